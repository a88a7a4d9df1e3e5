//! Which variables are certainly a single number: `f32`, `f64`, or of a type parameter `S: Real`.
//!
//! What is a number is known from the types that the user wrote (parameters, annotations), from
//! literals, and from operators and methods of numbers. Both modes of arithmetic on numbers are then
//! written as arithmetic (`x_bar += y_bar * c`, `y_dot = x_dot * c`), as by hand, where it would otherwise go
//! through the traits that stand for all types: the reader sees what happens, the compiler has no
//! obligations to prove, which take most of the time of a large function, and a build without
//! optimisation calls nothing.
//!
//! Where nothing is known (fields, results of calls) the traits remain. A guess is never made: a
//! variable is either of a type that follows from the rules of the language, or unknown. The one
//! name that is taken for what it is elsewhere is that of the trait `Real`.

use std::collections::HashMap;

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::punctuated::Punctuated;
use syn::{
    Expr, ExprPath, GenericParam, Generics, Lit, Token, Type, TypeParamBound, UnOp, WherePredicate,
    parse_quote,
};

use crate::floats;
use crate::ir::{
    Argument, BinaryOperator, Block, Operand, Operation, Place, Projection, Shape, Statement, Var,
    VarId,
};
use crate::lower::Lowered;
use crate::parse::signature::Parameter;
use crate::types::{element, is_discrete, is_float};

/// A type of numbers.
#[derive(Clone, PartialEq, Eq)]
pub enum Number {
    F32,
    F64,
    /// A type parameter that is bounded by `Real`.
    Scalar(Ident),
}

impl Number {
    /// The neutral element of addition.
    pub fn zero(&self) -> TokenStream {
        match self {
            Self::F32 => quote!(-0.0_f32),
            Self::F64 => quote!(-0.0_f64),
            Self::Scalar(name) => quote!(<#name as ::ad::Additive>::zero()),
        }
    }

    /// The type, if there are literals of it.
    fn of_literals(&self) -> Option<Type> {
        match self {
            Self::F32 => Some(parse_quote!(f32)),
            Self::F64 => Some(parse_quote!(f64)),
            Self::Scalar(_) => None,
        }
    }
}

/// The type parameters that are bounded by `Real`.
pub fn scalars(generics: &Generics) -> Vec<Ident> {
    let is_real = |bounds: &Punctuated<TypeParamBound, Token![+]>| {
        bounds.iter().any(|bound| match bound {
            TypeParamBound::Trait(bound) => {
                bound.path.segments.last().is_some_and(|last| last.ident == "Real")
            }
            _ => false,
        })
    };
    let parameters = generics.params.iter().filter_map(|parameter| match parameter {
        GenericParam::Type(ty) if is_real(&ty.bounds) => Some(ty.ident.clone()),
        _ => None,
    });
    let clauses = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let clauses = clauses.filter_map(|predicate| match predicate {
        WherePredicate::Type(bound) if is_real(&bound.bounds) => match &bound.bounded_ty {
            Type::Path(path) if path.qself.is_none() => path.path.get_ident().cloned(),
            _ => None,
        },
        _ => None,
    });
    parameters.chain(clauses).collect()
}

/// What is known of a variable.
#[derive(Clone)]
enum Known {
    /// A type that the user wrote, or a part of one.
    Type(Box<Type>),
    /// A number.
    Value(Value),
    /// An array of what is known.
    Array(Box<Known>),
}

/// What is known of a number.
#[derive(Clone)]
struct Value {
    /// Its type; a literal is of the type of the number it is computed with.
    number: Option<Number>,
    /// Whether it is a constant, finite and not zero.
    is_regular: bool,
}

impl Known {
    /// A number of this type.
    fn number(number: Number) -> Self {
        Self::Value(Value { number: Some(number), is_regular: false })
    }

    /// Its type, if that is a number.
    fn as_number(&self) -> Option<&Number> {
        match self {
            Self::Value(value) => value.number.as_ref(),
            Self::Type(_) | Self::Array(_) => None,
        }
    }

    /// Whether it certainly is `Copy`.
    fn is_copy(&self) -> bool {
        fn is_copy(ty: &Type) -> bool {
            match ty {
                Type::Array(array) => is_copy(&array.elem),
                Type::Tuple(tuple) => tuple.elems.iter().all(is_copy),
                Type::Reference(reference) => reference.mutability.is_none(),
                Type::Paren(paren) => is_copy(&paren.elem),
                ty => is_float(ty) || is_discrete(ty),
            }
        }

        match self {
            Self::Type(ty) => is_copy(ty),
            Self::Value(_) => true,
            Self::Array(element) => element.is_copy(),
        }
    }

