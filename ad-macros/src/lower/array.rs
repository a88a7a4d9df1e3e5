//! Arrays built element by element: `array::from_fn` and `array::map`; `Option::map`.

use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{
    Expr, ExprCall, ExprMethodCall, GenericArgument, Path, PathArguments, Type, parse_quote,
};

use super::Lowerer;
use super::chain::is_chain;
use super::flow::strip_parens;
use super::item::Item;
use crate::ir::{Build, Operand, Place, Statement};

/// What the form of an expression tells of its type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Container {
    Array,
    Option,
}

impl Container {
    /// What a type is.
    pub fn of(ty: &Type) -> Option<Self> {
        match ty {
            Type::Array(_) => Some(Self::Array),
            Type::Paren(inner) => Self::of(&inner.elem),
            Type::Path(path) if path.path.segments.last()?.ident == "Option" => Some(Self::Option),
            _ => None,
        }
    }
}

/// `array::from_fn`, however far its path is written out.
pub(super) fn is_from_fn(path: &Path) -> bool {
    let mut segments = path.segments.iter().rev();
    segments.next().is_some_and(|last| last.ident == "from_fn")
        && segments.next().is_some_and(|module| module.ident == "array")
}

impl Lowerer<'_> {
    /// `array::from_fn(function)`
    pub(super) fn array_from_fn(&mut self, call: &ExprCall, path: &Path, hint: &str) -> Operand {
        let [function] = &call.args.iter().collect::<Vec<_>>()[..] else {
            return self.refuse(call, "`array::from_fn` takes one function");
        };
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

    /// `array.map(function)`, `option.map(function)`, if `call` is one.
    pub(super) fn mapped(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
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
            Some(Container::Option) => {
                let (receiver, name) = (&call.receiver, self.names.unwritten("content"));
                let some: Expr = match self.named_closure(function) {
                    Some(_) => parse_quote!(#function(#name)),
                    None => parse_quote!((#function)(#name)),
                };
                self.operand(
                    &parse_quote!(match #receiver {
                        ::core::option::Option::Some(#name) => ::core::option::Option::Some(#some),
                        ::core::option::Option::None => ::core::option::Option::None,
                    }),
                    hint,
                )
            }
            None => self.refuse(
                &call.method,
                "what this maps over may be an array or an option: give it a name and a type with `let` before",
            ),
        })
    }

    /// What an expression is known to hold.
    pub(super) fn container(&self, expr: &Expr) -> Option<Container> {
        match strip_parens(expr) {
            Expr::Array(_) | Expr::Repeat(_) => Some(Container::Array),
            Expr::Path(path) => {
                let root = self.lookup(path.path.get_ident()?)?;
                self.containers.get(&root).copied()
            }
            Expr::MethodCall(call) if call.method == "map" => self.container(&call.receiver),
            Expr::Call(call) => match strip_parens(&call.func) {
                Expr::Path(path) if is_from_fn(&path.path) => Some(Container::Array),
                Expr::Path(path) if super::expression::is_transparent(&path.path) => {
                    Some(Container::Option)
                }
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
                    Item::Copy(Self::element(place, quote!(#ident)))
                }
                None => Item::Constant(var),
            };
            lowerer.apply(function, vec![item])
        });
        let active = matches!(body.value, Operand::Var(_));
        let ident = self.names.fresh(hint, function.span());
        let result = self.var(ident, false, active);
        self.containers.insert(result, Container::Array);
        let record = self.names.fresh("tape", function.span());
        let like = source.map(|place| self.place_tokens(&place));
        let index = index.expect("set by the block");
        self.push(Statement::Build(Build { result, index, like, ty, body, record }));
        match active {
            true => Operand::Var(result),
            false => Operand::Constant(self.ident(result).to_token_stream()),
        }
    }
}
