//! The head of a loop over an iterator, and what happens to an item before it is used.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{Expr, Ident, Pat};

use super::chain::{Chain, Choice};
use super::item::{Access, Item};
use crate::ir::{Arm, BranchKind, Operand, Place, Target, VarId};
use crate::lower::Lowerer;
use crate::lower::flow::ends::End;
use crate::lower::state::Alias;
use crate::lower::syntax::simple_name;

/// What follows for an item.
pub(super) type Rest<'r> = dyn FnMut(&mut Lowerer<'_>, Item) -> Operand + 'r;

/// A chain whose items have names.
pub struct Items {
    /// Of what `pattern` takes apart.
    pub iterator: TokenStream,
    /// Whether the iterator is a range, which has to stand in parentheses before an adapter.
    pub(super) is_range: bool,
    /// How it can be run from its end to its start.
    pub(super) reversal: Reversal,
    pub pattern: TokenStream,
    pub defines: Vec<VarId>,
    pub item: Item,
    /// What the body does with an item before it is used, first to last.
    pub stages: Vec<Stage>,
}

/// How an iterator can be run from its end to its start.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reversal {
    /// Not, or not for sure.
    No,
    /// As it is, for it is a range of integers of some type.
    Plain,
    /// Under adapters too, for it runs over `usize`.
    Exact,
}

impl Items {
    /// Whether the iterator can be run from its end to its start, and is made of integers.
    pub fn is_reversible(&self) -> bool {
        self.reversal != Reversal::No
    }

