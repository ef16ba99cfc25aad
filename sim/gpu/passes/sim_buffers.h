// The arrays that every GPU method shares, in structure-of-arrays layout, float32. Displacements are stored instead of
// positions: near rest they keep seven digits, which positions would lose to the distance from the origin.
#pragma once
#include <cstdint>
#include <vector>

#include "gl/buffer.h"
#include "shaders/shared/relaxed_bulk.h"
#include "shaders/shared/types.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/ordering/mesh_order.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

/// From which share of the volume on the law squared continues its logarithm (sim/gpu/readback/tangle_watch.h).
enum class Hardness { own, eased, firm };

struct SimBuffers {
  /// `model`: in the order of placed(). States enter and leave in the order of the original model, everything else uses
  /// places.
  SimBuffers(const Model& model, MeshOrder placement);
  explicit SimBuffers(const Model& model) : SimBuffers(model, unmoved(model)) {}

  std::uint32_t vertex_count = 0;
  std::uint32_t tet_count = 0;                  // of solved_tets(), which these buffers hold
  std::uint32_t pair_count = 0;                 // the tets are stored in the order of TetPairing
  std::uint32_t quadratic_count = 0;            // of tet_count
  bool leaves_out = false;                      // whether tets with only fixed vertices are left out
  std::uint32_t most_tets = 0, most_slots = 0;  // per vertex
  double volume = 0;                            // of all tets at rest [m^3]
  double mean_mass = 0;                         // of the vertices [kg]
  double size = 0;                              // diagonal of the box around all tets at rest [m]

  // State, vec4 [vertex_count].
  gl::Buffer displacement;           // xyz u = x - X [m], w inverse mass as the tets use it [1/kg]; phantoms may follow
  gl::Buffer displacement_low;       // xyz: the part of u that float32 cannot represent, u = displacement +
                                     // displacement_low; exists for static equilibria only
  gl::Buffer velocity;               // xyz v [m/s]
  gl::Buffer previous_displacement;  // u* of the stage (sim/integrators/stage.h)
  // u and v at the start of the stage during it, of the stage or substep before at its start; keep_earlier()
  gl::Buffer earlier_displacement, earlier_velocity;
  gl::Buffer predicted;  // u~, the result of inertia and gravity alone

  MeshOrder placement;
  gl::Buffer placed_vertex;  // uint [vertex_count] placement.vertex

  // Constants of the model.
  gl::Buffer rest_position;  // vec4 [vertex_count] X [m], w inverse mass [1/kg], 0 where constrained
  gl::Buffer mass;           // float [vertex_count] consistent_masses() [kg]
  gl::Buffer tet_vertices;   // uvec4 [tet_count]
  gl::Buffer tet_shape;      // vec4 [3 * tet_count] rows of Dm^-1 [1/m], w of the first row: volume [m^3]; of a pair's
                             // first tet also d1, d2
  gl::Buffer tet_material;   // uint [tet_count]; absent for a single material
  gl::Buffer materials;      // vec4 [material_count]; absent for a single material

  // Scratch, vec4 [slots]: the contribution of each corner of a pair of tets, of a single or of a quadratic tet to its
  // vertex (shaders/common/pair_slots.glsl, quadratic_slots.glsl).
  gl::Buffer correction;
  gl::Buffer slot_begin;  // uint [vertex_count + 1] first slot of each vertex

  // Linear tets only; absent without them.
  gl::Buffer pair_fifth;  // uvec4 [pairs and single tets] data of a second tet relative to the first one, without d1
                          // and d2 (shaders/common/tet_pair.glsl)
  gl::Buffer pair_slots;  // uvec4 [pairs and single tets] slots of all corners but the pair's fifth, sorted by vertex
  gl::Buffer tet_begin;   // uint [vertex_count + 1] differences are the numbers of linear tets around each vertex

  // Quadratic tets only (shaders/common/quadratic_tet.glsl); absent without them.
  gl::Buffer mid_edges;        // uvec4 [2 * quadratic_count]
  gl::Buffer quadratic_slots;  // uvec4 [3 * quadratic_count] slots of all ten vertices
  gl::Buffer
      quadratic_begin;    // uint [vertex_count + 1] differences are the numbers of quadratic tets around each vertex
  gl::Buffer own_mass;    // float [vertex_count] [kg] MovingMasses::own; own_masses()
  gl::Buffer multiplier;  // float [quadratic_count] of relaxed K [Pa] (sim/quadratic/quadratic_multiplier.comp)
  gl::Buffer predicted_centroid;  // vec4 [quadratic_count] of what moves at centroids: u~ [m], w mass [kg]

