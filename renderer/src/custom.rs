//! Shapes and lights of one's own.
//!
//! Each is a struct of named numbers, generic over its scalar, and one `#[differentiable]` kernel; a
//! shape says also in which box it lies. The numbers are parameters like any others
//! (`shape.NAME.FIELD`, `light.NAME.FIELD`), shapes stand in the acceleration structure beside
//! triangles, and the kernels run on lanes. The pullbacks are those that the attribute writes.
//!
//! ```
//! use ad::vector::{Vector, Vector3};
//! use ad::{Differentiable, Fields, Real, Vec3, differentiable};
//! use glam::DVec3;
//! use renderer::custom::{Bounded, Intersection, Shape};
//! use renderer::transport::camera::Ray;
//!
//! /// A disc that faces along z.
//! #[derive(Clone, Copy, Debug, Differentiable, Fields)]
//! struct Disc<S: Real> {
//!     center: Vec3<S>,
//!     radius: S,
//! }
//!
//! #[differentiable]
//! impl<S: Real> Shape for Disc<S> {
//!     type Scalar = S;
//!
//!     fn intersect(self, ray: Ray<S>) -> Intersection<S> {
//!         let distance = (self.center.z() - ray.origin.z()) / ray.direction.z();
//!         let offset = ray.origin + ray.direction * distance - self.center;
//!         let margin = self.radius * self.radius - offset.length_squared();
//!         let normal = <Vec3<S>>::new(S::ZERO, S::ZERO, S::ONE);
//!         Intersection { distance, normal, margin }
//!     }
//! }
//!
//! impl Bounded for Disc<f64> {
//!     fn bounds(&self) -> (DVec3, DVec3) {
//!         let reach = DVec3::new(self.radius, self.radius, 0.0);
//!         (self.center - reach, self.center + reach)
//!     }
//! }
//! ```
//!
//! A scene holds the numbers; what evaluates the kernel at each scalar is made once, for a
//! [`ShapeKernel`]. Turned down: trait objects that hold the numbers themselves (every scene that is
//! cloned would clone them through a method of their own), and a type parameter of the scene (every
//! function that takes a scene would have to name it).

use std::any::{Any, TypeId, type_name};
use std::fmt;
use std::marker::PhantomData;
use std::sync::Arc;

use ad::lanes::{f32x8, f32x16, f64x8};
use ad::tape::Var;
use ad::vector::Vector;
use ad::{Differentiable, Dual, Field, Fields, Real, Tangent, Vec3, differentiable, select};
use glam::DVec3;

use crate::number::Number;
use crate::transport::camera::Ray;
use crate::transport::hit::SurfacePoint;
use crate::transport::light::Illumination;
use crate::transport::transform::{Transform, place, rotate, unplace};

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Intersection<S: Real> {
    /// The distance to the first point above 0.
    pub distance: S,
    /// The normal there, of any length above 0 and on either side.
    pub normal: Vec3<S>,
    /// A number that is positive where the ray meets the shape, and falls to zero as it comes to its
    /// silhouette: a discriminant, or the distance to a border. Where it is negative, distance and
    /// normal do not count, but should be finite: take the square root of `max(discriminant, 0)`.
    pub margin: S,
}

/// A shape: the numbers `self`, and where rays meet it.
#[differentiable]
pub trait Shape {
    /// The scalar of the numbers.
    type Scalar: Real;

    /// Where a ray meets the shape first. A shape that has no point on the ray has a negative margin, or
    /// a distance that is not above 0.
    fn intersect(self, ray: Ray<Self::Scalar>) -> Intersection<Self::Scalar>;
}

/// The box around a shape.
pub trait Bounded {
    /// The lowest and the highest corner of a box that holds the shape.
    fn bounds(&self) -> (DVec3, DVec3);
}

/// A light that reaches every point from one direction: the numbers `self`, and what it brings.
#[differentiable]
pub trait Emitter {
    /// The scalar of the numbers.
    type Scalar: Real;

    /// The illumination of a point, if nothing is between them. Points are in the coordinates of the
    /// scene, in the precision of the scalar.
    fn illuminate(self, point: Vec3<Self::Scalar>) -> Illumination<Self::Scalar>;
}

/// Where a ray meets a shape that is placed in the world. The shape meets the ray in its own
/// coordinates, where lengths and normals differ by the scale.
#[differentiable]
#[inline]
fn placed_intersection<S: Real, T: Shape<Scalar = S> + Differentiable + Copy>(
    shape: T,
    transform: Transform<S>,
    ray: Ray<S>,
) -> Intersection<S> {
    let inverse = transform.scale.recip();
    let origin = unplace::<S>(transform, ray.origin);
    let direction = rotate::<S>(-transform.rotation, ray.direction) * inverse;
    let length_recip = direction.length_recip();
    let found = shape.intersect(Ray { origin, direction: direction * length_recip });
    Intersection {
        distance: found.distance * length_recip,
        normal: rotate::<S>(transform.rotation, found.normal * inverse),
        margin: found.margin,
    }
}

/// The surface point where a ray meets a shape that is placed in the world.
#[differentiable]
#[inline]
fn placed_point<S: Real, T: Shape<Scalar = S> + Differentiable + Copy>(
    shape: T,
    transform: Transform<S>,
    ray: Ray<S>,
) -> SurfacePoint<S> {
    let found = placed_intersection::<S, T>(shape, transform, ray);
    let normal = found.normal.normalize();
    let behind = normal.dot(ray.direction).cmpgt(S::ZERO);
    SurfacePoint {
        point: ray.origin + ray.direction * found.distance,
        normal: select(behind, -normal, normal),
        view: -ray.direction,
    }
}

/// What takes the cotangents of the numbers of a shape or a light, with their indices.
pub(crate) type ToNumber<'a, S> = dyn FnMut(usize, S) + 'a;

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
                let by_scalar: Vec<(TypeId, Box<dyn Any + Send + Sync>)> = vec![$((
                    TypeId::of::<$scalar>(),
                    Box::new(Box::new(Kernel::<T>(PhantomData)) as Box<dyn ShapeAt<$scalar>>),
                )),*];
                ShapeKernel {
                    evaluators: Evaluators {
                        by_scalar: by_scalar.into(),
                        of: TypeId::of::<T>(),
                        name: type_name::<T>(),
                    },
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
                let by_scalar: Vec<(TypeId, Box<dyn Any + Send + Sync>)> = vec![$((
                    TypeId::of::<$scalar>(),
                    Box::new(Box::new(Kernel::<T>(PhantomData)) as Box<dyn EmitterAt<$scalar>>),
                )),*];
                EmitterKernel {
                    evaluators: Evaluators {
                        by_scalar: by_scalar.into(),
                        of: TypeId::of::<T>(),
                        name: type_name::<T>(),
                    },
                    fields: T::FIELDS,
                }
            }
        }
    };
}

families!(
    f32,
    f32x8,
    f32x16,
    f64,
    f64x8,
    Dual<f32>,
    Dual<f32x8>,
    Dual<f32x16>,
    Dual<f64>,
    Dual<f64x8>,
    Var
);
