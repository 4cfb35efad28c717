//! Coast tiles that are damaged or made to harm, as in `hostile_data`.

use ocean_globe::data::coast::Shores;

/// A number of protocol buffers.
fn varint(mut number: u64) -> Vec<u8> {
    let mut bytes = Vec::new();
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
    bytes
}

/// A field of bytes.
fn field(number: u64, bytes: &[u8]) -> Vec<u8> {
    [varint(number << 3 | 2), varint(bytes.len() as u64), bytes.to_vec()].concat()
}

/// A coast tile of one feature of land.
fn coast_tile(kind: u64, extent: u64, commands: &[u64]) -> Vec<u8> {
    tile_of(b"land", kind, extent, commands)
}

/// A coast tile of one feature of a layer.
fn tile_of(layer: &[u8], kind: u64, extent: u64, commands: &[u64]) -> Vec<u8> {
    let geometry: Vec<u8> = commands.iter().copied().flat_map(varint).collect();
    let feature = [vec![0x18], varint(kind), field(4, &geometry)].concat();
    field(3, &[vec![0x78, 2], field(1, layer), field(2, &feature), vec![0x28], varint(extent)].concat())
}

#[test]
fn coast_tiles_that_lie_are_refused() {
    let command = |id: u64, count: u64| count << 3 | id;
    let good = [command(1, 1), 20, 20, command(2, 3), 200, 0, 0, 200, 199, 0, command(7, 1)];
    let shores = Shores::decode("tile", &coast_tile(3, 4096, &good)).unwrap();
    assert_eq!(shores.rings[0].points, [[10, 10], [110, 10], [110, 110], [10, 110]]);
    let huge = u64::MAX;
    for (kind, extent, commands, part) in [
        (2, 4096, &good[..], "type 2"),
        (3, 0, &good, "0 units"),
        (3, 1 << 40, &good, "units"),
        (3, 4096, &good[..10], "not closed"),
        (3, 4096, &good[..8], "ends early"),
        (3, 4096, &[command(2, 1), 0, 0], "command 2"),
        (3, 4096, &[command(1, 2), 0, 0, 2, 2], "command 1"),
        (3, 4096, &[command(1, 1), 0, 0, command(7, 1)], "command 7"),
        (3, 4096, &[command(1, 1), 0, 0, command(2, 1 << 60), 0, 0], "points follow"),
        (3, 4096, &[command(5, 1)], "command 5"),
        (3, 4096, &[command(1, 1), 1 << 40, 0], "from its corner"),
        (3, 4096, &[command(1, 1), huge, huge], "from its corner"),
        (3, 4096, &[command(1, 1), 0], "ends early"),
    ] {
        let error = Shores::decode("tile 1/2/3", &coast_tile(kind, extent, commands)).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("tile 1/2/3"), "{commands:?}: {error}");
    }
    for (bytes, part) in [
        (&[0x1a, 0xff, 0xff, 0xff, 0xff, 0x0f][..], "ends early"),
        (&[0x1b], "unknown kind 3"),
        (&[0xff; 11], "more than 64 bits"),
    ] {
        let error = Shores::decode("tile", bytes).unwrap_err().to_string();
        assert!(error.contains(part), "{bytes:?}: {error}");
    }
    // Another layer is somebody else's; a tile without any is open sea.
    assert!(Shores::decode("tile", &field(3, &field(1, b"roads"))).unwrap().rings.is_empty());
    assert!(Shores::decode("tile", b"").unwrap().rings.is_empty());
}

#[test]
fn rivers_that_lie_are_refused() {
    let command = |id: u64, count: u64| count << 3 | id;
    let good = [command(1, 1), 20, 20, command(2, 2), 200, 0, 0, 200, command(1, 1), 2, 2, command(2, 1), 2, 2];
    let shores = Shores::decode("tile", &tile_of(b"river", 2, 4096, &good)).unwrap();
    assert_eq!(shores.rivers[0].points, [[10, 10], [110, 10], [110, 110]]);
    assert_eq!(shores.rivers[1].points, [[111, 111], [112, 112]]);
    let many = |count: u64| [vec![command(1, 1), 2, 2, command(2, count)], vec![2; 2 * count as usize]].concat();
    assert!(Shores::decode("tile", &tile_of(b"tributary", 2, 1 << 16, &many(16_383))).is_ok());
    for (kind, commands, part) in [
        (3, good.to_vec(), "type 3"),
        (2, good[..3].to_vec(), "one point"),
        (2, good[..6].to_vec(), "points follow"),
        (2, [&good[..8], &[command(7, 1)]].concat(), "command 7"),
        (2, [&good[..8], &[command(2, 1), 2, 2]].concat(), "command 2"),
        (2, vec![command(1, 1), 1 << 40, 0], "from its corner"),
        (2, many(16_384), "16385 points of rivers"),
    ] {
        let error =
            Shores::decode("tile 1/2/3", &tile_of(b"tributary", kind, 1 << 16, &commands)).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("tile 1/2/3"), "{part}: {error}");
    }
}
