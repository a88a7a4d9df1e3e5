//! What images are compared with.

use std::path::Path;

use super::Quality;
use crate::display::range_of_measure;
use crate::experiment::{MatchedPass, OptimizeSection, Target, ViewTarget};
use crate::files::images::picture_of_measure;
use crate::files::{LoadedImage, load_image, load_mask, load_pass};
use crate::loss::{ImageLoss, LossKind};
use crate::render::Renderer;
use crate::scene::Scene;
use crate::settings::{Pass, Settings};
use crate::{Error, Image};

/// An image to be matched: of a view, or of the camera of a scene without views.
#[derive(Clone, Debug)]
pub struct TargetImage {
    /// The index of the view; nothing in a scene without views.
    pub view: Option<usize>,
    /// What it shows of surfaces.
    pub pass: Pass,
    /// Its pixels.
    pub image: Image,
    /// Whether it was never matched, only compared with: see [`qualities`](super::Recovery::qualities).
    pub held_out: bool,
    pub(super) saturates: bool,
    /// How much each pixel counts, if not all the same.
    pub(super) weights: Option<Vec<f32>>,
    /// What the loss is multiplied by.
    pub(super) weight: f64,
}

impl TargetImage {
    /// The name of the view; empty in a scene without views.
    pub fn name<'a>(&self, scene: &'a Scene) -> &'a str {
        self.view.map_or("", |view| &scene.views()[view].name)
    }

    /// A picture of an image that is compared with this one. Radiance is a picture; of coverage, depth, places and
    /// normals levels are in proportion to a range of this one.
    pub fn picture(&self, image: &Image) -> Image {
        let mut picture = image.clone();
        if self.pass.is_measure() {
            picture_of_measure(&mut picture, range_of_measure(&self.image, self.pass));
        }
        picture
    }

    /// The absolute difference of every channel of the [pictures](Self::picture) of an image and of this one,
    /// as the loss sees them: where the target is clipped, so is the image, and pixels count by their weights.
    /// Nothing if the sizes differ.
    pub fn difference(&self, image: &Image) -> Option<Image> {
        let mut picture = self.picture(image);
        if self.saturates {
            picture.pixels.as_flattened_mut().iter_mut().for_each(|value| *value = value.min(1.0));
        }
        let mut difference = picture.absolute_difference(&self.picture(&self.image))?;
        for (pixel, &weight) in difference.pixels.iter_mut().zip(self.weights.iter().flatten()) {
            // What is masked out need not be finite.
            *pixel = pixel.map(|value| if weight > 0.0 { weight * value } else { 0.0 });
        }
        Some(difference)
    }

    /// What a scene shows of this target, in its size.
    pub(crate) fn render(&self, scene: &Scene, settings: &Settings) -> Image {
        let mut scene = scene.clone();
        let (width, height) = match self.view {
            Some(view) => {
                let view = &mut scene.views[view];
                (&mut view.width, &mut view.height)
            }
            None => (&mut scene.width, &mut scene.height),
        };
        (*width, *height) = (self.image.width, self.image.height);
        self.look(&mut scene);
        let settings = Settings { pass: self.pass, ..*settings };
        Renderer::unchecked(&scene, &settings).render()
    }

    /// This target, halved until no side is longer, as far as both can be.
    #[cfg(feature = "cli")]
    pub(crate) fn fitting(&self, longest: u32) -> Self {
        let (width, height) = (self.image.width, self.image.height);
        let most = width.trailing_zeros().min(height.trailing_zeros());
        let levels = (0..=most).find(|levels| width.max(height) >> levels <= longest);
        self.halved(levels.unwrap_or(most))
    }

    /// How alike the [pictures](Self::picture) of an image of the same size and of this one are.
    ///
    /// # Panics
    ///
    /// If the sizes differ.
    pub fn quality(&self, image: &Image) -> Quality {
        let (picture, target) = (self.picture(image), self.picture(&self.image));
        Quality::of(&picture, &target, self.weights.as_deref())
    }

    /// Makes a scene show what is to be compared.
    pub(super) fn look(&self, scene: &mut Scene) {
        if let Some(view) = self.view {
            scene.look_through(view);
        }
    }

    /// Makes a renderer of a scene that it has taken over show what is to be compared.
    pub(super) fn show(&self, scene: &mut Scene, renderer: &mut Renderer) {
        self.look(scene);
        if renderer.settings().pass != self.pass {
            renderer.show(scene, self.pass);
        }
        if self.view.is_some() {
            renderer.look(scene);
        }
    }

    /// How far an image is from this one, times the weight of the view.
    pub(crate) fn loss(&self, kind: LossKind) -> ImageLoss<'_> {
        let loss = ImageLoss::new(kind, &self.image, self.saturates);
        let loss = match &self.weights {
            Some(weights) => loss.weighted(weights),
            None => loss,
        };
        loss.times(self.weight)
    }

    /// This target with its sides halved.
    pub(super) fn halved(&self, levels: u32) -> Self {
        let (width, height) = (self.image.width, self.image.height);
        self.clone().reduced([width >> levels, height >> levels])
    }

    /// This target with fewer pixels, each the mean of those that it covers, by their weights. Where some of these
    /// are clipped and others are not, nobody knows the mean: such a pixel weighs nothing, unless all are such.
    pub(super) fn reduced(self, [width, height]: [u32; 2]) -> Self {
        let weights = self.weights.unwrap_or_else(|| vec![1.0; self.image.pixels.len()]);
        // What weighs nothing may be anything, also infinite.
        let mean = |value: &dyn Fn([f32; 3]) -> [f32; 3]| {
            let weighted = |(&pixel, &weight): (&[f32; 3], &f32)| match weight {
                0.0 => [0.0; 3],
                weight => value(pixel).map(|value| value * weight),
            };
            let pixels = self.image.pixels.iter().zip(&weights).map(weighted).collect();
            Image { pixels, ..self.image }.reduced(width, height).pixels
        };
        let sums: Vec<f32> = mean(&|_| [1.0; 3]).into_iter().map(|[weight, ..]| weight).collect();
        let by_weight = |(pixel, &sum): ([f32; 3], &f32)| match sum {
            0.0 => [0.0; 3],
            sum => pixel.map(|value| value / sum),
        };
        let pixels = mean(&|pixel| pixel).into_iter().zip(&sums).map(by_weight).collect();
        let clipped = mean(&|pixel| pixel.map(|value| f32::from(value >= 1.0)));
        let is_known = |(pixel, sum): (&[f32; 3], f32)| {
            pixel.iter().all(|&part| !self.saturates || part == 0.0 || part == sum)
        };
        let known = clipped.iter().zip(sums.iter().copied());
        let known = known.map(|of| if is_known(of) { of.1 } else { 0.0 });
        let mut weights: Vec<f32> = known.collect();
        if weights.iter().all(|&weight| weight == 0.0) {
            weights = sums;
        }
        let weights = weights.iter().any(|&weight| weight != 1.0).then_some(weights);
        Self { image: Image { width, height, pixels }, weights, ..self }
    }
}

