"""The table of `truth.py`: formulas as a user types them, and the mathematics that decides them.

In: nothing. Out: CASES, name -> case. The pieces say the surface in other words than the formula wherever there are any:
a square is decided by its root, a pole by its denominator multiplied out, a jump by its steps one at a time.
"""

import math
import random

from truth_rays import Piece, abs_power, cos, cosh, erf, exp, golden, ln, rational, sin, sinh, sqrt, tanh

q = rational
BOX = {"box": [-1.5, 1.5, -1.5, 1.5, -1.5, 1.5]}
EYE = [3.0, -2.4, 1.8]
CASES = {}

POLYNOMIAL = "rational polynomial along the ray, all real roots isolated"
PIECES = "one rational polynomial for each piece, its side conditions decided at the root"
BALLS = "bisection and Newton steps with balls of 128 bits"


def box(*h):
    """A box centred at 0 of half sizes h."""
    h = h * 3 if len(h) == 1 else h
    return {"box": [h[0] * -1, h[0], h[1] * -1, h[1], h[2] * -1, h[2]]}


def ball(r, c=(0.0, 0.0, 0.0)):
    return {"ball": [*c, r]}


def add(name, formula, *pieces, clip=BOX, eye=EYE, look_at=(0.0, 0.0, 0.0), fov=40.0, size=(48, 36), decided=None):
    pieces = [p if isinstance(p, Piece) else Piece(p) for p in pieces]
    if decided is None:
        conditions = any(p.conditions for p in pieces)
        decided = PIECES if conditions or len(pieces) > 1 else POLYNOMIAL
        if any(not p.polynomial for p in pieces):
            decided = BALLS
    assert name not in CASES, name
    CASES[name] = dict(
        formula=formula, pieces=pieces, clip=clip, eye=list(eye), look_at=list(look_at), fov=fov,
        width=size[0], height=size[1], decided=decided,
    )


def search(g, *conditions, within=()):
    """A piece that is no polynomial."""
    return Piece(g, *conditions, polynomial=False, within=within)


def steps(values, g, low, high):
    """For each whole n: g(n) = 0 where low(n) and high(n) are > 0."""
    return [Piece(lambda x, y, z, n=n: g(n)(x, y, z), low(n), high(n)) for n in values]


def squares(x, y, z):
    return x * x + y * y + z * z


def sphere(r2="1", c=("0", "0", "0")):
    a, b, d, r2 = q(c[0]), q(c[1]), q(c[2]), q(r2)
    return lambda x, y, z: (x - a) ** 2 + (y - b) ** 2 + (z - d) ** 2 - r2


def turned(case, count, seed, distance):
    """The same case from other eyes, at random on a sphere about what it looks at."""
    dice, old = random.Random(seed), CASES[case]
    for k in range(count):
        height = dice.uniform(-0.85, 0.85)
        angle = dice.uniform(0.0, 2 * math.pi)
        ring = math.sqrt(1 - height * height)
        step = [ring * math.cos(angle), ring * math.sin(angle), height]
        eye = [round(c + distance * s, 3) for c, s in zip(old["look_at"], step)]
        CASES[f"{case}_turned_{k + 1}"] = {**old, "eye": eye}


S = "x^2+y^2+z^2"
ONE = sphere()

# Roots of even order.
add("double_square", f"({S}-1)^2", ONE)
add("double_product", f"({S}-1)*({S}-1)", ONE)
add("double_abs", f"abs({S}-1)", ONE)
add("double_expanded", "x^4+y^4+z^4+2*x^2*y^2+2*y^2*z^2+2*z^2*x^2-2*x^2-2*y^2-2*z^2+1", ONE)
add("double_both_sides", f"({S})^2 = 2*({S})-1", ONE)
add("double_root_of_square", f"sqrt(({S}-1)^2)", ONE)
add("double_torus", f"(({S}+0.84)^2-4*(x^2+y^2))^2",
    lambda x, y, z: (squares(x, y, z) + q("0.84")) ** 2 - 4 * (x * x + y * y))
add("double_and_simple", f"({S}-1)^2*(z-0.3*x)", ONE, lambda x, y, z: z - q("0.3") * x, decided=PIECES)
add("double_letters", "z^2-2*z*sin(x)+sin(x)^2", search(lambda x, y, z: z - sin(x)), clip=box(4, 4, 1.5),
    eye=[7.0, -6.0, 5.0])
add("double_exp_letters", "exp(x)^2-2*z*exp(x)+z^2", search(lambda x, y, z: z - exp(x)))
add("double_graph", "(z-sin(x)*cos(y))^2", search(lambda x, y, z: z - sin(x) * cos(y)), clip=box(4, 4, 1.5),
    eye=[7.0, -6.0, 5.0])
add("double_abs_graph", "abs(z-sin(x)*cos(y))", search(lambda x, y, z: z - sin(x) * cos(y)), clip=box(4, 4, 1.5),
    eye=[7.0, -6.0, 5.0])
add("double_planes", "x^2+2*x*y+y^2-2*x*z-2*y*z+z^2", lambda x, y, z: x + y - z)
add("triple_power", f"({S}-1)^3", ONE)
add("triple_expanded", "x^3-3*x^2*z+3*x*z^2-z^3", lambda x, y, z: x - z)
add("triple_sphere_expanded", f"({S})^3-3*({S})^2+3*({S})-1", ONE)
add("triple_product", "(z-x^2)*(z-x^2)*(z-x^2)", lambda x, y, z: z - x * x)
add("quadruple_power", f"({S}-1)^4", ONE)
add("quadruple_expanded", "z^4-4*x*y*z^3+6*x^2*y^2*z^2-4*x^3*y^3*z+x^4*y^4", lambda x, y, z: z - x * y)
add("quadruple_letters", "(z^2-2*z*sin(x)+sin(x)^2)^2", search(lambda x, y, z: z - sin(x)), clip=box(4, 4, 1.5),
    eye=[7.0, -6.0, 5.0])
