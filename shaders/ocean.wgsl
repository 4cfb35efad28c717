// The sea, shaded where its mesh is drawn: in coarse pictures and large ones, in those whose pixels have several samples or that show a lake's mesh, in measured
// layers, and for an eye in it. Others are drawn by sea_places.wgsl and sea_of_places.wgsl.
#import sea_vertex
#import sea_pixel

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let own = Patch(in.rest, in.moved, in.height, in.incoming, in.shadow, in.grid, in.ahead, length(dpdx(in.rest)), length(dpdy(in.rest)));
    let found = sea_pixel(own, vec2u(in.position.xy));
    if !found.is_sea { discard; }
    return found.colour;
}
