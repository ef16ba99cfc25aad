// Strict reading of a JSON document: a Node is a value with its path and origin, so that every error names the file (or
// the --set) and the path, and states the value found and the one expected.
#pragma once
#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fascia {

/// The origin of the value at a path: the file, or the --set that set it.
struct DocumentOrigin {
  struct Override {
    std::string key;      // as on the command line
    std::string path;     // the same as errors print it
    std::string touched;  // path of the topmost value that this override created or replaced
  };
  std::string file;
  std::vector<Override> overrides;  // in the order of their application

  std::string where(const std::string& path) const;  // "scene.json: gravity", "--set gravity"
};

/// The option that the user typed for such a key: "--set gravity", "--grab".
std::string option_of(const std::string& key);

class Node {
 public:
  Node(const nlohmann::json& value, std::string path, const DocumentOrigin& origin)
      : value_(&value), path_(std::move(path)), origin_(&origin) {}

  std::string where(const std::string& key) const;  // in errors, for the value at `key`, which may be missing
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
  /// "is VALUE; expected ...".
  [[noreturn]] void refuse(const std::string& expected) const;

  // Objects. `known`: all keys that are permitted.
  void expect_object(const std::vector<std::string>& known) const;
  std::optional<Node> find(const std::string& key) const;
  Node at(const std::string& key, const std::string& expected) const;
  std::vector<std::pair<std::string, Node>> members(const std::string& expected) const;

  // Lists.
  std::vector<Node> elements(const std::string& expected) const;

  // Values. Ranges are closed.
  bool is_boolean() const { return value_->is_boolean(); }
  bool is_string() const { return value_->is_string(); }
  bool is_array() const { return value_->is_array(); }
  bool is_object() const { return value_->is_object(); }
  double number(double min, double max, const std::string& unit) const;
  int integer(int min, int max) const;
  std::string text(const std::string& expected) const;
  bool boolean() const;
  Eigen::Vector3d vector(double min, double max, const std::string& unit) const;

  // The same for an optional key: if it is missing, the field keeps its default.
  void read(const std::string& key, double& field, double min, double max, const std::string& unit) const;
  void read(const std::string& key, int& field, int min, int max) const;
  void read(const std::string& key, Eigen::Vector3d& field, double min, double max, const std::string& unit) const;

 private:
  const nlohmann::json* value_;
  std::string path_;
  const DocumentOrigin* origin_;
};

/// "0.001 to 1e+14 Pa".
std::string range_text(double min, double max, const std::string& unit);

}  // namespace fascia
