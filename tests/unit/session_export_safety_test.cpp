// Export presets that came with a file write nothing until the user allows them, and never outside the
// folder.
#include <fcntl.h>
#include <sys/stat.h>

#include "edit/export_presets.h"
#include "edit/level_settings.h"
#include "export/export_targets.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "paths.h"
#include "session/session.h"
#include "waiting.h"

namespace talus::session_export_safety_test {

namespace act = action;
namespace fs = std::filesystem;
using act::Answer;

class ForeignPresets : public FolderTest {
 protected:
  void SetUp() override {
    fs::create_directories(path("level"));
    start();
  }
  void start() {
    session_ = std::make_unique<Session>(
        Level(), "", kUnnamed,
        ExportTools{[](const std::string& name) { return read_file(source_path("assets/") + name); },
                    path("state/exports"), path("state/allowed_exports")});
  }
  // Writes the level as somebody else would.
  std::string put_level(std::vector<ExportPreset> presets,
                        const std::string& name = "level/cave.talus.json") {
    Level level;
    level.exports = std::move(presets);
    EXPECT_TRUE(save_level(level, *find_format("native"), path(name)));
    return path(name);
  }
  void open(const std::string& file) { session().apply(act::OpenFile{file}); }
  Session& session() { return *session_; }
  std::string message() { return session().message() ? session().message()->text : ""; }
  void wait() { ASSERT_TRUE(exports_end(session())); }
  // Paints a stroke and saves, as by Ctrl+S.
  void paint_and_save() {
    const auto red = static_cast<std::uint8_t>(session().level().palette[3].r + 1);
    session().apply(act::EditLevel{set_color(session().level(), 3, Rgb{red, 2, 3})});
    session().apply(act::SaveFile{});
    wait();
  }
  void answer(Answer answer) {
    ASSERT_TRUE(session().question());
    session().apply(act::AnswerQuestion{answer});
    wait();
  }
  bool asks() { return session().question() && session().question()->kind == Question::Kind::allow_exports; }
  // The files in the folder besides the level.
  std::set<std::string> written(const std::string& folder = "level") {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      const std::string name = entry.path().lexically_relative(path(folder)).string();
      if (name != "cave.talus.json") names.insert(name);
    }
    return names;
  }

  const ExportPreset data_{
      .name = "data", .exporter = "lua", .path = "out/a.lua", .on_save = true, .extra = ""};
  std::unique_ptr<Session> session_;
};

TEST_F(ForeignPresets, WriteNothingUntilTheUserAllowsTheirFiles) {
  const std::string file = put_level({data_});
  open(file);
  EXPECT_FALSE(session().allows_export(0));
  paint_and_save();
  EXPECT_TRUE(written().empty());
  ASSERT_TRUE(asks());
  ASSERT_NE(session().asked_exports(), nullptr);
  ASSERT_EQ(session().asked_exports()->outcomes.size(), 1u);
  EXPECT_EQ(session().asked_exports()->outcomes[0].files.at(0).path, path("level/out/a.lua"));
  answer(Answer::allow);
  EXPECT_EQ(written(), (std::set<std::string>{"out", "out/a.lua"}));
  EXPECT_NE(message().find("Exported data: 1 file to out/a.lua."), std::string::npos) << message();
  paint_and_save();
  EXPECT_FALSE(session().question());
  start();  // another start of the program
  open(file);
  EXPECT_TRUE(session().allows_export(0));
  paint_and_save();
  EXPECT_FALSE(session().question());
}

TEST_F(ForeignPresets, AreNotAskedAboutAtEachSave) {
  ExportPreset own = data_;
  own.name = "own";
  own.path = "out/own.lua";
  const std::string file = put_level({data_});
  open(file);
  session().apply(act::EditLevel{add_export(session().level(), own)});
  paint_and_save();
  ASSERT_TRUE(asks());
  EXPECT_TRUE(written().empty()) << "all are asked about first";
  answer(Answer::cancel);
  EXPECT_EQ(written(), (std::set<std::string>{"out", "out/own.lua"})) << "the user's own is written";
  paint_and_save();
  EXPECT_FALSE(session().question());
  EXPECT_NE(message().find("Not exported, as you have not allowed it: data."), std::string::npos)
      << message();
  EXPECT_EQ(written(), (std::set<std::string>{"out", "out/own.lua"}));
  session().apply(act::RunExports{});  // by hand it asks again
  wait();
  EXPECT_TRUE(asks());
  start();
  open(file);
  EXPECT_FALSE(session().allows_export(0));
  EXPECT_TRUE(session().allows_export(1)) << "his own, across a save and a start";
}

