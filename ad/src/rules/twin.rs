//! The rows of rules of functions, whose derivative is a type of the same name.
//!
//! A row names the function with its type parameters, gives its value, and the linear map from the tangent
//! of its argument, or the tuple of those of its arguments, to that of the result. The map is the same
//! for all arguments, so that the pullback is a function.

/// The derivatives of functions, one a row.
macro_rules! twins {
    ($(
        $(#[$doc:meta])*
        $name:ident[$($generics:tt)*]($($x:ident: $X:ty),*) -> $R:ty
            = $value:expr => $map:expr;
    )*) => { pastey::paste! {$(
        #[doc = concat!("The derivative of `", stringify!($name), "`.")]
        #[doc = ""]
        $(#[$doc])*
        #[allow(non_camel_case_types)]
        pub enum $name {}

        #[allow(unused_parens)]
        impl $name {
            /// The value and the pullback.
            #[inline(always)]
            pub fn vjp<$($generics)*>(
                $($x: $X),*
            ) -> ($R, fn(Tangent<$R>) -> ($(Tangent<$X>),*)) {
                ($value, |cotangent| Linear::<($(Tangent<$X>),*), Tangent<$R>>::pull($map, cotangent))
            }

            /// The value and its derivative along tangents.
            #[inline(always)]
            pub fn jvp<$($generics)*>(
                $($x: $X,)* $([<$x _dot>]: Tangent<$X>),*
            ) -> ($R, Tangent<$R>) {
                ($value, Linear::<($(Tangent<$X>),*), Tangent<$R>>::push($map, ($([<$x _dot>]),*)))
            }
        }
    )*}};
}

pub(super) use twins;
