#!/usr/bin/env python3
"""Renders the same scenes by this program and by Mitsuba 3, and says how far the pictures are apart.

    pip install mitsuba numpy OpenEXR
    cargo build --release
    python tests/compare/mitsuba.py target/release/implicit                 # every scene
    python tests/compare/mitsuba.py target/release/implicit gold glass     # scenes whose names hold one of these
    python tests/compare/mitsuba.py target/release/implicit --pictures DIR # both pictures and their difference, as PNG
    python tests/compare/mitsuba.py target/release/implicit --speed        # processor time instead

Mitsuba's variant llvm_ad_rgb is used where it runs (LLVM 16 or later; DRJIT_LIBLLVM_PATH says where it is), else scalar_rgb.
Ends with 1 if a scene fails.

What is compared. Radiance in linear sRGB, box filter on both sides, each side rendered with two seeds: a1 a2 (this program), b1 b2
(Mitsuba), a = (a1 + a2)/2, b = (b1 + b2)/2.

    apart = mean |a - b| / mean b
    noise = mean |(a1 - a2) + (b1 - b2)| / 2 / mean b    what `apart` would be of noise alone: both have the same variance
    whole = (mean a - mean b) / mean b

over pixels and channels, after averaging blocks of 1, 2, 4, 8 or 16 pixels a side: the smallest for which the noise is at most NOISE.
A scene fails if `apart` is more than MOST, or more than RATIO times its noise and more than MODEL, or if the noise stays too great.

Where the models differ, by right:
- Mitsuba's rough metals and glass scatter once, and mask by Smith's separable G; here what meets several facets is kept and masking is
  correlated by height. Compared at roughness <= 0.2 (alpha = r^2 = 0.04) only, where both make less than 1 %.
- `plastic` and `roughplastic` are the same model with nonlinear = true, the rough coat but for G as above and for what its facets lose:
  under an even sky a white ball of roughness 0.2 shows 1 here and 0.965 there, of roughness 0.3 0.919. The darker, the nearer.
- a tinted metal is Mitsuba's `principled` with metallic = 1.
- Mitsuba computes in single precision and moves rays off surfaces by an epsilon.
- Mitsuba has no sun with an angle: a far disc that glows stands for it. Its sky of gradients is a picture.
- Mitsuba's `path` finds no light of a point through glass: `light` is compared with its `ptracer` there.
"""
import argparse, functools, json, os, resource, statistics, subprocess, sys, tempfile, time

sys.path.pop(0)  # the folder of this file, whose name is that of the package

import mitsuba as mi
import numpy as np
import OpenEXR

ROUNDS = 3  # of four times the samples each, until the noise is low enough
NOISE = 0.004  # of the mean: less than half of MOST
MOST = 0.01  # the farthest that pictures may be apart
RATIO = 1.5  # pictures of the same are apart by their noise; two seeds know the noise of some thousand blocks within a tenth
MODEL = 0.003  # below this the masking functions and single precision may differ
SIZE = (128, 96)
EYE, LOOK_AT, FOV = (5, -5, 3), (0, 0, 0), 40


# Materials: what this program calls them, what Mitsuba calls them.

def rgb(*c):
    return "rgb(" + ", ".join(map(repr, c)) + ")", {"type": "rgb", "value": list(map(float, c))}


def two_sided(text, bsdf):
    return text, {"type": "twosided", "bsdf": bsdf}


def matte(*c):
    ours, theirs = rgb(*c)
    return two_sided(f"kind: matte, color: {ours}", {"type": "diffuse", "reflectance": theirs})


def plastic(*c, roughness=0.0):
    ours, theirs = rgb(*c)
    bsdf = {"type": "plastic", "diffuse_reflectance": theirs, "int_ior": 1.5, "ext_ior": 1.0, "nonlinear": True}
    if roughness:
        bsdf.update(type="roughplastic", distribution="ggx", alpha=roughness**2)
    return two_sided(f"kind: plastic, ior: 1.5, color: {ours}, roughness: {roughness}", bsdf)


