//! NumPy arrays of 64-bit floats from `.npy` files, as far as the pictures in `tests/data` need them.
//!
//! In: a file's bytes. Out: rows and numbers. Format: NEP 1, "A Simple File Format for NumPy Arrays", version 1.0.

/// A matrix, row by row.
#[derive(Debug, PartialEq)]
pub(crate) struct Matrix {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    pub(crate) numbers: Vec<f64>,
}

/// Reads a little-endian f64 matrix in C order.
pub(crate) fn matrix(bytes: &[u8]) -> Result<Matrix, String> {
    let Some((b"\x93NUMPY\x01\x00", rest)) = bytes.split_at_checked(8) else {
        return Err("not an .npy file of version 1.0".into());
    };
    let Some((length, rest)) = rest.split_first_chunk::<2>() else { return Err("cut off".into()) };
    let Some((header, data)) = rest.split_at_checked(usize::from(u16::from_le_bytes(*length))) else {
        return Err("cut off".into());
    };
    let header = std::str::from_utf8(header).map_err(|error| error.to_string())?;
    if !header.contains("'<f8'") || !header.contains("'fortran_order': False") {
        return Err(format!("not f64 in C order: {header}"));
    }
    let shape = header.split_once("'shape': (").and_then(|(_, rest)| rest.split_once(')')).map(|(shape, _)| shape);
    let shape: Vec<usize> = shape.unwrap_or("").split(',').filter_map(|part| part.trim().parse().ok()).collect();
    let &[rows, columns] = shape.as_slice() else { return Err(format!("not a matrix: {header}")) };
    if data.len() != rows * columns * 8 {
        return Err(format!("{} bytes for {rows} x {columns}", data.len()));
    }
    let numbers = data.as_chunks::<8>().0.iter().map(|chunk| f64::from_le_bytes(*chunk)).collect();
    Ok(Matrix { rows, columns, numbers })
}

#[test]
fn a_matrix_is_read_and_damage_is_noticed() {
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }\n";
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend_from_slice(&(header.len() as u16).to_le_bytes());
    bytes.extend_from_slice(header.as_bytes());
    bytes.extend_from_slice(&1.5f64.to_le_bytes());
    bytes.extend_from_slice(&f64::INFINITY.to_le_bytes());
    assert_eq!(matrix(&bytes), Ok(Matrix { rows: 1, columns: 2, numbers: vec![1.5, f64::INFINITY] }));
    for cut in [0, 7, 9, 20, bytes.len() - 1] {
        assert!(matrix(&bytes[..cut]).is_err(), "cut at {cut}");
    }
}
