//! The macros of the standard library that numerical code uses. Any other is refused: what it
//! expands to is not seen here. One of the user's that has such a name is called as it is where its
//! arguments carry no derivative and nothing is changed, and else refused by the compiler.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Expr, Lit, Macro, Pat, Path, Token};

use crate::ir::{Operand, Operation};
use crate::lower::Lowerer;
use crate::lower::rewrite::exits;
use crate::lower::syntax::{
    calls, macro_diverges, standard_macro, strip_parens, values_before_format,
};

/// `expression, pattern if guard`, as in `matches!`.
pub struct Matches {
    pub expr: Expr,
    pub pat: Pat,
    pub guard: Option<Expr>,
}

impl Parse for Matches {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let expr = input.parse()?;
        input.parse::<Token![,]>()?;
        let pat = Pat::parse_multi_with_leading_vert(input)?;
        let guard = match input.parse::<Option<Token![if]>>()? {
            Some(_) => Some(input.parse()?),
            None => None,
        };
        input.parse::<Option<Token![,]>>()?;
        Ok(Self { expr, pat, guard })
    }
}

/// Whether a macro is called for its effect: it prints, or it panics.
fn is_statement(name: &str) -> bool {
    ["assert", "debug_assert"].iter().any(|start| name.starts_with(start))
        || matches!(name, "panic" | "unreachable" | "print" | "println" | "eprint" | "eprintln")
}

/// The value of what never has one.
pub fn never() -> TokenStream {
    quote!(::ad::rt::never())
}

