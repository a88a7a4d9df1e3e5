//! What the body of a function tells about its variables without their types.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::Type;
use syn::visit::{self, Visit};

use crate::ir::{
    Binding, Block, BranchKind, BuildSource, Head, Operand, Operation, Place, Projection, Shape,
    Statement, Var, VarId,
};
use crate::lower::{Lowered, LoweredParameter};
use crate::names;
use crate::parse::signature::Parameter;
use crate::types::{is_discrete, is_float, pointee};

/// See the module.
pub struct Facts<'a> {
    vars: &'a [Var],
    scalars: &'a [Ident],
    by_name: HashMap<String, VarId>,
    operations: HashMap<VarId, &'a Operation>,
    /// Operands of arithmetic: numbers and vectors, and what one's own operators work on.
    arithmetic: HashSet<VarId>,
    /// The variables of loops over ranges, and integer parameters.
    integers: HashSet<VarId>,
    /// What variables are that are defined several at once and without derivative, as in
    /// `let (i, j) = (2 * n, 2 * n + 1)`.
    members: HashMap<VarId, TokenStream>,
    /// Parameters of type `[T; N]`, and with `true` of type `&[T; N]`, of numbers `T`.
    array_parameters: HashMap<VarId, bool>,
    /// Parameters that are slices or `Vec`s and stay as they are.
    sequences: HashSet<VarId>,
    /// Parameters that are `&`, and `&self`.
    references: HashSet<VarId>,
    /// The places that variables are parts of which patterns bind.
    bound: HashMap<VarId, Place>,
}

impl<'a> Facts<'a> {
    /// Gathers the facts.
    pub fn new(lowered: &'a Lowered, parameters: &[Parameter]) -> Self {
        let vars = &lowered.vars;
        let by_name = vars.iter().enumerate().map(|(id, var)| (var.ident.to_string(), id));
        let mut facts = Self {
            vars,
            scalars: &lowered.scalars,
            by_name: by_name.collect(),
            operations: HashMap::new(),
            arithmetic: HashSet::new(),
            integers: HashSet::new(),
            members: HashMap::new(),
            array_parameters: HashMap::new(),
            sequences: HashSet::new(),
            references: HashSet::new(),
            bound: HashMap::new(),
        };
        for (parameter, &LoweredParameter { var, .. }) in parameters.iter().zip(&lowered.parameters)
        {
            if parameter.is_shared {
                facts.references.insert(var);
            }
            match &parameter.ty {
                ty @ Type::Path(_) if is_discrete(ty) => {
                    facts.integers.insert(var);
                }
                ty @ Type::Array(_) if facts.is_of_numbers(ty) => {
                    facts.array_parameters.insert(var, false);
                }
                Type::Reference(reference)
                    if reference.mutability.is_none()
                        && matches!(*reference.elem, Type::Array(_))
                        && facts.is_of_numbers(&reference.elem) =>
                {
                    facts.array_parameters.insert(var, true);
                }
                ty if is_sequence(ty) && !vars[var].mutable && !parameter.is_exclusive => {
                    facts.sequences.insert(var);
                }
                _ => {}
            }
        }
        facts.block(&lowered.body);
        facts
    }

    fn block(&mut self, block: &'a Block) {
        for statement in &block.statements {
            match statement {
                Statement::Define { var, operation, .. } => {
                    self.operations.insert(*var, operation);
                    match operation {
                        Operation::Negate(value) => self.arithmetic.extend([*value]),
                        Operation::Binary(_, left, right) => {
                            self.arithmetic.extend([*left, *right]);
                        }
                        _ => {}
                    }
                }
                Statement::Update { value, previous, .. } => {
                    self.arithmetic.extend([*value, *previous]);
                }
                Statement::Branch(branch) => {
                    for arm in &branch.arms {
                        if let BranchKind::Match(_, Some(source)) = &branch.kind {
                            self.bindings(&arm.bindings, source);
                        }
                        self.block(&arm.body);
                    }
                }
                Statement::Loop(a_loop) => {
                    if let Head::For { defines, iterator, .. } = &a_loop.head
                        && self.is_range(iterator)
                    {
                        self.integers.extend(defines);
                    }
                    self.block(&a_loop.body);
                }
                Statement::Build(build) => {
                    match &build.source {
                        BuildSource::Index { index, .. } => {
                            self.integers.insert(*index);
                        }
                        BuildSource::Items { defines, iterator, .. } => {
                            if self.is_range(iterator) {
                                self.integers.extend(defines);
                            }
                        }
                    }
                    self.block(&build.body);
                }
                Statement::Plain { code, .. } => self.tuple(code),
                Statement::Destructure { source, bindings, .. } => {
                    self.bindings(bindings, source);
                }
                Statement::Assign { .. } | Statement::Keep(_) => {}
            }
        }
    }

