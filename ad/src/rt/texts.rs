//! Numbers that are read from texts of numbers with a derivative.

/// What a function gave for such a text.
pub struct Read<'a, T: ?Sized>(pub &'a T);

/// What does not come from a text.
#[diagnostic::on_unimplemented(
    message = "this number comes from one that has a derivative, by way of a text, where it is lost",
    label = "reads a number",
    note = "write `ad::stop_gradient(..)` around the number that the text is made of, if this is what you mean"
)]
pub trait OfNoText {}

/// The fallback for types of which nothing is known. Those that hold a number have a method of their own.
pub trait MayBeRead {
    /// Says that there is no number.
    #[inline(always)]
    fn is_no_number(&self) {}
}

impl<T: ?Sized> MayBeRead for Read<'_, T> {}

macro_rules! numbers {
    ($($type:ty),*) => {$(
        impl<S: crate::Real> Read<'_, $type> {
            /// Says that there is one.
            #[inline(always)]
            pub fn is_no_number(&self)
            where
                S: OfNoText,
            {
            }
        }
    )*};
}

numbers!(S, Option<S>, Vec<S>);

impl<S: crate::Real, E> Read<'_, Result<S, E>> {
    /// Says that there may be one.
    #[inline(always)]
    pub fn is_no_number(&self)
    where
        S: OfNoText,
    {
    }
}
