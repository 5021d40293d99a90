//! Letters beyond the keyboard: names that are one symbol, raised digits, and letters that only look like others.
//!
//! In: a character. Out: what it is read as, or what is wrong with it. Separate because these are tables.

/// Symbols that are names by themselves, with the name they are read as.
const SYMBOLS: [(char, &str); 21] = [
    ('π', "pi"),
    ('τ', "tau"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('ρ', "rho"),
    ('ϱ', "rho"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('α', "α"),
    ('β', "β"),
    ('γ', "γ"),
    ('δ', "δ"),
    ('ε', "ε"),
    ('ζ', "ζ"),
    ('η', "η"),
    ('λ', "λ"),
    ('μ', "μ"),
    ('ξ', "ξ"),
    ('σ', "σ"),
    ('ψ', "ψ"),
    ('ω', "ω"),
];

/// The name a symbol is read as; `None` if it is no symbol of the language.
pub(super) fn symbol(character: char) -> Option<&'static str> {
    if character.is_ascii() {
        return None;
    }
    SYMBOLS.iter().find(|(c, _)| *c == character).map(|(_, name)| *name)
}

/// The digit or minus that a raised character stands for.
pub(super) fn raised(character: char) -> Option<char> {
    if character.is_ascii() {
        return None;
    }
    let digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    match character {
        '⁻' => Some('-'),
        c => digits.chars().position(|d| d == c).and_then(|i| char::from_digit(i as u32, 10)),
    }
}

/// Letters drawn like Latin ones: what they look like and whose they are.
const LOOK_ALIKES: [(&str, &str, &str); 3] = [
    ("асԁеһіјӏорԛѕԝхуԍАВЕНІЈКМОРЅТХҮ", "acdehijlopqswxygABEHIJKMOPSTXY", "Cyrillic"),
    ("ικνουχΑΒΕΖΗΙΚΜΝΟΡΤΥΧ", "iknouxABEZHIKMNOPTYX", "Greek"),
    ("ıȷɑɡℎℓℯℊℴ", "ijaghlego", "special"),
];

/// What a letter looks like, if it only looks like a character of the language: that character, and whose letter it is.
pub(super) fn look_alike(character: char) -> Option<(char, &'static str)> {
    if character.is_ascii() {
        return None;
    }
    for (letters, latin, script) in LOOK_ALIKES {
        if let Some(i) = letters.chars().position(|c| c == character) {
            return latin.chars().nth(i).map(|c| (c, script));
        }
    }
    let code = character as u32;
    match code {
        // Full-width forms are ASCII moved by 0xFEE0 (Unicode, chart FF00).
        0xff01..=0xff5e => char::from_u32(code - 0xfee0).map(|c| (c, "full-width")),
        // Mathematical alphanumerics: alphabets of 52 letters from 1D400 to 1D6A3 (chart 1D400).
        0x1d400..=0x1d6a3 => {
            let i = (code - 0x1d400) % 52;
            char::from_u32(if i < 26 { 'A' as u32 + i } else { 'a' as u32 + i - 26 }).map(|c| (c, "mathematical"))
        }
        // Mathematical digits: five times ten.
        0x1d7ce..=0x1d7ff => char::from_digit((code - 0x1d7ce) % 10, 10).map(|c| (c, "mathematical")),
        // Lowered digits.
        0x2080..=0x2089 => char::from_digit(code - 0x2080, 10).map(|c| (c, "lowered")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn look_alikes_are_told_from_the_real_ones() {
        for (letters, latin, _) in LOOK_ALIKES {
            assert_eq!(letters.chars().count(), latin.chars().count());
            assert!(letters.chars().all(|c| !c.is_ascii() && symbol(c).is_none()));
        }
        let rows = [('х', 'x'), ('ｘ', 'x'), ('𝑥', 'x'), ('𝐳', 'z'), ('２', '2'), ('₂', '2'), ('（', '('), ('ο', 'o')];
        for (found, meant) in rows {
            assert_eq!(look_alike(found).map(|(c, _)| c), Some(meant));
        }
        assert_eq!(look_alike('x'), None);
        assert_eq!(raised('⁷'), Some('7'));
        assert_eq!(raised('7'), None);
    }
}
