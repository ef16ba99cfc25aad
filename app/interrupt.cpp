#include "app/interrupt.h"

#include <csignal>

namespace fascia {
namespace {

volatile std::sig_atomic_t flag = 0;

}  // namespace

void catch_interrupts() {
  const auto remember = [](int) { flag = 1; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() { return flag != 0; }

}  // namespace fascia
