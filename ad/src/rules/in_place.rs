//! The rows of rules of methods that change a sequence.
//!
//! ```text
//! insert(index: usize; value: Element)
//!     => |before, after, (), g| { .. (g, (), inserted) };
//! ```
//!
//! A row names the method, its two siblings, its arguments (first indices and lengths, then, after `;`,
//! an element or a slice), and the pullback: from the lengths before and after, the cotangent of the result and
//! that of what the sequence holds afterwards to that of what it held before and those of the
//! arguments. What changes the sequence changes its tangent alike, so the pushforward is the method, called on
//! tangents; where they need another one, it stands before the pullback.

/// Rules of methods that change what `$access` returns, whose tangent is a `$held` and whose cotangent a
/// `$cotangent`.
macro_rules! in_place {
    ($access:ident [$held:ty] [$cotangent:ty] $(
        $(#[$doc:meta])*
        $method:ident($($index:ident: usize),* $(; $value:ident: $kind:ident)?)
        $(-> $R:ty)? $(where Element: $bound:ident)? $(, |$tangent:ident| $push:expr)?
        => |$before:pat_param, $after:pat_param, $result:pat_param, $g:ident| $pull:expr;
    )*) => {
        pastey::paste! {$(
            in_place!(@siblings $access [$held] [$cotangent] [$(#[$doc])*]
                $method [<$method _vjp>] [<$method _jvp>]
                ($($index)*) ($($value: $kind)?) [$($R)?] [$($bound)?] [$(|$tangent| $push)?]
                |$before, $after, $result, $g| $pull);
        )*}
    };
    (@siblings $access:ident $held:tt $cotangent:tt $doc:tt $method:ident $vjp:ident $jvp:ident
        $indices:tt $value:tt [] $($rest:tt)*) => {
        in_place!(@siblings $access $held $cotangent $doc $method $vjp $jvp $indices $value [()] $($rest)*);
    };
    (@siblings $access:ident [$held:ty] [$cotangent:ty] [$($doc:tt)*] $method:ident $vjp:ident $jvp:ident
        ($($index:ident)*) ($($value:ident: $kind:ident)?) [$R:ty] [$($bound:ident)?] $push:tt
        |$before:pat_param, $after:pat_param, $result:pat_param, $g:ident| $pull:expr) => {
        $($doc)*
        #[inline]
        #[track_caller]
        #[allow(unused_mut, unused_parens, unused_variables)]
        fn $vjp(
            &mut self,
            $($index: usize,)*
            $($value: in_place!(@type $kind),)?
        ) -> (
            $R,
            impl FnOnce(Tangent<$R>, $cotangent) -> (
                $cotangent $(, in_place!(@unit $index))* $(, in_place!(@pulled $kind))?
            ) + use<Self>,
        )
        $(where Self::Element: $bound)?
        {
            let sequence = self.$access();
            let $before = sequence.len();
            let result = sequence.$method($($index,)* $($value)?);
            let $after = sequence.len();
            (result, move |$result: Tangent<$R>, mut $g: $cotangent| $pull)
        }

        #[doc = concat!("Changes the tangent alike, by `", stringify!($method), "`.")]
        #[inline]
        #[track_caller]
        fn $jvp(
            &mut self,
            $($index: usize,)*
            $($value: in_place!(@type $kind),)?
            tangent: &mut $held,
            $(_: in_place!(@unit $index),)*
            $(dot: in_place!(@dot $kind $value),)?
        ) -> ($R, Tangent<$R>)
        $(where Self::Element: $bound)?
        {
            let result = self.$access().$method($($index,)* $($value)?);
            (result, in_place!(@push $method tangent ($($index,)* $(in_place!(@own dot $value))?) $push))
        }
    };
    (@unit $index:ident) => { () };
    (@type Element) => { Self::Element };
    (@type Slice) => { &[Self::Element] };
    (@dot Element $value:ident) => { Tangent<Self::Element> };
    (@dot Slice $value:ident) => { &[Tangent<Self::Element>] };
    (@pulled Element) => { Tangent<Self::Element> };
    (@pulled Slice) => { Vec<Tangent<Self::Element>> };
    (@own $dot:ident $value:ident) => { $dot };
    (@push $method:ident $held:ident ($($argument:expr),* $(,)?) []) => { $held.$method($($argument),*) };
    (@push $method:ident $held:ident ($($argument:expr),* $(,)?) [|$tangent:ident| $push:expr]) => {{
        let $tangent = ($held, $($argument),*);
        $push
    }};
}

pub(super) use in_place;
