// Merges part by part. Each part counts what both sides changed.
#include "merge.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <talus/level/limits.h>
#include "merge_groups.h"
#include "tile_look.h"

namespace talus {
namespace {

// Conflicts of levels that cannot be merged part by part.
constexpr const char* kTileSizes = "the size of the tiles";
constexpr const char* kTooMuch = "more than fits into one level";

std::vector<std::string> sorted_layer_names(const Level& level) {
  std::vector<std::string> names;
  for (const TileLayer& layer : level.layers.list) names.push_back(layer.name);
  std::sort(names.begin(), names.end());
  return names;
}

bool same_layer_order(const Level& a, const Level& b) {
  return std::equal(a.layers.list.begin(), a.layers.list.end(), b.layers.list.begin(), b.layers.list.end(),
                    [](const TileLayer& x, const TileLayer& y) { return x.name == y.name; });
}

// How the elements of a list became those of a changed one.
struct ListFate {
  std::vector<int> now;      // by element of the old list, its index in the new one; -1: it was removed
  std::vector<bool> is_new;  // by element of the new list
};

// Finds equal elements first, then those of one name, then those that stand at the same place.
template <class Element>
ListFate fate_of(const std::vector<Element>& before, const std::vector<Element>& after) {
  ListFate fate{std::vector<int>(before.size(), -1), std::vector<bool>(after.size(), true)};
  const auto match = [&](const auto& fits) {
    std::size_t next = 0;  // most lists keep their order, so the search begins behind the last one found
    for (std::size_t i = 0; i < before.size(); ++i) {
      for (std::size_t n = 0; n < after.size() && fate.now[i] < 0; ++n) {
        const std::size_t k = (next + n) % after.size();
        if (!fate.is_new[k] || !fits(i, k)) continue;
        fate.now[i] = static_cast<int>(k);
        fate.is_new[k] = false;
        next = k + 1;
      }
    }
  };
  match([&](std::size_t i, std::size_t k) { return before[i] == after[k]; });
  match([&](std::size_t i, std::size_t k) {
    return !before[i].name.empty() && before[i].name == after[k].name;
  });
  if (before.size() == after.size()) match([](std::size_t i, std::size_t k) { return i == k; });
  return fate;
}

class LevelMerger {
 public:
  LevelMerger(const Level& base, const Level& mine, const Level& theirs, MergeSide side)
      : base_(base), mine_(mine), theirs_(theirs), side_(side), merged_{theirs} {}
  // groups: of the layers, which the levels do not have themselves. chosen: the one of the side, with them.
  LevelMerger(const Level& base, const Level& mine, const Level& theirs, MergeSide side,
              const std::vector<GroupVersions>& groups, const Level& chosen)
      : LevelMerger(base, mine, theirs, side) {
    groups_ = &groups;
    chosen_ = &chosen;
  }

  MergedLevel merge();

 private:
  std::string reason_for_whole() const;
  std::string text_of_apart(const std::string& reason) const;
  void merge_parts();

  template <class T>
  const T& pick(const T& base, const T& mine, const T& theirs, int& conflicts) const {
    return pick_side(base, mine, theirs, side_, conflicts);
  }
  // The same for one part of the level that is taken as a whole. what: a phrase for the user.
  template <class T>
  void take_whole(T Level::*part, const char* what) {
    int conflicts = 0;
    merged_.level.*part = pick(base_.*part, mine_.*part, theirs_.*part, conflicts);
    if (conflicts > 0) merged_.conflicts.emplace_back(what);
  }
  template <class Element, class PickOne>
  std::vector<Element> merged_list(const std::vector<Element>& base, const std::vector<Element>& mine,
                                   const std::vector<Element>& theirs, int& conflicts,
                                   const PickOne& pick_one) const;
  template <class Element>
  void merge_list(std::vector<Element> Level::*part, const char* noun, const char* nouns);
  template <class Array>
  void merge_array(Array Level::*part, const char* noun, const char* nouns);
  void note(int conflicts, const char* noun, const char* nouns);

