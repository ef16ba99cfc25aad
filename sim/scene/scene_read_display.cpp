// Reads the key "display" of a scene file.
#include "base/json/json_document.h"
#include "base/suggest.h"
#include "sim/scene/scene_read.h"

namespace fascia {
namespace {

constexpr double kSmallestFont = 6, kLargestFont = 60;  // [points]

// The values of one setting, by its type.
void read(const Node& node, bool& on) { on = node.boolean(); }

void read(const Node& node, double& share) { share = node.number(0, 1, ""); }

template <class Choice>
void read_choice(const Node& node, const std::vector<Choice>& choices, Choice& chosen) {
  std::vector<std::string> names;
  for (const Choice choice : choices) names.push_back(name_of(choice));
  const std::string expected = "one of " + join(names), name = node.text(expected);
  for (const Choice choice : choices) {
    if (name != name_of(choice)) continue;
    chosen = choice;
    return;
  }
  node.fail("is " + excerpt(name) + perhaps(name, names), expected);
}

void read(const Node& node, ColorBy& color) { read_choice(node, all_colors(), color); }
void read(const Node& node, ColorMap& map) { read_choice(node, all_color_maps(), map); }
void read(const Node& node, Background& background) { read_choice(node, all_backgrounds(), background); }

void read(const Node& node, LegendSide& side) { read_choice(node, all_legend_sides(), side); }

void read(const Node& node, MarkSettings& marks) {
  std::vector<std::string> names;
  visit_marks(marks, [&](bool&, const char* name, auto&&...) { names.emplace_back(name); });
  const std::string expected = "true, false, or a list of " + join(names);
  if (node.is_boolean()) {
    const bool on = node.boolean();
    visit_marks(marks, [&](bool& kind, auto&&...) { kind = on; });
    return;
  }
  marks = {false, false, false};
  for (const Node& element : node.elements(expected)) {
    const std::string given = element.text("one of " + join(names));
    bool known = false;
    visit_marks(marks, [&](bool& kind, const char* name, auto&&...) {
      if (given != name) return;
      if (kind) element.fail("is " + excerpt(given) + " again", "each name once");
      kind = known = true;
    });
    if (!known) element.fail("is " + excerpt(given) + perhaps(given, names), "one of " + join(names));
  }
}

void read(const Node& node, LegendSettings& legend) {
  node.expect_object({"side", "font_size", "plate"});
  if (const auto side = node.find("side")) read(*side, legend.side);
  node.read("font_size", legend.font_size, kSmallestFont, kLargestFont, "points");
  if (const auto plate = node.find("plate")) legend.plate = plate->boolean();
}

void read(const Node& node, std::optional<Eigen::Vector2d>& range) {
  const std::string expected = "a list of 2 numbers, the lower one first";
  const std::vector<Node> ends = node.elements(expected);
  if (ends.size() != 2) node.refuse(expected);
  constexpr double kLargest = 1e30;
  range.emplace(ends[0].number(-kLargest, kLargest, ""), ends[1].number(-kLargest, kLargest, ""));
  if (!((*range)[0] < (*range)[1])) node.refuse(expected);
}

void read(const Node& node, std::optional<SectionPlane>& given) {
  SectionPlane& section = given.emplace();
  node.expect_object({"normal", "offset"});
  node.read("normal", section.normal, -kFarthestLook, kFarthestLook, "");
  node.read("offset", section.offset, -kFarthestLook, kFarthestLook, "m");
  if (section.normal.norm() < 1e-9) node.fail("normal has no length", "a vector across the plane");
}

void read(const Node& node, std::optional<SeparateTets>& given) {
  SeparateTets& tets = given.emplace();
  node.expect_object({"shrink", "spread"});
  node.read("shrink", tets.shrink, 0.01, 1, "");
  node.read("spread", tets.spread, 0, 10, "");
}

}  // namespace

DisplaySettings read_display(const Node& node) {
  DisplaySettings display;
  std::vector<std::string> keys;
  visit_display(display, [&](auto&, const char* key, auto&&...) { keys.emplace_back(key); });
  node.expect_object(keys);
  visit_display(display, [&](auto& field, const char* key, auto&&...) {
    if (const auto value = node.find(key)) read(*value, field);
  });
  return display;
}

}  // namespace fascia
