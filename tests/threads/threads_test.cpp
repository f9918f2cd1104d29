// All threads of the program run at the same time while the level is painted. The test is for
// ThreadSanitizer; in other builds it shows that each thread gets the level of one moment.
#include <gtest/gtest.h>
#include <unistd.h>

#include "edit/export_presets.h"
#include "platform/autosave.h"
#include "session/session.h"
#include "unit/folder_test.h"

namespace talus::threads_test {

constexpr int kSide = 384;  // cells; a map of this size is compiled on a thread

class Threads : public FolderTest {
 protected:
  std::unique_ptr<Session> start() const {
    Level level;
    level.sheet(SheetId::tiles).flags[1] = 1;
    level.map = TileMap(kSide, kSide);
    level.spawns.push_back({"", {16, 8}, {}, ""});
    level.exports = {{.name = "map", .exporter = "tmj", .path = "a.tmj", .extra = {}},
                     {.name = "lua", .exporter = "lua", .path = "a.lua", .extra = {}}};
    auto session = std::make_unique<Session>(std::move(level), "", kUnnamed,
                                             ExportTools{.read_asset = {}, .record = path("exports")});
    session->apply(action::SaveFileAs{path("a.talus.json")});
    return session;
  }
  // Paints tile 1, and sets or clears its flag, so that the whole ground is compiled again.
  static void paint(Session& session, int number) {
    const Cell cell{number % kSide, 3};
    Edit edit{"Paint", {CellChange{cell, session.level().map.tile_at(cell), 1}}};
    const FlagSet flags = session.level().tile_flags(1);
    edit.changes.push_back(FlagsChange{SheetId::tiles, 1, flags, flags ^ 1});
    session.apply(action::EditLevel{std::move(edit)});
  }
};

TEST_F(Threads, CompileExportAndSaveWhileTheLevelIsPainted) {
  const auto session = start();
  Autosave autosave(path("autosave"));
  double now = 0;
  for (int i = 0; i < 60; ++i, now += 1) {
    paint(*session, i);
    if (i % 7 == 0) session->apply(action::RunExports{});
    if (i % 7 == 3) session->apply(action::PreviewExport{0});
    if (i % 14 == 5) session->apply(action::CancelExport{});
    if (i % 20 == 19) session->apply(action::SaveFile{});
    if (i % 5 == 0) session->apply(action::StepFrame{});
    autosave.follow(*session, now);
    session->advance(1.0 / 60);
    if (session->question()) session->apply(action::AnswerQuestion{action::Answer::allow});
    ::usleep(500);
  }
  paint(*session, 100);
  ASSERT_TRUE(autosave.save_now(*session));
  while (session->exporting().is_busy() || session->compile_progress()) {
    ::usleep(500);
    session->advance(0);
    if (session->question()) session->apply(action::AnswerQuestion{action::Answer::allow});
  }
  EXPECT_TRUE(exists("a.tmj"));
  EXPECT_TRUE(session->scene() == compile_scene(session->level()));
}

TEST_F(Threads, EndWithTheSession) {
  for (int round = 0; round < 10; ++round) {
    const auto session = start();
    Autosave autosave(path("autosave"));
    paint(*session, round);
    session->apply(action::RunExports{});
    autosave.follow(*session, 0);
    autosave.follow(*session, 100);
    session->advance(0);
  }
}

}  // namespace talus::threads_test
