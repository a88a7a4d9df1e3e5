//! Which variables are certainly a single number, `f32` or `f64`.
//!
//! What is a number is known from the types that the user wrote (parameters, annotations), from
//! literals, and from operators and methods of numbers. Both modes of arithmetic on numbers are then
//! written as arithmetic (`x_bar += y_bar * c`, `y_dot = x_dot * c`), as by hand, where it would otherwise go
//! through the traits that stand for all types: the reader sees what happens, the compiler has no
//! obligations to prove, which take most of the time of a large function, and a build without
//! optimisation calls nothing.
//!
//! Where nothing is known (fields, results of calls, generic scalars) the traits remain. A guess is
//! never made: a variable is either of a type that follows from the rules of the language, or
//! unknown.

use std::collections::HashMap;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;
use syn::{GenericArgument, PathArguments, Type};

use crate::floats;
use crate::ir::{Argument, Block, Operand, Operation, Place, Projection, Statement, Var, VarId};
use crate::lower::Lowered;
use crate::signature::Parameter;

/// A type of numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Number {
    F32,
    F64,
}

impl Number {
    /// The neutral element of addition.
    pub fn zero(self) -> TokenStream {
        match self {
            Self::F32 => quote!(-0.0_f32),
            Self::F64 => quote!(-0.0_f64),
        }
    }
}

/// What is known of a variable.
#[derive(Clone)]
enum Known {
    /// A type that the user wrote, or a part of one.
    Type(Box<Type>),
    /// A number.
    Number(Number),
    /// It was a literal at first, and is of the type of the number it is computed with. Whether it
    /// still is, finite and not zero.
    Literal { is_regular: bool },
}

/// See the module.
pub struct Numbers<'a> {
    vars: &'a [Var],
    known: HashMap<VarId, Known>,
}

impl<'a> Numbers<'a> {
    /// Finds the numbers.
    pub fn new(lowered: &'a Lowered, parameters: &[Parameter]) -> Self {
        let mut numbers = Self { vars: &lowered.vars, known: HashMap::new() };
        for (parameter, lowered) in parameters.iter().zip(&lowered.parameters) {
            numbers.know_type(lowered.var, &parameter.ty);
        }
        // What a loop assigns to a variable may tell the type of what was read from it before.
        loop {
            let count = numbers.count();
            numbers.block(&lowered.body);
            if numbers.count() == count {
                return numbers;
            }
        }
    }

    /// The type of a variable, if that is a number.
    pub fn number(&self, var: VarId) -> Option<Number> {
        match self.known.get(&var)? {
            Known::Number(number) => Some(*number),
            Known::Type(_) | Known::Literal { .. } => None,
        }
    }

    /// Whether both operands of an operator are numbers.
    pub fn are_numbers(&self, operands: [VarId; 2]) -> bool {
        self.of_both(operands).is_some()
    }

    /// Whether a variable is a literal, finite and not zero.
    pub fn is_regular_literal(&self, var: VarId) -> bool {
        matches!(self.known.get(&var), Some(Known::Literal { is_regular: true }))
    }

    /// Whether the way from a variable into it leads through arrays alone, so that its cotangent
    /// has all of their elements.
    pub fn is_in_array(&self, root: VarId, path: &[Projection]) -> bool {
        let Some(Known::Type(ty)) = self.known.get(&root) else { return false };
        let mut ty = without_references(ty);
        for step in path {
            match (step, ty) {
                (Projection::Index(index), Type::Array(array)) if is_index(index) => {
                    ty = &array.elem;
                }
                _ => return false,
            }
        }
        true
    }

    fn count(&self) -> usize {
        self.known.values().filter(|known| !matches!(known, Known::Literal { .. })).count()
    }

    fn know_type(&mut self, var: VarId, ty: &Type) {
        let known = match number(ty) {
            Some(number) => Known::Number(number),
            None => Known::Type(Box::new(ty.clone())),
        };
        self.known.insert(var, known);
    }

    fn block(&mut self, block: &Block) {
        for statement in &block.statements {
            match statement {
                Statement::Define { var, ty: Some(ty), .. } => self.know_type(*var, ty),
                Statement::Define { var, ty: None, operation } => {
                    if self.is_open(*var)
                        && let Some(known) = self.result(operation)
                    {
                        self.known.insert(*var, self.kept(*var, known));
                    }
                }
                Statement::Assign { place, value: Operand::Var(value) }
                | Statement::Update { place, value, .. } => self.assigned(place, *value),
                Statement::Branch(branch) => {
                    for arm in &branch.arms {
                        self.block(&arm.body);
                        if let (Some(result), Operand::Var(value)) =
                            (branch.result, &arm.body.value)
                            && let Some(number) = self.number(*value)
                        {
                            self.known.insert(result, Known::Number(number));
                        }
                    }
                }
                Statement::Loop(a_loop) => self.block(&a_loop.body),
                Statement::Build(build) => self.block(&build.body),
                Statement::Plain { .. }
                | Statement::Destructure { .. }
                | Statement::Assign { value: Operand::Constant(_), .. } => {}
            }
        }
    }

    /// What stays known of a variable, whatever is assigned to it.
    fn kept(&self, var: VarId, known: Known) -> Known {
        match known {
            Known::Literal { .. } if self.vars[var].mutable => Known::Literal { is_regular: false },
            known => known,
        }
    }

    /// Whether no type is known of a variable yet.
    fn is_open(&self, var: VarId) -> bool {
        matches!(self.known.get(&var), None | Some(Known::Literal { .. }))
    }

    /// A variable that began as a literal is of the type of what is assigned to it.
    fn assigned(&mut self, place: &Place, value: VarId) {
        if place.path.is_empty()
            && let Some(Known::Literal { .. }) = self.known.get(&place.root)
            && let Some(number) = self.number(value)
        {
            self.known.insert(place.root, Known::Number(number));
        }
    }