    fn bindings(&mut self, bindings: &[Binding], source: &Place) {
        for binding in bindings {
            let path = [&source.path[..], &binding.path].concat();
            self.bound.insert(binding.var, Place { root: source.root, path });
        }
    }

    /// The part of another variable that a variable is a copy of, if it never changes.
    pub fn origin(&self, var: VarId) -> Option<Place> {
        if self.vars[var].mutable {
            return None;
        }
        if let Some(place) = self.bound.get(&var) {
            return Some(place.clone());
        }
        match self.operations.get(&var)? {
            Operation::Read(place) | Operation::Clone(place, _) if !place.path.is_empty() => {
                Some(place.clone())
            }
            Operation::Use(Operand::Var(source)) => self.origin(*source),
            _ => None,
        }
    }

    /// The field of another variable for which a variable stands that a pattern bound, or a reference.
    pub fn stands_for(&self, var: VarId) -> Option<&Place> {
        let place = match (self.bound.get(&var), self.operations.get(&var)) {
            (Some(place), _) | (None, Some(Operation::Borrow(place))) => place,
            _ => return None,
        };
        let is_plain = |step: &Projection| matches!(step, Projection::Field(_) | Projection::Deref);
        (!self.vars[var].mutable && place.path.iter().all(is_plain)).then_some(place)
    }

    /// Takes a definition of several variables apart.
    fn tuple(&mut self, code: &TokenStream) {
        let Ok(syn::Stmt::Local(local)) = syn::parse2(code.clone()) else { return };
        let (syn::Pat::Tuple(pattern), Some(init)) = (&local.pat, &local.init) else { return };
        let syn::Expr::Tuple(values) = &*init.expr else { return };
        if pattern.elems.len() != values.elems.len() {
            return;
        }
        for (pattern, value) in pattern.elems.iter().zip(&values.elems) {
            if let syn::Pat::Ident(pattern) = pattern
                && pattern.by_ref.is_none()
                && pattern.subpat.is_none()
                && let Some(var) = self.named(&pattern.ident)
                && !self.vars[var].mutable
            {
                self.members.insert(var, value.to_token_stream());
            }
        }
    }

    /// What a variable is that was defined together with others and without derivative, if it is
    /// cheap arithmetic on numbers.
    pub fn member(&self, var: VarId) -> Option<&TokenStream> {
        self.members.get(&var).filter(|tokens| self.is_number_before(tokens, var))
    }

    /// The variable of a name.
    pub fn named(&self, name: &Ident) -> Option<VarId> {
        self.by_name.get(&name.to_string()).copied()
    }

    /// Whether the variable certainly holds no reference, so that the pullback may keep it, and is
    /// certainly `Copy`, so that naming it once more does no harm.
    pub fn is_number(&self, var: VarId) -> bool {
        if self.arithmetic.contains(&var) || self.integers.contains(&var) {
            return true;
        }
        if self.member(var).is_some() {
            return true;
        }
        match self.operations.get(&var) {
            Some(
                Operation::Negate(_)
                | Operation::Binary(..)
                | Operation::Cast(..)
                | Operation::Value(_),
            ) => true,
            Some(Operation::Use(Operand::Constant(tokens))) if !self.vars[var].mutable => {
                self.is_number_before(tokens, var)
            }
            _ => false,
        }
    }

