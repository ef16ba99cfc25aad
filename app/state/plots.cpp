#include "app/state/plots.h"

namespace fascia {

void Plots::clear() {
  history.clear();
  measured.clear();
  measured_file.clear();
  fit = {};
}

void Plots::forget() {
  clear();
  end.reset();
  probe.reset();
  choosing = false;
}

}  // namespace fascia
