// What is in the place of a level's files, and is not theirs.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "folder_test.h"
#include "ldtk_text.h"
#include "session/session.h"

namespace talus::place_taken_test {

namespace fs = std::filesystem;
namespace act = action;
using testing::HasSubstr;

std::string map_with(const std::string& source) {
  return R"(<map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">)"
         R"(<tileset firstgid="1" source=")" +
         source + R"("/><layer name="l" width="2" height="1"><data encoding="csv">1,2</data></layer></map>)";
}
constexpr const char* kTileset =
    R"(<tileset name="t" tilewidth="8" tileheight="8" tilecount="4" columns="2"></tileset>)";

class PlaceTaken : public FolderTest {
 protected:
  void open(const std::string& name) {
    session_.apply(act::OpenFile{path(name)});
    if (session_.level_import()) session_.apply(act::ApplyLevelImport{});
  }
  void paint(Cell cell, TileNumber tile) {
    const TileNumber before = session_.level().map.tile_at(cell);
    session_.apply(act::EditLevel{Edit{"Paint", {CellChange{cell, before, tile}}}});
  }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }
  std::string question() const { return session_.question() ? session_.question()->text : ""; }
  void save_through_link(const std::string& from, const std::string& to);

  Session session_;
};

TEST_F(PlaceTaken, ATilesetCannotHaveTheCompanionsName) {
  put("m.tmx", map_with("m.tmx.talus.json"));
  for (const bool is_there : {false, true}) {
    if (is_there) put("m.tmx.talus.json", kTileset);
    const auto loaded = load_level(path("m.tmx"));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().message,
              "names m.tmx.talus.json, which is the name of its own companion: give that file another name");
  }
  put("other.tmx", map_with("m.tmx.talus.json"));
  auto other = load_level(path("other.tmx"));
  ASSERT_TRUE(other);
  EXPECT_FALSE(save_level(other->level, *other->format, path("m.tmx"), other->companion));
  EXPECT_EQ(bytes_of("m.tmx.talus.json"), kTileset);
}

TEST_F(PlaceTaken, ADamagedCompanionOfLdtkIsKeptAside) {
  std::string text = ldtk_project(ldtk_level(ldtk_grid(4, 2, "1,0,0,0,1,1,1,1"), "A", R"("iid":"a",)"),
                                  R"({"value":1,"identifier":"wall"})");
  text.insert(1, R"("iid":"p",)");
  put("g.ldtk", text);
  for (const char* const damaged :
       {R"({"talus":5,"companion":{)", R"({"talus":5,"companion":{"project":"p"},"levels":[]})",
        R"({"talus":999,"companion":{"project":"p"}})", R"({"talus":5,"compan)", "{", "", "\xff", "[]"}) {
    put("g.talus.json", damaged);
    auto loaded = load_level(path("g.ldtk"));
    ASSERT_TRUE(loaded);
    EXPECT_THAT(loaded->note, HasSubstr("g.talus.json is left as it is, and not read: ")) << damaged;
    loaded->level.map.set({1, 0}, loaded->level.map.tile_at({0, 0}));
    const auto saved = save_level(loaded->level, *loaded->format, path("g.ldtk"), loaded->companion);
    ASSERT_TRUE(saved) << to_string(saved.error(), "g.ldtk");
    EXPECT_THAT(saved->note, HasSubstr("What was there before is kept as g.talus-kept"));
    EXPECT_EQ(load_level(path("g.ldtk"))->level, loaded->level);
  }
  EXPECT_EQ(bytes_of("g.talus-kept1.json"), R"({"talus":5,"companion":{)");
}

TEST_F(PlaceTaken, ADanglingLinkIsAskedAbout) {
  put("t.tsx", kTileset);
  put("m.tmx", map_with("t.tsx"));
  open("m.tmx");
  paint({0, 0}, session_.level().map.tile_at({1, 0}));
  fs::remove(path("m.tmx"));
  fs::create_symlink("elsewhere.tmx", path("m.tmx"));
  session_.apply(act::CheckFile{});
  session_.apply(act::SaveFile{});
  EXPECT_THAT(question(), HasSubstr("m.tmx is a link now, which leads to " + path("elsewhere.tmx")));
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  EXPECT_FALSE(exists("elsewhere.tmx"));
  session_.apply(act::SaveFile{});
  session_.apply(act::AnswerQuestion{act::Answer::replace});
  EXPECT_THAT(bytes_of("elsewhere.tmx"), HasSubstr("2,2"));
}

TEST_F(PlaceTaken, ALinkToAnotherFileIsNamedInTheQuestion) {
  put("t.tsx", kTileset);
  put("notes.txt", "mine");
  put("m.tmx", map_with("t.tsx"));
  open("m.tmx");
  paint({0, 0}, session_.level().map.tile_at({1, 0}));
  fs::remove(path("m.tmx"));
  fs::create_symlink("notes.txt", path("m.tmx"));
  session_.apply(act::SaveFile{});
  EXPECT_THAT(question(), HasSubstr("m.tmx is a link to " + path("notes.txt") + ", where saving writes."))
      << message();
  EXPECT_EQ(bytes_of("notes.txt"), "mine");
}

TEST_F(PlaceTaken, ASplitHardLinkIsReported) {
  put("t.tsx", kTileset);
  put("m.tmx", map_with("t.tsx"));
  fs::create_hard_link(path("m.tmx"), path("backup.tmx"));
  fs::create_hard_link(path("t.tsx"), path("shared.tsx"));
  auto loaded = load_level(path("m.tmx"));
  ASSERT_TRUE(loaded);
  Level& level = loaded->level;
  level.map.set({0, 0}, level.map.tile_at({1, 0}));
  level.tile_shapes[static_cast<std::size_t>(level.map.tile_at({1, 0}))] = {.kind = TileShape::Kind::solid};
  const auto saved = save_level(level, *loaded->format, path("m.tmx"), loaded->companion);
  ASSERT_TRUE(saved) << to_string(saved.error(), "m.tmx");
  EXPECT_EQ(saved->note,
            "t.tsx had other names, hard links, which keep what it was before. "
            "m.tmx had other names, hard links, which keep what it was before");
  EXPECT_EQ(bytes_of("shared.tsx"), kTileset);
}

// Saves, and expects the question about a link from one file of the folder to another; declines, and allows.
void PlaceTaken::save_through_link(const std::string& from, const std::string& to) {
  const std::string before = bytes_of(to);
  session_.apply(act::SaveFile{});
  ASSERT_TRUE(session_.question()) << message();
  EXPECT_THAT(question(), HasSubstr(from + " is a link now, which leads to " + path(to) + "."));
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  EXPECT_EQ(bytes_of(to), before);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of(to), before);
  session_.apply(act::AnswerQuestion{act::Answer::replace});
  EXPECT_NE(bytes_of(to), before) << message();
  EXPECT_EQ(question(), "");
}

