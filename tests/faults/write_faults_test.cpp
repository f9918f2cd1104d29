// Every system call that writes a file fails in turn, once and for good. Old files are never lost, no
// temporary file stays, and the user is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <map>
#include <memory>

#include "faults/failing_calls.h"
#include "formats/native/recording_file.h"
#include "platform/autosave.h"
#include "platform/open_copies.h"
#include "platform/settings.h"
#include "unit/folder_test.h"
#include "unit/waiting.h"

namespace talus::write_faults_test {

namespace fs = std::filesystem;

class WriteFaults : public FolderTest {
 protected:
  void empty_folder() const {
    for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry.path());
  }
  // The content of all files by path, except locks.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file() && entry.path().extension() != ".lock")
        found[entry.path().string()] = read_file(entry.path().string()).value_or("");
    }
    return found;
  }
  int temporaries() const {
    const auto all = files();
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [](const auto& file) { return file.first.ends_with(".tmp"); }));
  }
  // prepare() creates older files. work() replaces them while a call fails, and returns whether everything
  // went well as far as the user knows. is_kept(went_well) returns whether nothing is lost. again() runs when
  // the disk works again, and returns whether everything is as wanted.
  struct Steps {
    std::function<void()> prepare;
    std::function<bool()> work;
    std::function<bool(bool)> is_kept;
    std::function<bool()> again;
  };
  void fail_each_call(const Steps& steps) {
    for (int number = 0; run_with_fault(steps, number, number % 2 == 0 ? EIO : EACCES, false); ++number)
      ASSERT_LT(number, 1000);
    for (int number = 0; run_with_fault(steps, number, ENOSPC, true); ++number) ASSERT_LT(number, 1000);
  }

 private:
  // Returns false if there is no call of this number.
  bool run_with_fault(const Steps& steps, int number, int error, bool for_good) {
    FailingCalls calls(folder_.string());
    empty_folder();
    steps.prepare();
    calls.fail_from(calls.count() + number, error, for_good);
    const bool well = steps.work();
    const std::string failed = calls.failed();
    calls.heal();
    SCOPED_TRACE(::testing::Message() << "call " << number << ", " << failed << ", fails with " << error
                                      << (for_good ? " for good" : " once"));
    EXPECT_TRUE(steps.is_kept(well));
    const bool can_remove = !for_good && !failed.starts_with("unlink");
    EXPECT_TRUE(!can_remove || temporaries() == 0);
    EXPECT_TRUE(steps.again());
    EXPECT_EQ(temporaries(), 0);
    return !failed.empty() && !HasFailure();
  }
};

Level painted(TileNumber tile) {
  Level level;
  level.map.set({1, 1}, tile);
  return level;
}

void paint(Session& session, TileNumber tile) {
  session.apply(
      action::EditLevel{Edit{"Paint", {CellChange{{1, 1}, session.level().map.tile_at({1, 1}), tile}}}});
}

TileNumber tile_in(const Level& level) { return level.map.tile_at({1, 1}); }

bool tells_error(const Session& session) { return session.message() && session.message()->is_error; }

TEST_F(WriteFaults, SavingALevel) {
  std::unique_ptr<Session> session;
  const auto saved_tile = [&] {
    const auto level = load_level(path("a.talus.json"));
    return level ? tile_in(level->level) : -1;
  };
  const auto save = [&] {
    session->apply(action::SaveFile{});
    return !session->modified();
  };
  fail_each_call(
      {.prepare =
           [&] {
             ASSERT_TRUE(save_level(painted(1), *find_format("native"), path("a.talus.json")));
             session = std::make_unique<Session>();
             session->apply(action::OpenFile{path("a.talus.json")});
             session->finish_reading();
             paint(*session, 2);
           },
       .work = save,
       .is_kept =
           [&](bool well) { return well ? saved_tile() == 2 : saved_tile() == 1 && tells_error(*session); },
       .again = [&] { return save() && saved_tile() == 2; }});
}

