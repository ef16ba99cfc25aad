#include "sim/gpu/self_test/self_test.h"

#include <sstream>

#include "base/error.h"
#include "sim/gpu/self_test/kernel_rows.h"

namespace fascia {

std::string KernelCheck::text() const {
  if (!failure.empty()) return kernels + ": " + failure;
  std::ostringstream text;
  text.precision(3);
  text << kernels << (passed() ? ": off by " : " is off by ") << deviation << ", expected at most " << bound;
  return text.str();
}

std::vector<KernelCheck> self_test(gl::ProgramCache& programs, const std::function<void(const KernelCheck&)>& news) {
  std::vector<KernelRow> rows = single_kernels();
  for (KernelRow& row : whole_steps()) rows.push_back(std::move(row));
  std::vector<KernelCheck> checks;
  for (const KernelRow& row : rows) {
    KernelCheck& check = checks.emplace_back(KernelCheck{row.kernels, 0, row.bound, ""});
    try {
      check.deviation = row.deviation(programs);
    } catch (const gl::ContextLost&) {
      throw;
    } catch (const Error& error) {
      check.failure = error.what();
      const std::string device = gl::device().renderer + ": ";  // which the report names once
      if (check.failure.starts_with(device)) check.failure.erase(0, device.size());
    }
    if (news) news(check);
  }
  return checks;
}

}  // namespace fascia