/// The targets of a section, in the order of the views, and, where they are known, the parameters that made
/// them. `place` names the experiment in errors.
pub(super) fn load(
    scene: &Scene,
    section: &OptimizeSection,
    place: &str,
    settings: &Settings,
) -> Result<(Vec<TargetImage>, Option<Scene>), Error> {
    let truth = match &section.target {
        Some(Target::Values(values)) => {
            let mut truth = scene.clone();
            for (id, values) in values {
                truth.assign(*id, values);
            }
            truth.validate(format_args!("{place}: optimize.target_values"))?;
            Some(truth)
        }
        _ => None,
    };
    let loader = Loader { scene, place, settings, truth: truth.as_ref() };
    let mut targets = Vec::new();
    match scene.views() {
        [] => {
            let mut one = ViewTarget { mask: section.mask.clone(), ..ViewTarget::default() };
            if let Some(Target::Image(path)) = &section.target {
                one.image = Some(path.clone());
            }
            loader.add(None, &one, &mut targets)?;
        }
        views => {
            if let Some(Target::Image(path)) = &section.target {
                let problem =
                    "a scene with views has a target for each of them: `target` in [[view]]";
                return Err(Error::new(path.display(), problem));
            }
            for view in 0..views.len() {
                let default = ViewTarget::default();
                let given = section.views.get(view).unwrap_or(&default);
                loader.add(Some(view), given, &mut targets)?;
            }
        }
    }
    if targets.iter().all(|target| target.held_out) {
        return Err(Error::new(place, "every view is held out: there is nothing to match"));
    }
    Ok((targets, truth))
}

/// What targets are loaded or rendered for.
struct Loader<'a> {
    scene: &'a Scene,
    place: &'a str,
    settings: &'a Settings,
    truth: Option<&'a Scene>,
}