def measured(n, k, roughness=0.0):
    (n, eta), (k, absorbing) = rgb(*n), rgb(*k)
    bsdf = {"type": "conductor", "eta": eta, "k": absorbing}
    if roughness:
        bsdf.update(type="roughconductor", distribution="ggx", alpha=roughness**2)
    return two_sided(f"kind: metal, n: {n}, k: {k}, roughness: {roughness}", bsdf)


def tinted(*c, roughness):
    ours, theirs = rgb(*c)
    bsdf = {"type": "principled", "base_color": theirs, "metallic": 1.0, "roughness": roughness}
    return two_sided(f"kind: metal, color: {ours}, roughness: {roughness}", bsdf)


def mirror(*c):
    ours, theirs = rgb(*c)
    bsdf = {"type": "conductor", "material": "none", "specular_reflectance": theirs}
    return two_sided(f"kind: mirror, color: {ours}", bsdf)


def glass(ior=1.5, roughness=0.0, absorption=None, outside=1.0):
    bsdf = {"type": "dielectric", "int_ior": ior, "ext_ior": outside}
    if roughness:
        bsdf.update(type="roughdielectric", distribution="ggx", alpha=roughness**2)
    text = f"kind: glass, ior: {ior}, roughness: {roughness}"
    if absorption:
        text += f", absorption: {rgb(*absorption)[0]}"
    return text, bsdf


GOLD = ((0.14, 0.37, 1.44), (3.98, 2.39, 1.60))


# Things: the program's line, Mitsuba's shapes.

def ball(at, radius, material, glow=None, absorption=None):
    x, y, z = at
    text, bsdf = material
    shape = {"type": "sphere", "center": list(at), "radius": radius, "bsdf": bsdf}
    if glow:
        text += f", emission: {rgb(*glow)[0]}"
        shape["emitter"] = {"type": "area", "radiance": rgb(*glow)[1]}
    if absorption:
        shape["interior"] = {"type": "homogeneous", "albedo": 0.0, "sigma_t": rgb(*absorption)[1]}
    return f"(x-({x}))^2+(y-({y}))^2+(z-({z}))^2={radius**2!r} {{{text}}}", [shape]


def sheet(axis, at, middle, half, material, glow=None):
    """A square of an axis' plane, both of its sides alike."""
    center = list(middle)
    center[axis] = at
    text, bsdf = material
    spans = ", ".join(f"{c - (0.1 if i == axis else half)!r}..{c + (0.1 if i == axis else half)!r}" for i, c in enumerate(center))
    turn = {0: ([0, 1, 0], 90), 1: ([1, 0, 0], -90), 2: ([0, 0, 1], 0)}[axis]
    place = mi.ScalarTransform4f().translate(center).rotate(*turn).scale(half)
    shapes = [{"type": "rectangle", "to_world": place, "bsdf": bsdf}]
    if glow:
        text += f", emission: {rgb(*glow)[0]}"
        light = {"type": "area", "radiance": rgb(*glow)[1]}
        gap = [1e-4 * (i == axis) for i in range(3)]
        back = mi.ScalarTransform4f().translate([c - g for c, g in zip(center, gap)]).rotate(*turn).rotate([1, 0, 0], 180).scale(half)
        shapes = [{**shapes[0], "emitter": light}, {**shapes[0], "to_world": back, "emitter": light}]
    return f"{'xyz'[axis]}={at} {{{text}, clip: box({spans})}}", shapes


def floor(material=None, at=-1, half=4):
    return sheet(2, at, (0, 0, 0), half, material or matte(0.5, 0.5, 0.6))


def ball_light(at, radius, power):
    radiance = power / (4 * np.pi**2 * radius**2)
    dark = {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.0] * 3}}
    light = {"type": "area", "radiance": {"type": "rgb", "value": [radiance] * 3}}
    shape = {"type": "sphere", "center": list(at), "radius": radius, "bsdf": dark, "emitter": light}
    return f"light {{at: {tuple(at)}, power: {power}, radius: {radius}}}", [shape]


def point_light(at, power):
    intensity = {"type": "rgb", "value": [power / (4 * np.pi)] * 3}
    return f"light {{at: {tuple(at)}, power: {power}}}", [{"type": "point", "position": list(at), "intensity": intensity}]


