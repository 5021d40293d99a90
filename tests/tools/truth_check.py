"""A second opinion on the pictures of `truth.py`: the formulas as typed, sampled in doubles.

    python3 tests/tools/truth_check.py [NAME...]

In: cases.toml and the pictures. Out: for each case, how many hits do not look like one (f at the depth is neither small nor
between values of both signs), and how many pixels show an earlier change of sign. Doubles and samples prove nothing; the
script is there to find a case whose side conditions do not say what its formula says. Jumps and poles are expected to show.
"""

import math
import pathlib
import re
import sys
import tomllib

import numpy as np

from truth_rays import clip_size, clip_span, frame

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "data" / "exact"
SAMPLES = 4001


def real_power(a, p):
    return np.sign(a) * np.abs(a) ** p


def chebyshev(n, u):
    return np.polynomial.chebyshev.Chebyshev.basis(n)(u)


NAMES = dict(
    sin=np.sin, cos=np.cos, tan=np.tan, exp=np.exp, ln=np.log, log2=np.log2, sqrt=np.sqrt, abs=np.abs, floor=np.floor,
    ceil=np.ceil, sign=np.sign, asin=np.arcsin, acos=np.arccos, atan=np.arctan, atan2=np.arctan2, acosh=np.arccosh,
    atanh=np.arctanh, tanh=np.tanh, cosh=np.cosh, sinh=np.sinh, cbrt=np.cbrt, golden=(1 + math.sqrt(5)) / 2,
    round=lambda u: np.sign(u) * np.floor(np.abs(u) + 0.5), mod=lambda a, b: a - b * np.floor(a / b),
    step=lambda e, u: (u >= e) * 1.0, root=lambda n, u: real_power(u, 1 / n), chebyshev=chebyshev,
    erf=np.vectorize(math.erf), choose=np.where,
    min=lambda *a: np.minimum.reduce(np.broadcast_arrays(*a)), max=lambda *a: np.maximum.reduce(np.broadcast_arrays(*a)),
)


def compiled(formula):
    *definitions, text = formula.split(";")
    for definition in definitions:
        name, value = definition.split("=")
        text = re.sub(rf"\b{name.strip()}\b", f"({value})", text)
    text = text.replace("^(1/3)", "^third").replace("^(2/3)", "^two_thirds").replace("if(", "choose(")
    text = re.sub(r"\|(\w)\|", r"abs(\1)", text)
    text = re.sub(r"(\w)\^third", r"cbrt(\1)", text)
    text = re.sub(r"(\w)\^two_thirds", r"cbrt(\1)**2", text)
    left, _, right = text.replace("^", "**").partition("=")
    return compile(f"({left.strip()})-({right.strip() or 0})", formula, "eval")


def check(case):
    depths = np.load(FOLDER / f"{case['name']}.npy")
    f, r, u = (np.array(v) for v in frame(case["eye"], case["look_at"]))
    w, h, tangent = case["width"], case["height"], math.tan(math.radians(case["fov"]) / 2)
    code, size, eye = compiled(case["formula"]), clip_size(case["clip"]), np.array(case["eye"])
    odd, early = 0, 0
    for j in range(h):
        for i in range(w):
            t = depths[j, i]
            if math.isnan(t):
                continue
            d = f + ((i + 0.5) / w * 2 - 1) * (w / h) * tangent * r + (1 - (j + 0.5) / h * 2) * tangent * u
            d = d / np.linalg.norm(d)
            span = clip_span(case["clip"], case["eye"], list(d))
            if span is None:
                odd += math.isfinite(t)
                continue

            def values(s):
                x, y, z = (eye[k] + s * d[k] for k in range(3))
                return np.broadcast_to(eval(code, NAMES, dict(x=x, y=y, z=z)), s.shape)

            low, high = span[0] + 3e-6 * size, span[1] - 3e-6 * size
            end = min(high, t - 1e-5 * size)
            if end > low:
                front = values(np.linspace(low, end, SAMPLES))
                signs = np.sign(front[np.isfinite(front)])
                early += bool((signs[1:] * signs[:-1] < 0).any())
            if math.isfinite(t):
                near = values(t + size * np.array([-1e-6, 0.0, 1e-6]))
                good = near[np.isfinite(near)]
                odd += not (len(good) and (good.min() <= 0 <= good.max() or abs(good).min() < 1e-9 * abs(values(np.linspace(low, high, 9))).max()))
    return odd, early


def main():
    table = tomllib.loads((FOLDER / "cases.toml").read_text())["case"]
    for case in table:
        if len(sys.argv) > 1 and case["name"] not in sys.argv[1:]:
            continue
        with np.errstate(all="ignore"):
            odd, early = check(case)
        if odd or early:
            print(f"{case['name']}: {odd} hits look odd, {early} earlier changes of sign  [{case['formula'][:60]}]", flush=True)


if __name__ == "__main__":
    main()
