#!/usr/bin/env python3
"""Writes tests/data/random-formulas.tsv: 2000 random programs with value and gradient at a point.

Needs mpmath. Each formula is grown as a tree that is written twice: as text in the notation of people (products without
a sign, functions without brackets, bars, raised digits, few brackets), by the rules of grammar.md; and as a Python
function on numbers of 120 digits, fully bracketed. Gradients are central differences of step 1e-40 at that precision, so
that no rule of differentiation stands behind them; a point where steps of two sizes or directions disagree (a crease,
a jump), or where more digits change the value, is thrown away. Columns: program TAB x y z TAB value TAB fx fy fz, or `nan` for the last two where there is no value.

    python tests/tools/random_formulas.py > tests/data/random-formulas.tsv
"""

import random

import mpmath
from mpmath import mp, mpf

mp.dps = 120
STEP = mpf(10) ** -40
COUNT = 2000

# Beyond these, rounding at 120 digits or the range of f64 would be what is compared: sin(tau) is exactly 0.
LARGEST, SMALLEST = mpf(10) ** 60, mpf(10) ** -60

SEED = 20

# How tight a text binds; a text is put in brackets where a tighter one is needed.
SUM, PRODUCT, POWER, ATOM = range(4)


class Undefined(Exception):
    """The formula has no value here."""


class Node:
    """A text with its binding, and its meaning. `bare` is set where a factor must not follow without a sign."""

    def __init__(self, text, binding, value, bare=False):
        self.text, self.binding, self.value, self.bare = text, binding, value, bare

    def at(self, binding):
        return self.text if self.binding >= binding else f"({self.text})"


def check(condition):
    if not condition:
        raise Undefined


def real_root(order, a):
    return -mpmath.root(-a, order) if a < 0 else mpmath.root(a, order)


def power(a, b):
    """A base that is not negative with any exponent."""
    check(a > 0 or (a == 0 and b > 0))
    return mpmath.exp(b * mpmath.log(a)) if a > 0 else mpf(0)


def where(condition, function):
    def inner(*args):
        check(condition(*args))
        return function(*args)
    return inner


def divided(a, b):
    check(b != 0)
    return a / b


def whole_power(a, n):
    check(n > 0 or a != 0)
    return a ** n


def away(a):
    return mpmath.sign(a) * mpmath.floor(abs(a) + mpf(1) / 2)


def smooth(low, high, a):
    t = min(max(divided(a - low, high - low), mpf(0)), mpf(1))
    return t * t * (3 - 2 * t)


def always(*_):
    return True


