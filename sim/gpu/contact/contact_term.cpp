#include "sim/gpu/contact/contact_term.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "sim/contact/contact_energy.h"
#include "sim/contact/tissue_surface.h"
#include "sim/gpu/contact/piece_rows.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/solid_mesh.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using shared::vec4;

constexpr std::uint32_t kLoadLanes = 64;
// A bound for the loops of kernels. More pairs would need as many faces that press on one vertex.
constexpr std::uint32_t kMostPairsOfVertex = 1024;
// Of the size of the tissue: points closer to a tool may touch it in a step in which they were expected to rest.
constexpr double kMargin = 0.02;
// How deep inside the iterations may start: enough for what touches to press, and for its stiffness to be known.
constexpr double kLetIn = 1e-4;          // of the size, in tools
constexpr double kLetInOfSkin = 0.05;    // in tissue
constexpr double kLeastShare = 1e-6;     // of the way: 0 says that the start stays as it is
constexpr std::uint32_t kNoBody = ~0u;   // shaders/sim/contact/contact_retreat.comp
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

// The weights as the GPU has them: their sum is 0 there, too, so that forces stay equal and opposite.
vec4 weights_of(const PairRow& pair) {
  std::array<float, 4> w;
  for (std::size_t k = 0; k < 4; ++k) w[k] = static_cast<float>(pair.weights[k]);
  std::size_t least = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (std::abs(w[k]) < std::abs(w[least])) least = k;
  w[least] = 0;
  w[least] = -(w[0] + w[1] + w[2] + w[3]);
  return {w[0], w[1], w[2], w[3]};
}

}  // namespace

ContactTerm::ContactTerm(const Model& model, SimBuffers& buffers)
    : model_(model),
      buffers_(buffers),
      tools_(model.tools),
      surface_(make_contact_surface(model)),
      pairs_(model),
      friction_(model.contact.friction),
      half_thickness_(0.5 * model.contact.thickness) {
  if (surface_.pieces.size() > kMostPieces)
    throw Error("contact", "has " + std::to_string(surface_.pieces.size()) + " rigid pieces",
                "expected at most " + std::to_string(kMostPieces) + ": ground, obstacles, instruments, jaws as two");
  if (!acts()) return;
  margin_ = kMargin * buffers.size;
  make_grids();
  let_in_ = kLetIn * buffers.size;
  place_ = buffers.placement.place;
  const std::size_t all = point_count() + pairs_.slot_count(), rows = std::max(surface_.row_count, 1u);
  std::vector<Tet> vertices(all);
  point_entries_.resize(buffers.vertex_count);
  std::size_t entries = 0;
  for (std::uint32_t p = 0; p < point_count(); ++p) {
    const ContactPoint& point = surface_.points[p];
    for (std::uint32_t k = 0; k < 3; ++k) {
      vertices[p][k] = place_[point.vertices[k]];
      if (point.weights[k] == 0) continue;
      point_entries_[vertices[p][k]].push_back(4 * p + k);
      ++entries;
    }
    vertices[p][3] = vertices[p][0];
    places_.push_back(vertices[p]);
  }
  for (const std::vector<std::uint32_t>& list : point_entries_)
    most_entries_ = std::max(most_entries_, static_cast<std::uint32_t>(list.size()));
  if (!pairs_.empty()) most_entries_ += kMostPairsOfVertex;
  std::vector<std::uint32_t> near(all, 1), none(4 + all);
  std::fill_n(near.begin(), point_count(), 0u);
  none[1] = none[2] = 1;
  vertices_ = gl::Buffer("contact_vertices", vertices);
  weights_ = gl::Buffer("contact_weights", std::vector<vec4>(all));
  rest_ = gl::Buffer("contact_rest", std::vector<vec4>(std::max(point_count(), 1u)));
  begin_ = gl::Buffer("contact_begin", std::vector<std::uint32_t>(buffers.vertex_count + std::size_t{1}));
  end_ = gl::Buffer("contact_end", std::vector<std::uint32_t>(buffers.vertex_count));
  entries_ = gl::Buffer("contact_entries", std::vector<std::uint32_t>(entries + 4 * pairs_.slot_count()));
  pieces_ = gl::Buffer("contact_pieces", sizeof(vec4) * 11 * std::max<std::size_t>(surface_.pieces.size(), 1));
  near_ = gl::Buffer("contact_near", near);
  counts_ = gl::Buffer("contact_counts", std::vector<std::uint32_t>(stretches() + 1));
  list_ = gl::Buffer("contact_list", none);
  rows_ = gl::Buffer("contact_row", std::vector<vec4>(rows));
  normals_ = gl::Buffer("contact_normal", std::vector<vec4>(rows));
  forces_ = gl::Buffer("contact_force", std::vector<vec4>(all));
  blocks_ = gl::Buffer("contact_block", std::vector<vec4>(2 * all));
  loads_ = gl::Buffer("contact_loads", std::vector<vec4>(2 * kLoadLanes * surface_.pieces.size()));
  std::vector<std::uint32_t> body(buffers.vertex_count, kNoBody);
  limits_.assign(std::max<std::size_t>(model.bodies.size(), 1), 1);
  std::vector<std::uint32_t> limits(limits_.size() + point_count());
  const std::vector<char> held = model.held();
  const UnconstrainedParts free = unconstrained_parts(model, held);
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) body[place_[v]] = bodies[v];
  for (std::uint32_t p = 0; p < point_count(); ++p) limits[limits_.size() + p] = body[vertices[p][0]];
  body_ = gl::Buffer("contact_body", body);
  limit_ = gl::Buffer("contact_limit", limits);
  falls_.assign(free.unconstrained.begin(), free.unconstrained.end());
  gravity_ = model.gravity;
  if (!pairs_.empty()) constants_ = gl::Buffer("contact_pairs", std::vector<vec4>(3 * pairs_.slot_count()));
  const std::vector<vec4> no_forces(surface_.row_count + pairs_.slot_count());
  buffers.contact_memory = gl::Buffer("contact_memory", no_forces);
  buffers.contact_before = gl::Buffer("contact_before", no_forces);
  upload_entries();
  upload_points(model);
  place_pieces(motion_on_paths(tools_, 0, 0));
}

