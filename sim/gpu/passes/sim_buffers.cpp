#include "sim/gpu/passes/sim_buffers.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

namespace fascia {
namespace {

using shared::vec4;

// A vertex counts as diverged at this multiple of the scene's size plus gravity's displacement in a substep from its
// prediction.
constexpr double kFarthest = 100;

vec4 to_vec4(const Eigen::Vector3d& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), static_cast<float>(w)};
}

// The fraction of the last component is that of shaders/sim/elasticity/feature_material.glsl.
vec4 to_vec4(const Material& m, Hardness hardness) {
  float model = static_cast<float>(m.model);
  if (m.model == MaterialModel::mooney_rivlin) model += 0.5f * static_cast<float>(m.mooney_ratio);
  if (m.model == MaterialModel::squared && hardness != Hardness::own)
    model += hardness == Hardness::eased ? 0.5f : 0.25f;
  return {static_cast<float>(m.young_modulus), static_cast<float>(m.poisson_ratio), static_cast<float>(m.damping),
          model};
}

// Adds the elements at every vertex v to counts[v + 1].
template <class Elements>
void count_at(std::vector<std::uint32_t>& counts, const Elements& elements) {
  for (const auto& vertices : elements)
    for (const std::uint32_t v : vertices) ++counts[v + 1];
}

struct Shape {
  Eigen::Matrix3d gradients;  // rows for the last three corners
  double volume;

  Shape(const Model& model, const Tet& tet) {
    Eigen::Matrix3d dm;
    for (int k = 0; k < 3; ++k) dm.col(k) = model.rest_positions[tet[k + 1]] - model.rest_positions[tet[0]];
    gradients = dm.inverse();
    volume = dm.determinant() / 6;
  }
};

// The shapes of tets in the order of a TetPairing with aligned pairs, and the data that shaders/common/tet_pair.glsl
// reads of their second tets; without the slots of the fifth corners.
struct Shapes {
  std::vector<vec4> rows;
  std::vector<Tet> fifth;

  Shapes(const Model& model, const std::vector<Tet>& tets, const TetPairing& pairing)
      : rows(3 * tets.size()), fifth(pairing.second_begin()) {
    const std::uint32_t pair_count = pairing.pair_count;
    const auto bits = [](double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); };
    for (std::size_t t = 0; t < tets.size(); ++t) {
      const Shape a(model, tets[t]);
      Eigen::Vector3d beside(a.volume, 0, 0);  // the rows
      if (t < pair_count) {
        const Tet& second = tets[fifth.size() + t];
        const Shape b(model, second);
        const Eigen::RowVector3d bx = a.gradients.row(2);
        const auto along = [&](const Eigen::RowVector3d& difference) { return difference.dot(bx) / bx.squaredNorm(); };
        beside[1] = along(b.gradients.row(1) - a.gradients.row(0));
        beside[2] = along(b.gradients.row(0) - a.gradients.row(1));
        fifth[t] = {second[3], 0, bits(-along(b.gradients.row(2))), bits(b.volume)};
      } else if (t < fifth.size()) {
        fifth[t] = {tets[t][3], 0, bits(-1), bits(a.volume)};
      }
      for (int k = 0; k < 3; ++k)
        rows[3 * t + static_cast<std::size_t>(k)] = to_vec4(a.gradients.row(k).transpose(), beside[k]);
    }
  }
};

// The numbers of linear and of quadratic tets at the vertices before each one.
struct Offsets {
  std::vector<std::uint32_t> linear, quadratic;  // [vertex_count + 1]

  Offsets(const std::vector<Tet>& tets, const TetPairing& pairing, const std::vector<MidEdges>& middles,
          std::uint32_t vertex_count)
      : linear(vertex_count + 1, 0), quadratic(vertex_count + 1, 0) {
    const std::span all(tets);
    count_at(linear, all.first(pairing.linear_count()));
    count_at(quadratic, all.subspan(pairing.linear_count()));
    count_at(quadratic, middles);
    for (std::vector<std::uint32_t>* counts : {&linear, &quadratic})
      std::partial_sum(counts->begin(), counts->end(), counts->begin());
  }
};

// The slots in which the corners of pairs and single tets, and the vertices of quadratic tets, store their corrections:
// a counting sort by vertex.
struct Slots {
  gl::Buffer correction, pair, quadratic, begin;  // as in SimBuffers
  std::uint32_t most = 0;                         // largest number per vertex

