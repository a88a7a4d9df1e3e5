//! Rays and what they meet, one by one: paths are followed analytically through surfaces that are known.

use glam::DVec3;

use super::code::decode;
use super::numbers::Numbers;
use crate::number::Plain;
use crate::primal::inputs::ShapeInputs;
use crate::primal::integrator::{Integrator, ZeroWeight};
use crate::primal::known::KnownHit;
use crate::primal::tracer::Tracer;
use crate::scene::Slot;
use crate::trace::adjacency::Adjacency;
use crate::trace::bvh::NO_PRIMITIVE;
use crate::trace::layout::{Kind, Layout, TextureLayout};
use crate::transport::camera::{CameraFrame, Ray, film_point, primary_ray};
use crate::transport::edge::{ball_margin, plane_margin, segment_margin, sphere_margin};
use crate::transport::hit::{Primitive, hit};
use crate::transport::normal_map::{NormalMap, mapped_normal};
use crate::transport::smooth::{
    SmoothPoint, curved_point, next_ray_outward, side_of, smooth_point,
};
use crate::transport::sphere::Sphere;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::{Footprint, texel_position};
use crate::transport::triangle::{Triangle, triangle_point, triangle_uv};
use crate::transport::vertex::next_ray;

/// The largest angle between the planes of triangles that count as one: where more edges meet in a pixel, each is less
/// well known, and nobody sees this one.
const COPLANAR: f64 = 1e-5;

/// How far from its place a vertex in single precision may be, as a part of its largest coordinate. Triangles of one plane
/// are as far from it.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// The cosine with the normal below which a ray grazes a triangle: the point that it meets moves by more than the tenfold of
/// what the triangle does.
const GRAZED: f64 = 0.1;

/// How far such a triangle goes into the scene, as a part of its distance: what smaller ones are off by is another for each,
/// and is right on average.
const DEEP: f64 = 0.1;

/// Up to this distance, as a part of that from where the ray starts, an edge lies on the surface behind it: what single
/// precision tells.
const TOUCHING: f64 = 2e-6;

/// The least sine of the angle between two such surfaces: planes that are closer to parallel meet in no line that can be
/// relied upon.
const LEAST_SINE: f64 = 1e-2;

/// The square of the sine below which two edges of a triangle are one line.
const NO_AREA: f64 = (f32::EPSILON * f32::EPSILON) as f64;

/// A boundary of what rays see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// The straight line between two vertices.
    Segment([u32; 2]),
    /// The silhouette of a sphere or a custom shape.
    Silhouette(u32),
    /// The curve in which two primitives pierce each other.
    /// See [`code`](super::code::code).
    Intersection([u32; 2]),
    /// A triangle or a sphere on which a shadow ray begins. It begins [above](mod@crate::transport::smooth) a smooth
    /// triangle, and where that place goes through another surface, this is in the way of the light or no longer is.
    Start(u32),
}

/// Where a ray meets a surface.
pub struct Met {
    /// The point, with the normal that it is shaded with.
    pub surface: SurfacePoint<f64>,
    /// The normal of the geometry, on the side of the viewer.
    pub outward: DVec3,
    /// Where shadow rays start.
    pub start: DVec3,
}

/// A scene in double precision, one ray at a time.
#[derive(Clone, Copy)]
pub struct Geometry<'a> {
    pub layout: &'a Layout,
    pub tracer: &'a Tracer,
    numbers: Numbers<'a>,
    pub zero_weight: ZeroWeight,
    pub adjacency: &'a Adjacency,
    pub frame: CameraFrame<f64>,
    /// Image width and height in pixels.
    size: [f64; 2],
}

impl<'a> Geometry<'a> {
    pub fn new<L: Plain>(integrator: Integrator<'a, L>) -> Self {
        let Integrator { layout, tracer, inputs, zero_weight, .. } = integrator;
        let numbers = Numbers::new(inputs);
        let (adjacency, frame) = (layout.adjacency(), numbers.others.frame());
        let size = [layout.width, layout.height].map(f64::from);
        Self { layout, tracer, numbers, zero_weight, adjacency, frame, size }
    }

    pub fn is_triangle(&self, primitive: u32) -> bool {
        self.layout.kind_of(primitive as usize).0 == Kind::Triangle
    }

