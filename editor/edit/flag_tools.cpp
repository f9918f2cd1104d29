// Paints flags, and changes fields.
#include "flag_tools.h"

#include <algorithm>
#include <cassert>

#include "flag_lamps.h"
#include "level/single_change.h"

namespace talus {
namespace {

constexpr FlagSet kAllFlags = ~FlagSet{0};

std::set<int> tiles_of(const Level& level, const SpriteArea& area) {
  std::set<int> tiles;
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) tiles.insert(area.tile_at(level, x, y));
  }
  return tiles;
}

std::string paint_label(FlagPattern pattern, bool on) {
  const int lowest = pattern.lowest_flag();
  if (pattern == pattern_of_flag(lowest)) return (on ? "Set flag " : "Clear flag ") + std::to_string(lowest);
  return on ? "Set flags" : "Clear flags";
}

// Fields in the order of their flags, so that files and panels list them alike.
Edit put_fields(const Level& level, std::vector<FlagField> fields, std::string label) {
  std::sort(fields.begin(), fields.end(),
            [](const FlagField& a, const FlagField& b) { return a.first < b.first; });
  return single_change(std::move(label), FlagFieldsChange{level.flag_fields, std::move(fields)});
}

}  // namespace

Edit paint_flags(const Level& level, SheetId sheet, const std::set<int>& tiles, FlagPattern pattern,
                 bool on) {
  Edit edit{paint_label(pattern, on), {}};
  const FlagPattern painted{pattern.mask, on ? pattern.bits : FlagSet{0}};
  for (const int tile : tiles) {
    const FlagSet before = level.sheet(sheet).flags[static_cast<std::size_t>(tile)];
    const FlagSet after = painted.put_in(before);
    if (before != after) edit.changes.emplace_back(FlagsChange{sheet, tile, before, after});
  }
  return edit;
}

Edit paint_flags(const Level& level, const SpriteArea& area, FlagPattern pattern, bool on) {
  return paint_flags(level, area.sheet, tiles_of(level, area), pattern, on);
}

bool stroke_sets(FlagPattern pattern, FlagSet flags) { return pattern.bits == 0 || !pattern.matches(flags); }

Edit set_all_flags(const Level& level, const SpriteArea& area, FlagSet flags) {
  Edit edit = paint_flags(level, area, {kAllFlags, flags}, true);
  edit.label = "Set all flags";
  return edit;
}

std::optional<FlagSet> common_flags(const Level& level, const SpriteArea& area, FlagSet mask) {
  const AreaFlags flags = flags_in(level, area);
  return (flags.any & mask) == (flags.all & mask) ? std::optional(flags.all & mask) : std::nullopt;
}

Edit set_flag_field(const Level& level, std::size_t index, FlagField field) {
  std::vector<FlagField> fields = level.flag_fields;
  assert(index <= fields.size() && !problem_of(field));
  const bool is_new = index == fields.size();
  std::string label = (is_new ? "Make a field of flags " : "Change the field of flags ") +
                      std::to_string(field.first) + " to " + std::to_string(field.last());
  if (is_new)
    fields.push_back(std::move(field));
  else
    fields[index] = std::move(field);
  assert(!overlapping_field(fields));
  return put_fields(level, std::move(fields), std::move(label));
}

Edit remove_flag_field(const Level& level, std::size_t index) {
  std::vector<FlagField> fields = level.flag_fields;
  assert(index < fields.size());
  fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(index));
  return put_fields(level, std::move(fields), "Take a field of flags apart");
}

}  // namespace talus
