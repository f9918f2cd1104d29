// Presets that would overwrite each other's files, and the default names and paths of presets.
#include "export/preset_clash.h"

#include <gtest/gtest.h>

#include <set>

#include "export/export_plan.h"
#include "formats/files/atomic_file.h"
#include "paths.h"

namespace talus::preset_clash_test {

const std::string kLevel = "/home/me/cave.talus.json";

ExportPreset preset(const std::string& name, const std::string& exporter, const std::string& path) {
  return {.name = name, .exporter = exporter, .path = path, .extra = ""};
}

std::string clash(std::vector<ExportPreset> presets, std::size_t index = 0) {
  return clash_problem(presets, index, kLevel);
}

FormatResult<std::string> read_asset(const std::string& name) {
  return read_file(source_path("assets/") + name);
}

TEST(ExporterFiles, AreAllNamedBeforehand) {
  Level level;
  level.curves.push_back({"", {Arc{{30, 20}, 8, 24, 36, true}, Curve::Faces::up}, ""});
  level.flag_names[4] = "ice";
  auto picture = std::make_shared<SheetPicture>(SheetPicture{1, 1, {1, 2, 3, 255}});
  MapObject shown{.form = MapObject::Form::tile, .size = {4, 4}};
  shown.picture = {.picture = picture, .width = 1, .height = 1};
  level.objects.push_back({.name = "shown", .objects = {shown}});
  level.large_tiles[1] = {.part = {.picture = picture, .width = 1, .height = 1}, .size = {16, 16}};
  const ReadAsset read = read_asset;
  for (const Exporter& exporter : exporters()) {
    const std::string name = exporter.is_folder() ? "a.b" : "a.b." + std::string(exporter.extensions[0]);
    const auto exported = exporter.make({level, name, read});
    ASSERT_TRUE(exported) << exporter.id << exported.error().message;
    std::set<std::string> written, told;
    for (const ExportedFile& file : exported->files) {
      if (!file.name.empty()) written.insert(without_picture_number(file.name));
    }
    for (const std::string_view beside : exporter.beside) told.insert(name_beside(beside, name));
    EXPECT_EQ(written, told) << exporter.id;
  }
}

TEST(ExporterFiles, PicturesOfAMapBelongToIt) {
  EXPECT_NE(
      clash({preset("map", "tmx", "out/a.tmx"), preset("map as a picture", "png", "out/a-picture-12.png")}),
      "");
  EXPECT_NE(
      clash({preset("map as a picture", "png", "out/a-picture-1.png"), preset("map", "sti", "out/a.lua")}),
      "");
  for (const char* path :
       {"out/a-picture-.png", "out/a-picture-1x.png", "out/b-picture-1.png", "a-picture-1.png"})
    EXPECT_EQ(clash({preset("map", "tmx", "out/a.tmx"), preset("map as a picture", "png", path)}), "")
        << path;
  EXPECT_EQ(without_picture_number("a-picture-3.png"), "a-picture-#.png");
  EXPECT_EQ(without_picture_number("a-tiles.png"), "a-tiles.png");
}

TEST(ExporterFiles, CompanionsBelongToOneExport) {
  EXPECT_NE(clash({preset("cart", "tic", "out/a.tic"), preset("copy", "native", "out/a.tic.talus.json")}),
            "");
  EXPECT_EQ(clash({preset("cart", "tic", "out/a.tic"), preset("copy", "native", "out/a.talus.json")}), "");
  const std::vector<ExportPreset> own = {preset("copy", "native", "game.tic.talus.json")};
  EXPECT_EQ(clash_problem(own, 0, "/home/me/game.tic"),
            "game.tic.talus.json belongs to the level's own file, and the preset would overwrite it: give "
            "another path");
}

TEST(ExporterFiles, SharedPicturesAreTheSame) {
  Level level;
  level.sheet(SheetId::tiles).images[5].fill(7);
  level.sheet(SheetId::tiles).flags[5] = 1 << 2;  // a slope of 16x8 px, for which STI gets additional tiles
  level.map.set({2, 2}, 5);
  const ReadAsset read = read_asset;
  std::set<std::string> pictures;
  for (const Exporter& exporter : exporters()) {
    if (!exporter.shares_sheet) continue;
    const auto exported = exporter.make({level, "a." + std::string(exporter.extensions[0]), read});
    pictures.insert(exported->files.back().bytes);
  }
  EXPECT_EQ(pictures.size(), 1u);
}

TEST(PresetClash, DefaultPathsDoNotClash) {
  std::vector<ExportPreset> presets;
  std::set<std::string> paths;
  for (const Exporter& exporter : exporters()) {
    const std::string path = usual_path(exporter, "cave.talus.json");
    presets.push_back(preset(std::string(exporter.id), std::string(exporter.id), path));
    EXPECT_TRUE(paths.insert(path).second) << path;
  }
  for (std::size_t i = 0; i < presets.size(); ++i) EXPECT_EQ(clash(presets, i), "") << presets[i].name;
}

TEST(PresetClash, NamesBothPresetsAndTheFile) {
  EXPECT_EQ(clash({preset("data", "lua", "out/a.lua"), preset("map", "sti", "out/../out/a.lua")}),
            "the presets \"data\" and \"map\" would both write out/a.lua: give one of them another path");
  EXPECT_EQ(
      clash({preset("picture", "png", "/home/me/out/a-tiles.png"), preset("map", "tmj", "out/a.tmj")}, 1),
      "the presets \"picture\" and \"map\" would both write out/a-tiles.png: give one of them another "
      "path");
  EXPECT_EQ(clash({preset("", "love", "game"), preset("", "lua-runtime", "game/")}),
            "the presets \"game\" and \"game/\" would both write game/talus.lua: give one of them another "
            "path");
  EXPECT_EQ(
      clash({preset("data", "lua", "game/main.lua"), preset("love", "love", "game")}),
      "the presets \"data\" and \"love\" would both write game/main.lua: give one of them another path");
}

TEST(PresetClash, EqualOrDifferentFilesDoNotClash) {
  EXPECT_EQ(clash({preset("a", "tmj", "out/a.tmj"), preset("b", "tmx", "out/a.tmx")}), "")
      << "both write the tiles' picture";
  EXPECT_EQ(clash({preset("a", "tmj", "out/a.tmj"), preset("b", "sti", "out/a.lua")}), "");
  EXPECT_EQ(clash({preset("a", "csv", "out"), preset("b", "love", "out")}), "");
  EXPECT_EQ(clash({preset("a", "no-such", "out"), preset("b", "no-such", "out")}), "");
}

TEST(PresetClash, AnExportMayNotReplaceTheLevel) {
  const std::vector<ExportPreset> presets = {preset("game", "cpp", "game")};
  EXPECT_EQ(clash_problem(presets, 0, "game/level.talus.json"), "");
  const std::vector<ExportPreset> own = {preset("game", "cpp", ".")};
  EXPECT_EQ(clash_problem(own, 0, "game/level.talus.json"),
            "level.talus.json is the level's own file, which the preset would overwrite: give another path");
}

TEST(PresetTarget, TheNameAndThePathFollowTheTarget) {
  const std::vector<ExportPreset> others = {preset("love", "love", "export/love"),
                                            preset("sti", "sti", "export/cave-sti.lua")};
  const auto changed = [&](const ExportPreset& before, const char* target) {
    return with_target(before, *find_exporter(target), others, "cave.talus.json", kLevel);
  };
  EXPECT_EQ(changed({}, "love"), preset("love 2", "love", "export/love-2"));
  const ExportPreset second = preset("love 2", "love", "export/love-2");
  EXPECT_EQ(changed(second, "tmj"), preset("tmj", "tmj", "export/cave.tmj"));
  EXPECT_EQ(changed(second, "sti"), preset("sti 2", "sti", "export/cave-sti-2.lua"));
  EXPECT_EQ(changed(second, "love"), second);
  EXPECT_EQ(changed(preset("tic", "tic", "export/cave.tic"), "tic-playable"),
            preset("tic-playable", "tic-playable", "export/cave-playable.tic"));
  EXPECT_EQ(changed(preset("love 2b", "love", "mine/x"), "tic"), preset("love 2b", "tic", "mine/x.tic"));
}

TEST(PresetTarget, ACopyGetsAPathOfItsOwn) {
  const std::vector<ExportPreset> others = {preset("a", "tic", "mine/a.tic"),
                                            preset("b", "tic", "mine/a-2.tic")};
  EXPECT_EQ(free_path_like(others[0], *find_exporter("tic"), others, kLevel), "mine/a-3.tic");
}

}  // namespace talus::preset_clash_test
