// Draws offscreen with the editor's own canvas.
#include "shot.h"

#include <algorithm>
#include <cmath>

#include "app.h"
#include "edit/level_settings.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/opening_area.h"
#include "panels/canvas/tile_drawing.h"
#include "panels/window/panel_list.h"
#include "picture.h"
#include "picture_texture_cache.h"
#include "session/checks/prover.h"

namespace talus {
namespace {

constexpr int kFramesToSettle = 3;  // text and tables need more than one frame to find their sizes

// id: one of panels_in_tabs().
TabPlace place_of_tab(const std::string& id) {
  return std::ranges::find(tab_infos(), id, &TabInfo::id)->place;
}

// Opens the places of the panels, and the debugger. In a small window, that of the first one goes before.
void show_panels(const std::vector<std::string>& panels, View& view) {
  WindowView& window = view.window;
  window.tabs = panels;
  window.dock_open = !panels.empty();
  if (panels.empty()) return;
  view.canvas.mode = CanvasMode::play;
  for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel) {
    window.first = place_of_tab(*panel);
    open_place(window, window.first);
  }
}

// Does what a user would do to see what the options ask for. Returns false if it was asked to stop.
bool prepare(const WindowShotOptions& options, Session& session, View& view) {
  if (options.solver) {
    Tuning tuning = session.level().tuning;
    tuning.solver = *options.solver;
    session.apply(action::EditLevel{set_tuning(session.level(), tuning)});
  }
  for (int i = 0; i < options.frames; ++i) {
    if (options.goes_on && !options.goes_on(static_cast<double>(i) / options.frames)) return false;
    session.apply(action::StepFrame{});
  }
  session.apply(action::SelectBody{options.body});
  for (const std::string& condition : options.breakpoints)
    session.apply(action::SetBreakpoint{{.condition = condition, .body = options.body}});
  if (options.runs_back) session.apply(action::RunToBreakpoint{SearchDirection::backwards});
  if (options.overlays.any(&Overlay::needs_reach)) session.apply(action::FindReach{});
  if (options.overlays.any(&Overlay::needs_proof)) session.apply(action::Prove{});
  if (options.compared) session.apply(action::CompareVariant{Variant{*options.compared}});
  show_panels(options.panels, view);
  view.canvas.split_compared = options.two_views;
  view.debugger.stage = options.stage;
  return true;
}

// One step in each frame, as in play, so that every overlay changes.
WindowCost measure(App& app) {
  app.ui().view.window.metrics.clear();
  for (std::size_t i = 0; i < FrameMetrics::kFrames; ++i) {
    app.session().apply(action::StepFrame{});
    app.frame();
  }
  return {app.ui().view.window.metrics, app.session().step_times().series()->points().back().last};
}

}  // namespace

tl::expected<void, std::string> write_shot(const Session& session, const ShotOptions& options,
                                           const std::string& png_path) {
  const Rect area = options.area.value_or(screen_with_bodies(session.level(), session.state(), options.body));
  const auto zoom = static_cast<float>(options.zoom);
  const ImVec2 size{std::max(1.0f, std::round(static_cast<float>(area.w) * zoom)),
                    std::max(1.0f, std::round(static_cast<float>(area.h) * zoom))};
  WindowOptions hidden;
  hidden.offscreen = true;
  auto window = GlWindow::open(hidden);
  if (!window) return tl::unexpected(window.error());
  SheetTextures textures;
  Ui ui;
  ui.scale = std::clamp(zoom / 3, 1.0f, 3.0f);  // overlays stay in proportion to the art
  (*window)->set_style({.scale = ui.scale});
  textures.update(session, ui);
  PictureTextureCache pictures;
  pictures.update(ui);
  (*window)->begin_picture(size);
  const CanvasView view{{0, 0},
                        size,
                        {std::round(-area.x * zoom), std::round(-area.y * zoom)},
                        zoom,
                        session.level().map.tile_size()};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  draw_tiles(list, session.level(), view, ui,
             {.hide_balls = true, .time = static_cast<double>(session.timeline().frame()) * kMsPerFrame});
  draw_curves(list, session.level(), view, ui.scale);
  draw_bodies(list, session, session.level(), view, ui, 255);
  draw_overlays(list, session, options.overlays, view, ui.scale);
  ImGui::Render();
  const auto picture = draw_picture();
  if (!picture) return tl::unexpected(picture.error());
  return write_png(*picture, png_path, InPlace::write);
}

std::vector<std::string> panels_in_tabs() {
  std::vector<std::string> ids;
  for (const TabInfo& tab : tab_infos()) ids.push_back(tab.id);
  return ids;
}

std::optional<std::pair<std::string, std::string>> panels_of_one_place(const std::vector<std::string>& ids) {
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t k = i + 1; k < ids.size(); ++k)
      if (ids[i] != ids[k] && place_of_tab(ids[i]) == place_of_tab(ids[k])) return std::pair(ids[i], ids[k]);
  return std::nullopt;
}

tl::expected<void, std::string> write_window_shot(const WindowShotOptions& options,
                                                  const std::string& png_path, WindowCost* cost) {
  double now = 0;
  AppOptions start;
  start.file = options.file;
  start.width = options.width;
  start.height = options.height;
  start.offscreen = true;
  start.remember = false;
  start.clock = [&now] { return now; };
  auto app = App::start(std::move(start));
  if (!app) return tl::unexpected(app.error());
  Session& session = (*app)->session();
  (*app)->ui().view.preferences.plays_opened = false;
  (*app)->ui().view.preferences.theme = options.theme;
  (*app)->ui().view.window.welcome_open = false;
  session.finish_reading();
  session.apply(action::Pause{});
  for (const Overlay* overlay : all_overlays())
    session.apply(action::SetOverlay{overlay, options.overlays.has(*overlay)});
  if (!prepare(options, session, (*app)->ui().view)) return tl::unexpected(std::string("was cancelled"));
  do {
    for (int i = 0; i < kFramesToSettle; ++i) (*app)->frame();
  } while (session.debugger().is_busy() || session.is_on_the_way() || session.compile_progress() ||
           session.is_linting() || session.reach().running() || session.prover().running());
  if (cost != nullptr) *cost = measure(**app);
  if (session.message() && !session.message()->is_error) {  // it would hide what it is about
    session.apply(action::DismissMessage{});
    (*app)->frame();
  }
  return (*app)->screenshot(png_path);
}

}  // namespace talus
