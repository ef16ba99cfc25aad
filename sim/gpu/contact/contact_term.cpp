#include "sim/gpu/contact/contact_term.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

#include "base/error.h"
#include "sim/contact/tissue/tissue_cover.h"
#include "sim/contact/tissue/tissue_surface.h"
#include "sim/gpu/contact/piece_rows.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/solid_mesh.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using shared::vec4;

// A bound for the loops of kernels. More pairs would need as many faces that press on one vertex.
constexpr std::uint32_t kMostPairsOfVertex = 1024;
constexpr std::uint32_t kFirstCorner = 0x80000000;  // shaders/sim/contact/entry.glsl
// How deep inside tools bodies are taken: enough for what touches to press, and for its stiffness to be known.
constexpr double kLetIn = 1e-4;  // of the size

void add(std::vector<vec4>& rows, const RigidPose& pose, double w0, double w1, double w2, double w3) {
  rows.push_back(row_of(pose.axes.col(0), w0));
  rows.push_back(row_of(pose.axes.col(1), w1));
  rows.push_back(row_of(pose.axes.col(2), w2));
  rows.push_back(row_of(pose.origin, w3));
}

// The farthest that a point of a piece moves, at most [m].
double farthest_way(const ToolShape& shape, const RigidPose& from, const RigidPose& to) {
  const double radius = bounding_radius(shape);
  const Vector3d middle = middle_of(shape);
  const double way = (to.to_scene(middle) - from.to_scene(middle)).norm();
  const double turn = (to.axes - from.axes).norm();
  return turn > 0 ? way + turn * radius : way;  // a plane that turns reaches everywhere
}

// shaders/sim/contact/entry.glsl
std::array<std::uint32_t, 2> entry_of(std::uint32_t point, std::uint32_t corner, float weight) {
  return {point | (corner == 0 ? kFirstCorner : 0), std::bit_cast<std::uint32_t>(weight)};
}

// Where contact has its origin on the GPU, so that places keep their digits in tissue that lies far from the scene's:
// its middle. In tissue near the scene's origin, that.
Vector3d middle_of_tissue(const Model& model, double size) {
  constexpr double kFar = 4;  // sizes
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : model.rest_positions) box.extend(x);
  const Vector3d middle = box.isEmpty() ? Vector3d(0, 0, 0) : Vector3d(box.center());
  return middle.norm() > kFar * size ? middle : Vector3d(0, 0, 0);
}

// A shape whose own origin is moved to its middle, by the way [m] that is returned. Meshes are left.
Vector3d move_to_middle(ToolShape& shape) {
  struct Move {
    Vector3d by;
    void operator()(SphereShape& s) const { s.center -= by; }
    void operator()(CapsuleShape& s) const { s.from -= by, s.to -= by; }
    void operator()(BoxShape& s) const { s.center -= by; }
    void operator()(PlaneShape& s) const { s.point -= by; }
    void operator()(CylinderShape& s) const { s.from -= by, s.to -= by; }
    void operator()(MeshShape&) const {}
  };
  if (std::holds_alternative<MeshShape>(shape)) return {0, 0, 0};
  const Vector3d by = middle_of(shape);
  std::visit(Move{by}, shape);
  return by;
}

// The weights as the GPU has them: their sum is 0 there, too, so that forces stay equal and opposite.
std::array<float, 4> weights_of(const PairRow& pair) {
  std::array<float, 4> w;
  for (std::size_t k = 0; k < 4; ++k) w[k] = static_cast<float>(pair.weights[k]);
  std::size_t least = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (std::abs(w[k]) < std::abs(w[least])) least = k;
  w[least] = 0;
  w[least] = -(w[0] + w[1] + w[2] + w[3]);
  return w;
}

}  // namespace

