#include "sim/gpu/contact/contact_term.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "sim/contact/contact_energy.h"
#include "sim/gpu/contact/piece_rows.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/solid_mesh.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using shared::vec4;

constexpr std::uint32_t kLoadLanes = 64;
constexpr std::uint32_t kCorners = 3;
// Of the size of the tissue: points closer to a tool may touch it in a step in which they were expected to rest.
constexpr double kMargin = 0.02;
constexpr std::uint32_t kStretch = 256;  // of points that one invocation lists

void add(std::vector<vec4>& rows, const RigidPose& pose, double w0, double w1, double w2, double w3) {
  rows.push_back(row_of(pose.axes.col(0), w0));
  rows.push_back(row_of(pose.axes.col(1), w1));
  rows.push_back(row_of(pose.axes.col(2), w2));
  rows.push_back(row_of(pose.origin, w3));
}

// The farthest that a point of a piece moves, at most [m].
double way_of(const ToolShape& shape, const RigidPose& from, const RigidPose& to) {
  const double radius = bounding_radius(shape);
  const Vector3d middle = middle_of(shape);
  const double way = (to.to_scene(middle) - from.to_scene(middle)).norm();
  const double turn = (to.axes - from.axes).norm();
  return turn > 0 ? way + turn * radius : way;  // a plane that turns reaches everywhere
}

}  // namespace

ContactTerm::ContactTerm(const Model& model, SimBuffers& buffers)
    : model_(model),
      buffers_(buffers),
      tools_(model.tools),
      surface_(make_contact_surface(model)),
      half_thickness_(0.5 * model.contact.thickness) {
  if (surface_.pieces.size() > kMostPieces)
    throw Error("contact", "has " + std::to_string(surface_.pieces.size()) + " rigid pieces",
                "expected at most " + std::to_string(kMostPieces) + ": ground, obstacles, instruments, jaws as two");
  if (!acts()) return;
  margin_ = kMargin * buffers.size;
  make_grids();
  std::vector<Tet> vertices;
  std::vector<vec4> rest;
  std::vector<std::vector<std::uint32_t>> entries(buffers.vertex_count);
  for (std::uint32_t p = 0; p < point_count(); ++p) {
    const ContactPoint& point = surface_.points[p];
    Vector3d x(0, 0, 0);
    Tet& placed = vertices.emplace_back(Tet{});
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      x += point.weights[k] * model.rest_positions[point.vertices[k]];
      placed[k] = buffers.placement.place[point.vertices[k]];
      if (point.weights[k] > 0) entries[placed[k]].push_back(4 * p + k);
    }
    rest.push_back(row_of(x));
    places_.push_back({placed[0], placed[1], placed[2]});
  }
  std::vector<std::uint32_t> begin{0}, all;
  for (const std::vector<std::uint32_t>& list : entries) {
    all.insert(all.end(), list.begin(), list.end());
    begin.push_back(static_cast<std::uint32_t>(all.size()));
    most_entries_ = std::max(most_entries_, static_cast<std::uint32_t>(list.size()));
  }
  const std::vector<vec4> no_rows(surface_.row_count);
  const std::vector<std::uint32_t> nowhere(begin.begin(), begin.end() - 1);
  vertices_ = gl::Buffer("contact_vertices", vertices);
  weights_ = gl::Buffer("contact_weights", sizeof(vec4) * point_count());
  rest_ = gl::Buffer("contact_rest", rest);
  begin_ = gl::Buffer("contact_begin", begin);
  end_ = gl::Buffer("contact_end", nowhere);
  entries_ = gl::Buffer("contact_entries", all);
  pieces_ = gl::Buffer("contact_pieces", sizeof(vec4) * 11 * surface_.pieces.size());
  near_ = gl::Buffer("contact_near", std::vector<std::uint32_t>(point_count()));
  counts_ = gl::Buffer("contact_counts", std::vector<std::uint32_t>(point_count() / kStretch + 1));
  std::vector<std::uint32_t> none(4 + point_count());
  none[1] = none[2] = 1;
  list_ = gl::Buffer("contact_list", none);
  rows_ = gl::Buffer("contact_row", no_rows);
  normals_ = gl::Buffer("contact_normal", no_rows);
  forces_ = gl::Buffer("contact_force", std::vector<vec4>(point_count()));
  blocks_ = gl::Buffer("contact_block", std::vector<vec4>(2 * point_count()));
  loads_ = gl::Buffer("contact_loads", std::vector<vec4>(2 * kLoadLanes * surface_.pieces.size()));
  buffers.contact_memory = gl::Buffer("contact_memory", no_rows);
  buffers.contact_before = gl::Buffer("contact_before", no_rows);
  materials_changed(model);
  begin_stage(motion_on_paths(tools_, 0, 0));
}