std::uint32_t ContactTerm::stretches() const { return std::max(1u, (point_count() + kStretch - 1) / kStretch); }

void ContactTerm::upload_points(const Model& model) {
  const std::vector<double> stiffness = contact_stiffness(model, surface_);
  std::vector<vec4> weights, rest;
  for (std::size_t p = 0; p < surface_.points.size(); ++p) {
    const ContactPoint& point = surface_.points[p];
    Vector3d x(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) x += point.weights[k] * model.rest_positions[point.vertices[k]];
    weights.push_back(row_of({point.weights[0], point.weights[1], point.weights[2]}));
    rest.push_back(row_of(x, stiffness[p]));
  }
  weights_.upload(0, weights.size() * sizeof(vec4), weights.data());
  rest_.upload(0, rest.size() * sizeof(vec4), rest.data());
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
  friction_ = model.contact.friction;
  gravity_ = model.gravity;
  pairs_.materials_changed(model);
  upload_points(model);
}

void ContactTerm::begin_stage(const ToolMotion& motion, double duration, SimBuffers& buffers) {
  if (!acts()) return;
  std::fill(limits_.begin(), limits_.end(), 1.0f);
  if (!surface_.empty()) place_pieces(motion);
  if (!pairs_.empty()) {
    start_ = buffers.download_vectors(buffers.displacement);
    const std::vector<Vector3d> velocity = buffers.download_vectors(buffers.velocity);
    std::vector<Vector3d> end = start_;
    for (std::size_t v = 0; v < end.size(); ++v)
      end[v] += duration * velocity[v] + (falls_[v] ? duration * duration : 0) * gravity_;
    place_pairs(start_, end, buffers);
    limit_start(end);
  }
  limit_.upload(0, limits_.size() * sizeof(float), limits_.data());
}

