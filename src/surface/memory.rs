//! What a tracer keeps for one sheet between batches of rays.
//!
//! In: a sheet. Out: registers for its kernels, and the formulas that are enough in some part of space, made once and found
//! again. Separate from the tracer because nothing here looks at rays.

use super::isolate::CellFiles;
use super::screen::{Rectangle, Screen, place_slabs};
use super::sheet::{Kernels, Points, Sheet};
use super::tile::FormFiles;
use crate::closure::pieces::Scratch;
use crate::closure::specialise::{Choices, Key, SLABS, Slabs};
use crate::num::level::Simd;
use std::collections::HashMap;

/// Register files of some kernels.
pub(crate) struct Registers {
    pub(crate) cells: CellFiles,
    pub(crate) forms: FormFiles,
    pub(crate) point: Vec<Points>,
    pub(crate) gradient: Vec<Points>,
}

impl Registers {
    pub(crate) fn new(kernels: &Kernels) -> Self {
        Registers {
            cells: CellFiles { value: kernels.value.registers(), slope: kernels.slope.registers() },
            forms: FormFiles { value: kernels.value_form.registers(), slope: kernels.slope_form.registers() },
            point: kernels.point.registers(),
            gradient: kernels.gradient.registers(),
        }
    }
}

/// A sheet's formula without what does not matter in some part of space.
pub(crate) struct Special {
    pub(crate) kernels: Kernels,
    pub(crate) registers: Registers,
}

/// What a tracer keeps for one sheet.
pub(crate) struct Memory {
    pub(crate) registers: Registers,
    pub(crate) scalar: Scratch,
    pub(crate) sides: Scratch,
    /// The forms of what can be left out, and the formulas without it met so far.
    pub(crate) slabs: Vec<Slabs>,
    pub(crate) specials: HashMap<Key, Special>,
    /// The one at hand; its registers are in `registers` meanwhile.
    pub(crate) special: Option<(Key, Special)>,
}

/// The kernels of the formula at hand: the special one, or the sheet's own.
pub(crate) fn kernels_of<'a>(sheet: &'a Sheet, special: &'a Option<(Key, Special)>) -> &'a Kernels {
    special.as_ref().map_or(&sheet.kernels, |(_, special)| &special.kernels)
}

/// So many formulas are kept; then all are made anew.
const MOST_SPECIALS: usize = 2048;

impl Memory {
    pub(crate) fn new(sheet: &Sheet) -> Self {
        Memory {
            registers: Registers::new(&sheet.kernels),
            scalar: sheet.scalar.scratch(),
            sides: sheet.sides.scratch(),
            slabs: sheet.choices.as_ref().map_or_else(Vec::new, Choices::registers),
            specials: HashMap::new(),
            special: None,
        }
    }

    /// Takes up the formula that is enough between two depths of a rectangle.
    pub(crate) fn specialise(
        &mut self,
        sheet: &Sheet,
        (a, end): (f64, f64),
        (screen, rectangle): (&Screen, Rectangle),
        simd: Simd,
    ) {
        let Some(choices) = &sheet.choices else { return };
        place_slabs(simd, screen, rectangle, (a, end), &mut self.slabs);
        let Some(key) = choices.live(&mut self.slabs, SLABS) else { return };
        if self.specials.len() >= MOST_SPECIALS {
            self.specials.clear();
        }
        let mut special = self.specials.remove(&key).unwrap_or_else(|| {
            let (mut graph, g) = choices.pruned(&key);
            let kernels = Kernels::new(&mut graph, g, simd);
            Special { registers: Registers::new(&kernels), kernels }
        });
        std::mem::swap(&mut self.registers, &mut special.registers);
        self.special = Some((key, special));
    }

    /// Puts it away again.
    pub(crate) fn generalise(&mut self) {
        if let Some((key, mut special)) = self.special.take() {
            std::mem::swap(&mut self.registers, &mut special.registers);
            self.specials.insert(key, special);
        }
    }
}
