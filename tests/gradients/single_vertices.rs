//! The gradient by single vertices of a mesh.

use renderer::{
    Arithmetic, Image, ImageLoss, LossKind, ParameterId, Sampling, Scene, Settings,
    loss_and_gradient,
};

use crate::everything::place_meshes;
use crate::image::{agrees_with_finite_differences, in_arithmetic, target};
use crate::sampling::samples;
use crate::scenes::{mirror_scene, multiply, set, small_scene, textured_scene};
use crate::transparency::{varied_parts, varied_scene};

/// Without and with rays that go on, under textures, behind transparent ones, with meshes that are placed
/// in the world.
fn scenes() -> [Scene; 5] {
    [
        small_scene(20),
        mirror_scene(20),
        textured_scene(16),
        varied_scene(16),
        place_meshes(varied_parts(16)).scene(),
    ]
}

/// The vertices of all meshes.
fn meshes(scene: &Scene) -> Vec<ParameterId> {
    scene.parameters().into_iter().filter(|id| id.field == "vertices").collect()
}

fn vertex(scene: &Scene, mesh: usize, vertex: usize) -> ParameterId {
    ParameterId { vertex: Some(vertex), ..meshes(scene)[mesh] }
}

fn gradient_by(
    scene: &Scene,
    sampling: Sampling,
    ids: &[ParameterId],
) -> renderer::LossAndGradient {
    let target = target(scene);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let settings = Settings { sampling, ..in_arithmetic(Arithmetic::F32x16) };
    loss_and_gradient(scene, &settings, &loss, ids).unwrap()
}

#[test]
fn a_vertex_agrees_with_finite_differences() {
    for scene in scenes() {
        for mesh in 0..scene.meshes().len() {
            agrees_with_finite_differences(&scene, vertex(&scene, mesh, 2));
        }
    }
}

/// To the last bit: what is left out of the work brings zeros alone.
#[test]
fn a_vertex_has_its_part_of_the_whole_gradient() {
    let several = Sampling::Stratified(samples(3, 1));
    for sampling in [Sampling::Center, several] {
        for scene in scenes() {
            let whole = gradient_by(&scene, sampling, &meshes(&scene));
            let mut seen = 0;
            for (mesh, &vertices) in meshes(&scene).iter().enumerate() {
                for index in 0..scene.meshes()[mesh].vertices.len() {
                    let id = vertex(&scene, mesh, index);
                    let expected = &whole.gradient.get(vertices)[3 * index..][..3];
                    let part = gradient_by(&scene, sampling, &[id]);
                    let found = (part.loss, part.gradient.get(id));
                    assert_eq!(found, (whole.loss, expected), "{}", scene.path(id));
                    seen += usize::from(expected != [0.0; 3]);
                }
            }
            assert!(seen >= 4, "{seen} vertices matter");
        }
    }
}

/// In any order, with whole meshes and other parameters.
#[test]
fn vertices_and_whole_meshes_can_be_asked_for_together() {
    let scene = place_meshes(varied_parts(16)).scene();
    let center = Sampling::Center;
    let everything = gradient_by(&scene, center, &scene.parameters()).gradient;
    let ids = [
        vertex(&scene, 2, 5),
        meshes(&scene)[1],
        vertex(&scene, 0, 1),
        scene.parameter("camera.look_from").unwrap(),
        vertex(&scene, 2, 1),
        vertex(&scene, 1, 3),
        scene.parameter("mesh.panes.rotation").unwrap(),
        vertex(&scene, 2, 2),
    ];
    let found = gradient_by(&scene, center, &ids).gradient;
    for id in ids {
        let whole = everything.get(ParameterId { vertex: None, ..id });
        let expected = match id.vertex {
            None => whole,
            Some(vertex) => &whole[3 * vertex..][..3],
        };
        // The rotation of a mesh without its vertices is summed up in another order.
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-6 * b.abs();
        match id.field {
            "rotation" => assert!(found.get(id).iter().zip(expected).all(close)),
            _ => assert_eq!(found.get(id), expected, "{}", scene.path(id)),
        }
    }
    assert_eq!(found.iter().map(|(id, _)| id).collect::<Vec<_>>(), ids);
    for id in [meshes(&scene)[0], meshes(&scene)[2], vertex(&scene, 0, 0), vertex(&scene, 2, 3)] {
        assert!(found.get(id).is_empty(), "{}", scene.path(id));
    }
}

/// Where a gradient is computed again in another range, all of it is scaled back.
#[test]
fn a_vertex_keeps_its_part_where_the_loss_leaves_the_range_of_single_precision() {
    let mut scene = small_scene(20);
    for path in ["light.key.radiant_intensity", "light.sky.irradiance"] {
        multiply(&mut scene, path, 1e-25);
    }
    for path in ["material.ground.emission", "material.object.emission"] {
        set(&mut scene, path, &[0.0; 3]);
    }
    let black = Image::black(scene.width, scene.height);
    let loss = ImageLoss::new(LossKind::MeanSquared, &black, false);
    let id = vertex(&scene, 1, 1);
    let [single, double] = [Arithmetic::F32x16, Arithmetic::F64x8].map(|arithmetic| {
        loss_and_gradient(&scene, &in_arithmetic(arithmetic), &loss, &[id]).unwrap()
    });
    assert!(double.loss > 0.0 && double.loss < 1e-40, "{}", double.loss);
    for (a, b) in single.gradient.get(id).iter().zip(double.gradient.get(id)) {
        assert!(*b != 0.0 && (a - b).abs() <= 1e-3 * b.abs(), "{a} {b}");
    }
}
