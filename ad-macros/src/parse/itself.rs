//! Methods that return their receiver, `fn scale(&mut self, by: f64) -> &mut Self`.
//!
//! What becomes of the receiver its cotangent tells, which the pullback of every `&mut self` takes and
//! gives. So the derivative is that of a method without a result, but for a mark in its place, and in a
//! chain of such methods each is called on the receiver of the first.

use quote::ToTokens;
use syn::parse::Parse;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, ReceiverKind, ReturnType, Signature, Stmt, Type, parse_quote};

/// Whether a method of `owner` returns a `&mut` to what it takes as one.
pub fn is_returned(signature: &Signature, owner: Option<&Type>) -> bool {
    let takes = signature
        .receiver()
        .is_some_and(|receiver| matches!(receiver.kind, ReceiverKind::Reference(_, _, Some(_))));
    let ReturnType::Type(_, ty) = &signature.output else { return false };
    let Type::Reference(reference) = &**ty else { return false };
    let written = |ty: &Type| ty.to_token_stream().to_string();
    let target = written(&reference.elem);
    takes
        && reference.mutability.is_some()
        && (target == "Self" || owner.is_some_and(|owner| written(owner) == target))
}

/// What stands for the receiver: a type, and its only value.
pub fn mark<T: Parse>() -> T {
    parse_quote!(::ad::rt::CallTheNextMethodInAStatementOfItsOwn)
}

/// Such a method with the mark as its result.
pub fn marked(signature: &Signature) -> Signature {
    let output = ReturnType::Type(Default::default(), Box::new(mark()));
    Signature { output, ..signature.clone() }
}

/// The body of such a method with the mark as its result. Refuses to return anything but the receiver.
pub fn body(block: &Block) -> syn::Result<Block> {
    let mut block = block.clone();
    let mut returns = Returns(Ok(()));
    returns.visit_block_mut(&mut block);
    returns.0?;
    change_block(&mut block)?;
    Ok(block)
}

/// Marks what a method `return`s.
struct Returns(syn::Result<()>);

impl VisitMut for Returns {
    fn visit_expr_return_mut(&mut self, exit: &mut syn::ExprReturn) {
        visit_mut::visit_expr_return_mut(self, exit);
        if let (Ok(()), Some(value)) = (&self.0, &mut exit.expr) {
            self.0 = change(value);
        }
    }

    // Those of closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}

fn change_block(block: &mut Block) -> syn::Result<()> {
    match block.stmts.last_mut() {
        Some(Stmt::Expr(value, None)) => change(value),
        _ => Ok(()),
    }
}

/// Evaluates a value that is the receiver, and gives the mark.
fn change(value: &mut Expr) -> syn::Result<()> {
    match value {
        Expr::Paren(inner) => change(&mut inner.expr),
        Expr::Block(block) if block.label.is_none() => change_block(&mut block.block),
        Expr::If(branch) => {
            change_block(&mut branch.then_branch)?;
            branch.else_branch.as_mut().map_or(Ok(()), |(_, otherwise)| change(otherwise))
        }
        Expr::Match(branch) => branch.arms.iter_mut().try_for_each(|arm| change(&mut arm.body)),
        Expr::Return(_) | Expr::Break(_) | Expr::Continue(_) | Expr::Macro(_) => Ok(()),
        value if is_receiver(value) => {
            *value = mark();
            Ok(())
        }
        value if is_called_on_receiver(value) => {
            let mark: Expr = mark();
            *value = parse_quote!({ #value; #mark });
            Ok(())
        }
        value => Err(syn::Error::new_spanned(
            value,
            "a method that returns `&mut Self` has a derivative where it returns `self`: call what changes it before, and write `self` here",
        )),
    }
}

fn is_receiver(value: &Expr) -> bool {
    matches!(value, Expr::Path(path) if path.path.is_ident("self"))
}

fn is_called_on_receiver(value: &Expr) -> bool {
    match value {
        Expr::MethodCall(call) => {
            is_receiver(&call.receiver) || is_called_on_receiver(&call.receiver)
        }
        _ => false,
    }
}
