#include "app/window/parts/messages.h"

#include <limits>
#include <new>

#include "app/panels/panels.h"
#include "app/window/parts/opening_screen.h"

namespace fascia {

void Messages::say(const std::string& text, bool is_error) {
  message_ = Message{text, is_error, Clock::now() + std::chrono::seconds(is_error ? 3600 : 4)};
}

bool Messages::attempt(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Cancelled& cancelled) {
    say(cancelled.name + " was not opened");
  } catch (const std::bad_alloc&) {
    say("Out of memory", true);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
  return false;
}

double Messages::seconds_left() const {
  return message_ ? std::chrono::duration<double>(message_->until - Clock::now()).count()
                  : std::numeric_limits<double>::infinity();
}

void Messages::draw(bool without_news) {
  if (!message_ || (without_news && !message_->is_error)) return;
  if (draw_message(message_->text, message_->is_error) || Clock::now() > message_->until) clear();
}

}  // namespace fascia
