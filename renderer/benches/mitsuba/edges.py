#!/usr/bin/env python3
"""Gradients that see silhouettes: Mitsuba's `direct_projective` and `renderer bench --edges on`, in turns.

    VENV/bin/python renderer/benches/mitsuba/edges.py target/release/renderer SCENE.toml MESH [--threads N] [--rounds N]
        [--step S]

SCENE.toml is what `compare.py` takes, MESH the name of a mesh in it. Mitsuba's integrator has no edges of shadows of
point lights, so its indirect boundary is off (`sppi = 0`); a light at the camera hides its shadows, and both gradients mean
the same.

Printed are milliseconds of an iteration by all vertices, as `compare.py` explains them, and what the derivative of a
weighted image by moving the mesh as a whole is off from central differences of the same program's finely sampled images,
with one sample per pixel; of Mitsuba's the mean over many seeds, and how far a single one is from that mean.
"""
import argparse, json, os, subprocess, sys, tempfile

import numpy as np

from compare import iterations, median, mitsuba_keys, mitsuba_scene, repeat, run_ours

WEIGHT = 0.1   # of the image itself, as if the target were a little darker
OFFSETS = np.eye(3)


def differences(render, weights, step):
    """The derivatives of a weighted image by the offset of a mesh."""
    return [((render(step * e) - render(-step * e)) * weights).sum() / (2 * step) for e in OFFSETS]


def off(found, expected):
    return float(np.linalg.norm(np.subtract(found, expected)) / np.linalg.norm(expected))


def run_mitsuba(arguments):
    """One process of Mitsuba; prints its figures as JSON."""
    import drjit as dr
    import mitsuba as mi
    mi.set_variant("llvm_ad_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    dr.set_thread_count(arguments.threads)
    description, _ = mitsuba_scene(mi, arguments.scene)
    scene = mi.load_dict(description, optimize=False)
    params = mi.traverse(scene)
    key, = mitsuba_keys(params, f"mesh.{arguments.mesh}.vertices")
    projective = mi.load_dict({"type": "direct_projective", "sppi": 0})
    direct = mi.load_dict({"type": "direct", "emitter_samples": 1, "bsdf_samples": 0})
    vertices = np.array(params[key]).reshape(-1, 3)

    def render(offset):
        params[key] = mi.Float((vertices + offset).ravel())
        params.update()
        return np.float64(mi.render(scene, integrator=direct, spp=1024))

    image = render(0)
    weights = 2 * WEIGHT * image / image.size
    _, iteration = iterations(dr, mi, scene, params, [key], projective, mi.TensorXf((1 - WEIGHT) * image))
    out = {"iteration": repeat(iteration)}
    if arguments.gradients:
        gradients = []
        for seed in range(arguments.gradients):
            leaf = mi.Float(vertices.ravel())
            dr.enable_grad(leaf)
            params[key] = leaf
            params.update()
            image = mi.render(scene, params, integrator=projective, spp=1, seed=seed)
            dr.backward(dr.sum(image * mi.TensorXf(weights), axis=None))
            gradients.append(np.array(dr.grad(leaf)).reshape(-1, 3).sum(0))
        mean = np.mean(gradients, axis=0)
        out["off"] = off(mean, differences(render, weights, arguments.step))
        out["noise"] = median([off(gradient, mean) for gradient in gradients])
    print(json.dumps(out))


def accuracy_of_ours(arguments):
    import mitsuba as mi
    mi.set_variant("scalar_rgb")
    folder = tempfile.mkdtemp()
    file, target = os.path.join(folder, "image.exr"), os.path.join(folder, "target.exr")
    path = f"mesh.{arguments.mesh}.translation"

    def run(*words):
        return subprocess.run([arguments.renderer, *words], check=True, capture_output=True, text=True).stdout

    def render(*words):
        run("render", arguments.scene, "-o", file, *words)
        rgb = mi.Bitmap(file).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)
        return np.float64(np.array(rgb))

    def moved(offset):
        return render("--samples", "64", "--set", f"{path}=" + ",".join(map(str, offset)))

    image = render()
    mi.Bitmap(np.float32((1 - WEIGHT) * image)).write(target)
    found = json.loads(run("gradient", arguments.scene, "--target", target, "--param", path, "--edges", "on", "--json"))
    return off(found[path], differences(moved, 2 * WEIGHT * image / image.size, arguments.step))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("renderer"), parser.add_argument("scene"), parser.add_argument("mesh")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--step", type=float, default=0.01)
    parser.add_argument("--mitsuba-alone", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--gradients", type=int, default=0, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.mitsuba_alone:
        return run_mitsuba(arguments)

    arguments.parameters = [f"mesh.{arguments.mesh}.vertices"]
    theirs, ours, without = [], [], []
    for round in range(arguments.rounds):
        command = [sys.executable, os.path.abspath(__file__), *sys.argv[1:], "--mitsuba-alone"]
        command += ["--gradients", "32"] if round == 0 else []
        output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        theirs.append(json.loads(output.splitlines()[-1]))
        ours.append(run_ours(arguments, "on")["iteration"])
        without.append(run_ours(arguments)["iteration"])
    for i, name, choose in ((0, "median", median), (1, "least", min)):
        a, b, c = (choose([times[i] for times in rounds])
                   for rounds in ([round["iteration"] for round in theirs], ours, without))
        print("iteration, %-6s  Mitsuba %9.3f  ours %9.3f  (%5.2f)  ours without edges %9.3f" % (name, a, b, a / b, c))
    print("off from differences: Mitsuba %.3f (and one seed from the mean %.3f), ours %.3f" % (
        theirs[0]["off"], theirs[0]["noise"], accuracy_of_ours(arguments)))


if __name__ == "__main__":
    main()