  // `tets`: in the order of a TetPairing. The slots of the fifth corners are written next to the vertices.
  Slots(const std::vector<Tet>& tets, const TetPairing& pairing, const std::vector<MidEdges>& middles,
        std::uint32_t vertex_count, std::vector<Tet>& fifth) {
    std::vector<Tet> corners(tets.begin(), tets.begin() + static_cast<std::ptrdiff_t>(pairing.second_begin()));
    const std::vector<Tet> whole(tets.begin() + static_cast<std::ptrdiff_t>(pairing.linear_count()), tets.end());
    std::vector<std::uint32_t> begins(vertex_count + 1, 0);
    count_at(begins, corners);
    count_at(begins, whole);
    count_at(begins, middles);
    for (std::uint32_t i = 0; i < pairing.pair_count; ++i) ++begins[fifth[i][0] + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    for (std::uint32_t v = 0; v < vertex_count; ++v) most = std::max(most, begins[v + 1] - begins[v]);
    begin = gl::Buffer("slot_begin", begins);
    correction = gl::Buffer("correction", begins.back() * sizeof(vec4));
    std::vector<std::uint32_t>& next = begins;  // next free slot of each vertex
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      for (std::uint32_t& v : corners[i]) v = next[v]++;
      if (i < pairing.pair_count) fifth[i][1] = next[fifth[i][0]]++;
    }
    if (!corners.empty() || whole.empty()) pair = gl::Buffer("pair_slots", corners);
    std::vector<Tet> of_quadratic;
    for (std::size_t q = 0; q < whole.size(); ++q) {
      const MidEdges& m = middles[q];
      for (const Tet& vertices : {whole[q], Tet{m[0], m[1], m[2], m[3]}}) {
        Tet& four = of_quadratic.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) four[k] = next[vertices[k]]++;
      }
      const std::uint32_t fifth_middle = next[m[4]]++, sixth_middle = next[m[5]]++;
      of_quadratic.push_back({fifth_middle, sixth_middle, 0, 0});
    }
    if (!whole.empty()) quadratic = gl::Buffer("quadratic_slots", of_quadratic);
  }
};

}  // namespace

SimBuffers::SimBuffers(const Model& model, MeshOrder places)
    : vertex_count(static_cast<std::uint32_t>(model.rest_positions.size())),
      placement(std::move(places)),
      placed_vertex("placed_vertex", placement.vertex) {
  tet_count = static_cast<std::uint32_t>(placement.tets.order.size());
  leaves_out = tet_count < model.tets.size();
  const std::size_t vertex_bytes = vertex_count * sizeof(vec4);
  displacement = gl::Buffer("displacement", vertex_bytes);
  velocity = gl::Buffer("velocity", vertex_bytes);
  previous_displacement = gl::Buffer("previous_displacement", vertex_bytes);
  predicted = gl::Buffer("predicted", vertex_bytes);
  rest_position = gl::Buffer("rest_position", vertex_bytes);
  mass = gl::Buffer("mass", vertex_count * sizeof(float));
  set_tet_order(model, placement.tets);
  for (const Tet& tet : model.tets) {
    const std::vector<Eigen::Vector3d>& x = model.rest_positions;
    volume += (x[tet[1]] - x[tet[0]]).cross(x[tet[2]] - x[tet[0]]).dot(x[tet[3]] - x[tet[0]]) / 6;
  }
  Eigen::AlignedBox3d box;
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) box.extend(model.rest_positions[v]);
  size = box.diagonal().norm();
  if (model.materials.size() > 1) {
    materials = gl::Buffer("materials", model.materials.size() * sizeof(vec4));
  }
  diverged = gl::Buffer("diverged", sizeof(std::uint32_t));
  step = gl::Buffer("step", sizeof(shared::StepValues));
  upload_materials(model);
}

