// The files of a fit: report.html, fit.json, values.csv, and the fitted scene.
#pragma once
#include <filesystem>
#include <string>

#include "sim/fit/fit.h"

namespace fascia {

struct FitSubject {
  const Experiment& experiment;
  bool noise_known;
  std::string command_line;
};

/// Makes the folder if it is missing, before long work. Throws Error where the report could not be written.
void make_fit_folder(const std::filesystem::path& folder);
/// Without gnuplot the report has no charts. Throws Error.
void write_fit(const std::filesystem::path& folder, const FitResult& result, const FitSubject& subject);

}  // namespace fascia
