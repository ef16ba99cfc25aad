// The exceptions of the library. If memory runs out, calls throw std::bad_alloc.
#pragma once
#include <stdexcept>
#include <string>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// The base of all exceptions of the library. The text is one line for a reader: "where: what; what was expected".
  /// `where` is a file with a line or a JSON path, or an argument. A call that throws has changed nothing, unless its
  /// description states otherwise.
  class FASCIA_EXPORT Error : public std::runtime_error {
   public:
    /// Makes an error with `message` as its text.
    explicit Error(const std::string& message);
    /// Makes an error with the text "where: what; expected".
    Error(const std::string& where, const std::string& what, const std::string& expected);
    ~Error() override;
  };

  /// Thrown if a stop token ended the work.
  class FASCIA_EXPORT Interrupted : public Error {
   public:
    /// Makes an error with `message` as its text.
    explicit Interrupted(const std::string& message);
    ~Interrupted() override;
  };

  /// Thrown if the graphics device was reset. Its content is lost; every simulation of that context can only be
  /// destroyed.
  class FASCIA_EXPORT ContextLost : public Error {
   public:
    /// Makes an error with `message` as its text.
    explicit ContextLost(const std::string& message);
    ~ContextLost() override;
  };

}  // namespace api
}  // namespace fascia
