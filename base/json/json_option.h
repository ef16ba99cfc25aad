// Options whose text is a small document: "at=0.1,0.05,0;translate=0,0.1,0;start=0.2".
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fascia {

std::vector<std::string> parts_of(std::string_view text, char separator);

/// The parts KEY=VALUE between semicolons, in their order. Throws Error, which names the option, for a part of another
/// form, with `example` as what is expected, and for a repeated key.
std::vector<std::pair<std::string, std::string>> option_parts(std::string_view text, const std::string& option,
                                                              const std::string& example);

/// Numbers as people write them, also those that JSON does not know: .5, +5 and 5.
std::optional<double> number_in(std::string_view text);
/// A number, true, false, or the text itself.
nlohmann::json scalar_of(const std::string& text);
/// The scalars between commas.
nlohmann::json list_of(const std::string& text);
/// The same; without a comma one scalar, and a value that starts like JSON is JSON. Throws Error.
nlohmann::json value_of(const std::string& text, const std::string& option);

}  // namespace fascia
