// Undo and redo of everything that a user turns. The window shows it the tunables once nobody holds one: what differs
// from the last time is one entry, whatever made it, so a drag of a slider, a key and a combo are each undone in one
// piece. Knows values only.
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
  /// What differs from the last call becomes an entry, and what was undone is gone.
  void follow(const Tunables& now);
  /// As follow(), but what differs is nobody's change: a replay's.
  void accept(const Tunables& now) { last_ = now; }

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < entries_.size(); }
  const Entry& undone_next() const { return entries_[done_ - 1]; }
  const Entry& redone_next() const { return entries_[done_]; }
  /// The tunables to set for it. Call accept() with what they then are.
  Tunables undo() { return entries_[--done_].before; }
  Tunables redo() { return entries_[done_++].after; }

  const std::deque<Entry>& entries() const { return entries_; }
  std::size_t done() const { return done_; }   // entries that are not undone
  bool complete() const { return complete_; }  // false: there were more than kMostEntries, the first ones are gone

 private:
  Tunables last_;
  std::deque<Entry> entries_;  // the oldest first
  std::size_t done_ = 0;
  bool complete_ = true;
};

}  // namespace fascia
