//! The ways to a gradient.

use glam::Vec3;

use crate::Image;
use crate::loss::{ImageLoss, PixelLoss};
use crate::recovery::Recovery;
use crate::render::Renderer;
use crate::scene::{Object, ParameterId, Scene};
use crate::settings::{Sampling, Settings};
use crate::tape::TapeRenderer;

/// A way to the gradient of a loss at the parameters of a scene.
pub(super) trait Engine {
    /// Moves away from the parameters, so that the next gradient has to take them over, as in an
    /// optimisation. Not measured.
    fn leave(&mut self) {}

    /// Takes the parameters over; their gradient.
    fn gradient(&mut self) -> Vec<f64>;

    /// The image that the gradient is of, where it may be another one than the reference's.
    fn image(&self) -> Option<Image> {
        None
    }
}

/// What engines are asked for.
#[derive(Clone, Copy)]
pub(super) struct Question<'a> {
    pub recovery: &'a Recovery<'a>,
    pub settings: Settings,
}

impl<'a> Question<'a> {
    fn scene(&self) -> &'a Scene {
        self.recovery.scene()
    }

    fn ids(&self) -> &'a [ParameterId] {
        self.recovery.ids()
    }

    fn loss(&self) -> ImageLoss<'a> {
        self.recovery.targets()[0].loss(self.recovery.loss_kind())
    }

    fn renderer(&self) -> Renderer {
        Renderer::unchecked(self.scene(), &self.settings)
    }

    /// The scene with its parameters a hair away from where they are; if `geometry` says so, with all
    /// spheres and vertices, too.
    fn moved(&self, geometry: Geometry) -> Scene {
        let mut ids = self.ids().to_vec();
        if geometry != Geometry::AsAsked {
            ids.extend(self.scene().parameters().into_iter().filter(is_geometry));
        }
        let mut scene = self.scene().clone();
        for id in ids {
            let moved: Vec<f64> = scene.get(id).iter().map(|value| value * (1.0 + 1e-9)).collect();
            scene.assign(id, &moved);
        }
        scene
    }
}

/// Whether the acceleration structure depends on a parameter.
pub(super) fn is_geometry(id: &ParameterId) -> bool {
    match id.object {
        Object::Mesh(_) => !["texture_coordinates", "normals"].contains(&id.field),
        Object::Sphere(_) | Object::Shape(_) => true,
        Object::Camera | Object::View(_) | Object::Environment | Object::Light(_) => false,
        Object::Material(_) | Object::Texture(_) => false,
    }
}

/// What happens to spheres and meshes between gradients.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Geometry {
    /// Only requested geometry changes; the hierarchy is refitted.
    AsAsked,
    /// All geometry changes; the hierarchy is refitted.
    Refitted,
    /// All geometry changes; the hierarchy is rebuilt.
    Rebuilt,
}

/// The generated adjoint: one pass for all derivatives.
pub(super) struct Adjoint<'a> {
    question: Question<'a>,
    renderer: Renderer,
    moved: Scene,
    geometry: Geometry,
}

impl<'a> Adjoint<'a> {
    pub fn new(question: Question<'a>) -> Self {
        Self::with_geometry(question, Geometry::AsAsked)
    }

    pub fn with_geometry(question: Question<'a>, geometry: Geometry) -> Self {
        let moved = question.moved(geometry);
        Self { question, renderer: question.renderer(), moved, geometry }
    }

    /// Changes the rays through pixels.
    pub fn set_sampling(&mut self, sampling: Sampling) {
        self.question.settings.sampling = sampling;
        self.renderer.resample(sampling);
    }

    /// Takes the parameters over.
    fn arrive(&mut self) {
        match self.geometry {
            Geometry::Rebuilt => self.renderer = self.question.renderer(),
            _ => self.renderer.update(self.question.scene()),
        }
    }

    fn gradient_of(&self, loss: &dyn PixelLoss) -> Vec<f64> {
        let Question { recovery, .. } = self.question;
        let result = self.renderer.loss_and_gradient(recovery.scene(), loss, recovery.ids());
        result.gradient.concat()
    }
}

impl Engine for Adjoint<'_> {
    fn leave(&mut self) {
        self.renderer.update(&self.moved);
    }

    fn gradient(&mut self) -> Vec<f64> {
        self.arrive();
        self.gradient_of(&self.question.loss())
    }

    fn image(&self) -> Option<Image> {
        Some(self.renderer.render())
    }
}

