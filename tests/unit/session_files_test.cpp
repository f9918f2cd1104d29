// Session: opening, saving, and the questions before changes are lost. The tests work on real files.
#include <gtest/gtest.h>

#include "edit/level_settings.h"
#include "edit/map_stroke.h"
#include "folder_test.h"
#include "formats/tic80/tic_cart.h"
#include "png_bytes.h"
#include "session/session.h"

namespace talus::session_files_test {

namespace act = action;
namespace fs = std::filesystem;

class SessionFiles : public FolderTest {
 protected:
  // Paints the level's tile (1, 1), so that the session is modified.
  void paint(TileNumber tile) {
    session_.apply(act::EditLevel{paint_stamp(session_.level(), {1, 1}, {1, 1, {tile}}), 0});
  }
  // Writes another level, whose tile at (1, 1) is `tile`. Returns the path.
  std::string other_file(const std::string& name, TileNumber tile) {
    Level level;
    level.map.set({1, 1}, tile);
    EXPECT_TRUE(save_level(level, *format_for_file(name), path(name)));
    return path(name);
  }
  int painted() const { return session_.level().map.tile_at({1, 1}); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }

  Session session_;
};

TEST_F(SessionFiles, SaveAsTakesTheNameAndTheFormatOfItsExtension) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.talus.json")});
  EXPECT_EQ(session_.file_name(), "a.talus.json");
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(message(), "Saved a.talus.json.");
  EXPECT_FALSE(session_.message()->is_error);
  const auto loaded = load_level(path("a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->level == session_.level());
}

TEST_F(SessionFiles, SaveWritesToTheSameFile) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.tic")});
  paint(6);
  EXPECT_TRUE(session_.modified());
  session_.apply(act::SaveFile{});
  EXPECT_FALSE(session_.modified());
  EXPECT_FALSE(session_.wants_save_as());
  EXPECT_EQ(load_level(path("a.tic"))->level.map.at({1, 1}), 6);
}

TEST_F(SessionFiles, HistorySurvivesSaving) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.tic")});
  session_.apply(act::Undo{});
  EXPECT_EQ(painted(), 0);
  EXPECT_TRUE(session_.modified()) << "the file has the tile";
  session_.apply(act::Redo{});
  EXPECT_FALSE(session_.modified());
}

TEST_F(SessionFiles, SaveAsWithAnUnknownExtensionNamesTheKnownOnes) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.xyz")});
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_TRUE(message().starts_with("Cannot save a.xyz: ")) << message();
  EXPECT_NE(message().find(".tic"), std::string::npos) << message();
  EXPECT_NE(message().find(".talus.json"), std::string::npos) << message();
  EXPECT_FALSE(exists("a.xyz"));
  EXPECT_TRUE(session_.modified());
}

TEST_F(SessionFiles, SaveThatFailsKeepsTheNameAndTheChanges) {
  paint(5);
  session_.apply(act::SaveFileAs{path("missing/a.tic")});
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_EQ(session_.path(), "");
  EXPECT_TRUE(session_.modified());
}

TEST_F(SessionFiles, SaveOfAnUnnamedLevelAsksForAName) {
  paint(5);
  session_.apply(act::SaveFile{});
  EXPECT_TRUE(session_.wants_save_as());
  session_.apply(act::CancelSaveAs{});
  EXPECT_FALSE(session_.wants_save_as());
  session_.apply(act::SaveFile{});
  session_.apply(act::SaveFileAs{path("a.tic")});
  EXPECT_FALSE(session_.wants_save_as());
  EXPECT_TRUE(exists("a.tic"));
}

TEST_F(SessionFiles, OpenReplacesTheLevelAndStopsPlay) {
  const std::string cart = other_file("b.tic", 9);
  session_.apply({act::Play{}, act::SetGrid{false}});
  session_.advance(0.5);
  session_.apply(act::OpenFile{cart});
  EXPECT_EQ(painted(), 9);
  EXPECT_EQ(session_.path(), cart);
  EXPECT_FALSE(session_.modified());
  EXPECT_TRUE(session_.history().edits().empty());
  EXPECT_FALSE(session_.playback().running);
  EXPECT_EQ(session_.state().frame, 0);
  EXPECT_EQ(session_.scene(), compile_scene(session_.level()));
  EXPECT_EQ(session_.choices().body, 0);
  EXPECT_FALSE(session_.choices().grid) << "how things are shown is the user's, not the level's";
}

