//! The variable of an optimisation that a parameter becomes.

use crate::Error;
use crate::experiment::TunedParameter;
use crate::laplacian::{Laplacian, System, Weights};
use crate::optimize::{Preconditioner, Scale, Variable};
use crate::scene::table::{self, LARGEST_EXPONENT};
use crate::scene::{Object, Scene};

/// The variable for a parameter: with its own bounds and learning rate, or those of the table of
/// parameters.
pub(super) fn variable(
    scene: &Scene,
    tuned: &TunedParameter,
    common_rate: Option<f64>,
    target: Option<Vec<f64>>,
) -> Result<Variable, Error> {
    let row = table::row(tuned.id);
    let initial = scene.get(tuned.id).into_owned();
    let usual_rate = || match tuned.scale {
        Scale::Linear => row.rate * scene.natural_scale(tuned.id),
        Scale::Log => Scale::LOG_RATE,
    };
    let rate = tuned.learning_rate.or(common_rate).unwrap_or_else(usual_rate);
    let mut variable = Variable::new(scene.path(tuned.id).to_string(), initial, rate);
    variable.scale = tuned.scale;
    let (low, high) = scene.range(tuned.id);
    variable = variable.bounded(bound(low), bound(high));
    let narrow = |bounds: &mut [f64], given: &Option<Vec<f64>>, tighter: fn(f64, f64) -> f64| {
        for (bound, given) in bounds.iter_mut().zip(given.iter().flatten()) {
            *bound = tighter(*bound, *given);
        }
    };
    narrow(&mut variable.min, &tuned.min, f64::max);
    narrow(&mut variable.max, &tuned.max, f64::min);
    if tuned.min.is_none() {
        for (i, min) in variable.min.iter_mut().enumerate() {
            let truth = target.as_ref().map_or(f64::INFINITY, |target| target[i]);
            *min = min.max(scene.usual_min(tuned.id).min(variable.initial[i]).min(truth));
        }
    }
    if tuned.max.is_none() {
        for (i, max) in variable.max.iter_mut().enumerate() {
            // What is above it to begin with, or is known to be, may stay there.
            let truth = target.as_ref().map_or(f64::NEG_INFINITY, |target| target[i]);
            *max = max.min(row.usual_max.max(variable.initial[i]).max(truth));
        }
    }
    if let Some(spread) = &tuned.spread {
        variable.spread.clone_from(spread);
    }
    variable.target = target;
    if let (Some(lambda), Object::Mesh(mesh)) = (tuned.large_steps, tuned.id.object) {
        let mesh = &scene.meshes()[mesh];
        let laplacian = Laplacian::new(&mesh.vertices, &mesh.triangles, Weights::Uniform);
        let system = System::new(&laplacian, lambda).map_err(|error| {
            Error::new(format_args!("{}.{}", scene.path(tuned.id), error.place), error.problem)
        })?;
        let name = format!("large steps, lambda {lambda:e}");
        variable.preconditioner = Some(Preconditioner::new(name, move |block| system.solve(block)));
    }
    Ok(variable)
}

/// An end of a range as a bound. Where numbers only leave what single precision holds there is none:
/// coordinates of a box that large keep no digits, and who comes there has gone wrong and is to know.
fn bound(end: f64) -> f64 {
    if end.abs() > LARGEST_EXPONENT { f64::INFINITY.copysign(end) } else { end }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::variable;
    use crate::experiment::TunedParameter;
    use crate::scene::{MaterialObject, Scene};
    use crate::{Camera, Material};

    /// Where facets are as wide as they get, a roughness has no derivative to leave by.
    #[test]
    fn a_roughness_stays_where_it_changes_something() {
        let mut scene = Scene::new(1, 1, Camera::looking(DVec3::Z, DVec3::ZERO));
        let glossy = |roughness| MaterialObject::metallic_roughness(DVec3::ONE, 0.5, roughness);
        scene.add_material("glossy", glossy(0.3)).unwrap();
        scene.add_material("smooth", glossy(0.002)).unwrap();
        scene.add_material("matt", Material::lambertian(DVec3::ONE)).unwrap();
        let least = |name: &str, min: Option<f64>, truth: Option<f64>| {
            let id = scene.parameter(&format!("material.{name}.roughness")).unwrap();
            let min = min.map(|min| vec![min]);
            let tuned = TunedParameter { min, ..TunedParameter::new(id) };
            variable(&scene, &tuned, None, truth.map(|truth| vec![truth])).unwrap().min[0]
        };
        assert_eq!(least("glossy", None, None), 0.01);
        assert_eq!(least("glossy", Some(0.0), None), 0.0);
        assert_eq!(least("glossy", None, Some(0.004)), 0.004);
        assert_eq!(least("smooth", None, None), 0.002);
        assert_eq!(least("matt", None, None), 0.0);
    }
}
