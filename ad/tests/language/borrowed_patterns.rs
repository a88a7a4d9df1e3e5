//! Patterns that bind `&mut`: in `match`, `if let`, `let else`.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
enum E {
    A(f64),
    B { u: f64, v: f64 },
    N,
    V(Vec<f64>),
}

#[derive(Clone, Copy, Debug, Differentiable)]
struct P {
    a: f64,
    b: f64,
}

#[differentiable]
fn variants(x: f64, y: f64) -> f64 {
    let mut e = E::A(x * y);
    match &mut e {
        E::A(a) => *a *= x,
        E::B { u, .. } => *u += y,
        _ => {}
    }
    match e {
        E::A(a) => a * y,
        E::B { u, v } => u + v,
        _ => 0.0,
    }
}

#[differentiable]
fn option(x: f64, y: f64) -> f64 {
    let mut o = Some(x * y);
    if let Some(v) = &mut o {
        *v *= x;
    }
    o.unwrap_or(y) * y
}

#[differentiable]
fn as_mut(x: f64, y: f64) -> f64 {
    let mut o = Some(x * y);
    if let Some(v) = o.as_mut() {
        *v *= x;
        let w = *v;
        *v = w * w + y;
    }
    o.unwrap_or(y) * y
}

mod matched_self {
    use super::*;

    #[differentiable]
    impl E {
        fn grow(&mut self, k: f64) -> f64 {
            match self {
                Self::A(a) => {
                    *a *= k;
                    *a
                }
                E::B { u, v } => {
                    *u += *v * k;
                    *v -= *u;
                    *u * *v
                }
                E::V(w) => {
                    w.push(k);
                    w[0] *= k;
                    w[0]
                }
                E::N => k,
            }
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut e = E::B { u: x, v: y };
        let r = e.grow(x * y);
        let s = e.grow(y);
        match e {
            E::B { u, v } => u * v * r + s,
            _ => 0.0,
        }
    }
    #[differentiable]
    fn g(x: f64, y: f64) -> f64 {
        let mut e = E::V(vec![x, y]);
        let r = e.grow(x * y);
        let s = e.grow(y);
        match e {
            E::V(w) => w[0] * w[2] * r + s * w[3],
            _ => 0.0,
        }
    }
}

mod fields {
    use super::*;

    #[derive(Clone, Debug, Differentiable)]
    struct S {
        k: Option<P>,
        e: E,
    }
    #[differentiable]
    impl S {
        fn step(&mut self, x: f64) {
            if let Some(p) = &mut self.k {
                p.a *= x;
                p.b += p.a;
            }
            match &mut self.e {
                E::A(t) | E::B { u: t, .. } => *t += x,
                _ => {}
            }
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut s = S { k: Some(P { a: x, b: y }), e: E::B { u: y, v: x } };
        for _ in 0..3 {
            s.step(y);
        }
        let p = s.k.unwrap();
        let t = match s.e {
            E::A(t) => t,
            E::B { u, v } => u * v,
            _ => 0.0,
        };
        p.a * p.b + t
    }
}

#[differentiable]
fn used_meanwhile(x: f64, y: f64) -> f64 {
    let mut e = E::A(x * y);
    let mut s = 0.0;
    match &mut e {
        E::A(a) => {
            *a *= x;
            let c = e.clone();
            if let E::A(t) = c {
                s += t * t;
            }
            if let E::A(b) = &mut e {
                *b += y;
            }
        }
        _ => {}
    }
    if let E::A(a) = &e {
        s += a * x;
    }
    s
}

mod parameters {
    use super::*;

    #[differentiable]
    fn upd(e: &mut E, o: &mut Option<f64>, k: f64) {
        if let E::A(a) = e {
            *a = *a * k;
        }
        if let Some(v) = o {
            *v += k * k;
        }
        match o {
            Some(v) => *v *= k,
            None => *o = Some(k),
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut e = E::A(x);
        let mut o = Some(y);
        let mut n = None;
        upd(&mut e, &mut o, x);
        upd(&mut e, &mut n, y);
        let E::A(a) = e else { return 0.0 };
        a * o.unwrap() * n.unwrap()
    }
}

#[differentiable]
fn let_else(x: f64, y: f64) -> f64 {
    let mut e = E::A(x * y);
    let E::A(a) = &mut e else { return x };
    *a *= y;
    *a += x;
    let E::A(b) = e else { return y };
    b * b
}

mod passed_on {
    use super::*;

