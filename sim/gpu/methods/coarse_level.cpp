#include "sim/gpu/methods/coarse_level.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "sim/coarse/coarse_gather.h"
#include "sim/coarse/coarse_matrix.h"
#include "sim/coarse/linear_model.h"
#include "sim/gpu/passes/reduction.h"

namespace fascia {
namespace {

using shared::vec4;

constexpr float kOne = 32767;  // of entries of the inverse

// A sparse matrix by rows, for the GPU.
struct PackedRows {
  std::vector<std::uint32_t> begin{0};  // [row count + 1]
  std::vector<Tet>
      pairs;  // two entries each: column and weight (float bits) alternating; an odd last one is padded with zeros
};

PackedRows pack_rows(const std::vector<std::uint32_t>& begin, const std::vector<std::uint32_t>& column,
                     const std::vector<double>& weights) {
  PackedRows rows;
  const auto weight = [&](std::uint32_t k) { return std::bit_cast<std::uint32_t>(static_cast<float>(weights[k])); };
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    const std::uint32_t end = begin[i + 1];
    for (std::uint32_t k = begin[i]; k < end; k += 2)
      rows.pairs.push_back({column[k], weight(k), k + 1 < end ? column[k + 1] : 0, k + 1 < end ? weight(k + 1) : 0});
    rows.begin.push_back(static_cast<std::uint32_t>(rows.pairs.size()));
  }
  return rows;
}

}  // namespace

CoarseLevel::CoarseLevel(const gl::ProgramCache& programs, const Model& model, const SolverSettings& settings)
    : relaxed_(settings.tolerance == 0 && has_large_bulk(model)),
      materials_(model.materials),
      h_(settings.stage_length()) {
  Model linear = linear_model(model, relaxed_);
  space_ = make_coarse_space(linear, coarse_node_target(linear.tets.size()));
  if (empty()) return;
  const CoarseGather gather = make_coarse_gather(linear, space_);
  std::vector<Tet> entries;  // of c_ja [1/m] (float bits) and the vertex
  for (std::size_t k = 0; k < gather.vertex.size(); ++k) {
    const Eigen::Vector3f c = gather.gradient[k].cast<float>();
    entries.push_back({std::bit_cast<std::uint32_t>(c.x()), std::bit_cast<std::uint32_t>(c.y()),
                       std::bit_cast<std::uint32_t>(c.z()), gather.vertex[k]});
  }
  const std::uint32_t n = space_.node_count;
  lanes_ = programs.sums_in_groups() ? Reduction::kGroup : 1;
  row_octets_ = (3 * n + 7) / 8;
  gather_entry_ = gl::Buffer("gather_entry", entries);
  const CoarseTranspose transposed = transpose(space_);
  const PackedRows columns = pack_rows(transposed.begin, transposed.vertex, transposed.weight);
  std::vector<std::uint32_t> begin;
  for (std::uint32_t i = 0; i <= n; ++i) begin.insert(begin.end(), {gather.begin[i], columns.begin[i]});
  for (std::uint32_t i = 0; i < n; ++i)
    most_entries_ =
        std::max(most_entries_, gather.begin[i + 1] - gather.begin[i] + columns.begin[i + 1] - columns.begin[i]);
  node_begin_ = gl::Buffer("coarse_node_begin", begin);
  columns_ = gl::Buffer("coarse_columns", columns.pairs);
  const PackedRows rows = pack_rows(space_.begin, space_.node, space_.weight);
  row_begin_ = gl::Buffer("coarse_row_begin", rows.begin);
  rows_ = gl::Buffer("coarse_rows", rows.pairs);
  rotation_ = gl::Buffer("coarse_rotation", sizeof(vec4) * n);
  gradient_ = gl::Buffer("coarse_gradient", 2 * sizeof(vec4) * row_octets_);
  inverse_rows_ = gl::Buffer("coarse_inverse", sizeof(Tet) * row_octets_ * 3 * n);
  scale_ = gl::Buffer("coarse_scale", sizeof(vec4) * n);
  correction_ = gl::Buffer("coarse_correction", sizeof(vec4) * n);
  if (model.has_contact()) {
    constexpr std::size_t kMost = TouchedNodes::kMost;
    touched_ = gl::Buffer("coarse_touched", std::vector<std::uint32_t>(1 + kMost));
    contact_matrix_ = gl::Buffer("coarse_contact", sizeof(vec4) * 3 * kMost * kMost);
    free_ = gl::Buffer("coarse_free", sizeof(vec4) * kMost);
  }
  start({std::move(linear), settings.stage_length()});
}

