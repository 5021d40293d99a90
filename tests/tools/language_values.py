#!/usr/bin/env python3
"""Writes tests/data/language-values.tsv: typed programs with the value of their first surface's function at a point.

Needs mpmath. Each row below is `program => value`: the left is text of the language, the right says in Python, fully
bracketed and without any rule of the language, what it must mean. `[Q]`, `[R]`, `[S]` in front pick another
point than the first. The values are worked out at 50 digits and written with 20.

    python tests/tools/language_values.py > tests/data/language-values.tsv
"""

import mpmath
from mpmath import mp, mpf

mp.dps = 50

POINTS = {"P": ("0.75", "-1.25", "0.375"), "Q": ("-1.5", "0.25", "2"), "R": ("0", "0", "0"), "S": ("0.1", "-2", "3")}

ROWS = r"""
# numbers and constants
x+2 => x+2
x+.5 => x+mpf(1)/2
x+2. => x+2
x+1e-3 => x+mpf(1)/1000
x+1E2 => x+100
x+2e3 => x+2000
x+2e+3 => x+2000
x+2e => x+2*E
x+2e-x => x+2*E-x
x+2e-z => x+2*E-z
x+0.1+0.2 => x+mpf(3)/10
x+pi => x+pi
x+π => x+pi
x+tau => x+2*pi
x+e => x+E
x+golden => x+(1+sqrt(mpf(5)))/2
2πx => 2*pi*x
πx => pi*x
x*123456789012345678901234567890 => x*123456789012345678901234567890
x+1/3+1/3+1/3 => x+1
x => x
# coordinates ready for use
x+r => x+sqrt(x*x+y*y)
theta+x => atan2(y,x)+x
rho-x => sqrt(x*x+y*y+z*z)-x
phi-x => acos(z/sqrt(x*x+y*y+z*z))-x
θ+x => atan2(y,x)+x
ρ-x => sqrt(x*x+y*y+z*z)-x
φ-x => acos(z/sqrt(x*x+y*y+z*z))-x
|p|-1 => sqrt(x*x+y*y+z*z)-1
p.x+2p.y+3p.z => x+2*y+3*z
r^2+z^2 => x*x+y*y+z*z
[Q] theta+x => atan2(y,x)+x
[R] theta+x => nan
[R] phi+x => nan
r = 1 => sqrt(x*x+y*y)-1
rho = 2 => sqrt(x*x+y*y+z*z)-2
theta = z => atan2(y,x)-z
phi = 1 => acos(z/sqrt(x*x+y*y+z*z))-1
r = 2; x + r = 0 => x+2
x + r = 0; r = 3 => x+3
p = (1,2,3); p.y*x => 2*x
# operators, precedence
-x^2 => -(x**2)
2^3^2+x => 512+x
x^-2 => 1/x**2
x**2 => x**2
x**2**3 => x**8
-x^-2 => -(1/x**2)
(-x)^2 => x**2
x-y-z => (x-y)-z
x-y+z => (x-y)+z
x/y/z => (x/y)/z
x/y*z => (x/y)*z
x*y/z => (x*y)/z
x-(y-z) => x-y+z
x/(y/z) => x*z/y
- - x => x
-(-x) => x
+x => x
x + -y => x-y
x*-y => -(x*y)
x/-y => -(x/y)
x - -y => x+y
2^-x => 2**(-x)
2^-1+x => x+mpf(1)/2
-2^2+x => -4+x
(x+y)*(y-z) => (x+y)*(y-z)
x·y => x*y
x×y => x*y
x÷y => x/y
x−y => x-y
x % 0.5 => x-fl(x/mpf('0.5'))*mpf('0.5')
[Q] x % 1 => x-fl(x)
y % 1 => y-fl(y)
y % -1 => y+fl(-y)
x*y%z => (x*y)-z*fl((x*y)/z)
x%y*z => (x-y*fl(x/y))*z
2+y%z => 2+(y-z*fl(y/z))
[R] 1%x => nan
# powers
x^3 => x**3
[Q] x^3 => x**3
x^0 => 1
[R] x^0 => 1
y^0 => 1
ln(y)^0 => nan
ln(x)^0 => 1
sqrt(y)^0 => nan
x^1 => x
x^2.0 => x**2
y^(1/3) => rt(3,y)
y^(-1/3) => 1/rt(3,y)
y^(-2/3) => 1/rt(3,y)**2
y^(2/3) => rt(3,y)**2
y^(5/3) => rt(3,y)**5
y^(2/6) => rt(3,y)
y^(4/2) => y**2
y^-(1/3) => 1/rt(3,y)
y^(3/2) => nan
x^(3/2) => x**mpf(1.5)
x^(1/2) => sqrt(x)
x^0.5 => sqrt(x)
x^2.5 => x**mpf(2.5)
y^2.5 => nan
x^-2.5 => x**mpf(-2.5)
[R] x^-2.5 => nan
[R] x^2.5 => 0
x^(3/4) => x**mpf(0.75)
x^0.2 => x**(mpf(1)/5)
y^0.2 => nan
y^(1/5) => rt(5,y)
y^(0.5/1.5) => nan
n = 3; y^(1/n) => nan
n = 3; x^(1/n) => rt(3,x)
n = 3; y^n => y**3
n = 4 in [1, 6]; y^n => y**4
n = 2.5 in [1, 6]; y^n => nan
x^y => x**y
y^x => nan
y^floor(x+2) => nan
x^z => x**z
[R] x^(z+1) => 0
[R] x^z => nan
[R] x^(z-1) => nan
[R] x^-1 => nan
2^x => 2**x
e^x => exp(x)
e^(x*y) => exp(x*y)
e^2x => exp(2)*x
e^-x^2 => exp(-(x**2))
e^(-2)+x => exp(-2)+x
x^1/2 => x/2
2^0.5*x => sqrt(mpf(2))*x
x^1000000000 => mpf(x)**1000000000
[Q] ((x^3)^3)^3 => x**27
x² => x**2
x³+y² => x**3+y**2
x⁻² => 1/x**2
x¹⁰ => x**10
xy² => x*y**2
x^2^-1 => sqrt(x)
(x^2)^0.5 => abs(x)
[Q] sqrt(x^2) => abs(x)
[Q] sqrt(x)^2 => nan
sqrt(x)^2 => x
[Q] x^(1/3)^3 => nan
[Q] (x^(1/3))^3 => x
# an exponent with a coordinate in it keeps its domain when it folds to a constant
z^(x-x) => 1
y^(x-x) => nan
[R] z^(x-x) => nan
[R] x^(x-x+1) => 0
y^(x-x+2) => nan
y^(0x+1/3) => nan
y^(1+1) => y**2
y^(3-1) => y**2
w = x-x+2; y^w => nan
w = 4/2; y^w => y**2
f(n) = y^n; f(2) => y**2
f(n) = y^n; f(2+x-x) => nan
f(u) = u + 0x; y^f(2) => nan
sum(k = 1..2, y^k) => y+y**2
sum(k in [x-x+1], y^k) => nan
y^if(x < 0, 2, 2) => nan
y^(p.x-x+2) => nan
# floor and remainder of a quotient that rounds to a whole number
[S] 2 % x => 2-x*19
[S] mod(2,x) => 2-x*19
[S] floor(2/x) => 19
[S] mod(-2,x) => -2+x*20
[S] mod(y,x) => -2+x*20
[S] z % x => z-29*x
[S] floor(z/x) => 29
[S] mod(y,-x) => y+19*x
[S] z % 0.1 => 3-30*(mpf(1)/10)
[S] mod(x*30, x) => x*30-x*30
[S] floor(x/3) => 0
mod(3x, y) => 3*x-y*fl(3*x/y)
# as people type and paste it
x ^ 2 + y ^ 2 => x**2+y**2
 x  *  y  => x*y
x^ 2y => x**2*y
2 x^2 y => 2*x**2*y
2(x)(y)^2 => 2*x*y**2
-2x^2 => -2*x**2
-(x)^2 => -(x**2)
2-x^-1 => 2-1/x
2*-x => -2*x
x--y => x+y
x+-+y => x-y
x*+y => x*y
+-x => -x
x−−y => x+y
x·y÷z => x*y/z
x∙y => x*y
x²+y² => x**2+y**2
x²y³ => x**2*y**3
x⁻¹y => y/x
(x+y)² => (x+y)**2
2x² => 2*x**2
x^2² => x**4
2^x² => 2**(x**2)
|x|² => x**2
√x² + √(y²) => abs(x)+abs(y)
√x y => sqrt(x)*y
√xy => sqrt(x)*y
2√x => 2*sqrt(x)
√√x => sqrt(sqrt(x))
∛x³ => x
√|y| => sqrt(abs(y))
√x/2 => sqrt(x)/2
√2 x => sqrt(mpf(2))*x
√(2x) => sqrt(2*x)
1/√x => 1/sqrt(x)
x/2/y => x/2/y
x/2y/z => x/2*y/z
1/2/x y => 1/(2*x)*y
6/2(1+x) => 3*(1+x)
x % 2 y => (x-2*fl(x/2))*y
2x % y => 2*x-y*fl(2*x/y)
-x % 2 => (-x)-2*fl(-x/2)
-(x % 2) => -(x-2*fl(x/2))
x^2 % y => x**2-y*fl(x**2/y)
5 % y => 5-y*fl(5/y)
2^-x^2 => 2**(-(x**2))
2^(-x)^2 => 2**(x**2)
x^y^0 => x
(x^2)^3 => x**6
x^2^3 => x**8
x^+2 => x**2
x^--2 => x**2
x^(-2) => x**-2
x^(2) => x**2
x^(1)/(2) => x/2
x**-1 => 1/x
x^.5 => sqrt(x)
x^2. => x**2
x^1e0 => x
y^(+1/3) => rt(3,y)
y^(-(1/3)) => 1/rt(3,y)
y^((1)/(3)) => rt(3,y)
y^(3/9) => rt(3,y)
y^(6/3) => y**2
y^(1/2) => nan
y^(2/4) => nan
y^(0.333) => nan
y^(1/3.0) => rt(3,y)
y^(1/3+0) => nan
y^(-4/3) => rt(3,y)**-4
(y^3)^(1/3) => y
(y^2)^(1/2) => abs(y)
(y^(1/3))^2 => rt(3,y)**2
(-8)^(1/3) + x => -2+x
-8^(1/3) + x => -2+x
(-8)^(2/3) + x => 4+x
(-4)^0.5 + x => nan
(-2)^2 + x => 4+x
(-2)^-3 + x => x-mpf(1)/8
0^0 + x => 1+x
[R] 0^x => nan
[R] 1 + x^2^0 => 1
x^0.0 => 1
y^(0/5) => 1
y^(0/2) => 1
e^x y => mpmath.exp(x)*y
e^-x => mpmath.exp(-x)
e^x^2 => mpmath.exp(x**2)
e^(x)y => mpmath.exp(x)*y
2e^x => 2*mpmath.exp(x)
xe^x => x*mpmath.exp(x)
x e^-x^2 => x*mpmath.exp(-(x**2))
exp x^2 => mpmath.exp(x**2)
exp(x)^2 => mpmath.exp(x)**2
e^2 x => mpmath.exp(2)*x
e2 = 5; x*e2 => 5*x
# functions, nested without brackets
sin cos x => sin(cos(x))
sin cos tan y => sin(cos(tan(y)))
cos sin x cos y => cos(sin(x))*cos(y)
sin √x => sin(sqrt(x))
√sin x => sqrt(sin(x))
sin |y| => sin(abs(y))
|sin y| => abs(sin(y))
|sin y| cos x => abs(sin(y))*cos(x)
ln |y| => log(abs(y))
sin(cos(x)) sin y => sin(cos(x))*sin(y)
sin x sin y sin z => sin(x)*sin(y)*sin(z)
sin 2x cos 3y => sin(2*x)*cos(3*y)
2sin x cos y z => 2*sin(x)*cos(y*z)
x sin y => x*sin(y)
x sin y z => x*sin(y*z)
sin x + cos y => sin(x)+cos(y)
sin x - y => sin(x)-y
sin -x^2 => sin(-(x**2))
sin +x => sin(x)
-sin -x => -sin(-x)
sin 2 pi x => sin(2*pi*x)
sin 2πx => sin(2*pi*x)
sin πx => sin(pi*x)
sin pi/2 + x => sin(pi)/2+x
sin(pi/2) + x => 1+x
sin x^2 y => sin(x**2*y)
sin(x)^2 y => sin(x)**2*y
sin (x)^2 => sin(x)**2
sin (x+y) z => sin(x+y)*z
sin(x)(y) => sin(x)*y
sin x(y)(z) => sin(x*y*z)
sin^2 x cos^3 y => sin(x)**2*cos(y)**3
sin^2 2x => sin(2*x)**2
sin^2(x)y => sin(x)**2*y
sin³y => sin(y)**3
n = 2; sin^n x => sin(x)**2
ln^2 x => log(x)**2
sqrt x + y => sqrt(x)+y
sqrt x y => nan
sqrt(x) y => sqrt(x)*y
log x => log(x)/log(mpf(10))
log 100x => log(100*x)/log(mpf(10))
log(2, 8) + x => 3+x
log(e, x) => log(x)
log(0.5, x) => log(x)/log(mpf(1)/2)
log2 8x => log(8*x)/log(mpf(2))
ln e^x => x
ln e x => 1+log(x)
abs -y => abs(-y)
min(x, y)z => min(x,y)*z
max(x, y, z)^2 => max(x,y,z)**2
tan x/y => tan(x)/y
f(u) = u^2; f x => x**2
f(u) = u^2; f x y => (x*y)**2
f(u) = u^2; f x + 1 => x**2+1
f(u) = u^2; f(x)y => x**2*y
f(u) = u^2; f^2 x => x**4
f(u) = u^2; sin f x => sin(x**2)
# bars
|x|y => abs(x)*y
y|x| => y*abs(x)
2|x||y| => 2*abs(x)*abs(y)
|x| |y| => abs(x)*abs(y)
|x y| => abs(x*y)
|-x| => abs(x)
-|x| => -abs(x)
|x|^y => abs(x)**y
|(x)| => abs(x)
(|x|) => abs(x)
||x|| => abs(x)
|||x|-1|-2| => abs(abs(abs(x)-1)-2)
|x + |y|| => abs(x+abs(y))
||x| + y| => abs(abs(x)+y)
|x| - |y| => abs(x)-abs(y)
|x|*|y| => abs(x)*abs(y)
|x|/|y| => abs(x)/abs(y)
|x|(y+1) => abs(x)*(y+1)
(x)|y| => x*abs(y)
|x^2 - |y|^3| => abs(x**2-abs(y)**3)
max(|x|, |y|) => max(abs(x),abs(y))
|(1,2,2)| + x => 3+x
|p|^2 - 1 => x*x+y*y+z*z-1
|p - (0,0,1)| => sqrt(x*x+y*y+(z-1)**2)
# names that fall apart
xyz^2 => x*y*z**2
2xy => 2*x*y
xx => x*x
xyx => x*y*x
x²yz => x**2*y*z
xy/z => x*y/z
x/yz => x/y*z
xy^-1 => x/y
a = 2; ax^2 + ay => 2*x**2+2*y
a = 2; b = 3; ab x => 6*x
a = 2; xa => 2*x
a = 2; 3ax => 6*x
a = 2; b = 3; abxy => 6*x*y
a = 2; a^2x => 4*x
c = 3; r = 2; x r c => 6*x
θ = 2; θx => 2*x
α = 2; αx + α => 2*x+2
f(s, t) = st; f(x, y) => x*y
f(s) = sx; f(y) => y*x
sum(k = 1..3, kx) => 6*x
A1 = 2; A1 x => 2*x
x_1 = 2; x_1 y => 2*y
R = 2; R x => 2*x
R = 2; r = 3; R*r*x => 6*x
ex + e => E*x+E
# regions, chains
x < y < z => max(x-y,y-z)
z >= y >= x => max(y-z,x-y)
1 < x < 2 or y < 0 => min(max(1-x,x-2),y)
not not x < 1 => x-1
not x < 1 or y < 1 => min(1-x,y-1)
x < 1 and not y < 1 and z < 1 => max(x-1,1-y,z-1)
(x < 1 or y < 1) and z < 0 => max(min(x-1,y-1),z)
A = x < 1; B = y < 1; not (A or B) => -min(x-1,y-1)
A = x < 1; B = y < 1; C = z < 1; A and B or not C => min(max(x-1,y-1),1-z)
difference(x < 1, y < 1) => max(x-1,1-y)
difference(union(x<1, y<1), z<1, y<0) => max(min(x-1,y-1),1-z,-y)
intersection(x<1, not y<1) => max(x-1,1-y)
smooth_union(1, x, y) => min(x,y)-max(1-abs(x-y),0)**2/4
smooth_union(2, x, y) => min(x,y)-max(2-abs(x-y),0)**2/8
smooth_union(1, x, z, y) => (lambda m: min(m,y)-max(1-abs(m-y),0)**2/4)(min(x,z)-max(1-abs(x-z),0)**2/4)
smooth_union(1, x<1, z<1) => min(x-1,z-1)-max(1-abs(x-z),0)**2/4
union(x<1) => x-1
|p| <= 1 => sqrt(x*x+y*y+z*z)-1
# no value spreads
if(x > 0, ln(y), 2) + if(x < 0, ln(y), 2) => nan
if(x < 0, ln(y), 2) + x => 2+x
min(ln(y), x) => nan
min(x, 1/(x-0.75)) => nan
max(x, acos(y)) => nan
hypot(sqrt(y), x) => nan
atan2(ln(y), x) => nan
clamp(x, ln(y), 1) => nan
step(ln(y), x) => nan
smoothstep(1, 1, x) => nan
sign(ln(y)) => nan
|sqrt(y)| => nan
floor(ln(y)) => nan
0*sqrt(y) + x => nan
x^(0*ln(y)) => nan
sqrt(y)^2 => nan
sqrt(y)*0 => nan
ln(y) - ln(y) => nan
ln(y)/ln(y) => nan
(1/(x-x)) + 1 => nan
x/(y-y) => nan
w = ln(y); x => x
f(u, v) = u; f(x, ln(y)) => x
sum(k = 1..3, sqrt(k*y)) => nan
sum(k = 1..0, ln(y)) + x => x
product(k in [1, 2], ln(k - 1) + x) => nan
# implicit multiplication
2x => 2*x
3(x+1) => 3*(x+1)
(x+1)(y-2) => (x+1)*(y-2)
x y => x*y
x y z => x*y*z
2 sin(x) => 2*sin(x)
x(y+1) => x*(y+1)
1/2x => (1/mpf(2))*x
x/y z => (x/y)*z
2x^2 => 2*x**2
2x y^2 => 2*x*y**2
xy => x*y
xyz => x*y*z
xyz^2 => x*y*z**2
xy^2 => x*y**2
1/xy => (1/x)*y
x²y(z+1) => x**2*y*(z+1)
xy(x+y) => x*y*(x+y)
a = 2; axy => 2*x*y
a = 2; b = 3; abx => 6*x
a = 2; a x => 2*x
a = 2; a(x+1) => 2*(x+1)
a = 2; 3a^2x => 12*x
xe => x*E
2(x)(y) => 2*x*y
(x)(y)^2 => x*y**2
-2x => -2*x
# functions without brackets
sin 2x => sin(2*x)
sin x y => sin(x*y)
sin x cos y => sin(x)*cos(y)
sin x * y => sin(x)*y
sin x/2 => sin(x)/2
sin -x => sin(-x)
sin x^2 => sin(x**2)
sin x(y+1) => sin(x*(y+1))
sin (x)(y+1) => sin(x)*(y+1)
sin(x)y => sin(x)*y
sin(x)^2 => sin(x)**2
sin^2(x) => sin(x)**2
sin^2 x => sin(x)**2
sin²x => sin(x)**2
sin^2 x + cos^2 x + z => 1+z
sin sqrt x => sin(sqrt(x))
sqrt 2x => sqrt(2*x)
√2x => sqrt(mpf(2))*x
√x² => abs(x)
√x => sqrt(x)
√(x)^2 => abs(x)
∛y => rt(3,y)
∛(x+y) => rt(3,x+y)
2sin x => 2*sin(x)
sin x + 1 => sin(x)+1
ln x y => nan
cos xy => cos(x*y)
exp -x => exp(-x)
# bars
|x| => abs(x)
|y|z => abs(y)*z
|x||y| => abs(x)*abs(y)
||x|-1| => abs(abs(x)-1)
|y+1|^2 => (y+1)**2
2|y| => 2*abs(y)
|x-|y|| => abs(x-abs(y))
x|y| => x*abs(y)
|-y| => abs(y)
# functions
sin(x) => sin(x)
cos(x) => cos(x)
tan(x) => tan(x)
asin(x) => asin(x)
asin(y) => nan
acos(x) => acos(x)
acos(y) => nan
atan(y) => atan(y)
atan2(y,x) => atan2(y,x)
[Q] atan2(y,x) => atan2(y,x)
[R] atan2(y,x) => nan
sinh(y) => sinh(y)
cosh(y) => cosh(y)
tanh(y) => tanh(y)
asinh(y) => asinh(y)
acosh(x) => nan
[Q] acosh(z) => acosh(z)
atanh(x) => atanh(x)
atanh(y) => nan
exp(y) => exp(y)
ln(x) => log(x)
ln(y) => nan
[R] ln(x) => nan
log10(x) => log(x)/log(mpf(10))
log2(x) => log(x)/log(mpf(2))
log(x) => log(x)/log(mpf(10))
log(2,x) => log(x)/log(mpf(2))
log(10,x) => log(x)/log(mpf(10))
log(e,x) => log(x)
log(3,x) => log(x)/log(mpf(3))
log(x,z) => log(z)/log(x)
log(1,x) => nan
log(y,x) => nan
sqrt(x) => sqrt(x)
sqrt(y) => nan
[R] sqrt(x) => 0
cbrt(y) => rt(3,y)
root(3,y) => rt(3,y)
root(5,y) => rt(5,y)
root(1,y) => y
root(2,x) => sqrt(x)
root(4,x) => sqrt(sqrt(x))
root(4,y) => nan
n = 7; root(n,y) => rt(7,y)
abs(y) => abs(y)
sign(y) => -1
sign(x) => 1
[R] sign(x) => 0
floor(y) => -2
ceil(y) => -1
ceil(x) => 1
round(y) => -1
round(2x) => 2
round(-2x) => -2
round(y*2) => -3
[Q] round(x) => -2
frac(y) => mpf('0.75')
frac(x) => mpf('0.75')
mod(y,1) => mpf('0.75')
mod(x,-1) => mpf('-0.25')
mod(y,z) => y-z*fl(y/z)
min(x,y) => y
min(x,y,z) => y
max(x,y,z) => x
max(x) => x
min(x,ln(y)) => nan
max(ln(y),100) => nan
clamp(x,0,0.5) => mpf('0.5')
clamp(y,0,1) => 0
clamp(z,0,1) => z
clamp(ln(y),0,1) => nan
clamp(x,0,ln(y)) => nan
hypot(x,y) => sqrt(x*x+y*y)
hypot(x,y,z) => sqrt(x*x+y*y+z*z)
hypot(y) => abs(y)
hypot(x,ln(y)) => nan
step(0,x) => 1
step(0,y) => 0
[R] step(0,x) => 1
step(x,x) => 1
smoothstep(0,1,x) => x*x*(3-2*x)
smoothstep(0,1,y) => 0
smoothstep(-2,0,y) => (lambda t: t*t*(3-2*t))((y+2)/2)
smoothstep(0,0.5,x) => 1
erf(y) => erf(y)
chebyshev(0,x) => 1
chebyshev(1,x) => x
chebyshev(2,x) => 2*x*x-1
chebyshev(3,x) => 4*x**3-3*x
chebyshev(5,y) => 16*y**5-20*y**3+5*y
chebyshev(6,x) => cos(6*acos(x))
chebyshev(11,x) => cos(11*acos(x))
chebyshev(24,x) => cos(24*acos(x))
chebyshev(0,ln(y)) => nan
legendre(0,x) => 1
legendre(1,x) => x
legendre(2,x) => (3*x*x-1)/2
legendre(3,y) => (5*y**3-3*y)/2
legendre(7,x) => mpmath.legendre(7,x)
legendre(0,ln(y)) => nan
# vectors and lists
|p - (1,0,0)| => sqrt((x-1)**2+y*y+z*z)
|p - (1,0,0)|^2 => (x-1)**2+y*y+z*z
|p|^4 => (x*x+y*y+z*z)**2
|p|^3 => sqrt(x*x+y*y+z*z)**3
length(p) => sqrt(x*x+y*y+z*z)
length((x,y)) => sqrt(x*x+y*y)
dot(p,(1,2,3)) => x+2*y+3*z
dot(p,p) => x*x+y*y+z*z
dot((x,y),(2,3)) => 2*x+3*y
cross(p,(0,0,1)).x => y
cross(p,(1,2,3)).y => z-3*x
cross((1,2,3),p).z => y-2*x
normalize(p).x => x/sqrt(x*x+y*y+z*z)
[R] normalize(p).x => nan
(2p).y => 2*y
(p*2).y => 2*y
(p/2).y => y/2
(-p).z => -z
(p+p).x => 2*x
(p-(1,1,1)).z => z-1
c = (1,2,3); |p-c| => sqrt((x-1)**2+(y-2)**2+(z-3)**2)
c = (1,2,3); dot(p-c,p+c) => x*x+y*y+z*z-14
c = (1,0,0); d = 2c + (0,1,0); dot(d,p) => 2*x+y
v = (x, y); v.x*v.y => x*y
if(x<0,p,2p).y => 2*y
# sums and products
sum(k = 1..4, x^k) => x+x**2+x**3+x**4
sum(k = 1..n, k)*x; n = 10 => 55*x
product(k = 1..3, x+k) => (x+1)*(x+2)*(x+3)
sum(k = 1..0, x) + x => x
product(k = 1..0, x)*y => y
sum(k = -2..2, k^2)*x => 10*x
sum(k = 0..2, sum(j = 0..k, x^j*y)) => y*(1+(1+x)+(1+x+x**2))
sum(c in [(0,0,0),(1,0,0)], exp(-4*|p-c|^2)) => exp(-4*(x*x+y*y+z*z))+exp(-4*((x-1)**2+y*y+z*z))
sum(c in [1,2,3], c*x) => 6*x
product(c in [1,2,3], c+x) => (1+x)*(2+x)*(3+x)
L = [1,2,5]; sum(c in L, x^c) => x+x**2+x**5
sum(c in [(1,0,0),(0,2,0)], c).y*x => 2*x
sum(k = 1..100, k)*x => 5050*x
sum(k = 1..40, x/k) => x*sum(mpf(1)/k for k in range(1,41))
sum(k = 1..3, (-1)^k*x^k) => -x+x**2-x**3
f(k) = sum(j = 1..k, j*x); f(3) => 6*x
k = 5; sum(k = 1..2, k)*x + k => 3*x+5
sum(k = 1..2, 2k x) => 6*x
sum(k = floor(1.5)..2*2, k*x) => 10*x
sum(c in [], c) + x => x
# definitions and functions
R = 1.5; x*R => x*mpf('1.5')
x*R; R = 1.5 => x*mpf('1.5')
w = x+1; w*w => (x+1)**2
a = b+1; b = c*2; c = x; a => 2*x+1
w = x+y; w^2 - w => (x+y)**2-(x+y)
bump(u, v) = exp(-(u^2+v^2)); bump(x, y) => exp(-(x*x+y*y))
f(u) = u^2 + x; f(y) => y*y+x
f(x) = x^2; f(y) + x => y*y+x
f(x,y) = x-y; f(y,x) => y-x
f(u) = g(u)+1; g(u) = 2u; f(x) => 2*x+1
f(u) = |u|; f(p) => sqrt(x*x+y*y+z*z)
f(v) = v.x; f(p) + f((2,3,4)) => x+2
f(u) = u^(1/3); f(y) => rt(3,y)
f(u) = a*u; a = 3; f(a*x) => 9*x
f(u) = 2u; f(f(f(x))) => 8*x
f(u) = u+1; 2f(x) => 2*(x+1)
f(u) = u+1; f(x)^2 => (x+1)**2
s(u) = sin(u); s(x) s(y) => sin(x)*sin(y)
d0 = x; d1 = d0+d0; d2 = d1+d1; d3 = d2+d2; d3 => 8*x
a = 0.5 in [0, 1]; a x => x/2
a = 0.5 in [0, 1] step 0.1; a + x => x+mpf('0.5')
t = pi/4 in [0, 2pi]; sin(t)*x => sin(pi/4)*x
f(x, y, z) = x*y - z => x*y-z
f(x, y) = x*y => z-x*y
f(x, y, z) = x*y - z; f(x, y, z) = 2 => x*y-z-2
f(u) = u^2; f(x) = y => x*x-y
h(x, y) = sin(x); k = 3 => z-sin(x)
# equations
x^2 + y^2 + z^2 = 1 => x*x+y*y+z*z-1
x^2 + y^2 == z => x*x+y*y-z
x^2+y^2+z^2-1 => x*x+y*y+z*z-1
z = sin(x)*cos(y) => z-sin(x)*cos(y)
x = 1 => x-1
y = x^2 => y-x**2
0 = x*y => -(x*y)
x(y+1) = 2 => x*(y+1)-2
x*y = 1/z => x*y-1/z
1 = x => 1-x
# regions: the function that is negative inside
x^2+y^2 <= 1 => x*x+y*y-1
x^2+y^2 < 1 => x*x+y*y-1
x >= y => y-x
x > 2 => 2-x
x ≤ 1 => x-1
x ≥ 1 => 1-x
0 <= x < 1 => max(0-x,x-1)
1 > x >= y > -5 => max(max(x-1,y-x),-5-y)
x < 1 and y < 1 => max(x-1,y-1)
x < 1 or y < 1 => min(x-1,y-1)
not x < 1 => -(x-1)
not (x < 1 and z > 0) => -max(x-1,-z)
x < 1 or y < 1 and z < 0 => min(x-1,max(y-1,z))
not x < 1 and y < 1 => max(1-x,y-1)
A = x <= 1; B = y <= 1; A and not B => max(x-1,1-y)
A = x^2 <= 1; A => x*x-1
union(x<1, y<1, z<1) => min(x-1,y-1,z-1)
intersection(x<1, y<1, z<1) => max(x-1,y-1,z-1)
difference(x<1, y<1, z<1) => max(x-1,1-y,1-z)
union(x-1, y-1) => min(x-1,y-1)
smooth_union(0.5, x, z) => (lambda a,b,k: min(a,b)-max(k-abs(a-b),0)**2/(4*k))(x,z,mpf('0.5'))
smooth_union(0.25, x<0, z<0, y<0) => (lambda s: s(s(x,z),y))(lambda a,b: min(a,b)-max(mpf('0.25')-abs(a-b),0)**2)
ln(y) < 1 or x < 5 => nan
x^2+y^2+z^2 <= 1 and z >= 0 => max(x*x+y*y+z*z-1,-z)
# if, and the truth on the boundary
if(x < 0, 1, 2)*y => 2*y
if(x > 0, 1, 2)*y => y
[R] 1 + x + if(x < 0, 1, 2) => 3
[R] 1 + x + if(x <= 0, 1, 2) => 2
[R] 1 + x + if(x > 0, 1, 2) => 3
[R] 1 + x + if(x >= 0, 1, 2) => 2
[R] 1 + x + if(not x < 0, 1, 2) => 2
[R] 1 + x + if(not x <= 0, 1, 2) => 3
[R] 1 + x + if(x < 0 or y <= 0, 1, 2) => 2
[R] 1 + x + if(x < 0 or y < 0, 1, 2) => 3
[R] 1 + x + if(x <= 0 and y < 0, 1, 2) => 3
[R] 1 + x + if(x <= 0 and y <= 0, 1, 2) => 2
[R] 1 + x + if(not (x <= 0 and y < 0), 1, 2) => 2
[R] 1 + x + if(not (x < 0 or y >= 0), 1, 2) => 3
[R] 1 + x + if(0 <= x < 1, 1, 2) => 2
[R] 1 + x + if(0 < x < 1, 1, 2) => 3
[R] 1 + x + if(-1 < x <= 0, 1, 2) => 2
[R] 1 + x + if(if(x <= 0, y < 0, y <= 0), 1, 2) => 3
[R] 1 + x + if(if(x < 0, y < 0, y <= 0), 1, 2) => 2
if(x > 0, ln(x), ln(-x)) => log(x)
[Q] if(x > 0, ln(x), ln(-x)) => log(-x)
if(x > 0, ln(y), 1) => nan
if(ln(y) < 0, x, y) => nan
if(x > 0, x < 1, y < 1) => x-1
if(2 > 1, x, y) => x
if(y < 0 and x > 0 or z > 5, x, z) => x
# no value
0*ln(y) + x => nan
0*ln(x) + x => x
y/(x-0.75) => nan
sqrt(-1)*x => nan
1/0 + x => nan
x/x => 1
[R] x/x => nan
[R] x - x/x => nan
[R] x*(1/x) => nan
[R] 0/x => nan
[R] ln(x)*z => nan
[R] x*y/(x*y) => nan
"""


def real_root(order, value):
    """The real root of odd order."""
    return -mpmath.root(-value, order) if value < 0 else mpmath.root(value, order)


NAMES = {
    "mpf": mpf, "mpmath": mpmath, "nan": mp.nan, "E": mp.e, "pi": mp.pi, "fl": mpmath.floor, "rt": real_root,
    **{name: getattr(mpmath, name) for name in (
        "sqrt sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp log erf").split()},
}


def written(value):
    value = mpf(value)
    return "nan" if mpmath.isnan(value) else mpmath.nstr(value, 20)


def main():
    print("# program\tx y z\tvalue of the first surface's function; written by tests/tools/language_values.py")
    for row in ROWS.strip().splitlines():
        if row.startswith("#"):
            print(row)
            continue
        program, meaning = row.rsplit(" => ", 1)
        point = "P"
        if program.startswith("["):
            point, program = program[1], program[4:]
        # A coordinate is the f64 nearest to what is written.
        x, y, z = (mpf(float(c)) for c in POINTS[point])
        value = eval(meaning, {**NAMES, "x": x, "y": y, "z": z})
        print(program, " ".join(POINTS[point]), written(value), sep="\t")


if __name__ == "__main__":
    main()
