"""Makes tests/data/derivatives.tsv: values and gradients of 300 formulas, correct to 50 digits.

Needs sympy and mpmath. Run from the project's root:  python tests/tools/derivatives.py

Values are computed by mpmath with 130 digits. Gradients are central differences of step 1e-45 at that precision
(error about 1e-90, independent of any rule of differentiation), and are compared with SymPy's symbolic derivative
where that exists in closed form. Only explicit operators and brackets are used, so that any reader of the language
agrees on what is meant. Columns: formula TAB x y z TAB value TAB fx fy fz.
"""

import random
import re

import mpmath as mp
import sympy as sp

mp.mp.dps = 130
STEP = mp.mpf(10) ** -45

HAND = """
x^2+y^2+z^2-1
(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)
z-sin(x)*cos(y)
(x^2+2.25*y^2+z^2-1)^3-x^2*z^3-0.1125*y^2*z^3
sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)
cos(x)+cos(y)+cos(z)
x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8
4*(2.618033988749895*x^2-y^2)*(2.618033988749895*y^2-z^2)*(2.618033988749895*z^2-x^2)-4.23606797749979*(x^2+y^2+z^2-1)^2
8*(x^2-6.854101966249685*y^2)*(y^2-6.854101966249685*z^2)*(z^2-6.854101966249685*x^2)*(x^4+y^4+z^4-2*x^2*y^2-2*x^2*z^2-2*y^2*z^2)+11.090169943749475*(x^2+y^2+z^2-1)^2*(x^2+y^2+z^2-0.3819660112501051)^2
(x^2+y^2+z^2+2*y-1)*((x^2+y^2+z^2-2*y-1)^2-8*z^2)+16*x*z*(x^2+y^2+z^2-2*y-1)
81*(x^3+y^3+z^3)-189*(x^2*y+x^2*z+y^2*x+y^2*z+z^2*x+z^2*y)+54*x*y*z+126*(x*y+x*z+y*z)-9*(x^2+y^2+z^2)-9*(x+y+z)+1
128*x^8-256*x^6+160*x^4-32*x^2+128*y^8-256*y^6+160*y^4-32*y^2+128*z^8-256*z^6+160*z^4-32*z^2+4
exp(-4*((x-0.372)^2+(y+0.468)^2+(z-0.42)^2))+exp(-4*((x+0.944)^2+(y-0.04)^2+(z+0.025)^2))-0.6
min(x^2+y^2+z^2-1,(x-1)^2+y^2+z^2-0.5)
max(abs(x)-1,max(abs(y)-1,abs(z)-1))
x/(1+x^2+y^2)
x*y/(x^2+y^2+z^2)
1/x+1/y-1/z
tan(x/3)+tan(y/3)*tan(z/4)
sqrt(x^2+y^2)-z
(sqrt(x^2+y^2)-1)^2+z^2-0.25
sqrt(sqrt(x^2+1)+sqrt(y^2+z^4))
exp(x)*sin(y)-ln(1+z^2)
ln(x^2+y^2+1)*log2(z^2+2)-log10(3+x^2)
asin(x/4)+acos(y/5)*atan(z)
asin(sin(x)/2)+acos(cos(y)/3)
sinh(x)*cosh(y)-tanh(z)
asinh(x)+acosh(2+y^2)*atanh(z/4)
erf(x)*erf(y-z)
erf(x*y)^2-exp(-z^2)
atan2(y,x)-z
atan2(z,sqrt(x^2+y^2))
atan2(sin(x),cos(y)+2)
cbrt(x)+cbrt(y*z)
root(5,x+y)-root(7,z)
cbrt(x^2+y)^2
(1+x^2)^y
(2+sin(x))^(cos(y)*z)
(x^2+1)^2.5-y
(x^2+y^2)^0.3+z
2^x+3^y-1.5^z
exp(x*y*z)
exp(sin(exp(x/2)))+y*z
sin(sin(sin(x+y)+y)+z)
ln(ln(x^2+3)+y^2)
abs(x*y-z)
abs(sin(x))+abs(abs(y)-1)-z
floor(x)+x*floor(y)+z
x-2*floor(x/2)+y
sign(x)*y^2+sign(z)*x
if(x-y<=0,x^2*y,y^3)+z
if(sin(x)<=0,cos(y),z*x)
min(x,min(y,z))+max(x*y,z)
min(sin(x),cos(y))*max(exp(z),2)
x^-1+y^-2+z^-3
(x+y*z)^-4
(x+y+z)^7-(x*y*z)^5
x^9*y^8-z^11
(1+x/10)^40
(x^2+y^2+z^2)^-1.5
x/3+y/7+z/0.1
pi*x^2-e*y+sqrt(2)*z
cos(pi*x)*sin(e*y)+z/pi
sqrt(1+sqrt(1+sqrt(1+x^2+y^2+z^2)))
(x-y)/(x+y)+(y-z)/(y+z)
((x+1)/(y+3))^3-z
1/(1+1/(1+1/(1+x^2)))-y*z
exp(-(x^2+y^2)/2)/sqrt(2*pi)-z
sin(x*y)/(1+z^2)+cos(y*z)/(1+x^2)
sin(x)/x-z*y
ln(exp(x)+exp(y)+exp(z))
sqrt(exp(x)+exp(-y))*z
atan(x*y)/atan(1+z^2)
tanh(20*(x^2+y^2-1))+z
sinh(x/2)^2-cosh(y/2)^2+1+z
cosh(x)*cosh(y)*cosh(z)-5
asinh(x*y*z)
acosh(1+x^2+y^2)-z
atanh(sin(x)*cos(y))-z
erf(x)/erf(1+y^2)-z
log2(1+exp(x))+log10(1+exp(y))-ln(1+exp(z))
x^2*y^2+y^2*z^2+z^2*x^2-x*y*z
x^2-y^2*z
x*y*z*(x+y+z)*(x-y)*(y-z)
(x*y+y*z+z*x)^3-8*x*y*z
(x^2+y^2-z^2)^2*(x+y)^3
""".split()

