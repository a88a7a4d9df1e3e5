//! Random programs, written by `cargo run -p ad --example random_programs -- 7 40`.

use ad::{Real, differentiable};

use crate::program::{Program, program};
use crate::types::{Pair, Shape, mixed, root, roots, shape, shifted};

/// Every program.
pub const PROGRAMS: &[Program] = &[
    program!(program_0, program_0_of),
    program!(program_1, program_1_of),
    program!(program_2, program_2_of),
    program!(program_3, program_3_of),
    program!(program_4, program_4_of),
    program!(program_5, program_5_of),
    program!(program_6, program_6_of),
    program!(program_7, program_7_of),
    program!(program_8, program_8_of),
    program!(program_9, program_9_of),
    program!(program_10, program_10_of),
    program!(program_11, program_11_of),
    program!(program_12, program_12_of),
    program!(program_13, program_13_of),
    program!(program_14, program_14_of),
    program!(program_15, program_15_of),
    program!(program_16, program_16_of),
    program!(program_17, program_17_of),
    program!(program_18, program_18_of),
    program!(program_19, program_19_of),
    program!(program_20, program_20_of),
    program!(program_21, program_21_of),
    program!(program_22, program_22_of),
    program!(program_23, program_23_of),
    program!(program_24, program_24_of),
    program!(program_25, program_25_of),
    program!(program_26, program_26_of),
    program!(program_27, program_27_of),
    program!(program_28, program_28_of),
    program!(program_29, program_29_of),
    program!(program_30, program_30_of),
    program!(program_31, program_31_of),
    program!(program_32, program_32_of),
    program!(program_33, program_33_of),
    program!(program_34, program_34_of),
    program!(program_35, program_35_of),
    program!(program_36, program_36_of),
    program!(program_37, program_37_of),
    program!(program_38, program_38_of),
    program!(program_39, program_39_of),
];

#[differentiable]
fn program_0(x: f64, y: f64) -> f64 {
    let mut b = ((x / (1.5 + x * x)) + 0.125).tanh();
    let r1 = [(-0.625_f64 * 0.75).sin(); 4];
    let mut r2 = [((y * -0.875_f64).max(0.875_f64) + 0.125).tanh(); 2];
    let mut p3 =
        Pair { a: ((b / (1.5 + y * y)) * 0.75).sin(), b: ((x * -0.125_f64).abs() + 0.125).tanh() };
    let a: f64 = r2.iter().map(|v| v * (p3.b + 0.125).tanh()).sum();
    'l4: for i5 in (0..4_usize).step_by(2) {
        if y > (b * 0.125_f64).cos() {
            let e: f64 = r1.iter().map(|v| v * (-1.125_f64 + 0.125).tanh()).sum();
            'l6: for i7 in (2..2_usize).rev() {
                p3.turn(((r1[(i5 * i5 + 1) % 4] * -0.375_f64) * 0.75).sin());
                p3 = p3.tamed();
            }
            let e = match roots(
                (r2[(i5 * i5 + 1) % 2] - ((i5 as f64) * 0.25)),
                (x * -1.125_f64).max(x),
            ) {
                Ok(v) => ((x * 0.375_f64).max(p3.b) - -0.375_f64).tanh(),
                Err(true) => y,
                Err(_) => (a * a + 0.25).sqrt(),
            };
        }
        'l8: for i9 in (1..1_usize).step_by(2) {
            b += (((x * 0.875_f64).max(0.125_f64) * -0.875_f64).cos() + 0.125).tanh();
        }
    }
    let mut p10 = Pair { a: ((-1.125_f64 * a) * 0.75).sin(), b: ((-(r1[0])) * 0.75).sin() };
    p10 = -(p10 - p3).tamed();
    p10 = p10.tamed();
    'l11: for i12 in (2..4_usize).rev() {
        let mut a = ((p3.b + ((i12 as f64) * 0.25)) + 0.125).tanh();
    }
    ((-(y)) / (1.5 + (a * a) * (a * a))) + a + b + y + x
}

fn program_0_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh();
    let r1 = [(S::from_f64(-0.625_f64) * S::from_f64(0.75)).sin(); 4];
    let mut r2 = [((y * S::from_f64(-0.875_f64)).max(S::from_f64(0.875_f64)) + S::from_f64(0.125))
        .tanh(); 2];
    let mut p3 = Pair {
        a: ((b / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
        b: ((x * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    let a = r2.iter().fold(S::from_f64(-0.0), |s, v| s + *v * (p3.b + S::from_f64(0.125)).tanh());
    'l4: for i5 in (0..4_usize).step_by(2) {
        if y.cmpgt((b * S::from_f64(0.125_f64)).cos()) {
            let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v * (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh()
            });
            'l6: for i7 in (2..2_usize).rev() {
                p3.turn(
                    ((r1[(i5 * i5 + 1) % 4] * S::from_f64(-0.375_f64)) * S::from_f64(0.75)).sin(),
                );
                p3 = p3.tamed();
            }
            let e = match roots(
                (r2[(i5 * i5 + 1) % 2] - (S::from_f64(i5 as f64) * S::from_f64(0.25))),
                (x * S::from_f64(-1.125_f64)).max(x),
            ) {
                Ok(v) => ((x * S::from_f64(0.375_f64)).max(p3.b) - S::from_f64(-0.375_f64)).tanh(),
                Err(true) => y,
                Err(_) => (a * a + S::from_f64(0.25)).sqrt(),
            };
        }
        'l8: for i9 in (1..1_usize).step_by(2) {
            b = b
                + (((x * S::from_f64(0.875_f64)).max(S::from_f64(0.125_f64))
                    * S::from_f64(-0.875_f64))
                .cos()
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    let mut p10 = Pair {
        a: ((S::from_f64(-1.125_f64) * a) * S::from_f64(0.75)).sin(),
        b: ((-(r1[0])) * S::from_f64(0.75)).sin(),
    };
    p10 = -(p10 - p3).tamed();
    p10 = p10.tamed();
    'l11: for i12 in (2..4_usize).rev() {
        let mut a =
            ((p3.b + (S::from_f64(i12 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh();
    }
    ((-(y)) / (S::from_f64(1.5) + (a * a) * (a * a))) + a + b + y + x
}

#[differentiable]
fn program_1(x: f64, y: f64) -> f64 {
    let mut d = ((y * 0.125_f64).abs() + 0.125).tanh();
    let r1 = [
        ((y + d) * 0.75).sin(),
        ((x * -0.125_f64).abs() + 0.125).tanh(),
        ((x * -0.625_f64) + 0.125).tanh(),
    ];
    let f: f64 = r1.iter().map(|v| v * ((r1[1] * 0.625_f64) + 0.125).tanh()).sum();
    let b = (d - (r1[1] * f));
    let a = if let Some(v) = root((0.375_f64 * -0.375_f64).cos()) {
        (y + (d - r1[0]))
    } else {
        (b * b + 0.25).sqrt()
    };
    'l2: for i3 in 0..4_usize {
        let b: f64 = r1.iter().map(|v| v * ((f * a) + 0.125).tanh()).sum();
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 5 {
        n5 += 1;
        d = (((r1[(n5 * n5 + 1) % 3] * r1[(n5 + 0) % 3]) * -1.125_f64).cos() * 0.75).sin();
        if n5 % 2 == 0 {
            'l6: for i7 in (2..4_usize).rev() {
                let d = program_0(
                    ((y * x) + 0.125).tanh(),
                    ((r1[i7 % 3] / (1.5 + r1[n5 % 3] * r1[n5 % 3])) + 0.125).tanh(),
                )
                .tanh();
            }
            let d = if n5 % 3 == 1 { (((n5 as f64) * 0.25) + -0.875_f64).sin() } else { 0.875_f64 };
        } else {
            let b = if (-(f)) < (b - d) {
                ((y * y + 0.25).sqrt() * (y * y + 0.25).sqrt() + 0.25).sqrt()
            } else {
                (f - 0.375_f64).tanh()
            };
            let c = match shape(
                ((b + -0.125_f64) * 0.75).sin(),
                ((f + 0.875_f64).sin() + 0.125).tanh(),
            ) {
                Shape::Point => (((n5 as f64) * 0.25) - -1.125_f64).tanh(),
                Shape::Disc(v) => (y - -0.875_f64).tanh(),
                Shape::Box { w: v, h } => ((r1[2] + r1[(n5 * n5 + 1) % 3]) * (-0.375_f64 * v)),
            };
        }
        d = (((((n5 as f64) * 0.25) * y) * (r1[n5 % 3] - 0.375_f64).tanh()) + 0.125).tanh();
    }
    r1[0] + a + b + f + d + y + x
}

fn program_1_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    let r1 = [
        ((y + d) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh(),
    ];
    let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[1] * S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh()
    });
    let b = (d - (r1[1] * f));
    let a = if let Some(v) = root((S::from_f64(0.375_f64) * S::from_f64(-0.375_f64)).cos()) {
        (y + (d - r1[0]))
    } else {
        (b * b + S::from_f64(0.25)).sqrt()
    };
    'l2: for i3 in 0..4_usize {
        let b = r1
            .iter()
            .fold(S::from_f64(-0.0), |s, v| s + *v * ((f * a) + S::from_f64(0.125)).tanh());
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 5 {
        n5 += 1;
        d = (((r1[(n5 * n5 + 1) % 3] * r1[(n5 + 0) % 3]) * S::from_f64(-1.125_f64)).cos()
            * S::from_f64(0.75))
        .sin();
        if n5 % 2 == 0 {
            'l6: for i7 in (2..4_usize).rev() {
                let d = program_0_of(
                    ((y * x) + S::from_f64(0.125)).tanh(),
                    ((r1[i7 % 3] / (S::from_f64(1.5) + r1[n5 % 3] * r1[n5 % 3]))
                        + S::from_f64(0.125))
                    .tanh(),
                )
                .tanh();
            }
            let d = if n5 % 3 == 1 {
                ((S::from_f64(n5 as f64) * S::from_f64(0.25)) + S::from_f64(-0.875_f64)).sin()
            } else {
                S::from_f64(0.875_f64)
            };
        } else {
            let b = if (-(f)).cmplt((b - d)) {
                ((y * y + S::from_f64(0.25)).sqrt() * (y * y + S::from_f64(0.25)).sqrt()
                    + S::from_f64(0.25))
                .sqrt()
            } else {
                (f - S::from_f64(0.375_f64)).tanh()
            };
            let c = match shape(
                ((b + S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
                ((f + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
            ) {
                Shape::Point => {
                    ((S::from_f64(n5 as f64) * S::from_f64(0.25)) - S::from_f64(-1.125_f64)).tanh()
                }
                Shape::Disc(v) => (y - S::from_f64(-0.875_f64)).tanh(),
                Shape::Box { w: v, h } => {
                    ((r1[2] + r1[(n5 * n5 + 1) % 3]) * (S::from_f64(-0.375_f64) * v))
                }
            };
        }
        d = ((((S::from_f64(n5 as f64) * S::from_f64(0.25)) * y)
            * (r1[n5 % 3] - S::from_f64(0.375_f64)).tanh())
            + S::from_f64(0.125))
        .tanh();
    }
    r1[0] + a + b + f + d + y + x
}

#[differentiable]
fn program_2(x: f64, y: f64) -> f64 {
    let mut e = (y * 0.75).sin();
    let mut r1 = [
        ((x - -1.125_f64).tanh() * 0.75).sin(),
        ((e - y) * 0.75).sin(),
        ((e - -1.125_f64).tanh() * 0.75).sin(),
    ];
    e = (r1[1] * 0.75).sin();
    #[differentiable(checkpoint)]
    'l2: for i3 in (2..0_usize).step_by(2) {
        let d = match root((x + x)) {
            Some(v) => ((r1[2] * -0.375_f64).abs() * 0.875_f64).abs(),
            None => (r1[(i3 + 2) % 3] + -1.125_f64).sin(),
        };
        if (e * e + 0.25).sqrt() >= (r1[(i3 + 2) % 3] - 0.375_f64).tanh() {
            e = (((d * -1.125_f64).cos() * (x + r1[1])) * 0.75).sin();
            let f = if (((i3 as f64) * 0.25) + r1[i3 % 3])
                >= (((i3 as f64) * 0.25) + 0.125_f64).sin()
            {
                ((d * -1.125_f64).max(((i3 as f64) * 0.25)) + (-0.125_f64 - 0.625_f64).tanh())
            } else {
                (-((0.375_f64 - 0.625_f64).tanh()))
            };
        }
        let c = mixed(&r1[1..]).sin();
    }
    let e = match roots((e + y), (x + r1[0])) {
        Ok(v) => ((0.875_f64 + -0.125_f64).sin() + (-0.625_f64 + r1[2])),
        Err(true) => y,
        Err(_) => (e * x),
    };
    r1[0] += (e + 0.125).tanh();
    let mut r4 = [(e * 0.75).sin(), ((e * x) + 0.125).tanh(), ((-(x)) * 0.75).sin()];
    'l5: for i6 in (2..1_usize).step_by(2) {
        let mut f = ((e * 0.625_f64).abs() + 0.125).tanh();
        let c: f64 = r4.iter().map(|v| v * ((-(f)) * 0.75).sin()).sum();
        let mut n8 = 0_usize;
        'l7: while n8 < 3 {
            n8 += 1;
            let (a, mut b) = (((e - -0.125_f64).tanh() * 0.75).sin(), (r1[(i6 * i6 + 1) % 3] * x));
            let d = r4[0];
            let mut u9: Vec<_> = r1.iter().map(|v| *v * r4[n8 % 3]).collect();
            u9.push(((-0.625_f64 + 0.375_f64).sin() * 0.75).sin());
            u9[0] = u9[1] * u9[u9.len() - 1];
            let a = (mixed(&u9) + u9[0]).tanh();
        }
    }
    (x + y) + e + y + x
}

fn program_2_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (y * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((e - y) * S::from_f64(0.75)).sin(),
        ((e - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(),
    ];
    e = (r1[1] * S::from_f64(0.75)).sin();

    'l2: for i3 in (2..0_usize).step_by(2) {
        let d = match root((x + x)) {
            Some(v) => ((r1[2] * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.875_f64)).abs(),
            None => (r1[(i3 + 2) % 3] + S::from_f64(-1.125_f64)).sin(),
        };
        if (e * e + S::from_f64(0.25))
            .sqrt()
            .cmpge((r1[(i3 + 2) % 3] - S::from_f64(0.375_f64)).tanh())
        {
            e = (((d * S::from_f64(-1.125_f64)).cos() * (x + r1[1])) * S::from_f64(0.75)).sin();
            let f = if ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + r1[i3 % 3]).cmpge(
                ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(0.125_f64)).sin(),
            ) {
                ((d * S::from_f64(-1.125_f64)).max((S::from_f64(i3 as f64) * S::from_f64(0.25)))
                    + (S::from_f64(-0.125_f64) - S::from_f64(0.625_f64)).tanh())
            } else {
                (-((S::from_f64(0.375_f64) - S::from_f64(0.625_f64)).tanh()))
            };
        }
        let c = mixed(&r1[1..]).sin();
    }
    let e = match roots((e + y), (x + r1[0])) {
        Ok(v) => {
            ((S::from_f64(0.875_f64) + S::from_f64(-0.125_f64)).sin()
                + (S::from_f64(-0.625_f64) + r1[2]))
        }
        Err(true) => y,
        Err(_) => (e * x),
    };
    r1[0] = r1[0] + (e + S::from_f64(0.125)).tanh();
    let mut r4 = [
        (e * S::from_f64(0.75)).sin(),
        ((e * x) + S::from_f64(0.125)).tanh(),
        ((-(x)) * S::from_f64(0.75)).sin(),
    ];
    'l5: for i6 in (2..1_usize).step_by(2) {
        let mut f = ((e * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh();
        let c =
            r4.iter().fold(S::from_f64(-0.0), |s, v| s + *v * ((-(f)) * S::from_f64(0.75)).sin());
        let mut n8 = 0_usize;
        'l7: while n8 < 3 {
            n8 += 1;
            let (a, mut b) = (
                ((e - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
                (r1[(i6 * i6 + 1) % 3] * x),
            );
            let d = r4[0];
            let mut u9: Vec<_> = r1.iter().map(|v| *v * r4[n8 % 3]).collect();
            u9.push(
                ((S::from_f64(-0.625_f64) + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75))
                    .sin(),
            );
            u9[0] = u9[1] * u9[u9.len() - 1];
            let a = (mixed(&u9) + u9[0]).tanh();
        }
    }
    (x + y) + e + y + x
}

#[differentiable]
fn program_3(x: f64, y: f64) -> f64 {
    let mut c = (x * 0.75).sin();
    let mut r1 = [(y * 0.75).sin(), ((0.875_f64 * 0.875_f64).abs() * 0.75).sin()];
    let a = match roots((c * c + 0.25).sqrt(), (x / (1.5 + r1[0] * r1[0]))) {
        Ok(v) => ((v * -0.375_f64).abs() * (r1[1] + c)),
        Err(true) => y,
        Err(_) => (r1[1] * r1[1] + 0.25).sqrt(),
    };
    for v in r1.iter() {
        c = c * ((r1[0] * a) * 0.75).sin() + *v * ((r1[0] * a) * 0.75).sin();
    }
    c -= (((a * -0.875_f64).cos() * -0.875_f64).abs() * 0.75).sin();
    let mut p2 = Pair { a: (y + 0.125).tanh(), b: ((r1[1] - -0.375_f64).tanh() + 0.125).tanh() };
    let g3 = |t: f64| r1[0] * t;
    let a = (g3((x + a)) + g3((x / (1.5 + c * c)))).sin();
    for v in r1.iter() {
        c = c * ((c - a) + 0.125).tanh() + *v * ((c - a) + 0.125).tanh();
    }
    r1[1] *= (((c + -0.625_f64).sin() * -1.125_f64).abs() + 0.125).tanh();
    c *= (r1[1] + 0.125).tanh();
    let e =
        program_1(((a + r1[0]) * 0.75).sin(), ((0.625_f64 / (1.5 + a * a)) + 0.125).tanh()).tanh();
    let mut f = ((r1[1] * 0.875_f64).abs() + 0.125).tanh();
    r1[1] = (((r1[0] + 0.875_f64).sin() - 0.875_f64).tanh() + 0.125).tanh();
    p2 += Pair { a: (r1[1] * 0.75).sin(), b: ((-(c)) + 0.125).tanh() };
    p2 = p2.tamed();
    r1[0] = (((r1[0] / (1.5 + p2.a * p2.a)) / (1.5 + (c * r1[0]) * (c * r1[0]))) * 0.75).sin();
    p2 = -(p2 - p2).tamed();
    p2 = p2.tamed();
    ((a + -0.125_f64).sin() * x) + f + e + a + c + y + x
}

fn program_3_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (x * S::from_f64(0.75)).sin();
    let mut r1 = [
        (y * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.875_f64) * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    let a =
        match roots((c * c + S::from_f64(0.25)).sqrt(), (x / (S::from_f64(1.5) + r1[0] * r1[0]))) {
            Ok(v) => ((v * S::from_f64(-0.375_f64)).abs() * (r1[1] + c)),
            Err(true) => y,
            Err(_) => (r1[1] * r1[1] + S::from_f64(0.25)).sqrt(),
        };
    for v in r1.iter() {
        c = c * ((r1[0] * a) * S::from_f64(0.75)).sin()
            + *v * ((r1[0] * a) * S::from_f64(0.75)).sin();
    }
    c = c
        - (((a * S::from_f64(-0.875_f64)).cos() * S::from_f64(-0.875_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    let mut p2 = Pair {
        a: (y + S::from_f64(0.125)).tanh(),
        b: ((r1[1] - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    let g3 = |t: S| r1[0] * t;
    let a = (g3((x + a)) + g3((x / (S::from_f64(1.5) + c * c)))).sin();
    for v in r1.iter() {
        c = c * ((c - a) + S::from_f64(0.125)).tanh() + *v * ((c - a) + S::from_f64(0.125)).tanh();
    }
    r1[1] = r1[1]
        * (((c + S::from_f64(-0.625_f64)).sin() * S::from_f64(-1.125_f64)).abs()
            + S::from_f64(0.125))
        .tanh();
    c = c * (r1[1] + S::from_f64(0.125)).tanh();
    let e = program_1_of(
        ((a + r1[0]) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.625_f64) / (S::from_f64(1.5) + a * a)) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut f = ((r1[1] * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh();
    r1[1] = (((r1[0] + S::from_f64(0.875_f64)).sin() - S::from_f64(0.875_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    p2 += Pair { a: (r1[1] * S::from_f64(0.75)).sin(), b: ((-(c)) + S::from_f64(0.125)).tanh() };
    p2 = p2.tamed();
    r1[0] = (((r1[0] / (S::from_f64(1.5) + p2.a * p2.a))
        / (S::from_f64(1.5) + (c * r1[0]) * (c * r1[0])))
        * S::from_f64(0.75))
    .sin();
    p2 = -(p2 - p2).tamed();
    p2 = p2.tamed();
    ((a + S::from_f64(-0.125_f64)).sin() * x) + f + e + a + c + y + x
}

#[differentiable]
fn program_4(x: f64, y: f64) -> f64 {
    let mut e = ((x * y) + 0.125).tanh();
    let mut r1 = [((y * y) * 0.75).sin(); 5];
    let c: f64 = r1.iter().map(|v| v * ((x * r1[0]) + 0.125).tanh()).sum();
    'l2: for i3 in (2..5_usize).step_by(2) {
        let mut r4 = [((y * -1.125_f64).abs() + 0.125).tanh(); 5];
    }
    let by5 = ((e - e) * 0.75).sin();
    let e = shifted(&mut r1[3..], by5);
    let f = program_1((y + 0.125).tanh(), ((r1[4] * 0.625_f64).max(r1[2]) * 0.75).sin()).tanh();
    'l6: for i7 in (2..0_usize).step_by(2) {
        let b = y;
        #[differentiable(checkpoint)]
        'l8: for i9 in i7..=3_usize {
            if (r1[(i9 * i9 + 1) % 5] * -0.125_f64).cos() < (e * 0.375_f64).cos() {
                let d = root((r1[0] + ((i9 as f64) * 0.25))).map_or((x + e), |v| {
                    ((f + ((i7 as f64) * 0.25)) + (r1[(i7 * i7 + 1) % 5] + 0.625_f64).sin())
                });
            }
            if (((i9 as f64) * 0.25) * r1[3]) > (((i9 as f64) * 0.25) * r1[(i7 + 3) % 5]) {
                break;
            }
        }
    }
    let mut r10 = [(y * 0.75).sin(); 4];
    'l11: for i12 in (2..1_usize).step_by(2) {
        let f = ((r10[(i12 * i12 + 1) % 4] + 0.625_f64).sin() + (y + -0.875_f64));
        let by13 = ((f / (1.5 + -0.375_f64 * -0.375_f64)) + 0.125).tanh();
        for v in r1.iter_mut() {
            *v = (*v * by13).sin();
        }
    }
    ((r10[1] + c) * -0.125_f64).max(f) + f + e + c + y + x
}

fn program_4_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y * y) * S::from_f64(0.75)).sin(); 5];
    let c = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * ((x * r1[0]) + S::from_f64(0.125)).tanh());
    'l2: for i3 in (2..5_usize).step_by(2) {
        let mut r4 = [((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(); 5];
    }
    let by5 = ((e - e) * S::from_f64(0.75)).sin();
    let e = shifted(&mut r1[3..], by5);
    let f = program_1_of(
        (y + S::from_f64(0.125)).tanh(),
        ((r1[4] * S::from_f64(0.625_f64)).max(r1[2]) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    'l6: for i7 in (2..0_usize).step_by(2) {
        let b = y;

        'l8: for i9 in i7..=3_usize {
            if (r1[(i9 * i9 + 1) % 5] * S::from_f64(-0.125_f64))
                .cos()
                .cmplt((e * S::from_f64(0.375_f64)).cos())
            {
                let d = root((r1[0] + (S::from_f64(i9 as f64) * S::from_f64(0.25)))).map_or(
                    (x + e),
                    |v| {
                        ((f + (S::from_f64(i7 as f64) * S::from_f64(0.25)))
                            + (r1[(i7 * i7 + 1) % 5] + S::from_f64(0.625_f64)).sin())
                    },
                );
            }
            if ((S::from_f64(i9 as f64) * S::from_f64(0.25)) * r1[3])
                .cmpgt(((S::from_f64(i9 as f64) * S::from_f64(0.25)) * r1[(i7 + 3) % 5]))
            {
                break;
            }
        }
    }
    let mut r10 = [(y * S::from_f64(0.75)).sin(); 4];
    'l11: for i12 in (2..1_usize).step_by(2) {
        let f = ((r10[(i12 * i12 + 1) % 4] + S::from_f64(0.625_f64)).sin()
            + (y + S::from_f64(-0.875_f64)));
        let by13 = ((f / (S::from_f64(1.5) + S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64)))
            + S::from_f64(0.125))
        .tanh();
        for v in r1.iter_mut() {
            *v = (*v * by13).sin();
        }
    }
    ((r10[1] + c) * S::from_f64(-0.125_f64)).max(f) + f + e + c + y + x
}

#[differentiable]
fn program_5(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.875_f64).max(y) + 0.125).tanh();
    let mut r1 = [
        ((x * -0.375_f64).max(x) * 0.75).sin(),
        ((y * c) + 0.125).tanh(),
        ((x + -0.375_f64) * 0.75).sin(),
        (c + 0.125).tanh(),
    ];
    let a = ((r1[3] * r1[1]) * r1[3]);
    r1[0] = (((r1[2] - r1[0]) * 0.375_f64).cos() + 0.125).tanh();
    let c = program_2(
        ((r1[1] * 0.125_f64).max(a) + 0.125).tanh(),
        ((-0.625_f64 + -0.625_f64).sin() + 0.125).tanh(),
    )
    .tanh();
    let d = match shape(((y * y + 0.25).sqrt() + 0.125).tanh(), ((x * c) + 0.125).tanh()) {
        Shape::Point => y,
        Shape::Disc(v) => ((r1[3] * v) + (v * -0.125_f64).max(c)),
        Shape::Box { w: v, h } => (-((r1[3] + 0.875_f64).sin())),
    };
    #[differentiable(checkpoint)]
    'l2: for i3 in 2..=5_usize {
        let mut p4 = Pair { a: (d + 0.125).tanh(), b: (a * 0.75).sin() };
        let mut u5: Vec<_> = r1.iter().map(|v| *v * a).collect();
        u5.push(((r1[(i3 * i3 + 1) % 4] * 0.125_f64).cos() * 0.75).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let f = (mixed(&u5) + u5[0]).tanh();
    }
    let d = mixed(&r1[..2]).sin();
    let b = ((r1[0] * -0.375_f64) - -0.125_f64).tanh();
    'l6: for i7 in 0..=0_usize {
        let e = if (r1[(i7 + 2) % 4] - -0.375_f64).tanh() <= (r1[i7 % 4] + -0.375_f64) {
            (b * b + 0.25).sqrt()
        } else {
            ((((i7 as f64) * 0.25) * ((i7 as f64) * 0.25) + 0.25).sqrt()
                / (1.5 + (x * x + 0.25).sqrt() * (x * x + 0.25).sqrt()))
        };
        'l8: for i9 in (1..5_usize).step_by(2) {
            let mut b = ((-(r1[(i7 * i7 + 1) % 4])) + 0.125).tanh();
        }
        r1[1] *= ((e + 0.625_f64).sin() * 0.75).sin();
    }
    (r1[1] - -0.625_f64).tanh() + b + d + c + a + y + x
}

