#include "app/state/tool_readings.h"

namespace fascia {

void ToolReadings::add(double time, const std::vector<ToolLoad>& loads) {
  if (!readings_.empty() && (time < readings_.back().time || loads.size() != readings_.back().loads.size())) forget();
  if (!readings_.empty() && time == readings_.back().time) readings_.pop_back();
  readings_.push_back({time, loads});
  if (readings_.size() > kMean) readings_.pop_front();
}

std::vector<ToolLoad> ToolReadings::mean() const {
  if (readings_.empty()) return {};
  std::vector<ToolLoad> mean = readings_.back().loads;
  for (std::size_t t = 0; t < mean.size(); ++t) {
    mean[t].force.setZero();
    mean[t].torque.setZero();
    mean[t].normal = 0;
    for (const Reading& reading : readings_) {
      mean[t].force += reading.loads[t].force / static_cast<double>(readings_.size());
      mean[t].torque += reading.loads[t].torque / static_cast<double>(readings_.size());
      mean[t].normal += reading.loads[t].normal / static_cast<double>(readings_.size());
    }
  }
  return mean;
}

}  // namespace fascia
