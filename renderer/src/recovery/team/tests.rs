//! Teams of threads.

use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use super::*;

/// A rank that is a thread. Messages wait for their receivers, as large ones may between processes.
struct Thread {
    rank: usize,
    to: Vec<SyncSender<Vec<f64>>>,
    from: Vec<Receiver<Vec<f64>>>,
}

impl Team for Thread {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.to.len()
    }

    fn send(&self, to: usize, numbers: &[f64]) {
        self.to[to].send(numbers.to_vec()).unwrap();
    }

    fn receive(&self, from: usize, numbers: &mut [f64]) {
        numbers.copy_from_slice(&self.from[from].recv().unwrap());
    }

    fn broadcast(&self, numbers: &mut [f64]) {
        match self.rank {
            0 => (1..self.size()).for_each(|rank| self.send(rank, numbers)),
            _ => self.receive(0, numbers),
        }
    }

    fn exchange(&self, text: &str) -> Vec<String> {
        let own: Vec<f64> = text.bytes().map(f64::from).collect();
        let said = |from: usize| {
            if from == self.rank {
                let others = (0..self.size()).filter(|rank| *rank != from);
                others.for_each(|rank| self.send(rank, &own));
                return text.to_owned();
            }
            let bytes = self.from[from].recv().unwrap().into_iter().map(|byte| byte as u8);
            String::from_utf8(bytes.collect()).unwrap()
        };
        (0..self.size()).map(said).collect()
    }
}

/// What each of so many ranks returns.
pub(in crate::recovery) fn in_team<T: Send>(
    size: usize,
    run: impl Fn(&dyn Team) -> T + Sync,
) -> Vec<T> {
    let mut ranks: Vec<Thread> =
        (0..size).map(|rank| Thread { rank, to: vec![], from: vec![] }).collect();
    for to in 0..size {
        for from in 0..size {
            let (sender, receiver) = sync_channel(0);
            ranks[from].to.push(sender);
            ranks[to].from.push(receiver);
        }
    }
    thread::scope(|scope| {
        let run = &run;
        let ranks: Vec<_> = ranks.into_iter().map(|rank| scope.spawn(move || run(&rank))).collect();
        ranks.into_iter().map(|rank| rank.join().unwrap()).collect()
    })
}

#[test]
fn a_rank_that_fails_or_differs_is_named_to_all() {
    let agreed = |of_rank: fn(usize) -> Result<u32, Error>| {
        in_team(3, |team| agree(team, of_rank(team.rank()), u32::to_string))
    };
    assert!(agreed(|_| Ok(7)).iter().all(|agreed| *agreed == Ok(7)));
    let error = |place: &str| Error::new(place, "cannot be read");
    let fails =
        agreed(|rank| if rank < 2 { Ok(7) } else { Err(Error::new("a", "cannot be read")) });
    assert_eq!(fails[0], Err(Error::new("rank 2", "a: cannot be read")));
    assert_eq!(fails[1], fails[0]);
    assert_eq!(fails[2], Err(error("a")));
    let differs = agreed(|rank| Ok(if rank == 1 { 8 } else { 7 }));
    assert!(differs.iter().all(|agreed| *agreed == differs[0]));
    let error = differs[0].as_ref().unwrap_err();
    assert!(error.place == "rank 1" && error.problem.contains("another problem"), "{error}");
}

#[test]
fn tasks_reach_all_ranks() {
    let begun = Begun { iteration: 1 << 40, level: 3 };
    let seen = in_team(3, |team| {
        if team.rank() == 0 {
            Task::Curvature.ask(team, begun, &[1.0, f64::MIN_POSITIVE]);
            Task::End.ask(team, Begun::default(), &[]);
            return vec![];
        }
        let mut x = [0.0; 2];
        let first = Task::next(team, &mut x);
        vec![(first, x), (Task::next(team, &mut x), x)]
    });
    let x = [1.0, f64::MIN_POSITIVE];
    let expected = [((Task::Curvature, begun), x), ((Task::End, Begun::default()), x)];
    assert_eq!(seen[1..], [expected.to_vec(), expected.to_vec()]);
}
