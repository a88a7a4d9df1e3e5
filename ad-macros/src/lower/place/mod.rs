//! Places: variables and parts of them, to read, to borrow, to assign to.

pub mod apart;
pub mod element;
pub mod indexed;
pub mod part;
pub mod pattern;
pub mod slice_pattern;

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprAssign, ExprBinary, Lit, UnOp, parse_quote};

use super::Lowerer;
use super::call::callee::is_associated;
use super::expression::order::may_have_effect;
use super::rewrite::exits;
use super::state::Alias;
use super::syntax::{self, calls, is_type_name, makes_value, root_name, simple_path, strip_parens};
use crate::ir::primal::Primal;
use crate::ir::{
    Argument, BinaryOperator, Operand, Operation, Place, Projection, Statement, VarId,
};
use crate::lower::rewrite::desugar;
use crate::{floats, names, rules};

impl Lowerer<'_> {
    /// The place that an expression names or refers to, if it is one of a local variable.
    pub(super) fn place(&mut self, expr: &Expr) -> Option<Place> {
        self.located(expr).map(|(place, _)| place)
    }

    /// The place that an expression names, and how many times the expression refers to it: 0 for
    /// the place itself.
    fn located(&mut self, expr: &Expr) -> Option<(Place, usize)> {
        match expr {
            Expr::Paren(inner) => self.located(&inner.expr),
            Expr::Path(path) => {
                let root = self.variable(path)?;
                Some(match self.aliases.get(&root) {
                    Some(alias) => (alias.place.clone(), alias.depth),
                    None => (Place::of(root), 0),
                })
            }
            Expr::Field(field) => {
                let mut place = self.whole(&field.base)?;
                place.path.push(Projection::Field(field.member.clone()));
                Some((place, 0))
            }
            Expr::Index(index) if indexed::is_element(index) => None,
            Expr::Index(index) => {
                let mut place = self.whole(&index.expr)?;
                let whole = self.place_tokens(&place);
                let position = self.index(&index.index, &whole);
                place.path.push(Projection::Index(position));
                Some((place, 0))
            }
            call @ Expr::MethodCall(_) if self.is_lent_element(call) => {
                self.lent_element(call).map(|place| (place, 1))
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                let (mut place, depth) = self.located(&unary.expr)?;
                if depth > 0 {
                    return Some((place, depth - 1));
                }
                place.path.push(Projection::Deref);
                Some((place, 0))
            }
            _ => None,
        }
    }

    /// The place of which a part is named: also what an option lends, of which only a part can be copied.
    fn whole(&mut self, expr: &Expr) -> Option<Place> {
        let place = self.place(expr).or_else(|| self.shared_element(expr));
        if place.is_some() || !is_lent_content(expr) {
            return place;
        }
        match self.operand(expr, "content") {
            Operand::Var(root) => Some(Place::of(root)),
            Operand::Constant(_) => None,
        }
    }

    /// A place, with names for the indices that are computed by calls or read what may change: it is written
    /// more than once, and behind what is evaluated after it.
    pub(super) fn repeatable(&mut self, place: &Expr) -> Expr {
        let mut place = place.clone();
        let mut way = &mut place;
        let mut indices = Vec::new();
        loop {
            way = match way {
                Expr::Paren(inner) => &mut inner.expr,
                Expr::Field(field) => &mut field.base,
                Expr::Unary(unary) => &mut unary.expr,
                Expr::Index(index) => {
                    match &mut *index.index {
                        Expr::Range(range) => indices.extend(
                            [&mut range.end, &mut range.start]
                                .into_iter()
                                .flatten()
                                .map(|end| &mut **end),
                        ),
                        position => indices.push(position),
                    }
                    &mut index.expr
                }
                _ => break,
            };
        }
        for index in indices.into_iter().rev() {
            // A call tells no type, and may give anything.
            let ty = calls(index).then(|| quote!(: usize));
            if ty.is_some() || self.reads_changeable(index) {
                let name = self.names.unwritten("position");
                let position = std::mem::replace(index, parse_quote!(#name));
                self.statement(&parse_quote!(let #name #ty = #position;));
            }
        }
        place
    }

    /// How many times a name, or what `*` leaves of it, refers to a place.
    pub(super) fn depth(&self, expr: &Expr) -> usize {
        match expr {
            Expr::Paren(inner) => self.depth(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                self.depth(&unary.expr).saturating_sub(1)
            }
            Expr::Path(path) => {
                let root = self.variable(path);
                let alias = root.and_then(|root| self.aliases.get(&root));
                alias.map_or(0, |alias| alias.depth)
            }
            call => usize::from(self.is_lent_element(call)),
        }
    }

    /// Whether an expression is known to be a reference.
    pub(super) fn is_reference(&self, expr: &Expr) -> bool {
        let known = |path: &syn::ExprPath| {
            let root = self.variable(path);
            root.is_some_and(|root| self.references.contains(&root))
        };
        self.depth(expr) > 0 || matches!(strip_parens(expr), Expr::Path(path) if known(path))
    }

    /// `let name = &mut place;`
    pub(super) fn exclusive_alias(&mut self, name: &syn::Ident, target: &Expr) {
        if let Some(place) = self.target(target) {
            self.alias_place(name, Alias::exclusive(place));
        }
    }

    /// `let name = &place;`: while the name is used, nothing can change the place. Says whether it is
    /// a place of which a part may be named.
    pub(super) fn shared_alias(&mut self, name: &syn::Ident, target: &Expr) -> bool {
        if self.depth(target) > 0 || self.is_reference(target) {
            return false;
        }
        let Some(place) = self.active_place(target) else { return false };
        if self.vars[place.root].is_function {
            return false;
        }
        self.alias_place(name, Alias::shared(place));
        true
    }

    /// Whether an expression is a `&mut` to a place.
    pub(super) fn is_exclusive_alias(&self, expr: &Expr) -> bool {
        self.is_lent_element(expr)
            || simple_path(expr)
                .and_then(|name| self.lookup(name))
                .is_some_and(|var| self.is_lent(var))
    }

    /// What a `&mut` to a place, or a parameter that is one, refers to.
    pub(super) fn behind_exclusive(&self, reference: &Expr) -> Option<Expr> {
        let is_parameter = |name| self.lookup(name).is_some_and(|var| self.vars[var].exclusive);
        match reference {
            Expr::Reference(reference) => {
                reference.mutability.is_some().then(|| (*reference.expr).clone())
            }
            _ => (self.is_exclusive_alias(reference)
                || simple_path(reference).is_some_and(is_parameter))
            .then(|| parse_quote!(*#reference)),
        }
    }

    /// Whether a variable is a name for a `&mut`.
    pub(super) fn is_lent(&self, var: VarId) -> bool {
        self.aliases.get(&var).is_some_and(|alias| alias.is_exclusive)
    }

    /// The value of an operand of an operator: what a reference refers to.
    pub(super) fn scalar(&mut self, expr: &Expr, hint: &str) -> Operand {
        if !self.is_reference(expr) {
            return self.operand(expr, hint);
        }
        let depth = self.depth(expr);
        let mut place = self.place(expr).expect("a reference to a place");
        if depth == 0 {
            place.path.push(Projection::Deref);
        }
        match simple_path(expr) {
            Some(name) if hint == "value" => self.read_place(place, &name.to_string()),
            _ => self.read_place(place, hint),
        }
    }

    /// A copy of a place.
    pub(super) fn read_place(&mut self, place: Place, hint: &str) -> Operand {
        let root = &self.vars[place.root];
        let span = root.ident.span();
        if !root.active {
            let mutable = root.mutable;
            let tokens = Operand::Constant(self.place_tokens(&place));
            if !mutable {
                return tokens;
            }
            let var = self.define("constant", span, false, Operation::Use(tokens));
            return self.constant(var);
        }
        if place.path.is_empty() && !root.mutable {
            return Operand::Var(place.root);
        }
        Operand::Var(self.define(hint, span, true, Operation::Read(place)))
    }

    /// The value of an element that moves out of its place: a clone, for the place is named again.
    pub(super) fn clone_place(&mut self, place: Place, kind: Option<VarId>, hint: &str) -> Operand {
        let (span, active) = (self.ident(place.root).span(), self.vars[place.root].active);
        let value = self.define(hint, span, active, Operation::Clone(place, kind));
        self.operand_of(value)
    }

    /// A reference to a place.
    pub(super) fn borrow_place(&mut self, place: Place) -> Operand {
        let root = &self.vars[place.root];
        let span = root.ident.span();
        if !root.active {
            let tokens = self.place_tokens(&place);
            return Operand::Constant(quote!((&#tokens)));
        }
        let var = self.define("reference", span, true, Operation::Borrow(place));
        self.references.insert(var);
        Operand::Var(var)
    }

    /// A place with a derivative.
    pub(super) fn active_place(&mut self, expr: &Expr) -> Option<Place> {
        self.place_if(expr, |lowerer, place| lowerer.vars[place.root].active)
    }

    /// The place that an expression names, if it is one to use: if not, its indices are evaluated
    /// elsewhere.
    pub(super) fn place_if(
        &mut self,
        expr: &Expr,
        is_wanted: impl FnOnce(&Self, &Place) -> bool,
    ) -> Option<Place> {
        self.or_undone(|lowerer| lowerer.place(expr).filter(|place| is_wanted(lowerer, place)))
    }

    /// The receiver of a method. Where it is a place that may be assigned to, the method is called
    /// on the place itself, which a method that takes `&mut self` changes.
    pub(super) fn receiver(&mut self, call: &syn::ExprMethodCall) -> Argument {
        let is_lent = |lowerer: &Self, place: &Place| !lowerer.is_copied(place, call);
        let Some(place) = self.place_if(&call.receiver, is_lent) else {
            let receiver = self.scalar(&call.receiver, "receiver");
            let is_active = matches!(receiver, Operand::Var(_));
            let method = call.method.to_string();
            let may_change = rules::changes_receiver(&method)
                || makes_own(&call.receiver) && !rules::is_method(&method);
            if is_active && may_change {
                let span = call.receiver.span();
                return Argument::Receiver(self.changeable(receiver, "receiver", span));
            }
            return Argument::Value(self.kept(receiver, &call.receiver));
        };
        if !self.vars[place.root].active && !self.vars[place.root].mutable {
            return Argument::Value(Operand::Constant(self.place_tokens(&place)));
        }
        match self.called_on.contains(&place.root) {
            true => Argument::Borrow(place),
            false => Argument::Receiver(place),
        }
    }

    /// Whether the method is certainly called on a copy of the place. Where an argument changes a
    /// variable it must be, since a reference would not have compiled.
    fn is_copied(&self, place: &Place, call: &syn::ExprMethodCall) -> bool {
        self.vars[place.root].mutable
            && (floats::takes_number(&call.method.to_string()) && !self.own.contains(&place.root)
                || call.args.iter().any(|argument| {
                    exits::changed_places(argument)
                        .into_iter()
                        .filter(|changed| !syntax::are_other_fields(changed, &call.receiver))
                        .any(|changed| self.may_belong_to(changed, place.root, argument))
                }))
    }

    /// Whether a place that an expression changes may be a part of a variable.
    fn may_belong_to(&self, part: &Expr, root: VarId, within: &Expr) -> bool {
        if makes_value(part) {
            return false;
        }
        match self.root_of(part) {
            Some(of_part) => of_part == root,
            // A name of the expression's own.
            None => {
                self.mentions(within, |path| self.root_of(&Expr::Path(path.clone())) == Some(root))
            }
        }
    }

    /// The variable in which a place is, whatever names lead to it.
    pub(super) fn root_of(&self, place: &Expr) -> Option<VarId> {
        let var = self.lookup(root_name(place)?)?;
        Some(self.aliases.get(&var).map_or(var, |alias| alias.place.root))
    }

    /// An index into `whole`, or a range of them, that keeps its value until the reverse sweep.
    pub(super) fn index(&mut self, expr: &Expr, whole: &TokenStream) -> TokenStream {
        let Expr::Range(range) = expr else {
            return self.settled_index(expr);
        };
        let from = range.start.as_ref().map_or_else(|| quote!(0), |from| self.settled_index(from));
        let limits = &range.limits;
        let to = match &range.end {
            Some(to) => self.settled_index(to),
            // The cotangent may be shorter than what is indexed, so it cannot tell the end.
            None => self.named_tokens("len", range.span(), quote!(#whole.len())),
        };
        quote!(#from #limits #to)
    }

    /// The position of the first element in a range of `whole`, and that behind the last.
    pub(super) fn bounds(
        &mut self,
        range: &syn::ExprRange,
        whole: &TokenStream,
    ) -> [TokenStream; 2] {
        let from = range.start.as_ref().map_or_else(|| quote!(0), |from| self.settled_index(from));
        let to = match (&range.end, &range.limits) {
            (Some(to), syn::RangeLimits::HalfOpen(_)) => self.settled_index(to),
            (Some(to), syn::RangeLimits::Closed(_)) => {
                let to = self.settled_index(to);
                quote!(#to + 1)
            }
            (None, _) => quote!(#whole.len()),
        };
        [from, to]
    }

    pub(super) fn settled_index(&mut self, expr: &Expr) -> TokenStream {
        if let Expr::Lit(literal) = expr
            && let Lit::Int(number) = &literal.lit
        {
            return quote!(#number);
        }
        // What a key is made of lives as long as the key.
        if let Expr::Reference(key) = expr
            && key.mutability.is_none()
            && makes_value(&key.expr)
        {
            let key = self.settled_index(&key.expr);
            return quote!(&#key);
        }
        let index = self.plain_constant(expr);
        self.named_tokens("index", expr.span(), index)
    }

    pub(super) fn place_tokens(&self, place: &Place) -> TokenStream {
        Primal(&self.vars).place(place)
    }

    /// The place that is assigned to.
    pub(super) fn target(&mut self, expr: &Expr) -> Option<Place> {
        if self.depth(expr) > 0 {
            self.refuse(
                expr,
                "a name for an element cannot be given to another one: assign to `*name`",
            );
            return None;
        }
        let Some(place) = self.place(expr) else {
            self.refuse(expr, not_a_place(expr));
            return None;
        };
        self.can_be_assigned(expr, &place).then_some(place)
    }

    /// Whether a place that an expression names can be assigned to; refuses it if not.
    pub(super) fn can_be_assigned(&mut self, expr: &Expr, place: &Place) -> bool {
        // Behind a variable that may be assigned to is a box, which owns its content.
        let is_reference = !self.vars[place.root].mutable;
        if is_reference && place.path.iter().any(|step| matches!(step, Projection::Deref)) {
            self.refuse(
                expr,
                "assignment through a reference is not supported: assign to a variable",
            );
            return false;
        }
        true
    }

    /// `place = value`
    pub(super) fn assign(&mut self, assign: &ExprAssign) {
        if let Expr::Infer(_) = &*assign.left {
            let value = self.operand(&assign.right, "value");
            return self.discard(value);
        }
        if let Some(desugared) = desugar::assignment(assign, self.names) {
            return self.scope(|lowerer| {
                desugared.iter().for_each(|statement| lowerer.statement(statement));
            });
        }
        if let Expr::Index(index) = strip_parens(&assign.left)
            && indexed::is_element(index)
        {
            let call = indexed::replaced(index, &assign.right);
            return self.expression_statement(&parse_quote!(#call));
        }
        let value = self.operand(&assign.right, "value");
        let value = self.in_turn(value, &assign.right, [&*assign.left]);
        let Some(place) = self.target(&assign.left) else { return };
        if self.vars[place.root].active {
            self.push(Statement::Assign { place, value });
        } else {
            let value = self.stored(&value, assign.right.span());
            let target = self.place_tokens(&place);
            self.push_plain(quote!(#target = #value;));
        }
    }

    /// `place op= value`
    pub(super) fn update(&mut self, update: &ExprBinary) {
        let operator = BinaryOperator::of_update(&update.op);
        if let (Expr::Index(index), Some(operator)) = (strip_parens(&update.left), operator)
            && indexed::is_element(index)
        {
            return self.update_element(index, operator, &update.right);
        }
        if operator.is_some_and(|operator| self.borrowed_update(operator, update)) {
            return;
        }
        let value = self.scalar(&update.right, "value");
        let value = self.in_turn(value, &update.right, [&*update.left]);
        let Some(place) = self.target(&update.left) else { return };
        let both_may = may_have_effect(&update.left) && may_have_effect(&update.right);
        if both_may || exits::changes_index(&update.right, &update.left) {
            if self.is_reference(&update.right) {
                self.refuse(
                    update,
                    "of `place += value` the place is evaluated first where the value is a reference, and here last: \
                     give one side a name before, by `let`",
                );
            }
            let (place, value) = (self.place_tokens(&place), self.tokens(&value));
            let check = quote!(::ad::rt::right_first(&#place, &#value););
            self.push_plain(names::located(check, update.op.span()));
        }
        let token = &update.op;
        match operator {
            Some(operator) if self.vars[place.root].active => {
                let value = self.named(value, "constant", update.right.span());
                let value = self.number(value);
                let hint = self.ident(place.root).to_string();
                let read = Operation::Read(place.clone());
                let previous = self.define(&hint, update.left.span(), true, read);
                self.push(Statement::Update { place, operator, previous, value });
            }
            // Bit operations have no derivative, nor has what they are applied to.
            _ => {
                let value = self.stored(&value, update.right.span());
                let target = self.place_tokens(&place);
                if self.vars[place.root].active {
                    self.push_plain(quote!(::ad::rt::constant(#target);));
                }
                self.push_plain(quote!(#target #token #value;));
            }
        }
    }

    /// `whole[(i, j)] op= value`
    fn update_element(&mut self, index: &syn::ExprIndex, operator: BinaryOperator, value: &Expr) {
        let [position, term] = ["position", "term"].map(|name| self.names.unwritten(name));
        let (whole, written) = (&index.expr, &index.index);
        let element: syn::ExprIndex = parse_quote!(#whole[#position]);
        let (symbol, read) = (Primal::operator(operator), indexed::read(&element));
        let replaced = indexed::replaced(&element, &parse_quote!(#read #symbol #term));
        self.scope(|lowerer| {
            lowerer.statement(&parse_quote!(let #term = #value;));
            lowerer.statement(&parse_quote!(let #position = #written;));
            let both_may = may_have_effect(written) && may_have_effect(value);
            if both_may || exits::changes_index(value, &Expr::Index(index.clone())) {
                let element = lowerer.plain(&parse_quote!(#whole[#position]));
                let (span, term) = (index.span(), lowerer.plain(&parse_quote!(#term)));
                let check = quote!(::ad::rt::right_first(&#element, &#term););
                lowerer.push_plain(names::located(check, span));
            }
            lowerer.statement(&parse_quote!(#replaced;));
        });
    }

    /// Tokens of an operand, checked by its type to have no derivative.
    pub(super) fn without_derivative(&self, value: &Operand) -> TokenStream {
        match value {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Var(var) => self.stored(value, self.ident(*var).span()),
        }
    }

    /// The same of a value that stands at `span`.
    pub(super) fn stored(&self, value: &Operand, span: Span) -> TokenStream {
        match value {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Var(var) => {
                let ident = self.ident_at(*var, span);
                // The compiler points to the argument only if both come from the same expansion.
                quote_spanned!(span.resolved_at(ident.span())=> ::ad::rt::constant(#ident))
            }
        }
    }
}

/// What to write instead of an assignment to what is no place.
fn not_a_place(expr: &Expr) -> &'static str {
    let method = match strip_parens(expr) {
        Expr::Unary(unary) => match strip_parens(&unary.expr) {
            Expr::MethodCall(call) => call.method.to_string(),
            _ => String::new(),
        },
        _ => String::new(),
    };
    match &*method {
        "or_insert" | "or_insert_with" | "or_default" => {
            "what a map holds has no derivative: let it hold indices, `#[constant] let mut indices = HashMap::new();`, and add to numbers in a `Vec`, `sums[index] += ..`"
        }
        "insert" | "get_or_insert" | "get_or_insert_with" => {
            "assign to the option first, `option = Some(value);`, then to its content: `if let Some(content) = &mut option { *content += .. }`"
        }
        _ => "only local variables and their parts can be assigned to",
    }
}

/// `option.as_ref().unwrap()`
fn is_lent_content(expr: &Expr) -> bool {
    let Expr::MethodCall(unwrapped) = strip_parens(expr) else { return false };
    let Expr::MethodCall(lent) = strip_parens(&unwrapped.receiver) else { return false };
    (unwrapped.method == "unwrap" || unwrapped.method == "expect")
        && (lent.method == "as_ref" || lent.method == "as_deref")
        && lent.args.is_empty()
}

/// Whether an expression makes a new value of what may be a type of one's own: `S { .. }`, `S::new(..)`,
/// `s.clone()`, `S::new(..).scaled(..)`.
fn makes_own(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Struct(_) => true,
        Expr::Call(call) => match strip_parens(&call.func) {
            Expr::Path(function) => {
                let last = function.path.segments.last();
                is_associated(function) || last.is_some_and(|last| is_type_name(&last.ident))
            }
            _ => false,
        },
        Expr::MethodCall(call) => {
            call.method == "clone"
                || makes_own(&call.receiver) && !rules::is_method(&call.method.to_string())
        }
        _ => false,
    }
}
