//! What a run that leaves edges out says of them at its end.

use super::output::{print_note, short};
use crate::optimize::Point;
use crate::recovery::Recovery;

/// The part of the loss without edges that the loss with them has at most where the target has edges.
const MUCH_LESS: f64 = 0.5;

/// Says so if images with edges are much more like the target than those that were matched to it.
pub(super) fn recommend_edges(recovery: &Recovery<'_>, found: &Point) {
    let losses = recovery.losses_beside_edges(&recovery.scene_at(&found.x));
    let Some([without, with]) = losses.filter(|[without, with]| *with < MUCH_LESS * without) else {
        return;
    };
    let (without, with) = (short(without), short(with));
    print_note(format_args!(
        "at edges the target shows both sides by their areas, as `renderer render` does: with edges the loss of what \
         was found is {with}, without {without}; --edges on recovers with edges"
    ));
}
