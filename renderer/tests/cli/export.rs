//! Meshes for other programs.

use crate::sandbox::Sandbox;

#[test]
fn scenes_are_written_as_meshes() {
    let sandbox = Sandbox::new();
    for file in ["object.glb", "object.obj"] {
        let output = sandbox.run(&["export", "scene.toml", "-o", file]);
        assert_eq!(String::from_utf8(output.stdout).unwrap(), format!("{file}\n"));
        let warning = format!(
            "warning: {file}: spheres are left out (1 in the scene): only meshes are written\n"
        );
        assert_eq!(String::from_utf8(output.stderr).unwrap(), warning);
        assert!(output.status.success());
        sandbox.succeed(&["render", file, "-o", "picture.png", "--width", "8"]);
    }
    assert!(sandbox.path("object.mtl").is_file());
    // What a recovery leaves is a scene as any other.
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out", "--iterations", "1"]);
    sandbox.succeed(&["export", "out/scene.toml", "-o", "found.glb"]);
    assert_eq!(sandbox.read("found.glb"), sandbox.read("object.glb"));
}

#[test]
fn what_cannot_be_written_is_refused() {
    let sandbox = Sandbox::new();
    sandbox.refuse_with(&["export", "scene.toml", "-o", "a.stl"], &["a.stl: ", ".glb", ".obj"]);
    sandbox.refuse_with(&["export", "scene.toml", "-o", "a/b.glb"], &["a/b.glb", "does not exist"]);
    sandbox.refuse_with(&["export", "scene.toml", "-o", "floor.obj"], &["floor.obj", "exists"]);
    sandbox.write("kept.mtl", "");
    sandbox.refuse_with(&["export", "scene.toml", "-o", "kept.obj"], &["kept.mtl", "exists"]);
    sandbox.refuse_with(&["export", "none.toml", "-o", "a.glb"], &["none.toml"]);
}
