//! Teams of threads.

use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use super::*;
use crate::experiment::Experiment;
use crate::optimize::{Objective, Quiet};
use crate::recovery::{ImageObjective, Recovery};
use crate::settings::{Edges, Settings};

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
        let next = || {
            let mut numbers = vec![7.0];
            (Task::next(team, &mut numbers), numbers)
        };
        vec![next(), next()]
    });
    let x = vec![1.0, f64::MIN_POSITIVE];
    let expected = [((Task::Curvature, begun), x), ((Task::End, Begun::default()), vec![])];
    assert_eq!(seen[1..], [expected.to_vec(), expected.to_vec()]);
}

/// Three views of two balls, the last of which shows one alone; `bright` makes the other one overflow.
fn experiment(bright: bool, method: &str) -> Experiment {
    let view = |(name, from): (&str, &str)| {
        format!(
            "[[view]]\nname = \"{name}\"\nlook_from = {from}\nlook_at = [0, 0, 0]\nwidth = 8\nheight = 8\n"
        )
    };
    let views = [("a", "[0, 1, 5]"), ("b", "[1, 1, 5]"), ("c", "[0, 0.2, 3]")];
    let views: String = views.into_iter().map(view).collect();
    let other = if bright { "[1e38, 1e38, 1e38]" } else { "[0.1, 0.2, 0.3]" };
    let text = format!(
        "{views}[[light]]\nname = \"key\"\ntype = \"point\"\nposition = [2, 3, 4]\n\
         radiant_intensity = 3000\n\
         [[sphere]]\nname = \"one\"\ncenter = [0, 0, 0]\nradius = 0.8\nmaterial = \"paint\"\n\
         [[sphere]]\nname = \"two\"\ncenter = [0, 1.8, 0]\nradius = 0.4\nmaterial = \"other\"\n\
         [material.paint]\ndiffuse = [0.5, 0.5, 0.5]\n[material.other]\ndiffuse = {other}\n\
         [optimize]\n{method}\n[optimize.target_values]\n\"material.paint.diffuse\" = [0.4, 0.3, 0.2]\n\
         [[optimize.parameter]]\npath = \"light.key.position\"\n\
         [[optimize.parameter]]\npath = \"material.paint.diffuse\"\n"
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).unwrap();
    Experiment::load(&path).unwrap()
}

/// What rank 0 of so many gets from `run`, which the others serve, and what it knows to be left out.
fn led<T: Send>(
    size: usize,
    experiment: &Experiment,
    run: impl Fn(&Recovery<'_>, &dyn Team) -> T + Sync,
) -> (T, Option<String>) {
    let results = in_team(size, |team| {
        let settings = Settings { edges: Edges::Off, ..Settings::default() };
        let recovery = Recovery::new(experiment, "scene", &settings).unwrap();
        let recovery = recovery.allowing_non_finite();
        if team.rank() > 0 {
            recovery.serve(team);
            return None;
        }
        Some((recovery.lead(team, || run(&recovery, team)), recovery.left_out()))
    });
    results.into_iter().flatten().next().unwrap()
}

#[test]
fn ranks_evaluate_what_one_process_does() {
    let experiment = experiment(false, "iterations = 5\noptimizer = \"lm\"\ncoarse_to_fine = 1");
    let run = |recovery: &Recovery<'_>, team: &dyn Team| {
        let mut objective = ImageObjective::shared(recovery, recovery.render_settings(), team);
        let x = recovery.initial();
        let beyond = vec![f64::NAN; x.len()];
        let nothing = objective.evaluate(&beyond).loss.is_nan();
        objective.begin(3, 1);
        let evaluated = (objective.evaluate(&x), objective.curvature(&x), nothing);
        let outcome = recovery.run_shared(team, &recovery.settings(), &mut Quiet).unwrap();
        (evaluated, outcome.best, outcome.history.len(), outcome.evaluations)
    };
    let alone = led(1, &experiment, run);
    let (loss, curvature, nothing) = &alone.0.0;
    assert!(loss.is_finite() && curvature.is_some() && *nothing, "{alone:?}");
    for size in [2, 3, 5] {
        assert_eq!(led(size, &experiment, run), alone, "{size} ranks");
    }
}

#[test]
fn a_loss_without_curvature_has_none_on_any_rank() {
    let experiment = experiment(false, "loss = \"l1\"");
    let curvature = |recovery: &Recovery<'_>, team: &dyn Team| {
        let mut objective = ImageObjective::shared(recovery, recovery.render_settings(), team);
        objective.curvature(&recovery.initial())
    };
    for size in [1, 2] {
        assert_eq!(led(size, &experiment, curvature), (None, None));
    }
}

#[test]
fn what_is_left_out_last_is_known_to_rank_0() {
    let experiment = experiment(true, "");
    let run = |recovery: &Recovery<'_>, team: &dyn Team| {
        let mut objective = ImageObjective::shared(recovery, recovery.render_settings(), team);
        (0..2).for_each(|_| drop(objective.evaluate(&recovery.initial())));
    };
    let (_, alone) = led(1, &experiment, run);
    let text = alone.as_ref().unwrap();
    assert!(text.starts_with("view `b`: ") && text.contains("not finite"), "{text}");
    for size in [2, 3, 4] {
        assert_eq!(led(size, &experiment, run).1, alone, "{size} ranks");
    }
}
