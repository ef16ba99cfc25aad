#include "sim/gpu/surface_positions.h"

namespace fascia {

SurfacePositions::SurfacePositions(const SimBuffers& buffers)
    : positions_("positions", buffers.vertex_count * sizeof(shared::vec4)) {}

void SurfacePositions::record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
                              ColorBy color) {
  passes_.clear();
  gl::ComputePass::Bindings publish{{"rest_position", &buffers.rest_position},
                                    {"displacement", &buffers.displacement},
                                    {"position", &positions_}};
  const bool heat = color != ColorBy::none;
  if (heat) {
    gl::Defines defines = defines_of({features.material_per_tet, false});
    defines.emplace_back("HEAT_STRAIN", color == ColorBy::strain ? "1" : "0");
    gl::ComputePass::Bindings tet{{"step", &buffers.step},
                                  {"tet_vertices", &buffers.tet_vertices},
                                  {"tet_shape", &buffers.tet_shape},
                                  {"tet_slots", &buffers.tet_slots},
                                  {"displacement", &buffers.displacement},
                                  {"correction", &buffers.correction}};
    passes_.emplace_back(programs.compute("sim/heat_tet.comp", defines),
                         with_material(std::move(tet), features, buffers), buffers.tet_count);
    publish.emplace_back("slot_begin", &buffers.slot_begin);
    publish.emplace_back("correction", &buffers.correction);
  }
  passes_.emplace_back(programs.compute("sim/publish.comp", {{"HEAT", heat ? "1" : "0"}}), std::move(publish),
                       buffers.vertex_count);
}

void SurfacePositions::run() const {
  for (const gl::ComputePass& pass : passes_) pass.run();
}

}  // namespace fascia
