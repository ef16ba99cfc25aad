// The names of a scene's bodies and tools, under which histories and statistics have their forces: each belongs to one.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "base/json/json_node.h"
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

class SceneNames {
 public:
  /// The name that the file gives to what `owner` describes ("bodies[0]"). Throws Error at `node` if it is empty or
  /// another's. Names that differ only in what columns of a history cannot have are the same.
  void claim(const Node& node, const std::string& name, const std::string& owner);
  /// A free name for what the file does not name: `wanted`, or "wanted 2" and so on.
  std::string give(const std::string& wanted, const std::string& owner);

 private:
  std::map<std::string, std::string> owners_;  // by their names in columns
};

/// A name as a part of a column of a history: without what ends a cell.
std::string column_name(const std::string& name);

/// Throws Error at `contact` if columns of a history belong to two: the force of a tool "a_b", and that of a body "b"
/// on "a" where bodies touch. `bodies`: their names.
void require_own_columns(const Node& contact, const std::vector<std::string>& bodies, const SceneTools& tools);

}  // namespace fascia
