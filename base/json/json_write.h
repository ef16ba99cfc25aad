// Numbers and vectors as documents that are written have them.
#pragma once
#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace fascia {

/// Whole numbers without ".0".
nlohmann::ordered_json number_document(double value);
nlohmann::ordered_json vector_document(const Eigen::Vector3d& v);

}  // namespace fascia
