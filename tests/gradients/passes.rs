//! What passes show of the geometry of surfaces.

use glam::{DVec3, dvec3};
use renderer::scene::{Environment, EnvironmentObject, Wrap};
use renderer::{
    Arithmetic, Camera, Edges, Image, Integrator, LossKind, Material, Mesh, Pass, Renderer,
    Sampling, Scene, Settings, SphereObject, Texture, render, render_vjp,
};

use crate::custom::add_egg;
use crate::everything::{place_meshes, smooth_meshes};
use crate::image::{check_parameter_with, in_arithmetic, target_of};
use crate::scenes::{small_parts, small_scene};

const OF_GEOMETRY: [Pass; 3] = [Pass::Depth, Pass::Position, Pass::Normals];

fn of(pass: Pass) -> Settings {
    Settings { pass, ..in_arithmetic(Arithmetic::F64) }
}

#[test]
fn the_geometry_of_surfaces_agrees_with_finite_differences() {
    let mut scene = place_meshes(smooth_meshes(small_parts(16))).scene();
    add_egg(&mut scene, 1);
    for pass in OF_GEOMETRY {
        let target = target_of(&scene, &of(pass));
        let moves = scene.parameters().into_iter().filter(|&id| scene.moves_edges(id));
        for id in moves.filter(|&id| !scene.path(id).to_string().starts_with("light")) {
            check_parameter_with(&of(pass), &scene, &target, LossKind::MeanSquared, id);
        }
    }
}

/// A wall and a ball before it, far from zero, seen along a slanted direction.
#[test]
fn passes_show_depth_places_and_normals() {
    let far = dvec3(1e4, -2e4, 3e4);
    let (from, toward) = (far + dvec3(0.0, 0.0, 8.0), dvec3(0.6, 0.0, -0.8));
    let mut scene = Scene::new(31, 31, Camera::looking(from, from + toward));
    scene.add_material("grey", Material::lambertian(DVec3::ONE)).unwrap();
    let wall = [[-40.0, -40.0], [40.0, -40.0], [40.0, 40.0], [-40.0, 40.0]];
    let wall = wall.map(|[x, y]| (far + dvec3(x, y, 0.0)).to_array()).to_vec();
    scene.add_mesh(Mesh::new("wall", wall, vec![[0, 1, 2], [0, 2, 3]])).unwrap();
    let center = from + 5.0 * toward;
    scene.add_sphere(SphereObject::new("ball", center, 0.5)).unwrap();
    let [depth, position, normal] = OF_GEOMETRY.map(|pass| render(&scene, &of(pass)).unwrap());
    let at = |pixels: &[[f32; 3]], index: usize| DVec3::from(pixels[index].map(f64::from));
    let middle = 15 * 31 + 15;
    assert_eq!(depth.pixels[middle], [4.5; 3]);
    assert!((at(&normal.pixels, middle) + toward).length() < 1e-6);
    assert!((at(&position.pixels, middle) - (center - 0.5 * toward)).length() < 5e-3);
    for index in [0, 30, 30 * 31, 31 * 31 - 1] {
        let place = at(&position.pixels, index);
        assert!((place.z - far.z).abs() < 5e-3, "{place}");
        let along = (place - from).dot(toward);
        assert!((depth.pixels[index][0] as f64 - along).abs() < 5e-3, "{along}");
        assert_eq!(normal.pixels[index], [0.0, 0.0, 1.0]);
    }
}

/// Single precision loses no more than the numbers themselves.
#[test]
fn passes_of_geometry_hold_in_single_precision() {
    let scene = small_scene(32);
    for pass in OF_GEOMETRY {
        let double = render(&scene, &of(pass)).unwrap();
        let single = render(&scene, &Settings { arithmetic: Arithmetic::default(), ..of(pass) });
        let pairs = single.unwrap().pixels.into_iter().zip(double.pixels);
        let off = pairs.filter(|(a, b)| {
            let off = a.iter().zip(b).map(|(a, b)| (a - b).abs());
            off.fold(0.0, f32::max) > 1e-4
        });
        // A ray through an edge may go either way.
        assert!(off.count() <= 2, "{pass:?}");
    }
}

