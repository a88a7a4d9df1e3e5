//! `collect`, `sum` and `product` into an option or a result: loops that end with the first failure.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Expr, ExprMethodCall, GenericArgument, PathArguments, Type, parse_quote};

use crate::ir::{BinaryOperator, Operand};
use crate::lower::Lowerer;
use crate::lower::rewrite::desugar::scrutinee;
use crate::types::element;

/// An option or a result of a type.
struct Attempt {
    content: Type,
    /// The type of the errors of a result.
    error: Option<Type>,
}

impl Lowerer<'_> {
    /// `.collect::<Option<Vec<_>>>()`, `.collect::<Result<Vec<_>, _>>()`, if `ty` is one of these.
    pub(super) fn collected_attempts(
        &mut self,
        call: &ExprMethodCall,
        ty: &Type,
        hint: &str,
    ) -> Option<Operand> {
        let attempt = Attempt::of(ty)?;
        let content = match &attempt.content {
            Type::Infer(_) => parse_quote!(::std::vec::Vec<_>),
            ty => (matches!(ty, Type::Path(_)) && element(ty).is_some()).then(|| ty.clone())?,
        };
        let start = quote!(::std::vec::Vec::new());
        let attempt = Attempt { content, ..attempt };
        Some(self.until_failure(call, attempt, start, hint, |all, value| quote!(#all.push(#value))))
    }

    /// `.sum::<Option<_>>()`, `.product::<Result<_, _>>()`, if `ty` is one of these; the operator is that of
    /// the method.
    pub(super) fn accumulated_attempts(
        &mut self,
        call: &ExprMethodCall,
        ty: &Type,
        operator: BinaryOperator,
        hint: &str,
    ) -> Option<Operand> {
        let attempt = Attempt::of(ty)?;
        let content = &attempt.content;
        let start = match operator {
            BinaryOperator::Add => quote!(::ad::rt::empty_sum::<#content>()),
            _ => quote!(::ad::rt::empty_product::<#content>()),
        };
        let step = |all: &Ident, value: &Ident| match operator {
            BinaryOperator::Add => quote!(#all = #all + #value),
            _ => quote!(#all = #all * #value),
        };
        Some(self.until_failure(call, attempt, start, hint, step))
    }

    /// What `step` makes of `start` and one content after the other, or the first failure.
    fn until_failure(
        &mut self,
        call: &ExprMethodCall,
        Attempt { content, error }: Attempt,
        start: TokenStream,
        hint: &str,
        step: impl Fn(&Ident, &Ident) -> TokenStream,
    ) -> Operand {
        let [all, value, failure] =
            ["all", "value", "failure"].map(|name| self.names.unwritten(name));
        let chain = scrutinee(&call.receiver);
        let (option, result) = (quote!(::core::option::Option), quote!(::core::result::Result));
        let step = step(&all, &value);
        // What a success is, a failure as a pattern and as a value, and what is kept of it.
        let (full, empty, kept, error) = match error {
            None => (quote!(#option::Some), quote!(#option::None), quote!(()), parse_quote!(())),
            Some(error) => {
                (quote!(#result::Ok), quote!(#result::Err(#value)), quote!(#value), error)
            }
        };
        let gathered: Expr = parse_quote!({
            let mut #all: #content = #start;
            let mut #failure: #option<#error> = #option::None;
            for #value in #chain {
                match #value {
                    #full(#value) => #step,
                    #empty => {
                        #failure = #option::Some(#kept);
                        break;
                    }
                }
            }
            match #failure {
                #option::None => #full(#all),
                #option::Some(#value) => #empty,
            }
        });
        self.operand(&gathered, hint)
    }
}

impl Attempt {
    /// `Option<T>`, `Result<T, E>`, `Result<T>`: an alias may leave the type of errors out.
    fn of(ty: &Type) -> Option<Self> {
        let Type::Path(path) = ty else { return None };
        let last = path.path.segments.last()?;
        let PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
        let mut arguments = arguments.args.iter().filter_map(|argument| match argument {
            GenericArgument::Type(ty) => Some(ty.clone()),
            _ => None,
        });
        let content = arguments.next()?;
        let error = match &*last.ident.to_string() {
            "Option" => None,
            "Result" => Some(arguments.next().unwrap_or_else(|| parse_quote!(_))),
            _ => return None,
        };
        Some(Self { content, error })
    }
}