add("power_hundred", f"({S})^100 = 1", ONE)
add("square_plus_square", f"({S}-1)^2+(z-0.3)^2", lambda x, y, z: squares(x, y, z) + 1,
    decided="a sum of two squares, 0 on a circle alone, which no pixel centre meets")

# Sheets that lie close together, or nearly exist.
add("shell_thousandth", f"({S}-1)*({S}-0.998001)", ONE, sphere("0.998001"))
add("shell_hundred_thousandth", f"({S}-1)*({S}-0.9999800001)", ONE, sphere("0.9999800001"))
add("shell_inside", f"({S}-1)*({S}-0.9999800001)", ONE, sphere("0.9999800001"), eye=[0.1, 0.2, -0.1],
    look_at=[1.0, 0.5, 0.3], fov=80.0)
add("nearly_double_empty", f"({S}-1)^2+1e-9", lambda x, y, z: (squares(x, y, z) - 1) ** 2 + q("1e-9"))
add("nearly_double_two_sheets", f"({S}-1)^2-1e-9", lambda x, y, z: (squares(x, y, z) - 1) ** 2 - q("1e-9"))
add("nearly_double_letters_empty", "z^2-2*z*sin(x)+sin(x)^2+1e-8", lambda x, y, z: x * x + 1, clip=box(4, 4, 1.5),
    eye=[7.0, -6.0, 5.0], decided="a square plus 1e-8: empty")
add("abs_lifted_empty", f"abs({S}-1)+1e-10", lambda x, y, z: x * x + 1, decided="an absolute value plus 1e-10: empty")
add("abs_lowered", f"abs({S}-1)-1e-6", sphere("1.000001"), sphere("0.999999"))

# Tangency.
LEFT, RIGHT = sphere(c=("-1", "0", "0")), sphere(c=("1", "0", "0"))
add("tangent_product", "((x-1)^2+y^2+z^2-1)*((x+1)^2+y^2+z^2-1)", LEFT, RIGHT, clip=box(2.2, 1.2, 1.2), eye=[3.0, -5.0, 2.0])
add("tangent_min", "min(sqrt((x-1)^2+y^2+z^2)-1,sqrt((x+1)^2+y^2+z^2)-1)", Piece(LEFT, RIGHT), Piece(RIGHT, LEFT),
    clip=box(2.2, 1.2, 1.2), eye=[3.0, -5.0, 2.0])
INNER = sphere("0.25", ("0.5", "0", "0"))
add("tangent_inside", f"({S}-1)*((x-0.5)^2+y^2+z^2-0.25)", ONE, INNER, eye=[0.2, -0.9, 0.1], look_at=[0.4, 0.0, 0.0], fov=90.0)
add("tangent_plane", f"({S}-1)*(z-1)", ONE, lambda x, y, z: z - 1, eye=[2.0, -3.0, 0.9])
add("tangent_cylinders", "((x-1)^2+y^2-1)*((x+1)^2+y^2-1)", lambda x, y, z: (x - 1) ** 2 + y * y - 1,
    lambda x, y, z: (x + 1) ** 2 + y * y - 1, clip=box(2.2, 1.2, 1.2), eye=[3.0, -5.0, 2.0])

# Thin and grazing.
add("needle", "x^2+y^2=1e-6", lambda x, y, z: x * x + y * y - q("1e-6"), eye=[3.0, -2.0, 0.5], size=(49, 37))
add("needle_near", "x^2+y^2=1e-6", lambda x, y, z: x * x + y * y - q("1e-6"), eye=[3.0, -2.0, 0.5], fov=0.08)
add("needle_along", "x^2+z^2=1e-6", lambda x, y, z: x * x + z * z - q("1e-6"), eye=[0.0, -3.0, 0.002], fov=0.2, size=(49, 37))
add("needle_ellipsoid", "x^2/1e-6+y^2/1e-6+z^2=1", lambda x, y, z: (x * x + y * y) * 10**6 + z * z - 1,
    eye=[3.0, -2.0, 0.5], fov=0.1)
add("needle_ellipsoid_far", "x^2/1e-6+y^2/1e-6+z^2=1", lambda x, y, z: (x * x + y * y) * 10**6 + z * z - 1,
    eye=[3.0, -2.0, 0.0], size=(49, 37))
DISC = lambda x, y, z: x * x + y * y + 10**8 * z * z - 1
add("disc_edge_on", "x^2+y^2+1e8*z^2=1", DISC, eye=[3.0, 0.5, 0.0], size=(49, 37))
add("disc_edge_on_near", "x^2+y^2+1e8*z^2=1", DISC, eye=[3.0, 0.5, 0.00005], fov=0.006)
add("disc_slanted", "x^2+y^2+1e8*z^2=1", DISC)
add("grazing_plane", "z=0", lambda x, y, z: z, eye=[3.0, 0.4, 0.001], look_at=[0.0, 0.0, 0.0], fov=2.0)
add("grazing_slope", "z=1e-6*x", lambda x, y, z: z - q("1e-6") * x, eye=[3.0, 0.4, 0.0005], fov=1.0)
add("grazing_sphere", f"{S}=1", ONE, eye=[3.0, 0.0, 1.0001], look_at=[0.0, 0.0, 1.0], fov=0.05)
add("grazing_waves", "z=0.001*sin(20*x)", search(lambda x, y, z: z - q("0.001") * sin(20 * x)), eye=[3.0, 0.4, 0.004],
    fov=0.5, size=(32, 24))

