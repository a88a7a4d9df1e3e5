//! Kernels of custom shapes and lights, at every scalar that scenes are computed in.

use std::any::{Any, TypeId, type_name};
use std::fmt;
use std::marker::PhantomData;
use std::sync::Arc;

use ad::lanes::{f32x16, f64x8};
use ad::tape::Var;
use ad::{Additive, Differentiable, Dual, Field, Fields, Tangent, Vec3};
use glam::DVec3;

use super::{Bounded, Emitter, Intersection, Shape};
use crate::number::Number;
use crate::transport::camera::Ray;
use crate::transport::illumination::Illumination;
use crate::transport::shape::{placed_intersection, placed_point};
use crate::transport::surface::SurfacePoint;
use crate::transport::transform::{Transform, place};

/// What takes the cotangents of the numbers of a shape or a light, with their indices.
type ToNumber<'a, S> = dyn FnMut(usize, S) + 'a;

/// A shape at one scalar; `numbers` are those of all its fields.
pub(crate) trait ShapeAt<S: Number>: Send + Sync {
    fn intersect(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
    ) -> Intersection<S>;

    fn point(&self, numbers: &[S::Lane], transform: Transform<S>, ray: Ray<S>) -> SurfacePoint<S>;

    /// The pullback of [`point`](Self::point).
    fn pull_point(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
        cotangent: Tangent<SurfacePoint<S>>,
        to_number: &mut ToNumber<'_, S>,
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>);

    /// The pullback of the margin of [`intersect`](Self::intersect).
    fn pull_margin(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
        cotangent: S,
        to_number: &mut ToNumber<'_, S>,
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>);
}

/// A light at one scalar; `numbers` are those of all its fields.
pub(crate) trait EmitterAt<S: Number>: Send + Sync {
    fn illuminate(&self, numbers: &[S::Lane], point: Vec3<S>) -> Illumination<S>;

    /// The pullback of [`illuminate`](Self::illuminate), which returns the cotangent of the point.
    fn pull_illuminate(
        &self,
        numbers: &[S::Lane],
        point: Vec3<S>,
        cotangent: Tangent<Illumination<S>>,
        to_number: &mut ToNumber<'_, S>,
    ) -> Vec3<S>;
}

/// The kernel of a type `T` of numbers.
struct Kernel<T>(PhantomData<fn() -> T>);

/// The numbers of a type, in every lane.
#[inline]
fn gather<S: Number, T: Fields<f64>>(numbers: &[S::Lane]) -> T::With<S> {
    T::With::from_fn(&mut |index| S::splat(numbers[index]))
}

#[inline]
fn scatter<S, T: Fields<S>>(cotangent: &T, to_number: &mut ToNumber<'_, S>) {
    (0..T::LEN).for_each(|index| to_number(index, cotangent.number(index)));
}

impl<S, T> ShapeAt<S> for Kernel<T>
where
    S: Number,
    T: Fields<f64>,
    T::With<S>: Shape<Scalar = S> + Differentiable<Tangent: Fields<S>> + Copy,
{
    fn intersect(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
    ) -> Intersection<S> {
        placed_intersection::<S, T::With<S>>(gather::<S, T>(numbers), transform, ray)
    }

    fn point(&self, numbers: &[S::Lane], transform: Transform<S>, ray: Ray<S>) -> SurfacePoint<S> {
        placed_point::<S, T::With<S>>(gather::<S, T>(numbers), transform, ray)
    }

    fn pull_point(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
        cotangent: Tangent<SurfacePoint<S>>,
        to_number: &mut ToNumber<'_, S>,
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>) {
        let shape = gather::<S, T>(numbers);
        let (_, pullback) = placed_point::vjp::<S, T::With<S>>(shape, transform, ray);
        let (shape, transform, ray) = pullback(cotangent);
        scatter(&shape, to_number);
        (transform, ray)
    }

    fn pull_margin(
        &self,
        numbers: &[S::Lane],
        transform: Transform<S>,
        ray: Ray<S>,
        cotangent: S,
        to_number: &mut ToNumber<'_, S>,
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>) {
        let shape = gather::<S, T>(numbers);
        let (_, pullback) = placed_intersection::vjp::<S, T::With<S>>(shape, transform, ray);
        let cotangent = Tangent::<Intersection<S>> { margin: cotangent, ..Additive::zero() };
        let (shape, transform, ray) = pullback(cotangent);
        scatter(&shape, to_number);
        (transform, ray)
    }
}

impl<S, T> EmitterAt<S> for Kernel<T>
where
    S: Number,
    T: Fields<f64>,
    T::With<S>: Emitter<Scalar = S> + Differentiable<Tangent: Fields<S>>,
{
    fn illuminate(&self, numbers: &[S::Lane], point: Vec3<S>) -> Illumination<S> {
        gather::<S, T>(numbers).illuminate(point)
    }

    fn pull_illuminate(
        &self,
        numbers: &[S::Lane],
        point: Vec3<S>,
        cotangent: Tangent<Illumination<S>>,
        to_number: &mut ToNumber<'_, S>,
    ) -> Vec3<S> {
        let (_, pullback) = gather::<S, T>(numbers).illuminate_vjp(point);
        let (light, point) = pullback(cotangent);
        scatter(&light, to_number);
        point
    }
}

