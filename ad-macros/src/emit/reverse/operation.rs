//! The pullback of each operation.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Member, Type};

use super::contribute::{Target, cotangent_of};
use super::{Sides, Sweeper};
use crate::emit::lending;
use crate::ir::primal::Primal;
use crate::ir::{
    Argument, BinaryOperator, Derivative, Operand, Operation, Place, Projection, Shape, Var, VarId,
};
use crate::names;

/// To a function of more parameters nothing is lent.
const MOST_LENT: usize = 12;

impl Sweeper<'_> {
    pub(super) fn define(&mut self, var: VarId, ty: Option<&Type>, operation: &Operation) -> Sides {
        let mut reverse = TokenStream::new();
        let pulls_back = self.started.contains(&var) || self.changes_live_place(operation);
        if pulls_back {
            self.start(&mut reverse, var);
            self.pull_back(&mut reverse, var, operation);
        }
        if self.loop_depth > 0 && self.is_fixed(var, operation) {
            let (ident, value) = (&self.vars[var].ident, self.primal(operation, self.span(var)));
            let ty = ty.map(|ty| quote!(: #ty));
            self.top.extend(quote!(let #ident #ty = #value;));
            return Sides::default();
        }
        let Var { ident, record, mutable, .. } = &self.vars[var];
        let mutability = mutable.then(|| quote!(mut));
        let ty = ty.map(|ty| quote!(: #ty));
        let forward = match operation {
            // Without forward mode the derivative has to exist also where nothing flows back through it.
            Operation::Call { callee, arguments }
                if pulls_back || self.is_alone && self.vars[var].active =>
            {
                let (vjp, is_method) = (callee.derivative.vjp(), callee.is_method);
                let lends = pulls_back && self.lends(operation);
                let told = self.told(callee, arguments);
                let call = match (lends, callee.derivative.vjp_onto()) {
                    (true, Some(vjp_onto)) => self.call(&vjp_onto, is_method, arguments),
                    (true, None) => {
                        let method = self.lent_method(operation).expect("a method is lent");
                        self.lent_call(record, method, &vjp, arguments)
                    }
                    (false, _) if pulls_back && !told.is_empty() => {
                        self.told_call(&vjp, callee, arguments, &told)
                    }
                    (false, _) => self.call(&vjp, is_method, arguments),
                };
                let check = Primal(self.vars).check_name(callee, arguments, ident);
                let [before, after] = check.unwrap_or_default();
                let record = if pulls_back { quote!(#record) } else { quote!(_) };
                quote!(#before let (#ident, #record) = #call; #after)
            }
            Operation::Closure(closure) => {
                let object = self.object(closure);
                quote!(let #ident #ty = #object;)
            }
            operation => {
                let value = match operation {
                    Operation::Binary(operator, left, right)
                        if pulls_back && !operator.is_linear() =>
                    {
                        self.product(*operator, [*left, *right], ident.span())
                    }
                    operation => self.primal(operation, ident.span()),
                };
                let kept = match operation {
                    Operation::Negate(value) if pulls_back => {
                        self.kept(record, "Negation", &[*value])
                    }
                    Operation::Binary(BinaryOperator::Add, left, right) if pulls_back => {
                        self.kept(record, "Sum", &[*left, *right])
                    }
                    Operation::Binary(BinaryOperator::Sub, left, right) if pulls_back => {
                        self.kept(record, "Difference", &[*left, *right])
                    }
                    _ => TokenStream::new(),
                };
                quote!(#kept let #mutability #ident #ty = #value;)
            }
        };
        let (space_definition, test) = (self.space_definition(var), self.test(var));
        let mut defines = self.names_of(var);
        if self.loop_depth == 0 || matches!(operation, Operation::Call { .. }) {
            defines.push(record.clone());
        }
        Sides { forward: quote!(#forward #space_definition #test), reverse, defines }
    }

    /// The call of a method that may be lent cotangents.
    fn lent_call(
        &mut self,
        record: &Ident,
        method: lending::Method,
        vjp: &TokenStream,
        arguments: &[Argument],
    ) -> TokenStream {
        let tokens = |argument| Primal(self.vars).argument(argument);
        let receiver = match &arguments[0] {
            Argument::Borrow(place) => {
                let place = self.place(place);
                quote!((&#place))
            }
            // Of a `&mut` itself every type has the default.
            Argument::Receiver(place)
                if place.path.is_empty() && self.vars[place.root].exclusive =>
            {
                let place = self.place(place);
                quote!((*#place))
            }
            receiver => tokens(receiver),
        };
        // So it has of a reference, where the type's own takes what that refers to by value.
        let is_reference = match &arguments[0] {
            Argument::Borrow(_) => true,
            Argument::Receiver(Place { root, path }) => {
                path.is_empty() && self.facts.is_given_by_reference(*root)
            }
            Argument::Value(Operand::Var(var)) => {
                matches!(self.facts.operation(*var), Some(Operation::Borrow(_)))
            }
            _ => false,
        };
        let lender = if is_reference { quote!((*#receiver)) } else { receiver.clone() };
        let arguments: Vec<_> = arguments[1..].iter().map(tokens).collect();
        let call = method.call(record, [&receiver, &lender], vjp, &arguments);
        self.lending_methods.insert(method);
        call
    }

    /// Whether the operation is a constant that is the same in every iteration.
    fn is_fixed(&self, var: VarId, operation: &Operation) -> bool {
        matches!(operation, Operation::Use(Operand::Constant(code))
            if self.facts.is_number(var) && self.facts.is_fixed(code))
            && !self.vars[var].mutable
    }

    pub(super) fn ident(&self, var: VarId) -> &Ident {
        &self.vars[var].ident
    }

    pub(super) fn call(
        &self,
        function: &TokenStream,
        method: bool,
        arguments: &[Argument],
    ) -> TokenStream {
        Primal(self.vars).call(function, method, arguments)
    }

    pub(super) fn place(&self, place: &Place) -> TokenStream {
        Primal(self.vars).place(place)
    }

    /// The operation as the user wrote it.
    pub(super) fn primal(&self, operation: &Operation, span: proc_macro2::Span) -> TokenStream {
        Primal(self.vars).operation(operation, span)
    }

    /// Gives the cotangent of `var` to what it was made from.
    fn pull_back(&mut self, reverse: &mut TokenStream, var: VarId, operation: &Operation) {
        let Var { cotangent, record, ident, .. } = &self.vars[var];
        let (cotangent, span) = (quote!(#cotangent), ident.span());
        match operation {
            Operation::Use(Operand::Constant(_)) | Operation::Named { .. } => {}
            Operation::Use(Operand::Var(source)) if self.numbers.number(var).is_some() => {
                self.add(reverse, *source, &[], cotangent);
            }
            Operation::Use(Operand::Var(source)) | Operation::Value(source) => {
                self.contribute(reverse, *source, &[], cotangent);
            }
            Operation::Read(place) if self.numbers.number(var).is_some() => {
                self.add(reverse, place.root, &place.path, cotangent);
            }
            Operation::Read(place) | Operation::Clone(place, _) | Operation::Borrow(place) => {
                self.contribute(reverse, place.root, &place.path, cotangent);
            }
            Operation::Negate(value) => self.pull_back_negation(reverse, record, *value, cotangent),
            Operation::Binary(operator, left, right) => {
                self.pull_back_binary(reverse, record, *operator, [*left, *right], cotangent, span);
            }
            Operation::Cast(value, ty) => {
                let source = self.ident(*value);
                let pulled = quote_spanned!(span=>
                    ::ad::rules::CastPullback::<#ty>::cast_pullback(#source, #cotangent));
                self.contribute(reverse, *value, &[], pulled);
            }
            Operation::Call { callee, arguments } => {
                let lends = self.lends(operation);
                let told = if lends { Vec::new() } else { self.told(callee, arguments) };
                let pulled = match told.is_empty() {
                    true => self.call_pullback(reverse, record, cotangent, arguments, lends),
                    false => self.told_pullback(reverse, record, cotangent, arguments, &told),
                };
                let mut targets: Vec<_> = arguments.iter().map(argument_target).collect();
                if let (true, Some(Some(receiver))) = (callee.is_method, targets.first_mut()) {
                    receiver.is_coerced |= self.may_be_box(receiver.place.root);
                }
                self.contribute_all(reverse, &targets, pulled, false);
            }
            Operation::Aggregate { shape: Shape::Boxed, parts, .. } => {
                for (_, part) in parts {
                    if let Operand::Var(part) = part {
                        let space = self.space(*part);
                        self.contribute(reverse, *part, &[], quote!(#space.enter(#cotangent)));
                    }
                }
            }
            Operation::Aggregate { shape: Shape::Transparent, parts, .. } => {
                for (_, part) in parts {
                    if let Operand::Var(part) = part {
                        self.contribute(reverse, *part, &[], cotangent.clone());
                    }
                }
            }
            Operation::Aggregate { shape: shape @ (Shape::Array | Shape::Vec), parts, .. } => {
                let targets: Vec<_> = parts.iter().map(|(_, part)| operand_target(part)).collect();
                let elements = match shape {
                    Shape::Vec => quote!(::ad::rt::Enter::enter(#cotangent)),
                    _ => cotangent,
                };
                self.contribute_all(reverse, &targets, elements, true);
            }
            Operation::Aggregate { shape, parts, .. } => {
                for (member, part) in parts {
                    let Operand::Var(part) = part else { continue };
                    let field = match shape {
                        Shape::Variant(variant) => quote!(#cotangent.#variant.#member),
                        _ => quote!(#cotangent.#member),
                    };
                    let value = match shape {
                        Shape::Struct | Shape::Updated | Shape::Variant(_) => {
                            self.check_stored(reverse, *part, &field, member.span());
                            let space = self.space(*part);
                            quote!(#space.enter(#field))
                        }
                        _ => field,
                    };
                    self.contribute(reverse, *part, &[], value);
                }
            }
            Operation::UpdateStruct { parts, rest, .. } => {
                reverse.extend(quote!(let mut #cotangent = #cotangent;));
                for (member, part) in parts {
                    self.pull_field(reverse, &cotangent, member, part);
                }
                self.contribute(reverse, rest.root, &rest.path, cotangent);
            }
            Operation::Closure(closure) => {
                for (index, (_, place)) in closure.captures.iter().enumerate() {
                    let part = Member::from(index);
                    let part = quote!(#cotangent.#part);
                    self.contribute(reverse, place.root, &place.path, part);
                }
            }
            Operation::Repeat { value, .. } => {
                self.contribute(reverse, *value, &[], quote!(::ad::rt::sum(#cotangent)));
            }
        }
    }

    /// Whether a variable may be a box, of which a method is given the content.
    fn may_be_box(&self, var: VarId) -> bool {
        let comes_from_elsewhere = match self.facts.operation(var) {
            Some(operation) => matches!(operation, Operation::Call { .. } | Operation::Use(_)),
            None => true,
        };
        comes_from_elsewhere && self.numbers.number(var).is_none()
    }

    /// The call of the pullback of a call. What the call may have changed lends it its cotangent.
    fn call_pullback(
        &mut self,
        reverse: &mut TokenStream,
        record: &Ident,
        cotangent: TokenStream,
        arguments: &[Argument],
        lends: bool,
    ) -> TokenStream {
        let mut lent = Vec::new();
        let mut receiver = None;
        // Which of several were borrowed as `&` no type could tell.
        let changed = arguments.iter().filter_map(|argument| argument.changed(self.vars));
        let is_only_one = changed.count() == 1;
        for argument in arguments {
            match argument {
                Argument::Reborrow(place) if is_only_one && self.vars[place.root].active => {
                    self.start(reverse, place.root);
                    receiver = Some(cotangent_of(&self.vars[place.root].cotangent, &place.path));
                }
                Argument::Exclusive(place) | Argument::Reborrow(place)
                    if !self.vars[place.root].active =>
                {
                    lent.push(self.of_constant(place));
                }
                Argument::Exclusive(place) | Argument::Reborrow(place) => {
                    self.start(reverse, place.root);
                    let lender = cotangent_of(&self.vars[place.root].cotangent, &place.path);
                    lent.push(quote!(::ad::rt::take_changed(#lender)));
                }
                Argument::Receiver(place) if self.is_constant(place) => {
                    receiver = Some(quote!(&mut ::ad::NoTangent::<()>::new()));
                }
                Argument::Receiver(place) if self.vars[place.root].mutable => {
                    self.start(reverse, place.root);
                    receiver = Some(cotangent_of(&self.vars[place.root].cotangent, &place.path));
                }
                Argument::Value(_)
                | Argument::Borrow(_)
                | Argument::Function(_)
                | Argument::Callee(_)
                | Argument::PassedOn(..)
                | Argument::Receiver(_) => {}
            }
        }
        if lends {
            let onto: Vec<_> =
                arguments.iter().map(|argument| self.lend(reverse, argument)).collect();
            return match receiver {
                None => quote! {
                    ::ad::rt::PullbackOnto::pull_back(#record, #cotangent, (#(#lent,)*), (#(#onto,)*))
                },
                Some(receiver) => {
                    let offered = Ident::new("offered", Span::mixed_site());
                    quote! {{
                        let #offered = (#(#onto,)*);
                        ::ad::rt::MethodPullbackOnto::pull_back(#record, #cotangent, #receiver, #offered)
                    }}
                }
            };
        }
        match receiver {
            None => quote!(#record(#cotangent #(, #lent)*)),
            Some(receiver) => quote! {
                ::ad::rt::MethodPullback::pull_back(#record, #cotangent, #receiver, (#(#lent,)*))
            },
        }
    }

    /// Whether an operation is a call that is lent cotangents (see [`lending`]).
    fn lends(&self, operation: &Operation) -> bool {
        let Operation::Call { callee, arguments } = operation else { return false };
        // Whether a `&mut` was taken as `&` the types tell of one of them, if nothing else is changed.
        let reborrowed = arguments.iter().filter_map(|argument| match argument {
            Argument::Reborrow(place) => Some(self.vars[place.root].active),
            _ => None,
        });
        let is_told = match reborrowed.collect::<Vec<_>>()[..] {
            [] => true,
            [is_active] => {
                let changes = |argument: &Argument| matches!(argument, Argument::Exclusive(_));
                is_active && !callee.is_method && !arguments.iter().any(changes)
            }
            _ => false,
        };
        let may_lend = match callee.is_method {
            true => {
                // What a method may have changed, and what it was lent besides, no type would tell.
                let may_change = matches!(&arguments[0],
                    Argument::Receiver(place) if self.vars[place.root].mutable);
                let changes = |argument: &Argument| matches!(argument, Argument::Exclusive(_));
                self.lent_method(operation).is_some()
                    && !(may_change && arguments.iter().any(changes))
                    && arguments.iter().all(|argument| self.may_stand_beside_lent(argument))
            }
            false => callee.derivative.vjp_onto().is_some(),
        };
        may_lend
            && arguments.len() <= MOST_LENT
            && is_told
            && arguments.iter().any(|argument| match argument {
                Argument::Exclusive(_) => true,
                // What comes back need not be brought to size.
                Argument::Value(Operand::Var(var)) if self.moves(*var) => true,
                argument => self.lent_place(argument).is_some(),
            })
    }

    /// Whether a value is known to move where it is passed.
    fn moves(&self, var: VarId) -> bool {
        let source = match self.facts.operation(var) {
            Some(Operation::Read(place) | Operation::Clone(place, _)) if place.path.is_empty() => {
                place.root
            }
            Some(Operation::Use(Operand::Var(source))) => *source,
            _ => var,
        };
        [var, source].iter().any(|var| self.movable.contains(var))
    }

    /// The method that is called, if it may be one that is lent cotangents: none with a rule in `ad`.
    fn lent_method(&self, operation: &Operation) -> Option<lending::Method> {
        let Operation::Call { callee, arguments } = operation else { return None };
        let Derivative::Sibling { name, turbofish: None, .. } = &callee.derivative else {
            return None;
        };
        let is_own = callee.is_method && !callee.may_have_rule;
        let is_mutable = |receiver: &Argument| matches!(receiver, Argument::Receiver(place) if self.vars[place.root].mutable);
        is_own.then(|| lending::Method {
            name: name.clone(),
            arity: arguments.len() - 1,
            is_mutable: arguments.first().is_some_and(is_mutable),
        })
    }

    /// Whether a method that is passed this may be one that is lent cotangents.
    fn may_stand_beside_lent(&self, argument: &Argument) -> bool {
        !Primal(self.vars).is_function(argument)
            && match argument {
                Argument::Value(Operand::Constant(tokens)) => lending::has_own_type(tokens),
                Argument::Reborrow(_)
                | Argument::Function(_)
                | Argument::Callee(_)
                | Argument::PassedOn(..) => false,
                Argument::Value(Operand::Var(_))
                | Argument::Borrow(_)
                | Argument::Exclusive(_)
                | Argument::Receiver(_) => true,
            }
    }

    /// The place to which an argument is a reference, as far as can be seen: what a pattern binds may be a value,
    /// of which nothing is taken.
    fn lent_place(&self, argument: &Argument) -> Option<Place> {
        let place = match argument {
            Argument::Borrow(place) | Argument::Reborrow(place) | Argument::Receiver(place) => {
                place.clone()
            }
            Argument::Value(Operand::Var(var))
                if self.references.iter().any(|(reference, _)| reference == var)
                    || matches!(self.facts.operation(*var), Some(Operation::Borrow(_)))
                    || self.vars[*var].reference && self.facts.stands_for(*var).is_some() =>
            {
                Place::of(*var)
            }
            _ => return None,
        };
        self.vars[place.root].active.then_some(place)
    }

    /// The cotangent so far, for the function that is given this argument.
    fn lend(&mut self, reverse: &mut TokenStream, argument: &Argument) -> TokenStream {
        let is_range = |place: &Place| place.path.last().is_some_and(Projection::is_range);
        // A range would have to be moved out element by element: what the function touches is less.
        let Some(place) = self.lent_place(argument).filter(|place| !is_range(place)) else {
            return quote!(::ad::rt::Lent::nothing());
        };
        self.start(reverse, place.root);
        let lender = cotangent_of(&self.vars[place.root].cotangent, &place.path);
        quote!(::ad::rt::Take::take(#lender))
    }

    /// The cotangent of what never carries a derivative, and may be changed.
    pub(super) fn of_constant(&self, place: &Place) -> TokenStream {
        names::located(quote!(::ad::rt::of_constant()), self.ident(place.root).span())
    }

    /// Whether a place changes and never carries a derivative.
    pub(super) fn is_constant(&self, place: &Place) -> bool {
        !self.vars[place.root].active && self.vars[place.root].mutable
    }

    /// Whether an operation may change something whose cotangent is not zero. What it makes of a
    /// constant is none: the type of the pullback, which is called, tells that it stays one.
    fn changes_live_place(&mut self, operation: &Operation) -> bool {
        let Operation::Call { arguments, .. } = operation else { return false };
        arguments.iter().filter_map(Argument::changeable).any(|place| {
            self.is_constant(place) || self.vars[place.root].mutable && self.is_live(place)
        })
    }

    /// A field that a struct update sets: its cotangent does not reach the rest.
    fn pull_field(
        &mut self,
        reverse: &mut TokenStream,
        cotangent: &TokenStream,
        member: &Member,
        part: &Operand,
    ) {
        let taken = quote!(::ad::rt::take(&mut #cotangent.#member));
        match part {
            Operand::Constant(_) => reverse.extend(quote!(#taken;)),
            Operand::Var(part) => {
                let field = quote!(#cotangent.#member);
                self.check_stored(reverse, *part, &field, member.span());
                let space = self.space(*part);
                self.contribute(reverse, *part, &[], quote!(#space.enter(#taken)));
            }
        }
    }
}

fn operand_target(operand: &Operand) -> Option<Target> {
    match operand {
        Operand::Constant(_) => None,
        Operand::Var(root) => Some(Target::whole(*root)),
    }
}

fn argument_target(argument: &Argument) -> Option<Target> {
    match argument {
        Argument::Value(operand) => operand_target(operand),
        Argument::Function(var) => Some(Target::whole(*var)),
        Argument::Borrow(place)
        | Argument::Callee(place)
        | Argument::PassedOn(place, _)
        | Argument::Exclusive(place)
        | Argument::Reborrow(place)
        | Argument::Receiver(place) => {
            let path = place.path.iter().filter(|step| step.is_part()).cloned().collect();
            let is_coerced = !matches!(argument, Argument::Receiver(_));
            Some(Target { place: Place { root: place.root, path }, is_coerced })
        }
    }
}