LEAVES = ["x", "y", "z", "x", "y", "z", "2", "3", "0.5", "1.25", "pi"]
INNER = ["sin({})", "cos({})", "atan({})", "tanh({})", "exp({}/4)", "asinh({})", "erf({})", "abs({})", "cbrt({})",
         "sqrt(1+({})^2)", "ln(2+({})^2)", "({})^2", "({})^3", "1/(2+({})^2)", "sinh({}/3)", "cosh({}/3)", "-({})",
         "log2(3+({})^2)", "log10(1.5+({})^2)", "asin(sin({})/2)", "acos(tanh({}))", "atanh(tanh({})/2)",
         "acosh(1.5+({})^2)", "tan(atan({})/2)", "root(5,{})", "floor({})", "sign({})*({})"]
OUTER = ["({})+({})", "({})-({})", "({})*({})", "({})/(1.5+({})^2)", "min({},{})", "max({},{})", "atan2({},2+sin({}))",
         "(1.5+sin({}))^({})", "if({}<=0,{},x*y)"]


def generated(rng, depth):
    if depth == 0 or rng.random() < 0.1:
        return rng.choice(LEAVES)
    if rng.random() < 0.5:
        return inner(rng, generated(rng, depth - 1))
    return rng.choice(OUTER).format(generated(rng, depth - 1), generated(rng, depth - 1))


def inner(rng, argument):
    template = rng.choice(INNER)
    return template.format(*[argument] * template.count("{}"))


def real_root(n, v):
    n = int(n)
    return mp.sign(v) * mp.root(abs(v), n)


MP = dict(sin=mp.sin, cos=mp.cos, tan=mp.tan, asin=mp.asin, acos=mp.acos, atan=mp.atan, sinh=mp.sinh, cosh=mp.cosh,
          tanh=mp.tanh, asinh=mp.asinh, acosh=mp.acosh, atanh=mp.atanh, exp=mp.exp, ln=mp.log, erf=mp.erf,
          log2=lambda v: mp.log(v) / mp.log(2), log10=mp.log10, sqrt=mp.sqrt, cbrt=lambda v: real_root(3, v),
          root=real_root, abs=abs, sign=mp.sign, floor=mp.floor, min=min, max=max, atan2=mp.atan2, pi=mp.pi, e=mp.e,
          choose=lambda c, a, b: a if c <= 0 else b, N=mp.mpf)
