//! Values as they are written down and read back, with every bit.

use super::row::Row;

/// Values of one kind, in order.
#[derive(Clone, Debug, PartialEq)]
pub enum Array {
    /// Numbers with a unit, SI.
    Numbers(Vec<f64>),
    /// Counts: steps, ids.
    Counts(Vec<u64>),
}

/// Takes the array `name` out: of a million discs none is kept longer than it is needed.
pub fn take(arrays: &mut Vec<(String, Array)>, name: &str) -> Option<Array> {
    let at = arrays.iter().position(|(of, _)| of == name)?;
    Some(arrays.swap_remove(at).1)
}

/// Takes the rows of the array `name` out, which must be so `many`, or any number of them.
///
/// # Errors
///
/// Names the array, says what it has, and what is wanted.
pub fn rows<T: Row>(
    arrays: &mut Vec<(String, Array)>,
    name: &str,
    many: Option<usize>,
) -> Result<Vec<T>, String> {
    let kind = if T::HAS_COUNTS { "counts" } else { "numbers" };
    let wanted = match many {
        Some(many) => format!("{} {kind} are wanted", many * T::WIDTH),
        None => format!("{} {kind} a row are wanted", T::WIDTH),
    };
    let (length, bits): (usize, Box<dyn Iterator<Item = u64>>) = match take(arrays, name) {
        Some(Array::Numbers(all)) if !T::HAS_COUNTS => {
            (all.len(), Box::new(all.into_iter().map(f64::to_bits)))
        }
        Some(Array::Counts(all)) if T::HAS_COUNTS => (all.len(), Box::new(all.into_iter())),
        _ => return Err(format!("array {name}: {wanted}, there are none")),
    };
    if length % T::WIDTH != 0 || many.is_some_and(|many| length != many * T::WIDTH) {
        return Err(format!("array {name}: it has {length}, {wanted}"));
    }
    let mut bits = bits;
    let mut row = vec![0; T::WIDTH];
    let mut next = |at: usize| {
        row.iter_mut().zip(&mut bits).for_each(|(word, bits)| *word = bits);
        T::of_words(&row).ok_or_else(|| format!("array {name}: row {at} is out of range"))
    };
    (0..length / T::WIDTH).map(&mut next).collect()
}
