//! Random programs, written by `cargo run -p ad --example random_programs -- 8 60`.

use ad::{Real, differentiable};

use crate::program::{Program, program};
use crate::types::Shape::{Disc, Point};
use crate::types::{Pair, Shape, bent, folded, mixed, root, roots, shape, shifted, summed};

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
    program!(program_40, program_40_of),
    program!(program_41, program_41_of),
    program!(program_42, program_42_of),
    program!(program_43, program_43_of),
    program!(program_44, program_44_of),
    program!(program_45, program_45_of),
    program!(program_46, program_46_of),
    program!(program_47, program_47_of),
    program!(program_48, program_48_of),
    program!(program_49, program_49_of),
    program!(program_50, program_50_of),
    program!(program_51, program_51_of),
    program!(program_52, program_52_of),
    program!(program_53, program_53_of),
    program!(program_54, program_54_of),
    program!(program_55, program_55_of),
    program!(program_56, program_56_of),
    program!(program_57, program_57_of),
    program!(program_58, program_58_of),
    program!(program_59, program_59_of),
];

#[differentiable]
fn program_0(x: f64, y: f64) -> f64 {
    let mut d = ((-(x)) * 0.75).sin();
    let mut r1 = [((y * 0.125_f64) * 0.75).sin(); 3];
    r1[2] -= ((-((d + -0.125_f64).sin())) * 0.75).sin();
    let e = match roots((r1[1] * y), (r1[0] * x)) {
        Ok(v) => (d * -0.375_f64).max(-0.375_f64),
        Err(true) => d,
        Err(_) => (x * 0.375_f64),
    };
    let mut p2 = Pair { a: (r1[0] * 0.75).sin(), b: ((d - -0.375_f64).tanh() * 0.75).sin() };
    let by3 = (x * 0.75).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    if (e * r1[0]) < (-0.375_f64 * y) {
        return ((e * 0.875_f64).abs() * -0.625_f64).cos();
    }
    let b = mixed(&r1[..3]).sin();
    let c = match shape((e * 0.75).sin(), ((p2.b * p2.b + 0.25).sqrt() + 0.125).tanh()) {
        Point => (0.875_f64 * p2.b),
        Disc(v) => (d + 0.625_f64).sin(),
        Shape::Box { w: v, h } => (r1[0] - 0.875_f64).tanh(),
    };
    r1[0] = (((0.375_f64 - x) + (c - r1[2])) + 0.125).tanh();
    let mut r4 = [((-(e)) * 0.75).sin(); 4];
    if (c - r4[3]) <= (x * -1.125_f64).cos() {
        return ((r4[3] + -1.125_f64).sin() * (p2.a * r4[0]));
    }
    if (d * -0.625_f64).abs() >= (e * c) {
        let b = x;
        #[differentiable(checkpoint)]
        'l5: for i6 in 2..=1_usize {
            d *= (((i6 as f64) * 0.25) + 0.125).tanh();
            if i6 % 2 == 0 {
                continue 'l5;
            }
        }
    }
    e + c + b + e + d + y + x
}

