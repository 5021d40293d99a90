//! Which instructions the machine has, and the one macro that compiles a function for each level.
//!
//! A function is written once, generic over [`Level`], and stamped out per level by
//! `for_each_level!`; which stamp runs is decided once at run time. The results are the same bits in
//! every level: the order of evaluation is the same, and a·b + c is rounded once in all of them.

/// A set of instructions that a function is compiled for.
pub trait Level: Copy + Send + Sync + 'static {
    /// a·b + c with one rounding.
    fn fma(a: f64, b: f64, c: f64) -> f64;
}

/// Instructions that every machine has; the fused product is computed in software where the target has none.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

/// AVX2 and FMA, with or without AVX-512. Only functions stamped by `for_each_level!` may use it.
#[derive(Clone, Copy, Debug)]
pub struct Fused;

/// The level chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Simd {
    /// [`Portable`].
    #[default]
    Portable,
    /// [`Fused`] in vectors of four; made by [`Simd::best`] alone, which checked the machine.
    Fused(Checked),
    /// [`Fused`] in vectors of eight (AVX-512); likewise.
    Wide(Checked),
}

/// Proof that the machine was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checked(());

impl Level for Portable {
    #[inline(always)]
    fn fma(a: f64, b: f64, c: f64) -> f64 {
        #[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
        #[allow(clippy::disallowed_methods, reason = "the target has the instruction")]
        return a.mul_add(b, c);
        #[cfg(not(any(target_arch = "aarch64", target_feature = "fma")))]
        super::fused::mul_add(a, b, c)
    }
}

impl Level for Fused {
    #[inline(always)]
    #[allow(clippy::disallowed_methods, reason = "compiled with the instruction")]
    fn fma(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

impl Simd {
    /// The fastest level this machine has.
    pub fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            let fused = has!("avx2") && has!("fma");
            if fused && has!("avx512f") && has!("avx512bw") && has!("avx512dq") && has!("avx512vl") {
                return Simd::Wide(Checked(()));
            }
            if fused {
                return Simd::Fused(Checked(()));
            }
        }
        Simd::Portable
    }

    /// The levels that this machine has, slowest first.
    pub fn all() -> Vec<Simd> {
        match Simd::best() {
            Simd::Portable => vec![Simd::Portable],
            Simd::Fused(checked) => vec![Simd::Portable, Simd::Fused(checked)],
            Simd::Wide(checked) => vec![Simd::Portable, Simd::Fused(checked), Simd::Wide(checked)],
        }
    }
}

/// Compiles one generic function for every level and makes the function that picks one.
///
/// ```ignore
/// for_each_level! {
///     /// Docs.
///     pub fn name<L: Level, [T: Number]>(simd, a: A, b: &mut B) -> R = body_function;
/// }
/// ```
/// makes `name(simd, a, b)`, which runs `body` — the block, in which `L` names the level — inside a function
/// with the level's instructions. Closures written in the block have those instructions too; closures
/// written in functions that the block calls do not.
macro_rules! for_each_level {
    ($(#[$doc:meta])* $vis:vis fn $name:ident [$level:ident $(, $generic:ident : $bound:path)*]
     ($($arg:ident : $type:ty),* $(,)?) $(-> $ret:ty)? $body:block) => {
        $(#[$doc])*
        $vis fn $name<$($generic: $bound),*>(simd: $crate::num::level::Simd, $($arg: $type),*) $(-> $ret)? {
            fn portable<$($generic: $bound),*>($($arg: $type),*) $(-> $ret)? {
                #[allow(dead_code)]
                type $level = $crate::num::level::Portable;
                $body
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn fused<$($generic: $bound),*>($($arg: $type),*) $(-> $ret)? {
                #[allow(dead_code)]
                type $level = $crate::num::level::Fused;
                $body
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma,avx512f,avx512bw,avx512dq,avx512vl")]
            fn wide<$($generic: $bound),*>($($arg: $type),*) $(-> $ret)? {
                #[allow(dead_code)]
                type $level = $crate::num::level::Fused;
                $body
            }
            match simd {
                $crate::num::level::Simd::Portable => portable::<$($generic),*>($($arg),*),
                #[cfg(target_arch = "x86_64")]
                #[allow(unsafe_code)]
                // SAFETY: a `Checked` exists only if `Simd::best` found AVX2 and FMA on this machine.
                $crate::num::level::Simd::Fused(_) => unsafe { fused::<$($generic),*>($($arg),*) },
                #[cfg(target_arch = "x86_64")]
                #[allow(unsafe_code)]
                // SAFETY: as above, and the same for AVX-512.
                $crate::num::level::Simd::Wide(_) => unsafe { wide::<$($generic),*>($($arg),*) },
                #[cfg(not(target_arch = "x86_64"))]
                $crate::num::level::Simd::Fused(_) | $crate::num::level::Simd::Wide(_) => portable::<$($generic),*>($($arg),*),
            }
        }
    };
}
pub(crate) use for_each_level;