impl Loader<'_> {
    /// Adds the targets of a view, or of the camera.
    fn add(
        &self,
        view: Option<usize>,
        given: &ViewTarget,
        targets: &mut Vec<TargetImage>,
    ) -> Result<(), Error> {
        let first = targets.len();
        let weights = match &given.mask {
            Some(path) => {
                let mask = load_mask(path)?;
                self.check_size(path, &mask, view, "mask")?;
                if mask.pixels.iter().all(|[weight, ..]| *weight == 0.0) {
                    return Err(Error::new(path.display(), "the mask leaves no pixel to match"));
                }
                Some(mask.pixels.into_iter().map(|[weight, ..]| weight).collect())
            }
            None => None,
        };
        let target = TargetImage {
            view,
            pass: self.settings.pass,
            image: Image::black(0, 0),
            held_out: given.held_out,
            saturates: false,
            weights,
            weight: given.weight,
        };
        if let Some(path) = &given.image {
            let LoadedImage { image, saturates } = load_image(path)?;
            self.check_size(path, &image, view, "target")?;
            targets.push(TargetImage { image, saturates, ..target.clone() });
        }
        for MatchedPass { pass, file, weight } in &given.passes {
            let pass = *pass;
            let image = load_pass(file, pass)?;
            self.check_size(file, &image, view, pass.name())?;
            let weight = target.weight * weight;
            targets.push(TargetImage { image, pass, weight, ..target.clone() });
        }
        if targets.len() > first {
            return Ok(());
        }
        let Some(truth) = self.truth else {
            let problem = match view {
                None => {
                    "no target: give an image with --target, or `target` or `target_values` in the section [optimize]"
                        .to_owned()
                }
                Some(view) => format!(
                    "no target for the view `{}`: give it a `target`, a `coverage`, a `depth` or `normals`, or \
                     `target_values` in the section [optimize]",
                    self.scene.views()[view].name
                ),
            };
            return Err(Error::new(self.place, problem));
        };
        let mut truth = truth.clone();
        target.look(&mut truth);
        let image = Renderer::unchecked(&truth, self.settings).render();
        targets.push(TargetImage { image, ..target });
        Ok(())
    }

    /// Whether an image has the size of the camera.
    fn check_size(
        &self,
        path: &Path,
        image: &Image,
        view: Option<usize>,
        what: &str,
    ) -> Result<(), Error> {
        let (camera, [width, height]) = match view {
            None => (format!("camera of {}", self.place), self.scene.size()),
            Some(view) => {
                let view = &self.scene.views()[view];
                (format!("view `{}` of {}", view.name, self.place), [view.width, view.height])
            }
        };
        if [image.width, image.height] == [width, height] {
            return Ok(());
        }
        let Image { width: own_width, height: own_height, .. } = *image;
        let sizes = format!(
            "the {what} has {own_width} x {own_height} pixels, the {camera} has {width} x {height}"
        );
        let is_scaled =
            u64::from(own_width) * u64::from(height) == u64::from(width) * u64::from(own_height);
        let hint = match is_scaled {
            true => format!(" (--width {own_width} renders at the size of the {what})"),
            false => String::new(),
        };
        Err(Error::new(path.display(), sizes + &hint))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target(values: [f32; 8], weights: Option<[f32; 8]>, saturates: bool) -> TargetImage {
        let pixels = values.map(|value| [value, 0.25, 0.5]).to_vec();
        TargetImage {
            view: None,
            pass: Pass::Radiance,
            image: Image { width: 4, height: 2, pixels },
            held_out: false,
            saturates,
            weights: weights.map(Vec::from),
            weight: 1.0,
        }
    }

    /// The weights and the red of the two pixels that all others are covered by.
    fn reduced(target: TargetImage) -> (Option<Vec<f32>>, [f32; 2]) {
        let TargetImage { image, weights, .. } = target.reduced([2, 1]);
        (weights, [image.pixels[0][0], image.pixels[1][0]])
    }

    #[test]
    fn coarse_pixels_are_means_of_what_counts() {
        let values = [0.1, 0.3, 1.0, 0.5, 0.2, 0.2, 0.7, 0.6];
        assert_eq!(reduced(target(values, None, false)), (None, [0.2, 0.7]));
        // What is under the mask shows nowhere.
        let weights = [1.0, 1.0, 0.0, 0.5, 1.0, 1.0, 0.0, 0.0];
        for hidden in [1000.0, f32::INFINITY, f32::NAN] {
            let [a, b, _, d, e, f, ..] = values;
            let values = [a, b, hidden, d, e, f, hidden, hidden];
            let found = reduced(target(values, Some(weights), true));
            assert_eq!(found, (Some(vec![1.0, 0.125]), [0.2, 0.5]));
        }
    }

    #[test]
    fn coarse_pixels_that_are_partly_clipped_weigh_nothing() {
        let values = [0.1, 0.3, 1.0, 0.5, 0.2, 0.2, 0.7, 0.6];
        let (weights, _) = reduced(target(values, None, true));
        assert_eq!(weights, Some(vec![1.0, 0.0]));
        // Unless none would be left.
        assert_eq!(reduced(target([0.5, 1.0, 1.0, 0.5, 0.2, 0.2, 0.7, 0.6], None, true)).0, None);
        assert_eq!(reduced(target([1.0; 8], None, true)), (None, [1.0, 1.0]));
    }
}
