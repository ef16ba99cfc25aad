// The passes of contact within a step: which points are near, where bodies meet, forces, curvatures and memory.
#include <set>

#include "sim/contact/contact_block.h"
#include "sim/gpu/contact/contact_term.h"
#include "sim/gpu/contact/piece_rows.h"
#include "sim/gpu/passes/recording.h"
#include "sim/tool/tool_entry.h"

namespace fascia {

std::optional<std::string> ContactTerm::define(TermUse use) const {
  if (use == TermUse::gradient) return "1";
  if (use == TermUse::block) return "2";
  return std::nullopt;
}

void ContactTerm::bind(TermUse use, gl::ComputePass::Bindings& bindings) const {
  if (sums_) {
    bindings.emplace_back("contact_sums", &sums_);
    return;
  }
  bind_entries(bindings);
  if (use == TermUse::gradient)
    bindings.emplace_back("contact_force", &forces_);
  else
    bindings.emplace_back("contact_block", &blocks_);
}

void ContactTerm::bind_entries(gl::ComputePass::Bindings& bindings) const {
  bindings.insert(bindings.end(), {{"contact_begin", &begin_}, {"contact_end", &end_}, {"contact_entries", &entries_}});
}

gl::Defines ContactTerm::defines() const {
  std::set<int> kinds;
  for (const ContactPiece& piece : surface_.pieces) kinds.insert(piece_rows_of(tools_[piece.tool].shape).kind);
  gl::Defines defines = defines_of_shapes(kinds);
  defines.emplace_back("PAIRS", pairs_.empty() ? "0" : "1");
  return defines;
}

std::uint32_t ContactTerm::loops_of_point() const {
  constexpr std::uint32_t kOfGrid = 13;  // shaders/sim/contact/mesh_distance.glsl
  return static_cast<std::uint32_t>(surface_.pieces.size()) * (grids_ ? kOfGrid : 1) + 1;
}

EnergyTerm::Passes ContactTerm::find_near(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  gl::ComputePass::Bindings bindings{{"contact_pieces", &pieces_},
                                     {"contact_vertices", &vertices_},
                                     {"contact_weights", &weights_},
                                     {"contact_rest", &rest_},
                                     {"start_displacement", &buffers.start_of_stage()},
                                     {"displacement", &buffers.displacement},
                                     {"contact_memory", &buffers.contact_memory},
                                     {"contact_before", &buffers.contact_before},
                                     {"contact_near", &near_},
                                     {"contact_anchor", &rows_},
                                     {"contact_force", &forces_},
                                     {"contact_block", &blocks_}};
  gl::ComputePass::Bindings of_near = bindings;
  of_near.emplace_back("contact_counts", &counts_);
  if (grids_) of_near.emplace_back("contact_grid", &grids_);
  gl::Defines near = defines();
  near.insert(near.end(), {{"STRETCH", std::to_string(kStretch)}, {"CROWDED", crowds_ ? "1" : "0"}});
  gl::ComputePass::Constants constants{{"pieces", static_cast<std::uint32_t>(surface_.pieces.size())}};
  Passes passes;
  if (doubtful_) {
    constants.insert(constants.end(), {{"deferred_list", 0}, {"deferred_begin", 4}});
    bindings.emplace_back("deferred", &doubtful_->lists);
    gl::Defines doubtful = defines();
    for (auto& [name, value] : doubtful)
      if (name == "MESHES") value = "0";
    passes.emplace_back(programs.compute("sim/contact/contact_doubtful.comp", doubtful), std::move(bindings),
                        point_count(), constants);
    passes.back().copy_first(doubtful_->none, doubtful_->lists);
    near.emplace_back("DEFERRED", "1");
    of_near.emplace_back("deferred_items", &doubtful_->lists);
  }
  passes.emplace_back(programs.compute("sim/contact/contact_near.comp", near), std::move(of_near), point_count(),
                      std::move(constants));
  if (doubtful_) passes.back().set_indirect(doubtful_->lists, 0);
  for (gl::ComputePass& pass : passes) pass.loops(loops_of_point());
  return passes;
}

gl::ComputePass ContactTerm::over_near(gl::ProgramCache& programs, const char* kernel, gl::ComputePass::Bindings more,
                                       const gl::Defines& defined) const {
  more.insert(more.end(), {{"contact_pieces", &pieces_},
                           {"contact_vertices", &vertices_},
                           {"contact_weights", &weights_},
                           {"contact_rest", &rest_},
                           {"contact_normal", &normals_},
                           {"contact_near", &near_},
                           {"deferred_items", &list_}});
  if (grids_) more.emplace_back("contact_grid", &grids_);
  gl::ComputePass::Constants constants{{"deferred_list", 0}, {"deferred_begin", 4}};
  if (!pairs_.empty()) {
    more.emplace_back("contact_pairs", &constants_);
    constants.emplace_back("points", point_count());
  }
  gl::Defines listed = defines();
  listed.insert(listed.end(), defined.begin(), defined.end());
  listed.emplace_back("DEFERRED", "1");
  listed.emplace_back("STICKING", std::to_string(kStickingPenalty));
  gl::ComputePass pass(programs.compute(kernel, listed), std::move(more), point_count() + pairs_.slot_count(),
                       std::move(constants));
  pass.loops(loops_of_point());
  pass.set_indirect(list_, 0);
  return pass;
}

EnergyTerm::Passes ContactTerm::over_touched(gl::ProgramCache& programs, const char* kernel, gl::Defines defines,
                                             gl::ComputePass::Bindings bindings) const {
  defines.emplace_back("DEFERRED", "1");
  bindings.emplace_back("deferred_items", &list_);
  Passes passes;
  for (const std::uint32_t list : {touched_list(), few_list()}) {
    if (list == few_list() && !sums_) break;
    gl::ComputePass pass(programs.compute(kernel, defines), bindings, buffers_.vertex_count,
                         {{"deferred_list", list}, {"deferred_begin", list + 4}});
    pass.loops(2 * most_entries_ + 2);
    pass.set_indirect(list_, list);
    passes.push_back(std::move(pass));
  }
  return passes;
}

EnergyTerm::Passes ContactTerm::begin(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  const gl::ComputePass::Bindings places{{"start_displacement", &buffers.start_of_stage()},
                                         {"displacement", &buffers.displacement},
                                         {"contact_near", &near_}};
  Passes passes;
  if (!surface_.empty()) append(passes, find_near(programs, buffers));
  passes
      .emplace_back(
          programs.compute("sim/contact/contact_list.comp", {{"STRETCH", std::to_string(kStretch)}}),
          gl::ComputePass::Bindings{{"contact_near", &near_}, {"contact_counts", &counts_}, {"contact_list", &list_}},
          stretches(),
          gl::ComputePass::Constants{{"points", point_count()},
                                     {"stretches", stretches()},
                                     {"touched_list", touched_list()},
                                     {"few_list", few_list()}})
      .loops(stretches() + kStretch + 1);
  gl::ComputePass::Bindings touched{{"contact_begin", &begin_},   {"contact_entries", &entries_},
                                    {"contact_near", &near_},     {"contact_end", &end_},
                                    {"contact_counts", &counts_}, {"contact_list", &list_}};
  if (sums_) touched.emplace_back("contact_sums", &sums_);
  gl::Defines counting = defines_of_shapes({});
  counting.emplace_back("CROWDED", crowds_ ? "1" : "0");
  if (crowds_)
    touched.insert(touched.end(),
                   {{"contact_pieces", &pieces_}, {"contact_anchor", &rows_}, {"contact_crowds", &crowds_}});
  passes
      .emplace_back(programs.compute("sim/contact/contact_touched.comp", counting), std::move(touched),
                    buffers.vertex_count,
                    gl::ComputePass::Constants{
                        {"touched_list", touched_list()}, {"few_list", few_list()}, {"stretches", stretches()}})
      .loops((most_entries_ + 1) * (crowds_ ? static_cast<std::uint32_t>(surface_.pieces.size()) + 1 : 1) + 5);
  if (surface_.empty()) return passes;
  gl::ComputePass::Bindings listed = places;
  listed.insert(listed.end(),
                {{"step", &buffers.step}, {"contact_bodies", &starts_.bodies()}, {"contact_anchor", &rows_}});
  gl::ComputePass::Bindings support = listed;
  gl::ComputePass::Constants constants;
  support.emplace_back("contact_memory", &buffers.contact_memory);
  if (crowds_) {
    support.emplace_back("contact_crowds", &crowds_);
    constants.emplace_back("vertex_count", buffers.vertex_count);
  }
  passes.push_back(start_of_near(programs, "sim/contact/contact_support.comp", std::move(support), constants));
  listed.emplace_back("contact_normal_now", &normals_);
  passes.push_back(start_of_near(programs, "sim/contact/contact_start.comp", std::move(listed), {}));
  return passes;
}

gl::ComputePass ContactTerm::start_of_near(gl::ProgramCache& programs, const char* kernel,
                                           gl::ComputePass::Bindings more, gl::ComputePass::Constants constants) const {
  more.insert(more.end(), {{"contact_pieces", &pieces_},
                           {"contact_vertices", &vertices_},
                           {"contact_weights", &weights_},
                           {"contact_rest", &rest_},
                           {"deferred_items", &list_}});
  if (grids_) more.emplace_back("contact_grid", &grids_);
  gl::Defines listed = defines();
  listed.emplace_back("DEFERRED", "1");
  listed.emplace_back("ENTRY_STEPS", std::to_string(kEntrySteps));
  listed.emplace_back("STICKING", std::to_string(kStickingPenalty));
  listed.emplace_back("CROWDED", crowds_ ? "1" : "0");
  constants.insert(
      constants.end(),
      {{"deferred_list", 0}, {"deferred_begin", 4}, {"bodies", starts_.body_count()}, {"points", point_count()}});
  gl::ComputePass pass(programs.compute(kernel, listed), std::move(more), point_count() + pairs_.slot_count(),
                       std::move(constants));
  pass.loops((2 * kEntrySteps + 10) * loops_of_point());
  pass.set_indirect(list_, 0);
  return pass;
}

EnergyTerm::Passes ContactTerm::advance(const Recording& r, const gl::Buffer& step) const {
  return {r.over_vertices("sim/contact/contact_advance.comp", {},
                          {{"step", &r.buffers.step},
                           {"contact_bodies", &starts_.bodies()},
                           {"contact_body", &starts_.body_of_vertex()},
                           {"iterate", &r.buffers.displacement},
                           {"displacement", &r.buffers.displacement},
                           {"last_step", &step}},
                          {{"bodies", starts_.body_count()}})};
}

EnergyTerm::Passes ContactTerm::evaluate(gl::ProgramCache& programs, const SimBuffers& buffers,
                                         const VertexBlocks* blocks) const {
  Passes passes{over_near(programs, "sim/contact/contact_force.comp",
                          {{"displacement", &buffers.displacement},
                           {"contact_memory", &buffers.contact_memory},
                           {"contact_anchor", &rows_},
                           {"contact_force", &forces_},
                           {"contact_block", &blocks_},
                           {"contact_pressing", &pressing_}})};
  if (!sums_) return passes;
  gl::ComputePass::Bindings bindings{
      {"step", &buffers.step}, {"contact_force", &forces_}, {"contact_block", &blocks_}, {"contact_sums", &sums_}};
  bind_entries(bindings);
  if (blocks)
    bindings.insert(bindings.end(),
                    {{"sums_before", &sums_}, {"block_free", &blocks->free}, {"block_inverse", &blocks->inverse}});
  append(passes, over_touched(programs, "sim/contact/contact_gather.comp", {{"INVERTS", blocks ? "1" : "0"}},
                              std::move(bindings)));
  return passes;
}

EnergyTerm::Passes ContactTerm::finish(gl::ProgramCache& programs, const SimBuffers& buffers, bool moves_bodies) const {
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"displacement", &buffers.displacement},
                                     {"contact_memory_now", &buffers.contact_memory},
                                     {"contact_row", &rows_},
                                     {"contact_force", &forces_}};
  if (moves_bodies) bindings.emplace_back("contact_moved", &moved_rows_);
  return {over_near(programs, "sim/contact/contact_finish.comp", std::move(bindings),
                    {{"MOVED_BODIES", moves_bodies ? "1" : "0"}})};
}

