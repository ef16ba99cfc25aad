// gnuplot as a child process: it draws the charts, so that fascia needs no plotting code of its own.
#pragma once
#include <filesystem>
#include <string>

namespace fascia {

inline constexpr const char* kGnuplotPackage = "expected the Debian package gnuplot-nox";

bool gnuplot_installed();  // found in PATH

/// Puts what `script` draws on gnuplot's standard output under `path`, through a temporary name. Throws Error when
/// gnuplot is not installed or fails; an old file stays then.
void run_gnuplot(const std::filesystem::path& path, const std::string& script);

}  // namespace fascia
