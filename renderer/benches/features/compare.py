#!/usr/bin/env python3
"""What a scene pays for features that it does not use.

    python3 renderer/benches/features/compare.py [FEATURE ..] [--rounds N]

The sources are copied to `target/features`. There the renderer is built as it is, and once without each feature: the
places where the integrator asks whether a scene has it are replaced by the answer (`PATCHES` below; a place that is no
longer there stops the script), so that the compiler leaves the code of the feature out. All builds render the same two
scenes, which use none of the features, and compute their gradients by everything: a mesh of 78,400 triangles under one
point light, and a single triangle, the only scene in which nothing can cast a shadow. Hashes of image and gradient have
to be the same in all builds.

The programs run in turns, those of the features that are named, or of all. Printed is the median over the rounds of
the time of the whole renderer over that of the build without the feature, in the same round, and what lies between the
quartiles. The first row compares the whole renderer with a copy of itself: what differs there is noise.
"""
import argparse, os, pathlib, shutil, statistics, subprocess, sys

INTEGRATOR = "renderer/src/integrator/"
# By feature: the scenes that do not use it, and (file, what stands there, what it is replaced by).
PATCHES = {
    "textures": (("sphere", "triangle"), [
        ("textures.rs", "if self.textures.is_empty() ||", "if true ||"),
    ]),
    "spheres": (("sphere", "triangle"), [
        ("view.rs", "(Shape::Spheres(leaves), spheres),", ""),
        ("view.rs", "Shape::Spheres(leaves) => {", "Shape::Spheres(leaves) => { unreachable!();"),
        ("sweep.rs", "Shape::Spheres(leaves) => {", "Shape::Spheres(leaves) => { unreachable!();"),
        ("../acceleration/packet_queries.rs", "self.spheres.visit_packet::<false>(&mut packet, |leaf, packet| {",
         "let _ = (|leaf: &SphereLeaf, packet: &mut Packet| {"),
        ("../acceleration/packet_queries.rs", "self.spheres.visit_packet::<true>(&mut packet, |leaf, packet| {",
         "let _ = (|leaf: &SphereLeaf, packet: &mut Packet| {"),
    ]),
    "several lights": (("sphere", "triangle"), [
        ("shade.rs", "let others = &self.lights[..index];", "let others = &self.lights[..0];"),
        ("shade.rs", "for (index, light) in lights.iter().enumerate() {",
         "if let Some((index, light)) = lights.iter().enumerate().next() {"),
        ("shadows.rs", "lit.extend(self.lights.iter().enumerate().map(",
         "lit.extend(self.lights.iter().enumerate().take(1).map("),
    ]),
    "shadows": (("triangle",), [
        ("shadows.rs", "if self.is_alone(view) {", "if true {"),
        ("shadows.rs", "if rays == 0 || self.is_alone(view) {", "if true {"),
    ]),
    "reflections": (("sphere", "triangle"), [
        ("mirrors.rs", "if !dark.mirrors && !self.has_mirrors && !self.has_transparency {", "if true {"),
        ("radiance.rs", "sight.views().get(1)", "None"),
        ("sweep.rs", "let beyond = views.get(1).zip(deeper.first_mut());",
         "let beyond: Option<(&View<L>, &mut Flow<L>)> = None;"),
        ("sweep.rs", "let beyond = deeper.first().filter(|_| views.len() > 1);",
         "let beyond: Option<&Flow<L>> = None;"),
        ("sweep.rs", "for depth in 1..views.len() {", "for depth in 1..1 {"),
        ("sweep.rs", "for depth in (1..views.len()).rev() {", "for depth in (1..1).rev() {"),
    ]),
    "transparency": (("sphere", "triangle"), [
        ("transparency.rs", "if !self.has_transparency {", "if true {"),
        ("shade.rs", "match &self.cover {", "match &None::<Cover<L>> {"),
        ("shade.rs", "match self.passed.get(light) {", "match None::<&Passed<L>> {"),
        ("shade.rs", "for (index, passed) in self.passed.iter().enumerate() {",
         "for (index, passed) in self.passed.iter().take(0).enumerate() {"),
    ]),
    "distant lights": (("sphere", "triangle"), [
        ("shade.rs", "Light::Distant(light) => light.reflect(self),", "Light::Distant(_) => unreachable!(),"),
        ("shade.rs", "Some(Light::Distant(last)) => self.pull_back_from(last, respond, to_light, to_shown),",
         "Some(Light::Distant(_)) => unreachable!(),"),
        ("shade.rs", "Light::Distant(light) => self.pull_back_to(light, cotangent, &mut pulled, to_light),",
         "Light::Distant(_) => unreachable!(),"),
        ("shadows.rs", "Light::Distant(light) => self.lit_along(light.direction.normalize(), view),",
         "Light::Distant(_) => unreachable!(),"),
    ]),
    "user-defined shapes": (("sphere", "triangle"), [
        ("view.rs", "(Shape::Custom, custom),", ""),
        ("view.rs", "Shape::Custom => self.custom_surface(&primitives, ray, alive),", "Shape::Custom => unreachable!(),"),
        ("sweep.rs", "Shape::Custom => prepared.pull_custom_surface(group, surface, &mut self.sums.shapes),",
         "Shape::Custom => unreachable!(),"),
        ("sweep.rs", "if !custom_lights.is_empty() {", "if false {"),
        ("custom.rs", "if self.scene.shapes.is_empty() {", "if true {"),
        ("custom.rs", "self.scene.custom_lights.is_empty()", "true"),
        ("custom.rs", "0..self.scene.shapes.len()", "0..0"),
        ("shadows.rs", "if !self.scene.shapes.is_empty() {", "if false {"),
        ("shade.rs", "in self.illuminations.iter().enumerate()", "in self.illuminations.iter().take(0).enumerate()"),
    ]),
}
# Everything that neither scene uses.
PATCHES["all of them but shadows"] = (("sphere", "triangle"), [
    patch for name, (_, patches) in PATCHES.items() if name != "shadows" for patch in patches])


