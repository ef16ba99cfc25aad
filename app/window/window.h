// The window: one frame after the other of input, panels, steps, drawing. Whatever fails in a frame becomes a message,
// and the scene that is open stays open; only the loss of the device ends it, and leaves the scene as it was some
// seconds before. While nothing moves there are no frames: the window sleeps until something happens.
#pragma once
#include <array>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "app/compare/split_view.h"
#include "app/dialogs/file_dialogs.h"
#include "app/dialogs/gallery.h"
#include "app/overlay/overlay.h"
#include "app/panels/hints.h"
#include "app/session/open_input.h"
#include "app/session/replay_view.h"
#include "app/state/window_state.h"
#include "app/ui/window_input.h"
#include "app/video/capture.h"
#include "app/video/session_recording.h"
#include "app/window/autosave.h"
#include "app/window/hover.h"
#include "app/window/mouse_tool.h"
#include "app/window/opening_screen.h"
#include "app/window/real_time_clock.h"
#include "gl/timer.h"
#include "sim/output/stats.h"

namespace fascia {

class Window {
 public:
  /// Throws Error when the scene cannot be simulated.
  Window(Graphics& graphics, const ViewOptions& options, Opened opened);

  /// Until the window is closed, the asked number of steps is done or the program is interrupted. Throws
  /// gl::ContextLost, which names the file that keeps the scene.
  void run();
  /// The video that was being recorded when the window closed. Throws Error.
  void finish_video() {
    if (video_.running()) video_.finish();
  }

  const Simulation& simulation() const { return session_->simulation; }
  const RunStats& stats() const { return stats_; }  // of all steps made

 private:
  using Clock = std::chrono::steady_clock;
  struct Message {
    std::string text;
    bool is_error = false;
    Clock::time_point until;
  };

  void wait_for_events();
  void require_device() const;
  void settle();
  bool asleep() const;       // all tissue that is shown
  bool still() const;        // the tissue does not move
  double idle_time() const;  // [s] for which nothing changes unless somebody does something; 0 while things move
  void frame(double elapsed);
  bool update_framebuffer();  // false: nothing to draw on, the window is minimised
  void handle_input(Requests& requests);
  void press_key(int key, int mods, Requests& requests);
  void build_panels(Requests& requests);
  void simulate(double elapsed, const Requests& requests);
  void make_step();
  void read_diagnostics();
  void find_last_residual();                     // which nobody may have asked for
  void follow(const Diagnostics& diagnostics);   // into the plots
  bool choose_probe(const Eigen::Vector2d& at);  // false: nothing was to be chosen
  void write_plots(const Requests& requests);
  void go_back(std::uint32_t lost);  // the state came apart
  void remember();                   // for a device that is lost and for a window that ends badly
  void remember_now_and_then();
  Scene scene_now() const;  // with the materials and the camera of now
  std::vector<GrabMark> marks();
  std::vector<Box> covered(const Framebuffer& picture) const;  // what else is drawn over it
  void draw_ring(const MarkArea& area, const Session& session);
  void draw();
  void capture(const Requests& requests);

  void carry_out(const Requests& requests);
  void open(const std::filesystem::path& path);
  void resume(const std::filesystem::path& path);
  Opened read(const std::filesystem::path& path, OpeningScreen& screen);
  std::unique_ptr<Session> make_session(Opened& opened, OpeningScreen& screen,
                                        double share_done);  // with a bar while it takes long
  void take_over(std::unique_ptr<Session> opened);
  void export_state(const std::filesystem::path& path);
  void follow_hints();
  void session_began();  // what the window knows of the one that is open
  void save(const std::filesystem::path& path, bool with_mesh);
  void set_title();
  void reset();
  void begin_recording();   // of the session that was opened
  void follow_recording();  // once a frame
  void end_recording();
  void leave_recorded_session();
  void record_anew();  // after it: grabs that stay hold on
  void let_go();       // of all grabs, at both sides; those of a replay hold on
  void save_replay(const std::filesystem::path& path);
  void begin_replay();
  void follow_replay();  // its camera and display; its end
  void end_replay(const std::string& news);
  void toggle_video();
  void record_frame();
  void reload_shaders();
  Provenance provenance() const;

