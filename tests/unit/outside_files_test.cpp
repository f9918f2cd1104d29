// Maps that name files outside of their folder: the window asks, the command line has an option.
#include <gmock/gmock.h>

#include "cli_answer.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "png_bytes.h"
#include "session/files/read_permissions.h"
#include "session/session.h"

namespace talus::outside_files_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class OutsideFiles : public FolderTest {
 protected:
  // A map whose tileset, and that one's picture, lie beside the folder of the map.
  OutsideFiles() {
    for (const char* folder : {"game/maps", "game/sets", "game/art"}) fs::create_directories(path(folder));
    put("game/art/t.png", rgb_png(8, std::vector<Rgb>(64, Rgb{200, 0, 0})));
    put("game/sets/t.tsx", R"(<tileset name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1">)"
                           R"(<image source="../art/t.png" width="8" height="8"/></tileset>)");
    put("game/maps/a.tmx", map_with("../sets/t.tsx"));
  }
  static std::string map_with(const std::string& tileset) {
    return R"(<map version="1.10" orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)"
           R"(<tileset firstgid="1" source=")" +
           tileset +
           R"("/><layer id="1" name="l" width="1" height="1"><data encoding="csv">1</data></layer></map>)";
  }
  ExportTools tools() const { return {.read_asset = {}, .reads = path("state/reads")}; }
  std::string game() const { return fs::canonical(path("game")).string(); }
  static Rgb corner(const Session& session) {
    const SheetPicture* const picture = session.level().sheet(SheetId::tiles).picture.get();
    const TileNumber tile = session.level().map.tile_at({0, 0});
    const Cell place = session.level().sheet(SheetId::tiles).layout().place_of(tile);
    if (picture == nullptr) {
      const auto color = session.level().sheet(SheetId::tiles).images[tile][0];
      return session.level().palette[color];
    }
    const std::uint8_t* pixel = picture->at(8 * place.x, 8 * place.y);
    return {pixel[0], pixel[1], pixel[2]};
  }
};
const Rgb kRed{200, 0, 0};

TEST_F(OutsideFiles, AreReadAfterOneQuestion) {
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/a.tmx")});
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::read_outside);
  EXPECT_EQ(session.question()->text,
            "a.tmx names 1 file outside of its folder:\n../sets/t.tsx (" + game() +
                "/sets/t.tsx)\nRead it? All maps in the folder of a.tmx may then read files in " + game() +
                ".\nSaving writes a tileset among them once flags or shapes of its tiles are edited.");
  EXPECT_EQ(session.path(), "") << "the level before stays open";
  session.apply(action::AnswerQuestion{action::Answer::allow});
  EXPECT_FALSE(session.question()) << "the picture that the tileset names is in the same folder";
  EXPECT_EQ(session.path(), path("game/maps/a.tmx"));
  EXPECT_EQ(corner(session), kRed);
  // Other maps beside it, also in later starts.
  put("game/maps/b.tmx", map_with("../sets/t.tsx"));
  Session later(Level(), "", kUnnamed, tools());
  later.apply(action::OpenFile{path("game/maps/b.tmx")});
  EXPECT_FALSE(later.question());
  EXPECT_EQ(corner(later), kRed);
  // But not what lies elsewhere.
  put("secret.tsx", "<tileset/>");
  put("game/maps/c.tmx", map_with("../../secret.tsx"));
  later.apply(action::OpenFile{path("game/maps/c.tmx")});
  ASSERT_TRUE(later.question());
  EXPECT_THAT(later.question()->text, HasSubstr("../../secret.tsx"));
}