  // The same for a thing of a tile that not each side has; at least one of mine and theirs has it.
  template <class T>
  std::optional<T> pick_held(const std::optional<T>& base, const std::optional<T>& mine,
                             const std::optional<T>& theirs, int& conflicts) const {
    if (!mine || !theirs) return mine ? mine : theirs;
    return pick(base, mine, theirs, conflicts);
  }
  // Picks each of these members by itself; the others of `merged` stay.
  template <class Element, class... Part>
  void pick_parts(Element& merged, const Element& base, const Element& mine, const Element& theirs,
                  int& conflicts, Part... part) const {
    ((merged.*part = pick(base.*part, mine.*part, theirs.*part, conflicts)), ...);
  }
  void merge_spawns();
  void merge_objects();
  void merge_tilesets();
  void merge_tiles();
  bool merges_looks(SheetId id) const;
  void merge_looks(SheetId id, Sheet& sheet);
  void take_looks(SheetId id, Sheet& sheet);
  void merge_sheet(SheetId id, std::size_t count);
  int merged_count(int base, int mine, int theirs, int& conflicts) const;
  void merge_layers();
  void merge_groups();
  const Level& layer_order();
  bool has_lost_layer(const Level& order, const Level& other) const;
  TileLayer merged_look(const Level& order, int layer, int& conflicts) const;
  MapCells merged_cells(const Level& order, int layer, const TileMap& map, int& conflicts) const;
  int lost_cells(const Level& changed, int layer, int base_layer, const TileMap& map) const;
  void fit_tiles();
  void fit_curves();

  const Level& base_;
  const Level& mine_;
  const Level& theirs_;
  const MergeSide side_;
  MergedLevel merged_;
  const std::vector<GroupVersions>* groups_ = nullptr;  // null: there are none
  const Level* chosen_ = nullptr;                       // null: mine_ or theirs_
};

void LevelMerger::note(int conflicts, const char* noun, const char* nouns) {
  if (conflicts > 0)
    merged_.conflicts.push_back(std::to_string(conflicts) + " " + (conflicts == 1 ? noun : nouns));
}

// The order is theirs; what was added here follows. pick_one: as pick(), for an element that both have.
template <class Element, class PickOne>
std::vector<Element> LevelMerger::merged_list(const std::vector<Element>& base,
                                              const std::vector<Element>& mine,
                                              const std::vector<Element>& theirs, int& conflicts,
                                              const PickOne& pick_one) const {
  constexpr std::size_t kMax = 8192;  // each is compared with each
  const bool is_large = std::max({base.size(), mine.size(), theirs.size()}) > kMax;
  if (is_large || mine == theirs || theirs == base || mine == base)
    return pick(base, mine, theirs, conflicts);
  const ListFate here = fate_of(base, mine), there = fate_of(base, theirs);
  std::vector<int> base_of(theirs.size(), -1);
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (there.now[i] >= 0) base_of[static_cast<std::size_t>(there.now[i])] = static_cast<int>(i);
  }
  std::vector<Element> all;
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    if (base_of[k] < 0) {
      all.push_back(theirs[k]);
      continue;
    }
    const auto i = static_cast<std::size_t>(base_of[k]);
    if (here.now[i] >= 0) {
      all.push_back(pick_one(base[i], mine[static_cast<std::size_t>(here.now[i])], theirs[k], conflicts));
    } else if (!(theirs[k] == base[i])) {  // removed here, changed there
      ++conflicts;
      if (side_ == MergeSide::theirs) all.push_back(theirs[k]);
    }
  }
  for (std::size_t i = 0; i < base.size(); ++i) {
    const bool is_mine_alone = here.now[i] >= 0 && there.now[i] < 0;
    if (!is_mine_alone || mine[static_cast<std::size_t>(here.now[i])] == base[i]) continue;
    ++conflicts;
    if (side_ == MergeSide::mine) all.push_back(mine[static_cast<std::size_t>(here.now[i])]);
  }
  for (std::size_t k = 0; k < mine.size(); ++k) {
    const bool is_there =
        std::any_of(theirs.begin(), theirs.end(), [&](const Element& other) { return other == mine[k]; });
    if (here.is_new[k] && !is_there) all.push_back(mine[k]);
  }
  return all;
}

