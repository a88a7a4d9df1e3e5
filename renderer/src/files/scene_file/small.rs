//! Objects that are too small beside the scene.

use crate::Warning;
use crate::scene::Scene;

/// The size of an object, as a part of that of the scene, below which single precision no longer tells where its surface is: rays
/// meet surfaces in it, whatever the kernels compute in.
const LEAST: f64 = 1e-5;

/// Warns of the smallest object of a scene, from the file `place`, if it is too small.
pub(super) fn of_smallness(scene: &Scene, place: &str) -> Vec<Warning> {
    if scene.spheres.len() + scene.meshes.len() < 2 {
        return Vec::new();
    }
    let balls = scene.spheres.iter().map(|ball| (format!("sphere.{}", ball.name), ball.bounds()));
    let meshes = scene
        .meshes
        .iter()
        .filter_map(|mesh| Some((format!("mesh.{}", mesh.name), mesh.bounds()?)));
    let whole = scene.bounding_box().map_or(0.0, |(low, high)| low.distance(high));
    let sizes = balls.chain(meshes).map(|(name, (low, high))| (name, low.distance(high)));
    // Of what has no size at all it is said that nothing is seen.
    let smallest = sizes.filter(|(_, size)| *size > 0.0).min_by(|(_, a), (_, b)| a.total_cmp(b));
    let warning = |(name, size): (String, f64)| {
        let problem = format!(
            "is {:.0e} times as large as the scene: shadows and gradients of what is so small are noisy, for rays meet \
             surfaces in single precision",
            size / whole
        );
        Warning::new(format_args!("{place}: {name}"), problem)
    };
    smallest.filter(|(_, size)| *size < LEAST * whole).map(warning).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::SphereObject;
    use crate::{Camera, Material};

    #[test]
    fn objects_that_are_too_small_are_warned_of() {
        let warnings = |distance: f64| {
            let mut scene = Scene::new(4, 4, Camera::looking(DVec3::Z, DVec3::ZERO));
            scene.add_material("matt", Material::lambertian(DVec3::ONE)).unwrap();
            scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
            scene.add_sphere(SphereObject::new("moon", distance * DVec3::X, 10.0)).unwrap();
            of_smallness(&scene, "s.toml")
        };
        assert_eq!(warnings(1e5), []);
        let [warning] = &warnings(1e6)[..] else { panic!("there is one warning") };
        assert!(warning.to_string().starts_with("s.toml: sphere.ball: is 3e-6 times as large"));
    }
}
