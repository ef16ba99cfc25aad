// What the library throws. Running out of memory is std::bad_alloc, as everywhere.
#pragma once
#include <stdexcept>
#include <string>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// The text is one line for a person: "where: what; what was expected". `where` is a file with line or JSON path, or
  /// an argument. A call that throws has changed nothing, unless its description says otherwise.
  class FASCIA_EXPORT Error : public std::runtime_error {
   public:
    explicit Error(const std::string& message);
    Error(const std::string& where, const std::string& what, const std::string& expected);
    ~Error() override;
  };

  /// Work was ended by a stop token.
  class FASCIA_EXPORT Interrupted : public Error {
   public:
    explicit Interrupted(const std::string& message);
    ~Interrupted() override;
  };

  /// The graphics device was reset, and what it held is lost: every simulation of that context can only be destroyed.
  class FASCIA_EXPORT ContextLost : public Error {
   public:
    explicit ContextLost(const std::string& message);
    ~ContextLost() override;
  };

}  // namespace api
}  // namespace fascia
