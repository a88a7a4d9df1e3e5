//! The rows that rules are written in.
//!
//! A row names a function, its two siblings, its arguments, and one of three things from which both
//! siblings follow:
//!
//! ```text
//! sqrt sqrt_vjp sqrt_jvp (x) = root => Times(unless(root.cmpeq(Self::ZERO), Self::HALF / root));
//! extend extend_vjp extend_jvp (v, last: Self::S) -> Self::V3: |g| (g.truncate(), g.z);
//! reject_from reject_from_vjp reject_from_jvp (a, onto: Self) -> Self as geometry::reject_from;
//! ```
//!
//! - `=>` gives the partial derivative by each argument, as a [linear map](super::linear) from its
//!   tangents to those of the result: one map, or a tuple of as many as there are arguments. The
//!   names of the arguments and, after `=`, one for the value stand for their values. The pullback
//!   applies the adjoint of each map to the cotangent, the pushforward adds up what each map makes of its
//!   tangent.
//! - `:` says that the function is linear in all arguments at once, and gives its adjoint. The
//!   pushforward is the function, of the tangents.
//! - `as` names a differentiable function of the numbers of the arguments that computes the same.
//!
//! The value is that of the function itself in any case. An argument without a type is the
//! receiver, `&` before it one by reference; without any types all arguments and the result are
//! `Self`.
//!
//! A table makes a trait of its rows: `for every Real`, whose methods have bodies, or `for` a list of
//! types, on each of which the rows are written out, so that they can call what each has by itself.

