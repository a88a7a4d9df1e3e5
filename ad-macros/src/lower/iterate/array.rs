//! Arrays and `Vec`s built element by element: `array::from_fn`, `array::map`, `collect`.

use quote::quote;
use syn::spanned::Spanned;
use syn::{
    Expr, ExprCall, ExprMethodCall, GenericArgument, Path, PathArguments, Type, parse_quote,
};

use super::chain::is_chain;
use super::item::Item;
use crate::ir::{Block, Build, BuildSource, Operand, Operation, Place, Statement};
use crate::lower::Lowerer;
use crate::lower::call::callee::is_from_fn;
use crate::lower::iterate::consume;
use crate::lower::rewrite::told::tell_items;
use crate::lower::state::Container;
use crate::lower::syntax;
use crate::lower::syntax::strip_parens;
use crate::types::element;

impl Lowerer<'_> {
    /// `array::from_fn(function)`
    pub fn array_from_fn(&mut self, call: &ExprCall, path: &Path, hint: &str) -> Operand {
        let [function] = &call.args.iter().collect::<Vec<_>>()[..] else {
            return self.refuse(call, "`array::from_fn` takes one function");
        };
        let arguments = quote!(::<u8, 0, fn(usize) -> u8>);
        self.check_function(path, &quote!(::core::array::from_fn), &arguments);
        let ty = match &path.segments.last().expect("a path has a segment").arguments {
            PathArguments::AngleBracketed(arguments) => {
                let arguments: Vec<&GenericArgument> = arguments.args.iter().collect();
                match &arguments[..] {
                    [element, length, ..] => Some(parse_quote!([#element; #length])),
                    _ => None,
                }
            }
            _ => None,
        };
        self.build(function, None, ty, hint)
    }

    /// `array.map(function)`, if `call` is one.
    pub fn mapped(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        if call.method != "map" || call.args.len() != 1 || is_chain(&call.receiver) {
            return None;
        }
        let function = &call.args[0];
        if !matches!(strip_parens(function), Expr::Closure(_) | Expr::Path(_)) {
            return None;
        }
        Some(match self.container(&call.receiver) {
            Some(Container::Array) => {
                let place = self.source_place(&call.receiver, false);
                self.build(function, Some(place), None, hint)
            }
            _ => self.refuse(
                &call.method,
                "what this maps over may be an array, an option or a result: give it a name and a type with `let` before",
            ),
        })
    }

    /// What an expression is known to hold.
    pub fn container(&self, expr: &Expr) -> Option<Container> {
        match strip_parens(expr) {
            Expr::Array(_) | Expr::Repeat(_) => Some(Container::Array),
            Expr::Path(path) => {
                let root = self.variable(path)?;
                self.containers.get(&root).copied()
            }
            Expr::MethodCall(call) => match &*call.method.to_string() {
                "map" | "and_then" | "or_else" => self.container(&call.receiver),
                "ok_or" | "ok_or_else" | "map_err" => Some(Container::Result),
                "ok" | "then" | "then_some" => Some(Container::Option),
                "to_array" | "to_cols_array" => Some(Container::Array),
                _ => None,
            },
            Expr::Call(call) => match strip_parens(&call.func) {
                Expr::Path(path) if is_from_fn(&path.path) => Some(Container::Array),
                Expr::Path(path) if syntax::outcome(&path.path).is_some() => {
                    Some(Container::Result)
                }
                Expr::Path(path) if syntax::is_transparent(&path.path) => Some(Container::Option),
                _ => None,
            },
            _ => None,
        }
    }

    /// An array of what `function` makes of each index, or of each element of `source`.
    fn build(
        &mut self,
        function: &Expr,
        source: Option<Place>,
        ty: Option<Type>,
        hint: &str,
    ) -> Operand {
        let mut index = None;
        let body = self.block(|lowerer| {
            let ident = lowerer.names.fresh("index", function.span());
            let var = *index.insert(lowerer.var(ident, false, false));
            let item = match &source {
                Some(place) => {
                    let ident = lowerer.ident(var);
                    Item::Moved(Self::element(place, quote!(#ident)))
                }
                None => Item::Constant(var),
            };
            lowerer.apply(function, vec![item])
        });
        let like = source.map(|place| self.place_tokens(&place));
        let index = index.expect("set by the block");
        let result = self.built(BuildSource::Index { index, like }, ty, body, hint);
        if let Operand::Var(var) = result {
            self.containers.insert(var, Container::Array);
        }
        result
    }

    /// `.collect::<Vec<_>>()`
    pub(super) fn collected(&mut self, call: &ExprMethodCall, hint: &str) -> Operand {
        let ty = consume::type_argument(call);
        if let Some(ty) = &ty
            && let Some(value) = self.collected_attempts(call, ty, hint)
        {
            return value;
        }
        let is_vec = ty.as_ref().is_none_or(|ty| {
            matches!(ty, Type::Path(path)
                if path.path.segments.last().is_some_and(|last| last.ident == "Vec"))
        });
        if !is_vec {
            return self.refuse(
                &call.method,
                "`collect` is supported into a `Vec`, and an option or a result of one: for anything else write a `for` loop, or `ad::no_diff(|| ..)` around it if no derivative is to flow",
            );
        }
        let mut call = call.clone();
        if let Some(element) = ty.as_ref().and_then(element) {
            tell_items(&mut call.receiver, element);
        }
        let chain = self.or_undone(|lowerer| {
            Some(lowerer.chain(&call.receiver)).filter(|chain| !chain.is_filtered())
        });
        let Some(chain) = chain else {
            return self.pushed(&call, ty, hint);
        };
        let mut source = None;
        let body = self.block(|lowerer| {
            let items = lowerer.items(&chain, None);
            let item = lowerer.staged(items.item, items.stages);
            let (pattern, defines, iterator) = (items.pattern, items.defines, items.iterator);
            source = Some(BuildSource::Items { pattern, defines, iterator });
            lowerer.owned(item, &call)
        });
        self.built(source.expect("set by the block"), ty, body, hint)
    }

    /// `.collect::<Vec<_>>()` of a filtered iterator: one by one.
    fn pushed(&mut self, call: &ExprMethodCall, ty: Option<Type>, hint: &str) -> Operand {
        let hint = if hint == "value" { "collected" } else { hint };
        let ident = self.names.fresh(hint, call.span());
        let var = self.var(ident, true, true);
        let empty = Operation::Use(Operand::Constant(quote!(::std::vec::Vec::new())));
        let ty = ty.or_else(|| Some(parse_quote!(::std::vec::Vec<_>)));
        self.push(Statement::Define { var, ty, operation: empty });
        let [vec, item_name] = ["collected", "item"].map(|name| self.names.unwritten(name));
        self.run_chain(&call.receiver, &mut |lowerer, item, end| {
            let item = Item::Value(lowerer.owned(item, call));
            lowerer.scope(|lowerer| {
                lowerer.alias(&vec, var);
                lowerer.bind_item(&parse_quote!(#item_name), item);
                lowerer.expression_statement(&parse_quote!(#vec.push(#item_name)));
            });
            lowerer.normal_end(Self::unit(), end)
        });
        self.read_place(Place::of(var), hint)
    }

    /// `vec.extend(iterator)`, if `call` is that.
    pub fn extended(&mut self, call: &ExprMethodCall) -> Option<Operand> {
        let [items] = &call.args.iter().collect::<Vec<_>>()[..] else { return None };
        if call.method != "extend" {
            return None;
        }
        // A `Vec` copies what is referred to.
        let elements = match strip_parens(items) {
            Expr::Reference(reference) if reference.mutability.is_none() => Some(&*reference.expr),
            items if self.is_reference(items) && !self.is_exclusive_alias(items) => Some(items),
            _ => None,
        };
        let elements = elements.map(|elements| -> Expr { parse_quote!((#elements).iter()) });
        let items = elements.as_ref().unwrap_or(items);
        if !is_chain(items) {
            return None;
        }
        let (vec, item_name) = (self.repeatable(&call.receiver), self.names.unwritten("item"));
        self.run_chain(items, &mut |lowerer, item, end| {
            let item = Item::Value(match item {
                Item::Reference(alias) => lowerer.read_place(alias.place, "item"),
                item => lowerer.owned(item, call),
            });
            lowerer.scope(|lowerer| {
                lowerer.bind_item(&parse_quote!(#item_name), item);
                lowerer.expression_statement(&parse_quote!(#vec.push(#item_name)));
            });
            lowerer.normal_end(Self::unit(), end)
        });
        Some(Self::unit())
    }

    /// An item that does not refer to a place.
    pub(super) fn owned(&mut self, item: Item, call: &ExprMethodCall) -> Operand {
        if item.refers() {
            return self.refuse(
                &call.method,
                "references to items are not supported here: find positions, by `position(..)` or \
                 `enumerate()`, and use `xs[i]`, or put `.copied()`, `.cloned()`, or, if they are slices, \
                 `.map(|items| items.to_vec())` before it",
            );
        }
        self.item_value(item)
    }

    fn built(&mut self, source: BuildSource, ty: Option<Type>, body: Block, hint: &str) -> Operand {
        let active = matches!(body.value, Operand::Var(_));
        let span = proc_macro2::Span::call_site();
        let ident = self.names.fresh(hint, span);
        let result = self.var(ident, false, active);
        let record = self.names.fresh("tape", span);
        self.push(Statement::Build(Build { result, source, ty, body, record }));
        self.operand_of(result)
    }
}
