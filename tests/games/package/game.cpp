// Loads a level with the installed package and lets it run: game FILE FRAMES prints the hash of the last
// state.

#include <formats/format.h>
#include <sim/solver.h>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto loaded = talus::load_level(argv[1]);
  if (!loaded) {
    std::cerr << talus::to_string(loaded.error(), argv[1]) << '\n';
    return 1;
  }
  const auto scene = std::make_shared<const talus::Scene>(talus::compile_scene(loaded->level));
  const auto solver = talus::make_solver(scene);
  talus::State state = talus::initial_state(*scene);
  for (int i = 0; i < std::atoi(argv[2]); ++i) solver->step(state, {});
  std::cout << std::hex << talus::state_hash(state) << '\n';
}
