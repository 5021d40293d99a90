//! Rust source as the tidy rules want to see it: without comments, without what quotes hold, without tests.
//!
//! In: a file's text. Out: the same text, byte for byte as long, with blanks where something was taken out, so that line
//! numbers stay. Apart from the rules because it knows Rust's spelling and nothing of this project.

/// The text without comments, and with blank strings and character literals.
pub(crate) fn code_only(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut out = bytes.to_vec();
    let mut at = 0;
    while at < bytes.len() {
        let end = match bytes[at..] {
            [b'/', b'/', ..] => at + text[at..].find('\n').unwrap_or(text.len() - at),
            [b'/', b'*', ..] => block_comment_end(bytes, at),
            [b'r', b'"' | b'#', ..] if !follows_name(bytes, at) => raw_string_end(text, at),
            [b'"', ..] => string_end(bytes, at),
            [b'\'', ..] => character_end(text, at),
            _ => at,
        };
        for byte in &mut out[at..end] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
        at = end.max(at + 1);
    }
    String::from_utf8(out).unwrap()
}

fn is_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

fn follows_name(bytes: &[u8], at: usize) -> bool {
    at > 0 && is_name(bytes[at - 1]) && bytes[at - 1] != b'b'
}

fn block_comment_end(bytes: &[u8], start: usize) -> usize {
    let (mut depth, mut at) = (0, start);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => (depth, at) = (depth + 1, at + 2),
            b"*/" => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
    bytes.len()
}

/// `r"…"`, `r#"…"#`; a raw identifier like `r#type` is no string and ends where it starts.
fn raw_string_end(text: &str, start: usize) -> usize {
    let hashes = text[start + 1..].bytes().take_while(|&byte| byte == b'#').count();
    let open = start + 1 + hashes;
    if text.as_bytes().get(open) != Some(&b'"') {
        return start;
    }
    let close = format!("\"{}", "#".repeat(hashes));
    text[open + 1..].find(&close).map_or(text.len(), |found| open + 1 + found + close.len())
}

fn string_end(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at < bytes.len() {
        match bytes[at] {
            b'\\' => at += 2,
            b'"' => return at + 1,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// A character literal; a lifetime ends where it starts.
fn character_end(text: &str, start: usize) -> usize {
    let mut rest = text[start + 1..].char_indices();
    match rest.next() {
        Some((_, '\\')) => text[start + 3..].find('\'').map_or(text.len(), |found| start + 3 + found + 1),
        Some(_) => match rest.next() {
            Some((after, '\'')) => start + 1 + after + 1,
            _ => start,
        },
        None => start,
    }
}

/// The code without the items under `#[cfg(test)]` and `#[test]`.
pub(crate) fn without_tests(code: &str) -> String {
    let mut out = code.to_string();
    for mark in ["#[cfg(test)]", "#[test]", "#[cfg(any(test"] {
        while let Some(start) = out.find(mark) {
            let end = item_end(&out, start + mark.len());
            let blank: String = out[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
            out.replace_range(start..end, &blank);
        }
    }
    out
}

/// Where the item ends that starts here: at a `;`, or with the brace that closes its body.
fn item_end(code: &str, start: usize) -> usize {
    let mut depth = 0;
    for (at, c) in code[start..].char_indices() {
        match c {
            ';' if depth == 0 => return start + at + 1,
            '{' => depth += 1,
            '}' if depth <= 1 => return start + at + 1,
            '}' => depth -= 1,
            _ => {}
        }
    }
    code.len()
}

/// Where a word stands on its own.
pub(crate) fn words<'a>(code: &'a str, word: &'a str) -> impl Iterator<Item = usize> + 'a {
    let bytes = code.as_bytes();
    code.match_indices(word).map(|(at, _)| at).filter(move |&at| {
        let after = at + word.len();
        (at == 0 || !is_name(bytes[at - 1])) && (after >= bytes.len() || !is_name(bytes[after]))
    })
}

/// The first names of the paths that follow a prefix: one, or several when a brace opens a group.
pub(crate) fn heads(rest: &str) -> Vec<&str> {
    let Some(group) = rest.strip_prefix('{') else { return vec![name(rest)] };
    let (mut depth, mut start, mut found) = (0, 0, Vec::new());
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                found.push(name(group[start..at].trim_start()));
                start = at + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    found.retain(|head| !head.is_empty());
    found
}

fn name(text: &str) -> &str {
    let end = text.bytes().position(|byte| !is_name(byte)).unwrap_or(text.len());
    &text[..end]
}

#[test]
fn only_code_is_left() {
    for (text, expect) in [
        ("a // b\nc", "a     \nc"),
        ("a /* b /* c */ d */ e", "a                   e"),
        ("f(\"x // \\\" y\") g", "f(           ) g"),
        ("r#\"a\"b\"# c", "         c"),
        ("r#type", "r#type"),
        ("'a' '\\'' 'b", "         'b"),
        ("&'a str", "&'a str"),
        ("for 'a in x", "for 'a in x"),
        ("b\"q\" + 1", "b    + 1"),
        ("'\"' x \"y\"", "    x    "),
    ] {
        assert_eq!(code_only(text), expect, "{text}");
    }
}

#[test]
fn tests_are_left_out() {
    assert_eq!(without_tests("a #[cfg(test)] mod t { b { c } } d").split_whitespace().collect::<Vec<_>>(), ["a", "d"]);
    assert_eq!(without_tests("#[cfg(test)]\nmod tests;\nx").split_whitespace().collect::<Vec<_>>(), ["x"]);
}

#[test]
fn groups_have_several_heads() {
    assert_eq!(heads("num::{a, b}"), ["num"]);
    assert_eq!(heads("{num::{a, b}, expr, cli::x}; y"), ["num", "expr", "cli"]);
}
