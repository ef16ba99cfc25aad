// A scripted hand on the command line: "at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02".
#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

namespace fascia {

/// The same as an element of the scene's "grabs", for the strict reader to judge. Keys are those of the scene file but for select;
/// numbers with commas are lists, and the keys of a path are separated by /: "path=0,0,0,0/0.5,0,0.1,0". Throws Error for a part
/// that is no KEY=VALUE or a key given twice.
nlohmann::json grab_document(std::string_view text);

}  // namespace fascia