gl::ComputePass CoarseLevel::restriction(const Recording& r, const gl::Buffer& gradient) const {
  gl::ComputePass pass(r.programs.compute("sim/two_level/coarse_restrict.comp"),
                       gl::ComputePass::Bindings{{"coarse_node_begin", &node_begin_},
                                                 {"gather_entry", &gather_entry_},
                                                 {"coarse_columns", &columns_},
                                                 {"gradient", &gradient},
                                                 {"displacement", &r.buffers.displacement},
                                                 {"coarse_scale", &scale_},
                                                 {"coarse_rotation", &rotation_},
                                                 {"coarse_gradient", &gradient_}},
                       space_.node_count * lanes_);
  pass.loops(most_entries_ + 16);
  return pass;
}

Passes CoarseLevel::begin(const Recording& r, const gl::Buffer& gradient) const {
  Passes passes;
  if (contact_matrix_ && r.has_blocks()) passes.push_back(restriction(r, gradient));
  return passes;
}

Passes CoarseLevel::passes(const Recording& r, const gl::Buffer& gradient) const {
  Passes passes;
  passes.push_back(restriction(r, gradient));
  const auto solve = [&](bool touched, std::uint32_t nodes, gl::ComputePass::Bindings more) {
    more.insert(more.end(),
                {{"coarse_inverse", &inverse_rows_}, {"coarse_scale", &scale_}, {"coarse_gradient", &gradient_}});
    passes
        .emplace_back(r.programs.compute("sim/two_level/coarse_solve.comp", {{"TOUCHED", touched ? "1" : "0"}}),
                      std::move(more), lanes_ > 1 ? nodes * lanes_ : (nodes + 1) / 2,
                      gl::ComputePass::Constants{{"row_octets", row_octets_}, {"nodes", nodes}})
        .loops(row_octets_ + 1);
  };
  if (contact_matrix_ && r.has_blocks()) {
    constexpr auto kMost = static_cast<std::uint32_t>(TouchedNodes::kMost);
    solve(true, kMost, {{"coarse_touched", &touched_}, {"coarse_free", &free_}});
    passes
        .emplace_back(r.programs.compute("sim/two_level/coarse_contact.comp"),
                      gl::ComputePass::Bindings{{"coarse_touched", &touched_},
                                                {"coarse_contact", &contact_matrix_},
                                                {"coarse_scale", &scale_},
                                                {"coarse_free", &free_},
                                                {"coarse_gradient", &gradient_}},
                      kMost * lanes_)
        .loops(kMost + 1);
  }
  solve(false, space_.node_count, {{"coarse_rotation", &rotation_}, {"coarse_correction", &correction_}});
  return passes;
}

Eigen::MatrixXf CoarseLevel::compute(const CoarseSpace& space, const Job& job) {
  return coarse_inverse(coarse_matrix(job.model, space, job.h));
}

void CoarseLevel::upload() {
  const Eigen::MatrixXf inverse = with_stiffness(free_inverse_, space_, springs_, h_);
  const Eigen::VectorXf scale = (inverse.diagonal().cwiseMax(0) / kOne).cwiseSqrt();
  const std::size_t row_length = std::size_t{8} * row_octets_;
  std::vector<std::int16_t> rows(row_length * static_cast<std::size_t>(inverse.rows()), 0);
  for (Eigen::Index i = 0; i < inverse.rows(); ++i)
    for (Eigen::Index k = 0; k < inverse.cols(); ++k)
      if (const float product = scale[i] * scale[k]; product > 0)  // symmetric
        rows[static_cast<std::size_t>(i) * row_length + static_cast<std::size_t>(k)] =
            static_cast<std::int16_t>(std::lround(std::clamp(inverse(k, i) / product, -kOne, kOne)));
  inverse_rows_.upload(0, rows.size() * sizeof(std::int16_t), rows.data());
  std::vector<vec4> scales;
  for (Eigen::Index i = 0; i < inverse.rows(); i += 3) scales.push_back({scale[i], scale[i + 1], scale[i + 2], 0});
  scale_.upload(0, scales.size() * sizeof(vec4), scales.data());
  if (!contact_matrix_) return;
  quantized_ = std::move(rows);
  scales_ = scale;
  compliance_ = {};
  if (!contact_.nodes.empty()) upload_contact();
}

