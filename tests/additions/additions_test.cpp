// Adds one overlay, one rule of the lint and two kinds of bodies, and shows that the files named in
// docs/adding.md are enough. The three lists of this program have one or two more rows each (see
// tests/CMakeLists.txt), and everything else is as in `talus`. body_kinds_test.cpp shows the added bodies in
// games and in the window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include <talus/sim/solver.h>
#include "level/lint/fixes.h"
#include "overlay/overlay.h"
#include "panels/commands/commands.h"
#include "paths.h"
#include "platform/settings.h"
#include "unit/cli_answer.h"
#include "unit/exported_level.h"
#include "unit/folder_test.h"
#include "unit/native_text.h"

namespace talus::additions_test {

using ::testing::HasSubstr;

// A level with a body of the added kind, without a name, above solid ground.
Level level() {
  Level level = level_of_shapes({"....", "....", "1111"});
  level.tuning.solver = SolverKind::exact;
  level.spawns = level_of_native(native_with(R"("spawns": [{"x": 8, "kind": "barrel"}])")).spawns;
  return level;
}

// All files of an export, one after the other.
std::string all_of_export(const char* exporter) {
  const ReadAsset assets = [](const std::string& asset) { return read_file(source_path("assets/") + asset); };
  std::string bytes;
  const auto files = find_exporter(exporter)->write({level(), "cave", assets});
  EXPECT_TRUE(files);
  for (const ExportedFile& file : files.value_or(Exported()).files) bytes += file.bytes;
  return bytes;
}

class Additions : public FolderTest {
 protected:
  std::string file() { return put("level.talus.json", native_of_level(level())); }
};

TEST_F(Additions, AnOverlayNeedsOneFile) {
  const Overlay* centres = find_overlay("centres");
  ASSERT_NE(centres, nullptr);
  OverlaySet shown;
  shown.set(*centres, true);
  const Scene scene = compile_scene(level());
  const State state = initial_state(scene);
  const OverlayDrawing drawing =
      make_overlays({.scene = scene, .state = state, .record = {}}, shown, {0, 0, 100, 100});
  ASSERT_EQ(drawing.marks.size(), 1u);
  EXPECT_EQ(drawing.marks[0].overlay, centres);
  EXPECT_EQ(drawing.marks[0].at, state.bodies[0].box.center());

  EXPECT_EQ(find_command("overlay/centres"_command).help, centres->help);
  Settings settings;
  settings.overlays = shown;
  ASSERT_TRUE(save_settings(settings, path("settings.json")));
  EXPECT_TRUE(load_settings(path("settings.json"))->overlays.has(*centres));
  const CliAnswer help = cli_answer({"shot", "--help"});
  EXPECT_THAT(help.out, HasSubstr("centres"));
}

TEST_F(Additions, ARuleOfTheLintNeedsOneFile) {
  const std::vector<Problem> problems = lint(level());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].rule->code, "spawn-unnamed");
  EXPECT_EQ(std::count(lint_rules().begin(), lint_rules().end(), problems[0].rule), 1);
  const CliAnswer answer = cli_answer({"check", file()});
  EXPECT_THAT(answer.out, HasSubstr(": warning: body 1 has no name [spawn-unnamed]"));

  Level fixed = level();
  const Edit edit = fix_all(fixed, fixed, {}, problems, *problems[0].rule);
  EXPECT_EQ(edit.label, "Fix 1 problem: body without a name");
  apply_edit(fixed, edit);
  EXPECT_TRUE(lint(fixed).empty());
}

TEST_F(Additions, AKindOfBodyNeedsOneRow) {
  const BodyKind barrel = find_body_kind("barrel").value();
  ASSERT_EQ(level().spawns[0].kind, barrel);
  EXPECT_EQ(level().spawns[0].size, (Vec2{16, 12}));
  EXPECT_TRUE(level_of_native(native_of_level(level())) == level());

  const auto scene = std::make_shared<const Scene>(compile_scene(level()));
  State state = initial_state(*scene);
  const auto solver = make_solver(scene);
  for (int i = 0; i < 60; ++i) solver->step(state, {}, nullptr);
  EXPECT_EQ(state.bodies[0].kind, barrel);
  EXPECT_EQ(state.bodies[0].box.bottom(), 16) << "it has fallen onto the ground";

  for (const char* exporter : {"json", "csv", "svg", "lua", "tmx"})
    EXPECT_THAT(all_of_export(exporter), HasSubstr("barrel")) << exporter;
  EXPECT_THAT(all_of_export("ldtk"), HasSubstr("Barrel"));
}

}  // namespace talus::additions_test
