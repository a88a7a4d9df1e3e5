//! `return` of what is not `Copy` out of a loop.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
struct S {
    v: Vec<f64>,
    k: f64,
}

mod found {
    use super::*;

    #[differentiable]
    fn find(xs: &[f64], t: f64) -> Vec<f64> {
        let mut v = Vec::new();
        for x in xs {
            v.push(x * t);
            if v.len() == 2 {
                return v;
            }
        }
        v.push(t);
        v
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let v = find(&[x, y, x * y], x);
        v[0] * v[1]
    }
}

mod result {
    use super::*;

    #[differentiable]
    fn run(x: f64, y: f64) -> Result<Vec<f64>, String> {
        let mut v = vec![x, y];
        for k in 0..5 {
            if v[0] > 100.0 {
                return Err("big".into());
            }
            if k == 3 {
                return Ok(v);
            }
            v[0] *= y;
        }
        Ok(v)
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        match run(x, y) {
            Ok(v) => v[0] * v[1],
            Err(_) => 0.0,
        }
    }
}

mod endless {
    use super::*;

    #[differentiable]
    fn cg(x: f64, y: f64) -> (Vec<f64>, f64) {
        let mut v = vec![x, y];
        let mut r = 1.0;
        loop {
            r *= 0.5 * y;
            v[0] += r;
            for _ in 0..3 {
                v[1] *= x;
                if v[1].abs() > 5.0 {
                    return (v, r);
                }
            }
            if r.abs() < 0.1 {
                return (v, r);
            }
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let (v, r) = cg(x, y * 0.3);
        v[0] * v[1] + r
    }
}

mod own_struct {
    use super::*;

    #[differentiable]
    fn go(x: f64, y: f64) -> S {
        let mut s = S { v: vec![x], k: y };
        let mut n = 0;
        while n < 4 {
            s.v.push(s.k * x);
            s.k *= y;
            n += 1;
            if s.k < 0.5 {
                return s;
            }
            if n == 3 {
                s.k += 1.0;
                return s;
            }
        }
        s
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let s = go(x, y);
        s.v.iter().sum::<f64>() * s.k
    }
}

mod moved_before {
    use super::*;

    #[differentiable]
    fn go(v: Vec<f64>, y: f64) -> Option<Vec<f64>> {
        let mut v = v;
        for i in 0..v.len() {
            if v[i] < -3.0 {
                return None;
            }
            v[i] *= y;
            if i == 1 {
                return Some(v);
            }
        }
        Some(v)
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        go(vec![x, y, x], y).map_or(0.0, |v| v[0] * v[1] * v[2])
    }
}

mod parameter {
    use super::*;

    #[differentiable]
    fn go(mut v: Vec<f64>, y: f64) -> Vec<f64> {
        for i in 0..v.len() {
            let v2 = v[i];
            if v2 > 0.5 {
                return v;
            }
            v[i] = v2 * y + 1.0;
        }
        v
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let w = go(vec![x, y, x], y);
        w[0] * w[1] * w[2]
    }
}

#[test]
fn loops_are_left_with_values() {
    {
        use found::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use result::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use endless::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use own_struct::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use moved_before::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use parameter::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
}
