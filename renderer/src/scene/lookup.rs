//! From a path that a person typed to a parameter.

use super::{ParameterId, Scene};

/// How many paths a message lists at most.
const LISTED: usize = 8;

impl Scene {
    /// The parameter that a path names.
    ///
    /// # Errors
    ///
    /// If there is none: one line that says so and lists the paths that are closest.
    pub fn find_parameter(&self, path: &str) -> Result<ParameterId, String> {
        if let Some(id) = self.parameter(path) {
            return Ok(id);
        }
        let paths = self.parameter_ids().into_iter().map(|id| self.path(id).to_string());
        // The longest common beginning tells what the person meant: the object, or only its kind.
        let common =
            |other: &str| path.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
        let mut paths: Vec<(usize, String)> = paths.map(|p| (common(&p), p)).collect();
        paths.sort_by_key(|(common, _)| std::cmp::Reverse(*common));
        let longest = paths.first().map_or(0, |(common, _)| *common);
        let close: Vec<&str> = paths
            .iter()
            .filter(|(common, _)| *common == longest && longest > 0)
            .map(|(_, p)| p.as_str())
            .take(LISTED)
            .collect();
        Err(if close.is_empty() {
            format!(
                "no parameter `{path}`: paths begin with camera, light, material, sphere or mesh"
            )
        } else {
            format!("no parameter `{path}`; closest: {}", close.join(", "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo::demo_experiment;

    #[test]
    fn a_wrong_path_leads_to_the_right_one() {
        let scene = demo_experiment().unwrap().scene;
        assert_eq!(scene.find_parameter("camera.vfov"), Ok(ParameterId::Vfov));
        assert_eq!(
            scene.find_parameter("light.key.positon").unwrap_err(),
            "no parameter `light.key.positon`; closest: light.key.position"
        );
        let error = scene.find_parameter("x").unwrap_err();
        assert!(error.contains("paths begin with camera"), "{error}");
    }
}
