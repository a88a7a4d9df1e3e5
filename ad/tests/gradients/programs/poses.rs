//! Cameras and skeletons: quaternions and matrices of glam.

use ad::{Differentiable, differentiable};
use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Joint {
    rotation: DQuat,
    offset: DVec3,
}

#[differentiable]
fn world(joints: &[Joint]) -> DMat4 {
    let mut pose = DMat4::IDENTITY;
    for joint in joints {
        pose *= DMat4::from_rotation_translation(joint.rotation, joint.offset);
    }
    pose
}

#[differentiable]
fn skeleton(bend: f64, twist: f64) -> f64 {
    let joints = [
        Joint { rotation: DQuat::from_rotation_x(bend), offset: DVec3::Y },
        Joint {
            rotation: DQuat::from_axis_angle(DVec3::new(0.6, 0.8, 0.0), twist),
            offset: DVec3::new(0.1, 0.7, bend),
        },
        Joint {
            rotation: (DQuat::from_rotation_z(bend) * DQuat::from_rotation_y(twist)).normalize(),
            offset: DVec3::Y * 0.5,
        },
    ];
    let pose = world(&joints);
    let tip = pose.transform_point3(DVec3::new(0.0, 0.3, 0.1));
    let turned = pose.transform_vector3(DVec3::Z);
    tip.distance(DVec3::new(0.2, 1.8, 0.4)) + turned.x + pose.determinant()
}

#[differentiable]
fn projected(angle: f64, focal: f64) -> f64 {
    let between = DQuat::from_rotation_y(0.2).slerp(DQuat::from_rotation_x(angle), 0.3 * focal);
    let eye = DVec3::new(0.3, -0.2, 4.0);
    let rotation = DMat3::from_quat(between) * DMat3::from_rotation_z(angle);
    let view = rotation.transpose();
    let mut error = 0.0;
    for point in [DVec3::new(0.4, 0.1, 0.0), DVec3::new(-0.3, 0.6, -0.5)] {
        let p = view * (point - eye);
        let screen = p.truncate() / -p.z * focal;
        error += screen.length_squared();
    }
    let shear = DMat3::from_cols(DVec3::X, DVec3::new(angle, 1.0, 0.0), DVec3::Z);
    let back = (shear * rotation).inverse() * DVec3::new(1.0, focal, 2.0);
    error + back.dot(between * DVec3::X) + (DMat4::from_scale(back) * DVec4::ONE).y
}

#[test]
fn poses() {
    check!(skeleton(bend, twist) at [0.4, 1.1], [-0.9, 0.3]);
    check!(projected(angle, focal) at [0.4, 1.1], [-0.9, 0.8]);
}
