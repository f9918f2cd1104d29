// talus export to folders: what is written, and what is refused.
#include <gtest/gtest.h>

#include "cli_answer.h"
#include "export/exporter.h"
#include "folder_test.h"

namespace talus::cli_export_test {

TEST(Exporters, AMissingPartIsAnErrorAndWritesNothing) {
  const ReadAsset nothing = [](const std::string& name) -> FormatResult<std::string> {
    return tl::unexpected(FormatError{name, "is missing"});
  };
  const auto exported = find_exporter("lua-runtime")->write({Level(), "game", nothing});
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().place, "runtime/base.lua");
}

class CliExport : public FolderTest {
 protected:
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"export", TALUS_SOURCE_DIR "/assets/demo.talus.json", "--to"});
    answer_ = cli_answer(words);
    return answer_.status;
  }

  CliAnswer answer_;
};

TEST_F(CliExport, OneFileGoesToStandardOutput) {
  const std::pair<const char*, const char*> beginnings[] = {{"lua", "-- A level exported by Talus"},
                                                            {"json", "{\n \"width\":240,"},
                                                            {"c", "/* A level exported by Talus"},
                                                            {"png", "\x89PNG\r\n"},
                                                            {"svg", "<?xml version=\"1.0\"?>\n<svg "}};
  for (const auto& [format, beginning] : beginnings) {
    EXPECT_EQ(run({format, "-o", "-"}), 0) << answer_.err;
    EXPECT_EQ(answer_.out.substr(0, std::string(beginning).size()), beginning) << format;
  }
}

TEST_F(CliExport, TablesAreAFolder) {
  ASSERT_EQ(run({"csv", "-o", path("tables")}), 0) << answer_.err;
  for (const char* name : {"map.csv", "flags.csv", "polygons.csv", "lines.csv", "spawns.csv"})
    EXPECT_TRUE(exists(std::string("tables/") + name)) << name;
  EXPECT_EQ(run({"csv", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name one"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, LoveIsAFolder) {
  ASSERT_EQ(run({"love", "-o", path("game")}), 0) << answer_.err;
  for (const char* name : {"main.lua", "conf.lua", "talus.lua", "level.lua", "sheet.png"})
    EXPECT_TRUE(exists(std::string("game/") + name)) << name;
}

TEST_F(CliExport, AFolderIsNoStandardOutput) {
  EXPECT_EQ(run({"love", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name one"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, AFolderUnderAFileIsRefused) {
  const std::string file = TALUS_SOURCE_DIR "/README.md/game";
  EXPECT_EQ(run({"lua-runtime", "-o", file}), 1);
  EXPECT_NE(answer_.err.find("cannot be made"), std::string::npos) << answer_.err;
}

}  // namespace talus::cli_export_test
