//! Lists of few cells of many, as the bundled pictures of lights and of towns are kept.

/// Cells and their values: of each the cells from the last one that has a value to it (base 128, little-endian), and a byte.
pub fn cells(bytes: &'static [u8]) -> impl Iterator<Item = (u64, u8)> {
    let mut bytes = bytes.iter().copied();
    let mut next = 0;
    std::iter::from_fn(move || {
        let mut gap = 0;
        for shift in (0..).step_by(7) {
            let byte = bytes.next()?;
            gap |= u64::from(byte & 127) << shift;
            if byte < 128 {
                break;
            }
        }
        let cell = next + gap;
        next = cell + 1;
        Some((cell, bytes.next()?))
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn gaps_add_up() {
        let bytes: &[u8] = &[0, 7, 200, 1, 9, 3, 255];
        assert_eq!(super::cells(bytes).collect::<Vec<_>>(), [(0, 7), (201, 9), (205, 255)]);
        assert_eq!(super::cells(&bytes[..6]).count(), 2, "the last value is missing");
    }
}