    /// Whether no type is known.
    fn is_open(&self) -> bool {
        match self {
            Self::Type(_) => false,
            Self::Value(value) => value.number.is_none(),
            Self::Array(element) => element.is_open(),
        }
    }

    /// The same of a variable that something else may be assigned to.
    fn changing(self) -> Self {
        match self {
            Self::Type(ty) => Self::Type(ty),
            Self::Value(value) => Self::Value(Value { is_regular: false, ..value }),
            Self::Array(element) => Self::Array(Box::new(element.changing())),
        }
    }
}

/// Writes down what is known of numbers. Variables that begin as literals and may change get their types:
/// the compiler would find them by what is assigned later, and calls of methods and of rules come before that.
/// And a number that moves out of a place is a copy.
pub fn write_known(lowered: &mut Lowered, parameters: &[Parameter]) {
    let numbers = Numbers::new(lowered, parameters);
    let known: Vec<_> = (0..lowered.vars.len()).map(|var| numbers.number(var).cloned()).collect();
    write_known_in(&mut lowered.body, &lowered.vars, &known);
}

fn write_known_in(block: &mut Block, vars: &[Var], known: &[Option<Number>]) {
    for statement in &mut block.statements {
        match statement {
            Statement::Define { var, ty, operation: Operation::Use(Operand::Constant(_)) }
                if vars[*var].mutable && ty.is_none() =>
            {
                *ty = known[*var].as_ref().and_then(Number::of_literals);
            }
            Statement::Define { var, operation, .. } if known[*var].is_some() => {
                if let Operation::Clone(place, _) = operation {
                    *operation = Operation::Read(place.clone());
                }
            }
            statement => {
                let blocks = statement.blocks_mut();
                blocks.into_iter().for_each(|block| write_known_in(block, vars, known));
            }
        }
    }
}

/// See the module.
pub struct Numbers<'a> {
    vars: &'a [Var],
    scalars: &'a [Ident],
    known: HashMap<VarId, Known>,
}

impl<'a> Numbers<'a> {
    /// Finds the numbers.
    pub fn new(lowered: &'a Lowered, parameters: &[Parameter]) -> Self {
        let mut numbers =
            Self { vars: &lowered.vars, scalars: &lowered.scalars, known: HashMap::new() };
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
    pub fn number(&self, var: VarId) -> Option<&Number> {
        self.known.get(&var)?.as_number()
    }

    /// Whether a variable certainly is `Copy`.
    pub fn is_copy(&self, var: VarId) -> bool {
        self.known.get(&var).is_some_and(Known::is_copy)
    }

    /// Whether both operands of an operator are numbers.
    pub fn are_numbers(&self, operands: [VarId; 2]) -> bool {
        self.of_both(operands).is_some_and(|known| !known.is_open())
    }

    /// Whether a variable is a constant, finite and not zero.
    pub fn is_regular_constant(&self, var: VarId) -> bool {
        matches!(self.known.get(&var), Some(Known::Value(Value { is_regular: true, .. })))
    }

    /// Whether the way from a variable into it leads through arrays alone, so that its cotangent
    /// has all of their elements.
    pub fn is_in_array(&self, root: VarId, path: &[Projection]) -> bool {
        let Some(mut known) = self.known.get(&root) else { return false };
        let mut path = path.iter();
        let is_element =
            |step: &Projection| matches!(step, Projection::Index(index) if is_index(index));
        while let Known::Array(element) = known {
            match path.next() {
                None => return true,
                Some(step) if is_element(step) => known = element,
                Some(_) => return false,
            }
        }
        let Known::Type(ty) = known else { return path.len() == 0 };
        let mut ty = without_references(ty);
        for step in path {
            match ty {
                Type::Array(array) if is_element(step) => ty = &array.elem,
                _ => return false,
            }
        }
        true
    }

    fn count(&self) -> usize {
        self.known.values().filter(|known| !known.is_open()).count()
    }

    fn know_type(&mut self, var: VarId, ty: &Type) {
        let known = self.of_type(ty);
        self.known.insert(var, known);
    }

    fn of_type(&self, ty: &Type) -> Known {
        match self.named(ty) {
            Some(number) => Known::number(number),
            None => Known::Type(Box::new(ty.clone())),
        }
    }

    /// The number that a type is.
    fn named(&self, ty: &Type) -> Option<Number> {
        match ty {
            Type::Path(path) if path.qself.is_none() => match path.path.get_ident()? {
                name if name == "f32" => Some(Number::F32),
                name if name == "f64" => Some(Number::F64),
                name => self.scalar(name),
            },
            Type::Paren(paren) => self.named(&paren.elem),
            _ => None,
        }
    }

    fn scalar(&self, name: &Ident) -> Option<Number> {
        self.scalars.contains(name).then(|| Number::Scalar(name.clone()))
    }

    fn block(&mut self, block: &Block) {
        for statement in &block.statements {
            match statement {
                Statement::Define { var, ty: Some(ty), .. } => self.know_type(*var, ty),
                Statement::Define { var, ty: None, operation } => {
                    if self.known.get(var).is_none_or(Known::is_open)
                        && let Some(known) = self.result(operation)
                    {
                        let is_constant = !self.vars[*var].mutable;
                        let known = if is_constant { known } else { known.changing() };
                        self.known.insert(*var, known);
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
                            self.known.insert(result, Known::number(number.clone()));
                        }
                    }
                }
                Statement::Loop(a_loop) => self.block(&a_loop.body),
                Statement::Build(build) => self.block(&build.body),
                Statement::Plain { .. }
                | Statement::Destructure { .. }
                | Statement::Keep(_)
                | Statement::Assign { value: Operand::Constant(_), .. } => {}
            }
        }
    }

