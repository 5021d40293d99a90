"""First roots along a camera's rays, isolated with certainty.

In: a case of `truth_cases.py`. Out: the depth of one pixel. Apart from `truth.py`, which writes files, so that the table of
cases and the program share these types.
"""

import math

from flint import arb, ctx, fmpq, fmpq_poly

ctx.prec = 128
MOVE = 1e-7  # of sx and sy: what a ray is moved by to see whether its answer is stable
JUMP = 1e-2  # of the size: a move that changes the depth by more counts as another answer
EDGE = 2e-9  # of the size: a root nearer to the clip's boundary is left out
START = 1e-12  # of the size: a root nearer to the eye is the surface the ray starts on
NARROW = 1e-11  # of the ray's length in the clip: where bisection gives up
BALLS = 4000  # intervals looked at before bisection gives up
UNKNOWN = object()


def rational(text):
    """An exact decimal or fraction, `"0.3"` or `"407/131"`."""
    top, _, bottom = str(text).partition("/")
    if bottom:
        return rational(top) / rational(bottom)
    mantissa, _, exponent = top.lower().partition("e")
    whole, _, digits = mantissa.partition(".")
    shift = int(exponent or 0) - len(digits)
    value = fmpq(int(whole + digits))
    return value * 10**shift if shift >= 0 else value / 10 ** (-shift)


def exact(double):
    """The fraction that a double is."""
    top, bottom = float(double).as_integer_ratio()
    return fmpq(top, bottom)


class Jet:
    """A ball of values of g along the ray, and a ball of its derivative."""

    __slots__ = ("v", "d")

    def __init__(self, v, d):
        self.v, self.d = v, d

    def __add__(self, o):
        return Jet(self.v + o.v, self.d + o.d) if isinstance(o, Jet) else Jet(self.v + arb(o), self.d)

    __radd__ = __add__

    def __neg__(self):
        return Jet(-self.v, -self.d)

    def __sub__(self, o):
        return Jet(self.v - o.v, self.d - o.d) if isinstance(o, Jet) else Jet(self.v - arb(o), self.d)

    def __rsub__(self, o):
        return Jet(arb(o) - self.v, -self.d)

    def __mul__(self, o):
        if isinstance(o, Jet):
            return Jet(self.v * o.v, self.d * o.v + self.v * o.d)
        return Jet(self.v * arb(o), self.d * arb(o))

    __rmul__ = __mul__

    def __truediv__(self, o):
        if isinstance(o, Jet):
            return Jet(self.v / o.v, (self.d * o.v - self.v * o.d) / (o.v * o.v))
        return Jet(self.v / arb(o), self.d / arb(o))

    def __pow__(self, n):
        return Jet(self.v**n, n * self.v ** (n - 1) * self.d)


def _chain(value, slope):
    """A function of one variable for balls and jets, from its value and its derivative on balls."""

    def apply(u):
        return Jet(value(u.v), slope(u.v) * u.d) if isinstance(u, Jet) else value(arb(u))

    return apply


sin = _chain(lambda u: u.sin(), lambda u: u.cos())
cos = _chain(lambda u: u.cos(), lambda u: -u.sin())
exp = _chain(lambda u: u.exp(), lambda u: u.exp())
ln = _chain(lambda u: u.log(), lambda u: 1 / u)
sqrt = _chain(lambda u: u.sqrt(), lambda u: 1 / (2 * u.sqrt()))
cosh = _chain(lambda u: u.cosh(), lambda u: u.sinh())
sinh = _chain(lambda u: u.sinh(), lambda u: u.cosh())
tanh = _chain(lambda u: u.tanh(), lambda u: 1 / (u.cosh() * u.cosh()))
atan = _chain(lambda u: u.atan(), lambda u: 1 / (1 + u * u))
erf = _chain(lambda u: u.erf(), lambda u: 2 * (-u * u).exp() / arb.pi().sqrt())


def _abs_power(u, p, signed):
    """|u|^p, or sign(u)·|u|^p: the hull of the values at the ends, and 0 where the ball holds it."""

    def at(w):
        m = abs(w)
        r = (arb(p) * m.log()).exp() if m > 0 else arb(0)
        return -r if signed and w < 0 else r

    low, high = arb(u.lower()), arb(u.upper())
    ends = at(low).union(at(high))
    return ends.union(arb(0)) if u.contains(0) else ends