// The cart and its companion are two files. If every call fails, a started save cannot be taken back, and the
// companion may have its new content already.
TEST_F(WriteFaults, SavingACartAndItsCompanion) {
  std::unique_ptr<Session> session;
  const auto with_bodies = [](TileNumber tile, std::size_t count) {
    Level level = painted(tile);
    for (std::size_t i = 0; i < count; ++i)
      level.spawns.push_back({"", {16.0 * static_cast<double>(i), 8}, {}, ""});
    return level;
  };
  const auto save = [&] {
    session->apply(action::SaveFile{});
    if (session->question()) {  // a save that could not be taken back is asked about
      session->apply(action::AnswerQuestion{action::Answer::keep});
      session->apply(action::SaveFile{});
    }
    return !session->modified();
  };
  const auto saved = [&]() -> std::pair<int, std::size_t> {
    const auto level = load_level(path("a.tic"));
    return level ? std::pair<int, std::size_t>(tile_in(level->level), level->level.spawns.size())
                 : std::pair<int, std::size_t>(-1, 0);
  };
  fail_each_call({.prepare =
                      [&] {
                        ASSERT_TRUE(save_level(with_bodies(1, 1), *find_format("tic"), path("a.tic")));
                        session = std::make_unique<Session>();
                        session->apply(action::OpenFile{path("a.tic")});
                        session->finish_reading();
                        const auto changed = std::make_shared<const Level>(with_bodies(2, 2));
                        session->apply(action::EditLevel{replace_by(session->level(), changed, "Change")});
                      },
                  .work = save,
                  .is_kept =
                      [&](bool well) {
                        const auto [tile, bodies] = saved();
                        if (well) return tile == 2 && bodies == 2;
                        return tile == 1 && bodies >= 1 && tells_error(*session);
                      },
                  .again = [&] { return save() && saved() == std::pair<int, std::size_t>(2, 2); }});
}

TEST_F(WriteFaults, Autosaving) {
  std::unique_ptr<Session> session;
  std::unique_ptr<Autosave> autosave;
  double now = 0;
  const auto follow = [&] {
    for (int i = 0; i < 12; ++i, now += 1) {
      autosave->follow(*session, now);
      EXPECT_TRUE(comes_true([&] { return !autosave->is_writing(); }));
    }
    autosave->follow(*session, 0);  // takes the written file over, and begins no new write
    return !autosave->problem();
  };
  const auto saved_tile = [&] {
    for (const auto& [file, bytes] : files()) {
      const auto work = read_saved_work(file);
      if (work && !file.ends_with(".tmp")) return static_cast<int>(tile_in(*work->level));
    }
    return -1;
  };
  fail_each_call({.prepare =
                      [&] {
                        autosave.reset();
                        session = std::make_unique<Session>();
                        autosave = std::make_unique<Autosave>(path("autosave"));
                        paint(*session, 1);
                        ASSERT_TRUE(autosave->save_now(*session));
                        paint(*session, 2);
                      },
                  .work = follow,
                  .is_kept = [&](bool well) { return saved_tile() == 2 || (!well && saved_tile() == 1); },
                  .again = [&] { return follow() && saved_tile() == 2; }});
}

TEST_F(WriteFaults, TheFirstAutosave) {
  std::unique_ptr<Session> session;
  std::unique_ptr<Autosave> autosave;
  const auto save = [&] { return autosave->save_now(*session).has_value(); };
  const auto saved = [&] {
    const auto works = Autosave(path("autosave")).left_behind();  // the lock is this process's
    return works.empty() && exists("autosave") && !files().empty();
  };
  fail_each_call({.prepare =
                      [&] {
                        autosave.reset();
                        empty_folder();
                        session = std::make_unique<Session>();
                        autosave = std::make_unique<Autosave>(path("autosave"));
                        paint(*session, 1);
                      },
                  .work = save,
                  .is_kept = [&](bool well) { return well ? saved() : autosave->problem().has_value(); },
                  .again = [&] { return save() && saved(); }});
}

