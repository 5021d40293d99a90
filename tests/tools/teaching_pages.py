#!/usr/bin/env python3
"""Compiles the program's LaTeX with a real TeX and opens its HTML in a real browser.

Usage: teaching_pages.py PROGRAM FOLDER [--screenshots]

PROGRAM is the built program; pages and screenshots are left in FOLDER. Needs pdflatex (Debian: texlive-latex-base) and chromium.
Prints one line a page; exit status 1 if a document does not compile or a page says anything on the console.
"""

import pathlib
import subprocess
import sys

FORMULAS = [
    "x^2+y^2+z^2=1",
    "(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)=0",
    "z = sin x cos y",
    "(x^2+9/4*y^2+z^2-1)^3 = x^2*z^3+9/80*y^2*z^3",
    "x/(1+y^2) - z/(x^2+1) = 0",
    "|x|+|y|+|z| = 1",
    "min(x, y) + max(y, z) = if(x <= 0, floor(x), cbrt(y))",
    "2^x + x^(y/2) = log2(z^2+1) - log10(x^2+2) + ln(y^2+3)",
    "asin(x/3) + acos(y/3) - atan(z) + sinh x cosh y - tanh z = 0",
    "asinh x + acosh(y+4) - atanh(z/3) + erf x = 0",
    "a = 0.5 in [0, 1]; f(u) = u^2 - a; f(x) + f(y) = f(z)",
    "x^2+y^2 <= 1 and not z >= 0",
]

RAYS = [
    ["(x^2+y^2+z^2-1)^2", "--from", "0,0,3", "--direction", "0,0,-1", "--step", "0.13"],
    ["z=tan(x)", "--from", "-2.5,0,0", "--direction", "1,0,0", "--step", "0.11", "--ball", "0,0,0,3"],
]


def run(command, **more):
    return subprocess.run(command, capture_output=True, text=True, timeout=300, **more)


def typeset(folder, name):
    done = run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", name + ".tex"], cwd=folder)
    wide = done.stdout.count("Overfull \\hbox")
    print(f"{name}.tex: {'compiled' if done.returncode == 0 else 'FAILED'}, {wide} lines too wide")
    if done.returncode != 0:
        print("\n".join(line for line in done.stdout.splitlines() if line.startswith(("!", "l."))))
    return done.returncode == 0


def browse(folder, page, screenshots):
    command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", "--v=0"]
    command += ["--user-data-dir=" + str(folder / "profile"), "--window-size=1000,2600", "--virtual-time-budget=3000"]
    command += ["--screenshot=" + str(page.with_suffix(".png"))] if screenshots else ["--dump-dom"]
    done = run([*command, page.resolve().as_uri()])
    said = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    is_shown = done.returncode == 0 and (screenshots or "</html>" in done.stdout)
    print(f"{page.name}: {'opened' if is_shown else 'FAILED'}, {len(said)} messages on the console")
    print("".join(line + "\n" for line in said), end="")
    return is_shown and not said


def main():
    program, folder = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    screenshots = "--screenshots" in sys.argv
    folder.mkdir(parents=True, exist_ok=True)
    commands = [["explain", formula] for formula in FORMULAS] + [["ray", *ray] for ray in RAYS]
    fine, pages = True, []
    for number, command in enumerate(commands, 1):
        for language in ["en", "sl"]:
            name = f"{command[0]}-{number:02}-{language}"
            for form, ending in [("--latex", ".tex"), ("--html", ".html")]:
                path = folder / (name + ending)
                said = run([program, *command, "--quiet", "--language", language, form, "-o", str(path)])
                if said.returncode != 0:
                    print(said.stderr)
                    fine = False
            fine &= typeset(folder, name)
            pages.append(folder / (name + ".html"))
    for language in ["en", "sl"]:
        lessons = folder / ("lessons-" + language)
        fine &= run([program, "lesson", "--html", str(lessons), "--language", language]).returncode == 0
        pages += sorted(lessons.glob("*.html"))
    for page in pages:
        fine &= browse(folder, page, screenshots)
    print("all fine" if fine else "NOT all fine")
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
