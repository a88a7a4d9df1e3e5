//! The page on a run while it goes on.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, ChildStderr, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::sandbox::Sandbox;

/// More than a test waits for.
const ENDLESS: &str = "100000000";

/// A run with a page.
struct Run {
    child: Child,
    errors: BufReader<ChildStderr>,
    port: u16,
    token: String,
}

impl Run {
    fn start(sandbox: &Sandbox, more: &[&str]) -> Self {
        let arguments =
            ["optimize", "experiment.toml", "--target", "photo.png", "--out", "out", "--live", "0"];
        let mut command = sandbox.command(&[&arguments[..], more].concat());
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let mut errors = BufReader::new(child.stderr.take().unwrap());
        let mut line = String::new();
        while !line.contains("live: ") {
            line.clear();
            assert!(errors.read_line(&mut line).unwrap() > 0, "no address");
        }
        let address = line.trim().strip_prefix("live: http://127.0.0.1:").unwrap();
        let (port, token) = address.trim_end_matches('/').split_once('/').unwrap();
        Self { port: port.parse().unwrap(), token: token.to_owned(), child, errors }
    }

    /// Sends bytes; the status and the body of what comes back, if anything does.
    fn send(&self, bytes: &[u8]) -> Option<(u16, Vec<u8>)> {
        let mut connection = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        connection.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        // The server may have heard enough before the end.
        let _ = connection.write_all(bytes);
        let mut answer = Vec::new();
        let _ = connection.read_to_end(&mut answer);
        let end = answer.windows(4).position(|bytes| bytes == b"\r\n\r\n")?;
        let status = std::str::from_utf8(&answer[9..12]).unwrap().parse().unwrap();
        Some((status, answer.split_off(end + 4)))
    }

    fn ask(&self, method: &str, path: &str, host: &str) -> (u16, Vec<u8>) {
        let request = format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\n\r\n");
        self.send(request.as_bytes()).unwrap()
    }

    fn get(&self, path: &str) -> (u16, Vec<u8>) {
        self.ask("GET", &format!("/{}/{path}", self.token), "localhost")
    }

    fn post(&self, path: &str) -> u16 {
        self.ask("POST", &format!("/{}/{path}", self.token), "127.0.0.1:80").0
    }

    fn state(&self) -> Value {
        let (status, body) = self.get("state.json");
        assert_eq!(status, 200);
        serde_json::from_slice(&body).unwrap()
    }

    fn iteration(&self) -> u64 {
        self.state()["step"]["iteration"].as_u64().unwrap_or(0)
    }

    /// Waits until the run has gone on from an iteration.
    fn wait_beyond(&self, iteration: u64) {
        let deadline = Instant::now() + Duration::from_secs(60);
        while self.iteration() <= iteration {
            assert!(Instant::now() < deadline, "the run stands still");
            sleep(Duration::from_millis(5));
        }
    }

    /// Stops the run, and waits for its end; what it has said.
    fn stop(mut self) -> (Option<i32>, String) {
        self.post("stop");
        let mut said = String::new();
        self.errors.read_to_string(&mut said).unwrap();
        (self.child.wait().unwrap().code(), said)
    }
}

/// With a target that is never matched exactly.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_changed("truth.toml", "[1.5, 3.0, 2.0]", "[-1.0, 2.5, 2.5]");
    sandbox.succeed(&["render", "truth.toml", "-o", "photo.png"]);
    sandbox
}

#[test]
fn the_page_shows_the_run() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS]);
    let (status, page) = run.get("");
    let page = String::from_utf8(page).unwrap();
    assert!(status == 200 && page.starts_with("<!DOCTYPE html>"));
    // It needs nothing of elsewhere.
    for part in ["src=\"", "href=\"h", "@import", "url("] {
        assert!(!page.contains(part), "{part}");
    }
    run.wait_beyond(20);
    let state = run.state();
    assert_eq!((&state["phase"], &state["title"]), (&"running".into(), &"experiment.toml".into()));
    assert_eq!(state["views"], serde_json::json!(["camera"]));
    for number in ["loss", "seconds", "gradient_norm", "ratio", "factor"] {
        assert!(state["step"][number].as_f64().unwrap() > 0.0, "{number}");
    }
    let course = &state["course"];
    let count = |list: &Value| list.as_array().unwrap().len();
    assert!(count(&course["iterations"]) > 10);
    assert_eq!(count(&course["losses"]), count(&course["iterations"]));
    assert_eq!(count(&course["numbers"]), 4);
    for number in course["numbers"].as_array().unwrap() {
        assert!(number["path"].as_str().unwrap().starts_with("light.key."));
        assert_eq!(count(&number["values"]), count(&course["iterations"]));
    }

    let image = |path: &str| {
        let (status, body) = run.get(path);
        assert_eq!((status, &body[1..4]), (200, &b"PNG"[..]), "{path}");
        let decoder = png::Decoder::new(std::io::Cursor::new(&body));
        let info = decoder.read_info().unwrap();
        (info.info().width, info.info().height, body)
    };
    for path in ["current.png", "target.png?view=0", "difference.png"] {
        let (width, height, _) = image(path);
        assert_eq!((width, height), (24, 16), "{path}");
    }
    assert_eq!(image("target.png").2.len(), sandbox.read("out/target.png").len());
    run.post("pause");
    sleep(Duration::from_millis(200));
    let [front, same, side] = [
        "orbit.png?width=32&height=20",
        "orbit.png?width=32&height=20&turn=0",
        "orbit.png?width=32&height=20&turn=40&distance=2",
    ]
    .map(image);
    assert_eq!((front.0, front.1), (32, 20));
    assert!(front.2 == same.2 && front.2 != side.2);
    for (path, status) in [
        ("orbit.png?turn=nan", 400),
        ("orbit.png?rise=x", 400),
        ("current.png?view=1", 400),
        ("target.png?view=-1", 400),
        ("difference.png?view=0.5", 400),
        ("nothing", 404),
        ("../state.json", 404),
        ("stop", 405),
    ] {
        assert_eq!(run.get(path).0, status, "{path}");
    }
    assert_eq!(run.post("state.json"), 405);
    assert_eq!(run.stop().0, Some(130));
}

