//! Views: one scene, one tree, several cameras.

use renderer::glam::DVec3;
use renderer::{
    Camera, Edges, ImageLoss, LossKind, Pass, Renderer, Scene, Settings, View, render, render_jvp,
};

use crate::scenes::{set, textured_scene};

/// The scene through two cameras, of different sizes.
fn scene_with_views() -> Scene {
    let mut scene = textured_scene(40);
    let left = Camera { vfov: 38.0, ..scene.camera };
    let right = Camera { look_from: scene.camera.look_from + DVec3::new(1.3, 0.4, -0.6), ..left };
    for (name, width, height, camera) in [("left", 40, 30, left), ("right", 28, 36, right)] {
        scene.add_view(View { name: name.into(), width, height, camera }).unwrap();
    }
    scene
}

/// The same scene through one of them alone.
fn alone(scene: &Scene, view: usize) -> Scene {
    let View { width, height, camera, .. } = scene.views()[view].clone();
    let mut alone = textured_scene(40);
    (alone.width, alone.height, alone.camera) = (width, height, camera);
    alone
}

fn with_edges() -> Settings {
    Settings { edges: Edges::On, ..Settings::default() }.in_double_precision()
}

#[test]
fn a_view_is_the_image_of_its_camera() {
    let mut scene = scene_with_views();
    for settings in [crate::without_edges(), with_edges()] {
        let mut renderer = Renderer::new(&scene, &settings).unwrap();
        for view in [1, 0, 1] {
            scene.look_through(view);
            renderer.look(&scene);
            assert_eq!(renderer.render(), render(&alone(&scene, view), &settings).unwrap());
        }
    }
}

#[test]
fn gradients_of_a_view_are_those_of_its_camera_and_of_no_other() {
    let mut scene = scene_with_views();
    let paths = ["look_from", "look_at", "up", "vfov", "film_scale"];
    for settings in [crate::without_edges(), with_edges()] {
        let mut renderer = Renderer::new(&scene, &settings).unwrap();
        for view in [0, 1] {
            scene.look_through(view);
            renderer.look(&scene);
            let alone = alone(&scene, view);
            let mut target = renderer.render();
            target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.8);
            let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
            let asked = |scene: &Scene, kind: &str| -> Vec<_> {
                let common = ["light.key.position", "mesh.floor.vertices"];
                let own = paths.map(|path| format!("{kind}.{path}"));
                let all = own.iter().map(String::as_str).chain(common);
                all.map(|path| scene.parameter(path).unwrap()).collect()
            };
            let name = ["view.left", "view.right"][view];
            let found = renderer.loss_and_gradient(&scene, &loss, &asked(&scene, name));
            let expected = Renderer::new(&alone, &settings).unwrap();
            let expected = expected.loss_and_gradient(&alone, &loss, &asked(&alone, "camera"));
            assert_eq!(found.loss.to_bits(), expected.loss.to_bits());
            assert_eq!(found.gradient.concat(), expected.gradient.concat());
            let other = ["view.right", "view.left"][view];
            let other = asked(&scene, other)[..paths.len()].to_vec();
            let zero = renderer.loss_and_gradient(&scene, &loss, &other).gradient.concat();
            assert_eq!(zero, vec![0.0; 11]);
        }
    }
}

/// Forward mode shares no code with the pullback of the camera but the frame.
#[test]
fn derivatives_along_the_camera_of_a_view_agree_with_its_gradient() {
    let mut scene = scene_with_views();
    scene.look_through(1);
    let settings = crate::without_edges().in_double_precision();
    let id = scene.parameter("view.right.look_from").unwrap();
    let along = vec![0.3, -0.5, 0.8];
    let (image, derivative) = render_jvp(&scene, &settings, &[(id, along.clone())]).unwrap();
    assert!(derivative.pixels.as_flattened().iter().any(|value| *value != 0.0));
    let mut target = image.clone();
    target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.5);
    let loss = ImageLoss::new(LossKind::SumSquared, &target, false);
    let renderer = Renderer::new(&scene, &settings).unwrap();
    let gradient = renderer.loss_and_gradient(&scene, &loss, &[id]).gradient.concat();
    let by_gradient: f64 = gradient.iter().zip(&along).map(|(a, b)| a * b).sum();
    let (_, by_forward) = renderer.loss_jvp(&scene, &loss, &[(id, along)]).unwrap();
    let error = (by_gradient - by_forward).abs() / by_forward.abs();
    assert!(error < 1e-9, "{by_gradient} {by_forward}");
}

/// A silhouette that moves by a pixel changes the coverage by its length: against differences of the
/// coverage image, whose edges are straight here.
#[test]
fn coverage_sees_silhouettes_and_nothing_else() {
    let mut scene = Scene::new(32, 32, Camera::looking(DVec3::Z * 4.0, DVec3::ZERO));
    let paint = renderer::Material::lambertian(DVec3::new(0.8, 0.3, 0.1));
    let paint = scene.add_material("paint", paint).unwrap();
    let corners = vec![[-0.7, -0.62, 0.1], [0.83, -0.41, 0.0], [0.14, 0.87, -0.2]];
    let triangle = renderer::Mesh::new("triangle", corners, vec![[0, 1, 2]]).material(paint);
    scene.add_mesh(triangle).unwrap();
    let settings = Settings { pass: Pass::Coverage, ..with_edges() };
    let image = render(&scene, &settings).unwrap();
    assert!(image.pixels.contains(&[1.0; 3]));
    assert!(image.pixels.iter().any(|[value, ..]| *value > 0.01 && *value < 0.99));
    assert!(image.pixels.iter().all(|[r, g, b]| r == g && g == b && *r < 1.0 + 1e-6));
    let target = renderer::Image::black(32, 32);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let renderer = Renderer::new(&scene, &settings).unwrap();
    let [vertices, diffuse] = ["mesh.triangle.vertices", "material.paint.diffuse"]
        .map(|path| scene.parameter(path).unwrap());
    let found = renderer.loss_and_gradient(&scene, &loss, &[vertices, diffuse]);
    assert_eq!(found.gradient.get(diffuse), [0.0; 3]);
    let gradient = found.gradient.get(vertices);
    let norm = gradient.iter().map(|value| value * value).sum::<f64>().sqrt();
    assert!(norm > 0.0);
    let start = scene.get(vertices).into_owned();
    for index in 0..9 {
        let value = |by: f64| {
            let (mut scene, mut moved) = (scene.clone(), start.clone());
            moved[index] += by;
            set(&mut scene, "mesh.triangle.vertices", &moved);
            Renderer::new(&scene, &settings).unwrap().loss(&loss)
        };
        let difference = (value(1e-5) - value(-1e-5)) / 2e-5;
        let error = (gradient[index] - difference).abs() / norm;
        assert!(error < 0.02, "{index}: {} {difference}", gradient[index]);
    }
}