def abs_power(p):
    """u -> |u|^p for a fraction p > 1."""
    q = rational(p)
    return _chain(lambda u: _abs_power(u, q, False), lambda u: arb(q) * _abs_power(u, q - 1, True))


def golden():
    """The golden ratio as a ball."""
    return (1 + arb(5).sqrt()) / 2


class Piece:
    """g = 0 where every condition is > 0; `within` (> 0, linear) narrows the ray before a search."""

    def __init__(self, g, *conditions, polynomial=True, within=()):
        self.g, self.conditions, self.polynomial, self.within = g, conditions, polynomial, within


class Ray:
    """eye + s·d with exact coefficients."""

    def __init__(self, eye, d):
        self.eye = [exact(v) for v in eye]
        self.d = [exact(v) for v in d]
        self.length = sum((arb(v) * arb(v) for v in self.d), arb(0)).sqrt()
        self.eye_ball = [arb(v) for v in self.eye]
        self.d_ball = [arb(v) for v in self.d]

    def polynomials(self):
        return [fmpq_poly([a, b]) for a, b in zip(self.eye, self.d)]

    def point(self, s):
        return [a + s * b for a, b in zip(self.eye_ball, self.d_ball)]

    def jets(self, s):
        return [Jet(p, d) for p, d in zip(self.point(s), self.d_ball)]


def clip_margin(clip, p):
    """How far inside the clip a point is: a ball, positive inside."""
    if "ball" in clip:
        c = clip["ball"]
        return arb(exact(c[3])) - sum(((v - arb(exact(w))) ** 2 for v, w in zip(p, c)), arb(0)).sqrt()
    b = clip["box"]
    sides = [p[k] - arb(exact(b[2 * k])) for k in range(3)] + [arb(exact(b[2 * k + 1])) - p[k] for k in range(3)]
    return min(sides, key=lambda side: float(side.mid()))


def clip_size(clip):
    if "ball" in clip:
        return clip["ball"][3]
    b = clip["box"]
    return math.sqrt(sum((b[2 * k + 1] - b[2 * k]) ** 2 for k in range(3))) / 2


def clip_span(clip, eye, d):
    """The s in which the ray is in the clip, a little wide, in doubles; None when it passes by."""
    if "ball" in clip:
        c = clip["ball"]
        e = [a - b for a, b in zip(eye, c)]
        a = sum(v * v for v in d)
        b = sum(v * w for v, w in zip(e, d))
        disc = b * b - a * (sum(v * v for v in e) - c[3] ** 2)
        if disc < -1e-6 * (b * b + a * c[3] ** 2):
            return None
        root = math.sqrt(max(disc, 0.0))
        low, high = (-b - root) / a, (-b + root) / a
    else:
        low, high = -math.inf, math.inf
        for k in range(3):
            x0, x1 = clip["box"][2 * k], clip["box"][2 * k + 1]
            if d[k] == 0.0:
                if not x0 <= eye[k] <= x1:
                    return None
                continue
            t0, t1 = sorted(((x0 - eye[k]) / d[k], (x1 - eye[k]) / d[k]))
            low, high = max(low, t0), min(high, t1)
    wide = 1e-6 * clip_size(clip)
    low, high = max(low - wide, START * clip_size(clip) / 2), high + wide
    return (low, high) if low < high else None


def polynomial_roots(piece, ray, span):
    """All real roots in the span, ascending."""
    g = piece.g(*ray.polynomials())
    if g == 0:
        return [(arb(span[0]), UNKNOWN)]
    if isinstance(g, fmpq) or g.degree() < 1:
        return []
    # flint proves which of the isolated roots are real, and gives those an imaginary part of exactly 0.
    roots = [r.real for r, _ in g.numer().complex_roots() if r.imag.is_zero()]
    roots = [r for r in roots if r.upper() > span[0] and r.lower() < span[1]]
    return [(r, None) for r in sorted(roots, key=lambda r: r.mid())]


def ball(low, high):
    return arb(low).union(arb(high))


def refine(g, ray, low, high):
    """The one root of a monotonic g in [low, high]."""
    inside = ball(low, high)
    for _ in range(200):
        m = arb(inside.mid())
        step = m - g(*ray.jets(m)).v / g(*ray.jets(inside)).d
        if step.is_finite() and step.overlaps(inside):
            inside = step.intersection(inside)
        if inside.rad() < 1e-25 * max(1e-6, abs(float(inside.mid()))):
            break
    return inside


