// Pairs what the level has with what the file gave, and writes the differences.
#include "tiled_object_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "../text/json_text.h"
#include "tiled_object_layers.h"
#include "tiled_objects.h"
#include "tiled_pairs.h"
#include "tiled_tiles.h"

namespace talus {
namespace {

using Place = TiledSources::Place;
using PropertyValue = decltype(TiledProperty::value);

// Up to 5 for what is near.
int closeness(Vec2 a, Vec2 b) {
  constexpr double kFar = 64;  // px
  return static_cast<int>(5 / (1 + (std::abs(a.x - b.x) + std::abs(a.y - b.y)) / kFar));
}

int same_name(const std::string& a, const std::string& b) { return a != b ? 0 : a.empty() ? 10 : 20; }

int likeness_of(const Spawn& a, const Spawn& b) {
  if (a == b) return kSameItem;
  if (a.kind != b.kind && a.position != b.position) return 0;
  return 1 + same_name(a.name, b.name) + (a.kind == b.kind ? 10 : 0) + (a.size == b.size ? 5 : 0) +
         (a.position == b.position ? 20 : 0) + (a.velocity == b.velocity ? 3 : 0) +
         closeness(a.position, b.position);
}

int likeness_of(const MapObject& a, const MapObject& b) {
  if (a == b) return kSameItem;
  if (a.form != b.form) return 0;
  constexpr int kLeast = 20;  // of what may be the same object
  const int like = same_name(a.name, b.name) + (a.type == b.type ? 10 : 0) + (a.size == b.size ? 5 : 0) +
                   (!a.points.empty() && a.points == b.points ? 10 : 0) +
                   (a.position == b.position ? 20 : 0) + (a.tile != 0 && a.tile == b.tile ? 5 : 0) +
                   (a.properties == b.properties ? 5 : 0) + closeness(a.position, b.position);
  return like < kLeast ? 0 : like;
}

int likeness_of(const LevelCurve& a, const LevelCurve& b) {
  if (a == b) return kSameItem;
  const bool has_same_name = !a.name.empty() && a.name == b.name;
  if (a.curve.form.index() != b.curve.form.index() && !has_same_name) return 0;
  const auto first = tiled_object(a), second = tiled_object(b);
  const int near = first && second ? closeness(first->position, second->position) : 0;
  return 1 + same_name(a.name, b.name) + (a.curve.form == b.curve.form ? 20 : 0) + near;
}

template <class Item>
std::vector<int> pairs_of(const std::vector<Item>& before, const std::vector<Item>& now) {
  return pair_items(static_cast<int>(before.size()), static_cast<int>(now.size()), [&](int i, int k) {
    return likeness_of(before[static_cast<std::size_t>(i)], now[static_cast<std::size_t>(k)]);
  });
}

// By layer of the level, that of the opened one; -1: it is new. Names count first, then equal objects.
std::vector<int> pairs_of_layers(const std::vector<ObjectLayer>& before,
                                 const std::vector<ObjectLayer>& now) {
  std::vector<int> pairs(now.size(), -1);
  std::vector<bool> is_taken(before.size());
  const auto match = [&](const auto& fits) {
    for (std::size_t k = 0; k < now.size(); ++k) {
      for (std::size_t i = 0; i < before.size() && pairs[k] < 0; ++i) {
        if (is_taken[i] || !fits(before[i], now[k])) continue;
        pairs[k] = static_cast<int>(i);
        is_taken[i] = true;
      }
    }
  };
  match(
      [](const ObjectLayer& a, const ObjectLayer& b) { return a.name == b.name && a.objects == b.objects; });
  const auto has_same_content = [](const ObjectLayer& a, const ObjectLayer& b) {
    return a.objects == b.objects && a.image == b.image;
  };
  match(
      [&](const ObjectLayer& a, const ObjectLayer& b) { return a.name == b.name && has_same_content(a, b); });
  match([&](const ObjectLayer& a, const ObjectLayer& b) {
    return (!a.objects.empty() || a.image) && has_same_content(a, b);
  });
  match([](const ObjectLayer& a, const ObjectLayer& b) { return a.name == b.name; });
  match([](const ObjectLayer& a, const ObjectLayer& b) {
    return std::any_of(a.objects.begin(), a.objects.end(), [&](const MapObject& object) {
      return std::find(b.objects.begin(), b.objects.end(), object) != b.objects.end();
    });
  });
  return pairs;
}

std::optional<PropertyValue> value_to_write(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  return std::nullopt;
}

Json properties_of(const MapObject& object) {
  Json json = object.properties.empty() ? Json::object() : json_part(object.properties);
  if (!json.is_object()) json = Json::object();
  return json;
}

class ObjectWriter {
 public:
  ObjectWriter(const Level& level, const Level& opened, const TiledMap& map, const TiledSources& sources)
      : level_(level), opened_(opened), map_(map), sources_(sources) {
    for (const TiledLayer& layer : map.layers)
      if (!layer.has_tiles) files_.push_back(&layer);
    edits_.resize(files_.size());
  }

