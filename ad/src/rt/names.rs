//! Whether a function and its derivative belong together.
//!
//! `g` is looked up among the values, `g::vjp` among the types. A function that hides another one of its
//! name does not hide that one's derivatives, so that `g(x)` and `g::vjp(x)` could be of two functions.
//! What the compiler does not see there, debug builds do: both have one path. A macro of the user's may
//! have the name of one of the standard library, too.

use core::any::type_name;
use core::marker::PhantomData;

/// Compiles for one function, under two paths.
#[inline(always)]
pub fn same_function<F>(_: F, _: F) {}

/// A method as a function: of what it is called on, and of what else `Kind` says.
pub trait Method<Receiver, Kind> {}

macro_rules! methods {
    ($(($($argument:ident)*))*) => {$(
        impl<F, Receiver, Result, $($argument),*> Method<Receiver, ($($argument,)* Result,)> for F where
            F: FnOnce(Receiver $(, $argument)*) -> Result
        {
        }
    )*};
}

methods! {
    ()
    (A)
    (A B)
    (A B C)
    (A B C D)
    (A B C D E)
    (A B C D E G)
    (A B C D E G H)
}

/// Compiles where a macro changes nothing.
#[inline(always)]
pub fn changes_nothing(_: impl Fn()) {}

/// The value of a macro; compiles where it changes nothing.
#[inline(always)]
pub fn unchanging<R>(value: impl Fn() -> R) -> R {
    value()
}

/// Compiles where a macro makes text.
#[inline(always)]
pub fn text(text: String) -> String {
    text
}

/// What the name of a method leads to: in a type, and in one of its traits.
pub struct Found<F, G>(pub F, pub G);

/// The method of the trait.
pub struct OfTrait;

/// A name of the type itself, which hides that of the trait.
pub struct OfType;

impl<F> Found<F, F> {
    /// Whose method it is.
    #[inline(always)]
    pub fn owner(&self) -> OfTrait {
        OfTrait
    }

    /// What it is called on, and what that is to be.
    #[inline(always)]
    pub fn receivers(&self) -> (PhantomData<()>, PhantomData<()>) {
        (PhantomData, PhantomData)
    }
}

/// Two methods of one name. One method has a method of its own.
pub trait Hidden<F, G> {
    /// Whose method it is.
    #[inline(always)]
    fn owner(&self) -> OfType {
        OfType
    }

    /// What both are called on.
    #[inline(always)]
    fn receivers<R, S, Kind, Other>(&self) -> (PhantomData<R>, PhantomData<S>)
    where
        F: Method<R, Kind>,
        G: Method<S, Other>,
    {
        (PhantomData, PhantomData)
    }
}

impl<F, G> Hidden<F, G> for Found<F, G> {}

/// That a method belongs to what its derivative belongs to.
#[diagnostic::on_unimplemented(
    message = "a method of the type hides this one of the trait wherever it is called, and has no derivative: that of the trait would be taken in its place",
    label = "the type has a method of this name",
    note = "put `#[differentiable]` on that method, too, if it is yours, or give one of them another name"
)]
pub trait SameOwner {}

#[diagnostic::do_not_recommend]
impl SameOwner for (OfTrait, OfTrait) {}
#[diagnostic::do_not_recommend]
impl SameOwner for (OfType, OfType) {}

/// Compiles where a method and its derivative belong together.
#[inline(always)]
pub fn same_owner<O: SameOwner>(_method_and_derivative: O) {}

/// That two methods are called on the same.
#[diagnostic::on_unimplemented(
    message = "a method of the type and this one of the trait have one name and take `self` in different ways: which of them a call means depends on how it is written, and the derivative of the other would be taken",
    label = "the type has a method of this name",
    note = "let both take `self`, `&self` or `&mut self`, or give one of them another name"
)]
pub trait SameReceiver {}

#[diagnostic::do_not_recommend]
impl<Receiver> SameReceiver for (PhantomData<Receiver>, PhantomData<Receiver>) {}

/// Compiles where a method of a type and one of a trait are called on the same.
#[inline(always)]
pub fn same_receiver<R: SameReceiver>(_of_type_and_of_trait: R) {}

/// Stands in the place of the type that would have the derivatives of a function.
pub enum FunctionWithoutDerivative {}

/// That there are derivatives.
#[diagnostic::on_unimplemented(
    message = "this function has no derivative",
    label = "is called with what has one",
    note = "put `#[differentiable]` on it, if it is yours",
    note = "or write its derivative by hand: `#[differentiable(vjp = rule)] use module::function;`",
    note = "or say that nothing is to flow through it: `ad::no_diff(|| function(x))`"
)]
pub trait FunctionWithDerivative {}

