//! `vec![..]` and `Box::new(..)`.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::parse::{Parse, ParseStream};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, ExprCall, Macro, Stmt, Token, parse_quote};

use super::construct::numbered;
use crate::ir::{Operand, Operation, Shape};
use crate::lower::Lowerer;
use crate::lower::rewrite::exits::expr_exits;
use crate::lower::syntax::standard_macro;
use crate::names::Names;

/// What stands in `vec![..]`: a list, or one element and how often it is repeated.
struct Elements {
    elements: Vec<Expr>,
    length: Option<Expr>,
}

impl Parse for Elements {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut elements = Vec::new();
        while !input.is_empty() {
            elements.push(input.parse()?);
            if elements.len() == 1 && input.peek(Token![;]) {
                input.parse::<Token![;]>()?;
                return Ok(Self { elements, length: Some(input.parse()?) });
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(Self { elements, length: None })
    }
}

/// Takes elements of `vec!` that may exit, and those before, out of the macros in statements: `vec![a, f()?, b]`
/// becomes `{ let value = a; let value_1 = f()?; vec![value, value_1, b] }`.
pub fn exits_apart(mut stmts: Vec<Stmt>, names: &mut Names) -> Vec<Stmt> {
    struct Apart<'n>(&'n mut Names);

    impl Apart<'_> {
        fn block(&mut self, call: &Macro) -> Option<Block> {
            let path = &call.path;
            standard_macro(path).filter(|name| name == "vec")?;
            let Elements { mut elements, mut length } = call.parse_body().ok()?;
            let mut parts: Vec<_> = elements.iter_mut().chain(&mut length).collect();
            parts.iter_mut().for_each(|part| self.visit_expr_mut(part));
            let exit = parts.iter().rposition(|part| expr_exits(part))?;
            let mut block: Block = parse_quote!({});
            for part in &mut parts[..=exit] {
                let name = self.0.unwritten("value");
                let value = std::mem::replace(*part, parse_quote!(#name));
                block.stmts.push(parse_quote!(let #name = #value;));
            }
            let length = length.map(|length| quote!(; #length));
            let vector: Expr = parse_quote!(#path![#(#elements),* #length]);
            block.stmts.push(Stmt::Expr(vector, None));
            Some(block)
        }
    }

    impl VisitMut for Apart<'_> {
        fn visit_expr_mut(&mut self, expr: &mut Expr) {
            visit_mut::visit_expr_mut(self, expr);
            if let Expr::Macro(call) = expr
                && let Some(block) = self.block(&call.mac)
            {
                *expr = parse_quote!(#block);
            }
        }

        fn visit_stmt_mut(&mut self, stmt: &mut Stmt) {
            visit_mut::visit_stmt_mut(self, stmt);
            if let Stmt::Macro(call) = stmt
                && let Some(block) = self.block(&call.mac)
            {
                let semi_token = call.semi_token;
                *stmt = Stmt::Expr(parse_quote!(#block), semi_token);
            }
        }
    }

    let mut apart = Apart(names);
    stmts.iter_mut().for_each(|stmt| apart.visit_stmt_mut(stmt));
    stmts
}

impl Lowerer<'_> {
    /// `vec![a, b]`, `vec![x; n]`
    pub fn vec(&mut self, call: &Macro, hint: &str) -> Operand {
        let Elements { elements, length } = match syn::parse2(call.tokens.clone()) {
            Ok(elements) => elements,
            Err(error) => {
                self.errors.add(error);
                return Self::unit();
            }
        };
        let path = &call.path;
        let empty = quote_spanned!(path.span()=> #path![]);
        self.check_macro(path, &empty, &quote!(::std::vec::Vec<()>));
        let Some(length) = length else {
            let parts = self.operands(&elements);
            let tokens = parts.iter().map(|part| self.tokens(part));
            let expression = quote!(::std::vec![#(#tokens),*]);
            return self.aggregate(expression, Shape::Vec, numbered(parts), hint, call.span());
        };
        let element = self.operand(&elements[0], "element");
        let length = self.plain_constant(&length);
        match element {
            Operand::Constant(tokens) => Operand::Constant(quote!(::std::vec![#tokens; #length])),
            Operand::Var(value) => {
                let operation = Operation::Repeat { value, length, is_vec: true };
                Operand::Var(self.define(hint, call.span(), true, operation))
            }
        }
    }

    /// `Box::new(x)`
    pub fn boxed(&mut self, call: &ExprCall, hint: &str) -> Operand {
        let function = &call.func;
        let parts = self.operands(&call.args);
        let tokens: TokenStream = parts.iter().map(|part| self.tokens(part)).collect();
        let expression = quote!(#function(#tokens));
        let value = self.aggregate(expression, Shape::Boxed, numbered(parts), hint, call.span());
        // It could be somebody else's `Box`.
        if let Operand::Var(var) = value {
            let ident = self.ident(var).to_token_stream();
            let code = quote!(let _: &::std::boxed::Box<_> = &#ident;);
            self.push_plain(code);
        }
        value
    }
}
