"""Values of Preetham, Shirley and Smits' sky by their formulas, for the table in src/scene/daylight.rs.

Written from "A practical analytic model for daylight" (1999), appendix A.2, with names and order of its own; luminances over
179 lm/W, chromaticities to linear sRGB by the matrix of IEC 61966-2-1. Run: python3 tests/tools/daylight.py
"""

from math import acos, cos, exp, pi, sqrt, tan


def unit(v):
    length = sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def coefficients(t):
    luminance = (0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703)
    x = (-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452)
    y = (-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529)
    return luminance, x, y


def distribution(theta, gamma, c):
    a, b, c_, d, e = c
    return (1 + a * exp(b / cos(theta))) * (1 + c_ * exp(d * gamma) + e * cos(gamma) ** 2)


def zenith(t, s):
    chi = (4 / 9 - t / 120) * (pi - 2 * s)
    luminance = 1000 * ((4.0453 * t - 4.9710) * tan(chi) - 0.2155 * t + 2.4192)
    x = (
        (0.00166 * s**3 - 0.00375 * s**2 + 0.00209 * s) * t**2
        + (-0.02903 * s**3 + 0.06377 * s**2 - 0.03202 * s + 0.00394) * t
        + (0.11693 * s**3 - 0.21196 * s**2 + 0.06052 * s + 0.25886)
    )
    y = (
        (0.00275 * s**3 - 0.00610 * s**2 + 0.00317 * s) * t**2
        + (-0.04214 * s**3 + 0.08970 * s**2 - 0.04153 * s + 0.00516) * t
        + (0.15346 * s**3 - 0.26756 * s**2 + 0.06670 * s + 0.26688)
    )
    return luminance, x, y


def radiance(sun, turbidity, direction):
    sun, direction = unit(sun), unit(direction)
    sun_angle, view_angle = acos(sun[2]), acos(direction[2])
    between = acos(max(-1, min(1, sum(a * b for a, b in zip(sun, direction)))))
    values = []
    for value, c in zip(zenith(turbidity, sun_angle), coefficients(turbidity)):
        values.append(value * distribution(view_angle, between, c) / distribution(0, sun_angle, c))
    luminance, x, y = values
    X, Y, Z = luminance * x / y, luminance, luminance * (1 - x - y) / y
    rgb = (
        3.2406 * X - 1.5372 * Y - 0.4986 * Z,
        -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
        0.0557 * X - 0.2040 * Y + 1.0570 * Z,
    )
    return [max(0.0, part) / 179 for part in rgb]


ROWS = [
    ((0.6, 0.0, 0.8), 2.5, (0.0, 0.0, 1.0)),
    ((0.6, 0.0, 0.8), 2.5, (-0.6, 0.0, 0.8)),
    ((0.6, 0.0, 0.8), 2.5, (0.5, 0.1, 0.8)),
    ((1.0, -1.0, 2.0), 3.0, (0.3, 0.9, 0.1)),
    ((1.0, -1.0, 2.0), 6.0, (-0.3, 0.2, 0.5)),
    ((0.0, 1.0, 0.05), 2.0, (0.0, 0.9, 0.2)),
    ((0.0, 1.0, 0.05), 10.0, (0.0, -0.9, 0.2)),
    ((0.0, 0.0, 1.0), 4.0, (1.0, 0.0, 0.01)),
]

if __name__ == "__main__":
    print("    /// Sun, turbidity, direction, radiance, by tests/tools/daylight.py.")
    print(f"    const ROWS: [([f64; 3], f64, [f64; 3], [f64; 3]); {len(ROWS)}] = [")
    for sun, turbidity, direction in ROWS:
        print(f"        ({list(sun)}, {turbidity}, {list(direction)}, {radiance(sun, turbidity, direction)}),")
    print("    ];")
