// Texts and lists of files as long as a hostile file makes them, in every panel: the window keeps working.
#include <imgui.h>

#include <fstream>
#include <ostream>

#include "harness.h"
#include "panels/commands/commands.h"
#include "panels/ui/shown_text.h"
#include "platform/picture.h"

namespace talus::long_text_test {

constexpr std::size_t kLetters = 20'000;
constexpr int kEntries = 10'000;

struct HostileText {
  const char* name;
  std::string text;
  // Prints the name in the test's name, which would hold addresses otherwise.
  friend void PrintTo(const HostileText& hostile, std::ostream* out) { *out << hostile.name; }
};

std::string repeated(std::string_view part) {
  std::string text;
  while (text.size() < kLetters) text += part;
  return text;
}

std::vector<HostileText> hostile_texts() {
  return {{"Word", repeated("W")},
          {"Words", repeated("many words ")},
          {"Lines", repeated("a\n")},
          {"NoUtf8", repeated("\xff\xc3(\xe2\x82\xf0\x9f")},
          {"Controls", repeated(std::string_view("\0\x1b[2J\r\t\x7f", 9))},
          {"RightToLeft", repeated("\xe2\x80\xae"
                                   "abc\xe2\x81\xa7\xd7\xa9")},
          {"Ids", repeated("###x##")}};
}

struct WindowSize {
  int width, height;
  friend void PrintTo(const WindowSize& size, std::ostream* out) { *out << size.width << "x" << size.height; }
};

class UiLongText : public UiTest, public ::testing::WithParamInterface<std::tuple<HostileText, WindowSize>> {
 protected:
  const std::string& text() const { return std::get<HostileText>(GetParam()).text; }

  void start_with_long_names() {
    const WindowSize size = std::get<WindowSize>(GetParam());
    start(save_test_level("level.talus.json"), size.width, size.height);
    session().apply(action::RecoverLevel{std::make_shared<const Level>(level_of_long_names()), "", text()});
    frames(2);
    ASSERT_EQ(level().spawns.front().name, text());
  }

  Level level_of_long_names() const {
    Level level = test_level();
    level.flag_names.fill(text());
    FlagField field;
    field.name = text();
    field.first = 4;
    field.values = {text(), text(), text(), text()};
    level.flag_fields = {field};
    level.spawns.resize(3);
    for (std::size_t i = 0; i < level.spawns.size(); ++i) {
      level.spawns[i].name = text();
      level.spawns[i].position = {100.0 + 20 * static_cast<double>(i), 60};
    }
    LevelCurve curve;
    curve.name = text();
    curve.curve.form = Segment{{20, 100}, {60, 80}};
    level.curves = {curve, curve};
    const auto cells = std::make_shared<const MapCells>(level.map.cells().size());
    level.layers.list = {{.name = text()}, {.name = text(), .cells = cells}};
    level.brushes.resize(500, Brush{text().substr(0, kMaxBrushName), 1, 1, {1}, false, {}});
    const std::string part = text().substr(0, kMaxExportText);
    for (int i = 0; i < 100; ++i)
      level.exports.push_back({part, i % 2 == 0 ? "json" : part, part, {}, false, {}});
    level.extra = R"({"hard_case": {"number": 1, "title": ")" + json_text() + R"(", "set_up": ")" +
                  json_text() + R"(", "right_answer": ")" + json_text() +
                  R"(", "frames": 10, "checks": []}})";
    return level;
  }
  // The text, or in JSON the part of it that needs no escapes.
  std::string json_text() const {
    std::string plain;
    for (const char c : text()) plain += c >= ' ' && c < 0x7f && c != '"' && c != '\\' ? c : 'x';
    return plain;
  }

  // Draws as a window does. Fails if a text has more corners than ImGui can count.
  void look(const std::string& what) {
    frames(2);
    const ImDrawData& data = *ImGui::GetDrawData();
    EXPECT_LT(data.TotalVtxCount, 400'000) << what;
    for (int i = 0; i < data.CmdListsCount; ++i)
      for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer)
        EXPECT_LT(command.ElemCount, 6u * 65'536) << what;
  }
  void look_at_help_of(const char* widget) {
    move(centre(widget));
    frames(40);
    look(widget);
  }

  void look_at_tabs() {
    app().ui().view.window.dock_open = true;
    frames(2);
    for (const char* tab :
         {"tabs/inspector", "tabs/why", "tabs/shape", "tabs/tile", "tabs/tuning", "tabs/brushes",
          "tabs/problems", "tabs/history", "tabs/flag_search", "tabs/layers", "tabs/input_roll", "tabs/plots",
          "tabs/breakpoints", "tabs/compare", "tabs/reach"}) {
      click(tab);
      look(tab);
    }
  }
};

