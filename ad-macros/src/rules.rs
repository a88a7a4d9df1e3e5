//! The methods that have rules in `ad`.

use crate::floats;
use crate::names::is_in;

/// Those of vectors, matrices, quaternions, sequences, options and integers that leave their receiver as
/// it is.
const METHODS: &str = "\
    clone cloned col conjugate copied cross determinant distance distance_squared dot \
    element_product element_sum expect inverse length length_recip length_squared lerp max_element \
    min_element mul_quat mul_vec3 normalize normalize_or_zero project_onto reflect saturating_add \
    saturating_mul saturating_sub slerp to_owned to_vec transform_point3 transform_vector3 \
    transpose try_into unwrap unwrap_or unwrap_or_default wrapping_add wrapping_mul wrapping_sub x \
    xyz y z";

/// Those whose rules are for all numbers or all vectors, whatever their type.
const FOR_EVERY_TYPE: &str = "\
    clone cross distance distance_squared dot element_sum length length_recip length_squared lerp \
    max_element min_element normalize normalize_or_zero reflect sin_cos to_degrees to_radians x y \
    z";

/// Those of sequences that change their receiver.
const CHANGES_RECEIVER: &str = "\
    append clear copy_from_slice dedup dedup_by dedup_by_key extend extend_from_slice fill insert \
    pop pop_back pop_front push push_back push_front remove resize retain reverse rotate_left \
    rotate_right sort_by sort_by_key sort_unstable_by sort_unstable_by_key split_off swap \
    swap_remove truncate";

/// Those of sequences that change their receiver and become calls of functions.
const BECOMES_CALL: [&str; 2] = ["copy_within", "drain"];

/// Whether types of other crates have a method of this name that changes its receiver.
pub fn changes_receiver(name: &str) -> bool {
    is_in(CHANGES_RECEIVER, name) || BECOMES_CALL.contains(&name)
}

/// Whether types of other crates have a method of this name whose rule is in `ad`. One's own type may
/// have such a one, too.
pub fn is_method(name: &str) -> bool {
    floats::takes_number(name) || is_in(METHODS, name) || is_in(CHANGES_RECEIVER, name)
}

/// Whether the rule of this name is for every type that can do certain things: the compiler says then what a
/// type without the rule cannot do.
pub fn is_for_every_type(name: &str) -> bool {
    floats::real_returns_number(name) || is_in(FOR_EVERY_TYPE, name)
}
