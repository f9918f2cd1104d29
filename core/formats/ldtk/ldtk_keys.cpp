// Writes what tiles of LDtk are as numbers in a text, and reads them again.
#include "ldtk_keys.h"

#include <algorithm>
#include <charconv>

namespace talus {
namespace {

constexpr std::size_t kKeyHead = 2, kPartNumbers = 11;

// Nothing for other texts, and for too many numbers.
std::optional<std::vector<int>> numbers_of(const std::string& text) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (!numbers.empty() && *at++ != ' ') return std::nullopt;
    int number = 0;
    const auto [stopped, problem] = std::from_chars(at, end, number);
    if (problem != std::errc() || numbers.size() == kKeyHead + kMaxLdtkCellParts * kPartNumbers)
      return std::nullopt;
    numbers.push_back(number);
    at = stopped;
  }
  return numbers;
}

template <class Definition>
int index_of_uid(const std::vector<Definition>& definitions, int uid) {
  const auto found = std::find_if(definitions.begin(), definitions.end(),
                                  [&](const Definition& definition) { return definition.uid == uid; });
  return found == definitions.end() ? -1 : static_cast<int>(found - definitions.begin());
}

bool is_within(int number, int min, int max) { return number >= min && number <= max; }

// numbers: kPartNumbers of them.
std::optional<LdtkKey::Part> part_of(const int* numbers, const LdtkProject& project, TileSize tile) {
  constexpr int kOpaquePart = 255, kMaxFlips = 3, kMaxRgb = 0xffffff;
  LdtkKey::Part part;
  LdtkSource& source = part.source;
  source.tileset = numbers[0] == 0 ? -1 : index_of_uid(project.tilesets, numbers[0]);
  source.x = numbers[1];
  source.y = numbers[2];
  source.id = numbers[3];
  source.side = numbers[4];
  source.flips = numbers[5];
  source.opacity = numbers[6];
  source.rgb = static_cast<std::uint32_t>(numbers[7]);
  part.x = numbers[8];
  part.y = numbers[9];
  part.is_hidden = numbers[10] == 1;
  const bool is_good = (numbers[0] == 0 || source.tileset >= 0) &&
                       is_within(source.x, -kMaxLdtkPlace, kMaxLdtkPlace) &&
                       is_within(source.y, -kMaxLdtkPlace, kMaxLdtkPlace) && source.id >= 0 &&
                       is_within(source.side, 1, kMaxLdtkTileSide) && is_within(source.flips, 0, kMaxFlips) &&
                       is_within(source.opacity, 1, kOpaquePart) && is_within(numbers[7], 0, kMaxRgb) &&
                       is_within(part.x, 1 - source.side, tile.width - 1) &&
                       is_within(part.y, 1 - source.side, tile.height - 1) && is_within(numbers[10], 0, 1);
  return is_good ? std::optional(part) : std::nullopt;
}

}  // namespace

std::vector<std::string> ldtk_keys_of(const LdtkTiles& tiles, const LdtkProject& project) {
  std::vector<std::string> keys;
  keys.reserve(tiles.cells.size());
  for (const LdtkCell& cell : tiles.cells) {
    std::string& text = keys.emplace_back();
    if (cell.value.layer == LdtkCellValue::kNoCell) continue;
    const auto add = [&](int number) { text += (text.empty() ? "" : " ") + std::to_string(number); };
    add(cell.value.layer < 0 ? 0 : project.layers[static_cast<std::size_t>(cell.value.layer)].uid);
    add(cell.value.value);
    for (const LdtkPart& part : cell.parts) {
      const LdtkSource& source = tiles.sources[part.source];
      for (const int number :
           {source.tileset < 0 ? 0 : project.tilesets[static_cast<std::size_t>(source.tileset)].uid, source.x,
            source.y, source.id, source.side, source.flips, source.opacity, static_cast<int>(source.rgb),
            part.x, part.y, part.is_hidden ? 1 : 0})
        add(number);
    }
  }
  return keys;
}

std::optional<LdtkKey> read_ldtk_key(const std::string& text, const LdtkProject& project, TileSize tile) {
  const auto numbers = numbers_of(text);
  if (!numbers || numbers->size() < kKeyHead || (numbers->size() - kKeyHead) % kPartNumbers != 0)
    return std::nullopt;
  LdtkKey key;
  key.value = {index_of_uid(project.layers, (*numbers)[0]), (*numbers)[1]};
  if (key.value.value < 0) return std::nullopt;
  if (key.value.value == 0) key.value = {};
  for (std::size_t i = kKeyHead; i < numbers->size(); i += kPartNumbers) {
    const auto part = part_of(&(*numbers)[i], project, tile);
    if (!part) return std::nullopt;
    key.parts.push_back(*part);
  }
  return key;
}

}  // namespace talus