TEST_P(UiLongText, EveryPanelShowsIt) {
  start_with_long_names();
  session().apply(action::SetMark{0, text()});
  session().apply(action::SetPlot{0, {text(), 0}});
  session().apply(action::SetBreakpoint{{.condition = text()}});
  session().apply(action::SetFlagOverlay{level().flag_fields[0].pattern(1)});
  look_at_tabs();
  for (const CanvasMode mode : {CanvasMode::map, CanvasMode::play, CanvasMode::both}) {
    app().ui().view.canvas.mode = mode;
    look("canvas");
  }
  session().apply(action::SelectSpawn{0});
  for (int i = 0; i < 3; ++i) session().apply(action::StepFrame{});
  look_at_tabs();
  session().apply(action::SetMapTool{MapTool::curve});
  session().apply(action::SelectCurve{0});
  look_at_tabs();
  click("flags/menu0");
  look("flag menu");
  key(SDLK_ESCAPE);
  click("flags/menu4");
  look("field menu");
  key(SDLK_ESCAPE);
  click("flags/field4");
  look("field");
  key(SDLK_ESCAPE);
  click("canvas/flag_tint");
  look("tint");
  key(SDLK_ESCAPE);
  for (const char* menu : {"menu/File", "menu/Edit", "menu/View", "menu/Debug", "menu/Help"}) {
    click(menu);
    look(menu);
    key(SDLK_ESCAPE);
  }
  app().ui().view.files.exports.open = true;
  look("exports");
  look_at_help_of("export/preset0");
  app().ui().view.files.exports.open = false;
  for (const char* widget : {"flags/lamp0", "menu/title", "timeline/track"}) look_at_help_of(widget);
  // A level with such names may be impossible to save automatically.
  const bool is_saved = find("status/file") != nullptr;
  look_at_help_of(is_saved ? "status/file" : "status/not-saved-by-itself");
}

TEST_P(UiLongText, MessagesScroll) {
  start_with_long_names();
  for (const bool is_error : {false, true}) {
    session().apply(action::ShowMessage{text(), is_error});
    look("message");
    const Widget* shown = find("message/text");
    ASSERT_NE(shown, nullptr);
    const float height = static_cast<float>(std::get<WindowSize>(GetParam()).height);
    EXPECT_LT(shown->max.y - shown->min.y, height / 2);
    EXPECT_NE(find("message/dismiss"), nullptr);
  }
  click("message/dismiss");
  look("no message");
  EXPECT_FALSE(session().message());
}

TEST_P(UiLongText, QuestionsAndTheirAnswersAreInTheWindow) {
  start_with_long_names();
  session().apply(action::NewLevel{});
  look("question");
  const float height = static_cast<float>(std::get<WindowSize>(GetParam()).height);
  ASSERT_NE(find("question/cancel"), nullptr);
  EXPECT_LT(find("question/cancel")->max.y, height);
  click("question/cancel");
  EXPECT_FALSE(session().question());
}

TEST_P(UiLongText, AFieldRefusesMoreTextThanItHolds) {
  start_with_long_names();
  session().apply(action::SelectSpawn{0});
  frames(2);
  click("inspector/spawn_name");
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  type("x");
  key(SDLK_RETURN);
  EXPECT_EQ(level().spawns[0].name, text()) << "what is too long to be typed is not cut by a click";
  session().apply(action::EditLevel{replace_by(level(), std::make_shared<const Level>(test_level()), "x")});
  Level named = test_level();
  named.spawns.resize(1);
  named.spawns[0].position = {100, 60};
  session().apply(action::EditLevel{replace_by(level(), std::make_shared<const Level>(named), "y")});
  session().apply(action::SelectSpawn{0});
  frames(2);
  click("inspector/spawn_name");
  ImGui::SetClipboardText(repeated("W").c_str());
  key(KeyChord{'v', true});
  look("pasted");
  key(SDLK_RETURN);
  frames(2);
  EXPECT_EQ(level().spawns[0].name, std::string(kMaxTyped, 'W'));
}

