//! Functions of glam whose derivatives are those of formulas, as programs call them.

use ad::differentiable;
use glam::{DAffine3, DQuat, DVec2, DVec3};

macro_rules! programs {
    ($module:ident $scalar:ident $v2:ident $v3:ident $v4:ident $q:ident
        $m2:ident $m3:ident $m4:ident $a2:ident $a3:ident) => {
        pub mod $module {
            use ad::differentiable;
            use glam::{$a2, $a3, $m2, $m3, $m4, $q, $v2, $v3, $v4};

            type S = $scalar;

            #[differentiable]
            pub fn rejections(x: S, y: S) -> S {
                let (a, b) = ($v3::new(x, y, x * y), $v3::new(1.0, x, y));
                let (c, d) = ($v2::new(x, y), $v2::new(y, 1.0 + x));
                let rejected = a.reject_from(b).dot(b.reject_from(a));
                let normal = d.project_onto_normalized(c) + c.reject_from_normalized(d);
                let long = $v4::new(x, y, 1.0, 2.0).reject_from($v4::new(1.0, y, x, y));
                rejected + normal.x * normal.y + long.x * long.w
            }

            #[differentiable]
            pub fn lengths(x: S, y: S) -> S {
                let (a, b) = ($v3::new(x, y, 2.0), $v2::new(x, y));
                let unit = a.normalize_or($v3::new(y, 1.0, x));
                let fallback = (b - b).normalize_or($v2::new(y * y, x));
                let shorter = a.clamp_length(0.1 * x, 0.5 * y) + a.clamp_length_max(0.3 * y);
                let longer = b.clamp_length(8.0 * x, 9.0 * x) + b.clamp_length_min(7.0 * y);
                let same = b.clamp_length(0.01, 100.0);
                let moved = a.move_towards(unit, 0.4 * x) + unit.move_towards(a, 50.0 * y);
                unit.x + fallback.x * same.y + shorter.y * longer.x + moved.z * longer.y
            }

            #[differentiable]
            pub fn refracted(x: S, y: S) -> S {
                let (ray, normal) =
                    ($v3::new(x, -y, 0.2).normalize(), $v3::new(0.1, 1.0, x).normalize());
                let through = ray.refract(normal, 0.6 + 0.1 * y);
                let flat = $v2::new(x, -y).normalize().refract($v2::new(0.0, 1.0), 0.7 * x);
                let total = ray.refract(normal, 50.0 * x);
                through.x * through.y + flat.x + flat.y + total.x
            }

            #[differentiable]
            pub fn angles(x: S, y: S) -> S {
                let (a, b) = ($v2::new(x, y), $v2::from_angle(x * y));
                let turned = a.rotate(b).perp() + b.rotate_angle(y);
                let (c, d) = ($v3::new(x, y, 0.3), $v3::new(y, -x * x, 1.0));
                a.to_angle() * b.perp_dot(a)
                    + a.angle_to(b)
                    + turned.x * turned.y
                    + c.angle_between(d)
            }

            #[differentiable]
            pub fn rotations(x: S, y: S) -> S {
                let a = $v3::new(x, y, 0.3);
                let about = a.rotate_x(x) + a.rotate_y(y).rotate_z(x * y);
                let turned = about.rotate_axis($v3::new(y, 1.0, x).normalize(), x + y);
                turned.x * turned.y + turned.z
            }

            #[differentiable]
            pub fn quaternions(x: S, y: S) -> S {
                let a = $q::from_scaled_axis($v3::new(x, y, 0.3));
                let identity = $q::from_scaled_axis($v3::new(x - x, y - y, 0.0));
                let arc = $q::from_rotation_arc(
                    $v3::new(x, y, 0.3).normalize(),
                    $v3::new(y, -1.0, x).normalize(),
                );
                let (axis, angle) = a.to_axis_angle();
                let back = (a * arc).to_scaled_axis();
                let (half, same) = (arc / (x + 2.0), identity.to_scaled_axis());
                axis.x * angle
                    + back.y * back.z
                    + a.angle_between(arc)
                    + half.w
                    + same.x * identity.w
            }

            #[differentiable]
            pub fn matrices(x: S, y: S) -> S {
                let a = $m3::from_scale_angle_translation($v2::new(x, y), x * y, $v2::new(y, 1.0));
                let b = $m3::from_angle(x)
                    * $m3::from_scale($v2::new(y, x))
                    * $m3::from_translation($v2::new(x, 2.0));
                let c =
                    $m3::from_mat2($m2::from_cols($v2::new(x, y), $v2::new(1.0, y)).div_scalar(y));
                let p =
                    a.transform_point2($v2::new(x, 1.0)) + b.transform_vector2($v2::new(1.0, y));
                let wide = $m4::from_mat3(a.mul_scalar(x) / y);
                let q = wide.project_point3($v3::new(p.x, p.y, x));
                let mut perspective = wide;
                perspective.x_axis.w = y;
                let r = perspective.project_point3(q);
                let narrow = $m3::from_mat4(perspective).determinant();
                q.x * q.y + c.determinant() + r.z + narrow
            }

            #[differentiable]
            pub fn plane(x: S, y: S) -> S {
                let a = $a2::from_scale_angle_translation($v2::new(x, y), x * y, $v2::new(y, 1.0));
                let b = $a2::from_angle(x) * $a2::from_scale($v2::new(y, x));
                let c = $a2::from_angle_translation(y, $v2::new(x, 2.0))
                    * $a2::from_translation($v2::new(x, y));
                let d = $a2::from_mat2(a.matrix2)
                    * $a2::from_mat2_translation(b.matrix2, c.translation);
                let p = (a * b * c * d.inverse()).transform_point2($v2::new(x, 1.0));
                let v = a.inverse().transform_vector2(p) + c.translation * y;
                p.x * v.y + v.x
            }

            #[differentiable]
            pub fn space(x: S, y: S) -> S {
                let turn = $q::from_rotation_y(x);
                let a = $a3::from_scale_rotation_translation(
                    $v3::new(x, y, 1.5),
                    turn,
                    $v3::new(y, 1.0, x),
                );
                let b = $a3::from_rotation_translation(turn, $v3::new(x, y, 0.0))
                    * $a3::from_scale($v3::new(y, x, 1.0));
                let c =
                    $a3::from_rotation_x(x) * $a3::from_rotation_y(y) * $a3::from_rotation_z(x * y);
                let d = $a3::from_quat(turn) * $a3::from_axis_angle($v3::new(0.6, 0.0, 0.8), y);
                let e = $a3::from_translation($v3::new(x, y, 1.0)) * $a3::from_mat3(a.matrix3);
                let f = $a3::from_mat3_translation(b.matrix3, e.translation)
                    * $a3::from_mat4($m4::from_translation($v3::new(y, x, x)));
                let p = (a * b * c * d * e.inverse() * f).transform_point3($v3::new(x, 1.0, y));
                let v = a.inverse().transform_vector3(p);
                p.x * v.y + v.z * p.z
            }

            #[differentiable]
            pub fn tuples(x: S, y: S) -> S {
                let a: $v3 = (x, y, x * y).into();
                let b = $v2::from((a.x, a.z));
                let (c, d): (S, S) = b.into();
                a.dot(a) * c + d
            }
        }
    };
}

