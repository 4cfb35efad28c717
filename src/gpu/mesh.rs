//! Triangles of regular grids.

/// Vertex indices of the two triangles of each cell of a grid of `columns` by `rows` cells, whose vertices stand row by row.
pub fn grid_triangles(columns: u32, rows: u32) -> Vec<u32> {
    let across = columns + 1;
    let cell = |column: u32, row: u32| {
        let v = row * across + column;
        [v, v + 1, v + across, v + 1, v + across + 1, v + across]
    };
    (0..rows).flat_map(|row| (0..columns).flat_map(move |column| cell(column, row))).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_cell_is_covered_once_and_all_triangles_turn_the_same_way() {
        let triangles = super::grid_triangles(3, 2);
        assert_eq!(triangles.len(), 3 * 2 * 6);
        let at = |v: u32| (i64::from(v % 4), i64::from(v / 4));
        for t in triangles.chunks(3) {
            let [(ax, ay), (bx, by), (cx, cy)] = [at(t[0]), at(t[1]), at(t[2])];
            // Twice the signed area: half a cell each, so six cells in all.
            assert_eq!((bx - ax) * (cy - ay) - (by - ay) * (cx - ax), 1);
        }
    }
}