TEST_F(WriteFaults, WritingSettings) {
  const std::string file = path("config/settings.json");
  const auto with_scale = [](double scale) {
    Settings settings = default_settings();
    settings.ui_scale = scale;
    return settings;
  };
  const auto save = [&] { return save_settings(with_scale(2), file).has_value(); };
  const auto scale = [&] {
    const auto settings = load_settings(file);
    return settings ? settings->ui_scale : -1;
  };
  fail_each_call({.prepare = [&] { ASSERT_TRUE(save_settings(with_scale(3), file)); },
                  .work = save,
                  .is_kept = [&](bool well) { return scale() == 2 || (!well && scale() == 3); },
                  .again = [&] { return save() && scale() == 2; }});
}

TEST_F(WriteFaults, TheFirstSettings) {
  const std::string file = path("config/settings.json");
  const auto save = [&] { return save_settings(default_settings(), file).has_value(); };
  fail_each_call({.prepare = [] {},
                  .work = save,
                  .is_kept =
                      [&](bool well) {
                        return exists("config/settings.json") ? load_settings(file).has_value() : !well;
                      },
                  .again = [&] { return save() && load_settings(file).has_value(); }});
}

class ExportFaults : public WriteFaults {
 protected:
  void open(TileNumber tile) {
    Level level = painted(tile);
    level.exports = {{.name = "map", .exporter = "tmj", .path = "out/map.tmj", .extra = {}}};
    ASSERT_TRUE(save_level(level, *find_format("native"), path("a.talus.json")));
    const ExportTools tools{
        .read_asset = {}, .record = path("state/exports"), .permissions = path("state/permissions")};
    session_ = std::make_unique<Session>(Level(), "", kUnnamed, tools);
    session_->apply(action::OpenFile{path("a.talus.json")});
    session_->finish_reading();
  }
  // Returns true if all files were written and no other message was needed. Answers up to three questions.
  bool run() {
    if (session_->question()) session_->apply(action::AnswerQuestion{action::Answer::cancel});
    session_->apply(action::RunExports{});
    wait();
    for (int i = 0; i < 3 && session_->question(); ++i) {
      const bool asks_to_allow = session_->question()->kind == Question::Kind::allow_exports;
      session_->apply(
          action::AnswerQuestion{asks_to_allow ? action::Answer::allow : action::Answer::replace});
      wait();
    }
    return !session_->question() && session_->message() && !session_->message()->is_error;
  }
  void wait() { ASSERT_TRUE(exports_end(*session_)); }
  std::map<std::string, std::string> exported() const {
    auto all = files();
    std::erase_if(all, [&](const auto& file) { return !file.first.starts_with(path("out/")); });
    return all;
  }
  bool is_told() const { return tells_error(*session_) || session_->question(); }
  std::unique_ptr<Session> session_;
};

TEST_F(ExportFaults, Exporting) {
  open(2);
  ASSERT_TRUE(run()) << session_->message()->text;
  const auto as_new = exported();
  ASSERT_EQ(as_new.size(), 2u);
  std::map<std::string, std::string> before;
  const auto knows_all = [&] {
    const ExportRecord record(path("state/exports"));
    return std::all_of(as_new.begin(), as_new.end(),
                       [&](const auto& file) { return record.knows(file.first); }) &&
           record.knows("/of/another/level");
  };
  fail_each_call({.prepare =
                      [&] {
                        open(1);
                        ASSERT_TRUE(run());
                        ExportRecord record(path("state/exports"));
                        record.note("/of/another/level", 5);
                        ASSERT_TRUE(record.save());
                        before = exported();
                        open(2);
                      },
                  .work = [&] { return run(); },
                  .is_kept =
                      [&](bool well) {
                        auto now = exported();
                        std::erase_if(now, [](const auto& file) { return file.first.ends_with(".tmp"); });
                        const bool is_whole = std::all_of(now.begin(), now.end(), [&](const auto& file) {
                          return file.second == before[file.first] || file.second == as_new.at(file.first);
                        });
                        return is_whole && now.size() == before.size() && knows_all() &&
                               (well ? now == as_new : is_told());
                      },
                  .again = [&] { return run() && exported() == as_new && knows_all(); }});
}