# Nodes, cusps, double lines.
C1, C2 = q("2.618033988749895"), q("4.23606797749979")
BARTH6 = ("4*(2.618033988749895*x^2-y^2)*(2.618033988749895*y^2-z^2)*(2.618033988749895*z^2-x^2)"
          "-4.23606797749979*(x^2+y^2+z^2-1)^2")
add("barth_sextic_decimals", BARTH6,
    lambda x, y, z: 4 * (C1 * x**2 - y**2) * (C1 * y**2 - z**2) * (C1 * z**2 - x**2) - C2 * (squares(x, y, z) - 1) ** 2,
    clip=ball(1.75), eye=[2.1, -3.0, 3.2])
add("barth_sextic_golden",
    f"4*(golden^2*x^2-y^2)*(golden^2*y^2-z^2)*(golden^2*z^2-x^2)-(1+2*golden)*({S}-1)^2",
    search(lambda x, y, z: 4 * (golden() ** 2 * x**2 - y**2) * (golden() ** 2 * y**2 - z**2) * (golden() ** 2 * z**2 - x**2)
           - (1 + 2 * golden()) * (squares(x, y, z) - 1) ** 2), clip=ball(1.75), eye=[3.1, -3.0, 1.2], size=(32, 24))
C3, C4, C5 = q("6.854101966249685"), q("11.090169943749475"), q("0.3819660112501051")
add("barth_decic",
    "8*(x^2-6.854101966249685*y^2)*(y^2-6.854101966249685*z^2)*(z^2-6.854101966249685*x^2)"
    "*(x^4+y^4+z^4-2*x^2*y^2-2*x^2*z^2-2*y^2*z^2)"
    "+11.090169943749475*(x^2+y^2+z^2-1)^2*(x^2+y^2+z^2-0.3819660112501051)^2",
    lambda x, y, z: 8 * (x**2 - C3 * y**2) * (y**2 - C3 * z**2) * (z**2 - C3 * x**2)
    * (x**4 + y**4 + z**4 - 2 * x**2 * y**2 - 2 * x**2 * z**2 - 2 * y**2 * z**2)
    + C4 * (squares(x, y, z) - 1) ** 2 * (squares(x, y, z) - C5) ** 2, clip=ball(2.0), eye=[3.08, -4.69, 2.49])
add("kummer", f"({S}-1.69)^2-(407/131)*((1-z)^2-2*x^2)*((1+z)^2-2*y^2)",
    lambda x, y, z: (squares(x, y, z) - q("1.69")) ** 2 - q("407/131") * ((1 - z) ** 2 - 2 * x**2) * ((1 + z) ** 2 - 2 * y**2),
    clip=ball(3.0), eye=[5.0, -4.0, 3.0])
CAYLEY = lambda x, y, z: 4 * squares(x, y, z) + 16 * x * y * z - 1
add("cayley_cubic", f"4*({S})+16*x*y*z-1", CAYLEY, clip=ball(2.0), eye=[2.0, 3.5, -2.4])
WHITNEY = lambda x, y, z: x * x - y * y * z
add("whitney", "x^2-y^2*z", WHITNEY, eye=[4.5, -3.8, 2.6])
STEINER = lambda x, y, z: x**2 * y**2 + y**2 * z**2 + z**2 * x**2 - x * y * z
add("steiner", "x^2*y^2+y^2*z^2+z^2*x^2-x*y*z", STEINER, clip=ball(0.8), eye=[1.18, 1.47, 0.93])
CROSSCAP = lambda x, y, z: 4 * x**2 * (squares(x, y, z) + z) + y**2 * (y**2 + z**2 - 1)
add("cross_cap", f"4*x^2*({S}+z)+y^2*(y^2+z^2-1)", CROSSCAP)
add("ding_dong", "x^2+y^2=(1-z)*z^2", lambda x, y, z: x * x + y * y - (1 - z) * z * z)
add("cuspidal_edge", "y^2=x^3", lambda x, y, z: y * y - x**3)
add("swallowtail", "16*x^4*z-4*x^3*y^2-128*x^2*z^2+144*x*y^2*z-27*y^4+256*z^3",
    lambda x, y, z: 16 * x**4 * z - 4 * x**3 * y**2 - 128 * x**2 * z**2 + 144 * x * y**2 * z - 27 * y**4 + 256 * z**3,
    eye=[-3.0, -2.4, 1.8])
add("flattened_torus", f"({S}+0.75)^2=4*(x^2+y^2)-1.5*z^2",
    lambda x, y, z: (squares(x, y, z) + q("0.75")) ** 2 - 4 * (x * x + y * y) + q("1.5") * z * z)
add("horn_torus", f"({S})^2=4*(x^2+y^2)", lambda x, y, z: squares(x, y, z) ** 2 - 4 * (x * x + y * y), clip=box(2.2, 2.2, 1.2),
    eye=[4.0, -3.0, 4.0])
add("cone_apex", "x^2+y^2=z^2", lambda x, y, z: x * x + y * y - z * z, eye=[3.0, -2.4, 0.0], size=(49, 37))
add("klein", f"({S}+2*y-1)*(({S}-2*y-1)^2-8*z^2)+16*x*z*({S}-2*y-1)",
    lambda x, y, z: (squares(x, y, z) + 2 * y - 1) * ((squares(x, y, z) - 2 * y - 1) ** 2 - 8 * z * z)
    + 16 * x * z * (squares(x, y, z) - 2 * y - 1), clip=ball(5.0), eye=[6.16, -9.38, 4.98])
