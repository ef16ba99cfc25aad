#include "app/window/parts/compile_notice.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "render/target/framebuffer.h"

namespace fascia {
namespace {

constexpr double kUnnoticed = 0.3;  // [s]: shorter waits show nothing

}  // namespace

CompileNotice::CompileNotice(Graphics& graphics, Overlay& overlay, const Framebuffer& picture, int left)
    : graphics_(graphics), overlay_(overlay), picture_(picture), left_(left), first_runs_(*graphics.programs, [this] {
        tell();
      }) {}

void CompileNotice::tell() {
  ++kernels_;
  if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() < kUnnoticed) return;
  glfwPollEvents();  // otherwise the desktop considers the program unresponsive; the events wait for the next frame
  overlay_.draw_list(picture_, 1, [&](ImDrawList& list) {
    ui::pill(list, "Compiling kernels for this graphics driver, the first time only",
             static_cast<float>(left_ + picture_.width()) / 2, ui::px(52),
             ui::kText);  // below the notices at the top
  });
  picture_.present(picture_.width(), picture_.height());
  glfwSwapBuffers(graphics_.context->window());
}

}  // namespace fascia
