//! The rows that rules are written in.
//!
//! A row names a function, its arguments, and one of three things from which both siblings follow:
//!
//! ```text
//! sinc(x) => Times(unless(x.cmpeq(Self::ZERO), (x.cos() - x.sin() / x) / x));
//! extend(v, z: Self::S) -> Self::V3: |g| (g.truncate(), g.z);
//! reject_from(v, onto: Self) -> Self as vector::reject_from;
//! ```
//!
//! - `=>` gives the partial derivative by each argument, a [linear map](super::linear) from its tangents to
//!   those of the result: one map, or a tuple of as many as there are arguments. The names of the
//!   arguments stand for their values, and so does one for the result, as `root` in `sqrt(x) = root => ..`.
//!   The pullback applies the adjoint of each map to the cotangent, the pushforward adds up what each
//!   map makes of its tangent.
//! - `:` says that the function is linear in all arguments at once, and gives its adjoint. The
//!   pushforward is the function, of the tangents.
//! - `as` names a differentiable function of the numbers of the arguments that computes the same.
//!
//! The value is that of the function itself in any case. An argument without a type is the
//! receiver, `&` before it one by reference, as before a first or only other argument; without any
//! types all arguments and the result are `Self`.
//!
//! A table makes a trait of its rows: `for every Real`, say, or `for` a list of types, on each of which the
//! rows are written out, so that they can call what each has by itself.
//!
//! Turned down: a table of pushforwards beside that of pullbacks (two to keep in agreement, with all
//! their singular points); pulling unit vectors back for every function with a vector as result (three
//! pullbacks, and the zeros in them do not vanish from products with numbers that may be infinite).

