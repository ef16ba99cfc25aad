// Springs at single vertices: E = 1/2 k |u - target|^2.
INPUT_VEC4(VertexSpring, vertex_spring)  // [vertex_count] xyz target displacement [m], w stiffness [N/m], 0 without a
                                         // spring

vec4 grab_gradient(uint v, vec3 u, float scale) {
  vec4 spring = FETCH(vertex_spring, v);
  vec3 stretch = u - spring.xyz;
  float k = scale * spring.w;
  return vec4(k * stretch, k * dot(stretch, stretch));
}

float grab_stiffness(uint v, float scale) { return scale * FETCH(vertex_spring, v).w; }