    /// Whether a primitive is a triangle with normals of its corners.
    pub fn is_smooth(&self, primitive: u32) -> bool {
        self.is_triangle(primitive) && self.layout.normals.of(primitive as usize).is_some()
    }

    /// Whether a primitive is a triangle without normals of its corners.
    pub fn is_flat(&self, primitive: u32) -> bool {
        self.is_triangle(primitive) && !self.is_smooth(primitive)
    }

    /// Whether a ray grazes a flat triangle that goes far into the scene.
    pub fn is_grazed(&self, primitive: u32, ray: Ray<f64>) -> bool {
        self.is_triangle(primitive) && {
            let Triangle { a, b, c } = self.triangle(primitive as usize);
            let (direction, normal) = (ray.direction.normalize(), (b - a).cross(c - a));
            let depths = [a, b, c].map(|corner| (corner - ray.origin).dot(direction));
            let [nearest, farthest] =
                [f64::min, f64::max].map(|end| depths.into_iter().reduce(end).unwrap_or(0.0));
            normal.dot(direction).abs() < GRAZED * normal.length()
                && farthest - nearest > DEEP * farthest
        }
    }

    /// Whether rays go straight on through a primitive.
    pub fn is_transparent(&self, primitive: u32) -> bool {
        self.layout.traits_of(primitive as usize).is_transparent
    }

    /// Whether a primitive is a triangle with this edge.
    pub fn is_side(&self, primitive: u32, edge: [u32; 2]) -> bool {
        let layout = self.layout;
        self.is_triangle(primitive)
            && edge.iter().all(|end| layout.triangles[primitive as usize].contains(end))
    }

