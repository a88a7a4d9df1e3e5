//! What a user can choose.

/// A choice between speed and accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The scalar of the kernels and how many of them go side by side, under the generated adjoint.
    Arithmetic,
    /// How derivatives are made, if not by the generated adjoint.
    Engine,
    /// How primary visibility is found.
    Visibility,
    /// The quality of the acceleration structure, and what happens to it when geometry moves.
    Tree,
    /// How many mirrors light meets at most.
    Bounces,
    /// The step of central differences in single precision, in the natural scale of each parameter.
    SingleDifferences,
    /// The same in double precision.
    DoubleDifferences,
}

impl Axis {
    /// All axes.
    pub const ALL: [Self; 7] = [
        Self::Arithmetic,
        Self::Engine,
        Self::Visibility,
        Self::Tree,
        Self::Bounces,
        Self::SingleDifferences,
        Self::DoubleDifferences,
    ];

    /// Words for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            Self::Arithmetic => "adjoint",
            Self::Engine => "other engines",
            Self::Visibility => "visibility",
            Self::Tree => "tree",
            Self::Bounces => "bounces",
            Self::SingleDifferences => "differences, f32",
            Self::DoubleDifferences => "differences, f64",
        }
    }
}
