//! The items of an iterator, and the names that patterns give to them.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Expr, Ident, Member, Pat};

use super::Lowerer;
use super::chain::Chain;
use super::closure::simple_name;
use super::ends::{End, Target};
use crate::ir::{Arm, BranchKind, Operand, Operation, Place, Projection, Shape, Statement, VarId};

/// A name for a reference to a place: reading it reads the place.
#[derive(Clone)]
pub(super) struct Alias {
    pub place: Place,
    /// How many times the place is referred to: 1 for `&place`, 2 for `&&place`.
    pub depth: usize,
}

/// An item of an iterator, in the body of its loop.
#[derive(Clone)]
pub(super) enum Item {
    /// What no derivative flows through.
    Constant(VarId),
    /// `&place`
    Reference(Alias),
    /// A copy of a place.
    Copy(Place),
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
            Self::Constant(_) | Self::Copy(_) | Self::Value(_) => false,
        }
    }

    /// A reference to the item.
    pub fn borrowed(self, lowerer: &mut Lowerer<'_>) -> Self {
        match self {
            Self::Reference(Alias { place, depth }) => {
                Self::Reference(Alias { place, depth: depth + 1 })
            }
            Self::Copy(place) => Self::Reference(Alias { place, depth: 1 }),
            Self::Tuple(items) => {
                Self::Tuple(items.into_iter().map(|item| item.borrowed(lowerer)).collect())
            }
            Self::Constant(root) => {
                Self::Reference(Alias { place: Place { root, path: Vec::new() }, depth: 1 })
            }
            Self::Value(value) => {
                let span = proc_macro2::Span::call_site();
                let root = lowerer.named(value, "item", span);
                Self::Reference(Alias { place: Place { root, path: Vec::new() }, depth: 1 })
            }
        }
    }
}

/// A chain whose items have names.
pub(super) struct Items {
    /// Of what `pattern` takes apart.
    pub iterator: TokenStream,
    /// Whether the iterator is a range, which has to stand in parentheses before an adapter.
    is_range: bool,
    pub pattern: TokenStream,
    pub defines: Vec<VarId>,
    pub item: Item,
    /// What the body does with an item before it is used, first to last.
    pub stages: Vec<Stage>,
}