void ContactTerm::make_grids() {
  std::vector<float> nodes;
  std::map<const SolidMesh*, std::size_t> first;
  for (const Tool& tool : tools_) {
    const auto* mesh = std::get_if<MeshShape>(&tool.shape);
    first_nodes_.push_back(mesh ? first.try_emplace(mesh->solid.get(), nodes.size()).first->second : 0);
    if (mesh && first_nodes_.back() == nodes.size())
      nodes.insert(nodes.end(), mesh->solid->distances.begin(), mesh->solid->distances.end());
  }
  constexpr std::size_t kMostNodes = std::size_t{1} << 24;  // that float32 numbers
  if (nodes.size() > kMostNodes)
    throw Error("contact", "the meshes of tools have " + std::to_string(nodes.size()) + " nodes of distances",
                "expected at most " + std::to_string(kMostNodes) + ": fewer meshes");
  if (!nodes.empty()) grids_ = gl::Buffer("contact_grid", nodes);
}

void ContactTerm::materials_changed(const Model& model) {
  if (!acts()) return;
  const std::vector<double> stiffness = contact_stiffness(model, surface_);
  std::vector<vec4> weights;
  for (std::size_t p = 0; p < surface_.points.size(); ++p) {
    const auto& w = surface_.points[p].weights;
    weights.push_back(row_of({w[0], w[1], w[2]}, stiffness[p]));
  }
  weights_.upload(0, weights.size() * sizeof(vec4), weights.data());
}

void ContactTerm::begin_stage(const ToolMotion& motion) {
  if (!acts()) return;
  std::vector<vec4> rows;
  for (const ContactPiece& piece : surface_.pieces) {
    const Tool& tool = tools_[piece.tool];
    const ToolPlace &from = motion.from[piece.tool], &to = motion.to[piece.tool];
    const RigidPose before = tool.pose_of_piece(piece.piece, from), after = tool.pose_of_piece(piece.piece, to);
    const PieceRows shape = piece_rows_of(tool.shape, first_nodes_[piece.tool]);
    const double share = 1.0 / (1 << (2 * piece.level)), reach = way_of(tool.shape, before, after) + margin_;
    add(rows, after, tool.friction, share, reach, half_thickness_);
    add(rows, before, shape.kind, piece.first_row, piece.points, 0);
    rows.push_back(shape.a);
    rows.push_back(shape.b);
    rows.push_back(row_of(to.pose.origin));
  }
  const auto same = [](const vec4& a, const vec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; };
  if (std::equal(rows.begin(), rows.end(), uploaded_.begin(), uploaded_.end(), same)) return;
  pieces_.upload(0, rows.size() * sizeof(vec4), rows.data());
  uploaded_ = std::move(rows);
}

std::optional<std::string> ContactTerm::define(TermUse use) const {
  if (use == TermUse::gradient) return "1";
  if (use == TermUse::block) return "2";
  return std::nullopt;
}

void ContactTerm::bind(TermUse use, gl::ComputePass::Bindings& bindings) const {
  bindings.insert(bindings.end(), {{"contact_begin", &begin_},
                                   {"contact_end", &end_},
                                   {"contact_entries", &entries_},
                                   {"contact_weights", &weights_}});
  if (use == TermUse::gradient)
    bindings.emplace_back("contact_force", &forces_);
  else
    bindings.emplace_back("contact_block", &blocks_);
}

gl::Defines ContactTerm::defines() const {
  std::set<int> kinds;
  for (const ContactPiece& piece : surface_.pieces) kinds.insert(piece_rows_of(tools_[piece.tool].shape).kind);
  return defines_of_shapes(kinds);
}

std::uint32_t ContactTerm::loops_of_point() const {
  constexpr std::uint32_t kOfGrid = 13;  // shaders/sim/contact/mesh_distance.glsl
  return static_cast<std::uint32_t>(surface_.pieces.size()) * (grids_ ? kOfGrid : 1) + 1;
}

gl::ComputePass ContactTerm::over_points(gl::ProgramCache& programs, const char* kernel,
                                         gl::ComputePass::Bindings more) const {
  more.insert(more.end(), {{"contact_pieces", &pieces_},
                           {"contact_vertices", &vertices_},
                           {"contact_weights", &weights_},
                           {"contact_rest", &rest_}});
  if (grids_) more.emplace_back("contact_grid", &grids_);
  gl::ComputePass pass(programs.compute(kernel, defines()), std::move(more), point_count(),
                       {{"pieces", static_cast<std::uint32_t>(surface_.pieces.size())}});
  pass.loops(loops_of_point());
  return pass;
}