ContactTerm::ContactTerm(const Model& model, SimBuffers& buffers, gl::LoadPath loads)
    : model_(model),
      buffers_(buffers),
      tools_(model.tools),
      surface_(make_contact_surface(model)),
      pairs_(model),
      half_thickness_(0.5 * model.contact.thickness) {
  if (surface_.pieces.size() > ContactSurface::kMostPieces)
    throw Error("contact", "has " + std::to_string(surface_.pieces.size()) + " rigid pieces",
                "expected at most " + std::to_string(ContactSurface::kMostPieces) +
                    ": ground, obstacles, instruments, jaws as two");
  if (!acts()) return;
  margin_ = kContactMargin * buffers.size;
  origin_ = middle_of_tissue(model, buffers.size);
  make_grids();
  let_in_ = kLetIn * buffers.size;
  const std::size_t all = point_count() + pairs_.slot_count(), rows = std::max(surface_.row_count, 1u);
  std::vector<Tet> vertices(all);
  point_entries_.resize(buffers.vertex_count);
  for (std::uint32_t p = 0; p < point_count(); ++p) {
    const ContactPoint& point = surface_.points[p];
    for (std::uint32_t k = 0; k < 3; ++k) {
      vertices[p][k] = buffers.placement.place[point.vertices[k]];
      if (point.weights[k] == 0) continue;
      point_entries_[vertices[p][k]].push_back(entry_of(p, k, static_cast<float>(point.weights[k])));
    }
    vertices[p][3] = vertices[p][0];
    places_.push_back(vertices[p]);
  }
  for (const std::vector<Entry>& list : point_entries_)
    most_entries_ = std::max(most_entries_, static_cast<std::uint32_t>((list.size() + 1) / 2));
  if (!pairs_.empty()) most_entries_ += kMostPairsOfVertex / 2 + 1;
  std::size_t entries = 4 * pairs_.slot_count();
  for (const std::vector<Entry>& list : point_entries_) entries += (list.size() + 1) / 2;
  const std::size_t lists = loads == gl::LoadPath::texel ? 2 : 1;  // of vertices
  std::vector<std::uint32_t> near(all, 1), none(4 + all + lists * (4 + buffers.vertex_count));
  std::fill_n(near.begin(), point_count(), 0u);
  none[1] = none[2] = 1;
  vertices_ = gl::Buffer("contact_vertices", vertices);
  weights_ = gl::Buffer("contact_weights", std::vector<vec4>(all));
  rest_ = gl::Buffer("contact_rest", std::vector<vec4>(2 * std::max(point_count(), 1u)));
  begin_ = gl::Buffer("contact_begin", std::vector<std::uint32_t>(buffers.vertex_count + std::size_t{1}));
  end_ = gl::Buffer("contact_end", std::vector<std::uint32_t>(buffers.vertex_count));
  entries_ = gl::Buffer("contact_entries", 2 * sizeof(Entry) * entries);
  pieces_ = gl::Buffer("contact_pieces", sizeof(vec4) * kPieceRows * std::max<std::size_t>(surface_.pieces.size(), 1));
  near_ = gl::Buffer("contact_near", near);
  counts_ = gl::Buffer("contact_counts", std::vector<std::uint32_t>(stretches() + 1));
  list_ = gl::Buffer("contact_list", none);
  rows_ = gl::Buffer("contact_row", std::vector<vec4>(rows));
  normals_ = gl::Buffer("contact_normal", std::vector<vec4>(rows));
  moved_rows_ =
      gl::Buffer("contact_moved", std::vector<vec4>(surface_.row_count + pairs_.row_count(), vec4{0, 0, 0, kNoPlane}));
  forces_ = gl::Buffer("contact_force", std::vector<vec4>(all));
  blocks_ = gl::Buffer("contact_block", std::vector<vec4>(2 * all));
  pressing_ = gl::Buffer("contact_pressing", std::vector<vec4>(all));
  along_ = gl::Buffer("contact_along", std::vector<vec4>(all));
  if (loads == gl::LoadPath::texel)
    sums_ = gl::Buffer("contact_sums", std::vector<vec4>(3 * std::size_t{buffers.vertex_count}));
  if (loads == gl::LoadPath::texel && grids_) doubtful_ = std::make_unique<DeferredTets>(Deferral{1, point_count()});
  if (crowded()) crowds_ = gl::Buffer("contact_crowds", sizeof(float) * buffers.vertex_count * surface_.pieces.size());
  loads_ = gl::Buffer("contact_loads", std::vector<vec4>(3 * kLoadLanes * surface_.pieces.size()));
  std::vector<std::uint32_t> first_vertices;
  for (std::uint32_t p = 0; p < point_count(); ++p) first_vertices.push_back(places_[p][0]);
  starts_ = BodyStarts(model, buffers, first_vertices);
  if (!pairs_.empty()) constants_ = gl::Buffer("contact_pairs", std::vector<vec4>(3 * pairs_.slot_count()));
  const std::vector<vec4> no_forces(surface_.row_count + pairs_.row_count());
  buffers.contact_memory = gl::Buffer("contact_memory", no_forces);
  buffers.contact_before = gl::Buffer("contact_before", no_forces);
  upload_entries();
  upload_points(model);
  place_pieces(motion_on_paths(tools_, 0, 0));
}