TEST_F(PlaceTaken, ALinkToEqualBytesIsAskedAbout) {
  put("t.tsx", kTileset);
  put("m.tmx", map_with("t.tsx"));
  put("other.tmx", bytes_of("m.tmx"));
  open("m.tmx");
  paint({0, 0}, session_.level().map.tile_at({1, 0}));
  fs::remove(path("m.tmx"));
  fs::create_symlink("other.tmx", path("m.tmx"));
  session_.apply(act::CheckFile{});
  save_through_link("m.tmx", "other.tmx");
  EXPECT_THAT(bytes_of("other.tmx"), HasSubstr("2,2"));
  paint({1, 0}, 0);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(question(), "") << "it is asked once";
}

TEST_F(PlaceTaken, ALinkToAnotherMapIsAskedAbout) {
  put("t.tsx", kTileset);
  put("m.tmx", map_with("t.tsx"));
  std::string other = map_with("t.tsx");
  other.replace(other.find(">1,2<"), 5, ">4,4<");
  put("other.tmx", other);
  open("m.tmx");
  paint({0, 0}, session_.level().map.tile_at({1, 0}));
  const Level painted = session_.level();
  fs::remove(path("m.tmx"));
  fs::create_symlink("other.tmx", path("m.tmx"));
  session_.apply(act::CheckFile{});
  EXPECT_THAT(question(), HasSubstr("m.tmx is a link to " + path("other.tmx") + ", where saving writes."));
  EXPECT_EQ(session_.level(), painted) << "it is not read unasked";
  EXPECT_EQ(bytes_of("other.tmx"), other);
}

TEST_F(PlaceTaken, ALinkInPlaceOfATilesetIsAskedAbout) {
  put("t.tsx", kTileset);
  put("m.tmx", map_with("t.tsx"));
  put("other.tsx", kTileset);
  open("m.tmx");
  auto made = std::make_shared<Level>(session_.level());
  made->tile_shapes[made->map.tile_at({1, 0})] = {.kind = TileShape::Kind::solid};
  session_.apply(act::EditLevel{replace_by(session_.level(), made, "Edit the tile")});
  fs::remove(path("t.tsx"));
  fs::create_symlink("other.tsx", path("t.tsx"));
  session_.apply(act::CheckFile{});
  save_through_link("t.tsx", "other.tsx");
}

// Only root may give a file away, so the test as another user holds less.
TEST_F(PlaceTaken, AFileKeepsItsOwnerAndItsMode) {
  constexpr uid_t kOther = 12345;
  const std::string file = put("a.txt", "old");
  const bool is_root = ::geteuid() == 0;
  ASSERT_EQ(::chown(file.c_str(), is_root ? kOther : ::geteuid(), is_root ? kOther : ::getegid()), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0664), 0);
  ASSERT_TRUE(write_file_atomic(file, "new"));
  struct stat now = {};
  ASSERT_EQ(::stat(file.c_str(), &now), 0);
  EXPECT_EQ(now.st_uid, is_root ? kOther : ::geteuid());
  EXPECT_EQ(now.st_gid, is_root ? kOther : ::getegid());
  EXPECT_EQ(now.st_mode & 07777, 0664U);
}

}  // namespace talus::place_taken_test
