// Shallow water holds no higher waves: the share of theirs that a depth allows.
#import frame

// Of waves over the open sea's as `height`.
fn held_share(depth: Metres, height: f32) -> f32 { return clamp(depth * HELD_BY_DEPTH / max(height * frame.wave_height, 1e-3), 0.0, 1.0); }