def searched_roots(piece, ray, span):
    """Roots ascending, as they are found; a stretch that cannot be decided comes as UNKNOWN and ends the search."""
    low, high = span
    for h in piece.within:
        line = h(*ray.polynomials())
        c0, c1 = float(line[0].p) / float(line[0].q), float(line[1].p) / float(line[1].q)
        if c1 == 0.0:
            if c0 <= 0.0:
                return
            continue
        t = -c0 / c1
        low, high = (max(low, t), high) if c1 > 0 else (low, min(high, t))
    if low >= high:
        return
    narrow, stack, count, g = NARROW * (span[1] - span[0]), [(low, high)], 0, piece.g
    while stack:
        a, b = stack.pop()
        count += 1
        m = 0.5 * (a + b)
        whole = ball(a, b)
        wide = g(*ray.jets(whole))
        finite = wide.v.is_finite()
        if finite and not wide.v.contains(0):
            continue
        if finite and wide.d.is_finite():
            mean = g(*ray.jets(arb(m))).v + wide.d * (whole - arb(m))
            if not mean.contains(0):
                continue
            if not wide.d.contains(0):
                ga, gb = g(*ray.point(arb(a))), g(*ray.point(arb(b)))
                if not (ga.contains(0) or gb.contains(0)):
                    if (ga > 0) != (gb > 0):
                        yield refine(g, ray, a, b), None
                    continue
        if b - a < narrow or count > BALLS:
            yield whole, UNKNOWN
            return
        stack += [(m, b), (a, m)]


def first_of_piece(piece, ray, clip, span, size):
    """(s, status) of the first root that counts: status None, or UNKNOWN; None when there is none."""
    roots = polynomial_roots if piece.polynomial else searched_roots
    for s, status in roots(piece, ray, span):
        p = ray.point(s)
        margin = clip_margin(clip, p)
        if status is not UNKNOWN and s * ray.length < START * size:
            continue
        if margin < -EDGE * size:
            continue
        if status is UNKNOWN or not margin > EDGE * size:
            return s, UNKNOWN
        sides = [h(*p) for h in piece.conditions]
        if any(side < 0 for side in sides):
            continue
        if all(side > 0 for side in sides):
            return s, None
        return s, UNKNOWN
    return None


def depth(case, d):
    """The first root's distance, +inf or NaN."""
    span = clip_span(case["clip"], case["eye"], d)
    if span is None:
        return math.inf
    ray, size, best, doubtful = Ray(case["eye"], d), clip_size(case["clip"]), None, None
    for piece in case["pieces"]:
        found = first_of_piece(piece, ray, case["clip"], span, size)
        if found is None:
            continue
        s, status = found
        if status is UNKNOWN:
            doubtful = s if doubtful is None or s.lower() < doubtful.lower() else doubtful
        elif best is None or s.mid() < best.mid():
            best = s
    if doubtful is not None and (best is None or not best < doubtful):
        return math.nan
    if best is None:
        return math.inf
    t = best * ray.length
    return float(t.mid()) if t.rad() < 1e-14 * max(size, float(t.mid())) else math.nan


def normalize(v):
    n = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return [c / n for c in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def frame(eye, look_at):
    """Forward, right, up; z is up, or y when the camera looks along z."""
    f = normalize([a - b for a, b in zip(look_at, eye)])
    r = cross(f, [0.0, 0.0, 1.0])
    if math.sqrt(sum(c * c for c in r)) < 1e-9:
        r = cross(f, [0.0, 1.0, 0.0])
    r = normalize(r)
    return f, r, cross(r, f)


def stable_depth(case, i, j):
    f, r, u = frame(case["eye"], case["look_at"])
    w, h, tangent = case["width"], case["height"], math.tan(math.radians(case["fov"]) / 2)
    sx = ((i + 0.5) / w * 2 - 1) * (w / h) * tangent
    sy = (1 - (j + 0.5) / h * 2) * tangent

    def at(dx, dy):
        return depth(case, [a + (sx + dx) * b + (sy + dy) * c for a, b, c in zip(f, r, u)])

    t = at(0.0, 0.0)
    if math.isnan(t):
        return t
    for move in ((MOVE, 0.0), (-MOVE, 0.0), (0.0, MOVE), (0.0, -MOVE)):
        other = at(*move)
        same = t == other if math.isinf(t) else abs(t - other) <= JUMP * clip_size(case["clip"])
        if not same:
            return math.nan
    return t
