//! Warns of scenes that nothing lights, and of lights that shine on nothing.

use glam::DVec3;

use crate::Warning;
use crate::scene::{Light, LightSource, MaterialObject, Scene};

/// Warns where all is black, or a light of the scene file, which is at `place`, makes no difference.
pub(super) fn of_darkness(scene: &Scene, place: &str) -> Vec<Warning> {
    if is_black(scene) {
        let problem =
            "has no light: add a [[light]], or an `emission` to a material, or all is black";
        return vec![Warning::new(place, problem).of_radiance()];
    }
    let shines_away = scene.lights.iter().filter(|light| match &light.source {
        LightSource::Known(Light::Rectangle(light) | Light::Disc(light)) => {
            let axis = light.right.cross(light.up);
            !reaches_before(scene, light.center, axis.normalize_or_zero())
        }
        _ => false,
    });
    let warning = |name: &String| {
        let place = format_args!("{place}: light.{name}");
        let problem =
            "lights nothing: it shines towards `right` x `up`, where no surface is; -`up` turns it";
        Warning::new(place, problem).of_radiance()
    };
    shines_away.map(|light| warning(&light.name)).collect()
}

/// Whether a scene shows something, but nothing that lights it.
fn is_black(scene: &Scene) -> bool {
    let glows = |material: &MaterialObject| material.values.emission != DVec3::ZERO;
    let Scene { lights, materials, environment, .. } = scene;
    environment.is_none()
        && lights.is_empty()
        && !materials.is_empty()
        && !materials.iter().any(glows)
}

/// Whether a mesh or a sphere has a part before a plane, on the side of its normal. A scene without any has what
/// programs add.
fn reaches_before(scene: &Scene, point: DVec3, normal: DVec3) -> bool {
    let is_before = |place: DVec3, reach: f64| (place - point).dot(normal) + reach > 0.0;
    let shows_nothing = scene.meshes.is_empty() && scene.spheres.is_empty();
    shows_nothing
        || scene.spheres.iter().any(|ball| is_before(ball.values.center, ball.values.radius))
        || scene.meshes.iter().any(|mesh| mesh.world_vertices().any(|place| is_before(place, 0.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{AreaLight, SphereObject};
    use crate::{Camera, Material};

    #[test]
    fn lights_that_shine_away_are_warned_of() {
        let warnings = |up: DVec3| {
            let camera = Camera::looking(DVec3::Z, DVec3::ZERO);
            let mut scene = Scene::new(4, 4, camera);
            scene.add_material("matt", Material::lambertian(DVec3::ONE)).unwrap();
            scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
            let center = DVec3::new(0.0, 0.0, 4.0);
            let (right, color, radiance) = (DVec3::X, DVec3::ONE, 1.0);
            let light = AreaLight { center, right, up, color, radiance };
            scene.add_light("window", Light::Rectangle(light)).unwrap();
            of_darkness(&scene, "s.toml")
        };
        assert_eq!(warnings(DVec3::NEG_Y), []);
        let [warning] = &warnings(DVec3::Y)[..] else { panic!("there is one warning") };
        assert!(warning.to_string().starts_with("s.toml: light.window: lights nothing"));
    }
}
