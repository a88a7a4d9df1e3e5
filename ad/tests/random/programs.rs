//! Random programs, written by `cargo run -p ad --example random_programs -- 8 60`.

use ad::{Real, differentiable};

use crate::program::{Program, program};
use crate::types::Shape::{Disc, Point};
use crate::types::{List, Pair, Shape, bent, folded, mixed, root, roots, shape, shifted, summed};

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
    let z2;
    if (r1[0] + -0.125_f64).sin() <= (d * r1[1]) {
        z2 = ((y + -0.375_f64).sin() - 0.625_f64).tanh();
    } else {
        z2 = (d * x);
    }
    let mut u3: Vec<_> = r1.iter().map(|v| *v * r1[2]).collect();
    u3.push((-0.375_f64 + 0.125).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let by4 = (r1[1] * 0.75).sin();
    for v in r1.iter_mut() {
        *v = (*v * by4).sin();
    }
    let mut p5 = Pair {
        a: ((z2 * 0.375_f64).cos() + 0.125).tanh(),
        b: ((y * -1.125_f64).abs() * 0.75).sin(),
    };
    let f = ((d + p5.a) * (y * -0.875_f64).cos());
    let g6 = |t: f64| x * t;
    let a = (g6(z2) + g6(y)).sin();
    let a = p5.dot(&p5).sin();
    let c = match root((r1[0] - r1[0])) {
        Some(v) => ((r1[0] * r1[0] + 0.25).sqrt() - 0.875_f64).tanh(),
        None => (f * -1.125_f64).cos(),
    };
    let a = root((c + -0.625_f64).sin())
        .map_or((p5.b / (1.5 + d * d)), |v| ((d - r1[2]) - (p5.a - r1[1])));
    let mut u7: Vec<_> = r1.iter().map(|v| *v * c).collect();
    u7.push(((a + x) * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    let mut f = ((r1[2] + r1[0]) * 0.75).sin();
    let (a, mut b) = (((a * a + 0.25).sqrt() * 0.75).sin(), (y + 0.875_f64).sin());
    let b = d;
    if (-(p5.a)) >= (-0.875_f64 + a) {
        r1[2] = (y * 0.75).sin();
        let mut z8;
        if (b * 0.375_f64).abs() > (d * z2) {
            let t = ((r1[2] * d) - (x * x + 0.25).sqrt());
            z8 = ((x * x) + 0.625_f64).sin();
        } else if (b - 0.375_f64).tanh() > (-1.125_f64 * -1.125_f64 + 0.25).sqrt() {
            z8 = bent((x * x));
        } else {
            z8 = ((r1[2] * d) - (x * x + 0.25).sqrt());
        }
        z8 = z8 * (x * x);
    }
    (x + (r1[2] * z2)) + b + a + f + d + c + z2 + y + x
}

fn program_0_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((-(x)) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(); 3];
    let z2;
    if (r1[0] + S::from_f64(-0.125_f64)).sin().cmple((d * r1[1])) {
        z2 = ((y + S::from_f64(-0.375_f64)).sin() - S::from_f64(0.625_f64)).tanh();
    } else {
        z2 = (d * x);
    }
    let mut u3: Vec<_> = r1.iter().map(|v| *v * r1[2]).collect();
    u3.push((S::from_f64(-0.375_f64) + S::from_f64(0.125)).tanh());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let d = (mixed(&u3) + u3[0]).tanh();
    let by4 = (r1[1] * S::from_f64(0.75)).sin();
    for v in r1.iter_mut() {
        *v = (*v * by4).sin();
    }
    let mut p5 = Pair {
        a: ((z2 * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((y * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    let f = ((d + p5.a) * (y * S::from_f64(-0.875_f64)).cos());
    let g6 = |t: S| x * t;
    let a = (g6(z2) + g6(y)).sin();
    let a = p5.dot(&p5).sin();
    let c = match root((r1[0] - r1[0])) {
        Some(v) => ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() - S::from_f64(0.875_f64)).tanh(),
        None => (f * S::from_f64(-1.125_f64)).cos(),
    };
    let a = root((c + S::from_f64(-0.625_f64)).sin())
        .map_or((p5.b / (S::from_f64(1.5) + d * d)), |v| ((d - r1[2]) - (p5.a - r1[1])));
    let mut u7: Vec<_> = r1.iter().map(|v| *v * c).collect();
    u7.push(((a + x) * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    let mut f = ((r1[2] + r1[0]) * S::from_f64(0.75)).sin();
    let (a, mut b) = (
        ((a * a + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (y + S::from_f64(0.875_f64)).sin(),
    );
    let b = d;
    if (-(p5.a)).cmpge((S::from_f64(-0.875_f64) + a)) {
        r1[2] = (y * S::from_f64(0.75)).sin();
        let mut z8;
        if (b * S::from_f64(0.375_f64)).abs().cmpgt((d * z2)) {
            let t = ((r1[2] * d) - (x * x + S::from_f64(0.25)).sqrt());
            z8 = ((x * x) + S::from_f64(0.625_f64)).sin();
        } else if (b - S::from_f64(0.375_f64))
            .tanh()
            .cmpgt((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt())
        {
            z8 = bent((x * x));
        } else {
            z8 = ((r1[2] * d) - (x * x + S::from_f64(0.25)).sqrt());
        }
        z8 = z8 * (x * x);
    }
    (x + (r1[2] * z2)) + b + a + f + d + c + z2 + y + x
}

#[differentiable]
fn program_1(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((-0.125_f64 + 0.125_f64).sin() * 0.75).sin(); 5];
    let mut r2 = [
        ((f * -0.625_f64).cos() * 0.75).sin(),
        ((-(-0.125_f64)) + 0.125).tanh(),
        ((-(0.625_f64)) * 0.75).sin(),
        ((-0.625_f64 - 0.875_f64).tanh() * 0.75).sin(),
    ];
    let z3;
    if (r2[0] * 0.875_f64).abs() <= (r2[3] / (1.5 + y * y)) {
        let t = ((x * 0.625_f64).max(x) + (y * x));
        z3 = (t * -0.375_f64).abs();
    } else if y < r1[3] {
        z3 = bent(y);
    } else {
        z3 = ((x * 0.625_f64).max(x) + (y * x));
    }
    let mut p4 =
        Pair { a: (0.625_f64 + 0.125).tanh(), b: ((r2[1] * r2[1] + 0.25).sqrt() * 0.75).sin() };
    for v in r1.iter().cycle().take(2) {
        f = (f + *v).sin();
    }
    let mut a = ((x * p4.b) + 0.125).tanh();
    a *= (((y + 0.625_f64) * 0.625_f64) + 0.125).tanh();
    f *= (((p4.a * 0.875_f64).abs() * (-0.875_f64 - 0.875_f64).tanh()) * 0.75).sin();
    'l5: for i6 in (2..5_usize).rev() {
        let (a, mut b) = (((p4.a * 0.625_f64).abs() + 0.125).tanh(), (z3 / (1.5 + z3 * z3)));
        let l7 =
            List(vec![((r2[0] + f) * 0.75).sin(), (p4.b + -0.125_f64).sin(), (y + 0.125).tanh()]);
        let m8 = &l7
            * &List(vec![
                ((r2[(i6 * i6 + 1) % 4] * a) * 0.75).sin(),
                (r2[3] * r2[3] + 0.25).sqrt(),
                ((r2[i6 % 4] / (1.5 + f * f)) * 0.75).sin(),
            ]);
        let c = ((-&m8 + l7).total()).tanh();
    }
    #[differentiable(checkpoint)]
    'l9: for i10 in (2..5_usize).rev() {
        let b = summed(
            |t: f64| (((i10 as f64) * 0.25) * t).sin(),
            ((r1[(i10 * i10 + 1) % 5] + r1[(i10 * i10 + 1) % 5]) * 0.75).sin(),
            0,
        )
        .tanh();
        'l11: for i12 in (i10..3_usize).step_by(2) {
            let a = List(vec![
                ((r1[i10 % 5] * -1.125_f64).cos() * 0.75).sin(),
                (0.125_f64 + r1[i10 % 5]),
                ((p4.b * -0.625_f64) * 0.75).sin(),
            ])
            .folded((b * 0.75).sin(), |s, v| (s * v + 0.625_f64).sin());
            if i10 % 3 == 1 {
                p4 = (Pair {
                    a: ((r2[(i12 * i12 + 1) % 4] * r2[(i12 * i12 + 1) % 4] + 0.25).sqrt() + 0.125)
                        .tanh(),
                    b: ((p4.a * -0.125_f64) + 0.125).tanh(),
                } - p4 * ((z3 * y) + 0.125).tanh())
                .tamed();
                p4 = p4.tamed();
                p4 += p4;
                p4 = p4.tamed();
                f = (((0.125_f64 / (1.5 + p4.a * p4.a))
                    / (1.5
                        + (((i12 as f64) * 0.25) * -0.125_f64).cos()
                            * (((i12 as f64) * 0.25) * -0.125_f64).cos()))
                    * 0.75)
                    .sin();
            }
            let d = if i10 % 4 == 3 { y } else { y };
        }
    }
    ((r2[1] + r2[0]) * r2[1]) + a + z3 + f + y + x
}

fn program_1_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 =
        [((S::from_f64(-0.125_f64) + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 5];
    let mut r2 = [
        ((f * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        ((-(S::from_f64(-0.125_f64))) + S::from_f64(0.125)).tanh(),
        ((-(S::from_f64(0.625_f64))) * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.625_f64) - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
    ];
    let z3;
    if (r2[0] * S::from_f64(0.875_f64)).abs().cmple((r2[3] / (S::from_f64(1.5) + y * y))) {
        let t = ((x * S::from_f64(0.625_f64)).max(x) + (y * x));
        z3 = (t * S::from_f64(-0.375_f64)).abs();
    } else if y.cmplt(r1[3]) {
        z3 = bent(y);
    } else {
        z3 = ((x * S::from_f64(0.625_f64)).max(x) + (y * x));
    }
    let mut p4 = Pair {
        a: (S::from_f64(0.625_f64) + S::from_f64(0.125)).tanh(),
        b: ((r2[1] * r2[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    };
    for v in r1.iter().cycle().take(2) {
        f = (f + *v).sin();
    }
    let mut a = ((x * p4.b) + S::from_f64(0.125)).tanh();
    a = a * (((y + S::from_f64(0.625_f64)) * S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh();
    f = f
        * (((p4.a * S::from_f64(0.875_f64)).abs()
            * (S::from_f64(-0.875_f64) - S::from_f64(0.875_f64)).tanh())
            * S::from_f64(0.75))
        .sin();
    'l5: for i6 in (2..5_usize).rev() {
        let (a, mut b) = (
            ((p4.a * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            (z3 / (S::from_f64(1.5) + z3 * z3)),
        );
        let l7 = List(vec![
            ((r2[0] + f) * S::from_f64(0.75)).sin(),
            (p4.b + S::from_f64(-0.125_f64)).sin(),
            (y + S::from_f64(0.125)).tanh(),
        ]);
        let m8 = &l7
            * &List(vec![
                ((r2[(i6 * i6 + 1) % 4] * a) * S::from_f64(0.75)).sin(),
                (r2[3] * r2[3] + S::from_f64(0.25)).sqrt(),
                ((r2[i6 % 4] / (S::from_f64(1.5) + f * f)) * S::from_f64(0.75)).sin(),
            ]);
        let c = ((-&m8 + l7).total()).tanh();
    }

    'l9: for i10 in (2..5_usize).rev() {
        let b = summed(
            |t: S| ((S::from_f64(i10 as f64) * S::from_f64(0.25)) * t).sin(),
            ((r1[(i10 * i10 + 1) % 5] + r1[(i10 * i10 + 1) % 5]) * S::from_f64(0.75)).sin(),
            0,
        )
        .tanh();
        'l11: for i12 in (i10..3_usize).step_by(2) {
            let a = List(vec![
                ((r1[i10 % 5] * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
                (S::from_f64(0.125_f64) + r1[i10 % 5]),
                ((p4.b * S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
            ])
            .folded((b * S::from_f64(0.75)).sin(), |s, v| (s * v + S::from_f64(0.625_f64)).sin());
            if i10 % 3 == 1 {
                p4 = (Pair {
                    a: ((r2[(i12 * i12 + 1) % 4] * r2[(i12 * i12 + 1) % 4] + S::from_f64(0.25))
                        .sqrt()
                        + S::from_f64(0.125))
                    .tanh(),
                    b: ((p4.a * S::from_f64(-0.125_f64)) + S::from_f64(0.125)).tanh(),
                } - p4 * ((z3 * y) + S::from_f64(0.125)).tanh())
                .tamed();
                p4 = p4.tamed();
                p4 += p4;
                p4 = p4.tamed();
                f = (((S::from_f64(0.125_f64) / (S::from_f64(1.5) + p4.a * p4.a))
                    / (S::from_f64(1.5)
                        + ((S::from_f64(i12 as f64) * S::from_f64(0.25))
                            * S::from_f64(-0.125_f64))
                        .cos()
                            * ((S::from_f64(i12 as f64) * S::from_f64(0.25))
                                * S::from_f64(-0.125_f64))
                            .cos()))
                    * S::from_f64(0.75))
                .sin();
            }
            let d = if i10 % 4 == 3 { y } else { y };
        }
    }
    ((r2[1] + r2[0]) * r2[1]) + a + z3 + f + y + x
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
    let mut r3 = [((d * r1[2]) * 0.75).sin(); 3];
    let c = mixed(&r3[0..]).sin();
    let k4 = (y / (1.5 + r3[0] * r3[0]));
    for part in r3.chunks_exact_mut(2) {
        part[0] = (part[0] * k4).sin();
        part.reverse();
    }
    'l5: for i6 in (1..5_usize).rev() {
        d = ((-((d - 0.875_f64).tanh())) * 0.75).sin();
        let b = mixed(&r3[..1]).sin();
        if (-(p2.b)) >= (r3[(i6 + 0) % 3] * -0.625_f64) {
            let e = program_0(
                ((x + -0.875_f64).sin() * 0.75).sin(),
                ((((i6 as f64) * 0.25) * -0.375_f64).abs() * 0.75).sin(),
            )
            .tanh();
            r3[(i6 + 1) % 3] =
                (((((i6 as f64) * 0.25) * -0.375_f64).abs() - (r3[i6 % 3] + p2.a)) + 0.125).tanh();
        }
    }
    if (c * -0.625_f64).abs() > (p2.a + d) {
        let f: f64 = r3.iter().map(|v| v * ((x - 0.625_f64).tanh() + 0.125).tanh()).sum();
        let (a, mut b) = ((r3[1] + 0.125).tanh(), (x + 0.875_f64).sin());
        let mut u7 = r1.to_vec();
        u7.push((a * 0.75).sin());
        u7[0] = u7[1] * u7[u7.len() - 1];
        let f = (mixed(&u7) + u7[0]).tanh();
    }
    ((-1.125_f64 / (1.5 + y * y)) * (d * d)) + c + d + y + x
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
    let mut r3 = [((d * r1[2]) * S::from_f64(0.75)).sin(); 3];
    let c = mixed(&r3[0..]).sin();
    let k4 = (y / (S::from_f64(1.5) + r3[0] * r3[0]));
    for part in r3.chunks_exact_mut(2) {
        part[0] = (part[0] * k4).sin();
        part.reverse();
    }
    'l5: for i6 in (1..5_usize).rev() {
        d = ((-((d - S::from_f64(0.875_f64)).tanh())) * S::from_f64(0.75)).sin();
        let b = mixed(&r3[..1]).sin();
        if (-(p2.b)).cmpge((r3[(i6 + 0) % 3] * S::from_f64(-0.625_f64))) {
            let e = program_0_of(
                ((x + S::from_f64(-0.875_f64)).sin() * S::from_f64(0.75)).sin(),
                (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64)).abs()
                    * S::from_f64(0.75))
                .sin(),
            )
            .tanh();
            r3[(i6 + 1) % 3] =
                ((((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64)).abs()
                    - (r3[i6 % 3] + p2.a))
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    if (c * S::from_f64(-0.625_f64)).abs().cmpgt((p2.a + d)) {
        let f = r3.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh()
        });
        let (a, mut b) = ((r3[1] + S::from_f64(0.125)).tanh(), (x + S::from_f64(0.875_f64)).sin());
        let mut u7 = r1.to_vec();
        u7.push((a * S::from_f64(0.75)).sin());
        u7[0] = u7[1] * u7[u7.len() - 1];
        let f = (mixed(&u7) + u7[0]).tanh();
    }
    ((S::from_f64(-1.125_f64) / (S::from_f64(1.5) + y * y)) * (d * d)) + c + d + y + x
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
    f = (((r1[1] * r1[1]) * (r1[1] * r1[1]) + 0.25).sqrt() + 0.125).tanh();
    let g4 = |t: f64| d * t;
    let c = (g4((r1[1] + r1[0])) + g4((r1[0] + r1[1]))).sin();
    if (-(r1[0])) <= (r1[0] / (1.5 + x * x)) {
        let d = root((0.625_f64 - -0.625_f64).tanh()).map_or((0.125_f64 + r1[0]), |v| {
            ((r1[0] / (1.5 + f * f)) * (p3.b * p3.b + 0.25).sqrt())
        });
        let b = if (x * -0.625_f64).abs() < (r1[0] * y) { f } else { ((-(f)) + (-(d))) };
        let e = match roots((-0.625_f64 * p3.a), (-(c))) {
            Ok(v) => ((r1[1] * c) + 0.625_f64).sin(),
            Err(true) => 0.375_f64,
            Err(_) => (r1[1] + d),
        };
    } else {
        let e = if (f - c) < (x + 0.375_f64).sin() {
            ((-0.875_f64 * c) / (1.5 + (-(x)) * (-(x))))
        } else {
            ((p3.b - y) + 0.625_f64).sin()
        };
    }
    'l5: for i6 in (0..3_usize).rev() {
        let k7 = (r1[(i6 * i6 + 1) % 2] * r1[(i6 + 1) % 2]);
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k7).sin();
            part.reverse();
        }
    }
    let e = summed(bent, ((r1[1] * y) * 0.75).sin(), 3).tanh();
    f = (((f * f) * (0.875_f64 * -0.875_f64).abs()) + 0.125).tanh();
    let mut c = ((r1[0] + -1.125_f64) + 0.125).tanh();
    ((r1[1] * -1.125_f64).cos() + -0.625_f64).sin() + c + e + d + f + y + x
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
    f = (((r1[1] * r1[1]) * (r1[1] * r1[1]) + S::from_f64(0.25)).sqrt() + S::from_f64(0.125))
        .tanh();
    let g4 = |t: S| d * t;
    let c = (g4((r1[1] + r1[0])) + g4((r1[0] + r1[1]))).sin();
    if (-(r1[0])).cmple((r1[0] / (S::from_f64(1.5) + x * x))) {
        let d = root((S::from_f64(0.625_f64) - S::from_f64(-0.625_f64)).tanh())
            .map_or((S::from_f64(0.125_f64) + r1[0]), |v| {
                ((r1[0] / (S::from_f64(1.5) + f * f)) * (p3.b * p3.b + S::from_f64(0.25)).sqrt())
            });
        let b = if (x * S::from_f64(-0.625_f64)).abs().cmplt((r1[0] * y)) {
            f
        } else {
            ((-(f)) + (-(d)))
        };
        let e = match roots((S::from_f64(-0.625_f64) * p3.a), (-(c))) {
            Ok(v) => ((r1[1] * c) + S::from_f64(0.625_f64)).sin(),
            Err(true) => S::from_f64(0.375_f64),
            Err(_) => (r1[1] + d),
        };
    } else {
        let e = if (f - c).cmplt((x + S::from_f64(0.375_f64)).sin()) {
            ((S::from_f64(-0.875_f64) * c) / (S::from_f64(1.5) + (-(x)) * (-(x))))
        } else {
            ((p3.b - y) + S::from_f64(0.625_f64)).sin()
        };
    }
    'l5: for i6 in (0..3_usize).rev() {
        let k7 = (r1[(i6 * i6 + 1) % 2] * r1[(i6 + 1) % 2]);
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k7).sin();
            part.reverse();
        }
    }
    let e = summed(bent, ((r1[1] * y) * S::from_f64(0.75)).sin(), 3).tanh();
    f = (((f * f) * (S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)).abs()) + S::from_f64(0.125))
        .tanh();
    let mut c = ((r1[0] + S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh();
    ((r1[1] * S::from_f64(-1.125_f64)).cos() + S::from_f64(-0.625_f64)).sin()
        + c
        + e
        + d
        + f
        + y
        + x
}

#[differentiable]
fn program_4(x: f64, y: f64) -> f64 {
    let mut c = ((x * -0.625_f64).max(y) + 0.125).tanh();
    let mut r1 = [((x * y) * 0.75).sin(); 4];
    let mut p2 = Pair { a: ((c + -0.875_f64) + 0.125).tanh(), b: ((-(c)) + 0.125).tanh() };
    if (r1[1] - 0.625_f64).tanh() < (r1[1] + p2.b) {
        return ((y * y + 0.25).sqrt() * 0.375_f64).max(r1[0]);
    }
    if c <= (c * c + 0.25).sqrt() {
        return (x * -0.375_f64).max(r1[2]);
    }
    let b = ((r1[1] * r1[1] + 0.25).sqrt() - (-(x)));
    let a = root((x / (1.5 + c * c))).map_or(r1[1], |v| 0.375_f64);
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        'l5: for i6 in (1..3_usize).step_by(2) {
            p2 += Pair {
                a: ((r1[(n4 + 3) % 4] / (1.5 + r1[0] * r1[0])) + 0.125).tanh(),
                b: ((r1[(i6 * i6 + 1) % 4] * -0.375_f64).max(b) + 0.125).tanh(),
            };
            p2 = p2.tamed();
        }
        let a = match roots((y - c), r1[(n4 + 2) % 4]) {
            Ok(v) => ((a + x) * (r1[n4 % 4] * 0.375_f64).cos()),
            Err(true) => y,
            Err(_) => (r1[n4 % 4] * r1[n4 % 4] + 0.25).sqrt(),
        };
        let c = mixed(&r1[0..]).sin();
    }
    let mut f = ((p2.b + b) * 0.75).sin();
    let e = if (c / (1.5 + r1[3] * r1[3])) <= (y * 0.375_f64).max(p2.a) {
        (-(r1[2] + f))
    } else {
        (c + -0.375_f64).sin()
    };
    let g7 = |t: f64, v: &[f64]| mixed(v) * t + (p2.b).tanh();
    let b = folded(&g7, (r1[0] + 0.125).tanh(), &r1).sin();
    p2 += p2;
    p2 = p2.tamed();
    ((e * 0.125_f64).max(p2.a) * (e * 0.125_f64).max(p2.a) + 0.25).sqrt()
        + b
        + e
        + f
        + a
        + c
        + y
        + x
}

fn program_4_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * y) * S::from_f64(0.75)).sin(); 4];
    let mut p2 = Pair {
        a: ((c + S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
        b: ((-(c)) + S::from_f64(0.125)).tanh(),
    };
    if (r1[1] - S::from_f64(0.625_f64)).tanh().cmplt((r1[1] + p2.b)) {
        return ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.375_f64)).max(r1[0]);
    }
    if c.cmple((c * c + S::from_f64(0.25)).sqrt()) {
        return (x * S::from_f64(-0.375_f64)).max(r1[2]);
    }
    let b = ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() - (-(x)));
    let a = root((x / (S::from_f64(1.5) + c * c))).map_or(r1[1], |v| S::from_f64(0.375_f64));
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        'l5: for i6 in (1..3_usize).step_by(2) {
            p2 += Pair {
                a: ((r1[(n4 + 3) % 4] / (S::from_f64(1.5) + r1[0] * r1[0])) + S::from_f64(0.125))
                    .tanh(),
                b: ((r1[(i6 * i6 + 1) % 4] * S::from_f64(-0.375_f64)).max(b) + S::from_f64(0.125))
                    .tanh(),
            };
            p2 = p2.tamed();
        }
        let a = match roots((y - c), r1[(n4 + 2) % 4]) {
            Ok(v) => ((a + x) * (r1[n4 % 4] * S::from_f64(0.375_f64)).cos()),
            Err(true) => y,
            Err(_) => (r1[n4 % 4] * r1[n4 % 4] + S::from_f64(0.25)).sqrt(),
        };
        let c = mixed(&r1[0..]).sin();
    }
    let mut f = ((p2.b + b) * S::from_f64(0.75)).sin();
    let e =
        if (c / (S::from_f64(1.5) + r1[3] * r1[3])).cmple((y * S::from_f64(0.375_f64)).max(p2.a)) {
            (-(r1[2] + f))
        } else {
            (c + S::from_f64(-0.375_f64)).sin()
        };
    let g7 = |t: S, v: &[S]| mixed(v) * t + (p2.b).tanh();
    let b = folded(&g7, (r1[0] + S::from_f64(0.125)).tanh(), &r1).sin();
    p2 += p2;
    p2 = p2.tamed();
    ((e * S::from_f64(0.125_f64)).max(p2.a) * (e * S::from_f64(0.125_f64)).max(p2.a)
        + S::from_f64(0.25))
    .sqrt()
        + b
        + e
        + f
        + a
        + c
        + y
        + x
}

#[differentiable]
fn program_5(x: f64, y: f64) -> f64 {
    let mut e = ((-1.125_f64 * y) + 0.125).tanh();
    let mut r1 = [(e * 0.75).sin(); 2];
    let mut p2 = Pair {
        a: ((r1[1] * 0.375_f64).max(e) + 0.125).tanh(),
        b: ((r1[0] + -0.375_f64).sin() * 0.75).sin(),
    };
    let f: f64 = r1.iter().map(|v| v * (-0.875_f64 + 0.125).tanh()).sum();
    let f =
        program_4(((y / (1.5 + x * x)) + 0.125).tanh(), ((e / (1.5 + x * x)) * 0.75).sin()).tanh();
    if (x * 0.875_f64).cos() > (f * r1[0]) {
        return ((-(p2.b)) - (-0.625_f64 * 0.875_f64).abs());
    }
    for v in r1.iter() {
        e = e * ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh()
            + *v * ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh();
    }
    let mut u3 = r1.to_vec();
    u3.push(((e - 0.125_f64).tanh() * 0.75).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let b = (mixed(&u3) + u3[0]).tanh();
    r1[1] -= (r1[0] + 0.125).tanh();
    e -= (((r1[0] * -0.625_f64).abs() * (r1[0] * -0.625_f64).abs() + 0.25).sqrt() + 0.125).tanh();
    let by4 = ((x * 0.625_f64).max(b) + 0.125).tanh();
    let b = shifted(&mut r1[0..], by4);
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        for v in r1.iter().cycle().take(3) {
            e = (e + *v).sin();
        }
        let mut r7 = [((r1[n6 % 2] * ((n6 as f64) * 0.25)) + 0.125).tanh(), (b + 0.125).tanh()];
        let c = if let Some(v) = root((y * r1[(n6 * n6 + 1) % 2])) {
            (0.625_f64 * (f * f + 0.25).sqrt())
        } else {
            (f + e)
        };
    }
    let d = mixed(&r1).sin();
    ((r1[0] + p2.b) * (p2.b + f)) + d + b + f + e + y + x
}

fn program_5_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((S::from_f64(-1.125_f64) * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [(e * S::from_f64(0.75)).sin(); 2];
    let mut p2 = Pair {
        a: ((r1[1] * S::from_f64(0.375_f64)).max(e) + S::from_f64(0.125)).tanh(),
        b: ((r1[0] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * (S::from_f64(-0.875_f64) + S::from_f64(0.125)).tanh()
    });
    let f = program_4_of(
        ((y / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        ((e / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    if (x * S::from_f64(0.875_f64)).cos().cmpgt((f * r1[0])) {
        return ((-(p2.b)) - (S::from_f64(-0.625_f64) * S::from_f64(0.875_f64)).abs());
    }
    for v in r1.iter() {
        e = e * ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh()
            + *v * ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    }
    let mut u3 = r1.to_vec();
    u3.push(((e - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin());
    u3[0] = u3[1] * u3[u3.len() - 1];
    let b = (mixed(&u3) + u3[0]).tanh();
    r1[1] = r1[1] - (r1[0] + S::from_f64(0.125)).tanh();
    e = e
        - (((r1[0] * S::from_f64(-0.625_f64)).abs() * (r1[0] * S::from_f64(-0.625_f64)).abs()
            + S::from_f64(0.25))
        .sqrt()
            + S::from_f64(0.125))
        .tanh();
    let by4 = ((x * S::from_f64(0.625_f64)).max(b) + S::from_f64(0.125)).tanh();
    let b = shifted(&mut r1[0..], by4);
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        for v in r1.iter().cycle().take(3) {
            e = (e + *v).sin();
        }
        let mut r7 = [
            ((r1[n6 % 2] * (S::from_f64(n6 as f64) * S::from_f64(0.25))) + S::from_f64(0.125))
                .tanh(),
            (b + S::from_f64(0.125)).tanh(),
        ];
        let c = if let Some(v) = root((y * r1[(n6 * n6 + 1) % 2])) {
            (S::from_f64(0.625_f64) * (f * f + S::from_f64(0.25)).sqrt())
        } else {
            (f + e)
        };
    }
    let d = mixed(&r1).sin();
    ((r1[0] + p2.b) * (p2.b + f)) + d + b + f + e + y + x
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
    'l2: for i3 in (0..0_usize).step_by(2) {
        for v in r1.iter() {
            c = c * ((x * -0.625_f64).max(y) + 0.125).tanh()
                + *v * ((x * -0.625_f64).max(y) + 0.125).tanh();
        }
        if i3 % 4 == 3 {
            let mut f = (r1[(i3 + 4) % 5] * 0.75).sin();
            let mut r4 = [
                (((i3 as f64) * 0.25) + 0.125).tanh(),
                ((-(x)) * 0.75).sin(),
                (0.875_f64 * 0.75).sin(),
                ((f * -0.375_f64).abs() * 0.75).sin(),
            ];
            let f = if (r1[i3 % 5] - c) < (r1[(i3 + 0) % 5] * r4[0]) {
                (c * -1.125_f64).cos()
            } else {
                (-((f * f + 0.25).sqrt()))
            };
        }
    }
    'l5: for i6 in (0..3_usize).rev() {
        let mut p7 =
            Pair { a: ((-(y)) * 0.75).sin(), b: ((y * ((i6 as f64) * 0.25)) + 0.125).tanh() };
        let g8 = |t: f64| {
            ((r1[(i6 * i6 + 1) % 5] * r1[(i6 * i6 + 1) % 5] + 0.25).sqrt()
                - (r1[1] + -0.625_f64).sin())
                * t
        };
        let a = (g8((y - 0.375_f64).tanh())
            + g8((((i6 as f64) * 0.25) * ((i6 as f64) * 0.25) + 0.25).sqrt()))
        .sin();
    }
    if (r1[4] - r1[3]) >= y {
        let mut w9 = (((0.375_f64 * y) + 0.125).tanh(), [(c * -1.125_f64).abs(); 2]);
        {
            let (p, [q, _]) = &mut w9;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w9.0 + w9.1[0] * w9.1[1]).tanh();
        let c =
            if let Some(v) = root(c) { ((r1[0] - a) + -1.125_f64).sin() } else { (a * -0.625_f64) };
    }
    c = (((x + -0.375_f64) * -0.875_f64).cos() + 0.125).tanh();
    let (a, mut b) = ((c + 0.125).tanh(), (r1[0] * r1[0] + 0.25).sqrt());
    ((a * a) - -0.125_f64).tanh() + b + a + c + y + x
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
    'l2: for i3 in (0..0_usize).step_by(2) {
        for v in r1.iter() {
            c = c * ((x * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh()
                + *v * ((x * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh();
        }
        if i3 % 4 == 3 {
            let mut f = (r1[(i3 + 4) % 5] * S::from_f64(0.75)).sin();
            let mut r4 = [
                ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh(),
                ((-(x)) * S::from_f64(0.75)).sin(),
                (S::from_f64(0.875_f64) * S::from_f64(0.75)).sin(),
                ((f * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
            ];
            let f = if (r1[i3 % 5] - c).cmplt((r1[(i3 + 0) % 5] * r4[0])) {
                (c * S::from_f64(-1.125_f64)).cos()
            } else {
                (-((f * f + S::from_f64(0.25)).sqrt()))
            };
        }
    }
    'l5: for i6 in (0..3_usize).rev() {
        let mut p7 = Pair {
            a: ((-(y)) * S::from_f64(0.75)).sin(),
            b: ((y * (S::from_f64(i6 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
        };
        let g8 = |t: S| {
            ((r1[(i6 * i6 + 1) % 5] * r1[(i6 * i6 + 1) % 5] + S::from_f64(0.25)).sqrt()
                - (r1[1] + S::from_f64(-0.625_f64)).sin())
                * t
        };
        let a = (g8((y - S::from_f64(0.375_f64)).tanh())
            + g8(((S::from_f64(i6 as f64) * S::from_f64(0.25))
                * (S::from_f64(i6 as f64) * S::from_f64(0.25))
                + S::from_f64(0.25))
            .sqrt()))
        .sin();
    }
    if (r1[4] - r1[3]).cmpge(y) {
        let mut w9 = (
            ((S::from_f64(0.375_f64) * y) + S::from_f64(0.125)).tanh(),
            [(c * S::from_f64(-1.125_f64)).abs(); 2],
        );
        {
            let (p, [q, _]) = &mut w9;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w9.0 + w9.1[0] * w9.1[1]).tanh();
        let c = if let Some(v) = root(c) {
            ((r1[0] - a) + S::from_f64(-1.125_f64)).sin()
        } else {
            (a * S::from_f64(-0.625_f64))
        };
    }
    c = (((x + S::from_f64(-0.375_f64)) * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125))
        .tanh();
    let (a, mut b) = ((c + S::from_f64(0.125)).tanh(), (r1[0] * r1[0] + S::from_f64(0.25)).sqrt());
    ((a * a) - S::from_f64(-0.125_f64)).tanh() + b + a + c + y + x
}

#[differentiable]
fn program_7(x: f64, y: f64) -> f64 {
    let mut e = ((y * x) * 0.75).sin();
    let r1 = [((x + 0.125_f64).sin() * 0.75).sin(); 3];
    let z2;
    if (x * -0.375_f64).max(x) < (0.375_f64 * x) {
        let t = ((x * 0.125_f64) * (r1[1] * 0.125_f64).abs());
        z2 = ((y * x) * (y * x) + 0.25).sqrt();
    } else if (e * 0.375_f64).abs() >= (-0.875_f64 + x) {
        z2 = bent((x * 0.875_f64));
    } else {
        z2 = ((x * 0.125_f64) * (r1[1] * 0.125_f64).abs());
    }
    if (-0.375_f64 + e) > (r1[0] - e) {
        let mut p3 = Pair { a: (x * 0.75).sin(), b: ((r1[2] * e) * 0.75).sin() };
        p3 = (p3 + p3) * ((y / (1.5 + z2 * z2)) * 0.75).sin();
        p3 = p3.tamed();
        p3.turn((r1[1] * 0.75).sin());
        p3 = p3.tamed();
    } else {
        let l4 = List(vec![
            ((-(e)) * 0.75).sin(),
            (z2 * 0.375_f64).abs(),
            ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh(),
        ]);
        let m5 = &l4 * &List(vec![((r1[0] - y) + 0.125).tanh(), y, ((-(z2)) + 0.125).tanh()]);
        let a = ((&(&l4 * &m5) * &m5).total() * l4.total()).tanh();
        e -= (r1[0] + 0.125).tanh();
        'l6: for i7 in (2..2_usize).rev() {
            let mut u8: Vec<_> = r1.iter().map(|v| *v * e).collect();
            u8.push(((r1[0] * -0.125_f64).cos() * 0.75).sin());
            u8[0] = u8[1] * u8[u8.len() - 1];
            let e = (mixed(&u8) + u8[0]).tanh();
        }
    }
    let r9 = [((e + y) + 0.125).tanh(); 4];
    let r10 = [((x + r9[2]) + 0.125).tanh(), (r9[1] * 0.75).sin()];
    e *= (((z2 + -0.375_f64) + (r10[0] + e)) + 0.125).tanh();
    #[differentiable(checkpoint)]
    'l11: for i12 in (2..1_usize).step_by(2) {
        let g13 = |t: f64| ((e * 0.125_f64).abs() + (z2 - 0.125_f64).tanh()) * t;
        let a = (g13((((i12 as f64) * 0.25) + e)) + g13((e * r10[1]))).sin();
        let g14 = |t: f64| ((y * -0.875_f64).max(((i12 as f64) * 0.25)) * -0.125_f64).abs() * t;
        let a = (g14((y - r9[(i12 * i12 + 1) % 4])) + g14((e + r10[(i12 * i12 + 1) % 2]))).sin();
    }
    ((r1[0] * y) * (-(-0.375_f64))) + z2 + e + y + x
}

fn program_7_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * x) * S::from_f64(0.75)).sin();
    let r1 = [((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 3];
    let z2;
    if (x * S::from_f64(-0.375_f64)).max(x).cmplt((S::from_f64(0.375_f64) * x)) {
        let t = ((x * S::from_f64(0.125_f64)) * (r1[1] * S::from_f64(0.125_f64)).abs());
        z2 = ((y * x) * (y * x) + S::from_f64(0.25)).sqrt();
    } else if (e * S::from_f64(0.375_f64)).abs().cmpge((S::from_f64(-0.875_f64) + x)) {
        z2 = bent((x * S::from_f64(0.875_f64)));
    } else {
        z2 = ((x * S::from_f64(0.125_f64)) * (r1[1] * S::from_f64(0.125_f64)).abs());
    }
    if (S::from_f64(-0.375_f64) + e).cmpgt((r1[0] - e)) {
        let mut p3 =
            Pair { a: (x * S::from_f64(0.75)).sin(), b: ((r1[2] * e) * S::from_f64(0.75)).sin() };
        p3 = (p3 + p3) * ((y / (S::from_f64(1.5) + z2 * z2)) * S::from_f64(0.75)).sin();
        p3 = p3.tamed();
        p3.turn((r1[1] * S::from_f64(0.75)).sin());
        p3 = p3.tamed();
    } else {
        let l4 = List(vec![
            ((-(e)) * S::from_f64(0.75)).sin(),
            (z2 * S::from_f64(0.375_f64)).abs(),
            ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ]);
        let m5 = &l4
            * &List(vec![
                ((r1[0] - y) + S::from_f64(0.125)).tanh(),
                y,
                ((-(z2)) + S::from_f64(0.125)).tanh(),
            ]);
        let a = ((&(&l4 * &m5) * &m5).total() * l4.total()).tanh();
        e = e - (r1[0] + S::from_f64(0.125)).tanh();
        'l6: for i7 in (2..2_usize).rev() {
            let mut u8: Vec<_> = r1.iter().map(|v| *v * e).collect();
            u8.push(((r1[0] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin());
            u8[0] = u8[1] * u8[u8.len() - 1];
            let e = (mixed(&u8) + u8[0]).tanh();
        }
    }
    let r9 = [((e + y) + S::from_f64(0.125)).tanh(); 4];
    let r10 = [((x + r9[2]) + S::from_f64(0.125)).tanh(), (r9[1] * S::from_f64(0.75)).sin()];
    e = e * (((z2 + S::from_f64(-0.375_f64)) + (r10[0] + e)) + S::from_f64(0.125)).tanh();

    'l11: for i12 in (2..1_usize).step_by(2) {
        let g13 =
            |t: S| ((e * S::from_f64(0.125_f64)).abs() + (z2 - S::from_f64(0.125_f64)).tanh()) * t;
        let a =
            (g13(((S::from_f64(i12 as f64) * S::from_f64(0.25)) + e)) + g13((e * r10[1]))).sin();
        let g14 = |t: S| {
            ((y * S::from_f64(-0.875_f64)).max((S::from_f64(i12 as f64) * S::from_f64(0.25)))
                * S::from_f64(-0.125_f64))
            .abs()
                * t
        };
        let a = (g14((y - r9[(i12 * i12 + 1) % 4])) + g14((e + r10[(i12 * i12 + 1) % 2]))).sin();
    }
    ((r1[0] * y) * (-(S::from_f64(-0.375_f64)))) + z2 + e + y + x
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
    for v in r1.iter().cycle().take(8) {
        a = (a + *v).sin();
    }
    let mut p2 = Pair {
        a: ((x * 0.375_f64).abs() + 0.125).tanh(),
        b: ((0.125_f64 * -0.625_f64).max(x) * 0.75).sin(),
    };
    if (r1[2] * a) >= r1[3] {
        let mut w3 = ((r1[1] + 0.125).tanh(), [0.625_f64; 2]);
        {
            let (ref mut p, [ref mut q, _]) = w3;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let e = (w3.0 + w3.1[0] * w3.1[1]).tanh();
        if (e * a) <= (e * r1[1]) {
            return ((e * r1[1]) + (e - p2.a));
        }
    }
    let g4 = |t: f64| r1[4] * t;
    let f = (g4((r1[2] * 0.875_f64).abs()) + g4((a * r1[3]))).sin();
    a -= (((y * 0.875_f64).max(0.875_f64) + (-(a))) + 0.125).tanh();
    a *= (((r1[3] * y) * (r1[0] * 0.125_f64).max(r1[2])) + 0.125).tanh();
    let c = List(vec![
        ((f * -1.125_f64).max(y) * 0.75).sin(),
        (r1[1] - -1.125_f64).tanh(),
        (p2.b * 0.75).sin(),
    ])
    .folded(((r1[4] + x) + 0.125).tanh(), |s, v| (s * v + (p2.a + r1[4])).sin());
    let mut r5 = [((r1[1] * 0.875_f64).max(x) + 0.125).tanh(); 4];
    r5[0] += (((a / (1.5 + r1[3] * r1[3])) + (x * 0.125_f64).max(f)) + 0.125).tanh();
    p2 = -(Pair { a: (a + 0.125).tanh(), b: ((a + f) * 0.75).sin() }
        - Pair {
            a: ((f / (1.5 + y * y)) + 0.125).tanh(),
            b: ((y / (1.5 + p2.b * p2.b)) * 0.75).sin(),
        })
    .tamed();
    p2 = p2.tamed();
    let mut c = ((-(p2.b)) + 0.125).tanh();
    'l6: for i7 in (2..3_usize).rev() {
        let a = ((r5[(i7 + 2) % 4] * r1[(i7 * i7 + 1) % 5]) * (r1[(i7 * i7 + 1) % 5] + r1[1]));
    }
    p2.b + c + f + a + y + x
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
    for v in r1.iter().cycle().take(8) {
        a = (a + *v).sin();
    }
    let mut p2 = Pair {
        a: ((x * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: ((S::from_f64(0.125_f64) * S::from_f64(-0.625_f64)).max(x) * S::from_f64(0.75)).sin(),
    };
    if (r1[2] * a).cmpge(r1[3]) {
        let mut w3 = ((r1[1] + S::from_f64(0.125)).tanh(), [S::from_f64(0.625_f64); 2]);
        {
            let (ref mut p, [ref mut q, _]) = w3;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let e = (w3.0 + w3.1[0] * w3.1[1]).tanh();
        if (e * a).cmple((e * r1[1])) {
            return ((e * r1[1]) + (e - p2.a));
        }
    }
    let g4 = |t: S| r1[4] * t;
    let f = (g4((r1[2] * S::from_f64(0.875_f64)).abs()) + g4((a * r1[3]))).sin();
    a = a
        - (((y * S::from_f64(0.875_f64)).max(S::from_f64(0.875_f64)) + (-(a)))
            + S::from_f64(0.125))
        .tanh();
    a = a
        * (((r1[3] * y) * (r1[0] * S::from_f64(0.125_f64)).max(r1[2])) + S::from_f64(0.125)).tanh();
    let c = List(vec![
        ((f * S::from_f64(-1.125_f64)).max(y) * S::from_f64(0.75)).sin(),
        (r1[1] - S::from_f64(-1.125_f64)).tanh(),
        (p2.b * S::from_f64(0.75)).sin(),
    ])
    .folded(((r1[4] + x) + S::from_f64(0.125)).tanh(), |s, v| (s * v + (p2.a + r1[4])).sin());
    let mut r5 = [((r1[1] * S::from_f64(0.875_f64)).max(x) + S::from_f64(0.125)).tanh(); 4];
    r5[0] = r5[0]
        + (((a / (S::from_f64(1.5) + r1[3] * r1[3])) + (x * S::from_f64(0.125_f64)).max(f))
            + S::from_f64(0.125))
        .tanh();
    p2 = -(Pair { a: (a + S::from_f64(0.125)).tanh(), b: ((a + f) * S::from_f64(0.75)).sin() }
        - Pair {
            a: ((f / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
            b: ((y / (S::from_f64(1.5) + p2.b * p2.b)) * S::from_f64(0.75)).sin(),
        })
    .tamed();
    p2 = p2.tamed();
    let mut c = ((-(p2.b)) + S::from_f64(0.125)).tanh();
    'l6: for i7 in (2..3_usize).rev() {
        let a = ((r5[(i7 + 2) % 4] * r1[(i7 * i7 + 1) % 5]) * (r1[(i7 * i7 + 1) % 5] + r1[1]));
    }
    p2.b + c + f + a + y + x
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
    if (x - 0.375_f64).tanh() < (0.625_f64 * 0.875_f64).cos() {
        return y;
    }
    r1[3] -= (((x - y) * (-(d))) + 0.125).tanh();
    let mut f = ((-(x)) * 0.75).sin();
    let g2 = |t: f64| ((t - 0.125_f64).tanh() * t) * t;
    let e = (g2((x * r1[1])) + g2((-1.125_f64 + x))).sin();
    let a = match shape(((y - 0.875_f64).tanh() + 0.125).tanh(), ((y + r1[3]) + 0.125).tanh()) {
        Shape::Point => (r1[3] * 0.375_f64).abs(),
        Shape::Disc(v) => ((d * e) + e),
        Shape::Box { w: v, h } => ((r1[1] + r1[2]) + (r1[1] - 0.125_f64).tanh()),
    };
    let f = root((d * d)).map_or((y * y + 0.25).sqrt(), |v| {
        ((r1[3] + v) / (1.5 + (0.875_f64 * d) * (0.875_f64 * d)))
    });
    let mut p3 = Pair { a: ((e * -0.875_f64).max(a) * 0.75).sin(), b: ((y + f) + 0.125).tanh() };
    let e = match shape(((r1[3] * r1[3] + 0.25).sqrt() * 0.75).sin(), (a + 0.125).tanh()) {
        Point => (a + -0.125_f64).sin(),
        Disc(v) => ((r1[2] + r1[3]) - -1.125_f64).tanh(),
        Shape::Box { w: v, h } => ((v / (1.5 + d * d)) - -1.125_f64).tanh(),
    };
    #[differentiable(checkpoint)]
    'l4: for i5 in (2..5_usize).rev() {
        if (f * 0.875_f64).cos() < (0.125_f64 + e) {
            break;
        }
    }
    'l6: for i7 in 0..2_usize {
        let by8 = ((f + -0.625_f64).sin() * 0.75).sin();
        for v in r1.iter_mut() {
            *v = (*v * by8).sin();
        }
        d *= (((0.125_f64 / (1.5 + d * d)) + -0.125_f64).sin() + 0.125).tanh();
        if i7 % 4 == 2 {
            'l9: for i10 in (0..0_usize).rev() {
                let a = program_6(
                    (r1[(i7 * i7 + 1) % 4] * 0.75).sin(),
                    ((y * ((i7 as f64) * 0.25)) * 0.75).sin(),
                )
                .tanh();
            }
        } else {
            let a: f64 = r1.iter().map(|v| v * ((a * -0.125_f64).abs() * 0.75).sin()).sum();
        }
    }
    ((d + r1[1]) * (x / (1.5 + y * y))) + e + f + a + d + y + x
}

fn program_9_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((S::from_f64(0.375_f64) * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(0.125_f64) * y) * S::from_f64(0.75)).sin(),
        ((y + x) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        ((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ];
    if (x - S::from_f64(0.375_f64))
        .tanh()
        .cmplt((S::from_f64(0.625_f64) * S::from_f64(0.875_f64)).cos())
    {
        return y;
    }
    r1[3] = r1[3] - (((x - y) * (-(d))) + S::from_f64(0.125)).tanh();
    let mut f = ((-(x)) * S::from_f64(0.75)).sin();
    let g2 = |t: S| ((t - S::from_f64(0.125_f64)).tanh() * t) * t;
    let e = (g2((x * r1[1])) + g2((S::from_f64(-1.125_f64) + x))).sin();
    let a = match shape(
        ((y - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((y + r1[3]) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r1[3] * S::from_f64(0.375_f64)).abs(),
        Shape::Disc(v) => ((d * e) + e),
        Shape::Box { w: v, h } => ((r1[1] + r1[2]) + (r1[1] - S::from_f64(0.125_f64)).tanh()),
    };
    let f = root((d * d)).map_or((y * y + S::from_f64(0.25)).sqrt(), |v| {
        ((r1[3] + v)
            / (S::from_f64(1.5) + (S::from_f64(0.875_f64) * d) * (S::from_f64(0.875_f64) * d)))
    });
    let mut p3 = Pair {
        a: ((e * S::from_f64(-0.875_f64)).max(a) * S::from_f64(0.75)).sin(),
        b: ((y + f) + S::from_f64(0.125)).tanh(),
    };
    let e = match shape(
        ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (a + S::from_f64(0.125)).tanh(),
    ) {
        Point => (a + S::from_f64(-0.125_f64)).sin(),
        Disc(v) => ((r1[2] + r1[3]) - S::from_f64(-1.125_f64)).tanh(),
        Shape::Box { w: v, h } => {
            ((v / (S::from_f64(1.5) + d * d)) - S::from_f64(-1.125_f64)).tanh()
        }
    };

    'l4: for i5 in (2..5_usize).rev() {
        if (f * S::from_f64(0.875_f64)).cos().cmplt((S::from_f64(0.125_f64) + e)) {
            break;
        }
    }
    'l6: for i7 in 0..2_usize {
        let by8 = ((f + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin();
        for v in r1.iter_mut() {
            *v = (*v * by8).sin();
        }
        d = d
            * (((S::from_f64(0.125_f64) / (S::from_f64(1.5) + d * d)) + S::from_f64(-0.125_f64))
                .sin()
                + S::from_f64(0.125))
            .tanh();
        if i7 % 4 == 2 {
            'l9: for i10 in (0..0_usize).rev() {
                let a = program_6_of(
                    (r1[(i7 * i7 + 1) % 4] * S::from_f64(0.75)).sin(),
                    ((y * (S::from_f64(i7 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                )
                .tanh();
            }
        } else {
            let a = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v * ((a * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin()
            });
        }
    }
    ((d + r1[1]) * (x / (S::from_f64(1.5) + y * y))) + e + f + a + d + y + x
}

#[differentiable]
fn program_10(x: f64, y: f64) -> f64 {
    let mut f = ((y * -0.125_f64).max(x) * 0.75).sin();
    let r1 = [((x * 0.625_f64).max(x) + 0.125).tanh(); 2];
    f *= (((x / (1.5 + x * x)) * (x / (1.5 + x * x)) + 0.25).sqrt() * 0.75).sin();
    f += (((y + y) + (r1[1] + x)) * 0.75).sin();
    if (r1[1] * r1[0]) <= (0.875_f64 + -0.875_f64).sin() {
        return ((y + -0.625_f64).sin() + (0.125_f64 * 0.875_f64).abs());
    }
    let (a, mut b) = ((r1[1] + 0.125).tanh(), (f * x));
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let f = if n3 % 3 == 2 { ((x * x) * 0.375_f64).abs() } else { a };
        let a = program_4(
            ((r1[n3 % 2] * -0.625_f64).cos() * 0.75).sin(),
            ((r1[0] * -1.125_f64).max(a) + 0.125).tanh(),
        )
        .tanh();
        let b = program_2(
            ((r1[(n3 + 1) % 2] - -1.125_f64) * 0.75).sin(),
            ((-0.875_f64 + ((n3 as f64) * 0.25)) * 0.75).sin(),
        )
        .tanh();
    }
    let mut p4 = Pair { a: ((-(y)) + 0.125).tanh(), b: ((r1[1] * 0.375_f64).cos() * 0.75).sin() };
    let d = match roots((y * 0.625_f64).cos(), (y + x)) {
        Ok(v) => ((r1[1] * a) * 0.125_f64).cos(),
        Err(true) => p4.a,
        Err(_) => (r1[1] - 0.125_f64).tanh(),
    };
    f -= ((-(-(-0.875_f64))) + 0.125).tanh();
    let c = if (b - p4.b) < (r1[1] * -0.875_f64).abs() {
        ((r1[0] + -0.875_f64).sin() * -1.125_f64).abs()
    } else {
        ((r1[1] + 0.125_f64).sin() / (1.5 + (r1[0] * y) * (r1[0] * y)))
    };
    let r5 = [((-(p4.b)) + 0.125).tanh(); 3];
    p4 += p4;
    p4 = p4.tamed();
    ((f + p4.b) * (r5[2] * x)) + c + d + b + a + f + y + x
}

fn program_10_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * S::from_f64(-0.125_f64)).max(x) * S::from_f64(0.75)).sin();
    let r1 = [((x * S::from_f64(0.625_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    f = f
        * (((x / (S::from_f64(1.5) + x * x)) * (x / (S::from_f64(1.5) + x * x))
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    f = f + (((y + y) + (r1[1] + x)) * S::from_f64(0.75)).sin();
    if (r1[1] * r1[0]).cmple((S::from_f64(0.875_f64) + S::from_f64(-0.875_f64)).sin()) {
        return ((y + S::from_f64(-0.625_f64)).sin()
            + (S::from_f64(0.125_f64) * S::from_f64(0.875_f64)).abs());
    }
    let (a, mut b) = ((r1[1] + S::from_f64(0.125)).tanh(), (f * x));
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let f = if n3 % 3 == 2 { ((x * x) * S::from_f64(0.375_f64)).abs() } else { a };
        let a = program_4_of(
            ((r1[n3 % 2] * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
            ((r1[0] * S::from_f64(-1.125_f64)).max(a) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let b = program_2_of(
            ((r1[(n3 + 1) % 2] - S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin(),
            ((S::from_f64(-0.875_f64) + (S::from_f64(n3 as f64) * S::from_f64(0.25)))
                * S::from_f64(0.75))
            .sin(),
        )
        .tanh();
    }
    let mut p4 = Pair {
        a: ((-(y)) + S::from_f64(0.125)).tanh(),
        b: ((r1[1] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
    };
    let d = match roots((y * S::from_f64(0.625_f64)).cos(), (y + x)) {
        Ok(v) => ((r1[1] * a) * S::from_f64(0.125_f64)).cos(),
        Err(true) => p4.a,
        Err(_) => (r1[1] - S::from_f64(0.125_f64)).tanh(),
    };
    f = f - ((-(-(S::from_f64(-0.875_f64)))) + S::from_f64(0.125)).tanh();
    let c = if (b - p4.b).cmplt((r1[1] * S::from_f64(-0.875_f64)).abs()) {
        ((r1[0] + S::from_f64(-0.875_f64)).sin() * S::from_f64(-1.125_f64)).abs()
    } else {
        ((r1[1] + S::from_f64(0.125_f64)).sin() / (S::from_f64(1.5) + (r1[0] * y) * (r1[0] * y)))
    };
    let r5 = [((-(p4.b)) + S::from_f64(0.125)).tanh(); 3];
    p4 += p4;
    p4 = p4.tamed();
    ((f + p4.b) * (r5[2] * x)) + c + d + b + a + f + y + x
}

#[differentiable]
fn program_11(x: f64, y: f64) -> f64 {
    let mut d = ((y * x) + 0.125).tanh();
    let r1 = [((y * d) * 0.75).sin(); 4];
    let mut r2 = [((y / (1.5 + d * d)) + 0.125).tanh(); 4];
    let d = match roots((y + 0.375_f64).sin(), (y - -0.625_f64).tanh()) {
        Ok(v) => ((r1[0] * 0.375_f64).abs() + (d + 0.125_f64).sin()),
        Err(true) => r1[1],
        Err(_) => (y + 0.375_f64).sin(),
    };
    'l3: for i4 in (1..3_usize).step_by(2) {
        let mut c = ((y - d) * 0.75).sin();
        let a = if (((i4 as f64) * 0.25) - y) < (c * r1[3]) {
            ((-(y)) + (0.125_f64 * x))
        } else {
            ((x * r1[i4 % 4]) * (r1[(i4 * i4 + 1) % 4] + -0.375_f64).sin())
        };
    }
    let r5 = [((-(d)) + 0.125).tanh(); 2];
    let mut f = ((y + r1[3]) * 0.75).sin();
    if (f * d) >= d {
        let d = List(vec![
            ((y * -0.875_f64).max(y) + 0.125).tanh(),
            (r1[0] * 0.625_f64).max(r1[2]),
            ((r2[1] / (1.5 + d * d)) * 0.75).sin(),
        ])
        .folded(((f * r2[0]) * 0.75).sin(), |s, v| (s * v + (x * y)).sin());
        let by6 = (d + 0.125).tanh();
        for v in r2.iter_mut() {
            *v = (*v * by6).sin();
        }
        f = (r2[1] + 0.125).tanh();
    } else {
        if y >= (0.375_f64 * 0.625_f64).cos() {
            'l7: for i8 in (0..4_usize).step_by(2) {
                f -= (((r5[(i8 * i8 + 1) % 2] / (1.5 + f * f)) + -0.625_f64).sin() * 0.75).sin();
                let by9 = ((-(f)) + 0.125).tanh();
                let e = shifted(&mut r2[1..], by9);
            }
            let b = ((y * -1.125_f64).max(-1.125_f64) + (r5[1] - f));
        } else {
            let mut a = ((f * x) * 0.75).sin();
            let g10 = |t: f64, v: &[f64]| mixed(v) * t + ((r1[3] + f) - (t + t)).tanh();
            let c = folded(&g10, ((a - -1.125_f64).tanh() + 0.125).tanh(), &r1).sin();
            let f = match shape(((x * x + 0.25).sqrt() * 0.75).sin(), (0.125_f64 + 0.125).tanh()) {
                Point => (0.875_f64 * 0.625_f64).abs(),
                Disc(v) => ((x + r5[1]) * (x + r5[1]) + 0.25).sqrt(),
                Shape::Box { w: v, h } => r2[1],
            };
        }
        let d = summed(
            |t: f64| {
                (((-1.125_f64 - -0.625_f64).tanh()
                    / (1.5 + (-0.625_f64 * -0.125_f64).max(x) * (-0.625_f64 * -0.125_f64).max(x)))
                    * t)
                    .sin()
            },
            ((f * 0.625_f64).cos() + 0.125).tanh(),
            2,
        )
        .tanh();
    }
    ((x * -0.875_f64).max(x) * (x / (1.5 + x * x))) + f + d + y + x
}

fn program_11_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * x) + S::from_f64(0.125)).tanh();
    let r1 = [((y * d) * S::from_f64(0.75)).sin(); 4];
    let mut r2 = [((y / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(); 4];
    let d = match roots((y + S::from_f64(0.375_f64)).sin(), (y - S::from_f64(-0.625_f64)).tanh()) {
        Ok(v) => ((r1[0] * S::from_f64(0.375_f64)).abs() + (d + S::from_f64(0.125_f64)).sin()),
        Err(true) => r1[1],
        Err(_) => (y + S::from_f64(0.375_f64)).sin(),
    };
    'l3: for i4 in (1..3_usize).step_by(2) {
        let mut c = ((y - d) * S::from_f64(0.75)).sin();
        let a = if ((S::from_f64(i4 as f64) * S::from_f64(0.25)) - y).cmplt((c * r1[3])) {
            ((-(y)) + (S::from_f64(0.125_f64) * x))
        } else {
            ((x * r1[i4 % 4]) * (r1[(i4 * i4 + 1) % 4] + S::from_f64(-0.375_f64)).sin())
        };
    }
    let r5 = [((-(d)) + S::from_f64(0.125)).tanh(); 2];
    let mut f = ((y + r1[3]) * S::from_f64(0.75)).sin();
    if (f * d).cmpge(d) {
        let d = List(vec![
            ((y * S::from_f64(-0.875_f64)).max(y) + S::from_f64(0.125)).tanh(),
            (r1[0] * S::from_f64(0.625_f64)).max(r1[2]),
            ((r2[1] / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
        ])
        .folded(((f * r2[0]) * S::from_f64(0.75)).sin(), |s, v| (s * v + (x * y)).sin());
        let by6 = (d + S::from_f64(0.125)).tanh();
        for v in r2.iter_mut() {
            *v = (*v * by6).sin();
        }
        f = (r2[1] + S::from_f64(0.125)).tanh();
    } else {
        if y.cmpge((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).cos()) {
            'l7: for i8 in (0..4_usize).step_by(2) {
                f = f
                    - (((r5[(i8 * i8 + 1) % 2] / (S::from_f64(1.5) + f * f))
                        + S::from_f64(-0.625_f64))
                    .sin()
                        * S::from_f64(0.75))
                    .sin();
                let by9 = ((-(f)) + S::from_f64(0.125)).tanh();
                let e = shifted(&mut r2[1..], by9);
            }
            let b = ((y * S::from_f64(-1.125_f64)).max(S::from_f64(-1.125_f64)) + (r5[1] - f));
        } else {
            let mut a = ((f * x) * S::from_f64(0.75)).sin();
            let g10 = |t: S, v: &[S]| mixed(v) * t + ((r1[3] + f) - (t + t)).tanh();
            let c = folded(
                &g10,
                ((a - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
                &r1,
            )
            .sin();
            let f = match shape(
                ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh(),
            ) {
                Point => (S::from_f64(0.875_f64) * S::from_f64(0.625_f64)).abs(),
                Disc(v) => ((x + r5[1]) * (x + r5[1]) + S::from_f64(0.25)).sqrt(),
                Shape::Box { w: v, h } => r2[1],
            };
        }
        let d = summed(
            |t: S| {
                (((S::from_f64(-1.125_f64) - S::from_f64(-0.625_f64)).tanh()
                    / (S::from_f64(1.5)
                        + (S::from_f64(-0.625_f64) * S::from_f64(-0.125_f64)).max(x)
                            * (S::from_f64(-0.625_f64) * S::from_f64(-0.125_f64)).max(x)))
                    * t)
                    .sin()
            },
            ((f * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
            2,
        )
        .tanh();
    }
    ((x * S::from_f64(-0.875_f64)).max(x) * (x / (S::from_f64(1.5) + x * x))) + f + d + y + x
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
    let c = if (f + -1.125_f64) >= b { x } else { ((f + y) * (f + y) + 0.25).sqrt() };
    let c = mixed(&r1[..3]).sin();
    let g3 = |t: f64| (-((x * x + 0.25).sqrt())) * t;
    let b = (g3((y * y)) + g3(x)).sin();
    f *= (((r1[0] + r1[0]) * -0.375_f64).abs() * 0.75).sin();
    let (a, mut b) = (((x + r1[2]) + 0.125).tanh(), (r1[0] * c));
    let b = root((-0.125_f64 - r1[0]))
        .map_or((-(-0.875_f64)), |v| ((r1[1] + -1.125_f64).sin() + (f + -0.625_f64).sin()));
    if (0.875_f64 * c) < (x * r1[0]) {
        return ((y * -0.625_f64).abs()
            / (1.5 + (f * -0.625_f64).max(r1[0]) * (f * -0.625_f64).max(r1[0])));
    }
    f -= (((b - x) * 0.625_f64).abs() + 0.125).tanh();
    'l4: for i5 in 2..2_usize {
        f = (c + 0.125).tanh();
        if (x * 0.375_f64) < (0.125_f64 * r1[(i5 + 0) % 3]) {
            let mut p6 = Pair { a: ((y - r1[0]) * 0.75).sin(), b: ((c + 0.125_f64) * 0.75).sin() };
            let c = if i5 % 3 == 1 { (-((r1[2] * r1[2] + 0.25).sqrt())) } else { r1[i5 % 3] };
        } else {
            let a = match roots((-(r1[(i5 + 1) % 3])), (b - f)) {
                Ok(v) => x,
                Err(true) => f,
                Err(_) => (r1[i5 % 3] - -1.125_f64).tanh(),
            };
            let mut p7 = Pair {
                a: ((r1[2] + -0.375_f64).sin() * 0.75).sin(),
                b: ((f * f + 0.25).sqrt() * 0.75).sin(),
            };
        }
        let d = program_4(
            ((r1[0] / (1.5 + 0.625_f64 * 0.625_f64)) + 0.125).tanh(),
            ((((i5 as f64) * 0.25) * c) + 0.125).tanh(),
        )
        .tanh();
    }
    c + b + a + c + f + y + x
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
    let c = if (f + S::from_f64(-1.125_f64)).cmpge(b) {
        x
    } else {
        ((f + y) * (f + y) + S::from_f64(0.25)).sqrt()
    };
    let c = mixed(&r1[..3]).sin();
    let g3 = |t: S| (-((x * x + S::from_f64(0.25)).sqrt())) * t;
    let b = (g3((y * y)) + g3(x)).sin();
    f = f * (((r1[0] + r1[0]) * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin();
    let (a, mut b) = (((x + r1[2]) + S::from_f64(0.125)).tanh(), (r1[0] * c));
    let b = root((S::from_f64(-0.125_f64) - r1[0])).map_or((-(S::from_f64(-0.875_f64))), |v| {
        ((r1[1] + S::from_f64(-1.125_f64)).sin() + (f + S::from_f64(-0.625_f64)).sin())
    });
    if (S::from_f64(0.875_f64) * c).cmplt((x * r1[0])) {
        return ((y * S::from_f64(-0.625_f64)).abs()
            / (S::from_f64(1.5)
                + (f * S::from_f64(-0.625_f64)).max(r1[0])
                    * (f * S::from_f64(-0.625_f64)).max(r1[0])));
    }
    f = f - (((b - x) * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh();
    'l4: for i5 in 2..2_usize {
        f = (c + S::from_f64(0.125)).tanh();
        if (x * S::from_f64(0.375_f64)).cmplt((S::from_f64(0.125_f64) * r1[(i5 + 0) % 3])) {
            let mut p6 = Pair {
                a: ((y - r1[0]) * S::from_f64(0.75)).sin(),
                b: ((c + S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(),
            };
            let c = if i5 % 3 == 1 {
                (-((r1[2] * r1[2] + S::from_f64(0.25)).sqrt()))
            } else {
                r1[i5 % 3]
            };
        } else {
            let a = match roots((-(r1[(i5 + 1) % 3])), (b - f)) {
                Ok(v) => x,
                Err(true) => f,
                Err(_) => (r1[i5 % 3] - S::from_f64(-1.125_f64)).tanh(),
            };
            let mut p7 = Pair {
                a: ((r1[2] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
                b: ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            };
        }
        let d = program_4_of(
            ((r1[0] / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
                + S::from_f64(0.125))
            .tanh(),
            (((S::from_f64(i5 as f64) * S::from_f64(0.25)) * c) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    c + b + a + c + f + y + x
}

#[differentiable]
fn program_13(x: f64, y: f64) -> f64 {
    let mut d = ((x * y) * 0.75).sin();
    let mut r1 = [((y * -1.125_f64).abs() + 0.125).tanh(); 5];
    'l2: for i3 in 2..3_usize {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * x).collect();
        u4.push(((d * 0.625_f64).abs() + 0.125).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let a = (mixed(&u4) + u4[0]).tanh();
    }
    let mut d = ((r1[3] / (1.5 + -0.125_f64 * -0.125_f64)) + 0.125).tanh();
    r1[0] = (((r1[4] * -0.375_f64).max(r1[3]) * -0.875_f64).abs() + 0.125).tanh();
    'l5: for i6 in 2..=1_usize {
        if (x * 0.625_f64) >= (y * y) {
            let e = program_0(((y * r1[i6 % 5]) * 0.75).sin(), ((y * y) + 0.125).tanh()).tanh();
            let c = match shape(((d * r1[2]) + 0.125).tanh(), ((r1[i6 % 5] * d) * 0.75).sin()) {
                Shape::Point => (-0.375_f64 * -0.375_f64 + 0.25).sqrt(),
                Shape::Disc(v) => ((y * x) + (-0.875_f64 + v)),
                Shape::Box { w: v, h } => ((r1[0] + 0.125_f64) - (e * -0.125_f64).max(e)),
            };
        } else {
            let a = ((x * -0.875_f64).max(y) * 0.625_f64).max(((i6 as f64) * 0.25));
            let g7 = |t: f64, v: &[f64]| {
                mixed(v) * t
                    + ((d + r1[(i6 * i6 + 1) % 5])
                        / (1.5 + (x * x + 0.25).sqrt() * (x * x + 0.25).sqrt()))
                    .tanh()
            };
            let d = folded(&g7, (((i6 as f64) * 0.25) + 0.125).tanh(), &r1).sin();
        }
    }
    let d = (-(y));
    let g8 = |t: f64| ((r1[0] - 0.125_f64).tanh() + 0.125_f64).sin() * t;
    let c = (g8((r1[1] * -0.375_f64).abs()) + g8((x * -0.625_f64).cos())).sin();
    let mut a = ((x - c) + 0.125).tanh();
    let mut p9 = Pair { a: (c * 0.75).sin(), b: ((0.625_f64 * -0.375_f64).abs() * 0.75).sin() };
    (-(y * r1[4])) + a + c + d + y + x
}

fn program_13_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(); 5];
    'l2: for i3 in 2..3_usize {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * x).collect();
        u4.push(((d * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let a = (mixed(&u4) + u4[0]).tanh();
    }
    let mut d = ((r1[3] / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
        + S::from_f64(0.125))
    .tanh();
    r1[0] = (((r1[4] * S::from_f64(-0.375_f64)).max(r1[3]) * S::from_f64(-0.875_f64)).abs()
        + S::from_f64(0.125))
    .tanh();
    'l5: for i6 in 2..=1_usize {
        if (x * S::from_f64(0.625_f64)).cmpge((y * y)) {
            let e = program_0_of(
                ((y * r1[i6 % 5]) * S::from_f64(0.75)).sin(),
                ((y * y) + S::from_f64(0.125)).tanh(),
            )
            .tanh();
            let c = match shape(
                ((d * r1[2]) + S::from_f64(0.125)).tanh(),
                ((r1[i6 % 5] * d) * S::from_f64(0.75)).sin(),
            ) {
                Shape::Point => {
                    (S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt()
                }
                Shape::Disc(v) => ((y * x) + (S::from_f64(-0.875_f64) + v)),
                Shape::Box { w: v, h } => {
                    ((r1[0] + S::from_f64(0.125_f64)) - (e * S::from_f64(-0.125_f64)).max(e))
                }
            };
        } else {
            let a = ((x * S::from_f64(-0.875_f64)).max(y) * S::from_f64(0.625_f64))
                .max((S::from_f64(i6 as f64) * S::from_f64(0.25)));
            let g7 = |t: S, v: &[S]| {
                mixed(v) * t
                    + ((d + r1[(i6 * i6 + 1) % 5])
                        / (S::from_f64(1.5)
                            + (x * x + S::from_f64(0.25)).sqrt()
                                * (x * x + S::from_f64(0.25)).sqrt()))
                    .tanh()
            };
            let d = folded(
                &g7,
                ((S::from_f64(i6 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh(),
                &r1,
            )
            .sin();
        }
    }
    let d = (-(y));
    let g8 = |t: S| ((r1[0] - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125_f64)).sin() * t;
    let c = (g8((r1[1] * S::from_f64(-0.375_f64)).abs()) + g8((x * S::from_f64(-0.625_f64)).cos()))
        .sin();
    let mut a = ((x - c) + S::from_f64(0.125)).tanh();
    let mut p9 = Pair {
        a: (c * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(0.625_f64) * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    (-(y * r1[4])) + a + c + d + y + x
}

#[differentiable]
fn program_14(x: f64, y: f64) -> f64 {
    let mut e = ((y * y + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [(e + 0.125).tanh(); 4];
    let mut z2;
    if (e * 0.125_f64).max(r1[2]) < (r1[3] * 0.625_f64).abs() {
        z2 = ((r1[3] / (1.5 + r1[3] * r1[3])) - -0.625_f64).tanh();
    } else {
        z2 = (r1[0] * -0.875_f64).max(y);
    }
    z2 = z2 * (r1[0] * -0.875_f64).max(y);
    for v in r1.iter().cycle().take(3) {
        z2 = (z2 + *v).sin();
    }
    let mut z3;
    if (r1[3] * r1[1]) < r1[2] {
        z3 = ((r1[0] * r1[3]) * (r1[2] * -1.125_f64).abs());
    } else {
        z3 = (r1[3] + y);
    }
    z3 = z3 * (r1[3] + y);
    let l4 =
        List(vec![((y * y + 0.25).sqrt() + 0.125).tanh(), -0.875_f64, (0.625_f64 + 0.125).tanh()]);
    let m5 = &l4
        * &List(vec![
            ((z2 + -0.125_f64).sin() + 0.125).tanh(),
            r1[2],
            ((y - -0.375_f64).tanh() * 0.75).sin(),
        ]);
    let e = ((&(&l4 * &m5) * &m5).total() * l4.total()).tanh();
    z2 -= ((-(r1[1] / (1.5 + y * y))) * 0.75).sin();
    let by6 = ((-0.875_f64 * z3) + 0.125).tanh();
    let d = shifted(&mut r1[3..], by6);
    let c = match roots((y + r1[2]), (r1[1] * e)) {
        Ok(v) => ((y - r1[1]) * 0.125_f64).max(d),
        Err(true) => r1[0],
        Err(_) => (0.625_f64 * -0.875_f64),
    };
    if (r1[0] + 0.875_f64).sin() > z3 {
        return ((r1[2] * -0.125_f64).abs() * (r1[2] * -0.125_f64).abs() + 0.25).sqrt();
    }
    let c = match shape(
        ((r1[1] / (1.5 + z3 * z3)) * 0.75).sin(),
        ((r1[2] * -0.625_f64).max(r1[2]) * 0.75).sin(),
    ) {
        Point => (-0.875_f64 * c),
        Disc(v) => ((d / (1.5 + r1[3] * r1[3])) - (r1[1] * r1[1] + 0.25).sqrt()),
        Shape::Box { w: v, h } => (c + (z3 - -0.625_f64).tanh()),
    };
    'l7: for i8 in 2..=1_usize {
        if r1[3] <= (y + -0.625_f64) {
            let mut p9 = Pair {
                a: ((r1[3] * x) + 0.125).tanh(),
                b: ((r1[0] / (1.5 + 0.125_f64 * 0.125_f64)) * 0.75).sin(),
            };
        } else {
            #[differentiable(checkpoint)]
            'l10: for i11 in (i8..4_usize).step_by(2) {
                r1[(i8 + 2) % 4] = ((-((z3 * -0.375_f64).cos())) + 0.125).tanh();
                let f = program_2(
                    ((e * r1[(i11 * i11 + 1) % 4]) * 0.75).sin(),
                    ((-0.875_f64 / (1.5 + 0.375_f64 * 0.375_f64)) * 0.75).sin(),
                )
                .tanh();
                let mut p12 = Pair {
                    a: ((x * 0.375_f64).max(r1[(i11 * i11 + 1) % 4]) * 0.75).sin(),
                    b: ((-(f)) * 0.75).sin(),
                };
            }
        }
    }
    (-((-1.125_f64 + -0.375_f64).sin())) + c + d + e + z3 + z2 + y + x
}

fn program_14_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [(e + S::from_f64(0.125)).tanh(); 4];
    let mut z2;
    if (e * S::from_f64(0.125_f64)).max(r1[2]).cmplt((r1[3] * S::from_f64(0.625_f64)).abs()) {
        z2 = ((r1[3] / (S::from_f64(1.5) + r1[3] * r1[3])) - S::from_f64(-0.625_f64)).tanh();
    } else {
        z2 = (r1[0] * S::from_f64(-0.875_f64)).max(y);
    }
    z2 = z2 * (r1[0] * S::from_f64(-0.875_f64)).max(y);
    for v in r1.iter().cycle().take(3) {
        z2 = (z2 + *v).sin();
    }
    let mut z3;
    if (r1[3] * r1[1]).cmplt(r1[2]) {
        z3 = ((r1[0] * r1[3]) * (r1[2] * S::from_f64(-1.125_f64)).abs());
    } else {
        z3 = (r1[3] + y);
    }
    z3 = z3 * (r1[3] + y);
    let l4 = List(vec![
        ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        S::from_f64(-0.875_f64),
        (S::from_f64(0.625_f64) + S::from_f64(0.125)).tanh(),
    ]);
    let m5 = &l4
        * &List(vec![
            ((z2 + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
            r1[2],
            ((y - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        ]);
    let e = ((&(&l4 * &m5) * &m5).total() * l4.total()).tanh();
    z2 = z2 - ((-(r1[1] / (S::from_f64(1.5) + y * y))) * S::from_f64(0.75)).sin();
    let by6 = ((S::from_f64(-0.875_f64) * z3) + S::from_f64(0.125)).tanh();
    let d = shifted(&mut r1[3..], by6);
    let c = match roots((y + r1[2]), (r1[1] * e)) {
        Ok(v) => ((y - r1[1]) * S::from_f64(0.125_f64)).max(d),
        Err(true) => r1[0],
        Err(_) => (S::from_f64(0.625_f64) * S::from_f64(-0.875_f64)),
    };
    if (r1[0] + S::from_f64(0.875_f64)).sin().cmpgt(z3) {
        return ((r1[2] * S::from_f64(-0.125_f64)).abs() * (r1[2] * S::from_f64(-0.125_f64)).abs()
            + S::from_f64(0.25))
        .sqrt();
    }
    let c = match shape(
        ((r1[1] / (S::from_f64(1.5) + z3 * z3)) * S::from_f64(0.75)).sin(),
        ((r1[2] * S::from_f64(-0.625_f64)).max(r1[2]) * S::from_f64(0.75)).sin(),
    ) {
        Point => (S::from_f64(-0.875_f64) * c),
        Disc(v) => {
            ((d / (S::from_f64(1.5) + r1[3] * r1[3])) - (r1[1] * r1[1] + S::from_f64(0.25)).sqrt())
        }
        Shape::Box { w: v, h } => (c + (z3 - S::from_f64(-0.625_f64)).tanh()),
    };
    'l7: for i8 in 2..=1_usize {
        if r1[3].cmple((y + S::from_f64(-0.625_f64))) {
            let mut p9 = Pair {
                a: ((r1[3] * x) + S::from_f64(0.125)).tanh(),
                b: ((r1[0] / (S::from_f64(1.5) + S::from_f64(0.125_f64) * S::from_f64(0.125_f64)))
                    * S::from_f64(0.75))
                .sin(),
            };
        } else {
            'l10: for i11 in (i8..4_usize).step_by(2) {
                r1[(i8 + 2) % 4] =
                    ((-((z3 * S::from_f64(-0.375_f64)).cos())) + S::from_f64(0.125)).tanh();
                let f = program_2_of(
                    ((e * r1[(i11 * i11 + 1) % 4]) * S::from_f64(0.75)).sin(),
                    ((S::from_f64(-0.875_f64)
                        / (S::from_f64(1.5) + S::from_f64(0.375_f64) * S::from_f64(0.375_f64)))
                        * S::from_f64(0.75))
                    .sin(),
                )
                .tanh();
                let mut p12 = Pair {
                    a: ((x * S::from_f64(0.375_f64)).max(r1[(i11 * i11 + 1) % 4])
                        * S::from_f64(0.75))
                    .sin(),
                    b: ((-(f)) * S::from_f64(0.75)).sin(),
                };
            }
        }
    }
    (-((S::from_f64(-1.125_f64) + S::from_f64(-0.375_f64)).sin())) + c + d + e + z3 + z2 + y + x
}

#[differentiable]
fn program_15(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.375_f64) + 0.125).tanh();
    let r1 = [(x + 0.125).tanh(), ((y + x) + 0.125).tanh()];
    let mut r2 = [(c * 0.75).sin(), ((c - y) + 0.125).tanh()];
    let mut p3 = Pair {
        a: ((c * -1.125_f64).cos() * 0.75).sin(),
        b: ((r1[0] * -0.375_f64).abs() + 0.125).tanh(),
    };
    let mut p4 = Pair { a: ((y + 0.125_f64).sin() + 0.125).tanh(), b: ((p3.b - y) + 0.125).tanh() };
    'l5: for i6 in 0..1_usize {
        p3.turn(((r1[(i6 * i6 + 1) % 2] * 0.375_f64).cos() * 0.75).sin());
        p3 = p3.tamed();
        let g7 = |t: f64, v: &[f64]| {
            mixed(v) * t
                + ((r2[(i6 + 1) % 2] / (1.5 + t * t)) / (1.5 + (p3.b - t) * (p3.b - t))).tanh()
        };
        let c = folded(&g7, ((-0.625_f64 - r2[1]) * 0.75).sin(), &r2).sin();
        p4.turn((r2[(i6 * i6 + 1) % 2] + 0.125).tanh());
        p4 = p4.tamed();
    }
    let g8 = |t: f64| c * t;
    let a = (g8((y + c)) + g8((r2[1] + -0.125_f64).sin())).sin();
    r2[0] *= (((c * 0.125_f64).cos() + (r1[0] * 0.875_f64)) * 0.75).sin();
    r2[1] = (((x * 0.875_f64).cos() * r1[1]) * 0.75).sin();
    r2[1] *= (((c * c + 0.25).sqrt() * -1.125_f64).cos() * 0.75).sin();
    let e: f64 = r2.iter().map(|v| v * ((r1[1] * 0.125_f64).cos() * 0.75).sin()).sum();
    let mut n10 = 0_usize;
    'l9: while n10 < 5 {
        n10 += 1;
        c += (((r1[1] / (1.5 + e * e)) + (((n10 as f64) * 0.25) * -0.625_f64).cos()) * 0.75).sin();
        'l11: for i12 in n10..5_usize {
            #[differentiable(checkpoint)]
            'l13: for i14 in (n10..0_usize).rev() {
                let a = if let Some(v) = root((c * 0.125_f64).abs()) {
                    ((x - -0.875_f64).tanh() * (r1[0] * -1.125_f64).max(c))
                } else {
                    (r1[(i12 * i12 + 1) % 2] * x)
                };
            }
            'l15: for i16 in (2..5_usize).rev() {
                let mut p17 = Pair {
                    a: ((y * -1.125_f64).cos() * 0.75).sin(),
                    b: ((r1[(i16 * i16 + 1) % 2] * r1[(i16 * i16 + 1) % 2] + 0.25).sqrt() * 0.75)
                        .sin(),
                };
            }
            let d = if i12 % 2 == 0 {
                (a * a + 0.25).sqrt()
            } else {
                ((-(p3.a)) + (e / (1.5 + -0.875_f64 * -0.875_f64)))
            };
        }
        let mut z18;
        let mut n19 = 0_usize;
        loop {
            n19 += 1;
            let t = ((r1[(n10 + 1) % 2] * r1[(n10 + 1) % 2] + 0.25).sqrt() * -0.625_f64).cos();
            if n19 > 2 || n10 % 2 == 1 {
                z18 = ((y * r2[n10 % 2]) / (1.5 + (p4.a + p4.a) * (p4.a + p4.a)));
                break;
            }
        }
        z18 = z18 * (e - c);
    }
    (-((x * x + 0.25).sqrt())) + e + a + c + y + x
}

fn program_15_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [(x + S::from_f64(0.125)).tanh(), ((y + x) + S::from_f64(0.125)).tanh()];
    let mut r2 = [(c * S::from_f64(0.75)).sin(), ((c - y) + S::from_f64(0.125)).tanh()];
    let mut p3 = Pair {
        a: ((c * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((r1[0] * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    let mut p4 = Pair {
        a: ((y + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((p3.b - y) + S::from_f64(0.125)).tanh(),
    };
    'l5: for i6 in 0..1_usize {
        p3.turn(((r1[(i6 * i6 + 1) % 2] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin());
        p3 = p3.tamed();
        let g7 = |t: S, v: &[S]| {
            mixed(v) * t
                + ((r2[(i6 + 1) % 2] / (S::from_f64(1.5) + t * t))
                    / (S::from_f64(1.5) + (p3.b - t) * (p3.b - t)))
                    .tanh()
        };
        let c =
            folded(&g7, ((S::from_f64(-0.625_f64) - r2[1]) * S::from_f64(0.75)).sin(), &r2).sin();
        p4.turn((r2[(i6 * i6 + 1) % 2] + S::from_f64(0.125)).tanh());
        p4 = p4.tamed();
    }
    let g8 = |t: S| c * t;
    let a = (g8((y + c)) + g8((r2[1] + S::from_f64(-0.125_f64)).sin())).sin();
    r2[0] = r2[0]
        * (((c * S::from_f64(0.125_f64)).cos() + (r1[0] * S::from_f64(0.875_f64)))
            * S::from_f64(0.75))
        .sin();
    r2[1] = (((x * S::from_f64(0.875_f64)).cos() * r1[1]) * S::from_f64(0.75)).sin();
    r2[1] = r2[1]
        * (((c * c + S::from_f64(0.25)).sqrt() * S::from_f64(-1.125_f64)).cos()
            * S::from_f64(0.75))
        .sin();
    let e = r2.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[1] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin()
    });
    let mut n10 = 0_usize;
    'l9: while n10 < 5 {
        n10 += 1;
        c = c
            + (((r1[1] / (S::from_f64(1.5) + e * e))
                + ((S::from_f64(n10 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).cos())
                * S::from_f64(0.75))
            .sin();
        'l11: for i12 in n10..5_usize {
            'l13: for i14 in (n10..0_usize).rev() {
                let a = if let Some(v) = root((c * S::from_f64(0.125_f64)).abs()) {
                    ((x - S::from_f64(-0.875_f64)).tanh()
                        * (r1[0] * S::from_f64(-1.125_f64)).max(c))
                } else {
                    (r1[(i12 * i12 + 1) % 2] * x)
                };
            }
            'l15: for i16 in (2..5_usize).rev() {
                let mut p17 = Pair {
                    a: ((y * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
                    b: ((r1[(i16 * i16 + 1) % 2] * r1[(i16 * i16 + 1) % 2] + S::from_f64(0.25))
                        .sqrt()
                        * S::from_f64(0.75))
                    .sin(),
                };
            }
            let d = if i12 % 2 == 0 {
                (a * a + S::from_f64(0.25)).sqrt()
            } else {
                ((-(p3.a))
                    + (e / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64))))
            };
        }
        let mut z18;
        let mut n19 = 0_usize;
        loop {
            n19 += 1;
            let t = ((r1[(n10 + 1) % 2] * r1[(n10 + 1) % 2] + S::from_f64(0.25)).sqrt()
                * S::from_f64(-0.625_f64))
            .cos();
            if n19 > 2 || n10 % 2 == 1 {
                z18 = ((y * r2[n10 % 2]) / (S::from_f64(1.5) + (p4.a + p4.a) * (p4.a + p4.a)));
                break;
            }
        }
        z18 = z18 * (e - c);
    }
    (-((x * x + S::from_f64(0.25)).sqrt())) + e + a + c + y + x
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
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let z4;
        if (e * r1[1]) < (r1[(n3 * n3 + 1) % 4] * r1[(n3 * n3 + 1) % 4] + 0.25).sqrt() {
            let t = ((x * e) * (x * e) + 0.25).sqrt();
            z4 = ((r1[(n3 * n3 + 1) % 4] * x) * 0.375_f64).cos();
        } else if n3 % 4 == 1 {
            z4 = bent((e - 0.375_f64).tanh());
        } else {
            z4 = ((x * e) * (x * e) + 0.25).sqrt();
        }
        #[differentiable(checkpoint)]
        'l5: for i6 in n3..2_usize {
            r1[(n3 * n3 + 1) % 4] += (((((i6 as f64) * 0.25) + e) + (r1[2] * z4)) * 0.75).sin();
            let by7 = ((e - r1[i6 % 4]) + 0.125).tanh();
            let b = shifted(&mut r1[1..], by7);
        }
        let b = List(vec![
            ((((n3 as f64) * 0.25) + r1[3]) * 0.75).sin(),
            (e + r1[2]),
            ((r1[(n3 + 2) % 4] * -0.125_f64).max(r1[1]) + 0.125).tanh(),
        ])
        .folded(((e * e + 0.25).sqrt() * 0.75).sin(), |s, v| {
            (s * v + (((n3 as f64) * 0.25) * -0.875_f64).abs()).sin()
        });
    }
    let e = match roots((y * y), (y * 0.125_f64).max(r1[2])) {
        Ok(v) => ((y * 0.625_f64) + e),
        Err(true) => r1[3],
        Err(_) => (r1[2] * r1[0]),
    };
    let mut c = ((-(e)) + 0.125).tanh();
    let mut p8 = Pair { a: ((-(e)) + 0.125).tanh(), b: ((-(-0.125_f64)) * 0.75).sin() };
    let mut u9: Vec<_> = r1.iter().map(|v| *v * 0.125_f64).collect();
    u9.push(((c - r1[2]) + 0.125).tanh());
    u9[0] = u9[1] * u9[u9.len() - 1];
    let c = (mixed(&u9) + u9[0]).tanh();
    p8.turn(((y * r1[2]) * 0.75).sin());
    p8 = p8.tamed();
    let c =
        program_0(((y * p8.a) * 0.75).sin(), ((r1[3] * r1[3] + 0.25).sqrt() + 0.125).tanh()).tanh();
    let f = if (c + -1.125_f64) <= (r1[2] + x) {
        ((-(y)) * 0.375_f64).abs()
    } else {
        ((c * -1.125_f64).max(-0.375_f64) + (e - 0.875_f64).tanh())
    };
    let mut p10 = Pair { a: (r1[3] * 0.75).sin(), b: ((r1[2] + r1[0]) + 0.125).tanh() };
    (-(r1[2] * y)) + f + c + e + y + x
}

fn program_16_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
        ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let z4;
        if (e * r1[1])
            .cmplt((r1[(n3 * n3 + 1) % 4] * r1[(n3 * n3 + 1) % 4] + S::from_f64(0.25)).sqrt())
        {
            let t = ((x * e) * (x * e) + S::from_f64(0.25)).sqrt();
            z4 = ((r1[(n3 * n3 + 1) % 4] * x) * S::from_f64(0.375_f64)).cos();
        } else if n3 % 4 == 1 {
            z4 = bent((e - S::from_f64(0.375_f64)).tanh());
        } else {
            z4 = ((x * e) * (x * e) + S::from_f64(0.25)).sqrt();
        }

        'l5: for i6 in n3..2_usize {
            r1[(n3 * n3 + 1) % 4] = r1[(n3 * n3 + 1) % 4]
                + ((((S::from_f64(i6 as f64) * S::from_f64(0.25)) + e) + (r1[2] * z4))
                    * S::from_f64(0.75))
                .sin();
            let by7 = ((e - r1[i6 % 4]) + S::from_f64(0.125)).tanh();
            let b = shifted(&mut r1[1..], by7);
        }
        let b = List(vec![
            (((S::from_f64(n3 as f64) * S::from_f64(0.25)) + r1[3]) * S::from_f64(0.75)).sin(),
            (e + r1[2]),
            ((r1[(n3 + 2) % 4] * S::from_f64(-0.125_f64)).max(r1[1]) + S::from_f64(0.125)).tanh(),
        ])
        .folded(((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(), |s, v| {
            (s * v + ((S::from_f64(n3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.875_f64)).abs())
                .sin()
        });
    }
    let e = match roots((y * y), (y * S::from_f64(0.125_f64)).max(r1[2])) {
        Ok(v) => ((y * S::from_f64(0.625_f64)) + e),
        Err(true) => r1[3],
        Err(_) => (r1[2] * r1[0]),
    };
    let mut c = ((-(e)) + S::from_f64(0.125)).tanh();
    let mut p8 = Pair {
        a: ((-(e)) + S::from_f64(0.125)).tanh(),
        b: ((-(S::from_f64(-0.125_f64))) * S::from_f64(0.75)).sin(),
    };
    let mut u9: Vec<_> = r1.iter().map(|v| *v * S::from_f64(0.125_f64)).collect();
    u9.push(((c - r1[2]) + S::from_f64(0.125)).tanh());
    u9[0] = u9[1] * u9[u9.len() - 1];
    let c = (mixed(&u9) + u9[0]).tanh();
    p8.turn(((y * r1[2]) * S::from_f64(0.75)).sin());
    p8 = p8.tamed();
    let c = program_0_of(
        ((y * p8.a) * S::from_f64(0.75)).sin(),
        ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let f = if (c + S::from_f64(-1.125_f64)).cmple((r1[2] + x)) {
        ((-(y)) * S::from_f64(0.375_f64)).abs()
    } else {
        ((c * S::from_f64(-1.125_f64)).max(S::from_f64(-0.375_f64))
            + (e - S::from_f64(0.875_f64)).tanh())
    };
    let mut p10 = Pair {
        a: (r1[3] * S::from_f64(0.75)).sin(),
        b: ((r1[2] + r1[0]) + S::from_f64(0.125)).tanh(),
    };
    (-(r1[2] * y)) + f + c + e + y + x
}

#[differentiable]
fn program_17(x: f64, y: f64) -> f64 {
    let mut a = ((x * x) * 0.75).sin();
    let mut r1 = [((y * -1.125_f64).cos() * 0.75).sin(); 3];
    a *= (((x * 0.875_f64).cos() * -0.875_f64).max(r1[2]) * 0.75).sin();
    let mut r2 = [((a * -0.375_f64).abs() * 0.75).sin(); 3];
    let f: f64 = r1.iter().map(|v| v * ((y + r2[0]) + 0.125).tanh()).sum();
    let g3 = |t: f64| ((r1[2] * r1[2] + 0.25).sqrt() - 0.375_f64).tanh() * t;
    let d = (g3((r2[2] * x)) + g3((x * -0.875_f64).max(x))).sin();
    let mut p4 =
        Pair { a: ((r1[1] * -0.125_f64) * 0.75).sin(), b: ((r2[0] * -0.625_f64) + 0.125).tanh() };
    let e = summed(
        |t: f64| (((f * f + 0.25).sqrt() + -0.875_f64).sin() * t).sin(),
        ((x * f) * 0.75).sin(),
        3,
    )
    .tanh();
    let d = summed(|t: f64| (((x * a) * (a * r2[1])) * t).sin(), ((y * e) * 0.75).sin(), 2).tanh();
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        let e = p4.dot(&p4).sin();
        let mut p7 = Pair { a: ((a * 0.875_f64) + 0.125).tanh(), b: (y + 0.125).tanh() };
        let a: f64 = r2.iter().map(|v| v * ((f * r1[(n6 + 2) % 3]) * 0.75).sin()).sum();
    }
    let e = if (r2[1] * -1.125_f64).cos() > (f * -1.125_f64).max(y) {
        ((-0.125_f64 * 0.625_f64).cos() * -1.125_f64).abs()
    } else {
        ((r1[1] * p4.a) * (r2[2] + x))
    };
    let c = summed(
        |t: f64| (((t * 0.375_f64).max(y) * -1.125_f64).max(e) * t).sin(),
        ((-(e)) * 0.75).sin(),
        1,
    )
    .tanh();
    #[differentiable(checkpoint)]
    'l8: for i9 in (0..5_usize).rev() {
        p4.turn((y + 0.125).tanh());
        p4 = p4.tamed();
    }
    ((a * a + 0.25).sqrt() * -1.125_f64).max(d) + c + e + d + f + a + y + x
}

fn program_17_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * x) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(); 3];
    a = a
        * (((x * S::from_f64(0.875_f64)).cos() * S::from_f64(-0.875_f64)).max(r1[2])
            * S::from_f64(0.75))
        .sin();
    let mut r2 = [((a * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(); 3];
    let f = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * ((y + r2[0]) + S::from_f64(0.125)).tanh());
    let g3 =
        |t: S| ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() - S::from_f64(0.375_f64)).tanh() * t;
    let d = (g3((r2[2] * x)) + g3((x * S::from_f64(-0.875_f64)).max(x))).sin();
    let mut p4 = Pair {
        a: ((r1[1] * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        b: ((r2[0] * S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh(),
    };
    let e = summed(
        |t: S| (((f * f + S::from_f64(0.25)).sqrt() + S::from_f64(-0.875_f64)).sin() * t).sin(),
        ((x * f) * S::from_f64(0.75)).sin(),
        3,
    )
    .tanh();
    let d =
        summed(|t: S| (((x * a) * (a * r2[1])) * t).sin(), ((y * e) * S::from_f64(0.75)).sin(), 2)
            .tanh();
    let mut n6 = 0_usize;
    'l5: while n6 < 1 {
        n6 += 1;
        let e = p4.dot(&p4).sin();
        let mut p7 = Pair {
            a: ((a * S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh(),
            b: (y + S::from_f64(0.125)).tanh(),
        };
        let a = r2.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((f * r1[(n6 + 2) % 3]) * S::from_f64(0.75)).sin()
        });
    }
    let e = if (r2[1] * S::from_f64(-1.125_f64)).cos().cmpgt((f * S::from_f64(-1.125_f64)).max(y)) {
        ((S::from_f64(-0.125_f64) * S::from_f64(0.625_f64)).cos() * S::from_f64(-1.125_f64)).abs()
    } else {
        ((r1[1] * p4.a) * (r2[2] + x))
    };
    let c = summed(
        |t: S| (((t * S::from_f64(0.375_f64)).max(y) * S::from_f64(-1.125_f64)).max(e) * t).sin(),
        ((-(e)) * S::from_f64(0.75)).sin(),
        1,
    )
    .tanh();

    'l8: for i9 in (0..5_usize).rev() {
        p4.turn((y + S::from_f64(0.125)).tanh());
        p4 = p4.tamed();
    }
    ((a * a + S::from_f64(0.25)).sqrt() * S::from_f64(-1.125_f64)).max(d)
        + c
        + e
        + d
        + f
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
    let g2 = |t: f64| ((d - y) + 0.125_f64).sin() * t;
    let d = (g2((r1[2] * -0.625_f64).cos()) + g2(r1[3])).sin();
    if r1[1] < (r1[4] * 0.375_f64).max(d) {
        let (a, mut b) = ((d * 0.75).sin(), (d + -0.125_f64).sin());
        let mut p3 = Pair { a: ((e - x) + 0.125).tanh(), b: ((r1[0] - r1[0]) * 0.75).sin() };
        let d = summed(bent, ((b * b + 0.25).sqrt() + 0.125).tanh(), 3).tanh();
    }
    let k4 = e;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k4).sin();
        part.reverse();
    }
    if (r1[2] * -1.125_f64).max(0.375_f64) > (d * -0.875_f64).max(r1[1]) {
        let f = match root((e * 0.125_f64).max(r1[3])) {
            Some(v) => ((e + v) - (-(r1[1]))),
            None => (r1[2] - -0.375_f64),
        };
        'l5: for i6 in 2..=3_usize {
            for v in r1.iter().cycle().take(7) {
                e = (e + *v).sin();
            }
            let by7 = ((r1[(i6 * i6 + 1) % 5] + -0.875_f64).sin() + 0.125).tanh();
            let d = shifted(&mut r1[2..], by7);
            let mut w8 =
                (((0.875_f64 * r1[1]) * 0.75).sin(), [(r1[i6 % 5] * r1[(i6 * i6 + 1) % 5]); 2]);
            {
                let (p, [q, _]) = &mut w8;
                *p = (*p * *q).sin();
                *q = *q * *p + *q;
            }
            let f = (w8.0 + w8.1[0] * w8.1[1]).tanh();
        }
    } else {
        e = (y + 0.125).tanh();
        let e = match roots((r1[4] - d), (d * x)) {
            Ok(v) => ((d * v) * (-0.375_f64 * e)),
            Err(true) => r1[4],
            Err(_) => y,
        };
        let mut z9;
        if x <= (y * 0.625_f64).max(x) {
            z9 = ((0.875_f64 - 0.125_f64).tanh() * -0.125_f64).abs();
        } else {
            z9 = (d * 0.625_f64).abs();
        }
        z9 = z9 * (d * 0.625_f64).abs();
    }
    (-(r1[1] - r1[0])) + d + e + y + x
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
    let g2 = |t: S| ((d - y) + S::from_f64(0.125_f64)).sin() * t;
    let d = (g2((r1[2] * S::from_f64(-0.625_f64)).cos()) + g2(r1[3])).sin();
    if r1[1].cmplt((r1[4] * S::from_f64(0.375_f64)).max(d)) {
        let (a, mut b) = ((d * S::from_f64(0.75)).sin(), (d + S::from_f64(-0.125_f64)).sin());
        let mut p3 = Pair {
            a: ((e - x) + S::from_f64(0.125)).tanh(),
            b: ((r1[0] - r1[0]) * S::from_f64(0.75)).sin(),
        };
        let d = summed(bent, ((b * b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(), 3)
            .tanh();
    }
    let k4 = e;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k4).sin();
        part.reverse();
    }
    if (r1[2] * S::from_f64(-1.125_f64))
        .max(S::from_f64(0.375_f64))
        .cmpgt((d * S::from_f64(-0.875_f64)).max(r1[1]))
    {
        let f = match root((e * S::from_f64(0.125_f64)).max(r1[3])) {
            Some(v) => ((e + v) - (-(r1[1]))),
            None => (r1[2] - S::from_f64(-0.375_f64)),
        };
        'l5: for i6 in 2..=3_usize {
            for v in r1.iter().cycle().take(7) {
                e = (e + *v).sin();
            }
            let by7 = ((r1[(i6 * i6 + 1) % 5] + S::from_f64(-0.875_f64)).sin()
                + S::from_f64(0.125))
            .tanh();
            let d = shifted(&mut r1[2..], by7);
            let mut w8 = (
                ((S::from_f64(0.875_f64) * r1[1]) * S::from_f64(0.75)).sin(),
                [(r1[i6 % 5] * r1[(i6 * i6 + 1) % 5]); 2],
            );
            {
                let (p, [q, _]) = &mut w8;
                *p = (*p * *q).sin();
                *q = *q * *p + *q;
            }
            let f = (w8.0 + w8.1[0] * w8.1[1]).tanh();
        }
    } else {
        e = (y + S::from_f64(0.125)).tanh();
        let e = match roots((r1[4] - d), (d * x)) {
            Ok(v) => ((d * v) * (S::from_f64(-0.375_f64) * e)),
            Err(true) => r1[4],
            Err(_) => y,
        };
        let mut z9;
        if x.cmple((y * S::from_f64(0.625_f64)).max(x)) {
            z9 = ((S::from_f64(0.875_f64) - S::from_f64(0.125_f64)).tanh()
                * S::from_f64(-0.125_f64))
            .abs();
        } else {
            z9 = (d * S::from_f64(0.625_f64)).abs();
        }
        z9 = z9 * (d * S::from_f64(0.625_f64)).abs();
    }
    (-(r1[1] - r1[0])) + d + e + y + x
}

#[differentiable]
fn program_19(x: f64, y: f64) -> f64 {
    let mut f = ((y * x) + 0.125).tanh();
    let r1 = [((y / (1.5 + x * x)) * 0.75).sin(); 3];
    let g2 = |t: f64| r1[1] * t;
    let a = (g2((r1[0] * 0.375_f64).abs()) + g2((0.125_f64 - -0.625_f64).tanh())).sin();
    let mut a = ((f - f) * 0.75).sin();
    'l3: for i4 in (2..0_usize).rev() {
        let mut p5 = Pair {
            a: ((r1[i4 % 3] * -0.125_f64).cos() * 0.75).sin(),
            b: ((-(r1[1])) + 0.125).tanh(),
        };
    }
    if x <= (f - 0.125_f64).tanh() {
        let f = match roots((x * r1[0]), f) {
            Ok(v) => ((a * -0.125_f64).abs() * (v * v)),
            Err(true) => r1[2],
            Err(_) => (y / (1.5 + -0.625_f64 * -0.625_f64)),
        };
    }
    f = (((x / (1.5 + r1[2] * r1[2])) * x) * 0.75).sin();
    if f > (y / (1.5 + a * a)) {
        f += (a * 0.75).sin();
        let a = program_11(((x * r1[0]) * 0.75).sin(), ((f + 0.375_f64) + 0.125).tanh()).tanh();
    } else {
        if (a * 0.125_f64).max(x) > (-(f)) {
            a -= (((x / (1.5 + f * f)) * (f + a)) + 0.125).tanh();
        }
        let l6 = List(vec![((r1[0] + r1[1]) * 0.75).sin(), (x + a), ((a + y) + 0.125).tanh()]);
        let m7 = &l6
            * &List(vec![
                ((0.625_f64 * -0.375_f64).abs() * 0.75).sin(),
                -0.375_f64,
                (-0.125_f64 + 0.125).tanh(),
            ]);
        let c = ((l6.clone() + m7).total()).tanh();
    }
    a = (((x + 0.875_f64).sin() - -0.375_f64).tanh() + 0.125).tanh();
    ((y + r1[2]) - -0.875_f64).tanh() + a + f + y + x
}

fn program_19_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * x) + S::from_f64(0.125)).tanh();
    let r1 = [((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(); 3];
    let g2 = |t: S| r1[1] * t;
    let a = (g2((r1[0] * S::from_f64(0.375_f64)).abs())
        + g2((S::from_f64(0.125_f64) - S::from_f64(-0.625_f64)).tanh()))
    .sin();
    let mut a = ((f - f) * S::from_f64(0.75)).sin();
    'l3: for i4 in (2..0_usize).rev() {
        let mut p5 = Pair {
            a: ((r1[i4 % 3] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            b: ((-(r1[1])) + S::from_f64(0.125)).tanh(),
        };
    }
    if x.cmple((f - S::from_f64(0.125_f64)).tanh()) {
        let f = match roots((x * r1[0]), f) {
            Ok(v) => ((a * S::from_f64(-0.125_f64)).abs() * (v * v)),
            Err(true) => r1[2],
            Err(_) => (y / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64))),
        };
    }
    f = (((x / (S::from_f64(1.5) + r1[2] * r1[2])) * x) * S::from_f64(0.75)).sin();
    if f.cmpgt((y / (S::from_f64(1.5) + a * a))) {
        f = f + (a * S::from_f64(0.75)).sin();
        let a = program_11_of(
            ((x * r1[0]) * S::from_f64(0.75)).sin(),
            ((f + S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    } else {
        if (a * S::from_f64(0.125_f64)).max(x).cmpgt((-(f))) {
            a = a - (((x / (S::from_f64(1.5) + f * f)) * (f + a)) + S::from_f64(0.125)).tanh();
        }
        let l6 = List(vec![
            ((r1[0] + r1[1]) * S::from_f64(0.75)).sin(),
            (x + a),
            ((a + y) + S::from_f64(0.125)).tanh(),
        ]);
        let m7 = &l6
            * &List(vec![
                ((S::from_f64(0.625_f64) * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75))
                    .sin(),
                S::from_f64(-0.375_f64),
                (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh(),
            ]);
        let c = ((l6.clone() + m7).total()).tanh();
    }
    a = (((x + S::from_f64(0.875_f64)).sin() - S::from_f64(-0.375_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    ((y + r1[2]) - S::from_f64(-0.875_f64)).tanh() + a + f + y + x
}

#[differentiable]
fn program_20(x: f64, y: f64) -> f64 {
    let mut d = (x + 0.125).tanh();
    let mut r1 = [((d - -1.125_f64).tanh() * 0.75).sin(); 4];
    let mut z2;
    if (r1[0] * -0.125_f64).cos() <= (0.875_f64 * -1.125_f64).abs() {
        z2 = (x * d);
    } else {
        z2 = (y * -0.625_f64).cos();
    }
    z2 = z2 * (y * -0.625_f64).cos();
    let c =
        if (-(z2)) < (-(d)) { (-((r1[3] * -0.875_f64).cos())) } else { ((y + z2) * (r1[1] + z2)) };
    let mut p3 = Pair { a: (x + 0.125).tanh(), b: ((r1[3] * r1[3] + 0.25).sqrt() + 0.125).tanh() };
    let mut r4 = [
        ((r1[1] - c) + 0.125).tanh(),
        ((r1[2] + 0.375_f64).sin() + 0.125).tanh(),
        ((-0.875_f64 * d) * 0.75).sin(),
    ];
    if y <= r4[1] {
        let mut u5: Vec<_> = r4.iter().map(|v| *v * r1[1]).collect();
        u5.push((0.125_f64 + 0.125).tanh());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let c = (mixed(&u5) + u5[0]).tanh();
        let mut r6 = [((d * d + 0.25).sqrt() + 0.125).tanh(), ((c * x) * 0.75).sin()];
    } else {
        let e = summed(
            |t: f64| (((r4[1] * 0.625_f64).max(-0.375_f64) + 0.625_f64).sin() * t).sin(),
            (p3.a * 0.75).sin(),
            0,
        )
        .tanh();
        let mut p7 =
            Pair { a: (0.375_f64 * 0.75).sin(), b: ((p3.b * p3.b + 0.25).sqrt() * 0.75).sin() };
        let z8;
        if (0.875_f64 / (1.5 + c * c)) < (e * p7.b) {
            let t = (-(d));
            z8 = y;
        } else if (e * d) >= (-(-1.125_f64)) {
            z8 = bent((r4[2] + r1[2]));
        } else {
            z8 = (-(d));
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 1 {
        n10 += 1;
        if n10 % 2 == 0 {
            r1[2] -= (((y - r4[0]) + (x - r4[(n10 * n10 + 1) % 3])) * 0.75).sin();
            let mut u11: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u11.push((c + 0.125).tanh());
            u11[0] = u11[1] * u11[u11.len() - 1];
            let b = (mixed(&u11) + u11[0]).tanh();
        }
    }
    ((c * c) - -0.125_f64).tanh() + c + z2 + d + y + x
}

fn program_20_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((d - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(); 4];
    let mut z2;
    if (r1[0] * S::from_f64(-0.125_f64))
        .cos()
        .cmple((S::from_f64(0.875_f64) * S::from_f64(-1.125_f64)).abs())
    {
        z2 = (x * d);
    } else {
        z2 = (y * S::from_f64(-0.625_f64)).cos();
    }
    z2 = z2 * (y * S::from_f64(-0.625_f64)).cos();
    let c = if (-(z2)).cmplt((-(d))) {
        (-((r1[3] * S::from_f64(-0.875_f64)).cos()))
    } else {
        ((y + z2) * (r1[1] + z2))
    };
    let mut p3 = Pair {
        a: (x + S::from_f64(0.125)).tanh(),
        b: ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    };
    let mut r4 = [
        ((r1[1] - c) + S::from_f64(0.125)).tanh(),
        ((r1[2] + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.875_f64) * d) * S::from_f64(0.75)).sin(),
    ];
    if y.cmple(r4[1]) {
        let mut u5: Vec<_> = r4.iter().map(|v| *v * r1[1]).collect();
        u5.push((S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let c = (mixed(&u5) + u5[0]).tanh();
        let mut r6 = [
            ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            ((c * x) * S::from_f64(0.75)).sin(),
        ];
    } else {
        let e = summed(
            |t: S| {
                (((r4[1] * S::from_f64(0.625_f64)).max(S::from_f64(-0.375_f64))
                    + S::from_f64(0.625_f64))
                .sin()
                    * t)
                    .sin()
            },
            (p3.a * S::from_f64(0.75)).sin(),
            0,
        )
        .tanh();
        let mut p7 = Pair {
            a: (S::from_f64(0.375_f64) * S::from_f64(0.75)).sin(),
            b: ((p3.b * p3.b + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        };
        let z8;
        if (S::from_f64(0.875_f64) / (S::from_f64(1.5) + c * c)).cmplt((e * p7.b)) {
            let t = (-(d));
            z8 = y;
        } else if (e * d).cmpge((-(S::from_f64(-1.125_f64)))) {
            z8 = bent((r4[2] + r1[2]));
        } else {
            z8 = (-(d));
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 1 {
        n10 += 1;
        if n10 % 2 == 0 {
            r1[2] =
                r1[2] - (((y - r4[0]) + (x - r4[(n10 * n10 + 1) % 3])) * S::from_f64(0.75)).sin();
            let mut u11: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u11.push((c + S::from_f64(0.125)).tanh());
            u11[0] = u11[1] * u11[u11.len() - 1];
            let b = (mixed(&u11) + u11[0]).tanh();
        }
    }
    ((c * c) - S::from_f64(-0.125_f64)).tanh() + c + z2 + d + y + x
}

#[differentiable]
fn program_21(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((x * f) * 0.75).sin(); 3];
    if (f - -0.625_f64).tanh() <= (x * 0.125_f64).cos() {
        let mut p2 = Pair { a: ((f * -0.625_f64).abs() * 0.75).sin(), b: (x * 0.75).sin() };
    } else {
        f = (((-(f)) * 0.125_f64).max(r1[1]) + 0.125).tanh();
    }
    r1[0] += (((x + 0.625_f64).sin() * (y * 0.375_f64).abs()) * 0.75).sin();
    r1[0] += (((x + f) * (-1.125_f64 - r1[2])) * 0.75).sin();
    let r3 = [((r1[1] * -0.875_f64) * 0.75).sin(); 5];
    let (a, mut b) = (((f * f + 0.25).sqrt() + 0.125).tanh(), (r1[2] * r1[2]));
    f += (x * 0.75).sin();
    let g4 = |t: f64| ((f * f + 0.25).sqrt() * -0.375_f64).max(a) * t;
    let d = (g4((f * a)) + g4((f + b))).sin();
    let b = mixed(&r3[1..]).sin();
    let (a, mut b) = (((-(b)) * 0.75).sin(), (r1[2] * 0.625_f64).max(y));
    if (y / (1.5 + r3[4] * r3[4])) <= (f - y) {
        let by5 = ((f - 0.625_f64).tanh() * 0.75).sin();
        let d = shifted(&mut r1[1..], by5);
        #[differentiable(checkpoint)]
        'l6: for i7 in (2..5_usize).rev() {
            let a = match shape(
                ((r3[(i7 * i7 + 1) % 5] * 0.375_f64).cos() * 0.75).sin(),
                ((x * ((i7 as f64) * 0.25)) + 0.125).tanh(),
            ) {
                Point => (r3[(i7 + 3) % 5] - -0.625_f64).tanh(),
                Disc(v) => ((-(x)) * 0.125_f64).abs(),
                Shape::Box { w: v, h } => ((h * -0.625_f64).max(r3[1]) + -0.875_f64).sin(),
            };
        }
        let k8 = (-(x));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k8).sin();
            part.reverse();
        }
    } else {
        r1[0] *= ((f * (a + y)) + 0.125).tanh();
    }
    (r1[1] * (d * -0.875_f64).abs()) + b + a + d + f + y + x
}

fn program_21_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * f) * S::from_f64(0.75)).sin(); 3];
    if (f - S::from_f64(-0.625_f64)).tanh().cmple((x * S::from_f64(0.125_f64)).cos()) {
        let mut p2 = Pair {
            a: ((f * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
            b: (x * S::from_f64(0.75)).sin(),
        };
    } else {
        f = (((-(f)) * S::from_f64(0.125_f64)).max(r1[1]) + S::from_f64(0.125)).tanh();
    }
    r1[0] = r1[0]
        + (((x + S::from_f64(0.625_f64)).sin() * (y * S::from_f64(0.375_f64)).abs())
            * S::from_f64(0.75))
        .sin();
    r1[0] = r1[0] + (((x + f) * (S::from_f64(-1.125_f64) - r1[2])) * S::from_f64(0.75)).sin();
    let r3 = [((r1[1] * S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(); 5];
    let (a, mut b) =
        (((f * f + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(), (r1[2] * r1[2]));
    f = f + (x * S::from_f64(0.75)).sin();
    let g4 = |t: S| ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(-0.375_f64)).max(a) * t;
    let d = (g4((f * a)) + g4((f + b))).sin();
    let b = mixed(&r3[1..]).sin();
    let (a, mut b) = (((-(b)) * S::from_f64(0.75)).sin(), (r1[2] * S::from_f64(0.625_f64)).max(y));
    if (y / (S::from_f64(1.5) + r3[4] * r3[4])).cmple((f - y)) {
        let by5 = ((f - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        let d = shifted(&mut r1[1..], by5);

        'l6: for i7 in (2..5_usize).rev() {
            let a = match shape(
                ((r3[(i7 * i7 + 1) % 5] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
                ((x * (S::from_f64(i7 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
            ) {
                Point => (r3[(i7 + 3) % 5] - S::from_f64(-0.625_f64)).tanh(),
                Disc(v) => ((-(x)) * S::from_f64(0.125_f64)).abs(),
                Shape::Box { w: v, h } => {
                    ((h * S::from_f64(-0.625_f64)).max(r3[1]) + S::from_f64(-0.875_f64)).sin()
                }
            };
        }
        let k8 = (-(x));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k8).sin();
            part.reverse();
        }
    } else {
        r1[0] = r1[0] * ((f * (a + y)) + S::from_f64(0.125)).tanh();
    }
    (r1[1] * (d * S::from_f64(-0.875_f64)).abs()) + b + a + d + f + y + x
}

#[differentiable]
fn program_22(x: f64, y: f64) -> f64 {
    let mut d = ((y * y + 0.25).sqrt() + 0.125).tanh();
    let mut r1 =
        [((0.875_f64 / (1.5 + 0.625_f64 * 0.625_f64)) * 0.75).sin(), ((d + x) + 0.125).tanh()];
    let (a, mut b) = (((x / (1.5 + r1[0] * r1[0])) * 0.75).sin(), (x - 0.375_f64));
    d *= (((-(r1[1])) * (r1[0] + -0.125_f64).sin()) * 0.75).sin();
    let mut d = (r1[0] * 0.75).sin();
    let mut l2 =
        List(vec![(b + 0.125).tanh(), (0.625_f64 - d), ((x / (1.5 + x * x)) + 0.125).tanh()]);
    for i3 in 0..1_usize {
        l2 += &List(vec![
            ((r1[1] / (1.5 + d * d)) * 0.75).sin(),
            (x - -0.375_f64).tanh(),
            (r1[1] + 0.125).tanh(),
        ]);
        if r1[0] < (-(r1[1])) {
            continue;
        }
        l2 = &l2
            * &List(vec![
                ((r1[1] / (1.5 + d * d)) * 0.75).sin(),
                (x - -0.375_f64).tanh(),
                (r1[1] + 0.125).tanh(),
            ]);
    }
    let b = l2.total();
    let mut r4 = [
        ((0.625_f64 * 0.125_f64).abs() + 0.125).tanh(),
        ((x - 0.625_f64).tanh() + 0.125).tanh(),
        (r1[1] + 0.125).tanh(),
    ];
    if (r1[1] * -0.375_f64).max(d) < r4[0] {
        let mut f = ((b * r4[2]) + 0.125).tanh();
    }
    let k5 = b;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k5).sin();
        part.reverse();
    }
    'l6: for i7 in (2..3_usize).rev() {
        r4[(i7 * i7 + 1) % 3] =
            (((r4[(i7 * i7 + 1) % 3] * ((i7 as f64) * 0.25)) + -0.625_f64).sin() + 0.125).tanh();
    }
    'l8: for i9 in 0..=4_usize {
        d *= (((x + -1.125_f64).sin() + (a * a + 0.25).sqrt()) * 0.75).sin();
        let mut l10 = List(vec![
            ((r4[i9 % 3] + 0.625_f64).sin() * 0.75).sin(),
            (y * -0.375_f64).abs(),
            ((0.375_f64 * -0.375_f64).max(d) * 0.75).sin(),
        ]);
        for i11 in 0..1_usize {
            l10 += &List(vec![
                ((r4[(i9 + 1) % 3] * r4[(i9 + 1) % 3] + 0.25).sqrt() + 0.125).tanh(),
                (-(r4[i9 % 3])),
                ((b * b) * 0.75).sin(),
            ]);
            if i9 % 4 == 1 {
                continue;
            }
            l10 = l10
                + List(vec![
                    ((r4[(i9 + 1) % 3] * r4[(i9 + 1) % 3] + 0.25).sqrt() + 0.125).tanh(),
                    (-(r4[i9 % 3])),
                    ((b * b) * 0.75).sin(),
                ]) * ((((i9 as f64) * 0.25) + -0.625_f64).sin() * 0.75).sin();
        }
        let e = l10.total();
    }
    let mut u12: Vec<_> = r4.iter().map(|v| *v * y).collect();
    u12.push(((r4[0] + x) * 0.75).sin());
    u12[0] = u12[1] * u12[u12.len() - 1];
    let b = (mixed(&u12) + u12[0]).tanh();
    ((-(d)) * -0.875_f64).max(a) + b + d + a + y + x
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
    let (a, mut b) = (
        ((x / (S::from_f64(1.5) + r1[0] * r1[0])) * S::from_f64(0.75)).sin(),
        (x - S::from_f64(0.375_f64)),
    );
    d = d * (((-(r1[1])) * (r1[0] + S::from_f64(-0.125_f64)).sin()) * S::from_f64(0.75)).sin();
    let mut d = (r1[0] * S::from_f64(0.75)).sin();
    let mut l2 = List(vec![
        (b + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.625_f64) - d),
        ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
    ]);
    for i3 in 0..1_usize {
        l2 += &List(vec![
            ((r1[1] / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
            (x - S::from_f64(-0.375_f64)).tanh(),
            (r1[1] + S::from_f64(0.125)).tanh(),
        ]);
        if r1[0].cmplt((-(r1[1]))) {
            continue;
        }
        l2 = &l2
            * &List(vec![
                ((r1[1] / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
                (x - S::from_f64(-0.375_f64)).tanh(),
                (r1[1] + S::from_f64(0.125)).tanh(),
            ]);
    }
    let b = l2.total();
    let mut r4 = [
        ((S::from_f64(0.625_f64) * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
        (r1[1] + S::from_f64(0.125)).tanh(),
    ];
    if (r1[1] * S::from_f64(-0.375_f64)).max(d).cmplt(r4[0]) {
        let mut f = ((b * r4[2]) + S::from_f64(0.125)).tanh();
    }
    let k5 = b;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k5).sin();
        part.reverse();
    }
    'l6: for i7 in (2..3_usize).rev() {
        r4[(i7 * i7 + 1) % 3] = (((r4[(i7 * i7 + 1) % 3]
            * (S::from_f64(i7 as f64) * S::from_f64(0.25)))
            + S::from_f64(-0.625_f64))
        .sin()
            + S::from_f64(0.125))
        .tanh();
    }
    'l8: for i9 in 0..=4_usize {
        d = d
            * (((x + S::from_f64(-1.125_f64)).sin() + (a * a + S::from_f64(0.25)).sqrt())
                * S::from_f64(0.75))
            .sin();
        let mut l10 = List(vec![
            ((r4[i9 % 3] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
            (y * S::from_f64(-0.375_f64)).abs(),
            ((S::from_f64(0.375_f64) * S::from_f64(-0.375_f64)).max(d) * S::from_f64(0.75)).sin(),
        ]);
        for i11 in 0..1_usize {
            l10 += &List(vec![
                ((r4[(i9 + 1) % 3] * r4[(i9 + 1) % 3] + S::from_f64(0.25)).sqrt()
                    + S::from_f64(0.125))
                .tanh(),
                (-(r4[i9 % 3])),
                ((b * b) * S::from_f64(0.75)).sin(),
            ]);
            if i9 % 4 == 1 {
                continue;
            }
            l10 = l10
                + List(vec![
                    ((r4[(i9 + 1) % 3] * r4[(i9 + 1) % 3] + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.125))
                    .tanh(),
                    (-(r4[i9 % 3])),
                    ((b * b) * S::from_f64(0.75)).sin(),
                ]) * (((S::from_f64(i9 as f64) * S::from_f64(0.25)) + S::from_f64(-0.625_f64))
                    .sin()
                    * S::from_f64(0.75))
                .sin();
        }
        let e = l10.total();
    }
    let mut u12: Vec<_> = r4.iter().map(|v| *v * y).collect();
    u12.push(((r4[0] + x) * S::from_f64(0.75)).sin());
    u12[0] = u12[1] * u12[u12.len() - 1];
    let b = (mixed(&u12) + u12[0]).tanh();
    ((-(d)) * S::from_f64(-0.875_f64)).max(a) + b + d + a + y + x
}

#[differentiable]
fn program_23(x: f64, y: f64) -> f64 {
    let mut f = ((y - y) + 0.125).tanh();
    let mut r1 = [((f - f) + 0.125).tanh(); 5];
    let mut p2 = Pair { a: ((y * x) + 0.125).tanh(), b: ((y * 0.375_f64).cos() + 0.125).tanh() };
    'l3: for i4 in (1..0_usize).rev() {
        if (-0.125_f64 * -0.875_f64).max(0.625_f64) < (p2.b * 0.125_f64) {
            r1[(i4 * i4 + 1) % 5] -= (((i4 as f64) * 0.25) + 0.125).tanh();
            r1[i4 % 5] = (((0.375_f64 + f) * (0.875_f64 * p2.a)) * 0.75).sin();
            let b = summed(
                |t: f64| (r1[(i4 * i4 + 1) % 5] * t).sin(),
                ((x * -0.625_f64).cos() + 0.125).tanh(),
                2,
            )
            .tanh();
        }
        if (r1[0] + r1[(i4 + 1) % 5]) > (-(p2.b)) {
            let mut n6 = 0_usize;
            'l5: while n6 < 3 {
                n6 += 1;
                let mut u7 = r1.to_vec();
                u7.push(((((i4 as f64) * 0.25) * -0.125_f64).cos() + 0.125).tanh());
                u7[0] = u7[1] * u7[u7.len() - 1];
                let d = (mixed(&u7) + u7[0]).tanh();
                f *= ((d - -0.625_f64).tanh() + 0.125).tanh();
                let b = ((-(r1[(n6 * n6 + 1) % 5])) * (-(r1[(n6 * n6 + 1) % 5])) + 0.25).sqrt();
            }
            let g8 = |t: f64| ((i4 as f64) * 0.25) * t;
            let c = (g8((r1[4] * r1[i4 % 5])) + g8((x * 0.125_f64).max(y))).sin();
            let b = mixed(&r1[..4]).sin();
        } else {
            f += (((r1[1] + r1[2]) * (x * r1[2])) * 0.75).sin();
            let f = List(vec![
                ((x * p2.b) * 0.75).sin(),
                (r1[i4 % 5] + r1[1]),
                ((x * r1[1]) * 0.75).sin(),
            ])
            .folded(((y * r1[i4 % 5]) * 0.75).sin(), |s, v| {
                (s * v + (r1[(i4 * i4 + 1) % 5] * r1[i4 % 5])).sin()
            });
        }
    }
    ((-(r1[0])) * -0.125_f64).cos() + f + y + x
}

fn program_23_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((f - f) + S::from_f64(0.125)).tanh(); 5];
    let mut p2 = Pair {
        a: ((y * x) + S::from_f64(0.125)).tanh(),
        b: ((y * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    'l3: for i4 in (1..0_usize).rev() {
        if (S::from_f64(-0.125_f64) * S::from_f64(-0.875_f64))
            .max(S::from_f64(0.625_f64))
            .cmplt((p2.b * S::from_f64(0.125_f64)))
        {
            r1[(i4 * i4 + 1) % 5] = r1[(i4 * i4 + 1) % 5]
                - ((S::from_f64(i4 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
            r1[i4 % 5] = (((S::from_f64(0.375_f64) + f) * (S::from_f64(0.875_f64) * p2.a))
                * S::from_f64(0.75))
            .sin();
            let b = summed(
                |t: S| (r1[(i4 * i4 + 1) % 5] * t).sin(),
                ((x * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
                2,
            )
            .tanh();
        }
        if (r1[0] + r1[(i4 + 1) % 5]).cmpgt((-(p2.b))) {
            let mut n6 = 0_usize;
            'l5: while n6 < 3 {
                n6 += 1;
                let mut u7 = r1.to_vec();
                u7.push(
                    (((S::from_f64(i4 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                        .cos()
                        + S::from_f64(0.125))
                    .tanh(),
                );
                u7[0] = u7[1] * u7[u7.len() - 1];
                let d = (mixed(&u7) + u7[0]).tanh();
                f = f * ((d - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
                let b = ((-(r1[(n6 * n6 + 1) % 5])) * (-(r1[(n6 * n6 + 1) % 5]))
                    + S::from_f64(0.25))
                .sqrt();
            }
            let g8 = |t: S| (S::from_f64(i4 as f64) * S::from_f64(0.25)) * t;
            let c = (g8((r1[4] * r1[i4 % 5])) + g8((x * S::from_f64(0.125_f64)).max(y))).sin();
            let b = mixed(&r1[..4]).sin();
        } else {
            f = f + (((r1[1] + r1[2]) * (x * r1[2])) * S::from_f64(0.75)).sin();
            let f = List(vec![
                ((x * p2.b) * S::from_f64(0.75)).sin(),
                (r1[i4 % 5] + r1[1]),
                ((x * r1[1]) * S::from_f64(0.75)).sin(),
            ])
            .folded(((y * r1[i4 % 5]) * S::from_f64(0.75)).sin(), |s, v| {
                (s * v + (r1[(i4 * i4 + 1) % 5] * r1[i4 % 5])).sin()
            });
        }
    }
    ((-(r1[0])) * S::from_f64(-0.125_f64)).cos() + f + y + x
}

#[differentiable]
fn program_24(x: f64, y: f64) -> f64 {
    let mut a = ((x - 0.375_f64).tanh() * 0.75).sin();
    let mut r1 = [((a + y) * 0.75).sin(), (a * 0.75).sin()];
    let by2 = ((y * 0.875_f64).cos() * 0.75).sin();
    let d = shifted(&mut r1[0..], by2);
    let mut l3 = List(vec![((-(x)) + 0.125).tanh(), (y * r1[0]), ((-(a)) + 0.125).tanh()]);
    for i4 in 0..0_usize {
        l3 += &List(vec![((r1[0] + a) * 0.75).sin(), d, (r1[0] + 0.125).tanh()]);
        if (r1[0] - 0.875_f64).tanh() > (r1[0] * r1[0] + 0.25).sqrt() {
            continue;
        }
        l3 = &l3 * &List(vec![((r1[0] + a) * 0.75).sin(), d, (r1[0] + 0.125).tanh()]);
    }
    let d = l3.total();
    r1[0] = (((x / (1.5 + d * d)) + (r1[1] * a)) + 0.125).tanh();
    if (d + -0.375_f64).sin() >= (r1[1] * r1[1]) {
        let mut p5 = Pair { a: ((d / (1.5 + y * y)) * 0.75).sin(), b: ((x * a) + 0.125).tanh() };
    }
    a += (((d * d + 0.25).sqrt() - (-1.125_f64 * -1.125_f64 + 0.25).sqrt()) * 0.75).sin();
    let f = match shape(
        ((-(a)) + 0.125).tanh(),
        ((-1.125_f64 * -1.125_f64 + 0.25).sqrt() * 0.75).sin(),
    ) {
        Point => (-(x)),
        Disc(v) => (d * d + 0.25).sqrt(),
        Shape::Box { w: v, h } => ((h * h) - (r1[1] + 0.625_f64).sin()),
    };
    let mut p6 = Pair {
        a: ((r1[0] + -0.625_f64).sin() + 0.125).tanh(),
        b: ((d * -0.375_f64).max(f) * 0.75).sin(),
    };
    let by7 = ((f * 0.125_f64).cos() * 0.75).sin();
    let e = shifted(&mut r1[1..], by7);
    let mut u8 = r1.to_vec();
    u8.push(((p6.b * r1[0]) + 0.125).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let d = (mixed(&u8) + u8[0]).tanh();
    a -= (((r1[1] * r1[1] + 0.25).sqrt() * (r1[1] * d)) * 0.75).sin();
    let (a, mut b) = (((-0.125_f64 - 0.375_f64).tanh() * 0.75).sin(), (-(r1[1])));
    let a = match roots((b + 0.875_f64).sin(), (p6.a * e)) {
        Ok(v) => ((y - r1[1]) * 0.875_f64).cos(),
        Err(true) => b,
        Err(_) => r1[0],
    };
    let c = p6.dot(&p6).sin();
    ((p6.a * a) + 0.625_f64).sin() + c + a + b + d + e + f + y + x
}

fn program_24_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((a + y) * S::from_f64(0.75)).sin(), (a * S::from_f64(0.75)).sin()];
    let by2 = ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let d = shifted(&mut r1[0..], by2);
    let mut l3 = List(vec![
        ((-(x)) + S::from_f64(0.125)).tanh(),
        (y * r1[0]),
        ((-(a)) + S::from_f64(0.125)).tanh(),
    ]);
    for i4 in 0..0_usize {
        l3 += &List(vec![
            ((r1[0] + a) * S::from_f64(0.75)).sin(),
            d,
            (r1[0] + S::from_f64(0.125)).tanh(),
        ]);
        if (r1[0] - S::from_f64(0.875_f64)).tanh().cmpgt((r1[0] * r1[0] + S::from_f64(0.25)).sqrt())
        {
            continue;
        }
        l3 = &l3
            * &List(vec![
                ((r1[0] + a) * S::from_f64(0.75)).sin(),
                d,
                (r1[0] + S::from_f64(0.125)).tanh(),
            ]);
    }
    let d = l3.total();
    r1[0] = (((x / (S::from_f64(1.5) + d * d)) + (r1[1] * a)) + S::from_f64(0.125)).tanh();
    if (d + S::from_f64(-0.375_f64)).sin().cmpge((r1[1] * r1[1])) {
        let mut p5 = Pair {
            a: ((d / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
            b: ((x * a) + S::from_f64(0.125)).tanh(),
        };
    }
    a = a
        + (((d * d + S::from_f64(0.25)).sqrt()
            - (S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt())
            * S::from_f64(0.75))
        .sin();
    let f = match shape(
        ((-(a)) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
    ) {
        Point => (-(x)),
        Disc(v) => (d * d + S::from_f64(0.25)).sqrt(),
        Shape::Box { w: v, h } => ((h * h) - (r1[1] + S::from_f64(0.625_f64)).sin()),
    };
    let mut p6 = Pair {
        a: ((r1[0] + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((d * S::from_f64(-0.375_f64)).max(f) * S::from_f64(0.75)).sin(),
    };
    let by7 = ((f * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin();
    let e = shifted(&mut r1[1..], by7);
    let mut u8 = r1.to_vec();
    u8.push(((p6.b * r1[0]) + S::from_f64(0.125)).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let d = (mixed(&u8) + u8[0]).tanh();
    a = a - (((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * (r1[1] * d)) * S::from_f64(0.75)).sin();
    let (a, mut b) = (
        ((S::from_f64(-0.125_f64) - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        (-(r1[1])),
    );
    let a = match roots((b + S::from_f64(0.875_f64)).sin(), (p6.a * e)) {
        Ok(v) => ((y - r1[1]) * S::from_f64(0.875_f64)).cos(),
        Err(true) => b,
        Err(_) => r1[0],
    };
    let c = p6.dot(&p6).sin();
    ((p6.a * a) + S::from_f64(0.625_f64)).sin() + c + a + b + d + e + f + y + x
}

#[differentiable]
fn program_25(x: f64, y: f64) -> f64 {
    let mut e = ((x * -1.125_f64) + 0.125).tanh();
    let r1 = [((y * -1.125_f64).abs() + 0.125).tanh(); 2];
    let d = root((y * y + 0.25).sqrt()).map_or((y / (1.5 + e * e)), |v| (y - (r1[0] + r1[0])));
    'l2: for i3 in 1..=2_usize {
        let d = match shape(
            ((d + 0.625_f64).sin() + 0.125).tanh(),
            ((-((i3 as f64) * 0.25)) + 0.125).tanh(),
        ) {
            Shape::Point => (r1[i3 % 2] * -0.375_f64),
            Shape::Disc(v) => (e / (1.5 + (r1[i3 % 2] + r1[0]) * (r1[i3 % 2] + r1[0]))),
            Shape::Box { w: v, h } => ((((i3 as f64) * 0.25) * -0.875_f64).cos() * 0.125_f64).cos(),
        };
    }
    for v in r1.iter().cycle().take(0) {
        e = (e + *v).sin();
    }
    let mut p4 = Pair { a: ((y * -0.375_f64).cos() * 0.75).sin(), b: ((r1[0] * y) * 0.75).sin() };
    let b = mixed(&r1).sin();
    let (a, mut b) = ((x * 0.75).sin(), (r1[0] * r1[0]));
    b = (((x / (1.5 + p4.a * p4.a)) * 0.625_f64).abs() + 0.125).tanh();
    let mut p5 =
        Pair { a: ((a + x) + 0.125).tanh(), b: ((b * -1.125_f64).max(r1[1]) + 0.125).tanh() };
    let mut p6 = Pair { a: ((d + -0.625_f64).sin() * 0.75).sin(), b: ((e * a) + 0.125).tanh() };
    let d = mixed(&r1).sin();
    let mut b = ((e * p5.b) * 0.75).sin();
    for v in r1.iter() {
        e = e * ((r1[1] - r1[1]) * 0.75).sin() + *v * ((r1[1] - r1[1]) * 0.75).sin();
    }
    'l7: for i8 in (1..5_usize).step_by(2) {
        #[differentiable(checkpoint)]
        'l9: for i10 in (i8..5_usize).step_by(2) {
            'l11: for i12 in 1..0_usize {
                b = (((((i8 as f64) * 0.25) + p4.b) * (d + r1[i10 % 2])) + 0.125).tanh();
            }
        }
        let r13 = [
            ((r1[(i8 * i8 + 1) % 2] - -1.125_f64).tanh() + 0.125).tanh(),
            ((r1[0] * p4.a) + 0.125).tanh(),
            ((r1[i8 % 2] + r1[(i8 + 1) % 2]) + 0.125).tanh(),
        ];
    }
    b + b + d + a + e + y + x
}

fn program_25_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(); 2];
    let d = root((y * y + S::from_f64(0.25)).sqrt())
        .map_or((y / (S::from_f64(1.5) + e * e)), |v| (y - (r1[0] + r1[0])));
    'l2: for i3 in 1..=2_usize {
        let d = match shape(
            ((d + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
            ((-(S::from_f64(i3 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
        ) {
            Shape::Point => (r1[i3 % 2] * S::from_f64(-0.375_f64)),
            Shape::Disc(v) => {
                (e / (S::from_f64(1.5) + (r1[i3 % 2] + r1[0]) * (r1[i3 % 2] + r1[0])))
            }
            Shape::Box { w: v, h } => {
                (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.875_f64)).cos()
                    * S::from_f64(0.125_f64))
                .cos()
            }
        };
    }
    for v in r1.iter().cycle().take(0) {
        e = (e + *v).sin();
    }
    let mut p4 = Pair {
        a: ((y * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((r1[0] * y) * S::from_f64(0.75)).sin(),
    };
    let b = mixed(&r1).sin();
    let (a, mut b) = ((x * S::from_f64(0.75)).sin(), (r1[0] * r1[0]));
    b = (((x / (S::from_f64(1.5) + p4.a * p4.a)) * S::from_f64(0.625_f64)).abs()
        + S::from_f64(0.125))
    .tanh();
    let mut p5 = Pair {
        a: ((a + x) + S::from_f64(0.125)).tanh(),
        b: ((b * S::from_f64(-1.125_f64)).max(r1[1]) + S::from_f64(0.125)).tanh(),
    };
    let mut p6 = Pair {
        a: ((d + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        b: ((e * a) + S::from_f64(0.125)).tanh(),
    };
    let d = mixed(&r1).sin();
    let mut b = ((e * p5.b) * S::from_f64(0.75)).sin();
    for v in r1.iter() {
        e = e * ((r1[1] - r1[1]) * S::from_f64(0.75)).sin()
            + *v * ((r1[1] - r1[1]) * S::from_f64(0.75)).sin();
    }
    'l7: for i8 in (1..5_usize).step_by(2) {
        'l9: for i10 in (i8..5_usize).step_by(2) {
            'l11: for i12 in 1..0_usize {
                b = ((((S::from_f64(i8 as f64) * S::from_f64(0.25)) + p4.b) * (d + r1[i10 % 2]))
                    + S::from_f64(0.125))
                .tanh();
            }
        }
        let r13 = [
            ((r1[(i8 * i8 + 1) % 2] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            ((r1[0] * p4.a) + S::from_f64(0.125)).tanh(),
            ((r1[i8 % 2] + r1[(i8 + 1) % 2]) + S::from_f64(0.125)).tanh(),
        ];
    }
    b + b + d + a + e + y + x
}

#[differentiable]
fn program_26(x: f64, y: f64) -> f64 {
    let mut a = ((-0.125_f64 * -0.125_f64 + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [((a * -1.125_f64).cos() * 0.75).sin(); 5];
    r1[2] *= ((r1[0] + (a * 0.875_f64).cos()) * 0.75).sin();
    'l2: for i3 in (1..3_usize).rev() {
        let l4 = List(vec![
            ((-(r1[i3 % 5])) + 0.125).tanh(),
            (a * -0.375_f64).max(r1[3]),
            ((y - x) + 0.125).tanh(),
        ]);
        let m5 = &l4
            * &List(vec![
                ((a * -0.375_f64).abs() + 0.125).tanh(),
                (r1[(i3 + 0) % 5] * y),
                ((x + r1[1]) + 0.125).tanh(),
            ]);
        let d = ((-&m5 + l4).total()).tanh();
        let a = a;
        if (r1[(i3 * i3 + 1) % 5] * x) >= x {
            break;
        }
    }
    let f = summed(bent, ((a + r1[3]) * 0.75).sin(), 3).tanh();
    let mut l6 =
        List(vec![((-(a)) * 0.75).sin(), (0.375_f64 - -0.875_f64).tanh(), ((f * x) * 0.75).sin()]);
    for i7 in 0..1_usize {
        l6 += &List(vec![
            ((x * 0.625_f64).cos() + 0.125).tanh(),
            (r1[2] * -1.125_f64).abs(),
            ((f * -0.125_f64).abs() * 0.75).sin(),
        ]);
        if (f * a) <= (f * -0.375_f64) {
            continue;
        }
        l6 = &l6
            * &List(vec![
                ((x * 0.625_f64).cos() + 0.125).tanh(),
                (r1[2] * -1.125_f64).abs(),
                ((f * -0.125_f64).abs() * 0.75).sin(),
            ]);
    }
    let d = l6.total();
    for v in r1.iter() {
        a = a * ((x - f) * 0.75).sin() + *v * ((x - f) * 0.75).sin();
    }
    a = (x * 0.75).sin();
    r1[1] = (((r1[3] * f) - -0.875_f64).tanh() + 0.125).tanh();
    let mut p8 = Pair {
        a: ((r1[3] + -0.375_f64).sin() + 0.125).tanh(),
        b: ((r1[3] + -0.875_f64) + 0.125).tanh(),
    };
    let (a, mut b) = (((r1[3] / (1.5 + r1[3] * r1[3])) + 0.125).tanh(), (r1[2] * -0.625_f64).cos());
    b += ((p8.b - -1.125_f64).tanh() + 0.125).tanh();
    r1[0] *= (((0.625_f64 * p8.b) - (-1.125_f64 + d)) * 0.75).sin();
    ((0.375_f64 + 0.125_f64).sin() - (f * -0.375_f64).max(r1[2])) + b + a + d + f + y + x
}

fn program_26_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.125))
    .tanh();
    let mut r1 = [((a * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(); 5];
    r1[2] = r1[2] * ((r1[0] + (a * S::from_f64(0.875_f64)).cos()) * S::from_f64(0.75)).sin();
    'l2: for i3 in (1..3_usize).rev() {
        let l4 = List(vec![
            ((-(r1[i3 % 5])) + S::from_f64(0.125)).tanh(),
            (a * S::from_f64(-0.375_f64)).max(r1[3]),
            ((y - x) + S::from_f64(0.125)).tanh(),
        ]);
        let m5 = &l4
            * &List(vec![
                ((a * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
                (r1[(i3 + 0) % 5] * y),
                ((x + r1[1]) + S::from_f64(0.125)).tanh(),
            ]);
        let d = ((-&m5 + l4).total()).tanh();
        let a = a;
        if (r1[(i3 * i3 + 1) % 5] * x).cmpge(x) {
            break;
        }
    }
    let f = summed(bent, ((a + r1[3]) * S::from_f64(0.75)).sin(), 3).tanh();
    let mut l6 = List(vec![
        ((-(a)) * S::from_f64(0.75)).sin(),
        (S::from_f64(0.375_f64) - S::from_f64(-0.875_f64)).tanh(),
        ((f * x) * S::from_f64(0.75)).sin(),
    ]);
    for i7 in 0..1_usize {
        l6 += &List(vec![
            ((x * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
            (r1[2] * S::from_f64(-1.125_f64)).abs(),
            ((f * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ]);
        if (f * a).cmple((f * S::from_f64(-0.375_f64))) {
            continue;
        }
        l6 = &l6
            * &List(vec![
                ((x * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
                (r1[2] * S::from_f64(-1.125_f64)).abs(),
                ((f * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
            ]);
    }
    let d = l6.total();
    for v in r1.iter() {
        a = a * ((x - f) * S::from_f64(0.75)).sin() + *v * ((x - f) * S::from_f64(0.75)).sin();
    }
    a = (x * S::from_f64(0.75)).sin();
    r1[1] = (((r1[3] * f) - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut p8 = Pair {
        a: ((r1[3] + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((r1[3] + S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
    };
    let (a, mut b) = (
        ((r1[3] / (S::from_f64(1.5) + r1[3] * r1[3])) + S::from_f64(0.125)).tanh(),
        (r1[2] * S::from_f64(-0.625_f64)).cos(),
    );
    b = b + ((p8.b - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    r1[0] = r1[0]
        * (((S::from_f64(0.625_f64) * p8.b) - (S::from_f64(-1.125_f64) + d)) * S::from_f64(0.75))
            .sin();
    ((S::from_f64(0.375_f64) + S::from_f64(0.125_f64)).sin()
        - (f * S::from_f64(-0.375_f64)).max(r1[2]))
        + b
        + a
        + d
        + f
        + y
        + x
}

#[differentiable]
fn program_27(x: f64, y: f64) -> f64 {
    let mut e = (y + 0.125).tanh();
    let r1 = [((e * e) * 0.75).sin(); 3];
    let a = root((x + r1[0])).map_or(e, |v| -0.625_f64);
    for v in r1.iter().cycle().take(8) {
        e = (e + *v).sin();
    }
    let mut e = (y * 0.75).sin();
    'l2: for i3 in 2..0_usize {
        'l4: for i5 in (2..4_usize).step_by(2) {
            let mut n7 = 0_usize;
            'l6: while n7 < 3 {
                n7 += 1;
                let d =
                    match shape(((e - y) + 0.125).tanh(), ((x * x + 0.25).sqrt() + 0.125).tanh()) {
                        Point => (a + e),
                        Disc(v) => (-((r1[0] * r1[0] + 0.25).sqrt())),
                        Shape::Box { w: v, h } => ((a - r1[0]) + (v * ((i3 as f64) * 0.25))),
                    };
                let mut l8 = List(vec![
                    ((r1[1] * 0.625_f64) * 0.75).sin(),
                    (r1[(i3 * i3 + 1) % 3] * ((n7 as f64) * 0.25)),
                    ((r1[2] * r1[(n7 + 2) % 3]) + 0.125).tanh(),
                ]);
                for i9 in 0..0_usize {
                    l8 += &List(vec![
                        ((x * 0.875_f64).cos() + 0.125).tanh(),
                        x,
                        ((d + x) + 0.125).tanh(),
                    ]);
                    if (a + r1[(i3 + 1) % 3]) <= (a / (1.5 + r1[(i5 + 1) % 3] * r1[(i5 + 1) % 3])) {
                        continue;
                    }
                    l8 = &l8
                        * &List(vec![
                            ((x * 0.875_f64).cos() + 0.125).tanh(),
                            x,
                            ((d + x) + 0.125).tanh(),
                        ]);
                }
                let a = l8.total();
            }
            let r10 = [((r1[i3 % 3] / (1.5 + a * a)) + 0.125).tanh(); 4];
        }
        let mut l11 = List(vec![(e * 0.75).sin(), y, ((r1[0] * -1.125_f64).abs() * 0.75).sin()]);
        for i12 in 0..2_usize {
            l11 += &List(vec![
                ((r1[i3 % 3] + e) * 0.75).sin(),
                (-1.125_f64 * 0.875_f64).max(x),
                ((r1[1] * r1[i3 % 3]) + 0.125).tanh(),
            ]);
            if (a + r1[2]) >= (e / (1.5 + y * y)) {
                continue;
            }
            l11 = l11
                + List(vec![
                    ((r1[i3 % 3] + e) * 0.75).sin(),
                    (-1.125_f64 * 0.875_f64).max(x),
                    ((r1[1] * r1[i3 % 3]) + 0.125).tanh(),
                ]) * ((x * -0.375_f64).cos() * 0.75).sin();
        }
        let a = l11.total();
    }
    e -= (y * 0.75).sin();
    let mut r13 = [
        ((r1[0] - -0.875_f64).tanh() + 0.125).tanh(),
        ((e * e + 0.25).sqrt() * 0.75).sin(),
        ((r1[1] * 0.125_f64).abs() + 0.125).tanh(),
        ((-(a)) + 0.125).tanh(),
    ];
    let mut n15 = 0_usize;
    'l14: while n15 < 4 {
        n15 += 1;
        let by16 = (e + 0.125).tanh();
        let e = shifted(&mut r13[1..], by16);
        let k17 = (r1[1] * e);
        for part in r13.chunks_exact_mut(2) {
            part[0] = (part[0] * k17).sin();
            part.reverse();
        }
    }
    ((r13[0] * -0.125_f64) + (r13[3] * y)) + e + a + y + x
}

fn program_27_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (y + S::from_f64(0.125)).tanh();
    let r1 = [((e * e) * S::from_f64(0.75)).sin(); 3];
    let a = root((x + r1[0])).map_or(e, |v| S::from_f64(-0.625_f64));
    for v in r1.iter().cycle().take(8) {
        e = (e + *v).sin();
    }
    let mut e = (y * S::from_f64(0.75)).sin();
    'l2: for i3 in 2..0_usize {
        'l4: for i5 in (2..4_usize).step_by(2) {
            let mut n7 = 0_usize;
            'l6: while n7 < 3 {
                n7 += 1;
                let d = match shape(
                    ((e - y) + S::from_f64(0.125)).tanh(),
                    ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
                ) {
                    Point => (a + e),
                    Disc(v) => (-((r1[0] * r1[0] + S::from_f64(0.25)).sqrt())),
                    Shape::Box { w: v, h } => {
                        ((a - r1[0]) + (v * (S::from_f64(i3 as f64) * S::from_f64(0.25))))
                    }
                };
                let mut l8 = List(vec![
                    ((r1[1] * S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
                    (r1[(i3 * i3 + 1) % 3] * (S::from_f64(n7 as f64) * S::from_f64(0.25))),
                    ((r1[2] * r1[(n7 + 2) % 3]) + S::from_f64(0.125)).tanh(),
                ]);
                for i9 in 0..0_usize {
                    l8 += &List(vec![
                        ((x * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
                        x,
                        ((d + x) + S::from_f64(0.125)).tanh(),
                    ]);
                    if (a + r1[(i3 + 1) % 3])
                        .cmple((a / (S::from_f64(1.5) + r1[(i5 + 1) % 3] * r1[(i5 + 1) % 3])))
                    {
                        continue;
                    }
                    l8 = &l8
                        * &List(vec![
                            ((x * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
                            x,
                            ((d + x) + S::from_f64(0.125)).tanh(),
                        ]);
                }
                let a = l8.total();
            }
            let r10 = [((r1[i3 % 3] / (S::from_f64(1.5) + a * a)) + S::from_f64(0.125)).tanh(); 4];
        }
        let mut l11 = List(vec![
            (e * S::from_f64(0.75)).sin(),
            y,
            ((r1[0] * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ]);
        for i12 in 0..2_usize {
            l11 += &List(vec![
                ((r1[i3 % 3] + e) * S::from_f64(0.75)).sin(),
                (S::from_f64(-1.125_f64) * S::from_f64(0.875_f64)).max(x),
                ((r1[1] * r1[i3 % 3]) + S::from_f64(0.125)).tanh(),
            ]);
            if (a + r1[2]).cmpge((e / (S::from_f64(1.5) + y * y))) {
                continue;
            }
            l11 = l11
                + List(vec![
                    ((r1[i3 % 3] + e) * S::from_f64(0.75)).sin(),
                    (S::from_f64(-1.125_f64) * S::from_f64(0.875_f64)).max(x),
                    ((r1[1] * r1[i3 % 3]) + S::from_f64(0.125)).tanh(),
                ]) * ((x * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin();
        }
        let a = l11.total();
    }
    e = e - (y * S::from_f64(0.75)).sin();
    let mut r13 = [
        ((r1[0] - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((-(a)) + S::from_f64(0.125)).tanh(),
    ];
    let mut n15 = 0_usize;
    'l14: while n15 < 4 {
        n15 += 1;
        let by16 = (e + S::from_f64(0.125)).tanh();
        let e = shifted(&mut r13[1..], by16);
        let k17 = (r1[1] * e);
        for part in r13.chunks_exact_mut(2) {
            part[0] = (part[0] * k17).sin();
            part.reverse();
        }
    }
    ((r13[0] * S::from_f64(-0.125_f64)) + (r13[3] * y)) + e + a + y + x
}

#[differentiable]
fn program_28(x: f64, y: f64) -> f64 {
    let mut f = (y + 0.125).tanh();
    let mut r1 = [((x * -0.625_f64).max(x) + 0.125).tanh(); 2];
    let b = r1[0];
    let mut p2 =
        Pair { a: ((x / (1.5 + x * x)) + 0.125).tanh(), b: ((0.875_f64 * x) + 0.125).tanh() };
    f *= (((r1[0] + -0.375_f64).sin() * 0.375_f64).abs() * 0.75).sin();
    let d = match roots(r1[0], (-0.125_f64 * r1[1])) {
        Ok(v) => ((v * v + 0.25).sqrt() * 0.875_f64).cos(),
        Err(true) => r1[1],
        Err(_) => (r1[0] * f),
    };
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let f = match shape(((x * 0.375_f64).max(y) * 0.75).sin(), ((r1[1] * 0.875_f64) + 0.125).tanh())
    {
        Point => (x * -0.125_f64).cos(),
        Disc(v) => ((-0.375_f64 - r1[1]) * -0.375_f64).abs(),
        Shape::Box { w: v, h } => ((-0.125_f64 - h) * x),
    };
    let by3 = ((d * 0.875_f64).cos() + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    let l4 = List(vec![(x * 0.75).sin(), d, (b * 0.75).sin()]);
    let m5 = &l4
        * &List(vec![(y + 0.125).tanh(), (r1[1] / (1.5 + r1[1] * r1[1])), ((-(b)) + 0.125).tanh()]);
    let a = ((m5 * l4.total()).total()).tanh();
    let a =
        program_6(((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin(), ((0.625_f64 + r1[0]) * 0.75).sin())
            .tanh();
    r1[0] = (((-(r1[0])) - (f * r1[0])) * 0.75).sin();
    'l6: for i7 in 0..5_usize {
        let mut e = ((d + -1.125_f64).sin() + 0.125).tanh();
    }
    let f = match roots((x - p2.b), (x - a)) {
        Ok(v) => ((r1[0] - -0.375_f64).tanh() * (r1[1] + y)),
        Err(true) => a,
        Err(_) => (r1[1] - y),
    };
    let b = b;
    ((-(p2.b)) * -0.625_f64).abs() + b + f + a + d + y + x
}

fn program_28_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (y + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * S::from_f64(-0.625_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    let b = r1[0];
    let mut p2 = Pair {
        a: ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        b: ((S::from_f64(0.875_f64) * x) + S::from_f64(0.125)).tanh(),
    };
    f = f
        * (((r1[0] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.375_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    let d = match roots(r1[0], (S::from_f64(-0.125_f64) * r1[1])) {
        Ok(v) => ((v * v + S::from_f64(0.25)).sqrt() * S::from_f64(0.875_f64)).cos(),
        Err(true) => r1[1],
        Err(_) => (r1[0] * f),
    };
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let f = match shape(
        ((x * S::from_f64(0.375_f64)).max(y) * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh(),
    ) {
        Point => (x * S::from_f64(-0.125_f64)).cos(),
        Disc(v) => ((S::from_f64(-0.375_f64) - r1[1]) * S::from_f64(-0.375_f64)).abs(),
        Shape::Box { w: v, h } => ((S::from_f64(-0.125_f64) - h) * x),
    };
    let by3 = ((d * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    let l4 = List(vec![(x * S::from_f64(0.75)).sin(), d, (b * S::from_f64(0.75)).sin()]);
    let m5 = &l4
        * &List(vec![
            (y + S::from_f64(0.125)).tanh(),
            (r1[1] / (S::from_f64(1.5) + r1[1] * r1[1])),
            ((-(b)) + S::from_f64(0.125)).tanh(),
        ]);
    let a = ((m5 * l4.total()).total()).tanh();
    let a = program_6_of(
        ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.625_f64) + r1[0]) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    r1[0] = (((-(r1[0])) - (f * r1[0])) * S::from_f64(0.75)).sin();
    'l6: for i7 in 0..5_usize {
        let mut e = ((d + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh();
    }
    let f = match roots((x - p2.b), (x - a)) {
        Ok(v) => ((r1[0] - S::from_f64(-0.375_f64)).tanh() * (r1[1] + y)),
        Err(true) => a,
        Err(_) => (r1[1] - y),
    };
    let b = b;
    ((-(p2.b)) * S::from_f64(-0.625_f64)).abs() + b + f + a + d + y + x
}

#[differentiable]
fn program_29(x: f64, y: f64) -> f64 {
    let mut d = ((x * x) * 0.75).sin();
    let r1 = [
        ((d + -1.125_f64).sin() * 0.75).sin(),
        ((x * 0.625_f64).max(d) * 0.75).sin(),
        ((y + 0.125_f64).sin() * 0.75).sin(),
    ];
    if (d * -0.875_f64).cos() >= (d * -1.125_f64).abs() {
        let mut l2 =
            List(vec![((y * -0.875_f64).max(y) + 0.125).tanh(), (x * x), ((d - y) + 0.125).tanh()]);
        for i3 in 0..4_usize {
            l2 += &List(vec![
                ((y / (1.5 + d * d)) + 0.125).tanh(),
                (x * x + 0.25).sqrt(),
                ((-0.875_f64 + r1[1]) + 0.125).tanh(),
            ]);
            if (d * d + 0.25).sqrt() < (x * -1.125_f64).max(r1[0]) {
                continue;
            }
            l2 = l2
                + List(vec![
                    ((y / (1.5 + d * d)) + 0.125).tanh(),
                    (x * x + 0.25).sqrt(),
                    ((-0.875_f64 + r1[1]) + 0.125).tanh(),
                ]) * ((y * 0.625_f64).abs() * 0.75).sin();
        }
        let f = l2.total();
        if (d * d) <= (r1[1] + -0.375_f64).sin() {
            let l4 = List(vec![
                ((x * -0.125_f64).max(x) * 0.75).sin(),
                (f * 0.875_f64).abs(),
                ((0.625_f64 - x) + 0.125).tanh(),
            ]);
            let m5 = &l4
                * &List(vec![
                    ((r1[0] + -0.375_f64).sin() + 0.125).tanh(),
                    (-(d)),
                    ((d + 0.375_f64).sin() * 0.75).sin(),
                ]);
            let e = ((-&m5 + l4).total()).tanh();
        }
    }
    let a = mixed(&r1[2..]).sin();
    let mut p6 = Pair { a: (y + 0.125).tanh(), b: ((-(r1[1])) + 0.125).tanh() };
    let r7 = [((d * p6.b) + 0.125).tanh(), ((d * p6.b) + 0.125).tanh()];
    let mut r8 = [
        ((y * -1.125_f64) + 0.125).tanh(),
        ((a * 0.125_f64).cos() + 0.125).tanh(),
        ((p6.a - p6.a) + 0.125).tanh(),
    ];
    r8[2] = (r1[2] + 0.125).tanh();
    let c = summed(bent, ((r1[2] * r1[2] + 0.25).sqrt() + 0.125).tanh(), 3).tanh();
    let e = p6
        .dot(&Pair {
            a: ((-0.125_f64 / (1.5 + r8[2] * r8[2])) + 0.125).tanh(),
            b: ((p6.a * -0.375_f64).max(a) * 0.75).sin(),
        })
        .sin();
    let f = match shape(((p6.a / (1.5 + e * e)) + 0.125).tanh(), ((r8[1] + d) * 0.75).sin()) {
        Shape::Point => y,
        Shape::Disc(v) => ((r7[1] + -0.375_f64) / (1.5 + (c * r1[1]) * (c * r1[1]))),
        Shape::Box { w: v, h } => ((a - d) + (p6.a * p6.a + 0.25).sqrt()),
    };
    let by9 = ((r1[1] * r7[1]) * 0.75).sin();
    for v in r8.iter_mut() {
        *v = (*v * by9).sin();
    }
    let (a, mut b) = ((y * 0.75).sin(), (a * a + 0.25).sqrt());
    ((p6.b + 0.375_f64).sin() - (f + 0.875_f64).sin()) + b + a + f + e + c + d + y + x
}

fn program_29_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * x) * S::from_f64(0.75)).sin();
    let r1 = [
        ((d + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(0.625_f64)).max(d) * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    if (d * S::from_f64(-0.875_f64)).cos().cmpge((d * S::from_f64(-1.125_f64)).abs()) {
        let mut l2 = List(vec![
            ((y * S::from_f64(-0.875_f64)).max(y) + S::from_f64(0.125)).tanh(),
            (x * x),
            ((d - y) + S::from_f64(0.125)).tanh(),
        ]);
        for i3 in 0..4_usize {
            l2 += &List(vec![
                ((y / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
                (x * x + S::from_f64(0.25)).sqrt(),
                ((S::from_f64(-0.875_f64) + r1[1]) + S::from_f64(0.125)).tanh(),
            ]);
            if (d * d + S::from_f64(0.25)).sqrt().cmplt((x * S::from_f64(-1.125_f64)).max(r1[0])) {
                continue;
            }
            l2 = l2
                + List(vec![
                    ((y / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
                    (x * x + S::from_f64(0.25)).sqrt(),
                    ((S::from_f64(-0.875_f64) + r1[1]) + S::from_f64(0.125)).tanh(),
                ]) * ((y * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
        }
        let f = l2.total();
        if (d * d).cmple((r1[1] + S::from_f64(-0.375_f64)).sin()) {
            let l4 = List(vec![
                ((x * S::from_f64(-0.125_f64)).max(x) * S::from_f64(0.75)).sin(),
                (f * S::from_f64(0.875_f64)).abs(),
                ((S::from_f64(0.625_f64) - x) + S::from_f64(0.125)).tanh(),
            ]);
            let m5 = &l4
                * &List(vec![
                    ((r1[0] + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
                    (-(d)),
                    ((d + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
                ]);
            let e = ((-&m5 + l4).total()).tanh();
        }
    }
    let a = mixed(&r1[2..]).sin();
    let mut p6 =
        Pair { a: (y + S::from_f64(0.125)).tanh(), b: ((-(r1[1])) + S::from_f64(0.125)).tanh() };
    let r7 = [((d * p6.b) + S::from_f64(0.125)).tanh(), ((d * p6.b) + S::from_f64(0.125)).tanh()];
    let mut r8 = [
        ((y * S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
        ((a * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((p6.a - p6.a) + S::from_f64(0.125)).tanh(),
    ];
    r8[2] = (r1[2] + S::from_f64(0.125)).tanh();
    let c =
        summed(bent, ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(), 3)
            .tanh();
    let e = p6
        .dot(&Pair {
            a: ((S::from_f64(-0.125_f64) / (S::from_f64(1.5) + r8[2] * r8[2]))
                + S::from_f64(0.125))
            .tanh(),
            b: ((p6.a * S::from_f64(-0.375_f64)).max(a) * S::from_f64(0.75)).sin(),
        })
        .sin();
    let f = match shape(
        ((p6.a / (S::from_f64(1.5) + e * e)) + S::from_f64(0.125)).tanh(),
        ((r8[1] + d) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => y,
        Shape::Disc(v) => {
            ((r7[1] + S::from_f64(-0.375_f64)) / (S::from_f64(1.5) + (c * r1[1]) * (c * r1[1])))
        }
        Shape::Box { w: v, h } => ((a - d) + (p6.a * p6.a + S::from_f64(0.25)).sqrt()),
    };
    let by9 = ((r1[1] * r7[1]) * S::from_f64(0.75)).sin();
    for v in r8.iter_mut() {
        *v = (*v * by9).sin();
    }
    let (a, mut b) = ((y * S::from_f64(0.75)).sin(), (a * a + S::from_f64(0.25)).sqrt());
    ((p6.b + S::from_f64(0.375_f64)).sin() - (f + S::from_f64(0.875_f64)).sin())
        + b
        + a
        + f
        + e
        + c
        + d
        + y
        + x
}

#[differentiable]
fn program_30(x: f64, y: f64) -> f64 {
    let mut f = ((-0.625_f64 - 0.875_f64).tanh() * 0.75).sin();
    let mut r1 = [((-0.125_f64 - -0.625_f64).tanh() + 0.125).tanh(); 5];
    r1[1] -= (((-0.625_f64 * 0.125_f64).cos() - -1.125_f64).tanh() + 0.125).tanh();
    let mut p2 =
        Pair { a: ((f - -0.375_f64).tanh() * 0.75).sin(), b: ((0.625_f64 * x) * 0.75).sin() };
    if (f - 0.875_f64).tanh() < (f + f) {
        r1[1] += (((x + 0.875_f64).sin() + (x + 0.625_f64).sin()) * 0.75).sin();
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        'l5: for i6 in n4..=5_usize {
            f = ((r1[(n4 + 1) % 5] * (r1[(n4 + 2) % 5] * r1[(n4 + 2) % 5] + 0.25).sqrt()) + 0.125)
                .tanh();
            let f = mixed(&r1[3..]).sin();
        }
        'l7: for i8 in (n4..1_usize).step_by(2) {
            if i8 % 3 == 1 {
                let c = program_5(
                    ((-1.125_f64 * -1.125_f64 + 0.25).sqrt() * 0.75).sin(),
                    ((0.625_f64 / (1.5 + r1[4] * r1[4])) + 0.125).tanh(),
                )
                .tanh();
            } else {
                let f = match root((-(x))) {
                    Some(v) => ((((i8 as f64) * 0.25) + 0.125_f64).sin() * 0.875_f64).cos(),
                    None => x,
                };
            }
            r1[3] = (((x + p2.a) * (((i8 as f64) * 0.25) - -0.375_f64).tanh()) + 0.125).tanh();
            'l9: for i10 in (n4..0_usize).step_by(2) {
                r1[(i8 + 3) % 5] = (((0.375_f64 * f) + y) + 0.125).tanh();
                let mut r11 = [((r1[(i10 + 3) % 5] + p2.a) + 0.125).tanh(); 4];
            }
        }
    }
    (0.375_f64 + (r1[1] * r1[2])) + f + y + x
}

fn program_30_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f =
        ((S::from_f64(-0.625_f64) - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((S::from_f64(-0.125_f64) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125))
        .tanh(); 5];
    r1[1] = r1[1]
        - (((S::from_f64(-0.625_f64) * S::from_f64(0.125_f64)).cos() - S::from_f64(-1.125_f64))
            .tanh()
            + S::from_f64(0.125))
        .tanh();
    let mut p2 = Pair {
        a: ((f - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(0.625_f64) * x) * S::from_f64(0.75)).sin(),
    };
    if (f - S::from_f64(0.875_f64)).tanh().cmplt((f + f)) {
        r1[1] = r1[1]
            + (((x + S::from_f64(0.875_f64)).sin() + (x + S::from_f64(0.625_f64)).sin())
                * S::from_f64(0.75))
            .sin();
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        'l5: for i6 in n4..=5_usize {
            f = ((r1[(n4 + 1) % 5]
                * (r1[(n4 + 2) % 5] * r1[(n4 + 2) % 5] + S::from_f64(0.25)).sqrt())
                + S::from_f64(0.125))
            .tanh();
            let f = mixed(&r1[3..]).sin();
        }
        'l7: for i8 in (n4..1_usize).step_by(2) {
            if i8 % 3 == 1 {
                let c = program_5_of(
                    ((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25))
                        .sqrt()
                        * S::from_f64(0.75))
                    .sin(),
                    ((S::from_f64(0.625_f64) / (S::from_f64(1.5) + r1[4] * r1[4]))
                        + S::from_f64(0.125))
                    .tanh(),
                )
                .tanh();
            } else {
                let f = match root((-(x))) {
                    Some(v) => (((S::from_f64(i8 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.125_f64))
                    .sin()
                        * S::from_f64(0.875_f64))
                    .cos(),
                    None => x,
                };
            }
            r1[3] = (((x + p2.a)
                * ((S::from_f64(i8 as f64) * S::from_f64(0.25)) - S::from_f64(-0.375_f64)).tanh())
                + S::from_f64(0.125))
            .tanh();
            'l9: for i10 in (n4..0_usize).step_by(2) {
                r1[(i8 + 3) % 5] = (((S::from_f64(0.375_f64) * f) + y) + S::from_f64(0.125)).tanh();
                let mut r11 = [((r1[(i10 + 3) % 5] + p2.a) + S::from_f64(0.125)).tanh(); 4];
            }
        }
    }
    (S::from_f64(0.375_f64) + (r1[1] * r1[2])) + f + y + x
}

#[differentiable]
fn program_31(x: f64, y: f64) -> f64 {
    let mut d = ((y - -0.875_f64) + 0.125).tanh();
    let mut r1 = [((x * x) * 0.75).sin(); 4];
    r1[1] += (-0.125_f64 + 0.125).tanh();
    r1[1] *= ((-(r1[3] / (1.5 + y * y))) + 0.125).tanh();
    let c = program_10(((0.375_f64 * 0.375_f64 + 0.25).sqrt() * 0.75).sin(), ((-(d)) * 0.75).sin())
        .tanh();
    let b = match shape(((-(y)) * 0.75).sin(), ((-0.375_f64 * d) * 0.75).sin()) {
        Point => (y * x),
        Disc(v) => r1[3],
        Shape::Box { w: v, h } => (-0.875_f64 * (c * v)),
    };
    let mut p2 = Pair { a: ((x + r1[1]) * 0.75).sin(), b: ((c * r1[0]) + 0.125).tanh() };
    let c = root((y / (1.5 + x * x))).map_or((c + d), |v| ((-0.875_f64 * x) * 0.125_f64).max(c));
    d = (((p2.a / (1.5 + c * c)) - c) + 0.125).tanh();
    let c = summed(|t: f64| (((x * y) + (x - y)) * t).sin(), ((b * b) * 0.75).sin(), 3).tanh();
    let c = ((c - 0.875_f64).tanh() * -0.125_f64).max(y);
    'l3: for i4 in 2..=3_usize {
        let c = program_27(((c * x) + 0.125).tanh(), (p2.b + 0.125).tanh()).tanh();
    }
    p2.b = ((-1.125_f64 + c) + 0.125).tanh();
    p2 = p2.tamed();
    let mut n6 = 0_usize;
    'l5: while n6 < 5 {
        n6 += 1;
        let k7 = (y / (1.5 + d * d));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k7).sin();
            part.reverse();
        }
        'l8: for i9 in (n6..5_usize).step_by(2) {
            if n6 % 2 == 1 {
                let mut c = ((r1[(i9 + 0) % 4] * r1[(i9 + 0) % 4] + 0.25).sqrt() + 0.125).tanh();
                r1[0] *= (((r1[2] * -1.125_f64).cos() * 0.375_f64).cos() * 0.75).sin();
                let mut c = ((p2.a * 0.125_f64).max(0.375_f64) * 0.75).sin();
            } else {
                let a = mixed(&r1).sin();
            }
        }
        let mut w10 =
            (((r1[1] - -1.125_f64).tanh() + 0.125).tanh(), [(r1[2] - 0.375_f64).tanh(); 2]);
        {
            let (ref mut p, [ref mut q, _]) = w10;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let f = (w10.0 + w10.1[0] * w10.1[1]).tanh();
    }
    ((-1.125_f64 + r1[0]) - (c - -0.875_f64).tanh()) + c + b + d + y + x
}

fn program_31_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y - S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * x) * S::from_f64(0.75)).sin(); 4];
    r1[1] = r1[1] + (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh();
    r1[1] = r1[1] * ((-(r1[3] / (S::from_f64(1.5) + y * y))) + S::from_f64(0.125)).tanh();
    let c = program_10_of(
        ((S::from_f64(0.375_f64) * S::from_f64(0.375_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
        ((-(d)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let b = match shape(
        ((-(y)) * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) * d) * S::from_f64(0.75)).sin(),
    ) {
        Point => (y * x),
        Disc(v) => r1[3],
        Shape::Box { w: v, h } => (S::from_f64(-0.875_f64) * (c * v)),
    };
    let mut p2 = Pair {
        a: ((x + r1[1]) * S::from_f64(0.75)).sin(),
        b: ((c * r1[0]) + S::from_f64(0.125)).tanh(),
    };
    let c = root((y / (S::from_f64(1.5) + x * x)))
        .map_or((c + d), |v| ((S::from_f64(-0.875_f64) * x) * S::from_f64(0.125_f64)).max(c));
    d = (((p2.a / (S::from_f64(1.5) + c * c)) - c) + S::from_f64(0.125)).tanh();
    let c = summed(|t: S| (((x * y) + (x - y)) * t).sin(), ((b * b) * S::from_f64(0.75)).sin(), 3)
        .tanh();
    let c = ((c - S::from_f64(0.875_f64)).tanh() * S::from_f64(-0.125_f64)).max(y);
    'l3: for i4 in 2..=3_usize {
        let c = program_27_of(
            ((c * x) + S::from_f64(0.125)).tanh(),
            (p2.b + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    p2.b = ((S::from_f64(-1.125_f64) + c) + S::from_f64(0.125)).tanh();
    p2 = p2.tamed();
    let mut n6 = 0_usize;
    'l5: while n6 < 5 {
        n6 += 1;
        let k7 = (y / (S::from_f64(1.5) + d * d));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k7).sin();
            part.reverse();
        }
        'l8: for i9 in (n6..5_usize).step_by(2) {
            if n6 % 2 == 1 {
                let mut c = ((r1[(i9 + 0) % 4] * r1[(i9 + 0) % 4] + S::from_f64(0.25)).sqrt()
                    + S::from_f64(0.125))
                .tanh();
                r1[0] = r1[0]
                    * (((r1[2] * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.375_f64)).cos()
                        * S::from_f64(0.75))
                    .sin();
                let mut c = ((p2.a * S::from_f64(0.125_f64)).max(S::from_f64(0.375_f64))
                    * S::from_f64(0.75))
                .sin();
            } else {
                let a = mixed(&r1).sin();
            }
        }
        let mut w10 = (
            ((r1[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            [(r1[2] - S::from_f64(0.375_f64)).tanh(); 2],
        );
        {
            let (ref mut p, [ref mut q, _]) = w10;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let f = (w10.0 + w10.1[0] * w10.1[1]).tanh();
    }
    ((S::from_f64(-1.125_f64) + r1[0]) - (c - S::from_f64(-0.875_f64)).tanh()) + c + b + d + y + x
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
    let mut d = ((0.375_f64 / (1.5 + -1.125_f64 * -1.125_f64)) * 0.75).sin();
    'l2: for i3 in 1..3_usize {
        r1[(i3 * i3 + 1) % 4] += (r1[(i3 + 0) % 4] * 0.75).sin();
        #[differentiable(checkpoint)]
        'l4: for i5 in 2..5_usize {
            #[differentiable(checkpoint)]
            'l6: for i7 in 1..3_usize {
                let mut p8 =
                    Pair { a: ((x - -0.375_f64).tanh() * 0.75).sin(), b: ((d * y) * 0.75).sin() };
                f = (((y * ((i3 as f64) * 0.25)) * (r1[i7 % 4] * -1.125_f64).max(r1[3])) * 0.75)
                    .sin();
                let (a, mut b) = (
                    ((((i7 as f64) * 0.25) * -0.125_f64).abs() + 0.125).tanh(),
                    (((i3 as f64) * 0.25) - x),
                );
            }
            let z9;
            if i5 % 2 == 1 {
                let t = ((r1[(i3 + 1) % 4] / (1.5 + y * y)) * (r1[(i3 + 1) % 4] / (1.5 + y * y))
                    + 0.25)
                    .sqrt();
                z9 = (f + (((i5 as f64) * 0.25) / (1.5 + r1[i3 % 4] * r1[i3 % 4])));
            } else if (f + r1[(i3 + 2) % 4]) > (y + ((i5 as f64) * 0.25)) {
                z9 = bent((((i5 as f64) * 0.25) * ((i5 as f64) * 0.25) + 0.25).sqrt());
            } else {
                z9 = ((r1[(i3 + 1) % 4] / (1.5 + y * y)) * (r1[(i3 + 1) % 4] / (1.5 + y * y))
                    + 0.25)
                    .sqrt();
            }
        }
    }
    let by10 = ((f + x) * 0.75).sin();
    let a = shifted(&mut r1[2..], by10);
    for v in r1.iter().cycle().take(8) {
        f = (f + *v).sin();
    }
    let e = match root((-0.125_f64 + 0.875_f64).sin()) {
        Some(v) => ((f * 0.625_f64).abs() * x),
        None => f,
    };
    let mut r11 = [((e * -0.375_f64).abs() + 0.125).tanh(); 4];
    f += ((r1[2] * 0.375_f64).cos() * 0.75).sin();
    ((d * 0.375_f64).max(e) * (a * y)) + e + a + d + f + y + x
}

fn program_32_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * y) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((-(x)) * S::from_f64(0.75)).sin(),
    ];
    let mut d = ((S::from_f64(0.375_f64)
        / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
        * S::from_f64(0.75))
    .sin();
    'l2: for i3 in 1..3_usize {
        r1[(i3 * i3 + 1) % 4] =
            r1[(i3 * i3 + 1) % 4] + (r1[(i3 + 0) % 4] * S::from_f64(0.75)).sin();

        'l4: for i5 in 2..5_usize {
            'l6: for i7 in 1..3_usize {
                let mut p8 = Pair {
                    a: ((x - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
                    b: ((d * y) * S::from_f64(0.75)).sin(),
                };
                f = (((y * (S::from_f64(i3 as f64) * S::from_f64(0.25)))
                    * (r1[i7 % 4] * S::from_f64(-1.125_f64)).max(r1[3]))
                    * S::from_f64(0.75))
                .sin();
                let (a, mut b) = (
                    (((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
                        .abs()
                        + S::from_f64(0.125))
                    .tanh(),
                    ((S::from_f64(i3 as f64) * S::from_f64(0.25)) - x),
                );
            }
            let z9;
            if i5 % 2 == 1 {
                let t = ((r1[(i3 + 1) % 4] / (S::from_f64(1.5) + y * y))
                    * (r1[(i3 + 1) % 4] / (S::from_f64(1.5) + y * y))
                    + S::from_f64(0.25))
                .sqrt();
                z9 = (f
                    + ((S::from_f64(i5 as f64) * S::from_f64(0.25))
                        / (S::from_f64(1.5) + r1[i3 % 4] * r1[i3 % 4])));
            } else if (f + r1[(i3 + 2) % 4])
                .cmpgt((y + (S::from_f64(i5 as f64) * S::from_f64(0.25))))
            {
                z9 = bent(
                    ((S::from_f64(i5 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i5 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.25))
                    .sqrt(),
                );
            } else {
                z9 = ((r1[(i3 + 1) % 4] / (S::from_f64(1.5) + y * y))
                    * (r1[(i3 + 1) % 4] / (S::from_f64(1.5) + y * y))
                    + S::from_f64(0.25))
                .sqrt();
            }
        }
    }
    let by10 = ((f + x) * S::from_f64(0.75)).sin();
    let a = shifted(&mut r1[2..], by10);
    for v in r1.iter().cycle().take(8) {
        f = (f + *v).sin();
    }
    let e = match root((S::from_f64(-0.125_f64) + S::from_f64(0.875_f64)).sin()) {
        Some(v) => ((f * S::from_f64(0.625_f64)).abs() * x),
        None => f,
    };
    let mut r11 = [((e * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(); 4];
    f = f + ((r1[2] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    ((d * S::from_f64(0.375_f64)).max(e) * (a * y)) + e + a + d + f + y + x
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
    let mut e = ((y - -1.125_f64).tanh() * 0.75).sin();
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((r1[3] * -0.875_f64).max(a) + 0.125).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let a = (mixed(&u2) + u2[0]).tanh();
    if (-0.125_f64 + 0.375_f64) < (a * e) {
        e += (((y * -0.125_f64).abs() + (x * x + 0.25).sqrt()) + 0.125).tanh();
        let (a, mut b) = (((r1[0] - e) + 0.125).tanh(), (e + -0.625_f64).sin());
        r1[0] = (((-(y)) * (-(y)) + 0.25).sqrt() + 0.125).tanh();
    } else {
        let b = match root((x / (1.5 + e * e))) {
            Some(v) => ((y * 0.875_f64).max(v) - (v * v + 0.25).sqrt()),
            None => (r1[0] + r1[3]),
        };
        let b = match shape((r1[4] + 0.125).tanh(), ((x + -0.875_f64).sin() + 0.125).tanh()) {
            Point => (x * -0.625_f64).abs(),
            Disc(v) => ((a + y) * -0.375_f64).abs(),
            Shape::Box { w: v, h } => ((-(0.375_f64)) * -0.125_f64).cos(),
        };
    }
    'l3: for i4 in (2..4_usize).step_by(2) {
        let mut p5 =
            Pair { a: ((x * y) + 0.125).tanh(), b: ((y * y + 0.25).sqrt() + 0.125).tanh() };
        let z6;
        let mut n7 = 0_usize;
        loop {
            n7 += 1;
            let t = (-(-(y)));
            if n7 > 2 || (-(p5.a)) > (x + r1[(i4 * i4 + 1) % 5]) {
                z6 = p5.b;
                break;
            }
        }
    }
    let mut r8 = [((y / (1.5 + r1[0] * r1[0])) * 0.75).sin(); 4];
    let mut p9 = Pair { a: ((a - 0.875_f64).tanh() + 0.125).tanh(), b: ((x * r8[2]) * 0.75).sin() };
    p9.turn(((x * 0.875_f64).abs() * 0.75).sin());
    p9 = p9.tamed();
    ((r8[0] * r1[2]) * (r8[0] * r1[2]) + 0.25).sqrt() + a + e + y + x
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
    let mut e = ((y - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((r1[3] * S::from_f64(-0.875_f64)).max(a) + S::from_f64(0.125)).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let a = (mixed(&u2) + u2[0]).tanh();
    if (S::from_f64(-0.125_f64) + S::from_f64(0.375_f64)).cmplt((a * e)) {
        e = e
            + (((y * S::from_f64(-0.125_f64)).abs() + (x * x + S::from_f64(0.25)).sqrt())
                + S::from_f64(0.125))
            .tanh();
        let (a, mut b) =
            (((r1[0] - e) + S::from_f64(0.125)).tanh(), (e + S::from_f64(-0.625_f64)).sin());
        r1[0] = (((-(y)) * (-(y)) + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    } else {
        let b = match root((x / (S::from_f64(1.5) + e * e))) {
            Some(v) => ((y * S::from_f64(0.875_f64)).max(v) - (v * v + S::from_f64(0.25)).sqrt()),
            None => (r1[0] + r1[3]),
        };
        let b = match shape(
            (r1[4] + S::from_f64(0.125)).tanh(),
            ((x + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ) {
            Point => (x * S::from_f64(-0.625_f64)).abs(),
            Disc(v) => ((a + y) * S::from_f64(-0.375_f64)).abs(),
            Shape::Box { w: v, h } => ((-(S::from_f64(0.375_f64))) * S::from_f64(-0.125_f64)).cos(),
        };
    }
    'l3: for i4 in (2..4_usize).step_by(2) {
        let mut p5 = Pair {
            a: ((x * y) + S::from_f64(0.125)).tanh(),
            b: ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        };
        let z6;
        let mut n7 = 0_usize;
        loop {
            n7 += 1;
            let t = (-(-(y)));
            if n7 > 2 || (-(p5.a)).cmpgt((x + r1[(i4 * i4 + 1) % 5])) {
                z6 = p5.b;
                break;
            }
        }
    }
    let mut r8 = [((y / (S::from_f64(1.5) + r1[0] * r1[0])) * S::from_f64(0.75)).sin(); 4];
    let mut p9 = Pair {
        a: ((a - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: ((x * r8[2]) * S::from_f64(0.75)).sin(),
    };
    p9.turn(((x * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin());
    p9 = p9.tamed();
    ((r8[0] * r1[2]) * (r8[0] * r1[2]) + S::from_f64(0.25)).sqrt() + a + e + y + x
}

#[differentiable]
fn program_34(x: f64, y: f64) -> f64 {
    let mut e = (x + 0.125).tanh();
    let r1 = [((e - -0.375_f64).tanh() + 0.125).tanh(); 2];
    let (a, mut b) = (((r1[0] - -1.125_f64).tanh() + 0.125).tanh(), (r1[1] * r1[1] + 0.25).sqrt());
    let d = a;
    let mut r2 = [((e - x) * 0.75).sin(); 3];
    let d = mixed(&r2).sin();
    let mut z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((r2[1] - -0.125_f64).tanh() * (e + a));
        if n4 > 2 || (r2[1] * r2[2]) <= (-0.625_f64 * b) {
            z3 = ((-(r2[2])) * -0.625_f64).cos();
            break;
        }
    }
    z3 = z3 * (-(d));
    let g5 = |t: f64| (-(z3 + 0.625_f64)) * t;
    let b = (g5((a * -1.125_f64).cos()) + g5((y - -1.125_f64).tanh())).sin();
    for v in r1.iter().cycle().take(2) {
        e = (e + *v).sin();
    }
    let mut r6 = [
        ((r2[1] + d) + 0.125).tanh(),
        ((0.875_f64 * 0.875_f64 + 0.25).sqrt() * 0.75).sin(),
        ((b + a) * 0.75).sin(),
        ((-(0.875_f64)) + 0.125).tanh(),
        ((a * -0.625_f64).cos() * 0.75).sin(),
    ];
    let z7;
    let mut n8 = 0_usize;
    loop {
        n8 += 1;
        let t = (x - e);
        if n8 > 2 || (r2[1] + r6[1]) < r1[0] {
            z7 = r2[1];
            break;
        }
    }
    let g9 = |t: f64| (-(y * r1[0])) * t;
    let d = (g9((d + z3)) + g9((e + 0.875_f64).sin())).sin();
    e = (r1[1] + 0.125).tanh();
    let a = match root((0.125_f64 * -0.875_f64).cos()) {
        Some(v) => ((-(z7)) * -1.125_f64).cos(),
        None => (d * 0.125_f64).max(r2[2]),
    };
    let mut l10 = List(vec![
        ((r6[4] * r6[4] + 0.25).sqrt() * 0.75).sin(),
        (r2[0] * 0.125_f64).max(z3),
        ((x / (1.5 + z7 * z7)) + 0.125).tanh(),
    ]);
    for i11 in 0..3_usize {
        l10 += &List(vec![(a * 0.75).sin(), -0.375_f64, (z7 + 0.125).tanh()]);
        if (-(e)) <= (-(r2[0])) {
            continue;
        }
        l10 = &l10 * &List(vec![(a * 0.75).sin(), -0.375_f64, (z7 + 0.125).tanh()]);
    }
    let d = l10.total();
    let a = ((r2[2] * r2[2] + 0.25).sqrt() * 0.875_f64).cos();
    ((-(x)) * (r6[3] + 0.625_f64).sin()) + a + d + z7 + b + z3 + e + y + x
}

fn program_34_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (x + S::from_f64(0.125)).tanh();
    let r1 = [((e - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(); 2];
    let (a, mut b) = (
        ((r1[0] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        (r1[1] * r1[1] + S::from_f64(0.25)).sqrt(),
    );
    let d = a;
    let mut r2 = [((e - x) * S::from_f64(0.75)).sin(); 3];
    let d = mixed(&r2).sin();
    let mut z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((r2[1] - S::from_f64(-0.125_f64)).tanh() * (e + a));
        if n4 > 2 || (r2[1] * r2[2]).cmple((S::from_f64(-0.625_f64) * b)) {
            z3 = ((-(r2[2])) * S::from_f64(-0.625_f64)).cos();
            break;
        }
    }
    z3 = z3 * (-(d));
    let g5 = |t: S| (-(z3 + S::from_f64(0.625_f64))) * t;
    let b =
        (g5((a * S::from_f64(-1.125_f64)).cos()) + g5((y - S::from_f64(-1.125_f64)).tanh())).sin();
    for v in r1.iter().cycle().take(2) {
        e = (e + *v).sin();
    }
    let mut r6 = [
        ((r2[1] + d) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.875_f64) * S::from_f64(0.875_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
        ((b + a) * S::from_f64(0.75)).sin(),
        ((-(S::from_f64(0.875_f64))) + S::from_f64(0.125)).tanh(),
        ((a * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
    ];
    let z7;
    let mut n8 = 0_usize;
    loop {
        n8 += 1;
        let t = (x - e);
        if n8 > 2 || (r2[1] + r6[1]).cmplt(r1[0]) {
            z7 = r2[1];
            break;
        }
    }
    let g9 = |t: S| (-(y * r1[0])) * t;
    let d = (g9((d + z3)) + g9((e + S::from_f64(0.875_f64)).sin())).sin();
    e = (r1[1] + S::from_f64(0.125)).tanh();
    let a = match root((S::from_f64(0.125_f64) * S::from_f64(-0.875_f64)).cos()) {
        Some(v) => ((-(z7)) * S::from_f64(-1.125_f64)).cos(),
        None => (d * S::from_f64(0.125_f64)).max(r2[2]),
    };
    let mut l10 = List(vec![
        ((r6[4] * r6[4] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (r2[0] * S::from_f64(0.125_f64)).max(z3),
        ((x / (S::from_f64(1.5) + z7 * z7)) + S::from_f64(0.125)).tanh(),
    ]);
    for i11 in 0..3_usize {
        l10 += &List(vec![
            (a * S::from_f64(0.75)).sin(),
            S::from_f64(-0.375_f64),
            (z7 + S::from_f64(0.125)).tanh(),
        ]);
        if (-(e)).cmple((-(r2[0]))) {
            continue;
        }
        l10 = &l10
            * &List(vec![
                (a * S::from_f64(0.75)).sin(),
                S::from_f64(-0.375_f64),
                (z7 + S::from_f64(0.125)).tanh(),
            ]);
    }
    let d = l10.total();
    let a = ((r2[2] * r2[2] + S::from_f64(0.25)).sqrt() * S::from_f64(0.875_f64)).cos();
    ((-(x)) * (r6[3] + S::from_f64(0.625_f64)).sin()) + a + d + z7 + b + z3 + e + y + x
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
    let e = program_20(
        ((r1[4] * r1[4] + 0.25).sqrt() + 0.125).tanh(),
        ((r1[2] * -0.375_f64).max(a) * 0.75).sin(),
    )
    .tanh();
    for v in r1.iter().cycle().take(1) {
        a = (a + *v).sin();
    }
    r1[3] -= (((e * -0.125_f64).cos() * (e * r1[0])) * 0.75).sin();
    #[differentiable(checkpoint)]
    'l3: for i4 in 1..0_usize {
        let c = mixed(&r1[..4]).sin();
        let b = ((a * -0.375_f64).cos() * (x + c));
    }
    let mut u5: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u5.push(((x + r1[4]) + 0.125).tanh());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let f = (mixed(&u5) + u5[0]).tanh();
    r1[1] = (r1[0] * 0.75).sin();
    let b = program_24(((f * -0.125_f64) * 0.75).sin(), ((x * 0.625_f64) * 0.75).sin()).tanh();
    let mut p6 = Pair { a: ((y * e) * 0.75).sin(), b: ((y - 0.375_f64).tanh() + 0.125).tanh() };
    let f = summed(|t: f64| (f * t).sin(), ((y * p6.b) * 0.75).sin(), 0).tanh();
    let g7 = |t: f64, v: &[f64]| {
        mixed(v) * t
            + ((-0.375_f64 + 0.625_f64).sin() / (1.5 + (r1[0] + r1[3]) * (r1[0] + r1[3]))).tanh()
    };
    let b = folded(&g7, ((x * -0.875_f64).abs() * 0.75).sin(), &r1).sin();
    r1[3] = (((r1[4] * b) * 0.125_f64).max(-0.875_f64) * 0.75).sin();
    ((r1[2] * r1[3]) * -0.625_f64).cos() + b + f + e + a + y + x
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
    let e = program_20_of(
        ((r1[4] * r1[4] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((r1[2] * S::from_f64(-0.375_f64)).max(a) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    for v in r1.iter().cycle().take(1) {
        a = (a + *v).sin();
    }
    r1[3] = r1[3] - (((e * S::from_f64(-0.125_f64)).cos() * (e * r1[0])) * S::from_f64(0.75)).sin();

    'l3: for i4 in 1..0_usize {
        let c = mixed(&r1[..4]).sin();
        let b = ((a * S::from_f64(-0.375_f64)).cos() * (x + c));
    }
    let mut u5: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u5.push(((x + r1[4]) + S::from_f64(0.125)).tanh());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let f = (mixed(&u5) + u5[0]).tanh();
    r1[1] = (r1[0] * S::from_f64(0.75)).sin();
    let b = program_24_of(
        ((f * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut p6 = Pair {
        a: ((y * e) * S::from_f64(0.75)).sin(),
        b: ((y - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    let f = summed(|t: S| (f * t).sin(), ((y * p6.b) * S::from_f64(0.75)).sin(), 0).tanh();
    let g7 = |t: S, v: &[S]| {
        mixed(v) * t
            + ((S::from_f64(-0.375_f64) + S::from_f64(0.625_f64)).sin()
                / (S::from_f64(1.5) + (r1[0] + r1[3]) * (r1[0] + r1[3])))
                .tanh()
    };
    let b = folded(&g7, ((x * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(), &r1).sin();
    r1[3] = (((r1[4] * b) * S::from_f64(0.125_f64)).max(S::from_f64(-0.875_f64))
        * S::from_f64(0.75))
    .sin();
    ((r1[2] * r1[3]) * S::from_f64(-0.625_f64)).cos() + b + f + e + a + y + x
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
    let mut b = ((p2.a * c) * 0.75).sin();
    let d = summed(bent, ((c / (1.5 + -0.875_f64 * -0.875_f64)) + 0.125).tanh(), 3).tanh();
    let d = program_31((y * 0.75).sin(), ((p2.b * 0.875_f64).max(e) + 0.125).tanh()).tanh();
    let f = summed(
        |t: f64| ((r1[0] + (-(y))) * t).sin(),
        ((r1[2] + 0.875_f64).sin() + 0.125).tanh(),
        3,
    )
    .tanh();
    let e = match shape(
        ((r1[0] + 0.625_f64).sin() * 0.75).sin(),
        ((p2.b - 0.375_f64).tanh() * 0.75).sin(),
    ) {
        Shape::Point => (c * -0.125_f64).cos(),
        Shape::Disc(v) => ((-1.125_f64 + -0.375_f64).sin() - -0.375_f64).tanh(),
        Shape::Box { w: v, h } => ((-(r1[2])) + 0.625_f64).sin(),
    };
    let a = summed(bent, ((r1[1] + r1[1]) * 0.75).sin(), 3).tanh();
    r1[2] = (((r1[2] / (1.5 + f * f)) * p2.a) * 0.75).sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        let b = match roots((-1.125_f64 * r1[n4 % 3]), a) {
            Ok(v) => ((a * -1.125_f64).cos() - (((n4 as f64) * 0.25) * v)),
            Err(true) => a,
            Err(_) => r1[2],
        };
    }
    p2 = (p2 - p2 * ((x / (1.5 + r1[1] * r1[1])) + 0.125).tanh()).tamed();
    p2 = p2.tamed();
    r1[0] = (((-(r1[1])) * -1.125_f64).cos() + 0.125).tanh();
    let mut p5 = Pair {
        a: ((r1[0] * 0.125_f64).abs() * 0.75).sin(),
        b: ((y * -0.625_f64).cos() * 0.75).sin(),
    };
    ((b / (1.5 + -0.125_f64 * -0.125_f64)) - (0.625_f64 * -0.125_f64).max(r1[0]))
        + a
        + e
        + f
        + d
        + b
        + c
        + y
        + x
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
    let mut b = ((p2.a * c) * S::from_f64(0.75)).sin();
    let d = summed(
        bent,
        ((c / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64)))
            + S::from_f64(0.125))
        .tanh(),
        3,
    )
    .tanh();
    let d = program_31_of(
        (y * S::from_f64(0.75)).sin(),
        ((p2.b * S::from_f64(0.875_f64)).max(e) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let f = summed(
        |t: S| ((r1[0] + (-(y))) * t).sin(),
        ((r1[2] + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        3,
    )
    .tanh();
    let e = match shape(
        ((r1[0] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        ((p2.b - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (c * S::from_f64(-0.125_f64)).cos(),
        Shape::Disc(v) => ((S::from_f64(-1.125_f64) + S::from_f64(-0.375_f64)).sin()
            - S::from_f64(-0.375_f64))
        .tanh(),
        Shape::Box { w: v, h } => ((-(r1[2])) + S::from_f64(0.625_f64)).sin(),
    };
    let a = summed(bent, ((r1[1] + r1[1]) * S::from_f64(0.75)).sin(), 3).tanh();
    r1[2] = (((r1[2] / (S::from_f64(1.5) + f * f)) * p2.a) * S::from_f64(0.75)).sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        let b = match roots((S::from_f64(-1.125_f64) * r1[n4 % 3]), a) {
            Ok(v) => {
                ((a * S::from_f64(-1.125_f64)).cos()
                    - ((S::from_f64(n4 as f64) * S::from_f64(0.25)) * v))
            }
            Err(true) => a,
            Err(_) => r1[2],
        };
    }
    p2 = (p2 - p2 * ((x / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh()).tamed();
    p2 = p2.tamed();
    r1[0] = (((-(r1[1])) * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh();
    let mut p5 = Pair {
        a: ((r1[0] * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((y * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
    };
    ((b / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
        - (S::from_f64(0.625_f64) * S::from_f64(-0.125_f64)).max(r1[0]))
        + a
        + e
        + f
        + d
        + b
        + c
        + y
        + x
}

#[differentiable]
fn program_37(x: f64, y: f64) -> f64 {
    let mut a = ((0.375_f64 - x) * 0.75).sin();
    let r1 = [((-(a)) + 0.125).tanh(); 2];
    let e = mixed(&r1[0..]).sin();
    'l2: for i3 in 0..4_usize {
        let d = e;
    }
    let d = mixed(&r1).sin();
    a -= (((r1[1] * 0.375_f64).cos() + -0.375_f64).sin() * 0.75).sin();
    let a = mixed(&r1[..2]).sin();
    let f = match root((r1[0] * r1[1])) {
        Some(v) => ((d + x) * 0.375_f64).max(r1[0]),
        None => (y * x),
    };
    let f = program_18(((-(r1[0])) * 0.75).sin(), ((f * f + 0.25).sqrt() * 0.75).sin()).tanh();
    let r4 = [((r1[0] * y) * 0.75).sin(); 4];
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        'l7: for i8 in 1..=0_usize {
            let mut e = ((r1[(n6 * n6 + 1) % 2] + y) + 0.125).tanh();
            let e = program_16(
                ((a - 0.375_f64).tanh() * 0.75).sin(),
                ((r1[(n6 + 0) % 2] * ((i8 as f64) * 0.25)) + 0.125).tanh(),
            )
            .tanh();
            let f = program_9((e + 0.125).tanh(), ((0.375_f64 * x) * 0.75).sin()).tanh();
        }
        'l9: for i10 in (2..0_usize).rev() {
            if (r1[0] * -0.375_f64).abs() <= (y * x) {
                let mut p11 = Pair {
                    a: ((x - -0.375_f64).tanh() * 0.75).sin(),
                    b: ((f * ((i10 as f64) * 0.25)) + 0.125).tanh(),
                };
            }
            let f = mixed(&r4[1..]).sin();
        }
        let mut e = (-1.125_f64 * 0.75).sin();
    }
    ((0.125_f64 * -0.625_f64).cos() + (e + -0.375_f64).sin()) + f + a + d + e + y + x
}

fn program_37_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(0.375_f64) - x) * S::from_f64(0.75)).sin();
    let r1 = [((-(a)) + S::from_f64(0.125)).tanh(); 2];
    let e = mixed(&r1[0..]).sin();
    'l2: for i3 in 0..4_usize {
        let d = e;
    }
    let d = mixed(&r1).sin();
    a = a
        - (((r1[1] * S::from_f64(0.375_f64)).cos() + S::from_f64(-0.375_f64)).sin()
            * S::from_f64(0.75))
        .sin();
    let a = mixed(&r1[..2]).sin();
    let f = match root((r1[0] * r1[1])) {
        Some(v) => ((d + x) * S::from_f64(0.375_f64)).max(r1[0]),
        None => (y * x),
    };
    let f = program_18_of(
        ((-(r1[0])) * S::from_f64(0.75)).sin(),
        ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let r4 = [((r1[0] * y) * S::from_f64(0.75)).sin(); 4];
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        'l7: for i8 in 1..=0_usize {
            let mut e = ((r1[(n6 * n6 + 1) % 2] + y) + S::from_f64(0.125)).tanh();
            let e = program_16_of(
                ((a - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
                ((r1[(n6 + 0) % 2] * (S::from_f64(i8 as f64) * S::from_f64(0.25)))
                    + S::from_f64(0.125))
                .tanh(),
            )
            .tanh();
            let f = program_9_of(
                (e + S::from_f64(0.125)).tanh(),
                ((S::from_f64(0.375_f64) * x) * S::from_f64(0.75)).sin(),
            )
            .tanh();
        }
        'l9: for i10 in (2..0_usize).rev() {
            if (r1[0] * S::from_f64(-0.375_f64)).abs().cmple((y * x)) {
                let mut p11 = Pair {
                    a: ((x - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
                    b: ((f * (S::from_f64(i10 as f64) * S::from_f64(0.25))) + S::from_f64(0.125))
                        .tanh(),
                };
            }
            let f = mixed(&r4[1..]).sin();
        }
        let mut e = (S::from_f64(-1.125_f64) * S::from_f64(0.75)).sin();
    }
    ((S::from_f64(0.125_f64) * S::from_f64(-0.625_f64)).cos() + (e + S::from_f64(-0.375_f64)).sin())
        + f
        + a
        + d
        + e
        + y
        + x
}

#[differentiable]
fn program_38(x: f64, y: f64) -> f64 {
    let mut d = ((x - -1.125_f64).tanh() * 0.75).sin();
    let mut r1 = [((0.875_f64 + d) * 0.75).sin(), ((x * y) * 0.75).sin(), (d + 0.125).tanh()];
    let c = if (d + 0.625_f64) <= (x * d) {
        ((r1[0] * -0.375_f64).cos() - 0.625_f64).tanh()
    } else {
        ((y + d) * -1.125_f64).cos()
    };
    if (r1[1] * c) >= (r1[1] * -1.125_f64).max(c) {
        return ((r1[2] - c) + (c / (1.5 + d * d)));
    }
    let mut r2 = [((r1[1] + 0.125_f64).sin() + 0.125).tanh(); 4];
    'l3: for i4 in 2..2_usize {
        let l5 = List(vec![
            ((x - r2[i4 % 4]) * 0.75).sin(),
            (((i4 as f64) * 0.25) + ((i4 as f64) * 0.25)),
            ((-((i4 as f64) * 0.25)) + 0.125).tanh(),
        ]);
        let m6 = &l5
            * &List(vec![
                ((d * d + 0.25).sqrt() + 0.125).tanh(),
                (-(r1[(i4 * i4 + 1) % 3])),
                ((0.125_f64 - r1[1]) + 0.125).tanh(),
            ]);
        let a = ((m6 * l5.total()).total()).tanh();
        let mut a = ((-(c)) * 0.75).sin();
    }
    if (-(d)) >= (x + x) {
        d += (((x * 0.375_f64).max(x) + x) + 0.125).tanh();
        let mut a = ((r1[0] + x) + 0.125).tanh();
        let f = mixed(&r2[..3]).sin();
    } else {
        let a = program_32(
            ((r2[0] * -1.125_f64).abs() + 0.125).tanh(),
            ((r1[0] * -0.875_f64).max(r1[0]) + 0.125).tanh(),
        )
        .tanh();
        let e = (c * -1.125_f64).max(x);
    }
    if (x + 0.625_f64).sin() >= (r1[1] * r1[2]) {
        r2[2] *= (d + 0.125).tanh();
        let mut p7 =
            Pair { a: ((d - 0.875_f64).tanh() + 0.125).tanh(), b: ((r2[3] - d) + 0.125).tanh() };
    } else {
        if (d - c) > y {
            let b = if c >= (r1[0] * 0.625_f64).cos() {
                ((d - r2[0]) * (c + -0.625_f64).sin())
            } else {
                ((-(r1[1])) + 0.375_f64).sin()
            };
        }
    }
    c + c + d + y + x
}

fn program_38_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(0.875_f64) + d) * S::from_f64(0.75)).sin(),
        ((x * y) * S::from_f64(0.75)).sin(),
        (d + S::from_f64(0.125)).tanh(),
    ];
    let c = if (d + S::from_f64(0.625_f64)).cmple((x * d)) {
        ((r1[0] * S::from_f64(-0.375_f64)).cos() - S::from_f64(0.625_f64)).tanh()
    } else {
        ((y + d) * S::from_f64(-1.125_f64)).cos()
    };
    if (r1[1] * c).cmpge((r1[1] * S::from_f64(-1.125_f64)).max(c)) {
        return ((r1[2] - c) + (c / (S::from_f64(1.5) + d * d)));
    }
    let mut r2 = [((r1[1] + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh(); 4];
    'l3: for i4 in 2..2_usize {
        let l5 = List(vec![
            ((x - r2[i4 % 4]) * S::from_f64(0.75)).sin(),
            ((S::from_f64(i4 as f64) * S::from_f64(0.25))
                + (S::from_f64(i4 as f64) * S::from_f64(0.25))),
            ((-(S::from_f64(i4 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
        ]);
        let m6 = &l5
            * &List(vec![
                ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
                (-(r1[(i4 * i4 + 1) % 3])),
                ((S::from_f64(0.125_f64) - r1[1]) + S::from_f64(0.125)).tanh(),
            ]);
        let a = ((m6 * l5.total()).total()).tanh();
        let mut a = ((-(c)) * S::from_f64(0.75)).sin();
    }
    if (-(d)).cmpge((x + x)) {
        d = d + (((x * S::from_f64(0.375_f64)).max(x) + x) + S::from_f64(0.125)).tanh();
        let mut a = ((r1[0] + x) + S::from_f64(0.125)).tanh();
        let f = mixed(&r2[..3]).sin();
    } else {
        let a = program_32_of(
            ((r2[0] * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
            ((r1[0] * S::from_f64(-0.875_f64)).max(r1[0]) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let e = (c * S::from_f64(-1.125_f64)).max(x);
    }
    if (x + S::from_f64(0.625_f64)).sin().cmpge((r1[1] * r1[2])) {
        r2[2] = r2[2] * (d + S::from_f64(0.125)).tanh();
        let mut p7 = Pair {
            a: ((d - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
            b: ((r2[3] - d) + S::from_f64(0.125)).tanh(),
        };
    } else {
        if (d - c).cmpgt(y) {
            let b = if c.cmpge((r1[0] * S::from_f64(0.625_f64)).cos()) {
                ((d - r2[0]) * (c + S::from_f64(-0.625_f64)).sin())
            } else {
                ((-(r1[1])) + S::from_f64(0.375_f64)).sin()
            };
        }
    }
    c + c + d + y + x
}

#[differentiable]
fn program_39(x: f64, y: f64) -> f64 {
    let mut f = ((y + x) + 0.125).tanh();
    let mut r1 = [
        ((-0.625_f64 * -0.625_f64 + 0.25).sqrt() * 0.75).sin(),
        ((y * f) * 0.75).sin(),
        (x + 0.125).tanh(),
    ];
    for v in r1.iter().cycle().take(1) {
        f = (f + *v).sin();
    }
    let z2;
    if (x * x + 0.25).sqrt() < (f + -0.625_f64).sin() {
        z2 = y;
    } else {
        z2 = (-(f));
    }
    let mut e = (z2 + 0.125).tanh();
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        let e = ((z2 * -1.125_f64).abs() * (r1[2] + 0.375_f64));
    }
    let c: f64 = r1.iter().map(|v| v * ((r1[0] * -0.875_f64).max(z2) * 0.75).sin()).sum();
    'l5: for i6 in (2..3_usize).step_by(2) {
        for v in r1.iter() {
            f = f * (r1[(i6 + 0) % 3] * 0.75).sin() + *v * (r1[(i6 + 0) % 3] * 0.75).sin();
        }
    }
    let mut p7 =
        Pair { a: ((e * 0.625_f64).abs() * 0.75).sin(), b: ((r1[0] - r1[1]) * 0.75).sin() };
    let g8 = |t: f64| (f * (-0.625_f64 * -0.625_f64 + 0.25).sqrt()) * t;
    let d = (g8((r1[0] * 0.625_f64)) + g8((x * r1[0]))).sin();
    let b = match roots((r1[2] + 0.125_f64), (r1[1] + -0.875_f64)) {
        Ok(v) => (y + (p7.b + r1[1])),
        Err(true) => p7.b,
        Err(_) => (y * 0.125_f64).cos(),
    };
    e = (((x * r1[0]) - -0.125_f64).tanh() + 0.125).tanh();
    let e = ((p7.b / (1.5 + p7.b * p7.b)) - 0.125_f64).tanh();
    p7 = (p7 * p7 + p7).tamed();
    p7 = p7.tamed();
    ((-0.875_f64 + -0.125_f64).sin() + (p7.b / (1.5 + r1[1] * r1[1])))
        + e
        + b
        + d
        + c
        + z2
        + f
        + y
        + x
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
    for v in r1.iter().cycle().take(1) {
        f = (f + *v).sin();
    }
    let z2;
    if (x * x + S::from_f64(0.25)).sqrt().cmplt((f + S::from_f64(-0.625_f64)).sin()) {
        z2 = y;
    } else {
        z2 = (-(f));
    }
    let mut e = (z2 + S::from_f64(0.125)).tanh();
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        let e = ((z2 * S::from_f64(-1.125_f64)).abs() * (r1[2] + S::from_f64(0.375_f64)));
    }
    let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[0] * S::from_f64(-0.875_f64)).max(z2) * S::from_f64(0.75)).sin()
    });
    'l5: for i6 in (2..3_usize).step_by(2) {
        for v in r1.iter() {
            f = f * (r1[(i6 + 0) % 3] * S::from_f64(0.75)).sin()
                + *v * (r1[(i6 + 0) % 3] * S::from_f64(0.75)).sin();
        }
    }
    let mut p7 = Pair {
        a: ((e * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((r1[0] - r1[1]) * S::from_f64(0.75)).sin(),
    };
    let g8 = |t: S| {
        (f * (S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25)).sqrt()) * t
    };
    let d = (g8((r1[0] * S::from_f64(0.625_f64))) + g8((x * r1[0]))).sin();
    let b = match roots((r1[2] + S::from_f64(0.125_f64)), (r1[1] + S::from_f64(-0.875_f64))) {
        Ok(v) => (y + (p7.b + r1[1])),
        Err(true) => p7.b,
        Err(_) => (y * S::from_f64(0.125_f64)).cos(),
    };
    e = (((x * r1[0]) - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let e = ((p7.b / (S::from_f64(1.5) + p7.b * p7.b)) - S::from_f64(0.125_f64)).tanh();
    p7 = (p7 * p7 + p7).tamed();
    p7 = p7.tamed();
    ((S::from_f64(-0.875_f64) + S::from_f64(-0.125_f64)).sin()
        + (p7.b / (S::from_f64(1.5) + r1[1] * r1[1])))
        + e
        + b
        + d
        + c
        + z2
        + f
        + y
        + x
}

#[differentiable]
fn program_40(x: f64, y: f64) -> f64 {
    let mut b = ((y * 0.375_f64).cos() * 0.75).sin();
    let r1 = [((b + 0.125_f64).sin() * 0.75).sin(); 2];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        let (a, mut b) = (((x * b) * 0.75).sin(), (-(r1[(n3 + 1) % 2])));
    }
    let mut p4 = Pair { a: ((b / (1.5 + x * x)) + 0.125).tanh(), b: (r1[0] * 0.75).sin() };
    'l5: for i6 in 0..=2_usize {
        let a = match roots(-1.125_f64, (-((i6 as f64) * 0.25))) {
            Ok(v) => (r1[0] * 0.875_f64).abs(),
            Err(true) => r1[(i6 * i6 + 1) % 2],
            Err(_) => (((i6 as f64) * 0.25) + -0.625_f64).sin(),
        };
    }
    let g7 = |t: f64| ((-(t)) / (1.5 + (-(y)) * (-(y)))) * t;
    let b = (g7((0.875_f64 - r1[0])) + g7(b)).sin();
    let mut d = ((r1[0] * p4.a) + 0.125).tanh();
    if (0.125_f64 * 0.375_f64).cos() <= (x * x + 0.25).sqrt() {
        return ((r1[1] - y) * (r1[1] - y) + 0.25).sqrt();
    }
    d = (((p4.a * 0.875_f64).cos() * (y - -0.625_f64).tanh()) * 0.75).sin();
    d = (((r1[1] / (1.5 + d * d)) - 0.875_f64).tanh() + 0.125).tanh();
    p4 = -(Pair { a: (d + 0.125).tanh(), b: ((d + d) + 0.125).tanh() } - p4).tamed();
    p4 = p4.tamed();
    let mut u8 = r1.to_vec();
    u8.push(((-1.125_f64 + 0.125_f64).sin() + 0.125).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let b = (mixed(&u8) + u8[0]).tanh();
    p4 = (p4 * Pair { a: ((0.375_f64 + d) * 0.75).sin(), b: (y * 0.75).sin() }
        + Pair {
            a: ((p4.a / (1.5 + p4.a * p4.a)) * 0.75).sin(),
            b: ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh(),
        })
    .tamed();
    p4 = p4.tamed();
    let c = ((x * r1[1]) * -0.375_f64).abs();
    (b * -0.875_f64).max(d) + c + b + d + y + x
}

fn program_40_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [((b + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(); 2];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        let (a, mut b) = (((x * b) * S::from_f64(0.75)).sin(), (-(r1[(n3 + 1) % 2])));
    }
    let mut p4 = Pair {
        a: ((b / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        b: (r1[0] * S::from_f64(0.75)).sin(),
    };
    'l5: for i6 in 0..=2_usize {
        let a =
            match roots(S::from_f64(-1.125_f64), (-(S::from_f64(i6 as f64) * S::from_f64(0.25)))) {
                Ok(v) => (r1[0] * S::from_f64(0.875_f64)).abs(),
                Err(true) => r1[(i6 * i6 + 1) % 2],
                Err(_) => {
                    ((S::from_f64(i6 as f64) * S::from_f64(0.25)) + S::from_f64(-0.625_f64)).sin()
                }
            };
    }
    let g7 = |t: S| ((-(t)) / (S::from_f64(1.5) + (-(y)) * (-(y)))) * t;
    let b = (g7((S::from_f64(0.875_f64) - r1[0])) + g7(b)).sin();
    let mut d = ((r1[0] * p4.a) + S::from_f64(0.125)).tanh();
    if (S::from_f64(0.125_f64) * S::from_f64(0.375_f64))
        .cos()
        .cmple((x * x + S::from_f64(0.25)).sqrt())
    {
        return ((r1[1] - y) * (r1[1] - y) + S::from_f64(0.25)).sqrt();
    }
    d = (((p4.a * S::from_f64(0.875_f64)).cos() * (y - S::from_f64(-0.625_f64)).tanh())
        * S::from_f64(0.75))
    .sin();
    d = (((r1[1] / (S::from_f64(1.5) + d * d)) - S::from_f64(0.875_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    p4 = -(Pair { a: (d + S::from_f64(0.125)).tanh(), b: ((d + d) + S::from_f64(0.125)).tanh() }
        - p4)
        .tamed();
    p4 = p4.tamed();
    let mut u8 = r1.to_vec();
    u8.push(((S::from_f64(-1.125_f64) + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let b = (mixed(&u8) + u8[0]).tanh();
    p4 =
        (p4 * Pair {
            a: ((S::from_f64(0.375_f64) + d) * S::from_f64(0.75)).sin(),
            b: (y * S::from_f64(0.75)).sin(),
        } + Pair {
            a: ((p4.a / (S::from_f64(1.5) + p4.a * p4.a)) * S::from_f64(0.75)).sin(),
            b: ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        })
        .tamed();
    p4 = p4.tamed();
    let c = ((x * r1[1]) * S::from_f64(-0.375_f64)).abs();
    (b * S::from_f64(-0.875_f64)).max(d) + c + b + d + y + x
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
    f *= (((-1.125_f64 * p2.b) * -1.125_f64).max(f) + 0.125).tanh();
    p2 = (p2 * Pair { a: ((r1[2] - y) + 0.125).tanh(), b: ((f - -0.875_f64).tanh() * 0.75).sin() }
        + p2)
        .tamed();
    p2 = p2.tamed();
    'l3: for i4 in 2..4_usize {
        f = (((r1[i4 % 4] * -0.375_f64).max(p2.b) + (p2.a - -0.625_f64).tanh()) + 0.125).tanh();
        'l5: for i6 in (0..2_usize).step_by(2) {
            f = (((p2.b * x) + (r1[(i4 * i4 + 1) % 4] + -0.875_f64).sin()) + 0.125).tanh();
            let mut r7 = [((f * f) * 0.75).sin(); 5];
        }
    }
    p2 = (p2 - p2 * ((0.375_f64 - y) * 0.75).sin()).tamed();
    p2 = p2.tamed();
    let k8 = (r1[2] + p2.a);
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k8).sin();
        part.reverse();
    }
    let d = summed(|t: f64| (r1[0] * t).sin(), (x + 0.125).tanh(), 3).tanh();
    let a = match shape((r1[3] + 0.125).tanh(), ((r1[3] + -0.125_f64).sin() + 0.125).tanh()) {
        Point => (p2.b * -1.125_f64),
        Disc(v) => p2.b,
        Shape::Box { w: v, h } => y,
    };
    let mut r9 = [
        ((r1[1] + r1[3]) * 0.75).sin(),
        ((f * r1[3]) + 0.125).tanh(),
        ((d * f) * 0.75).sin(),
        ((y * y + 0.25).sqrt() + 0.125).tanh(),
        ((r1[3] * 0.375_f64).max(f) + 0.125).tanh(),
    ];
    ((r1[2] * x) + (r1[1] - 0.375_f64).tanh()) + a + d + f + y + x
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
    f = f
        * (((S::from_f64(-1.125_f64) * p2.b) * S::from_f64(-1.125_f64)).max(f)
            + S::from_f64(0.125))
        .tanh();
    p2 =
        (p2 * Pair {
            a: ((r1[2] - y) + S::from_f64(0.125)).tanh(),
            b: ((f - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        } + p2)
            .tamed();
    p2 = p2.tamed();
    'l3: for i4 in 2..4_usize {
        f = (((r1[i4 % 4] * S::from_f64(-0.375_f64)).max(p2.b)
            + (p2.a - S::from_f64(-0.625_f64)).tanh())
            + S::from_f64(0.125))
        .tanh();
        'l5: for i6 in (0..2_usize).step_by(2) {
            f = (((p2.b * x) + (r1[(i4 * i4 + 1) % 4] + S::from_f64(-0.875_f64)).sin())
                + S::from_f64(0.125))
            .tanh();
            let mut r7 = [((f * f) * S::from_f64(0.75)).sin(); 5];
        }
    }
    p2 = (p2 - p2 * ((S::from_f64(0.375_f64) - y) * S::from_f64(0.75)).sin()).tamed();
    p2 = p2.tamed();
    let k8 = (r1[2] + p2.a);
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k8).sin();
        part.reverse();
    }
    let d = summed(|t: S| (r1[0] * t).sin(), (x + S::from_f64(0.125)).tanh(), 3).tanh();
    let a = match shape(
        (r1[3] + S::from_f64(0.125)).tanh(),
        ((r1[3] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
    ) {
        Point => (p2.b * S::from_f64(-1.125_f64)),
        Disc(v) => p2.b,
        Shape::Box { w: v, h } => y,
    };
    let mut r9 = [
        ((r1[1] + r1[3]) * S::from_f64(0.75)).sin(),
        ((f * r1[3]) + S::from_f64(0.125)).tanh(),
        ((d * f) * S::from_f64(0.75)).sin(),
        ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((r1[3] * S::from_f64(0.375_f64)).max(f) + S::from_f64(0.125)).tanh(),
    ];
    ((r1[2] * x) + (r1[1] - S::from_f64(0.375_f64)).tanh()) + a + d + f + y + x
}

#[differentiable]
fn program_42(x: f64, y: f64) -> f64 {
    let mut b = ((x * x + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [(b * 0.75).sin(), ((y + b) + 0.125).tanh()];
    let (a, mut b) = (((b - r1[1]) + 0.125).tanh(), y);
    if (b * x) >= (r1[0] * r1[1]) {
        b = (((x * x + 0.25).sqrt() - 0.875_f64).tanh() * 0.75).sin();
        let mut p2 = Pair { a: ((a * x) * 0.75).sin(), b: ((b * x) * 0.75).sin() };
    }
    let (a, mut b) = ((y * 0.75).sin(), (y + y));
    if (b * -0.375_f64).abs() > r1[0] {
        return ((a / (1.5 + b * b)) * (a / (1.5 + b * b)) + 0.25).sqrt();
    }
    let by3 = (x + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    'l4: for i5 in (1..5_usize).step_by(2) {
        if (y - a) >= (y * r1[0]) {
            for v in r1.iter().cycle().take(5) {
                b = (b + *v).sin();
            }
        }
    }
    if (y + 0.375_f64).sin() > (y * 0.375_f64).cos() {
        return ((0.625_f64 + -0.875_f64).sin() - -0.375_f64).tanh();
    }
    let b = if (r1[1] + r1[0]) > (x * a) {
        ((-0.125_f64 * x) * (x + -0.875_f64).sin())
    } else {
        ((b * -0.125_f64) - 0.125_f64).tanh()
    };
    let mut c = ((x / (1.5 + b * b)) * 0.75).sin();
    let mut c = ((r1[1] + y) * 0.75).sin();
    ((a * a + 0.25).sqrt() + (x * r1[1])) + c + b + a + y + x
}

fn program_42_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [(b * S::from_f64(0.75)).sin(), ((y + b) + S::from_f64(0.125)).tanh()];
    let (a, mut b) = (((b - r1[1]) + S::from_f64(0.125)).tanh(), y);
    if (b * x).cmpge((r1[0] * r1[1])) {
        b = (((x * x + S::from_f64(0.25)).sqrt() - S::from_f64(0.875_f64)).tanh()
            * S::from_f64(0.75))
        .sin();
        let mut p2 =
            Pair { a: ((a * x) * S::from_f64(0.75)).sin(), b: ((b * x) * S::from_f64(0.75)).sin() };
    }
    let (a, mut b) = ((y * S::from_f64(0.75)).sin(), (y + y));
    if (b * S::from_f64(-0.375_f64)).abs().cmpgt(r1[0]) {
        return ((a / (S::from_f64(1.5) + b * b)) * (a / (S::from_f64(1.5) + b * b))
            + S::from_f64(0.25))
        .sqrt();
    }
    let by3 = (x + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    'l4: for i5 in (1..5_usize).step_by(2) {
        if (y - a).cmpge((y * r1[0])) {
            for v in r1.iter().cycle().take(5) {
                b = (b + *v).sin();
            }
        }
    }
    if (y + S::from_f64(0.375_f64)).sin().cmpgt((y * S::from_f64(0.375_f64)).cos()) {
        return ((S::from_f64(0.625_f64) + S::from_f64(-0.875_f64)).sin()
            - S::from_f64(-0.375_f64))
        .tanh();
    }
    let b = if (r1[1] + r1[0]).cmpgt((x * a)) {
        ((S::from_f64(-0.125_f64) * x) * (x + S::from_f64(-0.875_f64)).sin())
    } else {
        ((b * S::from_f64(-0.125_f64)) - S::from_f64(0.125_f64)).tanh()
    };
    let mut c = ((x / (S::from_f64(1.5) + b * b)) * S::from_f64(0.75)).sin();
    let mut c = ((r1[1] + y) * S::from_f64(0.75)).sin();
    ((a * a + S::from_f64(0.25)).sqrt() + (x * r1[1])) + c + b + a + y + x
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
    if (r1[1] / (1.5 + 0.125_f64 * 0.125_f64)) < (d + e) {
        let (a, mut b) = (((e * -0.125_f64).abs() + 0.125).tanh(), (x - -0.125_f64).tanh());
    } else {
        let a = List(vec![
            ((d + -0.625_f64).sin() + 0.125).tanh(),
            d,
            ((y * y + 0.25).sqrt() * 0.75).sin(),
        ])
        .folded(((r1[1] * d) + 0.125).tanh(), |s, v| (s * v + (d * 0.375_f64).abs()).sin());
    }
    if (p2.a + e) < (d + -1.125_f64) {
        let c = List(vec![
            ((r1[1] / (1.5 + r1[2] * r1[2])) * 0.75).sin(),
            (d * x),
            (r1[1] + 0.125).tanh(),
        ])
        .folded(((r1[1] + r1[2]) * 0.75).sin(), |s, v| (s * v + (x * e)).sin());
    } else {
        let r3 = [
            ((e / (1.5 + d * d)) + 0.125).tanh(),
            ((d * r1[1]) * 0.75).sin(),
            ((y * 0.875_f64) * 0.75).sin(),
            (d + 0.125).tanh(),
            (y + 0.125).tanh(),
        ];
    }
    let b = mixed(&r1).sin();
    let b = mixed(&r1).sin();
    let mut n5 = 0_usize;
    'l4: while n5 < 1 {
        n5 += 1;
        p2.turn(((b * p2.a) * 0.75).sin());
        p2 = p2.tamed();
        e += (((((n5 as f64) * 0.25) * 0.875_f64).abs() * (-(e))) * 0.75).sin();
        p2 += p2;
        p2 = p2.tamed();
    }
    0.625_f64 + b + d + e + y + x
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
    if (r1[1] / (S::from_f64(1.5) + S::from_f64(0.125_f64) * S::from_f64(0.125_f64))).cmplt((d + e))
    {
        let (a, mut b) = (
            ((e * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
            (x - S::from_f64(-0.125_f64)).tanh(),
        );
    } else {
        let a = List(vec![
            ((d + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
            d,
            ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ])
        .folded(((r1[1] * d) + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (d * S::from_f64(0.375_f64)).abs()).sin()
        });
    }
    if (p2.a + e).cmplt((d + S::from_f64(-1.125_f64))) {
        let c = List(vec![
            ((r1[1] / (S::from_f64(1.5) + r1[2] * r1[2])) * S::from_f64(0.75)).sin(),
            (d * x),
            (r1[1] + S::from_f64(0.125)).tanh(),
        ])
        .folded(((r1[1] + r1[2]) * S::from_f64(0.75)).sin(), |s, v| (s * v + (x * e)).sin());
    } else {
        let r3 = [
            ((e / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
            ((d * r1[1]) * S::from_f64(0.75)).sin(),
            ((y * S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin(),
            (d + S::from_f64(0.125)).tanh(),
            (y + S::from_f64(0.125)).tanh(),
        ];
    }
    let b = mixed(&r1).sin();
    let b = mixed(&r1).sin();
    let mut n5 = 0_usize;
    'l4: while n5 < 1 {
        n5 += 1;
        p2.turn(((b * p2.a) * S::from_f64(0.75)).sin());
        p2 = p2.tamed();
        e = e
            + ((((S::from_f64(n5 as f64) * S::from_f64(0.25)) * S::from_f64(0.875_f64)).abs()
                * (-(e)))
                * S::from_f64(0.75))
            .sin();
        p2 += p2;
        p2 = p2.tamed();
    }
    S::from_f64(0.625_f64) + b + d + e + y + x
}

#[differentiable]
fn program_44(x: f64, y: f64) -> f64 {
    let mut a = ((y - -0.375_f64).tanh() * 0.75).sin();
    let mut r1 = [((y * 0.625_f64).max(0.375_f64) + 0.125).tanh(); 2];
    a = (-1.125_f64 + 0.125).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 3 {
        n3 += 1;
        let g4 = |t: f64| {
            ((r1[(n3 * n3 + 1) % 2] * -0.875_f64) + (0.875_f64 * ((n3 as f64) * 0.25))) * t
        };
        let b = (g4((r1[n3 % 2] * ((n3 as f64) * 0.25))) + g4((x * x + 0.25).sqrt())).sin();
        let mut p5 = Pair {
            a: ((-0.375_f64 + ((n3 as f64) * 0.25)) + 0.125).tanh(),
            b: ((x * 0.625_f64).max(r1[n3 % 2]) * 0.75).sin(),
        };
    }
    a = ((-(y * a)) + 0.125).tanh();
    let a = if (-(y)) < (-(0.625_f64)) { y } else { ((x * a) * (x * -0.125_f64).abs()) };
    'l6: for i7 in 2..0_usize {
        let mut d = ((a * -0.375_f64).max(a) * 0.75).sin();
    }
    let f = mixed(&r1[..2]).sin();
    let b = if let Some(v) = root((-0.375_f64 + r1[0])) {
        ((x + v) * (x + v) + 0.25).sqrt()
    } else {
        f
    };
    let c = mixed(&r1).sin();
    let mut p8 = Pair { a: ((r1[1] - x) + 0.125).tanh(), b: ((f + x) + 0.125).tanh() };
    let c = if (y * y + 0.25).sqrt() >= -1.125_f64 {
        ((-(p8.b)) * 0.125_f64).abs()
    } else {
        ((r1[0] - r1[1]) + (-0.625_f64 * 0.875_f64).cos())
    };
    let mut r9 = [
        ((y * -0.375_f64).max(0.125_f64) * 0.75).sin(),
        ((0.375_f64 * 0.125_f64).max(0.875_f64) * 0.75).sin(),
        (p8.b * 0.75).sin(),
    ];
    r9[0] + c + b + f + a + y + x
}

fn program_44_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 =
        [((y * S::from_f64(0.625_f64)).max(S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(); 2];
    a = (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 3 {
        n3 += 1;
        let g4 = |t: S| {
            ((r1[(n3 * n3 + 1) % 2] * S::from_f64(-0.875_f64))
                + (S::from_f64(0.875_f64) * (S::from_f64(n3 as f64) * S::from_f64(0.25))))
                * t
        };
        let b = (g4((r1[n3 % 2] * (S::from_f64(n3 as f64) * S::from_f64(0.25))))
            + g4((x * x + S::from_f64(0.25)).sqrt()))
        .sin();
        let mut p5 = Pair {
            a: ((S::from_f64(-0.375_f64) + (S::from_f64(n3 as f64) * S::from_f64(0.25)))
                + S::from_f64(0.125))
            .tanh(),
            b: ((x * S::from_f64(0.625_f64)).max(r1[n3 % 2]) * S::from_f64(0.75)).sin(),
        };
    }
    a = ((-(y * a)) + S::from_f64(0.125)).tanh();
    let a = if (-(y)).cmplt((-(S::from_f64(0.625_f64)))) {
        y
    } else {
        ((x * a) * (x * S::from_f64(-0.125_f64)).abs())
    };
    'l6: for i7 in 2..0_usize {
        let mut d = ((a * S::from_f64(-0.375_f64)).max(a) * S::from_f64(0.75)).sin();
    }
    let f = mixed(&r1[..2]).sin();
    let b = if let Some(v) = root((S::from_f64(-0.375_f64) + r1[0])) {
        ((x + v) * (x + v) + S::from_f64(0.25)).sqrt()
    } else {
        f
    };
    let c = mixed(&r1).sin();
    let mut p8 = Pair {
        a: ((r1[1] - x) + S::from_f64(0.125)).tanh(),
        b: ((f + x) + S::from_f64(0.125)).tanh(),
    };
    let c = if (y * y + S::from_f64(0.25)).sqrt().cmpge(S::from_f64(-1.125_f64)) {
        ((-(p8.b)) * S::from_f64(0.125_f64)).abs()
    } else {
        ((r1[0] - r1[1]) + (S::from_f64(-0.625_f64) * S::from_f64(0.875_f64)).cos())
    };
    let mut r9 = [
        ((y * S::from_f64(-0.375_f64)).max(S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.375_f64) * S::from_f64(0.125_f64)).max(S::from_f64(0.875_f64))
            * S::from_f64(0.75))
        .sin(),
        (p8.b * S::from_f64(0.75)).sin(),
    ];
    r9[0] + c + b + f + a + y + x
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
    let e = summed(bent, ((0.625_f64 - r1[0]) * 0.75).sin(), 3).tanh();
    let e = mixed(&r1[..3]).sin();
    'l2: for i3 in (2..2_usize).step_by(2) {
        if i3 % 4 == 2 {
            break;
        }
        let mut p4 = Pair {
            a: ((r1[1] + r1[(i3 * i3 + 1) % 5]) * 0.75).sin(),
            b: ((r1[(i3 + 4) % 5] * r1[(i3 + 4) % 5] + 0.25).sqrt() * 0.75).sin(),
        };
        let e = p4.dot(&p4).sin();
    }
    'l5: for i6 in 1..3_usize {
        if (-0.375_f64 + -0.125_f64) <= (r1[(i6 * i6 + 1) % 5] + e) {
            continue;
        }
        let mut a = ((r1[4] - -0.875_f64).tanh() + 0.125).tanh();
        let mut l7 = List(vec![
            ((a * a + 0.25).sqrt() + 0.125).tanh(),
            (a * 0.875_f64).cos(),
            ((r1[(i6 * i6 + 1) % 5] + r1[(i6 * i6 + 1) % 5]) + 0.125).tanh(),
        ]);
        for i8 in 0..1_usize {
            l7 += &List(vec![
                ((-0.875_f64 - -1.125_f64).tanh() + 0.125).tanh(),
                (((i6 as f64) * 0.25) * r1[i6 % 5]),
                ((-(a)) + 0.125).tanh(),
            ]);
            if (y + y) < (a * r1[4]) {
                continue;
            }
            l7 = l7
                + List(vec![
                    ((-0.875_f64 - -1.125_f64).tanh() + 0.125).tanh(),
                    (((i6 as f64) * 0.25) * r1[i6 % 5]),
                    ((-(a)) + 0.125).tanh(),
                ]) * ((x * r1[(i6 * i6 + 1) % 5]) + 0.125).tanh();
        }
        let e = l7.total();
    }
    let b = match roots((e * y), (e + 0.625_f64).sin()) {
        Ok(v) => ((e * r1[2]) - 0.625_f64).tanh(),
        Err(true) => x,
        Err(_) => (x - y),
    };
    let e = List(vec![((r1[2] - r1[2]) + 0.125).tanh(), (y - y), ((e + r1[1]) + 0.125).tanh()])
        .folded(((-(x)) * 0.75).sin(), |s, v| (s * v + r1[1]).sin());
    let z9;
    if e < (r1[2] - -0.875_f64) {
        z9 = ((r1[2] * b) + -0.625_f64).sin();
    } else {
        z9 = (e * e);
    }
    if (e + e) >= r1[1] {
        let mut l10 =
            List(vec![((z9 * y) * 0.75).sin(), (e * 0.375_f64).max(x), ((z9 - z9) + 0.125).tanh()]);
        for i11 in 0..1_usize {
            l10 += &List(vec![
                ((x - z9) * 0.75).sin(),
                (r1[0] * r1[0] + 0.25).sqrt(),
                ((r1[2] * -0.875_f64) + 0.125).tanh(),
            ]);
            if (b * r1[4]) > (0.125_f64 * 0.875_f64).abs() {
                continue;
            }
            l10 = l10
                + List(vec![
                    ((x - z9) * 0.75).sin(),
                    (r1[0] * r1[0] + 0.25).sqrt(),
                    ((r1[2] * -0.875_f64) + 0.125).tanh(),
                ]) * ((b * -0.875_f64).max(r1[0]) * 0.75).sin();
        }
        let e = l10.total();
    }
    (b + (b * 0.375_f64).max(-0.375_f64)) + z9 + e + b + y + x
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
    let e = summed(bent, ((S::from_f64(0.625_f64) - r1[0]) * S::from_f64(0.75)).sin(), 3).tanh();
    let e = mixed(&r1[..3]).sin();
    'l2: for i3 in (2..2_usize).step_by(2) {
        if i3 % 4 == 2 {
            break;
        }
        let mut p4 = Pair {
            a: ((r1[1] + r1[(i3 * i3 + 1) % 5]) * S::from_f64(0.75)).sin(),
            b: ((r1[(i3 + 4) % 5] * r1[(i3 + 4) % 5] + S::from_f64(0.25)).sqrt()
                * S::from_f64(0.75))
            .sin(),
        };
        let e = p4.dot(&p4).sin();
    }
    'l5: for i6 in 1..3_usize {
        if (S::from_f64(-0.375_f64) + S::from_f64(-0.125_f64)).cmple((r1[(i6 * i6 + 1) % 5] + e)) {
            continue;
        }
        let mut a = ((r1[4] - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
        let mut l7 = List(vec![
            ((a * a + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            (a * S::from_f64(0.875_f64)).cos(),
            ((r1[(i6 * i6 + 1) % 5] + r1[(i6 * i6 + 1) % 5]) + S::from_f64(0.125)).tanh(),
        ]);
        for i8 in 0..1_usize {
            l7 += &List(vec![
                ((S::from_f64(-0.875_f64) - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125))
                    .tanh(),
                ((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[i6 % 5]),
                ((-(a)) + S::from_f64(0.125)).tanh(),
            ]);
            if (y + y).cmplt((a * r1[4])) {
                continue;
            }
            l7 = l7
                + List(vec![
                    ((S::from_f64(-0.875_f64) - S::from_f64(-1.125_f64)).tanh()
                        + S::from_f64(0.125))
                    .tanh(),
                    ((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[i6 % 5]),
                    ((-(a)) + S::from_f64(0.125)).tanh(),
                ]) * ((x * r1[(i6 * i6 + 1) % 5]) + S::from_f64(0.125)).tanh();
        }
        let e = l7.total();
    }
    let b = match roots((e * y), (e + S::from_f64(0.625_f64)).sin()) {
        Ok(v) => ((e * r1[2]) - S::from_f64(0.625_f64)).tanh(),
        Err(true) => x,
        Err(_) => (x - y),
    };
    let e = List(vec![
        ((r1[2] - r1[2]) + S::from_f64(0.125)).tanh(),
        (y - y),
        ((e + r1[1]) + S::from_f64(0.125)).tanh(),
    ])
    .folded(((-(x)) * S::from_f64(0.75)).sin(), |s, v| (s * v + r1[1]).sin());
    let z9;
    if e.cmplt((r1[2] - S::from_f64(-0.875_f64))) {
        z9 = ((r1[2] * b) + S::from_f64(-0.625_f64)).sin();
    } else {
        z9 = (e * e);
    }
    if (e + e).cmpge(r1[1]) {
        let mut l10 = List(vec![
            ((z9 * y) * S::from_f64(0.75)).sin(),
            (e * S::from_f64(0.375_f64)).max(x),
            ((z9 - z9) + S::from_f64(0.125)).tanh(),
        ]);
        for i11 in 0..1_usize {
            l10 += &List(vec![
                ((x - z9) * S::from_f64(0.75)).sin(),
                (r1[0] * r1[0] + S::from_f64(0.25)).sqrt(),
                ((r1[2] * S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
            ]);
            if (b * r1[4]).cmpgt((S::from_f64(0.125_f64) * S::from_f64(0.875_f64)).abs()) {
                continue;
            }
            l10 = l10
                + List(vec![
                    ((x - z9) * S::from_f64(0.75)).sin(),
                    (r1[0] * r1[0] + S::from_f64(0.25)).sqrt(),
                    ((r1[2] * S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
                ]) * ((b * S::from_f64(-0.875_f64)).max(r1[0]) * S::from_f64(0.75)).sin();
        }
        let e = l10.total();
    }
    (b + (b * S::from_f64(0.375_f64)).max(S::from_f64(-0.375_f64))) + z9 + e + b + y + x
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
    let mut r2 = [((y / (1.5 + a * a)) * 0.75).sin(); 5];
    let mut r3 = [((a + r2[4]) + 0.125).tanh(); 5];
    let e = match shape((-0.875_f64 * 0.75).sin(), ((r3[0] + r3[1]) * 0.75).sin()) {
        Point => (-(y)),
        Disc(v) => ((r1[1] * y) + -0.625_f64).sin(),
        Shape::Box { w: v, h } => ((-(r1[0])) * -0.125_f64).max(h),
    };
    if (x * 0.625_f64).max(y) < (a * -0.625_f64).cos() {
        let z4;
        if (a * -0.875_f64).max(r2[4]) > e {
            let t = ((r2[3] - 0.625_f64).tanh() + (-0.375_f64 / (1.5 + e * e)));
            z4 = ((0.625_f64 + e) + (r1[2] + 0.375_f64).sin());
        } else if (-0.375_f64 * a) <= (e - -0.875_f64).tanh() {
            z4 = bent((-0.875_f64 - -1.125_f64).tanh());
        } else {
            z4 = ((r2[3] - 0.625_f64).tanh() + (-0.375_f64 / (1.5 + e * e)));
        }
    } else {
        'l5: for i6 in (0..1_usize).rev() {
            let mut u7 = r3.to_vec();
            u7.push(((r2[(i6 + 2) % 5] * ((i6 as f64) * 0.25)) * 0.75).sin());
            u7[0] = u7[1] * u7[u7.len() - 1];
            let f = (mixed(&u7) + u7[0]).tanh();
        }
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            let e = (a / (1.5 + (y * -1.125_f64).abs() * (y * -1.125_f64).abs()));
        }
    }
    let r10 = [(0.375_f64 * 0.75).sin(), ((-0.375_f64 * -0.375_f64 + 0.25).sqrt() * 0.75).sin()];
    let c = match root((y + -0.125_f64)) {
        Some(v) => ((0.875_f64 * 0.625_f64) * -1.125_f64).abs(),
        None => (y * y + 0.25).sqrt(),
    };
    let e =
        root((-(a))).map_or((r2[1] * -0.625_f64).cos(), |v| ((v + -0.375_f64).sin() + (r3[1] * e)));
    let mut p11 = Pair { a: (r3[3] + 0.125).tanh(), b: ((r10[1] - y) * 0.75).sin() };
    for v in r1.iter().cycle().take(4) {
        a = (a + *v).sin();
    }
    ((p11.b - p11.b) - -0.125_f64).tanh() + e + c + a + y + x
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
    let mut r2 = [((y / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin(); 5];
    let mut r3 = [((a + r2[4]) + S::from_f64(0.125)).tanh(); 5];
    let e = match shape(
        (S::from_f64(-0.875_f64) * S::from_f64(0.75)).sin(),
        ((r3[0] + r3[1]) * S::from_f64(0.75)).sin(),
    ) {
        Point => (-(y)),
        Disc(v) => ((r1[1] * y) + S::from_f64(-0.625_f64)).sin(),
        Shape::Box { w: v, h } => ((-(r1[0])) * S::from_f64(-0.125_f64)).max(h),
    };
    if (x * S::from_f64(0.625_f64)).max(y).cmplt((a * S::from_f64(-0.625_f64)).cos()) {
        let z4;
        if (a * S::from_f64(-0.875_f64)).max(r2[4]).cmpgt(e) {
            let t = ((r2[3] - S::from_f64(0.625_f64)).tanh()
                + (S::from_f64(-0.375_f64) / (S::from_f64(1.5) + e * e)));
            z4 = ((S::from_f64(0.625_f64) + e) + (r1[2] + S::from_f64(0.375_f64)).sin());
        } else if (S::from_f64(-0.375_f64) * a).cmple((e - S::from_f64(-0.875_f64)).tanh()) {
            z4 = bent((S::from_f64(-0.875_f64) - S::from_f64(-1.125_f64)).tanh());
        } else {
            z4 = ((r2[3] - S::from_f64(0.625_f64)).tanh()
                + (S::from_f64(-0.375_f64) / (S::from_f64(1.5) + e * e)));
        }
    } else {
        'l5: for i6 in (0..1_usize).rev() {
            let mut u7 = r3.to_vec();
            u7.push(
                ((r2[(i6 + 2) % 5] * (S::from_f64(i6 as f64) * S::from_f64(0.25)))
                    * S::from_f64(0.75))
                .sin(),
            );
            u7[0] = u7[1] * u7[u7.len() - 1];
            let f = (mixed(&u7) + u7[0]).tanh();
        }
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            let e = (a
                / (S::from_f64(1.5)
                    + (y * S::from_f64(-1.125_f64)).abs() * (y * S::from_f64(-1.125_f64)).abs()));
        }
    }
    let r10 = [
        (S::from_f64(0.375_f64) * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
    ];
    let c = match root((y + S::from_f64(-0.125_f64))) {
        Some(v) => {
            ((S::from_f64(0.875_f64) * S::from_f64(0.625_f64)) * S::from_f64(-1.125_f64)).abs()
        }
        None => (y * y + S::from_f64(0.25)).sqrt(),
    };
    let e = root((-(a))).map_or((r2[1] * S::from_f64(-0.625_f64)).cos(), |v| {
        ((v + S::from_f64(-0.375_f64)).sin() + (r3[1] * e))
    });
    let mut p11 = Pair {
        a: (r3[3] + S::from_f64(0.125)).tanh(),
        b: ((r10[1] - y) * S::from_f64(0.75)).sin(),
    };
    for v in r1.iter().cycle().take(4) {
        a = (a + *v).sin();
    }
    ((p11.b - p11.b) - S::from_f64(-0.125_f64)).tanh() + e + c + a + y + x
}

#[differentiable]
fn program_47(x: f64, y: f64) -> f64 {
    let mut c = ((-0.625_f64 + 0.375_f64) * 0.75).sin();
    let mut r1 = [((x * -0.125_f64).abs() + 0.125).tanh(), ((y + y) + 0.125).tanh()];
    if (r1[0] * 0.375_f64).abs() > (c + c) {
        let a = match roots((x + r1[0]), (-0.375_f64 + y)) {
            Ok(v) => ((r1[0] * v) * (y + -0.875_f64).sin()),
            Err(true) => c,
            Err(_) => (r1[1] / (1.5 + y * y)),
        };
        for v in r1.iter() {
            c = c * ((-(x)) * 0.75).sin() + *v * ((-(x)) * 0.75).sin();
        }
    } else {
        'l2: for i3 in 1..2_usize {
            let (a, mut b) = ((r1[(i3 + 1) % 2] + 0.125).tanh(), x);
            let c = match shape(
                ((y * -0.375_f64).cos() + 0.125).tanh(),
                ((c * -1.125_f64).abs() + 0.125).tanh(),
            ) {
                Shape::Point => a,
                Shape::Disc(v) => ((r1[(i3 * i3 + 1) % 2] + 0.875_f64).sin() * -0.125_f64).max(c),
                Shape::Box { w: v, h } => ((x * a) * (a * b)),
            };
        }
        let mut p4 = Pair { a: ((c - x) + 0.125).tanh(), b: ((x / (1.5 + c * c)) * 0.75).sin() };
    }
    let by5 = ((-(-0.125_f64)) + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by5).sin();
    }
    let mut u6 = r1.to_vec();
    u6.push(((r1[0] * 0.125_f64).max(-0.875_f64) + 0.125).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let b = (mixed(&u6) + u6[0]).tanh();
    let mut p7 = Pair {
        a: ((0.625_f64 * 0.875_f64).abs() * 0.75).sin(),
        b: ((r1[0] * 0.875_f64).cos() + 0.125).tanh(),
    };
    let d = List(vec![
        ((b * -0.375_f64).abs() + 0.125).tanh(),
        y,
        ((r1[0] * -0.625_f64).max(r1[0]) + 0.125).tanh(),
    ])
    .folded(((b + r1[1]) + 0.125).tanh(), |s, v| (s * v + (y + p7.b)).sin());
    r1[1] = (((r1[1] * 0.875_f64).cos() - y) * 0.75).sin();
    r1[0] = (((r1[0] + -0.625_f64) * -0.125_f64).max(x) * 0.75).sin();
    'l8: for i9 in 0..=1_usize {
        let by10 = ((d * 0.875_f64).max(d) * 0.75).sin();
        for v in r1.iter_mut() {
            *v = (*v * by10).sin();
        }
    }
    ((x * r1[1]) + -0.875_f64).sin() + d + b + c + y + x
}

fn program_47_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((S::from_f64(-0.625_f64) + S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
    ];
    if (r1[0] * S::from_f64(0.375_f64)).abs().cmpgt((c + c)) {
        let a = match roots((x + r1[0]), (S::from_f64(-0.375_f64) + y)) {
            Ok(v) => ((r1[0] * v) * (y + S::from_f64(-0.875_f64)).sin()),
            Err(true) => c,
            Err(_) => (r1[1] / (S::from_f64(1.5) + y * y)),
        };
        for v in r1.iter() {
            c = c * ((-(x)) * S::from_f64(0.75)).sin() + *v * ((-(x)) * S::from_f64(0.75)).sin();
        }
    } else {
        'l2: for i3 in 1..2_usize {
            let (a, mut b) = ((r1[(i3 + 1) % 2] + S::from_f64(0.125)).tanh(), x);
            let c = match shape(
                ((y * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
                ((c * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
            ) {
                Shape::Point => a,
                Shape::Disc(v) => ((r1[(i3 * i3 + 1) % 2] + S::from_f64(0.875_f64)).sin()
                    * S::from_f64(-0.125_f64))
                .max(c),
                Shape::Box { w: v, h } => ((x * a) * (a * b)),
            };
        }
        let mut p4 = Pair {
            a: ((c - x) + S::from_f64(0.125)).tanh(),
            b: ((x / (S::from_f64(1.5) + c * c)) * S::from_f64(0.75)).sin(),
        };
    }
    let by5 = ((-(S::from_f64(-0.125_f64))) + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by5).sin();
    }
    let mut u6 = r1.to_vec();
    u6.push(
        ((r1[0] * S::from_f64(0.125_f64)).max(S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
    );
    u6[0] = u6[1] * u6[u6.len() - 1];
    let b = (mixed(&u6) + u6[0]).tanh();
    let mut p7 = Pair {
        a: ((S::from_f64(0.625_f64) * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((r1[0] * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    let d = List(vec![
        ((b * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        y,
        ((r1[0] * S::from_f64(-0.625_f64)).max(r1[0]) + S::from_f64(0.125)).tanh(),
    ])
    .folded(((b + r1[1]) + S::from_f64(0.125)).tanh(), |s, v| (s * v + (y + p7.b)).sin());
    r1[1] = (((r1[1] * S::from_f64(0.875_f64)).cos() - y) * S::from_f64(0.75)).sin();
    r1[0] = (((r1[0] + S::from_f64(-0.625_f64)) * S::from_f64(-0.125_f64)).max(x)
        * S::from_f64(0.75))
    .sin();
    'l8: for i9 in 0..=1_usize {
        let by10 = ((d * S::from_f64(0.875_f64)).max(d) * S::from_f64(0.75)).sin();
        for v in r1.iter_mut() {
            *v = (*v * by10).sin();
        }
    }
    ((x * r1[1]) + S::from_f64(-0.875_f64)).sin() + d + b + c + y + x
}

#[differentiable]
fn program_48(x: f64, y: f64) -> f64 {
    let mut f = ((y * 0.375_f64).cos() * 0.75).sin();
    let r1 = [((-(x)) + 0.125).tanh(); 5];
    if (f + -0.125_f64) >= (x * -1.125_f64).abs() {
        let f = summed(bent, ((-(y)) * 0.75).sin(), 3).tanh();
        let b = summed(bent, ((f * f + 0.25).sqrt() * 0.75).sin(), 3).tanh();
    } else {
        f -= (((y * 0.125_f64).max(f) + (f - 0.125_f64)) + 0.125).tanh();
        f = (((x * 0.125_f64) - 0.625_f64).tanh() * 0.75).sin();
    }
    'l2: for i3 in 2..5_usize {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * 0.375_f64).collect();
        u4.push(((f * -0.375_f64).max(x) + 0.125).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let b = (mixed(&u4) + u4[0]).tanh();
    }
    'l5: for i6 in (0..4_usize).rev() {
        f += (((r1[1] + ((i6 as f64) * 0.25))
            / (1.5
                + (r1[(i6 + 1) % 5] - 0.875_f64).tanh() * (r1[(i6 + 1) % 5] - 0.875_f64).tanh()))
            + 0.125)
            .tanh();
    }
    let b = mixed(&r1).sin();
    let mut u7 = r1.to_vec();
    u7.push((r1[0] * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    let b = root(x).map_or((x + b), |v| ((r1[4] - 0.875_f64).tanh() + -1.125_f64).sin());
    f += (((r1[4] * 0.125_f64).cos() * -1.125_f64).max(r1[1]) + 0.125).tanh();
    let mut p8 = Pair { a: ((f * f) * 0.75).sin(), b: ((r1[2] * -0.625_f64).cos() * 0.75).sin() };
    ((d + -0.375_f64).sin() - (y + 0.375_f64).sin()) + b + d + f + y + x
}

fn program_48_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [((-(x)) + S::from_f64(0.125)).tanh(); 5];
    if (f + S::from_f64(-0.125_f64)).cmpge((x * S::from_f64(-1.125_f64)).abs()) {
        let f = summed(bent, ((-(y)) * S::from_f64(0.75)).sin(), 3).tanh();
        let b =
            summed(bent, ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(), 3).tanh();
    } else {
        f = f
            - (((y * S::from_f64(0.125_f64)).max(f) + (f - S::from_f64(0.125_f64)))
                + S::from_f64(0.125))
            .tanh();
        f = (((x * S::from_f64(0.125_f64)) - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75))
            .sin();
    }
    'l2: for i3 in 2..5_usize {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * S::from_f64(0.375_f64)).collect();
        u4.push(((f * S::from_f64(-0.375_f64)).max(x) + S::from_f64(0.125)).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let b = (mixed(&u4) + u4[0]).tanh();
    }
    'l5: for i6 in (0..4_usize).rev() {
        f = f
            + (((r1[1] + (S::from_f64(i6 as f64) * S::from_f64(0.25)))
                / (S::from_f64(1.5)
                    + (r1[(i6 + 1) % 5] - S::from_f64(0.875_f64)).tanh()
                        * (r1[(i6 + 1) % 5] - S::from_f64(0.875_f64)).tanh()))
                + S::from_f64(0.125))
            .tanh();
    }
    let b = mixed(&r1).sin();
    let mut u7 = r1.to_vec();
    u7.push((r1[0] * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    let b = root(x).map_or((x + b), |v| {
        ((r1[4] - S::from_f64(0.875_f64)).tanh() + S::from_f64(-1.125_f64)).sin()
    });
    f = f
        + (((r1[4] * S::from_f64(0.125_f64)).cos() * S::from_f64(-1.125_f64)).max(r1[1])
            + S::from_f64(0.125))
        .tanh();
    let mut p8 = Pair {
        a: ((f * f) * S::from_f64(0.75)).sin(),
        b: ((r1[2] * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
    };
    ((d + S::from_f64(-0.375_f64)).sin() - (y + S::from_f64(0.375_f64)).sin()) + b + d + f + y + x
}

#[differentiable]
fn program_49(x: f64, y: f64) -> f64 {
    let mut b = ((x + x) + 0.125).tanh();
    let mut r1 = [((y * 0.375_f64).max(x) + 0.125).tanh(); 3];
    let mut w2 = (((x * 0.875_f64).max(-1.125_f64) + 0.125).tanh(), [(x * y); 2]);
    {
        let (p, [q, _]) = &mut w2;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w2.0 + w2.1[0] * w2.1[1]).tanh();
    if (r1[0] + 0.125_f64).sin() > (b * 0.375_f64).max(r1[1]) {
        let mut p3 = Pair {
            a: ((y - 0.125_f64).tanh() + 0.125).tanh(),
            b: ((y * 0.875_f64).abs() * 0.75).sin(),
        };
        'l4: for i5 in 2..4_usize {
            let k6 = (x / (1.5 + r1[i5 % 3] * r1[i5 % 3]));
            for part in r1.chunks_exact_mut(2) {
                part[0] = (part[0] * k6).sin();
                part.reverse();
            }
            r1[(i5 * i5 + 1) % 3] *=
                (((((i5 as f64) * 0.25) * r1[(i5 + 1) % 3]) * 0.375_f64).abs() * 0.75).sin();
        }
        let l7 = List(vec![((x + x) + 0.125).tanh(), r1[2], ((-(r1[1])) + 0.125).tanh()]);
        let m8 = &l7
            * &List(vec![
                ((p3.b * 0.875_f64).abs() * 0.75).sin(),
                (b - r1[2]),
                ((y + p3.a) + 0.125).tanh(),
            ]);
        let e = ((-&m8 + l7).total()).tanh();
    }
    b = (((b * 0.125_f64).cos() + -0.625_f64).sin() * 0.75).sin();
    let mut p9 = Pair {
        a: ((f - 0.625_f64).tanh() * 0.75).sin(),
        b: ((r1[1] * -0.625_f64).abs() * 0.75).sin(),
    };
    let d = if (b * y) < (x * x + 0.25).sqrt() { y } else { (-(b)) };
    let mut l10 = List(vec![
        ((b * -1.125_f64).cos() + 0.125).tanh(),
        (r1[0] + -0.875_f64).sin(),
        (y + 0.125).tanh(),
    ]);
    for i11 in 0..2_usize {
        l10 += &List(vec![
            ((b * 0.125_f64).max(y) * 0.75).sin(),
            (r1[1] * -0.375_f64).cos(),
            ((0.875_f64 * 0.625_f64).abs() + 0.125).tanh(),
        ]);
        if (-0.125_f64 / (1.5 + r1[0] * r1[0])) >= (p9.b / (1.5 + b * b)) {
            continue;
        }
        l10 = l10
            + List(vec![
                ((b * 0.125_f64).max(y) * 0.75).sin(),
                (r1[1] * -0.375_f64).cos(),
                ((0.875_f64 * 0.625_f64).abs() + 0.125).tanh(),
            ]) * ((r1[0] - 0.125_f64).tanh() * 0.75).sin();
    }
    let a = l10.total();
    if y < (f / (1.5 + 0.625_f64 * 0.625_f64)) {
        b -= (((0.875_f64 * -0.375_f64).max(p9.a) * 0.125_f64).abs() + 0.125).tanh();
        if (-0.375_f64 / (1.5 + b * b)) <= p9.a {
            let a = ((d + a) + (-(r1[2])));
            let d: f64 = r1.iter().map(|v| v * ((p9.a + r1[2]) * 0.75).sin()).sum();
        } else {
            let c = match roots((r1[0] * r1[0] + 0.25).sqrt(), y) {
                Ok(v) => ((b * b) - (d + p9.a)),
                Err(true) => b,
                Err(_) => (r1[0] * r1[0] + 0.25).sqrt(),
            };
            let g12 = |t: f64| ((b + -0.875_f64).sin() / (1.5 + (-(y)) * (-(y)))) * t;
            let a = (g12((a * -0.125_f64).max(r1[1])) + g12(r1[2])).sin();
            'l13: for i14 in (0..5_usize).step_by(2) {
                p9 = (p9 + p9) * (a * 0.75).sin();
                p9 = p9.tamed();
            }
        }
        let r15 = [((f - -0.875_f64).tanh() + 0.125).tanh(); 4];
    }
    ((a - 0.875_f64).tanh() + 0.625_f64).sin() + a + d + f + b + y + x
}

fn program_49_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x + x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y * S::from_f64(0.375_f64)).max(x) + S::from_f64(0.125)).tanh(); 3];
    let mut w2 = (
        ((x * S::from_f64(0.875_f64)).max(S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
        [(x * y); 2],
    );
    {
        let (p, [q, _]) = &mut w2;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w2.0 + w2.1[0] * w2.1[1]).tanh();
    if (r1[0] + S::from_f64(0.125_f64)).sin().cmpgt((b * S::from_f64(0.375_f64)).max(r1[1])) {
        let mut p3 = Pair {
            a: ((y - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            b: ((y * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
        };
        'l4: for i5 in 2..4_usize {
            let k6 = (x / (S::from_f64(1.5) + r1[i5 % 3] * r1[i5 % 3]));
            for part in r1.chunks_exact_mut(2) {
                part[0] = (part[0] * k6).sin();
                part.reverse();
            }
            r1[(i5 * i5 + 1) % 3] = r1[(i5 * i5 + 1) % 3]
                * ((((S::from_f64(i5 as f64) * S::from_f64(0.25)) * r1[(i5 + 1) % 3])
                    * S::from_f64(0.375_f64))
                .abs()
                    * S::from_f64(0.75))
                .sin();
        }
        let l7 = List(vec![
            ((x + x) + S::from_f64(0.125)).tanh(),
            r1[2],
            ((-(r1[1])) + S::from_f64(0.125)).tanh(),
        ]);
        let m8 = &l7
            * &List(vec![
                ((p3.b * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
                (b - r1[2]),
                ((y + p3.a) + S::from_f64(0.125)).tanh(),
            ]);
        let e = ((-&m8 + l7).total()).tanh();
    }
    b = (((b * S::from_f64(0.125_f64)).cos() + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75))
        .sin();
    let mut p9 = Pair {
        a: ((f - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: ((r1[1] * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    let d = if (b * y).cmplt((x * x + S::from_f64(0.25)).sqrt()) { y } else { (-(b)) };
    let mut l10 = List(vec![
        ((b * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        (r1[0] + S::from_f64(-0.875_f64)).sin(),
        (y + S::from_f64(0.125)).tanh(),
    ]);
    for i11 in 0..2_usize {
        l10 += &List(vec![
            ((b * S::from_f64(0.125_f64)).max(y) * S::from_f64(0.75)).sin(),
            (r1[1] * S::from_f64(-0.375_f64)).cos(),
            ((S::from_f64(0.875_f64) * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ]);
        if (S::from_f64(-0.125_f64) / (S::from_f64(1.5) + r1[0] * r1[0]))
            .cmpge((p9.b / (S::from_f64(1.5) + b * b)))
        {
            continue;
        }
        l10 = l10
            + List(vec![
                ((b * S::from_f64(0.125_f64)).max(y) * S::from_f64(0.75)).sin(),
                (r1[1] * S::from_f64(-0.375_f64)).cos(),
                ((S::from_f64(0.875_f64) * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125))
                    .tanh(),
            ]) * ((r1[0] - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
    }
    let a = l10.total();
    if y.cmplt((f / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))) {
        b = b
            - (((S::from_f64(0.875_f64) * S::from_f64(-0.375_f64)).max(p9.a)
                * S::from_f64(0.125_f64))
            .abs()
                + S::from_f64(0.125))
            .tanh();
        if (S::from_f64(-0.375_f64) / (S::from_f64(1.5) + b * b)).cmple(p9.a) {
            let a = ((d + a) + (-(r1[2])));
            let d = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v * ((p9.a + r1[2]) * S::from_f64(0.75)).sin()
            });
        } else {
            let c = match roots((r1[0] * r1[0] + S::from_f64(0.25)).sqrt(), y) {
                Ok(v) => ((b * b) - (d + p9.a)),
                Err(true) => b,
                Err(_) => (r1[0] * r1[0] + S::from_f64(0.25)).sqrt(),
            };
            let g12 = |t: S| {
                ((b + S::from_f64(-0.875_f64)).sin() / (S::from_f64(1.5) + (-(y)) * (-(y)))) * t
            };
            let a = (g12((a * S::from_f64(-0.125_f64)).max(r1[1])) + g12(r1[2])).sin();
            'l13: for i14 in (0..5_usize).step_by(2) {
                p9 = (p9 + p9) * (a * S::from_f64(0.75)).sin();
                p9 = p9.tamed();
            }
        }
        let r15 = [((f - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(); 4];
    }
    ((a - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.625_f64)).sin() + a + d + f + b + y + x
}

#[differentiable]
fn program_50(x: f64, y: f64) -> f64 {
    let mut f = ((x + 0.125_f64).sin() * 0.75).sin();
    let r1 = [((x * f) * 0.75).sin(); 4];
    let g2 = |t: f64| ((f * f + 0.25).sqrt() - -1.125_f64).tanh() * t;
    let d = (g2((f * 0.375_f64).max(y)) + g2((-1.125_f64 * f))).sin();
    f = (((r1[3] * f) / (1.5 + (r1[3] - 0.875_f64).tanh() * (r1[3] - 0.875_f64).tanh())) * 0.75)
        .sin();
    let f = mixed(&r1).sin();
    if r1[3] >= (r1[3] * -0.125_f64).max(r1[1]) {
        let c = List(vec![
            ((-0.875_f64 * -0.875_f64).abs() * 0.75).sin(),
            (f * f + 0.25).sqrt(),
            ((d * 0.125_f64) * 0.75).sin(),
        ])
        .folded(((d - 0.375_f64).tanh() + 0.125).tanh(), |s, v| (s * v + r1[1]).sin());
        let a = summed(
            |t: f64| (((d * 0.125_f64).max(d) * (r1[3] + t)) * t).sin(),
            ((r1[3] + x) * 0.75).sin(),
            2,
        )
        .tanh();
    }
    let mut r3 = [((r1[1] * x) * 0.75).sin(), ((r1[1] * f) * 0.75).sin()];
    let z4;
    if y >= (r3[0] * 0.875_f64).cos() {
        let t = ((d + r3[0]) - (d - f));
        z4 = ((r1[2] + -0.875_f64).sin() * (-(r1[3])));
    } else if (r1[0] + -1.125_f64).sin() < (r1[2] * r3[1]) {
        z4 = bent((r1[0] * -0.125_f64).abs());
    } else {
        z4 = ((d + r3[0]) - (d - f));
    }
    if (r1[0] - y) >= (x / (1.5 + z4 * z4)) {
        return 0.375_f64;
    }
    let a = match roots((x / (1.5 + x * x)), r3[1]) {
        Ok(v) => ((z4 * 0.625_f64).abs() + (v * 0.875_f64).max(r1[1])),
        Err(true) => z4,
        Err(_) => (r1[1] * 0.125_f64).abs(),
    };
    let mut p5 = Pair {
        a: ((y * -0.875_f64).max(d) + 0.125).tanh(),
        b: ((f - 0.875_f64).tanh() + 0.125).tanh(),
    };
    'l6: for i7 in (1..1_usize).rev() {
        let mut b = ((z4 - ((i7 as f64) * 0.25)) + 0.125).tanh();
        let d = List(vec![
            ((x + 0.875_f64).sin() + 0.125).tanh(),
            (r1[(i7 + 1) % 4] - a),
            ((r1[2] - p5.a) * 0.75).sin(),
        ])
        .folded(((b - -0.375_f64).tanh() + 0.125).tanh(), |s, v| {
            (s * v + (((i7 as f64) * 0.25) * 0.125_f64).abs()).sin()
        });
    }
    ((0.125_f64 - -0.625_f64).tanh() + 0.375_f64) + a + z4 + f + d + y + x
}

fn program_50_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let r1 = [((x * f) * S::from_f64(0.75)).sin(); 4];
    let g2 = |t: S| ((f * f + S::from_f64(0.25)).sqrt() - S::from_f64(-1.125_f64)).tanh() * t;
    let d = (g2((f * S::from_f64(0.375_f64)).max(y)) + g2((S::from_f64(-1.125_f64) * f))).sin();
    f = (((r1[3] * f)
        / (S::from_f64(1.5)
            + (r1[3] - S::from_f64(0.875_f64)).tanh() * (r1[3] - S::from_f64(0.875_f64)).tanh()))
        * S::from_f64(0.75))
    .sin();
    let f = mixed(&r1).sin();
    if r1[3].cmpge((r1[3] * S::from_f64(-0.125_f64)).max(r1[1])) {
        let c = List(vec![
            ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(),
            (f * f + S::from_f64(0.25)).sqrt(),
            ((d * S::from_f64(0.125_f64)) * S::from_f64(0.75)).sin(),
        ])
        .folded(((d - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + r1[1]).sin()
        });
        let a = summed(
            |t: S| (((d * S::from_f64(0.125_f64)).max(d) * (r1[3] + t)) * t).sin(),
            ((r1[3] + x) * S::from_f64(0.75)).sin(),
            2,
        )
        .tanh();
    }
    let mut r3 = [((r1[1] * x) * S::from_f64(0.75)).sin(), ((r1[1] * f) * S::from_f64(0.75)).sin()];
    let z4;
    if y.cmpge((r3[0] * S::from_f64(0.875_f64)).cos()) {
        let t = ((d + r3[0]) - (d - f));
        z4 = ((r1[2] + S::from_f64(-0.875_f64)).sin() * (-(r1[3])));
    } else if (r1[0] + S::from_f64(-1.125_f64)).sin().cmplt((r1[2] * r3[1])) {
        z4 = bent((r1[0] * S::from_f64(-0.125_f64)).abs());
    } else {
        z4 = ((d + r3[0]) - (d - f));
    }
    if (r1[0] - y).cmpge((x / (S::from_f64(1.5) + z4 * z4))) {
        return S::from_f64(0.375_f64);
    }
    let a = match roots((x / (S::from_f64(1.5) + x * x)), r3[1]) {
        Ok(v) => ((z4 * S::from_f64(0.625_f64)).abs() + (v * S::from_f64(0.875_f64)).max(r1[1])),
        Err(true) => z4,
        Err(_) => (r1[1] * S::from_f64(0.125_f64)).abs(),
    };
    let mut p5 = Pair {
        a: ((y * S::from_f64(-0.875_f64)).max(d) + S::from_f64(0.125)).tanh(),
        b: ((f - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    'l6: for i7 in (1..1_usize).rev() {
        let mut b =
            ((z4 - (S::from_f64(i7 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh();
        let d = List(vec![
            ((x + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
            (r1[(i7 + 1) % 4] - a),
            ((r1[2] - p5.a) * S::from_f64(0.75)).sin(),
        ])
        .folded(
            ((b - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
            |s, v| {
                (s * v
                    + ((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64)).abs())
                .sin()
            },
        );
    }
    ((S::from_f64(0.125_f64) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.375_f64))
        + a
        + z4
        + f
        + d
        + y
        + x
}

#[differentiable]
fn program_51(x: f64, y: f64) -> f64 {
    let mut b = ((0.875_f64 - 0.625_f64) + 0.125).tanh();
    let mut r1 = [
        (b + 0.125).tanh(),
        ((b * 0.625_f64).abs() + 0.125).tanh(),
        ((b / (1.5 + x * x)) * 0.75).sin(),
    ];
    b -= (((b * y) * 0.625_f64).abs() * 0.75).sin();
    let c: f64 = r1.iter().map(|v| v * ((y + -0.375_f64).sin() * 0.75).sin()).sum();
    b = (((r1[0] * 0.375_f64).max(r1[0]) * (x * 0.375_f64).cos()) * 0.75).sin();
    let mut p2 = Pair { a: ((y - -0.625_f64).tanh() * 0.75).sin(), b: (y + 0.125).tanh() };
    let b = ((b * 0.375_f64) + (r1[2] * r1[1]));
    let mut l3 = List(vec![(x + 0.125).tanh(), (b + -0.125_f64).sin(), ((-(x)) * 0.75).sin()]);
    for i4 in 0..1_usize {
        l3 += &List(vec![
            ((y * 0.625_f64).max(x) + 0.125).tanh(),
            (c - 0.375_f64).tanh(),
            ((x * -1.125_f64) + 0.125).tanh(),
        ]);
        if (y / (1.5 + c * c)) < (r1[1] * 0.625_f64).max(r1[1]) {
            continue;
        }
        l3 = &l3
            * &List(vec![
                ((y * 0.625_f64).max(x) + 0.125).tanh(),
                (c - 0.375_f64).tanh(),
                ((x * -1.125_f64) + 0.125).tanh(),
            ]);
    }
    let f = l3.total();
    let f = if (f - y) < (y * y + 0.25).sqrt() {
        ((b - p2.b) / (1.5 + x * x))
    } else {
        ((y * p2.a) - -1.125_f64).tanh()
    };
    let mut c = ((r1[1] * r1[2]) * 0.75).sin();
    let mut u5: Vec<_> = r1.iter().map(|v| *v * r1[0]).collect();
    u5.push((c * 0.75).sin());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let f = (mixed(&u5) + u5[0]).tanh();
    c = (((r1[1] * x) - (r1[1] - r1[0])) + 0.125).tanh();
    let e = if (y * c) >= (y * -0.375_f64).max(c) {
        ((c * 0.125_f64).cos() * 0.625_f64).max(r1[0])
    } else {
        r1[1]
    };
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        let (a, mut b) = (((e + r1[n7 % 3]) + 0.125).tanh(), (-(r1[(n7 * n7 + 1) % 3])));
        let d = summed(
            |t: f64| (((r1[(n7 + 2) % 3] + 0.125_f64) * 0.125_f64).max(e) * t).sin(),
            ((e * r1[(n7 + 0) % 3]) + 0.125).tanh(),
            3,
        )
        .tanh();
    }
    ((y + p2.b) * -0.875_f64).cos() + e + f + c + b + y + x
}

fn program_51_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((S::from_f64(0.875_f64) - S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (b + S::from_f64(0.125)).tanh(),
        ((b * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((b / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ];
    b = b - (((b * y) * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((y + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin()
    });
    b = (((r1[0] * S::from_f64(0.375_f64)).max(r1[0]) * (x * S::from_f64(0.375_f64)).cos())
        * S::from_f64(0.75))
    .sin();
    let mut p2 = Pair {
        a: ((y - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: (y + S::from_f64(0.125)).tanh(),
    };
    let b = ((b * S::from_f64(0.375_f64)) + (r1[2] * r1[1]));
    let mut l3 = List(vec![
        (x + S::from_f64(0.125)).tanh(),
        (b + S::from_f64(-0.125_f64)).sin(),
        ((-(x)) * S::from_f64(0.75)).sin(),
    ]);
    for i4 in 0..1_usize {
        l3 += &List(vec![
            ((y * S::from_f64(0.625_f64)).max(x) + S::from_f64(0.125)).tanh(),
            (c - S::from_f64(0.375_f64)).tanh(),
            ((x * S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
        ]);
        if (y / (S::from_f64(1.5) + c * c)).cmplt((r1[1] * S::from_f64(0.625_f64)).max(r1[1])) {
            continue;
        }
        l3 = &l3
            * &List(vec![
                ((y * S::from_f64(0.625_f64)).max(x) + S::from_f64(0.125)).tanh(),
                (c - S::from_f64(0.375_f64)).tanh(),
                ((x * S::from_f64(-1.125_f64)) + S::from_f64(0.125)).tanh(),
            ]);
    }
    let f = l3.total();
    let f = if (f - y).cmplt((y * y + S::from_f64(0.25)).sqrt()) {
        ((b - p2.b) / (S::from_f64(1.5) + x * x))
    } else {
        ((y * p2.a) - S::from_f64(-1.125_f64)).tanh()
    };
    let mut c = ((r1[1] * r1[2]) * S::from_f64(0.75)).sin();
    let mut u5: Vec<_> = r1.iter().map(|v| *v * r1[0]).collect();
    u5.push((c * S::from_f64(0.75)).sin());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let f = (mixed(&u5) + u5[0]).tanh();
    c = (((r1[1] * x) - (r1[1] - r1[0])) + S::from_f64(0.125)).tanh();
    let e = if (y * c).cmpge((y * S::from_f64(-0.375_f64)).max(c)) {
        ((c * S::from_f64(0.125_f64)).cos() * S::from_f64(0.625_f64)).max(r1[0])
    } else {
        r1[1]
    };
    let mut n7 = 0_usize;
    'l6: while n7 < 1 {
        n7 += 1;
        let (a, mut b) =
            (((e + r1[n7 % 3]) + S::from_f64(0.125)).tanh(), (-(r1[(n7 * n7 + 1) % 3])));
        let d = summed(
            |t: S| {
                (((r1[(n7 + 2) % 3] + S::from_f64(0.125_f64)) * S::from_f64(0.125_f64)).max(e) * t)
                    .sin()
            },
            ((e * r1[(n7 + 0) % 3]) + S::from_f64(0.125)).tanh(),
            3,
        )
        .tanh();
    }
    ((y + p2.b) * S::from_f64(-0.875_f64)).cos() + e + f + c + b + y + x
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
    let z2;
    if (y + r1[3]) < (x * r1[0]) {
        let t = ((r1[3] - r1[0]) * (r1[1] * r1[1] + 0.25).sqrt());
        z2 = (-(r1[2] * e));
    } else if (y * x) > (e * 0.875_f64) {
        z2 = bent((y + r1[1]));
    } else {
        z2 = ((r1[3] - r1[0]) * (r1[1] * r1[1] + 0.25).sqrt());
    }
    let mut c = ((x + x) + 0.125).tanh();
    let (a, mut b) = (((-0.125_f64 - -0.875_f64).tanh() + 0.125).tanh(), r1[2]);
    let mut p3 = Pair { a: ((r1[2] + r1[2]) + 0.125).tanh(), b: ((r1[2] - x) * 0.75).sin() };
    let d = program_20(((r1[2] + b) * 0.75).sin(), ((c + -0.125_f64).sin() + 0.125).tanh()).tanh();
    if (p3.b + a) > (x * r1[0]) {
        let c = ((b * z2) * -0.875_f64).max(e);
        let f = mixed(&r1[0..]).sin();
        b = (((p3.b + x) - (p3.b * 0.875_f64).max(z2)) * 0.75).sin();
    } else {
        let g4 = |t: f64| ((-0.875_f64 - b) * (z2 + -0.875_f64).sin()) * t;
        let d = (g4((r1[1] * -0.625_f64).max(0.625_f64)) + g4((d * 0.625_f64).max(r1[0]))).sin();
    }
    let mut z5;
    if (r1[3] * 0.875_f64).abs() <= e {
        let t = ((r1[1] + r1[0]) * -0.125_f64).max(r1[0]);
        z5 = ((a * y) + (p3.a * t));
    } else if (d * e) >= (x * 0.625_f64).max(r1[1]) {
        z5 = bent(r1[1]);
    } else {
        z5 = ((r1[1] + r1[0]) * -0.125_f64).max(r1[0]);
    }
    z5 = z5 * r1[1];
    'l6: for i7 in 1..1_usize {
        let b = mixed(&r1[2..]).sin();
        for v in r1.iter() {
            z5 = z5 * ((c * e) + 0.125).tanh() + *v * ((c * e) + 0.125).tanh();
        }
        let mut p8 =
            Pair { a: ((b * 0.625_f64).abs() + 0.125).tanh(), b: ((a * p3.b) + 0.125).tanh() };
    }
    ((r1[2] + r1[3]) - (p3.b - 0.875_f64).tanh()) + z5 + d + b + a + c + z2 + e + y + x
}

fn program_52_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((e + e) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.625_f64)).max(e) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.875_f64)).max(y) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
    ];
    let z2;
    if (y + r1[3]).cmplt((x * r1[0])) {
        let t = ((r1[3] - r1[0]) * (r1[1] * r1[1] + S::from_f64(0.25)).sqrt());
        z2 = (-(r1[2] * e));
    } else if (y * x).cmpgt((e * S::from_f64(0.875_f64))) {
        z2 = bent((y + r1[1]));
    } else {
        z2 = ((r1[3] - r1[0]) * (r1[1] * r1[1] + S::from_f64(0.25)).sqrt());
    }
    let mut c = ((x + x) + S::from_f64(0.125)).tanh();
    let (a, mut b) = (
        ((S::from_f64(-0.125_f64) - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        r1[2],
    );
    let mut p3 = Pair {
        a: ((r1[2] + r1[2]) + S::from_f64(0.125)).tanh(),
        b: ((r1[2] - x) * S::from_f64(0.75)).sin(),
    };
    let d = program_20_of(
        ((r1[2] + b) * S::from_f64(0.75)).sin(),
        ((c + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    if (p3.b + a).cmpgt((x * r1[0])) {
        let c = ((b * z2) * S::from_f64(-0.875_f64)).max(e);
        let f = mixed(&r1[0..]).sin();
        b = (((p3.b + x) - (p3.b * S::from_f64(0.875_f64)).max(z2)) * S::from_f64(0.75)).sin();
    } else {
        let g4 = |t: S| ((S::from_f64(-0.875_f64) - b) * (z2 + S::from_f64(-0.875_f64)).sin()) * t;
        let d = (g4((r1[1] * S::from_f64(-0.625_f64)).max(S::from_f64(0.625_f64)))
            + g4((d * S::from_f64(0.625_f64)).max(r1[0])))
        .sin();
    }
    let mut z5;
    if (r1[3] * S::from_f64(0.875_f64)).abs().cmple(e) {
        let t = ((r1[1] + r1[0]) * S::from_f64(-0.125_f64)).max(r1[0]);
        z5 = ((a * y) + (p3.a * t));
    } else if (d * e).cmpge((x * S::from_f64(0.625_f64)).max(r1[1])) {
        z5 = bent(r1[1]);
    } else {
        z5 = ((r1[1] + r1[0]) * S::from_f64(-0.125_f64)).max(r1[0]);
    }
    z5 = z5 * r1[1];
    'l6: for i7 in 1..1_usize {
        let b = mixed(&r1[2..]).sin();
        for v in r1.iter() {
            z5 = z5 * ((c * e) + S::from_f64(0.125)).tanh()
                + *v * ((c * e) + S::from_f64(0.125)).tanh();
        }
        let mut p8 = Pair {
            a: ((b * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            b: ((a * p3.b) + S::from_f64(0.125)).tanh(),
        };
    }
    ((r1[2] + r1[3]) - (p3.b - S::from_f64(0.875_f64)).tanh()) + z5 + d + b + a + c + z2 + e + y + x
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
    let (a, mut b) = (((-0.875_f64 * r1[0]) * 0.75).sin(), (0.875_f64 - 0.875_f64).tanh());
    #[differentiable(checkpoint)]
    'l2: for i3 in (2..3_usize).rev() {
        b = (((y / (1.5 + ((i3 as f64) * 0.25) * ((i3 as f64) * 0.25))) * -1.125_f64).abs()
            + 0.125)
            .tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 1 {
            n5 += 1;
            let mut u6: Vec<_> = r1.iter().map(|v| *v * r1[(n5 + 1) % 4]).collect();
            u6.push(((r1[(n5 + 1) % 4] * -0.125_f64).abs() + 0.125).tanh());
            u6[0] = u6[1] * u6[u6.len() - 1];
            let f = (mixed(&u6) + u6[0]).tanh();
        }
        if (0.375_f64 / (1.5 + r1[0] * r1[0])) < (((i3 as f64) * 0.25) * 0.375_f64).cos() {
            let mut c = (y + 0.125).tanh();
        } else {
            let f = match roots((r1[(i3 * i3 + 1) % 4] * a), (r1[3] * -0.625_f64).abs()) {
                Ok(v) => ((a * r1[0]) * 0.375_f64).abs(),
                Err(true) => a,
                Err(_) => (y * -0.125_f64).max(x),
            };
            let mut p7 =
                Pair { a: (b * 0.75).sin(), b: ((r1[(i3 + 3) % 4] * r1[2]) + 0.125).tanh() };
        }
    }
    for v in r1.iter() {
        b = b * ((b * -1.125_f64) * 0.75).sin() + *v * ((b * -1.125_f64) * 0.75).sin();
    }
    r1[1] = (((r1[0] + -0.625_f64).sin() + (a * -0.375_f64).cos()) * 0.75).sin();
    let d: f64 = r1.iter().map(|v| v * ((-(r1[3])) * 0.75).sin()).sum();
    let mut u8: Vec<_> = r1.iter().map(|v| *v * 0.125_f64).collect();
    u8.push((y + 0.125).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let e = (mixed(&u8) + u8[0]).tanh();
    let mut p9 =
        Pair { a: ((r1[0] + e) * 0.75).sin(), b: ((r1[0] * -0.125_f64).max(y) * 0.75).sin() };
    d + e + d + b + a + y + x
}

fn program_53_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin(),
        ((y * y) + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
        ((a * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let (a, mut b) = (
        ((S::from_f64(-0.875_f64) * r1[0]) * S::from_f64(0.75)).sin(),
        (S::from_f64(0.875_f64) - S::from_f64(0.875_f64)).tanh(),
    );

    'l2: for i3 in (2..3_usize).rev() {
        b = (((y
            / (S::from_f64(1.5)
                + (S::from_f64(i3 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i3 as f64) * S::from_f64(0.25))))
            * S::from_f64(-1.125_f64))
        .abs()
            + S::from_f64(0.125))
        .tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 1 {
            n5 += 1;
            let mut u6: Vec<_> = r1.iter().map(|v| *v * r1[(n5 + 1) % 4]).collect();
            u6.push(
                ((r1[(n5 + 1) % 4] * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
            );
            u6[0] = u6[1] * u6[u6.len() - 1];
            let f = (mixed(&u6) + u6[0]).tanh();
        }
        if (S::from_f64(0.375_f64) / (S::from_f64(1.5) + r1[0] * r1[0]))
            .cmplt(((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(0.375_f64)).cos())
        {
            let mut c = (y + S::from_f64(0.125)).tanh();
        } else {
            let f =
                match roots((r1[(i3 * i3 + 1) % 4] * a), (r1[3] * S::from_f64(-0.625_f64)).abs()) {
                    Ok(v) => ((a * r1[0]) * S::from_f64(0.375_f64)).abs(),
                    Err(true) => a,
                    Err(_) => (y * S::from_f64(-0.125_f64)).max(x),
                };
            let mut p7 = Pair {
                a: (b * S::from_f64(0.75)).sin(),
                b: ((r1[(i3 + 3) % 4] * r1[2]) + S::from_f64(0.125)).tanh(),
            };
        }
    }
    for v in r1.iter() {
        b = b * ((b * S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin()
            + *v * ((b * S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin();
    }
    r1[1] = (((r1[0] + S::from_f64(-0.625_f64)).sin() + (a * S::from_f64(-0.375_f64)).cos())
        * S::from_f64(0.75))
    .sin();
    let d =
        r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * ((-(r1[3])) * S::from_f64(0.75)).sin());
    let mut u8: Vec<_> = r1.iter().map(|v| *v * S::from_f64(0.125_f64)).collect();
    u8.push((y + S::from_f64(0.125)).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let e = (mixed(&u8) + u8[0]).tanh();
    let mut p9 = Pair {
        a: ((r1[0] + e) * S::from_f64(0.75)).sin(),
        b: ((r1[0] * S::from_f64(-0.125_f64)).max(y) * S::from_f64(0.75)).sin(),
    };
    d + e + d + b + a + y + x
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
    'l2: for i3 in (0..4_usize).rev() {
        let mut p4 = Pair {
            a: ((-((i3 as f64) * 0.25)) * 0.75).sin(),
            b: ((r1[i3 % 4] + 0.375_f64) * 0.75).sin(),
        };
    }
    let mut w5 = (((r1[1] - 0.125_f64).tanh() * 0.75).sin(), [(r1[0] - e); 2]);
    {
        let (ref mut p, [ref mut q, _]) = w5;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w5.0 + w5.1[0] * w5.1[1]).tanh();
    let mut r6 = [
        ((0.875_f64 / (1.5 + x * x)) * 0.75).sin(),
        ((r1[0] + -1.125_f64).sin() * 0.75).sin(),
        ((r1[3] + r1[2]) * 0.75).sin(),
    ];
    let mut u7: Vec<_> = r6.iter().map(|v| *v * f).collect();
    u7.push(((r6[0] * -1.125_f64).abs() * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    r6[0] += (r6[1] + 0.125).tanh();
    let mut p8 = Pair {
        a: ((-0.375_f64 * -0.375_f64 + 0.25).sqrt() + 0.125).tanh(),
        b: ((y * d) + 0.125).tanh(),
    };
    let d = program_46(
        ((-0.625_f64 + -0.375_f64).sin() * 0.75).sin(),
        ((r6[2] / (1.5 + 0.625_f64 * 0.625_f64)) * 0.75).sin(),
    )
    .tanh();
    if (r1[2] + r6[2]) < (x * -0.125_f64).abs() {
        let mut u9 = r1.to_vec();
        u9.push(((r6[1] * p8.a) + 0.125).tanh());
        u9[0] = u9[1] * u9[u9.len() - 1];
        let d = (mixed(&u9) + u9[0]).tanh();
        let a = if (f + r6[0]) >= (r1[1] + 0.375_f64).sin() {
            ((f * r1[0]) + -0.875_f64).sin()
        } else {
            ((r1[0] * -0.875_f64).abs() + 0.375_f64).sin()
        };
    } else {
        e = (((r6[2] * -0.125_f64).abs() - (f - y)) + 0.125).tanh();
        let mut p10 =
            Pair { a: ((f * d) * 0.75).sin(), b: ((p8.a / (1.5 + r1[1] * r1[1])) + 0.125).tanh() };
        let z11;
        if (r1[2] * r6[1]) > (y + p8.a) {
            let t = ((e * e + 0.25).sqrt() + -0.375_f64).sin();
            z11 = ((p8.a + -0.125_f64).sin() + (f * r1[3]));
        } else if e >= (r6[2] * 0.375_f64).max(d) {
            z11 = bent((r1[0] * d));
        } else {
            z11 = ((e * e + 0.25).sqrt() + -0.375_f64).sin();
        }
    }
    (-(-(y))) + d + f + e + y + x
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
    'l2: for i3 in (0..4_usize).rev() {
        let mut p4 = Pair {
            a: ((-(S::from_f64(i3 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
            b: ((r1[i3 % 4] + S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        };
    }
    let mut w5 =
        (((r1[1] - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(), [(r1[0] - e); 2]);
    {
        let (ref mut p, [ref mut q, _]) = w5;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w5.0 + w5.1[0] * w5.1[1]).tanh();
    let mut r6 = [
        ((S::from_f64(0.875_f64) / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
        ((r1[0] + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((r1[3] + r1[2]) * S::from_f64(0.75)).sin(),
    ];
    let mut u7: Vec<_> = r6.iter().map(|v| *v * f).collect();
    u7.push(((r6[0] * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let d = (mixed(&u7) + u7[0]).tanh();
    r6[0] = r6[0] + (r6[1] + S::from_f64(0.125)).tanh();
    let mut p8 = Pair {
        a: ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt()
            + S::from_f64(0.125))
        .tanh(),
        b: ((y * d) + S::from_f64(0.125)).tanh(),
    };
    let d = program_46_of(
        ((S::from_f64(-0.625_f64) + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((r6[2] / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
            * S::from_f64(0.75))
        .sin(),
    )
    .tanh();
    if (r1[2] + r6[2]).cmplt((x * S::from_f64(-0.125_f64)).abs()) {
        let mut u9 = r1.to_vec();
        u9.push(((r6[1] * p8.a) + S::from_f64(0.125)).tanh());
        u9[0] = u9[1] * u9[u9.len() - 1];
        let d = (mixed(&u9) + u9[0]).tanh();
        let a = if (f + r6[0]).cmpge((r1[1] + S::from_f64(0.375_f64)).sin()) {
            ((f * r1[0]) + S::from_f64(-0.875_f64)).sin()
        } else {
            ((r1[0] * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.375_f64)).sin()
        };
    } else {
        e = (((r6[2] * S::from_f64(-0.125_f64)).abs() - (f - y)) + S::from_f64(0.125)).tanh();
        let mut p10 = Pair {
            a: ((f * d) * S::from_f64(0.75)).sin(),
            b: ((p8.a / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh(),
        };
        let z11;
        if (r1[2] * r6[1]).cmpgt((y + p8.a)) {
            let t = ((e * e + S::from_f64(0.25)).sqrt() + S::from_f64(-0.375_f64)).sin();
            z11 = ((p8.a + S::from_f64(-0.125_f64)).sin() + (f * r1[3]));
        } else if e.cmpge((r6[2] * S::from_f64(0.375_f64)).max(d)) {
            z11 = bent((r1[0] * d));
        } else {
            z11 = ((e * e + S::from_f64(0.25)).sqrt() + S::from_f64(-0.375_f64)).sin();
        }
    }
    (-(-(y))) + d + f + e + y + x
}

#[differentiable]
fn program_55(x: f64, y: f64) -> f64 {
    let mut a = ((y + x) + 0.125).tanh();
    let mut r1 = [(y * 0.75).sin(); 5];
    'l2: for i3 in (0..4_usize).rev() {
        let z4;
        if (x - r1[(i3 * i3 + 1) % 5]) >= (r1[i3 % 5] + 0.125_f64).sin() {
            z4 = (-(a / (1.5 + y * y)));
        } else {
            z4 = (x - 0.375_f64).tanh();
        }
        if (((i3 as f64) * 0.25) + z4) < a {
            let mut p5 = Pair {
                a: ((x + -0.625_f64) * 0.75).sin(),
                b: ((((i3 as f64) * 0.25) + r1[i3 % 5]) + 0.125).tanh(),
            };
        } else {
            let mut d = (z4 + 0.125).tanh();
            a += ((z4 * a) * 0.75).sin();
            let g6 = |t: f64| {
                ((((i3 as f64) * 0.25) - r1[(i3 * i3 + 1) % 5]) - (x * r1[(i3 * i3 + 1) % 5])) * t
            };
            let b = (g6((-0.875_f64 * x)) + g6((r1[i3 % 5] * r1[i3 % 5] + 0.25).sqrt())).sin();
        }
        let c = ((y * -0.875_f64).max(z4) * -1.125_f64).abs();
    }
    let (a, mut b) = (((y * y) + 0.125).tanh(), (r1[2] * r1[2] + 0.25).sqrt());
    let mut p7 =
        Pair { a: ((x * -1.125_f64).max(r1[0]) * 0.75).sin(), b: (-0.375_f64 * 0.75).sin() };
    let a = List(vec![
        ((y * 0.375_f64).cos() + 0.125).tanh(),
        (a * a + 0.25).sqrt(),
        ((y * -0.375_f64).cos() * 0.75).sin(),
    ])
    .folded(((x * y) + 0.125).tanh(), |s, v| (s * v + (y + 0.625_f64)).sin());
    'l8: for i9 in (1..2_usize).rev() {
        let a = program_39(
            ((r1[(i9 * i9 + 1) % 5] * r1[i9 % 5]) + 0.125).tanh(),
            ((r1[(i9 + 3) % 5] * 0.375_f64).cos() + 0.125).tanh(),
        )
        .tanh();
    }
    let d = match shape(((y * p7.b) + 0.125).tanh(), ((a * 0.125_f64).cos() + 0.125).tanh()) {
        Point => (r1[1] * r1[0]),
        Disc(v) => ((p7.a - 0.875_f64).tanh() - (r1[4] * a)),
        Shape::Box { w: v, h } => ((h * h + 0.25).sqrt() * (h + v)),
    };
    ((-0.125_f64 + 0.375_f64).sin() - -1.125_f64).tanh() + d + a + b + y + x
}

fn program_55_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y + x) + S::from_f64(0.125)).tanh();
    let mut r1 = [(y * S::from_f64(0.75)).sin(); 5];
    'l2: for i3 in (0..4_usize).rev() {
        let z4;
        if (x - r1[(i3 * i3 + 1) % 5]).cmpge((r1[i3 % 5] + S::from_f64(0.125_f64)).sin()) {
            z4 = (-(a / (S::from_f64(1.5) + y * y)));
        } else {
            z4 = (x - S::from_f64(0.375_f64)).tanh();
        }
        if ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + z4).cmplt(a) {
            let mut p5 = Pair {
                a: ((x + S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
                b: (((S::from_f64(i3 as f64) * S::from_f64(0.25)) + r1[i3 % 5])
                    + S::from_f64(0.125))
                .tanh(),
            };
        } else {
            let mut d = (z4 + S::from_f64(0.125)).tanh();
            a = a + ((z4 * a) * S::from_f64(0.75)).sin();
            let g6 = |t: S| {
                (((S::from_f64(i3 as f64) * S::from_f64(0.25)) - r1[(i3 * i3 + 1) % 5])
                    - (x * r1[(i3 * i3 + 1) % 5]))
                    * t
            };
            let b = (g6((S::from_f64(-0.875_f64) * x))
                + g6((r1[i3 % 5] * r1[i3 % 5] + S::from_f64(0.25)).sqrt()))
            .sin();
        }
        let c = ((y * S::from_f64(-0.875_f64)).max(z4) * S::from_f64(-1.125_f64)).abs();
    }
    let (a, mut b) =
        (((y * y) + S::from_f64(0.125)).tanh(), (r1[2] * r1[2] + S::from_f64(0.25)).sqrt());
    let mut p7 = Pair {
        a: ((x * S::from_f64(-1.125_f64)).max(r1[0]) * S::from_f64(0.75)).sin(),
        b: (S::from_f64(-0.375_f64) * S::from_f64(0.75)).sin(),
    };
    let a = List(vec![
        ((y * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        (a * a + S::from_f64(0.25)).sqrt(),
        ((y * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
    ])
    .folded(((x * y) + S::from_f64(0.125)).tanh(), |s, v| {
        (s * v + (y + S::from_f64(0.625_f64))).sin()
    });
    'l8: for i9 in (1..2_usize).rev() {
        let a = program_39_of(
            ((r1[(i9 * i9 + 1) % 5] * r1[i9 % 5]) + S::from_f64(0.125)).tanh(),
            ((r1[(i9 + 3) % 5] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    let d = match shape(
        ((y * p7.b) + S::from_f64(0.125)).tanh(),
        ((a * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ) {
        Point => (r1[1] * r1[0]),
        Disc(v) => ((p7.a - S::from_f64(0.875_f64)).tanh() - (r1[4] * a)),
        Shape::Box { w: v, h } => ((h * h + S::from_f64(0.25)).sqrt() * (h + v)),
    };
    ((S::from_f64(-0.125_f64) + S::from_f64(0.375_f64)).sin() - S::from_f64(-1.125_f64)).tanh()
        + d
        + a
        + b
        + y
        + x
}

#[differentiable]
fn program_56(x: f64, y: f64) -> f64 {
    let mut c = ((y + 0.625_f64).sin() + 0.125).tanh();
    let mut r1 = [((y - c) * 0.75).sin(); 3];
    if (r1[1] - y) >= (y * x) {
        if (r1[1] * r1[1] + 0.25).sqrt() <= (r1[1] / (1.5 + r1[2] * r1[2])) {
            c -= (((x * r1[1]) + r1[2]) * 0.75).sin();
            let (a, mut b) = (((x + x) + 0.125).tanh(), (r1[1] / (1.5 + y * y)));
        }
        let f = if let Some(v) = root((c * r1[2])) {
            ((r1[1] + y) * (y * y + 0.25).sqrt())
        } else {
            (r1[0] - -0.875_f64).tanh()
        };
    }
    let c = match shape(
        ((r1[0] + -0.875_f64).sin() + 0.125).tanh(),
        ((0.625_f64 * 0.625_f64 + 0.25).sqrt() + 0.125).tanh(),
    ) {
        Shape::Point => (0.625_f64 + y),
        Shape::Disc(v) => ((y * -0.875_f64).abs() * -0.375_f64).abs(),
        Shape::Box { w: v, h } => ((x * v) * (r1[1] * 0.125_f64).abs()),
    };
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((c - 0.125_f64).tanh() * (x + r1[2]));
        if n3 > 2 || (y - -0.375_f64) < y {
            z2 = (y * 0.875_f64).max(r1[1]);
            break;
        }
    }
    let g4 = |t: f64| ((r1[0] * r1[0] + 0.25).sqrt() / (1.5 + (c + r1[1]) * (c + r1[1]))) * t;
    let e = (g4((x * r1[2])) + g4(r1[1])).sin();
    let f = summed(
        |t: f64| ((-(z2 * c)) * t).sin(),
        ((-1.125_f64 * 0.375_f64).max(r1[1]) * 0.75).sin(),
        2,
    )
    .tanh();
    let a = match root(r1[1]) {
        Some(v) => ((e - f) - (r1[1] + r1[2])),
        None => (f * f + 0.25).sqrt(),
    };
    let a =
        root((a - 0.875_f64).tanh()).map_or(-0.625_f64, |v| ((v * r1[1]) * -1.125_f64).max(r1[1]));
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        let f = match roots((0.125_f64 * 0.125_f64 + 0.25).sqrt(), f) {
            Ok(v) => ((-0.375_f64 - z2) * (-0.375_f64 - z2) + 0.25).sqrt(),
            Err(true) => e,
            Err(_) => (x * x + 0.25).sqrt(),
        };
        let mut p7 =
            Pair { a: ((-(e)) * 0.75).sin(), b: ((0.375_f64 - -0.125_f64).tanh() + 0.125).tanh() };
    }
    ((y * 0.875_f64).cos() * -0.875_f64).cos() + a + f + e + z2 + c + y + x
}

fn program_56_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut r1 = [((y - c) * S::from_f64(0.75)).sin(); 3];
    if (r1[1] - y).cmpge((y * x)) {
        if (r1[1] * r1[1] + S::from_f64(0.25))
            .sqrt()
            .cmple((r1[1] / (S::from_f64(1.5) + r1[2] * r1[2])))
        {
            c = c - (((x * r1[1]) + r1[2]) * S::from_f64(0.75)).sin();
            let (a, mut b) =
                (((x + x) + S::from_f64(0.125)).tanh(), (r1[1] / (S::from_f64(1.5) + y * y)));
        }
        let f = if let Some(v) = root((c * r1[2])) {
            ((r1[1] + y) * (y * y + S::from_f64(0.25)).sqrt())
        } else {
            (r1[0] - S::from_f64(-0.875_f64)).tanh()
        };
    }
    let c = match shape(
        ((r1[0] + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt()
            + S::from_f64(0.125))
        .tanh(),
    ) {
        Shape::Point => (S::from_f64(0.625_f64) + y),
        Shape::Disc(v) => ((y * S::from_f64(-0.875_f64)).abs() * S::from_f64(-0.375_f64)).abs(),
        Shape::Box { w: v, h } => ((x * v) * (r1[1] * S::from_f64(0.125_f64)).abs()),
    };
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((c - S::from_f64(0.125_f64)).tanh() * (x + r1[2]));
        if n3 > 2 || (y - S::from_f64(-0.375_f64)).cmplt(y) {
            z2 = (y * S::from_f64(0.875_f64)).max(r1[1]);
            break;
        }
    }
    let g4 = |t: S| {
        ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()
            / (S::from_f64(1.5) + (c + r1[1]) * (c + r1[1])))
            * t
    };
    let e = (g4((x * r1[2])) + g4(r1[1])).sin();
    let f = summed(
        |t: S| ((-(z2 * c)) * t).sin(),
        ((S::from_f64(-1.125_f64) * S::from_f64(0.375_f64)).max(r1[1]) * S::from_f64(0.75)).sin(),
        2,
    )
    .tanh();
    let a = match root(r1[1]) {
        Some(v) => ((e - f) - (r1[1] + r1[2])),
        None => (f * f + S::from_f64(0.25)).sqrt(),
    };
    let a = root((a - S::from_f64(0.875_f64)).tanh())
        .map_or(S::from_f64(-0.625_f64), |v| ((v * r1[1]) * S::from_f64(-1.125_f64)).max(r1[1]));
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        let f = match roots(
            (S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt(),
            f,
        ) {
            Ok(v) => ((S::from_f64(-0.375_f64) - z2) * (S::from_f64(-0.375_f64) - z2)
                + S::from_f64(0.25))
            .sqrt(),
            Err(true) => e,
            Err(_) => (x * x + S::from_f64(0.25)).sqrt(),
        };
        let mut p7 = Pair {
            a: ((-(e)) * S::from_f64(0.75)).sin(),
            b: ((S::from_f64(0.375_f64) - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125))
                .tanh(),
        };
    }
    ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(-0.875_f64)).cos()
        + a
        + f
        + e
        + z2
        + c
        + y
        + x
}

#[differentiable]
fn program_57(x: f64, y: f64) -> f64 {
    let mut f = ((x + -1.125_f64) * 0.75).sin();
    let mut r1 = [((y + y) + 0.125).tanh(), ((x * 0.375_f64).cos() + 0.125).tanh()];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let k4 = (f * f + 0.25).sqrt();
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k4).sin();
            part.reverse();
        }
    }
    let mut p5 = Pair { a: ((f - -1.125_f64).tanh() + 0.125).tanh(), b: (x + 0.125).tanh() };
    if (x * x) < p5.b {
        return f;
    }
    let mut u6 = r1.to_vec();
    u6.push((y + 0.125).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let f = (mixed(&u6) + u6[0]).tanh();
    'l7: for i8 in (1..5_usize).rev() {
        let f = program_9(
            ((((i8 as f64) * 0.25) + r1[(i8 + 0) % 2]) + 0.125).tanh(),
            ((x * -0.875_f64).max(r1[(i8 * i8 + 1) % 2]) * 0.75).sin(),
        )
        .tanh();
    }
    let g9 = |t: f64| ((r1[0] * 0.625_f64).cos() * 0.375_f64).abs() * t;
    let b = (g9(-0.875_f64) + g9((y * -1.125_f64).abs())).sin();
    let mut r10 = [
        ((y + r1[0]) * 0.75).sin(),
        ((x * -0.625_f64).abs() + 0.125).tanh(),
        ((r1[1] * f) + 0.125).tanh(),
    ];
    r1[0] = (((p5.b - 0.875_f64) * p5.a) * 0.75).sin();
    'l11: for i12 in (0..3_usize).rev() {
        let k13 = (((i12 as f64) * 0.25) + ((i12 as f64) * 0.25));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k13).sin();
            part.reverse();
        }
        let z14;
        if i12 % 4 == 3 {
            z14 = ((p5.b * b) + (r10[2] + p5.a));
        } else {
            z14 = (((i12 as f64) * 0.25) * 0.375_f64).max(r10[1]);
        }
        let f = match shape(((r1[0] + r10[i12 % 3]) + 0.125).tanh(), (x * 0.75).sin()) {
            Point => (((i12 as f64) * 0.25) * 0.375_f64).max(r1[i12 % 2]),
            Disc(v) => ((-(f)) * (v - ((i12 as f64) * 0.25))),
            Shape::Box { w: v, h } => {
                ((p5.b + ((i12 as f64) * 0.25)) + (((i12 as f64) * 0.25) - f))
            }
        };
    }
    ((r1[1] / (1.5 + f * f)) - 0.125_f64).tanh() + b + f + y + x
}

fn program_57_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x + S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y + y) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let k4 = (f * f + S::from_f64(0.25)).sqrt();
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k4).sin();
            part.reverse();
        }
    }
    let mut p5 = Pair {
        a: ((f - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: (x + S::from_f64(0.125)).tanh(),
    };
    if (x * x).cmplt(p5.b) {
        return f;
    }
    let mut u6 = r1.to_vec();
    u6.push((y + S::from_f64(0.125)).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let f = (mixed(&u6) + u6[0]).tanh();
    'l7: for i8 in (1..5_usize).rev() {
        let f = program_9_of(
            (((S::from_f64(i8 as f64) * S::from_f64(0.25)) + r1[(i8 + 0) % 2])
                + S::from_f64(0.125))
            .tanh(),
            ((x * S::from_f64(-0.875_f64)).max(r1[(i8 * i8 + 1) % 2]) * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    let g9 = |t: S| ((r1[0] * S::from_f64(0.625_f64)).cos() * S::from_f64(0.375_f64)).abs() * t;
    let b = (g9(S::from_f64(-0.875_f64)) + g9((y * S::from_f64(-1.125_f64)).abs())).sin();
    let mut r10 = [
        ((y + r1[0]) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((r1[1] * f) + S::from_f64(0.125)).tanh(),
    ];
    r1[0] = (((p5.b - S::from_f64(0.875_f64)) * p5.a) * S::from_f64(0.75)).sin();
    'l11: for i12 in (0..3_usize).rev() {
        let k13 = ((S::from_f64(i12 as f64) * S::from_f64(0.25))
            + (S::from_f64(i12 as f64) * S::from_f64(0.25)));
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k13).sin();
            part.reverse();
        }
        let z14;
        if i12 % 4 == 3 {
            z14 = ((p5.b * b) + (r10[2] + p5.a));
        } else {
            z14 = ((S::from_f64(i12 as f64) * S::from_f64(0.25)) * S::from_f64(0.375_f64))
                .max(r10[1]);
        }
        let f = match shape(
            ((r1[0] + r10[i12 % 3]) + S::from_f64(0.125)).tanh(),
            (x * S::from_f64(0.75)).sin(),
        ) {
            Point => ((S::from_f64(i12 as f64) * S::from_f64(0.25)) * S::from_f64(0.375_f64))
                .max(r1[i12 % 2]),
            Disc(v) => ((-(f)) * (v - (S::from_f64(i12 as f64) * S::from_f64(0.25)))),
            Shape::Box { w: v, h } => {
                ((p5.b + (S::from_f64(i12 as f64) * S::from_f64(0.25)))
                    + ((S::from_f64(i12 as f64) * S::from_f64(0.25)) - f))
            }
        };
    }
    ((r1[1] / (S::from_f64(1.5) + f * f)) - S::from_f64(0.125_f64)).tanh() + b + f + y + x
}

#[differentiable]
fn program_58(x: f64, y: f64) -> f64 {
    let mut b = ((-0.125_f64 + -0.125_f64).sin() * 0.75).sin();
    let mut r1 =
        [((y * y + 0.25).sqrt() * 0.75).sin(), ((-(x)) * 0.75).sin(), ((x * x) * 0.75).sin()];
    let mut p2 = Pair { a: ((-(x)) * 0.75).sin(), b: ((r1[1] - -0.375_f64).tanh() * 0.75).sin() };
    b += (((r1[2] + y) * -0.875_f64).max(0.375_f64) * 0.75).sin();
    let d = match root((r1[2] * 0.875_f64)) {
        Some(v) => ((-(b)) * (y * x)),
        None => (b - r1[2]),
    };
    let a = match roots((r1[0] - x), (p2.a - r1[0])) {
        Ok(v) => r1[0],
        Err(true) => b,
        Err(_) => (-1.125_f64 + 0.125_f64).sin(),
    };
    if (d - a) >= a {
        r1[2] += (((-0.375_f64 * r1[1]) * d) * 0.75).sin();
        let mut p3 = Pair { a: ((y * x) + 0.125).tanh(), b: ((a * -0.625_f64).cos() * 0.75).sin() };
        #[differentiable(checkpoint)]
        'l4: for i5 in 1..=2_usize {
            p2 = (p2 + p2) * ((x - a) * 0.75).sin();
            p2 = p2.tamed();
            let by6 = ((a - -0.375_f64).tanh() + 0.125).tanh();
            let f = shifted(&mut r1[0..], by6);
            if (d + -0.375_f64).sin() >= ((i5 as f64) * 0.25) {
                let mut r7 = [((b * y) * 0.75).sin(); 3];
                p3 += p3;
                p3 = p3.tamed();
                p3 =
                    (p3 + Pair {
                        a: ((r1[(i5 * i5 + 1) % 3] + -0.625_f64).sin() * 0.75).sin(),
                        b: ((-(b)) * 0.75).sin(),
                    }) * ((p2.a + r1[1]) + 0.125).tanh();
                p3 = p3.tamed();
            }
        }
    } else {
        p2.b = ((y * y + 0.25).sqrt() * 0.75).sin();
        p2 = p2.tamed();
        let mut p8 = Pair { a: ((r1[2] + r1[0]) + 0.125).tanh(), b: (r1[1] * 0.75).sin() };
    }
    -0.375_f64 + a + d + b + y + x
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
    b = b
        + (((r1[2] + y) * S::from_f64(-0.875_f64)).max(S::from_f64(0.375_f64)) * S::from_f64(0.75))
            .sin();
    let d = match root((r1[2] * S::from_f64(0.875_f64))) {
        Some(v) => ((-(b)) * (y * x)),
        None => (b - r1[2]),
    };
    let a = match roots((r1[0] - x), (p2.a - r1[0])) {
        Ok(v) => r1[0],
        Err(true) => b,
        Err(_) => (S::from_f64(-1.125_f64) + S::from_f64(0.125_f64)).sin(),
    };
    if (d - a).cmpge(a) {
        r1[2] = r1[2] + (((S::from_f64(-0.375_f64) * r1[1]) * d) * S::from_f64(0.75)).sin();
        let mut p3 = Pair {
            a: ((y * x) + S::from_f64(0.125)).tanh(),
            b: ((a * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        };

        'l4: for i5 in 1..=2_usize {
            p2 = (p2 + p2) * ((x - a) * S::from_f64(0.75)).sin();
            p2 = p2.tamed();
            let by6 = ((a - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh();
            let f = shifted(&mut r1[0..], by6);
            if (d + S::from_f64(-0.375_f64))
                .sin()
                .cmpge((S::from_f64(i5 as f64) * S::from_f64(0.25)))
            {
                let mut r7 = [((b * y) * S::from_f64(0.75)).sin(); 3];
                p3 += p3;
                p3 = p3.tamed();
                p3 =
                    (p3 + Pair {
                        a: ((r1[(i5 * i5 + 1) % 3] + S::from_f64(-0.625_f64)).sin()
                            * S::from_f64(0.75))
                        .sin(),
                        b: ((-(b)) * S::from_f64(0.75)).sin(),
                    }) * ((p2.a + r1[1]) + S::from_f64(0.125)).tanh();
                p3 = p3.tamed();
            }
        }
    } else {
        p2.b = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
        p2 = p2.tamed();
        let mut p8 = Pair {
            a: ((r1[2] + r1[0]) + S::from_f64(0.125)).tanh(),
            b: (r1[1] * S::from_f64(0.75)).sin(),
        };
    }
    S::from_f64(-0.375_f64) + a + d + b + y + x
}

#[differentiable]
fn program_59(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((-1.125_f64 * -1.125_f64 + 0.25).sqrt() + 0.125).tanh(); 5];
    let mut c = (r1[4] * 0.75).sin();
    r1[4] = (((r1[1] * r1[1] + 0.25).sqrt() * (r1[2] - 0.625_f64).tanh()) * 0.75).sin();
    let mut p2 = Pair { a: ((r1[0] - -0.875_f64).tanh() * 0.75).sin(), b: ((x + y) * 0.75).sin() };
    'l3: for i4 in (1..4_usize).step_by(2) {
        let z5;
        if (p2.a * y) < (((i4 as f64) * 0.25) + y) {
            let t = r1[4];
            z5 = ((r1[(i4 * i4 + 1) % 5] * -0.625_f64).abs() * (t - c));
        } else if y < (f * -0.375_f64).abs() {
            z5 = bent((-0.875_f64 * -0.875_f64 + 0.25).sqrt());
        } else {
            z5 = r1[4];
        }
    }
    let e = if (x * 0.125_f64).abs() >= (y * y + 0.25).sqrt() {
        p2.b
    } else {
        ((x * x + 0.25).sqrt() * (-0.625_f64 + -0.875_f64).sin())
    };
    let c = ((e * 0.125_f64).abs() * -0.875_f64).max(y);
    r1[4] *= (((-(y)) + (y * 0.375_f64).abs()) + 0.125).tanh();
    let c = mixed(&r1[..1]).sin();
    let e = (e * 0.625_f64).cos();
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let (a, mut b) = (((r1[4] - p2.b) * 0.75).sin(), (-(c)));
    r1[2] +=
        (((f * -1.125_f64).abs() / (1.5 + (b / (1.5 + y * y)) * (b / (1.5 + y * y)))) * 0.75).sin();
    let a = p2
        .dot(&Pair {
            a: ((a * -0.375_f64).max(-0.375_f64) + 0.125).tanh(),
            b: ((a * a + 0.25).sqrt() + 0.125).tanh(),
        })
        .sin();
    ((c + r1[4]) * -0.125_f64).cos() + a + b + e + c + f + y + x
}

fn program_59_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.125))
    .tanh(); 5];
    let mut c = (r1[4] * S::from_f64(0.75)).sin();
    r1[4] = (((r1[1] * r1[1] + S::from_f64(0.25)).sqrt()
        * (r1[2] - S::from_f64(0.625_f64)).tanh())
        * S::from_f64(0.75))
    .sin();
    let mut p2 = Pair {
        a: ((r1[0] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: ((x + y) * S::from_f64(0.75)).sin(),
    };
    'l3: for i4 in (1..4_usize).step_by(2) {
        let z5;
        if (p2.a * y).cmplt(((S::from_f64(i4 as f64) * S::from_f64(0.25)) + y)) {
            let t = r1[4];
            z5 = ((r1[(i4 * i4 + 1) % 5] * S::from_f64(-0.625_f64)).abs() * (t - c));
        } else if y.cmplt((f * S::from_f64(-0.375_f64)).abs()) {
            z5 = bent(
                (S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt(),
            );
        } else {
            z5 = r1[4];
        }
    }
    let e = if (x * S::from_f64(0.125_f64)).abs().cmpge((y * y + S::from_f64(0.25)).sqrt()) {
        p2.b
    } else {
        ((x * x + S::from_f64(0.25)).sqrt()
            * (S::from_f64(-0.625_f64) + S::from_f64(-0.875_f64)).sin())
    };
    let c = ((e * S::from_f64(0.125_f64)).abs() * S::from_f64(-0.875_f64)).max(y);
    r1[4] = r1[4] * (((-(y)) + (y * S::from_f64(0.375_f64)).abs()) + S::from_f64(0.125)).tanh();
    let c = mixed(&r1[..1]).sin();
    let e = (e * S::from_f64(0.625_f64)).cos();
    p2 = (p2 * p2 + p2).tamed();
    p2 = p2.tamed();
    let (a, mut b) = (((r1[4] - p2.b) * S::from_f64(0.75)).sin(), (-(c)));
    r1[2] = r1[2]
        + (((f * S::from_f64(-1.125_f64)).abs()
            / (S::from_f64(1.5)
                + (b / (S::from_f64(1.5) + y * y)) * (b / (S::from_f64(1.5) + y * y))))
            * S::from_f64(0.75))
        .sin();
    let a = p2
        .dot(&Pair {
            a: ((a * S::from_f64(-0.375_f64)).max(S::from_f64(-0.375_f64)) + S::from_f64(0.125))
                .tanh(),
            b: ((a * a + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        })
        .sin();
    ((c + r1[4]) * S::from_f64(-0.125_f64)).cos() + a + b + e + c + f + y + x
}
