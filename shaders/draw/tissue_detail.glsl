// Patches, lines and bumps of tissue, from noise in rest coordinates, so that they are fixed to the tissue however it
// deforms. Waves shorter than two pixels fade out.
in vec3 rest;   // [m]
in vec3 place;  // of the same point now [m]

struct Detail {
  vec3 color;   // factor
  float lines;  // 0 to 1: share of the lines' color
  float film;   // 0 to 1: share of the wetness
  vec3 normal;
};

float lattice(uvec3 cell) {
  uint h = cell.x * 0x8da6b343u + cell.y * 0xd8163841u + cell.z * 0xcb1ab31fu;  // large primes
  h ^= h >> 15u;
  h *= 0x2c1b3c6du;
  h ^= h >> 13u;
  return float(h >> 8u) * (1.0 / 16777216.0);
}

// Noise from -1 to 1 in x and its gradient in yzw: random values on a lattice, interpolated by quintics (Perlin 2002).
vec4 noise(vec3 p) {
  vec3 whole = floor(p), f = p - whole;
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0), du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  uvec3 c = uvec3(ivec3(whole));
  vec4 low = vec4(lattice(c), lattice(c + uvec3(1, 0, 0)), lattice(c + uvec3(0, 1, 0)), lattice(c + uvec3(1, 1, 0)));
  vec4 high = vec4(lattice(c + uvec3(0, 0, 1)), lattice(c + uvec3(1, 0, 1)), lattice(c + uvec3(0, 1, 1)),
                   lattice(c + uvec3(1, 1, 1)));
  vec4 along_z = mix(low, high, u.z), step_z = high - low;
  vec2 along_y = mix(along_z.xy, along_z.zw, u.y), step_y = along_z.zw - along_z.xy,
       rise_z = mix(step_z.xy, step_z.zw, u.y);
  float value = mix(along_y.x, along_y.y, u.x);
  vec3 gradient = vec3(along_y.y - along_y.x, mix(step_y.x, step_y.y, u.x), mix(rise_z.x, rise_z.y, u.x)) * du;
  return vec4(2.0 * value - 1.0, 2.0 * gradient);
}

// The normal of the surface raised by a height with this gradient in rest coordinates (Mikkelsen 2010, with the
// gradient carried from rest to the deformed surface by the derivatives of both along the picture).
vec3 bumped(vec3 n, vec3 gradient) {
  vec3 dx = dFdx(place), dy = dFdy(place), r1 = cross(dy, n), r2 = cross(n, dx);
  float area = dot(dx, r1);
  vec3 slope = (dot(gradient, dFdx(rest)) * r1 + dot(gradient, dFdy(rest)) * r2) / max(abs(area), 1e-20);
  slope = (area < 0.0 ? -1.0 : 1.0) * slope;
  return normalize(n - slope);
}

Detail detail(vec3 n) {
  vec4 structure = paint_structure();
  // Fibers: coordinates along them are shorter.
  vec3 fibers = frame.fibers.xyz;
  vec3 p = structure.x * (rest - fibers * dot(rest, fibers) * (1.0 - 1.0 / structure.y));
  float pixel = max(length(dFdx(p)), length(dFdy(p)));  // [patches]
  const mat3 turn = mat3(0.48, 0.60, -0.64, -0.80, 0.60, 0.0, 0.36, 0.512, 0.768);  // between octaves
  vec4 octave[5];
  float frequency[5] = float[5](1.0, 2.3, 5.1, 11.0, 23.0), strength[5];
  mat3 turned = mat3(1.0);
  for (int k = 0; k < 5; ++k) {
    strength[k] = clamp(2.0 - 4.0 * pixel * frequency[k], 0.0, 1.0);
    octave[k] = noise(frequency[k] * (turned * p) + 17.0 * float(k));
    octave[k].yzw = frequency[k] * (octave[k].yzw * turned);
    turned = turn * turned;
  }
  Detail result;
  vec4 patches = paint_patches();
  float broad = octave[0].x + 0.6 * strength[1] * octave[1].x + 0.35 * strength[2] * octave[2].x;
  float fine = 0.6 * strength[3] * octave[3].x + 0.5 * strength[4] * octave[4].x;
  float patch_here = clamp(0.5 + 0.55 * broad + 0.35 * fine, 0.0, 1.0);
  result.color = mix(vec3(1.0), patches.rgb, patches.w * patch_here);
  // Lines follow where noise is zero; its gradient makes them equally wide. Broad noise interrupts them.
  float share = paint_lines().w;
  vec4 way = octave[1] + 0.35 * strength[2] * octave[2];
  float off = abs(way.x) / max(length(way.yzw), 0.5);
  float width = 0.12 * share * (0.6 + 0.8 * clamp(0.5 + octave[0].x, 0.0, 1.0));
  result.lines = (1.0 - smoothstep(0.5 * width, width + 1.5 * pixel, off)) * step(0.001, share) *
                 clamp(width / (2.0 * pixel + 1e-6), 0.0, 1.0) * smoothstep(-0.5, 0.2, octave[0].x + 0.5 * share);
  vec3 rise = 0.30 * octave[1].yzw / 2.3 + 0.35 * strength[2] * octave[2].yzw / 5.1 +
              0.35 * strength[3] * octave[3].yzw / 11.0 + 0.18 * strength[4] * octave[4].yzw / 23.0;
  rise -= fibers * dot(rise, fibers) * (1.0 - 1.0 / structure.y);
  result.normal = bumped(n, structure.z * rise);
  result.film = 1.0 - 0.4 * patch_here;
  return result;
}
