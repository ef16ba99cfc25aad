#include "app/golden/golden.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/golden/difference_picture.h"
#include "app/golden/provenance_difference.h"
#include "app/golden/sensitivity.h"
#include "app/golden/tolerance.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/model/vertex_csv.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

struct Deviation {
  double largest = 0;  // [m]
  std::size_t vertex = 0;
};

std::string size_text(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

void require_golden(const fs::path& path) {
  std::error_code ec;
  if (!fs::exists(path, ec))
    throw Error(path.string(), "no golden yet", "expected one: --update makes it, to be looked at before it is kept");
}

ImageDifference picture_difference(const Image& picture, const Image& golden, const fs::path& path) {
  if (picture.width != golden.width || picture.height != golden.height)
    throw Error(path.string(), "is a picture of " + size_text(golden),
                "expected the new picture's " + size_text(picture));
  return difference(golden, picture, kPixelBound);
}

std::vector<Eigen::Vector3d> read_state(const fs::path& path, std::size_t vertices) {
  constexpr std::size_t kAnyVertex = std::numeric_limits<std::uint32_t>::max();  // their number is compared separately
  VertexTable table = read_vertex_csv(path, kAnyVertex);
  if (table.vertices.size() != vertices || table.vertices.back() != vertices - 1)
    throw Error(
        path.string(),
        "has " + std::to_string(table.vertices.size()) + " vertices up to " + std::to_string(table.vertices.back()),
        "expected 0 to " + std::to_string(vertices - 1) + " of the scene's mesh");
  return std::move(table.values);
}

Deviation deviation(const Outcome& outcome, const std::vector<Eigen::Vector3d>& golden) {
  Deviation result;
  for (std::size_t v = 0; v < golden.size(); ++v) {
    const double distance = (outcome.mesh.positions[v] + outcome.fields.displacement[v] - golden[v]).norm();
    if (result.largest < distance || std::isnan(distance)) result = {distance, v};  // once NaN, always NaN
  }
  return result;
}

std::string against(double value, double limit) {
  return three_digits(value) + " (at most " + three_digits(limit) + ")";
}

Finding compare_picture(const Outcome& outcome, const fs::path& path, const GoldenLimits& limits,
                        Comparison& comparison) {
  require_golden(path);
  const Image golden = read_png(path);
  const ImageDifference d = picture_difference(outcome.picture, golden, path);
  comparison.mean = d.mean;
  comparison.share = d.share;
  comparison.picture = difference_picture(golden, outcome.picture, kPixelBound);
  const bool passed = d.mean <= limits.mean && d.share <= limits.share;
  return {passed, path.string() + ": " + (passed ? "same picture" : "the picture differs") + ", mean difference " +
                      against(d.mean, limits.mean) + ", share of pixels off by more than 8/255 " +
                      against(d.share, limits.share)};
}

Finding compare_state(const Outcome& outcome, const fs::path& path, const GoldenLimits& limits,
                      Comparison& comparison) {
  require_golden(path);
  const Deviation d = deviation(outcome, read_state(path, outcome.mesh.positions.size()));
  comparison.deviation = d.largest / outcome.size;
  const bool passed = *comparison.deviation <= limits.state;
  return {passed, path.string() + ": " + (passed ? "same state" : "the state differs") + ", largest deviation " +
                      against(*comparison.deviation, limits.state) + " of the scene's size, " +
                      three_digits(d.largest) + " m at vertex " + std::to_string(d.vertex)};
}

Finding compare_contact(const Outcome& outcome, const fs::path& path, const GoldenLimits& limits,
                        Comparison& comparison) {
  const ContactForces golden = read_contact_golden(path);
  comparison.contact = contact_deviation(outcome.contact, golden);
  const std::string tools = differing_tools(outcome.contact, golden);
  if (!tools.empty()) return {false, path.string() + ": the tools differ: " + tools};
  const bool passed = *comparison.contact <= limits.contact;
  return {passed, path.string() + ": " + (passed ? "same forces" : "the forces differ") + ", largest difference " +
                      against(*comparison.contact, limits.contact) + " of the largest force"};
}

template <class F>
Finding finding_of(const F& compare_one) {
  try {
    return compare_one();
  } catch (const Error& error) {
    return {false, error.what()};
  }
}

// Replaces the golden and describes the change; empty without a readable golden.
std::string update_picture(const Outcome& outcome, const fs::path& path) {
  std::string change = "new";
  if (std::error_code ec; fs::exists(path, ec)) {
    try {
      const ImageDifference d = picture_difference(outcome.picture, read_png(path), path);
      if (d.mean == 0 && provenance_differences(read_png_metadata(path), outcome.provenance).empty())
        return path.string() + ": unchanged";
      change = d.mean == 0 ? "same pixels, new provenance"
                           : "changed, mean difference " + three_digits(d.mean) + ", share " + three_digits(d.share);
    } catch (const Error&) {
      change = "replaced a picture of another size or kind";
    }
  }
  write_png(path, outcome.picture, outcome.provenance);
  return path.string() + ": " + change;
}

std::string update_state(const Outcome& outcome, const fs::path& path) {
  std::string change = "new";
  if (std::error_code ec; fs::exists(path, ec)) {
    try {
      const Deviation d = deviation(outcome, read_state(path, outcome.mesh.positions.size()));
      if (d.largest == 0) return path.string() + ": unchanged";
      change = "changed, largest deviation " + three_digits(d.largest / outcome.size) + " of the scene's size, " +
               three_digits(d.largest) + " m at vertex " + std::to_string(d.vertex);
    } catch (const Error&) {
      change = "replaced a state of another mesh or kind";
    }
  }
  write_state(path, outcome.mesh, outcome.fields);
  return path.string() + ": " + change;
}

std::string update_contact(const Outcome& outcome, const fs::path& path) {
  std::string change = "new";
  if (std::error_code ec; fs::exists(path, ec)) {
    try {
      const double d = contact_deviation(outcome.contact, read_contact_golden(path));
      if (d == 0) return path.string() + ": unchanged";
      change = "changed, largest difference " + three_digits(d) + " of the largest force";
    } catch (const Error&) {
      change = "replaced a file of another kind";
    }
  }
  write_contact_golden(path, outcome.contact);
  return path.string() + ": " + change;
}

}  // namespace

