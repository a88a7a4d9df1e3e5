//! Operators of references: `impl Mul<&Matrix> for &Matrix`.
//!
//! The rule stands on the types of the values, which are borrowed, whatever the operator takes by
//! reference: `&a * &b`, `a * &b` and `a * b` have one derivative.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Block, FnArg, GenericArgument, GenericParam, Generics, ImplItem, ItemImpl, Lifetime, Path,
    PathArguments, ReturnType, Signature, Type, Visibility, parse_quote,
};

use super::parts::{Kind, Operator, output, without_receiver};
use crate::emit::Differentiated;
use crate::impls::operator;
use crate::names;
use crate::names::own;
use crate::parse::callable::Callables;
use crate::parse::function::{Function, Place};
use crate::parse::options::Options;
use crate::parse::signature;
use crate::types;

/// Whether an operand is a reference.
pub fn is_of_references(block: &ItemImpl, path: &Path) -> bool {
    let is_reference = |ty: &Type| matches!(ty, Type::Reference(_));
    is_reference(&block.self_ty) || right(path).is_some_and(is_reference)
}

/// An operand that is a reference to a slice.
pub fn slice<'b>(block: &'b ItemImpl, path: &'b Path) -> Option<&'b Type> {
    let mut operands = std::iter::once(&*block.self_ty).chain(right(path));
    operands.find(|ty| matches!(types::pointee(ty), Type::Slice(_)))
}

/// The right operand, if it is written down.
fn right(path: &Path) -> Option<&Type> {
    match &path.segments.last()?.arguments {
        PathArguments::AngleBracketed(arguments) => arguments.args.iter().find_map(|a| match a {
            GenericArgument::Type(ty) => Some(ty),
            _ => None,
        }),
        _ => None,
    }
}

/// An operator of references.
pub struct Borrowed {
    operator: Operator,
    path: Path,
    /// Without the lifetimes of the operands.
    generics: Generics,
    /// The operands as the operator takes them.
    operands: [Type; 2],
    result: Type,
    /// That of the method, without receiver.
    signature: Signature,
    body: Block,
}

