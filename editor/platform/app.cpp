// Runs the editor: input, panels, actions, picture, frame by frame.
#include "app.h"

#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "asset_path.h"
#include "external_program.h"
#include "formats/files/atomic_file.h"
#include "formats/files/keep_aside.h"
#include "formats/last_catch.h"
#include "formats/native/recording_file.h"
#include "formats/text/utf8_text.h"
#include "panels/canvas/sheet_overlay.h"
#include "panels/commands/commands.h"
#include "panels/files/reading_panel.h"
#include "panels/ui/dialog.h"
#include "panels/window/area_picture.h"
#include "picture.h"
#include "sdl_keys.h"
#include "session/checks/prover.h"
#include "session/files/read_permissions.h"
#include "session/files/unsaved_mappings.h"
#include "session/run/work_share.h"
#include "user_folder.h"

namespace talus {
namespace {

constexpr double kLivelyAfterEvent = 0.7;  // s: for hovering, tooltips and the results of an action
constexpr double kFrameBudget = 0.008;     // s: the shortest frame, if the driver does not wait itself
constexpr double kIdleWait = 3600;         // s
constexpr double kBlinkWait = 0.25;        // s: while something changes slowly, such as a text cursor
constexpr double kNoteTime = 4;            // s; for short messages of success
// Dear ImGui draws a closed dialog once more, and gives the next frame's clicks to what was drawn before it.
// In an opened dialog the text field gets the focus one frame later.
constexpr int kDialogOpeningFrames = 2;

// s. A long message says which parts of a file a level does not have. The user should be able to read all of
// it.
double note_time(const std::string& note) {
  constexpr double kShort = 100, kReadingTime = 0.2;  // letters; s for each further letter
  constexpr double kMax = 60;  // s: a longer message is scrolled, and dismissed by hand or by this time
  return std::min(kMax, kNoteTime + std::max(0.0, static_cast<double>(note.size()) - kShort) * kReadingTime);
}

double machine_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

FrameCost cost_of_frame(double interface_seconds, double opengl_seconds) {
  const ImDrawData& data = *ImGui::GetDrawData();
  FrameCost cost{interface_seconds * 1000, opengl_seconds * 1000, data.TotalVtxCount, 0};
  for (int i = 0; i < data.CmdListsCount; ++i) cost.draw_calls += data.CmdLists[i]->CmdBuffer.Size;
  return cost;
}

// Readable on common displays: 1 up to 1080 rows, 1.5 for 1440, 2.25 for 2160.
float automatic_scale(float window_height) {
  return std::clamp(std::round(window_height / 960 * 4) / 4, 1.0f, 4.0f);
}

// The largest scale, in quarters, at which no part of the window's layout is cut off; at least 1.
float largest_scale(ImVec2 window) {
  constexpr float kLeastWidth = 880, kLeastHeight = 576;  // px at scale 1
  return std::max(1.0f, std::floor(std::min(window.x / kLeastWidth, window.y / kLeastHeight) * 4) / 4);
}

constexpr const char* kDemoLevel = "demo.talus.json";  // an asset

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

// The keys that move between controls, and press them.
bool is_navigation_key(int key) {
  return key == ' ' || key == kKeyTab || key == kKeyEnter || (key >= kKeyLeft && key <= kKeyDown);
}

// A list, a menu or a dialog.
bool is_popup_open() { return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0; }

}  // namespace

tl::expected<std::unique_ptr<App>, std::string> App::start(AppOptions options) {
  std::unique_ptr<App> app(new App(std::move(options)));
  if (!app->options_.clock) app->options_.clock = machine_time;
  Settings settings = default_settings();
  std::string problem;
  if (app->options_.remember) {
    if (auto loaded = load_settings(settings_path()))
      settings = std::move(*loaded);
    else
      problem = app->keep_settings_aside(loaded.error());
  }
  const std::string error = app->open_window(settings);
  if (!error.empty()) return tl::unexpected(error);
  app->last_time_ = app->last_event_ = app->options_.clock();
  if (!app->options_.offscreen) app->gamepads_.watch();
  CanvasesView& canvas = app->ui_.view.canvas;
  canvas.opens_on_player = canvas.follow_body = !app->options_.paused_at_first_screen;
  const bool is_asked_for = !app->options_.file.empty();
  if (!is_asked_for) app->options_.file = first_file(settings);
  app->open_first_level();
  app->take_settings(settings);
  if (app->options_.file.empty()) {
    app->play_opened_level();
    app->demo_hand_.emplace();
  }
  if (app->options_.remember) {
    app->guard_.emplace((std::filesystem::path(state_folder()) / "autosave").string(),
                        app->options_.patience);
    app->guard_->start(app->ui_.view);
  }
  if (!problem.empty()) app->session_->apply(action::ShowMessage{problem, true});
  app->note_changes();
  if (!is_asked_for)
    app->ui_.view.window.welcome_open = settings.preferences.starts_with == StartsWith::welcome;
  return app;
}

// Settings that cannot be read are not replaced: the file is kept aside, or stays; then no new settings are
// saved. Returns the text for the user.
std::string App::keep_settings_aside(const std::string& problem) {
  const auto kept = keep_aside(settings_path());
  remembers_settings_ = kept.has_value();
  return problem + (kept ? " It is kept as " + *kept + "."
                         : " It stays as it is: settings are not remembered until the next start.");
}

std::string App::open_window(Settings& settings) {
  WindowOptions window;
  if (options_.width > 0) settings.width = options_.width;
  if (options_.height > 0) settings.height = options_.height;
  window.width = settings.width;
  window.height = settings.height;
  window.offscreen = options_.offscreen;
  auto opened = GlWindow::open(window);
  if (!opened) return opened.error();
  window_ = std::move(*opened);
  textures_ = std::make_unique<SheetTextures>();
  map_textures_ = std::make_unique<MapTextureCache>();
  small_pictures_ = std::make_unique<SmallPictureTextures>();
  picture_textures_ = std::make_unique<PictureTextureCache>();
  SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
  return {};
}

void App::open_first_level() {
  ExportTools tools{.read_asset = [](const std::string& name) { return read_file(asset_path(name)); },
                    .patience = options_.patience};
  if (options_.remember) {
    tools.record = state_folder() + "/exports";
    tools.permissions = state_folder() + "/" + kPermissionsFile;
    tools.reads = state_folder() + "/" + kReadPermissionsFile;
    tools.mappings = state_folder() + "/" + kMappingsFile;
  }
  if (!options_.file.empty()) {
    waits_for_file_ = true;
    session_ = std::make_unique<Session>(Level(), "", kUnnamed, tools);
    std::vector<std::string> maps = {absolute_path(options_.file)};
    for (const std::string& other : options_.others) maps.push_back(absolute_path(other));
    session_->apply(maps.size() == 1 ? Action(action::OpenFile{maps[0]}) : Action(action::OpenMaps{maps}));
    return;
  }
  auto demo = load_level(asset_path(kDemoLevel));
  session_ = demo ? std::make_unique<Session>(std::move(demo->level), "", "demo (copy)", tools)
                  : std::make_unique<Session>(Level(), "", kUnnamed, tools);
  if (!demo) session_->apply(action::ShowMessage{"The demo level is missing: " + demo.error().message, true});
}

// A level without bodies is painted first, and a recording is looked at.
void App::play_opened_level() {
  const bool has_bodies = !session_->state().bodies.empty() || session_->compile_progress();
  if (ui_.view.preferences.plays_opened && has_bodies && session_->timeline().last_frame() == 0)
    session_->apply(action::Play{});
}

void App::take_settings(const Settings& settings) {
  ui_.view.window.layout = settings.layout;
  ui_.view.canvas.mode = settings.canvas;
  ui_.view.window.ui_scale = settings.ui_scale;
  ui_.view.sprites.pixels = settings.pixels;
  ui_.view.files.recent_files = settings.recent_files;
  ui_.view.files.kept_folders = settings.kept_folders;
  for (const std::string& file : settings.recent_files)
    if (auto picture = recent_pictures_.find(file)) ui_.view.files.recent_pictures[file] = std::move(picture);
  ui_.view.files.scenes = scene_paths();
  ui_.view.files.hard_cases = hard_case_paths();
  ui_.view.files.tour_level = asset_path("platformer/meadow.tmx");
  ui_.view.window.tabs = settings.tabs;
  ui_.view.window.moved_tabs = settings.moved_tabs;
  ui_.view.layouts = settings.layouts;
  ui_.view.window.left_open = settings.left_open;
  ui_.view.window.right_open = settings.right_open;
  ui_.view.window.right_low_open = settings.right_low_open;
  ui_.view.window.dock_open = settings.dock_open;
  ui_.view.canvas.legend_folded = settings.legend_folded;
  ui_.view.canvas.labels_all = settings.labels_all;
  ui_.view.tour.step = settings.tour_step;
  ui_.view.preferences = noted_preferences_ = settings.preferences;
  session_->apply(action::SetOverlayPalette{settings.overlay_palette});
  for (const Breakpoint& breakpoint : settings.breakpoints)
    session_->apply(action::SetBreakpoint{breakpoint});
  for (std::size_t i = 0; i < settings.plots.size(); ++i)
    session_->apply(action::SetPlot{i, {settings.plots[i], 0}});
  session_->apply(action::SetGrid{settings.grid});
  session_->apply(action::SetScreenBorders{settings.screen_borders});
  for (const Overlay* overlay : all_overlays())
    session_->apply(action::SetOverlay{overlay, settings.overlays.has(*overlay)});
}

Settings App::current_settings() const {
  Settings settings;
  const ImVec2 size = window_->windowed_size();
  settings.width = static_cast<int>(size.x);
  settings.height = static_cast<int>(size.y);
  settings.layout = ui_.view.window.layout;
  settings.canvas = ui_.view.canvas.mode;
  settings.ui_scale = ui_.view.window.ui_scale;
  settings.pixels = ui_.view.sprites.pixels;
  settings.grid = session_->choices().grid;
  settings.screen_borders = session_->choices().screen_borders;
  settings.overlays = session_->choices().overlays;
  settings.recent_files = ui_.view.files.recent_files;
  settings.kept_folders = ui_.view.files.kept_folders;
  settings.tabs = ui_.view.window.tabs;
  settings.moved_tabs = ui_.view.window.moved_tabs;
  settings.layouts = ui_.view.layouts;
  settings.left_open = ui_.view.window.left_open;
  settings.right_open = ui_.view.window.right_open;
  settings.right_low_open = ui_.view.window.right_low_open;
  settings.dock_open = ui_.view.window.dock_open;
  settings.legend_folded = ui_.view.canvas.legend_folded;
  settings.labels_all = ui_.view.canvas.labels_all;
  settings.tour_step = ui_.view.tour.step;
  settings.preferences = ui_.view.preferences;
  settings.overlay_palette = session_->choices().overlay_palette;
  settings.breakpoints = session_->debugger().breakpoints().all();
  for (const PlotList::Entry& entry : session_->debugger().plots().all())
    settings.plots.push_back(entry.plot.text);
  return settings;
}

std::string App::remember() const {
  if (!options_.remember || !remembers_settings_) return "";
  const auto saved = save_settings(current_settings(), settings_path());
  return saved ? "" : saved.error();
}

// Shows a lasting problem once, below the current message.
void App::remember_changes() {
  const std::string problem = remember();
  if (problem == std::exchange(remember_problem_, problem) || problem.empty()) return;
  const std::string told = session_->message() ? session_->message()->text + "\n" : "";
  session_->apply(action::ShowMessage{told + problem, true});
}

App::~App() {
  if (!session_) return;
  if (const std::string problem = remember(); !problem.empty())
    std::cerr << printable_line("talus: warning: " + problem) << '\n';
  if (guard_) guard_->end(*session_);
}

void App::run() {
  try {
    while (!session_->wants_quit()) turn();
  } catch (...) {  // work that is not saved here can be recovered at the next start
    if (guard_) guard_->keep(*session_);
    throw;
  }
}

void App::turn() {
  if (wait() || follow_work()) frame();
}

bool App::follow_work() {
  const bool busy = ImGui::IsAnyMouseDown() || frames_to_hold_ > 0;
  const double now = options_.clock();
  if (!guard_ || !guard_->follow(*session_, ui_.view, now, busy)) return false;
  last_event_ = now;  // a dialog is measured in its first frame and seen in a later one
  note_waits_ = true;
  return true;
}

bool App::wait() {
  const bool works = session_->playback().running || session_->timeline().behind() ||
                     session_->is_on_the_way() || session_->debugger().is_busy() ||
                     session_->compile_progress().has_value() || session_->is_linting() ||
                     session_->reach().running() || session_->prover().running() ||
                     session_->exporting().is_busy() || session_->reading();
  const double now = options_.clock();
  if (works) last_event_ = now;  // its dialog closes, and its message is measured, in later frames
  if (works || ui_.wants_frames() || has_waiting_events() || last_time_ - last_event_ < kLivelyAfterEvent) {
    const double spent = now - last_time_;
    if (spent < kFrameBudget) pause(kFrameBudget - spent, /*for_event=*/false);
    return true;
  }
  double next_frame = now + kIdleWait;
  if (!note_.empty() && !note_waits_ && !keeps_note())
    next_frame = std::min(next_frame, note_since_ + note_time(note_));
  if (ImGui::GetIO().WantTextInput) next_frame = std::min(next_frame, last_time_ + kBlinkWait);
  const double until = guard_ ? std::min(next_frame, guard_->due()) : next_frame;
  pause(std::max(0.0, until - now), /*for_event=*/true);
  return SDL_PollEvent(nullptr) == 1 || options_.clock() >= next_frame;
}

void App::pause(double seconds, bool for_event) const {
  if (options_.pause) return options_.pause(seconds);
  const double ms = std::ceil(seconds * 1000);
  if (for_event)
    SDL_WaitEventTimeout(nullptr, static_cast<int>(ms));
  else
    SDL_Delay(static_cast<Uint32>(ms));
}

void App::frame() {
  handle_events();
  const double now = options_.clock();
  const double passed = now - last_time_;
  play_demo();
  session_->advance(passed);
  last_time_ = ui_.time = now;
  dismiss_old_note();
  follow_work();
  window_->set_full_screen(ui_.view.window.full_screen);
  const float wanted = ui_.view.window.ui_scale > 0 ? static_cast<float>(ui_.view.window.ui_scale)
                                                    : automatic_scale(window_->size().y);
  ui_.scale = std::min(wanted, largest_scale(window_->size()));
  window_->set_style({ui_.scale, ui_.view.preferences.font_size, ui_.view.preferences.theme});
  textures_->update(*session_, ui_);
  map_textures_->update(session_->level(), session_->revision(), ui_);
  picture_textures_->update(ui_);
  small_pictures_->update(ui_);
  if (const auto& import = session_->png_import(); import && import->plan)
    textures_->show_preview(import->plan->sheet, import->plan->palette, ui_);
  if (const auto& import = session_->tile_import())
    textures_->show_preview(import->shown, session_->level().palette, ui_);
  Actions actions;
  const double start = processor_time();
  window_->begin_frame(events_, ui_.view.canvas.cursor.begin_frame(), keys_navigate_controls(), passed);
  draw(actions);
  window_->end_frame();
  const double made = processor_time();
  window_->draw();
  ui_.view.window.dialog_key = {};
  ui_.view.window.metrics.note(cost_of_frame(made - start, processor_time() - made));
  window_->present();
  ++drawn_frames_;
  apply(actions);
  copies_.follow(*session_);
  open_wanted_program();
  note_dialog_result();
  note_changes();
  hold_keys_while_dialogs_change();
}

void App::draw(Actions& actions) {
  UiFrame frame(ui_);
  ui_.problems = &session_->listed_problems();
  workspace_.draw(*session_, actions, ui_);
  draw_file_dialog(actions);
  if (guard_) guard_->draw(*session_, ui_);
}

// When a dialog opens or closes, the next presses are meant for the new state. They wait until it is drawn
// and has the focus.
void App::hold_keys_while_dialogs_change() {
  std::vector<std::string> wanted = ui_.wanted_dialogs(*session_);
  if (wanted != std::exchange(wanted_dialogs_, wanted))
    frames_to_hold_ = kDialogOpeningFrames;
  else if (frames_to_hold_ > 0)
    --frames_to_hold_;
  hold_keys_until_field_focused();
}

// If the field does not appear, no control gets the keys.
void App::hold_keys_until_field_focused() {
  Requests& requests = ui_.view.requests;
  const std::string wanted = requests.waiting_for_keys();
  if (wanted != std::exchange(wanted_field_, wanted) && !wanted.empty())
    frames_to_hold_ = Requests::kMaxFramesForKeys;
  requests.end_frame();
}

void App::handle_events() {
  // Presses while a file is read wait for it, or for the dialog that shows how far it is.
  const bool waits_for_file = session_->reading() && !shows_reading(*session_);
  events_.begin_frame(frames_to_hold_ > 0 || waits_for_file);
  std::vector<std::string> dropped;  // together
  SDL_Event event;
  while (events_.next(event)) {
    Actions actions;
    window_->process_event(event);
    last_event_ = options_.clock();
    if (is_by_user(event)) note_waits_ = false;
    const bool is_press = event.type == SDL_KEYDOWN || event.type == SDL_MOUSEBUTTONDOWN ||
                          event.type == SDL_CONTROLLERBUTTONDOWN;
    // What is pressed on the welcome page does not touch the level behind it.
    if ((is_press && !ui_.view.window.welcome_open) || event.type == SDL_DROPFILE) leave_demo();
    if (event.type == SDL_QUIT) {
      actions.push_back(action::Quit{});
    } else if (event.type == SDL_KEYDOWN) {
      handle_key(event.key, actions);
    } else if (event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN) {
      ui_.view.canvas.cursor.hide();  // the user is back at the mouse
      ui_.view.window.keys_in_panel = false;
    } else if (event.type == SDL_DROPFILE && event.drop.file != nullptr) {
      dropped.emplace_back(event.drop.file);
      SDL_free(event.drop.file);
    }
    handle_gamepad(event, actions);
    release(event, actions);
    apply(actions);
  }
  if (dropped.size() == 1) session_->apply(action::OpenFile{dropped[0]});
  if (dropped.size() > 1) session_->apply(action::OpenMaps{dropped});
}

void App::handle_key(const SDL_KeyboardEvent& key, Actions& actions) {
  const KeyChord chord = chord_of(key.keysym);
  if (!chord || capture_key(chord, key.repeat != 0)) return;
  if (key.keysym.sym == SDLK_ESCAPE && close_window(actions)) return;
  if (key.repeat == 0 && ImGui::GetTopMostPopupModal() != nullptr) ui_.view.window.dialog_key = chord;
  if (keys_are_taken(chord) || steer(chord, actions)) return;
  run_key(chord, key.repeat != 0, *session_, actions, ui_);
}

// Closes the error that is shown; else, if there is none, the window about the program that was opened
// last; else the mark on the map. Returns true if the key does only that, and no selection is lost.
bool App::close_window(Actions& actions) {
  if (ImGui::GetIO().WantTextInput || is_popup_open()) return false;
  if (std::exchange(ui_.view.commands.pad_capture, std::nullopt)) return true;
  if (std::exchange(ui_.view.window.keys_in_panel, false)) return true;
  if (session_->message() && session_->message()->is_error) {
    actions.push_back(action::DismissMessage{});
    return true;
  }
  if (const std::size_t count = session_->earlier_messages().size(); count > 0) {
    actions.push_back(action::DismissMessage{count - 1});
    return true;
  }
  for (bool* open :
       {&ui_.view.window.help_open, &ui_.view.window.settings_open, &ui_.view.window.metrics_open,
        &ui_.view.files.exports.open, &ui_.view.level.find_tiles_open, &ui_.view.window.welcome_open,
        &ui_.view.window.layouts_open, &ui_.view.window.alone, &ui_.view.debugger.picks_cell}) {
    if (std::exchange(*open, false)) return false;
  }
  if (std::exchange(ui_.view.canvas.marked_cell, std::nullopt).has_value()) return true;
  const Choices& choices = session_->choices();
  const bool keeps_tool = choices.selection || choices.pasted || ui_.view.window.focus != Focus::map ||
                          ui_.view.canvas.cursor.on() || ImGui::IsAnyMouseDown();
  if (!keeps_tool && ui_.view.canvas.mode == CanvasMode::play) ui_.view.canvas.paint_in_play = false;
  return false;
}

// Lists, menus, dialogs, floating windows, and a panel that was given the keys.
bool App::keys_navigate_controls() const {
  return is_popup_open() || ui_.view.window.keys_in_panel || floating_window_has_focus();
}

// A key for a command goes to the dialog that asks for it; but Escape closes the dialog.
bool App::capture_key(KeyChord chord, bool repeated) {
  auto& capture = ui_.view.commands.key_capture;
  if (!capture || capture->pressed) return false;
  if (repeated) return true;
  if (chord.key != kKeyEscape) capture->pressed = chord;
  return true;
}

void App::open_wanted_program() {
  const ProgramCommands& commands = ui_.view.preferences.programs;
  game_start_.follow(*session_, commands);
  const auto wanted = ui_.view.requests.take<request::OpenProgram>();
  if (!wanted || (wanted->program == ProgramId::love && game_start_.begin(*session_, commands))) return;
  open_in_program(*session_, wanted->program, commands, copies_);
}

// Holds a key of the players. Returns true if it belongs only to them: in a pause beside the map it is held
// for the next step, and also runs its command.
bool App::steer(KeyChord chord, Actions& actions) {
  const bool theirs =
      ui_.view.window.focus == Focus::map && !ui_.view.canvas.cursor.on() && has_players(*session_);
  if (!theirs || !play_keys_.press(chord, ui_.view.preferences.keys)) return false;
  actions.push_back(held());
  return keys_steer(*session_, ui_.view);
}

action::HoldKeys App::held() const {
  const action::HoldKeys keys = play_keys_.held(), pad = gamepads_.held(ui_.view.preferences.pad);
  return {keys.left || pad.left, keys.right || pad.right, keys.jump || pad.jump};
}

// Gamepads steer wherever the keys go. A button that the settings wait for steers nothing.
void App::handle_gamepad(const SDL_Event& event, Actions& actions) {
  if (!gamepads_.follow(event)) return;
  ui_.view.commands.gamepads = gamepads_.names();
  const auto pressed = Gamepads::pressed_button(event);
  auto& capture = ui_.view.commands.pad_capture;
  if (capture && pressed) {
    (ui_.view.preferences.pad.*capture->buttons)[capture->index] = *pressed;
    capture.reset();
    gamepads_.release_all();
  } else if (pressed == "start") {
    actions.push_back(action::TogglePlay{});
  }
  const Input& input = session_->playback().input;
  if (held() != action::HoldKeys{input.left, input.right, input.jump}) actions.push_back(held());
}

// A released key is released for all, whoever has the keys by then; when the window loses the focus, all keys
// are released.
void App::release(const SDL_Event& event, Actions& actions) {
  if (event.type == SDL_KEYUP) {
    ui_.view.canvas.cursor.release(chord_of(event.key.keysym).key);
    if (play_keys_.release(chord_of(event.key.keysym).key)) actions.push_back(held());
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_GAINED) {
    ui_.view.window.is_in_front = true;
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
    ui_.view.window.is_in_front = false;
    play_keys_.release_all();
    gamepads_.release_all();
    ui_.view.canvas.cursor.lift();
    actions.push_back(held());
  }
}

// While a dialog is open or a text is typed, the keys belong there.
bool App::keys_are_taken(KeyChord chord) const {
  if (ImGui::GetTopMostPopupModal() != nullptr) return true;
  if (ui_.view.window.welcome_open && !chord.ctrl && !chord.alt) return true;
  // Keys move through an open list or menu.
  if (is_popup_open() && !chord.ctrl && !chord.alt && chord.key < kKeyF1) return true;
  const bool types = ImGui::GetIO().WantTextInput;
  if (!types && !chord.ctrl && !chord.alt && is_navigation_key(chord.key) && keys_navigate_controls())
    return true;
  const bool moves_cursor = chord.key >= kKeyTab;
  const bool edits_text =
      !chord.ctrl || moves_cursor ||
      std::string_view("acvxyz").find(static_cast<char>(chord.key)) != std::string_view::npos;
  return types && chord.key < kKeyF1 && edits_text;
}

void App::draw_file_dialog(Actions& actions) {
  if (const auto asked = ui_.view.requests.take<request::ShowFileDialog>()) asked_dialog_ = asked->dialog;
  const auto is_wanted = [this](const Session& session, const View& view) {
    return wanted_file(session, view, asked_dialog_).has_value();
  };
  const auto request = wanted_file(*session_, ui_.view, asked_dialog_);
  const auto answer = browser_.draw(request, is_wanted, *session_, ui_);
  if (!answer) return;
  if (answer->cancelled) {
    asked_dialog_.reset();
    if (session_->wants_save_as() || session_->wants_save_recording())
      actions.push_back(action::CancelSaveAs{});
    return;
  }
  dialog_answered_ = true;
  actions.push_back(action::DismissMessage{});
  actions.push_back(answer_to(request->dialog, answer->path, *session_, ui_.view));
}

// An error of the dialog's own action is shown in the dialog, which stays open.
void App::note_dialog_result() {
  if (!std::exchange(dialog_answered_, false)) return;
  if (session_->message() && session_->message()->is_error) {
    browser_.show_error(session_->message()->text);
    session_->apply(action::DismissMessage{});
  } else {
    asked_dialog_.reset();
  }
}

void App::play_demo() {
  if (!demo_hand_ || !session_->playback().running) return;
  if (const auto held = demo_hand_->next(session_->state())) session_->apply(*held);
}

void App::leave_demo() {
  if (demo_hand_ && demo_hand_->holds()) session_->apply(action::HoldMouse{});
  demo_hand_.reset();
}

void App::apply(const Actions& actions) {
  session_->apply(actions);
  const bool stamps = paints_with_stamp(session_->choices().map_tool);
  for (const Action& action : actions) {
    const auto* choice = std::get_if<ChoiceAction>(&action);
    if (choice == nullptr) continue;
    const bool is_of_stamp = std::holds_alternative<action::SelectTiles>(*choice) && stamps;
    if (is_of_stamp || std::holds_alternative<action::SetMapTool>(*choice)) ui_.view.canvas.take_up_tool();
  }
}

void App::note_changes() {
  const std::string title =
      shown_line(session_->file_names(), kMaxLabel) + (session_->modified() ? " * - Talus" : " - Talus");
  if (title != title_) window_->set_title(title_ = title);
  // Only another level has a new revision and no history.
  if (session_->revision() != std::exchange(noted_revision_, session_->revision()) &&
      session_->history().edits().empty()) {
    copies_.forget();
    ui_.view.forget_level();
    ui_.view.window.welcome_open = false;
    waits_for_file_ = false;
    leave_demo();
    if (session_->path() == absolute_path(asset_path(kDemoLevel))) demo_hand_.emplace();
    if (!options_.paused_at_first_screen) play_opened_level();
  }
  if (waits_for_file_ && !session_->reading()) {
    waits_for_file_ = session_->question().has_value();
    if (session_->message() && session_->message()->is_error) ui_.view.window.welcome_open = true;
  }
  if (ui_.view.preferences != noted_preferences_) {
    noted_preferences_ = ui_.view.preferences;
    remember_changes();
  }
  const bool is_other = session_->path() != std::exchange(noted_path_, session_->path());
  const bool is_saved = session_->saves() != std::exchange(noted_saves_, session_->saves());
  if (is_other && !noted_path_.empty()) note_recent_file();
  if ((is_other || is_saved) && !noted_path_.empty()) note_recent_picture();
}

void App::note_recent_file() {
  auto& recent = ui_.view.files.recent_files;
  const std::string path = absolute_path(noted_path_);
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > kMaxRecentFiles) recent.resize(kMaxRecentFiles);
  remember_changes();
}