#[test]
fn strangers_are_turned_away() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS]);
    let wrong = "0".repeat(run.token.len());
    for path in [
        "/",
        "/state.json",
        &format!("/{wrong}/"),
        &format!("/{}", run.token),
        &format!("/{}0/", run.token),
    ] {
        assert_eq!(run.ask("GET", path, "localhost").0, 403, "{path}");
    }
    assert_eq!(run.ask("POST", &format!("/{wrong}/stop"), "localhost").0, 403);
    let path = format!("/{}/", run.token);
    for (host, status) in [
        ("evil.com", 403),
        ("127.0.0.1.evil.com:80", 403),
        ("192.168.0.1", 403),
        ("[::1]:7", 200),
        ("LocalHost", 200),
    ] {
        assert_eq!(run.ask("GET", &path, host).0, status, "{host}");
    }
    assert_eq!(run.state()["phase"], "running");
    assert_eq!(run.stop().0, Some(130));
}

#[test]
fn the_page_steers_the_run() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS]);
    run.wait_beyond(5);
    assert_eq!(run.post("pause"), 200);
    sleep(Duration::from_millis(200));
    let paused = run.state();
    sleep(Duration::from_millis(400));
    assert_eq!(
        (&paused["phase"], paused["step"].clone()),
        (&"paused".into(), run.state()["step"].clone())
    );
    let before = run.iteration();
    assert_eq!(run.post("learning_rate?factor=0.25"), 200);
    assert_eq!(run.post("go_on"), 200);
    run.wait_beyond(before + 5);
    let state = run.state();
    assert_eq!((&state["phase"], &state["step"]["factor"]), (&"running".into(), &0.25.into()));
    let rates = |state: &Value| state["step"]["rates"][0].as_f64().unwrap();
    assert!((rates(&state) / rates(&paused) - 0.25).abs() < 1e-12);
    // The pause took longer than these iterations do.
    assert!(
        state["step"]["seconds"].as_f64().unwrap() - paused["step"]["seconds"].as_f64().unwrap()
            < 0.4
    );
    for factor in ["0", "-1", "inf", "1e300", "x", ""] {
        assert_eq!(run.post(&format!("learning_rate?factor={factor}")), 400, "{factor}");
    }
    assert_eq!(run.post("learning_rate"), 400);
    // Also while it is paused.
    run.post("pause");
    let (code, said) = run.stop();
    assert_eq!(code, Some(130), "{said}");
    assert!(said.contains("go on with the same command and --resume"), "{said}");

    // The checkpoint keeps the learning rate.
    let checkpoint = sandbox.json("out/checkpoint.json");
    let factors = &checkpoint["state"]["learning_rate_factors"];
    assert_eq!((factors.as_array().unwrap().len(), &factors[0][1]), (1, &0.25.into()));
    let run = Run::start(&sandbox, &["--iterations", ENDLESS, "--resume"]);
    run.wait_beyond(checkpoint["state"]["iteration"].as_u64().unwrap() + 1);
    assert_eq!(run.state()["step"]["factor"], 0.25);
    assert_eq!(run.stop().0, Some(130));
}

#[test]
fn methods_without_a_learning_rate_get_none() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS, "--optimizer", "lm"]);
    assert_eq!(run.post("learning_rate?factor=0.5"), 400);
    assert_eq!(run.state()["has_rate"], false);
    run.post("stop");
}

