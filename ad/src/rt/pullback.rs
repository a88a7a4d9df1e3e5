//! Calls of pullbacks whose signature depends on the method that was called.

use super::{NotLent, OfChanged, Take};

/// The method took `self` or `&self`: its pullback wants the cotangent of the result alone.
pub enum Shared {}

/// The method took `&mut self`: its pullback wants the cotangent of what the receiver held
/// afterwards, too. `Kind` is that of [`Take`].
pub struct Exclusive<Kind>(Kind);

/// The pullback of a method that was called on something it may have changed.
///
/// `Kind` is inferred from the signature of the pullback. `Others` are the cotangents of further
/// `&mut` arguments.
pub trait MethodPullback<Cotangent, Receiver: ?Sized, Others, Kind> {
    /// The cotangents of receiver and arguments.
    type Parts;

    /// Calls the pullback. What it returns for the receiver is to be added to the receiver's
    /// cotangent.
    fn pull_back(
        self,
        cotangent: Cotangent,
        receiver: &mut Receiver,
        others: Others,
    ) -> Self::Parts;
}

macro_rules! method_pullbacks {
    ($(($($other:ident),*))*) => {$(
        impl<F, C, R: ?Sized, P, $($other),*> MethodPullback<C, R, ($($other,)*), Shared> for F
        where
            F: FnOnce(C $(, $other)*) -> P,
        {
            type Parts = P;

            #[inline(always)]
            #[allow(non_snake_case)]
            fn pull_back(self, cotangent: C, _: &mut R, ($($other,)*): ($($other,)*)) -> P {
                self(cotangent $(, $other)*)
            }
        }

        impl<F, C, R: ?Sized, T, K, P, $($other),*>
            MethodPullback<C, R, ($($other,)*), Exclusive<(T, K)>> for F
        where
            F: FnOnce(C, T $(, $other)*) -> P,
            R: Take<T, K>,
            K: OfChanged<T>,
        {
            type Parts = P;

            #[inline(always)]
            #[allow(non_snake_case)]
            fn pull_back(
                self,
                cotangent: C,
                receiver: &mut R,
                ($($other,)*): ($($other,)*),
            ) -> P {
                self(cotangent, receiver.take() $(, $other)*)
            }
        }
    )*};
}

method_pullbacks! {
    ()
    (O0)
    (O0, O1)
    (O0, O1, O2)
    (O0, O1, O2, O3)
    (O0, O1, O2, O3, O4)
    (O0, O1, O2, O3, O4, O5)
}

/// What callers lend: a tuple with a member for each parameter. Its type tells a function that is
/// lent cotangents from one that takes the cotangent of a `&mut`.
pub struct Offered<T>(pub T);

/// The function has a parameter whose cotangent callers lend.
pub enum Lending {}

/// The function has none.
pub enum NotLending {}

/// The function has one beside a `&mut` parameter. `Kind` is that of [`Take`].
pub struct ExclusiveLending<Kind>(Kind);

/// The pullback of a function to which cotangents are offered, in the tuple `Offered` with a member
/// for each parameter. `Others` are the cotangents of `&mut` arguments.
///
/// Which of them are taken the signature of the pullback tells; the others are [`NotLent`].
#[diagnostic::on_unimplemented(
    message = "this call changes what it is called on, or takes by `&mut`, where no change is expected",
    label = "changes something",
    note = "give the call a statement of its own before, `let value = object.method(..);`, and use `value` here"
)]
pub trait PullbackOnto<Cotangent, Others, Offered, Kind> {
    /// The cotangents of the arguments.
    type Parts;

    /// Calls the pullback. What it returns for a cotangent that was lent is to be added to what the
    /// lender has left, which is zero.
    fn pull_back(self, cotangent: Cotangent, others: Others, offered: Offered) -> Self::Parts;
}

/// Says that a method has a function beside it that is lent cotangents.
pub struct Lends;

/// Says that it has none.
pub struct LendsNothing;

/// What was found by the name of the function that is lent cotangents: its value and pullback, or nothing, where a
/// reference is called on whose method takes what it refers to by value. (The compiler looks for methods of references
/// first, and of them there is the default.)
pub trait Onto<Own> {
    /// Whether it is the function.
    const IS_FOUND: bool;

    /// Value and pullback, its own or those of `vjp`.
    type Chosen;

    /// Whichever was called.
    fn or(onto: Option<Self>, own: Option<Own>) -> Self::Chosen
    where
        Self: Sized;
}

impl<Own> Onto<Own> for () {
    const IS_FOUND: bool = false;
    type Chosen = Own;

    #[inline(always)]
    fn or(_onto: Option<Self>, own: Option<Own>) -> Own {
        own.expect("the method's own derivative was called")
    }
}

impl<Value, Pullback, Own> Onto<Own> for (Value, Pullback) {
    const IS_FOUND: bool = true;
    type Chosen = Self;

    #[inline(always)]
    fn or(onto: Option<Self>, _own: Option<Own>) -> Self {
        onto.expect("the function that is lent cotangents was called")
    }
}

impl Lends {
    /// Returns `true` if the accumulating pullback is to be called.
    #[inline(always)]
    pub const fn lends<A: Onto<B>, B>(&self, _onto: &Option<A>, _own: &Option<B>) -> bool {
        A::IS_FOUND
    }

    /// Goes on: the function that is lent cotangents is called next.
    #[inline(always)]
    pub const fn lent(&self) {}

