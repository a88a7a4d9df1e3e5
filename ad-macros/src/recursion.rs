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
use syn::{Block, Expr, ExprCall, ExprMethodCall, Ident, Macro, Signature};

use crate::rules;

/// Whether a function calls itself by its name, by `Self::` or on `self`; a method of a type also where
/// it calls one of its name on a variable, which is part of `self` in most cases: `left.depth()`. A name
/// that has a rule is another type's there: `re.sin()`.
pub fn is_recursive(signature: &Signature, body: &Block, is_inherent: bool) -> bool {
    let is_own = !rules::is_method(&signature.ident.to_string());
    Calls {
        name: &signature.ident,
        is_method: signature.receiver().is_some(),
        counts_variables: is_inherent && is_own,
        owner: None,
        found: false,
    }
    .are_in(body)
}

/// The functions of the type `owner` to be boxed, so that none calls itself, by its name or by way of others.
pub fn circular(
    owner: Option<&Ident>,
    is_inherent: bool,
    functions: &[(&Signature, &Block)],
) -> Vec<Ident> {
    let calls = |body: &Block, called: &Signature| {
        let name = &called.ident;
        let counts_variables = is_inherent && !rules::is_method(&name.to_string());
        let is_method = called.receiver().is_some();
        Calls { name, is_method, counts_variables, owner, found: false }.are_in(body)
    };
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
    /// Whether a call on any variable counts.
    counts_variables: bool,
    /// What stands for `Self`.
    owner: Option<&'a Ident>,
    found: bool,
}

impl Calls<'_> {
    fn are_in(mut self, body: &Block) -> bool {
        self.visit_block(body);
        self.found
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
            if path.path.is_ident("self") || self.counts_variables && path.path.get_ident().is_some());
        self.found |= self.is_method && is_own && call.method == *self.name;
        visit::visit_expr_method_call(self, call);
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
