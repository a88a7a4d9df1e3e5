#!/usr/bin/env python3
"""Gradients by vertices that see silhouettes: Mitsuba's `direct_projective` and `renderer bench --edges on`, in turns.

    VENV/bin/python renderer/benches/mitsuba/edges.py target/release/renderer SCENE.toml PARAM [--threads N] [--rounds N]

SCENE.toml is what `compare.py` takes, PARAM the path of the vertices of a mesh. Mitsuba's integrator has no edges of
shadows of point lights, so its indirect boundary is off (`sppi = 0`); a light at the camera, which hides its shadows, makes both
gradients mean the same.

Printed are milliseconds of an iteration, as `compare.py` explains them, and what one gradient of Mitsuba's is off from
the mean of many, relative to its norm; then what ours is off from that mean, which has noise of its own. The loss of these
gradients weighs the image with fixed numbers: with the target and the noise of one image its gradient would be biased.
"""
import argparse, json, os, subprocess, sys, tempfile, tomllib

from compare import iterations, median, mitsuba_keys, mitsuba_scene, repeat, run_ours


def run_mitsuba(arguments):
    """One process of Mitsuba; prints its figures as JSON."""
    import drjit as dr
    import mitsuba as mi
    import numpy as np
    mi.set_variant("llvm_ad_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    dr.set_thread_count(arguments.threads)
    description, _ = mitsuba_scene(mi, arguments.scene)
    scene = mi.load_dict(description, optimize=False)
    params = mi.traverse(scene)
    keys = mitsuba_keys(params, arguments.parameter)
    projective = mi.load_dict({"type": "direct_projective", "sppi": 0})
    reference = mi.render(scene, integrator=mi.load_dict({"type": "direct", "emitter_samples": 1, "bsdf_samples": 0}), spp=512)
    target = mi.TensorXf(reference * 0.9)
    dr.eval(target)
    write, iteration = iterations(dr, mi, scene, params, keys, projective, target)
    out = {"positions": np.concatenate([np.array(params[key]).ravel() for key in keys]).tolist()}
    out["iteration"] = repeat(iteration)
    if arguments.target:
        mi.Bitmap(target).write(arguments.target)
        weights = mi.TensorXf(2 * (reference - target) / dr.prod(target.shape))
        gradients = []
        for seed in range(arguments.gradients):
            leaves = write(seed)
            dr.backward(dr.sum(mi.render(scene, params, integrator=projective, spp=1, seed=seed) * weights, axis=None))
            gradients.append(np.concatenate([np.array(dr.grad(leaf)).ravel() for leaf in leaves]))
        out["gradients"] = [gradient.tolist() for gradient in gradients]
    print(json.dumps(out))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("renderer"), parser.add_argument("scene"), parser.add_argument("parameter")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--gradients", type=int, default=64)
    parser.add_argument("--mitsuba-alone", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--target", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.mitsuba_alone:
        return run_mitsuba(arguments)

    target = os.path.join(tempfile.mkdtemp(), "target.exr")
    arguments.parameters = [arguments.parameter]
    ours, theirs = [], []
    for round in range(arguments.rounds):
        command = [sys.executable, os.path.abspath(__file__), "--mitsuba-alone", *sys.argv[1:]]
        command += ["--target", target] if round == 0 else []
        output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        theirs.append(json.loads(output.splitlines()[-1]))
        ours.append([run_ours(arguments, edges)["iteration"] for edges in ("on", "off")])
    for i, name in enumerate(("median", "least")):
        choose = (median, min)[i]
        a, b, c = (choose(times) for times in ([r["iteration"][i] for r in theirs], [r[0][i] for r in ours], [r[1][i] for r in ours]))
        print("iteration, %-6s  Mitsuba %9.3f  ours %9.3f  (%5.2f)  ours without edges %9.3f" % (name, a, b, a / b, c))
    compare_gradients(arguments, target, theirs[0])


def compare_gradients(arguments, target, theirs):
    import numpy as np
    command = [arguments.renderer, "gradient", arguments.scene, "--target", target, "--param", arguments.parameter, "--json"]
    output = subprocess.run(command + ["--edges", "on"], check=True, capture_output=True, text=True).stdout
    name = arguments.parameter.split(".")[1]
    mesh, = (m for m in tomllib.load(open(arguments.scene, "rb"))["mesh"] if os.path.splitext(os.path.basename(m["path"]))[0] == name)
    obj = open(os.path.join(os.path.dirname(os.path.abspath(arguments.scene)), mesh["path"]))
    positions = [[float(x) for x in line.split()[1:4]] for line in obj if line.startswith("v ")]
    # Mitsuba splits vertices: what stands at one place belongs together.
    places, order = np.unique(np.float32(positions), axis=0, return_inverse=True)

    def by_place(numbers, order):
        total = np.zeros((len(places), 3))
        np.add.at(total, order, np.reshape(numbers, (-1, 3)))
        return total

    ours = by_place(json.loads(output)[arguments.parameter], order)
    index = {tuple(place): i for i, place in enumerate(places)}
    order = [index[tuple(place)] for place in np.float32(theirs["positions"]).reshape(-1, 3)]
    gradients = [by_place(gradient, order) for gradient in theirs["gradients"]]
    mean = np.mean(gradients, axis=0)
    off = lambda gradient: np.linalg.norm(gradient - mean) / np.linalg.norm(mean)
    whole = lambda gradient: np.linalg.norm(gradient.sum(0) - mean.sum(0)) / np.linalg.norm(mean.sum(0))
    for what, measure in (("all vertices", off), ("their sum", whole)):
        print("%-12s  off from the mean of %d: one of Mitsuba's %.3f, ours %.3f (the mean itself about %.3f)" % (
            what, len(gradients), median([measure(g) for g in gradients]), measure(ours),
            median([measure(g) for g in gradients]) / len(gradients) ** 0.5))


if __name__ == "__main__":
    main()