def sun(toward, irradiance, angle=0.0):
    d = np.array(toward, float) / np.linalg.norm(toward)
    text = f"sun {{from: {tuple(toward)}, irradiance: {irradiance}, angle: {angle}}}"
    if not angle:
        return text, [{"type": "directional", "direction": (-d).tolist(), "irradiance": {"type": "rgb", "value": [irradiance] * 3}}]
    far, half = 1e4, np.radians(angle / 2)
    place = mi.ScalarTransform4f().look_at((d * far).tolist(), [0, 0, 0], [0, 0, 1]).scale(float(far * np.tan(half)))
    radiance = {"type": "rgb", "value": [irradiance / (np.pi * np.sin(half) ** 2)] * 3}
    return text, [{"type": "disk", "to_world": place, "emitter": {"type": "area", "radiance": radiance}}]


def sky(*c):
    return f"sky {{radiance: 1, color: {rgb(*c)[0]}}}", [{"type": "constant", "radiance": rgb(*c)[1]}]


def gradient(top, horizon, ground, height=1024):
    sine = np.cos((np.arange(height) + 0.5) / height * np.pi)[:, None, None]
    top_, horizon_, ground_ = (np.array(c, float) for c in (top, horizon, ground))
    rows = np.where(sine > 0, horizon_ + (top_ - horizon_) * sine, ground_) * np.ones((1, 8, 1))
    up = mi.ScalarTransform4f().rotate([1, 0, 0], 90)
    picture = {"type": "envmap", "bitmap": mi.Bitmap(rows.astype(np.float32)), "to_world": up}
    return f"sky {{top: {rgb(*top)[0]}, horizon: {rgb(*horizon)[0]}, ground: {rgb(*ground)[0]}}}", [picture]


def room(half, material):
    return [sheet(axis, side * half, (0, 0, 0), half, material) for axis in range(3) for side in (-1, 1)]


