#include "app/state/undo_history.h"

namespace fascia {

void UndoHistory::restart(const Tunables& now) {
  entries_.clear();
  done_ = 0;
  complete_ = true;
  last_ = now;
}

void UndoHistory::follow(const Tunables& now) {
  if (now == last_) return;
  const std::vector<std::string> lines = changes(last_, now);
  std::string text = lines.front();
  if (lines.size() > 1) text += " and " + std::to_string(lines.size() - 1) + " more";
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(done_), entries_.end());
  entries_.push_back({std::move(text), last_, now});
  if (entries_.size() > kMostEntries) {
    entries_.pop_front();
    complete_ = false;
  }
  done_ = entries_.size();
  last_ = now;
}

}  // namespace fascia
