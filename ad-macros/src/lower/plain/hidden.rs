//! Ways by which a number could go on unseen: through what holds all of it without being one.
//!
//! A text, or the bits of a number, have no derivative; nor has a cell to which a condition gives one.
//! But a number that is read from these again would. What the standard library offers for that is
//! refused here, or by the type of the cell.

use std::collections::HashSet;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprMethodCall, ExprPath, UnOp};

use super::no_diff::{stopped, undifferentiated};
use crate::ir::{Operand, Operation, Statement, VarId};
use crate::lower::Lowerer;
use crate::lower::rewrite::exits::is_update;
use crate::lower::search::has;
use crate::lower::syntax::{root_name, strip_parens};

/// Methods and functions that give a number in another form, without loss.
const ENCODING: [&str; 4] = ["to_bits", "to_ne_bytes", "to_le_bytes", "to_be_bytes"];

/// Those that make a number of such a form again, or of a text.
const DECODING: [&str; 6] =
    ["parse", "from_str", "from_bits", "from_ne_bytes", "from_le_bytes", "from_be_bytes"];

/// Whether a method of this name may give a number in another form.
pub(super) fn encodes(method: &syn::Ident) -> bool {
    ENCODING.iter().any(|name| method == name)
}

/// Whether a function or a method of this name may make a number of another form.
pub fn decodes(name: &syn::Ident) -> bool {
    DECODING.iter().any(|known| name == known)
}

/// Adds the code without derivative by which `statements`, and what lies within them, define a variable.
fn add_definitions<'s>(statements: &'s [Statement], var: VarId, found: &mut Vec<&'s TokenStream>) {
    for statement in statements {
        for block in statement.blocks() {
            if let (Operand::Constant(code), true) = (&block.value, statement.result() == Some(var))
            {
                found.push(code);
            }
            add_definitions(&block.statements, var, found);
        }
    }
    found.extend(statements.iter().filter_map(|statement| match statement {
        Statement::Define {
            var: defined,
            operation: Operation::Use(Operand::Constant(code)),
            ..
        } if *defined == var => Some(code),
        Statement::Plain { code, defines } if defines.contains(&var) => Some(code),
        _ => None,
    }));
}

/// The place that holds what a place or a value is given: a guard is of the cell that made it.
fn held_by(expr: &Expr) -> &Expr {
    match strip_parens(expr) {
        Expr::Reference(reference) => held_by(&reference.expr),
        Expr::MethodCall(call) => held_by(&call.receiver),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => held_by(&unary.expr),
        Expr::Index(index) if root_name(&index.expr).is_none() => held_by(&index.expr),
        place => place,
    }
}

