// Shallow water holds no higher waves: the share of theirs that a depth allows.
#import frame

fn held_share(depth: Metres) -> f32 { return clamp(depth * HELD_BY_DEPTH / max(frame.wave_height, 1e-3), 0.0, 1.0); }
