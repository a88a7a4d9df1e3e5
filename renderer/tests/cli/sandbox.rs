//! A folder of its own for each test, and the binary run in it.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::{Map, Value};
use tempfile::TempDir;

/// A camera, a light, a ball and a floor from an OBJ file. Small: each test renders it often.
pub const SCENE: &str = r#"
[camera]
look_from = [0.0, 1.5, 4.0]
look_at = [0.0, 0.3, 0.0]
width = 24
height = 16

[[light]]
name = "key"
type = "point"
position = [1.5, 3.0, 2.0]
radiant_intensity = 30.0

[[mesh]]
path = "floor.obj"

[[sphere]]
name = "ball"
center = [0.0, 0.5, 0.0]
radius = 0.5
material = "paint"

[material.paint]
diffuse = [0.6, 0.3, 0.2]
specular = [0.1, 0.1, 0.1]
exponent = 12.0
"#;

pub const FLOOR: &str = "\
v -2 0 -2
v 2 0 -2
v 2 0 2
v -2 0 2
f 4 3 2 1
";

/// What to find: a light, from the image that it makes.
pub const OPTIMIZE: &str = r#"
[optimize]
iterations = 40

[optimize.target_values]
"light.key.position" = [-1.0, 2.5, 2.5]
"light.key.radiant_intensity" = 22.5

[[optimize.parameter]]
path = "light.key.position"

[[optimize.parameter]]
path = "light.key.radiant_intensity"
"#;

pub struct Sandbox {
    folder: TempDir,
}

impl Sandbox {
    /// A folder with `scene.toml`, `floor.obj`, and `experiment.toml`, which is the scene and what
    /// to recover of it.
    pub fn new() -> Self {
        let sandbox = Self { folder: tempfile::tempdir().unwrap() };
        sandbox.write("scene.toml", SCENE);
        sandbox.write("floor.obj", FLOOR);
        sandbox.write("experiment.toml", format!("{SCENE}{OPTIMIZE}"));
        sandbox
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    /// A scene file that differs from [`SCENE`] in one place.
    pub fn write_changed(&self, name: &str, from: &str, to: &str) {
        assert_eq!(SCENE.matches(from).count(), 1, "{from}");
        self.write(name, SCENE.replace(from, to));
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn json(&self, name: &str) -> Value {
        serde_json::from_slice(&self.read(name)).unwrap()
    }

    /// The names of all files and folders, sorted.
    pub fn names(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The binary, to be run in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_renderer"));
        command.current_dir(self.folder.path()).args(arguments);
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs what has to succeed; its standard output.
    pub fn succeed(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
        String::from_utf8(output.stdout).unwrap()
    }

    /// Runs what has to print an object of numbers.
    pub fn succeed_json(&self, arguments: &[&str]) -> Map<String, Value> {
        let Value::Object(object) = serde_json::from_str(&self.succeed(arguments)).unwrap() else {
            panic!("an object");
        };
        // What stands beside the numbers of parameters is an object of its own.
        for (path, value) in object.iter().filter(|(_, value)| !value.is_object()) {
            assert!(!numbers(value).is_empty(), "{path}: {value}");
        }
        object
    }

    /// Runs what has to be refused: exit code 2, nothing on the standard output, one line on the
    /// standard error stream, no file made or changed. The line, without `error: `.
    pub fn refuse(&self, arguments: &[&str]) -> String {
        let before = self.snapshot();
        let output = self.run(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {errors}");
        assert_eq!(output.stdout, b"", "{arguments:?}");
        let line = errors.strip_suffix('\n').unwrap_or_else(|| panic!("{errors:?}"));
        assert!(!line.contains('\n') && !line.contains("panicked"), "{errors}");
        assert!(self.snapshot() == before, "{arguments:?} left files behind");
        line.strip_prefix("error: ").unwrap_or_else(|| panic!("{line}")).to_owned()
    }

    /// [`refuse`](Self::refuse) where the message has to hold all of `parts`.
    pub fn refuse_with(&self, arguments: &[&str], parts: &[&str]) {
        let line = self.refuse(arguments);
        for part in parts {
            assert!(line.contains(part), "{arguments:?}: no `{part}` in `{line}`");
        }
    }

    /// Every file with its content, and every folder.
    fn snapshot(&self) -> Vec<(PathBuf, Option<Vec<u8>>)> {
        let mut found = Vec::new();
        let mut open = vec![self.folder.path().to_owned()];
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(&folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    open.push(path.clone());
                    found.push((path, None));
                } else {
                    found.push((path.clone(), Some(fs::read(&path).unwrap())));
                }
            }
        }
        found.sort();
        found
    }
}

/// The numbers of a parameter in JSON, however nested; nothing else may be there.
pub fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number.as_f64().unwrap()],
        Value::Array(values) => values.iter().flat_map(numbers).collect(),
        other => panic!("not a number: {other}"),
    }
}