std::uint32_t ContactTerm::curvature_partials(const gl::ProgramCache& programs) const {
  return Reduction(programs, point_count() + pairs_.slot_count()).partials;
}

EnergyTerm::Passes ContactTerm::curvature(gl::ProgramCache& programs, const SimBuffers& buffers,
                                          const TermCurvature& at) const {
  const std::uint32_t most = point_count() + pairs_.slot_count();
  const Reduction sum(programs, most);
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},          {"contact_vertices", &vertices_},
                                     {"contact_weights", &weights_},   {"contact_block", &blocks_},
                                     {"contact_pressing", &pressing_}, {"contact_along", &along_},
                                     {"contact_list", &list_},         {"fine_direction", &at.fine_direction},
                                     {"last_step", &at.last_step},     {"curvature_partials", &at.partials}};
  if (at.coarse_direction) bindings.emplace_back("coarse_direction", at.coarse_direction);
  Passes passes;
  passes
      .emplace_back(programs.compute("sim/contact/contact_curvature.comp", {{"SPLIT", at.coarse_direction ? "1" : "0"},
                                                                            {"PAIRS", pairs_.empty() ? "0" : "1"}}),
                    std::move(bindings), sum.lanes, gl::ComputePass::Constants{{"first_partial", at.first_partial}})
      .loops(most / sum.lanes + 2);
  return passes;
}

