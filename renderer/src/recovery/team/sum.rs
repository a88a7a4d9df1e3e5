//! Sums over views, by many ranks, in the order of the views.
//!
//! Additions in another order give other bits, so what views come to cannot be added within ranks first. Here a
//! chain does it: ranks take consecutive shares of the views, keep what each of their views comes to, and
//! then the sum travels from rank to rank, each of which adds its views in their order. It travels in chunks, so
//! that all ranks add at the same time, one to an earlier chunk than the next.
//!
//! With V views, n ranks and P numbers of 8 bytes, each rank receives and sends the sum once: 8 P bytes, however
//! many views there are. It keeps 8 P V / n bytes, up to [`MOST_KEPT`]; views beyond that wait for another
//! round, back and forth along the chain, so the sum of a round is where the next one begins.
//!
//! Turned down: gathering what all views come to in rank 0 (8 P V bytes through one network card, most of
//! which rank 0 would hold); exchanging slices of all views between all ranks, each of which adds one slice (as
//! much memory as here, and 8 P V / n bytes in and out of each rank: V / n times the traffic); sums in a tree
//! that follows from the number of views (hardly less traffic than here, one sum for each of its levels also in one
//! process, and other bits than before); sums without rounding, whose order is free (several times the numbers).

use super::Team;

/// What a rank keeps of its views until the sum of those before them arrives: so many bytes, or one view.
const MOST_KEPT: usize = 1 << 30;

/// The numbers of a message: a megabyte, far above what starting a message costs, and far below what there is to
/// add where time counts.
const CHUNK: usize = 1 << 17;

/// The sum of what `count` things come to, `len` numbers each, added to 0 in their order: in rank 0; others get a
/// part of it. A rank is asked for its share.
pub(in crate::recovery) fn sum_in_order(
    team: &dyn Team,
    count: usize,
    len: usize,
    of: impl FnMut(usize) -> Vec<f64>,
) -> Vec<f64> {
    sum_in_rounds(team, count, len, MOST_KEPT / (8 * len.max(1)), of)
}

/// The same, of which each rank keeps at most so many at a time.
fn sum_in_rounds(
    team: &dyn Team,
    count: usize,
    len: usize,
    most_kept: usize,
    mut of: impl FnMut(usize) -> Vec<f64>,
) -> Vec<f64> {
    let (rank, size) = (team.rank(), team.size());
    // Nobody has to wait for oneself.
    let kept = if size == 1 { 1 } else { most_kept.clamp(1, count.div_ceil(size).max(1)) };
    let rounds = count.div_ceil(kept * size);
    let mut sum = vec![0.0; len];
    for round in 0..rounds {
        let first = round * kept * size;
        let count = (count - first).min(kept * size);
        // The last round ends at rank 0.
        let is_downwards = (rounds - round) % 2 == 1;
        let place = if is_downwards { size - 1 - rank } else { rank };
        let [below, above] = [rank.checked_sub(1), Some(rank + 1).filter(|&rank| rank < size)];
        let (from, to) = if is_downwards { (above, below) } else { (below, above) };
        let share = first + place * count / size..first + (place + 1) * count / size;
        let terms: Vec<Vec<f64>> = share.map(&mut of).collect();
        for begin in (0..len).step_by(CHUNK) {
            let chunk = begin..len.min(begin + CHUNK);
            let sum = &mut sum[chunk.clone()];
            if let Some(from) = from {
                team.receive(from, sum);
            }
            for term in &terms {
                sum.iter_mut().zip(&term[chunk.clone()]).for_each(|(sum, term)| *sum += term);
            }
            if let Some(to) = to {
                team.send(to, sum);
            }
        }
    }
    sum
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::super::tests::in_team;
    use super::*;

    /// Numbers whose sum is another in any other order.
    fn term(index: usize, len: usize) -> Vec<f64> {
        (0..len).map(|i| (1e8 * ((index * 7919 + i * 104_729) as f64).sin()).powi(3)).collect()
    }

    fn in_order(count: usize, len: usize) -> Vec<f64> {
        let add = |sum: Vec<f64>, index| {
            sum.iter().zip(term(index, len)).map(|(sum, term)| sum + term).collect()
        };
        (0..count).fold(vec![0.0; len], add)
    }

    #[test]
    fn sums_have_the_same_bits_on_any_number_of_ranks_in_any_number_of_rounds() {
        for (count, len) in [(1, 1), (2, 5), (7, 3), (5, CHUNK + 17), (40, 10), (0, 4)] {
            let expected = in_order(count, len);
            for size in [1, 2, 3, 9] {
                for kept in [0, 2, usize::MAX] {
                    let sums = in_team(size, |team| {
                        let mut asked = Vec::new();
                        let of = |index| {
                            asked.push(index);
                            term(index, len)
                        };
                        let sum = sum_in_rounds(team, count, len, kept, of);
                        (sum, asked)
                    });
                    assert!(sums[0].0 == expected, "{count} of {len} on {size}, {kept} kept");
                    let mut asked: Vec<usize> =
                        sums.into_iter().flat_map(|(_, asked)| asked).collect();
                    asked.sort_unstable();
                    assert!(asked.into_iter().eq(0..count), "{count} of {len} on {size}");
                }
            }
        }
    }

    #[test]
    fn shares_differ_by_one_at_most() {
        let shares = in_team(4, |team| {
            let mut count = 0;
            sum_in_order(team, 10, 1, |index| {
                count += 1;
                term(index, 1)
            });
            count
        });
        assert_eq!(shares.iter().sum::<usize>(), 10);
        assert!(shares.iter().all(|count| [2, 3].contains(count)), "{shares:?}");
    }
}
