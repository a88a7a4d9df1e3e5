//! Writes the forward mode of a lowered function: beside every variable `x` its tangent `x_dot`.
//!
//! The code has the form of the user's: branches return value and tangent, loops keep no tape, and
//! a call of `f` becomes one of `f::jvp`. A variable that may change has a tangent that changes
//! with it.
//!
//! Tangents of values are owned; those of references are references to tangents, so that a call
//! costs no more than the function's own. What a type alone decides (whether a method takes its
//! receiver by value, whether a field is `#[constant]`) is left to traits (`ad::rt::pass`,
//! `ad::rt::read`), which all end in a copy or in nothing.
//!
//! A tangent here has the size of its value: that of a `Vec` has as many elements. (A cotangent may
//! be shorter, since a zero has to be made from the type alone; in forward mode the value is at
//! hand.) So tangents are indexed as values are, and one comparison of lengths where a function
//! begins lets the compiler drop the bounds checks.
//!
//! Turned down: evaluating the function on dual numbers (needs code that is generic over the
//! scalar); a pushforward as a closure, the mirror of `vjp` (saves what no reverse sweep will read,
//! and most callers have one tangent).

mod arithmetic;
mod call;
mod closure;
mod flow;
mod function;
mod operation;
mod place;

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use crate::analyse::numbers::Numbers;
use crate::analyse::uses::Uses;
use crate::ir::primal::{Primal, project};
use crate::ir::{Binding, Block, Operand, Place, Projection, Statement, VarId};
use crate::lower::Lowered;
use crate::names::Names;
use crate::parse::signature::Parameter;

pub use function::{delegated, item, names_of_tangents, tangent_of_type};

/// The forward mode of a function.
pub struct Forward {
    /// The names of the tangents of the parameters.
    pub tangents: Vec<Ident>,
    /// The statements.
    pub statements: TokenStream,
    /// The value and its tangent.
    pub result: TokenStream,
}

/// What the tangent of a variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tangent {
    /// There is none: the variable does not move.
    Still,
    /// A value that a function may take as it is.
    Owned,
    /// A value, of what may be a reference.
    OwnedTarget,
    /// A shared reference.
    Shared,
    /// A `&mut`.
    Exclusive,
}

