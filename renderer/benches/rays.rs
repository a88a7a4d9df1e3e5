//! The rate of rays: packets, single rays, and the binary tree of obvhs with its own
//! triangle test. OBJ files, and numbers of rings of bumpy spheres; without any, spheres of 6,400,
//! 69,696 and 1,000,000 triangles. Millions of rays per second, on one thread and on all, and the
//! ratio to the binary tree; medians over interleaved repetitions.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use glam::{Vec3, vec3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit};
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use renderer::Mesh;
use renderer::files::load_obj;
use renderer::trace::bvh::{
    Bvh, NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, Shape, tile_position,
};

use super::sphere::bumpy_sphere;
use super::timing::{median, seconds};

const REPETITIONS: usize = 9;
/// The edge of the image in tiles of 8 x 8 pixels.
const TILES: usize = 128;

/// Measures meshes.
pub fn run(arguments: &[String]) {
    let spheres = ["40", "132", "500"].map(String::from);
    for argument in if arguments.is_empty() { &spheres } else { arguments } {
        if let Ok(rings) = argument.parse() {
            measure("bumpy sphere", &corners(&bumpy_sphere(rings)));
            continue;
        }
        match load_obj(Path::new(argument)) {
            Ok(model) => {
                measure(argument, &model.meshes.iter().flat_map(corners).collect::<Vec<_>>());
            }
            Err(error) => eprintln!("error: {error}"),
        }
    }
}

/// The corners of each triangle.
fn corners(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let corner = |index: u32| Vec3::from(mesh.vertices[index as usize].map(|x| x as f32));
    mesh.triangles.iter().map(|triangle| triangle.map(corner)).collect()
}

/// A mesh with the trees over it and the rays to trace.
struct Subject {
    tree: Bvh,
    binary: Bvh2,
    /// In the order of the binary tree's leaves.
    triangles: Vec<Triangle>,
    eye: Vec3,
    light: Vec3,
    primary: Vec<PacketVectors>,
    /// From the light to what the eye sees, the rays that are wanted, and where they end.
    shadow: Vec<(PacketVectors, u64, [u32; PACKET_RAYS])>,
    /// Origins and directions.
    random: Vec<(Vec3, Vec3)>,
}

fn measure(name: &str, corners: &[[Vec3; 3]]) {
    println!("{name}: {} triangles, {} threads", corners.len(), rayon::current_num_threads());
    let shapes: Vec<_> = corners.iter().map(|&t| Shape::Triangle(t)).collect();
    measure_build(corners, &shapes);
    let subject = Subject::new(corners, &shapes);
    let threads = [1, rayon::current_num_threads()];
    let pools =
        threads.map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().expect("threads"));

    type Case<'a> = (&'a str, usize, Box<dyn Fn(&Subject) + Sync>);
    let cases: [Vec<Case>; 3] = [
        vec![
            ("primary, packets", 0, Box::new(Subject::primary_packets)),
            ("primary, single", 0, Box::new(Subject::primary_single)),
            ("primary, binary tree", 0, Box::new(Subject::primary_binary)),
        ],
        vec![
            ("shadow, packets", 1, Box::new(Subject::shadow_packets)),
            ("shadow, single", 1, Box::new(Subject::shadow_single)),
            ("shadow, binary tree", 1, Box::new(Subject::shadow_binary)),
        ],
        vec![
            ("random, single", 2, Box::new(Subject::random_single)),
            ("random, binary tree", 2, Box::new(Subject::random_binary)),
        ],
    ];
    let shadow_rays = subject.shadow.iter().map(|(_, active, _)| active.count_ones() as usize);
    let rays = [TILES * TILES * PACKET_RAYS, shadow_rays.sum(), subject.random.len()];
    for group in &cases {
        let mut samples_of = vec![[Vec::new(), Vec::new()]; group.len()];
        for _ in 0..REPETITIONS {
            for ((_, _, run), samples) in group.iter().zip(&mut samples_of) {
                for (pool, samples) in pools.iter().zip(samples) {
                    samples.push(pool.install(|| seconds(|| run(&subject))));
                }
            }
        }
        let rates: Vec<_> = group
            .iter()
            .zip(samples_of)
            .map(|((_, kind, _), samples)| {
                samples.map(|samples| rays[*kind] as f64 / median(samples) / 1e6)
            })
            .collect();
        let base = rates[rates.len() - 1];
        for ((name, ..), rate) in group.iter().zip(&rates) {
            println!(
                "  {name:22} {:8.2} {:8.2} Mrays/s  {:5.2} x {:5.2} x",
                rate[0],
                rate[1],
                rate[0] / base[0],
                rate[1] / base[1]
            );
        }
    }
}

/// Building, and fitting to vertices that move a little and back.
fn measure_build(corners: &[[Vec3; 3]], shapes: &[Shape]) {
    let moved: Vec<_> =
        corners.iter().map(|t| Shape::Triangle(t.map(|v| v * (1.0 + 0.01 * v.x)))).collect();
    let mut tree = Bvh::new(&shapes);
    let (mut build, mut update) = (Vec::new(), Vec::new());
    for _ in 0..REPETITIONS {
        build.push(seconds(|| Bvh::new(&shapes)));
        update.push(seconds(|| tree.update(&moved)));
        update.push(seconds(|| tree.update(&shapes)));
    }
    println!("  build {:.2} ms, update {:.2} ms", median(build) * 1e3, median(update) * 1e3);
}

