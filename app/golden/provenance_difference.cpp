#include "app/golden/provenance_difference.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/json/json_document.h"

namespace fascia {
namespace {

std::optional<std::string> text_at(const Provenance& provenance, const std::string& keyword) {
  for (const auto& [key, text] : provenance)
    if (key == keyword) return text;
  return std::nullopt;
}

std::string now_and_then(const std::string& what, const std::string& golden, const std::string& now) {
  return what + ": golden " + golden + ", now " + now;
}

// Converts "/solver/iterations" of a JSON pointer to a dotted path.
std::string dotted(std::string pointer) {
  if (!pointer.empty()) pointer.erase(0, 1);
  std::replace(pointer.begin(), pointer.end(), '/', '.');
  return pointer;
}

std::vector<std::string> parameter_differences(const std::string& golden, const std::string& now) {
  const auto parse = [](const std::string& text) { return nlohmann::json::parse(text, nullptr, false); };
  const nlohmann::json before = parse(golden), after = parse(now);
  if (before.is_discarded() || after.is_discarded()) return {now_and_then("parameters", "not readable", "others")};
  const nlohmann::json a = before.flatten(), b = after.flatten();
  std::vector<std::string> lines;
  const auto value = [](const nlohmann::json& flat, const std::string& key) {
    return flat.contains(key) ? excerpt(flat[key]) : "none";
  };
  for (const auto& [key, ignored] : a.items())
    if (!b.contains(key) || a[key] != b[key])
      lines.push_back(now_and_then(dotted(key), excerpt(a[key]), value(b, key)));
  for (const auto& [key, ignored] : b.items())
    if (!a.contains(key)) lines.push_back(now_and_then(dotted(key), "none", excerpt(b[key])));
  return lines;
}

}  // namespace

std::vector<std::string> provenance_differences(const Provenance& golden, const Provenance& now) {
  std::vector<std::string> lines;
  bool any = false;
  for (const auto& [keyword, text] : now) {
    const std::optional<std::string> before = text_at(golden, keyword);
    any = any || before;
    if (keyword == "Command line" || before == text) continue;
    if (keyword == "Parameters" && before) {
      for (std::string& line : parameter_differences(*before, text)) lines.push_back(std::move(line));
    } else {
      lines.push_back(now_and_then(keyword, before ? on_one_line(*before) : "none", on_one_line(text)));
    }
  }
  if (!any) return {"the golden carries no provenance: it was not made by fascia, or its texts were stripped"};
  return lines;
}

}  // namespace fascia