T8 = lambda u: 128 * u**8 - 256 * u**6 + 160 * u**4 - 32 * u**2 + 1
add("chmutov", "chebyshev(8,x)+chebyshev(8,y)+chebyshev(8,z)+1", lambda x, y, z: T8(x) + T8(y) + T8(z) + 1, clip=box(1.1),
    eye=[2.27, -3.46, 1.84])
add("heart_cusps", f"(x^2+2.25*y^2+z^2-1)^3-x^2*z^3-0.1125*y^2*z^3",
    lambda x, y, z: (x * x + q("2.25") * y * y + z * z - 1) ** 3 - x * x * z**3 - q("0.1125") * y * y * z**3,
    clip=ball(1.5), eye=[0.7, -2.8, 2.4])
add("crossed_planes", "x*y*z", lambda x, y, z: x, lambda x, y, z: y, lambda x, y, z: z)
add("crossed_planes_expanded", "x^2-y^2", lambda x, y, z: x - y, lambda x, y, z: x + y)

# Poles.
add("tan", "z=tan(x)", search(lambda x, y, z: z * cos(x) - sin(x)), clip=box(6, 3, 3), eye=[9.0, -8.0, 6.0],
    decided="z cos x = sin x by " + BALLS)
add("tan_product", "z=tan(x)*tan(y)", search(lambda x, y, z: z * cos(x) * cos(y) - sin(x) * sin(y), lambda x, y, z: cos(x) ** 2,
                                             lambda x, y, z: cos(y) ** 2),
    clip=box(3, 3, 3), eye=[6.0, -5.0, 5.0], size=(32, 24), decided="z cos x cos y = sin x sin y by " + BALLS)
add("reciprocal", "z=1/x", lambda x, y, z: x * z - 1, clip=box(3), eye=[6.0, -5.0, 4.0])
add("reciprocal_product", "x*y=1/z", lambda x, y, z: x * y * z - 1, clip=box(3), eye=[6.0, -5.0, 4.0])
add("quotient", "z=x/y", Piece(lambda x, y, z: y * z - x, lambda x, y, z: y * y))
add("pole_square", "z=1/(x^2+y^2)", lambda x, y, z: z * (x * x + y * y) - 1, clip=box(3), eye=[6.0, -5.0, 4.0])
add("pole_times_zero", "x*(1/x)", lambda x, y, z: x * x + 1, decided="1 where it is defined: empty")
add("quotient_of_equals", f"({S}-1)/({S}-1)", lambda x, y, z: x * x + 1, decided="1 where it is defined: empty")
add("reciprocal_never", f"1/({S}-1)", lambda x, y, z: x * x + 1, decided="a reciprocal is never 0: empty")
add("reciprocal_one", f"1/({S}-1)=1", sphere("2"), clip=box(1.6))
add("quotient_hole", "z*x/x", Piece(lambda x, y, z: z, lambda x, y, z: x * x))
add("quotient_sphere", f"({S}-1)/(x-0.2)", Piece(ONE, lambda x, y, z: (x - q("0.2")) ** 2))
add("rational_bumps", "z=x*y/(x^2+y^2+0.01)", lambda x, y, z: z * (x * x + y * y + q("0.01")) - x * y)
add("pole_line", "1/x+1/y+1/z=1", Piece(lambda x, y, z: y * z + x * z + x * y - x * y * z, lambda x, y, z: (x * y * z) ** 2),
    clip=box(3), eye=[6.0, -5.0, 4.0])

# Jumps.
floor_steps = steps(range(-4, 4), lambda n: lambda x, y, z: z - n, lambda n: lambda x, y, z: x - n,
                    lambda n: lambda x, y, z: n + 1 - x)
add("floor", "z=floor(x)", *floor_steps, clip=box(3.3), eye=[6.0, -5.0, 4.0])
add("ceil", "z=ceil(x)", *steps(range(-4, 5), lambda n: lambda x, y, z: z - n, lambda n: lambda x, y, z: x - n + 1,
                                lambda n: lambda x, y, z: n - x), clip=box(3.3), eye=[-6.0, -5.0, 4.0])
add("round", "z=round(x)/2", *steps(range(-4, 5), lambda n: lambda x, y, z: z - q(n) / 2, lambda n: lambda x, y, z: x - n + q("0.5"),
                                    lambda n: lambda x, y, z: n + q("0.5") - x), clip=box(3.3), eye=[6.0, -5.0, 4.0])
add("mod", "z=mod(x,1)", *steps(range(-3, 3), lambda n: lambda x, y, z: z - x + n, lambda n: lambda x, y, z: x - n,
                                lambda n: lambda x, y, z: n + 1 - x), clip=box(2.5), eye=[5.0, -4.0, 3.0])
add("mod_operator", "z=(x+y)%0.75", *steps(range(-7, 7), lambda n: lambda x, y, z: z - x - y + q("0.75") * n,
                                           lambda n: lambda x, y, z: x + y - q("0.75") * n,
                                           lambda n: lambda x, y, z: q("0.75") * (n + 1) - x - y), clip=box(2.4), eye=[5.0, -4.0, 3.0])
add("sign", "z=sign(x)*0.5", Piece(lambda x, y, z: 2 * z - 1, lambda x, y, z: x), Piece(lambda x, y, z: 2 * z + 1, lambda x, y, z: -x))
add("abs_minus_floor", "z=abs(x)-floor(y)",
    *[Piece(lambda x, y, z, n=n, s=s: z - s * x + n, lambda x, y, z, s=s: s * x, lambda x, y, z, n=n: y - n,
            lambda x, y, z, n=n: n + 1 - y) for n in range(-3, 3) for s in (1, -1)], clip=box(2.4), eye=[5.0, -4.0, 3.0])