  TiledObjectEdits write() {
    order_layers();
    write_spawns();
    write_curves();
    write_objects();
    return finished();
  }

 private:
  void order_layers();
  int new_layer(std::string name);
  void write_spawns();
  TiledObjectEdit edit_of(const Spawn& before, const Spawn& now, Place place) const;
  void write_curves();
  TiledObjectEdit edit_of(const LevelCurve& now, Place place) const;
  void write_objects();
  TiledObjectEdit edit_of(const MapObject& before, const MapObject& now, Place place) const;
  void add(Place where, TiledObject object, std::vector<TiledPropertyEdit> properties);
  std::vector<Place> places_of_new(const std::vector<int>& pairs, const std::vector<Place>& sources,
                                   std::string_view layer);
  TiledObjectEdits finished();

  const TiledObject& object_at(Place place) const {
    return files_[static_cast<std::size_t>(place.layer)]->objects[static_cast<std::size_t>(place.index)];
  }
  Vec2 offset_of(int layer) const;
  // As they are in the text, of what is moved by this offset when it is read.
  Vec2 in_file(Vec2 position, Vec2 offset) const;
  TiledObject in_file(TiledObject object, Vec2 offset = {}) const;
  std::vector<TiledObjectEdit>& edits_at(int layer) { return edits_[static_cast<std::size_t>(layer)]; }