template <class Element>
void LevelMerger::merge_list(std::vector<Element> Level::*part, const char* noun, const char* nouns) {
  int conflicts = 0;
  merged_.level.*part = merged_list(base_.*part, mine_.*part, theirs_.*part, conflicts,
                                    [this](const Element& base, const Element& mine, const Element& theirs,
                                           int& count) { return pick(base, mine, theirs, count); });
  note(conflicts, noun, nouns);
}

// A body that both changed is merged part by part: Tiled may move it while it gets a picture here.
void LevelMerger::merge_spawns() {
  int conflicts = 0;
  const auto pick_body = [&](const Spawn& base, const Spawn& mine, const Spawn& theirs, int& count) {
    Spawn merged = theirs;
    int parts = 0;
    pick_parts(merged, base, mine, theirs, parts, &Spawn::name, &Spawn::position, &Spawn::velocity,
               &Spawn::extra, &Spawn::kind, &Spawn::size, &Spawn::foot, &Spawn::picture);
    count += parts > 0;
    return merged;
  };
  merged_.level.spawns = merged_list(base_.spawns, mine_.spawns, theirs_.spawns, conflicts, pick_body);
  note(conflicts, "body", "bodies");
}

// Objects of a layer that both changed are merged one by one.
void LevelMerger::merge_objects() {
  int looks = 0, objects = 0;
  const auto pick_layer = [&](const ObjectLayer& base, const ObjectLayer& mine, const ObjectLayer& theirs,
                              int&) {
    ObjectLayer merged = theirs;
    pick_parts(merged, base, mine, theirs, looks, &ObjectLayer::name, &ObjectLayer::is_ground,
               &ObjectLayer::visible, &ObjectLayer::locked, &ObjectLayer::opacity, &ObjectLayer::offset,
               &ObjectLayer::parallax, &ObjectLayer::tint, &ObjectLayer::group, &ObjectLayer::place,
               &ObjectLayer::by_y, &ObjectLayer::image, &ObjectLayer::extra);
    merged.objects = merged_list(base.objects, mine.objects, theirs.objects, objects,
                                 [this](const MapObject& was, const MapObject& here, const MapObject& there,
                                        int& count) { return pick(was, here, there, count); });
    return merged;
  };
  int layers = 0;
  merged_.level.objects = merged_list(base_.objects, mine_.objects, theirs_.objects, layers, pick_layer);
  note(objects, "object", "objects");
  note(looks + layers, "layer of objects", "layers of objects");
}

// They must fit the sheet of tiles, whose layout may be that of the other side.
void LevelMerger::merge_tilesets() {
  take_whole(&Level::tilesets, "the tilesets");
  Level& level = merged_.level;
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  for (const Level* other : {&theirs_, &mine_}) {
    if (!problem_of(level.tilesets, sheet)) return;
    level.tilesets = other->tilesets;
  }
  if (problem_of(level.tilesets, sheet)) level.tilesets.clear();
}

template <class Array>
void LevelMerger::merge_array(Array Level::*part, const char* noun, const char* nouns) {
  int conflicts = 0;
  for (std::size_t i = 0; i < (base_.*part).size(); ++i)
    (merged_.level.*part)[i] = pick((base_.*part)[i], (mine_.*part)[i], (theirs_.*part)[i], conflicts);
  note(conflicts, noun, nouns);
}

// Whether all three show their tiles in true colour, or none, so that tiles of both sides go together.
bool LevelMerger::merges_looks(SheetId id) const {
  const bool has_picture = theirs_.sheet(id).picture != nullptr;
  return (base_.sheet(id).picture != nullptr) == has_picture &&
         (mine_.sheet(id).picture != nullptr) == has_picture &&
         base_.map.tile_size() == theirs_.map.tile_size();
}

// One side has a picture in true colour, the other does not.
void LevelMerger::take_looks(SheetId id, Sheet& sheet) {
  const Sheet &base = base_.sheet(id), &mine = mine_.sheet(id), &theirs = theirs_.sheet(id);
  int conflicts = 0;
  const auto fits = [&](const Sheet& side) { return side.count() == sheet.count(); };
  const Sheet* source = &pick(base, mine, theirs, conflicts);
  if (conflicts > 0) merged_.conflicts.emplace_back("the picture of a sheet");
  if (!fits(*source)) source = fits(mine) ? &mine : &theirs;
  sheet.images = source->images;
  sheet.images.resize(sheet.flags.size());
  sheet.picture = fits(*source) ? source->picture : nullptr;
}