/// Writes the forward mode.
pub fn forward(lowered: &Lowered, parameters: &[Parameter], names: &mut Names) -> Forward {
    let scalars = Numbers::new(lowered, parameters);
    let mut writer = Writer {
        lowered,
        names,
        uses: Uses::of(lowered, &scalars),
        idents: HashMap::new(),
        scalars,
        numbers: HashSet::new(),
        of_numbers: HashSet::new(),
        changing: HashSet::new(),
        taken_apart: HashSet::new(),
        tangents: vec![Tangent::Still; lowered.vars.len()],
        position: 0,
    };
    let vars = lowered.parameters.iter().map(|parameter| parameter.var);
    let mut lengths = TokenStream::new();
    for (var, parameter) in vars.clone().zip(parameters) {
        if lowered.vars[var].active {
            writer.tangents[var] = function::tangent_of_parameter(parameter);
        }
        if function::is_number(&parameter.ty, &lowered.scalars) {
            writer.numbers.insert(var);
        }
        if function::is_made_of_numbers(&parameter.ty, &lowered.scalars) {
            writer.of_numbers.insert(var);
        }
        if writer.tangents[var] != Tangent::Still && function::has_length(&parameter.ty) {
            let (ident, dot) = (&lowered.vars[var].ident, writer.dot(var));
            lengths.extend(quote!(::ad::rt::same_length(#ident.len(), #dot.len());));
        }
    }
    let tangents = vars.map(|var| writer.dot(var)).collect();
    let statements = writer.block(&lowered.body);
    let result = writer.pair(&lowered.body);
    for parameter in &lowered.parameters {
        if writer.taken_apart.contains(&parameter.var) {
            let dot = writer.dot(parameter.var);
            lengths.extend(quote!(let mut #dot = #dot;));
        }
    }
    Forward { tangents, statements: quote!(#lengths #statements), result }
}

struct Writer<'a> {
    lowered: &'a Lowered,
    names: &'a mut Names,
    uses: Uses,
    /// The names of tangents.
    idents: HashMap<VarId, Ident>,
    /// The types of those that certainly are numbers.
    scalars: Numbers<'a>,
    /// The variables that certainly are numbers or vectors, whose tangents are copied by `Copy`.
    numbers: HashSet<VarId>,
    /// The parameters whose elements are.
    of_numbers: HashSet<VarId>,
    /// The variables that do not change although their tangents may.
    changing: HashSet<VarId>,
    /// Those of whose tangents parts move out.
    taken_apart: HashSet<VarId>,
    /// What the tangents of the variables are, as far as these have been defined.
    tangents: Vec<Tangent>,
    /// The number of the statement being written.
    position: usize,
}

impl Writer<'_> {
    /// The statements of a block.
    fn block(&mut self, block: &Block) -> TokenStream {
        self.statements(&block.statements)
    }

    fn statements(&mut self, statements: &[Statement]) -> TokenStream {
        statements.iter().map(|statement| self.statement(statement)).collect()
    }

    fn statement(&mut self, statement: &Statement) -> TokenStream {
        self.position += 1;
        match statement {
            Statement::Define { var, ty, operation } => self.define(*var, ty.as_ref(), operation),
            Statement::Plain { code, .. } => code.clone(),
            Statement::Destructure { pattern, ty, source, bindings } => {
                let place = self.primal_place(source);
                let ty = ty.as_ref().map(|ty| quote!(: #ty));
                let ends = self.uses.end_with(source.root, self.position);
                let tangents = self.bindings(bindings, Some(source), ends);
                quote!(let #pattern #ty = #place; #tangents)
            }
            Statement::Assign { place, value } => self.assign(place, value),
            Statement::Update { place, operator, previous, value } => {
                self.update(place, *operator, *previous, *value)
            }
            Statement::Branch(branch) => self.branch(branch),
            Statement::Loop(a_loop) => self.a_loop(a_loop),
            Statement::Build(build) => self.build(build),
            Statement::Keep(keep) => self.keep(keep),
        }
    }

    fn ident(&self, var: VarId) -> &Ident {
        &self.lowered.vars[var].ident
    }

    /// The name of the tangent of a variable.
    fn dot(&mut self, var: VarId) -> Ident {
        if let Some(dot) = self.idents.get(&var) {
            return dot.clone();
        }
        let ident = &self.lowered.vars[var].ident;
        let dot = self.names.fresh(&format!("{ident}_dot"), ident.span());
        self.idents.insert(var, dot.clone());
        dot
    }

    /// Whether the tangent of an operand is certainly zero.
    fn is_still(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Constant(_) => true,
            Operand::Var(var) => self.tangents[*var] == Tangent::Still,
        }
    }

    fn tokens(&self, operand: &Operand) -> TokenStream {
        Primal(&self.lowered.vars).tokens(operand)
    }

    /// The value of a block and its tangent, as a tuple.
    fn pair(&mut self, block: &Block) -> TokenStream {
        let value = self.tokens(&block.value);
        match &block.value {
            Operand::Var(var) if self.tangents[*var] == Tangent::Shared => {
                let dot = self.dot(*var);
                quote!((#value, ::ad::rt::read(&#value, #dot)))
            }
            Operand::Var(var) if self.tangents[*var] != Tangent::Still => {
                let tangent = match (self.tangents[*var], self.uses.end_as_value(block.id)) {
                    (Tangent::Owned | Tangent::OwnedTarget, true) => {
                        self.dot(*var).to_token_stream()
                    }
                    _ => self.owned(*var),
                };
                quote!((#value, #tangent))
            }
            Operand::Constant(tokens) if tokens.to_string() == "()" => quote!(((), ())),
            _ => quote!(::ad::rt::with_zero(#value)),
        }
    }

    /// The tangent of a variable that moves, as a value.
    fn owned(&mut self, var: VarId) -> TokenStream {
        let (ident, dot) = (self.ident(var).clone(), self.dot(var));
        match self.tangents[var] {
            Tangent::Shared | Tangent::Exclusive => quote!(::ad::rt::read(&#ident, #dot)),
            _ if self.uses.end_with(var, self.position) => quote!(#dot),
            _ => self.copy(var, quote!(#dot)),
        }
    }

    /// A copy of the tangent of `var`.
    fn copy(&self, var: VarId, tangent: TokenStream) -> TokenStream {
        match self.numbers.contains(&var) || self.scalars.number(var).is_some() {
            true => tangent,
            false => quote!(::ad::rt::copy(&#tangent)),
        }
    }

    /// Names variables that a pattern binds under other names.
    fn named(&self, bindings: &[Binding]) -> TokenStream {
        let named = bindings.iter().filter_map(|Binding { var, written, .. }| {
            let (ident, written) = (self.ident(*var), written.as_ref()?);
            Some(quote!(let #ident = #written;))
        });
        named.collect()
    }

    /// What a pattern bound moves with the matched place; `ends` says whether nothing else uses that.
    fn bindings(
        &mut self,
        bindings: &[Binding],
        source: Option<&Place>,
        ends: bool,
    ) -> TokenStream {
        let mut tokens = TokenStream::new();
        let Some(source) = source.filter(|place| self.tangents[place.root] != Tangent::Still)
        else {
            for var in bindings.iter().map(|binding| binding.var) {
                // What starts from a constant may be given a tangent later.
                if self.lowered.vars[var].mutable && self.lowered.vars[var].active {
                    let ident = self.ident(var).clone();
                    self.tangents[var] = Tangent::OwnedTarget;
                    let dot = self.dot(var);
                    tokens.extend(quote!(let mut #dot = ::ad::rt::zero_like(&#ident);));
                }
            }
            return tokens;
        };
        let is_element = |binding: &Binding| {
            binding.path.iter().any(|step| matches!(step, Projection::Index(_)))
        };
        let takes = source.path.is_empty()
            && matches!(self.tangents[source.root], Tangent::Owned | Tangent::OwnedTarget)
            && ends
            && bindings.iter().all(|binding| !self.lowered.vars[binding.var].reference)
            && are_apart(bindings)
            && (!bindings.iter().any(is_element) || self.lowered.movable.contains(&source.root));
        // Out of an array no element moves by itself.
        let array = (takes && bindings.iter().any(is_element)).then(|| {
            let (array, dot) =
                (self.names.fresh("parts", Span::call_site()), self.dot(source.root));
            tokens.extend(quote!(let mut #array = #dot;));
            array
        });
        for binding in bindings {
            let var = &self.lowered.vars[binding.var];
            let (ident, reference) = (&var.ident, var.reference && !var.mutable);
            let mutability = var.mutable.then(|| quote!(mut));
            let path = [&source.path[..], &binding.path].concat();
            let part = Place { root: source.root, path };
            let dot = self.dot(binding.var);
            if takes {
                let tangent = match &array {
                    Some(array) => {
                        let part = project(quote!(#array), &binding.path);
                        quote!(::ad::rt::take(&mut #part))
                    }
                    None => self.tangent_place(&part),
                };
                tokens.extend(quote!(let #mutability #dot = ::ad::rt::read(&#ident, #tangent);));
            } else {
                let tangent = self.shared(&part);
                tokens.extend(match reference {
                    true => quote!(let #dot = #tangent;),
                    false => quote!(let #mutability #dot = ::ad::rt::read(&#ident, #tangent);),
                });
            }
            self.tangents[binding.var] = match reference && !takes {
                true => Tangent::Shared,
                false => Tangent::OwnedTarget,
            };
        }
        tokens
    }
}

/// Whether no binding holds what another one holds.
fn are_apart(bindings: &[Binding]) -> bool {
    let steps = |binding: &Binding| -> Option<Vec<String>> {
        let step = |step: &Projection| match step {
            Projection::Field(member) => Some(quote!(#member).to_string()),
            Projection::Index(index) if !step.is_range() => Some(index.to_string()),
            _ => None,
        };
        binding.path.iter().map(step).collect()
    };
    let paths: Option<Vec<_>> = bindings.iter().map(steps).collect();
    paths.is_some_and(|paths| {
        let apart = |i: usize, j: usize| {
            i == j || (!paths[i].starts_with(&paths[j]) && !paths[j].starts_with(&paths[i]))
        };
        (0..paths.len()).all(|i| (0..i).all(|j| apart(i, j)))
    })
}
