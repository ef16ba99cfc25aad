// Abaqus files: keyword lines and the names of elements.
#include "sim/mesh/io/fem/abaqus_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

namespace fascia {

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == text.npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r\"") + 1 - begin));
}

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string Keyword::value(const char* parameter) const {
  const auto found = parameters.find(parameter);
  return found == parameters.end() ? "" : found->second;
}

bool at_abaqus_comment(const Scanner& in) { return in.data().substr(in.offset()).starts_with("**"); }

bool at_abaqus_keyword(const Scanner& in) {
  return in.data().substr(in.offset()).starts_with('*') && !at_abaqus_comment(in);
}

Keyword take_keyword(Scanner& in) {
  in.blame(in.offset());
  std::string text;
  for (bool goes_on = true; goes_on && in.remaining() > 0;) {
    const std::string_view line = in.line();
    text += line;
    goes_on = trimmed(line).ends_with(',') && !at_abaqus_keyword(in);
  }
  Keyword keyword;
  std::string_view rest(text);
  for (bool first = true; !rest.empty(); first = false) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    if (first) {
      keyword.name = upper_case(trimmed(part.substr(1)));
    } else {
      const std::size_t equals = std::min(part.find('='), part.size());
      keyword.parameters[upper_case(trimmed(part.substr(0, equals)))] =
          equals < part.size() ? trimmed(part.substr(equals + 1)) : "";
    }
  }
  return keyword;
}

std::optional<FemElement> abaqus_element(const std::string& type) {
  struct Family {
    const char* prefix;
    int dimension;
  };
  static constexpr std::array<Family, 15> families = {{{"DC3D", 3},
                                                       {"AC3D", 3},
                                                       {"C3D", 3},
                                                       {"SFM3D", 2},
                                                       {"M3D", 2},
                                                       {"R3D", 2},
                                                       {"STRI", 2},
                                                       {"CPS", 2},
                                                       {"CPE", 2},
                                                       {"CAX", 2},
                                                       {"DC2D", 2},
                                                       {"DS", 2},
                                                       {"S", 2},
                                                       {"T3D", 1},
                                                       {"B3", 1}}};
  const auto family = std::find_if(families.begin(), families.end(), [&](const Family& f) {
    const std::size_t length = std::string_view(f.prefix).size();
    return type.starts_with(f.prefix) && type.size() > length && std::isdigit(static_cast<unsigned char>(type[length]));
  });
  if (family == families.end()) return std::nullopt;
  std::size_t nodes = 0;
  std::from_chars(type.data() + std::string_view(family->prefix).size(), type.data() + type.size(), nodes);
  if (family->prefix == std::string_view("STRI") && nodes == 65) nodes = 6;
  static const std::map<std::pair<int, std::size_t>, std::size_t> corners = {
      {{3, 4}, 4},  {{3, 5}, 5},  {{3, 6}, 6}, {{3, 8}, 8}, {{3, 10}, 4}, {{3, 13}, 5}, {{3, 15}, 6},
      {{3, 20}, 8}, {{3, 27}, 8}, {{2, 3}, 3}, {{2, 4}, 4}, {{2, 6}, 3},  {{2, 8}, 4},  {{2, 9}, 4}};
  const auto found = corners.find({family->dimension, nodes});
  if (found == corners.end()) return FemElement{family->dimension, 0, 0};
  return FemElement{family->dimension, found->second, nodes};
}

}  // namespace fascia
