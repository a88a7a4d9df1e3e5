//! Images of a run as it is.

use std::sync::{Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::orbit::Orbit;
use super::state::Position;
use crate::Error;
use crate::Image;
use crate::display::range_of_measure;
use crate::files::images::picture_of_measure;
use crate::recovery::{Recovery, TargetImage};
use crate::render::Renderer;
use crate::scene::{Integrator, ParameterId, PathTracing};
use crate::settings::{Edges, Pass, Sampling, Settings};

/// Larger images of views are halved until they are no larger.
const LARGEST_SIDE: u32 = 640;
/// The most paths through a pixel of what goes around the scene.
const ORBIT_SAMPLES: u32 = 2;

/// What images are made of.
pub(super) struct Stage {
    ids: Vec<ParameterId>,
    settings: Settings,
    targets: Vec<TargetImage>,
    /// The names of the targets.
    pub names: Vec<String>,
    /// The latest image of a view, with the target and the iteration that it is of.
    latest: Mutex<Option<(usize, Option<u64>, Image)>>,
    /// Some threads of their own: the run is slowed by no more than they take, and they do not wait for it.
    pool: Option<ThreadPool>,
}

impl Stage {
    pub fn new(recovery: &Recovery<'_>) -> Self {
        let scene = recovery.scene();
        let name = |target: &TargetImage| {
            let view = match target.name(scene) {
                "" => "camera",
                name => name,
            };
            let pass = match target.pass {
                Pass::Radiance => String::new(),
                pass => format!(" ({})", pass.name()),
            };
            let held_out = if target.held_out { " (held out)" } else { "" };
            format!("{view}{pass}{held_out}")
        };
        let targets = recovery.targets();
        let threads = (rayon::current_num_threads() / 2).max(1);
        Self {
            ids: recovery.ids().to_vec(),
            settings: *recovery.render_settings(),
            names: targets.iter().map(name).collect(),
            targets: targets.iter().map(|target| target.fitting(LARGEST_SIDE)).collect(),
            latest: Mutex::new(None),
            pool: ThreadPoolBuilder::new().num_threads(threads).build().ok(),
        }
    }

    /// The picture that a target is.
    pub fn target(&self, target: usize) -> Image {
        let target = &self.targets[target];
        target.picture(&target.image)
    }

    /// A picture of what the scene shows of a target where a run is.
    pub fn current(&self, target: usize, at: &Position) -> Image {
        self.targets[target].picture(&self.rendered(target, at))
    }

    fn rendered(&self, target: usize, at: &Position) -> Image {
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((of, iteration, image)) = &*latest
            && (*of, *iteration) == (target, at.iteration)
        {
            return image.clone();
        }
        let target_image = &self.targets[target];
        let mut image =
            self.within_pool(|| target_image.render(&at.scene(&self.ids), &self.settings));
        image.blacken_non_finite();
        *latest = Some((target, at.iteration, image.clone()));
        image
    }

    /// Where the latest image of a target differs from it, [scaled](for_the_eye), and by what.
    pub fn difference(&self, target: usize, at: &Position) -> (Image, f32) {
        let shown = {
            let latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
            latest.as_ref().filter(|(of, ..)| *of == target).map(|(.., image)| image.clone())
        };
        let image = shown.unwrap_or_else(|| self.rendered(target, at));
        let difference = self.targets[target].difference(&image);
        for_the_eye(difference.unwrap_or_else(|| Image::black(1, 1)))
    }

    /// The scene where a run is from elsewhere, in a width and a height.
    pub fn orbit(&self, orbit: Orbit, size: [u32; 2], at: &Position) -> Result<Image, Error> {
        let mut scene = at.scene(&self.ids);
        scene.camera = orbit.camera(&scene);
        scene.views.clear();
        [scene.width, scene.height] = size;
        // Narrow images are as wide as others are high.
        let [width, height] = size.map(f64::from);
        scene.camera.film_scale *= (height / width).max(1.0);
        if let Integrator::Path(paths) = scene.integrator {
            let samples = paths.samples.min(ORBIT_SAMPLES);
            scene.integrator = Integrator::Path(PathTracing { samples, ..paths });
        }
        // What is matched by depth or normals alone may have no light.
        let shows_light = self.targets.iter().any(|target| target.pass == Pass::Radiance);
        let pass = if shows_light { Pass::Radiance } else { Pass::Normals };
        let settings =
            Settings { pass, edges: Edges::Off, sampling: Sampling::default(), ..self.settings };
        let mut image =
            self.within_pool(|| Renderer::new(&scene, &settings).map(|it| it.render()))?;
        if pass.is_measure() {
            let range = range_of_measure(&image, pass);
            picture_of_measure(&mut image, range);
        }
        Ok(image)
    }

    fn within_pool<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

/// A difference over what is white then: what one of a hundred pixels exceeds, since some on edges differ by so
/// much that nothing else would be seen.
fn for_the_eye(mut difference: Image) -> (Image, f32) {
    let largest = |pixel: &[f32; 3]| pixel.iter().copied().fold(0.0, f32::max);
    let mut sizes: Vec<f32> = difference.pixels.iter().map(largest).collect();
    sizes.sort_by(f32::total_cmp);
    let exceeded = sizes[sizes.len() - 1 - sizes.len() / 100];
    let white = if exceeded > 0.0 { exceeded } else { sizes[sizes.len() - 1] };
    if white > 0.0 {
        difference.pixels.as_flattened_mut().iter_mut().for_each(|channel| *channel /= white);
    }
    (difference, white)
}
