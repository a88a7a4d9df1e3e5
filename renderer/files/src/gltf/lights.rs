//! The camera and the lights.

use glam::{DMat4, DVec3};
use renderer_core::scene::{Camera, DistantLight, Light, PointLight, SpotLight};

use super::document::{self, Document, LightDefinition};
use super::nodes::PlacedNode;
use crate::names::{Names, clean_name};

pub(super) type FoundCamera = Option<(Camera<f64>, Option<f64>)>;

/// The first camera, if there is one, and the width of its image over the height, if it says.
pub(super) fn camera(document: &Document, nodes: &[PlacedNode<'_>]) -> Result<FoundCamera, String> {
    let Some((index, node)) = nodes.iter().find_map(|node| Some((node.node.camera?, node))) else {
        return Ok(None);
    };
    let definition = document::get(&document.cameras, index, "cameras")?;
    let Some(perspective) = &definition.perspective else {
        return Err(format!(
            "cameras[{index}]: is not a perspective camera; name the file as a [[mesh]] of a scene \
             file to give it another one"
        ));
    };
    let look_from = node.to_world.transform_point3(DVec3::ZERO);
    let axis = |axis: DVec3| node.to_world.transform_vector3(axis).normalize_or_zero();
    let (forward, up) = (axis(DVec3::NEG_Z), axis(DVec3::Y));
    let camera = Camera {
        look_from,
        look_at: look_from + forward,
        up,
        vfov: perspective.yfov.to_degrees(),
        film_scale: 1.0,
    };
    if perspective.aspect_ratio.is_some_and(|ratio| ratio <= 0.0) {
        return Err(format!("cameras[{index}]: its aspectRatio must be above 0"));
    }
    Ok(Some((camera, perspective.aspect_ratio)))
}

/// The names and values of the lights.
pub(super) fn lights(
    document: &Document,
    nodes: &[PlacedNode<'_>],
) -> Result<Vec<(String, Light<f64>)>, String> {
    let definitions = &document.extensions.lights.lights;
    let (mut lights, mut given) = (Vec::new(), Names::default());
    for PlacedNode { node, to_world, .. } in nodes {
        let Some(reference) = &node.extensions.light else { continue };
        let index = reference.light;
        let definition = document::get(definitions, index, "lights")?;
        let light = light(definition, *to_world)
            .map_err(|problem| format!("KHR_lights_punctual.lights[{index}]: {problem}"))?;
        let names = [node.name.as_deref(), definition.name.as_deref()];
        let name = names.into_iter().flatten().map(clean_name).find(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| "light".to_owned());
        lights.push((given.take(name), light));
    }
    Ok(lights)
}

pub(super) fn light(definition: &LightDefinition, to_world: DMat4) -> Result<Light<f64>, String> {
    let color = DVec3::from_array(definition.color);
    match definition.kind.as_str() {
        "point" => Ok(Light::Point(PointLight {
            position: to_world.transform_point3(DVec3::ZERO),
            color,
            radiant_intensity: definition.intensity,
        })),
        "directional" => Ok(Light::Distant(DistantLight {
            // It shines along its own -z; ours is the direction towards the light.
            direction: to_world.transform_vector3(DVec3::Z).normalize_or_zero(),
            color,
            irradiance: definition.intensity,
        })),
        "spot" => {
            let Some(spot) = &definition.spot else {
                return Err("is a spot light without the angles of its cone".to_owned());
            };
            Ok(Light::Spot(SpotLight {
                position: to_world.transform_point3(DVec3::ZERO),
                direction: to_world.transform_vector3(DVec3::NEG_Z).normalize_or_zero(),
                color,
                radiant_intensity: definition.intensity,
                inner_angle: spot.inner_cone_angle.to_degrees(),
                outer_angle: spot.outer_cone_angle.to_degrees(),
            }))
        }
        kind => Err(format!("is a {kind} light; point, directional and spot lights are read")),
    }
}
