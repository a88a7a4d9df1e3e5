#!/usr/bin/env python3
"""The same scenes in Mitsuba 3 (LLVM back-end) and in `renderer bench`, in turns.

    python3 -m venv VENV && VENV/bin/pip install mitsuba numpy       # and an LLVM library, e.g. libllvm19
    VENV/bin/python renderer/benches/mitsuba/compare.py target/release/renderer SCENE.toml [PARAM ..]
        [--threads N] [--rounds N]

SCENE.toml is a scene file of the renderer: point lights, OBJ meshes and matt materials; `tree.toml`, `teapot.toml` and
`sphere.toml` beside this file are three. PARAM are the paths of the parameters to differentiate by (light positions and
intensities, diffuse colours, vertices); without any, those of the scene file.

A round starts one process of each. Both repeat each figure for a second; printed are the medians and the minima
over the rounds of their medians and minima, in milliseconds, and the ratio Mitsuba / ours. An iteration is:
write the parameters, update the scene, render, mean squared error, gradient. `frozen` is Mitsuba's iteration under
dr.freeze, which it cannot do for geometry. The images are compared first: Mitsuba's with 64 samples per pixel, ours with
one ray through the middle, so pixels on edges differ.
"""
import argparse, json, os, re, subprocess, sys, tempfile, time, tomllib

PI = 3.141592653589793


def mitsuba_scene(mi, path):
    """The scene in Mitsuba's terms. Both: radiance = albedo / pi * intensity / r^2 * cosine."""
    toml = tomllib.load(open(path, "rb"))
    folder = os.path.dirname(os.path.abspath(path))
    camera = toml["camera"]
    if camera.get("film_scale", 1.0) != 1.0:
        sys.exit("compare.py: camera.film_scale has to be 1")
    film = {"type": "hdrfilm", "width": camera["width"], "height": camera["height"], "rfilter": {"type": "box"},
            "pixel_format": "rgb", "component_format": "float32"}
    look = mi.ScalarTransform4f().look_at(origin=camera["look_from"], target=camera["look_at"],
                                          up=camera.get("up", [0, 1, 0]))
    scene = {"type": "scene", "sensor": {
        "type": "perspective", "fov_axis": "y", "fov": camera.get("vfov", 45.0), "to_world": look,
        "sampler": {"type": "independent", "sample_count": 1}, "film": film}}
    for light in toml["light"]:
        if light["type"] != "point":
            sys.exit("compare.py: only point lights")
        intensity = light["radiant_intensity"] if "radiant_intensity" in light else light["power"] / (4 * PI)
        color = [c * intensity for c in light.get("color", [1.0, 1.0, 1.0])]
        scene["light_" + light["name"]] = {
            "type": "point", "position": light["position"], "intensity": {"type": "rgb", "value": color}}
    materials = toml.get("material", {})
    for mesh in toml["mesh"]:
        obj = os.path.join(folder, mesh["path"])
        stem = os.path.splitext(os.path.basename(obj))[0]
        groups = split_by_material(obj) if "material" not in mesh else {mesh["material"]: obj}
        for name, part in groups.items():
            material = materials.get(name, {})
            if any(material.get("specular", [0.0])):
                sys.exit(f"compare.py: material.{name} is not matt")
            diffuse = material.get("diffuse") or library_color(obj, name)
            bsdf = {"type": "twosided", "bsdf": {
                "type": "diffuse", "reflectance": {"type": "rgb", "value": diffuse}}}
            key = f"mesh_{stem}" + (f"_{name}" if len(groups) > 1 else "")
            scene[key] = {"type": "obj", "filename": part, "face_normals": mesh.get("normals") != "smooth", "bsdf": bsdf}
    return scene, toml