double ContactTerm::way_of(const ToolMotion& motion) const {
  double farthest = 0;
  for (const ContactPiece& piece : surface_.pieces) {
    const Tool& tool = tools_[piece.tool];
    farthest = std::max(farthest, farthest_way(tool.shape, tool.pose_of_piece(piece.piece, motion.from[piece.tool]),
                                               tool.pose_of_piece(piece.piece, motion.to[piece.tool])));
  }
  return farthest;
}

bool ContactTerm::crowded() const {
  return std::any_of(surface_.pieces.begin(), surface_.pieces.end(),
                     [](const ContactPiece& piece) { return piece.level > 0; });
}

std::uint32_t ContactTerm::stretches() const { return std::max(1u, (point_count() + kStretch - 1) / kStretch); }

void ContactTerm::upload_points(const Model& model) {
  stiffness_ = contact_stiffness(model, surface_);
  const std::vector<double> in_stage = length_ > 0 ? stage_stiffness(model, surface_, stiffness_, length_) : stiffness_;
  std::vector<vec4> weights, rest;
  for (std::size_t p = 0; p < surface_.points.size(); ++p) {
    const ContactPoint& point = surface_.points[p];
    Vector3d x = -origin_;
    for (std::size_t k = 0; k < 3; ++k) x += point.weights[k] * model.rest_positions[point.vertices[k]];
    weights.push_back(row_of({point.weights[0], point.weights[1], point.weights[2]}));
    rest.push_back(row_of(x, in_stage[p]));
    const Vector3d lost = rounding_of(x);
    rest.push_back(row_of(lost));
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

void ContactTerm::materials_changed(const Model& model, SimBuffers& buffers) {
  if (!acts()) return;
  const std::vector<double> before = stiffness_;
  upload_points(model);
  const ContactMemory left = buffers.contact_forces(buffers.contact_memory);
  ContactMemory softened = left;
  soften(softened, surface_, before, stiffness_);
  pairs_.materials_changed(model, std::span(softened).subspan(surface_.row_count));
  if (softened != left) buffers.upload_contact(softened);
  starts_.materials_changed(model);
}

void ContactTerm::begin_step(int substeps) {
  earlier_loads_.begin();
  substeps_ = substeps;
  share_ = 0;
}

void ContactTerm::begin_stage(const ToolMotion& motion, double time, const IntegratorStage& stage,
                              SimBuffers& buffers) {
  if (!acts()) return;
  if (share_ > 0) keep_loads();
  share_ = stage.share / substeps_;
  share_bits_ = std::bit_cast<std::uint32_t>(static_cast<float>(stage.share));
  read_list_.clear();
  if (std::exchange(length_, stage.length) != stage.length) upload_points(model_);
  if (!surface_.empty()) place_pieces(motion);
  motion_ = motion;
  if (!pairs_.empty()) {
    const bool had_pairs = !pairs_.rows().empty();
    pairs_.begin(time, stage, buffers, surface_.row_count);
    if (had_pairs || !pairs_.rows().empty()) upload_pairs();
  }
  starts_.begin(model_.gravity, pairs_);
}

void ContactTerm::move_bodies(const BodyMotions& motions, SimBuffers& buffers, gl::Downloads& downloads) {
  std::vector<vec4> at(buffers.vertex_count), from(at.size()), aim(at.size());
  std::vector<vec4> left(surface_.row_count + pairs_.row_count());
  std::vector<vec4> normals(surface_.row_count), rows(surface_.row_count);
  downloads.add(buffers.displacement, at.size() * sizeof(vec4), at.data());
  downloads.add(buffers.start_of_stage(), from.size() * sizeof(vec4), from.data());
  downloads.add(buffers.predicted, aim.size() * sizeof(vec4), aim.data());
  downloads.add(buffers.contact_before, left.size() * sizeof(vec4), left.data());
  if (!rows.empty()) {
    downloads.add(normals_, normals.size() * sizeof(vec4), normals.data());
    downloads.add(rows_, rows.size() * sizeof(vec4), rows.data());
  }
  downloads.run();
  ContactMemory before = SimBuffers::contact_forces(left);
  for (const PairRow& row : pairs_.rows()) before[surface_.row_count + force_row(row.slot)].normal = row.before;
  const auto flat = [](const std::vector<Vector3d>& vectors) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(vectors.data()->data(), 3 * static_cast<Eigen::Index>(vectors.size()));
  };
  std::vector<double> stiffness;
  for (const vec4& row : rows) stiffness.push_back(row.w);
  ContactEnergy energy(model_, surface_, stiffness, before, flat(buffers.vectors_of(from)), motion_, pairs_.rows());
  if (!rows.empty())
    energy.take_planes([&](std::uint32_t row) -> std::optional<ToolEntry> {
      const vec4& plane = normals[row];
      if (plane.w == kNoPlane) return std::nullopt;
      const Vector3d normal(plane.x, plane.y, plane.z);
      return ToolEntry{normal, plane.w + normal.dot(origin_)};
    });
  std::vector<Vector3d> u = buffers.vectors_of(at);
  if (motions.move(&energy, buffers.vectors_of(aim), length_, u)) buffers.upload_displacements(u, at);
  std::vector<RowState> states(left.size(), {0, {0, 0, 0}});
  energy.put_rows(states, flat(u));
  std::vector<vec4> moved;
  for (const RowState& state : states) {
    const Eigen::Vector3f q = state.tangential.cast<float>();
    moved.push_back({q.x(), q.y(), q.z(), static_cast<float>(state.depth)});
  }
  moved_rows_.upload(0, moved.size() * sizeof(vec4), moved.data());
  has_moved_rows_ = true;
}

void ContactTerm::forget_moved_rows() {
  if (!std::exchange(has_moved_rows_, false)) return;
  const std::vector<vec4> none(surface_.row_count + pairs_.row_count(), vec4{0, 0, 0, kNoPlane});
  moved_rows_.upload(0, none.size() * sizeof(vec4), none.data());
}

bool ContactTerm::search_again(SimBuffers& buffers) {
  if (!pairs_.search_again(buffers, surface_.row_count)) return false;
  read_list_.clear();
  upload_pairs();
  return true;
}

void ContactTerm::place_pieces(const ToolMotion& motion) {
  std::vector<vec4> rows;
  for (const ContactPiece& piece : surface_.pieces) {
    const Tool& tool = tools_[piece.tool];
    const ToolPlace &from = motion.from[piece.tool], &to = motion.to[piece.tool];
    RigidPose before = tool.pose_of_piece(piece.piece, from), after = tool.pose_of_piece(piece.piece, to);
    ToolShape placed = tool.shape;
    if (!origin_.isZero()) {
      const Vector3d by = move_to_middle(placed);
      for (RigidPose* pose : {&before, &after}) pose->origin += pose->axes * by - origin_;
    }
    const PieceRows shape = piece_rows_of(placed, first_nodes_[piece.tool]);
    const double reach = farthest_way(placed, before, after) + margin_;
    add(rows, after, tool.friction, surface_.full_slip, reach, half_thickness_);
    add(rows, before, shape.kind, piece.first_row, piece.points, let_in_);
    rows.push_back(shape.a);
    rows.push_back(shape.b);
    rows.push_back(row_of(to.pose.origin - origin_, std::min(finest_radius(tool.shape), 1e30)));
    const Vector3d lost = rounding_of(after.origin) + after.axes * shape.lost_place;
    rows.push_back(row_of(lost));
    rows.push_back(row_of(shape.lost_half, shape.lost_radius));
    rows.push_back(row_of({1.0 * piece.everywhere, surface_.edge_width, surface_.first_reach}, shape.round));
  }
  const auto same = [](const vec4& a, const vec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; };
  if (std::equal(rows.begin(), rows.end(), uploaded_.begin(), uploaded_.end(), same)) return;
  pieces_.upload(0, rows.size() * sizeof(vec4), rows.data());
  uploaded_ = std::move(rows);
}

void ContactTerm::upload_pairs() {
  const auto count = static_cast<std::uint32_t>(pairs_.rows().size());
  counts_.upload(sizeof count * stretches(), sizeof count, &count);
  std::vector<Tet> vertices;
  std::vector<vec4> weights, constants;
  std::vector<std::uint32_t> listed;
  places_.resize(point_count());
  for (const PairRow& pair : pairs_.rows()) {
    Tet& placed = vertices.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) placed[k] = buffers_.placement.place[pair.vertices[k]];
    places_.push_back(placed);
    const std::array<float, 4> w = weights_of(pair);
    weights.push_back({w[0], w[1], w[2], w[3]});
    constants.push_back(row_of(pair.normal, pair.gap));
    constants.push_back(row_of(pair.start, pair.stiffness));
    constants.push_back(
        row_of({model_.contact.friction, static_cast<double>(surface_.row_count + force_row(pair.slot)), 0}));
    listed.push_back(point_count() + static_cast<std::uint32_t>(listed.size()));
  }
  vertices_.upload(sizeof(Tet) * point_count(), vertices.size() * sizeof(Tet), vertices.data());
  weights_.upload(sizeof(vec4) * point_count(), weights.size() * sizeof(vec4), weights.data());
  constants_.upload(0, constants.size() * sizeof(vec4), constants.data());
  list_.upload(4 * sizeof(std::uint32_t), listed.size() * sizeof(std::uint32_t), listed.data());
  upload_entries();
}

