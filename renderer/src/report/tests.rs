//! Pages of whole and of broken folders.

use std::fs;

use super::*;

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in files {
        fs::write(folder.path().join(name), content).unwrap();
    }
    folder
}

const SUMMARY: &str = r#"{
    "loss": {"initial": 0.5, "final": 1e-9, "ratio": 2e-9}, "iterations": 12, "seconds": 1.25,
    "stop_detail": "<done>", "parameters": {"light.<b>.position": {"initial": [1, 2, 3],
    "final": [4, 5, 6]}, "texture.w.texels": {"initial": [0,0,0,0,0,0,0,0,0,0,0,0,0],
    "final": [0,0,0.5,0,0,0,0,0,0,0,0,0,0]}}, "largest_difference": 0.25,
    "settings": {"command": "renderer optimize <a>", "most iterations": 9},
    "pictures": [{"path": "texture.w", "initial": "a.png", "final": "b.png"}], "strip": [{"iteration": 0, "loss": 0.5, "file": "a.png"},
    {"iteration": 12, "loss": 1e-9, "file": "b.png"}]
}"#;

#[test]
fn what_is_there_is_on_the_page() {
    let folder = folder(&[
        ("summary.json", SUMMARY),
        ("history.csv", "iteration,loss,gradient_norm,seconds\n0,0.5,1,0\n1,1e-9,1,0.1\n"),
        (
            "trajectory.json",
            r#"{"paths": ["x"], "target": [null], "iterations": [0, 12], "values": [[1], [2]]}"#,
        ),
        ("target.png", "not looked into"),
        ("final.png", "d"),
        ("difference.png", "c"),
        ("a.png", "a"),
        ("b.png", "b"),
        ("scene.toml", "# </pre><script>alert(1)</script>"),
    ]);
    let page = report_page(folder.path()).unwrap();
    for part in [
        "<th>final over initial</th><td>2.00e-9</td>",
        "&lt;done&gt;",
        "<th>command</th><td>renderer optimize &lt;a&gt;</td>",
        "<th>most iterations</th><td>9</td>",
        "texture.w, recovered</figcaption>",
        "<span>0</span><span>0.125</span><span>0.25</span>",
        "<div id=\"comparison\" hidden>",
        "<th>texture.w.texels</th><td>13 numbers from 0 to 0, mean 0</td>",
        "moved by 0.1387 (root mean square); most: [2] 0 → 0.5, [0] 0 → 0, [1] 0 → 0",
        "light.&lt;b&gt;.position",
        "<td>4, 5, 6</td>",
        "initial loss 5.000e-1, lowest 1.000e-9",
        "class=\"curve\"",
        "max=\"1\" value=\"1\"",
        "iteration 12, loss 1.000e-9",
        "&lt;script&gt;alert(1)",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    for part in ["<th>true</th>", "The dashed line"] {
        assert!(!page.contains(part), "the truth is not known, but the page has {part}");
    }
    // Nothing on it is fetched: every address is data.
    assert_eq!(page.matches(" src=").count(), page.matches(" src=\"data:").count());
    assert!(!page.contains("href=") && !page.contains("<link") && !page.contains("url("));
    assert_eq!(page.matches("<script>").count(), 1);
}

#[test]
fn the_truth_stands_where_it_is_known() {
    let folder = folder(&[
        (
            "summary.json",
            r#"{"parameters": {"a": {"initial": [1], "final": [2]},
            "b": {"initial": [3], "final": [4], "target": [5.5]}}}"#,
        ),
        (
            "trajectory.json",
            r#"{"paths": ["a", "b"], "target": [null, 5.5], "iterations": [0], "values": [[1, 3]]}"#,
        ),
    ]);
    let page = report_page(folder.path()).unwrap();
    for part in ["<th>recovered</th><th>true</th>", "<td>4</td><td>5.5</td>", "The dashed line"] {
        assert!(page.contains(part), "{part}: {page}");
    }
}

#[test]
fn a_summary_is_enough_and_needed() {
    let bare = folder(&[("summary.json", "{}")]);
    assert!(report_page(bare.path()).unwrap().contains("<h2>Result</h2>"));
    let empty = folder(&[]);
    let error = report_page(empty.path()).unwrap_err();
    assert!(error.place.ends_with("summary.json") && error.problem.contains("renderer optimize"));
}

#[test]
fn broken_files_are_named() {
    for (name, content, expected) in [
        ("summary.json", "{", "summary.json: is broken: EOF"),
        ("history.csv", "a\n0,1,2,3\n1,nan,2,3\n", "history.csv:3: must be an iteration and three"),
        ("history.csv", "a\n0,1\n", "history.csv:2: must be"),
        ("trajectory.json", "[]", "trajectory.json: is broken: "),
        (
            "trajectory.json",
            r#"{"paths": ["x"], "target": [], "iterations": [], "values": []}"#,
            "trajectory.json: is broken: its parts differ in length",
        ),
        ("summary.json", r#"{"strip": 3}"#, "summary.json: strip is broken: "),
    ] {
        let folder = folder(&[("summary.json", "{}"), (name, content)]);
        let error = report_page(folder.path()).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn what_moved_most_is_drawn() {
    let count = MOST_CHARTS + 10;
    // One element is small, and moves by all of its size.
    let moved = |i: usize| match i {
        0..MOST_CHARTS => [1.0, 2.0],
        MOST_CHARTS => [0.0, 1e-6],
        _ => [1.0, 1.0],
    };
    let trajectory = Trajectory {
        paths: (0..count).rev().map(|i| format!("x[{i}]")).collect(),
        target: vec![None; count],
        iterations: vec![0, 1],
        values: vec![
            (0..count).rev().map(|i| moved(i)[0]).collect(),
            (0..count).rev().map(|i| moved(i)[1]).collect(),
        ],
    };
    assert!(drawn(&trajectory).into_iter().eq(10..count));
    assert!(trajectories(&trajectory).contains("10 more, which moved less"));
}
