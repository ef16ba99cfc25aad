// Runs gnuplot as a child process: it draws the charts, so that fascia needs no plotting code of its own.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

inline constexpr const char* kGnuplotPackage = "expected the Debian package gnuplot-nox";

bool gnuplot_installed();  // found in PATH

/// Writes gnuplot's output for `script` to `path`, through a temporary name. Throws Error if gnuplot is not installed
/// or fails; an old file is then kept. `title`: of an SVG file, which browsers show.
void run_gnuplot(const std::filesystem::path& path, const std::string& script, const std::string& title = "fascia");

}  // namespace fascia