ONE = {
    "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan, "atan": mpmath.atan, "sinh": mpmath.sinh,
    "cosh": mpmath.cosh, "tanh": mpmath.tanh, "asinh": mpmath.asinh, "exp": mpmath.exp, "erf": mpmath.erf,
    "abs": abs, "sign": mpmath.sign, "floor": mpmath.floor, "ceil": mpmath.ceil, "round": away,
    "frac": lambda a: a - mpmath.floor(a), "cbrt": lambda a: real_root(3, a),
    "asin": where(lambda a: abs(a) <= 1, mpmath.asin), "acos": where(lambda a: abs(a) <= 1, mpmath.acos),
    "acosh": where(lambda a: a >= 1, mpmath.acosh), "atanh": where(lambda a: abs(a) < 1, mpmath.atanh),
    "ln": where(lambda a: a > 0, mpmath.log), "log10": where(lambda a: a > 0, mpmath.log10),
    "log2": where(lambda a: a > 0, lambda a: mpmath.log(a) / mpmath.log(2)),
    "sqrt": where(lambda a: a >= 0, mpmath.sqrt),
}
TWO = {
    "atan2": where(lambda a, b: a != 0 or b != 0, mpmath.atan2), "min": min, "max": max,
    "hypot": lambda a, b: mpmath.sqrt(a * a + b * b),
    "mod": where(lambda a, b: b != 0, lambda a, b: a - b * mpmath.floor(a / b)),
    "step": lambda edge, a: mpf(0) if a < edge else mpf(1),
}
THREE = {
    "clamp": lambda a, low, high: min(max(a, low), high), "smoothstep": smooth, "hypot": lambda a, b, c: mpmath.sqrt(a * a + b * b + c * c),
    "min": min, "max": max,
}
LEAVES = {
    "x": lambda v: v["x"], "y": lambda v: v["y"], "z": lambda v: v["z"],
    "r": lambda v: mpmath.sqrt(v["x"] ** 2 + v["y"] ** 2),
    "rho": lambda v: mpmath.sqrt(v["x"] ** 2 + v["y"] ** 2 + v["z"] ** 2),
    "theta": lambda v: TWO["atan2"](v["y"], v["x"]),
    "p.x": lambda v: v["x"], "|p|": lambda v: mpmath.sqrt(v["x"] ** 2 + v["y"] ** 2 + v["z"] ** 2),
    "pi": lambda v: mp.pi, "golden": lambda v: (1 + mpmath.sqrt(mpf(5))) / 2, "tau": lambda v: 2 * mp.pi,
}
RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class Grower:
    """Grows formulas; `names` are those that a definition in front has made. Their values are functions: what is not
    used need have no value."""

    def __init__(self, rng):
        self.rng = rng
        self.names = []

    def space(self):
        return self.rng.choice(["", "", " "])

    def number(self):
        text = self.rng.choice(["2", "3", "0.5", ".25", "1.5", "7", "1e-1", "2.75", "10", "0.1"])
        value = mpf(text)
        return Node(text, ATOM, lambda v: value)

    def leaf(self):
        if self.rng.random() < 0.2:
            return self.number()
        if self.names and self.rng.random() < 0.4:
            name = self.rng.choice(self.names)
            return Node(name, ATOM, lambda v: v[name]())
        names = ["x", "y", "z"] * 5 + list(LEAVES)
        text = self.rng.choice(names)
        return Node(text, ATOM, LEAVES[text])

    def grow(self, depth):
        if depth <= 0:
            return self.leaf()
        kinds = [self.sum] * 4 + [self.product] * 5 + [self.quotient] * 2 + [self.power] * 3 + [self.call] * 5
        kinds += [self.bare_call] * 2 + [self.negation, self.bars, self.remainder, self.choice, self.series, self.family]
        return self.rng.choice(kinds)(depth)

    def part(self, depth):
        return self.grow(depth - self.rng.choice([1, 1, 2]))

    def sum(self, depth):
        a, b = self.part(depth), self.part(depth)
        s = self.space()
        if self.rng.random() < 0.5:
            return Node(f"{a.at(SUM)}{s}+{s}{b.at(PRODUCT)}", SUM, lambda v: a.value(v) + b.value(v))
        minus = self.rng.choice(["-", "-", "−"])
        return Node(f"{a.at(SUM)}{s}{minus}{s}{b.at(PRODUCT)}", SUM, lambda v: a.value(v) - b.value(v))

    def product(self, depth):
        a, b = self.part(depth), self.part(depth)
        left, right = a.at(PRODUCT), b.at(POWER)
        value = lambda v: a.value(v) * b.value(v)
        # Without a sign: never behind a function without brackets, never before a number, a bar or a sign.
        follows = right[0] in "(xyz" or right.startswith(("sin", "cos", "exp", "sqrt"))
        if not (a.binding >= PRODUCT and a.bare) and follows and self.rng.random() < 0.6:
            joined = left[-1] == ")" or left[-1].isdigit() and right[0] != "e" or right[0] == "(" and left[-1] in "xyz"
            gap = "" if joined and self.rng.random() < 0.6 else " "
            if not (left[-1].isdigit() and right[0] == "e"):
                return Node(f"{left}{gap}{right}", PRODUCT, value, b.bare and b.binding >= POWER)
        sign = self.rng.choice(["*", "*", "*", " * ", "·", "×"])
        return Node(f"{left}{sign}{right}", PRODUCT, value, b.bare and b.binding >= POWER)

    def quotient(self, depth):
        a, b = self.part(depth), self.part(depth)
        sign = self.rng.choice(["/", "/", " / ", "÷"])
        value = lambda v: divided(a.value(v), b.value(v))
        return Node(f"{a.at(PRODUCT)}{sign}{b.at(POWER)}", PRODUCT, value, b.bare and b.binding >= POWER)

    def remainder(self, depth):
        a, b = self.part(depth), self.part(depth)
        value = lambda v: TWO["mod"](a.value(v), b.value(v))
        return Node(f"{a.at(PRODUCT)} % {b.at(POWER)}", PRODUCT, value, b.bare and b.binding >= POWER)

    def negation(self, depth):
        a = self.part(depth)
        return Node(f"-{a.at(POWER)}", SUM, lambda v: -a.value(v))

    def power(self, depth):
        a = self.part(depth)
        base = a.at(ATOM)
        kind = self.rng.randrange(5)
        if kind <= 1:
            n = self.rng.choice([2, 2, 3, 4, 5, 7, -1, -2, -3])
            text = str(n).translate(RAISED) if self.rng.random() < 0.3 else self.rng.choice(["^", "^", "**"]) + str(n)
            return Node(f"{base}{text}", POWER, lambda v: whole_power(a.value(v), n))
        if kind == 2:
            p, q = self.rng.choice([(1, 3), (2, 3), (-1, 3), (3, 5), (-2, 5), (4, 3), (1, 7)])
            return Node(f"{base}^({p}/{q})", POWER, lambda v: whole_power(real_root(q, a.value(v)), p))
        if kind == 3:
            text = self.rng.choice(["0.5", "(1/2)", "(3/2)", "1.5", "2.5", "-0.5", "0.3"])
            number = mpf({"(1/2)": "0.5", "(3/2)": "1.5"}.get(text, text))
            return Node(f"{base}^{text}", POWER, lambda v: power(a.value(v), number))
        b = self.part(depth - 1)
        root = self.rng.choice(["2", "e", "(1+x^2)", "(2+cos(y))", "x"])
        base_of = {"2": lambda v: mpf(2), "e": lambda v: mp.e, "(1+x^2)": lambda v: 1 + v["x"] ** 2,
                   "(2+cos(y))": lambda v: 2 + mpmath.cos(v["y"]), "x": lambda v: v["x"]}[root]
        # With x in front the exponent varies, also where it would fold to a number.
        return Node(f"{root}^(0*x+({b.text}))", POWER, lambda v: power(base_of(v), b.value(v)))

    def call(self, depth):
        table, count = self.rng.choice([(ONE, 1), (ONE, 1), (ONE, 1), (TWO, 2), (THREE, 3)])
        name = self.rng.choice(list(table))
        args = [self.part(depth) for _ in range(count)]
        function = table[name]
        inner = ("," + self.space()).join(a.text for a in args)
        return Node(f"{name}({inner})", ATOM, lambda v: function(*[a.value(v) for a in args]))

    def bare_call(self, depth):
        name = self.rng.choice(["sin", "cos", "sqrt", "ln", "exp", "tan", "abs", "√"])
        power_text = self.rng.choice(["", "", "", "^2", "²"]) if name not in "√" else ""
        argument = self.rng.choice(["x", "y", "2x", "x y", "3z", "x^2", "-y", "2 pi z", "x(y+1)"])
        meaning = {"x": lambda v: v["x"], "y": lambda v: v["y"], "2x": lambda v: 2 * v["x"],
                   "x y": lambda v: v["x"] * v["y"], "3z": lambda v: 3 * v["z"], "x^2": lambda v: v["x"] ** 2,
                   "-y": lambda v: -v["y"], "2 pi z": lambda v: 2 * mp.pi * v["z"],
                   "x(y+1)": lambda v: v["x"] * (v["y"] + 1)}[argument]
        if name == "√":
            argument, meaning = self.rng.choice([("x", LEAVES["x"]), ("z", LEAVES["z"]), ("(x+y)", lambda v: v["x"] + v["y"])])
            return Node(f"√{argument}", POWER, lambda v: ONE["sqrt"](meaning(v)), True)
        function = ONE[name]
        square = bool(power_text)
        value = lambda v: function(meaning(v)) ** (2 if square else 1)
        return Node(f"{name}{power_text} {argument}", PRODUCT, value, True)

    def bars(self, depth):
        a = self.part(depth)
        return Node(f"|{a.text}|" if "|" not in a.text else f"abs({a.text})", ATOM, lambda v: abs(a.value(v)))

    def choice(self, depth):
        a, b, c = self.part(depth), self.part(depth), self.part(depth)
        sign = self.rng.choice(["<", "<=", ">", ">="])
        less = sign[0] == "<"

        def value(v):
            d = c.value(v)
            return a.value(v) if (d < 0 if less else d > 0) or (d == 0 and "=" in sign) else b.value(v)
        return Node(f"if({c.text} {sign} 0, {a.text}, {b.text})", ATOM, value)

    def series(self, depth):
        n = self.rng.randint(1, 5)
        product = self.rng.random() < 0.3
        a = self.part(depth)
        form = self.rng.choice(["k*({})", "({})/k", "({})^k", "sin(k*({}))"])
        term = {"k*({})": lambda a, k: a * k, "({})/k": lambda a, k: a / k, "({})^k": lambda a, k: a ** k,
                "sin(k*({}))": lambda a, k: mpmath.sin(a * k)}[form]

        def value(v):
            total = mpf(1) if product else mpf(0)
            for k in range(1, n + 1):
                t = term(a.value(v), k)
                total = total * t if product else total + t
            return total
        return Node(f"{'product' if product else 'sum'}(k = 1..{n}, {form.format(a.text)})", ATOM, value)

    def family(self, depth):
        a, n = self.part(depth), self.rng.randint(2, 7)
        kind = self.rng.choice(["chebyshev", "legendre", "root", "log"])
        if kind == "chebyshev":
            return Node(f"chebyshev({n}, {a.text})", ATOM, lambda v: recurrence(n, a.value(v), lambda k: (2, 1)))
        if kind == "legendre":
            step = lambda k: (mpf(2 * k + 1) / (k + 1), mpf(k) / (k + 1))
            return Node(f"legendre({n}, {a.text})", ATOM, lambda v: recurrence(n, a.value(v), step))
        if kind == "root":
            order = self.rng.choice([3, 4, 5])
            even = order % 2 == 0
            root = where(lambda a: a >= 0, lambda a: mpmath.root(a, 4)) if even else lambda a: real_root(order, a)
            return Node(f"root({order}, {a.text})", ATOM, lambda v: root(a.value(v)))
        return Node(f"log({n}, {a.text})", ATOM, lambda v: ONE["ln"](a.value(v)) / mpmath.log(n))

    def program(self):
        """A formula, sometimes behind a definition or a function."""
        self.names = []
        depth = self.rng.choice([1, 2, 2, 3, 3, 4])
        kind = self.rng.random()
        if kind < 0.12:
            inner = self.grow(2)
            self.names = ["w"]
            outer = self.grow(depth)
            return f"w = {inner.text}; {outer.text}", lambda v: outer.value({**v, "w": lambda: inner.value(v)}), "w" in outer.text
        if kind < 0.24:
            self.names = ["u", "u", "t"]
            body = self.grow(2)
            self.names = []
            first, second = self.grow(depth - 1), self.grow(1)
            text = f"f(u, t) = {body.text}; f({first.text}, {second.text}) + z"
            return text, lambda v: body.value({**v, "u": lambda: first.value(v), "t": lambda: second.value(v)}) + v["z"], True
        formula = self.grow(depth)
        return formula.text, formula.value, True