bool Comparison::passed() const {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& finding) { return finding.passed; });
}

std::vector<std::string> missing_goldens(const GoldenFiles& goldens) {
  std::vector<std::string> lines;
  for (const fs::path& golden : {goldens.picture, goldens.state}) {
    if (golden.empty()) continue;
    try {
      require_golden(golden);
    } catch (const Error& error) {
      lines.push_back(error.what());
    }
  }
  return lines;
}

Comparison compare(const Outcome& outcome, const GoldenFiles& goldens, const GoldenLimits& given) {
  Comparison comparison;
  GoldenLimits limits = given;
  try {
    limits = widened(given, read_sensitivity(goldens));
  } catch (const Error& error) {
    comparison.findings.push_back({false, error.what()});
  }
  comparison.limits = limits;
  if (!goldens.picture.empty())
    comparison.findings.push_back(
        finding_of([&] { return compare_picture(outcome, goldens.picture, limits, comparison); }));
  if (!goldens.state.empty())
    comparison.findings.push_back(
        finding_of([&] { return compare_state(outcome, goldens.state, limits, comparison); }));
  if (std::error_code ec; !goldens.state.empty() && fs::exists(contact_beside(goldens.state), ec))
    comparison.findings.push_back(
        finding_of([&] { return compare_contact(outcome, contact_beside(goldens.state), limits, comparison); }));
  if (comparison.passed() || goldens.picture.empty()) return comparison;
  try {
    comparison.reasons = provenance_differences(read_png_metadata(goldens.picture), outcome.provenance);
    if (comparison.reasons.empty())
      comparison.reasons.push_back("made by the same version, renderer, parameters, mesh and time as the golden");
  } catch (const Error&) {  // already reported as a finding
  }
  return comparison;
}

std::vector<std::string> update_goldens(const Outcome& outcome, const GoldenFiles& goldens) {
  std::vector<std::string> changes;
  if (!goldens.picture.empty()) changes.push_back(update_picture(outcome, goldens.picture));
  if (!goldens.state.empty()) changes.push_back(update_state(outcome, goldens.state));
  if (!goldens.state.empty() && !outcome.contact.empty())
    changes.push_back(update_contact(outcome, contact_beside(goldens.state)));
  return changes;
}

}  // namespace fascia
