//! Scatter: from lanes of cotangents to sums in double precision.

use ad::{Additive, Fields, Tangent};
use glam::DVec3;

use super::request::{Bits, Dense, Request};
use super::selection::Selection;
use crate::number::Plain;
use crate::primal::coalesce::Coalesced;
use crate::primal::lanes::sum_of_lanes;
use crate::transport::camera::CameraFrame;
use crate::transport::material::Material;
use crate::transport::sphere::Sphere;

/// The number of numbers of a material.
const MATERIAL: usize = <Material<f64> as Fields<f64>>::LEN;
/// The number of numbers of a sphere.
const SPHERE: usize = <Sphere<f64> as Fields<f64>>::LEN;

/// Sums of `N` numbers by slot, in the order in which the slots were first touched.
pub type Sparse<const N: usize> = Vec<(u32, [f64; N])>;

/// The loss of a strip, and the sums of its cotangents.
#[derive(Clone, Debug, Default)]
pub struct Sums {
    pub loss: f64,
    pub frame: Option<Tangent<CameraFrame<f64>>>,
    /// Sums of cotangents of lights, custom shapes and transforms.
    pub dense: Vec<f64>,
    pub materials: Sparse<MATERIAL>,
    pub spheres: Sparse<SPHERE>,
    /// Sums of cotangents of vertices, in world coordinates.
    pub vertices: Sparse<3>,
    /// Sums of cotangents of normals, in world coordinates.
    pub normals: Sparse<3>,
    pub uvs: Sparse<2>,
    pub texels: Sparse<3>,
}

impl Sums {
    fn new(request: &Request) -> Self {
        Self { dense: vec![0.0; request.dense], ..Self::default() }
    }

    /// Returns `true` if the loss and every sum are finite.
    pub fn is_finite(&self) -> bool {
        fn finite<const N: usize>(sums: &Sparse<N>) -> bool {
            sums.iter().flat_map(|(_, sum)| sum).all(|value| value.is_finite())
        }
        let frame = self.frame.iter().all(|frame| {
            let mut is_finite = true;
            frame.visit(&mut |_, value| is_finite &= value.is_finite());
            is_finite
        });
        self.loss.is_finite()
            && frame
            && self.dense.iter().all(|value| value.is_finite())
            && finite(&self.materials)
            && finite(&self.spheres)
            && finite(&self.vertices)
            && finite(&self.normals)
            && finite(&self.uvs)
            && finite(&self.texels)
    }
}

/// Where the sum of each slot stands in a list of sums.
///
/// A sparse set (Briggs & Torczon, "An Efficient Representation for Sparse Sets", 1993): it is never
/// cleared, because a place counts only if the sum in it bears its slot. So a strip costs the time
/// and the memory of what it touches, however much there is.
struct SparseSet(Vec<u32>);

impl SparseSet {
    fn new(selection: &Selection) -> Self {
        Self(vec![0; selection.count()])
    }

    /// The sum of a slot.
    #[inline]
    fn sum<'a, const N: usize>(
        &mut self,
        sums: &'a mut Sparse<N>,
        slot: usize,
    ) -> &'a mut [f64; N] {
        let place = &mut self.0[slot];
        let is_it = sums.get(*place as usize).is_some_and(|(of, _)| *of == slot as u32);
        if !is_it {
            *place = sums.len() as u32;
            sums.push((slot as u32, [0.0; N]));
        }
        &mut sums[*place as usize].1
    }
}

/// The sums of a thread's strips, one after the other.
pub struct Scatter<'a> {
    pub request: &'a Request,
    pub sums: Sums,
    materials: SparseSet,
    spheres: SparseSet,
    vertices: SparseSet,
    normals: SparseSet,
    uvs: SparseSet,
    texels: SparseSet,
}

impl<'a> Scatter<'a> {
    pub fn new(request: &'a Request) -> Self {
        Self {
            request,
            sums: Sums::new(request),
            materials: SparseSet::new(&request.materials),
            spheres: SparseSet::new(&request.spheres),
            vertices: SparseSet::new(&request.vertices),
            normals: SparseSet::new(&request.normals),
            uvs: SparseSet::new(&request.uvs),
            texels: SparseSet::new(&request.texels),
        }
    }

    /// The sums so far; new ones begin at zero.
    pub fn take(&mut self) -> Sums {
        std::mem::replace(&mut self.sums, Sums::new(self.request))
    }

    /// Adds the cotangents of a frame in all lanes.
    pub fn frame<L: Plain>(&mut self, cotangent: &Tangent<CameraFrame<L>>) {
        let all = ad::Mask::splat(true);
        let sum = Fields::from_fn(&mut |index| sum_of_lanes::<L>(cotangent.number(index), all));
        self.sums.frame.get_or_insert_with(Additive::zero).accumulate(sum);
    }

    /// Adds the cotangents of materials by material.
    #[inline]
    pub fn materials<L: Plain>(&mut self, materials: &Coalesced, cotangent: &Tangent<Material<L>>) {
        let Self { request, sums, materials: set, .. } = self;
        for (material, lanes) in materials.iter() {
            if let Some(slot) = request.materials.slot(material) {
                let sum = set.sum(&mut sums.materials, slot);
                add_numbers(cotangent, request.material_numbers, L::mask_from_bits(lanes), sum);
            }
        }
    }

