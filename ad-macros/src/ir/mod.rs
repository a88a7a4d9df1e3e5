//! The form between the user's function and the sweeps: few kinds of statement, every operand
//! named, no exits.

mod called;
mod callee;
mod keep;
pub mod primal;
mod typed_by;

use std::collections::HashSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::{BinOp, Member, Type};

use crate::parse::signature::Parameter;

pub use called::{Called, may_be_known};
pub use callee::{Callee, Derivative};
pub use keep::{Action, Keep, Kept, Target, Way};
pub use typed_by::{TypedBy, argument};

/// A function body in lowered form.
pub struct Lowered {
    /// Every variable.
    pub vars: Vec<Var>,
    /// The parameters.
    pub parameters: Vec<LoweredParameter>,
    /// The parameters that are shared references, and the types that they refer to.
    pub references: Vec<(VarId, Type)>,
    /// The variables of types that are known not to be `Copy`.
    pub movable: HashSet<VarId>,
    /// The type parameters that are bounded by `Real`.
    pub scalars: Vec<Ident>,
    /// What it calls.
    pub called: Called,
    /// The body.
    pub body: Block,
    /// Whether the body passes functions to others: it takes a derivative to do so, of the mode of what
    /// is passed.
    pub passes_functions: bool,
}

/// A parameter of a function.
pub struct LoweredParameter {
    /// Its variable.
    pub var: VarId,
    /// Whether its tangents may differ in size.
    pub has_shape: bool,
    /// Whether it is a box, whose cotangent may have been gathered as that of the content.
    pub is_box: bool,
}

/// Index of a [`Var`].
pub type VarId = usize;

/// Identifies a block; the block in which a variable lives holds its cotangent.
pub type BlockId = usize;

/// A variable of the forward sweep.
pub struct Var {
    /// Its name.
    pub ident: Ident,
    /// The name of its cotangent.
    pub cotangent: Ident,
    /// The name of the space in which its cotangent lives.
    pub space: Ident,
    /// The name of what the forward sweep keeps of the operation that defines the variable: the
    /// pullback of a call, the types of a sum.
    pub record: Ident,
    /// The block it lives in.
    pub block: BlockId,
    /// Whether it is assigned to after its definition.
    pub mutable: bool,
    /// Whether it is a `&mut` parameter.
    pub exclusive: bool,
    /// Whether it may be a shared reference: a part of what a reference refers to, named by a
    /// pattern.
    pub reference: bool,
    /// Whether a derivative may flow through it. One that is not active is a constant.
    pub active: bool,
    /// Whether it is a function, or a reference to one: an object with a derivative, which only
    /// derivatives take.
    pub is_function: bool,
    /// Whether the user gave it its name.
    pub is_binding: bool,
}

/// A step from a value into a part of it.
#[derive(Clone)]
pub enum Projection {
    /// `.member`
    Field(Member),
    /// The member of a tuple that has so many behind it; a pattern with `..` does not tell how many
    /// stand before it.
    FromEnd(usize),
    /// `[index]`; the index is a literal or an immutable variable, or a range between such.
    Index(TokenStream),
    /// `*`; the cotangent of a reference is that of its target.
    Deref,
    /// What a `&mut` refers to that a pattern bound: `*name` is the place to which the steps before
    /// lead, which has no other name in Rust if it lies in a variant.
    Behind(VarId),
}

impl Projection {
    /// Whether the step leads to a part of the cotangent.
    pub fn is_part(&self) -> bool {
        matches!(self, Self::Field(_) | Self::FromEnd(_) | Self::Index(_))
    }

    /// Whether the step leads to a range of elements.
    pub fn is_range(&self) -> bool {
        matches!(self, Self::Index(index) if index.clone().into_iter().nth(1).is_some())
    }
}

/// A variable or a part of one.
#[derive(Clone)]
pub struct Place {
    /// The variable.
    pub root: VarId,
    /// The way from there.
    pub path: Vec<Projection>,
}