/// A trait of rules, one a row.
macro_rules! rules {
    ($(#[$doc:meta])* $rules:ident for every $bound:ident { $($rows:tt)* }) => {
        $(#[$doc])*
        pub trait $rules: $bound {
            rules!(@rows [defined use<Self>] $($rows)*);
        }

        impl<T: $bound> $rules for T {}
    };
    ($(#[$doc:meta])* $rules:ident: $bound:ident for $($type:ident)* { $($rows:tt)* }) => {
        $(#[$doc])*
        pub trait $rules: $bound {
            rules!(@rows [declared use<Self>] $($rows)*);
        }

        rules!(@impls $rules { $($rows)* } $($type)*);
    };
    (@impls $rules:ident $rows:tt $($type:ident)*) => {$(
        impl $rules for $type {
            rules!(@impl $rows);
        }
    )*};
    (@impl { $($rows:tt)* }) => { rules!(@rows [defined use<>] $($rows)*); };

    (@rows $form:tt $(
        $(#[$doc:meta])*
        $name:ident $arguments:tt $(-> $R:ty)? $(= $value:ident)?
        $(as $formula:path)? $(: $adjoint:expr)? $(=> $partials:expr)?;
    )*) => {
        pastey::paste! {$(
            rules!(@row [$form [$(#[$doc])*] $name [<$name _vjp>] [<$name _jvp>]] $arguments [$($R)?]
                [$($value,)? _value] [$(partials $partials)? $(adjoint $adjoint)? $(formula $formula)?]);
        )*}
    };

    // The parameters, the call and the tangents, by what is taken by reference.
    (@row $head:tt ($x:ident $(, $y:ident)*) [] $($rest:tt)*) => {
        rules!(@row $head ($x $(, $y: Self)*) [Self] $($rest)*);
    };
    (@row $head:tt ($x:ident $(, $y:ident: $Y:ty)*) $($rest:tt)*) => {
        pastey::paste! {
            rules!(@siblings $head [self $(, $y: $Y)*] [let $x = self;] [$x $(, $y)*]
                [[<$x _dot>]: $crate::Tangent<Self> $(, [<$y _dot>]: $crate::Tangent<$Y>)*] []
                [[<$x _dot>] $(, [<$y _dot>])*]
                [$x [<$x _dot>] Self $(, $y [<$y _dot>] $Y)*] $($rest)*);
        }
    };
    (@row $head:tt (&$x:ident $(, $y:ident: $Y:ty)*) $($rest:tt)*) => {
        pastey::paste! {
            rules!(@siblings $head [&self $(, $y: $Y)*] [let $x = *self;] [&$x $(, $y)*]
                [[<$x _dot>]: &$crate::Tangent<Self> $(, [<$y _dot>]: $crate::Tangent<$Y>)*]
                [let [<$x _dot>] = *[<$x _dot>];] [&[<$x _dot>] $(, [<$y _dot>])*]
                [$x [<$x _dot>] Self $(, $y [<$y _dot>] $Y)*] $($rest)*);
        }
    };
    (@row $head:tt (&$x:ident, &$y:ident: $Y:ty) $($rest:tt)*) => {
        pastey::paste! {
            rules!(@siblings $head [&self, $y: &$Y] [let ($x, $y) = (*self, *$y);] [&$x, &$y]
                [[<$x _dot>]: &$crate::Tangent<Self>, [<$y _dot>]: &$crate::Tangent<$Y>]
                [let ([<$x _dot>], [<$y _dot>]) = (*[<$x _dot>], *[<$y _dot>]);]
                [&[<$x _dot>], &[<$y _dot>]]
                [$x [<$x _dot>] Self, $y [<$y _dot>] $Y] $($rest)*);
        }
    };
    (@row $head:tt (&$y:ident: $Y:ty) $($rest:tt)*) => {
        pastey::paste! {
            rules!(@siblings $head [$y: &$Y] [let $y = *$y;] [&$y]
                [[<$y _dot>]: &$crate::Tangent<$Y>] [let [<$y _dot>] = *[<$y _dot>];]
                [&[<$y _dot>]] [$y [<$y _dot>] $Y] $($rest)*);
        }
    };
    (@row $head:tt ($($y:ident: $Y:ty),*) $($rest:tt)*) => {
        pastey::paste! {
            rules!(@siblings $head [$($y: $Y),*] [] [$($y),*]
                [$([<$y _dot>]: $crate::Tangent<$Y>),*] [] [$([<$y _dot>]),*]
                [$($y [<$y _dot>] $Y),*] $($rest)*);
        }
    };

    (@siblings [[$form:ident $($captured:tt)*] $doc:tt $name:ident $vjp:ident $jvp:ident]
        [$($parameters:tt)*] [$($receive:tt)*] [$($values:tt)*]
        [$($tangents:tt)*] [$($receive_tangents:tt)*] [$($dots:tt)*]
        [$($x:ident $dot:ident $X:ty),*] [$R:ty] [$value:ident $($_:tt)*] $rule:tt) => {
        rules!(@sibling $form "The pullback of `" $name $doc [
            $vjp($($parameters)*) -> (
                $R,
                impl FnOnce($crate::Tangent<$R>) -> rules!(@parts $($X),*) + $($captured)*,
            )
        ] {
            $($receive)*
            let $value = Self::$name($($values)*);
            ($value, move |cotangent: $crate::Tangent<$R>| {
                rules!(@pull $rule cotangent $R, $($x $X),*)
            })
        });
        rules!(@sibling $form "The derivative along tangents of `" $name $doc [
            $jvp($($parameters)*, $($tangents)*) -> ($R, $crate::Tangent<$R>)
        ] {
            $($receive)*
            let $value = Self::$name($($values)*);
            $($receive_tangents)*
            let along = rules!(@push $rule (Self::$name($($dots)*)) $R, $($x $dot $X),*);
            ($value, along)
        });
    };
    (@parts $X:ty) => { $crate::Tangent<$X> };
    (@parts $($X:ty),*) => { ($($crate::Tangent<$X>),*) };

    (@sibling declared $says:literal $name:ident [$($doc:tt)*] [$($signature:tt)*] $body:tt) => {
        #[doc = concat!($says, stringify!($name), "`.")]
        #[doc = ""]
        $($doc)*
        fn $($signature)*;
    };
    (@sibling defined $says:literal $name:ident [$($doc:tt)*] [$($signature:tt)*] $body:tt) => {
        #[doc = concat!($says, stringify!($name), "`.")]
        #[doc = ""]
        $($doc)*
        #[inline(always)]
        #[allow(unused_variables, unused_parens)]
        fn $($signature)* $body
    };

    // What the three kinds of rows make of cotangents and of tangents.
    (@pull [partials $partials:expr] $cotangent:ident $R:ty, $($x:ident $X:ty),*) => {{
        use $crate::{Tangent, rules::linear::Linear};
        let ($($x),*) = $partials;
        ($(Linear::<Tangent<$X>, Tangent<$R>>::pull($x, $cotangent)),*)
    }};
    (@push [partials $partials:expr] $linear:tt $R:ty, $($x:ident $dot:ident $X:ty),*) => {{
        use $crate::{Tangent, rules::linear::Linear};
        let ($($x),*) = $partials;
        let mut along = <Tangent<$R> as $crate::Additive>::zero();
        $(
            let part = Linear::<Tangent<$X>, Tangent<$R>>::push($x, $dot);
            $crate::Additive::accumulate(&mut along, part);
        )*
        along
    }};
    (@pull [adjoint $adjoint:expr] $cotangent:ident $R:ty, $($x:ident $X:ty),*) => {
        $crate::rules::linear::adjoint($cotangent, $adjoint)
    };
    (@push [adjoint $adjoint:expr] $linear:tt $R:ty, $($x:ident $dot:ident $X:ty),*) => { $linear };
    (@pull [formula $formula:path] $cotangent:ident $R:ty, $($x:ident $X:ty),*) => {{
        use $crate::rules::Numbers;
        use $formula as formula;
        let (_, pullback) = formula::vjp($($x.numbers()),*);
        Numbers::of_numbers(pullback($cotangent.numbers()))
    }};
    (@push [formula $formula:path] $linear:tt $R:ty, $($x:ident $dot:ident $X:ty),*) => {{
        use $crate::rules::Numbers;
        use $formula as formula;
        let (_, along) = formula::jvp($($x.numbers(),)* $($dot.numbers()),*);
        Numbers::of_numbers(along)
    }};
}

pub(crate) use rules;
