mod printing {
    macro_rules! println {
        ($a:expr) => {
            $a *= 2.0
        };
    }

    #[ad::differentiable]
    pub fn doubles(x: f64) -> f64 {
        let mut y = x;
        println!(y);
        y * y
    }
}

mod formatting {
    macro_rules! format {
        ($a:expr) => {
            3.0 * $a
        };
    }

    #[ad::differentiable]
    pub fn triples(x: f64) -> f64 {
        let y = format!(x);
        y * y
    }
}

mod ending {
    macro_rules! unreachable {
        ($a:expr) => {
            $a
        };
    }

    #[ad::differentiable]
    pub fn goes_on(x: f64) -> f64 {
        if x > 1.0 { x * x } else { unreachable!(x) }
    }
}

/// Another macro that does what that of the standard library does.
mod muted {
    macro_rules! println {
        ($($token:tt)*) => {{}};
    }

    #[ad::differentiable]
    pub fn says_nothing(x: f64) -> f64 {
        println!("{x}");
        x * x
    }
}

fn main() {
    muted::says_nothing::grad(2.0);
}
