//! A renderer that keeps what it has prepared of a scene.

use ad::Dual;
use glam::DVec3;

use super::Linear;
use crate::Error;
use crate::adjoint::{self, Gradient, LossAndGradient, Request};
use crate::arithmetic::with_arithmetic;
use crate::boundary::add_derivative;
use crate::diagnose::{self, NonFinite};
use crate::edges::{Geometry, Limb, StripPaths, View};
use crate::image::Image;
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::image::{loss, pixels_dual, rays_by_depth, render_into, trace_only};
use crate::primal::inputs::Inputs;
use crate::primal::integrator::{Integrator, Prepared};
use crate::primal::varying::Varying;
use crate::scene::{ParameterId, Scene};
use crate::settings::{Pass, Settings};
use crate::trace::sampling::Sampling;

/// A scene that is prepared to be rendered again and again: its numbers may change, its objects stay.
///
/// ```
/// use renderer::glam::DVec3;
/// use renderer::{Camera, PointLight, Renderer, Scene, Settings};
///
/// let mut scene = Scene::new(8, 8, Camera::looking(DVec3::Z, DVec3::ZERO));
/// let light = PointLight { position: DVec3::Z, color: DVec3::ONE, radiant_intensity: 1.0 };
/// scene.add_light("key", light)?;
/// let mut renderer = Renderer::new(&scene, &Settings::default())?;
/// let intensity = scene.parameter("light.key.radiant_intensity")?;
/// for step in 1..4 {
///     scene.set(intensity, &[f64::from(step)])?;
///     renderer.update(&scene);
///     let image = renderer.render();
///     assert_eq!(image.pixels.len(), 64);
/// }
/// # Ok::<(), renderer::Error>(())
/// ```
pub struct Renderer {
    engine: Box<dyn Engine>,
}

impl Renderer {
    /// Prepares a scene.
    ///
    /// # Errors
    ///
    /// If the scene is not [valid](Scene::check).
    pub fn new(scene: &Scene, settings: &Settings) -> Result<Self, Error> {
        scene.check()?;
        Ok(Self::unchecked(scene, settings))
    }

    /// Prepares a scene that is known to be valid.
    #[doc(hidden)]
    pub fn unchecked(scene: &Scene, settings: &Settings) -> Self {
        let engine: Box<dyn Engine> = with_arithmetic!(settings.arithmetic, L => {
            Box::new(Prepared::<L>::new(scene, *settings))
        });
        Self { engine }
    }

    /// How the scene is rendered.
    pub fn settings(&self) -> &Settings {
        self.engine.settings()
    }

    /// Takes over the numbers of the scene, which has the objects that it had when it was prepared.
    /// Where geometry has moved, the acceleration structure is refitted.
    pub fn update(&mut self, scene: &Scene) {
        self.engine.update(scene);
    }

    /// Takes over what the scene is [seen through](Scene::look_through), and nothing else: tree and numbers
    /// stay what they were.
    pub fn look(&mut self, scene: &Scene) {
        self.engine.look(scene);
    }

    /// Shows something else of surfaces, of the scene that was last taken over.
    pub fn show(&mut self, scene: &Scene, pass: Pass) {
        self.engine.show(scene, pass);
    }

    /// The image; see [`render`](super::render()).
    pub fn render(&self) -> Image {
        let (width, height) = self.engine.size();
        let mut image = Image::black(width, height);
        self.engine.render_into(&mut image);
        image
    }

    /// [`render`](Self::render), over an image of the same size: who renders often saves the time to get
    /// memory.
    ///
    /// # Panics
    ///
    /// If the image has another size than the scene's.
    pub fn render_into(&self, image: &mut Image) {
        self.engine.render_into(image);
    }

    /// A loss of the image, in double precision from the radiance on.
    pub fn loss(&self, loss: &dyn PixelLoss) -> f64 {
        self.engine.loss(loss)
    }

    /// A loss of the image and its gradient; see [`loss_and_gradient`](super::loss_and_gradient). `scene`
    /// is the one that was last taken over.
    ///
    /// # Panics
    ///
    /// If there is [no derivative](Scene::check_differentiable) by one of the parameters.
    pub fn loss_and_gradient(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
    ) -> LossAndGradient {
        self.engine.loss_and_gradient(scene, loss, requested)
    }

