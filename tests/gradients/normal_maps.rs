//! Normal maps in scenes: their images beside those of turned surfaces, and their gradients.

use glam::{DVec2, DVec3, dvec2, dvec3};
use renderer::scene::{Bsdf, Integrator, MaterialObject, Slot, Wrap};
use renderer::{
    Arithmetic, Camera, DistantLight, Image, ImageLoss, LossKind, Material, Mesh, Pass, PointLight,
    Renderer, Scene, Settings, SphereObject, Texture, loss_and_gradient, render,
};

use crate::edges;
use crate::everything::{place_meshes, smooth_meshes};
use crate::image::{
    agrees_with_finite_differences, check_parameter_with, in_arithmetic, lanes_agree_on,
    single_agrees_with_double, target_of,
};
use crate::paths::{agrees_with_differences, lit_box, paths};
use crate::scenes::{Parts, small_parts};

fn texture(name: &str, [width, height]: [u32; 2], wrap: Wrap, texels: Vec<[f64; 3]>) -> Texture {
    Texture { name: name.into(), width, height, wrap, texels: texels.into() }
}

/// A map that bends everywhere, and nowhere alike.
fn relief(name: &str, size: [u32; 2], wrap: Wrap) -> Texture {
    let texel = |i: u32| {
        let value = |channel: u32| f64::from((i * 5 + channel * 3 + i * i) % 7) / 6.0;
        [0.3 + 0.4 * value(0), 0.3 + 0.4 * value(1), 0.7 + 0.25 * value(2)]
    };
    texture(name, size, wrap, (0..size[0] * size[1]).map(texel).collect())
}

/// The small scene with a normal map on the floor, and one beside other textures on the tent, which is a
/// mirror image of itself and has facets.
fn bumpy_parts(size: u32) -> Parts {
    let mut parts = small_parts(size);
    parts.textures =
        vec![relief("waves", [3, 2], Wrap::Repeat), relief("scales", [4, 3], Wrap::Mirror)];
    let [ground, object] = [0, 1].map(|index| parts.materials[index].clone());
    let mut scaly = MaterialObject {
        name: "scaly".into(),
        bsdf: Bsdf::MetallicRoughness,
        normal_scale: 0.7,
        ..object.clone().with_texture(Slot::Normal, 1).with_texture(Slot::MetallicRoughness, 1)
    };
    (scaly.values.metallic, scaly.values.roughness) = (0.3, 0.7);
    parts.materials = vec![ground.with_texture(Slot::Normal, 0), object, scaly];
    let [floor, tent] = [0, 1].map(|index| parts.meshes[index].clone());
    parts.meshes = vec![
        floor.texture_coordinates(
            vec![[-2.1, -1.3], [2.2, -1.1], [2.4, 5.3], [-1.9, 5.1]],
            vec![[0, 1, 2], [0, 2, 3]],
        ),
        tent.material(2).texture_coordinates(
            vec![[0.13, 0.11], [1.2, -0.1], [0.61, 1.3], [1.4, 0.7]],
            vec![[0, 1, 2], [1, 3, 2]],
        ),
    ];
    parts
}

