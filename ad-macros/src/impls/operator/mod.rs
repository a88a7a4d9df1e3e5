//! Operators of one's own types: `#[differentiable]` on `impl Mul for Complex`.
//!
//! The block stays as it is, and a rule like those of numbers stands beside it
//! (`impl MulPullback for Complex`), so that `a * b` means the same to generated code whatever the
//! types are. The body of the operator becomes that of the rule, with a variable in place of `self`:
//! the rules of sums have no receiver, and get their operands from where they were kept.
//!
//! A rule pulls back from the operands: what the operator computes on its way is computed once more.

mod borrowed;
mod parts;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{
    Attribute, Block, FnArg, Generics, ImplItem, ItemImpl, Path, ReturnType, Signature, Type,
    Visibility, parse_quote,
};

use self::borrowed::Borrowed;
use self::parts::{Kind, Operator, output, without_receiver};
use crate::emit::{Differentiated, header};
use crate::names::own;
use crate::parse::callable::Callables;
use crate::parse::function::{Function, Place};
use crate::parse::options;
use crate::parse::options::Options;

const OPERATORS: [Operator; 11] = [
    Operator { name: "Neg", kind: Kind::Unary },
    Operator { name: "Add", kind: Kind::Sum },
    Operator { name: "Sub", kind: Kind::Sum },
    Operator { name: "Mul", kind: Kind::Product },
    Operator { name: "Div", kind: Kind::Product },
    Operator { name: "Rem", kind: Kind::Product },
    Operator { name: "AddAssign", kind: Kind::Increase },
    Operator { name: "SubAssign", kind: Kind::Increase },
    Operator { name: "MulAssign", kind: Kind::Scaling },
    Operator { name: "DivAssign", kind: Kind::Scaling },
    Operator { name: "RemAssign", kind: Kind::Scaling },
];

/// The operator whose trait this is.
pub fn of(path: &Path) -> Option<Operator> {
    let last = path.segments.last()?;
    OPERATORS.into_iter().find(|operator| last.ident == operator.name)
}

/// The rule of an operator.
pub fn rule(operator: Operator, block: &ItemImpl, options: &Options) -> syn::Result<TokenStream> {
    let Some((path, _)) = &block.trait_ else { return Ok(TokenStream::new()) };
    let method = block.items.iter().find_map(|item| match item {
        ImplItem::Fn(method) => Some(method),
        _ => None,
    });
    // The compiler says that it is missing.
    let Some(method) = method else { return Ok(TokenStream::new()) };
    refuse_options(options, &method.attrs, path)?;

    if let Some(slice) = borrowed::slice(block, path) {
        return Err(syn::Error::new_spanned(
            slice,
            "an operator with a slice has no derivative, for a slice has no size of its own: take `&Vec<T>` or an array, or write a method that takes the slice",
        ));
    }
    if borrowed::is_of_references(block, path) {
        let borrowed = Borrowed::new(operator, block, (&method.sig, &method.block));
        return Ok(borrowed.as_ref().map(Borrowed::rule).unwrap_or_default());
    }

    let Some((mut signature, mut body)) = without_receiver(&method.sig, &method.block) else {
        return Ok(TokenStream::new());
    };
    if let Some(mut output) = output(block) {
        output.visit_signature_mut(&mut signature);
        output.visit_block_mut(&mut body);
    }
    let rule = Rule { operator, path, block, signature: &signature };
    Ok(match rule.differentiated(&body) {
        Ok(differentiated) => rule.expand(Some(&differentiated)),
        // What stands in for it, so that no use of the operator adds an error of its own.
        Err(error) => {
            let (error, rule) = (error.into_compile_error(), rule.expand(None));
            quote!(#error #rule)
        }
    })
}

fn refuse_options(options: &Options, attributes: &[Attribute], path: &Path) -> syn::Result<()> {
    let options = options.with(options::own_options(attributes)?);
    let has_some =
        options.checkpoint || options.reverse || options.vjp.is_some() || options.jvp.is_some();
    match has_some {
        true => Err(syn::Error::new_spanned(
            path,
            "the attribute takes no arguments on an operator: put them on a method, and let the operator call that",
        )),
        false => Ok(()),
    }
}

/// Says that an operator between values of these types has a derivative. A second one would stand in
/// conflict with it.
fn mark(
    operator: Operator,
    span: Span,
    (generics, left, right): (&Generics, &Type, &Type),
) -> TokenStream {
    let operation = Ident::new(operator.name, span);
    let (header, _, bounds) = generics.split_for_impl();
    quote_spanned! {span=>
        impl #header ::ad::rules::AttributeOnOneForm<::ad::rules::operation::#operation, #right>
            for #left #bounds {}
    }
}

struct Rule<'a> {
    operator: Operator,
    path: &'a Path,
    block: &'a ItemImpl,
    /// That of the method, without receiver.
    signature: &'a Signature,
}