  // A comparison of two settings, while there is one.
  Session& tuned() { return split_ && state_.editing_b ? split_->b() : *session_; }  // what the panels show
  Session& held() { return split_ && grab_in_b_ ? split_->b() : *session_; }         // what the mouse acts on
  int panels_cover() const;                                                          // of the picture's width [pixels]
  Margins margins() const;                                                           // of the window's picture
  void compare(CompareAsk ask);
  void edit(bool b);
  MouseTool::Picture to_side(Eigen::Vector2d& at, bool press);  // of the comparison: which one, and where in it
  MouseTool::Picture picture_of_grab() const;                   // of the side that the mouse acts on
  bool points_at_b() const;
  Eigen::Vector2d pointer_in_side(bool b) const;
  void after_mouse();  // both sides see and feel the same
  void lead();         // both feel the same
  /// `scale`: SplitView::draw_labels; `left`: pixels of it that are the panels', beside which the tissue stands;
  /// `drawn`: SplitView::draw.
  void draw_scene(Framebuffer& picture, float scale, int left);
  void draw_comparison(Framebuffer& picture, float scale, int left,
                       const std::function<void(std::size_t, const Framebuffer&)>& drawn = {});

  void follow_tunables();                        // into the history
  void accept_tunables();                        // what a replay has changed is no entry
  void go_through_history(std::size_t entries);  // until so many are in force
  void set_material_entries(const std::vector<MaterialEntries>& entries);
  void materials_changed();  // their number
  void rescale(double factor);
  Scene scene_to_reproduce() const;
  void copy_command();

  /// Runs `work`; an exception becomes a message, and so does an opening that was given up.
  bool attempt(const std::function<void()>& work);
  void say(const std::string& text, bool is_error = false);

  Graphics& graphics_;
  const ViewOptions& options_;
  WindowInput input_;
  Overlay overlay_;
  UserStore user_;
  Autosave autosave_;
  FileDialogs dialogs_;
  Gallery gallery_;
  Hints hints_;
  std::vector<Material> tuned_from_;  // materials of the last frame, while the hint about them is shown
  std::unique_ptr<Session> session_;
  std::unique_ptr<Framebuffer> framebuffer_;
  std::unique_ptr<SplitView> split_;
  bool grab_in_b_ = false;
  MouseTool mouse_;
  Hover hover_;
  Eigen::Vector2d pointer_{-1, -1};  // the mouse, in pixels of the window's picture
  Pacing pacing_;
  VideoCapture video_;
  std::unique_ptr<SessionRecording> recording_;  // none: there is no place for it
  long recorded_from_ = 0;                       // steps made before it
  bool begins_at_start_ = true;                  // where R goes, not in mid-session
  ReplayView replay_view_;
  std::optional<DisplaySettings> replayed_display_;
  WindowState state_;
  RunStats stats_;
  std::optional<Message> message_;
  gl::Timer solve_timer_, render_timer_;
  int samples_;
  long steps_left_ = -1;                         // until the window closes by itself; negative: it does not
  double simulated_ = 0;                         // in this frame [s]
  long divergences_ = 0;                         // times in a row
  long diverged_at_ = 0;                         // steps made when it last did
  std::optional<Diagnostics> diagnostics_of_a_;  // the latest of session_
  bool diagnose_ = true;                         // the state has changed since the last diagnostics
  struct Moment {
    double time = 0;  // simulated [s]
    long steps = 0;   // made
  };
  std::array<Moment, 2> diagnosed_;  // the last that diagnostics were asked of; no more are under way
  int frames_to_settle_ = 3;         // to draw although nothing moves
  bool settled_ = false;             // nothing has happened since settle()
  bool shown_ = false;               // this session, in a frame: steps come after the first picture
  // What was active or open when the last frame ended: ImGui closes it before a key is looked at here
  bool panels_take_escape_ = false;
  std::optional<CameraSettings> opened_camera_;  // as the session began with
  std::shared_ptr<const Replay> remembered_;  // the scene as it was a few seconds ago, in case that the device is lost
  std::string remembered_scene_;              // of it, as a file would say it
  long remembered_step_ = 0;                  // steps solved then
  std::optional<std::filesystem::path>
      recovered_;  // by a window that ended badly; until the user has said what to do with it
  std::vector<std::future<Opened>> given_up_;  // readings that nobody waits for
};

}  // namespace fascia
