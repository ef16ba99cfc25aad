// The key "display" of a scene file.
#include "base/json/json_document.h"
#include "base/suggest.h"
#include "sim/scene/scene_read.h"

namespace fascia {
namespace {

template <class Choice>
void read_choice(const Node& node, const char* key, const std::vector<Choice>& choices, Choice& chosen) {
  const auto value = node.find(key);
  if (!value) return;
  std::vector<std::string> names;
  for (const Choice choice : choices) names.push_back(name_of(choice));
  const std::string expected = "one of " + join(names), name = value->text(expected);
  for (const Choice choice : choices) {
    if (name != name_of(choice)) continue;
    chosen = choice;
    return;
  }
  value->fail("is " + excerpt(name) + perhaps(name, names), expected);
}

void read_switch(const Node& node, const char* key, bool& on) {
  if (const auto value = node.find(key)) on = value->boolean();
}

Eigen::Vector2d read_range(const Node& node) {
  const std::string expected = "a list of 2 numbers, the lower one first";
  const std::vector<Node> ends = node.elements(expected);
  if (ends.size() != 2) node.refuse(expected);
  constexpr double kLargest = 1e30;
  const Eigen::Vector2d range(ends[0].number(-kLargest, kLargest, ""), ends[1].number(-kLargest, kLargest, ""));
  if (!(range[0] < range[1])) node.refuse(expected);
  return range;
}

SectionPlane read_section(const Node& node) {
  SectionPlane section;
  node.expect_object({"normal", "offset"});
  node.read("normal", section.normal, -kFarthestLook, kFarthestLook, "");
  node.read("offset", section.offset, -kFarthestLook, kFarthestLook, "m");
  if (section.normal.norm() < 1e-9) node.fail("normal has no length", "a vector across the plane");
  return section;
}

SeparateTets read_tets(const Node& node) {
  SeparateTets tets;
  node.expect_object({"shrink", "spread"});
  node.read("shrink", tets.shrink, 0.01, 1, "");
  node.read("spread", tets.spread, 0, 10, "");
  return tets;
}

}  // namespace

DisplaySettings read_display(const Node& node) {
  DisplaySettings display;
  node.expect_object({"color", "range", "color_map", "wireframe", "section", "tets", "shadow", "ground",
                      "ambient_occlusion", "depth_cue", "background"});
  read_choice(node, "color", all_colors(), display.color);
  if (const auto range = node.find("range")) display.range = read_range(*range);
  read_choice(node, "color_map", all_color_maps(), display.color_map);
  read_switch(node, "wireframe", display.wireframe);
  if (const auto section = node.find("section")) display.section = read_section(*section);
  if (const auto tets = node.find("tets")) display.tets = read_tets(*tets);
  read_switch(node, "shadow", display.shadow);
  read_switch(node, "ground", display.ground);
  node.read("ambient_occlusion", display.ambient_occlusion, 0, 1, "");
  node.read("depth_cue", display.depth_cue, 0, 1, "");
  read_choice(node, "background", all_backgrounds(), display.background);
  return display;
}

}  // namespace fascia
