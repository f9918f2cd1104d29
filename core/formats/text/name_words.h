// The words of a name that a person gave: of a layer, a value or an entity.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

inline constexpr std::size_t kMaxNameBytesRead = 256;  // of a name, that are looked at

// Its words in small letters: "One_Way wall2" and "OneWayWall2" become "one", "way", "wall2". A plural of
// more than three letters loses its s.
std::vector<std::string> name_words(std::string_view name);

}  // namespace talus
