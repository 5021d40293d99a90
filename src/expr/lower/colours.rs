//! The names of colours.
//!
//! In: a name or hexadecimal digits. Out: red, green, blue of 0..=255, sRGB. Separate because it is a table.

/// The named colours of CSS Color Module Level 4, section 6.1, sorted by name.
const NAMED: [(&str, [u8; 3]); 148] = [
    ("aliceblue", [240, 248, 255]),
    ("antiquewhite", [250, 235, 215]),
    ("aqua", [0, 255, 255]),
    ("aquamarine", [127, 255, 212]),
    ("azure", [240, 255, 255]),
    ("beige", [245, 245, 220]),
    ("bisque", [255, 228, 196]),
    ("black", [0, 0, 0]),
    ("blanchedalmond", [255, 235, 205]),
    ("blue", [0, 0, 255]),
    ("blueviolet", [138, 43, 226]),
    ("brown", [165, 42, 42]),
    ("burlywood", [222, 184, 135]),
    ("cadetblue", [95, 158, 160]),
    ("chartreuse", [127, 255, 0]),
    ("chocolate", [210, 105, 30]),
    ("coral", [255, 127, 80]),
    ("cornflowerblue", [100, 149, 237]),
    ("cornsilk", [255, 248, 220]),
    ("crimson", [220, 20, 60]),
    ("cyan", [0, 255, 255]),
    ("darkblue", [0, 0, 139]),
    ("darkcyan", [0, 139, 139]),
    ("darkgoldenrod", [184, 134, 11]),
    ("darkgray", [169, 169, 169]),
    ("darkgreen", [0, 100, 0]),
    ("darkgrey", [169, 169, 169]),
    ("darkkhaki", [189, 183, 107]),
    ("darkmagenta", [139, 0, 139]),
    ("darkolivegreen", [85, 107, 47]),
    ("darkorange", [255, 140, 0]),
    ("darkorchid", [153, 50, 204]),
    ("darkred", [139, 0, 0]),
    ("darksalmon", [233, 150, 122]),
    ("darkseagreen", [143, 188, 143]),
    ("darkslateblue", [72, 61, 139]),
    ("darkslategray", [47, 79, 79]),
    ("darkslategrey", [47, 79, 79]),
    ("darkturquoise", [0, 206, 209]),
    ("darkviolet", [148, 0, 211]),
    ("deeppink", [255, 20, 147]),
    ("deepskyblue", [0, 191, 255]),
    ("dimgray", [105, 105, 105]),
    ("dimgrey", [105, 105, 105]),
    ("dodgerblue", [30, 144, 255]),
    ("firebrick", [178, 34, 34]),
    ("floralwhite", [255, 250, 240]),
    ("forestgreen", [34, 139, 34]),
    ("fuchsia", [255, 0, 255]),
    ("gainsboro", [220, 220, 220]),
    ("ghostwhite", [248, 248, 255]),
    ("gold", [255, 215, 0]),
    ("goldenrod", [218, 165, 32]),
    ("gray", [128, 128, 128]),
    ("green", [0, 128, 0]),
    ("greenyellow", [173, 255, 47]),
    ("grey", [128, 128, 128]),
    ("honeydew", [240, 255, 240]),
    ("hotpink", [255, 105, 180]),
    ("indianred", [205, 92, 92]),
    ("indigo", [75, 0, 130]),
    ("ivory", [255, 255, 240]),
    ("khaki", [240, 230, 140]),
    ("lavender", [230, 230, 250]),
    ("lavenderblush", [255, 240, 245]),
    ("lawngreen", [124, 252, 0]),
    ("lemonchiffon", [255, 250, 205]),
    ("lightblue", [173, 216, 230]),
    ("lightcoral", [240, 128, 128]),
    ("lightcyan", [224, 255, 255]),
    ("lightgoldenrodyellow", [250, 250, 210]),
    ("lightgray", [211, 211, 211]),
    ("lightgreen", [144, 238, 144]),
    ("lightgrey", [211, 211, 211]),
    ("lightpink", [255, 182, 193]),
    ("lightsalmon", [255, 160, 122]),
    ("lightseagreen", [32, 178, 170]),
    ("lightskyblue", [135, 206, 250]),
    ("lightslategray", [119, 136, 153]),
    ("lightslategrey", [119, 136, 153]),
    ("lightsteelblue", [176, 196, 222]),
    ("lightyellow", [255, 255, 224]),
    ("lime", [0, 255, 0]),
    ("limegreen", [50, 205, 50]),
    ("linen", [250, 240, 230]),
    ("magenta", [255, 0, 255]),
    ("maroon", [128, 0, 0]),
    ("mediumaquamarine", [102, 205, 170]),
    ("mediumblue", [0, 0, 205]),
    ("mediumorchid", [186, 85, 211]),
    ("mediumpurple", [147, 112, 219]),
    ("mediumseagreen", [60, 179, 113]),
    ("mediumslateblue", [123, 104, 238]),
    ("mediumspringgreen", [0, 250, 154]),
    ("mediumturquoise", [72, 209, 204]),
    ("mediumvioletred", [199, 21, 133]),
    ("midnightblue", [25, 25, 112]),
    ("mintcream", [245, 255, 250]),
    ("mistyrose", [255, 228, 225]),
    ("moccasin", [255, 228, 181]),
    ("navajowhite", [255, 222, 173]),
    ("navy", [0, 0, 128]),
    ("oldlace", [253, 245, 230]),
    ("olive", [128, 128, 0]),
    ("olivedrab", [107, 142, 35]),
    ("orange", [255, 165, 0]),
    ("orangered", [255, 69, 0]),
    ("orchid", [218, 112, 214]),
    ("palegoldenrod", [238, 232, 170]),
    ("palegreen", [152, 251, 152]),
    ("paleturquoise", [175, 238, 238]),
    ("palevioletred", [219, 112, 147]),
    ("papayawhip", [255, 239, 213]),
    ("peachpuff", [255, 218, 185]),
    ("peru", [205, 133, 63]),
    ("pink", [255, 192, 203]),
    ("plum", [221, 160, 221]),
    ("powderblue", [176, 224, 230]),
    ("purple", [128, 0, 128]),
    ("rebeccapurple", [102, 51, 153]),
    ("red", [255, 0, 0]),
    ("rosybrown", [188, 143, 143]),
    ("royalblue", [65, 105, 225]),
    ("saddlebrown", [139, 69, 19]),
    ("salmon", [250, 128, 114]),
    ("sandybrown", [244, 164, 96]),
    ("seagreen", [46, 139, 87]),
    ("seashell", [255, 245, 238]),
    ("sienna", [160, 82, 45]),
    ("silver", [192, 192, 192]),
    ("skyblue", [135, 206, 235]),
    ("slateblue", [106, 90, 205]),
    ("slategray", [112, 128, 144]),
    ("slategrey", [112, 128, 144]),
    ("snow", [255, 250, 250]),
    ("springgreen", [0, 255, 127]),
    ("steelblue", [70, 130, 180]),
    ("tan", [210, 180, 140]),
    ("teal", [0, 128, 128]),
    ("thistle", [216, 191, 216]),
    ("tomato", [255, 99, 71]),
    ("turquoise", [64, 224, 208]),
    ("violet", [238, 130, 238]),
    ("wheat", [245, 222, 179]),
    ("white", [255, 255, 255]),
    ("whitesmoke", [245, 245, 245]),
    ("yellow", [255, 255, 0]),
    ("yellowgreen", [154, 205, 50]),
];

