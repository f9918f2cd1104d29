// The menus and, at their right, the name of what is open.
#include "menu_panel.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "panel_list.h"
#include "panels/commands/commands.h"
#include "panels/files/export_as.h"
#include "panels/files/picture_in_list.h"
#include "panels/layout_presets.h"
#include "panels/ui/shown_text.h"

namespace talus {
namespace {

// The key of a command as it works at the focus: for keys of the other side of the window, the key that moves
// the focus there comes first.
std::string keys_from_here(const Command& command, const Session& session, const Ui& ui) {
  const std::string key = keys_of(command, ui);
  if (has_focus(command, session, ui.view)) return key;
  return keys_of(focus_command(command.scope), ui) + " then " + key;
}

void draw_command(const Command& command, const Session& session, Actions& actions, Ui& ui) {
  const std::string keys = keys_from_here(command, session, ui);
  const bool enabled = command.is_enabled(session, ui);
  if (menu_item(command.label, {}, keys, command.is_checked(session, ui), enabled))
    command.run(session, actions, ui);
  ui.item("menu/" + command.id, command.help, {}, enabled);
}

// As many as a low window has room for; the others are in a menu at the end.
void draw_command_rows(std::span<const Command* const> rows, const std::string& name, const Session& session,
                       Actions& actions, Ui& ui) {
  constexpr std::size_t kMaxRows = 24;
  const std::size_t count = rows.size() > kMaxRows ? kMaxRows - 1 : rows.size();
  for (const Command* const command : rows.first(count)) draw_command(*command, session, actions, ui);
  if (count == rows.size()) return;
  const bool open = ImGui::BeginMenu("More");
  ui.item(name + "/more", "The other commands of this group.");
  if (!open) return;
  draw_command_rows(rows.subspan(count), name + "/more", session, actions, ui);
  ImGui::EndMenu();
}

// The part of an id before the slash: "map".
std::string_view group_of(const Command& command) {
  return std::string_view(command.id).substr(0, command.id.find('/'));
}

// path: "Debug/Timeline"; its last part is the label.
bool begin_menu_of(const std::string& path, Ui& ui) {
  const std::string label = path.substr(path.rfind('/') + 1), widget = "menu/" + label;
  if (ui.view.requests.take<request::FocusField>(widget)) ImGui::OpenPopup(label.c_str());
  const bool open = ImGui::BeginMenu(label.c_str());
  ui.item(widget);
  return open;
}

// In the order of their sections; within a section in the order of the table.
std::vector<const Command*> commands_of_menu(std::string_view path) {
  std::vector<const Command*> found;
  for (const Command& command : commands())
    if (command.menu.menu == path) found.push_back(&command);
  std::ranges::stable_sort(found, {}, [](const Command* command) { return command->menu.section; });
  return found;
}

// The menus within a menu, in the order in which the table names them.
std::vector<std::string> menus_of_menu(std::string_view path) {
  std::vector<std::string> found;
  for (const Command& command : commands()) {
    const std::string_view menu = command.menu.menu;
    const bool is_within = menu.size() > path.size() && menu.starts_with(path) && menu[path.size()] == '/';
    if (is_within && std::ranges::find(found, menu) == found.end()) found.emplace_back(menu);
  }
  return found;
}

// Before the row of a file: the picture of its level, or a dark field if none is known.
void draw_picture_of_row(const std::string& file, Ui& ui) {
  const ImVec2 room{ui.px(64), ui.px(36)}, at = ImGui::GetCursorScreenPos();
  ImGui::Dummy(room);
  draw_recent_picture(file, at, {at.x + room.x, at.y + room.y}, ui);
  ImGui::SameLine();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (room.y - ImGui::GetTextLineHeight()) / 2);
}

constexpr float kLayoutGap = 2;       // px at scale 1, between the buttons of two layouts
constexpr float kRoomForWords = 800;  // px at scale 1, of a window whose title has room beside them

float width_of_layouts(const Ui& ui) {
  float width = 0;
  for (const LayoutPreset& preset : layout_presets())
    width += size_of_text(preset.label).x + 2 * ImGui::GetStyle().FramePadding.x + ui.px(kLayoutGap);
  return width;
}

void draw_layout_buttons(const Session& session, Actions& actions, Ui& ui) {
  for (const LayoutPreset& preset : layout_presets()) {
    const std::string id = layout_command(preset), widget = "layout/" + std::string(preset.key);
    command_text_button(CommandId{id}, session, actions, ui,
                        {.label = preset.label, .widget = widget, .height = ImGui::GetFrameHeight()});
    ImGui::SameLine(0, ui.px(kLayoutGap));
  }
}

}  // namespace

void MenuPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!ImGui::BeginMenuBar()) return;
  for (std::string_view menu : kMenus) draw_menu(std::string(menu), session, actions, ui);
  draw_title(session, actions, ui);
  ImGui::EndMenuBar();
}

void MenuPanel::draw_menu(const std::string& path, const Session& session, Actions& actions, Ui& ui) {
  if (!begin_menu_of(path, ui)) return;
  int section = 0;
  for (const Command* command : commands_of_menu(path)) {
    if (command->menu.section != section) {
      draw_end_of_section(path, section, session, actions, ui);
      ImGui::Separator();
      section = command->menu.section;
    }
    draw_command(*command, session, actions, ui);
  }
  draw_end_of_section(path, section, session, actions, ui);
  ImGui::EndMenu();
}

// Parts of the menus that are not commands: submenus and lists.
void MenuPanel::draw_end_of_section(const std::string& menu, int section, const Session& session,
                                    Actions& actions, Ui& ui) {
  if (section == 0) {
    const std::vector<std::string> within = menus_of_menu(menu);
    if (!within.empty()) ImGui::Separator();
    for (const std::string& path : within) draw_menu(path, session, actions, ui);
  }
  struct List {
    MenuPlace after;
    void (MenuPanel::*draw)(const Session&, Actions&, Ui&);
  };
  constexpr List kLists[] = {{menus::kFileOpen, &MenuPanel::draw_maps},
                             {menus::kFileOpen, &MenuPanel::draw_recent_files},
                             {menus::kFileOpen, &MenuPanel::draw_hard_cases},
                             {menus::kFileExport, &MenuPanel::draw_export_targets},
                             {menus::kViewLayouts, &MenuPanel::draw_panels},
                             {menus::kViewLooks, &MenuPanel::draw_scale_choice},
                             {menus::kDebugRecording, &MenuPanel::draw_edit_rule},
                             {menus::kHelp, &MenuPanel::draw_all_commands}};
  for (const List& list : kLists)
    if (list.after == MenuPlace{menu, section}) (this->*list.draw)(session, actions, ui);
}

void MenuPanel::draw_title(const Session& session, Actions& actions, Ui& ui) {
  const std::string title = session.file_names() + (session.modified() ? " *" : "");
  const bool has_room = ImGui::GetWindowWidth() >= ui.px(kRoomForWords);
  const std::string solver =
      (has_room ? "solver: " : "") + std::string(solver_name(session.level().tuning.solver)) + "   60 Hz";
  const float solver_at = ImGui::GetWindowWidth() - size_of_text(solver).x - ui.px(8);
  const float layouts_at = solver_at - width_of_layouts(ui) - ui.px(16);
  ImGui::SameLine(ui.px(370));
  draw_short_text(title, layouts_at - ui.px(370 + 16), theme::tone(theme::kText));
  ui.item("menu/title", session.path().empty() ? "Not in a file yet." : session.path());
  ImGui::SameLine(layouts_at);
  draw_layout_buttons(session, actions, ui);
  ImGui::SameLine(solver_at);
  ui.muted(solver);
  ui.tooltip("The solver that moves the bodies, and its steps a second at speed x1.");
}

