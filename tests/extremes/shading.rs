//! Lights and materials at their ends.

use ad::Scalar;

use crate::images::check_agreement;
use crate::kernels::{BySpot, DistantLit, Kernel, PointLit};
use crate::oracle::{Case, check};
use crate::scenes::{set, small_parts, small_scene};

/// A surface point, a material and a light.
#[derive(Clone, Copy)]
struct Shading {
    position: [f64; 3],
    color: [f64; 3],
    intensity: f64,
    diffuse: [f64; 3],
    roughness: f64,
    specular: [f64; 3],
    exponent: f64,
    view: [f64; 3],
    /// A length over which the radiance changes when the light moves.
    length: f64,
    /// An angle over which it changes when directions turn.
    angle: f64,
    value: f64,
    gradient: f64,
}

/// The surface lies at the origin and faces +z.
const ORDINARY: Shading = Shading {
    position: [0.75, -0.5, 2.0],
    color: [1.0, 0.75, 0.5],
    intensity: 30.0,
    diffuse: [0.5, 0.25, 0.75],
    roughness: 0.375,
    specular: [0.25, 0.5, 0.125],
    exponent: 20.0,
    view: [-0.36, 0.48, 0.8],
    length: 0.1,
    angle: 0.01,
    value: 50.0,
    gradient: 100.0,
};

impl Shading {
    #[track_caller]
    fn check(self, name: &str) {
        self.check_point(name);
        let Self { length, angle, value, gradient, .. } = self;
        let name = format!("{name}, from infinitely far");
        let power = self.power();
        let lengths = [length, 1.0, power, 1.0, 0.1, 1.0, 0.1, 1.0, angle, angle];
        check::<DistantLit>(&Case {
            name: &name,
            x: &self.numbers(),
            lengths: &lengths,
            value,
            gradient,
        });
    }

    #[track_caller]
    fn check_point(self, name: &str) {
        let Self { length, angle, value, gradient, .. } = self;
        let power = self.power();
        let lengths = [length, 1.0, power, 1.0, 0.1, 1.0, 0.1, length, angle, angle];
        check::<PointLit>(&Case { name, x: &self.numbers(), lengths: &lengths, value, gradient });
    }

    /// A change of the intensity that changes the radiance.
    fn power(&self) -> f64 {
        if self.intensity > 0.0 { self.intensity } else { 1.0 }
    }

    fn numbers(&self) -> Vec<f64> {
        let Self {
            position, color, intensity, diffuse, roughness, specular, exponent, view, ..
        } = *self;
        let numbers = [
            &position[..],
            &color,
            &[intensity],
            &diffuse,
            &[roughness],
            &specular,
            &[exponent],
            &[0.0; 3],
            &[0.0, 0.0, 1.0],
            &view,
        ];
        numbers.concat().into_iter().map(|x| f64::from(x as f32)).collect()
    }
}

#[test]
fn intensities_and_exponents() {
    for intensity in [1e-30, 1e-10, 1.0, 1e10, 1e30] {
        Shading { intensity, ..ORDINARY }.check(&format!("light of intensity {intensity:e}"));
    }
    for exponent in [0.0, 1.0, 100.0, 1e4] {
        // Next to where the mirror direction is.
        Shading {
            position: [0.73, -0.95, 1.6],
            exponent,
            length: 0.1 / exponent.max(1.0),
            angle: 0.1 / exponent.max(1.0),
            value: 50.0 + 10.0 * exponent,
            gradient: 100.0 + 100.0 * exponent,
            ..ORDINARY
        }
        .check(&format!("highlight with exponent {exponent}"));
    }
}

#[test]
fn albedos() {
    let black = [0.0; 3];
    let white = [1.0; 3];
    Shading { diffuse: black, specular: black, ..ORDINARY }.check("black albedo");
    Shading { diffuse: white, specular: black, ..ORDINARY }.check("white albedo");
    Shading { diffuse: black, specular: white, ..ORDINARY }.check("white highlight");
    for roughness in [0.0, 1e-6, 1.0] {
        Shading { roughness, ..ORDINARY }.check(&format!("roughness {roughness:e}"));
    }
    Shading { color: black, ..ORDINARY }.check("black light");
    Shading { intensity: 0.0, ..ORDINARY }.check("light of intensity zero");
}