TEST_F(ForeignPresets, SayThatACartBringsTheLevelsOwnCode) {
  const auto question_of = [&](const std::string& exporter, bool has_cart) {
    Level level;
    level.exports = {
        {.name = "cart", .exporter = exporter, .path = "out/a.lua", .on_save = true, .extra = ""}};
    if (exporter == "tic") level.exports[0].path = "out/a.tic";
    if (has_cart)
      level.cart = std::make_shared<const CartOrigin>(
          CartOrigin{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = "-- script: lua\ntrace(1)\n"});
    EXPECT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
    start();
    open(path("level/cave.talus.json"));
    paint_and_save();
    return asks() ? session().question()->text : "no question";
  };
  const std::string plain =
      "These exports came with the level's file. Nothing of them is written until you allow it.";
  const std::string warning =
      plain +
      "\nThe TIC-80 carts among them bring the level's own code, which TIC-80 runs when you open them.";
  EXPECT_EQ(question_of("tic-text", true), warning);
  EXPECT_EQ(question_of("tic", true), warning);
  EXPECT_EQ(question_of("tic-text", false), plain);
  EXPECT_EQ(question_of("tic-text-playable", true), plain) << "its code is a game of Talus's";
  EXPECT_EQ(question_of("lua", true), plain);
}

TEST_F(ForeignPresets, AreNamedInALineOfAMessage) {
  ExportPreset named = data_;
  named.name = "da\nta" + std::string(300, 'x');
  open(put_level({named}));
  paint_and_save();
  ASSERT_TRUE(asks());
  answer(Answer::cancel);
  EXPECT_NE(
      message().find("Not exported, as you have not allowed it: da\\nta" + std::string(92, 'x') + "...."),
      std::string::npos)
      << message();
}

TEST_F(ForeignPresets, AddNoLineToAMessageByTheirPath) {
  ExportPreset forged = data_;
  forged.path = "a\nSaved everything.lua";
  open(put_level({forged}));
  paint_and_save();
  ASSERT_TRUE(asks());
  answer(Answer::allow);
  wait();
  EXPECT_NE(message().find("1 file to a\\nSaved everything.lua"), std::string::npos) << message();
  EXPECT_EQ(message().find("\nSaved everything"), std::string::npos) << message();
}

TEST_F(ForeignPresets, AreForeignAgainAfterAForeignChange) {
  const std::string file = put_level({data_});
  open(file);
  paint_and_save();
  answer(Answer::allow);
  const auto changes = [&](auto change) {
    ExportPreset changed = data_;
    change(changed);
    put_level({changed});
    open(file);
    EXPECT_FALSE(session().allows_export(0));
    paint_and_save();
    EXPECT_TRUE(asks());
    answer(Answer::cancel);
  };
  changes([](ExportPreset& p) { p.path = "out/b.lua"; });
  changes([](ExportPreset& p) { p.exporter = "sti"; });
  changes([](ExportPreset& p) { p.parts = "pairs"; });
  changes([](ExportPreset& p) { p.name = "other"; });
  changes([](ExportPreset& p) { p.extra = R"({"run":"me"})"; });
  EXPECT_EQ(written(), (std::set<std::string>{"out", "out/a.lua"}));
  put_level({data_}, "level/copy.talus.json");
  open(path("level/copy.talus.json"));
  EXPECT_FALSE(session().allows_export(0)) << "another file";
  put_level({data_});
  open(file);
  EXPECT_TRUE(session().allows_export(0)) << "as it was allowed";
}

// The change comes while the level is open, and with the edit that reads the file again.
TEST_F(ForeignPresets, AreForeignAfterAnotherProgramChangesTheFile) {
  const std::string file = put_level({});
  open(file);
  put_level({data_});
  session().apply(act::CheckFile{});
  ASSERT_EQ(session().level().exports.size(), 1u) << "it was read again";
  EXPECT_FALSE(session().allows_export(0));
  session().apply(act::Undo{});
  session().apply(act::Redo{});
  EXPECT_FALSE(session().allows_export(0)) << "a redone edit is not allowed either";
  paint_and_save();
  EXPECT_TRUE(asks());
  EXPECT_TRUE(written().empty());
}

