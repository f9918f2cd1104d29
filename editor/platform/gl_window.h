// GlWindow: an SDL window with an OpenGL context and a Dear ImGui context in it.
#pragma once

#include <SDL.h>
#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "event_queue.h"
#include "panels/canvas/key_cursor.h"
#include "panels/preferences.h"

namespace talus {

struct WindowOptions {
  std::string title = "Talus";
  // px of the screen, at most the size of the display; 0: most of the display, or 1280x720 without one
  int width = 0, height = 0;
  bool offscreen = false;  // without any display, by SDL's driver of that name
};

struct WindowStyle {
  float scale = 1;                             // of text and controls
  double font_size = Preferences().font_size;  // px at scale 1
  ThemeKind theme = ThemeKind::dark;
  friend bool operator==(const WindowStyle&, const WindowStyle&) = default;
};

class GlWindow {
 public:
  // The error is one sentence on what is missing.
  static tl::expected<std::unique_ptr<GlWindow>, std::string> open(const WindowOptions& options);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  void set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }
  ImVec2 size() const;                                                           // px of the window
  ImVec2 windowed_size() const { return windowed_.x > 0 ? windowed_ : size(); }  // without full screen
  void set_full_screen(bool wanted);                                             // cheap if nothing changes
  float pixel_ratio() const;  // pixels of the framebuffer for one of the window
  bool is_minimized() const { return (SDL_GetWindowFlags(window_) & SDL_WINDOW_MINIMIZED) != 0; }

  // Sets fonts and colours; cheap if the style is already set.
  void set_style(const WindowStyle& style);
  void process_event(const SDL_Event& event);
  // pointer: place and buttons of the mouse; nothing: those of the events. keys_navigate: arrows, Tab, Space
  // and Enter move through the open controls. seconds: since the frame before.
  void begin_frame(const EventQueue& events, const std::optional<CursorPointer>& pointer, bool keys_navigate,
                   double seconds);
  // Begins a frame of that size in px for draw_picture(), whatever the size of the window.
  void begin_picture(ImVec2 size);
  // Makes triangles of what Dear ImGui got since begin_frame(). draw() hands them to OpenGL, and present()
  // shows them. Offscreen nobody would see them: there draw_picture() draws when a picture is wanted.
  void end_frame();
  void draw();
  void present();

 private:
  static void start_key_navigation();
  static void enable_key_navigation(bool wanted);
  static void let_tab_reach_every_control();
  GlWindow() = default;
  std::string start(const WindowOptions& options);  // returns the error, or an empty text

  SDL_Window* window_ = nullptr;
  SDL_GLContext gl_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  ImVec2 windowed_;  // px, of the window before it filled the screen; 0: it does not
  bool offscreen_ = false;
  bool is_invisible_ = false;  // whether SDL's driver has no screen
  bool has_video_ = false;
  bool has_backend_ = false;
  WindowStyle style_{0, 0, ThemeKind::dark};  // the style that was set last
  float font_ratio_ = 0;                      // pixel_ratio() at that time
};

}  // namespace talus
