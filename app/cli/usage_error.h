// Errors of options that are invalid or contradict each other: exit code 2.
#pragma once
#include "base/error.h"

namespace fascia {

class UsageError : public Error {
 public:
  using Error::Error;
};

/// Returns the result of `open`. An Error that begins with an option's name ("--set ...") becomes a UsageError, since
/// the option is wrong and not the file.
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
