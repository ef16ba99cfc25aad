// Options that do not go with each other, or mean nothing: exit code 2.
#pragma once
#include "sim/error.h"

namespace fascia {

class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace fascia
