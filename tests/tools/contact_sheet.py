#!/usr/bin/env python3
"""Draws all scenes of tests/data/scenes.toml with the program and joins the pictures to one sheet.

usage: contact_sheet.py PROGRAM SHEET.png [TILE]     needs pillow; PROGRAM is the built `implicit`
Prints, for each scene, the processor seconds, what was proven and how long the trace took.
"""
import json, os, subprocess, sys, tempfile, tomllib
from PIL import Image

program, sheet, tile = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 240
here = os.path.dirname(os.path.abspath(__file__))
scenes = tomllib.load(open(os.path.join(here, "../data/scenes.toml"), "rb"))["scene"]
columns = 6
rows = -(-len(scenes) // columns)
page = Image.new("RGB", (columns * tile, rows * tile))
with tempfile.TemporaryDirectory() as folder:
    for k, scene in enumerate(scenes):
        clip = scene["clip"]
        if "ball" in clip:
            region = ["--ball", f"0,0,0,{clip['ball']}"]
        else:
            h = clip["box"]
            region = ["--box", f"{-h},{h},{-h},{h},{-h},{h}"]
        picture, stats = os.path.join(folder, "a.png"), os.path.join(folder, "a.json")
        eye = ",".join(map(str, scene["eye"]))
        command = [program, "-o", picture, "-s", f"{tile}x{tile}", "--eye", eye, "--look-at", "0,0,0", *region]
        command += ["--quiet", "--stats-json", stats, "--", scene["formula"]]
        subprocess.run(command, check=True, timeout=600)
        s = json.load(open(stats))
        print(f"{scene['name']:14} cpu {s['cpu_seconds']['total']:.3f} s, trace {s['cpu_seconds']['trace']:.3f} s, "
              f"proven {s['proven']}/{s['pixels']}, touch {s['touch']}, undecided {s['undecided']}", flush=True)
        page.paste(Image.open(picture).convert("RGB"), (k % columns * tile, k // columns * tile))
page.save(sheet, optimize=True)