def scenes():
    """Name, things, bounces, Mitsuba's integrator, the modes that are compared, the camera (eye, what it looks at, angle)."""
    sphere = lambda material, **more: ball((0, 0, 0), 1, material, **more)
    lamp, orange = ball_light((2, -2, 3), 0.5, 100), matte(0.8, 0.5, 0.3)
    clear, low = ("path", "bidirectional"), -1.2
    every, no_light = ("path", "light", "bidirectional"), ("path", "bidirectional")
    tint, blue = (0.1, 0.3, 0.8), (0.5, 0.4, 0.3)
    table = [
        ("matte, ball light", [sphere(orange), floor(), lamp], 4, every),
        ("matte, point", [sphere(orange), floor(), point_light((2, -2, 3), 100)], 4, every),
        ("matte, sun", [sphere(orange), floor(), sun((1, -1, 2), 3)], 4, every),
        ("matte, sun of 20 degrees", [sphere(orange), floor(), sun((1, -1, 2), 3, 20)], 4, every),
        ("matte, sky", [sphere(orange), floor(), sky(0.7, 0.9, 1.2)], 4, every),
        ("matte, gradient", [sphere(orange), floor(), gradient((1, 1, 2), blue, (0.1, 0.1, 0.1))], 4, every),
        ("matte, glowing ball", [sphere(orange), floor(), ball((1.5, -1.5, 1), 0.3, orange, glow=(15, 12, 9))], 4, every),
        ("matte, glowing square", [sphere(orange), floor(), sheet(2, 2, (0, 0, 0), 0.7, matte(0, 0, 0), glow=(6, 5, 4))], 4, every),
        ("matte, four lights", [sphere(orange), floor(), lamp, sky(0.1, 0.1, 0.2), sun((-1, -1, 1), 1), point_light((-2, -2, 2), 30)], 4, every),
        ("direct light only", [sphere(orange), floor(), lamp], 1, every),
        ("white room", [*room(2, matte(0.8, 0.8, 0.7)), sphere(orange), ball_light((0, 0, 1.5), 0.3, 50)], 10, every, ((1.7, -1.7, 0.3), (0, 0, -0.2), 80)),
        ("plastic", [sphere(plastic(0.8, 0.2, 0.1)), floor(plastic(0.5, 0.5, 0.6)), lamp], 5, no_light),
        ("rough plastic", [sphere(plastic(0.8, 0.2, 0.1, roughness=0.2)), floor(plastic(0.5, 0.5, 0.6, roughness=0.2)), lamp], 4, every),
        ("white plastic, sky", [sphere(plastic(1, 1, 1)), floor(), sky(1, 1, 1)], 4, no_light),
        ("gold", [sphere(measured(*GOLD)), floor(), lamp], 4, no_light),
        ("rough gold", [sphere(measured(*GOLD, roughness=0.2)), floor(), lamp], 4, every),
        ("rough gold, sky", [sphere(measured(*GOLD, roughness=0.2)), floor(), gradient((1, 1, 2), blue, (0.1, 0.1, 0.1))], 4, every),
        ("tinted metal", [sphere(tinted(0.9, 0.5, 0.1, roughness=0.2)), floor(), lamp], 4, every),
        ("mirror", [sphere(mirror(0.9, 0.8, 0.7)), floor(), lamp], 6, no_light),
        ("two mirrors", [sphere(mirror(0.9, 0.8, 0.7)), floor(mirror(0.8, 0.8, 0.9)), ball((-1.5, -1, -0.5), 0.4, orange), lamp], 6, no_light),
        ("glass", [sphere(glass()), floor(at=low), ball_light((2, -2, 3), 1, 100)], 8, clear),
        ("glass, sky", [sphere(glass()), floor(at=low), gradient((1, 1, 2), blue, (0.1, 0.1, 0.1))], 8, clear),
        ("rough glass", [sphere(glass(roughness=0.2)), floor(at=low), ball_light((2, -2, 3), 1, 100)], 8, clear),
        ("dark glass", [sphere(glass(absorption=tint), absorption=tint), floor(at=low), ball_light((2, -2, 3), 1, 100)], 8, clear, "volpath"),
        ("glass in water", [ball((0, 0, 0), 0.5, glass(outside=1.33)), sphere(glass(ior=1.33)), floor(at=low), ball_light((2, -2, 3), 1, 100)], 10, clear),
        ("glow in glass", [sphere(glass()), ball((0, 0, 0), 0.5, matte(0, 0, 0), glow=(3, 2, 1)), floor(at=low)], 8, clear),
        ("matte in glass", [sphere(glass()), ball((0, 0, 0), 0.5, orange), floor(at=low), ball_light((2, -2, 3), 1, 100)], 8, clear),
        ("point through glass", [sphere(glass()), floor(at=low), point_light((2, -2, 3), 100)], 6, ("light",), "ptracer"),
    ]
    for name, things, bounces, modes, *more in table:
        integrator = next((m for m in more if isinstance(m, str)), "path")
        camera = next((m for m in more if not isinstance(m, str)), (EYE, LOOK_AT, FOV))
        yield name, things, bounces, integrator, modes, camera


# Both renderers.

def program_text(things, camera):
    eye, look_at, fov = camera
    lines = [line for line, _ in things]
    # Where glasses overlap, what is written later fills the place.
    glasses = [line for line in lines if "kind: glass" in line][::-1]
    lines = [line for line in lines if line not in glasses] + glasses
    return "; ".join(lines + [f"camera {{eye: {eye}, look_at: {look_at}, fov: {fov}}}", "render {clip: box(-4..4, -4..4, -2..2)}"])


def ours(program, text, mode, samples, bounces, size, seed, *more):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a.exr")
        command = [program, text, "--mode", mode, "--samples", samples, "--bounces", bounces, "--size", "%dx%d" % size]
        command += ["--seed", seed, "--filter", "box", "--quiet", "-o", path, *more]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{done.stderr}\nin: {text}")
        channels = OpenEXR.File(path).channels()
        picture = channels["RGB"].pixels if "RGB" in channels else np.stack([channels[c].pixels for c in "RGB"], -1)
        return picture.astype(float)


