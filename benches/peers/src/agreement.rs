//! Whether a peer drew the surface.
//!
//! In: our depths and what the peer hit. Out: the share of the pixels that it has right. Pixels whose neighbours do not
//! all agree in ours are left out: a peer's pixel grid may be half a pixel off.

/// A peer draws a scene right from this share of its pixels on.
pub const RIGHT: f64 = 0.99;

/// The share of right pixels among those that one of the two hits; `is_right(pixel, depth)` says whether the peer has
/// this hit. `is_hit(pixel)` says whether the peer hits anything.
pub fn share(depths: &[f64], size: u32, is_hit: impl Fn(usize) -> bool, is_right: impl Fn(usize, f64) -> bool) -> f64 {
    let (mut seen, mut right) = (0u64, 0u64);
    for (pixel, &depth) in depths.iter().enumerate() {
        if !is_inner(depths, size as usize, pixel) {
            continue;
        }
        let (ours, theirs) = (depth.is_finite(), is_hit(pixel));
        seen += u64::from(ours || theirs);
        right += u64::from(ours && theirs && is_right(pixel, depth));
    }
    right as f64 / seen as f64
}

/// Whether all neighbours hit, or all miss, as the pixel itself.
fn is_inner(depths: &[f64], size: usize, pixel: usize) -> bool {
    let (x, y) = (pixel % size, pixel / size);
    let range = |c: usize| c.saturating_sub(1)..(c + 2).min(size);
    range(y).all(|j| range(x).all(|i| depths[j * size + i].is_finite() == depths[pixel].is_finite()))
}