macro_rules! modes {
    ($($name:ident)*) => {
        /// What a type with the derivatives of a function has. It is asked for where that type is missing.
        #[allow(missing_docs)]
        pub trait Modes {
            $(fn $name();)*
        }

        impl<T: FunctionWithDerivative> Modes for T {
            $(fn $name() {})*
        }
    };
}

modes! {
    vjp vjp_onto jvp named
    argument_0 argument_1 argument_2 argument_3
    argument_0_forward argument_1_forward argument_2_forward argument_3_forward
    passed_0 passed_1 passed_2 passed_3
}

/// That there are derivatives of a method.
#[diagnostic::on_unimplemented(
    message = "this method has no derivative",
    label = "is called with what has one",
    note = "put `#[differentiable]` on it, or on its `impl` block, if it is yours",
    note = "or write its derivative by hand: `#[differentiable(vjp = rule)]` on it, or on a function that calls it",
    note = "or say that nothing is to flow through it: `ad::no_diff(|| x.method())`"
)]
pub trait MethodWithDerivative {}

/// Whether the path of a function is another than `path`; an empty one is not known.
#[inline(always)]
pub fn has_other_name<F>(_function: &F, path: &str) -> bool {
    !path.is_empty() && without_arguments(type_name::<F>()) != without_arguments(path)
}

/// Says that there is no derivative of a function.
#[cold]
#[track_caller]
pub fn other_function<F>(_function: &F, path: &str) -> ! {
    panic!(
        "`{}` has no derivative: in its place that of `{path}` would be taken, which has the same name; \
         put `#[differentiable]` on it, or give it another name",
        type_name::<F>()
    )
}

/// Makes sure that `D` is the function for one mode of the derivative of the function `F`.
#[track_caller]
pub fn check_mode_of<F, D>(function: &F, _derivative: &D) {
    let path = without_arguments(type_name::<D>());
    let path = path.strip_suffix("::vjp").or_else(|| path.strip_suffix("::jvp"));
    if let Some(path) = path
        && has_other_name(function, path)
    {
        other_function(function, path);
    }
}

/// A path without the type arguments at its end.
// Debug builds come here at each call of a function: it is compiled with who calls, and looks at bytes.
#[inline]
fn without_arguments(path: &str) -> &str {
    let mut open = 0;
    for (index, byte) in path.bytes().enumerate().rev() {
        match byte {
            b'>' if path[..index].ends_with('-') => {}
            b'>' => open += 1,
            b'<' => open -= 1,
            _ => {}
        }
        if open == 0 {
            return if byte == b'<' { &path[..index] } else { path };
        }
    }
    path
}

/// Says that a call that is never made would give what a value is.
#[inline(always)]
pub fn same_type<T>(_never: &Option<T>, _value: &T) {}

/// Makes sure that `$function` has the path `$path`: in debug builds, or always. Its type arguments follow from how
/// it is called, and from the result of its derivative, which [`same_result`](crate::same_result) gives.
#[doc(hidden)]
#[macro_export]
macro_rules! check_name {
    ($result:ident = $function:expr, $path:expr, ($($argument:expr),*)) => {
        #[cfg(debug_assertions)]
        $crate::check_name!(always $result = $function, $path, ($($argument),*));
    };
    (always $result:ident = $function:expr, $path:expr, ($($argument:expr),*)) => {
        let mut $result = ::core::option::Option::None;
        {
            let function = $function;
            if $crate::rt::has_other_name(&function, $path) {
                $result = ::core::option::Option::Some(function($($argument),*));
                $crate::rt::other_function(&function, $path);
            }
        }
    };
}

/// Says that the function of [`check_name`](crate::check_name) and its derivative have results of one type.
#[doc(hidden)]
#[macro_export]
macro_rules! same_result {
    ($result:ident, $value:ident) => {
        #[cfg(debug_assertions)]
        $crate::same_result!(always $result, $value);
    };
    (always $result:ident, $value:ident) => {
        $crate::rt::same_type(&$result, &$value);
    };
}

#[cfg(test)]
mod tests {
    use super::without_arguments;

    #[test]
    fn arguments_at_the_end_are_left_out() {
        for (path, name) in [
            ("m::f", "m::f"),
            ("m::f<f64>", "m::f"),
            ("m::f<a::B<C>, fn(f64) -> D<E>>", "m::f"),
            ("<a::B<C> as d::E<F>>::f<G>", "<a::B<C> as d::E<F>>::f"),
            ("<a::B as c::D>::f", "<a::B as c::D>::f"),
        ] {
            assert_eq!(without_arguments(path), name);
        }
    }
}
