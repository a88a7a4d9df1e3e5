//! From the user's syntax to [`ir`](crate::ir).
//!
//! [`rewrite`] makes the syntax plainer, from syntax to syntax. [`flow`] then goes through the statements,
//! and [`expression`], [`call`] and [`place`] name intermediate results and the parts of values that are
//! meant. Iterators become loops in [`iterate`]. [`plain`] passes on code through which no derivative
//! flows, or refuses it where one would be lost. [`scopes`] knows what names mean, [`state`] what else is
//! known on the way, [`movable`] what is not `Copy`; [`syntax`] tells what forms mean by themselves,
//! [`search`] whether they stand somewhere within.

mod call;
mod expression;
mod flow;
mod iterate;
mod movable;
mod place;
mod plain;
mod rewrite;
mod scopes;
mod search;
mod state;
mod syntax;

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{ReturnType, Type, spanned::Spanned};

pub use self::call::own_methods::has_own_methods;
pub use self::expression::operator::is_own_type;
pub use self::movable::may_move;
pub use self::place::indexed::{getter, setter};
use self::scopes::Scopes;
use self::state::{Alias, Closure, Container, Fork, Jump, JumpId, LocalFunctions};
pub use self::syntax::{macro_diverges, strip_parens};
use crate::errors::Errors;
use crate::ir::{Block, BlockId, Called, Operand, Operation, Statement, Var, VarId};
pub use crate::ir::{Lowered, LoweredParameter};
use crate::names::Names;
use crate::parse::signature::Parameter;
use crate::types::{has_fixed_size, is_box, is_discrete, is_float, pointee};

/// A function, as the user wrote it.
pub struct Source<'a> {
    pub parameters: &'a [Parameter],
    pub result: &'a Type,
    pub body: &'a syn::Block,
    /// The type parameters that are scalars.
    pub scalars: Vec<Ident>,
    /// The methods that stand beside it and take `&mut self`.
    pub exclusive_methods: &'a [Ident],
    /// Whether the methods of `Self` are those of a user's type.
    pub self_is_own: bool,
}

/// Lowers a function.
pub fn lower(source: Source<'_>, names: &mut Names, errors: &mut Errors) -> Lowered {
    let Source { parameters, result, body, scalars, exclusive_methods, self_is_own } = source;
    let mut lowerer = Lowerer::new(OnFailure::of(result), names, errors);
    lowerer.scalars = scalars;
    lowerer.self_is_own = self_is_own;
    lowerer.exclusive_methods = exclusive_methods.iter().map(Ident::to_string).collect();
    let types = parameters.iter().map(|parameter| &parameter.ty);
    lowerer.variants = rewrite::variants::of(types, result, body);
    let mut parameter_vars = Vec::new();
    let body = lowerer.block(|lowerer| {
        parameter_vars = parameters.iter().map(|p| lowerer.parameter(p)).collect();
        for (parameter, &var) in parameters.iter().zip(&parameter_vars) {
            if let Some(pattern) = &parameter.pattern {
                lowerer.parameter_pattern(pattern, var);
            }
        }
        lowerer.local_functions = LocalFunctions::of(items(body));
        lowerer.items = items(body).map(|item| item.to_token_stream().to_string()).collect();
        let stmts = rewrite::leading::in_parentheses(body.stmts.clone());
        lowerer.function_body(rewrite::told::statements(stmts, result))
    });
    lowerer.finished(parameters, &parameter_vars, body)
}

/// The items of the outermost block: they are seen in the whole of it, so they stand before all else,
/// where both sweeps see them.
pub fn items(body: &syn::Block) -> impl Iterator<Item = &syn::Item> {
    body.stmts.iter().filter_map(|stmt| match stmt {
        syn::Stmt::Item(item) => Some(item),
        _ => None,
    })
}

/// What `?` returns.
#[derive(Clone, Copy, PartialEq, Eq)]
enum OnFailure {
    /// `None`
    None,
    /// `Err(..)`
    Err,
    /// The name of the result may stand for either.
    ByType,
    /// The function returns neither an `Option` nor a `Result`.
    Unknown,
}

impl OnFailure {
    fn of(result: &Type) -> Self {
        let Type::Path(path) = result else { return Self::Unknown };
        match path.path.segments.last() {
            Some(last) if last.ident == "Option" => Self::None,
            Some(last) if last.ident == "Result" => Self::Err,
            _ if is_discrete(result) || is_float(result) => Self::Unknown,
            _ => Self::ByType,
        }
    }

    fn of_closure(result: &ReturnType) -> Self {
        match result {
            ReturnType::Default => Self::ByType,
            ReturnType::Type(_, ty) => Self::of(ty),
        }
    }
}

