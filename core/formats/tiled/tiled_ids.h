// TiledIds: numbers for new objects or layers of a map.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace talus {

class TiledIds {
 public:
  // used: the numbers that are taken, in any order. next: what the map says that the next one gets; it may be
  // wrong.
  TiledIds(std::vector<std::int64_t> used, std::int64_t next);

  int take();
  // What the map has to say as the next number; nothing if none was taken.
  std::optional<int> next() const { return has_taken_ ? std::optional<int>(next_) : std::nullopt; }

 private:
  std::vector<std::int64_t> used_;  // sorted
  int next_ = 1;
  bool has_taken_ = false;
};

}  // namespace talus
