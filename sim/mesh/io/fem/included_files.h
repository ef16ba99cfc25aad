// The files that a finite element file includes: by their names, in its folder.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "sim/mesh/io/formats.h"

namespace fascia {

class IncludedFiles {
 public:
  /// `root`: the file that is read, for errors. `read_beside` must outlive this.
  IncludedFiles(std::string root, const ReadBeside& read_beside) : root_(std::move(root)), read_beside_(read_beside) {}

  /// A scanner, which lives as long as this, at the beginning of the file. Throws Error, which `in` locates, if this is
  /// no name of a file or the 33rd one: files may include one another.
  Scanner& open(const Scanner& in, const std::string& name);

 private:
  struct File {
    std::string content;
    Scanner in;
    File(const std::string& where, std::string text) : content(std::move(text)), in(where, content) {}
  };

  std::string root_;
  const ReadBeside& read_beside_;
  std::vector<std::unique_ptr<File>> files_;  // errors name places in them
};

}  // namespace fascia