TEST_F(ForeignPresets, FromMapsRecordingsAndAutosavesAreForeign) {
  Level level;
  level.exports = {data_};
  const ReadAsset none;
  const auto exported = find_exporter("tmj")->make({level, "map.tmj", none});
  ASSERT_TRUE(exported);
  ASSERT_TRUE(write_exported(*find_exporter("tmj"), *exported, path("map.tmj")));
  const auto saved_as = [&](const std::string& name) {
    EXPECT_EQ(session().level().exports.size(), 1u);
    session().apply(act::SaveFileAs{path("level/" + name)});
    wait();
    EXPECT_TRUE(asks()) << name;
    EXPECT_FALSE(exists("level/out"));
    answer(Answer::cancel);
  };
  open(path("map.tmj"));
  if (!session().level().exports.empty()) saved_as("a.talus.json");
  Recording recording;
  recording.level = level;
  ASSERT_TRUE(save_recording(recording, path("run.talusrec")));
  open(path("run.talusrec"));
  saved_as("b.talus.json");
  session().apply(act::NewLevel{});
  session().apply(act::RecoverLevel{std::make_shared<const Level>(level), "", "saved"});
  saved_as("c.talus.json");
}

TEST_F(ForeignPresets, StayInTheFolderOfTheLevel) {
  fs::create_directories(path("home"));
  fs::create_symlink(path("home"), path("level/link"));
  fs::create_directories(path("level/export"));
  fs::create_symlink("../../home/init.lua", path("level/export/level.lua"));  // dangling
  fs::create_symlink("../home/init.lua", path("level/data.lua"));
  ASSERT_EQ(::mkfifo(path("level/pipe.lua").c_str(), 0600), 0);
  const std::vector<std::pair<const char*, std::string>> outside = {{"lua", "../home/init.lua"},
                                                                    {"lua", path("home/init.lua")},
                                                                    {"lua", "link/init.lua"},
                                                                    {"lua", "data.lua"},
                                                                    {"lua-runtime", "export"},
                                                                    {"lua-runtime", "../home"},
                                                                    {"csv", "link"},
                                                                    {"lua", "pipe.lua"},
                                                                    {"lua", "export/../../home/init.lua"}};
  std::vector<ExportPreset> presets;
  for (const auto& [exporter, to] : outside)
    presets.push_back({.name = to, .exporter = exporter, .path = to, .on_save = true, .extra = ""});
  open(put_level(presets));
  const std::set<std::string> before = written();
  paint_and_save();
  EXPECT_FALSE(session().question()) << "there is nothing to allow";
  EXPECT_TRUE(written("home").empty());
  EXPECT_EQ(written(), before);
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  for (const ExportOutcome& outcome : session().exporting().last_run()) {
    ASSERT_TRUE(outcome.problem) << outcome.task.preset.path;
    EXPECT_EQ(outcome.problem->is_outside, outcome.task.preset.path != "pipe.lua")
        << outcome.task.preset.path;
    EXPECT_TRUE(outcome.files.empty()) << "the files are not even looked at";
  }
  // A change by the user that keeps the path does not allow the path.
  ExportPreset renamed = session().level().exports[0];
  renamed.name = "mine";
  session().apply(act::EditLevel{set_export(session().level(), 0, renamed, "Rename")});
  EXPECT_TRUE(session().allows_export(0));
  session().apply(act::RunExports{0});
  wait();
  EXPECT_TRUE(written("home").empty());
}

// The link is put there between the check and the write.
TEST_F(ForeignPresets, ALinkPutInTheirWayLaterStopsThem) {
  fs::create_directories(path("home"));
  open(put_level({data_}));
  paint_and_save();
  ASSERT_TRUE(asks());
  fs::create_symlink(path("home"), path("level/out"));
  answer(Answer::allow);
  EXPECT_TRUE(written("home").empty());
  const Exporter& exporter = *find_exporter("lua-runtime");
  const Exported content{{{"level.lua", "x", false}}, {}};
  EXPECT_FALSE(write_exported(exporter, content, path("level/out"), nullptr,
                              bounds_of_level(path("level/cave.talus.json"))));
  EXPECT_TRUE(written("home").empty());
}

