//! `implicit` alone.
//!
//! In: nothing. Out: a greeting with commands to try.

use super::complaint::Complaint;
use super::console;

const GREETING: &str = "\
implicit: type an equation and see its surface, exactly.

  implicit 'x^2 + y^2 + z^2 = 1' -o sphere.png
  implicit 'sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) = 0' -o gyroid.png
  implicit eval 'x^2 + y^2 + z^2 - 1' --at 1,1,1

All options: implicit --help
";

/// Prints it.
///
/// # Errors
/// If standard output is full.
pub fn run() -> Result<(), Complaint> {
    console::print(GREETING.as_bytes())
}