TEST_F(SessionFiles, AnUntouchedCartIsSavedByteForByte) {
  const std::string cart = other_file("b.tic", 9);
  const std::string before = bytes_of(cart);
  session_.apply({act::OpenFile{cart}, act::SaveFile{}});
  EXPECT_EQ(message(), "Saved b.tic.");
  EXPECT_EQ(bytes_of(cart), before);
}

TEST_F(SessionFiles, SaveKeepsTheFormatOfTheContent) {
  const std::string cart = path("cart.bin");
  fs::rename(other_file("b.talus.json", 9), cart);
  session_.apply(act::OpenFile{cart});
  ASSERT_EQ(painted(), 9) << message();
  paint(8);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved cart.bin.");
  EXPECT_EQ(load_level(cart)->level.map.at({1, 1}), 8);
}

// A picture can only be read: saving must not replace it by a cart.
TEST_F(SessionFiles, APngCartBecomesALevelWithoutAFile) {
  other_file("a.tic", 7);
  const std::string picture = rgb_png(1, {{1, 2, 3}});
  const std::string png = picture.substr(0, picture.size() - 12) +
                          png_chunk("caRt", zipped(bytes_of("a.tic"))) + png_chunk("IEND", "");
  put("cart.png", png);
  session_.apply(act::OpenFile{path("cart.png")});
  EXPECT_EQ(painted(), 7);
  EXPECT_EQ(session_.file_name(), "cart.png");
  EXPECT_EQ(session_.path(), "");
  EXPECT_FALSE(session_.modified());
  session_.apply(act::SaveFile{});
  EXPECT_TRUE(session_.wants_save_as());
  session_.apply(act::SaveFileAs{path("cart.png")});
  EXPECT_EQ(message().substr(0, 62), "Cannot save cart.png: its extension must be one of .talus.json");
  EXPECT_EQ(bytes_of("cart.png"), png);
  session_.apply(act::SaveFileAs{path("b.tic")});
  EXPECT_EQ(bytes_of("b.tic"), bytes_of("a.tic"));
  session_.apply(act::CheckFile{});
  EXPECT_EQ(message(), "Saved b.tic.");
}

TEST_F(SessionFiles, AFileThatCannotBeReadLeavesTheLevelAlone) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.tic")});
  put("bad.talus.json", "{ nonsense");
  session_.apply(act::OpenFile{path("bad.talus.json")});
  ASSERT_TRUE(session_.message());
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_EQ(message(), to_string(load_level(path("bad.talus.json")).error(), path("bad.talus.json")));
  EXPECT_EQ(painted(), 5);
  EXPECT_EQ(session_.file_name(), "a.tic");
  EXPECT_EQ(session_.history().edits().size(), 1u);
}

TEST_F(SessionFiles, AMissingFileIsAnError) {
  session_.apply(act::OpenFile{path("missing.tic")});
  ASSERT_TRUE(session_.message());
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_TRUE(message().starts_with(path("missing.tic"))) << message();
}

TEST_F(SessionFiles, OpeningClearsAnOldError) {
  session_.apply(act::OpenFile{path("missing.tic")});
  session_.apply(act::OpenFile{other_file("b.tic", 9)});
  EXPECT_FALSE(session_.message());
}

TEST_F(SessionFiles, UnsavedChangesAreAskedAbout) {
  paint(5);
  session_.apply(act::SaveFileAs{path("a.tic")});
  const std::string cart = other_file("b.tic", 9);
  paint(6);
  for (const Action& losing : std::vector<Action>{act::OpenFile{cart}, act::NewLevel{}, act::Quit{}}) {
    session_.apply(losing);
    ASSERT_TRUE(session_.question());
    EXPECT_EQ(session_.question()->text, "Save the changes to a.tic?");
    EXPECT_FALSE(session_.wants_quit());
    EXPECT_EQ(painted(), 6);
    session_.apply(act::AnswerQuestion{act::Answer::cancel});
    EXPECT_FALSE(session_.question());
    EXPECT_EQ(painted(), 6);
    EXPECT_FALSE(session_.wants_quit());
  }
}

TEST_F(SessionFiles, NothingIsAskedWithoutChanges) {
  session_.apply(act::Quit{});
  EXPECT_FALSE(session_.question());
  EXPECT_TRUE(session_.wants_quit());
}