// So the mouse alone reaches every command, even if no menu has it.
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
    std::vector<const Command*> its;
    for (const Command& command : commands())
      if (group_of(command) == group) its.push_back(&command);
    draw_command_rows(its, "menu/all/" + std::string(group), session, actions, ui);
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_maps(const Session& session, Actions& actions, Ui& ui) {
  constexpr std::size_t kMaxShown = 500;
  const MapList& maps = session.maps();
  const auto& files = maps.files();
  const bool open = ImGui::BeginMenu("Maps", !files.empty());
  ui.item("menu/maps", "The maps that were opened together, or those of a folder.");
  if (!open) return;
  for (std::size_t i = 0; i < std::min(files.size(), kMaxShown); ++i) {
    const std::string name = std::filesystem::path(files[i]).filename().string();
    draw_picture_of_row(files[i], ui);
    if (menu_item(name, std::to_string(i), {}, maps.current() == i))
      actions.push_back(action::OpenFile{files[i]});
    ui.item("menu/maps" + std::to_string(i), files[i]);
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_recent_files(const Session&, Actions& actions, Ui& ui) {
  const auto& files = ui.view.files.recent_files;
  const bool open = ImGui::BeginMenu("Recent files", !files.empty());
  ui.item("menu/recent", "The files that were open before.");
  if (!open) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = std::filesystem::path(files[i]).filename().string();
    draw_picture_of_row(files[i], ui);
    if (menu_item(name, std::to_string(i))) actions.push_back(action::OpenFile{files[i]});
    ui.item("menu/recent" + std::to_string(i), files[i]);
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_hard_cases(const Session&, Actions& actions, Ui& ui) {
  const auto& files = ui.view.files.hard_cases;
  const bool open = ImGui::BeginMenu("Hard cases", !files.empty());
  ui.item("menu/hard_cases",
          "Scenes that break slope code, each with its own input, and the right answer drawn over it.");
  if (!open) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (menu_item(example_name(files[i]), {})) actions.push_back(action::OpenFile{files[i], true});
    ui.item("menu/hard_case" + std::to_string(i), files[i]);
  }
  ImGui::EndMenu();
}

// One click exports to a target: by the level's first preset of it, or by a new one.
void MenuPanel::draw_export_targets(const Session& session, Actions& actions, Ui& ui) {
  const bool open = ImGui::BeginMenu("Export as", !session.exporting().running());
  ui.item("menu/export_as",
          "Writes the level for a game or another program, beside its file. The window of "
          "exports shows what is written, and where.");
  if (!open) return;
  for (const Exporter& exporter : exporters()) {
    if (menu_item(capitalized(exporter.label), {})) export_as(exporter, session, actions);
    ui.item("menu/export_as/" + std::string(exporter.id), exporter.purpose);
  }
  ImGui::EndMenu();
}

// A panel that was closed comes back to its first place, and its region opens.
void MenuPanel::draw_panels(const Session&, Actions&, Ui& ui) {
  const bool open = ImGui::BeginMenu("Panels");
  ui.item("menu/panels", "The panels with tabs: closes one, or brings it back.");
  if (!open) return;
  WindowView& window = ui.view.window;
  for (const TabInfo& tab : tab_infos()) {
    const TabPlace place = moved_place(window, tab.id).value_or(tab.place);
    const bool is_shown = place != TabPlace::closed && is_open_at(window, place);
    if (menu_item(tab.title, {}, {}, is_shown)) {
      if (is_shown)
        move_tab(window, tab.id, TabPlace::closed);
      else
        ui.ask(request::ShowTab(tab.id));
    }
    ui.item("menu/panels/" + tab.id);
  }
  ImGui::EndMenu();
}

void MenuPanel::draw_edit_rule(const Session& session, Actions& actions, Ui& ui) {
  using Kind = EditRule::Kind;
  const bool open = ImGui::BeginMenu("When the level is edited");
  ui.item("menu/edit_rule", "What happens to the recording when the level is edited.");
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

void MenuPanel::draw_scale_choice(const Session&, Actions&, Ui& ui) {
  const bool open = ImGui::BeginMenu("Size of text");
  ui.item("menu/scale", "How large text and controls are; automatic follows the window's height.");
  if (!open) return;
  for (double scale : {0.0, 1.0, 1.25, 1.5, 2.0, 3.0}) {
    const std::string label = scale == 0 ? "automatic" : std::to_string(static_cast<int>(scale * 100)) + " %";
    if (menu_item(label, {}, {}, ui.view.window.ui_scale == scale)) ui.view.window.ui_scale = scale;
  }
  ImGui::EndMenu();
}

}  // namespace talus
