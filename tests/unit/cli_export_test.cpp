// talus export into folders: what is written, and what is refused.
#include <gtest/gtest.h>

#include "cli_answer.h"
#include "export/exporter.h"
#include "folder_test.h"
#include "paths.h"

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
    words.insert(words.begin(), {"export", source_path("assets/demo.talus.json"), "--to"});
    answer_ = cli_answer(words);
    return answer_.status;
  }

  CliAnswer answer_;
};

TEST_F(CliExport, OneFileGoesToStandardOutput) {
  const std::pair<const char*, const char*> beginnings[] = {{"lua", "-- A level exported by Talus"},
                                                            {"json", "{\n \"width\":240,"},
                                                            {"c", "/* Copyright (c) 2026 the Talus authors."},
                                                            {"png", "\x89PNG\r\n"},
                                                            {"svg", "<?xml version=\"1.0\"?>\n<svg "}};
  for (const auto& [format, beginning] : beginnings) {
    EXPECT_EQ(run({format, "-o", "-"}), 0) << answer_.err;
    EXPECT_EQ(answer_.out.substr(0, std::string(beginning).size()), beginning) << format;
  }
}

TEST_F(CliExport, TablesAreAFolder) {
  ASSERT_EQ(run({"csv", "-o", path("tables")}), 0) << answer_.err;
  for (const char* name : {"map.csv", "flags.csv", "polygons.csv", "lines.csv", "bodies.csv"})
    EXPECT_TRUE(exists(std::string("tables/") + name)) << name;
  EXPECT_EQ(run({"csv", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name a folder"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, LoveIsAFolder) {
  ASSERT_EQ(run({"love", "-o", path("game")}), 0) << answer_.err;
  for (const char* name : {"main.lua", "conf.lua", "talus.lua", "level.lua", "sheet.png"})
    EXPECT_TRUE(exists(std::string("game/") + name)) << name;
}

TEST_F(CliExport, PartsOfTheRuntimeCanBeChosen) {
  ASSERT_EQ(run({"lua-runtime", "-o", path("game"), "--parts", "players,mouse"}), 0) << answer_.err;
  const std::string text = bytes_of("game/talus.lua");
  EXPECT_NE(
      text.find("\n-- The parts of this module: slopes, balls, sides, walk, players, pairs, mouse, events, "
                "steer, data.\n"),
      std::string::npos);
  EXPECT_EQ(run({"love", "-o", path("other"), "--parts", "plyers"}), 1);
  EXPECT_NE(answer_.err.find("\"plyers\" is not a part of the runtime; the parts are slopes, one_way"),
            std::string::npos)
      << answer_.err;
  EXPECT_FALSE(exists("other"));
  EXPECT_EQ(run({"csv", "-o", path("other"), "--parts", "players"}), 2);
}

TEST_F(CliExport, AFolderCannotGoToStandardOutput) {
  EXPECT_EQ(run({"love", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name a folder"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, AFolderUnderAFileIsRefused) {
  const std::string file = source_path("README.md/game");
  EXPECT_EQ(run({"lua-runtime", "-o", file}), 1);
  EXPECT_EQ(answer_.err,
            file + ": error: " + source_path("README.md") + " is a file, but must be a folder\n");
}

}  // namespace talus::cli_export_test
