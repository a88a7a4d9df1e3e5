//! Random expressions. Their values stay moderate, and no function leaves its domain.

use crate::text::{Both, put};
use crate::writer::{Kind, Writer};

impl Writer {
    /// An expression of moderate size.
    pub fn expression(&mut self, depth: usize) -> Both {
        if depth == 0 || self.random.chance(15) {
            return self.leaf();
        }
        let a = self.expression(depth - 1);
        let constant = self.literal();
        match self.random.below(14) {
            0 | 1 => put("({} + {})", &[&a, &self.expression(depth - 1)]),
            2 => put("({} - {})", &[&a, &self.expression(depth - 1)]),
            3..=5 => put("({} * {})", &[&a, &self.expression(depth - 1)]),
            6 => {
                let b = self.expression(depth - 1);
                put("({} / ({} + {} * {}))", &[&a, &Both::number(1.5), &b, &b])
            }
            7 => put("({}).sin()", &[&put("{} + {}", &[&a, &constant])]),
            8 => put("({}).cos()", &[&put("{} * {}", &[&a, &constant])]),
            9 => put("({}).tanh()", &[&put("{} - {}", &[&a, &constant])]),
            10 => put("({} * {} + {}).sqrt()", &[&a, &a, &Both::number(0.25)]),
            11 => put("({}).max({})", &[&put("{} * {}", &[&a, &constant]), &self.leaf()]),
            12 => put("(-({}))", &[&a]),
            _ => put("({} * {}).abs()", &[&a, &constant]),
        }
    }

    /// A variable, an element, a constant, or what an integer is worth.
    pub fn leaf(&mut self) -> Both {
        let (scalars, arrays, integers) =
            (self.visible(Kind::is_scalar), self.visible(Kind::is_array), self.integers());
        let pairs = self.visible(|kind| kind == Kind::Pair);
        match self.random.below(11) {
            10 if !self.is_pure() => self.drawn(),
            0 if !integers.is_empty() => {
                let integer = self.random.pick(&integers);
                put(
                    "({} * {})",
                    &[
                        &Both::number(format!("{integer} as f64")).parenthesised(),
                        &Both::number(0.25),
                    ],
                )
            }
            1..=3 if !arrays.is_empty() => {
                let array = self.random.pick(&arrays);
                let index = self.index(array.length());
                Both::same(format!("{}[{index}]", array.name))
            }
            4 => self.literal(),
            5 if !pairs.is_empty() => {
                let pair = self.random.pick(&pairs).name;
                Both::same(format!("{pair}.{}", self.random.pick(&["a", "b"])))
            }
            _ => Both::same(self.random.pick(&scalars).name),
        }
    }

    pub fn literal(&mut self) -> Both {
        let quarters = self.random.below(9) as f64;
        Both::number(format!("{:?}_f64", quarters / 4.0 - 1.125))
    }

    /// An index into an array.
    pub fn index(&mut self, length: usize) -> String {
        let integers = self.integers();
        if integers.is_empty() || self.random.chance(30) {
            return self.random.below(length).to_string();
        }
        let integer = self.random.pick(&integers);
        match self.random.below(3) {
            0 => format!("{integer} % {length}"),
            1 => format!("({integer} + {}) % {length}", self.random.below(length)),
            _ => format!("({integer} * {integer} + 1) % {length}"),
        }
    }

    /// A comparison of numbers or of integers.
    pub fn condition(&mut self) -> Both {
        let integers = self.integers();
        if !integers.is_empty() && self.random.chance(40) {
            let (integer, modulus) = (self.random.pick(&integers), 2 + self.random.below(3));
            return Both::same(format!("{integer} % {modulus} == {}", self.random.below(modulus)));
        }
        let (a, b) = (self.expression(1), self.expression(1));
        let (operator, name) =
            self.random.pick(&[("<", "cmplt"), (">", "cmpgt"), ("<=", "cmple"), (">=", "cmpge")]);
        Both {
            plain: format!("{} {operator} {}", a.plain, b.plain),
            generic: format!("{}.{name}({})", a.generic, b.generic),
        }
    }

    /// An expression that stays bounded however often it is repeated.
    pub fn bounded(&mut self, depth: usize) -> Both {
        let value = self.expression(depth);
        match self.random.chance(50) {
            true => put("({}).sin()", &[&put("{} * {}", &[&value, &Both::number(0.75)])]),
            false => put("({}).tanh()", &[&put("{} + {}", &[&value, &Both::number(0.125)])]),
        }
    }
}
