// The origin of a file, stored in the file: one line of JSON where the format permits a comment. A CSV does not (its
// first line has the column names, and scripts rely on that), so its provenance is in NAME.csv.json.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fascia {

using Provenance = std::vector<std::pair<std::string, std::string>>;  // keyword, text

/// For a file that contains several times.
Provenance without_moment(Provenance provenance);

/// {"Software":"fascia 0.2.0",...}, on one line and without "--", which XML comments must not contain.
std::string provenance_json(const Provenance& provenance);
/// The text of an export with the provenance line, if its extension is .vtu, .msh, .obj or .inp; others are unchanged,
/// also without provenance.
std::string with_provenance(std::string text, const std::string& ending, const Provenance& provenance);
/// Reads it back from such a text. Empty if there is none.
Provenance find_provenance(std::string_view text);

/// NAME.csv.json of NAME.csv.
std::filesystem::path provenance_beside(const std::filesystem::path& csv);

}  // namespace fascia
