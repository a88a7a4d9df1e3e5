//! Finds functions that call themselves.
//!
//! The type of a pullback holds those of the pullbacks it calls, so that of a recursive function
//! would hold itself: it has to be boxed. Methods of one block that call each other in a circle are seen
//! together; a function that calls itself by way of functions outside says so with
//! `#[differentiable(boxed)]`, which one function of the circle needs.

use std::collections::HashSet;

use proc_macro2::{TokenStream, TokenTree};
use syn::parse::ParseStream;
use syn::visit::{self, Visit};
use syn::{
    Arm, Block, Expr, ExprCall, ExprLet, ExprMethodCall, Ident, Macro, Pat, PatIdent, Signature,
};

use crate::rules;

/// Whether a function calls itself by its name, by `Self::` or on `self`; a method of a type also where
/// it calls one of its name on a variable, which is part of `self` in most cases: `left.depth()`. A name
/// that has a rule is another type's there, `re.sin()`, unless a `match` or an `if let` names the variable:
/// `Node(left, ..) => left.insert(x)`.
pub fn is_recursive(signature: &Signature, body: &Block, is_inherent: bool) -> bool {
    Calls::of(signature, is_inherent, None).are_in(body)
}

/// The functions of the type `owner` to be boxed, so that none calls itself, by its name or by way of others.
pub fn circular(
    owner: Option<&Ident>,
    is_inherent: bool,
    functions: &[(&Signature, &Block)],
) -> Vec<Ident> {
    let calls =
        |body: &Block, called: &Signature| Calls::of(called, is_inherent, owner).are_in(body);
    let called: Vec<Vec<_>> = functions
        .iter()
        .map(|(_, body)| {
            (0..functions.len()).filter(|&other| calls(body, functions[other].0)).collect()
        })
        .collect();
    let mut boxed = Vec::new();
    for start in 0..functions.len() {
        let (mut reached, mut open) = (HashSet::new(), vec![start]);
        while let Some(at) = open.pop() {
            let next = called[at].iter().filter(|next| !boxed.contains(*next));
            open.extend(next.copied().filter(|&next| reached.insert(next)));
        }
        if reached.contains(&start) {
            boxed.push(start);
        }
    }
    boxed.into_iter().map(|index| functions[index].0.ident.clone()).collect()
}

struct Calls<'a> {
    name: &'a Ident,
    is_method: bool,
    /// The variables on which a call counts.
    variables: Variables,
    /// What stands for `Self`.
    owner: Option<&'a Ident>,
    found: bool,
}

enum Variables {
    None,
    All,
    /// Those that patterns of matches name, as far as they have been met.
    Matched(HashSet<Ident>),
}

impl<'a> Calls<'a> {
    fn of(called: &'a Signature, is_inherent: bool, owner: Option<&'a Ident>) -> Self {
        let name = &called.ident;
        let variables = match is_inherent {
            false => Variables::None,
            true if rules::is_method(&name.to_string()) => Variables::Matched(HashSet::new()),
            true => Variables::All,
        };
        Self { name, is_method: called.receiver().is_some(), variables, owner, found: false }
    }

    fn are_in(mut self, body: &Block) -> bool {
        self.visit_block(body);
        self.found
    }

    fn counts(&self, variable: &Ident) -> bool {
        match &self.variables {
            Variables::None => false,
            Variables::All => true,
            Variables::Matched(names) => names.contains(variable),
        }
    }

    /// Notes what a pattern names.
    fn matched(&mut self, pattern: &Pat) {
        let Variables::Matched(names) = &mut self.variables else { return };
        Named(names).visit_pat(pattern);
    }
}

/// The names in a pattern.
struct Named<'a>(&'a mut HashSet<Ident>);

impl<'ast> Visit<'ast> for Named<'_> {
    fn visit_pat_ident(&mut self, name: &'ast PatIdent) {
        self.0.insert(name.ident.clone());
        visit::visit_pat_ident(self, name);
    }
}

impl<'ast> Visit<'ast> for Calls<'_> {
    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        if let Expr::Path(function) = &*call.func {
            let segments = &function.path.segments;
            let is_own = match (segments.first(), segments.last(), segments.len()) {
                (_, Some(last), 1) => !self.is_method && last.ident == *self.name,
                (Some(first), Some(last), 2) => {
                    (first.ident == "Self" || self.owner == Some(&first.ident))
                        && last.ident == *self.name
                }
                _ => false,
            };
            self.found |= is_own;
        }
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let is_own = matches!(&*call.receiver, Expr::Path(path)
            if path.path.get_ident().is_some_and(|name| name == "self" || self.counts(name)));
        self.found |= self.is_method && is_own && call.method == *self.name;
        visit::visit_expr_method_call(self, call);
    }

    fn visit_arm(&mut self, arm: &'ast Arm) {
        self.matched(&arm.pat);
        visit::visit_arm(self, arm);
    }

    fn visit_expr_let(&mut self, condition: &'ast ExprLet) {
        self.matched(&condition.pat);
        visit::visit_expr_let(self, condition);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        if let Ok(arguments) = call.parse_body_with(leading_expressions) {
            arguments.iter().for_each(|argument| self.visit_expr(argument));
        }
    }
}

/// The expressions that what a macro is given begins with: elements, as in `vec![x, y]` and `vec![x; n]`,
/// values, and what `matches!` looks at.
fn leading_expressions(input: ParseStream<'_>) -> syn::Result<Vec<Expr>> {
    let mut found = Vec::new();
    while let Ok(expr) = input.parse() {
        found.push(expr);
        let separator: TokenTree = match input.is_empty() {
            true => break,
            false => input.parse()?,
        };
        if !matches!(&separator, TokenTree::Punct(mark) if [',', ';'].contains(&mark.as_char())) {
            break;
        }
    }
    input.parse::<TokenStream>()?;
    Ok(found)
}
