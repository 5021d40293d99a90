"""Reads the lines of the soak and prints the largest error of each function in ulp of the exact result, as the
table of docs/error-bounds.md. Needs mpmath.

    cargo bench --bench soak -- 4000 | python tests/tools/errors.py
"""

import struct
import sys
from mpmath import mp, mpf

mp.prec = 160


def number(text):
    return struct.unpack(">d", bytes.fromhex(text.rjust(16, "0")))[0]


def ulp(exact):
    return mpf(2) ** max(mp.frexp(exact)[1] - 53, -1074)


def odd_root(a, n):
    return mp.sign(a) * mp.root(abs(a), n)


def wide(f, a):
    """f with enough bits for angles of any size."""
    mp.prec = 1300
    value = f(a)
    mp.prec = 160
    return +value


EXACT = {
    "sin": lambda a, b: wide(mp.sin, a), "cos": lambda a, b: wide(mp.cos, a), "tan": lambda a, b: wide(mp.tan, a),
    "exp": lambda a, b: mp.exp(a), "ln": lambda a, b: mp.log(a), "log2": lambda a, b: mp.log(a, 2),
    "log10": lambda a, b: mp.log(a, 10), "atan": lambda a, b: mp.atan(a), "asin": lambda a, b: mp.asin(a),
    "acos": lambda a, b: mp.acos(a), "sinh": lambda a, b: wide(mp.sinh, a), "cosh": lambda a, b: mp.cosh(a),
    "tanh": lambda a, b: wide(mp.tanh, a), "asinh": lambda a, b: wide(mp.asinh, a), "acosh": lambda a, b: mp.acosh(a),
    "atanh": lambda a, b: wide(mp.atanh, a), "erf": lambda a, b: mp.erf(a), "cbrt": lambda a, b: odd_root(a, 3),
    "root5": lambda a, b: odd_root(a, 5), "power3": lambda a, b: a**3, "power7": lambda a, b: a**7,
    "power-5": lambda a, b: a**-5, "power1000001": lambda a, b: a**1000001, "pow": lambda a, b: mp.power(a, b),
    "atan2": lambda a, b: mp.atan2(a, b),
}

worst, count = {}, {}
for line in sys.stdin:
    fields = line.split()
    if len(fields) != 4 or fields[0] not in EXACT:
        continue
    name, a, b, ours = fields[0], *map(number, fields[1:])
    exact = EXACT[name](mpf(a), mpf(b))
    count[name] = count.get(name, 0) + 1
    if exact == 0 or abs(exact) > mpf(sys.float_info.max) or abs(exact) < mpf(sys.float_info.min):
        continue
    error = float(abs(mpf(ours) - exact) / ulp(exact)) if ours == ours else float("inf")
    if error > worst.get(name, (-1,))[0]:
        worst[name] = (error, a, b)

print("| function | points | largest error, ulp | at |")
print("| --- | --- | --- | --- |")
for name, (error, a, b) in worst.items():
    place = f"{a!r}" if name not in ("pow", "atan2") else f"{a!r}, {b!r}"
    print(f"| {name} | {count[name]} | {error:.4f} | {place} |")