#[test]
fn directions() {
    for sine in [1e-3, 1e-7] {
        Shading { position: [2.0, 0.0, 2.0 * sine], length: sine, ..ORDINARY }
            .check(&format!("light {sine:e} rad above the surface"));
        Shading { position: [2.0, 0.0, -2.0 * sine], length: sine, ..ORDINARY }
            .check(&format!("light {sine:e} rad below the surface"));
    }
    Shading { position: [0.5, 0.25, -2.0], ..ORDINARY }.check("light behind the surface");
    let [x, y, z] = ORDINARY.view;
    for exponent in [0.0, 1.0, 20.0] {
        Shading { position: [-x, -y, -z], exponent, ..ORDINARY }
            .check(&format!("half vector zero, exponent {exponent}"));
    }
    // There a rough surface has a kink.
    Shading { position: [2.0 * x, 2.0 * y, 2.0 * z], roughness: 0.0, ..ORDINARY }
        .check("light behind the camera");
}

#[test]
fn distances() {
    for distance in [1e-10, 1e-6, 1e6, 1e10] {
        let position = ORDINARY.position.map(|x| x * distance);
        Shading { position, length: 0.1 * distance, ..ORDINARY }
            .check_point(&format!("light at distance {distance:e}"));
    }
}

/// Points at `angle` degrees from the axis of a cone between `inner` and `outer` degrees.
#[test]
fn cones() {
    for (inner, outer, angle) in [
        (10.0, 30.0, 20.0),
        (0.0, 90.0, 60.0),
        (0.0, 1e-3, 6e-4),
        (5.0, 5.001, 5.0005),
        (30.0, 40.0, 10.0),
        (30.0, 40.0, 50.0),
        (30.0, 40.0, 180.0),
    ] {
        for distance in [1e-6, 1.0, 1e6] {
            let (sine, cosine) = f64::to_radians(angle).sin_cos();
            let x = [
                [0.0; 3],
                [0.0, 0.0, 2.0],
                [1.0, 0.75, 0.5],
                [30.0, inner, outer],
                [sine * distance, 0.0, cosine * distance],
            ];
            let x: Vec<f64> = x.as_flattened().iter().map(|&x| f64::from(x as f32)).collect();
            let width: f64 = outer - inner;
            let turn = 0.01 * width.to_radians();
            // The fall-off takes the difference of two angles apart.
            let digits = 50.0 * outer / width;
            check::<BySpot>(&Case {
                name: &format!("cone of {inner} to {outer} degrees, {angle} off, at {distance:e}"),
                x: &x,
                lengths: &[
                    turn * distance,
                    turn,
                    1.0,
                    30.0,
                    0.01 * width,
                    0.01 * width,
                    turn * distance,
                ],
                value: digits,
                gradient: 4.0 * digits,
            });
        }
    }
}

/// A light in the surface point has no direction: it brings nothing, and neither does a derivative.
#[test]
fn a_light_in_the_surface_is_dark() {
    fn darkness<S: Scalar>() {
        let numbers = Shading { position: [0.0; 3], ..ORDINARY }.numbers();
        let x: Vec<S> = numbers.into_iter().map(S::from_f64).collect();
        assert!(PointLit::value(&x).iter().all(|radiance| radiance.vanishes()));
        assert!(PointLit::pull_back(&x, &[S::ONE; 3]).iter().all(|gradient| gradient.vanishes()));
    }
    darkness::<f32>();
    darkness::<f64>();
}

/// Lights in corners, on surfaces, inside of a closed one, and in the camera.
#[test]
fn scenes_under_lights_in_odd_places() {
    for (place, position) in [
        ("in a vertex", [0.4, 0.0, 0.6]),
        ("on an edge", [0.7, 0.65, 0.4]),
        ("on the sphere", [-0.8, 1.0, 0.4]),
        ("in the middle of the sphere", [-0.8, 0.5, 0.4]),
        ("below the floor", [0.0, -50.0, 0.0]),
        ("in the camera", [0.3, 2.5, 6.0]),
        ("far away", [2e7, 4e7, 3e7]),
    ] {
        let mut scene = small_scene(24);
        set(&mut scene, "light.key.position", &position);
        check_agreement(&format!("scene with a light {place}"), &scene, 1e-4);
    }
}

#[test]
fn scenes_of_extreme_materials() {
    // A highlight of exponent 1e4 falls between the pixels.
    for exponent in [0.0, 1.0, 100.0] {
        let mut parts = small_parts(24);
        parts.materials.iter_mut().for_each(|material| material.values.exponent = exponent);
        check_agreement(&format!("scene of exponent {exponent}"), &parts.scene(), 1e-3);
    }
    // A black one shows no light that the image could differ by.
    for (name, albedo) in [("nearly black", 1e-3), ("white", 1.0)] {
        let mut parts = small_parts(24);
        for material in &mut parts.materials {
            material.values.diffuse = glam::DVec3::splat(albedo);
            material.values.specular = material.values.diffuse;
        }
        check_agreement(&format!("scene of {name} albedo"), &parts.scene(), 1e-4);
    }
}