TEST_F(WriteFaults, CopiesForOtherPrograms) {
  const ProgramInfo& tic80 = *std::find_if(program_infos().begin(), program_infos().end(),
                                           [](const ProgramInfo& info) { return info.format == "tic"; });
  const Session session(painted(2), "", "cave");
  std::unique_ptr<OpenCopies> copies;
  const auto write = [&] { return copies->write(session, tic80).has_value(); };
  const auto is_copy = [&] {
    const auto level = load_level(path("copies/cave.tic"));
    return level && tile_in(level->level) == 2;
  };
  const auto has_what_the_other_program_saved = [&] {
    const auto all = files();
    return std::any_of(all.begin(), all.end(),
                       [](const auto& file) { return file.second == "by the other"; });
  };
  fail_each_call(
      {.prepare =
           [&] {
             copies = std::make_unique<OpenCopies>(path("copies"));
             ASSERT_TRUE(copies->write(Session(painted(1), "", "cave"), tic80));
             put("copies/cave.tic", "by the other");
             copies = std::make_unique<OpenCopies>(path("copies"));  // the program starts again
           },
       .work = write,
       .is_kept = [&](bool well) { return has_what_the_other_program_saved() && (!well || is_copy()); },
       .again = [&] { return write() && is_copy() && has_what_the_other_program_saved(); }});
}

TEST_F(WriteFaults, RecordingsAndPictures) {
  std::unique_ptr<Session> session;
  std::string old_recording, old_picture;
  const auto save = [&] {
    session->apply(action::SaveRecording{path("a.talusrec")});
    const bool saved = !tells_error(*session);
    session->apply(action::ExportPng{PngPart::tiles, path("a.png")});
    return saved && !tells_error(*session);
  };
  const auto is_new = [&] {
    const auto recording = load_recording(path("a.talusrec"));
    return recording && recording->frames == 3 && bytes_of("a.png").substr(1, 3) == "PNG";
  };
  fail_each_call({.prepare =
                      [&] {
                        old_recording = put("a.talusrec", "old recording");
                        old_picture = put("a.png", "old picture");
                        session = std::make_unique<Session>(painted(2), "", "a");
                        for (int i = 0; i < 3; ++i) session->apply(action::StepFrame{});
                      },
                  .work = save,
                  .is_kept =
                      [&](bool well) {
                        const bool whole_recording = bytes_of("a.talusrec") == "old recording" ||
                                                     load_recording(path("a.talusrec")).has_value();
                        const bool whole_picture =
                            bytes_of("a.png") == "old picture" || bytes_of("a.png").size() > 100;
                        return whole_recording && whole_picture && (!well || is_new());
                      },
                  .again = [&] { return save() && is_new(); }});
}

TEST_F(WriteFaults, AFileIsSyncedBeforeItReplacesTheOldOne) {
  put("a", "old");
  FailingCalls calls(folder_.string());
  ASSERT_TRUE(write_file_atomic(path("a"), "new"));
  const std::vector<std::string> log = calls.log();
  const auto at = [&](const std::string& call) {
    const auto found = std::find(log.begin(), log.end(), call);
    EXPECT_NE(found, log.end()) << call;
    return found - log.begin();
  };
  EXPECT_LT(at("write .a.0.tmp"), at("fsync .a.0.tmp"));
  EXPECT_LT(at("fsync .a.0.tmp"), at("rename .a.0.tmp a"));
  EXPECT_LT(at("rename .a.0.tmp a"), at("fsync " + folder_.filename().string()));
}