impl Borrowed {
    /// The operator of a block, `None` if the compiler says what is wrong with it.
    pub fn new(
        operator: Operator,
        block: &ItemImpl,
        (signature, body): (&Signature, &Block),
    ) -> Option<Self> {
        let (path, _) = block.trait_.as_ref()?;
        let (mut signature, mut body) = without_receiver(signature, body)?;
        if let Some(mut output) = output(block) {
            output.visit_block_mut(&mut body);
        }
        let mut path = path.clone();
        let left = (*block.self_ty).clone();
        let right = match operator.kind {
            Kind::Unary => parse_quote!(()),
            _ => right(&path).cloned().unwrap_or_else(|| left.clone()),
        };
        let mut operands = [left, right];

        let mut elision = Elision::default();
        operands.iter_mut().for_each(|ty| elision.outermost(ty));
        elision.visit_path_mut(&mut path);
        elision.visit_block_mut(&mut body);
        let mut generics = block.generics.clone();
        elision.take_from(&mut generics, &operands);

        let changes = operator.changes();
        for (index, (input, ty)) in signature.inputs.iter_mut().zip(&operands).enumerate() {
            if let FnArg::Typed(typed) = input {
                *typed.ty = match changes && index == 0 {
                    true => parse_quote!(&mut #ty),
                    false => ty.clone(),
                };
            }
        }
        let result = match changes {
            true => parse_quote!(()),
            false => block.items.iter().find_map(|item| match item {
                ImplItem::Type(associated) if associated.ident == "Output" => {
                    Some(associated.ty.clone())
                }
                _ => None,
            })?,
        };
        signature.output = match changes {
            true => ReturnType::Default,
            false => parse_quote!(-> #result),
        };
        Some(Self { operator, path, generics, operands, result, signature, body })
    }

    /// The rule, and what is refused.
    pub fn rule(&self) -> TokenStream {
        let function = Function {
            place: Place::TraitImpl(&self.generics, &self.operands[0]),
            visibility: &Visibility::Inherited,
            signature: &self.signature,
            callables: &Callables::new(&self.signature),
            body: Some(&self.body),
            exclusive_methods: &[],
            options: Options::default(),
        };
        match function.differentiated() {
            Ok(differentiated) => self.expand(Some(&differentiated)),
            // What stands in for it, so that no use of the operator adds an error of its own.
            Err(error) => {
                let (error, rule) = (error.into_compile_error(), self.expand(None));
                quote!(#error #rule)
            }
        }
    }

    fn expand(&self, differentiated: Option<&Differentiated>) -> TokenStream {
        let Self { operator, path, generics, operands, result, signature, .. } = self;
        let span = path.span();
        let [left, right] = operands;
        let (left_value, right_value) = (types::pointee(left), types::pointee(right));
        let operation = Ident::new(operator.name, span);
        let [rhs, tangent, rhs_tangent, cotangent] =
            ["rhs", "tangent", "rhs_tangent", "cotangent"].map(own);
        let (header, _, bounds) = generics.split_for_impl();
        let signature::Captured { lifetimes, others } =
            signature::captured(signature, Some(generics), false);
        let captured = quote!(use<#(#lifetimes,)* #(#others),*>);
        let is_unary = operator.kind == Kind::Unary;

        // What is taken by value is a copy.
        let given = |ty: &Type, value: TokenStream| match ty {
            Type::Reference(_) => value,
            _ => quote!(::core::clone::Clone::clone(#value)),
        };
        let method = &signature.ident;
        let (left_given, right_given) = match operator.changes() {
            true => (quote!(self), given(right, quote!(#rhs))),
            false => (given(left, quote!(self)), given(right, quote!(#rhs))),
        };
        let values = match is_unary {
            true => vec![left_given.clone()],
            false => vec![left_given.clone(), right_given.clone()],
        };
        let tangents = match (operator.changes(), is_unary) {
            (true, _) => vec![quote!(#tangent), given(right, quote!(#rhs_tangent))],
            (false, true) => vec![given(left, quote!(#tangent))],
            (false, false) => {
                vec![given(left, quote!(#tangent)), given(right, quote!(#rhs_tangent))]
            }
        };
        let (back, along) = match differentiated {
            None => (quote!((refused(), |_, _| refused())), quote!(refused())),
            Some(Differentiated { names, vjp, tangents: dots, jvp }) => {
                let operands = quote!(let (#(#names,)*) = (#(#values,)*););
                let back = match is_unary {
                    true => {
                        let (value, pullback) = (own("value"), own("pullback"));
                        quote! {
                            let (#value, #pullback) = #vjp;
                            (#value, move |#cotangent| (#pullback(#cotangent), ()))
                        }
                    }
                    false => vjp.clone(),
                };
                (
                    quote!(#operands #back),
                    quote!(#operands let (#(#dots,)*) = (#(#tangents,)*); #jvp),
                )
            }
        };
        let refused = differentiated.is_none().then(|| {
            quote! {
                fn refused<T>() -> T {
                    ::core::unreachable!()
                }
            }
        });
        let back = match (differentiated, operator.changes()) {
            (None, false) => quote!((refused(), |_| refused())),
            _ => back,
        };
        let lints = quote! {
            #[allow(unused, non_snake_case, refining_impl_trait, clippy::all, clippy::pedantic, clippy::nursery)]
        };
        let gradient = quote!((::ad::Tangent<#left_value>, ::ad::Tangent<#right_value>));
        let right_tangent = quote!(::ad::Tangent<#right_value>);
        let body = match operator.changes() {
            true => quote! {
                #lints
                #[inline]
                fn assign(&mut self, #rhs: &#right_value) {
                    <#left as #path>::#method(#(#values),*)
                }

                #lints
                #[inline]
                fn vjp(&mut self, #rhs: &#right_value) -> (
                    (),
                    impl ::core::ops::FnOnce((), ::ad::Tangent<#left_value>) -> #gradient + #captured,
                ) {
                    #refused
                    #back
                }

                #lints
                #[inline]
                fn jvp(
                    &mut self,
                    #rhs: &#right_value,
                    #tangent: &mut ::ad::Tangent<#left_value>,
                    #rhs_tangent: &#right_tangent,
                ) -> ((), ()) {
                    #refused
                    #along
                }
            },
            false => quote! {
                type Output = #result;

                #lints
                #[inline]
                fn value(&self, #rhs: &#right_value) -> #result {
                    <#left as #path>::#method(#(#values),*)
                }

                #lints
                #[inline]
                fn vjp(&self, #rhs: &#right_value) -> (
                    #result,
                    impl ::core::ops::FnOnce(::ad::Tangent<#result>) -> #gradient + #captured,
                ) {
                    #refused
                    #back
                }

                #lints
                #[inline]
                fn jvp(
                    &self,
                    #rhs: &#right_value,
                    #tangent: &::ad::Tangent<#left_value>,
                    #rhs_tangent: &#right_tangent,
                ) -> (#result, ::ad::Tangent<#result>) {
                    #refused
                    #along
                }
            },
        };
        let rule = match operator.changes() {
            true => quote_spanned!(span=> BorrowedAssignment),
            false => quote_spanned!(span=> BorrowedOperator),
        };
        let mark = operator::mark(*operator, span, (generics, left_value, right_value));
        quote_spanned! {span=>
            #[automatically_derived]
            impl #header ::ad::rules::#rule<
                ::ad::rules::operation::#operation, #right_value, ::ad::rules::OfReferences,
            > for #left_value #bounds {
                #body
            }

            #mark
        }
    }
}

/// Leaves out the lifetimes of operands, which are others in the rule.
#[derive(Default)]
struct Elision {
    names: HashSet<Lifetime>,
}

impl Elision {
    /// Takes the lifetime off a reference.
    fn outermost(&mut self, ty: &mut Type) {
        if let Type::Reference(reference) = ty {
            self.names.extend(reference.lifetime.take());
        }
    }

    /// Takes those off that nothing else names.
    fn take_from(&self, generics: &mut Generics, operands: &[Type]) {
        let mut named = HashSet::new();
        let bounds = &generics.where_clause;
        names::collect(quote!(#(#operands)* #bounds), &mut named);
        let kept = generics.params.iter().filter(|parameter| match parameter {
            GenericParam::Lifetime(lifetime) => {
                !self.names.contains(&lifetime.lifetime)
                    || named.contains(&lifetime.lifetime.ident.to_string())
            }
            _ => true,
        });
        generics.params = kept.cloned().collect();
    }
}

impl VisitMut for Elision {
    fn visit_type_reference_mut(&mut self, reference: &mut syn::TypeReference) {
        if reference.lifetime.as_ref().is_some_and(|lifetime| self.names.contains(lifetime)) {
            reference.lifetime = None;
        }
        visit_mut::visit_type_reference_mut(self, reference);
    }
}
