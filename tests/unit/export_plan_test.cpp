// Presets of exports: how a level keeps them, where their paths lead, what would be written, and writing it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "export/export_plan.h"
#include "folder_test.h"
#include "formats/tic80/tic_cart.h"
#include "native_text.h"

namespace talus::export_plan_test {

namespace fs = std::filesystem;

Level level_with(std::vector<ExportPreset> presets) {
  Level level;
  level.exports = std::move(presets);
  return level;
}

FormatResult<std::string> no_asset(const std::string& name) {
  return tl::unexpected(FormatError{name, "is missing"});
}

void expect_error(const std::string& exports, const std::string& place, const std::string& message) {
  expect_native_error(native_with("\"exports\": " + exports), place, message);
}

TEST(NativeExports, SurviveSavingAndReading) {
  const Level level = level_with({{"game", "love", "export/love", "pairs", true, R"({"colour":"red"})"},
                                  {"", "no-such-target", "/tmp/x y.zip", "", false, ""}});
  const auto text = native_of_level(level);
  EXPECT_NE(text.find(R"(
  "exports": [
    {"name": "game", "to": "love", "path": "export/love", "parts": "pairs", "on_save": true, "colour": "red"},
    {"name": "", "to": "no-such-target", "path": "/tmp/x y.zip"}
  ],)"),
            std::string::npos)
      << text;
  EXPECT_EQ(level_of_native(text), level) << "a target that is not known is kept";
  EXPECT_EQ(native_of_level(Level()).find("exports"), std::string::npos);
}

TEST(NativeExports, ErrorsNameThePlace) {
  expect_error("{}", "key exports", "must be a list of up to 100 presets");
  expect_error("[1]", "key exports[0]", "must be an object");
  expect_error(R"([{}, {"to": 1}])", "key exports[1].to", "must be a string of up to 4096 bytes");
  expect_error(R"([{"parts": []}])", "key exports[0].parts", "must be a string of up to 4096 bytes");
  expect_error(R"([{"on_save": 1}])", "key exports[0].on_save", "must be true or false");
  const auto written = write_native(level_with({{std::string(4097, 'a'), "love", "", "", false, ""}}), {});
  ASSERT_FALSE(written) << "it could not be read again";
  EXPECT_EQ(written.error().place, "key exports[0].name");
}

TEST(ExportPath, IsCountedFromTheLevelsFile) {
  const auto output = [](const std::string& path, const std::string& file) {
    return output_of({"", "love", path, "", false, ""}, file);
  };
  EXPECT_EQ(output("export/love", "/home/me/game/cave.talus.json"), "/home/me/game/export/love");
  EXPECT_EQ(output("../out/a.tmj", "/home/me/game/cave.talus.json"), "/home/me/out/a.tmj");
  EXPECT_EQ(output("/out", "/home/me/cave.talus.json"), "/out");
  EXPECT_EQ(output("/out", ""), "/out");
  EXPECT_EQ(output("out", "cave.talus.json"), "out");
  EXPECT_EQ(output("", "/home/cave.talus.json").error().error.message,
            "the path is empty: name a file or a folder");
  EXPECT_EQ(output(std::string(".bashrc\0.lua", 12), "/home/cave.talus.json").error().error.message,
            "has a NUL character, which file names cannot have");
  EXPECT_EQ(output("out", "").error().field, ExportProblem::Field::path);
  EXPECT_EQ(output("./cave.talus.json", "/home/cave.talus.json").error().error.message,
            "this is the level's own file: choose another one");
}

TEST(ExportPath, OfACopyEndsAsThatOfALevel) {
  const auto output = [](const std::string& path) {
    return output_of({"", "native", path, "", false, ""}, "/home/cave.talus.json");
  };
  EXPECT_EQ(output("out/copy.talus.json"), "/home/out/copy.talus.json");
  for (const char* path : {"package.json", "a.talus.json/../package.json", "x.talus.json/"}) {
    ASSERT_FALSE(output(path)) << path;
    EXPECT_EQ(output(path).error().field, ExportProblem::Field::path);
  }
}

TEST(ExportPath, IsRelativeIfBothMoveTogether) {
  const std::string file = "/home/me/game/cave.talus.json";
  EXPECT_EQ(path_for("/home/me/game/export/love", file), "export/love");
  EXPECT_EQ(path_for("/home/me/site/map.csv", file), "../site/map.csv");
  EXPECT_EQ(path_for("/var/www/map.csv", file), "/var/www/map.csv");
  EXPECT_EQ(path_for("/home/me/map.csv", ""), "/home/me/map.csv");
}

TEST(ExportPath, FollowsTheTarget) {
  const Exporter &tic = *find_exporter("tic"), &text = *find_exporter("tic-text"),
                 &love = *find_exporter("love");
  EXPECT_EQ(usual_path(tic, "cave.talus.json"), "export/cave.tic");
  EXPECT_EQ(usual_path(tic, "cave.talus.json", 2), "export/cave-2.tic");
  EXPECT_EQ(usual_path(text, ""), "export/level-tic.lua");
  EXPECT_EQ(usual_path(love, "cave.talus.json", 3), "export/love-3");
  EXPECT_TRUE(is_usual_path("export/cave-2.tic", tic, "cave.talus.json"));
  EXPECT_TRUE(is_usual_path("", tic, "cave.talus.json"));
  EXPECT_FALSE(is_usual_path("export/cave-0.tic", tic, "cave.talus.json"));
  EXPECT_EQ(path_for_other("mine/a.b.tic", tic, text), "mine/a.b." + std::string(text.extensions[0]));
  EXPECT_EQ(path_for_other("mine/game", love, tic), "mine/game.tic");
}

class ExportPlans : public FolderTest {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
};

TEST_F(ExportPlans, SayWhatIsAtThePlace) {
  const std::string output = path("out/a.tic");
  auto plan = plan_export(Level(), "tic", output, no_asset);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->files.size(), 1u);
  EXPECT_EQ(plan->files[0].path, output);
  EXPECT_EQ(plan->files[0].name, "a.tic");
  EXPECT_EQ(plan->files[0].place, PlannedFile::Place::empty);
  EXPECT_FALSE(exists("out")) << "nothing is written yet";
  ASSERT_TRUE(write_plan(*plan));
  EXPECT_EQ(fs::file_size(output), plan->files[0].size);
  EXPECT_EQ(plan_export(Level(), "tic", output, no_asset)->files[0].place, PlannedFile::Place::same);
  put("out/a.tic", "mine");
  plan = plan_export(Level(), "tic", output, no_asset);
  EXPECT_EQ(plan->files[0].place, PlannedFile::Place::other);
  EXPECT_EQ(plan->files[0].old_size, 4u);
  EXPECT_EQ(plan->files[0].old, content_hash("mine"));
}

