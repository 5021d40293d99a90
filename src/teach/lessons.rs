//! The lessons: which there are, with which program and which commands.
//!
//! In: nothing. Out: [`LESSONS`], and a lesson's page once somebody has run its commands. The sentences are in the files of texts
//! under `lesson.NN.title` and `lesson.NN.1`, `.2`, …; behind the k-th paragraph stands what the k-th command shows.

use super::page::{Block, Page};
use super::texts::Texts;

/// A lesson.
#[derive(Clone, Copy, Debug)]
pub struct Lesson {
    /// Its file's name without the ending, `NN-name`.
    pub name: &'static str,
    /// Its program.
    pub program: &'static str,
    /// Its commands; `PROGRAM` stands for the file.
    pub commands: &'static [&'static str],
}

/// Where the programs of the lessons are, from the project's root.
pub const FOLDER: &str = "examples/lessons";

/// What stands for the lesson's file in a command.
pub const PROGRAM: &str = "PROGRAM";

macro_rules! lesson {
    ($name:literal, $($command:literal),+) => {
        Lesson { name: $name, program: include_str!(concat!("../../examples/lessons/", $name, ".imp")), commands: &[$($command),+] }
    };
}

/// All lessons in their order.
pub static LESSONS: [Lesson; 12] = [
    lesson!("01-planes-and-quadrics", "PROGRAM -o picture.png -s 480x360 --orbit 20,40", "explain PROGRAM"),
    lesson!("02-graphs", "PROGRAM -o picture.png -s 480x360", "explain PROGRAM"),
    lesson!("03-the-ray", "ray PROGRAM --from 0,-4,0.5 --direction 0,2,0 --step 0.25"),
    lesson!(
        "04-the-step",
        "ray PROGRAM --from 0,0,3 --direction 0,0,-1 --step 0.3",
        "compare PROGRAM --step 0.5,0.1,0.02 --size 200x150"
    ),
    lesson!("05-double-roots", "ray PROGRAM --from 0,0,3 --direction 0,0,-1 --step 0.13", "explain PROGRAM"),
    lesson!("06-newton-runs-away", "ray PROGRAM --from -1.9,0,0 --direction 1,0,0 --step 1.2"),
    lesson!(
        "07-poles-are-no-walls",
        "ray PROGRAM --from -2.5,0,0.5 --direction 1,0,0 --step 0.11",
        "compare PROGRAM --step 0.2,0.05 --size 200x150"
    ),
    lesson!(
        "08-the-gradient-as-normal",
        "PROGRAM -o picture.png -s 480x360 --mode normal",
        "ray PROGRAM --from 2,-4,1.5 --direction -2,4,-1.2 --step 0.05",
        "explain PROGRAM"
    ),
    lesson!(
        "09-reflection-and-refraction",
        "ray PROGRAM --from 0.5,0,3 --direction 0,0,-1 --step 0.25 --ior 1.5",
        "PROGRAM -o picture.png -s 480x360 --mode mirror"
    ),
    lesson!(
        "10-camera-light-both",
        "ray PROGRAM --from 0,-4,0 --direction 0,1,0.1 --step 0.25",
        "ray PROGRAM --from 2,-3,3 --direction -2,2.04757,-2.69524 --step 0.05"
    ),
    lesson!("11-why-sharing-matters", "explain PROGRAM"),
    lesson!(
        "12-intervals-as-proof",
        "ray PROGRAM --from 0,0,3 --direction 0,0,-1 --step 0.3",
        "PROGRAM -o picture.png -s 480x360 --mode proof"
    ),
];

impl Lesson {
    /// Its number as it is written: two digits.
    pub fn number(&self) -> &'static str {
        &self.name[..2]
    }

    /// Its title.
    pub fn title(&self, texts: &Texts) -> String {
        let key = format!("lesson.{}.title", self.number());
        texts.get(key.as_str()).to_owned()
    }

    /// A command as it is typed.
    pub fn typed(&self, command: &str) -> String {
        format!("implicit {}", command.replace(PROGRAM, &format!("{FOLDER}/{}.imp", self.name)))
    }

    /// Its page; `run` answers a command with what it shows.
    ///
    /// # Errors
    /// What `run` says.
    pub fn page<E>(&self, texts: &Texts, mut run: impl FnMut(&str) -> Result<Vec<Block>, E>) -> Result<Page, E> {
        let mut page = Page::new(format!("{}. {}", self.number().trim_start_matches('0'), self.title(texts)));
        page.blocks.push(Block::Code(self.program.trim_end().to_owned()));
        for k in 1.. {
            let key = format!("lesson.{}.{k}", self.number());
            let paragraph = texts.get(key.as_str());
            let command = self.commands.get(k - 1);
            if paragraph == key && command.is_none() {
                break;
            }
            if paragraph != key {
                page.say(paragraph);
            }
            if let Some(command) = command {
                page.blocks.push(Block::Code(self.typed(command)));
                page.blocks.extend(run(command)?);
            }
        }
        Ok(page)
    }
}
