// Contact on the GPU: the energy of sim/contact/contact_energy.h as one more term of the step's objective. Points near
// no piece of a tool cost one pass at the start of a stage; forces, energies and curvatures are computed over the list
// of the others, whose length the GPU knows alone. Pairs of the tissue with itself are found by the CPU, which reads
// the state at the start of a stage for that, and are at the head of the same list.
#pragma once
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "gl/downloads.h"
#include "sim/coarse/coarse_contact.h"
#include "sim/contact/contact_surface.h"
#include "sim/contact/pair_energy.h"
#include "sim/contact/step_loads.h"
#include "sim/gpu/contact/body_motions.h"
#include "sim/gpu/contact/body_starts.h"
#include "sim/gpu/contact/pair_stage.h"
#include "sim/gpu/passes/deferred_tets.h"
#include "sim/gpu/passes/energy_term.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

class ContactTerm : public EnergyTerm {
 public:
  /// `model`: in its own order, outlives this as `buffers` do, which hold its vertices in theirs, and get their
  /// contact_memory here. The model's materials may change. Throws Error for more than
  /// ContactSurface::kMostPieces pieces.
  ContactTerm(const Model& model, SimBuffers& buffers, gl::LoadPath loads);

  /// Also softens the forces in the buffers' contact_memory where tissue became softer. Waits for the GPU.
  void materials_changed(const Model& model, SimBuffers& buffers);
  /// Before the first stage of a step of so many substeps.
  void begin_step(int substeps);
  /// The poses of a stage that ends at `time` [s], and the pairs of the tissue. Waits for the GPU where tissue touches
  /// tissue, and for the loads of the step's stage before.
  void begin_stage(const ToolMotion& motion, double time, const IntegratorStage& stage, SimBuffers& buffers);
  /// Whether the stage's iterations led tissue through tissue. Their result is then where the next ones of the same
  /// stage start, with the pairs that are met on the way there. Waits for the GPU where tissue is near tissue.
  bool search_again(SimBuffers& buffers);
  /// After the last search of a stage, which need not have found a way around all that meets; after its end.
  void take_back(SimBuffers& buffers) { pairs_.take_back(buffers); }
  /// Before or after the iterations of a stage near tools or tissue: moves bodies that nothing holds as wholes, and has
  /// the forces at the end of the stage from places in double precision. Waits for the GPU.
  void move_bodies(const BodyMotions& motions, SimBuffers& buffers, gl::Downloads& downloads);
  /// The forces at the end of the stage are those of the GPU's own places.
  void forget_moved_rows();
  /// Iterations start where the tissue is: bodies were moved since begin_stage().
  void stay() { starts_.stay(); }
  /// After begin_stage(): whether tissue stops other tissue in the stage, or has to make room for it.
  bool meets() const { return starts_.meets() || pairs_.parts(); }
  bool cuts() const { return pairs_.cuts(); }  // what search_again() looked at last
  long taken_back() const { return pairs_.taken_back(); }
  bool searches() const { return !pairs_.empty(); }
  double search_ms() const { return pairs_.search_ms(); }  // for pairs, so far

  std::string name() const override { return "contact"; }
  bool acts() const override { return !surface_.empty() || !pairs_.empty(); }
  bool has_blocks() const override { return true; }
  std::optional<std::string> define(TermUse use) const override;
  void bind(TermUse use, gl::ComputePass::Bindings& bindings) const override;
  std::vector<VertexStiffness> stiffness() const override { return {}; }
  Passes project(gl::ProgramCache&, const SimBuffers&, bool) const override { return {}; }
  Passes impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes begin(gl::ProgramCache& programs, const SimBuffers& buffers) const override;
  Passes advance(const Recording& recording, const gl::Buffer& step) const override;
  Passes evaluate(gl::ProgramCache& programs, const SimBuffers& buffers, const VertexBlocks* blocks) const override;
  bool evaluates_blocks() const override { return bool{sums_}; }
  Passes finish(gl::ProgramCache& programs, const SimBuffers& buffers, bool moves_bodies) const override;
  Passes curvature(gl::ProgramCache& programs, const SimBuffers& buffers, const TermCurvature& at) const override;
  Passes over_touched(gl::ProgramCache& programs, const char* kernel, gl::Defines defines,
                      gl::ComputePass::Bindings bindings) const override;
  std::uint32_t curvature_partials(const gl::ProgramCache& programs) const override;
  std::optional<PressingRows> pressing() const override;

  /// What stiffness_at_points() needs of the GPU, read before each call.
  void read_stiffness(gl::Downloads& downloads);
  /// The stiffness of the points that press or stick, as the last forces were computed, at places of the buffers'
  /// vertices.
  std::vector<PointStiffness> stiffness_at_points() const;

  /// The vertices of the points that were near a piece in the last stage, at places of the buffers' vertices. All other
  /// points were farther than margin() [m] from every piece. Waits for the GPU.
  std::vector<std::uint32_t> near_vertices() const;
  double margin() const { return margin_; }
  /// The farthest that a point of a piece moves, at most [m].
  double way_of(const ToolMotion& motion) const;

  /// [vertex of the model] forces on the tissue at the end of the last stage [N]; waits for the GPU.
  std::vector<Eigen::Vector3d> forces_at_vertices() const;
  /// So that a state that is set does not show the forces of another one.
  void forget_forces();
  /// Nothing touches any more: no forces, and none that a later step starts with.
  void let_go(SimBuffers& buffers);
  /// What shaders/sim/contact/pressure.glsl reads.
  void bind_pressure(gl::ComputePass::Bindings& bindings);