fn program_0_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((-(x)) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(); 3];
    r1[2] = r1[2] - ((-((d + S::from_f64(-0.125_f64)).sin())) * S::from_f64(0.75)).sin();
    let e = match roots((r1[1] * y), (r1[0] * x)) {
        Ok(v) => (d * S::from_f64(-0.375_f64)).max(S::from_f64(-0.375_f64)),
        Err(true) => d,
        Err(_) => (x * S::from_f64(0.375_f64)),
    };
    let mut p2 = Pair {
        a: (r1[0] * S::from_f64(0.75)).sin(),
        b: ((d - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
    };
    let by3 = (x * S::from_f64(0.75)).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    if (e * r1[0]).cmplt((S::from_f64(-0.375_f64) * y)) {
        return ((e * S::from_f64(0.875_f64)).abs() * S::from_f64(-0.625_f64)).cos();
    }
    let b = mixed(&r1[..3]).sin();
    let c = match shape(
        (e * S::from_f64(0.75)).sin(),
        ((p2.b * p2.b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    ) {
        Point => (S::from_f64(0.875_f64) * p2.b),
        Disc(v) => (d + S::from_f64(0.625_f64)).sin(),
        Shape::Box { w: v, h } => (r1[0] - S::from_f64(0.875_f64)).tanh(),
    };
    r1[0] = (((S::from_f64(0.375_f64) - x) + (c - r1[2])) + S::from_f64(0.125)).tanh();
    let mut r4 = [((-(e)) * S::from_f64(0.75)).sin(); 4];
    if (c - r4[3]).cmple((x * S::from_f64(-1.125_f64)).cos()) {
        return ((r4[3] + S::from_f64(-1.125_f64)).sin() * (p2.a * r4[0]));
    }
    if (d * S::from_f64(-0.625_f64)).abs().cmpge((e * c)) {
        let b = x;

        'l5: for i6 in 2..=1_usize {
            d = d * ((S::from_f64(i6 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
            if i6 % 2 == 0 {
                continue 'l5;
            }
        }
    }
    e + c + b + e + d + y + x
}

#[differentiable]
fn program_1(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((-0.125_f64 + 0.125_f64).sin() * 0.75).sin(); 5];
    let g2 = |t: f64| ((x + -1.125_f64).sin() * 0.625_f64).cos() * t;
    let f = (g2((-(-0.125_f64))) + g2((x * r1[2]))).sin();
    let mut r3 = [(r1[3] + 0.125).tanh(); 2];
    let z4;
    if (x * f) <= y {
        let t = ((0.375_f64 * 0.875_f64).max(f) + 0.125_f64).sin();
        z4 = ((r1[4] * r1[4] + 0.25).sqrt() * -0.625_f64).abs();
    } else if (f - r3[1]) >= (r3[1] * 0.625_f64).max(0.625_f64) {
        z4 = bent((-(-0.875_f64)));
    } else {
        z4 = ((0.375_f64 * 0.875_f64).max(f) + 0.125_f64).sin();
    }
    let e = summed(|t: f64| (r1[0] * t).sin(), (r3[0] + 0.125).tanh(), 2).tanh();
    let mut a = ((e * y) * 0.75).sin();
    let r5 = [((f * -1.125_f64).max(z4) * 0.75).sin(); 5];
    let b = match shape(((y + z4) + 0.125).tanh(), ((r5[0] * x) * 0.75).sin()) {
        Point => (y * y),
        Disc(v) => (-((v - -0.625_f64).tanh())),
        Shape::Box { w: v, h } => ((r1[2] + r5[4]) * (y / (1.5 + v * v))),
    };
    let mut u6 = r3.to_vec();
    u6.push(((y + z4) * 0.75).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let c = (mixed(&u6) + u6[0]).tanh();
    #[differentiable(checkpoint)]
    'l7: for i8 in 2..=1_usize {
        let a = match roots(((i8 as f64) * 0.25), (0.625_f64 / (1.5 + z4 * z4))) {
            Ok(v) => ((-(r3[(i8 + 0) % 2])) - (x - -1.125_f64).tanh()),
            Err(true) => c,
            Err(_) => (-0.625_f64 * c),
        };
        let mut p9 = Pair {
            a: ((r5[3] + r5[i8 % 5]) * 0.75).sin(),
            b: ((e * e + 0.25).sqrt() + 0.125).tanh(),
        };
        let mut p10 = Pair { a: ((b + b) * 0.75).sin(), b: ((-(-0.625_f64)) * 0.75).sin() };
    }
    a -= (((r5[4] * 0.125_f64).cos() * 0.375_f64).abs() * 0.75).sin();
    let b = match shape(((r1[4] - 0.625_f64).tanh() * 0.75).sin(), ((-(r1[0])) * 0.75).sin()) {
        Point => 0.625_f64,
        Disc(v) => ((v - 0.375_f64).tanh() * -0.875_f64).max(r1[1]),
        Shape::Box { w: v, h } => c,
    };
    ((y * -0.625_f64).max(c) + -0.375_f64).sin() + b + c + a + e + z4 + f + y + x
}

fn program_1_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 =
        [((S::from_f64(-0.125_f64) + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 5];
    let g2 = |t: S| ((x + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.625_f64)).cos() * t;
    let f = (g2((-(S::from_f64(-0.125_f64)))) + g2((x * r1[2]))).sin();
    let mut r3 = [(r1[3] + S::from_f64(0.125)).tanh(); 2];
    let z4;
    if (x * f).cmple(y) {
        let t = ((S::from_f64(0.375_f64) * S::from_f64(0.875_f64)).max(f) + S::from_f64(0.125_f64))
            .sin();
        z4 = ((r1[4] * r1[4] + S::from_f64(0.25)).sqrt() * S::from_f64(-0.625_f64)).abs();
    } else if (f - r3[1]).cmpge((r3[1] * S::from_f64(0.625_f64)).max(S::from_f64(0.625_f64))) {
        z4 = bent((-(S::from_f64(-0.875_f64))));
    } else {
        z4 = ((S::from_f64(0.375_f64) * S::from_f64(0.875_f64)).max(f) + S::from_f64(0.125_f64))
            .sin();
    }
    let e = summed(|t: S| (r1[0] * t).sin(), (r3[0] + S::from_f64(0.125)).tanh(), 2).tanh();
    let mut a = ((e * y) * S::from_f64(0.75)).sin();
    let r5 = [((f * S::from_f64(-1.125_f64)).max(z4) * S::from_f64(0.75)).sin(); 5];
    let b = match shape(
        ((y + z4) + S::from_f64(0.125)).tanh(),
        ((r5[0] * x) * S::from_f64(0.75)).sin(),
    ) {
        Point => (y * y),
        Disc(v) => (-((v - S::from_f64(-0.625_f64)).tanh())),
        Shape::Box { w: v, h } => ((r1[2] + r5[4]) * (y / (S::from_f64(1.5) + v * v))),
    };
    let mut u6 = r3.to_vec();
    u6.push(((y + z4) * S::from_f64(0.75)).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let c = (mixed(&u6) + u6[0]).tanh();

    'l7: for i8 in 2..=1_usize {
        let a = match roots(
            (S::from_f64(i8 as f64) * S::from_f64(0.25)),
            (S::from_f64(0.625_f64) / (S::from_f64(1.5) + z4 * z4)),
        ) {
            Ok(v) => ((-(r3[(i8 + 0) % 2])) - (x - S::from_f64(-1.125_f64)).tanh()),
            Err(true) => c,
            Err(_) => (S::from_f64(-0.625_f64) * c),
        };
        let mut p9 = Pair {
            a: ((r5[3] + r5[i8 % 5]) * S::from_f64(0.75)).sin(),
            b: ((e * e + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        };
        let mut p10 = Pair {
            a: ((b + b) * S::from_f64(0.75)).sin(),
            b: ((-(S::from_f64(-0.625_f64))) * S::from_f64(0.75)).sin(),
        };
    }
    a = a
        - (((r5[4] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.375_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    let b = match shape(
        ((r1[4] - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((-(r1[0])) * S::from_f64(0.75)).sin(),
    ) {
        Point => S::from_f64(0.625_f64),
        Disc(v) => ((v - S::from_f64(0.375_f64)).tanh() * S::from_f64(-0.875_f64)).max(r1[1]),
        Shape::Box { w: v, h } => c,
    };
    ((y * S::from_f64(-0.625_f64)).max(c) + S::from_f64(-0.375_f64)).sin()
        + b
        + c
        + a
        + e
        + z4
        + f
        + y
        + x
}

#[differentiable]
fn program_2(x: f64, y: f64) -> f64 {
    let mut d = (y + 0.125).tanh();
    let r1 = [
        ((d - d) * 0.75).sin(),
        ((d + -1.125_f64).sin() * 0.75).sin(),
        ((y + 0.125_f64).sin() * 0.75).sin(),
        ((y * y) * 0.75).sin(),
    ];
    let mut p2 = Pair { a: ((r1[1] - d) * 0.75).sin(), b: ((x + -0.625_f64).sin() + 0.125).tanh() };
    if (d + -0.625_f64) <= (r1[2] / (1.5 + r1[2] * r1[2])) {
        return (-((0.375_f64 - -1.125_f64).tanh()));
    }
    p2 = -(Pair { a: (x + 0.125).tanh(), b: ((y / (1.5 + r1[0] * r1[0])) + 0.125).tanh() }
        - Pair {
            a: ((y + -0.875_f64).sin() + 0.125).tanh(),
            b: ((y * 0.375_f64).abs() * 0.75).sin(),
        })
    .tamed();
    p2 = p2.tamed();
    let f = program_0(((y * -0.625_f64).max(r1[3]) + 0.125).tanh(), (x + 0.125).tanh()).tanh();
    'l3: for i4 in (1..2_usize).rev() {
        p2.b = ((p2.a + p2.a) + 0.125).tanh();
        p2 = p2.tamed();
        'l5: for i6 in (2..5_usize).rev() {
            'l7: for i8 in (0..4_usize).rev() {
                d *= (((r1[i6 % 4] - r1[i4 % 4]) * -1.125_f64).abs() * 0.75).sin();
                d -= (((r1[0] * 0.625_f64).abs()
                    / (1.5 + (-((i6 as f64) * 0.25)) * (-((i6 as f64) * 0.25))))
                    + 0.125)
                    .tanh();
            }
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 3 {
        n10 += 1;
        let g11 = |t: f64| x * t;
        let c = (g11((-(p2.b))) + g11((-(r1[2])))).sin();
    }
    d = ((p2.a
        / (1.5 + (f / (1.5 + 0.875_f64 * 0.875_f64)) * (f / (1.5 + 0.875_f64 * 0.875_f64))))
        * 0.75)
        .sin();
    let g12 = |t: f64| ((-1.125_f64 * x) - 0.125_f64).tanh() * t;
    let c = (g12(r1[2]) + g12((f * f))).sin();
    ((-(d)) + -0.125_f64).sin() + c + f + d + y + x
}

fn program_2_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (y + S::from_f64(0.125)).tanh();
    let r1 = [
        ((d - d) * S::from_f64(0.75)).sin(),
        ((d + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y * y) * S::from_f64(0.75)).sin(),
    ];
    let mut p2 = Pair {
        a: ((r1[1] - d) * S::from_f64(0.75)).sin(),
        b: ((x + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
    };
    if (d + S::from_f64(-0.625_f64)).cmple((r1[2] / (S::from_f64(1.5) + r1[2] * r1[2]))) {
        return (-((S::from_f64(0.375_f64) - S::from_f64(-1.125_f64)).tanh()));
    }
    p2 = -(Pair {
        a: (x + S::from_f64(0.125)).tanh(),
        b: ((y / (S::from_f64(1.5) + r1[0] * r1[0])) + S::from_f64(0.125)).tanh(),
    } - Pair {
        a: ((y + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((y * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
    })
    .tamed();
    p2 = p2.tamed();
    let f = program_0_of(
        ((y * S::from_f64(-0.625_f64)).max(r1[3]) + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    'l3: for i4 in (1..2_usize).rev() {
        p2.b = ((p2.a + p2.a) + S::from_f64(0.125)).tanh();
        p2 = p2.tamed();
        'l5: for i6 in (2..5_usize).rev() {
            'l7: for i8 in (0..4_usize).rev() {
                d = d
                    * (((r1[i6 % 4] - r1[i4 % 4]) * S::from_f64(-1.125_f64)).abs()
                        * S::from_f64(0.75))
                    .sin();
                d = d
                    - (((r1[0] * S::from_f64(0.625_f64)).abs()
                        / (S::from_f64(1.5)
                            + (-(S::from_f64(i6 as f64) * S::from_f64(0.25)))
                                * (-(S::from_f64(i6 as f64) * S::from_f64(0.25)))))
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 3 {
        n10 += 1;
        let g11 = |t: S| x * t;
        let c = (g11((-(p2.b))) + g11((-(r1[2])))).sin();
    }
    d = ((p2.a
        / (S::from_f64(1.5)
            + (f / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64)))
                * (f / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64)))))
        * S::from_f64(0.75))
    .sin();
    let g12 = |t: S| ((S::from_f64(-1.125_f64) * x) - S::from_f64(0.125_f64)).tanh() * t;
    let c = (g12(r1[2]) + g12((f * f))).sin();
    ((-(d)) + S::from_f64(-0.125_f64)).sin() + c + f + d + y + x
}

#[differentiable]
fn program_3(x: f64, y: f64) -> f64 {
    let mut f = ((y * y) * 0.75).sin();
    let mut r1 = [((-(x)) + 0.125).tanh(), ((x + y) * 0.75).sin()];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((-0.625_f64 * f) * 0.75).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let mut p3 =
        Pair { a: ((r1[1] - -0.125_f64).tanh() + 0.125).tanh(), b: ((x * f) * 0.75).sin() };
    let a = program_1(
        ((x * 0.375_f64).abs() + 0.125).tanh(),
        ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh(),
    )
    .tanh();
    let b = match roots((d * p3.b), (r1[1] - d)) {
        Ok(v) => ((d - p3.a) * (r1[0] + 0.375_f64).sin()),
        Err(true) => r1[0],
        Err(_) => r1[1],
    };
    r1[0] += (((0.625_f64 * r1[0]) * (b + -0.375_f64).sin()) * 0.75).sin();
    'l4: for i5 in (0..4_usize).step_by(2) {
        r1[(i5 + 0) % 2] = ((a + -0.625_f64).sin() + 0.125).tanh();
        for v in r1.iter() {
            f = f * ((f * x) * 0.75).sin() + *v * ((f * x) * 0.75).sin();
        }
        let mut n7 = 0_usize;
        'l6: while n7 < 2 {
            n7 += 1;
            let a = program_2(
                ((-((n7 as f64) * 0.25)) * 0.75).sin(),
                ((r1[n7 % 2] + -0.875_f64).sin() * 0.75).sin(),
            )
            .tanh();
        }
    }
    let a = summed(
        |t: f64| (((r1[0] - r1[1]) + (r1[1] + 0.625_f64).sin()) * t).sin(),
        ((r1[1] + f) * 0.75).sin(),
        0,
    )
    .tanh();
    r1[0] *= ((x + (r1[1] - r1[1])) * 0.75).sin();
    p3 = (p3 + p3) * ((p3.b - a) * 0.75).sin();
    p3 = p3.tamed();
    let c =
        if (p3.b * r1[1]) <= (-(r1[0])) { (r1[1] + d) } else { ((f * r1[1]) * 0.375_f64).max(b) };
    ((b * b + 0.25).sqrt() * 0.375_f64).cos() + c + a + b + d + f + y + x
}

fn program_3_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((-(x)) + S::from_f64(0.125)).tanh(), ((x + y) * S::from_f64(0.75)).sin()];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((S::from_f64(-0.625_f64) * f) * S::from_f64(0.75)).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let mut p3 = Pair {
        a: ((r1[1] - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: ((x * f) * S::from_f64(0.75)).sin(),
    };
    let a = program_1_of(
        ((x * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let b = match roots((d * p3.b), (r1[1] - d)) {
        Ok(v) => ((d - p3.a) * (r1[0] + S::from_f64(0.375_f64)).sin()),
        Err(true) => r1[0],
        Err(_) => r1[1],
    };
    r1[0] = r1[0]
        + (((S::from_f64(0.625_f64) * r1[0]) * (b + S::from_f64(-0.375_f64)).sin())
            * S::from_f64(0.75))
        .sin();
    'l4: for i5 in (0..4_usize).step_by(2) {
        r1[(i5 + 0) % 2] = ((a + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh();
        for v in r1.iter() {
            f = f * ((f * x) * S::from_f64(0.75)).sin() + *v * ((f * x) * S::from_f64(0.75)).sin();
        }
        let mut n7 = 0_usize;
        'l6: while n7 < 2 {
            n7 += 1;
            let a = program_2_of(
                ((-(S::from_f64(n7 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                ((r1[n7 % 2] + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(),
            )
            .tanh();
        }
    }
    let a = summed(
        |t: S| (((r1[0] - r1[1]) + (r1[1] + S::from_f64(0.625_f64)).sin()) * t).sin(),
        ((r1[1] + f) * S::from_f64(0.75)).sin(),
        0,
    )
    .tanh();
    r1[0] = r1[0] * ((x + (r1[1] - r1[1])) * S::from_f64(0.75)).sin();
    p3 = (p3 + p3) * ((p3.b - a) * S::from_f64(0.75)).sin();
    p3 = p3.tamed();
    let c = if (p3.b * r1[1]).cmple((-(r1[0]))) {
        (r1[1] + d)
    } else {
        ((f * r1[1]) * S::from_f64(0.375_f64)).max(b)
    };
    ((b * b + S::from_f64(0.25)).sqrt() * S::from_f64(0.375_f64)).cos() + c + a + b + d + f + y + x
}

#[differentiable]
fn program_4(x: f64, y: f64) -> f64 {
    let mut c = ((x * -0.625_f64).max(y) + 0.125).tanh();
    let mut r1 = [((x * y) * 0.75).sin(); 4];
    let mut p2 = Pair { a: ((c + -0.875_f64) + 0.125).tanh(), b: ((-(c)) + 0.125).tanh() };
    r1[2] = (r1[2] * 0.75).sin();
    if (r1[1] * 0.625_f64) >= (y * y + 0.25).sqrt() {
        let e = match shape(
            ((p2.b * -1.125_f64).cos() * 0.75).sin(),
            ((y / (1.5 + 0.625_f64 * 0.625_f64)) * 0.75).sin(),
        ) {
            Shape::Point => (x * x + 0.25).sqrt(),
            Shape::Disc(v) => ((x * r1[1]) * (x * r1[1]) + 0.25).sqrt(),
            Shape::Box { w: v, h } => ((x + -1.125_f64) * (c / (1.5 + v * v))),
        };
        p2 = (p2 - p2 * ((x + -0.375_f64).sin() * 0.75).sin()).tamed();
        p2 = p2.tamed();
        'l3: for i4 in (0..4_usize).step_by(2) {
            #[differentiable(checkpoint)]
            'l5: for i6 in (i4..2_usize).step_by(2) {
                let mut d = ((p2.a * p2.a + 0.25).sqrt() * 0.75).sin();
                let (a, mut b) = (((r1[(i4 + 1) % 4] + r1[i4 % 4]) * 0.75).sin(), (-(x)));
                let b =
                    program_0((r1[3] + 0.125).tanh(), ((r1[(i4 + 2) % 4] - r1[3]) + 0.125).tanh())
                        .tanh();
            }
            let f = ((r1[i4 % 4] * 0.375_f64).abs() * (c * -0.625_f64).abs());
            if (c / (1.5 + ((i4 as f64) * 0.25) * ((i4 as f64) * 0.25))) > (x * p2.b) {
                let a = match root((x * -0.625_f64).cos()) {
                    Some(v) => ((v - -0.375_f64).tanh() - (-(r1[(i4 * i4 + 1) % 4]))),
                    None => (r1[(i4 * i4 + 1) % 4] + r1[i4 % 4]),
                };
                let c =
                    program_0(((-(p2.a)) + 0.125).tanh(), (r1[(i4 + 0) % 4] + 0.125).tanh()).tanh();
            } else {
                let mut p7 = Pair {
                    a: ((f * 0.375_f64).max(p2.a) * 0.75).sin(),
                    b: ((c / (1.5 + y * y)) + 0.125).tanh(),
                };
                let e = match roots(
                    (r1[(i4 * i4 + 1) % 4] * r1[(i4 * i4 + 1) % 4] + 0.25).sqrt(),
                    (c * ((i4 as f64) * 0.25)),
                ) {
                    Ok(v) => ((p2.a + r1[(i4 + 1) % 4]) * -0.625_f64).max(e),
                    Err(true) => r1[i4 % 4],
                    Err(_) => (-(c)),
                };
            }
        }
    }
    ((r1[3] - -0.875_f64) - -0.625_f64).tanh() + c + y + x
}

fn program_4_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * y) * S::from_f64(0.75)).sin(); 4];
    let mut p2 = Pair {
        a: ((c + S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
        b: ((-(c)) + S::from_f64(0.125)).tanh(),
    };
    r1[2] = (r1[2] * S::from_f64(0.75)).sin();
    if (r1[1] * S::from_f64(0.625_f64)).cmpge((y * y + S::from_f64(0.25)).sqrt()) {
        let e = match shape(
            ((p2.b * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
            ((y / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
                * S::from_f64(0.75))
            .sin(),
        ) {
            Shape::Point => (x * x + S::from_f64(0.25)).sqrt(),
            Shape::Disc(v) => ((x * r1[1]) * (x * r1[1]) + S::from_f64(0.25)).sqrt(),
            Shape::Box { w: v, h } => {
                ((x + S::from_f64(-1.125_f64)) * (c / (S::from_f64(1.5) + v * v)))
            }
        };
        p2 = (p2 - p2 * ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin()).tamed();
        p2 = p2.tamed();
        'l3: for i4 in (0..4_usize).step_by(2) {
            'l5: for i6 in (i4..2_usize).step_by(2) {
                let mut d = ((p2.a * p2.a + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
                let (a, mut b) =
                    (((r1[(i4 + 1) % 4] + r1[i4 % 4]) * S::from_f64(0.75)).sin(), (-(x)));
                let b = program_0_of(
                    (r1[3] + S::from_f64(0.125)).tanh(),
                    ((r1[(i4 + 2) % 4] - r1[3]) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            }
            let f =
                ((r1[i4 % 4] * S::from_f64(0.375_f64)).abs() * (c * S::from_f64(-0.625_f64)).abs());
            if (c
                / (S::from_f64(1.5)
                    + (S::from_f64(i4 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i4 as f64) * S::from_f64(0.25))))
            .cmpgt((x * p2.b))
            {
                let a = match root((x * S::from_f64(-0.625_f64)).cos()) {
                    Some(v) => ((v - S::from_f64(-0.375_f64)).tanh() - (-(r1[(i4 * i4 + 1) % 4]))),
                    None => (r1[(i4 * i4 + 1) % 4] + r1[i4 % 4]),
                };
                let c = program_0_of(
                    ((-(p2.a)) + S::from_f64(0.125)).tanh(),
                    (r1[(i4 + 0) % 4] + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            } else {
                let mut p7 = Pair {
                    a: ((f * S::from_f64(0.375_f64)).max(p2.a) * S::from_f64(0.75)).sin(),
                    b: ((c / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
                };
                let e = match roots(
                    (r1[(i4 * i4 + 1) % 4] * r1[(i4 * i4 + 1) % 4] + S::from_f64(0.25)).sqrt(),
                    (c * (S::from_f64(i4 as f64) * S::from_f64(0.25))),
                ) {
                    Ok(v) => ((p2.a + r1[(i4 + 1) % 4]) * S::from_f64(-0.625_f64)).max(e),
                    Err(true) => r1[i4 % 4],
                    Err(_) => (-(c)),
                };
            }
        }
    }
    ((r1[3] - S::from_f64(-0.875_f64)) - S::from_f64(-0.625_f64)).tanh() + c + y + x
}

#[differentiable]
fn program_5(x: f64, y: f64) -> f64 {
    let mut e = ((-1.125_f64 * y) + 0.125).tanh();
    let mut r1 = [(e * 0.75).sin(); 2];
    let mut p2 = Pair {
        a: ((r1[1] * 0.375_f64).max(e) + 0.125).tanh(),
        b: ((r1[0] + -0.375_f64).sin() * 0.75).sin(),
    };
    #[differentiable(checkpoint)]
    'l3: for i4 in (1..1_usize).step_by(2) {
        let c = x;
    }
    let mut f = ((e / (1.5 + y * y)) + 0.125).tanh();
    let b = program_3(((x * -1.125_f64).cos() * 0.75).sin(), ((e - y) + 0.125).tanh()).tanh();
    'l5: for i6 in (0..5_usize).step_by(2) {
        let by7 = ((x - r1[i6 % 2]) + 0.125).tanh();
        let b = shifted(&mut r1[1..], by7);
        let f = match roots((p2.a * e), (((i6 as f64) * 0.25) * -0.625_f64).cos()) {
            Ok(v) => ((p2.a * 0.625_f64).cos() + (-(e))),
            Err(true) => x,
            Err(_) => (p2.a * ((i6 as f64) * 0.25)),
        };
    }
    e -= (((b * 0.375_f64).cos() * (r1[0] * -0.625_f64).cos()) + 0.125).tanh();
    let z8;
    if (r1[1] * r1[1] + 0.25).sqrt() < x {
        z8 = r1[1];
    } else {
        z8 = (e * -0.625_f64);
    }
    if r1[1] < (f * f + 0.25).sqrt() {
        let g9 = |t: f64| ((x * x + 0.25).sqrt() + (r1[1] * 0.875_f64).max(r1[0])) * t;
        let f = (g9((x + x)) + g9((r1[1] * r1[1]))).sin();
    }
    p2.b = ((x * e) * 0.75).sin();
    p2 = p2.tamed();
    p2.b = (x * 0.75).sin();
    p2 = p2.tamed();
    ((r1[0] - 0.125_f64).tanh() + 0.875_f64) + z8 + b + f + e + y + x
}

fn program_5_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((S::from_f64(-1.125_f64) * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [(e * S::from_f64(0.75)).sin(); 2];
    let mut p2 = Pair {
        a: ((r1[1] * S::from_f64(0.375_f64)).max(e) + S::from_f64(0.125)).tanh(),
        b: ((r1[0] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
    };

    'l3: for i4 in (1..1_usize).step_by(2) {
        let c = x;
    }
    let mut f = ((e / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh();
    let b = program_3_of(
        ((x * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
        ((e - y) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    'l5: for i6 in (0..5_usize).step_by(2) {
        let by7 = ((x - r1[i6 % 2]) + S::from_f64(0.125)).tanh();
        let b = shifted(&mut r1[1..], by7);
        let f = match roots(
            (p2.a * e),
            ((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).cos(),
        ) {
            Ok(v) => ((p2.a * S::from_f64(0.625_f64)).cos() + (-(e))),
            Err(true) => x,
            Err(_) => (p2.a * (S::from_f64(i6 as f64) * S::from_f64(0.25))),
        };
    }
    e = e
        - (((b * S::from_f64(0.375_f64)).cos() * (r1[0] * S::from_f64(-0.625_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    let z8;
    if (r1[1] * r1[1] + S::from_f64(0.25)).sqrt().cmplt(x) {
        z8 = r1[1];
    } else {
        z8 = (e * S::from_f64(-0.625_f64));
    }
    if r1[1].cmplt((f * f + S::from_f64(0.25)).sqrt()) {
        let g9 = |t: S| {
            ((x * x + S::from_f64(0.25)).sqrt() + (r1[1] * S::from_f64(0.875_f64)).max(r1[0])) * t
        };
        let f = (g9((x + x)) + g9((r1[1] * r1[1]))).sin();
    }
    p2.b = ((x * e) * S::from_f64(0.75)).sin();
    p2 = p2.tamed();
    p2.b = (x * S::from_f64(0.75)).sin();
    p2 = p2.tamed();
    ((r1[0] - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.875_f64)) + z8 + b + f + e + y + x
}

#[differentiable]
fn program_6(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.875_f64).max(y) * 0.75).sin();
    let r1 = [
        ((0.875_f64 + y) + 0.125).tanh(),
        ((-(c)) * 0.75).sin(),
        ((c * x) * 0.75).sin(),
        ((c - c) + 0.125).tanh(),
        (-1.125_f64 + 0.125).tanh(),
    ];
    let mut f = ((c * r1[2]) * 0.75).sin();
    let c =
        program_3(((f + -0.875_f64).sin() * 0.75).sin(), ((f * -0.875_f64).cos() + 0.125).tanh())
            .tanh();
    f = ((-((r1[2] * -0.625_f64).abs())) * 0.75).sin();
    let mut p2 = Pair { a: (r1[0] * 0.75).sin(), b: ((r1[3] * -1.125_f64).max(y) * 0.75).sin() };
    let c = if let Some(v) = root(x) {
        ((r1[2] / (1.5 + p2.a * p2.a)) * (r1[2] - f))
    } else {
        (r1[3] * p2.b)
    };
    let c = if (r1[0] + 0.125_f64) > (c * c + 0.25).sqrt() {
        ((f + x) * (f + x) + 0.25).sqrt()
    } else {
        ((p2.b * -1.125_f64).max(p2.b) * (x * -0.375_f64).max(r1[3]))
    };
    f -= (((p2.a - x) - 0.875_f64).tanh() + 0.125).tanh();
    let a = mixed(&r1[0..]).sin();
    f += (((p2.a * a) * 0.125_f64).abs() + 0.125).tanh();
    f *= (((p2.a - r1[4]) + (r1[1] * -1.125_f64).abs()) * 0.75).sin();
    f = (((0.125_f64 * p2.a) + (c * c + 0.25).sqrt()) * 0.75).sin();
    p2.b = ((f * r1[0]) + 0.125).tanh();
    p2 = p2.tamed();
    let a = ((-(f)) * (-(f)) + 0.25).sqrt();
    let (a, mut b) = (((-0.125_f64 * 0.875_f64).cos() + 0.125).tanh(), (x + -0.625_f64).sin());
    r1[2] + b + a + c + f + y + x
}

fn program_6_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.875_f64)).max(y) * S::from_f64(0.75)).sin();
    let r1 = [
        ((S::from_f64(0.875_f64) + y) + S::from_f64(0.125)).tanh(),
        ((-(c)) * S::from_f64(0.75)).sin(),
        ((c * x) * S::from_f64(0.75)).sin(),
        ((c - c) + S::from_f64(0.125)).tanh(),
        (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh(),
    ];
    let mut f = ((c * r1[2]) * S::from_f64(0.75)).sin();
    let c = program_3_of(
        ((f + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(),
        ((f * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    f = ((-((r1[2] * S::from_f64(-0.625_f64)).abs())) * S::from_f64(0.75)).sin();
    let mut p2 = Pair {
        a: (r1[0] * S::from_f64(0.75)).sin(),
        b: ((r1[3] * S::from_f64(-1.125_f64)).max(y) * S::from_f64(0.75)).sin(),
    };
    let c = if let Some(v) = root(x) {
        ((r1[2] / (S::from_f64(1.5) + p2.a * p2.a)) * (r1[2] - f))
    } else {
        (r1[3] * p2.b)
    };
    let c = if (r1[0] + S::from_f64(0.125_f64)).cmpgt((c * c + S::from_f64(0.25)).sqrt()) {
        ((f + x) * (f + x) + S::from_f64(0.25)).sqrt()
    } else {
        ((p2.b * S::from_f64(-1.125_f64)).max(p2.b) * (x * S::from_f64(-0.375_f64)).max(r1[3]))
    };
    f = f - (((p2.a - x) - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    let a = mixed(&r1[0..]).sin();
    f = f + (((p2.a * a) * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    f = f * (((p2.a - r1[4]) + (r1[1] * S::from_f64(-1.125_f64)).abs()) * S::from_f64(0.75)).sin();
    f = (((S::from_f64(0.125_f64) * p2.a) + (c * c + S::from_f64(0.25)).sqrt())
        * S::from_f64(0.75))
    .sin();
    p2.b = ((f * r1[0]) + S::from_f64(0.125)).tanh();
    p2 = p2.tamed();
    let a = ((-(f)) * (-(f)) + S::from_f64(0.25)).sqrt();
    let (a, mut b) = (
        ((S::from_f64(-0.125_f64) * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(-0.625_f64)).sin(),
    );
    r1[2] + b + a + c + f + y + x
}

#[differentiable]
fn program_7(x: f64, y: f64) -> f64 {
    let mut e = ((y * x) * 0.75).sin();
    let r1 = [((x + 0.125_f64).sin() * 0.75).sin(); 3];
    let mut z2;
    if (e * y) < (x + x) {
        let t = ((y - 0.125_f64).tanh()
            / (1.5 + (0.375_f64 * -1.125_f64).abs() * (0.375_f64 * -1.125_f64).abs()));
        z2 = (y * (r1[1] * x));
    } else if (y / (1.5 + y * y)) >= (-0.875_f64 + x) {
        z2 = bent((x + 0.875_f64).sin());
    } else {
        z2 = ((y - 0.125_f64).tanh()
            / (1.5 + (0.375_f64 * -1.125_f64).abs() * (0.375_f64 * -1.125_f64).abs()));
    }
    z2 = z2 * (x + 0.875_f64).sin();
    z2 = (((y * 0.125_f64).cos() * (x - e)) + 0.125).tanh();
    let mut u3 = r1.to_vec();
    u3.push((x * 0.75).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let e = match shape(((x * r1[1]) * 0.75).sin(), ((r1[1] * 0.375_f64).abs() + 0.125).tanh()) {
        Shape::Point => r1[1],
        Shape::Disc(v) => ((v / (1.5 + z2 * z2)) * 0.375_f64).max(z2),
        Shape::Box { w: v, h } => ((r1[2] - e) * 0.125_f64).max(e),
    };
    let mut u4 = r1.to_vec();
    u4.push(((x * -0.375_f64).max(0.375_f64) + 0.125).tanh());
    u4[0] = u4[1] * u4[u4.len() - 1];
    let f = (mixed(&u4) + u4[0]).tanh();
    let mut p5 = Pair { a: ((r1[0] * z2) * 0.75).sin(), b: ((d * d + 0.25).sqrt() + 0.125).tanh() };
    z2 += (((0.875_f64 * -0.375_f64).max(z2) * -1.125_f64).abs() * 0.75).sin();
    z2 -= (((0.875_f64 + 0.625_f64) * (0.875_f64 + 0.625_f64) + 0.25).sqrt() * 0.75).sin();
    z2 = (y * 0.75).sin();
    if (z2 + y) >= (y * f) {
        return ((r1[2] - f) * (r1[2] - f) + 0.25).sqrt();
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        z2 = (((n7 as f64) * 0.25) + 0.125).tanh();
        z2 = (((n7 as f64) * 0.25) + 0.125).tanh();
        let g8 = |t: f64| ((x + e) * (((n7 as f64) * 0.25) / (1.5 + p5.b * p5.b))) * t;
        let c = (g8((f * f + 0.25).sqrt()) + g8((y * 0.375_f64).abs())).sin();
    }
    ((x * r1[1]) * (e - 0.375_f64).tanh()) + f + e + d + z2 + y + x
}

fn program_7_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * x) * S::from_f64(0.75)).sin();
    let r1 = [((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 3];
    let mut z2;
    if (e * y).cmplt((x + x)) {
        let t = ((y - S::from_f64(0.125_f64)).tanh()
            / (S::from_f64(1.5)
                + (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).abs()
                    * (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).abs()));
        z2 = (y * (r1[1] * x));
    } else if (y / (S::from_f64(1.5) + y * y)).cmpge((S::from_f64(-0.875_f64) + x)) {
        z2 = bent((x + S::from_f64(0.875_f64)).sin());
    } else {
        z2 = ((y - S::from_f64(0.125_f64)).tanh()
            / (S::from_f64(1.5)
                + (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).abs()
                    * (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).abs()));
    }
    z2 = z2 * (x + S::from_f64(0.875_f64)).sin();
    z2 = (((y * S::from_f64(0.125_f64)).cos() * (x - e)) + S::from_f64(0.125)).tanh();
    let mut u3 = r1.to_vec();
    u3.push((x * S::from_f64(0.75)).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let e = match shape(
        ((x * r1[1]) * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => r1[1],
        Shape::Disc(v) => ((v / (S::from_f64(1.5) + z2 * z2)) * S::from_f64(0.375_f64)).max(z2),
        Shape::Box { w: v, h } => ((r1[2] - e) * S::from_f64(0.125_f64)).max(e),
    };
    let mut u4 = r1.to_vec();
    u4.push(
        ((x * S::from_f64(-0.375_f64)).max(S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
    );
    u4[0] = u4[1] * u4[u4.len() - 1];
    let f = (mixed(&u4) + u4[0]).tanh();
    let mut p5 = Pair {
        a: ((r1[0] * z2) * S::from_f64(0.75)).sin(),
        b: ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    };
    z2 = z2
        + (((S::from_f64(0.875_f64) * S::from_f64(-0.375_f64)).max(z2) * S::from_f64(-1.125_f64))
            .abs()
            * S::from_f64(0.75))
        .sin();
    z2 = z2
        - (((S::from_f64(0.875_f64) + S::from_f64(0.625_f64))
            * (S::from_f64(0.875_f64) + S::from_f64(0.625_f64))
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    z2 = (y * S::from_f64(0.75)).sin();
    if (z2 + y).cmpge((y * f)) {
        return ((r1[2] - f) * (r1[2] - f) + S::from_f64(0.25)).sqrt();
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        z2 = ((S::from_f64(n7 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
        z2 = ((S::from_f64(n7 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
        let g8 = |t: S| {
            ((x + e)
                * ((S::from_f64(n7 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + p5.b * p5.b)))
                * t
        };
        let c =
            (g8((f * f + S::from_f64(0.25)).sqrt()) + g8((y * S::from_f64(0.375_f64)).abs())).sin();
    }
    ((x * r1[1]) * (e - S::from_f64(0.375_f64)).tanh()) + f + e + d + z2 + y + x
}

#[differentiable]
fn program_8(x: f64, y: f64) -> f64 {
    let mut a = ((-(x)) * 0.75).sin();
    let r1 = [
        ((x + -0.375_f64).sin() * 0.75).sin(),
        ((x + 0.625_f64) + 0.125).tanh(),
        ((a * a) * 0.75).sin(),
        ((y + a) * 0.75).sin(),
        ((a * 0.625_f64).cos() + 0.125).tanh(),
    ];
    #[differentiable(checkpoint)]
    'l2: for i3 in (2..4_usize).step_by(2) {
        a = (((x * x + 0.25).sqrt() + 0.125_f64).sin() * 0.75).sin();
        if (a * r1[1]) >= (a * 0.625_f64).abs() {
            a += (r1[(i3 * i3 + 1) % 5] + 0.125).tanh();
            if (-(y)) >= (((i3 as f64) * 0.25) * -0.125_f64).max(((i3 as f64) * 0.25)) {
                a -= ((x - (r1[i3 % 5] * ((i3 as f64) * 0.25))) + 0.125).tanh();
                a *= (r1[0] * 0.75).sin();
                let c = ((r1[(i3 + 4) % 5] - r1[i3 % 5]) * 0.875_f64).max(0.875_f64);
            } else {
                a = (((-0.625_f64 * -0.125_f64).max(a) + (-0.625_f64 * 0.875_f64).max(a)) + 0.125)
                    .tanh();
            }
        }
    }
    'l4: for i5 in (0..0_usize).step_by(2) {
        let mut d = ((x * 0.125_f64).max(x) * 0.75).sin();
        #[differentiable(checkpoint)]
        'l6: for i7 in (0..5_usize).step_by(2) {
            'l8: for i9 in 0..=5_usize {
                let (a, mut b) = (
                    ((r1[3] + r1[(i7 + 3) % 5]) + 0.125).tanh(),
                    (r1[i5 % 5] / (1.5 + r1[(i5 + 2) % 5] * r1[(i5 + 2) % 5])),
                );
                let c = ((a * a + 0.25).sqrt() + (d / (1.5 + r1[1] * r1[1])));
            }
            #[differentiable(checkpoint)]
            'l10: for i11 in 2..=5_usize {
                let mut r12 = [((((i7 as f64) * 0.25) + 0.625_f64).sin() * 0.75).sin(); 2];
                d *= (d * 0.75).sin();
                d -= (((((i11 as f64) * 0.25) * ((i11 as f64) * 0.25) + 0.25).sqrt() * -0.125_f64)
                    .abs()
                    * 0.75)
                    .sin();
            }
            'l13: for i14 in 1..2_usize {
                let r15 = [
                    ((-0.375_f64 * -0.375_f64 + 0.25).sqrt() * 0.75).sin(),
                    (r1[(i7 * i7 + 1) % 5] * 0.75).sin(),
                ];
            }
        }
        d += (((y * r1[(i5 + 4) % 5]) * (d + ((i5 as f64) * 0.25))) + 0.125).tanh();
    }
    ((r1[4] - -0.875_f64).tanh() * -0.875_f64).max(y) + a + y + x
}

fn program_8_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((-(x)) * S::from_f64(0.75)).sin();
    let r1 = [
        ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((x + S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh(),
        ((a * a) * S::from_f64(0.75)).sin(),
        ((y + a) * S::from_f64(0.75)).sin(),
        ((a * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];

    'l2: for i3 in (2..4_usize).step_by(2) {
        a = (((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125_f64)).sin()
            * S::from_f64(0.75))
        .sin();
        if (a * r1[1]).cmpge((a * S::from_f64(0.625_f64)).abs()) {
            a = a + (r1[(i3 * i3 + 1) % 5] + S::from_f64(0.125)).tanh();
            if (-(y)).cmpge(
                ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                    .max((S::from_f64(i3 as f64) * S::from_f64(0.25))),
            ) {
                a = a
                    - ((x - (r1[i3 % 5] * (S::from_f64(i3 as f64) * S::from_f64(0.25))))
                        + S::from_f64(0.125))
                    .tanh();
                a = a * (r1[0] * S::from_f64(0.75)).sin();
                let c = ((r1[(i3 + 4) % 5] - r1[i3 % 5]) * S::from_f64(0.875_f64))
                    .max(S::from_f64(0.875_f64));
            } else {
                a = (((S::from_f64(-0.625_f64) * S::from_f64(-0.125_f64)).max(a)
                    + (S::from_f64(-0.625_f64) * S::from_f64(0.875_f64)).max(a))
                    + S::from_f64(0.125))
                .tanh();
            }
        }
    }
    'l4: for i5 in (0..0_usize).step_by(2) {
        let mut d = ((x * S::from_f64(0.125_f64)).max(x) * S::from_f64(0.75)).sin();

        'l6: for i7 in (0..5_usize).step_by(2) {
            'l8: for i9 in 0..=5_usize {
                let (a, mut b) = (
                    ((r1[3] + r1[(i7 + 3) % 5]) + S::from_f64(0.125)).tanh(),
                    (r1[i5 % 5] / (S::from_f64(1.5) + r1[(i5 + 2) % 5] * r1[(i5 + 2) % 5])),
                );
                let c =
                    ((a * a + S::from_f64(0.25)).sqrt() + (d / (S::from_f64(1.5) + r1[1] * r1[1])));
            }

            'l10: for i11 in 2..=5_usize {
                let mut r12 = [(((S::from_f64(i7 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.625_f64))
                .sin()
                    * S::from_f64(0.75))
                .sin(); 2];
                d = d * (d * S::from_f64(0.75)).sin();
                d = d
                    - ((((S::from_f64(i11 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i11 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.25))
                    .sqrt()
                        * S::from_f64(-0.125_f64))
                    .abs()
                        * S::from_f64(0.75))
                    .sin();
            }
            'l13: for i14 in 1..2_usize {
                let r15 = [
                    ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25))
                        .sqrt()
                        * S::from_f64(0.75))
                    .sin(),
                    (r1[(i7 * i7 + 1) % 5] * S::from_f64(0.75)).sin(),
                ];
            }
        }
        d = d
            + (((y * r1[(i5 + 4) % 5]) * (d + (S::from_f64(i5 as f64) * S::from_f64(0.25))))
                + S::from_f64(0.125))
            .tanh();
    }
    ((r1[4] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(-0.875_f64)).max(y) + a + y + x
}

#[differentiable]
fn program_9(x: f64, y: f64) -> f64 {
    let mut d = ((0.375_f64 * x) + 0.125).tanh();
    let mut r1 = [
        ((0.125_f64 * y) * 0.75).sin(),
        ((y + x) + 0.125).tanh(),
        ((x * -0.375_f64).abs() * 0.75).sin(),
        ((y / (1.5 + x * x)) * 0.75).sin(),
    ];
    let f = program_2(((r1[1] - x) * 0.75).sin(), ((x + r1[1]) + 0.125).tanh()).tanh();
    #[differentiable(checkpoint)]
    'l2: for i3 in 1..2_usize {
        if (-(y)) < (r1[(i3 + 1) % 4] * ((i3 as f64) * 0.25)) {
            continue;
        }
        let g4 = |t: f64| ((t - 0.125_f64).tanh() * t) * t;
        let e = (g4((x * r1[(i3 + 0) % 4])) + g4((-(f)))).sin();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        if (r1[n6 % 4] * -0.875_f64).max(x) >= (r1[(n6 * n6 + 1) % 4] * -1.125_f64).cos() {
            let b = match shape(((f * f) * 0.75).sin(), (r1[(n6 * n6 + 1) % 4] + 0.125).tanh()) {
                Shape::Point => (y * r1[(n6 + 0) % 4]),
                Shape::Disc(v) => (-(v * v)),
                Shape::Box { w: v, h } => ((v * v) * (-(h))),
            };
            let mut u7: Vec<_> = r1.iter().map(|v| *v * ((n6 as f64) * 0.25)).collect();
            u7.push(((r1[(n6 + 2) % 4] * -0.875_f64).max(((n6 as f64) * 0.25)) * 0.75).sin());
            u7[0] = u7[1] * u7[u7.len() - 1];
            let d = (mixed(&u7) + u7[0]).tanh();
            if n6 % 3 == 2 {
                break;
            }
        } else {
            d = (f * 0.75).sin();
            let d = if let Some(v) = root((x * -0.375_f64).abs()) {
                ((d + r1[0]) * (y / (1.5 + y * y)))
            } else {
                (f * 0.125_f64).abs()
            };
        }
    }
    if (-(x)) <= (f + y) {
        let f = match roots((r1[0] * -0.375_f64).max(r1[0]), (y + -1.125_f64).sin()) {
            Ok(v) => ((f / (1.5 + r1[2] * r1[2])) * (f / (1.5 + r1[2] * r1[2])) + 0.25).sqrt(),
            Err(true) => f,
            Err(_) => (d * -0.125_f64).max(-0.875_f64),
        };
        'l8: for i9 in 1..=3_usize {
            'l10: for i11 in (0..1_usize).step_by(2) {
                let mut p12 = Pair { a: ((d + 0.125_f64) * 0.75).sin(), b: ((-(d)) * 0.75).sin() };
                d *= ((0.625_f64 * 0.625_f64 + 0.25).sqrt() + 0.125).tanh();
            }
            let d = if (d + -0.375_f64).sin() > (-0.125_f64 * -1.125_f64).max(((i9 as f64) * 0.25))
            {
                ((d * 0.625_f64).cos() + (x * y))
            } else {
                (0.375_f64 * -0.375_f64).max(r1[i9 % 4])
            };
            r1[(i9 * i9 + 1) % 4] -=
                (((-0.375_f64 + d) * (-0.375_f64 + d) + 0.25).sqrt() + 0.125).tanh();
        }
        if (f + d) <= (f * 0.125_f64).max(d) {
            return ((d - -0.625_f64).tanh() * (d - -0.625_f64).tanh() + 0.25).sqrt();
        }
    } else {
        let e = root(d)
            .map_or((d * d + 0.25).sqrt(), |v| ((r1[1] * 0.625_f64).cos() + 0.875_f64).sin());
    }
    ((f * f + 0.25).sqrt() * (r1[1] / (1.5 + d * d))) + f + d + y + x
}

fn program_9_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((S::from_f64(0.375_f64) * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(0.125_f64) * y) * S::from_f64(0.75)).sin(),
        ((y + x) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        ((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ];
    let f = program_2_of(
        ((r1[1] - x) * S::from_f64(0.75)).sin(),
        ((x + r1[1]) + S::from_f64(0.125)).tanh(),
    )
    .tanh();

    'l2: for i3 in 1..2_usize {
        if (-(y)).cmplt((r1[(i3 + 1) % 4] * (S::from_f64(i3 as f64) * S::from_f64(0.25)))) {
            continue;
        }
        let g4 = |t: S| ((t - S::from_f64(0.125_f64)).tanh() * t) * t;
        let e = (g4((x * r1[(i3 + 0) % 4])) + g4((-(f)))).sin();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        if (r1[n6 % 4] * S::from_f64(-0.875_f64))
            .max(x)
            .cmpge((r1[(n6 * n6 + 1) % 4] * S::from_f64(-1.125_f64)).cos())
        {
            let b = match shape(
                ((f * f) * S::from_f64(0.75)).sin(),
                (r1[(n6 * n6 + 1) % 4] + S::from_f64(0.125)).tanh(),
            ) {
                Shape::Point => (y * r1[(n6 + 0) % 4]),
                Shape::Disc(v) => (-(v * v)),
                Shape::Box { w: v, h } => ((v * v) * (-(h))),
            };
            let mut u7: Vec<_> =
                r1.iter().map(|v| *v * (S::from_f64(n6 as f64) * S::from_f64(0.25))).collect();
            u7.push(
                ((r1[(n6 + 2) % 4] * S::from_f64(-0.875_f64))
                    .max((S::from_f64(n6 as f64) * S::from_f64(0.25)))
                    * S::from_f64(0.75))
                .sin(),
            );
            u7[0] = u7[1] * u7[u7.len() - 1];
            let d = (mixed(&u7) + u7[0]).tanh();
            if n6 % 3 == 2 {
                break;
            }
        } else {
            d = (f * S::from_f64(0.75)).sin();
            let d = if let Some(v) = root((x * S::from_f64(-0.375_f64)).abs()) {
                ((d + r1[0]) * (y / (S::from_f64(1.5) + y * y)))
            } else {
                (f * S::from_f64(0.125_f64)).abs()
            };
        }
    }
    if (-(x)).cmple((f + y)) {
        let f = match roots(
            (r1[0] * S::from_f64(-0.375_f64)).max(r1[0]),
            (y + S::from_f64(-1.125_f64)).sin(),
        ) {
            Ok(v) => ((f / (S::from_f64(1.5) + r1[2] * r1[2]))
                * (f / (S::from_f64(1.5) + r1[2] * r1[2]))
                + S::from_f64(0.25))
            .sqrt(),
            Err(true) => f,
            Err(_) => (d * S::from_f64(-0.125_f64)).max(S::from_f64(-0.875_f64)),
        };
        'l8: for i9 in 1..=3_usize {
            'l10: for i11 in (0..1_usize).step_by(2) {
                let mut p12 = Pair {
                    a: ((d + S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(),
                    b: ((-(d)) * S::from_f64(0.75)).sin(),
                };
                d = d
                    * ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25))
                        .sqrt()
                        + S::from_f64(0.125))
                    .tanh();
            }
            let d = if (d + S::from_f64(-0.375_f64)).sin().cmpgt(
                (S::from_f64(-0.125_f64) * S::from_f64(-1.125_f64))
                    .max((S::from_f64(i9 as f64) * S::from_f64(0.25))),
            ) {
                ((d * S::from_f64(0.625_f64)).cos() + (x * y))
            } else {
                (S::from_f64(0.375_f64) * S::from_f64(-0.375_f64)).max(r1[i9 % 4])
            };
            r1[(i9 * i9 + 1) % 4] = r1[(i9 * i9 + 1) % 4]
                - (((S::from_f64(-0.375_f64) + d) * (S::from_f64(-0.375_f64) + d)
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh();
        }
        if (f + d).cmple((f * S::from_f64(0.125_f64)).max(d)) {
            return ((d - S::from_f64(-0.625_f64)).tanh() * (d - S::from_f64(-0.625_f64)).tanh()
                + S::from_f64(0.25))
            .sqrt();
        }
    } else {
        let e = root(d).map_or((d * d + S::from_f64(0.25)).sqrt(), |v| {
            ((r1[1] * S::from_f64(0.625_f64)).cos() + S::from_f64(0.875_f64)).sin()
        });
    }
    ((f * f + S::from_f64(0.25)).sqrt() * (r1[1] / (S::from_f64(1.5) + d * d))) + f + d + y + x
}

#[differentiable]
fn program_10(x: f64, y: f64) -> f64 {
    let mut f = ((y * -0.125_f64).max(x) * 0.75).sin();
    let r1 = [((x * 0.625_f64).max(x) + 0.125).tanh(); 2];
    let z2;
    if (r1[0] + y) > (0.875_f64 + f) {
        z2 = ((r1[0] * -0.875_f64).max(x) + -0.875_f64).sin();
    } else {
        z2 = (0.375_f64 - -1.125_f64).tanh();
    }
    f = (((y * 0.625_f64).max(-1.125_f64) * (r1[1] / (1.5 + 0.875_f64 * 0.875_f64))) * 0.75).sin();
    let g3 = |t: f64| ((r1[1] + 0.125_f64) * 0.875_f64).abs() * t;
    let b = (g3((0.375_f64 + f)) + g3((x * -1.125_f64).cos())).sin();
    if (-(z2)) >= (0.375_f64 * -0.875_f64).abs() {
        return ((r1[1] * y) + x);
    }
    f *= (((-(-0.375_f64)) / (1.5 + (z2 + -0.875_f64).sin() * (z2 + -0.875_f64).sin())) + 0.125)
        .tanh();
    let mut p4 = Pair {
        a: ((f * -0.375_f64).abs() + 0.125).tanh(),
        b: ((f * -0.875_f64).abs() + 0.125).tanh(),
    };
    'l5: for i6 in 2..=1_usize {
        let c = p4.dot(&p4).sin();
        let mut r7 = [
            ((r1[(i6 + 0) % 2] * -0.625_f64).abs() + 0.125).tanh(),
            ((((i6 as f64) * 0.25) * 0.625_f64).cos() * 0.75).sin(),
        ];
    }
    f = (((f * 0.375_f64).abs() - -1.125_f64).tanh() * 0.75).sin();
    let a = match root(0.125_f64) {
        Some(v) => ((b - 0.125_f64).tanh() * 0.875_f64).cos(),
        None => (r1[1] - p4.a),
    };
    'l8: for i9 in (1..3_usize).rev() {
        if (((i9 as f64) * 0.25) * -0.125_f64).max(r1[1]) >= (r1[0] * y) {
            let b = root((p4.b / (1.5 + x * x))).map_or((p4.b * x), |v| {
                ((r1[(i9 * i9 + 1) % 2] * -0.125_f64).abs()
                    / (1.5 + (r1[i9 % 2] * r1[i9 % 2]) * (r1[i9 % 2] * r1[i9 % 2])))
            });
            let a = (-(r1[i9 % 2] * ((i9 as f64) * 0.25)));
        }
        f -= (((z2 + p4.b) * (r1[0] * -0.875_f64)) * 0.75).sin();
        f *= (((x * x + 0.25).sqrt() * (x * x + 0.25).sqrt() + 0.25).sqrt() * 0.75).sin();
    }
    ((y - -0.875_f64).tanh() + (-(r1[1]))) + a + b + z2 + f + y + x
}

fn program_10_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * S::from_f64(-0.125_f64)).max(x) * S::from_f64(0.75)).sin();
    let r1 = [((x * S::from_f64(0.625_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    let z2;
    if (r1[0] + y).cmpgt((S::from_f64(0.875_f64) + f)) {
        z2 = ((r1[0] * S::from_f64(-0.875_f64)).max(x) + S::from_f64(-0.875_f64)).sin();
    } else {
        z2 = (S::from_f64(0.375_f64) - S::from_f64(-1.125_f64)).tanh();
    }
    f = (((y * S::from_f64(0.625_f64)).max(S::from_f64(-1.125_f64))
        * (r1[1] / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64))))
        * S::from_f64(0.75))
    .sin();
    let g3 = |t: S| ((r1[1] + S::from_f64(0.125_f64)) * S::from_f64(0.875_f64)).abs() * t;
    let b = (g3((S::from_f64(0.375_f64) + f)) + g3((x * S::from_f64(-1.125_f64)).cos())).sin();
    if (-(z2)).cmpge((S::from_f64(0.375_f64) * S::from_f64(-0.875_f64)).abs()) {
        return ((r1[1] * y) + x);
    }
    f = f
        * (((-(S::from_f64(-0.375_f64)))
            / (S::from_f64(1.5)
                + (z2 + S::from_f64(-0.875_f64)).sin() * (z2 + S::from_f64(-0.875_f64)).sin()))
            + S::from_f64(0.125))
        .tanh();
    let mut p4 = Pair {
        a: ((f * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: ((f * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    'l5: for i6 in 2..=1_usize {
        let c = p4.dot(&p4).sin();
        let mut r7 = [
            ((r1[(i6 + 0) % 2] * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(0.625_f64)).cos()
                * S::from_f64(0.75))
            .sin(),
        ];
    }
    f = (((f * S::from_f64(0.375_f64)).abs() - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75))
        .sin();
    let a = match root(S::from_f64(0.125_f64)) {
        Some(v) => ((b - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.875_f64)).cos(),
        None => (r1[1] - p4.a),
    };
    'l8: for i9 in (1..3_usize).rev() {
        if ((S::from_f64(i9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
            .max(r1[1])
            .cmpge((r1[0] * y))
        {
            let b = root((p4.b / (S::from_f64(1.5) + x * x))).map_or((p4.b * x), |v| {
                ((r1[(i9 * i9 + 1) % 2] * S::from_f64(-0.125_f64)).abs()
                    / (S::from_f64(1.5) + (r1[i9 % 2] * r1[i9 % 2]) * (r1[i9 % 2] * r1[i9 % 2])))
            });
            let a = (-(r1[i9 % 2] * (S::from_f64(i9 as f64) * S::from_f64(0.25))));
        }
        f = f - (((z2 + p4.b) * (r1[0] * S::from_f64(-0.875_f64))) * S::from_f64(0.75)).sin();
        f = f
            * (((x * x + S::from_f64(0.25)).sqrt() * (x * x + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.25))
            .sqrt()
                * S::from_f64(0.75))
            .sin();
    }
    ((y - S::from_f64(-0.875_f64)).tanh() + (-(r1[1]))) + a + b + z2 + f + y + x
}

#[differentiable]
fn program_11(x: f64, y: f64) -> f64 {
    let mut d = ((y * x) + 0.125).tanh();
    let r1 = [((y * d) * 0.75).sin(); 4];
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((y + 0.375_f64).sin() * (y * r1[0]));
        if n3 > 2 || (y - -0.625_f64).tanh() > (0.625_f64 + 0.875_f64) {
            z2 = (-(r1[1] + r1[3]));
            break;
        }
    }
    'l4: for i5 in 0..=4_usize {
        d = (((r1[0] * y)
            / (1.5
                + (r1[(i5 * i5 + 1) % 4] * -0.125_f64).cos()
                    * (r1[(i5 * i5 + 1) % 4] * -0.125_f64).cos()))
            * 0.75)
            .sin();
        let mut u6: Vec<_> = r1.iter().map(|v| *v * ((i5 as f64) * 0.25)).collect();
        u6.push(((r1[2] - -1.125_f64).tanh() + 0.125).tanh());
        u6[0] = u6[1] * u6[u6.len() - 1];
        let f = (mixed(&u6) + u6[0]).tanh();
    }
    let d: f64 = r1.iter().map(|v| v * ((y * -0.875_f64).max(x) * 0.75).sin()).sum();
    let (a, mut b) = (((z2 * r1[1]) + 0.125).tanh(), (r1[1] + r1[0]));
    let mut r7 = [
        ((b - r1[2]) * 0.75).sin(),
        ((r1[0] * y) + 0.125).tanh(),
        ((-(-0.125_f64)) + 0.125).tanh(),
    ];
    r7[2] = (0.125_f64 + 0.125).tanh();
    let mut p8 = Pair { a: ((r1[3] * x) * 0.75).sin(), b: ((a / (1.5 + d * d)) * 0.75).sin() };
    let mut b = ((r1[1] - b) + 0.125).tanh();
    for v in r1.iter() {
        b = b * ((z2 * r7[2]) + 0.125).tanh() + *v * ((z2 * r7[2]) + 0.125).tanh();
    }
    if (z2 * -0.625_f64).max(b) >= (-(r7[2])) {
        return ((p8.b / (1.5 + p8.a * p8.a)) * (p8.b / (1.5 + p8.a * p8.a)) + 0.25).sqrt();
    }
    b = ((d * d) * 0.75).sin();
    b *= (d + 0.125).tanh();
    ((b * r1[0]) * (b * -0.875_f64).max(p8.b)) + b + a + d + z2 + y + x
}

fn program_11_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * x) + S::from_f64(0.125)).tanh();
    let r1 = [((y * d) * S::from_f64(0.75)).sin(); 4];
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((y + S::from_f64(0.375_f64)).sin() * (y * r1[0]));
        if n3 > 2
            || (y - S::from_f64(-0.625_f64))
                .tanh()
                .cmpgt((S::from_f64(0.625_f64) + S::from_f64(0.875_f64)))
        {
            z2 = (-(r1[1] + r1[3]));
            break;
        }
    }
    'l4: for i5 in 0..=4_usize {
        d = (((r1[0] * y)
            / (S::from_f64(1.5)
                + (r1[(i5 * i5 + 1) % 4] * S::from_f64(-0.125_f64)).cos()
                    * (r1[(i5 * i5 + 1) % 4] * S::from_f64(-0.125_f64)).cos()))
            * S::from_f64(0.75))
        .sin();
        let mut u6: Vec<_> =
            r1.iter().map(|v| *v * (S::from_f64(i5 as f64) * S::from_f64(0.25))).collect();
        u6.push(((r1[2] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh());
        u6[0] = u6[1] * u6[u6.len() - 1];
        let f = (mixed(&u6) + u6[0]).tanh();
    }
    let d = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((y * S::from_f64(-0.875_f64)).max(x) * S::from_f64(0.75)).sin()
    });
    let (a, mut b) = (((z2 * r1[1]) + S::from_f64(0.125)).tanh(), (r1[1] + r1[0]));
    let mut r7 = [
        ((b - r1[2]) * S::from_f64(0.75)).sin(),
        ((r1[0] * y) + S::from_f64(0.125)).tanh(),
        ((-(S::from_f64(-0.125_f64))) + S::from_f64(0.125)).tanh(),
    ];
    r7[2] = (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh();
    let mut p8 = Pair {
        a: ((r1[3] * x) * S::from_f64(0.75)).sin(),
        b: ((a / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
    };
    let mut b = ((r1[1] - b) + S::from_f64(0.125)).tanh();
    for v in r1.iter() {
        b = b * ((z2 * r7[2]) + S::from_f64(0.125)).tanh()
            + *v * ((z2 * r7[2]) + S::from_f64(0.125)).tanh();
    }
    if (z2 * S::from_f64(-0.625_f64)).max(b).cmpge((-(r7[2]))) {
        return ((p8.b / (S::from_f64(1.5) + p8.a * p8.a))
            * (p8.b / (S::from_f64(1.5) + p8.a * p8.a))
            + S::from_f64(0.25))
        .sqrt();
    }
    b = ((d * d) * S::from_f64(0.75)).sin();
    b = b * (d + S::from_f64(0.125)).tanh();
    ((b * r1[0]) * (b * S::from_f64(-0.875_f64)).max(p8.b)) + b + a + d + z2 + y + x
}

#[differentiable]
fn program_12(x: f64, y: f64) -> f64 {
    let mut f = ((x * -0.875_f64).max(y) + 0.125).tanh();
    let r1 = [
        ((x - -0.625_f64).tanh() * 0.75).sin(),
        ((x + 0.625_f64).sin() * 0.75).sin(),
        (0.125_f64 + 0.125).tanh(),
    ];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * f).collect();
    u2.push((f * 0.75).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let b = (mixed(&u2) + u2[0]).tanh();
    f = (((f + -1.125_f64) - -0.625_f64).tanh() * 0.75).sin();
    let mut r3 = [
        ((f + y) + 0.125).tanh(),
        ((r1[1] * 0.875_f64).max(b) + 0.125).tanh(),
        ((-(x)) + 0.125).tanh(),
        ((-(x)) + 0.125).tanh(),
        (x + 0.125).tanh(),
    ];
    let mut p4 = Pair { a: ((r1[1] * x) + 0.125).tanh(), b: ((x + 0.125_f64).sin() * 0.75).sin() };
    if (p4.b - -0.625_f64).tanh() < (y + r3[1]) {
        return (-((r3[4] - 0.625_f64).tanh()));
    }
    r3[4] -= (((-0.375_f64 * 0.625_f64).cos() + 0.625_f64).sin() + 0.125).tanh();
    let by5 = ((y + -0.625_f64).sin() + 0.125).tanh();
    for v in r3.iter_mut() {
        *v = (*v * by5).sin();
    }
    'l6: for i7 in (2..0_usize).step_by(2) {
        'l8: for i9 in (i7..3_usize).step_by(2) {
            p4 = (p4 + p4) * ((y * r3[i9 % 5]) + 0.125).tanh();
            p4 = p4.tamed();
        }
        let mut r10 = [
            ((-0.375_f64 * -0.625_f64).max(b) * 0.75).sin(),
            ((y * y + 0.25).sqrt() + 0.125).tanh(),
            ((p4.a * 0.125_f64).abs() + 0.125).tanh(),
        ];
        f -= (((r10[0] * 0.125_f64).max(x) - -0.875_f64).tanh() + 0.125).tanh();
    }
    let mut u11: Vec<_> = r3.iter().map(|v| *v * -0.875_f64).collect();
    u11.push((y * 0.75).sin());
    u11[0] = u11[1] * u11[u11.len() - 1];
    let a = (mixed(&u11) + u11[0]).tanh();
    let d = match shape((-0.875_f64 * 0.75).sin(), ((f + r1[1]) + 0.125).tanh()) {
        Shape::Point => (r3[2] + -0.875_f64),
        Shape::Disc(v) => (-(b + r3[1])),
        Shape::Box { w: v, h } => (-(a + r1[1])),
    };
    (r1[0] * r1[2]) + d + a + b + f + y + x
}

fn program_12_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x * S::from_f64(-0.875_f64)).max(y) + S::from_f64(0.125)).tanh();
    let r1 = [
        ((x - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((x + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh(),
    ];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * f).collect();
    u2.push((f * S::from_f64(0.75)).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let b = (mixed(&u2) + u2[0]).tanh();
    f = (((f + S::from_f64(-1.125_f64)) - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75))
        .sin();
    let mut r3 = [
        ((f + y) + S::from_f64(0.125)).tanh(),
        ((r1[1] * S::from_f64(0.875_f64)).max(b) + S::from_f64(0.125)).tanh(),
        ((-(x)) + S::from_f64(0.125)).tanh(),
        ((-(x)) + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(0.125)).tanh(),
    ];
    let mut p4 = Pair {
        a: ((r1[1] * x) + S::from_f64(0.125)).tanh(),
        b: ((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    if (p4.b - S::from_f64(-0.625_f64)).tanh().cmplt((y + r3[1])) {
        return (-((r3[4] - S::from_f64(0.625_f64)).tanh()));
    }
    r3[4] = r3[4]
        - (((S::from_f64(-0.375_f64) * S::from_f64(0.625_f64)).cos() + S::from_f64(0.625_f64))
            .sin()
            + S::from_f64(0.125))
        .tanh();
    let by5 = ((y + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh();
    for v in r3.iter_mut() {
        *v = (*v * by5).sin();
    }
    'l6: for i7 in (2..0_usize).step_by(2) {
        'l8: for i9 in (i7..3_usize).step_by(2) {
            p4 = (p4 + p4) * ((y * r3[i9 % 5]) + S::from_f64(0.125)).tanh();
            p4 = p4.tamed();
        }
        let mut r10 = [
            ((S::from_f64(-0.375_f64) * S::from_f64(-0.625_f64)).max(b) * S::from_f64(0.75)).sin(),
            ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            ((p4.a * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ];
        f = f
            - (((r10[0] * S::from_f64(0.125_f64)).max(x) - S::from_f64(-0.875_f64)).tanh()
                + S::from_f64(0.125))
            .tanh();
    }
    let mut u11: Vec<_> = r3.iter().map(|v| *v * S::from_f64(-0.875_f64)).collect();
    u11.push((y * S::from_f64(0.75)).sin());
    u11[0] = u11[1] * u11[u11.len() - 1];
    let a = (mixed(&u11) + u11[0]).tanh();
    let d = match shape(
        (S::from_f64(-0.875_f64) * S::from_f64(0.75)).sin(),
        ((f + r1[1]) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r3[2] + S::from_f64(-0.875_f64)),
        Shape::Disc(v) => (-(b + r3[1])),
        Shape::Box { w: v, h } => (-(a + r1[1])),
    };
    (r1[0] * r1[2]) + d + a + b + f + y + x
}

#[differentiable]
fn program_13(x: f64, y: f64) -> f64 {
    let mut d = ((x * y) * 0.75).sin();
    let mut r1 = [((y * -1.125_f64).abs() + 0.125).tanh(); 5];
    d += (((r1[4] * d) / (1.5 + (-(d)) * (-(d)))) + 0.125).tanh();
    let mut d = ((r1[3] / (1.5 + -0.125_f64 * -0.125_f64)) + 0.125).tanh();
    let g2 = |t: f64| ((x + -0.375_f64) + (d * r1[3])) * t;
    let c = (g2((0.625_f64 + d)) + g2((d * 0.625_f64).cos())).sin();
    'l3: for i4 in 1..4_usize {
        let by5 = (x * 0.75).sin();
        let b = shifted(&mut r1[4..], by5);
    }
    let e = match roots((d * r1[0]), (-(r1[1]))) {
        Ok(v) => ((c / (1.5 + d * d)) * -1.125_f64).cos(),
        Err(true) => d,
        Err(_) => (r1[1] / (1.5 + x * x)),
    };
    let a = match shape(((x * c) * 0.75).sin(), ((e * y) + 0.125).tanh()) {
        Shape::Point => (x + x),
        Shape::Disc(v) => ((y + 0.625_f64).sin() * (r1[1] * c)),
        Shape::Box { w: v, h } => v,
    };
    if (a - a) >= r1[3] {
        let e = if d < (d * d + 0.25).sqrt() {
            ((r1[2] * r1[1]) / (1.5 + (0.125_f64 / (1.5 + c * c)) * (0.125_f64 / (1.5 + c * c))))
        } else {
            ((-(0.625_f64)) + 0.375_f64).sin()
        };
    } else {
        let e: f64 = r1.iter().map(|v| v * ((c - 0.875_f64).tanh() * 0.75).sin()).sum();
    }
    let r6 = [((0.375_f64 * -0.125_f64).abs() + 0.125).tanh(); 3];
    'l7: for i8 in (2..2_usize).step_by(2) {
        let f = (-(((i8 as f64) * 0.25) + e));
        let mut n10 = 0_usize;
        'l9: while n10 < 3 {
            n10 += 1;
            let z11;
            if n10 % 3 == 0 {
                let t = ((d * d + 0.25).sqrt() * 0.125_f64).abs();
                z11 = (t - (r1[0] * r1[2]));
            } else if (f * f) >= (0.125_f64 * r1[(i8 + 3) % 5]) {
                z11 = bent((-1.125_f64 * f));
            } else {
                z11 = ((d * d + 0.25).sqrt() * 0.125_f64).abs();
            }
            d = (y + 0.125).tanh();
            let c = mixed(&r1).sin();
        }
    }
    ((a - -0.375_f64).tanh() * (r6[0] - e)) + a + e + c + d + y + x
}

fn program_13_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(); 5];
    d = d + (((r1[4] * d) / (S::from_f64(1.5) + (-(d)) * (-(d)))) + S::from_f64(0.125)).tanh();
    let mut d = ((r1[3] / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
        + S::from_f64(0.125))
    .tanh();
    let g2 = |t: S| ((x + S::from_f64(-0.375_f64)) + (d * r1[3])) * t;
    let c = (g2((S::from_f64(0.625_f64) + d)) + g2((d * S::from_f64(0.625_f64)).cos())).sin();
    'l3: for i4 in 1..4_usize {
        let by5 = (x * S::from_f64(0.75)).sin();
        let b = shifted(&mut r1[4..], by5);
    }
    let e = match roots((d * r1[0]), (-(r1[1]))) {
        Ok(v) => ((c / (S::from_f64(1.5) + d * d)) * S::from_f64(-1.125_f64)).cos(),
        Err(true) => d,
        Err(_) => (r1[1] / (S::from_f64(1.5) + x * x)),
    };
    let a = match shape(((x * c) * S::from_f64(0.75)).sin(), ((e * y) + S::from_f64(0.125)).tanh())
    {
        Shape::Point => (x + x),
        Shape::Disc(v) => ((y + S::from_f64(0.625_f64)).sin() * (r1[1] * c)),
        Shape::Box { w: v, h } => v,
    };
    if (a - a).cmpge(r1[3]) {
        let e = if d.cmplt((d * d + S::from_f64(0.25)).sqrt()) {
            ((r1[2] * r1[1])
                / (S::from_f64(1.5)
                    + (S::from_f64(0.125_f64) / (S::from_f64(1.5) + c * c))
                        * (S::from_f64(0.125_f64) / (S::from_f64(1.5) + c * c))))
        } else {
            ((-(S::from_f64(0.625_f64))) + S::from_f64(0.375_f64)).sin()
        };
    } else {
        let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((c - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin()
        });
    }
    let r6 =
        [((S::from_f64(0.375_f64) * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(); 3];
    'l7: for i8 in (2..2_usize).step_by(2) {
        let f = (-((S::from_f64(i8 as f64) * S::from_f64(0.25)) + e));
        let mut n10 = 0_usize;
        'l9: while n10 < 3 {
            n10 += 1;
            let z11;
            if n10 % 3 == 0 {
                let t = ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.125_f64)).abs();
                z11 = (t - (r1[0] * r1[2]));
            } else if (f * f).cmpge((S::from_f64(0.125_f64) * r1[(i8 + 3) % 5])) {
                z11 = bent((S::from_f64(-1.125_f64) * f));
            } else {
                z11 = ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.125_f64)).abs();
            }
            d = (y + S::from_f64(0.125)).tanh();
            let c = mixed(&r1).sin();
        }
    }
    ((a - S::from_f64(-0.375_f64)).tanh() * (r6[0] - e)) + a + e + c + d + y + x
}

#[differentiable]
fn program_14(x: f64, y: f64) -> f64 {
    let mut e = ((y * y + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [(e + 0.125).tanh(); 4];
    #[differentiable(checkpoint)]
    'l2: for i3 in (1..3_usize).step_by(2) {
        if (-0.625_f64 * y) < (x * e) {
            continue;
        }
    }
    let c = match roots((e * 0.625_f64).cos(), r1[0]) {
        Ok(v) => ((r1[1] + -0.375_f64).sin() - 0.625_f64).tanh(),
        Err(true) => y,
        Err(_) => (r1[3] * r1[1]),
    };
    let mut p4 = Pair { a: ((c * r1[0]) * 0.75).sin(), b: (r1[3] * 0.75).sin() };
    let e = match roots((y + r1[3]), (r1[2] * r1[2] + 0.25).sqrt()) {
        Ok(v) => 0.375_f64,
        Err(true) => c,
        Err(_) => (c - p4.a),
    };
    let mut d = ((r1[3] + -0.125_f64).sin() + 0.125).tanh();
    p4 = -(Pair { a: ((x * 0.375_f64).cos() + 0.125).tanh(), b: ((c * r1[2]) + 0.125).tanh() }
        - Pair { a: ((p4.a - e) * 0.75).sin(), b: ((d - r1[0]) + 0.125).tanh() })
    .tamed();
    p4 = p4.tamed();
    d = (((y * e) + (-(r1[3]))) + 0.125).tanh();
    let mut z5;
    let mut n6 = 0_usize;
    loop {
        n6 += 1;
        let t = ((-0.875_f64 * -0.875_f64 + 0.25).sqrt() - -0.625_f64).tanh();
        if n6 > 2 || (y * 0.375_f64).cos() <= (r1[0] * 0.375_f64).cos() {
            z5 = (c - -0.375_f64).tanh();
            break;
        }
    }
    z5 = z5 * y;
    let (a, mut b) = ((-0.125_f64 + 0.125).tanh(), (y / (1.5 + 0.375_f64 * 0.375_f64)));
    let e = summed(
        |t: f64| (((p4.a + a) * (p4.b * p4.b + 0.25).sqrt()) * t).sin(),
        ((c * -0.375_f64).abs() * 0.75).sin(),
        2,
    )
    .tanh();
    let mut p7 = Pair { a: (x * 0.75).sin(), b: ((r1[2] - -0.125_f64).tanh() * 0.75).sin() };
    if p7.b >= (d - -0.625_f64).tanh() {
        return ((b * -0.125_f64).abs() + (r1[1] * -0.625_f64).abs());
    }
    let mut d = ((e + -0.625_f64) * 0.75).sin();
    r1[1] + d + e + b + a + z5 + c + y + x
}

fn program_14_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [(e + S::from_f64(0.125)).tanh(); 4];

    'l2: for i3 in (1..3_usize).step_by(2) {
        if (S::from_f64(-0.625_f64) * y).cmplt((x * e)) {
            continue;
        }
    }
    let c = match roots((e * S::from_f64(0.625_f64)).cos(), r1[0]) {
        Ok(v) => ((r1[1] + S::from_f64(-0.375_f64)).sin() - S::from_f64(0.625_f64)).tanh(),
        Err(true) => y,
        Err(_) => (r1[3] * r1[1]),
    };
    let mut p4 =
        Pair { a: ((c * r1[0]) * S::from_f64(0.75)).sin(), b: (r1[3] * S::from_f64(0.75)).sin() };
    let e = match roots((y + r1[3]), (r1[2] * r1[2] + S::from_f64(0.25)).sqrt()) {
        Ok(v) => S::from_f64(0.375_f64),
        Err(true) => c,
        Err(_) => (c - p4.a),
    };
    let mut d = ((r1[3] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh();
    p4 = -(Pair {
        a: ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((c * r1[2]) + S::from_f64(0.125)).tanh(),
    } - Pair {
        a: ((p4.a - e) * S::from_f64(0.75)).sin(),
        b: ((d - r1[0]) + S::from_f64(0.125)).tanh(),
    })
    .tamed();
    p4 = p4.tamed();
    d = (((y * e) + (-(r1[3]))) + S::from_f64(0.125)).tanh();
    let mut z5;
    let mut n6 = 0_usize;
    loop {
        n6 += 1;
        let t = ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
            - S::from_f64(-0.625_f64))
        .tanh();
        if n6 > 2
            || (y * S::from_f64(0.375_f64)).cos().cmple((r1[0] * S::from_f64(0.375_f64)).cos())
        {
            z5 = (c - S::from_f64(-0.375_f64)).tanh();
            break;
        }
    }
    z5 = z5 * y;
    let (a, mut b) = (
        (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh(),
        (y / (S::from_f64(1.5) + S::from_f64(0.375_f64) * S::from_f64(0.375_f64))),
    );
    let e = summed(
        |t: S| (((p4.a + a) * (p4.b * p4.b + S::from_f64(0.25)).sqrt()) * t).sin(),
        ((c * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        2,
    )
    .tanh();
    let mut p7 = Pair {
        a: (x * S::from_f64(0.75)).sin(),
        b: ((r1[2] - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
    };
    if p7.b.cmpge((d - S::from_f64(-0.625_f64)).tanh()) {
        return ((b * S::from_f64(-0.125_f64)).abs() + (r1[1] * S::from_f64(-0.625_f64)).abs());
    }
    let mut d = ((e + S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin();
    r1[1] + d + e + b + a + z5 + c + y + x
}

#[differentiable]
fn program_15(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.375_f64) + 0.125).tanh();
    let r1 = [(x + 0.125).tanh(), ((y + x) + 0.125).tanh()];
    #[differentiable(checkpoint)]
    'l2: for i3 in (0..2_usize).rev() {
        let mut c = ((c * 0.875_f64).max(y) * 0.75).sin();
        let mut p4 = Pair {
            a: ((((i3 as f64) * 0.25) * -1.125_f64).cos() * 0.75).sin(),
            b: ((r1[1] * -0.375_f64).abs() * 0.75).sin(),
        };
        c -= (((y * x) - (r1[(i3 + 1) % 2] * r1[1])) * 0.75).sin();
    }
    let mut r5 = [((r1[0] * 0.375_f64).cos() * 0.75).sin(); 2];
    let g6 = |t: f64| ((-0.625_f64 - r5[0]) / (1.5 + r5[0] * r5[0])) * t;
    let d = (g6((c / (1.5 + x * x))) + g6((y / (1.5 + x * x)))).sin();
    if (x * 0.875_f64).abs() <= (r1[0] * -0.625_f64).max(d) {
        let mut p7 = Pair { a: ((r5[0] * d) * 0.75).sin(), b: ((0.375_f64 + x) * 0.75).sin() };
        let f = if let Some(v) = root((d / (1.5 + c * c))) {
            ((x / (1.5 + 0.375_f64 * 0.375_f64)) + (r1[0] * v))
        } else {
            (r1[1] * 0.125_f64).cos()
        };
        if (x * 0.875_f64) > y {
            c = (((r5[0] * c) - 0.125_f64).tanh() * 0.75).sin();
            c -= (((0.375_f64 * -0.125_f64).abs() * (0.375_f64 * -0.125_f64).abs() + 0.25).sqrt()
                + 0.125)
                .tanh();
        }
    }
    c *= (((y * -0.625_f64).abs() * (x + x)) + 0.125).tanh();
    let c = ((c * 0.625_f64).cos() * (y + y));
    ((x * 0.875_f64).cos() * (r1[1] * d)) + c + d + y + x
}

fn program_15_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [(x + S::from_f64(0.125)).tanh(), ((y + x) + S::from_f64(0.125)).tanh()];

    'l2: for i3 in (0..2_usize).rev() {
        let mut c = ((c * S::from_f64(0.875_f64)).max(y) * S::from_f64(0.75)).sin();
        let mut p4 = Pair {
            a: (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)).cos()
                * S::from_f64(0.75))
            .sin(),
            b: ((r1[1] * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        };
        c = c - (((y * x) - (r1[(i3 + 1) % 2] * r1[1])) * S::from_f64(0.75)).sin();
    }
    let mut r5 = [((r1[0] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(); 2];
    let g6 = |t: S| ((S::from_f64(-0.625_f64) - r5[0]) / (S::from_f64(1.5) + r5[0] * r5[0])) * t;
    let d = (g6((c / (S::from_f64(1.5) + x * x))) + g6((y / (S::from_f64(1.5) + x * x)))).sin();
    if (x * S::from_f64(0.875_f64)).abs().cmple((r1[0] * S::from_f64(-0.625_f64)).max(d)) {
        let mut p7 = Pair {
            a: ((r5[0] * d) * S::from_f64(0.75)).sin(),
            b: ((S::from_f64(0.375_f64) + x) * S::from_f64(0.75)).sin(),
        };
        let f = if let Some(v) = root((d / (S::from_f64(1.5) + c * c))) {
            ((x / (S::from_f64(1.5) + S::from_f64(0.375_f64) * S::from_f64(0.375_f64)))
                + (r1[0] * v))
        } else {
            (r1[1] * S::from_f64(0.125_f64)).cos()
        };
        if (x * S::from_f64(0.875_f64)).cmpgt(y) {
            c = (((r5[0] * c) - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
            c = c
                - (((S::from_f64(0.375_f64) * S::from_f64(-0.125_f64)).abs()
                    * (S::from_f64(0.375_f64) * S::from_f64(-0.125_f64)).abs()
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    c = c * (((y * S::from_f64(-0.625_f64)).abs() * (x + x)) + S::from_f64(0.125)).tanh();
    let c = ((c * S::from_f64(0.625_f64)).cos() * (y + y));
    ((x * S::from_f64(0.875_f64)).cos() * (r1[1] * d)) + c + d + y + x
}

#[differentiable]
fn program_16(x: f64, y: f64) -> f64 {
    let mut e = ((x * x + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [
        ((y * y + 0.25).sqrt() * 0.75).sin(),
        ((y * -0.625_f64) * 0.75).sin(),
        ((e * e + 0.25).sqrt() * 0.75).sin(),
        ((x * -0.125_f64).cos() + 0.125).tanh(),
    ];
    let (a, mut b) = ((x + 0.125).tanh(), (y + -0.625_f64).sin());
    let e = ((y * -1.125_f64).abs() + (r1[3] * y));
    let by2 = ((y - e) + 0.125).tanh();
    let b = shifted(&mut r1[3..], by2);
    r1[3] -= (((y * r1[2]) / (1.5 + (r1[3] + 0.625_f64).sin() * (r1[3] + 0.625_f64).sin()))
        + 0.125)
        .tanh();
    let d = match shape(((-0.375_f64 * x) * 0.75).sin(), ((b - b) * 0.75).sin()) {
        Point => (r1[2] + r1[0]),
        Disc(v) => -0.375_f64,
        Shape::Box { w: v, h } => x,
    };
    let mut d = ((r1[3] / (1.5 + y * y)) * 0.75).sin();
    'l3: for i4 in (1..2_usize).rev() {
        let c = program_7(((d * d + 0.25).sqrt() * 0.75).sin(), (0.375_f64 * 0.75).sin()).tanh();
        let mut u5 = r1.to_vec();
        u5.push(((x * x + 0.25).sqrt() * 0.75).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let d = (mixed(&u5) + u5[0]).tanh();
        let mut u6 = r1.to_vec();
        u6.push(((r1[(i4 + 0) % 4] * -0.375_f64).cos() + 0.125).tanh());
        u6[0] = u6[1] * u6[u6.len() - 1];
        let b = (mixed(&u6) + u6[0]).tanh();
    }
    let e: f64 = r1.iter().map(|v| v * ((e + 0.625_f64).sin() + 0.125).tanh()).sum();
    #[differentiable(checkpoint)]
    'l7: for i8 in 1..5_usize {
        let c = match shape(
            ((d * 0.625_f64).cos() * 0.75).sin(),
            ((x * r1[(i8 + 0) % 4]) + 0.125).tanh(),
        ) {
            Point => (y - -0.375_f64),
            Disc(v) => b,
            Shape::Box { w: v, h } => ((e * r1[i8 % 4]) * -1.125_f64).abs(),
        };
    }
    let d = match roots((-(a)), (-(b))) {
        Ok(v) => ((-0.375_f64 * 0.125_f64) * (r1[0] + -0.375_f64).sin()),
        Err(true) => r1[0],
        Err(_) => (b * r1[1]),
    };
    ((e * e + 0.25).sqrt() + (x * -0.875_f64).cos()) + d + e + b + a + y + x
}

fn program_16_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
        ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let (a, mut b) = ((x + S::from_f64(0.125)).tanh(), (y + S::from_f64(-0.625_f64)).sin());
    let e = ((y * S::from_f64(-1.125_f64)).abs() + (r1[3] * y));
    let by2 = ((y - e) + S::from_f64(0.125)).tanh();
    let b = shifted(&mut r1[3..], by2);
    r1[3] = r1[3]
        - (((y * r1[2])
            / (S::from_f64(1.5)
                + (r1[3] + S::from_f64(0.625_f64)).sin()
                    * (r1[3] + S::from_f64(0.625_f64)).sin()))
            + S::from_f64(0.125))
        .tanh();
    let d = match shape(
        ((S::from_f64(-0.375_f64) * x) * S::from_f64(0.75)).sin(),
        ((b - b) * S::from_f64(0.75)).sin(),
    ) {
        Point => (r1[2] + r1[0]),
        Disc(v) => S::from_f64(-0.375_f64),
        Shape::Box { w: v, h } => x,
    };
    let mut d = ((r1[3] / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin();
    'l3: for i4 in (1..2_usize).rev() {
        let c = program_7_of(
            ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            (S::from_f64(0.375_f64) * S::from_f64(0.75)).sin(),
        )
        .tanh();
        let mut u5 = r1.to_vec();
        u5.push(((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let d = (mixed(&u5) + u5[0]).tanh();
        let mut u6 = r1.to_vec();
        u6.push(((r1[(i4 + 0) % 4] * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh());
        u6[0] = u6[1] * u6[u6.len() - 1];
        let b = (mixed(&u6) + u6[0]).tanh();
    }
    let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((e + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh()
    });

    'l7: for i8 in 1..5_usize {
        let c = match shape(
            ((d * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin(),
            ((x * r1[(i8 + 0) % 4]) + S::from_f64(0.125)).tanh(),
        ) {
            Point => (y - S::from_f64(-0.375_f64)),
            Disc(v) => b,
            Shape::Box { w: v, h } => ((e * r1[i8 % 4]) * S::from_f64(-1.125_f64)).abs(),
        };
    }
    let d = match roots((-(a)), (-(b))) {
        Ok(v) => {
            ((S::from_f64(-0.375_f64) * S::from_f64(0.125_f64))
                * (r1[0] + S::from_f64(-0.375_f64)).sin())
        }
        Err(true) => r1[0],
        Err(_) => (b * r1[1]),
    };
    ((e * e + S::from_f64(0.25)).sqrt() + (x * S::from_f64(-0.875_f64)).cos())
        + d
        + e
        + b
        + a
        + y
        + x
}

#[differentiable]
fn program_17(x: f64, y: f64) -> f64 {
    let mut a = ((x * x) * 0.75).sin();
    let mut r1 = [((y * -1.125_f64).cos() * 0.75).sin(); 3];
    let d = ((-0.625_f64 * -0.625_f64 + 0.25).sqrt() * -0.125_f64).cos();
    let mut p2 = Pair { a: (x + 0.125).tanh(), b: ((a - 0.875_f64).tanh() * 0.75).sin() };
    let d = mixed(&r1[1..]).sin();
    'l3: for i4 in 2..1_usize {
        let mut f = ((r1[(i4 + 2) % 3] + ((i4 as f64) * 0.25)) * 0.75).sin();
        p2 = (p2 * p2
            + Pair {
                a: ((x * -0.125_f64).cos() + 0.125).tanh(),
                b: ((p2.b + -0.375_f64).sin() * 0.75).sin(),
            })
        .tamed();
        p2 = p2.tamed();
    }
    r1[1] = (((r1[0] * -0.625_f64) * 0.125_f64).abs() * 0.75).sin();
    let by5 = ((y + 0.875_f64) * 0.75).sin();
    for v in r1.iter_mut() {
        *v = (*v * by5).sin();
    }
    let b = ((r1[0] - y) * (y * r1[1]));
    let mut r6 = [((r1[0] * 0.375_f64) * 0.75).sin(), ((d + p2.a) * 0.75).sin()];
    a = (((d + -0.375_f64).sin() * (d + -0.375_f64).sin() + 0.25).sqrt() * 0.75).sin();
    a = (r1[1] * 0.75).sin();
    let mut u7 = r6.to_vec();
    u7.push(((-1.125_f64 * -1.125_f64 + 0.25).sqrt() * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let f = (mixed(&u7) + u7[0]).tanh();
    let d: f64 = r1.iter().map(|v| v * ((0.875_f64 * -0.875_f64).max(y) + 0.125).tanh()).sum();
    ((r1[1] * 0.125_f64).abs() * -0.875_f64).max(a) + d + f + b + a + y + x
}

fn program_17_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * x) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(); 3];
    let d = ((S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25)).sqrt()
        * S::from_f64(-0.125_f64))
    .cos();
    let mut p2 = Pair {
        a: (x + S::from_f64(0.125)).tanh(),
        b: ((a - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
    };
    let d = mixed(&r1[1..]).sin();
    'l3: for i4 in 2..1_usize {
        let mut f = ((r1[(i4 + 2) % 3] + (S::from_f64(i4 as f64) * S::from_f64(0.25)))
            * S::from_f64(0.75))
        .sin();
        p2 = (p2 * p2
            + Pair {
                a: ((x * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                b: ((p2.b + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
            })
        .tamed();
        p2 = p2.tamed();
    }
    r1[1] = (((r1[0] * S::from_f64(-0.625_f64)) * S::from_f64(0.125_f64)).abs()
        * S::from_f64(0.75))
    .sin();
    let by5 = ((y + S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin();
    for v in r1.iter_mut() {
        *v = (*v * by5).sin();
    }
    let b = ((r1[0] - y) * (y * r1[1]));
    let mut r6 = [
        ((r1[0] * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        ((d + p2.a) * S::from_f64(0.75)).sin(),
    ];
    a = (((d + S::from_f64(-0.375_f64)).sin() * (d + S::from_f64(-0.375_f64)).sin()
        + S::from_f64(0.25))
    .sqrt()
        * S::from_f64(0.75))
    .sin();
    a = (r1[1] * S::from_f64(0.75)).sin();
    let mut u7 = r6.to_vec();
    u7.push(
        ((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
    );
    u7[0] = u7[1] * u7[u7.len() - 1];
    let f = (mixed(&u7) + u7[0]).tanh();
    let d = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v
            * ((S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)).max(y) + S::from_f64(0.125))
                .tanh()
    });
    ((r1[1] * S::from_f64(0.125_f64)).abs() * S::from_f64(-0.875_f64)).max(a)
        + d
        + f
        + b
        + a
        + y
        + x
}

#[differentiable]
fn program_18(x: f64, y: f64) -> f64 {
    let mut e = ((y * -0.375_f64).max(x) * 0.75).sin();
    let mut r1 = [
        ((e + y) * 0.75).sin(),
        ((e + -0.375_f64).sin() * 0.75).sin(),
        ((e * 0.375_f64).max(0.625_f64) * 0.75).sin(),
        ((y * 0.125_f64).cos() * 0.75).sin(),
        ((x + y) + 0.125).tanh(),
    ];
    let d = if let Some(v) = root((r1[4] * -0.875_f64).max(r1[2])) {
        ((r1[1] * -0.875_f64).max(x) * -0.125_f64).abs()
    } else {
        (y - -0.125_f64).tanh()
    };
    let c = ((x * x + 0.25).sqrt() + (r1[0] * r1[0] + 0.25).sqrt());
    #[differentiable(checkpoint)]
    'l2: for i3 in 2..3_usize {
        r1[3] -= (r1[2] * 0.75).sin();
    }
    if (y * y) < (x * x + 0.25).sqrt() {
        let mut p4 = Pair { a: ((d - e) + 0.125).tanh(), b: ((r1[0] - r1[0]) * 0.75).sin() };
        let c: f64 = r1.iter().map(|v| v * ((c * c + 0.25).sqrt() + 0.125).tanh()).sum();
        let e = match roots(d, (-1.125_f64 / (1.5 + r1[2] * r1[2]))) {
            Ok(v) => ((0.375_f64 - r1[0]) * -0.875_f64).max(e),
            Err(true) => -0.875_f64,
            Err(_) => (0.875_f64 * p4.b),
        };
    }
    let r5 = [
        ((e + c) * 0.75).sin(),
        (r1[0] * 0.75).sin(),
        ((r1[2] * r1[2] + 0.25).sqrt() + 0.125).tanh(),
    ];
    if (r5[1] * r5[2]) > (e * y) {
        e -= (((c * -1.125_f64).cos() * 0.125_f64).max(-0.875_f64) + 0.125).tanh();
    }
    'l6: for i7 in 1..=2_usize {
        let f = mixed(&r1[..1]).sin();
        r1[(i7 + 1) % 5] *= (((d * ((i7 as f64) * 0.25)) + 0.875_f64).sin() * 0.75).sin();
        let e = match roots((r5[1] / (1.5 + -0.625_f64 * -0.625_f64)), (-(-1.125_f64))) {
            Ok(v) => ((d * -0.625_f64).abs() + (r1[4] + -0.375_f64).sin()),
            Err(true) => ((i7 as f64) * 0.25),
            Err(_) => (r1[(i7 * i7 + 1) % 5] / (1.5 + r5[1] * r5[1])),
        };
    }
    ((c * -0.875_f64).abs() + -1.125_f64).sin() + c + d + e + y + x
}

fn program_18_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * S::from_f64(-0.375_f64)).max(x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((e + y) * S::from_f64(0.75)).sin(),
        ((e + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((e * S::from_f64(0.375_f64)).max(S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin(),
        ((x + y) + S::from_f64(0.125)).tanh(),
    ];
    let d = if let Some(v) = root((r1[4] * S::from_f64(-0.875_f64)).max(r1[2])) {
        ((r1[1] * S::from_f64(-0.875_f64)).max(x) * S::from_f64(-0.125_f64)).abs()
    } else {
        (y - S::from_f64(-0.125_f64)).tanh()
    };
    let c = ((x * x + S::from_f64(0.25)).sqrt() + (r1[0] * r1[0] + S::from_f64(0.25)).sqrt());

    'l2: for i3 in 2..3_usize {
        r1[3] = r1[3] - (r1[2] * S::from_f64(0.75)).sin();
    }
    if (y * y).cmplt((x * x + S::from_f64(0.25)).sqrt()) {
        let mut p4 = Pair {
            a: ((d - e) + S::from_f64(0.125)).tanh(),
            b: ((r1[0] - r1[0]) * S::from_f64(0.75)).sin(),
        };
        let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((c * c + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh()
        });
        let e = match roots(d, (S::from_f64(-1.125_f64) / (S::from_f64(1.5) + r1[2] * r1[2]))) {
            Ok(v) => ((S::from_f64(0.375_f64) - r1[0]) * S::from_f64(-0.875_f64)).max(e),
            Err(true) => S::from_f64(-0.875_f64),
            Err(_) => (S::from_f64(0.875_f64) * p4.b),
        };
    }
    let r5 = [
        ((e + c) * S::from_f64(0.75)).sin(),
        (r1[0] * S::from_f64(0.75)).sin(),
        ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    ];
    if (r5[1] * r5[2]).cmpgt((e * y)) {
        e = e
            - (((c * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.125_f64))
                .max(S::from_f64(-0.875_f64))
                + S::from_f64(0.125))
            .tanh();
    }
    'l6: for i7 in 1..=2_usize {
        let f = mixed(&r1[..1]).sin();
        r1[(i7 + 1) % 5] = r1[(i7 + 1) % 5]
            * (((d * (S::from_f64(i7 as f64) * S::from_f64(0.25))) + S::from_f64(0.875_f64)).sin()
                * S::from_f64(0.75))
            .sin();
        let e = match roots(
            (r5[1] / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64))),
            (-(S::from_f64(-1.125_f64))),
        ) {
            Ok(v) => {
                ((d * S::from_f64(-0.625_f64)).abs() + (r1[4] + S::from_f64(-0.375_f64)).sin())
            }
            Err(true) => (S::from_f64(i7 as f64) * S::from_f64(0.25)),
            Err(_) => (r1[(i7 * i7 + 1) % 5] / (S::from_f64(1.5) + r5[1] * r5[1])),
        };
    }
    ((c * S::from_f64(-0.875_f64)).abs() + S::from_f64(-1.125_f64)).sin() + c + d + e + y + x
}

#[differentiable]
fn program_19(x: f64, y: f64) -> f64 {
    let mut f = ((y * x) + 0.125).tanh();
    let r1 = [((y / (1.5 + x * x)) * 0.75).sin(); 3];
    f = ((r1[1] * -0.625_f64).abs() * 0.75).sin();
    for v in r1.iter() {
        f = f * ((f * f) * 0.75).sin() + *v * ((f * f) * 0.75).sin();
    }
    'l2: for i3 in 2..=4_usize {
        let mut p4 = Pair {
            a: ((x / (1.5 + r1[1] * r1[1])) + 0.125).tanh(),
            b: ((r1[(i3 + 0) % 3] / (1.5 + y * y)) * 0.75).sin(),
        };
    }
    f *= (((x + 0.125_f64).sin() - 0.125_f64).tanh() + 0.125).tanh();
    let d = summed(|t: f64| (((y * f) * (r1[1] - f)) * t).sin(), (r1[1] + 0.125).tanh(), 0).tanh();
    f += (f * 0.75).sin();
    if (r1[2] + x) > (y * x) {
        let d: f64 = r1.iter().map(|v| v * ((x * x) + 0.125).tanh()).sum();
        let e = ((x - r1[1]) / (1.5 + (y * r1[1]) * (y * r1[1])));
    }
    let mut p5 =
        Pair { a: ((x * -0.125_f64).cos() * 0.75).sin(), b: ((f + 0.375_f64) + 0.125).tanh() };
    f = (((p5.a / (1.5 + p5.b * p5.b)) * (p5.a / (1.5 + p5.b * p5.b)) + 0.25).sqrt() + 0.125)
        .tanh();
    let (a, mut b) = (((x * 0.375_f64).max(-0.125_f64) * 0.75).sin(), r1[1]);
    let mut p6 =
        Pair { a: ((a + b) + 0.125).tanh(), b: ((p5.b * -0.375_f64).cos() + 0.125).tanh() };
    (r1[2] + 0.125_f64).sin() + b + a + d + f + y + x
}

fn program_19_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * x) + S::from_f64(0.125)).tanh();
    let r1 = [((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(); 3];
    f = ((r1[1] * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin();
    for v in r1.iter() {
        f = f * ((f * f) * S::from_f64(0.75)).sin() + *v * ((f * f) * S::from_f64(0.75)).sin();
    }
    'l2: for i3 in 2..=4_usize {
        let mut p4 = Pair {
            a: ((x / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh(),
            b: ((r1[(i3 + 0) % 3] / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
        };
    }
    f = f
        * (((x + S::from_f64(0.125_f64)).sin() - S::from_f64(0.125_f64)).tanh()
            + S::from_f64(0.125))
        .tanh();
    let d =
        summed(|t: S| (((y * f) * (r1[1] - f)) * t).sin(), (r1[1] + S::from_f64(0.125)).tanh(), 0)
            .tanh();
    f = f + (f * S::from_f64(0.75)).sin();
    if (r1[2] + x).cmpgt((y * x)) {
        let d = r1
            .iter()
            .fold(S::from_f64(-0.0), |s, v| s + *v * ((x * x) + S::from_f64(0.125)).tanh());
        let e = ((x - r1[1]) / (S::from_f64(1.5) + (y * r1[1]) * (y * r1[1])));
    }
    let mut p5 = Pair {
        a: ((x * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((f + S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
    };
    f = (((p5.a / (S::from_f64(1.5) + p5.b * p5.b)) * (p5.a / (S::from_f64(1.5) + p5.b * p5.b))
        + S::from_f64(0.25))
    .sqrt()
        + S::from_f64(0.125))
    .tanh();
    let (a, mut b) = (
        ((x * S::from_f64(0.375_f64)).max(S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        r1[1],
    );
    let mut p6 = Pair {
        a: ((a + b) + S::from_f64(0.125)).tanh(),
        b: ((p5.b * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    (r1[2] + S::from_f64(0.125_f64)).sin() + b + a + d + f + y + x
}

#[differentiable]
fn program_20(x: f64, y: f64) -> f64 {
    let mut d = (x + 0.125).tanh();
    let mut r1 = [((d - -1.125_f64).tanh() * 0.75).sin(); 4];
    d = (y * 0.75).sin();
    d -= (((r1[2] - x) * d) + 0.125).tanh();
    r1[3] -= ((-(d - d)) + 0.125).tanh();
    let f = program_17(
        ((y + 0.875_f64).sin() * 0.75).sin(),
        ((-0.875_f64 / (1.5 + d * d)) + 0.125).tanh(),
    )
    .tanh();
    let mut p2 =
        Pair { a: ((r1[1] + f) * 0.75).sin(), b: ((r1[0] - -1.125_f64).tanh() + 0.125).tanh() };
    if (d + r1[2]) < (r1[1] - f) {
        return ((r1[3] * -0.625_f64) * (r1[3] * -0.625_f64) + 0.25).sqrt();
    }
    let by3 = ((-0.125_f64 * -0.625_f64).abs() * 0.75).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    let mut u4 = r1.to_vec();
    u4.push((r1[2] + 0.125).tanh());
    u4[0] = u4[1] * u4[u4.len() - 1];
    let e = (mixed(&u4) + u4[0]).tanh();
    let f = match root((0.125_f64 * e)) {
        Some(v) => x,
        None => (d * d + 0.25).sqrt(),
    };
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        let mut p7 = Pair {
            a: ((r1[(n6 + 1) % 4] - 0.625_f64).tanh() * 0.75).sin(),
            b: ((((n6 as f64) * 0.25) * 0.625_f64) + 0.125).tanh(),
        };
    }
    #[differentiable(checkpoint)]
    'l8: for i9 in 1..=4_usize {
        if i9 % 3 == 0 {
            p2 += p2;
            p2 = p2.tamed();
            let mut p10 = Pair {
                a: ((r1[i9 % 4] * 0.125_f64).abs() * 0.75).sin(),
                b: ((y + r1[(i9 * i9 + 1) % 4]) * 0.75).sin(),
            };
            let a = match shape(
                ((y * ((i9 as f64) * 0.25)) + 0.125).tanh(),
                ((((i9 as f64) * 0.25) * e) * 0.75).sin(),
            ) {
                Point => -1.125_f64,
                Disc(v) => ((i9 as f64) * 0.25),
                Shape::Box { w: v, h } => (r1[i9 % 4] * (h - h)),
            };
        } else {
            r1[3] *= (((-0.625_f64 * -0.625_f64 + 0.25).sqrt() + -1.125_f64).sin() + 0.125).tanh();
            let e: f64 = r1.iter().map(|v| v * ((f * -1.125_f64).cos() + 0.125).tanh()).sum();
            for v in r1.iter() {
                d = d * ((d - -0.875_f64).tanh() * 0.75).sin()
                    + *v * ((d - -0.875_f64).tanh() * 0.75).sin();
            }
        }
        let a = ((r1[i9 % 4] + y) / (1.5 + r1[i9 % 4] * r1[i9 % 4]));
    }
    ((-(d)) + p2.a) + f + e + d + y + x
}

fn program_20_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((d - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(); 4];
    d = (y * S::from_f64(0.75)).sin();
    d = d - (((r1[2] - x) * d) + S::from_f64(0.125)).tanh();
    r1[3] = r1[3] - ((-(d - d)) + S::from_f64(0.125)).tanh();
    let f = program_17_of(
        ((y + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.875_f64) / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut p2 = Pair {
        a: ((r1[1] + f) * S::from_f64(0.75)).sin(),
        b: ((r1[0] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    if (d + r1[2]).cmplt((r1[1] - f)) {
        return ((r1[3] * S::from_f64(-0.625_f64)) * (r1[3] * S::from_f64(-0.625_f64))
            + S::from_f64(0.25))
        .sqrt();
    }
    let by3 = ((S::from_f64(-0.125_f64) * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    let mut u4 = r1.to_vec();
    u4.push((r1[2] + S::from_f64(0.125)).tanh());
    u4[0] = u4[1] * u4[u4.len() - 1];
    let e = (mixed(&u4) + u4[0]).tanh();
    let f = match root((S::from_f64(0.125_f64) * e)) {
        Some(v) => x,
        None => (d * d + S::from_f64(0.25)).sqrt(),
    };
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        let mut p7 = Pair {
            a: ((r1[(n6 + 1) % 4] - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
            b: (((S::from_f64(n6 as f64) * S::from_f64(0.25)) * S::from_f64(0.625_f64))
                + S::from_f64(0.125))
            .tanh(),
        };
    }

    'l8: for i9 in 1..=4_usize {
        if i9 % 3 == 0 {
            p2 += p2;
            p2 = p2.tamed();
            let mut p10 = Pair {
                a: ((r1[i9 % 4] * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
                b: ((y + r1[(i9 * i9 + 1) % 4]) * S::from_f64(0.75)).sin(),
            };
            let a = match shape(
                ((y * (S::from_f64(i9 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
                (((S::from_f64(i9 as f64) * S::from_f64(0.25)) * e) * S::from_f64(0.75)).sin(),
            ) {
                Point => S::from_f64(-1.125_f64),
                Disc(v) => (S::from_f64(i9 as f64) * S::from_f64(0.25)),
                Shape::Box { w: v, h } => (r1[i9 % 4] * (h - h)),
            };
        } else {
            r1[3] = r1[3]
                * (((S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25))
                    .sqrt()
                    + S::from_f64(-1.125_f64))
                .sin()
                    + S::from_f64(0.125))
                .tanh();
            let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v * ((f * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh()
            });
            for v in r1.iter() {
                d = d * ((d - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin()
                    + *v * ((d - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
            }
        }
        let a = ((r1[i9 % 4] + y) / (S::from_f64(1.5) + r1[i9 % 4] * r1[i9 % 4]));
    }
    ((-(d)) + p2.a) + f + e + d + y + x
}

#[differentiable]
fn program_21(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((x * f) * 0.75).sin(); 3];
    r1[1] = (x + 0.125).tanh();
    'l2: for i3 in (2..4_usize).step_by(2) {
        let mut p4 = Pair { a: ((f * -0.625_f64).abs() * 0.75).sin(), b: (x * 0.75).sin() };
    }
    let (a, mut b) = (((f - f) * 0.75).sin(), (r1[2] * -0.875_f64).cos());
    b += ((r1[0] - (r1[1] * r1[1] + 0.25).sqrt()) * 0.75).sin();
    let mut p5 = Pair { a: ((y * y + 0.25).sqrt() + 0.125).tanh(), b: ((x + a) * 0.75).sin() };
    let r6 = [
        ((b - -0.125_f64).tanh() + 0.125).tanh(),
        ((p5.a * r1[1]) + 0.125).tanh(),
        (y * 0.75).sin(),
    ];
    let b = match roots((f / (1.5 + f * f)), (f + 0.375_f64).sin()) {
        Ok(v) => ((f * -0.375_f64) * -0.625_f64).cos(),
        Err(true) => x,
        Err(_) => (b * x),
    };
    'l7: for i8 in 1..2_usize {
        let d = summed(bent, ((-0.125_f64 / (1.5 + p5.b * p5.b)) + 0.125).tanh(), 3).tanh();
        p5 = (p5 + p5) * (x * 0.75).sin();
        p5 = p5.tamed();
    }
    let mut r9 =
        [((y * -1.125_f64).abs() * 0.75).sin(), ((-0.375_f64 - -0.375_f64).tanh() * 0.75).sin()];
    'l10: for i11 in (0..0_usize).rev() {
        p5 += p5;
        p5 = p5.tamed();
        let mut p12 = Pair {
            a: ((p5.b * p5.b + 0.25).sqrt() + 0.125).tanh(),
            b: ((r9[(i11 + 0) % 2] - -0.625_f64).tanh() + 0.125).tanh(),
        };
    }
    (-(y - r1[2])) + b + a + f + y + x
}

fn program_21_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * f) * S::from_f64(0.75)).sin(); 3];
    r1[1] = (x + S::from_f64(0.125)).tanh();
    'l2: for i3 in (2..4_usize).step_by(2) {
        let mut p4 = Pair {
            a: ((f * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
            b: (x * S::from_f64(0.75)).sin(),
        };
    }
    let (a, mut b) = (((f - f) * S::from_f64(0.75)).sin(), (r1[2] * S::from_f64(-0.875_f64)).cos());
    b = b + ((r1[0] - (r1[1] * r1[1] + S::from_f64(0.25)).sqrt()) * S::from_f64(0.75)).sin();
    let mut p5 = Pair {
        a: ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        b: ((x + a) * S::from_f64(0.75)).sin(),
    };
    let r6 = [
        ((b - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((p5.a * r1[1]) + S::from_f64(0.125)).tanh(),
        (y * S::from_f64(0.75)).sin(),
    ];
    let b = match roots((f / (S::from_f64(1.5) + f * f)), (f + S::from_f64(0.375_f64)).sin()) {
        Ok(v) => ((f * S::from_f64(-0.375_f64)) * S::from_f64(-0.625_f64)).cos(),
        Err(true) => x,
        Err(_) => (b * x),
    };
    'l7: for i8 in 1..2_usize {
        let d = summed(
            bent,
            ((S::from_f64(-0.125_f64) / (S::from_f64(1.5) + p5.b * p5.b)) + S::from_f64(0.125))
                .tanh(),
            3,
        )
        .tanh();
        p5 = (p5 + p5) * (x * S::from_f64(0.75)).sin();
        p5 = p5.tamed();
    }
    let mut r9 = [
        ((y * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
    ];
    'l10: for i11 in (0..0_usize).rev() {
        p5 += p5;
        p5 = p5.tamed();
        let mut p12 = Pair {
            a: ((p5.b * p5.b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            b: ((r9[(i11 + 0) % 2] - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
        };
    }
    (-(y - r1[2])) + b + a + f + y + x
}

#[differentiable]
fn program_22(x: f64, y: f64) -> f64 {
    let mut d = ((y * y + 0.25).sqrt() + 0.125).tanh();
    let mut r1 =
        [((0.875_f64 / (1.5 + 0.625_f64 * 0.625_f64)) * 0.75).sin(), ((d + x) + 0.125).tanh()];
    let mut r2 =
        [((y + r1[1]) + 0.125).tanh(), (r1[0] * 0.75).sin(), ((r1[1] * 0.375_f64) * 0.75).sin()];
    'l3: for i4 in (2..5_usize).rev() {
        let f = if i4 % 4 == 0 { (y - (r1[1] * r2[(i4 + 1) % 3])) } else { d };
        r2[(i4 * i4 + 1) % 3] = (((r2[(i4 + 0) % 3] - x) * 0.875_f64).max(x) * 0.75).sin();
    }
    if (r2[0] - d) <= (-(x)) {
        let mut p5 = Pair { a: ((r1[1] + x) + 0.125).tanh(), b: (x + 0.125).tanh() };
        let f = if (d + r1[1]) >= (d * p5.b) { y } else { (r2[0] + (r1[1] + y)) };
        let g6 = |t: f64, v: &[f64]| mixed(v) * t + (p5.a).tanh();
        let c = folded(&g6, ((-1.125_f64 * -1.125_f64 + 0.25).sqrt() + 0.125).tanh(), &r1).sin();
    } else {
        d *= (((x - d) * (r2[2] + d)) * 0.75).sin();
    }
    d += (((y * y + 0.25).sqrt() * -0.875_f64).abs() * 0.75).sin();
    d = (((-1.125_f64 + y) * (d - -1.125_f64).tanh()) + 0.125).tanh();
    'l7: for i8 in (2..2_usize).step_by(2) {
        let a = if i8 % 4 == 2 {
            (-((0.375_f64 * -0.375_f64).max(d)))
        } else {
            ((-((i8 as f64) * 0.25)) * (-((i8 as f64) * 0.25)) + 0.25).sqrt()
        };
    }
    r1[0] -= (((-0.125_f64 + y) * (y + x)) * 0.75).sin();
    ((x / (1.5 + x * x)) + -0.125_f64).sin() + d + y + x
}

fn program_22_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(0.875_f64)
            / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
            * S::from_f64(0.75))
        .sin(),
        ((d + x) + S::from_f64(0.125)).tanh(),
    ];
    let mut r2 = [
        ((y + r1[1]) + S::from_f64(0.125)).tanh(),
        (r1[0] * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
    ];
    'l3: for i4 in (2..5_usize).rev() {
        let f = if i4 % 4 == 0 { (y - (r1[1] * r2[(i4 + 1) % 3])) } else { d };
        r2[(i4 * i4 + 1) % 3] =
            (((r2[(i4 + 0) % 3] - x) * S::from_f64(0.875_f64)).max(x) * S::from_f64(0.75)).sin();
    }
    if (r2[0] - d).cmple((-(x))) {
        let mut p5 = Pair {
            a: ((r1[1] + x) + S::from_f64(0.125)).tanh(),
            b: (x + S::from_f64(0.125)).tanh(),
        };
        let f = if (d + r1[1]).cmpge((d * p5.b)) { y } else { (r2[0] + (r1[1] + y)) };
        let g6 = |t: S, v: &[S]| mixed(v) * t + (p5.a).tanh();
        let c = folded(
            &g6,
            ((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.125))
            .tanh(),
            &r1,
        )
        .sin();
    } else {
        d = d * (((x - d) * (r2[2] + d)) * S::from_f64(0.75)).sin();
    }
    d = d
        + (((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(-0.875_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    d = (((S::from_f64(-1.125_f64) + y) * (d - S::from_f64(-1.125_f64)).tanh())
        + S::from_f64(0.125))
    .tanh();
    'l7: for i8 in (2..2_usize).step_by(2) {
        let a = if i8 % 4 == 2 {
            (-((S::from_f64(0.375_f64) * S::from_f64(-0.375_f64)).max(d)))
        } else {
            ((-(S::from_f64(i8 as f64) * S::from_f64(0.25)))
                * (-(S::from_f64(i8 as f64) * S::from_f64(0.25)))
                + S::from_f64(0.25))
            .sqrt()
        };
    }
    r1[0] = r1[0] - (((S::from_f64(-0.125_f64) + y) * (y + x)) * S::from_f64(0.75)).sin();
    ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(-0.125_f64)).sin() + d + y + x
}

#[differentiable]
fn program_23(x: f64, y: f64) -> f64 {
    let mut f = ((y - y) + 0.125).tanh();
    let mut r1 = [((f - f) + 0.125).tanh(); 5];
    let mut p2 = Pair { a: ((y * x) + 0.125).tanh(), b: ((y * 0.375_f64).cos() + 0.125).tanh() };
    #[differentiable(checkpoint)]
    'l3: for i4 in (0..4_usize).step_by(2) {
        r1[(i4 * i4 + 1) % 5] -= (y * 0.75).sin();
        'l5: for i6 in (i4..3_usize).step_by(2) {
            p2.b = ((f + x) * 0.75).sin();
            p2 = p2.tamed();
            r1[(i4 + 1) % 5] =
                (((r1[i6 % 5] * r1[i6 % 5] + 0.25).sqrt() + (r1[(i6 * i6 + 1) % 5] - x)) + 0.125)
                    .tanh();
            let f = match shape(
                ((y * -0.125_f64).cos() * 0.75).sin(),
                ((r1[(i4 * i4 + 1) % 5] + -1.125_f64) + 0.125).tanh(),
            ) {
                Point => (((i4 as f64) * 0.25) * -0.875_f64).cos(),
                Disc(v) => (v - -0.625_f64).tanh(),
                Shape::Box { w: v, h } => ((r1[(i6 + 1) % 5] + 0.625_f64).sin() - 0.375_f64).tanh(),
            };
        }
        r1[i4 % 5] -=
            (((r1[(i4 * i4 + 1) % 5] + -0.875_f64).sin() + -0.125_f64).sin() + 0.125).tanh();
    }
    let a = match roots((r1[4] * 0.125_f64).max(y), x) {
        Ok(v) => (-0.875_f64 * 0.125_f64).cos(),
        Err(true) => r1[1],
        Err(_) => (r1[3] * r1[3]),
    };
    p2 = (p2 * Pair { a: ((f * r1[4]) * 0.75).sin(), b: ((-(y)) * 0.75).sin() }
        + Pair {
            a: ((f - -0.875_f64).tanh() * 0.75).sin(),
            b: ((0.375_f64 * 0.625_f64).max(f) * 0.75).sin(),
        })
    .tamed();
    p2 = p2.tamed();
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        p2.b = ((a * -0.375_f64).max(r1[3]) + 0.125).tanh();
        p2 = p2.tamed();
        r1[n8 % 5] *= ((a * (r1[(n8 * n8 + 1) % 5] * -0.875_f64).max(a)) * 0.75).sin();
        r1[n8 % 5] -= (((y * y + 0.25).sqrt() / (1.5 + x * x)) * 0.75).sin();
    }
    ((r1[0] * -0.125_f64).max(r1[2]) * 0.125_f64).cos() + a + f + y + x
}

fn program_23_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((f - f) + S::from_f64(0.125)).tanh(); 5];
    let mut p2 = Pair {
        a: ((y * x) + S::from_f64(0.125)).tanh(),
        b: ((y * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    };

    'l3: for i4 in (0..4_usize).step_by(2) {
        r1[(i4 * i4 + 1) % 5] = r1[(i4 * i4 + 1) % 5] - (y * S::from_f64(0.75)).sin();
        'l5: for i6 in (i4..3_usize).step_by(2) {
            p2.b = ((f + x) * S::from_f64(0.75)).sin();
            p2 = p2.tamed();
            r1[(i4 + 1) % 5] = (((r1[i6 % 5] * r1[i6 % 5] + S::from_f64(0.25)).sqrt()
                + (r1[(i6 * i6 + 1) % 5] - x))
                + S::from_f64(0.125))
            .tanh();
            let f = match shape(
                ((y * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
                ((r1[(i4 * i4 + 1) % 5] + S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
            ) {
                Point => {
                    ((S::from_f64(i4 as f64) * S::from_f64(0.25)) * S::from_f64(-0.875_f64)).cos()
                }
                Disc(v) => (v - S::from_f64(-0.625_f64)).tanh(),
                Shape::Box { w: v, h } => ((r1[(i6 + 1) % 5] + S::from_f64(0.625_f64)).sin()
                    - S::from_f64(0.375_f64))
                .tanh(),
            };
        }
        r1[i4 % 5] = r1[i4 % 5]
            - (((r1[(i4 * i4 + 1) % 5] + S::from_f64(-0.875_f64)).sin() + S::from_f64(-0.125_f64))
                .sin()
                + S::from_f64(0.125))
            .tanh();
    }
    let a = match roots((r1[4] * S::from_f64(0.125_f64)).max(y), x) {
        Ok(v) => (S::from_f64(-0.875_f64) * S::from_f64(0.125_f64)).cos(),
        Err(true) => r1[1],
        Err(_) => (r1[3] * r1[3]),
    };
    p2 =
        (p2 * Pair {
            a: ((f * r1[4]) * S::from_f64(0.75)).sin(),
            b: ((-(y)) * S::from_f64(0.75)).sin(),
        } + Pair {
            a: ((f - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
            b: ((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).max(f) * S::from_f64(0.75)).sin(),
        })
        .tamed();
    p2 = p2.tamed();
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        p2.b = ((a * S::from_f64(-0.375_f64)).max(r1[3]) + S::from_f64(0.125)).tanh();
        p2 = p2.tamed();
        r1[n8 % 5] = r1[n8 % 5]
            * ((a * (r1[(n8 * n8 + 1) % 5] * S::from_f64(-0.875_f64)).max(a)) * S::from_f64(0.75))
                .sin();
        r1[n8 % 5] = r1[n8 % 5]
            - (((y * y + S::from_f64(0.25)).sqrt() / (S::from_f64(1.5) + x * x))
                * S::from_f64(0.75))
            .sin();
    }
    ((r1[0] * S::from_f64(-0.125_f64)).max(r1[2]) * S::from_f64(0.125_f64)).cos() + a + f + y + x
}

#[differentiable]
fn program_24(x: f64, y: f64) -> f64 {
    let mut a = ((x - 0.375_f64).tanh() * 0.75).sin();
    let mut r1 = [((a + y) * 0.75).sin(), (a * 0.75).sin()];
    let by2 = ((y * 0.875_f64).cos() * 0.75).sin();
    let d = shifted(&mut r1[0..], by2);
    r1[0] += (x + 0.125).tanh();
    let f = program_15(((r1[0] * d) + 0.125).tanh(), ((r1[0] + a) * 0.75).sin()).tanh();
    let mut p3 = Pair { a: ((y + r1[1]) + 0.125).tanh(), b: ((0.875_f64 - r1[0]) * 0.75).sin() };
    let mut r4 = [((r1[0] * r1[0] + 0.25).sqrt() * 0.75).sin(); 2];
    a -= (((d + 0.125_f64).sin() / (1.5 + (y * -1.125_f64).cos() * (y * -1.125_f64).cos()))
        + 0.125)
        .tanh();
    let z5;
    if (-0.125_f64 * 0.125_f64).max(d) > (-0.375_f64 * 0.625_f64).abs() {
        let t = ((y * 0.875_f64).max(p3.b) * r4[0]);
        z5 = (a * (d + x));
    } else if (0.375_f64 + -0.625_f64).sin() > (x / (1.5 + x * x)) {
        z5 = bent((y * 0.875_f64).cos());
    } else {
        z5 = ((y * 0.875_f64).max(p3.b) * r4[0]);
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 2 {
        n7 += 1;
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            let b = p3
                .dot(&Pair {
                    a: ((r4[n7 % 2] - a) * 0.75).sin(),
                    b: (r1[(n9 + 0) % 2] + 0.125).tanh(),
                })
                .sin();
        }
        let mut u10: Vec<_> = r1.iter().map(|v| *v * -0.875_f64).collect();
        u10.push(((p3.a * 0.125_f64).cos() * 0.75).sin());
        u10[0] = u10[1] * u10[u10.len() - 1];
        let f = (mixed(&u10) + u10[0]).tanh();
        let mut r11 = [
            (z5 + 0.125).tanh(),
            ((r4[(n7 + 1) % 2] * 0.625_f64).cos() + 0.125).tanh(),
            ((d + f) + 0.125).tanh(),
            (z5 + 0.125).tanh(),
            ((((n7 as f64) * 0.25) / (1.5 + r1[n7 % 2] * r1[n7 % 2])) * 0.75).sin(),
        ];
    }
    let a = if (r4[1] + -0.375_f64).sin() < (z5 / (1.5 + -0.625_f64 * -0.625_f64)) {
        ((r1[0] - r4[0]) * -0.375_f64).max(y)
    } else {
        f
    };
    let mut c = (d * 0.75).sin();
    ((r1[1] - p3.b) - -0.375_f64).tanh() + c + a + z5 + f + d + y + x
}

fn program_24_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((a + y) * S::from_f64(0.75)).sin(), (a * S::from_f64(0.75)).sin()];
    let by2 = ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let d = shifted(&mut r1[0..], by2);
    r1[0] = r1[0] + (x + S::from_f64(0.125)).tanh();
    let f = program_15_of(
        ((r1[0] * d) + S::from_f64(0.125)).tanh(),
        ((r1[0] + a) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut p3 = Pair {
        a: ((y + r1[1]) + S::from_f64(0.125)).tanh(),
        b: ((S::from_f64(0.875_f64) - r1[0]) * S::from_f64(0.75)).sin(),
    };
    let mut r4 = [((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(); 2];
    a = a
        - (((d + S::from_f64(0.125_f64)).sin()
            / (S::from_f64(1.5)
                + (y * S::from_f64(-1.125_f64)).cos() * (y * S::from_f64(-1.125_f64)).cos()))
            + S::from_f64(0.125))
        .tanh();
    let z5;
    if (S::from_f64(-0.125_f64) * S::from_f64(0.125_f64))
        .max(d)
        .cmpgt((S::from_f64(-0.375_f64) * S::from_f64(0.625_f64)).abs())
    {
        let t = ((y * S::from_f64(0.875_f64)).max(p3.b) * r4[0]);
        z5 = (a * (d + x));
    } else if (S::from_f64(0.375_f64) + S::from_f64(-0.625_f64))
        .sin()
        .cmpgt((x / (S::from_f64(1.5) + x * x)))
    {
        z5 = bent((y * S::from_f64(0.875_f64)).cos());
    } else {
        z5 = ((y * S::from_f64(0.875_f64)).max(p3.b) * r4[0]);
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 2 {
        n7 += 1;
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            let b = p3
                .dot(&Pair {
                    a: ((r4[n7 % 2] - a) * S::from_f64(0.75)).sin(),
                    b: (r1[(n9 + 0) % 2] + S::from_f64(0.125)).tanh(),
                })
                .sin();
        }
        let mut u10: Vec<_> = r1.iter().map(|v| *v * S::from_f64(-0.875_f64)).collect();
        u10.push(((p3.a * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin());
        u10[0] = u10[1] * u10[u10.len() - 1];
        let f = (mixed(&u10) + u10[0]).tanh();
        let mut r11 = [
            (z5 + S::from_f64(0.125)).tanh(),
            ((r4[(n7 + 1) % 2] * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
            ((d + f) + S::from_f64(0.125)).tanh(),
            (z5 + S::from_f64(0.125)).tanh(),
            (((S::from_f64(n7 as f64) * S::from_f64(0.25))
                / (S::from_f64(1.5) + r1[n7 % 2] * r1[n7 % 2]))
                * S::from_f64(0.75))
            .sin(),
        ];
    }
    let a = if (r4[1] + S::from_f64(-0.375_f64))
        .sin()
        .cmplt((z5 / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64))))
    {
        ((r1[0] - r4[0]) * S::from_f64(-0.375_f64)).max(y)
    } else {
        f
    };
    let mut c = (d * S::from_f64(0.75)).sin();
    ((r1[1] - p3.b) - S::from_f64(-0.375_f64)).tanh() + c + a + z5 + f + d + y + x
}

#[differentiable]
fn program_25(x: f64, y: f64) -> f64 {
    let mut e = ((x * -1.125_f64) + 0.125).tanh();
    let r1 = [((y * -1.125_f64).abs() + 0.125).tanh(); 2];
    let d = root((y * y + 0.25).sqrt()).map_or((y / (1.5 + e * e)), |v| (y - (r1[0] + r1[0])));
    let b = program_10(((x * 0.375_f64).cos() * 0.75).sin(), ((e + y) * 0.75).sin()).tanh();
    let b = ((y - d) * (x * b));
    let mut p2 =
        Pair { a: ((x * x + 0.25).sqrt() + 0.125).tanh(), b: ((r1[1] * b) + 0.125).tanh() };
    'l3: for i4 in (2..2_usize).rev() {
        p2 =
            (p2 * Pair {
                a: ((r1[0] * -0.375_f64).cos() * 0.75).sin(),
                b: ((r1[(i4 + 1) % 2] + -0.875_f64) * 0.75).sin(),
            } + p2)
                .tamed();
        p2 = p2.tamed();
        p2 = (p2 + p2) * ((0.375_f64 / (1.5 + x * x)) * 0.75).sin();
        p2 = p2.tamed();
        let mut z5;
        let mut n6 = 0_usize;
        loop {
            n6 += 1;
            let t = ((r1[(i4 + 0) % 2] * r1[(i4 + 0) % 2] + 0.25).sqrt() * 0.875_f64).cos();
            if n6 > 2 || i4 % 3 == 2 {
                z5 = ((d + -0.625_f64).sin() * 0.125_f64).abs();
                break;
            }
        }
        z5 = z5 * (d * -1.125_f64).max(r1[0]);
    }
    let (a, mut b) = (((b * e) * 0.75).sin(), (-1.125_f64 * -0.125_f64).abs());
    p2 += Pair {
        a: ((p2.b + -0.875_f64).sin() * 0.75).sin(),
        b: ((a + 0.375_f64).sin() * 0.75).sin(),
    };
    p2 = p2.tamed();
    p2 = (p2 - p2 * ((e * -1.125_f64).cos() * 0.75).sin()).tamed();
    p2 = p2.tamed();
    'l7: for i8 in (1..0_usize).step_by(2) {
        e -= ((d - (r1[i8 % 2] + p2.b)) * 0.75).sin();
        b = (((r1[i8 % 2] * -0.875_f64).cos() + (p2.a * r1[i8 % 2])) * 0.75).sin();
    }
    p2.a + b + a + d + e + y + x
}

fn program_25_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(); 2];
    let d = root((y * y + S::from_f64(0.25)).sqrt())
        .map_or((y / (S::from_f64(1.5) + e * e)), |v| (y - (r1[0] + r1[0])));
    let b = program_10_of(
        ((x * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        ((e + y) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let b = ((y - d) * (x * b));
    let mut p2 = Pair {
        a: ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        b: ((r1[1] * b) + S::from_f64(0.125)).tanh(),
    };
    'l3: for i4 in (2..2_usize).rev() {
        p2 =
            (p2 * Pair {
                a: ((r1[0] * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
                b: ((r1[(i4 + 1) % 2] + S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
            } + p2)
                .tamed();
        p2 = p2.tamed();
        p2 = (p2 + p2)
            * ((S::from_f64(0.375_f64) / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin();
        p2 = p2.tamed();
        let mut z5;
        let mut n6 = 0_usize;
        loop {
            n6 += 1;
            let t = ((r1[(i4 + 0) % 2] * r1[(i4 + 0) % 2] + S::from_f64(0.25)).sqrt()
                * S::from_f64(0.875_f64))
            .cos();
            if n6 > 2 || i4 % 3 == 2 {
                z5 = ((d + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.125_f64)).abs();
                break;
            }
        }
        z5 = z5 * (d * S::from_f64(-1.125_f64)).max(r1[0]);
    }
    let (a, mut b) = (
        ((b * e) * S::from_f64(0.75)).sin(),
        (S::from_f64(-1.125_f64) * S::from_f64(-0.125_f64)).abs(),
    );
    p2 += Pair {
        a: ((p2.b + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(),
        b: ((a + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    p2 = p2.tamed();
    p2 = (p2 - p2 * ((e * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin()).tamed();
    p2 = p2.tamed();
    'l7: for i8 in (1..0_usize).step_by(2) {
        e = e - ((d - (r1[i8 % 2] + p2.b)) * S::from_f64(0.75)).sin();
        b = (((r1[i8 % 2] * S::from_f64(-0.875_f64)).cos() + (p2.a * r1[i8 % 2]))
            * S::from_f64(0.75))
        .sin();
    }
    p2.a + b + a + d + e + y + x
}

#[differentiable]
fn program_26(x: f64, y: f64) -> f64 {
    let mut a = ((-0.125_f64 * -0.125_f64 + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [((a * -1.125_f64).cos() * 0.75).sin(); 5];
    if (r1[4] * -0.375_f64).abs() <= y {
        'l2: for i3 in 2..=2_usize {
            'l4: for i5 in 0..0_usize {
                let mut u6: Vec<_> = r1.iter().map(|v| *v * y).collect();
                u6.push(((y + -0.375_f64).sin() * 0.75).sin());
                u6[0] = u6[1] * u6[u6.len() - 1];
                let d = (mixed(&u6) + u6[0]).tanh();
                let b = match roots((r1[4] * 0.375_f64).max(d), (r1[i5 % 5] * -0.375_f64).abs()) {
                    Ok(v) => ((r1[(i3 + 0) % 5] * x) * 0.375_f64).cos(),
                    Err(true) => x,
                    Err(_) => (r1[1] * r1[i5 % 5]),
                };
                let f = match roots((d - -0.625_f64).tanh(), (-0.625_f64 - b)) {
                    Ok(v) => (-((x * 0.125_f64).max(-0.125_f64))),
                    Err(true) => r1[4],
                    Err(_) => (-0.875_f64 - y),
                };
            }
            let a = if (-(x)) >= (-(y)) {
                ((y * 0.375_f64).abs() * 0.625_f64).cos()
            } else {
                ((y + x) * a)
            };
            let e = if let Some(v) = root((r1[3] * r1[i3 % 5])) {
                ((r1[i3 % 5] - y) + (v * 0.125_f64).abs())
            } else {
                (((i3 as f64) * 0.25) * 0.125_f64).max(y)
            };
        }
    }
    r1[0] += (((a - y) + (r1[0] - y)) + 0.125).tanh();
    r1[3] = (y * 0.75).sin();
    let mut p7 = Pair { a: ((r1[4] + r1[4]) + 0.125).tanh(), b: ((-(r1[2])) + 0.125).tanh() };
    p7.b = ((r1[4] * -0.625_f64).cos() * 0.75).sin();
    p7 = p7.tamed();
    let mut u8 = r1.to_vec();
    u8.push(((-(-0.125_f64)) * 0.75).sin());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let e = (mixed(&u8) + u8[0]).tanh();
    let d = mixed(&r1[2..]).sin();
    ((a - x) - (d * r1[2])) + d + e + a + y + x
}

fn program_26_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.125))
    .tanh();
    let mut r1 = [((a * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(); 5];
    if (r1[4] * S::from_f64(-0.375_f64)).abs().cmple(y) {
        'l2: for i3 in 2..=2_usize {
            'l4: for i5 in 0..0_usize {
                let mut u6: Vec<_> = r1.iter().map(|v| *v * y).collect();
                u6.push(((y + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin());
                u6[0] = u6[1] * u6[u6.len() - 1];
                let d = (mixed(&u6) + u6[0]).tanh();
                let b = match roots(
                    (r1[4] * S::from_f64(0.375_f64)).max(d),
                    (r1[i5 % 5] * S::from_f64(-0.375_f64)).abs(),
                ) {
                    Ok(v) => ((r1[(i3 + 0) % 5] * x) * S::from_f64(0.375_f64)).cos(),
                    Err(true) => x,
                    Err(_) => (r1[1] * r1[i5 % 5]),
                };
                let f = match roots(
                    (d - S::from_f64(-0.625_f64)).tanh(),
                    (S::from_f64(-0.625_f64) - b),
                ) {
                    Ok(v) => (-((x * S::from_f64(0.125_f64)).max(S::from_f64(-0.125_f64)))),
                    Err(true) => r1[4],
                    Err(_) => (S::from_f64(-0.875_f64) - y),
                };
            }
            let a = if (-(x)).cmpge((-(y))) {
                ((y * S::from_f64(0.375_f64)).abs() * S::from_f64(0.625_f64)).cos()
            } else {
                ((y + x) * a)
            };
            let e = if let Some(v) = root((r1[3] * r1[i3 % 5])) {
                ((r1[i3 % 5] - y) + (v * S::from_f64(0.125_f64)).abs())
            } else {
                ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64)).max(y)
            };
        }
    }
    r1[0] = r1[0] + (((a - y) + (r1[0] - y)) + S::from_f64(0.125)).tanh();
    r1[3] = (y * S::from_f64(0.75)).sin();
    let mut p7 = Pair {
        a: ((r1[4] + r1[4]) + S::from_f64(0.125)).tanh(),
        b: ((-(r1[2])) + S::from_f64(0.125)).tanh(),
    };
    p7.b = ((r1[4] * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin();
    p7 = p7.tamed();
    let mut u8 = r1.to_vec();
    u8.push(((-(S::from_f64(-0.125_f64))) * S::from_f64(0.75)).sin());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let e = (mixed(&u8) + u8[0]).tanh();
    let d = mixed(&r1[2..]).sin();
    ((a - x) - (d * r1[2])) + d + e + a + y + x
}

#[differentiable]
fn program_27(x: f64, y: f64) -> f64 {
    let mut e = (y + 0.125).tanh();
    let r1 = [((e * e) * 0.75).sin(); 3];
    let a = root((x + r1[0])).map_or(e, |v| -0.625_f64);
    e += (((y * y) * (y * y) + 0.25).sqrt() * 0.75).sin();
    e -= (((-(e)) - -1.125_f64).tanh() * 0.75).sin();
    let r2 = [
        (r1[2] * 0.75).sin(),
        ((a - y) + 0.125).tanh(),
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
        ((e + a) + 0.125).tanh(),
    ];
    let f = match roots((-(y)), (r1[0] - r1[2])) {
        Ok(v) => e,
        Err(true) => y,
        Err(_) => (y * e),
    };
    let e = match roots((e + -0.875_f64).sin(), (0.625_f64 / (1.5 + r2[3] * r2[3]))) {
        Ok(v) => ((-0.125_f64 - -0.875_f64).tanh() * (r2[2] * r2[1])),
        Err(true) => y,
        Err(_) => (x + r2[2]),
    };
    if (e + x) < (a * 0.125_f64).abs() {
        let z3;
        let mut n4 = 0_usize;
        loop {
            n4 += 1;
            let t = r2[0];
            if n4 > 2 || y < (a / (1.5 + r1[1] * r1[1])) {
                z3 = ((t * 0.625_f64).abs() + 0.125_f64).sin();
                break;
            }
        }
        if (a * 0.375_f64).abs() <= (x * x + 0.25).sqrt() {
            let mut r5 = [(f * 0.75).sin(); 2];
            'l6: for i7 in 0..3_usize {
                r5[0] = (((y + -1.125_f64) * 0.875_f64).max(a) * 0.75).sin();
                let mut p8 = Pair {
                    a: ((a * z3) + 0.125).tanh(),
                    b: ((e - -0.875_f64).tanh() * 0.75).sin(),
                };
                let by9 = ((p8.b * 0.125_f64) * 0.75).sin();
                for v in r5.iter_mut() {
                    *v = (*v * by9).sin();
                }
            }
        } else {
            let (a, mut b) = (((y + 0.375_f64).sin() + 0.125).tanh(), (a * a + 0.25).sqrt());
        }
    }
    ((-(y)) - (-1.125_f64 - -0.875_f64).tanh()) + e + f + a + y + x
}

fn program_27_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (y + S::from_f64(0.125)).tanh();
    let r1 = [((e * e) * S::from_f64(0.75)).sin(); 3];
    let a = root((x + r1[0])).map_or(e, |v| S::from_f64(-0.625_f64));
    e = e + (((y * y) * (y * y) + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    e = e - (((-(e)) - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin();
    let r2 = [
        (r1[2] * S::from_f64(0.75)).sin(),
        ((a - y) + S::from_f64(0.125)).tanh(),
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((e + a) + S::from_f64(0.125)).tanh(),
    ];
    let f = match roots((-(y)), (r1[0] - r1[2])) {
        Ok(v) => e,
        Err(true) => y,
        Err(_) => (y * e),
    };
    let e = match roots(
        (e + S::from_f64(-0.875_f64)).sin(),
        (S::from_f64(0.625_f64) / (S::from_f64(1.5) + r2[3] * r2[3])),
    ) {
        Ok(v) => ((S::from_f64(-0.125_f64) - S::from_f64(-0.875_f64)).tanh() * (r2[2] * r2[1])),
        Err(true) => y,
        Err(_) => (x + r2[2]),
    };
    if (e + x).cmplt((a * S::from_f64(0.125_f64)).abs()) {
        let z3;
        let mut n4 = 0_usize;
        loop {
            n4 += 1;
            let t = r2[0];
            if n4 > 2 || y.cmplt((a / (S::from_f64(1.5) + r1[1] * r1[1]))) {
                z3 = ((t * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125_f64)).sin();
                break;
            }
        }
        if (a * S::from_f64(0.375_f64)).abs().cmple((x * x + S::from_f64(0.25)).sqrt()) {
            let mut r5 = [(f * S::from_f64(0.75)).sin(); 2];
            'l6: for i7 in 0..3_usize {
                r5[0] = (((y + S::from_f64(-1.125_f64)) * S::from_f64(0.875_f64)).max(a)
                    * S::from_f64(0.75))
                .sin();
                let mut p8 = Pair {
                    a: ((a * z3) + S::from_f64(0.125)).tanh(),
                    b: ((e - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
                };
                let by9 = ((p8.b * S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin();
                for v in r5.iter_mut() {
                    *v = (*v * by9).sin();
                }
            }
        } else {
            let (a, mut b) = (
                ((y + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
                (a * a + S::from_f64(0.25)).sqrt(),
            );
        }
    }
    ((-(y)) - (S::from_f64(-1.125_f64) - S::from_f64(-0.875_f64)).tanh()) + e + f + a + y + x
}

#[differentiable]
fn program_28(x: f64, y: f64) -> f64 {
    let mut f = (y + 0.125).tanh();
    let mut r1 = [((x * -0.625_f64).max(x) + 0.125).tanh(); 2];
    let r2 = [(r1[0] * 0.75).sin(); 2];
    let mut p3 = Pair { a: ((y + y) + 0.125).tanh(), b: (r2[0] + 0.125).tanh() };
    r1[0] += (((f * -0.375_f64).cos() + -0.375_f64).sin() * 0.75).sin();
    let mut r4 = [((-(-0.375_f64)) + 0.125).tanh(); 3];
    'l5: for i6 in 1..=3_usize {
        for v in r2.iter() {
            f = f * ((x - -0.625_f64).tanh() * 0.75).sin()
                + *v * ((x - -0.625_f64).tanh() * 0.75).sin();
        }
        let mut c = ((((i6 as f64) * 0.25) + r4[(i6 + 1) % 3]) * 0.75).sin();
    }
    r4[0] = (((r2[0] / (1.5 + x * x)) + (p3.b * r2[1])) + 0.125).tanh();
    'l7: for i8 in (1..5_usize).rev() {
        let g9 = |t: f64| t * t;
        let d = (g9((r1[0] - 0.875_f64).tanh()) + g9((-0.125_f64 - f))).sin();
        f *= (((d - -0.625_f64).tanh() * 0.875_f64).max(x) + 0.125).tanh();
    }
    let mut u10: Vec<_> = r2.iter().map(|v| *v * r2[0]).collect();
    u10.push(((r1[1] * 0.625_f64).max(f) * 0.75).sin());
    u10[0] = u10[1] * u10[u10.len() - 1];
    let f = (mixed(&u10) + u10[0]).tanh();
    p3 += p3;
    p3 = p3.tamed();
    let a = ((-0.875_f64 + f) - -0.375_f64).tanh();
    ((-(r1[1])) * 0.625_f64).max(r2[0]) + a + f + y + x
}

fn program_28_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (y + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * S::from_f64(-0.625_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    let r2 = [(r1[0] * S::from_f64(0.75)).sin(); 2];
    let mut p3 =
        Pair { a: ((y + y) + S::from_f64(0.125)).tanh(), b: (r2[0] + S::from_f64(0.125)).tanh() };
    r1[0] = r1[0]
        + (((f * S::from_f64(-0.375_f64)).cos() + S::from_f64(-0.375_f64)).sin()
            * S::from_f64(0.75))
        .sin();
    let mut r4 = [((-(S::from_f64(-0.375_f64))) + S::from_f64(0.125)).tanh(); 3];
    'l5: for i6 in 1..=3_usize {
        for v in r2.iter() {
            f = f * ((x - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin()
                + *v * ((x - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        }
        let mut c = (((S::from_f64(i6 as f64) * S::from_f64(0.25)) + r4[(i6 + 1) % 3])
            * S::from_f64(0.75))
        .sin();
    }
    r4[0] = (((r2[0] / (S::from_f64(1.5) + x * x)) + (p3.b * r2[1])) + S::from_f64(0.125)).tanh();
    'l7: for i8 in (1..5_usize).rev() {
        let g9 = |t: S| t * t;
        let d =
            (g9((r1[0] - S::from_f64(0.875_f64)).tanh()) + g9((S::from_f64(-0.125_f64) - f))).sin();
        f = f
            * (((d - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.875_f64)).max(x)
                + S::from_f64(0.125))
            .tanh();
    }
    let mut u10: Vec<_> = r2.iter().map(|v| *v * r2[0]).collect();
    u10.push(((r1[1] * S::from_f64(0.625_f64)).max(f) * S::from_f64(0.75)).sin());
    u10[0] = u10[1] * u10[u10.len() - 1];
    let f = (mixed(&u10) + u10[0]).tanh();
    p3 += p3;
    p3 = p3.tamed();
    let a = ((S::from_f64(-0.875_f64) + f) - S::from_f64(-0.375_f64)).tanh();
    ((-(r1[1])) * S::from_f64(0.625_f64)).max(r2[0]) + a + f + y + x
}

#[differentiable]
fn program_29(x: f64, y: f64) -> f64 {
    let mut d = ((x * x) * 0.75).sin();
    let r1 = [
        ((d + -1.125_f64).sin() * 0.75).sin(),
        ((x * 0.625_f64).max(d) * 0.75).sin(),
        ((y + 0.125_f64).sin() * 0.75).sin(),
    ];
    d *= ((-0.875_f64 / (1.5 + (d - 0.625_f64).tanh() * (d - 0.625_f64).tanh())) + 0.125).tanh();
    let f = mixed(&r1[1..]).sin();
    d -= (((x * x) + -1.125_f64).sin() + 0.125).tanh();
    let mut p2 = Pair {
        a: ((y - -0.125_f64).tanh() + 0.125).tanh(),
        b: ((d * -1.125_f64).abs() + 0.125).tanh(),
    };
    let d = ((r1[2] * 0.625_f64).abs() + (y * y + 0.25).sqrt());
    let (a, mut b) = (((r1[0] * r1[0]) * 0.75).sin(), (f * -0.875_f64));
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        p2 =
            (p2 * Pair {
                a: ((r1[(n4 * n4 + 1) % 3] - 0.875_f64).tanh() + 0.125).tanh(),
                b: ((p2.b + r1[(n4 * n4 + 1) % 3]) * 0.75).sin(),
            } + p2)
                .tamed();
        p2 = p2.tamed();
        p2.turn(((p2.a / (1.5 + x * x)) + 0.125).tanh());
        p2 = p2.tamed();
    }
    let z5;
    if (b - a) > (r1[0] + -0.875_f64).sin() {
        z5 = ((x * p2.b) - (-(f)));
    } else {
        z5 = (y * 0.875_f64);
    }
    b *= (r1[1] * 0.75).sin();
    'l6: for i7 in (0..4_usize).step_by(2) {
        b -= ((r1[(i7 + 2) % 3] - 0.625_f64).tanh() * 0.75).sin();
        b *= (((a * -0.625_f64) + 0.625_f64).sin() + 0.125).tanh();
        if (p2.a * -0.375_f64).max(d) < (((i7 as f64) * 0.25) * ((i7 as f64) * 0.25)) {
            if (p2.b - -0.375_f64).tanh() >= (f * r1[(i7 + 2) % 3]) {
                b -= (((i7 as f64) * 0.25) + 0.125).tanh();
                let mut u8: Vec<_> = r1.iter().map(|v| *v * p2.a).collect();
                u8.push(((r1[(i7 * i7 + 1) % 3] + 0.875_f64).sin() * 0.75).sin());
                u8[0] = u8[1] * u8[u8.len() - 1];
                let b = (mixed(&u8) + u8[0]).tanh();
            } else {
                b -= (((z5 + -0.875_f64).sin() * -0.625_f64).cos() + 0.125).tanh();
            }
            b *= (((((i7 as f64) * 0.25) * -0.125_f64).max(y) * (r1[0] * a)) * 0.75).sin();
        } else {
            let c = match shape(
                (r1[(i7 + 1) % 3] * 0.75).sin(),
                ((-0.375_f64 + 0.375_f64).sin() * 0.75).sin(),
            ) {
                Shape::Point => (r1[i7 % 3] * r1[(i7 + 2) % 3]),
                Shape::Disc(v) => {
                    ((r1[0] * r1[0]) / (1.5 + r1[(i7 * i7 + 1) % 3] * r1[(i7 * i7 + 1) % 3]))
                }
                Shape::Box { w: v, h } => ((z5 * z5 + 0.25).sqrt() + (b - r1[(i7 * i7 + 1) % 3])),
            };
        }
    }
    ((r1[0] * r1[0] + 0.25).sqrt() * 0.375_f64).abs() + z5 + b + a + d + f + y + x
}

fn program_29_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * x) * S::from_f64(0.75)).sin();
    let r1 = [
        ((d + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(0.625_f64)).max(d) * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    d = d
        * ((S::from_f64(-0.875_f64)
            / (S::from_f64(1.5)
                + (d - S::from_f64(0.625_f64)).tanh() * (d - S::from_f64(0.625_f64)).tanh()))
            + S::from_f64(0.125))
        .tanh();
    let f = mixed(&r1[1..]).sin();
    d = d - (((x * x) + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut p2 = Pair {
        a: ((y - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: ((d * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    let d = ((r1[2] * S::from_f64(0.625_f64)).abs() + (y * y + S::from_f64(0.25)).sqrt());
    let (a, mut b) = (((r1[0] * r1[0]) * S::from_f64(0.75)).sin(), (f * S::from_f64(-0.875_f64)));
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        p2 =
            (p2 * Pair {
                a: ((r1[(n4 * n4 + 1) % 3] - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125))
                    .tanh(),
                b: ((p2.b + r1[(n4 * n4 + 1) % 3]) * S::from_f64(0.75)).sin(),
            } + p2)
                .tamed();
        p2 = p2.tamed();
        p2.turn(((p2.a / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh());
        p2 = p2.tamed();
    }
    let z5;
    if (b - a).cmpgt((r1[0] + S::from_f64(-0.875_f64)).sin()) {
        z5 = ((x * p2.b) - (-(f)));
    } else {
        z5 = (y * S::from_f64(0.875_f64));
    }
    b = b * (r1[1] * S::from_f64(0.75)).sin();
    'l6: for i7 in (0..4_usize).step_by(2) {
        b = b - ((r1[(i7 + 2) % 3] - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        b = b
            * (((a * S::from_f64(-0.625_f64)) + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125))
                .tanh();
        if (p2.a * S::from_f64(-0.375_f64)).max(d).cmplt(
            ((S::from_f64(i7 as f64) * S::from_f64(0.25))
                * (S::from_f64(i7 as f64) * S::from_f64(0.25))),
        ) {
            if (p2.b - S::from_f64(-0.375_f64)).tanh().cmpge((f * r1[(i7 + 2) % 3])) {
                b = b - ((S::from_f64(i7 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
                let mut u8: Vec<_> = r1.iter().map(|v| *v * p2.a).collect();
                u8.push(
                    ((r1[(i7 * i7 + 1) % 3] + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75))
                        .sin(),
                );
                u8[0] = u8[1] * u8[u8.len() - 1];
                let b = (mixed(&u8) + u8[0]).tanh();
            } else {
                b = b
                    - (((z5 + S::from_f64(-0.875_f64)).sin() * S::from_f64(-0.625_f64)).cos()
                        + S::from_f64(0.125))
                    .tanh();
            }
            b = b
                * ((((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                    .max(y)
                    * (r1[0] * a))
                    * S::from_f64(0.75))
                .sin();
        } else {
            let c = match shape(
                (r1[(i7 + 1) % 3] * S::from_f64(0.75)).sin(),
                ((S::from_f64(-0.375_f64) + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75))
                    .sin(),
            ) {
                Shape::Point => (r1[i7 % 3] * r1[(i7 + 2) % 3]),
                Shape::Disc(v) => {
                    ((r1[0] * r1[0])
                        / (S::from_f64(1.5) + r1[(i7 * i7 + 1) % 3] * r1[(i7 * i7 + 1) % 3]))
                }
                Shape::Box { w: v, h } => {
                    ((z5 * z5 + S::from_f64(0.25)).sqrt() + (b - r1[(i7 * i7 + 1) % 3]))
                }
            };
        }
    }
    ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.375_f64)).abs()
        + z5
        + b
        + a
        + d
        + f
        + y
        + x
}

#[differentiable]
fn program_30(x: f64, y: f64) -> f64 {
    let mut f = ((-0.625_f64 - 0.875_f64).tanh() * 0.75).sin();
    let mut r1 = [((-0.125_f64 - -0.625_f64).tanh() + 0.125).tanh(); 5];
    let c = if (r1[4] - -1.125_f64).tanh() > -1.125_f64 {
        ((r1[3] * r1[3] + 0.25).sqrt() + (y * x))
    } else {
        ((f * -0.125_f64).abs() * 0.875_f64).cos()
    };
    let g2 = |t: f64| ((c + x) * (t * t + 0.25).sqrt()) * t;
    let f = (g2((r1[3] + 0.875_f64).sin()) + g2((x / (1.5 + r1[2] * r1[2])))).sin();
    'l3: for i4 in (1..5_usize).step_by(2) {
        'l5: for i6 in 1..0_usize {
            if (x * r1[0]) >= (r1[i6 % 5] + r1[0]) {
                let mut r7 = [
                    ((x * c) + 0.125).tanh(),
                    ((-(r1[4])) * 0.75).sin(),
                    ((-(r1[(i4 * i4 + 1) % 5])) + 0.125).tanh(),
                ];
            } else {
                let mut d = ((0.625_f64 / (1.5 + r1[4] * r1[4])) + 0.125).tanh();
            }
            let a = ((-(f)) + -0.875_f64).sin();
        }
        r1[(i4 + 1) % 5] = ((-(y * y)) + 0.125).tanh();
    }
    let d = mixed(&r1[..3]).sin();
    let c = match shape(((-0.375_f64 + f) * 0.75).sin(), ((-0.125_f64 * r1[3]) + 0.125).tanh()) {
        Shape::Point => (r1[3] / (1.5 + r1[4] * r1[4])),
        Shape::Disc(v) => ((c * -0.375_f64).abs() * (-1.125_f64 * -1.125_f64 + 0.25).sqrt()),
        Shape::Box { w: v, h } => ((-(v)) * (-0.625_f64 + y)),
    };
    let c = if 0.375_f64 >= (y - -0.375_f64).tanh() {
        ((r1[2] * 0.125_f64).max(f) * (r1[0] + r1[1]))
    } else {
        r1[2]
    };
    if f <= (-(r1[4])) {
        let mut c = (r1[0] * 0.75).sin();
        'l8: for i9 in 2..=4_usize {
            'l10: for i11 in i9..=4_usize {
                let e = match roots(y, (r1[3] * 0.625_f64).max(-0.875_f64)) {
                    Ok(v) => ((d * -1.125_f64).cos() - (y * c)),
                    Err(true) => c,
                    Err(_) => (r1[(i11 + 0) % 5] * 0.375_f64).max(d),
                };
                let d = program_23(((r1[1] * -0.125_f64).cos() + 0.125).tanh(), (x + 0.125).tanh())
                    .tanh();
                let mut u12 = r1.to_vec();
                u12.push(((d * x) * 0.75).sin());
                u12[0] = u12[1] * u12[u12.len() - 1];
                let f = (mixed(&u12) + u12[0]).tanh();
            }
        }
    } else {
        let c = program_26(((d * y) + 0.125).tanh(), ((-0.375_f64 * y) + 0.125).tanh()).tanh();
        let mut u13 = r1.to_vec();
        u13.push(((x * 0.375_f64).abs() * 0.75).sin());
        u13[0] = u13[1] * u13[u13.len() - 1];
        let f = (mixed(&u13) + u13[0]).tanh();
    }
    d + c + d + f + y + x
}

fn program_30_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f =
        ((S::from_f64(-0.625_f64) - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((S::from_f64(-0.125_f64) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125))
        .tanh(); 5];
    let c = if (r1[4] - S::from_f64(-1.125_f64)).tanh().cmpgt(S::from_f64(-1.125_f64)) {
        ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + (y * x))
    } else {
        ((f * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.875_f64)).cos()
    };
    let g2 = |t: S| ((c + x) * (t * t + S::from_f64(0.25)).sqrt()) * t;
    let f = (g2((r1[3] + S::from_f64(0.875_f64)).sin())
        + g2((x / (S::from_f64(1.5) + r1[2] * r1[2]))))
    .sin();
    'l3: for i4 in (1..5_usize).step_by(2) {
        'l5: for i6 in 1..0_usize {
            if (x * r1[0]).cmpge((r1[i6 % 5] + r1[0])) {
                let mut r7 = [
                    ((x * c) + S::from_f64(0.125)).tanh(),
                    ((-(r1[4])) * S::from_f64(0.75)).sin(),
                    ((-(r1[(i4 * i4 + 1) % 5])) + S::from_f64(0.125)).tanh(),
                ];
            } else {
                let mut d = ((S::from_f64(0.625_f64) / (S::from_f64(1.5) + r1[4] * r1[4]))
                    + S::from_f64(0.125))
                .tanh();
            }
            let a = ((-(f)) + S::from_f64(-0.875_f64)).sin();
        }
        r1[(i4 + 1) % 5] = ((-(y * y)) + S::from_f64(0.125)).tanh();
    }
    let d = mixed(&r1[..3]).sin();
    let c = match shape(
        ((S::from_f64(-0.375_f64) + f) * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.125_f64) * r1[3]) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r1[3] / (S::from_f64(1.5) + r1[4] * r1[4])),
        Shape::Disc(v) => {
            ((c * S::from_f64(-0.375_f64)).abs()
                * (S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt())
        }
        Shape::Box { w: v, h } => ((-(v)) * (S::from_f64(-0.625_f64) + y)),
    };
    let c = if S::from_f64(0.375_f64).cmpge((y - S::from_f64(-0.375_f64)).tanh()) {
        ((r1[2] * S::from_f64(0.125_f64)).max(f) * (r1[0] + r1[1]))
    } else {
        r1[2]
    };
    if f.cmple((-(r1[4]))) {
        let mut c = (r1[0] * S::from_f64(0.75)).sin();
        'l8: for i9 in 2..=4_usize {
            'l10: for i11 in i9..=4_usize {
                let e =
                    match roots(y, (r1[3] * S::from_f64(0.625_f64)).max(S::from_f64(-0.875_f64))) {
                        Ok(v) => ((d * S::from_f64(-1.125_f64)).cos() - (y * c)),
                        Err(true) => c,
                        Err(_) => (r1[(i11 + 0) % 5] * S::from_f64(0.375_f64)).max(d),
                    };
                let d = program_23_of(
                    ((r1[1] * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                    (x + S::from_f64(0.125)).tanh(),
                )
                .tanh();
                let mut u12 = r1.to_vec();
                u12.push(((d * x) * S::from_f64(0.75)).sin());
                u12[0] = u12[1] * u12[u12.len() - 1];
                let f = (mixed(&u12) + u12[0]).tanh();
            }
        }
    } else {
        let c = program_26_of(
            ((d * y) + S::from_f64(0.125)).tanh(),
            ((S::from_f64(-0.375_f64) * y) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let mut u13 = r1.to_vec();
        u13.push(((x * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin());
        u13[0] = u13[1] * u13[u13.len() - 1];
        let f = (mixed(&u13) + u13[0]).tanh();
    }
    d + c + d + f + y + x
}

#[differentiable]
fn program_31(x: f64, y: f64) -> f64 {
    let mut d = ((y - -0.875_f64) + 0.125).tanh();
    let mut r1 = [((x * x) * 0.75).sin(); 4];
    d += (((r1[3] * 0.375_f64).cos() + -0.375_f64).sin() * 0.75).sin();
    let f = (-(-(r1[0])));
    r1[1] = (((0.125_f64 * 0.125_f64 + 0.25).sqrt() + 0.375_f64).sin() + 0.125).tanh();
    let mut d = ((-(f)) + 0.125).tanh();
    let e = program_12(((0.875_f64 * 0.125_f64).max(d) * 0.75).sin(), ((-(d)) * 0.75).sin()).tanh();
    let c = mixed(&r1).sin();
    d *= ((r1[2] * -0.125_f64).cos() * 0.75).sin();
    r1[1] += (((0.625_f64 * f) - c) * 0.75).sin();
    let mut r2 = [((f * d) * 0.75).sin(); 2];
    #[differentiable(checkpoint)]
    'l3: for i4 in 1..5_usize {
        let mut b = ((0.625_f64 * 0.625_f64 + 0.25).sqrt() * 0.75).sin();
        let c = if (r1[(i4 * i4 + 1) % 4] * 0.375_f64).cos() <= 0.875_f64 {
            ((((i4 as f64) * 0.25) + -0.375_f64).sin() * -0.625_f64).abs()
        } else {
            c
        };
        let r5 = [((y + r2[i4 % 2]) * 0.75).sin(), (y * 0.75).sin()];
    }
    if (c - -0.125_f64).tanh() <= (c - r2[0]) {
        return (r2[0] * (f - -0.625_f64));
    }
    ((d * d + 0.25).sqrt() + (x * -0.125_f64).abs()) + c + e + d + f + y + x
}

fn program_31_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y - S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * x) * S::from_f64(0.75)).sin(); 4];
    d = d
        + (((r1[3] * S::from_f64(0.375_f64)).cos() + S::from_f64(-0.375_f64)).sin()
            * S::from_f64(0.75))
        .sin();
    let f = (-(-(r1[0])));
    r1[1] = (((S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.375_f64))
    .sin()
        + S::from_f64(0.125))
    .tanh();
    let mut d = ((-(f)) + S::from_f64(0.125)).tanh();
    let e = program_12_of(
        ((S::from_f64(0.875_f64) * S::from_f64(0.125_f64)).max(d) * S::from_f64(0.75)).sin(),
        ((-(d)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let c = mixed(&r1).sin();
    d = d * ((r1[2] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin();
    r1[1] = r1[1] + (((S::from_f64(0.625_f64) * f) - c) * S::from_f64(0.75)).sin();
    let mut r2 = [((f * d) * S::from_f64(0.75)).sin(); 2];

    'l3: for i4 in 1..5_usize {
        let mut b = ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin();
        let c =
            if (r1[(i4 * i4 + 1) % 4] * S::from_f64(0.375_f64)).cos().cmple(S::from_f64(0.875_f64))
            {
                (((S::from_f64(i4 as f64) * S::from_f64(0.25)) + S::from_f64(-0.375_f64)).sin()
                    * S::from_f64(-0.625_f64))
                .abs()
            } else {
                c
            };
        let r5 = [((y + r2[i4 % 2]) * S::from_f64(0.75)).sin(), (y * S::from_f64(0.75)).sin()];
    }
    if (c - S::from_f64(-0.125_f64)).tanh().cmple((c - r2[0])) {
        return (r2[0] * (f - S::from_f64(-0.625_f64)));
    }
    ((d * d + S::from_f64(0.25)).sqrt() + (x * S::from_f64(-0.125_f64)).abs())
        + c
        + e
        + d
        + f
        + y
        + x
}

#[differentiable]
fn program_32(x: f64, y: f64) -> f64 {
    let mut f = ((y - 0.625_f64).tanh() * 0.75).sin();
    let mut r1 = [
        ((y * y) * 0.75).sin(),
        ((y - -0.125_f64).tanh() * 0.75).sin(),
        ((y * -0.125_f64).abs() + 0.125).tanh(),
        ((-(x)) * 0.75).sin(),
    ];
    f *= (((0.375_f64 / (1.5 + -1.125_f64 * -1.125_f64)) + (y + -0.125_f64)) * 0.75).sin();
    if (-0.875_f64 * y) >= (x - r1[3]) {
        r1[3] -= ((y * 0.375_f64).max(r1[1]) * 0.75).sin();
        let d = summed(
            |t: f64| (((x * 0.625_f64).max(y) * (r1[1] * 0.125_f64).abs()) * t).sin(),
            ((y + x) * 0.75).sin(),
            3,
        )
        .tanh();
        'l2: for i3 in 0..=0_usize {
            let d = match roots((-(r1[1])), (r1[(i3 * i3 + 1) % 4] - x)) {
                Ok(v) => ((x + v) * (r1[i3 % 4] / (1.5 + v * v))),
                Err(true) => d,
                Err(_) => (((i3 as f64) * 0.25) * ((i3 as f64) * 0.25) + 0.25).sqrt(),
            };
            r1[(i3 * i3 + 1) % 4] =
                (((((i3 as f64) * 0.25) / (1.5 + r1[i3 % 4] * r1[i3 % 4])) * -0.625_f64).max(f)
                    + 0.125)
                    .tanh();
            f += (((r1[(i3 + 1) % 4] * 0.625_f64).cos() * 0.375_f64).abs() * 0.75).sin();
        }
    }
    if (r1[2] * -0.875_f64).cos() < (-0.875_f64 + -1.125_f64) {
        return ((y * r1[1]) * -0.625_f64).max(y);
    }
    r1[0] += (((x * 0.375_f64).max(r1[1]) + 0.875_f64).sin() + 0.125).tanh();
    let b = summed(|t: f64| ((-(y + f)) * t).sin(), ((r1[0] - -0.125_f64).tanh() * 0.75).sin(), 0)
        .tanh();
    r1[0] -= (((r1[3] * y) - -0.625_f64).tanh() + 0.125).tanh();
    if (y / (1.5 + f * f)) >= (r1[3] * r1[3] + 0.25).sqrt() {
        r1[0] *= (((r1[1] * 0.625_f64).cos() * -0.625_f64).max(x) + 0.125).tanh();
    } else {
        let a = match shape(((-(r1[3])) + 0.125).tanh(), ((-(f)) + 0.125).tanh()) {
            Point => (f * f),
            Disc(v) => ((y * b) * (-(f))),
            Shape::Box { w: v, h } => (h / (1.5 + (b / (1.5 + v * v)) * (b / (1.5 + v * v)))),
        };
    }
    ((r1[3] / (1.5 + x * x)) * (f * b)) + b + f + y + x
}

fn program_32_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * y) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((-(x)) * S::from_f64(0.75)).sin(),
    ];
    f = f
        * (((S::from_f64(0.375_f64)
            / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
            + (y + S::from_f64(-0.125_f64)))
            * S::from_f64(0.75))
        .sin();
    if (S::from_f64(-0.875_f64) * y).cmpge((x - r1[3])) {
        r1[3] = r1[3] - ((y * S::from_f64(0.375_f64)).max(r1[1]) * S::from_f64(0.75)).sin();
        let d = summed(
            |t: S| {
                (((x * S::from_f64(0.625_f64)).max(y) * (r1[1] * S::from_f64(0.125_f64)).abs()) * t)
                    .sin()
            },
            ((y + x) * S::from_f64(0.75)).sin(),
            3,
        )
        .tanh();
        'l2: for i3 in 0..=0_usize {
            let d = match roots((-(r1[1])), (r1[(i3 * i3 + 1) % 4] - x)) {
                Ok(v) => ((x + v) * (r1[i3 % 4] / (S::from_f64(1.5) + v * v))),
                Err(true) => d,
                Err(_) => ((S::from_f64(i3 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i3 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt(),
            };
            r1[(i3 * i3 + 1) % 4] = ((((S::from_f64(i3 as f64) * S::from_f64(0.25))
                / (S::from_f64(1.5) + r1[i3 % 4] * r1[i3 % 4]))
                * S::from_f64(-0.625_f64))
            .max(f)
                + S::from_f64(0.125))
            .tanh();
            f = f
                + (((r1[(i3 + 1) % 4] * S::from_f64(0.625_f64)).cos() * S::from_f64(0.375_f64))
                    .abs()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    if (r1[2] * S::from_f64(-0.875_f64))
        .cos()
        .cmplt((S::from_f64(-0.875_f64) + S::from_f64(-1.125_f64)))
    {
        return ((y * r1[1]) * S::from_f64(-0.625_f64)).max(y);
    }
    r1[0] = r1[0]
        + (((x * S::from_f64(0.375_f64)).max(r1[1]) + S::from_f64(0.875_f64)).sin()
            + S::from_f64(0.125))
        .tanh();
    let b = summed(
        |t: S| ((-(y + f)) * t).sin(),
        ((r1[0] - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        0,
    )
    .tanh();
    r1[0] = r1[0] - (((r1[3] * y) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    if (y / (S::from_f64(1.5) + f * f)).cmpge((r1[3] * r1[3] + S::from_f64(0.25)).sqrt()) {
        r1[0] = r1[0]
            * (((r1[1] * S::from_f64(0.625_f64)).cos() * S::from_f64(-0.625_f64)).max(x)
                + S::from_f64(0.125))
            .tanh();
    } else {
        let a = match shape(
            ((-(r1[3])) + S::from_f64(0.125)).tanh(),
            ((-(f)) + S::from_f64(0.125)).tanh(),
        ) {
            Point => (f * f),
            Disc(v) => ((y * b) * (-(f))),
            Shape::Box { w: v, h } => {
                (h / (S::from_f64(1.5)
                    + (b / (S::from_f64(1.5) + v * v)) * (b / (S::from_f64(1.5) + v * v))))
            }
        };
    }
    ((r1[3] / (S::from_f64(1.5) + x * x)) * (f * b)) + b + f + y + x
}

#[differentiable]
fn program_33(x: f64, y: f64) -> f64 {
    let mut a = ((x + y) * 0.75).sin();
    let mut r1 = [
        ((0.875_f64 * y) * 0.75).sin(),
        ((x * 0.125_f64) * 0.75).sin(),
        ((y * x) * 0.75).sin(),
        ((a * 0.375_f64).abs() + 0.125).tanh(),
        ((-(y)) + 0.125).tanh(),
    ];
    r1[1] *= (((a * r1[2]) * 0.375_f64).abs() * 0.75).sin();
    let mut p2 =
        Pair { a: ((y * 0.625_f64).cos() + 0.125).tanh(), b: ((r1[3] * r1[4]) + 0.125).tanh() };
    a -= (((x * p2.a) * (y * r1[3])) + 0.125).tanh();
    'l3: for i4 in 1..1_usize {
        let g5 = |t: f64| {
            ((r1[i4 % 5] + r1[i4 % 5])
                / (1.5 + (r1[i4 % 5] - 0.625_f64).tanh() * (r1[i4 % 5] - 0.625_f64).tanh()))
                * t
        };
        let a = (g5((y * 0.625_f64).abs()) + g5((a + 0.875_f64).sin())).sin();
        p2 += Pair {
            a: ((x * r1[i4 % 5]) + 0.125).tanh(),
            b: ((p2.a / (1.5 + r1[i4 % 5] * r1[i4 % 5])) * 0.75).sin(),
        };
        p2 = p2.tamed();
    }
    let g6 = |t: f64| ((-0.875_f64 / (1.5 + r1[4] * r1[4])) * -0.625_f64).abs() * t;
    let b = (g6((r1[2] + y)) + g6((p2.b + p2.b))).sin();
    let (a, mut b) = (((a / (1.5 + b * b)) * 0.75).sin(), (r1[0] * 0.875_f64).abs());
    let e = mixed(&r1[..5]).sin();
    let mut u7: Vec<_> = r1.iter().map(|v| *v * x).collect();
    u7.push(((r1[0] - 0.375_f64).tanh() * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let e = (mixed(&u7) + u7[0]).tanh();
    let mut n9 = 0_usize;
    'l8: while n9 < 3 {
        n9 += 1;
        let mut d = ((a * r1[0]) + 0.125).tanh();
        let g10 = |t: f64| ((a - -1.125_f64).tanh() + 0.625_f64).sin() * t;
        let e = (g10((e - -0.125_f64).tanh()) + g10((r1[n9 % 5] + x))).sin();
        p2.b = ((p2.b + a) * 0.75).sin();
        p2 = p2.tamed();
    }
    (-(r1[3] + y)) + e + b + a + y + x
}

fn program_33_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(0.875_f64) * y) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(),
        ((y * x) * S::from_f64(0.75)).sin(),
        ((a * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((-(y)) + S::from_f64(0.125)).tanh(),
    ];
    r1[1] = r1[1] * (((a * r1[2]) * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin();
    let mut p2 = Pair {
        a: ((y * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((r1[3] * r1[4]) + S::from_f64(0.125)).tanh(),
    };
    a = a - (((x * p2.a) * (y * r1[3])) + S::from_f64(0.125)).tanh();
    'l3: for i4 in 1..1_usize {
        let g5 = |t: S| {
            ((r1[i4 % 5] + r1[i4 % 5])
                / (S::from_f64(1.5)
                    + (r1[i4 % 5] - S::from_f64(0.625_f64)).tanh()
                        * (r1[i4 % 5] - S::from_f64(0.625_f64)).tanh()))
                * t
        };
        let a =
            (g5((y * S::from_f64(0.625_f64)).abs()) + g5((a + S::from_f64(0.875_f64)).sin())).sin();
        p2 += Pair {
            a: ((x * r1[i4 % 5]) + S::from_f64(0.125)).tanh(),
            b: ((p2.a / (S::from_f64(1.5) + r1[i4 % 5] * r1[i4 % 5])) * S::from_f64(0.75)).sin(),
        };
        p2 = p2.tamed();
    }
    let g6 = |t: S| {
        ((S::from_f64(-0.875_f64) / (S::from_f64(1.5) + r1[4] * r1[4])) * S::from_f64(-0.625_f64))
            .abs()
            * t
    };
    let b = (g6((r1[2] + y)) + g6((p2.b + p2.b))).sin();
    let (a, mut b) = (
        ((a / (S::from_f64(1.5) + b * b)) * S::from_f64(0.75)).sin(),
        (r1[0] * S::from_f64(0.875_f64)).abs(),
    );
    let e = mixed(&r1[..5]).sin();
    let mut u7: Vec<_> = r1.iter().map(|v| *v * x).collect();
    u7.push(((r1[0] - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let e = (mixed(&u7) + u7[0]).tanh();
    let mut n9 = 0_usize;
    'l8: while n9 < 3 {
        n9 += 1;
        let mut d = ((a * r1[0]) + S::from_f64(0.125)).tanh();
        let g10 = |t: S| ((a - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.625_f64)).sin() * t;
        let e = (g10((e - S::from_f64(-0.125_f64)).tanh()) + g10((r1[n9 % 5] + x))).sin();
        p2.b = ((p2.b + a) * S::from_f64(0.75)).sin();
        p2 = p2.tamed();
    }
    (-(r1[3] + y)) + e + b + a + y + x
}

#[differentiable]
fn program_34(x: f64, y: f64) -> f64 {
    let mut e = (x + 0.125).tanh();
    let r1 = [((e - -0.375_f64).tanh() + 0.125).tanh(); 2];
    e = (((e - -1.125_f64).tanh() * (e - -1.125_f64).tanh() + 0.25).sqrt() * 0.75).sin();
    let g2 =
        |t: f64, v: &[f64]| mixed(v) * t + ((0.125_f64 * r1[1]) * (y * -0.375_f64).abs()).tanh();
    let e = folded(&g2, ((-(r1[1])) + 0.125).tanh(), &r1).sin();
    let a =
        match shape(((x * x + 0.25).sqrt() + 0.125).tanh(), ((x * 0.875_f64).cos() + 0.125).tanh())
        {
            Point => x,
            Disc(v) => ((r1[0] / (1.5 + y * y)) - -0.125_f64).tanh(),
            Shape::Box { w: v, h } => ((r1[1] + h) * (r1[1] + h) + 0.25).sqrt(),
        };
    let mut c = ((0.875_f64 * 0.875_f64 + 0.25).sqrt() * 0.75).sin();
    let a = match root((a - r1[1])) {
        Some(v) => (-(0.625_f64)),
        None => (e * -1.125_f64).cos(),
    };
    #[differentiable(checkpoint)]
    'l3: for i4 in (0..5_usize).step_by(2) {
        let f = summed(
            |t: f64| (((e * 0.875_f64) * (e * 0.875_f64) + 0.25).sqrt() * t).sin(),
            ((e / (1.5 + e * e)) * 0.75).sin(),
            1,
        )
        .tanh();
        'l5: for i6 in (0..0_usize).step_by(2) {
            c += (((x * x + 0.25).sqrt() * -0.625_f64).cos() * 0.75).sin();
            let z7;
            let mut n8 = 0_usize;
            loop {
                n8 += 1;
                let t = ((x * 0.375_f64).max(r1[(i6 * i6 + 1) % 2]) + (a * f));
                if n8 > 2 || (r1[i6 % 2] * a) > (c * 0.875_f64).abs() {
                    z7 = y;
                    break;
                }
            }
        }
        if y < (c + 0.125_f64).sin() {
            continue;
        }
    }
    let mut p9 = Pair {
        a: ((r1[1] - 0.375_f64) + 0.125).tanh(),
        b: ((c + -0.625_f64).sin() + 0.125).tanh(),
    };
    'l10: for i11 in (2..0_usize).step_by(2) {
        'l12: for i13 in 1..1_usize {
            let e = mixed(&r1).sin();
        }
        c += (((((i11 as f64) * 0.25) * 0.125_f64).max(x) * -0.875_f64).cos() + 0.125).tanh();
    }
    a + a + c + e + y + x
}

fn program_34_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (x + S::from_f64(0.125)).tanh();
    let r1 = [((e - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(); 2];
    e = (((e - S::from_f64(-1.125_f64)).tanh() * (e - S::from_f64(-1.125_f64)).tanh()
        + S::from_f64(0.25))
    .sqrt()
        * S::from_f64(0.75))
    .sin();
    let g2 = |t: S, v: &[S]| {
        mixed(v) * t
            + ((S::from_f64(0.125_f64) * r1[1]) * (y * S::from_f64(-0.375_f64)).abs()).tanh()
    };
    let e = folded(&g2, ((-(r1[1])) + S::from_f64(0.125)).tanh(), &r1).sin();
    let a = match shape(
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
    ) {
        Point => x,
        Disc(v) => ((r1[0] / (S::from_f64(1.5) + y * y)) - S::from_f64(-0.125_f64)).tanh(),
        Shape::Box { w: v, h } => ((r1[1] + h) * (r1[1] + h) + S::from_f64(0.25)).sqrt(),
    };
    let mut c = ((S::from_f64(0.875_f64) * S::from_f64(0.875_f64) + S::from_f64(0.25)).sqrt()
        * S::from_f64(0.75))
    .sin();
    let a = match root((a - r1[1])) {
        Some(v) => (-(S::from_f64(0.625_f64))),
        None => (e * S::from_f64(-1.125_f64)).cos(),
    };

    'l3: for i4 in (0..5_usize).step_by(2) {
        let f = summed(
            |t: S| {
                (((e * S::from_f64(0.875_f64)) * (e * S::from_f64(0.875_f64)) + S::from_f64(0.25))
                    .sqrt()
                    * t)
                    .sin()
            },
            ((e / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75)).sin(),
            1,
        )
        .tanh();
        'l5: for i6 in (0..0_usize).step_by(2) {
            c = c
                + (((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.625_f64)).cos()
                    * S::from_f64(0.75))
                .sin();
            let z7;
            let mut n8 = 0_usize;
            loop {
                n8 += 1;
                let t = ((x * S::from_f64(0.375_f64)).max(r1[(i6 * i6 + 1) % 2]) + (a * f));
                if n8 > 2 || (r1[i6 % 2] * a).cmpgt((c * S::from_f64(0.875_f64)).abs()) {
                    z7 = y;
                    break;
                }
            }
        }
        if y.cmplt((c + S::from_f64(0.125_f64)).sin()) {
            continue;
        }
    }
    let mut p9 = Pair {
        a: ((r1[1] - S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
        b: ((c + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
    };
    'l10: for i11 in (2..0_usize).step_by(2) {
        'l12: for i13 in 1..1_usize {
            let e = mixed(&r1).sin();
        }
        c = c
            + ((((S::from_f64(i11 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64)).max(x)
                * S::from_f64(-0.875_f64))
            .cos()
                + S::from_f64(0.125))
            .tanh();
    }
    a + a + c + e + y + x
}

#[differentiable]
fn program_35(x: f64, y: f64) -> f64 {
    let mut a = ((y * -0.375_f64) + 0.125).tanh();
    let mut r1 = [
        ((a + a) + 0.125).tanh(),
        ((y / (1.5 + 0.875_f64 * 0.875_f64)) + 0.125).tanh(),
        (a * 0.75).sin(),
        ((-(a)) + 0.125).tanh(),
        ((0.125_f64 - y) * 0.75).sin(),
    ];
    let mut p2 = Pair { a: ((y / (1.5 + x * x)) * 0.75).sin(), b: ((x * y) + 0.125).tanh() };
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((p2.b + y) * (x * a));
        if n4 > 2 || (r1[2] - 0.625_f64).tanh() > (y + r1[4]) {
            z3 = ((r1[0] * r1[0] + 0.25).sqrt() + (t - 0.375_f64).tanh());
            break;
        }
    }
    a = ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh();
    let c: f64 = r1.iter().map(|v| v * ((p2.b * z3) + 0.125).tanh()).sum();
    let mut p5 = Pair { a: (c + 0.125).tanh(), b: ((a - -0.125_f64).tanh() + 0.125).tanh() };
    let z6;
    if (-(r1[4])) >= (r1[4] * 0.875_f64).max(r1[4]) {
        z6 = (-(p5.b / (1.5 + a * a)));
    } else {
        z6 = (p5.a * -0.375_f64).cos();
    }
    for v in r1.iter() {
        a = a * ((z3 * -0.125_f64).max(y) * 0.75).sin()
            + *v * ((z3 * -0.125_f64).max(y) * 0.75).sin();
    }
    r1[1] = (((y * p5.b) * -0.625_f64).abs() * 0.75).sin();
    let c = match root((r1[1] - -1.125_f64).tanh()) {
        Some(v) => ((z3 - x) + x),
        None => (r1[0] + r1[3]),
    };
    r1[3] = (((r1[4] * c) * 0.125_f64).max(-0.875_f64) * 0.75).sin();
    let d: f64 = r1.iter().map(|v| v * ((z3 / (1.5 + x * x)) * 0.75).sin()).sum();
    let c = p5
        .dot(&Pair {
            a: ((x * 0.875_f64).max(p5.b) + 0.125).tanh(),
            b: ((a * -1.125_f64).cos() + 0.125).tanh(),
        })
        .sin();
    let f = match shape(
        ((-(-0.125_f64)) + 0.125).tanh(),
        ((r1[4] * -0.375_f64).abs() + 0.125).tanh(),
    ) {
        Shape::Point => (p5.b / (1.5 + d * d)),
        Shape::Disc(v) => (r1[0] + (r1[0] * r1[2])),
        Shape::Box { w: v, h } => ((z3 * p5.b) * p5.a),
    };
    r1[4] = (((0.625_f64 * r1[3]) * 0.375_f64).abs() + 0.125).tanh();
    ((r1[3] * 0.875_f64).abs() / (1.5 + (z6 / (1.5 + a * a)) * (z6 / (1.5 + a * a))))
        + f
        + c
        + d
        + z6
        + z3
        + a
        + y
        + x
}

fn program_35_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * S::from_f64(-0.375_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((a + a) + S::from_f64(0.125)).tanh(),
        ((y / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64)))
            + S::from_f64(0.125))
        .tanh(),
        (a * S::from_f64(0.75)).sin(),
        ((-(a)) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.125_f64) - y) * S::from_f64(0.75)).sin(),
    ];
    let mut p2 = Pair {
        a: ((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
        b: ((x * y) + S::from_f64(0.125)).tanh(),
    };
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((p2.b + y) * (x * a));
        if n4 > 2 || (r1[2] - S::from_f64(0.625_f64)).tanh().cmpgt((y + r1[4])) {
            z3 = ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + (t - S::from_f64(0.375_f64)).tanh());
            break;
        }
    }
    a = ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let c = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * ((p2.b * z3) + S::from_f64(0.125)).tanh());
    let mut p5 = Pair {
        a: (c + S::from_f64(0.125)).tanh(),
        b: ((a - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    let z6;
    if (-(r1[4])).cmpge((r1[4] * S::from_f64(0.875_f64)).max(r1[4])) {
        z6 = (-(p5.b / (S::from_f64(1.5) + a * a)));
    } else {
        z6 = (p5.a * S::from_f64(-0.375_f64)).cos();
    }
    for v in r1.iter() {
        a = a * ((z3 * S::from_f64(-0.125_f64)).max(y) * S::from_f64(0.75)).sin()
            + *v * ((z3 * S::from_f64(-0.125_f64)).max(y) * S::from_f64(0.75)).sin();
    }
    r1[1] = (((y * p5.b) * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let c = match root((r1[1] - S::from_f64(-1.125_f64)).tanh()) {
        Some(v) => ((z3 - x) + x),
        None => (r1[0] + r1[3]),
    };
    r1[3] = (((r1[4] * c) * S::from_f64(0.125_f64)).max(S::from_f64(-0.875_f64))
        * S::from_f64(0.75))
    .sin();
    let d = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((z3 / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin()
    });
    let c = p5
        .dot(&Pair {
            a: ((x * S::from_f64(0.875_f64)).max(p5.b) + S::from_f64(0.125)).tanh(),
            b: ((a * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        })
        .sin();
    let f = match shape(
        ((-(S::from_f64(-0.125_f64))) + S::from_f64(0.125)).tanh(),
        ((r1[4] * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (p5.b / (S::from_f64(1.5) + d * d)),
        Shape::Disc(v) => (r1[0] + (r1[0] * r1[2])),
        Shape::Box { w: v, h } => ((z3 * p5.b) * p5.a),
    };
    r1[4] = (((S::from_f64(0.625_f64) * r1[3]) * S::from_f64(0.375_f64)).abs()
        + S::from_f64(0.125))
    .tanh();
    ((r1[3] * S::from_f64(0.875_f64)).abs()
        / (S::from_f64(1.5)
            + (z6 / (S::from_f64(1.5) + a * a)) * (z6 / (S::from_f64(1.5) + a * a))))
        + f
        + c
        + d
        + z6
        + z3
        + a
        + y
        + x
}

#[differentiable]
fn program_36(x: f64, y: f64) -> f64 {
    let mut e = ((y - -0.875_f64).tanh() + 0.125).tanh();
    let mut r1 = [
        ((x / (1.5 + e * e)) * 0.75).sin(),
        ((x + 0.875_f64).sin() * 0.75).sin(),
        ((x * e) * 0.75).sin(),
    ];
    let mut p2 = Pair { a: ((r1[2] + x) + 0.125).tanh(), b: ((x * y) * 0.75).sin() };
    let c = match shape(((e + 0.375_f64).sin() * 0.75).sin(), ((r1[1] - e) + 0.125).tanh()) {
        Point => (x + r1[1]),
        Disc(v) => ((e - p2.b) * (e - p2.b) + 0.25).sqrt(),
        Shape::Box { w: v, h } => ((-0.125_f64 * x) + (p2.a + r1[0])),
    };
    r1[1] = (((c * c) / (1.5 + (x + 0.125_f64).sin() * (x + 0.125_f64).sin())) * 0.75).sin();
    'l3: for i4 in (1..5_usize).rev() {
        let d: f64 = r1.iter().map(|v| v * ((((i4 as f64) * 0.25) + p2.a) * 0.75).sin()).sum();
    }
    let mut c = ((c * y) + 0.125).tanh();
    let z5;
    if r1[0] < (r1[0] / (1.5 + x * x)) {
        z5 = (r1[0] - -1.125_f64).tanh();
    } else {
        z5 = (r1[0] - 0.625_f64).tanh();
    }
    let mut u6: Vec<_> = r1.iter().map(|v| *v * r1[2]).collect();
    u6.push(((z5 + -1.125_f64) * 0.75).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let a = (mixed(&u6) + u6[0]).tanh();
    e = (((y * -0.125_f64).abs() * -1.125_f64).abs() * 0.75).sin();
    'l7: for i8 in (2..1_usize).step_by(2) {
        let c = if (-1.125_f64 + 0.875_f64).sin() >= (0.875_f64 + r1[i8 % 3]) {
            p2.a
        } else {
            ((y - 0.375_f64).tanh() - (e * 0.875_f64).abs())
        };
        p2 = (p2 - p2 * (y * 0.75).sin()).tamed();
        p2 = p2.tamed();
    }
    'l9: for i10 in (0..0_usize).rev() {
        'l11: for i12 in 2..0_usize {
            p2 = -(p2 - p2).tamed();
            p2 = p2.tamed();
            'l13: for i14 in (1..0_usize).step_by(2) {
                let c = (a * a + 0.25).sqrt();
                p2 += p2;
                p2 = p2.tamed();
                e *= (((((i10 as f64) * 0.25) * -0.375_f64).abs()
                    - (0.625_f64 * -0.125_f64).max(r1[(i10 * i10 + 1) % 3]))
                    * 0.75)
                    .sin();
            }
            let d = match shape(
                ((y * y + 0.25).sqrt() * 0.75).sin(),
                ((((i12 as f64) * 0.25) * z5) * 0.75).sin(),
            ) {
                Shape::Point => (a * 0.125_f64).max(-0.625_f64),
                Shape::Disc(v) => ((p2.b * 0.125_f64) * (-(0.125_f64))),
                Shape::Box { w: v, h } => ((x * x + 0.25).sqrt() * -0.375_f64).abs(),
            };
        }
    }
    p2.a + a + z5 + c + e + y + x
}

fn program_36_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75)).sin(),
        ((x + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
        ((x * e) * S::from_f64(0.75)).sin(),
    ];
    let mut p2 = Pair {
        a: ((r1[2] + x) + S::from_f64(0.125)).tanh(),
        b: ((x * y) * S::from_f64(0.75)).sin(),
    };
    let c = match shape(
        ((e + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((r1[1] - e) + S::from_f64(0.125)).tanh(),
    ) {
        Point => (x + r1[1]),
        Disc(v) => ((e - p2.b) * (e - p2.b) + S::from_f64(0.25)).sqrt(),
        Shape::Box { w: v, h } => ((S::from_f64(-0.125_f64) * x) + (p2.a + r1[0])),
    };
    r1[1] = (((c * c)
        / (S::from_f64(1.5)
            + (x + S::from_f64(0.125_f64)).sin() * (x + S::from_f64(0.125_f64)).sin()))
        * S::from_f64(0.75))
    .sin();
    'l3: for i4 in (1..5_usize).rev() {
        let d = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v
                * (((S::from_f64(i4 as f64) * S::from_f64(0.25)) + p2.a) * S::from_f64(0.75)).sin()
        });
    }
    let mut c = ((c * y) + S::from_f64(0.125)).tanh();
    let z5;
    if r1[0].cmplt((r1[0] / (S::from_f64(1.5) + x * x))) {
        z5 = (r1[0] - S::from_f64(-1.125_f64)).tanh();
    } else {
        z5 = (r1[0] - S::from_f64(0.625_f64)).tanh();
    }
    let mut u6: Vec<_> = r1.iter().map(|v| *v * r1[2]).collect();
    u6.push(((z5 + S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let a = (mixed(&u6) + u6[0]).tanh();
    e = (((y * S::from_f64(-0.125_f64)).abs() * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75))
        .sin();
    'l7: for i8 in (2..1_usize).step_by(2) {
        let c = if (S::from_f64(-1.125_f64) + S::from_f64(0.875_f64))
            .sin()
            .cmpge((S::from_f64(0.875_f64) + r1[i8 % 3]))
        {
            p2.a
        } else {
            ((y - S::from_f64(0.375_f64)).tanh() - (e * S::from_f64(0.875_f64)).abs())
        };
        p2 = (p2 - p2 * (y * S::from_f64(0.75)).sin()).tamed();
        p2 = p2.tamed();
    }
    'l9: for i10 in (0..0_usize).rev() {
        'l11: for i12 in 2..0_usize {
            p2 = -(p2 - p2).tamed();
            p2 = p2.tamed();
            'l13: for i14 in (1..0_usize).step_by(2) {
                let c = (a * a + S::from_f64(0.25)).sqrt();
                p2 += p2;
                p2 = p2.tamed();
                e = e
                    * ((((S::from_f64(i10 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64))
                        .abs()
                        - (S::from_f64(0.625_f64) * S::from_f64(-0.125_f64))
                            .max(r1[(i10 * i10 + 1) % 3]))
                        * S::from_f64(0.75))
                    .sin();
            }
            let d = match shape(
                ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                (((S::from_f64(i12 as f64) * S::from_f64(0.25)) * z5) * S::from_f64(0.75)).sin(),
            ) {
                Shape::Point => (a * S::from_f64(0.125_f64)).max(S::from_f64(-0.625_f64)),
                Shape::Disc(v) => ((p2.b * S::from_f64(0.125_f64)) * (-(S::from_f64(0.125_f64)))),
                Shape::Box { w: v, h } => {
                    ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.375_f64)).abs()
                }
            };
        }
    }
    p2.a + a + z5 + c + e + y + x
}

#[differentiable]
fn program_37(x: f64, y: f64) -> f64 {
    let mut a = ((0.375_f64 - x) * 0.75).sin();
    let r1 = [((-(a)) + 0.125).tanh(); 2];
    let e = mixed(&r1[0..]).sin();
    a = ((a * (x + -0.625_f64).sin()) * 0.75).sin();
    a = (((r1[0] * 0.875_f64).max(r1[1]) + (a * -0.875_f64).abs()) * 0.75).sin();
    a = (((e * -0.625_f64).max(r1[0]) * (a * -0.125_f64).cos()) + 0.125).tanh();
    let mut p2 = Pair { a: ((r1[1] * -0.625_f64).max(y) + 0.125).tanh(), b: (y * 0.75).sin() };
    let (a, mut b) = (((y + 0.875_f64).sin() + 0.125).tanh(), (p2.a * r1[0]));
    let mut u3 = r1.to_vec();
    u3.push(((e / (1.5 + r1[0] * r1[0])) + 0.125).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let a = (mixed(&u3) + u3[0]).tanh();
    let c = match shape(((p2.a - r1[1]) * 0.75).sin(), ((r1[0] * 0.875_f64).max(a) * 0.75).sin()) {
        Shape::Point => (r1[1] * -0.125_f64).abs(),
        Shape::Disc(v) => p2.a,
        Shape::Box { w: v, h } => ((p2.a * -0.125_f64).max(p2.b) + (r1[1] - a)),
    };
    'l4: for i5 in (1..1_usize).step_by(2) {
        let c = match roots(
            (r1[i5 % 2] - 0.875_f64).tanh(),
            (r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2]),
        ) {
            Ok(v) => ((r1[i5 % 2] * -0.375_f64).abs() - -1.125_f64).tanh(),
            Err(true) => r1[(i5 * i5 + 1) % 2],
            Err(_) => (r1[1] / (1.5 + r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2])),
        };
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        if (y * r1[1]) >= p2.b {
            b = (r1[1] * 0.75).sin();
        }
        let g8 = |t: f64| ((-0.625_f64 * -0.875_f64).cos() * 0.875_f64).abs() * t;
        let f = (g8((p2.a * -1.125_f64).abs()) + g8(x)).sin();
        let b = match shape(
            ((b * r1[(n7 + 0) % 2]) + 0.125).tanh(),
            ((r1[1] + -0.875_f64) * 0.75).sin(),
        ) {
            Point => (f / (1.5 + -1.125_f64 * -1.125_f64)),
            Disc(v) => f,
            Shape::Box { w: v, h } => ((p2.b * p2.b) * -0.375_f64).cos(),
        };
    }
    (0.875_f64 * -0.375_f64).cos() + c + a + b + e + y + x
}

fn program_37_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(0.375_f64) - x) * S::from_f64(0.75)).sin();
    let r1 = [((-(a)) + S::from_f64(0.125)).tanh(); 2];
    let e = mixed(&r1[0..]).sin();
    a = ((a * (x + S::from_f64(-0.625_f64)).sin()) * S::from_f64(0.75)).sin();
    a = (((r1[0] * S::from_f64(0.875_f64)).max(r1[1]) + (a * S::from_f64(-0.875_f64)).abs())
        * S::from_f64(0.75))
    .sin();
    a = (((e * S::from_f64(-0.625_f64)).max(r1[0]) * (a * S::from_f64(-0.125_f64)).cos())
        + S::from_f64(0.125))
    .tanh();
    let mut p2 = Pair {
        a: ((r1[1] * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh(),
        b: (y * S::from_f64(0.75)).sin(),
    };
    let (a, mut b) =
        (((y + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(), (p2.a * r1[0]));
    let mut u3 = r1.to_vec();
    u3.push(((e / (S::from_f64(1.5) + r1[0] * r1[0])) + S::from_f64(0.125)).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let a = (mixed(&u3) + u3[0]).tanh();
    let c = match shape(
        ((p2.a - r1[1]) * S::from_f64(0.75)).sin(),
        ((r1[0] * S::from_f64(0.875_f64)).max(a) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (r1[1] * S::from_f64(-0.125_f64)).abs(),
        Shape::Disc(v) => p2.a,
        Shape::Box { w: v, h } => ((p2.a * S::from_f64(-0.125_f64)).max(p2.b) + (r1[1] - a)),
    };
    'l4: for i5 in (1..1_usize).step_by(2) {
        let c = match roots(
            (r1[i5 % 2] - S::from_f64(0.875_f64)).tanh(),
            (r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2]),
        ) {
            Ok(v) => {
                ((r1[i5 % 2] * S::from_f64(-0.375_f64)).abs() - S::from_f64(-1.125_f64)).tanh()
            }
            Err(true) => r1[(i5 * i5 + 1) % 2],
            Err(_) => (r1[1] / (S::from_f64(1.5) + r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2])),
        };
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        if (y * r1[1]).cmpge(p2.b) {
            b = (r1[1] * S::from_f64(0.75)).sin();
        }
        let g8 = |t: S| {
            ((S::from_f64(-0.625_f64) * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.875_f64))
                .abs()
                * t
        };
        let f = (g8((p2.a * S::from_f64(-1.125_f64)).abs()) + g8(x)).sin();
        let b = match shape(
            ((b * r1[(n7 + 0) % 2]) + S::from_f64(0.125)).tanh(),
            ((r1[1] + S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
        ) {
            Point => (f / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64))),
            Disc(v) => f,
            Shape::Box { w: v, h } => ((p2.b * p2.b) * S::from_f64(-0.375_f64)).cos(),
        };
    }
    (S::from_f64(0.875_f64) * S::from_f64(-0.375_f64)).cos() + c + a + b + e + y + x
}

#[differentiable]
fn program_38(x: f64, y: f64) -> f64 {
    let mut d = ((x - -1.125_f64).tanh() * 0.75).sin();
    let mut r1 = [((0.875_f64 + d) * 0.75).sin(), ((x * y) * 0.75).sin(), (d + 0.125).tanh()];
    if (r1[2] * r1[1]) <= (x * d) {
        let (a, mut b) = (((x - 0.625_f64).tanh() * 0.75).sin(), (y + d));
    }
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;
        #[differentiable(checkpoint)]
        'l4: for i5 in 0..=4_usize {
            let mut b = ((r1[(i5 * i5 + 1) % 3] - y) * 0.75).sin();
            let g6 = |t: f64| ((r1[(n3 + 0) % 3] - x) + -0.875_f64).sin() * t;
            let e = (g6((x - r1[(i5 + 0) % 3])) + g6((y + -0.625_f64).sin())).sin();
            'l7: for i8 in 1..0_usize {
                let mut p9 = Pair {
                    a: ((d - -0.125_f64).tanh() * 0.75).sin(),
                    b: ((((i8 as f64) * 0.25) + ((i8 as f64) * 0.25)) * 0.75).sin(),
                };
            }
        }
        let mut p10 = Pair {
            a: ((x * 0.375_f64).cos() + 0.125).tanh(),
            b: ((y * 0.875_f64).max(d) * 0.75).sin(),
        };
        let by11 = ((r1[n3 % 3] + -0.125_f64).sin() + 0.125).tanh();
        let e = shifted(&mut r1[0..], by11);
    }
    let b = ((-(x)) + (x * y));
    let f = summed(bent, ((b * x) + 0.125).tanh(), 3).tanh();
    let mut d = ((d * 0.375_f64).max(b) + 0.125).tanh();
    'l12: for i13 in (2..3_usize).rev() {
        let z14;
        let mut n15 = 0_usize;
        loop {
            n15 += 1;
            let t = ((r1[(i13 * i13 + 1) % 3] / (1.5 + r1[1] * r1[1]))
                * (r1[(i13 * i13 + 1) % 3] / (1.5 + r1[1] * r1[1]))
                + 0.25)
                .sqrt();
            if n15 > 2 || i13 % 3 == 2 {
                z14 = ((r1[i13 % 3] * r1[(i13 + 1) % 3]) + 0.875_f64);
                break;
            }
        }
    }
    r1[0] + d + f + b + y + x
}

fn program_38_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(0.875_f64) + d) * S::from_f64(0.75)).sin(),
        ((x * y) * S::from_f64(0.75)).sin(),
        (d + S::from_f64(0.125)).tanh(),
    ];
    if (r1[2] * r1[1]).cmple((x * d)) {
        let (a, mut b) = (((x - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(), (y + d));
    }
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;

        'l4: for i5 in 0..=4_usize {
            let mut b = ((r1[(i5 * i5 + 1) % 3] - y) * S::from_f64(0.75)).sin();
            let g6 = |t: S| ((r1[(n3 + 0) % 3] - x) + S::from_f64(-0.875_f64)).sin() * t;
            let e = (g6((x - r1[(i5 + 0) % 3])) + g6((y + S::from_f64(-0.625_f64)).sin())).sin();
            'l7: for i8 in 1..0_usize {
                let mut p9 = Pair {
                    a: ((d - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
                    b: (((S::from_f64(i8 as f64) * S::from_f64(0.25))
                        + (S::from_f64(i8 as f64) * S::from_f64(0.25)))
                        * S::from_f64(0.75))
                    .sin(),
                };
            }
        }
        let mut p10 = Pair {
            a: ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
            b: ((y * S::from_f64(0.875_f64)).max(d) * S::from_f64(0.75)).sin(),
        };
        let by11 = ((r1[n3 % 3] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh();
        let e = shifted(&mut r1[0..], by11);
    }
    let b = ((-(x)) + (x * y));
    let f = summed(bent, ((b * x) + S::from_f64(0.125)).tanh(), 3).tanh();
    let mut d = ((d * S::from_f64(0.375_f64)).max(b) + S::from_f64(0.125)).tanh();
    'l12: for i13 in (2..3_usize).rev() {
        let z14;
        let mut n15 = 0_usize;
        loop {
            n15 += 1;
            let t = ((r1[(i13 * i13 + 1) % 3] / (S::from_f64(1.5) + r1[1] * r1[1]))
                * (r1[(i13 * i13 + 1) % 3] / (S::from_f64(1.5) + r1[1] * r1[1]))
                + S::from_f64(0.25))
            .sqrt();
            if n15 > 2 || i13 % 3 == 2 {
                z14 = ((r1[i13 % 3] * r1[(i13 + 1) % 3]) + S::from_f64(0.875_f64));
                break;
            }
        }
    }
    r1[0] + d + f + b + y + x
}

#[differentiable]
fn program_39(x: f64, y: f64) -> f64 {
    let mut f = ((y + x) + 0.125).tanh();
    let mut r1 = [
        ((-0.625_f64 * -0.625_f64 + 0.25).sqrt() * 0.75).sin(),
        ((y * f) * 0.75).sin(),
        (x + 0.125).tanh(),
    ];
    let r2 = [((f * x) * 0.75).sin(); 5];
    let d =
        ((x * -0.875_f64).max(y) / (1.5 + (r2[4] * -0.875_f64).abs() * (r2[4] * -0.875_f64).abs()));
    let c = match shape(((f * f) * 0.75).sin(), ((r2[2] - f) * 0.75).sin()) {
        Shape::Point => (r1[0] + 0.875_f64),
        Shape::Disc(v) => (0.375_f64 + (-0.125_f64 - y)),
        Shape::Box { w: v, h } => ((h * -0.375_f64).abs() * (r2[0] / (1.5 + f * f))),
    };
    let mut u3 = r1.to_vec();
    u3.push(((y * c) * 0.75).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let mut r4 =
        [((-(r2[2])) + 0.125).tanh(), (f * 0.75).sin(), ((d * d + 0.25).sqrt() + 0.125).tanh()];
    let d = match shape(
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
        ((0.625_f64 * -1.125_f64).abs() * 0.75).sin(),
    ) {
        Shape::Point => (-(0.625_f64)),
        Shape::Disc(v) => ((d - 0.625_f64).tanh() * (0.625_f64 * -1.125_f64).max(c)),
        Shape::Box { w: v, h } => ((h * -1.125_f64) + (r4[1] + x)),
    };
    f = (((0.125_f64 * -0.375_f64).abs() - (f + d)) + 0.125).tanh();
    r4[0] = (((d * c) + (f * -1.125_f64).abs()) + 0.125).tanh();
    f += (r4[2] * 0.75).sin();
    r4[0] -= (((r2[0] * 0.125_f64).cos() * (r2[0] * 0.125_f64).cos() + 0.25).sqrt() + 0.125).tanh();
    let f: f64 = r2.iter().map(|v| v * ((d - -0.125_f64).tanh() + 0.125).tanh()).sum();
    let mut b = ((-(d)) * 0.75).sin();
    let mut b = ((c * c + 0.25).sqrt() + 0.125).tanh();
    let a = if (r2[4] * -0.375_f64).cos() > (x - -0.375_f64).tanh() {
        ((b * r1[2]) * (b * r1[2]) + 0.25).sqrt()
    } else {
        b
    };
    ((r4[1] * d) + 0.875_f64).sin() + a + b + f + d + c + y + x
}

fn program_39_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y + x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
        ((y * f) * S::from_f64(0.75)).sin(),
        (x + S::from_f64(0.125)).tanh(),
    ];
    let r2 = [((f * x) * S::from_f64(0.75)).sin(); 5];
    let d = ((x * S::from_f64(-0.875_f64)).max(y)
        / (S::from_f64(1.5)
            + (r2[4] * S::from_f64(-0.875_f64)).abs() * (r2[4] * S::from_f64(-0.875_f64)).abs()));
    let c =
        match shape(((f * f) * S::from_f64(0.75)).sin(), ((r2[2] - f) * S::from_f64(0.75)).sin()) {
            Shape::Point => (r1[0] + S::from_f64(0.875_f64)),
            Shape::Disc(v) => (S::from_f64(0.375_f64) + (S::from_f64(-0.125_f64) - y)),
            Shape::Box { w: v, h } => {
                ((h * S::from_f64(-0.375_f64)).abs() * (r2[0] / (S::from_f64(1.5) + f * f)))
            }
        };
    let mut u3 = r1.to_vec();
    u3.push(((y * c) * S::from_f64(0.75)).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let mut r4 = [
        ((-(r2[2])) + S::from_f64(0.125)).tanh(),
        (f * S::from_f64(0.75)).sin(),
        ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    ];
    let d = match shape(
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.625_f64) * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (-(S::from_f64(0.625_f64))),
        Shape::Disc(v) => {
            ((d - S::from_f64(0.625_f64)).tanh()
                * (S::from_f64(0.625_f64) * S::from_f64(-1.125_f64)).max(c))
        }
        Shape::Box { w: v, h } => ((h * S::from_f64(-1.125_f64)) + (r4[1] + x)),
    };
    f = (((S::from_f64(0.125_f64) * S::from_f64(-0.375_f64)).abs() - (f + d)) + S::from_f64(0.125))
        .tanh();
    r4[0] = (((d * c) + (f * S::from_f64(-1.125_f64)).abs()) + S::from_f64(0.125)).tanh();
    f = f + (r4[2] * S::from_f64(0.75)).sin();
    r4[0] = r4[0]
        - (((r2[0] * S::from_f64(0.125_f64)).cos() * (r2[0] * S::from_f64(0.125_f64)).cos()
            + S::from_f64(0.25))
        .sqrt()
            + S::from_f64(0.125))
        .tanh();
    let f = r2.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((d - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh()
    });
    let mut b = ((-(d)) * S::from_f64(0.75)).sin();
    let mut b = ((c * c + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let a = if (r2[4] * S::from_f64(-0.375_f64)).cos().cmpgt((x - S::from_f64(-0.375_f64)).tanh()) {
        ((b * r1[2]) * (b * r1[2]) + S::from_f64(0.25)).sqrt()
    } else {
        b
    };
    ((r4[1] * d) + S::from_f64(0.875_f64)).sin() + a + b + f + d + c + y + x
}

#[differentiable]
fn program_40(x: f64, y: f64) -> f64 {
    let mut b = ((y * 0.375_f64).cos() * 0.75).sin();
    let r1 = [((b + 0.125_f64).sin() * 0.75).sin(); 2];
    b += (((-(x)) - -0.875_f64).tanh() * 0.75).sin();
    'l2: for i3 in 2..=3_usize {
        let (a, mut b) = (((((i3 as f64) * 0.25) * b) + 0.125).tanh(), ((i3 as f64) * 0.25));
    }
    let mut c = (0.125_f64 + 0.125).tanh();
    let d = root((y * y)).map_or((-(b)), |v| -1.125_f64);
    let mut p4 = Pair { a: ((d * 0.875_f64).abs() * 0.75).sin(), b: ((r1[0] - b) + 0.125).tanh() };
    let b =
        program_12(((x - r1[0]) + 0.125).tanh(), ((0.875_f64 - 0.375_f64).tanh() + 0.125).tanh())
            .tanh();
    let mut e = ((r1[1] * r1[1]) + 0.125).tanh();
    let c: f64 = r1.iter().map(|v| v * (r1[0] + 0.125).tanh()).sum();
    p4.turn(((e * e + 0.25).sqrt() * 0.75).sin());
    p4 = p4.tamed();
    p4 = (p4 - p4 * ((0.875_f64 - r1[0]) + 0.125).tanh()).tamed();
    p4 = p4.tamed();
    let g5 = |t: f64| ((-(x)) - -0.625_f64).tanh() * t;
    let f = (g5(-1.125_f64) + g5((b + r1[1]))).sin();
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        let e = mixed(&r1[..2]).sin();
        let mut u8 = r1.to_vec();
        u8.push((((n7 as f64) * 0.25) + 0.125).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let e = (mixed(&u8) + u8[0]).tanh();
    }
    ((y * 0.125_f64).abs() * (r1[1] * -0.875_f64).abs()) + f + c + e + b + d + y + x
}

fn program_40_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [((b + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 2];
    b = b + (((-(x)) - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    'l2: for i3 in 2..=3_usize {
        let (a, mut b) = (
            (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * b) + S::from_f64(0.125)).tanh(),
            (S::from_f64(i3 as f64) * S::from_f64(0.25)),
        );
    }
    let mut c = (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh();
    let d = root((y * y)).map_or((-(b)), |v| S::from_f64(-1.125_f64));
    let mut p4 = Pair {
        a: ((d * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((r1[0] - b) + S::from_f64(0.125)).tanh(),
    };
    let b = program_12_of(
        ((x - r1[0]) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.875_f64) - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut e = ((r1[1] * r1[1]) + S::from_f64(0.125)).tanh();
    let c = r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * (r1[0] + S::from_f64(0.125)).tanh());
    p4.turn(((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin());
    p4 = p4.tamed();
    p4 = (p4 - p4 * ((S::from_f64(0.875_f64) - r1[0]) + S::from_f64(0.125)).tanh()).tamed();
    p4 = p4.tamed();
    let g5 = |t: S| ((-(x)) - S::from_f64(-0.625_f64)).tanh() * t;
    let f = (g5(S::from_f64(-1.125_f64)) + g5((b + r1[1]))).sin();
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        let e = mixed(&r1[..2]).sin();
        let mut u8 = r1.to_vec();
        u8.push(((S::from_f64(n7 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let e = (mixed(&u8) + u8[0]).tanh();
    }
    ((y * S::from_f64(0.125_f64)).abs() * (r1[1] * S::from_f64(-0.875_f64)).abs())
        + f
        + c
        + e
        + b
        + d
        + y
        + x
}

#[differentiable]
fn program_41(x: f64, y: f64) -> f64 {
    let mut f = ((x + -0.125_f64) * 0.75).sin();
    let mut r1 = [
        ((y / (1.5 + f * f)) * 0.75).sin(),
        ((y * y + 0.25).sqrt() * 0.75).sin(),
        ((y * f) + 0.125).tanh(),
        ((f * -0.125_f64).cos() + 0.125).tanh(),
    ];
    let mut p2 = Pair { a: ((x + -0.375_f64).sin() * 0.75).sin(), b: (r1[2] * 0.75).sin() };
    p2 += p2;
    p2 = p2.tamed();
    let d = summed(
        |t: f64| (((x + x) * 0.125_f64).abs() * t).sin(),
        ((f * 0.375_f64).abs() * 0.75).sin(),
        0,
    )
    .tanh();
    let f = ((y - y) + (y / (1.5 + p2.a * p2.a)));
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((x * -0.625_f64).abs() * -1.125_f64).abs();
        if n4 > 2 || d <= (-0.125_f64 * -0.125_f64 + 0.25).sqrt() {
            z3 = ((t * -0.125_f64) * x);
            break;
        }
    }
    'l5: for i6 in 1..=2_usize {
        let g7 = |t: f64| ((((i6 as f64) * 0.25) * r1[1]) - f) * t;
        let a = (g7((r1[(i6 * i6 + 1) % 4] * -1.125_f64).abs())
            + g7((p2.a + r1[(i6 * i6 + 1) % 4])))
        .sin();
        if i6 % 2 == 0 {
            let d = if let Some(v) = root((f * -1.125_f64).cos()) {
                (-(r1[(i6 * i6 + 1) % 4] - p2.b))
            } else {
                (((i6 as f64) * 0.25) * ((i6 as f64) * 0.25) + 0.25).sqrt()
            };
        } else {
            'l8: for i9 in 0..2_usize {
                let c = ((d * d + 0.25).sqrt() + f);
            }
            'l10: for i11 in 2..1_usize {
                r1[i11 % 4] -= ((p2.b - -0.875_f64).tanh() + 0.125).tanh();
            }
        }
        let r12 = [
            ((r1[(i6 * i6 + 1) % 4] * -0.125_f64).cos() + 0.125).tanh(),
            ((p2.a * r1[(i6 * i6 + 1) % 4]) * 0.75).sin(),
            ((-0.875_f64 * -0.875_f64 + 0.25).sqrt() * 0.75).sin(),
            ((y * y + 0.25).sqrt() + 0.125).tanh(),
            ((r1[i6 % 4] * 0.375_f64) * 0.75).sin(),
        ];
    }
    ((x + -0.375_f64) * 0.125_f64).cos() + z3 + f + d + y + x
}

fn program_41_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x + S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y / (S::from_f64(1.5) + f * f)) * S::from_f64(0.75)).sin(),
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((y * f) + S::from_f64(0.125)).tanh(),
        ((f * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut p2 = Pair {
        a: ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        b: (r1[2] * S::from_f64(0.75)).sin(),
    };
    p2 += p2;
    p2 = p2.tamed();
    let d = summed(
        |t: S| (((x + x) * S::from_f64(0.125_f64)).abs() * t).sin(),
        ((f * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        0,
    )
    .tanh();
    let f = ((y - y) + (y / (S::from_f64(1.5) + p2.a * p2.a)));
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((x * S::from_f64(-0.625_f64)).abs() * S::from_f64(-1.125_f64)).abs();
        if n4 > 2
            || d.cmple(
                (S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt(),
            )
        {
            z3 = ((t * S::from_f64(-0.125_f64)) * x);
            break;
        }
    }
    'l5: for i6 in 1..=2_usize {
        let g7 = |t: S| (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[1]) - f) * t;
        let a = (g7((r1[(i6 * i6 + 1) % 4] * S::from_f64(-1.125_f64)).abs())
            + g7((p2.a + r1[(i6 * i6 + 1) % 4])))
        .sin();
        if i6 % 2 == 0 {
            let d = if let Some(v) = root((f * S::from_f64(-1.125_f64)).cos()) {
                (-(r1[(i6 * i6 + 1) % 4] - p2.b))
            } else {
                ((S::from_f64(i6 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i6 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
            };
        } else {
            'l8: for i9 in 0..2_usize {
                let c = ((d * d + S::from_f64(0.25)).sqrt() + f);
            }
            'l10: for i11 in 2..1_usize {
                r1[i11 % 4] = r1[i11 % 4]
                    - ((p2.b - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
            }
        }
        let r12 = [
            ((r1[(i6 * i6 + 1) % 4] * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
            ((p2.a * r1[(i6 * i6 + 1) % 4]) * S::from_f64(0.75)).sin(),
            ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
                * S::from_f64(0.75))
            .sin(),
            ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            ((r1[i6 % 4] * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        ];
    }
    ((x + S::from_f64(-0.375_f64)) * S::from_f64(0.125_f64)).cos() + z3 + f + d + y + x
}

#[differentiable]
fn program_42(x: f64, y: f64) -> f64 {
    let mut b = ((x * x + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [(b * 0.75).sin(), ((y + b) + 0.125).tanh()];
    'l2: for i3 in (0..1_usize).rev() {
        for v in r1.iter() {
            b = b * ((x * r1[(i3 * i3 + 1) % 2]) * 0.75).sin()
                + *v * ((x * r1[(i3 * i3 + 1) % 2]) * 0.75).sin();
        }
        let by4 = (b + 0.125).tanh();
        let a = shifted(&mut r1[1..], by4);
        for v in r1.iter() {
            b = b * ((((i3 as f64) * 0.25) + -0.375_f64).sin() * 0.75).sin()
                + *v * ((((i3 as f64) * 0.25) + -0.375_f64).sin() * 0.75).sin();
        }
    }
    let e = match roots(r1[1], (r1[0] * -0.875_f64)) {
        Ok(v) => x,
        Err(true) => b,
        Err(_) => (x - -0.625_f64).tanh(),
    };
    let mut d = (y * 0.75).sin();
    let g5 = |t: f64| ((y + r1[0]) - (d - b)) * t;
    let a = (g5((d / (1.5 + y * y))) + g5((0.625_f64 * 0.625_f64 + 0.25).sqrt())).sin();
    let e = if (r1[1] * -0.125_f64).max(-0.875_f64) <= (-(a)) {
        ((r1[0] - b) * -0.875_f64).max(d)
    } else {
        ((e * r1[0]) * -0.375_f64).abs()
    };
    let f = program_5(
        ((a * -0.625_f64).cos() + 0.125).tanh(),
        ((r1[0] * 0.375_f64).cos() + 0.125).tanh(),
    )
    .tanh();
    let b = mixed(&r1[1..]).sin();
    'l6: for i7 in 1..=1_usize {
        r1[i7 % 2] -= (((e * 0.875_f64).abs() + -0.875_f64).sin() + 0.125).tanh();
    }
    let c = program_28(((x * x) + 0.125).tanh(), ((b * e) * 0.75).sin()).tanh();
    let d = program_29(((e * 0.125_f64).cos() + 0.125).tanh(), ((f + c) + 0.125).tanh()).tanh();
    0.375_f64 + d + c + b + f + e + a + y + x
}

fn program_42_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [(b * S::from_f64(0.75)).sin(), ((y + b) + S::from_f64(0.125)).tanh()];
    'l2: for i3 in (0..1_usize).rev() {
        for v in r1.iter() {
            b = b * ((x * r1[(i3 * i3 + 1) % 2]) * S::from_f64(0.75)).sin()
                + *v * ((x * r1[(i3 * i3 + 1) % 2]) * S::from_f64(0.75)).sin();
        }
        let by4 = (b + S::from_f64(0.125)).tanh();
        let a = shifted(&mut r1[1..], by4);
        for v in r1.iter() {
            b = b
                * (((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(-0.375_f64)).sin()
                    * S::from_f64(0.75))
                .sin()
                + *v * (((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(-0.375_f64))
                    .sin()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    let e = match roots(r1[1], (r1[0] * S::from_f64(-0.875_f64))) {
        Ok(v) => x,
        Err(true) => b,
        Err(_) => (x - S::from_f64(-0.625_f64)).tanh(),
    };
    let mut d = (y * S::from_f64(0.75)).sin();
    let g5 = |t: S| ((y + r1[0]) - (d - b)) * t;
    let a = (g5((d / (S::from_f64(1.5) + y * y)))
        + g5((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt()))
    .sin();
    let e = if (r1[1] * S::from_f64(-0.125_f64)).max(S::from_f64(-0.875_f64)).cmple((-(a))) {
        ((r1[0] - b) * S::from_f64(-0.875_f64)).max(d)
    } else {
        ((e * r1[0]) * S::from_f64(-0.375_f64)).abs()
    };
    let f = program_5_of(
        ((a * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((r1[0] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let b = mixed(&r1[1..]).sin();
    'l6: for i7 in 1..=1_usize {
        r1[i7 % 2] = r1[i7 % 2]
            - (((e * S::from_f64(0.875_f64)).abs() + S::from_f64(-0.875_f64)).sin()
                + S::from_f64(0.125))
            .tanh();
    }
    let c =
        program_28_of(((x * x) + S::from_f64(0.125)).tanh(), ((b * e) * S::from_f64(0.75)).sin())
            .tanh();
    let d = program_29_of(
        ((e * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((f + c) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    S::from_f64(0.375_f64) + d + c + b + f + e + a + y + x
}

#[differentiable]
fn program_43(x: f64, y: f64) -> f64 {
    let mut e = ((y - y) + 0.125).tanh();
    let mut r1 = [((e * y) + 0.125).tanh(); 4];
    let mut p2 = Pair { a: ((-(r1[0])) + 0.125).tanh(), b: ((e / (1.5 + x * x)) + 0.125).tanh() };
    let d = match shape((y + 0.125).tanh(), ((e + -0.125_f64) * 0.75).sin()) {
        Shape::Point => (e * -0.625_f64).cos(),
        Shape::Disc(v) => (r1[2] / (1.5 + (-1.125_f64 + r1[1]) * (-1.125_f64 + r1[1]))),
        Shape::Box { w: v, h } => ((-(y)) / (1.5 + (p2.b - r1[0]) * (p2.b - r1[0]))),
    };
    'l3: for i4 in 0..5_usize {
        let a = match shape(
            ((y * r1[(i4 + 2) % 4]) * 0.75).sin(),
            ((r1[(i4 + 3) % 4] * x) * 0.75).sin(),
        ) {
            Shape::Point => r1[2],
            Shape::Disc(v) => ((-(-0.625_f64)) * (-(-0.625_f64)) + 0.25).sqrt(),
            Shape::Box { w: v, h } => ((y * y + 0.25).sqrt() / (1.5 + v * v)),
        };
        let c = if (a * 0.375_f64).abs() <= (y * p2.a) {
            ((p2.b * p2.b + 0.25).sqrt() + (r1[(i4 * i4 + 1) % 4] - r1[(i4 * i4 + 1) % 4]))
        } else {
            (r1[(i4 * i4 + 1) % 4] * (p2.b * a))
        };
        r1[(i4 * i4 + 1) % 4] *= ((a + -1.125_f64).sin() + 0.125).tanh();
    }
    p2.turn(((0.375_f64 + x) + 0.125).tanh());
    p2 = p2.tamed();
    r1[2] = ((-(r1[0])) + 0.125).tanh();
    if y >= (y + e) {
        return ((p2.b + r1[1]) / (1.5 + y * y));
    }
    let f = match root((r1[1] - -0.125_f64).tanh()) {
        Some(v) => ((r1[3] * v) * (-(e))),
        None => r1[1],
    };
    let by5 = ((f * r1[1]) * 0.75).sin();
    let d = shifted(&mut r1[0..], by5);
    let mut p6 = Pair { a: ((y * e) + 0.125).tanh(), b: ((p2.b * r1[2]) * 0.75).sin() };
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        'l9: for i10 in (1..2_usize).rev() {
            if 0.125_f64 >= (((i10 as f64) * 0.25) * -0.125_f64) {
                break 'l7;
            }
        }
        let by11 = ((d - -0.625_f64).tanh() * 0.75).sin();
        for v in r1.iter_mut() {
            *v = (*v * by11).sin();
        }
    }
    e + d + f + e + y + x
}

fn program_43_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y - y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((e * y) + S::from_f64(0.125)).tanh(); 4];
    let mut p2 = Pair {
        a: ((-(r1[0])) + S::from_f64(0.125)).tanh(),
        b: ((e / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
    };
    let d = match shape(
        (y + S::from_f64(0.125)).tanh(),
        ((e + S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (e * S::from_f64(-0.625_f64)).cos(),
        Shape::Disc(v) => {
            (r1[2]
                / (S::from_f64(1.5)
                    + (S::from_f64(-1.125_f64) + r1[1]) * (S::from_f64(-1.125_f64) + r1[1])))
        }
        Shape::Box { w: v, h } => ((-(y)) / (S::from_f64(1.5) + (p2.b - r1[0]) * (p2.b - r1[0]))),
    };
    'l3: for i4 in 0..5_usize {
        let a = match shape(
            ((y * r1[(i4 + 2) % 4]) * S::from_f64(0.75)).sin(),
            ((r1[(i4 + 3) % 4] * x) * S::from_f64(0.75)).sin(),
        ) {
            Shape::Point => r1[2],
            Shape::Disc(v) => ((-(S::from_f64(-0.625_f64))) * (-(S::from_f64(-0.625_f64)))
                + S::from_f64(0.25))
            .sqrt(),
            Shape::Box { w: v, h } => {
                ((y * y + S::from_f64(0.25)).sqrt() / (S::from_f64(1.5) + v * v))
            }
        };
        let c = if (a * S::from_f64(0.375_f64)).abs().cmple((y * p2.a)) {
            ((p2.b * p2.b + S::from_f64(0.25)).sqrt()
                + (r1[(i4 * i4 + 1) % 4] - r1[(i4 * i4 + 1) % 4]))
        } else {
            (r1[(i4 * i4 + 1) % 4] * (p2.b * a))
        };
        r1[(i4 * i4 + 1) % 4] = r1[(i4 * i4 + 1) % 4]
            * ((a + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh();
    }
    p2.turn(((S::from_f64(0.375_f64) + x) + S::from_f64(0.125)).tanh());
    p2 = p2.tamed();
    r1[2] = ((-(r1[0])) + S::from_f64(0.125)).tanh();
    if y.cmpge((y + e)) {
        return ((p2.b + r1[1]) / (S::from_f64(1.5) + y * y));
    }
    let f = match root((r1[1] - S::from_f64(-0.125_f64)).tanh()) {
        Some(v) => ((r1[3] * v) * (-(e))),
        None => r1[1],
    };
    let by5 = ((f * r1[1]) * S::from_f64(0.75)).sin();
    let d = shifted(&mut r1[0..], by5);
    let mut p6 = Pair {
        a: ((y * e) + S::from_f64(0.125)).tanh(),
        b: ((p2.b * r1[2]) * S::from_f64(0.75)).sin(),
    };
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        'l9: for i10 in (1..2_usize).rev() {
            if S::from_f64(0.125_f64)
                .cmpge(((S::from_f64(i10 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64)))
            {
                break 'l7;
            }
        }
        let by11 = ((d - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        for v in r1.iter_mut() {
            *v = (*v * by11).sin();
        }
    }
    e + d + f + e + y + x
}

#[differentiable]
fn program_44(x: f64, y: f64) -> f64 {
    let mut a = ((y - -0.375_f64).tanh() * 0.75).sin();
    let mut r1 = [((y * 0.625_f64).max(0.375_f64) + 0.125).tanh(); 2];
    a *= ((-1.125_f64 * (a + -1.125_f64).sin()) + 0.125).tanh();
    let d = mixed(&r1[1..]).sin();
    a = ((d - 0.125_f64).tanh() + 0.125).tanh();
    let e = match roots((r1[0] * -0.875_f64).cos(), (a - y)) {
        Ok(v) => (d + 0.625_f64).sin(),
        Err(true) => -0.375_f64,
        Err(_) => y,
    };
    r1[0] += ((a * a + 0.25).sqrt() * 0.75).sin();
    let g2 = |t: f64| (-(t + r1[1])) * t;
    let e = (g2((d * 0.125_f64).max(d)) + g2((-0.375_f64 * 0.625_f64))).sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        r1[(n4 * n4 + 1) % 2] +=
            (((d * r1[(n4 * n4 + 1) % 2]) / (1.5 + -1.125_f64 * -1.125_f64)) + 0.125).tanh();
        let d = program_31(((x * -0.375_f64).max(y) * 0.75).sin(), (d + 0.125).tanh()).tanh();
    }
    let by5 = ((-(0.375_f64)) * 0.75).sin();
    let e = shifted(&mut r1[1..], by5);
    'l6: for i7 in (1..4_usize).step_by(2) {
        let g8 = |t: f64| r1[0] * t;
        let b = (g8((-(y))) + g8((a - -1.125_f64).tanh())).sin();
        let e = mixed(&r1[..1]).sin();
    }
    a = (((e + e) / (1.5 + (y * y + 0.25).sqrt() * (y * y + 0.25).sqrt())) * 0.75).sin();
    r1[1] + e + d + a + y + x
}

fn program_44_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 =
        [((y * S::from_f64(0.625_f64)).max(S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(); 2];
    a = a
        * ((S::from_f64(-1.125_f64) * (a + S::from_f64(-1.125_f64)).sin()) + S::from_f64(0.125))
            .tanh();
    let d = mixed(&r1[1..]).sin();
    a = ((d - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let e = match roots((r1[0] * S::from_f64(-0.875_f64)).cos(), (a - y)) {
        Ok(v) => (d + S::from_f64(0.625_f64)).sin(),
        Err(true) => S::from_f64(-0.375_f64),
        Err(_) => y,
    };
    r1[0] = r1[0] + ((a * a + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let g2 = |t: S| (-(t + r1[1])) * t;
    let e = (g2((d * S::from_f64(0.125_f64)).max(d))
        + g2((S::from_f64(-0.375_f64) * S::from_f64(0.625_f64))))
    .sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        r1[(n4 * n4 + 1) % 2] = r1[(n4 * n4 + 1) % 2]
            + (((d * r1[(n4 * n4 + 1) % 2])
                / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
                + S::from_f64(0.125))
            .tanh();
        let d = program_31_of(
            ((x * S::from_f64(-0.375_f64)).max(y) * S::from_f64(0.75)).sin(),
            (d + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    let by5 = ((-(S::from_f64(0.375_f64))) * S::from_f64(0.75)).sin();
    let e = shifted(&mut r1[1..], by5);
    'l6: for i7 in (1..4_usize).step_by(2) {
        let g8 = |t: S| r1[0] * t;
        let b = (g8((-(y))) + g8((a - S::from_f64(-1.125_f64)).tanh())).sin();
        let e = mixed(&r1[..1]).sin();
    }
    a = (((e + e)
        / (S::from_f64(1.5)
            + (y * y + S::from_f64(0.25)).sqrt() * (y * y + S::from_f64(0.25)).sqrt()))
        * S::from_f64(0.75))
    .sin();
    r1[1] + e + d + a + y + x
}

#[differentiable]
fn program_45(x: f64, y: f64) -> f64 {
    let mut e = ((x - 0.125_f64) * 0.75).sin();
    let mut r1 = [
        (x * 0.75).sin(),
        ((y * 0.875_f64) + 0.125).tanh(),
        ((y - -0.875_f64).tanh() * 0.75).sin(),
        ((e * -0.875_f64).max(y) + 0.125).tanh(),
        ((x + x) + 0.125).tanh(),
    ];
    'l2: for i3 in (0..4_usize).rev() {
        let z4;
        let mut n5 = 0_usize;
        loop {
            n5 += 1;
            let t = ((r1[(i3 * i3 + 1) % 5] * -0.125_f64).cos() * (r1[1] + r1[(i3 * i3 + 1) % 5]));
            if n5 > 2 || (r1[2] - x) <= (y / (1.5 + x * x)) {
                z4 = r1[(i3 + 0) % 5];
                break;
            }
        }
        r1[(i3 + 1) % 5] *= (((r1[i3 % 5] * r1[i3 % 5] + 0.25).sqrt() + (e * y)) + 0.125).tanh();
    }
    let g6 = |t: f64, v: &[f64]| {
        mixed(v) * t + ((0.625_f64 * 0.625_f64 + 0.25).sqrt() * (r1[1] * 0.375_f64).cos()).tanh()
    };
    let b = folded(&g6, ((y * x) + 0.125).tanh(), &r1).sin();
    let mut p7 =
        Pair { a: ((x * 0.375_f64).cos() * 0.75).sin(), b: ((r1[1] - r1[0]) + 0.125).tanh() };
    r1[1] *= (((b * 0.875_f64).cos() / (1.5 + (r1[1] + r1[4]) * (r1[1] + r1[4]))) * 0.75).sin();
    e -= (r1[2] + 0.125).tanh();
    p7.b = ((r1[1] - -1.125_f64).tanh() + 0.125).tanh();
    p7 = p7.tamed();
    e = (((y + r1[2]) * 0.875_f64).max(-0.875_f64) + 0.125).tanh();
    e += (((e * 0.125_f64).max(b) * (p7.a * e)) + 0.125).tanh();
    let mut e = ((e * r1[2]) + 0.125).tanh();
    #[differentiable(checkpoint)]
    'l8: for i9 in 2..1_usize {
        e += ((r1[(i9 + 1) % 5] + -0.125_f64).sin() + 0.125).tanh();
        let c = summed(bent, (x * 0.75).sin(), 3).tanh();
        let e = match roots((r1[(i9 + 0) % 5] * 0.875_f64), r1[(i9 + 4) % 5]) {
            Ok(v) => r1[(i9 + 3) % 5],
            Err(true) => ((i9 as f64) * 0.25),
            Err(_) => (r1[(i9 * i9 + 1) % 5] * -0.875_f64).max(p7.a),
        };
    }
    p7.a + e + b + y + x
}

fn program_45_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x - S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        (x * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh(),
        ((y - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((e * S::from_f64(-0.875_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ((x + x) + S::from_f64(0.125)).tanh(),
    ];
    'l2: for i3 in (0..4_usize).rev() {
        let z4;
        let mut n5 = 0_usize;
        loop {
            n5 += 1;
            let t = ((r1[(i3 * i3 + 1) % 5] * S::from_f64(-0.125_f64)).cos()
                * (r1[1] + r1[(i3 * i3 + 1) % 5]));
            if n5 > 2 || (r1[2] - x).cmple((y / (S::from_f64(1.5) + x * x))) {
                z4 = r1[(i3 + 0) % 5];
                break;
            }
        }
        r1[(i3 + 1) % 5] = r1[(i3 + 1) % 5]
            * (((r1[i3 % 5] * r1[i3 % 5] + S::from_f64(0.25)).sqrt() + (e * y))
                + S::from_f64(0.125))
            .tanh();
    }
    let g6 = |t: S, v: &[S]| {
        mixed(v) * t
            + ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt()
                * (r1[1] * S::from_f64(0.375_f64)).cos())
            .tanh()
    };
    let b = folded(&g6, ((y * x) + S::from_f64(0.125)).tanh(), &r1).sin();
    let mut p7 = Pair {
        a: ((x * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((r1[1] - r1[0]) + S::from_f64(0.125)).tanh(),
    };
    r1[1] = r1[1]
        * (((b * S::from_f64(0.875_f64)).cos()
            / (S::from_f64(1.5) + (r1[1] + r1[4]) * (r1[1] + r1[4])))
            * S::from_f64(0.75))
        .sin();
    e = e - (r1[2] + S::from_f64(0.125)).tanh();
    p7.b = ((r1[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    p7 = p7.tamed();
    e = (((y + r1[2]) * S::from_f64(0.875_f64)).max(S::from_f64(-0.875_f64)) + S::from_f64(0.125))
        .tanh();
    e = e + (((e * S::from_f64(0.125_f64)).max(b) * (p7.a * e)) + S::from_f64(0.125)).tanh();
    let mut e = ((e * r1[2]) + S::from_f64(0.125)).tanh();

    'l8: for i9 in 2..1_usize {
        e = e + ((r1[(i9 + 1) % 5] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh();
        let c = summed(bent, (x * S::from_f64(0.75)).sin(), 3).tanh();
        let e = match roots((r1[(i9 + 0) % 5] * S::from_f64(0.875_f64)), r1[(i9 + 4) % 5]) {
            Ok(v) => r1[(i9 + 3) % 5],
            Err(true) => (S::from_f64(i9 as f64) * S::from_f64(0.25)),
            Err(_) => (r1[(i9 * i9 + 1) % 5] * S::from_f64(-0.875_f64)).max(p7.a),
        };
    }
    p7.a + e + b + y + x
}

#[differentiable]
fn program_46(x: f64, y: f64) -> f64 {
    let mut a = ((x * -1.125_f64).cos() + 0.125).tanh();
    let r1 = [
        ((-0.125_f64 * a) * 0.75).sin(),
        ((y + x) * 0.75).sin(),
        (x * 0.75).sin(),
        ((y * 0.625_f64).abs() + 0.125).tanh(),
        ((x + a) + 0.125).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let mut p4 = Pair {
            a: ((0.625_f64 * y) + 0.125).tanh(),
            b: ((r1[3] * 0.375_f64).abs() + 0.125).tanh(),
        };
        let f = y;
    }
    let mut p5 =
        Pair { a: ((y * 0.625_f64).abs() * 0.75).sin(), b: ((r1[0] + r1[1]) * 0.75).sin() };
    let b = ((x * x + 0.25).sqrt() + (x + -0.625_f64).sin());
    let e = ((y * -0.125_f64).max(b) - (b * r1[4]));
    let f = program_27((y * 0.75).sin(), ((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin()).tanh();
    let b = if (f * f + 0.25).sqrt() >= r1[2] {
        ((-(p5.a)) * -1.125_f64).cos()
    } else {
        ((p5.a - r1[2]) + (b * 0.875_f64).cos())
    };
    let g6 = |t: f64| ((a + 0.375_f64).sin() / (1.5 + (a + r1[2]) * (a + r1[2]))) * t;
    let f = (g6((r1[0] * 0.875_f64).max(r1[3])) + g6((a - x))).sin();
    'l7: for i8 in 1..=3_usize {
        if (r1[i8 % 5] - ((i8 as f64) * 0.25)) <= (e * p5.a) {
            break 'l7;
        }
        a *= (((((i8 as f64) * 0.25) * r1[i8 % 5]) * (((i8 as f64) * 0.25) * r1[i8 % 5]) + 0.25)
            .sqrt()
            * 0.75)
            .sin();
        #[differentiable(checkpoint)]
        'l9: for i10 in 1..2_usize {
            let d = 0.875_f64;
            a -= (e + 0.125).tanh();
            a -= (((e * 0.375_f64).cos() - (p5.a * -0.875_f64).cos()) * 0.75).sin();
        }
    }
    ((-(b)) - -0.875_f64).tanh() + f + b + e + a + y + x
}

fn program_46_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh();
    let r1 = [
        ((S::from_f64(-0.125_f64) * a) * S::from_f64(0.75)).sin(),
        ((y + x) * S::from_f64(0.75)).sin(),
        (x * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((x + a) + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let mut p4 = Pair {
            a: ((S::from_f64(0.625_f64) * y) + S::from_f64(0.125)).tanh(),
            b: ((r1[3] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        };
        let f = y;
    }
    let mut p5 = Pair {
        a: ((y * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((r1[0] + r1[1]) * S::from_f64(0.75)).sin(),
    };
    let b = ((x * x + S::from_f64(0.25)).sqrt() + (x + S::from_f64(-0.625_f64)).sin());
    let e = ((y * S::from_f64(-0.125_f64)).max(b) - (b * r1[4]));
    let f = program_27_of(
        (y * S::from_f64(0.75)).sin(),
        ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let b = if (f * f + S::from_f64(0.25)).sqrt().cmpge(r1[2]) {
        ((-(p5.a)) * S::from_f64(-1.125_f64)).cos()
    } else {
        ((p5.a - r1[2]) + (b * S::from_f64(0.875_f64)).cos())
    };
    let g6 = |t: S| {
        ((a + S::from_f64(0.375_f64)).sin() / (S::from_f64(1.5) + (a + r1[2]) * (a + r1[2]))) * t
    };
    let f = (g6((r1[0] * S::from_f64(0.875_f64)).max(r1[3])) + g6((a - x))).sin();
    'l7: for i8 in 1..=3_usize {
        if (r1[i8 % 5] - (S::from_f64(i8 as f64) * S::from_f64(0.25))).cmple((e * p5.a)) {
            break 'l7;
        }
        a = a
            * ((((S::from_f64(i8 as f64) * S::from_f64(0.25)) * r1[i8 % 5])
                * ((S::from_f64(i8 as f64) * S::from_f64(0.25)) * r1[i8 % 5])
                + S::from_f64(0.25))
            .sqrt()
                * S::from_f64(0.75))
            .sin();

        'l9: for i10 in 1..2_usize {
            let d = S::from_f64(0.875_f64);
            a = a - (e + S::from_f64(0.125)).tanh();
            a = a
                - (((e * S::from_f64(0.375_f64)).cos() - (p5.a * S::from_f64(-0.875_f64)).cos())
                    * S::from_f64(0.75))
                .sin();
        }
    }
    ((-(b)) - S::from_f64(-0.875_f64)).tanh() + f + b + e + a + y + x
}

#[differentiable]
fn program_47(x: f64, y: f64) -> f64 {
    let mut c = ((-0.625_f64 + 0.375_f64) * 0.75).sin();
    let mut r1 = [((x * -0.125_f64).abs() + 0.125).tanh(), ((y + y) + 0.125).tanh()];
    let mut a = ((r1[0] * 0.375_f64).abs() + 0.125).tanh();
    r1[0] *= (((c * y) - (x * x)) + 0.125).tanh();
    let g2 = |t: f64| ((r1[0] * t) * (t + -0.875_f64).sin()) * t;
    let e = (g2((x * -0.875_f64).abs()) + g2((-0.375_f64 * 0.625_f64).max(r1[1]))).sin();
    let f = match shape(((-(e)) * 0.75).sin(), ((e * c) * 0.75).sin()) {
        Point => r1[1],
        Disc(v) => r1[1],
        Shape::Box { w: v, h } => ((r1[1] * r1[0]) - (v * v + 0.25).sqrt()),
    };
    let (a, mut b) = (((a * e) * 0.75).sin(), (r1[0] + 0.875_f64).sin());
    let b = summed(bent, ((r1[0] + -0.375_f64).sin() * 0.75).sin(), 3).tanh();
    'l3: for i4 in (1..5_usize).step_by(2) {
        if b < (y - f) {
            let mut r5 = [
                ((r1[i4 % 2] * r1[i4 % 2] + 0.25).sqrt() + 0.125).tanh(),
                ((r1[(i4 + 0) % 2] + -0.875_f64).sin() + 0.125).tanh(),
                ((r1[1] * a) * 0.75).sin(),
                ((x * 0.625_f64).cos() + 0.125).tanh(),
            ];
        }
        let g6 = |t: f64| e * t;
        let b = (g6((-(r1[1]))) + g6((e * e + 0.25).sqrt())).sin();
    }
    let (a, mut b) = ((b * 0.75).sin(), (r1[0] * 0.875_f64).abs());
    let mut u7 = r1.to_vec();
    u7.push((a + 0.125).tanh());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let b = (mixed(&u7) + u7[0]).tanh();
    let mut z8;
    if (e * -0.625_f64).abs() <= (f - -0.375_f64).tanh() {
        z8 = ((-0.125_f64 * 0.875_f64).cos() - y);
    } else {
        z8 = (e + b);
    }
    z8 = z8 * (e + b);
    let a = summed(
        |t: f64| (((c + 0.125_f64).sin() * -0.375_f64).cos() * t).sin(),
        (x * 0.75).sin(),
        1,
    )
    .tanh();
    ((r1[1] * 0.375_f64).abs() - 0.375_f64).tanh() + a + z8 + b + f + e + c + y + x
}

fn program_47_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((S::from_f64(-0.625_f64) + S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
    ];
    let mut a = ((r1[0] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    r1[0] = r1[0] * (((c * y) - (x * x)) + S::from_f64(0.125)).tanh();
    let g2 = |t: S| ((r1[0] * t) * (t + S::from_f64(-0.875_f64)).sin()) * t;
    let e = (g2((x * S::from_f64(-0.875_f64)).abs())
        + g2((S::from_f64(-0.375_f64) * S::from_f64(0.625_f64)).max(r1[1])))
    .sin();
    let f = match shape(((-(e)) * S::from_f64(0.75)).sin(), ((e * c) * S::from_f64(0.75)).sin()) {
        Point => r1[1],
        Disc(v) => r1[1],
        Shape::Box { w: v, h } => ((r1[1] * r1[0]) - (v * v + S::from_f64(0.25)).sqrt()),
    };
    let (a, mut b) = (((a * e) * S::from_f64(0.75)).sin(), (r1[0] + S::from_f64(0.875_f64)).sin());
    let b =
        summed(bent, ((r1[0] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(), 3).tanh();
    'l3: for i4 in (1..5_usize).step_by(2) {
        if b.cmplt((y - f)) {
            let mut r5 = [
                ((r1[i4 % 2] * r1[i4 % 2] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
                ((r1[(i4 + 0) % 2] + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
                ((r1[1] * a) * S::from_f64(0.75)).sin(),
                ((x * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
            ];
        }
        let g6 = |t: S| e * t;
        let b = (g6((-(r1[1]))) + g6((e * e + S::from_f64(0.25)).sqrt())).sin();
    }
    let (a, mut b) = ((b * S::from_f64(0.75)).sin(), (r1[0] * S::from_f64(0.875_f64)).abs());
    let mut u7 = r1.to_vec();
    u7.push((a + S::from_f64(0.125)).tanh());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let b = (mixed(&u7) + u7[0]).tanh();
    let mut z8;
    if (e * S::from_f64(-0.625_f64)).abs().cmple((f - S::from_f64(-0.375_f64)).tanh()) {
        z8 = ((S::from_f64(-0.125_f64) * S::from_f64(0.875_f64)).cos() - y);
    } else {
        z8 = (e + b);
    }
    z8 = z8 * (e + b);
    let a = summed(
        |t: S| (((c + S::from_f64(0.125_f64)).sin() * S::from_f64(-0.375_f64)).cos() * t).sin(),
        (x * S::from_f64(0.75)).sin(),
        1,
    )
    .tanh();
    ((r1[1] * S::from_f64(0.375_f64)).abs() - S::from_f64(0.375_f64)).tanh()
        + a
        + z8
        + b
        + f
        + e
        + c
        + y
        + x
}

#[differentiable]
fn program_48(x: f64, y: f64) -> f64 {
    let mut f = ((y * 0.375_f64).cos() * 0.75).sin();
    let r1 = [((-(x)) + 0.125).tanh(); 5];
    let a =
        program_11(((x + r1[0]) + 0.125).tanh(), ((r1[3] + -0.125_f64).sin() * 0.75).sin()).tanh();
    if (-(a)) < f {
        return y;
    }
    let a = summed(
        |t: f64| ((0.125_f64 + (x + -0.625_f64).sin()) * t).sin(),
        ((0.875_f64 * a) + 0.125).tanh(),
        2,
    )
    .tanh();
    'l2: for i3 in (2..5_usize).rev() {
        let z4;
        if (r1[3] * -1.125_f64).cos() > f {
            let t = y;
            z4 = ((a * -0.375_f64).max(y) * 0.375_f64).max(0.375_f64);
        } else if (r1[4] / (1.5 + r1[(i3 + 4) % 5] * r1[(i3 + 4) % 5])) > (a - a) {
            z4 = bent((r1[i3 % 5] * -1.125_f64).cos());
        } else {
            z4 = y;
        }
        if i3 % 3 == 1 {
            let f = mixed(&r1).sin();
            let b = mixed(&r1).sin();
        } else {
            let r5 = [((r1[(i3 * i3 + 1) % 5] * r1[(i3 + 1) % 5]) * 0.75).sin(); 5];
            if i3 % 4 == 2 {
                let a = match shape(
                    (f + 0.125).tanh(),
                    ((r5[(i3 * i3 + 1) % 5] * 0.125_f64).cos() + 0.125).tanh(),
                ) {
                    Shape::Point => (r5[0] - -0.875_f64),
                    Shape::Disc(v) => ((r1[(i3 + 4) % 5] + -0.125_f64).sin() + (f + x)),
                    Shape::Box { w: v, h } => ((z4 + x) * 0.625_f64).cos(),
                };
                let mut r6 = [(r1[(i3 + 0) % 5] * 0.75).sin(); 4];
                let mut f = ((x * y) + 0.125).tanh();
            } else {
                f *= (((r5[0] + f) * -0.625_f64).cos() + 0.125).tanh();
                let mut b = ((a * 0.375_f64).max(z4) * 0.75).sin();
            }
        }
    }
    y + a + f + y + x
}

fn program_48_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [((-(x)) + S::from_f64(0.125)).tanh(); 5];
    let a = program_11_of(
        ((x + r1[0]) + S::from_f64(0.125)).tanh(),
        ((r1[3] + S::from_f64(-0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    if (-(a)).cmplt(f) {
        return y;
    }
    let a = summed(
        |t: S| ((S::from_f64(0.125_f64) + (x + S::from_f64(-0.625_f64)).sin()) * t).sin(),
        ((S::from_f64(0.875_f64) * a) + S::from_f64(0.125)).tanh(),
        2,
    )
    .tanh();
    'l2: for i3 in (2..5_usize).rev() {
        let z4;
        if (r1[3] * S::from_f64(-1.125_f64)).cos().cmpgt(f) {
            let t = y;
            z4 = ((a * S::from_f64(-0.375_f64)).max(y) * S::from_f64(0.375_f64))
                .max(S::from_f64(0.375_f64));
        } else if (r1[4] / (S::from_f64(1.5) + r1[(i3 + 4) % 5] * r1[(i3 + 4) % 5])).cmpgt((a - a))
        {
            z4 = bent((r1[i3 % 5] * S::from_f64(-1.125_f64)).cos());
        } else {
            z4 = y;
        }
        if i3 % 3 == 1 {
            let f = mixed(&r1).sin();
            let b = mixed(&r1).sin();
        } else {
            let r5 = [((r1[(i3 * i3 + 1) % 5] * r1[(i3 + 1) % 5]) * S::from_f64(0.75)).sin(); 5];
            if i3 % 4 == 2 {
                let a = match shape(
                    (f + S::from_f64(0.125)).tanh(),
                    ((r5[(i3 * i3 + 1) % 5] * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125))
                        .tanh(),
                ) {
                    Shape::Point => (r5[0] - S::from_f64(-0.875_f64)),
                    Shape::Disc(v) => {
                        ((r1[(i3 + 4) % 5] + S::from_f64(-0.125_f64)).sin() + (f + x))
                    }
                    Shape::Box { w: v, h } => ((z4 + x) * S::from_f64(0.625_f64)).cos(),
                };
                let mut r6 = [(r1[(i3 + 0) % 5] * S::from_f64(0.75)).sin(); 4];
                let mut f = ((x * y) + S::from_f64(0.125)).tanh();
            } else {
                f = f * (((r5[0] + f) * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh();
                let mut b = ((a * S::from_f64(0.375_f64)).max(z4) * S::from_f64(0.75)).sin();
            }
        }
    }
    y + a + f + y + x
}

#[differentiable]
fn program_49(x: f64, y: f64) -> f64 {
    let mut b = ((x + x) + 0.125).tanh();
    let mut r1 = [((y * 0.375_f64).max(x) + 0.125).tanh(); 3];
    let e = summed(
        |t: f64| (((r1[1] + r1[2]) + 0.875_f64).sin() * t).sin(),
        ((x * 0.875_f64).max(-1.125_f64) + 0.125).tanh(),
        3,
    )
    .tanh();
    let c = ((b * 0.375_f64).max(r1[1]) * 0.375_f64).abs();
    'l2: for i3 in 1..2_usize {
        let f = match roots((r1[(i3 + 1) % 3] + c), (c * -0.875_f64).abs()) {
            Ok(v) => ((b / (1.5 + r1[i3 % 3] * r1[i3 % 3])) + 0.125_f64).sin(),
            Err(true) => r1[(i3 * i3 + 1) % 3],
            Err(_) => (((i3 as f64) * 0.25) * ((i3 as f64) * 0.25) + 0.25).sqrt(),
        };
        let b = if (y * c) <= (r1[0] * r1[(i3 * i3 + 1) % 3]) {
            r1[2]
        } else {
            ((y + -1.125_f64) + -0.375_f64).sin()
        };
        let mut p4 = Pair { a: ((c + -0.125_f64).sin() + 0.125).tanh(), b: (c + 0.125).tanh() };
    }
    'l5: for i6 in 1..5_usize {
        let z7;
        let mut n8 = 0_usize;
        loop {
            n8 += 1;
            let t = (-(-(b)));
            if n8 > 2 || (y + ((i6 as f64) * 0.25)) <= (-((i6 as f64) * 0.25)) {
                z7 = (-((b * b + 0.25).sqrt()));
                break;
            }
        }
        r1[(i6 + 2) % 3] = ((-(c)) * 0.75).sin();
    }
    let e = ((r1[2] * r1[2] + 0.25).sqrt() * -0.375_f64).max(e);
    'l9: for i10 in 0..1_usize {
        let by11 = ((r1[(i10 * i10 + 1) % 3] * r1[(i10 * i10 + 1) % 3] + 0.25).sqrt() * 0.75).sin();
        let a = shifted(&mut r1[1..], by11);
        if (b - -0.375_f64).tanh() > (-(-0.875_f64)) {
            break 'l9;
        }
        let mut d = ((r1[(i10 * i10 + 1) % 3] * 0.125_f64).cos() * 0.75).sin();
    }
    ((r1[0] * y) / (1.5 + (r1[2] - y) * (r1[2] - y))) + e + c + b + y + x
}

fn program_49_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x + x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y * S::from_f64(0.375_f64)).max(x) + S::from_f64(0.125)).tanh(); 3];
    let e = summed(
        |t: S| (((r1[1] + r1[2]) + S::from_f64(0.875_f64)).sin() * t).sin(),
        ((x * S::from_f64(0.875_f64)).max(S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
        3,
    )
    .tanh();
    let c = ((b * S::from_f64(0.375_f64)).max(r1[1]) * S::from_f64(0.375_f64)).abs();
    'l2: for i3 in 1..2_usize {
        let f = match roots((r1[(i3 + 1) % 3] + c), (c * S::from_f64(-0.875_f64)).abs()) {
            Ok(v) => {
                ((b / (S::from_f64(1.5) + r1[i3 % 3] * r1[i3 % 3])) + S::from_f64(0.125_f64)).sin()
            }
            Err(true) => r1[(i3 * i3 + 1) % 3],
            Err(_) => ((S::from_f64(i3 as f64) * S::from_f64(0.25))
                * (S::from_f64(i3 as f64) * S::from_f64(0.25))
                + S::from_f64(0.25))
            .sqrt(),
        };
        let b = if (y * c).cmple((r1[0] * r1[(i3 * i3 + 1) % 3])) {
            r1[2]
        } else {
            ((y + S::from_f64(-1.125_f64)) + S::from_f64(-0.375_f64)).sin()
        };
        let mut p4 = Pair {
            a: ((c + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
            b: (c + S::from_f64(0.125)).tanh(),
        };
    }
    'l5: for i6 in 1..5_usize {
        let z7;
        let mut n8 = 0_usize;
        loop {
            n8 += 1;
            let t = (-(-(b)));
            if n8 > 2
                || (y + (S::from_f64(i6 as f64) * S::from_f64(0.25)))
                    .cmple((-(S::from_f64(i6 as f64) * S::from_f64(0.25))))
            {
                z7 = (-((b * b + S::from_f64(0.25)).sqrt()));
                break;
            }
        }
        r1[(i6 + 2) % 3] = ((-(c)) * S::from_f64(0.75)).sin();
    }
    let e = ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() * S::from_f64(-0.375_f64)).max(e);
    'l9: for i10 in 0..1_usize {
        let by11 = ((r1[(i10 * i10 + 1) % 3] * r1[(i10 * i10 + 1) % 3] + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin();
        let a = shifted(&mut r1[1..], by11);
        if (b - S::from_f64(-0.375_f64)).tanh().cmpgt((-(S::from_f64(-0.875_f64)))) {
            break 'l9;
        }
        let mut d =
            ((r1[(i10 * i10 + 1) % 3] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin();
    }
    ((r1[0] * y) / (S::from_f64(1.5) + (r1[2] - y) * (r1[2] - y))) + e + c + b + y + x
}

#[differentiable]
fn program_50(x: f64, y: f64) -> f64 {
    let mut f = ((x + 0.125_f64).sin() * 0.75).sin();
    let r1 = [((x * f) * 0.75).sin(); 4];
    let c = -0.125_f64;
    let d = if (r1[0] / (1.5 + x * x)) > (r1[2] - f) {
        (-((x * x + 0.25).sqrt()))
    } else {
        ((r1[1] / (1.5 + r1[1] * r1[1])) * (r1[2] * f))
    };
    f = ((r1[3] * -0.875_f64).max(d) + 0.125).tanh();
    let b = mixed(&r1[3..]).sin();
    let g2 = |t: f64| ((r1[3] + c) * (r1[3] + c) + 0.25).sqrt() * t;
    let c = (g2((x * 0.125_f64)) + g2((y + d))).sin();
    let mut p3 = Pair { a: ((d - c) + 0.125).tanh(), b: ((x + y) * 0.75).sin() };
    let r4 = [((p3.b / (1.5 + x * x)) + 0.125).tanh(); 5];
    'l5: for i6 in (2..0_usize).rev() {
        'l7: for i8 in (i6..3_usize).rev() {
            if (r4[i6 % 5] + r4[(i8 + 2) % 5]) > (f + -0.625_f64).sin() {
                let b = ((((i6 as f64) * 0.25) + r4[0]) * (r4[(i8 * i8 + 1) % 5] * y));
                let b = ((r1[(i6 * i6 + 1) % 4] * f) * (r1[(i6 + 3) % 4] * r1[i6 % 4]));
                let f = match root((r1[(i6 + 3) % 4] + -1.125_f64).sin()) {
                    Some(v) => ((i6 as f64) * 0.25),
                    None => (y / (1.5 + p3.b * p3.b)),
                };
            } else {
                let mut d = ((((i8 as f64) * 0.25) / (1.5 + f * f)) * 0.75).sin();
            }
        }
        p3 =
            (p3 * Pair {
                a: ((((i6 as f64) * 0.25) * r1[(i6 * i6 + 1) % 4]) * 0.75).sin(),
                b: ((x * ((i6 as f64) * 0.25)) * 0.75).sin(),
            } + Pair {
                a: ((x - r4[(i6 + 1) % 5]) + 0.125).tanh(),
                b: ((((i6 as f64) * 0.25) * ((i6 as f64) * 0.25) + 0.25).sqrt() + 0.125).tanh(),
            })
            .tamed();
        p3 = p3.tamed();
        let mut a = ((b * 0.625_f64).abs() * 0.75).sin();
    }
    ((-(r1[2])) * r4[2]) + c + b + d + f + y + x
}

fn program_50_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let r1 = [((x * f) * S::from_f64(0.75)).sin(); 4];
    let c = S::from_f64(-0.125_f64);
    let d = if (r1[0] / (S::from_f64(1.5) + x * x)).cmpgt((r1[2] - f)) {
        (-((x * x + S::from_f64(0.25)).sqrt()))
    } else {
        ((r1[1] / (S::from_f64(1.5) + r1[1] * r1[1])) * (r1[2] * f))
    };
    f = ((r1[3] * S::from_f64(-0.875_f64)).max(d) + S::from_f64(0.125)).tanh();
    let b = mixed(&r1[3..]).sin();
    let g2 = |t: S| ((r1[3] + c) * (r1[3] + c) + S::from_f64(0.25)).sqrt() * t;
    let c = (g2((x * S::from_f64(0.125_f64))) + g2((y + d))).sin();
    let mut p3 =
        Pair { a: ((d - c) + S::from_f64(0.125)).tanh(), b: ((x + y) * S::from_f64(0.75)).sin() };
    let r4 = [((p3.b / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(); 5];
    'l5: for i6 in (2..0_usize).rev() {
        'l7: for i8 in (i6..3_usize).rev() {
            if (r4[i6 % 5] + r4[(i8 + 2) % 5]).cmpgt((f + S::from_f64(-0.625_f64)).sin()) {
                let b = (((S::from_f64(i6 as f64) * S::from_f64(0.25)) + r4[0])
                    * (r4[(i8 * i8 + 1) % 5] * y));
                let b = ((r1[(i6 * i6 + 1) % 4] * f) * (r1[(i6 + 3) % 4] * r1[i6 % 4]));
                let f = match root((r1[(i6 + 3) % 4] + S::from_f64(-1.125_f64)).sin()) {
                    Some(v) => (S::from_f64(i6 as f64) * S::from_f64(0.25)),
                    None => (y / (S::from_f64(1.5) + p3.b * p3.b)),
                };
            } else {
                let mut d = (((S::from_f64(i8 as f64) * S::from_f64(0.25))
                    / (S::from_f64(1.5) + f * f))
                    * S::from_f64(0.75))
                .sin();
            }
        }
        p3 =
            (p3 * Pair {
                a: (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[(i6 * i6 + 1) % 4])
                    * S::from_f64(0.75))
                .sin(),
                b: ((x * (S::from_f64(i6 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
            } + Pair {
                a: ((x - r4[(i6 + 1) % 5]) + S::from_f64(0.125)).tanh(),
                b: (((S::from_f64(i6 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i6 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh(),
            })
            .tamed();
        p3 = p3.tamed();
        let mut a = ((b * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
    }
    ((-(r1[2])) * r4[2]) + c + b + d + f + y + x
}

#[differentiable]
fn program_51(x: f64, y: f64) -> f64 {
    let mut b = ((0.875_f64 - 0.625_f64) + 0.125).tanh();
    let mut r1 = [
        (b + 0.125).tanh(),
        ((b * 0.625_f64).abs() + 0.125).tanh(),
        ((b / (1.5 + x * x)) * 0.75).sin(),
    ];
    'l2: for i3 in (0..3_usize).rev() {
        #[differentiable(checkpoint)]
        'l4: for i5 in (1..1_usize).rev() {
            r1[(i3 + 2) % 3] -= ((-((b + 0.625_f64).sin())) + 0.125).tanh();
            let mut p6 = Pair {
                a: ((r1[(i3 + 0) % 3] * -0.125_f64).abs() * 0.75).sin(),
                b: ((b * r1[(i3 + 2) % 3]) * 0.75).sin(),
            };
        }
        let mut p7 = Pair {
            a: ((-(-1.125_f64)) + 0.125).tanh(),
            b: ((r1[i3 % 3] * -0.375_f64).abs() * 0.75).sin(),
        };
    }
    b += (((b / (1.5 + r1[2] * r1[2])) - (y * y + 0.25).sqrt()) + 0.125).tanh();
    let mut p8 =
        Pair { a: ((r1[2] * 0.375_f64).abs() + 0.125).tanh(), b: ((y * r1[0]) + 0.125).tanh() };
    let mut n10 = 0_usize;
    'l9: while n10 < 1 {
        n10 += 1;
        let d = summed(
            |t: f64| {
                (((p8.a / (1.5 + b * b))
                    / (1.5 + (0.625_f64 + -0.875_f64) * (0.625_f64 + -0.875_f64)))
                    * t)
                    .sin()
            },
            (x + 0.125).tanh(),
            0,
        )
        .tanh();
    }
    let mut r11 = [
        ((b * 0.375_f64).max(y) + 0.125).tanh(),
        ((r1[1] - b) * 0.75).sin(),
        ((b + x) + 0.125).tanh(),
        ((-0.875_f64 * -1.125_f64).abs() * 0.75).sin(),
        ((b / (1.5 + -0.125_f64 * -0.125_f64)) * 0.75).sin(),
    ];
    r1[2] = (((b * 0.875_f64) / (1.5 + (r1[2] * y) * (r1[2] * y))) + 0.125).tanh();
    let mut z12;
    if (b - x) < x {
        let t = ((y * b) - (r1[1] - r11[2]));
        z12 = ((t * -0.125_f64).cos() + p8.a);
    } else if (y * -0.125_f64).max(p8.a) > (r1[0] * 0.625_f64) {
        z12 = bent((x * -0.125_f64));
    } else {
        z12 = ((y * b) - (r1[1] - r11[2]));
    }
    z12 = z12 * (x * -0.125_f64);
    let mut n14 = 0_usize;
    'l13: while n14 < 1 {
        n14 += 1;
        let d =
            summed(|t: f64| (r11[n14 % 5] * t).sin(), ((y + r1[n14 % 3]) + 0.125).tanh(), 0).tanh();
        let mut d = ((-(0.125_f64)) * 0.75).sin();
    }
    ((b * 0.625_f64).max(y) * 0.375_f64).cos() + z12 + b + y + x
}

fn program_51_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((S::from_f64(0.875_f64) - S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (b + S::from_f64(0.125)).tanh(),
        ((b * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((b / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in (0..3_usize).rev() {
        'l4: for i5 in (1..1_usize).rev() {
            r1[(i3 + 2) % 3] = r1[(i3 + 2) % 3]
                - ((-((b + S::from_f64(0.625_f64)).sin())) + S::from_f64(0.125)).tanh();
            let mut p6 = Pair {
                a: ((r1[(i3 + 0) % 3] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
                b: ((b * r1[(i3 + 2) % 3]) * S::from_f64(0.75)).sin(),
            };
        }
        let mut p7 = Pair {
            a: ((-(S::from_f64(-1.125_f64))) + S::from_f64(0.125)).tanh(),
            b: ((r1[i3 % 3] * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        };
    }
    b = b
        + (((b / (S::from_f64(1.5) + r1[2] * r1[2])) - (y * y + S::from_f64(0.25)).sqrt())
            + S::from_f64(0.125))
        .tanh();
    let mut p8 = Pair {
        a: ((r1[2] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: ((y * r1[0]) + S::from_f64(0.125)).tanh(),
    };
    let mut n10 = 0_usize;
    'l9: while n10 < 1 {
        n10 += 1;
        let d = summed(
            |t: S| {
                (((p8.a / (S::from_f64(1.5) + b * b))
                    / (S::from_f64(1.5)
                        + (S::from_f64(0.625_f64) + S::from_f64(-0.875_f64))
                            * (S::from_f64(0.625_f64) + S::from_f64(-0.875_f64))))
                    * t)
                    .sin()
            },
            (x + S::from_f64(0.125)).tanh(),
            0,
        )
        .tanh();
    }
    let mut r11 = [
        ((b * S::from_f64(0.375_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ((r1[1] - b) * S::from_f64(0.75)).sin(),
        ((b + x) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.875_f64) * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ((b / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
            * S::from_f64(0.75))
        .sin(),
    ];
    r1[2] = (((b * S::from_f64(0.875_f64)) / (S::from_f64(1.5) + (r1[2] * y) * (r1[2] * y)))
        + S::from_f64(0.125))
    .tanh();
    let mut z12;
    if (b - x).cmplt(x) {
        let t = ((y * b) - (r1[1] - r11[2]));
        z12 = ((t * S::from_f64(-0.125_f64)).cos() + p8.a);
    } else if (y * S::from_f64(-0.125_f64)).max(p8.a).cmpgt((r1[0] * S::from_f64(0.625_f64))) {
        z12 = bent((x * S::from_f64(-0.125_f64)));
    } else {
        z12 = ((y * b) - (r1[1] - r11[2]));
    }
    z12 = z12 * (x * S::from_f64(-0.125_f64));
    let mut n14 = 0_usize;
    'l13: while n14 < 1 {
        n14 += 1;
        let d = summed(
            |t: S| (r11[n14 % 5] * t).sin(),
            ((y + r1[n14 % 3]) + S::from_f64(0.125)).tanh(),
            0,
        )
        .tanh();
        let mut d = ((-(S::from_f64(0.125_f64))) * S::from_f64(0.75)).sin();
    }
    ((b * S::from_f64(0.625_f64)).max(y) * S::from_f64(0.375_f64)).cos() + z12 + b + y + x
}

#[differentiable]
fn program_52(x: f64, y: f64) -> f64 {
    let mut e = ((y * -0.625_f64).cos() * 0.75).sin();
    let mut r1 = [
        ((e + e) + 0.125).tanh(),
        ((x * 0.625_f64).max(e) + 0.125).tanh(),
        ((x * 0.875_f64).max(y) * 0.75).sin(),
        ((x * -0.875_f64) * 0.75).sin(),
    ];
    let mut r2 = [((y + r1[3]) + 0.125).tanh(); 4];
    r2[1] -= (((0.625_f64 * 0.125_f64).abs() * (e * 0.375_f64).cos()) + 0.125).tanh();
    let e = mixed(&r1[..1]).sin();
    r2[0] += (((y / (1.5 + r1[2] * r1[2])) * (x + y)) + 0.125).tanh();
    let c = match shape(((r1[2] * 0.875_f64).abs() + 0.125).tanh(), ((r2[2] + y) + 0.125).tanh()) {
        Point => (y + -0.125_f64).sin(),
        Disc(v) => ((x * -0.125_f64).max(0.875_f64) - (x - 0.375_f64).tanh()),
        Shape::Box { w: v, h } => (-(0.625_f64 * x)),
    };
    let mut f = ((-(y)) * 0.75).sin();
    'l3: for i4 in (0..0_usize).step_by(2) {
        'l5: for i6 in 2..0_usize {
            'l7: for i8 in 0..2_usize {
                r2[(i4 * i4 + 1) % 4] -= (((c - r2[2]) - (f * f)) * 0.75).sin();
            }
            'l9: for i10 in 1..3_usize {
                let mut p11 =
                    Pair { a: ((f * 0.875_f64).max(e) + 0.125).tanh(), b: (e + 0.125).tanh() };
            }
            let z12;
            if (c * r1[3]) >= (e * x) {
                z12 = ((x * -0.375_f64) * 0.125_f64).max(y);
            } else {
                z12 = (f * -0.625_f64).max(0.625_f64);
            }
        }
        let mut p13 =
            Pair { a: ((y - x) + 0.125).tanh(), b: ((r1[(i4 * i4 + 1) % 4] * e) + 0.125).tanh() };
        r2[(i4 + 3) % 4] = (p13.b * 0.75).sin();
    }
    ((e + x) + -0.125_f64).sin() + f + c + e + y + x
}

fn program_52_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((e + e) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.625_f64)).max(e) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.875_f64)).max(y) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
    ];
    let mut r2 = [((y + r1[3]) + S::from_f64(0.125)).tanh(); 4];
    r2[1] = r2[1]
        - (((S::from_f64(0.625_f64) * S::from_f64(0.125_f64)).abs()
            * (e * S::from_f64(0.375_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    let e = mixed(&r1[..1]).sin();
    r2[0] =
        r2[0] + (((y / (S::from_f64(1.5) + r1[2] * r1[2])) * (x + y)) + S::from_f64(0.125)).tanh();
    let c = match shape(
        ((r1[2] * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((r2[2] + y) + S::from_f64(0.125)).tanh(),
    ) {
        Point => (y + S::from_f64(-0.125_f64)).sin(),
        Disc(v) => {
            ((x * S::from_f64(-0.125_f64)).max(S::from_f64(0.875_f64))
                - (x - S::from_f64(0.375_f64)).tanh())
        }
        Shape::Box { w: v, h } => (-(S::from_f64(0.625_f64) * x)),
    };
    let mut f = ((-(y)) * S::from_f64(0.75)).sin();
    'l3: for i4 in (0..0_usize).step_by(2) {
        'l5: for i6 in 2..0_usize {
            'l7: for i8 in 0..2_usize {
                r2[(i4 * i4 + 1) % 4] =
                    r2[(i4 * i4 + 1) % 4] - (((c - r2[2]) - (f * f)) * S::from_f64(0.75)).sin();
            }
            'l9: for i10 in 1..3_usize {
                let mut p11 = Pair {
                    a: ((f * S::from_f64(0.875_f64)).max(e) + S::from_f64(0.125)).tanh(),
                    b: (e + S::from_f64(0.125)).tanh(),
                };
            }
            let z12;
            if (c * r1[3]).cmpge((e * x)) {
                z12 = ((x * S::from_f64(-0.375_f64)) * S::from_f64(0.125_f64)).max(y);
            } else {
                z12 = (f * S::from_f64(-0.625_f64)).max(S::from_f64(0.625_f64));
            }
        }
        let mut p13 = Pair {
            a: ((y - x) + S::from_f64(0.125)).tanh(),
            b: ((r1[(i4 * i4 + 1) % 4] * e) + S::from_f64(0.125)).tanh(),
        };
        r2[(i4 + 3) % 4] = (p13.b * S::from_f64(0.75)).sin();
    }
    ((e + x) + S::from_f64(-0.125_f64)).sin() + f + c + e + y + x
}

#[differentiable]
fn program_53(x: f64, y: f64) -> f64 {
    let mut a = ((x + y) * 0.75).sin();
    let mut r1 = [
        ((x / (1.5 + a * a)) * 0.75).sin(),
        ((y * y) + 0.125).tanh(),
        ((y + y) + 0.125).tanh(),
        ((a * -0.375_f64).cos() + 0.125).tanh(),
    ];
    let mut d = ((-0.875_f64 * r1[0]) * 0.75).sin();
    'l2: for i3 in 2..2_usize {
        let r4 = [
            (y + 0.125).tanh(),
            ((((i3 as f64) * 0.25) * -1.125_f64).max(r1[0]) * 0.75).sin(),
            (x * 0.75).sin(),
            ((((i3 as f64) * 0.25) + -0.625_f64).sin() * 0.75).sin(),
            ((r1[1] * r1[i3 % 4]) + 0.125).tanh(),
        ];
        let e = match roots((r1[i3 % 4] - 0.375_f64), (a * ((i3 as f64) * 0.25))) {
            Ok(v) => r4[i3 % 5],
            Err(true) => r4[(i3 * i3 + 1) % 5],
            Err(_) => y,
        };
        'l5: for i6 in (1..5_usize).rev() {
            r1[(i3 + 1) % 4] = ((r4[i3 % 5] * (e * x)) + 0.125).tanh();
            if (a * -0.125_f64).max(y) < (r4[i6 % 5] * 0.125_f64).abs() {
                continue 'l5;
            }
            let b = mixed(&r4).sin();
        }
    }
    let mut p7 = Pair { a: ((r1[3] * 0.375_f64) * 0.75).sin(), b: (d + 0.125).tanh() };
    let (a, mut b) = (((x * d) + 0.125).tanh(), (-(x)));
    let mut p8 = Pair { a: ((-(r1[2])) + 0.125).tanh(), b: ((a * r1[3]) + 0.125).tanh() };
    let mut r9 = [(a + 0.125).tanh(); 5];
    #[differentiable(checkpoint)]
    'l10: for i11 in (2..4_usize).step_by(2) {
        let a = mixed(&r1).sin();
        r9[4] *=
            (((((i11 as f64) * 0.25) / (1.5 + y * y)) + (b * -0.625_f64).abs()) + 0.125).tanh();
    }
    ((r1[0] * -0.375_f64).cos() * (r1[0] * -0.375_f64).cos() + 0.25).sqrt() + b + a + d + y + x
}

fn program_53_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin(),
        ((y * y) + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
        ((a * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut d = ((S::from_f64(-0.875_f64) * r1[0]) * S::from_f64(0.75)).sin();
    'l2: for i3 in 2..2_usize {
        let r4 = [
            (y + S::from_f64(0.125)).tanh(),
            (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)).max(r1[0])
                * S::from_f64(0.75))
            .sin(),
            (x * S::from_f64(0.75)).sin(),
            (((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(-0.625_f64)).sin()
                * S::from_f64(0.75))
            .sin(),
            ((r1[1] * r1[i3 % 4]) + S::from_f64(0.125)).tanh(),
        ];
        let e = match roots(
            (r1[i3 % 4] - S::from_f64(0.375_f64)),
            (a * (S::from_f64(i3 as f64) * S::from_f64(0.25))),
        ) {
            Ok(v) => r4[i3 % 5],
            Err(true) => r4[(i3 * i3 + 1) % 5],
            Err(_) => y,
        };
        'l5: for i6 in (1..5_usize).rev() {
            r1[(i3 + 1) % 4] = ((r4[i3 % 5] * (e * x)) + S::from_f64(0.125)).tanh();
            if (a * S::from_f64(-0.125_f64))
                .max(y)
                .cmplt((r4[i6 % 5] * S::from_f64(0.125_f64)).abs())
            {
                continue 'l5;
            }
            let b = mixed(&r4).sin();
        }
    }
    let mut p7 = Pair {
        a: ((r1[3] * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        b: (d + S::from_f64(0.125)).tanh(),
    };
    let (a, mut b) = (((x * d) + S::from_f64(0.125)).tanh(), (-(x)));
    let mut p8 = Pair {
        a: ((-(r1[2])) + S::from_f64(0.125)).tanh(),
        b: ((a * r1[3]) + S::from_f64(0.125)).tanh(),
    };
    let mut r9 = [(a + S::from_f64(0.125)).tanh(); 5];

    'l10: for i11 in (2..4_usize).step_by(2) {
        let a = mixed(&r1).sin();
        r9[4] = r9[4]
            * ((((S::from_f64(i11 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + y * y))
                + (b * S::from_f64(-0.625_f64)).abs())
                + S::from_f64(0.125))
            .tanh();
    }
    ((r1[0] * S::from_f64(-0.375_f64)).cos() * (r1[0] * S::from_f64(-0.375_f64)).cos()
        + S::from_f64(0.25))
    .sqrt()
        + b
        + a
        + d
        + y
        + x
}

#[differentiable]
fn program_54(x: f64, y: f64) -> f64 {
    let mut e = ((x * 0.875_f64).cos() * 0.75).sin();
    let r1 = [((-1.125_f64 + 0.875_f64).sin() + 0.125).tanh(); 4];
    let d = match roots(y, (r1[0] + r1[3])) {
        Ok(v) => (e * (-0.375_f64 * e)),
        Err(true) => x,
        Err(_) => (x + 0.125_f64).sin(),
    };
    let (a, mut b) = (((d * d + 0.25).sqrt() + 0.125).tanh(), (r1[2] * -0.125_f64).cos());
    e = (((b * b + 0.25).sqrt() - y) * 0.75).sin();
    e = (((y - b) - (r1[1] * -0.625_f64).abs()) * 0.75).sin();
    b -= ((r1[0] + (y + -1.125_f64).sin()) * 0.75).sin();
    'l2: for i3 in (2..3_usize).step_by(2) {
        let c: f64 = r1.iter().map(|v| v * (r1[i3 % 4] * 0.75).sin()).sum();
    }
    b -= (((r1[2] + -0.875_f64).sin() - (e / (1.5 + b * b))) * 0.75).sin();
    e = (((-(r1[1])) * (b + r1[2])) * 0.75).sin();
    let e = match shape(
        ((0.625_f64 * 0.875_f64).cos() + 0.125).tanh(),
        ((b / (1.5 + r1[3] * r1[3])) + 0.125).tanh(),
    ) {
        Point => (r1[3] * -0.125_f64).abs(),
        Disc(v) => ((r1[2] + -1.125_f64).sin() * -0.125_f64).cos(),
        Shape::Box { w: v, h } => {
            ((a / (1.5 + r1[0] * r1[0])) * (a / (1.5 + r1[0] * r1[0])) + 0.25).sqrt()
        }
    };
    let mut p4 = Pair { a: ((r1[0] + x) + 0.125).tanh(), b: ((d * a) + 0.125).tanh() };
    let z5;
    if (r1[2] * x) >= (y * y + 0.25).sqrt() {
        z5 = p4.b;
    } else {
        z5 = (e - p4.b);
    }
    let c = match shape(((b + r1[0]) * 0.75).sin(), ((b * e) * 0.75).sin()) {
        Point => (p4.a / (1.5 + r1[1] * r1[1])),
        Disc(v) => ((y * -0.625_f64).cos() - 0.125_f64).tanh(),
        Shape::Box { w: v, h } => ((p4.a * h) + r1[1]),
    };
    #[differentiable(checkpoint)]
    'l6: for i7 in (1..3_usize).step_by(2) {
        b = (((r1[i7 % 4] * p4.b) + r1[2]) * 0.75).sin();
    }
    (d * -0.875_f64).cos() + c + z5 + e + b + a + d + y + x
}

fn program_54_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 =
        [((S::from_f64(-1.125_f64) + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(); 4];
    let d = match roots(y, (r1[0] + r1[3])) {
        Ok(v) => (e * (S::from_f64(-0.375_f64) * e)),
        Err(true) => x,
        Err(_) => (x + S::from_f64(0.125_f64)).sin(),
    };
    let (a, mut b) = (
        ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        (r1[2] * S::from_f64(-0.125_f64)).cos(),
    );
    e = (((b * b + S::from_f64(0.25)).sqrt() - y) * S::from_f64(0.75)).sin();
    e = (((y - b) - (r1[1] * S::from_f64(-0.625_f64)).abs()) * S::from_f64(0.75)).sin();
    b = b - ((r1[0] + (y + S::from_f64(-1.125_f64)).sin()) * S::from_f64(0.75)).sin();
    'l2: for i3 in (2..3_usize).step_by(2) {
        let c = r1
            .iter()
            .fold(S::from_f64(-0.0), |s, v| s + *v * (r1[i3 % 4] * S::from_f64(0.75)).sin());
    }
    b = b
        - (((r1[2] + S::from_f64(-0.875_f64)).sin() - (e / (S::from_f64(1.5) + b * b)))
            * S::from_f64(0.75))
        .sin();
    e = (((-(r1[1])) * (b + r1[2])) * S::from_f64(0.75)).sin();
    let e = match shape(
        ((S::from_f64(0.625_f64) * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((b / (S::from_f64(1.5) + r1[3] * r1[3])) + S::from_f64(0.125)).tanh(),
    ) {
        Point => (r1[3] * S::from_f64(-0.125_f64)).abs(),
        Disc(v) => ((r1[2] + S::from_f64(-1.125_f64)).sin() * S::from_f64(-0.125_f64)).cos(),
        Shape::Box { w: v, h } => ((a / (S::from_f64(1.5) + r1[0] * r1[0]))
            * (a / (S::from_f64(1.5) + r1[0] * r1[0]))
            + S::from_f64(0.25))
        .sqrt(),
    };
    let mut p4 = Pair {
        a: ((r1[0] + x) + S::from_f64(0.125)).tanh(),
        b: ((d * a) + S::from_f64(0.125)).tanh(),
    };
    let z5;
    if (r1[2] * x).cmpge((y * y + S::from_f64(0.25)).sqrt()) {
        z5 = p4.b;
    } else {
        z5 = (e - p4.b);
    }
    let c =
        match shape(((b + r1[0]) * S::from_f64(0.75)).sin(), ((b * e) * S::from_f64(0.75)).sin()) {
            Point => (p4.a / (S::from_f64(1.5) + r1[1] * r1[1])),
            Disc(v) => ((y * S::from_f64(-0.625_f64)).cos() - S::from_f64(0.125_f64)).tanh(),
            Shape::Box { w: v, h } => ((p4.a * h) + r1[1]),
        };

    'l6: for i7 in (1..3_usize).step_by(2) {
        b = (((r1[i7 % 4] * p4.b) + r1[2]) * S::from_f64(0.75)).sin();
    }
    (d * S::from_f64(-0.875_f64)).cos() + c + z5 + e + b + a + d + y + x
}

#[differentiable]
fn program_55(x: f64, y: f64) -> f64 {
    let mut a = ((y + x) + 0.125).tanh();
    let mut r1 = [(y * 0.75).sin(); 5];
    r1[2] += (((r1[1] * x) * 0.125_f64).max(x) * 0.75).sin();
    a *= (((r1[3] * r1[3] + 0.25).sqrt() - 0.125_f64).tanh() * 0.75).sin();
    if y > (a * a + 0.25).sqrt() {
        return ((y + a) - 0.375_f64).tanh();
    }
    let a = if y >= (r1[1] + -0.125_f64).sin() {
        (a - (x + r1[1]))
    } else {
        ((x * -0.125_f64).max(r1[2]) * (x * -0.125_f64).max(r1[2]) + 0.25).sqrt()
    };
    r1[1] -= (((r1[1] * y) - (r1[4] + 0.125_f64).sin()) + 0.125).tanh();
    'l2: for i3 in 2..1_usize {
        let mut r4 = [((r1[2] - 0.375_f64).tanh() + 0.125).tanh(); 4];
        let mut n6 = 0_usize;
        'l5: while n6 < 5 {
            n6 += 1;
            let mut u7: Vec<_> = r1.iter().map(|v| *v * 0.125_f64).collect();
            u7.push(((a - ((n6 as f64) * 0.25)) + 0.125).tanh());
            u7[0] = u7[1] * u7[u7.len() - 1];
            let c = (mixed(&u7) + u7[0]).tanh();
            let mut p8 = Pair {
                a: ((c * r4[2]) * 0.75).sin(),
                b: ((r4[(n6 * n6 + 1) % 4] + c) * 0.75).sin(),
            };
            let a = summed(
                |t: f64| (((t * -0.125_f64).max(-0.375_f64) * 0.875_f64) * t).sin(),
                ((((i3 as f64) * 0.25) - -0.875_f64).tanh() * 0.75).sin(),
                2,
            )
            .tanh();
        }
        let a = summed(
            |t: f64| {
                (((-0.125_f64 / (1.5 + ((i3 as f64) * 0.25) * ((i3 as f64) * 0.25)))
                    * (0.375_f64 - 0.625_f64))
                    * t)
                    .sin()
            },
            ((a + -0.625_f64).sin() * 0.75).sin(),
            0,
        )
        .tanh();
    }
    let a = match roots((-(y)), (a + y)) {
        Ok(v) => r1[0],
        Err(true) => x,
        Err(_) => (a * a + 0.25).sqrt(),
    };
    let mut a = ((y + -1.125_f64).sin() * 0.75).sin();
    ((x * -0.625_f64).cos() * 0.375_f64).max(0.625_f64) + a + y + x
}

fn program_55_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y + x) + S::from_f64(0.125)).tanh();
    let mut r1 = [(y * S::from_f64(0.75)).sin(); 5];
    r1[2] = r1[2] + (((r1[1] * x) * S::from_f64(0.125_f64)).max(x) * S::from_f64(0.75)).sin();
    a = a
        * (((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() - S::from_f64(0.125_f64)).tanh()
            * S::from_f64(0.75))
        .sin();
    if y.cmpgt((a * a + S::from_f64(0.25)).sqrt()) {
        return ((y + a) - S::from_f64(0.375_f64)).tanh();
    }
    let a = if y.cmpge((r1[1] + S::from_f64(-0.125_f64)).sin()) {
        (a - (x + r1[1]))
    } else {
        ((x * S::from_f64(-0.125_f64)).max(r1[2]) * (x * S::from_f64(-0.125_f64)).max(r1[2])
            + S::from_f64(0.25))
        .sqrt()
    };
    r1[1] = r1[1]
        - (((r1[1] * y) - (r1[4] + S::from_f64(0.125_f64)).sin()) + S::from_f64(0.125)).tanh();
    'l2: for i3 in 2..1_usize {
        let mut r4 = [((r1[2] - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(); 4];
        let mut n6 = 0_usize;
        'l5: while n6 < 5 {
            n6 += 1;
            let mut u7: Vec<_> = r1.iter().map(|v| *v * S::from_f64(0.125_f64)).collect();
            u7.push(
                ((a - (S::from_f64(n6 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
            );
            u7[0] = u7[1] * u7[u7.len() - 1];
            let c = (mixed(&u7) + u7[0]).tanh();
            let mut p8 = Pair {
                a: ((c * r4[2]) * S::from_f64(0.75)).sin(),
                b: ((r4[(n6 * n6 + 1) % 4] + c) * S::from_f64(0.75)).sin(),
            };
            let a = summed(
                |t: S| {
                    (((t * S::from_f64(-0.125_f64)).max(S::from_f64(-0.375_f64))
                        * S::from_f64(0.875_f64))
                        * t)
                        .sin()
                },
                (((S::from_f64(i3 as f64) * S::from_f64(0.25)) - S::from_f64(-0.875_f64)).tanh()
                    * S::from_f64(0.75))
                .sin(),
                2,
            )
            .tanh();
        }
        let a = summed(
            |t: S| {
                (((S::from_f64(-0.125_f64)
                    / (S::from_f64(1.5)
                        + (S::from_f64(i3 as f64) * S::from_f64(0.25))
                            * (S::from_f64(i3 as f64) * S::from_f64(0.25))))
                    * (S::from_f64(0.375_f64) - S::from_f64(0.625_f64)))
                    * t)
                    .sin()
            },
            ((a + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
            0,
        )
        .tanh();
    }
    let a = match roots((-(y)), (a + y)) {
        Ok(v) => r1[0],
        Err(true) => x,
        Err(_) => (a * a + S::from_f64(0.25)).sqrt(),
    };
    let mut a = ((y + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin();
    ((x * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.375_f64)).max(S::from_f64(0.625_f64))
        + a
        + y
        + x
}

#[differentiable]
fn program_56(x: f64, y: f64) -> f64 {
    let mut c = ((y + 0.625_f64).sin() + 0.125).tanh();
    let mut r1 = [((y - c) * 0.75).sin(); 3];
    r1[2] -= (r1[1] * 0.75).sin();
    let z2;
    if (y * 0.625_f64) <= (0.125_f64 * r1[2]) {
        let t = ((r1[1] * r1[1]) * (-(r1[0])));
        z2 = ((r1[2] - -0.625_f64).tanh() - -0.625_f64).tanh();
    } else if (0.625_f64 - -1.125_f64).tanh() < (y + r1[1]) {
        z2 = bent((x - -0.375_f64).tanh());
    } else {
        z2 = ((r1[1] * r1[1]) * (-(r1[0])));
    }
    let a = program_20(
        ((r1[2] / (1.5 + c * c)) + 0.125).tanh(),
        ((r1[2] * 0.625_f64).cos() * 0.75).sin(),
    )
    .tanh();
    let mut p3 =
        Pair { a: ((a * 0.875_f64).cos() + 0.125).tanh(), b: ((a * a + 0.25).sqrt() * 0.75).sin() };
    c -= ((-((r1[1] * -0.625_f64).cos())) * 0.75).sin();
    r1[1] += (((p3.a * r1[1]) * (c * p3.a)) + 0.125).tanh();
    'l4: for i5 in 0..0_usize {
        let f = program_20(((-(r1[(i5 + 0) % 3])) * 0.75).sin(), ((r1[1] - a) * 0.75).sin()).tanh();
    }
    let mut d = ((a + 0.125_f64).sin() + 0.125).tanh();
    let c = if (y + 0.125_f64).sin() > (d * x) {
        ((p3.a - -0.125_f64).tanh() + (a * z2))
    } else {
        ((d * 0.375_f64).max(p3.a) + (r1[2] * y))
    };
    d -= (((-1.125_f64 * 0.375_f64).max(r1[1]) + -0.875_f64).sin() + 0.125).tanh();
    p3.b = ((a + r1[1]) + 0.125).tanh();
    p3 = p3.tamed();
    let (a, mut b) = (((y * y) + 0.125).tanh(), (x * -1.125_f64).abs());
    let mut r6 = [((d - -1.125_f64) + 0.125).tanh(); 3];
    ((p3.a * r6[2]) + 0.875_f64).sin() + b + a + c + d + z2 + y + x
}

fn program_56_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut r1 = [((y - c) * S::from_f64(0.75)).sin(); 3];
    r1[2] = r1[2] - (r1[1] * S::from_f64(0.75)).sin();
    let z2;
    if (y * S::from_f64(0.625_f64)).cmple((S::from_f64(0.125_f64) * r1[2])) {
        let t = ((r1[1] * r1[1]) * (-(r1[0])));
        z2 = ((r1[2] - S::from_f64(-0.625_f64)).tanh() - S::from_f64(-0.625_f64)).tanh();
    } else if (S::from_f64(0.625_f64) - S::from_f64(-1.125_f64)).tanh().cmplt((y + r1[1])) {
        z2 = bent((x - S::from_f64(-0.375_f64)).tanh());
    } else {
        z2 = ((r1[1] * r1[1]) * (-(r1[0])));
    }
    let a = program_20_of(
        ((r1[2] / (S::from_f64(1.5) + c * c)) + S::from_f64(0.125)).tanh(),
        ((r1[2] * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut p3 = Pair {
        a: ((a * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((a * a + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    };
    c = c - ((-((r1[1] * S::from_f64(-0.625_f64)).cos())) * S::from_f64(0.75)).sin();
    r1[1] = r1[1] + (((p3.a * r1[1]) * (c * p3.a)) + S::from_f64(0.125)).tanh();
    'l4: for i5 in 0..0_usize {
        let f = program_20_of(
            ((-(r1[(i5 + 0) % 3])) * S::from_f64(0.75)).sin(),
            ((r1[1] - a) * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    let mut d = ((a + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh();
    let c = if (y + S::from_f64(0.125_f64)).sin().cmpgt((d * x)) {
        ((p3.a - S::from_f64(-0.125_f64)).tanh() + (a * z2))
    } else {
        ((d * S::from_f64(0.375_f64)).max(p3.a) + (r1[2] * y))
    };
    d = d
        - (((S::from_f64(-1.125_f64) * S::from_f64(0.375_f64)).max(r1[1])
            + S::from_f64(-0.875_f64))
        .sin()
            + S::from_f64(0.125))
        .tanh();
    p3.b = ((a + r1[1]) + S::from_f64(0.125)).tanh();
    p3 = p3.tamed();
    let (a, mut b) = (((y * y) + S::from_f64(0.125)).tanh(), (x * S::from_f64(-1.125_f64)).abs());
    let mut r6 = [((d - S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(); 3];
    ((p3.a * r6[2]) + S::from_f64(0.875_f64)).sin() + b + a + c + d + z2 + y + x
}

#[differentiable]
fn program_57(x: f64, y: f64) -> f64 {
    let mut f = ((x + -1.125_f64) * 0.75).sin();
    let mut r1 = [((y + y) + 0.125).tanh(), ((x * 0.375_f64).cos() + 0.125).tanh()];
    if (f - r1[0]) > (r1[0] * 0.625_f64).max(r1[1]) {
        f += (((x / (1.5 + x * x)) * (x * f)) * 0.75).sin();
        let mut u2 = r1.to_vec();
        u2.push((y + 0.125).tanh());
        u2[0] = u2[1] * u2[u2.len() - 1];
        let f = (mixed(&u2) + u2[0]).tanh();
        let c = if (-(r1[1])) < (f / (1.5 + x * x)) {
            ((f * x) * -0.375_f64).max(y)
        } else {
            ((x * x + 0.25).sqrt() * (r1[1] * -0.125_f64).cos())
        };
    } else {
        #[differentiable(checkpoint)]
        'l3: for i4 in 2..0_usize {
            if (r1[(i4 * i4 + 1) % 2] / (1.5 + 0.625_f64 * 0.625_f64))
                <= (r1[i4 % 2] + -0.875_f64).sin()
            {
                break;
            }
            let mut n6 = 0_usize;
            'l5: while n6 < 4 {
                n6 += 1;
                let c = mixed(&r1).sin();
                let (a, mut b) = (((c * 0.125_f64).cos() * 0.75).sin(), (-(y)));
            }
            let c = root((r1[(i4 * i4 + 1) % 2] + -0.375_f64).sin())
                .map_or((x + -0.625_f64).sin(), |v| (-(-1.125_f64 - ((i4 as f64) * 0.25))));
        }
        let g7 = |t: f64| ((-(y)) * (-(y)) + 0.25).sqrt() * t;
        let d = (g7((y * y)) + g7((x + r1[0]))).sin();
    }
    let c = mixed(&r1[..2]).sin();
    let mut p8 = Pair { a: ((0.375_f64 + x) * 0.75).sin(), b: ((r1[1] + y) + 0.125).tanh() };
    let d = ((r1[0] * -0.625_f64).cos() * (x * 0.375_f64).max(r1[0]));
    ((x + c) * (f - x)) + d + c + f + y + x
}

fn program_57_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x + S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y + y) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    if (f - r1[0]).cmpgt((r1[0] * S::from_f64(0.625_f64)).max(r1[1])) {
        f = f + (((x / (S::from_f64(1.5) + x * x)) * (x * f)) * S::from_f64(0.75)).sin();
        let mut u2 = r1.to_vec();
        u2.push((y + S::from_f64(0.125)).tanh());
        u2[0] = u2[1] * u2[u2.len() - 1];
        let f = (mixed(&u2) + u2[0]).tanh();
        let c = if (-(r1[1])).cmplt((f / (S::from_f64(1.5) + x * x))) {
            ((f * x) * S::from_f64(-0.375_f64)).max(y)
        } else {
            ((x * x + S::from_f64(0.25)).sqrt() * (r1[1] * S::from_f64(-0.125_f64)).cos())
        };
    } else {
        'l3: for i4 in 2..0_usize {
            if (r1[(i4 * i4 + 1) % 2]
                / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
            .cmple((r1[i4 % 2] + S::from_f64(-0.875_f64)).sin())
            {
                break;
            }
            let mut n6 = 0_usize;
            'l5: while n6 < 4 {
                n6 += 1;
                let c = mixed(&r1).sin();
                let (a, mut b) =
                    (((c * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin(), (-(y)));
            }
            let c = root((r1[(i4 * i4 + 1) % 2] + S::from_f64(-0.375_f64)).sin())
                .map_or((x + S::from_f64(-0.625_f64)).sin(), |v| {
                    (-(S::from_f64(-1.125_f64) - (S::from_f64(i4 as f64) * S::from_f64(0.25))))
                });
        }
        let g7 = |t: S| ((-(y)) * (-(y)) + S::from_f64(0.25)).sqrt() * t;
        let d = (g7((y * y)) + g7((x + r1[0]))).sin();
    }
    let c = mixed(&r1[..2]).sin();
    let mut p8 = Pair {
        a: ((S::from_f64(0.375_f64) + x) * S::from_f64(0.75)).sin(),
        b: ((r1[1] + y) + S::from_f64(0.125)).tanh(),
    };
    let d = ((r1[0] * S::from_f64(-0.625_f64)).cos() * (x * S::from_f64(0.375_f64)).max(r1[0]));
    ((x + c) * (f - x)) + d + c + f + y + x
}

#[differentiable]
fn program_58(x: f64, y: f64) -> f64 {
    let mut b = ((-0.125_f64 + -0.125_f64).sin() * 0.75).sin();
    let mut r1 =
        [((y * y + 0.25).sqrt() * 0.75).sin(), ((-(x)) * 0.75).sin(), ((x * x) * 0.75).sin()];
    let mut p2 = Pair { a: ((-(x)) * 0.75).sin(), b: ((r1[1] - -0.375_f64).tanh() * 0.75).sin() };
    if (r1[0] - x) <= (y * -0.875_f64).max(0.375_f64) {
        return (r1[0] - (r1[2] * -0.375_f64).cos());
    }
    if (b * b + 0.25).sqrt() < r1[0] {
        return ((r1[2] + r1[2]) + p2.a);
    }
    let d = match roots((y / (1.5 + p2.a * p2.a)), (b + r1[2])) {
        Ok(v) => ((r1[0] + v) * (v - y)),
        Err(true) => r1[0],
        Err(_) => (x * -0.125_f64),
    };
    'l3: for i4 in 0..=2_usize {
        let mut u5 = r1.to_vec();
        u5.push((-0.375_f64 * 0.75).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let d = (mixed(&u5) + u5[0]).tanh();
        b *= (x + 0.125).tanh();
        b -= (((p2.a * p2.a + 0.25).sqrt() * -1.125_f64).max(r1[(i4 * i4 + 1) % 3]) * 0.75).sin();
    }
    r1[1] = (((b * -0.375_f64).abs() / (1.5 + x * x)) * 0.75).sin();
    let mut u6: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u6.push(((y * d) + 0.125).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let a = (mixed(&u6) + u6[0]).tanh();
    let a = summed(bent, ((y - -1.125_f64).tanh() + 0.125).tanh(), 3).tanh();
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let mut c = ((y + a) * 0.75).sin();
    let a = mixed(&r1[1..]).sin();
    (r1[2] + -0.625_f64).sin() + a + c + d + b + y + x
}

fn program_58_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b =
        ((S::from_f64(-0.125_f64) + S::from_f64(-0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((-(x)) * S::from_f64(0.75)).sin(),
        ((x * x) * S::from_f64(0.75)).sin(),
    ];
    let mut p2 = Pair {
        a: ((-(x)) * S::from_f64(0.75)).sin(),
        b: ((r1[1] - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
    };
    if (r1[0] - x).cmple((y * S::from_f64(-0.875_f64)).max(S::from_f64(0.375_f64))) {
        return (r1[0] - (r1[2] * S::from_f64(-0.375_f64)).cos());
    }
    if (b * b + S::from_f64(0.25)).sqrt().cmplt(r1[0]) {
        return ((r1[2] + r1[2]) + p2.a);
    }
    let d = match roots((y / (S::from_f64(1.5) + p2.a * p2.a)), (b + r1[2])) {
        Ok(v) => ((r1[0] + v) * (v - y)),
        Err(true) => r1[0],
        Err(_) => (x * S::from_f64(-0.125_f64)),
    };
    'l3: for i4 in 0..=2_usize {
        let mut u5 = r1.to_vec();
        u5.push((S::from_f64(-0.375_f64) * S::from_f64(0.75)).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let d = (mixed(&u5) + u5[0]).tanh();
        b = b * (x + S::from_f64(0.125)).tanh();
        b = b
            - (((p2.a * p2.a + S::from_f64(0.25)).sqrt() * S::from_f64(-1.125_f64))
                .max(r1[(i4 * i4 + 1) % 3])
                * S::from_f64(0.75))
            .sin();
    }
    r1[1] = (((b * S::from_f64(-0.375_f64)).abs() / (S::from_f64(1.5) + x * x))
        * S::from_f64(0.75))
    .sin();
    let mut u6: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u6.push(((y * d) + S::from_f64(0.125)).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let a = (mixed(&u6) + u6[0]).tanh();
    let a =
        summed(bent, ((y - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(), 3).tanh();
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let mut c = ((y + a) * S::from_f64(0.75)).sin();
    let a = mixed(&r1[1..]).sin();
    (r1[2] + S::from_f64(-0.625_f64)).sin() + a + c + d + b + y + x
}

#[differentiable]
fn program_59(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((-1.125_f64 * -1.125_f64 + 0.25).sqrt() + 0.125).tanh(); 5];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let mut p4 = Pair {
            a: ((y * y + 0.25).sqrt() + 0.125).tanh(),
            b: ((y + 0.875_f64).sin() * 0.75).sin(),
        };
        let d = program_19(
            ((-0.125_f64 + r1[n3 % 5]) + 0.125).tanh(),
            ((r1[n3 % 5] + 0.625_f64).sin() * 0.75).sin(),
        )
        .tanh();
        for v in r1.iter() {
            f = f * ((r1[(n3 + 1) % 5] * y) * 0.75).sin()
                + *v * ((r1[(n3 + 1) % 5] * y) * 0.75).sin();
        }
    }
    let z5;
    let mut n6 = 0_usize;
    loop {
        n6 += 1;
        let t = ((r1[3] * x) * r1[4]);
        if n6 > 2 || (r1[1] * -1.125_f64).cos() > r1[2] {
            z5 = ((f * -0.625_f64).cos() - (x + t));
            break;
        }
    }
    let mut r7 = [
        ((x * 0.625_f64).cos() + 0.125).tanh(),
        ((r1[0] - 0.625_f64) * 0.75).sin(),
        ((r1[1] + y) * 0.75).sin(),
    ];
    'l8: for i9 in (0..2_usize).step_by(2) {
        'l10: for i11 in (0..2_usize).step_by(2) {
            if (r1[i9 % 5] * r1[i9 % 5] + 0.25).sqrt() < (z5 * z5) {
                continue;
            }
            f = (((f * z5) + (z5 * 0.125_f64)) + 0.125).tanh();
            let f = match root((-0.125_f64 + z5)) {
                Some(v) => ((r7[2] + -0.875_f64).sin() * 0.125_f64).abs(),
                None => (r1[(i11 + 0) % 5] + ((i9 as f64) * 0.25)),
            };
        }
        if i9 % 4 == 0 {
            let mut d = ((x / (1.5 + r1[(i9 + 2) % 5] * r1[(i9 + 2) % 5])) + 0.125).tanh();
        } else {
            if i9 % 3 == 0 {
                f += (y * 0.75).sin();
                let e = program_39(
                    ((r7[0] + r7[(i9 * i9 + 1) % 3]) + 0.125).tanh(),
                    (-0.875_f64 * 0.75).sin(),
                )
                .tanh();
            }
            let g12 = |t: f64| ((y / (1.5 + f * f)) + -0.625_f64) * t;
            let e = (g12((r7[1] / (1.5 + r7[1] * r7[1]))) + g12((z5 * z5))).sin();
            'l13: for i14 in (1..1_usize).step_by(2) {
                let mut r15 = [(((i9 as f64) * 0.25) * 0.75).sin(); 2];
                let c = match roots((z5 + 0.375_f64).sin(), (0.125_f64 / (1.5 + x * x))) {
                    Ok(v) => ((x - f) * (x - f) + 0.25).sqrt(),
                    Err(true) => r15[i14 % 2],
                    Err(_) => (r1[i9 % 5] * -0.125_f64),
                };
                let mut p16 = Pair {
                    a: ((c * 0.125_f64).max(((i14 as f64) * 0.25)) * 0.75).sin(),
                    b: ((((i14 as f64) * 0.25) + r1[(i14 * i14 + 1) % 5]) * 0.75).sin(),
                };
            }
        }
    }
    ((f * 0.875_f64).max(r1[4]) * 0.375_f64).abs() + z5 + f + y + x
}

fn program_59_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.125))
    .tanh(); 5];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let mut p4 = Pair {
            a: ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            b: ((y + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
        };
        let d = program_19_of(
            ((S::from_f64(-0.125_f64) + r1[n3 % 5]) + S::from_f64(0.125)).tanh(),
            ((r1[n3 % 5] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        )
        .tanh();
        for v in r1.iter() {
            f = f * ((r1[(n3 + 1) % 5] * y) * S::from_f64(0.75)).sin()
                + *v * ((r1[(n3 + 1) % 5] * y) * S::from_f64(0.75)).sin();
        }
    }
    let z5;
    let mut n6 = 0_usize;
    loop {
        n6 += 1;
        let t = ((r1[3] * x) * r1[4]);
        if n6 > 2 || (r1[1] * S::from_f64(-1.125_f64)).cos().cmpgt(r1[2]) {
            z5 = ((f * S::from_f64(-0.625_f64)).cos() - (x + t));
            break;
        }
    }
    let mut r7 = [
        ((x * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((r1[0] - S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
        ((r1[1] + y) * S::from_f64(0.75)).sin(),
    ];
    'l8: for i9 in (0..2_usize).step_by(2) {
        'l10: for i11 in (0..2_usize).step_by(2) {
            if (r1[i9 % 5] * r1[i9 % 5] + S::from_f64(0.25)).sqrt().cmplt((z5 * z5)) {
                continue;
            }
            f = (((f * z5) + (z5 * S::from_f64(0.125_f64))) + S::from_f64(0.125)).tanh();
            let f = match root((S::from_f64(-0.125_f64) + z5)) {
                Some(v) => ((r7[2] + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.125_f64)).abs(),
                None => (r1[(i11 + 0) % 5] + (S::from_f64(i9 as f64) * S::from_f64(0.25))),
            };
        }
        if i9 % 4 == 0 {
            let mut d = ((x / (S::from_f64(1.5) + r1[(i9 + 2) % 5] * r1[(i9 + 2) % 5]))
                + S::from_f64(0.125))
            .tanh();
        } else {
            if i9 % 3 == 0 {
                f = f + (y * S::from_f64(0.75)).sin();
                let e = program_39_of(
                    ((r7[0] + r7[(i9 * i9 + 1) % 3]) + S::from_f64(0.125)).tanh(),
                    (S::from_f64(-0.875_f64) * S::from_f64(0.75)).sin(),
                )
                .tanh();
            }
            let g12 = |t: S| ((y / (S::from_f64(1.5) + f * f)) + S::from_f64(-0.625_f64)) * t;
            let e = (g12((r7[1] / (S::from_f64(1.5) + r7[1] * r7[1]))) + g12((z5 * z5))).sin();
            'l13: for i14 in (1..1_usize).step_by(2) {
                let mut r15 =
                    [((S::from_f64(i9 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin(); 2];
                let c = match roots(
                    (z5 + S::from_f64(0.375_f64)).sin(),
                    (S::from_f64(0.125_f64) / (S::from_f64(1.5) + x * x)),
                ) {
                    Ok(v) => ((x - f) * (x - f) + S::from_f64(0.25)).sqrt(),
                    Err(true) => r15[i14 % 2],
                    Err(_) => (r1[i9 % 5] * S::from_f64(-0.125_f64)),
                };
                let mut p16 = Pair {
                    a: ((c * S::from_f64(0.125_f64))
                        .max((S::from_f64(i14 as f64) * S::from_f64(0.25)))
                        * S::from_f64(0.75))
                    .sin(),
                    b: (((S::from_f64(i14 as f64) * S::from_f64(0.25)) + r1[(i14 * i14 + 1) % 5])
                        * S::from_f64(0.75))
                    .sin(),
                };
            }
        }
    }
    ((f * S::from_f64(0.875_f64)).max(r1[4]) * S::from_f64(0.375_f64)).abs() + z5 + f + y + x
}
