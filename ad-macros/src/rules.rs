//! The methods that have rules in `ad`.

use crate::floats;

/// Those of vectors, matrices, quaternions, sequences, options and integers, in alphabetical order.
const METHODS: [&str; 57] = [
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
    "saturating_add",
    "saturating_mul",
    "saturating_sub",
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
    "wrapping_add",
    "wrapping_mul",
    "wrapping_sub",
    "x",
    "xyz",
    "y",
    "z",
];

/// Those of sequences that change their receiver.
const CHANGES_RECEIVER: [&str; 12] = [
    "clear",
    "copy_from_slice",
    "extend",
    "extend_from_slice",
    "fill",
    "pop",
    "push",
    "reverse",
    "sort_by",
    "sort_unstable_by",
    "swap",
    "truncate",
];

/// Whether types of other crates have a method of this name that changes its receiver.
pub fn changes_receiver(name: &str) -> bool {
    CHANGES_RECEIVER.contains(&name)
}

/// Whether types of other crates have a method of this name whose rule is in `ad`. One's own type may
/// have such a one, too.
pub fn is_method(name: &str) -> bool {
    floats::takes_number(name) || METHODS.binary_search(&name).is_ok()
}
