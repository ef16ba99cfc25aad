// How stiff a contact point is where many press together. Each is as stiff as the tissue below it, since a small tool
// presses with few points. A flat one presses with all, sixty-four for a vertex at the finest level, which share that
// stiffness: each with all of it, they would be as hard as sixty-four times the penalty.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/contact/contact_surface.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

/// [row] the penalty on depth in a stage [N/m], 0 where the point has no row in it (has_row()): that of the point,
/// `stiffness` [point], over the number of points that share it, at least 1. They are counted by the forces N that they
/// bear. Around a vertex they are (sum w N)^2 / sum w N^2, w being their weights there: as many as of equal forces
/// would have this sum and these squares. A point has the mean over its corners. Where none around a vertex bears one
/// yet, N is what they would bear with all of the stiffness where velocities and gravity lead, in the piece grown by
/// ContactSurface::first_reach. `memory`: at the start, none if shorter than the rows. `start`, `ahead`: displacements
/// [vertex] at the start, and where these lead.
std::vector<double> row_stiffness(const Model& model, const ContactSurface& surface,
                                  const std::vector<double>& stiffness, const ContactMemory& memory,
                                  const ToolMotion& motion, const std::vector<Eigen::Vector3d>& start,
                                  const std::vector<Eigen::Vector3d>& ahead);

}  // namespace fascia
