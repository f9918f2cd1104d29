// talus export with the presets of a level, and with --watch.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <mutex>
#include <set>
#include <sstream>
#include <thread>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "waiting.h"

namespace talus::cli_export_watch_test {

namespace fs = std::filesystem;

// A stream buffer that another thread may read.
class SharedText : public std::streambuf {
 public:
  std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 protected:
  int overflow(int c) override {
    const std::lock_guard lock(mutex_);
    text_ += static_cast<char>(c);
    return c;
  }

 private:
  std::mutex mutex_;
  std::string text_;
};

class CliPresets : public FolderTest {
 protected:
  // Saves a level with these presets and `tile` at (0, 0).
  void save(std::vector<ExportPreset> presets, TileNumber tile = 0) const {
    Level level;
    level.exports = std::move(presets);
    level.map.set({0, 0}, tile);
    ASSERT_TRUE(save_level(level, *find_format("native"), path("cave.talus.json")));
  }
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"export", path("cave.talus.json")});
    answer_ = cli_answer(words);
    return answer_.status;
  }

  CliAnswer answer_;
};

const std::vector<ExportPreset> kTwo = {{"cart", "tic", "out/a.tic", "", false, ""},
                                        {"text", "tic-text", "out/a.lua", "", false, ""}};

TEST_F(CliPresets, AllAreWrittenBesideTheLevel) {
  save(kTwo);
  EXPECT_EQ(run({"--all"}), 0) << answer_.err;
  EXPECT_EQ(answer_.err, "");
  EXPECT_TRUE(exists("out/a.tic"));
  EXPECT_TRUE(exists("out/a.lua"));
  const std::string size = std::to_string(fs::file_size(path("out/a.tic")));
  EXPECT_EQ(answer_.out.find(path("out/a.tic") + ": 1 file, " + size + " bytes, "), 0u) << answer_.out;
}

TEST_F(CliPresets, OneIsChosenByItsName) {
  save(kTwo);
  EXPECT_EQ(run({"--preset", "text"}), 0) << answer_.err;
  EXPECT_FALSE(exists("out/a.tic"));
  EXPECT_TRUE(exists("out/a.lua"));
}

TEST_F(CliPresets, ImpossiblePresetsAreErrors) {
  save(kTwo);
  EXPECT_EQ(run({"--preset", "game"}), 1);
  EXPECT_EQ(answer_.err, path("cave.talus.json") +
                             ": error: there is no preset \"game\"; the level has \"cart\", \"text\"\n");
  save({{"odd", "gameboy", "a.gb", "", false, ""}, {"own", "native", "cave.talus.json", "", false, ""}});
  EXPECT_EQ(run({"--all"}), 1);
  EXPECT_EQ(answer_.err, path("cave.talus.json") +
                             ":preset \"odd\": error: \"gameboy\" is not a target that this version knows\n" +
                             path("cave.talus.json") +
                             ":preset \"own\": error: this is the level's own file: choose another one\n");
  save({});
  EXPECT_EQ(run({"--all"}), 1);
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"--all", "--preset", "cart"}), 2);
  EXPECT_EQ(run({"--all", "--to", "tic"}), 2);
  EXPECT_EQ(run({"--watch", "--to", "tic", "-o", "-"}), 2);
}

class CliWatch : public CliPresets {
 protected:
  void watch(const std::vector<std::string>& words) { watch_file_of("cave.talus.json", words); }
  void watch_file_of(const std::string& file, std::vector<std::string> words) {
    words.insert(words.begin(), {"export", path(file), "--watch"});
    thread_ = std::thread([this, words] {
      std::ostream out(&out_text_), err(&err_text_);
      status_ = run_cli(words, out, err);
    });
  }
  void TearDown() override {
    if (thread_.joinable()) interrupt();
    CliPresets::TearDown();
  }
  // Sends SIGINT, as Ctrl+C does. Call it only after the command has written something: before that, the
  // signal would end the tests.
  void interrupt() {
    pthread_kill(thread_.native_handle(), SIGINT);
    thread_.join();
  }
  static std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  // Waits until there are `count` lines, and returns the text.
  static std::string wait_for(SharedText& text, std::size_t count) {
    EXPECT_TRUE(comes_true([&] { return lines(text.text()) >= count; })) << text.text();
    return text.text();
  }

  SharedText out_text_, err_text_;
  std::thread thread_;
  int status_ = -1;
};