void LevelMerger::merge_looks(SheetId id, Sheet& sheet) {
  std::shared_ptr<SheetPicture> picture;
  const TileSize size = theirs_.map.tile_size();
  if (theirs_.sheet(id).picture != nullptr) {
    picture = std::make_shared<SheetPicture>();
    picture->width = sheet.columns * size.width;
    picture->height = sheet.layout().rows() * size.height;
    picture->rgba.resize(4 * static_cast<std::size_t>(picture->width) *
                         static_cast<std::size_t>(picture->height));
  }
  sheet.picture = std::move(picture);
  const auto look = [&](const Level& level, int tile) {
    const Sheet& side = level.sheet(id);
    return tile < side.count() ? std::optional(look_of(side, size, tile)) : std::nullopt;
  };
  int conflicts = 0;
  for (int tile = 0; tile < sheet.count(); ++tile) {
    const auto merged = pick_held(look(base_, tile), look(mine_, tile), look(theirs_, tile), conflicts);
    put_look(*merged, size, tile, sheet);
  }
  note(conflicts, "picture of a tile", "pictures of tiles");
}

void LevelMerger::merge_sheet(SheetId id, std::size_t count) {
  const Sheet &base = base_.sheet(id), &mine = mine_.sheet(id), &theirs = theirs_.sheet(id);
  Sheet& sheet = merged_.level.sheet(id);
  sheet.columns = theirs.columns;
  sheet.images.resize(count);
  sheet.flags.resize(count);
  const auto flags = [](const Sheet& side, std::size_t tile) {
    return tile < side.flags.size() ? std::optional(side.flags[tile]) : std::nullopt;
  };
  int conflicts = 0;
  for (std::size_t i = 0; i < count; ++i)
    sheet.flags[i] = *pick_held(flags(base, i), flags(mine, i), flags(theirs, i), conflicts);
  note(conflicts, "tile's flags", "tiles' flags");
  const bool same_picture =
      mine.picture == theirs.picture || (mine.picture && theirs.picture && *mine.picture == *theirs.picture);
  if (same_picture && mine.images == theirs.images)
    sheet.picture = theirs.picture;
  else if (merges_looks(id))
    merge_looks(id, sheet);
  else
    take_looks(id, sheet);
}

// Of tiles. If both have more than before, all are kept; those of one number are asked about.
int LevelMerger::merged_count(int base, int mine, int theirs, int& conflicts) const {
  if (mine > base && theirs > base) return std::max(mine, theirs);
  return pick(base, mine, theirs, conflicts);
}

void LevelMerger::merge_tiles() {
  int counts = 0;
  for (const SheetId id : {SheetId::tiles, SheetId::sprites}) {
    const int count =
        merged_count(base_.sheet(id).count(), mine_.sheet(id).count(), theirs_.sheet(id).count(), counts);
    merge_sheet(id, static_cast<std::size_t>(count));
  }
  if (counts > 0) merged_.conflicts.emplace_back("the number of tiles");
  const std::size_t count = merged_.level.sheet(SheetId::tiles).images.size();
  const auto shape = [](const Level& level, std::size_t tile) {
    return tile < level.tile_shapes.size() ? std::optional(level.tile_shapes[tile]) : std::nullopt;
  };
  int shapes = 0;
  merged_.level.tile_shapes.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    merged_.level.tile_shapes[i] = *pick_held(shape(base_, i), shape(mine_, i), shape(theirs_, i), shapes);
  note(shapes, "shape", "shapes");
}

// Whether `order` lacks a layer that the other side has changed.
bool LevelMerger::has_lost_layer(const Level& order, const Level& other) const {
  for (int i = 0; i < base_.layers.count(); ++i) {
    if (matching_layer(base_, i, order) >= 0) continue;
    const int there = matching_layer(base_, i, other);
    if (there >= 0 && !(other.cells_of(there) == base_.cells_of(i))) return true;
  }
  return false;
}

