// The message over the picture: news for some seconds, an error until it is closed. What fails in a frame becomes one.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace fascia {

class Messages {
 public:
  /// Takes the place of the message before it.
  void say(const std::string& text, bool is_error = false);
  /// Runs `work`. An exception becomes a message, and so does an opening that was given up: false.
  bool attempt(const std::function<void()>& work);
  void clear() { message_.reset(); }

  bool any() const { return message_.has_value(); }
  bool is_error() const { return message_ && message_->is_error; }
  const std::string& text() const { return message_->text; }  // where there is any
  double seconds_left() const;                                // until it goes by itself; infinite where there is none
  /// Between ImGui::NewFrame and ImGui::Render. `without_news`: only an error is shown.
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
