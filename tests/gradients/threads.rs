//! Results do not depend on the number of threads.

use renderer::{ImageLoss, LossKind, Renderer};

use crate::scenes::textured_scene;

#[test]
fn image_and_gradient_are_bit_identical_on_any_number_of_threads() {
    let scene = textured_scene(70);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let renderer = Renderer::new(&scene, &crate::without_edges()).unwrap();
            let image = renderer.render();
            let mut target = image.clone();
            target.pixels.iter_mut().flatten().for_each(|value| *value *= 0.9);
            let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
            let result = renderer.loss_and_gradient(&scene, &loss, &scene.parameters());
            (image, result)
        })
    };
    let (image, result) = run(1);
    for threads in [2, 3, 7] {
        let (other_image, other_result) = run(threads);
        assert_eq!(image, other_image);
        assert_eq!(result, other_result);
        assert_eq!(result.loss.to_bits(), other_result.loss.to_bits());
    }
}