void CoarseLevel::read_for_contact(gl::Downloads& downloads) {
  if (!contact_matrix_) return;
  node_rotations_.resize(space_.node_count);
  downloads.add(rotation_, node_rotations_.size() * sizeof(vec4), node_rotations_.data());
}

void CoarseLevel::set_contact(const std::vector<PointStiffness>& points) {
  if (empty() || !contact_matrix_ || (points.empty() && contact_.nodes.empty())) return;
  std::vector<Eigen::Quaternionf> rotations;
  if (!points.empty())
    for (const vec4& q : node_rotations_) rotations.emplace_back(q.w, q.x, q.y, q.z);
  TouchedNodes now = touched_nodes(space_, point_functions_, points, rotations, h_);
  const auto compliance = [&](Eigen::Index i) { return kOne * scales_[i] * scales_[i]; };
  if (keeps_contact_ && alike(now, contact_, compliance)) return;
  keeps_contact_ = true;
  contact_ = std::move(now);
  contact_stiffness_ = stiffness_between(contact_.nodes, space_, point_functions_, points, rotations, h_);
  upload_contact();
}

void CoarseLevel::upload_contact() {
  const std::size_t row_length = std::size_t{8} * row_octets_;
  if (compliance_.nodes != contact_.nodes)
    compliance_ = compliance_of(contact_.nodes, [&](Eigen::Index i, Eigen::Index k) {
      return scales_[i] * scales_[k] *
             static_cast<float>(quantized_[static_cast<std::size_t>(i) * row_length + static_cast<std::size_t>(k)]);
    });
  const Eigen::MatrixXf push = push_back(contact_stiffness_, compliance_);
  std::vector<std::uint32_t> touched{static_cast<std::uint32_t>(contact_.nodes.size())};
  touched.insert(touched.end(), contact_.nodes.begin(), contact_.nodes.end());
  std::vector<vec4> columns;
  for (Eigen::Index i = 0; i < push.rows(); i += 3)
    for (Eigen::Index k = 0; k < push.cols(); ++k) columns.push_back({push(i, k), push(i + 1, k), push(i + 2, k), 0});
  touched_.upload(0, touched.size() * sizeof(std::uint32_t), touched.data());
  if (!columns.empty()) contact_matrix_.upload(0, columns.size() * sizeof(vec4), columns.data());
}

bool CoarseLevel::ready() const {
  return free_inverse_.size() > 0 || !inverse_.valid() ||
         inverse_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void CoarseLevel::complete() {
  if (free_inverse_.size() == 0 && inverse_.valid()) take_next();
}

void CoarseLevel::start(Job job) {
  inverse_ = std::async(std::launch::async, [space = space_, job = std::move(job)] { return compute(space, job); });
}

void CoarseLevel::values_changed(const Model& model, const SolverSettings& settings) {
  if (empty() || (model.materials == materials_ && settings.stage_length() == h_)) return;
  materials_ = model.materials;
  h_ = settings.stage_length();
  request(model);
}

void CoarseLevel::relax(const Model& model, bool relaxed) {
  if (empty() || relaxed == relaxed_) return;
  relaxed_ = relaxed;
  request(model);
}

void CoarseLevel::request(const Model& model) {
  Job job{linear_model(model, relaxed_), h_};
  if (inverse_.valid())
    next_ = std::move(job);
  else
    start(std::move(job));
}

void CoarseLevel::set_stiffness(const std::vector<VertexStiffness>& springs) {
  if (empty() || springs == springs_) return;
  springs_ = springs;
  if (free_inverse_.size() > 0) upload();
}

void CoarseLevel::take_next() {
  free_inverse_ = inverse_.get();
  upload();
  if (!next_) return;
  start(std::move(*next_));
  next_.reset();
}

int CoarseLevel::update(bool wait) {
  if (wait) complete();
  int taken = 0;
  for (; inverse_.valid(); ++taken) {
    if (!wait && inverse_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) break;
    take_next();
  }
  return taken;
}

void CoarseLevel::take(int count) {
  complete();
  for (; count > 0 && inverse_.valid(); --count) take_next();
}

}  // namespace fascia
