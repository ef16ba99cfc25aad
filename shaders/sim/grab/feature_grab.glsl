// Springs that hold single vertices, as the methods that descend the energy see them. Neutral value: stiffness 0.
#if GRAB
INPUT_VEC4(VertexSpring, vertex_spring)  // [vertex_count] xyz target displacement [m], w stiffness [N/m]
vec4 spring_of(uint v) { return FETCH(vertex_spring, v); }
#else
vec4 spring_of(uint v) { return vec4(0.0); }
#endif
