//! Killed runs, and what they continue to.

use std::fs;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::sandbox::Sandbox;

/// Many cheap steps: a run takes about two seconds, most of them far from a checkpoint.
const ITERATIONS: &str = "3000";

fn start<'a>(out: &'a str, iterations: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = vec!["optimize", "experiment.toml", "--target", "photo.png"];
    arguments.extend(["--out", out, "--iterations", iterations]);
    arguments.extend(more);
    arguments
}

/// A folder with a target that cannot be matched exactly: a PNG rounds, and the run goes on.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_changed("truth.toml", "[1.5, 3.0, 2.0]", "[-1.0, 2.5, 2.5]");
    sandbox.succeed(&["render", "truth.toml", "-o", "photo.png"]);
    sandbox
}

/// What a run came to, without the time it took.
fn result(sandbox: &Sandbox, out: &str) -> (Vec<u8>, Vec<u8>, Vec<Value>, Vec<String>) {
    let summary = sandbox.json(&format!("{out}/summary.json"));
    let fields = ["loss", "iterations", "best_iteration", "stop_reason", "parameters"];
    let fields = fields.map(|name| summary[name].clone()).to_vec();
    let history = String::from_utf8(sandbox.read(&format!("{out}/history.csv"))).unwrap();
    let losses = history.lines().map(|row| row.rsplit_once(',').unwrap().0.to_owned()).collect();
    let scene = sandbox.read(&format!("{out}/scene.toml"));
    (scene, sandbox.read(&format!("{out}/final.png")), fields, losses)
}

/// Starts a run, and kills it some time after it has written a checkpoint. Whether it was still
/// running.
fn kill(sandbox: &Sandbox, arguments: &[&str], out: &str, after: Duration) -> bool {
    let checkpoint = sandbox.path(&format!("{out}/checkpoint.json"));
    let before = fs::read(&checkpoint).ok();
    let mut child =
        sandbox.command(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let deadline = Instant::now() + Duration::from_secs(60);
    while fs::read(&checkpoint).ok() == before {
        assert!(Instant::now() < deadline, "no checkpoint");
        sleep(Duration::from_millis(1));
    }
    sleep(after);
    let running = child.try_wait().unwrap().is_none();
    // SIGKILL: the process gets no chance to tidy up.
    child.kill().unwrap();
    child.wait().unwrap();
    running
}

#[test]
fn a_killed_run_resumes_to_the_same_bits() {
    let sandbox = sandbox();
    sandbox.succeed(&start("whole", ITERATIONS, &["--threads", "1"]));
    let whole = result(&sandbox, "whole");
    assert_eq!(whole.3.len(), 3002, "a header, the beginning and 3000 steps");

    let mut killed = 0;
    for (out, delay, middle) in [("a", 0, "500"), ("b", 30, "1400"), ("c", 100, "2300")] {
        let delay = Duration::from_millis(delay);
        let resume =
            |iterations, threads| start(out, iterations, &["--resume", "--threads", threads]);
        // On a fast machine a run may end before it is killed.
        if kill(&sandbox, &start(out, ITERATIONS, &[]), out, delay) {
            killed += 1;
            // On to the middle, and killed again soon after it, on another number of threads.
            sandbox.succeed(&resume(middle, "2"));
            killed += usize::from(kill(&sandbox, &resume(ITERATIONS, "1"), out, delay));
        }
        sandbox.succeed(&resume(ITERATIONS, "2"));
        assert!(result(&sandbox, out) == whole, "{out} differs");
        let leftovers = sandbox.names(out).into_iter().filter(|name| name.starts_with('.'));
        assert_eq!(leftovers.count(), 0, "{:?}", sandbox.names(out));
    }
    assert!(killed >= 2, "only {killed} of 6 runs were killed before their end");
}

#[test]
fn threads_change_no_bit_of_the_result() {
    let sandbox = Sandbox::new();
    for threads in ["1", "2"] {
        let arguments = ["optimize", "experiment.toml", "--out", threads, "--threads", threads];
        sandbox.succeed(&arguments);
    }
    assert!(result(&sandbox, "1") == result(&sandbox, "2"));
}

#[test]
fn an_unfinished_run_is_not_thrown_away() {
    let sandbox = sandbox();
    assert!(
        kill(&sandbox, &start("out", ITERATIONS, &[]), "out", Duration::ZERO),
        "done before it was killed"
    );
    sandbox.refuse_with(
        &start("out", ITERATIONS, &[]),
        &["out/checkpoint.json", "--resume", "another folder"],
    );
    // Nor is it continued as another problem.
    let other = ["--resume", "--precision", "f64"];
    sandbox.refuse_with(
        &start("out", ITERATIONS, &other),
        &["out/checkpoint.json", "another problem"],
    );
    let other = ["--resume", "--param", "light.key.color"];
    sandbox.refuse_with(
        &start("out", ITERATIONS, &other),
        &["out/checkpoint.json", "other parameters"],
    );
    sandbox.succeed(&start("out", ITERATIONS, &["--resume"]));
}

#[test]
fn a_finished_run_is_returned_or_gets_more_iterations() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "long", "--iterations", "30"]);
    let steps = |iterations| {
        let arguments = ["optimize", "experiment.toml", "--out", "out", "--resume"];
        sandbox.run(&[&arguments[..], &["--iterations", iterations]].concat())
    };
    assert!(steps("20").status.success());
    let again = steps("20");
    let progress = String::from_utf8(again.stderr).unwrap();
    assert!(progress.starts_with("the run was already finished, at iteration 20\n"), "{progress}");
    let more = String::from_utf8(steps("30").stderr).unwrap();
    assert_eq!(more.matches("resumed at iteration 20").count(), 1, "{more}");
    assert!(result(&sandbox, "out") == result(&sandbox, "long"));
}

#[test]
fn a_damaged_checkpoint_is_named() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out", "--iterations", "2"]);
    let whole = sandbox.read("out/checkpoint.json");
    sandbox.write("out/checkpoint.json", &whole[..whole.len() / 2]);
    let arguments = ["optimize", "experiment.toml", "--out", "out", "--resume"];
    sandbox.refuse_with(&arguments, &["out/checkpoint.json", "damaged", "remove"]);
}
