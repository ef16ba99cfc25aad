// A line of a CSV file as its cells.
#pragma once
#include <string_view>
#include <vector>

namespace fascia {

/// Without blanks and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// The cells between commas, trimmed; an empty line is one empty cell. They refer to `line`. Quotes have no meaning: no
/// name or number of these files has a comma.
std::vector<std::string_view> csv_cells(std::string_view line);

}  // namespace fascia
