//! Lights, as `KHR_lights_punctual` has them.

use glam::{DQuat, DVec3};
use renderer_core::scene::{Light, LightObject, LightSource, Scene};
use serde_json::{Value, json};

use crate::warning::Warnings;

/// The name of the extension.
pub(super) const EXTENSION: &str = "KHR_lights_punctual";

/// The lights of a scene that the format has, and a node for each. What it has not is warned of.
pub(super) fn lights(scene: &Scene, warnings: &mut Warnings) -> (Vec<Value>, Vec<Value>) {
    let (mut lights, mut nodes) = (Vec::new(), Vec::new());
    for LightObject { name, source } in &scene.lights {
        let written = match source {
            LightSource::Known(light) => light_and_place(light),
            LightSource::Custom { .. } => None,
        };
        let Some((mut light, mut node)) = written else {
            let problem = "is left out: the lights of glTF are points, spots and distant lights";
            warnings.add(name, format_args!("light.{name}"), problem);
            continue;
        };
        light["name"] = name[..].into();
        node["name"] = name[..].into();
        node["extensions"] = json!({ EXTENSION: { "light": lights.len() } });
        lights.push(light);
        nodes.push(node);
    }
    if scene.environment.is_some() {
        warnings.add("environment", "environment", "is left out: glTF has none");
    }
    (lights, nodes)
}

/// A light, and the node that places it: lights shine along the negative z axis of theirs.
fn light_and_place(light: &Light<f64>) -> Option<(Value, Value)> {
    let turned = |from: DVec3, to: DVec3| DQuat::from_rotation_arc(from, to.normalize()).to_array();
    Some(match light {
        Light::Point(light) => (
            shining("point", light.color, light.radiant_intensity),
            json!({ "translation": light.position.to_array() }),
        ),
        Light::Distant(light) => (
            shining("directional", light.color, light.irradiance),
            json!({ "rotation": turned(DVec3::Z, light.direction) }),
        ),
        Light::Spot(light) => {
            let mut spot = shining("spot", light.color, light.radiant_intensity);
            spot["spot"] = json!({
                "innerConeAngle": light.inner_angle.to_radians(),
                "outerConeAngle": light.outer_angle.to_radians(),
            });
            let rotation = turned(DVec3::NEG_Z, light.direction);
            (spot, json!({ "translation": light.position.to_array(), "rotation": rotation }))
        }
        _ => return None,
    })
}

/// A light of a kind. The channels of its color are at most 1, as the format asks for.
fn shining(kind: &str, color: DVec3, intensity: f64) -> Value {
    let brightest = color.max_element().max(1.0);
    let color = (color / brightest).to_array();
    json!({ "type": kind, "color": color, "intensity": intensity * brightest })
}
