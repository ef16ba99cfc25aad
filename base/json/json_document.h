// Parses JSON text to a document, with more checks than the parser it uses: a repeated key is refused, nesting is
// limited, and a syntax error is one line "file:line:column: ...".
#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace fascia {

/// Levels of lists and objects; more are refused, because the code that traverses a document is recursive.
inline constexpr std::size_t kDeepestNesting = 32;

/// `where` names the text in errors: a file, or "--set KEY".
nlohmann::json parse_json(std::string_view text, const std::string& where);

/// The text, or if it has line breaks or other control characters, the text as a JSON string.
std::string on_one_line(std::string_view text);

/// JSON paths as errors print them: "bodies[0].materials.default".
std::string path_of_key(const std::string& parent, std::string_view key);
std::string path_of_element(const std::string& parent, std::size_t index);

/// A value as errors print it, abbreviated if it is long.
std::string excerpt(const nlohmann::json& value);

}  // namespace fascia
