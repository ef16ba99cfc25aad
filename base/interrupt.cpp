#include "base/interrupt.h"

#include <unistd.h>

#include <csignal>

namespace fascia {
namespace {

volatile std::sig_atomic_t flag = 0, ends_at_once = 0;
std::stop_source source;  // requests are atomic operations as long as there are no callbacks

}  // namespace

void catch_interrupts() {
  const auto remember = [](int signal) {
    std::signal(signal, SIG_DFL);
    if (ends_at_once > 0) _exit(exit_interrupted);
    flag = 1;
    source.request_stop();
  };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return flag != 0; }

std::stop_token interrupt_token() { return source.get_token(); }

EndAtOnce::EndAtOnce() { ends_at_once = ends_at_once + 1; }
EndAtOnce::~EndAtOnce() { ends_at_once = ends_at_once - 1; }

}  // namespace fascia
