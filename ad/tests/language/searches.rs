//! One item of an iterator: `nth`, `next`, `find`, `last`, `max_by`; traits with parameters; items that are matched on.

use ad::{Differentiable, differentiable};
use glam::{DVec2, dvec2};

use crate::oracle::check;

#[derive(Clone, Copy, Debug, Differentiable)]
struct P {
    a: f64,
    b: f64,
}

#[differentiable]
fn by_number(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y];
    let a = v.iter().nth(2).copied().unwrap();
    let b = v.iter().map(|t| t * t).nth(1).unwrap_or(0.0);
    let c = v.iter().last().unwrap();
    let d = v.iter().next().unwrap();
    a * b + c * d
}

#[differentiable]
fn by_predicate(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y];
    let a = v.iter().copied().find(|t| *t > 0.5).unwrap_or(y);
    let b = v.iter().find_map(|t| if *t < 0.5 { Some(t * t) } else { None }).unwrap_or(1.0);
    let c = v.iter().map(|t| t * x).next().unwrap();
    let d = v.iter().filter(|t| **t > 0.0).map(|t| 2.0 * t).nth(7).unwrap_or(x);
    a * b + c * d
}

#[differentiable]
fn of_structs(x: f64, y: f64) -> f64 {
    let v = vec![P { a: x, b: y }, P { a: y, b: x }];
    let p = v.iter().nth(1).unwrap();
    let q = v.iter().last().map_or(0.0, |q| q.a * q.b);
    if let Some(r) = v.iter().next() { p.a * r.b + q } else { x }
}

#[differentiable]
fn extremes(x: f64, y: f64) -> f64 {
    let v = vec![x, y, x * y, x - y];
    let w = [y, x, 0.3, x];
    let greatest = v.iter().max_by(|a, b| a.total_cmp(b)).unwrap();
    let least = v[1..].iter().min_by(|a, b| a.partial_cmp(b).unwrap());
    let at = v.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map(|(i, _)| i).unwrap();
    let (number, nearest) = v
        .iter()
        .enumerate()
        .min_by(|(_, a), (_, b)| (**a - y * y).abs().total_cmp(&(**b - y * y).abs()))
        .unwrap();
    let mut sum = w[at] * number as f64 * nearest;
    if let Some((a, b)) = v.iter().zip(&w).max_by(|p, q| (p.0 * p.1).total_cmp(&(q.0 * q.1))) {
        sum += a * b;
    }
    let by_key = v.iter().min_by_key(|a| (**a * 1000.0) as i64).copied().unwrap_or(x);
    let none = v[..0].iter().max_by(|a, b| a.total_cmp(b)).map_or(x, |a| *a);
    sum * greatest + least.copied().unwrap() * by_key + none
}

#[differentiable]
fn extreme_structs(x: f64, y: f64) -> f64 {
    let v = vec![P { a: x, b: y }, P { a: y, b: x }, P { a: x, b: x * y }];
    // Of equal ones the last is the greatest, the first the least.
    let p = v.iter().max_by(|p, q| p.a.total_cmp(&q.a)).unwrap();
    match v.iter().min_by(|p, q| p.a.total_cmp(&q.a)) {
        Some(q) => p.b * q.b * q.a,
        None => x,
    }
}

mod of_several_types {
    use super::*;

    #[differentiable]
    trait Ap<T> {
        fn ap(&self, t: T) -> f64;
        fn twice(&self, t: T, k: f64) -> f64
        where
            T: Clone,
        {
            self.ap(t.clone()) * k + self.ap(t)
        }
    }
    #[differentiable]
    impl Ap<f64> for P {
        fn ap(&self, t: f64) -> f64 {
            self.a * t + self.b
        }
    }
    #[differentiable]
    impl Ap<DVec2> for P {
        fn ap(&self, t: DVec2) -> f64 {
            self.a * t.x + self.b * t.y
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        P { a: x, b: y }.ap(x * y) * y + P { a: y, b: y }.ap(dvec2(x, y))
    }
}

mod of_a_type_parameter {
    use super::*;

    #[differentiable]
    trait Ap<T> {
        fn ap(&self, t: T) -> T;
    }
    #[differentiable]
    impl Ap<f64> for P {
        fn ap(&self, t: f64) -> f64 {
            self.a * t + self.b
        }
    }
    #[differentiable]
    fn g<A: Ap<f64> + Differentiable>(a: &A, x: f64) -> f64 {
        a.ap(x) * x
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let p = P { a: x, b: y };
        g(&p, x * y) * y
    }
}

mod matched_items {
    use super::*;

