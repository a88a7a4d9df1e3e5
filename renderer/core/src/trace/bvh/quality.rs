//! How much work the construction of a hierarchy is worth.

use obvhs::BvhBuildParams;

/// The quality of a bounding volume hierarchy: a better one takes longer to build, and rays find their
/// way through it sooner. What they hit is the same.
///
/// All of them cluster primitives along a space-filling curve (PLOC, Meister & Bittner 2018); the
/// better ones look at more neighbours, and reinsert subtrees where they cost less.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum BuildQuality {
    /// The shortest time to build.
    #[default]
    Low,
    /// A compromise.
    Medium,
    /// The shortest time for rays.
    High,
}

impl BuildQuality {
    /// All qualities, the shortest time to build first.
    pub const ALL: [Self; 3] = [Self::Low, Self::Medium, Self::High];

    /// The quality in a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::Medium => "medium",
            Self::High => "high",
        }
    }

    /// The settings of the builder. Its leaves hold one primitive each: they are put together when
    /// nodes become eight-wide.
    pub(super) fn parameters(self) -> BvhBuildParams {
        let parameters = match self {
            Self::Low => BvhBuildParams::fastest_build(),
            Self::Medium => BvhBuildParams::medium_build(),
            Self::High => BvhBuildParams::very_slow_build(),
        };
        BvhBuildParams { max_prims_per_leaf: 1, ..parameters }
    }
}
