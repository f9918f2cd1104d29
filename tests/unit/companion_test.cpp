// Companions hold what a cart cannot, in a file beside it.
#include "formats/native/companion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "folder_test.h"
#include "formats/native/native.h"
#include "formats/text/content_hash.h"
#include "formats/text/json_text.h"

namespace talus::companion_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A level that fits into a cart: a map, pixels, flags.
Level plain_level() {
  Level level;
  level.map.set({2, 3}, 4);
  level.sheet(SheetId::tiles).images[4].fill(5);
  level.sheet(SheetId::tiles).flags[4] = 1;
  return level;
}

// The same level with one of everything that no cart can hold.
Level rich_level() {
  Level level = plain_level();
  level.map = TileMap(30, 17);
  level.map.set({2, 3}, 4);
  level.spawns.resize(2);
  level.spawns[0].position = {16, 8};
  level.spawns[1].kind = BodyKind::player;
  level.spawns[1].extra = R"({"worth":"coin"})";
  level.tile_shapes[4].kind = TileShape::Kind::solid;
  level.flag_shapes[5].kind = TileShape::Kind::solid;
  level.flag_shapes[5].one_way = true;
  level.curves.push_back({"line", {.form = Segment{{0, 0}, {8, 8}}}, ""});
  level.flag_names[0] = "wall";
  level.flag_fields = {{"kind", 3, 2, {"a", "b"}, ""}};
  level.roles.solid = 4;
  level.roles.ball = FlagRoles::kUnused;
  level.tuning.solver = SolverKind::article;
  level.tuning.shared.fall_speed = 4;
  level.brushes.push_back({.name = "grass", .tiles = {4}, .extra = ""});
  level.auto_tiles.tiles[0] = 4;
  level.exports = {{"game", "love", "game", "", false, ""}};
  level.palette = {};
  level.background = Rgba{1, 2, 3, 4};
  level.extra = R"({"future":1,"map":{"mood":"dark"},"nothing":null})";
  return level;
}

bool is_same(Level a, Level b) {
  a.cart = b.cart = nullptr;
  return a == b;
}

class Companions : public FolderTest {
 protected:
  SavedLevel save(const Level& level, const std::string& name, const CompanionFile& known = {}) const {
    auto saved = save_level(level, *format_for_file(name), path(name), known);
    EXPECT_TRUE(saved) << to_string(saved.error(), name);
    return saved ? *std::move(saved) : SavedLevel();
  }
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *std::move(loaded) : LoadedLevel();
  }
  // Changes the cart alone, as TIC-80 does.
  void change_cart(const std::string& name, void (*change)(Level&)) const {
    const Format& format = *format_for_file(name);
    Level level = format.read(bytes_of(name), context_for_file(name)).value();
    change(level);
    put(name, format.write(level, context_for_file(name)).value().bytes);
  }
  void expect_not_read(const std::string& why) const {
    const LoadedLevel loaded = load("game.tic");
    EXPECT_TRUE(is_same(loaded.level, plain_level()));
    EXPECT_EQ(loaded.note, "game.tic.talus.json is left as it is, and not read: " + why);
    EXPECT_EQ(loaded.companion.path, "");
  }
};

TEST_F(Companions, HoldWhatEachKindOfCartLacks) {
  for (const std::string name : {"a.tic", "a.lua", "a.js", "a.yue", "a.fnl", "a.py"}) {
    const Level level = rich_level();
    const SavedLevel saved = save(level, name);
    EXPECT_EQ(saved.companion.path, path(name + ".talus.json"));
    EXPECT_EQ(saved.note, "");
    EXPECT_TRUE(saved.dropped.empty());
    const LoadedLevel loaded = load(name);
    EXPECT_TRUE(is_same(loaded.level, level)) << name;
    EXPECT_EQ(loaded.note, "");
    EXPECT_EQ(loaded.companion.content, saved.companion.content);
    EXPECT_NE(loaded.level.cart, nullptr);
    // Saving again changes neither file.
    const std::string cart = bytes_of(name), companion = bytes_of(name + ".talus.json");
    save(loaded.level, name, loaded.companion);
    EXPECT_EQ(bytes_of(name), cart);
    EXPECT_EQ(bytes_of(name + ".talus.json"), companion);
  }
  EXPECT_FALSE(exists("a.tic.talus-kept1.json"));
}

