//! Every sentence that is shown, by key, in one file a language.
//!
//! In: `texts/en.txt` and its like, lines `key: text` with places `{0}`, `{1}` for what changes. Out: sentences. A new language is a
//! new file and a row in [`LANGUAGES`]; a test says which keys it lacks.

use std::collections::BTreeMap;

/// The languages by their codes (ISO 639-1), with their files.
pub const LANGUAGES: [(&str, &str); 2] = [("en", include_str!("texts/en.txt")), ("sl", include_str!("texts/sl.txt"))];

/// The sentences of one language.
#[derive(Clone, Debug)]
pub struct Texts {
    /// The language's code.
    pub code: &'static str,
    entries: BTreeMap<&'static str, &'static str>,
}

impl Texts {
    /// The texts of a language, if there is a file for it.
    pub fn of(code: &str) -> Option<Texts> {
        let (code, file) = LANGUAGES.into_iter().find(|(known, _)| *known == code)?;
        Some(Texts { code, entries: entries(file) })
    }

    /// English.
    pub fn english() -> Texts {
        Texts { code: LANGUAGES[0].0, entries: entries(LANGUAGES[0].1) }
    }

    /// The sentence of a key; the key itself where there is none.
    pub fn get<'a>(&self, key: &'a str) -> &'a str
    where
        'static: 'a,
    {
        self.entries.get(key).copied().unwrap_or(key)
    }

    /// The sentence of a key with its places filled.
    pub fn with(&self, key: &str, values: &[&str]) -> String {
        let mut text = self.get(key).to_owned();
        for (k, value) in values.iter().enumerate() {
            text = text.replace(&format!("{{{k}}}"), value);
        }
        text
    }

    /// All keys.
    pub fn keys(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.entries.keys().copied()
    }
}

fn entries(file: &'static str) -> BTreeMap<&'static str, &'static str> {
    let lines = file.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split_once(": ")).map(|(key, text)| (key.trim(), text.trim())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_every_key_with_the_same_places() {
        let english = Texts::english();
        for (code, _) in LANGUAGES {
            let texts = Texts::of(code).unwrap();
            let keys: Vec<&str> = texts.keys().collect();
            assert_eq!(keys, english.keys().collect::<Vec<&str>>(), "{code}");
            for key in keys {
                let places =
                    |texts: &Texts| (0..8).map(|k| texts.get(key).contains(&format!("{{{k}}}"))).collect::<Vec<bool>>();
                assert_eq!(places(&texts), places(&english), "{code} {key}");
            }
        }
    }

    #[test]
    fn places_are_filled() {
        assert_eq!(Texts::english().with("no {0} key {1}", &["a", "b"]), "no a key b");
    }
}
