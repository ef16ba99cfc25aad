// Where a static solve stops on the way of its tools. Tissue in which a tool is at once leaves it by the side that is
// nearest, and that is the far one beyond the tool's middle. So what ends deep is led there in short parts, from where
// it last was clear of the tissue.
#pragma once
#include <functional>
#include <vector>

#include "sim/tool/tool_motion.h"

namespace fascia {

/// How deep a tool would be in the tissue as it is: 0 clear of it, from 1 on so deep that it may leave by a wrong side.
using ToolDepth = std::function<double(std::size_t tool, const ToolPlace& place)>;

/// [s] Ascending, the last one `end`. `finest`: [tool] the size of its finest part [m]. `motion`: of the tools between
/// two times.
std::vector<double> approach_times(const std::vector<Tool>& tools, const std::vector<double>& finest, double begin,
                                   double end, double tissue_size,
                                   const std::function<ToolMotion(double from, double to)>& motion,
                                   const ToolDepth& depth);

}  // namespace fascia
