//! A rule and the function it differentiates, both on flat lists of scalars.

use ad::rules::NegPullback;
use ad::vector::Xyz;
use ad::{Differentiable, Dual, Real};
use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec3A, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

/// A function of scalars to scalars.
type Primal<S> = Box<dyn Fn(&[S]) -> Vec<S>>;

/// One sibling: from inputs and cotangents of the outputs to outputs and cotangents of the inputs; or from
/// inputs and their tangents to outputs and their tangents.
type Sibling<S> = Box<dyn Fn(&[S], &[S]) -> (Vec<S>, Vec<S>)>;

/// A rule.
pub struct Case<S> {
    pub name: &'static str,
    pub inputs: usize,
    pub outputs: usize,
    /// Moves an input to where the function is smooth, if that is possible.
    pub domain: fn(&mut [f64]) -> bool,
    pub primal: Primal<S>,
    pub vjp: Sibling<S>,
    pub jvp: Sibling<S>,
}

/// A rule whose siblings are called with inputs and the cotangent of the output, and with inputs and
/// their tangents.
pub fn case<S: Real, A: Flat<S>, R: Flat<S>>(
    name: &'static str,
    domain: fn(&mut [f64]) -> bool,
    primal: impl Fn(A) -> R + 'static,
    vjp: impl Fn(A, R) -> (R, A) + 'static,
    jvp: impl Fn(A, A) -> (R, R) + 'static,
) -> Case<S> {
    Case {
        name,
        inputs: A::LEN,
        outputs: R::LEN,
        domain,
        primal: Box::new(move |x| flatten(primal(unflatten(x)))),
        vjp: Box::new(move |x, g| {
            let (value, pulled) = vjp(unflatten(x), unflatten(g));
            (flatten(value), flatten(pulled))
        }),
        jvp: Box::new(move |x, dot| {
            let (value, along) = jvp(unflatten(x), unflatten(dot));
            (flatten(value), flatten(along))
        }),
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

impl<S, T: Flat<S>, const N: usize> Flat<S> for [T; N] {
    const LEN: usize = N * T::LEN;

    fn read(scalars: &mut dyn Iterator<Item = S>) -> Self {
        std::array::from_fn(|_| T::read(scalars))
    }

    fn write(self, scalars: &mut Vec<S>) {
        self.into_iter().for_each(|element| element.write(scalars));
    }
}

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
    Vec3A f32, 3;
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
    Affine2 f32, 6 from_cols_array to_cols_array;
    Affine3 f32, 12 from_cols_array to_cols_array;
    Quat f32, 4 from_array to_array;
    DMat2 f64, 4 from_cols_array to_cols_array;
    DMat3 f64, 9 from_cols_array to_cols_array;
    DMat4 f64, 16 from_cols_array to_cols_array;
    DAffine2 f64, 6 from_cols_array to_cols_array;
    DAffine3 f64, 12 from_cols_array to_cols_array;
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

/// The cases of functions, one a row: its arguments and its result, and where it is smooth. A function without
/// a receiver stands behind its type.
///
/// ```text
/// sinc(a: S) -> S, not_small;
/// [V] splat(a: S) -> V, anywhere;
/// ```
macro_rules! functions {
    ($($([$T:ident])? $name:ident($($x:ident: $X:ty),*) -> $R:ty, $domain:expr;)*) => {
        pastey::paste! { vec![$(
            $crate::rules::case::case(
                concat!($(stringify!($T), "::",)? stringify!($name) $(, " ", stringify!($X))*),
                $domain,
                |functions!(@tuple $($x),*): functions!(@type $($X),*)| -> $R {
                    functions!(@call [$($T)?] $name $($x),*)
                },
                |functions!(@tuple $($x),*), g| {
                    let (value, pullback) = functions!(@call [$($T)?] [<$name _vjp>] $($x),*);
                    (value, pullback(g))
                },
                |functions!(@tuple $($x),*), functions!(@tuple $([<$x _dot>]),*)| {
                    functions!(@call [$($T)?] [<$name _jvp>] $($x,)* $(ad::rt::pass(&[<$x _dot>])),*)
                },
            )
        ),*] }
    };
    (@tuple $x:ident) => { $x };
    (@tuple $($x:ident),*) => { ($($x),*) };
    (@type $X:ty) => { $X };
    (@type $($X:ty),*) => { ($($X),*) };
    (@call [] $name:ident $x:ident $(, $y:expr)*) => { $x.$name($($y),*) };
    (@call [$T:ident] $name:ident $($x:expr),*) => { <$T>::$name($($x),*) };
}

/// The cases of operators, one a row: the types of the operands and of what it makes, and where it is smooth.
macro_rules! operators {
    ($($A:ident $operator:tt $B:ident -> $R:ident, $domain:expr;)*) => {
        vec![$($crate::rules::case::case(
            concat!(stringify!($A), stringify!($operator), stringify!($B)),
            $domain,
            |(a, b): ($A, $B)| -> $R { a $operator b },
            |(a, b), g| (a $operator b, operators!(@pulled $operator a b g $A $B)),
            |(a, b), (a_dot, b_dot)| operators!(@pushed $operator a b a_dot b_dot $A $B),
        )),*]
    };
    (@pulled + $a:ident $b:ident $g:ident $A:ident $B:ident) => {
        <$A as AddPullback<$B>>::add_pullback(&Default::default(), $g)
    };
    (@pulled - $a:ident $b:ident $g:ident $A:ident $B:ident) => {
        <$A as SubPullback<$B>>::sub_pullback(&Default::default(), $g)
    };
    (@pulled * $a:ident $b:ident $g:ident $A:ident $B:ident) => {
        <$A as MulPullback<$B>>::mul_pullback($a, $b, $g)
    };
    (@pulled / $a:ident $b:ident $g:ident $A:ident $B:ident) => {
        <$A as DivPullback<$B>>::div_pullback($a, $b, $g)
    };
    (@pulled % $a:ident $b:ident $g:ident $A:ident $B:ident) => {
        <$A as RemPullback<$B>>::rem_pullback($a, $b, $g)
    };
    (@pushed + $($all:tt)*) => { operators!(@push AddPullback add_jvp $($all)*) };
    (@pushed - $($all:tt)*) => { operators!(@push SubPullback sub_jvp $($all)*) };
    (@pushed * $($all:tt)*) => { operators!(@push MulPullback mul_jvp $($all)*) };
    (@pushed / $($all:tt)*) => { operators!(@push DivPullback div_jvp $($all)*) };
    (@pushed % $($all:tt)*) => { operators!(@push RemPullback rem_jvp $($all)*) };
    (@push $rule:ident $jvp:ident $a:ident $b:ident $a_dot:ident $b_dot:ident $A:ident $B:ident) => {
        <$A as $rule<$B>>::$jvp($a, $b, $a_dot, $b_dot)
    };
}

/// The case of a negative.
pub fn negative<S: Real, A>() -> Case<S>
where
    A: Flat<S> + Copy + NegPullback + Differentiable<Tangent = A> + core::ops::Neg<Output = A>,
{
    case(
        "neg",
        anywhere,
        |a: A| -a,
        |a, g| (-a, A::neg_pullback(&Default::default(), g)),
        |a, a_dot| a.neg_jvp(a_dot),
    )
}

pub(super) use {functions, operators};
