//! One value for every pixel.
//!
//! In: a size and values. Out: rows of them, from the top. Colours, depths and normals are layers of one kind.

use super::size::Size;

/// A value of type `T` for every pixel, rows from the top, each from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer<T> {
    /// How many pixels there are.
    pub size: Size,
    /// Their values.
    pub values: Vec<T>,
}

impl<T: Copy> Layer<T> {
    /// A layer that is `value` everywhere.
    pub fn filled(size: Size, value: T) -> Self {
        Layer { size, values: vec![value; size.pixels()] }
    }

    /// The value of pixel i from the left, j from the top.
    pub fn at(&self, i: u32, j: u32) -> T {
        self.values[j as usize * self.size.width() as usize + i as usize]
    }

    /// Gives pixel i from the left, j from the top a value.
    pub fn set(&mut self, i: u32, j: u32, value: T) {
        self.values[j as usize * self.size.width() as usize + i as usize] = value;
    }

    /// Gives pixels from pixel i from the left on, all j from the top, their values.
    pub fn set_row(&mut self, i: u32, j: u32, values: &[T]) {
        let first = j as usize * self.size.width() as usize + i as usize;
        self.values[first..first + values.len()].copy_from_slice(values);
    }

    /// The rows, from the top.
    pub fn rows(&self) -> impl Iterator<Item = &[T]> {
        self.values.chunks_exact(self.size.width() as usize)
    }
}

#[cfg(test)]
impl Layer<[f32; 3]> {
    /// A picture of soft colours for tests of files.
    pub(crate) fn sample(size: Size) -> Self {
        let mut picture = Layer::filled(size, [0.0; 3]);
        let (across, down) = (size.width() as f32 - 1.0, size.height() as f32 - 1.0);
        for j in 0..size.height() {
            for i in 0..size.width() {
                picture.set(i, j, [i as f32 / across, j as f32 / down, 0.5]);
            }
        }
        picture
    }
}
