//! Values as lists of numbers.

use crate::vector::Xyz;

/// A value that is made of real numbers, its coordinates.
pub trait Coordinates: Sized {
    /// Appends the coordinates.
    fn write(&self, into: &mut Vec<f64>);

    /// The same value with other coordinates, of which it takes as many as it has.
    fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self;

    /// The coordinates.
    fn coordinates(&self) -> Vec<f64> {
        let mut coordinates = Vec::new();
        self.write(&mut coordinates);
        coordinates
    }
}

macro_rules! scalars {
    ($($type:ty)*) => {$(
        impl Coordinates for $type {
            fn write(&self, into: &mut Vec<f64>) {
                into.push(f64::from(*self));
            }

            fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
                from.next().map_or(*self, |value| value as $type)
            }
        }
    )*};
}

scalars!(f32 f64);

macro_rules! discrete {
    ($($type:ty)*) => {$(
        impl Coordinates for $type {
            fn write(&self, _: &mut Vec<f64>) {}

            fn read(&self, _: &mut impl Iterator<Item = f64>) -> Self {
                *self
            }
        }
    )*};
}

discrete!(bool char i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);

impl<T: Coordinates> Coordinates for Xyz<T> {
    fn write(&self, into: &mut Vec<f64>) {
        [&self.x, &self.y, &self.z].into_iter().for_each(|element| element.write(into));
    }

    fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
        let [x, y, z] = [&self.x, &self.y, &self.z].map(|element| element.read(from));
        Self { x, y, z }
    }
}

impl<T: Coordinates, const N: usize> Coordinates for [T; N] {
    fn write(&self, into: &mut Vec<f64>) {
        self.iter().for_each(|element| element.write(into));
    }

    fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
        self.each_ref().map(|element| element.read(from))
    }
}

impl<T: Coordinates> Coordinates for Vec<T> {
    fn write(&self, into: &mut Vec<f64>) {
        self.iter().for_each(|element| element.write(into));
    }

    fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
        self.iter().map(|element| element.read(from)).collect()
    }
}

impl<T: Coordinates> Coordinates for Option<T> {
    fn write(&self, into: &mut Vec<f64>) {
        self.iter().for_each(|content| content.write(into));
    }

    fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
        self.as_ref().map(|content| content.read(from))
    }
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Coordinates),*> Coordinates for ($($name,)*) {
            #[allow(unused_variables)]
            fn write(&self, into: &mut Vec<f64>) {
                $(self.$index.write(into);)*
            }

            #[allow(unused_variables, clippy::unused_unit)]
            fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
                ($(self.$index.read(from),)*)
            }
        }
    )*};
}

tuples! {
    ()
    (A 0)
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D 3)
    (A 0, B 1, C 2, D 3, E 4)
    (A 0, B 1, C 2, D 3, E 4, F 5)
}