TEST_F(Companions, HoldNothingThatTheCartHolds) {
  Level level = plain_level();
  level.spawns.resize(1);
  level.tuning.shared.fall_speed = 4;
  save(level, "game.tic");
  Json companion = parse_json(bytes_of("game.tic.talus.json")).value();
  EXPECT_EQ(companion["companion"]["file"], "game.tic");
  EXPECT_EQ(companion["companion"]["with"].size(), 4u);
  companion.erase("companion");
  EXPECT_EQ(companion, parse_json(R"({"talus": 1, "tuning": {"fall_speed": 4},
    "spawns": [{"name": "", "x": 0, "y": 0, "vx": 0, "vy": 0}]})")
                           .value())
      << companion.dump();
}

TEST_F(Companions, AreNotWrittenWhereTheCartLacksNothing) {
  save(plain_level(), "game.tic");
  EXPECT_FALSE(exists("game.tic.talus.json"));
  save(rich_level(), "level.talus.json");
  EXPECT_FALSE(exists("level.talus.json.talus.json"));
}

TEST_F(Companions, AreRemovedWhenNoLongerNeeded) {
  const SavedLevel saved = save(rich_level(), "game.tic");
  EXPECT_EQ(save(plain_level(), "game.tic", saved.companion).companion.path, "");
  EXPECT_FALSE(exists("game.tic.talus.json"));
  EXPECT_TRUE(is_same(load("game.tic").level, plain_level()));
}

TEST_F(Companions, FromAnotherLevelAreKeptAside) {
  save(rich_level(), "game.tic");
  const std::string before = bytes_of("game.tic.talus.json");
  EXPECT_EQ(save(plain_level(), "game.tic").note,
            "game.tic.talus.json held something else, which is kept as game.tic.talus-kept1.json");
  EXPECT_FALSE(exists("game.tic.talus.json"));
  EXPECT_EQ(bytes_of("game.tic.talus-kept1.json"), before);
  Level other = plain_level();
  other.spawns.resize(3);
  SavedLevel saved = save(other, "game.tic");
  saved.companion.content = 1;  // changed by another program since
  save(rich_level(), "game.tic", saved.companion);
  EXPECT_TRUE(exists("game.tic.talus-kept2.json"));
  EXPECT_TRUE(is_same(load("game.tic").level, rich_level()));
}

TEST_F(Companions, AreTakenWithACartThatWasChangedElsewhere) {
  Level level = rich_level();
  level.palette = default_palette();
  save(level, "game.tic");
  change_cart("game.tic", [](Level& cart) { cart.map.set({5, 6}, 7); });
  const LoadedLevel loaded = load("game.tic");
  level.map.set({5, 6}, 7);
  EXPECT_TRUE(is_same(loaded.level, level));
  EXPECT_EQ(
      loaded.note,
      "game.tic was changed since game.tic.talus.json was saved with it (map); all that was added is kept");
  // Code is no part of the level, so there is nothing to report.
  save(loaded.level, "game.lua");
  put("game.lua", "-- more code\n" + bytes_of("game.lua"));
  EXPECT_EQ(load("game.lua").note, "");
}

TEST_F(Companions, GrowTheMapWhereTheCartFillsMoreOfIt) {
  save(rich_level(), "game.tic");
  change_cart("game.tic", [](Level& cart) { cart.map.set({99, 50}, 7); });
  const LoadedLevel loaded = load("game.tic");
  EXPECT_EQ(loaded.level.map.width(), 100);
  EXPECT_EQ(loaded.level.map.height(), 51);
  EXPECT_EQ(loaded.level.map.at({99, 50}), 7);
  EXPECT_EQ(loaded.level.spawns.size(), 2u);
  EXPECT_THAT(loaded.note,
              HasSubstr("all that was added is kept, and the map is as large as its cells need"));
}