    /// Adds the cotangents of a sphere in some lanes.
    pub fn sphere<L: Plain>(&mut self, sphere: usize, lanes: u32, cotangent: &Tangent<Sphere<L>>) {
        let Self { request, sums, spheres: set, .. } = self;
        if let Some(slot) = request.spheres.slot(sphere) {
            let sum = set.sum(&mut sums.spheres, slot);
            add_numbers(cotangent, request.sphere_numbers, L::mask_from_bits(lanes), sum);
        }
    }

    /// Adds the cotangents of the numbers of a light, a shape or a transform in some lanes.
    #[inline]
    pub fn dense<L: Plain, T: Fields<L>>(&mut self, to: Dense, lanes: u32, cotangent: &T) {
        let sums = &mut self.sums.dense[to.start..];
        add_numbers(cotangent, to.numbers, L::mask_from_bits(lanes), sums);
    }

    /// Adds the cotangents of a custom shape with `count` numbers in some lanes. `pull` calls its
    /// argument with the number and the cotangent of each, and returns those of the transform and of what
    /// is left.
    pub fn shape<L: Plain, T: Fields<L>, R>(
        &mut self,
        shape: usize,
        count: usize,
        lanes: u32,
        pull: impl FnOnce(&mut dyn FnMut(usize, L)) -> (T, R),
    ) -> R {
        let to = self.request.shapes[shape];
        let (transform, rest) = pull(&mut |number, cotangent| {
            if let Some(to) = to {
                self.number(to, number, lanes, cotangent);
            }
        });
        if let Some(to) = to {
            self.dense_after::<L, T>(to, count, lanes, &transform);
        }
        rest
    }

    /// Adds the cotangents of a struct whose numbers come after `first` others, in some lanes.
    fn dense_after<L: Plain, T: Fields<L>>(
        &mut self,
        to: Dense,
        first: usize,
        lanes: u32,
        cotangent: &T,
    ) {
        let to = Dense { start: to.start + first, numbers: to.numbers >> first };
        self.dense::<L, T>(to, lanes, cotangent);
    }

    /// Adds cotangents that are sums already.
    pub fn dense_sum<T: Fields<f64>>(&mut self, to: Dense, cotangent: &T) {
        let sums = &mut self.sums.dense[to.start..];
        cotangent.visit(&mut |index, number| sums[index] += number);
    }

    /// Adds the cotangent of one number of a custom light or shape in some lanes.
    pub fn number<L: Plain>(&mut self, to: Dense, index: usize, lanes: u32, cotangent: L) {
        if to.numbers >> index & 1 == 1 {
            let sum = sum_of_lanes::<L>(cotangent, L::mask_from_bits(lanes));
            self.sums.dense[to.start + index] += sum;
        }
    }

    /// Adds the cotangent of a vertex in the world.
    #[inline]
    pub fn vertex(&mut self, vertex: usize, cotangent: DVec3) {
        if let Some(slot) = self.request.vertices.slot(vertex) {
            add(self.vertices.sum(&mut self.sums.vertices, slot), &cotangent.to_array());
        }
    }

    /// Adds the cotangent of a normal in the world.
    pub fn normal(&mut self, normal: usize, cotangent: DVec3) {
        if let Some(slot) = self.request.normals.slot(normal) {
            add(self.normals.sum(&mut self.sums.normals, slot), &cotangent.to_array());
        }
    }

    /// Adds the cotangent of texture coordinates.
    pub fn uv(&mut self, uv: usize, cotangent: [f64; 2]) {
        if let Some(slot) = self.request.uvs.slot(uv) {
            add(self.uvs.sum(&mut self.sums.uvs, slot), &cotangent);
        }
    }

    /// Adds the cotangent of a texel.
    pub fn texel(&mut self, texel: usize, cotangent: DVec3) {
        if let Some(slot) = self.request.texels.slot(texel) {
            add(self.texels.sum(&mut self.sums.texels, slot), &cotangent.to_array());
        }
    }
}

fn add<const N: usize>(sum: &mut [f64; N], term: &[f64; N]) {
    sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
}

/// Adds the numbers that are asked for, in the lanes in which `mask` holds.
#[inline]
fn add_numbers<L: Plain, T: Fields<L>>(
    cotangent: &T,
    numbers: Bits,
    mask: <L as ad::Select>::Mask,
    sums: &mut [f64],
) {
    cotangent.visit(&mut |index, number| {
        if numbers >> index & 1 == 1 {
            sums[index] += sum_of_lanes::<L>(number, mask);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::{Selection, SparseSet};

    /// What a set still says of an earlier list does not count.
    #[test]
    fn sums_stand_in_the_order_of_their_first_terms_list_after_list() {
        let mut set = SparseSet::new(&Selection::new(std::iter::once(0..100), 100));
        for offset in [0, 3, 50] {
            let mut sums = Vec::new();
            for (slot, term) in [(7, 1.0), (2, 10.0), (7, 2.0), (40, 5.0), (2, 0.5)] {
                set.sum::<1>(&mut sums, slot + offset)[0] += term;
            }
            let at = |slot: usize| (slot + offset) as u32;
            assert_eq!(sums, [(at(7), [3.0]), (at(2), [10.5]), (at(40), [5.0])]);
        }
    }
}