impl Place {
    /// The whole of a variable.
    pub fn of(root: VarId) -> Self {
        Self { root, path: Vec::new() }
    }
}

/// What an operation uses.
#[derive(Clone)]
pub enum Operand {
    /// An expression through which no derivative flows.
    Constant(TokenStream),
    /// An active variable that is never assigned to.
    Var(VarId),
}

/// What a call passes.
pub enum Argument {
    /// A value.
    Value(Operand),
    /// `&place`
    Borrow(Place),
    /// `&mut place`: the cotangent goes in and comes out.
    Exclusive(Place),
    /// What a `&mut` refers to, passed by the name of this alone: as `&mut`, or as `&` if that is
    /// what the function takes. The types tell.
    Reborrow(Place),
    /// A function, as it is passed to another one: a variable that an [`Operation::Closure`] or a
    /// copy of a parameter defines. There is a derivative of such a call only.
    Function(VarId),
    /// The function that is called, or copied to be passed on: values do without its derivative.
    Callee(Place),
    /// A reference to a function, passed on to a parameter that may take it by value: the function
    /// that is called tells.
    PassedOn(Place, TypedBy),
    /// The receiver of a method: a place, which the method borrows or copies. If the place may be
    /// assigned to, the method may change it: the types tell.
    Receiver(Place),
}

impl Argument {
    /// The place that the call can change, as far as its form tells.
    pub fn changeable(&self) -> Option<&Place> {
        match self {
            Self::Exclusive(place) | Self::Reborrow(place) | Self::Receiver(place) => Some(place),
            Self::Value(_)
            | Self::Borrow(_)
            | Self::Function(_)
            | Self::Callee(_)
            | Self::PassedOn(..) => None,
        }
    }

    /// The place that the call may change: that of a receiver only if it may be assigned to.
    pub fn changed(&self, vars: &[Var]) -> Option<&Place> {
        let is_receiver = matches!(self, Self::Receiver(_));
        self.changeable().filter(|place| !is_receiver || vars[place.root].mutable)
    }
}

/// A binary operator with a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
}

impl BinaryOperator {
    /// The operator in `x + y`; `None` for one without a rule.
    pub fn of(operator: &BinOp) -> Option<Self> {
        Some(match operator {
            BinOp::Add(_) => Self::Add,
            BinOp::Sub(_) => Self::Sub,
            BinOp::Mul(_) => Self::Mul,
            BinOp::Div(_) => Self::Div,
            BinOp::Rem(_) => Self::Rem,
            _ => return None,
        })
    }

    /// The operator in `x += y`; `None` for one without a rule.
    pub fn of_update(operator: &BinOp) -> Option<Self> {
        Some(match operator {
            BinOp::AddAssign(_) => Self::Add,
            BinOp::SubAssign(_) => Self::Sub,
            BinOp::MulAssign(_) => Self::Mul,
            BinOp::DivAssign(_) => Self::Div,
            BinOp::RemAssign(_) => Self::Rem,
            _ => return None,
        })
    }

    /// The function of its rule for a mode, `MulPullback::mul_jvp`; `x *= y` has a rule of its own.
    pub fn rule(self, assigns: bool, mode: &str, span: Span) -> TokenStream {
        let (of, suffix) = if assigns { ("Assign", "_assign") } else { ("", "") };
        let rule = format_ident!("{self:?}{of}Pullback", span = span);
        let function = format_ident!("{}{suffix}_{mode}", self.method(), span = span);
        quote_spanned!(span=> ::ad::rules::#rule::#function)
    }

    /// The name of its method.
    pub fn method(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Sub => "sub",
            Self::Mul => "mul",
            Self::Div => "div",
            Self::Rem => "rem",
        }
    }