void SimBuffers::set_tet_order(const Model& model, const TetPairing& pairing) {
  const std::vector<std::uint32_t>& order = pairing.order;
  std::vector<Tet> ordered;
  std::vector<MidEdges> middles;
  std::vector<std::uint32_t> material;
  ordered.reserve(order.size());
  for (const std::uint32_t t : order) {
    ordered.push_back(model.tets[t]);
    if (model.is_quadratic(t)) middles.push_back(model.mid_edges[t]);
    if (model.materials.size() > 1) material.push_back(model.tet_material[t]);
  }
  for (std::size_t i = 0; i < pairing.pair_count; ++i) align_at_face(ordered[i], ordered[pairing.second_begin() + i]);
  Shapes shapes(model, ordered, pairing);
  Slots slots(ordered, pairing, middles, vertex_count, shapes.fifth);
  Offsets offsets(ordered, pairing, middles, vertex_count);
  gl::Buffer vertices("tet_vertices", ordered), rows("tet_shape", shapes.rows), fifths, begins, packed_middles,
      quadratic_begins;
  if (!shapes.fifth.empty() || middles.empty()) {
    fifths = gl::Buffer("pair_fifth", shapes.fifth);
    begins = gl::Buffer("tet_begin", offsets.linear);
  }
  if (!middles.empty()) {
    std::vector<Tet> packed;
    for (const MidEdges& m : middles) packed.insert(packed.end(), {{m[0], m[1], m[2], m[3]}, {m[4], m[5], 0, 0}});
    packed_middles = gl::Buffer("mid_edges", packed);
    quadratic_begins = gl::Buffer("quadratic_begin", offsets.quadratic);
  }
  if (!material.empty()) tet_material = gl::Buffer("tet_material", material);
  tet_vertices = std::move(vertices);
  tet_shape = std::move(rows);
  correction = std::move(slots.correction);
  slot_begin = std::move(slots.begin);
  pair_fifth = std::move(fifths);
  pair_slots = std::move(slots.pair);
  tet_begin = std::move(begins);
  mid_edges = std::move(packed_middles);
  quadratic_slots = std::move(slots.quadratic);
  quadratic_begin = std::move(quadratic_begins);
  most_slots = slots.most;
  pair_count = pairing.pair_count;
  quadratic_count = pairing.quadratic_count;
  most_tets = 0;
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    most_tets = std::max(most_tets,
                         offsets.linear[v + 1] - offsets.linear[v] + offsets.quadratic[v + 1] - offsets.quadratic[v]);
  quadratic_tets.assign(order.begin() + pairing.linear_count(), order.end());
  if (has_quadratic()) {
    if (!own_mass) own_mass = gl::Buffer("own_mass", vertex_count * sizeof(float));
    predicted_centroid = gl::Buffer("predicted_centroid", quadratic_count * sizeof(vec4));
    multiplier = gl::Buffer("multiplier", std::vector<float>(quadratic_count, UNKNOWN_MULTIPLIER));
    upload_moving_masses(model);
  }
  tets = std::move(ordered);
  mid_edge_vertices = std::move(middles);
  tet_offsets = std::move(offsets.linear);
  quadratic_offsets = std::move(offsets.quadratic);
}

void SimBuffers::set_phantom_count(std::uint32_t count) {
  const std::size_t bytes = (vertex_count + count) * sizeof(vec4);
  if (bytes == displacement.bytes()) return;
  gl::Buffer wider("displacement", bytes);
  wider.copy(displacement, vertex_count * sizeof(vec4));
  displacement = std::move(wider);
}

void SimBuffers::upload_displacements(const std::vector<Eigen::Vector3d>& u, const std::vector<vec4>& before) {
  std::vector<vec4> values(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i)
    values[i] = to_vec4(u[placement.vertex[i]], before.empty() ? 0 : before[i].w);
  displacement.upload(0, values.size() * sizeof(vec4), values.data());
  if (!displacement_low) return;
  for (std::size_t i = 0; i < vertex_count; ++i)
    values[i] = to_vec4(u[placement.vertex[i]] - Eigen::Vector3d(values[i].x, values[i].y, values[i].z), 0);
  displacement_low.upload(0, values.size() * sizeof(vec4), values.data());
}

void SimBuffers::upload_velocities(const std::vector<Eigen::Vector3d>& v) {
  std::vector<vec4> values(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) values[i] = to_vec4(v[placement.vertex[i]], 0);
  velocity.upload(0, values.size() * sizeof(vec4), values.data());
}

void SimBuffers::upload_state(const Model& model, const State& state) {
  upload_displacements(state.displacement);
  std::vector<vec4> values(vertex_count);
  std::vector<char> fixed(vertex_count);
  for (const std::uint32_t v : model.fixed) fixed[v] = 1;
  for (std::size_t i = 0; i < vertex_count; ++i)
    values[i] = to_vec4(fixed[i] ? Eigen::Vector3d(0, 0, 0) : state.velocity[placement.vertex[i]], 0);
  velocity.upload(0, values.size() * sizeof(vec4), values.data());
  if (contact_memory) upload_contact(state.contact);
  if (!earlier_displacement || state.earlier.step == 0) return;
  for (const auto& [buffer, vectors] : {std::pair(&earlier_displacement, &state.earlier.displacement),
                                        std::pair(&earlier_velocity, &state.earlier.velocity)}) {
    for (std::size_t i = 0; i < vertex_count; ++i) values[i] = to_vec4((*vectors)[placement.vertex[i]], 0);
    buffer->upload(0, values.size() * sizeof(vec4), values.data());
  }
}

void SimBuffers::forget_multipliers() {
  if (!has_quadratic()) return;
  const std::vector<float> unknown(quadratic_count, UNKNOWN_MULTIPLIER);
  multiplier.upload(0, multiplier.bytes(), unknown.data());
}

void SimBuffers::keep_earlier(bool kept) {
  if (kept == static_cast<bool>(earlier_displacement)) return;
  earlier_displacement = gl::Buffer();
  earlier_velocity = gl::Buffer();
  if (!kept) return;
  const std::vector<vec4> zero(vertex_count);
  earlier_displacement = gl::Buffer("earlier_displacement", zero);
  earlier_velocity = gl::Buffer("earlier_velocity", zero);
}