TEST_F(SessionFiles, DiscardGoesOnWithoutSaving) {
  paint(5);
  session_.apply({act::OpenFile{other_file("b.tic", 9)}, act::AnswerQuestion{act::Answer::discard}});
  EXPECT_EQ(painted(), 9);
  EXPECT_FALSE(session_.question());
}

TEST_F(SessionFiles, SaveGoesOnAfterSaving) {
  session_.apply(act::SaveFileAs{path("a.tic")});
  paint(5);
  session_.apply({act::NewLevel{}, act::AnswerQuestion{act::Answer::save}});
  EXPECT_EQ(painted(), 0);
  EXPECT_EQ(session_.file_name(), "untitled");
  EXPECT_EQ(load_level(path("a.tic"))->level.map.at({1, 1}), 5);
  EXPECT_EQ(message(), "Saved a.tic.") << "also tells what was dropped";
}

TEST_F(SessionFiles, SaveOfAnUnnamedLevelGoesOnAfterItsName) {
  paint(5);
  session_.apply({act::Quit{}, act::AnswerQuestion{act::Answer::save}});
  EXPECT_TRUE(session_.wants_save_as());
  EXPECT_FALSE(session_.wants_quit());
  session_.apply(act::SaveFileAs{path("a.xyz")});
  EXPECT_TRUE(session_.wants_save_as()) << "it asks for another name";
  session_.apply(act::SaveFileAs{path("a.tic")});
  EXPECT_FALSE(session_.wants_save_as());
  EXPECT_TRUE(session_.wants_quit());
}

TEST_F(SessionFiles, CancellingTheNameCancelsTheNextStep) {
  paint(5);
  session_.apply({act::Quit{}, act::AnswerQuestion{act::Answer::save}, act::CancelSaveAs{}});
  EXPECT_FALSE(session_.wants_save_as());
  session_.apply(act::SaveFileAs{path("a.tic")});
  EXPECT_FALSE(session_.wants_quit());
}

TEST_F(SessionFiles, AFailedSaveCancelsTheNextStep) {
  session_.apply(act::SaveFileAs{path("a.tic")});
  paint(5);
  fs::remove_all(folder_);
  session_.apply({act::Quit{}, act::AnswerQuestion{act::Answer::save}});
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_FALSE(session_.wants_quit());
  EXPECT_FALSE(session_.question());
  EXPECT_TRUE(session_.modified());
}

TEST_F(SessionFiles, AnAnswerWithoutAQuestionDoesNothing) {
  paint(5);
  session_.apply(act::AnswerQuestion{act::Answer::discard});
  EXPECT_EQ(painted(), 5);
  EXPECT_TRUE(session_.modified());
}

// A companion holds what the cart cannot.
class SessionCompanions : public SessionFiles {
 protected:
  void place(std::size_t spawns) {
    session_.apply(
        act::EditLevel{set_spawns(session_.level(), std::vector<Spawn>(spawns), "Place spawns"), 0});
  }
  std::size_t placed() const { return session_.level().spawns.size(); }
};

TEST_F(SessionCompanions, AreSavedAndOpenedWithoutAMessage) {
  for (const std::string name : {"a.tic", "a.lua", "a.yue", "a.js"}) {
    session_.apply({act::NewLevel{}, act::AnswerQuestion{act::Answer::discard}});
    paint(5);
    place(2);
    session_.apply(act::SaveFileAs{path(name)});
    const std::string both = name + " + " + name + ".talus.json";
    EXPECT_EQ(message(), "Saved " + both + ".");
    EXPECT_EQ(session_.file_names(), both);
    EXPECT_EQ(session_.file_name(), name);
    EXPECT_FALSE(session_.modified());
    const Level saved = session_.level();
    session_.apply({act::NewLevel{}, act::DismissMessage{}});
    EXPECT_EQ(session_.file_names(), "untitled");
    session_.apply(act::OpenFile{path(name)});
    EXPECT_EQ(session_.level().spawns, saved.spawns);
    EXPECT_EQ(session_.file_names(), both);
    EXPECT_EQ(message(), "");
    EXPECT_FALSE(session_.modified());
    session_.apply(act::CheckFile{});
    EXPECT_EQ(message(), "");
  }
}

