//! `a += b` as `a = a + b`, and so with the other operators, for the scalars made here.

/// Gives a scalar that has operators those that assign.
macro_rules! assigning {
    (@one [$($parameter:ident: $bound:path),*] $type:ty: $name:ident $method:ident $operator:tt) => {
        impl<$($parameter: $bound),*> core::ops::$name for $type {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
    ($parameters:tt $type:ty) => {
        assigning!(@one $parameters $type: AddAssign add_assign +);
        assigning!(@one $parameters $type: SubAssign sub_assign -);
        assigning!(@one $parameters $type: MulAssign mul_assign *);
        assigning!(@one $parameters $type: DivAssign div_assign /);
    };
}

pub(crate) use assigning;
