//! What a command reads, and must not replace.

use std::path::Path;

use crate::Error;
use crate::experiment::{Experiment, OptimizeSection};

/// The files that an experiment is made from and compared with, and what names each.
pub(super) fn inputs(experiment: &Experiment) -> impl Iterator<Item = (&Path, &str)> {
    let named = experiment.files.iter().map(|file| (file.path.as_path(), &file.by[..]));
    let matched = experiment.optimize.as_ref().map_or_else(Vec::new, OptimizeSection::files);
    named.chain(matched.into_iter().map(|file| (file, "a file of cameras")))
}

/// # Errors
///
/// If `output` is a file that the experiment reads, links resolved.
pub(super) fn check_output(output: &Path, experiment: &Experiment) -> Result<(), Error> {
    match inputs(experiment).find(|(input, _)| is_same(input, output)) {
        None => Ok(()),
        Some((_, by)) => {
            let problem = format!(
                "would be replaced, though {by} names it as an input: choose another name, or \
                 remove it"
            );
            Err(Error::new(output.display(), problem))
        }
    }
}

/// Whether two paths are those of one file, links resolved. What does not exist is no file.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    matches!((one.canonicalize(), other.canonicalize()), (Ok(one), Ok(other)) if one == other)
}
