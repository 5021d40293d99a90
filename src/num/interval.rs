//! One interval, rounded outward, with what is known of the function on it.

/// The closed set of reals between two bounds, which may be infinite; empty when both are NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower bound; −∞ when there is none.
    pub lo: f64,
    /// Upper bound; +∞ when there is none.
    pub hi: f64,
}

/// Where a function is known to have a value on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defined {
    /// At every point: proven.
    Everywhere,
    /// Not proven either way.
    Somewhere,
    /// At no point: proven.
    Nowhere,
}

/// The range of a function over a box, with what is known of the function there (a reduced form of the
/// decorations of IEEE 1788-2015, section 11).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Contains every value that the function takes; empty exactly when it is defined nowhere.
    pub range: Interval,
    /// Where it has a value.
    pub defined: Defined,
    /// True only if it is defined everywhere on the box and its restriction to the box is continuous.
    pub continuous: bool,
}