    /// Whether two primitives are parts of one smooth surface: neighbouring triangles that look the same,
    /// of a plane or with the same normals where they meet.
    pub fn are_continuous(&self, a: u32, b: u32) -> bool {
        let layout = self.layout;
        let [a, b] = match [a, b].map(|primitive| layout.kind_of(primitive as usize)) {
            [(Kind::Triangle, a), (Kind::Triangle, b)] => [a, b],
            _ => return false,
        };
        if !layout.look_alike(a, b) {
            return false;
        }
        if [a, b].iter().any(|&triangle| layout.normals.of(triangle).is_some()) {
            return layout.share_normals(a, b) && !self.is_turned_over([a, b]);
        }
        let [first, second] = [a, b].map(|at| layout.triangles[at]);
        let is_shared = |vertex: &&u32| second.contains(vertex);
        if first.iter().filter(is_shared).count() < 2 {
            return false;
        }
        let corners = [first, second].map(|corners| corners.map(|vertex| self.vertex(vertex)));
        let [first, second] = corners.map(|[a, b, c]| (b - a).cross(c - a));
        let [of_first, of_second] = [first.length(), second.length()];
        let far =
            corners.as_flattened().iter().fold(0.0, |far: f64, at| far.max(at.abs().max_element()));
        let [a, b, c] = corners[0];
        let longest =
            a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a)).sqrt();
        // The heights over an edge are the areas over its length.
        let rounded = ROUNDING * far * longest * (of_first + of_second);
        first.cross(second).length() <= (COPLANAR * of_first * of_second).max(rounded)
    }

    /// Whether the normals of one of two smooth triangles that share an edge are [behind](side_of()) it and those
    /// of the other are not, so that shading jumps there.
    fn is_turned_over(&self, triangles: [usize; 2]) -> bool {
        let [of_first, of_second] = triangles.map(|at| self.has_normals_behind(at));
        self.wind_alike(triangles).is_some_and(|alike| (of_first != of_second) == alike)
    }

    /// Whether the corners of two triangles that share an edge stand in the same order around them.
    fn wind_alike(&self, triangles: [usize; 2]) -> Option<bool> {
        let [first, second] = triangles.map(|at| self.layout.triangles[at]);
        let apex = |of: [u32; 3], other: [u32; 3]| of.iter().position(|at| !other.contains(at));
        let (one, other) = (apex(first, second)?, apex(second, first)?);
        Some(first[(one + 1) % 3] == second[(other + 2) % 3])
    }

    /// Whether two triangles that share an edge show the same side of their surface to a place. Where it is folded, one
    /// of them may hide the other.
    pub fn show_one_side(&self, triangles: [u32; 2], place: DVec3) -> bool {
        let triangles = triangles.map(|triangle| triangle as usize);
        let [first, second] = triangles.map(|triangle| self.faces(triangle, place));
        self.wind_alike(triangles).is_none_or(|alike| (first == second) == alike)
    }

    /// Whether the normals of a smooth triangle are behind the side from which its corners stand anticlockwise.
    fn has_normals_behind(&self, triangle: usize) -> bool {
        let Triangle { a, b, c } = self.triangle(triangle);
        let normals = self.normals(triangle);
        normals.is_some_and(|normals| side_of::<f64>(normals, (b - a).cross(c - a)) < 0.0)
    }

    /// Whether two edges share one vertex.
    pub fn are_adjacent(&self, a: Edge, b: Edge) -> bool {
        let (Edge::Segment(a), Edge::Segment(b)) = (a, b) else { return false };
        let same = |&(a, b): &(u32, u32)| a == b || self.vertex(a) == self.vertex(b);
        let pairs = [(a[0], b[0]), (a[0], b[1]), (a[1], b[0]), (a[1], b[1])];
        pairs.iter().filter(|pair| same(pair)).count() == 1
    }

    /// Whether an edge is one of a mirror that rays leave. Those that are [lifted](next_ray_outward()) to the plane of a
    /// smooth triangle meet its neighbours there: rounding decides what they see, and nothing moves.
    pub fn has_edge(&self, mirror: &KnownHit, edge: Edge) -> bool {
        let Edge::Segment(ends) = edge else { return false };
        !self.is_transparent(mirror.primitive) && self.is_side(mirror.primitive, ends)
    }

    pub fn is_custom(&self, primitive: u32) -> bool {
        self.layout.kind_of(primitive as usize).0 == Kind::Custom
    }

    /// The coordinates of [`film_point`] of a place in pixels from the upper left corner.
    pub fn film(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [width, height] = self.size;
        [(x + x - width) / width, -(y + y - height) / height]
    }

    /// The place of such coordinates.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [width, height] = self.size;
        [0.5 * (1.0 + x) * width, 0.5 * (1.0 - y) * height]
    }

    /// The camera from which rays would come straight to what they meet after these surfaces: mirrored by each flat
    /// mirror among them. None after what bends rays otherwise.
    pub fn camera_after(&self, surfaces: &[KnownHit]) -> Option<CameraFrame<f64>> {
        surfaces.iter().try_fold(self.frame, |camera, known| {
            if self.is_transparent(known.primitive) {
                return Some(camera);
            }
            let index = known.primitive as usize;
            if !self.is_triangle(known.primitive) || self.is_bent(index) {
                return None;
            }
            let Triangle { a, b, c } = self.triangle(index);
            let normal = (b - a).cross(c - a).normalize();
            let mirrored = |vector: DVec3| vector - 2.0 * normal * normal.dot(vector);
            let [forward, right, up] = [camera.forward, camera.right, camera.up].map(mirrored);
            Some(CameraFrame { origin: a + mirrored(camera.origin - a), forward, right, up })
        })
    }

    /// The ray of a camera through a place of the image. Its direction is not a unit vector, but linear in the
    /// place.
    pub fn linear_ray(&self, camera: CameraFrame<f64>, place: [f64; 2]) -> Ray<f64> {
        let [x, y] = self.film(place);
        Ray { origin: camera.origin, direction: film_point::<f64>(camera, x, y) }
    }

    /// The derivatives of the number of an edge that the ray of a camera meets, by the place in the image.
    pub fn linear_slopes(
        &self,
        camera: CameraFrame<f64>,
        [a, b]: [u32; 2],
        place: [f64; 2],
    ) -> [f64; 2] {
        let Ray { origin, direction } = self.linear_ray(camera, place);
        let volume = (self.vertex(a) - origin).cross(self.vertex(b) - origin) / direction.length();
        let [width, height] = self.size;
        [volume.dot(camera.right) * 2.0 / width, -volume.dot(camera.up) * 2.0 / height]
    }

    /// Whether an edge is shorter in the image of a camera than this, in pixels.
    pub fn is_short(&self, camera: CameraFrame<f64>, ends: [u32; 2], length: f64) -> bool {
        let [a, b] = ends.map(|end| self.project(camera, self.vertex(end)));
        let squared = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2);
        a.zip(b).is_some_and(|(a, b)| squared(a, b) < length * length)
    }

    /// The ray through a place of the image after it has met `path`.
    pub fn ray(&self, path: &[KnownHit], place: [f64; 2]) -> Ray<f64> {
        let [x, y] = self.film(place);
        let ray = primary_ray::<f64>(self.frame, x, y);
        path.iter().fold(ray, |ray, known| self.next(known, &self.meet(known, ray)))
    }

    /// The ray that goes on from a surface point.
    pub fn next(&self, known: &KnownHit, met: &Met) -> Ray<f64> {
        let is_transparent = self.is_transparent(known.primitive);
        let Met { surface, outward, .. } = *met;
        match self.is_triangle(known.primitive) && self.is_bent(known.primitive as usize) {
            true => next_ray_outward::<f64>(SmoothPoint { surface, outward }, is_transparent),
            false => next_ray::<f64>(surface, is_transparent),
        }
    }

    /// Where a ray meets a primitive, or its plane if that is flat.
    pub fn meet(&self, known: &KnownHit, ray: Ray<f64>) -> Met {
        let layout = self.layout;
        let flat = |surface: SurfacePoint<f64>| Met {
            surface,
            outward: surface.normal,
            start: surface.point,
        };
        match layout.kind_of(known.primitive as usize) {
            (Kind::Triangle, index) => {
                let triangle = self.triangle(index);
                let mut met = match self.normals(index) {
                    None => flat(triangle_point::<f64>(triangle, ray)),
                    Some(normals) => {
                        let SmoothPoint { surface, outward } =
                            smooth_point::<f64>(triangle, normals, ray);
                        let start = curved_point::<f64>(triangle, normals, surface.point, outward);
                        Met { surface, outward, start }
                    }
                };
                self.bend(index, triangle, &mut met.surface);
                met
            }
            (Kind::Sphere, index) => {
                flat(hit::<f64>(Primitive::Sphere(self.sphere(index)), known.leaves, ray))
            }
            (Kind::Custom, index) => flat(self.numbers.others.shape(index).point(ray)),
        }
    }

    /// How far along a ray the surface point of a primitive is.
    pub fn depth(&self, known: &KnownHit, ray: Ray<f64>) -> f64 {
        let point = match self.layout.kind_of(known.primitive as usize) {
            (Kind::Triangle, index) => triangle_point::<f64>(self.triangle(index), ray).point,
            _ => self.meet(known, ray).surface.point,
        };
        (point - ray.origin).dot(ray.direction)
    }

    /// Whether a surface ends, at an edge that a ray meets, on the one that is seen behind it, as a box does that stands
    /// on a floor. On the way out of that, a gap would open, with a shadow in it; on the way into it the edge is that of surfaces
    /// that pierce each other.
    pub fn touch(&self, surfaces: [&KnownHit; 2], ray: Ray<f64>) -> bool {
        if surfaces.iter().any(|hit| hit.primitive == NO_PRIMITIVE) {
            return false;
        }
        let [near, behind] = surfaces.map(|hit| self.depth(hit, ray));
        (behind - near).abs() <= TOUCHING * near && {
            let [one, other] = surfaces.map(|hit| self.meet(hit, ray).outward);
            one.cross(other).length() > LEAST_SINE
        }
    }

    /// The number of an edge, see [`edge`](crate::transport::edge).
    pub fn margin(&self, edge: Edge, ray: Ray<f64>) -> f64 {
        match edge {
            Edge::Segment([a, b]) => segment_margin::<f64>(self.vertex(a), self.vertex(b), ray),
            Edge::Silhouette(primitive) => self.silhouette(primitive, ray),
            Edge::Intersection(surfaces) => {
                let [a, b] = surfaces.map(|surface| self.depth(&decode(surface), ray));
                a - b
            }
            Edge::Start(primitive) => match self.layout.kind_of(primitive as usize) {
                (Kind::Triangle, index) => plane_margin::<f64>(self.triangle(index), ray.origin),
                (_, index) => ball_margin::<f64>(self.sphere(index), ray.origin),
            },
        }
    }

    fn silhouette(&self, primitive: u32, ray: Ray<f64>) -> f64 {
        match self.layout.kind_of(primitive as usize) {
            (Kind::Custom, index) => {
                let ShapeInputs { kernel, numbers, transform } = self.numbers.others.shape(index);
                kernel.at::<f64>().intersect(&numbers, transform, ray).margin
            }
            (_, index) => sphere_margin::<f64>(self.sphere(index), ray),
        }
    }

    /// Where in the image of a camera a point is seen, in pixels; nothing if it is behind the camera.
    pub fn project(&self, camera: CameraFrame<f64>, point: DVec3) -> Option<[f64; 2]> {
        let CameraFrame { origin, forward, right, up } = camera;
        let from_camera = point - origin;
        let distance = from_camera.dot(forward);
        let x = from_camera.dot(right) / (right.length_squared() * distance);
        let y = from_camera.dot(up) / (up.length_squared() * distance);
        (distance > 0.0).then(|| self.place([x, y]))
    }

    /// Whether a triangle has an area that single precision can tell from none: rays meet no others.
    pub fn has_area(&self, triangle: usize) -> bool {
        let Triangle { a, b, c } = self.triangle(triangle);
        let (u, v) = (b - a, c - a);
        u.cross(v).length_squared() > NO_AREA * u.length_squared() * v.length_squared()
    }

    /// Whether the corners of a triangle stand anticlockwise as seen from a place.
    pub fn faces(&self, triangle: usize, place: DVec3) -> bool {
        let Triangle { a, b, c } = self.triangle(triangle);
        (b - a).cross(c - a).dot(place - a) > 0.0
    }

    /// Whether a triangle is behind the plane of another one next to a fold between them, as seen from a place.
    pub fn is_behind(&self, [triangle, other]: [usize; 2], seen_from: DVec3) -> bool {
        let Triangle { a, b, c } = self.triangle(other);
        let outward = (b - a).cross(c - a);
        let towards_viewer = outward.dot(seen_from - a);
        let of_edge = self.layout.triangles[other];
        let corners = self.layout.triangles[triangle].into_iter();
        let mut apex = corners.filter(|corner| !of_edge.contains(corner));
        apex.next().is_some_and(|apex| outward.dot(self.vertex(apex) - a) * towards_viewer < 0.0)
    }

    /// The pixel that a place in pixels is in, if it is one of the image.
    pub fn pixel(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let [width, height] = self.size;
        let is_inside = (0.0..width).contains(&x) && (0.0..height).contains(&y);
        is_inside.then(|| y as usize * width as usize + x as usize)
    }

    /// Image width and height in pixels.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// A sphere.
    pub fn sphere(&self, index: usize) -> Sphere<f64> {
        self.numbers.others.sphere(index)
    }

    /// A vertex.
    pub fn vertex(&self, index: u32) -> DVec3 {
        self.numbers.vertices.at(index)
    }

    pub fn triangle(&self, index: usize) -> Triangle<f64> {
        let [a, b, c] = self.layout.triangles[index].map(|vertex| self.vertex(vertex));
        Triangle { a, b, c }
    }

    /// Whether a triangle has other shading normals than its own.
    fn is_bent(&self, triangle: usize) -> bool {
        let layout = self.layout;
        layout.normals.of(triangle).is_some()
            || layout.traits_of(triangle).textures.get(Slot::Normal).is_some()
    }

    /// Bends the normal of a point of a triangle by its normal map, if it has one.
    fn bend(&self, index: usize, triangle: Triangle<f64>, surface: &mut SurfacePoint<f64>) {
        let Self { layout, numbers, .. } = self;
        let Some(texture) = layout.traits_of(index).textures.get(Slot::Normal) else { return };
        let Some(corners) = layout.uvs.of(index) else { return };
        let corners = corners.map(|corner| numbers.others.uv(corner));
        let uv = triangle_uv::<f64>(triangle, corners, surface.point);
        let texture = texture as usize;
        let TextureLayout { first_texel, width, height, .. } = layout.textures[texture];
        let [width, height] = [width, height].map(f64::from);
        let (x, y) = texel_position::<f64>(uv, width, height);
        let texels = layout.textures[texture]
            .around(x, y)
            .map(|texel| numbers.others.texel(texture, texel as usize - first_texel));
        let scale = layout.normal_scale(index);
        let map = NormalMap { footprint: Footprint { texels, width, height }, uv, scale };
        surface.normal = mapped_normal::<f64>(triangle, corners, *surface, map, true);
    }

    /// The normals of the corners of a triangle, if it is smooth.
    pub fn normals(&self, triangle: usize) -> Option<[DVec3; 3]> {
        let normals = self.layout.normals.of(triangle)?;
        Some(normals.map(|normal| self.numbers.normals.at(normal)))
    }
}