// The side that says which layers there are, in which order.
const Level& LevelMerger::layer_order() {
  const Level& chosen = side_ == MergeSide::mine ? mine_ : theirs_;
  const bool mine_is_old = same_layer_order(mine_, base_), theirs_is_old = same_layer_order(theirs_, base_);
  if (theirs_is_old && !has_lost_layer(mine_, theirs_)) return mine_;
  if (mine_is_old && !has_lost_layer(theirs_, mine_)) return theirs_;
  if (same_layer_order(mine_, theirs_)) return mine_;
  merged_.conflicts.emplace_back("the list of layers");
  return chosen;
}

TileLayer LevelMerger::merged_look(const Level& order, int layer, int& conflicts) const {
  const auto in = [&](const Level& level) -> const TileLayer* {
    const int i = matching_layer(order, layer, level);
    return i < 0 ? nullptr : &level.layers.list[static_cast<std::size_t>(i)];
  };
  TileLayer look = order.layers.list[static_cast<std::size_t>(layer)];
  look.cells = nullptr;
  const TileLayer *base = in(base_), *mine = in(mine_), *theirs = in(theirs_);
  if (base == nullptr || mine == nullptr || theirs == nullptr) return look;
  int fields = 0;
  pick_parts(look, *base, *mine, *theirs, fields, &TileLayer::name, &TileLayer::is_ground,
             &TileLayer::visible, &TileLayer::locked, &TileLayer::opacity, &TileLayer::offset,
             &TileLayer::parallax, &TileLayer::tint, &TileLayer::group, &TileLayer::extra);
  if (fields > 0) ++conflicts;
  return look;
}

// Changed cells of a layer that the merged map has no room for.
int LevelMerger::lost_cells(const Level& changed, int layer, int base_layer, const TileMap& map) const {
  if (layer < 0 || (changed.map.width() <= map.width() && changed.map.height() <= map.height())) return 0;
  int lost = 0;
  const auto& cells = changed.cells_of(layer);
  const int width = changed.map.width();
  for (int y = 0; y < changed.map.height(); ++y) {
    for (int x = y < map.height() ? map.width() : 0; x < width; ++x) {
      const MapCell cell = cells[static_cast<std::size_t>(y) * width + x];
      const bool was = base_layer >= 0 && base_.map.contains({x, y});
      const MapCell before =
          was ? base_.cells_of(base_layer)[static_cast<std::size_t>(y) * base_.map.width() + x] : MapCell();
      if (cell != before) ++lost;
    }
  }
  return lost;
}

MapCells LevelMerger::merged_cells(const Level& order, int layer, const TileMap& map, int& conflicts) const {
  const std::array<const Level*, 3> levels = {&base_, &mine_, &theirs_};
  std::array<const MapCells*, 3> cells = {};
  std::array<int, 3> places = {};
  bool same_size = true;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    places[i] = matching_layer(order, layer, *levels[i]);
    if (places[i] >= 0) cells[i] = &levels[i]->cells_of(places[i]);
    same_size = same_size && levels[i]->map.width() == map.width() && levels[i]->map.height() == map.height();
  }
  if (same_size && cells[1] && cells[2]) {
    if (*cells[1] == *cells[2] || (cells[0] && *cells[2] == *cells[0])) return *cells[1];
    if (cells[0] && *cells[1] == *cells[0]) return *cells[2];
  }
  if (same_size && (!cells[1] || !cells[2])) return cells[1] ? *cells[1] : *cells[2];
  MapCells merged(map.cells().size());
  const auto at = [&](std::size_t side, int x, int y) -> std::optional<MapCell> {
    const TileMap& own = levels[side]->map;
    if (cells[side] == nullptr || !own.contains({x, y})) return std::nullopt;
    return (*cells[side])[static_cast<std::size_t>(y) * own.width() + x];
  };
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const MapCell was = at(0, x, y).value_or(MapCell());
      const MapCell mine = at(1, x, y).value_or(was), theirs = at(2, x, y).value_or(was);
      merged.set(static_cast<std::size_t>(y) * map.width() + x, pick(was, mine, theirs, conflicts));
    }
  }
  conflicts += lost_cells(mine_, places[1], places[0], map) + lost_cells(theirs_, places[2], places[0], map);
  return merged;
}

