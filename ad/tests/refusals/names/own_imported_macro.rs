mod imported {
    macro_rules! reversed {
        ($($a:expr),*) => {{
            let mut v = std::vec![$($a),*];
            v.reverse();
            v
        }};
    }
    pub(crate) use reversed as vec;
}

mod importing {
    use super::imported::vec;

    #[ad::differentiable]
    pub fn makes(x: f64) -> f64 {
        let v = vec![x, 2.0];
        v[1]
    }
}

fn main() {}