    #[differentiable]
    fn bump(a: &mut f64, k: f64) -> f64 {
        *a *= k;
        *a + k
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut e = E::B { u: x, v: y };
        let mut s = 0.0;
        if let E::B { u, v } = &mut e {
            s += bump(u, y);
            s += bump(v, x) * *u;
            std::mem::swap(u, v);
        }
        if let E::B { u, v } = e { s + u * u * v } else { s }
    }
}

#[differentiable]
fn tuples(x: f64, y: f64) -> f64 {
    let mut t = (Some(x), [y, x * y]);
    match &mut t {
        (Some(a), [b, c]) => {
            *a *= *b;
            *b = *c * *a;
        }
        _ => {}
    }
    t.0.unwrap() * t.1[0] + t.1[1]
}

#[differentiable]
fn slices(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, 1.0];
    if let [a, .., d] = &mut v[..] {
        *a *= y;
        *d += *a * x;
    }
    match &mut v[1..] {
        [a, rest @ ..] => {
            for r in rest.iter_mut() {
                *r *= *a;
            }
        }
        [] => {}
    }
    v[0] * v[1] + v[2] * v[3]
}

#[differentiable]
fn elements(x: f64, y: f64) -> f64 {
    let mut es = vec![E::A(x), E::B { u: y, v: x }, E::N, E::A(y)];
    for (i, e) in es.iter_mut().enumerate() {
        match e {
            E::A(a) => *a *= x + i as f64,
            E::B { u, v } => {
                *u += *v;
                if *u > 0.0 {
                    continue;
                }
                *v *= 2.0;
            }
            _ => {}
        }
    }
    let mut s = 0.0;
    for e in &es {
        s += match e {
            E::A(a) => a * a,
            E::B { u, v } => u * v,
            _ => 1.0,
        };
    }
    s
}

#[differentiable]
fn nested(x: f64, y: f64) -> f64 {
    let mut e = (Some(E::A(x)), y);
    if let (Some(E::A(a)), b) = &mut e {
        *a *= *b;
        *b += *a;
    }
    match e {
        (Some(E::A(a)), b) => a * b,
        _ => 0.0,
    }
}

mod boxes {
    use super::*;

    #[derive(Clone, Debug, Differentiable)]
    enum T {
        L(f64),
        N(Box<T>, Box<T>),
    }
    #[differentiable]
    fn scale(t: &mut T, k: f64) {
        match t {
            T::L(v) => *v *= k,
            T::N(a, b) => {
                scale(a, k);
                scale(b, k * k);
            }
        }
    }
    #[differentiable]
    fn sum(t: &T) -> f64 {
        match t {
            T::L(v) => v * v,
            T::N(a, b) => sum(a) * sum(b),
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut t = T::N(Box::new(T::L(x)), Box::new(T::L(y)));
        scale(&mut t, x);
        sum(&t)
    }
}

#[differentiable]
fn captured(x: f64, y: f64) -> f64 {
    let mut o = Some(x);
    let mut n = 0;
    if let Some(v) = &mut o {
        let mut add = |t: f64| *v += t * y;
        add(x);
        add(y);
        n += 1;
    }
    o.unwrap() * n as f64
}

mod beside_integers {
    use super::*;

    #[derive(Clone, Debug, Differentiable)]
    enum K {
        C(usize, f64),
        D,
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut k = if x > 100.0 { K::D } else { K::C(0, x) };
        for _ in 0..3 {
            match &mut k {
                K::C(n, t) => {
                    *n += 1;
                    *t *= y * *n as f64;
                }
                K::D => {}
            }
        }
        match k {
            K::C(n, t) => t * n as f64,
            K::D => 0.0,
        }
    }
}

#[test]
fn what_a_pattern_borrows_is_changed() {
    check!(variants(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(option(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(as_mut(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use matched_self::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    {
        use fields::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    check!(used_meanwhile(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use parameters::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    check!(let_else(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use passed_on::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    check!(tuples(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(slices(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(elements(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(nested(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use boxes::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    check!(captured(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use beside_integers::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
}

#[derive(Clone, Copy, Debug, Differentiable)]
struct Wrapped<T>(T);

#[differentiable]
fn wrapped(a: &f64) -> Wrapped<f64> {
    Wrapped(*a)
}

#[differentiable]
fn both(x: &[f64]) -> P {
    let (head, tail) = (&x[0], &x[1]);
    P { a: *head, b: *tail }
}

#[differentiable]
fn copied(e: &E) -> E {
    match e {
        E::A(a) => E::A(*a),
        E::B { u, v } => E::B { u: *v, v: *u },
        other => other.clone(),
    }
}

/// What a reference leads to, as a field of what is made.
#[differentiable]
fn made_from_references(x: f64, y: f64) -> f64 {
    let whole = both(&[x, y]);
    let turned = match copied(&E::B { u: whole.a, v: whole.b }) {
        E::B { u, v } => u * u + v,
        _ => 0.0,
    };
    let boxed = Box::new(y);
    turned * wrapped(&x).0 + wrapped(&boxed).0
}

#[test]
fn fields_made_from_references() {
    check!(made_from_references(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}