/// Results, but for the time they took.
fn result(sandbox: &Sandbox, out: &str) -> (Vec<u8>, Vec<u8>, Vec<String>) {
    let history = String::from_utf8(sandbox.read(&format!("{out}/history.csv"))).unwrap();
    let losses = history.lines().map(|row| row.rsplit_once(',').unwrap().0.to_owned()).collect();
    let [scene, image] =
        ["scene.toml", "final.png"].map(|name| sandbox.read(&format!("{out}/{name}")));
    (scene, image, losses)
}

#[test]
fn a_run_that_is_watched_is_the_same() {
    let sandbox = sandbox();
    let iterations = ["--iterations", "1500"];
    let run = Run::start(&sandbox, &iterations);
    for path in ["current.png", "orbit.png?turn=10", "state.json", "difference.png"] {
        run.get(path);
    }
    run.post("pause");
    run.get("orbit.png?turn=20");
    let is_stopped = run.state()["phase"] == "paused";
    let (code, _) = run.stop();
    assert!(is_stopped && code == Some(130), "the run was over too soon");
    let arguments = ["optimize", "experiment.toml", "--target", "photo.png", "--out"];
    sandbox.succeed(&[&arguments[..], &["out", "--resume"], &iterations].concat());
    sandbox.succeed(&[&arguments[..], &["plain"], &iterations].concat());
    assert!(result(&sandbox, "out") == result(&sandbox, "plain"));
}

#[test]
fn hostile_clients_do_not_harm_the_run() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS]);
    let long = format!("GET /{} HTTP/1.1\r\nHost: localhost\r\n\r\n", "a".repeat(100_000));
    let headers = format!("GET / HTTP/1.1\r\n{}", "X: y\r\n".repeat(100_000));
    // Where a client is still talking, it may not hear why the server has hung up.
    for (bytes, status) in [(long, 431), (headers, 431)] {
        assert!(run.send(bytes.as_bytes()).is_none_or(|(said, _)| said == status));
    }
    for request in [
        &b"\r\n\r\n"[..],
        b"GET\r\n\r\n",
        b"GET / HTTP/1.1\r\n\r\n",
        b"GET nothing HTTP/1.1\r\nHost: localhost\r\n\r\n",
        b"\xff\xfe / HTTP/1.1\r\nHost: localhost\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: localhost\r\nno colon\r\n\r\n",
    ] {
        assert_eq!(run.send(request).unwrap().0, 400, "{request:?}");
    }
    // More than are served, most of which never finish their request.
    let connect = || TcpStream::connect(("127.0.0.1", run.port)).unwrap();
    let mut idle: Vec<TcpStream> = (0..64).map(|_| connect()).collect();
    for connection in &mut idle {
        let _ = connection.write_all(b"GET / HTTP/1.1\r\nHost: ");
    }
    // They are given up after some time, while the run goes on.
    let deadline = Instant::now() + Duration::from_secs(60);
    let request = format!("GET /{}/state.json HTTP/1.1\r\nHost: localhost\r\n\r\n", run.token);
    while run.send(request.as_bytes()).is_none() {
        assert!(Instant::now() < deadline, "the server is blocked");
        sleep(Duration::from_millis(50));
    }
    drop(idle);
    run.wait_beyond(run.iteration());
    assert_eq!(run.stop().0, Some(130));
}

/// As long as the command has something to write.
#[test]
fn the_page_hears_of_the_end() {
    let sandbox = sandbox();
    let mut run = Run::start(&sandbox, &["--iterations", "200"]);
    run.post("pause");
    let port = run.port;
    run.post("go_on");
    let mut said = String::new();
    run.errors.read_to_string(&mut said).unwrap();
    assert_eq!(run.child.wait().unwrap().code(), Some(0), "{said}");
    assert!(TcpStream::connect(("127.0.0.1", port)).is_err());
    assert!(fs::exists(sandbox.path("out/summary.json")).unwrap());
}

#[test]
fn ports_that_are_taken_are_named() {
    let sandbox = sandbox();
    let run = Run::start(&sandbox, &["--iterations", ENDLESS]);
    let port = run.port.to_string();
    let arguments = ["optimize", "experiment.toml", "--out", "other", "--live", &port];
    sandbox_refuses(&sandbox, &arguments, &["--live: 127.0.0.1", &port]);
    assert_eq!(run.stop().0, Some(130));
    sandbox.refuse_with(&["optimize", "experiment.toml", "--live", "99999"], &["--live", "99999"]);
    sandbox.refuse_with(&["optimize", "experiment.toml", "--live-address", "0.0.0.0"], &["--live"]);
}

/// While another run writes beside it.
fn sandbox_refuses(sandbox: &Sandbox, arguments: &[&str], parts: &[&str]) {
    let output = sandbox.run(arguments);
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{line}");
    assert!(parts.iter().all(|part| line.contains(part)) && line.lines().count() == 1, "{line}");
    assert!(!sandbox.path("other").exists());
}
