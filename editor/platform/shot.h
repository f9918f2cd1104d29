// Pictures of the level and of the window, without a display.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "overlay/overlay_table.h"
#include "panels/preferences.h"
#include "panels/window/frame_metrics.h"
#include "session/session.h"

namespace talus {

struct ShotOptions {
  OverlaySet overlays;
  // px of the level to show; nothing: a screen, 240x136 px or the map if that is smaller, with `body`, else
  // with the bodies.
  std::optional<Rect> area;
  int zoom = 4;  // px of the picture for each px of the level, 1 to 16
  int body = 0;  // id of the body whose details are always labelled; 0: no body
};

// Draws the play view as the editor would. The error is one sentence without the path.
tl::expected<void, std::string> write_shot(const Session& session, const ShotOptions& options,
                                           const std::string& png_path);

struct WindowShotOptions {
  std::string file;  // empty: the demo level
  int width = 1280;  // px of the window
  int height = 720;
  int frames = 0;  // steps to run before the picture is taken
  ThemeKind theme = ThemeKind::dark;
  OverlaySet overlays;
  int body = 0;                          // id of the chosen body; 0: no body
  std::optional<SolverKind> solver;      // replaces the level's own solver
  std::vector<std::string> panels;       // ids of the tabs to show; not empty: the debugger's panels are open
  std::vector<std::string> breakpoints;  // conditions of breakpoints, about the chosen body
  bool runs_back = false;  // after the steps, runs back to the last frame at which a breakpoint stops
  std::optional<SolverKind> compared;  // solver that gets the same input, too
  bool two_views = false;              // shows the two sides in two views
  int stage = -1;                      // stage of the chosen body's step to draw; -1: no stage
  // Receives the share of the steps that are done, 0..1; if it returns false, there is no picture. Empty: all
  // steps are run.
  std::function<bool(double share)> goes_on = {};
};

// The cost of the window while the level was played for as many frames as FrameMetrics keeps.
struct WindowCost {
  FrameMetrics frames;
  double ns_per_step = 0;  // of the simulation, all bodies; of the last step
};

// The ids that WindowShotOptions::panels may have.
std::vector<std::string> panels_in_tabs();
// Two of these that cannot be shown at once, as they are tabs of one place; nothing: there are none.
std::optional<std::pair<std::string, std::string>> panels_of_one_place(const std::vector<std::string>& ids);
// Draws the editor's whole window, with the default settings.
// cost: measured before the picture is drawn; null: not measured.
tl::expected<void, std::string> write_window_shot(const WindowShotOptions& options,
                                                  const std::string& png_path, WindowCost* cost = nullptr);

}  // namespace talus