/// A trait of rules, one a row.
macro_rules! rules {
    ($(#[$doc:meta])* $rules:ident for every $bound:ident { $($rows:tt)* }) => {
        $(#[$doc])*
        #[allow(clippy::type_complexity, clippy::too_many_arguments)]
        pub trait $rules: $bound {
            rules!(@rows [complete use<Self>] $($rows)*);
        }

        impl<T: $bound> $rules for T {}
    };
    ($(#[$doc:meta])* $rules:ident: $bound:ident for $($type:ident)* { $($rows:tt)* }) => {
        $(#[$doc])*
        #[allow(clippy::type_complexity, clippy::too_many_arguments)]
        pub trait $rules: $bound {
            rules!(@rows [declared use<Self>] $($rows)*);
        }

        rules!(@impls $rules { $($rows)* } $($type)*);
    };
    (@impls $rules:ident $rows:tt $($type:ident)*) => {$(
        #[allow(clippy::type_complexity, clippy::too_many_arguments)]
        impl $rules for $type {
            rules!(@impl $rows);
        }
    )*};
    (@impl { $($rows:tt)* }) => { rules!(@rows [defined use<>] $($rows)*); };

    (@rows $form:tt $(
        $(#[$doc:meta])*
        $method:ident $vjp:ident $jvp:ident $arguments:tt $(-> $R:ty)? $(= $value:ident)?
        $(as $formula:path)? $(: $adjoint:expr)? $(=> $partials:expr)?;
    )*) => {$(
        rules!(@row $form [$(#[$doc])*] $method $vjp $jvp $arguments [$($R)?] [$($value)?]
            [$(partials $partials)? $(adjoint $adjoint)? $(formula $formula)?]);
    )*};

    // Whether there is a receiver, and what the result is.
    (@row $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident ($x:ident $(, $y:ident)*) [] $($rest:tt)*) => {
        rules!(@named $form $doc $method $vjp $jvp [value $x] [] [$([$y: Self])*] [Self] $($rest)*);
    };
    (@row $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident
        ($x:ident $(, $y:ident: $Y:ty)*) [$R:ty] $($rest:tt)*) => {
        rules!(@named $form $doc $method $vjp $jvp [value $x] [] [$([$y: $Y])*] [$R] $($rest)*);
    };
    (@row $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident
        (&$x:ident $(, $y:ident: $Y:ty)*) [$R:ty] $($rest:tt)*) => {
        rules!(@named $form $doc $method $vjp $jvp [reference $x] [] [$([$y: $Y])*] [$R] $($rest)*);
    };
    (@row $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident
        ($($y:ident: $Y:ty),*) [$R:ty] $($rest:tt)*) => {
        rules!(@named $form $doc $method $vjp $jvp [] [] [$([$y: $Y])*] [$R] $($rest)*);
    };

    // Gives each argument a name for its tangent: every step has a `dot` of its own.
    (@named $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident $receiver:tt [$($named:tt)*]
        [[$y:ident: $Y:ty] $($more:tt)*] $($rest:tt)*) => {
        rules!(@named $form $doc $method $vjp $jvp $receiver [$($named)* [$y dot $Y]] [$($more)*]
            $($rest)*);
    };
    (@named $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident $receiver:tt $named:tt []
        $R:tt [] $rule:tt) => {
        rules!(@siblings $form $doc $method $vjp $jvp $receiver $named $R value $rule);
    };
    (@named $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident $receiver:tt $named:tt []
        $R:tt [$value:ident] $rule:tt) => {
        rules!(@siblings $form $doc $method $vjp $jvp $receiver $named $R $value $rule);
    };

    // The signatures and bodies.
    (@siblings $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident [value $x:ident]
        [$([$y:ident $dot:ident $Y:ty])*] [$R:ty] $value:ident $rule:tt) => {
        rules!(@sibling $form $doc $method "The pullback of `"
            [$vjp(self $(, $y: $Y)*) -> ($R, impl FnOnce(Tangent<$R>) -> rules!(@tuple Tangent<Self> $(, Tangent<$Y>)*))]
            {
                let $x = self;
                let $value = Self::$method($x $(, $y)*);
                ($value, move |cotangent: Tangent<$R>| {
                    rules!(@pull cotangent $R, [$x Self] $([$y $Y])*; $rule)
                })
            });
        rules!(@sibling $form $doc $method "The derivative along tangents of `"
            [$jvp(self, $($y: $Y,)* tangent: Tangent<Self> $(, $dot: Tangent<$Y>)*) -> ($R, Tangent<$R>)]
            {
                let $x = self;
                let $value = Self::$method($x $(, $y)*);
                ($value, rules!(@push [Self::$method(tangent $(, $dot)*)] $R, [$x tangent Self] $([$y $dot $Y])*; $rule))
            });
    };
    (@siblings [$form:ident $($captured:tt)*] $doc:tt $method:ident $vjp:ident $jvp:ident [reference $x:ident]
        [$([$y:ident $dot:ident $Y:ty])*] [$R:ty] $value:ident $rule:tt) => {
        rules!(@sibling [$form $($captured)*] $doc $method "The pullback of `"
            [$vjp(&self $(, $y: $Y)*) -> (
                $R,
                impl FnOnce(Tangent<$R>) -> rules!(@tuple Tangent<Self> $(, Tangent<$Y>)*) + $($captured)*,
            )]
            {
                let $x = *self;
                let $value = Self::$method(&$x $(, $y)*);
                ($value, move |cotangent: Tangent<$R>| {
                    rules!(@pull cotangent $R, [$x Self] $([$y $Y])*; $rule)
                })
            });
        rules!(@sibling [$form $($captured)*] $doc $method "The derivative along tangents of `"
            [$jvp(&self, $($y: $Y,)* tangent: &Tangent<Self> $(, $dot: Tangent<$Y>)*) -> ($R, Tangent<$R>)]
            {
                let ($x, tangent) = (*self, *tangent);
                let $value = Self::$method(&$x $(, $y)*);
                ($value, rules!(@push [Self::$method(&tangent $(, $dot)*)] $R, [$x tangent Self] $([$y $dot $Y])*; $rule))
            });
    };
    (@siblings $form:tt $doc:tt $method:ident $vjp:ident $jvp:ident []
        [$([$y:ident $dot:ident $Y:ty])*] [$R:ty] $value:ident $rule:tt) => {
        rules!(@sibling $form $doc $method "The pullback of `"
            [$vjp($($y: $Y),*) -> ($R, impl FnOnce(Tangent<$R>) -> rules!(@tuple $(Tangent<$Y>),*))]
            {
                let $value = Self::$method($($y),*);
                ($value, move |cotangent: Tangent<$R>| {
                    rules!(@pull cotangent $R, $([$y $Y])*; $rule)
                })
            });
        rules!(@sibling $form $doc $method "The derivative along tangents of `"
            [$jvp($($y: $Y,)* $($dot: Tangent<$Y>),*) -> ($R, Tangent<$R>)]
            {
                let $value = Self::$method($($y),*);
                ($value, rules!(@push [Self::$method($($dot),*)] $R, $([$y $dot $Y])*; $rule))
            });
    };
    (@tuple $part:ty) => { $part };
    (@tuple $($part:ty),*) => { ($($part),*) };

    (@sibling [declared $($captured:tt)*] [$($doc:tt)*] $method:ident $says:literal [$($signature:tt)*] $body:tt) => {
        #[doc = concat!($says, stringify!($method), "`.")]
        #[doc = ""]
        $($doc)*
        fn $($signature)*;
    };
    (@sibling [complete $($captured:tt)*] [$($doc:tt)*] $method:ident $says:literal [$($signature:tt)*] $body:tt) => {
        #[doc = concat!($says, stringify!($method), "`.")]
        #[doc = ""]
        $($doc)*
        #[inline(always)]
        #[allow(unused_variables, unused_parens)]
        fn $($signature)* $body
    };
    (@sibling [defined $($captured:tt)*] $doc:tt $method:ident $says:literal [$($signature:tt)*] $body:tt) => {
        #[inline(always)]
        #[allow(unused_variables, unused_parens)]
        fn $($signature)* $body
    };

    (@pull $cotangent:ident $R:ty, $([$x:ident $X:ty])*; [partials $partials:expr]) => {{
        let ($($x),*) = $partials;
        ($(Linear::<Tangent<$X>, Tangent<$R>>::pull($x, $cotangent)),*)
    }};
    (@pull $cotangent:ident $R:ty, $([$x:ident $X:ty])*; [adjoint $adjoint:expr]) => {
        linear::adjoint($cotangent, $adjoint)
    };
    (@pull $cotangent:ident $R:ty, $([$x:ident $X:ty])*; [formula $formula:path]) => {{
        use $formula as formula;
        let (_, pullback) = formula::vjp($($x.numbers()),*);
        Numbers::of_numbers(pullback($cotangent.numbers()))
    }};
    (@push [$pushed:expr] $R:ty, $([$x:ident $dot:ident $X:ty])*; [partials $partials:expr]) => {{
        let ($($x),*) = $partials;
        rules!(@sum $(Linear::<Tangent<$X>, Tangent<$R>>::push($x, $dot)),*)
    }};
    (@sum $first:expr $(, $more:expr)*) => { $first $(+ $more)* };
    (@push [$pushed:expr] $R:ty, $([$x:ident $dot:ident $X:ty])*; [adjoint $adjoint:expr]) => {
        $pushed
    };
    (@push [$pushed:expr] $R:ty, $([$x:ident $dot:ident $X:ty])*; [formula $formula:path]) => {{
        use $formula as formula;
        let (_, along) = formula::jvp($($x.numbers(),)* $($dot.numbers()),*);
        Numbers::of_numbers(along)
    }};
}

pub(super) use rules;