add("nested_floor", "z=floor(x+floor(y)/2)/2",
    *[Piece(lambda x, y, z, m=m: 2 * z - m, lambda x, y, z, n=n: y - n, lambda x, y, z, n=n: n + 1 - y,
            lambda x, y, z, n=n, m=m: x + q(n) / 2 - m, lambda x, y, z, n=n, m=m: m + 1 - x - q(n) / 2)
      for n in range(-3, 3) for m in range(-5, 5)], clip=box(2.4), eye=[5.0, -4.0, 3.0], size=(32, 24))
add("atan_of_pole", "z=atan(1/x)", search(lambda x, y, z: x * sin(z) - cos(z), lambda x, y, z: cos(z)), clip=box(3, 3, 1.57),
    eye=[5.0, -4.0, 3.0], decided="x sin z = cos z where cos z > 0 by " + BALLS)
add("angle_jump", "z=atan2(y,x)/2",
    search(lambda x, y, z: x * sin(2 * z) - y * cos(2 * z), lambda x, y, z: x * cos(2 * z) + y * sin(2 * z)),
    clip=box(2, 2, 1.57), eye=[-5.0, -3.0, 3.0],
    decided="x sin 2z = y cos 2z where x cos 2z + y sin 2z > 0 by " + BALLS)
add("choice", "z=if(x<0.25,x^2,y/2)", Piece(lambda x, y, z: z - x * x, lambda x, y, z: q("0.25") - x),
    Piece(lambda x, y, z: 2 * z - y, lambda x, y, z: x - q("0.25")))
add("step_function", "z=step(0,x)-0.5", Piece(lambda x, y, z: 2 * z - 1, lambda x, y, z: x),
    Piece(lambda x, y, z: 2 * z + 1, lambda x, y, z: -x))
add("step_times_sphere", f"(2*step(0.1,x)-1)*({S}-1)", Piece(ONE, lambda x, y, z: (x - q("0.1")) ** 2))
add("floor_levels", f"floor(2*({S}))=1", lambda x, y, z: x * x + 1, size=(12, 9), clip=ball(0.7),
    decided="the clip holds only x^2+y^2+z^2 < 0.5, where the left side is 0: empty")

# Edges of the domain.
add("hemisphere", "z=sqrt(1-x^2-y^2)", Piece(ONE, lambda x, y, z: z), eye=[3.0, -2.4, -1.0])
add("square_root", "z=sqrt(x)", Piece(lambda x, y, z: z * z - x, lambda x, y, z: z))
add("three_roots", "sqrt(x)+sqrt(y)+sqrt(z)=1",
    Piece(lambda x, y, z: (squares(x, y, z) - 2 * (x * y + y * z + z * x) - 2 * (x + y + z) + 1) ** 2 - 64 * x * y * z,
          lambda x, y, z: x, lambda x, y, z: y, lambda x, y, z: z,
          # Of the choices of signs that the polynomial holds, all plus is the one with the least sum: 1.
          lambda x, y, z: q("1.000001") - sqrt(x) - sqrt(y) - sqrt(z)),
    eye=[2.0, 1.4, 1.8], look_at=[0.3, 0.3, 0.3], clip={"box": [-0.1, 1.1, -0.1, 1.1, -0.1, 1.1]})
add("square_of_root", "z=sqrt(x)^2", Piece(lambda x, y, z: z - x, lambda x, y, z: x))
add("root_zero_outside", f"sqrt({S}-1)", ONE)
add("root_zero_inside", f"sqrt(1-{S})".replace("1-x^2+y^2+z^2", "1-x^2-y^2-z^2"), ONE)
add("root_zero_plane", "sqrt(x)", lambda x, y, z: x)
add("root_shifted", "sqrt(x)+z=0", Piece(lambda x, y, z: z * z - x, lambda x, y, z: -z))
add("logarithm", "z=ln(x)", search(lambda x, y, z: exp(z) - x), clip=box(2.5), eye=[5.0, -4.0, 3.0],
    decided="exp z = x by " + BALLS)
add("logarithm_times", "ln(x)*z", lambda x, y, z: x - 1, Piece(lambda x, y, z: z, lambda x, y, z: x), eye=[-3.0, -2.4, 1.8])
add("logarithm_sphere", f"ln({S})", ONE)
add("logarithm_two", "z=log2(x^2+y^2)", search(lambda x, y, z: exp(z * ln(2)) - x * x - y * y), clip=box(2.5), eye=[5.0, -4.0, 3.0],
    decided="2^z = x^2 + y^2 by " + BALLS)
add("arcsine", "z=asin(x)", search(lambda x, y, z: sin(z) - x), clip=box(1.5, 1.5, 1.5), decided="sin z = x by " + BALLS)
add("arcsine_across", "x=asin(z)", search(lambda x, y, z: sin(x) - z), clip=box(1.5, 1.5, 1.5), decided="sin x = z by " + BALLS)
add("arcsine_whole", "z=asin(x)", search(lambda x, y, z: sin(z) - x, lambda x, y, z: cos(z)), clip=box(2.0),
    eye=[5.0, -3.0, 2.0], decided="sin z = x where cos z > 0 by " + BALLS)
add("arccosine", "z=acos(x*y)", search(lambda x, y, z: cos(z) - x * y, lambda x, y, z: sin(z), lambda x, y, z: z), clip=box(2.0, 2.0, 3.5),
    eye=[6.0, -5.0, 5.0], decided="cos z = x y where sin z and z are > 0 by " + BALLS)