impl Subject {
    fn new(corners: &[[Vec3; 3]], shapes: &[Shape]) -> Self {
        let tree = Bvh::new(&shapes);
        let triangles: Vec<_> = corners
            .iter()
            .map(|t| Triangle { v0: t[0].into(), v1: t[1].into(), v2: t[2].into() })
            .collect();
        let binary =
            build_bvh2(&triangles, BvhBuildParams::medium_build(), &mut Duration::default());
        let order = binary.primitive_indices.iter();
        let triangles = order.map(|&id| triangles[id as usize]).collect();

        let points = corners.iter().flatten();
        let (low, high) = points.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), &p| {
            (low.min(p), high.max(p))
        });
        let (middle, radius) = (low.midpoint(high), (high - low).length() / 2.0);
        let eye = middle + vec3(0.6, 0.6, 1.8) * radius;
        let light = middle + vec3(1.8, 2.4, 1.8) * radius;
        let forward = (middle - eye).normalize();
        let right = forward.cross(Vec3::Y).normalize();
        let up = right.cross(forward);
        let primary: Vec<_> = (0..TILES * TILES)
            .map(|tile| {
                let mut directions = PacketVectors::ZERO;
                for ray in 0..PACKET_RAYS {
                    let film = |tile: usize, ray: usize| {
                        ((8 * tile + ray) as f32 + 0.5) / (4 * TILES) as f32 - 1.0
                    };
                    let (column, row) = tile_position(ray);
                    let x = film(tile % TILES, column) * 0.41;
                    let y = -film(tile / TILES, row) * 0.41;
                    directions.set(ray, (forward + right * x + up * y).normalize());
                }
                directions
            })
            .collect();
        let shadow = primary
            .iter()
            .map(|directions| {
                let hits = tree.nearest_packet(eye, directions, u64::MAX);
                let mut rays = PacketVectors::ZERO;
                let mut active = 0;
                for ray in 0..PACKET_RAYS {
                    if let Some(hit) = hits.get(ray) {
                        let point = eye + directions.get(ray) * hit.distance;
                        rays.set(ray, (point - light) * (1.0 - 1e-5));
                        active |= 1 << ray;
                    }
                }
                (rays, active, hits.primitive)
            })
            .filter(|(_, active, _)| *active != 0)
            .collect();

        let mut state = 1_u32;
        let mut uniform = || {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
            ((word >> 22) ^ word) as f32 / u32::MAX as f32 * 2.0 - 1.0
        };
        let mut point = || vec3(uniform(), uniform(), uniform());
        let random = (0..1 << 18)
            .map(|_| (middle + point() * radius, point().normalize_or(Vec3::X)))
            .collect();
        Self { tree, binary, triangles, eye, light, primary, shadow, random }
    }

    fn primary_packets(&self) {
        self.primary.par_iter().for_each(|directions| {
            black_box::<PacketHits>(self.tree.nearest_packet(self.eye, directions, u64::MAX));
        });
    }

    fn primary_single(&self) {
        self.primary.par_iter().for_each(|directions| {
            for ray in 0..PACKET_RAYS {
                black_box(self.tree.nearest(self.eye, directions.get(ray)));
            }
        });
    }

    fn primary_binary(&self) {
        self.primary.par_iter().for_each(|directions| {
            for ray in 0..PACKET_RAYS {
                self.nearest_binary(self.eye, directions.get(ray));
            }
        });
    }

    fn shadow_packets(&self) {
        self.shadow.par_iter().for_each(|(directions, active, from)| {
            black_box(self.tree.occluded_packet(self.light, directions, 1.0, from, *active));
        });
    }

    fn shadow_single(&self) {
        self.shadow.par_iter().for_each(|(directions, active, from)| {
            for ray in (0..PACKET_RAYS).filter(|ray| active >> ray & 1 != 0) {
                let from = Some(from[ray]).filter(|&from| from != NO_PRIMITIVE);
                black_box(self.tree.is_occluded(self.light, directions.get(ray), 1.0, from));
            }
        });
    }

    fn shadow_binary(&self) {
        self.shadow.par_iter().for_each(|(directions, active, from)| {
            for ray in (0..PACKET_RAYS).filter(|ray| active >> ray & 1 != 0) {
                let direction = directions.get(ray);
                let line = Ray::new(self.light.into(), direction.into(), 0.0, 1.0);
                black_box(self.binary.ray_traverse_miss(line, |line, index| {
                    if self.binary.primitive_indices[index] == from[ray] {
                        return f32::INFINITY;
                    }
                    self.triangles[index].intersect(line)
                }));
            }
        });
    }

    fn random_single(&self) {
        self.random.par_iter().with_min_len(256).for_each(|&(origin, direction)| {
            black_box(self.tree.nearest(origin, direction));
        });
    }

    fn random_binary(&self) {
        self.random.par_iter().with_min_len(256).for_each(|&(origin, direction)| {
            self.nearest_binary(origin, direction);
        });
    }

    fn nearest_binary(&self, origin: Vec3, direction: Vec3) {
        let ray = Ray::new(origin.into(), direction.into(), 0.0, f32::INFINITY);
        let mut hit = RayHit::none();
        self.binary.ray_traverse(ray, &mut hit, |ray, index| self.triangles[index].intersect(ray));
        black_box(hit.t);
    }
}
