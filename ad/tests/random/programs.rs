//! Random programs, written by `cargo run -p ad --example random_programs -- 8 60`.

use ad::{Real, differentiable};

use crate::effects::{
    Ball, Guard, Hard, Soft, curved, draw, left, of_parts, raised, raises, right, scale, two,
};
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
    let mut f = ((y - 0.125_f64).tanh() + 0.125).tanh();
    let mut r1 = [((draw() * 0.625_f64).cos() + 0.125).tanh(); 4];
    let z2;
    if (x * r1[2]) <= (y - -0.375_f64).tanh() {
        z2 = ((scale() * draw()) - -0.375_f64).tanh();
    } else {
        z2 = scale();
    }
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = (x / (1.5 + (r1[3] * x) * (r1[3] * x)));
        if n4 > 2 || (f * f + 0.25).sqrt() > (r1[1] * 0.125_f64).max(r1[3]) {
            z3 = (r1[1] * -1.125_f64).cos();
            break;
        }
    }
    let mut r5 = [((f + draw()) + 0.125).tanh(); 4];
    let mut q6 = [
        Ball { height: (0.625_f64 * 0.75).sin(), speed: ((-(y)) * 0.75).sin() },
        Ball {
            height: (draw() * 0.75).sin(),
            speed: ((r1[3] * r1[3] + 0.25).sqrt() + 0.125).tanh(),
        },
    ];
    let up7 = q6[0].bounce();
    let f = if up7 { q6[1].run(2) } else { 0.625_f64 };
    let f = q6[0].height * q6[1].speed - q6[0].speed;
    let by8 = ((r5[1] - -1.125_f64).tanh() + 0.125).tanh();
    for v in r5.iter_mut() {
        *v = (*v * by8).sin();
    }
    if (z2 * -0.375_f64).max(0.375_f64) >= (z3 + -0.625_f64).sin() {
        let f = List(vec![
            ((0.875_f64 - r1[2]) * 0.75).sin(),
            (-(z2)),
            ((scale() * r5[2]) * 0.75).sin(),
        ])
        .folded((r1[1] + 0.125).tanh(), |s, v| {
            (s * v + (-0.125_f64 * -0.125_f64 + 0.25).sqrt()).sin()
        });
        r1[3] += (((r1[0] * r5[0]) * -0.375_f64).max(x) * 0.75).sin();
    }
    let f = left::curved((r1[3] * r1[1]))
        * right::curved(((r5[0] + -0.625_f64).sin() * 0.75).sin())
        - curved((r1[3] * r1[1]));
    let c = if z2 < (z2 - -1.125_f64) {
        ((x * 0.125_f64).max(z2) + (r5[0] * 0.375_f64).abs())
    } else {
        ((-(scale())) * (-0.625_f64 * x))
    };
    let by9 = ((z2 * z2 + 0.25).sqrt() * 0.75).sin();
    let a = shifted(&mut r1[0..], by9);
    let d = mixed(&r1[1..]).sin();
    let f = (f + -0.125_f64).sin();
    let r10 = [((z2 * z2 + 0.25).sqrt() + 0.125).tanh(); 2];
    ((y * r1[3]) + (r5[0] / (1.5 + z3 * z3))) + f + d + a + c + z3 + z2 + y + x
}

fn program_0_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((y - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let mut r1 =
        [((S::from_f64(draw()) * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(); 4];
    let z2;
    if (x * r1[2]).cmple((y - S::from_f64(-0.375_f64)).tanh()) {
        z2 = ((S::from_f64(scale()) * S::from_f64(draw())) - S::from_f64(-0.375_f64)).tanh();
    } else {
        z2 = S::from_f64(scale());
    }
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = (x / (S::from_f64(1.5) + (r1[3] * x) * (r1[3] * x)));
        if n4 > 2
            || (f * f + S::from_f64(0.25)).sqrt().cmpgt((r1[1] * S::from_f64(0.125_f64)).max(r1[3]))
        {
            z3 = (r1[1] * S::from_f64(-1.125_f64)).cos();
            break;
        }
    }
    let mut r5 = [((f + S::from_f64(draw())) + S::from_f64(0.125)).tanh(); 4];
    let mut q6 = [
        Ball {
            height: (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
            speed: ((-(y)) * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: (S::from_f64(draw()) * S::from_f64(0.75)).sin(),
            speed: ((r1[3] * r1[3] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        },
    ];
    let up7 = q6[0].bounce();
    let f = if up7 { q6[1].run(2) } else { S::from_f64(0.625_f64) };
    let f = q6[0].height * q6[1].speed - q6[0].speed;
    let by8 = ((r5[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    for v in r5.iter_mut() {
        *v = (*v * by8).sin();
    }
    if (z2 * S::from_f64(-0.375_f64))
        .max(S::from_f64(0.375_f64))
        .cmpge((z3 + S::from_f64(-0.625_f64)).sin())
    {
        let f = List(vec![
            ((S::from_f64(0.875_f64) - r1[2]) * S::from_f64(0.75)).sin(),
            (-(z2)),
            ((S::from_f64(scale()) * r5[2]) * S::from_f64(0.75)).sin(),
        ])
        .folded((r1[1] + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt())
                .sin()
        });
        r1[3] =
            r1[3] + (((r1[0] * r5[0]) * S::from_f64(-0.375_f64)).max(x) * S::from_f64(0.75)).sin();
    }
    let f = left::curved((r1[3] * r1[1]))
        * right::curved(((r5[0] + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin())
        - curved((r1[3] * r1[1]));
    let c = if z2.cmplt((z2 - S::from_f64(-1.125_f64))) {
        ((x * S::from_f64(0.125_f64)).max(z2) + (r5[0] * S::from_f64(0.375_f64)).abs())
    } else {
        ((-(S::from_f64(scale()))) * (S::from_f64(-0.625_f64) * x))
    };
    let by9 = ((z2 * z2 + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let a = shifted(&mut r1[0..], by9);
    let d = mixed(&r1[1..]).sin();
    let f = (f + S::from_f64(-0.125_f64)).sin();
    let r10 = [((z2 * z2 + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 2];
    ((y * r1[3]) + (r5[0] / (S::from_f64(1.5) + z3 * z3))) + f + d + a + c + z3 + z2 + y + x
}

#[differentiable]
fn program_1(x: f64, y: f64) -> f64 {
    let mut d = ((y + y) + 0.125).tanh();
    let mut r1 = [((d * -0.625_f64).max(d) * 0.75).sin(); 2];
    if (-(y)) <= (0.875_f64 * x) {
        let d = {
            let _guard = Guard::set(-0.25);
            ((r1[0] + 0.875_f64).sin() * (d / (1.5 + y * y)))
        } * scale();
        let g2 = |t: f64| ((r1[1] / (1.5 + y * y)) * (d + r1[1])) * t;
        let b = (g2((d - draw())) + g2(x)).sin();
        let mut q3 = [
            Ball { height: (r1[1] + 0.125).tanh(), speed: (b * 0.75).sin() },
            Ball {
                height: ((d + -0.625_f64).sin() + 0.125).tanh(),
                speed: ((r1[0] * y) * 0.75).sin(),
            },
        ];
        let up4 = q3[1].bounce();
        let e = if up4 { q3[1].run(0) } else { (r1[1] + x) };
        let d = q3[0].height * q3[1].speed - q3[0].speed;
    } else {
        let mut p5 =
            Pair { a: ((r1[0] * -0.125_f64).cos() * 0.75).sin(), b: ((x + r1[1]) * 0.75).sin() };
        r1[1] += (((r1[1] * p5.a) * (-(-0.625_f64))) + 0.125).tanh();
    }
    let by6 = ((scale() + x) + 0.125).tanh();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let mut p9 = Pair {
        a: (r1[k8 % 2] * 0.75).sin(),
        b: ((((k8 as f64) * 0.25) - -0.375_f64).tanh() * 0.75).sin(),
    };
    let mut b = (y + 0.125).tanh();
    let l10 = List(vec![
        ((draw() * r1[1]) + 0.125).tanh(),
        (0.125_f64 * 0.125_f64 + 0.25).sqrt(),
        ((y - x) * 0.75).sin(),
    ]);
    let m11 = &l10 * &List(vec![(scale() + 0.125).tanh(), (-(r1[0])), (p9.b + 0.125).tanh()]);
    let b = ((l10.clone() + m11).total()).tanh();
    'l12: for i13 in (0..3_usize).step_by(2) {
        let e = match roots((((i13 as f64) * 0.25) * 0.125_f64).cos(), (x * y)) {
            Ok(v) => (0.625_f64 * 0.625_f64 + 0.25).sqrt(),
            Err(true) => r1[k8 % 2],
            Err(_) => (((i13 as f64) * 0.25) / (1.5 + y * y)),
        };
        r1[(k8 * k8 + 1) % 2] =
            (((((k8 as f64) * 0.25) + -0.875_f64).sin() * (-1.125_f64 - b)) + 0.125).tanh();
    }
    let z14;
    if (d * d + 0.25).sqrt() < (b * b + 0.25).sqrt() {
        let t = ((p9.b + draw()) / (1.5 + (d * 0.625_f64).cos() * (d * 0.625_f64).cos()));
        z14 = ((d / (1.5 + draw() * draw())) * -0.875_f64).cos();
    } else if k8 % 3 == 2 {
        z14 = bent(r1[0]);
    } else {
        z14 = ((p9.b + draw()) / (1.5 + (d * 0.625_f64).cos() * (d * 0.625_f64).cos()));
    }
    (r1[0] + 0.125_f64).sin() + z14 + b + d + y + x
}

fn program_1_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y + y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((d * S::from_f64(-0.625_f64)).max(d) * S::from_f64(0.75)).sin(); 2];
    if (-(y)).cmple((S::from_f64(0.875_f64) * x)) {
        let d = {
            let _guard = Guard::set(-0.25);
            ((r1[0] + S::from_f64(0.875_f64)).sin() * (d / (S::from_f64(1.5) + y * y)))
        } * S::from_f64(scale());
        let g2 = |t: S| ((r1[1] / (S::from_f64(1.5) + y * y)) * (d + r1[1])) * t;
        let b = (g2((d - S::from_f64(draw()))) + g2(x)).sin();
        let mut q3 = [
            Ball {
                height: (r1[1] + S::from_f64(0.125)).tanh(),
                speed: (b * S::from_f64(0.75)).sin(),
            },
            Ball {
                height: ((d + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
                speed: ((r1[0] * y) * S::from_f64(0.75)).sin(),
            },
        ];
        let up4 = q3[1].bounce();
        let e = if up4 { q3[1].run(0) } else { (r1[1] + x) };
        let d = q3[0].height * q3[1].speed - q3[0].speed;
    } else {
        let mut p5 = Pair {
            a: ((r1[0] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            b: ((x + r1[1]) * S::from_f64(0.75)).sin(),
        };
        r1[1] =
            r1[1] + (((r1[1] * p5.a) * (-(S::from_f64(-0.625_f64)))) + S::from_f64(0.125)).tanh();
    }
    let by6 = ((S::from_f64(scale()) + x) + S::from_f64(0.125)).tanh();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let mut p9 = Pair {
        a: (r1[k8 % 2] * S::from_f64(0.75)).sin(),
        b: (((S::from_f64(k8 as f64) * S::from_f64(0.25)) - S::from_f64(-0.375_f64)).tanh()
            * S::from_f64(0.75))
        .sin(),
    };
    let mut b = (y + S::from_f64(0.125)).tanh();
    let l10 = List(vec![
        ((S::from_f64(draw()) * r1[1]) + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.125_f64) * S::from_f64(0.125_f64) + S::from_f64(0.25)).sqrt(),
        ((y - x) * S::from_f64(0.75)).sin(),
    ]);
    let m11 = &l10
        * &List(vec![
            (S::from_f64(scale()) + S::from_f64(0.125)).tanh(),
            (-(r1[0])),
            (p9.b + S::from_f64(0.125)).tanh(),
        ]);
    let b = ((l10.clone() + m11).total()).tanh();
    'l12: for i13 in (0..3_usize).step_by(2) {
        let e = match roots(
            ((S::from_f64(i13 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64)).cos(),
            (x * y),
        ) {
            Ok(v) => (S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25)).sqrt(),
            Err(true) => r1[k8 % 2],
            Err(_) => ((S::from_f64(i13 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + y * y)),
        };
        r1[(k8 * k8 + 1) % 2] =
            ((((S::from_f64(k8 as f64) * S::from_f64(0.25)) + S::from_f64(-0.875_f64)).sin()
                * (S::from_f64(-1.125_f64) - b))
                + S::from_f64(0.125))
            .tanh();
    }
    let z14;
    if (d * d + S::from_f64(0.25)).sqrt().cmplt((b * b + S::from_f64(0.25)).sqrt()) {
        let t = ((p9.b + S::from_f64(draw()))
            / (S::from_f64(1.5)
                + (d * S::from_f64(0.625_f64)).cos() * (d * S::from_f64(0.625_f64)).cos()));
        z14 = ((d / (S::from_f64(1.5) + S::from_f64(draw()) * S::from_f64(draw())))
            * S::from_f64(-0.875_f64))
        .cos();
    } else if k8 % 3 == 2 {
        z14 = bent(r1[0]);
    } else {
        z14 = ((p9.b + S::from_f64(draw()))
            / (S::from_f64(1.5)
                + (d * S::from_f64(0.625_f64)).cos() * (d * S::from_f64(0.625_f64)).cos()));
    }
    (r1[0] + S::from_f64(0.125_f64)).sin() + z14 + b + d + y + x
}

#[differentiable]
fn program_2(x: f64, y: f64) -> f64 {
    let mut d = ((-0.125_f64 * 0.875_f64).cos() * 0.75).sin();
    let mut r1 = [(d * 0.75).sin(), ((x + 0.875_f64) * 0.75).sin(), (x * 0.75).sin()];
    let mut b = ((x - 0.125_f64).tanh() + 0.125).tanh();
    let r2 = [((d + -0.625_f64).sin() + 0.125).tanh(); 2];
    if (d + b) <= (r2[0] / (1.5 + r1[0] * r1[0])) {
        return ((r2[1] - y) / (1.5 + (r2[0] - 0.875_f64).tanh() * (r2[0] - 0.875_f64).tanh()));
    }
    let mut p3 = Pair { a: ((y * y + 0.25).sqrt() + 0.125).tanh(), b: ((d - x) + 0.125).tanh() };
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let mut w4 = (((r1[0] / (1.5 + p3.a * p3.a)) + 0.125).tanh(), [(-0.875_f64 * d); 2]);
    {
        let (p, [q, _]) = &mut w4;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w4.0 + w4.1[0] * w4.1[1]).tanh();
    if (d * -0.375_f64).cos() < d {
        let mut r5 = [((p3.b * p3.b + 0.25).sqrt() + 0.125).tanh(); 5];
    }
    b = (((r2[0] * 0.625_f64).cos() - (-(x))) + 0.125).tanh();
    p3.turn(((draw() / (1.5 + d * d)) + 0.125).tanh());
    p3 = p3.tamed();
    let mut p6 = Pair { a: (r2[0] * 0.75).sin(), b: ((r1[1] * b) * 0.75).sin() };
    r1[0] = (r1[1] * 0.75).sin();
    let mut r7 = [((r2[1] * p3.a) * 0.75).sin(); 4];
    let mut u8 = r1.to_vec();
    u8.push(((r2[0] * x) * 0.75).sin());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let f = (mixed(&u8) + u8[0]).tanh();
    (0.625_f64 * (p3.b * 0.125_f64).cos()) + f + b + d + y + x
}

fn program_2_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d =
        ((S::from_f64(-0.125_f64) * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let mut r1 = [
        (d * S::from_f64(0.75)).sin(),
        ((x + S::from_f64(0.875_f64)) * S::from_f64(0.75)).sin(),
        (x * S::from_f64(0.75)).sin(),
    ];
    let mut b = ((x - S::from_f64(0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let r2 = [((d + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(); 2];
    if (d + b).cmple((r2[0] / (S::from_f64(1.5) + r1[0] * r1[0]))) {
        return ((r2[1] - y)
            / (S::from_f64(1.5)
                + (r2[0] - S::from_f64(0.875_f64)).tanh()
                    * (r2[0] - S::from_f64(0.875_f64)).tanh()));
    }
    let mut p3 = Pair {
        a: ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        b: ((d - x) + S::from_f64(0.125)).tanh(),
    };
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let mut w4 = (
        ((r1[0] / (S::from_f64(1.5) + p3.a * p3.a)) + S::from_f64(0.125)).tanh(),
        [(S::from_f64(-0.875_f64) * d); 2],
    );
    {
        let (p, [q, _]) = &mut w4;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w4.0 + w4.1[0] * w4.1[1]).tanh();
    if (d * S::from_f64(-0.375_f64)).cos().cmplt(d) {
        let mut r5 = [((p3.b * p3.b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 5];
    }
    b = (((r2[0] * S::from_f64(0.625_f64)).cos() - (-(x))) + S::from_f64(0.125)).tanh();
    p3.turn(((S::from_f64(draw()) / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh());
    p3 = p3.tamed();
    let mut p6 =
        Pair { a: (r2[0] * S::from_f64(0.75)).sin(), b: ((r1[1] * b) * S::from_f64(0.75)).sin() };
    r1[0] = (r1[1] * S::from_f64(0.75)).sin();
    let mut r7 = [((r2[1] * p3.a) * S::from_f64(0.75)).sin(); 4];
    let mut u8 = r1.to_vec();
    u8.push(((r2[0] * x) * S::from_f64(0.75)).sin());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let f = (mixed(&u8) + u8[0]).tanh();
    (S::from_f64(0.625_f64) * (p3.b * S::from_f64(0.125_f64)).cos()) + f + b + d + y + x
}

#[differentiable]
fn program_3(x: f64, y: f64) -> f64 {
    let mut d = ((y + x) * 0.75).sin();
    let mut r1 = [((x - x) + 0.125).tanh(); 2];
    let mut q2 = [
        Ball {
            height: ((r1[1] * 0.875_f64).cos() * 0.75).sin(),
            speed: ((-(0.125_f64)) + 0.125).tanh(),
        },
        Ball {
            height: ((x / (1.5 + draw() * draw())) + 0.125).tanh(),
            speed: ((x * r1[1]) * 0.75).sin(),
        },
    ];
    let up3 = q2[1].bounce();
    let e = if up3 { q2[1].run(2) } else { (y - d) };
    let d = q2[0].height * q2[1].speed - q2[0].speed;
    if (r1[0] + 0.375_f64).sin() >= (draw() * d) {
        return ((e * 0.375_f64).max(d) * (r1[0] - r1[0]));
    }
    let z4;
    if (e - -0.875_f64).tanh() <= (d * -0.875_f64).abs() {
        z4 = r1[0];
    } else {
        z4 = (draw() * d);
    }
    let d = mixed(&r1).sin();
    let mut p5 = Pair { a: ((d + r1[1]) * 0.75).sin(), b: ((y * 0.125_f64).abs() * 0.75).sin() };
    let b = left::curved((x * -0.625_f64).abs()) * right::curved(((d + p5.b) * 0.75).sin())
        - curved((x * -0.625_f64).abs());
    let l6 = List(vec![((-(e)) + 0.125).tanh(), (b + r1[1]), (r1[0] + 0.125).tanh()]);
    let m7 = &l6
        * &List(vec![((r1[0] + r1[0]) * 0.75).sin(), (-(d)), ((d + 0.625_f64).sin() * 0.75).sin()]);
    let a = ((m7 * l6.total()).total()).tanh();
    'l8: for i9 in 2..0_usize {
        r1[(i9 + 0) % 2] *= (((r1[(i9 * i9 + 1) % 2] * r1[(i9 * i9 + 1) % 2] + 0.25).sqrt()
            * (r1[i9 % 2] * r1[i9 % 2] + 0.25).sqrt())
            * 0.75)
            .sin();
    }
    let mut r10 = [((d + 0.625_f64).sin() + 0.125).tanh(); 3];
    if (r1[1] * p5.a) <= (y * x) {
        let b = match roots((r10[1] - scale()), (draw() + 0.125_f64)) {
            Ok(v) => ((draw() + -1.125_f64).sin() * (p5.b * e)),
            Err(true) => r1[1],
            Err(_) => (r1[0] * draw()),
        };
        r10[0] = ((r1[0] * -0.125_f64).abs() + 0.125).tanh();
    }
    r1[1] = (((z4 * -0.125_f64).abs() - 0.125_f64).tanh() * 0.75).sin();
    ((y * b) * (y * b) + 0.25).sqrt() + a + b + d + z4 + e + y + x
}

fn program_3_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y + x) * S::from_f64(0.75)).sin();
    let mut r1 = [((x - x) + S::from_f64(0.125)).tanh(); 2];
    let mut q2 = [
        Ball {
            height: ((r1[1] * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin(),
            speed: ((-(S::from_f64(0.125_f64))) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((x / (S::from_f64(1.5) + S::from_f64(draw()) * S::from_f64(draw())))
                + S::from_f64(0.125))
            .tanh(),
            speed: ((x * r1[1]) * S::from_f64(0.75)).sin(),
        },
    ];
    let up3 = q2[1].bounce();
    let e = if up3 { q2[1].run(2) } else { (y - d) };
    let d = q2[0].height * q2[1].speed - q2[0].speed;
    if (r1[0] + S::from_f64(0.375_f64)).sin().cmpge((S::from_f64(draw()) * d)) {
        return ((e * S::from_f64(0.375_f64)).max(d) * (r1[0] - r1[0]));
    }
    let z4;
    if (e - S::from_f64(-0.875_f64)).tanh().cmple((d * S::from_f64(-0.875_f64)).abs()) {
        z4 = r1[0];
    } else {
        z4 = (S::from_f64(draw()) * d);
    }
    let d = mixed(&r1).sin();
    let mut p5 = Pair {
        a: ((d + r1[1]) * S::from_f64(0.75)).sin(),
        b: ((y * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    let b = left::curved((x * S::from_f64(-0.625_f64)).abs())
        * right::curved(((d + p5.b) * S::from_f64(0.75)).sin())
        - curved((x * S::from_f64(-0.625_f64)).abs());
    let l6 = List(vec![
        ((-(e)) + S::from_f64(0.125)).tanh(),
        (b + r1[1]),
        (r1[0] + S::from_f64(0.125)).tanh(),
    ]);
    let m7 = &l6
        * &List(vec![
            ((r1[0] + r1[0]) * S::from_f64(0.75)).sin(),
            (-(d)),
            ((d + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        ]);
    let a = ((m7 * l6.total()).total()).tanh();
    'l8: for i9 in 2..0_usize {
        r1[(i9 + 0) % 2] = r1[(i9 + 0) % 2]
            * (((r1[(i9 * i9 + 1) % 2] * r1[(i9 * i9 + 1) % 2] + S::from_f64(0.25)).sqrt()
                * (r1[i9 % 2] * r1[i9 % 2] + S::from_f64(0.25)).sqrt())
                * S::from_f64(0.75))
            .sin();
    }
    let mut r10 = [((d + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(); 3];
    if (r1[1] * p5.a).cmple((y * x)) {
        let b = match roots(
            (r10[1] - S::from_f64(scale())),
            (S::from_f64(draw()) + S::from_f64(0.125_f64)),
        ) {
            Ok(v) => ((S::from_f64(draw()) + S::from_f64(-1.125_f64)).sin() * (p5.b * e)),
            Err(true) => r1[1],
            Err(_) => (r1[0] * S::from_f64(draw())),
        };
        r10[0] = ((r1[0] * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    }
    r1[1] = (((z4 * S::from_f64(-0.125_f64)).abs() - S::from_f64(0.125_f64)).tanh()
        * S::from_f64(0.75))
    .sin();
    ((y * b) * (y * b) + S::from_f64(0.25)).sqrt() + a + b + d + z4 + e + y + x
}

#[differentiable]
fn program_4(x: f64, y: f64) -> f64 {
    let mut d = ((scale() / (1.5 + x * x)) + 0.125).tanh();
    let mut r1 = [(x + 0.125).tanh(); 4];
    if (0.625_f64 * 0.625_f64 + 0.25).sqrt() <= (r1[1] * 0.375_f64).abs() {
        let mut t2 = (x * 0.75).sin();
        let mut add3 = |v: f64| {
            t2 = (t2 * v + d).sin();
            t2 > 0.25
        };
        let e = if add3((-1.125_f64 + r1[0])) || !add3((r1[2] * r1[2] + 0.25).sqrt()) {
            r1[1]
        } else {
            -0.125_f64
        };
        let by4 = ((r1[0] + x) + 0.125).tanh();
        let m5 = &mut r1;
        if raises(m5) && !raises(m5) {
            m5[0] = by4 * m5[1];
        }
        let k6: usize = raised(m5);
    } else {
        let d = List(vec![
            ((draw() / (1.5 + y * y)) * 0.75).sin(),
            (-0.375_f64 * -0.375_f64 + 0.25).sqrt(),
            ((y - -0.375_f64).tanh() * 0.75).sin(),
        ])
        .folded(((-(r1[0])) + 0.125).tanh(), |s, v| (s * v + (r1[1] * r1[1] + 0.25).sqrt()).sin());
        let mut p7 =
            Pair { a: ((x + y) * 0.75).sin(), b: ((r1[0] * -0.125_f64).abs() * 0.75).sin() };
        let a = match roots((d + draw()), scale()) {
            Ok(v) => ((v - y) * (v - y) + 0.25).sqrt(),
            Err(true) => d,
            Err(_) => (y * 0.375_f64).cos(),
        };
    }
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let mut l8 = List(vec![(d * 0.75).sin(), d, ((x / (1.5 + y * y)) * 0.75).sin()]);
    for i9 in 0..4_usize {
        l8 += &List(vec![((0.875_f64 + r1[3]) + 0.125).tanh(), (d + d), (d + 0.125).tanh()]);
        if (r1[2] - r1[3]) < (-1.125_f64 + 0.625_f64).sin() {
            continue;
        }
        l8 = &l8 * &List(vec![((0.875_f64 + r1[3]) + 0.125).tanh(), (d + d), (d + 0.125).tanh()]);
    }
    let c = l8.total();
    let a = match raises(&mut r1) {
        true => (0.125_f64 + 0.875_f64).sin(),
        false => ((0.125_f64 + -0.375_f64) * -1.125_f64).max(d),
    };
    let g10 = |t: f64, v: &[f64]| mixed(v) * t + (d).tanh();
    let b = folded(&g10, (r1[0] + 0.125).tanh(), &r1).sin();
    'l11: for i12 in (1..0_usize).step_by(2) {
        let by13 = ((a / (1.5 + c * c)) + 0.125).tanh();
        let a = shifted(&mut r1[2..], by13);
    }
    let e = match roots((0.875_f64 + r1[2]), (r1[1] * -0.625_f64).cos()) {
        Ok(v) => x,
        Err(true) => x,
        Err(_) => (r1[2] + r1[1]),
    };
    let by14 = ((-1.125_f64 + -0.625_f64).sin() + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by14).sin();
    }
    (y + (a * -0.125_f64).abs()) + e + b + a + c + d + y + x
}

fn program_4_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((S::from_f64(scale()) / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh();
    let mut r1 = [(x + S::from_f64(0.125)).tanh(); 4];
    if (S::from_f64(0.625_f64) * S::from_f64(0.625_f64) + S::from_f64(0.25))
        .sqrt()
        .cmple((r1[1] * S::from_f64(0.375_f64)).abs())
    {
        let mut t2 = (x * S::from_f64(0.75)).sin();
        let mut add3 = |v: S| {
            t2 = (t2 * v + d).sin();
            t2.cmpgt(S::from_f64(0.25))
        };
        let e = if add3((S::from_f64(-1.125_f64) + r1[0]))
            || !add3((r1[2] * r1[2] + S::from_f64(0.25)).sqrt())
        {
            r1[1]
        } else {
            S::from_f64(-0.125_f64)
        };
        let by4 = ((r1[0] + x) + S::from_f64(0.125)).tanh();
        let m5 = &mut r1;
        if raises(m5) && !raises(m5) {
            m5[0] = by4 * m5[1];
        }
        let k6: usize = raised(m5);
    } else {
        let d = List(vec![
            ((S::from_f64(draw()) / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
            (S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64) + S::from_f64(0.25)).sqrt(),
            ((y - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        ])
        .folded(((-(r1[0])) + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (r1[1] * r1[1] + S::from_f64(0.25)).sqrt()).sin()
        });
        let mut p7 = Pair {
            a: ((x + y) * S::from_f64(0.75)).sin(),
            b: ((r1[0] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        };
        let a = match roots((d + S::from_f64(draw())), S::from_f64(scale())) {
            Ok(v) => ((v - y) * (v - y) + S::from_f64(0.25)).sqrt(),
            Err(true) => d,
            Err(_) => (y * S::from_f64(0.375_f64)).cos(),
        };
    }
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let mut l8 = List(vec![
        (d * S::from_f64(0.75)).sin(),
        d,
        ((x / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin(),
    ]);
    for i9 in 0..4_usize {
        l8 += &List(vec![
            ((S::from_f64(0.875_f64) + r1[3]) + S::from_f64(0.125)).tanh(),
            (d + d),
            (d + S::from_f64(0.125)).tanh(),
        ]);
        if (r1[2] - r1[3]).cmplt((S::from_f64(-1.125_f64) + S::from_f64(0.625_f64)).sin()) {
            continue;
        }
        l8 = &l8
            * &List(vec![
                ((S::from_f64(0.875_f64) + r1[3]) + S::from_f64(0.125)).tanh(),
                (d + d),
                (d + S::from_f64(0.125)).tanh(),
            ]);
    }
    let c = l8.total();
    let a = match raises(&mut r1) {
        true => (S::from_f64(0.125_f64) + S::from_f64(0.875_f64)).sin(),
        false => {
            ((S::from_f64(0.125_f64) + S::from_f64(-0.375_f64)) * S::from_f64(-1.125_f64)).max(d)
        }
    };
    let g10 = |t: S, v: &[S]| mixed(v) * t + (d).tanh();
    let b = folded(&g10, (r1[0] + S::from_f64(0.125)).tanh(), &r1).sin();
    'l11: for i12 in (1..0_usize).step_by(2) {
        let by13 = ((a / (S::from_f64(1.5) + c * c)) + S::from_f64(0.125)).tanh();
        let a = shifted(&mut r1[2..], by13);
    }
    let e = match roots((S::from_f64(0.875_f64) + r1[2]), (r1[1] * S::from_f64(-0.625_f64)).cos()) {
        Ok(v) => x,
        Err(true) => x,
        Err(_) => (r1[2] + r1[1]),
    };
    let by14 =
        ((S::from_f64(-1.125_f64) + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by14).sin();
    }
    (y + (a * S::from_f64(-0.125_f64)).abs()) + e + b + a + c + d + y + x
}

#[differentiable]
fn program_5(x: f64, y: f64) -> f64 {
    let mut d = ((x * 0.625_f64).abs() * 0.75).sin();
    let mut r1 = [(x * 0.75).sin(), ((d + -1.125_f64).sin() * 0.75).sin(), (d + 0.125).tanh()];
    r1[0] += (((x * -0.375_f64).max(y) * (x * r1[1])) + 0.125).tanh();
    let b = ((x / (1.5 + d * d)) * -1.125_f64).cos();
    let mut p2 = Pair {
        a: ((x * 0.875_f64).cos() + 0.125).tanh(),
        b: ((r1[0] * -0.625_f64).cos() + 0.125).tanh(),
    };
    let by3 = (r1[0] * 0.75).sin();
    let d = shifted(&mut r1[2..], by3);
    let d = summed(
        |t: f64| (((y * 0.875_f64).max(y) * (b * 0.625_f64).cos()) * t).sin(),
        ((y * 0.625_f64).max(p2.a) + 0.125).tanh(),
        0,
    )
    .tanh();
    let e = {
        let _guard = Guard::set(-0.25);
        ((x * scale()) * (r1[0] * r1[0] + 0.25).sqrt())
    } * scale();
    let e = r1[raised(&mut r1) % 3] * (r1[2] / (1.5 + r1[2] * r1[2]));
    let f = summed(|t: f64| ((-(p2.a * d)) * t).sin(), ((-(b)) * 0.75).sin(), 0).tanh();
    p2 += p2;
    p2 = p2.tamed();
    let mut c = ((d * d) * 0.75).sin();
    let z5;
    if (c * f) > -1.125_f64 {
        z5 = 0.375_f64;
    } else {
        z5 = (r1[2] - -0.125_f64).tanh();
    }
    let by6 = (0.875_f64 + 0.125).tanh();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let k9 = z5;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k9).sin();
        part.reverse();
    }
    c -= (((scale() + y) * 0.125_f64).max(draw()) + 0.125).tanh();
    (b * -0.375_f64).max(e) + z5 + c + f + e + d + b + y + x
}

fn program_5_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(0.625_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 = [
        (x * S::from_f64(0.75)).sin(),
        ((d + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        (d + S::from_f64(0.125)).tanh(),
    ];
    r1[0] =
        r1[0] + (((x * S::from_f64(-0.375_f64)).max(y) * (x * r1[1])) + S::from_f64(0.125)).tanh();
    let b = ((x / (S::from_f64(1.5) + d * d)) * S::from_f64(-1.125_f64)).cos();
    let mut p2 = Pair {
        a: ((x * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((r1[0] * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    let by3 = (r1[0] * S::from_f64(0.75)).sin();
    let d = shifted(&mut r1[2..], by3);
    let d = summed(
        |t: S| {
            (((y * S::from_f64(0.875_f64)).max(y) * (b * S::from_f64(0.625_f64)).cos()) * t).sin()
        },
        ((y * S::from_f64(0.625_f64)).max(p2.a) + S::from_f64(0.125)).tanh(),
        0,
    )
    .tanh();
    let e = {
        let _guard = Guard::set(-0.25);
        ((x * S::from_f64(scale())) * (r1[0] * r1[0] + S::from_f64(0.25)).sqrt())
    } * S::from_f64(scale());
    let e = r1[raised(&mut r1) % 3] * (r1[2] / (S::from_f64(1.5) + r1[2] * r1[2]));
    let f = summed(|t: S| ((-(p2.a * d)) * t).sin(), ((-(b)) * S::from_f64(0.75)).sin(), 0).tanh();
    p2 += p2;
    p2 = p2.tamed();
    let mut c = ((d * d) * S::from_f64(0.75)).sin();
    let z5;
    if (c * f).cmpgt(S::from_f64(-1.125_f64)) {
        z5 = S::from_f64(0.375_f64);
    } else {
        z5 = (r1[2] - S::from_f64(-0.125_f64)).tanh();
    }
    let by6 = (S::from_f64(0.875_f64) + S::from_f64(0.125)).tanh();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let k9 = z5;
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k9).sin();
        part.reverse();
    }
    c = c
        - (((S::from_f64(scale()) + y) * S::from_f64(0.125_f64)).max(S::from_f64(draw()))
            + S::from_f64(0.125))
        .tanh();
    (b * S::from_f64(-0.375_f64)).max(e) + z5 + c + f + e + d + b + y + x
}

#[differentiable]
fn program_6(x: f64, y: f64) -> f64 {
    let mut e = ((x * x) * 0.75).sin();
    let mut r1 = [
        ((draw() + e) * 0.75).sin(),
        ((x - draw()) + 0.125).tanh(),
        ((draw() * 0.125_f64).max(x) * 0.75).sin(),
        ((e + -1.125_f64).sin() * 0.75).sin(),
        ((-(x)) + 0.125).tanh(),
    ];
    if e >= (x * x) {
        return ((-0.625_f64 - y) + -1.125_f64).sin();
    }
    let f = r1[raised(&mut r1) % 5] * y;
    let d = if (-0.375_f64 + 0.125_f64).sin() < r1[2] {
        ((r1[4] - r1[3]) * (f + e))
    } else {
        ((scale() * r1[4]) + (y + -0.375_f64).sin())
    };
    r1[2] = ((-((r1[1] * -0.875_f64).max(y))) + 0.125).tanh();
    let c = root((d + -0.125_f64).sin()).map_or((f * 0.125_f64).max(r1[1]), |v| {
        ((e * e + 0.25).sqrt() + (-0.125_f64 * -1.125_f64).max(d))
    });
    r1[0] -= (((0.875_f64 - x) - 0.875_f64).tanh() + 0.125).tanh();
    let a = mixed(&r1[0..]).sin();
    for v in r1.iter().cycle().take(3) {
        e = (e + *v).sin();
    }
    let d = summed(bent, ((r1[1] * r1[1] + 0.25).sqrt() * 0.75).sin(), 3).tanh();
    let mut r3 = [
        ((r1[4] + c) + 0.125).tanh(),
        ((r1[1] * -0.625_f64).cos() * 0.75).sin(),
        ((c * 0.625_f64).max(r1[3]) * 0.75).sin(),
        ((c + d) + 0.125).tanh(),
        ((-0.625_f64 / (1.5 + f * f)) * 0.75).sin(),
    ];
    let mut q4 = [
        Ball { height: ((r1[4] * c) * 0.75).sin(), speed: ((c * draw()) * 0.75).sin() },
        Ball { height: (d * 0.75).sin(), speed: ((f - 0.625_f64).tanh() * 0.75).sin() },
    ];
    let up5 = q4[0].bounce();
    let b = if up5 { q4[1].run(1) } else { r1[1] };
    let a = q4[0].height * q4[1].speed - q4[0].speed;
    for v in r1.iter().cycle().take(1) {
        e = (e + *v).sin();
    }
    if (f + r3[4]) <= (r3[1] * a) {
        for v in r1.iter().cycle().take(1) {
            e = (e + *v).sin();
        }
        let by6 = ((d + e) * 0.75).sin();
        let m7 = &mut r3;
        if raises(m7) && !raises(m7) {
            m7[0] = by6 * m7[1];
        }
        let k8: usize = raised(m7);
    }
    ((r1[1] * e) + 0.625_f64).sin() + a + b + d + c + f + e + y + x
}

fn program_6_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x * x) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(draw()) + e) * S::from_f64(0.75)).sin(),
        ((x - S::from_f64(draw())) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(draw()) * S::from_f64(0.125_f64)).max(x) * S::from_f64(0.75)).sin(),
        ((e + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((-(x)) + S::from_f64(0.125)).tanh(),
    ];
    if e.cmpge((x * x)) {
        return ((S::from_f64(-0.625_f64) - y) + S::from_f64(-1.125_f64)).sin();
    }
    let f = r1[raised(&mut r1) % 5] * y;
    let d = if (S::from_f64(-0.375_f64) + S::from_f64(0.125_f64)).sin().cmplt(r1[2]) {
        ((r1[4] - r1[3]) * (f + e))
    } else {
        ((S::from_f64(scale()) * r1[4]) + (y + S::from_f64(-0.375_f64)).sin())
    };
    r1[2] = ((-((r1[1] * S::from_f64(-0.875_f64)).max(y))) + S::from_f64(0.125)).tanh();
    let c = root((d + S::from_f64(-0.125_f64)).sin()).map_or(
        (f * S::from_f64(0.125_f64)).max(r1[1]),
        |v| {
            ((e * e + S::from_f64(0.25)).sqrt()
                + (S::from_f64(-0.125_f64) * S::from_f64(-1.125_f64)).max(d))
        },
    );
    r1[0] = r1[0]
        - (((S::from_f64(0.875_f64) - x) - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125))
            .tanh();
    let a = mixed(&r1[0..]).sin();
    for v in r1.iter().cycle().take(3) {
        e = (e + *v).sin();
    }
    let d = summed(bent, ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(), 3)
        .tanh();
    let mut r3 = [
        ((r1[4] + c) + S::from_f64(0.125)).tanh(),
        ((r1[1] * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        ((c * S::from_f64(0.625_f64)).max(r1[3]) * S::from_f64(0.75)).sin(),
        ((c + d) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.625_f64) / (S::from_f64(1.5) + f * f)) * S::from_f64(0.75)).sin(),
    ];
    let mut q4 = [
        Ball {
            height: ((r1[4] * c) * S::from_f64(0.75)).sin(),
            speed: ((c * S::from_f64(draw())) * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: (d * S::from_f64(0.75)).sin(),
            speed: ((f - S::from_f64(0.625_f64)).tanh() * S::from_f64(0.75)).sin(),
        },
    ];
    let up5 = q4[0].bounce();
    let b = if up5 { q4[1].run(1) } else { r1[1] };
    let a = q4[0].height * q4[1].speed - q4[0].speed;
    for v in r1.iter().cycle().take(1) {
        e = (e + *v).sin();
    }
    if (f + r3[4]).cmple((r3[1] * a)) {
        for v in r1.iter().cycle().take(1) {
            e = (e + *v).sin();
        }
        let by6 = ((d + e) * S::from_f64(0.75)).sin();
        let m7 = &mut r3;
        if raises(m7) && !raises(m7) {
            m7[0] = by6 * m7[1];
        }
        let k8: usize = raised(m7);
    }
    ((r1[1] * e) + S::from_f64(0.625_f64)).sin() + a + b + d + c + f + e + y + x
}

of_parts!(#[differentiable] program_7 (t, a: f64) f64::from, if (t * -0.375_f64).cos() <= (scale() + a) { draw() } else { -0.625_f64 }, a + (t * t), a + a);
of_parts!(program_7_of<S> (t, a: S) S::from_f64, if (t * S::from_f64(-0.375_f64)).cos().cmple((S::from_f64(scale()) + a)) { S::from_f64(draw()) } else { S::from_f64(-0.625_f64) }, a + (t * t), a + a);

of_parts!(#[differentiable] program_8 (t, a: f64) f64::from, if (t + t) <= (0.125_f64 + t) { t } else { a }, if -0.875_f64 >= (t * -0.875_f64).abs() { a } else { t }, t - (a - -1.125_f64).tanh());
of_parts!(program_8_of<S> (t, a: S) S::from_f64, if (t + t).cmple((S::from_f64(0.125_f64) + t)) { t } else { a }, if S::from_f64(-0.875_f64).cmpge((t * S::from_f64(-0.875_f64)).abs()) { a } else { t }, t - (a - S::from_f64(-1.125_f64)).tanh());

#[differentiable]
fn program_9(x: f64, y: f64) -> f64 {
    let mut e = (x + 0.125).tanh();
    let mut r1 = [((0.375_f64 * e) + 0.125).tanh(), ((-0.625_f64 + draw()) * 0.75).sin()];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let b = List(vec![
            ((x * x + 0.25).sqrt() * 0.75).sin(),
            r1[(n3 * n3 + 1) % 2],
            ((-(e)) + 0.125).tanh(),
        ])
        .folded(((-0.625_f64 * -0.375_f64).abs() + 0.125).tanh(), |s, v| {
            (s * v + (y + r1[(n3 * n3 + 1) % 2])).sin()
        });
    }
    let e = match roots((x * x + 0.25).sqrt(), (e - r1[1])) {
        Ok(v) => ((-(v)) + -0.125_f64).sin(),
        Err(true) => 0.125_f64,
        Err(_) => (y - -1.125_f64),
    };
    let mut q4 = [
        Ball { height: ((e * e) + 0.125).tanh(), speed: ((r1[1] * r1[0]) + 0.125).tanh() },
        Ball { height: ((r1[1] * e) * 0.75).sin(), speed: (y * 0.75).sin() },
    ];
    let up5 = q4[1].bounce();
    let b = if up5 { q4[1].run(3) } else { (0.625_f64 * e) };
    let a = q4[0].height * q4[1].speed - q4[0].speed;
    if (x - x) >= (e + 0.875_f64).sin() {
        return ((y + r1[1]) * (r1[0] * 0.875_f64).cos());
    }
    let b = match roots((-(a)), (a + -0.125_f64)) {
        Ok(v) => ((b - b) * (scale() * r1[0])),
        Err(true) => y,
        Err(_) => (r1[1] * -0.875_f64).cos(),
    };
    if x >= (-(r1[1])) {
        return b;
    }
    let mut p6 =
        Pair { a: ((b * 0.375_f64).abs() * 0.75).sin(), b: ((-0.875_f64 + x) + 0.125).tanh() };
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let a = ((-(e)) + (r1[0] - 0.125_f64).tanh());
    p6.b = ((draw() + e) * 0.75).sin();
    p6 = p6.tamed();
    let mut u7 = r1.to_vec();
    u7.push(((b * -0.125_f64).max(a) * 0.75).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let e = (mixed(&u7) + u7[0]).tanh();
    let g8 = |t: f64| ((r1[1] * 0.625_f64).max(e) * 0.625_f64).cos() * t;
    let b = (g8((r1[1] - x)) + g8((r1[0] * 0.375_f64).abs())).sin();
    let mut b = ((draw() * -0.375_f64).cos() + 0.125).tanh();
    e + b + e + a + y + x
}

fn program_9_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(0.375_f64) * e) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.625_f64) + S::from_f64(draw())) * S::from_f64(0.75)).sin(),
    ];
    let mut n3 = 0_usize;
    'l2: while n3 < 5 {
        n3 += 1;
        let b = List(vec![
            ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            r1[(n3 * n3 + 1) % 2],
            ((-(e)) + S::from_f64(0.125)).tanh(),
        ])
        .folded(
            ((S::from_f64(-0.625_f64) * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
            |s, v| (s * v + (y + r1[(n3 * n3 + 1) % 2])).sin(),
        );
    }
    let e = match roots((x * x + S::from_f64(0.25)).sqrt(), (e - r1[1])) {
        Ok(v) => ((-(v)) + S::from_f64(-0.125_f64)).sin(),
        Err(true) => S::from_f64(0.125_f64),
        Err(_) => (y - S::from_f64(-1.125_f64)),
    };
    let mut q4 = [
        Ball {
            height: ((e * e) + S::from_f64(0.125)).tanh(),
            speed: ((r1[1] * r1[0]) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((r1[1] * e) * S::from_f64(0.75)).sin(),
            speed: (y * S::from_f64(0.75)).sin(),
        },
    ];
    let up5 = q4[1].bounce();
    let b = if up5 { q4[1].run(3) } else { (S::from_f64(0.625_f64) * e) };
    let a = q4[0].height * q4[1].speed - q4[0].speed;
    if (x - x).cmpge((e + S::from_f64(0.875_f64)).sin()) {
        return ((y + r1[1]) * (r1[0] * S::from_f64(0.875_f64)).cos());
    }
    let b = match roots((-(a)), (a + S::from_f64(-0.125_f64))) {
        Ok(v) => ((b - b) * (S::from_f64(scale()) * r1[0])),
        Err(true) => y,
        Err(_) => (r1[1] * S::from_f64(-0.875_f64)).cos(),
    };
    if x.cmpge((-(r1[1]))) {
        return b;
    }
    let mut p6 = Pair {
        a: ((b * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(-0.875_f64) + x) + S::from_f64(0.125)).tanh(),
    };
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let a = ((-(e)) + (r1[0] - S::from_f64(0.125_f64)).tanh());
    p6.b = ((S::from_f64(draw()) + e) * S::from_f64(0.75)).sin();
    p6 = p6.tamed();
    let mut u7 = r1.to_vec();
    u7.push(((b * S::from_f64(-0.125_f64)).max(a) * S::from_f64(0.75)).sin());
    u7[0] = u7[1] * u7[u7.len() - 1];
    let e = (mixed(&u7) + u7[0]).tanh();
    let g8 = |t: S| ((r1[1] * S::from_f64(0.625_f64)).max(e) * S::from_f64(0.625_f64)).cos() * t;
    let b = (g8((r1[1] - x)) + g8((r1[0] * S::from_f64(0.375_f64)).abs())).sin();
    let mut b = ((S::from_f64(draw()) * S::from_f64(-0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    e + b + e + a + y + x
}

#[differentiable]
fn program_10(x: f64, y: f64) -> f64 {
    let mut e = ((x + y) * 0.75).sin();
    let mut r1 = [((0.625_f64 * -0.875_f64).cos() * 0.75).sin(), ((-(x)) * 0.75).sin()];
    let r2 = [((x + e) * 0.75).sin(), ((r1[1] * -0.625_f64).cos() + 0.125).tanh()];
    let mut p3 = Pair {
        a: ((r2[1] - -1.125_f64).tanh() + 0.125).tanh(),
        b: ((x - 0.875_f64).tanh() + 0.125).tanh(),
    };
    'l4: for i5 in 0..1_usize {
        if (p3.a + y) > (((i5 as f64) * 0.25) + x) {
            let by6 = ((e + ((i5 as f64) * 0.25)) + 0.125).tanh();
            let m7 = &mut r1;
            if raises(m7) && !raises(m7) {
                m7[0] = by6 * m7[1];
            }
            let k8: usize = raised(m7);
            let c = {
                let _guard = Guard::set(-1.0);
                ((x - -1.125_f64).tanh() * (r2[k8 % 2] + r1[0]))
            } * scale();
        } else {
            let mut n10 = 0_usize;
            'l9: while n10 < 4 {
                n10 += 1;
                let mut c = ((r2[(i5 * i5 + 1) % 2] * y) * 0.75).sin();
            }
        }
        let e = left::curved((r2[(i5 * i5 + 1) % 2] * -0.125_f64).max(r2[1]))
            * right::curved(
                ((r2[(i5 * i5 + 1) % 2] * 0.875_f64).max(r2[(i5 * i5 + 1) % 2]) * 0.75).sin(),
            )
            - curved((r2[(i5 * i5 + 1) % 2] * -0.125_f64).max(r2[1]));
        let f = mixed(&r2[..1]).sin();
    }
    let k11: usize = raised(&mut r1) % 2;
    let mut p12 =
        Pair { a: ((r2[1] * r2[1] + 0.25).sqrt() + 0.125).tanh(), b: ((y + e) + 0.125).tanh() };
    let b = List(vec![
        ((e - scale()) + 0.125).tanh(),
        (e * 0.875_f64).cos(),
        ((e * 0.375_f64).cos() * 0.75).sin(),
    ])
    .folded(((-(0.125_f64)) + 0.125).tanh(), |s, v| (s * v + (e * x)).sin());
    'l13: for i14 in (k11..1_usize).step_by(2) {
        let mut w15 = (((-(b)) + 0.125).tanh(), [(x * 0.875_f64).max(((k11 as f64) * 0.25)); 2]);
        {
            let (ref mut p, [ref mut q, _]) = w15;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let f = (w15.0 + w15.1[0] * w15.1[1]).tanh();
        let l16 = List(vec![
            (r2[(k11 * k11 + 1) % 2] + 0.125).tanh(),
            (r1[0] - ((k11 as f64) * 0.25)),
            ((-(p12.a)) + 0.125).tanh(),
        ]);
        let m17 = &l16
            * &List(vec![
                (p3.b + 0.125).tanh(),
                (r1[1] * ((i14 as f64) * 0.25)),
                ((e * 0.625_f64).cos() * 0.75).sin(),
            ]);
        let d = ((m17 * l16.total()).total()).tanh();
    }
    ((x / (1.5 + 0.625_f64 * 0.625_f64)) * (draw() * -0.875_f64).max(p3.b)) + b + e + y + x
}

fn program_10_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut e = ((x + y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(0.625_f64) * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ((-(x)) * S::from_f64(0.75)).sin(),
    ];
    let r2 = [
        ((x + e) * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
    ];
    let mut p3 = Pair {
        a: ((r2[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        b: ((x - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
    };
    'l4: for i5 in 0..1_usize {
        if (p3.a + y).cmpgt(((S::from_f64(i5 as f64) * S::from_f64(0.25)) + x)) {
            let by6 =
                ((e + (S::from_f64(i5 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh();
            let m7 = &mut r1;
            if raises(m7) && !raises(m7) {
                m7[0] = by6 * m7[1];
            }
            let k8: usize = raised(m7);
            let c = {
                let _guard = Guard::set(-1.0);
                ((x - S::from_f64(-1.125_f64)).tanh() * (r2[k8 % 2] + r1[0]))
            } * S::from_f64(scale());
        } else {
            let mut n10 = 0_usize;
            'l9: while n10 < 4 {
                n10 += 1;
                let mut c = ((r2[(i5 * i5 + 1) % 2] * y) * S::from_f64(0.75)).sin();
            }
        }
        let e = left::curved((r2[(i5 * i5 + 1) % 2] * S::from_f64(-0.125_f64)).max(r2[1]))
            * right::curved(
                ((r2[(i5 * i5 + 1) % 2] * S::from_f64(0.875_f64)).max(r2[(i5 * i5 + 1) % 2])
                    * S::from_f64(0.75))
                .sin(),
            )
            - curved((r2[(i5 * i5 + 1) % 2] * S::from_f64(-0.125_f64)).max(r2[1]));
        let f = mixed(&r2[..1]).sin();
    }
    let k11: usize = raised(&mut r1) % 2;
    let mut p12 = Pair {
        a: ((r2[1] * r2[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        b: ((y + e) + S::from_f64(0.125)).tanh(),
    };
    let b = List(vec![
        ((e - S::from_f64(scale())) + S::from_f64(0.125)).tanh(),
        (e * S::from_f64(0.875_f64)).cos(),
        ((e * S::from_f64(0.375_f64)).cos() * S::from_f64(0.75)).sin(),
    ])
    .folded(((-(S::from_f64(0.125_f64))) + S::from_f64(0.125)).tanh(), |s, v| {
        (s * v + (e * x)).sin()
    });
    'l13: for i14 in (k11..1_usize).step_by(2) {
        let mut w15 = (
            ((-(b)) + S::from_f64(0.125)).tanh(),
            [(x * S::from_f64(0.875_f64)).max((S::from_f64(k11 as f64) * S::from_f64(0.25))); 2],
        );
        {
            let (ref mut p, [ref mut q, _]) = w15;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let f = (w15.0 + w15.1[0] * w15.1[1]).tanh();
        let l16 = List(vec![
            (r2[(k11 * k11 + 1) % 2] + S::from_f64(0.125)).tanh(),
            (r1[0] - (S::from_f64(k11 as f64) * S::from_f64(0.25))),
            ((-(p12.a)) + S::from_f64(0.125)).tanh(),
        ]);
        let m17 = &l16
            * &List(vec![
                (p3.b + S::from_f64(0.125)).tanh(),
                (r1[1] * (S::from_f64(i14 as f64) * S::from_f64(0.25))),
                ((e * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin(),
            ]);
        let d = ((m17 * l16.total()).total()).tanh();
    }
    ((x / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
        * (S::from_f64(draw()) * S::from_f64(-0.875_f64)).max(p3.b))
        + b
        + e
        + y
        + x
}

#[differentiable]
fn program_11(x: f64, y: f64) -> f64 {
    let mut c = ((scale() + 0.625_f64).sin() + 0.125).tanh();
    let mut r1 = [(x * 0.75).sin(); 2];
    let d = program_0((x * 0.75).sin(), ((r1[0] + r1[0]) * 0.75).sin()).tanh();
    let g2 = |t: f64| ((y + t) * (y - 0.875_f64).tanh()) * t;
    let e = (g2((d + 0.875_f64).sin()) + g2((r1[1] + r1[1]))).sin();
    'l3: for i4 in 0..=4_usize {
        'l5: for i6 in (i4..4_usize).step_by(2) {
            let a = if (((i6 as f64) * 0.25) - x) < (((i6 as f64) * 0.25) * r1[1]) {
                ((r1[i6 % 2] * -1.125_f64).max(0.125_f64) * (r1[1] * r1[1] + 0.25).sqrt())
            } else {
                ((d - -1.125_f64).tanh() * (y - -0.375_f64))
            };
        }
        let r7 = [((r1[(i4 * i4 + 1) % 2] * -1.125_f64).abs() * 0.75).sin(); 2];
    }
    let z8;
    let mut n9 = 0_usize;
    loop {
        n9 += 1;
        let t = r1[1];
        if n9 > 2 || (r1[1] * e) > (r1[0] * r1[0] + 0.25).sqrt() {
            z8 = ((scale() * r1[1]) * 0.125_f64).cos();
            break;
        }
    }
    let mut t10 = ((e * -0.125_f64).cos() * 0.75).sin();
    let mut add11 = |v: f64| {
        t10 = (t10 * v + d).sin();
        t10 > 0.25
    };
    let c = if add11((draw() * r1[0])) || !add11((c * d)) { -0.375_f64 } else { x };
    let k12 = (draw() * draw() + 0.25).sqrt();
    for part in r1.chunks_exact_mut(2) {
        part[0] = (part[0] * k12).sin();
        part.reverse();
    }
    let mut w13 = (((e - c) + 0.125).tanh(), [d; 2]);
    {
        let (p, [q, _]) = &mut w13;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w13.0 + w13.1[0] * w13.1[1]).tanh();
    if a < (t10 + 0.625_f64) {
        let f = mixed(&r1[..2]).sin();
        let mut n15 = 0_usize;
        'l14: while n15 < 2 {
            n15 += 1;
            let b =
                summed(bent, ((c * -0.875_f64).max(r1[(n15 + 1) % 2]) + 0.125).tanh(), 3).tanh();
            let mut q16 = [
                Ball {
                    height: ((z8 * z8 + 0.25).sqrt() * 0.75).sin(),
                    speed: ((-(z8)) * 0.75).sin(),
                },
                Ball {
                    height: ((r1[n15 % 2] + 0.625_f64).sin() + 0.125).tanh(),
                    speed: ((e * x) * 0.75).sin(),
                },
            ];
            let up17 = q16[n15 % 2].bounce();
            let f = if up17 { q16[1].run(2) } else { (r1[n15 % 2] + c) };
            let d = q16[0].height * q16[1].speed - q16[0].speed;
            let c = program_4(
                ((draw() + z8) + 0.125).tanh(),
                ((-(r1[(n15 * n15 + 1) % 2])) + 0.125).tanh(),
            )
            .tanh();
        }
        r1[0] *= (((-0.625_f64 * -0.625_f64).cos() * -0.375_f64).abs() + 0.125).tanh();
    } else {
        let mut p18 = Pair {
            a: ((r1[1] / (1.5 + d * d)) + 0.125).tanh(),
            b: ((draw() + r1[1]) * 0.75).sin(),
        };
    }
    ((r1[1] / (1.5 + e * e)) * (r1[0] * -0.375_f64).max(z8)) + a + t10 + c + z8 + e + d + y + x
}

fn program_11_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((S::from_f64(scale()) + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut r1 = [(x * S::from_f64(0.75)).sin(); 2];
    let d =
        program_0_of((x * S::from_f64(0.75)).sin(), ((r1[0] + r1[0]) * S::from_f64(0.75)).sin())
            .tanh();
    let g2 = |t: S| ((y + t) * (y - S::from_f64(0.875_f64)).tanh()) * t;
    let e = (g2((d + S::from_f64(0.875_f64)).sin()) + g2((r1[1] + r1[1]))).sin();
    'l3: for i4 in 0..=4_usize {
        'l5: for i6 in (i4..4_usize).step_by(2) {
            let a = if ((S::from_f64(i6 as f64) * S::from_f64(0.25)) - x)
                .cmplt(((S::from_f64(i6 as f64) * S::from_f64(0.25)) * r1[1]))
            {
                ((r1[i6 % 2] * S::from_f64(-1.125_f64)).max(S::from_f64(0.125_f64))
                    * (r1[1] * r1[1] + S::from_f64(0.25)).sqrt())
            } else {
                ((d - S::from_f64(-1.125_f64)).tanh() * (y - S::from_f64(-0.375_f64)))
            };
        }
        let r7 = [((r1[(i4 * i4 + 1) % 2] * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75))
            .sin(); 2];
    }
    let z8;
    let mut n9 = 0_usize;
    loop {
        n9 += 1;
        let t = r1[1];
        if n9 > 2 || (r1[1] * e).cmpgt((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()) {
            z8 = ((S::from_f64(scale()) * r1[1]) * S::from_f64(0.125_f64)).cos();
            break;
        }
    }
    let mut t10 = ((e * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin();
    let mut add11 = |v: S| {
        t10 = (t10 * v + d).sin();
        t10.cmpgt(S::from_f64(0.25))
    };
    let c = if add11((S::from_f64(draw()) * r1[0])) || !add11((c * d)) {
        S::from_f64(-0.375_f64)
    } else {
        x
    };
    let k12 = (S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25)).sqrt();
    for part in r1.chunks_exact_mut(2) {
        part[0] = (part[0] * k12).sin();
        part.reverse();
    }
    let mut w13 = (((e - c) + S::from_f64(0.125)).tanh(), [d; 2]);
    {
        let (p, [q, _]) = &mut w13;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w13.0 + w13.1[0] * w13.1[1]).tanh();
    if a.cmplt((t10 + S::from_f64(0.625_f64))) {
        let f = mixed(&r1[..2]).sin();
        let mut n15 = 0_usize;
        'l14: while n15 < 2 {
            n15 += 1;
            let b = summed(
                bent,
                ((c * S::from_f64(-0.875_f64)).max(r1[(n15 + 1) % 2]) + S::from_f64(0.125)).tanh(),
                3,
            )
            .tanh();
            let mut q16 = [
                Ball {
                    height: ((z8 * z8 + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
                    speed: ((-(z8)) * S::from_f64(0.75)).sin(),
                },
                Ball {
                    height: ((r1[n15 % 2] + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125))
                        .tanh(),
                    speed: ((e * x) * S::from_f64(0.75)).sin(),
                },
            ];
            let up17 = q16[n15 % 2].bounce();
            let f = if up17 { q16[1].run(2) } else { (r1[n15 % 2] + c) };
            let d = q16[0].height * q16[1].speed - q16[0].speed;
            let c = program_4_of(
                ((S::from_f64(draw()) + z8) + S::from_f64(0.125)).tanh(),
                ((-(r1[(n15 * n15 + 1) % 2])) + S::from_f64(0.125)).tanh(),
            )
            .tanh();
        }
        r1[0] = r1[0]
            * (((S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64)).cos()
                * S::from_f64(-0.375_f64))
            .abs()
                + S::from_f64(0.125))
            .tanh();
    } else {
        let mut p18 = Pair {
            a: ((r1[1] / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
            b: ((S::from_f64(draw()) + r1[1]) * S::from_f64(0.75)).sin(),
        };
    }
    ((r1[1] / (S::from_f64(1.5) + e * e)) * (r1[0] * S::from_f64(-0.375_f64)).max(z8))
        + a
        + t10
        + c
        + z8
        + e
        + d
        + y
        + x
}

#[differentiable]
fn program_12(x: f64, y: f64) -> f64 {
    let mut c = ((x + -0.125_f64) + 0.125).tanh();
    let r1 = [((x * -0.125_f64).max(x) + 0.125).tanh(); 2];
    let a = mixed(&r1[0..]).sin();
    'l2: for i3 in 1..3_usize {
        let g4 = |t: f64| ((t * draw()) + -1.125_f64).sin() * t;
        let b = (g4((x + 0.875_f64)) + g4((r1[0] * r1[0] + 0.25).sqrt())).sin();
        let e = match i3 % 4 {
            two => r1[(i3 + 1) % 2],
            k if k > two => (b * b + 0.25).sqrt(),
            _ => r1[i3 % 2],
        };
        let mut w5 = (((a * e) + 0.125).tanh(), [(c + scale()); 2]);
        {
            let (p, [q, _]) = &mut w5;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w5.0 + w5.1[0] * w5.1[1]).tanh();
    }
    'l6: for i7 in 0..=5_usize {
        let z8;
        if i7 % 4 == 0 {
            z8 = ((a + 0.875_f64).sin() * (a + 0.875_f64).sin() + 0.25).sqrt();
        } else {
            z8 = (0.625_f64 - -0.125_f64).tanh();
        }
        let a = match shape(
            ((((i7 as f64) * 0.25) * r1[(i7 * i7 + 1) % 2]) * 0.75).sin(),
            ((x * -0.875_f64).cos() * 0.75).sin(),
        ) {
            Point => (a - x),
            Disc(v) => ((v * v + 0.25).sqrt() * (v * v + 0.25).sqrt() + 0.25).sqrt(),
            Shape::Box { w: v, h } => r1[i7 % 2],
        };
        let mut r9 = [((((i7 as f64) * 0.25) * y) * 0.75).sin(); 2];
    }
    c -= (((-0.375_f64 - c) * 0.625_f64).abs() + 0.125).tanh();
    c -= (((a + draw()) * (x - -0.875_f64).tanh()) + 0.125).tanh();
    let mut u10: Vec<_> = r1.iter().map(|v| *v * c).collect();
    u10.push((y * 0.75).sin());
    u10[0] = u10[1] * u10[u10.len() - 1];
    let a = (mixed(&u10) + u10[0]).tanh();
    let d = match shape((a * 0.75).sin(), ((y + c) * 0.75).sin()) {
        Shape::Point => (r1[0] + r1[1]),
        Shape::Disc(v) => (-(r1[0] * a)),
        Shape::Box { w: v, h } => (-(r1[0] + y)),
    };
    let b: f64 = r1.iter().map(|v| v * (draw() * 0.75).sin()).sum();
    ((-(y)) + r1[1]) + b + d + a + c + y + x
}

fn program_12_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x + S::from_f64(-0.125_f64)) + S::from_f64(0.125)).tanh();
    let r1 = [((x * S::from_f64(-0.125_f64)).max(x) + S::from_f64(0.125)).tanh(); 2];
    let a = mixed(&r1[0..]).sin();
    'l2: for i3 in 1..3_usize {
        let g4 = |t: S| ((t * S::from_f64(draw())) + S::from_f64(-1.125_f64)).sin() * t;
        let b = (g4((x + S::from_f64(0.875_f64))) + g4((r1[0] * r1[0] + S::from_f64(0.25)).sqrt()))
            .sin();
        let e = match i3 % 4 {
            two => r1[(i3 + 1) % 2],
            k if k > two => (b * b + S::from_f64(0.25)).sqrt(),
            _ => r1[i3 % 2],
        };
        let mut w5 = (((a * e) + S::from_f64(0.125)).tanh(), [(c + S::from_f64(scale())); 2]);
        {
            let (p, [q, _]) = &mut w5;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w5.0 + w5.1[0] * w5.1[1]).tanh();
    }
    'l6: for i7 in 0..=5_usize {
        let z8;
        if i7 % 4 == 0 {
            z8 = ((a + S::from_f64(0.875_f64)).sin() * (a + S::from_f64(0.875_f64)).sin()
                + S::from_f64(0.25))
            .sqrt();
        } else {
            z8 = (S::from_f64(0.625_f64) - S::from_f64(-0.125_f64)).tanh();
        }
        let a = match shape(
            (((S::from_f64(i7 as f64) * S::from_f64(0.25)) * r1[(i7 * i7 + 1) % 2])
                * S::from_f64(0.75))
            .sin(),
            ((x * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        ) {
            Point => (a - x),
            Disc(v) => ((v * v + S::from_f64(0.25)).sqrt() * (v * v + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.25))
            .sqrt(),
            Shape::Box { w: v, h } => r1[i7 % 2],
        };
        let mut r9 =
            [(((S::from_f64(i7 as f64) * S::from_f64(0.25)) * y) * S::from_f64(0.75)).sin(); 2];
    }
    c = c
        - (((S::from_f64(-0.375_f64) - c) * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125))
            .tanh();
    c = c
        - (((a + S::from_f64(draw())) * (x - S::from_f64(-0.875_f64)).tanh()) + S::from_f64(0.125))
            .tanh();
    let mut u10: Vec<_> = r1.iter().map(|v| *v * c).collect();
    u10.push((y * S::from_f64(0.75)).sin());
    u10[0] = u10[1] * u10[u10.len() - 1];
    let a = (mixed(&u10) + u10[0]).tanh();
    let d = match shape((a * S::from_f64(0.75)).sin(), ((y + c) * S::from_f64(0.75)).sin()) {
        Shape::Point => (r1[0] + r1[1]),
        Shape::Disc(v) => (-(r1[0] * a)),
        Shape::Box { w: v, h } => (-(r1[0] + y)),
    };
    let b = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * (S::from_f64(draw()) * S::from_f64(0.75)).sin());
    ((-(y)) + r1[1]) + b + d + a + c + y + x
}

#[differentiable]
fn program_13(x: f64, y: f64) -> f64 {
    let mut c = (x * 0.75).sin();
    let mut r1 = [(y + 0.125).tanh(); 4];
    let by2 = ((y * 0.875_f64).cos() * 0.75).sin();
    let e = shifted(&mut r1[3..], by2);
    'l3: for i4 in (0..0_usize).rev() {
        if (-(c)) < (e / (1.5 + r1[(i4 * i4 + 1) % 4] * r1[(i4 * i4 + 1) % 4])) {
            break;
        }
        let g5 = |t: f64, v: &[f64]| mixed(v) * t + (((e + r1[i4 % 4]) * 0.625_f64).cos()).tanh();
        let c = folded(&g5, ((r1[2] * -0.875_f64).abs() + 0.125).tanh(), &r1).sin();
    }
    #[differentiable(checkpoint)]
    'l6: for i7 in 1..2_usize {
        let by8 = (c * 0.75).sin();
        let m9 = &mut r1;
        if raises(m9) && !raises(m9) {
            m9[0] = by8 * m9[1];
        }
        let k10: usize = raised(m9);
        let l11 = List(vec![
            ((e * x) + 0.125).tanh(),
            (-(y)),
            ((r1[k10 % 4] * r1[k10 % 4] + 0.25).sqrt() * 0.75).sin(),
        ]);
        let m12 = &l11
            * &List(vec![
                ((0.875_f64 - 0.375_f64) + 0.125).tanh(),
                (-1.125_f64 + -0.375_f64),
                ((y / (1.5 + 0.625_f64 * 0.625_f64)) + 0.125).tanh(),
            ]);
        let a = ((-&m12 + l11).total()).tanh();
    }
    let mut q13 = [
        Ball {
            height: ((e + r1[1]) * 0.75).sin(),
            speed: ((c * 0.625_f64).max(r1[1]) + 0.125).tanh(),
        },
        Ball {
            height: ((draw() * draw() + 0.25).sqrt() * 0.75).sin(),
            speed: ((r1[1] * 0.125_f64).abs() * 0.75).sin(),
        },
    ];
    let up14 = q13[0].bounce();
    let a = if up14 { q13[1].run(0) } else { (-1.125_f64 + r1[3]) };
    let b = q13[0].height * q13[1].speed - q13[0].speed;
    let mut z15;
    let mut n16 = 0_usize;
    loop {
        n16 += 1;
        let t = ((y * -0.375_f64).cos() * 0.125_f64).max(draw());
        if n16 > 2 || (x * 0.375_f64).max(e) <= (x + r1[1]) {
            z15 = r1[3];
            break;
        }
    }
    z15 = z15 * (-(b));
    let e = ((a + b) - 0.125_f64).tanh();
    let d = mixed(&r1[..4]).sin();
    'l17: for i18 in (2..2_usize).step_by(2) {
        let guard19 = Guard::set(-0.25);
        let mut r20 = [
            ((y * a) * 0.75).sin(),
            (a * 0.75).sin(),
            ((r1[i18 % 4] + scale()) + 0.125).tanh(),
            ((c * y) * 0.75).sin(),
        ];
    }
    -1.125_f64 + d + e + z15 + b + a + c + y + x
}

fn program_13_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (x * S::from_f64(0.75)).sin();
    let mut r1 = [(y + S::from_f64(0.125)).tanh(); 4];
    let by2 = ((y * S::from_f64(0.875_f64)).cos() * S::from_f64(0.75)).sin();
    let e = shifted(&mut r1[3..], by2);
    'l3: for i4 in (0..0_usize).rev() {
        if (-(c)).cmplt((e / (S::from_f64(1.5) + r1[(i4 * i4 + 1) % 4] * r1[(i4 * i4 + 1) % 4]))) {
            break;
        }
        let g5 = |t: S, v: &[S]| {
            mixed(v) * t + (((e + r1[i4 % 4]) * S::from_f64(0.625_f64)).cos()).tanh()
        };
        let c =
            folded(&g5, ((r1[2] * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(), &r1)
                .sin();
    }

    'l6: for i7 in 1..2_usize {
        let by8 = (c * S::from_f64(0.75)).sin();
        let m9 = &mut r1;
        if raises(m9) && !raises(m9) {
            m9[0] = by8 * m9[1];
        }
        let k10: usize = raised(m9);
        let l11 = List(vec![
            ((e * x) + S::from_f64(0.125)).tanh(),
            (-(y)),
            ((r1[k10 % 4] * r1[k10 % 4] + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ]);
        let m12 = &l11
            * &List(vec![
                ((S::from_f64(0.875_f64) - S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
                (S::from_f64(-1.125_f64) + S::from_f64(-0.375_f64)),
                ((y / (S::from_f64(1.5) + S::from_f64(0.625_f64) * S::from_f64(0.625_f64)))
                    + S::from_f64(0.125))
                .tanh(),
            ]);
        let a = ((-&m12 + l11).total()).tanh();
    }
    let mut q13 = [
        Ball {
            height: ((e + r1[1]) * S::from_f64(0.75)).sin(),
            speed: ((c * S::from_f64(0.625_f64)).max(r1[1]) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25)).sqrt()
                * S::from_f64(0.75))
            .sin(),
            speed: ((r1[1] * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        },
    ];
    let up14 = q13[0].bounce();
    let a = if up14 { q13[1].run(0) } else { (S::from_f64(-1.125_f64) + r1[3]) };
    let b = q13[0].height * q13[1].speed - q13[0].speed;
    let mut z15;
    let mut n16 = 0_usize;
    loop {
        n16 += 1;
        let t =
            ((y * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.125_f64)).max(S::from_f64(draw()));
        if n16 > 2 || (x * S::from_f64(0.375_f64)).max(e).cmple((x + r1[1])) {
            z15 = r1[3];
            break;
        }
    }
    z15 = z15 * (-(b));
    let e = ((a + b) - S::from_f64(0.125_f64)).tanh();
    let d = mixed(&r1[..4]).sin();
    'l17: for i18 in (2..2_usize).step_by(2) {
        let guard19 = Guard::set(-0.25);
        let mut r20 = [
            ((y * a) * S::from_f64(0.75)).sin(),
            (a * S::from_f64(0.75)).sin(),
            ((r1[i18 % 4] + S::from_f64(scale())) + S::from_f64(0.125)).tanh(),
            ((c * y) * S::from_f64(0.75)).sin(),
        ];
    }
    S::from_f64(-1.125_f64) + d + e + z15 + b + a + c + y + x
}

#[differentiable]
fn program_14(x: f64, y: f64) -> f64 {
    let mut d = ((-(scale())) * 0.75).sin();
    let r1 = [(x * 0.75).sin(); 5];
    d -= (((y - d) - -0.125_f64).tanh() + 0.125).tanh();
    let a: f64 = r1.iter().map(|v| v * ((d + draw()) + 0.125).tanh()).sum();
    let mut p2 =
        Pair { a: ((scale() + r1[4]) * 0.75).sin(), b: ((y + -0.875_f64).sin() + 0.125).tanh() };
    d = (((p2.a * x) + -1.125_f64).sin() * 0.75).sin();
    p2 = (p2 * Pair { a: (d + 0.125).tanh(), b: ((draw() + r1[3]) + 0.125).tanh() }
        + Pair {
            a: ((scale() * 0.875_f64).abs() * 0.75).sin(),
            b: ((-0.875_f64 * -0.875_f64 + 0.25).sqrt() + 0.125).tanh(),
        })
    .tamed();
    p2 = p2.tamed();
    let f = ((r1[2] * r1[2] + 0.25).sqrt() * -1.125_f64).max(y);
    'l3: for i4 in 0..4_usize {
        let f = if (r1[i4 % 5] + 0.125_f64) < (draw() * draw() + 0.25).sqrt() {
            (f + (draw() - draw()))
        } else {
            ((r1[(i4 * i4 + 1) % 5] * r1[(i4 + 2) % 5]) - p2.b)
        };
    }
    for v in r1.iter().cycle().take(0) {
        d = (d + *v).sin();
    }
    let e = root((p2.b * p2.b + 0.25).sqrt())
        .map_or((r1[3] * p2.a), |v| ((r1[3] + 0.875_f64).sin() * p2.a));
    let e = summed(
        |t: f64| (((f + x) - (a - -1.125_f64).tanh()) * t).sin(),
        ((f * -0.375_f64).abs() * 0.75).sin(),
        0,
    )
    .tanh();
    d = (((e * -0.625_f64).max(-0.125_f64) * (e * -0.625_f64).max(-0.125_f64) + 0.25).sqrt()
        + 0.125)
        .tanh();
    let c = match roots((y + r1[4]), (x * -0.125_f64).abs()) {
        Ok(v) => ((d * 0.375_f64).max(p2.b) * 0.625_f64).max(-1.125_f64),
        Err(true) => d,
        Err(_) => (r1[0] * -0.625_f64).max(r1[1]),
    };
    let mut r5 = [((r1[1] * r1[4]) + 0.125).tanh(), (x * 0.75).sin()];
    (-(d - r5[0])) + c + e + f + a + d + y + x
}

fn program_14_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((-(S::from_f64(scale()))) * S::from_f64(0.75)).sin();
    let r1 = [(x * S::from_f64(0.75)).sin(); 5];
    d = d - (((y - d) - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh();
    let a = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((d + S::from_f64(draw())) + S::from_f64(0.125)).tanh()
    });
    let mut p2 = Pair {
        a: ((S::from_f64(scale()) + r1[4]) * S::from_f64(0.75)).sin(),
        b: ((y + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
    };
    d = (((p2.a * x) + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin();
    p2 =
        (p2 * Pair {
            a: (d + S::from_f64(0.125)).tanh(),
            b: ((S::from_f64(draw()) + r1[3]) + S::from_f64(0.125)).tanh(),
        } + Pair {
            a: ((S::from_f64(scale()) * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
            b: ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.125))
            .tanh(),
        })
        .tamed();
    p2 = p2.tamed();
    let f = ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() * S::from_f64(-1.125_f64)).max(y);
    'l3: for i4 in 0..4_usize {
        let f = if (r1[i4 % 5] + S::from_f64(0.125_f64))
            .cmplt((S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25)).sqrt())
        {
            (f + (S::from_f64(draw()) - S::from_f64(draw())))
        } else {
            ((r1[(i4 * i4 + 1) % 5] * r1[(i4 + 2) % 5]) - p2.b)
        };
    }
    for v in r1.iter().cycle().take(0) {
        d = (d + *v).sin();
    }
    let e = root((p2.b * p2.b + S::from_f64(0.25)).sqrt())
        .map_or((r1[3] * p2.a), |v| ((r1[3] + S::from_f64(0.875_f64)).sin() * p2.a));
    let e = summed(
        |t: S| (((f + x) - (a - S::from_f64(-1.125_f64)).tanh()) * t).sin(),
        ((f * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin(),
        0,
    )
    .tanh();
    d = (((e * S::from_f64(-0.625_f64)).max(S::from_f64(-0.125_f64))
        * (e * S::from_f64(-0.625_f64)).max(S::from_f64(-0.125_f64))
        + S::from_f64(0.25))
    .sqrt()
        + S::from_f64(0.125))
    .tanh();
    let c = match roots((y + r1[4]), (x * S::from_f64(-0.125_f64)).abs()) {
        Ok(v) => ((d * S::from_f64(0.375_f64)).max(p2.b) * S::from_f64(0.625_f64))
            .max(S::from_f64(-1.125_f64)),
        Err(true) => d,
        Err(_) => (r1[0] * S::from_f64(-0.625_f64)).max(r1[1]),
    };
    let mut r5 = [((r1[1] * r1[4]) + S::from_f64(0.125)).tanh(), (x * S::from_f64(0.75)).sin()];
    (-(d - r5[0])) + c + e + f + a + d + y + x
}

#[differentiable]
fn program_15(x: f64, y: f64) -> f64 {
    let mut d = ((x * x) * 0.75).sin();
    let r1 = [((x - -0.625_f64).tanh() + 0.125).tanh(); 5];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * r1[4]).collect();
    u2.push(((d + y) + 0.125).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let r3 = [((d * r1[0]) * 0.75).sin(), ((y * d) + 0.125).tanh()];
    let mut p4 = Pair {
        a: ((r1[4] + r1[1]) + 0.125).tanh(),
        b: ((r3[1] * -0.125_f64).max(r3[1]) * 0.75).sin(),
    };
    let mut r5 = [((r1[4] * r1[4] + 0.25).sqrt() + 0.125).tanh(); 5];
    let l6 = List(vec![
        ((r1[3] - 0.875_f64).tanh() + 0.125).tanh(),
        (r1[1] * 0.125_f64).cos(),
        (p4.a * 0.75).sin(),
    ]);
    let m7 = &l6
        * &List(vec![
            ((-0.875_f64 * -0.875_f64 + 0.25).sqrt() + 0.125).tanh(),
            (-0.625_f64 / (1.5 + y * y)),
            ((r1[0] * x) + 0.125).tanh(),
        ]);
    let c = ((&(&l6 * &m7) * &m7).total() * l6.total()).tanh();
    if (-1.125_f64 * y) <= (-0.875_f64 * -0.875_f64 + 0.25).sqrt() {
        let mut t8 = ((p4.a + y) + 0.125).tanh();
        let mut add9 = |v: f64| {
            t8 = (t8 * v + ((x * 0.625_f64).abs() * (x * 0.625_f64).abs() + 0.25).sqrt()).sin();
            t8 > 0.25
        };
        let e = if add9((p4.a + x)) || !add9((r3[1] * r3[0])) { r5[2] } else { (draw() + x) };
        let by10 = ((scale() + -0.625_f64).sin() + 0.125).tanh();
        let m11 = &mut r5;
        if raises(m11) && !raises(m11) {
            m11[0] = by10 * m11[1];
        }
        let k12: usize = raised(m11);
    }
    if (x * 0.875_f64).cos() <= (y * -0.875_f64).max(y) {
        let a = ((r5[4] * -1.125_f64).max(r1[2]) + (r1[3] * r3[1]));
        'l13: for i14 in 0..=2_usize {
            let f = mixed(&r3[1..]).sin();
        }
        p4 = (Pair { a: ((a + r1[3]) * 0.75).sin(), b: ((a * r5[2]) * 0.75).sin() }
            - p4 * ((-(draw())) + 0.125).tanh())
        .tamed();
        p4 = p4.tamed();
    }
    'l15: for i16 in 2..2_usize {
        let mut d = ((r3[(i16 * i16 + 1) % 2] * c) * 0.75).sin();
        if i16 % 2 == 1 {
            let d = ((-(r1[1])) * (-(r1[1])) + 0.25).sqrt();
            let d = if i16 % 2 == 0 {
                (d * d + 0.25).sqrt()
            } else {
                ((r3[i16 % 2] + ((i16 as f64) * 0.25)) * -0.625_f64).abs()
            };
        } else {
            'l17: for i18 in (2..3_usize).step_by(2) {
                let a = ((x - p4.b) * 0.875_f64).abs();
                for k19 in 0..raised(&mut r5) % 5 {
                    r5[k19] = ((p4.b * -0.875_f64).cos() + 0.125).tanh();
                }
                r5[2] = ((-(r1[(i18 + 3) % 5] + x)) * 0.75).sin();
            }
            let f = if i16 % 2 == 1 {
                ((c * -0.375_f64).max(r3[i16 % 2]) * (0.375_f64 * c))
            } else {
                x
            };
            let mut n20 = 0_usize;
            while raises(&mut r5) && n20 < 3 {
                n20 += 1;
            }
        }
        let d = List(vec![
            ((draw() / (1.5 + d * d)) + 0.125).tanh(),
            (p4.b * r5[i16 % 5]),
            ((x * 0.125_f64).max(y) + 0.125).tanh(),
        ])
        .folded(((d * -0.875_f64).max(p4.b) + 0.125).tanh(), |s, v| {
            (s * v + (y * -0.125_f64).abs()).sin()
        });
    }
    ((r5[4] - -0.625_f64).tanh() * (c + d)) + c + d + y + x
}

fn program_15_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * x) * S::from_f64(0.75)).sin();
    let r1 = [((x - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh(); 5];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * r1[4]).collect();
    u2.push(((d + y) + S::from_f64(0.125)).tanh());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let d = (mixed(&u2) + u2[0]).tanh();
    let r3 = [((d * r1[0]) * S::from_f64(0.75)).sin(), ((y * d) + S::from_f64(0.125)).tanh()];
    let mut p4 = Pair {
        a: ((r1[4] + r1[1]) + S::from_f64(0.125)).tanh(),
        b: ((r3[1] * S::from_f64(-0.125_f64)).max(r3[1]) * S::from_f64(0.75)).sin(),
    };
    let mut r5 = [((r1[4] * r1[4] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(); 5];
    let l6 = List(vec![
        ((r1[3] - S::from_f64(0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        (r1[1] * S::from_f64(0.125_f64)).cos(),
        (p4.a * S::from_f64(0.75)).sin(),
    ]);
    let m7 = &l6
        * &List(vec![
            ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
                + S::from_f64(0.125))
            .tanh(),
            (S::from_f64(-0.625_f64) / (S::from_f64(1.5) + y * y)),
            ((r1[0] * x) + S::from_f64(0.125)).tanh(),
        ]);
    let c = ((&(&l6 * &m7) * &m7).total() * l6.total()).tanh();
    if (S::from_f64(-1.125_f64) * y)
        .cmple((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt())
    {
        let mut t8 = ((p4.a + y) + S::from_f64(0.125)).tanh();
        let mut add9 = |v: S| {
            t8 = (t8 * v
                + ((x * S::from_f64(0.625_f64)).abs() * (x * S::from_f64(0.625_f64)).abs()
                    + S::from_f64(0.25))
                .sqrt())
            .sin();
            t8.cmpgt(S::from_f64(0.25))
        };
        let e = if add9((p4.a + x)) || !add9((r3[1] * r3[0])) {
            r5[2]
        } else {
            (S::from_f64(draw()) + x)
        };
        let by10 =
            ((S::from_f64(scale()) + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh();
        let m11 = &mut r5;
        if raises(m11) && !raises(m11) {
            m11[0] = by10 * m11[1];
        }
        let k12: usize = raised(m11);
    }
    if (x * S::from_f64(0.875_f64)).cos().cmple((y * S::from_f64(-0.875_f64)).max(y)) {
        let a = ((r5[4] * S::from_f64(-1.125_f64)).max(r1[2]) + (r1[3] * r3[1]));
        'l13: for i14 in 0..=2_usize {
            let f = mixed(&r3[1..]).sin();
        }
        p4 = (Pair {
            a: ((a + r1[3]) * S::from_f64(0.75)).sin(),
            b: ((a * r5[2]) * S::from_f64(0.75)).sin(),
        } - p4 * ((-(S::from_f64(draw()))) + S::from_f64(0.125)).tanh())
        .tamed();
        p4 = p4.tamed();
    }
    'l15: for i16 in 2..2_usize {
        let mut d = ((r3[(i16 * i16 + 1) % 2] * c) * S::from_f64(0.75)).sin();
        if i16 % 2 == 1 {
            let d = ((-(r1[1])) * (-(r1[1])) + S::from_f64(0.25)).sqrt();
            let d = if i16 % 2 == 0 {
                (d * d + S::from_f64(0.25)).sqrt()
            } else {
                ((r3[i16 % 2] + (S::from_f64(i16 as f64) * S::from_f64(0.25)))
                    * S::from_f64(-0.625_f64))
                .abs()
            };
        } else {
            'l17: for i18 in (2..3_usize).step_by(2) {
                let a = ((x - p4.b) * S::from_f64(0.875_f64)).abs();
                for k19 in 0..raised(&mut r5) % 5 {
                    r5[k19] = ((p4.b * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.125)).tanh();
                }
                r5[2] = ((-(r1[(i18 + 3) % 5] + x)) * S::from_f64(0.75)).sin();
            }
            let f = if i16 % 2 == 1 {
                ((c * S::from_f64(-0.375_f64)).max(r3[i16 % 2]) * (S::from_f64(0.375_f64) * c))
            } else {
                x
            };
            let mut n20 = 0_usize;
            while raises(&mut r5) && n20 < 3 {
                n20 += 1;
            }
        }
        let d = List(vec![
            ((S::from_f64(draw()) / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
            (p4.b * r5[i16 % 5]),
            ((x * S::from_f64(0.125_f64)).max(y) + S::from_f64(0.125)).tanh(),
        ])
        .folded(((d * S::from_f64(-0.875_f64)).max(p4.b) + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (y * S::from_f64(-0.125_f64)).abs()).sin()
        });
    }
    ((r5[4] - S::from_f64(-0.625_f64)).tanh() * (c + d)) + c + d + y + x
}

#[differentiable]
fn program_16(x: f64, y: f64) -> f64 {
    let mut d = ((x * -1.125_f64).max(x) + 0.125).tanh();
    let mut r1 = [((x * y) + 0.125).tanh(); 3];
    let mut q2 = [
        Ball { height: ((x * x + 0.25).sqrt() + 0.125).tanh(), speed: ((x + d) + 0.125).tanh() },
        Ball {
            height: ((d * -0.125_f64).cos() + 0.125).tanh(),
            speed: ((r1[1] * -0.375_f64).abs() + 0.125).tanh(),
        },
    ];
    let up3 = q2[1].bounce();
    let d = if up3 { q2[1].run(1) } else { (scale() + r1[0]) };
    let e = q2[0].height * q2[1].speed - q2[0].speed;
    let c = r1[raised(&mut r1) % 3] * (e * 0.875_f64).abs();
    let mut c = ((-(r1[0])) + 0.125).tanh();
    if (c * c) >= (scale() * e) {
        if (c - -0.625_f64).tanh() > (scale() + d) {
            let c = (x * (x - x));
        } else {
            let mut f = ((-(y)) + 0.125).tanh();
            r1[0] = (((-(r1[1])) * 0.125_f64).cos() + 0.125).tanh();
            'l5: for i6 in 1..2_usize {
                r1[2] *= ((-(f + c)) + 0.125).tanh();
                f = (((y * 0.125_f64).max(draw()) * (y * 0.625_f64)) + 0.125).tanh();
                let d = mixed(&r1).sin();
            }
        }
        let mut p7 = Pair { a: ((-(c)) + 0.125).tanh(), b: ((-(c)) + 0.125).tanh() };
        let mut u8: Vec<_> = r1.iter().map(|v| *v * scale()).collect();
        u8.push(((e + p7.a) + 0.125).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let c = (mixed(&u8) + u8[0]).tanh();
    }
    ((-(r1[1])) * 0.875_f64).cos() + c + e + d + y + x
}

fn program_16_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(-1.125_f64)).max(x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x * y) + S::from_f64(0.125)).tanh(); 3];
    let mut q2 = [
        Ball {
            height: ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            speed: ((x + d) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((d * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
            speed: ((r1[1] * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        },
    ];
    let up3 = q2[1].bounce();
    let d = if up3 { q2[1].run(1) } else { (S::from_f64(scale()) + r1[0]) };
    let e = q2[0].height * q2[1].speed - q2[0].speed;
    let c = r1[raised(&mut r1) % 3] * (e * S::from_f64(0.875_f64)).abs();
    let mut c = ((-(r1[0])) + S::from_f64(0.125)).tanh();
    if (c * c).cmpge((S::from_f64(scale()) * e)) {
        if (c - S::from_f64(-0.625_f64)).tanh().cmpgt((S::from_f64(scale()) + d)) {
            let c = (x * (x - x));
        } else {
            let mut f = ((-(y)) + S::from_f64(0.125)).tanh();
            r1[0] = (((-(r1[1])) * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh();
            'l5: for i6 in 1..2_usize {
                r1[2] = r1[2] * ((-(f + c)) + S::from_f64(0.125)).tanh();
                f = (((y * S::from_f64(0.125_f64)).max(S::from_f64(draw()))
                    * (y * S::from_f64(0.625_f64)))
                    + S::from_f64(0.125))
                .tanh();
                let d = mixed(&r1).sin();
            }
        }
        let mut p7 = Pair {
            a: ((-(c)) + S::from_f64(0.125)).tanh(),
            b: ((-(c)) + S::from_f64(0.125)).tanh(),
        };
        let mut u8: Vec<_> = r1.iter().map(|v| *v * S::from_f64(scale())).collect();
        u8.push(((e + p7.a) + S::from_f64(0.125)).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let c = (mixed(&u8) + u8[0]).tanh();
    }
    ((-(r1[1])) * S::from_f64(0.875_f64)).cos() + c + e + d + y + x
}

#[differentiable]
fn program_17(x: f64, y: f64) -> f64 {
    let mut d = (x + 0.125).tanh();
    let mut r1 = [((x + d) * 0.75).sin(); 3];
    d = (((x * 0.875_f64).cos() * -0.875_f64).max(0.125_f64) + 0.125).tanh();
    let mut f = ((x * x + 0.25).sqrt() + 0.125).tanh();
    let mut p2 =
        Pair { a: ((r1[1] / (1.5 + y * y)) + 0.125).tanh(), b: ((y / (1.5 + d * d)) * 0.75).sin() };
    'l3: for i4 in 0..3_usize {
        if (-0.625_f64 * -0.375_f64) <= (x * -0.875_f64).max(x) {
            for v in r1.iter() {
                f = f * ((x - x) + 0.125).tanh() + *v * ((x - x) + 0.125).tanh();
            }
        } else {
            let e = summed(
                |t: f64| (((((i4 as f64) * 0.25) + r1[0]) * -1.125_f64).max(r1[i4 % 3]) * t).sin(),
                ((r1[(i4 * i4 + 1) % 3] + x) * 0.75).sin(),
                2,
            )
            .tanh();
            if i4 % 4 == 0 {
                let (a, mut b) = (((r1[1] - -0.375_f64).tanh() + 0.125).tanh(), r1[2]);
                let mut u5: Vec<_> = r1.iter().map(|v| *v * ((i4 as f64) * 0.25)).collect();
                u5.push(((draw() - 0.125_f64).tanh() * 0.75).sin());
                u5[0] = u5[1] * u5[u5.len() - 1];
                let f = (mixed(&u5) + u5[0]).tanh();
            }
            let c = if let Some(v) = root((d * e)) {
                ((r1[i4 % 3] * r1[i4 % 3] + 0.25).sqrt() / (1.5 + (d * x) * (d * x)))
            } else {
                (d - -0.375_f64)
            };
        }
        p2.turn(((0.625_f64 * r1[0]) + 0.125).tanh());
        p2 = p2.tamed();
        if (r1[(i4 + 1) % 3] * r1[(i4 + 1) % 3] + 0.25).sqrt() < (scale() * 0.875_f64).abs() {
            let (a, mut b) = (
                ((r1[(i4 * i4 + 1) % 3] - r1[(i4 * i4 + 1) % 3]) + 0.125).tanh(),
                (d - -0.375_f64).tanh(),
            );
        }
    }
    ((x * 0.375_f64) * (d + r1[0])) + f + d + y + x
}

fn program_17_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = (x + S::from_f64(0.125)).tanh();
    let mut r1 = [((x + d) * S::from_f64(0.75)).sin(); 3];
    d = (((x * S::from_f64(0.875_f64)).cos() * S::from_f64(-0.875_f64))
        .max(S::from_f64(0.125_f64))
        + S::from_f64(0.125))
    .tanh();
    let mut f = ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut p2 = Pair {
        a: ((r1[1] / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        b: ((y / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
    };
    'l3: for i4 in 0..3_usize {
        if (S::from_f64(-0.625_f64) * S::from_f64(-0.375_f64))
            .cmple((x * S::from_f64(-0.875_f64)).max(x))
        {
            for v in r1.iter() {
                f = f * ((x - x) + S::from_f64(0.125)).tanh()
                    + *v * ((x - x) + S::from_f64(0.125)).tanh();
            }
        } else {
            let e = summed(
                |t: S| {
                    ((((S::from_f64(i4 as f64) * S::from_f64(0.25)) + r1[0])
                        * S::from_f64(-1.125_f64))
                    .max(r1[i4 % 3])
                        * t)
                        .sin()
                },
                ((r1[(i4 * i4 + 1) % 3] + x) * S::from_f64(0.75)).sin(),
                2,
            )
            .tanh();
            if i4 % 4 == 0 {
                let (a, mut b) =
                    (((r1[1] - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(), r1[2]);
                let mut u5: Vec<_> =
                    r1.iter().map(|v| *v * (S::from_f64(i4 as f64) * S::from_f64(0.25))).collect();
                u5.push(
                    ((S::from_f64(draw()) - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75))
                        .sin(),
                );
                u5[0] = u5[1] * u5[u5.len() - 1];
                let f = (mixed(&u5) + u5[0]).tanh();
            }
            let c = if let Some(v) = root((d * e)) {
                ((r1[i4 % 3] * r1[i4 % 3] + S::from_f64(0.25)).sqrt()
                    / (S::from_f64(1.5) + (d * x) * (d * x)))
            } else {
                (d - S::from_f64(-0.375_f64))
            };
        }
        p2.turn(((S::from_f64(0.625_f64) * r1[0]) + S::from_f64(0.125)).tanh());
        p2 = p2.tamed();
        if (r1[(i4 + 1) % 3] * r1[(i4 + 1) % 3] + S::from_f64(0.25))
            .sqrt()
            .cmplt((S::from_f64(scale()) * S::from_f64(0.875_f64)).abs())
        {
            let (a, mut b) = (
                ((r1[(i4 * i4 + 1) % 3] - r1[(i4 * i4 + 1) % 3]) + S::from_f64(0.125)).tanh(),
                (d - S::from_f64(-0.375_f64)).tanh(),
            );
        }
    }
    ((x * S::from_f64(0.375_f64)) * (d + r1[0])) + f + d + y + x
}

of_parts!(#[differentiable] program_18 (x, y: f64) f64::from, y + (y * -0.625_f64).max(y), if (x * x + 0.25).sqrt() < (x / (1.5 + x * x)) { x } else { (y + 0.625_f64) }, -x * (x * -0.875_f64).abs());
of_parts!(program_18_of<S> (x, y: S) S::from_f64, y + (y * S::from_f64(-0.625_f64)).max(y), if (x * x + S::from_f64(0.25)).sqrt().cmplt((x / (S::from_f64(1.5) + x * x))) { x } else { (y + S::from_f64(0.625_f64)) }, -x * (x * S::from_f64(-0.875_f64)).abs());

of_parts!(#[differentiable] program_19 (x, y: f64) f64::from, if x > (y * -0.875_f64).cos() { y } else { (y * y) }, if x > (y - -0.625_f64).tanh() { draw() } else { (y * x) }, x - (y - y));
of_parts!(program_19_of<S> (x, y: S) S::from_f64, if x.cmpgt((y * S::from_f64(-0.875_f64)).cos()) { y } else { (y * y) }, if x.cmpgt((y - S::from_f64(-0.625_f64)).tanh()) { S::from_f64(draw()) } else { (y * x) }, x - (y - y));

#[differentiable]
fn program_20(x: f64, y: f64) -> f64 {
    let mut d = ((x * 0.375_f64).cos() + 0.125).tanh();
    let mut r1 = [(d * 0.75).sin(); 4];
    let b = List(vec![
        ((y * y + 0.25).sqrt() * 0.75).sin(),
        (x * -1.125_f64).abs(),
        ((r1[0] * 0.125_f64).max(d) * 0.75).sin(),
    ])
    .folded(((d - -0.125_f64).tanh() * 0.75).sin(), |s, v| (s * v + (scale() - r1[0])).sin());
    let r2 = [((d - -0.625_f64).tanh() + 0.125).tanh(); 2];
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let c = mixed(&r2).sin();
    let d = match shape(((x + r1[3]) * 0.75).sin(), (x + 0.125).tanh()) {
        Point => (b * -1.125_f64).cos(),
        Disc(v) => r2[0],
        Shape::Box { w: v, h } => c,
    };
    let l3 = List(vec![
        ((d * 0.375_f64).abs() + 0.125).tanh(),
        (d / (1.5 + r2[0] * r2[0])),
        ((x * scale()) + 0.125).tanh(),
    ]);
    let m4 = &l3 * &List(vec![(x * 0.75).sin(), (y * x), ((d + x) + 0.125).tanh()]);
    let a = ((&(&l3 * &m4) * &m4).total() * l3.total()).tanh();
    let b = summed(
        |t: f64| (((scale() + r1[0]) * (x / (1.5 + draw() * draw()))) * t).sin(),
        ((-(a)) * 0.75).sin(),
        1,
    )
    .tanh();
    let p5 = Pair { a: (-0.875_f64 * -0.875_f64 + 0.25).sqrt(), b: (r1[0] + 0.125).tanh() };
    let c = (<Pair<f64> as Soft>::pressed(&p5) + Hard::pressed(&p5) * p5.pressed()).tamed().a;
    let c = match shape(((d / (1.5 + y * y)) + 0.125).tanh(), ((x * -1.125_f64).cos() * 0.75).sin())
    {
        Point => (a / (1.5 + r2[1] * r2[1])),
        Disc(v) => ((a * a + 0.25).sqrt() * (y * r2[0])),
        Shape::Box { w: v, h } => ((r2[1] - y) / (1.5 + (a + h) * (a + h))),
    };
    let b = ((y * b) / (1.5 + a * a));
    let mut f = ((r1[2] - -0.875_f64).tanh() * 0.75).sin();
    if (-0.875_f64 * r1[0]) < (r2[1] * a) {
        let mut p6 = Pair { a: ((f * f + 0.25).sqrt() * 0.75).sin(), b: (a * 0.75).sin() };
    } else {
        assert!(raises(&mut r1) || true, "{}", r1.len());
        let mut p7 = Pair { a: ((c * f) * 0.75).sin(), b: (c * 0.75).sin() };
    }
    ((c * c + 0.25).sqrt()
        / (1.5 + (c / (1.5 + scale() * scale())) * (c / (1.5 + scale() * scale()))))
        + f
        + b
        + c
        + a
        + d
        + y
        + x
}

fn program_20_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh();
    let mut r1 = [(d * S::from_f64(0.75)).sin(); 4];
    let b = List(vec![
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        (x * S::from_f64(-1.125_f64)).abs(),
        ((r1[0] * S::from_f64(0.125_f64)).max(d) * S::from_f64(0.75)).sin(),
    ])
    .folded(((d - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin(), |s, v| {
        (s * v + (S::from_f64(scale()) - r1[0])).sin()
    });
    let r2 = [((d - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.125)).tanh(); 2];
    assert!(raises(&mut r1) || true, "{}", r1.len());
    let c = mixed(&r2).sin();
    let d = match shape(((x + r1[3]) * S::from_f64(0.75)).sin(), (x + S::from_f64(0.125)).tanh()) {
        Point => (b * S::from_f64(-1.125_f64)).cos(),
        Disc(v) => r2[0],
        Shape::Box { w: v, h } => c,
    };
    let l3 = List(vec![
        ((d * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        (d / (S::from_f64(1.5) + r2[0] * r2[0])),
        ((x * S::from_f64(scale())) + S::from_f64(0.125)).tanh(),
    ]);
    let m4 = &l3
        * &List(vec![
            (x * S::from_f64(0.75)).sin(),
            (y * x),
            ((d + x) + S::from_f64(0.125)).tanh(),
        ]);
    let a = ((&(&l3 * &m4) * &m4).total() * l3.total()).tanh();
    let b = summed(
        |t: S| {
            (((S::from_f64(scale()) + r1[0])
                * (x / (S::from_f64(1.5) + S::from_f64(draw()) * S::from_f64(draw()))))
                * t)
                .sin()
        },
        ((-(a)) * S::from_f64(0.75)).sin(),
        1,
    )
    .tanh();
    let p5 = Pair {
        a: (S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt(),
        b: (r1[0] + S::from_f64(0.125)).tanh(),
    };
    let c = (<Pair<S> as Soft>::pressed(&p5) + Hard::pressed(&p5) * p5.pressed()).tamed().a;
    let c = match shape(
        ((d / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
    ) {
        Point => (a / (S::from_f64(1.5) + r2[1] * r2[1])),
        Disc(v) => ((a * a + S::from_f64(0.25)).sqrt() * (y * r2[0])),
        Shape::Box { w: v, h } => ((r2[1] - y) / (S::from_f64(1.5) + (a + h) * (a + h))),
    };
    let b = ((y * b) / (S::from_f64(1.5) + a * a));
    let mut f = ((r1[2] - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    if (S::from_f64(-0.875_f64) * r1[0]).cmplt((r2[1] * a)) {
        let mut p6 = Pair {
            a: ((f * f + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            b: (a * S::from_f64(0.75)).sin(),
        };
    } else {
        assert!(raises(&mut r1) || true, "{}", r1.len());
        let mut p7 =
            Pair { a: ((c * f) * S::from_f64(0.75)).sin(), b: (c * S::from_f64(0.75)).sin() };
    }
    ((c * c + S::from_f64(0.25)).sqrt()
        / (S::from_f64(1.5)
            + (c / (S::from_f64(1.5) + S::from_f64(scale()) * S::from_f64(scale())))
                * (c / (S::from_f64(1.5) + S::from_f64(scale()) * S::from_f64(scale())))))
        + f
        + b
        + c
        + a
        + d
        + y
        + x
}

#[differentiable]
fn program_21(x: f64, y: f64) -> f64 {
    let mut d = ((x * -0.375_f64).abs() + 0.125).tanh();
    let r1 = [((scale() - -0.375_f64).tanh() * 0.75).sin(); 4];
    d *= (d + 0.125).tanh();
    d = (x * 0.75).sin();
    let mut w2 = (((x * y) * 0.75).sin(), [(x * -0.375_f64).abs(); 2]);
    {
        let (p, [q, _]) = &mut w2;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let c = (w2.0 + w2.1[0] * w2.1[1]).tanh();
    d += (r1[0] * 0.75).sin();
    let d = if (r1[1] * -0.875_f64).abs() >= (d * y) {
        ((-(d)) - (d / (1.5 + r1[0] * r1[0])))
    } else {
        d
    };
    let mut d = (y + 0.125).tanh();
    let mut r3 = [((c * -0.875_f64).abs() * 0.75).sin(); 2];
    let mut p4 = Pair { a: ((r1[2] * x) + 0.125).tanh(), b: ((-(y)) + 0.125).tanh() };
    let p5 =
        Pair { a: (c * -0.375_f64).max(r3[1]), b: ((0.625_f64 * 0.375_f64).cos() + 0.125).tanh() };
    let b = (<Pair<f64> as Soft>::pressed(&p5) + Hard::pressed(&p5) * p5.pressed()).tamed().a;
    d -= (((-(x)) / (1.5 + (x - -0.875_f64).tanh() * (x - -0.875_f64).tanh())) + 0.125).tanh();
    let r6 = [((r1[2] * c) * 0.75).sin(); 3];
    let mut q7 = [
        Ball {
            height: ((draw() + 0.625_f64).sin() * 0.75).sin(),
            speed: ((x + -0.375_f64).sin() * 0.75).sin(),
        },
        Ball { height: (p4.a * 0.75).sin(), speed: ((x * draw()) + 0.125).tanh() },
    ];
    let up8 = q7[1].bounce();
    let a = if up8 { q7[1].run(2) } else { (b * 0.875_f64).abs() };
    let f = q7[0].height * q7[1].speed - q7[0].speed;
    for v in r3.iter().cycle().take(6) {
        d = (d + *v).sin();
    }
    let a = match shape(((draw() * p4.a) * 0.75).sin(), ((d * draw()) + 0.125).tanh()) {
        Shape::Point => (r6[1] + -0.625_f64).sin(),
        Shape::Disc(v) => (p4.b * -0.375_f64).abs(),
        Shape::Box { w: v, h } => ((scale() * c) * -0.625_f64).max(draw()),
    };
    ((r3[1] * -0.125_f64).abs() * (r3[1] * -0.125_f64).abs() + 0.25).sqrt()
        + a
        + f
        + b
        + d
        + c
        + y
        + x
}

fn program_21_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((x * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    let r1 =
        [((S::from_f64(scale()) - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(); 4];
    d = d * (d + S::from_f64(0.125)).tanh();
    d = (x * S::from_f64(0.75)).sin();
    let mut w2 = (((x * y) * S::from_f64(0.75)).sin(), [(x * S::from_f64(-0.375_f64)).abs(); 2]);
    {
        let (p, [q, _]) = &mut w2;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let c = (w2.0 + w2.1[0] * w2.1[1]).tanh();
    d = d + (r1[0] * S::from_f64(0.75)).sin();
    let d = if (r1[1] * S::from_f64(-0.875_f64)).abs().cmpge((d * y)) {
        ((-(d)) - (d / (S::from_f64(1.5) + r1[0] * r1[0])))
    } else {
        d
    };
    let mut d = (y + S::from_f64(0.125)).tanh();
    let mut r3 = [((c * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin(); 2];
    let mut p4 = Pair {
        a: ((r1[2] * x) + S::from_f64(0.125)).tanh(),
        b: ((-(y)) + S::from_f64(0.125)).tanh(),
    };
    let p5 = Pair {
        a: (c * S::from_f64(-0.375_f64)).max(r3[1]),
        b: ((S::from_f64(0.625_f64) * S::from_f64(0.375_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    let b = (<Pair<S> as Soft>::pressed(&p5) + Hard::pressed(&p5) * p5.pressed()).tamed().a;
    d = d
        - (((-(x))
            / (S::from_f64(1.5)
                + (x - S::from_f64(-0.875_f64)).tanh() * (x - S::from_f64(-0.875_f64)).tanh()))
            + S::from_f64(0.125))
        .tanh();
    let r6 = [((r1[2] * c) * S::from_f64(0.75)).sin(); 3];
    let mut q7 = [
        Ball {
            height: ((S::from_f64(draw()) + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75))
                .sin(),
            speed: ((x + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: (p4.a * S::from_f64(0.75)).sin(),
            speed: ((x * S::from_f64(draw())) + S::from_f64(0.125)).tanh(),
        },
    ];
    let up8 = q7[1].bounce();
    let a = if up8 { q7[1].run(2) } else { (b * S::from_f64(0.875_f64)).abs() };
    let f = q7[0].height * q7[1].speed - q7[0].speed;
    for v in r3.iter().cycle().take(6) {
        d = (d + *v).sin();
    }
    let a = match shape(
        ((S::from_f64(draw()) * p4.a) * S::from_f64(0.75)).sin(),
        ((d * S::from_f64(draw())) + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r6[1] + S::from_f64(-0.625_f64)).sin(),
        Shape::Disc(v) => (p4.b * S::from_f64(-0.375_f64)).abs(),
        Shape::Box { w: v, h } => {
            ((S::from_f64(scale()) * c) * S::from_f64(-0.625_f64)).max(S::from_f64(draw()))
        }
    };
    ((r3[1] * S::from_f64(-0.125_f64)).abs() * (r3[1] * S::from_f64(-0.125_f64)).abs()
        + S::from_f64(0.25))
    .sqrt()
        + a
        + f
        + b
        + d
        + c
        + y
        + x
}

#[differentiable]
fn program_22(x: f64, y: f64) -> f64 {
    let mut c = ((x + -1.125_f64).sin() + 0.125).tanh();
    let mut r1 = [((scale() * scale() + 0.25).sqrt() * 0.75).sin(); 4];
    'l2: for i3 in (1..5_usize).rev() {
        r1[(i3 * i3 + 1) % 4] *=
            (((y + ((i3 as f64) * 0.25)) + (draw() * r1[i3 % 4])) * 0.75).sin();
        let b =
            program_16(((c * 0.125_f64).cos() + 0.125).tanh(), (r1[(i3 + 1) % 4] + 0.125).tanh())
                .tanh();
        let c = mixed(&r1[3..]).sin();
    }
    let mut z4;
    if (r1[2] / (1.5 + r1[0] * r1[0])) < (r1[1] * c) {
        let t = r1[1];
        z4 = x;
    } else if (c * r1[0]) < (x * x + 0.25).sqrt() {
        z4 = bent((x * c));
    } else {
        z4 = r1[1];
    }
    z4 = z4 * (x * c);
    let mut p5 =
        Pair { a: ((c * draw()) * 0.75).sin(), b: ((r1[1] / (1.5 + r1[0] * r1[0])) * 0.75).sin() };
    let mut z6;
    if (p5.b * c) < (z4 + y) {
        z6 = ((c * r1[3]) * (z4 + c));
    } else {
        z6 = (r1[3] * r1[3] + 0.25).sqrt();
    }
    z6 = z6 * (r1[3] * r1[3] + 0.25).sqrt();
    r1[1] -= (((draw() * z4) * (draw() * z4) + 0.25).sqrt() * 0.75).sin();
    let by7 = ((r1[3] - -0.625_f64).tanh() * 0.75).sin();
    let m8 = &mut r1;
    if raises(m8) && !raises(m8) {
        m8[0] = by7 * m8[1];
    }
    let k9: usize = raised(m8);
    let b = root((p5.b + -1.125_f64).sin())
        .map_or((c * scale()), |v| ((p5.a + r1[k9 % 4]) + (r1[1] * 0.625_f64).max(z4)));
    let by10 = ((p5.b + r1[k9 % 4]) * 0.75).sin();
    let a = shifted(&mut r1[0..], by10);
    let c = summed(
        |t: f64| (((x * c) + (a / (1.5 + ((k9 as f64) * 0.25) * ((k9 as f64) * 0.25)))) * t).sin(),
        ((r1[(k9 + 3) % 4] * 0.625_f64).cos() + 0.125).tanh(),
        0,
    )
    .tanh();
    if (r1[(k9 * k9 + 1) % 4] + 0.875_f64) >= (b + 0.375_f64) {
        z4 -= ((y * r1[(k9 + 1) % 4]) + 0.125).tanh();
        let mut r11 = [(r1[(k9 * k9 + 1) % 4] + 0.125).tanh(), (z4 + 0.125).tanh()];
    }
    ((c + r1[1]) / (1.5 + (y * 0.125_f64).abs() * (y * 0.125_f64).abs()))
        + c
        + a
        + b
        + z6
        + z4
        + y
        + x
}

fn program_22_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((x + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh();
    let mut r1 = [((S::from_f64(scale()) * S::from_f64(scale()) + S::from_f64(0.25)).sqrt()
        * S::from_f64(0.75))
    .sin(); 4];
    'l2: for i3 in (1..5_usize).rev() {
        r1[(i3 * i3 + 1) % 4] = r1[(i3 * i3 + 1) % 4]
            * (((y + (S::from_f64(i3 as f64) * S::from_f64(0.25)))
                + (S::from_f64(draw()) * r1[i3 % 4]))
                * S::from_f64(0.75))
            .sin();
        let b = program_16_of(
            ((c * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
            (r1[(i3 + 1) % 4] + S::from_f64(0.125)).tanh(),
        )
        .tanh();
        let c = mixed(&r1[3..]).sin();
    }
    let mut z4;
    if (r1[2] / (S::from_f64(1.5) + r1[0] * r1[0])).cmplt((r1[1] * c)) {
        let t = r1[1];
        z4 = x;
    } else if (c * r1[0]).cmplt((x * x + S::from_f64(0.25)).sqrt()) {
        z4 = bent((x * c));
    } else {
        z4 = r1[1];
    }
    z4 = z4 * (x * c);
    let mut p5 = Pair {
        a: ((c * S::from_f64(draw())) * S::from_f64(0.75)).sin(),
        b: ((r1[1] / (S::from_f64(1.5) + r1[0] * r1[0])) * S::from_f64(0.75)).sin(),
    };
    let mut z6;
    if (p5.b * c).cmplt((z4 + y)) {
        z6 = ((c * r1[3]) * (z4 + c));
    } else {
        z6 = (r1[3] * r1[3] + S::from_f64(0.25)).sqrt();
    }
    z6 = z6 * (r1[3] * r1[3] + S::from_f64(0.25)).sqrt();
    r1[1] = r1[1]
        - (((S::from_f64(draw()) * z4) * (S::from_f64(draw()) * z4) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin();
    let by7 = ((r1[3] - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin();
    let m8 = &mut r1;
    if raises(m8) && !raises(m8) {
        m8[0] = by7 * m8[1];
    }
    let k9: usize = raised(m8);
    let b = root((p5.b + S::from_f64(-1.125_f64)).sin()).map_or((c * S::from_f64(scale())), |v| {
        ((p5.a + r1[k9 % 4]) + (r1[1] * S::from_f64(0.625_f64)).max(z4))
    });
    let by10 = ((p5.b + r1[k9 % 4]) * S::from_f64(0.75)).sin();
    let a = shifted(&mut r1[0..], by10);
    let c = summed(
        |t: S| {
            (((x * c)
                + (a / (S::from_f64(1.5)
                    + (S::from_f64(k9 as f64) * S::from_f64(0.25))
                        * (S::from_f64(k9 as f64) * S::from_f64(0.25)))))
                * t)
                .sin()
        },
        ((r1[(k9 + 3) % 4] * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
        0,
    )
    .tanh();
    if (r1[(k9 * k9 + 1) % 4] + S::from_f64(0.875_f64)).cmpge((b + S::from_f64(0.375_f64))) {
        z4 = z4 - ((y * r1[(k9 + 1) % 4]) + S::from_f64(0.125)).tanh();
        let mut r11 =
            [(r1[(k9 * k9 + 1) % 4] + S::from_f64(0.125)).tanh(), (z4 + S::from_f64(0.125)).tanh()];
    }
    ((c + r1[1])
        / (S::from_f64(1.5)
            + (y * S::from_f64(0.125_f64)).abs() * (y * S::from_f64(0.125_f64)).abs()))
        + c
        + a
        + b
        + z6
        + z4
        + y
        + x
}

#[differentiable]
fn program_23(x: f64, y: f64) -> f64 {
    let mut c = ((y * 0.125_f64).abs() + 0.125).tanh();
    let r1 = [
        (y * 0.75).sin(),
        ((y + -0.375_f64).sin() * 0.75).sin(),
        ((y + y) * 0.75).sin(),
        ((-(y)) * 0.75).sin(),
    ];
    'l2: for i3 in (1..0_usize).rev() {
        let mut n5 = 0_usize;
        'l4: while n5 < 5 {
            n5 += 1;
            let mut p6 = Pair {
                a: ((r1[(i3 + 3) % 4] * r1[0]) * 0.75).sin(),
                b: ((draw() * 0.875_f64).max(x) * 0.75).sin(),
            };
            let mut n8 = 0_usize;
            'l7: while n8 < 3 {
                n8 += 1;
                let c = match shape(((-(r1[3])) + 0.125).tanh(), ((c * y) + 0.125).tanh()) {
                    Point => (0.625_f64 + r1[n5 % 4]),
                    Disc(v) => ((x * -0.625_f64).cos() / (1.5 + x * x)),
                    Shape::Box { w: v, h } => (0.875_f64 * -0.875_f64).max(v),
                };
            }
        }
        let mut p9 = Pair {
            a: ((-((i3 as f64) * 0.25)) + 0.125).tanh(),
            b: ((r1[(i3 * i3 + 1) % 4] + c) * 0.75).sin(),
        };
    }
    c -= (((-0.125_f64 - -0.375_f64).tanh() * (c - 0.375_f64).tanh()) + 0.125).tanh();
    let a = match roots((r1[3] + -0.375_f64).sin(), x) {
        Ok(v) => ((r1[1] - 0.375_f64).tanh() * (r1[1] - 0.375_f64).tanh() + 0.25).sqrt(),
        Err(true) => c,
        Err(_) => (c * 0.625_f64),
    };
    let d = if y >= (0.375_f64 * 0.125_f64) {
        ((-(c)) * (y * -0.875_f64).cos())
    } else {
        ((c - -0.625_f64).tanh() - -0.375_f64).tanh()
    };
    let mut l10 =
        List(vec![((y * 0.375_f64).abs() + 0.125).tanh(), (y * r1[1]), ((-(r1[2])) * 0.75).sin()]);
    for i11 in 0..1_usize {
        l10 += &List(vec![((a * a) + 0.125).tanh(), a, ((y * r1[1]) * 0.75).sin()]);
        if (r1[0] / (1.5 + -0.625_f64 * -0.625_f64)) < (r1[3] * -0.875_f64).cos() {
            continue;
        }
        l10 = &l10 * &List(vec![((a * a) + 0.125).tanh(), a, ((y * r1[1]) * 0.75).sin()]);
    }
    let f = l10.total();
    let mut w12 = (((r1[3] * 0.875_f64).max(c) * 0.75).sin(), [x; 2]);
    {
        let (p, [q, _]) = &mut w12;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w12.0 + w12.1[0] * w12.1[1]).tanh();
    let mut a = ((draw() / (1.5 + f * f)) + 0.125).tanh();
    let r13 = [
        ((a - -0.875_f64).tanh() + 0.125).tanh(),
        (a + 0.125).tanh(),
        ((c * y) * 0.75).sin(),
        (d * 0.75).sin(),
        ((r1[1] * -0.875_f64).max(-1.125_f64) * 0.75).sin(),
    ];
    let e = mixed(&r13[..3]).sin();
    ((r13[4] + r1[3]) * (a * 0.125_f64).cos()) + e + a + f + d + c + y + x
}

fn program_23_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    let r1 = [
        (y * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((y + y) * S::from_f64(0.75)).sin(),
        ((-(y)) * S::from_f64(0.75)).sin(),
    ];
    'l2: for i3 in (1..0_usize).rev() {
        let mut n5 = 0_usize;
        'l4: while n5 < 5 {
            n5 += 1;
            let mut p6 = Pair {
                a: ((r1[(i3 + 3) % 4] * r1[0]) * S::from_f64(0.75)).sin(),
                b: ((S::from_f64(draw()) * S::from_f64(0.875_f64)).max(x) * S::from_f64(0.75))
                    .sin(),
            };
            let mut n8 = 0_usize;
            'l7: while n8 < 3 {
                n8 += 1;
                let c = match shape(
                    ((-(r1[3])) + S::from_f64(0.125)).tanh(),
                    ((c * y) + S::from_f64(0.125)).tanh(),
                ) {
                    Point => (S::from_f64(0.625_f64) + r1[n5 % 4]),
                    Disc(v) => ((x * S::from_f64(-0.625_f64)).cos() / (S::from_f64(1.5) + x * x)),
                    Shape::Box { w: v, h } => {
                        (S::from_f64(0.875_f64) * S::from_f64(-0.875_f64)).max(v)
                    }
                };
            }
        }
        let mut p9 = Pair {
            a: ((-(S::from_f64(i3 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(),
            b: ((r1[(i3 * i3 + 1) % 4] + c) * S::from_f64(0.75)).sin(),
        };
    }
    c = c
        - (((S::from_f64(-0.125_f64) - S::from_f64(-0.375_f64)).tanh()
            * (c - S::from_f64(0.375_f64)).tanh())
            + S::from_f64(0.125))
        .tanh();
    let a = match roots((r1[3] + S::from_f64(-0.375_f64)).sin(), x) {
        Ok(v) => ((r1[1] - S::from_f64(0.375_f64)).tanh()
            * (r1[1] - S::from_f64(0.375_f64)).tanh()
            + S::from_f64(0.25))
        .sqrt(),
        Err(true) => c,
        Err(_) => (c * S::from_f64(0.625_f64)),
    };
    let d = if y.cmpge((S::from_f64(0.375_f64) * S::from_f64(0.125_f64))) {
        ((-(c)) * (y * S::from_f64(-0.875_f64)).cos())
    } else {
        ((c - S::from_f64(-0.625_f64)).tanh() - S::from_f64(-0.375_f64)).tanh()
    };
    let mut l10 = List(vec![
        ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        (y * r1[1]),
        ((-(r1[2])) * S::from_f64(0.75)).sin(),
    ]);
    for i11 in 0..1_usize {
        l10 += &List(vec![
            ((a * a) + S::from_f64(0.125)).tanh(),
            a,
            ((y * r1[1]) * S::from_f64(0.75)).sin(),
        ]);
        if (r1[0] / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64)))
            .cmplt((r1[3] * S::from_f64(-0.875_f64)).cos())
        {
            continue;
        }
        l10 = &l10
            * &List(vec![
                ((a * a) + S::from_f64(0.125)).tanh(),
                a,
                ((y * r1[1]) * S::from_f64(0.75)).sin(),
            ]);
    }
    let f = l10.total();
    let mut w12 = (((r1[3] * S::from_f64(0.875_f64)).max(c) * S::from_f64(0.75)).sin(), [x; 2]);
    {
        let (p, [q, _]) = &mut w12;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w12.0 + w12.1[0] * w12.1[1]).tanh();
    let mut a = ((S::from_f64(draw()) / (S::from_f64(1.5) + f * f)) + S::from_f64(0.125)).tanh();
    let r13 = [
        ((a - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
        (a + S::from_f64(0.125)).tanh(),
        ((c * y) * S::from_f64(0.75)).sin(),
        (d * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(-0.875_f64)).max(S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin(),
    ];
    let e = mixed(&r13[..3]).sin();
    ((r13[4] + r1[3]) * (a * S::from_f64(0.125_f64)).cos()) + e + a + f + d + c + y + x
}

#[differentiable]
fn program_24(x: f64, y: f64) -> f64 {
    let mut c = (y + 0.125).tanh();
    let mut r1 = [
        ((scale() + 0.375_f64).sin() + 0.125).tanh(),
        ((x + x) * 0.75).sin(),
        ((c + y) * 0.75).sin(),
        ((x - y) + 0.125).tanh(),
    ];
    let g2 = |t: f64, v: &[f64]| mixed(v) * t + ((y - x) + (y - y)).tanh();
    let a = folded(&g2, ((r1[1] + -0.625_f64) + 0.125).tanh(), &r1).sin();
    if (0.875_f64 - 0.875_f64).tanh() > (r1[0] * r1[0] + 0.25).sqrt() {
        return ((r1[3] * r1[3]) + 0.625_f64).sin();
    }
    if (x / (1.5 + r1[3] * r1[3])) >= (y * y) {
        return ((0.125_f64 * r1[0]) + -0.375_f64).sin();
    }
    'l3: for i4 in 1..3_usize {
        let d = summed(
            |t: f64| (((r1[(i4 * i4 + 1) % 4] + r1[i4 % 4]) + -0.625_f64).sin() * t).sin(),
            ((r1[(i4 + 2) % 4] * -0.125_f64).cos() * 0.75).sin(),
            2,
        )
        .tanh();
    }
    r1[0] += (((y - -0.625_f64).tanh() + (r1[0] * 0.875_f64).max(r1[0])) + 0.125).tanh();
    if c <= (x * r1[2]) {
        return ((r1[2] * -0.375_f64).cos() * -0.625_f64).cos();
    }
    let mut p5 = Pair {
        a: ((a / (1.5 + y * y)) + 0.125).tanh(),
        b: ((r1[1] * 0.125_f64).max(r1[3]) * 0.75).sin(),
    };
    r1[2] += (((p5.a - 0.125_f64).tanh() - 0.125_f64).tanh() + 0.125).tanh();
    let b = p5
        .dot(&Pair {
            a: ((x * 0.625_f64).cos() + 0.125).tanh(),
            b: ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh(),
        })
        .sin();
    'l6: for i7 in (0..3_usize).step_by(2) {
        let by8 = (r1[i7 % 4] * 0.75).sin();
        let a = shifted(&mut r1[1..], by8);
        let by9 = ((b - -1.125_f64).tanh() + 0.125).tanh();
        let m10 = &mut r1;
        if raises(m10) && !raises(m10) {
            m10[0] = by9 * m10[1];
        }
        let k11: usize = raised(m10);
        p5 = -(p5 - p5).tamed();
        p5 = p5.tamed();
    }
    ((r1[3] + 0.375_f64) * (r1[3] + x)) + b + a + c + y + x
}

fn program_24_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (y + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((S::from_f64(scale()) + S::from_f64(0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x + x) * S::from_f64(0.75)).sin(),
        ((c + y) * S::from_f64(0.75)).sin(),
        ((x - y) + S::from_f64(0.125)).tanh(),
    ];
    let g2 = |t: S, v: &[S]| mixed(v) * t + ((y - x) + (y - y)).tanh();
    let a = folded(&g2, ((r1[1] + S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh(), &r1).sin();
    if (S::from_f64(0.875_f64) - S::from_f64(0.875_f64))
        .tanh()
        .cmpgt((r1[0] * r1[0] + S::from_f64(0.25)).sqrt())
    {
        return ((r1[3] * r1[3]) + S::from_f64(0.625_f64)).sin();
    }
    if (x / (S::from_f64(1.5) + r1[3] * r1[3])).cmpge((y * y)) {
        return ((S::from_f64(0.125_f64) * r1[0]) + S::from_f64(-0.375_f64)).sin();
    }
    'l3: for i4 in 1..3_usize {
        let d = summed(
            |t: S| {
                (((r1[(i4 * i4 + 1) % 4] + r1[i4 % 4]) + S::from_f64(-0.625_f64)).sin() * t).sin()
            },
            ((r1[(i4 + 2) % 4] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            2,
        )
        .tanh();
    }
    r1[0] = r1[0]
        + (((y - S::from_f64(-0.625_f64)).tanh() + (r1[0] * S::from_f64(0.875_f64)).max(r1[0]))
            + S::from_f64(0.125))
        .tanh();
    if c.cmple((x * r1[2])) {
        return ((r1[2] * S::from_f64(-0.375_f64)).cos() * S::from_f64(-0.625_f64)).cos();
    }
    let mut p5 = Pair {
        a: ((a / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        b: ((r1[1] * S::from_f64(0.125_f64)).max(r1[3]) * S::from_f64(0.75)).sin(),
    };
    r1[2] = r1[2]
        + (((p5.a - S::from_f64(0.125_f64)).tanh() - S::from_f64(0.125_f64)).tanh()
            + S::from_f64(0.125))
        .tanh();
    let b = p5
        .dot(&Pair {
            a: ((x * S::from_f64(0.625_f64)).cos() + S::from_f64(0.125)).tanh(),
            b: ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        })
        .sin();
    'l6: for i7 in (0..3_usize).step_by(2) {
        let by8 = (r1[i7 % 4] * S::from_f64(0.75)).sin();
        let a = shifted(&mut r1[1..], by8);
        let by9 = ((b - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh();
        let m10 = &mut r1;
        if raises(m10) && !raises(m10) {
            m10[0] = by9 * m10[1];
        }
        let k11: usize = raised(m10);
        p5 = -(p5 - p5).tamed();
        p5 = p5.tamed();
    }
    ((r1[3] + S::from_f64(0.375_f64)) * (r1[3] + x)) + b + a + c + y + x
}

#[differentiable]
fn program_25(x: f64, y: f64) -> f64 {
    let mut c = ((y * y + 0.25).sqrt() * 0.75).sin();
    let r1 = [((-(y)) + 0.125).tanh(); 4];
    let f = summed(
        |t: f64| (((r1[0] * 0.125_f64).max(t) + t) * t).sin(),
        ((y + r1[2]) + 0.125).tanh(),
        3,
    )
    .tanh();
    let mut p2 = Pair { a: ((x * x) * 0.75).sin(), b: ((c * 0.125_f64).max(r1[3]) + 0.125).tanh() };
    let mut p3 =
        Pair { a: ((r1[1] * 0.625_f64).abs() + 0.125).tanh(), b: ((p2.b + r1[3]) * 0.75).sin() };
    let mut r4 = [((y + y) * 0.75).sin(), ((y * f) * 0.75).sin()];
    let mut r5 = [
        ((r4[1] * r4[1] + 0.25).sqrt() + 0.125).tanh(),
        ((-0.875_f64 * -0.875_f64).max(x) + 0.125).tanh(),
    ];
    let b = if raises(&mut r5) { (r1[3] / (1.5 + c * c)) } else { ((-(r4[1])) * 0.625_f64).abs() };
    p3 = (Pair { a: (0.625_f64 * 0.75).sin(), b: ((-0.375_f64 * b) + 0.125).tanh() }
        - p3 * ((b * -0.625_f64) * 0.75).sin())
    .tamed();
    p3 = p3.tamed();
    let b = if (b * 0.375_f64).abs() < (c + 0.375_f64).sin() {
        ((y * -0.625_f64).abs() + 0.375_f64).sin()
    } else {
        ((x * 0.875_f64) * 0.375_f64).abs()
    };
    let e = p3
        .dot(&Pair {
            a: ((x / (1.5 + f * f)) + 0.125).tanh(),
            b: ((r1[2] * -0.625_f64).abs() + 0.125).tanh(),
        })
        .sin();
    let mut r6 = [
        ((b * y) + 0.125).tanh(),
        ((r1[3] - -0.375_f64).tanh() * 0.75).sin(),
        ((draw() - -0.875_f64).tanh() * 0.75).sin(),
        ((-(r5[1])) * 0.75).sin(),
    ];
    p2 = (p2 * p3 + p2).tamed();
    p2 = p2.tamed();
    let c = match raises(&mut r6) {
        true => c,
        false => ((b - 0.125_f64).tanh() * -0.125_f64).max(r1[0]),
    };
    r5[1] *= (((e * y) * -1.125_f64).abs() + 0.125).tanh();
    let mut b = ((r4[0] * 0.625_f64).cos() * 0.75).sin();
    (f - y) + b + c + e + f + y + x
}

fn program_25_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let r1 = [((-(y)) + S::from_f64(0.125)).tanh(); 4];
    let f = summed(
        |t: S| (((r1[0] * S::from_f64(0.125_f64)).max(t) + t) * t).sin(),
        ((y + r1[2]) + S::from_f64(0.125)).tanh(),
        3,
    )
    .tanh();
    let mut p2 = Pair {
        a: ((x * x) * S::from_f64(0.75)).sin(),
        b: ((c * S::from_f64(0.125_f64)).max(r1[3]) + S::from_f64(0.125)).tanh(),
    };
    let mut p3 = Pair {
        a: ((r1[1] * S::from_f64(0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        b: ((p2.b + r1[3]) * S::from_f64(0.75)).sin(),
    };
    let mut r4 = [((y + y) * S::from_f64(0.75)).sin(), ((y * f) * S::from_f64(0.75)).sin()];
    let mut r5 = [
        ((r4[1] * r4[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64)).max(x) + S::from_f64(0.125)).tanh(),
    ];
    let b = if raises(&mut r5) {
        (r1[3] / (S::from_f64(1.5) + c * c))
    } else {
        ((-(r4[1])) * S::from_f64(0.625_f64)).abs()
    };
    p3 = (Pair {
        a: (S::from_f64(0.625_f64) * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(-0.375_f64) * b) + S::from_f64(0.125)).tanh(),
    } - p3 * ((b * S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin())
    .tamed();
    p3 = p3.tamed();
    let b = if (b * S::from_f64(0.375_f64)).abs().cmplt((c + S::from_f64(0.375_f64)).sin()) {
        ((y * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.375_f64)).sin()
    } else {
        ((x * S::from_f64(0.875_f64)) * S::from_f64(0.375_f64)).abs()
    };
    let e = p3
        .dot(&Pair {
            a: ((x / (S::from_f64(1.5) + f * f)) + S::from_f64(0.125)).tanh(),
            b: ((r1[2] * S::from_f64(-0.625_f64)).abs() + S::from_f64(0.125)).tanh(),
        })
        .sin();
    let mut r6 = [
        ((b * y) + S::from_f64(0.125)).tanh(),
        ((r1[3] - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((S::from_f64(draw()) - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((-(r5[1])) * S::from_f64(0.75)).sin(),
    ];
    p2 = (p2 * p3 + p2).tamed();
    p2 = p2.tamed();
    let c = match raises(&mut r6) {
        true => c,
        false => ((b - S::from_f64(0.125_f64)).tanh() * S::from_f64(-0.125_f64)).max(r1[0]),
    };
    r5[1] = r5[1] * (((e * y) * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh();
    let mut b = ((r4[0] * S::from_f64(0.625_f64)).cos() * S::from_f64(0.75)).sin();
    (f - y) + b + c + e + f + y + x
}

#[differentiable]
fn program_26(x: f64, y: f64) -> f64 {
    let mut c = ((y * x) + 0.125).tanh();
    let mut r1 = [((y - -0.375_f64).tanh() * 0.75).sin(); 5];
    let (a, mut b) = (((c + c) + 0.125).tanh(), (x + -0.625_f64).sin());
    r1[2] -= (((r1[3] - 0.125_f64).tanh() - (y * -1.125_f64).max(draw())) * 0.75).sin();
    let mut r2 = [((r1[1] + y) * 0.75).sin(); 5];
    r2[4] -= (((r1[0] * a) + (-0.375_f64 * 0.375_f64)) + 0.125).tanh();
    let mut q3 = [
        Ball {
            height: ((0.125_f64 - -0.625_f64).tanh() + 0.125).tanh(),
            speed: ((c * c + 0.25).sqrt() * 0.75).sin(),
        },
        Ball {
            height: ((0.625_f64 * -0.375_f64) * 0.75).sin(),
            speed: ((scale() * 0.125_f64).abs() + 0.125).tanh(),
        },
    ];
    let up4 = q3[0].bounce();
    let f = if up4 { q3[1].run(2) } else { (-0.625_f64 * 0.125_f64).cos() };
    let e = q3[0].height * q3[1].speed - q3[0].speed;
    let mut l5 = List(vec![
        ((-(0.125_f64)) * 0.75).sin(),
        (e - -0.875_f64).tanh(),
        ((e * r1[0]) * 0.75).sin(),
    ]);
    for i6 in 0..4_usize {
        l5 += &List(vec![
            ((r2[1] + x) * 0.75).sin(),
            r1[3],
            ((r1[1] * -0.125_f64).cos() * 0.75).sin(),
        ]);
        if (e - x) <= (b * b + 0.25).sqrt() {
            continue;
        }
        l5 = &l5
            * &List(vec![
                ((r2[1] + x) * 0.75).sin(),
                r1[3],
                ((r1[1] * -0.125_f64).cos() * 0.75).sin(),
            ]);
    }
    let d = l5.total();
    let mut n7 = 0_usize;
    while raises(&mut r2) && n7 < 3 {
        n7 += 1;
    }
    let mut u8 = r2.to_vec();
    u8.push((r1[(n7 * n7 + 1) % 5] + 0.125).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let f = (mixed(&u8) + u8[0]).tanh();
    if (r2[(n7 * n7 + 1) % 5] * r2[(n7 * n7 + 1) % 5] + 0.25).sqrt() > ((n7 as f64) * 0.25) {
        let g9 = |t: f64| ((x - r2[(n7 + 1) % 5]) * (-(r1[(n7 * n7 + 1) % 5]))) * t;
        let d = (g9((e * r2[2])) + g9((e * ((n7 as f64) * 0.25)))).sin();
        let g10 = |t: f64| ((r2[2] * t) * -0.375_f64).max(y) * t;
        let e = (g10((r1[(n7 + 1) % 5] * 0.625_f64)) + g10((r1[1] * b))).sin();
        let d = summed(|t: f64| (e * t).sin(), (r2[n7 % 5] * 0.75).sin(), 3).tanh();
    } else {
        let e = if (-(0.125_f64)) > (r2[3] * r1[(n7 + 4) % 5]) {
            (r1[4] - 0.625_f64).tanh()
        } else {
            ((scale() + 0.125_f64).sin() + (y + y))
        };
        let mut p11 = Pair { a: (((n7 as f64) * 0.25) * 0.75).sin(), b: (draw() + 0.125).tanh() };
    }
    (-(c * draw())) + f + d + e + b + a + c + y + x
}

fn program_26_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin(); 5];
    let (a, mut b) = (((c + c) + S::from_f64(0.125)).tanh(), (x + S::from_f64(-0.625_f64)).sin());
    r1[2] = r1[2]
        - (((r1[3] - S::from_f64(0.125_f64)).tanh()
            - (y * S::from_f64(-1.125_f64)).max(S::from_f64(draw())))
            * S::from_f64(0.75))
        .sin();
    let mut r2 = [((r1[1] + y) * S::from_f64(0.75)).sin(); 5];
    r2[4] = r2[4]
        - (((r1[0] * a) + (S::from_f64(-0.375_f64) * S::from_f64(0.375_f64))) + S::from_f64(0.125))
            .tanh();
    let mut q3 = [
        Ball {
            height: ((S::from_f64(0.125_f64) - S::from_f64(-0.625_f64)).tanh()
                + S::from_f64(0.125))
            .tanh(),
            speed: ((c * c + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: ((S::from_f64(0.625_f64) * S::from_f64(-0.375_f64)) * S::from_f64(0.75)).sin(),
            speed: ((S::from_f64(scale()) * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125))
                .tanh(),
        },
    ];
    let up4 = q3[0].bounce();
    let f =
        if up4 { q3[1].run(2) } else { (S::from_f64(-0.625_f64) * S::from_f64(0.125_f64)).cos() };
    let e = q3[0].height * q3[1].speed - q3[0].speed;
    let mut l5 = List(vec![
        ((-(S::from_f64(0.125_f64))) * S::from_f64(0.75)).sin(),
        (e - S::from_f64(-0.875_f64)).tanh(),
        ((e * r1[0]) * S::from_f64(0.75)).sin(),
    ]);
    for i6 in 0..4_usize {
        l5 += &List(vec![
            ((r2[1] + x) * S::from_f64(0.75)).sin(),
            r1[3],
            ((r1[1] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
        ]);
        if (e - x).cmple((b * b + S::from_f64(0.25)).sqrt()) {
            continue;
        }
        l5 = &l5
            * &List(vec![
                ((r2[1] + x) * S::from_f64(0.75)).sin(),
                r1[3],
                ((r1[1] * S::from_f64(-0.125_f64)).cos() * S::from_f64(0.75)).sin(),
            ]);
    }
    let d = l5.total();
    let mut n7 = 0_usize;
    while raises(&mut r2) && n7 < 3 {
        n7 += 1;
    }
    let mut u8 = r2.to_vec();
    u8.push((r1[(n7 * n7 + 1) % 5] + S::from_f64(0.125)).tanh());
    u8[0] = u8[1] * u8[u8.len() - 1];
    let f = (mixed(&u8) + u8[0]).tanh();
    if (r2[(n7 * n7 + 1) % 5] * r2[(n7 * n7 + 1) % 5] + S::from_f64(0.25))
        .sqrt()
        .cmpgt((S::from_f64(n7 as f64) * S::from_f64(0.25)))
    {
        let g9 = |t: S| ((x - r2[(n7 + 1) % 5]) * (-(r1[(n7 * n7 + 1) % 5]))) * t;
        let d = (g9((e * r2[2])) + g9((e * (S::from_f64(n7 as f64) * S::from_f64(0.25))))).sin();
        let g10 = |t: S| ((r2[2] * t) * S::from_f64(-0.375_f64)).max(y) * t;
        let e = (g10((r1[(n7 + 1) % 5] * S::from_f64(0.625_f64))) + g10((r1[1] * b))).sin();
        let d = summed(|t: S| (e * t).sin(), (r2[n7 % 5] * S::from_f64(0.75)).sin(), 3).tanh();
    } else {
        let e = if (-(S::from_f64(0.125_f64))).cmpgt((r2[3] * r1[(n7 + 4) % 5])) {
            (r1[4] - S::from_f64(0.625_f64)).tanh()
        } else {
            ((S::from_f64(scale()) + S::from_f64(0.125_f64)).sin() + (y + y))
        };
        let mut p11 = Pair {
            a: ((S::from_f64(n7 as f64) * S::from_f64(0.25)) * S::from_f64(0.75)).sin(),
            b: (S::from_f64(draw()) + S::from_f64(0.125)).tanh(),
        };
    }
    (-(c * S::from_f64(draw()))) + f + d + e + b + a + c + y + x
}

#[differentiable]
fn program_27(x: f64, y: f64) -> f64 {
    let mut c = ((0.875_f64 - -0.375_f64).tanh() * 0.75).sin();
    let mut r1 = [
        ((y * 0.375_f64).abs() + 0.125).tanh(),
        ((c * x) + 0.125).tanh(),
        ((0.375_f64 * y) + 0.125).tanh(),
    ];
    let mut r2 = [((c - x) + 0.125).tanh(); 2];
    r2[1] = ((c * 0.875_f64).max(y) + 0.125).tanh();
    let by3 = ((-(x)) + 0.125).tanh();
    let m4 = &mut r2;
    if raises(m4) && !raises(m4) {
        m4[0] = by3 * m4[1];
    }
    let k5: usize = raised(m4);
    let f = mixed(&r2[0..]).sin();
    let (a, mut b) = (((c * 0.125_f64).max(c) + 0.125).tanh(), r2[1]);
    let e = mixed(&r2[0..]).sin();
    #[differentiable(checkpoint)]
    'l6: for i7 in k5..=3_usize {
        #[differentiable(checkpoint)]
        'l8: for i9 in (1..2_usize).step_by(2) {
            let mut l10 = List(vec![
                ((x - r2[i7 % 2]) * 0.75).sin(),
                (-0.875_f64 * f),
                ((r1[(i7 * i7 + 1) % 3] - y) * 0.75).sin(),
            ]);
            for i11 in 0..4_usize {
                l10 += &List(vec![
                    ((r2[1] * -0.125_f64).abs() * 0.75).sin(),
                    (f - -1.125_f64).tanh(),
                    ((f * -1.125_f64).cos() * 0.75).sin(),
                ]);
                if (x * 0.125_f64).abs() <= (-(e)) {
                    continue;
                }
                l10 = &l10
                    * &List(vec![
                        ((r2[1] * -0.125_f64).abs() * 0.75).sin(),
                        (f - -1.125_f64).tanh(),
                        ((f * -1.125_f64).cos() * 0.75).sin(),
                    ]);
            }
            let f = l10.total();
        }
    }
    let e = if raises(&mut r2) { r1[k5 % 3] } else { ((r1[1] * e) * (r1[1] * e) + 0.25).sqrt() };
    b = ((draw() / (1.5 + c * c)) + 0.125).tanh();
    if k5 % 3 == 2 {
        let l12 = List(vec![
            ((f / (1.5 + ((k5 as f64) * 0.25) * ((k5 as f64) * 0.25))) + 0.125).tanh(),
            (r2[k5 % 2] * r1[(k5 * k5 + 1) % 3]),
            ((r2[(k5 + 1) % 2] * 0.125_f64).max(scale()) + 0.125).tanh(),
        ]);
        let m13 = &l12
            * &List(vec![
                ((scale() * -0.625_f64).abs() * 0.75).sin(),
                (x * -0.625_f64).max(c),
                ((((k5 as f64) * 0.25) + e) + 0.125).tanh(),
            ]);
        let c = ((-&m13 + l12).total()).tanh();
        let a = mixed(&r2[1..]).sin();
        let by14 = ((c + -1.125_f64).sin() + 0.125).tanh();
        let d = shifted(&mut r2[0..], by14);
    }
    ((f * 0.375_f64).abs() * (((k5 as f64) * 0.25) - ((k5 as f64) * 0.25)))
        + e
        + b
        + a
        + f
        + c
        + y
        + x
}

fn program_27_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c =
        ((S::from_f64(0.875_f64) - S::from_f64(-0.375_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((c * x) + S::from_f64(0.125)).tanh(),
        ((S::from_f64(0.375_f64) * y) + S::from_f64(0.125)).tanh(),
    ];
    let mut r2 = [((c - x) + S::from_f64(0.125)).tanh(); 2];
    r2[1] = ((c * S::from_f64(0.875_f64)).max(y) + S::from_f64(0.125)).tanh();
    let by3 = ((-(x)) + S::from_f64(0.125)).tanh();
    let m4 = &mut r2;
    if raises(m4) && !raises(m4) {
        m4[0] = by3 * m4[1];
    }
    let k5: usize = raised(m4);
    let f = mixed(&r2[0..]).sin();
    let (a, mut b) = (((c * S::from_f64(0.125_f64)).max(c) + S::from_f64(0.125)).tanh(), r2[1]);
    let e = mixed(&r2[0..]).sin();

    'l6: for i7 in k5..=3_usize {
        'l8: for i9 in (1..2_usize).step_by(2) {
            let mut l10 = List(vec![
                ((x - r2[i7 % 2]) * S::from_f64(0.75)).sin(),
                (S::from_f64(-0.875_f64) * f),
                ((r1[(i7 * i7 + 1) % 3] - y) * S::from_f64(0.75)).sin(),
            ]);
            for i11 in 0..4_usize {
                l10 += &List(vec![
                    ((r2[1] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
                    (f - S::from_f64(-1.125_f64)).tanh(),
                    ((f * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
                ]);
                if (x * S::from_f64(0.125_f64)).abs().cmple((-(e))) {
                    continue;
                }
                l10 = &l10
                    * &List(vec![
                        ((r2[1] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
                        (f - S::from_f64(-1.125_f64)).tanh(),
                        ((f * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin(),
                    ]);
            }
            let f = l10.total();
        }
    }
    let e = if raises(&mut r2) {
        r1[k5 % 3]
    } else {
        ((r1[1] * e) * (r1[1] * e) + S::from_f64(0.25)).sqrt()
    };
    b = ((S::from_f64(draw()) / (S::from_f64(1.5) + c * c)) + S::from_f64(0.125)).tanh();
    if k5 % 3 == 2 {
        let l12 = List(vec![
            ((f / (S::from_f64(1.5)
                + (S::from_f64(k5 as f64) * S::from_f64(0.25))
                    * (S::from_f64(k5 as f64) * S::from_f64(0.25))))
                + S::from_f64(0.125))
            .tanh(),
            (r2[k5 % 2] * r1[(k5 * k5 + 1) % 3]),
            ((r2[(k5 + 1) % 2] * S::from_f64(0.125_f64)).max(S::from_f64(scale()))
                + S::from_f64(0.125))
            .tanh(),
        ]);
        let m13 = &l12
            * &List(vec![
                ((S::from_f64(scale()) * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
                (x * S::from_f64(-0.625_f64)).max(c),
                (((S::from_f64(k5 as f64) * S::from_f64(0.25)) + e) + S::from_f64(0.125)).tanh(),
            ]);
        let c = ((-&m13 + l12).total()).tanh();
        let a = mixed(&r2[1..]).sin();
        let by14 = ((c + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh();
        let d = shifted(&mut r2[0..], by14);
    }
    ((f * S::from_f64(0.375_f64)).abs()
        * ((S::from_f64(k5 as f64) * S::from_f64(0.25))
            - (S::from_f64(k5 as f64) * S::from_f64(0.25))))
        + e
        + b
        + a
        + f
        + c
        + y
        + x
}

#[differentiable]
fn program_28(x: f64, y: f64) -> f64 {
    let mut c = (y + 0.125).tanh();
    let r1 = [((-(draw())) + 0.125).tanh(); 3];
    let f = match shape(((c * c + 0.25).sqrt() + 0.125).tanh(), ((c + -0.875_f64) + 0.125).tanh()) {
        Point => (y * -1.125_f64).cos(),
        Disc(v) => ((x * x + 0.25).sqrt() / (1.5 + (y / (1.5 + v * v)) * (y / (1.5 + v * v)))),
        Shape::Box { w: v, h } => (-((x * -0.375_f64).max(h))),
    };
    'l2: for i3 in 1..=4_usize {
        for v in r1.iter() {
            c = c * ((f - -0.625_f64).tanh() * 0.75).sin()
                + *v * ((f - -0.625_f64).tanh() * 0.75).sin();
        }
    }
    c *= ((y - (c * r1[0])) * 0.75).sin();
    let mut q4 = [
        Ball {
            height: ((r1[0] - f) * 0.75).sin(),
            speed: ((r1[0] * r1[0] + 0.25).sqrt() + 0.125).tanh(),
        },
        Ball { height: ((f + r1[0]) * 0.75).sin(), speed: ((r1[1] + r1[2]) + 0.125).tanh() },
    ];
    let up5 = q4[0].bounce();
    let f = if up5 { q4[1].run(0) } else { (c + -1.125_f64) };
    let f = q4[0].height * q4[1].speed - q4[0].speed;
    'l6: for i7 in 2..5_usize {
        if i7 % 4 == 2 {
            break 'l6;
        }
        let mut r8 = [((-((i7 as f64) * 0.25)) + 0.125).tanh(); 2];
    }
    let mut r9 = [
        ((x - r1[0]) + 0.125).tanh(),
        ((r1[0] / (1.5 + x * x)) + 0.125).tanh(),
        ((x + 0.875_f64).sin() + 0.125).tanh(),
        ((x * draw()) * 0.75).sin(),
    ];
    let p10 = Pair { a: (-(c)), b: ((f - -0.125_f64).tanh() + 0.125).tanh() };
    let c = (<Pair<f64> as Soft>::pressed(&p10) + Hard::pressed(&p10) * p10.pressed()).tamed().a;
    let mut a = ((f - f) + 0.125).tanh();
    let mut l11 = List(vec![
        ((r9[3] + x) + 0.125).tanh(),
        (scale() - r1[2]),
        ((-0.875_f64 + -0.375_f64).sin() + 0.125).tanh(),
    ]);
    for i12 in 0..0_usize {
        l11 += &List(vec![
            ((a - 0.375_f64).tanh() + 0.125).tanh(),
            (c - -0.375_f64).tanh(),
            ((r9[1] * r1[1]) + 0.125).tanh(),
        ]);
        if (c * r9[3]) <= (r9[0] + c) {
            continue;
        }
        l11 = l11
            + List(vec![
                ((a - 0.375_f64).tanh() + 0.125).tanh(),
                (c - -0.375_f64).tanh(),
                ((r9[1] * r1[1]) + 0.125).tanh(),
            ]) * ((-(r1[0])) * 0.75).sin();
    }
    let e = l11.total();
    let mut l13 = List(vec![
        ((x / (1.5 + a * a)) + 0.125).tanh(),
        (0.625_f64 + r9[2]),
        ((f * r1[1]) + 0.125).tanh(),
    ]);
    for i14 in 0..1_usize {
        l13 += &List(vec![((-(0.875_f64)) * 0.75).sin(), f, ((a * c) * 0.75).sin()]);
        if r9[3] <= (r1[0] / (1.5 + a * a)) {
            continue;
        }
        l13 = l13
            + List(vec![((-(0.875_f64)) * 0.75).sin(), f, ((a * c) * 0.75).sin()])
                * ((a * -0.625_f64).max(r1[0]) * 0.75).sin();
    }
    let e = l13.total();
    if (-(y)) >= a {
        let _guard15 = Guard::set(-0.75);
        let mut p16 = Pair {
            a: ((a - r9[2]) + 0.125).tanh(),
            b: ((0.375_f64 * -0.125_f64).abs() + 0.125).tanh(),
        };
        p16 = (p16 * Pair { a: ((y * c) * 0.75).sin(), b: ((r9[2] * r1[2]) + 0.125).tanh() } + p16)
            .tamed();
        p16 = p16.tamed();
    } else {
        let mut p17 = Pair { a: (a * 0.75).sin(), b: ((y + 0.625_f64) * 0.75).sin() };
        let mut u18: Vec<_> = r9.iter().map(|v| *v * p17.a).collect();
        u18.push((draw() + 0.125).tanh());
        u18[0] = u18[1] * u18[u18.len() - 1];
        let a = (mixed(&u18) + u18[0]).tanh();
    }
    y + e + a + c + f + y + x
}

fn program_28_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = (y + S::from_f64(0.125)).tanh();
    let r1 = [((-(S::from_f64(draw()))) + S::from_f64(0.125)).tanh(); 3];
    let f = match shape(
        ((c * c + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((c + S::from_f64(-0.875_f64)) + S::from_f64(0.125)).tanh(),
    ) {
        Point => (y * S::from_f64(-1.125_f64)).cos(),
        Disc(v) => {
            ((x * x + S::from_f64(0.25)).sqrt()
                / (S::from_f64(1.5)
                    + (y / (S::from_f64(1.5) + v * v)) * (y / (S::from_f64(1.5) + v * v))))
        }
        Shape::Box { w: v, h } => (-((x * S::from_f64(-0.375_f64)).max(h))),
    };
    'l2: for i3 in 1..=4_usize {
        for v in r1.iter() {
            c = c * ((f - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin()
                + *v * ((f - S::from_f64(-0.625_f64)).tanh() * S::from_f64(0.75)).sin();
        }
    }
    c = c * ((y - (c * r1[0])) * S::from_f64(0.75)).sin();
    let mut q4 = [
        Ball {
            height: ((r1[0] - f) * S::from_f64(0.75)).sin(),
            speed: ((r1[0] * r1[0] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((f + r1[0]) * S::from_f64(0.75)).sin(),
            speed: ((r1[1] + r1[2]) + S::from_f64(0.125)).tanh(),
        },
    ];
    let up5 = q4[0].bounce();
    let f = if up5 { q4[1].run(0) } else { (c + S::from_f64(-1.125_f64)) };
    let f = q4[0].height * q4[1].speed - q4[0].speed;
    'l6: for i7 in 2..5_usize {
        if i7 % 4 == 2 {
            break 'l6;
        }
        let mut r8 =
            [((-(S::from_f64(i7 as f64) * S::from_f64(0.25))) + S::from_f64(0.125)).tanh(); 2];
    }
    let mut r9 = [
        ((x - r1[0]) + S::from_f64(0.125)).tanh(),
        ((r1[0] / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(draw())) * S::from_f64(0.75)).sin(),
    ];
    let p10 =
        Pair { a: (-(c)), b: ((f - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh() };
    let c = (<Pair<S> as Soft>::pressed(&p10) + Hard::pressed(&p10) * p10.pressed()).tamed().a;
    let mut a = ((f - f) + S::from_f64(0.125)).tanh();
    let mut l11 = List(vec![
        ((r9[3] + x) + S::from_f64(0.125)).tanh(),
        (S::from_f64(scale()) - r1[2]),
        ((S::from_f64(-0.875_f64) + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
    ]);
    for i12 in 0..0_usize {
        l11 += &List(vec![
            ((a - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
            (c - S::from_f64(-0.375_f64)).tanh(),
            ((r9[1] * r1[1]) + S::from_f64(0.125)).tanh(),
        ]);
        if (c * r9[3]).cmple((r9[0] + c)) {
            continue;
        }
        l11 = l11
            + List(vec![
                ((a - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
                (c - S::from_f64(-0.375_f64)).tanh(),
                ((r9[1] * r1[1]) + S::from_f64(0.125)).tanh(),
            ]) * ((-(r1[0])) * S::from_f64(0.75)).sin();
    }
    let e = l11.total();
    let mut l13 = List(vec![
        ((x / (S::from_f64(1.5) + a * a)) + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.625_f64) + r9[2]),
        ((f * r1[1]) + S::from_f64(0.125)).tanh(),
    ]);
    for i14 in 0..1_usize {
        l13 += &List(vec![
            ((-(S::from_f64(0.875_f64))) * S::from_f64(0.75)).sin(),
            f,
            ((a * c) * S::from_f64(0.75)).sin(),
        ]);
        if r9[3].cmple((r1[0] / (S::from_f64(1.5) + a * a))) {
            continue;
        }
        l13 = l13
            + List(vec![
                ((-(S::from_f64(0.875_f64))) * S::from_f64(0.75)).sin(),
                f,
                ((a * c) * S::from_f64(0.75)).sin(),
            ]) * ((a * S::from_f64(-0.625_f64)).max(r1[0]) * S::from_f64(0.75)).sin();
    }
    let e = l13.total();
    if (-(y)).cmpge(a) {
        let _guard15 = Guard::set(-0.75);
        let mut p16 = Pair {
            a: ((a - r9[2]) + S::from_f64(0.125)).tanh(),
            b: ((S::from_f64(0.375_f64) * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125))
                .tanh(),
        };
        p16 =
            (p16 * Pair {
                a: ((y * c) * S::from_f64(0.75)).sin(),
                b: ((r9[2] * r1[2]) + S::from_f64(0.125)).tanh(),
            } + p16)
                .tamed();
        p16 = p16.tamed();
    } else {
        let mut p17 = Pair {
            a: (a * S::from_f64(0.75)).sin(),
            b: ((y + S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
        };
        let mut u18: Vec<_> = r9.iter().map(|v| *v * p17.a).collect();
        u18.push((S::from_f64(draw()) + S::from_f64(0.125)).tanh());
        u18[0] = u18[1] * u18[u18.len() - 1];
        let a = (mixed(&u18) + u18[0]).tanh();
    }
    y + e + a + c + f + y + x
}

of_parts!(#[differentiable] program_29 (b, sum: f64) f64::from, b - (-0.875_f64 + -0.875_f64).sin(), draw() - (b * -0.875_f64).cos(), -b * (draw() * b));
of_parts!(program_29_of<S> (b, sum: S) S::from_f64, b - (S::from_f64(-0.875_f64) + S::from_f64(-0.875_f64)).sin(), S::from_f64(draw()) - (b * S::from_f64(-0.875_f64)).cos(), -b * (S::from_f64(draw()) * b));

#[differentiable]
fn program_30(x: f64, y: f64) -> f64 {
    let mut c = ((y + x) * 0.75).sin();
    let r1 = [((c * x) + 0.125).tanh(); 2];
    let mut r2 = [
        ((y - scale()) * 0.75).sin(),
        ((r1[1] - 0.625_f64).tanh() + 0.125).tanh(),
        ((x * c) * 0.75).sin(),
        ((y + c) * 0.75).sin(),
    ];
    let by3 = ((c + x) + 0.125).tanh();
    let a = shifted(&mut r2[3..], by3);
    if (x / (1.5 + x * x)) <= (0.375_f64 * 0.625_f64).abs() {
        return ((r1[1] * -0.875_f64).cos() + 0.875_f64).sin();
    }
    let mut p4 = Pair { a: ((r2[3] * 0.125_f64).abs() * 0.75).sin(), b: ((x * c) + 0.125).tanh() };
    p4 = -(p4 - p4).tamed();
    p4 = p4.tamed();
    let mut d = ((-0.375_f64 - 0.625_f64).tanh() + 0.125).tanh();
    r2[2] += (((r2[1] + scale()) - (r1[0] * -1.125_f64).max(r2[0])) * 0.75).sin();
    let a = match root((r2[1] * -0.625_f64).max(r1[0])) {
        Some(v) => ((v + 0.125_f64).sin() * 0.875_f64).cos(),
        None => a,
    };
    let mut r5 = [
        ((x * r1[0]) * 0.75).sin(),
        (r2[2] * 0.75).sin(),
        ((y * -0.625_f64).abs() * 0.75).sin(),
        ((r1[0] + y) + 0.125).tanh(),
    ];
    let mut z6;
    let mut n7 = 0_usize;
    loop {
        n7 += 1;
        let t = ((-(p4.b)) * (y + a));
        if n7 > 2 || (p4.a * -0.375_f64) < (r1[0] - -0.125_f64).tanh() {
            z6 = ((0.625_f64 + c) - t);
            break;
        }
    }
    z6 = z6 * (0.625_f64 * 0.125_f64).max(y);
    z6 *= ((r2[3] * -0.625_f64).max(r5[2]) * 0.75).sin();
    let by8 = ((-(0.625_f64)) + 0.125).tanh();
    let a = shifted(&mut r5[2..], by8);
    let g9 = |t: f64| d * t;
    let e = (g9((-0.625_f64 + 0.625_f64).sin()) + g9((c / (1.5 + r2[1] * r2[1])))).sin();
    let mut e = (r5[2] * 0.75).sin();
    ((r2[1] - -1.125_f64).tanh() + -0.625_f64).sin() + e + a + z6 + d + c + y + x
}

fn program_30_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y + x) * S::from_f64(0.75)).sin();
    let r1 = [((c * x) + S::from_f64(0.125)).tanh(); 2];
    let mut r2 = [
        ((y - S::from_f64(scale())) * S::from_f64(0.75)).sin(),
        ((r1[1] - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((x * c) * S::from_f64(0.75)).sin(),
        ((y + c) * S::from_f64(0.75)).sin(),
    ];
    let by3 = ((c + x) + S::from_f64(0.125)).tanh();
    let a = shifted(&mut r2[3..], by3);
    if (x / (S::from_f64(1.5) + x * x))
        .cmple((S::from_f64(0.375_f64) * S::from_f64(0.625_f64)).abs())
    {
        return ((r1[1] * S::from_f64(-0.875_f64)).cos() + S::from_f64(0.875_f64)).sin();
    }
    let mut p4 = Pair {
        a: ((r2[3] * S::from_f64(0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        b: ((x * c) + S::from_f64(0.125)).tanh(),
    };
    p4 = -(p4 - p4).tamed();
    p4 = p4.tamed();
    let mut d =
        ((S::from_f64(-0.375_f64) - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    r2[2] = r2[2]
        + (((r2[1] + S::from_f64(scale())) - (r1[0] * S::from_f64(-1.125_f64)).max(r2[0]))
            * S::from_f64(0.75))
        .sin();
    let a = match root((r2[1] * S::from_f64(-0.625_f64)).max(r1[0])) {
        Some(v) => ((v + S::from_f64(0.125_f64)).sin() * S::from_f64(0.875_f64)).cos(),
        None => a,
    };
    let mut r5 = [
        ((x * r1[0]) * S::from_f64(0.75)).sin(),
        (r2[2] * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
        ((r1[0] + y) + S::from_f64(0.125)).tanh(),
    ];
    let mut z6;
    let mut n7 = 0_usize;
    loop {
        n7 += 1;
        let t = ((-(p4.b)) * (y + a));
        if n7 > 2
            || (p4.a * S::from_f64(-0.375_f64)).cmplt((r1[0] - S::from_f64(-0.125_f64)).tanh())
        {
            z6 = ((S::from_f64(0.625_f64) + c) - t);
            break;
        }
    }
    z6 = z6 * (S::from_f64(0.625_f64) * S::from_f64(0.125_f64)).max(y);
    z6 = z6 * ((r2[3] * S::from_f64(-0.625_f64)).max(r5[2]) * S::from_f64(0.75)).sin();
    let by8 = ((-(S::from_f64(0.625_f64))) + S::from_f64(0.125)).tanh();
    let a = shifted(&mut r5[2..], by8);
    let g9 = |t: S| d * t;
    let e = (g9((S::from_f64(-0.625_f64) + S::from_f64(0.625_f64)).sin())
        + g9((c / (S::from_f64(1.5) + r2[1] * r2[1]))))
    .sin();
    let mut e = (r5[2] * S::from_f64(0.75)).sin();
    ((r2[1] - S::from_f64(-1.125_f64)).tanh() + S::from_f64(-0.625_f64)).sin()
        + e
        + a
        + z6
        + d
        + c
        + y
        + x
}

#[differentiable]
fn program_31(x: f64, y: f64) -> f64 {
    let mut d = ((y / (1.5 + y * y)) + 0.125).tanh();
    let mut r1 = [
        ((y * -0.125_f64).max(x) * 0.75).sin(),
        ((d * draw()) * 0.75).sin(),
        ((d * -0.375_f64).max(d) + 0.125).tanh(),
        ((y * -0.625_f64).abs() * 0.75).sin(),
    ];
    let d = ((-(x)) - 0.125_f64).tanh();
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((r1[0] + d) * (-(r1[0])));
        if n3 > 2 || (-(d)) >= y {
            z2 = y;
            break;
        }
    }
    let mut q4 = [
        Ball { height: (draw() * 0.75).sin(), speed: ((r1[0] / (1.5 + d * d)) + 0.125).tanh() },
        Ball { height: ((z2 * d) * 0.75).sin(), speed: ((z2 * y) * 0.75).sin() },
    ];
    let up5 = q4[1].bounce();
    let e = if up5 { q4[1].run(0) } else { (z2 + 0.875_f64) };
    let c = q4[0].height * q4[1].speed - q4[0].speed;
    #[differentiable(checkpoint)]
    'l6: for i7 in 1..5_usize {
        let d = r1[raised(&mut r1) % 4] * (-0.875_f64 * 0.625_f64).cos();
        let e = if (r1[2] - d) > -0.375_f64 {
            ((z2 - 0.875_f64).tanh() * (z2 - 0.875_f64).tanh() + 0.25).sqrt()
        } else {
            ((x + r1[i7 % 4]) - -0.125_f64).tanh()
        };
        let mut u9: Vec<_> = r1.iter().map(|v| *v * c).collect();
        u9.push(((c - z2) + 0.125).tanh());
        u9[0] = u9[1] * u9[u9.len() - 1];
        let d = (mixed(&u9) + u9[0]).tanh();
    }
    let mut p10 =
        Pair { a: ((z2 / (1.5 + y * y)) + 0.125).tanh(), b: ((y + 0.125_f64).sin() * 0.75).sin() };
    let g11 = |t: f64| ((r1[0] * x) * -0.125_f64).abs() * t;
    let e = (g11((x * 0.375_f64).max(y)) + g11((-(y)))).sin();
    p10 = (p10 - p10 * ((z2 * z2 + 0.25).sqrt() * 0.75).sin()).tamed();
    p10 = p10.tamed();
    let c = p10.dot(&p10).sin();
    let d = mixed(&r1).sin();
    p10 = (p10
        * Pair { a: ((r1[2] * r1[3]) + 0.125).tanh(), b: ((d * -0.125_f64).abs() * 0.75).sin() }
        + p10)
        .tamed();
    p10 = p10.tamed();
    let c = root((draw() + c)).map_or(z2, |v| (-((-0.375_f64 * 0.125_f64).cos())));
    ((c * r1[3]) - c) + c + d + e + z2 + y + x
}

fn program_31_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut d = ((y / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((y * S::from_f64(-0.125_f64)).max(x) * S::from_f64(0.75)).sin(),
        ((d * S::from_f64(draw())) * S::from_f64(0.75)).sin(),
        ((d * S::from_f64(-0.375_f64)).max(d) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-0.625_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    let d = ((-(x)) - S::from_f64(0.125_f64)).tanh();
    let z2;
    let mut n3 = 0_usize;
    loop {
        n3 += 1;
        let t = ((r1[0] + d) * (-(r1[0])));
        if n3 > 2 || (-(d)).cmpge(y) {
            z2 = y;
            break;
        }
    }
    let mut q4 = [
        Ball {
            height: (S::from_f64(draw()) * S::from_f64(0.75)).sin(),
            speed: ((r1[0] / (S::from_f64(1.5) + d * d)) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((z2 * d) * S::from_f64(0.75)).sin(),
            speed: ((z2 * y) * S::from_f64(0.75)).sin(),
        },
    ];
    let up5 = q4[1].bounce();
    let e = if up5 { q4[1].run(0) } else { (z2 + S::from_f64(0.875_f64)) };
    let c = q4[0].height * q4[1].speed - q4[0].speed;

    'l6: for i7 in 1..5_usize {
        let d = r1[raised(&mut r1) % 4] * (S::from_f64(-0.875_f64) * S::from_f64(0.625_f64)).cos();
        let e = if (r1[2] - d).cmpgt(S::from_f64(-0.375_f64)) {
            ((z2 - S::from_f64(0.875_f64)).tanh() * (z2 - S::from_f64(0.875_f64)).tanh()
                + S::from_f64(0.25))
            .sqrt()
        } else {
            ((x + r1[i7 % 4]) - S::from_f64(-0.125_f64)).tanh()
        };
        let mut u9: Vec<_> = r1.iter().map(|v| *v * c).collect();
        u9.push(((c - z2) + S::from_f64(0.125)).tanh());
        u9[0] = u9[1] * u9[u9.len() - 1];
        let d = (mixed(&u9) + u9[0]).tanh();
    }
    let mut p10 = Pair {
        a: ((z2 / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(),
        b: ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    };
    let g11 = |t: S| ((r1[0] * x) * S::from_f64(-0.125_f64)).abs() * t;
    let e = (g11((x * S::from_f64(0.375_f64)).max(y)) + g11((-(y)))).sin();
    p10 = (p10 - p10 * ((z2 * z2 + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin()).tamed();
    p10 = p10.tamed();
    let c = p10.dot(&p10).sin();
    let d = mixed(&r1).sin();
    p10 =
        (p10 * Pair {
            a: ((r1[2] * r1[3]) + S::from_f64(0.125)).tanh(),
            b: ((d * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        } + p10)
            .tamed();
    p10 = p10.tamed();
    let c = root((S::from_f64(draw()) + c))
        .map_or(z2, |v| (-((S::from_f64(-0.375_f64) * S::from_f64(0.125_f64)).cos())));
    ((c * r1[3]) - c) + c + d + e + z2 + y + x
}

#[differentiable]
fn program_32(x: f64, y: f64) -> f64 {
    let mut b = (y + 0.125).tanh();
    let mut r1 = [
        ((b * x) + 0.125).tanh(),
        (b * 0.75).sin(),
        ((x * x + 0.25).sqrt() * 0.75).sin(),
        ((scale() * x) + 0.125).tanh(),
        ((y * -0.125_f64).abs() + 0.125).tanh(),
    ];
    let k2 = (b - -0.625_f64).tanh();
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    let g3 = |t: f64| ((y / (1.5 + y * y)) * (t * 0.875_f64).abs()) * t;
    let e = (g3((x - 0.875_f64).tanh()) + g3((x + 0.375_f64).sin())).sin();
    'l4: for i5 in 1..1_usize {
        let l6 = List(vec![
            ((r1[i5 % 5] * 0.625_f64) * 0.75).sin(),
            (r1[(i5 + 2) % 5] * 0.625_f64).max(((i5 as f64) * 0.25)),
            ((y * y + 0.25).sqrt() + 0.125).tanh(),
        ]);
        let m7 = &l6
            * &List(vec![
                ((((i5 as f64) * 0.25) + r1[(i5 * i5 + 1) % 5]) * 0.75).sin(),
                (x * 0.125_f64).abs(),
                ((e + -0.375_f64).sin() + 0.125).tanh(),
            ]);
        let e = ((&(&l6 * &m7) * &m7).total() * l6.total()).tanh();
        let c = mixed(&r1[..5]).sin();
    }
    let g8 = |t: f64| (t + (b * t)) * t;
    let f = (g8((r1[3] - draw())) + g8((x - -0.625_f64).tanh())).sin();
    let a = if raises(&mut r1) { (r1[2] + f) } else { r1[0] };
    let e = mixed(&r1[0..]).sin();
    let b = program_30(((f + -0.875_f64).sin() + 0.125).tanh(), ((-(f)) * 0.75).sin()).tanh();
    r1[2] += (((r1[2] * a) + 0.125_f64).sin() * 0.75).sin();
    let mut b = ((draw() * -0.375_f64).abs() + 0.125).tanh();
    b -= ((0.625_f64 - (0.625_f64 * r1[1])) * 0.75).sin();
    let mut z9;
    if (-(f)) >= (a + r1[4]) {
        let t = ((f + x) * (x - 0.375_f64).tanh());
        z9 = ((b * -0.625_f64).max(r1[2]) * 0.625_f64).cos();
    } else if (-(y)) < scale() {
        z9 = bent((y * y + 0.25).sqrt());
    } else {
        z9 = ((f + x) * (x - 0.375_f64).tanh());
    }
    z9 = z9 * (y * y + 0.25).sqrt();
    let f = summed(
        |t: f64| ((-(z9 - r1[0])) * t).sin(),
        ((r1[0] - -0.375_f64).tanh() + 0.125).tanh(),
        0,
    )
    .tanh();
    (b * e) + f + z9 + b + e + a + y + x
}

fn program_32_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (y + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((b * x) + S::from_f64(0.125)).tanh(),
        (b * S::from_f64(0.75)).sin(),
        ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((S::from_f64(scale()) * x) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    ];
    let k2 = (b - S::from_f64(-0.625_f64)).tanh();
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    let g3 = |t: S| ((y / (S::from_f64(1.5) + y * y)) * (t * S::from_f64(0.875_f64)).abs()) * t;
    let e =
        (g3((x - S::from_f64(0.875_f64)).tanh()) + g3((x + S::from_f64(0.375_f64)).sin())).sin();
    'l4: for i5 in 1..1_usize {
        let l6 = List(vec![
            ((r1[i5 % 5] * S::from_f64(0.625_f64)) * S::from_f64(0.75)).sin(),
            (r1[(i5 + 2) % 5] * S::from_f64(0.625_f64))
                .max((S::from_f64(i5 as f64) * S::from_f64(0.25))),
            ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ]);
        let m7 = &l6
            * &List(vec![
                (((S::from_f64(i5 as f64) * S::from_f64(0.25)) + r1[(i5 * i5 + 1) % 5])
                    * S::from_f64(0.75))
                .sin(),
                (x * S::from_f64(0.125_f64)).abs(),
                ((e + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(),
            ]);
        let e = ((&(&l6 * &m7) * &m7).total() * l6.total()).tanh();
        let c = mixed(&r1[..5]).sin();
    }
    let g8 = |t: S| (t + (b * t)) * t;
    let f = (g8((r1[3] - S::from_f64(draw()))) + g8((x - S::from_f64(-0.625_f64)).tanh())).sin();
    let a = if raises(&mut r1) { (r1[2] + f) } else { r1[0] };
    let e = mixed(&r1[0..]).sin();
    let b = program_30_of(
        ((f + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((-(f)) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    r1[2] = r1[2] + (((r1[2] * a) + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let mut b = ((S::from_f64(draw()) * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    b = b - ((S::from_f64(0.625_f64) - (S::from_f64(0.625_f64) * r1[1])) * S::from_f64(0.75)).sin();
    let mut z9;
    if (-(f)).cmpge((a + r1[4])) {
        let t = ((f + x) * (x - S::from_f64(0.375_f64)).tanh());
        z9 = ((b * S::from_f64(-0.625_f64)).max(r1[2]) * S::from_f64(0.625_f64)).cos();
    } else if (-(y)).cmplt(S::from_f64(scale())) {
        z9 = bent((y * y + S::from_f64(0.25)).sqrt());
    } else {
        z9 = ((f + x) * (x - S::from_f64(0.375_f64)).tanh());
    }
    z9 = z9 * (y * y + S::from_f64(0.25)).sqrt();
    let f = summed(
        |t: S| ((-(z9 - r1[0])) * t).sin(),
        ((r1[0] - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
        0,
    )
    .tanh();
    (b * e) + f + z9 + b + e + a + y + x
}

#[differentiable]
fn program_33(x: f64, y: f64) -> f64 {
    let mut b = ((y * y) * 0.75).sin();
    let r1 = [((-1.125_f64 + y) + 0.125).tanh(); 5];
    let mut r2 = [
        ((x * x + 0.25).sqrt() + 0.125).tanh(),
        ((x * -0.875_f64).max(b) * 0.75).sin(),
        ((r1[1] * -0.875_f64).max(r1[0]) + 0.125).tanh(),
        ((r1[3] * -0.125_f64).abs() * 0.75).sin(),
    ];
    let f = List(vec![(b * 0.75).sin(), (y * r1[0]), ((x * y) + 0.125).tanh()])
        .folded((r2[3] + 0.125).tanh(), |s, v| (s * v + (b * b + 0.25).sqrt()).sin());
    if (r1[0] * b) >= (y * 0.125_f64).abs() {
        let p3 = Pair { a: (draw() - y), b: ((r2[1] * x) + 0.125).tanh() };
        let b = (<Pair<f64> as Soft>::pressed(&p3) + Hard::pressed(&p3) * p3.pressed()).tamed().a;
        let mut w4 = (((b * x) * 0.75).sin(), [(r2[3] * b); 2]);
        {
            let (p, [q, _]) = &mut w4;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w4.0 + w4.1[0] * w4.1[1]).tanh();
        let mut n6 = 0_usize;
        'l5: while n6 < 2 {
            n6 += 1;
            let mut p7 = Pair {
                a: ((r2[0] * -1.125_f64).max(((n6 as f64) * 0.25)) * 0.75).sin(),
                b: ((y + ((n6 as f64) * 0.25)) * 0.75).sin(),
            };
            p7 = (p7 * p7 + p7).tamed();
            p7 = p7.tamed();
            let mut f = ((r1[(n6 * n6 + 1) % 5] + x) + 0.125).tanh();
        }
    }
    let g8 = |t: f64| y * t;
    let d = (g8((b * -0.625_f64).max(f)) + g8((x * x))).sin();
    let c = r2[raised(&mut r2) % 4] * (y + y);
    let a: f64 = r1.iter().map(|v| v * ((c * r2[1]) + 0.125).tanh()).sum();
    b = (((-(y)) * (-(y)) + 0.25).sqrt() * 0.75).sin();
    let mut q10 = [
        Ball {
            height: ((x * x + 0.25).sqrt() * 0.75).sin(),
            speed: ((draw() / (1.5 + b * b)) * 0.75).sin(),
        },
        Ball {
            height: ((draw() * r2[1]) * 0.75).sin(),
            speed: ((x * x + 0.25).sqrt() * 0.75).sin(),
        },
    ];
    let up11 = q10[1].bounce();
    let f = if up11 { q10[1].run(0) } else { (r1[1] + -0.625_f64).sin() };
    let b = q10[0].height * q10[1].speed - q10[0].speed;
    ((y * y + 0.25).sqrt() + -1.125_f64).sin() + b + f + a + c + d + y + x
}

fn program_33_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * y) * S::from_f64(0.75)).sin();
    let r1 = [((S::from_f64(-1.125_f64) + y) + S::from_f64(0.125)).tanh(); 5];
    let mut r2 = [
        ((x * x + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-0.875_f64)).max(b) * S::from_f64(0.75)).sin(),
        ((r1[1] * S::from_f64(-0.875_f64)).max(r1[0]) + S::from_f64(0.125)).tanh(),
        ((r1[3] * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
    ];
    let f = List(vec![
        (b * S::from_f64(0.75)).sin(),
        (y * r1[0]),
        ((x * y) + S::from_f64(0.125)).tanh(),
    ])
    .folded((r2[3] + S::from_f64(0.125)).tanh(), |s, v| {
        (s * v + (b * b + S::from_f64(0.25)).sqrt()).sin()
    });
    if (r1[0] * b).cmpge((y * S::from_f64(0.125_f64)).abs()) {
        let p3 =
            Pair { a: (S::from_f64(draw()) - y), b: ((r2[1] * x) + S::from_f64(0.125)).tanh() };
        let b = (<Pair<S> as Soft>::pressed(&p3) + Hard::pressed(&p3) * p3.pressed()).tamed().a;
        let mut w4 = (((b * x) * S::from_f64(0.75)).sin(), [(r2[3] * b); 2]);
        {
            let (p, [q, _]) = &mut w4;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let a = (w4.0 + w4.1[0] * w4.1[1]).tanh();
        let mut n6 = 0_usize;
        'l5: while n6 < 2 {
            n6 += 1;
            let mut p7 = Pair {
                a: ((r2[0] * S::from_f64(-1.125_f64))
                    .max((S::from_f64(n6 as f64) * S::from_f64(0.25)))
                    * S::from_f64(0.75))
                .sin(),
                b: ((y + (S::from_f64(n6 as f64) * S::from_f64(0.25))) * S::from_f64(0.75)).sin(),
            };
            p7 = (p7 * p7 + p7).tamed();
            p7 = p7.tamed();
            let mut f = ((r1[(n6 * n6 + 1) % 5] + x) + S::from_f64(0.125)).tanh();
        }
    }
    let g8 = |t: S| y * t;
    let d = (g8((b * S::from_f64(-0.625_f64)).max(f)) + g8((x * x))).sin();
    let c = r2[raised(&mut r2) % 4] * (y + y);
    let a = r1
        .iter()
        .fold(S::from_f64(-0.0), |s, v| s + *v * ((c * r2[1]) + S::from_f64(0.125)).tanh());
    b = (((-(y)) * (-(y)) + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let mut q10 = [
        Ball {
            height: ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
            speed: ((S::from_f64(draw()) / (S::from_f64(1.5) + b * b)) * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: ((S::from_f64(draw()) * r2[1]) * S::from_f64(0.75)).sin(),
            speed: ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        },
    ];
    let up11 = q10[1].bounce();
    let f = if up11 { q10[1].run(0) } else { (r1[1] + S::from_f64(-0.625_f64)).sin() };
    let b = q10[0].height * q10[1].speed - q10[0].speed;
    ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(-1.125_f64)).sin() + b + f + a + c + d + y + x
}

#[differentiable]
fn program_34(x: f64, y: f64) -> f64 {
    let mut b = ((-0.125_f64 * -0.125_f64 + 0.25).sqrt() + 0.125).tanh();
    let r1 = [((x * b) + 0.125).tanh(), ((b - -1.125_f64).tanh() + 0.125).tanh()];
    let e = summed(bent, ((b - -1.125_f64).tanh() + 0.125).tanh(), 3).tanh();
    let mut r2 = [((r1[1] - 0.375_f64).tanh() * 0.75).sin(); 3];
    let b = program_21((r2[1] * 0.75).sin(), ((r2[1] * e) * 0.75).sin()).tanh();
    let mut f = ((-0.875_f64 * -0.875_f64 + 0.25).sqrt() * 0.75).sin();
    let mut w3 = (((y - 0.875_f64).tanh() * 0.75).sin(), [(r2[2] * -0.625_f64).cos(); 2]);
    {
        let (ref mut p, [ref mut q, _]) = w3;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w3.0 + w3.1[0] * w3.1[1]).tanh();
    'l4: for i5 in (1..2_usize).rev() {
        let a = match root((r2[(i5 * i5 + 1) % 3] - -0.875_f64).tanh()) {
            Some(v) => (r1[i5 % 2] * (r1[i5 % 2] * 0.875_f64).cos()),
            None => f,
        };
    }
    let f = mixed(&r2[..3]).sin();
    let b = if (r2[0] * f) > (scale() * f) && raises(&mut r2) || !raises(&mut r2[1..]) {
        (b * 0.875_f64).cos()
    } else {
        ((f * f + 0.25).sqrt() * (a * a + 0.25).sqrt())
    };
    let mut p6 =
        Pair { a: ((draw() - y) + 0.125).tanh(), b: ((a * 0.875_f64).abs() + 0.125).tanh() };
    p6.b = (a * 0.75).sin();
    p6 = p6.tamed();
    let b = left::curved(r2[2]) * right::curved(((b - -1.125_f64).tanh() + 0.125).tanh())
        - curved(r2[2]);
    let r7 = [((-(r1[0])) + 0.125).tanh(); 2];
    let p8 = Pair { a: (-0.875_f64 - r2[0]), b: (r7[1] + 0.125).tanh() };
    let a = (<Pair<f64> as Soft>::pressed(&p8) + Hard::pressed(&p8) * p8.pressed()).tamed().a;
    ((x + f) * -1.125_f64).cos() + a + b + f + e + y + x
}

fn program_34_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()
        + S::from_f64(0.125))
    .tanh();
    let r1 = [
        ((x * b) + S::from_f64(0.125)).tanh(),
        ((b - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
    ];
    let e =
        summed(bent, ((b - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(), 3).tanh();
    let mut r2 = [((r1[1] - S::from_f64(0.375_f64)).tanh() * S::from_f64(0.75)).sin(); 3];
    let b =
        program_21_of((r2[1] * S::from_f64(0.75)).sin(), ((r2[1] * e) * S::from_f64(0.75)).sin())
            .tanh();
    let mut f = ((S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
        * S::from_f64(0.75))
    .sin();
    let mut w3 = (
        ((y - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin(),
        [(r2[2] * S::from_f64(-0.625_f64)).cos(); 2],
    );
    {
        let (ref mut p, [ref mut q, _]) = w3;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let a = (w3.0 + w3.1[0] * w3.1[1]).tanh();
    'l4: for i5 in (1..2_usize).rev() {
        let a = match root((r2[(i5 * i5 + 1) % 3] - S::from_f64(-0.875_f64)).tanh()) {
            Some(v) => (r1[i5 % 2] * (r1[i5 % 2] * S::from_f64(0.875_f64)).cos()),
            None => f,
        };
    }
    let f = mixed(&r2[..3]).sin();
    let b = if (r2[0] * f).cmpgt((S::from_f64(scale()) * f)) && raises(&mut r2)
        || !raises(&mut r2[1..])
    {
        (b * S::from_f64(0.875_f64)).cos()
    } else {
        ((f * f + S::from_f64(0.25)).sqrt() * (a * a + S::from_f64(0.25)).sqrt())
    };
    let mut p6 = Pair {
        a: ((S::from_f64(draw()) - y) + S::from_f64(0.125)).tanh(),
        b: ((a * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    p6.b = (a * S::from_f64(0.75)).sin();
    p6 = p6.tamed();
    let b = left::curved(r2[2])
        * right::curved(((b - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh())
        - curved(r2[2]);
    let r7 = [((-(r1[0])) + S::from_f64(0.125)).tanh(); 2];
    let p8 = Pair { a: (S::from_f64(-0.875_f64) - r2[0]), b: (r7[1] + S::from_f64(0.125)).tanh() };
    let a = (<Pair<S> as Soft>::pressed(&p8) + Hard::pressed(&p8) * p8.pressed()).tamed().a;
    ((x + f) * S::from_f64(-1.125_f64)).cos() + a + b + f + e + y + x
}

#[differentiable]
fn program_35(x: f64, y: f64) -> f64 {
    let mut b = ((y - y) * 0.75).sin();
    let mut r1 = [
        (y + 0.125).tanh(),
        (0.125_f64 * 0.75).sin(),
        ((y * y) * 0.75).sin(),
        ((draw() * -0.375_f64).max(b) * 0.75).sin(),
        ((y * 0.125_f64).max(y) + 0.125).tanh(),
    ];
    r1[0] -= (((r1[3] * x) * (r1[1] * 0.625_f64).abs()) + 0.125).tanh();
    let by2 = ((b / (1.5 + r1[1] * r1[1])) + 0.125).tanh();
    let e = shifted(&mut r1[0..], by2);
    let b = match roots((y + b), (e * scale())) {
        Ok(v) => ((y * r1[0]) * (y * r1[0]) + 0.25).sqrt(),
        Err(true) => y,
        Err(_) => (e * x),
    };
    let c = mixed(&r1[..4]).sin();
    let e = if (r1[1] + -0.125_f64).sin() > (0.125_f64 * x) {
        ((b * r1[2]) + -0.125_f64).sin()
    } else {
        ((y + 0.875_f64).sin() + x)
    };
    if (draw() * draw() + 0.25).sqrt() > (y * -0.875_f64).cos() {
        let c = mixed(&r1).sin();
        let mut t3 = ((x * r1[2]) + 0.125).tanh();
        let mut add4 = |v: f64| {
            t3 = (t3 * v + ((b + b) * (y * 0.875_f64).max(r1[3]))).sin();
            t3 > 0.25
        };
        let a = if add4((y / (1.5 + b * b))) || !add4((r1[2] + -0.625_f64).sin()) {
            r1[2]
        } else {
            (draw() * r1[0])
        };
    }
    'l5: for i6 in 2..=3_usize {
        let mut p7 =
            Pair { a: ((0.375_f64 * 0.375_f64 + 0.25).sqrt() * 0.75).sin(), b: (x + 0.125).tanh() };
        if (r1[4] * -0.125_f64).abs() <= (0.625_f64 - p7.b) {
            p7.b =
                ((-1.125_f64 / (1.5 + ((i6 as f64) * 0.25) * ((i6 as f64) * 0.25))) + 0.125).tanh();
            p7 = p7.tamed();
        }
    }
    let f = match shape(((-(x)) + 0.125).tanh(), ((y * 0.125_f64).abs() + 0.125).tanh()) {
        Shape::Point => (r1[0] + e),
        Shape::Disc(v) => {
            ((v * -0.375_f64).max(draw()) / (1.5 + (x * 0.125_f64).cos() * (x * 0.125_f64).cos()))
        }
        Shape::Box { w: v, h } => ((r1[4] * e) * 0.875_f64).max(-0.875_f64),
    };
    'l8: for i9 in 1..2_usize {
        r1[(i9 + 3) % 5] *= (((x * -0.375_f64) * 0.875_f64).abs() + 0.125).tanh();
        let e = mixed(&r1[0..]).sin();
    }
    y + f + e + c + b + y + x
}

fn program_35_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y - y) * S::from_f64(0.75)).sin();
    let mut r1 = [
        (y + S::from_f64(0.125)).tanh(),
        (S::from_f64(0.125_f64) * S::from_f64(0.75)).sin(),
        ((y * y) * S::from_f64(0.75)).sin(),
        ((S::from_f64(draw()) * S::from_f64(-0.375_f64)).max(b) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.125_f64)).max(y) + S::from_f64(0.125)).tanh(),
    ];
    r1[0] = r1[0]
        - (((r1[3] * x) * (r1[1] * S::from_f64(0.625_f64)).abs()) + S::from_f64(0.125)).tanh();
    let by2 = ((b / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh();
    let e = shifted(&mut r1[0..], by2);
    let b = match roots((y + b), (e * S::from_f64(scale()))) {
        Ok(v) => ((y * r1[0]) * (y * r1[0]) + S::from_f64(0.25)).sqrt(),
        Err(true) => y,
        Err(_) => (e * x),
    };
    let c = mixed(&r1[..4]).sin();
    let e = if (r1[1] + S::from_f64(-0.125_f64)).sin().cmpgt((S::from_f64(0.125_f64) * x)) {
        ((b * r1[2]) + S::from_f64(-0.125_f64)).sin()
    } else {
        ((y + S::from_f64(0.875_f64)).sin() + x)
    };
    if (S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25))
        .sqrt()
        .cmpgt((y * S::from_f64(-0.875_f64)).cos())
    {
        let c = mixed(&r1).sin();
        let mut t3 = ((x * r1[2]) + S::from_f64(0.125)).tanh();
        let mut add4 = |v: S| {
            t3 = (t3 * v + ((b + b) * (y * S::from_f64(0.875_f64)).max(r1[3]))).sin();
            t3.cmpgt(S::from_f64(0.25))
        };
        let a = if add4((y / (S::from_f64(1.5) + b * b)))
            || !add4((r1[2] + S::from_f64(-0.625_f64)).sin())
        {
            r1[2]
        } else {
            (S::from_f64(draw()) * r1[0])
        };
    }
    'l5: for i6 in 2..=3_usize {
        let mut p7 = Pair {
            a: ((S::from_f64(0.375_f64) * S::from_f64(0.375_f64) + S::from_f64(0.25)).sqrt()
                * S::from_f64(0.75))
            .sin(),
            b: (x + S::from_f64(0.125)).tanh(),
        };
        if (r1[4] * S::from_f64(-0.125_f64)).abs().cmple((S::from_f64(0.625_f64) - p7.b)) {
            p7.b = ((S::from_f64(-1.125_f64)
                / (S::from_f64(1.5)
                    + (S::from_f64(i6 as f64) * S::from_f64(0.25))
                        * (S::from_f64(i6 as f64) * S::from_f64(0.25))))
                + S::from_f64(0.125))
            .tanh();
            p7 = p7.tamed();
        }
    }
    let f = match shape(
        ((-(x)) + S::from_f64(0.125)).tanh(),
        ((y * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (r1[0] + e),
        Shape::Disc(v) => {
            ((v * S::from_f64(-0.375_f64)).max(S::from_f64(draw()))
                / (S::from_f64(1.5)
                    + (x * S::from_f64(0.125_f64)).cos() * (x * S::from_f64(0.125_f64)).cos()))
        }
        Shape::Box { w: v, h } => {
            ((r1[4] * e) * S::from_f64(0.875_f64)).max(S::from_f64(-0.875_f64))
        }
    };
    'l8: for i9 in 1..2_usize {
        r1[(i9 + 3) % 5] = r1[(i9 + 3) % 5]
            * (((x * S::from_f64(-0.375_f64)) * S::from_f64(0.875_f64)).abs() + S::from_f64(0.125))
                .tanh();
        let e = mixed(&r1[0..]).sin();
    }
    y + f + e + c + b + y + x
}

#[differentiable]
fn program_36(x: f64, y: f64) -> f64 {
    let mut b = ((y * y + 0.25).sqrt() + 0.125).tanh();
    let mut r1 = [((x / (1.5 + b * b)) * 0.75).sin(); 2];
    b += (y * 0.75).sin();
    let a = match roots((r1[1] * 0.125_f64).max(x), x) {
        Ok(v) => {
            ((scale() + v) / (1.5 + (0.375_f64 + 0.375_f64).sin() * (0.375_f64 + 0.375_f64).sin()))
        }
        Err(true) => b,
        Err(_) => (y - scale()),
    };
    r1[1] -= (((scale() * -0.125_f64).cos() - -0.375_f64).tanh() + 0.125).tanh();
    if (-0.125_f64 * y) > (a - x) {
        r1[1] *= (((a * a) / (1.5 + (-(r1[0])) * (-(r1[0])))) * 0.75).sin();
        if r1[1] > r1[1] {
            let mut p2 =
                Pair { a: ((x + b) * 0.75).sin(), b: ((draw() * 0.875_f64).cos() + 0.125).tanh() };
        }
        r1[1] += (((r1[0] / (1.5 + x * x)) / (1.5 + r1[1] * r1[1])) * 0.75).sin();
    } else {
        let mut r3 = [((y - 0.375_f64).tanh() + 0.125).tanh(); 2];
        if (b * -0.625_f64).max(b) <= (r3[0] * -0.125_f64).abs() {
            let mut u4: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u4.push(((0.125_f64 + y) + 0.125).tanh());
            u4[0] = u4[1] * u4[u4.len() - 1];
            let c = (mixed(&u4) + u4[0]).tanh();
        }
        r1[1] = (((scale() * x) * (y / (1.5 + b * b))) * 0.75).sin();
    }
    'l5: for i6 in 0..3_usize {
        let e =
            program_27(((scale() - -0.875_f64).tanh() + 0.125).tanh(), (-1.125_f64 + 0.125).tanh())
                .tanh();
    }
    (-((a * a + 0.25).sqrt())) + a + b + y + x
}

fn program_36_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let mut r1 = [((x / (S::from_f64(1.5) + b * b)) * S::from_f64(0.75)).sin(); 2];
    b = b + (y * S::from_f64(0.75)).sin();
    let a = match roots((r1[1] * S::from_f64(0.125_f64)).max(x), x) {
        Ok(v) => {
            ((S::from_f64(scale()) + v)
                / (S::from_f64(1.5)
                    + (S::from_f64(0.375_f64) + S::from_f64(0.375_f64)).sin()
                        * (S::from_f64(0.375_f64) + S::from_f64(0.375_f64)).sin()))
        }
        Err(true) => b,
        Err(_) => (y - S::from_f64(scale())),
    };
    r1[1] = r1[1]
        - (((S::from_f64(scale()) * S::from_f64(-0.125_f64)).cos() - S::from_f64(-0.375_f64))
            .tanh()
            + S::from_f64(0.125))
        .tanh();
    if (S::from_f64(-0.125_f64) * y).cmpgt((a - x)) {
        r1[1] = r1[1]
            * (((a * a) / (S::from_f64(1.5) + (-(r1[0])) * (-(r1[0])))) * S::from_f64(0.75)).sin();
        if r1[1].cmpgt(r1[1]) {
            let mut p2 = Pair {
                a: ((x + b) * S::from_f64(0.75)).sin(),
                b: ((S::from_f64(draw()) * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125))
                    .tanh(),
            };
        }
        r1[1] = r1[1]
            + (((r1[0] / (S::from_f64(1.5) + x * x)) / (S::from_f64(1.5) + r1[1] * r1[1]))
                * S::from_f64(0.75))
            .sin();
    } else {
        let mut r3 = [((y - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(); 2];
        if (b * S::from_f64(-0.625_f64)).max(b).cmple((r3[0] * S::from_f64(-0.125_f64)).abs()) {
            let mut u4: Vec<_> = r1.iter().map(|v| *v * y).collect();
            u4.push(((S::from_f64(0.125_f64) + y) + S::from_f64(0.125)).tanh());
            u4[0] = u4[1] * u4[u4.len() - 1];
            let c = (mixed(&u4) + u4[0]).tanh();
        }
        r1[1] = (((S::from_f64(scale()) * x) * (y / (S::from_f64(1.5) + b * b)))
            * S::from_f64(0.75))
        .sin();
    }
    'l5: for i6 in 0..3_usize {
        let e = program_27_of(
            ((S::from_f64(scale()) - S::from_f64(-0.875_f64)).tanh() + S::from_f64(0.125)).tanh(),
            (S::from_f64(-1.125_f64) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    (-((a * a + S::from_f64(0.25)).sqrt())) + a + b + y + x
}

#[differentiable]
fn program_37(x: f64, y: f64) -> f64 {
    let mut b = ((0.375_f64 + -0.625_f64) * 0.75).sin();
    let mut r1 = [((b - -0.375_f64).tanh() + 0.125).tanh(); 2];
    let e = match shape(((x * -0.875_f64).abs() + 0.125).tanh(), (y * 0.75).sin()) {
        Shape::Point => (b + r1[0]),
        Shape::Disc(v) => ((b + draw()) * 0.875_f64).max(r1[1]),
        Shape::Box { w: v, h } => b,
    };
    let d = match shape((x + 0.125).tanh(), ((x / (1.5 + x * x)) * 0.75).sin()) {
        Point => draw(),
        Disc(v) => ((r1[0] * 0.375_f64).cos() * 0.875_f64),
        Shape::Box { w: v, h } => ((v - b) * (b * -0.125_f64).cos()),
    };
    let f = ((-(r1[1])) * (-(r1[1])) + 0.25).sqrt();
    let mut p2 = Pair {
        a: ((draw() / (1.5 + 0.875_f64 * 0.875_f64)) * 0.75).sin(),
        b: ((-(b)) + 0.125).tanh(),
    };
    let g3 = |t: f64, v: &[f64]| mixed(v) * t + (((e + scale()) * -1.125_f64).max(e)).tanh();
    let c = folded(&g3, ((0.125_f64 + 0.625_f64).sin() + 0.125).tanh(), &r1).sin();
    let by4 = ((d * d + 0.25).sqrt() * 0.75).sin();
    let b = shifted(&mut r1[1..], by4);
    let by5 = ((r1[1] * r1[1] + 0.25).sqrt() + 0.125).tanh();
    let a = shifted(&mut r1[1..], by5);
    let mut e = ((-0.625_f64 - r1[0]) + 0.125).tanh();
    p2.b = (b * 0.75).sin();
    p2 = p2.tamed();
    let mut r6 = [
        ((d / (1.5 + -0.625_f64 * -0.625_f64)) * 0.75).sin(),
        ((d + -0.375_f64).sin() * 0.75).sin(),
        ((b * 0.375_f64).max(b) + 0.125).tanh(),
        ((e - b) + 0.125).tanh(),
        ((e * a) + 0.125).tanh(),
    ];
    let b = left::curved((-(x))) * right::curved(((-(c)) + 0.125).tanh()) - curved((-(x)));
    let by7 = ((b * r6[0]) * 0.75).sin();
    let m8 = &mut r6;
    if raises(m8) && !raises(m8) {
        m8[0] = by7 * m8[1];
    }
    let k9: usize = raised(m8);
    let mut n11 = 0_usize;
    'l10: while n11 < 1 {
        n11 += 1;
        let mut u12 = r1.to_vec();
        u12.push(((((n11 as f64) * 0.25) * r6[(n11 + 3) % 5]) + 0.125).tanh());
        u12[0] = u12[1] * u12[u12.len() - 1];
        let a = (mixed(&u12) + u12[0]).tanh();
    }
    ((((k9 as f64) * 0.25) * -0.625_f64).abs() + (-((k9 as f64) * 0.25)))
        + b
        + e
        + a
        + c
        + f
        + d
        + y
        + x
}

fn program_37_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((S::from_f64(0.375_f64) + S::from_f64(-0.625_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [((b - S::from_f64(-0.375_f64)).tanh() + S::from_f64(0.125)).tanh(); 2];
    let e = match shape(
        ((x * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
        (y * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (b + r1[0]),
        Shape::Disc(v) => ((b + S::from_f64(draw())) * S::from_f64(0.875_f64)).max(r1[1]),
        Shape::Box { w: v, h } => b,
    };
    let d = match shape(
        (x + S::from_f64(0.125)).tanh(),
        ((x / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
    ) {
        Point => S::from_f64(draw()),
        Disc(v) => ((r1[0] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.875_f64)),
        Shape::Box { w: v, h } => ((v - b) * (b * S::from_f64(-0.125_f64)).cos()),
    };
    let f = ((-(r1[1])) * (-(r1[1])) + S::from_f64(0.25)).sqrt();
    let mut p2 = Pair {
        a: ((S::from_f64(draw())
            / (S::from_f64(1.5) + S::from_f64(0.875_f64) * S::from_f64(0.875_f64)))
            * S::from_f64(0.75))
        .sin(),
        b: ((-(b)) + S::from_f64(0.125)).tanh(),
    };
    let g3 = |t: S, v: &[S]| {
        mixed(v) * t + (((e + S::from_f64(scale())) * S::from_f64(-1.125_f64)).max(e)).tanh()
    };
    let c = folded(
        &g3,
        ((S::from_f64(0.125_f64) + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        &r1,
    )
    .sin();
    let by4 = ((d * d + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin();
    let b = shifted(&mut r1[1..], by4);
    let by5 = ((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let a = shifted(&mut r1[1..], by5);
    let mut e = ((S::from_f64(-0.625_f64) - r1[0]) + S::from_f64(0.125)).tanh();
    p2.b = (b * S::from_f64(0.75)).sin();
    p2 = p2.tamed();
    let mut r6 = [
        ((d / (S::from_f64(1.5) + S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64)))
            * S::from_f64(0.75))
        .sin(),
        ((d + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((b * S::from_f64(0.375_f64)).max(b) + S::from_f64(0.125)).tanh(),
        ((e - b) + S::from_f64(0.125)).tanh(),
        ((e * a) + S::from_f64(0.125)).tanh(),
    ];
    let b =
        left::curved((-(x))) * right::curved(((-(c)) + S::from_f64(0.125)).tanh()) - curved((-(x)));
    let by7 = ((b * r6[0]) * S::from_f64(0.75)).sin();
    let m8 = &mut r6;
    if raises(m8) && !raises(m8) {
        m8[0] = by7 * m8[1];
    }
    let k9: usize = raised(m8);
    let mut n11 = 0_usize;
    'l10: while n11 < 1 {
        n11 += 1;
        let mut u12 = r1.to_vec();
        u12.push(
            (((S::from_f64(n11 as f64) * S::from_f64(0.25)) * r6[(n11 + 3) % 5])
                + S::from_f64(0.125))
            .tanh(),
        );
        u12[0] = u12[1] * u12[u12.len() - 1];
        let a = (mixed(&u12) + u12[0]).tanh();
    }
    (((S::from_f64(k9 as f64) * S::from_f64(0.25)) * S::from_f64(-0.625_f64)).abs()
        + (-(S::from_f64(k9 as f64) * S::from_f64(0.25))))
        + b
        + e
        + a
        + c
        + f
        + d
        + y
        + x
}

#[differentiable]
fn program_38(x: f64, y: f64) -> f64 {
    let mut b = ((y + 0.125_f64).sin() * 0.75).sin();
    let mut r1 = [
        ((0.875_f64 + -0.375_f64).sin() * 0.75).sin(),
        ((scale() + 0.125_f64).sin() * 0.75).sin(),
        ((-(y)) + 0.125).tanh(),
        ((x + -0.625_f64).sin() * 0.75).sin(),
        ((b + y) + 0.125).tanh(),
    ];
    #[differentiable(checkpoint)]
    'l2: for i3 in (0..4_usize).step_by(2) {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * b).collect();
        u4.push(((y * y + 0.25).sqrt() + 0.125).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let c = (mixed(&u4) + u4[0]).tanh();
        'l5: for i6 in (2..2_usize).rev() {
            for v in r1.iter().cycle().take(7) {
                b = (b + *v).sin();
            }
            let mut p7 = Pair {
                a: ((r1[1] * x) * 0.75).sin(),
                b: ((r1[(i3 * i3 + 1) % 5] + b) * 0.75).sin(),
            };
        }
        let f = if ((i3 as f64) * 0.25) >= (((i3 as f64) * 0.25) * -0.375_f64).cos() {
            ((r1[(i3 + 4) % 5] - 0.875_f64).tanh() * -1.125_f64).abs()
        } else {
            ((r1[3] - ((i3 as f64) * 0.25)) * (-(r1[3])))
        };
    }
    'l8: for i9 in 0..=2_usize {
        let (a, mut b) = (((-(x)) + 0.125).tanh(), (r1[i9 % 5] + -0.125_f64).sin());
        if (((i9 as f64) * 0.25) * y) >= b {
            break;
        }
        let e = match roots((r1[(i9 * i9 + 1) % 5] * r1[i9 % 5]), (scale() * 0.875_f64).abs()) {
            Ok(v) => ((b + ((i9 as f64) * 0.25)) * (draw() * -0.125_f64).abs()),
            Err(true) => x,
            Err(_) => (((i9 as f64) * 0.25) + x),
        };
    }
    let k10 = x;
    for part in r1.chunks_exact_mut(2) {
        part[0] = (part[0] * k10).sin();
        part.reverse();
    }
    r1[2] = (((draw() * 0.375_f64).max(y) * -0.375_f64).max(b) + 0.125).tanh();
    if 0.875_f64 > r1[0] {
        r1[2] = (((-0.625_f64 / (1.5 + scale() * scale())) + 0.375_f64).sin() + 0.125).tanh();
        let mut p11 =
            Pair { a: ((y * -0.875_f64).cos() * 0.75).sin(), b: ((r1[3] * b) * 0.75).sin() };
    }
    ((r1[2] * r1[0]) * (0.375_f64 * 0.875_f64).cos()) + b + y + x
}

fn program_38_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((S::from_f64(0.875_f64) + S::from_f64(-0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((S::from_f64(scale()) + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
        ((-(y)) + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        ((b + y) + S::from_f64(0.125)).tanh(),
    ];

    'l2: for i3 in (0..4_usize).step_by(2) {
        let mut u4: Vec<_> = r1.iter().map(|v| *v * b).collect();
        u4.push(((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh());
        u4[0] = u4[1] * u4[u4.len() - 1];
        let c = (mixed(&u4) + u4[0]).tanh();
        'l5: for i6 in (2..2_usize).rev() {
            for v in r1.iter().cycle().take(7) {
                b = (b + *v).sin();
            }
            let mut p7 = Pair {
                a: ((r1[1] * x) * S::from_f64(0.75)).sin(),
                b: ((r1[(i3 * i3 + 1) % 5] + b) * S::from_f64(0.75)).sin(),
            };
        }
        let f = if (S::from_f64(i3 as f64) * S::from_f64(0.25))
            .cmpge(((S::from_f64(i3 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64)).cos())
        {
            ((r1[(i3 + 4) % 5] - S::from_f64(0.875_f64)).tanh() * S::from_f64(-1.125_f64)).abs()
        } else {
            ((r1[3] - (S::from_f64(i3 as f64) * S::from_f64(0.25))) * (-(r1[3])))
        };
    }
    'l8: for i9 in 0..=2_usize {
        let (a, mut b) =
            (((-(x)) + S::from_f64(0.125)).tanh(), (r1[i9 % 5] + S::from_f64(-0.125_f64)).sin());
        if ((S::from_f64(i9 as f64) * S::from_f64(0.25)) * y).cmpge(b) {
            break;
        }
        let e = match roots(
            (r1[(i9 * i9 + 1) % 5] * r1[i9 % 5]),
            (S::from_f64(scale()) * S::from_f64(0.875_f64)).abs(),
        ) {
            Ok(v) => {
                ((b + (S::from_f64(i9 as f64) * S::from_f64(0.25)))
                    * (S::from_f64(draw()) * S::from_f64(-0.125_f64)).abs())
            }
            Err(true) => x,
            Err(_) => ((S::from_f64(i9 as f64) * S::from_f64(0.25)) + x),
        };
    }
    let k10 = x;
    for part in r1.chunks_exact_mut(2) {
        part[0] = (part[0] * k10).sin();
        part.reverse();
    }
    r1[2] = (((S::from_f64(draw()) * S::from_f64(0.375_f64)).max(y) * S::from_f64(-0.375_f64))
        .max(b)
        + S::from_f64(0.125))
    .tanh();
    if S::from_f64(0.875_f64).cmpgt(r1[0]) {
        r1[2] = (((S::from_f64(-0.625_f64)
            / (S::from_f64(1.5) + S::from_f64(scale()) * S::from_f64(scale())))
            + S::from_f64(0.375_f64))
        .sin()
            + S::from_f64(0.125))
        .tanh();
        let mut p11 = Pair {
            a: ((y * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
            b: ((r1[3] * b) * S::from_f64(0.75)).sin(),
        };
    }
    ((r1[2] * r1[0]) * (S::from_f64(0.375_f64) * S::from_f64(0.875_f64)).cos()) + b + y + x
}

#[differentiable]
fn program_39(x: f64, y: f64) -> f64 {
    let mut c = ((draw() * -0.875_f64).abs() * 0.75).sin();
    let mut r1 = [((-0.875_f64 * -0.625_f64).cos() * 0.75).sin(); 5];
    #[differentiable(checkpoint)]
    'l2: for i3 in (1..0_usize).step_by(2) {
        c = (c * 0.75).sin();
    }
    'l4: for i5 in (2..4_usize).rev() {
        'l6: for i7 in (i5..1_usize).step_by(2) {
            let d = ((draw() - 0.875_f64).tanh() + (c * c + 0.25).sqrt());
            let z8;
            if (r1[i5 % 5] - -0.375_f64).tanh() >= y {
                z8 = r1[(i5 + 4) % 5];
            } else {
                z8 = (((i7 as f64) * 0.25) * 0.125_f64).max(scale());
            }
        }
    }
    let b = root((y * y + 0.25).sqrt()).map_or((x * -0.125_f64).abs(), |v| (-(-(draw()))));
    c = (((x * 0.625_f64).abs() * (x * 0.625_f64).abs() + 0.25).sqrt() + 0.125).tanh();
    let mut w9 =
        (((-0.125_f64 * -0.125_f64 + 0.25).sqrt() * 0.75).sin(), [(b * -0.625_f64).cos(); 2]);
    {
        let (ref mut p, [ref mut q, _]) = w9;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let b = (w9.0 + w9.1[0] * w9.1[1]).tanh();
    let k10: usize = raised(&mut r1) % 5;
    let b = summed(
        |t: f64| (((x * -0.375_f64) - (x - r1[(k10 + 0) % 5])) * t).sin(),
        ((-(c)) + 0.125).tanh(),
        2,
    )
    .tanh();
    let c = {
        let _guard = Guard::set(0.5);
        ((r1[(k10 * k10 + 1) % 5] * scale()) * -0.375_f64).abs()
    } * scale();
    let mut p11 =
        Pair { a: ((c * 0.875_f64).cos() + 0.125).tanh(), b: ((scale() - scale()) + 0.125).tanh() };
    'l12: for i13 in (0..3_usize).rev() {
        let mut a = ((p11.b - 0.125_f64).tanh() * 0.75).sin();
        let a = root((((i13 as f64) * 0.25) * -0.375_f64).cos())
            .map_or((r1[(k10 + 1) % 5] - r1[i13 % 5]), |v| {
                ((scale() * 0.125_f64).cos() * (scale() * 0.125_f64).cos() + 0.25).sqrt()
            });
        let mut e = ((c * x) * 0.75).sin();
    }
    ((((k10 as f64) * 0.25) * r1[(k10 + 4) % 5]) * -0.375_f64).cos() + c + b + y + x
}

fn program_39_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((S::from_f64(draw()) * S::from_f64(-0.875_f64)).abs() * S::from_f64(0.75)).sin();
    let mut r1 =
        [((S::from_f64(-0.875_f64) * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(); 5];

    'l2: for i3 in (1..0_usize).step_by(2) {
        c = (c * S::from_f64(0.75)).sin();
    }
    'l4: for i5 in (2..4_usize).rev() {
        'l6: for i7 in (i5..1_usize).step_by(2) {
            let d = ((S::from_f64(draw()) - S::from_f64(0.875_f64)).tanh()
                + (c * c + S::from_f64(0.25)).sqrt());
            let z8;
            if (r1[i5 % 5] - S::from_f64(-0.375_f64)).tanh().cmpge(y) {
                z8 = r1[(i5 + 4) % 5];
            } else {
                z8 = ((S::from_f64(i7 as f64) * S::from_f64(0.25)) * S::from_f64(0.125_f64))
                    .max(S::from_f64(scale()));
            }
        }
    }
    let b = root((y * y + S::from_f64(0.25)).sqrt())
        .map_or((x * S::from_f64(-0.125_f64)).abs(), |v| (-(-(S::from_f64(draw())))));
    c = (((x * S::from_f64(0.625_f64)).abs() * (x * S::from_f64(0.625_f64)).abs()
        + S::from_f64(0.25))
    .sqrt()
        + S::from_f64(0.125))
    .tanh();
    let mut w9 = (
        ((S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64) + S::from_f64(0.25)).sqrt()
            * S::from_f64(0.75))
        .sin(),
        [(b * S::from_f64(-0.625_f64)).cos(); 2],
    );
    {
        let (ref mut p, [ref mut q, _]) = w9;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let b = (w9.0 + w9.1[0] * w9.1[1]).tanh();
    let k10: usize = raised(&mut r1) % 5;
    let b = summed(
        |t: S| (((x * S::from_f64(-0.375_f64)) - (x - r1[(k10 + 0) % 5])) * t).sin(),
        ((-(c)) + S::from_f64(0.125)).tanh(),
        2,
    )
    .tanh();
    let c = {
        let _guard = Guard::set(0.5);
        ((r1[(k10 * k10 + 1) % 5] * S::from_f64(scale())) * S::from_f64(-0.375_f64)).abs()
    } * S::from_f64(scale());
    let mut p11 = Pair {
        a: ((c * S::from_f64(0.875_f64)).cos() + S::from_f64(0.125)).tanh(),
        b: ((S::from_f64(scale()) - S::from_f64(scale())) + S::from_f64(0.125)).tanh(),
    };
    'l12: for i13 in (0..3_usize).rev() {
        let mut a = ((p11.b - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin();
        let a =
            root(((S::from_f64(i13 as f64) * S::from_f64(0.25)) * S::from_f64(-0.375_f64)).cos())
                .map_or((r1[(k10 + 1) % 5] - r1[i13 % 5]), |v| {
                    ((S::from_f64(scale()) * S::from_f64(0.125_f64)).cos()
                        * (S::from_f64(scale()) * S::from_f64(0.125_f64)).cos()
                        + S::from_f64(0.25))
                    .sqrt()
                });
        let mut e = ((c * x) * S::from_f64(0.75)).sin();
    }
    (((S::from_f64(k10 as f64) * S::from_f64(0.25)) * r1[(k10 + 4) % 5]) * S::from_f64(-0.375_f64))
        .cos()
        + c
        + b
        + y
        + x
}

#[differentiable]
fn program_40(x: f64, y: f64) -> f64 {
    let mut c = ((y / (1.5 + x * x)) * 0.75).sin();
    let r1 = [
        ((scale() / (1.5 + -1.125_f64 * -1.125_f64)) * 0.75).sin(),
        ((-(x)) * 0.75).sin(),
        ((y - x) * 0.75).sin(),
        ((c + 0.625_f64).sin() + 0.125).tanh(),
    ];
    let mut p2 = Pair { a: ((-(r1[0])) + 0.125).tanh(), b: ((x - r1[2]) + 0.125).tanh() };
    #[differentiable(checkpoint)]
    'l3: for i4 in 0..=1_usize {
        if i4 % 4 == 3 {
            let c = match roots((c * p2.a), (p2.b * p2.b + 0.25).sqrt()) {
                Ok(v) => ((-0.875_f64 + v) / (1.5 + (-(y)) * (-(y)))),
                Err(true) => c,
                Err(_) => (y * x),
            };
            'l5: for i6 in i4..1_usize {
                p2.turn(((x * c) * 0.75).sin());
                p2 = p2.tamed();
            }
            let e = p2
                .dot(&Pair {
                    a: ((r1[0] * c) + 0.125).tanh(),
                    b: ((x + -1.125_f64).sin() * 0.75).sin(),
                })
                .sin();
        } else {
            for v in r1.iter().cycle().take(5) {
                c = (c + *v).sin();
            }
            if i4 % 3 == 2 {
                break 'l3;
            }
            let f = ((r1[(i4 + 3) % 4] * x) + -0.875_f64).sin();
        }
        let p7 = Pair {
            a: (r1[(i4 * i4 + 1) % 4] + -0.125_f64).sin(),
            b: ((x - -1.125_f64).tanh() * 0.75).sin(),
        };
        let a = (<Pair<f64> as Soft>::pressed(&p7) + Hard::pressed(&p7) * p7.pressed()).tamed().a;
        if i4 % 4 == 0 {
            c += (((y + -0.875_f64).sin() + (c * -0.125_f64).max(((i4 as f64) * 0.25))) + 0.125)
                .tanh();
        } else {
            let mut r8 = [((r1[i4 % 4] * c) * 0.75).sin(), ((y * c) * 0.75).sin()];
            let r9 = [
                (y * 0.75).sin(),
                ((r1[(i4 * i4 + 1) % 4] + y) + 0.125).tanh(),
                ((c * 0.875_f64).max(r8[(i4 * i4 + 1) % 2]) + 0.125).tanh(),
            ];
            let by10 = ((c - -0.125_f64).tanh() * 0.75).sin();
            let m11 = &mut r8;
            if raises(m11) && !raises(m11) {
                m11[0] = by10 * m11[1];
            }
            let k12: usize = raised(m11);
        }
    }
    ((draw() / (1.5 + r1[1] * r1[1])) + (scale() * y)) + c + y + x
}

fn program_40_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin();
    let r1 = [
        ((S::from_f64(scale())
            / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
            * S::from_f64(0.75))
        .sin(),
        ((-(x)) * S::from_f64(0.75)).sin(),
        ((y - x) * S::from_f64(0.75)).sin(),
        ((c + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
    ];
    let mut p2 = Pair {
        a: ((-(r1[0])) + S::from_f64(0.125)).tanh(),
        b: ((x - r1[2]) + S::from_f64(0.125)).tanh(),
    };

    'l3: for i4 in 0..=1_usize {
        if i4 % 4 == 3 {
            let c = match roots((c * p2.a), (p2.b * p2.b + S::from_f64(0.25)).sqrt()) {
                Ok(v) => ((S::from_f64(-0.875_f64) + v) / (S::from_f64(1.5) + (-(y)) * (-(y)))),
                Err(true) => c,
                Err(_) => (y * x),
            };
            'l5: for i6 in i4..1_usize {
                p2.turn(((x * c) * S::from_f64(0.75)).sin());
                p2 = p2.tamed();
            }
            let e = p2
                .dot(&Pair {
                    a: ((r1[0] * c) + S::from_f64(0.125)).tanh(),
                    b: ((x + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
                })
                .sin();
        } else {
            for v in r1.iter().cycle().take(5) {
                c = (c + *v).sin();
            }
            if i4 % 3 == 2 {
                break 'l3;
            }
            let f = ((r1[(i4 + 3) % 4] * x) + S::from_f64(-0.875_f64)).sin();
        }
        let p7 = Pair {
            a: (r1[(i4 * i4 + 1) % 4] + S::from_f64(-0.125_f64)).sin(),
            b: ((x - S::from_f64(-1.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        };
        let a = (<Pair<S> as Soft>::pressed(&p7) + Hard::pressed(&p7) * p7.pressed()).tamed().a;
        if i4 % 4 == 0 {
            c = c
                + (((y + S::from_f64(-0.875_f64)).sin()
                    + (c * S::from_f64(-0.125_f64))
                        .max((S::from_f64(i4 as f64) * S::from_f64(0.25))))
                    + S::from_f64(0.125))
                .tanh();
        } else {
            let mut r8 =
                [((r1[i4 % 4] * c) * S::from_f64(0.75)).sin(), ((y * c) * S::from_f64(0.75)).sin()];
            let r9 = [
                (y * S::from_f64(0.75)).sin(),
                ((r1[(i4 * i4 + 1) % 4] + y) + S::from_f64(0.125)).tanh(),
                ((c * S::from_f64(0.875_f64)).max(r8[(i4 * i4 + 1) % 2]) + S::from_f64(0.125))
                    .tanh(),
            ];
            let by10 = ((c - S::from_f64(-0.125_f64)).tanh() * S::from_f64(0.75)).sin();
            let m11 = &mut r8;
            if raises(m11) && !raises(m11) {
                m11[0] = by10 * m11[1];
            }
            let k12: usize = raised(m11);
        }
    }
    ((S::from_f64(draw()) / (S::from_f64(1.5) + r1[1] * r1[1])) + (S::from_f64(scale()) * y))
        + c
        + y
        + x
}

#[differentiable]
fn program_41(x: f64, y: f64) -> f64 {
    let mut c = ((-(y)) * 0.75).sin();
    let mut r1 = [
        ((y * y + 0.25).sqrt() * 0.75).sin(),
        ((y * -1.125_f64).max(c) + 0.125).tanh(),
        ((y - y) * 0.75).sin(),
        ((c + -1.125_f64).sin() + 0.125).tanh(),
        ((y + scale()) * 0.75).sin(),
    ];
    let k2 = (y + -0.125_f64).sin();
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    let by3 = ((r1[3] - 0.875_f64).tanh() * 0.75).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    r1[0] += (((r1[4] * 0.875_f64).max(c) * 0.375_f64).max(y) + 0.125).tanh();
    let mut c = ((r1[4] * 0.375_f64).abs() + 0.125).tanh();
    let f = ((0.125_f64 - r1[0]) + -0.125_f64).sin();
    let mut p4 = Pair { a: ((c + y) * 0.75).sin(), b: (c + 0.125).tanh() };
    let e = List(vec![
        ((-0.125_f64 * r1[0]) + 0.125).tanh(),
        (-(c)),
        ((r1[0] / (1.5 + p4.a * p4.a)) * 0.75).sin(),
    ])
    .folded(((r1[0] / (1.5 + x * x)) + 0.125).tanh(), |s, v| (s * v + c).sin());
    let mut u5 = r1.to_vec();
    u5.push(((r1[0] * y) * 0.75).sin());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let a = (mixed(&u5) + u5[0]).tanh();
    let d = match root(p4.b) {
        Some(v) => ((r1[0] * 0.875_f64).max(x) - -1.125_f64).tanh(),
        None => (e / (1.5 + p4.b * p4.b)),
    };
    #[differentiable(checkpoint)]
    'l6: for i7 in (0..1_usize).rev() {
        let k8 = (e / (1.5 + d * d));
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k8).sin();
            part.reverse();
        }
    }
    let a = match roots((y + d), (r1[1] + -0.875_f64).sin()) {
        Ok(v) => x,
        Err(true) => x,
        Err(_) => (y * -0.375_f64).cos(),
    };
    let by9 = (d * 0.75).sin();
    let a = shifted(&mut r1[4..], by9);
    let f =
        match shape(((r1[4] + -0.125_f64).sin() + 0.125).tanh(), ((c + -0.375_f64) * 0.75).sin()) {
            Point => d,
            Disc(v) => ((r1[4] * -0.375_f64).max(e) - (0.875_f64 + v)),
            Shape::Box { w: v, h } => r1[1],
        };
    ((e - r1[2]) / (1.5 + (x / (1.5 + y * y)) * (x / (1.5 + y * y)))) + f + a + d + e + c + y + x
}

fn program_41_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut c = ((-(y)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-1.125_f64)).max(c) + S::from_f64(0.125)).tanh(),
        ((y - y) * S::from_f64(0.75)).sin(),
        ((c + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(scale())) * S::from_f64(0.75)).sin(),
    ];
    let k2 = (y + S::from_f64(-0.125_f64)).sin();
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    let by3 = ((r1[3] - S::from_f64(0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    for v in r1.iter_mut() {
        *v = (*v * by3).sin();
    }
    r1[0] = r1[0]
        + (((r1[4] * S::from_f64(0.875_f64)).max(c) * S::from_f64(0.375_f64)).max(y)
            + S::from_f64(0.125))
        .tanh();
    let mut c = ((r1[4] * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    let f = ((S::from_f64(0.125_f64) - r1[0]) + S::from_f64(-0.125_f64)).sin();
    let mut p4 =
        Pair { a: ((c + y) * S::from_f64(0.75)).sin(), b: (c + S::from_f64(0.125)).tanh() };
    let e = List(vec![
        ((S::from_f64(-0.125_f64) * r1[0]) + S::from_f64(0.125)).tanh(),
        (-(c)),
        ((r1[0] / (S::from_f64(1.5) + p4.a * p4.a)) * S::from_f64(0.75)).sin(),
    ])
    .folded(((r1[0] / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(), |s, v| {
        (s * v + c).sin()
    });
    let mut u5 = r1.to_vec();
    u5.push(((r1[0] * y) * S::from_f64(0.75)).sin());
    u5[0] = u5[1] * u5[u5.len() - 1];
    let a = (mixed(&u5) + u5[0]).tanh();
    let d = match root(p4.b) {
        Some(v) => ((r1[0] * S::from_f64(0.875_f64)).max(x) - S::from_f64(-1.125_f64)).tanh(),
        None => (e / (S::from_f64(1.5) + p4.b * p4.b)),
    };

    'l6: for i7 in (0..1_usize).rev() {
        let k8 = (e / (S::from_f64(1.5) + d * d));
        for part in r1.chunks_mut(2) {
            part[0] = (part[0] * k8).sin();
            part.reverse();
        }
    }
    let a = match roots((y + d), (r1[1] + S::from_f64(-0.875_f64)).sin()) {
        Ok(v) => x,
        Err(true) => x,
        Err(_) => (y * S::from_f64(-0.375_f64)).cos(),
    };
    let by9 = (d * S::from_f64(0.75)).sin();
    let a = shifted(&mut r1[4..], by9);
    let f = match shape(
        ((r1[4] + S::from_f64(-0.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((c + S::from_f64(-0.375_f64)) * S::from_f64(0.75)).sin(),
    ) {
        Point => d,
        Disc(v) => ((r1[4] * S::from_f64(-0.375_f64)).max(e) - (S::from_f64(0.875_f64) + v)),
        Shape::Box { w: v, h } => r1[1],
    };
    ((e - r1[2])
        / (S::from_f64(1.5) + (x / (S::from_f64(1.5) + y * y)) * (x / (S::from_f64(1.5) + y * y))))
        + f
        + a
        + d
        + e
        + c
        + y
        + x
}

#[differentiable]
fn program_42(x: f64, y: f64) -> f64 {
    let mut a = ((y * -0.125_f64) * 0.75).sin();
    let mut r1 = [
        ((a - -0.125_f64).tanh() + 0.125).tanh(),
        ((a - 0.125_f64).tanh() * 0.75).sin(),
        ((y * -1.125_f64).abs() + 0.125).tanh(),
        ((a * y) + 0.125).tanh(),
        ((x * a) * 0.75).sin(),
    ];
    let mut n2 = 0_usize;
    while raises(&mut r1) && n2 < 3 {
        n2 += 1;
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        let mut u5: Vec<_> = r1.iter().map(|v| *v * y).collect();
        u5.push(((r1[(n4 + 0) % 5] * -0.875_f64).max(r1[(n4 * n4 + 1) % 5]) * 0.75).sin());
        u5[0] = u5[1] * u5[u5.len() - 1];
        let e = (mixed(&u5) + u5[0]).tanh();
        let e = program_23(((y * a) + 0.125).tanh(), ((a - r1[n4 % 5]) + 0.125).tanh()).tanh();
    }
    let mut t6 = ((y * -1.125_f64).cos() * 0.75).sin();
    let mut add7 = |v: f64| {
        t6 = (t6 * v + ((draw() * y) * (draw() * y) + 0.25).sqrt()).sin();
        t6 > 0.25
    };
    let c = if add7((y * 0.125_f64).abs()) || !add7((0.625_f64 * -0.625_f64).cos()) {
        a
    } else {
        (r1[n2 % 5] * -0.125_f64).abs()
    };
    let by8 = ((r1[(n2 + 2) % 5] * a) * 0.75).sin();
    let b = shifted(&mut r1[1..], by8);
    if n2 % 2 == 1 {
        let b = match n2 % 4 {
            two => (r1[4] + -0.625_f64).sin(),
            k if k > two => (c + x),
            _ => (x / (1.5 + x * x)),
        };
        let b = program_6(
            ((c + 0.625_f64).sin() * 0.75).sin(),
            ((((n2 as f64) * 0.25) * 0.875_f64).max(((n2 as f64) * 0.25)) + 0.125).tanh(),
        )
        .tanh();
    }
    if (r1[1] - r1[(n2 * n2 + 1) % 5]) <= (x * r1[(n2 * n2 + 1) % 5]) {
        return (r1[2] * (r1[(n2 * n2 + 1) % 5] + ((n2 as f64) * 0.25)));
    }
    'l9: for i10 in (2..4_usize).step_by(2) {
        let c = match roots((x + r1[i10 % 5]), (draw() * b)) {
            Ok(v) => ((b + t6) * (x - r1[(n2 + 0) % 5])),
            Err(true) => r1[(i10 + 3) % 5],
            Err(_) => x,
        };
        assert!(raises(&mut r1) || true, "{}", r1.len());
        for v in r1.iter() {
            a = a * (((i10 as f64) * 0.25) + 0.125).tanh()
                + *v * (((i10 as f64) * 0.25) + 0.125).tanh();
        }
    }
    ((r1[(n2 + 1) % 5] + r1[(n2 + 3) % 5]) / (1.5 + (r1[4] - b) * (r1[4] - b)))
        + b
        + t6
        + c
        + a
        + y
        + x
}

fn program_42_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((y * S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [
        ((a - S::from_f64(-0.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((a - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        ((a * y) + S::from_f64(0.125)).tanh(),
        ((x * a) * S::from_f64(0.75)).sin(),
    ];
    let mut n2 = 0_usize;
    while raises(&mut r1) && n2 < 3 {
        n2 += 1;
    }
    let mut n4 = 0_usize;
    'l3: while n4 < 3 {
        n4 += 1;
        let mut u5: Vec<_> = r1.iter().map(|v| *v * y).collect();
        u5.push(
            ((r1[(n4 + 0) % 5] * S::from_f64(-0.875_f64)).max(r1[(n4 * n4 + 1) % 5])
                * S::from_f64(0.75))
            .sin(),
        );
        u5[0] = u5[1] * u5[u5.len() - 1];
        let e = (mixed(&u5) + u5[0]).tanh();
        let e = program_23_of(
            ((y * a) + S::from_f64(0.125)).tanh(),
            ((a - r1[n4 % 5]) + S::from_f64(0.125)).tanh(),
        )
        .tanh();
    }
    let mut t6 = ((y * S::from_f64(-1.125_f64)).cos() * S::from_f64(0.75)).sin();
    let mut add7 = |v: S| {
        t6 = (t6 * v
            + ((S::from_f64(draw()) * y) * (S::from_f64(draw()) * y) + S::from_f64(0.25)).sqrt())
        .sin();
        t6.cmpgt(S::from_f64(0.25))
    };
    let c = if add7((y * S::from_f64(0.125_f64)).abs())
        || !add7((S::from_f64(0.625_f64) * S::from_f64(-0.625_f64)).cos())
    {
        a
    } else {
        (r1[n2 % 5] * S::from_f64(-0.125_f64)).abs()
    };
    let by8 = ((r1[(n2 + 2) % 5] * a) * S::from_f64(0.75)).sin();
    let b = shifted(&mut r1[1..], by8);
    if n2 % 2 == 1 {
        let b = match n2 % 4 {
            two => (r1[4] + S::from_f64(-0.625_f64)).sin(),
            k if k > two => (c + x),
            _ => (x / (S::from_f64(1.5) + x * x)),
        };
        let b = program_6_of(
            ((c + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
            (((S::from_f64(n2 as f64) * S::from_f64(0.25)) * S::from_f64(0.875_f64))
                .max((S::from_f64(n2 as f64) * S::from_f64(0.25)))
                + S::from_f64(0.125))
            .tanh(),
        )
        .tanh();
    }
    if (r1[1] - r1[(n2 * n2 + 1) % 5]).cmple((x * r1[(n2 * n2 + 1) % 5])) {
        return (r1[2] * (r1[(n2 * n2 + 1) % 5] + (S::from_f64(n2 as f64) * S::from_f64(0.25))));
    }
    'l9: for i10 in (2..4_usize).step_by(2) {
        let c = match roots((x + r1[i10 % 5]), (S::from_f64(draw()) * b)) {
            Ok(v) => ((b + t6) * (x - r1[(n2 + 0) % 5])),
            Err(true) => r1[(i10 + 3) % 5],
            Err(_) => x,
        };
        assert!(raises(&mut r1) || true, "{}", r1.len());
        for v in r1.iter() {
            a = a * ((S::from_f64(i10 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh()
                + *v * ((S::from_f64(i10 as f64) * S::from_f64(0.25)) + S::from_f64(0.125)).tanh();
        }
    }
    ((r1[(n2 + 1) % 5] + r1[(n2 + 3) % 5]) / (S::from_f64(1.5) + (r1[4] - b) * (r1[4] - b)))
        + b
        + t6
        + c
        + a
        + y
        + x
}

#[differentiable]
fn program_43(x: f64, y: f64) -> f64 {
    let mut a = ((x * 0.875_f64).max(y) + 0.125).tanh();
    let mut r1 = [((y / (1.5 + x * x)) * 0.75).sin(); 3];
    let mut c = ((r1[0] * draw()) + 0.125).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        'l4: for i5 in n3..=1_usize {
            let e = match shape(
                ((c + -1.125_f64).sin() * 0.75).sin(),
                ((r1[(i5 + 0) % 3] + r1[0]) + 0.125).tanh(),
            ) {
                Shape::Point => (-(draw())),
                Shape::Disc(v) => ((a + c) * y),
                Shape::Box { w: v, h } => (-((draw() * 0.125_f64).abs())),
            };
            let g6 = |t: f64, v: &[f64]| {
                mixed(v) * t + ((r1[(n3 * n3 + 1) % 3] - -0.125_f64).tanh()).tanh()
            };
            let c = folded(
                &g6,
                ((((i5 as f64) * 0.25) / (1.5 + ((n3 as f64) * 0.25) * ((n3 as f64) * 0.25)))
                    * 0.75)
                    .sin(),
                &r1,
            )
            .sin();
        }
    }
    let mut r7 = [((scale() * r1[0]) + 0.125).tanh(); 4];
    let d = left::curved((r7[3] * -0.125_f64).cos()) * right::curved(((c - r7[2]) + 0.125).tanh())
        - curved((r7[3] * -0.125_f64).cos());
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        r7[1] *= (((x * 0.375_f64).cos() - (scale() + scale())) * 0.75).sin();
        let mut z10;
        if (r1[0] * r7[3]) >= (-1.125_f64 * -1.125_f64) {
            z10 = ((((n9 as f64) * 0.25) * scale()) * (-(r1[(n9 + 1) % 3])));
        } else {
            z10 = (-0.125_f64 * r7[3]);
        }
        z10 = z10 * (-0.125_f64 * r7[3]);
    }
    let mut r11 = [
        (x + 0.125).tanh(),
        ((c / (1.5 + d * d)) * 0.75).sin(),
        ((r1[0] + x) * 0.75).sin(),
        ((d + y) * 0.75).sin(),
    ];
    let mut p12 = Pair {
        a: ((scale() + -0.625_f64).sin() * 0.75).sin(),
        b: ((a + -0.875_f64).sin() + 0.125).tanh(),
    };
    let (a, mut b) = (((d * -0.125_f64).abs() + 0.125).tanh(), (r1[1] + -0.375_f64));
    let by13 = ((-(r11[0])) * 0.75).sin();
    let m14 = &mut r7;
    if raises(m14) && !raises(m14) {
        m14[0] = by13 * m14[1];
    }
    let k15: usize = raised(m14);
    ((-(a)) / (1.5 + (draw() * draw() + 0.25).sqrt() * (draw() * draw() + 0.25).sqrt()))
        + b
        + a
        + d
        + c
        + y
        + x
}

fn program_43_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(0.875_f64)).max(y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(); 3];
    let mut c = ((r1[0] * S::from_f64(draw())) + S::from_f64(0.125)).tanh();
    let mut n3 = 0_usize;
    'l2: while n3 < 2 {
        n3 += 1;
        'l4: for i5 in n3..=1_usize {
            let e = match shape(
                ((c + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
                ((r1[(i5 + 0) % 3] + r1[0]) + S::from_f64(0.125)).tanh(),
            ) {
                Shape::Point => (-(S::from_f64(draw()))),
                Shape::Disc(v) => ((a + c) * y),
                Shape::Box { w: v, h } => (-((S::from_f64(draw()) * S::from_f64(0.125_f64)).abs())),
            };
            let g6 = |t: S, v: &[S]| {
                mixed(v) * t + ((r1[(n3 * n3 + 1) % 3] - S::from_f64(-0.125_f64)).tanh()).tanh()
            };
            let c = folded(
                &g6,
                (((S::from_f64(i5 as f64) * S::from_f64(0.25))
                    / (S::from_f64(1.5)
                        + (S::from_f64(n3 as f64) * S::from_f64(0.25))
                            * (S::from_f64(n3 as f64) * S::from_f64(0.25))))
                    * S::from_f64(0.75))
                .sin(),
                &r1,
            )
            .sin();
        }
    }
    let mut r7 = [((S::from_f64(scale()) * r1[0]) + S::from_f64(0.125)).tanh(); 4];
    let d = left::curved((r7[3] * S::from_f64(-0.125_f64)).cos())
        * right::curved(((c - r7[2]) + S::from_f64(0.125)).tanh())
        - curved((r7[3] * S::from_f64(-0.125_f64)).cos());
    let mut n9 = 0_usize;
    'l8: while n9 < 2 {
        n9 += 1;
        r7[1] = r7[1]
            * (((x * S::from_f64(0.375_f64)).cos()
                - (S::from_f64(scale()) + S::from_f64(scale())))
                * S::from_f64(0.75))
            .sin();
        let mut z10;
        if (r1[0] * r7[3]).cmpge((S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64))) {
            z10 = (((S::from_f64(n9 as f64) * S::from_f64(0.25)) * S::from_f64(scale()))
                * (-(r1[(n9 + 1) % 3])));
        } else {
            z10 = (S::from_f64(-0.125_f64) * r7[3]);
        }
        z10 = z10 * (S::from_f64(-0.125_f64) * r7[3]);
    }
    let mut r11 = [
        (x + S::from_f64(0.125)).tanh(),
        ((c / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin(),
        ((r1[0] + x) * S::from_f64(0.75)).sin(),
        ((d + y) * S::from_f64(0.75)).sin(),
    ];
    let mut p12 = Pair {
        a: ((S::from_f64(scale()) + S::from_f64(-0.625_f64)).sin() * S::from_f64(0.75)).sin(),
        b: ((a + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
    };
    let (a, mut b) = (
        ((d * S::from_f64(-0.125_f64)).abs() + S::from_f64(0.125)).tanh(),
        (r1[1] + S::from_f64(-0.375_f64)),
    );
    let by13 = ((-(r11[0])) * S::from_f64(0.75)).sin();
    let m14 = &mut r7;
    if raises(m14) && !raises(m14) {
        m14[0] = by13 * m14[1];
    }
    let k15: usize = raised(m14);
    ((-(a))
        / (S::from_f64(1.5)
            + (S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25)).sqrt()
                * (S::from_f64(draw()) * S::from_f64(draw()) + S::from_f64(0.25)).sqrt()))
        + b
        + a
        + d
        + c
        + y
        + x
}

#[differentiable]
fn program_44(x: f64, y: f64) -> f64 {
    let mut a = ((-0.375_f64 * y) * 0.75).sin();
    let mut r1 = [((x + x) + 0.125).tanh(); 5];
    let f =
        List(vec![((a + -1.125_f64).sin() * 0.75).sin(), y, ((scale() + r1[4]) + 0.125).tanh()])
            .folded((x * 0.75).sin(), |s, v| (s * v + (x * -0.125_f64).cos()).sin());
    let e = match roots((r1[3] * -0.875_f64).cos(), (a - y)) {
        Ok(v) => (f + 0.625_f64).sin(),
        Err(true) => r1[1],
        Err(_) => (r1[3] * r1[3] + 0.25).sqrt(),
    };
    let e = program_23((e * 0.75).sin(), ((r1[4] * -0.625_f64).cos() * 0.75).sin()).tanh();
    let mut p2 =
        Pair { a: ((e * -0.875_f64).cos() * 0.75).sin(), b: ((a / (1.5 + x * x)) + 0.125).tanh() };
    r1[0] = ((x * x) * 0.75).sin();
    let (a, mut b) = (((p2.b / (1.5 + x * x)) * 0.75).sin(), (x * x + 0.25).sqrt());
    let _guard3 = Guard::set(0.75);
    p2.turn(((-(draw())) * 0.75).sin());
    p2 = p2.tamed();
    let e = if (-0.875_f64 * -1.125_f64).cos() > (r1[3] + a) {
        (e + (f - x))
    } else {
        ((-0.625_f64 + x) - 0.125_f64).tanh()
    };
    let f = List(vec![((y * y + 0.25).sqrt() * 0.75).sin(), r1[0], ((-(r1[4])) + 0.125).tanh()])
        .folded(((b + e) + 0.125).tanh(), |s, v| (s * v + (r1[4] * x)).sin());
    let mut t4 = ((p2.a * -0.375_f64).max(r1[2]) + 0.125).tanh();
    let mut add5 = |v: f64| {
        t4 = (t4 * v + scale()).sin();
        t4 > 0.25
    };
    let b = if add5(b) || !add5((e * 0.375_f64).max(-0.125_f64)) {
        -0.875_f64
    } else {
        (r1[4] + -0.875_f64).sin()
    };
    let a = match shape(((t4 + 0.375_f64).sin() * 0.75).sin(), ((-0.375_f64 + r1[2]) * 0.75).sin())
    {
        Shape::Point => (a * e),
        Shape::Disc(v) => ((scale() - -0.625_f64).tanh() + 0.375_f64).sin(),
        Shape::Box { w: v, h } => ((r1[2] * r1[2] + 0.25).sqrt() * (v + t4)),
    };
    let by6 = ((r1[4] * r1[4]) * 0.75).sin();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let a = if k8 % 2 == 0 {
        (x * -1.125_f64).abs()
    } else {
        (f * (r1[(k8 * k8 + 1) % 5] * 0.125_f64).max(r1[(k8 * k8 + 1) % 5]))
    };
    ((b * -0.625_f64).abs() / (1.5 + -0.125_f64 * -0.125_f64)) + a + t4 + b + f + e + y + x
}

fn program_44_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(-0.375_f64) * y) * S::from_f64(0.75)).sin();
    let mut r1 = [((x + x) + S::from_f64(0.125)).tanh(); 5];
    let f = List(vec![
        ((a + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
        y,
        ((S::from_f64(scale()) + r1[4]) + S::from_f64(0.125)).tanh(),
    ])
    .folded((x * S::from_f64(0.75)).sin(), |s, v| {
        (s * v + (x * S::from_f64(-0.125_f64)).cos()).sin()
    });
    let e = match roots((r1[3] * S::from_f64(-0.875_f64)).cos(), (a - y)) {
        Ok(v) => (f + S::from_f64(0.625_f64)).sin(),
        Err(true) => r1[1],
        Err(_) => (r1[3] * r1[3] + S::from_f64(0.25)).sqrt(),
    };
    let e = program_23_of(
        (e * S::from_f64(0.75)).sin(),
        ((r1[4] * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let mut p2 = Pair {
        a: ((e * S::from_f64(-0.875_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((a / (S::from_f64(1.5) + x * x)) + S::from_f64(0.125)).tanh(),
    };
    r1[0] = ((x * x) * S::from_f64(0.75)).sin();
    let (a, mut b) = (
        ((p2.b / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
        (x * x + S::from_f64(0.25)).sqrt(),
    );
    let _guard3 = Guard::set(0.75);
    p2.turn(((-(S::from_f64(draw()))) * S::from_f64(0.75)).sin());
    p2 = p2.tamed();
    let e = if (S::from_f64(-0.875_f64) * S::from_f64(-1.125_f64)).cos().cmpgt((r1[3] + a)) {
        (e + (f - x))
    } else {
        ((S::from_f64(-0.625_f64) + x) - S::from_f64(0.125_f64)).tanh()
    };
    let f = List(vec![
        ((y * y + S::from_f64(0.25)).sqrt() * S::from_f64(0.75)).sin(),
        r1[0],
        ((-(r1[4])) + S::from_f64(0.125)).tanh(),
    ])
    .folded(((b + e) + S::from_f64(0.125)).tanh(), |s, v| (s * v + (r1[4] * x)).sin());
    let mut t4 = ((p2.a * S::from_f64(-0.375_f64)).max(r1[2]) + S::from_f64(0.125)).tanh();
    let mut add5 = |v: S| {
        t4 = (t4 * v + S::from_f64(scale())).sin();
        t4.cmpgt(S::from_f64(0.25))
    };
    let b = if add5(b) || !add5((e * S::from_f64(0.375_f64)).max(S::from_f64(-0.125_f64))) {
        S::from_f64(-0.875_f64)
    } else {
        (r1[4] + S::from_f64(-0.875_f64)).sin()
    };
    let a = match shape(
        ((t4 + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ((S::from_f64(-0.375_f64) + r1[2]) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (a * e),
        Shape::Disc(v) => {
            ((S::from_f64(scale()) - S::from_f64(-0.625_f64)).tanh() + S::from_f64(0.375_f64)).sin()
        }
        Shape::Box { w: v, h } => ((r1[2] * r1[2] + S::from_f64(0.25)).sqrt() * (v + t4)),
    };
    let by6 = ((r1[4] * r1[4]) * S::from_f64(0.75)).sin();
    let m7 = &mut r1;
    if raises(m7) && !raises(m7) {
        m7[0] = by6 * m7[1];
    }
    let k8: usize = raised(m7);
    let a = if k8 % 2 == 0 {
        (x * S::from_f64(-1.125_f64)).abs()
    } else {
        (f * (r1[(k8 * k8 + 1) % 5] * S::from_f64(0.125_f64)).max(r1[(k8 * k8 + 1) % 5]))
    };
    ((b * S::from_f64(-0.625_f64)).abs()
        / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
        + a
        + t4
        + b
        + f
        + e
        + y
        + x
}

#[differentiable]
fn program_45(x: f64, y: f64) -> f64 {
    let mut a = ((x * -0.625_f64).cos() + 0.125).tanh();
    let mut r1 = [
        ((-(a)) * 0.75).sin(),
        ((a * x) * 0.75).sin(),
        ((y * 0.375_f64) + 0.125).tanh(),
        (a * 0.75).sin(),
    ];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((x * 0.125_f64).cos() * 0.75).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    let b = if let Some(v) = root((scale() + r1[1])) {
        (a + (0.125_f64 * -0.625_f64).cos())
    } else {
        (x + 0.875_f64).sin()
    };
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((r1[0] * 0.375_f64).cos() * 0.625_f64).cos();
        if n4 > 2 || 0.125_f64 > a {
            z3 = b;
            break;
        }
    }
    a *= (((f * 0.375_f64) * 0.375_f64).max(r1[3]) + 0.125).tanh();
    let mut d = ((r1[2] - 0.625_f64).tanh() + 0.125).tanh();
    for v in r1.iter() {
        d = d * ((x + r1[0]) + 0.125).tanh() + *v * ((x + r1[0]) + 0.125).tanh();
    }
    let mut p5 =
        Pair { a: ((f - r1[3]) + 0.125).tanh(), b: ((d * -0.875_f64).max(z3) * 0.75).sin() };
    p5 += Pair {
        a: ((y * 0.875_f64).max(x) + 0.125).tanh(),
        b: ((r1[2] / (1.5 + z3 * z3)) * 0.75).sin(),
    };
    p5 = p5.tamed();
    d = ((-(y)) + 0.125).tanh();
    p5 += p5;
    p5 = p5.tamed();
    let mut n7 = 0_usize;
    'l6: while n7 < 4 {
        n7 += 1;
        let c = match n7 % 4 {
            two => (f * -0.625_f64).abs(),
            k if k > two => (d * -0.875_f64).max(p5.b),
            _ => (b * r1[(n7 * n7 + 1) % 4]),
        };
    }
    if (r1[2] - -0.875_f64).tanh() >= (r1[2] - 0.875_f64).tanh() {
        let r8 = [
            ((y * y + 0.25).sqrt() + 0.125).tanh(),
            ((r1[2] + draw()) * 0.75).sin(),
            ((d * -0.875_f64).max(y) * 0.75).sin(),
            (z3 * 0.75).sin(),
        ];
        for v in r1.iter() {
            a = a * ((r8[1] * a) + 0.125).tanh() + *v * ((r8[1] * a) + 0.125).tanh();
        }
        let mut w9 = ((r1[2] * 0.75).sin(), [(draw() * -0.875_f64).cos(); 2]);
        {
            let (p, [q, _]) = &mut w9;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let e = (w9.0 + w9.1[0] * w9.1[1]).tanh();
    } else {
        let d = left::curved((d - 0.875_f64).tanh())
            * right::curved(((scale() - p5.b) * 0.75).sin())
            - curved((d - 0.875_f64).tanh());
        p5.b = ((r1[1] + r1[2]) * 0.75).sin();
        p5 = p5.tamed();
        p5 =
            (p5 * Pair {
                a: ((r1[0] * y) + 0.125).tanh(),
                b: ((r1[2] / (1.5 + 0.125_f64 * 0.125_f64)) * 0.75).sin(),
            } + p5)
                .tamed();
        p5 = p5.tamed();
    }
    ((a * x) + (a + -0.875_f64).sin()) + d + z3 + b + f + a + y + x
}

fn program_45_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x * S::from_f64(-0.625_f64)).cos() + S::from_f64(0.125)).tanh();
    let mut r1 = [
        ((-(a)) * S::from_f64(0.75)).sin(),
        ((a * x) * S::from_f64(0.75)).sin(),
        ((y * S::from_f64(0.375_f64)) + S::from_f64(0.125)).tanh(),
        (a * S::from_f64(0.75)).sin(),
    ];
    let mut u2: Vec<_> = r1.iter().map(|v| *v * y).collect();
    u2.push(((x * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin());
    u2[0] = u2[1] * u2[u2.len() - 1];
    let f = (mixed(&u2) + u2[0]).tanh();
    let b = if let Some(v) = root((S::from_f64(scale()) + r1[1])) {
        (a + (S::from_f64(0.125_f64) * S::from_f64(-0.625_f64)).cos())
    } else {
        (x + S::from_f64(0.875_f64)).sin()
    };
    let z3;
    let mut n4 = 0_usize;
    loop {
        n4 += 1;
        let t = ((r1[0] * S::from_f64(0.375_f64)).cos() * S::from_f64(0.625_f64)).cos();
        if n4 > 2 || S::from_f64(0.125_f64).cmpgt(a) {
            z3 = b;
            break;
        }
    }
    a = a
        * (((f * S::from_f64(0.375_f64)) * S::from_f64(0.375_f64)).max(r1[3]) + S::from_f64(0.125))
            .tanh();
    let mut d = ((r1[2] - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh();
    for v in r1.iter() {
        d = d * ((x + r1[0]) + S::from_f64(0.125)).tanh()
            + *v * ((x + r1[0]) + S::from_f64(0.125)).tanh();
    }
    let mut p5 = Pair {
        a: ((f - r1[3]) + S::from_f64(0.125)).tanh(),
        b: ((d * S::from_f64(-0.875_f64)).max(z3) * S::from_f64(0.75)).sin(),
    };
    p5 += Pair {
        a: ((y * S::from_f64(0.875_f64)).max(x) + S::from_f64(0.125)).tanh(),
        b: ((r1[2] / (S::from_f64(1.5) + z3 * z3)) * S::from_f64(0.75)).sin(),
    };
    p5 = p5.tamed();
    d = ((-(y)) + S::from_f64(0.125)).tanh();
    p5 += p5;
    p5 = p5.tamed();
    let mut n7 = 0_usize;
    'l6: while n7 < 4 {
        n7 += 1;
        let c = match n7 % 4 {
            two => (f * S::from_f64(-0.625_f64)).abs(),
            k if k > two => (d * S::from_f64(-0.875_f64)).max(p5.b),
            _ => (b * r1[(n7 * n7 + 1) % 4]),
        };
    }
    if (r1[2] - S::from_f64(-0.875_f64)).tanh().cmpge((r1[2] - S::from_f64(0.875_f64)).tanh()) {
        let r8 = [
            ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
            ((r1[2] + S::from_f64(draw())) * S::from_f64(0.75)).sin(),
            ((d * S::from_f64(-0.875_f64)).max(y) * S::from_f64(0.75)).sin(),
            (z3 * S::from_f64(0.75)).sin(),
        ];
        for v in r1.iter() {
            a = a * ((r8[1] * a) + S::from_f64(0.125)).tanh()
                + *v * ((r8[1] * a) + S::from_f64(0.125)).tanh();
        }
        let mut w9 = (
            (r1[2] * S::from_f64(0.75)).sin(),
            [(S::from_f64(draw()) * S::from_f64(-0.875_f64)).cos(); 2],
        );
        {
            let (p, [q, _]) = &mut w9;
            *p = (*p * *q).sin();
            *q = *q * *p + *q;
        }
        let e = (w9.0 + w9.1[0] * w9.1[1]).tanh();
    } else {
        let d = left::curved((d - S::from_f64(0.875_f64)).tanh())
            * right::curved(((S::from_f64(scale()) - p5.b) * S::from_f64(0.75)).sin())
            - curved((d - S::from_f64(0.875_f64)).tanh());
        p5.b = ((r1[1] + r1[2]) * S::from_f64(0.75)).sin();
        p5 = p5.tamed();
        p5 =
            (p5 * Pair {
                a: ((r1[0] * y) + S::from_f64(0.125)).tanh(),
                b: ((r1[2] / (S::from_f64(1.5) + S::from_f64(0.125_f64) * S::from_f64(0.125_f64)))
                    * S::from_f64(0.75))
                .sin(),
            } + p5)
                .tamed();
        p5 = p5.tamed();
    }
    ((a * x) + (a + S::from_f64(-0.875_f64)).sin()) + d + z3 + b + f + a + y + x
}

#[differentiable]
fn program_46(x: f64, y: f64) -> f64 {
    let mut a = ((scale() - y) + 0.125).tanh();
    let mut r1 = [((a * a) * 0.75).sin(), ((y + x) + 0.125).tanh()];
    let p2 = Pair {
        a: (draw() - -0.625_f64).tanh(),
        b: ((scale() * -0.875_f64).max(draw()) * 0.75).sin(),
    };
    let d = (<Pair<f64> as Soft>::pressed(&p2) + Hard::pressed(&p2) * p2.pressed()).tamed().a;
    let mut p3 = Pair { a: ((r1[0] * d) + 0.125).tanh(), b: ((x * -1.125_f64).abs() * 0.75).sin() };
    #[differentiable(checkpoint)]
    'l4: for i5 in 0..=3_usize {
        let p6 = Pair {
            a: (r1[(i5 * i5 + 1) % 2] * -0.875_f64).abs(),
            b: ((-0.375_f64 * -0.375_f64).cos() * 0.75).sin(),
        };
        let b = (<Pair<f64> as Soft>::pressed(&p6) + Hard::pressed(&p6) * p6.pressed()).tamed().a;
        if (-((i5 as f64) * 0.25)) <= (0.125_f64 + b) {
            for k7 in 0..raised(&mut r1) % 2 {
                r1[k7] = ((-0.375_f64 * -0.625_f64).max(((i5 as f64) * 0.25)) + 0.125).tanh();
            }
            'l8: for i9 in (i5..4_usize).rev() {
                let b = r1[(i9 + 0) % 2];
                p3.b = ((a - a) * 0.75).sin();
                p3 = p3.tamed();
                a -= (((r1[1] * r1[1] + 0.25).sqrt() - 0.125_f64).tanh() + 0.125).tanh();
            }
        }
    }
    let by10 = ((x * 0.875_f64).max(r1[1]) * 0.75).sin();
    let m11 = &mut r1;
    if raises(m11) && !raises(m11) {
        m11[0] = by10 * m11[1];
    }
    let k12: usize = raised(m11);
    p3.b = ((p3.b / (1.5 + ((k12 as f64) * 0.25) * ((k12 as f64) * 0.25))) + 0.125).tanh();
    p3 = p3.tamed();
    p3.turn(((p3.b / (1.5 + d * d)) * 0.75).sin());
    p3 = p3.tamed();
    let c = root((-(r1[0])))
        .map_or((d * -1.125_f64).abs(), |v| ((r1[(k12 * k12 + 1) % 2] - x) * 0.875_f64).abs());
    ((draw() * draw()) * (draw() * draw()) + 0.25).sqrt() + c + d + a + y + x
}

fn program_46_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(scale()) - y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((a * a) * S::from_f64(0.75)).sin(), ((y + x) + S::from_f64(0.125)).tanh()];
    let p2 = Pair {
        a: (S::from_f64(draw()) - S::from_f64(-0.625_f64)).tanh(),
        b: ((S::from_f64(scale()) * S::from_f64(-0.875_f64)).max(S::from_f64(draw()))
            * S::from_f64(0.75))
        .sin(),
    };
    let d = (<Pair<S> as Soft>::pressed(&p2) + Hard::pressed(&p2) * p2.pressed()).tamed().a;
    let mut p3 = Pair {
        a: ((r1[0] * d) + S::from_f64(0.125)).tanh(),
        b: ((x * S::from_f64(-1.125_f64)).abs() * S::from_f64(0.75)).sin(),
    };

    'l4: for i5 in 0..=3_usize {
        let p6 = Pair {
            a: (r1[(i5 * i5 + 1) % 2] * S::from_f64(-0.875_f64)).abs(),
            b: ((S::from_f64(-0.375_f64) * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75))
                .sin(),
        };
        let b = (<Pair<S> as Soft>::pressed(&p6) + Hard::pressed(&p6) * p6.pressed()).tamed().a;
        if (-(S::from_f64(i5 as f64) * S::from_f64(0.25))).cmple((S::from_f64(0.125_f64) + b)) {
            for k7 in 0..raised(&mut r1) % 2 {
                r1[k7] = ((S::from_f64(-0.375_f64) * S::from_f64(-0.625_f64))
                    .max((S::from_f64(i5 as f64) * S::from_f64(0.25)))
                    + S::from_f64(0.125))
                .tanh();
            }
            'l8: for i9 in (i5..4_usize).rev() {
                let b = r1[(i9 + 0) % 2];
                p3.b = ((a - a) * S::from_f64(0.75)).sin();
                p3 = p3.tamed();
                a = a
                    - (((r1[1] * r1[1] + S::from_f64(0.25)).sqrt() - S::from_f64(0.125_f64))
                        .tanh()
                        + S::from_f64(0.125))
                    .tanh();
            }
        }
    }
    let by10 = ((x * S::from_f64(0.875_f64)).max(r1[1]) * S::from_f64(0.75)).sin();
    let m11 = &mut r1;
    if raises(m11) && !raises(m11) {
        m11[0] = by10 * m11[1];
    }
    let k12: usize = raised(m11);
    p3.b = ((p3.b
        / (S::from_f64(1.5)
            + (S::from_f64(k12 as f64) * S::from_f64(0.25))
                * (S::from_f64(k12 as f64) * S::from_f64(0.25))))
        + S::from_f64(0.125))
    .tanh();
    p3 = p3.tamed();
    p3.turn(((p3.b / (S::from_f64(1.5) + d * d)) * S::from_f64(0.75)).sin());
    p3 = p3.tamed();
    let c = root((-(r1[0]))).map_or((d * S::from_f64(-1.125_f64)).abs(), |v| {
        ((r1[(k12 * k12 + 1) % 2] - x) * S::from_f64(0.875_f64)).abs()
    });
    ((S::from_f64(draw()) * S::from_f64(draw())) * (S::from_f64(draw()) * S::from_f64(draw()))
        + S::from_f64(0.25))
    .sqrt()
        + c
        + d
        + a
        + y
        + x
}

#[differentiable]
fn program_47(x: f64, y: f64) -> f64 {
    let mut b = (x * 0.75).sin();
    let r1 = [
        (b * 0.75).sin(),
        ((-(y)) + 0.125).tanh(),
        ((x - x) + 0.125).tanh(),
        ((b + x) + 0.125).tanh(),
    ];
    b += (((x * b) - (y * r1[2])) + 0.125).tanh();
    b += (((scale() - r1[2]) * (scale() - r1[2]) + 0.25).sqrt() + 0.125).tanh();
    let b: f64 = r1.iter().map(|v| v * ((y / (1.5 + x * x)) * 0.75).sin()).sum();
    let e = match roots((y - 0.625_f64).tanh(), (x * b)) {
        Ok(v) => ((-0.125_f64 * y) * scale()),
        Err(true) => r1[0],
        Err(_) => (r1[1] * r1[0]),
    };
    'l2: for i3 in 0..=3_usize {
        let g4 = |t: f64| scale() * t;
        let c = (g4((scale() + b)) + g4((-(r1[3])))).sin();
    }
    let f = match roots((x + 0.625_f64).sin(), (b - scale())) {
        Ok(v) => {
            ((draw() / (1.5 + -1.125_f64 * -1.125_f64)) * (0.375_f64 * 0.375_f64 + 0.25).sqrt())
        }
        Err(true) => e,
        Err(_) => (r1[1] / (1.5 + -0.875_f64 * -0.875_f64)),
    };
    let c = ((scale() + y) - (r1[0] * r1[0]));
    let mut r5 = [((-(f)) + 0.125).tanh(); 5];
    let mut p6 = Pair { a: ((r5[2] + e) + 0.125).tanh(), b: (draw() + 0.125).tanh() };
    let f = match shape(
        ((f + 0.625_f64).sin() + 0.125).tanh(),
        ((-0.625_f64 - -1.125_f64).tanh() + 0.125).tanh(),
    ) {
        Shape::Point => (scale() * -0.625_f64).max(c),
        Shape::Disc(v) => ((r5[1] * r5[0]) + 0.625_f64).sin(),
        Shape::Box { w: v, h } => (r1[2] - r1[0]),
    };
    if (f * c) > p6.a {
        if (c * c + 0.25).sqrt() > (r5[0] + 0.375_f64).sin() {
            return ((c - r5[1]) * 0.875_f64).abs();
        }
        let f = List(vec![
            ((e * r5[3]) + 0.125).tanh(),
            (x - r1[2]),
            ((r5[4] * r5[4] + 0.25).sqrt() + 0.125).tanh(),
        ])
        .folded(((p6.a * -0.125_f64).abs() * 0.75).sin(), |s, v| {
            (s * v + (0.625_f64 * 0.875_f64).max(p6.a)).sin()
        });
        let c = -0.125_f64;
    }
    ((b * -0.125_f64).abs() / (1.5 + (draw() * x) * (draw() * x))) + f + c + e + b + y + x
}

fn program_47_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (x * S::from_f64(0.75)).sin();
    let r1 = [
        (b * S::from_f64(0.75)).sin(),
        ((-(y)) + S::from_f64(0.125)).tanh(),
        ((x - x) + S::from_f64(0.125)).tanh(),
        ((b + x) + S::from_f64(0.125)).tanh(),
    ];
    b = b + (((x * b) - (y * r1[2])) + S::from_f64(0.125)).tanh();
    b = b
        + (((S::from_f64(scale()) - r1[2]) * (S::from_f64(scale()) - r1[2]) + S::from_f64(0.25))
            .sqrt()
            + S::from_f64(0.125))
        .tanh();
    let b = r1.iter().fold(S::from_f64(-0.0), |s, v| {
        s + *v * ((y / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin()
    });
    let e = match roots((y - S::from_f64(0.625_f64)).tanh(), (x * b)) {
        Ok(v) => ((S::from_f64(-0.125_f64) * y) * S::from_f64(scale())),
        Err(true) => r1[0],
        Err(_) => (r1[1] * r1[0]),
    };
    'l2: for i3 in 0..=3_usize {
        let g4 = |t: S| S::from_f64(scale()) * t;
        let c = (g4((S::from_f64(scale()) + b)) + g4((-(r1[3])))).sin();
    }
    let f = match roots((x + S::from_f64(0.625_f64)).sin(), (b - S::from_f64(scale()))) {
        Ok(v) => {
            ((S::from_f64(draw())
                / (S::from_f64(1.5) + S::from_f64(-1.125_f64) * S::from_f64(-1.125_f64)))
                * (S::from_f64(0.375_f64) * S::from_f64(0.375_f64) + S::from_f64(0.25)).sqrt())
        }
        Err(true) => e,
        Err(_) => (r1[1] / (S::from_f64(1.5) + S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64))),
    };
    let c = ((S::from_f64(scale()) + y) - (r1[0] * r1[0]));
    let mut r5 = [((-(f)) + S::from_f64(0.125)).tanh(); 5];
    let mut p6 = Pair {
        a: ((r5[2] + e) + S::from_f64(0.125)).tanh(),
        b: (S::from_f64(draw()) + S::from_f64(0.125)).tanh(),
    };
    let f = match shape(
        ((f + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((S::from_f64(-0.625_f64) - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
    ) {
        Shape::Point => (S::from_f64(scale()) * S::from_f64(-0.625_f64)).max(c),
        Shape::Disc(v) => ((r5[1] * r5[0]) + S::from_f64(0.625_f64)).sin(),
        Shape::Box { w: v, h } => (r1[2] - r1[0]),
    };
    if (f * c).cmpgt(p6.a) {
        if (c * c + S::from_f64(0.25)).sqrt().cmpgt((r5[0] + S::from_f64(0.375_f64)).sin()) {
            return ((c - r5[1]) * S::from_f64(0.875_f64)).abs();
        }
        let f = List(vec![
            ((e * r5[3]) + S::from_f64(0.125)).tanh(),
            (x - r1[2]),
            ((r5[4] * r5[4] + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh(),
        ])
        .folded(((p6.a * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(), |s, v| {
            (s * v + (S::from_f64(0.625_f64) * S::from_f64(0.875_f64)).max(p6.a)).sin()
        });
        let c = S::from_f64(-0.125_f64);
    }
    ((b * S::from_f64(-0.125_f64)).abs()
        / (S::from_f64(1.5) + (S::from_f64(draw()) * x) * (S::from_f64(draw()) * x)))
        + f
        + c
        + e
        + b
        + y
        + x
}

of_parts!(#[differentiable] program_48 (t, a: f64) f64::from, draw() + (t / (1.5 + a * a)), a + (scale() * t), scale() - (draw() - -1.125_f64).tanh());
of_parts!(program_48_of<S> (t, a: S) S::from_f64, S::from_f64(draw()) + (t / (S::from_f64(1.5) + a * a)), a + (S::from_f64(scale()) * t), S::from_f64(scale()) - (S::from_f64(draw()) - S::from_f64(-1.125_f64)).tanh());

of_parts!(#[differentiable] program_49 (t, a: f64) f64::from, if (t + t) > (t - a) { t } else { (t * 0.625_f64).max(0.375_f64) }, a + (a * t), if (t * -1.125_f64).cos() <= (t - a) { t } else { t });
of_parts!(program_49_of<S> (t, a: S) S::from_f64, if (t + t).cmpgt((t - a)) { t } else { (t * S::from_f64(0.625_f64)).max(S::from_f64(0.375_f64)) }, a + (a * t), if (t * S::from_f64(-1.125_f64)).cos().cmple((t - a)) { t } else { t });

#[differentiable]
fn program_50(x: f64, y: f64) -> f64 {
    let mut b = ((x * -0.375_f64).abs() * 0.75).sin();
    let r1 = [
        ((y + b) + 0.125).tanh(),
        ((x * -1.125_f64).cos() + 0.125).tanh(),
        ((b * b) + 0.125).tanh(),
    ];
    let mut r2 = [
        ((b * y) * 0.75).sin(),
        ((y - 0.375_f64).tanh() + 0.125).tanh(),
        ((y + 0.625_f64).sin() + 0.125).tanh(),
        (y * 0.75).sin(),
        (r1[0] * 0.75).sin(),
    ];
    let (a, mut b) = (((r2[1] / (1.5 + r1[1] * r1[1])) + 0.125).tanh(), (y * r1[1]));
    let g3 = |t: f64| (-((y * 0.875_f64).abs())) * t;
    let c = (g3(r2[4]) + g3(b)).sin();
    let c = match root((b + r1[1])) {
        Some(v) => ((b - v) - (scale() * scale() + 0.25).sqrt()),
        None => r1[2],
    };
    let mut q4 = [
        Ball { height: (draw() + 0.125).tanh(), speed: ((x + a) + 0.125).tanh() },
        Ball { height: (c + 0.125).tanh(), speed: ((r2[2] * -1.125_f64) * 0.75).sin() },
    ];
    let up5 = q4[1].bounce();
    let d = if up5 { q4[1].run(2) } else { (a + c) };
    let d = q4[0].height * q4[1].speed - q4[0].speed;
    let g6 = |t: f64| (a * 0.125_f64).cos() * t;
    let d = (g6((c + 0.875_f64).sin()) + g6(y)).sin();
    let mut p7 = Pair {
        a: ((r1[2] / (1.5 + r2[0] * r2[0])) + 0.125).tanh(),
        b: ((-0.875_f64 + -0.125_f64) + 0.125).tanh(),
    };
    p7.b = ((r1[0] * -0.625_f64) + 0.125).tanh();
    p7 = p7.tamed();
    r2[2] -= ((d * d + 0.25).sqrt() + 0.125).tanh();
    if a < -1.125_f64 {
        let mut u8 = r1.to_vec();
        u8.push((y + 0.125).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let e = (mixed(&u8) + u8[0]).tanh();
        let mut p9 = Pair { a: ((x + y) * 0.75).sin(), b: ((c * r2[3]) + 0.125).tanh() };
        let (a, mut b) = ((c * 0.75).sin(), (r1[0] * r2[0]));
    }
    let mut l10 = List(vec![
        ((-(p7.a)) * 0.75).sin(),
        (y + -0.125_f64).sin(),
        ((r1[2] / (1.5 + scale() * scale())) + 0.125).tanh(),
    ]);
    for i11 in 0..4_usize {
        l10 += &List(vec![(d * 0.75).sin(), (a * -1.125_f64).abs(), ((y - c) + 0.125).tanh()]);
        if (x * -0.625_f64).abs() < (r2[0] - y) {
            continue;
        }
        l10 = l10
            + List(vec![(d * 0.75).sin(), (a * -1.125_f64).abs(), ((y - c) + 0.125).tanh()])
                * ((r1[1] / (1.5 + b * b)) * 0.75).sin();
    }
    let e = l10.total();
    ((y * 0.375_f64).cos() * 0.625_f64).abs() + e + d + c + b + a + y + x
}

fn program_50_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * S::from_f64(-0.375_f64)).abs() * S::from_f64(0.75)).sin();
    let r1 = [
        ((y + b) + S::from_f64(0.125)).tanh(),
        ((x * S::from_f64(-1.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        ((b * b) + S::from_f64(0.125)).tanh(),
    ];
    let mut r2 = [
        ((b * y) * S::from_f64(0.75)).sin(),
        ((y - S::from_f64(0.375_f64)).tanh() + S::from_f64(0.125)).tanh(),
        ((y + S::from_f64(0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        (y * S::from_f64(0.75)).sin(),
        (r1[0] * S::from_f64(0.75)).sin(),
    ];
    let (a, mut b) =
        (((r2[1] / (S::from_f64(1.5) + r1[1] * r1[1])) + S::from_f64(0.125)).tanh(), (y * r1[1]));
    let g3 = |t: S| (-((y * S::from_f64(0.875_f64)).abs())) * t;
    let c = (g3(r2[4]) + g3(b)).sin();
    let c = match root((b + r1[1])) {
        Some(v) => {
            ((b - v) - (S::from_f64(scale()) * S::from_f64(scale()) + S::from_f64(0.25)).sqrt())
        }
        None => r1[2],
    };
    let mut q4 = [
        Ball {
            height: (S::from_f64(draw()) + S::from_f64(0.125)).tanh(),
            speed: ((x + a) + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: (c + S::from_f64(0.125)).tanh(),
            speed: ((r2[2] * S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin(),
        },
    ];
    let up5 = q4[1].bounce();
    let d = if up5 { q4[1].run(2) } else { (a + c) };
    let d = q4[0].height * q4[1].speed - q4[0].speed;
    let g6 = |t: S| (a * S::from_f64(0.125_f64)).cos() * t;
    let d = (g6((c + S::from_f64(0.875_f64)).sin()) + g6(y)).sin();
    let mut p7 = Pair {
        a: ((r1[2] / (S::from_f64(1.5) + r2[0] * r2[0])) + S::from_f64(0.125)).tanh(),
        b: ((S::from_f64(-0.875_f64) + S::from_f64(-0.125_f64)) + S::from_f64(0.125)).tanh(),
    };
    p7.b = ((r1[0] * S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh();
    p7 = p7.tamed();
    r2[2] = r2[2] - ((d * d + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    if a.cmplt(S::from_f64(-1.125_f64)) {
        let mut u8 = r1.to_vec();
        u8.push((y + S::from_f64(0.125)).tanh());
        u8[0] = u8[1] * u8[u8.len() - 1];
        let e = (mixed(&u8) + u8[0]).tanh();
        let mut p9 = Pair {
            a: ((x + y) * S::from_f64(0.75)).sin(),
            b: ((c * r2[3]) + S::from_f64(0.125)).tanh(),
        };
        let (a, mut b) = ((c * S::from_f64(0.75)).sin(), (r1[0] * r2[0]));
    }
    let mut l10 = List(vec![
        ((-(p7.a)) * S::from_f64(0.75)).sin(),
        (y + S::from_f64(-0.125_f64)).sin(),
        ((r1[2] / (S::from_f64(1.5) + S::from_f64(scale()) * S::from_f64(scale())))
            + S::from_f64(0.125))
        .tanh(),
    ]);
    for i11 in 0..4_usize {
        l10 += &List(vec![
            (d * S::from_f64(0.75)).sin(),
            (a * S::from_f64(-1.125_f64)).abs(),
            ((y - c) + S::from_f64(0.125)).tanh(),
        ]);
        if (x * S::from_f64(-0.625_f64)).abs().cmplt((r2[0] - y)) {
            continue;
        }
        l10 = l10
            + List(vec![
                (d * S::from_f64(0.75)).sin(),
                (a * S::from_f64(-1.125_f64)).abs(),
                ((y - c) + S::from_f64(0.125)).tanh(),
            ]) * ((r1[1] / (S::from_f64(1.5) + b * b)) * S::from_f64(0.75)).sin();
    }
    let e = l10.total();
    ((y * S::from_f64(0.375_f64)).cos() * S::from_f64(0.625_f64)).abs() + e + d + c + b + a + y + x
}

#[differentiable]
fn program_51(x: f64, y: f64) -> f64 {
    let mut b = ((x * x) * 0.75).sin();
    let mut r1 = [((x / (1.5 + y * y)) + 0.125).tanh(); 5];
    b += (r1[4] + 0.125).tanh();
    let a = match shape(((0.875_f64 * r1[1]) * 0.75).sin(), ((y + 0.125_f64).sin() * 0.75).sin()) {
        Point => (r1[4] + -0.375_f64).sin(),
        Disc(v) => ((b + b) * (r1[0] + x)),
        Shape::Box { w: v, h } => ((r1[4] * r1[4] + 0.25).sqrt() * (h + -0.625_f64).sin()),
    };
    let k2 = (scale() + x);
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    b += (((r1[3] * x) - (scale() * scale() + 0.25).sqrt()) + 0.125).tanh();
    let mut p3 = Pair {
        a: ((a - 0.125_f64).tanh() * 0.75).sin(),
        b: ((draw() * -0.125_f64).cos() + 0.125).tanh(),
    };
    let k4: usize = raised(&mut r1) % 5;
    let d = summed(
        |t: f64| {
            (((r1[(k4 * k4 + 1) % 5] - 0.125_f64).tanh() / (1.5 + (t + b) * (t + b))) * t).sin()
        },
        (b + 0.125).tanh(),
        0,
    )
    .tanh();
    'l5: for i6 in k4..=3_usize {
        let c = summed(
            |t: f64| {
                (((r1[i6 % 5] - ((k4 as f64) * 0.25)) * -0.875_f64).max(((i6 as f64) * 0.25)) * t)
                    .sin()
            },
            ((draw() + 0.875_f64).sin() * 0.75).sin(),
            0,
        )
        .tanh();
        let a = match root((p3.a * r1[k4 % 5])) {
            Some(v) => ((d / (1.5 + b * b)) * (d / (1.5 + c * c))),
            None => a,
        };
    }
    r1[0] += (((y * y + 0.25).sqrt() * (a * r1[(k4 * k4 + 1) % 5])) + 0.125).tanh();
    'l7: for i8 in (1..4_usize).rev() {
        let e = match shape(
            ((y * -0.375_f64).max(draw()) * 0.75).sin(),
            ((b * -0.875_f64).max(r1[(k4 * k4 + 1) % 5]) * 0.75).sin(),
        ) {
            Point => p3.b,
            Disc(v) => ((x + p3.a) * (x + b)),
            Shape::Box { w: v, h } => ((-(r1[(i8 * i8 + 1) % 5])) + (a - 0.125_f64).tanh()),
        };
        if i8 % 2 == 0 {
            p3 = (p3 + p3) * ((p3.b * 0.125_f64).max(((k4 as f64) * 0.25)) + 0.125).tanh();
            p3 = p3.tamed();
        } else {
            let mut d = ((((k4 as f64) * 0.25) * r1[k4 % 5]) * 0.75).sin();
        }
    }
    d + d + a + b + y + x
}

fn program_51_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = ((x * x) * S::from_f64(0.75)).sin();
    let mut r1 = [((x / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh(); 5];
    b = b + (r1[4] + S::from_f64(0.125)).tanh();
    let a = match shape(
        ((S::from_f64(0.875_f64) * r1[1]) * S::from_f64(0.75)).sin(),
        ((y + S::from_f64(0.125_f64)).sin() * S::from_f64(0.75)).sin(),
    ) {
        Point => (r1[4] + S::from_f64(-0.375_f64)).sin(),
        Disc(v) => ((b + b) * (r1[0] + x)),
        Shape::Box { w: v, h } => {
            ((r1[4] * r1[4] + S::from_f64(0.25)).sqrt() * (h + S::from_f64(-0.625_f64)).sin())
        }
    };
    let k2 = (S::from_f64(scale()) + x);
    for part in r1.chunks_mut(2) {
        part[0] = (part[0] * k2).sin();
        part.reverse();
    }
    b = b
        + (((r1[3] * x)
            - (S::from_f64(scale()) * S::from_f64(scale()) + S::from_f64(0.25)).sqrt())
            + S::from_f64(0.125))
        .tanh();
    let mut p3 = Pair {
        a: ((a - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(draw()) * S::from_f64(-0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
    };
    let k4: usize = raised(&mut r1) % 5;
    let d = summed(
        |t: S| {
            (((r1[(k4 * k4 + 1) % 5] - S::from_f64(0.125_f64)).tanh()
                / (S::from_f64(1.5) + (t + b) * (t + b)))
                * t)
                .sin()
        },
        (b + S::from_f64(0.125)).tanh(),
        0,
    )
    .tanh();
    'l5: for i6 in k4..=3_usize {
        let c = summed(
            |t: S| {
                (((r1[i6 % 5] - (S::from_f64(k4 as f64) * S::from_f64(0.25)))
                    * S::from_f64(-0.875_f64))
                .max((S::from_f64(i6 as f64) * S::from_f64(0.25)))
                    * t)
                    .sin()
            },
            ((S::from_f64(draw()) + S::from_f64(0.875_f64)).sin() * S::from_f64(0.75)).sin(),
            0,
        )
        .tanh();
        let a = match root((p3.a * r1[k4 % 5])) {
            Some(v) => ((d / (S::from_f64(1.5) + b * b)) * (d / (S::from_f64(1.5) + c * c))),
            None => a,
        };
    }
    r1[0] = r1[0]
        + (((y * y + S::from_f64(0.25)).sqrt() * (a * r1[(k4 * k4 + 1) % 5])) + S::from_f64(0.125))
            .tanh();
    'l7: for i8 in (1..4_usize).rev() {
        let e = match shape(
            ((y * S::from_f64(-0.375_f64)).max(S::from_f64(draw())) * S::from_f64(0.75)).sin(),
            ((b * S::from_f64(-0.875_f64)).max(r1[(k4 * k4 + 1) % 5]) * S::from_f64(0.75)).sin(),
        ) {
            Point => p3.b,
            Disc(v) => ((x + p3.a) * (x + b)),
            Shape::Box { w: v, h } => {
                ((-(r1[(i8 * i8 + 1) % 5])) + (a - S::from_f64(0.125_f64)).tanh())
            }
        };
        if i8 % 2 == 0 {
            p3 = (p3 + p3)
                * ((p3.b * S::from_f64(0.125_f64))
                    .max((S::from_f64(k4 as f64) * S::from_f64(0.25)))
                    + S::from_f64(0.125))
                .tanh();
            p3 = p3.tamed();
        } else {
            let mut d = (((S::from_f64(k4 as f64) * S::from_f64(0.25)) * r1[k4 % 5])
                * S::from_f64(0.75))
            .sin();
        }
    }
    d + d + a + b + y + x
}

#[differentiable]
fn program_52(x: f64, y: f64) -> f64 {
    let mut b = (x * 0.75).sin();
    let r1 = [((y * b) + 0.125).tanh(); 2];
    let z2;
    if (b * -1.125_f64).cos() > (y * y + 0.25).sqrt() {
        let t = ((x * x + 0.25).sqrt() * -0.875_f64).cos();
        z2 = ((x + r1[0]) * (t - r1[1]));
    } else if (b * -1.125_f64).max(y) < (y * -0.375_f64).abs() {
        z2 = bent((r1[0] * r1[0] + 0.25).sqrt());
    } else {
        z2 = ((x * x + 0.25).sqrt() * -0.875_f64).cos();
    }
    let mut p3 = Pair { a: ((y * scale()) + 0.125).tanh(), b: ((-(r1[1])) + 0.125).tanh() };
    let b = (y * (z2 * 0.875_f64));
    let mut r4 = [((z2 - r1[1]) + 0.125).tanh(); 2];
    let d = match roots((x * -0.125_f64).max(r1[0]), (b / (1.5 + p3.a * p3.a))) {
        Ok(v) => ((draw() - draw()) - b),
        Err(true) => r4[0],
        Err(_) => (scale() - -0.875_f64).tanh(),
    };
    'l5: for i6 in 1..3_usize {
        let f = match roots((r4[0] * b), (d * 0.125_f64).abs()) {
            Ok(v) => ((x - p3.a) * -0.625_f64).abs(),
            Err(true) => x,
            Err(_) => (r1[i6 % 2] * -0.875_f64),
        };
    }
    let d = mixed(&r4[..2]).sin();
    let g7 = |t: f64, v: &[f64]| mixed(v) * t + ((r4[0] + 0.375_f64).sin() + (-(b))).tanh();
    let e = folded(&g7, ((-(x)) + 0.125).tanh(), &r1).sin();
    let b = root((r1[1] * -0.625_f64).max(r4[0]))
        .map_or((e - 0.625_f64).tanh(), |v| ((r4[0] * 0.125_f64).max(r1[0]) * -0.625_f64).abs());
    p3 = (p3 * p3
        + Pair {
            a: ((-0.875_f64 * 0.875_f64).max(d) * 0.75).sin(),
            b: ((e + -0.875_f64).sin() + 0.125).tanh(),
        })
    .tamed();
    p3 = p3.tamed();
    let a = left::curved(e) * right::curved(((r4[0] + r1[0]) * 0.75).sin()) - curved(e);
    #[differentiable(checkpoint)]
    'l8: for i9 in (0..4_usize).step_by(2) {
        let mut f = ((z2 * 0.375_f64).abs() + 0.125).tanh();
    }
    ((e + r4[0]) * 0.625_f64).abs() + a + b + e + d + z2 + y + x
}

fn program_52_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut b = (x * S::from_f64(0.75)).sin();
    let r1 = [((y * b) + S::from_f64(0.125)).tanh(); 2];
    let z2;
    if (b * S::from_f64(-1.125_f64)).cos().cmpgt((y * y + S::from_f64(0.25)).sqrt()) {
        let t = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.875_f64)).cos();
        z2 = ((x + r1[0]) * (t - r1[1]));
    } else if (b * S::from_f64(-1.125_f64)).max(y).cmplt((y * S::from_f64(-0.375_f64)).abs()) {
        z2 = bent((r1[0] * r1[0] + S::from_f64(0.25)).sqrt());
    } else {
        z2 = ((x * x + S::from_f64(0.25)).sqrt() * S::from_f64(-0.875_f64)).cos();
    }
    let mut p3 = Pair {
        a: ((y * S::from_f64(scale())) + S::from_f64(0.125)).tanh(),
        b: ((-(r1[1])) + S::from_f64(0.125)).tanh(),
    };
    let b = (y * (z2 * S::from_f64(0.875_f64)));
    let mut r4 = [((z2 - r1[1]) + S::from_f64(0.125)).tanh(); 2];
    let d = match roots(
        (x * S::from_f64(-0.125_f64)).max(r1[0]),
        (b / (S::from_f64(1.5) + p3.a * p3.a)),
    ) {
        Ok(v) => ((S::from_f64(draw()) - S::from_f64(draw())) - b),
        Err(true) => r4[0],
        Err(_) => (S::from_f64(scale()) - S::from_f64(-0.875_f64)).tanh(),
    };
    'l5: for i6 in 1..3_usize {
        let f = match roots((r4[0] * b), (d * S::from_f64(0.125_f64)).abs()) {
            Ok(v) => ((x - p3.a) * S::from_f64(-0.625_f64)).abs(),
            Err(true) => x,
            Err(_) => (r1[i6 % 2] * S::from_f64(-0.875_f64)),
        };
    }
    let d = mixed(&r4[..2]).sin();
    let g7 =
        |t: S, v: &[S]| mixed(v) * t + ((r4[0] + S::from_f64(0.375_f64)).sin() + (-(b))).tanh();
    let e = folded(&g7, ((-(x)) + S::from_f64(0.125)).tanh(), &r1).sin();
    let b = root((r1[1] * S::from_f64(-0.625_f64)).max(r4[0]))
        .map_or((e - S::from_f64(0.625_f64)).tanh(), |v| {
            ((r4[0] * S::from_f64(0.125_f64)).max(r1[0]) * S::from_f64(-0.625_f64)).abs()
        });
    p3 = (p3 * p3
        + Pair {
            a: ((S::from_f64(-0.875_f64) * S::from_f64(0.875_f64)).max(d) * S::from_f64(0.75))
                .sin(),
            b: ((e + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
        })
    .tamed();
    p3 = p3.tamed();
    let a =
        left::curved(e) * right::curved(((r4[0] + r1[0]) * S::from_f64(0.75)).sin()) - curved(e);

    'l8: for i9 in (0..4_usize).step_by(2) {
        let mut f = ((z2 * S::from_f64(0.375_f64)).abs() + S::from_f64(0.125)).tanh();
    }
    ((e + r4[0]) * S::from_f64(0.625_f64)).abs() + a + b + e + d + z2 + y + x
}

#[differentiable]
fn program_53(x: f64, y: f64) -> f64 {
    let mut f = ((x * x) + 0.125).tanh();
    let mut r1 = [
        (f * 0.75).sin(),
        ((0.125_f64 * -0.625_f64) + 0.125).tanh(),
        ((f / (1.5 + x * x)) * 0.75).sin(),
        ((0.875_f64 + f) * 0.75).sin(),
        ((f - 0.625_f64).tanh() + 0.125).tanh(),
    ];
    r1[0] = (((x - 0.875_f64).tanh() * -0.875_f64).abs() + 0.125).tanh();
    let mut r2 = [
        ((f * -1.125_f64).max(y) * 0.75).sin(),
        ((r1[4] + f) * 0.75).sin(),
        ((f - f) + 0.125).tanh(),
        ((r1[0] + y) + 0.125).tanh(),
    ];
    let f = if (f - r1[1]) < (y * y) {
        ((f - y) * (x * r1[4]))
    } else {
        ((f + -0.625_f64).sin() + (y * y + 0.25).sqrt())
    };
    let mut t3 = ((y * y) + 0.125).tanh();
    let mut add4 = |v: f64| {
        t3 = (t3 * v + x).sin();
        t3 > 0.25
    };
    let b = if add4((draw() / (1.5 + f * f))) || !add4((f * f + 0.25).sqrt()) { r1[4] } else { f };
    r1[2] *= ((r2[3] * 0.125_f64).abs() + 0.125).tanh();
    for v in r1.iter().cycle().take(0) {
        t3 = (t3 + *v).sin();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let mut u7 = r2.to_vec();
        u7.push(((-(y)) * 0.75).sin());
        u7[0] = u7[1] * u7[u7.len() - 1];
        let e = (mixed(&u7) + u7[0]).tanh();
    }
    'l8: for i9 in (2..4_usize).rev() {
        'l10: for i11 in (i9..4_usize).step_by(2) {
            let l12 = List(vec![
                ((b + r2[(i11 + 2) % 4]) + 0.125).tanh(),
                (t3 + f),
                ((b * t3) + 0.125).tanh(),
            ]);
            let m13 = &l12
                * &List(vec![
                    ((r2[1] * x) + 0.125).tanh(),
                    (r1[(i11 + 1) % 5] * -0.375_f64).cos(),
                    ((f * y) * 0.75).sin(),
                ]);
            let b = ((l12.clone() + m13).total()).tanh();
            let c = match roots((f * 0.125_f64).abs(), (-0.875_f64 - r2[1])) {
                Ok(v) => ((r2[2] + r1[(i9 * i9 + 1) % 5]) - -0.875_f64).tanh(),
                Err(true) => ((i11 as f64) * 0.25),
                Err(_) => (b * t3),
            };
        }
        let by14 = ((((i9 as f64) * 0.25) * ((i9 as f64) * 0.25)) + 0.125).tanh();
        let m15 = &mut r2;
        if raises(m15) && !raises(m15) {
            m15[0] = by14 * m15[1];
        }
        let k16: usize = raised(m15);
    }
    let mut p17 =
        Pair { a: ((r1[0] * -0.375_f64).cos() * 0.75).sin(), b: ((draw() * b) + 0.125).tanh() };
    ((p17.a * x) * -0.875_f64).abs() + t3 + b + f + y + x
}

fn program_53_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x * x) + S::from_f64(0.125)).tanh();
    let mut r1 = [
        (f * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.125_f64) * S::from_f64(-0.625_f64)) + S::from_f64(0.125)).tanh(),
        ((f / (S::from_f64(1.5) + x * x)) * S::from_f64(0.75)).sin(),
        ((S::from_f64(0.875_f64) + f) * S::from_f64(0.75)).sin(),
        ((f - S::from_f64(0.625_f64)).tanh() + S::from_f64(0.125)).tanh(),
    ];
    r1[0] = (((x - S::from_f64(0.875_f64)).tanh() * S::from_f64(-0.875_f64)).abs()
        + S::from_f64(0.125))
    .tanh();
    let mut r2 = [
        ((f * S::from_f64(-1.125_f64)).max(y) * S::from_f64(0.75)).sin(),
        ((r1[4] + f) * S::from_f64(0.75)).sin(),
        ((f - f) + S::from_f64(0.125)).tanh(),
        ((r1[0] + y) + S::from_f64(0.125)).tanh(),
    ];
    let f = if (f - r1[1]).cmplt((y * y)) {
        ((f - y) * (x * r1[4]))
    } else {
        ((f + S::from_f64(-0.625_f64)).sin() + (y * y + S::from_f64(0.25)).sqrt())
    };
    let mut t3 = ((y * y) + S::from_f64(0.125)).tanh();
    let mut add4 = |v: S| {
        t3 = (t3 * v + x).sin();
        t3.cmpgt(S::from_f64(0.25))
    };
    let b = if add4((S::from_f64(draw()) / (S::from_f64(1.5) + f * f)))
        || !add4((f * f + S::from_f64(0.25)).sqrt())
    {
        r1[4]
    } else {
        f
    };
    r1[2] = r1[2] * ((r2[3] * S::from_f64(0.125_f64)).abs() + S::from_f64(0.125)).tanh();
    for v in r1.iter().cycle().take(0) {
        t3 = (t3 + *v).sin();
    }
    let mut n6 = 0_usize;
    'l5: while n6 < 4 {
        n6 += 1;
        let mut u7 = r2.to_vec();
        u7.push(((-(y)) * S::from_f64(0.75)).sin());
        u7[0] = u7[1] * u7[u7.len() - 1];
        let e = (mixed(&u7) + u7[0]).tanh();
    }
    'l8: for i9 in (2..4_usize).rev() {
        'l10: for i11 in (i9..4_usize).step_by(2) {
            let l12 = List(vec![
                ((b + r2[(i11 + 2) % 4]) + S::from_f64(0.125)).tanh(),
                (t3 + f),
                ((b * t3) + S::from_f64(0.125)).tanh(),
            ]);
            let m13 = &l12
                * &List(vec![
                    ((r2[1] * x) + S::from_f64(0.125)).tanh(),
                    (r1[(i11 + 1) % 5] * S::from_f64(-0.375_f64)).cos(),
                    ((f * y) * S::from_f64(0.75)).sin(),
                ]);
            let b = ((l12.clone() + m13).total()).tanh();
            let c = match roots(
                (f * S::from_f64(0.125_f64)).abs(),
                (S::from_f64(-0.875_f64) - r2[1]),
            ) {
                Ok(v) => ((r2[2] + r1[(i9 * i9 + 1) % 5]) - S::from_f64(-0.875_f64)).tanh(),
                Err(true) => (S::from_f64(i11 as f64) * S::from_f64(0.25)),
                Err(_) => (b * t3),
            };
        }
        let by14 = (((S::from_f64(i9 as f64) * S::from_f64(0.25))
            * (S::from_f64(i9 as f64) * S::from_f64(0.25)))
            + S::from_f64(0.125))
        .tanh();
        let m15 = &mut r2;
        if raises(m15) && !raises(m15) {
            m15[0] = by14 * m15[1];
        }
        let k16: usize = raised(m15);
    }
    let mut p17 = Pair {
        a: ((r1[0] * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        b: ((S::from_f64(draw()) * b) + S::from_f64(0.125)).tanh(),
    };
    ((p17.a * x) * S::from_f64(-0.875_f64)).abs() + t3 + b + f + y + x
}

#[differentiable]
fn program_54(x: f64, y: f64) -> f64 {
    let mut f = ((x - -0.875_f64).tanh() * 0.75).sin();
    let mut r1 = [((scale() * x) + 0.125).tanh(); 3];
    let b = mixed(&r1).sin();
    let mut p2 = Pair {
        a: ((b / (1.5 + -0.125_f64 * -0.125_f64)) + 0.125).tanh(),
        b: ((x * 0.125_f64).cos() * 0.75).sin(),
    };
    let mut p3 = Pair {
        a: ((-0.625_f64 * -0.625_f64 + 0.25).sqrt() + 0.125).tanh(),
        b: ((scale() * b) + 0.125).tanh(),
    };
    let g4 = |t: f64, v: &[f64]| mixed(v) * t + ((r1[0] - x) - (r1[1] - 0.125_f64).tanh()).tanh();
    let f = folded(&g4, ((-(y)) * 0.75).sin(), &r1).sin();
    let mut q5 = [
        Ball {
            height: ((r1[1] * r1[0]) * 0.75).sin(),
            speed: ((r1[2] / (1.5 + f * f)) * 0.75).sin(),
        },
        Ball {
            height: ((r1[1] + -1.125_f64).sin() * 0.75).sin(),
            speed: ((f - -1.125_f64).tanh() + 0.125).tanh(),
        },
    ];
    let up6 = q5[0].bounce();
    let a = if up6 { q5[1].run(0) } else { (-(r1[2])) };
    let d = q5[0].height * q5[1].speed - q5[0].speed;
    let a = summed(
        |t: f64| ((draw() + (x - r1[0])) * t).sin(),
        ((b / (1.5 + b * b)) + 0.125).tanh(),
        2,
    )
    .tanh();
    if (-(r1[2])) >= (y - x) {
        let c = List(vec![
            ((r1[1] + 0.625_f64).sin() * 0.75).sin(),
            (r1[0] / (1.5 + r1[1] * r1[1])),
            ((b + 0.375_f64).sin() * 0.75).sin(),
        ])
        .folded(((f + scale()) + 0.125).tanh(), |s, v| (s * v + (r1[1] * a)).sin());
        r1[0] *= (((d * 0.875_f64).cos() + 0.875_f64).sin() + 0.125).tanh();
        let c = if raises(&mut r1) {
            (-0.875_f64 * -0.875_f64 + 0.25).sqrt()
        } else {
            (-0.125_f64 * (x - -1.125_f64).tanh())
        };
    } else {
        let mut a = ((y * -0.125_f64).max(y) * 0.75).sin();
        let mut l7 = List(vec![
            ((r1[2] / (1.5 + f * f)) + 0.125).tanh(),
            (r1[0] * 0.875_f64).cos(),
            ((y * -0.625_f64).cos() * 0.75).sin(),
        ]);
        for i8 in 0..1_usize {
            l7 += &List(vec![
                ((d + d) * 0.75).sin(),
                (d + -1.125_f64).sin(),
                ((r1[2] - b) + 0.125).tanh(),
            ]);
            if (r1[1] * r1[1] + 0.25).sqrt() < (scale() * r1[2]) {
                continue;
            }
            l7 = l7
                + List(vec![
                    ((d + d) * 0.75).sin(),
                    (d + -1.125_f64).sin(),
                    ((r1[2] - b) + 0.125).tanh(),
                ]) * ((r1[2] + r1[2]) * 0.75).sin();
        }
        let d = l7.total();
        let by9 = (f * 0.75).sin();
        for v in r1.iter_mut() {
            *v = (*v * by9).sin();
        }
    }
    p2 = (p2 * Pair { a: ((a * -0.375_f64).abs() + 0.125).tanh(), b: (0.875_f64 + 0.125).tanh() }
        + Pair { a: ((r1[1] * r1[0]) * 0.75).sin(), b: (d + 0.125).tanh() })
    .tamed();
    p2 = p2.tamed();
    (0.125_f64 + (b * -0.125_f64).cos()) + a + d + f + b + y + x
}

fn program_54_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut f = ((x - S::from_f64(-0.875_f64)).tanh() * S::from_f64(0.75)).sin();
    let mut r1 = [((S::from_f64(scale()) * x) + S::from_f64(0.125)).tanh(); 3];
    let b = mixed(&r1).sin();
    let mut p2 = Pair {
        a: ((b / (S::from_f64(1.5) + S::from_f64(-0.125_f64) * S::from_f64(-0.125_f64)))
            + S::from_f64(0.125))
        .tanh(),
        b: ((x * S::from_f64(0.125_f64)).cos() * S::from_f64(0.75)).sin(),
    };
    let mut p3 = Pair {
        a: ((S::from_f64(-0.625_f64) * S::from_f64(-0.625_f64) + S::from_f64(0.25)).sqrt()
            + S::from_f64(0.125))
        .tanh(),
        b: ((S::from_f64(scale()) * b) + S::from_f64(0.125)).tanh(),
    };
    let g4 = |t: S, v: &[S]| {
        mixed(v) * t + ((r1[0] - x) - (r1[1] - S::from_f64(0.125_f64)).tanh()).tanh()
    };
    let f = folded(&g4, ((-(y)) * S::from_f64(0.75)).sin(), &r1).sin();
    let mut q5 = [
        Ball {
            height: ((r1[1] * r1[0]) * S::from_f64(0.75)).sin(),
            speed: ((r1[2] / (S::from_f64(1.5) + f * f)) * S::from_f64(0.75)).sin(),
        },
        Ball {
            height: ((r1[1] + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
            speed: ((f - S::from_f64(-1.125_f64)).tanh() + S::from_f64(0.125)).tanh(),
        },
    ];
    let up6 = q5[0].bounce();
    let a = if up6 { q5[1].run(0) } else { (-(r1[2])) };
    let d = q5[0].height * q5[1].speed - q5[0].speed;
    let a = summed(
        |t: S| ((S::from_f64(draw()) + (x - r1[0])) * t).sin(),
        ((b / (S::from_f64(1.5) + b * b)) + S::from_f64(0.125)).tanh(),
        2,
    )
    .tanh();
    if (-(r1[2])).cmpge((y - x)) {
        let c = List(vec![
            ((r1[1] + S::from_f64(0.625_f64)).sin() * S::from_f64(0.75)).sin(),
            (r1[0] / (S::from_f64(1.5) + r1[1] * r1[1])),
            ((b + S::from_f64(0.375_f64)).sin() * S::from_f64(0.75)).sin(),
        ])
        .folded(((f + S::from_f64(scale())) + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (r1[1] * a)).sin()
        });
        r1[0] = r1[0]
            * (((d * S::from_f64(0.875_f64)).cos() + S::from_f64(0.875_f64)).sin()
                + S::from_f64(0.125))
            .tanh();
        let c = if raises(&mut r1) {
            (S::from_f64(-0.875_f64) * S::from_f64(-0.875_f64) + S::from_f64(0.25)).sqrt()
        } else {
            (S::from_f64(-0.125_f64) * (x - S::from_f64(-1.125_f64)).tanh())
        };
    } else {
        let mut a = ((y * S::from_f64(-0.125_f64)).max(y) * S::from_f64(0.75)).sin();
        let mut l7 = List(vec![
            ((r1[2] / (S::from_f64(1.5) + f * f)) + S::from_f64(0.125)).tanh(),
            (r1[0] * S::from_f64(0.875_f64)).cos(),
            ((y * S::from_f64(-0.625_f64)).cos() * S::from_f64(0.75)).sin(),
        ]);
        for i8 in 0..1_usize {
            l7 += &List(vec![
                ((d + d) * S::from_f64(0.75)).sin(),
                (d + S::from_f64(-1.125_f64)).sin(),
                ((r1[2] - b) + S::from_f64(0.125)).tanh(),
            ]);
            if (r1[1] * r1[1] + S::from_f64(0.25)).sqrt().cmplt((S::from_f64(scale()) * r1[2])) {
                continue;
            }
            l7 = l7
                + List(vec![
                    ((d + d) * S::from_f64(0.75)).sin(),
                    (d + S::from_f64(-1.125_f64)).sin(),
                    ((r1[2] - b) + S::from_f64(0.125)).tanh(),
                ]) * ((r1[2] + r1[2]) * S::from_f64(0.75)).sin();
        }
        let d = l7.total();
        let by9 = (f * S::from_f64(0.75)).sin();
        for v in r1.iter_mut() {
            *v = (*v * by9).sin();
        }
    }
    p2 =
        (p2 * Pair {
            a: ((a * S::from_f64(-0.375_f64)).abs() + S::from_f64(0.125)).tanh(),
            b: (S::from_f64(0.875_f64) + S::from_f64(0.125)).tanh(),
        } + Pair {
            a: ((r1[1] * r1[0]) * S::from_f64(0.75)).sin(),
            b: (d + S::from_f64(0.125)).tanh(),
        })
        .tamed();
    p2 = p2.tamed();
    (S::from_f64(0.125_f64) + (b * S::from_f64(-0.125_f64)).cos()) + a + d + f + b + y + x
}

#[differentiable]
fn program_55(x: f64, y: f64) -> f64 {
    let mut a = ((x + y) + 0.125).tanh();
    let mut r1 = [((-(-0.625_f64)) + 0.125).tanh(); 2];
    let mut p2 = Pair { a: ((r1[1] * x) * 0.75).sin(), b: ((x + 0.875_f64).sin() + 0.125).tanh() };
    let mut n3 = 0_usize;
    while raises(&mut r1) && n3 < 3 {
        n3 += 1;
    }
    let mut p4 = Pair {
        a: ((r1[(n3 * n3 + 1) % 2] + -0.625_f64).sin() + 0.125).tanh(),
        b: ((r1[1] * 0.375_f64).abs() * 0.75).sin(),
    };
    let b = left::curved((r1[(n3 * n3 + 1) % 2] * -1.125_f64).abs())
        * right::curved(((draw() * -0.125_f64).max(a) * 0.75).sin())
        - curved((r1[(n3 * n3 + 1) % 2] * -1.125_f64).abs());
    let b = p4.dot(&p2).sin();
    'l5: for i6 in (0..1_usize).step_by(2) {
        'l7: for i8 in n3..=2_usize {
            r1[(i8 * i8 + 1) % 2] -= (((r1[1] / (1.5 + x * x)) + 0.625_f64).sin() * 0.75).sin();
        }
    }
    let a = List(vec![
        ((p4.a * -0.375_f64).cos() * 0.75).sin(),
        (r1[(n3 * n3 + 1) % 2] + 0.625_f64).sin(),
        ((((n3 as f64) * 0.25) - 0.625_f64).tanh() * 0.75).sin(),
    ])
    .folded((r1[(n3 * n3 + 1) % 2] * 0.75).sin(), |s, v| {
        (s * v + (r1[n3 % 2] + r1[(n3 * n3 + 1) % 2])).sin()
    });
    let e = match roots((r1[n3 % 2] + ((n3 as f64) * 0.25)), (a + x)) {
        Ok(v) => (v * -1.125_f64).cos(),
        Err(true) => a,
        Err(_) => (a * x),
    };
    let a = match shape(
        ((((n3 as f64) * 0.25) / (1.5 + x * x)) * 0.75).sin(),
        (scale() * 0.75).sin(),
    ) {
        Shape::Point => (y * 0.875_f64).abs(),
        Shape::Disc(v) => ((n3 as f64) * 0.25),
        Shape::Box { w: v, h } => ((r1[n3 % 2] * r1[(n3 * n3 + 1) % 2]) * ((n3 as f64) * 0.25)),
    };
    p4.b = ((r1[(n3 * n3 + 1) % 2] * r1[(n3 * n3 + 1) % 2]) + 0.125).tanh();
    p4 = p4.tamed();
    let by9 = ((b * b + 0.25).sqrt() + 0.125).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by9).sin();
    }
    p2 += Pair { a: ((r1[n3 % 2] - y) * 0.75).sin(), b: ((a + r1[(n3 + 1) % 2]) + 0.125).tanh() };
    p2 = p2.tamed();
    (y + -0.625_f64).sin() + a + e + b + y + x
}

fn program_55_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + y) + S::from_f64(0.125)).tanh();
    let mut r1 = [((-(S::from_f64(-0.625_f64))) + S::from_f64(0.125)).tanh(); 2];
    let mut p2 = Pair {
        a: ((r1[1] * x) * S::from_f64(0.75)).sin(),
        b: ((x + S::from_f64(0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
    };
    let mut n3 = 0_usize;
    while raises(&mut r1) && n3 < 3 {
        n3 += 1;
    }
    let mut p4 = Pair {
        a: ((r1[(n3 * n3 + 1) % 2] + S::from_f64(-0.625_f64)).sin() + S::from_f64(0.125)).tanh(),
        b: ((r1[1] * S::from_f64(0.375_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    let b = left::curved((r1[(n3 * n3 + 1) % 2] * S::from_f64(-1.125_f64)).abs())
        * right::curved(
            ((S::from_f64(draw()) * S::from_f64(-0.125_f64)).max(a) * S::from_f64(0.75)).sin(),
        )
        - curved((r1[(n3 * n3 + 1) % 2] * S::from_f64(-1.125_f64)).abs());
    let b = p4.dot(&p2).sin();
    'l5: for i6 in (0..1_usize).step_by(2) {
        'l7: for i8 in n3..=2_usize {
            r1[(i8 * i8 + 1) % 2] = r1[(i8 * i8 + 1) % 2]
                - (((r1[1] / (S::from_f64(1.5) + x * x)) + S::from_f64(0.625_f64)).sin()
                    * S::from_f64(0.75))
                .sin();
        }
    }
    let a = List(vec![
        ((p4.a * S::from_f64(-0.375_f64)).cos() * S::from_f64(0.75)).sin(),
        (r1[(n3 * n3 + 1) % 2] + S::from_f64(0.625_f64)).sin(),
        (((S::from_f64(n3 as f64) * S::from_f64(0.25)) - S::from_f64(0.625_f64)).tanh()
            * S::from_f64(0.75))
        .sin(),
    ])
    .folded((r1[(n3 * n3 + 1) % 2] * S::from_f64(0.75)).sin(), |s, v| {
        (s * v + (r1[n3 % 2] + r1[(n3 * n3 + 1) % 2])).sin()
    });
    let e = match roots((r1[n3 % 2] + (S::from_f64(n3 as f64) * S::from_f64(0.25))), (a + x)) {
        Ok(v) => (v * S::from_f64(-1.125_f64)).cos(),
        Err(true) => a,
        Err(_) => (a * x),
    };
    let a = match shape(
        (((S::from_f64(n3 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + x * x))
            * S::from_f64(0.75))
        .sin(),
        (S::from_f64(scale()) * S::from_f64(0.75)).sin(),
    ) {
        Shape::Point => (y * S::from_f64(0.875_f64)).abs(),
        Shape::Disc(v) => (S::from_f64(n3 as f64) * S::from_f64(0.25)),
        Shape::Box { w: v, h } => {
            ((r1[n3 % 2] * r1[(n3 * n3 + 1) % 2]) * (S::from_f64(n3 as f64) * S::from_f64(0.25)))
        }
    };
    p4.b = ((r1[(n3 * n3 + 1) % 2] * r1[(n3 * n3 + 1) % 2]) + S::from_f64(0.125)).tanh();
    p4 = p4.tamed();
    let by9 = ((b * b + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    for v in r1.iter_mut() {
        *v = (*v * by9).sin();
    }
    p2 += Pair {
        a: ((r1[n3 % 2] - y) * S::from_f64(0.75)).sin(),
        b: ((a + r1[(n3 + 1) % 2]) + S::from_f64(0.125)).tanh(),
    };
    p2 = p2.tamed();
    (y + S::from_f64(-0.625_f64)).sin() + a + e + b + y + x
}

#[differentiable]
fn program_56(x: f64, y: f64) -> f64 {
    let mut a = ((scale() / (1.5 + y * y)) + 0.125).tanh();
    let mut r1 = [((x + -0.375_f64).sin() + 0.125).tanh(); 4];
    r1[1] += ((y * y + 0.25).sqrt() + 0.125).tanh();
    let g2 = |t: f64| ((a - t) - (t / (1.5 + r1[1] * r1[1]))) * t;
    let e = (g2((r1[2] * x)) + g2((x * 0.625_f64))).sin();
    let p3 = Pair { a: (-0.625_f64 + x), b: ((e / (1.5 + scale() * scale())) * 0.75).sin() };
    let f = (<Pair<f64> as Soft>::pressed(&p3) + Hard::pressed(&p3) * p3.pressed()).tamed().a;
    let a = program_20(((f * 0.875_f64).max(a) + 0.125).tanh(), ((e * r1[1]) * 0.75).sin()).tanh();
    let c = mixed(&r1[2..]).sin();
    'l4: for i5 in 2..2_usize {
        let mut q6 = [
            Ball {
                height: ((r1[i5 % 4] + -0.875_f64).sin() + 0.125).tanh(),
                speed: ((((i5 as f64) * 0.25) * ((i5 as f64) * 0.25) + 0.25).sqrt() + 0.125).tanh(),
            },
            Ball {
                height: ((((i5 as f64) * 0.25) + a) * 0.75).sin(),
                speed: ((r1[i5 % 4] * -0.875_f64).abs() + 0.125).tanh(),
            },
        ];
        let up7 = q6[i5 % 2].bounce();
        let d = if up7 { q6[1].run(1) } else { (((i5 as f64) * 0.25) * -1.125_f64).cos() };
        let d = q6[0].height * q6[1].speed - q6[0].speed;
        let b = List(vec![
            ((r1[(i5 * i5 + 1) % 4] * 0.625_f64).max(y) * 0.75).sin(),
            (r1[2] - a),
            ((a * r1[(i5 * i5 + 1) % 4]) + 0.125).tanh(),
        ])
        .folded(((r1[2] + 0.125_f64).sin() + 0.125).tanh(), |s, v| {
            (s * v + (r1[(i5 * i5 + 1) % 4] * r1[(i5 + 1) % 4])).sin()
        });
    }
    let mut e = ((f * r1[1]) * 0.75).sin();
    r1[3] += (((-(r1[3])) * 0.375_f64).max(x) + 0.125).tanh();
    let b = left::curved((a + c)) * right::curved(((-(scale())) + 0.125).tanh()) - curved((a + c));
    let mut n8 = 0_usize;
    while raises(&mut r1) && n8 < 3 {
        n8 += 1;
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 2 {
        n10 += 1;
        let f = match raises(&mut r1) {
            true => (0.875_f64 * x),
            false => ((e * r1[2]) - 0.875_f64).tanh(),
        };
        e = (((-0.125_f64 - r1[(n8 * n8 + 1) % 4])
            - (r1[(n10 + 0) % 4] / (1.5 + r1[(n10 * n10 + 1) % 4] * r1[(n10 * n10 + 1) % 4])))
            + 0.125)
            .tanh();
    }
    (r1[3] + -0.875_f64).sin() + b + e + c + a + f + y + x
}

fn program_56_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((S::from_f64(scale()) / (S::from_f64(1.5) + y * y)) + S::from_f64(0.125)).tanh();
    let mut r1 = [((x + S::from_f64(-0.375_f64)).sin() + S::from_f64(0.125)).tanh(); 4];
    r1[1] = r1[1] + ((y * y + S::from_f64(0.25)).sqrt() + S::from_f64(0.125)).tanh();
    let g2 = |t: S| ((a - t) - (t / (S::from_f64(1.5) + r1[1] * r1[1]))) * t;
    let e = (g2((r1[2] * x)) + g2((x * S::from_f64(0.625_f64)))).sin();
    let p3 = Pair {
        a: (S::from_f64(-0.625_f64) + x),
        b: ((e / (S::from_f64(1.5) + S::from_f64(scale()) * S::from_f64(scale())))
            * S::from_f64(0.75))
        .sin(),
    };
    let f = (<Pair<S> as Soft>::pressed(&p3) + Hard::pressed(&p3) * p3.pressed()).tamed().a;
    let a = program_20_of(
        ((f * S::from_f64(0.875_f64)).max(a) + S::from_f64(0.125)).tanh(),
        ((e * r1[1]) * S::from_f64(0.75)).sin(),
    )
    .tanh();
    let c = mixed(&r1[2..]).sin();
    'l4: for i5 in 2..2_usize {
        let mut q6 = [
            Ball {
                height: ((r1[i5 % 4] + S::from_f64(-0.875_f64)).sin() + S::from_f64(0.125)).tanh(),
                speed: (((S::from_f64(i5 as f64) * S::from_f64(0.25))
                    * (S::from_f64(i5 as f64) * S::from_f64(0.25))
                    + S::from_f64(0.25))
                .sqrt()
                    + S::from_f64(0.125))
                .tanh(),
            },
            Ball {
                height: (((S::from_f64(i5 as f64) * S::from_f64(0.25)) + a) * S::from_f64(0.75))
                    .sin(),
                speed: ((r1[i5 % 4] * S::from_f64(-0.875_f64)).abs() + S::from_f64(0.125)).tanh(),
            },
        ];
        let up7 = q6[i5 % 2].bounce();
        let d = if up7 {
            q6[1].run(1)
        } else {
            ((S::from_f64(i5 as f64) * S::from_f64(0.25)) * S::from_f64(-1.125_f64)).cos()
        };
        let d = q6[0].height * q6[1].speed - q6[0].speed;
        let b = List(vec![
            ((r1[(i5 * i5 + 1) % 4] * S::from_f64(0.625_f64)).max(y) * S::from_f64(0.75)).sin(),
            (r1[2] - a),
            ((a * r1[(i5 * i5 + 1) % 4]) + S::from_f64(0.125)).tanh(),
        ])
        .folded(((r1[2] + S::from_f64(0.125_f64)).sin() + S::from_f64(0.125)).tanh(), |s, v| {
            (s * v + (r1[(i5 * i5 + 1) % 4] * r1[(i5 + 1) % 4])).sin()
        });
    }
    let mut e = ((f * r1[1]) * S::from_f64(0.75)).sin();
    r1[3] = r1[3] + (((-(r1[3])) * S::from_f64(0.375_f64)).max(x) + S::from_f64(0.125)).tanh();
    let b = left::curved((a + c))
        * right::curved(((-(S::from_f64(scale()))) + S::from_f64(0.125)).tanh())
        - curved((a + c));
    let mut n8 = 0_usize;
    while raises(&mut r1) && n8 < 3 {
        n8 += 1;
    }
    let mut n10 = 0_usize;
    'l9: while n10 < 2 {
        n10 += 1;
        let f = match raises(&mut r1) {
            true => (S::from_f64(0.875_f64) * x),
            false => ((e * r1[2]) - S::from_f64(0.875_f64)).tanh(),
        };
        e = (((S::from_f64(-0.125_f64) - r1[(n8 * n8 + 1) % 4])
            - (r1[(n10 + 0) % 4]
                / (S::from_f64(1.5) + r1[(n10 * n10 + 1) % 4] * r1[(n10 * n10 + 1) % 4])))
            + S::from_f64(0.125))
        .tanh();
    }
    (r1[3] + S::from_f64(-0.875_f64)).sin() + b + e + c + a + f + y + x
}

#[differentiable]
fn program_57(x: f64, y: f64) -> f64 {
    let mut a = ((x + -1.125_f64) * 0.75).sin();
    let mut r1 = [((a * x) * 0.75).sin(), (a + 0.125).tanh()];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let k4 = (r1[(n3 + 1) % 2] * a);
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k4).sin();
            part.reverse();
        }
    }
    let mut p5 = Pair { a: (x + 0.125).tanh(), b: ((x * -1.125_f64).abs() + 0.125).tanh() };
    p5 += p5;
    p5 = p5.tamed();
    let mut u6 = r1.to_vec();
    u6.push((y + 0.125).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let f = (mixed(&u6) + u6[0]).tanh();
    let mut q7 = [
        Ball {
            height: ((y - 0.125_f64).tanh() * 0.75).sin(),
            speed: ((r1[0] * 0.125_f64).cos() + 0.125).tanh(),
        },
        Ball { height: ((x * a) * 0.75).sin(), speed: ((x * a) + 0.125).tanh() },
    ];
    let up8 = q7[0].bounce();
    let f = if up8 { q7[1].run(2) } else { (f * f) };
    let b = q7[0].height * q7[1].speed - q7[0].speed;
    let mut n10 = 0_usize;
    'l9: while n10 < 2 {
        n10 += 1;
        r1[1] = (((r1[(n10 + 0) % 2] + y)
            / (1.5 + (f * -0.625_f64).abs() * (f * -0.625_f64).abs()))
            + 0.125)
            .tanh();
        let mut u11 = r1.to_vec();
        u11.push((y + 0.125).tanh());
        u11[0] = u11[1] * u11[u11.len() - 1];
        let f = (mixed(&u11) + u11[0]).tanh();
        'l12: for i13 in n10..=3_usize {
            let c = match root((((n10 as f64) * 0.25) * r1[(n10 * n10 + 1) % 2])) {
                Some(v) => ((((n10 as f64) * 0.25) / (1.5 + v * v)) + (b * draw())),
                None => a,
            };
            a = (((0.625_f64 * ((n10 as f64) * 0.25))
                * (r1[(i13 * i13 + 1) % 2] * 0.875_f64).cos())
                + 0.125)
                .tanh();
        }
    }
    let mut p14 = Pair { a: ((x * 0.375_f64).max(b) * 0.75).sin(), b: (draw() + 0.125).tanh() };
    let (a, mut b) = ((0.875_f64 * 0.75).sin(), (r1[1] * r1[1] + 0.25).sqrt());
    r1[0] + b + a + f + y + x
}

fn program_57_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x + S::from_f64(-1.125_f64)) * S::from_f64(0.75)).sin();
    let mut r1 = [((a * x) * S::from_f64(0.75)).sin(), (a + S::from_f64(0.125)).tanh()];
    let mut n3 = 0_usize;
    'l2: while n3 < 4 {
        n3 += 1;
        let k4 = (r1[(n3 + 1) % 2] * a);
        for part in r1.chunks_exact_mut(2) {
            part[0] = (part[0] * k4).sin();
            part.reverse();
        }
    }
    let mut p5 = Pair {
        a: (x + S::from_f64(0.125)).tanh(),
        b: ((x * S::from_f64(-1.125_f64)).abs() + S::from_f64(0.125)).tanh(),
    };
    p5 += p5;
    p5 = p5.tamed();
    let mut u6 = r1.to_vec();
    u6.push((y + S::from_f64(0.125)).tanh());
    u6[0] = u6[1] * u6[u6.len() - 1];
    let f = (mixed(&u6) + u6[0]).tanh();
    let mut q7 = [
        Ball {
            height: ((y - S::from_f64(0.125_f64)).tanh() * S::from_f64(0.75)).sin(),
            speed: ((r1[0] * S::from_f64(0.125_f64)).cos() + S::from_f64(0.125)).tanh(),
        },
        Ball {
            height: ((x * a) * S::from_f64(0.75)).sin(),
            speed: ((x * a) + S::from_f64(0.125)).tanh(),
        },
    ];
    let up8 = q7[0].bounce();
    let f = if up8 { q7[1].run(2) } else { (f * f) };
    let b = q7[0].height * q7[1].speed - q7[0].speed;
    let mut n10 = 0_usize;
    'l9: while n10 < 2 {
        n10 += 1;
        r1[1] = (((r1[(n10 + 0) % 2] + y)
            / (S::from_f64(1.5)
                + (f * S::from_f64(-0.625_f64)).abs() * (f * S::from_f64(-0.625_f64)).abs()))
            + S::from_f64(0.125))
        .tanh();
        let mut u11 = r1.to_vec();
        u11.push((y + S::from_f64(0.125)).tanh());
        u11[0] = u11[1] * u11[u11.len() - 1];
        let f = (mixed(&u11) + u11[0]).tanh();
        'l12: for i13 in n10..=3_usize {
            let c = match root(
                ((S::from_f64(n10 as f64) * S::from_f64(0.25)) * r1[(n10 * n10 + 1) % 2]),
            ) {
                Some(v) => {
                    (((S::from_f64(n10 as f64) * S::from_f64(0.25)) / (S::from_f64(1.5) + v * v))
                        + (b * S::from_f64(draw())))
                }
                None => a,
            };
            a = (((S::from_f64(0.625_f64) * (S::from_f64(n10 as f64) * S::from_f64(0.25)))
                * (r1[(i13 * i13 + 1) % 2] * S::from_f64(0.875_f64)).cos())
                + S::from_f64(0.125))
            .tanh();
        }
    }
    let mut p14 = Pair {
        a: ((x * S::from_f64(0.375_f64)).max(b) * S::from_f64(0.75)).sin(),
        b: (S::from_f64(draw()) + S::from_f64(0.125)).tanh(),
    };
    let (a, mut b) = (
        (S::from_f64(0.875_f64) * S::from_f64(0.75)).sin(),
        (r1[1] * r1[1] + S::from_f64(0.25)).sqrt(),
    );
    r1[0] + b + a + f + y + x
}

#[differentiable]
fn program_58(x: f64, y: f64) -> f64 {
    let mut a = ((x / (1.5 + y * y)) * 0.75).sin();
    let r1 = [((-(y)) + 0.125).tanh(); 4];
    let f = ((r1[1] * -1.125_f64).cos() * (y + r1[2]));
    a += (((x * f) + scale()) + 0.125).tanh();
    let d = mixed(&r1).sin();
    a += (d + 0.125).tanh();
    let mut r2 = [
        (f * 0.75).sin(),
        ((-(-0.875_f64)) * 0.75).sin(),
        ((y + d) + 0.125).tanh(),
        ((d + -1.125_f64).sin() + 0.125).tanh(),
        ((x + -1.125_f64).sin() * 0.75).sin(),
    ];
    let mut w3 = (((draw() + y) * 0.75).sin(), [(scale() - 0.125_f64); 2]);
    {
        let (p, [q, _]) = &mut w3;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w3.0 + w3.1[0] * w3.1[1]).tanh();
    let a = root((y * r1[0]))
        .map_or((y * -0.875_f64).cos(), |v| ((f / (1.5 + r2[0] * r2[0])) * (f * r1[0])));
    let mut r4 = [((draw() + x) + 0.125).tanh(); 5];
    let mut p5 =
        Pair { a: ((a + -0.125_f64) * 0.75).sin(), b: ((r2[2] * 0.875_f64).abs() * 0.75).sin() };
    let by6 = (x * 0.75).sin();
    for v in r4.iter_mut() {
        *v = (*v * by6).sin();
    }
    let mut e = ((-0.375_f64 - scale()) * 0.75).sin();
    let mut n8 = 0_usize;
    'l7: while n8 < 1 {
        n8 += 1;
        let f = match shape(
            ((f * -0.375_f64).max(f) + 0.125).tanh(),
            ((d * -0.125_f64).abs() * 0.75).sin(),
        ) {
            Point => (-(y)),
            Disc(v) => ((-(v)) + (a * a + 0.25).sqrt()),
            Shape::Box { w: v, h } => ((p5.a - p5.b) + 0.375_f64).sin(),
        };
        p5 = (p5 * p5 + p5).tamed();
        p5 = p5.tamed();
    }
    ((-(-0.625_f64)) + a) + e + a + f + d + y + x
}

fn program_58_of<S: Real<Mask = bool>>(x: S, y: S) -> S {
    let mut a = ((x / (S::from_f64(1.5) + y * y)) * S::from_f64(0.75)).sin();
    let r1 = [((-(y)) + S::from_f64(0.125)).tanh(); 4];
    let f = ((r1[1] * S::from_f64(-1.125_f64)).cos() * (y + r1[2]));
    a = a + (((x * f) + S::from_f64(scale())) + S::from_f64(0.125)).tanh();
    let d = mixed(&r1).sin();
    a = a + (d + S::from_f64(0.125)).tanh();
    let mut r2 = [
        (f * S::from_f64(0.75)).sin(),
        ((-(S::from_f64(-0.875_f64))) * S::from_f64(0.75)).sin(),
        ((y + d) + S::from_f64(0.125)).tanh(),
        ((d + S::from_f64(-1.125_f64)).sin() + S::from_f64(0.125)).tanh(),
        ((x + S::from_f64(-1.125_f64)).sin() * S::from_f64(0.75)).sin(),
    ];
    let mut w3 = (
        ((S::from_f64(draw()) + y) * S::from_f64(0.75)).sin(),
        [(S::from_f64(scale()) - S::from_f64(0.125_f64)); 2],
    );
    {
        let (p, [q, _]) = &mut w3;
        *p = (*p * *q).sin();
        *q = *q * *p + *q;
    }
    let f = (w3.0 + w3.1[0] * w3.1[1]).tanh();
    let a = root((y * r1[0])).map_or((y * S::from_f64(-0.875_f64)).cos(), |v| {
        ((f / (S::from_f64(1.5) + r2[0] * r2[0])) * (f * r1[0]))
    });
    let mut r4 = [((S::from_f64(draw()) + x) + S::from_f64(0.125)).tanh(); 5];
    let mut p5 = Pair {
        a: ((a + S::from_f64(-0.125_f64)) * S::from_f64(0.75)).sin(),
        b: ((r2[2] * S::from_f64(0.875_f64)).abs() * S::from_f64(0.75)).sin(),
    };
    let by6 = (x * S::from_f64(0.75)).sin();
    for v in r4.iter_mut() {
        *v = (*v * by6).sin();
    }
    let mut e = ((S::from_f64(-0.375_f64) - S::from_f64(scale())) * S::from_f64(0.75)).sin();
    let mut n8 = 0_usize;
    'l7: while n8 < 1 {
        n8 += 1;
        let f = match shape(
            ((f * S::from_f64(-0.375_f64)).max(f) + S::from_f64(0.125)).tanh(),
            ((d * S::from_f64(-0.125_f64)).abs() * S::from_f64(0.75)).sin(),
        ) {
            Point => (-(y)),
            Disc(v) => ((-(v)) + (a * a + S::from_f64(0.25)).sqrt()),
            Shape::Box { w: v, h } => ((p5.a - p5.b) + S::from_f64(0.375_f64)).sin(),
        };
        p5 = (p5 * p5 + p5).tamed();
        p5 = p5.tamed();
    }
    ((-(S::from_f64(-0.625_f64))) + a) + e + a + f + d + y + x
}

of_parts!(#[differentiable] program_59 (x, y: f64) f64::from, -x * (x - x), y - (x * x + 0.25).sqrt(), if (x - -1.125_f64).tanh() > (x * x + 0.25).sqrt() { x } else { (-(y)) });
of_parts!(program_59_of<S> (x, y: S) S::from_f64, -x * (x - x), y - (x * x + S::from_f64(0.25)).sqrt(), if (x - S::from_f64(-1.125_f64)).tanh().cmpgt((x * x + S::from_f64(0.25)).sqrt()) { x } else { (-(y)) });
