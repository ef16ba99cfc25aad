// The members of the uniform block that all drawing programs share, read by GLSL and by C++.
vec4 view_projection[4];   // columns: world to clip space
vec4 light_projection[4];  // columns: world to the shadow map: x, y and depth z, all 0 to 1
vec4 eye;                  // xyz [m]
vec4 light;                // xyz: unit vector toward the key light; w: one texel of the shadow map [m]
vec4 up;                   // xyz: unit vector
// width, height [pixels]; pixels per point (1/720 of the height); size of a pixel at depth 1 m [m]
vec4 picture;
vec4 center;           // xyz of the scene [m]; w: its radius [m]
vec4 ground_origin;    // xyz: the ground under shadow map coordinates (0, 0) [m]; w: depth there
vec4 ground_u;         // step of the same to (1, 0)
vec4 ground_v;         // step of the same to (0, 1)
vec4 grid_x;           // xyz: unit vector along the ground; w: spacing of the fine grid lines [m]
vec4 grid_z;           // xyz: across it; w: strong lines per fine line
vec4 paint[5];         // of the tissue, if there is one only: draw/paint.glsl
vec4 fibers;           // xyz: unit vector along the longest side of the rest shape
vec4 heat_range;       // scalar at 0 of the color map, 1 / (scalar at 1 - it); place of the range's ends in the map
vec4 color_map[7];     // rgb: coefficients of t^0 to t^6, sRGB
vec4 region_color[8];  // rgb, linear
vec4 section;          // xyz: unit normal, w: offset [m] of the plane beyond which nothing is drawn
vec4 spread;           // separate tets: x size of each, y outward shift; depth cue: z strength, w nearest depth [m]
