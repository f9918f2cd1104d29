// Session: previews of exports, exports by a thread, and the question before files of others are replaced.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>

#include "edit/export_presets.h"
#include "edit/level_settings.h"
#include "folder_test.h"
#include "paths.h"
#include "session/session.h"
#include "waiting.h"

namespace talus::session_exports_test {

namespace act = action;
namespace fs = std::filesystem;

class SessionExports : public FolderTest {
 protected:
  void SetUp() override { start(); }
  void TearDown() override {
    if (gate_) gate_->set_value();
    session_.reset();
  }

  // Starts a session on a saved level. If there is a gate, assets can be read only once it is open.
  void start(std::shared_future<void> gate = {}) {
    const ReadAsset read = [gate, this](const std::string& name) {
      if (gate.valid()) gate.wait();
      ++assets_read_;
      return read_file(source_path("assets/") + name);
    };
    session_ = std::make_unique<Session>(Level(), "", kUnnamed, ExportTools{read, path("state/exports")});
    session_->apply(act::SaveFileAs{path("cave.talus.json")});
  }
  void start_gated() {
    gate_.emplace();
    start(gate_->get_future().share());
  }

  Session& session() { return *session_; }
  const Exporting& exporting() { return session().exporting(); }
  std::string message() { return session().message() ? session().message()->text : ""; }

  void add(const std::string& name, const std::string& exporter, const std::string& to,
           bool on_save = false) {
    session().apply(act::EditLevel{add_export(session().level(), {name, exporter, to, "", on_save, ""})});
  }
  void wait() { ASSERT_TRUE(exports_end(session())); }
  const ExportOutcome& preview(std::size_t preset) {
    session().apply(act::PreviewExport{preset});
    wait();
    return exporting().preview()->outcome;
  }
  void run(std::optional<std::size_t> preset = {}) {
    session().apply(act::RunExports{preset});
    wait();
  }

  std::optional<std::promise<void>> gate_;
  std::atomic<int> assets_read_ = 0;
  std::unique_ptr<Session> session_;
};

TEST_F(SessionExports, ThePreviewShowsExactlyTheWrittenFiles) {
  add("game", "love", "out/game");
  const ExportOutcome shown = preview(0);
  ASSERT_FALSE(shown.problem);
  EXPECT_EQ(shown.output, path("out/game"));
  EXPECT_GE(shown.files.size(), 5u);
  EXPECT_FALSE(exists("out"));
  run();
  EXPECT_EQ(message(), "Exported game: " + std::to_string(shown.files.size()) + " files to out/game.");
  for (const PlannedFile& file : shown.files) {
    EXPECT_EQ(file.place, PlannedFile::Place::empty) << file.name;
    EXPECT_EQ(fs::file_size(file.path), file.size) << file.name;
  }
  for (const PlannedFile& file : preview(0).files) EXPECT_EQ(file.place, PlannedFile::Place::same);
}

TEST_F(SessionExports, ALevelWithoutAFileHasSizesButNoPaths) {
  session().apply(act::NewLevel{});
  add("cart", "tic", "a.tic");
  const ExportOutcome& shown = preview(0);
  ASSERT_EQ(shown.files.size(), 1u);
  EXPECT_GT(shown.files[0].size, 0u);
  ASSERT_TRUE(shown.problem);
  EXPECT_EQ(shown.problem->field, ExportProblem::Field::path);
  EXPECT_EQ(shown.problem->error.message.substr(0, 45), "the path is relative to the level's file, but");
  run();
  EXPECT_TRUE(session().wants_save_as()) << "then it goes on";
}

TEST_F(SessionExports, FilesOfOthersAreAskedAboutBeforeReplacing) {
  fs::create_directories(path("out"));
  std::ofstream(path("out/a.tic")) << "mine";
  add("cart", "tic", "out/a.tic");
  EXPECT_EQ(preview(0).foreign, std::set<std::string>{path("out/a.tic")});
  run();
  ASSERT_TRUE(session().question());
  EXPECT_EQ(session().question()->kind, Question::Kind::replace_files);
  EXPECT_NE(session().question()->text.find(path("out/a.tic")), std::string::npos);
  session().apply(act::AnswerQuestion{act::Answer::cancel});
  wait();
  EXPECT_EQ(bytes_of("out/a.tic"), "mine");
  run();
  session().apply(act::AnswerQuestion{act::Answer::replace});
  wait();
  const std::string cart = bytes_of("out/a.tic");
  EXPECT_NE(cart, "mine");

  // An export's own file is replaced without a question, also by another start of the program.
  start();
  add("cart", "tic", "out/a.tic");
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{1, 2, 3})});
  EXPECT_TRUE(preview(0).foreign.empty());
  EXPECT_EQ(preview(0).files[0].place, PlannedFile::Place::other);
  run();
  EXPECT_FALSE(session().question());
  EXPECT_NE(bytes_of("out/a.tic"), cart);
  // A file changed by hand belongs to the user again.
  std::ofstream(path("out/a.tic"), std::ios::app) << "more";
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{4, 2, 3})});
  EXPECT_EQ(preview(0).foreign.size(), 1u);
}

