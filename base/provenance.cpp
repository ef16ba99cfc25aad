#include "base/provenance.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fascia {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kMark = "fascia: {";
constexpr std::size_t kSearched = 1 << 16;  // bytes at the beginning of a file

// The position after the first line if that is `line`, else the beginning.
std::size_t behind(const std::string& text, std::string_view line) {
  const std::size_t at = text.find(line);
  const std::size_t end = at == std::string::npos ? at : text.find('\n', at);
  return end == std::string::npos ? 0 : end + 1;
}

// Abaqus reads at most 256 characters a line.
constexpr std::string_view kGoesOn = "**+";
std::string abaqus_comment(const std::string& line) {
  constexpr std::size_t kMost = 200;
  std::string text;
  for (std::size_t at = 0; at < line.size(); at += kMost)
    text.append(at == 0 ? "** " : kGoesOn).append(line, at, kMost).append("\n");
  return text;
}

}  // namespace

Provenance without_moment(Provenance provenance) {
  std::erase_if(provenance, [](const auto& entry) { return entry.first == "Moment"; });
  return provenance;
}

std::string provenance_json(const Provenance& provenance) {
  Json object = Json::object();
  for (const auto& [keyword, text] : provenance) object[keyword] = text;
  std::string json = object.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = json.find("--", at)) != std::string::npos;) json.replace(at, 2, "-\\u002d");
  return json;
}

std::string with_provenance(std::string text, const std::string& ending, const Provenance& provenance) {
  if (provenance.empty()) return text;
  const std::string line = "fascia: " + provenance_json(provenance);
  if (ending == ".vtu") text.insert(behind(text, "<?xml"), "<!-- " + line + " -->\n");
  if (ending == ".msh") text.insert(behind(text, "$EndMeshFormat"), "$Comments\n" + line + "\n$EndComments\n");
  if (ending == ".inp") text.insert(0, abaqus_comment(line));
  if (ending == ".obj") text.insert(0, "# " + line + "\n");
  return text;
}

Provenance find_provenance(std::string_view text) {
  const std::size_t at = text.substr(0, kSearched).find(kMark);
  if (at == std::string_view::npos) return {};
  std::string line;
  for (std::size_t begin = at + kMark.size() - 1; begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    line += text.substr(begin, end - begin);
    begin = end < text.size() && text.substr(end + 1).starts_with(kGoesOn) ? end + 1 + kGoesOn.size() : text.npos;
  }
  line.resize(line.rfind('}') + 1);
  const Json object = Json::parse(line, nullptr, false);
  Provenance provenance;
  if (!object.is_object()) return {};
  for (const auto& [keyword, value] : object.items())
    if (value.is_string()) provenance.emplace_back(keyword, value.get<std::string>());
  return provenance;
}

std::filesystem::path provenance_beside(const std::filesystem::path& csv) { return csv.string() + ".json"; }

}  // namespace fascia
