// XPBD swept color by color (section 3.1 of the I3D 2019 paper): each tet sees the corrections of the colors before it.
// The method converges where averaged Jacobi stays too soft, and costs one dispatch per color. With a bound on the
// colors some vertices are split into phantoms, which share the vertex's mass and are averaged after each sweep (see
// sim/ordering/graph_coloring.h): one color is mass-split Jacobi, enough colors are plain Gauss-Seidel.
#pragma once
#include "sim/gpu/methods/method.h"
#include "sim/ordering/graph_coloring.h"

namespace fascia {

class GaussSeidelMethod : public StepMethod {
 public:
  /// `colors` 0: as many as the mesh needs. Puts the tets of `buffers` in the order of the colors, along a
  /// space-filling curve within each.
  GaussSeidelMethod(const Model& model, SimBuffers& buffers, int colors);

  /// One pass per color. The first iteration of a substep starts from zero multipliers.
  Passes iteration(const Recording& recording, bool first) const override;

  /// A color is too small to justify another dispatch.
  Deferral most_deferred(const SimBuffers& buffers, bool fused) const override;

  bool goes_on_with(const MethodInputs& inputs) override;
  const Coloring* coloring() const override { return &coloring_; }
  /// Number of vertices and phantoms before each vertex; null without phantoms.
  const gl::Buffer* copy_begin() const override { return phantom_count_ ? &copy_begin_ : nullptr; }

 private:
  int colors_asked_;
  Coloring coloring_;      // of solved_tets(), by their index there
  gl::Buffer multiplier_;  // vec4 [2 * tet_count] lambda
  gl::Buffer corners_;     // uvec4 [tet_count]: the copy that each corner moves; only with phantoms
  gl::Buffer phantom_vertex_, copy_begin_,
      split_vertex_;  // [phantom_count], [vertex_count + 1], vertices that have phantoms
  std::uint32_t phantom_count_ = 0, split_count_ = 0;
};

}  // namespace fascia
