//! The gradient by single vertices of a mesh.

use renderer::integrator::{Gradient, Prepared, RenderSettings, Sampling, Wanted, gradient};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::{ParameterId, Scene};
use wide::{f32x16, f64x8};

use crate::image::{agrees_with_finite_differences, target};
use crate::sampling::samples;
use crate::scenes::{mirror_scene, small_scene, textured_scene};
use crate::transparency::varied_scene;

/// Without and with rays that go on, under textures, behind transparent ones.
fn scenes() -> [Scene; 4] {
    [small_scene(20), mirror_scene(20), textured_scene(16), varied_scene(16)]
}

fn single_vertices(scene: &Scene) -> Vec<ParameterId> {
    let meshes = scene.parameters.vertices.iter().enumerate();
    meshes
        .flat_map(|(mesh, vertices)| {
            (0..vertices.len()).map(move |vertex| ParameterId::Vertex { mesh, vertex })
        })
        .collect()
}

fn gradient_by(scene: &Scene, sampling: Sampling, ids: &[ParameterId]) -> (f64, Gradient) {
    let target = target(scene);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let settings = RenderSettings { sampling, ..RenderSettings::default() };
    let single = Prepared::<f32x16>::with_settings(scene, settings);
    let result = gradient(&single, &loss, Wanted::by(ids));
    (result.loss, result.gradient)
}

#[test]
fn a_vertex_agrees_with_finite_differences() {
    for scene in scenes() {
        for mesh in 0..scene.meshes.len() {
            agrees_with_finite_differences(&scene, ParameterId::Vertex { mesh, vertex: 2 });
        }
    }
}

/// To the last bit: what is left out of the work brings zeros alone.
#[test]
fn a_vertex_has_its_part_of_the_whole_gradient() {
    let several = Sampling::Stratified(samples(3, 1));
    for sampling in [Sampling::Center, several] {
        for scene in scenes() {
            let meshes: Vec<_> = (0..scene.meshes.len()).map(ParameterId::Vertices).collect();
            let (whole_loss, whole) = gradient_by(&scene, sampling, &meshes);
            let mut seen = 0;
            for id in single_vertices(&scene) {
                let ParameterId::Vertex { mesh, vertex } = id else { unreachable!() };
                let expected = &whole.get(ParameterId::Vertices(mesh))[3 * vertex..][..3];
                let (loss, part) = gradient_by(&scene, sampling, &[id]);
                assert_eq!((loss, part.get(id)), (whole_loss, expected), "{}", scene.path(id));
                assert_eq!(whole.get(id), expected, "{}", scene.path(id));
                seen += usize::from(expected != [0.0; 3]);
            }
            assert!(seen >= 4, "{seen} vertices matter");
        }
    }
}

/// In any order, with whole meshes and other parameters.
#[test]
fn vertices_and_whole_meshes_can_be_asked_for_together() {
    use ParameterId::*;
    let scene = varied_scene(16);
    let everything = gradient_by(&scene, Sampling::Center, &scene.parameter_ids()).1;
    let ids = [
        Vertex { mesh: 2, vertex: 5 },
        Vertices(1),
        Vertex { mesh: 0, vertex: 1 },
        LookFrom,
        Vertex { mesh: 2, vertex: 1 },
        Vertex { mesh: 1, vertex: 3 },
        Vertex { mesh: 2, vertex: 2 },
    ];
    let found = gradient_by(&scene, Sampling::Center, &ids).1;
    for id in ids {
        assert_eq!(found.get(id), everything.get(id), "{}", scene.path(id));
    }
    for id in
        [Vertices(0), Vertices(2), Vertex { mesh: 0, vertex: 0 }, Vertex { mesh: 2, vertex: 3 }]
    {
        assert!(found.get(id).is_empty(), "{}", scene.path(id));
    }
}

/// Where a gradient is computed again in another range, all of it is scaled back.
#[test]
fn a_vertex_keeps_its_part_where_the_loss_leaves_the_range_of_single_precision() {
    let mut scene = small_scene(20);
    for light in &mut scene.parameters.lights {
        match light {
            renderer::scene::Light::Point(light) => light.intensity *= 1e-25,
            renderer::scene::Light::Distant(light) => light.intensity *= 1e-25,
        }
    }
    scene.parameters.materials.iter_mut().for_each(|material| material.ambient *= 0.0);
    let mut black = target(&scene);
    black.pixels.fill([0.0; 3]);
    let loss = ImageLoss::new(LossKind::MeanSquared, &black, false);
    let id = ParameterId::Vertex { mesh: 1, vertex: 1 };
    let wanted = [id];
    let single = gradient(&Prepared::<f32x16>::new(&scene), &loss, Wanted::by(&wanted));
    let double = gradient(&Prepared::<f64x8>::new(&scene), &loss, Wanted::by(&wanted));
    assert!(double.loss > 0.0 && double.loss < 1e-40, "{}", double.loss);
    for (a, b) in single.gradient.get(id).iter().zip(double.gradient.get(id)) {
        assert!(*b != 0.0 && (a - b).abs() <= 1e-3 * b.abs(), "{a} {b}");
    }
}
