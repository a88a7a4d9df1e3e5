//! Several processes of one run, started by `mpirun`.

use std::fs;
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::sandbox::{FLOOR, SCENE, Sandbox};

/// A mesh whose triangles change on the way.
const REMESHED: &str = "\
[[optimize.parameter]]
path = \"mesh.floor.vertices\"
remesh = { edge_length = 0.9, every = 4 }
";

/// A scene through five cameras, one of them held out, with images of all kinds.
fn sandbox(method: &str) -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("floor.obj", FLOOR);
    let camera = "look_from = [0.0, 1.5, 4.0]\n";
    let scene = SCENE.replace(camera, "");
    let views = |with_targets: bool| {
        let view = |(index, x): (usize, f64)| {
            let targets = match index {
                _ if !with_targets => String::new(),
                1 => "target = \"truth-v1.exr\"\n\
                      depth = { path = \"measured-v1.exr\", weight = 0.1 }\n\
                      coverage = { path = \"covered-v1.exr\", weight = 0.2 }\n"
                    .into(),
                2 => "target = \"truth-v2.exr\"\nweight = 1.7\n".into(),
                3 => "target = \"truth-v3.exr\"\nheld_out = true\n".into(),
                _ => format!("target = \"truth-v{index}.exr\"\n"),
            };
            format!("[[view]]\nname = \"v{index}\"\nlook_from = [{x:?}, 1.5, 3.0]\n{targets}")
        };
        [-2.0, -1.0, 0.5, 1.0, 2.5].into_iter().enumerate().map(view).collect::<String>()
    };
    let truth = scene.replace("[1.5, 3.0, 2.0]", "[1.1, 2.8, 2.3]").replace("0.6, 0.3", "0.5, 0.4");
    sandbox.write("truth.toml", format!("{truth}{}", views(false)));
    for (pass, file) in [("radiance", "truth"), ("depth", "measured"), ("coverage", "covered")] {
        let file = format!("{file}.exr");
        sandbox.succeed(&["render", "truth.toml", "--pass", pass, "-o", &file]);
    }
    let spread = if method.contains("starts") { "spread = 0.2\n" } else { "" };
    let parameters: String = ["light.key.position", "material.paint.diffuse", "sphere.ball.center"]
        .map(|path| format!("[[optimize.parameter]]\npath = \"{path}\"\n{spread}"))
        .concat();
    let head = format!("[optimize]\n{method}\n");
    sandbox.write("shared.toml", format!("{scene}{}{head}{parameters}", views(true)));
    sandbox
}

/// So many ranks with one thread each.
fn mpirun(sandbox: &Sandbox, ranks: &str, arguments: &[&str]) -> Command {
    let mut command = ranks_of(sandbox, ranks);
    command.arg(env!("CARGO_BIN_EXE_renderer")).args(arguments);
    command
}

/// So many ranks of the program that its next arguments name.
fn ranks_of(sandbox: &Sandbox, ranks: &str) -> Command {
    let mut command = Command::new("mpirun");
    command.args(["--allow-run-as-root", "--oversubscribe", "-n", ranks]);
    // Open MPI gives ranks a second to end after one that failed.
    command.env("OMPI_MCA_odls_base_sigkill_timeout", "0");
    command.current_dir(sandbox.path("."));
    command
}

fn optimize<'a>(out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["optimize", "shared.toml", "--out", out, "--threads", "1"], more].concat()
}

fn output(mut command: Command) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = command.output().unwrap();
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).unwrap());
    (status.code(), stdout, stderr)
}

/// What a run came to, without the time it took.
fn result(sandbox: &Sandbox, out: &str) -> (Vec<Value>, Vec<String>, Vec<u8>) {
    let summary = sandbox.json(&format!("{out}/summary.json"));
    let fields = ["loss", "iterations", "best_iteration", "stop_reason", "parameters", "views"];
    let fields = fields.map(|name| summary[name].clone()).to_vec();
    let history = String::from_utf8(sandbox.read(&format!("{out}/history.csv"))).unwrap();
    let losses = history.lines().map(|row| row.rsplit_once(',').unwrap().0.to_owned()).collect();
    (fields, losses, sandbox.read(&format!("{out}/scene.toml")))
}

#[test]
fn any_number_of_ranks_comes_to_the_bits_of_one_process() {
    let remeshed = format!("optimizer = \"adam\"\niterations = 12\n{REMESHED}");
    let methods = [
        ("optimizer = \"adam\"\ncoarse_to_fine = 2\niterations = 12", &["2", "3", "8"][..]),
        ("optimizer = \"adam\"\nbatch = 3\nseed = 5\niterations = 9", &["2"]),
        ("optimizer = \"lbfgs\"\ncoarse_to_fine = 1\nstarts = 3\niterations = 8", &["3"]),
        ("optimizer = \"lm\"\nloss = \"huber\"\niterations = 4", &["2"]),
        (&remeshed, &["2"]),
    ];
    for (method, ranks) in methods {
        let sandbox = sandbox(method);
        sandbox.succeed(&optimize("alone", &[]));
        let alone = result(&sandbox, "alone");
        for ranks in ranks {
            let (code, printed, errors) = output(mpirun(&sandbox, ranks, &optimize(ranks, &[])));
            assert_eq!(code, Some(0), "{method}: {errors}");
            assert!(result(&sandbox, ranks) == alone, "{method}: {ranks} ranks differ");
            assert_eq!(printed.matches("results in ").count(), 1, "{printed}");
            assert_eq!(errors.matches("stopped after ").count(), 1, "{errors}");
            assert_eq!(errors.matches("more ranks than").count(), usize::from(*ranks == "8"));
        }
    }
}

