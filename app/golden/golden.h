// Compares a picture and a state with earlier ones that were approved, their "goldens": a PNG, and a CSV of positions.
// Used by render --compare, by check, and by the tests of the shipped scenes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/golden/contact_golden.h"
#include "app/golden/golden_files.h"
#include "render/target/image.h"
#include "sim/model/model.h"
#include "sim/output/run_provenance.h"
#include "sim/output/state_export.h"
#include "sim/reference/newton.h"

namespace fascia {

/// The data to compare.
struct Outcome {
  Image picture;
  Provenance provenance;
  TetMesh mesh;                // as in its file
  StateFields fields;          // the displacements are compared and written
  double size = 1;             // of the scene [m]
  ContactForces contact = {};  // of a scene with tools
};

struct Finding {
  bool passed = false;
  std::string text;  // one line: the measured value and its limit
};

struct Comparison {
  std::vector<Finding> findings;     // one per golden
  std::vector<std::string> reasons;  // of a failure: differences in the provenance of golden and outcome
  std::optional<Image> picture;  // golden, outcome and difference side by side, if pictures of one size were compared
  std::optional<double> mean, share, deviation, contact;  // as in GoldenLimits; absent: not comparable
  GoldenLimits limits;                                    // of the findings
  bool passed() const;
};

/// One line for each named golden that does not exist. Called before the work whose result is compared.
std::vector<std::string> missing_goldens(const GoldenFiles& goldens);

/// The limits are widened by the sensitivity of the goldens (sensitivity.h). Forces are compared where the scene has
/// tools and the state's golden has forces beside it. A golden that is missing, unreadable or of another size or mesh
/// is a finding, not an exception.
Comparison compare(const Outcome& outcome, const GoldenFiles& goldens, const GoldenLimits& limits);

/// Replaces the goldens by the outcome, each through a temporary name, and describes each change in a line. A golden
/// with the same pixels and provenance, or the same positions, is not written. Throws Error.
std::vector<std::string> update_goldens(const Outcome& outcome, const GoldenFiles& goldens);

}  // namespace fascia
