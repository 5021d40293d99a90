//! What a tracer keeps for one sheet between batches of rays.
//!
//! In: a sheet. Out: registers for its kernels, fit for every part of its formula. Separate from the tracer because nothing
//! here looks at rays.

use super::contract::RayFiles;
use super::isolate::CellFiles;
use super::kernels::Parts;
use super::sheet::{Balls, Points, Sheet};
use super::sum::Sum;
use super::tile::{FormFiles, Forms};
use crate::closure::pieces::Scratch;
use crate::closure::specialise::Slabs;

/// Register files of some kernels.
pub(crate) struct Registers {
    pub(crate) cells: CellFiles,
    pub(crate) along: RayFiles,
    pub(crate) forms: FormFiles,
    pub(crate) point: Vec<Points>,
    pub(crate) balls: Vec<Balls>,
    pub(crate) gradient: Vec<Points>,
}

/// What a tracer keeps for one sheet.
pub(crate) struct Memory {
    pub(crate) registers: Registers,
    /// Of the arguments that can be left out.
    pub(crate) leaves: Vec<Slabs>,
    pub(crate) scalar: Scratch,
    pub(crate) sides: Scratch,
}

impl Memory {
    pub(crate) fn new(sheet: &Sheet) -> Self {
        let formula = sheet.kernels.whole();
        Memory {
            registers: Registers {
                cells: CellFiles { value: formula.value().registers(), slope: formula.slope().registers() },
                along: RayFiles { value: formula.value_along().registers(), slope: formula.slope_along().registers() },
                forms: FormFiles {
                    value: formula.value_form().registers(),
                    slope: formula.slope_form().registers(),
                    terms: sheet.kernels.sum.as_ref().map_or_else(Vec::new, Sum::registers),
                    sums: [Forms::splat(0.0, 0.0); 2],
                },
                point: formula.point().registers(),
                balls: formula.ball().registers(),
                gradient: formula.gradient().registers(),
            },
            leaves: sheet.kernels.parts.as_ref().map_or_else(Vec::new, Parts::registers),
            scalar: sheet.scalar.scratch(),
            sides: sheet.sides.scratch(),
        }
    }
}