add("area_cosine", "z=acosh(x)", search(lambda x, y, z: cosh(z) - x, lambda x, y, z: z), clip=box(3.0), eye=[6.0, -4.0, 5.0],
    decided="cosh z = x where z > 0 by " + BALLS)
add("area_tangent", "z=atanh(x)", search(lambda x, y, z: tanh(z) - x), clip=box(2.5), eye=[5.0, -4.0, 3.0],
    decided="tanh z = x by " + BALLS)
add("scherk", "z=ln(cos(y)/cos(x))",
    search(lambda x, y, z: exp(z) * cos(x) - cos(y), lambda x, y, z: cos(x) ** 2, lambda x, y, z: cos(y) ** 2),
    clip=box(4, 4, 2), eye=[8.0, -7.0, 6.0], size=(32, 24), decided="exp z cos x = cos y, where neither is 0, by " + BALLS)
add("root_of_wave", "z=sqrt(sin(3*x))", search(lambda x, y, z: z * z - sin(3 * x), lambda x, y, z: z), clip=box(3.0),
    eye=[6.0, -4.0, 5.0], decided="z^2 = sin 3x where z > 0 by " + BALLS)

# Powers.
add("cube_root", "z=x^(1/3)", lambda x, y, z: z**3 - x)
add("cube_root_square", "z=x^(2/3)", lambda x, y, z: z**3 - x**2)
add("cube_root_sum", "x^(2/3)+y^(2/3)=1", lambda x, y, z: (x * x + y * y - 1) ** 3 + 27 * x**2 * y**2,
    decided="a + b + d = 0 gives a^3 + b^3 + d^3 = 3 a b d; " + POLYNOMIAL)
add("cube_root_spun", "x^(2/3)+y^(2/3)+z^2=1",
    lambda x, y, z: (x * x + y * y + (z * z - 1) ** 3) ** 3 - 27 * x**2 * y**2 * (z * z - 1) ** 3, size=(32, 24),
    decided="a + b + d = 0 gives a^3 + b^3 + d^3 = 3 a b d; " + POLYNOMIAL)
add("fifth_root", "z=root(5,x-y)", lambda x, y, z: z**5 - x + y)
add("cbrt_sphere", f"cbrt({S})=1", ONE)
add("power_variable", "x^y=z", search(lambda x, y, z: y * ln(x) - ln(z)),
    clip={"box": [0.1, 3.0, -2.0, 2.0, 0.1, 3.0]}, eye=[7.0, -5.0, 5.0], look_at=[1.5, 0.0, 1.5],
    size=(32, 24), decided="y ln x = ln z by " + BALLS)
CASES["power_variable"]["pieces"][0].within = (lambda x, y, z: x - q("0.05"), lambda x, y, z: z - q("0.05"))
P = abs_power("2.5")
add("superquadric", "abs(x)^2.5+abs(y)^2.5+abs(z)^2.5=1", search(lambda x, y, z: P(x) + P(y) + P(z) - 1))
P15 = abs_power("1.5")
add("superquadric_sharp", "|x|^1.5+|y|^1.5+|z|^1.5=1", search(lambda x, y, z: P15(x) + P15(y) + P15(z) - 1), size=(32, 24))
add("half_power", "z=x^1.5", Piece(lambda x, y, z: z * z - x**3, lambda x, y, z: z))
add("negative_power", "z=x^-2", lambda x, y, z: z * x * x - 1, clip=box(3), eye=[6.0, -5.0, 4.0])
add("high_power", "x^20+y^20+z^20=1", lambda x, y, z: x**20 + y**20 + z**20 - 1, size=(32, 24))

# Creases and solids.
A1, A2 = sphere("1", ("-0.5", "0", "0")), sphere("0.64", ("0.5", "0.3", "0"))
add("union", "min((x+0.5)^2+y^2+z^2-1,(x-0.5)^2+(y-0.3)^2+z^2-0.64)", Piece(A1, A2), Piece(A2, A1), clip=box(1.6))
add("intersection", "max((x+0.5)^2+y^2+z^2-1,(x-0.5)^2+(y-0.3)^2+z^2-0.64)", Piece(A1, lambda *p: -A2(*p)),
    Piece(A2, lambda *p: -A1(*p)), clip=box(1.6))
TUBE = lambda x, y, z: x * x + y * y - q("0.3")
add("difference", f"max({S}-1,-(x^2+y^2-0.3))", Piece(ONE, TUBE), Piece(TUBE, lambda *p: -ONE(*p)))
SIDES = [(k, s) for k in range(3) for s in (1, -1)]
add("cube", "max(abs(x),abs(y),abs(z))=1",
    *[Piece(lambda x, y, z, k=k, s=s: s * (x, y, z)[k] - 1,
            *[lambda x, y, z, j=j, r=r: 1 - r * (x, y, z)[j] for j, r in SIDES if j != k]) for k, s in SIDES])
add("octahedron", "abs(x)+abs(y)+abs(z)=1",
    *[Piece(lambda x, y, z, a=a, b=b, c=c: a * x + b * y + c * z - 1, lambda x, y, z, a=a: a * x, lambda x, y, z, b=b: b * y,
            lambda x, y, z, c=c: c * z) for a in (1, -1) for b in (1, -1) for c in (1, -1)])
add("folded_abs", "z=abs(abs(x)-0.5)",
    *[Piece(lambda x, y, z, s=s, r=r: z - r * (s * x - q("0.5")), lambda x, y, z, s=s: s * x,
            lambda x, y, z, s=s, r=r: r * (s * x - q("0.5"))) for s in (1, -1) for r in (1, -1)])
