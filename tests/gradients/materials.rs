//! Materials with facets and glass in scenes: their images in closed form, and their gradients.

use glam::{DVec3, dvec3};
use renderer::scene::{Bsdf, Environment, Integrator, MaterialObject, Slot, Wrap};
use renderer::{
    Arithmetic, Camera, Image, Material, Mesh, Renderer, Scene, Settings, SphereObject, Texture,
    render,
};

use crate::image::{agrees_with_finite_differences, in_arithmetic};
use crate::paths::{Sum, agrees_with_differences, lit_box, looking_changes_nothing, paths, still};
use crate::scenes::{set, small_parts};

/// A ball in light from everywhere.
fn furnace(material: MaterialObject, depth: u32, samples: u32) -> Image {
    let camera = Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO);
    let mut scene = Scene::new(16, 16, camera);
    scene.environment = Some(Environment::constant(DVec3::splat(2.0)).into());
    scene.integrator = paths(depth, samples);
    scene.add_material("ball", material).unwrap();
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
    render(&scene, &Settings::default()).unwrap()
}

/// Glass of any density vanishes in light from everywhere: what is lost on the way in comes back on the way
/// out. A smooth white metal does, and others are darker.
#[test]
fn balls_in_a_furnace_are_as_bright_as_it_or_less() {
    for ior in [1.0, 1.33, 2.4] {
        let image = furnace(MaterialObject::dielectric(ior), 60, 16);
        for pixel in image.pixels {
            assert!((pixel[0] - 2.0).abs() < 2e-2, "{ior}: {pixel:?}");
        }
    }
    for (metallic, roughness, least) in [(1.0, 0.0, 1.98), (1.0, 0.3, 1.8), (0.0, 0.5, 1.8)] {
        let white = MaterialObject::metallic_roughness(DVec3::ONE, metallic, roughness);
        let image = furnace(white, 3, 256);
        let mean = image.pixels.iter().map(|pixel| f64::from(pixel[1])).sum::<f64>() / 256.0;
        assert!((least..2.01).contains(&mean), "{metallic} {roughness}: {mean}");
    }
}

/// Two panes of glass around nothing but glass: the transmittance of a slab is `2n / (n² + 1)`, once all
/// reflections within it are counted; and what shines within glass is seen through its surface by a part
/// that Fresnel leaves, over the square of the index.
#[test]
fn a_slab_lets_through_what_the_series_says() {
    let ior = 1.7;
    let camera = Camera { film_scale: 1e-3, ..Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO) };
    let pane = |name: &str, z: f64, towards: bool| {
        let corners = [[-50.0, -50.0], [50.0, -50.0], [50.0, 50.0], [-50.0, 50.0]];
        let corners = corners.map(|[x, y]| [x, y, z]).to_vec();
        let triangles = match towards {
            true => vec![[0, 1, 2], [0, 2, 3]],
            false => vec![[0, 2, 1], [0, 3, 2]],
        };
        Mesh::new(name, corners, triangles)
    };
    let mut scene = Scene::new(8, 8, camera);
    scene.integrator = paths(40, 1024);
    scene.add_material("glass", MaterialObject::dielectric(ior)).unwrap();
    let lamp = Material { emission: DVec3::splat(3.0), ..Material::lambertian(DVec3::ZERO) };
    scene.add_material("lamp", lamp).unwrap();
    scene.add_mesh(pane("front", 0.0, true)).unwrap();
    let mut within = scene.clone();
    scene.add_mesh(pane("back", -0.5, false)).unwrap();
    scene.add_mesh(pane("lamp", -1.0, true).material(1)).unwrap();
    within.add_mesh(pane("lamp", -1.0, true).material(1)).unwrap();
    let mean = |scene: &Scene| {
        let image = render(scene, &Settings::default()).unwrap();
        image.pixels.iter().map(|pixel| f64::from(pixel[0])).sum::<f64>() / 64.0
    };
    let expected = 3.0 * 2.0 * ior / (ior * ior + 1.0);
    let found = mean(&scene);
    assert!((found - expected).abs() < 5e-3 * expected, "{found}, expected {expected}");
    // The mirror image of a pane has its outside where the pane has it.
    let mut mirrored = scene.clone();
    mirrored.meshes.iter_mut().for_each(|pane| pane.transform.scale.x = -1.0);
    let found = mean(&mirrored);
    assert!((found - expected).abs() < 5e-3 * expected, "{found}, expected {expected}");
    let lost = ((ior - 1.0) / (ior + 1.0)).powi(2);
    let (found, expected) = (mean(&within), 3.0 * (1.0 - lost) / (ior * ior));
    assert!((found - expected).abs() < 5e-3 * expected, "{found}, expected {expected}");
}