/// The image first, then the derivative of the loss by it, then the pullback along the same rays, which
/// are traced again: what a loss takes that is no sum over pixels.
pub(super) struct ImageFirst<'a>(pub Adjoint<'a>);

impl Engine for ImageFirst<'_> {
    fn leave(&mut self) {
        self.0.leave();
    }

    fn gradient(&mut self) -> Vec<f64> {
        let Self(adjoint) = self;
        adjoint.arrive();
        let image = adjoint.renderer.render();
        let loss = adjoint.question.loss();
        let places = (0..image.height).flat_map(|y| (0..image.width).map(move |x| (x, y)));
        let cotangent = |((x, y), &pixel): ((u32, u32), &[f32; 3])| {
            loss.evaluate(x, y, Vec3::from_array(pixel).as_dvec3()).1.as_vec3().into()
        };
        let pixels = places.zip(&image.pixels).map(cotangent).collect();
        let Question { recovery, .. } = adjoint.question;
        let cotangent = Image { pixels, ..image };
        adjoint.renderer.pullback(recovery.scene(), &cotangent, recovery.ids()).concat()
    }
}

/// Central differences of the loss: two images for each derivative.
pub(super) struct Differences<'a> {
    question: Question<'a>,
    renderer: Renderer,
    scene: Scene,
    /// The numbers to differentiate by, and the step of each.
    steps: Vec<(ParameterId, usize, f64)>,
}

impl<'a> Differences<'a> {
    pub fn new(question: Question<'a>, steps: Vec<(ParameterId, usize, f64)>) -> Self {
        let scene = question.scene().clone();
        Self { question, renderer: question.renderer(), scene, steps }
    }
}

impl Engine for Differences<'_> {
    fn gradient(&mut self) -> Vec<f64> {
        let Self { question, renderer, scene, steps } = self;
        let image_loss = question.loss();
        let derivative = |&(id, index, step): &(ParameterId, usize, f64)| {
            let at = scene.get(id).into_owned();
            let mut loss_at = |offset: f64| {
                let mut values = at.clone();
                values[index] += offset;
                scene.assign(id, &values);
                renderer.update(scene);
                renderer.loss(&image_loss)
            };
            let (above, below) = (loss_at(step), loss_at(-step));
            scene.assign(id, &at);
            (above - below) / (2.0 * step)
        };
        steps.iter().map(derivative).collect()
    }
}

/// Dual numbers: the image and its derivative once for each of some numbers.
pub(super) struct Forward<'a> {
    question: Question<'a>,
    renderer: Renderer,
    elements: Vec<usize>,
}

impl<'a> Forward<'a> {
    pub fn new(question: Question<'a>, elements: Vec<usize>) -> Self {
        Self { question, renderer: question.renderer(), elements }
    }
}

impl Engine for Forward<'_> {
    fn gradient(&mut self) -> Vec<f64> {
        let Question { recovery, .. } = self.question;
        let scene = recovery.scene();
        let loss = self.question.loss();
        let derivative = |&element: &usize| {
            let mut first = 0;
            let direction = recovery.ids().iter().map(|&id| {
                let count = scene.count(id);
                let unit = |index: usize| f64::from(u8::from(first + index == element));
                let block = (id, (0..count).map(unit).collect());
                first += count;
                block
            });
            let direction: Vec<_> = direction.collect();
            let (_, derivative) = self
                .renderer
                .loss_jvp(scene, &loss, &direction)
                .expect("directions have the numbers of their parameters");
            derivative
        };
        self.elements.iter().map(derivative).collect()
    }
}

/// Recordings at run time: one for each strip of the image, or one for all of it.
pub(super) struct Tape<'a> {
    question: Question<'a>,
    renderer: TapeRenderer,
    whole: bool,
}

impl<'a> Tape<'a> {
    pub fn new(question: Question<'a>, whole: bool) -> Self {
        let renderer = TapeRenderer::new(question.scene(), question.settings);
        Self { question, renderer, whole }
    }
}

impl Engine for Tape<'_> {
    fn gradient(&mut self) -> Vec<f64> {
        let Question { recovery, .. } = self.question;
        let loss = self.question.loss();
        self.renderer.gradient(recovery.scene(), &loss, recovery.ids(), self.whole)
    }
}
