// St. Venant-Kirchhoff's law with signed stretches, and the compression below which it departs from the plain law.
#pragma once
#include <Eigen/Core>

#include "sim/material/law.h"

namespace fascia {

// Limit of signed_st_venant_kirchhoff: below it the strain of a principal direction falls linearly
inline constexpr double kLeastStretch = 0.6;

/// Psi of signed_st_venant_kirchhoff; equal to st_venant_kirchhoff's where no stretch is below kLeastStretch.
Density signed_st_venant_kirchhoff_density(const Eigen::Matrix3d& f, const Material& material, bool with_second);

}  // namespace fascia