struct Lowerer<'a> {
    on_failure: OnFailure,
    vars: Vec<Var>,
    /// What the user's names mean.
    scopes: Scopes,
    /// The blocks being written, innermost last.
    open_blocks: Vec<(BlockId, Vec<Statement>)>,
    block_count: BlockId,
    /// What jumps can leave here, innermost last.
    jumps: Vec<Jump>,
    jump_count: JumpId,
    fork_count: Fork,
    /// The names that stand for references to places.
    aliases: HashMap<VarId, Alias>,
    /// The variables that are known to be references.
    references: HashSet<VarId>,
    /// The variables of types that may not be `Copy`.
    own: HashSet<VarId>,
    /// The variables of types whose methods are those of a user's type.
    own_methods: HashSet<VarId>,
    /// Whether `Self` is such a type.
    self_is_own: bool,
    /// Those that a declaration makes a `Vec` or another type that is not `Copy`.
    movable: HashSet<VarId>,
    /// The lengths of arrays, where they are literals.
    lengths: HashMap<VarId, usize>,
    /// The parameters that are slices.
    slices: HashSet<VarId>,
    /// What variables are known to hold.
    containers: HashMap<VarId, Container>,
    /// What patterns and loops take variables without derivative from.
    parts_of: HashMap<VarId, TokenStream>,
    /// The names that stand for closures.
    closures: HashMap<VarId, Rc<Closure>>,
    /// The names that stand for functions, as they were written.
    function_names: HashMap<VarId, syn::Expr>,
    /// The parameters that are functions, and their numbers of arguments.
    functions: HashMap<VarId, usize>,
    /// Whether this is the body of a closure that is passed to a function.
    is_object: bool,
    /// Whether a call was given a function.
    passes_functions: bool,
    /// The methods that stand beside this one and take `&mut self`.
    exclusive_methods: HashSet<String>,
    /// The names that the compiler has been asked about.
    checked: HashSet<String>,
    /// The functions and methods that are called.
    called: Called,
    /// The functions that it brings along.
    local_functions: LocalFunctions,
    /// The items of the outermost block, as they are written.
    items: HashSet<String>,
    /// The names in refutable patterns that were taken for constants, for their capital letter.
    capitals: HashSet<String>,
    /// The constructors that are variants although their enum is not named.
    variants: HashSet<String>,
    /// The type parameters that are scalars.
    scalars: Vec<Ident>,
    /// The variables on which methods are being called whose arguments are being written. An
    /// argument is evaluated before the call, although the receiver stands first: no method that
    /// an argument calls may change it.
    called_on: Vec<VarId>,
    /// Whether the temporaries of the statement being lowered get names.
    keeps_temporaries: bool,
    /// Those that have got one.
    temporaries: HashSet<VarId>,
    names: &'a mut Names,
    errors: &'a mut Errors,
}

impl<'a> Lowerer<'a> {
    fn new(on_failure: OnFailure, names: &'a mut Names, errors: &'a mut Errors) -> Self {
        Self {
            on_failure,
            vars: Vec::new(),
            scopes: Scopes::default(),
            open_blocks: Vec::new(),
            block_count: 0,
            jumps: Vec::new(),
            jump_count: 0,
            fork_count: 0,
            aliases: HashMap::new(),
            references: HashSet::new(),
            own: HashSet::new(),
            own_methods: HashSet::new(),
            self_is_own: false,
            movable: HashSet::new(),
            lengths: HashMap::new(),
            slices: HashSet::new(),
            containers: HashMap::new(),
            parts_of: HashMap::new(),
            closures: HashMap::new(),
            function_names: HashMap::new(),
            functions: HashMap::new(),
            is_object: false,
            passes_functions: false,
            exclusive_methods: HashSet::new(),
            checked: HashSet::new(),
            called: Called::default(),
            local_functions: LocalFunctions::default(),
            items: HashSet::new(),
            capitals: HashSet::new(),
            variants: HashSet::new(),
            scalars: Vec::new(),
            called_on: Vec::new(),
            keeps_temporaries: false,
            temporaries: HashSet::new(),
            names,
            errors,
        }
    }
}