gl::ComputePass ContactTerm::over_near(gl::ProgramCache& programs, const char* kernel,
                                       gl::ComputePass::Bindings more) const {
  more.insert(more.end(), {{"contact_pieces", &pieces_},
                           {"contact_vertices", &vertices_},
                           {"contact_weights", &weights_},
                           {"contact_rest", &rest_},
                           {"contact_normal", &normals_},
                           {"contact_near", &near_},
                           {"deferred_items", &list_}});
  if (grids_) more.emplace_back("contact_grid", &grids_);
  gl::Defines listed = defines();
  listed.emplace_back("DEFERRED", "1");
  listed.emplace_back("STICKING", std::to_string(kStickingPenalty));
  gl::ComputePass pass(programs.compute(kernel, listed), std::move(more), point_count(),
                       {{"deferred_list", 0}, {"deferred_begin", 4}});
  pass.loops(loops_of_point());
  pass.set_indirect(list_, 0);
  return pass;
}

EnergyTerm::Passes ContactTerm::begin(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  Passes passes;
  passes.push_back(over_points(programs, "sim/contact/contact_start.comp",
                               {{"start_displacement", &buffers.start_of_stage()},
                                {"displacement", &buffers.displacement},
                                {"contact_memory", &buffers.contact_memory},
                                {"contact_before", &buffers.contact_before},
                                {"contact_near", &near_},
                                {"contact_anchor", &rows_},
                                {"contact_normal_now", &normals_},
                                {"contact_force", &forces_},
                                {"contact_block", &blocks_}}));
  const std::uint32_t stretches = (point_count() + kStretch - 1) / kStretch;
  const gl::Defines stretched{{"STRETCH", std::to_string(kStretch)}};
  passes
      .emplace_back(programs.compute("sim/contact/contact_count.comp", stretched),
                    gl::ComputePass::Bindings{{"contact_near", &near_}, {"contact_counts", &counts_}}, stretches,
                    gl::ComputePass::Constants{{"points", point_count()}})
      .loops(kStretch + 1);
  passes
      .emplace_back(
          programs.compute("sim/contact/contact_list.comp", stretched),
          gl::ComputePass::Bindings{{"contact_near", &near_}, {"contact_counts", &counts_}, {"contact_list", &list_}},
          stretches, gl::ComputePass::Constants{{"points", point_count()}, {"stretches", stretches}})
      .loops(stretches + kStretch + 1);
  passes
      .emplace_back(programs.compute("sim/contact/contact_touched.comp"),
                    gl::ComputePass::Bindings{{"contact_begin", &begin_},
                                              {"contact_entries", &entries_},
                                              {"contact_near", &near_},
                                              {"contact_end", &end_}},
                    buffers.vertex_count)
      .loops(most_entries_ + 1);
  return passes;
}

EnergyTerm::Passes ContactTerm::evaluate(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  return {over_near(programs, "sim/contact/contact_force.comp",
                    {{"displacement", &buffers.displacement},
                     {"contact_memory", &buffers.contact_memory},
                     {"contact_anchor", &rows_},
                     {"contact_force", &forces_},
                     {"contact_block", &blocks_}})};
}

EnergyTerm::Passes ContactTerm::finish(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  return {over_near(programs, "sim/contact/contact_finish.comp",
                    {{"displacement", &buffers.displacement},
                     {"contact_memory_now", &buffers.contact_memory},
                     {"contact_row", &rows_},
                     {"contact_force", &forces_}})};
}

std::uint32_t ContactTerm::curvature_partials(const gl::ProgramCache& programs) const {
  return Reduction(programs, point_count()).partials;
}

EnergyTerm::Passes ContactTerm::curvature(gl::ProgramCache& programs, const SimBuffers& buffers,
                                          const TermCurvature& at) const {
  const Reduction sum(programs, point_count());
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"contact_vertices", &vertices_},
                                     {"contact_weights", &weights_},
                                     {"contact_block", &blocks_},
                                     {"contact_list", &list_},
                                     {"fine_direction", &at.fine_direction},
                                     {"curvature_partials", &at.partials}};
  if (at.coarse_direction) bindings.emplace_back("coarse_direction", at.coarse_direction);
  Passes passes;
  passes
      .emplace_back(
          programs.compute("sim/contact/contact_curvature.comp", {{"SPLIT", at.coarse_direction ? "1" : "0"}}),
          std::move(bindings), sum.lanes, gl::ComputePass::Constants{{"first_partial", at.first_partial}})
      .loops(point_count() / sum.lanes + 2);
  return passes;
}