def theirs_scene(things, bounces, integrator, size, camera):
    eye, look_at, fov = camera
    film = {"type": "hdrfilm", "width": size[0], "height": size[1], "rfilter": {"type": "box"}}
    place = mi.ScalarTransform4f().look_at(list(eye), list(look_at), [0, 0, 1])
    sampler = {"type": "multijitter", "sample_count": SPEED["samples"]}
    view = {"fov": fov, "fov_axis": "y", "near_clip": 1e-3, "to_world": place}
    scene = {
        "type": "scene",
        "integrator": {"type": integrator, "max_depth": bounces + 1, "rr_depth": 1000},
        "sensor": {"type": "perspective", **view, "film": film, "sampler": sampler},
    }
    shapes = [shape for _, shapes in things for shape in shapes]
    scene.update({f"thing{k}": shape for k, shape in enumerate(shapes)})
    return mi.load_dict(scene)


def theirs(scene, samples, seed):
    return np.array(mi.render(scene, spp=samples, seed=seed)).astype(float)


def variant():
    """The quickest variant that runs: a wrong LLVM ends the process, so another one tries."""
    attempt = ("import mitsuba as mi; mi.set_variant('llvm_ad_rgb'); "
               "mi.render(mi.load_dict({'type': 'scene', 'a': {'type': 'sphere', 'bsdf': {'type': 'roughconductor'}}, 'i': {'type': 'path'}, "
               "'e': {'type': 'constant'}, 'c': {'type': 'perspective', 'film': {'type': 'hdrfilm', 'width': 4, 'height': 4}}}), spp=1).numpy()")
    done = subprocess.run([sys.executable, "-c", attempt], capture_output=True)
    return "llvm_ad_rgb" if done.returncode == 0 else "scalar_rgb"


# Comparison.