  const Level& level_;
  const Level& opened_;
  const TiledMap& map_;
  const TiledSources& sources_;
  std::vector<const TiledLayer*> files_;             // layers of objects of the map; their indices, and those
                                                     // behind them for new layers, are numbers of layers here
  std::vector<std::string> new_names_;               // of new layers
  std::vector<std::vector<TiledObjectEdit>> edits_;  // by layer
  std::vector<int> order_;                           // layers
  std::vector<int> layer_pairs_, layers_;            // by layer of objects of the level: opened one, layer
};

// The number that is read as `wanted`: from the first cell of the map on, moved by the layer's offset.
double in_text(double wanted, double offset, double origin) {
  const auto read = [&](double raw) { return (raw - origin) + offset; };
  const double raw = (wanted - offset) + origin;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double other : {raw, std::nextafter(raw, -infinity), std::nextafter(raw, infinity)})
    if (read(other) == wanted) return other;
  return raw;
}

// Bodies and curves are moved by the offset of their layer; objects are not.
Vec2 ObjectWriter::offset_of(int layer) const {
  const auto i = static_cast<std::size_t>(layer);
  return i < files_.size() ? shown_looks(map_.groups, files_[i]->looks).offset : Vec2();
}

Vec2 ObjectWriter::in_file(Vec2 position, Vec2 offset) const {
  return {in_text(position.x, offset.x, 1.0 * map_.first.x * map_.tile_size.width),
          in_text(position.y, offset.y, 1.0 * map_.first.y * map_.tile_size.height)};
}

TiledObject ObjectWriter::in_file(TiledObject object, Vec2 offset) const {
  object.position = in_file(object.position, offset);
  return object;
}

int ObjectWriter::new_layer(std::string name) {
  new_names_.push_back(std::move(name));
  edits_.emplace_back();
  return static_cast<int>(edits_.size()) - 1;
}

// Layers that are no layers of the level, such as those of bodies, keep their places.
void ObjectWriter::order_layers() {
  layer_pairs_ = pairs_of_layers(opened_.objects, level_.objects);
  const auto file_of = [&](int opened) { return sources_.layers[static_cast<std::size_t>(opened)].layer; };
  std::vector<int> kept;  // in the level's order
  for (const int pair : layer_pairs_)
    if (pair >= 0) kept.push_back(file_of(pair));
  std::vector<bool> is_kept(files_.size()), goes(files_.size());
  for (const int file : kept) is_kept[static_cast<std::size_t>(file)] = true;
  for (const TiledSources::Layer& source : sources_.layers) {
    const auto file = static_cast<std::size_t>(source.layer);
    goes[file] = !is_kept[file] && source.objects.size() == files_[file]->objects.size();
  }
  std::size_t next = 0;
  for (std::size_t file = 0; file < files_.size(); ++file) {
    if (goes[file]) continue;
    order_.push_back(is_kept[file] ? kept[next++] : static_cast<int>(file));
  }
  for (std::size_t k = 0; k < level_.objects.size(); ++k) {
    if (layer_pairs_[k] >= 0) {
      layers_.push_back(file_of(layer_pairs_[k]));
      continue;
    }
    auto at = order_.end();
    if (k > 0)
      at = std::find(order_.begin(), order_.end(), layers_[k - 1]) + 1;
    else if (!kept.empty())
      at = std::find(order_.begin(), order_.end(), kept.front());
    layers_.push_back(new_layer(level_.objects[k].name));
    order_.insert(at, layers_.back());
  }
}

void ObjectWriter::add(Place where, TiledObject object, std::vector<TiledPropertyEdit> properties) {
  TiledObjectEdit edit{-1, false, std::move(object), std::move(properties)};
  edit.at = where.index;
  edits_at(where.layer).push_back(std::move(edit));
}

// By item, where a new one comes: before the object of the next one, or else at the end of a layer in which
// the last one is read.
std::vector<Place> ObjectWriter::places_of_new(const std::vector<int>& pairs,
                                               const std::vector<Place>& sources, std::string_view layer) {
  std::vector<Place> places(pairs.size());
  int last = -1;
  for (const int pair : pairs)
    if (pair >= 0) last = std::max(last, sources[static_cast<std::size_t>(pair)].layer);
  std::optional<Place> next;
  for (std::size_t i = pairs.size(); i-- > 0;) {
    if (pairs[i] >= 0) {
      next = sources[static_cast<std::size_t>(pairs[i])];
      continue;
    }
    if (!next) {
      int own = static_cast<int>(files_.size()) - 1;
      while (own >= 0 && files_[static_cast<std::size_t>(own)]->name != layer) --own;
      if (own < 0) {
        own = new_layer(std::string(layer));
        order_.push_back(own);
      }
      next = Place{std::max(own, last), -1};
    }
    places[i] = *next;
  }
  return places;
}

// The number of a property as it is written: whole ones stay whole.
PropertyValue number_like(const TiledProperties& properties, std::string_view name, double number) {
  const bool is_whole = find_property<std::int64_t>(properties, name) != nullptr;
  if (is_whole && number == std::trunc(number) && std::abs(number) < 1e15)
    return static_cast<std::int64_t>(number);
  return number;
}

const char* word_of(Foot foot) { return foot == Foot::centre ? "centre" : "box"; }

TiledObjectEdit ObjectWriter::edit_of(const Spawn& before, const Spawn& now, Place place) const {
  const TiledObject& old = object_at(place);
  const Vec2 anchor = anchor_of_gid(map_, old.gid);
  TiledObjectEdit edit{place.index, false, in_file(old), {}};
  edit.before = edit.object;
  TiledObject& object = *edit.object;
  if (now.name != before.name) object.name = now.name;
  if (now.kind != before.kind) object.type = traits_of(now.kind).word;
  if (now.size != before.size) object.size = now.size;
  const Vec2 from = tiled_position(before, old, anchor), to = tiled_position(now, old, anchor);
  const Vec2 written = in_file(to, offset_of(place.layer));
  if (from.x != to.x) object.position.x = written.x;
  if (from.y != to.y) object.position.y = written.y;
  const auto set = [&](const char* name, double was, double number) {
    if (was != number) edit.properties.push_back({name, number_like(old.properties, name, number)});
  };
  set("vx", before.velocity.x, now.velocity.x);
  set("vy", before.velocity.y, now.velocity.y);
  if (now.foot != before.foot) {
    std::optional<PropertyValue> value;
    if (now.foot) value = std::string(word_of(*now.foot));
    edit.properties.push_back({"foot", std::move(value)});
  }
  return edit;
}

void ObjectWriter::write_spawns() {
  const std::vector<int> pairs = pairs_of(opened_.spawns, level_.spawns);
  const std::vector<Place> places = places_of_new(pairs, sources_.spawns, kTiledBodyLayer);
  std::vector<bool> stays(opened_.spawns.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Spawn& now = level_.spawns[i];
    if (pairs[i] < 0) {
      TiledObject object = tiled_object(now);
      std::vector<TiledPropertyEdit> properties;
      for (const TiledProperty& property : std::exchange(object.properties, {})) {
        const bool is_usual = property.value == PropertyValue(0.0) || (property.name == "foot" && !now.foot);
        if (!is_usual) properties.push_back({property.name, property.value});
      }
      add(places[i], in_file(std::move(object), offset_of(places[i].layer)), std::move(properties));
      continue;
    }
    const auto was = static_cast<std::size_t>(pairs[i]);
    stays[was] = true;
    const Spawn& before = opened_.spawns[was];
    if (before != now)
      edits_at(sources_.spawns[was].layer).push_back(edit_of(before, now, sources_.spawns[was]));
  }
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const Place place = sources_.spawns[i];
    if (!stays[i]) edits_at(place.layer).push_back({place.index, true, {}, {}});
  }
}

