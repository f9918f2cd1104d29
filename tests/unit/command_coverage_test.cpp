// Every action and every tab has a command, so that the command palette and the keys reach it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <type_traits>

#include "panels/canvas/play_keys.h"
#include "panels/commands/command_search.h"
#include "panels/commands/key_conflicts.h"
#include "panels/window/panel_list.h"
#include "paths.h"

namespace talus::command_coverage_test {

namespace fs = std::filesystem;

// For each action, the command that does it, or that leads to the place where keys do it.
const std::map<std::string, std::string> kCommandOfAction = {
    {"EditLevel", "flags/switch0"},
    {"ChooseLayer", "layers/above"},
    {"Undo", "edit/undo"},
    {"Redo", "edit/redo"},
    {"NewLevel", "file/new"},
    {"OpenTiles", "file/new_from_tiles"},
    {"OpenFile", "file/open"},
    {"OpenNextMap", "file/next_map"},
    {"SaveRecording", "file/save_recording"},
    {"SaveFile", "file/save"},
    {"SaveFileAs", "file/save_as"},
    {"AskLdtkMapping", "file/ldtk_mapping"},
    {"ExportPng", "picture/export_tiles"},
    {"PreviewExport", "file/export"},
    {"RunExports", "file/export_all"},
    {"ExportGame", "program/love"},
    {"CancelExport", "file/export_cancel"},
    {"OpenPng", "picture/import"},
    {"Quit", "file/quit"},
    {"RecoverLevel", "file/recover"},
    {"DismissMessage", "view/dismiss"},
    {"Play", "play/run"},
    {"Pause", "play/toggle"},
    {"TogglePlay", "play/toggle"},
    {"StepFrame", "play/step"},
    {"ResetPlay", "play/reset"},
    {"SetSpeed", "play/faster"},
    {"HoldKeys", "player/left"},
    {"StepBack", "timeline/back"},
    {"SeekStart", "timeline/start"},
    {"SeekEnd", "timeline/end"},
    {"SeekFrame", "timeline/go_to"},
    {"SetMark", "timeline/mark"},
    {"RemoveMark", "timeline/mark"},
    {"JumpToMark", "timeline/next_mark"},
    {"TakeOver", "timeline/fork"},
    {"SwitchBranch", "timeline/next_branch"},
    {"DropBranch", "timeline/drop_branch"},
    {"CompareBranch", "compare/next"},
    {"SetInput", "roll/toggle"},
    {"SetMouse", "roll/mouse"},
    {"SetEditRule", "timeline/edit_rule"},
    {"Rerun", "timeline/rerun"},
    {"CancelRerun", "timeline/cancel"},
    {"SetBreakpoint", "breakpoints/new"},
    {"RemoveBreakpoint", "tabs/breakpoints"},
    {"RunToBreakpoint", "breakpoints/forwards"},
    {"FindLastStop", "why/last_stop"},
    {"FindParting", "compare/first"},
    {"SetParting", "compare/type_parting"},
    {"CancelSearch", "timeline/cancel"},
    {"SetPlot", "plots/new_plot"},
    {"RemovePlot", "tabs/plots"},
    {"CompareVariant", "compare/choose"},
    {"SelectBody", "bodies/next"},
    {"SelectSpawn", "bodies/next"},
    {"SelectCurve", "curves/next"},
    {"SetCurveKind", "map/curve_arc"},
    {"SelectObject", "objects/next"},
    {"SetObjectKind", "map/object_ellipse"},
    {"SelectTiles", "sheet/right"},
    {"SetStamp", "brushes/next"},
    {"SetRandomStamp", "map/random"},
    {"SelectCells", "map/select_all"},
    {"SetPasted", "map/paste"},
    {"SetMapTool", "map/stamp"},
    {"SetSpriteTool", "pixels/pencil"},
    {"SetBrush", "pixels/larger_brush"},
    {"SelectPixels", "pixels/select_all"},
    {"MovePixels", "sheet/left"},
    {"TurnPixels", "pixels/flip_h"},
    {"PastePixels", "pixels/paste"},
    {"SetColor", "palette/next"},
    {"SetRgba", "palette/next"},
    {"SetOverlay", "overlay/boxes"},
    {"SetFlagOverlay", "flags/tint0"},
    {"SetOverlayPalette", "view/safe_colours"},
    {"FindReach", "reach/find"},
    {"CancelReach", "reach/cancel"},
    {"ShowWay", "reach/show_way"},
    {"Prove", "problems/prove"},
    {"CancelProof", "problems/cancel_proof"},
    {"PlayFinding", "problems/next_finding"},
    {"SetLintOptions", "problems/type_seam"},
    {"SetGrid", "canvas/grid"},
    {"SetScreenBorders", "canvas/borders"},
};

// Actions without a command, and why they have none.
const std::map<std::string, std::string> kWithoutCommand = {
    {"OpenMaps", "what is dropped together; the commands for the next map list the folder of the open file"},
    {"SetExportPath", "a field of the export window, which a command opens"},
    {"SetPngImport", "a choice in a dialog, which has keys of its own"},
    {"ApplyPngImport", "an answer of that dialog"},
    {"CancelPngImport", "an answer of that dialog"},
    {"SetLevelImport", "a choice in a dialog, which has keys of its own"},
    {"ApplyTiles", "an answer of that dialog"},
    {"CancelTiles", "an answer of that dialog"},
    {"ApplyLevelImport", "an answer of that dialog"},
    {"CancelLevelImport", "an answer of that dialog"},
    {"AnswerQuestion", "an answer of a dialog"},
    {"CancelSaveAs", "an answer of a dialog"},
    {"CheckFile", "done by itself every second"},
    {"ShowMessage", "what the program says"},
    {"CancelReading", "an answer of a dialog"},
    {"HoldMouse", "moves of the mouse; the keyboard's cursor makes them, too"},
};

// The actions in the lists at the end of the domains' headers.
std::set<std::string> listed_actions() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(source_path("editor/session"))) {
    if (!entry.path().filename().string().ends_with("_actions.h")) continue;
    std::ifstream in(entry.path());
    std::stringstream text;
    text << in.rdbuf();
    const std::string all = text.str();
    const std::size_t from = all.find("Action ="), to = all.find(">;", from);
    if (from == std::string::npos || to == std::string::npos) continue;
    const std::string list = all.substr(from, to - from);
    const std::regex name("action::(\\w+)");
    for (std::sregex_iterator it(list.begin(), list.end(), name), end; it != end; ++it)
      names.insert((*it)[1].str());
  }
  return names;
}

