// A scripted grab on the command line:
// "at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02".
#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

namespace fascia {

/// The same as an element of the scene's "grabs", which the strict reader then checks. Keys are those of the scene
/// file; numbers with commas are lists, the keys of a path are separated by /: "path=0,0,0,0/0.5,0,0.1,0", and a value
/// that starts like JSON is JSON: select={"group":"tip"}. Throws Error for a part that is not KEY=VALUE, a repeated
/// key, invalid JSON, an empty `body`, and a `duration` or `smooth` without a motion.
nlohmann::json grab_document(std::string_view text);

}  // namespace fascia