/// Passes are the same where light takes all paths.
#[test]
fn passes_of_scenes_where_light_takes_all_paths_have_gradients() {
    let mut scene = small_scene(16);
    let camera = scene.parameter("camera.look_from").unwrap();
    let settings =
        Settings { pass: Pass::Depth, edges: Edges::Auto, ..in_arithmetic(Arithmetic::F64) };
    let gradient = |scene: &Scene| {
        let (image, pullback) = render_vjp(scene, &settings, &[camera]).unwrap();
        pullback(&image).get(camera).to_vec()
    };
    let direct = gradient(&scene);
    assert!(direct.iter().all(|&number| number != 0.0));
    scene.integrator = Integrator::Path(Default::default());
    assert_eq!(gradient(&scene), direct);
}

/// What a renderer shows next is what one made for it shows: rays, maps and edges included.
#[test]
fn showing_another_pass_is_as_good_as_beginning_with_it() {
    let mut scene = small_scene(16);
    scene.integrator = Integrator::Path(Default::default());
    let texels =
        vec![[0.2_f64, 0.4, 0.9], [0.9, 0.5, 0.1], [0.1, 0.8, 0.3], [0.6, 0.6, 0.6]].into();
    let sky = Texture { name: "sky".into(), width: 2, height: 2, wrap: Wrap::Repeat, texels };
    let texture = Some(scene.add_texture(sky).unwrap());
    let values = Environment { radiance: DVec3::ONE, rotation: 30.0 };
    scene.environment = Some(EnvironmentObject { values, texture, background: None });
    for (first, second, edges) in
        [(Pass::Depth, Pass::Radiance, Edges::On), (Pass::Radiance, Pass::Uv, Edges::Off)]
    {
        let mut renderer = Renderer::new(&scene, &Settings { edges, ..of(first) }).unwrap();
        renderer.show(&scene, second);
        // Edges are on for the first pass alone.
        let expected = render(&scene, &Settings { edges: Edges::Off, ..of(second) }).unwrap();
        assert_eq!(renderer.render(), expected, "{second:?}");
    }
}

/// Two textured walls with a step between them, a ball, and a shape without texture coordinates.
fn mapped() -> Scene {
    let mut scene = small_scene(16);
    add_egg(&mut scene, 1);
    let corners = vec![[-1.0, -1.0, 0.3], [1.0, -1.0, 0.0], [1.2, 1.0, 0.1], [-1.0, 1.1, 0.4]];
    let coordinates = vec![[0.1, 0.2], [0.9, 0.1], [2.0, 1.5], [-0.2, 0.8], [0.3, 0.4]];
    let uvs = vec![[0, 1, 2], [4, 2, 3]];
    let wall = Mesh::new("mapped", corners, vec![[0, 1, 2], [0, 2, 3]]);
    scene.add_mesh(wall.texture_coordinates(coordinates, uvs)).unwrap();
    scene
}

#[test]
fn texture_coordinates_agree_with_finite_differences() {
    let scene = mapped();
    let target = target_of(&scene, &of(Pass::Uv));
    let (mut own, mut others) = (0, 0);
    for id in scene.parameters() {
        let path = scene.path(id).to_string();
        if path.ends_with("texture_coordinates") || scene.moves_edges(id) {
            check_parameter_with(&of(Pass::Uv), &scene, &target, LossKind::MeanSquared, id);
            *if path.ends_with("texture_coordinates") { &mut own } else { &mut others } += 1;
        }
    }
    assert!(own == 1 && others > 5, "{own} {others}");
}

/// The jump of texture coordinates between triangles is an edge, also where their surface is one.
#[test]
fn texture_coordinates_have_edges_where_charts_end() {
    let scene = mapped();
    let settings = Settings { edges: Edges::On, ..of(Pass::Uv) };
    let image = |settings: &Settings| render(&scene, settings).unwrap();
    let fine = Settings { sampling: Sampling::Grid(16), edges: Edges::Off, ..settings };
    let error = |image: &Image, of: &Image| -> f32 {
        image.pixels.iter().zip(&of.pixels).map(|(a, b)| (a[0] - b[0]).abs()).sum()
    };
    let (fine, edged) = (image(&fine), image(&settings));
    let aliased = image(&Settings { edges: Edges::Off, ..settings });
    assert!(error(&edged, &fine) < 0.2 * error(&aliased, &fine));
}