    /// The pullback of the image; see [`render_vjp`](super::render_vjp). `scene` is the one that was last
    /// taken over.
    ///
    /// # Panics
    ///
    /// If the cotangent has another size than the image, or there is
    /// [no derivative](Scene::check_differentiable) by one of the parameters.
    pub fn pullback(
        &self,
        scene: &Scene,
        cotangent: &Image,
        requested: &[ParameterId],
    ) -> Gradient {
        let size = (cotangent.width, cotangent.height);
        assert_eq!(size, self.engine.size(), "the cotangent has the size of the image");
        self.engine.loss_and_gradient(scene, &Linear(cotangent), requested).gradient
    }

    /// The image and its derivative along a direction; see [`render_jvp`](super::render_jvp). `scene` is
    /// the one that was last taken over.
    ///
    /// # Errors
    ///
    /// If a direction has another number of numbers than its parameter, or two have numbers in common, or
    /// there is [no derivative](Scene::check_differentiable) by one.
    pub fn jvp(
        &self,
        scene: &Scene,
        direction: &[(ParameterId, Vec<f64>)],
    ) -> Result<(Image, Image), Error> {
        check_direction(scene, self.settings(), direction)?;
        Ok(self.engine.jvp(scene, direction))
    }

    /// A loss of the image and its derivative along a direction, in double precision from the radiance on.
    /// `scene` is the one that was last taken over.
    ///
    /// # Errors
    ///
    /// As [`jvp`](Self::jvp).
    pub fn loss_jvp(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        direction: &[(ParameterId, Vec<f64>)],
    ) -> Result<(f64, f64), Error> {
        check_direction(scene, self.settings(), direction)?;
        Ok(self.engine.loss_jvp(scene, loss, direction))
    }

    /// Searches for the pixels whose radiance an image cannot hold, and for the cause at the first of
    /// them.
    pub fn find_non_finite(&self, scene: &Scene) -> Option<NonFinite> {
        self.engine.find_non_finite(scene, None)
    }

    /// Searches for the pixels whose loss or gradient is not finite, and for the cause at the first.
    pub fn find_non_finite_gradient(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
    ) -> Option<NonFinite> {
        self.engine.find_non_finite(scene, Some((loss, requested)))
    }

    /// Loss and gradient of the pixels that are finite alone.
    pub fn gradient_of_finite(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
        found: &NonFinite,
    ) -> LossAndGradient {
        self.engine.gradient_of_finite(scene, loss, requested, found)
    }

    /// Changes the rays through pixels, and keeps all else.
    pub fn resample(&mut self, sampling: Sampling) {
        self.engine.resample(sampling);
    }

    /// Changes how many mirrors a path has at most, and keeps all else.
    pub fn set_bounces(&mut self, bounces: u32) {
        self.engine.set_bounces(bounces);
    }

    /// How many rays there are at each depth, and how many of them hit something: those that a gradient by
    /// the requested parameters traces.
    #[doc(hidden)]
    pub fn rays_by_depth(&self, scene: &Scene, requested: &[ParameterId]) -> Vec<(u64, u64)> {
        self.engine.rays_by_depth(scene, requested)
    }

    /// Traces the camera rays, and those of their shadows if they are wanted, and shades nothing: to
    /// measure it.
    pub fn trace_only(&self, shadows: bool) {
        self.engine.trace_only(shadows);
    }
}

/// A prepared scene, whatever it is computed in.
trait Engine: Send + Sync {
    fn settings(&self) -> &Settings;
    fn size(&self) -> (u32, u32);
    fn update(&mut self, scene: &Scene);
    fn look(&mut self, scene: &Scene);
    fn show(&mut self, scene: &Scene, pass: Pass);
    fn render_into(&self, image: &mut Image);
    fn loss(&self, loss: &dyn PixelLoss) -> f64;
    fn loss_and_gradient(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
    ) -> LossAndGradient;
    fn jvp(&self, scene: &Scene, direction: &[(ParameterId, Vec<f64>)]) -> (Image, Image);
    fn loss_jvp(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        direction: &[(ParameterId, Vec<f64>)],
    ) -> (f64, f64);
    fn find_non_finite(
        &self,
        scene: &Scene,
        of: Option<(&dyn PixelLoss, &[ParameterId])>,
    ) -> Option<NonFinite>;
    fn gradient_of_finite(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
        found: &NonFinite,
    ) -> LossAndGradient;
    fn resample(&mut self, sampling: Sampling);
    fn set_bounces(&mut self, bounces: u32);
    fn rays_by_depth(&self, scene: &Scene, requested: &[ParameterId]) -> Vec<(u64, u64)>;
    fn trace_only(&self, shadows: bool);
}