void LevelMerger::merge_layers() {
  using Size = std::pair<int, int>;
  const auto size_of_map = [](const Level& level) { return Size(level.map.width(), level.map.height()); };
  int sizes = 0, looks = 0, cells = 0;
  const Size size = pick(size_of_map(base_), size_of_map(mine_), size_of_map(theirs_), sizes);
  TileMap map(size.first, size.second, theirs_.map.tile_size());
  const Level& order = layer_order();
  TileLayers layers{{}, std::max(0, matching_layer(mine_, mine_.layers.chosen, order))};
  for (int i = 0; i < order.layers.count(); ++i) {
    layers.list.push_back(merged_look(order, i, looks));
    MapCells own = merged_cells(order, i, map, cells);
    if (i == layers.chosen)
      map.cells() = std::move(own);
    else
      layers.list.back().cells = std::make_shared<const MapCells>(std::move(own));
  }
  merged_.level.layers = std::move(layers);
  merged_.level.map = std::move(map);
  if (sizes > 0) merged_.conflicts.emplace_back("the size of the map");
  note(cells, "cell", "cells");
  note(looks, "layer's look", "layers' looks");
}

void LevelMerger::merge_groups() {
  if (groups_ == nullptr) return;
  int conflicts = 0;
  merged_.level.layers.groups = merged_groups(*groups_, side_, conflicts);
  tidy_groups(merged_.level.layers, merged_.level.objects);
  note(conflicts, "field of a group of layers", "fields of groups of layers");
}

// Tiles that only one side still had become tile 0, and animations with them go.
void LevelMerger::fit_tiles() {
  Level& level = merged_.level;
  const int count = level.tile_count();
  std::erase_if(level.large_tiles, [&](const auto& tile) { return tile.first >= count; });
  if (count >= mine_.tile_count() && count >= theirs_.tile_count()) return;
  int gone = 0;
  const auto fit_cells = [&](MapCells& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells.tiles()[i] < count) continue;
      cells.set(i, {});
      ++gone;
    }
  };
  const auto fit = [&](auto& tiles) {
    for (auto& tile : tiles) {
      if (MapCell(tile).tile < count) continue;
      tile = {};
      ++gone;
    }
  };
  fit_cells(level.map.cells());
  for (TileLayer& layer : level.layers.list) {
    if (layer.cells == nullptr) continue;
    MapCells cells = *layer.cells;
    fit_cells(cells);
    layer.cells = std::make_shared<const MapCells>(std::move(cells));
  }
  for (Brush& brush : level.brushes) fit(brush.tiles);
  for (Spawn& spawn : level.spawns)
    for (BodyFrames& frames : spawn.picture.acts)
      if (spawn.picture.sheet == SheetId::tiles && frames.first >= count) frames = {};
  fit(level.auto_tiles.tiles);
  gone += static_cast<int>(std::erase_if(level.animations, [&](const auto& animation) {
    return problem_of(TileAnimations{animation}, count).has_value();
  }));
  std::erase_if(level.tile_notes, [&](const auto& note) { return note.first >= count; });
  note(gone, "cell with a tile that is gone", "cells with tiles that are gone");
}

// Both ends of a curve must be on the map.
void LevelMerger::fit_curves() {
  const auto gone = std::erase_if(merged_.level.curves, [&](const LevelCurve& curve) {
    return problem_of(curve.curve, merged_.level.map).has_value();
  });
  note(static_cast<int>(gone), "curve that leaves the map", "curves that leave the map");
}

// What keeps the two sides from being merged part by part; empty if they can be.
std::string LevelMerger::reason_for_whole() const {
  if (!(mine_.map.tile_size() == theirs_.map.tile_size())) return kTileSizes;
  const bool same_numbers = mine_.sheet(SheetId::tiles).columns == theirs_.sheet(SheetId::tiles).columns &&
                            mine_.sheet(SheetId::sprites).columns == theirs_.sheet(SheetId::sprites).columns;
  return same_numbers ? "" : "the numbers of the tiles";
}