    pub(super) fn adapt(&mut self, adapter: &TokenStream) {
        let iterator = &self.iterator;
        self.iterator = match self.is_range {
            true => quote!((#iterator) #adapter),
            false => quote!(#iterator #adapter),
        };
        self.is_range = false;
        let keeps = match adapter.to_string().trim_start_matches(['.', ' ']) {
            adapter if adapter.starts_with("rev") => true,
            adapter if ["take", "skip", "step_by"].iter().any(|name| adapter.starts_with(name)) => {
                self.reversal == Reversal::Exact
            }
            _ => false,
        };
        if !keeps {
            self.reversal = Reversal::No;
        }
    }
}

/// A step on the way of an item to its use.
pub enum Stage {
    Map(Expr),
    Copied {
        clones: bool,
    },
    FilterMap {
        state: Option<VarId>,
        function: Expr,
        stops: bool,
    },
    Flat {
        function: Option<Expr>,
        method: Ident,
    },
    Filter(Expr),
    TakeWhile(Expr),
    SkipWhile {
        function: Expr,
        skips: VarId,
    },
    Count(VarId),
    /// Lets items pass by their number.
    Choose {
        counter: VarId,
        choice: Choice,
        count: TokenStream,
    },
    /// Ends the loop once enough items have passed.
    Limit {
        counter: VarId,
        count: TokenStream,
    },
}

impl Lowerer<'_> {
    /// Names the items of a chain; to be called inside of the loop's body.
    /// Those that have a name of their own in `pat` keep it.
    pub fn items(&mut self, chain: &Chain, pat: Option<&Pat>) -> Items {
        let mut lengths = Vec::new();
        if self.is_direct(chain, &mut lengths) {
            let name = position_name(chain, pat);
            let (var, ident) = self.loop_variable(name.as_deref().unwrap_or("index"));
            let lengths = lengths.into_iter().reduce(|all, next| quote!(#all.min(#next)));
            let (item, stages) = self.item_at(chain, var);
            return Items { stages, ..leaf(quote!(0..#lengths), ident, item, var) };
        }
        match chain {
            Chain::Elements { .. } => unreachable!("elements are direct"),
            Chain::Refused => Items {
                iterator: quote!(0..0),
                is_range: true,
                reversal: Reversal::No,
                pattern: quote!(_),
                defines: Vec::new(),
                item: Item::Value(Self::unit()),
                stages: Vec::new(),
            },
            Chain::Constant { iterator, is_range, .. } => {
                let name = pat.and_then(simple_name).map(Ident::to_string);
                let (var, ident) = self.loop_variable(name.as_deref().unwrap_or("item"));
                self.parts_of.insert(var, iterator.clone());
                let pattern = match pat {
                    Some(Pat::Wild(_)) => quote!(_),
                    _ => ident,
                };
                let reversal = if *is_range { Reversal::Plain } else { Reversal::No };
                let items = leaf(iterator.clone(), pattern, Item::Constant(var), var);
                Items { reversal, ..items }
            }
            Chain::Runs { place, iterator, size, cut_short, is_exclusive } => {
                let (var, ident) = self.loop_variable("start");
                let whole = self.place_tokens(place);
                let end = match cut_short {
                    true => {
                        let end = quote!((#ident + #size).min(#whole.len()));
                        self.named_tokens("end", proc_macro2::Span::call_site(), end)
                    }
                    false => quote!(#ident + #size),
                };
                let run = Self::element(place, quote!(#ident..#end));
                let run = Alias { place: run, depth: 1, is_exclusive: *is_exclusive };
                leaf(iterator.clone(), ident, Item::Reference(run), var)
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
                let item = self.staged(items.item.clone(), std::mem::take(&mut items.stages));
                Items { item: Item::Tuple(vec![Item::Constant(var), item]), ..items }
            }
            Chain::Zip(left, right) => {
                let [first, second] = pair_pattern(pat);
                let mut left = self.items(left, first);
                let mut right = self.items(right, second);
                let both = [&mut left, &mut right].map(|items| {
                    self.staged(items.item.clone(), std::mem::take(&mut items.stages))
                });
                let (left_pattern, right_pattern) = (&left.pattern, &right.pattern);
                let pattern = quote!((#left_pattern, #right_pattern));
                let right_iterator = &right.iterator;
                left.adapt(&quote!(.zip(#right_iterator)));
                let defines = [left.defines, right.defines].concat();
                Items { pattern, defines, item: Item::Tuple(both.into()), ..left }
            }
            Chain::Order { inner, adapter, .. } => {
                let mut items = self.items(inner, pat);
                items.adapt(adapter);
                items
            }
            Chain::Copied { inner, clones } => {
                self.with_stage(inner, Stage::Copied { clones: *clones }, None)
            }
            Chain::Map(inner, function) => {
                let pat = parameter(function);
                self.with_stage(inner, Stage::Map(function.clone()), pat)
            }
            Chain::Chained(left, right) => self.chained(left, right, pat),
            Chain::FilterMap { inner, state, function, stops } => {
                let (function_there, state, stops) = (function.clone(), *state, *stops);
                let stage = Stage::FilterMap { state, function: function_there, stops };
                self.with_stage(inner, stage, parameter(function))
            }
            Chain::Flat { inner, function, method } => {
                let pat = function.as_ref().and_then(parameter);
                let (function, method) = (function.clone(), method.clone());
                self.with_stage(inner, Stage::Flat { function, method }, pat)
            }
            Chain::Filter(inner, function) => {
                self.with_stage(inner, Stage::Filter(function.clone()), pat)
            }
            Chain::TakeWhile(inner, function) => {
                self.with_stage(inner, Stage::TakeWhile(function.clone()), pat)
            }
            Chain::SkipWhile(inner, function, skips) => {
                let stage = Stage::SkipWhile { function: function.clone(), skips: *skips };
                self.with_stage(inner, stage, pat)
            }
            Chain::Counted { inner, counter, choice, count } => {
                let (counter, choice, count) = (*counter, *choice, count.clone());
                let mut items = self.items(inner, pat);
                if choice == Choice::Take {
                    items.stages.insert(0, Stage::Limit { counter, count: count.clone() });
                }
                items.stages.push(Stage::Choose { counter, choice, count });
                items
            }
            Chain::Count(inner, counter) => {
                let [_, second] = pair_pattern(pat);
                self.with_stage(inner, Stage::Count(*counter), second)
            }
        }
    }

    /// Whether each item is made of elements at one position; gathers the lengths of their places.
    fn is_direct(&self, chain: &Chain, lengths: &mut Vec<TokenStream>) -> bool {
        match chain {
            Chain::Elements { place, .. } => {
                let whole = self.place_tokens(place);
                lengths.push(quote!(#whole.len()));
                true
            }
            Chain::Enumerate(inner) | Chain::Copied { inner, .. } | Chain::Map(inner, _) => {
                self.is_direct(inner, lengths)
            }
            Chain::Zip(left, right) => {
                self.is_direct(left, lengths) && self.is_direct(right, lengths)
            }
            _ => false,
        }
    }

    /// The item of a direct chain at the position that `index` holds.
    fn item_at(&mut self, chain: &Chain, index: VarId) -> (Item, Vec<Stage>) {
        match chain {
            Chain::Elements { place, access, .. } => {
                let ident = self.ident(index);
                let element = Self::element(place, quote!(#ident));
                let item = match access {
                    Access::Value => Item::Moved(element),
                    Access::Shared => Item::Reference(Alias::shared(element)),
                    Access::Exclusive => Item::Reference(Alias::exclusive(element)),
                };
                (item, Vec::new())
            }
            Chain::Enumerate(inner) => {
                let (item, stages) = self.item_at(inner, index);
                let item = self.staged(item, stages);
                (Item::Tuple(vec![Item::Constant(index), item]), Vec::new())
            }
            Chain::Zip(left, right) => {
                let both = [left, right].map(|chain| {
                    let (item, stages) = self.item_at(chain, index);
                    self.staged(item, stages)
                });
                (Item::Tuple(both.into()), Vec::new())
            }
            Chain::Copied { inner, clones } => {
                self.item_before(inner, index, Stage::Copied { clones: *clones })
            }
            Chain::Map(inner, function) => {
                self.item_before(inner, index, Stage::Map(function.clone()))
            }
            _ => unreachable!("the chain is direct"),
        }
    }

    fn item_before(&mut self, inner: &Chain, index: VarId, stage: Stage) -> (Item, Vec<Stage>) {
        let (item, mut stages) = self.item_at(inner, index);
        stages.push(stage);
        (item, stages)
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
    pub(super) fn staged(&mut self, item: Item, stages: Vec<Stage>) -> Item {
        let mut item = item;
        for stage in stages {
            item = match stage {
                Stage::Map(function) => Item::Value(self.apply(&function, vec![item])),
                Stage::Copied { clones } => self.copied(item, clones),
                _ => unreachable!("what follows a filter has been refused"),
            };
        }
        item
    }

    /// Runs the stages of an item, then `body`. Where a filter drops the item the block ends.
    pub fn run_stages(
        &mut self,
        item: Item,
        stages: &[Stage],
        own: Target,
        end: &End,
        body: &mut Rest<'_>,
    ) -> Operand {
        let Some((stage, rest)) = stages.split_first() else { return body(self, item) };
        match stage {
            Stage::Map(function) => {
                let value = Item::Value(self.apply(function, vec![item]));
                self.run_stages(value, rest, own, end, body)
            }
            Stage::Copied { clones } => {
                let copy = self.copied(item, *clones);
                self.run_stages(copy, rest, own, end, body)
            }
            Stage::Choose { counter, choice, count } => {
                let position = self.counted_on(*counter);
                let position = self.ident(position);
                let condition = match choice {
                    Choice::Skip => quote!(#position >= #count),
                    Choice::StepBy => quote!(#position % #count == 0),
                    Choice::Take => return self.run_stages(item, rest, own, end, body),
                };
                self.run_if(condition, false, own, end, &mut |lowerer| {
                    lowerer.run_stages(item.clone(), rest, own, end, body)
                })
            }
            Stage::Limit { counter, count } => {
                let counter = self.ident(*counter);
                let condition = quote!(#counter < #count);
                self.run_if(condition, true, own, end, &mut |lowerer| {
                    lowerer.run_stages(item.clone(), rest, own, end, body)
                })
            }
            Stage::Count(counter) => {
                let position = self.counted_on(*counter);
                let pair = Item::Tuple(vec![Item::Constant(position), item]);
                self.run_stages(pair, rest, own, end, body)
            }
            Stage::FilterMap { state, function, stops } => {
                let state = state.map(|root| Item::Reference(Alias::exclusive(Place::of(root))));
                let content = self.apply(function, state.into_iter().chain([item]).collect());
                let mut rest = |lowerer: &mut Lowerer<'_>, item: Item| {
                    lowerer.run_stages(item, rest, own, end, body)
                };
                self.run_some(content, *stops, own, end, &mut rest)
            }
            Stage::Flat { function, method } => {
                let mut rest = |lowerer: &mut Lowerer<'_>, item: Item| {
                    lowerer.run_stages(item, rest, own, end, body)
                };
                self.run_flat(item, function.as_ref(), method, end, &mut rest)
            }
            Stage::SkipWhile { function, skips } => {
                let item = self.settled_item(item);
                let skips = self.ident(*skips).clone();
                let tests =
                    self.block(|lowerer| Operand::Constant(lowerer.predicate(function, &item)));
                let passes = self.block(|_| Operand::Constant(quote!(false)));
                let arms = [tests, passes].map(Arm::plain).into();
                let kind = BranchKind::If(quote!(#skips));
                let skipped = self.branch(kind, arms, true, skips.span());
                let skipped = self.without_derivative(&skipped);
                self.push_plain(quote!(#skips = #skipped;));
                self.run_if(quote!(!#skips), false, own, end, &mut |lowerer| {
                    lowerer.run_stages(item.clone(), rest, own, end, body)
                })
            }
            Stage::Filter(function) | Stage::TakeWhile(function) => {
                // What it looks at and what the body uses is evaluated once.
                let item = self.settled_item(item);
                let condition = self.predicate(function, &item);
                let stops = matches!(stage, Stage::TakeWhile(_));
                self.run_if(condition, stops, own, end, &mut |lowerer| {
                    lowerer.run_stages(item.clone(), rest, own, end, body)
                })
            }
        }
    }

    /// What a predicate says of an item.
    fn predicate(&mut self, function: &Expr, item: &Item) -> TokenStream {
        let condition = match self.by_fields(function, item) {
            Some(by_fields) => self.apply(&by_fields, vec![item.clone()]),
            None => {
                let shown = item.clone().borrowed(self);
                self.apply(function, vec![shown])
            }
        };
        self.without_derivative(&condition)
    }

    /// Goes on with an item if a condition holds; else the item is dropped, or the loop ends.
    fn run_if(
        &mut self,
        condition: TokenStream,
        stops: bool,
        own: Target,
        end: &End,
        passes: &mut dyn FnMut(&mut Self) -> Operand,
    ) -> Operand {
        let passes = self.block(passes);
        let drops = self.block(|lowerer| match stops {
            true => lowerer.exit(own, Self::unit(), end),
            false => lowerer.normal_end(Self::unit(), end),
        });
        let arms = [passes, drops].map(Arm::plain);
        self.branch(BranchKind::If(condition), arms.into(), true, Span::call_site())
    }

    /// The number of an item, which is counted.
    fn counted_on(&mut self, counter: VarId) -> VarId {
        let ident = self.ident(counter).clone();
        let position = self.define_constant("position", ident.span(), quote!(#ident));
        self.push_plain(quote!(#ident += 1;));
        position
    }
}

/// The name that a pattern gives to the position of an item.
fn position_name(chain: &Chain, pat: Option<&Pat>) -> Option<String> {
    match chain {
        Chain::Enumerate(inner) => {
            let [first, second] = pair_pattern(pat);
            let name = first.and_then(simple_name).map(Ident::to_string);
            name.or_else(|| position_name(inner, second))
        }
        Chain::Zip(left, right) => {
            let [first, second] = pair_pattern(pat);
            position_name(left, first).or_else(|| position_name(right, second))
        }
        Chain::Copied { inner, .. } => position_name(inner, pat),
        Chain::Map(inner, function) => position_name(inner, parameter(function)),
        _ => None,
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

fn leaf(iterator: TokenStream, pattern: TokenStream, item: Item, var: VarId) -> Items {
    let (is_range, reversal) = (true, Reversal::Exact);
    Items { iterator, is_range, reversal, pattern, defines: vec![var], item, stages: Vec::new() }
}