/// The lit box with a ball of gold, a glazed wall whose roughness a texture varies, and a ball of glass.
fn furnished(size: u32) -> Scene {
    let mut scene = lit_box(size);
    let texels = vec![[0.2_f64, 0.9, 0.4], [0.3, 0.5, 0.8], [0.1, 0.7, 0.2], [0.6, 0.95, 0.6]];
    let finish = Texture {
        name: "finish".into(),
        width: 2,
        height: 2,
        wrap: Wrap::Clamp,
        texels: texels.into(),
    };
    let finish = scene.add_texture(finish).unwrap();
    let gold = MaterialObject::metallic_roughness(dvec3(0.9, 0.7, 0.3), 0.9, 0.35);
    let gold = scene.add_material("gold", gold).unwrap();
    let glass = MaterialObject::dielectric(1.5);
    let glass = scene.add_material("clear", glass).unwrap();
    set(&mut scene, "material.clear.diffuse", &[0.9, 0.95, 0.85]);
    let glaze = MaterialObject::metallic_roughness(dvec3(0.6, 0.3, 0.7), 0.4, 0.8);
    let glaze = glaze.with_texture(Slot::Diffuse, 0).with_texture(Slot::MetallicRoughness, finish);
    let glaze = scene.add_material("glaze", glaze).unwrap();
    let ball = |name, center, radius| SphereObject::new(name, center, radius);
    scene.add_sphere(ball("gold", dvec3(0.4, -0.6, -0.2), 0.25).material(gold)).unwrap();
    scene.add_sphere(ball("clear", dvec3(-0.1, 0.3, 0.1), 0.2).material(glass)).unwrap();
    let wall = scene.meshes.iter_mut().find(|mesh| mesh.name == "back").unwrap();
    *wall = wall.clone().material(glaze);
    scene
}

#[test]
fn gradients_by_facets_and_glass_agree_with_differences() {
    let mut scene = furnished(12);
    scene.integrator = paths(5, 16);
    agrees_with_differences(&scene);
}

/// Point and distant lights in direct images, where surfaces and cameras move too.
#[test]
fn gradients_of_direct_light_agree_with_differences() {
    let mut parts = small_parts(20);
    let finish = [(0.2, 0.6), (0.8, 0.45)];
    for (material, (metallic, roughness)) in parts.materials.iter_mut().zip(finish) {
        material.bsdf = Bsdf::MetallicRoughness;
        (material.values.metallic, material.values.roughness) = (metallic, roughness);
    }
    let scene = parts.scene();
    let names: Vec<_> = scene.parameters().iter().map(|&id| scene.path(id).to_string()).collect();
    assert!(names.contains(&"material.object.metallic".to_owned()), "{names:?}");
    assert!(!names.contains(&"material.object.specular".to_owned()), "{names:?}");
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

/// Light that is looked for among facets, glass and textures.
#[test]
fn looking_for_emitters_changes_nothing_but_noise() {
    looking_changes_nothing(furnished(16), 4, [512, 1024], 8e-3);
}

/// A smooth metal shows what a mirror shows that has Schlick's reflectance: white, that is all.
#[test]
fn a_smooth_metal_is_a_mirror() {
    let mut scene = lit_box(24);
    scene.integrator = paths(3, 256);
    let chrome = scene.materials.iter().position(|material| material.name == "chrome").unwrap();
    let white = Material { mirror: DVec3::ONE, ..Material::lambertian(DVec3::ZERO) };
    scene.materials[chrome] = MaterialObject { name: "chrome".into(), ..white.into() };
    let mirror = render(&scene, &Settings::default()).unwrap();
    let metal = MaterialObject::metallic_roughness(DVec3::ONE, 1.0, 0.0);
    scene.materials[chrome] = MaterialObject { name: "chrome".into(), ..metal };
    // Point lights are not seen in mirrors.
    let smooth = render(&scene, &Settings::default()).unwrap();
    let sum =
        |image: &Image| image.pixels.as_flattened().iter().map(|&x| f64::from(x)).sum::<f64>();
    let (found, expected) = (sum(&smooth), sum(&mirror));
    assert!((found - expected).abs() < 5e-3 * expected, "{found}, expected {expected}");
}

#[test]
fn precisions_agree() {
    let mut scene = furnished(24);
    scene.integrator = paths(4, 16);
    let of = |arithmetic: Arithmetic| {
        let renderer = Renderer::new(&scene, &in_arithmetic(arithmetic)).unwrap();
        let result = renderer.loss_and_gradient(&scene, &Sum, &still(&scene));
        (result.loss, result.gradient)
    };
    let (loss, gradient) = of(Arithmetic::F64x8);
    let (other_loss, other) = of(Arithmetic::F32x16);
    assert!((loss - other_loss).abs() <= 4e-3 * loss, "{loss} and {other_loss}");
    for (id, block) in gradient.iter() {
        let norm = |block: &mut dyn Iterator<Item = f64>| block.map(|x| x * x).sum::<f64>().sqrt();
        let size = norm(&mut block.iter().copied());
        let error = norm(&mut block.iter().zip(other.get(id)).map(|(a, b)| a - b));
        assert!(error <= 0.05 * size, "{}: {error:e} of {size:e}", scene.path(id));
    }
}

#[test]
fn images_and_gradients_are_bit_identical_on_any_number_of_threads() {
    let scene = furnished(40);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
            (renderer.render(), renderer.loss_and_gradient(&scene, &Sum, &still(&scene)))
        })
    };
    assert_eq!(run(1), run(3));
}

