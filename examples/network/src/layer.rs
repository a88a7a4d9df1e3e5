//! The renderer as a layer of a network: parameters of a scene in, images out.
//!
//! The layer is an operation of its own in candle's graph. Its backward pass gives the renderer the
//! cotangent of every pixel and takes back the cotangent of every parameter, so that whatever loss of
//! the images follows the layer, and whatever network stands before it, gradients pass through.
//! Turned down: an operation whose result is the loss itself, with the gradient saved on the way
//! forward. It would trace the scene once instead of twice, but fix the loss.

use std::sync::Arc;

use candle_core::{CpuStorage, CustomOp1, Device, Layout, Shape, Tensor, bail};
use rayon::prelude::*;
use renderer::{Error, Image, ParameterId, Renderer, Scene, Settings};

/// What errors name.
const PLACE: &str = "input of the layer that renders";

/// Renders a scene at other values of some of its parameters.
#[derive(Clone)]
pub struct RenderLayer {
    scene: Arc<Scene>,
    ids: Vec<ParameterId>,
}

impl RenderLayer {
    /// A layer whose input is the parameters that `paths` name, one after the other; all else is as
    /// in `scene`.
    ///
    /// # Errors
    ///
    /// If no parameter is named, the scene has no such parameter, or it is named twice.
    pub fn new(scene: Scene, paths: &[&str]) -> Result<Self, Error> {
        if paths.is_empty() {
            return Err(Error::new(PLACE, "no parameter: name one"));
        }
        let mut ids = Vec::new();
        for path in paths {
            let id = scene.parameter(path).map_err(placed)?;
            if ids.contains(&id) {
                return Err(Error::new(PLACE, format!("`{path}` is named twice")));
            }
            ids.push(id);
        }
        Ok(Self { scene: Arc::new(scene), ids })
    }

    /// The images of scenes, `[batch, height, width, 3]`, linear RGB, from their parameters,
    /// `[batch, numbers of all parameters]`, both `f32`. What lies between is in double precision.
    ///
    /// # Errors
    ///
    /// If the parameters have another shape or type, or no scene can have such values.
    pub fn images(&self, parameters: &Tensor) -> candle_core::Result<Tensor> {
        parameters.contiguous()?.apply_op1(self.clone())
    }

    /// The scene at other values of the parameters.
    ///
    /// # Errors
    ///
    /// If no scene can have such values.
    pub fn scene_at(&self, values: &[f32]) -> Result<Scene, Error> {
        let mut scene = Scene::clone(&self.scene);
        let mut rest = values;
        for &id in &self.ids {
            let (numbers, others) = rest.split_at(scene.get(id).len());
            let numbers: Vec<f64> = numbers.iter().copied().map(f64::from).collect();
            scene.set(id, &numbers).map_err(placed)?;
            rest = others;
        }
        Ok(scene)
    }

    /// How many numbers the parameters of one scene are.
    fn inputs(&self) -> usize {
        self.ids.iter().map(|&id| self.scene.get(id).len()).sum()
    }

    /// How many numbers one image is.
    fn outputs(&self) -> usize {
        3 * self.scene.width as usize * self.scene.height as usize
    }

    /// A scene at other values of the parameters, ready to be rendered.
    fn prepared(&self, values: &[f32]) -> Result<(Scene, Renderer), Error> {
        let scene = self.scene_at(values)?;
        let renderer = Renderer::new(&scene, &Settings::default().in_double_precision())?;
        Ok((scene, renderer))
    }

    /// One image.
    fn image(&self, values: &[f32]) -> Result<Vec<[f32; 3]>, Error> {
        Ok(self.prepared(values)?.1.render().pixels)
    }

    /// What flows back to the parameters of one image.
    fn pullback(&self, values: &[f32], image_bar: &[f32]) -> Result<Vec<f32>, Error> {
        let (scene, renderer) = self.prepared(values)?;
        let Scene { width, height, .. } = scene;
        let cotangent = Image { width, height, pixels: image_bar.as_chunks().0.to_vec() };
        let gradient = renderer.pullback(&scene, &cotangent, &self.ids);
        Ok(gradient.concat().into_iter().map(|number| number as f32).collect())
    }
}

/// An error that names the layer.
fn placed(error: Error) -> Error {
    Error::new(PLACE, error)
}

