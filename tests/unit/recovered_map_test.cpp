// Work that is recovered after another program has changed its file.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "ldtk_text.h"
#include "platform/autosave.h"
#include "session/session.h"

namespace talus::recovered_map_test {

namespace act = action;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kChunk = R"(<chunk x="0" y="0" width="2" height="2">1,2,3,4</chunk>)";
constexpr const char* kLeft = R"(<chunk x="-2" y="0" width="2" height="2">1,2,3,4</chunk>)";

std::string layer(const std::string& size, const std::string& name, const std::string& data) {
  return "<layer name=\"" + name + "\" " + size + "><data encoding=\"csv\">" + data + "</data></layer>";
}
std::string map_of(const std::string& more, const std::string& layers) {
  return "<map orientation=\"orthogonal\" tilewidth=\"16\" tileheight=\"16\" width=\"2\" height=\"2\"" +
         more +
         "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"8\" "
         "columns=\"4\"/>" +
         layers + "</map>";
}
std::string infinite(const std::string& chunks) {
  return map_of(R"( infinite="1")", layer(R"(width="2" height="2")", "l", chunks));
}
std::string finite(const std::string& cells) {
  return map_of("", layer(R"(width="2" height="2")", "l", cells));
}

class RecoveredMap : public FolderTest {
 protected:
  // Opens a level, paints a cell like another one, and ends without saving.
  void lose_work(const std::string& name, Cell cell, Cell like, const ImportChoices& choices = {}) {
    auto loaded = load_level(path(name), choices);
    ASSERT_TRUE(loaded) << to_string(loaded.error(), name);
    Session session(std::move(loaded->level), path(name));
    session.apply(act::EditLevel{
        Edit{"Paint", {CellChange{cell, session.level().map.at(cell), session.level().map.at(like)}}}});
    Autosave autosave(path("state"));
    ASSERT_TRUE(autosave.save_now(session));
    auto work = read_saved_work(autosave.own_file());
    ASSERT_TRUE(work) << work.error();
    work_ = *std::move(work);
    autosave.remove();
  }
  void recover() {
    session_.apply(
        act::RecoverLevel{work_.level, work_.path, work_.name, work_.recordings, work_.base, work_.choices});
    session_.finish_reading();
    EXPECT_TRUE(session_.modified());
  }
  void save() { session_.apply(act::SaveFile{}); }
  const Level& level() const { return session_.level(); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }

  SavedWork work_;
  Session session_;
};

TEST_F(RecoveredMap, IsSavedIntoItsFile) {
  put("m.tmx", finite("1,2,3,4"));
  lose_work("m.tmx", {0, 1}, {1, 0});
  recover();
  EXPECT_EQ(message(), "Recovered m.tmx. It is not saved yet; undo goes back to what the file has.");
  save();
  EXPECT_THAT(message(), HasSubstr("Saved"));
  EXPECT_EQ(bytes_of("m.tmx").find("1,2,3,4"), std::string::npos);
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,2,4"));
  session_.apply(act::Undo{});
  save();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,3,4"));
}

TEST_F(RecoveredMap, MovesWithAnInfiniteMap) {
  put("m.tmx", infinite(kChunk));
  lose_work("m.tmx", {0, 1}, {1, 0});
  put("m.tmx", infinite(std::string(kChunk) + kLeft));
  recover();
  EXPECT_THAT(message(), HasSubstr("It has what another program changed in the file since, too."));
  save();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(R"(<chunk x="0" y="0" width="2" height="2">1,2,2,4</chunk>)"));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(kLeft)) << "as Tiled wrote it";
}

TEST_F(RecoveredMap, KeepsWhatAnotherProgramPainted) {
  put("m.tmx", finite("1,2,3,4"));
  lose_work("m.tmx", {0, 1}, {1, 0});
  put("m.tmx", finite("1,2,3,5"));
  recover();
  save();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,2,5"));
}

TEST_F(RecoveredMap, IsAsItWasWhereBothPainted) {
  put("m.tmx", finite("1,2,3,4"));
  lose_work("m.tmx", {0, 1}, {1, 0});
  put("m.tmx", finite("1,2,6,4"));
  recover();
  EXPECT_THAT(message(), HasSubstr("Both changed 1 cell: they are as you had them."));
  const TileNumber like = level().map.tile_at({1, 0});
  EXPECT_EQ(level().map.tile_at({0, 1}), like);
  session_.apply(act::Undo{});
  EXPECT_NE(level().map.tile_at({0, 1}), like) << "undo gives the file's";
}

TEST_F(RecoveredMap, OfOneLayerLeavesTheOthers) {
  const std::string size = R"(width="2" height="2")";
  put("m.tmx", map_of("", layer(size, "a", "1,2,3,4") + layer(size, "b", "5,6,7,8")));
  lose_work("m.tmx", {0, 1}, {1, 0}, {.layer_number = 2});
  recover();
  save();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,3,4")) << message();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("5,6,6,8"));
}

std::string ldtk_of(int left, const std::string& rows) {
  const std::string other = ldtk_level(ldtk_grid(1, 1, "1"), "B", "\"iid\":\"b\",");
  std::string text = ldtk_project(ldtk_level(ldtk_grid(4 + left, 2, rows), "A",
                                             "\"iid\":\"a\",\"worldX\":" + std::to_string(-8 * left) + ",") +
                                      "," + other,
                                  R"({"value":1,"identifier":"wall"})");
  text.insert(1, R"("iid":"p",)");
  return text;
}

TEST_F(RecoveredMap, MovesWithALevelOfLdtkAmongOthers) {
  const ImportChoices of_a{.level = "A"};
  put("g.ldtk", ldtk_of(0, "1,0,0,0,1,1,1,1"));
  lose_work("g.ldtk", {2, 0}, {0, 0}, of_a);
  put("g.ldtk", ldtk_of(2, "0,0,1,0,0,0,0,0,1,1,1,1"));
  recover();
  const TileNumber wall = level().map.tile_at({2, 0});
  EXPECT_THAT(level().map.cells().tiles(), ElementsAre(0, 0, wall, 0, wall, 0, 0, 0, wall, wall, wall, wall));
  EXPECT_NE(wall, 0);
  save();
  EXPECT_EQ(load_level(path("g.ldtk"), of_a)->level, level()) << message();
}

TEST_F(RecoveredMap, WithADamagedBaseIsThatOfTheFileAlone) {
  put("m.tmx", finite("1,2,3,4"));
  lose_work("m.tmx", {0, 1}, {1, 0});
  SavedWork work = work_;
  work.file = path("work");
  ASSERT_TRUE(write_saved_work(work));
  std::string text = bytes_of("work");
  const std::size_t at = text.find("\"talus\"");
  ASSERT_NE(at, text.npos);
  text[at] = '?';  // of the base, which comes first
  put("work", text);
  const auto read = read_saved_work(path("work"));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->base, nullptr);
  EXPECT_EQ(*read->level, *work_.level);
  const std::size_t size = text.find("\"base_bytes\":") + 13;
  put("work", text.insert(size, "99999999"));
  EXPECT_FALSE(read_saved_work(path("work")));
}

}  // namespace talus::recovered_map_test
