"""Makes the pictures of `tests/data/exact`: first roots along rays, decided by mathematics that shares nothing with the program.

    python3 tests/tools/truth.py [NAME...]        needs python-flint and numpy

In: the table of `truth_cases.py`. Out: NAME.npy (H x W float64 depths) and cases.toml, in the format of `tests/data/truth`.

A case is a list of pieces. A piece is an equation g = 0 with side conditions h > 0, such that the surface is the union of the
pieces: z = sqrt(x) is z^2 = x where z > 0. The first root of a piece along a ray is found in one of two ways:

* a polynomial piece is expanded along the ray with rational coefficients (the camera's doubles are fractions), and all its
  real roots are isolated with certified balls (flint, square-free factors, 128 bits);
* any other piece is searched front to back by bisection with balls of 128 bits: an interval is dropped when the ball of g,
  or its mean-value form, excludes 0; it holds at most one root when the ball of g' excludes 0; and a root is then refined
  by Newton steps that stay inside the ball.

Depths: +inf is a proven miss; NaN says that the picture leaves the pixel out, because a side condition or the clip's edge
is too near to call, or because the answer changes when the ray is moved by 1e-7.
"""

import multiprocessing
import pathlib
import sys

import numpy

from truth_cases import CASES
from truth_rays import stable_depth

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "data" / "exact"


def picture(name):
    case = CASES[name]
    rows = [[stable_depth(case, i, j) for i in range(case["width"])] for j in range(case["height"])]
    depths = numpy.array(rows, dtype="<f8")
    numpy.save(FOLDER / f"{name}.npy", depths)
    finite = numpy.isfinite(depths).sum()
    print(f"{name}: hits {finite}, misses {numpy.isposinf(depths).sum()}, left out {numpy.isnan(depths).sum()}", flush=True)


def write_table(cases):
    """cases.toml, with the counts read back from the pictures."""
    text = ["# Made by tests/tools/truth.py; conventions as in ../truth/cases.toml.\n"]
    for name, case in cases.items():
        depths = numpy.load(FOLDER / f"{name}.npy")
        key, numbers = next(iter(case["clip"].items()))
        text.append(
            f'\n[[case]]\nname = "{name}"\nformula = "{case["formula"]}"\n'
            f"clip = {{ {key} = {[float(v) for v in numbers]} }}\n"
            f"eye = {[float(v) for v in case['eye']]}\nlook_at = {[float(v) for v in case['look_at']]}\n"
            f"fov = {float(case['fov'])}\nwidth = {case['width']}\nheight = {case['height']}\n"
            f"hits = {numpy.isfinite(depths).sum()}\nleft_out = {numpy.isnan(depths).sum()}\n"
            f'decided = "{case["decided"]}"\n'
        )
    (FOLDER / "cases.toml").write_text("".join(text))


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    names = sys.argv[1:] or list(CASES)
    with multiprocessing.Pool(2) as pool:
        pool.map(picture, names, chunksize=1)
    if all((FOLDER / f"{name}.npy").exists() for name in CASES):
        write_table(CASES)


if __name__ == "__main__":
    main()