TEST_F(Companions, LoseNothingIfBothFilesWereChanged) {
  save(rich_level(), "game.tic");  // its palette is black, which only the companion can hold
  change_cart("game.tic", [](Level& cart) { cart.palette[3] = {1, 2, 3}; });
  const std::string before = bytes_of("game.tic.talus.json");
  const LoadedLevel loaded = load("game.tic");
  EXPECT_EQ(loaded.level.palette[3], (Rgb{1, 2, 3}));
  EXPECT_EQ(loaded.level.spawns.size(), 2u);
  EXPECT_THAT(loaded.note, HasSubstr("(palette); both are kept, but where they disagree, game.tic counts"));
  EXPECT_FALSE(loaded.companion.content);
  save(loaded.level, "game.tic", loaded.companion);
  EXPECT_EQ(bytes_of("game.tic.talus-kept1.json"), before);
}

TEST_F(Companions, FromAnotherCartAreReportedAndUsed) {
  save(rich_level(), "other.tic");
  save(plain_level(), "game.tic");
  change_cart("game.tic", [](Level& cart) { cart.map.set({9, 9}, 9); });
  fs::copy(path("other.tic.talus.json"), path("game.tic.talus.json"));
  const LoadedLevel loaded = load("game.tic");
  EXPECT_EQ(loaded.level.spawns.size(), 2u);
  EXPECT_EQ(loaded.level.map.at({9, 9}), 9);
  EXPECT_THAT(loaded.note,
              HasSubstr("game.tic is not the file that game.tic.talus.json was saved with (other"));
}

TEST_F(Companions, FollowACartThatIsRenamedWithThem) {
  save(rich_level(), "game.tic");
  fs::rename(path("game.tic"), path("hero.tic"));
  fs::rename(path("game.tic.talus.json"), path("hero.tic.talus.json"));
  const LoadedLevel loaded = load("hero.tic");
  EXPECT_TRUE(is_same(loaded.level, rich_level()));
  EXPECT_EQ(loaded.note, "");
}

TEST_F(Companions, OpenTheirCart) {
  save(rich_level(), "game.tic");
  const LoadedLevel loaded = load("game.tic.talus.json");
  EXPECT_EQ(loaded.path, path("game.tic"));
  EXPECT_TRUE(is_same(loaded.level, rich_level()));
  fs::remove(path("game.tic"));
  EXPECT_EQ(load_level(path("game.tic.talus.json")).error().message,
            "is the companion that Talus saved with game.tic, but that file is not beside it: put both into "
            "one folder");
  fs::rename(path("game.tic.talus.json"), path("x.talus.json"));
  EXPECT_EQ(
      load_level(path("x.talus.json")).error().message,
      "is the companion that Talus saved with x, but that file is not beside it: put both into one folder");
  fs::rename(path("x.talus.json"), path("x.json"));
  EXPECT_EQ(load_level(path("x.json")).error().message,
            "is not a level, but the companion of a cart: put it beside the cart, and open the cart");
}

TEST_F(Companions, KeepTheirPlaceBesideACart) {
  save(rich_level(), "game.tic");
  const std::string before = bytes_of("game.tic.talus.json");
  const auto saved = save_level(Level(), *find_format("native"), path("game.tic.talus.json"));
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().message, "is the name of the companion of game.tic beside it: choose another name");
  EXPECT_EQ(bytes_of("game.tic.talus.json"), before);
  save(Level(), "other.tic.talus.json");  // a companion without a cart
}

