//! Wraps the sweeps into what users call: `f::vjp`, `f::value_and_grad`, `f::grad` (see [`items`]).

mod checkpoint;
mod forward;
pub mod header;
mod items;
mod lending;
mod passing;
mod reverse;
mod sized;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::Type;
use syn::spanned::Spanned;

use self::forward::Forward;
use crate::analyse::{kept, numbers};
use crate::emit::header::{Header, tuple_or_one};
use crate::errors::Errors;
use crate::lower;
use crate::names::Names;
use crate::names::own;
use crate::parse::function::{Function, Place};
use crate::parse::options::Options;
use crate::parse::recursion;
use crate::parse::refused;
use crate::parse::signature;
use crate::types;

/// Both modes of a function without the functions around them.
pub struct Differentiated {
    /// The names of the parameters.
    pub names: Vec<Ident>,
    /// Value and pullback.
    pub vjp: TokenStream,
    /// The names of the tangents of the parameters.
    pub tangents: Vec<Ident>,
    /// The value and its tangent.
    pub jvp: TokenStream,
}

impl Function<'_> {
    /// The derivative: items to put beside the function.
    pub fn derivative(&self) -> syn::Result<TokenStream> {
        let mut errors = Errors::default();
        let header = self.header(&mut errors);
        if self.options.checkpoint && matches!(self.place, Place::Trait(_) | Place::TraitImpl(..)) {
            errors.at(
                &self.signature.ident,
                "`checkpoint` is not supported on the methods of a trait: put the computation into a function, and call that",
            );
        }
        if self.options.checkpoint && self.callables.any() {
            errors.at(
                &self.signature.ident,
                "`checkpoint` is not supported on a function that takes functions: put what it computes between two calls of them into a function with `checkpoint`",
            );
        }
        if let (Some(rule), Some(_)) = (&self.options.vjp, self.body) {
            errors.finish()?;
            return Ok(self.functions(&header, Some(&self.delegated(&header, rule)), None));
        }
        let Some(body) = self.body else {
            errors.finish()?;
            return Ok(self.functions(&header, None, None));
        };

        let (sweeps, jvp) = self.written(&header, body, errors)?;
        Ok(self.functions(&header, Some(&sweeps), jvp.as_ref()))
    }

    /// Both modes as expressions of the parameters and of their tangents.
    pub fn differentiated(&self) -> syn::Result<Differentiated> {
        let mut errors = Errors::default();
        let header = self.header(&mut errors);
        let Some(body) = self.body else { unreachable!("is asked for where there is a body") };
        let (vjp, forward) = self.written(&header, body, errors)?;
        let forward = forward.expect("is wanted by default");
        Ok(Differentiated {
            names: header.parameters.iter().map(|parameter| parameter.ident.clone()).collect(),
            vjp,
            jvp: forward_body(&forward),
            tangents: forward.tangents,
        })
    }

    /// Value and pullback as an expression, and the forward mode, if it is wanted.
    fn written(
        &self,
        header: &Header,
        body: &syn::Block,
        mut errors: Errors,
    ) -> syn::Result<(TokenStream, Option<Forward>)> {
        let (signature, parameters) = (self.signature, &header.parameters);
        if header.is_hidden {
            errors.finish()?;
            errors = Errors::default();
        }
        let idents = parameters.iter().map(|parameter| parameter.ident.clone());
        let mut names = Names::new(quote!(#signature #body), idents);
        let source = lower::Source {
            parameters,
            result: &header.result,
            body,
            scalars: self.scalars(),
            exclusive_methods: self.exclusive_methods,
            self_is_own: match self.place {
                Place::Impl(_) => true,
                Place::TraitImpl(_, ty) => lower::has_own_methods(ty, false),
                Place::Free | Place::Trait(_) => false,
            },
        };
        let mut lowered = lower::lower(source, &mut names, &mut errors);
        errors.finish()?;
        kept::fill(&mut lowered, parameters, &mut names);
        numbers::write_known(&mut lowered, parameters);

        let seed = names.fresh("result_bar", Span::call_site());
        let sweeps = reverse::sweep(
            &lowered,
            parameters,
            (Some(header), !self.has_forward()),
            &seed,
            &mut names,
        );
        let reverse::Sweeps {
            forward,
            value,
            pullback,
            is_inlined,
            incoming,
            lent,
            lending_methods,
        } = sweeps;
        let defaults = lending_methods.iter().map(lending::Method::default_trait);
        let items: TokenStream = lower::items(body).map(ToTokens::to_token_stream).collect();
        let stand_ins = lowered.called.stand_ins();
        let jvp = self.forward(header, &lowered, &mut names).map(|forward| {
            let statements = &forward.statements;
            Forward { statements: quote!(#items #stand_ins #statements), ..forward }
        });
        let lent = header.lends().then_some(&lent[..]);
        let pullback = header.pullback(&seed, &incoming, lent, &pullback);
        let inline = (is_inlined && !header.boxed).then(|| quote!(#[inline(always)]));
        let sweeps = quote! {
            #stand_ins
            #(#defaults)*
            #forward
            (#value, #inline #pullback)
        };
        // Functions within the function have traits of their own.
        let sweeps = match items.is_empty() {
            true => sweeps,
            false => quote!(#items { #sweeps }),
        };
        let body = quote! {
            {
                #[allow(unused_imports)]
                use ::ad::rt::methods::*;
                #sweeps
            }
        };
        Ok((body, jvp))
    }

    /// The type parameters that are scalars.
    fn scalars(&self) -> Vec<Ident> {
        let outer = match self.place {
            Place::Free => None,
            Place::Impl(generics) | Place::Trait(generics) | Place::TraitImpl(generics, _) => {
                Some(generics)
            }
        };
        outer.into_iter().chain([&self.signature.generics]).flat_map(numbers::scalars).collect()
    }

    /// Whether the forward mode is written: it is wanted, and not given by hand.
    fn has_forward(&self) -> bool {
        !self.options.reverse && self.options.jvp.is_none()
    }

    /// The forward mode, if it is written.
    fn forward(
        &self,
        header: &Header,
        lowered: &lower::Lowered,
        names: &mut Names,
    ) -> Option<Forward> {
        self.has_forward().then(|| forward::forward(lowered, &header.parameters, names))
    }

    /// The function `jvp`.
    fn jvp(&self, header: &Header, forward: Option<&Forward>) -> TokenStream {
        if self.options.reverse {
            return TokenStream::new();
        }
        let Header { parameters, result, .. } = header;
        let (tangents, body) = match forward {
            Some(forward) => (forward.tangents.clone(), Some(forward_body(forward))),
            None => {
                let body = self.body.and_then(|_| forward::delegated(self, parameters));
                (forward::names_of_tangents(parameters), body)
            }
        };
        let bounds = self.bounds(header, &self.callables.forward);
        forward::item(self, parameters, result, &bounds, &tangents, body.as_ref())
    }

    /// What stands in for the derivative of a function that was refused, so that its callers do
    /// not add errors of their own.
    pub fn stub(&self) -> TokenStream {
        let mut errors = Errors::default();
        let header = self.header(&mut errors);
        if errors.finish().is_err() {
            return TokenStream::new();
        }
        let incoming = vec![own("_incoming"); header.exclusive_tangents.len()];
        let incoming: Vec<_> = incoming
            .iter()
            .enumerate()
            .map(|(index, ident)| format_ident!("{ident}_{index}"))
            .collect();
        let lent = vec![quote!(_); header.lent.len()];
        let lent = header.lends().then_some(&lent[..]);
        let pullback = header.pullback(&own("_cotangent"), &incoming, lent, &quote!(refused()));
        let body = quote! {
            {
                fn refused<T>() -> T {
                    ::core::unreachable!()
                }
                (refused(), #pullback)
            }
        };
        let plain = Options { boxed: self.options.boxed, ..Options::default() };
        let forward = Forward {
            tangents: forward::names_of_tangents(&header.parameters),
            statements: quote! {
                fn refused<T>() -> T {
                    ::core::unreachable!()
                }
            },
            result: quote!(refused()),
        };
        let function = Function { options: plain, ..*self };
        function.functions(&header, Some(&body), Some(&forward))
    }

    fn header(&self, errors: &mut Errors) -> Header {
        if let Place::Free = self.place {
            refused::name(&self.signature.ident, errors);
        }
        let parameters = signature::parameters(self.callables, errors);
        let (result, is_hidden) = signature::result(self.signature, errors);
        let tangents = parameters.iter().map(|parameter| match parameter.is_constant {
            true => quote!(()),
            false => tangent(&parameter.ty),
        });
        let tangents: Vec<_> = tangents.collect();
        let exclusive = parameters.iter().zip(&tangents);
        let exclusive = exclusive.filter(|(parameter, _)| parameter.is_exclusive);
        let lends = self.body.is_some() && lending::is_possible(self);
        let lent = parameters.iter().zip(&tangents).map(|(parameter, tangent)| {
            (lends && lending::is_lent(parameter)).then(|| tangent.clone())
        });
        let scalars = self.scalars();
        let is_sized_by_vjp = |parameter| lends && lending::is_sized_by_vjp(parameter, &scalars);
        Header {
            lent: lent.collect(),
            sized_by_vjp: parameters.iter().map(is_sized_by_vjp).collect(),
            result_tangent: tangent(&result),
            exclusive_tangents: exclusive.map(|(_, tangent)| tangent.clone()).collect(),
            gradient: tuple_or_one(&tangents),
            boxed: self.options.boxed
                || self.body.is_some_and(|body| {
                    let is_inherent = matches!(self.place, Place::Impl(_));
                    recursion::is_recursive(self.signature, body, is_inherent)
                }),
            parameters,
            result,
            is_hidden,
        }
    }

    /// The body of a `vjp` that a rule written by hand gives, which knows no cotangents but those of the sizes
    /// of the values.
    fn delegated(&self, header: &Header, rule: &syn::Path) -> TokenStream {
        let arguments = header.parameters.iter().map(|parameter| &parameter.ident);
        let call = quote_spanned!(rule.span()=> #rule(#(#arguments),*));
        let sized = header.parameters.iter().map(|parameter| !parameter.is_constant);
        sized::vjp(header, &call, &sized.collect::<Vec<_>>(), true)
    }
}

/// The forward mode as an expression.
fn forward_body(Forward { statements, result, .. }: &Forward) -> TokenStream {
    quote! {
        {
            #[allow(unused_imports)]
            use ::ad::rt::methods::*;
            #statements
            #result
        }
    }
}

fn tangent(ty: &Type) -> TokenStream {
    let ty = types::owned(ty);
    quote_spanned!(ty.span()=> ::ad::Tangent<#ty>)
}
