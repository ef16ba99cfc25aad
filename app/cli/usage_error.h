// Options that do not go with each other, or mean nothing: exit code 2.
#pragma once
#include "base/error.h"

namespace fascia {

class UsageError : public Error {
 public:
  using Error::Error;
};

/// What `open` returns; an Error that begins with an option's name ("--set ...") is a UsageError: the option's fault,
/// not the file's.
template <class Open>
auto blaming_options(Open&& open) {
  try {
    return open();
  } catch (const Error& error) {
    if (std::string(error.what()).starts_with("--")) throw UsageError(error.what());
    throw;
  }
}

}  // namespace fascia
