//! Methods that lend parts of a slice: `first`, `last`, `get`, `split_at`, `split_first`, and those
//! that lend two parts to be changed, as `split_at_mut`. Each is written with indices, so that a
//! cotangent goes to the part it belongs to, in constant time.

use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprMethodCall, Ident, Pat, RangeLimits, Stmt, parse_quote, parse_quote_spanned};

use crate::ir::{Argument, Callee, Operand, Operation, Projection, Statement};
use crate::lower::Lowerer;
use crate::lower::iterate::chain::is_chain;
use crate::lower::state::Alias;
use crate::lower::syntax::simple_name;
use crate::names::located;

impl Lowerer<'_> {
    /// The part of a slice, if `call` is such a method of a place, or `unwrap` or `expect` of one.
    pub fn lent(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        self.or_undone(|lowerer| lowerer.lent_part(call, hint))
    }

    fn lent_part(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        let unwrapped = match (&*call.method.to_string(), &*call.receiver) {
            ("unwrap" | "expect", Expr::MethodCall(inner)) => Some(inner),
            _ => None,
        };
        let inner = unwrapped.unwrap_or(call);
        if let Some(found) = self.found_item(inner, unwrapped.is_some(), hint) {
            return Some(found);
        }
        let index = self.names.unwritten("position");
        let positions: Vec<_> = inner.args.iter().collect();
        // An item of all elements is an element.
        let (slice, method) = match (&*inner.receiver, &*inner.method.to_string()) {
            (Expr::MethodCall(all), "nth") if all.method == "iter" => (&all.receiver, "get".into()),
            (Expr::MethodCall(all), "next") if all.method == "iter" => {
                (&all.receiver, "first".into())
            }
            (Expr::MethodCall(all), "last") if all.method == "iter" => {
                (&all.receiver, "last".into())
            }
            (_, method) => (&inner.receiver, method.to_owned()),
        };
        if is_chain(slice)
            || !["first", "last", "get", "split_first", "split_last", "split_at"]
                .contains(&&*method)
        {
            return None;
        }
        if self.calls_own_methods(slice) {
            return None;
        }
        let slice = &self.repeatable(slice);
        let span = inner.method.span();
        let (mut end, mut is_there): (Option<Stmt>, Expr) =
            (None, parse_quote_spanned!(span=> #index < #slice.len()));
        let (position, element): (Expr, Expr) = match (&*method, &positions[..]) {
            ("first", []) => {
                (parse_quote_spanned!(span=> 0), parse_quote_spanned!(span=> &#slice[#index]))
            }
            // Of an empty one the position is too large.
            ("last", []) => (
                parse_quote_spanned!(span=> #slice.len().wrapping_sub(1)),
                parse_quote_spanned!(span=> &#slice[#index]),
            ),
            ("get", [Expr::Range(range)]) => {
                let to = self.names.unwritten("end");
                let after: Expr = match (&range.end, range.limits) {
                    (Some(last), RangeLimits::Closed(_)) => parse_quote!(#last + 1),
                    (Some(end), RangeLimits::HalfOpen(_)) => parse_quote!(#end),
                    (None, _) => parse_quote!(#slice.len()),
                };
                is_there = parse_quote_spanned!(span=> #index <= #to && #to <= #slice.len());
                let part = parse_quote_spanned!(span=> &#slice[#index..#to]);
                let bound: Stmt = parse_quote!(let #to: ::core::primitive::usize = #after;);
                end = Some(bound);
                let start = range.start.as_deref().cloned();
                (start.unwrap_or_else(|| parse_quote_spanned!(span=> 0)), part)
            }
            ("get", [position]) => (
                parse_quote_spanned!(span=> #position),
                parse_quote_spanned!(span=> &#slice[#index]),
            ),
            ("split_first", []) => (
                parse_quote_spanned!(span=> 0),
                parse_quote_spanned!(span=> (&#slice[#index], &#slice[#index + 1..])),
            ),
            ("split_last", []) => (
                parse_quote_spanned!(span=> #slice.len().wrapping_sub(1)),
                parse_quote_spanned!(span=> (&#slice[#index], &#slice[..#index])),
            ),
            ("split_at", [position]) if unwrapped.is_none() => (
                parse_quote_spanned!(span=> #position),
                parse_quote_spanned!(span=> (&#slice[..#index], &#slice[#index..])),
            ),
            _ => return None,
        };
        let place = self.active_place(slice)?;
        // Somebody else's type may have a method of this name.
        let place = self.place_tokens(&place);
        self.push_plain(located(quote!(::ad::rt::is_sequence(&#place);), span));
        let is_whole = unwrapped.is_some() || inner.method == "split_at";
        let desugared: Expr = match is_whole {
            true => {
                parse_quote_spanned!(span=> {
                    let #index: ::core::primitive::usize = #position;
                    #end
                    #element
                })
            }
            false => parse_quote_spanned!(span=> {
                let #index: ::core::primitive::usize = #position;
                #end
                if #is_there {
                    ::core::option::Option::Some(#element)
                } else {
                    ::core::option::Option::None
                }
            }),
        };
        let part = self.operand(&desugared, hint);
        if let Operand::Var(var) = part {
            self.vars[var].reference = true;
        }
        Some(part)
    }

    /// The reference to the item that `find`, `max_by` and its kin choose, which computes nothing: they are asked for
    /// its number.
    fn found_item(
        &mut self,
        call: &ExprMethodCall,
        is_unwrapped: bool,
        hint: &str,
    ) -> Option<Operand> {
        let method = &call.method;
        let chooses = ["find", "max_by", "max_by_key", "min_by", "min_by_key"]
            .iter()
            .any(|name| method == name);
        let (true, Some(decides), 1) = (chooses, call.args.first(), call.args.len()) else {
            return None;
        };
        let index = self.names.unwritten("position");
        let (items, item) = self.numbered_items(&call.receiver, &index)?;
        let span = method.span();
        let position: Expr =
            parse_quote_spanned!(span=> ::ad::rt::position::#method(#items, #decides));
        let position = Operation::Use(Operand::Constant(self.plain(&position)));
        let var = self.bind(&index, false, false);
        let ty = Some(parse_quote!(::core::primitive::usize));
        self.push(Statement::Define { var, ty, operation: position });
        let found: Expr = match is_unwrapped {
            true => item,
            false => parse_quote!(if #index == ::core::primitive::usize::MAX {
                ::core::option::Option::None
            } else {
                ::core::option::Option::Some(#item)
            }),
        };
        let found = self.operand(&found, hint);
        if let Operand::Var(var) = found {
            self.vars[var].reference = true;
        }
        Some(found)
    }

    /// An iterator over references to elements, with their numbers, and the item whose number is `index`.
    fn numbered_items(&mut self, items: &Expr, index: &Ident) -> Option<(Expr, Expr)> {
        match items {
            Expr::Paren(inner) => self.numbered_items(&inner.expr, index),
            Expr::MethodCall(call) if call.method == "filter" && call.args.len() == 1 => {
                let (items, item) = self.numbered_items(&call.receiver, index)?;
                let (span, is_kept) = (call.method.span(), &call.args[0]);
                let filtered =
                    parse_quote_spanned!(span=> ::ad::rt::position::filtered(#items, #is_kept));
                Some((filtered, item))
            }
            items => {
                let mut items = items.clone();
                let item = self.item_by_number(&mut items, index)?;
                let span = items.span();
                Some((parse_quote_spanned!(span=> ::ad::rt::position::numbered(#items)), item))
            }
        }
    }

    /// The item at `index` of an iterator over references to elements, whose places then have names.
    fn item_by_number(&mut self, items: &mut Expr, index: &Ident) -> Option<Expr> {
        match items {
            Expr::Paren(inner) => self.item_by_number(&mut inner.expr, index),
            Expr::Reference(reference) if reference.mutability.is_none() => {
                self.element_by_number(&mut reference.expr, index)
            }
            // Of what is zipped with.
            slice @ Expr::Path(_) if self.is_reference(slice) => {
                self.element_by_number(slice, index)
            }
            Expr::MethodCall(call) => match (&*call.method.to_string(), call.args.len()) {
                ("iter", 0) => self.element_by_number(&mut call.receiver, index),
                ("enumerate", 0) => {
                    let item = self.item_by_number(&mut call.receiver, index)?;
                    Some(parse_quote!((#index, #item)))
                }
                ("zip", 1) => {
                    let left = self.item_by_number(&mut call.receiver, index)?;
                    let right = self.item_by_number(&mut call.args[0], index)?;
                    Some(parse_quote!((#left, #right)))
                }
                _ => None,
            },
            _ => None,
        }
    }

    fn element_by_number(&mut self, slice: &mut Expr, index: &Ident) -> Option<Expr> {
        let place = self.active_place(slice)?;
        let tokens = self.place_tokens(&place);
        self.push_plain(located(quote!(::ad::rt::is_sequence(&#tokens);), slice.span()));
        let name = self.names.unwritten("elements");
        self.alias_place(&name, Alias { depth: 0, ..Alias::shared(place) });
        *slice = parse_quote!(#name);
        Some(parse_quote!(&#name[#index]))
    }

    /// `vec.drain(range)`, as the `Vec` of what it gives, and `slice.copy_within(range, position)`.
    pub fn ranged(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        let arguments: Vec<_> = call.args.iter().collect();
        let (function, range, rest) = match (&*call.method.to_string(), &arguments[..]) {
            ("drain", [Expr::Range(range)]) => ("drained", range, None),
            ("copy_within", [Expr::Range(range), at]) => ("copied_within", range, Some(*at)),
            _ => return None,
        };
        let mut is_named = false;
        let place = self.place_if(&call.receiver, |lowerer, place| {
            is_named = true;
            lowerer.vars[place.root].active
        });
        let mut place = match place {
            Some(place) => place,
            None if is_named => return None,
            None => {
                let receiver = self.scalar(&call.receiver, "receiver");
                self.changeable(receiver, "receiver", call.receiver.span())
            }
        };
        if !self.vars[place.root].active {
            let (receiver, method) = (self.place_tokens(&place), &call.method);
            let arguments: Vec<_> =
                arguments.into_iter().map(|argument| self.plain(argument)).collect();
            return Some(Operand::Constant(quote!(#receiver.#method(#(#arguments),*))));
        }
        if place.path.is_empty() && self.vars[place.root].exclusive {
            place.path.push(Projection::Deref);
        }
        let tokens = self.place_tokens(&place);
        let [from, to] = self.bounds(range, &tokens);
        let numbers = [Some(from), Some(to), rest.map(|at| self.settled_index(at))];
        let numbers = numbers.into_iter().flatten().map(|number| {
            let number = self.define_constant("position", call.method.span(), number);
            Argument::Value(self.constant(number))
        });
        let numbers: Vec<_> = numbers.collect();
        let arguments = std::iter::once(Argument::Exclusive(place)).chain(numbers).collect();
        let function = syn::Ident::new(function, call.method.span());
        let callee = Callee::of_ad(quote_spanned!(call.method.span()=> ::ad::rules::#function));
        Some(self.finish_call(callee, arguments, hint, call.method.span()))
    }

    /// `let (left, right) = slice.split_at_mut(position)` and its kin: two names for parts. Says whether
    /// it is that.
    pub fn split_exclusively(&mut self, pat: &Pat, value: &Expr) -> bool {
        let Pat::Tuple(names) = pat else { return false };
        let (Some(first), Some(second), 2) = (
            names.elems.first().and_then(simple_name),
            names.elems.last().and_then(simple_name),
            names.elems.len(),
        ) else {
            return false;
        };
        let call = match value {
            Expr::MethodCall(call) if call.method == "unwrap" || call.method == "expect" => {
                match &*call.receiver {
                    Expr::MethodCall(inner) if inner.method != "split_at_mut" => inner,
                    _ => return false,
                }
            }
            Expr::MethodCall(call) if call.method == "split_at_mut" => call,
            _ => return false,
        };
        if !["split_at_mut", "split_first_mut", "split_last_mut"]
            .iter()
            .any(|method| call.method == method)
        {
            return false;
        }
        let slice = &self.repeatable(&call.receiver);
        let index = self.names.unwritten("position");
        let arguments: Vec<_> = call.args.iter().collect();
        let (position, parts): (Expr, [Expr; 2]) = match (&*call.method.to_string(), &arguments[..])
        {
            ("split_at_mut", [position]) => (
                parse_quote!(#position),
                [parse_quote!(#slice[..#index]), parse_quote!(#slice[#index..])],
            ),
            ("split_first_mut", []) => (
                parse_quote!(0),
                [parse_quote!(#slice[#index]), parse_quote!(#slice[#index + 1..])],
            ),
            ("split_last_mut", []) => (
                parse_quote!(#slice.len() - 1),
                [parse_quote!(#slice[#index]), parse_quote!(#slice[..#index])],
            ),
            _ => return false,
        };
        let Some(place) = self.active_place(slice) else { return false };
        let place = self.place_tokens(&place);
        self.push_plain(located(quote!(::ad::rt::is_sequence(&#place);), call.method.span()));
        self.statement(&parse_quote!(let #index: usize = #position;));
        for (name, part) in [first, second].into_iter().zip(&parts) {
            self.exclusive_alias(name, part);
        }
        true
    }

    /// `let (a, b) = &mut pair`, `let Pair { ref mut a, .. } = pair`: names for parts of a place. Says
    /// whether it is that.
    pub fn take_apart_exclusively(&mut self, pat: &Pat, value: &Expr) -> bool {
        let mut parts = Vec::new();
        if simple_name(pat).is_some() {
            return false;
        }
        let are_all = match &self.behind_exclusive(value) {
            Some(whole) => self.exclusive_parts(pat, whole, true, &mut parts),
            None => {
                matches!(value, Expr::Path(_) | Expr::Field(_) | Expr::Index(_) | Expr::Unary(_))
                    && self.exclusive_parts(pat, value, false, &mut parts)
            }
        };
        if !are_all || parts.is_empty() {
            return false;
        }
        for (name, part) in &parts {
            self.exclusive_alias(name, part);
        }
        true
    }

    /// The names that a pattern gives to parts of a place that may be changed; says whether it does
    /// nothing else. `is_behind` says that the place is behind a `&mut`.
    fn exclusive_parts(
        &self,
        pat: &Pat,
        place: &Expr,
        is_behind: bool,
        parts: &mut Vec<(syn::Ident, Expr)>,
    ) -> bool {
        let mut numbered = |elements: &mut dyn Iterator<Item = &Pat>, is_index: bool| {
            for (index, element) in elements.enumerate() {
                let index = syn::Index::from(index);
                let part: Expr = match is_index {
                    true => parse_quote!((#place)[#index]),
                    false => parse_quote!((#place).#index),
                };
                if matches!(element, Pat::Rest(_)) {
                    return elements_end(pat);
                }
                if !self.exclusive_parts(element, &part, is_behind, parts) {
                    return false;
                }
            }
            true
        };
        match pat {
            Pat::Wild(_) => true,
            Pat::Paren(inner) => self.exclusive_parts(&inner.pat, place, is_behind, parts),
            Pat::Ident(name) if name.subpat.is_none() => {
                let is_changed = match (&name.by_ref, &name.mutability) {
                    (Some(_), mutability) => mutability.is_some() && !is_behind,
                    (None, mutability) => mutability.is_none() && is_behind,
                };
                parts.push((name.ident.clone(), place.clone()));
                is_changed
            }
            Pat::Tuple(tuple) => numbered(&mut tuple.elems.iter(), false),
            Pat::Slice(slice) => numbered(&mut slice.elems.iter(), true),
            Pat::TupleStruct(pattern) if self.variant(&pattern.path).is_none() => {
                numbered(&mut pattern.elems.iter(), false)
            }
            Pat::Struct(pattern) if self.variant(&pattern.path).is_none() => {
                pattern.fields.iter().all(|field| {
                    let member = &field.member;
                    let part = parse_quote!((#place).#member);
                    self.exclusive_parts(&field.pat, &part, is_behind, parts)
                })
            }
            _ => false,
        }
    }
}

/// Whether `..` ends the pattern: the positions of what stands behind it are not known.
fn elements_end(pat: &Pat) -> bool {
    let last = match pat {
        Pat::Tuple(tuple) => tuple.elems.last(),
        Pat::TupleStruct(pattern) => pattern.elems.last(),
        Pat::Slice(slice) => slice.elems.last(),
        _ => None,
    };
    matches!(last, Some(Pat::Rest(_)))
}