def recurrence(n, a, step):
    before, last = mpf(1), a
    for k in range(1, n):
        rise, fall = step(k)
        before, last = last, rise * a * last - fall * before
    return last


def evaluated(value, point, extremes=False):
    """The value; None where there is none, or where it is too large or too small to judge, unless `extremes`."""
    try:
        result = mpf(value(dict(zip("xyz", point))))
        fits = abs(result) < LARGEST and not 0 < abs(result) < SMALLEST
        return result if fits or extremes else None
    except (Undefined, ZeroDivisionError, OverflowError):
        return None


def near(a, b):
    return abs(a - b) <= mpf(10) ** -25 * (1 + abs(a))


def differences(value, point, step):
    slopes = []
    for axis in range(3):
        ends = []
        for sign in (1, 0, -1):
            moved = list(point)
            moved[axis] += sign * step
            ends.append(evaluated(value, moved))
        if None in ends:
            return None
        ahead, behind = (ends[0] - ends[1]) / step, (ends[1] - ends[2]) / step
        if not near(ahead, behind):
            return None
        slopes.append((ahead + behind) / 2)
    return [mpf(0) if abs(s) < mpf(10) ** -70 else s for s in slopes]


def gradient(value, point):
    """The gradient; None where there may be none, which two steps show."""
    slopes, others = differences(value, point, STEP), differences(value, point, STEP * 1000)
    if slopes is None or others is None:
        return None
    agree = all(near(a, b) and abs(a) < LARGEST for a, b in zip(slopes, others))
    return slopes if agree else None


