//! Hand tracking: how far the points of a skinned hand are from where they were seen.

use std::fs;
use std::path::Path;

use ad::differentiable;
use glam::{DMat3, DMat4, DVec3};

use crate::Comparison;
use crate::read::{Numbers, reference};

/// A hand at rest.
struct Model {
    parents: Vec<Option<usize>>,
    relatives: Vec<DMat4>,
    inverse_absolutes: Vec<DMat4>,
    positions: Vec<DVec3>,
    /// For each vertex the bones that move it, and by how much.
    weights: Vec<Vec<(usize, f64)>>,
}

/// The rotation by angles about x, z and y, in this order.
#[differentiable]
fn euler(angles: DVec3) -> DMat3 {
    DMat3::from_rotation_z(angles.y)
        * DMat3::from_rotation_y(angles.z)
        * DMat3::from_rotation_x(angles.x)
}

#[differentiable]
fn axis_angle(v: DVec3) -> DMat3 {
    let angle = v.length();
    if angle < 1e-4 {
        return DMat3::IDENTITY;
    }
    DMat3::from_axis_angle(v / angle, angle)
}

/// The angles of each bone: a finger has four bones, of which three bend and one turns, too.
#[differentiable]
fn bone_angles(theta: &[f64], bones: usize) -> Vec<DVec3> {
    let mut angles = vec![DVec3::ZERO; bones];
    let (mut from, mut bone) = (6, 2);
    for _ in 0..5 {
        for joint in 0..3 {
            let bend = theta[from];
            from += 1;
            let mut turn = 0.0;
            if joint == 0 {
                turn = theta[from];
                from += 1;
            }
            angles[bone] = DVec3::new(bend, turn, 0.0);
            bone += 1;
        }
        bone += 1;
    }
    angles
}

#[differentiable]
fn transforms(#[constant] model: &Model, angles: &[DVec3]) -> Vec<DMat4> {
    let mut absolutes: Vec<DMat4> = Vec::new();
    for (i, angles) in angles.iter().enumerate() {
        let r = euler(*angles);
        let turn = DMat4::from_cols(
            r.x_axis.extend(0.0),
            r.y_axis.extend(0.0),
            r.z_axis.extend(0.0),
            glam::DVec4::W,
        );
        let relative = model.relatives[i] * turn;
        let absolute = match model.parents[i] {
            Some(parent) => absolutes[parent] * relative,
            None => relative,
        };
        absolutes.push(absolute);
    }
    absolutes.iter().enumerate().map(|(i, a)| *a * model.inverse_absolutes[i]).collect()
}

#[differentiable]
fn errors(#[constant] model: &Model, theta: &[f64], seen: &[(usize, DVec3)]) -> Vec<DVec3> {
    let transforms = transforms(model, &bone_angles(theta, model.parents.len()));
    let rotation = axis_angle(DVec3::new(theta[0], theta[1], theta[2]));
    let translation = DVec3::new(theta[3], theta[4], theta[5]);
    let mut errors = Vec::new();
    for &(vertex, point) in seen {
        let mut position = DVec3::ZERO;
        for &(bone, weight) in &model.weights[vertex] {
            position += transforms[bone].transform_point3(model.positions[vertex]) * weight;
        }
        errors.push(point - (rotation * position + translation));
    }
    errors
}

fn model(folder: &Path) -> Model {
    let text = |name: &str| fs::read_to_string(folder.join(name)).expect("a part of the model");
    let mut model = Model {
        parents: Vec::new(),
        relatives: Vec::new(),
        inverse_absolutes: Vec::new(),
        positions: Vec::new(),
        weights: Vec::new(),
    };
    for line in text("bones.txt").lines() {
        let numbers: Vec<f64> =
            line.split(':').skip(1).map(|n| n.parse().expect("a number")).collect();
        let matrix = |from: usize| {
            let rows: [f64; 16] = numbers[from..from + 16].try_into().expect("a matrix");
            DMat4::from_cols_array(&rows).transpose()
        };
        model.parents.push((numbers[0] >= 0.0).then_some(numbers[0] as usize));
        model.relatives.push(matrix(1));
        model.inverse_absolutes.push(matrix(17));
    }
    for line in text("vertices.txt").lines() {
        let numbers: Vec<f64> = line.split(':').map(|n| n.parse().expect("a number")).collect();
        model.positions.push(DVec3::from_slice(&numbers));
        let pairs = numbers[9..].chunks_exact(2).take(numbers[8] as usize);
        model.weights.push(pairs.map(|pair| (pair[0] as usize, pair[1])).collect());
    }
    model
}

pub fn compare(input: &Path) -> Comparison {
    let model = model(&input.with_file_name("model"));
    let mut numbers = Numbers::of_file(input);
    let [points, parameters] = numbers.sizes();
    let seen: Vec<(usize, DVec3)> = numbers
        .rows(points, 4)
        .iter()
        .map(|row| (row[0] as usize, DVec3::from_slice(&row[1..])))
        .collect();
    let theta = numbers.take(parameters);
    // A row of the Jacobian for each number, which the reference holds column by column.
    let mut derivatives = vec![0.0; 3 * points * parameters];
    for row in 0..3 * points {
        let (_, pullback) = errors::vjp(&model, &theta, &seen);
        let mut cotangent = vec![DVec3::ZERO; points];
        cotangent[row / 3][row % 3] = 1.0;
        let ((), by_theta, _) = pullback(cotangent);
        for (column, derivative) in by_theta.into_iter().enumerate() {
            derivatives[column * 3 * points + row] = derivative;
        }
    }
    Comparison {
        value: errors(&model, &theta, &seen)[0].x,
        derivatives,
        expected_value: reference(input, "objective")[0],
        expected: reference(input, "jacobian_column_major"),
    }
}