EnergyTerm::Passes ContactTerm::impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  Passes passes;
  passes.emplace_back(programs.compute("sim/contact/contact_impulse.comp"),
                      gl::ComputePass::Bindings{{"step", &buffers.step},
                                                {"contact_begin", &begin_},
                                                {"contact_end", &end_},
                                                {"contact_entries", &entries_},
                                                {"contact_weights", &weights_},
                                                {"contact_force", &forces_},
                                                {"slot_begin", &buffers.slot_begin},
                                                {"correction", &buffers.correction}},
                      buffers.vertex_count);
  gl::Defines defines_of_load = defines_of_shapes({});
  defines_of_load.emplace_back("LOAD_LANES", std::to_string(kLoadLanes));
  passes.emplace_back(programs.compute("sim/contact/contact_load.comp", defines_of_load),
                      gl::ComputePass::Bindings{{"contact_pieces", &pieces_},
                                                {"contact_vertices", &vertices_},
                                                {"contact_weights", &weights_},
                                                {"contact_rest", &rest_},
                                                {"displacement", &buffers.displacement},
                                                {"contact_row", &rows_},
                                                {"contact_loads", &loads_}},
                      kLoadLanes * static_cast<std::uint32_t>(surface_.pieces.size()));
  return passes;
}

std::vector<PointStiffness> ContactTerm::stiffness_at_points() const {
  std::vector<PointStiffness> result;
  std::uint32_t count = 0;
  list_.download(3 * sizeof count, sizeof count, &count);
  if (count == 0 || count > point_count()) return result;
  std::vector<std::uint32_t> points(count);
  list_.download(4 * sizeof count, count * sizeof count, points.data());
  const std::vector<vec4> blocks = blocks_.read<vec4>();
  for (const std::uint32_t p : points) {
    if (p >= point_count()) return {};  // a device that fails
    const vec4 &d = blocks[2 * p], &s = blocks[2 * p + 1];
    if (!(d.x + d.y + d.z > 0)) continue;
    Eigen::Matrix3d stiffness;
    stiffness << d.x, s.z, s.y, s.z, d.y, s.x, s.y, s.x, d.z;
    result.push_back({places_[p], surface_.points[p].weights, stiffness});
  }
  return result;
}

std::vector<Vector3d> ContactTerm::forces_at_vertices() const {
  std::vector<Vector3d> forces(model_.rest_positions.size(), Vector3d::Zero());
  if (!acts()) return forces;
  const std::vector<vec4> at_points = forces_.read<vec4>();
  for (std::size_t p = 0; p < at_points.size(); ++p) {
    const ContactPoint& point = surface_.points[p];
    for (std::size_t k = 0; k < kCorners; ++k)
      forces[point.vertices[k]] += point.weights[k] * Vector3d(at_points[p].x, at_points[p].y, at_points[p].z);
  }
  return forces;
}

void ContactTerm::forget_forces() {
  if (!acts()) return;
  forces_.clear();
  rows_.clear();
}

void ContactTerm::bind_pressure(gl::ComputePass::Bindings& bindings) {
  if (!areas_) {
    std::vector<float> areas(model_.rest_positions.size());
    const std::vector<double> of_vertices = surface_areas(model_);
    for (std::size_t v = 0; v < areas.size(); ++v)
      areas[buffers_.placement.place[v]] = static_cast<float>(of_vertices[v]);
    areas_ = gl::Buffer("contact_area", areas);
  }
  bind(TermUse::gradient, bindings);
  bindings.emplace_back("contact_area", &areas_);
}

std::vector<ToolLoad> ContactTerm::sum_of(const std::vector<vec4>& loads) const {
  std::vector<ToolLoad> result(tools_.size());
  for (std::size_t p = 0; p < surface_.pieces.size(); ++p)
    for (std::size_t lane = 0; lane < kLoadLanes; ++lane) {
      const vec4 &force = loads[2 * (kLoadLanes * p + lane)], &torque = loads[2 * (kLoadLanes * p + lane) + 1];
      ToolLoad& load = result[surface_.pieces[p].tool];
      load.force += Vector3d(force.x, force.y, force.z);
      load.torque += Vector3d(torque.x, torque.y, torque.z);
      load.points += static_cast<std::uint32_t>(force.w);
      load.deepest = std::max<double>(load.deepest, torque.w);
    }
  return result;
}

}  // namespace fascia
