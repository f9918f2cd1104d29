// Words for places, lengths and roles in messages about a level.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <talus/level/level.h>

namespace talus {

std::string cell_text(Cell cell);  // "(12, 9)"
// A length or position in px, rounded to a millionth, without the zeros of a whole number.
std::string px_text(double px);
std::string count_text(std::size_t count, std::string_view noun);  // "1 cell", "3 cells"
std::string role_label(TileRole role);                             // "up-slope"
std::string role_with_article(TileRole role);                      // "an up-slope"
// Its name, as in: body "hero"; without a name as below.
std::string spawn_name(const Level& level, int index);
std::string kind_and_number(const Level& level, int index);  // "player 2", counted from 1 among all spawns

}  // namespace talus
