//! ADBench's reprojection error of a point in a camera: two residuals, 15 parameters.

use ad::{Real, differentiable};

use crate::problem::Problem;
use crate::random::Random;

/// Camera (rotation 3, centre 3, focal length, principal point 2, radial distortion 2), point (3),
/// weight.
pub const PARAMETERS: usize = 15;

#[differentiable]
pub fn residuals<S: Real<Mask = bool>>(p: [S; PARAMETERS], feature: [f64; 2]) -> (S, S) {
    let (rx, ry, rz) = (p[0], p[1], p[2]);
    let (x, y, z) = (p[11] - p[3], p[12] - p[4], p[13] - p[5]);
    let square = rx * rx + ry * ry + rz * rz;
    let (u, v, w) = if square.cmpgt(S::ZERO) {
        // Rodrigues' formula.
        let angle = square.sqrt();
        let (sin, cos) = (angle.sin(), angle.cos());
        let recip = angle.recip();
        let (ax, ay, az) = (rx * recip, ry * recip, rz * recip);
        let along = (ax * x + ay * y + az * z) * (S::ONE - cos);
        (
            x * cos + (ay * z - az * y) * sin + ax * along,
            y * cos + (az * x - ax * z) * sin + ay * along,
            z * cos + (ax * y - ay * x) * sin + az * along,
        )
    } else {
        (x + ry * z - rz * y, y + rz * x - rx * z, z + rx * y - ry * x)
    };
    let (px, py) = (u / w, v / w);
    let r2 = px * px + py * py;
    let distortion = S::ONE + p[9] * r2 + p[10] * r2 * r2;
    let focal = p[6] * distortion;
    (
        p[14] * (px * focal + p[7] - S::from_f64(ad::stop_gradient(feature[0]))),
        p[14] * (py * focal + p[8] - S::from_f64(ad::stop_gradient(feature[1]))),
    )
}

/// Both rows of the Jacobian, written by hand.
pub fn adjoint(p: [f64; PARAMETERS], feature: [f64; 2]) -> [[f64; PARAMETERS]; 2] {
    let r = [p[0], p[1], p[2]];
    let t = [p[11] - p[3], p[12] - p[4], p[13] - p[5]];
    let square = dot(r, r);
    let angle = square.sqrt();
    let (sin, cos) = angle.sin_cos();
    let recip = 1.0 / angle;
    let axis = r.map(|r| r * recip);
    let across = cross(axis, t);
    let projection = dot(axis, t);
    let [u, v, w] = match square > 0.0 {
        true => std::array::from_fn(|i| {
            t[i] * cos + across[i] * sin + axis[i] * (projection * (1.0 - cos))
        }),
        false => {
            let across = cross(r, t);
            std::array::from_fn(|i| t[i] + across[i])
        }
    };
    let w_recip = 1.0 / w;
    let (px, py) = (u * w_recip, v * w_recip);
    let r2 = px * px + py * py;
    let distortion = 1.0 + p[9] * r2 + p[10] * r2 * r2;
    let focal = p[6] * distortion;

    let row = |gx: f64, gy: f64| {
        let mut bar = [0.0; PARAMETERS];
        bar[14] = gx * (px * focal + p[7] - feature[0]) + gy * (py * focal + p[8] - feature[1]);
        let (gx, gy) = (gx * p[14], gy * p[14]);
        (bar[7], bar[8]) = (gx, gy);
        let focal_bar = gx * px + gy * py;
        bar[6] = focal_bar * distortion;
        let distortion_bar = focal_bar * p[6];
        (bar[9], bar[10]) = (distortion_bar * r2, distortion_bar * r2 * r2);
        let r2_bar = distortion_bar * (p[9] + 2.0 * p[10] * r2);
        let px_bar = (gx * focal + 2.0 * px * r2_bar) * w_recip;
        let py_bar = (gy * focal + 2.0 * py * r2_bar) * w_recip;
        let rotated_bar = [px_bar, py_bar, -(px_bar * px + py_bar * py)];
        let (r_bar, t_bar) = if square > 0.0 {
            // t cos + (a x t) sin + a (a . t) (1 - cos), with the axis a = r / |r|.
            let along_bar = dot(rotated_bar, axis);
            let cross_bar = cross(rotated_bar, axis);
            let t_bar: [f64; 3] = std::array::from_fn(|i| {
                rotated_bar[i] * cos + cross_bar[i] * sin + axis[i] * (along_bar * (1.0 - cos))
            });
            let turned = cross(t, rotated_bar);
            let axis_bar: [f64; 3] = std::array::from_fn(|i| {
                turned[i] * sin + (1.0 - cos) * (rotated_bar[i] * projection + t[i] * along_bar)
            });
            let angle_bar = dot(rotated_bar, across) * cos
                + sin * (projection * along_bar - dot(rotated_bar, t));
            let along = dot(axis_bar, axis);
            let r_bar = std::array::from_fn(|i| {
                angle_bar * axis[i] + (axis_bar[i] - axis[i] * along) * recip
            });
            (r_bar, t_bar)
        } else {
            let cross_bar = cross(rotated_bar, r);
            (cross(t, rotated_bar), std::array::from_fn(|i| rotated_bar[i] + cross_bar[i]))
        };
        bar[..3].copy_from_slice(&r_bar);
        bar[11..14].copy_from_slice(&t_bar);
        for i in 0..3 {
            bar[3 + i] = -t_bar[i];
        }
        bar
    };
    [row(1.0, 0.0), row(0.0, 1.0)]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub struct BundleAdjustment;

const FEATURE: [f64; 2] = [-0.3, 0.2];

impl Problem for BundleAdjustment {
    const NAME: &'static str = "bundle adjustment, both rows";
    const OUTPUTS: usize = 2;

    fn point(&self) -> Vec<f64> {
        let mut p = Random::new(3).numbers::<PARAMETERS>();
        // The point lies well in front of the camera.
        p[13] += 4.0;
        p.to_vec()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        (outputs[0], outputs[1]) = residuals(*x.first_chunk().expect("15 numbers"), FEATURE);
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        let p = *x.first_chunk().expect("15 numbers");
        for (row, seed) in jacobian.chunks_exact_mut(PARAMETERS).zip([(1.0, 0.0), (0.0, 1.0)]) {
            row.copy_from_slice(&residuals::vjp(p, FEATURE).1(seed).0);
        }
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let [p, direction] = [x, direction].map(|x| *x.first_chunk().expect("15 numbers"));
        let (_, (first, second)) = residuals::jvp(p, FEATURE, direction, [0.0; 2]);
        tangents.copy_from_slice(&[first, second]);
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        let rows = adjoint(*x.first_chunk().expect("15 numbers"), FEATURE);
        jacobian.copy_from_slice(rows.as_flattened());
    }
}
