//! Loops with checkpoints, in the plainer form that the sweeps know: no exits, and no state but
//! variables of the function's own.
//!
//! An exit becomes a variable that says that the loop is over, upon which the iterations that are left
//! do nothing; the jump itself stands behind the loop. A `loop` is a `while` that goes on until it is
//! left. What is borrowed as `&mut` is copied before the loop and written back after it, and so is what
//! the loop uses of `self`.

use std::collections::BTreeMap;

use proc_macro2::Ident;
use quote::ToTokens;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Attribute, Block, Expr, ExprForLoop, ExprLoop, ExprWhile, Label, Lifetime, Stmt, parse_quote,
};

use crate::ir::VarId;
use crate::lower::rewrite::exits;
use crate::lower::rewrite::exits::Exit;
use crate::lower::search::block_has;
use crate::lower::syntax::strip_parens;
use crate::lower::{Lowerer, OnFailure};
use crate::names;
use crate::names::Names;
use crate::parse::options::own_options;

/// A loop, whatever makes it go on.
#[derive(Clone, Copy)]
struct Parts<'a> {
    attributes: &'a [Attribute],
    label: Option<&'a Label>,
    body: &'a Block,
}

/// The parts of a loop with checkpoints.
fn parts(expr: &Expr) -> Option<Parts<'_>> {
    let (attributes, label, body) = match expr {
        Expr::ForLoop(ExprForLoop { attrs, label, body, .. })
        | Expr::While(ExprWhile { attrs, label, body, .. })
        | Expr::Loop(ExprLoop { attrs, label, body, .. }) => (attrs, label, body),
        _ => return None,
    };
    let is_checkpointed = own_options(attributes).is_ok_and(|options| options.checkpoint);
    is_checkpointed.then_some(Parts { attributes, label: label.as_ref(), body })
}

