// Short hints for new users: each is shown until its action was done once, in this window or in an earlier one.
#pragma once
#include <string>
#include <vector>

#include "app/system/user_settings.h"

namespace fascia {

class Hints {
 public:
  explicit Hints(UserStore& user) : user_(user) {}
  bool wanted(const std::string& id) const { return !user_.now().hints_done.count(id); }  // grab, orbit, tune, help
  void done(const std::string& id) {
    if (wanted(id)) user_.change([&](UserSettings& settings) { settings.hints_done.insert(id); });
  }

 private:
  UserStore& user_;
};

struct HintLine {
  const char* text;
  bool dim;
};
/// The hints that are wanted, from the bottom up. `in_hand`: a drag moves an instrument.
std::vector<HintLine> hint_lines(const Hints& hints, bool in_hand);

}  // namespace fascia
