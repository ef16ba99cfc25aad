#include "app/state/plots.h"

namespace fascia {

void Plots::forget() {
  history.clear();
  measured.clear();
  end.reset();
  probe.reset();
  choosing = false;
}

}  // namespace fascia
