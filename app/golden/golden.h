// A picture and a state against those that were made before and looked at, their "goldens": a PNG, and a CSV of
// positions. What render
// --compare and check do, and what the tests of the shipped scenes are made of.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/golden/golden_files.h"
#include "render/target/image.h"
#include "sim/model/model.h"
#include "sim/output/run_provenance.h"
#include "sim/output/state_export.h"
#include "sim/reference/newton.h"

namespace fascia {

/// What is compared.
struct Outcome {
  Image picture;
  Provenance provenance;
  TetMesh mesh;        // as its file has it
  StateFields fields;  // of which displacements are compared and written
  double size = 1;     // of the scene [m]
};

struct Finding {
  bool passed = false;
  std::string text;  // one line: what was measured against which limit
};

struct Comparison {
  std::vector<Finding> findings;     // one per golden
  std::vector<std::string> reasons;  // of a failure: what differs in how golden and outcome were made
  std::optional<Image>
      picture;  // golden, outcome and difference side by side, where pictures of one size were compared
  std::optional<double> mean, share, deviation;  // as in GoldenLimits; absent: could not be compared
  bool passed() const;
};

/// One line for each golden that is named and not there. To be asked before the work that would be compared with it.
std::vector<std::string> missing_goldens(const GoldenFiles& goldens);

/// Throws nothing for a golden that is missing, unreadable or of another size or mesh: that is a finding.
Comparison compare(const Outcome& outcome, const GoldenFiles& goldens, const GoldenLimits& limits);

/// Makes the goldens what the outcome is, each through a temporary name, and says in a line each what changed. A golden
/// with the same pixels and provenance, or the same positions, is left alone. Throws Error.
std::vector<std::string> update_goldens(const Outcome& outcome, const GoldenFiles& goldens);

}  // namespace fascia
