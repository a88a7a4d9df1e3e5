//! What stands in the parentheses of `#[differentiable(..)]`.

use proc_macro2::Ident;
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Meta, Path, Token};

/// The arguments of the attribute.
#[derive(Clone, Default)]
pub struct Options {
    /// `checkpoint`: the pullback keeps the arguments alone.
    pub checkpoint: bool,
    /// `boxed`: the pullback is a boxed closure, whose type does not hold those of the pullbacks it
    /// calls.
    pub boxed: bool,
    /// `borrows`: the pullback may hold on to what references among the parameters refer to.
    pub borrows: bool,
    /// `vjp = path`: the function that is the derivative, written by hand.
    pub vjp: Option<Path>,
    /// `jvp = path`: the function that is the forward mode, written by hand.
    pub jvp: Option<Path>,
    /// `reverse`: there is no forward mode.
    pub reverse: bool,
}

impl Parse for Options {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Self::default();
        while !input.is_empty() {
            let name: Ident = input.parse()?;
            match () {
                () if name == "borrows" => options.borrows = true,
                () if name == "checkpoint" => options.checkpoint = true,
                () if name == "boxed" => options.boxed = true,
                () if name == "vjp" => {
                    input.parse::<Token![=]>()?;
                    options.vjp = Some(input.parse()?);
                }
                () if name == "jvp" => {
                    input.parse::<Token![=]>()?;
                    options.jvp = Some(input.parse()?);
                }
                () if name == "reverse" => options.reverse = true,
                () => {
                    return Err(syn::Error::new_spanned(
                        name,
                        "the arguments of `#[differentiable]` are: `borrows`, `boxed`, `checkpoint`, `reverse`, `vjp = path`, `jvp = path`",
                    ));
                }
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(options)
    }
}

impl Options {
    /// Refuses rules: several functions, or a loop, have none in common.
    pub fn without_rules(&self) -> syn::Result<()> {
        match self.vjp.as_ref().or(self.jvp.as_ref()) {
            None => Ok(()),
            Some(rule) => Err(syn::Error::new_spanned(
                rule,
                "a rule is that of one function: put it on the function or the method whose derivative it is",
            )),
        }
    }

    /// These, and those of the attribute on a method of the `impl` block that has these.
    pub fn with(&self, own: Self) -> Self {
        Self {
            checkpoint: self.checkpoint || own.checkpoint,
            boxed: self.boxed || own.boxed,
            borrows: self.borrows || own.borrows,
            vjp: own.vjp,
            jvp: own.jvp,
            reverse: self.reverse || own.reverse,
        }
    }
}

/// Whether an attribute is this crate's.
pub fn is_own(attribute: &Attribute) -> bool {
    attribute.path().segments.last().is_some_and(|last| last.ident == "differentiable")
}

/// What this crate's attributes say among those of a method or a loop.
pub fn own_options(attributes: &[Attribute]) -> syn::Result<Options> {
    let mut options = Options::default();
    for attribute in attributes.iter().filter(|attribute| is_own(attribute)) {
        if let Meta::List(list) = &attribute.meta {
            options = options.with(list.parse_args()?);
        }
    }
    Ok(options)
}