#[test]
fn gradients_of_flat_meshes_agree_with_finite_differences() {
    let scene = bumpy_parts(16).scene();
    let names: Vec<_> = scene.parameters().iter().map(|&id| scene.path(id).to_string()).collect();
    assert!(names.contains(&"texture.waves.texels".to_owned()), "{names:?}");
    assert!(!names.contains(&"material.ground.mirror".to_owned()), "{names:?}");
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn gradients_of_smooth_meshes_agree_with_finite_differences() {
    let mut parts = place_meshes(smooth_meshes(bumpy_parts(16)));
    let tent = &mut parts.meshes[1];
    tent.transform.scale.x *= -1.0;
    tent.vertices.iter_mut().for_each(|vertex| vertex[0] *= -1.0);
    let scene = parts.scene();
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn the_pass_of_normals_shows_bent_ones_with_gradients() {
    let scene = smooth_meshes(bumpy_parts(16)).scene();
    let settings = Settings { pass: Pass::Normals, ..in_arithmetic(Arithmetic::F64) };
    let target = target_of(&scene, &settings);
    for path in ["texture.waves.texels", "texture.scales.texels", "mesh.tent.vertices"] {
        let id = scene.parameter(path).unwrap();
        check_parameter_with(&settings, &scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn lanes_agree_with_single_numbers() {
    lanes_agree_on(&smooth_meshes(bumpy_parts(37)).scene());
}

#[test]
fn single_precision_is_close_to_double() {
    let scene = smooth_meshes(bumpy_parts(32)).scene();
    let target = target_of(&scene, &in_arithmetic(Arithmetic::F64));
    single_agrees_with_double(&scene, &target, [Arithmetic::F32x16, Arithmetic::F64x8]);
}

#[test]
fn images_and_gradients_are_bit_identical_on_any_number_of_threads() {
    let mut scene = bumpy_parts(70).scene();
    for integrator in [Integrator::Direct, paths(3, 4)] {
        scene.integrator = integrator;
        let ids = [scene.parameter("texture.scales.texels").unwrap()];
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let renderer = Renderer::new(&scene, &crate::without_edges()).unwrap();
                let image = renderer.render();
                let loss = ImageLoss::new(LossKind::L1, &image, false);
                (renderer.loss_and_gradient(&scene, &loss, &ids), image)
            })
        };
        assert_eq!(run(1), run(3));
    }
}

/// The lit box with normal maps on matt, glossy and metallic walls, of which one has smooth normals.
fn bumpy_box(size: u32) -> Scene {
    let mut scene = lit_box(size);
    let bumps = scene.add_texture(relief("bumps", [3, 2], Wrap::Repeat)).unwrap();
    let matt = MaterialObject::from(Material {
        roughness: 0.3,
        specular: DVec3::splat(0.1),
        exponent: 5.0,
        ..Material::lambertian(dvec3(0.7, 0.3, 0.5))
    });
    let materials = [
        ("matt", matt),
        ("glaze", MaterialObject::metallic_roughness(dvec3(0.6, 0.3, 0.7), 0.4, 0.8)),
        ("metal", MaterialObject::metallic_roughness(dvec3(0.9, 0.7, 0.4), 0.9, 0.25)),
    ];
    let uvs = vec![[0.1, 0.2], [1.3, 0.1], [1.21, 1.43], [-0.1, 0.9]];
    for (index, (name, material)) in materials.into_iter().enumerate() {
        let material = material.with_texture(Slot::Normal, bumps);
        let material = scene.add_material(name, material).unwrap();
        let wall = &mut scene.meshes[index];
        let triangles = wall.triangles.clone();
        *wall = wall.clone().material(material).texture_coordinates(uvs.clone(), triangles);
    }
    scene.meshes[1] = scene.meshes[1].clone().smooth();
    scene
}

#[test]
fn gradients_of_scattered_light_agree_with_differences() {
    let mut scene = bumpy_box(12);
    scene.integrator = paths(4, 16);
    agrees_with_differences(&scene);
}

/// `<c, J v>` forwards is `<Jᵀ c, v>` backwards.
#[test]
fn derivatives_of_scattered_light_agree_forwards_and_backwards() {
    let mut scene = bumpy_box(12);
    scene.integrator = paths(4, 16);
    let renderer = Renderer::new(&scene, &in_arithmetic(Arithmetic::F64x8)).unwrap();
    let black = Image::black(scene.width, scene.height);
    let loss = ImageLoss::new(LossKind::MeanSquared, &black, false);
    for path in
        ["texture.bumps.texels", "mesh.left.texture_coordinates", "material.glaze.roughness"]
    {
        let id = scene.parameter(path).unwrap();
        let direction: Vec<f64> = (0..scene.get(id).len()).map(|i| (i as f64).cos()).collect();
        let gradient = renderer.loss_and_gradient(&scene, &loss, &[id]).gradient;
        let products = gradient.get(id).iter().zip(&direction).map(|(slope, along)| slope * along);
        let backwards: f64 = products.sum();
        let (_, forwards) = renderer.loss_jvp(&scene, &loss, &[(id, direction)]).unwrap();
        let error = (forwards - backwards).abs();
        assert!(error <= 1e-9 * backwards.abs(), "{path}: {forwards} and {backwards}");
    }
}

/// A wall of one normal map, seen from before, with a lamp at its side.
fn wall(texel: [f64; 3], turned: impl Fn(Mesh) -> Mesh) -> Scene {
    let camera = Camera::looking(dvec3(0.2, 0.3, 4.0), dvec3(0.1, 0.0, 0.0));
    let mut scene = Scene::new(40, 32, camera);
    let map = scene.add_texture(texture("map", [1, 1], Wrap::Repeat, vec![texel])).unwrap();
    let paint = Material {
        specular: DVec3::splat(0.3),
        exponent: 12.0,
        ..Material::lambertian(dvec3(0.7, 0.5, 0.3))
    };
    let paint = MaterialObject::from(paint).with_texture(Slot::Normal, map);
    let paint = scene.add_material("paint", paint).unwrap();
    let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let mesh = Mesh::new("wall", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(paint);
    let uvs = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mesh = mesh.texture_coordinates(uvs, vec![[0, 1, 2], [0, 2, 3]]);
    scene.add_mesh(turned(mesh)).unwrap();
    let position = dvec3(1.5, 2.0, 2.5);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 20.0 };
    scene.add_light("lamp", lamp).unwrap();
    scene
}

fn image(scene: &Scene) -> Image {
    render(scene, &in_arithmetic(Arithmetic::F64)).unwrap()
}

/// The largest difference of two images.
fn difference(a: &Image, b: &Image) -> f32 {
    let pairs = a.pixels.as_flattened().iter().zip(b.pixels.as_flattened());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, |most, off| if off <= most { most } else { off })
}

fn without_map(mut scene: Scene) -> Scene {
    for material in &mut scene.materials {
        material.textures.0[Slot::Normal as usize] = None;
    }
    scene
}

const TILTED: [f64; 3] = [0.62, 0.41, 0.93];

/// The direction that a texel stands for on a wall whose tangent and bitangent are x and y.
fn direction([r, g, b]: [f64; 3]) -> DVec3 {
    (2.0 * dvec3(r, g, b) - DVec3::ONE).normalize()
}

/// With normals of its own the same wall is shaded in the same way.
fn with_normal(normal: DVec3) -> Scene {
    let all = |mesh: &Mesh| vec![[0; 3]; mesh.triangles.len()];
    without_map(wall(TILTED, |mesh| {
        let triangles = all(&mesh);
        mesh.normals(vec![normal.to_array()], triangles)
    }))
}

#[test]
fn a_map_of_one_texel_turns_the_normal_of_a_plane() {
    let flat = wall([0.5, 0.5, 1.0], |mesh| mesh);
    assert_eq!(difference(&image(&flat), &image(&without_map(flat.clone()))), 0.0);
    let smooth = wall([0.5, 0.5, 1.0], |mesh| mesh.smooth());
    assert!(difference(&image(&smooth), &image(&without_map(smooth.clone()))) < 1e-6);

    let tilted = wall(TILTED, |mesh| mesh);
    let expected = image(&with_normal(direction(TILTED)));
    assert!(difference(&expected, &image(&flat)) > 0.05);
    assert!(difference(&image(&tilted), &expected) < 1e-6);

    // However the corners of triangles are ordered, and whatever the texture coordinates.
    let turned = wall(TILTED, |mut mesh| {
        mesh.triangles = vec![[1, 2, 0], [2, 3, 0]];
        mesh.texture_triangles = vec![Some([1, 2, 0]), Some([2, 3, 0])];
        for [u, v] in &mut mesh.texture_coordinates {
            (*u, *v) = (3.0 * *u - 7.0, 0.2 * *v + 5.0);
        }
        mesh
    });
    assert!(difference(&image(&turned), &expected) < 1e-6);

    // A quarter turn of the texture.
    let quarter = wall(TILTED, |mut mesh| {
        mesh.texture_coordinates.iter_mut().for_each(|[u, v]| (*u, *v) = (*v, -*u));
        mesh
    });
    let normal = direction(TILTED);
    let expected = image(&with_normal(dvec3(-normal.y, normal.x, normal.z)));
    assert!(difference(&image(&quarter), &expected) < 1e-6);

    // A mirrored texture.
    let mirrored = wall(TILTED, |mut mesh| {
        mesh.texture_coordinates.iter_mut().for_each(|[u, _]| *u = -*u);
        mesh
    });
    let expected = image(&with_normal(dvec3(-normal.x, normal.y, normal.z)));
    assert!(difference(&image(&mirrored), &expected) < 1e-6);
}

/// Of a wall that is seen from behind, a bump is a dent; one that its transform mirrors is a mirror image.
#[test]
fn maps_are_turned_and_mirrored_with_their_mesh() {
    let normal = direction(TILTED);
    let behind = wall(TILTED, |mut mesh| {
        mesh.triangles = vec![[0, 2, 1], [0, 3, 2]];
        mesh.texture_triangles = vec![Some([0, 2, 1]), Some([0, 3, 2])];
        mesh
    });
    let expected = image(&with_normal(dvec3(-normal.x, -normal.y, normal.z)));
    assert!(difference(&image(&behind), &expected) < 1e-6);

    let mirrored = wall(TILTED, |mut mesh| {
        mesh.transform.scale = dvec3(-1.0, 1.0, 1.0);
        mesh
    });
    let expected = image(&with_normal(dvec3(-normal.x, normal.y, normal.z)));
    assert!(difference(&image(&mirrored), &expected) < 1e-6);
}

#[test]
fn the_scale_bends_more_or_less() {
    let mut scene = wall(TILTED, |mesh| mesh);
    for scale in [0.0, 0.5, 2.0, -1.0] {
        scene.materials[0].normal_scale = scale;
        let local = 2.0 * DVec3::from(TILTED) - DVec3::ONE;
        let normal = (local * dvec3(scale, scale, 1.0)).normalize();
        assert!(difference(&image(&scene), &image(&with_normal(normal))) < 1e-6, "{scale}");
    }
}

/// Paths are scattered about other normals than those of the surface, and bring the same light.
#[test]
fn scattered_light_is_that_of_turned_normals() {
    for (bsdf, roughness) in
        [(Bsdf::BlinnPhong, 0.0), (Bsdf::MetallicRoughness, 0.6), (Bsdf::MetallicRoughness, 0.15)]
    {
        let in_box = |mut scene: Scene| {
            let room = lit_box(4);
            let first = scene.materials.len() as u32;
            for material in &room.materials {
                let plain = MaterialObject { textures: Default::default(), ..material.clone() };
                scene.add_material(plain.name.clone(), plain).unwrap();
            }
            for mesh in &room.meshes {
                let material = mesh.materials[0] + first;
                let mesh =
                    Mesh::new(mesh.name.clone(), mesh.vertices.clone(), mesh.triangles.clone());
                scene.add_mesh(mesh.material(material)).unwrap();
            }
            scene.meshes[0].transform.scale = DVec3::splat(0.6);
            scene.camera = Camera::looking(dvec3(0.1, 0.1, 0.9), DVec3::ZERO);
            scene.materials[0].bsdf = bsdf;
            scene.materials[0].values.roughness = roughness;
            scene.materials[0].values.metallic = 0.5;
            scene.lights.clear();
            scene.integrator = paths(4, 1024);
            scene
        };
        let mean = |scene: Scene| {
            let image = render(&in_box(scene), &Settings::default()).unwrap();
            image.pixels.as_flattened().iter().map(|&x| f64::from(x)).sum::<f64>()
        };
        let found = mean(wall(TILTED, |mesh| mesh));
        let expected = mean(with_normal(direction(TILTED)));
        let error = (found - expected).abs() / expected;
        assert!(error < 2e-3, "{bsdf:?} {roughness}: {found}, expected {expected}");
    }
}

/// Silhouettes, ridges and shadows on surfaces with normal maps.
#[test]
fn edges_move_between_bent_normals() {
    let mut scene = edges::scene();
    edges::add_floor(&mut scene, 0.0);
    edges::add_wedge(&mut scene);
    edges::add_lamp(&mut scene);
    let map = scene.add_texture(relief("map", [3, 2], Wrap::Mirror)).unwrap();
    for (mesh, size) in scene.meshes.iter_mut().zip([0.05, 0.3]) {
        let uvs = mesh.vertices.iter().map(|&[x, y, z]| [size * (x + 0.3 * z), size * (y + z)]);
        let (uvs, triangles) = (uvs.collect(), mesh.triangles.clone());
        *mesh = mesh.clone().texture_coordinates(uvs, triangles);
        let material = &mut scene.materials[mesh.materials[0] as usize];
        *material = material.clone().with_texture(Slot::Normal, map);
    }
    for path in ["light.lamp.position", "mesh.shape.translation", "camera.look_at"] {
        edges::check(&scene, path, [(4, 4e-2)]);
    }
}

/// A face that turns its back to the sun is dark, where its map turns normals to the sun, too: at its ridge, but not where
/// samples next to the ridge see it.
#[test]
fn faces_with_normal_maps_are_in_their_own_shadow() {
    let mut scene = edges::scene();
    edges::add_wedge(&mut scene);
    let direction = dvec3(-0.9, 0.1, 0.6);
    let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
    let mut texels = vec![[0.9, 0.5, 0.6]; 256];
    texels[..129].fill([0.1, 0.5, 0.6]);
    let map = scene.add_texture(texture("map", [256, 1], Wrap::Clamp, texels)).unwrap();
    let mesh = &mut scene.meshes[0];
    let columns = [[0, 3], [1, 2], [4, 5]];
    let column = |at: u32| columns.iter().position(|column| column.contains(&at));
    let uvs = (0..6).map(|at| [0.5 * column(at).unwrap_or(0) as f64, f64::from(at % 2)]).collect();
    let triangles = mesh.triangles.clone();
    *mesh = mesh.clone().texture_coordinates(uvs, triangles);
    let material = &mut scene.materials[mesh.materials[0] as usize];
    *material = material.clone().with_texture(Slot::Normal, map);
    for path in ["mesh.shape.translation", "mesh.shape.vertices"] {
        edges::check(&scene, path, [(1, 8e-2), (4, 4e-2)]);
    }
}

#[test]
fn edges_are_the_same_forwards_backwards_and_in_single_precision() {
    let mut parts = smooth_meshes(bumpy_parts(48));
    parts.spheres.clear();
    let scene = parts.scene();
    let settings = Settings::default();
    let double = settings.in_double_precision();
    let target = target_of(&scene, &double);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    for path in ["camera.look_at", "mesh.tent.translation", "light.key.position"] {
        let id = scene.parameter(path).unwrap();
        let slopes = |settings: &Settings| {
            let renderer = Renderer::new(&scene, settings).unwrap();
            let result = renderer.loss_and_gradient(&scene, &loss, &[id]);
            let numbers = result.gradient.get(id).to_vec();
            let along: Vec<f64> = numbers.iter().map(|slope| slope.signum()).collect();
            let (_, forwards) = renderer.loss_jvp(&scene, &loss, &[(id, along)]).unwrap();
            let backwards: f64 = numbers.iter().map(|slope| slope.abs()).sum();
            (DVec3::from_slice(&numbers), forwards, backwards)
        };
        let (gradient, forwards, backwards) = slopes(&double);
        assert!((forwards - backwards).abs() < 1e-9 * backwards, "{forwards} {backwards}");
        let (single, ..) = slopes(&settings);
        assert!((single - gradient).length() < 1e-3 * gradient.length(), "{single} {gradient}");
    }
}

#[test]
fn what_has_no_tangents_is_refused() {
    let mut scene = wall(TILTED, |mesh| mesh);
    let bare = Mesh::new("bare", scene.meshes()[0].vertices.clone(), vec![[0, 1, 2]]);
    let text = scene.add_mesh(bare).unwrap_err().to_string();
    assert!(text.contains("has a texture, but has no texture coordinates"), "{text}");
    let text = scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap_err();
    assert_eq!(
        text.to_string(),
        "sphere.ball.material: has a normal_texture, which bends the normals of meshes alone"
    );
    let mut refusal = |material: MaterialObject| {
        let material = material.with_texture(Slot::Normal, 0);
        scene.add_material("new", material).unwrap_err().to_string()
    };
    assert_eq!(
        refusal(MaterialObject::dielectric(1.5)),
        "material.new.normal_texture: varies nothing that a material of this type has"
    );
    let mirror = Material { mirror: DVec3::ONE, ..Material::default() };
    assert_eq!(
        refusal(mirror.into()),
        "material.new.normal_texture: a mirror has none; leave out either normal_texture or mirror"
    );
    for (scale, problem) in [(f64::NAN, "NaN is not a finite number"), (1e7, "1e7 is beyond 1e6")] {
        let material = MaterialObject { normal_scale: scale, ..Material::default().into() };
        assert_eq!(refusal(material), format!("material.new.normal_scale: {problem}"));
    }
    let texels = scene.parameter("texture.map.texels").unwrap();
    let text = scene.set(texels, &[0.5, 0.5, 1.5]).unwrap_err().to_string();
    assert!(text.contains("must be at most 1 where they"), "{text}");
}

/// Texture coordinates that span nothing, maps of one texel, images of one pixel.
#[test]
fn degenerate_scenes_have_finite_images_and_gradients() {
    for uvs in [[DVec2::ZERO; 4], [dvec2(1e6, -1e6); 4], [0.0, 1.0, 2.0, 3.0].map(DVec2::splat)] {
        let mut scene = wall(TILTED, |mut mesh| {
            mesh.texture_coordinates = uvs.map(|uv| uv.to_array()).to_vec();
            mesh
        });
        assert_eq!(difference(&image(&scene), &image(&without_map(scene.clone()))), 0.0);
        (scene.width, scene.height) = (1, 1);
        for texel in [[0.0; 3], [0.5; 3], [1.0, 1.0, 0.0], [0.5, 0.5, 0.0]] {
            scene.textures[0].texels = vec![texel].into();
            let black = Image::black(1, 1);
            let loss = ImageLoss::new(LossKind::SumSquared, &black, false);
            let ids = scene.parameters();
            let result = loss_and_gradient(&scene, &Settings::default(), &loss, &ids).unwrap();
            assert!(result.loss.is_finite());
            assert!(result.gradient.concat().iter().all(|slope| slope.is_finite()), "{texel:?}");
        }
    }
}