State SimBuffers::download_state(double time, double earlier_step) const {
  State state{download_vectors(displacement), download_vectors(velocity), time};
  if (earlier_step > 0)
    state.earlier = {download_vectors(earlier_displacement), download_vectors(earlier_velocity), earlier_step};
  if (displacement_low) {
    const std::vector<Eigen::Vector3d> low = download_vectors(displacement_low);
    for (std::size_t i = 0; i < vertex_count; ++i) state.displacement[i] += low[i];
  }
  if (contact_memory) state.contact = contact_forces(contact_memory);
  return state;
}

std::vector<Eigen::Vector3d> SimBuffers::download_accelerations(const Eigen::Vector3d& gravity, double l) const {
  const std::vector<vec4> u = displacement.read<vec4>(), inertial = predicted.read<vec4>();
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(vertex_count);
  for (const std::uint32_t place : placement.place) {
    const vec4 &at = u[place], &from = inertial[place];
    vectors.push_back(Eigen::Vector3d(double(at.x) - from.x, double(at.y) - from.y, double(at.z) - from.z) / (l * l));
    if (from.w > 0) vectors.back() += gravity;
  }
  return vectors;
}

ContactMemory SimBuffers::contact_forces(const gl::Buffer& buffer) const { return contact_forces(buffer.read<vec4>()); }

ContactMemory SimBuffers::contact_forces(const std::vector<vec4>& content) {
  ContactMemory memory;
  memory.reserve(content.size());
  for (const vec4& force : content) memory.push_back({{force.x, force.y, force.z}, force.w});
  return memory;
}

void SimBuffers::upload_contact(const ContactMemory& memory) {
  std::vector<vec4> forces(contact_memory.bytes() / sizeof(vec4));
  for (std::size_t row = 0; row < std::min(forces.size(), memory.size()); ++row)
    forces[row] = to_vec4(memory[row].friction, memory[row].normal);
  contact_memory.upload(0, contact_memory.bytes(), forces.data());
}

std::vector<Eigen::Vector3d> SimBuffers::download_vectors(const gl::Buffer& buffer) const {
  std::vector<vec4> values(vertex_count);
  buffer.download(0, values.size() * sizeof(vec4), values.data());
  return vectors_of(values);
}

std::vector<Eigen::Vector3d> SimBuffers::vectors_of(const std::vector<vec4>& content) const {
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(vertex_count);
  for (const std::uint32_t place : placement.place)
    vectors.emplace_back(content[place].x, content[place].y, content[place].z);
  return vectors;
}

void SimBuffers::upload_materials(const Model& model) {
  if (materials) {
    std::vector<vec4> values;
    for (const Material& m : model.materials) values.push_back(to_vec4(m, hardness));
    materials.upload(0, values.size() * sizeof(vec4), values.data());
  }
  const std::vector<double> masses = lumped_masses(model), rows = consistent_masses(model);
  const std::vector<char> held = model.held();
  std::vector<vec4> rest(vertex_count);
  std::vector<float> mass_values(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) {
    rest[i] = to_vec4(model.rest_positions[i], held[i] || masses[i] <= 0 ? 0 : 1 / masses[i]);
    mass_values[i] = static_cast<float>(rows[i]);
  }
  mean_mass = std::accumulate(masses.begin(), masses.end(), 0.0) / vertex_count;
  rest_position.upload(0, rest.size() * sizeof(vec4), rest.data());
  mass.upload(0, mass_values.size() * sizeof(float), mass_values.data());
  if (has_quadratic()) upload_moving_masses(model);
}

void SimBuffers::upload_moving_masses(const Model& model) {
  const MovingMasses moving = moving_masses(model);
  const std::vector<float> own(moving.own.begin(), moving.own.end());
  own_mass.upload(0, own.size() * sizeof(float), own.data());
  std::vector<vec4> centroids;
  for (const std::uint32_t t : quadratic_tets) centroids.push_back({0, 0, 0, static_cast<float>(moving.centroid[t])});
  predicted_centroid.upload(0, centroids.size() * sizeof(vec4), centroids.data());
}

void SimBuffers::upload_step(const Model& model, const SolverSettings& settings, const IntegratorStage& stage) {
  const double h = stage.length;
  const shared::StepValues values{
      to_vec4(model.gravity, h),
      {static_cast<float>(settings.spectral_radius), static_cast<float>(settings.iterations),
       static_cast<float>(settings.tolerance), static_cast<float>(1 / mean_mass)},
      to_vec4(model.materials.front(), hardness),
      {static_cast<float>(kFarthest * (size + h * h * model.gravity.norm())), static_cast<float>(stage.duration),
       static_cast<float>(stage.extrapolation), static_cast<float>(stage.share)}};
  step.upload(0, sizeof values, &values);
}

}  // namespace fascia