/// The colour of a name.
pub(super) fn named(name: &str) -> Option<[u8; 3]> {
    NAMED.binary_search_by_key(&name, |(known, _)| known).ok().map(|at| NAMED[at].1)
}

/// The colour of a name or of hexadecimal digits.
pub fn color_of_text(text: &str) -> Option<[u8; 3]> {
    named(text).or_else(|| hexadecimal(text))
}

/// All names.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    NAMED.iter().map(|(name, _)| *name)
}

/// The colour of `#rgb` or `#rrggbb`.
pub(super) fn hexadecimal(text: &str) -> Option<[u8; 3]> {
    let digits = text.strip_prefix('#')?;
    let step = match digits.len() {
        3 => 1,
        6 => 2,
        _ => return None,
    };
    let mut color = [0u8; 3];
    for (at, part) in color.iter_mut().enumerate() {
        let value =
            u8::from_str_radix(digits.get(at * step..(at + 1) * step).filter(|part| !part.starts_with("+"))?, 16)
                .ok()?;
        *part = if step == 1 { value * 17 } else { value };
    }
    Some(color)
}

/// The parts of 0..=1, sRGB, as bytes.
pub(super) fn bytes(parts: [f64; 3]) -> [u8; 3] {
    parts.map(|part| (part * 255.0 + 0.5) as u8)
}