impl CustomOp1 for RenderLayer {
    fn name(&self) -> &'static str {
        "render"
    }

    fn cpu_fwd(
        &self,
        storage: &CpuStorage,
        layout: &Layout,
    ) -> candle_core::Result<(CpuStorage, Shape)> {
        let (batch, inputs) = layout.shape().dims2()?;
        if inputs != self.inputs() {
            bail!("{PLACE}: {inputs} numbers for each image, not {}", self.inputs());
        }
        let Some((start, end)) = layout.contiguous_offsets() else {
            bail!("{PLACE}: has to be contiguous");
        };
        let parameters = &storage.as_slice::<f32>()?[start..end];
        let images: Vec<_> = parameters
            .par_chunks(inputs)
            .map(|values| self.image(values))
            .collect::<Result<_, _>>()
            .map_err(candle_core::Error::wrap)?;
        let shape = (batch, self.scene.height as usize, self.scene.width as usize, 3);
        Ok((CpuStorage::F32(images.concat().into_flattened()), shape.into()))
    }

    fn bwd(
        &self,
        parameters: &Tensor,
        _images: &Tensor,
        images_bar: &Tensor,
    ) -> candle_core::Result<Option<Tensor>> {
        let values = parameters.flatten_all()?.to_vec1::<f32>()?;
        let images_bar = images_bar.flatten_all()?.to_vec1::<f32>()?;
        let bars: Vec<_> = values
            .par_chunks(self.inputs())
            .zip(images_bar.par_chunks(self.outputs()))
            .map(|(values, image_bar)| self.pullback(values, image_bar))
            .collect::<Result<_, _>>()
            .map_err(candle_core::Error::wrap)?;
        Tensor::from_vec(bars.concat(), parameters.shape(), &Device::Cpu).map(Some)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use ad::check::derivative;
    use candle_core::Var;
    use renderer::experiment::Experiment;
    use renderer::{Arithmetic, render};

    use super::*;
    use crate::training::errors;

    /// A ball that fills the image, and that the light can move around without an edge in sight: beside parameters that
    /// move edges, derivatives by colours are those of the exact image, and differences those of its estimate.
    const BALL: &str = r#"
[camera]
look_from = [0.0, 0.0, 4.0]
look_at = [0.0, 0.0, 0.0]
vfov = 14.0
width = 12
height = 9

[[light]]
name = "lamp"
type = "point"
position = [0.5, 0.7, 8.0]
radiant_intensity = 125.0

[[sphere]]
name = "ball"
center = [0.1, 0.0, 0.0]
radius = 1.0
material = "paint"

[material.paint]
diffuse = [0.5, 0.3, 0.2]
specular = [0.2, 0.2, 0.2]
exponent = 5.0
"#;
    const PATHS: [&str; 3] =
        ["light.lamp.radiant_intensity", "material.paint.diffuse", "light.lamp.position"];
    /// The parameters of two images.
    const VALUES: [[f32; 7]; 2] =
        [[125.0, 0.5, 0.3, 0.2, 0.5, 0.7, 8.0], [87.5, 0.2, 0.6, 0.4, -1.0, 0.2, 7.0]];

    fn layer() -> RenderLayer {
        let scene = Experiment::parse(BALL, Path::new(""), "the ball").unwrap().scene;
        RenderLayer::new(scene, &PATHS).unwrap()
    }

    #[test]
    fn images_are_those_of_the_renderer() {
        let layer = layer();
        let images = layer.images(&Tensor::new(&VALUES, &Device::Cpu).unwrap()).unwrap();
        assert_eq!(images.dims(), [2, 9, 12, 3]);
        let images = images.flatten_from(1).unwrap().to_vec2::<f32>().unwrap();
        for (image, values) in images.iter().zip(&VALUES) {
            let scene = layer.scene_at(values).unwrap();
            assert_eq!(scene.get(scene.parameter(PATHS[0]).unwrap())[0] as f32, values[0]);
            let settings = Settings { arithmetic: Arithmetic::F64x8, ..Settings::default() };
            let expected = render(&scene, &settings).unwrap().pixels;
            assert!(expected.iter().any(|pixel| pixel[0] > 0.05));
            for (a, b) in image.iter().zip(expected.as_flattened()) {
                assert!((a - b).abs() <= 1e-6 * b.abs(), "{a} {b}");
            }
        }
    }

    #[test]
    fn gradients_are_those_of_finite_differences() {
        let layer = layer();
        let target = Tensor::new(&[[112.5_f32, 0.4, 0.4, 0.3, 1.0, -1.0, 7.0]; 2], &Device::Cpu);
        let targets = layer.images(&target.unwrap()).unwrap();
        // The first image counts three times, so that images mistaken for each other would show.
        let weights = Tensor::new(&[3.0_f32, 1.0], &Device::Cpu).unwrap();
        let loss = |parameters: &Tensor| {
            let errors = errors(&layer.images(parameters).unwrap(), &targets).unwrap();
            (errors * &weights).unwrap().sum_all().unwrap()
        };
        let parameters = Var::new(&VALUES, &Device::Cpu).unwrap();
        let gradients = loss(&parameters).backward().unwrap();
        let gradient = gradients.get(&parameters).unwrap().to_vec2::<f32>().unwrap();
        for (image, values) in VALUES.iter().enumerate() {
            for (number, &value) in values.iter().enumerate() {
                let along = |x: f64| {
                    let mut values = VALUES;
                    values[image][number] = x as f32;
                    let values = Tensor::new(&values, &Device::Cpu).unwrap();
                    f64::from(loss(&values).to_scalar::<f32>().unwrap())
                };
                let expected = derivative(along, f64::from(value), 0.1 * f64::from(value)).value;
                let found = f64::from(gradient[image][number]);
                // What is left is the rounding of the loss to single precision.
                let scale = expected.abs().max(0.01 / f64::from(value).abs());
                assert!(
                    (found - expected).abs() <= 1e-3 * scale,
                    "number {number} of image {image}: {found}, by differences {expected}"
                );
            }
        }
    }

    #[test]
    fn what_cannot_be_rendered_is_refused() {
        let layer = layer();
        let message = |rows: &[[f32; 7]; 2]| {
            let rows = Tensor::new(rows, &Device::Cpu).unwrap();
            layer.images(&rows).unwrap_err().to_string()
        };
        let mut values = VALUES;
        values[1][5] = f32::NAN;
        let expected = "input of the layer that renders: light.lamp.position: NaN is not";
        assert!(message(&values).starts_with(expected), "{}", message(&values));
        let short = Tensor::zeros((2, 3), candle_core::DType::F32, &Device::Cpu).unwrap();
        let expected = "input of the layer that renders: 3 numbers for each image, not 7";
        assert!(layer.images(&short).unwrap_err().to_string().starts_with(expected));
        for paths in [&[][..], &["light.lamp.size"], &[PATHS[0], PATHS[0]]] {
            assert!(RenderLayer::new(Scene::clone(&layer.scene), paths).is_err(), "{paths:?}");
        }
    }
}
