//! How the ways of building one path of light are weighed against each other.
//!
//! In: densities, as a subpath grows from the eye or from a light. Out: the sums of ratios of densities that the weights of all ways are
//! made of (balance heuristic, Veach 1997, section 9.2.2; in the recursive form of Georgiev 2012, "Implementing Vertex Connection and
//! Merging", equations 31 to 42, without merging).

/// What a subpath knows of all other ways to build it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// For connecting to this vertex: d_VCM there.
    pub connected: f64,
    /// For paths that come the other way: d_VC there.
    pub reversed: f64,
}

impl Balance {
    /// At the next vertex, `distance` away, met with this cosine; the way there was not one of parallel rays or of a far light.
    pub fn arrive(self, distance: f64, cosine: f64) -> Self {
        Balance { connected: self.connected * distance * distance, ..self }.arrive_from_afar(cosine)
    }

    /// The same where the distance does not matter.
    pub fn arrive_from_afar(self, cosine: f64) -> Self {
        Balance { connected: self.connected / cosine, reversed: self.reversed / cosine }
    }

    /// Behind a vertex that sent the path on with these densities, forward and back, under this cosine.
    pub fn scatter(self, pdf: f64, reverse_pdf: f64, cosine: f64) -> Self {
        Balance { connected: 1.0 / pdf, reversed: cosine / pdf * (self.reversed * reverse_pdf + self.connected) }
    }

    /// Behind a mirror: nothing can be connected to it.
    pub fn reflect(self, cosine: f64) -> Self {
        Balance { connected: 0.0, reversed: self.reversed * cosine }
    }

    /// The sum of ratios on this side of a connection whose other end would have gone on here with `pdf` per area, where this vertex
    /// would have gone back with `reverse_pdf`.
    pub fn ratio(self, pdf: f64, reverse_pdf: f64) -> f64 {
        pdf * (self.connected + self.reversed * reverse_pdf)
    }
}