TEST_F(OutsideFiles, AreWrittenWithFlagsAndShapesOfTheirTiles) {
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/a.tmx")});
  session.apply(action::AnswerQuestion{action::Answer::allow});
  session.apply(action::DismissMessage{});
  auto made = std::make_shared<Level>(session.level());
  const TileNumber tile = made->map.tile_at({0, 0});
  made->tile_shapes[tile] = {.kind = TileShape::Kind::solid};
  made->sheet(SheetId::tiles).flags[tile] |= 2;
  session.apply(action::EditLevel{replace_by(session.level(), made, "Edit the tile")});
  session.apply(action::SaveFile{});
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text, "Saved a.tmx + " + game() + "/sets/t.tsx.");
  EXPECT_THAT(bytes_of("game/sets/t.tsx"), HasSubstr("<objectgroup"));
  EXPECT_FALSE(exists("game/maps/a.tmx.talus.json")) << bytes_of("game/maps/a.tmx.talus.json");
  Session later(Level(), "", kUnnamed, tools());
  later.apply(action::OpenFile{path("game/maps/a.tmx")});
  EXPECT_EQ(later.level().tile_shapes, session.level().tile_shapes);
  EXPECT_EQ(later.level().tile_flags(tile), session.level().tile_flags(tile));
}

TEST_F(OutsideFiles, ThatAreNotReadLeaveNumberedBoxes) {
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/a.tmx")});
  session.apply(action::AnswerQuestion{action::Answer::cancel});
  EXPECT_EQ(session.path(), path("game/maps/a.tmx"));
  ASSERT_TRUE(session.message());
  EXPECT_THAT(session.message()->text, HasSubstr("../sets/t.tsx: lies outside of the folder of the map"));
  EXPECT_NE(corner(session), kRed);
  // Nobody looks at them, also not when the map changes.
  put("game/sets/t.tsx", "changed");
  session.apply(action::CheckFile{});
  session.finish_reading();
  EXPECT_FALSE(session.question());
  put("game/maps/a.tmx", map_with("../sets/t.tsx") + "\n");
  session.apply(action::CheckFile{});
  session.finish_reading();
  EXPECT_FALSE(session.question()) << "it was answered";
  EXPECT_NE(corner(session), kRed);
  session.apply(action::OpenFile{path("game/maps/a.tmx")});
  EXPECT_TRUE(session.question()) << "opening asks again";
}

TEST_F(OutsideFiles, OfANativeLevelAreAskedAboutToo) {
  put("game/maps/a.talus.json", R"({"talus": 5, "sheet_size": [4, 4], "tilesets":
      [{"first": 0, "count": 4, "columns": 4, "image": "../art/t.png", "tile_size": [8, 8]}]})");
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/a.talus.json")});
  ASSERT_TRUE(session.question());
  EXPECT_THAT(session.question()->text, HasSubstr("../art/t.png"));
  session.apply(action::AnswerQuestion{action::Answer::allow});
  EXPECT_EQ(session.path(), path("game/maps/a.talus.json"));
  EXPECT_FALSE(session.level().tilesets.at(0).link->is_missing);
}

TEST_F(OutsideFiles, OfAMapThatAnotherProgramChangesAreAskedAbout) {
  put("game/maps/a.tmx", R"(<map orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)"
                         R"(<layer id="1" name="l"><data encoding="csv">0</data></layer></map>)");
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/a.tmx")});
  ASSERT_FALSE(session.question());
  put("game/maps/a.tmx", map_with("../sets/t.tsx"));
  for (int i = 0; i < 8 && !session.question(); ++i) {
    session.apply(action::CheckFile{});
    session.finish_reading();
  }
  ASSERT_TRUE(session.question());
  EXPECT_EQ(session.question()->kind, Question::Kind::read_outside);
  session.apply(action::AnswerQuestion{action::Answer::allow});
  session.finish_reading();
  EXPECT_EQ(corner(session), kRed);
}

TEST_F(OutsideFiles, OfALevelOfLdtkAreAskedAboutBeforeItsDialog) {
  const std::string level = ldtk_tiles(1, 1, ldtk_tile(0, 0, 0));
  put("game/maps/p.ldtk",
      ldtk_project(ldtk_level(level, "A") + "," + ldtk_level(level, "B"), "",
                   R"({"uid":1,"identifier":"Tiles","relPath":"../art/t.png","tileGridSize":8})"));
  Session session(Level(), "", kUnnamed, tools());
  session.apply(action::OpenFile{path("game/maps/p.ldtk")});
  ASSERT_TRUE(session.question());
  EXPECT_FALSE(session.level_import());
  session.apply(action::AnswerQuestion{action::Answer::allow});
  ASSERT_TRUE(session.level_import());
  ASSERT_TRUE(session.level_import()->plan);
  EXPECT_THAT(session.level_import()->plan->dropped, IsEmpty());
  session.apply(action::ApplyLevelImport{});
  EXPECT_FALSE(session.question());
  EXPECT_EQ(session.path(), path("game/maps/p.ldtk"));
}

