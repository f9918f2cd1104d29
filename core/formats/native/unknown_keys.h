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
// Every kind whose unknown keys a level keeps. The readers refuse those of the others.
std::span<const KeyKind> key_kinds();

struct UnknownKey {
  std::string place;    // "spawns[0].naem"
  std::string problem;  // "is not known; did you mean "name"?"
};
// Unknown keys are kept, but nothing reads them: most are misspelt. More than kMaxUnknownListed are not
// listed. A key that is known, but not for what the object is, such as the radius of a line, is one, too.
inline constexpr std::size_t kMaxUnknownListed = 100;
std::vector<UnknownKey> unknown_keys(const Level& level);

}  // namespace talus