#[test]
fn what_is_wrong_is_said_once() {
    let sandbox = sandbox("");
    let refuse = |arguments: &[&str], part: &str| {
        let (code, printed, errors) = output(mpirun(&sandbox, "2", arguments));
        assert_eq!((code, &printed[..]), (Some(2), ""), "{arguments:?}: {errors}");
        assert_eq!(errors.matches(part).count(), 1, "{arguments:?}: {errors}");
        assert_eq!(errors.matches("error: ").count(), 1, "{arguments:?}: {errors}");
    };
    refuse(&["optimize", "nothing.toml"], "nothing.toml");
    refuse(&["optimize", "shared.toml", "--optimiser", "adam"], "--optimiser");
    refuse(&["optimize", "shared.toml", "--accuracy", "0.1"], "--accuracy: measures times");
    refuse(&["optimize", "shared.toml", "--param", "camera.vfov"], "--param camera.vfov");
    refuse(&["params", "shared.toml"], "mpirun: only `renderer optimize`");
    // Of one rank alone, as where machines do not have the same files.
    let script = "cd $OMPI_COMM_WORLD_RANK && exec \"$0\" optimize shared.toml";
    let different = |change: &dyn Fn()| {
        change();
        let mut command = ranks_of(&sandbox, "2");
        command.args(["sh", "-c", script, env!("CARGO_BIN_EXE_renderer")]);
        let (code, _, errors) = output(command);
        assert_eq!(code, Some(2), "{errors}");
        assert_eq!(errors.matches("error: ").count(), 1, "{errors}");
        errors
    };
    let errors = different(&|| {
        for rank in ["0", "1"] {
            fs::create_dir(sandbox.path(rank)).unwrap();
            for file in sandbox.names(".").iter().filter(|name| name.contains('.')) {
                fs::copy(sandbox.path(file), sandbox.path(rank).join(file)).unwrap();
            }
        }
        fs::remove_file(sandbox.path("1/truth-v2.exr")).unwrap();
    });
    assert!(errors.contains("error: rank 1: shared.toml:"), "{errors}");
    assert!(errors.contains(": view.v2.target: truth-v2.exr: no such file"), "{errors}");
    let errors = different(&|| {
        fs::copy(sandbox.path("truth-v4.exr"), sandbox.path("1/truth-v2.exr")).unwrap();
    });
    assert!(errors.contains("error: rank 1: has another problem than rank 0"), "{errors}");
}

/// Sends a signal to a rank of a running `mpirun`.
fn signal(signal: &str, mpirun: u32, rank: usize) {
    let is_rank = |process: &String| {
        let file = |name| fs::read(format!("/proc/{process}/{name}")).unwrap_or_default();
        let text = |name| String::from_utf8_lossy(&file(name)).into_owned();
        let parent = text("stat").rsplit_once(')').and_then(|(_, rest)| {
            rest.split_whitespace().nth(1).map(|parent| parent == mpirun.to_string())
        });
        let name = format!("OMPI_COMM_WORLD_RANK={rank}");
        parent == Some(true) && text("environ").split('\0').any(|entry| entry == name)
    };
    let processes = fs::read_dir("/proc").unwrap();
    let mut processes = processes.filter_map(|entry| entry.unwrap().file_name().into_string().ok());
    let process = processes.find(is_rank).expect("no such rank");
    assert!(Command::new("kill").args([signal, &process]).status().unwrap().success());
}

#[test]
fn runs_that_end_early_leave_a_checkpoint_that_any_number_of_ranks_resumes() {
    let sandbox = sandbox("optimizer = \"adam\"\niterations = 500");
    sandbox.succeed(&optimize("whole", &[]));
    for (out, name, rank, lines) in [
        ("died", "-KILL", 1, &["mpirun noticed that process rank 1"][..]),
        ("asked", "-INT", 0, &["stopped after ", "go on with the same command and --resume"]),
    ] {
        let mut command = mpirun(&sandbox, "2", &optimize(out, &[]));
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let deadline = Instant::now() + Duration::from_secs(60);
        while !sandbox.path(&format!("{out}/checkpoint.json")).exists() {
            assert!(Instant::now() < deadline, "no checkpoint");
            sleep(Duration::from_millis(1));
        }
        signal(name, child.id(), rank);
        let output = child.wait_with_output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success(), "{name}: {errors}");
        for line in lines {
            assert_eq!(errors.matches(line).count(), 1, "{name}: {errors}");
        }
        let checkpoint = sandbox.json(&format!("{out}/checkpoint.json"));
        let iteration = checkpoint["state"]["iteration"].as_u64().unwrap();
        assert!((1..500).contains(&iteration), "{iteration}");
        sandbox.succeed(&optimize(out, &["--resume", "--iterations", "490"]));
        let resumed = output_of(mpirun(&sandbox, "3", &optimize(out, &["--resume"])));
        assert!(resumed.contains("resumed at iteration 490"), "{resumed}");
        assert!(result(&sandbox, out) == result(&sandbox, "whole"), "{name} differs");
    }
}

fn output_of(command: Command) -> String {
    let (code, _, errors) = output(command);
    assert_eq!(code, Some(0), "{errors}");
    errors
}
