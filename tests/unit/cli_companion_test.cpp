// Carts with companions on the command line: every command sees the whole level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "formats/text/json_text.h"
#include "level_picture.h"
#include "png_bytes.h"

namespace talus::cli_companion_test {

using testing::HasSubstr;

class CliCompanions : public FolderTest {
 protected:
  void SetUp() override {
    level_ = level_of({"....", "....", "####"});
    level_.spawns.resize(1);
    level_.spawns[0].kind = BodyKind::player;
    level_.tile_shapes[1].kind = TileShape::Kind::solid;
    ASSERT_TRUE(save_level(level_, *find_format("native"), path("whole.talus.json")));
    ASSERT_TRUE(save_level(level_, *find_format("tic"), path("game.tic")));
    ASSERT_TRUE(exists("game.tic.talus.json"));
  }
  CliAnswer run(const std::string& command, const std::string& file,
                const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {command, path(file)};
    words.insert(words.end(), options.begin(), options.end());
    return cli_answer(words);
  }
  // Expects that a command answers the same for the cart and for the native level.
  void expect_same(const std::string& command, const std::vector<std::string>& options) const {
    const CliAnswer whole = run(command, "whole.talus.json", options);
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_NE(whole.out, "");
    for (const char* file : {"game.tic", "game.tic.talus.json"}) {
      const CliAnswer cart = run(command, file, options);
      EXPECT_EQ(cart.status, 0) << cart.err;
      EXPECT_EQ(cart.out, whole.out);
      EXPECT_EQ(cart.err, whole.err);
    }
  }
  static bool is_same(Level a, Level b) {
    a.cart = b.cart = nullptr;
    return a == b;
  }

  Level level_;
};

TEST_F(CliCompanions, SimPlaysTheWholeLevel) { expect_same("sim", {"--frames", "60", "--hash"}); }

TEST_F(CliCompanions, ExportsHaveTheWholeLevel) { expect_same("export", {"--to", "json", "-o", "-"}); }

TEST_F(CliCompanions, ShotsShowTheWholeLevel) {
  const auto shot_status = [&](const std::string& file, const std::string& picture) {
    return status_of_own_process({"shot", path(file), "-o", path(picture)});
  };
  EXPECT_EQ(shot_status("whole.talus.json", "whole.png"), 0);
  EXPECT_EQ(shot_status("game.tic", "cart.png"), 0);
  EXPECT_EQ(bytes_of("cart.png"), bytes_of("whole.png"));
}

TEST_F(CliCompanions, ChecksSeeTheWholeLevel) {
  const CliAnswer whole = run("check", "whole.talus.json"), cart = run("check", "game.tic");
  EXPECT_EQ(cart.status, whole.status);
  const auto without_file = [&](std::string text, const std::string& file) {
    for (std::size_t at; (at = text.find(path(file))) != std::string::npos;)
      text.erase(at, path(file).size());
    return text;
  };
  EXPECT_EQ(without_file(cart.out, "game.tic"), without_file(whole.out, "whole.talus.json"));
}

TEST_F(CliCompanions, ImportsAreWhole) {
  EXPECT_EQ(run("import", "game.tic", {"-o", path("back.talus.json")}).status, 0);
  EXPECT_TRUE(is_same(load_level(path("back.talus.json"))->level, level_));
}

TEST_F(CliCompanions, ACartIsExportedWithItsCompanion) {
  for (const char* to : {"tic", "tic-text"}) {
    const std::string name = to == std::string("tic") ? "out.tic" : "out.lua";
    const CliAnswer answer = run("export", "whole.talus.json", {"--to", to, "-o", path(name)});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.err, "");
    EXPECT_TRUE(is_same(load_level(path(name))->level, level_));
    EXPECT_EQ(load_level(path(name))->note, "");
  }
  EXPECT_THAT(run("export", "whole.talus.json", {"--to", "tic", "-o", "-"}).err,
              HasSubstr("not stored in this format: what a cart cannot hold, which goes beside a file"));
  // A playable game has other code, and its companion is the same.
  EXPECT_EQ(run("export", "whole.talus.json", {"--to", "tic", "--playable", "-o", path("play.tic")}).status,
            0);
  EXPECT_TRUE(is_same(load_level(path("play.tic"))->level, level_));
}

