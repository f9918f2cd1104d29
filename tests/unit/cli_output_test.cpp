// No command replaces a file that it reads, or a file of another kind.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <talus/formats/format.h>
#include "cli/output_file.h"
#include "cli_answer.h"
#include "export/exporter.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "png_bytes.h"

namespace talus::cli_output_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliOutput : public FolderTest {
 protected:
  void SetUp() override {
    save("cave.talus.json");
    save("other.talus.json");
    save("game.tic");
    ASSERT_TRUE(save_recording(Recording(), path("run.talusrec")));
    put("picture.png", rgb_png(8, std::vector<Rgb>(64)));
    put("notes.txt", "of mine\n");
  }
  void save(const std::string& name) const {
    ASSERT_TRUE(save_level(level_, *format_for_file(name), path(name)));
  }
  // Other names of the level that the commands read: a link, a hard link, and another spelling.
  Words names_of_input(const std::string& ending) const {
    fs::create_symlink("cave.talus.json", path("link" + ending));
    fs::create_hard_link(path("cave.talus.json"), path("hard" + ending));
    return {path("link" + ending), path("hard" + ending), folder_.string() + "/./link" + ending};
  }
  // Expects that the command ends with an error about the file, and leaves the file as it is.
  void expect_refused(const Words& words, const std::string& file) {
    const auto before = read_file(file);
    const CliAnswer answer = cli_answer(words);
    EXPECT_EQ(answer.status, 1) << file << answer.err;
    EXPECT_THAT(answer.err, testing::StartsWith(file + ": error: "));
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_EQ(read_file(file).value_or("gone"), before.value_or("gone"));
  }

  Level level_;
};

TEST_F(CliOutput, ATraceReplacesOnlyTraces) {
  const std::string level = path("cave.talus.json");
  const auto trace_to = [&](const std::string& file) {
    return Words{"sim", level, "--frames", "2", "--trace", file};
  };
  expect_refused(trace_to(level), level);
  for (const std::string& name : names_of_input(".jsonl")) expect_refused(trace_to(name), name);
  for (const char* name : {"other.talus.json", "game.tic", "run.talusrec", "picture.png", "notes.txt"})
    expect_refused(trace_to(path(name)), path(name));
  for (const char* name : {"new.tic", "new.talus.json", "new.talusrec", "new.png", "new.tmx"}) {
    expect_refused(trace_to(path(name)), path(name));
    EXPECT_FALSE(exists(name));
  }
  put("keys.jsonl", "{\"frame\":1,\"mouse\":[1,2],\"down\":true}\n");
  Words with_input = trace_to(path("keys.jsonl"));
  with_input.insert(with_input.end(), {"--input", path("keys.jsonl")});
  expect_refused(with_input, path("keys.jsonl"));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(cli_answer(trace_to(path("t.jsonl"))).status, 0);
  EXPECT_THAT(bytes_of("t.jsonl"), testing::StartsWith("{\"frame\":1,"));
  EXPECT_EQ(cli_answer(trace_to("/dev/null")).status, 0);
  expect_refused({"sim", path("run.talusrec"), "--trace", path("game.tic")}, path("game.tic"));
}

TEST_F(CliOutput, ATraceReplacesNoInput) {
  put("keys.jsonl", "{\"frame\":1,\"mouse\":[1,2],\"down\":true}\n");
  const std::string keys = path("keys.jsonl");
  expect_refused({"sim", path("cave.talus.json"), "--frames", "2", "--trace", keys}, keys);
}

TEST_F(CliOutput, LargeFilesAreRecognisedToo) {
  const std::string trace = path("t.jsonl"), other = path("big.jsonl");
  const Words to_trace = {"sim", path("cave.talus.json"), "--frames", "2", "--trace", trace};
  ASSERT_EQ(cli_answer(to_trace).status, 0);
  put("big.jsonl", "of mine\n");
  for (const std::string& file : {trace, other}) fs::resize_file(file, kMaxFileBytes + 1);
  EXPECT_EQ(output_problem({other, kTraceBeginning, {}}),
            "exists, and is a file of another kind, which would be lost: name another file, or move it away");
  EXPECT_EQ(output_problem({trace, kTraceBeginning, {}}), "");
}

TEST_F(CliOutput, AFileThatCannotBeReadIsNotReplaced) {
  EXPECT_THAT(output_problem({"/proc/self/mem", kTraceBeginning, {}, true}),
              testing::StartsWith("exists, and its kind is not known, since it cannot be read: "));
}

TEST_F(CliOutput, AShotReplacesOnlyPictures) {
  const std::string level = path("cave.talus.json");
  const auto shot_to = [&](const std::string& file) { return Words{"shot", level, "-o", file}; };
  expect_refused(shot_to(level), level);
  for (const std::string& name : names_of_input(".png")) expect_refused(shot_to(name), name);
  for (const char* name : {"other.talus.json", "game.tic", "notes.txt"})
    expect_refused(shot_to(path(name)), path(name));
  for (const char* name : {"new.jpg", "new", "new.png.txt"}) {
    expect_refused(shot_to(path(name)), path(name));
    EXPECT_FALSE(exists(name));
  }
  const std::string picture = bytes_of("picture.png"), cart("\x04\x03\0\0\0\0\7", 7);
  put("cart.png",
      picture.substr(0, picture.size() - 12) + png_chunk("caRt", zipped(cart)) + png_chunk("IEND", ""));
  expect_refused(shot_to(path("cart.png")), path("cart.png"));
  put("text.png", "no picture");
  expect_refused(shot_to(path("text.png")), path("text.png"));
}

