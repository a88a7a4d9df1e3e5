//! What methods are called on: values without a name, and variables of which references live on.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
struct Tank {
    valve: Option<f64>,
    level: f64,
    inflows: Vec<f64>,
}

#[differentiable]
impl Tank {
    fn new(level: f64, inflows: &[f64]) -> Self {
        Self { valve: Some(level * inflows[0]), level, inflows: inflows.to_vec() }
    }

    fn pressure(&self) -> f64 {
        self.level * self.inflows[0]
    }

    fn through(&self, pipe: &f64) -> f64 {
        self.level * pipe
    }

    fn fill(&mut self, by: f64) -> f64 {
        self.level *= by;
        self.inflows[0] += by * self.level;
        self.level + self.inflows[0]
    }

    fn scaled(mut self, by: f64) -> Self {
        self.level *= by;
        self
    }

    fn emptied(self) -> f64 {
        self.level * self.inflows[1]
    }

    fn leak(&mut self) -> f64 {
        let mut lost = 0.0;
        match &self.valve {
            Some(width) => lost += self.pressure() * width,
            None => {}
        }
        self.level -= lost;
        lost
    }

    fn fuller<'a>(a: &'a Tank, b: &'a Tank) -> &'a Tank {
        if a.level > b.level { a } else { b }
    }
}

#[derive(Clone, Copy, Debug, Differentiable)]
enum Shape {
    Disc(f64),
    Box(f64, f64),
}

#[differentiable]
impl Shape {
    fn area(&self) -> f64 {
        match self {
            Shape::Disc(radius) => radius * radius,
            Shape::Box(width, height) => width * height,
        }
    }

    fn grow(&mut self, by: f64) -> f64 {
        match self {
            Shape::Disc(radius) => *radius *= by,
            Shape::Box(width, _) => *width += by,
        }
        self.area()
    }

    fn turned(self) -> Self {
        match self {
            Shape::Box(width, height) => Shape::Box(height, width),
            disc => disc,
        }
    }
}

#[differentiable]
fn named_by_patterns(x: f64, y: f64) -> f64 {
    let mut tank = Tank::new(x, &[x, y]);
    let mut sum = y;
    if let Some(width) = &tank.valve {
        sum += width * tank.pressure() + tank.pressure() * width;
        let pressure = tank.pressure();
        sum += width * pressure + tank.through(width);
    }
    match &tank.valve {
        Some(width) if tank.pressure() > *width => sum += width * 2.0,
        Some(width) => sum += width,
        None => {}
    }
    let Tank { level, inflows, .. } = &tank;
    sum += level * tank.pressure() * inflows[1];
    tank.level = sum.sin();
    sum + tank.level + tank.leak()
}

/// Of references that have ended, methods may change what they referred to.
#[differentiable]
fn ended(x: f64, y: f64) -> f64 {
    let mut tank = Tank::new(x, &[x, y]);
    let mut sum = y;
    for _ in 0..3 {
        if let Some(width) = &tank.valve {
            sum += tank.pressure() * width;
            sum += tank.fill(0.1 * sum);
        }
        sum += tank.fill(0.3);
    }
    match tank.valve {
        Some(width) => {
            sum += tank.fill(2.0);
            if width > 0.1 {
                sum *= 1.3;
            }
            sum += width * tank.fill(y);
        }
        None => {}
    }
    sum
}

#[differentiable]
fn assigned_later(x: f64, y: f64) -> f64 {
    let mut shape = Shape::Box(x, y);
    let mut sum = x;
    for _ in 0..2 {
        sum += match &shape {
            Shape::Disc(radius) => radius * shape.area(),
            Shape::Box(width, height) => width * shape.area() - height,
        };
        shape = Shape::Disc(sum);
    }
    sum + shape.area()
}

#[test]
fn references_live_beside_methods() {
    check!(named_by_patterns(x, y) at [0.7, 1.3], [-0.4, 0.6]);
    check!(ended(x, y) at [0.7, 1.3], [-0.4, 0.6]);
    check!(assigned_later(x, y) at [0.7, 1.3], [-0.4, 0.6]);
}

#[differentiable]
fn made(x: f64, y: f64) -> f64 {
    let tank = Tank::new(x, &[x, y]);
    let filled = tank.clone().fill(y) + Tank { level: y, ..tank.clone() }.fill(x);
    let emptied = tank.clone().emptied() * Tank::new(y, &[x, y]).scaled(y).scaled(2.0).emptied();
    let other = Tank::new(y, &[y, x]);
    let read = Tank::fuller(&tank, &other).pressure() * Tank::fuller(&tank, &other).through(&x);
    filled + emptied + read + tank.pressure()
}

#[differentiable]
fn made_of_copies(x: f64, y: f64) -> f64 {
    let mut sum = Shape::Disc(x).grow(y) + Shape::Box(x, y).turned().grow(x);
    for _ in 0..3 {
        sum += Shape::Box(0.1 * sum, y).grow(y) + Shape::Disc(0.1 * sum).turned().area();
    }
    sum + Shape::Box(x, sum).area().sin()
}

/// The argument changes a name of its own.
#[differentiable]
fn lent_beside_an_own_name(x: f64, y: f64) -> f64 {
    let mut tank = Tank::new(x, &[x, y]);
    let steps = [x, y, 0.5];
    let sum = |sum: &mut f64, step: &f64| {
        *sum += step;
        Some(*sum)
    };
    let filled = tank.fill(steps.iter().scan(y, sum).last().unwrap());
    let more = tank.fill({
        let mut all = 0.0;
        for step in &steps {
            all += step;
        }
        all
    });
    filled * more * tank.pressure()
}

#[test]
fn methods_change_what_has_no_name() {
    check!(made(x, y) at [0.7, 1.3], [-0.4, 0.6]);
    check!(made_of_copies(x, y) at [0.7, 1.3], [-0.4, 0.6]);
    check!(lent_beside_an_own_name(x, y) at [0.7, 1.3], [-0.4, 0.6]);
}
