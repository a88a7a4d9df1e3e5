//! Random programs, written by `cargo run -p ad --example random_programs -- 1 80`.

use ad::{Real, differentiable};

use crate::program::{Program, program};

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
    program!(program_60, program_60_of),
    program!(program_61, program_61_of),
    program!(program_62, program_62_of),
    program!(program_63, program_63_of),
    program!(program_64, program_64_of),
    program!(program_65, program_65_of),
    program!(program_66, program_66_of),
    program!(program_67, program_67_of),
    program!(program_68, program_68_of),
    program!(program_69, program_69_of),
    program!(program_70, program_70_of),
    program!(program_71, program_71_of),
    program!(program_72, program_72_of),
    program!(program_73, program_73_of),
    program!(program_74, program_74_of),
    program!(program_75, program_75_of),
    program!(program_76, program_76_of),
    program!(program_77, program_77_of),
    program!(program_78, program_78_of),
    program!(program_79, program_79_of),
];

#[differentiable]
fn program_0(x: f64, y: f64) -> f64 {
    let mut f = ((x * x + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [((f + f) + 0.125).tanh(); 3];
    let e: f64 = r1.iter().map(|v| v * ((r1[1] / (1.5 + y * y)) * 0.75).sin()).sum();
    f += (((-(0.375_f64)) - (x * y)) + 0.125).tanh();
    r1[0] *= (((e / (1.5 + x * x)) + 0.375_f64).sin() + 0.125).tanh();
    f -= (e + 0.125).tanh();
    r1[0] += (((e + y) * (y * f)) + 0.125).tanh();
    f *= (r1[2] * 0.75).sin();
    f *= (((e * 0.875_f64).abs() * (e * 0.875_f64).abs() + 0.25).sqrt() * 0.75).sin();
    f = (((f * 0.875_f64) * (e * 0.875_f64).abs()) * 0.75).sin();
    'l2: for i3 in (0..5_usize).step_by(2) {
        r1[i3 % 3] -= (f + 0.125).tanh();
    }
    let g4 = |t: f64| x * t;
    let c = (g4((r1[1] * r1[1])) + g4((x * -0.875_f64).max(e))).sin();
    let e = ((0.625_f64 * 0.625_f64).max(r1[0]) * -1.125_f64).abs();
    let c = if (0.625_f64 * -0.875_f64).cos() <= (r1[0] * 0.875_f64).abs() {
        f
    } else {
        (-(r1[1] - x))
    };
    if (r1[1] * r1[1] + 0.25).sqrt() < (r1[0] - -0.625_f64).tanh() {
        return ((-0.125_f64 * 0.375_f64).cos() - -1.125_f64).tanh();
    }
    (-((r1[0] * 0.375_f64).abs())) + c + e + f + y + x
}

fn program_0_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [((f + f) + S::from_f64(0.125)).tanh(); 3];
    let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[1] / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin()
    });
    f = f + (((-(S::from_f64(0.375_f64))) - (x * y)) + S::from_f64(0.125)).tanh();
    r1[0] = r1[0]
        * (((e / (S::from_f64(1.5) + x * x)) + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125))
            .tanh();
    f = f - (e + S::from_f64(0.125)).tanh();
    r1[0] = r1[0] + (((e + y) * (y * f)) + S::from_f64(0.125)).tanh();
    f = f * (r1[2] * S::from_f64(0.75)).sin();
    f = f
        * (((e * S::from_f64(0.875_f64)).abs() * (e * S::from_f64(0.875_f64)).abs()
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    f = (((f * S::from_f64(0.875_f64)) * (e * S::from_f64(0.875_f64)).abs()) * S::from_f64(0.75))
        .sin();
    'l2: for i3 in (0..5_usize).step_by(2) {
        r1[i3 % 3] = r1[i3 % 3] - (f + S::from_f64(0.125)).tanh();
    }
    let g4 = |t: S| x * t;
    let c = (g4((r1[1] * r1[1])) + g4((x * S::from_f64(-0.875_f64)).max(e))).sin();
    let e = ((S::from_f64(0.625_f64) * S::from_f64(0.625_f64)).max(r1[0])
        * S::from_f64(-1.125_f64))
    .abs();
    let c = if (S::from_f64(0.625_f64) * S::from_f64(-0.875_f64))
        .cos()
        .cmple((r1[0] * S::from_f64(0.875_f64)).abs())
    {
        f
    } else {
        (-(r1[1] - x))
    };
    if (r1[1] * r1[1] + S::from_f64(0.25)).sqrt().cmplt((r1[0] - S::from_f64(-0.625_f64)).tanh()) {
        return ((S::from_f64(-0.125_f64) * S::from_f64(0.375_f64)).cos()
            - S::from_f64(-1.125_f64))
        .tanh();
    }
    (-((r1[0] * S::from_f64(0.375_f64)).abs())) + c + e + f + y + x
}

#[differentiable]
fn program_1(x: f64, y: f64) -> f64 {
    let mut a = ((x * y) + 0.125).tanh();
    let r1 = [((a * y) * 0.75).sin(), ((x / (1.5 + x * x)) * 0.75).sin()];
    let mut b = ((r1[1] * y) + 0.125).tanh();
    if (0.125_f64 * 0.375_f64) >= (y * y + 0.25).sqrt() {
        if (x * r1[0]) > (y * r1[0]) {
            return ((0.125_f64 + y) - (b + y));
        }
        let mut f = ((x * x + 0.25).sqrt() + 0.125).tanh();
    } else {
        let g2 = |t: f64| (t * (r1[1] - 0.375_f64).tanh()) * t;
        let d = (g2(a) + g2(y)).sin();
        let c = ((r1[0] * r1[1]) * 0.875_f64).abs();
    }
    'l3: for i4 in (1..5_usize).step_by(2) {
        let e = program_0(
            ((a - -0.125_f64).tanh() * 0.75).sin(),
            ((((i4 as f64) * 0.25) / (1.5 + x * x)) * 0.75).sin(),
        )
        .tanh();
        if i4 % 2 == 1 {
            'l5: for i6 in (1..5_usize).rev() {
                let a = ((e + 0.625_f64) - -0.375_f64).tanh();
                let c = program_0(
                    ((-1.125_f64 - -1.125_f64).tanh() + 0.125).tanh(),
                    ((b * b) * 0.75).sin(),
                )
                .tanh();
            }
            a = (((-(x)) * 0.875_f64).abs() + 0.125).tanh();
            a = (((e * 0.625_f64).cos() + -0.875_f64).sin() + 0.125).tanh();
        } else {
            a += (((((i4 as f64) * 0.25) / (1.5 + y * y)) * -0.625_f64).cos() + 0.125).tanh();
        }
    }
    (x - -1.125_f64).tanh() + b + a + y + x
}

fn program_1_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * y) + S::from_f64(0.125)).tanh();
    let r1 = [
        ((a * y) * S::from_f64(0.75)).sin(),
        ((x / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ];
    let mut b = ((r1[1] * y) + S::from_f64(0.125)).tanh();
    if (S::from_f64(0.125_f64) * S::from_f64(0.375_f64)).cmpge((y * y + S::from_f64(0.25)).sqrt()) {
        if (x * r1[0]).cmpgt((y * r1[0])) {
            return ((S::from_f64(0.125_f64) + y) - (b + y));
        }
        let mut f = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    } else {
        let g2 = |t: S| (t * (r1[1] - S::from_f64(0.375_f64)).tanh()) * t;
        let d = (g2(a) + g2(y)).sin();
        let c = ((r1[0] * r1[1]) * S::from_f64(0.875_f64)).abs();
    }
    'l3: for i4 in (1..5_usize).step_by(2) {
        let e = program_0_of(
            ((a - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
            (((S::from_f64(i4 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + x * x))
                * S::from_f64(0.75))
            .sin(),
        )
        .tanh();
        if i4 % 2 == 1 {
            'l5: for i6 in (1..5_usize).rev() {
                let a = ((e + S::from_f64(0.625_f64)) - S::from_f64(-0.375_f64)).tanh();
                let c = program_0_of(
                    ((S::from_f64(-1.125_f64) - S::from_f64(-1.125_f64)).tanh()
                        + S::from_f64(0.125))
                    .tanh(),
                    ((b * b) * S::from_f64(0.75)).sin(),
                )
                .tanh();
            }
            a = (((-(x)) * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh();
            a = (((e * S::from_f64(0.625_f64)).cos() + S::from_f64(-0.875_f64)).sin()
                + S::from_f64(0.125))
            .tanh();
        } else {
            a = a
                + ((((S::from_f64(i4 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + y * y))
                    * S::from_f64(-0.625_f64))
                .cos()
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    (x - S::from_f64(-1.125_f64)).tanh() + b + a + y + x
}

#[differentiable]
fn program_2(x: f64, y: f64) -> f64 {
    let mut e = (y * 0.75).sin();
    let mut r1 = [((x - 0.125_f64).tanh() + 0.125).tanh(); 4];
    let a = ((x + 0.875_f64) * x);
    let d = program_0(((x * -0.875_f64).max(e) + 0.125).tanh(), ((-(a)) * 0.75).sin()).tanh();
    if (d + -0.625_f64).sin() < (e * e + 0.25).sqrt() {
        if (a - r1[3]) < (e - -0.125_f64).tanh() {
            return ((-(a)) - d);
        }
        'l2: for i3 in (1..5_usize).step_by(2) {
            'l4: for i5 in 1..5_usize {
                e += ((-(e)) * 0.75).sin();
                e *= (r1[1] * 0.75).sin();
            }
            e = (((r1[1] * -0.125_f64).cos() * (r1[1] * -0.125_f64).cos() + 0.25).sqrt() * 0.75)
                .sin();
            let g6 = |t: f64| ((r1[0] * r1[(i3 * i3 + 1) % 4]) * -0.875_f64).abs() * t;
            let a = (g6((y * 0.125_f64).max(e)) + g6((e * -1.125_f64).max(r1[(i3 + 3) % 4]))).sin();
        }
        e = ((-((y + 0.625_f64).sin())) + 0.125).tanh();
    }
    let mut n8 = 0_usize;
    'l7: while n8 < 2 {
        n8 += 1;
        'l9: for i10 in (n8..4_usize).rev() {
            e *= (((n8 as f64) * 0.25) * 0.75).sin();
            let mut a =
                ((r1[(i10 * i10 + 1) % 4] * r1[(i10 * i10 + 1) % 4] + 0.25).sqrt() * 0.75).sin();
        }
    }
    ((a + r1[1]) + (a * -1.125_f64).cos()) + d + a + e + y + x
}

fn program_2_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (y * S::from_f64(0.75)).sin();
    let mut r1 = [((x - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh(); 4];
    let a = ((x + S::from_f64(0.875_f64)) * x);
    let d = program_0_of(
        ((x * S::from_f64(-0.875_f64)).max(e) + S::from_f64(0.125)).tanh(),
        ((-(a)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    if (d + S::from_f64(-0.625_f64)).sin().cmplt((e * e + S::from_f64(0.25)).sqrt()) {
        if (a - r1[3]).cmplt((e - S::from_f64(-0.125_f64)).tanh()) {
            return ((-(a)) - d);
        }
        'l2: for i3 in (1..5_usize).step_by(2) {
            'l4: for i5 in 1..5_usize {
                e = e + ((-(e)) * S::from_f64(0.75)).sin();
                e = e * (r1[1] * S::from_f64(0.75)).sin();
            }
            e = (((r1[1] * S::from_f64(-0.125_f64)).cos()
                * (r1[1] * S::from_f64(-0.125_f64)).cos()
                + S::from_f64(0.25))
            .sqrt()
                * S::from_f64(0.75))
            .sin();
            let g6 = |t: S| ((r1[0] * r1[(i3 * i3 + 1) % 4]) * S::from_f64(-0.875_f64)).abs() * t;
            let a = (g6((y * S::from_f64(0.125_f64)).max(e))
                + g6((e * S::from_f64(-1.125_f64)).max(r1[(i3 + 3) % 4])))
            .sin();
        }
        e = ((-((y + S::from_f64(0.625_f64)).sin())) + S::from_f64(0.125)).tanh();
    }
    let mut n8 = 0_usize;
    'l7: while n8 < 2 {
        n8 += 1;
        'l9: for i10 in (n8..4_usize).rev() {
            e = e * ((S::from_f64(n8 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin();
            let mut a = ((r1[(i10 * i10 + 1) % 4] * r1[(i10 * i10 + 1) % 4] + S::from_f64(0.25))
                .sqrt()
                * S::from_f64(0.75))
            .sin();
        }
    }
    ((a + r1[1]) + (a * S::from_f64(-1.125_f64)).cos()) + d + a + e + y + x
}

#[differentiable]
fn program_3(x: f64, y: f64) -> f64 {
    let mut a = (y * 0.75).sin();
    let mut r1 = [(y * 0.75).sin(); 2];
    let mut r2 = [((x + x) + 0.125).tanh(); 2];
    a += (((r2[0] + x) - (r1[1] * r2[1])) + 0.125).tanh();
    for v in r2.iter() {
        a = a * (r2[1] * 0.75).sin() + *v * (r2[1] * 0.75).sin();
    }
    a = (((y - -0.125_f64).tanh() * (a * x)) * 0.75).sin();
    a = (((y * -0.125_f64).abs() * (r1[1] * r1[1] + 0.25).sqrt()) + 0.125).tanh();
    for v in r1.iter() {
        a = a * (x * 0.75).sin() + *v * (x * 0.75).sin();
    }
    'l3: for i4 in (0..0_usize).step_by(2) {
        if (a - 0.875_f64).tanh() < (x + 0.375_f64).sin() {
            break 'l3;
        }
        let b = ((r1[(i4 + 0) % 2] + a) * -0.375_f64).max(r1[0]);
    }
    let mut b = ((r2[0] + y) * 0.75).sin();
    let r5 = [(r1[1] + 0.125).tanh(); 2];
    let mut n7 = 0_usize;
    'l6: while n7 < 4 {
        n7 += 1;
        b = ((-((r1[(n7 + 1) % 2] * r1[(n7 + 1) % 2] + 0.25).sqrt())) * 0.75).sin();
        let mut e = ((y + y) + 0.125).tanh();
        r1[(n7 * n7 + 1) % 2] = (((-(r5[0])) * (-(r5[0])) + 0.25).sqrt() + 0.125).tanh();
    }
    ((-1.125_f64 + b) + (x * r2[0])) + b + a + y + x
}

fn program_3_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = (y * S::from_f64(0.75)).sin();
    let mut r1 = [(y * S::from_f64(0.75)).sin(); 2];
    let mut r2 = [((x + x) + S::from_f64(0.125)).tanh(); 2];
    a = a + (((r2[0] + x) - (r1[1] * r2[1])) + S::from_f64(0.125)).tanh();
    for v in r2.iter() {
        a = a * (r2[1] * S::from_f64(0.75)).sin() + *v * (r2[1] * S::from_f64(0.75)).sin();
    }
    a = (((y - S::from_f64(-0.125_f64)).tanh() * (a * x)) * S::from_f64(0.75)).sin();
    a = (((y * S::from_f64(-0.125_f64)).abs() * (r1[1] * r1[1] + S::from_f64(0.25)).sqrt())
        + S::from_f64(0.125))
    .tanh();
    for v in r1.iter() {
        a = a * (x * S::from_f64(0.75)).sin() + *v * (x * S::from_f64(0.75)).sin();
    }
    'l3: for i4 in (0..0_usize).step_by(2) {
        if (a - S::from_f64(0.875_f64)).tanh().cmplt((x + S::from_f64(0.375_f64)).sin()) {
            break 'l3;
        }
        let b = ((r1[(i4 + 0) % 2] + a) * S::from_f64(-0.375_f64)).max(r1[0]);
    }
    let mut b = ((r2[0] + y) * S::from_f64(0.75)).sin();
    let r5 = [(r1[1] + S::from_f64(0.125)).tanh(); 2];
    let mut n7 = 0_usize;
    'l6: while n7 < 4 {
        n7 += 1;
        b = ((-((r1[(n7 + 1) % 2] * r1[(n7 + 1) % 2] + S::from_f64(0.25)).sqrt()))
            * S::from_f64(0.75))
        .sin();
        let mut e = ((y + y) + S::from_f64(0.125)).tanh();
        r1[(n7 * n7 + 1) % 2] =
            (((-(r5[0])) * (-(r5[0])) + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    }
    ((S::from_f64(-1.125_f64) + b) + (x * r2[0])) + b + a + y + x
}

#[differentiable]
fn program_4(x: f64, y: f64) -> f64 {
    let mut e = ((x * -0.375_f64).max(y) * 0.75).sin();
    let r1 = [
        ((e + -0.625_f64).sin() * 0.75).sin(),
        ((y + x) + 0.125).tanh(),
        (0.625_f64 * 0.75).sin(),
        ((-0.375_f64 * 0.625_f64).cos() * 0.75).sin(),
        ((e * y) * 0.75).sin(),
    ];
    if y >= x {
        e += (((r1[4] * r1[0]) + (-(y))) * 0.75).sin();
    }
    let b = 0.625_f64;
    if (x + b) < (y * -0.375_f64).abs() {
        e *= ((x - (y + e)) + 0.125).tanh();
        'l2: for i3 in (1..2_usize).step_by(2) {
            e -= ((b + (r1[4] * r1[4] + 0.25).sqrt()) * 0.75).sin();
            if (e * x) < (b * 0.625_f64).max(e) {
                let r4 = [(r1[i3 % 5] * 0.75).sin(); 2];
                e -= (y + 0.125).tanh();
            }
            e = (((x / (1.5 + b * b)) * (r1[(i3 * i3 + 1) % 5] * e)) + 0.125).tanh();
        }
    }
    let b = if (x * 0.875_f64).cos() > (x * 0.625_f64) {
        (y + (x / (1.5 + r1[1] * r1[1])))
    } else {
        (-(-(y)))
    };
    for v in r1.iter() {
        e = e * (r1[4] * 0.75).sin() + *v * (r1[4] * 0.75).sin();
    }
    let c = if (y / (1.5 + y * y)) <= (-0.875_f64 * -0.625_f64).cos() {
        ((y * 0.625_f64).cos() * 0.875_f64).abs()
    } else {
        ((r1[1] * -1.125_f64).max(r1[4]) * -0.625_f64).abs()
    };
    ((x - 0.375_f64).tanh() * -0.375_f64).cos() + c + b + e + y + x
}

fn program_4_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(-0.375_f64)).max(y) * S::from_f64(0.75)).sin();
    let r1 = [
        ((e + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y + x) + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        ((e * y) * S::from_f64(0.75)).sin(),
    ];
    if y.cmpge(x) {
        e = e + (((r1[4] * r1[0]) + (-(y))) * S::from_f64(0.75)).sin();
    }
    let b = S::from_f64(0.625_f64);
    if (x + b).cmplt((y * S::from_f64(-0.375_f64)).abs()) {
        e = e * ((x - (y + e)) + S::from_f64(0.125)).tanh();
        'l2: for i3 in (1..2_usize).step_by(2) {
            e = e - ((b + (r1[4] * r1[4] + S::from_f64(0.25)).sqrt()) * S::from_f64(0.75)).sin();
            if (e * x).cmplt((b * S::from_f64(0.625_f64)).max(e)) {
                let r4 = [(r1[i3 % 5] * S::from_f64(0.75)).sin(); 2];
                e = e - (y + S::from_f64(0.125)).tanh();
            }
            e = (((x / (S::from_f64(1.5) + b * b)) * (r1[(i3 * i3 + 1) % 5] * e))
                + S::from_f64(0.125))
            .tanh();
        }
    }
    let b = if (x * S::from_f64(0.875_f64)).cos().cmpgt((x * S::from_f64(0.625_f64))) {
        (y + (x / (S::from_f64(1.5) + r1[1] * r1[1])))
    } else {
        (-(-(y)))
    };
    for v in r1.iter() {
        e = e * (r1[4] * S::from_f64(0.75)).sin() + *v * (r1[4] * S::from_f64(0.75)).sin();
    }
    let c = if (y / (S::from_f64(1.5) + y * y))
        .cmple((S::from_f64(-0.875_f64) * S::from_f64(-0.625_f64)).cos())
    {
        ((y * S::from_f64(0.625_f64)).cos() * S::from_f64(0.875_f64)).abs()
    } else {
        ((r1[1] * S::from_f64(-1.125_f64)).max(r1[4]) * S::from_f64(-0.625_f64)).abs()
    };
    ((x - S::from_f64(0.375_f64)).tanh() * S::from_f64(-0.375_f64)).cos() + c + b + e + y + x
}

#[differentiable]
fn program_5(x: f64, y: f64) -> f64 {
    let mut a = ((0.625_f64 * x) + 0.125).tanh();
    let mut r1 = [((y * -1.125_f64).abs() * 0.75).sin(); 3];
    let g2 = |t: f64| ((a * a + 0.25).sqrt() - 0.875_f64).tanh() * t;
    let e = (g2(a) + g2((-0.875_f64 + -0.875_f64).sin())).sin();
    if (-(r1[2])) <= (a - a) {
        a -= (((r1[1] - 0.625_f64).tanh() - 0.625_f64).tanh() * 0.75).sin();
    }
    'l3: for i4 in (2..3_usize).rev() {
        let g5 = |t: f64| ((-(y)) * ((i4 as f64) * 0.25)) * t;
        let a = (g5((x / (1.5 + a * a))) + g5(r1[(i4 + 1) % 3])).sin();
        let mut f = ((((i4 as f64) * 0.25) + -0.875_f64).sin() * 0.75).sin();
        let d = program_3(((-(f)) * 0.75).sin(), (a + 0.125).tanh()).tanh();
    }
    if (a - -1.125_f64).tanh() >= a {
        let mut n7 = 0_usize;
        'l6: while n7 < 1 {
            n7 += 1;
            let e: f64 = r1.iter().map(|v| v * (y + 0.125).tanh()).sum();
            let g8 = |t: f64| (-(e - r1[2])) * t;
            let a = (g8(a) + g8((y * -0.125_f64).abs())).sin();
        }
    }
    r1[0] *= (((a * 0.625_f64).abs() + y) * 0.75).sin();
    let r9 = [((x * 0.125_f64).abs() * 0.75).sin(); 4];
    a = (((-0.125_f64 * -0.125_f64 + 0.25).sqrt() * -0.625_f64).abs() + 0.125).tanh();
    (r1[2] + (r9[3] * 0.375_f64).cos()) + e + a + y + x
}

fn program_5_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(0.625_f64) * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(); 3];
    let g2 = |t: S| ((a * a + S::from_f64(0.25)).sqrt() - S::from_f64(0.875_f64)).tanh() * t;
    let e = (g2(a) + g2((S::from_f64(-0.875_f64) + S::from_f64(-0.875_f64)).sin())).sin();
    if (-(r1[2])).cmple((a - a)) {
        a = a
            - (((r1[1] - S::from_f64(0.625_f64)).tanh() - S::from_f64(0.625_f64)).tanh()
                * S::from_f64(0.75))
            .sin();
    }
    'l3: for i4 in (2..3_usize).rev() {
        let g5 = |t: S| ((-(y)) * (S::from_f64(i4 as f64) * S::from_f64(0.25))) * t;
        let a = (g5((x / (S::from_f64(1.5) + a * a))) + g5(r1[(i4 + 1) % 3])).sin();
        let mut f = (((S::from_f64(i4 as f64) * S::from_f64(0.25)) + S::from_f64(-0.875_f64))
            .sin()
            * S::from_f64(0.75))
        .sin();
        let d = program_3_of(((-(f)) * S::from_f64(0.75)).sin(), (a + S::from_f64(0.125)).tanh())
            .tanh();
    }
    if (a - S::from_f64(-1.125_f64)).tanh().cmpge(a) {
        let mut n7 = 0_usize;
        'l6: while n7 < 1 {
            n7 += 1;
            let e =
                r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * (y + S::from_f64(0.125)).tanh());
            let g8 = |t: S| (-(e - r1[2])) * t;
            let a = (g8(a) + g8((y * S::from_f64(-0.125_f64)).abs())).sin();
        }
    }
    r1[0] = r1[0] * (((a * S::from_f64(0.625_f64)).abs() + y) * S::from_f64(0.75)).sin();
    let r9 = [((x * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(); 4];
    a = (((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()
        * S::from_f64(-0.625_f64))
    .abs()
        + S::from_f64(0.125))
    .tanh();
    (r1[2] + (r9[3] * S::from_f64(0.375_f64)).cos()) + e + a + y + x
}

#[differentiable]
fn program_6(x: f64, y: f64) -> f64 {
    let mut b = ((y * y + 0.25).sqrt() * 0.75).sin();
    let r1 = [((x * -0.375_f64).max(x) * 0.75).sin(); 5];
    b = (-0.375_f64 * 0.75).sin();
    let mut f = ((y / (1.5 + x * x)) + 0.125).tanh();
    if (b * -0.125_f64).cos() > (y * -0.375_f64).abs() {
        return ((-(f)) - 0.875_f64).tanh();
    }
    if (r1[1] * r1[2]) <= (0.125_f64 - 0.375_f64) {
        b = (((-(r1[1])) + (f * r1[4])) * 0.75).sin();
        let g2 = |t: f64| ((0.375_f64 * 0.625_f64).cos() * (t * f)) * t;
        let c = (g2((r1[0] * -1.125_f64).abs()) + g2((y - r1[2]))).sin();
    }
    b -= ((r1[3] - (y - -0.375_f64).tanh()) * 0.75).sin();
    let d = (r1[1] * (0.875_f64 * 0.375_f64).abs());
    'l3: for i4 in (1..5_usize).step_by(2) {
        let mut r5 = [((((i4 as f64) * 0.25) + r1[i4 % 5]) * 0.75).sin(); 4];
    }
    let (a, mut b) = (((b * x) * 0.75).sin(), (y * y + 0.25).sqrt());
    if r1[3] > (a * r1[4]) {
        return b;
    }
    f *= (((f * 0.125_f64).abs() / (1.5 + (r1[2] * r1[1]) * (r1[2] * r1[1]))) * 0.75).sin();
    b = (y * 0.75).sin();
    ((f * f + 0.25).sqrt() - -0.125_f64).tanh() + b + a + d + f + y + x
}

fn program_6_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let r1 = [((x * S::from_f64(-0.375_f64)).max(x) * S::from_f64(0.75)).sin(); 5];
    b = (S::from_f64(-0.375_f64) * S::from_f64(0.75)).sin();
    let mut f = ((y / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh();
    if (b * S::from_f64(-0.125_f64)).cos().cmpgt((y * S::from_f64(-0.375_f64)).abs()) {
        return ((-(f)) - S::from_f64(0.875_f64)).tanh();
    }
    if (r1[1] * r1[2]).cmple((S::from_f64(0.125_f64) - S::from_f64(0.375_f64))) {
        b = (((-(r1[1])) + (f * r1[4])) * S::from_f64(0.75)).sin();
        let g2 = |t: S| ((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).cos() * (t * f)) * t;
        let c = (g2((r1[0] * S::from_f64(-1.125_f64)).abs()) + g2((y - r1[2]))).sin();
    }
    b = b - ((r1[3] - (y - S::from_f64(-0.375_f64)).tanh()) * S::from_f64(0.75)).sin();
    let d = (r1[1] * (S::from_f64(0.875_f64) * S::from_f64(0.375_f64)).abs());
    'l3: for i4 in (1..5_usize).step_by(2) {
        let mut r5 = [(((S::from_f64(i4 as f64) * S::from_f64(0.25)) + r1[i4 % 5])
            * S::from_f64(0.75))
        .sin(); 4];
    }
    let (a, mut b) = (((b * x) * S::from_f64(0.75)).sin(), (y * y + S::from_f64(0.25)).sqrt());
    if r1[3].cmpgt((a * r1[4])) {
        return b;
    }
    f = f
        * (((f * S::from_f64(0.125_f64)).abs()
            / (S::from_f64(1.5) + (r1[2] * r1[1]) * (r1[2] * r1[1])))
            * S::from_f64(0.75))
        .sin();
    b = (y * S::from_f64(0.75)).sin();
    ((f * f + S::from_f64(0.25)).sqrt() - S::from_f64(-0.125_f64)).tanh() + b + a + d + f + y + x
}

#[differentiable]
fn program_7(x: f64, y: f64) -> f64 {
    let mut f = ((y * x) * 0.75).sin();
    let mut r1 = [
        ((f * -0.125_f64).max(f) + 0.125).tanh(),
        (x * 0.75).sin(),
        ((f * f) + 0.125).tanh(),
        ((x * 0.875_f64).cos() * 0.75).sin(),
    ];
    if x <= (-0.875_f64 * r1[3]) {
        let g2 = |t: f64| ((r1[2] + r1[2]) * -0.375_f64).max(r1[1]) * t;
        let b = (g2((x * 0.375_f64).max(f)) + g2((r1[2] * -1.125_f64).max(-0.125_f64))).sin();
        'l3: for i4 in (2..4_usize).step_by(2) {
            r1[(i4 * i4 + 1) % 4] += (((y * f) + (f * r1[(i4 * i4 + 1) % 4])) + 0.125).tanh();
        }
        r1[0] = (((b + -0.875_f64) + (r1[3] + -1.125_f64).sin()) * 0.75).sin();
    } else {
        let mut f = ((-(r1[2])) + 0.125).tanh();
    }
    f += (-0.125_f64 + 0.125).tanh();
    f += ((x + (y + 0.625_f64).sin()) * 0.75).sin();
    let mut r5 = [(r1[2] * 0.75).sin(); 3];
    if (-(r1[2])) < (-(y)) {
        'l6: for i7 in 0..1_usize {
            if i7 % 2 == 1 {
                r1[1] -= (((f - y) * (x * -0.125_f64).max(f)) * 0.75).sin();
            }
            r5[i7 % 3] -= (((f * x) * (f * x) + 0.25).sqrt() + 0.125).tanh();
            for v in r5.iter() {
                f = f * ((x - 0.625_f64).tanh() + 0.125).tanh()
                    + *v * ((x - 0.625_f64).tanh() + 0.125).tanh();
            }
        }
        let mut b = ((r1[1] * -1.125_f64).max(y) + 0.125).tanh();
    }
    ((x / (1.5 + r5[1] * r5[1])) * (r5[0] * -0.875_f64).cos()) + f + y + x
}

fn program_7_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y * x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((f * S::from_f64(-0.125_f64)).max(f) + S::from_f64(0.125)).tanh(),
        (x * S::from_f64(0.75)).sin(),
        ((f * f) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
    ];
    if x.cmple((S::from_f64(-0.875_f64) * r1[3])) {
        let g2 = |t: S| ((r1[2] + r1[2]) * S::from_f64(-0.375_f64)).max(r1[1]) * t;
        let b = (g2((x * S::from_f64(0.375_f64)).max(f))
            + g2((r1[2] * S::from_f64(-1.125_f64)).max(S::from_f64(-0.125_f64))))
        .sin();
        'l3: for i4 in (2..4_usize).step_by(2) {
            r1[(i4 * i4 + 1) % 4] = r1[(i4 * i4 + 1) % 4]
                + (((y * f) + (f * r1[(i4 * i4 + 1) % 4])) + S::from_f64(0.125)).tanh();
        }
        r1[0] = (((b + S::from_f64(-0.875_f64)) + (r1[3] + S::from_f64(-1.125_f64)).sin())
            * S::from_f64(0.75))
        .sin();
    } else {
        let mut f = ((-(r1[2])) + S::from_f64(0.125)).tanh();
    }
    f = f + (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh();
    f = f + ((x + (y + S::from_f64(0.625_f64)).sin()) * S::from_f64(0.75)).sin();
    let mut r5 = [(r1[2] * S::from_f64(0.75)).sin(); 3];
    if (-(r1[2])).cmplt((-(y))) {
        'l6: for i7 in 0..1_usize {
            if i7 % 2 == 1 {
                r1[1] = r1[1]
                    - (((f - y) * (x * S::from_f64(-0.125_f64)).max(f)) * S::from_f64(0.75)).sin();
            }
            r5[i7 % 3] = r5[i7 % 3]
                - (((f * x) * (f * x) + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
            for v in r5.iter() {
                f = f * ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh()
                    + *v * ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
            }
        }
        let mut b = ((r1[1] * S::from_f64(-1.125_f64)).max(y) + S::from_f64(0.125)).tanh();
    }
    ((x / (S::from_f64(1.5) + r5[1] * r5[1])) * (r5[0] * S::from_f64(-0.875_f64)).cos()) + f + y + x
}

#[differentiable]
fn program_8(x: f64, y: f64) -> f64 {
    let mut b = ((x * x + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [
        ((x * x) * 0.75).sin(),
        ((x * -0.625_f64).max(y) * 0.75).sin(),
        ((0.875_f64 + b) * 0.75).sin(),
        ((b + 0.875_f64).sin() + 0.125).tanh(),
        (x + 0.125).tanh(),
    ];
    let (a, mut b) = (((b * -0.875_f64).abs() * 0.75).sin(), (r1[0] * r1[0] + 0.25).sqrt());
    'l2: for i3 in 1..=4_usize {
        let a = program_0(((y + x) + 0.125).tanh(), (a + 0.125).tanh()).tanh();
    }
    if (r1[0] + b) <= (r1[3] * r1[3] + 0.25).sqrt() {
        return ((r1[4] + r1[3]) - 0.375_f64).tanh();
    }
    'l4: for i5 in 2..=1_usize {
        let g6 = |t: f64| {
            ((0.625_f64 * -0.125_f64).max(x) * (0.625_f64 * -0.125_f64).max(x) + 0.25).sqrt() * t
        };
        let d =
            (g6((r1[(i5 * i5 + 1) % 5] * -0.625_f64).abs()) + g6((b - -0.625_f64).tanh())).sin();
        let e = if r1[3] > (b * -0.625_f64).max(d) {
            (((i5 as f64) * 0.25) * (((i5 as f64) * 0.25) + r1[4]))
        } else {
            ((-0.375_f64 * r1[i5 % 5]) + (r1[(i5 + 3) % 5] * r1[(i5 + 3) % 5] + 0.25).sqrt())
        };
        r1[4] += (r1[(i5 * i5 + 1) % 5] * 0.75).sin();
    }
    let r7 = [(x * 0.75).sin(); 2];
    let mut r8 = [
        ((a * y) + 0.125).tanh(),
        ((x - -1.125_f64).tanh() * 0.75).sin(),
        ((r7[1] * r7[1] + 0.25).sqrt() + 0.125).tanh(),
        ((x * -0.625_f64).max(a) * 0.75).sin(),
    ];
    if (r7[1] + 0.125_f64).sin() > y {
        let (a, mut b) = (((y - r8[3]) * 0.75).sin(), (x * -0.875_f64).abs());
        let a = (-(r7[1] + -1.125_f64));
    } else {
        b = (((b * b + 0.25).sqrt() * 0.875_f64).max(r8[2]) + 0.125).tanh();
        let d = (a * (0.375_f64 * r1[0]));
        let g9 = |t: f64| ((x + b) * -1.125_f64).max(r7[0]) * t;
        let c = (g9((r1[2] * x)) + g9((-(r8[1])))).sin();
    }
    ((y * y + 0.25).sqrt() * 0.125_f64).abs() + b + a + y + x
}

fn program_8_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x * x) * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.625_f64)).max(y) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.875_f64) + b) * S::from_f64(0.75)).sin(),
        ((b + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(0.125)).tanh(),
    ];
    let (a, mut b) = (
        ((b * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(),
        (r1[0] * r1[0] + S::from_f64(0.25)).sqrt(),
    );
    'l2: for i3 in 1..=4_usize {
        let a =
            program_0_of(((y + x) + S::from_f64(0.125)).tanh(), (a + S::from_f64(0.125)).tanh())
                .tanh();
    }
    if (r1[0] + b).cmple((r1[3] * r1[3] + S::from_f64(0.25)).sqrt()) {
        return ((r1[4] + r1[3]) - S::from_f64(0.375_f64)).tanh();
    }
    'l4: for i5 in 2..=1_usize {
        let g6 = |t: S| {
            ((S::from_f64(0.625_f64) * S::from_f64(-0.125_f64)).max(x)
                * (S::from_f64(0.625_f64) * S::from_f64(-0.125_f64)).max(x)
                + S::from_f64(0.25))
            .sqrt()
                * t
        };
        let d = (g6((r1[(i5 * i5 + 1) % 5] * S::from_f64(-0.625_f64)).abs())
            + g6((b - S::from_f64(-0.625_f64)).tanh()))
        .sin();
        let e = if r1[3].cmpgt((b * S::from_f64(-0.625_f64)).max(d)) {
            ((S::from_f64(i5 as f64) * S::from_f64(0.25))
                * ((S::from_f64(i5 as f64) * S::from_f64(0.25)) + r1[4]))
        } else {
            ((S::from_f64(-0.375_f64) * r1[i5 % 5])
                + (r1[(i5 + 3) % 5] * r1[(i5 + 3) % 5] + S::from_f64(0.25)).sqrt())
        };
        r1[4] = r1[4] + (r1[(i5 * i5 + 1) % 5] * S::from_f64(0.75)).sin();
    }
    let r7 = [(x * S::from_f64(0.75)).sin(); 2];
    let mut r8 = [
        ((a * y) + S::from_f64(0.125)).tanh(),
        ((x - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((r7[1] * r7[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.625_f64)).max(a) * S::from_f64(0.75)).sin(),
    ];
    if (r7[1] + S::from_f64(0.125_f64)).sin().cmpgt(y) {
        let (a, mut b) =
            (((y - r8[3]) * S::from_f64(0.75)).sin(), (x * S::from_f64(-0.875_f64)).abs());
        let a = (-(r7[1] + S::from_f64(-1.125_f64)));
    } else {
        b = (((b * b + S::from_f64(0.25)).sqrt() * S::from_f64(0.875_f64)).max(r8[2])
            + S::from_f64(0.125))
        .tanh();
        let d = (a * (S::from_f64(0.375_f64) * r1[0]));
        let g9 = |t: S| ((x + b) * S::from_f64(-1.125_f64)).max(r7[0]) * t;
        let c = (g9((r1[2] * x)) + g9((-(r8[1])))).sin();
    }
    ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.125_f64)).abs() + b + a + y + x
}

#[differentiable]
fn program_9(x: f64, y: f64) -> f64 {
    let mut f = (x + 0.125).tanh();
    let mut r1 = [((0.875_f64 * f) * 0.75).sin(); 2];
    let a = if (-0.375_f64 + f) < (x * r1[0]) {
        ((y * -0.125_f64).cos() / (1.5 + (f * x) * (f * x)))
    } else {
        ((y * y + 0.25).sqrt() - -0.875_f64).tanh()
    };
    f = ((x + -0.125_f64).sin() * 0.75).sin();
    'l2: for i3 in (1..0_usize).step_by(2) {
        f *= (((0.375_f64 * r1[(i3 * i3 + 1) % 2]) + (((i3 as f64) * 0.25) * -1.125_f64)) + 0.125)
            .tanh();
    }
    f += (((a * -0.625_f64) - -0.125_f64).tanh() * 0.75).sin();
    f = (((f - 0.875_f64).tanh()
        / (1.5 + (r1[1] + -1.125_f64).sin() * (r1[1] + -1.125_f64).sin()))
        * 0.75)
        .sin();
    'l4: for i5 in (1..0_usize).step_by(2) {
        let mut r6 = [(((i5 as f64) * 0.25) * 0.75).sin(); 3];
    }
    'l7: for i8 in 0..=4_usize {
        f += (((y * -1.125_f64).abs() + (y - -0.375_f64)) * 0.75).sin();
    }
    let mut r9 = [
        ((x * x) + 0.125).tanh(),
        ((f * r1[1]) * 0.75).sin(),
        ((r1[0] * r1[0] + 0.25).sqrt() * 0.75).sin(),
        ((y + a) + 0.125).tanh(),
    ];
    r1[1] *= (((0.625_f64 * 0.125_f64).cos() + (-0.125_f64 + x)) + 0.125).tanh();
    'l10: for i11 in (0..2_usize).rev() {
        f *= (((x * r9[0]) * (f + r1[1])) + 0.125).tanh();
        if (-0.625_f64 - r1[0]) > (r1[(i11 * i11 + 1) % 2] * r1[i11 % 2]) {
            let c = program_3(
                ((-((i11 as f64) * 0.25)) * 0.75).sin(),
                ((r1[(i11 * i11 + 1) % 2] * x) * 0.75).sin(),
            )
            .tanh();
            'l12: for i13 in (1..5_usize).rev() {
                r9[i13 % 4] =
                    (((0.625_f64 * 0.125_f64).max(r1[0]) * 0.375_f64).max(c) * 0.75).sin();
            }
            if x <= (r1[(i11 + 1) % 2] / (1.5 + r1[1] * r1[1])) {
                let mut e = (c * 0.75).sin();
                r9[0] += (((x / (1.5 + ((i11 as f64) * 0.25) * ((i11 as f64) * 0.25)))
                    / (1.5 + (f / (1.5 + a * a)) * (f / (1.5 + a * a))))
                    + 0.125)
                    .tanh();
                f = ((((i11 as f64) * 0.25) * 0.125_f64).abs() * 0.75).sin();
            } else {
                r9[3] = (((r9[0] * 0.375_f64).abs() - 0.875_f64).tanh() + 0.125).tanh();
                f = (((y - -0.125_f64).tanh() * -1.125_f64).abs() * 0.75).sin();
                f = (((((i11 as f64) * 0.25) * ((i11 as f64) * 0.25) + 0.25).sqrt()
                    * (((i11 as f64) * 0.25) * 0.125_f64).abs())
                    * 0.75)
                    .sin();
            }
        } else {
            for v in r1.iter() {
                f = f * ((r9[(i11 + 1) % 4] * r9[(i11 + 1) % 4] + 0.25).sqrt() + 0.125).tanh()
                    + *v * ((r9[(i11 + 1) % 4] * r9[(i11 + 1) % 4] + 0.25).sqrt() + 0.125).tanh();
            }
            let e = (-((x * x + 0.25).sqrt()));
            r1[0] = (((((i11 as f64) * 0.25) * y)
                / (1.5 + (-((i11 as f64) * 0.25)) * (-((i11 as f64) * 0.25))))
                + 0.125)
                .tanh();
        }
    }
    (y * r1[1]) + a + f + y + x
}

fn program_9_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((S::from_f64(0.875_f64) * f) * S::from_f64(0.75)).sin(); 2];
    let a = if (S::from_f64(-0.375_f64) + f).cmplt((x * r1[0])) {
        ((y * S::from_f64(-0.125_f64)).cos() / (S::from_f64(1.5) + (f * x) * (f * x)))
    } else {
        ((y * y + S::from_f64(0.25)).sqrt() - S::from_f64(-0.875_f64)).tanh()
    };
    f = ((x + S::from_f64(-0.125_f64)).sin() * S::from_f64(0.75)).sin();
    'l2: for i3 in (1..0_usize).step_by(2) {
        f = f
            * (((S::from_f64(0.375_f64) * r1[(i3 * i3 + 1) % 2])
                + ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)))
                + S::from_f64(0.125))
            .tanh();
    }
    f = f
        + (((a * S::from_f64(-0.625_f64)) - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75))
            .sin();
    f = (((f - S::from_f64(0.875_f64)).tanh()
        / (S::from_f64(1.5)
            + (r1[1] + S::from_f64(-1.125_f64)).sin() * (r1[1] + S::from_f64(-1.125_f64)).sin()))
        * S::from_f64(0.75))
    .sin();
    'l4: for i5 in (1..0_usize).step_by(2) {
        let mut r6 = [((S::from_f64(i5 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin(); 3];
    }
    'l7: for i8 in 0..=4_usize {
        f = f
            + (((y * S::from_f64(-1.125_f64)).abs() + (y - S::from_f64(-0.375_f64)))
                * S::from_f64(0.75))
            .sin();
    }
    let mut r9 = [
        ((x * x) + S::from_f64(0.125)).tanh(),
        ((f * r1[1]) * S::from_f64(0.75)).sin(),
        ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((y + a) + S::from_f64(0.125)).tanh(),
    ];
    r1[1] = r1[1]
        * (((S::from_f64(0.625_f64) * S::from_f64(0.125_f64)).cos()
            + (S::from_f64(-0.125_f64) + x))
            + S::from_f64(0.125))
        .tanh();
    'l10: for i11 in (0..2_usize).rev() {
        f = f * (((x * r9[0]) * (f + r1[1])) + S::from_f64(0.125)).tanh();
        if (S::from_f64(-0.625_f64) - r1[0]).cmpgt((r1[(i11 * i11 + 1) % 2] * r1[i11 % 2])) {
            let c = program_3_of(
                ((-(S::from_f64(i11 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                ((r1[(i11 * i11 + 1) % 2] * x) * S::from_f64(0.75)).sin(),
            )
            .tanh();
            'l12: for i13 in (1..5_usize).rev() {
                r9[i13 % 4] = (((S::from_f64(0.625_f64) * S::from_f64(0.125_f64)).max(r1[0])
                    * S::from_f64(0.375_f64))
                .max(c)
                    * S::from_f64(0.75))
                .sin();
            }
            if x.cmple((r1[(i11 + 1) % 2] / (S::from_f64(1.5) + r1[1] * r1[1]))) {
                let mut e = (c * S::from_f64(0.75)).sin();
                r9[0] = r9[0]
                    + (((x
                        / (S::from_f64(1.5)
                            + (S::from_f64(i11 as f64) * S::from_f64(0.25))
                                * (S::from_f64(i11 as f64) * S::from_f64(0.25))))
                        / (S::from_f64(1.5)
                            + (f / (S::from_f64(1.5) + a * a))
                                * (f / (S::from_f64(1.5) + a * a))))
                        + S::from_f64(0.125))
                    .tanh();
                f = (((S::from_f64(i11 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64))
                    .abs()
                    * S::from_f64(0.75))
                .sin();
            } else {
                r9[3] = (((r9[0] * S::from_f64(0.375_f64)).abs() - S::from_f64(0.875_f64)).tanh()
                    + S::from_f64(0.125))
                .tanh();
                f = (((y - S::from_f64(-0.125_f64)).tanh() * S::from_f64(-1.125_f64)).abs()
                    * S::from_f64(0.75))
                .sin();
                f = ((((S::from_f64(i11 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i11 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    * ((S::from_f64(i11 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64))
                        .abs())
                    * S::from_f64(0.75))
                .sin();
            }
        } else {
            for v in r1.iter() {
                f = f
                    * ((r9[(i11 + 1) % 4] * r9[(i11 + 1) % 4] + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.125))
                    .tanh()
                    + *v * ((r9[(i11 + 1) % 4] * r9[(i11 + 1) % 4] + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.125))
                    .tanh();
            }
            let e = (-((x * x + S::from_f64(0.25)).sqrt()));
            r1[0] = ((((S::from_f64(i11 as f64) * S::from_f64(0.25)) * y)
                / (S::from_f64(1.5)
                    + (-(S::from_f64(i11 as f64) * S::from_f64(0.25)))
                        * (-(S::from_f64(i11 as f64) * S::from_f64(0.25)))))
                + S::from_f64(0.125))
            .tanh();
        }
    }
    (y * r1[1]) + a + f + y + x
}

#[differentiable]
fn program_10(x: f64, y: f64) -> f64 {
    let mut b = (y + 0.125).tanh();
    let r1 = [((b * 0.625_f64).max(y) * 0.75).sin(); 5];
    if (r1[0] * -0.375_f64).cos() <= (b * b + 0.25).sqrt() {
        return ((-1.125_f64 / (1.5 + x * x)) * -0.375_f64).abs();
    }
    b = (((b * 0.125_f64).abs() * -0.625_f64).max(r1[2]) + 0.125).tanh();
    let mut r2 = [(y * 0.75).sin(); 4];
    r2[3] = (((y * y + 0.25).sqrt() * -1.125_f64).abs() * 0.75).sin();
    'l3: for i4 in 0..2_usize {
        let a = ((r1[(i4 + 1) % 5] * r1[(i4 + 1) % 5] + 0.25).sqrt() * -0.625_f64).cos();
    }
    'l5: for i6 in 0..2_usize {
        r2[(i6 * i6 + 1) % 4] =
            (((x / (1.5 + x * x)) * (r2[i6 % 4] * r2[(i6 * i6 + 1) % 4])) + 0.125).tanh();
    }
    'l7: for i8 in 1..5_usize {
        'l9: for i10 in 2..4_usize {
            if (b * b + 0.25).sqrt() > (((i8 as f64) * 0.25) - r1[0]) {
                continue 'l7;
            }
            r2[(i8 + 3) % 4] +=
                (((-0.125_f64 / (1.5 + 0.375_f64 * 0.375_f64)) - (b * -0.875_f64).abs()) + 0.125)
                    .tanh();
        }
        'l11: for i12 in (2..5_usize).step_by(2) {
            if i12 % 3 == 0 {
                let f = ((((i8 as f64) * 0.25) - -1.125_f64).tanh() / (1.5 + b * b));
                b -= (((-0.875_f64 + -0.875_f64).sin()
                    / (1.5
                        + (((i12 as f64) * 0.25) * ((i12 as f64) * 0.25) + 0.25).sqrt()
                            * (((i12 as f64) * 0.25) * ((i12 as f64) * 0.25) + 0.25).sqrt()))
                    + 0.125)
                    .tanh();
                let mut r13 = [((f + y) * 0.75).sin(); 3];
            } else {
                let mut r14 = [((x * y) * 0.75).sin(); 3];
            }
        }
        b = (((-0.625_f64 - -1.125_f64).tanh() + r2[0]) + 0.125).tanh();
    }
    (x * x + 0.25).sqrt() + b + y + x
}

fn program_10_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (y + S::from_f64(0.125)).tanh();
    let r1 = [((b * S::from_f64(0.625_f64)).max(y) * S::from_f64(0.75)).sin(); 5];
    if (r1[0] * S::from_f64(-0.375_f64)).cos().cmple((b * b + S::from_f64(0.25)).sqrt()) {
        return ((S::from_f64(-1.125_f64) / (S::from_f64(1.5) + x * x)) * S::from_f64(-0.375_f64))
            .abs();
    }
    b = (((b * S::from_f64(0.125_f64)).abs() * S::from_f64(-0.625_f64)).max(r1[2])
        + S::from_f64(0.125))
    .tanh();
    let mut r2 = [(y * S::from_f64(0.75)).sin(); 4];
    r2[3] = (((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(-1.125_f64)).abs()
        * S::from_f64(0.75))
    .sin();
    'l3: for i4 in 0..2_usize {
        let a = ((r1[(i4 + 1) % 5] * r1[(i4 + 1) % 5] + S::from_f64(0.25)).sqrt()
            * S::from_f64(-0.625_f64))
        .cos();
    }
    'l5: for i6 in 0..2_usize {
        r2[(i6 * i6 + 1) % 4] = (((x / (S::from_f64(1.5) + x * x))
            * (r2[i6 % 4] * r2[(i6 * i6 + 1) % 4]))
            + S::from_f64(0.125))
        .tanh();
    }
    'l7: for i8 in 1..5_usize {
        'l9: for i10 in 2..4_usize {
            if (b * b + S::from_f64(0.25))
                .sqrt()
                .cmpgt(((S::from_f64(i8 as f64) * S::from_f64(0.25)) - r1[0]))
            {
                continue 'l7;
            }
            r2[(i8 + 3) % 4] = r2[(i8 + 3) % 4]
                + (((S::from_f64(-0.125_f64)
                    / (S::from_f64(1.5) + S::from_f64(0.375_f64) * S::from_f64(0.375_f64)))
                    - (b * S::from_f64(-0.875_f64)).abs())
                    + S::from_f64(0.125))
                .tanh();
        }
        'l11: for i12 in (2..5_usize).step_by(2) {
            if i12 % 3 == 0 {
                let f = (((S::from_f64(i8 as f64) * S::from_f64(0.25)) - S::from_f64(-1.125_f64))
                    .tanh()
                    / (S::from_f64(1.5) + b * b));
                b = b
                    - (((S::from_f64(-0.875_f64) + S::from_f64(-0.875_f64)).sin()
                        / (S::from_f64(1.5)
                            + ((S::from_f64(i12 as f64) * S::from_f64(0.25))
                                * (S::from_f64(i12 as f64) * S::from_f64(0.25))
                                + S::from_f64(0.25))
                            .sqrt()
                                * ((S::from_f64(i12 as f64) * S::from_f64(0.25))
                                    * (S::from_f64(i12 as f64) * S::from_f64(0.25))
                                    + S::from_f64(0.25))
                                .sqrt()))
                        + S::from_f64(0.125))
                    .tanh();
                let mut r13 = [((f + y) * S::from_f64(0.75)).sin(); 3];
            } else {
                let mut r14 = [((x * y) * S::from_f64(0.75)).sin(); 3];
            }
        }
        b = (((S::from_f64(-0.625_f64) - S::from_f64(-1.125_f64)).tanh() + r2[0])
            + S::from_f64(0.125))
        .tanh();
    }
    (x * x + S::from_f64(0.25)).sqrt() + b + y + x
}

#[differentiable]
fn program_11(x: f64, y: f64) -> f64 {
    let mut e = ((y - y) * 0.75).sin();
    let mut r1 = [((x + -0.625_f64).sin() * 0.75).sin(); 2];
    let (a, mut b) = (((y + r1[1]) + 0.125).tanh(), (y + x));
    let mut r2 = [
        ((r1[0] * -0.875_f64).cos() * 0.75).sin(),
        ((e / (1.5 + e * e)) + 0.125).tanh(),
        ((y * 0.625_f64).max(r1[0]) * 0.75).sin(),
    ];
    let (a, mut b) = (((r1[0] - x) * 0.75).sin(), (0.125_f64 * y));
    'l3: for i4 in (0..4_usize).step_by(2) {
        'l5: for i6 in (i4..2_usize).step_by(2) {
            let f = if (b * a) > (y * b) {
                ((b + -0.375_f64).sin() + (r2[(i6 + 0) % 3] + -1.125_f64).sin())
            } else {
                ((-(b)) - -0.125_f64).tanh()
            };
            'l7: for i8 in (1..5_usize).step_by(2) {
                let mut c = ((x * x + 0.25).sqrt() * 0.75).sin();
            }
        }
        let (a, mut b) = ((-0.625_f64 * 0.75).sin(), (b * -0.625_f64).abs());
    }
    let g9 = |t: f64| ((b + 0.125_f64).sin() + (e - -1.125_f64).tanh()) * t;
    let a = (g9((0.875_f64 * 0.875_f64 + 0.25).sqrt()) + g9((r1[0] - e))).sin();
    if (a * -0.375_f64).cos() > (y * x) {
        return ((-(r2[1])) / (1.5 + (r1[1] * r2[0]) * (r1[1] * r2[0])));
    }
    let (a, mut b) = ((r2[0] + 0.125).tanh(), (x * a));
    if r2[1] <= (b + x) {
        e *= (((b + a) * (b + a) + 0.25).sqrt() * 0.75).sin();
        'l10: for i11 in 0..=1_usize {
            'l12: for i13 in 1..=5_usize {
                r2[i13 % 3] -= ((x * (a * a + 0.25).sqrt()) * 0.75).sin();
                r1[(i13 * i13 + 1) % 2] -= (((a * r2[i13 % 3]) * 0.125_f64).cos() * 0.75).sin();
            }
        }
    } else {
        let (a, mut b) = ((b + 0.125).tanh(), (-0.375_f64 * 0.875_f64).max(a));
        r1[1] -= (((r1[1] * a) * (r1[0] + 0.375_f64).sin()) * 0.75).sin();
        'l14: for i15 in (1..1_usize).step_by(2) {
            r1[0] = (((a * 0.375_f64).max(((i15 as f64) * 0.25)) * -1.125_f64).abs() * 0.75).sin();
            if i15 % 3 == 0 {
                let c = program_6(
                    ((-((i15 as f64) * 0.25)) * 0.75).sin(),
                    ((r1[(i15 + 1) % 2] * -0.375_f64).cos() * 0.75).sin(),
                )
                .tanh();
            }
        }
    }
    ((y * y) + (x * 0.625_f64).max(x)) + b + a + e + y + x
}

fn program_11_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y - y) * S::from_f64(0.75)).sin();
    let mut r1 = [((x + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(); 2];
    let (a, mut b) = (((y + r1[1]) + S::from_f64(0.125)).tanh(), (y + x));
    let mut r2 = [
        ((r1[0] * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ((e / (S::from_f64(1.5) + e * e)) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(0.625_f64)).max(r1[0]) * S::from_f64(0.75)).sin(),
    ];
    let (a, mut b) = (((r1[0] - x) * S::from_f64(0.75)).sin(), (S::from_f64(0.125_f64) * y));
    'l3: for i4 in (0..4_usize).step_by(2) {
        'l5: for i6 in (i4..2_usize).step_by(2) {
            let f = if (b * a).cmpgt((y * b)) {
                ((b + S::from_f64(-0.375_f64)).sin()
                    + (r2[(i6 + 0) % 3] + S::from_f64(-1.125_f64)).sin())
            } else {
                ((-(b)) - S::from_f64(-0.125_f64)).tanh()
            };
            'l7: for i8 in (1..5_usize).step_by(2) {
                let mut c = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
            }
        }
        let (a, mut b) = (
            (S::from_f64(-0.625_f64) * S::from_f64(0.75)).sin(),
            (b * S::from_f64(-0.625_f64)).abs(),
        );
    }
    let g9 = |t: S| ((b + S::from_f64(0.125_f64)).sin() + (e - S::from_f64(-1.125_f64)).tanh()) * t;
    let a = (g9((S::from_f64(0.875_f64) * S::from_f64(0.875_f64) + S::from_f64(0.25)).sqrt())
        + g9((r1[0] - e)))
    .sin();
    if (a * S::from_f64(-0.375_f64)).cos().cmpgt((y * x)) {
        return ((-(r2[1])) / (S::from_f64(1.5) + (r1[1] * r2[0]) * (r1[1] * r2[0])));
    }
    let (a, mut b) = ((r2[0] + S::from_f64(0.125)).tanh(), (x * a));
    if r2[1].cmple((b + x)) {
        e = e * (((b + a) * (b + a) + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
        'l10: for i11 in 0..=1_usize {
            'l12: for i13 in 1..=5_usize {
                r2[i13 % 3] = r2[i13 % 3]
                    - ((x * (a * a + S::from_f64(0.25)).sqrt()) * S::from_f64(0.75)).sin();
                r1[(i13 * i13 + 1) % 2] = r1[(i13 * i13 + 1) % 2]
                    - (((a * r2[i13 % 3]) * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75))
                        .sin();
            }
        }
    } else {
        let (a, mut b) = (
            (b + S::from_f64(0.125)).tanh(),
            (S::from_f64(-0.375_f64) * S::from_f64(0.875_f64)).max(a),
        );
        r1[1] = r1[1]
            - (((r1[1] * a) * (r1[0] + S::from_f64(0.375_f64)).sin()) * S::from_f64(0.75)).sin();
        'l14: for i15 in (1..1_usize).step_by(2) {
            r1[0] = (((a * S::from_f64(0.375_f64))
                .max((S::from_f64(i15 as f64) * S::from_f64(0.25)))
                * S::from_f64(-1.125_f64))
            .abs()
                * S::from_f64(0.75))
            .sin();
            if i15 % 3 == 0 {
                let c = program_6_of(
                    ((-(S::from_f64(i15 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
                    ((r1[(i15 + 1) % 2] * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
                )
                .tanh();
            }
        }
    }
    ((y * y) + (x * S::from_f64(0.625_f64)).max(x)) + b + a + e + y + x
}

#[differentiable]
fn program_12(x: f64, y: f64) -> f64 {
    let mut a = ((x * -0.375_f64).max(y) + 0.125).tanh();
    let mut r1 = [((-(a)) + 0.125).tanh(); 4];
    'l2: for i3 in 1..3_usize {
        r1[1] = (((r1[(i3 * i3 + 1) % 4] - -0.625_f64).tanh() * -1.125_f64).cos() * 0.75).sin();
        let g4 = |t: f64| (-(r1[(i3 * i3 + 1) % 4] / (1.5 + t * t))) * t;
        let a = (g4((x - ((i3 as f64) * 0.25))) + g4((((i3 as f64) * 0.25) + x))).sin();
        let mut b = ((-0.625_f64 * -0.875_f64).abs() + 0.125).tanh();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let f = if n6 % 2 == 0 {
            ((n6 as f64) * 0.25)
        } else {
            ((0.375_f64 + x)
                / (1.5 + (-1.125_f64 - -0.125_f64).tanh() * (-1.125_f64 - -0.125_f64).tanh()))
        };
    }
    a = ((y * -1.125_f64).abs() + 0.125).tanh();
    let g7 = |t: f64| ((a * 0.375_f64).abs() + (r1[0] * r1[0] + 0.25).sqrt()) * t;
    let a = (g7((x * 0.375_f64).cos()) + g7((a + -0.875_f64).sin())).sin();
    let mut f = (a * 0.75).sin();
    r1[3] = (((0.625_f64 * -0.375_f64).abs() * 0.875_f64).max(a) * 0.75).sin();
    r1[1] = (((x * f) * 0.875_f64).max(a) * 0.75).sin();
    let g8 = |t: f64| ((r1[3] * r1[2]) * (a * -0.125_f64).max(f)) * t;
    let f = (g8((f / (1.5 + r1[2] * r1[2]))) + g8((r1[0] * -1.125_f64).max(-0.875_f64))).sin();
    'l9: for i10 in 0..3_usize {
        let d = ((r1[(i10 + 2) % 4] + 0.375_f64).sin() * -0.875_f64).max(y);
    }
    ((r1[2] + f) * (f + f)) + f + a + y + x
}

fn program_12_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(-0.375_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((-(a)) + S::from_f64(0.125)).tanh(); 4];
    'l2: for i3 in 1..3_usize {
        r1[1] = (((r1[(i3 * i3 + 1) % 4] - S::from_f64(-0.625_f64)).tanh()
            * S::from_f64(-1.125_f64))
        .cos()
            * S::from_f64(0.75))
        .sin();
        let g4 = |t: S| (-(r1[(i3 * i3 + 1) % 4] / (S::from_f64(1.5) + t * t))) * t;
        let a = (g4((x - (S::from_f64(i3 as f64) * S::from_f64(0.25))))
            + g4(((S::from_f64(i3 as f64) * S::from_f64(0.25)) + x)))
        .sin();
        let mut b =
            ((S::from_f64(-0.625_f64) * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let f = if n6 % 2 == 0 {
            (S::from_f64(n6 as f64) * S::from_f64(0.25))
        } else {
            ((S::from_f64(0.375_f64) + x)
                / (S::from_f64(1.5)
                    + (S::from_f64(-1.125_f64) - S::from_f64(-0.125_f64)).tanh()
                        * (S::from_f64(-1.125_f64) - S::from_f64(-0.125_f64)).tanh()))
        };
    }
    a = ((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh();
    let g7 = |t: S| {
        ((a * S::from_f64(0.375_f64)).abs() + (r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) * t
    };
    let a =
        (g7((x * S::from_f64(0.375_f64)).cos()) + g7((a + S::from_f64(-0.875_f64)).sin())).sin();
    let mut f = (a * S::from_f64(0.75)).sin();
    r1[3] = (((S::from_f64(0.625_f64) * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.875_f64))
        .max(a)
        * S::from_f64(0.75))
    .sin();
    r1[1] = (((x * f) * S::from_f64(0.875_f64)).max(a) * S::from_f64(0.75)).sin();
    let g8 = |t: S| ((r1[3] * r1[2]) * (a * S::from_f64(-0.125_f64)).max(f)) * t;
    let f = (g8((f / (S::from_f64(1.5) + r1[2] * r1[2])))
        + g8((r1[0] * S::from_f64(-1.125_f64)).max(S::from_f64(-0.875_f64))))
    .sin();
    'l9: for i10 in 0..3_usize {
        let d =
            ((r1[(i10 + 2) % 4] + S::from_f64(0.375_f64)).sin() * S::from_f64(-0.875_f64)).max(y);
    }
    ((r1[2] + f) * (f + f)) + f + a + y + x
}

#[differentiable]
fn program_13(x: f64, y: f64) -> f64 {
    let mut e = ((x * y) + 0.125).tanh();
    let mut r1 = [(0.625_f64 * 0.75).sin(), ((y * 0.625_f64) + 0.125).tanh()];
    r1[0] += (((x + 0.125_f64).sin() * (0.875_f64 * -0.875_f64).max(r1[1])) + 0.125).tanh();
    let e = program_11(((-(r1[1])) + 0.125).tanh(), (e + 0.125).tanh()).tanh();
    'l2: for i3 in (1..1_usize).step_by(2) {
        let mut a = ((e + 0.875_f64).sin() * 0.75).sin();
        a = (-0.125_f64 + 0.125).tanh();
        r1[(i3 + 0) % 2] = (((r1[(i3 * i3 + 1) % 2] * r1[1]) + (e + r1[0])) * 0.75).sin();
    }
    if (r1[0] * r1[0] + 0.25).sqrt() >= (x + y) {
        return ((r1[0] * r1[0]) * 0.625_f64).max(r1[0]);
    }
    let mut f = ((r1[0] * e) * 0.75).sin();
    if (f - y) > (e + y) {
        let mut d = ((f - f) * 0.75).sin();
    }
    if (r1[0] * -1.125_f64).cos() <= (e + e) {
        let (a, mut b) = (((x / (1.5 + f * f)) + 0.125).tanh(), r1[1]);
    } else {
        let mut n5 = 0_usize;
        'l4: while n5 < 4 {
            n5 += 1;
            let f = if (f + r1[(n5 * n5 + 1) % 2]) <= (r1[(n5 + 1) % 2] + r1[(n5 + 1) % 2]) {
                ((r1[(n5 * n5 + 1) % 2] * ((n5 as f64) * 0.25)) - 0.375_f64).tanh()
            } else {
                ((((n5 as f64) * 0.25) * x) + -0.875_f64).sin()
            };
            if n5 % 3 == 0 {
                continue 'l4;
            }
            if n5 % 2 == 0 {
                let f =
                    program_7(((x * -1.125_f64).cos() + 0.125).tanh(), (0.125_f64 + 0.125).tanh())
                        .tanh();
                let mut c = ((e + e) + 0.125).tanh();
            }
        }
        'l6: for i7 in 2..5_usize {
            let d = (x * (e - -1.125_f64).tanh());
        }
        'l8: for i9 in 0..=5_usize {
            f = (((-(y)) * 0.875_f64).abs() + 0.125).tanh();
        }
    }
    (y * 0.375_f64).abs() + f + e + y + x
}

fn program_13_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh(),
    ];
    r1[0] = r1[0]
        + (((x + S::from_f64(0.125_f64)).sin()
            * (S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)).max(r1[1]))
            + S::from_f64(0.125))
        .tanh();
    let e =
        program_11_of(((-(r1[1])) + S::from_f64(0.125)).tanh(), (e + S::from_f64(0.125)).tanh())
            .tanh();
    'l2: for i3 in (1..1_usize).step_by(2) {
        let mut a = ((e + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin();
        a = (S::from_f64(-0.125_f64) + S::from_f64(0.125)).tanh();
        r1[(i3 + 0) % 2] =
            (((r1[(i3 * i3 + 1) % 2] * r1[1]) + (e + r1[0])) * S::from_f64(0.75)).sin();
    }
    if (r1[0] * r1[0] + S::from_f64(0.25)).sqrt().cmpge((x + y)) {
        return ((r1[0] * r1[0]) * S::from_f64(0.625_f64)).max(r1[0]);
    }
    let mut f = ((r1[0] * e) * S::from_f64(0.75)).sin();
    if (f - y).cmpgt((e + y)) {
        let mut d = ((f - f) * S::from_f64(0.75)).sin();
    }
    if (r1[0] * S::from_f64(-1.125_f64)).cos().cmple((e + e)) {
        let (a, mut b) = (((x / (S::from_f64(1.5) + f * f)) + S::from_f64(0.125)).tanh(), r1[1]);
    } else {
        let mut n5 = 0_usize;
        'l4: while n5 < 4 {
            n5 += 1;
            let f = if (f + r1[(n5 * n5 + 1) % 2]).cmple((r1[(n5 + 1) % 2] + r1[(n5 + 1) % 2])) {
                ((r1[(n5 * n5 + 1) % 2] * (S::from_f64(n5 as f64) * S::from_f64(0.25)))
                    - S::from_f64(0.375_f64))
                .tanh()
            } else {
                (((S::from_f64(n5 as f64) * S::from_f64(0.25)) * x) + S::from_f64(-0.875_f64)).sin()
            };
            if n5 % 3 == 0 {
                continue 'l4;
            }
            if n5 % 2 == 0 {
                let f = program_7_of(
                    ((x * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                    (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
                let mut c = ((e + e) + S::from_f64(0.125)).tanh();
            }
        }
        'l6: for i7 in 2..5_usize {
            let d = (x * (e - S::from_f64(-1.125_f64)).tanh());
        }
        'l8: for i9 in 0..=5_usize {
            f = (((-(y)) * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh();
        }
    }
    (y * S::from_f64(0.375_f64)).abs() + f + e + y + x
}

#[differentiable]
fn program_14(x: f64, y: f64) -> f64 {
    let mut a = ((y * y + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [((y - x) + 0.125).tanh(); 4];
    let d = if (x + x) >= (-0.875_f64 - -1.125_f64).tanh() {
        ((y - -0.125_f64).tanh() * (a + -0.625_f64).sin())
    } else {
        (0.375_f64 * (x - 0.625_f64).tanh())
    };
    'l2: for i3 in (2..5_usize).step_by(2) {
        let mut n5 = 0_usize;
        'l4: while n5 < 2 {
            n5 += 1;
            let (a, mut b) =
                (((r1[(n5 * n5 + 1) % 4] * r1[(n5 * n5 + 1) % 4] + 0.25).sqrt() * 0.75).sin(), a);
            let d = program_12(
                ((r1[(i3 * i3 + 1) % 4] * 0.625_f64).abs() + 0.125).tanh(),
                ((y - 0.125_f64).tanh() + 0.125).tanh(),
            )
            .tanh();
        }
        'l6: for i7 in 0..=0_usize {
            let a = ((r1[i7 % 4] + ((i3 as f64) * 0.25)) - 0.625_f64).tanh();
            let mut a = ((0.125_f64 + r1[i3 % 4]) * 0.75).sin();
        }
    }
    if (r1[0] - 0.625_f64).tanh() < (-0.375_f64 * r1[2]) {
        let mut r8 = [((x + d) + 0.125).tanh(); 4];
        'l9: for i10 in (0..4_usize).step_by(2) {
            a += (((-(y)) * (y / (1.5 + 0.625_f64 * 0.625_f64))) * 0.75).sin();
            let (a, mut b) =
                (((r1[i10 % 4] * y) * 0.75).sin(), (r8[(i10 + 0) % 4] * 0.125_f64).max(a));
            let mut b = ((a * r8[(i10 + 3) % 4]) + 0.125).tanh();
        }
    } else {
        let r11 = [(d + 0.125).tanh(); 3];
        let (a, mut b) = (((d * 0.125_f64).abs() * 0.75).sin(), (y / (1.5 + y * y)));
    }
    (d / (1.5 + (a * -0.125_f64).max(y) * (a * -0.125_f64).max(y))) + d + a + y + x
}

fn program_14_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [((y - x) + S::from_f64(0.125)).tanh(); 4];
    let d = if (x + x).cmpge((S::from_f64(-0.875_f64) - S::from_f64(-1.125_f64)).tanh()) {
        ((y - S::from_f64(-0.125_f64)).tanh() * (a + S::from_f64(-0.625_f64)).sin())
    } else {
        (S::from_f64(0.375_f64) * (x - S::from_f64(0.625_f64)).tanh())
    };
    'l2: for i3 in (2..5_usize).step_by(2) {
        let mut n5 = 0_usize;
        'l4: while n5 < 2 {
            n5 += 1;
            let (a, mut b) = (
                ((r1[(n5 * n5 + 1) % 4] * r1[(n5 * n5 + 1) % 4] + S::from_f64(0.25)).sqrt()
                    * S::from_f64(0.75))
                .sin(),
                a,
            );
            let d = program_12_of(
                ((r1[(i3 * i3 + 1) % 4] * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125))
                    .tanh(),
                ((y - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            )
            .tanh();
        }
        'l6: for i7 in 0..=0_usize {
            let a = ((r1[i7 % 4] + (S::from_f64(i3 as f64) * S::from_f64(0.25)))
                - S::from_f64(0.625_f64))
            .tanh();
            let mut a = ((S::from_f64(0.125_f64) + r1[i3 % 4]) * S::from_f64(0.75)).sin();
        }
    }
    if (r1[0] - S::from_f64(0.625_f64)).tanh().cmplt((S::from_f64(-0.375_f64) * r1[2])) {
        let mut r8 = [((x + d) + S::from_f64(0.125)).tanh(); 4];
        'l9: for i10 in (0..4_usize).step_by(2) {
            a = a
                + (((-(y))
                    * (y / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64))))
                    * S::from_f64(0.75))
                .sin();
            let (a, mut b) = (
                ((r1[i10 % 4] * y) * S::from_f64(0.75)).sin(),
                (r8[(i10 + 0) % 4] * S::from_f64(0.125_f64)).max(a),
            );
            let mut b = ((a * r8[(i10 + 3) % 4]) + S::from_f64(0.125)).tanh();
        }
    } else {
        let r11 = [(d + S::from_f64(0.125)).tanh(); 3];
        let (a, mut b) = (
            ((d * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
            (y / (S::from_f64(1.5) + y * y)),
        );
    }
    (d / (S::from_f64(1.5)
        + (a * S::from_f64(-0.125_f64)).max(y) * (a * S::from_f64(-0.125_f64)).max(y)))
        + d
        + a
        + y
        + x
}

#[differentiable]
fn program_15(x: f64, y: f64) -> f64 {
    let mut c = (-0.875_f64 + 0.125).tanh();
    let mut r1 = [(c * 0.75).sin(), ((c + -0.625_f64) * 0.75).sin(), (y + 0.125).tanh()];
    c = (((r1[1] + y) - -0.875_f64).tanh() + 0.125).tanh();
    if (x * x) > -0.875_f64 {
        return ((x - -0.375_f64).tanh() + (c * r1[1]));
    }
    r1[0] -= ((-(x)) + 0.125).tanh();
    for v in r1.iter() {
        c = c * ((c - -0.125_f64).tanh() * 0.75).sin()
            + *v * ((c - -0.125_f64).tanh() * 0.75).sin();
    }
    c = (((r1[1] * -0.375_f64).abs() - (x + r1[2])) + 0.125).tanh();
    if (y * y + 0.25).sqrt() >= (x + x) {
        c = (((-(y)) + -0.875_f64).sin() + 0.125).tanh();
        c = (((y * y) / (1.5 + (y / (1.5 + c * c)) * (y / (1.5 + c * c)))) + 0.125).tanh();
        'l2: for i3 in 1..=1_usize {
            let mut n5 = 0_usize;
            'l4: while n5 < 2 {
                n5 += 1;
                let a = y;
            }
            let mut n7 = 0_usize;
            'l6: while n7 < 5 {
                n7 += 1;
                r1[(i3 + 2) % 3] = (((-(r1[i3 % 3])) * 0.375_f64).cos() * 0.75).sin();
                let r8 = [
                    ((r1[(i3 * i3 + 1) % 3] * r1[(i3 * i3 + 1) % 3] + 0.25).sqrt() + 0.125).tanh(),
                    ((r1[n7 % 3] - ((i3 as f64) * 0.25)) * 0.75).sin(),
                    ((c * 0.375_f64).max(y) + 0.125).tanh(),
                    ((((n7 as f64) * 0.25) * ((n7 as f64) * 0.25) + 0.25).sqrt() * 0.75).sin(),
                ];
            }
            for v in r1.iter() {
                c = c * (r1[(i3 * i3 + 1) % 3] * 0.75).sin()
                    + *v * (r1[(i3 * i3 + 1) % 3] * 0.75).sin();
            }
        }
    } else {
        let e: f64 = r1.iter().map(|v| v * ((r1[0] + r1[1]) * 0.75).sin()).sum();
    }
    ((c - r1[1]) * 0.125_f64).abs() + c + y + x
}

fn program_15_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (S::from_f64(-0.875_f64) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (c * S::from_f64(0.75)).sin(),
        ((c + S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin(),
        (y + S::from_f64(0.125)).tanh(),
    ];
    c = (((r1[1] + y) - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
    if (x * x).cmpgt(S::from_f64(-0.875_f64)) {
        return ((x - S::from_f64(-0.375_f64)).tanh() + (c * r1[1]));
    }
    r1[0] = r1[0] - ((-(x)) + S::from_f64(0.125)).tanh();
    for v in r1.iter() {
        c = c * ((c - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin()
            + *v * ((c - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin();
    }
    c = (((r1[1] * S::from_f64(-0.375_f64)).abs() - (x + r1[2])) + S::from_f64(0.125)).tanh();
    if (y * y + S::from_f64(0.25)).sqrt().cmpge((x + x)) {
        c = (((-(y)) + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh();
        c = (((y * y)
            / (S::from_f64(1.5)
                + (y / (S::from_f64(1.5) + c * c)) * (y / (S::from_f64(1.5) + c * c))))
            + S::from_f64(0.125))
        .tanh();
        'l2: for i3 in 1..=1_usize {
            let mut n5 = 0_usize;
            'l4: while n5 < 2 {
                n5 += 1;
                let a = y;
            }
            let mut n7 = 0_usize;
            'l6: while n7 < 5 {
                n7 += 1;
                r1[(i3 + 2) % 3] =
                    (((-(r1[i3 % 3])) * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
                let r8 = [
                    ((r1[(i3 * i3 + 1) % 3] * r1[(i3 * i3 + 1) % 3] + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.125))
                    .tanh(),
                    ((r1[n7 % 3] - (S::from_f64(i3 as f64) * S::from_f64(0.25)))
                        * S::from_f64(0.75))
                    .sin(),
                    ((c * S::from_f64(0.375_f64)).max(y) + S::from_f64(0.125)).tanh(),
                    (((S::from_f64(n7 as f64) * S::from_f64(0.25))
                        * (S::from_f64(n7 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.25))
                    .sqrt()
                        * S::from_f64(0.75))
                    .sin(),
                ];
            }
            for v in r1.iter() {
                c = c * (r1[(i3 * i3 + 1) % 3] * S::from_f64(0.75)).sin()
                    + *v * (r1[(i3 * i3 + 1) % 3] * S::from_f64(0.75)).sin();
            }
        }
    } else {
        let e = r1
            .iter()
            .fold(S::from_f64(-0.0), |s, v| s + *v * ((r1[0] + r1[1]) * S::from_f64(0.75)).sin());
    }
    ((c - r1[1]) * S::from_f64(0.125_f64)).abs() + c + y + x
}

#[differentiable]
fn program_16(x: f64, y: f64) -> f64 {
    let mut f = (x * 0.75).sin();
    let mut r1 = [(x + 0.125).tanh(); 5];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        f = (((x + -0.625_f64).sin() + (y * -0.875_f64).cos()) + 0.125).tanh();
    }
    'l4: for i5 in 0..=4_usize {
        'l6: for i7 in (i5..4_usize).rev() {
            let f = ((x + f) * -0.625_f64).abs();
            'l8: for i9 in 1..1_usize {
                let mut a = ((r1[(i7 * i7 + 1) % 5] + f) * 0.75).sin();
                r1[(i5 * i5 + 1) % 5] += ((x * (-(0.125_f64))) * 0.75).sin();
            }
        }
        f = (((x + r1[(i5 * i5 + 1) % 5]) * (x + 0.875_f64).sin()) + 0.125).tanh();
    }
    let f = program_7(((-(r1[3])) + 0.125).tanh(), ((r1[4] - r1[0]) + 0.125).tanh()).tanh();
    r1[3] -= (y + 0.125).tanh();
    r1[3] = (r1[1] * 0.75).sin();
    let e = program_6(
        ((y + -0.125_f64).sin() + 0.125).tanh(),
        ((x * -0.125_f64).max(0.875_f64) + 0.125).tanh(),
    )
    .tanh();
    if (r1[0] + -0.375_f64) < (-(e)) {
        let f = if (e + r1[2]) >= (0.125_f64 * -0.625_f64).abs() {
            ((f / (1.5 + r1[2] * r1[2])) - 0.375_f64).tanh()
        } else {
            ((-0.125_f64 - r1[0]) * 0.125_f64).max(y)
        };
        r1[1] = (((0.375_f64 + f) + 0.375_f64).sin() * 0.75).sin();
        'l10: for i11 in (1..2_usize).step_by(2) {
            let mut a = ((e * ((i11 as f64) * 0.25)) * 0.75).sin();
            let (a, mut b) = (
                ((((i11 as f64) * 0.25) * ((i11 as f64) * 0.25) + 0.25).sqrt() + 0.125).tanh(),
                (y - 0.625_f64).tanh(),
            );
            let r12 = [((0.125_f64 / (1.5 + e * e)) * 0.75).sin(); 3];
        }
    }
    r1[0] + e + f + y + x
}

fn program_16_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = (x * S::from_f64(0.75)).sin();
    let mut r1 = [(x + S::from_f64(0.125)).tanh(); 5];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        f = (((x + S::from_f64(-0.625_f64)).sin() + (y * S::from_f64(-0.875_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    }
    'l4: for i5 in 0..=4_usize {
        'l6: for i7 in (i5..4_usize).rev() {
            let f = ((x + f) * S::from_f64(-0.625_f64)).abs();
            'l8: for i9 in 1..1_usize {
                let mut a = ((r1[(i7 * i7 + 1) % 5] + f) * S::from_f64(0.75)).sin();
                r1[(i5 * i5 + 1) % 5] = r1[(i5 * i5 + 1) % 5]
                    + ((x * (-(S::from_f64(0.125_f64)))) * S::from_f64(0.75)).sin();
            }
        }
        f = (((x + r1[(i5 * i5 + 1) % 5]) * (x + S::from_f64(0.875_f64)).sin())
            + S::from_f64(0.125))
        .tanh();
    }
    let f = program_7_of(
        ((-(r1[3])) + S::from_f64(0.125)).tanh(),
        ((r1[4] - r1[0]) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    r1[3] = r1[3] - (y + S::from_f64(0.125)).tanh();
    r1[3] = (r1[1] * S::from_f64(0.75)).sin();
    let e = program_6_of(
        ((y + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.125_f64)).max(S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    if (r1[0] + S::from_f64(-0.375_f64)).cmplt((-(e))) {
        let f = if (e + r1[2]).cmpge((S::from_f64(0.125_f64) * S::from_f64(-0.625_f64)).abs()) {
            ((f / (S::from_f64(1.5) + r1[2] * r1[2])) - S::from_f64(0.375_f64)).tanh()
        } else {
            ((S::from_f64(-0.125_f64) - r1[0]) * S::from_f64(0.125_f64)).max(y)
        };
        r1[1] = (((S::from_f64(0.375_f64) + f) + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75))
            .sin();
        'l10: for i11 in (1..2_usize).step_by(2) {
            let mut a =
                ((e * (S::from_f64(i11 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin();
            let (a, mut b) = (
                (((S::from_f64(i11 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i11 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh(),
                (y - S::from_f64(0.625_f64)).tanh(),
            );
            let r12 = [((S::from_f64(0.125_f64) / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75))
                .sin(); 3];
        }
    }
    r1[0] + e + f + y + x
}

#[differentiable]
fn program_17(x: f64, y: f64) -> f64 {
    let mut b = ((x - x) + 0.125).tanh();
    let mut r1 = [((-(b)) + 0.125).tanh(); 4];
    let g2 = |t: f64| ((y * b) * 0.375_f64).cos() * t;
    let c = (g2((b / (1.5 + x * x))) + g2((y / (1.5 + y * y)))).sin();
    let (a, mut b) = (((c + -0.375_f64).sin() + 0.125).tanh(), (r1[0] - -0.625_f64).tanh());
    r1[3] = (c * 0.75).sin();
    'l3: for i4 in 1..0_usize {
        if (c + 0.375_f64).sin() > (-(0.125_f64)) {
            break 'l3;
        }
        'l5: for i6 in (0..5_usize).rev() {
            b = (((((i6 as f64) * 0.25) * -0.625_f64).max(r1[(i6 * i6 + 1) % 4])
                * (c * r1[(i6 * i6 + 1) % 4]))
                * 0.75)
                .sin();
            'l7: for i8 in 1..1_usize {
                let b = program_12(((x * y) + 0.125).tanh(), ((r1[3] * x) + 0.125).tanh()).tanh();
                r1[(i6 + 2) % 4] = ((c - -0.875_f64).tanh() + 0.125).tanh();
                let f = (-((c * c + 0.25).sqrt()));
            }
            let mut r9 = [((((i4 as f64) * 0.25) - -0.875_f64).tanh() + 0.125).tanh(); 5];
        }
    }
    b += (((r1[3] * 0.125_f64).max(-1.125_f64) - (-(0.625_f64))) * 0.75).sin();
    'l10: for i11 in 0..=1_usize {
        'l12: for i13 in (i11..3_usize).step_by(2) {
            b *= (((r1[2] * 0.875_f64).abs()
                / (1.5
                    + (((i13 as f64) * 0.25) - 0.375_f64).tanh()
                        * (((i13 as f64) * 0.25) - 0.375_f64).tanh()))
                * 0.75)
                .sin();
            r1[(i13 * i13 + 1) % 4] -= (((y * y + 0.25).sqrt()
                * (((i11 as f64) * 0.25) * ((i11 as f64) * 0.25) + 0.25).sqrt())
                * 0.75)
                .sin();
        }
        if (-0.375_f64 * -0.375_f64 + 0.25).sqrt() <= (a * 0.125_f64) {
            'l14: for i15 in 1..=3_usize {
                r1[0] = (((-(r1[(i15 + 1) % 4])) * 0.625_f64).cos() * 0.75).sin();
                let b = ((((i11 as f64) * 0.25) - y) + (a + 0.125_f64));
            }
        } else {
            'l16: for i17 in 1..4_usize {
                b -= (((r1[1] + a) + (c - 0.875_f64).tanh()) * 0.75).sin();
                b = ((-((c * -1.125_f64).cos())) + 0.125).tanh();
                let a = program_10(
                    ((y * -0.625_f64).cos() + 0.125).tanh(),
                    ((x + -0.625_f64).sin() + 0.125).tanh(),
                )
                .tanh();
            }
            b += (((y + -0.875_f64).sin()
                / (1.5 + (b * r1[(i11 * i11 + 1) % 4]) * (b * r1[(i11 * i11 + 1) % 4])))
                + 0.125)
                .tanh();
        }
    }
    ((r1[1] * 0.875_f64).abs() * -0.875_f64).abs() + b + a + c + y + x
}

fn program_17_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x - x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((-(b)) + S::from_f64(0.125)).tanh(); 4];
    let g2 = |t: S| ((y * b) * S::from_f64(0.375_f64)).cos() * t;
    let c = (g2((b / (S::from_f64(1.5) + x * x))) + g2((y / (S::from_f64(1.5) + y * y)))).sin();
    let (a, mut b) = (
        ((c + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
        (r1[0] - S::from_f64(-0.625_f64)).tanh(),
    );
    r1[3] = (c * S::from_f64(0.75)).sin();
    'l3: for i4 in 1..0_usize {
        if (c + S::from_f64(0.375_f64)).sin().cmpgt((-(S::from_f64(0.125_f64)))) {
            break 'l3;
        }
        'l5: for i6 in (0..5_usize).rev() {
            b = ((((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64))
                .max(r1[(i6 * i6 + 1) % 4])
                * (c * r1[(i6 * i6 + 1) % 4]))
                * S::from_f64(0.75))
            .sin();
            'l7: for i8 in 1..1_usize {
                let b = program_12_of(
                    ((x * y) + S::from_f64(0.125)).tanh(),
                    ((r1[3] * x) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
                r1[(i6 + 2) % 4] =
                    ((c - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh();
                let f = (-((c * c + S::from_f64(0.25)).sqrt()));
            }
            let mut r9 =
                [(((S::from_f64(i4 as f64) * S::from_f64(0.25)) - S::from_f64(-0.875_f64)).tanh()
                    + S::from_f64(0.125))
                .tanh(); 5];
        }
    }
    b = b
        + (((r1[3] * S::from_f64(0.125_f64)).max(S::from_f64(-1.125_f64))
            - (-(S::from_f64(0.625_f64))))
            * S::from_f64(0.75))
        .sin();
    'l10: for i11 in 0..=1_usize {
        'l12: for i13 in (i11..3_usize).step_by(2) {
            b = b
                * (((r1[2] * S::from_f64(0.875_f64)).abs()
                    / (S::from_f64(1.5)
                        + ((S::from_f64(i13 as f64) * S::from_f64(0.25))
                            - S::from_f64(0.375_f64))
                        .tanh()
                            * ((S::from_f64(i13 as f64) * S::from_f64(0.25))
                                - S::from_f64(0.375_f64))
                            .tanh()))
                    * S::from_f64(0.75))
                .sin();
            r1[(i13 * i13 + 1) % 4] = r1[(i13 * i13 + 1) % 4]
                - (((y * y + S::from_f64(0.25)).sqrt()
                    * ((S::from_f64(i11 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i11 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.25))
                    .sqrt())
                    * S::from_f64(0.75))
                .sin();
        }
        if (S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25))
            .sqrt()
            .cmple((a * S::from_f64(0.125_f64)))
        {
            'l14: for i15 in 1..=3_usize {
                r1[0] = (((-(r1[(i15 + 1) % 4])) * S::from_f64(0.625_f64)).cos()
                    * S::from_f64(0.75))
                .sin();
                let b = (((S::from_f64(i11 as f64) * S::from_f64(0.25)) - y)
                    + (a + S::from_f64(0.125_f64)));
            }
        } else {
            'l16: for i17 in 1..4_usize {
                b = b
                    - (((r1[1] + a) + (c - S::from_f64(0.875_f64)).tanh()) * S::from_f64(0.75))
                        .sin();
                b = ((-((c * S::from_f64(-1.125_f64)).cos())) + S::from_f64(0.125)).tanh();
                let a = program_10_of(
                    ((y * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
                    ((x + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            }
            b = b
                + (((y + S::from_f64(-0.875_f64)).sin()
                    / (S::from_f64(1.5)
                        + (b * r1[(i11 * i11 + 1) % 4]) * (b * r1[(i11 * i11 + 1) % 4])))
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    ((r1[1] * S::from_f64(0.875_f64)).abs() * S::from_f64(-0.875_f64)).abs() + b + a + c + y + x
}

#[differentiable]
fn program_18(x: f64, y: f64) -> f64 {
    let mut f = ((y - 0.125_f64).tanh() + 0.125).tanh();
    let mut r1 =
        [((x * x) * 0.75).sin(), ((y * y) * 0.75).sin(), ((f * f + 0.25).sqrt() + 0.125).tanh()];
    let g2 = |t: f64| ((t * t) * (x / (1.5 + r1[1] * r1[1]))) * t;
    let f = (g2((y + 0.625_f64).sin()) + g2((r1[1] * y))).sin();
    let c = ((x - f) - (f * -0.125_f64).max(x));
    let mut a = ((r1[2] - 0.125_f64).tanh() + 0.125).tanh();
    let mut d = ((0.625_f64 * c) * 0.75).sin();
    'l3: for i4 in 1..2_usize {
        let mut d = ((a * f) * 0.75).sin();
        d *= (((-(0.625_f64)) - (-(x))) + 0.125).tanh();
    }
    'l5: for i6 in 0..=5_usize {
        let f = ((f * f) * 0.875_f64).abs();
        'l7: for i8 in 0..2_usize {
            let (a, mut b) = (
                ((a - -0.375_f64).tanh() + 0.125).tanh(),
                (r1[i8 % 3] / (1.5 + ((i6 as f64) * 0.25) * ((i6 as f64) * 0.25))),
            );
            let f = if b < (c * -0.125_f64).abs() {
                (y * 0.375_f64).abs()
            } else {
                ((-0.875_f64 * -0.375_f64).cos() * -0.875_f64).abs()
            };
        }
        let g9 = |t: f64| ((((i6 as f64) * 0.25) * -0.375_f64).abs() * y) * t;
        let d = (g9((r1[(i6 + 2) % 3] * r1[0])) + g9(r1[(i6 + 1) % 3])).sin();
    }
    let e = r1[1];
    ((x * 0.375_f64).abs() * (e / (1.5 + y * y))) + e + d + a + c + f + y + x
}

fn program_18_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((x * x) * S::from_f64(0.75)).sin(),
        ((y * y) * S::from_f64(0.75)).sin(),
        ((f * f + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
    ];
    let g2 = |t: S| ((t * t) * (x / (S::from_f64(1.5) + r1[1] * r1[1]))) * t;
    let f = (g2((y + S::from_f64(0.625_f64)).sin()) + g2((r1[1] * y))).sin();
    let c = ((x - f) - (f * S::from_f64(-0.125_f64)).max(x));
    let mut a = ((r1[2] - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut d = ((S::from_f64(0.625_f64) * c) * S::from_f64(0.75)).sin();
    'l3: for i4 in 1..2_usize {
        let mut d = ((a * f) * S::from_f64(0.75)).sin();
        d = d * (((-(S::from_f64(0.625_f64))) - (-(x))) + S::from_f64(0.125)).tanh();
    }
    'l5: for i6 in 0..=5_usize {
        let f = ((f * f) * S::from_f64(0.875_f64)).abs();
        'l7: for i8 in 0..2_usize {
            let (a, mut b) = (
                ((a - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
                (r1[i8 % 3]
                    / (S::from_f64(1.5)
                        + (S::from_f64(i6 as f64) * S::from_f64(0.25))
                            * (S::from_f64(i6 as f64) * S::from_f64(0.25)))),
            );
            let f = if b.cmplt((c * S::from_f64(-0.125_f64)).abs()) {
                (y * S::from_f64(0.375_f64)).abs()
            } else {
                ((S::from_f64(-0.875_f64) * S::from_f64(-0.375_f64)).cos()
                    * S::from_f64(-0.875_f64))
                .abs()
            };
        }
        let g9 = |t: S| {
            (((S::from_f64(i6 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64)).abs() * y) * t
        };
        let d = (g9((r1[(i6 + 2) % 3] * r1[0])) + g9(r1[(i6 + 1) % 3])).sin();
    }
    let e = r1[1];
    ((x * S::from_f64(0.375_f64)).abs() * (e / (S::from_f64(1.5) + y * y)))
        + e
        + d
        + a
        + c
        + f
        + y
        + x
}

#[differentiable]
fn program_19(x: f64, y: f64) -> f64 {
    let mut b = ((0.625_f64 + y) * 0.75).sin();
    let mut r1 = [
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
        (y + 0.125).tanh(),
        ((y - -0.375_f64).tanh() + 0.125).tanh(),
        ((y + 0.375_f64).sin() + 0.125).tanh(),
        ((x + x) * 0.75).sin(),
    ];
    for v in r1.iter() {
        b = b * (y + 0.125).tanh() + *v * (y + 0.125).tanh();
    }
    if (y + 0.125_f64).sin() > (y - r1[0]) {
        let (a, mut b) = ((y * 0.75).sin(), y);
        let g2 = |t: f64| t * t;
        let c = (g2((a * a)) + g2(r1[0])).sin();
        'l3: for i4 in 1..=2_usize {
            if i4 % 3 == 1 {
                let c = program_8(((a * 0.875_f64).max(c) + 0.125).tanh(), (c * 0.75).sin()).tanh();
                b *= (b * 0.75).sin();
                r1[(i4 * i4 + 1) % 5] =
                    (((((i4 as f64) * 0.25) * ((i4 as f64) * 0.25) + 0.25).sqrt() * -0.125_f64)
                        .cos()
                        + 0.125)
                        .tanh();
            } else {
                let d = ((b * -0.375_f64).max(0.125_f64) - -0.375_f64).tanh();
                r1[3] -= (((a * -0.375_f64).abs()
                    / (1.5
                        + (r1[(i4 + 4) % 5] + -0.875_f64).sin()
                            * (r1[(i4 + 4) % 5] + -0.875_f64).sin()))
                    * 0.75)
                    .sin();
            }
            if i4 % 2 == 1 {
                r1[(i4 * i4 + 1) % 5] +=
                    (((((i4 as f64) * 0.25) * -0.625_f64).max(r1[1]) * -0.625_f64).max(y) * 0.75)
                        .sin();
            } else {
                let (a, mut b) =
                    (((r1[3] + -0.375_f64).sin() + 0.125).tanh(), (-((i4 as f64) * 0.25)));
                b = (((-(r1[(i4 * i4 + 1) % 5])) * (((i4 as f64) * 0.25) + 0.375_f64).sin())
                    * 0.75)
                    .sin();
            }
        }
    }
    -0.625_f64 + b + y + x
}

fn program_19_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((S::from_f64(0.625_f64) + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        (y + S::from_f64(0.125)).tanh(),
        ((y - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x + x) * S::from_f64(0.75)).sin(),
    ];
    for v in r1.iter() {
        b = b * (y + S::from_f64(0.125)).tanh() + *v * (y + S::from_f64(0.125)).tanh();
    }
    if (y + S::from_f64(0.125_f64)).sin().cmpgt((y - r1[0])) {
        let (a, mut b) = ((y * S::from_f64(0.75)).sin(), y);
        let g2 = |t: S| t * t;
        let c = (g2((a * a)) + g2(r1[0])).sin();
        'l3: for i4 in 1..=2_usize {
            if i4 % 3 == 1 {
                let c = program_8_of(
                    ((a * S::from_f64(0.875_f64)).max(c) + S::from_f64(0.125)).tanh(),
                    (c * S::from_f64(0.75)).sin(),
                )
                .tanh();
                b = b * (b * S::from_f64(0.75)).sin();
                r1[(i4 * i4 + 1) % 5] = ((((S::from_f64(i4 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i4 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    * S::from_f64(-0.125_f64))
                .cos()
                    + S::from_f64(0.125))
                .tanh();
            } else {
                let d = ((b * S::from_f64(-0.375_f64)).max(S::from_f64(0.125_f64))
                    - S::from_f64(-0.375_f64))
                .tanh();
                r1[3] = r1[3]
                    - (((a * S::from_f64(-0.375_f64)).abs()
                        / (S::from_f64(1.5)
                            + (r1[(i4 + 4) % 5] + S::from_f64(-0.875_f64)).sin()
                                * (r1[(i4 + 4) % 5] + S::from_f64(-0.875_f64)).sin()))
                        * S::from_f64(0.75))
                    .sin();
            }
            if i4 % 2 == 1 {
                r1[(i4 * i4 + 1) % 5] = r1[(i4 * i4 + 1) % 5]
                    + ((((S::from_f64(i4 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64))
                        .max(r1[1])
                        * S::from_f64(-0.625_f64))
                    .max(y)
                        * S::from_f64(0.75))
                    .sin();
            } else {
                let (a, mut b) = (
                    ((r1[3] + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
                    (-(S::from_f64(i4 as f64) * S::from_f64(0.25))),
                );
                b = (((-(r1[(i4 * i4 + 1) % 5]))
                    * ((S::from_f64(i4 as f64) * S::from_f64(0.25)) + S::from_f64(0.375_f64))
                        .sin())
                    * S::from_f64(0.75))
                .sin();
            }
        }
    }
    S::from_f64(-0.625_f64) + b + y + x
}

#[differentiable]
fn program_20(x: f64, y: f64) -> f64 {
    let mut e = ((x * x + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [((x * x + 0.25).sqrt() + 0.125).tanh(); 2];
    let f = ((x / (1.5 + e * e)) + (-(r1[0])));
    if r1[0] >= x {
        return ((x * x + 0.25).sqrt() * 0.375_f64).abs();
    }
    'l2: for i3 in 0..=3_usize {
        'l4: for i5 in (i3..4_usize).step_by(2) {
            let mut b = ((((i3 as f64) * 0.25) / (1.5 + 0.375_f64 * 0.375_f64)) + 0.125).tanh();
            let mut n7 = 0_usize;
            'l6: while n7 < 4 {
                n7 += 1;
                let d = ((b * 0.625_f64).abs()
                    + (r1[(i3 * i3 + 1) % 2]
                        / (1.5 + r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2])));
                e = (((((i3 as f64) * 0.25) * -1.125_f64).cos() * 0.625_f64).cos() + 0.125).tanh();
            }
        }
    }
    if (e * r1[1]) <= (-(y)) {
        return ((y * -0.625_f64).abs() + (f / (1.5 + y * y)));
    }
    let r8 = [
        ((x + -1.125_f64).sin() * 0.75).sin(),
        ((e + -0.625_f64).sin() + 0.125).tanh(),
        ((e + -0.375_f64).sin() + 0.125).tanh(),
    ];
    if (e / (1.5 + y * y)) < e {
        return ((e * y) - 0.125_f64).tanh();
    }
    'l9: for i10 in (0..3_usize).step_by(2) {
        'l11: for i12 in (i10..3_usize).rev() {
            let (a, mut b) = (((x * -0.375_f64).abs() + 0.125).tanh(), y);
            let c: f64 = r1
                .iter()
                .map(|v| v * ((r8[(i10 * i10 + 1) % 3] * ((i12 as f64) * 0.25)) + 0.125).tanh())
                .sum();
        }
        if i10 % 4 == 0 {
            let c = ((r8[i10 % 3] * -0.375_f64).abs() - -0.875_f64).tanh();
            'l13: for i14 in i10..2_usize {
                let b = program_11(
                    ((r8[(i10 + 2) % 3] - e) + 0.125).tanh(),
                    (r1[i10 % 2] + 0.125).tanh(),
                )
                .tanh();
                let mut e = ((r8[(i14 * i14 + 1) % 3] + b) + 0.125).tanh();
                e -= (((f + r1[i10 % 2]) * (((i14 as f64) * 0.25) + 0.125_f64).sin()) + 0.125)
                    .tanh();
            }
            if i10 % 2 == 1 {
                r1[(i10 * i10 + 1) % 2] -=
                    (((r8[(i10 + 1) % 3] * r8[(i10 + 1) % 3] + 0.25).sqrt() * x) * 0.75).sin();
            } else {
                let mut r15 = [((-0.125_f64 * c) + 0.125).tanh(); 5];
                r1[1] += ((y / (1.5 + (r15[3] * y) * (r15[3] * y))) * 0.75).sin();
            }
        } else {
            let (a, mut b) =
                (((((i10 as f64) * 0.25) - r8[(i10 * i10 + 1) % 3]) + 0.125).tanh(), (e + y));
        }
        let mut r16 = [
            ((y * -0.125_f64).max(r8[i10 % 3]) + 0.125).tanh(),
            ((f / (1.5 + r8[(i10 + 2) % 3] * r8[(i10 + 2) % 3])) * 0.75).sin(),
            ((r8[(i10 + 0) % 3] + x) + 0.125).tanh(),
            (r8[1] * 0.75).sin(),
            (e + 0.125).tanh(),
        ];
    }
    ((r1[0] - r8[0]) + (-(x))) + f + e + y + x
}

fn program_20_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 2];
    let f = ((x / (S::from_f64(1.5) + e * e)) + (-(r1[0])));
    if r1[0].cmpge(x) {
        return ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.375_f64)).abs();
    }
    'l2: for i3 in 0..=3_usize {
        'l4: for i5 in (i3..4_usize).step_by(2) {
            let mut b = (((S::from_f64(i3 as f64) * S::from_f64(0.25))
                / (S::from_f64(1.5) + S::from_f64(0.375_f64) * S::from_f64(0.375_f64)))
                + S::from_f64(0.125))
            .tanh();
            let mut n7 = 0_usize;
            'l6: while n7 < 4 {
                n7 += 1;
                let d = ((b * S::from_f64(0.625_f64)).abs()
                    + (r1[(i3 * i3 + 1) % 2]
                        / (S::from_f64(1.5) + r1[(i5 * i5 + 1) % 2] * r1[(i5 * i5 + 1) % 2])));
                e = ((((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64))
                    .cos()
                    * S::from_f64(0.625_f64))
                .cos()
                    + S::from_f64(0.125))
                .tanh();
            }
        }
    }
    if (e * r1[1]).cmple((-(y))) {
        return ((y * S::from_f64(-0.625_f64)).abs() + (f / (S::from_f64(1.5) + y * y)));
    }
    let r8 = [
        ((x + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((e + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((e + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
    ];
    if (e / (S::from_f64(1.5) + y * y)).cmplt(e) {
        return ((e * y) - S::from_f64(0.125_f64)).tanh();
    }
    'l9: for i10 in (0..3_usize).step_by(2) {
        'l11: for i12 in (i10..3_usize).rev() {
            let (a, mut b) = (((x * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(), y);
            let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v
                    * ((r8[(i10 * i10 + 1) % 3] * (S::from_f64(i12 as f64) * S::from_f64(0.25)))
                        + S::from_f64(0.125))
                    .tanh()
            });
        }
        if i10 % 4 == 0 {
            let c =
                ((r8[i10 % 3] * S::from_f64(-0.375_f64)).abs() - S::from_f64(-0.875_f64)).tanh();
            'l13: for i14 in i10..2_usize {
                let b = program_11_of(
                    ((r8[(i10 + 2) % 3] - e) + S::from_f64(0.125)).tanh(),
                    (r1[i10 % 2] + S::from_f64(0.125)).tanh(),
                )
                .tanh();
                let mut e = ((r8[(i14 * i14 + 1) % 3] + b) + S::from_f64(0.125)).tanh();
                e = e
                    - (((f + r1[i10 % 2])
                        * ((S::from_f64(i14 as f64) * S::from_f64(0.25))
                            + S::from_f64(0.125_f64))
                        .sin())
                        + S::from_f64(0.125))
                    .tanh();
            }
            if i10 % 2 == 1 {
                r1[(i10 * i10 + 1) % 2] = r1[(i10 * i10 + 1) % 2]
                    - (((r8[(i10 + 1) % 3] * r8[(i10 + 1) % 3] + S::from_f64(0.25)).sqrt() * x)
                        * S::from_f64(0.75))
                    .sin();
            } else {
                let mut r15 = [((S::from_f64(-0.125_f64) * c) + S::from_f64(0.125)).tanh(); 5];
                r1[1] = r1[1]
                    + ((y / (S::from_f64(1.5) + (r15[3] * y) * (r15[3] * y))) * S::from_f64(0.75))
                        .sin();
            }
        } else {
            let (a, mut b) = (
                (((S::from_f64(i10 as f64) * S::from_f64(0.25)) - r8[(i10 * i10 + 1) % 3])
                    + S::from_f64(0.125))
                .tanh(),
                (e + y),
            );
        }
        let mut r16 = [
            ((y * S::from_f64(-0.125_f64)).max(r8[i10 % 3]) + S::from_f64(0.125)).tanh(),
            ((f / (S::from_f64(1.5) + r8[(i10 + 2) % 3] * r8[(i10 + 2) % 3])) * S::from_f64(0.75))
                .sin(),
            ((r8[(i10 + 0) % 3] + x) + S::from_f64(0.125)).tanh(),
            (r8[1] * S::from_f64(0.75)).sin(),
            (e + S::from_f64(0.125)).tanh(),
        ];
    }
    ((r1[0] - r8[0]) + (-(x))) + f + e + y + x
}

#[differentiable]
fn program_21(x: f64, y: f64) -> f64 {
    let mut a = ((x * y) + 0.125).tanh();
    let mut r1 = [((y + 0.375_f64).sin() * 0.75).sin(); 5];
    let e = program_15(((-(-0.375_f64)) + 0.125).tanh(), ((a * a) * 0.75).sin()).tanh();
    'l2: for i3 in 0..=4_usize {
        if (r1[0] * r1[0] + 0.25).sqrt() >= (x * -0.375_f64).max(r1[4]) {
            if (a / (1.5 + ((i3 as f64) * 0.25) * ((i3 as f64) * 0.25))) >= -0.625_f64 {
                let mut r4 = [
                    ((r1[4] * 0.625_f64).abs() * 0.75).sin(),
                    ((y - a) + 0.125).tanh(),
                    ((r1[(i3 * i3 + 1) % 5] * r1[(i3 * i3 + 1) % 5] + 0.25).sqrt() + 0.125).tanh(),
                ];
                let (a, mut b) = (((x * e) * 0.75).sin(), (a + x));
                let (a, mut b) = (((e * e + 0.25).sqrt() * 0.75).sin(), (x * x + 0.25).sqrt());
            } else {
                r1[i3 % 5] = ((r1[0] - (-(a))) * 0.75).sin();
                a = (((y - 0.625_f64).tanh() * (y - 0.625_f64).tanh() + 0.25).sqrt() * 0.75).sin();
                a = (x + 0.125).tanh();
            }
        } else {
            let mut e = ((y + y) + 0.125).tanh();
            if (a / (1.5 + x * x)) < (-1.125_f64 / (1.5 + e * e)) {
                continue 'l2;
            }
        }
        let mut c = ((r1[0] * -0.875_f64).max(r1[(i3 + 0) % 5]) + 0.125).tanh();
    }
    for v in r1.iter() {
        a = a * (y + 0.125).tanh() + *v * (y + 0.125).tanh();
    }
    ((r1[0] * 0.375_f64) - -0.375_f64).tanh() + e + a + y + x
}

fn program_21_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(); 5];
    let e = program_15_of(
        ((-(S::from_f64(-0.375_f64))) + S::from_f64(0.125)).tanh(),
        ((a * a) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    'l2: for i3 in 0..=4_usize {
        if (r1[0] * r1[0] + S::from_f64(0.25))
            .sqrt()
            .cmpge((x * S::from_f64(-0.375_f64)).max(r1[4]))
        {
            if (a
                / (S::from_f64(1.5)
                    + (S::from_f64(i3 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i3 as f64) * S::from_f64(0.25))))
            .cmpge(S::from_f64(-0.625_f64))
            {
                let mut r4 = [
                    ((r1[4] * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin(),
                    ((y - a) + S::from_f64(0.125)).tanh(),
                    ((r1[(i3 * i3 + 1) % 5] * r1[(i3 * i3 + 1) % 5] + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.125))
                    .tanh(),
                ];
                let (a, mut b) = (((x * e) * S::from_f64(0.75)).sin(), (a + x));
                let (a, mut b) = (
                    ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                    (x * x + S::from_f64(0.25)).sqrt(),
                );
            } else {
                r1[i3 % 5] = ((r1[0] - (-(a))) * S::from_f64(0.75)).sin();
                a = (((y - S::from_f64(0.625_f64)).tanh() * (y - S::from_f64(0.625_f64)).tanh()
                    + S::from_f64(0.25))
                .sqrt()
                    * S::from_f64(0.75))
                .sin();
                a = (x + S::from_f64(0.125)).tanh();
            }
        } else {
            let mut e = ((y + y) + S::from_f64(0.125)).tanh();
            if (a / (S::from_f64(1.5) + x * x))
                .cmplt((S::from_f64(-1.125_f64) / (S::from_f64(1.5) + e * e)))
            {
                continue 'l2;
            }
        }
        let mut c =
            ((r1[0] * S::from_f64(-0.875_f64)).max(r1[(i3 + 0) % 5]) + S::from_f64(0.125)).tanh();
    }
    for v in r1.iter() {
        a = a * (y + S::from_f64(0.125)).tanh() + *v * (y + S::from_f64(0.125)).tanh();
    }
    ((r1[0] * S::from_f64(0.375_f64)) - S::from_f64(-0.375_f64)).tanh() + e + a + y + x
}

#[differentiable]
fn program_22(x: f64, y: f64) -> f64 {
    let mut c = ((y * y + 0.25).sqrt() * 0.75).sin();
    let mut r1 = [((x * y) + 0.125).tanh(), ((-0.375_f64 * c) + 0.125).tanh()];
    let e = program_16(((c * c) * 0.75).sin(), (r1[1] + 0.125).tanh()).tanh();
    let mut r2 =
        [(-1.125_f64 + 0.125).tanh(), ((r1[1] + y) + 0.125).tanh(), ((x + y) + 0.125).tanh()];
    c += (((r1[0] * 0.625_f64) * (r1[0] * 0.625_f64) + 0.25).sqrt() * 0.75).sin();
    let d = (y * -0.375_f64).max(c);
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        if n4 % 2 == 0 {
            let g5 = |t: f64| ((y * 0.875_f64).cos() * 0.875_f64).max(((n4 as f64) * 0.25)) * t;
            let e = (g5((d * -1.125_f64).max(((n4 as f64) * 0.25))) + g5((c + r2[0]))).sin();
            'l6: for i7 in 0..0_usize {
                let r8 = [
                    ((r1[0] + x) * 0.75).sin(),
                    ((r2[2] * 0.125_f64).cos() + 0.125).tanh(),
                    (d * 0.75).sin(),
                    ((((i7 as f64) * 0.25) - y) + 0.125).tanh(),
                ];
                let (a, mut b) =
                    ((r8[(i7 * i7 + 1) % 4] * 0.75).sin(), (r1[(n4 + 0) % 2] - -0.875_f64).tanh());
            }
        }
    }
    let c = ((e * x) / (1.5 + (e * 0.375_f64).cos() * (e * 0.375_f64).cos()));
    let mut d = ((x - 0.125_f64).tanh() * 0.75).sin();
    r2[2] *= ((-(x)) + 0.125).tanh();
    r2[1] *= (((r1[1] / (1.5 + r2[2] * r2[2])) * (r1[1] + -0.375_f64).sin()) + 0.125).tanh();
    ((r1[1] + r1[1]) + 0.125_f64).sin() + d + c + e + y + x
}

fn program_22_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * y) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.375_f64) * c) + S::from_f64(0.125)).tanh(),
    ];
    let e = program_16_of(((c * c) * S::from_f64(0.75)).sin(), (r1[1] + S::from_f64(0.125)).tanh())
        .tanh();
    let mut r2 = [
        (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh(),
        ((r1[1] + y) + S::from_f64(0.125)).tanh(),
        ((x + y) + S::from_f64(0.125)).tanh(),
    ];
    c = c
        + (((r1[0] * S::from_f64(0.625_f64)) * (r1[0] * S::from_f64(0.625_f64))
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    let d = (y * S::from_f64(-0.375_f64)).max(c);
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        if n4 % 2 == 0 {
            let g5 = |t: S| {
                ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.875_f64))
                    .max((S::from_f64(n4 as f64) * S::from_f64(0.25)))
                    * t
            };
            let e = (g5(
                (d * S::from_f64(-1.125_f64)).max((S::from_f64(n4 as f64) * S::from_f64(0.25)))
            ) + g5((c + r2[0])))
            .sin();
            'l6: for i7 in 0..0_usize {
                let r8 = [
                    ((r1[0] + x) * S::from_f64(0.75)).sin(),
                    ((r2[2] * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                    (d * S::from_f64(0.75)).sin(),
                    (((S::from_f64(i7 as f64) * S::from_f64(0.25)) - y) + S::from_f64(0.125))
                        .tanh(),
                ];
                let (a, mut b) = (
                    (r8[(i7 * i7 + 1) % 4] * S::from_f64(0.75)).sin(),
                    (r1[(n4 + 0) % 2] - S::from_f64(-0.875_f64)).tanh(),
                );
            }
        }
    }
    let c = ((e * x)
        / (S::from_f64(1.5)
            + (e * S::from_f64(0.375_f64)).cos() * (e * S::from_f64(0.375_f64)).cos()));
    let mut d = ((x - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
    r2[2] = r2[2] * ((-(x)) + S::from_f64(0.125)).tanh();
    r2[1] = r2[1]
        * (((r1[1] / (S::from_f64(1.5) + r2[2] * r2[2]))
            * (r1[1] + S::from_f64(-0.375_f64)).sin())
            + S::from_f64(0.125))
        .tanh();
    ((r1[1] + r1[1]) + S::from_f64(0.125_f64)).sin() + d + c + e + y + x
}

#[differentiable]
fn program_23(x: f64, y: f64) -> f64 {
    let mut a = ((y - y) * 0.75).sin();
    let mut r1 = [((0.375_f64 * -0.125_f64) * 0.75).sin(); 2];
    let (a, mut b) = ((a * 0.75).sin(), (a * -1.125_f64).abs());
    b -= ((x * (r1[1] * a)) * 0.75).sin();
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let b = if r1[0] < (-(-0.625_f64)) {
            ((-0.125_f64 / (1.5 + a * a)) - 0.625_f64).tanh()
        } else {
            ((-1.125_f64 + -0.375_f64) * (b * b + 0.25).sqrt())
        };
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 1 {
        n5 += 1;
        r1[0] -= (-0.875_f64 + 0.125).tanh();
        let b = program_14(((y * r1[n5 % 2]) * 0.75).sin(), ((-(a)) + 0.125).tanh()).tanh();
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        b -= ((0.125_f64 * 0.875_f64).max(b) * 0.75).sin();
        b = (((a / (1.5 + ((n7 as f64) * 0.25) * ((n7 as f64) * 0.25))) - 0.625_f64).tanh()
            + 0.125)
            .tanh();
        r1[(n7 + 0) % 2] -= ((-0.125_f64 + -0.375_f64).sin() * 0.75).sin();
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        r1[(n9 + 1) % 2] +=
            (((x * 0.125_f64).cos() + (r1[n9 % 2] - -0.875_f64).tanh()) + 0.125).tanh();
        if n9 % 4 == 2 {
            let d = if n9 % 2 == 0 {
                ((0.875_f64 * x) * (r1[(n9 * n9 + 1) % 2] * y))
            } else {
                ((r1[0] * 0.125_f64).max(y) * -0.375_f64).max(r1[(n9 * n9 + 1) % 2])
            };
            if (r1[(n9 + 1) % 2] * y) < (r1[n9 % 2] * -0.625_f64).max(r1[(n9 + 0) % 2]) {
                break;
            }
            if n9 % 2 == 1 {
                r1[(n9 * n9 + 1) % 2] += (((r1[(n9 + 0) % 2] * r1[(n9 + 0) % 2] + 0.25).sqrt()
                    * -1.125_f64)
                    .max(r1[(n9 + 0) % 2])
                    + 0.125)
                    .tanh();
                b = ((a
                    / (1.5
                        + (((n9 as f64) * 0.25) - 0.125_f64).tanh()
                            * (((n9 as f64) * 0.25) - 0.125_f64).tanh()))
                    + 0.125)
                    .tanh();
                r1[(n9 * n9 + 1) % 2] =
                    (((r1[1] * ((n9 as f64) * 0.25)) + (-0.375_f64 * -0.625_f64).max(b)) * 0.75)
                        .sin();
            }
        }
        b = (y + 0.125).tanh();
    }
    ((y * r1[1]) - -0.375_f64).tanh() + b + a + y + x
}

fn program_23_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y - y) * S::from_f64(0.75)).sin();
    let mut r1 =
        [((S::from_f64(0.375_f64) * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(); 2];
    let (a, mut b) = ((a * S::from_f64(0.75)).sin(), (a * S::from_f64(-1.125_f64)).abs());
    b = b - ((x * (r1[1] * a)) * S::from_f64(0.75)).sin();
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let b = if r1[0].cmplt((-(S::from_f64(-0.625_f64)))) {
            ((S::from_f64(-0.125_f64) / (S::from_f64(1.5) + a * a)) - S::from_f64(0.625_f64)).tanh()
        } else {
            ((S::from_f64(-1.125_f64) + S::from_f64(-0.375_f64))
                * (b * b + S::from_f64(0.25)).sqrt())
        };
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 1 {
        n5 += 1;
        r1[0] = r1[0] - (S::from_f64(-0.875_f64) + S::from_f64(0.125)).tanh();
        let b = program_14_of(
            ((y * r1[n5 % 2]) * S::from_f64(0.75)).sin(),
            ((-(a)) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        b = b
            - ((S::from_f64(0.125_f64) * S::from_f64(0.875_f64)).max(b) * S::from_f64(0.75)).sin();
        b = (((a
            / (S::from_f64(1.5)
                + (S::from_f64(n7 as f64) * S::from_f64(0.25))
                    * (S::from_f64(n7 as f64) * S::from_f64(0.25))))
            - S::from_f64(0.625_f64))
        .tanh()
            + S::from_f64(0.125))
        .tanh();
        r1[(n7 + 0) % 2] = r1[(n7 + 0) % 2]
            - ((S::from_f64(-0.125_f64) + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin();
    }
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        r1[(n9 + 1) % 2] = r1[(n9 + 1) % 2]
            + (((x * S::from_f64(0.125_f64)).cos()
                + (r1[n9 % 2] - S::from_f64(-0.875_f64)).tanh())
                + S::from_f64(0.125))
            .tanh();
        if n9 % 4 == 2 {
            let d = if n9 % 2 == 0 {
                ((S::from_f64(0.875_f64) * x) * (r1[(n9 * n9 + 1) % 2] * y))
            } else {
                ((r1[0] * S::from_f64(0.125_f64)).max(y) * S::from_f64(-0.375_f64))
                    .max(r1[(n9 * n9 + 1) % 2])
            };
            if (r1[(n9 + 1) % 2] * y)
                .cmplt((r1[n9 % 2] * S::from_f64(-0.625_f64)).max(r1[(n9 + 0) % 2]))
            {
                break;
            }
            if n9 % 2 == 1 {
                r1[(n9 * n9 + 1) % 2] = r1[(n9 * n9 + 1) % 2]
                    + (((r1[(n9 + 0) % 2] * r1[(n9 + 0) % 2] + S::from_f64(0.25)).sqrt()
                        * S::from_f64(-1.125_f64))
                    .max(r1[(n9 + 0) % 2])
                        + S::from_f64(0.125))
                    .tanh();
                b = ((a
                    / (S::from_f64(1.5)
                        + ((S::from_f64(n9 as f64) * S::from_f64(0.25))
                            - S::from_f64(0.125_f64))
                        .tanh()
                            * ((S::from_f64(n9 as f64) * S::from_f64(0.25))
                                - S::from_f64(0.125_f64))
                            .tanh()))
                    + S::from_f64(0.125))
                .tanh();
                r1[(n9 * n9 + 1) % 2] = (((r1[1] * (S::from_f64(n9 as f64) * S::from_f64(0.25)))
                    + (S::from_f64(-0.375_f64) * S::from_f64(-0.625_f64)).max(b))
                    * S::from_f64(0.75))
                .sin();
            }
        }
        b = (y + S::from_f64(0.125)).tanh();
    }
    ((y * r1[1]) - S::from_f64(-0.375_f64)).tanh() + b + a + y + x
}

#[differentiable]
fn program_24(x: f64, y: f64) -> f64 {
    let mut c = ((x - 0.625_f64).tanh() + 0.125).tanh();
    let r1 = [(x * 0.75).sin(); 5];
    'l2: for i3 in (1..1_usize).rev() {
        let mut r4 = [((x * x) + 0.125).tanh(); 4];
        let mut f = ((0.125_f64 + 0.625_f64) * 0.75).sin();
        if (r1[1] * f) >= (r1[i3 % 5] * r1[i3 % 5] + 0.25).sqrt() {
            continue;
        }
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 3 {
        n6 += 1;
        if (r1[0] / (1.5 + r1[3] * r1[3])) >= (x + r1[n6 % 5]) {
            c = (((((n6 as f64) * 0.25) * y) * -0.375_f64).abs() * 0.75).sin();
        } else {
            let g7 = |t: f64| {
                ((t - -1.125_f64).tanh() / (1.5 + ((n6 as f64) * 0.25) * ((n6 as f64) * 0.25))) * t
            };
            let b = (g7((c / (1.5 + r1[(n6 * n6 + 1) % 5] * r1[(n6 * n6 + 1) % 5])))
                + g7((y * 0.375_f64).cos()))
            .sin();
            let e = ((r1[(n6 * n6 + 1) % 5] * 0.375_f64).cos() * (b * b));
        }
        for v in r1.iter() {
            c = c * ((c * r1[4]) + 0.125).tanh() + *v * ((c * r1[4]) + 0.125).tanh();
        }
    }
    if x >= (r1[0] * 0.625_f64) {
        'l8: for i9 in 2..=4_usize {
            let a = (y + c);
        }
        'l10: for i11 in (0..0_usize).step_by(2) {
            c += (((c * 0.125_f64) * -0.125_f64).cos() * 0.75).sin();
            let b =
                if i11 % 3 == 2 { ((r1[(i11 + 4) % 5] * x) + -0.625_f64) } else { (-(-0.125_f64)) };
        }
    } else {
        'l12: for i13 in (1..4_usize).rev() {
            c *= (c * 0.75).sin();
            c += (c * 0.75).sin();
            let b = if (x * -0.625_f64).max(x) >= (r1[i13 % 5] - x) {
                (y + 0.375_f64).sin()
            } else {
                ((x * c) - -0.125_f64).tanh()
            };
        }
        'l14: for i15 in (2..3_usize).rev() {
            let mut r16 = [((y + -0.375_f64).sin() * 0.75).sin(); 2];
            let b = program_0(((-(y)) * 0.75).sin(), ((y + r1[(i15 + 2) % 5]) * 0.75).sin()).tanh();
        }
        let (a, mut b) = (((c - -0.125_f64).tanh() * 0.75).sin(), -0.875_f64);
    }
    ((c / (1.5 + y * y)) * (y * c)) + c + y + x
}

fn program_24_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    let r1 = [(x * S::from_f64(0.75)).sin(); 5];
    'l2: for i3 in (1..1_usize).rev() {
        let mut r4 = [((x * x) + S::from_f64(0.125)).tanh(); 4];
        let mut f = ((S::from_f64(0.125_f64) + S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin();
        if (r1[1] * f).cmpge((r1[i3 % 5] * r1[i3 % 5] + S::from_f64(0.25)).sqrt()) {
            continue;
        }
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 3 {
        n6 += 1;
        if (r1[0] / (S::from_f64(1.5) + r1[3] * r1[3])).cmpge((x + r1[n6 % 5])) {
            c = ((((S::from_f64(n6 as f64) * S::from_f64(0.25)) * y) * S::from_f64(-0.375_f64))
                .abs()
                * S::from_f64(0.75))
            .sin();
        } else {
            let g7 = |t: S| {
                ((t - S::from_f64(-1.125_f64)).tanh()
                    / (S::from_f64(1.5)
                        + (S::from_f64(n6 as f64) * S::from_f64(0.25))
                            * (S::from_f64(n6 as f64) * S::from_f64(0.25))))
                    * t
            };
            let b = (g7((c / (S::from_f64(1.5) + r1[(n6 * n6 + 1) % 5] * r1[(n6 * n6 + 1) % 5])))
                + g7((y * S::from_f64(0.375_f64)).cos()))
            .sin();
            let e = ((r1[(n6 * n6 + 1) % 5] * S::from_f64(0.375_f64)).cos() * (b * b));
        }
        for v in r1.iter() {
            c = c * ((c * r1[4]) + S::from_f64(0.125)).tanh()
                + *v * ((c * r1[4]) + S::from_f64(0.125)).tanh();
        }
    }
    if x.cmpge((r1[0] * S::from_f64(0.625_f64))) {
        'l8: for i9 in 2..=4_usize {
            let a = (y + c);
        }
        'l10: for i11 in (0..0_usize).step_by(2) {
            c = c
                + (((c * S::from_f64(0.125_f64)) * S::from_f64(-0.125_f64)).cos()
                    * S::from_f64(0.75))
                .sin();
            let b = if i11 % 3 == 2 {
                ((r1[(i11 + 4) % 5] * x) + S::from_f64(-0.625_f64))
            } else {
                (-(S::from_f64(-0.125_f64)))
            };
        }
    } else {
        'l12: for i13 in (1..4_usize).rev() {
            c = c * (c * S::from_f64(0.75)).sin();
            c = c + (c * S::from_f64(0.75)).sin();
            let b = if (x * S::from_f64(-0.625_f64)).max(x).cmpge((r1[i13 % 5] - x)) {
                (y + S::from_f64(0.375_f64)).sin()
            } else {
                ((x * c) - S::from_f64(-0.125_f64)).tanh()
            };
        }
        'l14: for i15 in (2..3_usize).rev() {
            let mut r16 = [((y + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(); 2];
            let b = program_0_of(
                ((-(y)) * S::from_f64(0.75)).sin(),
                ((y + r1[(i15 + 2) % 5]) * S::from_f64(0.75)).sin(),
            )
            .tanh();
        }
        let (a, mut b) = (
            ((c - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
            S::from_f64(-0.875_f64),
        );
    }
    ((c / (S::from_f64(1.5) + y * y)) * (y * c)) + c + y + x
}

#[differentiable]
fn program_25(x: f64, y: f64) -> f64 {
    let mut f = ((x - x) + 0.125).tanh();
    let r1 = [((x * y) * 0.75).sin(), (f + 0.125).tanh(), (x + 0.125).tanh()];
    if (x * 0.875_f64).cos() <= (0.125_f64 - 0.125_f64).tanh() {
        'l2: for i3 in 1..=1_usize {
            f *= ((r1[1] * 0.125_f64).cos() * 0.75).sin();
        }
    }
    if (0.625_f64 * x) >= (-(r1[2])) {
        return ((-(0.625_f64)) * -0.375_f64).cos();
    }
    let g4 = |t: f64| (-(r1[0] - y)) * t;
    let b = (g4((r1[2] * r1[2] + 0.25).sqrt()) + g4(f)).sin();
    let mut f = ((y * r1[0]) * 0.75).sin();
    let c: f64 = r1.iter().map(|v| v * ((f - -0.375_f64).tanh() + 0.125).tanh()).sum();
    'l5: for i6 in (1..1_usize).rev() {
        let f: f64 = r1.iter().map(|v| v * ((x + b) * 0.75).sin()).sum();
    }
    f = (((b - 0.125_f64) * (b - 0.125_f64) + 0.25).sqrt() * 0.75).sin();
    'l7: for i8 in (2..2_usize).rev() {
        f -= (((0.375_f64 * 0.375_f64).cos()
            / (1.5
                + (((i8 as f64) * 0.25) + r1[(i8 * i8 + 1) % 3])
                    * (((i8 as f64) * 0.25) + r1[(i8 * i8 + 1) % 3])))
            + 0.125)
            .tanh();
        let mut n10 = 0_usize;
        'l9: while n10 < 2 {
            n10 += 1;
            'l11: for i12 in 1..2_usize {
                f = (((r1[(i12 * i12 + 1) % 3] * -0.875_f64).cos() + (r1[2] + 0.125_f64).sin())
                    * 0.75)
                    .sin();
                f = (((f * c) - 0.125_f64).tanh() * 0.75).sin();
            }
            f = (((f * r1[0]) - ((i8 as f64) * 0.25)) + 0.125).tanh();
        }
        f -= (((r1[(i8 + 0) % 3] * b) + -0.125_f64).sin() + 0.125).tanh();
    }
    ((r1[0] - 0.125_f64).tanh() - 0.375_f64).tanh() + c + f + b + y + x
}

fn program_25_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x - x) + S::from_f64(0.125)).tanh();
    let r1 = [
        ((x * y) * S::from_f64(0.75)).sin(),
        (f + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(0.125)).tanh(),
    ];
    if (x * S::from_f64(0.875_f64))
        .cos()
        .cmple((S::from_f64(0.125_f64) - S::from_f64(0.125_f64)).tanh())
    {
        'l2: for i3 in 1..=1_usize {
            f = f * ((r1[1] * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin();
        }
    }
    if (S::from_f64(0.625_f64) * x).cmpge((-(r1[2]))) {
        return ((-(S::from_f64(0.625_f64))) * S::from_f64(-0.375_f64)).cos();
    }
    let g4 = |t: S| (-(r1[0] - y)) * t;
    let b = (g4((r1[2] * r1[2] + S::from_f64(0.25)).sqrt()) + g4(f)).sin();
    let mut f = ((y * r1[0]) * S::from_f64(0.75)).sin();
    let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((f - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh()
    });
    'l5: for i6 in (1..1_usize).rev() {
        let f =
            r1.iter().fold(S::from_f64(-0.0), |s, v| s + *v * ((x + b) * S::from_f64(0.75)).sin());
    }
    f = (((b - S::from_f64(0.125_f64)) * (b - S::from_f64(0.125_f64)) + S::from_f64(0.25)).sqrt()
        * S::from_f64(0.75))
    .sin();
    'l7: for i8 in (2..2_usize).rev() {
        f = f
            - (((S::from_f64(0.375_f64) * S::from_f64(0.375_f64)).cos()
                / (S::from_f64(1.5)
                    + ((S::from_f64(i8 as f64) * S::from_f64(0.25)) + r1[(i8 * i8 + 1) % 3])
                        * ((S::from_f64(i8 as f64) * S::from_f64(0.25)) + r1[(i8 * i8 + 1) % 3])))
                + S::from_f64(0.125))
            .tanh();
        let mut n10 = 0_usize;
        'l9: while n10 < 2 {
            n10 += 1;
            'l11: for i12 in 1..2_usize {
                f = (((r1[(i12 * i12 + 1) % 3] * S::from_f64(-0.875_f64)).cos()
                    + (r1[2] + S::from_f64(0.125_f64)).sin())
                    * S::from_f64(0.75))
                .sin();
                f = (((f * c) - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
            }
            f = (((f * r1[0]) - (S::from_f64(i8 as f64) * S::from_f64(0.25))) + S::from_f64(0.125))
                .tanh();
        }
        f = f
            - (((r1[(i8 + 0) % 3] * b) + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125))
                .tanh();
    }
    ((r1[0] - S::from_f64(0.125_f64)).tanh() - S::from_f64(0.375_f64)).tanh() + c + f + b + y + x
}

#[differentiable]
fn program_26(x: f64, y: f64) -> f64 {
    let mut b = ((-0.625_f64 * -0.125_f64).cos() * 0.75).sin();
    let r1 = [((b + 0.375_f64).sin() * 0.75).sin(); 5];
    let d = program_18(((y * -0.125_f64).max(y) + 0.125).tanh(), ((-(r1[2])) * 0.75).sin()).tanh();
    let g2 = |t: f64| (0.875_f64 - -1.125_f64).tanh() * t;
    let a = (g2((y + x)) + g2(0.125_f64)).sin();
    b *= (y + 0.125).tanh();
    if (r1[1] * b) > (y * 0.125_f64).max(a) {
        let d = if (x * r1[3]) <= (r1[4] * -0.875_f64).abs() {
            b
        } else {
            ((r1[0] + -0.625_f64).sin() * (r1[0] + -0.625_f64).sin() + 0.25).sqrt()
        };
    }
    b += (((r1[1] * x) + (r1[3] + b)) * 0.75).sin();
    let d = program_24(((d * y) * 0.75).sin(), ((y * r1[4]) * 0.75).sin()).tanh();
    if (r1[3] * 0.625_f64).max(x) > (a * r1[1]) {
        b += (((r1[3] + a) * 0.375_f64).cos() + 0.125).tanh();
        let mut r3 = [
            ((0.125_f64 * 0.875_f64).abs() + 0.125).tanh(),
            ((y * -0.375_f64).cos() * 0.75).sin(),
            ((d - r1[2]) * 0.75).sin(),
            ((r1[1] + 0.625_f64).sin() * 0.75).sin(),
            (a + 0.125).tanh(),
        ];
    }
    b -= (((r1[2] - 0.625_f64).tanh() * -0.875_f64).cos() * 0.75).sin();
    b = (((r1[0] * a) - (0.875_f64 * 0.375_f64).cos()) + 0.125).tanh();
    let mut f = ((b * r1[3]) + 0.125).tanh();
    let mut n5 = 0_usize;
    'l4: while n5 < 3 {
        n5 += 1;
        let f = (-(x));
        if n5 % 3 == 2 {
            let d = program_12(((a * r1[n5 % 5]) * 0.75).sin(), ((r1[4] * b) * 0.75).sin()).tanh();
            b += (((0.375_f64 * 0.625_f64).abs()
                / (1.5
                    + (((n5 as f64) * 0.25) * ((n5 as f64) * 0.25) + 0.25).sqrt()
                        * (((n5 as f64) * 0.25) * ((n5 as f64) * 0.25) + 0.25).sqrt()))
                * 0.75)
                .sin();
        } else {
            b += ((x * -0.625_f64).max(a) * 0.75).sin();
        }
        b -= (((f * y) * -0.875_f64).max(r1[n5 % 5]) * 0.75).sin();
    }
    (-(d * r1[2])) + f + d + a + b + y + x
}

fn program_26_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b =
        ((S::from_f64(-0.625_f64) * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [((b + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(); 5];
    let d = program_18_of(
        ((y * S::from_f64(-0.125_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ((-(r1[2])) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let g2 = |t: S| (S::from_f64(0.875_f64) - S::from_f64(-1.125_f64)).tanh() * t;
    let a = (g2((y + x)) + g2(S::from_f64(0.125_f64))).sin();
    b = b * (y + S::from_f64(0.125)).tanh();
    if (r1[1] * b).cmpgt((y * S::from_f64(0.125_f64)).max(a)) {
        let d = if (x * r1[3]).cmple((r1[4] * S::from_f64(-0.875_f64)).abs()) {
            b
        } else {
            ((r1[0] + S::from_f64(-0.625_f64)).sin() * (r1[0] + S::from_f64(-0.625_f64)).sin()
                + S::from_f64(0.25))
            .sqrt()
        };
    }
    b = b + (((r1[1] * x) + (r1[3] + b)) * S::from_f64(0.75)).sin();
    let d =
        program_24_of(((d * y) * S::from_f64(0.75)).sin(), ((y * r1[4]) * S::from_f64(0.75)).sin())
            .tanh();
    if (r1[3] * S::from_f64(0.625_f64)).max(x).cmpgt((a * r1[1])) {
        b = b + (((r1[3] + a) * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
        let mut r3 = [
            ((S::from_f64(0.125_f64) * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
            ((y * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
            ((d - r1[2]) * S::from_f64(0.75)).sin(),
            ((r1[1] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
            (a + S::from_f64(0.125)).tanh(),
        ];
    }
    b = b
        - (((r1[2] - S::from_f64(0.625_f64)).tanh() * S::from_f64(-0.875_f64)).cos()
            * S::from_f64(0.75))
        .sin();
    b = (((r1[0] * a) - (S::from_f64(0.875_f64) * S::from_f64(0.375_f64)).cos())
        + S::from_f64(0.125))
    .tanh();
    let mut f = ((b * r1[3]) + S::from_f64(0.125)).tanh();
    let mut n5 = 0_usize;
    'l4: while n5 < 3 {
        n5 += 1;
        let f = (-(x));
        if n5 % 3 == 2 {
            let d = program_12_of(
                ((a * r1[n5 % 5]) * S::from_f64(0.75)).sin(),
                ((r1[4] * b) * S::from_f64(0.75)).sin(),
            )
            .tanh();
            b = b
                + (((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).abs()
                    / (S::from_f64(1.5)
                        + ((S::from_f64(n5 as f64) * S::from_f64(0.25))
                            * (S::from_f64(n5 as f64) * S::from_f64(0.25))
                            + S::from_f64(0.25))
                        .sqrt()
                            * ((S::from_f64(n5 as f64) * S::from_f64(0.25))
                                * (S::from_f64(n5 as f64) * S::from_f64(0.25))
                                + S::from_f64(0.25))
                            .sqrt()))
                    * S::from_f64(0.75))
                .sin();
        } else {
            b = b + ((x * S::from_f64(-0.625_f64)).max(a) * S::from_f64(0.75)).sin();
        }
        b = b - (((f * y) * S::from_f64(-0.875_f64)).max(r1[n5 % 5]) * S::from_f64(0.75)).sin();
    }
    (-(d * r1[2])) + f + d + a + b + y + x
}

#[differentiable]
fn program_27(x: f64, y: f64) -> f64 {
    let mut f = ((y + x) * 0.75).sin();
    let mut r1 = [((x * -0.625_f64).abs() * 0.75).sin(); 4];
    if (r1[3] * r1[3] + 0.25).sqrt() < r1[1] {
        return ((f + r1[3]) - (-0.875_f64 / (1.5 + y * y)));
    }
    for v in r1.iter() {
        f = f * ((y * f) + 0.125).tanh() + *v * ((y * f) + 0.125).tanh();
    }
    let mut a = ((f + r1[3]) + 0.125).tanh();
    let r2 = [((y - -1.125_f64).tanh() + 0.125).tanh(); 3];
    let a = y;
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        let mut a = ((f - 0.625_f64).tanh() * 0.75).sin();
        'l5: for i6 in (2..2_usize).rev() {
            if i6 % 4 == 1 {
                break 'l5;
            }
            if (r1[(i6 + 1) % 4] + r2[(i6 + 1) % 3]) < (r1[n4 % 4] * r1[n4 % 4] + 0.25).sqrt() {
                let mut e = (x + 0.125).tanh();
                a = (r2[2] * 0.75).sin();
                let mut d = (x * 0.75).sin();
            } else {
                r1[2] *= ((y * y + 0.25).sqrt() * 0.75).sin();
            }
        }
        r1[1] = (((-(x)) + (-((n4 as f64) * 0.25))) * 0.75).sin();
    }
    ((x + x) + -0.625_f64).sin() + a + f + y + x
}

fn program_27_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y + x) * S::from_f64(0.75)).sin();
    let mut r1 = [((x * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(); 4];
    if (r1[3] * r1[3] + S::from_f64(0.25)).sqrt().cmplt(r1[1]) {
        return ((f + r1[3]) - (S::from_f64(-0.875_f64) / (S::from_f64(1.5) + y * y)));
    }
    for v in r1.iter() {
        f = f * ((y * f) + S::from_f64(0.125)).tanh() + *v * ((y * f) + S::from_f64(0.125)).tanh();
    }
    let mut a = ((f + r1[3]) + S::from_f64(0.125)).tanh();
    let r2 = [((y - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(); 3];
    let a = y;
    let mut n4 = 0_usize;
    'l3: while n4 < 1 {
        n4 += 1;
        let mut a = ((f - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        'l5: for i6 in (2..2_usize).rev() {
            if i6 % 4 == 1 {
                break 'l5;
            }
            if (r1[(i6 + 1) % 4] + r2[(i6 + 1) % 3])
                .cmplt((r1[n4 % 4] * r1[n4 % 4] + S::from_f64(0.25)).sqrt())
            {
                let mut e = (x + S::from_f64(0.125)).tanh();
                a = (r2[2] * S::from_f64(0.75)).sin();
                let mut d = (x * S::from_f64(0.75)).sin();
            } else {
                r1[2] = r1[2] * ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
            }
        }
        r1[1] =
            (((-(x)) + (-(S::from_f64(n4 as f64) * S::from_f64(0.25)))) * S::from_f64(0.75)).sin();
    }
    ((x + x) + S::from_f64(-0.625_f64)).sin() + a + f + y + x
}

#[differentiable]
fn program_28(x: f64, y: f64) -> f64 {
    let mut b = ((x * -0.125_f64).cos() + 0.125).tanh();
    let mut r1 = [
        ((b + x) * 0.75).sin(),
        ((b * 0.875_f64).abs() + 0.125).tanh(),
        (b * 0.75).sin(),
        ((y + y) * 0.75).sin(),
        ((b + x) * 0.75).sin(),
    ];
    'l2: for i3 in (2..1_usize).step_by(2) {
        if (x * x) <= (r1[(i3 * i3 + 1) % 5] * r1[(i3 * i3 + 1) % 5] + 0.25).sqrt() {
            let g4 = |t: f64| x * t;
            let e = (g4((b * ((i3 as f64) * 0.25))) + g4(r1[0])).sin();
            let (a, mut b) = (((r1[(i3 + 1) % 5] * 0.625_f64).abs() * 0.75).sin(), r1[2]);
        } else {
            'l5: for i6 in i3..5_usize {
                let mut e = ((x * b) + 0.125).tanh();
                r1[(i3 + 0) % 5] -= (((((i3 as f64) * 0.25) * x) + 0.875_f64).sin() + 0.125).tanh();
            }
        }
        let r7 = [((r1[2] * b) + 0.125).tanh(), ((y * b) * 0.75).sin()];
        let mut c = ((((i3 as f64) * 0.25) * -0.125_f64).cos() * 0.75).sin();
    }
    if -1.125_f64 >= (b - -0.625_f64).tanh() {
        if (r1[1] * y) >= (x * 0.875_f64) {
            let mut f = (y * 0.75).sin();
            if (r1[2] * 0.625_f64).max(-0.375_f64) <= (r1[3] * r1[3] + 0.25).sqrt() {
                r1[0] = (((r1[2] * 0.625_f64).max(f) - 0.375_f64).tanh() * 0.75).sin();
                r1[0] += (b * 0.75).sin();
            }
        }
        if (-0.875_f64 + y) < (0.125_f64 / (1.5 + -0.375_f64 * -0.375_f64)) {
            return ((y / (1.5 + x * x)) * (b * x));
        }
    }
    ((-(r1[0])) * (y * r1[2])) + b + y + x
}

fn program_28_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((b + x) * S::from_f64(0.75)).sin(),
        ((b * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        (b * S::from_f64(0.75)).sin(),
        ((y + y) * S::from_f64(0.75)).sin(),
        ((b + x) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in (2..1_usize).step_by(2) {
        if (x * x).cmple((r1[(i3 * i3 + 1) % 5] * r1[(i3 * i3 + 1) % 5] + S::from_f64(0.25)).sqrt())
        {
            let g4 = |t: S| x * t;
            let e = (g4((b * (S::from_f64(i3 as f64) * S::from_f64(0.25)))) + g4(r1[0])).sin();
            let (a, mut b) = (
                ((r1[(i3 + 1) % 5] * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin(),
                r1[2],
            );
        } else {
            'l5: for i6 in i3..5_usize {
                let mut e = ((x * b) + S::from_f64(0.125)).tanh();
                r1[(i3 + 0) % 5] = r1[(i3 + 0) % 5]
                    - ((((S::from_f64(i3 as f64) * S::from_f64(0.25)) * x)
                        + S::from_f64(0.875_f64))
                    .sin()
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
        let r7 = [((r1[2] * b) + S::from_f64(0.125)).tanh(), ((y * b) * S::from_f64(0.75)).sin()];
        let mut c = (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
            .cos()
            * S::from_f64(0.75))
        .sin();
    }
    if S::from_f64(-1.125_f64).cmpge((b - S::from_f64(-0.625_f64)).tanh()) {
        if (r1[1] * y).cmpge((x * S::from_f64(0.875_f64))) {
            let mut f = (y * S::from_f64(0.75)).sin();
            if (r1[2] * S::from_f64(0.625_f64))
                .max(S::from_f64(-0.375_f64))
                .cmple((r1[3] * r1[3] + S::from_f64(0.25)).sqrt())
            {
                r1[0] = (((r1[2] * S::from_f64(0.625_f64)).max(f) - S::from_f64(0.375_f64)).tanh()
                    * S::from_f64(0.75))
                .sin();
                r1[0] = r1[0] + (b * S::from_f64(0.75)).sin();
            }
        }
        if (S::from_f64(-0.875_f64) + y).cmplt(
            (S::from_f64(0.125_f64)
                / (S::from_f64(1.5) + S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64))),
        ) {
            return ((y / (S::from_f64(1.5) + x * x)) * (b * x));
        }
    }
    ((-(r1[0])) * (y * r1[2])) + b + y + x
}

#[differentiable]
fn program_29(x: f64, y: f64) -> f64 {
    let mut d = ((x - y) + 0.125).tanh();
    let r1 = [((y * 0.375_f64).max(x) * 0.75).sin(); 4];
    d -= (((y * y) + 0.875_f64).sin() + 0.125).tanh();
    if (y * 0.125_f64).cos() > y {
        return ((d * -0.125_f64).cos() * -0.625_f64).cos();
    }
    d *= (((r1[1] * y) * -1.125_f64) * 0.75).sin();
    d = (((d * 0.875_f64).cos() * (d + y)) + 0.125).tanh();
    let e = program_7(((x - -0.375_f64).tanh() + 0.125).tanh(), ((-(d)) + 0.125).tanh()).tanh();
    'l2: for i3 in 1..=0_usize {
        let c = (r1[i3 % 4] - -0.125_f64).tanh();
    }
    'l4: for i5 in 0..=0_usize {
        if i5 % 3 == 0 {
            continue;
        }
    }
    d = ((-(y + x)) + 0.125).tanh();
    if (x * e) <= (r1[1] * r1[1] + 0.25).sqrt() {
        let mut b = ((r1[3] + 0.875_f64) * 0.75).sin();
        'l6: for i7 in 0..=3_usize {
            if (((i7 as f64) * 0.25) * -0.375_f64).max(r1[2])
                > (((i7 as f64) * 0.25) * 0.125_f64).abs()
            {
                let r8 = [
                    ((e * e + 0.25).sqrt() * 0.75).sin(),
                    (r1[(i7 + 3) % 4] * 0.75).sin(),
                    ((r1[i7 % 4] + -0.375_f64).sin() * 0.75).sin(),
                    ((-(r1[1])) + 0.125).tanh(),
                    ((-0.875_f64 * 0.125_f64).abs() + 0.125).tanh(),
                ];
                let c = ((b * b + 0.25).sqrt() - (e - -0.875_f64).tanh());
            } else {
                let mut d = ((r1[(i7 + 0) % 4] * -0.125_f64).max(b) + 0.125).tanh();
                let mut r9 = [
                    ((x * -0.375_f64) + 0.125).tanh(),
                    ((r1[i7 % 4] * e) * 0.75).sin(),
                    ((e * -0.125_f64).cos() + 0.125).tanh(),
                    ((y * y + 0.25).sqrt() * 0.75).sin(),
                ];
                d += (((b + 0.875_f64).sin() * (-1.125_f64 - -0.125_f64).tanh()) + 0.125).tanh();
            }
            'l10: for i11 in (i7..3_usize).step_by(2) {
                d += (((r1[3] + e) - (r1[0] * -0.875_f64)) + 0.125).tanh();
                b += (((e * e + 0.25).sqrt() - 0.625_f64).tanh() + 0.125).tanh();
            }
            'l12: for i13 in (i7..5_usize).rev() {
                let a = ((r1[(i13 * i13 + 1) % 4] - -0.875_f64).tanh()
                    - (r1[(i7 + 3) % 4] / (1.5 + y * y)));
                let mut r14 = [((e * b) + 0.125).tanh(), ((x * d) * 0.75).sin()];
                b *= (((a + r1[i7 % 4]) + -0.375_f64).sin() * 0.75).sin();
            }
        }
        d -= (((x * r1[3]) / (1.5 + (r1[2] * y) * (r1[2] * y))) + 0.125).tanh();
    } else {
        'l15: for i16 in 0..=0_usize {
            if i16 % 4 == 2 {
                let mut r17 = [
                    ((r1[i16 % 4] + r1[(i16 * i16 + 1) % 4]) + 0.125).tanh(),
                    ((d - d) * 0.75).sin(),
                    ((x + ((i16 as f64) * 0.25)) + 0.125).tanh(),
                    (d + 0.125).tanh(),
                    ((r1[0] * y) * 0.75).sin(),
                ];
                d += (e + 0.125).tanh();
                d += (((x * -0.625_f64).cos() * 0.125_f64).cos() + 0.125).tanh();
            }
            'l18: for i19 in i16..4_usize {
                let mut r20 = [((0.375_f64 * 0.875_f64).cos() + 0.125).tanh(); 3];
            }
            for v in r1.iter() {
                d = d * ((r1[(i16 + 2) % 4] * y) * 0.75).sin()
                    + *v * ((r1[(i16 + 2) % 4] * y) * 0.75).sin();
            }
        }
    }
    ((d - 0.125_f64).tanh() * (0.125_f64 + e)) + e + d + y + x
}

fn program_29_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x - y) + S::from_f64(0.125)).tanh();
    let r1 = [((y * S::from_f64(0.375_f64)).max(x) * S::from_f64(0.75)).sin(); 4];
    d = d - (((y * y) + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh();
    if (y * S::from_f64(0.125_f64)).cos().cmpgt(y) {
        return ((d * S::from_f64(-0.125_f64)).cos() * S::from_f64(-0.625_f64)).cos();
    }
    d = d * (((r1[1] * y) * S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin();
    d = (((d * S::from_f64(0.875_f64)).cos() * (d + y)) + S::from_f64(0.125)).tanh();
    let e = program_7_of(
        ((x - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((-(d)) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    'l2: for i3 in 1..=0_usize {
        let c = (r1[i3 % 4] - S::from_f64(-0.125_f64)).tanh();
    }
    'l4: for i5 in 0..=0_usize {
        if i5 % 3 == 0 {
            continue;
        }
    }
    d = ((-(y + x)) + S::from_f64(0.125)).tanh();
    if (x * e).cmple((r1[1] * r1[1] + S::from_f64(0.25)).sqrt()) {
        let mut b = ((r1[3] + S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin();
        'l6: for i7 in 0..=3_usize {
            if ((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64))
                .max(r1[2])
                .cmpgt(
                    ((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64)).abs(),
                )
            {
                let r8 = [
                    ((e * e + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                    (r1[(i7 + 3) % 4] * S::from_f64(0.75)).sin(),
                    ((r1[i7 % 4] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
                    ((-(r1[1])) + S::from_f64(0.125)).tanh(),
                    ((S::from_f64(-0.875_f64) * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125))
                        .tanh(),
                ];
                let c = ((b * b + S::from_f64(0.25)).sqrt() - (e - S::from_f64(-0.875_f64)).tanh());
            } else {
                let mut d = ((r1[(i7 + 0) % 4] * S::from_f64(-0.125_f64)).max(b)
                    + S::from_f64(0.125))
                .tanh();
                let mut r9 = [
                    ((x * S::from_f64(-0.375_f64)) + S::from_f64(0.125)).tanh(),
                    ((r1[i7 % 4] * e) * S::from_f64(0.75)).sin(),
                    ((e * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
                    ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                ];
                d = d
                    + (((b + S::from_f64(0.875_f64)).sin()
                        * (S::from_f64(-1.125_f64) - S::from_f64(-0.125_f64)).tanh())
                        + S::from_f64(0.125))
                    .tanh();
            }
            'l10: for i11 in (i7..3_usize).step_by(2) {
                d = d
                    + (((r1[3] + e) - (r1[0] * S::from_f64(-0.875_f64))) + S::from_f64(0.125))
                        .tanh();
                b = b
                    + (((e * e + S::from_f64(0.25)).sqrt() - S::from_f64(0.625_f64)).tanh()
                        + S::from_f64(0.125))
                    .tanh();
            }
            'l12: for i13 in (i7..5_usize).rev() {
                let a = ((r1[(i13 * i13 + 1) % 4] - S::from_f64(-0.875_f64)).tanh()
                    - (r1[(i7 + 3) % 4] / (S::from_f64(1.5) + y * y)));
                let mut r14 =
                    [((e * b) + S::from_f64(0.125)).tanh(), ((x * d) * S::from_f64(0.75)).sin()];
                b = b
                    * (((a + r1[i7 % 4]) + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75))
                        .sin();
            }
        }
        d = d
            - (((x * r1[3]) / (S::from_f64(1.5) + (r1[2] * y) * (r1[2] * y))) + S::from_f64(0.125))
                .tanh();
    } else {
        'l15: for i16 in 0..=0_usize {
            if i16 % 4 == 2 {
                let mut r17 = [
                    ((r1[i16 % 4] + r1[(i16 * i16 + 1) % 4]) + S::from_f64(0.125)).tanh(),
                    ((d - d) * S::from_f64(0.75)).sin(),
                    ((x + (S::from_f64(i16 as f64) * S::from_f64(0.25))) + S::from_f64(0.125))
                        .tanh(),
                    (d + S::from_f64(0.125)).tanh(),
                    ((r1[0] * y) * S::from_f64(0.75)).sin(),
                ];
                d = d + (e + S::from_f64(0.125)).tanh();
                d = d
                    + (((x * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.125_f64)).cos()
                        + S::from_f64(0.125))
                    .tanh();
            }
            'l18: for i19 in i16..4_usize {
                let mut r20 = [((S::from_f64(0.375_f64) * S::from_f64(0.875_f64)).cos()
                    + S::from_f64(0.125))
                .tanh(); 3];
            }
            for v in r1.iter() {
                d = d * ((r1[(i16 + 2) % 4] * y) * S::from_f64(0.75)).sin()
                    + *v * ((r1[(i16 + 2) % 4] * y) * S::from_f64(0.75)).sin();
            }
        }
    }
    ((d - S::from_f64(0.125_f64)).tanh() * (S::from_f64(0.125_f64) + e)) + e + d + y + x
}

#[differentiable]
fn program_30(x: f64, y: f64) -> f64 {
    let mut a = ((y - -0.875_f64).tanh() * 0.75).sin();
    let mut r1 = [((y * 0.875_f64).cos() + 0.125).tanh(); 4];
    let f = ((y + r1[0]) + (a * -0.875_f64));
    let mut b = ((x * f) * 0.75).sin();
    a += (((x * x + 0.25).sqrt() * (r1[1] + x)) * 0.75).sin();
    r1[1] = (((f - r1[3]) + (r1[2] + 0.625_f64).sin()) * 0.75).sin();
    a *= (((r1[1] - 0.125_f64).tanh() + -0.375_f64).sin() * 0.75).sin();
    r1[0] += (((x - x) + -0.375_f64).sin() + 0.125).tanh();
    if (y - -0.375_f64).tanh() < (a * 0.875_f64).cos() {
        return ((b - -0.125_f64).tanh() + -1.125_f64).sin();
    }
    let mut e = ((a * 0.875_f64).max(b) * 0.75).sin();
    a = (((r1[0] + 0.625_f64).sin() + -0.875_f64).sin() * 0.75).sin();
    let d = y;
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        r1[0] += (((n3 as f64) * 0.25) + 0.125).tanh();
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 3 {
        n5 += 1;
        'l6: for i7 in (n5..0_usize).step_by(2) {
            let f: f64 = r1.iter().map(|v| v * ((0.875_f64 * -0.625_f64).cos() * 0.75).sin()).sum();
            'l8: for i9 in i7..5_usize {
                let (a, mut b) =
                    (((f * -0.375_f64).cos() * 0.75).sin(), (r1[(n5 + 2) % 4] + 0.875_f64));
                r1[n5 % 4] = (r1[i7 % 4] + 0.125).tanh();
                let d = program_0(
                    ((r1[3] * r1[(i9 + 3) % 4]) * 0.75).sin(),
                    ((y - 0.125_f64) + 0.125).tanh(),
                )
                .tanh();
            }
            'l10: for i11 in 0..=3_usize {
                let (a, mut b) = (
                    ((r1[3] - 0.125_f64).tanh() * 0.75).sin(),
                    (r1[(i7 + 3) % 4] * r1[(n5 * n5 + 1) % 4]),
                );
                let d = ((r1[1] - -0.375_f64).tanh() - -0.125_f64).tanh();
                let (a, mut b) = (
                    ((r1[n5 % 4] * y) * 0.75).sin(),
                    (((i11 as f64) * 0.25) / (1.5 + -0.875_f64 * -0.875_f64)),
                );
            }
        }
        let d = program_14(
            ((b + x) + 0.125).tanh(),
            ((r1[(n5 * n5 + 1) % 4] + r1[n5 % 4]) + 0.125).tanh(),
        )
        .tanh();
    }
    ((d - b) + (-(f))) + d + e + b + f + a + y + x
}

fn program_30_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(); 4];
    let f = ((y + r1[0]) + (a * S::from_f64(-0.875_f64)));
    let mut b = ((x * f) * S::from_f64(0.75)).sin();
    a = a + (((x * x + S::from_f64(0.25)).sqrt() * (r1[1] + x)) * S::from_f64(0.75)).sin();
    r1[1] = (((f - r1[3]) + (r1[2] + S::from_f64(0.625_f64)).sin()) * S::from_f64(0.75)).sin();
    a = a
        * (((r1[1] - S::from_f64(0.125_f64)).tanh() + S::from_f64(-0.375_f64)).sin()
            * S::from_f64(0.75))
        .sin();
    r1[0] = r1[0] + (((x - x) + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh();
    if (y - S::from_f64(-0.375_f64)).tanh().cmplt((a * S::from_f64(0.875_f64)).cos()) {
        return ((b - S::from_f64(-0.125_f64)).tanh() + S::from_f64(-1.125_f64)).sin();
    }
    let mut e = ((a * S::from_f64(0.875_f64)).max(b) * S::from_f64(0.75)).sin();
    a = (((r1[0] + S::from_f64(0.625_f64)).sin() + S::from_f64(-0.875_f64)).sin()
        * S::from_f64(0.75))
    .sin();
    let d = y;
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        r1[0] = r1[0] + ((S::from_f64(n3 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
    }
    let mut n5 = 0_usize;
    'l4: while n5 < 3 {
        n5 += 1;
        'l6: for i7 in (n5..0_usize).step_by(2) {
            let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v
                    * ((S::from_f64(0.875_f64) * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75))
                        .sin()
            });
            'l8: for i9 in i7..5_usize {
                let (a, mut b) = (
                    ((f * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
                    (r1[(n5 + 2) % 4] + S::from_f64(0.875_f64)),
                );
                r1[n5 % 4] = (r1[i7 % 4] + S::from_f64(0.125)).tanh();
                let d = program_0_of(
                    ((r1[3] * r1[(i9 + 3) % 4]) * S::from_f64(0.75)).sin(),
                    ((y - S::from_f64(0.125_f64)) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            }
            'l10: for i11 in 0..=3_usize {
                let (a, mut b) = (
                    ((r1[3] - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
                    (r1[(i7 + 3) % 4] * r1[(n5 * n5 + 1) % 4]),
                );
                let d = ((r1[1] - S::from_f64(-0.375_f64)).tanh() - S::from_f64(-0.125_f64)).tanh();
                let (a, mut b) = (
                    ((r1[n5 % 4] * y) * S::from_f64(0.75)).sin(),
                    ((S::from_f64(i11 as f64) * S::from_f64(0.25))
                        / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64))),
                );
            }
        }
        let d = program_14_of(
            ((b + x) + S::from_f64(0.125)).tanh(),
            ((r1[(n5 * n5 + 1) % 4] + r1[n5 % 4]) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    ((d - b) + (-(f))) + d + e + b + f + a + y + x
}

#[differentiable]
fn program_31(x: f64, y: f64) -> f64 {
    let mut c = ((y - y) * 0.75).sin();
    let mut r1 = [
        ((x * -0.625_f64).cos() * 0.75).sin(),
        ((x * -0.625_f64).max(y) + 0.125).tanh(),
        ((x * x) + 0.125).tanh(),
        ((x + -0.125_f64).sin() + 0.125).tanh(),
        ((y * -0.125_f64) * 0.75).sin(),
    ];
    let (a, mut b) = (((c * -1.125_f64).abs() + 0.125).tanh(), (x - 0.875_f64).tanh());
    b += (((y + 0.125_f64) * 0.375_f64).max(c) * 0.75).sin();
    let mut d = ((b + r1[0]) * 0.75).sin();
    let r2 = [((c + a) * 0.75).sin(); 4];
    let c = ((a / (1.5 + c * c)) * (a / (1.5 + c * c)) + 0.25).sqrt();
    r1[3] = ((r1[1] * (d / (1.5 + a * a))) * 0.75).sin();
    b -= (((y * y) - (c - d)) * 0.75).sin();
    d -= (y * 0.75).sin();
    let g3 = |t: f64| ((-(-0.125_f64)) * 0.875_f64).max(c) * t;
    let b = (g3((d + -1.125_f64).sin()) + g3(y)).sin();
    d = (r2[0] + 0.125).tanh();
    d -= (((y - x) * -0.375_f64).abs() + 0.125).tanh();
    let mut r4 = [((b * r1[0]) * 0.75).sin(); 5];
    let mut r5 = [((d + r4[0]) + 0.125).tanh(); 2];
    'l6: for i7 in 0..=2_usize {
        d -= (((-0.625_f64 + d) + -1.125_f64).sin() * 0.75).sin();
        'l8: for i9 in (i7..4_usize).step_by(2) {
            if (r1[(i9 * i9 + 1) % 5] * r2[(i7 * i7 + 1) % 4]) <= (-(r1[2])) {
                break 'l8;
            }
            if (r2[(i9 * i9 + 1) % 4] - -0.625_f64).tanh() < (-(x)) {
                continue;
            }
        }
        let g10 = |t: f64| ((((i7 as f64) * 0.25) * r5[0]) - (r1[i7 % 5] * -0.875_f64).cos()) * t;
        let e = (g10((x / (1.5 + ((i7 as f64) * 0.25) * ((i7 as f64) * 0.25)))) + g10(a)).sin();
    }
    (-0.625_f64 * -0.625_f64 + 0.25).sqrt() + b + c + d + a + y + x
}

fn program_31_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y - y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        ((x * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ((x * x) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
    ];
    let (a, mut b) = (
        ((c * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        (x - S::from_f64(0.875_f64)).tanh(),
    );
    b = b
        + (((y + S::from_f64(0.125_f64)) * S::from_f64(0.375_f64)).max(c) * S::from_f64(0.75))
            .sin();
    let mut d = ((b + r1[0]) * S::from_f64(0.75)).sin();
    let r2 = [((c + a) * S::from_f64(0.75)).sin(); 4];
    let c = ((a / (S::from_f64(1.5) + c * c)) * (a / (S::from_f64(1.5) + c * c))
        + S::from_f64(0.25))
    .sqrt();
    r1[3] = ((r1[1] * (d / (S::from_f64(1.5) + a * a))) * S::from_f64(0.75)).sin();
    b = b - (((y * y) - (c - d)) * S::from_f64(0.75)).sin();
    d = d - (y * S::from_f64(0.75)).sin();
    let g3 = |t: S| ((-(S::from_f64(-0.125_f64))) * S::from_f64(0.875_f64)).max(c) * t;
    let b = (g3((d + S::from_f64(-1.125_f64)).sin()) + g3(y)).sin();
    d = (r2[0] + S::from_f64(0.125)).tanh();
    d = d - (((y - x) * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    let mut r4 = [((b * r1[0]) * S::from_f64(0.75)).sin(); 5];
    let mut r5 = [((d + r4[0]) + S::from_f64(0.125)).tanh(); 2];
    'l6: for i7 in 0..=2_usize {
        d = d
            - (((S::from_f64(-0.625_f64) + d) + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75))
                .sin();
        'l8: for i9 in (i7..4_usize).step_by(2) {
            if (r1[(i9 * i9 + 1) % 5] * r2[(i7 * i7 + 1) % 4]).cmple((-(r1[2]))) {
                break 'l8;
            }
            if (r2[(i9 * i9 + 1) % 4] - S::from_f64(-0.625_f64)).tanh().cmplt((-(x))) {
                continue;
            }
        }
        let g10 = |t: S| {
            (((S::from_f64(i7 as f64) * S::from_f64(0.25)) * r5[0])
                - (r1[i7 % 5] * S::from_f64(-0.875_f64)).cos())
                * t
        };
        let e = (g10((x
            / (S::from_f64(1.5)
                + (S::from_f64(i7 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i7 as f64) * S::from_f64(0.25)))))
            + g10(a))
        .sin();
    }
    (S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25)).sqrt()
        + b
        + c
        + d
        + a
        + y
        + x
}

#[differentiable]
fn program_32(x: f64, y: f64) -> f64 {
    let mut a = ((y * 0.625_f64).cos() * 0.75).sin();
    let mut r1 = [
        ((y * y) * 0.75).sin(),
        ((y - 0.375_f64).tanh() * 0.75).sin(),
        ((-(x)) * 0.75).sin(),
        ((y * 0.875_f64).cos() * 0.75).sin(),
    ];
    if (a - 0.375_f64).tanh() > x {
        return y;
    }
    if r1[2] < (r1[3] * -0.875_f64) {
        return -0.125_f64;
    }
    r1[0] = (((-(y)) * 0.875_f64).cos() + 0.125).tanh();
    a = (((a * -0.875_f64).max(x) / (1.5 + (r1[1] / (1.5 + y * y)) * (r1[1] / (1.5 + y * y))))
        + 0.125)
        .tanh();
    let b = program_17(
        ((r1[1] - -1.125_f64).tanh() + 0.125).tanh(),
        ((a + -0.375_f64).sin() + 0.125).tanh(),
    )
    .tanh();
    let g2 = |t: f64| ((x * 0.125_f64).max(y) * -0.875_f64).abs() * t;
    let e = (g2((r1[0] / (1.5 + a * a))) + g2(a)).sin();
    'l3: for i4 in (1..1_usize).step_by(2) {
        a *= (((r1[(i4 + 2) % 4] / (1.5 + a * a)) * -0.125_f64).max(0.875_f64) + 0.125).tanh();
        a *= ((-(y / (1.5 + ((i4 as f64) * 0.25) * ((i4 as f64) * 0.25)))) + 0.125).tanh();
        let g5 = |t: f64| ((y * y + 0.25).sqrt() * (-(r1[(i4 * i4 + 1) % 4]))) * t;
        let f = (g5((e * r1[i4 % 4])) + g5((y * b))).sin();
    }
    for v in r1.iter() {
        a = a * ((-(r1[3])) + 0.125).tanh() + *v * ((-(r1[3])) + 0.125).tanh();
    }
    'l6: for i7 in (0..4_usize).step_by(2) {
        if i7 % 2 == 0 {
            a = (((-(x)) * (a * x)) + 0.125).tanh();
            let mut r8 = [((r1[(i7 + 0) % 4] * a) + 0.125).tanh(); 2];
        }
        r1[(i7 + 0) % 4] = ((((i7 as f64) * 0.25) - (-(y))) + 0.125).tanh();
        let g9 = |t: f64| ((t * b) * x) * t;
        let c = (g9(r1[(i7 * i7 + 1) % 4]) + g9((((i7 as f64) * 0.25) * -0.125_f64).cos())).sin();
    }
    ((b * b) * (b * b) + 0.25).sqrt() + e + b + a + y + x
}

fn program_32_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * y) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((-(x)) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
    ];
    if (a - S::from_f64(0.375_f64)).tanh().cmpgt(x) {
        return y;
    }
    if r1[2].cmplt((r1[3] * S::from_f64(-0.875_f64))) {
        return S::from_f64(-0.125_f64);
    }
    r1[0] = (((-(y)) * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh();
    a = (((a * S::from_f64(-0.875_f64)).max(x)
        / (S::from_f64(1.5)
            + (r1[1] / (S::from_f64(1.5) + y * y)) * (r1[1] / (S::from_f64(1.5) + y * y))))
        + S::from_f64(0.125))
    .tanh();
    let b = program_17_of(
        ((r1[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((a + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let g2 = |t: S| ((x * S::from_f64(0.125_f64)).max(y) * S::from_f64(-0.875_f64)).abs() * t;
    let e = (g2((r1[0] / (S::from_f64(1.5) + a * a))) + g2(a)).sin();
    'l3: for i4 in (1..1_usize).step_by(2) {
        a = a
            * (((r1[(i4 + 2) % 4] / (S::from_f64(1.5) + a * a)) * S::from_f64(-0.125_f64))
                .max(S::from_f64(0.875_f64))
                + S::from_f64(0.125))
            .tanh();
        a = a
            * ((-(y
                / (S::from_f64(1.5)
                    + (S::from_f64(i4 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i4 as f64) * S::from_f64(0.25)))))
                + S::from_f64(0.125))
            .tanh();
        let g5 = |t: S| ((y * y + S::from_f64(0.25)).sqrt() * (-(r1[(i4 * i4 + 1) % 4]))) * t;
        let f = (g5((e * r1[i4 % 4])) + g5((y * b))).sin();
    }
    for v in r1.iter() {
        a = a * ((-(r1[3])) + S::from_f64(0.125)).tanh()
            + *v * ((-(r1[3])) + S::from_f64(0.125)).tanh();
    }
    'l6: for i7 in (0..4_usize).step_by(2) {
        if i7 % 2 == 0 {
            a = (((-(x)) * (a * x)) + S::from_f64(0.125)).tanh();
            let mut r8 = [((r1[(i7 + 0) % 4] * a) + S::from_f64(0.125)).tanh(); 2];
        }
        r1[(i7 + 0) % 4] =
            (((S::from_f64(i7 as f64) * S::from_f64(0.25)) - (-(y))) + S::from_f64(0.125)).tanh();
        let g9 = |t: S| ((t * b) * x) * t;
        let c = (g9(r1[(i7 * i7 + 1) % 4])
            + g9(((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64)).cos()))
        .sin();
    }
    ((b * b) * (b * b) + S::from_f64(0.25)).sqrt() + e + b + a + y + x
}

#[differentiable]
fn program_33(x: f64, y: f64) -> f64 {
    let mut c = ((x + y) * 0.75).sin();
    let mut r1 = [((x / (1.5 + c * c)) + 0.125).tanh(); 2];
    let (a, mut b) = (((r1[0] * c) + 0.125).tanh(), r1[1]);
    if (x / (1.5 + r1[1] * r1[1])) < (r1[0] * r1[0] + 0.25).sqrt() {
        let g2 = |t: f64| ((c + a) * 0.375_f64).cos() * t;
        let b = (g2((-(x))) + g2((y - y))).sin();
        c -= ((0.375_f64 - (b - -0.375_f64).tanh()) * 0.75).sin();
        let a: f64 = r1.iter().map(|v| v * ((c + 0.375_f64).sin() + 0.125).tanh()).sum();
    } else {
        'l3: for i4 in 0..2_usize {
            'l5: for i6 in 1..3_usize {
                let mut b = ((-(y)) + 0.125).tanh();
                c -= (((y * y + 0.25).sqrt() * (y * y + 0.25).sqrt() + 0.25).sqrt() * 0.75).sin();
            }
        }
    }
    let g7 = |t: f64| ((r1[1] - 0.125_f64).tanh() + -0.375_f64).sin() * t;
    let c = (g7((-(b))) + g7(r1[1])).sin();
    if (a - a) >= (c * -0.875_f64).cos() {
        return ((r1[0] * b) + x);
    }
    b = (((y / (1.5 + x * x)) - (x + r1[1])) * 0.75).sin();
    let mut n9 = 0_usize;
    'l8: while n9 < 5 {
        n9 += 1;
        if (y * 0.875_f64).abs() >= b {
            let mut d = ((y - 0.625_f64).tanh() * 0.75).sin();
        }
        b += (((((n9 as f64) * 0.25) * -0.125_f64).abs() * 0.875_f64).max(x) * 0.75).sin();
    }
    0.625_f64 + c + b + a + y + x
}

fn program_33_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [((x / (S::from_f64(1.5) + c * c)) + S::from_f64(0.125)).tanh(); 2];
    let (a, mut b) = (((r1[0] * c) + S::from_f64(0.125)).tanh(), r1[1]);
    if (x / (S::from_f64(1.5) + r1[1] * r1[1])).cmplt((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) {
        let g2 = |t: S| ((c + a) * S::from_f64(0.375_f64)).cos() * t;
        let b = (g2((-(x))) + g2((y - y))).sin();
        c = c
            - ((S::from_f64(0.375_f64) - (b - S::from_f64(-0.375_f64)).tanh()) * S::from_f64(0.75))
                .sin();
        let a = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((c + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh()
        });
    } else {
        'l3: for i4 in 0..2_usize {
            'l5: for i6 in 1..3_usize {
                let mut b = ((-(y)) + S::from_f64(0.125)).tanh();
                c = c
                    - (((y * y + S::from_f64(0.25)).sqrt() * (y * y + S::from_f64(0.25)).sqrt()
                        + S::from_f64(0.25))
                    .sqrt()
                        * S::from_f64(0.75))
                    .sin();
            }
        }
    }
    let g7 = |t: S| ((r1[1] - S::from_f64(0.125_f64)).tanh() + S::from_f64(-0.375_f64)).sin() * t;
    let c = (g7((-(b))) + g7(r1[1])).sin();
    if (a - a).cmpge((c * S::from_f64(-0.875_f64)).cos()) {
        return ((r1[0] * b) + x);
    }
    b = (((y / (S::from_f64(1.5) + x * x)) - (x + r1[1])) * S::from_f64(0.75)).sin();
    let mut n9 = 0_usize;
    'l8: while n9 < 5 {
        n9 += 1;
        if (y * S::from_f64(0.875_f64)).abs().cmpge(b) {
            let mut d = ((y - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        }
        b = b
            + ((((S::from_f64(n9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64)).abs()
                * S::from_f64(0.875_f64))
            .max(x)
                * S::from_f64(0.75))
            .sin();
    }
    S::from_f64(0.625_f64) + c + b + a + y + x
}

#[differentiable]
fn program_34(x: f64, y: f64) -> f64 {
    let mut a = ((x * 0.375_f64).cos() * 0.75).sin();
    let mut r1 = [((x * x + 0.25).sqrt() * 0.75).sin(); 3];
    'l2: for i3 in 0..=0_usize {
        let e = (((i3 as f64) * 0.25) - (a * -0.375_f64).abs());
        r1[(i3 * i3 + 1) % 3] =
            (((r1[(i3 * i3 + 1) % 3] + -1.125_f64).sin() - -1.125_f64).tanh() * 0.75).sin();
        let e = program_0(
            ((r1[(i3 * i3 + 1) % 3] + y) * 0.75).sin(),
            ((r1[1] + 0.625_f64).sin() * 0.75).sin(),
        )
        .tanh();
    }
    a += (r1[2] * 0.75).sin();
    'l4: for i5 in (2..2_usize).rev() {
        let mut b = ((r1[(i5 + 0) % 3] + x) + 0.125).tanh();
    }
    'l6: for i7 in 0..2_usize {
        let e =
            ((y * y + 0.25).sqrt() * (((i7 as f64) * 0.25) * 0.125_f64).max(r1[(i7 * i7 + 1) % 3]));
        let mut f = ((y + r1[i7 % 3]) * 0.75).sin();
        let a = ((r1[(i7 + 0) % 3] * r1[0]) * 0.125_f64).cos();
    }
    let mut d = ((-1.125_f64 * -1.125_f64).max(x) + 0.125).tanh();
    let mut a = ((-(r1[1])) + 0.125).tanh();
    a = (r1[0] + 0.125).tanh();
    (r1[2] - (0.375_f64 + a)) + a + d + y + x
}

fn program_34_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(); 3];
    'l2: for i3 in 0..=0_usize {
        let e =
            ((S::from_f64(i3 as f64) * S::from_f64(0.25)) - (a * S::from_f64(-0.375_f64)).abs());
        r1[(i3 * i3 + 1) % 3] = (((r1[(i3 * i3 + 1) % 3] + S::from_f64(-1.125_f64)).sin()
            - S::from_f64(-1.125_f64))
        .tanh()
            * S::from_f64(0.75))
        .sin();
        let e = program_0_of(
            ((r1[(i3 * i3 + 1) % 3] + y) * S::from_f64(0.75)).sin(),
            ((r1[1] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    a = a + (r1[2] * S::from_f64(0.75)).sin();
    'l4: for i5 in (2..2_usize).rev() {
        let mut b = ((r1[(i5 + 0) % 3] + x) + S::from_f64(0.125)).tanh();
    }
    'l6: for i7 in 0..2_usize {
        let e = ((y * y + S::from_f64(0.25)).sqrt()
            * ((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64))
                .max(r1[(i7 * i7 + 1) % 3]));
        let mut f = ((y + r1[i7 % 3]) * S::from_f64(0.75)).sin();
        let a = ((r1[(i7 + 0) % 3] * r1[0]) * S::from_f64(0.125_f64)).cos();
    }
    let mut d =
        ((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)).max(x) + S::from_f64(0.125)).tanh();
    let mut a = ((-(r1[1])) + S::from_f64(0.125)).tanh();
    a = (r1[0] + S::from_f64(0.125)).tanh();
    (r1[2] - (S::from_f64(0.375_f64) + a)) + a + d + y + x
}

#[differentiable]
fn program_35(x: f64, y: f64) -> f64 {
    let mut b = ((y + x) + 0.125).tanh();
    let r1 = [((y * y) * 0.75).sin(); 3];
    if b > (r1[0] - -0.125_f64).tanh() {
        return ((r1[0] * r1[0] + 0.25).sqrt() * -0.875_f64).cos();
    }
    let f = r1[2];
    b *= (((r1[1] * x) * (r1[1] * x)) * 0.75).sin();
    let (a, mut b) = (((y * 0.875_f64).max(y) + 0.125).tanh(), (r1[0] * -0.375_f64).max(r1[1]));
    b = (((a / (1.5 + r1[2] * r1[2])) - 0.375_f64).tanh() + 0.125).tanh();
    b = (((0.375_f64 * b) * 0.375_f64).max(r1[0]) * 0.75).sin();
    b += ((-(f * r1[2])) + 0.125).tanh();
    let (a, mut b) = (((y * -0.375_f64).abs() * 0.75).sin(), (y - r1[0]));
    b = (((r1[1] * 0.125_f64).cos() / (1.5 + (x * -0.125_f64).abs() * (x * -0.125_f64).abs()))
        + 0.125)
        .tanh();
    b *= (((a * a + 0.25).sqrt() + (y + a)) + 0.125).tanh();
    if (x + r1[0]) > (r1[2] - y) {
        let f = program_6(((x * x + 0.25).sqrt() * 0.75).sin(), ((-(f)) + 0.125).tanh()).tanh();
    }
    if (a / (1.5 + r1[0] * r1[0])) <= (-(r1[1])) {
        b *= (-0.125_f64 * 0.75).sin();
        'l2: for i3 in 2..1_usize {
            let b = ((f + 0.875_f64).sin() - (((i3 as f64) * 0.25) + 0.875_f64).sin());
            if i3 % 3 == 0 {
                break;
            }
        }
        b = ((-(a / (1.5 + r1[0] * r1[0]))) * 0.75).sin();
    }
    ((a * r1[1]) + -0.875_f64).sin() + b + a + f + y + x
}

fn program_35_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + x) + S::from_f64(0.125)).tanh();
    let r1 = [((y * y) * S::from_f64(0.75)).sin(); 3];
    if b.cmpgt((r1[0] - S::from_f64(-0.125_f64)).tanh()) {
        return ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(-0.875_f64)).cos();
    }
    let f = r1[2];
    b = b * (((r1[1] * x) * (r1[1] * x)) * S::from_f64(0.75)).sin();
    let (a, mut b) = (
        ((y * S::from_f64(0.875_f64)).max(y) + S::from_f64(0.125)).tanh(),
        (r1[0] * S::from_f64(-0.375_f64)).max(r1[1]),
    );
    b = (((a / (S::from_f64(1.5) + r1[2] * r1[2])) - S::from_f64(0.375_f64)).tanh()
        + S::from_f64(0.125))
    .tanh();
    b = (((S::from_f64(0.375_f64) * b) * S::from_f64(0.375_f64)).max(r1[0]) * S::from_f64(0.75))
        .sin();
    b = b + ((-(f * r1[2])) + S::from_f64(0.125)).tanh();
    let (a, mut b) = (((y * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(), (y - r1[0]));
    b = (((r1[1] * S::from_f64(0.125_f64)).cos()
        / (S::from_f64(1.5)
            + (x * S::from_f64(-0.125_f64)).abs() * (x * S::from_f64(-0.125_f64)).abs()))
        + S::from_f64(0.125))
    .tanh();
    b = b * (((a * a + S::from_f64(0.25)).sqrt() + (y + a)) + S::from_f64(0.125)).tanh();
    if (x + r1[0]).cmpgt((r1[2] - y)) {
        let f = program_6_of(
            ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            ((-(f)) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    if (a / (S::from_f64(1.5) + r1[0] * r1[0])).cmple((-(r1[1]))) {
        b = b * (S::from_f64(-0.125_f64) * S::from_f64(0.75)).sin();
        'l2: for i3 in 2..1_usize {
            let b = ((f + S::from_f64(0.875_f64)).sin()
                - ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(0.875_f64)).sin());
            if i3 % 3 == 0 {
                break;
            }
        }
        b = ((-(a / (S::from_f64(1.5) + r1[0] * r1[0]))) * S::from_f64(0.75)).sin();
    }
    ((a * r1[1]) + S::from_f64(-0.875_f64)).sin() + b + a + f + y + x
}

#[differentiable]
fn program_36(x: f64, y: f64) -> f64 {
    let mut f = ((y + -0.375_f64).sin() * 0.75).sin();
    let r1 = [
        ((x * y) + 0.125).tanh(),
        ((f + -0.625_f64).sin() + 0.125).tanh(),
        ((y + -0.875_f64) * 0.75).sin(),
    ];
    'l2: for i3 in (0..3_usize).rev() {
        let (a, mut b) = (
            ((f * -0.125_f64).max(r1[0]) + 0.125).tanh(),
            (((i3 as f64) * 0.25) + -0.375_f64).sin(),
        );
        if x < (x / (1.5 + x * x)) {
            let b = program_17(
                ((f - r1[i3 % 3]) + 0.125).tanh(),
                ((b - ((i3 as f64) * 0.25)) + 0.125).tanh(),
            )
            .tanh();
        } else {
            let g4 = |t: f64| {
                ((r1[1] - -0.875_f64).tanh() - (((i3 as f64) * 0.25) - r1[(i3 * i3 + 1) % 3])) * t
            };
            let a = (g4((r1[i3 % 3] + y)) + g4((r1[i3 % 3] * r1[i3 % 3] + 0.25).sqrt())).sin();
        }
        'l5: for i6 in 0..5_usize {
            let a: f64 = r1.iter().map(|v| v * ((a + a) + 0.125).tanh()).sum();
        }
    }
    f -= (((x * x + 0.25).sqrt() + (x * r1[1])) * 0.75).sin();
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        let mut c = ((y * -0.625_f64).abs() + 0.125).tanh();
        c = ((x * (c + -1.125_f64).sin()) * 0.75).sin();
        c = (((0.875_f64 * -0.875_f64) - -0.875_f64).tanh() + 0.125).tanh();
    }
    f -= ((-(x)) + 0.125).tanh();
    if (y / (1.5 + r1[1] * r1[1])) <= (f * 0.375_f64).cos() {
        let mut e = ((-(r1[0])) * 0.75).sin();
        e -= (((x * f) + (0.375_f64 * x)) + 0.125).tanh();
        let mut c = ((0.875_f64 + r1[0]) + 0.125).tanh();
    }
    ((x - 0.875_f64).tanh() + (r1[1] * 0.875_f64).cos()) + f + y + x
}

fn program_36_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin();
    let r1 = [
        ((x * y) + S::from_f64(0.125)).tanh(),
        ((f + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in (0..3_usize).rev() {
        let (a, mut b) = (
            ((f * S::from_f64(-0.125_f64)).max(r1[0]) + S::from_f64(0.125)).tanh(),
            ((S::from_f64(i3 as f64) * S::from_f64(0.25)) + S::from_f64(-0.375_f64)).sin(),
        );
        if x.cmplt((x / (S::from_f64(1.5) + x * x))) {
            let b = program_17_of(
                ((f - r1[i3 % 3]) + S::from_f64(0.125)).tanh(),
                ((b - (S::from_f64(i3 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
            )
            .tanh();
        } else {
            let g4 = |t: S| {
                ((r1[1] - S::from_f64(-0.875_f64)).tanh()
                    - ((S::from_f64(i3 as f64) * S::from_f64(0.25)) - r1[(i3 * i3 + 1) % 3]))
                    * t
            };
            let a = (g4((r1[i3 % 3] + y))
                + g4((r1[i3 % 3] * r1[i3 % 3] + S::from_f64(0.25)).sqrt()))
            .sin();
        }
        'l5: for i6 in 0..5_usize {
            let a = r1
                .iter()
                .fold(S::from_f64(-0.0), |s, v| s + *v * ((a + a) + S::from_f64(0.125)).tanh());
        }
    }
    f = f - (((x * x + S::from_f64(0.25)).sqrt() + (x * r1[1])) * S::from_f64(0.75)).sin();
    let mut n8 = 0_usize;
    'l7: while n8 < 3 {
        n8 += 1;
        let mut c = ((y * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh();
        c = ((x * (c + S::from_f64(-1.125_f64)).sin()) * S::from_f64(0.75)).sin();
        c = (((S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)) - S::from_f64(-0.875_f64)).tanh()
            + S::from_f64(0.125))
        .tanh();
    }
    f = f - ((-(x)) + S::from_f64(0.125)).tanh();
    if (y / (S::from_f64(1.5) + r1[1] * r1[1])).cmple((f * S::from_f64(0.375_f64)).cos()) {
        let mut e = ((-(r1[0])) * S::from_f64(0.75)).sin();
        e = e - (((x * f) + (S::from_f64(0.375_f64) * x)) + S::from_f64(0.125)).tanh();
        let mut c = ((S::from_f64(0.875_f64) + r1[0]) + S::from_f64(0.125)).tanh();
    }
    ((x - S::from_f64(0.875_f64)).tanh() + (r1[1] * S::from_f64(0.875_f64)).cos()) + f + y + x
}

#[differentiable]
fn program_37(x: f64, y: f64) -> f64 {
    let mut b = ((x - x) * 0.75).sin();
    let mut r1 =
        [((y - y) * 0.75).sin(), ((b * y) * 0.75).sin(), ((y * 0.625_f64).cos() + 0.125).tanh()];
    'l2: for i3 in 1..=0_usize {
        b = (((r1[1] - y) + y) + 0.125).tanh();
    }
    if (x + x) < (b - -0.375_f64) {
        'l4: for i5 in (0..5_usize).rev() {
            'l6: for i7 in 1..=2_usize {
                b += (((r1[(i5 * i5 + 1) % 3] * r1[(i5 * i5 + 1) % 3] + 0.25).sqrt() * 0.375_f64)
                    .cos()
                    + 0.125)
                    .tanh();
                let d = (r1[i7 % 3] * 0.375_f64).max(y);
            }
            let mut c = ((y * x) + 0.125).tanh();
            let mut n9 = 0_usize;
            'l8: while n9 < 4 {
                n9 += 1;
                b -= (((y * -0.625_f64).max(r1[(n9 * n9 + 1) % 3])
                    + (r1[(n9 + 0) % 3] * r1[(n9 + 0) % 3] + 0.25).sqrt())
                    + 0.125)
                    .tanh();
                b *= (((((n9 as f64) * 0.25) * ((n9 as f64) * 0.25) + 0.25).sqrt()
                    + (((n9 as f64) * 0.25) + -0.375_f64).sin())
                    + 0.125)
                    .tanh();
            }
        }
        b -= (((r1[0] - r1[1]) * (-(x))) * 0.75).sin();
    }
    b += (((y + r1[0]) * (r1[2] * 0.875_f64).cos()) * 0.75).sin();
    let a = y;
    ((a - y) + -1.125_f64).sin() + a + b + y + x
}

fn program_37_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x - x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y - y) * S::from_f64(0.75)).sin(),
        ((b * y) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    'l2: for i3 in 1..=0_usize {
        b = (((r1[1] - y) + y) + S::from_f64(0.125)).tanh();
    }
    if (x + x).cmplt((b - S::from_f64(-0.375_f64))) {
        'l4: for i5 in (0..5_usize).rev() {
            'l6: for i7 in 1..=2_usize {
                b = b
                    + (((r1[(i5 * i5 + 1) % 3] * r1[(i5 * i5 + 1) % 3] + S::from_f64(0.25))
                        .sqrt()
                        * S::from_f64(0.375_f64))
                    .cos()
                        + S::from_f64(0.125))
                    .tanh();
                let d = (r1[i7 % 3] * S::from_f64(0.375_f64)).max(y);
            }
            let mut c = ((y * x) + S::from_f64(0.125)).tanh();
            let mut n9 = 0_usize;
            'l8: while n9 < 4 {
                n9 += 1;
                b = b
                    - (((y * S::from_f64(-0.625_f64)).max(r1[(n9 * n9 + 1) % 3])
                        + (r1[(n9 + 0) % 3] * r1[(n9 + 0) % 3] + S::from_f64(0.25)).sqrt())
                        + S::from_f64(0.125))
                    .tanh();
                b = b
                    * ((((S::from_f64(n9 as f64) * S::from_f64(0.25))
                        * (S::from_f64(n9 as f64) * S::from_f64(0.25))
                        + S::from_f64(0.25))
                    .sqrt()
                        + ((S::from_f64(n9 as f64) * S::from_f64(0.25))
                            + S::from_f64(-0.375_f64))
                        .sin())
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
        b = b - (((r1[0] - r1[1]) * (-(x))) * S::from_f64(0.75)).sin();
    }
    b = b + (((y + r1[0]) * (r1[2] * S::from_f64(0.875_f64)).cos()) * S::from_f64(0.75)).sin();
    let a = y;
    ((a - y) + S::from_f64(-1.125_f64)).sin() + a + b + y + x
}

#[differentiable]
fn program_38(x: f64, y: f64) -> f64 {
    let mut d = ((x - -1.125_f64).tanh() + 0.125).tanh();
    let r1 = [(d * 0.75).sin(); 2];
    let (a, mut b) = (((y - -1.125_f64).tanh() + 0.125).tanh(), (d * y));
    let c = program_36((-0.375_f64 + 0.125).tanh(), ((b * 0.125_f64).max(b) + 0.125).tanh()).tanh();
    let (a, mut b) = (((-0.875_f64 - r1[0]) * 0.75).sin(), (c * c + 0.25).sqrt());
    b += (((a * -0.625_f64).cos() * 0.125_f64).abs() * 0.75).sin();
    b *= (((b - d) * (b - d) + 0.25).sqrt() + 0.125).tanh();
    let d = ((0.625_f64 / (1.5 + y * y)) * (r1[0] * 0.375_f64).cos());
    b += (((-(y)) * (d * 0.125_f64).max(d)) * 0.75).sin();
    'l2: for i3 in (2..1_usize).step_by(2) {
        'l4: for i5 in i3..0_usize {
            b *= (((r1[i3 % 2] - x) * -0.875_f64).max(r1[i5 % 2]) + 0.125).tanh();
        }
        b = (((r1[(i3 * i3 + 1) % 2] * y) - -0.375_f64).tanh() + 0.125).tanh();
    }
    let b = (-(r1[1]));
    let d = program_36(((d * c) + 0.125).tanh(), ((d + c) + 0.125).tanh()).tanh();
    let mut c = ((-0.875_f64 * x) + 0.125).tanh();
    ((r1[0] * 0.625_f64).max(r1[0]) / (1.5 + r1[0] * r1[0])) + c + d + b + a + y + x
}

fn program_38_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let r1 = [(d * S::from_f64(0.75)).sin(); 2];
    let (a, mut b) = (((y - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(), (d * y));
    let c = program_36_of(
        (S::from_f64(-0.375_f64) + S::from_f64(0.125)).tanh(),
        ((b * S::from_f64(0.125_f64)).max(b) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let (a, mut b) = (
        ((S::from_f64(-0.875_f64) - r1[0]) * S::from_f64(0.75)).sin(),
        (c * c + S::from_f64(0.25)).sqrt(),
    );
    b = b
        + (((a * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.125_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    b = b * (((b - d) * (b - d) + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let d = ((S::from_f64(0.625_f64) / (S::from_f64(1.5) + y * y))
        * (r1[0] * S::from_f64(0.375_f64)).cos());
    b = b + (((-(y)) * (d * S::from_f64(0.125_f64)).max(d)) * S::from_f64(0.75)).sin();
    'l2: for i3 in (2..1_usize).step_by(2) {
        'l4: for i5 in i3..0_usize {
            b = b
                * (((r1[i3 % 2] - x) * S::from_f64(-0.875_f64)).max(r1[i5 % 2])
                    + S::from_f64(0.125))
                .tanh();
        }
        b = (((r1[(i3 * i3 + 1) % 2] * y) - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125))
            .tanh();
    }
    let b = (-(r1[1]));
    let d =
        program_36_of(((d * c) + S::from_f64(0.125)).tanh(), ((d + c) + S::from_f64(0.125)).tanh())
            .tanh();
    let mut c = ((S::from_f64(-0.875_f64) * x) + S::from_f64(0.125)).tanh();
    ((r1[0] * S::from_f64(0.625_f64)).max(r1[0]) / (S::from_f64(1.5) + r1[0] * r1[0]))
        + c
        + d
        + b
        + a
        + y
        + x
}

#[differentiable]
fn program_39(x: f64, y: f64) -> f64 {
    let mut b = ((y + y) + 0.125).tanh();
    let r1 = [((b + x) * 0.75).sin(); 4];
    b *= ((-((y + 0.625_f64).sin())) + 0.125).tanh();
    let c = if (b * 0.625_f64).abs() > (b + x) {
        ((x * x + 0.25).sqrt() - (x * 0.875_f64).cos())
    } else {
        ((y * y) * (x * y))
    };
    let g2 = |t: f64| ((b * b + 0.25).sqrt() * (b * b + 0.25).sqrt() + 0.25).sqrt() * t;
    let e = (g2((x + c)) + g2((y - -0.625_f64).tanh())).sin();
    let mut r3 = [((-(b)) * 0.75).sin(); 2];
    let a = if (y * y + 0.25).sqrt() <= (e * 0.375_f64).max(r3[1]) {
        ((b - -1.125_f64).tanh() * -0.875_f64).cos()
    } else {
        ((c - 0.875_f64).tanh() - (y - -1.125_f64))
    };
    'l4: for i5 in (1..3_usize).rev() {
        if (x * c) < (r1[i5 % 4] - -1.125_f64).tanh() {
            break 'l4;
        }
    }
    let mut r6 = [
        ((e * r3[0]) * 0.75).sin(),
        ((a * e) * 0.75).sin(),
        (c * 0.75).sin(),
        ((e * 0.875_f64).max(0.375_f64) * 0.75).sin(),
        ((r3[0] - r3[0]) * 0.75).sin(),
    ];
    if (y / (1.5 + a * a)) < (e * 0.875_f64).max(r1[3]) {
        r6[2] = (((-1.125_f64 * r6[3]) * -0.875_f64).abs() * 0.75).sin();
        b += (((-(r1[1])) * -0.125_f64).cos() * 0.75).sin();
    }
    b *= (((x * r6[2]) / (1.5 + (e * -0.875_f64).max(a) * (e * -0.875_f64).max(a))) * 0.75).sin();
    r3[0] *= ((x * 0.875_f64).max(b) * 0.75).sin();
    let g7 = |t: f64| (b * b + 0.25).sqrt() * t;
    let e = (g7((-1.125_f64 * a)) + g7((a * a))).sin();
    ((e / (1.5 + y * y)) - (a * 0.875_f64).abs()) + e + a + c + b + y + x
}

fn program_39_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + y) + S::from_f64(0.125)).tanh();
    let r1 = [((b + x) * S::from_f64(0.75)).sin(); 4];
    b = b * ((-((y + S::from_f64(0.625_f64)).sin())) + S::from_f64(0.125)).tanh();
    let c = if (b * S::from_f64(0.625_f64)).abs().cmpgt((b + x)) {
        ((x * x + S::from_f64(0.25)).sqrt() - (x * S::from_f64(0.875_f64)).cos())
    } else {
        ((y * y) * (x * y))
    };
    let g2 = |t: S| {
        ((b * b + S::from_f64(0.25)).sqrt() * (b * b + S::from_f64(0.25)).sqrt()
            + S::from_f64(0.25))
        .sqrt()
            * t
    };
    let e = (g2((x + c)) + g2((y - S::from_f64(-0.625_f64)).tanh())).sin();
    let mut r3 = [((-(b)) * S::from_f64(0.75)).sin(); 2];
    let a = if (y * y + S::from_f64(0.25)).sqrt().cmple((e * S::from_f64(0.375_f64)).max(r3[1])) {
        ((b - S::from_f64(-1.125_f64)).tanh() * S::from_f64(-0.875_f64)).cos()
    } else {
        ((c - S::from_f64(0.875_f64)).tanh() - (y - S::from_f64(-1.125_f64)))
    };
    'l4: for i5 in (1..3_usize).rev() {
        if (x * c).cmplt((r1[i5 % 4] - S::from_f64(-1.125_f64)).tanh()) {
            break 'l4;
        }
    }
    let mut r6 = [
        ((e * r3[0]) * S::from_f64(0.75)).sin(),
        ((a * e) * S::from_f64(0.75)).sin(),
        (c * S::from_f64(0.75)).sin(),
        ((e * S::from_f64(0.875_f64)).max(S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(),
        ((r3[0] - r3[0]) * S::from_f64(0.75)).sin(),
    ];
    if (y / (S::from_f64(1.5) + a * a)).cmplt((e * S::from_f64(0.875_f64)).max(r1[3])) {
        r6[2] = (((S::from_f64(-1.125_f64) * r6[3]) * S::from_f64(-0.875_f64)).abs()
            * S::from_f64(0.75))
        .sin();
        b = b + (((-(r1[1])) * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin();
    }
    b = b
        * (((x * r6[2])
            / (S::from_f64(1.5)
                + (e * S::from_f64(-0.875_f64)).max(a) * (e * S::from_f64(-0.875_f64)).max(a)))
            * S::from_f64(0.75))
        .sin();
    r3[0] = r3[0] * ((x * S::from_f64(0.875_f64)).max(b) * S::from_f64(0.75)).sin();
    let g7 = |t: S| (b * b + S::from_f64(0.25)).sqrt() * t;
    let e = (g7((S::from_f64(-1.125_f64) * a)) + g7((a * a))).sin();
    ((e / (S::from_f64(1.5) + y * y)) - (a * S::from_f64(0.875_f64)).abs()) + e + a + c + b + y + x
}

#[differentiable]
fn program_40(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.875_f64).cos() * 0.75).sin();
    let mut r1 = [((c / (1.5 + y * y)) * 0.75).sin(), (y * 0.75).sin()];
    r1[0] = (((r1[0] * r1[0] + 0.25).sqrt() * 0.125_f64).max(x) * 0.75).sin();
    if (c + 0.625_f64).sin() > (r1[0] * -0.625_f64).cos() {
        let e = ((y / (1.5 + y * y)) + 0.625_f64).sin();
        'l2: for i3 in (2..2_usize).rev() {
            let f =
                if (r1[(i3 * i3 + 1) % 2] + x) <= c { (-(r1[0])) } else { (c * -0.875_f64).cos() };
            'l4: for i5 in (i3..5_usize).step_by(2) {
                r1[i5 % 2] -= (((y * 0.875_f64).abs() * (0.375_f64 + y)) + 0.125).tanh();
            }
            'l6: for i7 in (0..2_usize).rev() {
                r1[(i7 * i7 + 1) % 2] -= ((-(r1[0])) + 0.125).tanh();
                let c = program_5(
                    ((f * -0.875_f64).cos() * 0.75).sin(),
                    ((r1[i7 % 2] - f) + 0.125).tanh(),
                )
                .tanh();
            }
        }
        let mut n9 = 0_usize;
        'l8: while n9 < 3 {
            n9 += 1;
            'l10: for i11 in n9..5_usize {
                let b = program_14(((c + -0.375_f64).sin() + 0.125).tanh(), ((y * c) * 0.75).sin())
                    .tanh();
                r1[0] += ((y * (r1[n9 % 2] - -0.875_f64).tanh()) * 0.75).sin();
                r1[1] = ((-(-(r1[(i11 + 1) % 2]))) + 0.125).tanh();
            }
        }
    }
    ((x * 0.875_f64).max(0.375_f64) + c) + c + y + x
}

fn program_40_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((c / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
        (y * S::from_f64(0.75)).sin(),
    ];
    r1[0] = (((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() * S::from_f64(0.125_f64)).max(x)
        * S::from_f64(0.75))
    .sin();
    if (c + S::from_f64(0.625_f64)).sin().cmpgt((r1[0] * S::from_f64(-0.625_f64)).cos()) {
        let e = ((y / (S::from_f64(1.5) + y * y)) + S::from_f64(0.625_f64)).sin();
        'l2: for i3 in (2..2_usize).rev() {
            let f = if (r1[(i3 * i3 + 1) % 2] + x).cmple(c) {
                (-(r1[0]))
            } else {
                (c * S::from_f64(-0.875_f64)).cos()
            };
            'l4: for i5 in (i3..5_usize).step_by(2) {
                r1[i5 % 2] = r1[i5 % 2]
                    - (((y * S::from_f64(0.875_f64)).abs() * (S::from_f64(0.375_f64) + y))
                        + S::from_f64(0.125))
                    .tanh();
            }
            'l6: for i7 in (0..2_usize).rev() {
                r1[(i7 * i7 + 1) % 2] =
                    r1[(i7 * i7 + 1) % 2] - ((-(r1[0])) + S::from_f64(0.125)).tanh();
                let c = program_5_of(
                    ((f * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
                    ((r1[i7 % 2] - f) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            }
        }
        let mut n9 = 0_usize;
        'l8: while n9 < 3 {
            n9 += 1;
            'l10: for i11 in n9..5_usize {
                let b = program_14_of(
                    ((c + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
                    ((y * c) * S::from_f64(0.75)).sin(),
                )
                .tanh();
                r1[0] = r1[0]
                    + ((y * (r1[n9 % 2] - S::from_f64(-0.875_f64)).tanh()) * S::from_f64(0.75))
                        .sin();
                r1[1] = ((-(-(r1[(i11 + 1) % 2]))) + S::from_f64(0.125)).tanh();
            }
        }
    }
    ((x * S::from_f64(0.875_f64)).max(S::from_f64(0.375_f64)) + c) + c + y + x
}

#[differentiable]
fn program_41(x: f64, y: f64) -> f64 {
    let mut a = (x * 0.75).sin();
    let mut r1 = [((x * x + 0.25).sqrt() + 0.125).tanh(); 5];
    'l2: for i3 in (1..4_usize).rev() {
        let b = (r1[2] * -0.375_f64).cos();
        'l4: for i5 in (2..2_usize).rev() {
            let g6 = |t: f64| r1[(i3 * i3 + 1) % 5] * t;
            let b = (g6(a) + g6((y * -0.375_f64).abs())).sin();
            let d = program_0(
                ((x * -0.625_f64).abs() * 0.75).sin(),
                ((r1[0] - r1[(i3 * i3 + 1) % 5]) * 0.75).sin(),
            )
            .tanh();
            a = (((d * ((i3 as f64) * 0.25)) * -0.875_f64).cos() * 0.75).sin();
        }
        for v in r1.iter() {
            a = a * ((r1[(i3 * i3 + 1) % 5] * 0.375_f64).abs() + 0.125).tanh()
                + *v * ((r1[(i3 * i3 + 1) % 5] * 0.375_f64).abs() + 0.125).tanh();
        }
    }
    r1[1] -= (((r1[0] * r1[2]) * (a + a)) + 0.125).tanh();
    if (r1[1] * -0.125_f64).max(r1[2]) <= (r1[1] - 0.625_f64) {
        a *= ((y * 0.375_f64).abs() + 0.125).tanh();
        let e = program_9(((y + a) + 0.125).tanh(), ((-(a)) + 0.125).tanh()).tanh();
        let (a, mut b) = (((e + r1[2]) * 0.75).sin(), (r1[2] * r1[2] + 0.25).sqrt());
    }
    'l7: for i8 in 2..4_usize {
        a *= (((x + r1[(i8 + 4) % 5]) - -0.375_f64).tanh() + 0.125).tanh();
    }
    ((0.125_f64 * 0.125_f64 + 0.25).sqrt() * (r1[3] * x)) + a + y + x
}

fn program_41_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = (x * S::from_f64(0.75)).sin();
    let mut r1 = [((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 5];
    'l2: for i3 in (1..4_usize).rev() {
        let b = (r1[2] * S::from_f64(-0.375_f64)).cos();
        'l4: for i5 in (2..2_usize).rev() {
            let g6 = |t: S| r1[(i3 * i3 + 1) % 5] * t;
            let b = (g6(a) + g6((y * S::from_f64(-0.375_f64)).abs())).sin();
            let d = program_0_of(
                ((x * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
                ((r1[0] - r1[(i3 * i3 + 1) % 5]) * S::from_f64(0.75)).sin(),
            )
            .tanh();
            a = (((d * (S::from_f64(i3 as f64) * S::from_f64(0.25))) * S::from_f64(-0.875_f64))
                .cos()
                * S::from_f64(0.75))
            .sin();
        }
        for v in r1.iter() {
            a = a
                * ((r1[(i3 * i3 + 1) % 5] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125))
                    .tanh()
                + *v * ((r1[(i3 * i3 + 1) % 5] * S::from_f64(0.375_f64)).abs()
                    + S::from_f64(0.125))
                .tanh();
        }
    }
    r1[1] = r1[1] - (((r1[0] * r1[2]) * (a + a)) + S::from_f64(0.125)).tanh();
    if (r1[1] * S::from_f64(-0.125_f64)).max(r1[2]).cmple((r1[1] - S::from_f64(0.625_f64))) {
        a = a * ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh();
        let e = program_9_of(
            ((y + a) + S::from_f64(0.125)).tanh(),
            ((-(a)) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let (a, mut b) =
            (((e + r1[2]) * S::from_f64(0.75)).sin(), (r1[2] * r1[2] + S::from_f64(0.25)).sqrt());
    }
    'l7: for i8 in 2..4_usize {
        a = a
            * (((x + r1[(i8 + 4) % 5]) - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125))
                .tanh();
    }
    ((S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt() * (r1[3] * x))
        + a
        + y
        + x
}

#[differentiable]
fn program_42(x: f64, y: f64) -> f64 {
    let mut c = (x * 0.75).sin();
    let mut r1 = [((c * c) * 0.75).sin(); 3];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        for v in r1.iter() {
            c = c * (r1[0] + 0.125).tanh() + *v * (r1[0] + 0.125).tanh();
        }
        let (a, mut b) = (((r1[(n3 + 1) % 3] * -0.875_f64).max(c) + 0.125).tanh(), (y + x));
        let (a, mut b) = (((a * a) + 0.125).tanh(), (a * 0.875_f64));
    }
    let d = if (r1[2] - -0.375_f64).tanh() < (-0.625_f64 * c) {
        ((y * y + 0.25).sqrt() * (x - c))
    } else {
        ((y * x) * (c - x))
    };
    'l4: for i5 in 1..=3_usize {
        let d = if (0.625_f64 * r1[(i5 + 1) % 3]) > (y * -1.125_f64).abs() {
            (r1[i5 % 3] * 0.875_f64).abs()
        } else {
            ((r1[1] * 0.875_f64).cos() * (x * x))
        };
    }
    c -= (-0.875_f64 * 0.75).sin();
    c -= (((c * y) - -0.875_f64).tanh() * 0.75).sin();
    let mut e = ((d - 0.125_f64) + 0.125).tanh();
    e = (((r1[1] * d) - r1[2]) + 0.125).tanh();
    let b = program_37(
        ((c / (1.5 + r1[2] * r1[2])) + 0.125).tanh(),
        ((r1[1] * 0.375_f64).abs() * 0.75).sin(),
    )
    .tanh();
    let f = if (e * 0.125_f64).abs() <= (e * -0.625_f64).cos() {
        d
    } else {
        ((r1[2] - 0.125_f64).tanh() * (x + -0.625_f64).sin())
    };
    c = (((-(c)) * (b * -0.375_f64).abs()) * 0.75).sin();
    ((r1[1] + x) / (1.5 + -0.625_f64 * -0.625_f64)) + f + b + e + d + c + y + x
}

fn program_42_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (x * S::from_f64(0.75)).sin();
    let mut r1 = [((c * c) * S::from_f64(0.75)).sin(); 3];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        for v in r1.iter() {
            c = c * (r1[0] + S::from_f64(0.125)).tanh() + *v * (r1[0] + S::from_f64(0.125)).tanh();
        }
        let (a, mut b) = (
            ((r1[(n3 + 1) % 3] * S::from_f64(-0.875_f64)).max(c) + S::from_f64(0.125)).tanh(),
            (y + x),
        );
        let (a, mut b) = (((a * a) + S::from_f64(0.125)).tanh(), (a * S::from_f64(0.875_f64)));
    }
    let d = if (r1[2] - S::from_f64(-0.375_f64)).tanh().cmplt((S::from_f64(-0.625_f64) * c)) {
        ((y * y + S::from_f64(0.25)).sqrt() * (x - c))
    } else {
        ((y * x) * (c - x))
    };
    'l4: for i5 in 1..=3_usize {
        let d = if (S::from_f64(0.625_f64) * r1[(i5 + 1) % 3])
            .cmpgt((y * S::from_f64(-1.125_f64)).abs())
        {
            (r1[i5 % 3] * S::from_f64(0.875_f64)).abs()
        } else {
            ((r1[1] * S::from_f64(0.875_f64)).cos() * (x * x))
        };
    }
    c = c - (S::from_f64(-0.875_f64) * S::from_f64(0.75)).sin();
    c = c - (((c * y) - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut e = ((d - S::from_f64(0.125_f64)) + S::from_f64(0.125)).tanh();
    e = (((r1[1] * d) - r1[2]) + S::from_f64(0.125)).tanh();
    let b = program_37_of(
        ((c / (S::from_f64(1.5) + r1[2] * r1[2])) + S::from_f64(0.125)).tanh(),
        ((r1[1] * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let f = if (e * S::from_f64(0.125_f64)).abs().cmple((e * S::from_f64(-0.625_f64)).cos()) {
        d
    } else {
        ((r1[2] - S::from_f64(0.125_f64)).tanh() * (x + S::from_f64(-0.625_f64)).sin())
    };
    c = (((-(c)) * (b * S::from_f64(-0.375_f64)).abs()) * S::from_f64(0.75)).sin();
    ((r1[1] + x) / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64)))
        + f
        + b
        + e
        + d
        + c
        + y
        + x
}

#[differentiable]
fn program_43(x: f64, y: f64) -> f64 {
    let mut a = ((y + x) * 0.75).sin();
    let mut r1 = [(-0.125_f64 * 0.75).sin(), ((a * a + 0.25).sqrt() * 0.75).sin()];
    a = ((x + (a + -0.625_f64)) + 0.125).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;
        if n3 % 3 == 0 {
            break 'l2;
        }
        'l4: for i5 in n3..0_usize {
            if (0.375_f64 * -1.125_f64).cos() <= (-(y)) {
                break 'l2;
            }
        }
        if (y * r1[(n3 + 1) % 2]) > (r1[n3 % 2] * 0.125_f64).abs() {
            if (y * -0.375_f64).cos() >= (((n3 as f64) * 0.25) * r1[1]) {
                continue;
            }
            'l6: for i7 in (2..0_usize).rev() {
                let b = (a + (y * -1.125_f64).abs());
                let f = ((r1[1] + 0.125_f64).sin() * (r1[(n3 + 1) % 2] + y));
            }
        }
    }
    let c = x;
    let d = if (a * r1[0]) <= (r1[0] + y) {
        ((r1[1] + y) + (c - 0.625_f64).tanh())
    } else {
        (r1[0] + r1[1])
    };
    for v in r1.iter() {
        a = a * ((r1[1] * -0.375_f64).max(r1[0]) * 0.75).sin()
            + *v * ((r1[1] * -0.375_f64).max(r1[0]) * 0.75).sin();
    }
    a = (((0.875_f64 * -0.375_f64).abs() - (0.875_f64 + a)) + 0.125).tanh();
    (-(x + d)) + d + c + a + y + x
}

fn program_43_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y + x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        (S::from_f64(-0.125_f64) * S::from_f64(0.75)).sin(),
        ((a * a + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    ];
    a = ((x + (a + S::from_f64(-0.625_f64))) + S::from_f64(0.125)).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;
        if n3 % 3 == 0 {
            break 'l2;
        }
        'l4: for i5 in n3..0_usize {
            if (S::from_f64(0.375_f64) * S::from_f64(-1.125_f64)).cos().cmple((-(y))) {
                break 'l2;
            }
        }
        if (y * r1[(n3 + 1) % 2]).cmpgt((r1[n3 % 2] * S::from_f64(0.125_f64)).abs()) {
            if (y * S::from_f64(-0.375_f64))
                .cos()
                .cmpge(((S::from_f64(n3 as f64) * S::from_f64(0.25)) * r1[1]))
            {
                continue;
            }
            'l6: for i7 in (2..0_usize).rev() {
                let b = (a + (y * S::from_f64(-1.125_f64)).abs());
                let f = ((r1[1] + S::from_f64(0.125_f64)).sin() * (r1[(n3 + 1) % 2] + y));
            }
        }
    }
    let c = x;
    let d = if (a * r1[0]).cmple((r1[0] + y)) {
        ((r1[1] + y) + (c - S::from_f64(0.625_f64)).tanh())
    } else {
        (r1[0] + r1[1])
    };
    for v in r1.iter() {
        a = a * ((r1[1] * S::from_f64(-0.375_f64)).max(r1[0]) * S::from_f64(0.75)).sin()
            + *v * ((r1[1] * S::from_f64(-0.375_f64)).max(r1[0]) * S::from_f64(0.75)).sin();
    }
    a = (((S::from_f64(0.875_f64) * S::from_f64(-0.375_f64)).abs() - (S::from_f64(0.875_f64) + a))
        + S::from_f64(0.125))
    .tanh();
    (-(x + d)) + d + c + a + y + x
}

#[differentiable]
fn program_44(x: f64, y: f64) -> f64 {
    let mut b = ((y + -0.625_f64).sin() * 0.75).sin();
    let mut r1 = [
        ((y * -0.125_f64).cos() + 0.125).tanh(),
        ((x * y) * 0.75).sin(),
        ((y - 0.125_f64).tanh() + 0.125).tanh(),
        ((b * -0.375_f64) + 0.125).tanh(),
        ((y + -0.625_f64).sin() * 0.75).sin(),
    ];
    r1[3] -= (((x * -0.125_f64).abs() / (1.5 + x * x)) + 0.125).tanh();
    let f = if (r1[1] * r1[1] + 0.25).sqrt() > (y * b) {
        ((r1[3] * r1[4]) + (y + r1[4]))
    } else {
        ((b * 0.625_f64).max(y) * (b * x))
    };
    r1[3] = (((f * b) + -0.375_f64).sin() + 0.125).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        b += ((-((x * -0.875_f64).abs())) + 0.125).tanh();
    }
    if (b * b + 0.25).sqrt() > (r1[0] + r1[2]) {
        let a = program_35(((f * b) * 0.75).sin(), (f * 0.75).sin()).tanh();
    }
    if (x * 0.875_f64).cos() < (b / (1.5 + b * b)) {
        let e: f64 = r1.iter().map(|v| v * ((r1[3] * r1[3] + 0.25).sqrt() + 0.125).tanh()).sum();
        b *= (((y + -0.125_f64).sin() * r1[2]) * 0.75).sin();
    } else {
        let a: f64 = r1.iter().map(|v| v * ((r1[4] * 0.375_f64) + 0.125).tanh()).sum();
        let f = if (f * -0.625_f64).abs() <= (b + r1[1]) {
            ((r1[1] * r1[0]) + (r1[2] + -1.125_f64))
        } else {
            ((f * r1[3]) * (-(x)))
        };
        if (r1[3] + -0.375_f64).sin() <= (r1[0] * r1[0] + 0.25).sqrt() {
            r1[3] -= (((f + 0.875_f64).sin() - -1.125_f64).tanh() + 0.125).tanh();
            b -= (((r1[1] * b) / (1.5 + (y * r1[3]) * (y * r1[3]))) + 0.125).tanh();
            r1[1] = ((y - (f * x)) + 0.125).tanh();
        }
    }
    (-(x * r1[2])) + f + b + y + x
}

fn program_44_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((x * y) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((b * S::from_f64(-0.375_f64)) + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    r1[3] = r1[3]
        - (((x * S::from_f64(-0.125_f64)).abs() / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125))
            .tanh();
    let f = if (r1[1] * r1[1] + S::from_f64(0.25)).sqrt().cmpgt((y * b)) {
        ((r1[3] * r1[4]) + (y + r1[4]))
    } else {
        ((b * S::from_f64(0.625_f64)).max(y) * (b * x))
    };
    r1[3] = (((f * b) + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        b = b + ((-((x * S::from_f64(-0.875_f64)).abs())) + S::from_f64(0.125)).tanh();
    }
    if (b * b + S::from_f64(0.25)).sqrt().cmpgt((r1[0] + r1[2])) {
        let a = program_35_of(((f * b) * S::from_f64(0.75)).sin(), (f * S::from_f64(0.75)).sin())
            .tanh();
    }
    if (x * S::from_f64(0.875_f64)).cos().cmplt((b / (S::from_f64(1.5) + b * b))) {
        let e = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh()
        });
        b = b * (((y + S::from_f64(-0.125_f64)).sin() * r1[2]) * S::from_f64(0.75)).sin();
    } else {
        let a = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((r1[4] * S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh()
        });
        let f = if (f * S::from_f64(-0.625_f64)).abs().cmple((b + r1[1])) {
            ((r1[1] * r1[0]) + (r1[2] + S::from_f64(-1.125_f64)))
        } else {
            ((f * r1[3]) * (-(x)))
        };
        if (r1[3] + S::from_f64(-0.375_f64)).sin().cmple((r1[0] * r1[0] + S::from_f64(0.25)).sqrt())
        {
            r1[3] = r1[3]
                - (((f + S::from_f64(0.875_f64)).sin() - S::from_f64(-1.125_f64)).tanh()
                    + S::from_f64(0.125))
                .tanh();
            b = b
                - (((r1[1] * b) / (S::from_f64(1.5) + (y * r1[3]) * (y * r1[3])))
                    + S::from_f64(0.125))
                .tanh();
            r1[1] = ((y - (f * x)) + S::from_f64(0.125)).tanh();
        }
    }
    (-(x * r1[2])) + f + b + y + x
}

#[differentiable]
fn program_45(x: f64, y: f64) -> f64 {
    let mut d = ((x * 0.125_f64).abs() + 0.125).tanh();
    let mut r1 = [
        (x * 0.75).sin(),
        ((y + 0.375_f64).sin() * 0.75).sin(),
        ((x - 0.625_f64).tanh() * 0.75).sin(),
        ((x * y) * 0.75).sin(),
        ((x + 0.875_f64).sin() * 0.75).sin(),
    ];
    if (r1[1] - 0.375_f64).tanh() < (r1[4] + 0.625_f64).sin() {
        'l2: for i3 in 1..0_usize {
            if i3 % 4 == 3 {
                let b = program_0(((y * r1[2]) * 0.75).sin(), (r1[4] * 0.75).sin()).tanh();
                d = ((-(r1[(i3 + 4) % 5])) * 0.75).sin();
            } else {
                r1[(i3 + 1) % 5] *=
                    (((r1[i3 % 5] * -0.375_f64).abs() * 0.625_f64).cos() + 0.125).tanh();
                d *= (((d * d + 0.25).sqrt() + (((i3 as f64) * 0.25) * y)) * 0.75).sin();
            }
        }
        let mut n5 = 0_usize;
        'l4: while n5 < 2 {
            n5 += 1;
            'l6: for i7 in (1..0_usize).rev() {
                let mut f = ((r1[2] - 0.125_f64).tanh() + 0.125).tanh();
                let e = program_11(((r1[0] * d) + 0.125).tanh(), ((f + f) + 0.125).tanh()).tanh();
            }
        }
    } else {
        d = (x * 0.75).sin();
        'l8: for i9 in (0..1_usize).step_by(2) {
            r1[(i9 * i9 + 1) % 5] *=
                (((r1[2] * 0.375_f64).cos() * (r1[(i9 * i9 + 1) % 5] + y)) * 0.75).sin();
        }
        let e = if (d / (1.5 + d * d)) < r1[1] { (-(-(y))) } else { (-(r1[3] + d)) };
    }
    ((x - 0.375_f64).tanh() - (d / (1.5 + -0.375_f64 * -0.375_f64))) + d + y + x
}

fn program_45_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (x * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((x - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((x * y) * S::from_f64(0.75)).sin(),
        ((x + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    if (r1[1] - S::from_f64(0.375_f64)).tanh().cmplt((r1[4] + S::from_f64(0.625_f64)).sin()) {
        'l2: for i3 in 1..0_usize {
            if i3 % 4 == 3 {
                let b = program_0_of(
                    ((y * r1[2]) * S::from_f64(0.75)).sin(),
                    (r1[4] * S::from_f64(0.75)).sin(),
                )
                .tanh();
                d = ((-(r1[(i3 + 4) % 5])) * S::from_f64(0.75)).sin();
            } else {
                r1[(i3 + 1) % 5] = r1[(i3 + 1) % 5]
                    * (((r1[i3 % 5] * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.625_f64))
                        .cos()
                        + S::from_f64(0.125))
                    .tanh();
                d = d
                    * (((d * d + S::from_f64(0.25)).sqrt()
                        + ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * y))
                        * S::from_f64(0.75))
                    .sin();
            }
        }
        let mut n5 = 0_usize;
        'l4: while n5 < 2 {
            n5 += 1;
            'l6: for i7 in (1..0_usize).rev() {
                let mut f = ((r1[2] - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
                let e = program_11_of(
                    ((r1[0] * d) + S::from_f64(0.125)).tanh(),
                    ((f + f) + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            }
        }
    } else {
        d = (x * S::from_f64(0.75)).sin();
        'l8: for i9 in (0..1_usize).step_by(2) {
            r1[(i9 * i9 + 1) % 5] = r1[(i9 * i9 + 1) % 5]
                * (((r1[2] * S::from_f64(0.375_f64)).cos() * (r1[(i9 * i9 + 1) % 5] + y))
                    * S::from_f64(0.75))
                .sin();
        }
        let e =
            if (d / (S::from_f64(1.5) + d * d)).cmplt(r1[1]) { (-(-(y))) } else { (-(r1[3] + d)) };
    }
    ((x - S::from_f64(0.375_f64)).tanh()
        - (d / (S::from_f64(1.5) + S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64))))
        + d
        + y
        + x
}

#[differentiable]
fn program_46(x: f64, y: f64) -> f64 {
    let mut b = ((x * -0.875_f64).cos() * 0.75).sin();
    let r1 = [(x * 0.75).sin(); 5];
    let (a, mut b) = (((b + y) + 0.125).tanh(), x);
    if (a + r1[2]) >= (b + -0.875_f64).sin() {
        let mut r2 = [
            ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh(),
            ((x * r1[1]) + 0.125).tanh(),
            (a * 0.75).sin(),
        ];
        if (y * y + 0.25).sqrt() <= (y - r2[2]) {
            let mut f = (x + 0.125).tanh();
            let g3 = |t: f64| ((a * -0.875_f64).max(x) * (x * x + 0.25).sqrt()) * t;
            let a = (g3((r1[1] - y)) + g3((f * a))).sin();
        } else {
            let g4 = |t: f64| ((a + 0.375_f64).sin() * (r1[3] * a)) * t;
            let f = (g4((r2[1] * -0.875_f64).max(x)) + g4((r1[0] + a))).sin();
            'l5: for i6 in (2..5_usize).step_by(2) {
                let mut b = ((r2[i6 % 3] * 0.375_f64).cos() + 0.125).tanh();
            }
        }
    } else {
        'l7: for i8 in (0..4_usize).step_by(2) {
            'l9: for i10 in (1..0_usize).rev() {
                b -= (((((i10 as f64) * 0.25) * x) * (r1[(i8 + 0) % 5] - -1.125_f64).tanh())
                    * 0.75)
                    .sin();
            }
            if (x - -0.625_f64).tanh() < (b + -0.125_f64) {
                b += (a + 0.125).tanh();
                b -= ((-((y + 0.625_f64).sin())) + 0.125).tanh();
            } else {
                let (a, mut b) = (((a * a) + 0.125).tanh(), (b + r1[(i8 + 2) % 5]));
                b *= (((b - b)
                    / (1.5
                        + (r1[i8 % 5] * r1[i8 % 5] + 0.25).sqrt()
                            * (r1[i8 % 5] * r1[i8 % 5] + 0.25).sqrt()))
                    * 0.75)
                    .sin();
                b -= (((-(r1[4])) + 0.125_f64).sin() * 0.75).sin();
            }
        }
        if (y + -1.125_f64).sin() <= (-(y)) {
            let c: f64 = r1.iter().map(|v| v * ((r1[1] - r1[0]) + 0.125).tanh()).sum();
            let f = if (y - b) < r1[3] { (r1[4] - (r1[0] + y)) } else { ((b * c) + (-(c))) };
            b = (((-0.375_f64 * b) * 0.125_f64).cos() * 0.75).sin();
        }
        b *= ((-((r1[3] - -0.875_f64).tanh())) * 0.75).sin();
    }
    ((y + r1[1]) * 0.125_f64).abs() + b + a + y + x
}

fn program_46_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let r1 = [(x * S::from_f64(0.75)).sin(); 5];
    let (a, mut b) = (((b + y) + S::from_f64(0.125)).tanh(), x);
    if (a + r1[2]).cmpge((b + S::from_f64(-0.875_f64)).sin()) {
        let mut r2 = [
            ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            ((x * r1[1]) + S::from_f64(0.125)).tanh(),
            (a * S::from_f64(0.75)).sin(),
        ];
        if (y * y + S::from_f64(0.25)).sqrt().cmple((y - r2[2])) {
            let mut f = (x + S::from_f64(0.125)).tanh();
            let g3 = |t: S| {
                ((a * S::from_f64(-0.875_f64)).max(x) * (x * x + S::from_f64(0.25)).sqrt()) * t
            };
            let a = (g3((r1[1] - y)) + g3((f * a))).sin();
        } else {
            let g4 = |t: S| ((a + S::from_f64(0.375_f64)).sin() * (r1[3] * a)) * t;
            let f = (g4((r2[1] * S::from_f64(-0.875_f64)).max(x)) + g4((r1[0] + a))).sin();
            'l5: for i6 in (2..5_usize).step_by(2) {
                let mut b =
                    ((r2[i6 % 3] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
            }
        }
    } else {
        'l7: for i8 in (0..4_usize).step_by(2) {
            'l9: for i10 in (1..0_usize).rev() {
                b = b
                    - ((((S::from_f64(i10 as f64) * S::from_f64(0.25)) * x)
                        * (r1[(i8 + 0) % 5] - S::from_f64(-1.125_f64)).tanh())
                        * S::from_f64(0.75))
                    .sin();
            }
            if (x - S::from_f64(-0.625_f64)).tanh().cmplt((b + S::from_f64(-0.125_f64))) {
                b = b + (a + S::from_f64(0.125)).tanh();
                b = b - ((-((y + S::from_f64(0.625_f64)).sin())) + S::from_f64(0.125)).tanh();
            } else {
                let (a, mut b) = (((a * a) + S::from_f64(0.125)).tanh(), (b + r1[(i8 + 2) % 5]));
                b = b
                    * (((b - b)
                        / (S::from_f64(1.5)
                            + (r1[i8 % 5] * r1[i8 % 5] + S::from_f64(0.25)).sqrt()
                                * (r1[i8 % 5] * r1[i8 % 5] + S::from_f64(0.25)).sqrt()))
                        * S::from_f64(0.75))
                    .sin();
                b = b - (((-(r1[4])) + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
            }
        }
        if (y + S::from_f64(-1.125_f64)).sin().cmple((-(y))) {
            let c = r1.iter().fold(S::from_f64(-0.0), |s, v| {
                s + *v * ((r1[1] - r1[0]) + S::from_f64(0.125)).tanh()
            });
            let f = if (y - b).cmplt(r1[3]) { (r1[4] - (r1[0] + y)) } else { ((b * c) + (-(c))) };
            b = (((S::from_f64(-0.375_f64) * b) * S::from_f64(0.125_f64)).cos()
                * S::from_f64(0.75))
            .sin();
        }
        b = b * ((-((r1[3] - S::from_f64(-0.875_f64)).tanh())) * S::from_f64(0.75)).sin();
    }
    ((y + r1[1]) * S::from_f64(0.125_f64)).abs() + b + a + y + x
}

#[differentiable]
fn program_47(x: f64, y: f64) -> f64 {
    let mut d = ((-1.125_f64 + x) * 0.75).sin();
    let r1 = [((d * y) * 0.75).sin(); 3];
    if (r1[2] - y) > x {
        let mut n3 = 0_usize;
        'l2: while n3 < 2 {
            n3 += 1;
            let b = ((d * -1.125_f64).cos() * (d * -1.125_f64).cos() + 0.25).sqrt();
        }
    } else {
        d += (((r1[0] * y) * (r1[2] * 0.375_f64).abs()) * 0.75).sin();
        let mut f = ((d + 0.625_f64).sin() * 0.75).sin();
        let g4 = |t: f64| ((y * y + 0.25).sqrt() * (r1[1] * t)) * t;
        let f = (g4((r1[0] + y)) + g4((r1[0] + -0.875_f64).sin())).sin();
    }
    let c = program_30((r1[1] * 0.75).sin(), ((r1[0] + -1.125_f64).sin() + 0.125).tanh()).tanh();
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let mut n8 = 0_usize;
        'l7: while n8 < 1 {
            n8 += 1;
            d += ((-((r1[2] * r1[2] + 0.25).sqrt())) + 0.125).tanh();
        }
        let c = y;
        if (y * c) >= (r1[(n6 + 0) % 3] + r1[(n6 * n6 + 1) % 3]) {
            continue 'l5;
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 3 {
        n10 += 1;
        d = (((-(r1[(n10 + 1) % 3])) * (r1[(n10 + 0) % 3] / (1.5 + c * c))) * 0.75).sin();
        'l11: for i12 in (2..0_usize).rev() {
            let mut n14 = 0_usize;
            'l13: while n14 < 5 {
                n14 += 1;
                d *= ((-(c - -0.375_f64)) * 0.75).sin();
            }
            let (a, mut b) = (((y * r1[i12 % 3]) * 0.75).sin(), (-(r1[(n10 * n10 + 1) % 3])));
            let e =
                ((r1[n10 % 3] * 0.625_f64).max(d) + (0.625_f64 / (1.5 + -0.875_f64 * -0.875_f64)));
        }
        d = (((-0.625_f64 * r1[(n10 + 1) % 3]) - (c * -1.125_f64).cos()) + 0.125).tanh();
    }
    (-(r1[0] * r1[1])) + c + d + y + x
}

fn program_47_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((S::from_f64(-1.125_f64) + x) * S::from_f64(0.75)).sin();
    let r1 = [((d * y) * S::from_f64(0.75)).sin(); 3];
    if (r1[2] - y).cmpgt(x) {
        let mut n3 = 0_usize;
        'l2: while n3 < 2 {
            n3 += 1;
            let b = ((d * S::from_f64(-1.125_f64)).cos() * (d * S::from_f64(-1.125_f64)).cos()
                + S::from_f64(0.25))
            .sqrt();
        }
    } else {
        d = d + (((r1[0] * y) * (r1[2] * S::from_f64(0.375_f64)).abs()) * S::from_f64(0.75)).sin();
        let mut f = ((d + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin();
        let g4 = |t: S| ((y * y + S::from_f64(0.25)).sqrt() * (r1[1] * t)) * t;
        let f = (g4((r1[0] + y)) + g4((r1[0] + S::from_f64(-0.875_f64)).sin())).sin();
    }
    let c = program_30_of(
        (r1[1] * S::from_f64(0.75)).sin(),
        ((r1[0] + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let mut n8 = 0_usize;
        'l7: while n8 < 1 {
            n8 += 1;
            d = d + ((-((r1[2] * r1[2] + S::from_f64(0.25)).sqrt())) + S::from_f64(0.125)).tanh();
        }
        let c = y;
        if (y * c).cmpge((r1[(n6 + 0) % 3] + r1[(n6 * n6 + 1) % 3])) {
            continue 'l5;
        }
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 3 {
        n10 += 1;
        d = (((-(r1[(n10 + 1) % 3])) * (r1[(n10 + 0) % 3] / (S::from_f64(1.5) + c * c)))
            * S::from_f64(0.75))
        .sin();
        'l11: for i12 in (2..0_usize).rev() {
            let mut n14 = 0_usize;
            'l13: while n14 < 5 {
                n14 += 1;
                d = d * ((-(c - S::from_f64(-0.375_f64))) * S::from_f64(0.75)).sin();
            }
            let (a, mut b) =
                (((y * r1[i12 % 3]) * S::from_f64(0.75)).sin(), (-(r1[(n10 * n10 + 1) % 3])));
            let e = ((r1[n10 % 3] * S::from_f64(0.625_f64)).max(d)
                + (S::from_f64(0.625_f64)
                    / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64))));
        }
        d = (((S::from_f64(-0.625_f64) * r1[(n10 + 1) % 3]) - (c * S::from_f64(-1.125_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    }
    (-(r1[0] * r1[1])) + c + d + y + x
}

#[differentiable]
fn program_48(x: f64, y: f64) -> f64 {
    let mut b = (y * 0.75).sin();
    let mut r1 = [
        ((y * b) * 0.75).sin(),
        ((b * -1.125_f64).max(0.125_f64) + 0.125).tanh(),
        ((-(x)) + 0.125).tanh(),
        ((-(b)) + 0.125).tanh(),
    ];
    'l2: for i3 in 1..3_usize {
        b *= (((x + r1[3]) / (1.5 + (y - -0.875_f64).tanh() * (y - -0.875_f64).tanh())) * 0.75)
            .sin();
    }
    r1[3] = (((r1[2] * 0.625_f64).max(r1[0]) * (r1[2] * 0.625_f64).max(r1[0]) + 0.25).sqrt()
        + 0.125)
        .tanh();
    r1[0] += (y + 0.125).tanh();
    if (r1[2] * y) < (y - x) {
        r1[3] = (((r1[2] * -0.375_f64).abs() + (r1[3] - r1[0])) * 0.75).sin();
        'l4: for i5 in (0..3_usize).step_by(2) {
            b = (((x * x) * -0.875_f64).max(r1[(i5 * i5 + 1) % 4]) * 0.75).sin();
            r1[1] = (((r1[(i5 * i5 + 1) % 4] * x) + (((i5 as f64) * 0.25) + y)) * 0.75).sin();
            if i5 % 4 == 2 {
                break;
            }
        }
    }
    r1[2] = ((y / (1.5 + (-(x)) * (-(x)))) * 0.75).sin();
    'l6: for i7 in (0..1_usize).step_by(2) {
        let d = program_11(
            ((y - ((i7 as f64) * 0.25)) * 0.75).sin(),
            ((((i7 as f64) * 0.25) * 0.625_f64).abs() * 0.75).sin(),
        )
        .tanh();
    }
    b = (b * 0.75).sin();
    ((-(x)) - 0.875_f64).tanh() + b + y + x
}

fn program_48_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (y * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * b) * S::from_f64(0.75)).sin(),
        ((b * S::from_f64(-1.125_f64)).max(S::from_f64(0.125_f64)) + S::from_f64(0.125)).tanh(),
        ((-(x)) + S::from_f64(0.125)).tanh(),
        ((-(b)) + S::from_f64(0.125)).tanh(),
    ];
    'l2: for i3 in 1..3_usize {
        b = b
            * (((x + r1[3])
                / (S::from_f64(1.5)
                    + (y - S::from_f64(-0.875_f64)).tanh()
                        * (y - S::from_f64(-0.875_f64)).tanh()))
                * S::from_f64(0.75))
            .sin();
    }
    r1[3] = (((r1[2] * S::from_f64(0.625_f64)).max(r1[0])
        * (r1[2] * S::from_f64(0.625_f64)).max(r1[0])
        + S::from_f64(0.25))
    .sqrt()
        + S::from_f64(0.125))
    .tanh();
    r1[0] = r1[0] + (y + S::from_f64(0.125)).tanh();
    if (r1[2] * y).cmplt((y - x)) {
        r1[3] =
            (((r1[2] * S::from_f64(-0.375_f64)).abs() + (r1[3] - r1[0])) * S::from_f64(0.75)).sin();
        'l4: for i5 in (0..3_usize).step_by(2) {
            b = (((x * x) * S::from_f64(-0.875_f64)).max(r1[(i5 * i5 + 1) % 4])
                * S::from_f64(0.75))
            .sin();
            r1[1] = (((r1[(i5 * i5 + 1) % 4] * x)
                + ((S::from_f64(i5 as f64) * S::from_f64(0.25)) + y))
                * S::from_f64(0.75))
            .sin();
            if i5 % 4 == 2 {
                break;
            }
        }
    }
    r1[2] = ((y / (S::from_f64(1.5) + (-(x)) * (-(x)))) * S::from_f64(0.75)).sin();
    'l6: for i7 in (0..1_usize).step_by(2) {
        let d = program_11_of(
            ((y - (S::from_f64(i7 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
            (((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.625_f64)).abs()
                * S::from_f64(0.75))
            .sin(),
        )
        .tanh();
    }
    b = (b * S::from_f64(0.75)).sin();
    ((-(x)) - S::from_f64(0.875_f64)).tanh() + b + y + x
}

#[differentiable]
fn program_49(x: f64, y: f64) -> f64 {
    let mut c = (x * 0.75).sin();
    let r1 = [((-(c)) * 0.75).sin(); 2];
    'l2: for i3 in (0..4_usize).step_by(2) {
        if i3 % 3 == 0 {
            let mut r4 = [((((i3 as f64) * 0.25) + r1[0]) * 0.75).sin(); 4];
        }
        c = (c * 0.75).sin();
    }
    c += ((c / (1.5 + (-0.125_f64 * c) * (-0.125_f64 * c))) * 0.75).sin();
    c = ((-(c * r1[0])) * 0.75).sin();
    let mut r5 = [((x * y) * 0.75).sin(); 4];
    c = (((r1[1] / (1.5 + c * c)) * (y * -0.625_f64).cos()) * 0.75).sin();
    'l6: for i7 in 2..1_usize {
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            if n9 % 4 == 3 {
                let (a, mut b) = ((x * 0.75).sin(), (r1[0] * 0.125_f64).max(((i7 as f64) * 0.25)));
                let e =
                    ((y / (1.5 + r1[(i7 + 0) % 2] * r1[(i7 + 0) % 2])) + (a + r5[(i7 + 2) % 4]));
            }
        }
    }
    if (r5[0] + x) < (x - -0.125_f64).tanh() {
        return ((y + r1[0]) * 0.625_f64).cos();
    }
    ((c - x) * c) + c + y + x
}

fn program_49_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (x * S::from_f64(0.75)).sin();
    let r1 = [((-(c)) * S::from_f64(0.75)).sin(); 2];
    'l2: for i3 in (0..4_usize).step_by(2) {
        if i3 % 3 == 0 {
            let mut r4 = [(((S::from_f64(i3 as f64) * S::from_f64(0.25)) + r1[0])
                * S::from_f64(0.75))
            .sin(); 4];
        }
        c = (c * S::from_f64(0.75)).sin();
    }
    c = c
        + ((c
            / (S::from_f64(1.5) + (S::from_f64(-0.125_f64) * c) * (S::from_f64(-0.125_f64) * c)))
            * S::from_f64(0.75))
        .sin();
    c = ((-(c * r1[0])) * S::from_f64(0.75)).sin();
    let mut r5 = [((x * y) * S::from_f64(0.75)).sin(); 4];
    c = (((r1[1] / (S::from_f64(1.5) + c * c)) * (y * S::from_f64(-0.625_f64)).cos())
        * S::from_f64(0.75))
    .sin();
    'l6: for i7 in 2..1_usize {
        let mut n9 = 0_usize;
        'l8: while n9 < 5 {
            n9 += 1;
            if n9 % 4 == 3 {
                let (a, mut b) = (
                    (x * S::from_f64(0.75)).sin(),
                    (r1[0] * S::from_f64(0.125_f64))
                        .max((S::from_f64(i7 as f64) * S::from_f64(0.25))),
                );
                let e = ((y / (S::from_f64(1.5) + r1[(i7 + 0) % 2] * r1[(i7 + 0) % 2]))
                    + (a + r5[(i7 + 2) % 4]));
            }
        }
    }
    if (r5[0] + x).cmplt((x - S::from_f64(-0.125_f64)).tanh()) {
        return ((y + r1[0]) * S::from_f64(0.625_f64)).cos();
    }
    ((c - x) * c) + c + y + x
}

#[differentiable]
fn program_50(x: f64, y: f64) -> f64 {
    let mut a = ((x + 0.125_f64).sin() * 0.75).sin();
    let r1 = [((a * a) * 0.75).sin(); 4];
    a *= (((a + y) / (1.5 + a * a)) * 0.75).sin();
    if r1[3] > (y * 0.375_f64).cos() {
        a *= (((y * a) - -0.625_f64).tanh() + 0.125).tanh();
    }
    a -= (((a / (1.5 + -1.125_f64 * -1.125_f64)) + (a * a)) * 0.75).sin();
    'l2: for i3 in (2..5_usize).step_by(2) {
        'l4: for i5 in (i3..5_usize).step_by(2) {
            a = (((x + x) / (1.5 + (-(x)) * (-(x)))) + 0.125).tanh();
            a = (((x - r1[1]) * 0.625_f64).max(a) * 0.75).sin();
        }
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 2 {
        n7 += 1;
        let a = (r1[2] + -0.625_f64).sin();
        let mut c = ((r1[(n7 * n7 + 1) % 4] * x) + 0.125).tanh();
        'l8: for i9 in n7..4_usize {
            'l10: for i11 in (2..2_usize).step_by(2) {
                c *= (((x * -0.875_f64) * (c - 0.625_f64).tanh()) * 0.75).sin();
                c += (((x * -0.625_f64).max(c)
                    * (r1[(i9 * i9 + 1) % 4] * r1[(i9 * i9 + 1) % 4] + 0.25).sqrt())
                    + 0.125)
                    .tanh();
                let mut r12 = [((-(y)) * 0.75).sin(); 2];
            }
            let (a, mut b) = (((c - -0.375_f64).tanh() * 0.75).sin(), (c * c + 0.25).sqrt());
            let r13 = [
                ((c + 0.125_f64).sin() * 0.75).sin(),
                ((x / (1.5 + 0.875_f64 * 0.875_f64)) * 0.75).sin(),
                ((((n7 as f64) * 0.25) * a) + 0.125).tanh(),
                (r1[(n7 * n7 + 1) % 4] * 0.75).sin(),
            ];
        }
    }
    ((a * x) + (0.375_f64 * x)) + a + y + x
}

fn program_50_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let r1 = [((a * a) * S::from_f64(0.75)).sin(); 4];
    a = a * (((a + y) / (S::from_f64(1.5) + a * a)) * S::from_f64(0.75)).sin();
    if r1[3].cmpgt((y * S::from_f64(0.375_f64)).cos()) {
        a = a * (((y * a) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    }
    a = a
        - (((a / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
            + (a * a))
            * S::from_f64(0.75))
        .sin();
    'l2: for i3 in (2..5_usize).step_by(2) {
        'l4: for i5 in (i3..5_usize).step_by(2) {
            a = (((x + x) / (S::from_f64(1.5) + (-(x)) * (-(x)))) + S::from_f64(0.125)).tanh();
            a = (((x - r1[1]) * S::from_f64(0.625_f64)).max(a) * S::from_f64(0.75)).sin();
        }
    }
    let mut n7 = 0_usize;
    'l6: while n7 < 2 {
        n7 += 1;
        let a = (r1[2] + S::from_f64(-0.625_f64)).sin();
        let mut c = ((r1[(n7 * n7 + 1) % 4] * x) + S::from_f64(0.125)).tanh();
        'l8: for i9 in n7..4_usize {
            'l10: for i11 in (2..2_usize).step_by(2) {
                c = c
                    * (((x * S::from_f64(-0.875_f64)) * (c - S::from_f64(0.625_f64)).tanh())
                        * S::from_f64(0.75))
                    .sin();
                c = c
                    + (((x * S::from_f64(-0.625_f64)).max(c)
                        * (r1[(i9 * i9 + 1) % 4] * r1[(i9 * i9 + 1) % 4] + S::from_f64(0.25))
                            .sqrt())
                        + S::from_f64(0.125))
                    .tanh();
                let mut r12 = [((-(y)) * S::from_f64(0.75)).sin(); 2];
            }
            let (a, mut b) = (
                ((c - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
                (c * c + S::from_f64(0.25)).sqrt(),
            );
            let r13 = [
                ((c + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
                ((x / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64)))
                    * S::from_f64(0.75))
                .sin(),
                (((S::from_f64(n7 as f64) * S::from_f64(0.25)) * a) + S::from_f64(0.125)).tanh(),
                (r1[(n7 * n7 + 1) % 4] * S::from_f64(0.75)).sin(),
            ];
        }
    }
    ((a * x) + (S::from_f64(0.375_f64) * x)) + a + y + x
}

#[differentiable]
fn program_51(x: f64, y: f64) -> f64 {
    let mut c = ((y + y) * 0.75).sin();
    let mut r1 = [
        ((-(y)) + 0.125).tanh(),
        ((-(x)) + 0.125).tanh(),
        ((x * y) * 0.75).sin(),
        ((y * 0.375_f64).max(c) * 0.75).sin(),
        (c + 0.125).tanh(),
    ];
    let g2 = |t: f64| ((x * x + 0.25).sqrt() * -0.625_f64).abs() * t;
    let d = (g2((-(r1[0]))) + g2((r1[1] * r1[1] + 0.25).sqrt())).sin();
    c += (((0.125_f64 - 0.875_f64).tanh() / (1.5 + (c / (1.5 + x * x)) * (c / (1.5 + x * x))))
        * 0.75)
        .sin();
    r1[0] = (y * 0.75).sin();
    'l3: for i4 in (1..2_usize).step_by(2) {
        let (a, mut b) = ((d * 0.75).sin(), (r1[3] * -0.875_f64).cos());
        let mut e = ((c * d) + 0.125).tanh();
    }
    let (a, mut b) = ((x + 0.125).tanh(), r1[0]);
    if (c * 0.875_f64).cos() >= (x * r1[2]) {
        let d = program_27(((b * x) + 0.125).tanh(), ((b - r1[2]) + 0.125).tanh()).tanh();
        r1[0] -= (((a * c) + 0.625_f64).sin() * 0.75).sin();
    }
    r1[4] *= (((a - x) - (r1[0] * r1[0] + 0.25).sqrt()) * 0.75).sin();
    r1[4] = ((r1[0] + r1[2]) * 0.75).sin();
    r1[4] = (((-(x)) * 0.875_f64).cos() + 0.125).tanh();
    'l5: for i6 in 1..=5_usize {
        c = (((r1[(i6 + 2) % 5] - y) * (b + -0.125_f64).sin()) + 0.125).tanh();
        if i6 % 2 == 0 {
            if c <= (b * 0.625_f64).cos() {
                let mut c = (b + 0.125).tanh();
                let mut a = (b * 0.75).sin();
            } else {
                c = (((r1[i6 % 5] * 0.375_f64).cos() - -0.125_f64).tanh() + 0.125).tanh();
            }
        }
        let (a, mut b) = (((x * -0.625_f64).abs() + 0.125).tanh(), (0.375_f64 - d));
    }
    (y * (r1[0] - x)) + b + a + d + c + y + x
}

fn program_51_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((-(y)) + S::from_f64(0.125)).tanh(),
        ((-(x)) + S::from_f64(0.125)).tanh(),
        ((x * y) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.375_f64)).max(c) * S::from_f64(0.75)).sin(),
        (c + S::from_f64(0.125)).tanh(),
    ];
    let g2 = |t: S| ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.625_f64)).abs() * t;
    let d = (g2((-(r1[0]))) + g2((r1[1] * r1[1] + S::from_f64(0.25)).sqrt())).sin();
    c = c
        + (((S::from_f64(0.125_f64) - S::from_f64(0.875_f64)).tanh()
            / (S::from_f64(1.5)
                + (c / (S::from_f64(1.5) + x * x)) * (c / (S::from_f64(1.5) + x * x))))
            * S::from_f64(0.75))
        .sin();
    r1[0] = (y * S::from_f64(0.75)).sin();
    'l3: for i4 in (1..2_usize).step_by(2) {
        let (a, mut b) = ((d * S::from_f64(0.75)).sin(), (r1[3] * S::from_f64(-0.875_f64)).cos());
        let mut e = ((c * d) + S::from_f64(0.125)).tanh();
    }
    let (a, mut b) = ((x + S::from_f64(0.125)).tanh(), r1[0]);
    if (c * S::from_f64(0.875_f64)).cos().cmpge((x * r1[2])) {
        let d = program_27_of(
            ((b * x) + S::from_f64(0.125)).tanh(),
            ((b - r1[2]) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        r1[0] = r1[0] - (((a * c) + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin();
    }
    r1[4] =
        r1[4] * (((a - x) - (r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) * S::from_f64(0.75)).sin();
    r1[4] = ((r1[0] + r1[2]) * S::from_f64(0.75)).sin();
    r1[4] = (((-(x)) * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh();
    'l5: for i6 in 1..=5_usize {
        c = (((r1[(i6 + 2) % 5] - y) * (b + S::from_f64(-0.125_f64)).sin()) + S::from_f64(0.125))
            .tanh();
        if i6 % 2 == 0 {
            if c.cmple((b * S::from_f64(0.625_f64)).cos()) {
                let mut c = (b + S::from_f64(0.125)).tanh();
                let mut a = (b * S::from_f64(0.75)).sin();
            } else {
                c = (((r1[i6 % 5] * S::from_f64(0.375_f64)).cos() - S::from_f64(-0.125_f64))
                    .tanh()
                    + S::from_f64(0.125))
                .tanh();
            }
        }
        let (a, mut b) = (
            ((x * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
            (S::from_f64(0.375_f64) - d),
        );
    }
    (y * (r1[0] - x)) + b + a + d + c + y + x
}

#[differentiable]
fn program_52(x: f64, y: f64) -> f64 {
    let mut a = ((y / (1.5 + 0.125_f64 * 0.125_f64)) + 0.125).tanh();
    let r1 = [((x * y) * 0.75).sin(), ((a + y) * 0.75).sin(), ((a / (1.5 + y * y)) * 0.75).sin()];
    a *= ((a * (a * x)) * 0.75).sin();
    let e =
        program_4(((x * -0.125_f64).cos() * 0.75).sin(), ((r1[2] * 0.375_f64).abs() * 0.75).sin())
            .tanh();
    a *= ((x * -0.375_f64).cos() + 0.125).tanh();
    a -= (r1[2] + 0.125).tanh();
    a = ((0.875_f64 * (y * -0.625_f64).cos()) + 0.125).tanh();
    let mut r2 = [
        ((a + 0.875_f64).sin() + 0.125).tanh(),
        ((r1[2] + -0.125_f64).sin() * 0.75).sin(),
        ((e + 0.875_f64) + 0.125).tanh(),
        ((-(e)) + 0.125).tanh(),
    ];
    let mut r3 = [((r2[1] * x) * 0.75).sin(); 2];
    let a = if (x * x + 0.25).sqrt() < (r1[1] + 0.875_f64).sin() {
        ((e / (1.5 + e * e)) - -0.875_f64).tanh()
    } else {
        ((r1[2] - 0.375_f64).tanh() + (-(y)))
    };
    'l4: for i5 in (2..3_usize).rev() {
        let a = program_18(
            ((-0.875_f64 * r3[(i5 + 0) % 2]) * 0.75).sin(),
            ((r1[(i5 + 0) % 3] - -0.375_f64).tanh() * 0.75).sin(),
        )
        .tanh();
        let d = if i5 % 4 == 1 {
            (-(r2[i5 % 4] + x))
        } else {
            ((e * 0.375_f64).cos() * 0.875_f64).abs()
        };
        let mut e = ((-(e)) + 0.125).tanh();
    }
    let d =
        program_4(((-(r2[1])) + 0.125).tanh(), ((r1[2] * 0.375_f64).cos() + 0.125).tanh()).tanh();
    let mut c = ((a * x) + 0.125).tanh();
    ((c * -0.375_f64).abs() * 0.625_f64).max(r3[1]) + c + d + a + e + y + x
}

fn program_52_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y / (S::from_f64(1.5) + S::from_f64(0.125_f64) * S::from_f64(0.125_f64)))
        + S::from_f64(0.125))
    .tanh();
    let r1 = [
        ((x * y) * S::from_f64(0.75)).sin(),
        ((a + y) * S::from_f64(0.75)).sin(),
        ((a / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
    ];
    a = a * ((a * (a * x)) * S::from_f64(0.75)).sin();
    let e = program_4_of(
        ((x * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
        ((r1[2] * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    a = a * ((x * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    a = a - (r1[2] + S::from_f64(0.125)).tanh();
    a = ((S::from_f64(0.875_f64) * (y * S::from_f64(-0.625_f64)).cos()) + S::from_f64(0.125))
        .tanh();
    let mut r2 = [
        ((a + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((r1[2] + S::from_f64(-0.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((e + S::from_f64(0.875_f64)) + S::from_f64(0.125)).tanh(),
        ((-(e)) + S::from_f64(0.125)).tanh(),
    ];
    let mut r3 = [((r2[1] * x) * S::from_f64(0.75)).sin(); 2];
    let a = if (x * x + S::from_f64(0.25)).sqrt().cmplt((r1[1] + S::from_f64(0.875_f64)).sin()) {
        ((e / (S::from_f64(1.5) + e * e)) - S::from_f64(-0.875_f64)).tanh()
    } else {
        ((r1[2] - S::from_f64(0.375_f64)).tanh() + (-(y)))
    };
    'l4: for i5 in (2..3_usize).rev() {
        let a = program_18_of(
            ((S::from_f64(-0.875_f64) * r3[(i5 + 0) % 2]) * S::from_f64(0.75)).sin(),
            ((r1[(i5 + 0) % 3] - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        )
        .tanh();
        let d = if i5 % 4 == 1 {
            (-(r2[i5 % 4] + x))
        } else {
            ((e * S::from_f64(0.375_f64)).cos() * S::from_f64(0.875_f64)).abs()
        };
        let mut e = ((-(e)) + S::from_f64(0.125)).tanh();
    }
    let d = program_4_of(
        ((-(r2[1])) + S::from_f64(0.125)).tanh(),
        ((r1[2] * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let mut c = ((a * x) + S::from_f64(0.125)).tanh();
    ((c * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.625_f64)).max(r3[1])
        + c
        + d
        + a
        + e
        + y
        + x
}

#[differentiable]
fn program_53(x: f64, y: f64) -> f64 {
    let mut c = ((x * 0.625_f64).abs() * 0.75).sin();
    let r1 = [(y * 0.75).sin(); 3];
    c *= (((r1[1] * r1[1] + 0.25).sqrt() * (r1[1] * 0.125_f64).cos()) + 0.125).tanh();
    'l2: for i3 in (0..3_usize).rev() {
        let c = program_32(((r1[i3 % 3] * c) * 0.75).sin(), ((-(x)) + 0.125).tanh()).tanh();
    }
    c = (((c + -0.625_f64).sin() * (c + -0.125_f64).sin()) * 0.75).sin();
    c += (((r1[1] * r1[2]) + x) + 0.125).tanh();
    if (y * 0.625_f64).max(r1[0]) < (y * 0.875_f64).max(r1[2]) {
        c *= ((-((r1[2] * 0.375_f64).cos())) + 0.125).tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 4 {
            n5 += 1;
            let c = ((-(r1[0])) - (r1[2] * x));
            'l6: for i7 in 1..=2_usize {
                let mut f = ((y * x) + 0.125).tanh();
                f = (((y * -0.625_f64).abs() * 0.125_f64).max(r1[(n5 * n5 + 1) % 3]) * 0.75).sin();
                f *= ((((n5 as f64) * 0.25) + (r1[(n5 * n5 + 1) % 3] * 0.875_f64).cos()) + 0.125)
                    .tanh();
            }
            let g8 = |t: f64| ((r1[n5 % 3] + -0.375_f64).sin() + (c - 0.125_f64).tanh()) * t;
            let a = (g8((r1[(n5 + 1) % 3] + r1[(n5 + 1) % 3]))
                + g8((r1[(n5 * n5 + 1) % 3] - -0.375_f64).tanh()))
            .sin();
        }
        if (x * 0.625_f64).cos() >= (c * x) {
            return ((-0.125_f64 + -0.375_f64) * (y * r1[1]));
        }
    }
    (y * (y * -1.125_f64).max(c)) + c + y + x
}

fn program_53_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let r1 = [(y * S::from_f64(0.75)).sin(); 3];
    c = c
        * (((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * (r1[1] * S::from_f64(0.125_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    'l2: for i3 in (0..3_usize).rev() {
        let c = program_32_of(
            ((r1[i3 % 3] * c) * S::from_f64(0.75)).sin(),
            ((-(x)) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    c = (((c + S::from_f64(-0.625_f64)).sin() * (c + S::from_f64(-0.125_f64)).sin())
        * S::from_f64(0.75))
    .sin();
    c = c + (((r1[1] * r1[2]) + x) + S::from_f64(0.125)).tanh();
    if (y * S::from_f64(0.625_f64)).max(r1[0]).cmplt((y * S::from_f64(0.875_f64)).max(r1[2])) {
        c = c * ((-((r1[2] * S::from_f64(0.375_f64)).cos())) + S::from_f64(0.125)).tanh();
        let mut n5 = 0_usize;
        'l4: while n5 < 4 {
            n5 += 1;
            let c = ((-(r1[0])) - (r1[2] * x));
            'l6: for i7 in 1..=2_usize {
                let mut f = ((y * x) + S::from_f64(0.125)).tanh();
                f = (((y * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.125_f64))
                    .max(r1[(n5 * n5 + 1) % 3])
                    * S::from_f64(0.75))
                .sin();
                f = f
                    * (((S::from_f64(n5 as f64) * S::from_f64(0.25))
                        + (r1[(n5 * n5 + 1) % 3] * S::from_f64(0.875_f64)).cos())
                        + S::from_f64(0.125))
                    .tanh();
            }
            let g8 = |t: S| {
                ((r1[n5 % 3] + S::from_f64(-0.375_f64)).sin() + (c - S::from_f64(0.125_f64)).tanh())
                    * t
            };
            let a = (g8((r1[(n5 + 1) % 3] + r1[(n5 + 1) % 3]))
                + g8((r1[(n5 * n5 + 1) % 3] - S::from_f64(-0.375_f64)).tanh()))
            .sin();
        }
        if (x * S::from_f64(0.625_f64)).cos().cmpge((c * x)) {
            return ((S::from_f64(-0.125_f64) + S::from_f64(-0.375_f64)) * (y * r1[1]));
        }
    }
    (y * (y * S::from_f64(-1.125_f64)).max(c)) + c + y + x
}

#[differentiable]
fn program_54(x: f64, y: f64) -> f64 {
    let mut d = ((x / (1.5 + x * x)) * 0.75).sin();
    let mut r1 = [((x + x) * 0.75).sin(); 4];
    let mut r2 = [((d * -0.625_f64).max(x) + 0.125).tanh(); 2];
    let a = if (x + d) > (d * -0.625_f64).max(x) {
        ((-(r1[0])) * -1.125_f64).abs()
    } else {
        ((-(r1[0])) * (d * d + 0.25).sqrt())
    };
    for v in r2.iter() {
        d = d * ((d * x) + 0.125).tanh() + *v * ((d * x) + 0.125).tanh();
    }
    'l3: for i4 in (0..4_usize).step_by(2) {
        let c = (-(r1[i4 % 4]));
        r1[(i4 * i4 + 1) % 4] -= (((c / (1.5 + a * a)) * 0.625_f64).cos() * 0.75).sin();
        let mut n6 = 0_usize;
        'l5: while n6 < 4 {
            n6 += 1;
            let f = ((((i4 as f64) * 0.25) * -0.375_f64).max(y) + (d + r2[0]));
            if n6 % 4 == 0 {
                r2[0] *= (((r2[(n6 + 1) % 2] + 0.625_f64).sin() - (-0.375_f64 / (1.5 + f * f)))
                    * 0.75)
                    .sin();
                r2[n6 % 2] -= (r1[2] + 0.125).tanh();
                let mut f = ((a + 0.875_f64).sin() * 0.75).sin();
            } else {
                let (a, mut b) =
                    (((d * d + 0.25).sqrt() * 0.75).sin(), (r1[(n6 * n6 + 1) % 4] + d));
            }
            'l7: for i8 in n6..=0_usize {
                let e = program_10(
                    ((r2[0] - a) + 0.125).tanh(),
                    ((((n6 as f64) * 0.25) + f) * 0.75).sin(),
                )
                .tanh();
                r2[0] = (((r1[2] + r1[(i4 + 2) % 4]) + -1.125_f64).sin() * 0.75).sin();
            }
        }
    }
    ((d - r2[1]) * (d * x)) + a + d + y + x
}

fn program_54_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin();
    let mut r1 = [((x + x) * S::from_f64(0.75)).sin(); 4];
    let mut r2 = [((d * S::from_f64(-0.625_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    let a = if (x + d).cmpgt((d * S::from_f64(-0.625_f64)).max(x)) {
        ((-(r1[0])) * S::from_f64(-1.125_f64)).abs()
    } else {
        ((-(r1[0])) * (d * d + S::from_f64(0.25)).sqrt())
    };
    for v in r2.iter() {
        d = d * ((d * x) + S::from_f64(0.125)).tanh() + *v * ((d * x) + S::from_f64(0.125)).tanh();
    }
    'l3: for i4 in (0..4_usize).step_by(2) {
        let c = (-(r1[i4 % 4]));
        r1[(i4 * i4 + 1) % 4] = r1[(i4 * i4 + 1) % 4]
            - (((c / (S::from_f64(1.5) + a * a)) * S::from_f64(0.625_f64)).cos()
                * S::from_f64(0.75))
            .sin();
        let mut n6 = 0_usize;
        'l5: while n6 < 4 {
            n6 += 1;
            let f = (((S::from_f64(i4 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64))
                .max(y)
                + (d + r2[0]));
            if n6 % 4 == 0 {
                r2[0] = r2[0]
                    * (((r2[(n6 + 1) % 2] + S::from_f64(0.625_f64)).sin()
                        - (S::from_f64(-0.375_f64) / (S::from_f64(1.5) + f * f)))
                        * S::from_f64(0.75))
                    .sin();
                r2[n6 % 2] = r2[n6 % 2] - (r1[2] + S::from_f64(0.125)).tanh();
                let mut f = ((a + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin();
            } else {
                let (a, mut b) = (
                    ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                    (r1[(n6 * n6 + 1) % 4] + d),
                );
            }
            'l7: for i8 in n6..=0_usize {
                let e = program_10_of(
                    ((r2[0] - a) + S::from_f64(0.125)).tanh(),
                    (((S::from_f64(n6 as f64) * S::from_f64(0.25)) + f) * S::from_f64(0.75)).sin(),
                )
                .tanh();
                r2[0] = (((r1[2] + r1[(i4 + 2) % 4]) + S::from_f64(-1.125_f64)).sin()
                    * S::from_f64(0.75))
                .sin();
            }
        }
    }
    ((d - r2[1]) * (d * x)) + a + d + y + x
}

#[differentiable]
fn program_55(x: f64, y: f64) -> f64 {
    let mut b = ((y + x) + 0.125).tanh();
    let r1 = [((x / (1.5 + b * b)) + 0.125).tanh(); 2];
    let b = ((y - -0.875_f64).tanh() * -0.625_f64).max(y);
    'l2: for i3 in 1..5_usize {
        let mut f = ((r1[(i3 * i3 + 1) % 2] * b) * 0.75).sin();
    }
    'l4: for i5 in (2..2_usize).rev() {
        let b = program_50((r1[i5 % 2] * 0.75).sin(), ((((i5 as f64) * 0.25) * b) + 0.125).tanh())
            .tanh();
    }
    let mut f = ((b / (1.5 + y * y)) * 0.75).sin();
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        let b = if n7 % 2 == 0 {
            r1[(n7 * n7 + 1) % 2]
        } else {
            ((b * r1[(n7 * n7 + 1) % 2]) * (b * r1[(n7 * n7 + 1) % 2]) + 0.25).sqrt()
        };
        'l8: for i9 in (2..4_usize).step_by(2) {
            'l10: for i11 in i9..=1_usize {
                f = ((r1[(i9 * i9 + 1) % 2] * 0.625_f64).max(((i11 as f64) * 0.25)) + 0.125).tanh();
                let (a, mut b) = (
                    ((b * -1.125_f64).abs() * 0.75).sin(),
                    (r1[(i11 * i11 + 1) % 2] * -1.125_f64).cos(),
                );
            }
            'l12: for i13 in (i9..1_usize).rev() {
                let f = (y + (x * -0.375_f64).max(y));
            }
        }
        f = ((b * (x * 0.125_f64).cos()) * 0.75).sin();
    }
    ((-0.625_f64 * -0.125_f64).abs() * 0.875_f64).cos() + f + b + y + x
}

fn program_55_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + x) + S::from_f64(0.125)).tanh();
    let r1 = [((x / (S::from_f64(1.5) + b * b)) + S::from_f64(0.125)).tanh(); 2];
    let b = ((y - S::from_f64(-0.875_f64)).tanh() * S::from_f64(-0.625_f64)).max(y);
    'l2: for i3 in 1..5_usize {
        let mut f = ((r1[(i3 * i3 + 1) % 2] * b) * S::from_f64(0.75)).sin();
    }
    'l4: for i5 in (2..2_usize).rev() {
        let b = program_50_of(
            (r1[i5 % 2] * S::from_f64(0.75)).sin(),
            (((S::from_f64(i5 as f64) * S::from_f64(0.25)) * b) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    let mut f = ((b / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin();
    let mut n7 = 0_usize;
    'l6: while n7 < 3 {
        n7 += 1;
        let b = if n7 % 2 == 0 {
            r1[(n7 * n7 + 1) % 2]
        } else {
            ((b * r1[(n7 * n7 + 1) % 2]) * (b * r1[(n7 * n7 + 1) % 2]) + S::from_f64(0.25)).sqrt()
        };
        'l8: for i9 in (2..4_usize).step_by(2) {
            'l10: for i11 in i9..=1_usize {
                f = ((r1[(i9 * i9 + 1) % 2] * S::from_f64(0.625_f64))
                    .max((S::from_f64(i11 as f64) * S::from_f64(0.25)))
                    + S::from_f64(0.125))
                .tanh();
                let (a, mut b) = (
                    ((b * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
                    (r1[(i11 * i11 + 1) % 2] * S::from_f64(-1.125_f64)).cos(),
                );
            }
            'l12: for i13 in (i9..1_usize).rev() {
                let f = (y + (x * S::from_f64(-0.375_f64)).max(y));
            }
        }
        f = ((b * (x * S::from_f64(0.125_f64)).cos()) * S::from_f64(0.75)).sin();
    }
    ((S::from_f64(-0.625_f64) * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.875_f64)).cos()
        + f
        + b
        + y
        + x
}

#[differentiable]
fn program_56(x: f64, y: f64) -> f64 {
    let mut d = ((y + 0.625_f64).sin() * 0.75).sin();
    let mut r1 =
        [((d + y) + 0.125).tanh(), ((d - 0.625_f64).tanh() * 0.75).sin(), (x + 0.125).tanh()];
    let mut r2 = [
        ((y * -1.125_f64).abs() + 0.125).tanh(),
        ((r1[2] * -0.125_f64).abs() + 0.125).tanh(),
        ((r1[1] * -0.875_f64).max(x) + 0.125).tanh(),
        ((r1[1] + r1[2]) + 0.125).tanh(),
        ((d + r1[0]) + 0.125).tanh(),
    ];
    let a = ((y + -1.125_f64).sin() * -0.125_f64).cos();
    let f = program_33(((y + -0.125_f64).sin() * 0.75).sin(), (r1[2] + 0.125).tanh()).tanh();
    r2[4] += (((r1[0] * a) + (r2[0] - 0.625_f64).tanh()) + 0.125).tanh();
    'l3: for i4 in (0..3_usize).step_by(2) {
        let c = if (r2[i4 % 5] * r2[(i4 + 4) % 5]) <= (((i4 as f64) * 0.25) * d) {
            ((-1.125_f64 * -0.375_f64).abs() * (-(y)))
        } else {
            ((-(-0.625_f64)) * -0.375_f64).cos()
        };
        let (a, mut b) = (
            ((-((i4 as f64) * 0.25)) * 0.75).sin(),
            (((i4 as f64) * 0.25) * ((i4 as f64) * 0.25) + 0.25).sqrt(),
        );
        let mut n6 = 0_usize;
        'l5: while n6 < 4 {
            n6 += 1;
            r1[(n6 * n6 + 1) % 3] = (((y - c) - (x - a)) + 0.125).tanh();
            b += ((((i4 as f64) * 0.25) - -0.625_f64).tanh() * 0.75).sin();
        }
    }
    let (a, mut b) = (((r2[3] + d) * 0.75).sin(), (x + a));
    let (a, mut b) = (((r2[4] - x) * 0.75).sin(), (d - 0.125_f64).tanh());
    let c = if (a * a) > (x * -0.625_f64).abs() { (r2[0] * (a * a + 0.25).sqrt()) } else { y };
    b = ((-(x)) * 0.75).sin();
    ((r2[3] - b) + (-(r1[2]))) + c + b + a + f + d + y + x
}

fn program_56_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((d + y) + S::from_f64(0.125)).tanh(),
        ((d - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        (x + S::from_f64(0.125)).tanh(),
    ];
    let mut r2 = [
        ((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((r1[2] * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((r1[1] * S::from_f64(-0.875_f64)).max(x) + S::from_f64(0.125)).tanh(),
        ((r1[1] + r1[2]) + S::from_f64(0.125)).tanh(),
        ((d + r1[0]) + S::from_f64(0.125)).tanh(),
    ];
    let a = ((y + S::from_f64(-1.125_f64)).sin() * S::from_f64(-0.125_f64)).cos();
    let f = program_33_of(
        ((y + S::from_f64(-0.125_f64)).sin() * S::from_f64(0.75)).sin(),
        (r1[2] + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    r2[4] = r2[4]
        + (((r1[0] * a) + (r2[0] - S::from_f64(0.625_f64)).tanh()) + S::from_f64(0.125)).tanh();
    'l3: for i4 in (0..3_usize).step_by(2) {
        let c = if (r2[i4 % 5] * r2[(i4 + 4) % 5])
            .cmple(((S::from_f64(i4 as f64) * S::from_f64(0.25)) * d))
        {
            ((S::from_f64(-1.125_f64) * S::from_f64(-0.375_f64)).abs() * (-(y)))
        } else {
            ((-(S::from_f64(-0.625_f64))) * S::from_f64(-0.375_f64)).cos()
        };
        let (a, mut b) = (
            ((-(S::from_f64(i4 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
            ((S::from_f64(i4 as f64) * S::from_f64(0.25))
                * (S::from_f64(i4 as f64) * S::from_f64(0.25))
                + S::from_f64(0.25))
            .sqrt(),
        );
        let mut n6 = 0_usize;
        'l5: while n6 < 4 {
            n6 += 1;
            r1[(n6 * n6 + 1) % 3] = (((y - c) - (x - a)) + S::from_f64(0.125)).tanh();
            b = b
                + (((S::from_f64(i4 as f64) * S::from_f64(0.25)) - S::from_f64(-0.625_f64)).tanh()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    let (a, mut b) = (((r2[3] + d) * S::from_f64(0.75)).sin(), (x + a));
    let (a, mut b) = (((r2[4] - x) * S::from_f64(0.75)).sin(), (d - S::from_f64(0.125_f64)).tanh());
    let c = if (a * a).cmpgt((x * S::from_f64(-0.625_f64)).abs()) {
        (r2[0] * (a * a + S::from_f64(0.25)).sqrt())
    } else {
        y
    };
    b = ((-(x)) * S::from_f64(0.75)).sin();
    ((r2[3] - b) + (-(r1[2]))) + c + b + a + f + d + y + x
}

#[differentiable]
fn program_57(x: f64, y: f64) -> f64 {
    let mut b = ((x + y) * 0.75).sin();
    let mut r1 = [((x * x) * 0.75).sin(); 3];
    let e = if (0.875_f64 + b) > r1[0] {
        ((r1[0] * r1[0] + 0.25).sqrt() - (-(r1[1])))
    } else {
        ((y * y + 0.25).sqrt() + (-(y)))
    };
    if y < (b * 0.375_f64).cos() {
        b = (((b - 0.625_f64).tanh() * -0.875_f64).cos() * 0.75).sin();
        'l2: for i3 in 2..=0_usize {
            b = (((b * b + 0.25).sqrt() * (((i3 as f64) * 0.25) / (1.5 + b * b))) * 0.75).sin();
            b = (((y - y) * (r1[(i3 + 0) % 3] * -0.125_f64).abs()) * 0.75).sin();
            let b = if i3 % 3 == 2 {
                ((((i3 as f64) * 0.25) * -0.875_f64) * -0.125_f64).cos()
            } else {
                -0.875_f64
            };
        }
        b = ((y + -0.625_f64).sin() * 0.75).sin();
    }
    if (b - 0.875_f64).tanh() > (x * 0.625_f64).abs() {
        if (e * -0.625_f64).cos() <= (x * 0.875_f64).cos() {
            'l4: for i5 in (1..5_usize).rev() {
                let mut d = ((b - 0.125_f64).tanh() * 0.75).sin();
                d = (((b + -0.875_f64).sin()
                    / (1.5 + (r1[i5 % 3] - -0.125_f64).tanh() * (r1[i5 % 3] - -0.125_f64).tanh()))
                    * 0.75)
                    .sin();
                b = ((x + -0.125_f64).sin() + 0.125).tanh();
            }
        }
        let g6 = |t: f64| ((x * r1[1]) - -0.625_f64).tanh() * t;
        let c = (g6(r1[2]) + g6((r1[2] + -0.375_f64).sin())).sin();
    }
    (e - -0.125_f64).tanh() + e + b + y + x
}

fn program_57_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [((x * x) * S::from_f64(0.75)).sin(); 3];
    let e = if (S::from_f64(0.875_f64) + b).cmpgt(r1[0]) {
        ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() - (-(r1[1])))
    } else {
        ((y * y + S::from_f64(0.25)).sqrt() + (-(y)))
    };
    if y.cmplt((b * S::from_f64(0.375_f64)).cos()) {
        b = (((b - S::from_f64(0.625_f64)).tanh() * S::from_f64(-0.875_f64)).cos()
            * S::from_f64(0.75))
        .sin();
        'l2: for i3 in 2..=0_usize {
            b = (((b * b + S::from_f64(0.25)).sqrt()
                * ((S::from_f64(i3 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + b * b)))
                * S::from_f64(0.75))
            .sin();
            b = (((y - y) * (r1[(i3 + 0) % 3] * S::from_f64(-0.125_f64)).abs())
                * S::from_f64(0.75))
            .sin();
            let b = if i3 % 3 == 2 {
                (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.875_f64))
                    * S::from_f64(-0.125_f64))
                .cos()
            } else {
                S::from_f64(-0.875_f64)
            };
        }
        b = ((y + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin();
    }
    if (b - S::from_f64(0.875_f64)).tanh().cmpgt((x * S::from_f64(0.625_f64)).abs()) {
        if (e * S::from_f64(-0.625_f64)).cos().cmple((x * S::from_f64(0.875_f64)).cos()) {
            'l4: for i5 in (1..5_usize).rev() {
                let mut d = ((b - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
                d = (((b + S::from_f64(-0.875_f64)).sin()
                    / (S::from_f64(1.5)
                        + (r1[i5 % 3] - S::from_f64(-0.125_f64)).tanh()
                            * (r1[i5 % 3] - S::from_f64(-0.125_f64)).tanh()))
                    * S::from_f64(0.75))
                .sin();
                b = ((x + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh();
            }
        }
        let g6 = |t: S| ((x * r1[1]) - S::from_f64(-0.625_f64)).tanh() * t;
        let c = (g6(r1[2]) + g6((r1[2] + S::from_f64(-0.375_f64)).sin())).sin();
    }
    (e - S::from_f64(-0.125_f64)).tanh() + e + b + y + x
}

#[differentiable]
fn program_58(x: f64, y: f64) -> f64 {
    let mut d = ((x / (1.5 + y * y)) * 0.75).sin();
    let mut r1 = [(x * 0.75).sin(); 5];
    let mut r2 = [
        ((r1[4] * -0.875_f64).max(-0.875_f64) * 0.75).sin(),
        ((d * -1.125_f64).cos() + 0.125).tanh(),
    ];
    let e = ((r1[1] * -1.125_f64).max(d) * 0.125_f64).abs();
    let g3 = |t: f64| ((e * 0.625_f64).max(r2[0]) * (d * e)) * t;
    let e = (g3((d + 0.125_f64)) + g3((-0.125_f64 * 0.125_f64).max(r1[3]))).sin();
    'l4: for i5 in (0..0_usize).step_by(2) {
        d *= (r2[(i5 * i5 + 1) % 2] * 0.75).sin();
    }
    d = (((d * -1.125_f64).max(d) + -0.875_f64).sin() + 0.125).tanh();
    let (a, mut b) = (((-(0.375_f64)) + 0.125).tanh(), e);
    b = (((-0.125_f64 * 0.625_f64).cos() + 0.125_f64).sin() * 0.75).sin();
    let g6 = |t: f64| ((r1[1] + t) + 0.125_f64).sin() * t;
    let b = (g6(d) + g6((b + 0.125_f64).sin())).sin();
    'l7: for i8 in 2..=4_usize {
        let mut r9 = [
            ((e * 0.875_f64).cos() * 0.75).sin(),
            ((d * a) + 0.125).tanh(),
            ((e - r1[1]) * 0.75).sin(),
            ((y * a) + 0.125).tanh(),
            ((r1[(i8 * i8 + 1) % 5] * 0.125_f64).max(b) * 0.75).sin(),
        ];
        let a = ((r2[(i8 + 0) % 2] * r2[(i8 + 0) % 2] + 0.25).sqrt() - -0.375_f64).tanh();
    }
    r1[4] *= (e + 0.125).tanh();
    'l10: for i11 in (1..0_usize).rev() {
        let g12 = |t: f64| ((a * 0.875_f64).abs() * 0.875_f64).cos() * t;
        let a = (g12((((i11 as f64) * 0.25) + b)) + g12((y + a))).sin();
        d += (((d * 0.875_f64).cos() + (r2[0] - 0.625_f64).tanh()) * 0.75).sin();
        d = ((e * e + 0.25).sqrt() + 0.125).tanh();
    }
    (r2[0] * (y + r1[3])) + b + a + e + d + y + x
}

fn program_58_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin();
    let mut r1 = [(x * S::from_f64(0.75)).sin(); 5];
    let mut r2 = [
        ((r1[4] * S::from_f64(-0.875_f64)).max(S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
        ((d * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let e = ((r1[1] * S::from_f64(-1.125_f64)).max(d) * S::from_f64(0.125_f64)).abs();
    let g3 = |t: S| ((e * S::from_f64(0.625_f64)).max(r2[0]) * (d * e)) * t;
    let e = (g3((d + S::from_f64(0.125_f64)))
        + g3((S::from_f64(-0.125_f64) * S::from_f64(0.125_f64)).max(r1[3])))
    .sin();
    'l4: for i5 in (0..0_usize).step_by(2) {
        d = d * (r2[(i5 * i5 + 1) % 2] * S::from_f64(0.75)).sin();
    }
    d = (((d * S::from_f64(-1.125_f64)).max(d) + S::from_f64(-0.875_f64)).sin()
        + S::from_f64(0.125))
    .tanh();
    let (a, mut b) = (((-(S::from_f64(0.375_f64))) + S::from_f64(0.125)).tanh(), e);
    b = (((S::from_f64(-0.125_f64) * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125_f64)).sin()
        * S::from_f64(0.75))
    .sin();
    let g6 = |t: S| ((r1[1] + t) + S::from_f64(0.125_f64)).sin() * t;
    let b = (g6(d) + g6((b + S::from_f64(0.125_f64)).sin())).sin();
    'l7: for i8 in 2..=4_usize {
        let mut r9 = [
            ((e * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
            ((d * a) + S::from_f64(0.125)).tanh(),
            ((e - r1[1]) * S::from_f64(0.75)).sin(),
            ((y * a) + S::from_f64(0.125)).tanh(),
            ((r1[(i8 * i8 + 1) % 5] * S::from_f64(0.125_f64)).max(b) * S::from_f64(0.75)).sin(),
        ];
        let a = ((r2[(i8 + 0) % 2] * r2[(i8 + 0) % 2] + S::from_f64(0.25)).sqrt()
            - S::from_f64(-0.375_f64))
        .tanh();
    }
    r1[4] = r1[4] * (e + S::from_f64(0.125)).tanh();
    'l10: for i11 in (1..0_usize).rev() {
        let g12 = |t: S| ((a * S::from_f64(0.875_f64)).abs() * S::from_f64(0.875_f64)).cos() * t;
        let a = (g12(((S::from_f64(i11 as f64) * S::from_f64(0.25)) + b)) + g12((y + a))).sin();
        d = d
            + (((d * S::from_f64(0.875_f64)).cos() + (r2[0] - S::from_f64(0.625_f64)).tanh())
                * S::from_f64(0.75))
            .sin();
        d = ((e * e + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    }
    (r2[0] * (y + r1[3])) + b + a + e + d + y + x
}

#[differentiable]
fn program_59(x: f64, y: f64) -> f64 {
    let mut a = ((y * -1.125_f64).abs() * 0.75).sin();
    let mut r1 = [((a * -0.625_f64).abs() + 0.125).tanh(), ((y / (1.5 + y * y)) + 0.125).tanh()];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let g4 = |t: f64| {
            ((((n3 as f64) * 0.25) + r1[(n3 * n3 + 1) % 2])
                * (((n3 as f64) * 0.25) + r1[(n3 * n3 + 1) % 2])
                + 0.25)
                .sqrt()
                * t
        };
        let e = (g4((y * 0.875_f64).cos()) + g4((r1[n3 % 2] - 0.125_f64).tanh())).sin();
        let (a, mut b) = (
            ((0.875_f64 + r1[(n3 * n3 + 1) % 2]) + 0.125).tanh(),
            (r1[(n3 * n3 + 1) % 2] + ((n3 as f64) * 0.25)),
        );
    }
    let e = ((x * y) + (x / (1.5 + a * a)));
    r1[0] -= (r1[1] + 0.125).tanh();
    r1[0] += ((x - (a + 0.625_f64).sin()) * 0.75).sin();
    if r1[1] > (r1[0] + r1[0]) {
        'l5: for i6 in 0..4_usize {
            r1[(i6 * i6 + 1) % 2] = (((r1[1] * a) * x) * 0.75).sin();
        }
        let b = program_39(((r1[1] / (1.5 + x * x)) * 0.75).sin(), ((a + e) + 0.125).tanh()).tanh();
        let mut r7 = [
            (0.125_f64 + 0.125).tanh(),
            ((r1[1] * b) * 0.75).sin(),
            ((r1[0] - 0.125_f64).tanh() + 0.125).tanh(),
            ((e + a) * 0.75).sin(),
        ];
    }
    'l8: for i9 in (0..3_usize).step_by(2) {
        for v in r1.iter() {
            a = a * ((e * a) + 0.125).tanh() + *v * ((e * a) + 0.125).tanh();
        }
    }
    let c = ((y * e) / (1.5 + (a * a + 0.25).sqrt() * (a * a + 0.25).sqrt()));
    ((r1[1] * 0.125_f64) - (x * x + 0.25).sqrt()) + c + e + a + y + x
}

fn program_59_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((a * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((y / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let g4 = |t: S| {
            (((S::from_f64(n3 as f64) * S::from_f64(0.25)) + r1[(n3 * n3 + 1) % 2])
                * ((S::from_f64(n3 as f64) * S::from_f64(0.25)) + r1[(n3 * n3 + 1) % 2])
                + S::from_f64(0.25))
            .sqrt()
                * t
        };
        let e = (g4((y * S::from_f64(0.875_f64)).cos())
            + g4((r1[n3 % 2] - S::from_f64(0.125_f64)).tanh()))
        .sin();
        let (a, mut b) = (
            ((S::from_f64(0.875_f64) + r1[(n3 * n3 + 1) % 2]) + S::from_f64(0.125)).tanh(),
            (r1[(n3 * n3 + 1) % 2] + (S::from_f64(n3 as f64) * S::from_f64(0.25))),
        );
    }
    let e = ((x * y) + (x / (S::from_f64(1.5) + a * a)));
    r1[0] = r1[0] - (r1[1] + S::from_f64(0.125)).tanh();
    r1[0] = r1[0] + ((x - (a + S::from_f64(0.625_f64)).sin()) * S::from_f64(0.75)).sin();
    if r1[1].cmpgt((r1[0] + r1[0])) {
        'l5: for i6 in 0..4_usize {
            r1[(i6 * i6 + 1) % 2] = (((r1[1] * a) * x) * S::from_f64(0.75)).sin();
        }
        let b = program_39_of(
            ((r1[1] / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
            ((a + e) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let mut r7 = [
            (S::from_f64(0.125_f64) + S::from_f64(0.125)).tanh(),
            ((r1[1] * b) * S::from_f64(0.75)).sin(),
            ((r1[0] - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
            ((e + a) * S::from_f64(0.75)).sin(),
        ];
    }
    'l8: for i9 in (0..3_usize).step_by(2) {
        for v in r1.iter() {
            a = a * ((e * a) + S::from_f64(0.125)).tanh()
                + *v * ((e * a) + S::from_f64(0.125)).tanh();
        }
    }
    let c = ((y * e)
        / (S::from_f64(1.5)
            + (a * a + S::from_f64(0.25)).sqrt() * (a * a + S::from_f64(0.25)).sqrt()));
    ((r1[1] * S::from_f64(0.125_f64)) - (x * x + S::from_f64(0.25)).sqrt()) + c + e + a + y + x
}

#[differentiable]
fn program_60(x: f64, y: f64) -> f64 {
    let mut c = ((y / (1.5 + y * y)) + 0.125).tanh();
    let mut r1 = [((x + 0.375_f64).sin() + 0.125).tanh(); 2];
    if (-(r1[1])) >= (0.375_f64 + c) {
        r1[1] += (((c * -0.625_f64) * -1.125_f64).abs() * 0.75).sin();
    } else {
        r1[1] = (((-(-0.625_f64)) / (1.5 + (0.375_f64 * c) * (0.375_f64 * c))) * 0.75).sin();
    }
    let mut r2 = [((r1[0] * 0.375_f64) * 0.75).sin(); 2];
    if (x * y) >= (x * 0.875_f64).max(x) {
        let d = program_47(((-1.125_f64 - c) + 0.125).tanh(), ((r2[1] * x) + 0.125).tanh()).tanh();
        let e = ((c * -0.375_f64).abs() - 0.625_f64).tanh();
        if (y * y + 0.25).sqrt() >= (c * -0.125_f64).max(r2[1]) {
            for v in r2.iter() {
                c = c * (y + 0.125).tanh() + *v * (y + 0.125).tanh();
            }
            'l3: for i4 in (0..2_usize).step_by(2) {
                c -= (((e + ((i4 as f64) * 0.25)) + (x - 0.625_f64).tanh()) + 0.125).tanh();
                c -= (((-0.625_f64 * ((i4 as f64) * 0.25)) - (0.375_f64 + 0.875_f64)) * 0.75).sin();
            }
            c = ((c * -0.125_f64).cos() + 0.125).tanh();
        }
    } else {
        'l5: for i6 in (1..0_usize).step_by(2) {
            'l7: for i8 in (1..0_usize).step_by(2) {
                c = ((-((x + 0.625_f64).sin())) * 0.75).sin();
                r1[0] += (((-0.875_f64 * 0.375_f64).max(r1[0]) * 0.125_f64).cos() + 0.125).tanh();
            }
            'l9: for i10 in (2..2_usize).rev() {
                let d = r2[1];
                c = (((y * -0.875_f64).max(r2[i6 % 2]) * 0.625_f64).cos() + 0.125).tanh();
                let mut d = (x * 0.75).sin();
            }
        }
    }
    ((x * x + 0.25).sqrt() + 0.625_f64).sin() + c + y + x
}

fn program_60_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(); 2];
    if (-(r1[1])).cmpge((S::from_f64(0.375_f64) + c)) {
        r1[1] = r1[1]
            + (((c * S::from_f64(-0.625_f64)) * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75))
                .sin();
    } else {
        r1[1] = (((-(S::from_f64(-0.625_f64)))
            / (S::from_f64(1.5) + (S::from_f64(0.375_f64) * c) * (S::from_f64(0.375_f64) * c)))
            * S::from_f64(0.75))
        .sin();
    }
    let mut r2 = [((r1[0] * S::from_f64(0.375_f64)) * S::from_f64(0.75)).sin(); 2];
    if (x * y).cmpge((x * S::from_f64(0.875_f64)).max(x)) {
        let d = program_47_of(
            ((S::from_f64(-1.125_f64) - c) + S::from_f64(0.125)).tanh(),
            ((r2[1] * x) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let e = ((c * S::from_f64(-0.375_f64)).abs() - S::from_f64(0.625_f64)).tanh();
        if (y * y + S::from_f64(0.25)).sqrt().cmpge((c * S::from_f64(-0.125_f64)).max(r2[1])) {
            for v in r2.iter() {
                c = c * (y + S::from_f64(0.125)).tanh() + *v * (y + S::from_f64(0.125)).tanh();
            }
            'l3: for i4 in (0..2_usize).step_by(2) {
                c = c
                    - (((e + (S::from_f64(i4 as f64) * S::from_f64(0.25)))
                        + (x - S::from_f64(0.625_f64)).tanh())
                        + S::from_f64(0.125))
                    .tanh();
                c = c
                    - (((S::from_f64(-0.625_f64) * (S::from_f64(i4 as f64) * S::from_f64(0.25)))
                        - (S::from_f64(0.375_f64) + S::from_f64(0.875_f64)))
                        * S::from_f64(0.75))
                    .sin();
            }
            c = ((c * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh();
        }
    } else {
        'l5: for i6 in (1..0_usize).step_by(2) {
            'l7: for i8 in (1..0_usize).step_by(2) {
                c = ((-((x + S::from_f64(0.625_f64)).sin())) * S::from_f64(0.75)).sin();
                r1[0] = r1[0]
                    + (((S::from_f64(-0.875_f64) * S::from_f64(0.375_f64)).max(r1[0])
                        * S::from_f64(0.125_f64))
                    .cos()
                        + S::from_f64(0.125))
                    .tanh();
            }
            'l9: for i10 in (2..2_usize).rev() {
                let d = r2[1];
                c = (((y * S::from_f64(-0.875_f64)).max(r2[i6 % 2]) * S::from_f64(0.625_f64))
                    .cos()
                    + S::from_f64(0.125))
                .tanh();
                let mut d = (x * S::from_f64(0.75)).sin();
            }
        }
    }
    ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.625_f64)).sin() + c + y + x
}

#[differentiable]
fn program_61(x: f64, y: f64) -> f64 {
    let mut e = ((x * 0.375_f64).abs() * 0.75).sin();
    let mut r1 = [((e * e) + 0.125).tanh(); 2];
    let g2 = |t: f64| (-1.125_f64 * 0.375_f64).cos() * t;
    let e = (g2((-0.375_f64 / (1.5 + r1[1] * r1[1]))) + g2((x * r1[0]))).sin();
    r1[1] = (((r1[1] + -0.375_f64) - 0.625_f64).tanh() * 0.75).sin();
    let mut b = (r1[1] + 0.125).tanh();
    b += (((b + -0.625_f64).sin() * -0.875_f64).abs() * 0.75).sin();
    let (a, mut b) = (((-(e)) * 0.75).sin(), (e + r1[0]));
    if (a + r1[1]) <= (a + -0.375_f64).sin() {
        if e > a {
            if e > (r1[1] - y) {
                return ((b + -0.625_f64).sin() * (r1[1] * -0.625_f64).abs());
            }
            let g3 = |t: f64| ((-(b)) * -0.375_f64).cos() * t;
            let b = (g3((-0.875_f64 * -0.125_f64).cos()) + g3((a + -0.375_f64).sin())).sin();
            if (x - y) < (y * 0.375_f64).max(x) {
                let mut c = ((r1[1] * 0.875_f64).max(r1[0]) + 0.125).tanh();
                c += (r1[0] + 0.125).tanh();
                r1[0] += (((y - r1[1]) - -0.375_f64).tanh() + 0.125).tanh();
            } else {
                r1[1] += (((x * x + 0.25).sqrt() * -0.625_f64).cos() + 0.125).tanh();
                let mut r4 = [(y * 0.75).sin(); 5];
                let mut b = ((r1[1] * r4[1]) * 0.75).sin();
            }
        }
        r1[1] *= (((r1[0] + 0.875_f64).sin() * (r1[1] * r1[1] + 0.25).sqrt()) * 0.75).sin();
        b = (r1[0] + 0.125).tanh();
    }
    ((r1[1] / (1.5 + e * e)) * (r1[1] * -0.375_f64)) + b + a + e + y + x
}

fn program_61_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 = [((e * e) + S::from_f64(0.125)).tanh(); 2];
    let g2 = |t: S| (S::from_f64(-1.125_f64) * S::from_f64(0.375_f64)).cos() * t;
    let e = (g2((S::from_f64(-0.375_f64) / (S::from_f64(1.5) + r1[1] * r1[1]))) + g2((x * r1[0])))
        .sin();
    r1[1] = (((r1[1] + S::from_f64(-0.375_f64)) - S::from_f64(0.625_f64)).tanh()
        * S::from_f64(0.75))
    .sin();
    let mut b = (r1[1] + S::from_f64(0.125)).tanh();
    b = b
        + (((b + S::from_f64(-0.625_f64)).sin() * S::from_f64(-0.875_f64)).abs()
            * S::from_f64(0.75))
        .sin();
    let (a, mut b) = (((-(e)) * S::from_f64(0.75)).sin(), (e + r1[0]));
    if (a + r1[1]).cmple((a + S::from_f64(-0.375_f64)).sin()) {
        if e.cmpgt(a) {
            if e.cmpgt((r1[1] - y)) {
                return ((b + S::from_f64(-0.625_f64)).sin()
                    * (r1[1] * S::from_f64(-0.625_f64)).abs());
            }
            let g3 = |t: S| ((-(b)) * S::from_f64(-0.375_f64)).cos() * t;
            let b = (g3((S::from_f64(-0.875_f64) * S::from_f64(-0.125_f64)).cos())
                + g3((a + S::from_f64(-0.375_f64)).sin()))
            .sin();
            if (x - y).cmplt((y * S::from_f64(0.375_f64)).max(x)) {
                let mut c =
                    ((r1[1] * S::from_f64(0.875_f64)).max(r1[0]) + S::from_f64(0.125)).tanh();
                c = c + (r1[0] + S::from_f64(0.125)).tanh();
                r1[0] = r1[0]
                    + (((y - r1[1]) - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh();
            } else {
                r1[1] = r1[1]
                    + (((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.625_f64)).cos()
                        + S::from_f64(0.125))
                    .tanh();
                let mut r4 = [(y * S::from_f64(0.75)).sin(); 5];
                let mut b = ((r1[1] * r4[1]) * S::from_f64(0.75)).sin();
            }
        }
        r1[1] = r1[1]
            * (((r1[0] + S::from_f64(0.875_f64)).sin()
                * (r1[1] * r1[1] + S::from_f64(0.25)).sqrt())
                * S::from_f64(0.75))
            .sin();
        b = (r1[0] + S::from_f64(0.125)).tanh();
    }
    ((r1[1] / (S::from_f64(1.5) + e * e)) * (r1[1] * S::from_f64(-0.375_f64))) + b + a + e + y + x
}

#[differentiable]
fn program_62(x: f64, y: f64) -> f64 {
    let mut c = ((x * 0.625_f64) + 0.125).tanh();
    let r1 =
        [((y * y) + 0.125).tanh(), ((x * 0.875_f64).cos() * 0.75).sin(), ((y - c) + 0.125).tanh()];
    let mut f = ((x * -0.125_f64).max(x) + 0.125).tanh();
    c = (((-0.375_f64 * 0.875_f64).max(y) - -0.125_f64).tanh() + 0.125).tanh();
    'l2: for i3 in (1..3_usize).step_by(2) {
        c = (((r1[(i3 * i3 + 1) % 3] * 0.625_f64).abs() * (-((i3 as f64) * 0.25))) * 0.75).sin();
        c = (((c * r1[(i3 + 0) % 3]) + (r1[i3 % 3] * 0.875_f64).max(r1[(i3 + 1) % 3])) + 0.125)
            .tanh();
        f = (((-(y)) + (f * c)) * 0.75).sin();
    }
    if (y * y + 0.25).sqrt() > (y + -0.125_f64) {
        return ((r1[0] * -0.125_f64).max(-0.125_f64) * (r1[1] * -0.125_f64).max(y));
    }
    if (y * f) <= (y * 0.125_f64).abs() {
        let mut a = (f * 0.75).sin();
        c -= ((-0.125_f64 * 0.625_f64).max(r1[0]) + 0.125).tanh();
        'l4: for i5 in 2..5_usize {
            let b: f64 = r1.iter().map(|v| v * ((x * f) + 0.125).tanh()).sum();
            let d = program_46(
                ((((i5 as f64) * 0.25) + x) + 0.125).tanh(),
                (((i5 as f64) * 0.25) + 0.125).tanh(),
            )
            .tanh();
            c *= ((f * 0.875_f64).abs() * 0.75).sin();
        }
    }
    ((r1[1] * x) + (x / (1.5 + r1[1] * r1[1]))) + f + c + y + x
}

fn program_62_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * S::from_f64(0.625_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [
        ((y * y) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ((y - c) + S::from_f64(0.125)).tanh(),
    ];
    let mut f = ((x * S::from_f64(-0.125_f64)).max(x) + S::from_f64(0.125)).tanh();
    c = (((S::from_f64(-0.375_f64) * S::from_f64(0.875_f64)).max(y) - S::from_f64(-0.125_f64))
        .tanh()
        + S::from_f64(0.125))
    .tanh();
    'l2: for i3 in (1..3_usize).step_by(2) {
        c = (((r1[(i3 * i3 + 1) % 3] * S::from_f64(0.625_f64)).abs()
            * (-(S::from_f64(i3 as f64) * S::from_f64(0.25))))
            * S::from_f64(0.75))
        .sin();
        c = (((c * r1[(i3 + 0) % 3])
            + (r1[i3 % 3] * S::from_f64(0.875_f64)).max(r1[(i3 + 1) % 3]))
            + S::from_f64(0.125))
        .tanh();
        f = (((-(y)) + (f * c)) * S::from_f64(0.75)).sin();
    }
    if (y * y + S::from_f64(0.25)).sqrt().cmpgt((y + S::from_f64(-0.125_f64))) {
        return ((r1[0] * S::from_f64(-0.125_f64)).max(S::from_f64(-0.125_f64))
            * (r1[1] * S::from_f64(-0.125_f64)).max(y));
    }
    if (y * f).cmple((y * S::from_f64(0.125_f64)).abs()) {
        let mut a = (f * S::from_f64(0.75)).sin();
        c = c
            - ((S::from_f64(-0.125_f64) * S::from_f64(0.625_f64)).max(r1[0]) + S::from_f64(0.125))
                .tanh();
        'l4: for i5 in 2..5_usize {
            let b = r1
                .iter()
                .fold(S::from_f64(-0.0), |s, v| s + *v * ((x * f) + S::from_f64(0.125)).tanh());
            let d = program_46_of(
                (((S::from_f64(i5 as f64) * S::from_f64(0.25)) + x) + S::from_f64(0.125)).tanh(),
                ((S::from_f64(i5 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh(),
            )
            .tanh();
            c = c * ((f * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin();
        }
    }
    ((r1[1] * x) + (x / (S::from_f64(1.5) + r1[1] * r1[1]))) + f + c + y + x
}

#[differentiable]
fn program_63(x: f64, y: f64) -> f64 {
    let mut e = ((y + x) + 0.125).tanh();
    let mut r1 = [((x * 0.875_f64).max(0.125_f64) + 0.125).tanh(); 5];
    let e = program_59(((y * x) + 0.125).tanh(), ((y * e) + 0.125).tanh()).tanh();
    let mut a = ((e - -1.125_f64).tanh() + 0.125).tanh();
    let e = ((r1[1] - -0.625_f64).tanh() - 0.625_f64).tanh();
    r1[2] += ((a - e) * 0.75).sin();
    let e = ((-(r1[2])) + y);
    let f = program_32((y * 0.75).sin(), ((e * a) * 0.75).sin()).tanh();
    'l2: for i3 in 1..=2_usize {
        let d = if (a / (1.5 + f * f)) >= (a * r1[4]) {
            (((i3 as f64) * 0.25) * (((i3 as f64) * 0.25) * r1[i3 % 5]))
        } else {
            ((y * 0.375_f64).abs() * (y * -1.125_f64).cos())
        };
        'l4: for i5 in (2..2_usize).step_by(2) {
            let b = ((r1[0] * 0.875_f64).max(x)
                / (1.5 + (-(r1[(i5 + 0) % 5])) * (-(r1[(i5 + 0) % 5]))));
        }
    }
    let (a, mut b) = (((-0.375_f64 * -0.625_f64).cos() * 0.75).sin(), x);
    let b = program_48((r1[1] + 0.125).tanh(), (-0.625_f64 + 0.125).tanh()).tanh();
    let b = program_7(((-0.375_f64 - b) * 0.75).sin(), (r1[1] * 0.75).sin()).tanh();
    let (a, mut b) = (((y * 0.375_f64).abs() + 0.125).tanh(), (-0.875_f64 - -0.875_f64).tanh());
    ((-(x)) - -0.375_f64).tanh() + b + a + f + e + y + x
}

fn program_63_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y + x) + S::from_f64(0.125)).tanh();
    let mut r1 =
        [((x * S::from_f64(0.875_f64)).max(S::from_f64(0.125_f64)) + S::from_f64(0.125)).tanh(); 5];
    let e =
        program_59_of(((y * x) + S::from_f64(0.125)).tanh(), ((y * e) + S::from_f64(0.125)).tanh())
            .tanh();
    let mut a = ((e - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let e = ((r1[1] - S::from_f64(-0.625_f64)).tanh() - S::from_f64(0.625_f64)).tanh();
    r1[2] = r1[2] + ((a - e) * S::from_f64(0.75)).sin();
    let e = ((-(r1[2])) + y);
    let f =
        program_32_of((y * S::from_f64(0.75)).sin(), ((e * a) * S::from_f64(0.75)).sin()).tanh();
    'l2: for i3 in 1..=2_usize {
        let d = if (a / (S::from_f64(1.5) + f * f)).cmpge((a * r1[4])) {
            ((S::from_f64(i3 as f64) * S::from_f64(0.25))
                * ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * r1[i3 % 5]))
        } else {
            ((y * S::from_f64(0.375_f64)).abs() * (y * S::from_f64(-1.125_f64)).cos())
        };
        'l4: for i5 in (2..2_usize).step_by(2) {
            let b = ((r1[0] * S::from_f64(0.875_f64)).max(x)
                / (S::from_f64(1.5) + (-(r1[(i5 + 0) % 5])) * (-(r1[(i5 + 0) % 5]))));
        }
    }
    let (a, mut b) =
        (((S::from_f64(-0.375_f64) * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(), x);
    let b = program_48_of(
        (r1[1] + S::from_f64(0.125)).tanh(),
        (S::from_f64(-0.625_f64) + S::from_f64(0.125)).tanh(),
    )
    .tanh();
    let b = program_7_of(
        ((S::from_f64(-0.375_f64) - b) * S::from_f64(0.75)).sin(),
        (r1[1] * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let (a, mut b) = (
        ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        (S::from_f64(-0.875_f64) - S::from_f64(-0.875_f64)).tanh(),
    );
    ((-(x)) - S::from_f64(-0.375_f64)).tanh() + b + a + f + e + y + x
}

#[differentiable]
fn program_64(x: f64, y: f64) -> f64 {
    let mut b = ((y + 0.875_f64).sin() * 0.75).sin();
    let mut r1 = [((x * b) + 0.125).tanh(); 5];
    b *= (((x * 0.375_f64).abs() + (b + b)) * 0.75).sin();
    if r1[3] <= (r1[1] / (1.5 + x * x)) {
        let r2 = [((y * b) + 0.125).tanh(); 4];
        r1[3] -= (x + 0.125).tanh();
    } else {
        let d = if x >= b { ((b + x) - (y + b)) } else { b };
        'l3: for i4 in 1..=3_usize {
            'l5: for i6 in (i4..4_usize).step_by(2) {
                r1[i6 % 5] = (((r1[i4 % 5] * 0.625_f64).max(r1[4]) * 0.125_f64).cos() * 0.75).sin();
                let mut r7 = [(b + 0.125).tanh(); 5];
            }
            let mut n9 = 0_usize;
            'l8: while n9 < 5 {
                n9 += 1;
                let b = program_41(
                    ((((i4 as f64) * 0.25) * 0.375_f64).max(x) * 0.75).sin(),
                    ((b / (1.5 + r1[(n9 * n9 + 1) % 5] * r1[(n9 * n9 + 1) % 5])) + 0.125).tanh(),
                )
                .tanh();
                r1[0] = (((r1[(n9 + 4) % 5] * ((i4 as f64) * 0.25))
                    * (r1[(n9 + 4) % 5] * ((i4 as f64) * 0.25))
                    + 0.25)
                    .sqrt()
                    + 0.125)
                    .tanh();
            }
        }
    }
    'l10: for i11 in 0..2_usize {
        r1[(i11 + 0) % 5] =
            (((((i11 as f64) * 0.25) + r1[(i11 + 4) % 5]) - 0.375_f64).tanh() + 0.125).tanh();
        r1[1] = (((r1[i11 % 5] - b) - -0.125_f64).tanh() * 0.75).sin();
    }
    ((-(x)) - -0.125_f64).tanh() + b + y + x
}

fn program_64_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin();
    let mut r1 = [((x * b) + S::from_f64(0.125)).tanh(); 5];
    b = b * (((x * S::from_f64(0.375_f64)).abs() + (b + b)) * S::from_f64(0.75)).sin();
    if r1[3].cmple((r1[1] / (S::from_f64(1.5) + x * x))) {
        let r2 = [((y * b) + S::from_f64(0.125)).tanh(); 4];
        r1[3] = r1[3] - (x + S::from_f64(0.125)).tanh();
    } else {
        let d = if x.cmpge(b) { ((b + x) - (y + b)) } else { b };
        'l3: for i4 in 1..=3_usize {
            'l5: for i6 in (i4..4_usize).step_by(2) {
                r1[i6 % 5] = (((r1[i4 % 5] * S::from_f64(0.625_f64)).max(r1[4])
                    * S::from_f64(0.125_f64))
                .cos()
                    * S::from_f64(0.75))
                .sin();
                let mut r7 = [(b + S::from_f64(0.125)).tanh(); 5];
            }
            let mut n9 = 0_usize;
            'l8: while n9 < 5 {
                n9 += 1;
                let b = program_41_of(
                    (((S::from_f64(i4 as f64) * S::from_f64(0.25)) * S::from_f64(0.375_f64))
                        .max(x)
                        * S::from_f64(0.75))
                    .sin(),
                    ((b / (S::from_f64(1.5) + r1[(n9 * n9 + 1) % 5] * r1[(n9 * n9 + 1) % 5]))
                        + S::from_f64(0.125))
                    .tanh(),
                )
                .tanh();
                r1[0] = (((r1[(n9 + 4) % 5] * (S::from_f64(i4 as f64) * S::from_f64(0.25)))
                    * (r1[(n9 + 4) % 5] * (S::from_f64(i4 as f64) * S::from_f64(0.25)))
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh();
            }
        }
    }
    'l10: for i11 in 0..2_usize {
        r1[(i11 + 0) % 5] = ((((S::from_f64(i11 as f64) * S::from_f64(0.25)) + r1[(i11 + 4) % 5])
            - S::from_f64(0.375_f64))
        .tanh()
            + S::from_f64(0.125))
        .tanh();
        r1[1] = (((r1[i11 % 5] - b) - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin();
    }
    ((-(x)) - S::from_f64(-0.125_f64)).tanh() + b + y + x
}

#[differentiable]
fn program_65(x: f64, y: f64) -> f64 {
    let mut d = ((y * -0.625_f64).abs() + 0.125).tanh();
    let r1 = [((y - -1.125_f64).tanh() * 0.75).sin(); 5];
    let mut e = ((x * -0.375_f64).cos() + 0.125).tanh();
    d += (((d / (1.5 + e * e)) * (r1[0] * 0.125_f64).cos()) + 0.125).tanh();
    let mut c = ((y * e) + 0.125).tanh();
    'l2: for i3 in (2..0_usize).step_by(2) {
        if i3 % 4 == 0 {
            continue 'l2;
        }
    }
    if (e * 0.125_f64).cos() > (r1[2] * r1[4]) {
        e = (((y - 0.375_f64).tanh() / (1.5 + (r1[4] - r1[1]) * (r1[4] - r1[1]))) + 0.125).tanh();
    }
    'l4: for i5 in (2..2_usize).rev() {
        for v in r1.iter() {
            c = c * ((r1[2] * -0.875_f64).abs() * 0.75).sin()
                + *v * ((r1[2] * -0.875_f64).abs() * 0.75).sin();
        }
        let mut r6 = [
            ((y * ((i5 as f64) * 0.25)) + 0.125).tanh(),
            (e + 0.125).tanh(),
            ((c * y) * 0.75).sin(),
            ((x / (1.5 + r1[(i5 * i5 + 1) % 5] * r1[(i5 * i5 + 1) % 5])) * 0.75).sin(),
        ];
    }
    let g7 = |t: f64| ((r1[2] * x) - -0.375_f64).tanh() * t;
    let e = (g7((r1[1] * d)) + g7(r1[0])).sin();
    c = ((r1[4] + (y - 0.375_f64).tanh()) * 0.75).sin();
    c *= (((-(c)) * (r1[3] * x)) + 0.125).tanh();
    for v in r1.iter() {
        d = d * ((d + r1[2]) * 0.75).sin() + *v * ((d + r1[2]) * 0.75).sin();
    }
    -1.125_f64 + e + c + d + y + x
}

fn program_65_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh();
    let r1 = [((y - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(); 5];
    let mut e = ((x * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    d = d
        + (((d / (S::from_f64(1.5) + e * e)) * (r1[0] * S::from_f64(0.125_f64)).cos())
            + S::from_f64(0.125))
        .tanh();
    let mut c = ((y * e) + S::from_f64(0.125)).tanh();
    'l2: for i3 in (2..0_usize).step_by(2) {
        if i3 % 4 == 0 {
            continue 'l2;
        }
    }
    if (e * S::from_f64(0.125_f64)).cos().cmpgt((r1[2] * r1[4])) {
        e = (((y - S::from_f64(0.375_f64)).tanh()
            / (S::from_f64(1.5) + (r1[4] - r1[1]) * (r1[4] - r1[1])))
            + S::from_f64(0.125))
        .tanh();
    }
    'l4: for i5 in (2..2_usize).rev() {
        for v in r1.iter() {
            c = c * ((r1[2] * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin()
                + *v * ((r1[2] * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin();
        }
        let mut r6 = [
            ((y * (S::from_f64(i5 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
            (e + S::from_f64(0.125)).tanh(),
            ((c * y) * S::from_f64(0.75)).sin(),
            ((x / (S::from_f64(1.5) + r1[(i5 * i5 + 1) % 5] * r1[(i5 * i5 + 1) % 5]))
                * S::from_f64(0.75))
            .sin(),
        ];
    }
    let g7 = |t: S| ((r1[2] * x) - S::from_f64(-0.375_f64)).tanh() * t;
    let e = (g7((r1[1] * d)) + g7(r1[0])).sin();
    c = ((r1[4] + (y - S::from_f64(0.375_f64)).tanh()) * S::from_f64(0.75)).sin();
    c = c * (((-(c)) * (r1[3] * x)) + S::from_f64(0.125)).tanh();
    for v in r1.iter() {
        d = d * ((d + r1[2]) * S::from_f64(0.75)).sin()
            + *v * ((d + r1[2]) * S::from_f64(0.75)).sin();
    }
    S::from_f64(-1.125_f64) + e + c + d + y + x
}

#[differentiable]
fn program_66(x: f64, y: f64) -> f64 {
    let mut b = ((x / (1.5 + x * x)) + 0.125).tanh();
    let mut r1 = [((x + x) * 0.75).sin(); 4];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        if b >= (b + -1.125_f64).sin() {
            continue 'l2;
        }
        r1[0] = (b * 0.75).sin();
    }
    r1[2] += (((b + 0.875_f64).sin() * -0.375_f64).cos() * 0.75).sin();
    b = (((0.125_f64 * 0.125_f64 + 0.25).sqrt() - -0.875_f64).tanh() + 0.125).tanh();
    r1[3] = ((y - 0.875_f64).tanh() * 0.75).sin();
    let mut d = ((r1[2] - 0.125_f64).tanh() * 0.75).sin();
    if (r1[0] * r1[2]) > (b * b + 0.25).sqrt() {
        return r1[3];
    }
    'l4: for i5 in 0..5_usize {
        let (a, mut b) = (
            ((-1.125_f64 * 0.125_f64).cos() + 0.125).tanh(),
            (((i5 as f64) * 0.25) * ((i5 as f64) * 0.25)),
        );
        let f: f64 = r1.iter().map(|v| v * ((d / (1.5 + y * y)) * 0.75).sin()).sum();
    }
    let (a, mut b) = (((b + x) + 0.125).tanh(), (b + 0.125_f64).sin());
    'l6: for i7 in 0..=2_usize {
        'l8: for i9 in (i7..4_usize).step_by(2) {
            let mut b = (d + 0.125).tanh();
            d += (((-(-0.875_f64)) * -0.125_f64).cos() * 0.75).sin();
        }
        for v in r1.iter() {
            b = b * ((0.875_f64 - 0.625_f64).tanh() * 0.75).sin()
                + *v * ((0.875_f64 - 0.625_f64).tanh() * 0.75).sin();
        }
    }
    ((d - a) * (d - a) + 0.25).sqrt() + b + a + d + y + x
}

fn program_66_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x + x) * S::from_f64(0.75)).sin(); 4];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        if b.cmpge((b + S::from_f64(-1.125_f64)).sin()) {
            continue 'l2;
        }
        r1[0] = (b * S::from_f64(0.75)).sin();
    }
    r1[2] = r1[2]
        + (((b + S::from_f64(0.875_f64)).sin() * S::from_f64(-0.375_f64)).cos()
            * S::from_f64(0.75))
        .sin();
    b = (((S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt()
        - S::from_f64(-0.875_f64))
    .tanh()
        + S::from_f64(0.125))
    .tanh();
    r1[3] = ((y - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut d = ((r1[2] - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
    if (r1[0] * r1[2]).cmpgt((b * b + S::from_f64(0.25)).sqrt()) {
        return r1[3];
    }
    'l4: for i5 in 0..5_usize {
        let (a, mut b) = (
            ((S::from_f64(-1.125_f64) * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
            ((S::from_f64(i5 as f64) * S::from_f64(0.25))
                * (S::from_f64(i5 as f64) * S::from_f64(0.25))),
        );
        let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
            s + *v * ((d / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin()
        });
    }
    let (a, mut b) = (((b + x) + S::from_f64(0.125)).tanh(), (b + S::from_f64(0.125_f64)).sin());
    'l6: for i7 in 0..=2_usize {
        'l8: for i9 in (i7..4_usize).step_by(2) {
            let mut b = (d + S::from_f64(0.125)).tanh();
            d = d
                + (((-(S::from_f64(-0.875_f64))) * S::from_f64(-0.125_f64)).cos()
                    * S::from_f64(0.75))
                .sin();
        }
        for v in r1.iter() {
            b = b
                * ((S::from_f64(0.875_f64) - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75))
                    .sin()
                + *v * ((S::from_f64(0.875_f64) - S::from_f64(0.625_f64)).tanh()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    ((d - a) * (d - a) + S::from_f64(0.25)).sqrt() + b + a + d + y + x
}

#[differentiable]
fn program_67(x: f64, y: f64) -> f64 {
    let mut d = ((x * -1.125_f64).abs() * 0.75).sin();
    let mut r1 = [
        (y + 0.125).tanh(),
        (x + 0.125).tanh(),
        ((y - y) + 0.125).tanh(),
        ((x + 0.375_f64).sin() + 0.125).tanh(),
    ];
    let b = if (y + 0.625_f64).sin() <= 0.375_f64 {
        0.625_f64
    } else {
        ((x * -0.125_f64).abs() * 0.875_f64).cos()
    };
    d = (((-0.375_f64 * r1[3]) * -0.125_f64).cos() * 0.75).sin();
    let mut e = ((b + d) + 0.125).tanh();
    if (e / (1.5 + r1[1] * r1[1])) <= (r1[3] * -0.375_f64).max(r1[2]) {
        return ((d - -0.125_f64).tanh() * -0.375_f64).cos();
    }
    let (a, mut b) = (((r1[1] * b) + 0.125).tanh(), (r1[0] + -0.875_f64).sin());
    let (a, mut b) = ((r1[1] + 0.125).tanh(), e);
    let f = r1[3];
    let a = if (d / (1.5 + x * x)) < (b - 0.625_f64).tanh() {
        ((y * 0.875_f64).cos() * (y * 0.875_f64).cos() + 0.25).sqrt()
    } else {
        (e - -0.125_f64).tanh()
    };
    e *= (((r1[2] * r1[2] + 0.25).sqrt() * (r1[2] * r1[2] + 0.25).sqrt() + 0.25).sqrt() * 0.75)
        .sin();
    r1[1] *= (((x * -0.375_f64).abs() * (b * -0.125_f64).max(-0.375_f64)) * 0.75).sin();
    if f >= (f * 0.625_f64).abs() {
        r1[3] += (((r1[1] - r1[2]) * 0.625_f64).cos() + 0.125).tanh();
    } else {
        let a = e;
    }
    'l2: for i3 in (0..4_usize).step_by(2) {
        if (((i3 as f64) * 0.25) * -0.125_f64).max(f)
            <= (e / (1.5 + r1[(i3 + 1) % 4] * r1[(i3 + 1) % 4]))
        {
            continue 'l2;
        }
        let d =
            program_35((((i3 as f64) * 0.25) * 0.75).sin(), ((-(-0.125_f64)) * 0.75).sin()).tanh();
    }
    ((e * 0.375_f64) * (r1[0] + 0.875_f64).sin()) + a + f + b + e + d + y + x
}

fn program_67_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 = [
        (y + S::from_f64(0.125)).tanh(),
        (x + S::from_f64(0.125)).tanh(),
        ((y - y) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
    ];
    let b = if (y + S::from_f64(0.625_f64)).sin().cmple(S::from_f64(0.375_f64)) {
        S::from_f64(0.625_f64)
    } else {
        ((x * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.875_f64)).cos()
    };
    d = (((S::from_f64(-0.375_f64) * r1[3]) * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75))
        .sin();
    let mut e = ((b + d) + S::from_f64(0.125)).tanh();
    if (e / (S::from_f64(1.5) + r1[1] * r1[1])).cmple((r1[3] * S::from_f64(-0.375_f64)).max(r1[2]))
    {
        return ((d - S::from_f64(-0.125_f64)).tanh() * S::from_f64(-0.375_f64)).cos();
    }
    let (a, mut b) =
        (((r1[1] * b) + S::from_f64(0.125)).tanh(), (r1[0] + S::from_f64(-0.875_f64)).sin());
    let (a, mut b) = ((r1[1] + S::from_f64(0.125)).tanh(), e);
    let f = r1[3];
    let a = if (d / (S::from_f64(1.5) + x * x)).cmplt((b - S::from_f64(0.625_f64)).tanh()) {
        ((y * S::from_f64(0.875_f64)).cos() * (y * S::from_f64(0.875_f64)).cos()
            + S::from_f64(0.25))
        .sqrt()
    } else {
        (e - S::from_f64(-0.125_f64)).tanh()
    };
    e = e
        * (((r1[2] * r1[2] + S::from_f64(0.25)).sqrt()
            * (r1[2] * r1[2] + S::from_f64(0.25)).sqrt()
            + S::from_f64(0.25))
        .sqrt()
            * S::from_f64(0.75))
        .sin();
    r1[1] = r1[1]
        * (((x * S::from_f64(-0.375_f64)).abs()
            * (b * S::from_f64(-0.125_f64)).max(S::from_f64(-0.375_f64)))
            * S::from_f64(0.75))
        .sin();
    if f.cmpge((f * S::from_f64(0.625_f64)).abs()) {
        r1[3] =
            r1[3] + (((r1[1] - r1[2]) * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh();
    } else {
        let a = e;
    }
    'l2: for i3 in (0..4_usize).step_by(2) {
        if ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.125_f64))
            .max(f)
            .cmple((e / (S::from_f64(1.5) + r1[(i3 + 1) % 4] * r1[(i3 + 1) % 4])))
        {
            continue 'l2;
        }
        let d = program_35_of(
            ((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin(),
            ((-(S::from_f64(-0.125_f64))) * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    ((e * S::from_f64(0.375_f64)) * (r1[0] + S::from_f64(0.875_f64)).sin())
        + a
        + f
        + b
        + e
        + d
        + y
        + x
}

#[differentiable]
fn program_68(x: f64, y: f64) -> f64 {
    let mut e = ((0.125_f64 * y) * 0.75).sin();
    let mut r1 = [
        (x * 0.75).sin(),
        (-0.625_f64 + 0.125).tanh(),
        ((-(e)) * 0.75).sin(),
        ((y + -0.625_f64).sin() + 0.125).tanh(),
        ((y * x) * 0.75).sin(),
    ];
    if (y - e) >= (r1[2] - 0.625_f64).tanh() {
        'l2: for i3 in 1..0_usize {
            e += (((x - e) * (r1[4] - r1[(i3 + 0) % 5])) + 0.125).tanh();
            r1[i3 % 5] += (((r1[(i3 * i3 + 1) % 5] * y) - 0.125_f64).tanh() + 0.125).tanh();
        }
        let b = if (-(r1[2])) < (-0.125_f64 - -0.375_f64).tanh() {
            ((0.125_f64 * e) * (e + e))
        } else {
            ((r1[1] * -1.125_f64).abs() - (y - -0.625_f64).tanh())
        };
        'l4: for i5 in 0..0_usize {
            r1[1] -= (((r1[2] * r1[2] + 0.25).sqrt() - 0.875_f64).tanh() * 0.75).sin();
            'l6: for i7 in (i5..4_usize).rev() {
                r1[i7 % 5] = (((e + -0.875_f64).sin() / (1.5 + (y * x) * (y * x))) + 0.125).tanh();
            }
            let (a, mut b) = ((b * 0.75).sin(), x);
        }
    }
    if (r1[0] * r1[2]) >= (0.125_f64 * r1[1]) {
        let f = ((e * e + 0.25).sqrt() * (x * 0.875_f64).cos());
        let mut n9 = 0_usize;
        'l8: while n9 < 3 {
            n9 += 1;
            let (a, mut b) = ((e * 0.75).sin(), (((n9 as f64) * 0.25) * -0.625_f64).cos());
            if n9 % 2 == 0 {
                break;
            }
            if (e * -0.375_f64).max(e) >= (a * 0.875_f64) {
                r1[(n9 * n9 + 1) % 5] =
                    (((r1[(n9 + 2) % 5] + -0.625_f64).sin() * 0.125_f64).cos() + 0.125).tanh();
                r1[(n9 * n9 + 1) % 5] *=
                    (((x * 0.875_f64).cos() * (r1[(n9 * n9 + 1) % 5] * -1.125_f64)) + 0.125).tanh();
                let a = program_21(
                    ((r1[(n9 * n9 + 1) % 5] * r1[(n9 + 1) % 5]) + 0.125).tanh(),
                    (r1[(n9 + 4) % 5] + 0.125).tanh(),
                )
                .tanh();
            } else {
                let f = ((e - -1.125_f64) - -0.125_f64).tanh();
            }
        }
    }
    ((r1[1] + e) * (e * e)) + e + y + x
}

fn program_68_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((S::from_f64(0.125_f64) * y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        (x * S::from_f64(0.75)).sin(),
        (S::from_f64(-0.625_f64) + S::from_f64(0.125)).tanh(),
        ((-(e)) * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y * x) * S::from_f64(0.75)).sin(),
    ];
    if (y - e).cmpge((r1[2] - S::from_f64(0.625_f64)).tanh()) {
        'l2: for i3 in 1..0_usize {
            e = e + (((x - e) * (r1[4] - r1[(i3 + 0) % 5])) + S::from_f64(0.125)).tanh();
            r1[i3 % 5] = r1[i3 % 5]
                + (((r1[(i3 * i3 + 1) % 5] * y) - S::from_f64(0.125_f64)).tanh()
                    + S::from_f64(0.125))
                .tanh();
        }
        let b = if (-(r1[2])).cmplt((S::from_f64(-0.125_f64) - S::from_f64(-0.375_f64)).tanh()) {
            ((S::from_f64(0.125_f64) * e) * (e + e))
        } else {
            ((r1[1] * S::from_f64(-1.125_f64)).abs() - (y - S::from_f64(-0.625_f64)).tanh())
        };
        'l4: for i5 in 0..0_usize {
            r1[1] = r1[1]
                - (((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() - S::from_f64(0.875_f64)).tanh()
                    * S::from_f64(0.75))
                .sin();
            'l6: for i7 in (i5..4_usize).rev() {
                r1[i7 % 5] = (((e + S::from_f64(-0.875_f64)).sin()
                    / (S::from_f64(1.5) + (y * x) * (y * x)))
                    + S::from_f64(0.125))
                .tanh();
            }
            let (a, mut b) = ((b * S::from_f64(0.75)).sin(), x);
        }
    }
    if (r1[0] * r1[2]).cmpge((S::from_f64(0.125_f64) * r1[1])) {
        let f = ((e * e + S::from_f64(0.25)).sqrt() * (x * S::from_f64(0.875_f64)).cos());
        let mut n9 = 0_usize;
        'l8: while n9 < 3 {
            n9 += 1;
            let (a, mut b) = (
                (e * S::from_f64(0.75)).sin(),
                ((S::from_f64(n9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).cos(),
            );
            if n9 % 2 == 0 {
                break;
            }
            if (e * S::from_f64(-0.375_f64)).max(e).cmpge((a * S::from_f64(0.875_f64))) {
                r1[(n9 * n9 + 1) % 5] = (((r1[(n9 + 2) % 5] + S::from_f64(-0.625_f64)).sin()
                    * S::from_f64(0.125_f64))
                .cos()
                    + S::from_f64(0.125))
                .tanh();
                r1[(n9 * n9 + 1) % 5] = r1[(n9 * n9 + 1) % 5]
                    * (((x * S::from_f64(0.875_f64)).cos()
                        * (r1[(n9 * n9 + 1) % 5] * S::from_f64(-1.125_f64)))
                        + S::from_f64(0.125))
                    .tanh();
                let a = program_21_of(
                    ((r1[(n9 * n9 + 1) % 5] * r1[(n9 + 1) % 5]) + S::from_f64(0.125)).tanh(),
                    (r1[(n9 + 4) % 5] + S::from_f64(0.125)).tanh(),
                )
                .tanh();
            } else {
                let f = ((e - S::from_f64(-1.125_f64)) - S::from_f64(-0.125_f64)).tanh();
            }
        }
    }
    ((r1[1] + e) * (e * e)) + e + y + x
}

#[differentiable]
fn program_69(x: f64, y: f64) -> f64 {
    let mut c = ((-(y)) * 0.75).sin();
    let r1 = [
        ((y * y + 0.25).sqrt() + 0.125).tanh(),
        ((x * 0.375_f64).cos() * 0.75).sin(),
        ((y * -0.375_f64).cos() + 0.125).tanh(),
        ((-1.125_f64 + x) * 0.75).sin(),
    ];
    let e = if (c * r1[0]) >= (c * r1[3]) {
        ((y * r1[0]) / (1.5 + (r1[1] + y) * (r1[1] + y)))
    } else {
        (x + (y * y + 0.25).sqrt())
    };
    c -= (((r1[1] - -1.125_f64).tanh() + (r1[1] * r1[1] + 0.25).sqrt()) * 0.75).sin();
    let f = if (x - -0.875_f64).tanh() <= (r1[0] * r1[0] + 0.25).sqrt() {
        ((r1[1] * r1[2]) + (c * r1[1]))
    } else {
        x
    };
    let f: f64 = r1.iter().map(|v| v * ((r1[0] * 0.375_f64).max(c) + 0.125).tanh()).sum();
    let (a, mut b) = (((r1[3] * -0.875_f64).max(r1[2]) * 0.75).sin(), (-0.875_f64 * r1[0]));
    'l2: for i3 in (2..3_usize).step_by(2) {
        let d = if (-(r1[3])) <= e { ((((i3 as f64) * 0.25) * -0.625_f64).cos() * b) } else { c };
        let r4 = [((r1[i3 % 4] - -0.125_f64).tanh() * 0.75).sin(); 5];
        c *= ((-((r1[(i3 + 2) % 4] * -0.625_f64).cos())) + 0.125).tanh();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        'l7: for i8 in (2..2_usize).step_by(2) {
            let mut r9 = [((r1[(i8 * i8 + 1) % 4] * 0.875_f64).max(y) + 0.125).tanh(); 5];
            let mut b = ((r9[(i8 + 3) % 5] + -0.375_f64).sin() * 0.75).sin();
            b *= ((a * (x - -0.875_f64).tanh()) * 0.75).sin();
        }
    }
    ((y + -0.875_f64).sin() * (x - -0.625_f64).tanh()) + b + a + f + e + c + y + x
}

fn program_69_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((-(y)) * S::from_f64(0.75)).sin();
    let r1 = [
        ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-1.125_f64) + x) * S::from_f64(0.75)).sin(),
    ];
    let e = if (c * r1[0]).cmpge((c * r1[3])) {
        ((y * r1[0]) / (S::from_f64(1.5) + (r1[1] + y) * (r1[1] + y)))
    } else {
        (x + (y * y + S::from_f64(0.25)).sqrt())
    };
    c = c
        - (((r1[1] - S::from_f64(-1.125_f64)).tanh() + (r1[1] * r1[1] + S::from_f64(0.25)).sqrt())
            * S::from_f64(0.75))
        .sin();
    let f =
        if (x - S::from_f64(-0.875_f64)).tanh().cmple((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) {
            ((r1[1] * r1[2]) + (c * r1[1]))
        } else {
            x
        };
    let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[0] * S::from_f64(0.375_f64)).max(c) + S::from_f64(0.125)).tanh()
    });
    let (a, mut b) = (
        ((r1[3] * S::from_f64(-0.875_f64)).max(r1[2]) * S::from_f64(0.75)).sin(),
        (S::from_f64(-0.875_f64) * r1[0]),
    );
    'l2: for i3 in (2..3_usize).step_by(2) {
        let d = if (-(r1[3])).cmple(e) {
            (((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).cos() * b)
        } else {
            c
        };
        let r4 = [((r1[i3 % 4] - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(); 5];
        c = c
            * ((-((r1[(i3 + 2) % 4] * S::from_f64(-0.625_f64)).cos())) + S::from_f64(0.125)).tanh();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 2 {
        n6 += 1;
        'l7: for i8 in (2..2_usize).step_by(2) {
            let mut r9 = [((r1[(i8 * i8 + 1) % 4] * S::from_f64(0.875_f64)).max(y)
                + S::from_f64(0.125))
            .tanh(); 5];
            let mut b =
                ((r9[(i8 + 3) % 5] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin();
            b = b * ((a * (x - S::from_f64(-0.875_f64)).tanh()) * S::from_f64(0.75)).sin();
        }
    }
    ((y + S::from_f64(-0.875_f64)).sin() * (x - S::from_f64(-0.625_f64)).tanh())
        + b
        + a
        + f
        + e
        + c
        + y
        + x
}

#[differentiable]
fn program_70(x: f64, y: f64) -> f64 {
    let mut e = ((x * y) * 0.75).sin();
    let mut r1 = [((y * -0.875_f64).cos() + 0.125).tanh(); 2];
    let d = if (y + e) < (r1[0] + -0.375_f64).sin() {
        ((0.125_f64 * y) * -0.625_f64).max(y)
    } else {
        ((e * y) / (1.5 + (e + e) * (e + e)))
    };
    r1[0] *= (r1[1] * 0.75).sin();
    let mut d = (r1[0] * 0.75).sin();
    let (a, mut b) = (((r1[0] + -0.625_f64).sin() * 0.75).sin(), x);
    d *= (-1.125_f64 + 0.125).tanh();
    b = (((r1[1] * r1[1] + 0.25).sqrt() * -0.875_f64).max(a) + 0.125).tanh();
    let mut e = ((r1[1] * -0.125_f64).max(r1[0]) + 0.125).tanh();
    'l2: for i3 in (0..0_usize).rev() {
        if (b + b) <= (-0.875_f64 * -0.375_f64) {
            let c = program_32(
                ((-0.125_f64 * -0.875_f64).cos() + 0.125).tanh(),
                ((a + d) + 0.125).tanh(),
            )
            .tanh();
        }
    }
    'l4: for i5 in (1..3_usize).step_by(2) {
        let mut r6 = [((r1[i5 % 2] * -0.875_f64).abs() * 0.75).sin(); 5];
    }
    let mut n8 = 0_usize;
    'l7: while n8 < 5 {
        n8 += 1;
        r1[(n8 * n8 + 1) % 2] += ((0.375_f64 * 0.625_f64).cos() * 0.75).sin();
    }
    ((r1[1] * x) - (b - 0.375_f64).tanh()) + e + b + a + d + y + x
}

fn program_70_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125)).tanh(); 2];
    let d = if (y + e).cmplt((r1[0] + S::from_f64(-0.375_f64)).sin()) {
        ((S::from_f64(0.125_f64) * y) * S::from_f64(-0.625_f64)).max(y)
    } else {
        ((e * y) / (S::from_f64(1.5) + (e + e) * (e + e)))
    };
    r1[0] = r1[0] * (r1[1] * S::from_f64(0.75)).sin();
    let mut d = (r1[0] * S::from_f64(0.75)).sin();
    let (a, mut b) = (((r1[0] + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(), x);
    d = d * (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh();
    b = (((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(-0.875_f64)).max(a)
        + S::from_f64(0.125))
    .tanh();
    let mut e = ((r1[1] * S::from_f64(-0.125_f64)).max(r1[0]) + S::from_f64(0.125)).tanh();
    'l2: for i3 in (0..0_usize).rev() {
        if (b + b).cmple((S::from_f64(-0.875_f64) * S::from_f64(-0.375_f64))) {
            let c = program_32_of(
                ((S::from_f64(-0.125_f64) * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125))
                    .tanh(),
                ((a + d) + S::from_f64(0.125)).tanh(),
            )
            .tanh();
        }
    }
    'l4: for i5 in (1..3_usize).step_by(2) {
        let mut r6 = [((r1[i5 % 2] * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(); 5];
    }
    let mut n8 = 0_usize;
    'l7: while n8 < 5 {
        n8 += 1;
        r1[(n8 * n8 + 1) % 2] = r1[(n8 * n8 + 1) % 2]
            + ((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin();
    }
    ((r1[1] * x) - (b - S::from_f64(0.375_f64)).tanh()) + e + b + a + d + y + x
}

#[differentiable]
fn program_71(x: f64, y: f64) -> f64 {
    let mut c = ((-(x)) * 0.75).sin();
    let mut r1 =
        [((x * c) + 0.125).tanh(), ((c + c) * 0.75).sin(), ((c * c + 0.25).sqrt() * 0.75).sin()];
    c -= (((y * c) * -0.625_f64).abs() + 0.125).tanh();
    let b = program_20(((-(c)) + 0.125).tanh(), ((c + r1[0]) * 0.75).sin()).tanh();
    c += ((-(r1[1] - b)) * 0.75).sin();
    r1[1] -= (((-0.375_f64 + x) * 0.625_f64).cos() * 0.75).sin();
    let f: f64 = r1.iter().map(|v| v * ((r1[2] * -0.625_f64).max(y) + 0.125).tanh()).sum();
    r1[0] = (r1[0] * 0.75).sin();
    if (r1[0] * r1[2]) > (x / (1.5 + x * x)) {
        c += (((x * r1[2]) * (x * r1[2]) + 0.25).sqrt() * 0.75).sin();
    }
    if r1[2] > (r1[1] * 0.625_f64).cos() {
        return ((r1[1] - r1[2]) * (r1[0] - r1[1]));
    }
    if y > x {
        return ((b - y) * (y - -0.375_f64).tanh());
    }
    'l2: for i3 in 1..2_usize {
        if (((i3 as f64) * 0.25) / (1.5 + r1[(i3 * i3 + 1) % 3] * r1[(i3 * i3 + 1) % 3])) <= b {
            continue 'l2;
        }
        c *= (f * 0.75).sin();
        let d = program_7(((y + -0.375_f64).sin() + 0.125).tanh(), ((b - c) * 0.75).sin()).tanh();
    }
    (f - (y * c)) + f + b + c + y + x
}

fn program_71_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((-(x)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x * c) + S::from_f64(0.125)).tanh(),
        ((c + c) * S::from_f64(0.75)).sin(),
        ((c * c + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
    ];
    c = c - (((y * c) * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh();
    let b = program_20_of(
        ((-(c)) + S::from_f64(0.125)).tanh(),
        ((c + r1[0]) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    c = c + ((-(r1[1] - b)) * S::from_f64(0.75)).sin();
    r1[1] = r1[1]
        - (((S::from_f64(-0.375_f64) + x) * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75))
            .sin();
    let f = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((r1[2] * S::from_f64(-0.625_f64)).max(y) + S::from_f64(0.125)).tanh()
    });
    r1[0] = (r1[0] * S::from_f64(0.75)).sin();
    if (r1[0] * r1[2]).cmpgt((x / (S::from_f64(1.5) + x * x))) {
        c = c + (((x * r1[2]) * (x * r1[2]) + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    }
    if r1[2].cmpgt((r1[1] * S::from_f64(0.625_f64)).cos()) {
        return ((r1[1] - r1[2]) * (r1[0] - r1[1]));
    }
    if y.cmpgt(x) {
        return ((b - y) * (y - S::from_f64(-0.375_f64)).tanh());
    }
    'l2: for i3 in 1..2_usize {
        if ((S::from_f64(i3 as f64) * S::from_f64(0.25))
            / (S::from_f64(1.5) + r1[(i3 * i3 + 1) % 3] * r1[(i3 * i3 + 1) % 3]))
            .cmple(b)
        {
            continue 'l2;
        }
        c = c * (f * S::from_f64(0.75)).sin();
        let d = program_7_of(
            ((y + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
            ((b - c) * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    (f - (y * c)) + f + b + c + y + x
}

#[differentiable]
fn program_72(x: f64, y: f64) -> f64 {
    let mut e = ((y / (1.5 + -0.875_f64 * -0.875_f64)) + 0.125).tanh();
    let mut r1 = [((e / (1.5 + e * e)) + 0.125).tanh(); 2];
    let b = if (e * e + 0.25).sqrt() > (r1[0] + y) {
        ((e * -1.125_f64).abs() * (y + x))
    } else {
        (-((y * -0.625_f64).abs()))
    };
    if e < (r1[1] * x) {
        return ((x + b) - -0.375_f64).tanh();
    }
    let mut r2 = [
        ((r1[0] * 0.625_f64).max(-0.125_f64) * 0.75).sin(),
        ((x + y) * 0.75).sin(),
        ((r1[1] * -1.125_f64).max(y) + 0.125).tanh(),
        ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh(),
        ((e * -1.125_f64).abs() * 0.75).sin(),
    ];
    'l3: for i4 in (1..0_usize).step_by(2) {
        'l5: for i6 in 0..=2_usize {
            for v in r2.iter() {
                e = e * ((((i4 as f64) * 0.25) / (1.5 + b * b)) + 0.125).tanh()
                    + *v * ((((i4 as f64) * 0.25) / (1.5 + b * b)) + 0.125).tanh();
            }
        }
        let mut n8 = 0_usize;
        'l7: while n8 < 5 {
            n8 += 1;
            let mut n10 = 0_usize;
            'l9: while n10 < 5 {
                n10 += 1;
                let a = program_5(((-(-0.625_f64)) * 0.75).sin(), (r2[4] + 0.125).tanh()).tanh();
                r2[n10 % 5] = (((r1[(i4 * i4 + 1) % 2] * a) - -1.125_f64).tanh() * 0.75).sin();
            }
        }
    }
    r1[0] = (((r2[1] - y) * (r2[0] * -0.125_f64).cos()) + 0.125).tanh();
    e -= (r1[0] * 0.75).sin();
    let mut n12 = 0_usize;
    'l11: while n12 < 5 {
        n12 += 1;
        for v in r1.iter() {
            e = e * ((((n12 as f64) * 0.25) * r1[0]) * 0.75).sin()
                + *v * ((((n12 as f64) * 0.25) * r1[0]) * 0.75).sin();
        }
        'l13: for i14 in (n12..4_usize).step_by(2) {
            'l15: for i16 in (2..0_usize).rev() {
                e += (((-1.125_f64 + y) + (x * 0.125_f64).abs()) * 0.75).sin();
            }
            e *= ((r2[4] * -0.125_f64).max(e) * 0.75).sin();
            let c = if (b * b) >= (-(r2[2])) {
                y
            } else {
                ((((n12 as f64) * 0.25) - 0.875_f64).tanh() / (1.5 + (-(b)) * (-(b))))
            };
        }
        if (y + r2[(n12 + 3) % 5]) > (y * e) {
            r1[(n12 * n12 + 1) % 2] +=
                (((y * r2[(n12 * n12 + 1) % 5]) * (r1[n12 % 2] * b)) * 0.75).sin();
        }
    }
    ((e * -0.625_f64).cos() * (-(e))) + b + e + y + x
}

fn program_72_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((y / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64)))
        + S::from_f64(0.125))
    .tanh();
    let mut r1 = [((e / (S::from_f64(1.5) + e * e)) + S::from_f64(0.125)).tanh(); 2];
    let b = if (e * e + S::from_f64(0.25)).sqrt().cmpgt((r1[0] + y)) {
        ((e * S::from_f64(-1.125_f64)).abs() * (y + x))
    } else {
        (-((y * S::from_f64(-0.625_f64)).abs()))
    };
    if e.cmplt((r1[1] * x)) {
        return ((x + b) - S::from_f64(-0.375_f64)).tanh();
    }
    let mut r2 = [
        ((r1[0] * S::from_f64(0.625_f64)).max(S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        ((x + y) * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(-1.125_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((e * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    'l3: for i4 in (1..0_usize).step_by(2) {
        'l5: for i6 in 0..=2_usize {
            for v in r2.iter() {
                e = e
                    * (((S::from_f64(i4 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + b * b))
                        + S::from_f64(0.125))
                    .tanh()
                    + *v * (((S::from_f64(i4 as f64) * S::from_f64(0.25))
                        / (S::from_f64(1.5) + b * b))
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
        let mut n8 = 0_usize;
        'l7: while n8 < 5 {
            n8 += 1;
            let mut n10 = 0_usize;
            'l9: while n10 < 5 {
                n10 += 1;
                let a = program_5_of(
                    ((-(S::from_f64(-0.625_f64))) * S::from_f64(0.75)).sin(),
                    (r2[4] + S::from_f64(0.125)).tanh(),
                )
                .tanh();
                r2[n10 % 5] = (((r1[(i4 * i4 + 1) % 2] * a) - S::from_f64(-1.125_f64)).tanh()
                    * S::from_f64(0.75))
                .sin();
            }
        }
    }
    r1[0] = (((r2[1] - y) * (r2[0] * S::from_f64(-0.125_f64)).cos()) + S::from_f64(0.125)).tanh();
    e = e - (r1[0] * S::from_f64(0.75)).sin();
    let mut n12 = 0_usize;
    'l11: while n12 < 5 {
        n12 += 1;
        for v in r1.iter() {
            e = e
                * (((S::from_f64(n12 as f64) * S::from_f64(0.25)) * r1[0]) * S::from_f64(0.75))
                    .sin()
                + *v * (((S::from_f64(n12 as f64) * S::from_f64(0.25)) * r1[0])
                    * S::from_f64(0.75))
                .sin();
        }
        'l13: for i14 in (n12..4_usize).step_by(2) {
            'l15: for i16 in (2..0_usize).rev() {
                e = e
                    + (((S::from_f64(-1.125_f64) + y) + (x * S::from_f64(0.125_f64)).abs())
                        * S::from_f64(0.75))
                    .sin();
            }
            e = e * ((r2[4] * S::from_f64(-0.125_f64)).max(e) * S::from_f64(0.75)).sin();
            let c = if (b * b).cmpge((-(r2[2]))) {
                y
            } else {
                (((S::from_f64(n12 as f64) * S::from_f64(0.25)) - S::from_f64(0.875_f64)).tanh()
                    / (S::from_f64(1.5) + (-(b)) * (-(b))))
            };
        }
        if (y + r2[(n12 + 3) % 5]).cmpgt((y * e)) {
            r1[(n12 * n12 + 1) % 2] = r1[(n12 * n12 + 1) % 2]
                + (((y * r2[(n12 * n12 + 1) % 5]) * (r1[n12 % 2] * b)) * S::from_f64(0.75)).sin();
        }
    }
    ((e * S::from_f64(-0.625_f64)).cos() * (-(e))) + b + e + y + x
}

#[differentiable]
fn program_73(x: f64, y: f64) -> f64 {
    let mut b = ((y * -0.625_f64).abs() * 0.75).sin();
    let mut r1 = [((-(x)) * 0.75).sin(); 3];
    r1[2] = (y + 0.125).tanh();
    'l2: for i3 in (0..5_usize).step_by(2) {
        r1[(i3 + 2) % 3] = (y * 0.75).sin();
    }
    r1[2] += (((y * r1[0]) * (x - b)) + 0.125).tanh();
    'l4: for i5 in 1..=3_usize {
        let mut r6 = [((r1[i5 % 3] + -0.375_f64).sin() * 0.75).sin(); 5];
        b *= (((r1[(i5 * i5 + 1) % 3] * b) - 0.625_f64).tanh() + 0.125).tanh();
    }
    let (a, mut b) = (((r1[0] - -1.125_f64).tanh() * 0.75).sin(), (r1[1] + -0.375_f64).sin());
    if (a + -0.625_f64).sin() <= (r1[2] + b) {
        return ((-0.125_f64 + r1[2]) - (y + 0.375_f64).sin());
    }
    if (a * a) < (a * -0.375_f64).max(r1[0]) {
        return (x - (-0.125_f64 + r1[0]));
    }
    let a: f64 = r1.iter().map(|v| v * ((y * r1[0]) + 0.125).tanh()).sum();
    'l7: for i8 in 0..=0_usize {
        b = ((((i8 as f64) * 0.25) / (1.5 + (y * y + 0.25).sqrt() * (y * y + 0.25).sqrt())) * 0.75)
            .sin();
        if r1[(i8 * i8 + 1) % 3] <= (b * 0.875_f64).abs() {
            break 'l7;
        }
        if (0.625_f64 * -0.125_f64).max(r1[(i8 * i8 + 1) % 3])
            >= (((i8 as f64) * 0.25) * 0.625_f64).max(b)
        {
            let mut n10 = 0_usize;
            'l9: while n10 < 5 {
                n10 += 1;
                b *= (((y * y + 0.25).sqrt() * (y * -0.875_f64).cos()) * 0.75).sin();
                b = (((x + x) * (-(y))) * 0.75).sin();
                b *= (((x + y) * (r1[(i8 * i8 + 1) % 3] + 0.875_f64).sin()) * 0.75).sin();
            }
            'l11: for i12 in i8..=3_usize {
                let a = (r1[i8 % 3] * (r1[2] + -1.125_f64).sin());
                b -= (r1[2] * 0.75).sin();
                let d = program_30(
                    ((-0.875_f64 * r1[(i8 * i8 + 1) % 3]) + 0.125).tanh(),
                    ((r1[(i12 + 2) % 3] * -0.125_f64).max(0.375_f64) + 0.125).tanh(),
                )
                .tanh();
            }
            b = (((0.875_f64 * -0.875_f64).abs() - a) + 0.125).tanh();
        }
    }
    ((0.625_f64 + y) * (0.625_f64 + y) + 0.25).sqrt() + a + b + y + x
}

fn program_73_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 = [((-(x)) * S::from_f64(0.75)).sin(); 3];
    r1[2] = (y + S::from_f64(0.125)).tanh();
    'l2: for i3 in (0..5_usize).step_by(2) {
        r1[(i3 + 2) % 3] = (y * S::from_f64(0.75)).sin();
    }
    r1[2] = r1[2] + (((y * r1[0]) * (x - b)) + S::from_f64(0.125)).tanh();
    'l4: for i5 in 1..=3_usize {
        let mut r6 = [((r1[i5 % 3] + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(); 5];
        b = b
            * (((r1[(i5 * i5 + 1) % 3] * b) - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125))
                .tanh();
    }
    let (a, mut b) = (
        ((r1[0] - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        (r1[1] + S::from_f64(-0.375_f64)).sin(),
    );
    if (a + S::from_f64(-0.625_f64)).sin().cmple((r1[2] + b)) {
        return ((S::from_f64(-0.125_f64) + r1[2]) - (y + S::from_f64(0.375_f64)).sin());
    }
    if (a * a).cmplt((a * S::from_f64(-0.375_f64)).max(r1[0])) {
        return (x - (S::from_f64(-0.125_f64) + r1[0]));
    }
    let a = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * ((y * r1[0]) + S::from_f64(0.125)).tanh());
    'l7: for i8 in 0..=0_usize {
        b = (((S::from_f64(i8 as f64) * S::from_f64(0.25))
            / (S::from_f64(1.5)
                + (y * y + S::from_f64(0.25)).sqrt() * (y * y + S::from_f64(0.25)).sqrt()))
            * S::from_f64(0.75))
        .sin();
        if r1[(i8 * i8 + 1) % 3].cmple((b * S::from_f64(0.875_f64)).abs()) {
            break 'l7;
        }
        if (S::from_f64(0.625_f64) * S::from_f64(-0.125_f64))
            .max(r1[(i8 * i8 + 1) % 3])
            .cmpge(((S::from_f64(i8 as f64) * S::from_f64(0.25)) * S::from_f64(0.625_f64)).max(b))
        {
            let mut n10 = 0_usize;
            'l9: while n10 < 5 {
                n10 += 1;
                b = b
                    * (((y * y + S::from_f64(0.25)).sqrt() * (y * S::from_f64(-0.875_f64)).cos())
                        * S::from_f64(0.75))
                    .sin();
                b = (((x + x) * (-(y))) * S::from_f64(0.75)).sin();
                b = b
                    * (((x + y) * (r1[(i8 * i8 + 1) % 3] + S::from_f64(0.875_f64)).sin())
                        * S::from_f64(0.75))
                    .sin();
            }
            'l11: for i12 in i8..=3_usize {
                let a = (r1[i8 % 3] * (r1[2] + S::from_f64(-1.125_f64)).sin());
                b = b - (r1[2] * S::from_f64(0.75)).sin();
                let d = program_30_of(
                    ((S::from_f64(-0.875_f64) * r1[(i8 * i8 + 1) % 3]) + S::from_f64(0.125)).tanh(),
                    ((r1[(i12 + 2) % 3] * S::from_f64(-0.125_f64)).max(S::from_f64(0.375_f64))
                        + S::from_f64(0.125))
                    .tanh(),
                )
                .tanh();
            }
            b = (((S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)).abs() - a)
                + S::from_f64(0.125))
            .tanh();
        }
    }
    ((S::from_f64(0.625_f64) + y) * (S::from_f64(0.625_f64) + y) + S::from_f64(0.25)).sqrt()
        + a
        + b
        + y
        + x
}

#[differentiable]
fn program_74(x: f64, y: f64) -> f64 {
    let mut d = (x * 0.75).sin();
    let mut r1 = [((d * 0.125_f64).max(x) + 0.125).tanh(); 2];
    'l2: for i3 in (1..4_usize).rev() {
        let a = ((r1[1] * -0.125_f64).abs() + -0.375_f64).sin();
        'l4: for i5 in 0..0_usize {
            let f = if (r1[(i3 + 1) % 2] * ((i5 as f64) * 0.25))
                >= (x / (1.5 + r1[(i3 * i3 + 1) % 2] * r1[(i3 * i3 + 1) % 2]))
            {
                ((a - r1[(i3 + 0) % 2]) + -0.625_f64).sin()
            } else {
                (y * (a + r1[0]))
            };
        }
        let d = program_45(((x + d) * 0.75).sin(), (r1[(i3 * i3 + 1) % 2] * 0.75).sin()).tanh();
    }
    let mut b = (d * 0.75).sin();
    if (-0.625_f64 + -0.625_f64).sin() >= (r1[1] * -0.875_f64).cos() {
        if (d + 0.125_f64).sin() <= (d - 0.125_f64).tanh() {
            if (x + r1[1]) <= (y + 0.125_f64).sin() {
                return ((r1[1] * x) * (-(y)));
            }
            d = (r1[0] * 0.75).sin();
        }
    } else {
        if (-(-0.125_f64)) >= (r1[0] * r1[0] + 0.25).sqrt() {
            return ((x * 0.625_f64).abs() * -1.125_f64).abs();
        }
    }
    if (b / (1.5 + x * x)) < (0.875_f64 * -0.125_f64).cos() {
        let g6 = |t: f64| (-(t - r1[0])) * t;
        let f = (g6((-0.125_f64 + b)) + g6((r1[1] * 0.875_f64).abs())).sin();
        r1[0] = (x * 0.75).sin();
    } else {
        r1[1] = (((0.375_f64 * -0.875_f64).max(r1[0]) * -0.625_f64).abs() + 0.125).tanh();
        let b =
            program_44(((d - x) + 0.125).tanh(), ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh())
                .tanh();
    }
    ((-0.875_f64 * 0.625_f64) + (r1[1] * x)) + b + d + y + x
}

fn program_74_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x * S::from_f64(0.75)).sin();
    let mut r1 = [((d * S::from_f64(0.125_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    'l2: for i3 in (1..4_usize).rev() {
        let a = ((r1[1] * S::from_f64(-0.125_f64)).abs() + S::from_f64(-0.375_f64)).sin();
        'l4: for i5 in 0..0_usize {
            let f = if (r1[(i3 + 1) % 2] * (S::from_f64(i5 as f64) * S::from_f64(0.25)))
                .cmpge((x / (S::from_f64(1.5) + r1[(i3 * i3 + 1) % 2] * r1[(i3 * i3 + 1) % 2])))
            {
                ((a - r1[(i3 + 0) % 2]) + S::from_f64(-0.625_f64)).sin()
            } else {
                (y * (a + r1[0]))
            };
        }
        let d = program_45_of(
            ((x + d) * S::from_f64(0.75)).sin(),
            (r1[(i3 * i3 + 1) % 2] * S::from_f64(0.75)).sin(),
        )
        .tanh();
    }
    let mut b = (d * S::from_f64(0.75)).sin();
    if (S::from_f64(-0.625_f64) + S::from_f64(-0.625_f64))
        .sin()
        .cmpge((r1[1] * S::from_f64(-0.875_f64)).cos())
    {
        if (d + S::from_f64(0.125_f64)).sin().cmple((d - S::from_f64(0.125_f64)).tanh()) {
            if (x + r1[1]).cmple((y + S::from_f64(0.125_f64)).sin()) {
                return ((r1[1] * x) * (-(y)));
            }
            d = (r1[0] * S::from_f64(0.75)).sin();
        }
    } else {
        if (-(S::from_f64(-0.125_f64))).cmpge((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) {
            return ((x * S::from_f64(0.625_f64)).abs() * S::from_f64(-1.125_f64)).abs();
        }
    }
    if (b / (S::from_f64(1.5) + x * x))
        .cmplt((S::from_f64(0.875_f64) * S::from_f64(-0.125_f64)).cos())
    {
        let g6 = |t: S| (-(t - r1[0])) * t;
        let f =
            (g6((S::from_f64(-0.125_f64) + b)) + g6((r1[1] * S::from_f64(0.875_f64)).abs())).sin();
        r1[0] = (x * S::from_f64(0.75)).sin();
    } else {
        r1[1] = (((S::from_f64(0.375_f64) * S::from_f64(-0.875_f64)).max(r1[0])
            * S::from_f64(-0.625_f64))
        .abs()
            + S::from_f64(0.125))
        .tanh();
        let b = program_44_of(
            ((d - x) + S::from_f64(0.125)).tanh(),
            ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    ((S::from_f64(-0.875_f64) * S::from_f64(0.625_f64)) + (r1[1] * x)) + b + d + y + x
}

#[differentiable]
fn program_75(x: f64, y: f64) -> f64 {
    let mut b = (x * 0.75).sin();
    let mut r1 = [
        ((x / (1.5 + b * b)) + 0.125).tanh(),
        ((x + y) + 0.125).tanh(),
        ((b + b) + 0.125).tanh(),
        ((x * -1.125_f64).cos() + 0.125).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;
        let mut b = (y * 0.75).sin();
    }
    b += ((r1[0] * r1[3]) + 0.125).tanh();
    'l4: for i5 in (2..4_usize).rev() {
        let c = program_53(((x - 0.625_f64).tanh() + 0.125).tanh(), ((y * y) * 0.75).sin()).tanh();
        b -= (((c * c) + (c * c + 0.25).sqrt()) + 0.125).tanh();
        r1[i5 % 4] -= (((c * -1.125_f64).max(r1[0]) + (0.125_f64 - y)) + 0.125).tanh();
    }
    let mut r6 = [
        ((y * b) * 0.75).sin(),
        (-0.375_f64 + 0.125).tanh(),
        (b * 0.75).sin(),
        ((b * r1[2]) + 0.125).tanh(),
        ((y * -0.125_f64).abs() * 0.75).sin(),
    ];
    'l7: for i8 in 2..=4_usize {
        'l9: for i10 in (0..3_usize).step_by(2) {
            let r11 = [((-(y)) * 0.75).sin(), ((r6[0] / (1.5 + y * y)) + 0.125).tanh()];
            if i8 % 3 == 0 {
                r1[(i10 + 0) % 4] =
                    (((((i8 as f64) * 0.25) * 0.375_f64).max(x) + (b * y)) + 0.125).tanh();
                r1[(i8 + 0) % 4] -= (r1[(i8 + 3) % 4] * 0.75).sin();
                let mut a = ((b * -0.625_f64).abs() * 0.75).sin();
            } else {
                b -= (((x * r1[(i10 + 3) % 4]) + -0.875_f64).sin() * 0.75).sin();
                let f = ((y * -0.875_f64).abs() + (-0.875_f64 * -1.125_f64).cos());
                r6[i8 % 5] +=
                    (((((i10 as f64) * 0.25) + r6[2]) * (r6[(i8 + 3) % 5] * x)) * 0.75).sin();
            }
        }
    }
    r6[1] + b + y + x
}

fn program_75_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (x * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((x / (S::from_f64(1.5) + b * b)) + S::from_f64(0.125)).tanh(),
        ((x + y) + S::from_f64(0.125)).tanh(),
        ((b + b) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 1 {
        n3 += 1;
        let mut b = (y * S::from_f64(0.75)).sin();
    }
    b = b + ((r1[0] * r1[3]) + S::from_f64(0.125)).tanh();
    'l4: for i5 in (2..4_usize).rev() {
        let c = program_53_of(
            ((x - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
            ((y * y) * S::from_f64(0.75)).sin(),
        )
        .tanh();
        b = b - (((c * c) + (c * c + S::from_f64(0.25)).sqrt()) + S::from_f64(0.125)).tanh();
        r1[i5 % 4] = r1[i5 % 4]
            - (((c * S::from_f64(-1.125_f64)).max(r1[0]) + (S::from_f64(0.125_f64) - y))
                + S::from_f64(0.125))
            .tanh();
    }
    let mut r6 = [
        ((y * b) * S::from_f64(0.75)).sin(),
        (S::from_f64(-0.375_f64) + S::from_f64(0.125)).tanh(),
        (b * S::from_f64(0.75)).sin(),
        ((b * r1[2]) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    'l7: for i8 in 2..=4_usize {
        'l9: for i10 in (0..3_usize).step_by(2) {
            let r11 = [
                ((-(y)) * S::from_f64(0.75)).sin(),
                ((r6[0] / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
            ];
            if i8 % 3 == 0 {
                r1[(i10 + 0) % 4] = ((((S::from_f64(i8 as f64) * S::from_f64(0.25))
                    * S::from_f64(0.375_f64))
                .max(x)
                    + (b * y))
                    + S::from_f64(0.125))
                .tanh();
                r1[(i8 + 0) % 4] = r1[(i8 + 0) % 4] - (r1[(i8 + 3) % 4] * S::from_f64(0.75)).sin();
                let mut a = ((b * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin();
            } else {
                b = b
                    - (((x * r1[(i10 + 3) % 4]) + S::from_f64(-0.875_f64)).sin()
                        * S::from_f64(0.75))
                    .sin();
                let f = ((y * S::from_f64(-0.875_f64)).abs()
                    + (S::from_f64(-0.875_f64) * S::from_f64(-1.125_f64)).cos());
                r6[i8 % 5] = r6[i8 % 5]
                    + ((((S::from_f64(i10 as f64) * S::from_f64(0.25)) + r6[2])
                        * (r6[(i8 + 3) % 5] * x))
                        * S::from_f64(0.75))
                    .sin();
            }
        }
    }
    r6[1] + b + y + x
}

#[differentiable]
fn program_76(x: f64, y: f64) -> f64 {
    let mut d = ((y * y) + 0.125).tanh();
    let mut r1 = [
        ((y - y) * 0.75).sin(),
        ((x * y) + 0.125).tanh(),
        ((x * -0.375_f64).max(x) + 0.125).tanh(),
        (x * 0.75).sin(),
    ];
    d = (((r1[0] / (1.5 + r1[3] * r1[3])) + 0.375_f64).sin() + 0.125).tanh();
    'l2: for i3 in 2..5_usize {
        let a = if i3 % 2 == 1 {
            ((((i3 as f64) * 0.25) / (1.5 + d * d)) * (r1[3] * -0.625_f64))
        } else {
            r1[1]
        };
        'l4: for i5 in (1..0_usize).step_by(2) {
            'l6: for i7 in (0..3_usize).rev() {
                r1[1] += (((-((i7 as f64) * 0.25)) * (-((i7 as f64) * 0.25)) + 0.25).sqrt()
                    + 0.125)
                    .tanh();
                let b = program_67(
                    ((x - -0.625_f64).tanh() * 0.75).sin(),
                    ((r1[(i3 + 3) % 4] - 0.625_f64).tanh() + 0.125).tanh(),
                )
                .tanh();
            }
            let mut r8 = [((r1[2] + x) + 0.125).tanh(); 5];
            let mut n10 = 0_usize;
            'l9: while n10 < 4 {
                n10 += 1;
                let mut e = ((r1[2] - -0.375_f64).tanh() * 0.75).sin();
                d += ((-(r8[i3 % 5] - ((i3 as f64) * 0.25))) + 0.125).tanh();
            }
        }
    }
    if (0.375_f64 * 0.625_f64).max(x) >= (x + r1[2]) {
        return ((-(y)) * 0.625_f64).max(-0.125_f64);
    }
    d = (y + 0.125).tanh();
    d = (((x + d) * -0.625_f64).cos() + 0.125).tanh();
    r1[0] + d + y + x
}

fn program_76_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y * y) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((y - y) * S::from_f64(0.75)).sin(),
        ((x * y) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.375_f64)).max(x) + S::from_f64(0.125)).tanh(),
        (x * S::from_f64(0.75)).sin(),
    ];
    d = (((r1[0] / (S::from_f64(1.5) + r1[3] * r1[3])) + S::from_f64(0.375_f64)).sin()
        + S::from_f64(0.125))
    .tanh();
    'l2: for i3 in 2..5_usize {
        let a = if i3 % 2 == 1 {
            (((S::from_f64(i3 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + d * d))
                * (r1[3] * S::from_f64(-0.625_f64)))
        } else {
            r1[1]
        };
        'l4: for i5 in (1..0_usize).step_by(2) {
            'l6: for i7 in (0..3_usize).rev() {
                r1[1] = r1[1]
                    + (((-(S::from_f64(i7 as f64) * S::from_f64(0.25)))
                        * (-(S::from_f64(i7 as f64) * S::from_f64(0.25)))
                        + S::from_f64(0.25))
                    .sqrt()
                        + S::from_f64(0.125))
                    .tanh();
                let b = program_67_of(
                    ((x - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
                    ((r1[(i3 + 3) % 4] - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125))
                        .tanh(),
                )
                .tanh();
            }
            let mut r8 = [((r1[2] + x) + S::from_f64(0.125)).tanh(); 5];
            let mut n10 = 0_usize;
            'l9: while n10 < 4 {
                n10 += 1;
                let mut e = ((r1[2] - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin();
                d = d
                    + ((-(r8[i3 % 5] - (S::from_f64(i3 as f64) * S::from_f64(0.25))))
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
    }
    if (S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).max(x).cmpge((x + r1[2])) {
        return ((-(y)) * S::from_f64(0.625_f64)).max(S::from_f64(-0.125_f64));
    }
    d = (y + S::from_f64(0.125)).tanh();
    d = (((x + d) * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh();
    r1[0] + d + y + x
}

#[differentiable]
fn program_77(x: f64, y: f64) -> f64 {
    let mut f = ((-(y)) * 0.75).sin();
    let mut r1 = [((f + x) * 0.75).sin(); 2];
    if (x * r1[1]) >= (x - f) {
        r1[0] = (((-(f)) - (y - f)) + 0.125).tanh();
        r1[1] = (((f * f) - (x + r1[1])) * 0.75).sin();
    } else {
        if (r1[1] * r1[0]) > (r1[0] * r1[1]) {
            let c = r1[0];
            r1[0] *= (((r1[1] / (1.5 + c * c))
                / (1.5 + (f / (1.5 + c * c)) * (f / (1.5 + c * c))))
                + 0.125)
                .tanh();
        } else {
            for v in r1.iter() {
                f = f * ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh()
                    + *v * ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh();
            }
            let d = program_21(
                ((y * -1.125_f64).abs() * 0.75).sin(),
                ((y * -0.375_f64).cos() * 0.75).sin(),
            )
            .tanh();
            let g2 = |t: f64| ((0.375_f64 * t) + (f + x)) * t;
            let e = (g2((d + d)) + g2((-0.875_f64 + 0.375_f64).sin())).sin();
        }
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 4 {
        n4 += 1;
        let mut d = ((r1[0] * r1[(n4 + 0) % 2]) * 0.75).sin();
        let g5 = |t: f64| ((r1[0] + -1.125_f64).sin() + (t + r1[1])) * t;
        let a = (g5((r1[n4 % 2] * y)) + g5((r1[0] * r1[(n4 * n4 + 1) % 2]))).sin();
        let mut r6 = [
            ((0.375_f64 - -0.375_f64).tanh() + 0.125).tanh(),
            ((-(a)) + 0.125).tanh(),
            ((((n4 as f64) * 0.25) / (1.5 + a * a)) * 0.75).sin(),
            ((x * r1[n4 % 2]) * 0.75).sin(),
            ((0.125_f64 + r1[(n4 + 1) % 2]) + 0.125).tanh(),
        ];
    }
    r1[0] = (((-1.125_f64 * -1.125_f64).abs() - (r1[0] * f)) * 0.75).sin();
    y + f + y + x
}

fn program_77_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((-(y)) * S::from_f64(0.75)).sin();
    let mut r1 = [((f + x) * S::from_f64(0.75)).sin(); 2];
    if (x * r1[1]).cmpge((x - f)) {
        r1[0] = (((-(f)) - (y - f)) + S::from_f64(0.125)).tanh();
        r1[1] = (((f * f) - (x + r1[1])) * S::from_f64(0.75)).sin();
    } else {
        if (r1[1] * r1[0]).cmpgt((r1[0] * r1[1])) {
            let c = r1[0];
            r1[0] = r1[0]
                * (((r1[1] / (S::from_f64(1.5) + c * c))
                    / (S::from_f64(1.5)
                        + (f / (S::from_f64(1.5) + c * c)) * (f / (S::from_f64(1.5) + c * c))))
                    + S::from_f64(0.125))
                .tanh();
        } else {
            for v in r1.iter() {
                f = f * ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh()
                    + *v * ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
            }
            let d = program_21_of(
                ((y * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
                ((y * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
            )
            .tanh();
            let g2 = |t: S| ((S::from_f64(0.375_f64) * t) + (f + x)) * t;
            let e =
                (g2((d + d)) + g2((S::from_f64(-0.875_f64) + S::from_f64(0.375_f64)).sin())).sin();
        }
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 4 {
        n4 += 1;
        let mut d = ((r1[0] * r1[(n4 + 0) % 2]) * S::from_f64(0.75)).sin();
        let g5 = |t: S| ((r1[0] + S::from_f64(-1.125_f64)).sin() + (t + r1[1])) * t;
        let a = (g5((r1[n4 % 2] * y)) + g5((r1[0] * r1[(n4 * n4 + 1) % 2]))).sin();
        let mut r6 = [
            ((S::from_f64(0.375_f64) - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
            ((-(a)) + S::from_f64(0.125)).tanh(),
            (((S::from_f64(n4 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + a * a))
                * S::from_f64(0.75))
            .sin(),
            ((x * r1[n4 % 2]) * S::from_f64(0.75)).sin(),
            ((S::from_f64(0.125_f64) + r1[(n4 + 1) % 2]) + S::from_f64(0.125)).tanh(),
        ];
    }
    r1[0] = (((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)).abs() - (r1[0] * f))
        * S::from_f64(0.75))
    .sin();
    y + f + y + x
}

#[differentiable]
fn program_78(x: f64, y: f64) -> f64 {
    let mut c = ((x * y) * 0.75).sin();
    let mut r1 = [((y * -0.875_f64).abs() + 0.125).tanh(); 5];
    let g2 = |t: f64| (r1[3] * (x + 0.875_f64).sin()) * t;
    let c = (g2((r1[0] / (1.5 + x * x))) + g2((x + -1.125_f64))).sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        let r5 = [((r1[n4 % 5] * r1[n4 % 5] + 0.25).sqrt() * 0.75).sin(), ((c + c) * 0.75).sin()];
        let mut c = ((x / (1.5 + c * c)) * 0.75).sin();
    }
    let g6 = |t: f64| ((r1[3] + 0.125_f64).sin() * 0.125_f64).cos() * t;
    let c = (g6((y + x)) + g6((x * y))).sin();
    let r7 = [
        ((-(c)) + 0.125).tanh(),
        ((-(c)) + 0.125).tanh(),
        ((y * -0.875_f64).cos() * 0.75).sin(),
        ((r1[0] * c) * 0.75).sin(),
        ((y + -1.125_f64).sin() + 0.125).tanh(),
    ];
    'l8: for i9 in (1..1_usize).step_by(2) {
        if (c / (1.5 + ((i9 as f64) * 0.25) * ((i9 as f64) * 0.25))) < r7[(i9 * i9 + 1) % 5] {
            if i9 % 3 == 1 {
                let mut b = ((-0.625_f64 - x) * 0.75).sin();
            } else {
                let (a, mut b) = (((((i9 as f64) * 0.25) / (1.5 + c * c)) + 0.125).tanh(), c);
                r1[2] = (((-0.125_f64 * -0.125_f64).cos()
                    + (((i9 as f64) * 0.25) - -0.375_f64).tanh())
                    * 0.75)
                    .sin();
                let (a, mut b) = (((x * x) + 0.125).tanh(), r7[1]);
            }
            if i9 % 3 == 2 {
                let mut d = ((-((i9 as f64) * 0.25)) * 0.75).sin();
                let mut r10 = [((d + ((i9 as f64) * 0.25)) * 0.75).sin(); 2];
            } else {
                r1[1] = (((y * y) * (c - 0.125_f64)) + 0.125).tanh();
            }
        }
        'l11: for i12 in 0..3_usize {
            let mut n14 = 0_usize;
            'l13: while n14 < 4 {
                n14 += 1;
                let (a, mut b) = (((c * r7[(n14 + 3) % 5]) + 0.125).tanh(), (y + -1.125_f64).sin());
                r1[4] -= (((r1[i12 % 5] * 0.375_f64).abs() * 0.375_f64).abs() + 0.125).tanh();
            }
            let e = if i9 % 4 == 2 {
                ((r1[i12 % 5] + x) - 0.125_f64).tanh()
            } else {
                ((c * y) * (c * y) + 0.25).sqrt()
            };
            if i12 % 3 == 1 {
                r1[i12 % 5] -= ((r1[i9 % 5] + (c * -0.625_f64).abs()) + 0.125).tanh();
            }
        }
    }
    ((y * r1[3]) - (x * -0.375_f64).abs()) + c + y + x
}

fn program_78_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((y * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(); 5];
    let g2 = |t: S| (r1[3] * (x + S::from_f64(0.875_f64)).sin()) * t;
    let c = (g2((r1[0] / (S::from_f64(1.5) + x * x))) + g2((x + S::from_f64(-1.125_f64)))).sin();
    let mut n4 = 0_usize;
    'l3: while n4 < 5 {
        n4 += 1;
        let r5 = [
            ((r1[n4 % 5] * r1[n4 % 5] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            ((c + c) * S::from_f64(0.75)).sin(),
        ];
        let mut c = ((x / (S::from_f64(1.5) + c * c)) * S::from_f64(0.75)).sin();
    }
    let g6 = |t: S| ((r1[3] + S::from_f64(0.125_f64)).sin() * S::from_f64(0.125_f64)).cos() * t;
    let c = (g6((y + x)) + g6((x * y))).sin();
    let r7 = [
        ((-(c)) + S::from_f64(0.125)).tanh(),
        ((-(c)) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ((r1[0] * c) * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
    ];
    'l8: for i9 in (1..1_usize).step_by(2) {
        if (c
            / (S::from_f64(1.5)
                + (S::from_f64(i9 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i9 as f64) * S::from_f64(0.25))))
        .cmplt(r7[(i9 * i9 + 1) % 5])
        {
            if i9 % 3 == 1 {
                let mut b = ((S::from_f64(-0.625_f64) - x) * S::from_f64(0.75)).sin();
            } else {
                let (a, mut b) = (
                    (((S::from_f64(i9 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + c * c))
                        + S::from_f64(0.125))
                    .tanh(),
                    c,
                );
                r1[2] = (((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)).cos()
                    + ((S::from_f64(i9 as f64) * S::from_f64(0.25)) - S::from_f64(-0.375_f64))
                        .tanh())
                    * S::from_f64(0.75))
                .sin();
                let (a, mut b) = (((x * x) + S::from_f64(0.125)).tanh(), r7[1]);
            }
            if i9 % 3 == 2 {
                let mut d =
                    ((-(S::from_f64(i9 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin();
                let mut r10 = [((d + (S::from_f64(i9 as f64) * S::from_f64(0.25)))
                    * S::from_f64(0.75))
                .sin(); 2];
            } else {
                r1[1] = (((y * y) * (c - S::from_f64(0.125_f64))) + S::from_f64(0.125)).tanh();
            }
        }
        'l11: for i12 in 0..3_usize {
            let mut n14 = 0_usize;
            'l13: while n14 < 4 {
                n14 += 1;
                let (a, mut b) = (
                    ((c * r7[(n14 + 3) % 5]) + S::from_f64(0.125)).tanh(),
                    (y + S::from_f64(-1.125_f64)).sin(),
                );
                r1[4] = r1[4]
                    - (((r1[i12 % 5] * S::from_f64(0.375_f64)).abs() * S::from_f64(0.375_f64))
                        .abs()
                        + S::from_f64(0.125))
                    .tanh();
            }
            let e = if i9 % 4 == 2 {
                ((r1[i12 % 5] + x) - S::from_f64(0.125_f64)).tanh()
            } else {
                ((c * y) * (c * y) + S::from_f64(0.25)).sqrt()
            };
            if i12 % 3 == 1 {
                r1[i12 % 5] = r1[i12 % 5]
                    - ((r1[i9 % 5] + (c * S::from_f64(-0.625_f64)).abs()) + S::from_f64(0.125))
                        .tanh();
            }
        }
    }
    ((y * r1[3]) - (x * S::from_f64(-0.375_f64)).abs()) + c + y + x
}

#[differentiable]
fn program_79(x: f64, y: f64) -> f64 {
    let mut e = ((x * -0.125_f64).max(y) + 0.125).tanh();
    let mut r1 = [
        ((y * -0.875_f64) * 0.75).sin(),
        ((0.875_f64 / (1.5 + y * y)) + 0.125).tanh(),
        ((y + y) + 0.125).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        let (a, mut b) = (((x / (1.5 + e * e)) * 0.75).sin(), (y * y));
        'l4: for i5 in 2..3_usize {
            e += (((r1[(i5 * i5 + 1) % 3] - r1[1]) * 0.625_f64).cos() * 0.75).sin();
            r1[i5 % 3] = (((e + ((n3 as f64) * 0.25)) * 0.625_f64).cos() * 0.75).sin();
        }
        let c = if n3 % 4 == 3 { (-(x * r1[0])) } else { b };
    }
    r1[1] = (((y + x) * (e * r1[0])) + 0.125).tanh();
    'l6: for i7 in (2..5_usize).step_by(2) {
        e += (((e * ((i7 as f64) * 0.25)) + (x + r1[(i7 + 0) % 3])) + 0.125).tanh();
    }
    if (r1[1] * r1[0]) <= (e + -0.125_f64).sin() {
        return ((x * y) * -0.875_f64).cos();
    }
    if (y * -1.125_f64).max(r1[2]) > (y * y + 0.25).sqrt() {
        if (r1[0] * r1[0] + 0.25).sqrt() < (r1[2] + y) {
            return ((y * 0.125_f64) - (e * -0.875_f64).abs());
        }
        let d = if r1[2] <= (x + 0.625_f64).sin() {
            ((r1[2] + -0.375_f64).sin() * -0.375_f64).cos()
        } else {
            (y * y + 0.25).sqrt()
        };
        'l8: for i9 in 2..1_usize {
            if i9 % 2 == 0 {
                let (a, mut b) =
                    (((y - 0.125_f64).tanh() * 0.75).sin(), (r1[1] * -1.125_f64).cos());
                let mut r10 = [
                    ((d * d) * 0.75).sin(),
                    ((r1[i9 % 3] + d) + 0.125).tanh(),
                    ((0.125_f64 * 0.125_f64 + 0.25).sqrt() * 0.75).sin(),
                    ((-(r1[(i9 + 0) % 3])) * 0.75).sin(),
                ];
            }
            if i9 % 3 == 0 {
                e -= ((x - -0.875_f64).tanh() * 0.75).sin();
            } else {
                let mut r11 = [(r1[(i9 * i9 + 1) % 3] * 0.75).sin(); 2];
                e -= ((-((d * 0.375_f64).cos())) + 0.125).tanh();
            }
        }
    }
    ((r1[1] + e) - -0.625_f64).tanh() + e + y + x
}

fn program_79_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * S::from_f64(-0.125_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((y * S::from_f64(-0.875_f64)) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.875_f64) / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        ((y + y) + S::from_f64(0.125)).tanh(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        let (a, mut b) = (((x / (S::from_f64(1.5) + e * e)) * S::from_f64(0.75)).sin(), (y * y));
        'l4: for i5 in 2..3_usize {
            e = e
                + (((r1[(i5 * i5 + 1) % 3] - r1[1]) * S::from_f64(0.625_f64)).cos()
                    * S::from_f64(0.75))
                .sin();
            r1[i5 % 3] = (((e + (S::from_f64(n3 as f64) * S::from_f64(0.25)))
                * S::from_f64(0.625_f64))
            .cos()
                * S::from_f64(0.75))
            .sin();
        }
        let c = if n3 % 4 == 3 { (-(x * r1[0])) } else { b };
    }
    r1[1] = (((y + x) * (e * r1[0])) + S::from_f64(0.125)).tanh();
    'l6: for i7 in (2..5_usize).step_by(2) {
        e = e
            + (((e * (S::from_f64(i7 as f64) * S::from_f64(0.25))) + (x + r1[(i7 + 0) % 3]))
                + S::from_f64(0.125))
            .tanh();
    }
    if (r1[1] * r1[0]).cmple((e + S::from_f64(-0.125_f64)).sin()) {
        return ((x * y) * S::from_f64(-0.875_f64)).cos();
    }
    if (y * S::from_f64(-1.125_f64)).max(r1[2]).cmpgt((y * y + S::from_f64(0.25)).sqrt()) {
        if (r1[0] * r1[0] + S::from_f64(0.25)).sqrt().cmplt((r1[2] + y)) {
            return ((y * S::from_f64(0.125_f64)) - (e * S::from_f64(-0.875_f64)).abs());
        }
        let d = if r1[2].cmple((x + S::from_f64(0.625_f64)).sin()) {
            ((r1[2] + S::from_f64(-0.375_f64)).sin() * S::from_f64(-0.375_f64)).cos()
        } else {
            (y * y + S::from_f64(0.25)).sqrt()
        };
        'l8: for i9 in 2..1_usize {
            if i9 % 2 == 0 {
                let (a, mut b) = (
                    ((y - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
                    (r1[1] * S::from_f64(-1.125_f64)).cos(),
                );
                let mut r10 = [
                    ((d * d) * S::from_f64(0.75)).sin(),
                    ((r1[i9 % 3] + d) + S::from_f64(0.125)).tanh(),
                    ((S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt()
                        * S::from_f64(0.75))
                    .sin(),
                    ((-(r1[(i9 + 0) % 3])) * S::from_f64(0.75)).sin(),
                ];
            }
            if i9 % 3 == 0 {
                e = e - ((x - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
            } else {
                let mut r11 = [(r1[(i9 * i9 + 1) % 3] * S::from_f64(0.75)).sin(); 2];
                e = e - ((-((d * S::from_f64(0.375_f64)).cos())) + S::from_f64(0.125)).tanh();
            }
        }
    }
    ((r1[1] + e) - S::from_f64(-0.625_f64)).tanh() + e + y + x
}
