// The paint of the tissue at a pixel, as packed() of render/view/tissue_paint.h fills it: that of the frame, or with
// PAINTS that of the triangle's region.
#if REGIONS || PAINTS
layout(binding = 4) uniform usamplerBuffer region;  // per item of TRIANGLES triangles
uint region_here() { return texelFetch(region, gl_PrimitiveID / TRIANGLES).x; }
#endif
#if PAINTS
layout(binding = 7) uniform samplerBuffer paints;
vec4 paint(int part) { return texelFetch(paints, 5 * int(region_here()) + part); }
#else
vec4 paint(int part) { return frame.paint[part]; }
#endif

vec4 paint_color() { return paint(0); }      // rgb; w 1 where it replaces the colors of corners
vec4 paint_patches() { return paint(1); }    // rgb factor of the color in patches; w their strength
vec4 paint_lines() { return paint(2); }      // rgb; w share of the surface
vec4 paint_structure() { return paint(3); }  // patches per meter, stretch along the fibers, slope of bumps, wetness
vec3 paint_wrap() { return paint(4).rgb; }   // how far light passes the terminator, as a cosine
