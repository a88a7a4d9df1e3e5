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
use crate::emit::{Differentiated, header};
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
        let [left_tangent, right_tangent] =
            [left_value, right_value].map(|ty| quote!(::ad::Tangent<#ty>));
        let operation = Ident::new(operator.name, span);
        let [rhs, tangent, rhs_tangent] = ["rhs", "tangent", "rhs_tangent"].map(own);
        let (parameters, _, bounds) = generics.split_for_impl();
        let signature::Captured { lifetimes, others } =
            signature::captured(signature, Some(generics), false);
        let captured = quote!(use<#(#lifetimes,)* #(#others),*>);

        let mutability = operator.changes().then(|| quote!(mut));
        let (rule, output, value) = match operator.changes() {
            true => (
                quote_spanned!(span=> BorrowedAssignment),
                None,
                quote!(fn assign(&mut self, #rhs: &#right_value)),
            ),
            false => (
                quote_spanned!(span=> BorrowedOperator),
                Some(quote!(type Output = #result;)),
                quote!(fn value(&self, #rhs: &#right_value) -> #result),
            ),
        };
        let (cotangents, pushed) = match operator.changes() {
            true => (quote!((), #left_tangent), quote!(())),
            false => (quote!(::ad::Tangent<#result>), quote!(::ad::Tangent<#result>)),
        };
        let (method, values) = (&signature.ident, self.given(&quote!(self), &rhs));
        let [back, along] = match differentiated {
            Some(differentiated) => self.sweeps(differentiated, &values),
            None => self.refused(),
        };
        let lints = header::lints();
        let mark = operator::mark(*operator, span, (generics, left_value, right_value));
        quote_spanned! {span=>
            #[automatically_derived]
            impl #parameters ::ad::rules::#rule<
                ::ad::rules::operation::#operation, #right_value, ::ad::rules::OfReferences,
            > for #left_value #bounds {
                #output

                #lints
                #[inline]
                #value {
                    <#left as #path>::#method(#(#values),*)
                }

                #lints
                #[inline]
                fn vjp(&#mutability self, #rhs: &#right_value) -> (
                    #result,
                    impl ::core::ops::FnOnce(#cotangents) -> (#left_tangent, #right_tangent)
                        + #captured,
                ) {
                    #back
                }

                #lints
                #[inline]
                fn jvp(
                    &#mutability self,
                    #rhs: &#right_value,
                    #tangent: &#mutability #left_tangent,
                    #rhs_tangent: &#right_tangent,
                ) -> (#result, #pushed) {
                    #along
                }
            }

            #mark
        }
    }

    /// The operands as the operator takes them, or their tangents: what it takes by value is a copy.
    fn given(&self, left: &TokenStream, right: &Ident) -> Vec<TokenStream> {
        let given = |ty: &Type, value: TokenStream| match ty {
            Type::Reference(_) => value,
            _ => quote!(::core::clone::Clone::clone(#value)),
        };
        let left = match self.operator.changes() {
            true => left.clone(),
            false => given(&self.operands[0], left.clone()),
        };
        match self.operator.kind {
            Kind::Unary => vec![left],
            _ => vec![left, given(&self.operands[1], quote!(#right))],
        }
    }

    /// The bodies of `vjp` and `jvp`.
    fn sweeps(&self, differentiated: &Differentiated, values: &[TokenStream]) -> [TokenStream; 2] {
        let Differentiated { names, vjp, tangents: dots, jvp } = differentiated;
        let operands = quote!(let (#(#names,)*) = (#(#values,)*););
        let [value, pullback, cotangent, tangent, rhs_tangent] =
            ["value", "pullback", "cotangent", "tangent", "rhs_tangent"].map(own);
        let back = match self.operator.kind {
            Kind::Unary => quote! {
                let (#value, #pullback) = #vjp;
                (#value, move |#cotangent| (#pullback(#cotangent), ()))
            },
            _ => vjp.clone(),
        };
        let tangents = self.given(&quote!(#tangent), &rhs_tangent);
        [quote!(#operands #back), quote!(#operands let (#(#dots,)*) = (#(#tangents,)*); #jvp)]
    }

    /// What stands in place of these bodies where there are errors in them.
    fn refused(&self) -> [TokenStream; 2] {
        let refused = quote! {
            fn refused<T>() -> T {
                ::core::unreachable!()
            }
        };
        let pullback = match self.operator.changes() {
            true => quote!(|_, _| refused()),
            false => quote!(|_| refused()),
        };
        [quote!(#refused (refused(), #pullback)), quote!(#refused refused())]
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
