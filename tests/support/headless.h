// Options of a test without a window.
#pragma once
#include "app/cli/options.h"

namespace fascia::test {

inline CommonOptions headless() {
  CommonOptions options;
  options.context = "osmesa";
  options.quiet = true;
  return options;
}

}  // namespace fascia::test
