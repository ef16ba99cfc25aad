// Reads the grabs of a scene file ("grabs").
#include "sim/scene/scene_read.h"

namespace fascia {
namespace {

constexpr double kStiffest = 1e15;  // [N/m]
constexpr double kSmallest = 1e-9;  // [m], [N/m]

std::vector<ScriptedGrab::Key> read_path(const Node& node) {
  const std::string expected = "a list of keys [t, dx, dy, dz]: seconds after start, ascending, and meters";
  std::vector<ScriptedGrab::Key> path;
  for (const Node& key : node.elements(expected)) {
    const std::vector<Node> values = key.elements(expected);
    if (values.size() != 4) key.refuse(expected);
    const auto coordinate = [&](std::size_t k) { return values[k].number(-kFarthestTissue, kFarthestTissue, "m"); };
    path.push_back({values[0].number(0, kLongestTime, "s"), {coordinate(1), coordinate(2), coordinate(3)}});
    if (path.size() > 1 && !(path[path.size() - 2].time < path.back().time))
      key.refuse("a later time than that of the key before");
  }
  if (path.empty()) node.refuse(expected);
  return path;
}

}  // namespace

ScriptedGrab read_grab(const Node& node) {
  node.expect_object({"at", "select", "body", "radius", "stiffness", "start", "duration", "release", "smooth",
                      "translate", "push", "path"});
  ScriptedGrab grab;
  const auto at = node.find("at"), select = node.find("select"), radius = node.find("radius"), push = node.find("push"),
             path = node.find("path"), release = node.find("release");
  if (at && select) node.fail("has at and select", "one of them");
  if (!at && !select) node.fail("holds nothing", "at, a place [x, y, z] on the tissue [m], or select");
  if (at) grab.where = at->vector(-kFarthestTissue, kFarthestTissue, "m");
  if (select) grab.where = read_selection(*select);
  if (select && radius) radius->fail("goes with at", "no radius beside select");
  if (const auto body = node.find("body")) grab.body = body->text("the name of a body");
  if (radius) grab.radius = radius->number(kSmallest, kFarthestTissue, "m");
  if (const auto stiffness = node.find("stiffness")) grab.stiffness = stiffness->number(kSmallest, kStiffest, "N/m");
  node.read("start", grab.start, 0, kLongestTime, "s");
  node.read("duration", grab.duration, 0, kLongestTime, "s");
  if (release) {
    grab.release = release->number(0, kLongestTime, "s");
    if (!(*grab.release > grab.start)) release->refuse("a time after start");
  }
  if (const auto smooth = node.find("smooth")) grab.smooth = smooth->boolean();
  node.read("translate", grab.translate, -kFarthestTissue, kFarthestTissue, "m");
  if (push) grab.push = push->number(-kFarthestTissue, kFarthestTissue, "m");
  if (path) grab.path = read_path(*path);
  if (push && select) push->fail("needs a place to push at", "at instead of select");
  const int ways = static_cast<int>(node.find("translate").has_value()) + push.has_value() + path.has_value();
  if (ways > 1) node.fail("has more than one of translate, push and path", "one of them");
  if (path && node.find("duration")) node.fail("has path and duration", "the times of the path alone");
  return grab;
}

}  // namespace fascia