template <class... Domains>
constexpr std::size_t count_of_actions(std::type_identity<std::variant<Domains...>>) {
  return (std::variant_size_v<Domains> + ...);
}

bool is_command(const std::string& id) {
  const auto all = commands();
  return std::any_of(all.begin(), all.end(), [&](const Command& command) { return command.id == id; });
}

TEST(CommandCoverage, EveryActionHasACommandOrAReason) {
  const std::set<std::string> actions = listed_actions();
  EXPECT_EQ(actions.size(), count_of_actions(std::type_identity<Action>()));
  for (const std::string& name : actions)
    EXPECT_EQ(kCommandOfAction.count(name) + kWithoutCommand.count(name), 1u) << name;
  for (const auto& [name, id] : kCommandOfAction) {
    EXPECT_EQ(actions.count(name), 1u) << name;
    EXPECT_TRUE(is_command(id)) << id;
  }
  for (const auto& [name, reason] : kWithoutCommand) EXPECT_EQ(actions.count(name), 1u) << name;
}

TEST(CommandCoverage, EveryTabHasACommand) {
  for (const TabInfo& tab : tab_infos()) EXPECT_TRUE(is_command("tabs/" + tab.id)) << tab.id;
  EXPECT_EQ(tab_infos().size(), 17u);
}

TEST(CommandCoverage, CommandsHaveUniqueIdsAndHelp) {
  std::set<std::string_view> ids;
  for (const Command& command : commands()) {
    EXPECT_TRUE(ids.insert(command.id).second) << command.id;
    EXPECT_FALSE(command.label.empty()) << command.id;
    EXPECT_FALSE(command.help.empty()) << command.id;
    EXPECT_NE(command.run, nullptr) << command.id;
  }
}

