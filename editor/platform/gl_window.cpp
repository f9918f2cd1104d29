// The window, with the Dear ImGui backends that the system's library has.
#include "gl_window.h"

#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif
#include <SDL_opengl.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <filesystem>

#include "panels/ui/icons.h"
#include "panels/ui/theme.h"

namespace talus {
namespace {

constexpr int kLeastWidth = 700, kLeastHeight = 450;  // px: in a smaller window panels are cut off
constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* kBoldFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
constexpr float kBuiltInFontSize = 13;  // the built-in font is sharp only at whole multiples of this

void set_gl_attributes() {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
}

struct WindowSize {
  int width, height;
};

// As wanted, if the display has room for it. 0: four fifths of the display, but at least the size that the
// layout is made for.
WindowSize size_on_display(WindowSize wanted, bool offscreen) {
  const WindowSize designed{1280, 720};
  SDL_Rect room{};
  const bool is_known = !offscreen && SDL_GetDisplayUsableBounds(0, &room) == 0;
  const auto size = [&](int asked, int least, int all) {
    const int most = is_known ? all : std::max(asked, least);
    return std::min(asked > 0 ? asked : std::max(most * 4 / 5, least), most);
  };
  return {size(wanted.width, designed.width, room.w), size(wanted.height, designed.height, room.h)};
}

// Latin with all its accents, Greek and Cyrillic, dashes and quotes: names of files and presets have them.
constexpr std::array<ImWchar, 9> kGlyphs = {0x20, 0x17f, 0x370, 0x3ff, 0x400, 0x45f, 0x2010, 0x205e, 0};

void load_fonts(const WindowStyle& style, float pixel_ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  ImFontConfig config;
  std::error_code error;
  const bool has_fonts =
      std::filesystem::exists(kFontFile, error) && std::filesystem::exists(kBoldFontFile, error);
  const float size = std::round(static_cast<float>(style.font_size) * style.scale * pixel_ratio);
  config.OversampleH = 2;
  if (has_fonts) {
    io.Fonts->AddFontFromFileTTF(kFontFile, size, &config, kGlyphs.data());
  } else {
    ImFontConfig built_in;
    built_in.SizePixels = kBuiltInFontSize * std::max(1.0f, std::floor(style.scale * pixel_ratio));
    io.Fonts->AddFontDefault(&built_in);
  }
  add_icon_font(*io.Fonts, style.scale * pixel_ratio);  // its glyphs become part of the font before it
  if (has_fonts) io.Fonts->AddFontFromFileTTF(kBoldFontFile, size, &config, kGlyphs.data());
  io.FontGlobalScale = 1 / pixel_ratio;
}

// ImGui's place of a mouse that is nowhere is as far away as a float allows, which is not a pixel number.
void new_frame() {
  ImGui::NewFrame();
  constexpr float kNowhere = -300'000;  // just as invalid
  if (!ImGui::IsMousePosValid()) ImGui::GetIO().MousePos = {kNowhere, kNowhere};
}

}  // namespace

tl::expected<std::unique_ptr<GlWindow>, std::string> GlWindow::open(const WindowOptions& options) {
  std::unique_ptr<GlWindow> window(new GlWindow());
  const std::string error = window->start(options);
  if (!error.empty()) return tl::unexpected(error);
  return window;
}

std::string GlWindow::start(const WindowOptions& options) {
  offscreen_ = options.offscreen;
  if (options.offscreen) SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
  has_video_ = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
  if (options.offscreen) SDL_ResetHint(SDL_HINT_VIDEODRIVER);
  if (!has_video_) return std::string("No screen to open a window on: ") + SDL_GetError() + ".";
  // Without a screen SDL falls back to drivers that show nothing, and the program would only seem to hang.
  const std::string driver = SDL_GetCurrentVideoDriver();
  is_invisible_ = driver == "offscreen" || driver == "dummy" || driver == "evdev";
  if (is_invisible_ && !options.offscreen && SDL_getenv("SDL_VIDEODRIVER") == nullptr) {
    return "No screen to open a window on: neither an X server nor a Wayland compositor answers.";
  }
  set_gl_attributes();
  const WindowSize size = size_on_display({options.width, options.height}, options.offscreen);
  window_ =
      SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width,
                       size.height, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  if (window_ == nullptr) return std::string("Cannot open a window with OpenGL: ") + SDL_GetError() + ".";
  SDL_SetWindowMinimumSize(window_, kLeastWidth, kLeastHeight);
  gl_ = SDL_GL_CreateContext(window_);
  if (gl_ == nullptr) return std::string("OpenGL 3.3 is missing: ") + SDL_GetError() + ".";
  SDL_GL_SetSwapInterval(1);

  IMGUI_CHECKVERSION();
  imgui_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().IniFilename = nullptr;  // the program has a layout of its own
  ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
  if (!ImGui_ImplSDL2_InitForOpenGL(window_, gl_)) return "Dear ImGui cannot use the window.";
  has_backend_ = true;
  if (!ImGui_ImplOpenGL3_Init("#version 330")) return "Dear ImGui cannot use OpenGL.";
  // Without this, a full window with more than 65,536 vertices would end the program.
  if ((ImGui::GetIO().BackendFlags & ImGuiBackendFlags_RendererHasVtxOffset) == 0)
    return "OpenGL 3.2 is missing: this version cannot draw more than 65,536 vertices.";
  return {};
}

GlWindow::~GlWindow() {
  if (imgui_ != nullptr) {
    ImGui::SetCurrentContext(imgui_);
    if (ImGui::GetIO().BackendRendererUserData != nullptr) ImGui_ImplOpenGL3_Shutdown();
    if (has_backend_) ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext(imgui_);
  }
  if (gl_ != nullptr) SDL_GL_DeleteContext(gl_);
  if (window_ != nullptr) SDL_DestroyWindow(window_);
  if (has_video_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

ImVec2 GlWindow::size() const {
  int w = 0, h = 0;
  SDL_GetWindowSize(window_, &w, &h);
  return {static_cast<float>(w), static_cast<float>(h)};
}

void GlWindow::set_full_screen(bool wanted) {
  const bool is_full = windowed_.x > 0;
  if (wanted == is_full) return;
  windowed_ = wanted ? size() : ImVec2{0, 0};
  SDL_SetWindowFullscreen(window_, wanted ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

float GlWindow::pixel_ratio() const {
  int drawable = 0, width = 0;
  SDL_GL_GetDrawableSize(window_, &drawable, nullptr);
  SDL_GetWindowSize(window_, &width, nullptr);
  return width > 0 && drawable > 0 ? static_cast<float>(drawable) / static_cast<float>(width) : 1;
}

void GlWindow::set_style(const WindowStyle& style) {
  const float ratio = pixel_ratio();  // differs between screens
  if (style == style_ && ratio == font_ratio_) return;
  style_ = style;
  font_ratio_ = ratio;
  theme::apply(style.scale, style.theme);
  load_fonts(style, ratio);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void GlWindow::process_event(const SDL_Event& event) { ImGui_ImplSDL2_ProcessEvent(&event); }

// What is held down already was meant for something else. The focused control is highlighted, except in lists
// and menus, which the mouse may have opened.
void GlWindow::start_key_navigation() {
  for (float& duration : ImGui::GetIO().NavInputsDownDuration) duration = 0;
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool has_list = !context.OpenPopupStack.empty() && ImGui::GetTopMostPopupModal() == nullptr;
  if (!has_list) context.NavDisableHighlight = false;
}

// While keys navigate, Enter chooses like Space. Elsewhere keys belong to the commands, or to the text that
// is typed.
void GlWindow::enable_key_navigation(bool wanted) {
  ImGuiIO& io = ImGui::GetIO();
  if (!wanted || io.WantTextInput) {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    return;
  }
  if ((io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) == 0) start_key_navigation();
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  if (ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Enter))) io.NavInputs[ImGuiNavInput_Activate] = 1;
}

// In this version of Dear ImGui Tab stops only at fields; this makes it stop at buttons, too.
void GlWindow::let_tab_reach_every_control() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!context.NavMoveSubmitted || (context.NavMoveFlags & ImGuiNavMoveFlags_Tabbing) == 0) return;
  context.NavMoveFlags |= ImGuiNavMoveFlags_FocusApi;
  if (context.NavTabbingDir == 0 && context.NavId != 0) context.NavTabbingDir = 1;
}

void GlWindow::begin_frame(const EventQueue& events, const std::optional<CursorPointer>& pointer,
                           bool keys_navigate, double seconds) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  constexpr double kLeast = 1e-4;  // Dear ImGui needs some time between frames
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(seconds, kLeast));
#if IMGUI_VERSION_NUM < 18700
  // This version of Dear ImGui asks SDL for the mouse; events that a test has pushed would not count.
  ImGuiIO& io = ImGui::GetIO();
  const MouseState& mouse = events.mouse();
  io.MousePos = mouse.inside ? ImVec2(mouse.x, mouse.y) : ImVec2(-FLT_MAX, -FLT_MAX);
  for (std::size_t i = 0; i < mouse.down.size(); ++i) io.MouseDown[i] = mouse.down[i];
  if (pointer) {
    io.MousePos = pointer->at;
    for (std::size_t i = 0; i < mouse.down.size(); ++i)
      io.MouseDown[i] = i < pointer->down.size() && pointer->down[i];
  }
  io.KeyCtrl = (events.modifiers() & KMOD_CTRL) != 0;
  io.KeyShift = (events.modifiers() & KMOD_SHIFT) != 0;
  io.KeyAlt = (events.modifiers() & KMOD_ALT) != 0;
#else
  static_cast<void>(events);
  static_cast<void>(pointer);
#endif
  enable_key_navigation(keys_navigate);
  new_frame();
  if (keys_navigate) let_tab_reach_every_control();
}

void GlWindow::begin_picture(ImVec2 size) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::GetIO().DisplaySize = size;
  ImGui::GetIO().DisplayFramebufferScale = {1, 1};
  new_frame();
}

void GlWindow::end_frame() { ImGui::Render(); }

void GlWindow::draw() {
  if (offscreen_) return;
  const ImDrawData* data = ImGui::GetDrawData();
  glViewport(0, 0, static_cast<int>(data->DisplaySize.x * data->FramebufferScale.x),
             static_cast<int>(data->DisplaySize.y * data->FramebufferScale.y));
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

// If nothing is shown, nothing waits for a frame either: the driver would keep all commands and textures.
void GlWindow::present() {
  if (!offscreen_) SDL_GL_SwapWindow(window_);
  if (is_invisible_) glFinish();
}

}  // namespace talus