// A file that is in place, but may not survive a power failure, is reported.
TEST_F(WriteFaults, AFolderThatCannotBeSyncedIsReported) {
  const std::string doubt =
      "is written, but a power failure may undo that, since its folder could not be synchronised: "
      "Input/output error";
  const auto fail_at_folder = [&](FailingCalls& calls, const std::function<void()>& write) {
    write();  // from now on it replaces an older file
    const int before = calls.count();
    write();
    const auto log = calls.log();
    const auto at = std::find(log.begin() + before, log.end(), "fsync " + folder_.filename().string());
    ASSERT_NE(at, log.end());
    calls.fail_from(calls.count() + static_cast<int>(at - log.begin()) - before, EIO, false);
    write();
    EXPECT_EQ(calls.failed(), *at);
    calls.heal();
  };
  FailingCalls calls(folder_.string());
  FormatResult<void> written;
  fail_at_folder(calls, [&] { written = write_file_atomic(path("a"), "new"); });
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, doubt);
  EXPECT_EQ(bytes_of("a"), "new");

  Session session(painted(1), "", "a");
  session.apply(action::SaveFileAs{path("a.talus.json")});
  fail_at_folder(calls, [&] {
    paint(session, static_cast<TileNumber>(tile_in(session.level()) + 1));
    session.apply(action::SaveFile{});
  });
  EXPECT_EQ(session.message()->text, "Saved a.talus.json. a.talus.json " + doubt + ".");
  EXPECT_FALSE(session.modified());
}

TEST_F(WriteFaults, APermissionThatCannotBeStoredIsReported) {
  const std::string store = put("no_folder", "") + "/allowed";
  Session session(painted(1), "", "a", ExportTools{.read_asset = {}, .record = "", .permissions = store});
  const ExportPreset preset{.name = "map", .exporter = "csv", .path = "map", .extra = {}};
  session.apply(action::EditLevel{Edit{"Add", {ExportsChange{{}, {preset}}}}});
  session.apply(action::SaveFileAs{path("a.talus.json")});
  EXPECT_EQ(
      session.message()->text,
      "Saved a.talus.json.\nCannot save which exports are allowed, so Talus will ask about them again: " +
          store + " cannot be written: Not a directory.");
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_FALSE(session.modified());

  Session later(Level(), "", kUnnamed, ExportTools{.read_asset = {}, .record = "", .permissions = store});
  later.apply(action::OpenFile{path("a.talus.json")});
  later.apply(action::RunExports{});
  ASSERT_TRUE(exports_end(later));
  ASSERT_TRUE(later.question()) << "it is asked about again";
  later.apply(action::AnswerQuestion{action::Answer::allow});
  ASSERT_TRUE(exports_end(later));
  EXPECT_TRUE(exists("map") && !fs::is_empty(path("map"))) << "and written";
  EXPECT_NE(later.message()->text.find("Cannot save which exports are allowed"), std::string::npos)
      << later.message()->text;
}

TEST_F(WriteFaults, AChangeIsSeenIfTheFileWasUnreadableBefore) {
  Session session(painted(1), "", "a");
  FailingCalls calls(folder_.string());
  session.apply(action::SaveFileAs{path("a.talus.json")});
  const int all = calls.count();
  paint(session, 2);
  calls.fail_from(all + all - 2, EIO, false);  // a read of the saved file
  session.apply(action::SaveFile{});
  ASSERT_NE(calls.failed().find("read"), std::string::npos) << calls.failed();
  ASSERT_FALSE(session.modified());
  put("a.talus.json", "by another program");
  paint(session, 3);
  session.apply(action::SaveFile{});
  EXPECT_TRUE(session.question());
  EXPECT_EQ(bytes_of("a.talus.json"), "by another program");
}

}  // namespace talus::write_faults_test