    /// Whether the variable is an array, and whether behind a reference.
    pub fn array(&self, var: VarId) -> Option<bool> {
        if let Some(&by_reference) = self.array_parameters.get(&var) {
            return Some(by_reference);
        }
        let is_array = match self.operations.get(&var)? {
            Operation::Use(Operand::Constant(tokens)) => {
                let mut tokens = tokens.clone().into_iter();
                let first = tokens.next();
                matches!(first, Some(TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Bracket)
                    && tokens.next().is_none()
            }
            Operation::Repeat { is_vec, .. } => !is_vec,
            Operation::Aggregate { shape: Shape::Array, parts, .. } => {
                parts.iter().all(|(_, part)| match part {
                    Operand::Var(part) => self.is_number(*part) || self.array(*part) == Some(false),
                    Operand::Constant(tokens) => self.is_number_before(tokens, var),
                })
            }
            Operation::Read(place) if place.path.is_empty() => {
                self.array(place.root) == Some(false)
            }
            Operation::Use(Operand::Var(source)) => self.array(*source) == Some(false),
            _ => false,
        };
        is_array.then_some(false)
    }

    /// Whether a variable may be assigned to after its definition.
    pub fn is_mutable(&self, var: VarId) -> bool {
        self.vars[var].mutable
    }

    /// Whether a variable is a parameter that is a slice or a `Vec` and stays as it is.
    pub fn is_sequence(&self, var: VarId) -> bool {
        self.sequences.contains(&var)
    }

    /// Whether a variable is a parameter by `&`.
    pub fn is_given_by_reference(&self, var: VarId) -> bool {
        self.references.contains(&var)
    }

    /// Whether a variable is a parameter that has a length and stays as it is.
    pub fn is_parameter_with_length(&self, var: VarId) -> bool {
        self.sequences.contains(&var) || self.array_parameters.contains_key(&var)
    }

    /// Whether this is a type parameter that is a scalar.
    pub fn is_scalar(&self, name: &Ident) -> bool {
        self.scalars.contains(name)
    }

    /// Whether code names a slice or a `Vec`, of which the reverse sweep knows nothing.
    pub fn names_sequence(&self, code: &TokenStream) -> bool {
        self.uses(code).iter().any(|var| self.sequences.contains(var))
    }

    /// The variables that code names.
    pub fn uses(&self, code: &TokenStream) -> Vec<VarId> {
        let mut names = HashSet::new();
        names::collect_variables(code.clone(), &mut names);
        let mut uses: Vec<_> =
            names.iter().filter_map(|name| self.by_name.get(name).copied()).collect();
        uses.sort_unstable();
        uses
    }

    /// Whether a type is certainly that of numbers, or of arrays of them, which are `Copy`.
    fn is_of_numbers(&self, ty: &Type) -> bool {
        match ty {
            Type::Array(array) => self.is_of_numbers(&array.elem),
            Type::Path(path) => {
                let name = path.path.segments.last().map(|last| &last.ident);
                is_float(ty)
                    || is_discrete(ty) && name.is_some_and(|name| name != "String")
                    || name.is_some_and(|name| self.is_of_scalars(name))
            }
            _ => false,
        }
    }

    /// The operation that defines a variable.
    pub fn operation(&self, var: VarId) -> Option<&'a Operation> {
        self.operations.get(&var).copied()
    }

    /// Equal for places that are the same as long as nothing is assigned: an index stands for what
    /// it was computed from.
    pub fn key(&self, place: &Place) -> (VarId, String) {
        let step = |step: &Projection| match step {
            Projection::Field(member) => format!(".{}", member.to_token_stream()),
            Projection::FromEnd(behind) => format!(".-{behind}"),
            Projection::Deref => "*".to_owned(),
            Projection::Behind(name) => format!("&{name}"),
            Projection::Index(index) => format!("[{}]", self.index(index)),
        };
        (place.root, place.path.iter().map(step).collect())
    }

    /// What an index stands for.
    pub fn index(&self, index: &TokenStream) -> TokenStream {
        let mut index = index.clone();
        while let Some(origin) = self.immutable_origin(&index) {
            index = origin;
        }
        index
    }

