//! Vertices that vary together, least squares, and images from coarse to fine.

use serde_json::Value;

use crate::sandbox::{OPTIMIZE, SCENE, Sandbox, numbers};

const OCTAHEDRON: &str = "\
v 0.5 0 0
v 0 0.5 0
v 0 0 0.5
v -0.5 0 0
v 0 -0.5 0
v 0 0 -0.5
f 1 2 3
f 2 4 3
f 4 5 3
f 5 1 3
f 2 1 6
f 4 2 6
f 5 4 6
f 1 5 6
";

/// A body to be stretched, beside the ball.
fn sandbox(section: &str, parameter: &str) -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("body.obj", OCTAHEDRON);
    let mesh = "[[mesh]]\npath = \"body.obj\"\nname = \"body\"\nmaterial = \"paint\"\n\
                translation = [0.0, 1.2, 0.0]\n";
    let target = "[optimize.target_values]\n\"mesh.body.vertices\" = [0.6, 0.0, 0.0, 0.0, 0.4, 0.0, \
                  0.0, 0.0, 0.5, -0.4, 0.1, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, -0.5]\n";
    let scene = format!(
        "{SCENE}{mesh}[optimize]\n{section}{target}\
         [[optimize.parameter]]\npath = \"mesh.body.vertices\"\n{parameter}"
    );
    sandbox.write("shape.toml", scene);
    sandbox
}

/// What a run came to, but for the time it took.
fn result(sandbox: &Sandbox, out: &str) -> Vec<Value> {
    let summary = sandbox.json(&format!("{out}/summary.json"));
    ["loss", "iterations", "best_iteration", "parameters"]
        .map(|name| summary[name].clone())
        .to_vec()
}

#[test]
fn vertices_take_large_steps_and_resume_to_the_same_bits() {
    let section =
        "optimizer = { type = \"adam\", uniform = true }\ncoarse_to_fine = 2\niterations = 60\n";
    let parameter = "large_steps = 0.5\nlearning_rate = 0.02\nlaplacian = { weight = 1e-5, weights = \"cotangent\" }\n";
    let sandbox = sandbox(section, parameter);
    let run = |out: &str, threads: &str| {
        sandbox.succeed(&[
            "optimize",
            "shape.toml",
            "--out",
            out,
            "--resume",
            "--threads",
            threads,
        ]);
        result(&sandbox, out)
    };
    let whole = run("whole", "1");
    let loss = &whole[0];
    assert!(loss["ratio"].as_f64().unwrap() < 0.1, "{loss}");
    // Levels span the iterations, so a part of a run is one that is killed.
    let mut child = sandbox.command(&["optimize", "shape.toml", "--out", "parts"]);
    let mut child = child.stderr(std::process::Stdio::null()).spawn().unwrap();
    let checkpoint = sandbox.path("parts/checkpoint.json");
    while !checkpoint.exists() && child.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(run("parts", "2"), whole);
    // The first level ends where a third of the iterations does.
    let history = String::from_utf8(sandbox.read("whole/history.csv")).unwrap();
    assert_eq!(history.lines().count(), 62);
}

