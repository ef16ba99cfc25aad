// What made a file, in the file: one line of JSON where its format has room for a remark. A CSV has none (its first
// line is the names of its columns, and scripts count on that), so there it stands beside it, in NAME.csv.json.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fascia {

using Provenance = std::vector<std::pair<std::string, std::string>>;  // keyword, text

/// Of a file that shows many moments.
Provenance without_moment(Provenance provenance);

/// {"Software":"fascia 0.2.0",...}, on one line and without "--", which XML comments must not have.
std::string provenance_json(const Provenance& provenance);
/// The text of an export whose ending is .vtu, .msh or .obj, with the line in it; of others as it is. None without
/// provenance.
std::string with_provenance(std::string text, const std::string& ending, const Provenance& provenance);
/// The same again, from such a text. Empty if there is none.
Provenance find_provenance(std::string_view text);

/// NAME.csv.json of NAME.csv.
std::filesystem::path provenance_beside(const std::filesystem::path& csv);

}  // namespace fascia
