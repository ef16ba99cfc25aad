// Undo and redo of all parameter changes. The window passes the tunables whenever no widget is active: the difference
// from the last call is one entry, so a drag of a slider, a key and a combo are each undone at once. Works on values
// only.
#pragma once
#include <deque>
#include <string>

#include "app/state/tunables.h"

namespace fascia {

class UndoHistory {
 public:
  static constexpr std::size_t kMostEntries = 200;

  struct Entry {
    std::string text;  // "Young's modulus: 10 kPa to 12 kPa", "... and 2 more"
    Tunables before, after;
  };

  void restart(const Tunables& now);
  /// Makes an entry of the difference from the last call, and discards undone entries.
  void follow(const Tunables& now);
  /// As follow(), but without an entry, since the change is a replay's.
  void accept(const Tunables& now) { last_ = now; }

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < entries_.size(); }
  const Entry& undone_next() const { return entries_[done_ - 1]; }
  const Entry& redone_next() const { return entries_[done_]; }
  /// Returns the tunables to set. Call accept() with the resulting ones.
  Tunables undo() { return entries_[--done_].before; }
  Tunables redo() { return entries_[done_++].after; }

  const std::deque<Entry>& entries() const { return entries_; }
  std::size_t done() const { return done_; }   // entries in effect
  bool complete() const { return complete_; }  // false: the oldest entries were dropped

 private:
  Tunables last_;
  std::deque<Entry> entries_;  // the oldest first
  std::size_t done_ = 0;
  bool complete_ = true;
};

}  // namespace fascia
