// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// A game in the terminal: plays a level made with Talus, to the same doubles as the editor.
//   game [FILE [FRAMES [KEYS]]]
// FILE: a level or a TIC-80 cart; by default level.talus.json beside this file. Without FRAMES it plays at 60
// frames a second until Ctrl+C; with FRAMES it makes so many steps, shows the last one and prints its hash,
// which is that of `talus sim FILE --frames FRAMES --hash`. KEYS are what a player does, a letter for 10
// frames: l left, r right, j jump, L and R with a jump, others nothing; after the last one nothing is held.
#include <talus/formats/format.h>
#include <talus/level/ground.h>
#include <talus/sim/solver.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace {

constexpr int kColumns = 78, kRows = 20;  // of the view, in tiles
constexpr std::size_t kFramesOfKey = 10;

// What the player holds in the step that leads to a frame, from 1.
talus::Input keys_at(const std::string& keys, std::int64_t frame) {
  const auto at = static_cast<std::size_t>(frame - 1) / kFramesOfKey;
  const char key = at < keys.size() ? keys[at] : '.';
  talus::Input input;
  input.left = key == 'l' || key == 'L';
  input.right = key == 'r' || key == 'R';
  input.jump = key == 'j' || key == 'L' || key == 'R';
  return input;
}

char letter_of(const talus::TileShape& shape) {
  if (shape.one_way) return '-';
  if (!has_heights(shape)) return '#';
  return shape.heights.front() < shape.heights.back() ? '/' : '\\';
}

// The part of the level around its first body, a character a tile.
std::string view_of(const talus::TileMap& map, const talus::Terrain& ground, const talus::State& state) {
  talus::Cell corner{0, 0};
  if (!state.bodies.empty()) {
    const talus::Rect& box = state.bodies.front().box;
    const talus::Cell at = map.cell_at(box.position());
    corner = {at.x - kColumns / 2, at.y - kRows / 2};
  }
  std::string view;
  for (int row = 0; row < kRows; ++row) {
    char letter = ' ';
    int tiles = 0;  // that the letter still takes: slopes may be several tiles wide
    for (int column = 0; column < kColumns; ++column) {
      const talus::Cell cell{corner.x + column, corner.y + row};
      talus::TileShape shape;
      if (ground.contains(cell)) shape = ground.shape_at(cell);
      if (shape.kind != talus::TileShape::Kind::none) letter = letter_of(shape), tiles = shape.tiles;
      view += tiles-- > 0 ? letter : ' ';
    }
    view += '\n';
  }
  for (const talus::Body& body : state.bodies) {
    const talus::Cell cell = map.cell_at({body.box.x + body.box.w / 2, body.box.y + body.box.h / 2});
    const int column = cell.x - corner.x, row = cell.y - corner.y;
    if (column < 0 || column >= kColumns || row < 0 || row >= kRows) continue;
    const auto at = static_cast<std::size_t>(row) * (kColumns + 1) + static_cast<std::size_t>(column);
    view[at] = talus::traits_of(body.kind).takes_keys ? '@' : 'o';
  }
  return view;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : LEVEL_FILE, keys = argc > 3 ? argv[3] : "";
  const auto loaded = talus::load_level(file);
  if (!loaded) {
    std::cerr << talus::to_string(loaded.error(), file) << '\n';
    return 1;
  }
  const auto scene = std::make_shared<const talus::Scene>(talus::compile_scene(loaded->level));
  const auto solver = talus::make_solver(scene);
  const talus::TileMap& map = loaded->level.map;
  const talus::Terrain ground = talus::terrain_of(loaded->level);  // to be shown, whichever solver it has
  talus::State state = talus::initial_state(*scene);

  if (argc > 2) {
    for (const int frames = std::atoi(argv[2]); state.frame < frames;)
      solver->step(state, keys_at(keys, state.frame + 1));
    std::cout << view_of(map, ground, state) << std::hex << talus::state_hash(state) << '\n';
    return 0;
  }
  for (auto due = std::chrono::steady_clock::now();; due += std::chrono::microseconds(16'667)) {
    std::this_thread::sleep_until(due);
    solver->step(state, keys_at(keys, state.frame + 1));
    std::cout << "\x1b[H\x1b[2J" << view_of(map, ground, state) << std::flush;
  }
}
