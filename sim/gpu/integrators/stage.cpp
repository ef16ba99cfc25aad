#include "sim/gpu/integrators/stage.h"

namespace fascia {

gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           const Start& start, const ActiveSet* active) {
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"rest_position", &buffers.rest_position},
                                     {"velocity", &buffers.velocity},
                                     {"iterate", &buffers.displacement},
                                     {"displacement", &buffers.displacement},
                                     {"previous_displacement", &buffers.previous_displacement},
                                     {"predicted", &buffers.predicted}};
  if (copy_begin) bindings.emplace_back("copy_begin", copy_begin);
  gl::Defines defines{{"MASS_SPLITTING", copy_begin ? "1" : "0"}, {"START_WITHOUT_GRAVITY", start.gravity ? "0" : "1"}};
  if (start.unconstrained) {
    defines.emplace_back("UNCONSTRAINED", "1");
    bindings.emplace_back("unconstrained", start.unconstrained);
  }
  if (active) {
    defines.emplace_back("LISTED", "1");
    bindings.emplace_back("item_list", &active->vertices);
  }
  if (buffers.earlier_displacement) {
    defines.emplace_back("EXTRAPOLATES", "1");
    bindings.emplace_back("earlier_displacement", &buffers.earlier_displacement);
    bindings.emplace_back("earlier_velocity", &buffers.earlier_velocity);
  }
  gl::ComputePass pass(programs.compute("sim/step/predict.comp", defines), std::move(bindings), buffers.vertex_count);
  pass.loops(0);
  if (active) {
    pass.follow("invocations", active->vertex_count);
    pass.follow("moving_count", active->moving_count);
  }
  return pass;
}

gl::ComputePass centroid_prediction(const Recording& r) {
  gl::ComputePass pass = r.over_quadratic("sim/quadratic/quadratic_predict.comp", {},
                                          {{"step", &r.buffers.step},
                                           {"tet_vertices", &r.buffers.tet_vertices},
                                           {"tet_shape", &r.buffers.tet_shape},
                                           {"mid_edges", &r.buffers.mid_edges},
                                           {"predicted", &r.buffers.predicted},
                                           {"predicted_centroid", &r.buffers.predicted_centroid}});
  pass.loops(0);
  return pass;
}

Passes strains_at_start(const Recording& r) {
  gl::Defines defines;
  gl::ComputePass::Bindings bindings{{"previous_displacement", &r.buffers.previous_displacement},
                                     {"previous_strain", &r.previous_strain}};
  if (r.buffers.earlier_displacement) {
    defines.emplace_back("EXTRAPOLATES", "1");
    bindings = {{"step", &r.buffers.step},
                {"previous_displacement", &r.buffers.displacement},
                {"earlier_displacement", &r.buffers.earlier_displacement},
                {"previous_strain", &r.previous_strain}};
  }
  Passes passes;
  if (r.buffers.has_linear())
    passes.push_back(r.over_pairs("sim/step/previous_strain.comp", defines, with_pairs(bindings, r.buffers)).loops(0));
  if (r.buffers.has_quadratic())
    passes.push_back(
        r.over_quadratic("sim/quadratic/quadratic_strain.comp", defines, with_quadratic(bindings, r.buffers)));
  return passes;
}

gl::ComputePass velocity_update(const Recording& r) {
  gl::Defines defines;
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"displacement", &r.buffers.displacement},
                                     {"previous_displacement", &r.buffers.previous_displacement},
                                     {"predicted", &r.buffers.predicted},
                                     {"velocity_before", &r.buffers.velocity},
                                     {"velocity", &r.buffers.velocity},
                                     {"diverged", &r.buffers.diverged}};
  if (r.buffers.earlier_displacement) {
    defines.emplace_back("EXTRAPOLATES", "1");
    bindings.emplace_back("earlier_velocity", &r.buffers.earlier_velocity);
  }
  return r.over_vertices("sim/step/velocity.comp", defines, std::move(bindings));
}

}  // namespace fascia
