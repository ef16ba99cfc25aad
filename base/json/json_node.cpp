#include "base/json/json_node.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include "base/error.h"
#include "base/json/json_document.h"
#include "base/suggest.h"

namespace fascia {
namespace {

bool is_within(const std::string& path, const std::string& ancestor) {
  if (path.compare(0, ancestor.size(), ancestor) != 0) return false;
  return path.size() == ancestor.size() || path[ancestor.size()] == '.' || path[ancestor.size()] == '[';
}

}  // namespace

std::string option_of(const std::string& key) { return (key.starts_with("--") ? "" : "--set ") + on_one_line(key); }

std::string DocumentOrigin::where(const std::string& path) const {
  for (auto it = overrides.rbegin(); it != overrides.rend(); ++it) {
    if (!is_within(path, it->touched)) continue;
    return option_of(it->key) + (path == it->path ? "" : ": " + path);
  }
  return path.empty() ? file : file + ": " + path;
}

std::string Node::where(const std::string& key) const { return origin_->where(path_of_key(path_, key)); }

void Node::fail(const std::string& what, const std::string& expected) const {
  throw Error(origin_->where(path_), what, "expected " + expected);
}

void Node::refuse(const std::string& expected) const { fail("is " + excerpt(*value_), expected); }

void Node::expect_object(const std::vector<std::string>& known) const {
  if (!value_->is_object()) refuse("an object with " + join(known));
  for (const auto& item : value_->items()) {
    if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
    const Node stranger(item.value(), path_of_key(path_, item.key()), *origin_);
    stranger.fail("unknown key " + excerpt(item.key()) + perhaps(item.key(), known), "one of " + join(known));
  }
}

std::optional<Node> Node::find(const std::string& key) const {
  const auto it = value_->find(key);
  if (it == value_->end()) return std::nullopt;
  return Node(*it, path_of_key(path_, key), *origin_);
}

Node Node::at(const std::string& key, const std::string& expected) const {
  if (auto node = find(key)) return *node;
  throw Error(where(key), "is missing", "expected " + expected);
}

std::vector<std::pair<std::string, Node>> Node::members(const std::string& expected) const {
  if (!value_->is_object()) refuse(expected);
  std::vector<std::pair<std::string, Node>> nodes;
  for (const auto& item : value_->items()) {
    nodes.emplace_back(item.key(), Node(item.value(), path_of_key(path_, item.key()), *origin_));
  }
  return nodes;
}

std::vector<Node> Node::elements(const std::string& expected) const {
  if (!value_->is_array()) refuse(expected);
  std::vector<Node> nodes;
  nodes.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) {
    nodes.emplace_back((*value_)[i], path_of_element(path_, i), *origin_);
  }
  return nodes;
}

double Node::number(double min, double max, const std::string& unit) const {
  if (!value_->is_number()) refuse("a number, " + range_text(min, max, unit));
  const double value = value_->get<double>();
  if (!(value >= min && value <= max)) refuse(range_text(min, max, unit));
  return value;
}

int Node::integer(int min, int max) const {
  const std::string expected = "a whole number, " + range_text(min, max, "");
  if (!value_->is_number()) refuse(expected);
  const double value = value_->get<double>();
  if (!(value >= min && value <= max) || value != static_cast<int>(value)) refuse(expected);
  return static_cast<int>(value);
}

std::string Node::text(const std::string& expected) const {
  if (!value_->is_string()) refuse(expected);
  return value_->get<std::string>();
}

bool Node::boolean() const {
  const std::string near = value_->is_string() ? nearest(value_->get<std::string>(), {"true", "false"}) : "";
  if (!near.empty()) fail("is " + excerpt(*value_) + ", perhaps " + near, "true or false");
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

Eigen::Vector3d Node::vector(double min, double max, const std::string& unit) const {
  const std::string expected = "a list of 3 numbers" + (unit.empty() ? "" : " [" + unit + "]");
  const std::vector<Node> nodes = elements(expected);
  if (nodes.size() != 3) refuse(expected);
  return {nodes[0].number(min, max, unit), nodes[1].number(min, max, unit), nodes[2].number(min, max, unit)};
}

void Node::read(const std::string& key, double& field, double min, double max, const std::string& unit) const {
  if (const auto node = find(key)) field = node->number(min, max, unit);
}

void Node::read(const std::string& key, int& field, int min, int max) const {
  if (const auto node = find(key)) field = node->integer(min, max);
}

void Node::read(const std::string& key, Eigen::Vector3d& field, double min, double max, const std::string& unit) const {
  if (const auto node = find(key)) field = node->vector(min, max, unit);
}

std::string range_text(double min, double max, const std::string& unit) {
  char text[64];
  std::snprintf(text, sizeof text, min < max ? "%g to %g" : "%g", min, max);
  return text + (unit.empty() ? "" : " " + unit);
}

}  // namespace fascia
