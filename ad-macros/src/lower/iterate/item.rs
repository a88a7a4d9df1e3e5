//! The items of an iterator, and the names that patterns give to them.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, ExprClosure, Ident, Pat, Stmt, parse_quote};

use crate::ir::{Operand, Operation, Place, Projection, Shape, VarId};
use crate::lower::Lowerer;
use crate::lower::expression::construct;
use crate::lower::place::pattern::positions;
use crate::lower::rewrite::fields;
use crate::lower::state::Alias;
use crate::lower::syntax;
use crate::lower::syntax::{as_statements, is_plain_name, strip_parens};

impl Alias {
    /// `&place`
    pub fn shared(place: Place) -> Self {
        Self { place, depth: 1, is_exclusive: false }
    }

    /// `&mut place`
    pub fn exclusive(place: Place) -> Self {
        Self { place, depth: 1, is_exclusive: true }
    }

    /// What it refers to.
    fn target(self) -> Item {
        match self.depth {
            1 => Item::Copy(self.place),
            depth => Item::Reference(Self { depth: depth - 1, ..self }),
        }
    }
}

/// What an iterator gives of elements.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// Their values.
    Value,
    /// References.
    Shared,
    /// References by which they may be changed.
    Exclusive,
}

impl Access {
    /// Whether items are references.
    pub fn is_reference(self) -> bool {
        self != Self::Value
    }
}

/// An item of an iterator, in the body of its loop.
#[derive(Clone)]
pub enum Item {
    /// What no derivative flows through.
    Constant(VarId),
    /// `&place`
    Reference(Alias),
    /// A copy of a place.
    Copy(Place),
    /// An element by value, which need not be `Copy`.
    Moved(Place),
    /// `(a, b)`
    Tuple(Vec<Item>),
    /// What a closure returned.
    Value(Operand),
}

impl Item {
    /// Whether it is, or holds, a reference to a place.
    pub fn refers(&self) -> bool {
        match self {
            Self::Reference(_) => true,
            Self::Tuple(items) => items.iter().any(Self::refers),
            Self::Constant(_) | Self::Copy(_) | Self::Moved(_) | Self::Value(_) => false,
        }
    }

    /// A reference to the item.
    pub fn borrowed(self, lowerer: &mut Lowerer<'_>) -> Self {
        match self {
            Self::Reference(alias) => {
                Self::Reference(Alias { depth: alias.depth + 1, is_exclusive: false, ..alias })
            }
            Self::Copy(place) | Self::Moved(place) => Self::Reference(Alias::shared(place)),
            Self::Tuple(items) => {
                Self::Tuple(items.into_iter().map(|item| item.borrowed(lowerer)).collect())
            }
            Self::Constant(root) => Self::Reference(Alias::shared(Place::of(root))),
            Self::Value(value) => {
                let span = proc_macro2::Span::call_site();
                let root = lowerer.named(value, "item", span);
                Self::Reference(Alias::shared(Place::of(root)))
            }
        }
    }
}

