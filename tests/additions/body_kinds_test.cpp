// Two kinds of bodies more, by a row each: a barrel, which falls, and a runner, which runs by the keys. Games
// in Lua and in C move them as the program does, to the last bit, and they look the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <imgui.h>

#include <filesystem>
#include <memory>

#include <talus/c/talus.h>
#include <talus/sim/solver.h>
#include "export/exporter.h"
#include "panels/inspector/spawn_inspector.h"
#include "paths.h"
#include "sim/frame_hash.h"
#include "unit/cli_answer.h"
#include "unit/folder_test.h"
#include "unit/native_text.h"
#include "unit/program_output.h"

namespace talus::body_kinds_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kFrames = 240;
const std::string kGames = source_path("tests/games/");

// A barrel, a runner and a ball tile above a floor with a slope, as large as a screen of TIC-80.
Level level_with_kinds() {
  return level_of_native(native_with(R"("tuning": {"solver": "exact"},
    "tiles": {"1": {"shape": {"kind": "solid"},
                    "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"},
              "2": {"shape": {"kind": "slope", "heights": [0, 8]},
                    "pixels": "0000000d 000000dd 00000ddd 0000dddd 000ddddd 00dddddd 0ddddddd dddddddd"},
              "3": {"flags": [1],
                    "pixels": "00444400 04444440 44444444 44400444 44400444 44444444 04444440 00444400"}},
    "spawns": [{"x": 16, "y": 20, "kind": "barrel"}, {"x": 40, "y": 100, "kind": "runner"}],
    "map": {"width": 30, "height": 17, "rows": ["", "", "", "", "", "", "", "", "", "", "000000000000000003",
            "", "", "", "", "00000000000000000201",
            "010101010101010101010101010101010101010101010101010101010101"]})"));
}

// With a body that the level file does not have: games add it, by its kind and place alone.
Level level_with_another_barrel() {
  Level level = level_with_kinds();
  const BodyKind barrel = level.spawns[0].kind;
  level.spawns.push_back({.name = "", .position = {100, 30}, .velocity = {}, .extra = "", .kind = barrel});
  level.spawns.back().size = traits_of(barrel).size;
  return level;
}

class AddedBodyKinds : public FolderTest {
 protected:
  void SetUp() override {
    put_level("level.talus.json", level_with_kinds());
    put("keys.jsonl", R"({"frame":20,"keys":["right"]}
{"frame":90,"keys":["right","jump"]}
{"frame":120,"keys":["left"]}
{"frame":160,"keys":[]}
)");
  }

  std::string put_level(const std::string& name, const Level& level) {
    return put(name, native_of_level(level));
  }
  void export_to(const std::string& exporter, const std::string& to) {
    const CliAnswer answer =
        cli_answer({"export", path("level.talus.json"), "--to", exporter, "-o", path(to)});
    ASSERT_EQ(answer.status, kExitGood) << answer.err;
  }
  // Writes what the program does with the level and the keys, as lines of JSON.
  void trace(const std::string& level, const std::string& keys) {
    const CliAnswer answer = cli_answer({"sim", path(level), "--frames", std::to_string(kFrames), "--input",
                                         path(keys), "--no-contacts", "--trace", path("trace.jsonl")});
    ASSERT_EQ(answer.status, kExitGood) << answer.err;
  }
  // What a command prints in the test's folder, its errors, too.
  std::string run(const std::string& command) {
    return output_of("cd '" + folder_.string() + "' && { " + command + "; } 2>&1");
  }
  void expect_trace(const std::string& printed, int bodies) {
    put("printed", printed);
    EXPECT_EQ(run("lua5.3 '" + kGames + "same_trace.lua' printed trace.jsonl"),
              std::to_string(bodies * kFrames) + " bodies compared, 0 differences\n")
        << printed.substr(0, 1000);
  }
  // Runs a game of LÖVE with more code at its end. Returns what it printed.
  std::string run_love(const std::string& game, const std::string& more) {
    put(game + "/main.lua", bytes_of(game + "/main.lua") +
                                "\nfunction love.errorhandler(problem) print(problem) os.exit(1) end\n" +
                                more);
    return output_of("XDG_DATA_HOME='" + folder_.string() +
                     "/saved' SDL_VIDEODRIVER=offscreen SDL_AUDIODRIVER=dummy timeout 600 love '" +
                     path(game) + "' 2>/dev/null");
  }
  // The picture of the play view at the start. Made by another process, as drivers of OpenGL keep memory.
  std::string picture(const Level& level, const std::string& name) {
    const std::string file = put_level("shown.talus.json", level);
    const pid_t child = ::fork();
    if (child == 0) ::_exit(cli_answer({"shot", file, "--zoom", "4", "-o", path(name)}).status);
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    return bytes_of(name);
  }
};

TEST_F(AddedBodyKinds, AreInTheHashesOfFrames) {
  State state = initial_state(compile_scene(level_with_kinds()));
  const auto changes = [&](std::size_t body) {
    State other = state;
    other.bodies[body].gait.coyote = 3;
    EXPECT_EQ(frame_hash(other) != frame_hash(state), state_hash(other) != state_hash(state));
    return frame_hash(other) != frame_hash(state);
  };
  EXPECT_FALSE(changes(1)) << "nothing of a barrel depends on keys";
  EXPECT_TRUE(changes(2)) << "a runner's next jump depends on it";
}

TEST_F(AddedBodyKinds, MoveInLuaAsInTheProgram) {
  ASSERT_NO_FATAL_FAILURE(export_to("lua-runtime", "game"));
  put("game/main.lua", R"(
local talus, level = require "talus", require "level"
local held_in, world = dofile(arg[1])(arg[2]), talus.new(level)
local barrel = world:add {kind = "barrel", x = 100, y = 30}
assert(barrel.w == 16 and barrel.h == 12 and barrel.foot == "centre")
for frame = 1, tonumber(arg[3]) do
  world:step(held_in(frame))
  for _, b in ipairs(world.bodies) do
    print(("%d %d %.17g %.17g %.17g %.17g"):format(frame, b.id, b.x, b.y, b.vx, b.vy))
  end
end
)");
  put_level("another.talus.json", level_with_another_barrel());
  ASSERT_NO_FATAL_FAILURE(trace("another.talus.json", "keys.jsonl"));
  for (const std::string lua : {"lua5.3", "luajit"}) {
    SCOPED_TRACE(lua);
    expect_trace(run("cd game && " + lua + " main.lua '" + kGames + "script.lua' ../keys.jsonl " +
                     std::to_string(kFrames)),
                 4);
  }
}

TEST_F(AddedBodyKinds, MoveInCartsAsInTheProgram) {
  ASSERT_NO_FATAL_FAILURE(export_to("tic-text-playable", "cart.lua"));
  ASSERT_NO_FATAL_FAILURE(trace("level.talus.json", "keys.jsonl"));
  expect_trace(
      run("lua5.3 '" + kGames + "tic80_play.lua' cart.lua " + std::to_string(kFrames) + " keys.jsonl"), 3);
}

TEST_F(AddedBodyKinds, MoveAndLookInLoveAsInTheProgram) {
  ASSERT_NO_FATAL_FAILURE(export_to("love", "game"));
  put("nothing.jsonl", "");
  ASSERT_NO_FATAL_FAILURE(trace("level.talus.json", "nothing.jsonl"));
  picture(level_with_kinds(), "game/shot.png");
  put("game/same_picture.lua", read_file(kGames + "same_picture.lua").value());
  const std::string printed = run_love("game", read_file(kGames + "love_look.lua").value() + R"(
local look = love.load
function love.load()
  look {}
  require "trace"(talus.new(level), )" + std::to_string(kFrames) +
                                                   ")\nend\n");
  EXPECT_THAT(printed, HasSubstr("the same picture"));
  expect_trace(printed, 3);
}

TEST_F(AddedBodyKinds, MoveInGamesWithBump) {
  ASSERT_NO_FATAL_FAILURE(export_to("bump", "game"));
  fs::copy(kGames + "bump_world.lua", path("game/bump.lua"));
  const std::string printed = run_love("game", R"(
local load = love.load
function love.keyboard.isDown(key) return key == "right" end
function love.load()
  load {}
  for _ = 1, 60 do love.update(1 / 60) end
  love.draw()
  for _, b in ipairs(bodies) do print(("%s of %dx%d, %s"):format(b.kind, b.w, b.h, b.vx > 0 and "runs" or "rests")) end
  love.event.quit()
end
)");
  EXPECT_THAT(printed, HasSubstr("ball of 8x8, rests\nbarrel of 16x12, rests\nrunner of 6x12, runs\n"));
}

TEST_F(AddedBodyKinds, MoveInCAsInTheProgram) {
  char error[200];
  const std::unique_ptr<talus_game, void (*)(talus_game*)> game(
      talus_open(path("level.talus.json").c_str(), error, sizeof error), talus_close);
  ASSERT_NE(game, nullptr) << error;
  const auto scene = std::make_shared<const Scene>(compile_scene(level_with_kinds()));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  Input right;
  right.right = true;
  for (int i = 0; i < kFrames; ++i) {
    solver->step(state, right, nullptr);
    ASSERT_EQ(talus_step(game.get(), TALUS_RIGHT, 0, 0, 0), 1);
    ASSERT_EQ(talus_hash(game.get()), state_hash(state)) << "frame " << i + 1;
  }
  talus_body barrel, runner;
  ASSERT_EQ(talus_body_at(game.get(), 1, &barrel) + talus_body_at(game.get(), 2, &runner), 2);
  EXPECT_EQ(barrel.w, 16);
  EXPECT_STREQ(talus_kind_word(barrel.kind), "barrel");
  EXPECT_EQ(runner.w, 6);
  EXPECT_STREQ(talus_kind_word(runner.kind), "runner");
  EXPECT_GT(runner.x, 40);
}

TEST_F(AddedBodyKinds, AreDrawnByTheirLook) {
  const Level level = level_with_kinds();
  Level usual = level;
  usual.spawns[0].kind = BodyKind::ball;
  usual.spawns[1].kind = BodyKind::player;
  usual.spawns[1].foot = Foot::box;
  Level swapped = usual;
  swapped.spawns[0].kind = BodyKind::player;
  const std::string shown = picture(level, "added.png");
  EXPECT_EQ(shown.substr(0, 4), "\x89PNG");
  EXPECT_TRUE(shown == picture(usual, "usual.png")) << "a barrel looks like a ball, a runner like a player";
  EXPECT_FALSE(shown == picture(swapped, "swapped.png"));
}

// ---- The inspector ----

// A window with the inspector of one body, and a mouse.
class Window {
 public:
  explicit Window(const Level& level) : session_(level), context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    io.Fonts->AddFontDefault();
    io.Fonts->Build();
  }
  ~Window() { ImGui::DestroyContext(context_); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Presses and releases the left button on a control.
  void click(const std::string& name) {
    for (int i = 0; i < 2; ++i) draw();  // a list is hidden in its first frame, which measures it
    const Widget* widget = ui_.widgets.find(name);
    ASSERT_NE(widget, nullptr) << name;
    ImGui::GetIO().MousePos = widget->centre();
    for (const bool down : {false, true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      draw();
    }
  }
  const Level& level() const { return session_.level(); }

 private:
  void draw() {
    Actions actions;
    ImGui::NewFrame();
    {
      const UiFrame frame(ui_);
      ImGui::SetNextWindowSize({700, 400});
      ImGui::Begin("inspector");
      inspector_.draw(session_, 0, actions, ui_);
      ImGui::End();
    }
    ImGui::Render();
    session_.apply(actions);
  }

  Session session_;
  Ui ui_;
  SpawnInspector inspector_;
  ImGuiContext* context_;
};

TEST_F(AddedBodyKinds, AreInTheListOfTheInspector) {
  Window window(level_with_kinds());
  window.click("inspector/kind");
  window.click("inspector/kind_runner");
  EXPECT_EQ(traits_of(window.level().spawns[0].kind).word, "runner");
  window.click("inspector/kind");
  window.click("inspector/kind_barrel");
  EXPECT_EQ(traits_of(window.level().spawns[0].kind).word, "barrel");
}

}  // namespace talus::body_kinds_test