impl<L: Plain> Engine for Prepared<L> {
    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn size(&self) -> (u32, u32) {
        (self.layout.width, self.layout.height)
    }

    fn update(&mut self, scene: &Scene) {
        Prepared::update(self, scene);
    }

    fn look(&mut self, scene: &Scene) {
        Prepared::look(self, scene);
    }

    fn show(&mut self, scene: &Scene, pass: Pass) {
        Prepared::show(self, scene, pass);
    }

    fn render_into(&self, image: &mut Image) {
        match self.sees_edges() {
            true => {
                let integrator = self.integrator();
                let view = View::new(&Geometry::new(integrator), integrator);
                view.fill(image);
                view.recycle(integrator.frames);
            }
            false => render_into(self.integrator(), image),
        }
    }

    fn loss(&self, pixel_loss: &dyn PixelLoss) -> f64 {
        match self.sees_edges() {
            true => {
                let integrator = self.integrator();
                let view = View::new(&Geometry::new(integrator), integrator);
                let loss = view.loss(self.layout.width, pixel_loss);
                view.recycle(integrator.frames);
                loss
            }
            false => loss(self.integrator(), pixel_loss),
        }
    }

    fn loss_and_gradient(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
    ) -> LossAndGradient {
        if let Err(error) = scene.check_differentiable(&self.settings, requested) {
            panic!("{error}");
        }
        let request = Request::new(scene, &self.layout, requested);
        adjoint::loss_and_gradient(self, scene, loss, &request)
    }

    fn jvp(&self, scene: &Scene, direction: &[(ParameterId, Vec<f64>)]) -> (Image, Image) {
        let pixels = pixels_along(self, scene, direction);
        let image = |part: usize| {
            let pixels = pixels.iter().map(|pixel| pixel[part].as_vec3().to_array()).collect();
            Image { width: self.layout.width, height: self.layout.height, pixels }
        };
        (image(0), image(1))
    }

    fn loss_jvp(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        direction: &[(ParameterId, Vec<f64>)],
    ) -> (f64, f64) {
        let pixels = pixels_along(self, scene, direction);
        let (mut sum, mut along) = (0.0, 0.0);
        for (index, [radiance, derivative]) in pixels.into_iter().enumerate() {
            let (x, y) = (index as u32 % self.layout.width, index as u32 / self.layout.width);
            let (value, cotangent) = loss.evaluate(x, y, radiance);
            sum += value;
            along += cotangent.dot(derivative);
        }
        (sum, along)
    }

    fn find_non_finite(
        &self,
        scene: &Scene,
        of: Option<(&dyn PixelLoss, &[ParameterId])>,
    ) -> Option<NonFinite> {
        match of {
            None => diagnose::find_non_finite_radiance(self, scene),
            Some((loss, requested)) => diagnose::find_non_finite(self, scene, loss, requested),
        }
    }

    fn gradient_of_finite(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        requested: &[ParameterId],
        found: &NonFinite,
    ) -> LossAndGradient {
        let request = Request::new(scene, &self.layout, requested);
        diagnose::gradient_of_finite(self, scene, loss, &request, found)
    }

    fn resample(&mut self, sampling: Sampling) {
        Prepared::resample(self, sampling);
    }

    fn set_bounces(&mut self, bounces: u32) {
        Prepared::set_bounces(self, bounces);
    }

    fn rays_by_depth(&self, scene: &Scene, requested: &[ParameterId]) -> Vec<(u64, u64)> {
        let request = Request::new(scene, &self.layout, requested);
        rays_by_depth(self.integrator().with_zero_weight(request.zero_weight))
    }

    fn trace_only(&self, shadows: bool) {
        trace_only(self.integrator(), shadows);
    }
}