    /// What its result is called.
    pub fn result(self) -> &'static str {
        match self {
            Self::Add => "sum",
            Self::Sub => "difference",
            Self::Mul => "product",
            Self::Div => "quotient",
            Self::Rem => "remainder",
        }
    }

    /// Whether its partial derivatives are constants.
    pub fn is_linear(self) -> bool {
        matches!(self, Self::Add | Self::Sub)
    }
}

/// How the value of an [`Operation::Aggregate`] holds its parts.
#[derive(Clone, PartialEq, Eq)]
pub enum Shape {
    /// `(a, b)`
    Tuple,
    /// `[a, b]`
    Array,
    /// `vec![a, b]`
    Vec,
    /// `Name { a, b }` or `Name(a, b)`; a field may be `#[constant]`.
    Struct,
    /// `Name { a, b, ..rest }`, of which the rest is a constant.
    Updated,
    /// `Box::new(a)`: the cotangent of the whole is a box of that of its content.
    Boxed,
    /// `Some(a)`: the cotangent of the whole is that of its content.
    Transparent,
    /// `ControlFlow::Break(a)` (member 0) or `Continue(a)` (member 1); `Ok(a)` (member 0) or
    /// `Err(a)` (member 1).
    Flow,
    /// `Enum::Variant { a, b }` or `Enum::Variant(a, b)`.
    Variant(Ident),
}

/// The right-hand side of a definition.
pub enum Operation {
    /// An operand as it is.
    Use(Operand),
    /// A copy of a place.
    Read(Place),
    /// A clone of a place: in Rust the value moves out of it. Of an element of what may have none, the kind of that, a
    /// variable, says how it is cloned.
    Clone(Place, Option<VarId>),
    /// What a variable is or refers to: a number.
    Value(VarId),
    /// `&place`
    Borrow(Place),
    /// `-x`
    Negate(VarId),
    /// `x + y`
    Binary(BinaryOperator, VarId, VarId),
    /// `x as T`
    Cast(VarId, Type),
    /// A call.
    Call { callee: Callee, arguments: Vec<Argument> },
    /// A value made of parts.
    Aggregate { expression: TokenStream, shape: Shape, parts: Vec<(Member, Operand)> },
    /// A struct made of parts and, for the rest, of another struct.
    UpdateStruct { expression: TokenStream, parts: Vec<(Member, Operand)>, rest: Place },
    /// A closure, as an object with a derivative.
    Closure(Box<Closure>),
    /// A function that has a name, as such an object.
    Named { primal: TokenStream, derivative: Derivative },
    /// `[x; N]` or `vec![x; n]`
    Repeat { value: VarId, length: TokenStream, is_vec: bool },
}

/// A closure that is passed to a function.
pub struct Closure {
    /// Copies of what it captures, as expressions in the function around it, and the places there.
    pub captures: Vec<(TokenStream, Place)>,
    /// Its parameters: references to what it captures, then its arguments.
    pub parameters: Vec<Parameter>,
    /// Its body, as that of a function of these parameters.
    pub function: Lowered,
    /// The parameter to which it is passed, where that tells the types of its own.
    pub typed_by: Option<TypedBy>,
}

/// A variable that a pattern binds to a part of the matched value.
pub struct Binding {
    pub var: VarId,
    pub path: Vec<Projection>,
    /// The name in the pattern, where it is another than that of the variable: it may turn out to be
    /// that of a constant.
    pub written: Option<Ident>,
}

impl Binding {
    /// A variable under its own name.
    pub fn new(var: VarId, path: Vec<Projection>) -> Self {
        Self { var, path, written: None }
    }
}