TEST_F(OutsideFiles, OnTheCommandLineNeedAnOption) {
  const auto import = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"import", path("game/maps/a.tmx"), "-o", path("a.talus.json")};
    words.insert(words.end(), more.begin(), more.end());
    return cli_answer(words);
  };
  const CliAnswer without = import({});
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_THAT(without.err, HasSubstr("not in the level: the tileset, file ../sets/t.tsx: lies outside"));
  EXPECT_THAT(without.err, HasSubstr("names 1 file outside of its folder: --allow-outside reads it"));
  const CliAnswer with = import({"--allow-outside"});
  EXPECT_THAT(with.err, Not(HasSubstr("outside")));
  EXPECT_THAT(cli_answer({"check", path("game/maps/a.tmx"), "--allow-outside"}).err,
              Not(HasSubstr("outside")));
  // What was allowed in the window holds here, too.
  ReadPermissions permissions(path(".state") + "/" + kReadPermissionsFile);
  ASSERT_TRUE(permissions.allow(path("game/maps/a.tmx"), game()));
  EXPECT_THAT(import({}).err, Not(HasSubstr("outside")));
}

TEST_F(OutsideFiles, PermissionsAreForMapsOfAFolder) {
  const std::string store = path("state/reads");
  ReadPermissions permissions(store);
  EXPECT_THAT(permissions.folders_of(path("game/maps/a.tmx")), IsEmpty());
  ASSERT_TRUE(permissions.allow(path("game/maps/a.tmx"), game()));
  ASSERT_TRUE(permissions.allow(path("game/maps/b.tmx"), game()));
  EXPECT_THAT(permissions.folders_of(path("game/maps/c.tmx")), ElementsAre(game()));
  EXPECT_THAT(permissions.folders_of(path("game/a.tmx")), IsEmpty());
  EXPECT_EQ(bytes_of("state/reads"), "{\"maps\":\"" + game() + "/maps\",\"read\":\"" + game() + "\"}\n");
  // Damaged lines are left out, and the oldest go.
  put("state/reads",
      "[]\n{\"maps\":1,\"read\":\"/\"}\n{\"maps\":\"x\",\"read\":\"/\"}\n" + bytes_of("state/reads"));
  EXPECT_THAT(ReadPermissions(store).folders_of(path("game/maps/a.tmx")), ElementsAre(game()));
  put("state/reads", std::string(ReadPermissions::kMaxKept + 1, ' '));
  EXPECT_THAT(ReadPermissions(store).folders_of(path("game/maps/a.tmx")), IsEmpty());
  std::string full;
  for (int i = 0; full.size() < ReadPermissions::kMaxKept - 200; ++i)
    full += "{\"maps\":\"/" + std::to_string(i) + "\",\"read\":\"/\"}\n";
  put("state/reads", full);
  ASSERT_TRUE(ReadPermissions(store).allow(path("game/maps/a.tmx"), game()));
  EXPECT_LE(bytes_of("state/reads").size(), ReadPermissions::kMaxKept);
  EXPECT_THAT(ReadPermissions(store).folders_of(path("game/maps/a.tmx")), ElementsAre(game()));
}

TEST_F(OutsideFiles, CommonFolderFollowsLinks) {
  fs::create_directories(path("far/away"));
  fs::create_symlink(path("far/away"), path("game/maps/link"));
  const std::string map = path("game/maps/a.tmx"), root = fs::canonical(path(".")).string();
  EXPECT_EQ(common_folder(map, {"../art/t.png"}), game());
  EXPECT_EQ(common_folder(map, {"../maps/x.png"}), game() + "/maps");
  EXPECT_EQ(common_folder(map, {"../art/t.png", "link/x.png"}), root);
  fs::create_symlink("round", path("game/maps/round"));
  EXPECT_EQ(common_folder(map, {"round/x.png"}), "");
}

}  // namespace talus::outside_files_test
