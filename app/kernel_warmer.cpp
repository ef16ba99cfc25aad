#include "app/kernel_warmer.h"

#include <algorithm>
#include <utility>

namespace fascia {

KernelWarmer::KernelWarmer(const Graphics& graphics, std::function<void()> news)
    : shaders_(graphics.data_dir / "shaders"),
      loads_(graphics.programs->load_path()),
      fusing_(graphics.programs->fusing()),
      news_(std::move(news)) {
  try {
    context_ = graphics.context->beside();
    if (context_) thread_ = std::thread([this] { work(); });
  } catch (const std::exception&) {  // a window without it is as good, once it is warm
    context_.reset();
  }
}

KernelWarmer::~KernelWarmer() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

Rehearsed KernelWarmer::compiled(const SolverSettings& settings, const Model& model) {
  if (!context_ || model.tets.size() > kMostTets) return Rehearsed::all;
  const KernelUse use = kernel_use(settings, model);
  const std::lock_guard lock(mutex_);
  auto found = std::find_if(asked_.begin(), asked_.end(), [&](const Asked& asked) { return asked.use == use; });
  if (found == asked_.end()) {
    found = asked_.insert(asked_.end(), {use, rehearsal_body(model), Rehearsed::nothing, {}});
    changed_.notify_one();
  }
  found->at = Clock::now();
  return found->compiled;
}

KernelWarmer::Asked* KernelWarmer::next() {
  Asked* last = nullptr;
  for (Asked& asked : asked_)
    if (asked.compiled != Rehearsed::all && (!last || asked.at > last->at)) last = &asked;
  return last;
}

// What nobody has asked for in a while gives way to what somebody waits for.
bool KernelWarmer::go_on(Asked& asked, Rehearsed compiled) {
  constexpr auto kWhile = std::chrono::milliseconds(200);
  const std::lock_guard lock(mutex_);
  const bool more = compiled > asked.compiled;
  if (more) asked.compiled = compiled;
  if (more && news_) news_();
  const Asked* other = next();
  return !ends_ && !(other && other != &asked && other->at > asked.at + kWhile);
}

void KernelWarmer::work() {
  context_->make_current();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ends_ || next(); });
    if (ends_) break;
    Asked& asked = *next();
    lock.unlock();
    bool failed = false;
    try {
      gl::ProgramCache programs(shaders_, loads_);
      programs.set_fusing(fusing_);
      rehearse(programs, asked.use, asked.body, [&](Rehearsed done) { return go_on(asked, done); });
    } catch (const std::exception&) {  // where it is needed it will fail again, and be told
      failed = true;
    }
    if (failed) go_on(asked, Rehearsed::all);
    lock.lock();
    if (asked.compiled == Rehearsed::all) asked.body = {};
  }
  lock.unlock();
  context_->leave();
}

}  // namespace fascia
