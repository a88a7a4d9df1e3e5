//! Methods that return `&mut Self`, and chains of them.

use ad::check::{assert_forward, assert_rule};
use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Debug, Differentiable)]
struct Ball {
    height: f64,
    speed: f64,
}

#[differentiable]
impl Ball {
    fn scale(&mut self, by: f64) -> &mut Self {
        self.height *= by;
        self.speed *= by * by;
        self
    }

    fn shift(&mut self, by: f64) -> &mut Ball {
        self.height += by * self.speed;
        self
    }

    fn bounce(&mut self, floor: f64) -> &mut Self {
        if self.height > floor {
            return self;
        }
        self.height = 2.0 * floor - self.height;
        match self.speed > 0.0 {
            true => self.scale(0.9),
            false => {
                self.speed *= -0.8;
                self
            }
        }
    }

    fn step<'a>(&'a mut self, by: f64, floor: f64) -> &'a mut Self {
        let factor = 1.0 + by * self.height;
        self.shift(by).bounce(floor).scale(factor)
    }

    #[differentiable(checkpoint)]
    fn settle(&mut self, steps: usize) -> &mut Self {
        for _ in 0..steps {
            self.step(0.1, 0.2).shift(-0.05);
        }
        self
    }

    fn energy(&self) -> f64 {
        self.height * 9.81 + 0.5 * self.speed * self.speed
    }
}

#[differentiable]
trait Turn {
    fn turn(&mut self, angle: f64) -> &mut Self;

    fn turn_twice(&mut self, angle: f64) -> &mut Self {
        self.turn(angle).turn(0.5 * angle)
    }
}

#[differentiable]
impl Turn for Ball {
    fn turn(&mut self, angle: f64) -> &mut Self {
        let (sin, cos) = angle.sin_cos();
        let height = cos * self.height - sin * self.speed;
        self.speed = sin * self.height + cos * self.speed;
        self.height = height;
        self
    }
}

#[differentiable]
fn of_a_variable(x: f64, by: f64) -> f64 {
    let mut ball = Ball { height: x, speed: 1.5 * x };
    ball.scale(by).shift(2.0 * by).turn(x * by);
    ball.step(by, 3.0);
    ball.energy() * ball.height
}

/// Changes the index of the receiver.
#[differentiable]
fn advanced(k: &mut usize, value: f64) -> f64 {
    *k += 1;
    value * value
}

#[differentiable]
fn of_parts(x: f64, by: f64) -> f64 {
    let mut balls = vec![Ball { height: x, speed: by }; 3];
    let mut pair = (balls[1], x);
    for i in 0..3 {
        balls[(i + 1) % 3].scale(x).shift(by * i as f64);
        pair.0.shift(balls[i].height).turn_twice(by);
    }
    let mut k = 0;
    balls[k].scale(advanced(&mut k, by)).shift(advanced(&mut k, x));
    assert_eq!(k, 2);
    balls.last_mut().unwrap().turn(by).scale(pair.0.energy());
    balls.iter().map(|ball| ball.energy()).sum::<f64>() * pair.0.height
}

#[differentiable]
fn of_a_parameter(ball: &mut Ball, by: f64) -> f64 {
    let before = ball.height;
    ball.settle(3).bounce(10.0 * by).settle(1);
    before * ball.speed
}

#[differentiable]
fn of_any<T: Turn + Differentiable>(it: &mut T, by: f64) {
    if by > 0.5 {
        it.turn(by).turn_twice(by * by);
    }
}

#[differentiable]
fn lent(x: f64, by: f64) -> f64 {
    let mut ball = Ball { height: x, speed: -0.3 };
    let value = of_a_parameter(&mut ball, by);
    of_any(&mut ball, by);
    value + ball.height * ball.speed
}

/// Counts, without derivative.
#[derive(Clone, Copy, Default)]
struct Counter(usize);

impl Counter {
    fn add(&mut self, more: usize) -> &mut Self {
        self.0 += more;
        self
    }

    /// Another than the receiver.
    fn other<'a>(&mut self, others: &'a mut [Counter]) -> &'a mut Self {
        &mut others[self.0]
    }
}

#[differentiable]
fn counted(x: f64, by: f64) -> f64 {
    #[constant]
    let mut counter = Counter(1);
    #[constant]
    let mut others = [Counter(0); 2];
    counter.other(&mut others).add(3);
    counter.add(1).add(2);
    x.powi(counter.0 as i32) * by + others[1].0 as f64 * x
}

#[test]
fn chains_change_the_receiver() {
    for (x, by) in [(1.2, 0.7), (-0.4, 0.3)] {
        assert_rule(of_a_variable, of_a_variable::vjp, (x, by));
        assert_forward(of_a_variable, of_a_variable::jvp, (x, by));
        assert_rule(of_parts, of_parts::vjp, (x, by));
        assert_forward(of_parts, of_parts::jvp, (x, by));
        assert_rule(lent, lent::vjp, (x, by));
        assert_rule(counted, counted::vjp, (x, by));
        assert_forward(counted, counted::jvp, (x, by));
    }
    assert_forward(lent, lent::jvp, (0.4, 0.8));
    assert_rule(lent, lent::vjp, (0.4, 0.8));
}

#[test]
fn the_derivative_has_a_mark_in_its_place() {
    let mut ball = Ball { height: 2.0, speed: 3.0 };
    let (_, pullback) = ball.scale_vjp(0.5);
    assert_eq!((ball.height, ball.speed), (1.0, 0.75));
    let (by_ball, by_factor) = pullback((), BallTangent { height: 1.0, speed: 10.0 });
    assert_eq!((by_ball.height, by_ball.speed, by_factor), (0.5, 2.5, 2.0 + 30.0));
}