def copy_sources(to):
    files = subprocess.check_output(["git", "ls-files"], text=True).splitlines()
    shutil.rmtree(to, ignore_errors=True)
    for file in files:
        (to / file).parent.mkdir(parents=True, exist_ok=True)
        # With the time of now: what an earlier run patched is built anew.
        shutil.copyfile(file, to / file)


def patched(source, patches):
    """Applies patches; the texts before."""
    before = {}
    for file, old, new in patches:
        path = source / INTEGRATOR / file
        text = path.read_text()
        before.setdefault(path, text)
        if old not in text:
            sys.exit(f"compare.py: {file}: `{old}` is no longer there")
        path.write_text(text.replace(old, new))
    return before


def build(folder, name, patches):
    source = folder / "source"
    before = patched(source, patches)
    command = ["cargo", "bench", "-p", "renderer", "--no-default-features", "--bench", "features", "--no-run"]
    environment = {**os.environ, "CARGO_TARGET_DIR": str(folder / "target")}
    built = subprocess.run(command, cwd=source, env=environment, capture_output=True, text=True)
    if built.returncode != 0:
        sys.exit(f"compare.py: without {name}:\n{built.stderr}")
    line = next(line for line in built.stderr.splitlines() if "Executable" in line)
    program = folder / name.replace(" ", "-")
    shutil.copy2(source / line[line.rindex("(") + 1:line.rindex(")")], program)
    for path, text in before.items():
        path.write_text(text)
    return program


def run(program):
    """By scene: times of image and gradient, and the hash."""
    lines = subprocess.check_output([program, "plain"], text=True).splitlines()
    rows = [line.split() for line in lines]
    return {scene: (float(image), float(gradient), digest) for scene, image, gradient, digest in rows}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("features", nargs="*", default=list(PATCHES), metavar="FEATURE", help=", ".join(PATCHES))
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--build-only", action="store_true")
    parser.add_argument("--run-only", action="store_true", help="with the builds of an earlier run")
    arguments = parser.parse_args()
    if unknown := set(arguments.features) - set(PATCHES):
        parser.error(f"no feature {', '.join(unknown)}: there are {', '.join(PATCHES)}")
    folder = pathlib.Path("target/features").absolute()
    patches = {name: PATCHES[name] for name in arguments.features}
    builds = {"nothing (a copy)": (("sphere", "triangle"), []), **patches}
    programs = {name: folder / name.replace(" ", "-") for name in ["whole", *builds]}
    if not arguments.run_only:
        copy_sources(folder / "source")
        whole = build(folder, "whole", [])
        shutil.copy2(whole, programs["nothing (a copy)"])
        for name, (_, of_feature) in patches.items():
            build(folder, name, of_feature)
    if arguments.build_only:
        return
    rounds = []
    for _ in range(arguments.rounds):
        rounds.append({name: run(program) for name, program in programs.items()})
    print(f"{'without':<26} {'scene':<10} {'image':>8} {'quartiles':>17} {'gradient':>9} {'quartiles':>17}")
    for name, (scenes, _) in builds.items():
        for scene in scenes:
            if any(times[name][scene][2] != times["whole"][scene][2] for times in rounds):
                sys.exit(f"compare.py: without {name}, {scene} is another image or gradient")
            cells = []
            for what in (0, 1):
                ratios = [times["whole"][scene][what] / times[name][scene][what] for times in rounds]
                low, middle, high = statistics.quantiles(ratios, n=4)
                cells.append(f"{middle:>8.3f} {f'{low:.3f} .. {high:.3f}':>17}")
            print(f"{name:<26} {scene:<10} {cells[0]} {cells[1]}")


main()