#[test]
fn triangles_change_and_resume_to_the_same_bits() {
    let section = "optimizer = { type = \"adam\", uniform = true }\niterations = 30\n";
    let parameter = "large_steps = 0.5\nlearning_rate = 0.02\n\
                     remesh = { edge_length = 0.2, every = 7 }\nedge_length = 1e-4\n\
                     laplacian = { weight = 1e-5, weights = \"cotangent\" }\n";
    let light = "[[optimize.parameter]]\npath = \"light.key.radiant_intensity\"\nscale = \"log\"\n";
    let sandbox = sandbox(section, &format!("{parameter}{light}"));
    let run = |out: &str, iterations: &str, threads: &str| {
        let arguments = ["optimize", "shape.toml", "--out", out, "--resume", "--iterations"];
        sandbox.succeed(&[&arguments[..], &[iterations, "--threads", threads]].concat())
    };
    let printed = run("whole", "30", "1");
    assert!(printed.contains("of them turned over 0, intersecting others 0"), "{printed}");
    let whole = result(&sandbox, "whole");
    let triangles = whole[3]["mesh.body.vertices"]["triangles"].as_u64().unwrap();
    assert!(triangles > 30, "{triangles}");
    // Lengths fall step by step.
    run("begun", "8", "1");
    let begun = result(&sandbox, "begun")[3]["mesh.body.vertices"]["triangles"].as_u64().unwrap();
    assert!(begun < triangles / 2, "{begun}");
    // In parts, which end before, at and after changes, it comes to the same bits.
    for (iterations, threads) in [("6", "2"), ("7", "1"), ("8", "2"), ("21", "1"), ("30", "2")] {
        run("parts", iterations, threads);
    }
    assert_eq!(result(&sandbox, "parts"), whole);
    let mesh = |out: &str| sandbox.read(&format!("{out}/meshes/body.obj"));
    assert_eq!(mesh("parts"), mesh("whole"));
    // What was found is a scene of its own, and a mesh for others.
    sandbox.succeed(&["render", "whole/scene.toml", "-o", "again.png"]);
    assert_eq!(sandbox.read("again.png"), sandbox.read("whole/final.png"));
    sandbox.succeed(&["export", "whole/scene.toml", "-o", "whole.glb"]);
    sandbox.succeed(&["report", "whole"]);
}

#[test]
fn the_coordinates_of_steps_change_the_way_and_not_the_gradient() {
    let one = |parameter: &str| {
        let sandbox =
            sandbox("iterations = 1\noptimizer = { type = \"adam\", uniform = true }\n", parameter);
        sandbox.succeed(&["optimize", "shape.toml", "--out", "out"]);
        let history = String::from_utf8(sandbox.read("out/history.csv")).unwrap();
        let rows: Vec<Vec<f64>> = history
            .lines()
            .skip(1)
            .map(|row| row.split(',').map(|n| n.parse().unwrap()).collect())
            .collect();
        (rows[0][1], rows[0][2], rows[1][1])
    };
    let (plain, large) =
        (one("learning_rate = 0.01\n"), one("large_steps = 3.0\nlearning_rate = 0.01\n"));
    assert_eq!((plain.0, plain.1), (large.0, large.1));
    assert_ne!(plain.2, large.2);
}

#[test]
fn least_squares_find_a_light_in_few_steps() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out", "--optimizer", "lm"]);
    let summary = sandbox.json("out/summary.json");
    let found = numbers(&summary["parameters"]["light.key.position"]["final"]);
    let error = found
        .iter()
        .zip([-1.0, 2.5, 2.5])
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, |m: f64, e| if e.is_nan() { f64::INFINITY } else { m.max(e) });
    assert!(error < 1e-3, "{found:?}");
    // In parts it comes to the same bits.
    for iterations in ["3", "8", "40"] {
        let arguments = ["optimize", "experiment.toml", "--out", "parts", "--optimizer", "lm"];
        sandbox.succeed(&[&arguments[..], &["--resume", "--iterations", iterations]].concat());
    }
    assert_eq!(result(&sandbox, "parts"), result(&sandbox, "out"));
}

/// The ball is where no edge of the target is near.
#[test]
fn one_of_several_starts_sees_where_to_go() {
    let find = |starts: &str, spread: &str, out: &str, threads: &str| {
        let sandbox = Sandbox::new();
        let section = format!(
            "[optimize]\noptimizer = \"lbfgs\"\ncoarse_to_fine = 1\niterations = 60\n{starts}\
             [optimize.target_values]\n\"sphere.ball.center\" = [-1.1, 0.6, 0.2]\n\
             [[optimize.parameter]]\npath = \"sphere.ball.center\"\n{spread}"
        );
        let scene = SCENE.replace("center = [0.0, 0.5, 0.0]", "center = [1.2, 0.5, 0.0]");
        sandbox.write("far.toml", format!("{scene}{section}"));
        sandbox.succeed(&["optimize", "far.toml", "--out", out, "--threads", threads]);
        let summary = sandbox.json(&format!("{out}/summary.json"));
        let found = numbers(&summary["parameters"]["sphere.ball.center"]["final"]);
        let off = found.iter().zip([-1.1, 0.6, 0.2]).map(|(a, b)| (a - b).abs());
        (off.fold(0.0, f64::max), found)
    };
    assert!(find("", "", "one", "1").0 > 0.5);
    let spread = "spread = [2.5, 0.3, 0.5]\n";
    let (off, found) = find("starts = 8\nseed = 3\n", spread, "many", "1");
    assert!(off < 0.02, "{found:?}");
    assert_eq!(find("starts = 8\nseed = 3\n", spread, "many", "2").1, found);
}