/// Facets of no roughness and of next to none, and the ends of what is metal.
#[test]
fn extreme_finishes_have_finite_gradients() {
    let mut scene = furnished(12);
    let ids = scene.parameters();
    for (metallic, roughness) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1e-4), (0.0, 1.0), (1.0, 0.011)] {
        set(&mut scene, "material.gold.metallic", &[metallic]);
        set(&mut scene, "material.gold.roughness", &[roughness]);
        let renderer = Renderer::new(&scene, &crate::without_edges()).unwrap();
        let result = renderer.loss_and_gradient(&scene, &Sum, &ids);
        assert!(result.loss.is_finite() && result.gradient.concat().iter().all(|x| x.is_finite()));
    }
}

/// The base that a metal lacks is in its derivative by the metallic part, though in no image of it: in light from
/// everywhere, and where glossy metals light each other. An image is linear in that part, so that the derivative
/// is the difference of a metal and what is none.
#[test]
fn metals_know_what_they_were_without_metal() {
    for roughness in [0.05, 0.4] {
        let mut scene = Scene::new(12, 12, Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO));
        scene.environment = Some(Environment::constant(DVec3::splat(2.0)).into());
        scene.integrator = paths(2, 1024);
        let metal = MaterialObject::metallic_roughness(dvec3(0.8, 0.5, 0.2), 1.0, roughness);
        scene.add_material("ball", metal).unwrap();
        scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
        let id = scene.parameter("material.ball.metallic").unwrap();
        let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
        let of_metal = renderer.loss_and_gradient(&scene, &Sum, &[id]);
        set(&mut scene, "material.ball.metallic", &[0.0]);
        let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
        let without = renderer.loss_and_gradient(&scene, &Sum, &[id]);
        let (found, expected) = (of_metal.gradient.concat()[0], of_metal.loss - without.loss);
        // Both are sums of what metal and base reflect, with either sign.
        let error = (found - expected).abs();
        assert!(error < 4e-3 * of_metal.loss, "{found}, not {expected}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let scene = furnished(8);
    let direct = Scene { integrator: Integrator::Direct, ..scene.clone() };
    let text = render(&direct, &Settings::default()).unwrap_err().to_string();
    assert!(text.starts_with("material.clear.type: "), "{text}");
    let mut scene = scene;
    let panes = MaterialObject::dielectric(1.5).with_opacity(0.5);
    let text = scene.add_material("panes", panes).unwrap_err().to_string();
    assert!(text.starts_with("material.panes.opacity: "), "{text}");
    let varied = MaterialObject::dielectric(1.5).with_texture(Slot::MetallicRoughness, 0);
    let text = scene.add_material("varied", varied).unwrap_err().to_string();
    assert!(text.starts_with("material.varied.metallic_roughness_texture: "), "{text}");
}