void ContactTerm::place_pieces(const ToolMotion& motion) {
  std::vector<vec4> rows;
  for (const ContactPiece& piece : surface_.pieces) {
    const Tool& tool = tools_[piece.tool];
    const ToolPlace &from = motion.from[piece.tool], &to = motion.to[piece.tool];
    const RigidPose before = tool.pose_of_piece(piece.piece, from), after = tool.pose_of_piece(piece.piece, to);
    const PieceRows shape = piece_rows_of(tool.shape, first_nodes_[piece.tool]);
    const double share = 1.0 / (1 << (2 * piece.level)), reach = way_of(tool.shape, before, after) + margin_;
    add(rows, after, tool.friction, share, reach, half_thickness_);
    add(rows, before, shape.kind, piece.first_row, piece.points, let_in_);
    rows.push_back(shape.a);
    rows.push_back(shape.b);
    rows.push_back(row_of(to.pose.origin));
  }
  const auto same = [](const vec4& a, const vec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; };
  if (std::equal(rows.begin(), rows.end(), uploaded_.begin(), uploaded_.end(), same)) return;
  pieces_.upload(0, rows.size() * sizeof(vec4), rows.data());
  uploaded_ = std::move(rows);
}

void ContactTerm::place_pairs(const std::vector<Vector3d>& start, const std::vector<Vector3d>& end,
                              SimBuffers& buffers) {
  const std::size_t offset = sizeof(vec4) * surface_.row_count;
  std::vector<vec4> before(pairs_.slot_count()), kept(pairs_.slot_count());
  buffers.contact_memory.download(offset, before.size() * sizeof(vec4), before.data());
  std::vector<ContactForce> forces;
  for (const vec4& force : before) forces.push_back({{force.x, force.y, force.z}, force.w});
  const bool had_pairs = !rows_of_pairs_.empty();
  rows_of_pairs_ = pairs_.find(start, end, forces);

  // Slots without a pair forget their force.
  for (const PairRow& pair : rows_of_pairs_) kept[pair.slot] = before[pair.slot];
  buffers.contact_memory.upload(offset, kept.size() * sizeof(vec4), kept.data());
  buffers.contact_before.upload(offset, kept.size() * sizeof(vec4), kept.data());

  const auto count = static_cast<std::uint32_t>(rows_of_pairs_.size());
  counts_.upload(sizeof count * stretches(), sizeof count, &count);
  if (count == 0 && !had_pairs) return;
  std::vector<Tet> vertices;
  std::vector<vec4> weights, constants;
  std::vector<std::uint32_t> listed;
  places_.resize(point_count());
  for (const PairRow& pair : rows_of_pairs_) {
    Tet& placed = vertices.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) placed[k] = place_[pair.vertices[k]];
    places_.push_back(placed);
    weights.push_back(weights_of(pair));
    constants.push_back(row_of(pair.normal, pair.gap));
    constants.push_back(row_of(pair.start, pair.stiffness));
    constants.push_back(row_of({friction_, static_cast<double>(surface_.row_count + pair.slot), 0}));
    listed.push_back(point_count() + static_cast<std::uint32_t>(listed.size()));
  }
  vertices_.upload(sizeof(Tet) * point_count(), vertices.size() * sizeof(Tet), vertices.data());
  weights_.upload(sizeof(vec4) * point_count(), weights.size() * sizeof(vec4), weights.data());
  constants_.upload(0, constants.size() * sizeof(vec4), constants.data());
  list_.upload(4 * sizeof(std::uint32_t), listed.size() * sizeof(std::uint32_t), listed.data());
  upload_entries();
}

bool ContactTerm::searches_again(SimBuffers& buffers) {
  if (pairs_.empty() || !pairs_.sees_near()) return false;
  const std::vector<Vector3d> end = buffers.download_vectors(buffers.displacement);
  if (!pairs_.misses(end)) return false;
  place_pairs(start_, end, buffers);
  const std::vector<float> as_it_is(limits_.size(), 0);
  limit_.upload(0, as_it_is.size() * sizeof(float), as_it_is.data());
  return true;
}