    /// What is known of the result of an operation.
    fn result(&self, operation: &Operation) -> Option<Known> {
        match operation {
            Operation::Use(Operand::Constant(tokens)) => constant(tokens),
            Operation::Use(Operand::Var(source)) => self.known.get(source).cloned(),
            Operation::Read(place) => self.part(place),
            Operation::Value(source) => match self.known.get(source)? {
                Known::Type(ty) => number(without_references(ty)).map(Known::Number),
                known => Some(known.clone()),
            },
            Operation::Negate(value) => self.number(*value).map(Known::Number),
            Operation::Binary(_, left, right) => self.of_both([*left, *right]).map(Known::Number),
            Operation::Cast(_, ty) => number(ty).map(Known::Number),
            Operation::Call { primal, method: true, arguments, .. } => {
                let receiver = match arguments.first()? {
                    Argument::Receiver(place) => self.part(place)?,
                    Argument::Value(Operand::Var(var)) => self.known.get(var)?.clone(),
                    _ => return None,
                };
                let is_known = floats::returns_number(&primal.to_string());
                (is_known && matches!(receiver, Known::Number(_))).then_some(receiver)
            }
            Operation::Repeat { .. }
            | Operation::Borrow(_)
            | Operation::Call { .. }
            | Operation::Closure(_)
            | Operation::Named { .. }
            | Operation::Aggregate { .. }
            | Operation::UpdateStruct { .. } => None,
        }
    }

    /// The type of two operands, if that is a number.
    fn of_both(&self, operands: [VarId; 2]) -> Option<Number> {
        match operands.map(|operand| self.known.get(&operand)) {
            [Some(Known::Number(left)), Some(Known::Number(right))] => {
                (left == right).then_some(*left)
            }
            [Some(Known::Number(number)), Some(Known::Literal { .. })]
            | [Some(Known::Literal { .. }), Some(Known::Number(number))] => Some(*number),
            _ => None,
        }
    }

    /// What is known of a part of a variable.
    fn part(&self, place: &Place) -> Option<Known> {
        let root = self.known.get(&place.root)?;
        if place.path.is_empty() {
            return Some(root.clone());
        }
        let Known::Type(ty) = root else { return None };
        let mut ty = (**ty).clone();
        for step in &place.path {
            ty = match (step, ty) {
                (Projection::Deref, Type::Reference(reference)) => *reference.elem,
                (Projection::Index(index), ty) if is_index(index) => {
                    element(without_references(&ty))?.clone()
                }
                _ => return None,
            };
        }
        Some(number(&ty).map_or(Known::Type(Box::new(ty)), Known::Number))
    }
}

/// Whether an index is that of one element. What is read by one token is an element, since a range
/// of elements cannot be read by value.
fn is_index(index: &TokenStream) -> bool {
    index.clone().into_iter().count() == 1
}

fn without_references(ty: &Type) -> &Type {
    match ty {
        Type::Reference(reference) => without_references(&reference.elem),
        Type::Paren(paren) => without_references(&paren.elem),
        Type::Group(group) => without_references(&group.elem),
        ty => ty,
    }
}

fn number(ty: &Type) -> Option<Number> {
    match ty {
        Type::Path(path) if path.qself.is_none() && path.path.is_ident("f32") => Some(Number::F32),
        Type::Path(path) if path.qself.is_none() && path.path.is_ident("f64") => Some(Number::F64),
        Type::Paren(paren) => number(&paren.elem),
        Type::Group(group) => number(&group.elem),
        _ => None,
    }
}

/// The type of the elements of an array, a slice or a `Vec`.
fn element(ty: &Type) -> Option<&Type> {
    match ty {
        Type::Array(array) => Some(&array.elem),
        Type::Slice(slice) => Some(&slice.elem),
        Type::Path(path) => {
            let last = path.path.segments.last().filter(|last| last.ident == "Vec")?;
            let PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
            match arguments.args.first()? {
                GenericArgument::Type(ty) => Some(ty),
                _ => None,
            }
        }
        _ => None,
    }
}

/// What a constant tells by itself: a literal, or a cast.
fn constant(tokens: &TokenStream) -> Option<Known> {
    let tokens: Vec<_> = tokens.clone().into_iter().collect();
    match &tokens[..] {
        [TokenTree::Literal(value)] => literal(&value.to_string()),
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => {
            constant(&group.stream())
        }
        [TokenTree::Punct(minus), value] if minus.as_char() == '-' => {
            constant(&value.clone().into())
        }
        [value @ .., TokenTree::Ident(cast), TokenTree::Ident(ty)]
            if cast == "as" && value.iter().all(is_part_of_path) =>
        {
            match () {
                () if ty == "f32" => Some(Known::Number(Number::F32)),
                () if ty == "f64" => Some(Known::Number(Number::F64)),
                () => None,
            }
        }
        _ => None,
    }
}

/// Whether the token is none of an operator with two operands.
fn is_part_of_path(token: &TokenTree) -> bool {
    match token {
        TokenTree::Punct(punct) => matches!(punct.as_char(), '.' | ':'),
        TokenTree::Ident(_) | TokenTree::Literal(_) | TokenTree::Group(_) => true,
    }
}

fn literal(text: &str) -> Option<Known> {
    let text = text.replace('_', "");
    if text.ends_with("f32") {
        return Some(Known::Number(Number::F32));
    }
    if text.ends_with("f64") {
        return Some(Known::Number(Number::F64));
    }
    let value: f32 = text.contains(['.', 'e', 'E']).then(|| text.parse().ok())??;
    Some(Known::Literal { is_regular: value.is_finite() && value != 0.0 })
}
