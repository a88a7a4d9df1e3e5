//! A rule and the function it differentiates, both on flat lists of scalars.

use ad::vector::Xyz;
use ad::{Dual, Real};
use glam::{DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use glam::{Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};

/// A function of scalars to scalars.
type Primal<S> = Box<dyn Fn(&[S]) -> Vec<S>>;

/// From inputs and cotangents of the outputs to outputs and cotangents of the inputs.
type Vjp<S> = Box<dyn Fn(&[S], &[S]) -> (Vec<S>, Vec<S>)>;

/// A rule.
pub struct Case<S> {
    pub name: &'static str,
    pub inputs: usize,
    pub outputs: usize,
    /// Moves an input to where the function is smooth, if that is possible.
    pub domain: fn(&mut [f64]) -> bool,
    pub primal: Primal<S>,
    pub vjp: Vjp<S>,
}

/// A rule whose pullback is called by `vjp` with inputs and the cotangent of the output.
pub fn case<S: Real, A: Flat<S>, R: Flat<S>>(
    name: &'static str,
    domain: fn(&mut [f64]) -> bool,
    primal: impl Fn(A) -> R + 'static,
    vjp: impl Fn(A, R) -> (R, A) + 'static,
) -> Case<S> {
    let vjp = move |x: &[S], g: &[S]| {
        let (value, pulled) = vjp(unflatten(x), unflatten(g));
        (flatten(value), flatten(pulled))
    };
    Case {
        name,
        inputs: A::LEN,
        outputs: R::LEN,
        domain,
        primal: Box::new(move |x| flatten(primal(unflatten(x)))),
        vjp: Box::new(vjp),
    }
}

/// The domain of a function that is smooth everywhere.
pub fn anywhere(_: &mut [f64]) -> bool {
    true
}

/// Makes every input positive and not small.
pub fn positive(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x = x.abs() + 0.2);
    true
}

/// No input is small.
pub fn not_small(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x += 0.2_f64.copysign(*x));
    true
}

/// The first half of the inputs keeps its distance from the other half, element by element.
pub fn apart(x: &mut [f64]) -> bool {
    let (a, b) = x.split_at(x.len() / 2);
    a.iter().zip(b).all(|(a, b)| (a - b).abs() > 0.1)
}

/// The elements keep their distance from each other.
pub fn distinct(x: &mut [f64]) -> bool {
    (0..x.len()).all(|i| (0..i).all(|j| (x[i] - x[j]).abs() > 0.1))
}

/// Made of scalars.
pub trait Flat<S>: Sized {
    /// How many.
    const LEN: usize;
    /// Builds it from its scalars.
    fn read(scalars: &mut dyn Iterator<Item = S>) -> Self;
    /// Its scalars.
    fn write(self, scalars: &mut Vec<S>);
}

fn flatten<S, T: Flat<S>>(value: T) -> Vec<S> {
    let mut scalars = Vec::new();
    value.write(&mut scalars);
    scalars
}

fn unflatten<S: Copy, T: Flat<S>>(scalars: &[S]) -> T {
    T::read(&mut scalars.iter().copied())
}

macro_rules! scalars {
    ($($type:ty),*) => {$(
        impl Flat<$type> for $type {
            const LEN: usize = 1;

            fn read(scalars: &mut dyn Iterator<Item = $type>) -> Self {
                scalars.next().unwrap()
            }

            fn write(self, scalars: &mut Vec<$type>) {
                scalars.push(self);
            }
        }
    )*};
}

scalars!(f32, f64, Dual<f64>);

macro_rules! vectors {
    ($($type:ident $scalar:ty, $len:literal;)*) => {$(
        impl Flat<$scalar> for $type {
            const LEN: usize = $len;

            fn read(scalars: &mut dyn Iterator<Item = $scalar>) -> Self {
                Self::from_array(std::array::from_fn(|_| scalars.next().unwrap()))
            }

            fn write(self, scalars: &mut Vec<$scalar>) {
                scalars.extend(self.to_array());
            }
        }
    )*};
}

vectors! {
    Vec2 f32, 2;
    Vec3 f32, 3;
    Vec4 f32, 4;
    DVec2 f64, 2;
    DVec3 f64, 3;
    DVec4 f64, 4;
}

macro_rules! matrices {
    ($($type:ident $scalar:ty, $len:literal $from:ident $to:ident;)*) => {$(
        impl Flat<$scalar> for $type {
            const LEN: usize = $len;

            fn read(scalars: &mut dyn Iterator<Item = $scalar>) -> Self {
                let numbers: [$scalar; $len] = std::array::from_fn(|_| scalars.next().unwrap());
                matrices!(@$from $type numbers)
            }

            fn write(self, scalars: &mut Vec<$scalar>) {
                scalars.extend(self.$to());
            }
        }
    )*};
    (@from_array $type:ident $numbers:ident) => { $type::from_array($numbers) };
    (@from_cols_array $type:ident $numbers:ident) => { $type::from_cols_array(&$numbers) };
}

matrices! {
    Mat2 f32, 4 from_cols_array to_cols_array;
    Mat3 f32, 9 from_cols_array to_cols_array;
    Mat4 f32, 16 from_cols_array to_cols_array;
    Quat f32, 4 from_array to_array;
    DMat2 f64, 4 from_cols_array to_cols_array;
    DMat3 f64, 9 from_cols_array to_cols_array;
    DMat4 f64, 16 from_cols_array to_cols_array;
    DQuat f64, 4 from_array to_array;
}

impl<S: Real> Flat<S> for Xyz<S> {
    const LEN: usize = 3;

    fn read(scalars: &mut dyn Iterator<Item = S>) -> Self {
        let mut next = || scalars.next().unwrap();
        Self { x: next(), y: next(), z: next() }
    }

    fn write(self, scalars: &mut Vec<S>) {
        scalars.extend([self.x, self.y, self.z]);
    }
}

macro_rules! tuples {
    ($(($($name:ident),*))*) => {$(
        impl<S, $($name: Flat<S>),*> Flat<S> for ($($name,)*) {
            const LEN: usize = 0 $(+ $name::LEN)*;

            fn read(scalars: &mut dyn Iterator<Item = S>) -> Self {
                ($($name::read(scalars),)*)
            }

            #[allow(non_snake_case)]
            fn write(self, scalars: &mut Vec<S>) {
                let ($($name,)*) = self;
                $($name.write(scalars);)*
            }
        }
    )*};
}

tuples!((A, B)(A, B, C)(A, B, C, D));

/// A case from the form of its arguments, its value and its pullback.
macro_rules! rule {
    (($name:expr) $domain:expr, ($($x:ident: $type:ty),*) -> $result:ty,
     $primal:expr, |$g:ident| $vjp:expr) => {
        $crate::rules::case::case(
            $name,
            $domain,
            |rule!(@pattern $($x),*): rule!(@type $($type),*)| -> $result { $primal },
            |rule!(@pattern $($x),*): rule!(@type $($type),*), $g: $result| $vjp,
        )
    };
    ($name:literal $($rest:tt)*) => { rule!(($name) $($rest)*) };
    (@pattern $x:ident) => { $x };
    (@pattern $($x:ident),*) => { ($($x),*) };
    (@type $type:ty) => { $type };
    (@type $($type:ty),*) => { ($($type),*) };
}

/// The value and the cotangents of a call of a `_vjp`.
macro_rules! call {
    ($call:expr, $g:expr) => {{
        let (value, pullback) = $call;
        (value, pullback($g))
    }};
}

pub(super) use {call, rule};
