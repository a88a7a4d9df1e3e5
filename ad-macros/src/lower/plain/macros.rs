//! Macros in code through which no derivative flows: `matches!`, and those of which nothing is known.

use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;
use syn::visit_mut::VisitMut;
use syn::{Expr, Macro, Token};

use super::Plain;
use crate::ir::Operand;
use crate::lower::Lowerer;
use crate::lower::call::macros::Matches;
use crate::lower::syntax::is_unknown_macro;

impl Lowerer<'_> {
    pub(in crate::lower) fn refuse_macro(&mut self, call: &Macro) -> Operand {
        let name = call.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
        let typed = match is_unknown_macro(call) {
            true => {
                format!(
                    "; where it gives a `bool` or an integer, say so: `let name: bool = {name}!(..);`"
                )
            }
            false => String::new(),
        };
        self.refuse(
            call,
            format!("the macro `{name}!` cannot be differentiated: write out what it expands to, or call it outside of the differentiable function{typed}"),
        )
    }
}

impl Plain<'_, '_> {
    /// `matches!(expr, pattern if guard)`
    pub(super) fn visit_matches(&mut self, call: &mut Macro) {
        let Matches { mut expr, mut pat, guard } = match call.parse_body() {
            Ok(parts) => parts,
            Err(error) => return self.lowerer.errors.add(error),
        };
        let carries = self.carries(&expr);
        self.visit_expr_mut(&mut expr);
        self.lowerer.scopes.open();
        self.bind_to(&mut pat, carries);
        let was_conditional = std::mem::replace(&mut self.is_conditional, true);
        let guard = guard.map(|mut guard| {
            self.visit_expr_mut(&mut guard);
            quote!(if #guard)
        });
        self.is_conditional = was_conditional;
        self.lowerer.scopes.close();
        call.tokens = quote!(#expr, #pat #guard);
    }

    /// The arguments of a macro of which nothing is known but that its value is not differentiated. It is evaluated
    /// within a closure, where it compiles if it changes nothing. `None` where it takes something else than values,
    /// which may have names, or a message.
    pub(super) fn visit_arguments_of_macro(&mut self, call: &mut Macro) -> Option<()> {
        let parser = Punctuated::<Expr, Token![,]>::parse_terminated;
        let mut arguments = call.parse_body_with(parser).ok()?;
        self.closures += 1;
        self.visit_conditional(|plain| {
            for argument in &mut arguments {
                match argument {
                    Expr::Assign(named)
                        if matches!(&*named.left, Expr::Path(path)
                            if plain.lowerer.variable(path).is_none()) =>
                    {
                        plain.visit_expr_mut(&mut named.right);
                    }
                    value => plain.visit_expr_mut(value),
                }
            }
        });
        self.closures -= 1;
        call.tokens = arguments.into_token_stream();
        Some(())
    }
}
