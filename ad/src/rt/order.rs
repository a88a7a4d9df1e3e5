//! The order in which `place += value` evaluates its sides.

/// Types whose assigning operators the compiler knows: between these the value is evaluated first, else the
/// place.
#[diagnostic::on_unimplemented(
    message = "of `place += value` the place is evaluated first where one of both is a `{Self}`, and here last",
    label = "the order of its sides may matter",
    note = "give one side a name before, by `let`"
)]
pub trait BuiltIn {}

macro_rules! built_in {
    ($($type:ty)*) => {$(
        impl BuiltIn for $type {}
    )*};
}

built_in!(f32 f64 i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);

/// Compiles where the value of `place += value` is evaluated first.
#[inline(always)]
pub fn right_first<T: BuiltIn, V: BuiltIn>(_place: &T, _value: &V) {}
