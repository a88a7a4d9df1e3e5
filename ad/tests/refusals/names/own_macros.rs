mod textual {
    macro_rules! vec {
        ($a:expr, $b:expr) => {
            [$b, $a, 3.0]
        };
    }

    macro_rules! dbg {
        ($a:expr) => {
            2.0 * $a
        };
    }

    #[ad::differentiable]
    pub fn makes(x: f64) -> f64 {
        let v = vec![x, 2.0];
        v[1] * dbg!(x)
    }
}

fn main() {}
