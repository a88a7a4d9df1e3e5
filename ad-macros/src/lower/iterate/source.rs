//! What an iterator runs over, and the adapters on it.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::spanned::Spanned;
use syn::{Expr, ExprMethodCall};

use super::chain::{
    Chain, Choice, array_length, is_adapter, is_chain, is_source, literal, literal_length, of_one,
};
use super::item::Access;
use crate::ir::{Operand, Operation, Place, Projection, Statement, VarId};
use crate::lower::Lowerer;
use crate::lower::expression::order::{calls_function, may_have_effect};
use crate::lower::state::Container;
use crate::lower::syntax::strip_parens;
use crate::names::located;

impl Lowerer<'_> {
    /// What a `for` loop runs over.
    pub fn chain(&mut self, expr: &Expr) -> Chain {
        match strip_parens(expr) {
            Expr::Range(range) => self.range(range),
            Expr::Reference(reference) => {
                let access = match reference.mutability {
                    Some(_) => Access::Exclusive,
                    None => Access::Shared,
                };
                self.elements(&reference.expr, access)
            }
            Expr::Call(call) if let Some((path, array)) = of_one(call) => {
                let name = &path.segments.last().expect("a path has a segment").ident;
                self.check_function(path, &quote!(::core::iter::#name), &quote!(::<u8>));
                self.chain(&array)
            }
            Expr::MethodCall(call) if is_source(&call.method) => self.source(call),
            Expr::MethodCall(call) if is_adapter(&call.method) && is_chain(expr) => {
                self.adapter(call)
            }
            expr => {
                // What a pattern named in what is referred to is a reference, too.
                let is_named = matches!(expr, Expr::Path(path)
                    if self.variable(path).is_some_and(|var| self.may_refer(var)));
                let access = match self.is_reference(expr) || is_named {
                    true if self.is_exclusive_alias(expr) => Access::Exclusive,
                    true => Access::Shared,
                    false => Access::Value,
                };
                self.elements(expr, access)
            }
        }
    }

    fn range(&mut self, range: &syn::ExprRange) -> Chain {
        let Some(from) = &range.start else {
            self.refuse(range, "the range of a differentiable loop needs a start");
            return Chain::Refused;
        };
        let length = range.end.as_ref().and_then(|to| literal_length(from, to, &range.limits));
        let limits = &range.limits;
        let from = self.in_its_turn(from);
        let to = range.end.as_ref().map(|to| self.in_its_turn(to));
        // A range without end cannot be run backwards.
        let is_range = to.is_some();
        Chain::Constant { iterator: quote!(#from #limits #to), length, is_range }
    }

    fn source(&mut self, call: &ExprMethodCall) -> Chain {
        let (method, receiver) = (&call.method, &call.receiver);
        match (&*method.to_string(), call.args.first()) {
            ("drain", Some(_)) => match self.ranged(call, "drained") {
                Some(Operand::Var(root)) => {
                    let place = Place::of(root);
                    Chain::Elements { place, access: Access::Value, length: None }
                }
                Some(Operand::Constant(iterator)) => {
                    Chain::Constant { iterator, length: None, is_range: false }
                }
                None => {
                    let iterator = self.plain(&Expr::MethodCall(call.clone()));
                    Chain::Constant { iterator, length: None, is_range: false }
                }
            },
            ("iter", None) => self.elements(receiver, Access::Shared),
            ("iter_mut", None) => self.elements(receiver, Access::Exclusive),
            ("into_iter", None) if is_chain(receiver) => self.chain(receiver),
            ("into_iter", None) => match self.chain(strip_parens(receiver)) {
                // An array is no iterator, upon which adapters could be.
                Chain::Constant { iterator, length, is_range: false } => Chain::Constant {
                    iterator: quote!(::core::iter::IntoIterator::into_iter(#iterator)),
                    length,
                    is_range: false,
                },
                chain => chain,
            },
            (
                "windows" | "chunks" | "chunks_mut" | "chunks_exact" | "chunks_exact_mut",
                Some(size),
            ) => {
                let place = self.source_place(receiver, true);
                self.check_sequence(&place, receiver);
                let size = self.fixed(size);
                let whole = self.place_tokens(&place);
                let cut_short = method == "chunks" || method == "chunks_mut";
                let starts = match method == "windows" {
                    true => quote!(::ad::rt::windows(#whole.len(), #size)),
                    false if cut_short => quote!((0..#whole.len()).step_by(#size)),
                    false => quote!(::ad::rt::chunks_exact(#whole.len(), #size)),
                };
                let is_exclusive = method == "chunks_mut" || method == "chunks_exact_mut";
                Chain::Runs { place, iterator: starts, size, cut_short, is_exclusive }
            }
            _ => {
                self.refuse(
                    call,
                    "this is not the standard library's iterator: loop over an index",
                );
                Chain::Refused
            }
        }
    }

    fn elements(&mut self, expr: &Expr, access: Access) -> Chain {
        let by_reference = access.is_reference();
        if let (Expr::Reference(reference), true) = (strip_parens(expr), by_reference) {
            return self.elements(&reference.expr, access);
        }
        let mut is_constant = false;
        let place = self.place_if(expr, |lowerer, place| {
            let root = &lowerer.vars[place.root];
            is_constant = !root.active;
            by_reference || root.active && !root.mutable
        });
        if is_constant && !by_reference {
            return Chain::Constant { iterator: self.plain(expr), length: None, is_range: false };
        }
        let is_option = matches!(self.container(expr), Some(Container::Option | Container::Result));
        if let Some(place) = place {
            if is_option {
                return self.refuse_option(expr);
            }
            self.check_sequence(&place, expr);
            let length = match place.path.is_empty() {
                true => self.lengths.get(&place.root).copied(),
                false => None,
            };
            return Chain::Elements { place, access, length };
        }
        match self.operand(expr, "source") {
            Operand::Constant(iterator) if !by_reference => {
                Chain::Constant { iterator, length: None, is_range: false }
            }
            Operand::Var(_) if is_option => self.refuse_option(expr),
            value => {
                let root = self.source_var(value, expr);
                let place = Place::of(root);
                self.check_sequence(&place, expr);
                Chain::Elements { place, access, length: array_length(expr) }
            }
        }
    }

    /// Has the compiler check that a place holds a list of the standard library, whose elements are run over
    /// by their positions.
    fn check_sequence(&mut self, place: &Place, expr: &Expr) {
        let is_known = self.slices.contains(&place.root) || self.lengths.contains_key(&place.root);
        if place.path.is_empty() && is_known {
            return;
        }
        let whole = self.place_tokens(place);
        self.push_plain(located(quote!(::ad::rt::is_sequence(&#whole);), expr.span()));
    }

    fn refuse_option(&mut self, expr: &Expr) -> Chain {
        self.refuse(
            expr,
            "an option or a result is not run over here: write `if let Some(value) = option { .. }`",
        );
        Chain::Refused
    }

    /// The place whose elements are run over: a copy of it, where the loop may change it.
    pub(super) fn source_place(&mut self, expr: &Expr, by_reference: bool) -> Place {
        let stays =
            |lowerer: &Self, place: &Place| by_reference || !lowerer.vars[place.root].mutable;
        if let Some(place) = self.place_if(expr, stays) {
            return place;
        }
        let value = self.operand(expr, "source");
        Place { root: self.source_var(value, expr), path: Vec::new() }
    }

    /// What has no place of its own, as a variable; of a constant a reference.
    fn source_var(&mut self, value: Operand, expr: &Expr) -> VarId {
        match self.kept(value, expr) {
            Operand::Var(var) => var,
            Operand::Constant(tokens) => {
                self.define_constant("source", expr.span(), quote!(&#tokens))
            }
        }
    }

    /// A number that keeps its value until the reverse sweep.
    fn fixed(&mut self, expr: &Expr) -> TokenStream {
        if let Expr::Lit(literal) = expr {
            return quote!(#literal);
        }
        let tokens = self.plain_constant(expr);
        self.named_tokens("size", expr.span(), tokens)
    }

    /// A number as it is before the rest of an iterator is made.
    fn in_its_turn(&mut self, expr: &Expr) -> TokenStream {
        match may_have_effect(expr) || self.reads_changeable(expr) {
            true => self.fixed(expr),
            false => self.plain_constant(expr),
        }
    }

    fn adapter(&mut self, call: &ExprMethodCall) -> Chain {
        let inner = Box::new(self.chain(&call.receiver));
        let name = call.method.to_string();
        let filtered = inner.is_filtered();
        if matches!(&*name, "zip" | "rev" | "take" | "skip" | "step_by" | "cycle") {
            inner.functions().into_iter().for_each(|function| self.refuse_changes(function));
        }
        match (&*name, call.args.first()) {
            ("copied" | "cloned", None) => Chain::Copied { inner, clones: name == "cloned" },
            ("enumerate", None) if filtered => {
                let counter = self.counter(&call.method);
                Chain::Count(inner, counter)
            }
            ("enumerate", None) => Chain::Enumerate(inner),
            ("zip", Some(other)) if !filtered => {
                let other = self.chain(other);
                if other.is_filtered() {
                    self.refuse(
                        call,
                        "`zip` with a filtered iterator is not supported: write a loop",
                    );
                    return Chain::Refused;
                }
                Chain::Zip(inner, Box::new(other))
            }
            ("map", Some(function)) => Chain::Map(inner, function.clone()),
            ("filter", Some(function)) => Chain::Filter(inner, function.clone()),
            ("filter_map" | "map_while", Some(function)) => {
                let (function, stops) = (function.clone(), name == "map_while");
                Chain::FilterMap { inner, state: None, function, stops }
            }
            ("scan", Some(start)) if call.args.len() == 2 => {
                let start = self.operand(start, "state");
                let state = Some(self.changing("state", start, &call.method));
                Chain::FilterMap { inner, state, function: call.args[1].clone(), stops: true }
            }
            ("flat_map", Some(_)) | ("flatten", None) => {
                let (function, method) = (call.args.first().cloned(), call.method.clone());
                Chain::Flat { inner, function, method }
            }
            ("chain", Some(other)) if !filtered => {
                let other = self.chain(other);
                if other.is_filtered() {
                    self.refuse(
                        call,
                        "`chain` with a filtered iterator is not supported: write two loops",
                    );
                    return Chain::Refused;
                }
                Chain::Chained(inner, Box::new(other))
            }
            ("take_while", Some(function)) => Chain::TakeWhile(inner, function.clone()),
            ("skip_while", Some(function)) => {
                let skips = self.state_of("skips", quote!(true), &call.method);
                Chain::SkipWhile(inner, function.clone(), skips)
            }
            ("rev" | "cycle", None) if !filtered => {
                let repeats = name == "cycle";
                Chain::Order { inner, adapter: call_of(&name, None), limit: None, repeats }
            }
            // The item behind the last one is made before it is clear that it is not asked for.
            ("take", Some(_)) if filtered && is_lent(&call.receiver) => {
                self.refuse(
                    &call.receiver,
                    "one item more would be taken out of this iterator behind a filter: write a `for` loop that is left by `break`",
                );
                Chain::Refused
            }
            ("take", Some(count)) if filtered => self.counted(call, inner, Choice::Take, count),
            ("skip", Some(count)) if filtered || self.may_have_effects(&inner) => {
                self.counted(call, inner, Choice::Skip, count)
            }
            ("step_by", Some(count)) if filtered || self.may_have_effects(&inner) => {
                self.counted(call, inner, Choice::StepBy, count)
            }
            ("take" | "skip" | "step_by", Some(count)) => {
                let limit = match (&*name, literal(count)) {
                    ("take", Some(count)) => Some(count),
                    _ => None,
                };
                let count = self.in_its_turn(count);
                let adapter = call_of(&name, Some(count));
                Chain::Order { inner, adapter, limit, repeats: false }
            }
            ("peekable", None) => {
                self.refuse(&call.method, LOOK_AHEAD);
                Chain::Refused
            }
            _ if filtered => {
                self.refuse(
                    &call.method,
                    format!("`{name}` behind a filter is not supported: put it before, or write a `for` loop with an `if`"),
                );
                Chain::Refused
            }
            _ => {
                self.refuse(
                    &call.method,
                    format!("the iterator adapter `{name}` is not supported: write a `for` loop"),
                );
                Chain::Refused
            }
        }
    }

    /// An adapter that chooses items by their number, after all of them have been made.
    fn counted(
        &mut self,
        call: &ExprMethodCall,
        inner: Box<Chain>,
        choice: Choice,
        count: &Expr,
    ) -> Chain {
        let (count, counter) = (self.fixed(count), self.counter(&call.method));
        Chain::Counted { inner, counter, choice, count }
    }

    /// A variable that counts items.
    fn counter(&mut self, at: &syn::Ident) -> VarId {
        self.state_of("count", quote!(0usize), at)
    }

    /// A variable that an adapter changes from item to item.
    fn state_of(&mut self, name: &str, start: TokenStream, at: &syn::Ident) -> VarId {
        let start = Operation::Use(Operand::Constant(start));
        let ident = self.names.fresh(name, at.span());
        let state = self.var(ident, true, false);
        self.push(Statement::Define { var: state, ty: None, operation: start });
        state
    }

    /// Whether making an item may have an effect: the standard library makes those too that `skip` and
    /// `step_by` drop.
    fn may_have_effects(&self, chain: &Chain) -> bool {
        chain.functions().into_iter().any(|function| {
            match (self.named_closure(function), strip_parens(function)) {
                (Some(closure), _) => calls_function(&closure.body.body),
                (None, Expr::Closure(closure)) => calls_function(&closure.body),
                _ => true,
            }
        })
    }

    /// The place of element `index`.
    pub fn element(place: &Place, index: TokenStream) -> Place {
        let path = [&place.path[..], &[Projection::Index(index)]].concat();
        Place { root: place.root, path }
    }
}

/// What to write instead of `peekable`.
pub(super) const LOOK_AHEAD: &str =
    "an iterator that looks ahead has no derivative: count an index, and look at `xs.get(i + 1)`";

fn call_of(adapter: &str, argument: Option<TokenStream>) -> TokenStream {
    let adapter = format_ident!("{adapter}");
    quote!(.#adapter(#argument))
}

/// Whether an iterator is lent, by `by_ref` or `&mut`, so that what it gives is gone for others.
fn is_lent(chain: &Expr) -> bool {
    match strip_parens(chain) {
        Expr::MethodCall(call) => call.method == "by_ref" || is_lent(&call.receiver),
        Expr::Reference(reference) => reference.mutability.is_some(),
        _ => false,
    }
}