    /// What began as a literal is of the type of what is assigned to it.
    fn assigned(&mut self, place: &Place, value: VarId) {
        let Some(number) = self.number(value).cloned() else { return };
        let Some(mut known) = self.known.get_mut(&place.root) else { return };
        for step in &place.path {
            match (known, step) {
                (Known::Array(element), Projection::Index(index)) if is_index(index) => {
                    known = element;
                }
                _ => return,
            }
        }
        if let Known::Value(value) = known {
            value.number.get_or_insert(number);
        }
    }

    /// What is known of the result of an operation.
    fn result(&self, operation: &Operation) -> Option<Known> {
        match operation {
            Operation::Use(Operand::Constant(tokens)) => {
                self.constant(&syn::parse2(tokens.clone()).ok()?)
            }
            Operation::Use(Operand::Var(source)) => self.known.get(source).cloned(),
            Operation::Read(place) | Operation::Clone(place, _) => self.part(place),
            Operation::Value(source) => match self.known.get(source)? {
                Known::Type(ty) => self.named(without_references(ty)).map(Known::number),
                known => Some(known.clone()),
            },
            Operation::Negate(value) => self.of_both([*value; 2]),
            Operation::Binary(_, left, right) => self.of_both([*left, *right]),
            Operation::Cast(_, ty) => self.named(ty).map(Known::number),
            Operation::Call { callee, arguments } => {
                let method = callee.method_name()?;
                let receiver = match arguments.first()? {
                    Argument::Receiver(place) => self.part(place)?,
                    Argument::Value(Operand::Var(var)) => self.known.get(var)?.clone(),
                    _ => return None,
                };
                let number = receiver.as_number()?;
                let returns_number = match number {
                    Number::F32 | Number::F64 => floats::returns_number,
                    Number::Scalar(_) => floats::real_returns_number,
                };
                returns_number(&method.to_string()).then(|| Known::number(number.clone()))
            }
            Operation::Repeat { value, is_vec: false, .. } => {
                self.known.get(value).cloned().map(|element| Known::Array(Box::new(element)))
            }
            Operation::Aggregate { shape: Shape::Array, parts, .. } => {
                let mut elements = parts.iter().map(|(_, part)| match part {
                    Operand::Var(part) => self.known.get(part).cloned(),
                    Operand::Constant(tokens) => self.constant(&syn::parse2(tokens.clone()).ok()?),
                });
                let first = elements.next()??;
                let element = elements.try_fold(first, |one, other| combined(&one, &other?))?;
                Some(Known::Array(Box::new(element.changing())))
            }
            Operation::Repeat { .. }
            | Operation::Borrow(_)
            | Operation::Closure(_)
            | Operation::Named { .. }
            | Operation::Aggregate { .. }
            | Operation::UpdateStruct { .. } => None,
        }
    }

    /// What is known of the result of an operator, if its operands are numbers.
    fn of_both(&self, [left, right]: [VarId; 2]) -> Option<Known> {
        combined(self.known.get(&left)?, self.known.get(&right)?)
    }