fn program_5_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.875_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x * S::from_f64(-0.375_f64)).max(x) * S::from_f64(0.75)).sin(),
        ((y * c) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-0.375_f64)) * S::from_f64(0.75)).sin(),
        (c + S::from_f64(0.125)).tanh(),
    ];
    let a = ((r1[3] * r1[1]) * r1[3]);
    r1[0] = (((r1[2] - r1[0]) * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    let c = program_2_of(
        ((r1[1] * S::from_f64(0.125_f64)).max(a) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.625_f64) + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let d = match shape(
        ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * c) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => y,
        Shape::Disc(v) => ((r1[3] * v) + (v * S::from_f64(-0.125_f64)).max(c)),
        Shape::Box { w: v, h } => (-((r1[3] + S::from_f64(0.875_f64)).sin())),
    };

    'l2: for i3 in 2..=5_usize {
        let mut p4 = Pair { a: (d + S::from_f64(0.125)).tanh(), b: (a * S::from_f64(0.75)).sin() };
        let mut u5: Vec<_> = r1.iter().map(|v| *v * a).collect();
        u5.push(((r1[(i3 * i3 + 1) % 4] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let f = (mixed(&u5) + u5[0]).tanh();
    }
    let d = mixed(&r1[..2]).sin();
    let b = ((r1[0] * S::from_f64(-0.375_f64)) - S::from_f64(-0.125_f64)).tanh();
    'l6: for i7 in 0..=0_usize {
        let e = if (r1[(i7 + 2) % 4] - S::from_f64(-0.375_f64))
            .tanh()
            .cmple((r1[i7 % 4] + S::from_f64(-0.375_f64)))
        {
            (b * b + S::from_f64(0.25)).sqrt()
        } else {
            (((S::from_f64(i7 as f64) * S::from_f64(0.25))
                * (S::from_f64(i7 as f64) * S::from_f64(0.25))
                + S::from_f64(0.25))
            .sqrt()
                / (S::from_f64(1.5)
                    + (x * x + S::from_f64(0.25)).sqrt() * (x * x + S::from_f64(0.25)).sqrt()))
        };
        'l8: for i9 in (1..5_usize).step_by(2) {
            let mut b = ((-(r1[(i7 * i7 + 1) % 4])) + S::from_f64(0.125)).tanh();
        }
        r1[1] = r1[1] * ((e + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin();
    }
    (r1[1] - S::from_f64(-0.625_f64)).tanh() + b + d + c + a + y + x
}

#[differentiable]
fn program_6(x: f64, y: f64) -> f64 {
    let mut e = ((y / (1.5 + y * y)) * 0.75).sin();
    let mut r1 = [((e * y) + 0.125).tanh(); 2];
    let mut u2 = r1.to_vec();
    u2.push(((y * -1.125_f64).max(r1[1]) * 0.75).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    e += ((-0.125_f64 * r1[1]) + 0.125).tanh();
    let (a, mut b) = (((r1[1] * 0.125_f64).abs() + 0.125).tanh(), (e * r1[1]));
    b = ((-(x + b)) + 0.125).tanh();
    let mut p3 = Pair { a: ((y / (1.5 + a * a)) + 0.125).tanh(), b: ((e + x) * 0.75).sin() };
    if (a + -1.125_f64).sin() <= (r1[0] * p3.a) {
        e = (((f / (1.5 + r1[0] * r1[0])) - (a + -0.375_f64).sin()) * 0.75).sin();
        let g4 = |t: f64| ((e * 0.625_f64).cos() + (x * -0.125_f64).max(r1[0])) * t;
        let a = (g4((y * 0.375_f64).cos()) + g4((r1[1] + -0.875_f64).sin())).sin();
    }
    'l5: for i6 in (2..1_usize).step_by(2) {
        if i6 % 3 == 2 {
            let mut p7 = Pair {
                a: ((r1[(i6 + 1) % 2] * 0.375_f64).max(y) * 0.75).sin(),
                b: ((r1[(i6 + 1) % 2] * r1[1]) * 0.75).sin(),
            };
            if (r1[(i6 * i6 + 1) % 2] * 0.125_f64).max(a) <= (y + e) {
                e += ((((i6 as f64) * 0.25) * (r1[i6 % 2] + -0.625_f64).sin()) + 0.125).tanh();
                b = (((0.625_f64 + r1[1]) * (0.625_f64 + r1[1]) + 0.25).sqrt() + 0.125).tanh();
                let d = match shape(
                    ((r1[1] * -0.375_f64).max(((i6 as f64) * 0.25)) + 0.125).tanh(),
                    ((r1[i6 % 2] + 0.375_f64).sin() + 0.125).tanh(),
                ) {
                    Shape::Point => (0.375_f64 + f),
                    Shape::Disc(v) => r1[1],
                    Shape::Box { w: v, h } => {
                        ((r1[(i6 * i6 + 1) % 2] + -1.125_f64).sin() * -0.625_f64).abs()
                    }
                };
            }
        }
        p3 = -(p3 - p3).tamed();
        p3 = p3.tamed();
    }
    (b - (-0.125_f64 - -0.625_f64).tanh()) + b + a + f + e + y + x
}

fn program_6_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin();
    let mut r1 = [((e * y) + S::from_f64(0.125)).tanh(); 2];
    let mut u2 = r1.to_vec();
    u2.push(((y * S::from_f64(-1.125_f64)).max(r1[1]) * S::from_f64(0.75)).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    e = e + ((S::from_f64(-0.125_f64) * r1[1]) + S::from_f64(0.125)).tanh();
    let (a, mut b) =
        (((r1[1] * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh(), (e * r1[1]));
    b = ((-(x + b)) + S::from_f64(0.125)).tanh();
    let mut p3 = Pair {
        a: ((y / (S::from_f64(1.5) + a * a)) + S::from_f64(0.125)).tanh(),
        b: ((e + x) * S::from_f64(0.75)).sin(),
    };
    if (a + S::from_f64(-1.125_f64)).sin().cmple((r1[0] * p3.a)) {
        e = (((f / (S::from_f64(1.5) + r1[0] * r1[0])) - (a + S::from_f64(-0.375_f64)).sin())
            * S::from_f64(0.75))
        .sin();
        let g4 = |t: S| {
            ((e * S::from_f64(0.625_f64)).cos() + (x * S::from_f64(-0.125_f64)).max(r1[0])) * t
        };
        let a = (g4((y * S::from_f64(0.375_f64)).cos())
            + g4((r1[1] + S::from_f64(-0.875_f64)).sin()))
        .sin();
    }
    'l5: for i6 in (2..1_usize).step_by(2) {
        if i6 % 3 == 2 {
            let mut p7 = Pair {
                a: ((r1[(i6 + 1) % 2] * S::from_f64(0.375_f64)).max(y) * S::from_f64(0.75)).sin(),
                b: ((r1[(i6 + 1) % 2] * r1[1]) * S::from_f64(0.75)).sin(),
            };
            if (r1[(i6 * i6 + 1) % 2] * S::from_f64(0.125_f64)).max(a).cmple((y + e)) {
                e = e
                    + (((S::from_f64(i6 as f64) * S::from_f64(0.25))
                        * (r1[i6 % 2] + S::from_f64(-0.625_f64)).sin())
                        + S::from_f64(0.125))
                    .tanh();
                b = (((S::from_f64(0.625_f64) + r1[1]) * (S::from_f64(0.625_f64) + r1[1])
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh();
                let d = match shape(
                    ((r1[1] * S::from_f64(-0.375_f64))
                        .max((S::from_f64(i6 as f64) * S::from_f64(0.25)))
                        + S::from_f64(0.125))
                    .tanh(),
                    ((r1[i6 % 2] + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
                ) {
                    Shape::Point => (S::from_f64(0.375_f64) + f),
                    Shape::Disc(v) => r1[1],
                    Shape::Box { w: v, h } => ((r1[(i6 * i6 + 1) % 2] + S::from_f64(-1.125_f64))
                        .sin()
                        * S::from_f64(-0.625_f64))
                    .abs(),
                };
            }
        }
        p3 = -(p3 - p3).tamed();
        p3 = p3.tamed();
    }
    (b - (S::from_f64(-0.125_f64) - S::from_f64(-0.625_f64)).tanh()) + b + a + f + e + y + x
}

#[differentiable]
fn program_7(x: f64, y: f64) -> f64 {
    let mut b = ((x * 0.875_f64).abs() + 0.125).tanh();
    let mut r1 = [((b * -0.125_f64).max(y) + 0.125).tanh(); 5];
    let b: f64 = r1.iter().map(|v| v * ((y * -0.375_f64).abs() + 0.125).tanh()).sum();
    let mut p2 = Pair { a: ((b * -1.125_f64).abs() + 0.125).tanh(), b: (x + 0.125).tanh() };
    let mut d = (r1[4] * 0.75).sin();
    let mut u3 = r1.to_vec();
    u3.push(((p2.b + x) * 0.75).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let e = (mixed(&u3) + u3[0]).tanh();
    let (a, mut b) = (((-(b)) * 0.75).sin(), (x - e));
    let e = mixed(&r1[3..]).sin();
    r1[4] -= (y + 0.125).tanh();
    if (p2.b + e) < b {
        p2 = (p2 - p2 * ((-(r1[0])) + 0.125).tanh()).tamed();
        p2 = p2.tamed();
        let e = match root(r1[2]) {
            Some(v) => r1[2],
            None => (p2.a * p2.b),
        };
    }
    r1[4] = (((r1[0] * x) * (0.375_f64 * -1.125_f64).cos()) * 0.75).sin();
    d += (((x * x) * 0.625_f64).abs() * 0.75).sin();
    let a = root((e + -0.375_f64).sin()).map_or((0.625_f64 * b), |v| y);
    if (p2.b * a) <= (a * a) {
        return (y * (r1[0] / (1.5 + d * d)));
    }
    ((-0.375_f64 + r1[3]) * -0.375_f64).max(y) + a + e + b + d + y + x
}

fn program_7_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh();
    let mut r1 = [((b * S::from_f64(-0.125_f64)).max(y) + S::from_f64(0.125)).tanh(); 5];
    let b = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((y * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh()
    });
    let mut p2 = Pair {
        a: ((b * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: (x + S::from_f64(0.125)).tanh(),
    };
    let mut d = (r1[4] * S::from_f64(0.75)).sin();
    let mut u3 = r1.to_vec();
    u3.push(((p2.b + x) * S::from_f64(0.75)).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let e = (mixed(&u3) + u3[0]).tanh();
    let (a, mut b) = (((-(b)) * S::from_f64(0.75)).sin(), (x - e));
    let e = mixed(&r1[3..]).sin();
    r1[4] = r1[4] - (y + S::from_f64(0.125)).tanh();
    if (p2.b + e).cmplt(b) {
        p2 = (p2 - p2 * ((-(r1[0])) + S::from_f64(0.125)).tanh()).tamed();
        p2 = p2.tamed();
        let e = match root(r1[2]) {
            Some(v) => r1[2],
            None => (p2.a * p2.b),
        };
    }
    r1[4] = (((r1[0] * x) * (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).cos())
        * S::from_f64(0.75))
    .sin();
    d = d + (((x * x) * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let a = root((e + S::from_f64(-0.375_f64)).sin()).map_or((S::from_f64(0.625_f64) * b), |v| y);
    if (p2.b * a).cmple((a * a)) {
        return (y * (r1[0] / (S::from_f64(1.5) + d * d)));
    }
    ((S::from_f64(-0.375_f64) + r1[3]) * S::from_f64(-0.375_f64)).max(y) + a + e + b + d + y + x
}

#[differentiable]
fn program_8(x: f64, y: f64) -> f64 {
    let mut d = ((x * x) + 0.125).tanh();
    let mut r1 = [
        ((x * 0.125_f64).abs() * 0.75).sin(),
        ((x * 0.375_f64).cos() + 0.125).tanh(),
        ((x + x) * 0.75).sin(),
    ];
    'l2: for i3 in (1..5_usize).step_by(2) {
        r1[(i3 + 2) % 3] *= (((r1[(i3 * i3 + 1) % 3] * x) + r1[(i3 * i3 + 1) % 3]) + 0.125).tanh();
        'l4: for i5 in 1..5_usize {
            'l6: for i7 in (0..4_usize).rev() {
                let (a, mut b) = ((x * 0.75).sin(), (x * 0.875_f64).cos());
            }
            let c = if i5 % 2 == 0 {
                ((y * r1[0]) * 0.875_f64).cos()
            } else {
                (y - (r1[2] / (1.5 + d * d)))
            };
            let b = if (c * 0.875_f64) <= (((i3 as f64) * 0.25) * -0.875_f64).max(y) {
                ((r1[1] + 0.625_f64).sin() * (c * r1[2]))
            } else {
                ((d * c) * (r1[i3 % 3] * 0.125_f64).abs())
            };
        }
        let g8 = |t: f64| ((r1[(i3 + 0) % 3] * r1[(i3 * i3 + 1) % 3]) * -0.125_f64).cos() * t;
        let f = (g8((((i3 as f64) * 0.25) * 0.625_f64).cos()) + g8(-0.375_f64)).sin();
    }
    'l9: for i10 in (0..3_usize).rev() {
        if i10 % 2 == 1 {
            #[differentiable(checkpoint)]
            'l11: for i12 in i10..1_usize {
                let f = mixed(&r1).sin();
            }
        } else {
            let r13 = [
                ((x * r1[1]) * 0.75).sin(),
                (r1[1] + 0.125).tanh(),
                ((x * ((i10 as f64) * 0.25)) + 0.125).tanh(),
                ((r1[2] - 0.625_f64).tanh() + 0.125).tanh(),
                ((d + 0.875_f64).sin() * 0.75).sin(),
            ];
            let mut c = ((d * -0.375_f64).abs() * 0.75).sin();
            let (a, mut b) = (((-0.375_f64 + x) + 0.125).tanh(), (x * c));
        }
        let (a, mut b) = (
            ((r1[(i10 * i10 + 1) % 3] + -1.125_f64).sin() + 0.125).tanh(),
            (y / (1.5 + ((i10 as f64) * 0.25) * ((i10 as f64) * 0.25))),
        );
        let mut p14 = Pair { a: ((y + -0.125_f64).sin() + 0.125).tanh(), b: (d + 0.125).tanh() };
    }
    x + d + y + x
}

fn program_8_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((x + x) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in (1..5_usize).step_by(2) {
        r1[(i3 + 2) % 3] = r1[(i3 + 2) % 3]
            * (((r1[(i3 * i3 + 1) % 3] * x) + r1[(i3 * i3 + 1) % 3]) + S::from_f64(0.125)).tanh();
        'l4: for i5 in 1..5_usize {
            'l6: for i7 in (0..4_usize).rev() {
                let (a, mut b) =
                    ((x * S::from_f64(0.75)).sin(), (x * S::from_f64(0.875_f64)).cos());
            }
            let c = if i5 % 2 == 0 {
                ((y * r1[0]) * S::from_f64(0.875_f64)).cos()
            } else {
                (y - (r1[2] / (S::from_f64(1.5) + d * d)))
            };
            let b = if (c * S::from_f64(0.875_f64)).cmple(
                ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.875_f64)).max(y),
            ) {
                ((r1[1] + S::from_f64(0.625_f64)).sin() * (c * r1[2]))
            } else {
                ((d * c) * (r1[i3 % 3] * S::from_f64(0.125_f64)).abs())
            };
        }
        let g8 =
            |t: S| ((r1[(i3 + 0) % 3] * r1[(i3 * i3 + 1) % 3]) * S::from_f64(-0.125_f64)).cos() * t;
        let f = (g8(((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(0.625_f64)).cos())
            + g8(S::from_f64(-0.375_f64)))
        .sin();
    }
    'l9: for i10 in (0..3_usize).rev() {
        if i10 % 2 == 1 {
            'l11: for i12 in i10..1_usize {
                let f = mixed(&r1).sin();
            }
        } else {
            let r13 = [
                ((x * r1[1]) * S::from_f64(0.75)).sin(),
                (r1[1] + S::from_f64(0.125)).tanh(),
                ((x * (S::from_f64(i10 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
                ((r1[2] - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
                ((d + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
            ];
            let mut c = ((d * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin();
            let (a, mut b) = (((S::from_f64(-0.375_f64) + x) + S::from_f64(0.125)).tanh(), (x * c));
        }
        let (a, mut b) = (
            ((r1[(i10 * i10 + 1) % 3] + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
            (y / (S::from_f64(1.5)
                + (S::from_f64(i10 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i10 as f64) * S::from_f64(0.25)))),
        );
        let mut p14 = Pair {
            a: ((y + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
            b: (d + S::from_f64(0.125)).tanh(),
        };
    }
    x + d + y + x
}

#[differentiable]
fn program_9(x: f64, y: f64) -> f64 {
    let mut f = ((-(y)) + 0.125).tanh();
    let mut r1 = [(f + 0.125).tanh(); 5];
    #[differentiable(checkpoint)]
    'l2: for i3 in 2..=3_usize {
        let by4 = (-0.125_f64 * 0.75).sin();
        let b = shifted(&mut r1[1..], by4);
    }
    let (a, mut b) = (((r1[3] + y) * 0.75).sin(), (f * -0.875_f64).abs());
    if (-(-0.125_f64)) <= (f / (1.5 + b * b)) {
        return ((a - 0.875_f64).tanh() * (r1[2] + r1[0]));
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        b += (b + 0.125).tanh();
        let d = mixed(&r1[3..]).sin();
        'l7: for i8 in (n6..4_usize).rev() {
            f -= (((-(r1[(i8 + 4) % 5])) * -0.875_f64).abs() + 0.125).tanh();
        }
    }
    'l9: for i10 in 0..=5_usize {
        let g11 =
            |t: f64| ((r1[1] + y) / (1.5 + (-(r1[(i10 + 4) % 5])) * (-(r1[(i10 + 4) % 5])))) * t;
        let b = (g11((y * 0.125_f64))
            + g11((y / (1.5 + r1[(i10 * i10 + 1) % 5] * r1[(i10 * i10 + 1) % 5]))))
        .sin();
        f *= ((-0.625_f64 * 0.875_f64).max(0.375_f64) + 0.125).tanh();
        'l12: for i13 in (2..5_usize).rev() {
            let mut u14 = r1.to_vec();
            u14.push(((f + 0.125_f64).sin() * 0.75).sin());
            u14[0] = u14[1] * u14[u14.len() - 1];
            let d = (mixed(&u14) + u14[0]).tanh();
        }
    }
    ((-(b)) + (a * a + 0.25).sqrt()) + b + a + f + y + x
}

fn program_9_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((-(y)) + S::from_f64(0.125)).tanh();
    let mut r1 = [(f + S::from_f64(0.125)).tanh(); 5];

    'l2: for i3 in 2..=3_usize {
        let by4 = (S::from_f64(-0.125_f64) * S::from_f64(0.75)).sin();
        let b = shifted(&mut r1[1..], by4);
    }
    let (a, mut b) = (((r1[3] + y) * S::from_f64(0.75)).sin(), (f * S::from_f64(-0.875_f64)).abs());
    if (-(S::from_f64(-0.125_f64))).cmple((f / (S::from_f64(1.5) + b * b))) {
        return ((a - S::from_f64(0.875_f64)).tanh() * (r1[2] + r1[0]));
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        b = b + (b + S::from_f64(0.125)).tanh();
        let d = mixed(&r1[3..]).sin();
        'l7: for i8 in (n6..4_usize).rev() {
            f = f
                - (((-(r1[(i8 + 4) % 5])) * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125))
                    .tanh();
        }
    }
    'l9: for i10 in 0..=5_usize {
        let g11 = |t: S| {
            ((r1[1] + y) / (S::from_f64(1.5) + (-(r1[(i10 + 4) % 5])) * (-(r1[(i10 + 4) % 5])))) * t
        };
        let b = (g11((y * S::from_f64(0.125_f64)))
            + g11((y / (S::from_f64(1.5) + r1[(i10 * i10 + 1) % 5] * r1[(i10 * i10 + 1) % 5]))))
        .sin();
        f = f
            * ((S::from_f64(-0.625_f64) * S::from_f64(0.875_f64)).max(S::from_f64(0.375_f64))
                + S::from_f64(0.125))
            .tanh();
        'l12: for i13 in (2..5_usize).rev() {
            let mut u14 = r1.to_vec();
            u14.push(((f + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin());
            u14[0] = u14[1] * u14[u14.len() - 1];
            let d = (mixed(&u14) + u14[0]).tanh();
        }
    }
    ((-(b)) + (a * a + S::from_f64(0.25)).sqrt()) + b + a + f + y + x
}

#[differentiable]
fn program_10(x: f64, y: f64) -> f64 {
    let mut d = ((y * x) * 0.75).sin();
    let mut r1 = [((y * y + 0.25).sqrt() + 0.125).tanh(); 3];
    let mut u2 = r1.to_vec();
    u2.push(((r1[0] * 0.125_f64).cos() + 0.125).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    r1[2] = (((d + 0.375_f64).sin() - 0.125_f64).tanh() * 0.75).sin();
    r1[1] = (((-(x)) - (-0.875_f64 * 0.625_f64).abs()) * 0.75).sin();
    'l3: for i4 in 2..1_usize {
        d += (((-(x)) + (d * x)) + 0.125).tanh();
    }
    'l5: for i6 in (1..1_usize).rev() {
        let e = mixed(&r1).sin();
    }
    let g7 = |t: f64| 0.625_f64 * t;
    let d = (g7((-(f))) + g7((r1[0] + y))).sin();
    'l8: for i9 in 1..=2_usize {
        if i9 % 4 == 3 {
            continue;
        }
        let c = root((((i9 as f64) * 0.25) * r1[(i9 + 1) % 3]))
            .map_or(f, |v| ((f / (1.5 + x * x)) - 0.375_f64).tanh());
    }
    if (x * 0.375_f64).cos() < (y + y) {
        return y;
    }
    'l10: for i11 in (1..0_usize).step_by(2) {
        'l12: for i13 in 0..=2_usize {
            let c = mixed(&r1[2..]).sin();
            let mut n15 = 0_usize;
            'l14: while n15 < 4 {
                n15 += 1;
                let mut f = ((((n15 as f64) * 0.25) + -1.125_f64).sin() + 0.125).tanh();
                f *= ((c * (x / (1.5 + r1[(n15 * n15 + 1) % 3] * r1[(n15 * n15 + 1) % 3])))
                    + 0.125)
                    .tanh();
            }
            let f = match shape(
                ((f / (1.5 + c * c)) * 0.75).sin(),
                ((y * 0.625_f64).abs() + 0.125).tanh(),
            ) {
                Shape::Point => (r1[1] + f),
                Shape::Disc(v) => r1[(i11 * i11 + 1) % 3],
                Shape::Box { w: v, h } => f,
            };
        }
        if (r1[i11 % 3] * -1.125_f64).abs() >= r1[(i11 * i11 + 1) % 3] {
            continue;
        }
        let mut p16 = Pair {
            a: ((r1[(i11 * i11 + 1) % 3] - r1[(i11 + 2) % 3]) * 0.75).sin(),
            b: ((r1[i11 % 3] + ((i11 as f64) * 0.25)) * 0.75).sin(),
        };
    }
    (y / (1.5 + (r1[2] * x) * (r1[2] * x))) + d + f + y + x
}

fn program_10_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * x) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 3];
    let mut u2 = r1.to_vec();
    u2.push(((r1[0] * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    r1[2] = (((d + S::from_f64(0.375_f64)).sin() - S::from_f64(0.125_f64)).tanh()
        * S::from_f64(0.75))
    .sin();
    r1[1] = (((-(x)) - (S::from_f64(-0.875_f64) * S::from_f64(0.625_f64)).abs())
        * S::from_f64(0.75))
    .sin();
    'l3: for i4 in 2..1_usize {
        d = d + (((-(x)) + (d * x)) + S::from_f64(0.125)).tanh();
    }
    'l5: for i6 in (1..1_usize).rev() {
        let e = mixed(&r1).sin();
    }
    let g7 = |t: S| S::from_f64(0.625_f64) * t;
    let d = (g7((-(f))) + g7((r1[0] + y))).sin();
    'l8: for i9 in 1..=2_usize {
        if i9 % 4 == 3 {
            continue;
        }
        let c = root(((S::from_f64(i9 as f64) * S::from_f64(0.25)) * r1[(i9 + 1) % 3]))
            .map_or(f, |v| ((f / (S::from_f64(1.5) + x * x)) - S::from_f64(0.375_f64)).tanh());
    }
    if (x * S::from_f64(0.375_f64)).cos().cmplt((y + y)) {
        return y;
    }
    'l10: for i11 in (1..0_usize).step_by(2) {
        'l12: for i13 in 0..=2_usize {
            let c = mixed(&r1[2..]).sin();
            let mut n15 = 0_usize;
            'l14: while n15 < 4 {
                n15 += 1;
                let mut f = (((S::from_f64(n15 as f64) * S::from_f64(0.25))
                    + S::from_f64(-1.125_f64))
                .sin()
                    + S::from_f64(0.125))
                .tanh();
                f = f
                    * ((c
                        * (x / (S::from_f64(1.5)
                            + r1[(n15 * n15 + 1) % 3] * r1[(n15 * n15 + 1) % 3])))
                        + S::from_f64(0.125))
                    .tanh();
            }
            let f = match shape(
                ((f / (S::from_f64(1.5) + c * c)) * S::from_f64(0.75)).sin(),
                ((y * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            ) {
                Shape::Point => (r1[1] + f),
                Shape::Disc(v) => r1[(i11 * i11 + 1) % 3],
                Shape::Box { w: v, h } => f,
            };
        }
        if (r1[i11 % 3] * S::from_f64(-1.125_f64)).abs().cmpge(r1[(i11 * i11 + 1) % 3]) {
            continue;
        }
        let mut p16 = Pair {
            a: ((r1[(i11 * i11 + 1) % 3] - r1[(i11 + 2) % 3]) * S::from_f64(0.75)).sin(),
            b: ((r1[i11 % 3] + (S::from_f64(i11 as f64) * S::from_f64(0.25))) * S::from_f64(0.75))
                .sin(),
        };
    }
    (y / (S::from_f64(1.5) + (r1[2] * x) * (r1[2] * x))) + d + f + y + x
}

#[differentiable]
fn program_11(x: f64, y: f64) -> f64 {
    let mut f = ((x * -0.625_f64).max(0.875_f64) + 0.125).tanh();
    let mut r1 = [((x - x) * 0.75).sin(), ((y - -1.125_f64).tanh() + 0.125).tanh()];
    let e = program_0(((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin(), ((0.375_f64 + x) * 0.75).sin())
        .tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let mut n5 = 0_usize;
        'l4: while n5 < 5 {
            n5 += 1;
            let mut p6 =
                Pair { a: ((-(y)) + 0.125).tanh(), b: (((n3 as f64) * 0.25) + 0.125).tanh() };
        }
    }
    let (a, mut b) = (((y + 0.875_f64).sin() + 0.125).tanh(), x);
    if (b / (1.5 + r1[1] * r1[1])) < (0.875_f64 * b) {
        let mut p7 =
            Pair { a: ((f * a) * 0.75).sin(), b: ((r1[1] / (1.5 + r1[1] * r1[1])) + 0.125).tanh() };
    } else {
        'l8: for i9 in 2..3_usize {
            let a = if i9 % 2 == 1 {
                ((e + 0.375_f64) + (y / (1.5 + x * x)))
            } else {
                ((i9 as f64) * 0.25)
            };
        }
        if (x + -0.375_f64).sin() > (0.625_f64 - -0.625_f64).tanh() {
            return e;
        }
        if (-0.375_f64 * 0.875_f64).max(a) < r1[0] {
            b = (((-(b)) * 0.375_f64).max(e) + 0.125).tanh();
        } else {
            b = ((e * e + 0.25).sqrt() * 0.75).sin();
            let mut n11 = 0_usize;
            'l10: while n11 < 4 {
                n11 += 1;
                let mut p12 = Pair {
                    a: ((b - -0.375_f64).tanh() + 0.125).tanh(),
                    b: ((r1[1] / (1.5 + y * y)) * 0.75).sin(),
                };
            }
        }
    }
    (b + 0.875_f64).sin() + b + a + e + f + y + x
}