def is_doubtful(value, point, result):
    """Whether more digits change the value: a jump at just this point, or a zero made of rounding."""
    with mp.workdps(150):
        other = evaluated(value, point, True)
    if result is None or other is None:
        return result is not other
    return abs(result - other) > mpf(10) ** -40 * (abs(result) + SMALLEST)


def main():
    rng = random.Random(SEED)
    grower = Grower(rng)
    print("# program\tx y z\tvalue\tgradient; written by tests/tools/random_formulas.py")
    seen, undefined = set(), 0
    while len(seen) < COUNT:
        text, value, uses = grower.program()
        point = [mpf(rng.randint(-128, 128)) / 64 for _ in range(3)]
        depends = any(letter in text for letter in "xyz") or "r" in text
        if text in seen or not uses or not depends or len(text) > 160 or 0 in point:
            continue
        result, noise = evaluated(value, point), evaluated(value, point, True)
        if result is None and noise is not None or is_doubtful(value, point, noise):
            continue
        numbers = " ".join(mpmath.nstr(c, 10) for c in point)
        if result is None:
            # Nowhere near the point either: the edge of a domain proves nothing.
            around = [evaluated(value, [c + d for c in point]) for d in (mpf(10) ** -9, -mpf(10) ** -9)]
            if undefined * 10 > len(seen) or around != [None, None]:
                continue
            undefined += 1
            print(text, numbers, "nan", "nan", sep="\t")
        else:
            slopes = gradient(value, point)
            if slopes is None:
                continue
            print(text, numbers, mpmath.nstr(result, 17), " ".join(mpmath.nstr(s, 17) for s in slopes), sep="\t")
        seen.add(text)


if __name__ == "__main__":
    main()