    /// What is known of a part of a variable.
    fn part(&self, place: &Place) -> Option<Known> {
        let mut known = self.known.get(&place.root)?.clone();
        for step in &place.path {
            known = match (known, step) {
                (Known::Array(element), Projection::Index(index)) if is_index(index) => *element,
                (Known::Type(ty), Projection::Deref) => match *ty {
                    Type::Reference(reference) => self.of_type(&reference.elem),
                    _ => return None,
                },
                (Known::Type(ty), Projection::Index(index)) if is_index(index) => {
                    self.of_type(element(without_references(&ty))?)
                }
                (Known::Type(ty), Projection::Index(index)) if is_range(index) => {
                    let element = element(without_references(&ty))?;
                    Known::Type(Box::new(parse_quote!([#element])))
                }
                _ => return None,
            };
        }
        Some(known)
    }

    /// What a constant tells by itself.
    fn constant(&self, constant: &Expr) -> Option<Known> {
        match constant {
            Expr::Lit(literal) => of_literal(&literal.lit).map(Known::Value),
            Expr::Paren(paren) => self.constant(&paren.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.constant(&unary.expr),
            Expr::Binary(binary) if BinaryOperator::of(&binary.op).is_some() => {
                combined(&self.constant(&binary.left)?, &self.constant(&binary.right)?)
            }
            Expr::Cast(cast) => self.named(&cast.ty).map(Known::number),
            Expr::Repeat(repeat) => {
                Some(Known::Array(Box::new(self.constant(&repeat.expr)?.changing())))
            }
            Expr::Path(path) => {
                let (number, name) = self.associated(path)?;
                let is_regular = ["ONE", "TWO", "HALF", "PI"].iter().any(|regular| name == regular);
                (is_regular || name == "ZERO")
                    .then(|| Known::Value(Value { number: Some(number), is_regular }))
            }
            Expr::Call(call) => {
                let Expr::Path(path) = &*call.func else { return None };
                let (number, name) = self.associated(path)?;
                let is_regular = match call.args.first()? {
                    Expr::Lit(literal) => of_literal(&literal.lit)?.is_regular,
                    _ => false,
                };
                (name == "from_f64")
                    .then(|| Known::Value(Value { number: Some(number), is_regular }))
            }
            _ => None,
        }
    }

    /// The scalar of `S::NAME`, and the name.
    fn associated<'p>(&self, path: &'p ExprPath) -> Option<(Number, &'p Ident)> {
        let segments = &path.path.segments;
        match (path.qself.is_none(), segments.len()) {
            (true, 2) => Some((self.scalar(&segments[0].ident)?, &segments[1].ident)),
            _ => None,
        }
    }
}

/// What is known of the result of an operator between two numbers.
fn combined(left: &Known, right: &Known) -> Option<Known> {
    let (Known::Value(left), Known::Value(right)) = (left, right) else { return None };
    let number = match (&left.number, &right.number) {
        (Some(left), Some(right)) if left != right => return None,
        (Some(number), Some(_)) => Some(number),
        // A literal is of no type parameter: what an operator between the two gives, only the bounds
        // tell.
        (Some(Number::Scalar(_)), None) | (None, Some(Number::Scalar(_))) => return None,
        (Some(number), None) | (None, Some(number)) => Some(number),
        (None, None) => None,
    };
    Some(Known::Value(Value { number: number.cloned(), is_regular: false }))
}

/// Whether an index is that of one element. What is read by one token is an element, since a range
/// of elements cannot be read by value.
fn is_index(index: &TokenStream) -> bool {
    index.clone().into_iter().count() == 1
}

/// Whether an index is that of a part.
fn is_range(index: &TokenStream) -> bool {
    matches!(syn::parse2(index.clone()), Ok(Expr::Range(_)))
}

fn without_references(ty: &Type) -> &Type {
    match ty {
        Type::Reference(reference) => without_references(&reference.elem),
        Type::Paren(paren) => without_references(&paren.elem),
        ty => ty,
    }
}

fn of_literal(literal: &Lit) -> Option<Value> {
    let (number, value) = match literal {
        Lit::Float(literal) => (literal.suffix(), literal.base10_parse::<f32>()),
        // `1f64`
        Lit::Int(literal) if !literal.suffix().is_empty() => {
            (literal.suffix(), literal.base10_parse())
        }
        _ => return None,
    };
    let number = match number {
        "" => None,
        "f32" => Some(Number::F32),
        "f64" => Some(Number::F64),
        _ => return None,
    };
    // What is finite and not zero as an `f32` is so as an `f64`.
    let is_regular = value.is_ok_and(|value| value.is_finite() && value != 0.0);
    Some(Value { number, is_regular })
}