  const gl::Buffer& loads() const { return loads_; }  // filled by the passes of impulses()
  /// The pairs of the last stage, and where their forces are, behind those of the points: vec4 [pairs].
  const std::vector<PairRow>& pairs() const { return pairs_.rows(); }
  const gl::Buffer& forces() const { return forces_; }
  std::size_t forces_of_pairs() const { return sizeof(shared::vec4) * point_count(); }
  /// At the end of a stage with these pairs, from the content of loads() and the forces of the pairs.
  ContactLoads sum_of(const std::vector<shared::vec4>& loads, const std::vector<PairRow>& pairs,
                      const std::vector<shared::vec4>& forces) const;
  const StepLoads& earlier_loads() const { return earlier_loads_; }  // of the last step's stages but its last one
  void record_loads(gl::ProgramCache& programs);                     // before the first stage

 private:
  static constexpr std::uint32_t kLoadLanes = 64;  // partial sums of the force of a piece
  static constexpr std::uint32_t kStretch = 256;   // of points that one invocation lists
  static constexpr std::size_t kPieceRows = 14;    // shaders/sim/contact/piece.glsl
  static constexpr float kNoPlane = 3e38F;         // the same, and of no depth

  void make_grids();
  gl::Defines defines() const;  // of the shapes that there are, and whether there are pairs
  void upload_points(const Model& model);
  void place_pieces(const ToolMotion& motion);
  void upload_pairs();
  void upload_entries();
  void keep_loads();  // of the stage that has ended
  Passes find_near(gl::ProgramCache& programs, const SimBuffers& buffers) const;
  gl::ComputePass load_pass(gl::ProgramCache& programs) const;
  gl::ComputePass start_of_near(gl::ProgramCache& programs, const char* kernel, gl::ComputePass::Bindings more,
                                gl::ComputePass::Constants constants) const;
  gl::ComputePass over_near(gl::ProgramCache& programs, const char* kernel, gl::ComputePass::Bindings more,
                            const gl::Defines& defined = {}) const;
  void bind_entries(gl::ComputePass::Bindings& bindings) const;  // shaders/sim/contact/entry.glsl
  std::uint32_t loops_of_point() const;
  bool crowded() const;  // some tool has more points than the surface has vertices
  std::uint32_t point_count() const { return static_cast<std::uint32_t>(surface_.points.size()); }
  std::uint32_t stretches() const;  // of points, each of which one invocation lists; one at least
  // Where in list_ the vertices follow the points and pairs, and, on software renderers, those of few points
  std::uint32_t touched_list() const { return 4 + point_count() + pairs_.slot_count(); }
  std::uint32_t few_list() const { return touched_list() + 4 + buffers_.vertex_count; }

  const Model& model_;
  const SimBuffers& buffers_;
  std::vector<Tool> tools_;
  ContactSurface surface_;
  PairStage pairs_;
  ToolMotion motion_;                              // in the stage
  using Entry = std::array<std::uint32_t, 2>;      // shaders/sim/contact/entry.glsl
  std::vector<std::vector<Entry>> point_entries_;  // [vertex]
  Eigen::Vector3d origin_{0, 0, 0};                // of contact on the GPU [m]
  double half_thickness_ = 0, margin_ = 0;         // [m]; margin: added to the reach of every piece
  double let_in_ = 0;                              // [m] how deep inside tools bodies are taken
  BodyStarts starts_;
  std::uint32_t most_entries_ = 0;                    // of a vertex, two points each
  std::vector<std::array<std::uint32_t, 4>> places_;  // of the vertices of points and pairs
  gl::Buffer vertices_, weights_, rest_;              // of the points
  gl::Buffer begin_, end_, entries_;                  // the points of every vertex
  std::vector<std::size_t> first_nodes_;              // [tool] in grids_
  gl::Buffer grids_;                        // float, of the tools that are meshes (sim/tool/solid_mesh.h); else absent
  std::unique_ptr<DeferredTets> doubtful_;  // of contact_doubtful.comp, on software renderers where tools are meshes
  gl::Buffer pieces_, near_, counts_, list_, constants_;
  gl::Buffer rows_, normals_, moved_rows_, forces_, blocks_, loads_;
  gl::Buffer pressing_, along_;    // contact_force.comp, contact_curvature.comp
  gl::Buffer sums_;                // of contact_gather.comp; absent on GPUs
  gl::Buffer crowds_;              // float [pieces * vertex_count]; absent where no tool is crowded()
  gl::Buffer areas_;               // float [vertex_count] [m^2]; created for the first picture of pressures
  std::vector<double> stiffness_;  // [point] contact_stiffness() [N/m]
  double length_ = 0;              // of the stage [s]
  int substeps_ = 1;               // of the step
  double share_ = 0;               // of the stage in the loads of the step; 0 before its first one
  std::uint32_t share_bits_ = std::bit_cast<std::uint32_t>(1.f);  // of IntegratorStage::share, for contact_load.comp
  StepLoads earlier_loads_;
  std::optional<gl::ComputePass> load_pass_;
  bool has_moved_rows_ = false;            // of move_bodies() in moved_rows_
  std::vector<shared::vec4> uploaded_;     // of pieces_
  std::vector<std::uint32_t> read_list_;   // of list_, for stiffness_at_points()
  std::vector<shared::vec4> read_blocks_;  // of blocks_
};

}  // namespace fascia