impl Lowerer<'_> {
    /// The function whose parameters are `vars`.
    fn finished(self, parameters: &[Parameter], vars: &[VarId], body: Block) -> Lowered {
        let both = parameters.iter().zip(vars);
        let references = both.clone().filter_map(|(parameter, &var)| match &parameter.ty {
            Type::Reference(reference) if !parameter.is_exclusive => {
                Some((var, (*reference.elem).clone()))
            }
            _ => None,
        });
        let references = references.collect();
        let parameters = both.map(|(parameter, &var)| LoweredParameter {
            var,
            has_shape: !has_fixed_size(&parameter.ty, &self.scalars),
            is_box: is_box(&parameter.ty),
        });
        let parameters = parameters.collect();
        let Self { vars, movable, scalars, called, passes_functions, .. } = self;
        Lowered { vars, parameters, references, movable, scalars, called, body, passes_functions }
    }

    /// Writes a block; `fill` returns its value.
    fn block(&mut self, fill: impl FnOnce(&mut Self) -> Operand) -> Block {
        let id = self.block_count;
        self.block_count += 1;
        self.open_blocks.push((id, Vec::new()));
        self.scopes.open();
        let value = fill(self);
        self.scopes.close();
        let (id, statements) = self.open_blocks.pop().expect("the block opened above");
        Block { id, statements, value }
    }

    /// Runs `fill` in a scope of names of its own.
    fn scope<R>(&mut self, fill: impl FnOnce(&mut Self) -> R) -> R {
        self.scopes.open();
        let result = fill(self);
        self.scopes.close();
        result
    }

    /// Whether a variable is or may be a reference.
    fn may_refer(&self, var: VarId) -> bool {
        self.vars[var].reference || self.references.contains(&var)
    }

    /// An item where it stands.
    fn local_item(&mut self, item: &syn::Item) {
        // One of an inner block would have another meaning outside of that.
        if self.is_object || !self.items.contains(&item.to_token_stream().to_string()) {
            self.refuse(
                item,
                "an item in an inner block is not supported: move it out of the block, or out of the differentiable function",
            );
        }
    }

    fn push(&mut self, statement: Statement) {
        self.open_blocks.last_mut().expect("a block is open").1.push(statement);
    }

    /// Writes code through which no derivative flows, and which defines nothing.
    fn push_plain(&mut self, code: TokenStream) {
        self.push(Statement::Plain { code, defines: Vec::new() });
    }

    /// What `attempt` gives. Where it gives nothing its statements go, too: they are written once
    /// more, in another way.
    fn or_undone<R>(&mut self, attempt: impl FnOnce(&mut Self) -> Option<R>) -> Option<R> {
        let written =
            |lowerer: &mut Self| lowerer.open_blocks.last().map_or(0, |open| open.1.len());
        let before = written(self);
        let value = attempt(self);
        if value.is_none()
            && let Some((_, statements)) = self.open_blocks.last_mut()
        {
            statements.truncate(before);
        }
        value
    }

    /// Makes a variable called `ident`.
    fn var(&mut self, ident: Ident, mutable: bool, active: bool) -> VarId {
        let [cotangent, space, record] = ["bar", "space", "pullback"]
            .map(|role| self.names.fresh(&format!("{ident}_{role}"), ident.span()));
        self.push_var(ident, [cotangent, space, record], mutable, active)
    }

    /// Makes a variable for a name of the user's that generated code never names.
    fn unwritten_var(&mut self, name: &Ident, mutable: bool, active: bool) -> VarId {
        let ident = self.names.fresh(&format!("{name}_alias"), name.span());
        let named = std::array::from_fn(|_| ident.clone());
        self.push_var(ident, named, mutable, active)
    }

    fn push_var(
        &mut self,
        ident: Ident,
        [cotangent, space, record]: [Ident; 3],
        mutable: bool,
        active: bool,
    ) -> VarId {
        self.vars.push(Var {
            ident,
            cotangent,
            space,
            record,
            block: self.open_blocks.last().expect("a block is open").0,
            mutable,
            exclusive: false,
            reference: false,
            active,
            is_function: false,
            is_binding: false,
        });
        self.vars.len() - 1
    }

    /// Makes the variable for what the user calls `name` from here on.
    fn bind(&mut self, name: &Ident, mutable: bool, active: bool) -> VarId {
        let ident = self.names.fresh(&name.to_string(), name.span());
        let var = self.var(ident, mutable, active);
        self.vars[var].is_binding = true;
        self.alias(name, var);
        var
    }

    /// Lets the user's `name` mean `var` from here on.
    fn alias(&mut self, name: &Ident, var: VarId) {
        self.scopes.bind(name, var);
    }

    fn lookup(&self, name: &Ident) -> Option<VarId> {
        self.scopes.lookup(name)
    }

    /// The variable that a path names, if it names one.
    fn variable(&self, path: &syn::ExprPath) -> Option<VarId> {
        self.lookup(path.path.get_ident()?)
    }

    /// Refuses to read a name that a pattern may have bound although it was taken for a constant.
    fn check_capital(&mut self, path: &syn::ExprPath) {
        if let Some(name) = path.path.get_ident()
            && self.capitals.contains(&name.to_string())
        {
            self.refuse(
                path,
                format!("`{name}` was taken for a constant in a pattern, for its capital letter: name a variable in lower case, and write `self::{name}` for a constant"),
            );
        }
    }

    fn parameter(&mut self, parameter: &Parameter) -> VarId {
        let var = self.parameter_var(parameter);
        self.alias(&parameter.ident, var);
        var
    }

    /// The variable of a parameter, without a name for users.
    fn parameter_var(&mut self, parameter: &Parameter) -> VarId {
        let exclusive = parameter.is_exclusive;
        let mutable = exclusive || parameter.is_mutable_receiver;
        let var = self.var(
            parameter.ident.clone(),
            mutable,
            !parameter.is_constant && !is_discrete(&parameter.ty),
        );
        self.vars[var].exclusive = exclusive;
        if parameter.is_shared {
            self.references.insert(var);
        }
        self.note_type(var, &parameter.ty);
        if is_own_type(&parameter.ty, &self.scalars) {
            self.own.insert(var);
        }
        self.functions.extend(parameter.arity.map(|arity| (var, arity)));
        self.vars[var].is_function = parameter.arity.is_some();
        var
    }

    /// Remembers what a type tells of a variable.
    fn note_type(&mut self, var: VarId, ty: &Type) {
        if let Type::Reference(_) = ty {
            self.references.insert(var);
        }
        if has_own_methods(ty, self.self_is_own) {
            self.own_methods.insert(var);
        }
        if movable::may_move(pointee(ty), &self.scalars) {
            self.movable.insert(var);
        }
        if let Type::Slice(_) = pointee(ty) {
            self.slices.insert(var);
        }
        // An array behind a reference has the methods of a slice.
        let behind = Container::of(pointee(ty)).filter(|container| *container != Container::Array);
        if let Some(container) = Container::of(ty).or(behind) {
            self.containers.insert(var, container);
        }
        if let Type::Array(array) = pointee(ty)
            && let Some(length) = iterate::chain::literal(&array.len)
        {
            self.lengths.insert(var, length);
        }
    }

    /// A new immutable variable, defined here.
    fn define(&mut self, hint: &str, span: Span, active: bool, operation: Operation) -> VarId {
        let ident = self.names.fresh(hint, span);
        let var = self.var(ident, false, active);
        self.push(Statement::Define { var, ty: None, operation });
        var
    }

    /// Defines a variable without derivative.
    fn define_constant(&mut self, hint: &str, span: Span, value: TokenStream) -> VarId {
        self.define(hint, span, false, Operation::Use(Operand::Constant(value)))
    }

    /// The name of a variable that keeps what has no derivative.
    fn named_tokens(&mut self, hint: &str, span: Span, value: TokenStream) -> TokenStream {
        let var = self.define_constant(hint, span, value);
        self.ident(var).to_token_stream()
    }

    /// An operand as a variable.
    fn named(&mut self, operand: Operand, hint: &str, span: Span) -> VarId {
        match operand {
            Operand::Var(var) => var,
            Operand::Constant(value) => self.define_constant(hint, span, value),
        }
    }

    fn ident(&self, var: VarId) -> &Ident {
        &self.vars[var].ident
    }

    /// The name of a variable, for errors about its use at `span`.
    fn ident_at(&self, var: VarId, span: Span) -> Ident {
        let mut ident = self.ident(var).clone();
        ident.set_span(span.resolved_at(ident.span()));
        ident
    }

    fn tokens(&self, operand: &Operand) -> TokenStream {
        match operand {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Var(var) => self.ident(*var).to_token_stream(),
        }
    }

    /// Reports what cannot be differentiated; what stands in for it is never compiled.
    fn refuse(&mut self, at: impl ToTokens, message: impl std::fmt::Display) -> Operand {
        let span = at.span();
        self.errors.at(at, message);
        Operand::Constant(quote::quote_spanned!(span=> ::core::unreachable!()))
    }

    /// A variable without derivative as an operand.
    fn constant(&self, var: VarId) -> Operand {
        Operand::Constant(self.ident(var).to_token_stream())
    }

    /// A variable that is never assigned to as an operand.
    fn operand_of(&self, var: VarId) -> Operand {
        match self.vars[var].active {
            true => Operand::Var(var),
            false => self.constant(var),
        }
    }

    fn unit() -> Operand {
        Operand::Constant(quote!(()))
    }
}
