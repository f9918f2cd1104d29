// Words for edits, by the kind of their changes.
#include "edit_text.h"

#include <algorithm>

#include <talus/level/tuning.h>
#include "level/level_text.h"
#include "panels/sprites/tile_number.h"

namespace talus {
namespace {

constexpr std::size_t kMaxFields = 2;  // of a tuning change; so many are named

// "Paint tiles" with the number in its middle, "Fill rectangle" with it at its end.
std::string with_count(const std::string& label, std::size_t count, const std::string& what) {
  const std::string plural = what + "s";
  if (label.ends_with(" " + plural))
    return label.substr(0, label.size() - plural.size()) + count_text(count, what);
  return label + ": " + count_text(count, what);
}

std::string describe_cells(const Edit& edit) {
  Cell from = std::get<CellChange>(edit.changes.front()).cell;
  std::size_t count = 0;
  for (const Change& change : edit.changes) {
    const CellChange* cell = std::get_if<CellChange>(&change);
    if (cell == nullptr) continue;
    from = {std::min(from.x, cell->cell.x), std::min(from.y, cell->cell.y)};
    ++count;
  }
  return with_count(edit.label, count, "tile") + " at (" + std::to_string(from.x) + ", " +
         std::to_string(from.y) + ")";
}

std::string number_of(SheetId sheet, int image) {
  return " of #" + std::to_string(number_on_screen(sheet, image));
}

std::string describe_tuning(const Edit& edit, const TuningChange& change) {
  if (change.before.solver != change.after.solver)
    return "Change the solver to " + std::string(solver_name(change.after.solver));
  std::string names;
  std::size_t count = 0;
  for (const TuningField& field : tuning_fields()) {
    if (field.of(change.before) == field.of(change.after)) continue;
    if (++count > kMaxFields) return edit.label;
    names += (names.empty() ? " " : ", ") + std::string(field.label);
  }
  return names.empty() ? edit.label : "Change" + names;
}

}  // namespace

std::string describe(const Edit& edit) {
  if (edit.changes.empty()) return edit.label;
  const Change& first = edit.changes.front();
  if (std::holds_alternative<CellChange>(first)) return describe_cells(edit);
  if (const auto* pixel = std::get_if<PixelChange>(&first)) {
    const auto count = std::count_if(edit.changes.begin(), edit.changes.end(),
                                     [](const Change& c) { return std::holds_alternative<PixelChange>(c); });
    return with_count(edit.label, static_cast<std::size_t>(count), "pixel") +
           number_of(pixel->sheet, pixel->tile);
  }
  if (const auto* look = std::get_if<TileLookChange>(&first)) {
    const auto count = std::count_if(edit.changes.begin(), edit.changes.end(), [](const Change& c) {
      return std::holds_alternative<TileLookChange>(c);
    });
    return (count > 1 ? with_count(edit.label, static_cast<std::size_t>(count), "tile") : edit.label) +
           number_of(look->sheet, look->tile);
  }
  if (const auto* flags = std::get_if<FlagsChange>(&first))
    return edit.label + number_of(flags->sheet, flags->tile);
  if (const auto* tuning = std::get_if<TuningChange>(&first)) return describe_tuning(edit, *tuning);
  return edit.label;
}

}  // namespace talus