impl Lowerer<'_> {
    /// What stands for a loop with checkpoints that has exits, or works on what is borrowed.
    pub(super) fn plainer_loop(&mut self, stmt: &Stmt) -> Option<Stmt> {
        let Stmt::Expr(a_loop, semicolon) = stmt else { return None };
        let parts = parts(a_loop)?;
        if self.is_object {
            return None;
        }
        // A condition that is more than one.
        if let Expr::While(ExprWhile { cond, .. }) = a_loop
            && self.is_not_plain(cond)
        {
            let Parts { attributes, label, body } = parts;
            let plainer = parse_quote!({
                #(#attributes)*
                #label loop {
                    if #cond #body else { break; }
                }
            });
            return Some(Stmt::Expr(plainer, Some(Default::default())));
        }
        if let Some((plainer, has_value)) = self.without_exits(a_loop) {
            let ends = (!has_value).then(Default::default);
            return Some(Stmt::Expr(plainer, semicolon.or(ends)));
        }
        let plainer = self.with_own_state(a_loop)?;
        Some(Stmt::Expr(plainer, Some(Default::default())))
    }

    /// The jumps of a loop behind it, and whether that has the loop's value or type.
    fn without_exits(&mut self, a_loop: &Expr) -> Option<(Expr, bool)> {
        let Parts { attributes, label, body } = parts(a_loop)?;
        let own = label.map(|label| label.name.clone());
        let is_exit = |exit: &Exit| match exit {
            Exit::Continue(label) => label.is_some() && *label != own,
            Exit::Break(_) | Exit::Return => true,
        };
        let exits: Vec<_> = exits::block_exits(body).into_iter().filter(is_exit).collect();
        if exits.is_empty()
            || (has_question_mark(body)
                && !matches!(self.on_failure, OnFailure::None | OnFailure::Err))
        {
            return None;
        }
        let fresh = ["is_running", "returned", "jump"].map(|name| self.names.unwritten(name));
        let [is_running, returned, jump] = &fresh;
        let own = own.unwrap_or_else(|| {
            let name = self.names.unwritten("checkpointed");
            Lifetime::new(&format!("'{name}"), name.span())
        });
        // Jumps to labels of loops and blocks around it, by their numbers from 1.
        let outward: Vec<_> = exits
            .iter()
            .filter(|exit| match exit {
                Exit::Break(label) => label.as_ref().is_some_and(|label| *label != own),
                Exit::Continue(_) => true,
                Exit::Return => false,
            })
            .cloned()
            .collect();

        let mut body = body.clone();
        let has_return = exits.contains(&Exit::Return);
        let mut rewriting = Rewriting {
            own: &own,
            is_running,
            returned,
            jump,
            outward: &outward,
            carried: BTreeMap::new(),
            result: None,
            on_failure: self.on_failure,
            depth: 0,
            names: &mut *self.names,
        };
        rewriting.visit_block_mut(&mut body);
        let Rewriting { carried, result, .. } = rewriting;

        let label = Label { name: own.clone(), colon_token: Default::default() };
        let mut before: Vec<Stmt> = vec![parse_quote!(let mut #is_running = true;)];
        let mut after: Vec<Stmt> = Vec::new();
        let plainer: Expr = match a_loop {
            // Of numbers without end none would be left to do nothing.
            Expr::ForLoop(ExprForLoop { pat, expr, .. }) if let Some(first) = endless(expr) => {
                let count = self.names.unwritten("count");
                before.push(parse_quote!(let mut #count = #first;));
                parse_quote! {
                    #(#attributes)*
                    #label while #is_running {
                        let #pat = #count;
                        #count += 1;
                        #body
                    }
                }
            }
            Expr::ForLoop(ExprForLoop { pat, expr, .. }) => parse_quote! {
                #(#attributes)*
                #label for #pat in #expr {
                    if #is_running #body
                }
            },
            Expr::While(ExprWhile { cond, .. }) => parse_quote! {
                #(#attributes)*
                #label while #is_running && (#cond) #body
            },
            _ => parse_quote!(#(#attributes)* #label while #is_running #body),
        };
        if has_return {
            let value = self.names.unwritten("value");
            before.push(parse_quote!(let mut #returned = ::core::option::Option::None;));
            after.push(parse_quote! {
                if let ::core::option::Option::Some(#value) = #returned {
                    return #value;
                }
            });
        }
        if !outward.is_empty() {
            before.push(parse_quote!(let mut #jump = 0_usize;));
        }
        for (index, exit) in outward.iter().enumerate() {
            if let (Exit::Break(label), Some(value)) = (exit, carried.get(&index)) {
                before.push(parse_quote!(let mut #value = ::core::option::Option::None;));
                after.push(parse_quote! {
                    if let ::core::option::Option::Some(#value) = #value {
                        break #label #value;
                    }
                });
                continue;
            }
            let number = index + 1;
            let outward: Expr = match exit {
                Exit::Break(label) => parse_quote!(break #label),
                Exit::Continue(label) => parse_quote!(continue #label),
                Exit::Return => unreachable!("leads out of the function"),
            };
            after.push(parse_quote!(if #jump == #number { #outward; }));
        }
        let value: Option<Expr> = match result {
            Some(result) => {
                before.push(parse_quote!(let mut #result = ::core::option::Option::None;));
                Some(parse_quote!(#result.unwrap()))
            }
            None => exits::expr_diverges(a_loop).then(|| parse_quote!(::core::unreachable!())),
        };
        let plainer = parse_quote!({
            #(#before)*
            #plainer
            #(#after)*
            #value
        });
        Some((plainer, value.is_some()))
    }

    /// A loop on copies of what it uses that is borrowed.
    fn with_own_state(&mut self, a_loop: &Expr) -> Option<Expr> {
        let mut named = names::identifiers(a_loop.to_token_stream());
        named.sort();
        for name in named {
            let Some(var) = self.lookup(&name) else { continue };
            if name == "self" {
                return self.with_own_receiver(a_loop, &name, var);
            }
            // What a parameter borrows, or a part of it that has a name.
            let alias = self.aliases.get(&var).filter(|alias| alias.is_exclusive);
            let root = alias.map_or(var, |alias| alias.place.root);
            if !self.vars[root].exclusive {
                continue;
            }
            let mut path = alias.into_iter().flat_map(|alias| &alias.place.path);
            let is_slice = match path.rfind(|step| step.is_part()) {
                Some(part) => part.is_range(),
                None => self.slices.contains(&root),
            };
            let copy = self.names.unwritten("copy");
            let (copied, back): (Expr, Stmt) = match is_slice {
                true => {
                    (parse_quote!(#name.to_vec()), parse_quote!(#name.copy_from_slice(&#copy);))
                }
                false => (parse_quote!((*#name).clone()), parse_quote!(*#name = #copy;)),
            };
            return Some(parse_quote!({
                let mut #copy = #copied;
                {
                    let #name = &mut #copy;
                    #a_loop
                }
                #back
            }));
        }
        None
    }

    /// A loop on a copy of `self`, which cannot be the name of a variable.
    fn with_own_receiver(&mut self, a_loop: &Expr, name: &Ident, receiver: VarId) -> Option<Expr> {
        let [copy, this] = ["copy", "this"].map(|name| self.names.unwritten(name));
        let renamed = names::without_self(a_loop.to_token_stream(), &this);
        let renamed: Expr = syn::parse2(renamed).ok()?;
        Some(if self.vars[receiver].exclusive {
            parse_quote!({
                let mut #copy = (*#name).clone();
                {
                    let #this = &mut #copy;
                    #renamed
                }
                *#name = #copy;
            })
        } else if self.vars[receiver].mutable {
            parse_quote!({
                let mut #this = #name;
                #renamed
                #name = #this;
            })
        } else if self.may_refer(receiver) {
            parse_quote!({
                let #this = (*#name).clone();
                #renamed
            })
        } else {
            return None;
        })
    }
}

/// The first of numbers without end, `first..`.
fn endless(iterator: &Expr) -> Option<&Expr> {
    match strip_parens(iterator) {
        Expr::Range(range) if range.end.is_none() => range.start.as_deref(),
        _ => None,
    }
}

/// Whether `?` may leave the loop.
fn has_question_mark(body: &Block) -> bool {
    block_has(body, |part| match part {
        Expr::Try(_) => Some(true),
        Expr::Closure(_) => Some(false),
        _ => None,
    })
}

/// Puts the end of the iteration in place of each jump out of the loop, and notes where it leads.
struct Rewriting<'a> {
    own: &'a Lifetime,
    is_running: &'a Ident,
    returned: &'a Ident,
    jump: &'a Ident,
    outward: &'a [Exit],
    /// What takes the values that jumps to labels take along, by the positions of these jumps.
    carried: BTreeMap<usize, Ident>,
    /// What takes the value of the loop.
    result: Option<Ident>,
    on_failure: OnFailure,
    /// In how many loops within the loop.
    depth: usize,
    names: &'a mut Names,
}

impl Rewriting<'_> {
    fn leave(&self, note: Option<Stmt>) -> Expr {
        let Self { own, is_running, .. } = self;
        parse_quote!({
            #note
            #is_running = false;
            continue #own;
        })
    }

    fn leave_with(&self, taken_by: &Ident, value: &Expr) -> Expr {
        self.leave(Some(parse_quote!(#taken_by = ::core::option::Option::Some(#value);)))
    }

    /// What stands for a jump to a label, or to the loop itself, that may take a value along.
    fn jump_to(&mut self, exit: &Exit, value: Option<&Expr>) -> Option<Expr> {
        if let Some(index) = self.outward.iter().position(|outward| outward == exit) {
            let (jump, number) = (self.jump, index + 1);
            return Some(match value {
                Some(value) => {
                    let names = &mut *self.names;
                    let taken_by =
                        self.carried.entry(index).or_insert_with(|| names.unwritten("carried"));
                    let taken_by = taken_by.clone();
                    self.leave_with(&taken_by, value)
                }
                None => self.leave(Some(parse_quote!(#jump = #number;))),
            });
        }
        let leaves_own = match exit {
            Exit::Break(None) => self.depth == 0,
            Exit::Break(Some(label)) => label == self.own,
            _ => false,
        };
        leaves_own.then(|| match value {
            Some(value) => {
                let names = &mut *self.names;
                let result = self.result.get_or_insert_with(|| names.unwritten("result")).clone();
                self.leave_with(&result, value)
            }
            None => self.leave(None),
        })
    }
}

impl Rewriting<'_> {
    /// A statement, and before it what `?` may leave in the middle of it.
    fn apart(&mut self, mut stmt: Stmt) -> Vec<Stmt> {
        let mut parts = Vec::new();
        let expr = match &mut stmt {
            Stmt::Local(syn::Local { init: Some(init), .. }) => &mut *init.expr,
            Stmt::Expr(expr, _) => expr,
            _ => return vec![stmt],
        };
        loop {
            let evaluated = match &mut *expr {
                Expr::If(branch) => &mut *branch.cond,
                Expr::Match(branch) => &mut *branch.expr,
                Expr::Block(_) | Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) => break,
                expr => expr,
            };
            match exits::hoist(evaluated, self.names) {
                Some(hoisted) => {
                    let name = hoisted.name.clone();
                    let part = hoisted.into_argument();
                    parts.push(parse_quote!(let #name = #part;));
                }
                None => break,
            }
        }
        parts.push(stmt);
        parts
    }
}

impl VisitMut for Rewriting<'_> {
    fn visit_block_mut(&mut self, block: &mut syn::Block) {
        let statements = std::mem::take(&mut block.stmts);
        block.stmts = statements.into_iter().flat_map(|stmt| self.apart(stmt)).collect();
        visit_mut::visit_block_mut(self, block);
    }

    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        let is_loop = matches!(expr, Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_));
        self.depth += usize::from(is_loop);
        visit_mut::visit_expr_mut(self, expr);
        self.depth -= usize::from(is_loop);
        let rewritten = match &*expr {
            Expr::Return(jump) => {
                let unit = parse_quote!(());
                Some(self.leave_with(self.returned, jump.expr.as_deref().unwrap_or(&unit)))
            }
            Expr::Try(attempt) => {
                let (value, error) = (&attempt.expr, &self.names.unwritten("error"));
                let (failure, content): (syn::Pat, Expr) = match self.on_failure {
                    OnFailure::Err => (
                        parse_quote!(::core::result::Result::Err(#error)),
                        parse_quote!(::core::result::Result::Err(::ad::rt::propagate(#error))),
                    ),
                    _ => (
                        parse_quote!(::core::option::Option::None),
                        parse_quote!(::core::option::Option::None),
                    ),
                };
                let success: syn::Path = match self.on_failure {
                    OnFailure::Err => parse_quote!(::core::result::Result::Ok),
                    _ => parse_quote!(::core::option::Option::Some),
                };
                let leave = self.leave_with(self.returned, &content);
                Some(parse_quote!(match #value {
                    #success(#error) => #error,
                    #failure => #leave,
                }))
            }
            Expr::Break(jump) => {
                self.jump_to(&Exit::Break(jump.label.clone()), jump.expr.as_deref())
            }
            Expr::Continue(jump) => self.jump_to(&Exit::Continue(jump.label.clone()), None),
            _ => None,
        };
        if let Some(rewritten) = rewritten {
            *expr = rewritten;
        }
    }

    // Jumps in closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}