TEST_F(ExportPlans, SayWhichFieldIsWrong) {
  using Field = ExportProblem::Field;
  const auto problem = [&](const std::string& exporter, const std::string& output) {
    return plan_export(Level(), exporter, output, no_asset).error();
  };
  EXPECT_EQ(problem("gameboy", path("a.gb")).field, Field::target);
  EXPECT_EQ(problem("gameboy", path("a.gb")).error.message,
            "\"gameboy\" is not a target that this version knows");
  EXPECT_EQ(problem("tic", path("a.png.zip")).field, Field::path);
  EXPECT_EQ(problem("love", path("a")).field, Field::level);
  EXPECT_EQ(problem("love", path("a")).error.message, "is missing") << "of the asset";
  put("file", "");
  EXPECT_EQ(problem("tic", path("file/a.tic")).error.message,
            path("file") + " is a file, but must be a folder");
  fs::create_directory(path("dir.tic"));
  EXPECT_EQ(problem("tic", path("dir.tic")).error.message,
            path("dir.tic") + " is a folder, but must be a file");
}

const Exporter& folder_target() { return *find_exporter("love"); }

TEST_F(ExportPlans, AreWrittenAsAWhole) {
  put("a", "old a");
  fs::create_directory(path("b"));  // a folder at the place of a file
  const Exported content{.files = {{"a", "new a"}, {"b", "new b"}}, .dropped = {}};
  const auto written = write_exported(folder_target(), content, folder_.string());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().place, "b");
  EXPECT_EQ(bytes_of("a"), "old a");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"})) << "no temporary is left";
}