TEST_F(SessionExports, SavingRunsTheMarkedPresets) {
  add("cart", "tic", "out/a.tic", true);
  add("text", "tic-text", "out/a.lua");
  session().apply(act::SaveFile{});
  wait();
  EXPECT_TRUE(exists("out/a.tic"));
  EXPECT_FALSE(exists("out/a.lua"));
  EXPECT_EQ(message(), "Saved cave.talus.json.\nExported cart: 1 file to out/a.tic.");
}

TEST_F(SessionExports, OneProblemDoesNotStopTheOtherPresets) {
  add("odd", "gameboy", "out/a.gb");
  add("cart", "tic", "out/a.tic");
  run();
  EXPECT_EQ(message(),
            "Export of odd: \"gameboy\" is not a target that this version knows.\nExported cart: 1 file to "
            "out/a.tic.");
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_TRUE(exists("out/a.tic"));
  EXPECT_EQ(session().level().exports[0].exporter, "gameboy");
}

TEST_F(SessionExports, ACancelledRunWritesNothing) {
  start_gated();
  add("game", "love", "out/game");
  session().apply(act::RunExports{0});
  session().advance(0);
  ASSERT_TRUE(exporting().running());
  EXPECT_EQ(exporting().progress()->name, "game");
  EXPECT_EQ(exporting().progress()->files, 0u) << "they are still being made";
  session().apply(act::CancelExport{});
  EXPECT_FALSE(exporting().running()) << "at once for the user";
  gate_->set_value();
  gate_.reset();
  wait();
  EXPECT_EQ(message(), "The export was cancelled: nothing was written.");
  EXPECT_FALSE(exists("out"));
  run();
  EXPECT_TRUE(exists("out/game/main.lua"));
}

TEST_F(SessionExports, APreviewDoesNotDelayARun) {
  add("cart", "tic", "out/a.tic");
  session().apply(act::PreviewExport{0});
  session().apply(act::RunExports{0});
  EXPECT_TRUE(exporting().running());
  wait();
  EXPECT_TRUE(exists("out/a.tic"));
  EXPECT_FALSE(exporting().preview()) << "the preview of the old files is dropped";
}

TEST_F(SessionExports, ARunReusesThePreviewOfTheSameLevel) {
  add("game", "love", "out/game");
  preview(0);
  const int read = assets_read_;
  ASSERT_GT(read, 0);
  run(0);
  EXPECT_TRUE(exists("out/game/main.lua"));
  EXPECT_EQ(preview(0).files[0].place, PlannedFile::Place::same) << "the places are looked at again";
  EXPECT_EQ(assets_read_, read) << "no file is made again";
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{1, 2, 3})});
  run(0);
  EXPECT_EQ(assets_read_, 2 * read) << "for a changed level all files are made again";
}

TEST_F(SessionExports, ACancelledPreviewStaysCancelled) {
  start_gated();
  add("game", "love", "out/game");
  session().apply(act::PreviewExport{0});
  const ExportTask task = session().export_task(0);
  ASSERT_TRUE(exporting().preview_progress());
  EXPECT_EQ(exporting().preview_progress()->name, "game");
  session().apply(act::CancelExport{});
  EXPECT_FALSE(exporting().preview_progress()) << "at once for the user";
  EXPECT_TRUE(exporting().preview_cancelled());
  EXPECT_TRUE(exporting().previews(session().revision(), task)) << "so the window does not start it again";
  gate_->set_value();
  gate_.reset();
  wait();
  EXPECT_FALSE(exporting().preview());
  EXPECT_EQ(message(), "Saved cave.talus.json.") << "a preview that the user cancelled gives no message";
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{1, 2, 3})});
  EXPECT_FALSE(exporting().previews(session().revision(), task)) << "of another level";
  preview(0);
  EXPECT_FALSE(exporting().preview_cancelled());
  EXPECT_TRUE(exporting().preview());
}