TEST_F(Companions, AreFoundThroughALink) {
  save(rich_level(), "game.tic");
  fs::create_directory(path("links"));
  fs::create_symlink(path("game.tic"), path("links/game.tic"));
  const LoadedLevel loaded = load("links/game.tic");
  EXPECT_TRUE(is_same(loaded.level, rich_level()));
  save(loaded.level, "links/game.tic", loaded.companion);
  EXPECT_FALSE(exists("links/game.tic.talus.json"));
}

TEST_F(Companions, BrokenOnesLeaveTheCartAlone) {
  save(plain_level(), "game.tic");
  const auto with = [&](const std::string& members) {
    put("game.tic.talus.json", R"({"talus": 1, "companion": {"file": "game.tic"}, )" + members + "}");
  };
  put("game.tic.talus.json", "{");
  expect_not_read("line 1, column 2: this is not valid JSON");
  put("game.tic.talus.json", "[]");
  expect_not_read("is a file of its own, not the companion of another one");
  put("game.tic.talus.json", write_native(rich_level(), {})->bytes);
  expect_not_read("is a file of its own, not the companion of another one");
  put("game.tic.talus.json", R"({"companion": 7})");
  expect_not_read("key companion: must be an object");
  with(R"("spawns": [{"x": "far"}])");
  expect_not_read("key spawns[0].x: must be a number from -100000000 to 100000000");
  with(R"("roles": 7)");
  expect_not_read("key roles: must be an object");
  with(R"("map": {"width": -3})");
  expect_not_read("key map.width: must be a whole number from 1 to 2097152");
  with(R"("cart": {"kind": "tic", "chunks": []})");
  expect_not_read("key cart: must not be in a companion: the file beside it holds the cart");
  put("game.tic.talus.json", R"({"talus": 99, "companion": {"file": "game.tic"}})");
  EXPECT_THAT(load("game.tic").note, HasSubstr("has version 99"));
}

TEST_F(Companions, ThingsOtherThanFilesAreNotOpened) {
  save(plain_level(), "game.tic");
  ASSERT_EQ(::mkfifo(path("game.tic.talus.json").c_str(), 0600), 0);
  expect_not_read("is a link, a folder or a device, but must be a file");
  fs::remove(path("game.tic.talus.json"));
  put("game.tic.talus.json", "");
  fs::resize_file(path("game.tic.talus.json"), kMaxFileBytes + 1);
  expect_not_read("is larger than 96 MiB");
  fs::remove(path("game.tic.talus.json"));
  put("victim", "mine");
  fs::create_symlink(path("victim"), path("game.tic.talus.json"));
  expect_not_read("is a link, a folder or a device, but must be a file");
  // A thing in the way is moved aside, and never written through.
  const SavedLevel saved = save(rich_level(), "game.tic");
  EXPECT_EQ(bytes_of("victim"), "mine");
  EXPECT_TRUE(fs::is_symlink(path("game.tic.talus-kept1.json")));
  EXPECT_TRUE(is_same(load("game.tic").level, rich_level()));
}

TEST_F(Companions, BrokenOnesAreNeverOverwritten) {
  save(plain_level(), "game.tic");
  put("game.tic.talus.json", "<<<<<<< mine");
  save(plain_level(), "game.tic", load("game.tic").companion);
  EXPECT_EQ(bytes_of("game.tic.talus.json"), "<<<<<<< mine")
      << "no companion is needed, so the broken file stays";
  const SavedLevel saved = save(rich_level(), "game.tic", load("game.tic").companion);
  EXPECT_EQ(saved.note,
            "game.tic.talus.json held something else, which is kept as game.tic.talus-kept1.json");
  EXPECT_EQ(bytes_of("game.tic.talus-kept1.json"), "<<<<<<< mine");
}

