//! What traces the rays of a scene.

use std::sync::Arc;

use ad::{Fields, Real, Scalar};
use glam::{DVec3, Vec3};

use super::inputs::{self, Inputs, LightInputs, ShapeInputs};
use super::varying::Varying;
use crate::number::{Number, widen};
use crate::scene::{Scene, Sphere};
use crate::settings::{PrimaryVisibility, Settings};
use crate::trace::bvh::{BuildQuality, Bvh, CustomShape, PacketHits, PacketVectors, Shape, Shapes};
use crate::trace::layout::{Kind, Layout};
use crate::trace::raster::Raster;
use crate::trace::tile::Tile;
use crate::transport::camera::Ray;
use crate::transport::illumination::Illumination;
use crate::transport::light::{Light, match_light};

/// The acceleration structure of a scene, and where its camera and its lights are. Everything is
/// relative to the origin of the inputs that it is made of.
pub struct Tracer {
    /// Shared with what traces the same geometry in other light.
    pub bvh: Arc<Bvh>,
    pinhole: DVec3,
    /// In double precision: shadow rays start exactly at lights.
    lights: Vec<LightInputs<f64>>,
    /// Whether, and from where, primitives are rasterised instead of being found by rays.
    raster: Option<Raster>,
}

impl Tracer {
    pub fn new<S: Number<Lane: Scalar>>(
        scene: &Scene,
        settings: &Settings,
        layout: &Layout,
        inputs: &Inputs<S>,
        bvh: Arc<Bvh>,
    ) -> Self {
        let (pinhole, lights) = (DVec3::ZERO, Vec::new());
        let mut tracer = Self { bvh, pinhole, lights, raster: None };
        tracer.update(scene, settings, layout, inputs);
        tracer
    }

    /// An acceleration structure of nothing, as a scene needs it.
    pub fn bvh_of_nothing(settings: &Settings, layout: &Layout) -> Bvh {
        // Paths have so many rays that a better hierarchy pays for itself.
        let least = match layout.path_tracing {
            Some(_) => BuildQuality::Medium,
            None => BuildQuality::Low,
        };
        match settings.visibility {
            PrimaryVisibility::BruteForce => Bvh::list(&[]),
            PrimaryVisibility::Bvh | PrimaryVisibility::Raster => {
                Bvh::with_quality(&[], settings.build_quality.max(least))
            }
        }
    }

    /// Takes over where geometry has moved to.
    pub fn update_geometry<S: Number<Lane: Scalar>>(
        &mut self,
        scene: &Scene,
        layout: &Layout,
        inputs: &Inputs<S>,
    ) {
        let customs = &customs(scene, inputs.origin);
        Arc::make_mut(&mut self.bvh).update(&Geometry { layout, inputs, customs });
    }

    /// Takes over where camera and lights are.
    pub fn update<S: Number<Lane: Scalar>>(
        &mut self,
        scene: &Scene,
        settings: &Settings,
        layout: &Layout,
        inputs: &Inputs<S>,
    ) {
        self.lights = inputs::lights(scene, layout, inputs.origin, &Varying::NONE);
        let shining = inputs.shining::<f64>(layout, |number| number.to_f64());
        self.lights.extend(shining.map(LightInputs::Shining));
        self.look(scene, settings, layout, inputs);
    }

    /// Takes over what the scene is seen through.
    pub fn look<S: Number<Lane: Scalar>>(
        &mut self,
        scene: &Scene,
        settings: &Settings,
        layout: &Layout,
        inputs: &Inputs<S>,
    ) {
        let origin = inputs.origin;
        let frame = inputs::frame::<f64>(scene, origin, &Varying::NONE);
        self.pinhole = frame.origin;
        if settings.visibility == PrimaryVisibility::Raster {
            let geometry = Geometry { layout, inputs, customs: &customs(scene, origin) };
            self.raster = Some(Raster::new(&geometry, &frame, layout.width, layout.height));
        }
    }

    /// The position of a light, if it has one from which its rays all start.
    pub fn position(&self, light: usize) -> Option<DVec3> {
        match &self.lights[light] {
            LightInputs::Known { light, place } => light.position(*place),
            LightInputs::Shining(_) | LightInputs::Custom { .. } => None,
        }
    }

    /// A light in some arithmetic, if its kind is known.
    pub fn known<S: Real>(&self, light: usize) -> Option<Light<S>> {
        let LightInputs::Known { light, .. } = &self.lights[light] else { return None };
        Some(match_light!(light, light => Variant(light.map(S::from_f64))))
    }

    /// The illumination of a point by a light, if nothing is between them.
    pub fn illuminate(&self, light: usize, point: DVec3) -> Illumination<f64> {
        self.lights[light].illuminate(point)
    }

    /// Finds what wanted camera rays hit first: those of a tile, or any.
    #[inline]
    pub fn primary(
        &self,
        tile: Option<&Tile>,
        directions: &PacketVectors,
        wanted: u64,
        hits: &mut PacketHits,
    ) {
        let origin = self.pinhole.as_vec3();
        match self.raster.as_ref().zip(tile) {
            None => self.bvh.nearest_packet_into(origin, directions, wanted, hits),
            Some((raster, tile)) => raster.nearest_into(tile, origin, directions, wanted, hits),
        }
    }
}

/// The shapes of one's own, relative to an origin.
fn customs(scene: &Scene, origin: DVec3) -> Vec<Arc<dyn CustomShape>> {
    let shapes = inputs::shapes::<f64>(scene, origin, &Varying::NONE);
    shapes.into_iter().map(|shape| Arc::new(shape) as Arc<dyn CustomShape>).collect()
}

/// The primitives as traversal takes them: the triangles, then the spheres, then the shapes of one's
/// own.
struct Geometry<'a, S: Number> {
    layout: &'a Layout,
    inputs: &'a Inputs<S>,
    customs: &'a [Arc<dyn CustomShape>],
}

impl<S: Number<Lane: Scalar>> Shapes for Geometry<'_, S> {
    fn count(&self) -> usize {
        self.layout.material_of.len()
    }

    #[inline]
    fn shape(&self, index: u32) -> Shape {
        let Inputs { vertices, spheres, .. } = self.inputs;
        match self.layout.kind_of(index as usize) {
            (Kind::Triangle, index) => {
                let corner = |vertex: u32| widen::<S::Lane>(vertices[vertex as usize]).as_vec3();
                Shape::Triangle(self.layout.triangles[index].map(corner))
            }
            (Kind::Sphere, index) => {
                let Sphere { center, radius, .. } = spheres[index];
                Shape::Sphere(widen::<S::Lane>(center).as_vec3(), radius.to_f64() as f32)
            }
            (Kind::Custom, index) => Shape::Custom(self.customs[index].clone()),
        }
    }
}

impl CustomShape for ShapeInputs<f64> {
    fn bounds(&self) -> (Vec3, Vec3) {
        let (low, high) = self.kernel.bounds(&self.numbers, self.transform);
        (low.as_vec3(), high.as_vec3())
    }

    fn distance(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let (origin, direction) = (origin.as_dvec3(), direction.as_dvec3());
        let length = direction.length();
        let ray = Ray { origin, direction: direction / length };
        let found = self.kernel.at::<f64>().intersect(&self.numbers, self.transform, ray);
        let is_hit = found.margin >= 0.0 && found.distance > 0.0;
        is_hit.then_some((found.distance / length) as f32)
    }
}