#[test]
fn what_cannot_be_done_is_said() {
    let refuse = |section: &str, parameter: &str, parts: &[&str]| {
        sandbox(section, parameter).refuse_with(&["optimize", "shape.toml", "--out", "out"], parts);
    };
    refuse("", "large_steps = -1.0\n", &["shape.toml:", "large_steps", "above 0"]);
    refuse("", "laplacian = { weight = -1.0 }\n", &["laplacian", "weight of 0 or more, has -1"]);
    refuse("", "edge_length = -1.0\n", &["edge_length", "weight of 0 or more, has -1"]);
    refuse("", "total_variation = 1.0\n", &["total_variation", "texels of a texture"]);
    refuse("", "laplacian = { wight = 1.0 }\n", &["shape.toml:", "wight"]);
    refuse(
        "optimizer = \"lbfgs\"\n",
        "large_steps = 1.0\n",
        &["mesh.body.vertices out (large steps"],
    );
    let refused = ["shape.toml: optimize.loss", "another loss"];
    refuse("optimizer = \"lm\"\nloss = \"l1\"\n", "", &refused);
    refuse("coarse_to_fine = 5\n", "", &["optimize.coarse_to_fine", "24 x 16", "5 times"]);
    refuse("loss = { type = \"huber\", delta = 0.0 }\n", "", &["optimize.loss.delta", "above 0"]);
    refuse("starts = 4\n", "", &["optimize.starts", "`spread`"]);
    refuse("starts = 4\n", "spread = 0.0\n", &["optimize.starts", "above 0"]);
    refuse("starts = 0\n", "spread = 1.0\n", &["optimize.starts", "at least 1"]);
    refuse("", "spread = 1.0\n", &["mesh.body.vertices.spread", "`starts`"]);
    refuse("starts = 4\n", "spread = -1.0\n", &["spread", "0 or more"]);
    refuse("seed = 4\n", "", &["optimize.seed", "`batch` or `starts`"]);
    refuse("loss = \"hubert\"\n", "", &["shape.toml:", "hubert", "huber"]);
    let remesh = "remesh = { edge_length = 0.2, every = 7 }\n";
    let of = "mesh.body.vertices.remesh";
    refuse("optimizer = \"lbfgs\"\n", remesh, &["shape.toml:", of, "lbfgs"]);
    refuse("optimizer = \"lm\"\n", remesh, &["shape.toml:", of, "lm"]);
    refuse("", &format!("min = -9.0\n{remesh}"), &["shape.toml:", of, "`min`"]);
    refuse("", "remesh = { edge_length = 0.2, every = 0 }\n", &[of, "every", "at least 1"]);
    refuse("", "remesh = { edge_length = 0.0, every = 7 }\n", &[of, "body", "above 0, is 0"]);
    refuse("", "remesh = { edge_length = 1e-9, every = 7 }\n", &[of, "body", "memory"]);
    refuse("", "remesh = { edge_length = 0.2 }\n", &["shape.toml:", "every"]);
    refuse("", "remesh = { every = 7, edge_lenth = 0.2 }\n", &["shape.toml:", "edge_lenth"]);
    let single = "path = \"mesh.body.vertices[2]\"\nremesh = { edge_length = 0.2, every = 7 }\n";
    let whole = "path = \"mesh.body.vertices\"\n";
    let alone = sandbox("", "");
    let text = String::from_utf8(alone.read("shape.toml")).unwrap();
    alone.write("shape.toml", text.replace(whole, single));
    alone.refuse_with(&["optimize", "shape.toml"], &["remesh", "all vertices of a mesh"]);
    let sandbox = Sandbox::new();
    let light = OPTIMIZE.replace(
        "path = \"light.key.position\"",
        "path = \"light.key.position\"\nlarge_steps = 1.0",
    );
    sandbox.write("light.toml", format!("{SCENE}{light}"));
    sandbox.refuse_with(&["optimize", "light.toml"], &["large_steps", "vertices of a mesh"]);
}
