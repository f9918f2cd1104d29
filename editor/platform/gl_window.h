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
  int width = 0, height = 0;  // px of the screen; 0: most of the display, 1280x720 without one
  bool offscreen = false;     // without any display, by SDL's driver of that name
};

struct WindowStyle {
  float scale = 1;                             // of text and controls
  double font_size = Preferences().font_size;  // px at scale 1
  ThemeKind theme = ThemeKind::dark;
  friend bool operator==(const WindowStyle&, const WindowStyle&) = default;
};

class GlWindow {
 public:
  // The error says what is missing, in one sentence.
  static tl::expected<std::unique_ptr<GlWindow>, std::string> open(const WindowOptions& options);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  void set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }
  ImVec2 size() const;        // px of the window
  float pixel_ratio() const;  // pixels of the framebuffer for one of the window
  bool is_minimized() const { return (SDL_GetWindowFlags(window_) & SDL_WINDOW_MINIMIZED) != 0; }

  // Fonts and colours; cheap when it is the style already set.
  void set_style(const WindowStyle& style);
  void process_event(const SDL_Event& event);
  // pointer: what the mouse is said to be; nothing: what the events make it. keys_navigate: the arrows,
  // Tab, Space and Enter go through what is open, control by control.
  void begin_frame(const EventQueue& events, const std::optional<CursorPointer>& pointer, bool keys_navigate);
  void begin_picture(ImVec2 size);  // a frame of that size in px for draw_picture(), whatever the window's is
  // Makes triangles of what was put into Dear ImGui since begin_frame(); draw() gives them to OpenGL, and
  // present() shows them. Offscreen nobody would see them: there draw_picture() draws, when a picture is
  // wanted.
  void end_frame();
  void draw();
  void present();

 private:
  static void start_key_navigation();
  static void enable_key_navigation(bool wanted);
  static void let_tab_reach_every_control();
  GlWindow() = default;
  std::string start(const WindowOptions& options);  // the error, or nothing

  SDL_Window* window_ = nullptr;
  SDL_GLContext gl_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  bool offscreen_ = false;
  bool is_invisible_ = false;  // SDL's driver has no screen
  bool has_video_ = false;
  bool has_backend_ = false;
  WindowStyle style_{0, 0, ThemeKind::dark};  // that was set last
  float font_ratio_ = 0;                      // pixel_ratio() at that time
};

}  // namespace talus
