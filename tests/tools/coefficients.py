"""Prints src/num/func/coefficients.rs: the polynomials and split constants of src/num/func. Needs mpmath.

Each polynomial interpolates its function at the Chebyshev nodes of the interval (within a factor of two of the
minimax polynomial); the error printed beside it is that of the rounded coefficients, measured on 2000 points, as
a fraction of the function it becomes a part of.

    python tests/tools/coefficients.py > src/num/func/coefficients.rs
"""

from mpmath import mp, mpf, matrix, lu_solve

mp.prec = 400


def fit(f, lo, hi, count):
    lo, hi = mpf(lo), mpf(hi)
    nodes = [(lo + hi) / 2 + (hi - lo) / 2 * mp.cos(mp.pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    rows = matrix(count, count)
    for i, x in enumerate(nodes):
        for j in range(count):
            rows[i, j] = x**j
    solution = lu_solve(rows, matrix([f(x) for x in nodes]))
    return [mpf(float(c)) for c in solution]


def emit(name, meaning, f, lo, hi, count, part):
    """part(x, p - f) is the share of an error of the polynomial at x in the final result."""
    coefficients = fit(f, lo, hi, count)
    lo, hi = mpf(lo), mpf(hi)
    worst = mpf(0)
    for i in range(2001):
        x = lo + (hi - lo) * i / 2000
        worst = max(worst, abs(part(x, mp.polyval(coefficients[::-1], x) - f(x))))
    bits = float(mp.log(worst, 2)) if worst else float("-inf")
    print(f"/// {meaning}; error 2^{bits:.1f} of the result.")
    print(f"pub(super) const {name}: [f64; {count}] = [")
    for c in coefficients:
        print(f"    {float(c)!r},")
    print("];\n")


def split(name, meaning, value, parts):
    rest, out = value, []
    for _ in range(parts):
        out.append(float(rest))
        rest -= mpf(out[-1])
    print(f"/// {meaning}, as an unevaluated sum.")
    print(f"pub(super) const {name}: [f64; {parts}] = [{', '.join(map(repr, out))}];\n")


def series(f, limit):
    """f with its removable singularity at 0 filled in by its limit."""
    return lambda x: mpf(limit) if abs(x) < mpf(10) ** -40 else f(x)


quarter = (mp.pi / 4 * mpf("1.0001")) ** 2
half_ln2 = mp.ln(2) / 2 * mpf("1.0001")
odd_log = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1) * mpf("1.0001")) ** 2
eighth = (mp.tan(mp.pi / 8) * mpf("1.0001")) ** 2

print("//! The polynomials and split constants of the elementary functions.")
print("//!")
print("//! Nothing comes in; numbers come out, for the functions beside this file. Separate because it is the output")
print("//! of `tests/tools/coefficients.py`, lowest power first: change that script, not this file.\n")
print("#![allow(clippy::excessive_precision, clippy::unreadable_literal, clippy::approx_constant)]")
print("#![cfg_attr(rustfmt, rustfmt_skip)]\n")

s = mp.sqrt
emit("SIN", "sin r = r + r·z·SIN(z), z = r², |r| ≤ π/4",
     series(lambda z: (mp.sin(s(z)) / s(z) - 1) / z, mpf(-1) / 6), 0, quarter, 7, lambda z, d: d * z)
emit("COS", "cos r = 1 − z/2 + z²·COS(z), z = r², |r| ≤ π/4",
     series(lambda z: (mp.cos(s(z)) - 1 + z / 2) / z**2, mpf(1) / 24), 0, quarter, 6, lambda z, d: d * z * z)
emit("EXP", "e^r = 1 + r + r²·EXP(r), |r| ≤ ln 2 / 2",
     series(lambda r: (mp.exp(r) - 1 - r) / r**2, mpf(1) / 2), -half_ln2, half_ln2, 11, lambda r, d: d * r * r)
emit("LN", "2·artanh(s) = 2·s + s³·(2/3 + w·LN(w)), w = s², s = (√2 − 1)/(√2 + 1) at most",
     series(lambda w: (2 * mp.atanh(s(w)) / s(w) - 2 - 2 * w / 3) / w**2, mpf(2) / 5), 0, odd_log, 8,
     lambda w, d: d * w**2)
emit("ATAN", "arctan t = t + t·w·ATAN(w), w = t², |t| ≤ tan(π/8)",
     series(lambda w: (mp.atan(s(w)) / s(w) - 1) / w, mpf(-1) / 3), 0, eighth, 12, lambda w, d: d * w)
emit("ASIN", "arcsin x = x + x·z·ASIN(z), z = x², |x| ≤ 1/2",
     series(lambda z: (mp.asin(s(z)) / s(z) - 1) / z, mpf(1) / 6), 0, mpf("0.2501"), 13, lambda z, d: d * z)
emit("SINH", "sinh x = x + x·z·SINH(z), z = x², |x| ≤ 1",
     series(lambda z: (mp.sinh(s(z)) / s(z) - 1) / z, mpf(1) / 6), 0, mpf("1.001"), 8, lambda z, d: d * z)
emit("ERF", "erf x = x + x·ERF(z), z = x², |x| ≤ 1",
     series(lambda z: mp.erf(s(z)) / s(z) - 1, 2 / s(mp.pi) - 1), 0, mpf("1.001"), 14, lambda z, d: d)
CENTRE = mp.mpf("2.4375")


def scaled_complement(t):
    x = CENTRE * (1 + t) / (1 - t)
    return mp.exp(x * x) * mp.erfc(x)


bound = mp.mpf("0.4225")
emit("ERFC", "e^(x²)·erfc x = ERFC(t), t = (x − c)/(x + c), c = 39/16, 1 ≤ x ≤ 6 (the substitution of Shepherd and "
     "Laframboise, Math. Comp. 36 (1981) 249)", scaled_complement, -bound, bound, 17,
     lambda t, d: d * mp.exp(-((CENTRE * (1 + t) / (1 - t)) ** 2)))
split("HALF_PI", "π/2", mp.pi / 2, 4)
split("PI", "π", mp.pi, 2)
split("QUARTER_PI", "π/4", mp.pi / 4, 2)
split("LN_2", "ln 2", mp.ln(2), 3)
split("LOG2_E", "1/ln 2", 1 / mp.ln(2), 2)
split("LOG10_E", "1/ln 10", 1 / mp.ln(10), 2)
split("LOG10_2", "log₁₀ 2", mp.log(2, 10), 3)
split("TWO_THIRDS", "2/3", mpf(2) / 3, 2)
print("/// 2/π: the bits after the binary point, 64 a word, first word first (argument reduction after Payne and")
print("/// Hanek, SIGNUM Newsletter 18 (1983) 19).")
mp.prec = 1600
digits = int(mp.floor(2 / mp.pi * mpf(2) ** (64 * 20)))
words = [(digits >> (64 * (19 - i))) & (2**64 - 1) for i in range(20)]
print("pub(super) const TWO_OVER_PI: [u64; 20] = [")
for word in words:
    print(f"    0x{word:016x},")
print("];")