impl Lowerer<'_> {
    /// A call of a macro, as a value or as a statement.
    pub fn macro_call(&mut self, call: &Macro, hint: &str) -> Operand {
        let name = standard_macro(&call.path).unwrap_or_default();
        match &*name {
            "format" => return self.formatted(call),
            "dbg" => return self.debugged(call, hint),
            "vec" => return self.vec(call, hint),
            "matches" => {
                return self.discrete(&Expr::Macro(syn::ExprMacro {
                    attrs: Vec::new(),
                    mac: call.clone(),
                }));
            }
            "todo" | "unimplemented" => {
                return self.refuse(
                    call,
                    format!(
                        "`{name}!` has no derivative: write what is to be computed, or `panic!`"
                    ),
                );
            }
            _ => {}
        }
        let Some(shown) = values_before_format(&name).filter(|_| is_statement(&name)) else {
            return self.refuse_macro(call);
        };
        let Some(arguments) = self.arguments_of(call) else { return Self::unit() };
        let mut tokens = Vec::new();
        for argument in arguments.iter().take(shown) {
            tokens.push(self.plain(argument));
        }
        let message: Vec<_> = arguments.iter().skip(shown).collect();
        tokens.extend(self.message(&message));
        let path = &call.path;
        let value = quote_spanned!(call.span()=> #path!(#(#tokens),*));
        let diverges = macro_diverges(call);
        // A macro of the user's may have this name.
        let check = match diverges {
            true => Some(quote_spanned!(path.span()=> let _ = || -> ! { #value };)),
            false => (!arguments.iter().any(calls))
                .then(|| quote_spanned!(path.span()=> ::ad::rt::changes_nothing(|| { #value; });)),
        };
        self.push_plain(quote!(#check #value;));
        match diverges {
            true => Operand::Constant(never()),
            false => Self::unit(),
        }
    }

    /// `format!(..)`: text has no derivative.
    fn formatted(&mut self, call: &Macro) -> Operand {
        let Some(arguments) = self.arguments_of(call) else { return Self::unit() };
        let arguments: Vec<_> = arguments.iter().collect();
        let message = self.message(&arguments);
        let path = &call.path;
        let text = quote_spanned!(call.span()=> #path!(#(#message),*));
        let text = Operand::Constant(quote_spanned!(path.span()=> ::ad::rt::text(#text)));
        let var = self.define("text", call.span(), false, Operation::Use(text));
        self.constant(var)
    }

    fn arguments_of(&mut self, call: &Macro) -> Option<Vec<Expr>> {
        let parsed = call.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated);
        let arguments = match parsed {
            Ok(arguments) => arguments,
            Err(error) => {
                self.errors.add(error);
                return None;
            }
        };
        for argument in &arguments {
            if exits::expr_exits(argument) {
                self.refuse(
                    argument,
                    "an exit from within a macro is not supported: bind the value to a variable with `let` before",
                );
            }
        }
        Some(arguments.into_iter().collect())
    }

    /// The arguments of a message. Names that the format string captures are passed by name, for
    /// generated variables may be called otherwise.
    fn message(&mut self, arguments: &[&Expr]) -> Vec<TokenStream> {
        let mut tokens = Vec::new();
        let mut named = Vec::new();
        for argument in arguments {
            tokens.push(match argument {
                Expr::Assign(assign) => {
                    let (name, value) = (&assign.left, self.plain_in_place(&assign.right));
                    named.push(name.to_token_stream().to_string());
                    quote!(#name = #value)
                }
                argument => self.plain_in_place(argument),
            });
        }
        if let Some(Expr::Lit(literal)) = arguments.first().map(|first| strip_parens(first))
            && let Lit::Str(format) = &literal.lit
        {
            for name in captured_names(&format.value(), format.span()) {
                if named.contains(&name.to_string()) || self.lookup(&name).is_none() {
                    continue;
                }
                let value = self.plain(&syn::parse_quote!(#name));
                tokens.push(quote!(#name = #value));
            }
        }
        tokens
    }

    /// Has the compiler check that a macro is that of the standard library, of which `call` is a call of
    /// type `ty`: beside an import of all that is there another macro of the name is ambiguous.
    pub fn check_macro(&mut self, path: &Path, call: &TokenStream, ty: &TokenStream) {
        if path.segments.len() > 1 || !self.checked.insert(call.to_string()) {
            return;
        }
        let code = quote_spanned! {path.span()=> {
            #[allow(unused_imports)]
            use ::std::*;
            let _ = || -> #ty { #call };
        }};
        self.push_plain(code);
    }

    /// `dbg!(x)`: prints, and is `x`.
    fn debugged(&mut self, call: &Macro, hint: &str) -> Operand {
        let path = &call.path;
        self.check_macro(path, &quote_spanned!(path.span()=> #path!()), &quote!(()));
        let arguments = self.arguments_of(call).unwrap_or_default();
        let [argument] = &arguments[..] else {
            return self.refuse(call, "`dbg!` of one value is supported");
        };
        let value = self.operand(argument, hint);
        let var = self.named(value, "shown", call.span());
        let ident = self.ident(var).clone();
        let text = call.tokens.to_string();
        let code = quote_spanned! {call.span()=>
            ::std::eprintln!(
                "[{}:{}:{}] {} = {:#?}",
                ::core::file!(), ::core::line!(), ::core::column!(), #text, &#ident
            );
        };
        self.push_plain(code);
        self.operand_of(var)
    }
}

/// What the elements of `vec!` and the argument of `dbg!` are evaluated by; a macro that is none of these
/// drops what it makes itself.
pub fn elements(call: &Macro) -> Option<Punctuated<Expr, Token![,]>> {
    let name = standard_macro(&call.path)?;
    matches!(&*name, "vec" | "dbg")
        .then(|| call.parse_body_with(Punctuated::parse_terminated).ok())
        .flatten()
}

/// The names that a format string takes from around it: `{name}`, `{:width$}`.
pub fn captured_names(format: &str, span: Span) -> Vec<Ident> {
    let mut names: Vec<Ident> = Vec::new();
    let unescaped = format.replace("{{", "");
    for part in unescaped.split('{').skip(1) {
        let Some((part, _)) = part.split_once('}') else { continue };
        let (name, options) = part.split_once(':').unwrap_or((part, ""));
        let widths = options.split('$').rev().skip(1).map(|width| {
            width.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("")
        });
        for name in std::iter::once(name.trim()).chain(widths) {
            if syn::parse_str::<Ident>(name).is_ok() && !names.iter().any(|n| n == name) {
                names.push(Ident::new(name, span));
            }
        }
    }
    names
}
