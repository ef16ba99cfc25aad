// Remembers for which scenes the driver's cache on disk has the fused kernels (gl/fused_pass.h), so that a window can
// use them from its first step, and need not begin with single ones until another process has found them cached.
#pragma once
#include <filesystem>
#include <string>

#include "sim/scene/scene.h"

namespace fascia {

class KernelRecord {
 public:
  /// `file` keeps the record, one line per scene; empty: none is kept. `driver` names the driver and how kernels are
  /// made for it.
  KernelRecord(std::filesystem::path file, std::string driver);

  bool has(const Scene& scene) const;
  /// Whether both have the same kernels, as far as this can be known.
  bool same(const Scene& a, const Scene& b) const;
  /// A record that cannot be written is not kept.
  void add(const Scene& scene) const;

 private:
  std::string key_of(const Scene& scene) const;  // empty if the driver has no cache

  std::filesystem::path file_;
  std::string driver_;
};

}  // namespace fascia
