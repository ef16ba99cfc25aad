// An instrument on the command line: "name=probe;shape=sphere;radius=0.01;from=0,0.1,0;to=0,0.02,0;duration=1".
#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

namespace fascia {

/// The same as an element of the scene's "instruments", which the strict reader then checks. `shape` is the name of a
/// shape, whose values stand beside it, or JSON; `length` of a capsule or cylinder is along y, from the origin up. The
/// origin stays at `from`, or moves from there to `to` within `duration` after `start` [s], with the angles
/// `rotate_deg`; or it moves along the JSON of a path. Throws Error, which names the key, for a part that is not
/// KEY=VALUE, a repeated or unknown key, invalid JSON, a value of another shape, one that is missing, and for a motion
/// without its end or its duration.
nlohmann::json instrument_document(std::string_view text);

}  // namespace fascia
