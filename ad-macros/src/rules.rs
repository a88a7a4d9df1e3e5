//! The methods that have rules in `ad`.

use crate::floats;

/// Those of vectors, matrices, quaternions, sequences and options, in alphabetical order.
const METHODS: [&str; 51] = [
    "clear",
    "clone",
    "cloned",
    "col",
    "conjugate",
    "copied",
    "copy_from_slice",
    "cross",
    "determinant",
    "distance",
    "distance_squared",
    "dot",
    "element_product",
    "element_sum",
    "expect",
    "extend",
    "extend_from_slice",
    "fill",
    "inverse",
    "length",
    "length_recip",
    "length_squared",
    "lerp",
    "max_element",
    "midpoint",
    "min_element",
    "mul_quat",
    "mul_vec3",
    "normalize",
    "normalize_or_zero",
    "pop",
    "project_onto",
    "push",
    "reflect",
    "reverse",
    "slerp",
    "sort_by",
    "sort_unstable_by",
    "swap",
    "to_vec",
    "transform_point3",
    "transform_vector3",
    "transpose",
    "truncate",
    "unwrap",
    "unwrap_or",
    "unwrap_or_default",
    "x",
    "xyz",
    "y",
    "z",
];

/// Whether types of other crates have a method of this name whose rule is in `ad`. One's own type may
/// have such a one, too.
pub fn is_method(name: &str) -> bool {
    floats::takes_number(name) || METHODS.binary_search(&name).is_ok()
}