impl Lowerer<'_> {
    /// What `*` or a clone makes of an item, or of each of its parts.
    pub(super) fn copied(&mut self, item: Item, clones: bool) -> Item {
        let copy = |place| if clones { Item::Moved(place) } else { Item::Copy(place) };
        let constant = |reference: TokenStream| match clones {
            true => quote!(::core::clone::Clone::clone(#reference)),
            false => quote!((*#reference)),
        };
        match item {
            Item::Reference(alias) => match alias.target() {
                Item::Copy(place) => copy(place),
                target => target,
            },
            Item::Tuple(items) => {
                Item::Tuple(items.into_iter().map(|item| self.copied(item, clones)).collect())
            }
            Item::Value(value) => {
                let tokens = self.tokens(&value);
                match value {
                    Operand::Var(root) => copy(Place { root, path: vec![Projection::Deref] }),
                    Operand::Constant(_) => Item::Value(Operand::Constant(constant(tokens))),
                }
            }
            Item::Constant(var) => {
                let ident = self.ident(var);
                Item::Value(Operand::Constant(constant(quote!(#ident))))
            }
            // Not Rust, which the compiler says of the function.
            Item::Copy(place) | Item::Moved(place) => Item::Copy(place),
        }
    }

    /// The item, evaluated once however often it is used.
    pub(super) fn settled_item(&mut self, item: Item) -> Item {
        match item {
            Item::Value(Operand::Constant(tokens)) => {
                let value = Operation::Use(Operand::Constant(tokens));
                let span = proc_macro2::Span::call_site();
                Item::Constant(self.define("item", span, false, value))
            }
            Item::Tuple(items) => {
                Item::Tuple(items.into_iter().map(|item| self.settled_item(item)).collect())
            }
            item => item,
        }
    }

    /// Lets `pat` name the parts of an item.
    pub fn bind_item(&mut self, pat: &Pat, item: Item) {
        match (pat, item) {
            (Pat::Paren(inner), item) => self.bind_item(&inner.pat, item),
            (Pat::Wild(_), item) => self.discard_item(item),
            (Pat::Type(typed), item @ (Item::Reference(_) | Item::Tuple(_))) => {
                self.bind_item(&typed.pat, item);
            }
            (Pat::Tuple(tuple), Item::Tuple(items))
                if let Some(pats) = spread(&tuple.elems, items.len()) =>
            {
                for (pat, item) in pats.into_iter().zip(items) {
                    match pat {
                        Some(pat) => self.bind_item(pat, item),
                        None => self.discard_item(item),
                    }
                }
            }
            (Pat::Ident(ident), Item::Reference(alias)) if is_plain_name(ident) => {
                let _ = self.alias_place(&ident.ident, alias);
            }
            (Pat::Ident(ident), Item::Constant(var)) if is_plain_name(ident) => {
                self.alias(&ident.ident, var);
            }
            (Pat::Reference(reference), Item::Reference(alias)) => {
                self.bind_item(&reference.pat, alias.target());
            }
            // `&(a, b)` of a borrowed pair.
            (Pat::Reference(reference), Item::Tuple(items)) => {
                let items = items.into_iter().map(|item| self.copied(item, false)).collect();
                self.bind_item(&reference.pat, Item::Tuple(items));
            }
            (Pat::Tuple(tuple), Item::Reference(alias)) => {
                for (pat, position) in tuple.elems.iter().zip(positions(&tuple.elems)) {
                    self.check_position(&position, pat, alias.is_exclusive);
                    self.bind_part(pat, &alias, position);
                }
            }
            (Pat::Slice(slice), Item::Reference(alias)) => {
                self.check_rest(&slice.elems);
                for (index, pat) in slice.elems.iter().enumerate() {
                    let index = syn::Index::from(index);
                    self.bind_part(pat, &alias, Projection::Index(quote!(#index)));
                }
            }
            (Pat::Struct(pattern), Item::Reference(alias)) => {
                for field in &pattern.fields {
                    let step = Projection::Field(field.member.clone());
                    self.bind_part(&field.pat, &alias, step);
                }
            }
            (pat, item) => {
                let value = self.item_value(item);
                let (pat, ty) = syntax::split_type(pat);
                self.bind_pattern(pat, ty, value);
            }
        }
    }

    /// Lets `pat` name the parts of an item in these statements. A tuple whose fields alone they use is taken apart.
    pub fn bind_item_of(&mut self, pat: &Pat, item: Item, stmts: &mut Vec<Stmt>) {
        let parts = self.taken_apart(pat, &item, stmts);
        self.bind_item(parts.as_ref().unwrap_or(pat), item);
    }

    /// A closure of a tuple that is used by its fields alone, as one of the tuple taken apart: fields are what they are
    /// behind a reference, too.
    pub(super) fn by_fields(&mut self, function: &Expr, item: &Item) -> Option<Expr> {
        let Expr::Closure(closure) = strip_parens(function) else { return None };
        let [pat] = &closure.inputs.iter().collect::<Vec<_>>()[..] else { return None };
        let mut stmts = as_statements(&closure.body);
        let parts = self.taken_apart(pat, item, &mut stmts)?;
        let body = parse_quote!({ #(#stmts)* });
        let inputs = [parts].into_iter().collect();
        Some(Expr::Closure(ExprClosure { inputs, body: Box::new(body), ..closure.clone() }))
    }

    fn taken_apart(&mut self, pat: &Pat, item: &Item, stmts: &mut Vec<Stmt>) -> Option<Pat> {
        let (Pat::Ident(whole), Item::Tuple(items)) = (pat, item) else { return None };
        if !is_plain_name(whole) {
            return None;
        }
        let names: Vec<_> = items.iter().map(|_| self.names.unwritten("part")).collect();
        *stmts = fields::named(&whole.ident, &names, stmts)?;
        let parts = names.iter().zip(items).map(|(name, item)| {
            let part = parse_quote!(#name);
            self.taken_apart(&part, item, stmts).unwrap_or(part)
        });
        let parts: Vec<_> = parts.collect();
        Some(parse_quote!((#(#parts),*)))
    }

    fn bind_part(&mut self, pat: &Pat, whole: &Alias, step: Projection) {
        if let Pat::Rest(_) = pat {
            return;
        }
        let place = &whole.place;
        let path = [&place.path[..], &[step]].concat();
        let place = Place { root: place.root, path };
        let part = Alias { place, depth: 1, is_exclusive: whole.is_exclusive };
        self.bind_item(pat, Item::Reference(part));
    }

    /// Lets `name` mean a reference to a place.
    pub fn alias_place(&mut self, name: &Ident, alias: Alias) -> VarId {
        let root = &self.vars[alias.place.root];
        let (mutable, active) = (root.mutable, root.active);
        // Generated code names the place, never the alias.
        let var = self.unwritten_var(name, mutable, active);
        self.aliases.insert(var, alias);
        self.alias(name, var);
        var
    }

    /// An item as a value of its own.
    pub(super) fn item_value(&mut self, item: Item) -> Operand {
        match item {
            Item::Constant(var) => self.constant(var),
            Item::Value(value) => value,
            Item::Copy(place) => self.read_place(place, "item"),
            Item::Moved(place) => self.clone_place(place, None, "item"),
            Item::Reference(Alias { place, .. }) => self.borrow_place(place),
            Item::Tuple(items) => {
                let parts: Vec<_> = items.into_iter().map(|item| self.item_value(item)).collect();
                let tokens = parts.iter().map(|part| self.tokens(part));
                let expression = quote!((#(#tokens,)*));
                if parts.iter().all(|part| matches!(part, Operand::Constant(_))) {
                    return Operand::Constant(expression);
                }
                let parts = construct::numbered(parts);
                let operation = Operation::Aggregate { expression, shape: Shape::Tuple, parts };
                let span = proc_macro2::Span::call_site();
                Operand::Var(self.define("item", span, true, operation))
            }
        }
    }
}

/// The pattern for each of `count` members of a tuple; `None` for what `..` leaves out.
fn spread(
    elements: &syn::punctuated::Punctuated<Pat, syn::Token![,]>,
    count: usize,
) -> Option<Vec<Option<&Pat>>> {
    let rest = elements.iter().position(|element| matches!(element, Pat::Rest(_)));
    let Some(rest) = rest else {
        return (elements.len() == count).then(|| elements.iter().map(Some).collect());
    };
    let left_out = (count + 1).checked_sub(elements.len())?;
    let (before, behind) = (elements.iter().take(rest), elements.iter().skip(rest + 1));
    let left_out = std::iter::repeat_n(None, left_out);
    Some(before.map(Some).chain(left_out).chain(behind.map(Some)).collect())
}
