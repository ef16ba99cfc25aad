// Contact with tools on the GPU: the energy of sim/contact/contact_energy.h as one more term of the step's objective.
// Points near no piece cost one pass at the start of a stage; forces, energies and curvatures are computed over the
// list of the others, whose length the GPU knows alone.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/coarse/coarse_contact.h"
#include "sim/contact/contact_surface.h"
#include "sim/contact/tool_load.h"
#include "sim/gpu/passes/energy_term.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

class ContactTerm : public EnergyTerm {
 public:
  static constexpr std::size_t kMostPieces = 32;  // bits of a point's mask

  /// `model`: in its own order, outlives this as `buffers` do, which hold its vertices in theirs, and get their
  /// contact_memory here. The model's materials may change. Throws Error for more than kMostPieces pieces.
  ContactTerm(const Model& model, SimBuffers& buffers);

  void materials_changed(const Model& model);
  /// The poses of a stage.
  void begin_stage(const ToolMotion& motion);

  std::string name() const override { return "contact"; }
  bool acts() const override { return !surface_.empty(); }
  bool has_blocks() const override { return true; }
  std::optional<std::string> define(TermUse use) const override;
  void bind(TermUse use, gl::ComputePass::Bindings& bindings) const override;
  std::vector<VertexStiffness> stiffness() const override { return {}; }
  Passes project(gl::ProgramCache&, const SimBuffers&, bool) const override { return {}; }
  Passes impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes begin(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes evaluate(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes finish(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes curvature(gl::ProgramCache& programs, const SimBuffers& buffers, const TermCurvature& at) const override;
  std::uint32_t curvature_partials(const gl::ProgramCache& programs) const override;

  /// The stiffness of the points that press or stick, as the last forces were computed, at places of the buffers'
  /// vertices. Waits for the GPU.
  std::vector<PointStiffness> stiffness_at_points() const;

  /// [vertex of the model] forces on the tissue at the end of the last stage [N]; waits for the GPU.
  std::vector<Eigen::Vector3d> forces_at_vertices() const;
  /// So that a state that is set does not show the forces of another one.
  void forget_forces();
  /// What shaders/sim/contact/pressure.glsl reads.
  void bind_pressure(gl::ComputePass::Bindings& bindings);

  const gl::Buffer& loads() const { return loads_; }  // filled by the passes of impulses()
  /// From the content of loads(): [tool].
  std::vector<ToolLoad> sum_of(const std::vector<shared::vec4>& loads) const;

 private:
  void make_grids();
  gl::Defines defines() const;  // of the shapes that there are
  gl::ComputePass over_points(gl::ProgramCache& programs, const char* kernel, gl::ComputePass::Bindings more) const;
  gl::ComputePass over_near(gl::ProgramCache& programs, const char* kernel, gl::ComputePass::Bindings more) const;
  std::uint32_t loops_of_point() const;
  std::uint32_t point_count() const { return static_cast<std::uint32_t>(surface_.points.size()); }

  const Model& model_;
  const SimBuffers& buffers_;
  std::vector<Tool> tools_;
  ContactSurface surface_;
  double half_thickness_ = 0, margin_ = 0;            // [m]; margin: added to the reach of every piece
  std::uint32_t most_entries_ = 0;                    // of a vertex
  std::vector<std::array<std::uint32_t, 3>> places_;  // of the points' vertices
  gl::Buffer vertices_, weights_, rest_;              // of the points
  gl::Buffer begin_, end_, entries_;                  // the points of every vertex
  std::vector<std::size_t> first_nodes_;              // [tool] in grids_
  gl::Buffer grids_;  // float, of the tools that are meshes (sim/tool/solid_mesh.h); else absent
  gl::Buffer pieces_, near_, counts_, list_;
  gl::Buffer rows_, normals_, forces_, blocks_, loads_;
  gl::Buffer areas_;                    // float [vertex_count] [m^2]; created for the first picture of pressures
  std::vector<shared::vec4> uploaded_;  // of pieces_
};

}  // namespace fascia
