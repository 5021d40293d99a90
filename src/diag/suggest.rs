//! "Did you mean": the known names that are nearest to an unknown one.
//!
//! In: what was typed and what would have been known. Out: at most three names, nearest first.
//! Separate because names, attributes, parameters and options are all mistyped in the same way.

/// Longer words are not compared: a distance costs the product of the lengths.
const MAX_COMPARED: usize = 40;

/// How many names are offered at most.
const MAX_OFFERED: usize = 3;

/// The candidates within a third of the word's length of edits, nearest first; those equally near in the
/// order given.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let length = word.chars().count();
    if length > MAX_COMPARED {
        return Vec::new();
    }
    let lower = word.to_lowercase();
    let mut found: Vec<(usize, &str)> = candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= MAX_COMPARED && *candidate != word)
        .filter_map(|candidate| {
            let distance = strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
            let longest = length.max(candidate.chars().count());
            (distance <= longest / 3).then_some((distance, candidate))
        })
        .collect();
    found.sort_by_key(|&(distance, _)| distance);
    found.dedup_by_key(|&mut (_, candidate)| candidate);
    found.into_iter().map(|(_, candidate)| candidate).take(MAX_OFFERED).collect()
}

/// Names as a choice: "`a`", "`a` or `b`", "`a`, `b` or `c`".
pub fn one_of(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [only] => format!("`{only}`"),
        [first @ .., last] => {
            let list: Vec<String> = first.iter().map(|name| format!("`{name}`")).collect();
            format!("{} or `{last}`", list.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_offered_and_far_ones_are_not() {
        let known = ["sin", "sinh", "sqrt", "smoothstep", "radius"];
        let rows: [(&str, &[&str]); 6] = [
            ("sqr", &["sqrt"]),
            ("snih", &["sinh"]),
            ("SMOTHSTEP", &["smoothstep"]),
            ("raduis", &["radius"]),
            ("banana", &[]),
            ("q", &[]),
        ];
        for (word, expected) in rows {
            let found = nearest(word, known);
            assert!(found.first() == expected.first(), "{word}: {found:?}");
        }
        assert!(nearest(&"s".repeat(100_000), known).is_empty());
    }

    #[test]
    fn a_choice_reads_as_a_sentence() {
        assert_eq!(one_of(&["a"]), "`a`");
        assert_eq!(one_of(&["a", "b", "c"]), "`a`, `b` or `c`");
    }
}
