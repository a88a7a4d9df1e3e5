//! The rows of rules of methods that change a sequence.
//!
//! ```text
//! insert(index: usize; value: Element)
//!     => |before, after, (), g| { .. (g, (), inserted) };
//! ```
//!
//! A row names the method, its arguments (first indices and lengths, then, after `;`, an element or a
//! slice), and the pullback: from the lengths before and after, the cotangent of the result and that of
//! what the sequence holds afterwards to that of what it held before and those of the arguments. What
//! changes the sequence changes its tangent alike, so the pushforward is the method, called on tangents;
//! where they need another one, it stands before the pullback.

/// Rules of methods that change what `$access` returns, whose tangent is a `$held` and whose cotangent a
/// `$cotangent`.
macro_rules! in_place {
    ($access:ident [$held:ty] [$cotangent:ty] $(
        $(#[$doc:meta])*
        $name:ident($($index:ident: usize),* $(; $value:ident: $kind:ident)?)
        $(-> $R:ty)? $(where Element: $bound:ident)? $(, |$tangents:ident| $push:expr)?
        => |$before:pat_param, $after:pat_param, $result:pat_param, $g:ident| $pull:expr;
    )*) => { pastey::paste! {$(
        #[doc = concat!("The pullback of `", stringify!($name), "`.")]
        #[doc = ""]
        $(#[$doc])*
        #[inline]
        #[track_caller]
        #[allow(unused_mut, unused_parens, unused_variables)]
        fn [<$name _vjp>](
            &mut self,
            $($index: usize,)*
            $($value: in_place!(@type $kind),)?
        ) -> (
            in_place!(@type $($R)?),
            impl FnOnce(in_place!(@tangent $($R)?), $cotangent) -> (
                $cotangent $(, in_place!(@unit $index))* $(, in_place!(@pulled $kind))?
            ) + use<Self>,
        )
        $(where Self::Element: $bound)?
        {
            let sequence = self.$access();
            let $before = sequence.len();
            let result = sequence.$name($($index,)* $($value)?);
            let $after = sequence.len();
            (result, move |$result: in_place!(@tangent $($R)?), mut $g: $cotangent| $pull)
        }

        #[doc = concat!("Changes the tangent alike, by `", stringify!($name), "`.")]
        #[inline]
        #[track_caller]
        fn [<$name _jvp>](
            &mut self,
            $($index: usize,)*
            $($value: in_place!(@type $kind),)?
            tangent: &mut $held,
            $(_: in_place!(@unit $index),)*
            $([<$value _dot>]: in_place!(@tangent $kind),)?
        ) -> (in_place!(@type $($R)?), in_place!(@tangent $($R)?))
        $(where Self::Element: $bound)?
        {
            let result = self.$access().$name($($index,)* $($value)?);
            let along = in_place!(@push $name tangent ($($index,)* $([<$value _dot>])?)
                $(|$tangents| $push)?);
            (result, along)
        }
    )*}};
    (@unit $index:ident) => { () };
    (@type) => { () };
    (@type Element) => { Self::Element };
    (@type Slice) => { &[Self::Element] };
    (@type $R:ty) => { $R };
    (@tangent) => { () };
    (@tangent Element) => { Tangent<Self::Element> };
    (@tangent Slice) => { &[Tangent<Self::Element>] };
    (@tangent $R:ty) => { Tangent<$R> };
    (@pulled Element) => { Tangent<Self::Element> };
    (@pulled Slice) => { Vec<Tangent<Self::Element>> };
    (@push $name:ident $held:ident ($($argument:expr),* $(,)?)) => { $held.$name($($argument),*) };
    (@push $name:ident $held:ident ($($argument:expr),* $(,)?) |$tangents:ident| $push:expr) => {{
        let $tangents = ($held, $($argument),*);
        $push
    }};
}

pub(super) use in_place;