TEST_F(CliCompanions, AnOldCompanionDoesNotAddToANewExport) {
  EXPECT_EQ(run("export", "whole.talus.json", {"--to", "tic", "-o", path("out.tic")}).status, 0);
  Level bare;
  bare.map.set({1, 1}, 1);
  ASSERT_TRUE(save_level(bare, *find_format("native"), path("bare.talus.json")));
  EXPECT_EQ(run("export", "bare.talus.json", {"--to", "tic", "-o", path("out.tic")}).status, 0);
  EXPECT_TRUE(is_same(load_level(path("out.tic"))->level, bare));
  EXPECT_EQ(load_level(path("out.tic"))->note, "");
  EXPECT_EQ(run("export", "bare.talus.json", {"--to", "tic", "-o", path("bare.tic")}).status, 0);
  EXPECT_FALSE(exists("bare.tic.talus.json"));
  // A file that no export wrote is not replaced.
  put("out.tic.talus.json", "mine");
  const CliAnswer answer = run("export", "whole.talus.json", {"--to", "tic", "-o", path("out.tic")});
  EXPECT_EQ(answer.status, 1);
  EXPECT_THAT(answer.err, HasSubstr("out.tic.talus.json: error: was changed since it was exported"));
  EXPECT_EQ(bytes_of("out.tic.talus.json"), "mine");
}

TEST_F(CliCompanions, AreNotWrittenOver) {
  const std::string before = bytes_of("game.tic.talus.json");
  for (const auto& [command, options] :
       {std::pair<std::string, std::vector<std::string>>{"import", {}}, {"export", {"--to", "native"}}}) {
    std::vector<std::string> words = options;
    words.insert(words.end(), {"-o", path("game.tic.talus.json")});
    const CliAnswer answer = run(command, "game.tic", words);
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.err, HasSubstr("is the name of the companion of game.tic beside it"));
  }
  // Commands that read the companion do not replace it either, under any of its names.
  const std::string cart = bytes_of("game.tic");
  for (const char* input : {"game.tic", "game.tic.talus.json"}) {
    for (const char* output : {"game.tic", "game.tic.talus.json"}) {
      const CliAnswer answer = run("sim", input, {"--frames", "1", "--trace", path(output)});
      EXPECT_EQ(answer.status, 1);
      EXPECT_THAT(answer.err, HasSubstr(path(output) + ": error: "));
    }
  }
  EXPECT_EQ(bytes_of("game.tic"), cart);
  EXPECT_EQ(bytes_of("game.tic.talus.json"), before);
}

TEST_F(CliCompanions, ImportedPicturesChangeTheCartAlone) {
  const std::string companion = bytes_of("game.tic.talus.json"), cart = path("game.tic");
  put("in.png", rgb_png(8, std::vector<Rgb>(64, default_palette()[5])));
  const CliAnswer answer = run("import", "in.png", {"--into", cart, "--part", "sprites", "-o", cart});
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_FALSE(exists("game.tic.talus-kept1.json"));
  const auto loaded = load_level(cart);
  EXPECT_EQ(loaded->note, "") << "they fit";
  EXPECT_EQ(loaded->level.spawns, level_.spawns);
  EXPECT_EQ(loaded->level.sheet(SheetId::sprites).images[0][5], 5);
}

TEST_F(CliCompanions, CompanionsThatDoNotFitAreReportedOnce) {
  put("game.tic.talus.json", "{");
  const CliAnswer answer = run("sim", "game.tic", {"--frames", "1", "--hash"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(
      answer.err.find(path("game.tic") + ": warning: game.tic.talus.json is left as it is, and not read: "),
      0u)
      << answer.err;
}

}  // namespace talus::cli_companion_test
