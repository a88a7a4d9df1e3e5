//! How much work a tree is worth.

use obvhs::BvhBuildParams;

/// How long it may take to build a tree, so that rays find their way through it sooner. What is found
/// is the same.
///
/// All of them cluster primitives along a space-filling curve (PLOC, Meister & Bittner 2018); the
/// longer ones look at more neighbours, and put subtrees where they cost less afterwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Effort {
    /// The shortest time to build.
    #[default]
    Least,
    /// A compromise.
    Medium,
    /// The shortest time for rays.
    Most,
}

impl Effort {
    /// All of them, the shortest time to build first.
    pub const ALL: [Self; 3] = [Self::Least, Self::Medium, Self::Most];

    /// A word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Least => "least",
            Self::Medium => "medium",
            Self::Most => "most",
        }
    }

    /// The settings of the builder. Its leaves hold one primitive each: they are put together when
    /// nodes become eight-wide.
    pub(super) fn parameters(self) -> BvhBuildParams {
        let parameters = match self {
            Self::Least => BvhBuildParams::fastest_build(),
            Self::Medium => BvhBuildParams::medium_build(),
            Self::Most => BvhBuildParams::very_slow_build(),
        };
        BvhBuildParams { max_prims_per_leaf: 1, ..parameters }
    }
}
