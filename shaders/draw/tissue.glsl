// Outputs of the vertex shaders of tissue: to surface.frag, or with DEPTH_ONLY to the shadow map.
#if !DEPTH_ONLY
out vec3 to_eye;
out vec3 surface_normal;
#if HEAT_MAP
out float heat;
#endif
#if SHADOW
out vec3 shadow_position;
#endif
#if DETAIL
out vec3 rest, place;
#endif
#if WIREFRAME
out vec3 barycentric;
#endif
#endif

// `position` xyz [m], w scalar of the heat map.
void hand_on(vec4 position, vec3 normal) {
#if DEPTH_ONLY
  gl_Position = vec4(2.0 * to_shadow(position.xyz) - 1.0, 1.0);
#else
  gl_Position = to_clip(position.xyz);
  to_eye = normalize(frame.eye.xyz - position.xyz);
  surface_normal = normal;
#if DETAIL
  place = position.xyz;
#endif
#if HEAT_MAP
  heat = (position.w - frame.heat_range.x) * frame.heat_range.y;
#endif
#if SHADOW
  // The lookup is slightly off the surface, farther at grazing light: that removes self-shadowing without moving the
  // shadow's foot.
  float slope = 1.0 - max(dot(normal, frame.light.xyz), 0.0);
  shadow_position = to_shadow(position.xyz + normal * frame.light.w * (1.0 + 2.5 * slope));
  shadow_position.z = min(shadow_position.z, 1.0);  // limit of the map's range
#endif
#endif
}

// Output for a triangle that is not drawn: all three vertices are the same.
void grab_on_nothing() {
  hand_on(vec4(0.0), vec3(0.0));
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
