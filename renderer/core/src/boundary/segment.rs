//! Paths from the camera to rays along edges.

use std::f64::consts::TAU;

use glam::DVec3;

use super::contours::{Contour, Contours, Target, on_sphere};
use crate::edges::{Edge, Geometry, Met};
use crate::primal::known::KnownHit;
use crate::primal::shadow::SURFACE_ERROR;
use crate::scene::PathTracing;
use crate::trace::emitters::Emitters;
use crate::trace::layout::Kind;
use crate::trace::random::path_numbers;
use crate::trace::sampling::hash;
use crate::transport::camera::{CameraFrame, Ray, film_point};
use crate::transport::emitter::{barycentric_of, triangle_spread};
use crate::transport::environment::{direction_of, map_coordinates};

/// How far beside an edge it is asked what is seen there, as a part of the distance.
const ASIDE: f64 = 1e-4;

/// A way to draw rays along edges.
#[derive(Clone, Copy, PartialEq)]
pub enum Way {
    /// In all directions.
    Evenly,
    /// Towards surfaces and parts of the environment that shine.
    TowardsEmitters,
    /// Towards lights.
    TowardsLights,
}

/// How far a tangent is followed before it may meet its sphere again, in radii.
const LEAVING: f64 = 1e-3;

/// How often a ray is sent on that meets what it has just left.
const TRIES: u32 = 6;

/// A path from the camera to a ray along an edge.
pub struct Segment {
    /// Where it begins, with the coordinates of [`film_point`].
    pub film: [f64; 2],
    pub pixel: usize,
    /// The surface points that it comes by, from the camera on.
    pub points: Vec<DVec3>,
    /// The places that it goes on to: against the normal of the edge, and along it.
    pub targets: [DVec3; 2],
    pub edges: Vec<Edge>,
    /// By what it sends on of a jump of the radiance beyond the edge: the derivative of the pixel by the number of each
    /// edge, but for the density of rays.
    pub weight: f64,
    /// One over the density of rays that are drawn evenly.
    pub even: f64,
    pub source: Source,
    /// Tells random choices apart.
    pub seed: u32,
}

/// How a ray along an edge was drawn.
#[derive(Clone, Copy, PartialEq)]
pub enum Source {
    Evenly,
    /// Towards what shines: a primitive, or the environment.
    Emitter(Option<u32>),
    /// Towards a light, which shines on this side and brings what counts for the density of rays.
    Light {
        light: usize,
        side: usize,
        irradiance: DVec3,
    },
}

/// Draws such paths.
#[derive(Clone, Copy)]
pub struct Sampler<'a> {
    pub geometry: &'a Geometry<'a>,
    pub contours: &'a Contours<'a>,
    pub emitters: &'a Emitters,
    pub lights: usize,
    pub seed: u32,
    pub limits: PathTracing,
    /// Whether the edges of direct light on what the camera sees are known otherwise.
    pub knows_direct: bool,
    /// How many are drawn one after the other.
    pub chunk: u32,
    /// How often each way of drawing rays is used.
    pub count: u32,
}

impl<'a> Sampler<'a> {
    /// The path of an index that is drawn in one of three ways: evenly, towards what shines, or towards lights. Nothing
    /// if the camera does not see its end.
    pub fn draw(&self, way: Way, index: u32) -> Option<(Segment, Contour<'a>)> {
        let seed = self.seed_of(way);
        let [choice, along, u, v] = path_numbers(index, 0, seed);
        let [fine, depth, emitter, fine_emitter] = path_numbers(index, 1, seed);
        let [choice, emitter] = [exact(choice, fine), exact(emitter, fine_emitter)];
        let (contour, source) = match way {
            Way::Evenly => (self.evenly(index)?, Source::Evenly),
            Way::TowardsEmitters => {
                let (primitive, target) = self.emitter(emitter, [u, v])?;
                let contour = self.contours.towards(choice, along, target)?;
                let shines = primitive.is_none_or(|primitive| {
                    !contour.is_of(primitive) && self.shows(primitive, target, contour.point)
                });
                (shines.then_some(contour)?, Source::Emitter(primitive))
            }
            Way::TowardsLights => self.towards_light(choice, along, emitter)?,
        };
        let least = match way {
            Way::Evenly => 1,
            Way::TowardsEmitters if !self.knows_direct => 1,
            _ => 2,
        };
        let (surfaces, times) = self.surfaces(least, depth)?;
        let mut segment = self.path(&contour, source, surfaces, (index, seed))?;
        segment.weight = segment.weight * times * contour.slope / f64::from(self.count);
        Some((segment, contour))
    }

    fn seed_of(&self, way: Way) -> u32 {
        hash(self.seed ^ hash(way as u32))
    }

