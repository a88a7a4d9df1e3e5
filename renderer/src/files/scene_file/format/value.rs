//! Numbers of a scene file.

use std::fmt;

use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

/// A number, or an array of them.
#[derive(Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub(in super::super) enum Numbers {
    One(f64),
    Many(Vec<f64>),
}

impl From<&[f64]> for Numbers {
    fn from(numbers: &[f64]) -> Self {
        match numbers {
            [number] => Self::One(*number),
            _ => Self::Many(numbers.to_vec()),
        }
    }
}

impl<'de> Deserialize<'de> for Numbers {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumbersVisitor;

        impl<'de> Visitor<'de> for NumbersVisitor {
            type Value = Numbers;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a number or an array of numbers")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Numbers, E> {
                Ok(Numbers::One(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Numbers, E> {
                Ok(Numbers::One(value as f64))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Numbers, E> {
                Ok(Numbers::One(value as f64))
            }

            fn visit_i128<E: de::Error>(self, value: i128) -> Result<Numbers, E> {
                Ok(Numbers::One(value as f64))
            }

            fn visit_u128<E: de::Error>(self, value: u128) -> Result<Numbers, E> {
                Ok(Numbers::One(value as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Numbers, A::Error> {
                let mut numbers = Vec::new();
                while let Some(number) = values.next_element()? {
                    numbers.push(number);
                }
                Ok(Numbers::Many(numbers))
            }
        }

        deserializer.deserialize_any(NumbersVisitor)
    }
}
