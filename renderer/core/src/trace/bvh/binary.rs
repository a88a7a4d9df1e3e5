//! The binary hierarchy that the eight-wide one is collapsed from.

use std::collections::HashMap;
use std::ops::Range;

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;

use super::quality::BuildQuality;

/// How many boxes are looked at to see whether many coincide.
const SAMPLES: usize = 4096;
/// So many equal ones among them are many.
const MANY: usize = 4;

/// Builds the hierarchy over boxes; parents come before their children.
///
/// The builder merges the nearest pairs of clusters in rounds. Where boxes coincide, all are equally near,
/// a round merges one pair, and the time is quadratic. So boxes that coincide count as one, and are
/// halved among the nodes below its leaf. To find them all costs as much as to build, which is only done
/// where a sample has many.
pub fn build(boxes: Vec<Aabb>, quality: BuildQuality) -> Bvh2 {
    if !many_coincide(&boxes) {
        return build_distinct(&boxes, quality);
    }
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    order.sort_unstable_by_key(|&index| (key(&boxes[index as usize]), index));
    let mut start = 0;
    let coincide = |&a: &u32, &b: &u32| key(&boxes[a as usize]) == key(&boxes[b as usize]);
    let groups = order.chunk_by(coincide).map(|group| {
        let range = start..start + group.len();
        start = range.end;
        range
    });
    let groups: Vec<Range<usize>> = groups.collect();
    let distinct: Vec<Aabb> =
        groups.iter().map(|group| boxes[order[group.start] as usize]).collect();
    let mut binary = build_distinct(&distinct, quality);
    for index in 0..binary.nodes.len() {
        if binary.nodes[index].is_leaf() {
            let group = binary.primitive_indices[binary.nodes[index].first_index as usize];
            halve(&mut binary, index, groups[group as usize].clone());
        }
    }
    binary.primitive_indices = order;
    binary
}

fn build_distinct(boxes: &[Aabb], quality: BuildQuality) -> Bvh2 {
    let mut build_time = std::time::Duration::ZERO;
    let mut binary = build_bvh2(boxes, quality.parameters(), &mut build_time);
    if !binary.children_are_ordered_after_parents {
        binary.reorder_in_stack_traversal_order();
    }
    binary
}

/// Makes a leaf the root of a balanced hierarchy over a range of primitives with the same box.
fn halve(binary: &mut Bvh2, leaf: usize, members: Range<usize>) {
    let mut pending = vec![(leaf, members)];
    while let Some((index, members)) = pending.pop() {
        let first = binary.nodes.len();
        let node = &mut binary.nodes[index];
        if members.len() == 1 {
            (node.first_index, node.prim_count) = (members.start as u32, 1);
            continue;
        }
        (node.first_index, node.prim_count) = (first as u32, 0);
        let child = *node;
        binary.nodes.extend([child; 2]);
        let middle = members.start + members.len() / 2;
        pending.extend([(first, members.start..middle), (first + 1, middle..members.end)]);
    }
}

fn many_coincide(boxes: &[Aabb]) -> bool {
    if boxes.len() < SAMPLES {
        return false;
    }
    let mut counts: HashMap<[u32; 6], usize> = HashMap::new();
    let samples = boxes.iter().step_by(boxes.len() / SAMPLES);
    samples.into_iter().any(|sample| {
        let count = counts.entry(key(sample)).or_default();
        *count += 1;
        *count == MANY
    })
}

/// What is equal for boxes that coincide.
fn key(sample: &Aabb) -> [u32; 6] {
    let ([a, b, c], [d, e, f]) = (sample.min.to_array(), sample.max.to_array());
    // Zeros of either sign are the same place.
    [a, b, c, d, e, f].map(|coordinate| (coordinate + 0.0).to_bits())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    fn depth(binary: &Bvh2) -> usize {
        let mut depths = vec![1; binary.nodes.len()];
        for (index, node) in binary.nodes.iter().enumerate() {
            if !node.is_leaf() {
                let first = node.first_index as usize;
                assert!(first > index);
                let below = depths[index] + 1;
                depths[first..first + 2].fill(below);
            }
        }
        depths.into_iter().max().unwrap_or(0)
    }

    /// Without their groups the builder would take minutes.
    #[test]
    fn coincident_boxes_are_halved() {
        let point = |x: f32| Aabb::new(Vec3::splat(x).into(), Vec3::splat(x).into());
        let mut boxes = vec![point(1.0); 200_000];
        boxes.extend((0..1000).map(|i| point(i as f32)));
        boxes.extend([point(0.0), point(-0.0)]);
        let binary = build(boxes.clone(), BuildQuality::Low);
        let mut found: Vec<u32> = Vec::new();
        for node in binary.nodes.iter().filter(|node| node.is_leaf()) {
            assert_eq!(node.prim_count, 1);
            found.push(binary.primitive_indices[node.first_index as usize]);
            let inside = &boxes[*found.last().unwrap() as usize];
            assert!(node.aabb().min == inside.min && node.aabb().max == inside.max);
        }
        found.sort_unstable();
        assert!(found.into_iter().eq(0..boxes.len() as u32));
        assert!(depth(&binary) < 64, "{}", depth(&binary));
    }
}
