// Games in Lua that steer their world: bodies come and go, have keys of their own, sense others, and say what
// they touch.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "export/lua_level.h"
#include "export/lua_parts.h"
#include "export/lua_runtime.h"
#include "folder_test.h"
#include "paths.h"
#include "unit/meeting_run.h"
#include "unit/program_output.h"

namespace talus::lua_steer_test {

class LuaSteer : public FolderTest {
 protected:
  // What a program prints that has a level in `level`, and its world in `world`: the same in both Luas.
  std::string printed(const Level& level, const std::string& program,
                      std::string_view parts = "players,balls,pairs,steer") {
    std::vector<std::string> texts;
    for (const std::string& file : lua_part_files(lua_parts(level, parts).value()))
      texts.push_back(bytes_of(source_path("assets/runtime/") + file + ".lua"));
    put("talus.lua", join_lua(texts));
    put("level.lua", lua_level(level));
    put("program.lua",
        "local talus, level = require 'talus', require 'level'\nlocal world = talus.new(level)\n" + program);
    const std::string in_folder = "cd '" + folder_.string() + "' && ";
    const std::string out = output_of(in_folder + "lua5.3 program.lua 2>&1");
    EXPECT_EQ(output_of(in_folder + "luajit program.lua 2>&1"), out);
    return out;
  }
};

// A room of 16x12 tiles of 8 px, with a floor at y 88.
Level room() {
  Level level = room_level(16, 12, 0.2);
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::block);
  return level;
}

TEST_F(LuaSteer, IdsOfBodiesThatAreGoneAreNotGivenAgain) {
  EXPECT_EQ(printed(room(), R"(
for i = 1, 3 do world:add {kind = "ball", x = 20 * i, y = 40} end
for _, body in ipairs(world.bodies) do
  io.write(body.id, " ")
  if body.id ~= 2 then world:remove(body) end
end
world:add {kind = "ball", x = 60, y = 40}
for _, body in ipairs(world.bodies) do io.write(body.id, " ") end
print()
local function tell(call, ...) print((select(2, pcall(call, world, ...)):gsub('^.*lua:%d+: ', ''))) end
local gone = world.bodies[1]
world:remove(gone)
tell(world.remove, gone)
tell(world.remove, nil)
tell(world.bodies_in, 1, 2, 3)
)"),
            "1 2 3 2 4 \nthe ball 2 is not in the world\nnil is not in the world\n"
            "a box is four numbers, x, y, w and h in px, not 1, 2, 3 and nil\n");
}

TEST_F(LuaSteer, AnErrorNamesTheKindsThatAreThere) {
  EXPECT_EQ(printed(room(), R"(print(pcall(world.add, world, {kind = "typo", x = 0, y = 0})))"),
            "false\tno kind \"typo\"; this level has ball, crate, disc, marble, player\n");
}

