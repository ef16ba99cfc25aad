#include "sim/gpu/readback/surface_positions.h"

#include <algorithm>
#include <array>

namespace fascia {

SurfacePositions::SurfacePositions(const SimBuffers& buffers, const EmbeddedPoints& embedded)
    : vertex_count_(buffers.vertex_count),
      embedded_count_(static_cast<std::uint32_t>(embedded.points.size())),
      positions_("positions", (vertex_count_ + embedded.points.size()) * sizeof(shared::vec4)) {
  if (embedded.points.empty()) return;
  std::vector<shared::vec4> rest, weights;
  std::vector<Tet> vertices;
  const auto to_float = [](double v) { return static_cast<float>(v); };
  for (std::size_t i = 0; i < embedded.points.size(); ++i) {
    const Eigen::Vector3d& p = embedded.points[i];
    rest.push_back({to_float(p.x()), to_float(p.y()), to_float(p.z()), 0});
    const auto& w = embedded.ties[i].weights;
    weights.push_back({to_float(w[0]), to_float(w[1]), to_float(w[2]), to_float(w[3])});
    Tet corners = embedded.ties[i].vertices;
    for (std::uint32_t& v : corners) v = buffers.placement.place[v];
    vertices.push_back(corners);
  }
  embed_position_ = gl::Buffer("embed_position", rest);
  if (!embedded.quadratic.empty()) {
    weights.clear();
    std::vector<shared::vec4> middle_weights;
    std::vector<Tet> middles;
    for (const QuadraticTie& tie : embedded.quadratic) {
      std::array<std::uint32_t, 8> places{};  // of the middles; without any, weights of zero at vertex 0
      std::array<float, 12> w{};
      std::transform(tie.weights.begin(), tie.weights.end(), w.begin(), to_float);
      for (std::size_t m = 0; m < 6; ++m)
        if (tie.middles[m] != kNoVertex) places[m] = buffers.placement.place[tie.middles[m]];
      weights.push_back({w[0], w[1], w[2], w[3]});
      middles.insert(middles.end(), {{places[0], places[1], places[2], places[3]}, {places[4], places[5], 0, 0}});
      middle_weights.insert(middle_weights.end(), {{w[4], w[5], w[6], w[7]}, {w[8], w[9], 0, 0}});
    }
    embed_middles_ = gl::Buffer("embed_middles", middles);
    embed_middle_weights_ = gl::Buffer("embed_middle_weights", middle_weights);
  }
  embed_vertices_ = gl::Buffer("embed_vertices", vertices);
  embed_weights_ = gl::Buffer("embed_weights", weights);
}

void SurfacePositions::record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
                              ColorBy color, ContactTerm& contact) {
  passes_.clear();
  const auto flag = [](bool on) { return on ? "1" : "0"; };
  gl::ComputePass::Bindings publish{{"placed_vertex", &buffers.placed_vertex},
                                    {"rest_position", &buffers.rest_position},
                                    {"displacement", &buffers.displacement},
                                    {"position", &positions_}};
  const bool heat = is_heat_map(color), by_vertex = color == ColorBy::error || color == ColorBy::mesh_error ||
                                                    color == ColorBy::recovered_von_mises;
  const bool by_force = color == ColorBy::contact_pressure, touches = by_force && contact.acts();
  const bool by_tet = heat && !by_vertex && !by_force && color != ColorBy::displacement && color != ColorBy::velocity;
  if (by_vertex) {
    if (!vertex_errors_) vertex_errors_ = gl::Buffer("vertex_errors", sizeof(float) * vertex_count_);
    publish.emplace_back("vertex_scalar", &vertex_errors_);
  }
  if (touches) contact.bind_pressure(publish);
  if (color == ColorBy::velocity) publish.emplace_back("velocity", &buffers.velocity);
  if (by_tet) {
    Features elastic = features;
    elastic.damping = false;
    gl::Defines defines = defines_of(elastic);
    defines.emplace_back("HEAT_STRAIN", flag(color == ColorBy::strain));
    defines.emplace_back("HEAT_VOLUME_RATIO", flag(color == ColorBy::volume_ratio));
    defines.emplace_back("HEAT_VON_MISES", flag(color == ColorBy::von_mises));
    defines.emplace_back("HEAT_LARGEST_STRESS", flag(color == ColorBy::largest_stress));
    defines.emplace_back("HEAT_SMALLEST_STRESS", flag(color == ColorBy::smallest_stress));
    gl::ComputePass::Bindings tet{{"step", &buffers.step}, {"displacement", &buffers.displacement}};
    tet = with_material(std::move(tet), features, buffers);
    if (buffers.has_linear())
      passes_.emplace_back(programs.compute("sim/readback/heat_tet.comp", defines), with_slots(tet, buffers),
                           buffers.pair_and_single_count(), constants_of_pairs(buffers));
    if (buffers.has_quadratic())
      passes_.emplace_back(
          programs.compute("sim/quadratic/quadratic_heat.comp", defines_of_quadratic(defines, buffers)),
          with_quadratic_slots(tet, buffers), buffers.quadratic_count, constants_of_quadratic(buffers));
    publish.emplace_back("slot_begin", &buffers.slot_begin);
    publish.emplace_back("correction", &buffers.correction);
  }
  passes_.emplace_back(
      programs.compute("sim/readback/publish.comp", {{"HEAT_BY_TET", flag(by_tet)},
                                                     {"HEAT_BY_VERTEX", flag(by_vertex)},
                                                     {"HEAT_CONTACT", flag(touches)},
                                                     {"HEAT_VELOCITY", flag(color == ColorBy::velocity)},
                                                     {"HEAT_DISPLACEMENT", flag(color == ColorBy::displacement)},
                                                     {"HEAT_AT_REST", color == ColorBy::volume_ratio ? "1.0" : "0.0"}}),
      std::move(publish), buffers.vertex_count);
  if (!heat) range_.reset();
  if (heat && !range_) range_.emplace(positions_, vertex_count_);
  if (heat) range_->set_middle(quantity_of(color).neutral.value_or(0));
  if (embedded_count_ == 0) return;
  gl::ComputePass::Bindings embed{{"embed_position", &embed_position_},
                                  {"embed_vertices", &embed_vertices_},
                                  {"embed_weights", &embed_weights_},
                                  {"displacement", &buffers.displacement},
                                  {"position", &positions_}};
  if (heat) embed.emplace_back("placed_vertex", &buffers.placed_vertex);
  if (embed_middles_)
    embed.insert(embed.end(), {{"embed_middles", &embed_middles_}, {"embed_middle_weights", &embed_middle_weights_}});
  passes_.emplace_back(
      programs.compute("sim/readback/embed.comp", {{"HEAT", flag(heat)}, {"QUADRATIC", flag(bool{embed_middles_})}}),
      std::move(embed), embedded_count_, gl::ComputePass::Constants{{"vertex_count", vertex_count_}});
}

void SurfacePositions::set_vertex_errors(const std::vector<float>& errors) {
  if (!vertex_errors_) vertex_errors_ = gl::Buffer("vertex_errors", sizeof(float) * vertex_count_);
  vertex_errors_.upload(0, errors.size() * sizeof(float), errors.data());
}

void SurfacePositions::run() const {
  for (const gl::ComputePass& pass : passes_) pass.run();
}

}  // namespace fascia