// Of the level as it was opened or saved last.
void App::note_recent_picture() {
  const std::string path = absolute_path(noted_path_);
  const auto picture =
      picture_of_start(session_->level(), session_->state(), RecentPictures::kWidth, RecentPictures::kHeight);
  if (picture == nullptr) return;
  ui_.view.files.recent_pictures[path] = picture;
  if (options_.remember) recent_pictures_.keep(*picture, path, ui_.view.files.recent_files);
}

// A message with a button waits for it.
bool App::keeps_note() const { return session_->message() && session_->message()->offers_ground; }

// Messages of success disappear; errors stay.
void App::dismiss_old_note() {
  const auto& message = session_->message();
  const std::string text = message && !message->is_error ? message->text : "";
  if (text != note_ || note_waits_) {
    note_ = text;
    note_since_ = last_time_;
  } else if (!note_.empty() && !keeps_note() && last_time_ - note_since_ > note_time(note_)) {
    session_->apply(action::DismissMessage{});
  }
}

tl::expected<void, std::string> App::screenshot(const std::string& path) const {
  const auto picture = draw_picture();
  if (!picture) return tl::unexpected(picture.error());
  return write_png(*picture, path);
}

int run_editor(const std::vector<std::string>& files) {
  const std::string file = files.empty() ? "" : files.front();
  const auto tell = [](const std::string& error) {
    std::cerr << printable_line("talus: error: " + error) << '\n';
    return 1;
  };
  try {
    AppOptions options{.file = file};
    if (!files.empty()) options.others.assign(files.begin() + 1, files.end());
    auto app = App::start(std::move(options));
    if (!app) return tell(app.error());
    (*app)->run();
  } catch (...) {
    return tell("the editor ended while it had " + (file.empty() ? "the demo level" : file) +
                " open: " + caught_text());
  }
  return 0;
}

}  // namespace talus