    /// The ray along an edge of the path of an index that is drawn evenly.
    pub fn evenly(&self, index: u32) -> Option<Contour<'a>> {
        let seed = self.seed_of(Way::Evenly);
        let [choice, along, u, v] = path_numbers(index, 0, seed);
        let [fine, ..] = path_numbers(index, 1, seed);
        self.contours.evenly(exact(choice, fine), [along, u, v])
    }

    /// How many surfaces a path comes by, and one over the probability: half of them one more than the others.
    fn surfaces(&self, least: u32, mut number: f64) -> Option<(u32, f64)> {
        let (mut surfaces, mut times) = (least, 1.0);
        // The last piece of a path leads beyond the edge.
        let most = self.limits.max_depth.saturating_sub(1);
        while surfaces < most {
            times *= 2.0;
            if number < 0.5 {
                break;
            }
            number = 2.0 * number - 1.0;
            surfaces += 1;
        }
        (least <= most).then_some((surfaces, times))
    }

    /// A place that shines, and the primitive that it is on.
    fn emitter(&self, choice: f64, numbers: [f64; 2]) -> Option<(Option<u32>, Target)> {
        let layout = self.geometry.layout;
        let (primitive, _) = self.emitters.choose(choice);
        if let Some(rank) = primitive.checked_sub(layout.material_of.len() as u32) {
            let sky = layout.sky.as_ref()?;
            let place = sky.place(sky.cell(rank), numbers);
            return Some((None, Target::Direction(direction_of::<f64>(place))));
        }
        let point = match layout.kind_of(primitive as usize) {
            (Kind::Triangle, index) => {
                let triangle = self.geometry.triangle(index);
                let [a, b, c] = barycentric_of::<f64>(numbers);
                triangle.a * a + triangle.b * b + triangle.c * c
            }
            (_, index) => {
                let sphere = self.geometry.sphere(index);
                sphere.center + on_sphere(numbers) * sphere.radius
            }
        };
        Some((Some(primitive), Target::Point(point)))
    }

    /// Whether a point of a primitive is on the side that a place sees: not on the far side of a sphere.
    fn shows(&self, primitive: u32, target: Target, place: DVec3) -> bool {
        let (Target::Point(point), (Kind::Sphere, index)) =
            (target, self.geometry.layout.kind_of(primitive as usize))
        else {
            return true;
        };
        let sphere = self.geometry.sphere(index);
        let is_inside = place.distance(sphere.center) < sphere.radius;
        is_inside || (point - sphere.center).dot(place - point) > 0.0
    }

    /// What a ray through a place towards an emitter counts for in solid angle, if rays are drawn towards all that
    /// shines: where it meets a primitive, or the environment.
    pub fn spread(&self, ray: Ray<f64>, met: Option<KnownHit>) -> (f64, f64) {
        let layout = self.geometry.layout;
        let Some(known) = met else {
            let spread = layout.sky.as_ref().map_or(f64::INFINITY, |sky| {
                let at = map_coordinates::<f64>(0.0, ray.direction);
                let (rank, row) = sky.rank_at([at.u, at.v]);
                let cell = layout.material_of.len() as u32 + rank;
                self.emitters.choices(cell) * sky.solid_angle(row)
            });
            return (f64::INFINITY, spread);
        };
        let choices = self.emitters.choices(known.primitive);
        let met = self.geometry.meet(&known, ray);
        let distance = met.surface.point.distance(ray.origin);
        let spread = match layout.kind_of(known.primitive as usize) {
            (Kind::Triangle, index) => {
                let triangle = self.geometry.triangle(index);
                triangle_spread::<f64>(triangle, choices, ray.direction, distance)
            }
            (_, index) => {
                let sphere = self.geometry.sphere(index);
                let seen = sphere.radius / distance;
                2.0 * TAU * seen * seen * met.outward.dot(ray.direction).abs() * choices
            }
        };
        (distance, spread)
    }

    /// A ray through an edge towards one of the lights.
    fn towards_light(&self, choice: f64, along: f64, light: f64) -> Option<(Contour<'a>, Source)> {
        let tracer = self.geometry.tracer;
        let light = ((light * self.lights as f64) as usize).min(self.lights.checked_sub(1)?);
        let target = match (tracer.position(light), tracer.known::<f64>(light)) {
            (Some(position), _) => Target::Point(position),
            (None, Some(_)) => Target::Direction(tracer.illuminate(light, DVec3::ZERO).direction),
            (None, None) => return None,
        };
        let contour = self.contours.towards(choice, along, target)?;
        let side = contour.lit_side()?;
        if self.geometry.is_transparent(contour.primitive()) {
            return None;
        }
        let illumination = tracer.illuminate(light, contour.point);
        let spread = contour.towards_light(illumination.distance, self.lights as f64);
        let irradiance = illumination.irradiance * spread;
        let reach = 4.0 * SURFACE_ERROR * contour.point.abs().max_element();
        let aside = contour.normal * if side == 1 { reach } else { -reach };
        let [origin, direction] =
            [contour.point + aside, illumination.direction].map(|v| v.as_vec3());
        let is_own = |primitive: u32| contour.is_of(primitive);
        let limit = illumination.distance as f32;
        let is_lit = irradiance != DVec3::ZERO
            && !tracer.bvh.is_occluded_but(origin, direction, limit, is_own);
        is_lit.then_some((contour, Source::Light { light, side, irradiance }))
    }

    /// A path by so many surfaces to a ray along an edge, with a weight that does not know yet how it was drawn.
    fn path(
        &self,
        contour: &Contour<'_>,
        source: Source,
        surfaces: u32,
        (index, seed): (u32, u32),
    ) -> Option<Segment> {
        let (mut known, mut met) = self.before(contour, DVec3::ZERO)?;
        // Shadow rays start above smooth triangles.
        let is_lifted = source != Source::Evenly && self.geometry.is_smooth(known.primitive);
        if is_lifted {
            (known, met) = self.before(contour, met.surface.point - met.start)?;
        }
        let distance = met.surface.point.distance(contour.point);
        let foreshortened = match is_lifted {
            // The places above are as many as the points below, but for the angle between the normals.
            true => met.surface.normal.dot(contour.direction) / met.surface.normal.dot(met.outward),
            false => met.outward.dot(contour.direction),
        };
        let (mut points, mut weight) = (vec![met.surface.point], foreshortened.abs().recip());
        for step in 1..surfaces {
            let [u, v, ..] = path_numbers(index, 1 + step, seed);
            let (sin, cos) = (TAU * v).sin_cos();
            let (x, y) = met.outward.any_orthonormal_pair();
            // Evenly: a point of a surface that moves slides along a ray as fast as one over the cosine.
            let direction = (x * cos + y * sin) * (1.0 - u * u).sqrt() + met.outward * u;
            weight *= TAU * u;
            let reach = met.surface.point.abs().max_element();
            let origin = met.surface.point + met.outward * (SURFACE_ERROR * reach);
            let from = self.geometry.is_triangle(known.primitive).then_some(known.primitive);
            let ray = Ray { origin, direction };
            known = self.hit(from, ray)?.0;
            met = self.geometry.meet(&known, ray);
            weight /= met.outward.dot(direction).abs();
            points.push(met.surface.point);
        }
        points.reverse();
        let (point, frame) = (points[0], self.geometry.frame);
        let to_camera = frame.origin - point;
        let cosine = met.outward.dot(to_camera.normalize());
        if cosine <= 0.0 {
            return None;
        }
        let place = self.geometry.project(frame, point)?;
        let (pixel, film) = (self.geometry.pixel(place)?, self.geometry.film(place));
        let pixels = pixels_of_solid_angle(frame, film, self.geometry.size());
        weight *= cosine / to_camera.length_squared() * pixels;
        // Rays start beside surfaces, and may pass beside the edge by as much.
        let reach = contour.point.abs().max_element().max(to_camera.length());
        let aside = contour.normal * (ASIDE * distance).max(4.0 * SURFACE_ERROR * reach);
        Some(Segment {
            film,
            pixel,
            points,
            targets: [contour.point - aside, contour.point + aside],
            edges: contour.edges(),
            weight,
            even: contour.even,
            source,
            seed: hash(index ^ seed),
        })
    }

    /// The surface that a ray along an edge comes from, or one that is moved by as much.
    fn before(&self, contour: &Contour<'_>, moved: DVec3) -> Option<(KnownHit, Met)> {
        let from_edge = contour.point + moved;
        let mut ray = Ray { origin: from_edge, direction: -contour.direction };
        let mut from = None;
        for _ in 0..TRIES {
            let (known, distance) = self.hit(from, ray)?;
            if !contour.is_of(known.primitive) {
                return Some((known, self.geometry.meet(&known, ray)));
            }
            // Single precision does not tell that the ray touches its own surface and no more.
            from = self.geometry.is_triangle(known.primitive).then_some(known.primitive);
            let beyond = match self.geometry.layout.kind_of(known.primitive as usize) {
                (Kind::Sphere, index) => LEAVING * self.geometry.sphere(index).radius,
                _ => 0.0,
            };
            let passed = ray.origin.distance(from_edge) + distance;
            ray.origin = from_edge + ray.direction * (2.0 * passed).max(beyond);
        }
        None
    }

    fn hit(&self, from: Option<u32>, ray: Ray<f64>) -> Option<(KnownHit, f64)> {
        let [origin, direction] = [ray.origin, ray.direction].map(|v| v.as_vec3());
        let hit = self.geometry.tracer.bvh.nearest_but(from, origin, direction)?;
        let (primitive, leaves) = (hit.primitive, hit.leaves);
        let known = KnownHit { leaves, ..KnownHit::of_triangle(primitive) };
        Some((known, hit.distance.into()))
    }
}

/// A number that tells more than a million edges apart, which 23 bits do not.
fn exact(number: f64, fine: f64) -> f64 {
    number + fine / f64::from(1 << 23)
}

/// How many pixels a solid angle fills where it is small, for each steradian.
fn pixels_of_solid_angle(
    frame: CameraFrame<f64>,
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
) -> f64 {
    let length = film_point::<f64>(frame, x, y).length();
    let of_film = length.powi(3) / (frame.right.length() * frame.up.length());
    of_film * 0.25 * width * height
}
