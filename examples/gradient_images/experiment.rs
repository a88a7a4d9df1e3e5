//! The derivative of every pixel by one number of a scene: by dual numbers, and by differences.

use ad::vector::Vector3;
use ad::{Dual, Vec3};
use glam::DVec3;
use renderer::Error;
use renderer::acceleration::{Acceleration, Shape};
use renderer::arithmetic::{Arithmetic, Precision};
use renderer::demo::demo_experiment;
use renderer::experiment::Target;
use renderer::kernels::camera::{Camera, Ray, frame, primary_ray};
use renderer::kernels::light::PointLight;
use renderer::kernels::material::{Material, reflection_of_point_light};
use renderer::kernels::triangle::triangle_surface;
use renderer::recovery::{natural_scale, render_at};
use renderer::scene::{Light, MeshObject, ParameterId, Parameters, Scene};

/// A number, and its derivative by the chosen one.
type Number = Dual<f64>;

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

/// By one run of the renderer's kernels on dual numbers for each pixel. Which triangle a pixel shows,
/// and whether it lies in the shadow, does not change: the interior term.
///
/// The scene has one point light, meshes and no mirrors.
pub fn by_dual_numbers(scene: &Scene, id: ParameterId, element: usize) -> Vec<DVec3> {
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
    let camera = camera(&values.camera, &direction.camera);
    let aspect = Dual::constant(f64::from(scene.width) / f64::from(scene.height));
    let frame = frame::<Number>(camera, aspect);
    let light = point_light(&values.lights[0], &direction.lights[0]);

    let derivative = |x: f64, y: f64| {
        let ray: Ray<Number> = primary_ray::<Number>(frame, Dual::constant(x), Dual::constant(y));
        let Some(hit) =
            acceleration.nearest(value(ray.origin).as_vec3(), value(ray.direction).as_vec3())
        else {
            return DVec3::ZERO;
        };
        let triangle = &triangles[hit.primitive as usize];
        let (at, along) = (corners(triangle, values), corners(triangle, &direction));
        let [a, b, c] = [0, 1, 2].map(|corner| lift(at[corner], along[corner]));
        let surface = triangle_surface::<Number>(ray, a, b, c);
        let material = material(&values.materials[triangle.2], &direction.materials[triangle.2]);
        let mut radiance = material.ambient;
        let (point, to_light) =
            (value(surface.point), value(light.position) - value(surface.point));
        let (origin, from) = (point.as_vec3(), Some(hit.primitive));
        if !acceleration.is_occluded(origin, to_light.as_vec3(), 1.0, from) {
            radiance += reflection_of_point_light::<Number>(material, surface, light);
        }
        DVec3::new(radiance.x().derivative, radiance.y().derivative, radiance.z().derivative)
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

/// Dual numbers of values and their derivatives.
fn lift(values: DVec3, derivatives: DVec3) -> Vec3<Number> {
    <Vec3<Number>>::new(
        Dual::new(values.x, derivatives.x),
        Dual::new(values.y, derivatives.y),
        Dual::new(values.z, derivatives.z),
    )
}

/// The values alone.
fn value(v: Vec3<Number>) -> DVec3 {
    DVec3::new(v.x().value, v.y().value, v.z().value)
}

fn camera(at: &Camera<f64>, along: &Camera<f64>) -> Camera<Number> {
    Camera {
        look_from: lift(at.look_from, along.look_from),
        look_at: lift(at.look_at, along.look_at),
        up: lift(at.up, along.up),
        vfov: Dual::new(at.vfov, along.vfov),
        focus: Dual::new(at.focus, along.focus),
    }
}

fn point_light(at: &Light<f64>, along: &Light<f64>) -> PointLight<Number> {
    let (Light::Point(at), Light::Point(along)) = (at, along) else {
        panic!("the light is a point light");
    };
    PointLight {
        position: lift(at.position, along.position),
        color: lift(at.color, along.color),
        intensity: Dual::new(at.intensity, along.intensity),
    }
}

fn material(at: &Material<f64>, along: &Material<f64>) -> Material<Number> {
    Material {
        ambient: lift(at.ambient, along.ambient),
        diffuse: lift(at.diffuse, along.diffuse),
        specular: lift(at.specular, along.specular),
        exponent: Dual::new(at.exponent, along.exponent),
        reflection: lift(at.reflection, along.reflection),
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