/// A statement.
pub enum Statement {
    /// `let var: ty = operation;`
    Define { var: VarId, ty: Option<Type>, operation: Operation },
    /// Code through which no derivative flows, and the variables it defines.
    Plain { code: TokenStream, defines: Vec<VarId> },
    /// `let pattern: ty = source;`
    Destructure { pattern: TokenStream, ty: Option<Type>, source: Place, bindings: Vec<Binding> },
    /// `place = value;`
    Assign { place: Place, value: Operand },
    /// `place op= value;`, where `previous` is a copy of the place from before.
    Update { place: Place, operator: BinaryOperator, previous: VarId, value: VarId },
    /// `if` or `match`.
    Branch(Branch),
    /// `for`, `while`, `loop`
    Loop(Loop),
    /// `array::from_fn`, `array::map`
    Build(Build),
    /// Variables that one way on finds as they were, while another may move them.
    Keep(Keep),
}

impl Statement {
    /// The blocks in it.
    pub fn blocks(&self) -> Vec<&Block> {
        match self {
            Self::Branch(branch) => branch.arms.iter().map(|arm| &arm.body).collect(),
            Self::Loop(a_loop) => vec![&a_loop.body],
            Self::Build(build) => vec![&build.body],
            _ => Vec::new(),
        }
    }

    /// The variable that takes the value of its blocks.
    pub fn result(&self) -> Option<VarId> {
        match self {
            Self::Branch(branch) => branch.result,
            Self::Loop(a_loop) => a_loop.result,
            Self::Build(build) => Some(build.result),
            _ => None,
        }
    }

    /// The blocks in it, to be changed.
    pub fn blocks_mut(&mut self) -> Vec<&mut Block> {
        match self {
            Self::Branch(branch) => branch.arms.iter_mut().map(|arm| &mut arm.body).collect(),
            Self::Loop(a_loop) => vec![&mut a_loop.body],
            Self::Build(build) => vec![&mut build.body],
            _ => Vec::new(),
        }
    }
}

/// Statements, then a value.
pub struct Block {
    pub id: BlockId,
    pub statements: Vec<Statement>,
    pub value: Operand,
}

impl Block {
    /// Whether its statements may change one of the variables before this one.
    pub fn may_change(&self, first: VarId) -> bool {
        let is_changed = |place: &Place| place.root < first;
        self.statements.iter().any(|statement| match statement {
            Statement::Assign { place, .. } | Statement::Update { place, .. } => is_changed(place),
            Statement::Define { operation: Operation::Call { arguments, .. }, .. } => {
                arguments.iter().filter_map(Argument::changeable).any(is_changed)
            }
            statement => statement.blocks().iter().any(|block| block.may_change(first)),
        })
    }
}

/// One of several blocks is run.
pub struct Branch {
    /// Takes the value of the block, where it is wanted.
    pub result: Option<VarId>,
    /// The name of the path taken.
    pub record: Ident,
    pub kind: BranchKind,
    pub arms: Vec<Arm>,
}

impl Branch {
    /// The matched place, where a derivative flows through it.
    pub fn source(&self) -> Option<&Place> {
        match &self.kind {
            BranchKind::If(_) => None,
            BranchKind::Match(_, source) => source.as_ref(),
        }
    }