impl Lowerer<'_> {
    /// Refuses to make a number of what was made of one with a derivative.
    pub fn check_decoded(&mut self, source: &TokenStream, at: &impl quote::ToTokens) {
        if self.is_made_of_active(source) {
            self.refuse(
                at,
                "this number comes from one that has a derivative, by way of a text or of bits, where it is lost: write `ad::stop_gradient(..)` around that number if this is what you mean",
            );
        }
    }

    /// Whether code without derivative uses a variable that has one, itself or by way of others.
    fn is_made_of_active(&self, code: &TokenStream) -> bool {
        let is_active =
            |_: &Ident, var: Option<VarId>| var.is_some_and(|var| self.vars[var].active);
        self.is_made_of(code, &is_active, &mut HashSet::new())
    }

    /// Whether code without derivative makes or uses a text of a variable that has one.
    pub fn is_text_of_active(&self, code: &TokenStream) -> bool {
        let makes_text = |name: &Ident, _: Option<VarId>| name == "format" || name == "to_string";
        self.is_made_of(code, &makes_text, &mut HashSet::new()) && self.is_made_of_active(code)
    }

    /// Whether `found` holds for a name in code without derivative, or in what defines its variables, but for
    /// those that were `seen`.
    fn is_made_of(
        &self,
        code: &TokenStream,
        found: &dyn Fn(&Ident, Option<VarId>) -> bool,
        seen: &mut HashSet<VarId>,
    ) -> bool {
        let mut tokens = code.clone().into_iter().peekable();
        while let Some(token) = tokens.next() {
            let is_found = match token {
                TokenTree::Ident(name) if name == "stop_gradient" || name == "no_diff" => {
                    if let Some(TokenTree::Group(_)) = tokens.peek() {
                        tokens.next();
                    }
                    false
                }
                TokenTree::Ident(name) => {
                    let var = self.vars.iter().rposition(|var| var.ident == name);
                    let unseen = var.filter(|var| seen.insert(*var));
                    let definitions = unseen.map(|var| self.definitions(var)).unwrap_or_default();
                    found(&name, var)
                        || definitions.into_iter().any(|code| self.is_made_of(code, found, seen))
                }
                TokenTree::Group(group) => self.is_made_of(&group.stream(), found, seen),
                TokenTree::Punct(_) | TokenTree::Literal(_) => false,
            };
            if is_found {
                return true;
            }
        }
        false
    }

    /// Has the compiler refuse a number that a function gives for the text of one with a derivative.
    pub fn check_read(&mut self, value: TokenStream, hint: &str, span: Span) -> Operand {
        let value = self.define_constant(hint, span, value);
        let value = self.ident(value).clone();
        let code = quote_spanned!(span=> ::ad::rt::Read(&#value).is_no_number(););
        self.push_plain(code);
        Operand::Constant(quote!(#value))
    }

    /// The code without derivative that a variable gets its value from, on all ways.
    fn definitions(&self, var: VarId) -> Vec<&TokenStream> {
        let mut found = Vec::from_iter(self.parts_of.get(&var));
        for (_, statements) in &self.open_blocks {
            add_definitions(statements, var, &mut found);
        }
        found
    }

    /// Has the compiler refuse a cell that code without derivative gives a number with one, by a call or an
    /// assignment. It names what holds and what is given as the user wrote them. What the scopes from number
    /// `outside` on bind has no meaning where that is checked, and may have a derivative.
    pub fn check_cells(&mut self, giving: &Expr, outside: usize) {
        let (holders, given): (Vec<&Expr>, Vec<&Expr>) = match giving {
            Expr::MethodCall(ExprMethodCall { receiver, args, .. }) => {
                (std::iter::once(&**receiver).chain(args).collect(), args.iter().collect())
            }
            Expr::Call(call) => (call.args.iter().collect(), call.args.iter().collect()),
            Expr::Assign(assign) => (vec![&assign.left], vec![&assign.right]),
            Expr::Binary(update) if is_update(&update.op) => {
                (vec![&update.left], vec![&update.right])
            }
            _ => return,
        };
        let may_be_active = |given: &&Expr| {
            self.mentions(given, |path| {
                let is_bound_within = path
                    .path
                    .get_ident()
                    .is_some_and(|name| self.scopes.binds_within(outside, name));
                is_bound_within || self.names_active(path)
            })
        };
        if !given.iter().any(may_be_active) {
            return;
        }
        for holder in holders {
            let holder = held_by(holder);
            let Some(name) = root_name(holder) else { continue };
            if self.scopes.binds_within(outside, name) {
                continue;
            }
            let is_constant = self.lookup(name).is_none_or(|var| !self.vars[var].active);
            let is_place = matches!(holder, Expr::Path(_) | Expr::Field(_) | Expr::Index(_));
            if !is_constant || !is_place {
                continue;
            }
            let tokens = self.place(holder).map(|place| self.place_tokens(&place));
            let tokens = tokens.unwrap_or_else(|| quote!(#holder));
            let code =
                quote_spanned!(holder.span()=> ::ad::rt::Holder(&#tokens).holds_no_number(););
            self.push_plain(code);
        }
    }

    /// Whether an expression uses a variable through which a derivative may flow.
    pub fn mentions_active(&self, expr: &Expr) -> bool {
        self.mentions(expr, |path| self.names_active(path))
    }

    /// Whether a path names a variable through which a derivative may flow.
    fn names_active(&self, path: &ExprPath) -> bool {
        self.variable(path).is_some_and(|var| self.vars[var].active)
    }

    /// Whether `found` holds for a name in an expression, but for what is stopped.
    pub fn mentions(&self, expr: &Expr, mut found: impl FnMut(&ExprPath) -> bool) -> bool {
        has(expr, |part| match part {
            Expr::Path(path) => Some(found(path)),
            Expr::Call(call) if stopped(call).is_some() || undifferentiated(call).is_some() => {
                Some(false)
            }
            _ => None,
        })
    }
}
