#!/usr/bin/env python3
"""What a scene pays for features that it does not use.

    python3 renderer/benches/features/compare.py [FEATURE ..] [--rounds N]

The sources are copied to `target/features`. There the renderer is built as it is, and once without each feature: the
places where the renderer asks whether a scene has it are replaced by the answer (`PATCHES` below; a place that is no
longer there stops the script), so that the compiler leaves the code of the feature out. All builds render the same two
scenes, which use none of the features, and compute their gradients by everything: a mesh of 78,400 triangles under one
point light, and a single triangle, the only scene in which nothing can cast a shadow. Hashes of image and gradient have
to be the same in all builds.

The programs run in turns, those of the features that are named, or of all. Printed is the median over the rounds of
the time of the whole renderer over that of the build without the feature, in the same round, and what lies between the
quartiles. The first row compares the whole renderer with a copy of itself: what differs there is noise.
"""
import argparse, os, pathlib, shutil, statistics, subprocess, sys

SOURCES = "renderer/src/"
BOTH = ("sphere", "triangle")
# By feature: the scenes that do not use it, and (file, what stands there, what it is replaced by).
PATCHES = {
    "textures": (BOTH, [
        ("primal/vertex.rs", "if self.layout.textures.is_empty() ||", "if true ||"),
    ]),
    "spheres": (BOTH, [
        ("primal/hits.rs", "(Kind::Sphere, sphere),", "(Kind::Sphere, 0),"),
        ("primal/gather.rs", "Kind::Sphere => Some(Primitive::Sphere(self.sphere(primitives))),",
         "Kind::Sphere => unreachable!(),"),
        ("adjoint/chain.rs", "Kind::Sphere => {", "Kind::Sphere => { unreachable!();"),
        ("trace/bvh/packet_queries.rs", "nearest_of(&self.spheres, &mut packet, directions, hits);", ""),
        ("trace/bvh/packet_queries.rs", "| occluded_by(&self.spheres, &mut packet, directions)", ""),
    ]),
    "several lights": (BOTH, [
        ("primal/vertex.rs", "for (index, light) in lights.iter().enumerate() {",
         "if let Some((index, light)) = lights.iter().enumerate().next() {"),
        ("primal/shadow.rs", "visible.extend(self.layout.lights.iter().enumerate().map(",
         "visible.extend(self.layout.lights.iter().enumerate().take(1).map("),
        ("adjoint/chain.rs", "let own = vertex.own(others) + reflected;",
         "let own = vertex.own(&others[..0]) + reflected;"),
        ("adjoint/chain.rs", "in others.iter().enumerate() {", "in others.iter().take(0).enumerate() {"),
        ("adjoint/chain.rs", "in lights.iter().enumerate() {", "in lights.iter().take(1).enumerate() {"),
    ]),
    "shadows": (("triangle",), [
        ("primal/shadow.rs", "if self.is_alone(wavefront) {", "if true {"),
        ("primal/shadow.rs", "if rays == 0 || self.is_alone(wavefront) {", "if true {"),
    ]),
    "mirrors and depth": (BOTH, [
        ("primal/path.rs", "if !goes_on {", "if true {"),
        ("primal/image.rs", "wavefronts.get(1)", "None"),
        ("adjoint/chain.rs", "let beyond = wavefronts.get(depth + 1).zip(deeper.first_mut());",
         "let beyond: Option<(&Wavefront<L>, &mut AdjointState<L>)> = None;"),
        ("adjoint/chain.rs", "let beyond = deeper.first().filter(|_| depth + 1 < wavefronts.len());",
         "let beyond: Option<&AdjointState<L>> = None;"),
        ("adjoint/chain.rs", "for depth in 0..wavefronts.len() {", "for depth in 0..1 {"),
        ("adjoint/chain.rs", "for depth in (0..wavefronts.len()).rev() {", "for depth in (0..1).rev() {"),
    ]),
    "transparency": (BOTH, [
        ("primal/transmission.rs", "if !self.layout.has_transparency {", "if true {"),
        ("primal/gather.rs", "if !self.layout.has_transparency {", "if true {"),
        ("primal/vertex.rs", "self.wavefront.transmissions.get(light)?",
         "self.wavefront.transmissions.get(light).filter(|_| false)?"),
    ]),
    "user-defined shapes and lights": (BOTH, [
        ("primal/hits.rs", "(Kind::Custom, hit & !triangle & !sphere),", "(Kind::Custom, 0),"),
        ("primal/gather.rs", "None => self.custom_surface(primitives, ray),", "None => unreachable!(),"),
        ("primal/inputs.rs", "kernel.at::<S>().illuminate(numbers, point + *origin)", "unreachable!()"),
        ("primal/inputs.rs", "kernel.at::<S>().pull_illuminate(numbers, point, cotangent, &mut to_number)",
         "unreachable!()"),
        ("adjoint/chain.rs", "return self.pull_custom_surface(group, surface);", "unreachable!();"),
        ("trace/bvh/packet_queries.rs", "nearest_of(&self.customs, &mut packet, directions, hits);", ""),
        ("trace/bvh/packet_queries.rs", "| occluded_by(&self.customs, &mut packet, directions)", ""),
    ]),
    "distant and spot lights": (BOTH, [
        ("primal/shadow.rs", "None => self.visible_along(light, wavefront),", "None => unreachable!(),"),
        ("primal/inputs.rs", "Self::Known(light) => illuminate::<S>(*light, point),",
         "Self::Known(light) => { let Light::Point(light) = *light else { unreachable!() };"
         " crate::transport::light::illuminate_by_point::<S>(light, point) }"),
        ("primal/inputs.rs", "let (_, pullback) = illuminate::vjp::<S>(*light, point);",
         "let Light::Point(known) = *light else { unreachable!() };"
         " let (_, pullback) = crate::transport::light::illuminate_by_point::vjp::<S>(known, point);"),
        ("primal/inputs.rs", "match_light!(light, _light, cotangent, part => part.visit(&mut to_number));",
         "cotangent.visit(&mut to_number);"),
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
        path = source / SOURCES / file
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
