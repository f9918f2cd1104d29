// talus import of maps of Tiled: choices, warnings and errors.
#include "cli_answer.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "tiled_files.h"

namespace talus::cli_import_test {

class CliImportTest : public FolderTest {
 protected:
  void SetUp() override {
    put("two.tmx",
        "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
        "<tileset firstgid=\"1\" tilewidth=\"8\" tileheight=\"8\" columns=\"16\" tilecount=\"300\"/>"
        "<layer name=\"front\"><data encoding=\"csv\">290</data></layer>"
        "<layer name=\"back\"><data encoding=\"csv\">7</data></layer></map>");
  }

  // Runs `talus import two.tmx OPTIONS -o two.talus.json`.
  int import(std::vector<std::string> options) {
    std::vector<std::string> words = {"import", path("two.tmx")};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"-o", path("two.talus.json")});
    const CliAnswer answer = cli_answer(words);
    errors_ = answer.err;
    return answer.status;
  }
  // The messages, without the folder.
  std::string errors() const {
    const std::string folder = folder_.string() + "/";
    std::string text = errors_;
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
  }

  std::string errors_;
};

TEST_F(CliImportTest, RefusesAChoiceThatTheFormatDoesNotHave) {
  ASSERT_EQ(import({}), 0);
  const struct {
    const char* file;
    std::vector<std::string> options;
    const char* error;
  } cases[] = {
      {"two.tmx",
       {"--level", "1"},
       "is read as \"Tiled map, XML\", for which --level has no meaning: leave it out"},
      {"two.talus.json", {"--layer", "1"}, "is read as \"Talus level\", for which --layer has no meaning"},
      {"two.talus.json",
       {"--tiles-used"},
       "is read as \"Talus level\", for which --tiles-used has no meaning"},
  };
  for (const auto& [file, options, error] : cases) {
    std::vector<std::string> arguments = {"import", path(file), "-o", path("no.talus.json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CliAnswer answer = cli_answer(arguments);
    EXPECT_EQ(answer.status, 1) << file;
    EXPECT_NE(answer.err.find(error), std::string::npos) << answer.err;
    EXPECT_FALSE(exists("no.talus.json"));
  }
}

TEST_F(CliImportTest, TakesAllLayers) {
  EXPECT_EQ(import({}), 0);
  EXPECT_EQ(load_level(path("two.talus.json"))->level.layers.count(), 2);
}

TEST_F(CliImportTest, TakesTheChoiceAndWarnsOfTheRest) {
  EXPECT_EQ(import({"--layer", "front", "--tiles-used"}), 0);
  EXPECT_EQ(
      errors(),
      "two.tmx: warning: not in the level: the layer \"back\"\n"
      "two.tmx: warning: not in the level: the picture of the tileset \"\"\n"
      "two.tmx: warning: nothing on this map is ground yet: give tiles a flag or a shape, or call a layer "
      "walls in Tiled\n");
  EXPECT_EQ(load_level(path("two.talus.json"))->level.map.at({0, 0}), 1);
}

TEST_F(CliImportTest, AChosenLayerKeepsItsNameInEveryFile) {
  EXPECT_EQ(import({"--layer", "front"}), 0);
  EXPECT_EQ(load_level(path("two.talus.json"))->level.layers.list.front().name, "front");
  for (const char* format : {"tmx", "tmj"}) {
    const std::string file = path(std::string("front.") + format);
    ASSERT_EQ(cli_answer({"export", path("two.talus.json"), "--to", format, "-o", file}).status, 0);
    EXPECT_EQ(load_level(file)->level.layers.list.front().name, "front") << format;
  }
}

TEST_F(CliImportTest, TakesALevelOfAProjectOfLdtk) {
  const std::string project = ldtk_project(ldtk_level(ldtk_grid(1, 1, "1"), "Cave") + "," +
                                           ldtk_level(ldtk_grid(3, 1, "1,0,0"), "Top"));
  const std::string file = put("game.ldtk", project);
  const auto import_level = [&](const std::string& name) {
    return cli_answer({"import", file, "--level", name, "-o", path("top.talus.json")});
  };
  EXPECT_EQ(import_level("Top").status, 0);
  EXPECT_EQ(load_level(path("top.talus.json"))->level.map.width(), 3);
  const CliAnswer wrong = import_level("Sky");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_EQ(wrong.err, file + ": error: has no level with the name \"Sky\", but \"Cave\", \"Top\"\n");
}

}  // namespace talus::cli_import_test