programs!(double f64 DVec2 DVec3 DVec4 DQuat DMat2 DMat3 DMat4 DAffine2 DAffine3);
programs!(single f32 Vec2 Vec3 Vec4 Quat Mat2 Mat3 Mat4 Affine2 Affine3);

#[differentiable]
fn about(x: f64, y: f64) -> f64 {
    let turn = DQuat::from_scaled_axis(DVec3::new(x, 0.0, 0.0));
    turn.to_scaled_axis().x + 3.0 * turn.x + turn.to_axis_angle().1 * y
}

#[differentiable]
fn flat(x: f64, y: f64) -> f64 {
    let inverse = DAffine3::from_scale(DVec3::new(x, y, 0.0)).inverse();
    let fallback = DVec2::new(0.0, x).normalize_or(DVec2::new(y, 1.0));
    fallback.x + if inverse.is_finite() { inverse.translation.x } else { 0.0 }
}

#[test]
fn without_direction() {
    assert_eq!(about::grad(0.0, 1.0), (2.5, 0.0));
    assert_eq!(about::jvp(0.0, 1.0, 1.0, 0.0), (0.0, 2.5));
    assert_eq!(flat::grad(0.0, 2.0), (0.0, 1.0));
}

macro_rules! compare {
    ($($name:ident),*) => {
        #[test]
        fn in_double_precision() {
            use crate::oracle::check;
            use double::*;
            $(check!($name(x, y) at [1.3, 0.7], [0.4, 1.1]);)*
        }

        #[test]
        fn in_single_precision() {
            $(
                let (_, (by_x, by_y)) = single::$name::value_and_grad(1.3, 0.7);
                let (_, along) = single::$name::jvp(1.3, 0.7, 1.0, 0.0);
                let (_, expected) = double::$name::value_and_grad(1.3, 0.7);
                let size = 1.0 + expected.0.abs().max(expected.1.abs());
                for (got, expected) in [(by_x, expected.0), (by_y, expected.1), (along, expected.0)] {
                    let error = (f64::from(got) - expected).abs();
                    assert!(error < 1e-4 * size, "{}: {got} is not {expected}", stringify!($name));
                }
            )*
        }
    };
}

compare!(
    rejections,
    lengths,
    refracted,
    angles,
    rotations,
    quaternions,
    matrices,
    plane,
    space,
    tuples
);