TEST_F(CliWatch, ExportsAtOnceAndAfterEachSave) {
  save(kTwo);
  watch({"--preset", "cart"});
  wait_for(out_text_, 1);
  const std::string first = bytes_of("out/a.tic");
  ASSERT_NE(first, "(none)");

  // A reader of the output sees the old or the new file while it is replaced, never half of one.
  std::set<std::string> seen;
  std::atomic<bool> reads = true;
  std::thread reader([&] {
    while (reads) {
      seen.insert(bytes_of("out/a.tic"));
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  });
  save(kTwo, 1);  // by renaming, as this program saves
  wait_for(out_text_, 2);
  const std::string second = bytes_of("out/a.tic");
  // In place, as others do. The file is whole at any moment.
  std::fstream in_place(path("cave.talus.json"), std::ios::in | std::ios::out | std::ios::binary);
  in_place.seekp(static_cast<std::streamoff>(bytes_of("cave.talus.json").find("\"01\"") + 2))
      << '2' << std::flush;
  wait_for(out_text_, 3);
  const std::string third = bytes_of("out/a.tic");
  reads = false;
  reader.join();
  interrupt();
  EXPECT_EQ(status_, 0);
  EXPECT_NE(first, second);
  EXPECT_NE(second, third);
  EXPECT_THAT(seen, testing::IsSubsetOf(std::set<std::string>{first, second, third}));
  EXPECT_EQ(lines(out_text_.text()), 3u) << "one export for each: " << out_text_.text();
  EXPECT_EQ(err_text_.text(), "");
  const std::string line = out_text_.text().substr(0, out_text_.text().find('\n'));
  EXPECT_EQ(line.substr(line.size() - 3), " ms") << line;
  EXPECT_EQ(std::distance(fs::directory_iterator(path("out")), fs::directory_iterator()), 1)
      << "no temporary is left";
}

TEST_F(CliWatch, SeesTheCompanionOfACart) {
  Level level;
  level.map.set({0, 0}, 1);
  ASSERT_TRUE(save_level(level, *find_format("tic"), path("game.tic")));
  watch_file_of("game.tic", {"--to", "json", "-o", path("out.json")});
  wait_for(out_text_, 1);
  level.spawns.resize(1);
  level.spawns[0].name = "hero";
  auto saved = save_level(level, *find_format("tic"), path("game.tic"));
  ASSERT_TRUE(saved);
  const auto is_exported = [&](const std::string& name) {
    return bytes_of("out.json").find(name) != std::string::npos;
  };
  EXPECT_TRUE(comes_true([&] { return is_exported("hero"); }));
  level.spawns[0].name = "heroine";  // the cart stays the same
  ASSERT_TRUE(save_level(level, *find_format("tic"), path("game.tic"), saved->companion));
  EXPECT_TRUE(comes_true([&] { return is_exported("heroine"); }));
  fs::remove(path("game.tic.talus.json"));
  EXPECT_TRUE(comes_true([&] { return !is_exported("hero"); }));
  interrupt();
  EXPECT_EQ(err_text_.text(), "");
}

TEST_F(CliWatch, GoesOnAfterABadFile) {
  save({});
  watch({"--to", "tic", "-o", path("b.tic")});
  wait_for(out_text_, 1);
  fs::rename(put("bad", "{\"talus\": 1, \"palette\": 3}"), path("cave.talus.json"));
  EXPECT_EQ(wait_for(err_text_, 1),
            path("cave.talus.json") + ":key palette: error: must be a list of 16 colours\n");
  fs::remove(path("cave.talus.json"));
  const std::string gone = wait_for(err_text_, 2);
  EXPECT_NE(gone.find("does not exist; waiting for it\n"), std::string::npos) << gone;
  save({}, 5);
  wait_for(out_text_, 2);
  interrupt();
  EXPECT_EQ(status_, 0);
  const auto cart = load_level(path("b.tic"));
  ASSERT_TRUE(cart);
  EXPECT_EQ(cart->level.map.at({0, 0}), 5);
}

TEST_F(CliWatch, WaitsForAFileInThePlaceOfAPipe) {
  ASSERT_EQ(::mkfifo(path("cave.talus.json").c_str(), 0666), 0);
  watch({"--to", "tic", "-o", path("b.tic")});
  EXPECT_EQ(
      wait_for(err_text_, 1),
      path("cave.talus.json") + ": error: is a pipe; only regular files can be read; waiting for a file\n");
  // Long enough for several looks at the file. On a busy machine there are fewer, and the test holds as well.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  fs::remove(path("cave.talus.json"));
  save({}, 5);
  wait_for(out_text_, 1);
  interrupt();
  EXPECT_EQ(lines(err_text_.text()), 1u) << err_text_.text();
}

TEST_F(CliPresets, SigtermEndsAWatchThatWaitsForAPipe) {
  Level level;
  level.map = TileMap(300, 300);  // its JSON is larger than a pipe's buffer
  ASSERT_TRUE(save_level(level, *find_format("native"), path("cave.talus.json")));
  ASSERT_EQ(::mkfifo(path("out.json").c_str(), 0666), 0);
  const int reader = ::open(path("out.json").c_str(), O_RDONLY | O_NONBLOCK);
  const pid_t child = ::fork();
  if (child == 0) {
    run({"--watch", "--force", "--to", "json", "-o", path("out.json")});
    ::_exit(77);
  }
  int waiting = 0, status = 0;
  constexpr int kFull = 65'536;
  EXPECT_TRUE(comes_true([&] { return ::ioctl(reader, FIONREAD, &waiting) == 0 && waiting == kFull; }))
      << waiting;
  ::kill(child, SIGTERM);
  EXPECT_TRUE(comes_true([&] { return ::waitpid(child, &status, WNOHANG) != 0; }));
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
  ::kill(child, SIGKILL);
  ::close(reader);
}

TEST_F(CliWatch, KeepsStartersThatAreChangedMeanwhile) {
  save({});
  watch({"--to", "love", "-o", path("game"), "--fresh", "--force"});
  wait_for(out_text_, 1);
  std::ofstream(path("game/main.lua"), std::ios::binary) << "mine";
  save({}, 1);
  wait_for(err_text_, 1);
  interrupt();
  EXPECT_EQ(bytes_of("game/main.lua"), "mine") << "--fresh applies only to the first export";
  EXPECT_EQ(err_text_.text(),
            path("game/main.lua") + ": note: kept, as this file is yours now; --fresh writes it anew\n");
}

}  // namespace talus::cli_export_watch_test
