// The lines of Abaqus files: keywords, and the lines of values below them, which end at the next keyword.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sim/mesh/io/fem/fem_mesh.h"

namespace fascia {

std::string trimmed(std::string_view text);  // without quotes, too
std::string upper_case(std::string text);

/// A keyword line: its words in upper case, the values of parameters as they are.
struct Keyword {
  std::string name;
  std::map<std::string, std::string> parameters;
  bool has(const char* parameter) const { return parameters.contains(parameter); }
  std::string value(const char* parameter) const;  // empty if there is none
};

bool at_abaqus_keyword(const Scanner& in);
bool at_abaqus_comment(const Scanner& in);
/// Takes a keyword line and those in which it goes on. Errors name it.
Keyword take_keyword(Scanner& in);

/// The kind of element by its name: C3D10MH is a solid of ten nodes, CPS3 a triangle. Null for other families.
std::optional<FemElement> abaqus_element(const std::string& type);

}  // namespace fascia