add("rounded_union", "min(x^2+y^2-0.1,y^2+z^2-0.1,z^2+x^2-0.1)",
    *[Piece(lambda *p, k=k: p[k] ** 2 + p[(k + 1) % 3] ** 2 - q("0.1"),
            *[lambda *p, j=j: p[j] ** 2 + p[(j + 1) % 3] ** 2 - q("0.1") for j in range(3) if j != k]) for k in range(3)])

# Scales and places of the eye.
add("radius_million", f"{S}=1e12", sphere("1e12"), clip=box(1.5e6), eye=[3.0e6, -2.4e6, 1.8e6])
add("radius_ten_thousandth", f"{S}=1e-8", sphere("1e-8"), clip=box(1.5e-4), eye=[3.0e-4, -2.4e-4, 1.8e-4])
add("offset", "(x-100000)^2+y^2+z^2=1", sphere(c=("100000", "0", "0")),
    clip={"box": [99998.5, 100001.5, -1.5, 1.5, -1.5, 1.5]}, eye=[100003.0, -2.4, 1.8], look_at=[100000.0, 0.0, 0.0])
add("offset_expanded", "x^2-200000*x+9999999999+y^2+z^2", sphere(c=("100000", "0", "0")),
    clip={"box": [99998.5, 100001.5, -1.5, 1.5, -1.5, 1.5]}, eye=[100003.0, -2.4, 1.8], look_at=[100000.0, 0.0, 0.0])
add("offset_torus", "((x-100000)^2+y^2+z^2+0.84)^2=4*((x-100000)^2+y^2)",
    lambda x, y, z: (squares(x - 100000, y, z) + q("0.84")) ** 2 - 4 * ((x - 100000) ** 2 + y * y),
    clip={"box": [99998.5, 100001.5, -1.5, 1.5, -1.5, 1.5]}, eye=[100003.0, -2.4, 1.8], look_at=[100000.0, 0.0, 0.0])
add("far_eye", f"{S}=1", ONE, eye=[3000.0, -2400.0, 1800.0], fov=0.04)
add("inside_sphere", f"{S}=1", ONE, eye=[0.2, 0.1, -0.3], look_at=[1.0, 1.0, 0.5], fov=80.0)
add("inside_gyroid", "sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)",
    search(lambda x, y, z: sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x)), clip=ball(4.0), eye=[0.7, 0.8, 0.9],
    look_at=[3.0, 1.0, 0.5], fov=70.0, size=(32, 24))
add("on_sphere_inward", f"{S}=1", ONE, eye=[1.0, 0.0, 0.0], look_at=[0.0, 0.3, 0.2], fov=60.0)
add("on_sphere_outward", f"{S}=1", ONE, eye=[1.0, 0.0, 0.0], look_at=[2.0, 0.3, 0.2], fov=60.0)
add("on_plane", "z=0", lambda x, y, z: z, eye=[1.0, 0.25, 0.0], look_at=[0.0, 0.0, -0.5])
add("on_cylinder", "y^2+z^2=0.25", lambda x, y, z: 4 * (y * y + z * z) - 1, eye=[0.0, 0.5, 0.0], look_at=[0.4, -0.3, 0.1], fov=70.0)
add("on_one_of_two", f"({S}-1)*({S}-0.25)", ONE, sphere("0.25"), eye=[0.0, 0.0, 1.0], look_at=[0.0, 0.2, 0.0])
add("on_saddle", "z=x^2-y^2", lambda x, y, z: z - x * x + y * y, eye=[0.5, 0.5, 0.0], look_at=[0.0, 0.0, 0.1], fov=70.0)
add("large_factor", f"1e200*({S}-1)", ONE)
add("small_factor", f"1e-200*({S}-1)", ONE)
add("overflowing", f"exp(1000*({S}-1))=1", ONE)
add("tall_box", f"{S}=1", ONE, clip={"box": [-1e4, 1e4, -1e4, 1e4, -1e4, 1e4]})

# Smooth, but no polynomials.
METABALLS = lambda x, y, z: (exp(-4 * ((x - q("0.5")) ** 2 + y**2 + z**2)) + exp(-4 * ((x + q("0.5")) ** 2 + y**2 + (z - q("0.3")) ** 2))
                             - q("0.5"))
add("metaballs", "exp(-4*((x-0.5)^2+y^2+z^2))+exp(-4*((x+0.5)^2+y^2+(z-0.3)^2))-0.5", search(METABALLS), size=(32, 24))
add("gyroid", "sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)",
    search(lambda x, y, z: sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x)), clip=ball(4.0), eye=[6.0, -7.0, 5.0], size=(32, 24))
add("exponential", "z=exp(-x^2-y^2)", search(lambda x, y, z: z - exp(-(x * x) - y * y)), clip=box(2.5), eye=[5.0, -4.0, 3.0], size=(32, 24))
add("ripples", "z=sin(x^2+y^2)/2", search(lambda x, y, z: 2 * z - sin(x * x + y * y)), clip=box(4, 4, 1), eye=[8.0, -6.0, 6.0],
    size=(32, 24))
add("steep_step", "z=tanh(20*x)", search(lambda x, y, z: z - tanh(20 * x)), size=(32, 24))
add("error_function", "z=erf(3*x)", search(lambda x, y, z: z - erf(3 * x)), size=(32, 24))
add("catenoid", "x^2+y^2=cosh(z)^2/4", search(lambda x, y, z: 4 * (x * x + y * y) - cosh(z) ** 2), size=(32, 24))
add("helicoid", "x*sin(2*z)=y*cos(2*z)", search(lambda x, y, z: x * sin(2 * z) - y * cos(2 * z)), clip=box(1, 1, 3),
    eye=[6.0, -5.0, 4.0], size=(32, 24))