def split_by_material(path):
    """One file for each material: Mitsuba's OBJ plugin ignores `usemtl`."""
    vertices, groups, name = [], {}, "default"
    for line in open(path):
        words = line.split()
        if words[:1] in (["v"], ["vn"], ["vt"]):
            vertices.append(line)
        elif words[:1] == ["usemtl"]:
            name = words[1]
        elif words[:1] == ["f"]:
            groups.setdefault(name, []).append(line)
    folder = tempfile.mkdtemp()
    files = {}
    for name, faces in groups.items():
        files[name] = os.path.join(folder, f"{name}.obj")
        with open(files[name], "w") as out:
            out.writelines(vertices + faces)
    return files


def library_color(obj, name):
    """`Kd` of a material in the libraries of an OBJ file."""
    found, current = None, None
    for library in re.findall(r"^mtllib\s+(.*\S)", open(obj).read(), re.M):
        for line in open(os.path.join(os.path.dirname(obj), library)):
            words = line.split()
            if words[:1] == ["newmtl"]:
                current = words[1]
            elif words[:1] == ["Kd"] and current == name:
                found = [float(x) for x in words[1:4]]
    return found or [0.7] * 3


def mitsuba_keys(params, path):
    """What a path of ours is called in Mitsuba."""
    kind, name, field = path.split(".", 2)
    if kind == "light":
        return [f"light_{name}." + {"position": "position", "radiant_intensity": "intensity.value"}[field]]
    if kind == "mesh":
        return [k for k in params.keys() if k.startswith(f"mesh_{name}") and k.endswith(".vertex_positions")]
    if kind == "material" and field == "diffuse":
        keys = [k for k in params.keys() if k.endswith("reflectance.value") and f"_{name}." in k]
        return keys or [k for k in params.keys() if k.endswith("reflectance.value")][-1:]
    sys.exit(f"compare.py: no counterpart of {path}")