// The object of a curve, without what the importer does not need to read the same curve.
std::optional<TiledObject> plain_object(const LevelCurve& curve) {
  auto object = tiled_object(curve);
  if (!object) return object;
  TiledObject plain = *object;
  std::erase_if(plain.properties, [&](const TiledProperty& property) {
    return property.name != "faces" || curve.curve.faces == Curve::Faces::up;
  });
  return curves_of(plain) == std::vector<Curve>{curve.curve} ? plain : object;
}

// Nothing is changed for a curve that cannot be used, and would be lost.
TiledObjectEdit ObjectWriter::edit_of(const LevelCurve& now, Place place) const {
  const TiledObject& old = object_at(place);
  TiledObjectEdit edit{place.index, false, {}, {}};
  auto object = plain_object(now);
  if (!object) return edit;
  for (const std::string_view name : curve_properties()) {
    const auto named = [&](const TiledProperty& property) { return property.name == name; };
    const auto was = std::find_if(old.properties.begin(), old.properties.end(), named);
    const auto is = std::find_if(object->properties.begin(), object->properties.end(), named);
    if (is != object->properties.end() && (was == old.properties.end() || *was != *is))
      edit.properties.push_back({is->name, is->value});
    if (is == object->properties.end() && was != old.properties.end())
      edit.properties.push_back({std::string(name), std::nullopt});
  }
  object->type = old.type;
  object->size = old.size;
  edit.object = in_file(*std::move(object), offset_of(place.layer));
  edit.before = in_file(old);
  return edit;
}

// An object of several curves goes if one of them changes, and each of these gets an object of its own there.
void ObjectWriter::write_curves() {
  const std::vector<int> pairs = pairs_of(opened_.curves, level_.curves);
  std::vector<Place> places = places_of_new(pairs, sources_.curves, kTiledCurveLayer);
  std::vector<int> now_of(opened_.curves.size(), -1);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (pairs[k] >= 0) now_of[static_cast<std::size_t>(pairs[k])] = static_cast<int>(k);
  std::vector<bool> is_new(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) is_new[k] = pairs[k] < 0;
  for (std::size_t from = 0, to = 0; from < opened_.curves.size(); from = to) {
    const Place place = sources_.curves[from];
    bool is_same = true;
    for (to = from; to < opened_.curves.size() && sources_.curves[to] == place; ++to) {
      const int now = now_of[to];
      is_same = is_same && now >= 0 && opened_.curves[to] == level_.curves[static_cast<std::size_t>(now)];
    }
    if (is_same) continue;
    if (to == from + 1 && now_of[from] >= 0) {
      edits_at(place.layer).push_back(edit_of(level_.curves[static_cast<std::size_t>(now_of[from])], place));
      continue;
    }
    edits_at(place.layer).push_back({place.index, true, {}, {}});
    for (std::size_t i = from; i < to; ++i) {
      if (now_of[i] < 0) continue;
      is_new[static_cast<std::size_t>(now_of[i])] = true;
      places[static_cast<std::size_t>(now_of[i])] = place;
    }
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    auto object = is_new[k] ? plain_object(level_.curves[k]) : std::nullopt;
    if (!object) continue;
    std::vector<TiledPropertyEdit> properties;
    properties.reserve(object->properties.size());
    for (const TiledProperty& property : std::exchange(object->properties, {}))
      properties.push_back({property.name, property.value});
    add(places[k], in_file(*std::move(object), offset_of(places[k].layer)), std::move(properties));
  }
}