TEST_F(SessionExports, ALongRunReportsItsShareAndCanBeStopped) {
  start_gated();
  add("data", "csv", "out/data");
  add("game", "love", "out/game");
  session().apply(act::RunExports{});
  ExportProgress held;
  ASSERT_TRUE(comes_true([&] {
    held = exporting().progress().value();
    return held.task == 1 && held.share <= 0.5;
  }));
  EXPECT_GT(held.share, 0);
  session().apply(act::CancelExport{});
  gate_->set_value();
  gate_.reset();
  wait();
  EXPECT_EQ(message(), "The export was cancelled: nothing was written.");
  EXPECT_FALSE(exists("out"));
}

TEST_F(SessionExports, PresetsAreEditedWithUndo) {
  add("cart", "tic", "a.tic");
  ExportPreset other = session().level().exports[0];
  other.path = "b.tic";
  session().apply(act::EditLevel{set_export(session().level(), 0, other, "Change export path")});
  session().apply(act::EditLevel{remove_export(session().level(), 0)});
  EXPECT_TRUE(session().level().exports.empty());
  session().apply(act::Undo{});
  EXPECT_EQ(session().level().exports[0].path, "b.tic");
  session().apply(act::Undo{});
  EXPECT_EQ(session().level().exports[0].path, "a.tic");
  EXPECT_EQ(free_export_name(session().level(), "cart"), "cart 2");
  EXPECT_TRUE(remove_export(session().level(), 1).empty());
}

TEST_F(SessionExports, StartersThatTheUserChangedAreKept) {
  add("game", "love", "out", true);
  run();
  const std::size_t count = exporting().last_run()[0].files.size();
  std::ofstream(path("out/main.lua")) << "mine";
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{1, 2, 3})});
  const ExportOutcome& shown = preview(0);
  ASSERT_EQ(shown.kept.size(), 1u);
  EXPECT_EQ(shown.kept[0].name, "main.lua");
  EXPECT_EQ(shown.files.size(), count - 1);
  EXPECT_TRUE(shown.foreign.empty());
  session().apply(act::SaveFile{});
  wait();
  EXPECT_FALSE(session().question()) << "nothing is asked";
  EXPECT_EQ(bytes_of("out/main.lua"), "mine");
  EXPECT_EQ(message(), "Saved cave.talus.json.\nExported game: " + std::to_string(count - 1) +
                           " files to out. Kept main.lua, which is yours now.");
  // The preview made the files. They are written nevertheless if they are missing by then.
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{4, 2, 3})});
  preview(0);
  fs::remove(path("out/main.lua"));
  run();
  EXPECT_EQ(exporting().last_run()[0].files.size(), count);
  EXPECT_TRUE(exists("out/main.lua"));
}

TEST_F(SessionExports, PresetsThatOverwriteEachOtherAreProblems) {
  add("data", "lua", "out/a.lua");
  add("map", "sti", "out/a.lua");
  add("cart", "tic", "out/a.tic");
  const std::string problem =
      "the presets \"data\" and \"map\" would both write out/a.lua: give one of them another path";
  const ExportOutcome& shown = preview(1);
  ASSERT_TRUE(shown.problem);
  EXPECT_EQ(shown.problem->field, ExportProblem::Field::path);
  EXPECT_EQ(shown.problem->error.message, problem);
  EXPECT_EQ(shown.files.size(), 2u) << "their sizes are known all the same";
  run();
  EXPECT_EQ(message(), "Export of data: " + problem + ".\nExport of map: " + problem +
                           ".\nExported cart: 1 file to out/a.tic.");
  EXPECT_FALSE(exists("out/a.lua"));
}

TEST_F(SessionExports, ACartWithTooMuchCodeIsReported) {
  Level large;
  for (int i = 0; i < 2000; ++i)
    large.curves.push_back(
        {"", {Segment{{i % 200 + 0.125, i / 10.0}, {i % 200 + 3.25, 100.125}}, Curve::Faces::up}, ""});
  ASSERT_TRUE(save_level(large, *find_format("native"), path("large.talus.json")));
  session().apply(act::OpenFile{path("large.talus.json")});
  session().finish_reading();
  add("cart", "tic-playable", "out/a.tic");
  run();
  EXPECT_NE(message().find(" Too large, cart: the code has "), std::string::npos) << message();
  EXPECT_TRUE(exists("out/a.tic"));
}