#[test]
fn identifiers_are_whole_numbers_of_what_is_in_the_middle_of_a_pixel() {
    let scene = mapped();
    let plain = Settings { edges: Edges::Off, ..of(Pass::Ids) };
    let ids = render(&scene, &plain).unwrap();
    for settings in [
        Settings { edges: Edges::On, ..plain },
        Settings { sampling: Sampling::Grid(3), ..plain },
        Settings { arithmetic: Arithmetic::default(), ..plain },
    ] {
        assert_eq!(render(&scene, &settings).unwrap(), ids);
    }
    let mut seen: Vec<[u32; 3]> =
        ids.pixels.iter().map(|pixel| pixel.map(|id| id as u32)).collect();
    assert!(ids.pixels.iter().flatten().all(|id| id.fract() == 0.0));
    seen.sort_unstable();
    seen.dedup();
    let objects = scene.meshes.len() + scene.spheres.len() + scene.shapes.len();
    for &[object, triangle, material] in seen.iter().filter(|ids| **ids != [0; 3]) {
        let at = object as usize - 1;
        assert!(at < objects && material as usize <= scene.materials.len());
        let (triangles, expected) = match scene.meshes.get(at) {
            Some(mesh) => (mesh.triangles.len(), mesh.materials[triangle as usize - 1]),
            None => match scene.spheres.get(at - scene.meshes.len()) {
                Some(sphere) => (1, sphere.material),
                None => (1, scene.shapes[0].material),
            },
        };
        assert!((1..=triangles).contains(&(triangle as usize)));
        assert_eq!(material, expected + 1);
    }
    let mapped = scene.meshes.len() as u32;
    assert!(seen.iter().any(|ids| ids[..2] == [mapped, 2]), "{seen:?}");
    assert!(seen.iter().any(|ids| ids[0] == objects as u32), "{seen:?}");
    let camera = scene.parameter("camera.look_from").unwrap();
    let refused = render_vjp(&scene, &plain, &[camera]).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused, "pass: identifiers are whole numbers and have no derivative");
}

/// A fold whose upper triangle shares an edge with one without area, which two lower ones share: as modelling programs
/// leave them.
#[test]
fn triangles_without_area_between_others_leave_no_pixel_undefined() {
    let vertices = vec![
        [-1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.1, 0.0, 0.0],
        [0.0, 1.0, 0.3],
        [-0.2, -1.0, 0.4],
    ];
    let others = [[0, 1, 3], [0, 4, 2], [2, 4, 1]];
    let image = |triangles: Vec<[u32; 3]>, settings: &Settings| {
        let mut scene = Scene::new(64, 64, Camera::looking(dvec3(0.1, 0.05, 3.0), DVec3::ZERO));
        let upper = scene.add_material("upper", Material::lambertian(DVec3::ONE)).unwrap();
        let lower = scene.add_material("lower", Material::lambertian(DVec3::X)).unwrap();
        let mut mesh = Mesh::new("fold", vertices.clone(), triangles);
        mesh.materials =
            mesh.triangles.iter().map(|t| if t.contains(&4) { lower } else { upper }).collect();
        scene.add_mesh(mesh).unwrap();
        render(&scene, settings).unwrap()
    };
    for pass in [Pass::Albedo, Pass::Normals, Pass::Depth] {
        let settings = Settings { edges: Edges::On, ..of(pass) };
        let without = image(others.to_vec(), &settings);
        for flat in [[0, 2, 1], [0, 1, 2]] {
            let with = image([&others[..], &[flat]].concat(), &settings);
            let pixels = with.pixels.iter().flatten().zip(without.pixels.iter().flatten());
            for (with, without) in pixels {
                assert!((with - without).abs() < 1e-3, "{pass:?}, {flat:?}: {with} {without}");
            }
        }
    }
}
