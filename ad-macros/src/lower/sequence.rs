//! `vec![..]` and `Box::new(..)`.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::parse::{Parse, ParseStream};
use syn::spanned::Spanned;
use syn::{Expr, ExprCall, Macro, Token};

use super::Lowerer;
use super::construct::numbered;
use crate::ir::{Operand, Operation, Shape, Statement};

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

impl Lowerer<'_> {
    /// `vec![a, b]`, `vec![x; n]`
    pub(super) fn vec(&mut self, call: &Macro, hint: &str) -> Operand {
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
    pub(super) fn boxed(&mut self, call: &ExprCall, hint: &str) -> Operand {
        let function = &call.func;
        let parts = self.operands(&call.args);
        let tokens: TokenStream = parts.iter().map(|part| self.tokens(part)).collect();
        let expression = quote!(#function(#tokens));
        let value = self.aggregate(expression, Shape::Boxed, numbered(parts), hint, call.span());
        // It could be somebody else's `Box`.
        if let Operand::Var(var) = value {
            let ident = self.ident(var).to_token_stream();
            let code = quote!(let _: &::std::boxed::Box<_> = &#ident;);
            self.push(Statement::Plain { code, defines: Vec::new() });
        }
        value
    }
}
