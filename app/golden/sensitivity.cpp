#include "app/golden/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/golden/tolerance.h"
#include "base/error.h"
#include "base/file.h"
#include "base/number_text.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

constexpr const char* kColumns = "mean,share,state,contact";

struct Field {
  double Sensitivity::*measured;
  double GoldenLimits::*limit;
};
constexpr Field kFields[] = {{&Sensitivity::mean, &GoldenLimits::mean},
                             {&Sensitivity::share, &GoldenLimits::share},
                             {&Sensitivity::state, &GoldenLimits::state},
                             {&Sensitivity::contact, &GoldenLimits::contact}};

bool widens(const Sensitivity& sensitivity) {
  return std::any_of(std::begin(kFields), std::end(kFields), [&](const Field& field) {
    return kSensitivityMargin * sensitivity.*field.measured > GoldenLimits{}.*field.limit;
  });
}

}  // namespace

Sensitivity sensitivity_of(const Outcome& outcome, const Outcome& nudged) {
  Sensitivity sensitivity;
  const ImageDifference d = difference(outcome.picture, nudged.picture, kPixelBound);
  sensitivity.mean = d.mean;
  sensitivity.share = d.share;
  for (std::size_t v = 0; v < outcome.fields.displacement.size(); ++v)
    sensitivity.state = std::max(
        sensitivity.state, (outcome.fields.displacement[v] - nudged.fields.displacement[v]).norm() / outcome.size);
  sensitivity.contact = std::min(1.0, contact_deviation(nudged.contact, outcome.contact));
  return sensitivity;
}

GoldenLimits widened(GoldenLimits limits, const Sensitivity& sensitivity) {
  for (const Field& field : kFields)
    if (limits.*field.limit == GoldenLimits{}.*field.limit)
      limits.*field.limit = std::max(limits.*field.limit, kSensitivityMargin * sensitivity.*field.measured);
  return limits;
}

fs::path sensitivity_beside(const GoldenFiles& goldens) {
  return fs::path(goldens.state.empty() ? goldens.picture : goldens.state).replace_extension(".sensitivity.csv");
}

Sensitivity read_sensitivity(const GoldenFiles& goldens) {
  const fs::path path = sensitivity_beside(goldens);
  Sensitivity sensitivity;
  if (std::error_code ec; !fs::exists(path, ec)) return sensitivity;
  std::istringstream in(read_file(path));
  std::string header;
  bool valid = std::getline(in, header) && header == kColumns;
  for (const Field& field : kFields) {
    double& value = sensitivity.*field.measured;
    valid = valid && in >> value && std::isfinite(value) && value >= 0;
    if (valid && in.peek() == ',') in.get();
  }
  if (!valid)
    throw Error(path.string(), "is no sensitivity of a golden",
                std::string("expected ") + kColumns + " and a row of numbers, as --update writes them");
  return sensitivity;
}

std::vector<std::string> update_sensitivity(const Sensitivity& sensitivity, const GoldenFiles& goldens) {
  const fs::path path = sensitivity_beside(goldens);
  if (!widens(sensitivity)) {
    std::error_code ec;
    return fs::remove(path, ec) ? std::vector{path.string() + ": removed, rounding changes little"}
                                : std::vector<std::string>();
  }
  const std::string text = NumberText()
                               .add(kColumns)
                               .add('\n')
                               .add(sensitivity.mean)
                               .add(',')
                               .add(sensitivity.share)
                               .add(',')
                               .add(sensitivity.state)
                               .add(',')
                               .add(sensitivity.contact)
                               .add('\n')
                               .take();
  if (std::error_code ec; fs::exists(path, ec) && read_file(path) == text) return {path.string() + ": unchanged"};
  write_file(path, text);
  const GoldenLimits limits = widened({}, sensitivity);
  return {path.string() + ": the motion amplifies rounding, to " + three_digits(sensitivity.state) +
          " of the scene's size and to a mean difference of " + three_digits(sensitivity.mean) + "; at most " +
          three_digits(limits.state) + " and " + three_digits(limits.mean) + " are permitted"};
}

}  // namespace fascia
