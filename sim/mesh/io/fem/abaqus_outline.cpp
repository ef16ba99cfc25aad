#include "sim/mesh/io/fem/abaqus_outline.h"

#include <set>

#include "sim/mesh/io/fem/abaqus_lines.h"
#include "sim/mesh/io/fem/included_files.h"

namespace fascia {
namespace {

constexpr std::size_t kMostInstances = 1000;  // the file is read once for each

class OutlineReader {
 public:
  OutlineReader(const std::string& where, const ReadBeside& read_beside) : included_(where, read_beside) {}

  void read(Scanner& in) {
    while (in.remaining() > 0) {
      if (!at_abaqus_keyword(in)) {
        in.line();
        continue;
      }
      const Keyword keyword = take_keyword(in);
      in.set_section("*" + keyword.name);
      if (keyword.name == "INCLUDE") read(included_.open(in, keyword.value("INPUT")));
      if (keyword.name == "PART") ++outline.parts;
      if (keyword.name == "INSTANCE") add_instance(in, {keyword.value("NAME"), keyword.value("PART")});
    }
  }

  AbaqusOutline outline;

 private:
  void add_instance(const Scanner& in, const AbaqusInstance& instance) {
    if (!names_.insert(upper_case(instance.name)).second)
      in.fail("is the second instance of the name " + in_quotes(instance.name), "expected every name once");
    if (outline.instances.size() == kMostInstances)
      in.fail("is one instance too many", "expected at most " + std::to_string(kMostInstances));
    outline.instances.push_back(instance);
  }

  IncludedFiles included_;
  std::set<std::string> names_;
};

}  // namespace

AbaqusOutline abaqus_outline(Scanner in, const ReadBeside& read_beside) {
  OutlineReader reader(in.where(), read_beside);
  reader.read(in);
  return reader.outline;
}

}  // namespace fascia
