//! Paths that are known before they are followed: what each ray meets, and which lights it sees there.

use crate::trace::bvh::{PacketHits, first_rays};

/// Paths through points of the film, one for each ray of a packet.
#[derive(Default)]
pub struct KnownPaths {
    /// The points of the film, with the coordinates of
    /// [`film_point`](crate::transport::camera::film_point()); none where these are known otherwise.
    film: Vec<[f64; 2]>,
    depths: Vec<KnownHits>,
    /// How many of them belong to these paths.
    depth: usize,
}

/// What paths meet at one depth.
pub struct KnownHits {
    pub hits: PacketHits,
    /// By light, of the first ones: a bit for each ray that ends where an opaque surface is in its way.
    /// Shadow rays tell for the others.
    pub blocked: Vec<u64>,
    /// The transparent surfaces that lights come through, where that is known, by ray and light. Shadow rays tell
    /// elsewhere.
    pub through: Vec<Through>,
}

/// The transparent surfaces that a light comes through to where a ray ends.
pub struct Through {
    pub light: usize,
    pub ray: usize,
    pub surfaces: Vec<Occluding>,
}

/// A surface between a point and a light. Those of a ray are sorted: nothing depends on how the acceleration structure
/// has come to them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Occluding {
    pub primitive: u32,
    /// Whether the ray to the light leaves a sphere here.
    pub leaves: bool,
}

/// What one ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownHit {
    pub primitive: u32,
    /// Whether the ray leaves a sphere here.
    pub leaves: bool,
    /// A bit for each light that an opaque surface is in the way of.
    pub blocked: u64,
    /// A number for the materials that the lights come through, of other points where others are. Zero if
    /// there are none.
    pub filters: u32,
}

impl KnownHit {
    /// A triangle that nothing casts a shadow on.
    pub fn of_triangle(primitive: u32) -> Self {
        Self { primitive, leaves: false, blocked: 0, filters: 0 }
    }
}

impl KnownPaths {
    /// Removes all paths.
    pub fn clear(&mut self) {
        self.film.clear();
        self.depth = 0;
    }

    /// Adds a path through a point of the film, which meets surfaces at each of these depths. There are
    /// `lights` lights.
    pub fn push(&mut self, film: [f64; 2], hits: impl Iterator<Item = KnownHit>, lights: usize) {
        let ray = self.film.len();
        self.film.push(film);
        for (depth, hit) in hits.enumerate() {
            if depth == self.depth {
                self.next_depth(lights);
            }
            let known = &mut self.depths[depth];
            known.hits.primitive[ray] = hit.primitive;
            known.hits.leaves |= u64::from(hit.leaves) << ray;
            for (light, blocked) in known.blocked.iter_mut().enumerate() {
                *blocked |= (hit.blocked >> light & 1) << ray;
            }
        }
    }

    /// One more depth, at which no path meets anything yet.
    pub fn next_depth(&mut self, lights: usize) -> &mut KnownHits {
        if self.depth == self.depths.len() {
            let (blocked, through) = (Vec::new(), Vec::new());
            self.depths.push(KnownHits { hits: PacketHits::NONE, blocked, through });
        }
        let known = &mut self.depths[self.depth];
        self.depth += 1;
        known.hits = PacketHits::NONE;
        known.blocked.clear();
        known.blocked.resize(lights, 0);
        known.through.clear();
        known
    }

    /// Says which transparent surfaces a light comes through to where the path that was added last ends at a depth.
    pub fn push_through(&mut self, depth: usize, light: usize, surfaces: &[Occluding]) {
        let ray = self.film.len() - 1;
        let through = Through { light, ray, surfaces: surfaces.to_vec() };
        self.depths[depth].through.push(through);
    }

    /// Says that something is in the way of a light to where the path that was added last ends at a depth.
    pub fn block(&mut self, depth: usize, light: usize) {
        let ray = self.film.len() - 1;
        self.depths[depth].blocked[light] |= 1 << ray;
    }

    /// A bit for each path through a point of the film.
    pub fn rays(&self) -> u64 {
        first_rays(self.film.len())
    }

    /// What the paths meet at a depth, if any goes so far.
    pub fn at(&self, depth: usize) -> Option<&KnownHits> {
        self.depths[..self.depth].get(depth)
    }

    /// The points of the film.
    pub fn film(&self) -> &[[f64; 2]] {
        &self.film
    }
}

impl KnownHits {
    /// The transparent surfaces that a light comes through to where a ray ends, if that is known.
    pub fn through(&self, light: usize, ray: usize) -> Option<&[Occluding]> {
        let order = |through: &Through| (through.ray, through.light);
        let found = self.through.binary_search_by_key(&(ray, light), order).ok()?;
        Some(&self.through[found].surfaces)
    }
}
