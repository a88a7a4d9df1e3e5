//! The numbers of a scene with others in place of some.

use ad::vector::Vector3;
use ad::{Field, Fields, Real, Vec3};
use glam::DVec3;

use crate::number::Number;
use crate::scene::{Object, ParameterId};

/// Numbers that stand for those of some parameters, such as ones that carry derivatives; all others are
/// constants.
pub struct Varying<W> {
    pub blocks: Vec<(ParameterId, Vec<W>)>,
}

impl<W: Real> Varying<W> {
    /// Nothing varies.
    pub const NONE: Self = Self { blocks: Vec::new() };

    pub(super) fn block(&self, object: Object, field: &str) -> Option<&[W]> {
        let is_it = |id: &ParameterId| (id.object, id.field, id.vertex) == (object, field, None);
        self.blocks.iter().find(|(id, _)| is_it(id)).map(|(_, block)| &block[..])
    }

    /// Numbers of a custom light or shape.
    pub(super) fn lift_custom(&self, object: Object, fields: &[Field], values: &[f64]) -> Vec<W> {
        let mut lifted: Vec<W> = values.iter().map(|&value| W::from_f64(value)).collect();
        let mut start = 0;
        for field in fields {
            if let Some(block) = self.block(object, field.name) {
                lifted[start..start + field.len].copy_from_slice(block);
            }
            start += field.len;
        }
        lifted
    }

    /// Numbers of a known object, whose fields they are.
    pub(super) fn lift<T: Fields<f64>>(&self, object: Object, values: &T) -> T::With<W> {
        let values: Vec<f64> = (0..T::LEN).map(|index| values.number(index)).collect();
        let lifted = self.lift_custom(object, T::FIELDS, &values);
        T::With::from_fn(&mut |index| lifted[index])
    }

    /// The vertices of a mesh that vary one by one.
    pub(super) fn single_vertices(&self, object: Object) -> impl Iterator<Item = (usize, &[W])> {
        let blocks = self.blocks.iter().filter(move |(id, _)| id.object == object);
        blocks.filter_map(|(id, block)| Some((id.vertex?, &block[..])))
    }
}

/// Constants.
#[inline]
pub(super) fn lifted<S: Number, const N: usize>(values: &[f64; N]) -> [S::Wide; N] {
    values.map(S::Wide::from_f64)
}

/// A vector that does not vary.
pub(super) fn lifted_vector<S: Number>(v: DVec3) -> Vec3<S::Wide> {
    let [x, y, z] = lifted::<S, 3>(&v.to_array());
    Vector3::new(x, y, z)
}

#[inline]
pub(super) fn narrow_vector<S: Number>(v: Vec3<S::Wide>) -> Vec3<S::Lane> {
    Vector3::new(S::narrow(v.x()), S::narrow(v.y()), S::narrow(v.z()))
}
