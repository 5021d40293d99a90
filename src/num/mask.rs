//! Decisions of all lanes at once, as words of ones or zeros: a branch of one lane's own would end the vector
//! instructions.
//!
//! In: conditions, flags. Out: masks, and what they pick. Separate because every array type decides in this way.

/// Which lanes need another way: all bits of their word.
pub(in crate::num) type Mask<const N: usize> = [u64; N];

/// All bits of a word, or none.
#[inline(always)]
pub(in crate::num) fn word(condition: bool) -> u64 {
    u64::from(condition).wrapping_neg()
}

/// Whether any lane is marked. Four words at a time, which the compiler does not see by itself.
#[inline(always)]
pub(in crate::num) fn any<const N: usize>(mask: &Mask<N>) -> bool {
    let (fours, rest) = mask.as_chunks::<4>();
    let mut all = [0; 4];
    for four in fours {
        for i in 0..4 {
            all[i] |= four[i];
        }
    }
    let tail = rest.iter().fold(0, |tail, word| tail | word);
    (all[0] | all[1]) | (all[2] | all[3]) | tail != 0
}

/// The flags of both operands. Eight at a time, which the compiler does not see by itself.
#[inline(always)]
pub(in crate::num) fn join<const N: usize>(a: &[u8; N], b: &[u8; N], out: &mut [u8; N]) {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let (out, out_rest) = out.as_chunks_mut::<8>();
    for i in 0..out.len() {
        out[i] = (u64::from_ne_bytes(a[i]) | u64::from_ne_bytes(b[i])).to_ne_bytes();
    }
    for i in 0..out_rest.len() {
        out_rest[i] = a_rest[i] | b_rest[i];
    }
}

/// Adds flags to the marked lanes.
#[inline(always)]
pub(in crate::num) fn mark<const N: usize>(flags: &mut [u8; N], mask: &Mask<N>, bits: u8) {
    if any(mask) {
        for i in 0..N {
            flags[i] |= mask[i] as u8 & bits;
        }
    }
}

/// a where the word is all ones, b where it is 0.
#[inline(always)]
pub(in crate::num) fn pick(word: u64, a: f64, b: f64) -> f64 {
    f64::from_bits((a.to_bits() & word) | (b.to_bits() & !word))
}
