// How far a fit has come, as a file: a fit that is interrupted goes on there when the same command is started again.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "sim/fit/fit.h"

namespace fascia {

/// Fingerprints of what a fit is of. Two fits with equal ones take the same path.
struct FitIdentity {
  std::string scene, measurement, options;
};
/// `scene` with the data of its files (sim/scene/scene_carry.h).
FitIdentity identity_of(const Scene& scene, const std::vector<Measurement>& measurements, const std::string& options);

class FitProgressFile {
 public:
  /// `folder`/progress.json.
  FitProgressFile(const std::filesystem::path& folder, FitIdentity identity);

  /// None: no fit was interrupted here. Throws Error if it was another one, or if the file is no record of a fit of so
  /// many parameters.
  std::optional<FitProgress> read(std::size_t parameters) const;
  void write(const FitProgress& progress) const;  // a part is never seen. Throws Error
  void remove() const;                            // after the end of the fit
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  FitIdentity identity_;
};

}  // namespace fascia