// The same as a clause.
std::string LevelMerger::text_of_apart(const std::string& reason) const {
  const auto px = [](TileSize tile) {
    return std::to_string(tile.width) + "x" + std::to_string(tile.height) + " px";
  };
  if (reason == kTileSizes)
    return "the tiles have " + px(theirs_.map.tile_size()) + " there, and " + px(mine_.map.tile_size()) +
           " here";
  return reason == kTooMuch ? "both together are " + reason : reason + " are others there than here";
}

void LevelMerger::merge_parts() {
  merge_layers();
  merge_tiles();
  merge_tilesets();
  merge_spawns();
  merge_list(&Level::curves, "curve", "curves");
  merge_objects();
  merge_groups();
  merge_array(&Level::palette, "colour", "colours");
  take_whole(&Level::background, "the background");
  merge_array(&Level::flag_names, "name of a flag", "names of flags");
  merge_array(&Level::flag_shapes, "flag's shape", "flags' shapes");
  take_whole(&Level::flag_fields, "the fields of flags");
  take_whole(&Level::roles, "the roles of flags");
  take_whole(&Level::tuning, "the numbers of the physics");
  take_whole(&Level::animations, "the animations of tiles");
  take_whole(&Level::tile_notes, "the notes of tiles");
  take_whole(&Level::large_tiles, "the pictures of large tiles");
  take_whole(&Level::brushes, "the brushes");
  take_whole(&Level::auto_tiles, "the tiles of the ground");
  take_whole(&Level::exports, "the export presets");
  take_whole(&Level::extra, "what Talus does not show");
  fit_tiles();
  fit_curves();
}

// The origin of the merged level is theirs from the beginning.
MergedLevel LevelMerger::merge() {
  const auto take = [&](const Level& whole, std::vector<std::string> conflicts) {
    merged_ = MergedLevel{whole, std::move(conflicts)};
    merged_.level.cart = theirs_.cart;
    merged_.level.tiled = theirs_.tiled;
    merged_.level.ldtk = theirs_.ldtk;
  };
  const Level& chosen = chosen_ != nullptr ? *chosen_ : side_ == MergeSide::mine ? mine_ : theirs_;
  if (groups_ == nullptr && mine_ == base_) {
    take(theirs_, {});
  } else if (groups_ == nullptr && theirs_ == base_) {
    take(mine_, {});
  } else if (const std::string reason = reason_for_whole(); !reason.empty()) {
    take(chosen, {reason});
    merged_.apart = text_of_apart(reason);
  } else {
    merge_parts();
    if (!problem_of_amounts(merged_.level)) return std::move(merged_);
    take(chosen, {kTooMuch});
    merged_.apart = text_of_apart(kTooMuch);
  }
  return std::move(merged_);
}

}  // namespace

int matching_layer(const Level& level, int layer, const Level& other) {
  if (&level == &other) return layer;
  const auto& own = level.layers.list;
  const bool by_place =
      level.layers.count() == other.layers.count() && sorted_layer_names(level) != sorted_layer_names(other);
  if (by_place) return layer;
  const std::string& name = own[static_cast<std::size_t>(layer)].name;
  auto before = std::count_if(own.begin(), own.begin() + layer,
                              [&](const TileLayer& earlier) { return earlier.name == name; });
  for (int i = 0; i < other.layers.count(); ++i) {
    if (other.layers.list[static_cast<std::size_t>(i)].name == name && before-- == 0) return i;
  }
  return -1;
}

MergedLevel merge_in_place(const Level& base, const Level& mine, const Level& theirs, MergeSide side) {
  const bool has_groups =
      !base.layers.groups.empty() || !mine.layers.groups.empty() || !theirs.layers.groups.empty();
  if (!has_groups || mine == base || theirs == base) return LevelMerger(base, mine, theirs, side).merge();
  Level of_base = base, of_mine = mine, of_theirs = theirs;
  const auto groups = take_shared_groups({&of_base, &of_mine, &of_theirs});
  const Level& chosen = side == MergeSide::mine ? mine : theirs;
  return LevelMerger(of_base, of_mine, of_theirs, side, groups, chosen).merge();
}

}  // namespace talus