    #[derive(Clone, Copy, Debug, Differentiable)]
    enum E {
        A(f64),
        B { u: f64, v: f64 },
        N,
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let es = [E::A(x), E::B { u: y, v: x }, E::N];
        let mut s = 0.0;
        for e in &es {
            s += match e {
                E::A(a) => a * a,
                E::B { u, v } => u * v,
                E::N => 1.0,
            };
            if let E::A(a) = e {
                s *= a;
            }
        }
        for e in es.iter() {
            if let E::B { u, .. } = *e {
                s += u;
            }
        }
        s
    }
}

fn by_size(a: &f64, b: &f64) -> std::cmp::Ordering {
    a.abs().total_cmp(&b.abs())
}

/// Comparisons by the names of functions.
#[differentiable]
fn by_names(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y, -x];
    let greatest = v.iter().copied().max_by(f64::total_cmp).unwrap();
    let least = v.iter().map(|e| e * y).min_by(by_size).unwrap_or(x);
    greatest * greatest + least * x
}

#[test]
fn items_are_found() {
    check!(by_number(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(by_predicate(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(of_structs(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(by_names(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(extremes(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(extreme_structs(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use of_several_types::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use of_a_type_parameter::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use matched_items::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
}

#[derive(Clone, Differentiable)]
struct Planet {
    mass: f64,
    path: Vec<f64>,
    #[constant]
    id: usize,
}

#[differentiable]
fn planets(x: f64, y: f64) -> Vec<Planet> {
    let planet = |i: usize| Planet { mass: x * i as f64 + y, path: vec![x, y * i as f64], id: i };
    (0..4).map(planet).collect()
}

#[differentiable]
fn by_id(planets: &[Planet], id: usize) -> Option<f64> {
    let planet = planets.iter().find(|planet| planet.id == id)?;
    Some(planet.mass * planet.mass + planet.path.iter().sum::<f64>())
}

#[differentiable]
fn heavy(planets: &[Planet], weights: &[f64]) -> f64 {
    let first = match planets.iter().find(|planet| planet.mass > 1.0) {
        Some(planet) => planet.mass * planet.path[1],
        None => -1.0,
    };
    let Some((planet, weight)) =
        planets.iter().zip(weights).find(|(planet, weight)| planet.mass * **weight > 1.0)
    else {
        return first;
    };
    match planets.iter().enumerate().find(|(_, planet)| planet.mass > 1.5) {
        Some((i, other)) => first + planet.mass * weight * i as f64 * other.mass,
        None => first * weight,
    }
}

/// What is found among references is the element itself, which need not be `Copy`.
#[differentiable]
fn found(x: f64, y: f64) -> f64 {
    let planets = planets(x, y);
    let list = [x, y, x * y];
    let large = list.iter().find(|z| **z > 0.5).map(|z| z * y).unwrap_or(y);
    let second = planets.iter().find(|planet| planet.id == 1).unwrap().mass;
    let third = by_id(&planets, 3).unwrap_or(0.5) * by_id(&planets, 9).unwrap_or(x);
    large * second + third + heavy(&planets, &list)
}

/// Filters before a search leave elements what they are.
#[differentiable]
fn of_some(x: f64, y: f64) -> f64 {
    let planets = planets(x, y);
    let lightest = planets
        .iter()
        .filter(|planet| planet.id % 2 == 1)
        .min_by(|a, b| a.mass.total_cmp(&b.mass))
        .unwrap();
    let farthest = planets
        .iter()
        .filter(|planet| planet.mass > y)
        .filter(|planet| planet.id != 3)
        .max_by(|a, b| a.path[1].total_cmp(&b.path[1]));
    let heavy = planets
        .iter()
        .enumerate()
        .filter(|(i, planet)| *i > 0 && planet.mass < 1.9)
        .find(|(_, planet)| planet.path[1] > y);
    let none = planets.iter().filter(|planet| planet.id > 9).max_by_key(|planet| planet.id);
    let sum = lightest.mass * lightest.path[1] + none.map(|planet| planet.mass).unwrap_or(y);
    let far = farthest.map(|planet| planet.mass * y).unwrap_or(0.5);
    match heavy {
        Some((i, planet)) => sum + far * i as f64 * planet.mass,
        None => sum - far,
    }
}

#[test]
fn elements_are_found() {
    check!(of_some(x, y) at [0.7, 0.4], [0.9, 0.2], [0.2, 0.13], [1.3, 0.77]);
    check!(found(x, y) at [0.7, 0.4], [0.9, 0.2], [0.2, 0.1], [1.7, 0.6]);
}