// As shaders/sim/two_level/pressing_step.glsl goes over them: in passes, the first one at the start, over slices, each
// of which an invocation has in parts of eight rows, and then over the sums of the slices.
std::optional<PressingRows> ContactTerm::pressing() const {
  constexpr std::uint32_t kPasses = 7, kSlices = 64, kPart = 8;
  constexpr std::uint32_t kSlicesOfInvocation = kSlices / 4;  // where vectors are narrow
  const std::uint32_t most = point_count() + pairs_.slot_count();
  const std::uint32_t of_slice = most / (kPart * kSlices) + 2;
  return PressingRows{along_, list_, kPasses * (kSlicesOfInvocation * (of_slice + 1) + kSlices + 1)};
}

EnergyTerm::Passes ContactTerm::impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  Passes passes;
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"contact_force", &forces_},
                                     {"rest_position", &buffers.rest_position},
                                     {"slot_begin", &buffers.slot_begin},
                                     {"correction", &buffers.correction}};
  bind_entries(bindings);
  passes.emplace_back(programs.compute("sim/contact/contact_impulse.comp"), std::move(bindings), buffers.vertex_count);
  if (!surface_.empty()) passes.push_back(load_pass(programs));
  return passes;
}

gl::ComputePass ContactTerm::load_pass(gl::ProgramCache& programs) const {
  gl::Defines defines = defines_of_shapes({});
  defines.emplace_back("LOAD_LANES", std::to_string(kLoadLanes));
  gl::ComputePass pass(programs.compute("sim/contact/contact_load.comp", defines),
                       {{"contact_pieces", &pieces_},
                        {"contact_vertices", &vertices_},
                        {"contact_weights", &weights_},
                        {"contact_rest", &rest_},
                        {"displacement", &buffers_.displacement},
                        {"contact_row", &rows_},
                        {"contact_memory", &buffers_.contact_memory},
                        {"contact_before", &buffers_.contact_before},
                        {"rest_position", &buffers_.rest_position},
                        {"contact_loads", &loads_}},
                       kLoadLanes * static_cast<std::uint32_t>(surface_.pieces.size()));
  pass.follow("stage_share", share_bits_);
  return pass;
}

}  // namespace fascia