def median(xs):
    return sorted(xs)[len(xs) // 2]


def iterations(dr, mi, scene, params, keys, integrator, target):
    """Two functions of a seed: one writes the parameters, as leaves, and one takes a whole iteration."""
    values = {key: type(params[key])(dr.detach(params[key])) for key in keys}

    def write(seed):
        leaves = []
        for key in keys:
            moved = values[key]
            if key.endswith("vertex_positions"):   # or else the tree would not be updated
                offset = mi.Float(1e-7 * (1 + seed % 13))
                dr.make_opaque(offset)
                moved = moved + offset
            leaf = type(values[key])(moved)
            dr.eval(leaf)
            dr.enable_grad(leaf)
            params[key] = leaf
            leaves.append(leaf)
        params.update()
        return leaves

    def iteration(seed):
        leaves = write(seed)
        image = mi.render(scene, params, integrator=integrator, spp=1, seed=seed)
        loss = dr.mean(dr.square(image - target), axis=None)
        dr.backward(loss)
        dr.eval([dr.grad(leaf) for leaf in leaves], loss)
        dr.sync_thread()

    return write, iteration


def repeat(f):
    """Median and minimum of its milliseconds, over a second after warming up."""
    for seed in range(3):
        f(1000 + seed)
    times, start = [], time.perf_counter()
    while len(times) < 5 or time.perf_counter() - start < 1.0:
        begin = time.perf_counter()
        f(len(times))
        times.append((time.perf_counter() - begin) * 1e3)
    return [median(times), min(times)]


def run_mitsuba(arguments):
    """One process of Mitsuba; prints its figures as JSON."""
    import drjit as dr
    import mitsuba as mi
    mi.set_variant("llvm_ad_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    dr.set_thread_count(arguments.threads)
    description, toml = mitsuba_scene(mi, arguments.scene)
    integrator = mi.load_dict({"type": "direct", "emitter_samples": 1, "bsdf_samples": 0})
    scene = mi.load_dict(description, optimize=False)
    paths = arguments.parameters or [p["path"] for p in toml.get("optimize", {}).get("parameter", [])]
    params = mi.traverse(scene)
    keys = [key for path in paths for key in mitsuba_keys(params, path)]
    moves = any(key.endswith("vertex_positions") for key in keys)

    def primal(seed):
        image = mi.render(scene, integrator=integrator, spp=1, seed=seed)
        dr.eval(image)
        dr.sync_thread()
        return image

    target = mi.TensorXf(primal(0)) * 0.9
    dr.eval(target)
    write, iteration = iterations(dr, mi, scene, params, keys, integrator, target)

    @dr.freeze
    def frozen_gradient(scene, integrator, target, seed):
        image = mi.render(scene, mi.traverse(scene), integrator=integrator, spp=1, seed=seed)
        loss = dr.mean(dr.square(image - target), axis=None)
        dr.backward(loss)
        return loss

    def frozen(seed):
        leaves = write(seed)
        opaque = mi.UInt32(seed)
        dr.make_opaque(opaque)
        loss = frozen_gradient(scene, integrator, target, opaque)
        dr.eval([dr.grad(leaf) for leaf in leaves], loss)
        dr.sync_thread()

    out = {"image": repeat(primal), "iteration": repeat(iteration)}
    if not moves:
        out["frozen"] = repeat(frozen)
    status = open("/proc/self/status").read()
    out["peak memory"] = [float(re.search(r"VmHWM:\s*(\d+)", status)[1]) / 1024] * 2
    if arguments.image:
        import numpy as np
        np.save(arguments.image, np.array(mi.render(scene, integrator=integrator, spp=64)))
    print(json.dumps(out))


def run_ours(arguments, edges="off"):
    command = [arguments.renderer, "bench", arguments.scene, "--edges", edges, "--threads", str(arguments.threads)]
    for path in arguments.parameters:
        command += ["--param", path]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = {}
    for name, median, least in re.findall(r"^(image|iteration)\b[^\n]*?([\d.]+) +([\d.]+)$", text, re.M):
        rows[name] = [float(median), float(least)]
    rows["frozen"] = rows["iteration"]
    rows["peak memory"] = [float(re.search(r"^peak memory.*?([\d.]+)$", text, re.M)[1])] * 2
    return rows


def compare_images(arguments, theirs):
    import mitsuba as mi
    import numpy as np
    mi.set_variant("scalar_rgb")
    ours = os.path.join(tempfile.mkdtemp(), "ours.exr")
    subprocess.run([arguments.renderer, "render", arguments.scene, "-o", ours], check=True, capture_output=True)
    a, b = np.array(mi.Bitmap(ours).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)), np.load(theirs)
    difference = np.abs(a - b).max(-1) / b.max()
    print("images: difference relative to the brightest pixel: median %.1e, 95%% of the pixels below %.1e"
          % (np.median(difference), np.quantile(difference, 0.95)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("renderer"), parser.add_argument("scene"), parser.add_argument("parameters", nargs="*")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--mitsuba-alone", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--image", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.mitsuba_alone:
        return run_mitsuba(arguments)

    image = os.path.join(tempfile.mkdtemp(), "mitsuba.npy")
    ours, theirs = [], []
    for round in range(arguments.rounds):
        command = [sys.executable, os.path.abspath(__file__), "--mitsuba-alone", "--threads", str(arguments.threads)]
        command += ["--image", image] if round == 0 else []
        output = subprocess.run(command + [arguments.renderer, arguments.scene, *arguments.parameters],
                                check=True, capture_output=True, text=True).stdout
        theirs.append(json.loads(output.splitlines()[-1]))
        ours.append(run_ours(arguments))
    compare_images(arguments, image)
    print("%s, %d threads  %26s %32s" % (arguments.scene, arguments.threads, "median (ratio)", "least (ratio)"))
    for name in theirs[0]:
        line = "%-12s" % name
        for i, choose in ((0, median), (1, min)):
            a, b = (choose([round[name][i] for round in side]) for side in (theirs, ours))
            line += "  Mitsuba %9.3f  ours %9.3f  (%5.2f)" % (a, b, a / b)
        print(line)


if __name__ == "__main__":
    main()