// A pipe without a reader would block the write for ever.
TEST_F(ExportPlans, AreNeverWrittenIntoAPipeThatAppearsMeanwhile) {
  const Exported content{.files = {{"a", std::string(200'000, 'a')}, {"b", "b"}}, .dropped = {}};
  for (const ExportBounds& bounds : {ExportBounds(), ExportBounds{folder_.string(), true}}) {
    for (const char* const late : {"a", "b"}) {
      int reader = -1;
      const auto put_pipe = [&](std::size_t files, std::size_t) {
        if (files != 1)
          return true;  // the first file is staged beside its place, and the second is not begun
        EXPECT_EQ(::mkfifo(path(late).c_str(), 0666), 0);
        reader = ::open(path(late).c_str(), O_RDONLY | O_NONBLOCK);
        return true;
      };
      const auto written = write_exported(folder_target(), content, folder_.string(), put_pipe, bounds);
      ASSERT_FALSE(written);
      EXPECT_EQ(to_string(written.error(), "x"),
                std::string("x:") + late + ": error: is a pipe, but must be a regular file");
      char byte = 0;
      EXPECT_LE(::read(reader, &byte, 1), 0);
      ::close(reader);
      fs::remove(path("a"));
      fs::remove(path("b"));
      EXPECT_EQ(names(), std::vector<std::string>()) << "no temporary is left";
    }
  }
}

TEST_F(ExportPlans, AreCancelledAsAWhole) {
  put("a", "old a");
  const Exported content{.files = {{"a", "new a"}, {"sub/b", "new b"}}, .dropped = {}};
  std::vector<std::size_t> bytes;
  for (std::size_t last = 0; last < 3; ++last) {
    bytes.clear();
    const auto written = write_exported(folder_target(), content, folder_.string(),
                                        [&](std::size_t files, std::size_t so_far) {
                                          bytes.push_back(so_far);
                                          return files < last;
                                        });
    ASSERT_FALSE(written);
    EXPECT_EQ(bytes_of("a"), "old a");
  }
  EXPECT_EQ(bytes, (std::vector<std::size_t>{0, 5, 10}));
  ASSERT_TRUE(write_exported(folder_target(), content, folder_.string()));
  EXPECT_EQ(bytes_of("a"), "new a");
  EXPECT_EQ(bytes_of("sub/b"), "new b");
}

TEST_F(ExportPlans, LeaveOutStartersThatTheUserHasChanged) {
  const ReadAsset read = [](const std::string& name) -> FormatResult<std::string> { return "-- " + name; };
  const auto is_none = [](const PlannedFile&) { return false; };
  const auto is_all = [](const PlannedFile&) { return true; };
  auto plan = plan_export(Level(), "love", path("game"), read);
  ASSERT_TRUE(plan);
  EXPECT_EQ(own_starters(*plan, is_none), std::vector<std::size_t>()) << "nothing is there yet";
  ASSERT_TRUE(write_plan(*plan));
  put("game/main.lua", "mine");
  put("game/level.lua", "mine, too");
  plan = plan_export(Level(), "love", path("game"), read);
  const std::size_t count = plan->files.size();
  EXPECT_TRUE(own_starters(*plan, is_all).empty());
  const auto own = own_starters(*plan, is_none);
  ASSERT_EQ(own.size(), 1u) << "conf.lua is as it would be written, and level.lua is no starter";
  EXPECT_EQ(plan->files[own[0]].name, "main.lua");
  leave_out(*plan, own);
  EXPECT_EQ(plan->files.size(), count - 1);
  EXPECT_EQ(plan->content.files.size(), count - 1);
  ASSERT_TRUE(write_plan(*plan));
  EXPECT_EQ(bytes_of("game/main.lua"), "mine");
  EXPECT_NE(bytes_of("game/level.lua"), "mine, too");
}

TEST(ExportCode, TooLargeForACartIsAProblem) {
  const Exporter& cart = *find_exporter("tic-playable");
  EXPECT_EQ(code_problem(cart, std::nullopt), "");
  EXPECT_EQ(code_problem(cart, 65'536), "");
  EXPECT_EQ(code_problem(cart, 65'537),
            "the code has 65,537 bytes, but TIC-80's free version allows only 65,536: use fewer shapes or "
            "kinds of bodies");
  EXPECT_EQ(code_problem(*find_exporter("lua-runtime"), 65'537), "") << "of a game in any Lua";
}

}  // namespace talus::export_plan_test