TEST_F(SessionCompanions, AreRemovedWhenTheyAreNoLongerNeeded) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  EXPECT_TRUE(exists("a.tic.talus.json"));
  place(0);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved a.tic.");
  EXPECT_FALSE(exists("a.tic.talus.json"));
  EXPECT_EQ(session_.file_names(), "a.tic");
  session_.apply({act::Undo{}, act::SaveFile{}});
  EXPECT_TRUE(exists("a.tic.talus.json"));
  EXPECT_FALSE(exists("a.tic.talus-kept1.json")) << "nobody else has written there";
}

TEST_F(SessionCompanions, AreOpenedByTheirOwnName) {
  paint(5);
  place(1);
  session_.apply({act::SaveFileAs{path("a.tic")}, act::NewLevel{}, act::OpenFile{path("a.tic.talus.json")}});
  EXPECT_EQ(session_.path(), path("a.tic"));
  EXPECT_EQ(placed(), 1u);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved a.tic + a.tic.talus.json.");
}

TEST_F(SessionCompanions, ChangedByAnotherProgramAreReadAgain) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  Level other = session_.level();
  other.spawns.resize(3);
  const auto loaded = load_level(path("a.tic"));
  ASSERT_TRUE(save_level(other, *find_format("tic"), path("a.tic"), loaded->companion));
  session_.apply(act::CheckFile{});
  EXPECT_EQ(placed(), 3u);
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(message(),
            "Read a.tic + a.tic.talus.json again, as another program changed it. Undo takes that back.");
  session_.apply(act::Undo{});
  EXPECT_EQ(placed(), 1u);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(load_level(path("a.tic"))->level.spawns.size(), 1u);
  EXPECT_FALSE(exists("a.tic.talus-kept1.json")) << "it was read";
}

TEST_F(SessionCompanions, ChangedByAnotherProgramAreAskedAboutAndKept) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  place(2);
  put("a.tic.talus.json", "mine");
  session_.apply(act::SaveFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_TRUE(session_.question()->text.starts_with("a.tic.talus.json was changed by another program."))
      << session_.question()->text;
  session_.apply({act::AnswerQuestion{act::Answer::keep}, act::SaveFile{}});
  EXPECT_EQ(message(),
            "Saved a.tic + a.tic.talus.json. a.tic.talus.json held something else, which is kept as "
            "a.tic.talus-kept1.json.");
  EXPECT_EQ(bytes_of("a.tic.talus-kept1.json"), "mine");
  EXPECT_EQ(load_level(path("a.tic"))->level.spawns.size(), 2u);
}

TEST_F(SessionCompanions, RemovedOnesAreWrittenAgain) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  fs::remove(path("a.tic.talus.json"));
  session_.apply(act::CheckFile{});
  EXPECT_EQ(message(), "a.tic.talus.json was removed or renamed by another program. Saving writes it again.");
  EXPECT_EQ(placed(), 1u);
  EXPECT_TRUE(session_.modified());
  session_.apply({act::DismissMessage{}, act::CheckFile{}});
  EXPECT_EQ(message(), "") << "the change is reported only once";
  session_.apply(act::SaveFile{});
  EXPECT_TRUE(exists("a.tic.talus.json"));
}

TEST_F(SessionCompanions, BrokenByAnotherProgramDeleteNothing) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  put("a.tic.talus.json", "{");
  for (int i = 0; i < 4; ++i) session_.apply(act::CheckFile{});
  EXPECT_EQ(placed(), 1u);
  EXPECT_TRUE(session_.modified());
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_TRUE(
      message().starts_with("Another program changed what goes with a.tic, so the level stays as it is "
                            "here. a.tic.talus.json is left as it is, and not read: "))
      << message();
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("a.tic.talus-kept1.json"), "{");
  EXPECT_EQ(load_level(path("a.tic"))->level.spawns.size(), 1u);
}