impl Items {
    fn adapt(&mut self, adapter: &TokenStream) {
        let iterator = &self.iterator;
        self.iterator = match self.is_range {
            true => quote!((#iterator) #adapter),
            false => quote!(#iterator #adapter),
        };
        self.is_range = false;
    }
}

/// A step on the way of an item to its use.
pub(super) enum Stage {
    Map(Expr),
    Copied,
    Filter(Expr),
    TakeWhile(Expr),
    Count(VarId),
}

impl Lowerer<'_> {
    /// Names the items of a chain; to be called inside of the loop's body.
    /// Those that have a name of their own in `pat` keep it.
    pub(super) fn items(&mut self, chain: &Chain, pat: Option<&Pat>) -> Items {
        match chain {
            Chain::Refused => Items {
                iterator: quote!(0..0),
                is_range: true,
                pattern: quote!(_),
                defines: Vec::new(),
                item: Item::Value(Self::unit()),
                stages: Vec::new(),
            },
            Chain::Constant { iterator, .. } => {
                let name = pat.and_then(simple_name).map(Ident::to_string);
                let (var, ident) = self.loop_variable(name.as_deref().unwrap_or("item"));
                let pattern = match pat {
                    Some(Pat::Wild(_)) => quote!(_),
                    _ => ident,
                };
                leaf(iterator.clone(), pattern, Item::Constant(var), var)
            }
            Chain::Elements { place, by_reference, .. } => {
                let (var, ident) = self.loop_variable("index");
                let whole = self.place_tokens(place);
                let element = Self::element(place, quote!(#ident));
                let item = match by_reference {
                    true => Item::Reference(Alias { place: element, depth: 1 }),
                    false => Item::Copy(element),
                };
                leaf(quote!(0..#whole.len()), ident, item, var)
            }
            Chain::Runs { place, iterator, size, cut_short } => {
                let (var, ident) = self.loop_variable("start");
                let whole = self.place_tokens(place);
                let end = match cut_short {
                    true => {
                        let end = quote!((#ident + #size).min(#whole.len()));
                        let end = Operation::Use(Operand::Constant(end));
                        let end = self.define("end", proc_macro2::Span::call_site(), false, end);
                        self.ident(end).to_token_stream()
                    }
                    false => quote!(#ident + #size),
                };
                let run = Self::element(place, quote!(#ident..#end));
                leaf(iterator.clone(), ident, Item::Reference(Alias { place: run, depth: 1 }), var)
            }
            Chain::Enumerate(inner) => {
                let [first, second] = pair_pattern(pat);
                let name = first.and_then(simple_name).map(Ident::to_string);
                let (var, ident) = self.loop_variable(name.as_deref().unwrap_or("position"));
                let mut items = self.items(inner, second);
                let pattern = &items.pattern;
                items.pattern = quote!((#ident, #pattern));
                items.defines.push(var);
                items.adapt(&quote!(.enumerate()));
                let item = self.staged(&mut items);
                Items { item: Item::Tuple(vec![Item::Constant(var), item]), ..items }
            }
            Chain::Zip(left, right) => {
                let [first, second] = pair_pattern(pat);
                let mut left = self.items(left, first);
                let mut right = self.items(right, second);
                let both = vec![self.staged(&mut left), self.staged(&mut right)];
                let (left_pattern, right_pattern) = (&left.pattern, &right.pattern);
                let pattern = quote!((#left_pattern, #right_pattern));
                let right_iterator = &right.iterator;
                left.adapt(&quote!(.zip(#right_iterator)));
                let defines = [left.defines, right.defines].concat();
                Items { pattern, defines, item: Item::Tuple(both), ..left }
            }
            Chain::Order { inner, adapter, .. } => {
                let mut items = self.items(inner, pat);
                items.adapt(adapter);
                items
            }
            Chain::Copied(inner) => self.with_stage(inner, Stage::Copied, None),
            Chain::Map(inner, function) => {
                let pat = parameter(function);
                self.with_stage(inner, Stage::Map(function.clone()), pat)
            }
            Chain::Filter(inner, function) => {
                self.with_stage(inner, Stage::Filter(function.clone()), pat)
            }
            Chain::TakeWhile(inner, function) => {
                self.with_stage(inner, Stage::TakeWhile(function.clone()), pat)
            }
            Chain::Count(inner, counter) => {
                let [_, second] = pair_pattern(pat);
                self.with_stage(inner, Stage::Count(*counter), second)
            }
        }
    }

    fn with_stage(&mut self, inner: &Chain, stage: Stage, pat: Option<&Pat>) -> Items {
        let mut items = self.items(inner, pat);
        items.stages.push(stage);
        items
    }

    fn loop_variable(&mut self, hint: &str) -> (VarId, TokenStream) {
        let ident = self.names.fresh(hint, proc_macro2::Span::call_site());
        let var = self.var(ident.clone(), false, false);
        (var, ident.to_token_stream())
    }

    /// The item behind those of its stages that change no number of items.
    fn staged(&mut self, items: &mut Items) -> Item {
        let mut item = items.item.clone();
        for stage in items.stages.drain(..) {
            item = match stage {
                Stage::Map(function) => Item::Value(self.apply(&function, vec![item])),
                Stage::Copied => self.copied(item),
                _ => unreachable!("what follows a filter has been refused"),
            };
        }
        item
    }

    fn copied(&mut self, item: Item) -> Item {
        match item {
            Item::Reference(Alias { place, depth: 1 }) => Item::Copy(place),
            Item::Reference(Alias { place, depth }) => {
                Item::Reference(Alias { place, depth: depth - 1 })
            }
            Item::Tuple(items) => {
                Item::Tuple(items.into_iter().map(|item| self.copied(item)).collect())
            }
            Item::Value(value) => {
                let tokens = self.tokens(&value);
                match value {
                    Operand::Var(root) => {
                        let place = Place { root, path: vec![Projection::Deref] };
                        Item::Copy(place)
                    }
                    Operand::Constant(_) => Item::Value(Operand::Constant(quote!((*#tokens)))),
                }
            }
            Item::Constant(var) => {
                let ident = self.ident(var);
                Item::Value(Operand::Constant(quote!((*#ident))))
            }
            // Not Rust, which the compiler says of the function.
            Item::Copy(place) => Item::Copy(place),
        }
    }

    /// Runs the stages of an item, then `body`. Where a filter drops the item the block ends.
    pub(super) fn run_stages(
        &mut self,
        item: Item,
        stages: &[Stage],
        own: Target,
        end: &End,
        body: &mut dyn FnMut(&mut Self, Item) -> Operand,
    ) -> Operand {
        let Some((stage, rest)) = stages.split_first() else { return body(self, item) };
        match stage {
            Stage::Map(function) => {
                let value = Item::Value(self.apply(function, vec![item]));
                self.run_stages(value, rest, own, end, body)
            }
            Stage::Copied => {
                let copy = self.copied(item);
                self.run_stages(copy, rest, own, end, body)
            }
            Stage::Count(counter) => {
                let ident = self.ident(*counter).clone();
                let count = Operation::Use(Operand::Constant(quote!(#ident)));
                let position = self.define("position", ident.span(), false, count);
                let code = quote!(#ident += 1;);
                self.push(Statement::Plain { code, defines: Vec::new() });
                let pair = Item::Tuple(vec![Item::Constant(position), item]);
                self.run_stages(pair, rest, own, end, body)
            }
            Stage::Filter(function) | Stage::TakeWhile(function) => {
                // What it looks at and what the body uses is evaluated once.
                let item = self.settled_item(item);
                let shown = item.clone().borrowed(self);
                let condition = self.apply(function, vec![shown]);
                let condition = self.without_derivative(&condition);
                let passes = self.block(|lowerer| lowerer.run_stages(item, rest, own, end, body));
                let stops = matches!(stage, Stage::TakeWhile(_));
                let drops = self.block(|lowerer| match stops {
                    true => lowerer.exit(own, Self::unit(), end),
                    false => lowerer.normal_end(Self::unit(), end),
                });
                let arms = [passes, drops].map(|body| Arm {
                    pattern: TokenStream::new(),
                    guard: None,
                    bindings: Vec::new(),
                    body,
                });
                self.branch(BranchKind::If(condition), arms.into(), true, function.span())
            }
        }
    }

    fn settled_item(&mut self, item: Item) -> Item {
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
    pub(super) fn bind_item(&mut self, pat: &Pat, item: Item) {
        match (pat, item) {
            (Pat::Paren(inner), item) => self.bind_item(&inner.pat, item),
            (Pat::Wild(_), _) => {}
            (Pat::Type(typed), item @ (Item::Reference(_) | Item::Tuple(_))) => {
                self.bind_item(&typed.pat, item);
            }
            (Pat::Tuple(tuple), Item::Tuple(items)) if tuple.elems.len() == items.len() => {
                for (pat, item) in tuple.elems.iter().zip(items) {
                    self.bind_item(pat, item);
                }
            }
            (Pat::Ident(ident), Item::Reference(alias)) if is_plain_name(ident) => {
                self.alias_place(&ident.ident, alias);
            }
            (Pat::Ident(ident), Item::Constant(var)) if is_plain_name(ident) => {
                self.alias(&ident.ident, var);
            }
            (Pat::Reference(reference), Item::Reference(Alias { place, depth })) => {
                let target = match depth {
                    1 => Item::Copy(place),
                    _ => Item::Reference(Alias { place, depth: depth - 1 }),
                };
                self.bind_item(&reference.pat, target);
            }
            // `&(a, b)` of a borrowed pair.
            (Pat::Reference(reference), Item::Tuple(items)) => {
                let items = items.into_iter().map(|item| self.copied(item)).collect();
                self.bind_item(&reference.pat, Item::Tuple(items));
            }
            (Pat::Tuple(tuple), Item::Reference(alias)) => {
                for (index, pat) in tuple.elems.iter().enumerate() {
                    self.bind_part(pat, &alias, Projection::Field(Member::from(index)));
                }
            }
            (Pat::Slice(slice), Item::Reference(alias)) => {
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
                let (pat, ty) = super::flow::split_type(pat);
                self.bind_pattern(pat, ty, value);
            }
        }
    }

    fn bind_part(&mut self, pat: &Pat, whole: &Alias, step: Projection) {
        if let Pat::Rest(_) = pat {
            self.refuse(pat, "`..` is not supported here: name each part, or `_`");
        }
        let place = &whole.place;
        let path = [&place.path[..], &[step]].concat();
        let part = Alias { place: Place { root: place.root, path }, depth: 1 };
        self.bind_item(pat, Item::Reference(part));
    }

    /// Lets `name` mean a reference to a place.
    pub(super) fn alias_place(&mut self, name: &Ident, alias: Alias) {
        let root = &self.vars[alias.place.root];
        let (mutable, active) = (root.mutable, root.active);
        let ident = self.names.fresh(&name.to_string(), name.span());
        let var = self.var(ident, mutable, active);
        self.aliases.insert(var, alias);
        self.alias(name, var);
    }

    /// An item as a value of its own.
    pub(super) fn item_value(&mut self, item: Item) -> Operand {
        match item {
            Item::Constant(var) => Operand::Constant(self.ident(var).to_token_stream()),
            Item::Value(value) => value,
            Item::Copy(place) => self.read_place(place, "item"),
            Item::Reference(Alias { place, .. }) => self.borrow_place(place),
            Item::Tuple(items) => {
                let parts: Vec<_> = items.into_iter().map(|item| self.item_value(item)).collect();
                let tokens = parts.iter().map(|part| self.tokens(part));
                let expression = quote!((#(#tokens,)*));
                if parts.iter().all(|part| matches!(part, Operand::Constant(_))) {
                    return Operand::Constant(expression);
                }
                let parts = super::expression::numbered(parts);
                let operation = Operation::Aggregate { expression, shape: Shape::Tuple, parts };
                let span = proc_macro2::Span::call_site();
                Operand::Var(self.define("item", span, true, operation))
            }
        }
    }
}

/// The patterns of both parts of a pair.
fn pair_pattern(pat: Option<&Pat>) -> [Option<&Pat>; 2] {
    match pat {
        Some(Pat::Tuple(tuple)) if tuple.elems.len() == 2 => {
            [Some(&tuple.elems[0]), Some(&tuple.elems[1])]
        }
        Some(Pat::Paren(inner)) => pair_pattern(Some(&inner.pat)),
        _ => [None, None],
    }
}

/// The pattern of the only parameter of a closure.
fn parameter(function: &Expr) -> Option<&Pat> {
    match function {
        Expr::Closure(closure) if closure.inputs.len() == 1 => closure.inputs.first(),
        _ => None,
    }
}

fn is_plain_name(pat: &syn::PatIdent) -> bool {
    pat.by_ref.is_none() && pat.subpat.is_none() && pat.mutability.is_none()
}

fn leaf(iterator: TokenStream, pattern: TokenStream, item: Item, var: VarId) -> Items {
    let is_range = true;
    Items { iterator, is_range, pattern, defines: vec![var], item, stages: Vec::new() }
}