TEST_F(SessionExports, ExportsOfAnotherTalusAreNotAskedAbout) {
  add("cart", "tic", "out/a.tic");
  run();
  fs::create_directories(path("out"));
  std::ofstream(path("out/a.tic")) << "of the command line";
  EXPECT_EQ(preview(0).foreign.size(), 1u);
  ExportRecord record(path("state/exports"));
  record.note(path("out/../out/a.tic"), content_hash("of the command line"));
  EXPECT_TRUE(record.save());
  session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{1, 2, 3})});
  EXPECT_TRUE(preview(0).foreign.empty());
}

// The share is read when the level is made, before the game's own files are.
TEST(ExportPreviews, ReportTheirShare) {
  std::promise<void> gate;
  const std::shared_future<void> opened = gate.get_future().share();
  std::atomic<bool> is_waiting = false;
  Exporting exporting(ExportTools{[&](const std::string& name) {
    if (name.starts_with("templates/")) {
      is_waiting = true;
      opened.wait();
    }
    return read_file(source_path("assets/") + name);
  }});
  exporting.preview(Level(), 1, {{"game", "love", "out/game", "", false, ""}, ""});
  const bool waits = comes_true([&] { return is_waiting.load(); });
  const auto progress = exporting.preview_progress();
  gate.set_value();
  ASSERT_TRUE(waits);
  ASSERT_TRUE(progress);
  EXPECT_GT(progress->share, 0.9);
  EXPECT_LE(progress->share, 1);
}

class ExportRecords : public FolderTest {};

TEST_F(ExportRecords, RecordsOfSeveralProcessesAreMerged) {
  const std::string file = path("new/exports");
  ExportRecord one(file), two(file);
  one.note("/a", 1);
  two.note("/b", 2);
  two.note("/a", 3);
  EXPECT_TRUE(one.save());
  EXPECT_FALSE(two.has("/a", 1)) << "its own entry is newer";
  EXPECT_TRUE(two.save());
  EXPECT_FALSE(one.knows("/b"));
  one.refresh();
  EXPECT_TRUE(one.has("/b", 2));
  EXPECT_TRUE(ExportRecord(file).has("/a", 3));
}

TEST_F(ExportRecords, KeepPathsWithAnyCharacters) {
  const std::string file = path("exports");
  const std::array<std::string, 4> paths = {"/a\n5 /b", "/\xff/\r\n", "/=", "/ "};
  ExportRecord record(file);
  for (const std::string& each : paths) record.note(each, 7);
  EXPECT_TRUE(record.save());
  const ExportRecord again(file);
  for (const std::string& each : paths) EXPECT_TRUE(again.has(each, 7)) << each;
  EXPECT_FALSE(again.knows("/b"));
  std::ofstream(file) << "5 /old\nx\n7 =!\n7 =L2IKYw==\n";  // as earlier versions wrote it, and damaged lines
  EXPECT_TRUE(ExportRecord(file).has("/old", 5));
  EXPECT_TRUE(ExportRecord(file).has("/b\nc", 7));
}

TEST_F(ExportRecords, NeverGrowBeyondWhatCanBeRead) {
  const std::string file = path("exports");
  const std::string long_name(60'000, 'x');
  std::ofstream old(file);
  for (int i = 0; i < 180; ++i) old << "5 /" << i << long_name << '\n';  // 11 MB
  old.close();
  ExportRecord record(file);
  record.note("/new", 7);
  EXPECT_TRUE(record.save());
  EXPECT_LE(fs::file_size(file), ExportRecord::kMaxBytes);
  EXPECT_GT(fs::file_size(file), ExportRecord::kMaxBytes / 2);
  EXPECT_TRUE(ExportRecord(file).has("/new", 7));
}

TEST_F(ExportRecords, WithoutAFileTheyLastForTheProcess) {
  ExportRecord record;
  record.note("/a", 1);
  EXPECT_TRUE(record.save());
  EXPECT_TRUE(record.refresh()) << "there is no file that cannot be read";
  EXPECT_TRUE(record.has("/a", 1));
  EXPECT_FALSE(ExportRecord().knows("/a"));
}

}  // namespace talus::session_exports_test