TEST_F(CliOutput, FilesThatALevelNamesAreNotReplaced) {
  ASSERT_EQ(cli_answer({"export", path("cave.talus.json"), "--to", "tmx", "-o", path("map.tmx")}).status, 0);
  const std::string picture = path("map-tiles.png");
  ASSERT_TRUE(exists("map-tiles.png"));
  fs::create_hard_link(picture, path("again.png"));
  for (const std::string& name : {picture, path("again.png")}) {
    expect_refused({"shot", path("map.tmx"), "-o", name}, name);
    expect_refused({"export", path("map.tmx"), "--to", "palette-png", "-o", name}, name);
  }
}

TEST_F(CliOutput, AnExportReplacesNoFileOfAnotherKind) {
  const std::string level = path("cave.talus.json");
  for (const Exporter& exporter : exporters()) {
    if (exporter.is_folder()) continue;
    const std::string ending = "." + std::string(exporter.extensions.front()), id(exporter.id);
    for (const std::string& name : names_of_input("-" + id + ending))
      expect_refused({"export", level, "--to", id, "-o", name}, name);
    fs::copy_file(path("run.talusrec"), path("run-" + id + ending));
    expect_refused({"export", level, "--to", id, "-o", path("run-" + id + ending)},
                   path("run-" + id + ending));
  }
  expect_refused({"export", level, "--to", "native", "-o", level}, level);
  fs::copy_file(path("game.tic"), path("x.json"));
  expect_refused({"export", level, "--to", "json", "-o", path("x.json")}, path("x.json"));
  EXPECT_EQ(cli_answer({"export", level, "--to", "tic", "-o", path("game.tic")}).status, 0) << "it is named";
}

TEST_F(CliOutput, AnImportReplacesOnlyLevels) {
  const std::string level = path("cave.talus.json");
  expect_refused({"import", level, "-o", level}, level);
  for (const std::string& name : names_of_input(".talus.json"))
    expect_refused({"import", level, "-o", name}, name);
  for (const char* name : {"game.tic", "picture.png"}) {
    fs::copy_file(path(name), path(std::string(name) + ".talus.json"));
    expect_refused({"import", level, "-o", path(std::string(name) + ".talus.json")},
                   path(std::string(name) + ".talus.json"));
  }
  const std::string picture = path("picture.png");
  expect_refused({"import", picture, "--into", level, "-o", path("run.talusrec")}, path("run.talusrec"));
  fs::create_hard_link(picture, path("p.talus.json"));
  expect_refused({"import", picture, "--into", level, "-o", path("p.talus.json")}, path("p.talus.json"));
  EXPECT_EQ(cli_answer({"import", picture, "--into", level, "-o", level}).status, 0)
      << "the level that is changed is named twice";
}

TEST_F(CliOutput, AReportReplacesOnlyReports) {
  fs::create_directories(path("report"));
  fs::create_symlink(path("cave.talus.json"), path("report/report.csv"));
  const std::string before = bytes_of("cave.talus.json");
  const CliAnswer answer = cli_answer({"report", "--moves", "20", "-o", path("report")});
  EXPECT_EQ(answer.status, 1);
  EXPECT_THAT(answer.err, HasSubstr("report.csv: error: exists, and is a Talus level, which would be lost"));
  EXPECT_EQ(bytes_of("cave.talus.json"), before);
  fs::remove(path("report/report.csv"));
  fs::create_hard_link(path("notes.txt"), path("report/report.md"));
  EXPECT_EQ(cli_answer({"report", "--moves", "20", "-o", path("report")}).status, 1);
  EXPECT_EQ(bytes_of("notes.txt"), "of mine\n");
  EXPECT_FALSE(exists("report/report.csv"));
  EXPECT_EQ(output_problem({path("notes.txt"), "scene,solver\n1", {}}),
            "exists, and is a file of another kind, which would be lost: name another file, or move it away");
  put("old.csv", "scene,solver\n2");
  EXPECT_EQ(output_problem({path("old.csv"), "scene,solver\n1", {}}), "");
}

TEST_F(CliOutput, KindsAreRecognisedByContent) {
  EXPECT_EQ(content_kind(bytes_of("cave.talus.json")), "Talus level");
  EXPECT_EQ(content_kind(bytes_of("game.tic")), "TIC-80 cartridge");
  EXPECT_EQ(content_kind(bytes_of("run.talusrec")), "recording");
  EXPECT_EQ(content_kind(bytes_of("picture.png")), "PNG picture");
  EXPECT_EQ(content_kind(bytes_of("notes.txt")), "");
  const std::string long_key = "{\"" + std::string(300, 'x') + "\":[{}],", blanks(300, ' ');
  EXPECT_EQ(content_kind(long_key + "\"talus\":1}"), "Talus level");
  EXPECT_EQ(content_kind(blanks + bytes_of("cave.talus.json")), "Talus level");
  EXPECT_EQ(content_kind(long_key + "\"talus_recording\":1}"), "recording");
  EXPECT_EQ(content_kind(R"({"keywords":["talus"],"about":{"talus":1}})"), "");
  for (const char* id : {"lua", "json", "c", "svg", "sti"}) {
    const CliAnswer answer = cli_answer({"export", path("cave.talus.json"), "--to", id, "-o", "-"});
    EXPECT_EQ(content_kind(answer.out), "") << id;
  }
}

}  // namespace talus::cli_output_test