TEST_F(SessionCompanions, OfACartSavedByTic80AreKept) {
  paint(5);
  place(2);
  session_.apply(act::SaveFileAs{path("a.tic")});
  const Format& tic = *find_format("tic");
  Level cart = tic.read(bytes_of("a.tic"), {}).value();
  cart.map.set({1, 1}, 9);
  put("a.tic", tic.write(cart, {})->bytes);
  session_.apply(act::CheckFile{});
  EXPECT_EQ(painted(), 9);
  EXPECT_EQ(placed(), 2u);
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(
      message(),
      "Read a.tic + a.tic.talus.json again, as another program changed it. Undo takes that back. a.tic was "
      "changed since a.tic.talus.json was saved with it (map); all that was added is kept.");
  session_.apply({act::SaveFile{}, act::NewLevel{}, act::DismissMessage{}, act::OpenFile{path("a.tic")}});
  EXPECT_EQ(message(), "") << "they fit again";
}

TEST_F(SessionCompanions, StayWithALevelThatIsRecovered) {
  paint(5);
  place(1);
  session_.apply(act::SaveFileAs{path("a.tic")});
  place(2);
  const auto work = std::make_shared<const Level>(session_.level());
  Session after_crash;
  after_crash.apply(act::RecoverLevel{work, path("a.tic"), "a.tic"});
  EXPECT_EQ(after_crash.level().spawns.size(), 2u);
  EXPECT_EQ(after_crash.file_names(), "a.tic + a.tic.talus.json");
  after_crash.apply(act::SaveFile{});
  EXPECT_EQ(after_crash.message()->text, "Saved a.tic + a.tic.talus.json.");
  EXPECT_EQ(load_level(path("a.tic"))->level.spawns.size(), 2u);
}

TEST_F(SessionCompanions, BrokenOnesAreReported) {
  const std::string cart = other_file("a.tic", 9);
  put("a.tic.talus.json", "{");
  session_.apply(act::OpenFile{cart});
  EXPECT_EQ(painted(), 9);
  EXPECT_TRUE(message().starts_with("a.tic.talus.json is left as it is, and not read: ")) << message();
  EXPECT_EQ(session_.file_names(), "a.tic");
}

TEST_F(SessionCompanions, ComeFromAPngCartWithItsNewName) {
  other_file("a.tic", 7);
  const std::string picture = rgb_png(1, {{1, 2, 3}});
  put("cart.png", picture.substr(0, picture.size() - 12) + png_chunk("caRt", zipped(bytes_of("a.tic"))) +
                      png_chunk("IEND", ""));
  Level drawn = *read_tic(bytes_of("a.tic"), {});
  drawn.flag_names[0] = "wall";
  ASSERT_TRUE(save_level(drawn, *find_format("tic"), path("cart.png.tic")));
  fs::rename(path("cart.png.tic.talus.json"), path("cart.png.talus.json"));
  session_.apply(act::OpenFile{path("cart.png")});
  EXPECT_EQ(session_.level().flag_names[0], "wall") << "one that was put beside the picture counts";
  place(2);
  session_.apply({act::SaveFile{}, act::SaveFileAs{path("cart.tic")}});
  session_.apply({act::NewLevel{}, act::OpenFile{path("cart.tic")}});
  EXPECT_EQ(placed(), 2u);
  EXPECT_EQ(painted(), 7);
}

// A cartridge can hold bytes that no text project can hold, and that are no part of a level either.
TEST_F(SessionCompanions, DoNotHoldOtherChunksSoQuittingAsks) {
  other_file("a.tic", 7);
  put("a.tic", bytes_of("a.tic") + std::string("\x13\x01\0\0b", 5));
  session_.apply({act::OpenFile{path("a.tic")}, act::SaveFileAs{path("a.lua")}});
  EXPECT_EQ(message(), "Saved a.lua. Not stored in this format: the BINARY chunk of bank 0.");
  EXPECT_TRUE(session_.modified());
  session_.apply(act::Quit{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unstored);
  EXPECT_EQ(session_.question()->text,
            "a.lua cannot hold all of this level. Not in it: the BINARY chunk of bank 0.\n"
            "A level of Talus, .talus.json, holds everything.");
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  EXPECT_FALSE(session_.wants_quit());
  // Quitting asks after saving too, which stores no more than before.
  paint(3);
  session_.apply({act::Quit{}, act::AnswerQuestion{act::Answer::save}});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unstored);
  session_.apply(act::AnswerQuestion{act::Answer::save});
  EXPECT_TRUE(session_.wants_save_as());
  session_.apply(act::SaveFileAs{path("a.talus.json")});
  EXPECT_TRUE(session_.wants_quit());
  EXPECT_FALSE(session_.modified());
}

}  // namespace talus::session_files_test