fn check_direction(
    scene: &Scene,
    settings: &Settings,
    direction: &[(ParameterId, Vec<f64>)],
) -> Result<(), Error> {
    let ids: Vec<ParameterId> = direction.iter().map(|(id, _)| *id).collect();
    scene.check_differentiable(settings, &ids)?;
    for (index, (id, numbers)) in direction.iter().enumerate() {
        if let Some((other, _)) = direction[..index].iter().find(|(other, _)| other.overlaps(*id)) {
            let problem = format!("overlaps {}, which moves too", scene.path(*other));
            return Err(Error::new(scene.path(*id), problem));
        }
        let count = scene.count(*id);
        if count != numbers.len() {
            let problem = format!("moves by {} numbers, has {count}", numbers.len());
            return Err(Error::new(scene.path(*id), problem));
        }
    }
    Ok(())
}

/// The pixels of an image and their derivatives along a direction.
fn pixels_along<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    direction: &[(ParameterId, Vec<f64>)],
) -> Vec<[DVec3; 2]> {
    let ids: Vec<ParameterId> = direction.iter().map(|(id, _)| *id).collect();
    let block = |(id, numbers): &(ParameterId, Vec<f64>)| {
        let values = scene.get(*id);
        let moving = values.iter().zip(numbers).map(|(&value, &along)| Dual::new(value, along));
        (*id, moving.collect())
    };
    let varying = Varying { blocks: direction.iter().map(block).collect() };
    let inputs = Inputs::new(scene, &prepared.layout, prepared.inputs.origin, &varying);
    let request = Request::new(scene, &prepared.layout, &ids);
    let moving = prepared.with_inputs(&inputs).with_zero_weight(request.zero_weight);
    let has_edges = request.has_edges(prepared.settings.edges);
    if !has_edges {
        return pixels_dual(moving, prepared.layout.sampling, None);
    }
    if prepared.layout.path_tracing.is_some() {
        return pixels_of_paths(prepared, scene, &request, moving, varying);
    }
    let still = prepared.integrator().with_zero_weight(request.zero_weight);
    let geometry = Geometry::new(still);
    let view = View::new(&geometry, still);
    let derivatives = view.derivative(&geometry, moving, request.is_steep_at_silhouettes());
    let pixels = view.pixels.iter().zip(derivatives).map(|(&pixel, along)| [pixel, along]);
    let pixels = pixels.collect();
    view.recycle(still.frames);
    pixels
}

/// The pixels and their derivatives, edges that move among them, where light takes all paths.
fn pixels_of_paths<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    request: &Request,
    all_moving: Integrator<'_, Dual<L>>,
    mut varying: Varying<Dual<f64>>,
) -> Vec<[DVec3; 2]> {
    // The directions of light from the environment stay where it turns.
    varying.blocks.retain(|(id, _)| scene.moves_edges(*id));
    let layout = &prepared.layout;
    let mut pixels = Vec::new();
    let mut sum = vec![DVec3::ZERO; layout.width as usize * layout.height as usize];
    let inputs = Inputs::new(scene, layout, prepared.inputs.origin, &varying);
    let still = prepared.integrator().with_zero_weight(request.zero_weight);
    let moving = prepared.with_inputs(&inputs).with_zero_weight(request.zero_weight);
    add_derivative(still, moving, &mut sum);
    prepared.for_each_round(scene, |round, direct| {
        let still = direct.integrator().with_zero_weight(request.zero_weight);
        let geometry = Geometry::new(still);
        let view = View::of_paths(&geometry, still, prepared.integrator(), round);
        if round.index == 0 {
            let limb = Limb::of_paths(&view, &geometry, request.is_steep_at_silhouettes());
            let weight = |pixel, film| limb.weight(&geometry, pixel, film);
            pixels = pixels_dual(all_moving, layout.sampling, limb.has_strips().then_some(&weight));
            let of_strips = StripPaths::new(round, layout.sampling);
            view.add_strips((&geometry, &limb), all_moving, of_strips, &mut sum);
        }
        let inputs = Inputs::new(scene, &direct.layout, direct.inputs.origin, &varying);
        let moving = direct.with_inputs(&inputs).with_zero_weight(request.zero_weight);
        let of_round = view.boundary_derivative(&geometry, moving);
        sum.iter_mut().zip(of_round).for_each(|(sum, along)| *sum += along);
    });
    pixels.iter_mut().zip(sum).for_each(|(pixel, along)| pixel[1] += along);
    pixels
}