/// Kernels at every scalar, by the scalar.
#[derive(Clone)]
struct Evaluators {
    by_scalar: Arc<[(TypeId, Box<dyn Any + Send + Sync>)]>,
    /// The type of the numbers.
    of: TypeId,
    name: &'static str,
}

impl Evaluators {
    fn of<T: 'static>(by_scalar: Vec<(TypeId, Box<dyn Any + Send + Sync>)>) -> Self {
        let (of, name) = (TypeId::of::<T>(), type_name::<T>());
        Self { by_scalar: by_scalar.into(), of, name }
    }

    fn get<S: 'static, E: 'static + ?Sized>(&self) -> &E {
        let (_, found) = self
            .by_scalar
            .iter()
            .find(|(scalar, _)| *scalar == TypeId::of::<S>())
            .expect("kernels exist for every scalar that images are computed in");
        found.downcast_ref::<Box<E>>().expect("the kernel of a scalar has its type")
    }
}

impl fmt::Debug for Evaluators {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl PartialEq for Evaluators {
    fn eq(&self, other: &Self) -> bool {
        self.of == other.of
    }
}

/// What evaluates shapes of one type. Kernels of one type are equal.
#[derive(Clone, Debug)]
pub struct ShapeKernel {
    evaluators: Evaluators,
    pub(crate) fields: &'static [Field],
    bounds: fn(&[f64]) -> (DVec3, DVec3),
}

impl PartialEq for ShapeKernel {
    fn eq(&self, other: &Self) -> bool {
        self.evaluators == other.evaluators
    }
}

impl ShapeKernel {
    /// The lowest and the highest corner of a box around a shape that is placed in the world.
    pub(crate) fn bounds(&self, numbers: &[f64], transform: Transform<f64>) -> (DVec3, DVec3) {
        let corners: [DVec3; 2] = (self.bounds)(numbers).into();
        let corner = |index: usize| {
            let side = |axis: usize| corners[index >> axis & 1][axis];
            place::<f64>(transform, DVec3::new(side(0), side(1), side(2)))
        };
        let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        (0..8).map(corner).fold(empty, |(low, high), corner| (low.min(corner), high.max(corner)))
    }

    pub(crate) fn at<S: Number>(&self) -> &dyn ShapeAt<S> {
        self.evaluators.get::<S, dyn ShapeAt<S>>()
    }
}

/// What evaluates lights of one type.
#[derive(Clone, Debug, PartialEq)]
pub struct EmitterKernel {
    evaluators: Evaluators,
    pub(crate) fields: &'static [Field],
}

impl EmitterKernel {
    pub(crate) fn at<S: Number>(&self) -> &dyn EmitterAt<S> {
        self.evaluators.get::<S, dyn EmitterAt<S>>()
    }
}

/// Implements the families for types whose kernels exist at each of these scalars.
macro_rules! families {
    ($($scalar:ty),*) => {
        /// The structs of one shape, over every scalar; implemented for all that have a kernel.
        pub trait ShapeFamily: Fields<f64> + Sized + 'static {
            /// What evaluates these shapes.
            fn kernel() -> ShapeKernel;
        }

        impl<T> ShapeFamily for T
        where
            T: Fields<f64> + Bounded + 'static,
            $(T::With<$scalar>:
                Shape<Scalar = $scalar> + Differentiable<Tangent: Fields<$scalar>> + Copy,)*
        {
            fn kernel() -> ShapeKernel {
                ShapeKernel {
                    evaluators: Evaluators::of::<T>(vec![$((
                        TypeId::of::<$scalar>(),
                        Box::new(Box::new(Kernel::<T>(PhantomData)) as Box<dyn ShapeAt<$scalar>>),
                    )),*]),
                    fields: T::FIELDS,
                    bounds: |numbers| T::from_fn(&mut |index| numbers[index]).bounds(),
                }
            }
        }

        /// The structs of one light, over every scalar; implemented for all that have a kernel.
        pub trait EmitterFamily: Fields<f64> + Sized + 'static {
            /// What evaluates these lights.
            fn kernel() -> EmitterKernel;
        }

        impl<T> EmitterFamily for T
        where
            T: Fields<f64> + 'static,
            $(T::With<$scalar>:
                Emitter<Scalar = $scalar> + Differentiable<Tangent: Fields<$scalar>>,)*
        {
            fn kernel() -> EmitterKernel {
                EmitterKernel {
                    evaluators: Evaluators::of::<T>(vec![$((
                        TypeId::of::<$scalar>(),
                        Box::new(Box::new(Kernel::<T>(PhantomData)) as Box<dyn EmitterAt<$scalar>>),
                    )),*]),
                    fields: T::FIELDS,
                }
            }
        }
    };
}

families!(f32, f32x16, f64, f64x8, Dual<f32>, Dual<f32x16>, Dual<f64>, Dual<f64x8>, Var);