SP = dict(sin=sp.sin, cos=sp.cos, tan=sp.tan, asin=sp.asin, acos=sp.acos, atan=sp.atan, sinh=sp.sinh, cosh=sp.cosh,
          tanh=sp.tanh, asinh=sp.asinh, acosh=sp.acosh, atanh=sp.atanh, exp=sp.exp, ln=sp.log, erf=sp.erf,
          log2=lambda v: sp.log(v) / sp.log(2), log10=lambda v: sp.log(v) / sp.log(10), sqrt=sp.sqrt, pi=sp.pi, e=sp.E,
          atan2=sp.atan2, N=sp.Rational)


def python(formula):
    text = re.sub(r"(?<![A-Za-z0-9_.])(\d+\.?\d*)", r'N("\1")', formula)
    return text.replace("^", "**").replace("if(", "choose(").replace("<=N(\"0\")", "")


def evaluated(code, point):
    value = eval(code, {"__builtins__": {}}, dict(MP, x=point[0], y=point[1], z=point[2]))
    value = mp.mpmathify(value)
    if isinstance(value, mp.mpc) or not mp.isfinite(value):
        raise ValueError("no value")
    return value


def gradient(code, point):
    slopes = []
    for i in range(3):
        up, down = list(point), list(point)
        up[i] += STEP
        down[i] -= STEP
        middle, up, down = evaluated(code, point), evaluated(code, up), evaluated(code, down)
        if abs((up - middle) - (middle - down)) > STEP * mp.mpf(10) ** -25:
            raise ValueError("a crease or a jump")
        slopes.append((up - down) / (2 * STEP))
    return slopes


def symbolic_agrees(formula, code, point, slopes):
    """Compares with SymPy where it knows every function; says whether it did."""
    if re.search(r"min|max|abs|floor|sign|cbrt|root|if\(", formula):
        return False
    x, y, z = sp.symbols("x y z", real=True)
    f = eval(code, {"__builtins__": {}}, dict(SP, x=x, y=y, z=z))
    exact = dict(zip((x, y, z), (sp.Rational(str(v)) for v in point)))
    for variable, slope in zip((x, y, z), slopes):
        value = sp.N(sp.diff(f, variable).subs(exact), 60)
        assert abs(mp.mpf(str(value)) - slope) <= mp.mpf(10) ** -48 * (1 + abs(slope)), (formula, variable, value, slope)
    return True


def rows(formula, rng):
    code, found, tries = python(formula), [], 0
    while len(found) < 2 and tries < 60:
        tries += 1
        # Multiples of 1/64 are f64 exactly, and so is their decimal.
        point = [rng.randrange(-128, 129) / 64 for _ in range(3)]
        exact = [mp.mpf(v) for v in point]
        try:
            value, slopes = evaluated(code, exact), gradient(code, exact)
        except (ValueError, ZeroDivisionError, TypeError):
            continue
        if max(abs(v) for v in [value, *slopes]) > 1e12:
            continue
        found.append((point, value, slopes, code))
    return found


def main():
    rng = random.Random(20)
    formulas = list(HAND)
    for name in ["x", "x*y+z", "x-y*z/2"]:
        formulas += [t.format(*[name] * t.count("{}")) for t in INNER]
    while len(formulas) < 300:
        text = generated(rng, 4)
        if text not in formulas and any(v in text for v in "xyz") and len(text) < 400:
            if rows(text, random.Random(1)):
                formulas.append(text)
    show = lambda v: mp.nstr(v, 50)
    compared = 0
    with open("tests/data/derivatives.tsv", "w") as out:
        for formula in formulas:
            found = rows(formula, rng)
            assert found, formula
            for point, value, slopes, code in found:
                compared += symbolic_agrees(formula, code, point, slopes)
                where = " ".join(repr(v) for v in point)
                out.write(f"{formula}\t{where}\t{show(value)}\t{' '.join(map(show, slopes))}\n")
    print(len(formulas), "formulas;", compared, "rows compared with SymPy")


main()
