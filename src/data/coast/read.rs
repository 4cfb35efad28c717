//! Reading a coast tile: bytes that anyone may have written.

use super::wire::{Reader, Value};
use super::{Level, MAX_EXTENT, MAX_POINTS, MAX_RIVER_POINTS, Read, Ring, River, Shores, Stream};

pub(super) fn tile(bytes: &[u8]) -> Read<Shores> {
    let mut shores: Option<Shores> = None;
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        let (3, Value::Bytes(bytes)) = (field, value) else { continue };
        let Some(layer) = layer(bytes)? else { continue };
        let all = shores.get_or_insert(Shores { extent: layer.extent, ..none() });
        if all.extent != layer.extent {
            return Err(format!("has layers of {} and {} units", all.extent, layer.extent));
        }
        all.rings.extend(layer.rings);
        all.rivers.extend(layer.rivers);
        let points: usize = all.rings.iter().map(|ring| ring.points.len()).sum();
        if points > MAX_POINTS {
            return Err(format!("has {points} points; at most {MAX_POINTS} are read"));
        }
        let points: usize = all.rivers.iter().map(|river| river.points.len()).sum();
        if points > MAX_RIVER_POINTS {
            return Err(format!("has {points} points of rivers; at most {MAX_RIVER_POINTS} are read"));
        }
    }
    Ok(shores.unwrap_or(none()))
}

fn none() -> Shores {
    Shores { extent: 4096, rings: Vec::new(), rivers: Vec::new() }
}

/// What the lines of a layer are.
#[derive(Clone, Copy)]
enum Kind {
    Border(Level),
    Middle(Stream),
}

/// `None` of a layer of another name.
fn layer(bytes: &[u8]) -> Read<Option<Shores>> {
    let (mut kind, mut extent, mut features) = (None, 4096, Vec::new());
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        match (field, value) {
            (1, Value::Bytes(name)) => {
                let level = Level::ALL.into_iter().find(|level| level.name().as_bytes() == name);
                let stream = Stream::ALL.into_iter().find(|stream| stream.name().as_bytes() == name);
                kind = level.map(Kind::Border).or(stream.map(Kind::Middle));
            }
            (2, Value::Bytes(feature)) => features.push(feature),
            (5, Value::Number(units)) => extent = units,
            _ => {}
        }
    }
    let Some(kind) = kind else { return Ok(None) };
    let units = u32::try_from(extent).ok().filter(|units| (1..=MAX_EXTENT).contains(units));
    let extent = units.ok_or_else(|| format!("has a layer of {extent} units"))? as i32;
    let mut shores = Shores { extent, ..none() };
    for bytes in features {
        feature(bytes, kind, &mut shores)?;
    }
    Ok(Some(shores))
}

fn feature(bytes: &[u8], kind: Kind, to: &mut Shores) -> Read<()> {
    let (mut number, mut geometry) = (0, &[][..]);
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        match (field, value) {
            (3, Value::Number(of_kind)) => number = of_kind,
            (4, Value::Bytes(commands)) => geometry = commands,
            _ => {}
        }
    }
    let (wanted, among) = match kind {
        Kind::Border(_) => (3, "polygons"),
        Kind::Middle(_) => (2, "lines"),
    };
    if number != wanted {
        return Err(format!("has a feature of type {number} among its {among}"));
    }
    let mut reader = Reader::new(geometry);
    let (mut at, mut points) = ([0i32; 2], Vec::new());
    let most = 4 * to.extent.max(256);
    while let Some(command) = reader.number_if_any()? {
        let (id, count) = (command & 7, command >> 3);
        match (id, count, points.len(), kind) {
            (1, 1, 0, _) => points.push(step(&mut reader, &mut at, most)?),
            (2, 1.., 1, _) => {
                // Two numbers of a byte or more each: a count beyond that lies.
                if count > (reader.left() / 2) as u64 {
                    return Err(format!("says that {count} points follow in {} bytes", reader.left()));
                }
                for _ in 0..count {
                    points.push(step(&mut reader, &mut at, most)?);
                }
                if let Kind::Middle(stream) = kind {
                    to.rivers.push(River { stream, points: std::mem::take(&mut points) });
                }
            }
            (7, 1, 3.., Kind::Border(level)) => to.rings.push(Ring { level, points: std::mem::take(&mut points) }),
            (id, count, drawn, _) => {
                return Err(format!("has command {id} for {count} after {drawn} points of a line"));
            }
        }
    }
    match kind {
        _ if points.is_empty() => Ok(()),
        Kind::Border(_) => Err("has a ring that is not closed".into()),
        Kind::Middle(_) => Err("has a river of one point".into()),
    }
}

fn step(reader: &mut Reader<'_>, at: &mut [i32; 2], most: i32) -> Read<[i32; 2]> {
    for place in at.iter_mut() {
        let way = reader.signed()?;
        let sum = i64::from(*place).saturating_add(way);
        if sum.unsigned_abs() > most as u64 {
            return Err(format!("has a point {sum} units from its corner"));
        }
        *place = sum as i32;
    }
    Ok(*at)
}