// A save that fails leaves both files as they were.
TEST_F(Companions, AreWrittenWithTheCartOrNotAtAll) {
  // A socket is noticed only when the cart is put in place, which comes after its companion.
  ASSERT_EQ(::mknod(path("game.tic").c_str(), S_IFSOCK | 0600, 0), 0);
  EXPECT_FALSE(save_level(rich_level(), *find_format("tic"), path("game.tic")));
  EXPECT_FALSE(exists("game.tic.talus.json"));
  put("game.tic.talus.json", "mine");
  EXPECT_FALSE(save_level(rich_level(), *find_format("tic"), path("game.tic")));
  EXPECT_EQ(bytes_of("game.tic.talus.json"), "mine");
  const CompanionFile own{path("game.tic.talus.json"), content_hash("mine")};
  EXPECT_FALSE(save_level(rich_level(), *find_format("tic"), path("game.tic"), own));
  EXPECT_EQ(bytes_of("game.tic.talus.json"), "mine");
  EXPECT_FALSE(exists("game.tic.talus-kept1.json"));

  Level unwritable = rich_level();
  unwritable.spawns[0].position.x = 1e300;
  const SavedLevel saved = save(rich_level(), "other.tic");
  const std::string cart = bytes_of("other.tic"), companion = bytes_of("other.tic.talus.json");
  unwritable.map.set({1, 1}, 1);
  const auto failed = save_level(unwritable, *find_format("tic"), path("other.tic"), saved.companion);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().place, "key spawns[0].x");
  EXPECT_EQ(bytes_of("other.tic"), cart);
  EXPECT_EQ(bytes_of("other.tic.talus.json"), companion);
}

// A crash between the two renames leaves one of these pairs.
TEST_F(Companions, ReportAPairFromTwoSaves) {
  const SavedLevel saved = save(rich_level(), "game.tic");
  const std::string old_cart = bytes_of("game.tic"), old_companion = bytes_of("game.tic.talus.json");
  Level next = rich_level();
  next.map.set({8, 8}, 4);
  next.spawns.resize(3);
  save(next, "game.tic", saved.companion);
  const std::string new_cart = bytes_of("game.tic");
  put("game.tic", old_cart);
  EXPECT_EQ(load("game.tic").level.spawns.size(), 3u);
  EXPECT_THAT(load("game.tic").note, HasSubstr("was changed since"));
  put("game.tic", new_cart);
  put("game.tic.talus.json", old_companion);
  EXPECT_EQ(load("game.tic").level.spawns.size(), 2u);
  EXPECT_EQ(load("game.tic").level.map.at({8, 8}), 4);
  EXPECT_THAT(load("game.tic").note, HasSubstr("was changed since"));
}

// Formats whose files hold lists, such as bodies, join them too.
TEST(CompanionContent, JoinsWhatBothHold) {
  static constexpr std::array<std::string_view, 2> kHolds = {"spawns", "tile_shapes"};
  Format format = *find_format("native");
  format.holds = kHolds;
  Level held;
  held.spawns.resize(2);
  held.spawns[1].position = {8, 8};
  held.tile_shapes[3].kind = held.tile_shapes[4].kind = TileShape::Kind::solid;
  Level level = held;
  level.spawns[1].position = {16, 8};
  level.tile_shapes[3] = {};  // removed
  level.tile_shapes[4].one_way = true;
  const std::string companion = write_companion(level, held, format, "a").value();
  EXPECT_TRUE(join_companion(companion, held, format, "a")->level == level);

  held.spawns.push_back({.name = "new", .position = {}, .velocity = {}, .extra = ""});
  held.tile_shapes[5].kind = TileShape::Kind::solid;
  const JoinedLevel joined = join_companion(companion, held, format, "a").value();
  EXPECT_EQ(joined.level.spawns.size(), 4u) << "the bodies of the file, and the one that was moved";
  EXPECT_EQ(joined.level.tile_shapes[5].kind, TileShape::Kind::solid);
  EXPECT_TRUE(joined.level.tile_shapes[4].one_way);
  EXPECT_FALSE(joined.is_whole) << "tile 3 was changed, so it stays";
}

}  // namespace talus::companion_test
