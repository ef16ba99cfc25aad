// Finds the tool under the mouse.
#pragma once
#include <optional>
#include <vector>

#include "base/ray.h"
#include "sim/tool/tool.h"

namespace fascia {

struct ToolHit {
  std::size_t tool;
  double distance;  // [m] along the ray
};

/// The first of the tools from `first` on that the ray hits; `places`: [tool].
std::optional<ToolHit> pick_tool(const Ray& ray, const std::vector<Tool>& tools, const std::vector<ToolPlace>& places,
                                 std::size_t first = 0);

}  // namespace fascia
