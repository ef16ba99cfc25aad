// The arrays that every GPU method shares, in structure-of-arrays layout, float32. Displacements are stored instead of
// positions: near rest they keep seven digits where positions would lose them to the distance from the origin.
#pragma once
#include <cstdint>
#include <vector>

#include "gl/buffer.h"
#include "shaders/shared/types.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/ordering/mesh_order.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

struct SimBuffers {
  /// `model`: placed() so. States come and go as the model outside counts its vertices, all else goes by places.
  SimBuffers(const Model& model, MeshOrder placement);
  explicit SimBuffers(const Model& model) : SimBuffers(model, unmoved(model)) {}

  std::uint32_t vertex_count = 0;
  std::uint32_t tet_count = 0;                  // of solved_tets(), which are here
  std::uint32_t pair_count = 0;                 // the tets lie as pair_tets() orders them
  bool leaves_out = false;                      // tets whose vertices are all fixed
  std::uint32_t most_tets = 0, most_slots = 0;  // of a vertex
  double volume = 0;                            // of all tets at rest [m^3]
  double mean_mass = 0;                         // of the vertices [kg]
  double size = 0;                              // diagonal of the box around all tets at rest [m]

  // State, vec4 [vertex_count].
  gl::Buffer displacement;           // xyz u = x - X [m], w inverse mass as tets see it [1/kg]; phantoms may follow
  gl::Buffer displacement_low;       // xyz what float32 cannot hold of u, u = displacement + displacement_low; made for
                                     // static equilibria only
  gl::Buffer velocity;               // xyz v [m/s]
  gl::Buffer previous_displacement;  // u at the start of the substep
  gl::Buffer predicted;              // u~, where inertia and gravity alone would lead

  MeshOrder placement;
  gl::Buffer placed_vertex;  // uint [vertex_count] placement.vertex

  // Constants of the model.
  gl::Buffer rest_position;  // vec4 [vertex_count] X [m], w inverse mass [1/kg], 0 where held
  gl::Buffer mass;           // float [vertex_count] [kg]
  gl::Buffer tet_vertices;   // uvec4 [tet_count]
  gl::Buffer tet_shape;      // vec4 [3 * tet_count] rows of Dm^-1 [1/m], w of the first row: volume [m^3]; of a pair's
                             // first tet others: d1, d2
  gl::Buffer pair_fifth;     // uvec4 [pairs and single tets] what a second tet adds to the first one, d1 and d2 apart
                             // (shaders/common/tet_pair.glsl)
  gl::Buffer tet_begin;      // uint [vertex_count + 1] its differences are the numbers of tets around each vertex
  gl::Buffer tet_material;   // uint [tet_count]; not made for a single material
  gl::Buffer materials;      // vec4 [material_count]; not made for a single material

  // Scratch, vec4 [slots]: what each corner of a pair of tets, or of a single tet, adds to its vertex
  // (shaders/common/pair_slots.glsl).
  gl::Buffer correction;
  gl::Buffer pair_slots;  // uvec4 [pairs and single tets] slots of all corners but the pair's fifth, sorted by vertex
  gl::Buffer slot_begin;  // uint [vertex_count + 1] first slot of each vertex

  // The same on the CPU: what is read back from a device that fails must never be an index or a size.
  std::vector<Tet> tets;                   // [tet_count] tet_vertices
  std::vector<std::uint32_t> tet_offsets;  // [vertex_count + 1] tet_begin

  gl::Buffer
      diverged;  // uint [1] smallest index of a vertex that is lost (shaders/sim/step/velocity.comp), ~0 for none

  gl::Buffer step;  // uniform block Step (shared::StepValues)

  /// The tets in another order: all of solved_tets(). Needs passes and lists that count on the old one made anew.
  /// Throws Error and changes nothing where there is no room.
  void set_tet_order(const Model& model, const TetPairing& order);
  std::uint32_t pair_and_single_count() const { return tet_count - pair_count; }
  /// Room for `count` copies of vertices behind the displacements, which stay.
  void set_phantom_count(std::uint32_t count);

  void upload_state(const Model& model, const State& state);
  State download_state(double time) const;
  /// The xyz of a buffer, vec4 [vertex_count or more], as the model counts its vertices. Waits for the GPU.
  std::vector<Eigen::Vector3d> download_vectors(const gl::Buffer& buffer) const;
  /// Masses follow density; call after any material change.
  void upload_materials(const Model& model);
  void upload_step(const Model& model, const SolverSettings& settings);
  bool material_per_tet() const { return static_cast<bool>(tet_material); }
};

}  // namespace fascia