TEST_F(ForeignPresets, NeverReplaceTheLevelItself) {
  ExportPreset own = data_;
  own.exporter = "native";
  own.path = "alias.talus.json";
  const std::string file = put_level({own});
  fs::create_hard_link(file, path("level/alias.talus.json"));
  open(file);
  session().apply(act::RunExports{});
  wait();
  ASSERT_TRUE(session().message());
  EXPECT_NE(message().find("is the level's own file"), std::string::npos) << message();
  EXPECT_FALSE(session().question());
}

TEST_F(ForeignPresets, APathTypedByTheUserMayLeaveTheFolder) {
  fs::create_directories(path("game"));
  const std::string file = put_level({data_});
  open(file);
  session().apply(act::SetExportPath{0, "../game/a.lua"});
  EXPECT_TRUE(session().allows_export(0));
  paint_and_save();
  EXPECT_FALSE(session().question());
  EXPECT_TRUE(exists("game/a.lua"));
  start();
  open(file);
  fs::remove(path("game/a.lua"));
  paint_and_save();
  EXPECT_TRUE(exists("game/a.lua")) << "it is remembered";
  // The permission holds for that place only.
  fs::create_directories(path("home"));
  fs::remove_all(path("game"));
  fs::create_symlink(path("home"), path("game"));
  paint_and_save();
  EXPECT_TRUE(written("home").empty());
  EXPECT_TRUE(session().message()->is_error);
}

TEST_F(ForeignPresets, AnAllowedPlaceOutsideIsAskedAboutOnce) {
  fs::create_directories(path("game"));
  ExportPreset preset = data_;
  preset.path = "../game/a.lua";
  open(put_level({preset}));
  session().apply(act::SetExportPath{0, preset.path});
  EXPECT_FALSE(session().modified()) << "nothing of the level has changed";
  EXPECT_FALSE(session().allows_export(0));
  paint_and_save();
  EXPECT_FALSE(exists("game/a.lua"));
  answer(Answer::allow);
  EXPECT_TRUE(exists("game/a.lua"));
}

// The paths are relative to the folder of the link, and stay there.
TEST_F(ForeignPresets, OfALinkedLevelStayBesideTheLink) {
  fs::create_directories(path("store"));
  put_level({data_}, "store/cave.talus.json");
  fs::create_symlink("../store/cave.talus.json", path("level/cave.talus.json"));
  open(path("level/cave.talus.json"));
  paint_and_save();
  answer(Answer::allow);
  EXPECT_TRUE(exists("level/out/a.lua"));
  EXPECT_TRUE(fs::is_symlink(path("level/cave.talus.json")));
  EXPECT_FALSE(exists("store/out"));
  ExportPreset preset = data_;
  preset.path = "../store/a.lua";
  put_level({preset}, "store/cave.talus.json");
  open(path("level/cave.talus.json"));
  paint_and_save();
  EXPECT_FALSE(session().question());
  EXPECT_FALSE(exists("store/a.lua"));
}

class ExportPermissionsFile : public FolderTest {
 protected:
  ExportPermissions opened(const std::string& level_file) const {
    ExportPermissions permissions(path("allowed"));
    permissions.open(level_file);
    return permissions;
  }
  static ExportPreset preset(const std::string& name, const std::string& extra = "") {
    return {.name = name, .exporter = "lua", .path = name + ".lua", .extra = extra};
  }
  // A preset that takes 60 KB in the store.
  static ExportPreset long_preset(const std::string& name) {
    return preset(name, R"({"x":")" + std::string(60'000, 'x') + "\"}");
  }
};

TEST_F(ExportPermissionsFile, KeepsAllowedPresetsOfFoldersOfAnyName) {
  for (const std::string name : {"d\xff", "line\nbreak", "\"quoted\""}) {
    fs::create_directories(path(name));
    const std::string file = path(name + "/cave.talus.json");
    const std::vector<ExportPreset> presets = {preset("a")};
    EXPECT_TRUE(opened(file).allow(presets));
    EXPECT_TRUE(opened(file).allows(presets[0])) << name;
    EXPECT_FALSE(opened(path("other/cave.talus.json")).allows(presets[0]));
  }
}

