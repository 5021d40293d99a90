//! Pictures that are drawn in passes.
//!
//! In: commands with `--progressive`, `--time-budget`, and signals. Out: which picture is there, at every time a whole
//! one.

use super::command::{Folder, PROGRAM};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A surface that takes a while at the size below, on any machine.
const LONG: [&str; 5] = ["sin(9x)*cos(9y)+sin(9y)*cos(9z)+sin(9z)*cos(9x)=0", "-s", "4000x4000", "--threads", "1"];

const SMALL: [&str; 5] = ["x^2+y^2+z^2=1", "-s", "60x40", "-o", "a.png"];

/// The width of a PNG file that can be decoded to its end.
fn width(bytes: &[u8]) -> u32 {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let width = reader.next_frame(&mut pixels).unwrap().width;
    reader.finish().unwrap();
    width
}

#[test]
fn passes_end_in_the_same_file() {
    let folder = Folder::new();
    assert_eq!(folder.run(&SMALL).status, 0);
    let plain = folder.read("a.png");
    for more in [&["--progressive"][..], &["--time-budget", "1e9"], &["--progressive", "--stats-json", "s.json"]] {
        std::fs::remove_file(folder.path.join("a.png")).unwrap();
        let said = folder.run(&[&SMALL, more].concat());
        assert!(said.status == 0 && !said.err.contains("the time was up"), "{more:?}: {}", said.err);
        assert!(folder.read("a.png") == plain, "{more:?}");
    }
}

#[test]
fn when_the_time_is_up_the_last_whole_pass_is_written() {
    let folder = Folder::new();
    let said = folder.run(&[&SMALL[..], &["--time-budget", "1e-9"]].concat());
    assert!(said.status == 0 && said.err.contains("one ray for each square of 16x16 pixels"), "{}", said.err);
    assert_eq!(width(&folder.read("a.png")), 60);
    let said =
        folder.run(&[&SMALL[..], &["--time-budget", "1e-9", "--stats-json", "s.json", "--depth", "d.exr"]].concat());
    assert!(said.status == 0 && said.err.contains("one ray a pixel"), "{}", said.err);
    let stats: serde_json::Value = serde_json::from_slice(&folder.read("s.json")).unwrap();
    assert_eq!(stats["hits"].as_u64().unwrap() + stats["misses"].as_u64().unwrap(), 60 * 40);
    assert_eq!(folder.run(&[&SMALL[..], &["--depth", "e.exr"]].concat()).status, 0);
    assert!(folder.read("d.exr") == folder.read("e.exr"));
    let said = folder.run(&[&SMALL[..], &["--time-budget", "1e-9", "--quiet"]].concat());
    assert_eq!((said.status, said.err.as_str()), (0, ""));
}

/// The modes that follow light, in which every sample is a pass's own.
const TRANSPORT: [&str; 3] = ["path", "light", "bidirectional"];

#[test]
fn passes_of_light_end_in_the_same_file() {
    for mode in TRANSPORT {
        let folder = Folder::new();
        let command = [&SMALL[..], &["--mode", mode, "--samples", "7"]].concat();
        assert_eq!(folder.run(&command).status, 0);
        let plain = folder.read("a.png");
        for more in [&["--progressive"][..], &["--time-budget", "1e9"], &["--progressive", "--stats"]] {
            std::fs::remove_file(folder.path.join("a.png")).unwrap();
            let said = folder.run(&[&command, more].concat());
            assert!(said.status == 0 && !said.err.contains("the time was up"), "{more:?}: {}", said.err);
            assert!(folder.read("a.png") == plain, "{more:?}");
            assert_eq!(
                more.contains(&"--stats"),
                said.err.contains("60x40 pixels, 7 samples a pixel, "),
                "{}",
                said.err
            );
        }
    }
}

#[test]
fn when_the_time_is_up_the_samples_that_all_pixels_have_are_written() {
    for mode in TRANSPORT {
        let folder = Folder::new();
        let run = |samples: &str, more: &[&str]| {
            let said = folder.run(&[&SMALL[..], &["--mode", mode, "--samples", samples], more].concat());
            assert_eq!(said.status, 0, "{}", said.err);
            (said.err, folder.read("a.png"))
        };
        let (said, picture) = run("65536", &["--time-budget", "1e-9", "--stats"]);
        assert!(said.contains("the time was up; the picture has 1 of 65536 samples a pixel"), "{said}");
        assert!(said.contains("60x40 pixels, 1 of 65536 samples a pixel"), "{said}");
        assert_eq!(width(&picture), 60);
        let (said, picture) = run("65536", &["--time-budget", "1e-9", "--quiet"]);
        assert!(said.is_empty() && width(&picture) == 60, "{said}");
    }
}

#[cfg(target_os = "linux")]
fn start(folder: &Folder, program: &[&str], more: &[&str]) -> Child {
    let mut command = Command::new(PROGRAM);
    command.args(program).args(["-o", "a.png"]).args(more).current_dir(&folder.path).stderr(Stdio::null());
    command.spawn().unwrap()
}

#[cfg(target_os = "linux")]
fn signal(child: &mut Child, signal: &str) -> Option<i32> {
    Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    child.wait().unwrap().code()
}

/// Waits until something holds; if it never does, the test fails.
#[cfg(target_os = "linux")]
fn wait_until(holds: impl Fn() -> bool) {
    for _ in 0..12_000 {
        if holds() {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("it never came about");
}

#[cfg(target_os = "linux")]
#[test]
fn the_file_is_replaced_after_every_pass_of_light() {
    for mode in TRANSPORT {
        let folder = Folder::new();
        // More samples than anyone waits for: the passes have 1, 2, 4, … samples a pixel.
        let mut child = start(&folder, &SMALL[..3], &["--mode", mode, "--samples", "65536", "--progressive"]);
        let mut seen = vec![Vec::new()];
        while seen.len() < 5 {
            wait_until(|| folder.path.join("a.png").exists() && folder.read("a.png") != *seen.last().unwrap());
            seen.push(folder.read("a.png"));
            assert_eq!(width(seen.last().unwrap()), 60);
        }
        assert_eq!(signal(&mut child, "-INT"), Some(130));
        assert_eq!((width(&folder.read("a.png")), folder.names()), (60, vec!["a.png".to_owned()]));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_run_leaves_the_last_whole_pass_or_the_disk_as_it_was() {
    let folder = Folder::new();
    for (name, status) in [("-INT", 130), ("-TERM", 143)] {
        folder.write("a.png", "older");
        let mut child = start(&folder, &LONG, &["--progressive"]);
        wait_until(|| folder.read("a.png") != b"older");
        assert_eq!(signal(&mut child, name), Some(status));
        assert_eq!((width(&folder.read("a.png")), folder.names()), (4000, vec!["a.png".to_owned()]));
        folder.write("a.png", "older");
        let mut child = start(&folder, &LONG, &["--time-budget", "1e9"]);
        std::thread::sleep(Duration::from_millis(200));
        assert_eq!(signal(&mut child, name), Some(status));
        assert_eq!((folder.read("a.png"), folder.names()), (b"older".to_vec(), vec!["a.png".to_owned()]));
    }
}