impl Rule<'_> {
    /// Both modes of the operator.
    fn differentiated(&self, body: &Block) -> syn::Result<Differentiated> {
        let function = Function {
            place: Place::TraitImpl(&self.block.generics, &self.block.self_ty),
            visibility: &Visibility::Inherited,
            signature: self.signature,
            callables: &Callables::new(self.signature),
            body: Some(body),
            exclusive_methods: &[],
            options: Options::default(),
        };
        function.differentiated()
    }

    /// The `impl` of the rule; without derivative what stands in for it.
    fn expand(&self, differentiated: Option<&Differentiated>) -> TokenStream {
        let Self { operator, path, block, signature } = self;
        let span = path.span();
        let (name, method) = (format_ident!("{}Pullback", operator.name), &signature.ident);
        let name = Ident::new(&name.to_string(), span);
        let arguments = path.segments.last().map(|last| &last.arguments);
        let (self_ty, types) = (&block.self_ty, self.types());
        let right = types.get(1).cloned().unwrap_or_else(|| parse_quote!(Self));
        let (generics, _, bounds) = block.generics.split_for_impl();
        let result = match &signature.output {
            ReturnType::Type(_, ty) => (**ty).clone(),
            ReturnType::Default => parse_quote!(Self),
        };
        let cotangent = own("cotangent");
        let (kept, left, right_operand) = (own("kept"), own("left"), own("right"));
        let (left_dot, right_dot) = (own("left_dot"), own("right_dot"));

        let mut items = TokenStream::new();
        let (operands, start) = match operator.kind {
            Kind::Unary | Kind::Sum | Kind::Increase => {
                items.extend(quote!(type Kept = ::ad::rules::Operands<Self, #right>;));
                (
                    quote!(#kept: &::ad::rules::Operands<Self, #right>),
                    quote!(let (mut #left, #right_operand) = #kept.give_back();),
                )
            }
            Kind::Product => (quote!(self, #right_operand: #right), quote!(let mut #left = self;)),
            Kind::Scaling => (quote!(mut #left: Self, #right_operand: #right), TokenStream::new()),
        };
        let gradient = match operator.kind {
            Kind::Unary => quote!(::ad::Tangent<Self>),
            _ => quote!((::ad::Tangent<Self>, ::ad::Tangent<#right>)),
        };
        let changes = operator.changes();
        let lent = |name: &Ident| match changes {
            true => quote!(&mut #name),
            false => quote!(#name),
        };
        let bound = |names: &[Ident], left: &Ident, right: &Ident| {
            let values = [lent(left), quote!(#right)];
            let values = values.iter().take(names.len());
            quote!(let (#(#names,)*) = (#(#values,)*);)
        };
        let refused = quote!(::core::unreachable!());
        let (back, along) = match differentiated {
            None => (refused.clone(), refused),
            Some(Differentiated { names, vjp, tangents, jvp }) => {
                let operands = bound(names, &left, &right_operand);
                let tangents = bound(tangents, &left_dot, &right_dot);
                let given = match changes {
                    true => quote!((), #cotangent),
                    false => quote!(#cotangent),
                };
                let along = match changes {
                    true => quote!({ #operands #tangents #jvp }; #left_dot),
                    false => quote!(#operands #tangents #jvp),
                };
                let pullback = own("pullback");
                let is_kept = quote_spanned!(self_ty.span()=> ::ad::rt::operand::<Self>(););
                (
                    quote! {
                        #is_kept
                        #start
                        #operands
                        let (_, #pullback) = #vjp;
                        #pullback(#given)
                    },
                    quote!(let mut #left = self; #along),
                )
            }
        };
        let (pullback, jvp) = (format_ident!("{method}_pullback"), format_ident!("{method}_jvp"));
        let output = match changes {
            true => quote!(::ad::Tangent<Self>),
            false => quote!((#result, ::ad::Tangent<#result>)),
        };
        let (further, further_tangent) = match operator.kind {
            Kind::Unary => (None, None),
            _ => (
                Some(quote!(, #right_operand: #right)),
                Some(quote!(, #right_dot: ::ad::Tangent<#right>)),
            ),
        };
        let lints = header::lints();
        let marked = match operator.kind {
            Kind::Unary => parse_quote!(()),
            _ => right.clone(),
        };
        let mark = mark(*operator, span, (&block.generics, self_ty, &marked));
        quote_spanned! {span=>
            #mark

            #[automatically_derived]
            impl #generics ::ad::rules::#name #arguments for #self_ty #bounds {
                #items

                #lints
                #[inline]
                fn #pullback(#operands, #cotangent: ::ad::Tangent<#result>) -> #gradient {
                    #back
                }

                #lints
                #[inline]
                fn #jvp(
                    self #further, mut #left_dot: ::ad::Tangent<Self> #further_tangent
                ) -> #output {
                    #along
                }
            }
        }
    }

    /// The types of the operands.
    fn types(&self) -> Vec<Type> {
        let inputs = self.signature.inputs.iter();
        inputs
            .filter_map(|input| match input {
                FnArg::Typed(typed) => Some((*typed.ty).clone()),
                FnArg::Receiver(_) => None,
            })
            .collect()
    }
}
