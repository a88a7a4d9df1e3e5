//! Each construct of the language, on both sides of each branch, against the oracles of `tests/gradients`.

#![allow(
    clippy::assign_op_pattern,
    clippy::iter_next_slice,
    clippy::iter_nth,
    clippy::ptr_arg,
    clippy::single_match,
    clippy::let_and_return,
    clippy::needless_range_loop,
    clippy::needless_borrows_for_generic_args,
    clippy::needless_return,
    clippy::boxed_local,
    clippy::explicit_auto_deref,
    clippy::redundant_slicing,
    clippy::toplevel_ref_arg,
    clippy::useless_vec,
    clippy::unnecessary_filter_map,
    clippy::double_ended_iterator_last,
    clippy::unnecessary_lazy_evaluations,
    clippy::multiple_bound_locations,
    clippy::type_complexity,
    clippy::never_loop,
    clippy::reversed_empty_ranges,
    clippy::needless_late_init,
    clippy::unnecessary_map_on_constructor,
    clippy::while_let_on_iterator,
    clippy::box_collection,
    clippy::needless_lifetimes,
    clippy::redundant_allocation,
    clippy::unnecessary_literal_unwrap,
    clippy::vec_box,
    reason = "these forms are what is tested"
)]

mod attempts;
mod borrowed_patterns;
mod boxes;
mod broken;
mod changed_parts;
mod checkpoint;
mod circles;
mod circles_in_macros;
mod closures;
mod closures_for_methods;
mod collected_attempts;
mod collections;
mod conditional;
mod constant_enums;
mod constant_lists;
mod constant_structs;
mod conversions;
mod data;
mod deferred;
mod draining;
mod dropped;
mod editing;
mod elements;
mod enums;
mod exclusive;
mod exits;
mod exits_in_vectors;
mod flow;
mod function_parameters;
mod functions;
mod functions_by_name;
mod generators;
mod indexed;
mod integers;
mod iterators;
mod jumps;
mod kept_references;
mod leaving;
mod lending;
mod lent_contents;
mod lent_elements;
mod lent_methods;
mod lifetimes;
mod lists;
mod macros;
mod made_where_lent;
mod mapped;
mod matrices;
mod mixtures;
mod moved_before_exits;
mod moved_elements;
mod moved_parts;
mod moved_references;
mod named_items;
mod named_iterators;
mod operators;
#[path = "../gradients/oracle.rs"]
mod oracle;
mod outcomes;
mod own_methods;
mod own_numbers;
mod owned;
mod parts_together;
mod passed_by_name;
mod passing_on;
mod programs;
mod queues;
mod reborrowed;
mod receivers;
mod references;
mod rest_patterns;
mod returned_receivers;
mod running;
mod scalars;
mod searches;
mod single_methods;
mod skipping;
mod slices;
mod splits;
mod statements;
mod steps;
mod swapping;
mod told_references;
mod trees;
mod variants;