void ContactTerm::limit_start(const std::vector<Vector3d>& end) {
  const double let_in = kLetInOfSkin * pairs_.skin();
  for (const PairRow& pair : rows_of_pairs_) {
    double way = 0;
    for (std::size_t k = 0; k < 4; ++k)
      way += pair.weights[k] * pair.normal.dot(end[pair.vertices[k]] - start_[pair.vertices[k]]);
    if (way >= 0 || pair.gap + way >= -let_in) continue;
    const auto share = static_cast<float>(std::max(0.0, pair.gap + let_in) / -way + kLeastShare);
    for (const std::uint32_t body : pair.bodies) limits_[body] = std::min(limits_[body], share);
  }
}

void ContactTerm::upload_entries() {
  std::vector<std::vector<std::uint32_t>> of_pairs(rows_of_pairs_.empty() ? 0 : point_entries_.size());
  for (std::uint32_t k = 0; k < rows_of_pairs_.size(); ++k)
    for (std::uint32_t corner = 0; corner < 4; ++corner)
      if (rows_of_pairs_[k].weights[corner] != 0)
        of_pairs[places_[point_count() + k][corner]].push_back(4 * (point_count() + k) + corner);
  std::vector<std::uint32_t> begin{0}, entries;
  for (std::size_t v = 0; v < point_entries_.size(); ++v) {
    entries.insert(entries.end(), point_entries_[v].begin(), point_entries_[v].end());
    if (!of_pairs.empty()) entries.insert(entries.end(), of_pairs[v].begin(), of_pairs[v].end());
    begin.push_back(static_cast<std::uint32_t>(entries.size()));
  }
  begin_.upload(0, begin.size() * sizeof(std::uint32_t), begin.data());
  entries_.upload(0, entries.size() * sizeof(std::uint32_t), entries.data());
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
  gl::Defines defines = defines_of_shapes(kinds);
  defines.emplace_back("PAIRS", pairs_.empty() ? "0" : "1");
  return defines;
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
                       {{"pieces", static_cast<std::uint32_t>(surface_.pieces.size())},
                        {"bodies", static_cast<std::uint32_t>(limits_.size())}});
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
  gl::ComputePass::Constants constants{{"deferred_list", 0}, {"deferred_begin", 4}};
  if (!pairs_.empty()) {
    more.emplace_back("contact_pairs", &constants_);
    constants.emplace_back("points", point_count());
  }
  gl::Defines listed = defines();
  listed.emplace_back("DEFERRED", "1");
  listed.emplace_back("STICKING", std::to_string(kStickingPenalty));
  gl::ComputePass pass(programs.compute(kernel, listed), std::move(more), point_count() + pairs_.slot_count(),
                       std::move(constants));
  pass.loops(loops_of_point());
  pass.set_indirect(list_, 0);
  return pass;
}

EnergyTerm::Passes ContactTerm::begin(gl::ProgramCache& programs, const SimBuffers& buffers) const {
  Passes passes;
  if (!surface_.empty())
    passes.push_back(over_points(programs, "sim/contact/contact_start.comp",
                                 {{"start_displacement", &buffers.start_of_stage()},
                                  {"displacement", &buffers.displacement},
                                  {"contact_memory", &buffers.contact_memory},
                                  {"contact_before", &buffers.contact_before},
                                  {"contact_near", &near_},
                                  {"contact_anchor", &rows_},
                                  {"contact_normal_now", &normals_},
                                  {"contact_limit", &limit_},
                                  {"contact_force", &forces_},
                                  {"contact_block", &blocks_}}));
  const gl::Defines stretched{{"STRETCH", std::to_string(kStretch)}};
  if (!surface_.empty())
    passes
        .emplace_back(programs.compute("sim/contact/contact_count.comp", stretched),
                      gl::ComputePass::Bindings{{"contact_near", &near_}, {"contact_counts", &counts_}}, stretches(),
                      gl::ComputePass::Constants{{"points", point_count()}})
        .loops(kStretch + 1);
  passes
      .emplace_back(
          programs.compute("sim/contact/contact_list.comp", stretched),
          gl::ComputePass::Bindings{{"contact_near", &near_}, {"contact_counts", &counts_}, {"contact_list", &list_}},
          stretches(), gl::ComputePass::Constants{{"points", point_count()}, {"stretches", stretches()}})
      .loops(stretches() + kStretch + 1);
  passes
      .emplace_back(programs.compute("sim/contact/contact_touched.comp"),
                    gl::ComputePass::Bindings{{"contact_begin", &begin_},
                                              {"contact_entries", &entries_},
                                              {"contact_near", &near_},
                                              {"contact_end", &end_}},
                    buffers.vertex_count)
      .loops(most_entries_ + 1);
  passes
      .emplace_back(programs.compute("sim/contact/contact_retreat.comp"),
                    gl::ComputePass::Bindings{{"contact_limit", &limit_},
                                              {"contact_body", &body_},
                                              {"start_displacement", &buffers.start_of_stage()},
                                              {"iterate", &buffers.displacement},
                                              {"displacement", &buffers.displacement}},
                    buffers.vertex_count)
      .loops(0);
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
  return Reduction(programs, point_count() + pairs_.slot_count()).partials;
}