    /// What the variable that an index consists of was computed from, if that never changes.
    fn immutable_origin(&self, index: &TokenStream) -> Option<TokenStream> {
        let name: Ident = syn::parse2(index.clone()).ok()?;
        let index = self.named(&name)?;
        match self.operations.get(&index)? {
            Operation::Use(Operand::Constant(tokens))
                if self.uses(tokens).iter().all(|&var| var < index && !self.vars[var].mutable)
                    && self.is_same_again(tokens, index) =>
            {
                Some(tokens.clone())
            }
            _ => None,
        }
    }

    /// Whether the code that defines a variable gives the same when it runs once more: a function may draw
    /// a random number.
    fn is_same_again(&self, code: &TokenStream, defined: VarId) -> bool {
        struct Calls<'f, 'a> {
            facts: &'f Facts<'a>,
            defined: VarId,
            may_differ: bool,
        }

        impl<'ast> Visit<'ast> for Calls<'_, '_> {
            fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
                self.may_differ |=
                    call.func.to_token_stream().to_string() != constant().to_string();
                visit::visit_expr_call(self, call);
            }

            fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
                self.may_differ |= !self.facts.is_same_again_before(call, self.defined);
            }

            fn visit_macro(&mut self, _: &'ast syn::Macro) {
                self.may_differ = true;
            }
        }

        let mut calls = Calls { facts: self, defined, may_differ: false };
        syn::parse2(code.clone()).is_ok_and(|code: syn::Expr| {
            calls.visit_expr(&code);
            !calls.may_differ
        })
    }

    /// The variables of a block that are read from a place which an earlier one was read from, and
    /// which has not been assigned to since: the two are equal, and so they are one variable to the
    /// reverse sweep, which then changes the cotangent of the place once.
    pub fn earlier_reads(&self, block: &Block) -> HashMap<VarId, VarId> {
        let mut reads: HashMap<_, VarId> = HashMap::new();
        let mut earlier = HashMap::new();
        for statement in &block.statements {
            if let Statement::Define { var, operation: Operation::Read(place), .. } = statement {
                match reads.entry(self.key(place)) {
                    Entry::Occupied(first) => {
                        earlier.insert(*var, *first.get());
                    }
                    Entry::Vacant(vacant) if !self.vars[*var].mutable => {
                        vacant.insert(*var);
                    }
                    Entry::Vacant(_) => {}
                }
            }
            let mut assigned = HashSet::new();
            self.assigned(statement, &mut assigned);
            reads.retain(|(root, _), _| !assigned.contains(root));
        }
        earlier
    }

    /// Collects the variables that a statement may assign to, at any depth.
    pub fn assigned(&self, statement: &Statement, into: &mut HashSet<VarId>) {
        match statement {
            Statement::Assign { place, .. } | Statement::Update { place, .. } => {
                into.insert(place.root);
            }
            Statement::Branch(_) | Statement::Loop(_) | Statement::Build(_) => {
                let inner = statement.blocks().into_iter().flat_map(|block| &block.statements);
                inner.for_each(|statement| self.assigned(statement, into));
            }
            Statement::Plain { code, .. } => {
                into.extend(self.uses(code).into_iter().filter(|&var| self.vars[var].mutable));
            }
            Statement::Define { operation: Operation::Call { arguments, .. }, .. } => {
                let changed = arguments.iter().filter_map(|argument| argument.changed(self.vars));
                into.extend(changed.map(|place| place.root));
            }
            Statement::Define { .. } | Statement::Destructure { .. } | Statement::Keep(_) => {}
        }
    }
}

/// Whether the path leads to an element of an array through indices alone.
pub fn is_element(path: &[Projection]) -> bool {
    let mut steps = path.iter().filter(|step| step.is_part()).peekable();
    // An index of several tokens is a range.
    let is_index = |step: &Projection| matches!(step, Projection::Index(index) if index.clone().into_iter().count() == 1);
    steps.peek().is_some() && steps.all(is_index)
}

/// What checks that a value carries no derivative.
fn constant() -> TokenStream {
    quote!(::ad::rt::constant)
}

/// A slice or a `Vec`, or a reference to one.
fn is_sequence(ty: &Type) -> bool {
    match pointee(ty) {
        Type::Slice(_) => true,
        Type::Path(path) => path.path.segments.last().is_some_and(|last| last.ident == "Vec"),
        _ => false,
    }
}
