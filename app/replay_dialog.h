// Asks where the replay of this session is to go.
#pragma once
#include <string>

#include "app/view_state.h"

namespace fascia {

class ReplayDialog {
 public:
  void ask();  // suggests a dated name in the current folder
  /// Between ImGui::NewFrame and ImGui::Render; what was chosen is in `requests`.
  void draw(Requests& requests);

 private:
  std::string path_;
  bool start_ = false;
};

}  // namespace fascia
