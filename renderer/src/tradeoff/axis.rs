//! What a user can choose.

/// A choice between speed and accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The scalar of the kernels and how many of them go side by side.
    Arithmetic,
    /// How derivatives are made.
    Engine,
    /// The step of central differences, in single or double precision.
    Differences,
    /// How it is found what pixels show.
    Visibility,
    /// What happens to the tree when geometry moves.
    Tree,
    /// How many mirrors light meets at most.
    Bounces,
}

impl Axis {
    /// A word for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            Self::Arithmetic => "arithmetic",
            Self::Engine => "engine",
            Self::Differences => "differences",
            Self::Visibility => "visibility",
            Self::Tree => "tree",
            Self::Bounces => "bounces",
        }
    }
}
