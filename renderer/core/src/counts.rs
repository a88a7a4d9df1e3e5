//! How much work images and gradients take.
//!
//! The work is counted where it is done: each thread counts for itself, and the counts of a strip of
//! the image are added to those of the process when it is done, so that counting costs nothing that
//! can be measured.

use std::cell::Cell;
use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

macro_rules! counts {
    ($($(#[$doc:meta])* $name:ident: $label:literal,)*) => {
        /// Counts of work.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Counts {
            $($(#[$doc])* pub $name: u64,)*
        }

        impl Counts {
            /// The work of this process so far.
            pub fn total() -> Self {
                Self { $($name: TOTAL.$name.load(Relaxed),)* }
            }
        }

        struct Total {
            $($name: AtomicU64,)*
        }

        static TOTAL: Total = Total { $($name: AtomicU64::new(0),)* };

        /// What one thread counts.
        pub(crate) struct Local {
            $(pub $name: Cell<u64>,)*
        }

        thread_local! {
            static LOCAL: Local = const { Local { $($name: Cell::new(0),)* } };
        }

        /// Adds what this thread has counted to the total, and begins anew.
        pub(crate) fn flush() {
            LOCAL.with(|counts| {
                $(TOTAL.$name.fetch_add(counts.$name.take(), Relaxed);)*
            });
        }

        impl fmt::Display for Counts {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                $(writeln!(f, concat!($label, "{:>15}"), self.$name)?;)*
                Ok(())
            }
        }
    };
}

counts! {
    /// Rays from the camera.
    primary_rays: "primary rays                ",
    /// Rays between surfaces and lights.
    shadow_rays: "shadow rays                 ",
    /// Rays that go on from mirrors and behind transparent surfaces.
    secondary_rays: "rays that go on             ",
    /// Nodes of the trees that were visited, by a ray or by a packet of up to 64.
    nodes: "nodes visited               ",
    /// Colours looked up in textures.
    texture_lookups: "texture lookups             ",
    /// Surface points that were shaded.
    shaded: "points shaded               ",
    /// Surface points whose shading was pulled back.
    shading_pullbacks: "shading pullbacks           ",
    /// Surface points that were pulled back to their primitives and to the camera.
    surface_pullbacks: "surface pullbacks           ",
}

/// Counts `more` work of this thread.
#[inline]
pub(crate) fn count(which: impl FnOnce(&Local) -> &Cell<u64>, more: u64) {
    LOCAL.with(|counts| {
        let count = which(counts);
        count.set(count.get() + more);
    });
}
