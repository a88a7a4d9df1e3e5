//! The nodes of a scene, placed in the world.

use glam::{DMat4, DQuat, DVec3};

use super::document::{Document, Node, get};

/// A node of the scene.
pub(super) struct PlacedNode<'a> {
    pub node: &'a Node,
    pub to_world: DMat4,
}

/// The nodes of the default scene, or of the first, or, if there is none, all nodes; parents before
/// their children.
pub(super) fn placed(document: &Document) -> Result<Vec<PlacedNode<'_>>, String> {
    let roots = match (document.scene, document.scenes.first()) {
        (Some(index), _) => get(&document.scenes, index, "scenes")?.nodes.clone(),
        (None, Some(first)) => first.nodes.clone(),
        (None, None) => roots(document),
    };
    let mut seen = vec![false; document.nodes.len()];
    let mut placed = Vec::new();
    // The next node is the last one.
    let mut open: Vec<_> = roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY)).collect();
    while let Some((index, parent)) = open.pop() {
        let node = get(&document.nodes, index, "nodes")?;
        if std::mem::replace(&mut seen[index], true) {
            return Err(format!("nodes[{index}] has two parents, or is its own ancestor"));
        }
        let to_world = parent * to_parent(node);
        open.extend(node.children.iter().rev().map(|&child| (child, to_world)));
        placed.push(PlacedNode { node, to_world });
    }
    Ok(placed)
}

/// The nodes that are nobody's children.
fn roots(document: &Document) -> Vec<usize> {
    let mut is_root = vec![true; document.nodes.len()];
    for &child in document.nodes.iter().flat_map(|node| &node.children) {
        if let Some(root) = is_root.get_mut(child) {
            *root = false;
        }
    }
    (0..is_root.len()).filter(|&i| is_root[i]).collect()
}

fn to_parent(node: &Node) -> DMat4 {
    if let Some(columns) = &node.matrix {
        return DMat4::from_cols_array(columns);
    }
    let rotation = node.rotation.map_or(DQuat::IDENTITY, DQuat::from_array);
    // A rotation of length 0 is none.
    let rotation = if rotation.length() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(
        node.scale.map_or(DVec3::ONE, DVec3::from_array),
        rotation,
        node.translation.map_or(DVec3::ZERO, DVec3::from_array),
    )
}