EnergyTerm::Passes ContactTerm::curvature(gl::ProgramCache& programs, const SimBuffers& buffers,
                                          const TermCurvature& at) const {
  const std::uint32_t most = point_count() + pairs_.slot_count();
  const Reduction sum(programs, most);
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
      .loops(most / sum.lanes + 2);
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
  if (surface_.empty()) return passes;
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
  const std::size_t most = places_.size();
  std::uint32_t count = 0;
  list_.download(3 * sizeof count, sizeof count, &count);
  if (count == 0 || count > most) return result;
  std::vector<std::uint32_t> points(count);
  list_.download(4 * sizeof count, count * sizeof count, points.data());
  std::vector<vec4> blocks(2 * most);
  blocks_.download(0, blocks.size() * sizeof(vec4), blocks.data());
  for (const std::uint32_t p : points) {
    if (p >= most) return {};  // a device that fails
    const vec4 &d = blocks[2 * p], &s = blocks[2 * p + 1];
    if (!(d.x + d.y + d.z > 0)) continue;
    Eigen::Matrix3d stiffness;
    stiffness << d.x, s.z, s.y, s.z, d.y, s.x, s.y, s.x, d.z;
    std::array<double, 4> weights{};
    if (p >= point_count())
      weights = rows_of_pairs_[p - point_count()].weights;
    else
      std::copy_n(surface_.points[p].weights.begin(), 3, weights.begin());
    result.push_back({places_[p], weights, stiffness});
  }
  return result;
}

std::vector<PairLoad> ContactTerm::sum_of(const std::vector<PairRow>& pairs, const std::vector<vec4>& forces) {
  std::vector<PairLoad> loads;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Vector3d force(forces[k].x, forces[k].y, forces[k].z);
    const double pressing = forces[k].w;
    if (pressing > 0 || !force.isZero(0))
      add_load(loads, pairs[k], force, pressing > 0, (pressing - pairs[k].before) / pairs[k].stiffness);
  }
  return loads;
}

std::vector<Vector3d> ContactTerm::forces_at_vertices() const {
  std::vector<Vector3d> forces(model_.rest_positions.size(), Vector3d::Zero());
  if (!acts()) return forces;
  const std::vector<vec4> at_points = forces_.read<vec4>();
  const auto force_at = [&](std::size_t p) { return Vector3d(at_points[p].x, at_points[p].y, at_points[p].z); };
  for (std::size_t p = 0; p < surface_.points.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k)
      forces[surface_.points[p].vertices[k]] += surface_.points[p].weights[k] * force_at(p);
  for (std::size_t p = 0; p < rows_of_pairs_.size(); ++p)
    for (std::size_t k = 0; k < 4; ++k)
      forces[rows_of_pairs_[p].vertices[k]] += rows_of_pairs_[p].weights[k] * force_at(point_count() + p);
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