  // The same on the CPU: data read back from a device that fails must never be an index or a size.
  std::vector<Tet> tets;                         // [tet_count] tet_vertices
  std::vector<MidEdges> mid_edge_vertices;       // [quadratic_count]
  std::vector<std::uint32_t> quadratic_tets;     // [quadratic_count] in Model::tets
  std::vector<std::uint32_t> tet_offsets;        // [vertex_count + 1] tet_begin
  std::vector<std::uint32_t> quadratic_offsets;  // [vertex_count + 1] quadratic_begin

  gl::Buffer contact_memory;  // vec4 [rows of the contact surface] State::contact: xyz friction, w normal [N]; absent
                              // without tools, as the next one
  gl::Buffer contact_before;  // the same at the start of the stage

  Hardness hardness = Hardness::own;  // of the law squared; upload_materials() and upload_step() pass it on

  gl::Buffer diverged;  // uint [1] smallest index of a diverged vertex (shaders/sim/step/velocity.comp), ~0 for none

  gl::Buffer step;  // uniform block Step (shared::StepValues)

  /// Stores the tets, all of solved_tets(), in another order. Passes and lists that use the old order must be recorded
  /// again. Throws Error and changes nothing if there is not enough memory.
  void set_tet_order(const Model& model, const TetPairing& order);
  std::uint32_t linear_count() const { return tet_count - quadratic_count; }
  bool has_linear() const { return quadratic_count == 0 || linear_count() > 0; }
  bool has_quadratic() const { return quadratic_count > 0; }
  std::uint32_t pair_and_single_count() const { return linear_count() - pair_count; }
  /// Of an element [tet_count] in the order of tets.
  ElementVertices element(std::size_t t) const {
    return t < linear_count() ? ElementVertices(tets[t])
                              : ElementVertices(tets[t], mid_edge_vertices[t - linear_count()]);
  }
  /// What moves with the vertices themselves: `mass` without quadratic tets.
  const gl::Buffer& own_masses() const { return own_mass ? own_mass : mass; }
  /// Of an iteration, in linear tets: a quadratic one has the vertices of eight.
  std::uint32_t work() const { return work_of(linear_count(), quadratic_count); }
  static std::uint32_t work_of(std::uint32_t linear, std::uint32_t quadratic) { return linear + 8 * quadratic; }
  /// Reserves `count` copies of vertices behind the displacements, which are preserved.
  void set_phantom_count(std::uint32_t count);

  /// The multipliers are unknown: K is not relaxed until they are updated.
  void forget_multipliers();
  /// Creates or frees earlier_displacement and earlier_velocity, for integrators that extrapolate.
  void keep_earlier(bool kept);
  /// u [m] at the start of the stage, during the stage.
  const gl::Buffer& start_of_stage() const {
    return earlier_displacement ? earlier_displacement : previous_displacement;
  }

  void upload_state(const Model& model, const State& state);
  /// `u`: [vertex of the model] [m]. `before`: what the buffer holds in a stage, whose inverse masses stay, for what
  /// the stage still computes; empty: between stages.
  void upload_displacements(const std::vector<Eigen::Vector3d>& u, const std::vector<shared::vec4>& before = {});
  void upload_velocities(const std::vector<Eigen::Vector3d>& velocity);
  /// `earlier_step`: State::Earlier::step; 0: the earlier state is left out.
  State download_state(double time, double earlier_step = 0) const;
  /// (u - u~) / l^2 + g of every vertex [m/s^2], at the end of a stage of length `l` [s]; constrained ones have no g.
  std::vector<Eigen::Vector3d> download_accelerations(const Eigen::Vector3d& gravity, double l) const;
  /// The xyz of a buffer, vec4 [vertex_count or more], in the model's vertex order. Waits for the GPU.
  std::vector<Eigen::Vector3d> download_vectors(const gl::Buffer& buffer) const;
  /// The xyz of its content.
  std::vector<Eigen::Vector3d> vectors_of(const std::vector<shared::vec4>& content) const;
  ContactMemory contact_forces(const gl::Buffer& buffer) const;  // of a copy of contact_memory
  static ContactMemory contact_forces(const std::vector<shared::vec4>& content);
  void upload_contact(const ContactMemory& memory);  // zeros where it has fewer rows
  /// Also updates the masses, which follow density; call after any material change.
  void upload_materials(const Model& model);
  void upload_step(const Model& model, const SolverSettings& settings, const IntegratorStage& stage);
  bool material_per_tet() const { return static_cast<bool>(tet_material); }

 private:
  void upload_moving_masses(const Model& model);
};

}  // namespace fascia
