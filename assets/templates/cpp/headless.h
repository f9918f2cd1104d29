// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Plays without a window, for tests of a game.
#pragma once

#include <string>

namespace game {

// Makes so many steps and prints the hash of the last one, which is that of `talus sim FILE --frames STEPS
// --hash`. keys: what a player does, a letter for 10 steps: l left, r right, j jump, L and R with a jump,
// others nothing; after the last one nothing is held. picture: the file for a picture of the last step, a
// BMP; empty: none. Whether all went well; if not, it was said why.
bool replay(const std::string& file, int steps, const std::string& keys, const std::string& picture);

}  // namespace game
