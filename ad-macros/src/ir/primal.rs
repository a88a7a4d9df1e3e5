//! Operations as the user wrote them, for both modes.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::{
    Argument, BinaryOperator, Callee, Operand, Operation, Place, Projection, Var, VarId,
    may_be_known,
};
use crate::names;
use crate::names::own;

/// A part of a value as an expression.
pub fn project(root: TokenStream, path: &[Projection]) -> TokenStream {
    path.iter().fold(root, |place, step| match step {
        Projection::Field(member) => quote!(#place.#member),
        Projection::FromEnd(behind) => {
            let member = member_from_end(&quote!(&#place), *behind);
            quote!((*#member))
        }
        Projection::Index(index) => quote!(#place[#index]),
        Projection::Deref => quote!((*#place)),
        Projection::Behind(_) => unreachable!("is a place, of which a name is known"),
    })
}

/// A reference to the member of a tuple that has so many behind it, from one to the tuple.
pub fn member_from_end(tuple: &TokenStream, behind: usize) -> TokenStream {
    let (member, behind) = (own("member"), vec![quote!(_); behind]);
    quote!({ let (.., #member #(, #behind)*) = #tuple; #member })
}

/// A part of a tangent, whose type alone counts; nothing if it is all of it.
pub fn tangent_path(root: TokenStream, path: &[Projection]) -> Option<TokenStream> {
    let step = |step: &Projection| match step {
        Projection::Field(_) | Projection::FromEnd(_) => Some(step.clone()),
        // A range, which is several tokens, gives what can be indexed once more.
        Projection::Index(_) if !step.is_range() => Some(Projection::Index(quote!(0))),
        Projection::Index(_) | Projection::Deref | Projection::Behind(_) => None,
    };
    let steps: Vec<Projection> = path.iter().filter_map(step).collect();
    (!steps.is_empty()).then(|| project(root, &steps))
}

/// Writes operations on these variables.
#[derive(Clone, Copy)]
pub struct Primal<'a>(pub &'a [Var]);

impl<'a> Primal<'a> {
    fn ident(self, var: VarId) -> &'a Ident {
        &self.0[var].ident
    }

    /// An operand.
    pub fn tokens(self, operand: &Operand) -> TokenStream {
        match operand {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Var(var) => {
                let ident = self.ident(*var);
                quote!(#ident)
            }
        }
    }

    /// A place.
    pub fn place(self, place: &Place) -> TokenStream {
        let is_name = |step: &Projection| matches!(step, Projection::Behind(_));
        match place.path.iter().rposition(is_name) {
            Some(position) if let Projection::Behind(name) = place.path[position] => {
                let name = self.ident(name);
                project(quote!((*#name)), &place.path[position + 1..])
            }
            _ => {
                let root = self.ident(place.root);
                project(quote!(#root), &place.path)
            }
        }
    }

    /// An operator.
    pub fn operator(operator: BinaryOperator) -> TokenStream {
        match operator {
            BinaryOperator::Add => quote!(+),
            BinaryOperator::Sub => quote!(-),
            BinaryOperator::Mul => quote!(*),
            BinaryOperator::Div => quote!(/),
            BinaryOperator::Rem => quote!(%),
        }
    }

    /// An operator that changes the place to its left.
    pub fn assigning(operator: BinaryOperator) -> TokenStream {
        match operator {
            BinaryOperator::Add => quote!(+=),
            BinaryOperator::Sub => quote!(-=),
            BinaryOperator::Mul => quote!(*=),
            BinaryOperator::Div => quote!(/=),
            BinaryOperator::Rem => quote!(%=),
        }
    }

    /// What a call is given.
    pub fn argument(self, argument: &Argument) -> TokenStream {
        match argument {
            Argument::Value(operand) => self.tokens(operand),
            Argument::Borrow(place) | Argument::Callee(place) => {
                let place = self.place(place);
                quote!(&#place)
            }
            Argument::PassedOn(place, by) => {
                let (place, pass) = (self.place(place), by.pass());
                quote!(#pass(&#place))
            }
            Argument::Exclusive(place) | Argument::Reborrow(place) => {
                let place = self.place(place);
                quote!(&mut #place)
            }
            Argument::Function(var) => {
                let ident = self.ident(*var);
                quote!(#ident)
            }
            Argument::Receiver(place) => self.place(place),
        }
    }

    /// Whether a call is given a function.
    pub fn is_function(self, argument: &Argument) -> bool {
        match argument {
            Argument::Function(_) | Argument::Callee(_) | Argument::PassedOn(..) => true,
            Argument::Value(Operand::Var(var)) => self.0[*var].is_function,
            Argument::Borrow(place) => self.0[place.root].is_function,
            _ => false,
        }
    }

    /// A call of a function, or of a method, whose receiver is the first argument.
    pub fn call(self, function: &TokenStream, method: bool, arguments: &[Argument]) -> TokenStream {
        let given = arguments.iter().map(|argument| self.argument(argument)).collect();
        Self::call_given(function, method, arguments, given)
    }

    /// A call, with what it is given for each of the arguments.
    pub fn call_given(
        function: &TokenStream,
        method: bool,
        arguments: &[Argument],
        mut given: Vec<TokenStream>,
    ) -> TokenStream {
        if method {
            let mut receiver = given.remove(0);
            if let Argument::Borrow(_) = arguments[0] {
                receiver = quote!((#receiver));
            }
            quote!(#receiver.#function(#(#given),*))
        } else {
            quote!(#function(#(#given),*))
        }
    }

    /// In debug builds checks that a function and the derivative called in its place are of one name:
    /// they come from two name spaces. One part stands before the call, the other behind what gives `value`.
    pub fn check_name(
        self,
        callee: &Callee,
        arguments: &[Argument],
        value: &Ident,
    ) -> Option<[TokenStream; 2]> {
        let path = callee.derivative.path()?;
        // What takes an object is a derivative.
        if arguments.iter().any(|argument| self.is_function(argument)) {
            return None;
        }
        let primal = &callee.primal;
        let arguments = arguments.iter().map(|argument| self.argument(argument));
        let last = names::identifiers(primal.clone()).pop();
        let always = last
            .filter(|name| may_be_known(&name.to_string()))
            .map(|name| Ident::new("always", name.span()));
        let result = Ident::new("never_called", Span::mixed_site());
        Some([
            quote!(::ad::check_name!(#always #result = #primal, #path(), (#(#arguments),*));),
            quote!(::ad::same_result!(#always #result, #value);),
        ])
    }

    /// An operation, except for a closure, which has a name where it is defined only.
    pub fn operation(self, operation: &Operation, span: Span) -> TokenStream {
        match operation {
            Operation::Use(operand) => self.tokens(operand),
            Operation::Read(place) => self.place(place),
            Operation::Clone(place, None) => {
                let place = self.place(place);
                quote!(::core::clone::Clone::clone(&#place))
            }
            Operation::Clone(place, Some(kind)) => {
                let (kind, place) = (self.ident(*kind), self.place(place));
                quote!(::ad::rules::attempt::taken(#kind, &#place))
            }
            Operation::Borrow(place) => {
                let place = self.place(place);
                quote!(&#place)
            }
            Operation::Value(value) => {
                let value = self.ident(*value);
                quote_spanned!(span=> ::ad::rt::ByValue::by_value(#value))
            }
            Operation::Negate(value) => {
                let value = self.ident(*value);
                quote_spanned!(span=> -#value)
            }
            Operation::Binary(operator, left, right) => {
                let (left, right) = (self.ident(*left), self.ident(*right));
                match operator {
                    BinaryOperator::Add => quote_spanned!(span=> #left + #right),
                    BinaryOperator::Sub => quote_spanned!(span=> #left - #right),
                    BinaryOperator::Mul => quote_spanned!(span=> #left * #right),
                    BinaryOperator::Div => quote_spanned!(span=> #left / #right),
                    BinaryOperator::Rem => quote_spanned!(span=> #left % #right),
                }
            }
            Operation::Cast(value, ty) => {
                let value = self.ident(*value);
                quote!(#value as #ty)
            }
            // What takes an object is a derivative, but for the calls of it.
            Operation::Call { callee, arguments }
                if arguments.iter().any(|argument| self.is_function(argument))
                    && !matches!(arguments.first(), Some(Argument::Callee(_))) =>
            {
                let call = self.call(&callee.derivative.vjp(), callee.is_method, arguments);
                quote!(#call.0)
            }
            Operation::Call { callee, arguments } => {
                self.call(&callee.primal, callee.is_method, arguments)
            }
            Operation::Closure(_) => unreachable!("is written where it is defined"),
            Operation::Named { primal, derivative } => {
                let vjp = derivative.vjp();
                quote!(::ad::function::named(#primal, #vjp))
            }
            Operation::Aggregate { expression, .. }
            | Operation::UpdateStruct { expression, .. } => expression.clone(),
            Operation::Repeat { value, length, is_vec } => {
                let value = self.ident(*value);
                match is_vec {
                    true => quote!(::std::vec![#value; #length]),
                    false => quote!([#value; #length]),
                }
            }
        }
    }
}