add("hyperbolic_sine", "sinh(x)*sinh(y)*sinh(z)=0.2", search(lambda x, y, z: sinh(x) * sinh(y) * sinh(z) - q("0.2")), size=(32, 24))
add("mixed_roots", f"sqrt(x^2+y^2+0.01)+sin(4*z)/4=0.8",
    search(lambda x, y, z: sqrt(x * x + y * y + q("0.01")) + sin(4 * z) / 4 - q("0.8")), size=(32, 24))
add("high_frequency", "z=0.3*sin(40*x)*sin(40*y)", search(lambda x, y, z: z - q("0.3") * sin(40 * x) * sin(40 * y)), clip=box(1.0),
    eye=[1.5, -1.2, 2.0], size=(24, 18))


def shifted(name, offset):
    """`(x-0.3)` with the sign as people write it."""
    if offset in ("0", "-0"):
        return name
    return f"({name}+{offset[1:]})" if offset.startswith("-") else f"({name}-{offset})"


def distance_text(c):
    return "+".join(f"{shifted(name, offset)}^2" for name, offset in zip("xyz", c))


# Many terms.
CENTRES = [
    ("0.372", "-0.468", "0.42"), ("-0.944", "0.04", "-0.025"), ("0.246", "-0.312", "-0.584"),
    ("-0.302", "0.781", "-0.785"), ("-0.485", "0.344", "0.695"), ("0.094", "0.301", "-0.6"),
    ("-0.41", "-0.131", "0.5"), ("-0.61", "0.136", "0.037"), ("-0.246", "-0.762", "0.35"),
    ("0.803", "-0.264", "0.492"), ("-0.899", "0.259", "0.118"), ("0.48", "0.97", "-0.248"),
    ("-0.3", "-0.937", "0.145"), ("-0.312", "-0.84", "0.729"), ("0.956", "0.118", "-0.027"),
    ("-0.297", "-0.96", "-0.112"), ("-0.46", "-0.295", "-0.906"), ("-0.817", "-0.362", "0.597"),
    ("-0.147", "0.87", "-0.004"), ("-0.677", "-0.12", "-0.616"),
]
GAUSSIANS = [sphere("0", c) for c in CENTRES]
add("twenty_gaussians", "+".join(f"exp(-4*({distance_text(c)}))" for c in CENTRES) + "-0.6",
    search(lambda x, y, z: sum((exp(-4 * g(x, y, z)) for g in GAUSSIANS[1:]), exp(-4 * GAUSSIANS[0](x, y, z))) - q("0.6")),
    clip=ball(2.5), eye=[2.566, -3.91, 2.077], size=(24, 18))
GRID = [(a, b, c) for a in ("-0.8", "0", "0.8") for b in ("-0.8", "0", "0.8") for c in ("-0.8", "0", "0.8")]
BALLS_TEXT = "min(" + ",".join(f"sqrt({distance_text(c)})-0.5" for c in GRID) + ")"
CUT_TEXT = "(0.9-sqrt((x-0.7)^2+(y+0.9)^2+(z-0.6)^2))"


def cut_ball(c):
    """The smooth maximum of one ball and the outside of the ball that is cut away."""
    near, cut = sphere("0", c), sphere("0", ("0.7", "-0.9", "0.6"))

    def g(x, y, z):
        a, b = sqrt(near(x, y, z)) - q("0.5"), q("0.9") - sqrt(cut(x, y, z))
        return a + b + sqrt((a - b) ** 2 + q("0.01"))

    return g


add("balls_cut_smoothly", f"a={BALLS_TEXT}; b={CUT_TEXT}; (a+b+sqrt((a-b)^2+0.01))/2=0",
    *[search(cut_ball(c)) for c in GRID], clip=ball(2.5), eye=[2.786, -4.245, 2.255], size=(16, 12),
    decided="from outside, the first root of the least of 27 functions is the first root of any; " + BALLS)
add("balls", BALLS_TEXT, *[sphere("0.25", c) for c in GRID], clip=ball(2.5), eye=[2.786, -4.245, 2.255], size=(32, 24),
    decided="from outside, the first root of the least of 27 functions is the first root of any; " + POLYNOMIAL)

# The same from other sides.
for case, count, seed, distance in [
    ("double_square", 2, 11, 4.5), ("double_letters", 2, 12, 10.0), ("barth_sextic_decimals", 3, 13, 5.0), ("kummer", 2, 14, 7.0),
    ("steiner", 2, 15, 2.2), ("cross_cap", 2, 16, 4.5), ("whitney", 2, 17, 6.0), ("cayley_cubic", 2, 18, 5.0), ("tan", 2, 19, 14.0),
    ("floor", 2, 20, 9.0), ("hemisphere", 2, 21, 4.5), ("union", 2, 22, 4.5), ("shell_hundred_thousandth", 2, 23, 4.0),
    ("reciprocal_product", 2, 24, 9.0), ("cuspidal_edge", 2, 25, 4.5), ("cube_root_sum", 2, 26, 4.5), ("octahedron", 2, 27, 4.0),
    ("logarithm_times", 2, 28, 4.5), ("superquadric", 1, 29, 4.5), ("abs_minus_floor", 2, 30, 7.0), ("swallowtail", 2, 31, 4.5),
    ("arcsine_whole", 1, 32, 6.0), ("quadruple_expanded", 2, 33, 4.5), ("chmutov", 1, 34, 4.5), ("quotient", 2, 35, 4.5),
]:
    turned(case, count, seed, distance)