// The exports of a linked level go beside the link, which is another place.
TEST_F(ExportPermissionsFile, HoldsInTheFolderForWhichItWasGiven) {
  for (const char* name : {"own", "other"}) fs::create_directories(path(name));
  put("own/cave.talus.json", "{}");
  fs::create_symlink("../own/cave.talus.json", path("other/cave.talus.json"));
  fs::create_symlink("own", path("same"));
  const std::vector<ExportPreset> presets = {preset("a")};
  EXPECT_TRUE(opened(path("own/cave.talus.json")).allow(presets));
  EXPECT_TRUE(opened(path("own/cave.talus.json")).allows(presets[0]));
  EXPECT_TRUE(opened(path("same/cave.talus.json")).allows(presets[0])) << "the same folder";
  EXPECT_FALSE(opened(path("other/cave.talus.json")).allows(presets[0]));
  EXPECT_TRUE(opened(path("other/cave.talus.json")).allow(presets));
  EXPECT_TRUE(opened(path("other/cave.talus.json")).allows(presets[0]));
}

TEST_F(ExportPermissionsFile, ForgetsTheOldestBeforeItGrowsTooLarge) {
  const std::string file = path("level");
  const std::size_t count = ExportPermissions::kMaxKept / 60'000 + 10;
  {
    std::ofstream store(path("allowed"));
    for (std::size_t i = 0; i < count; ++i)
      store << R"({"allowed":true,"file":")" << path("other")
            << R"(","preset":{"name":"n","path":"p","to":"lua","x":")" << std::string(60'000, 'x')
            << "\"}}\n";
  }
  const std::vector<ExportPreset> first = {long_preset("a")}, second = {preset("b")};
  EXPECT_TRUE(opened(file).allow(first));
  EXPECT_TRUE(opened(file).allow(second));
  EXPECT_LE(fs::file_size(path("allowed")), ExportPermissions::kMaxKept);
  EXPECT_GT(fs::file_size(path("allowed")), ExportPermissions::kMaxKept / 2);
  EXPECT_TRUE(opened(file).allows(first[0]) && opened(file).allows(second[0])) << "the newest";
  const std::string kept = bytes_of("allowed");
  EXPECT_TRUE(opened(file).allow(first)) << "nothing has changed";
  EXPECT_EQ(bytes_of("allowed"), kept);
}

// Earlier versions did not limit its size.
TEST_F(ExportPermissionsFile, IsReadEvenIfItIsLargerThanAnyLevel) {
  fs::resize_file(put("allowed", "{}\n"), kMaxFileBytes + 1);
  const std::vector<ExportPreset> presets = {preset("a")};
  ASSERT_TRUE(opened(path("level")).allow(presets));
  EXPECT_TRUE(opened(path("level")).allows(presets[0]));
  EXPECT_LE(fs::file_size(path("allowed")), ExportPermissions::kMaxKept);
}

TEST_F(ExportPermissionsFile, SaysOnceWhatItCannotKeep) {
  const std::vector<ExportPreset> long_one = {
      preset("b", R"({"x":")" + std::string(ExportPermissions::kMaxBytes, 'x') + "\"}")};
  ExportPermissions permissions = opened(path("level"));
  const auto told = permissions.allow(long_one);
  ASSERT_FALSE(told);
  EXPECT_EQ(told.error(),
            "Cannot save which exports are allowed, so Talus will ask about them again: the preset b is "
            "longer than 64 KB.");
  EXPECT_TRUE(permissions.allow(long_one));
  EXPECT_FALSE(permissions.allow(std::vector<ExportPreset>{preset("c\xff")}));
}

TEST_F(ExportPermissionsFile, DamagedLinesAreLeftOutAndOthersKept) {
  const ExportPreset a{.name = "a", .exporter = "lua", .path = "a.lua", .extra = ""};
  const ExportPreset long_one{.name = "b",
                              .exporter = "lua",
                              .path = "b.lua",
                              .extra = "{\"x\":\"" + std::string(ExportPermissions::kMaxBytes, 'x') + "\"}"};
  ExportPermissions first = opened(path("level"));
  const std::vector<ExportPreset> both = {a, long_one};
  first.allow(both);
  std::ofstream(path("allowed"), std::ios::app) << "{\"file\":1}\nnonsense\n[]\n{}\n";
  EXPECT_TRUE(opened(path("level")).allows(a));
  EXPECT_FALSE(opened(path("level")).allows(long_one)) << "it is asked about again";
  const std::vector<ExportPreset> other = {{.name = "c", .exporter = "lua", .path = "c.lua", .extra = ""}};
  ExportPermissions second = opened(path("level"));
  second.allow(other);
  EXPECT_TRUE(opened(path("level")).allows(a));
  EXPECT_TRUE(opened(path("level")).allows(other[0]));
}

}  // namespace talus::session_export_safety_test