TiledObjectEdit ObjectWriter::edit_of(const MapObject& before, const MapObject& now, Place place) const {
  const TiledObject& old = object_at(place);
  TiledObjectEdit edit{place.index, false, old, {}};
  TiledObject& object = *edit.object;
  const TiledObject wanted = tiled_object(now);
  if (now.name != before.name) object.name = wanted.name;
  if (now.type != before.type) object.type = wanted.type;
  if (now.tile != before.tile) object.gid = wanted.gid;
  if (now.position != before.position) object.position = wanted.position;
  if (now.size != before.size) object.size = wanted.size;
  if (now.rotation != before.rotation) object.rotation = wanted.rotation;
  if (now.visible != before.visible) object.visible = wanted.visible;
  if (now.points != before.points) object.points = wanted.points;
  const Json was = properties_of(before), is = properties_of(now);
  for (const auto& [name, value] : was.items())
    if (!is.contains(name)) edit.properties.push_back({name, std::nullopt});
  for (const auto& [name, value] : is.items()) {
    const auto known = was.find(name);
    if (known != was.end() && *known == value) continue;
    if (auto its = value_to_write(value)) edit.properties.push_back({name, std::move(its)});
  }
  edit.object = in_file(std::move(object));
  edit.before = in_file(old);
  return edit;
}

void ObjectWriter::write_objects() {
  const std::vector<MapObject> none;
  std::vector<bool> is_kept(opened_.objects.size());
  for (const int pair : layer_pairs_)
    if (pair >= 0) is_kept[static_cast<std::size_t>(pair)] = true;
  for (std::size_t k = 0; k < level_.objects.size(); ++k) {
    const std::vector<MapObject>& now = level_.objects[k].objects;
    if (level_.objects[k].image) continue;  // an element of a picture holds no objects
    const bool is_new = layer_pairs_[k] < 0;
    const auto opened = static_cast<std::size_t>(is_new ? 0 : layer_pairs_[k]);
    const std::vector<MapObject>& before = is_new ? none : opened_.objects[opened].objects;
    const std::vector<int> pairs = pairs_of(before, now);
    std::vector<bool> stays(before.size());
    const auto index_of = [&](int pair) {
      return sources_.layers[opened].objects[static_cast<std::size_t>(pair)];
    };
    std::vector<int> at(now.size(), -1);
    for (std::size_t i = now.size(), next = now.size(); i-- > 0;) {
      if (pairs[i] >= 0) next = i;
      if (next < now.size()) at[i] = index_of(pairs[next]);
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (pairs[i] < 0) {
        std::vector<TiledPropertyEdit> properties;
        const Json its = properties_of(now[i]);
        for (const auto& [name, value] : its.items())
          if (auto property = value_to_write(value)) properties.push_back({name, std::move(property)});
        add({layers_[k], at[i]}, in_file(tiled_object(now[i])), std::move(properties));
        continue;
      }
      const auto was = static_cast<std::size_t>(pairs[i]);
      stays[was] = true;
      if (before[was] == now[i]) continue;
      edits_at(layers_[k]).push_back(edit_of(before[was], now[i], {layers_[k], index_of(pairs[i])}));
    }
    for (std::size_t i = 0; i < stays.size(); ++i)
      if (!stays[i]) edits_at(layers_[k]).push_back({index_of(static_cast<int>(i)), true, {}, {}});
  }
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    if (is_kept[i]) continue;
    for (const int index : sources_.layers[i].objects)
      edits_at(sources_.layers[i].layer).push_back({index, true, {}, {}});
  }
}

TiledObjectEdits ObjectWriter::finished() {
  TiledObjectEdits all;
  std::vector<int> slots(edits_.size(), -1);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const auto layer = static_cast<std::size_t>(order_[i]);
    const bool is_new = layer >= files_.size();
    all.order.push_back({is_new ? -1 : order_[i], is_new ? new_names_[layer - files_.size()] : ""});
    slots[layer] = static_cast<int>(i);
    if (!edits_[layer].empty()) all.of.emplace(static_cast<int>(i), std::move(edits_[layer]));
  }
  for (const int layer : layers_) all.layers.push_back(slots[static_cast<std::size_t>(layer)]);
  return all;
}

}  // namespace

TiledObjectEdits object_edits(const Level& level, const Level& opened, const TiledMap& map,
                              const TiledSources& sources) {
  return ObjectWriter(level, opened, map, sources).write();
}

}  // namespace talus
