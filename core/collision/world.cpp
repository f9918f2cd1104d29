// World: items, their cells, projections and queries. The responses are in responses.cpp.
#include <talus/collision/world.h>

#include <cassert>
#include <cstdio>

#include "world_impl.h"

namespace talus {
namespace {

// After this many steps, all cells of the block around a segment replace its path through the grid.
constexpr std::int64_t kMaxSegmentSteps = std::int64_t{1} << 20;

// Entries of a cell that are passed in the time of one test, when an item leaves the cell.
constexpr std::int64_t kEntriesPerLook = 8;

// The number as Lua prints it.
std::string number_text(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.14g", v);
  return text;
}

// floor and ceil of a value within the range of int. The library's are calls on plain x86-64.
std::int32_t floor_int(double v) {
  const auto i = static_cast<std::int32_t>(v);
  return i - (i > v);
}
std::int32_t ceil_int(double v) {
  const auto i = static_cast<std::int32_t>(v);
  return i + (i < v);
}

bool is_cell(double v) { return v > -World::kMaxCell && v < World::kMaxCell; }

void check_size(double v, const char* name) {
  if (v <= 0) {
    throw WorldError(std::string(name) + " must be a positive integer, but was " + number_text(v) +
                     "(number)");
  }
}

[[noreturn]] void throw_too_far() {
  throw WorldError("A coordinate is infinite or lies beyond cell " + std::to_string(World::kMaxCell) +
                   " of the grid.");
}

}  // namespace

std::string item_not_added_message(std::string_view item) {
  return "Item " + std::string(item) +
         " must be added to the world before getting its rect. Use "
         "world:add(item, x,y,w,h) to add it first.";
}
std::string item_added_twice_message(std::string_view item) {
  return "Item " + std::string(item) + " added to the world twice.";
}
std::string unknown_response_message(std::string_view name) {
  return "Unknown collision type: " + std::string(name) + " (string)";
}

World::Impl::Impl(double size, Mode m)
    : cell_size(size),
      mode(m),
      responses{{"ignore", {}}, {"touch", {}}, {"cross", {}}, {"slide", {}}, {"bounce", {}}} {
  check_size(size, "cellSize");
  if (!(size <= kMaxCellSize)) throw WorldError("cellSize must be a finite number of pixels.");
}

std::uint32_t World::Impl::checked_slot(ItemId id) const {
  if (!has(id)) throw WorldError(item_not_added_message(std::to_string(id.index)));
  return id.index - 1;
}

void World::Impl::check_rect(const Rect& rect) const {
  check_size(rect.w, "w");
  check_size(rect.h, "h");
  if (mode == Mode::robust && !(std::isfinite(rect.x + rect.w) && std::isfinite(rect.y + rect.h))) {
    throw WorldError("x, y, w and h must be finite numbers.");
  }
}

CellRange World::Impl::cells_of(const Rect& rect) const {
  const double left = rect.x / cell_size;
  const double top = rect.y / cell_size;
  const double right = (rect.x + rect.w) / cell_size;
  const double bottom = (rect.y + rect.h) / cell_size;
  // No size is negative, so these four comparisons bound all numbers.
  if (!(left > -kMaxCell && top > -kMaxCell && right < kMaxCell && bottom < kMaxCell)) {
    if (std::isnan(left) || std::isnan(top) || std::isnan(right) || std::isnan(bottom)) return {};
    throw_too_far();
  }
  return {floor_int(left) + 1, floor_int(top) + 1, ceil_int(right), ceil_int(bottom)};
}

// Throws before it changes anything. Equal values stay as they were: -0 does not replace 0.
void World::Impl::place(std::uint32_t slot, const Rect& rect) {
  assert(depth == 0 && "a filter or response must not change the world");
  if (rects[slot] == rect) return;
  const CellRange cells = cells_of(rect);
  Item& item = items[slot];
  const std::int64_t covered_then = covered - item.cells.count() + cells.count();
  const std::int64_t most = kMaxCells + kMaxCellsOfItem * static_cast<std::int64_t>(items.size());
  if (covered_then > most && cells.count() > item.cells.count()) {
    throw WorldError("The items cover more than " + std::to_string(most) +
                     " cells of the grid: its cells are too small for them.");
  }
  if (!(cells == item.cells)) {
    looks += grid.remove(id_of(slot), item.cells) / kEntriesPerLook + cells.count();
    grid.insert(CellEntry::of(id_of(slot), item.group), cells);
    item.cells = cells;
    covered = covered_then;
  }
  rects[slot] = rect;
}

Collision World::Impl::collision(const Sweep& sweep, ItemId item, std::uint32_t slot, Response response,
                                 const SweepContact& contact) const {
  Collision hit;
  hit.item = item;
  hit.other = id_of(slot);
  hit.response = response;
  hit.overlaps = contact.overlaps;
  hit.ti = contact.ti;
  hit.move = sweep.d;
  hit.normal = contact.normal;
  hit.touch = contact.touch;
  hit.item_rect = sweep.box;
  hit.other_rect = rects[slot];
  return hit;
}

World::World(double cell_size, Mode mode) : impl_(std::make_unique<Impl>(cell_size, mode)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

ItemId World::add(Rect rect, int group) {
  assert(0 <= group && group < kGroupCount);
  Impl& w = *impl_;
  w.check_rect(rect);
  const bool reuse = !w.free_slots.empty();
  const auto slot = reuse ? w.free_slots.back() : static_cast<std::uint32_t>(w.items.size());
  if (!reuse) {
    w.items.emplace_back();
    w.rects.emplace_back();
  }
  w.items[slot].group = group;
  try {
    w.place(slot, rect);
  } catch (...) {
    if (!reuse) {
      w.items.pop_back();
      w.rects.pop_back();
    }
    throw;
  }
  if (reuse) w.free_slots.pop_back();
  Impl::Item& item = w.items[slot];
  item.serial = w.next_serial++;
  ++w.live;
  return w.id_of(slot);
}

void World::remove(ItemId item) {
  Impl& w = *impl_;
  assert(w.depth == 0 && "a filter or response must not change the world");
  const std::uint32_t slot = w.checked_slot(item);
  Impl::Item& removed = w.items[slot];
  w.free_slots.push_back(slot);
  w.grid.remove(item, removed.cells);
  w.covered -= removed.cells.count();
  const std::uint32_t generation = removed.generation == kMaxGeneration ? 1 : removed.generation + 1;
  removed = {};
  removed.generation = generation;
  w.rects[slot] = {};
  --w.live;
}

void World::update(ItemId item, Rect rect) {
  const std::uint32_t slot = impl_->checked_slot(item);
  impl_->check_rect(rect);
  impl_->place(slot, rect);
}

void World::update(ItemId item, Vec2 position) {
  const Rect& old = impl_->rects[impl_->checked_slot(item)];
  update(item, {position.x, position.y, old.w, old.h});
}

void World::project(ItemId item, Rect rect, Vec2 goal, Filter filter, std::vector<Collision>& hits) const {
  Impl& w = *impl_;
  w.check_rect(rect);
  hits.clear();
  const Sweep sweep(rect, goal);
  w.for_contacts(
      sweep, w.slot_of(item), [&](const CellEntry& entry) { return filter(item, entry.id()); },
      [&](std::uint32_t slot, Response response, const SweepContact& contact) {
        hits.push_back(w.collision(sweep, item, slot, response, contact));
      });
  w.sort_contacts(hits);
}

namespace {
constexpr auto kEveryItem = [](ItemId) { return true; };
}

void World::query_rect(Rect rect, std::vector<ItemId>& out) const { query_rect(rect, kEveryItem, out); }
void World::query_point(Vec2 point, std::vector<ItemId>& out) const { query_point(point, kEveryItem, out); }
void World::query_segment(Vec2 from, Vec2 to, std::vector<SegmentHit>& out) const {
  query_segment(from, to, kEveryItem, out);
}

void World::query_rect(Rect rect, ItemFilter filter, std::vector<ItemId>& out) const {
  Impl& w = *impl_;
  w.check_rect(rect);
  out.clear();
  w.for_candidates(w.cells_of(rect), Impl::kNoSlot, [&](std::span<const CellEntry> candidates) {
    for (const CellEntry& entry : candidates) {
      if (filter(entry.id()) && intersect(rect, w.rects[entry.index - 1])) out.push_back(entry.id());
    }
  });
  w.sort_by_age(out);
}

void World::query_point(Vec2 point, ItemFilter filter, std::vector<ItemId>& out) const {
  Impl& w = *impl_;
  out.clear();
  const double x = point.x / w.cell_size;
  const double y = point.y / w.cell_size;
  if (!is_cell(x) || !is_cell(y)) return;
  const Cell cell{floor_int(x) + 1, floor_int(y) + 1};
  const CellRange range{cell.x, cell.y, cell.x, cell.y};
  w.for_candidates(range, Impl::kNoSlot, [&](std::span<const CellEntry> candidates) {
    for (const CellEntry& entry : candidates) {
      if (filter(entry.id()) && contains(sides_of(w.rects[entry.index - 1]), point))
        out.push_back(entry.id());
    }
  });
  w.sort_by_age(out);
}

namespace {

// One axis of the walk along a segment: the time at which it enters the next cell, and the time from one cell
// to the next. bump's cell is one too far on both axes, which shows only in the rounding; this keeps it.
struct Walk {
  int step = 0;
  double delta = 0;
  double next = std::numeric_limits<double>::infinity();

  Walk(double cell_size, std::int32_t cell, double from, double to) {
    const double v = to - from;
    if (v > 0) {
      step = 1;
      delta = cell_size / v;
      next = ((cell + v) * cell_size - from) / v;
    } else if (v < 0) {
      step = -1;
      delta = -cell_size / v;
      next = ((cell + v - 1) * cell_size - from) / v;
    }
  }
};

// Calls visit(x, y) for the cells that the segment touches, from `a` to `b`. Returns false if rounding has
// led past `b`, or if the way is too long: the caller must then take all cells around the segment.
template <class Visit>
bool walk_segment(double cell_size, Vec2 from, Vec2 to, Cell a, Cell b, Visit visit) {
  Walk wx(cell_size, a.x, from.x, to.x);
  Walk wy(cell_size, a.y, from.y, to.y);
  Cell at = a;
  visit(at.x, at.y);
  const auto left = [&] { return std::abs(std::int64_t{at.x} - b.x) + std::abs(std::int64_t{at.y} - b.y); };
  for (std::int64_t steps = std::min(left() + 2, kMaxSegmentSteps); left() > 1; --steps) {
    if (steps == 0) return false;
    if (wx.next < wy.next) {
      wx.next += wx.delta;
      at.x += wx.step;
    } else {
      if (wx.next == wy.next) visit(at.x + wx.step, at.y);
      wy.next += wy.delta;
      at.y += wy.step;
    }
    visit(at.x, at.y);
  }
  if (!(at == b)) visit(b.x, b.y);
  return true;
}

}  // namespace

void World::query_segment(Vec2 from, Vec2 to, ItemFilter filter, std::vector<SegmentHit>& out) const {
  Impl& w = *impl_;
  out.clear();
  const CellRange a = w.cells_of({from.x, from.y, 0, 0});
  const CellRange b = w.cells_of({to.x, to.y, 0, 0});
  if (std::isnan(from.x + from.y + to.x + to.y)) return;
  const Cell first{a.left, a.top};
  const Cell last{b.left, b.top};

  ScratchPool<std::uint32_t>::Lease slots(w.slots);
  const auto gather = [&](const CellRange& range) {
    w.for_candidates(range, Impl::kNoSlot, [&](std::span<const CellEntry> candidates) {
      for (const CellEntry& entry : candidates) slots->push_back(entry.index - 1);
    });
  };
  const bool walked = walk_segment(w.cell_size, from, to, first, last, [&](std::int32_t x, std::int32_t y) {
    gather({x, y, x, y});
  });
  if (!walked) {
    gather({std::min(first.x, last.x), std::min(first.y, last.y), std::max(first.x, last.x),
            std::max(first.y, last.y)});
  }
  std::sort(slots->begin(), slots->end());
  slots->erase(std::unique(slots->begin(), slots->end()), slots->end());

  ScratchPool<Impl::WeightedHit>::Lease found(w.segment_hits);
  const Vec2 d = to - from;
  for (const std::uint32_t slot : *slots) {
    if (!filter(w.id_of(slot))) continue;
    const Sides box = sides_of(w.rects[slot]);
    Clip cut{0, 1, {}};
    if (!clip_line(box, from, d, cut)) continue;
    if (!((0 < cut.ti1 && cut.ti1 < 1) || (0 < cut.ti2 && cut.ti2 < 1))) continue;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Clip line{-infinity, infinity, {}};
    clip_line(box, from, d, line);
    found->push_back({std::min(line.ti1, line.ti2),
                      w.items[slot].serial,
                      {w.id_of(slot), cut.ti1, cut.ti2, from + d * cut.ti1, from + d * cut.ti2}});
  }
  std::sort(found->begin(), found->end(), [](const Impl::WeightedHit& l, const Impl::WeightedHit& r) {
    return l.weight != r.weight ? l.weight < r.weight : l.serial < r.serial;
  });
  for (const Impl::WeightedHit& hit : *found) out.push_back(hit.hit);
}

void World::set_most_tests(std::int64_t count) { impl_->most_tests = std::max<std::int64_t>(count, 1); }
bool World::gave_up() const noexcept { return impl_->gave_up; }
std::int64_t World::looks() const noexcept { return impl_->looks; }

bool World::has(ItemId item) const noexcept { return impl_->has(item); }
Rect World::rect(ItemId item) const { return impl_->rects[impl_->checked_slot(item)]; }

void World::items(std::vector<ItemId>& out) const {
  out.clear();
  for (std::uint32_t slot = 0; slot < impl_->items.size(); ++slot) {
    if (impl_->items[slot].serial != 0) out.push_back(impl_->id_of(slot));
  }
  impl_->sort_by_age(out);
}

std::size_t World::item_count() const noexcept { return impl_->live; }
std::size_t World::cell_count() const noexcept { return impl_->grid.cell_count(); }
void World::collect_empty_cells() { impl_->grid.drop_empty_cells(); }
double World::cell_size() const noexcept { return impl_->cell_size; }

Cell World::to_cell(Vec2 point) const {
  const double x = point.x / impl_->cell_size;
  const double y = point.y / impl_->cell_size;
  if (!is_cell(x) || !is_cell(y)) throw_too_far();
  return {floor_int(x) + 1, floor_int(y) + 1};
}

Vec2 World::to_world(Cell cell) const {
  return {(cell.x - 1.0) * impl_->cell_size, (cell.y - 1.0) * impl_->cell_size};
}

}  // namespace talus