    /// The branch with other bodies of its arms.
    pub fn choose(&self, bodies: impl Iterator<Item = TokenStream>) -> TokenStream {
        match &self.kind {
            BranchKind::If(condition) => {
                let bodies: Vec<_> = bodies.collect();
                let (then, otherwise) = (&bodies[0], &bodies[1]);
                quote!(if #condition #then else #otherwise)
            }
            BranchKind::Match(matched, _) => {
                let arms = self.arms.iter().zip(bodies).map(|(arm, body)| {
                    let pattern = &arm.pattern;
                    let guard = arm.guard.as_ref().map(|guard| quote!(if #guard));
                    quote!(#pattern #guard => #body)
                });
                quote!(match #matched { #(#arms)* })
            }
        }
    }
}

/// How the arm is chosen.
pub enum BranchKind {
    /// By a condition; there are two arms.
    If(TokenStream),
    /// By patterns. The matched place, where a derivative flows through it.
    Match(TokenStream, Option<Place>),
}

/// An arm of a branch; pattern, guard and bindings only in a `match`.
pub struct Arm {
    pub pattern: TokenStream,
    pub guard: Option<TokenStream>,
    pub bindings: Vec<Binding>,
    pub body: Block,
}

impl Arm {
    /// An arm that binds nothing.
    pub fn plain(body: Block) -> Self {
        Self { pattern: TokenStream::new(), guard: None, bindings: Vec::new(), body }
    }
}

/// A block that is run again and again.
pub struct Loop {
    pub head: Head,
    pub body: Block,
    /// The name of the tape.
    pub record: Ident,
    /// Whether the value of the body is a `ControlFlow`, whose `Break` ends the loop.
    pub breaks: bool,
    /// Takes the content of the `Break`.
    pub result: Option<VarId>,
    /// What `result` is where the loop ends by itself.
    pub natural_end: TokenStream,
    /// Whether the reverse sweep computes the iterations again, from some stored states.
    pub checkpoint: bool,
}

/// How a loop goes on.
pub enum Head {
    /// Once for each item of an iterator of constants.
    For {
        pattern: TokenStream,
        /// The variables of the pattern.
        defines: Vec<VarId>,
        iterator: TokenStream,
        /// Whether the iterator can be run from its end to its start, and is made of integers.
        reversible: bool,
        /// The number of iterations, where it is a literal.
        trip_count: Option<usize>,
    },
    /// While a condition holds.
    While(TokenStream),
    /// Until a `Break`.
    Loop,
}

/// A block that is run for each element of a new array or `Vec`, and has it as its value.
pub struct Build {
    /// Takes what is built.
    pub result: VarId,
    pub source: BuildSource,
    pub ty: Option<Type>,
    pub body: Block,
    /// The name of the tape.
    pub record: Ident,
}

impl Build {
    /// The definition of what is built of elements, or, of pairs, of what is built of the parts of each:
    /// `second` takes those behind.
    pub fn definition(
        &self,
        vars: &[Var],
        element: &TokenStream,
        second: Option<&Ident>,
    ) -> TokenStream {
        let is_paired = second.is_some();
        let built = match &self.source {
            BuildSource::Index { index, like } => {
                let index = &vars[*index].ident;
                let function = quote!(|#index: usize| #element);
                match (like, is_paired) {
                    (Some(like), true) => quote!(::ad::rt::record_like(&#like, #function)),
                    (Some(like), false) => quote!(::ad::rt::build_like(&#like, #function)),
                    (None, true) => quote!(::ad::rt::record(#function)),
                    (None, false) => quote!(::core::array::from_fn(#function)),
                }
            }
            BuildSource::Items { pattern, iterator, .. } => {
                let collected = if is_paired { quote!(unzip) } else { quote!(collect) };
                quote!((#iterator).map(|#pattern| #element).#collected())
            }
        };
        let vec =
            matches!(self.source, BuildSource::Items { .. }).then(|| quote!(::std::vec::Vec<_>));
        let ty = self.ty.as_ref().map(ToTokens::to_token_stream).or_else(|| vec.clone());
        let ident = &vars[self.result].ident;
        let (pattern, ty) = match second {
            None => (quote!(#ident), ty),
            Some(second) => {
                let seconds = vec.unwrap_or_else(|| quote!(_));
                (quote!((#ident, #second)), ty.map(|ty| quote!((#ty, #seconds))))
            }
        };
        let ty = ty.map(|ty| quote!(: #ty));
        quote!(let #pattern #ty = #built;)
    }
}

/// What elements are made from.
pub enum BuildSource {
    /// An array, from the index of each element, which is the variable. It has as many elements as
    /// another array, if there is one.
    Index { index: VarId, like: Option<TokenStream> },
    /// A `Vec`, from the items of an iterator of constants.
    Items { pattern: TokenStream, defines: Vec<VarId>, iterator: TokenStream },
}
