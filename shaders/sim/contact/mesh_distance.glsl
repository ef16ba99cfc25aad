// Distance to a solid in a closed surface, by quadratic B-splines over a grid (sim/tool/solid_mesh.h).
INPUT_FLOAT(ContactGrid, contact_grid)  // [nodes] of all meshes, x first [m]

// a: first node, spacing; b: nodes along each axis, number of the first one. xyz gradient, w distance [m].
vec4 mesh_distance(vec4 a, vec4 b, vec3 x) {
  vec3 place = (x - a.xyz) / a.w, inner = clamp(place, vec3(0.5), b.xyz - 1.5), middle = min(floor(inner + 0.5), b.xyz - 2.0);
  // Counted from the node, so that only the rounding of x is in it: coordinates in spacings have fewer digits.
  vec3 t = inner == place ? (x - (a.xyz + middle * a.w)) / a.w : inner - middle;
  // Columns: the nodes; rows: the axes.
  mat3 value = mat3(0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t));
  mat3 slope = mat3(t - 0.5, -2.0 * t, t + 0.5);
  uvec3 first = uvec3(middle) - 1u, count = uvec3(b.xyz);
  vec4 sum = vec4(0.0);
  for (uint k = 0u; k < 3u; ++k)
    for (uint j = 0u; j < 3u; ++j) {
      uint node = uint(b.w) + first.x + count.x * (first.y + j + count.y * (first.z + k));
      vec3 d = vec3(FETCH1(contact_grid, node), FETCH1(contact_grid, node + 1u), FETCH1(contact_grid, node + 2u));
      float along = dot(d, vec3(value[0].x, value[1].x, value[2].x)), rise = dot(d, vec3(slope[0].x, slope[1].x, slope[2].x));
      sum += vec4(rise * value[j].y * value[k].z, along * slope[j].y * value[k].z, along * value[j].y * slope[k].z,
                  along * value[j].y * value[k].z);
    }
  sum.xyz /= a.w;
  vec3 away = a.w * (place - inner);
  float beyond2 = dot(away, away);
  if (beyond2 == 0.0) return sum;
  // Outside the grid, a lower bound.
  float distance = sqrt(beyond2 + sum.w * sum.w);
  return vec4((away + sum.w * vec3(equal(away, vec3(0.0))) * sum.xyz) / distance, distance);
}
