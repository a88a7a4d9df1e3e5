//! Methods of options, results and truth values that are given closures: each is a `match` or `if`.
//!
//! They are told by name alone. Of the methods that options and results share, those of what is not seen
//! to be the one or the other are told by the type (`attempted`). A method of the user's with
//! such a name does not compile then, for its receiver is neither.

use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprMethodCall, Ident, Stmt, parse_quote};

use crate::ir::Operand;
use crate::lower::Lowerer;
use crate::lower::iterate::chain::is_chain;
use crate::lower::rewrite::desugar::scrutinee;
use crate::lower::rewrite::exits::may_change;
use crate::lower::search::has;
use crate::lower::state::Container;
use crate::lower::syntax::{calls, strip_parens};
use crate::rules;

impl Lowerer<'_> {
    /// The value of a method of an option, a result or a truth value, if `call` is one.
    pub fn optional(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        // They take it by value, so what stands behind a reference is copied.
        if self.is_reference(&call.receiver) {
            let depth = self.depth(&call.receiver).max(1);
            let receiver =
                (0..depth).fold((*call.receiver).clone(), |target, _| parse_quote!((*#target)));
            let receiver = Box::new(receiver);
            return self.optional_value(&ExprMethodCall { receiver, ..call.clone() }, hint);
        }
        self.optional_value(call, hint)
    }

    fn optional_value(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        let arguments: Vec<_> = call.args.iter().collect();
        let receiver = &scrutinee(&call.receiver);
        let [content, error] = ["content", "error"].map(|name| self.names.unwritten(name));
        let is_result = self.container(receiver) == Some(Container::Result);
        let (option, result) = (quote!(::core::option::Option), quote!(::core::result::Result));
        // Both as patterns and as expressions.
        let (some, none) = (quote!(#option::Some(#content)), quote!(#option::None));
        let (ok, err) = (quote!(#result::Ok(#content)), quote!(#result::Err(#error)));
        let (full, empty) = if is_result { (&ok, &err) } else { (&some, &none) };
        if self.container(receiver).is_none()
            && let Some(value) = self.attempted(call, hint)
        {
            return Some(value);
        }
        let failure: Vec<Expr> = if is_result { vec![parse_quote!(#error)] } else { Vec::new() };
        let desugared: Expr = match (&*call.method.to_string(), &arguments[..]) {
            ("then_some", [value]) => self.eagerly(receiver, value, |receiver, value| {
                parse_quote!(if #receiver { #option::Some(#value) } else { #none })
            }),
            ("then", [function]) => {
                let value = self.called(function, &[])?;
                parse_quote!(if #receiver { #option::Some(#value) } else { #none })
            }
            ("ok", []) => parse_quote!(match #receiver { #ok => #some, #result::Err(_) => #none }),
            ("ok_or", [otherwise]) => self.eagerly(receiver, otherwise, |receiver, otherwise| {
                parse_quote!(match #receiver { #some => #ok, #none => #result::Err(#otherwise) })
            }),
            ("ok_or_else", [function]) => {
                let otherwise = self.called(function, &[])?;
                parse_quote!(match #receiver { #some => #ok, #none => #result::Err(#otherwise) })
            }
            ("map_err", [function]) => {
                let otherwise = self.called(function, &[parse_quote!(#error)])?;
                parse_quote!(match #receiver { #ok => #ok, #err => #result::Err(#otherwise) })
            }
            ("unwrap_or_else", [function]) => match self.called(function, &[]) {
                Some(otherwise) => {
                    parse_quote!(match #receiver { #some => #content, #none => #otherwise })
                }
                None => {
                    let otherwise = self.called(function, &[parse_quote!(#error)])?;
                    parse_quote!(match #receiver { #ok => #content, #err => #otherwise })
                }
            },
            ("unwrap_or", [otherwise]) if lends(receiver) => {
                let taken = self.eagerly(receiver, otherwise, |receiver, otherwise| {
                    parse_quote!(match #receiver { #full => #content, #empty => #otherwise })
                });
                let taken = self.operand(&taken, hint);
                if let Operand::Var(reference) = taken {
                    self.vars[reference].reference = true;
                }
                return Some(taken);
            }
            ("map_or", [otherwise, function]) => {
                let value = self.called(function, &[parse_quote!(#content)])?;
                self.eagerly(receiver, otherwise, |receiver, otherwise| {
                    parse_quote!(match #receiver { #full => #value, #empty => #otherwise })
                })
            }
            ("map_or_else", [otherwise, function]) => {
                let value = self.called(function, &[parse_quote!(#content)])?;
                let otherwise = self.called(otherwise, &failure)?;
                parse_quote!(match #receiver { #full => #value, #empty => #otherwise })
            }
            ("and_then", [function]) => {
                let value = self.called(function, &[parse_quote!(#content)])?;
                parse_quote!(match #receiver { #full => #value, #empty => #empty })
            }
            ("filter", [function]) if !is_chain(receiver) => {
                let is_kept = self.names.unwritten("is_kept");
                let keeps = self.called(function, &[parse_quote!(&#content)])?;
                parse_quote!(match #receiver {
                    #some => {
                        let #is_kept = #keeps;
                        if #is_kept { #some } else { #none }
                    }
                    #none => #none,
                })
            }
            ("or_else", [function]) => {
                let otherwise = self.called(function, &failure)?;
                parse_quote!(match #receiver { #full => #full, #empty => #otherwise })
            }
            ("map", [function])
                if matches!(
                    self.container(receiver),
                    Some(Container::Option | Container::Result)
                ) =>
            {
                let value = self.called(function, &[parse_quote!(#content)])?;
                let mapped = match is_result {
                    true => quote!(#result::Ok(#value)),
                    false => quote!(#option::Some(#value)),
                };
                parse_quote!(match #receiver { #full => #mapped, #empty => #empty })
            }
            _ => return None,
        };
        Some(self.operand(&desugared, hint))
    }

    /// The value of a method that options and results share, on what its type tells to be either.
    fn attempted(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        let [attempt, parts, kind, content, failure] =
            ["attempt", "parts", "kind", "content", "failure"]
                .map(|name| self.names.unwritten(name));
        let of_content = |function| self.called(function, &[parse_quote!(#content)]);
        let arguments: Vec<_> = call.args.iter().collect();
        let again = parse_quote!(::ad::rules::attempt::again(#failure));
        let (full, empty): (Expr, Expr) = match (&*call.method.to_string(), &arguments[..]) {
            ("map", [function]) if !is_chain(&call.receiver) => {
                let value = of_content(function)?;
                (parse_quote!(::ad::rules::attempt::full(#kind, #value)), again)
            }
            ("and_then", [function]) => (of_content(function)?, again),
            ("map_or", [otherwise, function]) if !may_change(otherwise) => {
                (of_content(function)?, (*otherwise).clone())
            }
            ("map_or_else", [otherwise, function]) => {
                (of_content(function)?, self.called(otherwise, &[])?)
            }
            _ => return None,
        };
        let receiver = &call.receiver;
        let span = receiver.span();
        let [elements, index] = ["elements", "index"].map(|name| self.names.unwritten(name));
        Some(self.scope(|lowerer| {
            let value = lowerer.operand(receiver, "attempt");
            let of_attempt = lowerer.named(value, "attempt", span);
            lowerer.alias(&attempt, of_attempt);
            // What lends its content has no elements.
            let is_lent = lowerer.may_refer(of_attempt);
            let mapped = (!is_lent && lowerer.may_map_elements(call)).then(|| {
                let element = parse_quote!(::ad::rules::attempt::taken(#kind, &#elements[#index]));
                let value = lowerer.called(&call.args[0], &[element]);
                quote!(::ad::rules::attempt::whole(#kind, ::core::array::from_fn(|#index| #value)))
            });
            let [take_kind, take_apart] = match mapped {
                Some(_) => ["mapped_kind", "spread"],
                None => ["kind", "split"],
            };
            let [take_kind, take_apart] =
                [take_kind, take_apart].map(|name| Ident::new(name, span));
            let ident = lowerer.ident_at(of_attempt, span);
            let code = quote_spanned!(span=> ::ad::rules::attempt::#take_kind(&#ident));
            let var = lowerer.define_constant("kind", span, code);
            lowerer.alias(&kind, var);
            let taken = parse_quote!(::ad::rules::attempt::#take_apart(#attempt));
            let taken = lowerer.call(&taken, "parts");
            let taken = lowerer.named(taken, "parts", span);
            lowerer.vars[taken].reference = is_lent;
            lowerer.alias(&parts, taken);
            let desugared: Expr = match mapped {
                Some(mapped) => parse_quote!(match #parts {
                    ::core::result::Result::Ok(::core::result::Result::Ok(#content)) => #full,
                    ::core::result::Result::Ok(::core::result::Result::Err(#failure)) => #empty,
                    ::core::result::Result::Err(#elements) => #mapped,
                }),
                None => parse_quote!(match #parts {
                    ::core::result::Result::Ok(#content) => #full,
                    ::core::result::Result::Err(#failure) => #empty,
                }),
            };
            lowerer.operand(&desugared, hint)
        }))
    }

    /// Whether `map` may be that of an array: on what has its type from elsewhere. The function is written
    /// once more for elements, where it runs more than once, so nothing may move into it.
    fn may_map_elements(&self, call: &ExprMethodCall) -> bool {
        call.method == "map"
            && is_typed_elsewhere(&call.receiver)
            && !self.may_take_variable(&call.args[0])
    }

    /// Whether a variable that may not be `Copy` may move within an expression: it is named as a value.
    fn may_take_variable(&self, expr: &Expr) -> bool {
        let mut places: Vec<*const Expr> = Vec::new();
        has(expr, |part| {
            let place = match part {
                Expr::Field(field) => &field.base,
                Expr::Index(index) => &index.expr,
                Expr::MethodCall(call) => &call.receiver,
                Expr::Reference(reference) => &reference.expr,
                Expr::Path(path) => {
                    let var = self.variable(path).filter(|_| !places.contains(&(&raw const *part)));
                    return Some(var.is_some_and(|var| {
                        (self.movable.contains(&var) || self.own.contains(&var))
                            && !self.may_refer(var)
                    }));
                }
                _ => return None,
            };
            places.push(&raw const **place);
            None
        })
    }

    /// What `choose` makes of a receiver and an argument that is evaluated behind it in any case.
    fn eagerly(
        &mut self,
        receiver: &Expr,
        argument: &Expr,
        choose: impl FnOnce(&Expr, &Expr) -> Expr,
    ) -> Expr {
        if !may_change(argument) {
            return choose(receiver, argument);
        }
        let eager = self.names.unwritten("otherwise");
        let argument_first = parse_quote!(let #eager = #argument;);
        let eager = parse_quote!(#eager);
        let (statements, choice): (Vec<Stmt>, Expr) =
            match calls(receiver) || self.reads_changeable(receiver) {
                true => {
                    let option = self.names.unwritten("option");
                    let receiver_first = parse_quote!(let #option = #receiver;);
                    (vec![receiver_first, argument_first], choose(&parse_quote!(#option), &eager))
                }
                false => (vec![argument_first], choose(receiver, &eager)),
            };
        parse_quote!({ #(#statements)* #choice })
    }

    /// The call of a closure or a function with these arguments; `None` if it takes another number
    /// of them, or is neither.
    fn called(&self, function: &Expr, arguments: &[Expr]) -> Option<Expr> {
        let named = self.named_closure(function);
        let inputs = match (&named, strip_parens(function)) {
            (Some(closure), _) => closure.body.inputs.len(),
            (None, Expr::Closure(closure)) => closure.inputs.len(),
            (None, Expr::Path(_)) => arguments.len(),
            _ => return None,
        };
        let is_name = matches!(strip_parens(function), Expr::Path(_));
        (inputs == arguments.len()).then(|| match is_name {
            true => parse_quote!(#function(#(#arguments),*)),
            false => parse_quote!((#function)(#(#arguments),*)),
        })
    }
}

/// Whether the form of an expression tells nothing of its type.
fn is_typed_elsewhere(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Binary(_) | Expr::Call(_) | Expr::Field(_) | Expr::Index(_) => true,
        Expr::Path(_) | Expr::Unary(_) => true,
        Expr::MethodCall(call) if call.method == "map" => is_typed_elsewhere(&call.receiver),
        Expr::MethodCall(call) => rules::is_for_every_type(&call.method.to_string()),
        _ => false,
    }
}

/// Whether a call gives an option of a reference into what it is called on.
fn lends(expr: &Expr) -> bool {
    matches!(strip_parens(expr), Expr::MethodCall(call)
        if ["first", "last", "get"].iter().any(|name| call.method == name))
}
