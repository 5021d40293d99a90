//! The command line as scripts depend on it: exit statuses, messages, files.
//!
//! In: tables of commands. Out: what must hold of each. Pictures themselves are judged elsewhere.

use super::command::{Folder, PROGRAM, said};
use std::process::{Command, Stdio};

/// A sphere, small, in the least time.
const SMALL: [&str; 5] = ["-s", "16x12", "--samples", "1", "x^2+y^2+z^2=1"];

fn words(line: &str) -> Vec<&str> {
    line.split('|').collect()
}

/// Arguments with `|` between them, the exit status, and what standard error must say.
const ROWS: &[(&str, i32, &str)] = &[
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6", 0, "note: no region was given"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--quiet", 0, ""),
    ("x^2+y^2=1|z=0|-o|a.png|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.PNG|-s|8x6|--threads|0", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--threads|99999999999999999999999", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.exr|-s|8x6|--depth|d.exr|--normals|n.exr|--stats-json|s.json|--stats", 0, "proven"),
    ("x^2+y^2+z^2=a^2|a=1 in [0,2]|--set|a=0.5|-o|a.png|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--box|-1,1,-1,1,-1,1|--eye|-3,-3,1|--look-at|0,0,0", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--ball|-0.5,0,0,1|--orbit|-30,20", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--method|march|--step|0.01", 0, ""),
    ("--|-x^2-y^2=z", 2, "nowhere to draw"),
    ("-o|a.png|-s|8x6|--|-x^2-y^2=z", 0, ""),
    ("x^2+y^2+z^2=1", 2, "add -o picture.png"),
    ("-x^2-y^2=z|-o|a.png", 2, "implicit -o a.png -- '-x^2-y^2=z'"),
    ("x^2+y^2+z^2=1|-o|a.jpg|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.JPEG|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.webp|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.tiff|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.Tif|-s|8x6", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.gif", 2, "'a.gif' must end in .png, .jpg, .webp, .tiff or .exr"),
    ("x^2+y^2+z^2=1|-o|picture", 2, "must end in .png"),
    ("x^2+y^2+z^2=1|-o|", 2, "a value is required"),
    ("x^2+y^2+z^2=1|-o|.", 2, "must end in .png"),
    ("x^2+y^2+z^2=1|-o|a.webp|-s|16385x1", 2, "at most 16384 pixels a side"),
    ("x^2+y^2+z^2=1|-o|a.jpg|-s|65536x1", 2, "at most 65535 pixels a side"),
    ("x^2+y^2+z^2=1|-o|a.png|--mode|nice", 2, "no mode 'nice'"),
    ("x^2+y^2+z^2=1|-o|a.png|--tonemap|filmic", 2, "there is no tone curve 'filmic'; there are neutral, agx, none"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--background|rgb(0.2, 0.5, 1)", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--background|hsv(120, 1/2, 1)", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|--background|rgb(2, 0, 0)", 2, "lies between 0 and 1"),
    ("x^2+y^2+z^2=1|-o|a.png|--background|red } render { size: 1x1", 2, "write a name, #rrggbb, rgb(1, 0.5, 0)"),
    ("x^2+y^2+z^2=1|-o|a.png|--background|blu", 2, "there is no colour `blu`; did you mean `blue`?"),
    ("x^2+y^2+z^2=1|-o|a.png|--background|red, mode: path", 2, "write a name, #rrggbb, rgb(1, 0.5, 0), transparent"),
    ("x^2+y^2+z^2=1|-o|a.png|--filter|box", 2, "mode studio makes no use of --filter; `path`, `light`"),
    ("x^2+y^2+z^2=1; render { filter: box }|-o|a.png|-s|8x6", 0, "makes no use of `filter`"),
    ("x^2+y^2+z^2=1; render { filter: box }|-o|a.png|--strict", 1, "makes no use of `filter`"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--filter|box|--mode|light|--samples|1", 0, ""),
    ("x^2+y^2+z^2=1|-o|a.png|--filter|sinc", 2, "there is no filter 'sinc'; there are box, gaussian, mitchell"),
    ("x^2+y^2+z^2=1|-o|a.png|--exposure|1000", 2, "a number of stops from -100 to 100"),
    ("x^2+y^2+z^2=1|-o|a.png|--background|rde", 2, "there is no colour `rde`; did you mean `red`?"),
    ("x^2+y^2+z^2=1|-o|a.jpg|--background|transparent", 2, "a jpg has no clear pixels"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--mode|depth|--background|red", 0, "makes no use of `background`"),
    ("x^2+y^2+z^2=1; render { tonemap: filmic }|-o|a.png", 1, "there is no tone curve 'filmic'"),
    ("x^2+y^2+z^2=1; render { filter: sinc }|-o|a.png", 1, "there is no filter 'sinc'"),
    ("x^2+y^2+z^2=1|-o|a.png|--step|0.1", 2, "--method march"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--progressive|--time-budget|9", 0, ""),
    ("x^2+y^2+z^2=1|-o|-|--progressive", 2, "'-' is none"),
    ("x^2+y^2+z^2=1|--depth|d.exr|--progressive", 2, "add -o picture.png"),
    ("x^2+y^2+z^2=1|-o|a.png|--time-budget|0", 2, "more than 0"),
    ("x^2+y^2+z^2=1|-o|a.png|--time-budget|soon", 2, "'soon' is no number"),
    ("x^2+y^2+z^2=1|-o|a.png|--size|8193x8192", 2, "2^26"),
    ("x^2+y^2+z^2=1|-o|a.png|--size|0x5", 2, "at least one pixel"),
    ("x^2+y^2+z^2=1|-o|a.png|--fov|180", 2, "less than 180"),
    ("x^2+y^2+z^2=1|-o|a.png|--box|1,0,0,1,0,1", 2, "in x the lower end"),
    ("x^2+y^2+z^2=1|-o|a.png|--ball|0,0,0,-1", 2, "radius"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1,2", 2, "3 numbers with commas between them are needed, as in 1,2,3; here are 2"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1|-2|3", 2, "  implicit 'x^2+y^2+z^2=1' -o a.png --eye 1,-2,3\n"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1|2", 2, "'--eye <X,Y,Z>': 3 numbers with commas between them"),
    ("eval|x|--at|(1, 2, 3)", 2, "  implicit eval x --at 1,2,3"),
    ("eval|x|--at|1 2", 2, "here are 2"),
    ("x^2+y^2+z^2=1|-o|a.png|--threads|-3", 2, "'-3' is no whole number"),
    ("x^2+y^2+z^2=1|-o|a.png|--bounces|x", 2, "a whole number from 0"),
    ("x^2+y^2+z^2=1|-o|a.png|--samples|0", 2, "a whole number from 1 to 65536"),
    ("x^2+y^2+z^2=1|-o|a.png|--seed|-1", 2, "a whole number from 0"),
    ("x^2+y^2+z^2=1|-o|a.png|--fov|-5", 2, "more than 0"),
    ("x^2+y^2+z^2=1|-o|a.png|--size|-8x6", 2, "'-8x6' is no size"),
    ("x^2+y^2+z^2=1|-o|a.png|--set|-a=1", 2, "'-a' is no name"),
    ("x^2+y^2+z^2=1|-o|a.png|--ball|0,0,0,1e200|--eye|1,2,3", 2, "the region is too large"),
    ("x^2+y^2+z^2=1|-o|a.png|--box|-1e308,1e308,-1,1,-1,1", 2, "the region is too large"),
    ("x^2+y^2+z^2=1 { clip: ball(0,0,0,2) }; render { clip: box(-1e308..1e308, 0..1, 0..1) }|-o|a.png", 1, ":1:"),
    ("chek|x=1|-o|a.png", 1, "if a command was meant: implicit check"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1 2 3", 2, "  implicit 'x^2+y^2+z^2=1' -o a.png --eye 1,2,3\n"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye=(1, -2, 3)", 2, "  implicit 'x^2+y^2+z^2=1' -o a.png --eye=1,-2,3\n"),
    ("x^2+y^2+z^2=1|--orbit|30 20|-o|a.png", 2, "  implicit 'x^2+y^2+z^2=1' --orbit 30,20 -o a.png\n"),
    ("x^2+y^2+z^2=1|-o|a.png|--box|-1 1 -1 1 -1 1", 2, "--box -1,1,-1,1,-1,1\n"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|nan,0,0", 2, "'nan' is not finite"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1e999,0,0", 2, "'1e999' is not finite"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1e308,0,0|--look-at|-1e308,0,0", 2, "too far"),
    ("x^2+y^2+z^2=1|-o|a.png|--orbit|0,0,1.7e308|--look-at|1e308,0,0", 2, "too far"),
    ("x^2+y^2+z^2=1|-o|a.png|--fov|1e-320", 2, "too far"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1e-200,0,0|--look-at|0,0,0", 2, "nearer to it than can be told"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|0,0,0|--look-at|0,0,0", 2, "the eye is at the point"),
    ("x^2+y^2+z^2=1|-o|a.png|--eye|1,2,3|--orbit|1,2", 2, "--orbit"),
    ("x^2+y^2+z^2=1|-o|a.exr|--depth|a.exr", 2, "asked for twice"),
    ("x^2+y^2+z^2=1|-o|a.exr|--depth|./a.exr", 2, "asked for twice"),
    ("x^2+y^2+z^2=1|-o|-|--stats-json|-", 2, "asked for twice"),
    ("x^2+y^2+z^2=1|--depth|-", 2, "must end in .exr"),
    ("x^2+y^2+z^2=1|-o|a.png|-o|b.png", 2, "cannot be used multiple times"),
    ("x^2+y^2+z^2=1|-o", 2, "a value is required"),
    ("x^2+y^2+z^2=1|--depth|a.png", 2, "must end in .exr"),
    ("x^2+y^2+z^2=1|-o|a.png|--no-such-option", 2, "--no-such-option"),
    ("x^2+y^2+z^2=1|-o|a.png|--colour|red", 2, "implicit 'x^2 + y^2 + z^2 = 1 { color: red }'"),
    ("x^2+y^2+z^2=1|-o|a.png|--siz|8x6", 2, "exists: '--size'"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--box|5,6,5,6,5,6", 0, "empty, no pixel's ray meets a surface; without --box the"),
    ("x^2+y^2+z^2=1|-o|a.png|-s|8x6|--eye|0,0,5|--look-at|0,0,9", 0, "without --eye and --look-at the program finds"),
    ("x^2+y^2+z^2=1|-o|missing/a.png", 1, "cannot write 'missing/a.png'"),
    ("x^2+y^2+z^2+1=0|-o|a.png", 1, "there is nothing to see: f > 0 everywhere"),
    ("sqrt(-1-x^2)=y|-o|a.png", 1, "there is nothing to see: f has no value"),
    ("x^2+(y|-o|a.png", 1, "--> <argument 1>:1:"),
    ("x^2=1|y=)|-o|a.png", 1, "--> <argument 2>:1:"),
    ("missing.imp|-o|a.png", 1, "cannot read 'missing.imp'"),
    ("1/2x=y|-o|a.png|-s|8x6|--strict", 1, "error"),
    ("x^2+y^2+z^2=1|-o|a.png|--set|b=1", 1, "b"),
    ("5|-o|a.png", 1, "error"),
    ("gallery|x", 2, "not built yet"),
    ("lesson", 0, ""),
    ("lesson|99", 2, "from 1 to 12"),
    ("lesson|1|--language|xx", 2, "there are texts in en, sl"),
    ("explain|x^2+(y", 1, "--> <argument 1>:1:"),
    ("explain|x^2+y^2=1|-o|missing/a.html|--html", 1, "cannot write 'missing/a.html'"),
    ("explain|x^2+y^2=1|--latex|--html", 2, "cannot be used with"),
    ("explain|R = 2|x=R|--of|S", 1, "defines no 'S'"),
    ("ray|x^2+y^2+z^2=1", 2, "--pixel"),
    ("ray|x^2+y^2+z^2=1|--from|0,0,3", 2, "--direction"),
    ("ray|x^2+y^2+z^2=1|--from|0,0,3|--direction|0,0,0", 2, "must have a length"),
    ("ray|x^2+y^2+z^2=1|--from|9,9,9|--direction|0,0,1", 1, "does not meet the region"),
    ("ray|x^2+y^2+z^2=1|--pixel|800,0", 2, "outside a picture of 800x600"),
    ("ray|x^2+y^2+z^2=1|--pixel|a", 2, "two whole numbers"),
    ("ray|x^2+y^2+z^2=1|--from|0,0,3|--direction|0,0,-1|--step|1e-9", 2, "more than 100000 samples"),
    ("ray|5|--from|0,0,3|--direction|0,0,-1", 1, "error"),
    ("compare|x^2+y^2+z^2=1|--vary|objects", 2, "several surfaces"),
    ("compare|x^2+y^2+z^2=1|--step|0", 2, "more than 0"),
    ("compare|x^2+y^2+z^2=1|-s|8x6|--step|0.5|-o|missing/a.png", 1, "cannot write"),
    ("--quiet|check|x=1|-o|a.png", 1, "check"),
    ("-o|a.png|--|eval", 1, "eval"),
    ("import", 2, "PICTURE.png"),
    ("import|missing.png", 1, "cannot import 'missing.png'"),
    ("completions|tcsh", 2, "there are bash, zsh, fish, elvish, powershell and man"),
    ("check|x^2+y^2=1", 0, ""),
    ("check|x^2+(y", 1, "--> <argument 1>:1:"),
    ("check|R = 2|x^2+y^2=R|--of|R", 0, ""),
    ("check|R = 2|x^2+y^2=R|--of|S", 1, "defines no 'S'"),
    ("check", 2, "PROGRAM"),
    ("eval|x", 2, "--at"),
    ("eval|x|--at|1,2", 2, "3 numbers"),
    ("eval|x|--at|inf,0,0", 2, "finite"),
    ("eval|x|--over|1,0,0,1,0,1", 2, "in x"),
    ("eval|-x|--at|1,2,3", 2, "implicit eval --at 1,2,3 -- -x"),
    ("--help", 0, ""),
    ("--version", 0, ""),
    ("", 2, "nowhere to draw"),
    ("|-o|a.png", 1, ""),
];

#[test]
fn commands_end_with_their_status_and_words_and_leave_no_file_behind_when_they_fail() {
    let folder = Folder::new();
    for &(line, status, message) in ROWS {
        let said = folder.run(&words(line));
        assert_eq!(said.status, status, "{line}: {}", said.err);
        assert!(said.err.contains(message), "{line}: {message} is not in {}", said.err);
        if status != 0 {
            assert_eq!(folder.names(), Vec::<String>::new(), "{line}");
        }
        for name in folder.names() {
            std::fs::remove_file(folder.path.join(name)).unwrap();
        }
    }
}

#[test]
fn shells_and_man_get_what_they_read() {
    let folder = Folder::new();
    let rows = [
        ("bash", "_implicit()"),
        ("zsh", "#compdef implicit"),
        ("fish", "complete -c implicit"),
        ("elvish", "set edit:completion:arg-completer[implicit]"),
        ("powershell", "Register-ArgumentCompleter"),
        ("man", ".TH implicit 1"),
    ];
    for (script, start) in rows {
        let said = folder.run(&["completions", script]);
        let text = String::from_utf8(said.out).unwrap();
        assert_eq!((said.status, said.err.as_str()), (0, ""));
        assert!(
            text.contains(start) && ["time", "studio", "eval", "completions"].iter().all(|word| text.contains(word))
        );
    }
}

#[test]
fn quiet_commands_say_nothing() {
    let folder = Folder::new();
    let said = folder.run(&words("1/2x=y|-o|a.png|-s|8x6|--quiet|--ball|0,0,0,2|--eye|9,9,9|--look-at|99,9,9"));
    assert_eq!((said.status, said.err.as_str()), (0, ""));
}

#[test]
fn alone_it_greets_with_three_commands() {
    let said = Folder::new().run::<&str>(&[]);
    let text = String::from_utf8(said.out).unwrap();
    assert_eq!((said.status, text.matches("  implicit ").count()), (0, 3));
}

#[test]
fn failures_leave_an_older_picture_as_it_was() {
    let folder = Folder::new();
    folder.write("a.png", "older");
    for line in
        ["x^2+(|-o|a.png", "x^2+y^2+z^2+1=0|-o|a.png", "x=1|-o|a.png|--depth|missing/d.exr", "x=1|-o|a.png|-s|0x1"]
    {
        assert_ne!(folder.run(&words(line)).status, 0, "{line}");
        assert_eq!(folder.read("a.png"), b"older", "{line}");
        assert_eq!(folder.names(), ["a.png"]);
    }
}

#[test]
fn programs_come_from_arguments_files_and_standard_input() {
    let folder = Folder::new();
    folder.write("Sphere.IMP", "x^2 + y^2 + z^2 = 1 // a sphere\n");
    folder.write("parts/ring.imp", "include \"radius.imp\"\n(x^2+y^2+z^2+R^2-0.1)^2 = 4*R^2*(x^2+y^2)");
    folder.write("parts/radius.imp", "R = 1");
    let evaluate = |args: &[&str], input: &str| {
        let args = [&["eval", "--json", "--at", "1,0,0"], args].concat();
        let said = folder.run_with(&args, input, &[]);
        (said.status, String::from_utf8(said.out).unwrap().lines().count(), said.err)
    };
    assert_eq!(evaluate(&["Sphere.IMP"], ""), (0, 1, String::new()));
    assert_eq!(evaluate(&["-"], "x=1; y=2; z=3"), (0, 3, String::new()));
    assert_eq!(evaluate(&["parts/ring.imp", "x=1"], ""), (0, 2, String::new()));
    folder.write("parts/outside.imp", "include \"../Sphere.IMP\"");
    let (status, _, err) = evaluate(&["parts/outside.imp"], "");
    assert!(status == 1 && err.contains("outside the folder") && err.contains("outside.imp:1:9"), "{err}");
    folder.write("parts/circle.imp", "include \"circle.imp\"\nx=1");
    let (status, _, err) = evaluate(&["parts/circle.imp"], "");
    assert!(status == 1 && err.contains("includes itself"), "{err}");
    folder.write("note.txt", "x=1");
    let (status, _, err) = evaluate(&["note.txt"], "");
    assert!(status == 1 && err.contains("'note.txt' is a file"), "{err}");
    folder.write("bytes.imp", [0xff, 0xfe]);
    let (status, _, err) = evaluate(&["bytes.imp"], "");
    assert!(status == 1 && err.contains("UTF-8"), "{err}");
}

#[test]
fn values_and_enclosures_are_printed_as_agreed() {
    let folder = Folder::new();
    let rows: &[(&[&str], &str, &str)] = &[
        (&["x^2+y^2+z^2=1", "--at", "1,1,1"], "", "f = 2  gradient = (2, 2, 2)\n"),
        (&["x^2+y^2+z^2=1", "--at", "1,1,1", "--json"], "", "{\"value\":2.0,\"gradient\":[2.0,2.0,2.0]}\n"),
        (&["ln(x)=0", "--at", "-1,0,0", "--json"], "", "{\"value\":\"nan\",\"gradient\":[\"nan\",\"nan\",\"nan\"]}\n"),
        (&["5", "--at", "0,0,0"], "", "f = 5  gradient = (0, 0, 0)\n"),
        (&["R = 2", "w = R*x", "x=1", "--of", "w", "--at", "3,0,0"], "", "f = 6  gradient = (2, 0, 0)\n"),
        (&["x=y", "--at", "-"], "1,2,3\n\n4 5 6\n", "f = -1  gradient = (1, -1, 0)\nf = -1  gradient = (1, -1, 0)\n"),
        (
            &["y=0", "--over", "0,1,2,3,-inf,inf", "--json"],
            "",
            "{\"lo\":2.0,\"hi\":3.0,\"defined\":\"everywhere\",\"continuous\":true}\n",
        ),
        (
            &["ln(x)", "--over", "-2,-1,0,1,0,1", "--json"],
            "",
            "{\"lo\":null,\"hi\":null,\"defined\":\"nowhere\",\"continuous\":false}\n",
        ),
    ];
    for (args, input, expected) in rows {
        let said = folder.run_with(&[&["eval"], *args].concat(), input, &[]);
        assert_eq!(
            (said.status, String::from_utf8(said.out).unwrap().as_str()),
            (0, *expected),
            "{args:?} {}",
            said.err
        );
    }
    let said = folder.run_with(&["eval", "x", "--at", "-"], "1,2,3\n4,5\n", &[]);
    assert!(said.status == 1 && said.err.contains("<stdin>:2"), "{}", said.err);
}

#[test]
fn statistics_add_up() {
    let folder = Folder::new();
    let args = [&SMALL[..], &["--stats-json", "s.json", "--mode", "normal", "--threads", "3"]].concat();
    assert_eq!(folder.run(&args).status, 0);
    let stats: serde_json::Value = serde_json::from_slice(&folder.read("s.json")).unwrap();
    let count = |key: &str| stats[key].as_u64().unwrap_or_else(|| panic!("{key}"));
    assert_eq!(count("pixels"), 16 * 12);
    assert_eq!(count("hits") + count("misses") + count("touch") + count("undecided"), count("pixels"));
    assert_eq!((count("proven"), count("rays"), count("threads")), (16 * 12, 16 * 12, 3));
    assert!(["points", "gradients", "cells"].iter().all(|key| stats["evaluations"][key].is_u64()));
    for times in ["seconds", "cpu_seconds"] {
        let seconds = |stage: &str| stats[times][stage].as_f64().unwrap();
        let sum: f64 = ["parse", "compile", "trace", "shade", "encode"].iter().map(|stage| seconds(stage)).sum();
        assert!(seconds("total") > 0.0 && (sum - seconds("total")).abs() < 1e-12);
    }
    assert!(stats["version"].is_string() && stats["region"].is_array());
    let marched = [&SMALL[..], &["--stats-json", "m.json", "--method", "march"]].concat();
    assert_eq!(folder.run(&marched).status, 0);
    let stats: serde_json::Value = serde_json::from_slice(&folder.read("m.json")).unwrap();
    assert_eq!(stats["proven"], 0);
}

#[test]
fn standard_output_takes_a_picture_and_may_be_full_or_closed() {
    let folder = Folder::new();
    let said_ok = folder.run(&[&SMALL[..], &["-o", "-", "--quiet"]].concat());
    assert!(said_ok.status == 0 && said_ok.out.starts_with(b"\x89PNG"));
    if cfg!(target_os = "linux") {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = Command::new(PROGRAM).args(SMALL).args(["-o", "-"]).stdout(full).output().unwrap();
        let said_full = said(output);
        assert!(said_full.status == 1 && said_full.err.contains("standard output"), "{}", said_full.err);
        let said_full = folder.run(&[&SMALL[..], &["-o", "/dev/full"]].concat());
        assert!(said_full.status == 1 && said_full.err.contains("no space left"), "{}", said_full.err);
        for args in [&["--help"][..], &["completions", "man"], &["eval", "x", "--at", "1,2,3"]] {
            let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
            assert_eq!(
                Command::new(PROGRAM).args(args).stdout(full).output().unwrap().status.code(),
                Some(1),
                "{args:?}"
            );
        }
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let status = Command::new(PROGRAM).args(["x=("]).args(["-o", "a.png"]).stderr(full).status().unwrap();
        assert_eq!(status.code(), Some(1));
    }
    let mut child = Command::new(PROGRAM)
        .args(SMALL)
        .args(["-o", "-"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(said(child.wait_with_output().unwrap()).status, 1);
    // Who reads text and has had enough is content.
    let mut child = Command::new(PROGRAM).arg("--help").stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_permissions_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new();
    folder.write("real.png", "older");
    std::fs::set_permissions(folder.path.join("real.png"), std::fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real.png", folder.path.join("link.png")).unwrap();
    assert_eq!(folder.run(&[&SMALL[..], &["-o", "link.png"]].concat()).status, 0);
    assert!(folder.read("real.png").starts_with(b"\x89PNG"));
    assert!(std::fs::symlink_metadata(folder.path.join("link.png")).unwrap().is_symlink());
    assert_eq!(std::fs::metadata(folder.path.join("real.png")).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(folder.run(&[&SMALL[..], &["-o", "/dev/null"]].concat()).status, 0);
}

#[cfg(unix)]
#[test]
fn arguments_that_are_no_text_are_refused() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let bytes = OsStr::from_bytes(b"x=\xff");
    let folder = Folder::new();
    let rows: [(&[&OsStr], i32); 3] = [
        (&[bytes, OsStr::new("-o"), OsStr::new("a.png")], 1),
        (&[OsStr::new("x=1"), OsStr::new("-o"), OsStr::new("a.png"), OsStr::new("--size"), bytes], 2),
        (&[OsStr::new("eval"), bytes, OsStr::new("--at"), OsStr::new("1,2,3")], 1),
    ];
    for (args, status) in rows {
        assert_eq!(folder.run(args).status, status);
    }
    let picture = OsStr::from_bytes(b"\xff.png");
    let args: Vec<&OsStr> = SMALL.iter().map(OsStr::new).chain([OsStr::new("-o"), picture]).collect();
    assert_eq!(folder.run(&args).status, 0);
    assert_eq!(folder.run(&[OsStr::new("import"), picture]).status, 0);
    let said = folder.run(&[OsStr::new("import"), OsStr::from_bytes(b"\xfe.png")]);
    assert!(said.status == 1 && said.err.contains("no such file"), "{}", said.err);
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_run_leaves_the_disk_as_it_was() {
    let folder = Folder::new();
    folder.write("a.png", "older");
    for (signal, status) in [("-INT", 130), ("-TERM", 143)] {
        let formula = "x^2+y^2+z^2=1";
        let mut child = Command::new(PROGRAM)
            .args([formula, "-s", "8000x8000", "--threads", "1", "-o", "a.png"])
            .current_dir(&folder.path)
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(150));
        Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(status));
        assert_eq!((folder.read("a.png"), folder.names()), (b"older".to_vec(), vec!["a.png".to_owned()]));
    }
}