INSTANTIATE_TEST_SUITE_P(Texts, UiLongText,
                         ::testing::Combine(::testing::ValuesIn(hostile_texts()),
                                            ::testing::Values(WindowSize{1152, 700}, WindowSize{1920, 1080})),
                         [](const auto& one) {
                           return std::string(std::get<HostileText>(one.param).name) +
                                  std::to_string(std::get<WindowSize>(one.param).width);
                         });

class UiLongList : public UiTest {
 protected:
  void look() {
    frames(3);
    EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 400'000);
  }
};

class UiLongMessage : public UiTest {};

TEST_F(UiLongMessage, CanBeCopiedAsAWholeIfItIsCut) {
  start(save_test_level("level.talus.json"));
  EXPECT_NE(ImGui::GetIO().BackendFlags & ImGuiBackendFlags_RendererHasVtxOffset, 0)
      << "a full window would end the program";
  session().apply(action::ShowMessage{"short", true});
  frames(3);
  EXPECT_EQ(find("message/copy_all"), nullptr);
  std::string text = repeated("many words ");
  text[100] = '\0';
  session().apply(action::ShowMessage{text, true});
  frames(3);
  ASSERT_NE(find("message/copy_all"), nullptr);
  click("message/copy_all");
  frames(2);
  text[100] = ' ';
  EXPECT_EQ(std::string(ImGui::GetClipboardText()), text);
}

TEST_F(UiLongList, TheHistory) {
  start();
  for (int i = 0; i < kEntries; ++i) {
    session().apply(action::EditLevel{
        {.label = "Paint",
         .changes = {
             CellChange{{1, 1}, static_cast<std::uint8_t>(i % 2), static_cast<std::uint8_t>((i + 1) % 2)}}}});
  }
  ASSERT_EQ(session().history().edits().size(), static_cast<std::size_t>(kEntries));
  click("tabs/history");
  look();
  EXPECT_NE(find("history/entry" + std::to_string(kEntries)), nullptr);
  EXPECT_EQ(find("history/entry0"), nullptr);
}

TEST_F(UiLongList, TheFilesOfAFolder) {
  start();
  std::filesystem::create_directories(path("many"));
  for (int i = 0; i < kEntries / 4; ++i)
    std::ofstream(path("many/" + std::string(180, 'W') + std::to_string(1000000 + i) + ".tic"));
  std::ofstream(path("many/\xff\xfe\x01\x1b[2J.tic"));
  app().ui().view.files.recent_files = {path("many/x.tic")};
  app().ui().ask(request::ShowFileDialog{FileDialog::open});
  frames(3);
  push_typing(path("many"));
  key(SDLK_RETURN);
  look();
  EXPECT_NE(find("files/entry/.."), nullptr);
  for (int i = 0; i < 100; ++i) key(kKeyDown);
  look();
  EXPECT_NE(find("files/entry/" + std::string(180, 'W') + "1000097.tic"), nullptr)
      << "the list follows the keys";
}

TEST_F(UiLongList, TheLayersOfAMapOfTiled) {
  start();
  {
    std::ofstream map(path("big.tmx"));
    map << R"(<map orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)"
        << R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="16" columns="16"/>)"
        << "<properties>";
    for (int i = 0; i < 1000; ++i) map << "<property name=\"property number " << i << "\" value=\"1\"/>";
    map << "</properties>";
    for (int i = 0; i < 400; ++i)
      map << "<layer name=\"layer " << i << ' ' << std::string(40, 'W')
          << "\"><data encoding=\"csv\">3</data></layer>";
    map << "</map>";
  }
  drop(path("big.tmx"));
  frames(3);
  ASSERT_NE(find("choose/open"), nullptr);
  look();
  EXPECT_LT(find("choose/open")->max.y, 720);
  EXPECT_NE(find("choose/layer1"), nullptr);
  EXPECT_EQ(find("choose/layer400"), nullptr);
  click("choose/open");
  look();
  EXPECT_NE(find("message/text"), nullptr);
}

TEST_F(UiLongList, TheMarksOfARecording) {
  start();
  for (int i = 0; i < 300; ++i) session().apply(action::StepFrame{});
  for (int i = 0; i < 300; ++i) session().apply(action::SetMark{i, "mark"});
  look();
  move(centre("timeline/track"));
  look();
}

}  // namespace talus::long_text_test
