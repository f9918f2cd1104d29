#include "object_tools.h"

#include <utility>

#include "level/single_change.h"

namespace talus {
namespace {

bool has_object_layer(const Level& level, int layer) {
  return layer >= 0 && layer < static_cast<int>(level.objects.size());
}

Edit set_mark(const Level& level, int layer, bool ObjectLayer::*mark, bool on, std::string label) {
  if (!has_object_layer(level, layer)) return {std::move(label), {}};
  std::vector<ObjectLayer> layers = level.objects;
  layers[static_cast<std::size_t>(layer)].*mark = on;
  return single_change(std::move(label), ObjectsChange{level.objects, std::move(layers)});
}

}  // namespace

Edit set_object_ground(const Level& level, int layer, bool is_ground) {
  return set_mark(level, layer, &ObjectLayer::is_ground, is_ground,
                  is_ground ? "Make objects ground" : "Make objects no ground");
}

Edit set_object_visible(const Level& level, int layer, bool visible) {
  return set_mark(level, layer, &ObjectLayer::visible, visible, visible ? "Show objects" : "Hide objects");
}

std::string object_layer_text(const Level& level, int layer) {
  const ObjectLayer& objects = level.objects[static_cast<std::size_t>(layer)];
  const std::size_t count = objects.objects.size();
  const std::string name = objects.name.empty() ? "Objects " + std::to_string(layer + 1) : objects.name;
  return name + ", " + std::to_string(count) + (count == 1 ? " object" : " objects");
}

}  // namespace talus