TEST(CommandCoverage, MenusOfCommandsAreInTheBar) {
  for (const Command& command : commands()) {
    const std::string_view menu = command.menu.menu, bar = menu.substr(0, menu.find('/'));
    EXPECT_TRUE(menu.empty() || std::ranges::find(kMenus, bar) != kMenus.end()) << command.id;
    EXPECT_GE(command.menu.section, 0) << command.id;
  }
}

TEST(KeyConflicts, PlayersKeysConflictWithKeysThatAlwaysWork) {
  const Command& jump = find_command("player/jump"_command);
  EXPECT_EQ(command_with_key({kKeyF5}, jump, {})->id, "play/toggle");
  EXPECT_EQ(command_with_key({kKeyLeft}, jump, {})->id, "player/left");
  EXPECT_EQ(command_with_key({'3'}, jump, {}), nullptr)
      << "a tool of the map, which waits while players have the keys";
  KeyBindings changed;
  bind_key(jump, 0, {'k'}, changed);
  EXPECT_EQ(play_keys_text(changed), "Run: Left, Right   Jump: K, Space, Z");
}

// The id of the first command that the search finds.
std::string found_by(std::string_view typed) {
  const Command* best = nullptr;
  std::optional<int> most;
  for (const Command& command : commands()) {
    const auto score = command_score(command, typed);
    if (!score || (most && *score <= *most)) continue;
    most = score;
    best = &command;
  }
  return best != nullptr ? best->id : "";
}

TEST(CommandSearch, FindsByLabelsThenByOtherWords) {
  EXPECT_EQ(found_by("metrics"), "view/metrics");
  EXPECT_EQ(found_by("spawn"), "map/body");
  EXPECT_EQ(found_by("spawn rename"), "bodies/name");
  EXPECT_EQ(found_by("shortcuts"), "edit/keys");
  EXPECT_EQ(found_by("name flag 3"), "flags/name3");
  EXPECT_EQ(found_by("hex flags"), "flags/type_byte");
  EXPECT_EQ(found_by("type rgb"), "palette/type");
  EXPECT_EQ(found_by("killed"), "file/recover") << "of its help";
  EXPECT_EQ(found_by("undo"), "edit/undo") << "labels come first";
  EXPECT_EQ(found_by("flag"), "flags/find")
      << "and whole words in labels come before single letters, as in FLip left And riGht";
  EXPECT_EQ(found_by("level width"), "map/resize");
  EXPECT_EQ(found_by("no such thing anywhere"), "");
}

constexpr auto kAllEnabled = [](const Command&) { return true; };

TEST(CommandSearch, ListsCommandsThatCanRunFirst) {
  EXPECT_EQ(matching_commands("", kAllEnabled).commands.size(), commands().size());
  const auto found = matching_commands("undo", kAllEnabled).commands;
  ASSERT_GT(found.size(), 1u);
  EXPECT_EQ(found.front()->id, "edit/undo");
  const auto now =
      matching_commands("undo", [](const Command& command) { return command.id != "edit/undo"; }).commands;
  ASSERT_EQ(now.size(), found.size());
  EXPECT_EQ(now.back()->id, "edit/undo") << "there is nothing to undo";
  EXPECT_EQ(now.front(), found[1]);
}

TEST(CommandSearch, TellsThatTheTypedCommandIsDisabled) {
  const auto but_undo = [](const Command& command) { return command.id != "edit/undo"; };
  const auto none = [](const Command&) { return false; };
  EXPECT_EQ(matching_commands("undo", kAllEnabled).meant, nullptr);
  ASSERT_NE(matching_commands("undo", but_undo).meant, nullptr);
  EXPECT_EQ(matching_commands("undo", but_undo).meant->id, "edit/undo");
  EXPECT_EQ(matching_commands("undo", none).meant->id, "edit/undo");
  EXPECT_EQ(matching_commands("", but_undo).meant, nullptr);
  EXPECT_EQ(matching_commands("no such thing anywhere", none).meant, nullptr);
}

}  // namespace talus::command_coverage_test
