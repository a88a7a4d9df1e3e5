//! The derivative of every pixel by one number of a scene: by forward mode, and by differences.

use glam::DVec3;
use renderer::Error;
use renderer::acceleration::{Acceleration, Shape};
use renderer::arithmetic::{Arithmetic, Precision};
use renderer::demo::demo_experiment;
use renderer::experiment::Target;
use renderer::kernels::camera::{Camera, CameraTangent, frame, primary_ray};
use renderer::kernels::light::{PointLight, PointLightTangent};
use renderer::kernels::material::{Material, MaterialTangent, reflection_of_point_light};
use renderer::kernels::triangle::triangle_surface;
use renderer::recovery::{natural_scale, render_at};
use renderer::scene::{Light, MeshObject, ParameterId, Parameters, Scene};

/// The tree of the demo under its true light, in an image of `size` by `size` pixels.
pub fn scene(size: u32) -> Result<Scene, Error> {
    let experiment = demo_experiment()?;
    let mut scene = experiment.scene;
    (scene.width, scene.height) = (size, size);
    scene.parameters.camera.focus = 0.4;
    if let Some(Target::Values(truth)) = experiment.optimize.and_then(|optimize| optimize.target) {
        for (id, values) in truth {
            scene.parameters.get_mut(id).copy_from_slice(&values);
        }
    }
    Ok(scene)
}

/// By central differences of two images in double precision. The images see edges move.
pub fn by_differences(scene: &Scene, id: ParameterId, element: usize) -> Vec<DVec3> {
    let step = 1e-3 * natural_scale(scene, id);
    let image = |offset: f64| {
        let mut moved = scene.clone();
        moved.parameters.get_mut(id)[element] += offset;
        render_at(Arithmetic::fastest(Precision::F64), &moved)
    };
    let (above, below) = (image(step), image(-step));
    let pixel = |rgb: &[f32; 3]| glam::Vec3::from(*rgb).as_dvec3();
    let pairs = above.pixels.iter().zip(&below.pixels);
    pairs.map(|(above, below)| (pixel(above) - pixel(below)) / (2.0 * step)).collect()
}

/// By the forward mode of the renderer's kernels, which comes with their gradients. Which triangle a pixel
/// shows, and whether it lies in the shadow, does not change: the interior term.
///
/// The scene has one point light, meshes and no mirrors.
pub fn by_forward_mode(scene: &Scene, id: ParameterId, element: usize) -> Vec<DVec3> {
    let values = &scene.parameters;
    let mut direction = values.clone();
    for other in scene.parameter_ids() {
        direction.get_mut(other).fill(0.0);
    }
    direction.get_mut(id)[element] = 1.0;

    let triangles = triangles(scene);
    let corners = |&(mesh, corners, _): &Triangle, parameters: &Parameters| {
        corners.map(|corner| DVec3::from_array(parameters.vertices[mesh][corner as usize]))
    };
    let shapes: Vec<Shape> = triangles
        .iter()
        .map(|triangle| Shape::Triangle(corners(triangle, values).map(|v| v.as_vec3())))
        .collect();
    let acceleration = Acceleration::new(&shapes[..]);
    let aspect = f64::from(scene.width) / f64::from(scene.height);
    let Camera { look_from, look_at, up, vfov, focus } = direction.camera;
    let camera_dot = CameraTangent { look_from, look_at, up, vfov, focus };
    let (frame, frame_dot) = frame::jvp::<f64>(values.camera, aspect, camera_dot, 0.0);
    let (light, light_dot) = (point_light(&values.lights[0]), point_light(&direction.lights[0]));
    let PointLight { position, color, intensity } = light_dot;
    let light_dot = PointLightTangent { position, color, intensity };

    let derivative = |x: f64, y: f64| {
        let (ray, ray_dot) = primary_ray::jvp::<f64>(frame, x, y, frame_dot, 0.0, 0.0);
        let Some(hit) = acceleration.nearest(ray.origin.as_vec3(), ray.direction.as_vec3()) else {
            return DVec3::ZERO;
        };
        let triangle = &triangles[hit.primitive as usize];
        let ([a, b, c], [a_dot, b_dot, c_dot]) =
            (corners(triangle, values), corners(triangle, &direction));
        let (surface, surface_dot) =
            triangle_surface::jvp::<f64>(ray, a, b, c, ray_dot, a_dot, b_dot, c_dot);
        let material = values.materials[triangle.2];
        let Material { ambient, diffuse, specular, exponent, reflection } =
            direction.materials[triangle.2];
        let material_dot = MaterialTangent { ambient, diffuse, specular, exponent, reflection };
        let to_light = light.position - surface.point;
        let (origin, from) = (surface.point.as_vec3(), Some(hit.primitive));
        if acceleration.is_occluded(origin, to_light.as_vec3(), 1.0, from) {
            return ambient;
        }
        let (_, reflected_dot) = reflection_of_point_light::jvp::<f64>(
            material,
            surface,
            light,
            material_dot,
            surface_dot,
            light_dot,
        );
        ambient + reflected_dot
    };
    let (width, height) = (scene.width, scene.height);
    let place = |index: u32, count: u32| f64::from(2 * index + 1) / f64::from(count) - 1.0;
    let pixels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    pixels.map(|(column, row)| derivative(place(column, width), -place(row, height))).collect()
}

/// The mesh of a triangle, its corners there, and its material.
type Triangle = (usize, [u32; 3], usize);

fn triangles(scene: &Scene) -> Vec<Triangle> {
    let of_mesh = |(index, mesh): (usize, &MeshObject)| {
        let pairs = mesh.triangles.iter().zip(&mesh.materials);
        pairs.map(|(&corners, &material)| (index, corners, material as usize)).collect::<Vec<_>>()
    };
    scene.meshes.iter().enumerate().flat_map(of_mesh).collect()
}

fn point_light(light: &Light<f64>) -> PointLight<f64> {
    match light {
        Light::Point(light) => *light,
        Light::Distant(_) => panic!("the light is a point light"),
    }
}

/// The largest derivative of a channel, without its sign.
pub fn largest(derivatives: &[DVec3]) -> f64 {
    derivatives.iter().fold(0.0, |largest, d| largest.max(d.abs().max_element()))
}

/// The part of the pixels at which two images of derivatives differ by more than `tolerance` times
/// the largest derivative of the first.
pub fn different(derivatives: &[DVec3], others: &[DVec3], tolerance: f64) -> f64 {
    let limit = tolerance * largest(derivatives);
    let pairs = derivatives.iter().zip(others);
    let count = pairs.filter(|(d, other)| (**d - **other).abs().max_element() > limit).count();
    count as f64 / derivatives.len() as f64
}
