// The menus and, at their right, what is open.
#include "menu_panel.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include "panels/commands/commands.h"

namespace talus {
namespace {

// The key of a command as it works where the focus is: those of the other side of the window need the focus
// first.
std::string keys_from_here(const Command& command, const Ui& ui) {
  const std::string key = keys_of(command, ui);
  if (has_focus(command, ui.view)) return key;
  return keys_of(focus_command(command.scope), ui) + ", " + key;
}

void draw_command(std::string_view id, const Session& session, Actions& actions, Ui& ui) {
  const Command& command = find_command(id);
  const std::string label(command.label), keys = "    " + keys_from_here(command, ui);  // apart from labels
  const bool enabled = command.is_enabled(session, ui);
  if (menu_item(label, {}, keys, command.is_checked(session, ui), enabled)) command.run(session, actions, ui);
  ui.item("menu/" + std::string(id), command.help, {}, enabled);
}

// An empty id draws a line between the commands.
void draw_commands(std::initializer_list<std::string_view> ids, const Session& session, Actions& actions,
                   Ui& ui) {
  for (std::string_view id : ids) {
    if (id.empty())
      ImGui::Separator();
    else
      draw_command(id, session, actions, ui);
  }
}

// The part of an id before the slash: "map".
std::string_view group_of(const Command& command) { return command.id.substr(0, command.id.find('/')); }

bool begin_menu(const char* label, Ui& ui) {
  const std::string widget = std::string("menu/") + label;
  if (ui.view.wants_text == widget) {  // by a command
    ui.view.wants_text.clear();
    ImGui::OpenPopup(label);
  }
  const bool open = ImGui::BeginMenu(label);
  ui.item(widget);
  return open;
}

}  // namespace

void MenuPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!ImGui::BeginMenuBar()) return;
  if (begin_menu("File", ui)) {
    draw_commands({"file/new", "file/open"}, session, actions, ui);
    draw_recent_files(actions, ui);
    draw_hard_cases(actions, ui);
    draw_commands({"", "file/save", "file/save_as", "file/recover", "", "program/tic80", "program/love",
                   "program/tiled", ""},
                  session, actions, ui);
    draw_commands({"file/export", "file/export_all", "", "picture/import", "picture/export_tiles",
                   "picture/export_sprites", "picture/export_palette", "", "file/quit"},
                  session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Edit", ui)) {
    draw_commands({"edit/undo", "edit/redo", "", "shape/suggest", "shape/give", "", "flags/brush",
                   "flags/find", "flags/next", "flags/previous", "", "problems/next", "problems/previous",
                   "problems/fix", "problems/fix_kind", "", "edit/settings", "edit/keys"},
                  session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Map", ui)) {
    draw_commands({"map/stamp",
                   "map/pan",
                   "map/select",
                   "map/fill",
                   "map/line",
                   "map/rectangle",
                   "map/ellipse",
                   "map/slope",
                   "map/segment",
                   "map/body",
                   "map/erase",
                   "map/pick",
                   "map/curve",
                   "map/ground",
                   "",
                   "map/cut",
                   "map/copy",
                   "map/paste",
                   "map/delete",
                   "map/fill_selection",
                   "map/mirror_h",
                   "map/mirror_v",
                   "map/select_all",
                   "map/select_none",
                   "",
                   "map/duplicate",
                   "map/random",
                   "map/shuffle",
                   "brushes/add",
                   "ground/propose",
                   "",
                   "map/find",
                   "map/find_next",
                   "map/find_previous",
                   "map/resize"},
                  session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Sprites", ui)) {
    draw_commands({"pixels/cut",
                   "pixels/copy",
                   "pixels/paste",
                   "pixels/select_all",
                   "pixels/deselect",
                   "",
                   "pixels/pencil",
                   "pixels/pick",
                   "pixels/select",
                   "pixels/fill",
                   "pixels/line",
                   "pixels/rectangle",
                   "pixels/ellipse",
                   "pixels/smaller_brush",
                   "pixels/larger_brush",
                   "",
                   "pixels/flip_h",
                   "pixels/flip_v",
                   "pixels/rotate",
                   "pixels/shift_left",
                   "pixels/shift_right",
                   "pixels/shift_up",
                   "pixels/shift_down",
                   "pixels/clear",
                   "",
                   "palette/copy",
                   "palette/paste",
                   "",
                   "sheet/switch",
                   "pixels/neighbours",
                   "pixels/enlarge"},
                  session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("View", ui)) {
    draw_commands({"view/sprites",
                   "view/map",
                   "view/cursor",
                   "",
                   "canvas/map",
                   "canvas/play",
                   "canvas/both",
                   "canvas/two_maps",
                   "",
                   "canvas/zoom_in",
                   "canvas/zoom_out",
                   "map/fit",
                   "map/minimap",
                   "",
                   "canvas/grid",
                   "canvas/borders",
                   "canvas/flag_tint",
                   "",
                   "view/layout_draw",
                   "view/layout_play",
                   "view/layout_debug",
                   "view/reset_layout",
                   "",
                   "view/light_theme",
                   "view/safe_colours",
                   "view/metrics"},
                  session, actions, ui);
    draw_scale_choice(ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Play", ui)) {
    draw_commands({"play/toggle", "play/step", "play/run", "play/reset", "", "play/slower", "play/faster", "",
                   "canvas/paint_in_play", "canvas/follow", "play/no_body", "", "canvas/legend"},
                  session, actions, ui);
    for (const OverlayInfo& info : overlay_infos())
      draw_command("overlay/" + std::string(info.key), session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Debug", ui)) {
    draw_commands({"view/debugger", "view/input", ""}, session, actions, ui);
    const auto draw_menu = [&](const char* label, std::initializer_list<std::string_view> ids) {
      if (!begin_menu(label, ui)) return;
      draw_commands(ids, session, actions, ui);
      ImGui::EndMenu();
    };
    draw_menu("Timeline",
              {"timeline/start", "timeline/back_10", "timeline/back", "play/step", "timeline/on_10",
               "timeline/end", "timeline/go_to", "", "timeline/mark", "timeline/previous_mark",
               "timeline/next_mark", "", "timeline/zoom_in", "timeline/zoom_out", "timeline/fit"});
    draw_menu("Branches", {"timeline/fork", "timeline/previous_branch", "timeline/next_branch",
                           "timeline/drop_branch", "", "timeline/rerun", "timeline/cancel"});
    draw_menu("Compare", {"compare/next", "compare/split", "", "compare/first", "compare/stop"});
    draw_menu("Plots", {"watch/new_watch", "watch/choose_times"});
    draw_menu("Reach", {"reach/find", "reach/cancel", "reach/show_way"});
    draw_menu("Breakpoints", {"stops/forwards", "stops/back", "", "stops/new", "stops/kind", "stops/pick",
                              "stops/add", "", "stops/switch_all"});
    draw_menu("Tuning", {"tuning/solver", "tuning/fields"});
    draw_commands({"", "why/next", "why/before", "", "file/save_recording"}, session, actions, ui);
    draw_edit_rule(session, actions, ui);
    ImGui::EndMenu();
  }
  if (begin_menu("Help", ui)) {
    draw_commands({"help/keys", "help/commands"}, session, actions, ui);
    draw_all_commands(session, actions, ui);
    ImGui::EndMenu();
  }
  const std::string title = session.file_names() + (session.modified() ? " *" : "");
  const std::string solver = std::string(solver_name(session.level().tuning.solver)) + "   60 Hz";
  const float solver_at = ImGui::GetWindowWidth() - size_of_text(solver).x - ui.px(8);
  ImGui::SameLine(ui.px(370));
  draw_short_text(title, solver_at - ui.px(370 + 16), theme::tone(theme::kText));
  ui.item("menu/title", session.path().empty() ? "Not in a file yet." : session.path());
  ImGui::SameLine(solver_at);
  ui.heading(solver);
  ui.tooltip("The solver that moves the bodies, and its steps a second at speed x1.");
  ImGui::EndMenuBar();
}

// So that the mouse alone reaches every command, whichever menus leave it out.
void MenuPanel::draw_all_commands(const Session& session, Actions& actions, Ui& ui) {
  const bool open = ImGui::BeginMenu("All commands");
  ui.item("menu/all", "Every command there is, by what it is about.");
  if (!open) return;
  std::vector<std::string_view> groups;
  for (const Command& command : commands()) {
    if (std::find(groups.begin(), groups.end(), group_of(command)) == groups.end())
      groups.push_back(group_of(command));
  }
  for (std::string_view group : groups) {
    const bool group_open = begin_menu(group);
    ui.item("menu/all/" + std::string(group));
    if (!group_open) continue;
    for (const Command& command : commands())
      if (group_of(command) == group) draw_command(command.id, session, actions, ui);
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_recent_files(Actions& actions, Ui& ui) {
  const auto& files = ui.view.recent_files;
  const bool open = ImGui::BeginMenu("Recent files", !files.empty());
  ui.item("menu/recent", "The files that were open before.");
  if (!open) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = std::filesystem::path(files[i]).filename().string();
    if (menu_item(name, std::to_string(i))) actions.push_back(action::OpenFile{files[i]});
    ui.item("menu/recent" + std::to_string(i), files[i]);
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_hard_cases(Actions& actions, Ui& ui) {
  const auto& files = ui.view.hard_cases;
  const bool open = ImGui::BeginMenu("Hard cases", !files.empty());
  ui.item("menu/hard_cases",
          "Scenes that break slope code, each with its own input, and the right answer drawn over it.");
  if (!open) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::string name = std::filesystem::path(files[i]).filename().string();
    name.erase(std::min(name.find('.'), name.size()));
    std::replace(name.begin(), name.end(), '-', ' ');
    if (menu_item(name, {})) actions.push_back(action::OpenFile{files[i], true});
    ui.item("menu/hard_case" + std::to_string(i), files[i]);
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_edit_rule(const Session& session, Actions& actions, Ui& ui) {
  using Kind = EditRule::Kind;
  const bool open = ImGui::BeginMenu("When the level is edited");
  ui.item("menu/edit_rule", "What becomes of the recording when the level changes under it.");
  if (!open) return;
  const EditRule now = session.edit_rule();
  const std::int64_t frame = session.state().frame;
  const auto choice = [&](Kind kind, const std::string& label, const char* name) {
    if (menu_item(label, {}, {}, now.kind == kind))
      actions.push_back(action::SetEditRule{{kind, kind == Kind::from_frame ? frame : 0}});
    ui.item(std::string("menu/rule_") + name);
  };
  choice(Kind::go_on, "Go on from the shown frame", "go_on");
  choice(Kind::from_start, "Run the recording again from frame 0", "from_start");
  choice(Kind::from_frame,
         "Run it again from frame " + std::to_string(now.kind == Kind::from_frame ? now.frame : frame),
         "from_frame");
  ImGui::EndMenu();
}

void MenuPanel::draw_scale_choice(Ui& ui) {
  const bool open = ImGui::BeginMenu("Size of text");
  ui.item("menu/scale", "How large text and controls are; automatic follows the window's height.");
  if (!open) return;
  for (double scale : {0.0, 1.0, 1.25, 1.5, 2.0, 3.0}) {
    const std::string label = scale == 0 ? "automatic" : std::to_string(static_cast<int>(scale * 100)) + " %";
    if (menu_item(label, {}, {}, ui.view.ui_scale == scale)) ui.view.ui_scale = scale;
  }
  ImGui::EndMenu();
}

}  // namespace talus
