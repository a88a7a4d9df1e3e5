//! `renderer` without a command: the light of an embedded scene is recovered from one image.

use std::path::Path;

use glam::DVec3;

use super::optimize::{Earlier, recover, report};
use super::output::print;
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::demo::demo_experiment;
use crate::recovery::Recovery;
use crate::recovery::team::Alone;
use crate::scene::{Light, LightSource, Scene};
use crate::settings::Settings;

pub(super) fn run(arithmetic: Arithmetic) -> Result<(), Error> {
    let out = Path::new("out/demo");
    print("Recovering the light of a scene from one image of it.")?;
    let experiment = demo_experiment()?;
    let recovery = Recovery::new(
        &experiment,
        "the embedded demo",
        &Settings { arithmetic, ..Settings::default() },
    )?;
    // The demonstration always starts from the beginning.
    let outcome = recover(&experiment, &recovery, &Alone, out, Earlier::Replaced, None)?;
    print(report(&recovery, &outcome, out))?;

    let truth: Vec<f64> =
        recovery.variables().iter().flat_map(|v| v.target.clone().unwrap_or_default()).collect();
    let true_light = incident_light(&recovery.scene_at(&truth));
    let found_light = incident_light(&recovery.scene_at(&outcome.best.x));
    if let (Some(truth), Some(found)) = (true_light, found_light) {
        print(format_args!(
            "At the tree: direction of the light {:.3} degrees off, irradiance {:.3} % off.",
            truth.0.angle_between(found.0).to_degrees(),
            (found.1 / truth.1 - 1.0).abs() * 100.0
        ))?;
        print(
            "(From afar, a light twice as distant and four times as strong looks the same: these two are what the image tells best.)",
        )?;
    }
    Ok(())
}

/// Direction and irradiance of the point light of a scene at the middle of its mesh.
fn incident_light(scene: &Scene) -> Option<(DVec3, f64)> {
    let mesh = scene.meshes.first()?;
    let sum: DVec3 = mesh.world_vertices().sum();
    let middle = sum / mesh.vertices.len() as f64;
    match scene.lights.first()?.source {
        LightSource::Known(Light::Point(light)) => {
            let to_light = light.position - middle;
            Some((to_light, light.radiant_intensity / to_light.length_squared()))
        }
        _ => None,
    }
}
