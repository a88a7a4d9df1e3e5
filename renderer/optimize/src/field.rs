//! Numbers that a caller chooses, and what they may be.

use renderer_core::Error;

/// A hyper-parameter: its name, its value, whether that can be used, and what can.
pub(super) type Field = (&'static str, f64, bool, &'static str);

/// The first number that is out of its range, as an error whose place is `place` and its name.
pub(super) fn check_fields(place: &str, fields: Vec<Field>) -> Result<(), Error> {
    match fields.into_iter().find(|(_, _, good, _)| !good) {
        Some((name, value, _, right)) => Err(Error::new(
            format_args!("{place}.{name}"),
            format_args!("is {value}; it must be {right}"),
        )),
        None => Ok(()),
    }
}