fn program_11_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f =
        ((x * S::from_f64(-0.625_f64)).max(S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x - x) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
    ];
    let e = program_0_of(
        ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.375_f64) + x) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let mut n5 = 0_usize;
        'l4: while n5 < 5 {
            n5 += 1;
            let mut p6 = Pair {
                a: ((-(y)) + S::from_f64(0.125)).tanh(),
                b: ((S::from_f64(n3 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh(),
            };
        }
    }
    let (a, mut b) = (((y + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(), x);
    if (b / (S::from_f64(1.5) + r1[1] * r1[1])).cmplt((S::from_f64(0.875_f64) * b)) {
        let mut p7 = Pair {
            a: ((f * a) * S::from_f64(0.75)).sin(),
            b: ((r1[1] / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh(),
        };
    } else {
        'l8: for i9 in 2..3_usize {
            let a = if i9 % 2 == 1 {
                ((e + S::from_f64(0.375_f64)) + (y / (S::from_f64(1.5) + x * x)))
            } else {
                (S::from_f64(i9 as f64) * S::from_f64(0.25))
            };
        }
        if (x + S::from_f64(-0.375_f64))
            .sin()
            .cmpgt((S::from_f64(0.625_f64) - S::from_f64(-0.625_f64)).tanh())
        {
            return e;
        }
        if (S::from_f64(-0.375_f64) * S::from_f64(0.875_f64)).max(a).cmplt(r1[0]) {
            b = (((-(b)) * S::from_f64(0.375_f64)).max(e) + S::from_f64(0.125)).tanh();
        } else {
            b = ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
            let mut n11 = 0_usize;
            'l10: while n11 < 4 {
                n11 += 1;
                let mut p12 = Pair {
                    a: ((b - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
                    b: ((r1[1] / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
                };
            }
        }
    }
    (b + S::from_f64(0.875_f64)).sin() + b + a + e + f + y + x
}

#[differentiable]
fn program_12(x: f64, y: f64) -> f64 {
    let mut c = ((x * y) + 0.125).tanh();
    let r1 = [((y * 0.125_f64).cos() * 0.75).sin(); 4];
    let g2 = |t: f64| r1[2] * t;
    let e = (g2((c / (1.5 + r1[1] * r1[1]))) + g2((0.125_f64 + y))).sin();
    let (a, mut b) = (((x * -1.125_f64).cos() * 0.75).sin(), r1[0]);
    c -= (c + 0.125).tanh();
    let e = if (r1[1] * 0.375_f64) >= (c - a) {
        ((a * -0.375_f64).cos() * -0.875_f64).max(r1[3])
    } else {
        ((c * 0.125_f64).abs() - 0.125_f64)
    };
    b = (((r1[3] * 0.625_f64).abs() * (r1[1] * -0.875_f64).cos()) * 0.75).sin();
    let r3 = [(x + 0.125).tanh(), (r1[0] + 0.125).tanh()];
    if (r1[3] * 0.125_f64).max(x) < c {
        return b;
    }
    b -= (((e * 0.375_f64).abs() - c) * 0.75).sin();
    let r4 =
        [((a * a) + 0.125).tanh(), ((e * e + 0.25).sqrt() * 0.75).sin(), (r3[0] + 0.125).tanh()];
    let (a, mut b) = (((r3[0] * y) + 0.125).tanh(), (-(r4[0])));
    let mut r5 = [
        ((r1[2] / (1.5 + r3[1] * r3[1])) * 0.75).sin(),
        (r4[0] * 0.75).sin(),
        ((r1[3] + c) + 0.125).tanh(),
    ];
    let (a, mut b) = (((e - r3[0]) + 0.125).tanh(), (a - 0.875_f64).tanh());
    let r6 = [
        ((c * r3[0]) + 0.125).tanh(),
        ((0.875_f64 * -0.625_f64).abs() * 0.75).sin(),
        ((b + c) + 0.125).tanh(),
        ((x + 0.875_f64).sin() + 0.125).tanh(),
    ];
    r5[0] += (((r5[1] - -0.625_f64) - -0.625_f64).tanh() * 0.75).sin();
    ((c * c + 0.25).sqrt() * (r5[2] - c)) + b + a + e + c + y + x
}

fn program_12_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * y) + S::from_f64(0.125)).tanh();
    let r1 = [((y * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin(); 4];
    let g2 = |t: S| r1[2] * t;
    let e = (g2((c / (S::from_f64(1.5) + r1[1] * r1[1]))) + g2((S::from_f64(0.125_f64) + y))).sin();
    let (a, mut b) = (((x * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(), r1[0]);
    c = c - (c + S::from_f64(0.125)).tanh();
    let e = if (r1[1] * S::from_f64(0.375_f64)).cmpge((c - a)) {
        ((a * S::from_f64(-0.375_f64)).cos() * S::from_f64(-0.875_f64)).max(r1[3])
    } else {
        ((c * S::from_f64(0.125_f64)).abs() - S::from_f64(0.125_f64))
    };
    b = (((r1[3] * S::from_f64(0.625_f64)).abs() * (r1[1] * S::from_f64(-0.875_f64)).cos())
        * S::from_f64(0.75))
    .sin();
    let r3 = [(x + S::from_f64(0.125)).tanh(), (r1[0] + S::from_f64(0.125)).tanh()];
    if (r1[3] * S::from_f64(0.125_f64)).max(x).cmplt(c) {
        return b;
    }
    b = b - (((e * S::from_f64(0.375_f64)).abs() - c) * S::from_f64(0.75)).sin();
    let r4 = [
        ((a * a) + S::from_f64(0.125)).tanh(),
        ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (r3[0] + S::from_f64(0.125)).tanh(),
    ];
    let (a, mut b) = (((r3[0] * y) + S::from_f64(0.125)).tanh(), (-(r4[0])));
    let mut r5 = [
        ((r1[2] / (S::from_f64(1.5) + r3[1] * r3[1])) * S::from_f64(0.75)).sin(),
        (r4[0] * S::from_f64(0.75)).sin(),
        ((r1[3] + c) + S::from_f64(0.125)).tanh(),
    ];
    let (a, mut b) =
        (((e - r3[0]) + S::from_f64(0.125)).tanh(), (a - S::from_f64(0.875_f64)).tanh());
    let r6 = [
        ((c * r3[0]) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.875_f64) * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
        ((b + c) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
    ];
    r5[0] = r5[0]
        + (((r5[1] - S::from_f64(-0.625_f64)) - S::from_f64(-0.625_f64)).tanh()
            * S::from_f64(0.75))
        .sin();
    ((c * c + S::from_f64(0.25)).sqrt() * (r5[2] - c)) + b + a + e + c + y + x
}

#[differentiable]
fn program_13(x: f64, y: f64) -> f64 {
    let mut e = ((y * -0.875_f64).max(0.875_f64) * 0.75).sin();
    let r1 = [((y + y) * 0.75).sin(); 3];
    e *= (e * 0.75).sin();
    'l2: for i3 in (0..1_usize).rev() {
        if r1[(i3 * i3 + 1) % 3] <= (r1[i3 % 3] + y) {
            e += (((y / (1.5 + e * e)) * (y + -0.875_f64).sin()) + 0.125).tanh();
            if i3 % 3 == 2 {
                break;
            }
            let mut p4 = Pair {
                a: ((y + e) * 0.75).sin(),
                b: ((((i3 as f64) * 0.25) + r1[i3 % 3]) * 0.75).sin(),
            };
        }
        let mut n6 = 0_usize;
        'l5: while n6 < 1 {
            n6 += 1;
            let (a, mut b) = (((r1[2] * -0.875_f64).abs() + 0.125).tanh(), x);
            let g7 = |t: f64| r1[(i3 * i3 + 1) % 3] * t;
            let e = (g7((r1[n6 % 3] * e)) + g7((e / (1.5 + r1[i3 % 3] * r1[i3 % 3])))).sin();
            b = (((0.125_f64 + 0.125_f64) + a) + 0.125).tanh();
        }
        let e = if i3 % 4 == 1 {
            ((y + r1[i3 % 3]) / (1.5 + (y + x) * (y + x)))
        } else {
            ((x + 0.375_f64).sin() * -0.375_f64).max(r1[1])
        };
    }
    e = (((r1[2] + y) * 0.375_f64).cos() + 0.125).tanh();
    e -= ((e * 0.875_f64).abs() + 0.125).tanh();
    let a = match shape(((x / (1.5 + x * x)) + 0.125).tanh(), (r1[2] + 0.125).tanh()) {
        Shape::Point => (-0.125_f64 + -0.875_f64).sin(),
        Shape::Disc(v) => ((e - y) * (0.375_f64 * r1[2])),
        Shape::Box { w: v, h } => v,
    };
    (r1[1] * (-(r1[2]))) + a + e + y + x
}

fn program_13_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e =
        ((y * S::from_f64(-0.875_f64)).max(S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin();
    let r1 = [((y + y) * S::from_f64(0.75)).sin(); 3];
    e = e * (e * S::from_f64(0.75)).sin();
    'l2: for i3 in (0..1_usize).rev() {
        if r1[(i3 * i3 + 1) % 3].cmple((r1[i3 % 3] + y)) {
            e = e
                + (((y / (S::from_f64(1.5) + e * e)) * (y + S::from_f64(-0.875_f64)).sin())
                    + S::from_f64(0.125))
                .tanh();
            if i3 % 3 == 2 {
                break;
            }
            let mut p4 = Pair {
                a: ((y + e) * S::from_f64(0.75)).sin(),
                b: (((S::from_f64(i3 as f64) * S::from_f64(0.25)) + r1[i3 % 3])
                    * S::from_f64(0.75))
                .sin(),
            };
        }
        let mut n6 = 0_usize;
        'l5: while n6 < 1 {
            n6 += 1;
            let (a, mut b) =
                (((r1[2] * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(), x);
            let g7 = |t: S| r1[(i3 * i3 + 1) % 3] * t;
            let e = (g7((r1[n6 % 3] * e)) + g7((e / (S::from_f64(1.5) + r1[i3 % 3] * r1[i3 % 3]))))
                .sin();
            b = (((S::from_f64(0.125_f64) + S::from_f64(0.125_f64)) + a) + S::from_f64(0.125))
                .tanh();
        }
        let e = if i3 % 4 == 1 {
            ((y + r1[i3 % 3]) / (S::from_f64(1.5) + (y + x) * (y + x)))
        } else {
            ((x + S::from_f64(0.375_f64)).sin() * S::from_f64(-0.375_f64)).max(r1[1])
        };
    }
    e = (((r1[2] + y) * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    e = e - ((e * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh();
    let a = match shape(
        ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        (r1[2] + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (S::from_f64(-0.125_f64) + S::from_f64(-0.875_f64)).sin(),
        Shape::Disc(v) => ((e - y) * (S::from_f64(0.375_f64) * r1[2])),
        Shape::Box { w: v, h } => v,
    };
    (r1[1] * (-(r1[2]))) + a + e + y + x
}

#[differentiable]
fn program_14(x: f64, y: f64) -> f64 {
    let mut c = ((y * y) * 0.75).sin();
    let mut r1 = [
        ((c / (1.5 + c * c)) * 0.75).sin(),
        ((x * -1.125_f64).max(x) + 0.125).tanh(),
        ((x + -0.625_f64).sin() + 0.125).tanh(),
        ((y * -1.125_f64).cos() + 0.125).tanh(),
        (0.625_f64 * 0.75).sin(),
    ];
    if (-(y)) <= (r1[1] * 0.375_f64).max(y) {
        'l2: for i3 in 1..=2_usize {
            let by4 = ((((i3 as f64) * 0.25) * -0.125_f64).abs() * 0.75).sin();
            for v in r1.iter_mut() {
                *v = (*v * by4).sin();
            }
            c = (((y * y + 0.25).sqrt() - 0.875_f64).tanh() * 0.75).sin();
            'l5: for i6 in (1..1_usize).step_by(2) {
                let mut r7 = [((((i6 as f64) * 0.25) - r1[(i6 * i6 + 1) % 5]) + 0.125).tanh(); 4];
            }
        }
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 3 {
        n9 += 1;
        c -= (((c + x)
            / (1.5
                + (((n9 as f64) * 0.25) * -0.375_f64).abs()
                    * (((n9 as f64) * 0.25) * -0.375_f64).abs()))
            + 0.125)
            .tanh();
        let g10 = |t: f64| ((((n9 as f64) * 0.25) * -0.625_f64).max(t) * c) * t;
        let d = (g10((r1[(n9 * n9 + 1) % 5] * -1.125_f64).abs())
            + g10((-0.125_f64 * -0.125_f64 + 0.25).sqrt()))
        .sin();
    }
    let g11 = |t: f64| (y * y + 0.25).sqrt() * t;
    let b = (g11((c * r1[3])) + g11((r1[4] * -0.625_f64).max(c))).sin();
    let c = match roots((c / (1.5 + 0.875_f64 * 0.875_f64)), (y * r1[3])) {
        Ok(v) => ((0.125_f64 * 0.625_f64).max(b) * (v + b)),
        Err(true) => r1[1],
        Err(_) => (-(x)),
    };
    r1[3] = (((r1[4] + c) - 0.375_f64).tanh() * 0.75).sin();
    let mut r12 = [(b + 0.125).tanh(); 2];
    let mut a = ((y + y) * 0.75).sin();
    ((r12[1] * 0.875_f64).max(b) - x) + a + c + b + y + x
}

fn program_14_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((c / (S::from_f64(1.5) + c * c)) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-1.125_f64)).max(x) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
    ];
    if (-(y)).cmple((r1[1] * S::from_f64(0.375_f64)).max(y)) {
        'l2: for i3 in 1..=2_usize {
            let by4 = (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                .abs()
                * S::from_f64(0.75))
            .sin();
            for v in r1.iter_mut() {
                *v = (*v * by4).sin();
            }
            c = (((y * y + S::from_f64(0.25)).sqrt() - S::from_f64(0.875_f64)).tanh()
                * S::from_f64(0.75))
            .sin();
            'l5: for i6 in (1..1_usize).step_by(2) {
                let mut r7 = [(((S::from_f64(i6 as f64) * S::from_f64(0.25))
                    - r1[(i6 * i6 + 1) % 5])
                    + S::from_f64(0.125))
                .tanh(); 4];
            }
        }
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 3 {
        n9 += 1;
        c = c
            - (((c + x)
                / (S::from_f64(1.5)
                    + ((S::from_f64(n9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64))
                        .abs()
                        * ((S::from_f64(n9 as f64) * S::from_f64(0.25))
                            * S::from_f64(-0.375_f64))
                        .abs()))
                + S::from_f64(0.125))
            .tanh();
        let g10 = |t: S| {
            (((S::from_f64(n9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).max(t) * c)
                * t
        };
        let d = (g10((r1[(n9 * n9 + 1) % 5] * S::from_f64(-1.125_f64)).abs())
            + g10((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()))
        .sin();
    }
    let g11 = |t: S| (y * y + S::from_f64(0.25)).sqrt() * t;
    let b = (g11((c * r1[3])) + g11((r1[4] * S::from_f64(-0.625_f64)).max(c))).sin();
    let c = match roots(
        (c / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64))),
        (y * r1[3]),
    ) {
        Ok(v) => ((S::from_f64(0.125_f64) * S::from_f64(0.625_f64)).max(b) * (v + b)),
        Err(true) => r1[1],
        Err(_) => (-(x)),
    };
    r1[3] = (((r1[4] + c) - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r12 = [(b + S::from_f64(0.125)).tanh(); 2];
    let mut a = ((y + y) * S::from_f64(0.75)).sin();
    ((r12[1] * S::from_f64(0.875_f64)).max(b) - x) + a + c + b + y + x
}

#[differentiable]
fn program_15(x: f64, y: f64) -> f64 {
    let mut e = ((-(0.375_f64)) + 0.125).tanh();
    let mut r1 = [
        ((0.125_f64 + 0.375_f64) * 0.75).sin(),
        ((0.875_f64 * e) + 0.125).tanh(),
        ((y + -1.125_f64).sin() * 0.75).sin(),
        ((y * -0.375_f64).max(e) * 0.75).sin(),
    ];
    e = (((y - 0.375_f64).tanh() + (0.375_f64 + y)) + 0.125).tanh();
    let (a, mut b) = (((r1[1] + r1[0]) + 0.125).tanh(), (e * -0.875_f64).abs());
    let g2 = |t: f64| ((r1[3] * r1[3] + 0.25).sqrt() + (-(y))) * t;
    let a = (g2((r1[1] * b)) + g2(r1[1])).sin();
    let (a, mut b) = (((r1[3] * r1[3] + 0.25).sqrt() + 0.125).tanh(), (r1[3] * -0.625_f64).abs());
    r1[2] =
        (((-(a)) / (1.5 + (r1[3] + 0.875_f64).sin() * (r1[3] + 0.875_f64).sin())) + 0.125).tanh();
    if b < (r1[0] - -0.375_f64) {
        r1[3] *= (r1[0] + 0.125).tanh();
        let e = r1[0];
        let mut p3 =
            Pair { a: ((-0.125_f64 + r1[2]) + 0.125).tanh(), b: ((b * r1[2]) * 0.75).sin() };
    } else {
        for v in r1.iter() {
            b = b * ((y / (1.5 + a * a)) * 0.75).sin() + *v * ((y / (1.5 + a * a)) * 0.75).sin();
        }
    }
    let d = program_2(((a + -0.375_f64).sin() * 0.75).sin(), ((e * a) + 0.125).tanh()).tanh();
    let mut n5 = 0_usize;
    'l4: while n5 < 2 {
        n5 += 1;
        if -0.375_f64 <= (y + -0.375_f64).sin() {
            if r1[(n5 + 1) % 4] < (b * e) {
                e -= (r1[(n5 + 2) % 4] * 0.75).sin();
                b -= ((a * a + 0.25).sqrt() + 0.125).tanh();
            }
            let f = match shape(
                ((e - y) * 0.75).sin(),
                ((((n5 as f64) * 0.25) * ((n5 as f64) * 0.25) + 0.25).sqrt() + 0.125).tanh(),
            ) {
                Shape::Point => (r1[(n5 * n5 + 1) % 4] - -0.875_f64).tanh(),
                Shape::Disc(v) => ((r1[0] * r1[0]) * (v * 0.625_f64)),
                Shape::Box { w: v, h } => ((((n5 as f64) * 0.25) + x) * -0.875_f64).cos(),
            };
            let mut r6 = [((0.875_f64 + 0.125_f64).sin() * 0.75).sin(); 5];
        } else {
            let d = program_11(
                ((r1[(n5 + 3) % 4] * r1[(n5 + 2) % 4]) * 0.75).sin(),
                ((b + d) * 0.75).sin(),
            )
            .tanh();
            if n5 % 3 == 2 {
                r1[(n5 * n5 + 1) % 4] -= (e * 0.75).sin();
            }
            let c = match roots((r1[1] + -0.625_f64).sin(), (y + 0.625_f64)) {
                Ok(v) => ((a / (1.5 + x * x)) + (e * -0.625_f64).cos()),
                Err(true) => e,
                Err(_) => -0.375_f64,
            };
        }
    }
    ((e + b) - 0.125_f64).tanh() + d + b + a + e + y + x
}

fn program_15_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((-(S::from_f64(0.375_f64))) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(0.125_f64) + S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.875_f64) * e) + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.375_f64)).max(e) * S::from_f64(0.75)).sin(),
    ];
    e = (((y - S::from_f64(0.375_f64)).tanh() + (S::from_f64(0.375_f64) + y)) + S::from_f64(0.125))
        .tanh();
    let (a, mut b) =
        (((r1[1] + r1[0]) + S::from_f64(0.125)).tanh(), (e * S::from_f64(-0.875_f64)).abs());
    let g2 = |t: S| ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + (-(y))) * t;
    let a = (g2((r1[1] * b)) + g2(r1[1])).sin();
    let (a, mut b) = (
        ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        (r1[3] * S::from_f64(-0.625_f64)).abs(),
    );
    r1[2] = (((-(a))
        / (S::from_f64(1.5)
            + (r1[3] + S::from_f64(0.875_f64)).sin() * (r1[3] + S::from_f64(0.875_f64)).sin()))
        + S::from_f64(0.125))
    .tanh();
    if b.cmplt((r1[0] - S::from_f64(-0.375_f64))) {
        r1[3] = r1[3] * (r1[0] + S::from_f64(0.125)).tanh();
        let e = r1[0];
        let mut p3 = Pair {
            a: ((S::from_f64(-0.125_f64) + r1[2]) + S::from_f64(0.125)).tanh(),
            b: ((b * r1[2]) * S::from_f64(0.75)).sin(),
        };
    } else {
        for v in r1.iter() {
            b = b * ((y / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin()
                + *v * ((y / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin();
        }
    }
    let d = program_2_of(
        ((a + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((e * a) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut n5 = 0_usize;
    'l4: while n5 < 2 {
        n5 += 1;
        if S::from_f64(-0.375_f64).cmple((y + S::from_f64(-0.375_f64)).sin()) {
            if r1[(n5 + 1) % 4].cmplt((b * e)) {
                e = e - (r1[(n5 + 2) % 4] * S::from_f64(0.75)).sin();
                b = b - ((a * a + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
            }
            let f = match shape(
                ((e - y) * S::from_f64(0.75)).sin(),
                (((S::from_f64(n5 as f64) * S::from_f64(0.25))
                    * (S::from_f64(n5 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh(),
            ) {
                Shape::Point => (r1[(n5 * n5 + 1) % 4] - S::from_f64(-0.875_f64)).tanh(),
                Shape::Disc(v) => ((r1[0] * r1[0]) * (v * S::from_f64(0.625_f64))),
                Shape::Box { w: v, h } => (((S::from_f64(n5 as f64) * S::from_f64(0.25)) + x)
                    * S::from_f64(-0.875_f64))
                .cos(),
            };
            let mut r6 = [((S::from_f64(0.875_f64) + S::from_f64(0.125_f64)).sin()
                * S::from_f64(0.75))
            .sin(); 5];
        } else {
            let d = program_11_of(
                ((r1[(n5 + 3) % 4] * r1[(n5 + 2) % 4]) * S::from_f64(0.75)).sin(),
                ((b + d) * S::from_f64(0.75)).sin(),
            )
            .tanh();
            if n5 % 3 == 2 {
                r1[(n5 * n5 + 1) % 4] = r1[(n5 * n5 + 1) % 4] - (e * S::from_f64(0.75)).sin();
            }
            let c = match roots(
                (r1[1] + S::from_f64(-0.625_f64)).sin(),
                (y + S::from_f64(0.625_f64)),
            ) {
                Ok(v) => ((a / (S::from_f64(1.5) + x * x)) + (e * S::from_f64(-0.625_f64)).cos()),
                Err(true) => e,
                Err(_) => S::from_f64(-0.375_f64),
            };
        }
    }
    ((e + b) - S::from_f64(0.125_f64)).tanh() + d + b + a + e + y + x
}

#[differentiable]
fn program_16(x: f64, y: f64) -> f64 {
    let mut c = ((x * x) + 0.125).tanh();
    let mut r1 = [((x * y) + 0.125).tanh(); 2];
    r1[1] *= ((y + 0.125_f64).sin() * 0.75).sin();
    r1[1] = (((x * -0.375_f64).max(r1[1]) * (y * y + 0.25).sqrt()) + 0.125).tanh();
    let c = match roots(y, (r1[1] + r1[0])) {
        Ok(v) => ((r1[0] * -0.125_f64).cos() * -1.125_f64).abs(),
        Err(true) => x,
        Err(_) => (y * x),
    };
    let (a, mut b) = (((r1[1] + r1[1]) * 0.75).sin(), (x + y));
    let mut u2: Vec<_> = r1.iter().map(|v| *v * a).collect();
    u2.push((x * 0.75).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let b = (mixed(&u2) + u2[0]).tanh();
    r1[0] *= (r1[1] * 0.75).sin();
    let mut p3 = Pair { a: ((b + x) * 0.75).sin(), b: ((y / (1.5 + r1[1] * r1[1])) * 0.75).sin() };
    let mut c = ((c + p3.a) * 0.75).sin();
    p3 = (p3 * p3 + p3).tamed();
    p3 = p3.tamed();
    let by4 = (r1[1] + 0.125).tanh();
    let f = shifted(&mut r1[0..], by4);
    if (r1[0] - -0.125_f64).tanh() < (-(-0.375_f64)) {
        return (r1[0] * -0.375_f64).abs();
    }
    #[differentiable(checkpoint)]
    'l5: for i6 in 0..=5_usize {
        let by7 = ((y * r1[0]) * 0.75).sin();
        let a = shifted(&mut r1[1..], by7);
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        let f = p3
            .dot(&Pair { a: ((c * a) * 0.75).sin(), b: ((r1[(n9 + 0) % 2] * p3.a) + 0.125).tanh() })
            .sin();
    }
    ((c - y) + (x * r1[1])) + f + c + b + a + y + x
}

fn program_16_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * y) + S::from_f64(0.125)).tanh(); 2];
    r1[1] = r1[1] * ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    r1[1] = (((x * S::from_f64(-0.375_f64)).max(r1[1]) * (y * y + S::from_f64(0.25)).sqrt())
        + S::from_f64(0.125))
    .tanh();
    let c = match roots(y, (r1[1] + r1[0])) {
        Ok(v) => ((r1[0] * S::from_f64(-0.125_f64)).cos() * S::from_f64(-1.125_f64)).abs(),
        Err(true) => x,
        Err(_) => (y * x),
    };
    let (a, mut b) = (((r1[1] + r1[1]) * S::from_f64(0.75)).sin(), (x + y));
    let mut u2: Vec<_> = r1.iter().map(|v| *v * a).collect();
    u2.push((x * S::from_f64(0.75)).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let b = (mixed(&u2) + u2[0]).tanh();
    r1[0] = r1[0] * (r1[1] * S::from_f64(0.75)).sin();
    let mut p3 = Pair {
        a: ((b + x) * S::from_f64(0.75)).sin(),
        b: ((y / (S::from_f64(1.5) + r1[1] * r1[1])) * S::from_f64(0.75)).sin(),
    };
    let mut c = ((c + p3.a) * S::from_f64(0.75)).sin();
    p3 = (p3 * p3 + p3).tamed();
    p3 = p3.tamed();
    let by4 = (r1[1] + S::from_f64(0.125)).tanh();
    let f = shifted(&mut r1[0..], by4);
    if (r1[0] - S::from_f64(-0.125_f64)).tanh().cmplt((-(S::from_f64(-0.375_f64)))) {
        return (r1[0] * S::from_f64(-0.375_f64)).abs();
    }

    'l5: for i6 in 0..=5_usize {
        let by7 = ((y * r1[0]) * S::from_f64(0.75)).sin();
        let a = shifted(&mut r1[1..], by7);
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        let f = p3
            .dot(&Pair {
                a: ((c * a) * S::from_f64(0.75)).sin(),
                b: ((r1[(n9 + 0) % 2] * p3.a) + S::from_f64(0.125)).tanh(),
            })
            .sin();
    }
    ((c - y) + (x * r1[1])) + f + c + b + a + y + x
}

#[differentiable]
fn program_17(x: f64, y: f64) -> f64 {
    let mut d = ((-(x)) + 0.125).tanh();
    let r1 = [(x * 0.75).sin(); 3];
    d = ((r1[0] * 0.875_f64).abs() * 0.75).sin();
    d = (((0.875_f64 * y) * 0.625_f64).cos() * 0.75).sin();
    #[differentiable(checkpoint)]
    'l2: for i3 in (1..2_usize).rev() {
        let mut p4 = Pair {
            a: ((r1[0] * -0.625_f64).max(d) + 0.125).tanh(),
            b: ((y * 0.125_f64).max(x) * 0.75).sin(),
        };
        let b = ((r1[2] - -0.125_f64).tanh() * -0.375_f64).cos();
        let b = match roots((r1[(i3 * i3 + 1) % 3] + b), (x + -0.125_f64).sin()) {
            Ok(v) => r1[(i3 + 2) % 3],
            Err(true) => r1[(i3 * i3 + 1) % 3],
            Err(_) => (d * b),
        };
    }
    #[differentiable(checkpoint)]
    'l5: for i6 in (0..2_usize).rev() {
        d *= (((i6 as f64) * 0.25) * 0.75).sin();
        d += (((((i6 as f64) * 0.25) * r1[i6 % 3]) * (x * x + 0.25).sqrt()) + 0.125).tanh();
    }
    let mut p7 = Pair {
        a: ((r1[2] * 0.125_f64).abs() * 0.75).sin(),
        b: ((y + -0.875_f64).sin() * 0.75).sin(),
    };
    p7 = (p7 + p7) * (y + 0.125).tanh();
    p7 = p7.tamed();
    d += (((y * r1[1]) * (d - 0.375_f64).tanh()) * 0.75).sin();
    let b =
        program_2((r1[1] + 0.125).tanh(), ((p7.a * 0.375_f64).max(-0.625_f64) * 0.75).sin()).tanh();
    let f = if (r1[2] * -0.625_f64).max(r1[1]) < (-(b)) { (b + (d + r1[0])) } else { r1[0] };
    ((r1[0] * f) * -0.125_f64).abs() + f + b + d + y + x
}

fn program_17_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((-(x)) + S::from_f64(0.125)).tanh();
    let r1 = [(x * S::from_f64(0.75)).sin(); 3];
    d = ((r1[0] * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin();
    d = (((S::from_f64(0.875_f64) * y) * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin();

    'l2: for i3 in (1..2_usize).rev() {
        let mut p4 = Pair {
            a: ((r1[0] * S::from_f64(-0.625_f64)).max(d) + S::from_f64(0.125)).tanh(),
            b: ((y * S::from_f64(0.125_f64)).max(x) * S::from_f64(0.75)).sin(),
        };
        let b = ((r1[2] - S::from_f64(-0.125_f64)).tanh() * S::from_f64(-0.375_f64)).cos();
        let b = match roots((r1[(i3 * i3 + 1) % 3] + b), (x + S::from_f64(-0.125_f64)).sin()) {
            Ok(v) => r1[(i3 + 2) % 3],
            Err(true) => r1[(i3 * i3 + 1) % 3],
            Err(_) => (d * b),
        };
    }

    'l5: for i6 in (0..2_usize).rev() {
        d = d * ((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin();
        d = d
            + ((((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[i6 % 3])
                * (x * x + S::from_f64(0.25)).sqrt())
                + S::from_f64(0.125))
            .tanh();
    }
    let mut p7 = Pair {
        a: ((r1[2] * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((y + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    p7 = (p7 + p7) * (y + S::from_f64(0.125)).tanh();
    p7 = p7.tamed();
    d = d + (((y * r1[1]) * (d - S::from_f64(0.375_f64)).tanh()) * S::from_f64(0.75)).sin();
    let b = program_2_of(
        (r1[1] + S::from_f64(0.125)).tanh(),
        ((p7.a * S::from_f64(0.375_f64)).max(S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let f = if (r1[2] * S::from_f64(-0.625_f64)).max(r1[1]).cmplt((-(b))) {
        (b + (d + r1[0]))
    } else {
        r1[0]
    };
    ((r1[0] * f) * S::from_f64(-0.125_f64)).abs() + f + b + d + y + x
}

#[differentiable]
fn program_18(x: f64, y: f64) -> f64 {
    let mut f = ((y * x) + 0.125).tanh();
    let mut r1 = [((y - y) + 0.125).tanh(); 2];
    let mut p2 = Pair { a: ((x + r1[1]) + 0.125).tanh(), b: ((-(f)) + 0.125).tanh() };
    f -= (((0.125_f64 + y) + (r1[1] * -1.125_f64).abs()) * 0.75).sin();
    let mut u3: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u3.push(((y * y + 0.25).sqrt() * 0.75).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let e = (mixed(&u3) + u3[0]).tanh();
    p2 = (p2 + p2) * ((y * -0.875_f64).abs() + 0.125).tanh();
    p2 = p2.tamed();
    f -= (((r1[0] * r1[0] + 0.25).sqrt() + e) + 0.125).tanh();
    if (y * r1[0]) > (-(f)) {
        p2 = -(p2
            - Pair {
                a: ((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin(),
                b: ((x + -0.375_f64).sin() * 0.75).sin(),
            })
        .tamed();
        p2 = p2.tamed();
    }
    let r4 = [((x / (1.5 + x * x)) * 0.75).sin(); 4];
    if (p2.a - 0.375_f64).tanh() < (-(x)) {
        let mut p5 =
            Pair { a: ((r1[1] + p2.b) * 0.75).sin(), b: ((f * 0.375_f64).max(y) + 0.125).tanh() };
        let g6 = |t: f64| ((e + r1[0]) + r4[3]) * t;
        let c = (g6((-(x))) + g6((-0.625_f64 * 0.375_f64).cos())).sin();
        if (r4[3] / (1.5 + 0.625_f64 * 0.625_f64)) > (r4[2] + 0.875_f64).sin() {
            return ((c * r4[3])
                / (1.5 + (e * -0.875_f64).max(r4[3]) * (e * -0.875_f64).max(r4[3])));
        }
    }
    let e = mixed(&r4[..1]).sin();
    p2 =
        (p2 * Pair {
            a: ((r1[1] / (1.5 + y * y)) * 0.75).sin(),
            b: ((r4[3] * -0.375_f64).abs() + 0.125).tanh(),
        } + Pair { a: ((x * -0.875_f64).cos() + 0.125).tanh(), b: (y * 0.75).sin() })
        .tamed();
    p2 = p2.tamed();
    ((f + x) - (-0.625_f64 - f)) + e + f + y + x
}

fn program_18_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y - y) + S::from_f64(0.125)).tanh(); 2];
    let mut p2 = Pair {
        a: ((x + r1[1]) + S::from_f64(0.125)).tanh(),
        b: ((-(f)) + S::from_f64(0.125)).tanh(),
    };
    f = f
        - (((S::from_f64(0.125_f64) + y) + (r1[1] * S::from_f64(-1.125_f64)).abs())
            * S::from_f64(0.75))
        .sin();
    let mut u3: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u3.push(((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let e = (mixed(&u3) + u3[0]).tanh();
    p2 = (p2 + p2) * ((y * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh();
    p2 = p2.tamed();
    f = f - (((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + e) + S::from_f64(0.125)).tanh();
    if (y * r1[0]).cmpgt((-(f))) {
        p2 = -(p2
            - Pair {
                a: ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                b: ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
            })
        .tamed();
        p2 = p2.tamed();
    }
    let r4 = [((x / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(); 4];
    if (p2.a - S::from_f64(0.375_f64)).tanh().cmplt((-(x))) {
        let mut p5 = Pair {
            a: ((r1[1] + p2.b) * S::from_f64(0.75)).sin(),
            b: ((f * S::from_f64(0.375_f64)).max(y) + S::from_f64(0.125)).tanh(),
        };
        let g6 = |t: S| ((e + r1[0]) + r4[3]) * t;
        let c = (g6((-(x))) + g6((S::from_f64(-0.625_f64) * S::from_f64(0.375_f64)).cos())).sin();
        if (r4[3] / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
            .cmpgt((r4[2] + S::from_f64(0.875_f64)).sin())
        {
            return ((c * r4[3])
                / (S::from_f64(1.5)
                    + (e * S::from_f64(-0.875_f64)).max(r4[3])
                        * (e * S::from_f64(-0.875_f64)).max(r4[3])));
        }
    }
    let e = mixed(&r4[..1]).sin();
    p2 =
        (p2 * Pair {
            a: ((r1[1] / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
            b: ((r4[3] * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        } + Pair {
            a: ((x * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
            b: (y * S::from_f64(0.75)).sin(),
        })
        .tamed();
    p2 = p2.tamed();
    ((f + x) - (S::from_f64(-0.625_f64) - f)) + e + f + y + x
}

#[differentiable]
fn program_19(x: f64, y: f64) -> f64 {
    let mut d = ((-0.875_f64 * -0.375_f64).max(x) * 0.75).sin();
    let mut r1 = [
        ((d + 0.625_f64).sin() + 0.125).tanh(),
        ((d - x) * 0.75).sin(),
        ((d * d + 0.25).sqrt() + 0.125).tanh(),
        ((y + d) + 0.125).tanh(),
        ((x - 0.125_f64).tanh() * 0.75).sin(),
    ];
    if 0.375_f64 >= (r1[0] * -0.375_f64).max(y) {
        return x;
    }
    if (y - r1[4]) < (r1[1] + d) {
        let b =
            program_7(((0.625_f64 + -0.375_f64).sin() * 0.75).sin(), (r1[0] + 0.125).tanh()).tanh();
        let (a, mut b) = (((d * d + 0.25).sqrt() + 0.125).tanh(), (y * -0.375_f64).abs());
    }
    d -= (((y * -0.875_f64).abs() * -1.125_f64).cos() * 0.75).sin();
    let mut p2 =
        Pair { a: ((-0.125_f64 * 0.625_f64).max(x) * 0.75).sin(), b: ((d * r1[4]) + 0.125).tanh() };
    let g3 = |t: f64| r1[0] * t;
    let b = (g3((r1[4] - -1.125_f64).tanh()) + g3((p2.b - r1[2]))).sin();
    let mut r4 = [
        (r1[0] * 0.75).sin(),
        ((p2.a * 0.875_f64).cos() * 0.75).sin(),
        ((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin(),
        (r1[3] * 0.75).sin(),
    ];
    r4[3] -= ((-(p2.b * y)) + 0.125).tanh();
    r1[0] += (((p2.b - p2.a) * (-(d))) * 0.75).sin();
    let mut r5 = [((x + b) * 0.75).sin(), (r1[4] * 0.75).sin()];
    let mut r6 = [(x + 0.125).tanh(); 4];
    let mut u7 = r5.to_vec();
    u7.push(((r6[2] * -1.125_f64).cos() * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let b = (mixed(&u7) + u7[0]).tanh();
    if b >= (b + r6[1]) {
        if (r1[0] + p2.b) <= (-(d)) {
            'l8: for i9 in (2..4_usize).step_by(2) {
                let d = root((((i9 as f64) * 0.25) - p2.a))
                    .map_or((y * y + 0.25).sqrt(), |v| ((0.375_f64 * -0.625_f64).max(p2.a) + x));
            }
            d -= (((p2.b * r6[2]) * (p2.b * r6[2]) + 0.25).sqrt() * 0.75).sin();
        }
    }
    (b * b + 0.25).sqrt() + b + d + y + x
}

fn program_19_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d =
        ((S::from_f64(-0.875_f64) * S::from_f64(-0.375_f64)).max(x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((d + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((d - x) * S::from_f64(0.75)).sin(),
        ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((y + d) + S::from_f64(0.125)).tanh(),
        ((x - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
    ];
    if S::from_f64(0.375_f64).cmpge((r1[0] * S::from_f64(-0.375_f64)).max(y)) {
        return x;
    }
    if (y - r1[4]).cmplt((r1[1] + d)) {
        let b = program_7_of(
            ((S::from_f64(0.625_f64) + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
            (r1[0] + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let (a, mut b) = (
            ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            (y * S::from_f64(-0.375_f64)).abs(),
        );
    }
    d = d
        - (((y * S::from_f64(-0.875_f64)).abs() * S::from_f64(-1.125_f64)).cos()
            * S::from_f64(0.75))
        .sin();
    let mut p2 = Pair {
        a: ((S::from_f64(-0.125_f64) * S::from_f64(0.625_f64)).max(x) * S::from_f64(0.75)).sin(),
        b: ((d * r1[4]) + S::from_f64(0.125)).tanh(),
    };
    let g3 = |t: S| r1[0] * t;
    let b = (g3((r1[4] - S::from_f64(-1.125_f64)).tanh()) + g3((p2.b - r1[2]))).sin();
    let mut r4 = [
        (r1[0] * S::from_f64(0.75)).sin(),
        ((p2.a * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (r1[3] * S::from_f64(0.75)).sin(),
    ];
    r4[3] = r4[3] - ((-(p2.b * y)) + S::from_f64(0.125)).tanh();
    r1[0] = r1[0] + (((p2.b - p2.a) * (-(d))) * S::from_f64(0.75)).sin();
    let mut r5 = [((x + b) * S::from_f64(0.75)).sin(), (r1[4] * S::from_f64(0.75)).sin()];
    let mut r6 = [(x + S::from_f64(0.125)).tanh(); 4];
    let mut u7 = r5.to_vec();
    u7.push(((r6[2] * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let b = (mixed(&u7) + u7[0]).tanh();
    if b.cmpge((b + r6[1])) {
        if (r1[0] + p2.b).cmple((-(d))) {
            'l8: for i9 in (2..4_usize).step_by(2) {
                let d = root(((S::from_f64(i9 as f64) * S::from_f64(0.25)) - p2.a))
                    .map_or((y * y + S::from_f64(0.25)).sqrt(), |v| {
                        ((S::from_f64(0.375_f64) * S::from_f64(-0.625_f64)).max(p2.a) + x)
                    });
            }
            d = d
                - (((p2.b * r6[2]) * (p2.b * r6[2]) + S::from_f64(0.25)).sqrt()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    (b * b + S::from_f64(0.25)).sqrt() + b + d + y + x
}

#[differentiable]
fn program_20(x: f64, y: f64) -> f64 {
    let mut f = ((x * x) + 0.125).tanh();
    let mut r1 = [
        ((f * 0.125_f64).abs() * 0.75).sin(),
        ((f + x) * 0.75).sin(),
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
    ];
    r1[2] = (f + 0.125).tanh();
    let mut e = ((r1[1] * 0.125_f64).max(x) + 0.125).tanh();
    let mut u2: Vec<_> = r1.iter().map(|v| *v * x).collect();
    u2.push(((x - -0.125_f64).tanh() + 0.125).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let a = match shape(((d * 0.375_f64).abs() + 0.125).tanh(), (0.625_f64 * 0.75).sin()) {
        Shape::Point => (d * -0.875_f64).abs(),
        Shape::Disc(v) => ((e * -0.125_f64).cos() * -0.875_f64).cos(),
        Shape::Box { w: v, h } => ((r1[0] * r1[0] + 0.25).sqrt() * 0.375_f64).abs(),
    };
    r1[0] -= (((-(0.625_f64)) * (x - -0.875_f64).tanh()) * 0.75).sin();
    let mut p3 = Pair { a: ((x - -1.125_f64).tanh() + 0.125).tanh(), b: (x + 0.125).tanh() };
    let d = mixed(&r1[..2]).sin();
    let c = program_13((d + 0.125).tanh(), (r1[0] + 0.125).tanh()).tanh();
    let (a, mut b) = (((c - p3.b) + 0.125).tanh(), (p3.b - e));
    let e = if (x * -0.625_f64).max(r1[1]) < (d * 0.125_f64) {
        ((e - f) * -0.375_f64).max(f)
    } else {
        r1[0]
    };
    r1[0] = (x + 0.125).tanh();
    let g4 = |t: f64| ((-(c)) - (a - 0.375_f64).tanh()) * t;
    let d = (g4((y * y)) + g4((0.875_f64 + 0.625_f64).sin())).sin();
    'l5: for i6 in 0..3_usize {
        r1[i6 % 3] = (((r1[2] + e) * (-(r1[(i6 + 1) % 3]))) + 0.125).tanh();
        f = (((((i6 as f64) * 0.25) - a) + 0.375_f64).sin() + 0.125).tanh();
        let b: f64 = r1.iter().map(|v| v * ((b * -0.625_f64).cos() + 0.125).tanh()).sum();
    }
    ((r1[0] * a) + x) + d + e + b + a + c + f + y + x
}

fn program_20_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((f * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ((f + x) * S::from_f64(0.75)).sin(),
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    ];
    r1[2] = (f + S::from_f64(0.125)).tanh();
    let mut e = ((r1[1] * S::from_f64(0.125_f64)).max(x) + S::from_f64(0.125)).tanh();
    let mut u2: Vec<_> = r1.iter().map(|v| *v * x).collect();
    u2.push(((x - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let a = match shape(
        ((d * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (d * S::from_f64(-0.875_f64)).abs(),
        Shape::Disc(v) => ((e * S::from_f64(-0.125_f64)).cos() * S::from_f64(-0.875_f64)).cos(),
        Shape::Box { w: v, h } => {
            ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.375_f64)).abs()
        }
    };
    r1[0] = r1[0]
        - (((-(S::from_f64(0.625_f64))) * (x - S::from_f64(-0.875_f64)).tanh())
            * S::from_f64(0.75))
        .sin();
    let mut p3 = Pair {
        a: ((x - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: (x + S::from_f64(0.125)).tanh(),
    };
    let d = mixed(&r1[..2]).sin();
    let c =
        program_13_of((d + S::from_f64(0.125)).tanh(), (r1[0] + S::from_f64(0.125)).tanh()).tanh();
    let (a, mut b) = (((c - p3.b) + S::from_f64(0.125)).tanh(), (p3.b - e));
    let e = if (x * S::from_f64(-0.625_f64)).max(r1[1]).cmplt((d * S::from_f64(0.125_f64))) {
        ((e - f) * S::from_f64(-0.375_f64)).max(f)
    } else {
        r1[0]
    };
    r1[0] = (x + S::from_f64(0.125)).tanh();
    let g4 = |t: S| ((-(c)) - (a - S::from_f64(0.375_f64)).tanh()) * t;
    let d = (g4((y * y)) + g4((S::from_f64(0.875_f64) + S::from_f64(0.625_f64)).sin())).sin();
    'l5: for i6 in 0..3_usize {
        r1[i6 % 3] = (((r1[2] + e) * (-(r1[(i6 + 1) % 3]))) + S::from_f64(0.125)).tanh();
        f = ((((S::from_f64(i6 as f64) * S::from_f64(0.25)) - a) + S::from_f64(0.375_f64)).sin()
            + S::from_f64(0.125))
        .tanh();
        let b = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((b * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh()
        });
    }
    ((r1[0] * a) + x) + d + e + b + a + c + f + y + x
}

#[differentiable]
fn program_21(x: f64, y: f64) -> f64 {
    let mut d = (x * 0.75).sin();
    let mut r1 = [((-(0.125_f64)) + 0.125).tanh(), ((d - x) * 0.75).sin()];
    d -= (((d * -1.125_f64).abs() + (x + d)) + 0.125).tanh();
    r1[0] = (((d / (1.5 + r1[1] * r1[1])) + (r1[1] - d)) * 0.75).sin();
    if (d - -0.375_f64).tanh() >= x {
        r1[0] = (((r1[1] + y) * -0.125_f64).abs() + 0.125).tanh();
        'l2: for i3 in (1..5_usize).step_by(2) {
            let mut p4 =
                Pair { a: (r1[i3 % 2] * 0.75).sin(), b: ((x * -0.125_f64).cos() * 0.75).sin() };
            d *= (((x + x) + (r1[1] * -0.875_f64)) * 0.75).sin();
            let d = p4
                .dot(&Pair {
                    a: ((x * 0.875_f64).cos() + 0.125).tanh(),
                    b: ((d + ((i3 as f64) * 0.25)) * 0.75).sin(),
                })
                .sin();
        }
        let mut p5 = Pair { a: (y * 0.75).sin(), b: ((r1[0] * y) + 0.125).tanh() };
    } else {
        r1[1] *= (x + 0.125).tanh();
    }
    let a = match roots((y + -0.125_f64), (x - d)) {
        Ok(v) => ((-(d)) * -0.125_f64).max(v),
        Err(true) => 0.125_f64,
        Err(_) => (d * x),
    };
    'l6: for i7 in 1..=0_usize {
        let g8 = |t: f64| ((r1[(i7 + 0) % 2] + r1[1]) + (d * 0.125_f64).cos()) * t;
        let f = (g8((d * d + 0.25).sqrt()) + g8((r1[(i7 * i7 + 1) % 2] * y))).sin();
        if i7 % 2 == 1 {
            let b = match roots(((i7 as f64) * 0.25), (0.625_f64 + -0.875_f64).sin()) {
                Ok(v) => ((f * 0.625_f64).abs() * -0.625_f64).abs(),
                Err(true) => -1.125_f64,
                Err(_) => (a + y),
            };
            for v in r1.iter() {
                d = d * ((x - r1[1]) * 0.75).sin() + *v * ((x - r1[1]) * 0.75).sin();
            }
            let mut p9 = Pair {
                a: ((-0.375_f64 * ((i7 as f64) * 0.25)) * 0.75).sin(),
                b: ((r1[0] - r1[i7 % 2]) + 0.125).tanh(),
            };
        }
    }
    ((x - 0.625_f64).tanh() - (r1[1] * -1.125_f64).cos()) + a + d + y + x
}

fn program_21_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((-(S::from_f64(0.125_f64))) + S::from_f64(0.125)).tanh(),
        ((d - x) * S::from_f64(0.75)).sin(),
    ];
    d = d - (((d * S::from_f64(-1.125_f64)).abs() + (x + d)) + S::from_f64(0.125)).tanh();
    r1[0] = (((d / (S::from_f64(1.5) + r1[1] * r1[1])) + (r1[1] - d)) * S::from_f64(0.75)).sin();
    if (d - S::from_f64(-0.375_f64)).tanh().cmpge(x) {
        r1[0] = (((r1[1] + y) * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh();
        'l2: for i3 in (1..5_usize).step_by(2) {
            let mut p4 = Pair {
                a: (r1[i3 % 2] * S::from_f64(0.75)).sin(),
                b: ((x * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            };
            d = d * (((x + x) + (r1[1] * S::from_f64(-0.875_f64))) * S::from_f64(0.75)).sin();
            let d = p4
                .dot(&Pair {
                    a: ((x * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
                    b: ((d + (S::from_f64(i3 as f64) * S::from_f64(0.25))) * S::from_f64(0.75))
                        .sin(),
                })
                .sin();
        }
        let mut p5 =
            Pair { a: (y * S::from_f64(0.75)).sin(), b: ((r1[0] * y) + S::from_f64(0.125)).tanh() };
    } else {
        r1[1] = r1[1] * (x + S::from_f64(0.125)).tanh();
    }
    let a = match roots((y + S::from_f64(-0.125_f64)), (x - d)) {
        Ok(v) => ((-(d)) * S::from_f64(-0.125_f64)).max(v),
        Err(true) => S::from_f64(0.125_f64),
        Err(_) => (d * x),
    };
    'l6: for i7 in 1..=0_usize {
        let g8 = |t: S| ((r1[(i7 + 0) % 2] + r1[1]) + (d * S::from_f64(0.125_f64)).cos()) * t;
        let f = (g8((d * d + S::from_f64(0.25)).sqrt()) + g8((r1[(i7 * i7 + 1) % 2] * y))).sin();
        if i7 % 2 == 1 {
            let b = match roots(
                (S::from_f64(i7 as f64) * S::from_f64(0.25)),
                (S::from_f64(0.625_f64) + S::from_f64(-0.875_f64)).sin(),
            ) {
                Ok(v) => ((f * S::from_f64(0.625_f64)).abs() * S::from_f64(-0.625_f64)).abs(),
                Err(true) => S::from_f64(-1.125_f64),
                Err(_) => (a + y),
            };
            for v in r1.iter() {
                d = d * ((x - r1[1]) * S::from_f64(0.75)).sin()
                    + *v * ((x - r1[1]) * S::from_f64(0.75)).sin();
            }
            let mut p9 = Pair {
                a: ((S::from_f64(-0.375_f64) * (S::from_f64(i7 as f64) * S::from_f64(0.25)))
                    * S::from_f64(0.75))
                .sin(),
                b: ((r1[0] - r1[i7 % 2]) + S::from_f64(0.125)).tanh(),
            };
        }
    }
    ((x - S::from_f64(0.625_f64)).tanh() - (r1[1] * S::from_f64(-1.125_f64)).cos()) + a + d + y + x
}

#[differentiable]
fn program_22(x: f64, y: f64) -> f64 {
    let mut e = ((y * y) * 0.75).sin();
    let mut r1 = [
        ((e - -0.875_f64).tanh() + 0.125).tanh(),
        ((y + y) + 0.125).tanh(),
        ((-(y)) + 0.125).tanh(),
        ((e - x) * 0.75).sin(),
    ];
    let by2 = ((e - r1[0]) + 0.125).tanh();
    let a = shifted(&mut r1[2..], by2);
    if r1[0] <= (-1.125_f64 * -0.125_f64).max(x) {
        let r3 = [(0.375_f64 + 0.125).tanh(); 3];
        let c = -1.125_f64;
        let mut p4 = Pair {
            a: ((r3[0] * 0.625_f64).abs() + 0.125).tanh(),
            b: ((y / (1.5 + x * x)) + 0.125).tanh(),
        };
    }
    let a = if (r1[1] - -0.625_f64).tanh() <= (-1.125_f64 * 0.875_f64) {
        ((x * 0.125_f64).max(r1[2]) + 0.125_f64).sin()
    } else {
        (-(e))
    };
    let mut p5 =
        Pair { a: ((x - -0.125_f64).tanh() + 0.125).tanh(), b: (-0.375_f64 + 0.125).tanh() };
    let mut r6 = [((x * x + 0.25).sqrt() * 0.75).sin(); 2];
    let e = match roots(0.625_f64, r1[2]) {
        Ok(v) => ((-(y)) + (e + 0.625_f64).sin()),
        Err(true) => x,
        Err(_) => (p5.b / (1.5 + -0.375_f64 * -0.375_f64)),
    };
    let f = if let Some(v) = root((-0.875_f64 + 0.875_f64).sin()) { v } else { r6[1] };
    'l7: for i8 in (2..2_usize).rev() {
        let e = program_1((-0.125_f64 + 0.125).tanh(), ((e + 0.375_f64) * 0.75).sin()).tanh();
        let mut c = ((((i8 as f64) * 0.25) * ((i8 as f64) * 0.25)) * 0.75).sin();
    }
    let (a, mut b) = (((r6[1] * r6[1] + 0.25).sqrt() * 0.75).sin(), x);
    ((y * 0.125_f64) - (y - 0.375_f64).tanh()) + b + a + f + e + y + x
}

fn program_22_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((e - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
        ((-(y)) + S::from_f64(0.125)).tanh(),
        ((e - x) * S::from_f64(0.75)).sin(),
    ];
    let by2 = ((e - r1[0]) + S::from_f64(0.125)).tanh();
    let a = shifted(&mut r1[2..], by2);
    if r1[0].cmple((S::from_f64(-1.125_f64) * S::from_f64(-0.125_f64)).max(x)) {
        let r3 = [(S::from_f64(0.375_f64) + S::from_f64(0.125)).tanh(); 3];
        let c = S::from_f64(-1.125_f64);
        let mut p4 = Pair {
            a: ((r3[0] * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            b: ((y / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        };
    }
    let a = if (r1[1] - S::from_f64(-0.625_f64))
        .tanh()
        .cmple((S::from_f64(-1.125_f64) * S::from_f64(0.875_f64)))
    {
        ((x * S::from_f64(0.125_f64)).max(r1[2]) + S::from_f64(0.125_f64)).sin()
    } else {
        (-(e))
    };
    let mut p5 = Pair {
        a: ((x - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: (S::from_f64(-0.375_f64) + S::from_f64(0.125)).tanh(),
    };
    let mut r6 = [((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(); 2];
    let e = match roots(S::from_f64(0.625_f64), r1[2]) {
        Ok(v) => ((-(y)) + (e + S::from_f64(0.625_f64)).sin()),
        Err(true) => x,
        Err(_) => (p5.b / (S::from_f64(1.5) + S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64))),
    };
    let f = if let Some(v) = root((S::from_f64(-0.875_f64) + S::from_f64(0.875_f64)).sin()) {
        v
    } else {
        r6[1]
    };
    'l7: for i8 in (2..2_usize).rev() {
        let e = program_1_of(
            (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh(),
            ((e + S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        )
        .tanh();
        let mut c = (((S::from_f64(i8 as f64) * S::from_f64(0.25))
            * (S::from_f64(i8 as f64) * S::from_f64(0.25)))
            * S::from_f64(0.75))
        .sin();
    }
    let (a, mut b) = (((r6[1] * r6[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(), x);
    ((y * S::from_f64(0.125_f64)) - (y - S::from_f64(0.375_f64)).tanh()) + b + a + f + e + y + x
}

#[differentiable]
fn program_23(x: f64, y: f64) -> f64 {
    let mut c = ((-(y)) * 0.75).sin();
    let mut r1 = [((-1.125_f64 * c) * 0.75).sin(); 2];
    let d = match shape(((y - 0.375_f64).tanh() * 0.75).sin(), ((-0.625_f64 + c) * 0.75).sin()) {
        Shape::Point => (y / (1.5 + r1[1] * r1[1])),
        Shape::Disc(v) => ((r1[0] * c) * (x * r1[0])),
        Shape::Box { w: v, h } => ((c * -1.125_f64).cos() * (r1[0] * 0.625_f64).abs()),
    };
    c -= (((y - r1[0]) - (r1[1] * r1[1] + 0.25).sqrt()) * 0.75).sin();
    let d = if (d * -0.875_f64).abs() > (r1[0] * 0.125_f64).cos() {
        ((y * -0.875_f64).abs() * -1.125_f64).abs()
    } else {
        (-(y / (1.5 + 0.625_f64 * 0.625_f64)))
    };
    let b = program_16(((d + x) + 0.125).tanh(), ((-0.625_f64 * 0.375_f64) * 0.75).sin()).tanh();
    let mut p2 = Pair {
        a: ((r1[1] * -1.125_f64).abs() + 0.125).tanh(),
        b: ((b + 0.375_f64).sin() * 0.75).sin(),
    };
    'l3: for i4 in 0..0_usize {
        let a = if i4 % 3 == 2 {
            ((r1[1] * 0.875_f64).cos() + (-1.125_f64 + 0.125_f64).sin())
        } else {
            (-(r1[1] * p2.a))
        };
        let mut r5 = [
            ((r1[0] * -0.375_f64).max(r1[(i4 * i4 + 1) % 2]) * 0.75).sin(),
            ((-(a)) + 0.125).tanh(),
            ((y * r1[(i4 + 0) % 2]) * 0.75).sin(),
            ((p2.a - y) * 0.75).sin(),
            ((c - r1[1]) * 0.75).sin(),
        ];
    }
    p2 = (p2 + p2) * ((r1[0] + c) * 0.75).sin();
    p2 = p2.tamed();
    let b = program_22(((x - 0.375_f64).tanh() + 0.125).tanh(), ((d + d) + 0.125).tanh()).tanh();
    if (r1[0] * 0.625_f64).abs() > (y + b) {
        return ((r1[0] - b) / (1.5 + (p2.b - y) * (p2.b - y)));
    }
    let by6 = ((x * r1[1]) + 0.125).tanh();
    let d = shifted(&mut r1[1..], by6);
    let d = mixed(&r1[..2]).sin();
    for v in r1.iter() {
        c = c * ((b * b + 0.25).sqrt() + 0.125).tanh()
            + *v * ((b * b + 0.25).sqrt() + 0.125).tanh();
    }
    ((r1[0] / (1.5 + r1[0] * r1[0])) * (r1[0] / (1.5 + r1[0] * r1[0])) + 0.25).sqrt()
        + d
        + b
        + c
        + y
        + x
}

fn program_23_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((-(y)) * S::from_f64(0.75)).sin();
    let mut r1 = [((S::from_f64(-1.125_f64) * c) * S::from_f64(0.75)).sin(); 2];
    let d = match shape(
        ((y - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.625_f64) + c) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (y / (S::from_f64(1.5) + r1[1] * r1[1])),
        Shape::Disc(v) => ((r1[0] * c) * (x * r1[0])),
        Shape::Box { w: v, h } => {
            ((c * S::from_f64(-1.125_f64)).cos() * (r1[0] * S::from_f64(0.625_f64)).abs())
        }
    };
    c = c - (((y - r1[0]) - (r1[1] * r1[1] + S::from_f64(0.25)).sqrt()) * S::from_f64(0.75)).sin();
    let d = if (d * S::from_f64(-0.875_f64)).abs().cmpgt((r1[0] * S::from_f64(0.125_f64)).cos()) {
        ((y * S::from_f64(-0.875_f64)).abs() * S::from_f64(-1.125_f64)).abs()
    } else {
        (-(y / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64))))
    };
    let b = program_16_of(
        ((d + x) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.625_f64) * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut p2 = Pair {
        a: ((r1[1] * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: ((b + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    'l3: for i4 in 0..0_usize {
        let a = if i4 % 3 == 2 {
            ((r1[1] * S::from_f64(0.875_f64)).cos()
                + (S::from_f64(-1.125_f64) + S::from_f64(0.125_f64)).sin())
        } else {
            (-(r1[1] * p2.a))
        };
        let mut r5 = [
            ((r1[0] * S::from_f64(-0.375_f64)).max(r1[(i4 * i4 + 1) % 2]) * S::from_f64(0.75))
                .sin(),
            ((-(a)) + S::from_f64(0.125)).tanh(),
            ((y * r1[(i4 + 0) % 2]) * S::from_f64(0.75)).sin(),
            ((p2.a - y) * S::from_f64(0.75)).sin(),
            ((c - r1[1]) * S::from_f64(0.75)).sin(),
        ];
    }
    p2 = (p2 + p2) * ((r1[0] + c) * S::from_f64(0.75)).sin();
    p2 = p2.tamed();
    let b = program_22_of(
        ((x - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((d + d) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    if (r1[0] * S::from_f64(0.625_f64)).abs().cmpgt((y + b)) {
        return ((r1[0] - b) / (S::from_f64(1.5) + (p2.b - y) * (p2.b - y)));
    }
    let by6 = ((x * r1[1]) + S::from_f64(0.125)).tanh();
    let d = shifted(&mut r1[1..], by6);
    let d = mixed(&r1[..2]).sin();
    for v in r1.iter() {
        c = c * ((b * b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh()
            + *v * ((b * b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    }
    ((r1[0] / (S::from_f64(1.5) + r1[0] * r1[0])) * (r1[0] / (S::from_f64(1.5) + r1[0] * r1[0]))
        + S::from_f64(0.25))
    .sqrt()
        + d
        + b
        + c
        + y
        + x
}

#[differentiable]
fn program_24(x: f64, y: f64) -> f64 {
    let mut e = ((x * y) + 0.125).tanh();
    let r1 = [((x + 0.125_f64).sin() + 0.125).tanh(); 5];
    let e = if r1[3] <= r1[3] {
        ((e * r1[2]) / (1.5 + (e * 0.625_f64).abs() * (e * 0.625_f64).abs()))
    } else {
        y
    };
    'l2: for i3 in (2..4_usize).rev() {
        'l4: for i5 in (i3..0_usize).step_by(2) {
            let mut c = (y + 0.125).tanh();
        }
    }
    let mut c = ((x / (1.5 + r1[1] * r1[1])) + 0.125).tanh();
    let mut p6 = Pair { a: ((e * 0.125_f64).cos() + 0.125).tanh(), b: ((y + y) * 0.75).sin() };
    let mut u7: Vec<_> = r1.iter().map(|v| *v * r1[4]).collect();
    u7.push(((r1[1] * -0.625_f64).abs() * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let a = (mixed(&u7) + u7[0]).tanh();
    if (x + a) >= (x * -0.875_f64).max(y) {
        return (-((y * y + 0.25).sqrt()));
    }
    let a = match shape(((e * 0.875_f64).abs() + 0.125).tanh(), ((-1.125_f64 * c) * 0.75).sin()) {
        Shape::Point => (r1[4] * y),
        Shape::Disc(v) => r1[4],
        Shape::Box { w: v, h } => (-((a * 0.375_f64).cos())),
    };
    if (r1[2] + c) <= (a * a + 0.25).sqrt() {
        return ((r1[2] - 0.875_f64).tanh()
            / (1.5
                + (0.375_f64 * -1.125_f64).max(-0.625_f64)
                    * (0.375_f64 * -1.125_f64).max(-0.625_f64)));
    }
    c -= (((a * -0.375_f64).cos() * (a * -0.375_f64).cos() + 0.25).sqrt() * 0.75).sin();
    p6.turn((r1[1] * 0.75).sin());
    p6 = p6.tamed();
    c += ((p6.b - -1.125_f64).tanh() * 0.75).sin();
    let mut r8 =
        [((y + -0.875_f64).sin() + 0.125).tanh(), ((y * c) * 0.75).sin(), ((y + a) + 0.125).tanh()];
    ((-(a)) + e) + a + c + e + y + x
}

fn program_24_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * y) + S::from_f64(0.125)).tanh();
    let r1 = [((x + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh(); 5];
    let e = if r1[3].cmple(r1[3]) {
        ((e * r1[2])
            / (S::from_f64(1.5)
                + (e * S::from_f64(0.625_f64)).abs() * (e * S::from_f64(0.625_f64)).abs()))
    } else {
        y
    };
    'l2: for i3 in (2..4_usize).rev() {
        'l4: for i5 in (i3..0_usize).step_by(2) {
            let mut c = (y + S::from_f64(0.125)).tanh();
        }
    }
    let mut c = ((x / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh();
    let mut p6 = Pair {
        a: ((e * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((y + y) * S::from_f64(0.75)).sin(),
    };
    let mut u7: Vec<_> = r1.iter().map(|v| *v * r1[4]).collect();
    u7.push(((r1[1] * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let a = (mixed(&u7) + u7[0]).tanh();
    if (x + a).cmpge((x * S::from_f64(-0.875_f64)).max(y)) {
        return (-((y * y + S::from_f64(0.25)).sqrt()));
    }
    let a = match shape(
        ((e * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-1.125_f64) * c) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (r1[4] * y),
        Shape::Disc(v) => r1[4],
        Shape::Box { w: v, h } => (-((a * S::from_f64(0.375_f64)).cos())),
    };
    if (r1[2] + c).cmple((a * a + S::from_f64(0.25)).sqrt()) {
        return ((r1[2] - S::from_f64(0.875_f64)).tanh()
            / (S::from_f64(1.5)
                + (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64))
                    .max(S::from_f64(-0.625_f64))
                    * (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64))
                        .max(S::from_f64(-0.625_f64))));
    }
    c = c
        - (((a * S::from_f64(-0.375_f64)).cos() * (a * S::from_f64(-0.375_f64)).cos()
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    p6.turn((r1[1] * S::from_f64(0.75)).sin());
    p6 = p6.tamed();
    c = c + ((p6.b - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r8 = [
        ((y + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y * c) * S::from_f64(0.75)).sin(),
        ((y + a) + S::from_f64(0.125)).tanh(),
    ];
    ((-(a)) + e) + a + c + e + y + x
}

#[differentiable]
fn program_25(x: f64, y: f64) -> f64 {
    let mut a = ((x * 0.125_f64).max(y) + 0.125).tanh();
    let r1 = [
        (a * 0.75).sin(),
        ((-0.875_f64 - -0.625_f64) + 0.125).tanh(),
        ((x * -0.875_f64).abs() * 0.75).sin(),
    ];
    if (0.375_f64 * 0.875_f64).max(r1[0]) >= (-(x)) {
        'l2: for i3 in (0..4_usize).rev() {
            let mut p4 = Pair {
                a: ((y * 0.625_f64).abs() + 0.125).tanh(),
                b: ((r1[(i3 * i3 + 1) % 3] - -1.125_f64) + 0.125).tanh(),
            };
            let mut a = ((-0.875_f64 * 0.375_f64).max(x) + 0.125).tanh();
        }
        if (y + r1[2]) <= x {
            if r1[2] <= (r1[2] + a) {
                a += ((r1[2] + (x * x)) + 0.125).tanh();
            } else {
                a = (((x * 0.625_f64).max(a) * (-0.875_f64 + 0.625_f64).sin()) + 0.125).tanh();
            }
            let d = if (-(0.375_f64)) <= (r1[0] + -0.125_f64).sin() {
                ((y + -1.125_f64) + r1[2])
            } else {
                ((r1[1] - -0.125_f64).tanh() * (r1[2] * -0.875_f64).max(-0.625_f64))
            };
        } else {
            a += (((x - y) / (1.5 + (a * -0.625_f64).cos() * (a * -0.625_f64).cos())) + 0.125)
                .tanh();
            a -= ((a * (r1[2] - y)) + 0.125).tanh();
        }
    } else {
        a -= (((r1[1] + r1[0]) * (x * -0.125_f64).abs()) * 0.75).sin();
    }
    if r1[2] <= (r1[0] * 0.125_f64).cos() {
        'l5: for i6 in (2..3_usize).rev() {
            'l7: for i8 in (i6..2_usize).step_by(2) {
                a *= (((y * x) + (a * -1.125_f64).abs()) + 0.125).tanh();
            }
            if i6 % 2 == 0 {
                a = (((0.625_f64 - -0.125_f64).tanh() * -0.875_f64).max(y) + 0.125).tanh();
            } else {
                a -= (((-0.875_f64 - 0.875_f64).tanh() * 0.875_f64).cos() + 0.125).tanh();
                let (a, mut b) = ((a * 0.75).sin(), a);
                b -= ((-(a * ((i6 as f64) * 0.25))) * 0.75).sin();
            }
        }
        a = (((r1[0] * a) - -0.875_f64).tanh() + 0.125).tanh();
        let d: f64 = r1.iter().map(|v| v * ((-(x)) * 0.75).sin()).sum();
    }
    (r1[0] * -0.375_f64).cos() + a + y + x
}

fn program_25_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(0.125_f64)).max(y) + S::from_f64(0.125)).tanh();
    let r1 = [
        (a * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.875_f64) - S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    if (S::from_f64(0.375_f64) * S::from_f64(0.875_f64)).max(r1[0]).cmpge((-(x))) {
        'l2: for i3 in (0..4_usize).rev() {
            let mut p4 = Pair {
                a: ((y * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
                b: ((r1[(i3 * i3 + 1) % 3] - S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
            };
            let mut a = ((S::from_f64(-0.875_f64) * S::from_f64(0.375_f64)).max(x)
                + S::from_f64(0.125))
            .tanh();
        }
        if (y + r1[2]).cmple(x) {
            if r1[2].cmple((r1[2] + a)) {
                a = a + ((r1[2] + (x * x)) + S::from_f64(0.125)).tanh();
            } else {
                a = (((x * S::from_f64(0.625_f64)).max(a)
                    * (S::from_f64(-0.875_f64) + S::from_f64(0.625_f64)).sin())
                    + S::from_f64(0.125))
                .tanh();
            }
            let d = if (-(S::from_f64(0.375_f64))).cmple((r1[0] + S::from_f64(-0.125_f64)).sin()) {
                ((y + S::from_f64(-1.125_f64)) + r1[2])
            } else {
                ((r1[1] - S::from_f64(-0.125_f64)).tanh()
                    * (r1[2] * S::from_f64(-0.875_f64)).max(S::from_f64(-0.625_f64)))
            };
        } else {
            a = a
                + (((x - y)
                    / (S::from_f64(1.5)
                        + (a * S::from_f64(-0.625_f64)).cos()
                            * (a * S::from_f64(-0.625_f64)).cos()))
                    + S::from_f64(0.125))
                .tanh();
            a = a - ((a * (r1[2] - y)) + S::from_f64(0.125)).tanh();
        }
    } else {
        a = a - (((r1[1] + r1[0]) * (x * S::from_f64(-0.125_f64)).abs()) * S::from_f64(0.75)).sin();
    }
    if r1[2].cmple((r1[0] * S::from_f64(0.125_f64)).cos()) {
        'l5: for i6 in (2..3_usize).rev() {
            'l7: for i8 in (i6..2_usize).step_by(2) {
                a = a
                    * (((y * x) + (a * S::from_f64(-1.125_f64)).abs()) + S::from_f64(0.125)).tanh();
            }
            if i6 % 2 == 0 {
                a = (((S::from_f64(0.625_f64) - S::from_f64(-0.125_f64)).tanh()
                    * S::from_f64(-0.875_f64))
                .max(y)
                    + S::from_f64(0.125))
                .tanh();
            } else {
                a = a
                    - (((S::from_f64(-0.875_f64) - S::from_f64(0.875_f64)).tanh()
                        * S::from_f64(0.875_f64))
                    .cos()
                        + S::from_f64(0.125))
                    .tanh();
                let (a, mut b) = ((a * S::from_f64(0.75)).sin(), a);
                b = b
                    - ((-(a * (S::from_f64(i6 as f64) * S::from_f64(0.25)))) * S::from_f64(0.75))
                        .sin();
            }
        }
        a = (((r1[0] * a) - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
        let d =
            r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * ((-(x)) * S::from_f64(0.75)).sin());
    }
    (r1[0] * S::from_f64(-0.375_f64)).cos() + a + y + x
}

#[differentiable]
fn program_26(x: f64, y: f64) -> f64 {
    let mut d = ((y * x) * 0.75).sin();
    let r1 = [
        ((y * x) * 0.75).sin(),
        ((x / (1.5 + y * y)) + 0.125).tanh(),
        ((d * y) + 0.125).tanh(),
        ((x * -0.125_f64).max(0.875_f64) * 0.75).sin(),
        ((d * d) * 0.75).sin(),
    ];
    'l2: for i3 in 2..=2_usize {
        d *= (((r1[1] * 0.375_f64)
            / (1.5 + (-1.125_f64 * 0.375_f64).max(y) * (-1.125_f64 * 0.375_f64).max(y)))
            + 0.125)
            .tanh();
        let mut c = (y * 0.75).sin();
        d *= (((((i3 as f64) * 0.25) / (1.5 + d * d)) - (-(c))) * 0.75).sin();
    }
    let a = if let Some(v) = root((d + 0.375_f64).sin()) { v } else { 0.875_f64 };
    'l4: for i5 in 1..=2_usize {
        let (a, mut b) = (((y * ((i5 as f64) * 0.25)) * 0.75).sin(), d);
        let mut p6 = Pair { a: ((r1[1] + b) * 0.75).sin(), b: ((b * r1[i5 % 5]) + 0.125).tanh() };
    }
    let r7 = [((d + y) * 0.75).sin(); 3];
    let f = ((r1[2] * -0.875_f64).max(x) * -1.125_f64).abs();
    if (d - r1[0]) > (d + -0.375_f64).sin() {
        return ((r7[0] * r7[0] + 0.25).sqrt() * -0.625_f64).abs();
    }
    if (d * d + 0.25).sqrt() >= (d * f) {
        d += (d + 0.125).tanh();
        let mut p8 = Pair { a: ((-(a)) + 0.125).tanh(), b: (-0.625_f64 + 0.125).tanh() };
        let mut f = ((r1[4] - r7[0]) * 0.75).sin();
    } else {
        if (d * 0.625_f64).max(r1[2]) < (r1[2] * -1.125_f64).abs() {
            let mut p9 = Pair {
                a: ((r7[2] * -0.875_f64).max(f) * 0.75).sin(),
                b: ((-(0.875_f64)) * 0.75).sin(),
            };
        } else {
            if a > (y - x) {
                return ((y / (1.5 + r7[2] * r7[2])) * (d * d));
            }
            d *= (((f * -1.125_f64).abs() * (f * -1.125_f64).abs() + 0.25).sqrt() + 0.125).tanh();
            let mut p10 = Pair {
                a: ((d * -0.125_f64).cos() + 0.125).tanh(),
                b: ((r1[0] * -0.125_f64).abs() * 0.75).sin(),
            };
        }
        d += (((r1[3] + y) * -1.125_f64).max(0.125_f64) * 0.75).sin();
    }
    ((d * 0.625_f64).max(y) * (d * 0.625_f64).max(y) + 0.25).sqrt() + f + a + d + y + x
}

fn program_26_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * x) * S::from_f64(0.75)).sin();
    let r1 = [
        ((y * x) * S::from_f64(0.75)).sin(),
        ((x / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        ((d * y) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.125_f64)).max(S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin(),
        ((d * d) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in 2..=2_usize {
        d = d
            * (((r1[1] * S::from_f64(0.375_f64))
                / (S::from_f64(1.5)
                    + (S::from_f64(-1.125_f64) * S::from_f64(0.375_f64)).max(y)
                        * (S::from_f64(-1.125_f64) * S::from_f64(0.375_f64)).max(y)))
                + S::from_f64(0.125))
            .tanh();
        let mut c = (y * S::from_f64(0.75)).sin();
        d = d
            * ((((S::from_f64(i3 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + d * d))
                - (-(c)))
                * S::from_f64(0.75))
            .sin();
    }
    let a = if let Some(v) = root((d + S::from_f64(0.375_f64)).sin()) {
        v
    } else {
        S::from_f64(0.875_f64)
    };
    'l4: for i5 in 1..=2_usize {
        let (a, mut b) =
            (((y * (S::from_f64(i5 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(), d);
        let mut p6 = Pair {
            a: ((r1[1] + b) * S::from_f64(0.75)).sin(),
            b: ((b * r1[i5 % 5]) + S::from_f64(0.125)).tanh(),
        };
    }
    let r7 = [((d + y) * S::from_f64(0.75)).sin(); 3];
    let f = ((r1[2] * S::from_f64(-0.875_f64)).max(x) * S::from_f64(-1.125_f64)).abs();
    if (d - r1[0]).cmpgt((d + S::from_f64(-0.375_f64)).sin()) {
        return ((r7[0] * r7[0] + S::from_f64(0.25)).sqrt() * S::from_f64(-0.625_f64)).abs();
    }
    if (d * d + S::from_f64(0.25)).sqrt().cmpge((d * f)) {
        d = d + (d + S::from_f64(0.125)).tanh();
        let mut p8 = Pair {
            a: ((-(a)) + S::from_f64(0.125)).tanh(),
            b: (S::from_f64(-0.625_f64) + S::from_f64(0.125)).tanh(),
        };
        let mut f = ((r1[4] - r7[0]) * S::from_f64(0.75)).sin();
    } else {
        if (d * S::from_f64(0.625_f64)).max(r1[2]).cmplt((r1[2] * S::from_f64(-1.125_f64)).abs()) {
            let mut p9 = Pair {
                a: ((r7[2] * S::from_f64(-0.875_f64)).max(f) * S::from_f64(0.75)).sin(),
                b: ((-(S::from_f64(0.875_f64))) * S::from_f64(0.75)).sin(),
            };
        } else {
            if a.cmpgt((y - x)) {
                return ((y / (S::from_f64(1.5) + r7[2] * r7[2])) * (d * d));
            }
            d = d
                * (((f * S::from_f64(-1.125_f64)).abs() * (f * S::from_f64(-1.125_f64)).abs()
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh();
            let mut p10 = Pair {
                a: ((d * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                b: ((r1[0] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
            };
        }
        d = d
            + (((r1[3] + y) * S::from_f64(-1.125_f64)).max(S::from_f64(0.125_f64))
                * S::from_f64(0.75))
            .sin();
    }
    ((d * S::from_f64(0.625_f64)).max(y) * (d * S::from_f64(0.625_f64)).max(y) + S::from_f64(0.25))
        .sqrt()
        + f
        + a
        + d
        + y
        + x
}

#[differentiable]
fn program_27(x: f64, y: f64) -> f64 {
    let mut f = ((y * -0.375_f64).max(x) + 0.125).tanh();
    let r1 = [((x * 0.625_f64).max(f) * 0.75).sin(); 4];
    if (y - f) <= y {
        return ((x * f) + 0.625_f64).sin();
    }
    let c = if (x * f) > (y + 0.625_f64).sin() { r1[0] } else { ((y + 0.125_f64).sin() * x) };
    f -= (((x * f) * -0.125_f64).abs() + 0.125).tanh();
    'l2: for i3 in (2..4_usize).step_by(2) {
        let c = match roots(
            (y * -0.875_f64).max(r1[i3 % 4]),
            (r1[(i3 * i3 + 1) % 4] + 0.125_f64).sin(),
        ) {
            Ok(v) => ((f * -0.375_f64) * 0.625_f64).cos(),
            Err(true) => -0.875_f64,
            Err(_) => (y - r1[i3 % 4]),
        };
        let mut p4 = Pair {
            a: ((0.625_f64 * 0.625_f64 + 0.25).sqrt() + 0.125).tanh(),
            b: ((c * 0.875_f64).abs() + 0.125).tanh(),
        };
    }
    f = ((-0.875_f64 * -0.875_f64).abs() * 0.75).sin();
    f *= (((-(y)) + (y * y + 0.25).sqrt()) + 0.125).tanh();
    let b = match shape(((r1[3] * 0.125_f64) + 0.125).tanh(), (r1[3] + 0.125).tanh()) {
        Shape::Point => (y * c),
        Shape::Disc(v) => ((x * x) * r1[0]),
        Shape::Box { w: v, h } => ((x * -0.875_f64).abs() + (r1[3] * r1[3] + 0.25).sqrt()),
    };
    'l5: for i6 in (0..1_usize).rev() {
        'l7: for i8 in i6..=4_usize {
            let d = match shape(
                ((((i6 as f64) * 0.25) * 0.875_f64).abs() * 0.75).sin(),
                ((c - x) * 0.75).sin(),
            ) {
                Shape::Point => (-0.875_f64 - 0.375_f64).tanh(),
                Shape::Disc(v) => ((-((i6 as f64) * 0.25)) + 0.875_f64).sin(),
                Shape::Box { w: v, h } => f,
            };
            let mut p9 =
                Pair { a: ((d * b) + 0.125).tanh(), b: ((r1[1] - r1[i6 % 4]) + 0.125).tanh() };
        }
        let (a, mut b) = (((x * -0.375_f64).cos() * 0.75).sin(), f);
        f += (-1.125_f64 + 0.125).tanh();
    }
    ((f - r1[1]) - (-0.875_f64 * 0.375_f64)) + b + c + f + y + x
}

fn program_27_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * S::from_f64(-0.375_f64)).max(x) + S::from_f64(0.125)).tanh();
    let r1 = [((x * S::from_f64(0.625_f64)).max(f) * S::from_f64(0.75)).sin(); 4];
    if (y - f).cmple(y) {
        return ((x * f) + S::from_f64(0.625_f64)).sin();
    }
    let c = if (x * f).cmpgt((y + S::from_f64(0.625_f64)).sin()) {
        r1[0]
    } else {
        ((y + S::from_f64(0.125_f64)).sin() * x)
    };
    f = f - (((x * f) * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    'l2: for i3 in (2..4_usize).step_by(2) {
        let c = match roots(
            (y * S::from_f64(-0.875_f64)).max(r1[i3 % 4]),
            (r1[(i3 * i3 + 1) % 4] + S::from_f64(0.125_f64)).sin(),
        ) {
            Ok(v) => ((f * S::from_f64(-0.375_f64)) * S::from_f64(0.625_f64)).cos(),
            Err(true) => S::from_f64(-0.875_f64),
            Err(_) => (y - r1[i3 % 4]),
        };
        let mut p4 = Pair {
            a: ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.125))
            .tanh(),
            b: ((c * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        };
    }
    f = ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin();
    f = f * (((-(y)) + (y * y + S::from_f64(0.25)).sqrt()) + S::from_f64(0.125)).tanh();
    let b = match shape(
        ((r1[3] * S::from_f64(0.125_f64)) + S::from_f64(0.125)).tanh(),
        (r1[3] + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (y * c),
        Shape::Disc(v) => ((x * x) * r1[0]),
        Shape::Box { w: v, h } => {
            ((x * S::from_f64(-0.875_f64)).abs() + (r1[3] * r1[3] + S::from_f64(0.25)).sqrt())
        }
    };
    'l5: for i6 in (0..1_usize).rev() {
        'l7: for i8 in i6..=4_usize {
            let d = match shape(
                (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(0.875_f64)).abs()
                    * S::from_f64(0.75))
                .sin(),
                ((c - x) * S::from_f64(0.75)).sin(),
            ) {
                Shape::Point => (S::from_f64(-0.875_f64) - S::from_f64(0.375_f64)).tanh(),
                Shape::Disc(v) => {
                    ((-(S::from_f64(i6 as f64) * S::from_f64(0.25))) + S::from_f64(0.875_f64)).sin()
                }
                Shape::Box { w: v, h } => f,
            };
            let mut p9 = Pair {
                a: ((d * b) + S::from_f64(0.125)).tanh(),
                b: ((r1[1] - r1[i6 % 4]) + S::from_f64(0.125)).tanh(),
            };
        }
        let (a, mut b) = (((x * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(), f);
        f = f + (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh();
    }
    ((f - r1[1]) - (S::from_f64(-0.875_f64) * S::from_f64(0.375_f64))) + b + c + f + y + x
}

#[differentiable]
fn program_28(x: f64, y: f64) -> f64 {
    let mut d = (x * 0.75).sin();
    let mut r1 = [
        (y + 0.125).tanh(),
        ((d - 0.625_f64) + 0.125).tanh(),
        ((x + -1.125_f64).sin() + 0.125).tanh(),
        ((y * x) + 0.125).tanh(),
        ((d + -0.625_f64).sin() * 0.75).sin(),
    ];
    if d < (y * 0.375_f64) {
        return (y * (x - x));
    }
    if (r1[0] * d) >= y {
        let mut f = ((x * -0.375_f64).cos() + 0.125).tanh();
        let mut p2 = Pair {
            a: ((x * -0.375_f64).abs() + 0.125).tanh(),
            b: ((r1[3] / (1.5 + f * f)) * 0.75).sin(),
        };
    } else {
        let mut p3 = Pair { a: ((d + x) + 0.125).tanh(), b: ((r1[4] - y) * 0.75).sin() };
        'l4: for i5 in 0..=1_usize {
            let (a, mut b) = (((d + ((i5 as f64) * 0.25)) * 0.75).sin(), (x + -0.875_f64).sin());
            #[differentiable(checkpoint)]
            'l6: for i7 in (2..3_usize).step_by(2) {
                let d = root((0.125_f64 * 0.125_f64 + 0.25).sqrt())
                    .map_or((x * 0.125_f64).max(y), |v| r1[(i5 * i5 + 1) % 5]);
            }
            let by8 = ((a * a) * 0.75).sin();
            let d = shifted(&mut r1[0..], by8);
        }
        let e = root((y * -0.875_f64).max(x))
            .map_or((r1[0] * -0.125_f64).cos(), |v| ((d * -0.125_f64).abs() * (p3.b * -0.125_f64)));
    }
    let e = mixed(&r1[3..]).sin();
    let f = mixed(&r1).sin();
    if (d * -0.375_f64).cos() < y {
        let mut p9 =
            Pair { a: ((d * d + 0.25).sqrt() * 0.75).sin(), b: ((e * -0.125_f64) * 0.75).sin() };
        d -= (((y + y) * (-0.125_f64 * e)) * 0.75).sin();
        let f = match root((r1[1] * r1[1] + 0.25).sqrt()) {
            Some(v) => ((f * f + 0.25).sqrt() * -0.375_f64).cos(),
            None => (r1[0] * 0.375_f64).abs(),
        };
    } else {
        if (e + r1[2]) <= (r1[2] + r1[3]) {
            let mut u10: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u10.push(((e * d) + 0.125).tanh());
            u10[0] = u10[1] * u10[u10.len() - 1];
            let a = (mixed(&u10) + u10[0]).tanh();
            let mut p11 = Pair { a: (r1[0] + 0.125).tanh(), b: ((y + r1[0]) + 0.125).tanh() };
        }
    }
    r1[4] + f + e + d + y + x
}

fn program_28_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x * S::from_f64(0.75)).sin();
    let mut r1 = [
        (y + S::from_f64(0.125)).tanh(),
        ((d - S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y * x) + S::from_f64(0.125)).tanh(),
        ((d + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    if d.cmplt((y * S::from_f64(0.375_f64))) {
        return (y * (x - x));
    }
    if (r1[0] * d).cmpge(y) {
        let mut f = ((x * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh();
        let mut p2 = Pair {
            a: ((x * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
            b: ((r1[3] / (S::from_f64(1.5) + f * f)) * S::from_f64(0.75)).sin(),
        };
    } else {
        let mut p3 = Pair {
            a: ((d + x) + S::from_f64(0.125)).tanh(),
            b: ((r1[4] - y) * S::from_f64(0.75)).sin(),
        };
        'l4: for i5 in 0..=1_usize {
            let (a, mut b) = (
                ((d + (S::from_f64(i5 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                (x + S::from_f64(-0.875_f64)).sin(),
            );

            'l6: for i7 in (2..3_usize).step_by(2) {
                let d = root(
                    (S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt(),
                )
                .map_or((x * S::from_f64(0.125_f64)).max(y), |v| r1[(i5 * i5 + 1) % 5]);
            }
            let by8 = ((a * a) * S::from_f64(0.75)).sin();
            let d = shifted(&mut r1[0..], by8);
        }
        let e = root((y * S::from_f64(-0.875_f64)).max(x))
            .map_or((r1[0] * S::from_f64(-0.125_f64)).cos(), |v| {
                ((d * S::from_f64(-0.125_f64)).abs() * (p3.b * S::from_f64(-0.125_f64)))
            });
    }
    let e = mixed(&r1[3..]).sin();
    let f = mixed(&r1).sin();
    if (d * S::from_f64(-0.375_f64)).cos().cmplt(y) {
        let mut p9 = Pair {
            a: ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            b: ((e * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        };
        d = d - (((y + y) * (S::from_f64(-0.125_f64) * e)) * S::from_f64(0.75)).sin();
        let f = match root((r1[1] * r1[1] + S::from_f64(0.25)).sqrt()) {
            Some(v) => ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(-0.375_f64)).cos(),
            None => (r1[0] * S::from_f64(0.375_f64)).abs(),
        };
    } else {
        if (e + r1[2]).cmple((r1[2] + r1[3])) {
            let mut u10: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u10.push(((e * d) + S::from_f64(0.125)).tanh());
            u10[0] = u10[1] * u10[u10.len() - 1];
            let a = (mixed(&u10) + u10[0]).tanh();
            let mut p11 = Pair {
                a: (r1[0] + S::from_f64(0.125)).tanh(),
                b: ((y + r1[0]) + S::from_f64(0.125)).tanh(),
            };
        }
    }
    r1[4] + f + e + d + y + x
}

#[differentiable]
fn program_29(x: f64, y: f64) -> f64 {
    let mut f = (x * 0.75).sin();
    let mut r1 = [
        ((x + y) * 0.75).sin(),
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
        ((x * f) * 0.75).sin(),
        ((y * -0.125_f64).abs() + 0.125).tanh(),
    ];
    let mut p2 = Pair { a: ((r1[1] + y) + 0.125).tanh(), b: ((-(r1[0])) * 0.75).sin() };
    let mut p3 = Pair {
        a: ((r1[0] * -0.875_f64).cos() + 0.125).tanh(),
        b: ((f * 0.125_f64).max(r1[2]) * 0.75).sin(),
    };
    if (f * f + 0.25).sqrt() > (r1[3] + r1[2]) {
        p2 += Pair { a: (f * 0.75).sin(), b: ((p2.b + r1[0]) * 0.75).sin() };
        p2 = p2.tamed();
    } else {
        if (r1[3] - 0.375_f64) <= (f * -0.875_f64) {
            r1[1] *= (((y - -0.125_f64).tanh() - -0.625_f64).tanh() + 0.125).tanh();
        }
        let mut r4 = [
            ((y - -0.125_f64).tanh() + 0.125).tanh(),
            ((f * -0.125_f64).cos() * 0.75).sin(),
            ((-(y)) + 0.125).tanh(),
            ((y - r1[1]) * 0.75).sin(),
            ((-(y)) + 0.125).tanh(),
        ];
    }
    let e = program_28(
        ((-0.875_f64 * -1.125_f64).cos() + 0.125).tanh(),
        ((p3.b * 0.875_f64).abs() + 0.125).tanh(),
    )
    .tanh();
    let mut r5 = [(x * 0.75).sin(); 2];
    let mut u6: Vec<_> = r5.iter().map(|v| *v * r1[1]).collect();
    u6.push(((p3.b * 0.375_f64).abs() * 0.75).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let d = (mixed(&u6) + u6[0]).tanh();
    f = (((r5[0] * r1[2])
        / (1.5
            + (p3.b / (1.5 + -1.125_f64 * -1.125_f64))
                * (p3.b / (1.5 + -1.125_f64 * -1.125_f64))))
        + 0.125)
        .tanh();
    let a = if (r5[0] * -0.125_f64).cos() >= (-(x)) {
        (-((r1[0] + -0.375_f64).sin()))
    } else {
        ((e - 0.125_f64).tanh() * -0.625_f64).cos()
    };
    let mut r7 = [
        ((0.625_f64 * 0.375_f64).abs() * 0.75).sin(),
        ((-1.125_f64 * 0.875_f64).max(p3.b) * 0.75).sin(),
        (a * 0.75).sin(),
        (x + 0.125).tanh(),
        ((y * 0.125_f64).max(x) + 0.125).tanh(),
    ];
    let by8 = ((a * y) + 0.125).tanh();
    let c = shifted(&mut r7[4..], by8);
    ((r1[3] * r1[3] + 0.25).sqrt() - -0.375_f64).tanh() + c + a + d + e + f + y + x
}

fn program_29_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x + y) * S::from_f64(0.75)).sin(),
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * f) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    ];
    let mut p2 = Pair {
        a: ((r1[1] + y) + S::from_f64(0.125)).tanh(),
        b: ((-(r1[0])) * S::from_f64(0.75)).sin(),
    };
    let mut p3 = Pair {
        a: ((r1[0] * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((f * S::from_f64(0.125_f64)).max(r1[2]) * S::from_f64(0.75)).sin(),
    };
    if (f * f + S::from_f64(0.25)).sqrt().cmpgt((r1[3] + r1[2])) {
        p2 += Pair {
            a: (f * S::from_f64(0.75)).sin(),
            b: ((p2.b + r1[0]) * S::from_f64(0.75)).sin(),
        };
        p2 = p2.tamed();
    } else {
        if (r1[3] - S::from_f64(0.375_f64)).cmple((f * S::from_f64(-0.875_f64))) {
            r1[1] = r1[1]
                * (((y - S::from_f64(-0.125_f64)).tanh() - S::from_f64(-0.625_f64)).tanh()
                    + S::from_f64(0.125))
                .tanh();
        }
        let mut r4 = [
            ((y - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            ((f * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            ((-(y)) + S::from_f64(0.125)).tanh(),
            ((y - r1[1]) * S::from_f64(0.75)).sin(),
            ((-(y)) + S::from_f64(0.125)).tanh(),
        ];
    }
    let e = program_28_of(
        ((S::from_f64(-0.875_f64) * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((p3.b * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut r5 = [(x * S::from_f64(0.75)).sin(); 2];
    let mut u6: Vec<_> = r5.iter().map(|v| *v * r1[1]).collect();
    u6.push(((p3.b * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let d = (mixed(&u6) + u6[0]).tanh();
    f = (((r5[0] * r1[2])
        / (S::from_f64(1.5)
            + (p3.b / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
                * (p3.b
                    / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))))
        + S::from_f64(0.125))
    .tanh();
    let a = if (r5[0] * S::from_f64(-0.125_f64)).cos().cmpge((-(x))) {
        (-((r1[0] + S::from_f64(-0.375_f64)).sin()))
    } else {
        ((e - S::from_f64(0.125_f64)).tanh() * S::from_f64(-0.625_f64)).cos()
    };
    let mut r7 = [
        ((S::from_f64(0.625_f64) * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-1.125_f64) * S::from_f64(0.875_f64)).max(p3.b) * S::from_f64(0.75)).sin(),
        (a * S::from_f64(0.75)).sin(),
        (x + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(0.125_f64)).max(x) + S::from_f64(0.125)).tanh(),
    ];
    let by8 = ((a * y) + S::from_f64(0.125)).tanh();
    let c = shifted(&mut r7[4..], by8);
    ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() - S::from_f64(-0.375_f64)).tanh()
        + c
        + a
        + d
        + e
        + f
        + y
        + x
}

#[differentiable]
fn program_30(x: f64, y: f64) -> f64 {
    let mut d = ((y * x) * 0.75).sin();
    let mut r1 = [(0.875_f64 + 0.125).tanh(); 3];
    'l2: for i3 in (2..3_usize).rev() {
        let mut p4 = Pair {
            a: ((r1[i3 % 3] - y) + 0.125).tanh(),
            b: ((r1[1] * ((i3 as f64) * 0.25)) * 0.75).sin(),
        };
    }
    d *= (((x - 0.625_f64).tanh() * (x - 0.625_f64).tanh() + 0.25).sqrt() + 0.125).tanh();
    if (y + y) >= (r1[2] - -0.625_f64).tanh() {
        r1[0] *= (((r1[0] + d) + -0.625_f64).sin() + 0.125).tanh();
        let mut u5: Vec<_> = r1.iter().map(|v| *v * x).collect();
        u5.push(((r1[1] * 0.125_f64).cos() * 0.75).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let e = (mixed(&u5) + u5[0]).tanh();
        'l6: for i7 in (1..3_usize).rev() {
            let d = ((x * x + 0.25).sqrt() + -0.875_f64).sin();
            let mut f = ((((i7 as f64) * 0.25) + y) + 0.125).tanh();
        }
    } else {
        let r8 = [
            ((d + y) + 0.125).tanh(),
            ((r1[2] * 0.875_f64).abs() * 0.75).sin(),
            ((y + d) * 0.75).sin(),
            (d * 0.75).sin(),
        ];
        'l9: for i10 in 2..=1_usize {
            d = (((r1[(i10 * i10 + 1) % 3] + r8[(i10 * i10 + 1) % 4]) + -0.625_f64).sin() * 0.75)
                .sin();
            let c = match shape((d + 0.125).tanh(), ((r1[(i10 * i10 + 1) % 3] * d) * 0.75).sin()) {
                Shape::Point => (((i10 as f64) * 0.25) * -1.125_f64).cos(),
                Shape::Disc(v) => d,
                Shape::Box { w: v, h } => (y * y),
            };
            let c = ((d * c) + (c / (1.5 + ((i10 as f64) * 0.25) * ((i10 as f64) * 0.25))));
        }
    }
    ((-(d)) * 0.125_f64).abs() + d + y + x
}

fn program_30_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * x) * S::from_f64(0.75)).sin();
    let mut r1 = [(S::from_f64(0.875_f64) + S::from_f64(0.125)).tanh(); 3];
    'l2: for i3 in (2..3_usize).rev() {
        let mut p4 = Pair {
            a: ((r1[i3 % 3] - y) + S::from_f64(0.125)).tanh(),
            b: ((r1[1] * (S::from_f64(i3 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
        };
    }
    d = d
        * (((x - S::from_f64(0.625_f64)).tanh() * (x - S::from_f64(0.625_f64)).tanh()
            + S::from_f64(0.25))
        .sqrt()
            + S::from_f64(0.125))
        .tanh();
    if (y + y).cmpge((r1[2] - S::from_f64(-0.625_f64)).tanh()) {
        r1[0] = r1[0] * (((r1[0] + d) + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh();
        let mut u5: Vec<_> = r1.iter().map(|v| *v * x).collect();
        u5.push(((r1[1] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let e = (mixed(&u5) + u5[0]).tanh();
        'l6: for i7 in (1..3_usize).rev() {
            let d = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(-0.875_f64)).sin();
            let mut f =
                (((S::from_f64(i7 as f64) * S::from_f64(0.25)) + y) + S::from_f64(0.125)).tanh();
        }
    } else {
        let r8 = [
            ((d + y) + S::from_f64(0.125)).tanh(),
            ((r1[2] * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
            ((y + d) * S::from_f64(0.75)).sin(),
            (d * S::from_f64(0.75)).sin(),
        ];
        'l9: for i10 in 2..=1_usize {
            d = (((r1[(i10 * i10 + 1) % 3] + r8[(i10 * i10 + 1) % 4]) + S::from_f64(-0.625_f64))
                .sin()
                * S::from_f64(0.75))
            .sin();
            let c = match shape(
                (d + S::from_f64(0.125)).tanh(),
                ((r1[(i10 * i10 + 1) % 3] * d) * S::from_f64(0.75)).sin(),
            ) {
                Shape::Point => {
                    ((S::from_f64(i10 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)).cos()
                }
                Shape::Disc(v) => d,
                Shape::Box { w: v, h } => (y * y),
            };
            let c = ((d * c)
                + (c / (S::from_f64(1.5)
                    + (S::from_f64(i10 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i10 as f64) * S::from_f64(0.25)))));
        }
    }
    ((-(d)) * S::from_f64(0.125_f64)).abs() + d + y + x
}

#[differentiable]
fn program_31(x: f64, y: f64) -> f64 {
    let mut e = ((y - 0.875_f64).tanh() + 0.125).tanh();
    let mut r1 = [
        (0.125_f64 + 0.125).tanh(),
        (x * 0.75).sin(),
        ((-1.125_f64 + 0.875_f64).sin() + 0.125).tanh(),
        ((-(-0.875_f64)) + 0.125).tanh(),
    ];
    let mut p2 = Pair { a: ((r1[3] * 0.375_f64).max(r1[2]) * 0.75).sin(), b: (x * 0.75).sin() };
    let mut b = ((r1[1] - 0.375_f64).tanh() * 0.75).sin();
    r1[0] = (((x - x) - (b - b)) + 0.125).tanh();
    for v in r1.iter() {
        b = b * ((r1[0] + 0.875_f64).sin() * 0.75).sin()
            + *v * ((r1[0] + 0.875_f64).sin() * 0.75).sin();
    }
    let r3 = [((e * -0.125_f64).cos() + 0.125).tanh(), ((-(r1[3])) + 0.125).tanh()];
    'l4: for i5 in 1..=5_usize {
        let (a, mut b) = (((r1[(i5 + 1) % 4] * y) + 0.125).tanh(), (x - 0.125_f64));
        'l6: for i7 in 0..0_usize {
            let b = ((r3[i7 % 2] * 0.625_f64).max(r3[(i7 * i7 + 1) % 2])
                * (r3[(i7 * i7 + 1) % 2] * -0.125_f64).abs());
        }
    }
    let b = ((-0.375_f64 * -0.375_f64 + 0.25).sqrt() + (b * -0.625_f64).abs());
    p2.turn(((r3[1] / (1.5 + e * e)) * 0.75).sin());
    p2 = p2.tamed();
    e -= (y * 0.75).sin();
    let b = mixed(&r1[..4]).sin();
    let e = p2.dot(&p2).sin();
    ((p2.a * r3[0]) * (r3[0] * r1[1])) + e + b + y + x
}

fn program_31_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh(),
        (x * S::from_f64(0.75)).sin(),
        ((S::from_f64(-1.125_f64) + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((-(S::from_f64(-0.875_f64))) + S::from_f64(0.125)).tanh(),
    ];
    let mut p2 = Pair {
        a: ((r1[3] * S::from_f64(0.375_f64)).max(r1[2]) * S::from_f64(0.75)).sin(),
        b: (x * S::from_f64(0.75)).sin(),
    };
    let mut b = ((r1[1] - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    r1[0] = (((x - x) - (b - b)) + S::from_f64(0.125)).tanh();
    for v in r1.iter() {
        b = b * ((r1[0] + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin()
            + *v * ((r1[0] + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin();
    }
    let r3 = [
        ((e * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((-(r1[3])) + S::from_f64(0.125)).tanh(),
    ];
    'l4: for i5 in 1..=5_usize {
        let (a, mut b) =
            (((r1[(i5 + 1) % 4] * y) + S::from_f64(0.125)).tanh(), (x - S::from_f64(0.125_f64)));
        'l6: for i7 in 0..0_usize {
            let b = ((r3[i7 % 2] * S::from_f64(0.625_f64)).max(r3[(i7 * i7 + 1) % 2])
                * (r3[(i7 * i7 + 1) % 2] * S::from_f64(-0.125_f64)).abs());
        }
    }
    let b = ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt()
        + (b * S::from_f64(-0.625_f64)).abs());
    p2.turn(((r3[1] / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75)).sin());
    p2 = p2.tamed();
    e = e - (y * S::from_f64(0.75)).sin();
    let b = mixed(&r1[..4]).sin();
    let e = p2.dot(&p2).sin();
    ((p2.a * r3[0]) * (r3[0] * r1[1])) + e + b + y + x
}

#[differentiable]
fn program_32(x: f64, y: f64) -> f64 {
    let mut a = ((x * y) + 0.125).tanh();
    let r1 = [
        ((-(x)) * 0.75).sin(),
        (0.875_f64 + 0.125).tanh(),
        ((-(y)) + 0.125).tanh(),
        ((x * 0.125_f64).cos() + 0.125).tanh(),
    ];
    let mut r2 = [
        ((r1[0] * r1[0] + 0.25).sqrt() * 0.75).sin(),
        ((r1[3] * r1[2]) * 0.75).sin(),
        ((a * -0.375_f64).max(x) + 0.125).tanh(),
        ((x + -1.125_f64).sin() * 0.75).sin(),
    ];
    r2[0] = (((-(r2[1])) - (-(x))) + 0.125).tanh();
    let a = match shape(((a * y) + 0.125).tanh(), ((r1[2] - y) + 0.125).tanh()) {
        Shape::Point => (r1[2] + a),
        Shape::Disc(v) => ((x * r2[0]) * (-(r1[2]))),
        Shape::Box { w: v, h } => (y - 0.375_f64).tanh(),
    };
    let mut e = ((x * 0.625_f64).abs() + 0.125).tanh();
    let c = match roots((r1[0] + r2[0]), (r2[1] - r1[1])) {
        Ok(v) => ((x * x + 0.25).sqrt() * (e * e + 0.25).sqrt()),
        Err(true) => r2[3],
        Err(_) => (x + r2[0]),
    };
    let mut n4 = 0_usize;
    'l3: while n4 < 4 {
        n4 += 1;
        let mut p5 =
            Pair { a: (c * 0.75).sin(), b: ((c * -0.125_f64).max(r1[n4 % 4]) * 0.75).sin() };
        let mut n7 = 0_usize;
        'l6: while n7 < 3 {
            n7 += 1;
            let (a, mut b) = (((a - -1.125_f64).tanh() + 0.125).tanh(), (-(p5.b)));
            r2[(n4 + 2) % 4] = (c + 0.125).tanh();
        }
        e -= (((c + r2[n4 % 4]) + (y + 0.625_f64).sin()) * 0.75).sin();
    }
    let c: f64 = r2.iter().map(|v| v * ((c + 0.875_f64).sin() * 0.75).sin()).sum();
    let mut p8 = Pair {
        a: ((r2[2] - -0.875_f64).tanh() * 0.75).sin(),
        b: ((r2[0] / (1.5 + e * e)) * 0.75).sin(),
    };
    #[differentiable(checkpoint)]
    'l9: for i10 in (0..5_usize).step_by(2) {
        let (a, mut b) = (((r1[0] + -1.125_f64).sin() + 0.125).tanh(), (a - -0.875_f64).tanh());
        'l11: for i12 in i10..1_usize {
            let mut c = ((-0.375_f64 * -0.125_f64).max(0.625_f64) * 0.75).sin();
        }
    }
    ((-(y)) - -0.625_f64).tanh() + c + e + a + y + x
}

fn program_32_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * y) + S::from_f64(0.125)).tanh();
    let r1 = [
        ((-(x)) * S::from_f64(0.75)).sin(),
        (S::from_f64(0.875_f64) + S::from_f64(0.125)).tanh(),
        ((-(y)) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut r2 = [
        ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((r1[3] * r1[2]) * S::from_f64(0.75)).sin(),
        ((a * S::from_f64(-0.375_f64)).max(x) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    r2[0] = (((-(r2[1])) - (-(x))) + S::from_f64(0.125)).tanh();
    let a = match shape(
        ((a * y) + S::from_f64(0.125)).tanh(),
        ((r1[2] - y) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r1[2] + a),
        Shape::Disc(v) => ((x * r2[0]) * (-(r1[2]))),
        Shape::Box { w: v, h } => (y - S::from_f64(0.375_f64)).tanh(),
    };
    let mut e = ((x * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh();
    let c = match roots((r1[0] + r2[0]), (r2[1] - r1[1])) {
        Ok(v) => ((x * x + S::from_f64(0.25)).sqrt() * (e * e + S::from_f64(0.25)).sqrt()),
        Err(true) => r2[3],
        Err(_) => (x + r2[0]),
    };
    let mut n4 = 0_usize;
    'l3: while n4 < 4 {
        n4 += 1;
        let mut p5 = Pair {
            a: (c * S::from_f64(0.75)).sin(),
            b: ((c * S::from_f64(-0.125_f64)).max(r1[n4 % 4]) * S::from_f64(0.75)).sin(),
        };
        let mut n7 = 0_usize;
        'l6: while n7 < 3 {
            n7 += 1;
            let (a, mut b) =
                (((a - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(), (-(p5.b)));
            r2[(n4 + 2) % 4] = (c + S::from_f64(0.125)).tanh();
        }
        e = e - (((c + r2[n4 % 4]) + (y + S::from_f64(0.625_f64)).sin()) * S::from_f64(0.75)).sin();
    }
    let c = r2.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((c + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin()
    });
    let mut p8 = Pair {
        a: ((r2[2] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: ((r2[0] / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75)).sin(),
    };

    'l9: for i10 in (0..5_usize).step_by(2) {
        let (a, mut b) = (
            ((r1[0] + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
            (a - S::from_f64(-0.875_f64)).tanh(),
        );
        'l11: for i12 in i10..1_usize {
            let mut c = ((S::from_f64(-0.375_f64) * S::from_f64(-0.125_f64))
                .max(S::from_f64(0.625_f64))
                * S::from_f64(0.75))
            .sin();
        }
    }
    ((-(y)) - S::from_f64(-0.625_f64)).tanh() + c + e + a + y + x
}

#[differentiable]
fn program_33(x: f64, y: f64) -> f64 {
    let mut e = ((x * 0.125_f64).max(y) * 0.75).sin();
    let mut r1 = [((-0.375_f64 * -0.125_f64) * 0.75).sin(); 2];
    e = (((x * x + 0.25).sqrt() - -0.875_f64).tanh() + 0.125).tanh();
    let mut p2 = Pair { a: ((y * r1[1]) * 0.75).sin(), b: ((y + y) + 0.125).tanh() };
    for v in r1.iter() {
        e = e * (0.875_f64 * 0.75).sin() + *v * (0.875_f64 * 0.75).sin();
    }
    let d = match shape(((p2.a - p2.b) + 0.125).tanh(), ((x * r1[0]) + 0.125).tanh()) {
        Shape::Point => (x - -0.125_f64).tanh(),
        Shape::Disc(v) => ((r1[0] - r1[0]) - 0.875_f64).tanh(),
        Shape::Box { w: v, h } => (-((e * -0.625_f64).abs())),
    };
    'l3: for i4 in (1..1_usize).rev() {
        let f = match roots(r1[i4 % 2], (-(y))) {
            Ok(v) => r1[(i4 * i4 + 1) % 2],
            Err(true) => r1[(i4 * i4 + 1) % 2],
            Err(_) => (d + r1[0]),
        };
    }
    let (a, mut b) = (((y - -0.125_f64).tanh() + 0.125).tanh(), (-(p2.a)));
    #[differentiable(checkpoint)]
    'l5: for i6 in (0..0_usize).step_by(2) {
        let by7 = ((((i6 as f64) * 0.25) * -1.125_f64).abs() + 0.125).tanh();
        let c = shifted(&mut r1[1..], by7);
        if (p2.b * r1[i6 % 2]) <= (p2.a * -0.625_f64).cos() {
            let by8 = ((p2.a * x) + 0.125).tanh();
            let e = shifted(&mut r1[1..], by8);
            r1[i6 % 2] *= (((r1[(i6 + 1) % 2] * b) - 0.125_f64).tanh() + 0.125).tanh();
            let mut d = ((r1[0] + -0.125_f64).sin() + 0.125).tanh();
        } else {
            let (a, mut b) = (((-(r1[0])) * 0.75).sin(), (d * d + 0.25).sqrt());
        }
    }
    e + b + a + d + e + y + x
}

fn program_33_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(0.125_f64)).max(y) * S::from_f64(0.75)).sin();
    let mut r1 =
        [((S::from_f64(-0.375_f64) * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(); 2];
    e = (((x * x + S::from_f64(0.25)).sqrt() - S::from_f64(-0.875_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    let mut p2 = Pair {
        a: ((y * r1[1]) * S::from_f64(0.75)).sin(),
        b: ((y + y) + S::from_f64(0.125)).tanh(),
    };
    for v in r1.iter() {
        e = e * (S::from_f64(0.875_f64) * S::from_f64(0.75)).sin()
            + *v * (S::from_f64(0.875_f64) * S::from_f64(0.75)).sin();
    }
    let d = match shape(
        ((p2.a - p2.b) + S::from_f64(0.125)).tanh(),
        ((x * r1[0]) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (x - S::from_f64(-0.125_f64)).tanh(),
        Shape::Disc(v) => ((r1[0] - r1[0]) - S::from_f64(0.875_f64)).tanh(),
        Shape::Box { w: v, h } => (-((e * S::from_f64(-0.625_f64)).abs())),
    };
    'l3: for i4 in (1..1_usize).rev() {
        let f = match roots(r1[i4 % 2], (-(y))) {
            Ok(v) => r1[(i4 * i4 + 1) % 2],
            Err(true) => r1[(i4 * i4 + 1) % 2],
            Err(_) => (d + r1[0]),
        };
    }
    let (a, mut b) =
        (((y - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(), (-(p2.a)));

    'l5: for i6 in (0..0_usize).step_by(2) {
        let by7 = (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)).abs()
            + S::from_f64(0.125))
        .tanh();
        let c = shifted(&mut r1[1..], by7);
        if (p2.b * r1[i6 % 2]).cmple((p2.a * S::from_f64(-0.625_f64)).cos()) {
            let by8 = ((p2.a * x) + S::from_f64(0.125)).tanh();
            let e = shifted(&mut r1[1..], by8);
            r1[i6 % 2] = r1[i6 % 2]
                * (((r1[(i6 + 1) % 2] * b) - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125))
                    .tanh();
            let mut d = ((r1[0] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh();
        } else {
            let (a, mut b) =
                (((-(r1[0])) * S::from_f64(0.75)).sin(), (d * d + S::from_f64(0.25)).sqrt());
        }
    }
    e + b + a + d + e + y + x
}

#[differentiable]
fn program_34(x: f64, y: f64) -> f64 {
    let mut a = ((y * y) * 0.75).sin();
    let mut r1 = [
        ((a * a + 0.25).sqrt() + 0.125).tanh(),
        ((x + -0.375_f64).sin() * 0.75).sin(),
        ((y * y) + 0.125).tanh(),
        ((a / (1.5 + a * a)) * 0.75).sin(),
    ];
    let mut p2 = Pair {
        a: ((r1[3] + 0.875_f64).sin() + 0.125).tanh(),
        b: ((r1[2] * 0.125_f64).max(r1[1]) * 0.75).sin(),
    };
    let (a, mut b) = (((p2.a + -0.875_f64).sin() * 0.75).sin(), (a * r1[3]));
    p2 += Pair { a: ((y * a) + 0.125).tanh(), b: ((r1[0] + r1[2]) * 0.75).sin() };
    p2 = p2.tamed();
    b = (((x - -1.125_f64).tanh() - -0.375_f64).tanh() + 0.125).tanh();
    b = (((b / (1.5 + p2.b * p2.b)) - -0.875_f64).tanh() + 0.125).tanh();
    let by3 = ((p2.a * -0.375_f64) * 0.75).sin();
    let a = shifted(&mut r1[1..], by3);
    let b = program_27(
        ((r1[3] + 0.125_f64).sin() * 0.75).sin(),
        ((r1[1] + 0.125_f64).sin() * 0.75).sin(),
    )
    .tanh();
    let mut e = ((b + y) * 0.75).sin();
    'l4: for i5 in 1..0_usize {
        r1[(i5 * i5 + 1) % 4] *= (b * 0.75).sin();
        e -= (((r1[(i5 * i5 + 1) % 4] / (1.5 + ((i5 as f64) * 0.25) * ((i5 as f64) * 0.25)))
            * (r1[(i5 * i5 + 1) % 4] / (1.5 + ((i5 as f64) * 0.25) * ((i5 as f64) * 0.25)))
            + 0.25)
            .sqrt()
            * 0.75)
            .sin();
        #[differentiable(checkpoint)]
        'l6: for i7 in (2..4_usize).rev() {
            'l8: for i9 in 0..=0_usize {
                let by10 = ((r1[i9 % 4] - x) * 0.75).sin();
                let e = shifted(&mut r1[2..], by10);
                let mut a = ((y * -1.125_f64).abs() + 0.125).tanh();
                let a = match roots((0.375_f64 * -0.625_f64), r1[(i9 + 2) % 4]) {
                    Ok(v) => ((b - -0.625_f64).tanh() * -1.125_f64).abs(),
                    Err(true) => r1[0],
                    Err(_) => (-0.125_f64 / (1.5 + y * y)),
                };
            }
        }
    }
    ((-(r1[2])) + (r1[3] + -0.375_f64).sin()) + e + b + a + y + x
}

fn program_34_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((a * a + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y * y) + S::from_f64(0.125)).tanh(),
        ((a / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin(),
    ];
    let mut p2 = Pair {
        a: ((r1[3] + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((r1[2] * S::from_f64(0.125_f64)).max(r1[1]) * S::from_f64(0.75)).sin(),
    };
    let (a, mut b) =
        (((p2.a + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(), (a * r1[3]));
    p2 += Pair {
        a: ((y * a) + S::from_f64(0.125)).tanh(),
        b: ((r1[0] + r1[2]) * S::from_f64(0.75)).sin(),
    };
    p2 = p2.tamed();
    b = (((x - S::from_f64(-1.125_f64)).tanh() - S::from_f64(-0.375_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    b = (((b / (S::from_f64(1.5) + p2.b * p2.b)) - S::from_f64(-0.875_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    let by3 = ((p2.a * S::from_f64(-0.375_f64)) * S::from_f64(0.75)).sin();
    let a = shifted(&mut r1[1..], by3);
    let b = program_27_of(
        ((r1[3] + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((r1[1] + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut e = ((b + y) * S::from_f64(0.75)).sin();
    'l4: for i5 in 1..0_usize {
        r1[(i5 * i5 + 1) % 4] = r1[(i5 * i5 + 1) % 4] * (b * S::from_f64(0.75)).sin();
        e = e
            - (((r1[(i5 * i5 + 1) % 4]
                / (S::from_f64(1.5)
                    + (S::from_f64(i5 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i5 as f64) * S::from_f64(0.25))))
                * (r1[(i5 * i5 + 1) % 4]
                    / (S::from_f64(1.5)
                        + (S::from_f64(i5 as f64) * S::from_f64(0.25))
                            * (S::from_f64(i5 as f64) * S::from_f64(0.25))))
                + S::from_f64(0.25))
            .sqrt()
                * S::from_f64(0.75))
            .sin();

        'l6: for i7 in (2..4_usize).rev() {
            'l8: for i9 in 0..=0_usize {
                let by10 = ((r1[i9 % 4] - x) * S::from_f64(0.75)).sin();
                let e = shifted(&mut r1[2..], by10);
                let mut a = ((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh();
                let a = match roots(
                    (S::from_f64(0.375_f64) * S::from_f64(-0.625_f64)),
                    r1[(i9 + 2) % 4],
                ) {
                    Ok(v) => ((b - S::from_f64(-0.625_f64)).tanh() * S::from_f64(-1.125_f64)).abs(),
                    Err(true) => r1[0],
                    Err(_) => (S::from_f64(-0.125_f64) / (S::from_f64(1.5) + y * y)),
                };
            }
        }
    }
    ((-(r1[2])) + (r1[3] + S::from_f64(-0.375_f64)).sin()) + e + b + a + y + x
}

#[differentiable]
fn program_35(x: f64, y: f64) -> f64 {
    let mut e = (y * 0.75).sin();
    let mut r1 = [
        ((y * -0.875_f64).max(x) + 0.125).tanh(),
        (x * 0.75).sin(),
        ((e * 0.375_f64).abs() * 0.75).sin(),
        ((-0.375_f64 * -0.375_f64 + 0.25).sqrt() * 0.75).sin(),
    ];
    let (a, mut b) = (((x * 0.625_f64).abs() + 0.125).tanh(), (y - -0.625_f64).tanh());
    let by2 = (a + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by2).sin();
    }
    r1[3] = (((r1[3] + e) * (-(b))) * 0.75).sin();
    'l3: for i4 in 1..=0_usize {
        if ((i4 as f64) * 0.25) < (x * 0.625_f64).abs() {
            let mut p5 = Pair { a: ((-(x)) + 0.125).tanh(), b: (r1[(i4 + 0) % 4] + 0.125).tanh() };
            let e = match roots(
                (r1[(i4 * i4 + 1) % 4] * ((i4 as f64) * 0.25)),
                (e * e + 0.25).sqrt(),
            ) {
                Ok(v) => ((p5.b - 0.375_f64).tanh() * 0.375_f64).abs(),
                Err(true) => b,
                Err(_) => (b * b + 0.25).sqrt(),
            };
            'l6: for i7 in (2..2_usize).step_by(2) {
                r1[2] -=
                    (((((i7 as f64) * 0.25) * 0.375_f64).abs() * -0.875_f64).cos() * 0.75).sin();
                let c =
                    program_25(((r1[1] * 0.875_f64).abs() + 0.125).tanh(), ((e * e) * 0.75).sin())
                        .tanh();
            }
        } else {
            #[differentiable(checkpoint)]
            'l8: for i9 in i4..=2_usize {
                let mut r10 = [
                    ((-((i4 as f64) * 0.25)) * 0.75).sin(),
                    ((a * -0.375_f64).max(-0.375_f64) + 0.125).tanh(),
                ];
            }
            if (e * r1[(i4 + 2) % 4]) < (r1[1] + r1[(i4 * i4 + 1) % 4]) {
                continue 'l3;
            }
            r1[2] += (((e + 0.125_f64).sin() * (a / (1.5 + r1[0] * r1[0]))) * 0.75).sin();
        }
    }
    ((b - 0.875_f64).tanh() * (x + b)) + b + a + e + y + x
}

fn program_35_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (y * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * S::from_f64(-0.875_f64)).max(x) + S::from_f64(0.125)).tanh(),
        (x * S::from_f64(0.75)).sin(),
        ((e * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
    ];
    let (a, mut b) = (
        ((x * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        (y - S::from_f64(-0.625_f64)).tanh(),
    );
    let by2 = (a + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by2).sin();
    }
    r1[3] = (((r1[3] + e) * (-(b))) * S::from_f64(0.75)).sin();
    'l3: for i4 in 1..=0_usize {
        if (S::from_f64(i4 as f64) * S::from_f64(0.25)).cmplt((x * S::from_f64(0.625_f64)).abs()) {
            let mut p5 = Pair {
                a: ((-(x)) + S::from_f64(0.125)).tanh(),
                b: (r1[(i4 + 0) % 4] + S::from_f64(0.125)).tanh(),
            };
            let e = match roots(
                (r1[(i4 * i4 + 1) % 4] * (S::from_f64(i4 as f64) * S::from_f64(0.25))),
                (e * e + S::from_f64(0.25)).sqrt(),
            ) {
                Ok(v) => ((p5.b - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.375_f64)).abs(),
                Err(true) => b,
                Err(_) => (b * b + S::from_f64(0.25)).sqrt(),
            };
            'l6: for i7 in (2..2_usize).step_by(2) {
                r1[2] = r1[2]
                    - ((((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.375_f64))
                        .abs()
                        * S::from_f64(-0.875_f64))
                    .cos()
                        * S::from_f64(0.75))
                    .sin();
                let c = program_25_of(
                    ((r1[1] * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
                    ((e * e) * S::from_f64(0.75)).sin(),
                )
                .tanh();
            }
        } else {
            'l8: for i9 in i4..=2_usize {
                let mut r10 = [
                    ((-(S::from_f64(i4 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                    ((a * S::from_f64(-0.375_f64)).max(S::from_f64(-0.375_f64))
                        + S::from_f64(0.125))
                    .tanh(),
                ];
            }
            if (e * r1[(i4 + 2) % 4]).cmplt((r1[1] + r1[(i4 * i4 + 1) % 4])) {
                continue 'l3;
            }
            r1[2] = r1[2]
                + (((e + S::from_f64(0.125_f64)).sin() * (a / (S::from_f64(1.5) + r1[0] * r1[0])))
                    * S::from_f64(0.75))
                .sin();
        }
    }
    ((b - S::from_f64(0.875_f64)).tanh() * (x + b)) + b + a + e + y + x
}

#[differentiable]
fn program_36(x: f64, y: f64) -> f64 {
    let mut f = (-0.875_f64 * 0.75).sin();
    let mut r1 = [((f / (1.5 + -1.125_f64 * -1.125_f64)) * 0.75).sin(); 3];
    f = (((-0.625_f64 / (1.5 + r1[0] * r1[0])) - -0.125_f64).tanh() * 0.75).sin();
    let b = match shape(((r1[0] + r1[1]) * 0.75).sin(), ((r1[2] + y) * 0.75).sin()) {
        Shape::Point => x,
        Shape::Disc(v) => ((f * 0.375_f64) * (v * 0.375_f64).abs()),
        Shape::Box { w: v, h } => ((r1[0] + -0.875_f64).sin() * -1.125_f64).max(v),
    };
    let mut p2 = Pair { a: ((r1[2] * x) * 0.75).sin(), b: ((x + r1[2]) * 0.75).sin() };
    let (a, mut b) = (((f * 0.875_f64).abs() + 0.125).tanh(), (r1[0] - 0.125_f64).tanh());
    p2.b = ((x * x) * 0.75).sin();
    p2 = p2.tamed();
    for v in r1.iter() {
        b = b * ((f - 0.875_f64).tanh() + 0.125).tanh()
            + *v * ((f - 0.875_f64).tanh() + 0.125).tanh();
    }
    for v in r1.iter() {
        f = f * ((y * 0.375_f64).abs() + 0.125).tanh()
            + *v * ((y * 0.375_f64).abs() + 0.125).tanh();
    }
    let mut e = ((p2.a * 0.875_f64).cos() * 0.75).sin();
    let a = match shape(((b * 0.875_f64) * 0.75).sin(), ((b - 0.125_f64).tanh() * 0.75).sin()) {
        Shape::Point => (a * r1[2]),
        Shape::Disc(v) => ((p2.b * -0.875_f64).max(v) * -0.125_f64).cos(),
        Shape::Box { w: v, h } => ((r1[2] * f) + (b * p2.a)),
    };
    let mut u3 = r1.to_vec();
    u3.push(((x + -0.375_f64).sin() + 0.125).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let f = (mixed(&u3) + u3[0]).tanh();
    let b = mixed(&r1[2..]).sin();
    let e = match shape(((a / (1.5 + y * y)) + 0.125).tanh(), (a * 0.75).sin()) {
        Shape::Point => (0.125_f64 - a),
        Shape::Disc(v) => ((b + f) + (-(x))),
        Shape::Box { w: v, h } => ((f * e) * -0.875_f64).max(r1[0]),
    };
    let mut c = ((a + -0.875_f64).sin() + 0.125).tanh();
    if (r1[0] * p2.a) <= e {
        return ((r1[1] + 0.375_f64).sin() + (r1[2] * -0.625_f64).abs());
    }
    (r1[1] * (b * r1[1])) + c + e + b + f + a + y + x
}

fn program_36_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (S::from_f64(-0.875_f64) * S::from_f64(0.75)).sin();
    let mut r1 = [((f / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
        * S::from_f64(0.75))
    .sin(); 3];
    f = (((S::from_f64(-0.625_f64) / (S::from_f64(1.5) + r1[0] * r1[0]))
        - S::from_f64(-0.125_f64))
    .tanh()
        * S::from_f64(0.75))
    .sin();
    let b = match shape(
        ((r1[0] + r1[1]) * S::from_f64(0.75)).sin(),
        ((r1[2] + y) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => x,
        Shape::Disc(v) => ((f * S::from_f64(0.375_f64)) * (v * S::from_f64(0.375_f64)).abs()),
        Shape::Box { w: v, h } => {
            ((r1[0] + S::from_f64(-0.875_f64)).sin() * S::from_f64(-1.125_f64)).max(v)
        }
    };
    let mut p2 = Pair {
        a: ((r1[2] * x) * S::from_f64(0.75)).sin(),
        b: ((x + r1[2]) * S::from_f64(0.75)).sin(),
    };
    let (a, mut b) = (
        ((f * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        (r1[0] - S::from_f64(0.125_f64)).tanh(),
    );
    p2.b = ((x * x) * S::from_f64(0.75)).sin();
    p2 = p2.tamed();
    for v in r1.iter() {
        b = b * ((f - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh()
            + *v * ((f - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    }
    for v in r1.iter() {
        f = f * ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh()
            + *v * ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    }
    let mut e = ((p2.a * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let a = match shape(
        ((b * S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin(),
        ((b - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (a * r1[2]),
        Shape::Disc(v) => ((p2.b * S::from_f64(-0.875_f64)).max(v) * S::from_f64(-0.125_f64)).cos(),
        Shape::Box { w: v, h } => ((r1[2] * f) + (b * p2.a)),
    };
    let mut u3 = r1.to_vec();
    u3.push(((x + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let f = (mixed(&u3) + u3[0]).tanh();
    let b = mixed(&r1[2..]).sin();
    let e = match shape(
        ((a / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        (a * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (S::from_f64(0.125_f64) - a),
        Shape::Disc(v) => ((b + f) + (-(x))),
        Shape::Box { w: v, h } => ((f * e) * S::from_f64(-0.875_f64)).max(r1[0]),
    };
    let mut c = ((a + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh();
    if (r1[0] * p2.a).cmple(e) {
        return ((r1[1] + S::from_f64(0.375_f64)).sin() + (r1[2] * S::from_f64(-0.625_f64)).abs());
    }
    (r1[1] * (b * r1[1])) + c + e + b + f + a + y + x
}

#[differentiable]
fn program_37(x: f64, y: f64) -> f64 {
    let mut d = ((x - -0.875_f64).tanh() + 0.125).tanh();
    let r1 = [((d * d) + 0.125).tanh(); 3];
    d += (d * 0.75).sin();
    let mut p2 = Pair { a: (0.375_f64 + 0.125).tanh(), b: ((r1[2] - x) + 0.125).tanh() };
    d += (d + 0.125).tanh();
    #[differentiable(checkpoint)]
    'l3: for i4 in 0..=2_usize {
        let mut r5 = [
            ((((i4 as f64) * 0.25) * r1[2]) + 0.125).tanh(),
            ((y * x) + 0.125).tanh(),
            ((y * p2.a) * 0.75).sin(),
            ((p2.b * 0.375_f64).cos() * 0.75).sin(),
        ];
    }
    p2.turn(((p2.b + x) * 0.75).sin());
    p2 = p2.tamed();
    let mut r6 = [
        ((x + -0.875_f64).sin() + 0.125).tanh(),
        ((x + r1[1]) * 0.75).sin(),
        ((x * -0.375_f64).max(r1[1]) + 0.125).tanh(),
        ((0.375_f64 * 0.375_f64).cos() + 0.125).tanh(),
        (r1[2] + 0.125).tanh(),
    ];
    let a = match shape(((x + r1[0]) + 0.125).tanh(), ((p2.a + r6[1]) * 0.75).sin()) {
        Shape::Point => (y * y + 0.25).sqrt(),
        Shape::Disc(v) => ((-0.125_f64 - x) / (1.5 + (v * y) * (v * y))),
        Shape::Box { w: v, h } => y,
    };
    let mut r7 = [((d / (1.5 + r1[1] * r1[1])) + 0.125).tanh(); 4];
    d *= (((a * -0.625_f64).abs() + (a * 0.125_f64).abs()) * 0.75).sin();
    if (-(r1[2])) > (r7[1] + r7[0]) {
        if (r7[3] + x) >= (r1[0] * 0.125_f64).max(x) {
            return ((a - a) * (a - a) + 0.25).sqrt();
        }
    } else {
        d = (((r6[3] - -0.875_f64).tanh() * 0.875_f64).cos() + 0.125).tanh();
        for v in r1.iter() {
            d = d * ((p2.a * 0.375_f64).max(a) * 0.75).sin()
                + *v * ((p2.a * 0.375_f64).max(a) * 0.75).sin();
        }
    }
    ((x * -0.875_f64).max(d) * 0.875_f64).abs() + a + d + y + x
}

fn program_37_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    let r1 = [((d * d) + S::from_f64(0.125)).tanh(); 3];
    d = d + (d * S::from_f64(0.75)).sin();
    let mut p2 = Pair {
        a: (S::from_f64(0.375_f64) + S::from_f64(0.125)).tanh(),
        b: ((r1[2] - x) + S::from_f64(0.125)).tanh(),
    };
    d = d + (d + S::from_f64(0.125)).tanh();

    'l3: for i4 in 0..=2_usize {
        let mut r5 = [
            (((S::from_f64(i4 as f64) * S::from_f64(0.25)) * r1[2]) + S::from_f64(0.125)).tanh(),
            ((y * x) + S::from_f64(0.125)).tanh(),
            ((y * p2.a) * S::from_f64(0.75)).sin(),
            ((p2.b * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        ];
    }
    p2.turn(((p2.b + x) * S::from_f64(0.75)).sin());
    p2 = p2.tamed();
    let mut r6 = [
        ((x + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x + r1[1]) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.375_f64)).max(r1[1]) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.375_f64) * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        (r1[2] + S::from_f64(0.125)).tanh(),
    ];
    let a = match shape(
        ((x + r1[0]) + S::from_f64(0.125)).tanh(),
        ((p2.a + r6[1]) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (y * y + S::from_f64(0.25)).sqrt(),
        Shape::Disc(v) => ((S::from_f64(-0.125_f64) - x) / (S::from_f64(1.5) + (v * y) * (v * y))),
        Shape::Box { w: v, h } => y,
    };
    let mut r7 = [((d / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh(); 4];
    d = d
        * (((a * S::from_f64(-0.625_f64)).abs() + (a * S::from_f64(0.125_f64)).abs())
            * S::from_f64(0.75))
        .sin();
    if (-(r1[2])).cmpgt((r7[1] + r7[0])) {
        if (r7[3] + x).cmpge((r1[0] * S::from_f64(0.125_f64)).max(x)) {
            return ((a - a) * (a - a) + S::from_f64(0.25)).sqrt();
        }
    } else {
        d = (((r6[3] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.875_f64)).cos()
            + S::from_f64(0.125))
        .tanh();
        for v in r1.iter() {
            d = d * ((p2.a * S::from_f64(0.375_f64)).max(a) * S::from_f64(0.75)).sin()
                + *v * ((p2.a * S::from_f64(0.375_f64)).max(a) * S::from_f64(0.75)).sin();
        }
    }
    ((x * S::from_f64(-0.875_f64)).max(d) * S::from_f64(0.875_f64)).abs() + a + d + y + x
}

#[differentiable]
fn program_38(x: f64, y: f64) -> f64 {
    let mut f = ((y - x) + 0.125).tanh();
    let mut r1 = [((x * x) + 0.125).tanh(); 2];
    let d = mixed(&r1[..1]).sin();
    let e: f64 = r1.iter().map(|v| v * ((y - y) + 0.125).tanh()).sum();
    f *= (((r1[1] - -1.125_f64).tanh() * -0.625_f64).cos() * 0.75).sin();
    'l2: for i3 in 0..=5_usize {
        f = (((r1[i3 % 2] / (1.5 + -0.375_f64 * -0.375_f64)) * (d - 0.875_f64).tanh()) + 0.125)
            .tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 1 {
            n5 += 1;
            f += ((r1[(n5 * n5 + 1) % 2] - -0.875_f64).tanh() * 0.75).sin();
            let g6 = |t: f64| r1[n5 % 2] * t;
            let e = (g6((y * 0.375_f64).abs()) + g6((0.125_f64 * x))).sin();
        }
    }
    let (a, mut b) = (((r1[0] + 0.625_f64) * 0.75).sin(), (x * r1[1]));
    b -= (((x - 0.375_f64).tanh() - 0.375_f64).tanh() + 0.125).tanh();
    let b = match root((r1[0] * -0.875_f64).cos()) {
        Some(v) => ((x + 0.125_f64).sin() * 0.875_f64).max(e),
        None => y,
    };
    let mut p7 = Pair { a: ((y + r1[1]) * 0.75).sin(), b: ((y + r1[0]) * 0.75).sin() };
    let a = if (r1[1] + y) < (x - -0.125_f64).tanh() {
        ((d - -0.625_f64).tanh() - -0.875_f64).tanh()
    } else {
        (a * a + 0.25).sqrt()
    };
    let f = match roots((e * r1[0]), (r1[1] - r1[0])) {
        Ok(v) => (e - -1.125_f64).tanh(),
        Err(true) => r1[0],
        Err(_) => (x + x),
    };
    ((a * 0.125_f64).abs() + (f + d)) + f + a + b + e + d + y + x
}

fn program_38_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * x) + S::from_f64(0.125)).tanh(); 2];
    let d = mixed(&r1[..1]).sin();
    let e =
        r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * ((y - y) + S::from_f64(0.125)).tanh());
    f = f
        * (((r1[1] - S::from_f64(-1.125_f64)).tanh() * S::from_f64(-0.625_f64)).cos()
            * S::from_f64(0.75))
        .sin();
    'l2: for i3 in 0..=5_usize {
        f = (((r1[i3 % 2]
            / (S::from_f64(1.5) + S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64)))
            * (d - S::from_f64(0.875_f64)).tanh())
            + S::from_f64(0.125))
        .tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 1 {
            n5 += 1;
            f = f
                + ((r1[(n5 * n5 + 1) % 2] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75))
                    .sin();
            let g6 = |t: S| r1[n5 % 2] * t;
            let e =
                (g6((y * S::from_f64(0.375_f64)).abs()) + g6((S::from_f64(0.125_f64) * x))).sin();
        }
    }
    let (a, mut b) = (((r1[0] + S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(), (x * r1[1]));
    b = b
        - (((x - S::from_f64(0.375_f64)).tanh() - S::from_f64(0.375_f64)).tanh()
            + S::from_f64(0.125))
        .tanh();
    let b = match root((r1[0] * S::from_f64(-0.875_f64)).cos()) {
        Some(v) => ((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.875_f64)).max(e),
        None => y,
    };
    let mut p7 = Pair {
        a: ((y + r1[1]) * S::from_f64(0.75)).sin(),
        b: ((y + r1[0]) * S::from_f64(0.75)).sin(),
    };
    let a = if (r1[1] + y).cmplt((x - S::from_f64(-0.125_f64)).tanh()) {
        ((d - S::from_f64(-0.625_f64)).tanh() - S::from_f64(-0.875_f64)).tanh()
    } else {
        (a * a + S::from_f64(0.25)).sqrt()
    };
    let f = match roots((e * r1[0]), (r1[1] - r1[0])) {
        Ok(v) => (e - S::from_f64(-1.125_f64)).tanh(),
        Err(true) => r1[0],
        Err(_) => (x + x),
    };
    ((a * S::from_f64(0.125_f64)).abs() + (f + d)) + f + a + b + e + d + y + x
}

#[differentiable]
fn program_39(x: f64, y: f64) -> f64 {
    let mut d = ((y - 0.625_f64).tanh() + 0.125).tanh();
    let mut r1 = [(y + 0.125).tanh(), (x * 0.75).sin(), ((d - d) * 0.75).sin()];
    for v in r1.iter() {
        d = d * ((r1[2] * 0.375_f64).cos() + 0.125).tanh()
            + *v * ((r1[2] * 0.375_f64).cos() + 0.125).tanh();
    }
    let g2 = |t: f64| ((0.625_f64 * -0.625_f64).max(y) - 0.875_f64).tanh() * t;
    let e = (g2(y) + g2(x)).sin();
    if (0.125_f64 / (1.5 + y * y)) > (0.875_f64 - r1[0]) {
        d = (((r1[1] + e) * (r1[2] * -1.125_f64).abs()) + 0.125).tanh();
        let mut a = ((-(y)) * 0.75).sin();
    } else {
        r1[0] *= (((e * -1.125_f64).max(r1[0]) + (0.625_f64 * -0.125_f64).max(d)) + 0.125).tanh();
        let mut p3 = Pair { a: ((e * -1.125_f64).cos() * 0.75).sin(), b: ((x + d) + 0.125).tanh() };
        'l4: for i5 in 2..=5_usize {
            p3.b = ((r1[i5 % 3] * r1[1]) * 0.75).sin();
            p3 = p3.tamed();
            let f = match root(e) {
                Some(v) => ((((i5 as f64) * 0.25) + p3.b) + -0.625_f64).sin(),
                None => (e - d),
            };
            if (r1[(i5 * i5 + 1) % 3] + 0.625_f64).sin() >= (x / (1.5 + r1[i5 % 3] * r1[i5 % 3])) {
                let e = p3
                    .dot(&Pair {
                        a: ((-(r1[i5 % 3])) * 0.75).sin(),
                        b: ((y * -0.375_f64).max(x) + 0.125).tanh(),
                    })
                    .sin();
                let mut u6 = r1.to_vec();
                u6.push(((((i5 as f64) * 0.25) * -0.125_f64).cos() + 0.125).tanh());
                u6[0] = u6[1] * u6[u6.len() - 1];
                let e = (mixed(&u6) + u6[0]).tanh();
                p3 = (p3 - p3 * ((f * -1.125_f64).abs() * 0.75).sin()).tamed();
                p3 = p3.tamed();
            } else {
                r1[1] = (((r1[0] + x) - e) * 0.75).sin();
                r1[(i5 * i5 + 1) % 3] *= (e * 0.75).sin();
            }
        }
    }
    ((e * 0.375_f64).cos() - -0.625_f64).tanh() + e + d + y + x
}

fn program_39_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (y + S::from_f64(0.125)).tanh(),
        (x * S::from_f64(0.75)).sin(),
        ((d - d) * S::from_f64(0.75)).sin(),
    ];
    for v in r1.iter() {
        d = d * ((r1[2] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh()
            + *v * ((r1[2] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    }
    let g2 = |t: S| {
        ((S::from_f64(0.625_f64) * S::from_f64(-0.625_f64)).max(y) - S::from_f64(0.875_f64)).tanh()
            * t
    };
    let e = (g2(y) + g2(x)).sin();
    if (S::from_f64(0.125_f64) / (S::from_f64(1.5) + y * y)).cmpgt((S::from_f64(0.875_f64) - r1[0]))
    {
        d = (((r1[1] + e) * (r1[2] * S::from_f64(-1.125_f64)).abs()) + S::from_f64(0.125)).tanh();
        let mut a = ((-(y)) * S::from_f64(0.75)).sin();
    } else {
        r1[0] = r1[0]
            * (((e * S::from_f64(-1.125_f64)).max(r1[0])
                + (S::from_f64(0.625_f64) * S::from_f64(-0.125_f64)).max(d))
                + S::from_f64(0.125))
            .tanh();
        let mut p3 = Pair {
            a: ((e * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
            b: ((x + d) + S::from_f64(0.125)).tanh(),
        };
        'l4: for i5 in 2..=5_usize {
            p3.b = ((r1[i5 % 3] * r1[1]) * S::from_f64(0.75)).sin();
            p3 = p3.tamed();
            let f = match root(e) {
                Some(v) => (((S::from_f64(i5 as f64) * S::from_f64(0.25)) + p3.b)
                    + S::from_f64(-0.625_f64))
                .sin(),
                None => (e - d),
            };
            if (r1[(i5 * i5 + 1) % 3] + S::from_f64(0.625_f64))
                .sin()
                .cmpge((x / (S::from_f64(1.5) + r1[i5 % 3] * r1[i5 % 3])))
            {
                let e = p3
                    .dot(&Pair {
                        a: ((-(r1[i5 % 3])) * S::from_f64(0.75)).sin(),
                        b: ((y * S::from_f64(-0.375_f64)).max(x) + S::from_f64(0.125)).tanh(),
                    })
                    .sin();
                let mut u6 = r1.to_vec();
                u6.push(
                    (((S::from_f64(i5 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                        .cos()
                        + S::from_f64(0.125))
                    .tanh(),
                );
                u6[0] = u6[1] * u6[u6.len() - 1];
                let e = (mixed(&u6) + u6[0]).tanh();
                p3 = (p3 - p3 * ((f * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin())
                    .tamed();
                p3 = p3.tamed();
            } else {
                r1[1] = (((r1[0] + x) - e) * S::from_f64(0.75)).sin();
                r1[(i5 * i5 + 1) % 3] = r1[(i5 * i5 + 1) % 3] * (e * S::from_f64(0.75)).sin();
            }
        }
    }
    ((e * S::from_f64(0.375_f64)).cos() - S::from_f64(-0.625_f64)).tanh() + e + d + y + x
}