void ContactTerm::upload_entries() {
  std::vector<std::vector<Entry>> of_pairs(pairs_.rows().empty() ? 0 : point_entries_.size());
  for (std::uint32_t k = 0; k < pairs_.rows().size(); ++k)
    for (std::uint32_t corner = 0; corner < 4; ++corner)
      if (pairs_.rows()[k].weights[corner] != 0)
        of_pairs[places_[point_count() + k][corner]].push_back(
            entry_of(point_count() + k, corner, weights_of(pairs_.rows()[k])[corner]));
  std::vector<std::uint32_t> begin{0};
  std::vector<Entry> entries;
  for (std::size_t v = 0; v < point_entries_.size(); ++v) {
    entries.insert(entries.end(), point_entries_[v].begin(), point_entries_[v].end());
    if (!of_pairs.empty()) entries.insert(entries.end(), of_pairs[v].begin(), of_pairs[v].end());
    if (entries.size() % 2 != 0) entries.push_back({entries.back()[0] & ~kFirstCorner, 0});
    begin.push_back(static_cast<std::uint32_t>(entries.size() / 2));
  }
  begin_.upload(0, begin.size() * sizeof(std::uint32_t), begin.data());
  entries_.upload(0, entries.size() * sizeof(Entry), entries.data());
}

}  // namespace fascia
