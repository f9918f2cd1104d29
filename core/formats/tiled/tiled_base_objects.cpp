#include "tiled_base_objects.h"

#include <algorithm>

#include "../text/xml_text.h"
#include "tiled_near.h"
#include "tiled_object_layers.h"

namespace talus {
namespace {

double x_of(const std::pair<TiledObject, const MapObject*>& entry) { return entry.first.position.x; }

}  // namespace

void TiledBaseObjects::set(const std::vector<ObjectLayer>& layers) {
  layers_ = &layers;
  is_taken_.assign(layers.size(), false);
}

void TiledBaseObjects::choose(const TiledLayer& layer) {
  chosen_ = nullptr;
  by_x_.clear();
  for (std::size_t i = 0; i < is_taken_.size() && chosen_ == nullptr; ++i) {
    const ObjectLayer& base = (*layers_)[i];
    const bool is_same = !is_taken_[i] && is_name_of(layer.name, base.name) &&
                         layer.image.has_value() == base.image.has_value();
    if (!is_same) continue;
    is_taken_[i] = true;
    chosen_ = &base;
  }
  if (chosen_ == nullptr) return;
  for (const MapObject& object : chosen_->objects) by_x_.emplace_back(tiled_object(object), &object);
  sort_by_x(by_x_, x_of);
}

void TiledBaseObjects::complete(ObjectLayer& layer, int tile_layers) const {
  if (chosen_ == nullptr) return;
  layer.name = chosen_->name;
  layer.extra = chosen_->extra;
  if (layer.place >= tile_layers && chosen_->place >= tile_layers) layer.place = chosen_->place;
}

const MapObject* TiledBaseObjects::like(const TiledObject& object) const {
  const auto near = near_in_x(std::span(by_x_), object.position.x, x_of);
  const auto same = std::find_if(near.begin(), near.end(), [&](const auto& base) {
    return is_name_of(object.name, base.first.name) && is_name_of(object.type, base.first.type) &&
           is_same_outline(base.first, object);
  });
  return same == near.end() ? nullptr : same->second;
}

void take_exact(const MapObject& base, MapObject& object) {
  object.name = base.name;
  object.type = base.type;
  object.position = base.position;
  object.size = base.size;
  object.points = base.points;
}

bool is_name_of(const std::string& written, const std::string& name) {
  return written == name || xml_text(written) == name;
}

}  // namespace talus
