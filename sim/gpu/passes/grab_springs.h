// Springs that pull patches of vertices to targets, which is how grabs act on the tissue. Kernels see one spring per
// vertex, the sum of all grabs there, so that no two invocations write to one vertex. Buffers exist only while a grab
// is active.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/gpu/passes/energy_term.h"
#include "sim/model/grab_spring.h"

namespace fascia {

class GrabSprings : public EnergyTerm {
 public:
  /// Replaces all springs; a vertex may have several. Returns true when the vertices changed and passes must be
  /// recorded again.
  bool set(const std::vector<GrabSpring>& springs);
  /// Whether the method applies the springs at the vertices (sim/energy/grab.glsl) or as constraints of their own
  /// (grab.comp), and whether any kernel reads them at the vertices.
  void set_use(bool at_vertices, bool spread, std::uint32_t vertex_count);

  std::string name() const override { return "grab"; }
  bool acts() const override { return !vertices_.empty(); }
  void bind(TermUse, gl::ComputePass::Bindings& bindings) const override {
    bindings.emplace_back("vertex_spring", &vertex_spring_);
  }
  std::vector<VertexStiffness> stiffness() const override;
  std::vector<gl::ComputePass> project(gl::ProgramCache& programs, const SimBuffers& buffers,
                                       bool first) const override;
  /// Updates multiplier() first if the springs are at vertices.
  std::vector<gl::ComputePass> impulses(gl::ProgramCache& programs, const SimBuffers& buffers) const override;

  void forget();  // clears the multipliers of the last substep, as the first iteration of the next one would
  const gl::Buffer& multiplier() const { return multiplier_; }  // vec4 [count] h^2 times the force on the tissue [kg m]
  std::uint32_t count() const { return static_cast<std::uint32_t>(vertices_.size()); }
  struct Owners {                             // the springs of each grab
    std::vector<GrabSpring> springs, joined;  // as given; as kernels see them, [count]
    std::vector<std::uint32_t> place;         // [springs.size()] index into joined
  };
  const Owners& owners() const { return owners_; }

 private:
  void spread();
  Owners owners_;
  std::vector<std::uint32_t> vertices_;
  std::vector<shared::vec4> springs_;  // target displacement [m] and stiffness [N/m]
  bool at_vertices_ = false, spread_ = false;
  std::uint32_t vertex_count_ = 0;
  gl::Buffer vertex_, target_, multiplier_;
  gl::Buffer vertex_spring_;  // vec4 [vertex_count], zero where no spring pulls; only where a kernel reads it
};

}  // namespace fascia