def blocks(picture, side):
    height, width = (n // side * side for n in picture.shape[:2])
    return picture[:height, :width].reshape(height // side, side, width // side, side, 3).mean((1, 3))


def compare(a, b):
    """Block side, apart, noise, whole."""
    for side in (1, 2, 4, 8, 16):
        (a1, a2), (b1, b2) = ([blocks(p, side) for p in pair] for pair in (a, b))
        mean = (b1 + b2).mean() / 2
        noise = np.abs((a1 - a2) + (b1 - b2)).mean() / 2 / mean
        if noise <= NOISE:
            break
    apart = np.abs((a1 + a2) - (b1 + b2)).mean() / 2 / mean
    return side, apart, noise, ((a1 + a2).mean() - (b1 + b2).mean()) / 2 / mean


def draw(folder, name, a, b):
    """This program's picture, Mitsuba's, and ten times their difference: red where this program is brighter, blue where darker."""
    a, b = sum(a) / 2, sum(b) / 2
    grey = lambda p: (p / (4 * np.median(b) + 1e-9)).clip(0, 1)
    part = (10 * (a - b).mean(-1) / b.mean()).clip(-1, 1)[..., None]
    difference = np.where(part > 0, [0, 1, 1], [1, 1, 0]) * -np.abs(part) + 1
    picture = np.concatenate([grey(a), grey(b), difference], 1).repeat(3, 0).repeat(3, 1)
    os.makedirs(folder, exist_ok=True)
    bitmap = mi.Bitmap(picture.astype(np.float32)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True)
    bitmap.write(os.path.join(folder, name.replace(" ", "-").replace(",", "") + ".png"))


# Processor time.

SPEED = {"size": (256, 256), "samples": 64, "bounces": 4}


def speed_things():
    return [ball((0, 0, 0), 1, matte(0.8, 0.5, 0.3)), floor(), ball_light((2, -2, 3), 0.5, 100)]


def time_theirs(kind):
    """Prints the processor seconds of pictures alone, the first and a later one, and the later one's noise; one thread."""
    import drjit
    drjit.set_thread_count(1)
    mi.set_variant(kind)
    scene = theirs_scene(speed_things(), SPEED["bounces"], "path", SPEED["size"], (EYE, LOOK_AT, FOV))
    seconds, pictures = [], []
    for seed in (1, 2):
        start = time.process_time()
        pictures.append(theirs(scene, SPEED["samples"], seed))
        seconds.append(time.process_time() - start)
    print(json.dumps([*seconds, pixel_noise(*pictures)]))


def pixel_noise(a, b):
    return float(np.sqrt(((a - b) ** 2).mean() / 2) / a.mean())


def time_ours(program, seed):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = program_text(speed_things(), (EYE, LOOK_AT, FOV))
    picture = ours(program, text, "path", SPEED["samples"], SPEED["bounces"], SPEED["size"], seed, "--threads", 1)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, picture


def speed(program, rounds=3):
    kinds = ["scalar_rgb"] + ["llvm_ad_rgb"] * (variant() == "llvm_ad_rgb")
    rows = {"this program, whole process": []} | {f"{kind}, {which} picture": [] for kind in kinds for which in ("first", "second")}
    noises = {}
    for turn in range(rounds):
        one, a = time_ours(program, 2 * turn + 1)
        two, b = time_ours(program, 2 * turn + 2)
        rows["this program, whole process"].append((one + two) / 2)
        noises["this program, whole process"] = pixel_noise(a, b)
        for kind in kinds:
            done = subprocess.run([sys.executable, __file__, program, "--time", kind], capture_output=True, text=True, check=True)
            first, second, noise = json.loads(done.stdout)
            for which, seconds in (("first", first), ("second", second)):
                rows[f"{kind}, {which} picture"].append(seconds)
                noises[f"{kind}, {which} picture"] = noise
    own = rows["this program, whole process"]
    million = SPEED["size"][0] * SPEED["size"][1] * SPEED["samples"] / 1e6
    print("| | s | million samples/s | over this program's time, median of pairs | noise of a pixel |\n| --- | --- | --- | --- | --- |")
    for name, seconds in rows.items():
        middle = statistics.median(seconds)
        ratio = statistics.median(s / o for s, o in zip(seconds, own))
        print(f"| {name} | {middle:.2f} | {million / middle:.2f} | {ratio:.2f} | {noises[name]:.2%} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("names", nargs="*", help="scenes whose names hold one of these")
    parser.add_argument("--samples", type=int, default=64, help="a pixel, for each of two seeds, on each side; more where that is not enough")
    parser.add_argument("--pictures", metavar="DIR")
    parser.add_argument("--speed", action="store_true")
    parser.add_argument("--time", help=argparse.SUPPRESS)
    arguments = parser.parse_intermixed_args()
    if arguments.time:
        return time_theirs(arguments.time)
    mi.set_variant("scalar_rgb")
    if arguments.speed:
        return speed(arguments.program)
    mi.set_variant(variant())
    print(f"Mitsuba {mi.__version__}, {mi.variant()}; two seeds; percent\n")
    print(f"{'scene':26} {'mode':14} {'samples':>7} {'block':>5} {'apart':>7} {'noise':>7} {'whole':>7}")
    failed = False
    for name, things, bounces, integrator, modes, camera in scenes():
        if arguments.names and not any(part in name for part in arguments.names):
            continue
        scene, text = theirs_scene(things, bounces, integrator, SIZE, camera), program_text(things, camera)
        known = functools.cache(lambda samples: [theirs(scene, samples, seed) for seed in (1, 2)])
        for mode in modes:
            for samples in (arguments.samples * 4**k for k in range(ROUNDS)):
                b = known(samples)
                a = [ours(arguments.program, text, mode, samples, bounces, SIZE, seed) for seed in (1, 2)]
                side, apart, noise, whole = compare(a, b)
                if noise <= NOISE:
                    break
            fails = bool(apart > MOST or noise > NOISE or apart > max(MODEL, RATIO * noise))
            failed |= fails
            print(f"{name:26} {mode:14} {samples:7} {side:5} {apart:7.2%} {noise:7.2%} {whole:+7.2%}{'  FAILS' * fails}", flush=True)
            if arguments.pictures:
                draw(arguments.pictures, f"{name} {mode}", a, b)
    return failed


if __name__ == "__main__":
    sys.exit(main())
