// Vertex block descent (Chen, Liu, Yang, Yuksel 2024): Gauss-Seidel over vertices. Each vertex solves the 3x3 Newton
// system of the step's objective in its own coordinates. One pass per vertex color.
#pragma once
#include "sim/gpu/methods/method.h"
#include "sim/ordering/graph_coloring.h"

namespace fascia {

class VertexDescentMethod : public StepMethod {
 public:
  VertexDescentMethod(const Model& model, const SimBuffers& buffers);
  bool starts_without_gravity() const override { return true; }
  Deferral most_deferred(const SimBuffers&, bool) const override {
    return {static_cast<std::uint32_t>(coloring_.color_count()), static_cast<std::uint32_t>(coloring_.order.size())};
  }
  bool descends() const override { return true; }
  Passes iteration(const Recording& recording, bool first) const override;

 private:
  VertexColoring coloring_;
  gl::Buffer vertex_tets_, color_vertex_;
};

}  // namespace fascia
