// The message over the picture: information for some seconds, an error until it is closed. Errors in a frame become
// messages.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace fascia {

class Messages {
 public:
  /// Replaces the previous message.
  void say(const std::string& text, bool is_error = false);
  /// Runs `work`. An exception or a cancelled opening becomes a message and returns false.
  bool attempt(const std::function<void()>& work);
  void clear() { message_.reset(); }

  bool any() const { return message_.has_value(); }
  bool is_error() const { return message_ && message_->is_error; }
  const std::string& text() const { return message_->text; }  // requires any()
  double seconds_left() const;                                // until the message disappears; infinite without one
  /// Between ImGui::NewFrame and ImGui::Render. With `without_news` only errors are shown.
  void draw(bool without_news);

 private:
  using Clock = std::chrono::steady_clock;
  struct Message {
    std::string text;
    bool is_error;
    Clock::time_point until;
  };
  std::optional<Message> message_;
};

}  // namespace fascia
