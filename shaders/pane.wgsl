// One colour over all of the viewport; src/app/pane.rs says COLOUR: as the target takes it, multiplied by its alpha.
#import full_screen

@fragment
fn fragment() -> @location(0) vec4f { return COLOUR; }
