//! Values that are made where they are lent to be changed, and changes in what is only tested.

use ad::differentiable;

use crate::oracle::check;

#[differentiable]
fn doubled(values: &mut [f64]) -> f64 {
    values[0] *= 2.0;
    values[0] * values[1]
}

#[differentiable]
fn lent(x: f64, y: f64) -> f64 {
    doubled(&mut [x, y]) + doubled(&mut vec![x * y; 2]) + doubled(&mut [x; 2])
}

#[differentiable]
fn appended(x: f64, y: f64) -> f64 {
    let mut values = vec![x];
    let others = vec![x, y];
    values.append(&mut others.clone());
    values.append(&mut values.clone());
    values.append(&mut vec![y * y; 2]);
    values[2] * values[4] * values[7] + others[1]
}

#[differentiable]
fn taken(x: f64, y: f64) -> f64 {
    let mut option = Some(x);
    let mut count = 0;
    while option.take().is_some() {
        count += 1;
    }
    if option.replace(x * y).is_none() { count as f64 * option.unwrap() } else { y }
}

#[differentiable]
fn drained(x: f64, y: f64) -> f64 {
    let mut values = vec![x, y, x * y, x + y, x - y, y * y, x * x];
    let count = values.drain(..1).count();
    let any = values.drain(..1).any(|value| value > 0.0);
    let all = values.drain(..1).all(|value| value > 0.0);
    let position = values.drain(..2).map(|value| value * y).position(|value| value > 0.2);
    let weight = if any { 2.0 } else { 3.0 } + if all { 5.0 } else { 7.0 };
    if values.drain(..1).filter(|value| *value > 1.0).count() > 0 {
        return values[0] * weight;
    }
    values[0] * weight * (count + position.map_or(3, |position| position)) as f64
}

#[differentiable]
fn tested(x: f64, y: f64) -> f64 {
    f64::from(u8::from(x > 0.0)) * y * x + f64::from(i32::from(y > 1.0)) * x
}

#[test]
fn changes() {
    check!(lent(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(appended(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(taken(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(drained(x, y) at [0.7, 1.3], [-1.1, 0.4], [-1.1, -0.4], [0.7, -0.3]);
    check!(tested(x, y) at [0.7, 1.3], [-1.1, 0.4], [-1.1, 1.2]);
}
