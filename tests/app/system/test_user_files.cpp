// The folders of a user's files, according to the XDG Base Directory Specification.
#include "app/system/user_files.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>

using namespace fascia;

namespace {

/// An environment variable that is restored at the end.
class Variable {
 public:
  explicit Variable(const char* name) : name_(name) {
    if (const char* value = std::getenv(name)) before_ = value;
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  void set(const char* value) const { value ? setenv(name_, value, 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("the user's folders follow the environment, and only absolute paths in it") {
  const Variable config("XDG_CONFIG_HOME"), state("XDG_STATE_HOME"), home("HOME");
  home.set("/home/user");
  config.set("/somewhere");
  state.set("/elsewhere");
  CHECK(config_folder() == "/somewhere/fascia");
  CHECK(state_folder() == "/elsewhere/fascia");
  config.set("relative");
  state.set(nullptr);
  CHECK(config_folder() == "/home/user/.config/fascia");
  CHECK(state_folder() == "/home/user/.local/state/fascia");
  home.set("relative");
  CHECK(config_folder().empty());
  home.set(nullptr);
  CHECK(config_folder().empty());
  CHECK(state_folder().empty());
}