/// Red, green, blue of 0..=1, sRGB, of a hue in degrees, a saturation and a value of 0..=1 (A. R. Smith, "Color gamut transform pairs",
/// SIGGRAPH 1978).
pub fn parts_of_value(hue: f64, saturation: f64, value: f64) -> [f64; 3] {
    mixed(hue, value * (1.0 - saturation), value)
}

/// Red, green, blue of 0..=1, sRGB, of a hue in degrees, a saturation and a lightness of 0..=1 (CSS Color Module Level 4, section 7).
pub fn parts_of_lightness(hue: f64, saturation: f64, lightness: f64) -> [f64; 3] {
    let reach = saturation * lightness.min(1.0 - lightness);
    mixed(hue, lightness - reach, lightness + reach)
}

/// The pure colour of a hue, its parts moved from 0..=1 to low..=high.
fn mixed(hue: f64, low: f64, high: f64) -> [f64; 3] {
    let sixths = hue / 60.0;
    // Red is full within 60 degrees of 0, green of 120, blue of 240, and each fades over the next 60.
    [0.0, 2.0, 4.0].map(|centre| {
        let turned = sixths - centre + 3.0;
        let away = (turned - (turned / 6.0).floor() * 6.0 - 3.0).abs();
        let part = (2.0 - away).clamp(0.0, 1.0);
        low + (high - low) * part
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_digits_give_the_colours_of_css() {
        assert!(NAMED.is_sorted_by_key(|(name, _)| name));
        let rows = [("red", [255, 0, 0]), ("teal", [0, 128, 128]), ("rebeccapurple", [102, 51, 153])];
        for (name, color) in rows {
            assert_eq!(named(name), Some(color), "{name}");
        }
        assert_eq!(named("Red"), None);
        let rows =
            [(0.0, "red"), (120.0, "lime"), (240.0, "blue"), (60.0, "yellow"), (-60.0, "magenta"), (540.0, "cyan")];
        for (hue, name) in rows {
            assert_eq!(Some(bytes(parts_of_value(hue, 1.0, 1.0))), named(name), "{name}");
            assert_eq!(Some(bytes(parts_of_lightness(hue, 1.0, 0.5))), named(name), "{name}");
        }
        assert_eq!(bytes(parts_of_value(30.0, 0.5, 1.0)), [255, 191, 128]);
        assert_eq!(bytes(parts_of_lightness(210.0, 0.5, 0.75)), [159, 191, 223]);
        let rows =
            [("#4af", Some([0x44, 0xaa, 0xff])), ("#0a0B0c", Some([10, 11, 12])), ("#12345", None), ("#+12", None)];
        for (text, color) in rows {
            assert_eq!(hexadecimal(text), color, "{text}");
        }
    }
}