TEST_F(LuaSteer, ErrorsOfAddNameWhatIsWrong) {
  EXPECT_EQ(printed(room(), R"(
level.kinds.bare, level.kinds.odd = {rule = "still", foot = "box"}, {rule = "walk", w = 8, h = 8}
local function tell(body) print((select(2, pcall(world.add, world, body)):gsub('^.*lua:%d+: ', ''))) end
tell(nil)
tell {x = 1, y = 2}
tell {kind = "ball", y = 2}
tell {kind = "bare", x = 1, y = 2, h = 8}
tell {kind = "ball", x = 1, y = "up"}
tell {kind = "odd", x = 1, y = 2}
tell {kind = "ball", x = 1, y = 2, foot = "toe"}
tell {kind = "player", x = 1, y = 2, run_speed = "fast"}
print(#world.bodies, (select(2, pcall(function() world:add {kind = "typo"} end)):match('^program.lua:%d+:')))
)"),
            "a body is a table with kind, x and y, not nil\n"
            "no kind \"nil\"; this level has ball, bare, crate, disc, marble, odd, player\n"
            "x of a ball is a number of px, not nil\n"
            "w of a bare is a number of px, not nil\n"
            "y of a ball is a number of px, not up\n"
            "the kind \"odd\" has the rule \"walk\"; the rules are fall, run and still\n"
            "the foot of a ball is box or centre, not toe\n"
            "run_speed of a player is a number of px, not fast\n"
            "0\tprogram.lua:14:\n");
}

TEST_F(LuaSteer, SensorsNeedNoPartForBodiesThatBlock) {
  EXPECT_EQ(printed(room(), R"(
level.kinds.coin = {rule = "still", w = 8, h = 8, foot = "box"}
local function coin(x) return world:add {kind = "coin", x = x, y = 40, sensor = true} end
coin(40)
local ball = world:add {kind = "ball", x = 40, y = 20}
print(coin(80).id, #world.bodies)
print((select(2, pcall(world.add, world, {kind = "ball", x = 60, y = 20})):match('takes the part pairs')))
for _ = 1, 90 do world:step() end
print(#world.bodies, ball.y > 79)
)",
                    "balls,steer"),
            "3\t3\ntakes the part pairs\n3\ttrue\n");
}

TEST_F(LuaSteer, KindsAndBodiesHaveTheirOwnRunSpeed) {
  EXPECT_EQ(printed(room(), R"(
level.kinds.slow = {rule = "run", w = 8, h = 8, foot = "box", run_speed = 0.5}
local slow = world:add {kind = "slow", x = 30, y = 80, input = {right = true}}
local slower = world:add {kind = "slow", x = 60, y = 80, run_speed = 0.25, input = {right = true}}
local player = world:add {kind = "player", x = 80, y = 72}
for _ = 1, 10 do world:step {right = true} end
print(slow.vx, slower.vx, player.vx > 1, world.tuning.run_speed == level.tuning.run_speed)
)"),
            "0.5\t0.25\ttrue\ttrue\n");
}

TEST_F(LuaSteer, TheFloorEndsAhead) {
  Level level = room();
  for (int row = 9; row < 11; ++row) level.map.set({6, row}, level.map.at({0, 0}));
  EXPECT_EQ(printed(level, R"(
local ball = world:add {kind = "ball", x = 48, y = 64}
local function ahead(x, y, ...) ball.x, ball.y = x, y; return world:floor_ahead(ball, ...) end
print(ahead(48, 64, "left"), ahead(48, 64, "right"), ahead(47, 64, "right"))
print(ahead(48, 64, "right", 15), ahead(48, 64, "right", 17), ahead(40, 80, "right"), ahead(40, 80, "left"))
print(pcall(world.floor_ahead, world, ball, "floor"))
)"),
            "false\tfalse\ttrue\nfalse\ttrue\ttrue\ttrue\nfalse\tno side \"floor\"; the sides are left "
            "and right\n");
}

// The crates above fall, to the bit as in the program, where the lowest one is erased.
TEST_F(LuaSteer, TheRestOfAStackFallsWhenOneIsRemoved) {
  Level level = room_level(16, 12, 0.2);
  for (int i = 1; i <= 3; ++i) add_body(level, BodyKind::crate, {40.0 + i, 88 - 8.0 * i});
  MeetingRun run(level);
  run.step(60);
  run.state.bodies.erase(run.state.bodies.begin());
  std::string expected;
  for (int frame = 0; frame < 30; ++frame) {
    run.step();
    for (const Body& body : run.state.bodies) {
      char text[80];
      std::snprintf(text, sizeof text, "%d %a %a\n", body.id, body.box.y, body.velocity.y);
      expected += text;
    }
  }
  EXPECT_EQ(run.body(0).box.y, 80) << "it has fallen onto the floor";
  EXPECT_EQ(printed(level, R"(
for _ = 1, 60 do world:step() end
world:remove(world.bodies[1])
for _ = 1, 30 do
  world:step()
  for _, b in ipairs(world.bodies) do print(("%d %a %a"):format(b.id, b.y, b.vy)) end
end
)"),
            expected);
}

TEST_F(LuaSteer, EachBodyMayHaveKeysOfItsOwn) {
  EXPECT_EQ(printed(room(), R"(
level.kinds.enemy = {rule = "run", w = 8, h = 8, foot = "box"}
local player = world:add {kind = "player", x = 60, y = 72}
local idle = world:add {kind = "enemy", x = 90, y = 80}
local walker = world:add {kind = "enemy", x = 40, y = 80, input = {left = true}}
for _ = 1, 10 do world:step {right = true} end
print(player.x > 61, idle.x == 90, walker.x < 39)
)"),
            "true\ttrue\ttrue\n");
}

TEST_F(LuaSteer, SensorsStopNobodyAndFindWhoIsThere) {
  const std::string program = R"(
level.kinds.coin = {rule = "still", w = 8, h = 8, foot = "box"}
local coin = world:add {kind = "coin", x = 40, y = 40, sensor = true}
local wall = world:add {kind = "coin", x = 80, y = 60}
local ball, other = world:add {kind = "ball", x = 40, y = 8}, world:add {kind = "ball", x = 80, y = 8}
local ghost = world:add {kind = "ball", x = 83, y = 8, sensor = true}
local found, seen = {}, 0
for _ = 1, 120 do
  world:step()
  for _, body in ipairs(world:bodies_in(coin.x, coin.y, coin.w, coin.h, found)) do
    if body == ball then seen = seen + 1 end
  end
end
print(coin.y == 40, wall.y == 60, ball.y > 79, other.y < 60, ghost.y > 79, seen > 0, #found)
)";
  Level level = room();
  EXPECT_EQ(printed(level, program), "true\ttrue\ttrue\ttrue\ttrue\ttrue\t1\n");
  let_bodies_meet(level.tuning, 0.2, 0);
  EXPECT_EQ(printed(level, program), "true\ttrue\ttrue\ttrue\ttrue\ttrue\t1\n");
}

TEST_F(LuaSteer, ABodySaysWhatItTouches) {
  EXPECT_EQ(
      printed(room(), R"(
local low = world:add {kind = "player", x = 9, y = 72}
for _ = 1, 20 do world:step {left = true} end
print(low.touched.left, low.touched.right, low.touched.floor, world:cell_beside(low, "left"))
print(world:cell_beside(low, "floor"))
print(world:cell_beside(low, "right"), pcall(world.cell_beside, world, low, "top"))
local on_it = world:add {kind = "ball", x = 9, y = 40}
local was_hit = false
for _ = 1, 120 do
  world:step()
  was_hit = was_hit or on_it.touched.floor == low
end
print(was_hit, on_it.grounded)
)"),
      "true\tnil\ttrue\t0\t9\n1\t11\nnil\tfalse\tno side \"top\"; the sides are floor, ceiling, left and "
      "right\ntrue\ttrue\n");
}

}  // namespace talus::lua_steer_test
