// The keys of native levels, by the kind of object that has them, and those of a level that are none of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/level/level.h>

namespace talus {

struct KeyKind {
  std::string_view name;  // the same as in assets/talus.schema.json: "spawn"
  std::vector<std::string_view> keys;
};
// Every kind, also those whose unknown keys the readers refuse.
std::span<const KeyKind> key_kinds();

struct UnknownKey {
  std::string place;    // "spawns[0].naem"
  std::string problem;  // "is not known; did you mean "name"?"
};
// Unknown keys are kept, but nothing reads them: most are misspelt. More than kMaxUnknownListed are not
// listed. A key that is known, but not for what the object is, such as the radius of a line, is one, too.
inline constexpr std::size_t kMaxUnknownListed = 100;
std::vector<UnknownKey> unknown_keys(const Level& level);
// Those of a file that is refused, as a misspelt key is often what its error misses. Empty if it is not JSON,
// a companion, or of a newer version. What is known, but not used, is not listed.
std::vector<UnknownKey> unknown_keys_of_file(std::string_view bytes);

}  // namespace talus