    /// What the function that was called returned.
    #[inline(always)]
    pub fn choose<A: Onto<B>, B>(self, onto: Option<A>, own: Option<B>) -> A::Chosen {
        A::or(onto, own)
    }
}

impl LendsNothing {
    /// Returns `true` if the accumulating pullback is to be called.
    #[inline(always)]
    pub const fn lends<A, B>(&self, _onto: &Option<A>, _own: &Option<B>) -> bool {
        false
    }

    /// Never returns: what follows changes a receiver that may be borrowed, and is never borrow-checked.
    pub fn lent(&self) -> ! {
        unreachable!("is not called where nothing is lent")
    }

    /// What the method's own derivative returned.
    #[inline(always)]
    pub fn choose<A, B>(self, _onto: Option<A>, own: Option<B>) -> B {
        <() as Onto<B>>::or(None, own)
    }
}

/// As [`PullbackOnto`], of a method that was called on something it may have changed, or a function that was passed the
/// name of a `&mut`.
#[diagnostic::on_unimplemented(
    message = "what this call changes, and what its arguments refer to, cannot be told from each other",
    note = "give each argument that is a call a statement of its own before, `let value = f(..);`, and pass `value`"
)]
pub trait MethodPullbackOnto<Cotangent, Receiver: ?Sized, Offered, Kind> {
    /// The cotangents of receiver and arguments.
    type Parts;

    /// Calls the pullback. See [`MethodPullback::pull_back`] and [`PullbackOnto::pull_back`].
    fn pull_back(
        self,
        cotangent: Cotangent,
        receiver: &mut Receiver,
        offered: Offered,
    ) -> Self::Parts;
}

impl<F, C, R: ?Sized, L, P> MethodPullbackOnto<C, R, L, Lending> for F
where
    F: FnOnce(C, Offered<L>) -> P,
{
    type Parts = P;

    #[inline(always)]
    fn pull_back(self, cotangent: C, _: &mut R, offered: L) -> P {
        self(cotangent, Offered(offered))
    }
}

impl<F, C, R: ?Sized, T, K, L, P> MethodPullbackOnto<C, R, L, ExclusiveLending<(T, K)>> for F
where
    F: FnOnce(C, T, Offered<L>) -> P,
    R: Take<T, K>,
    K: OfChanged<T>,
{
    type Parts = P;

    #[inline(always)]
    fn pull_back(self, cotangent: C, receiver: &mut R, offered: L) -> P {
        self(cotangent, receiver.take(), Offered(offered))
    }
}

macro_rules! pullbacks_onto {
    (lending $(($($other:ident),*))*) => {$(
        impl<F, C, L, P, $($other),*> PullbackOnto<C, ($($other,)*), L, Lending> for F
        where
            F: FnOnce(C $(, $other)*, Offered<L>) -> P,
        {
            type Parts = P;

            #[inline(always)]
            #[allow(non_snake_case)]
            fn pull_back(self, cotangent: C, ($($other,)*): ($($other,)*), offered: L) -> P {
                self(cotangent $(, $other)*, Offered(offered))
            }
        }
    )*};
    (not_lending $others:tt $(($($member:ident)*))*) => {$(
        pullbacks_onto!(@ $others ($($member,)*));
    )*};
    (@ () $members:ty) => {
        pullbacks_onto!(@of () $members);

        impl<F, C, R: ?Sized, P> MethodPullbackOnto<C, R, $members, NotLending> for F
        where
            F: FnOnce(C) -> P,
        {
            type Parts = P;

            #[inline(always)]
            fn pull_back(self, cotangent: C, _: &mut R, _: $members) -> P {
                self(cotangent)
            }
        }

        impl<F, C, R: ?Sized, T, K, P> MethodPullbackOnto<C, R, $members, Exclusive<(T, K)>> for F
        where
            F: FnOnce(C, T) -> P,
            R: Take<T, K>,
            K: OfChanged<T>,
        {
            type Parts = P;

            #[inline(always)]
            fn pull_back(self, cotangent: C, receiver: &mut R, _: $members) -> P {
                self(cotangent, receiver.take())
            }
        }
    };
    (@ ($($other:ident),+) $members:ty) => {
        pullbacks_onto!(@of ($($other),+) $members);
    };
    (@of ($($other:ident),*) $members:ty) => {
        impl<F, C, P, $($other),*> PullbackOnto<C, ($($other,)*), $members, NotLending> for F
        where
            F: FnOnce(C $(, $other)*) -> P,
        {
            type Parts = P;

            #[inline(always)]
            #[allow(non_snake_case)]
            fn pull_back(self, cotangent: C, ($($other,)*): ($($other,)*), _: $members) -> P {
                self(cotangent $(, $other)*)
            }
        }
    };
    (each $($others:tt)*) => {$(
        pullbacks_onto! {
            not_lending $others
            (NotLent)
            (NotLent NotLent)
            (NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
            (NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent NotLent)
        }
    )*};
}

pullbacks_onto!(lending()(O0)(O0, O1)(O0, O1, O2)(O0, O1, O2, O3)(O0, O1, O2, O3, O4)(
    O0, O1, O2, O3, O4, O5
));
pullbacks_onto!(each()(O0)(O0, O1)(O0, O1, O2)(O0, O1, O2, O3)(O0, O1, O2, O3, O4)(
    O0, O1, O2, O3, O4, O5
));
