//! `collect` into an option or a result of a `Vec`: a loop that ends with the first failure.

use quote::quote;
use syn::{Expr, ExprMethodCall, GenericArgument, PathArguments, Type, parse_quote};

use super::Lowerer;
use crate::ir::Operand;
use crate::types::element;

impl Lowerer<'_> {
    /// `.collect::<Option<Vec<_>>>()`, `.collect::<Result<Vec<_>, _>>()`, if `ty` is one of these.
    pub(super) fn collected_attempts(
        &mut self,
        call: &ExprMethodCall,
        ty: &Type,
        hint: &str,
    ) -> Option<Operand> {
        let (elements, error) = attempt(ty)?;
        let [all, value, failure] =
            ["collected", "value", "failure"].map(|name| self.names.unwritten(name));
        let chain = &call.receiver;
        let (option, result) = (quote!(::core::option::Option), quote!(::core::result::Result));
        let collected: Expr = match error {
            None => parse_quote!({
                let mut #all: #elements = ::std::vec::Vec::new();
                let mut #failure: bool = false;
                for #value in #chain {
                    match #value {
                        #option::Some(#value) => #all.push(#value),
                        #option::None => {
                            #failure = true;
                            break;
                        }
                    }
                }
                if #failure { #option::None } else { #option::Some(#all) }
            }),
            Some(error) => parse_quote!({
                    let mut #all: #elements = ::std::vec::Vec::new();
                    let mut #failure: #option<#error> = #option::None;
                    for #value in #chain {
                        match #value {
                            #result::Ok(#value) => #all.push(#value),
                            #result::Err(#value) => {
                                #failure = #option::Some(#value);
                                break;
                            }
                        }
                    }
                    match #failure {
                        #option::None => #result::Ok(#all),
                        #option::Some(#value) => #result::Err(#value),
                    }
            }),
        };
        Some(self.operand(&collected, hint))
    }
}

/// `Vec<T>` of `Option<Vec<T>>`, and with the type of errors of `Result<Vec<T>, E>`; for both may stand `_`.
fn attempt(ty: &Type) -> Option<(Type, Option<Type>)> {
    let Type::Path(path) = ty else { return None };
    let last = path.path.segments.last()?;
    let PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
    let mut arguments = arguments.args.iter().filter_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty.clone()),
        _ => None,
    });
    let elements = match arguments.next()? {
        Type::Infer(_) => parse_quote!(::std::vec::Vec<_>),
        ty => (matches!(ty, Type::Path(_)) && element(&ty).is_some()).then_some(ty)?,
    };
    match &*last.ident.to_string() {
        "Option" => Some((elements, None)),
        // An alias may leave the type of errors out.
        "Result" => Some((elements, Some(arguments.next().unwrap_or_else(|| parse_quote!(_))))),
        _ => None,
    }
}
