#include <talus/level/layer_group.h>

#include <algorithm>
#include <utility>

#include <talus/level/tile_layer.h>
#include "layer_tree.h"

namespace talus {
namespace {

double within(double value, double most) { return std::clamp(value, -most, most); }

Vec2 within(Vec2 value, double most) { return {within(value.x, most), within(value.y, most)}; }

Rgb product(Rgb a, Rgb b) {
  const auto channel = [](std::uint8_t x, std::uint8_t y) { return static_cast<std::uint8_t>(x * y / 255); };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

bool is_group(const LayerGroups& groups, int group) {
  return group >= 0 && static_cast<std::size_t>(group) < groups.size();
}

template <class Layer>
LayerLooks joined(const LayerLooks& above, const Layer& own) {
  LayerLooks looks;
  looks.visible = above.visible && own.visible;
  looks.locked = above.locked || own.locked;
  looks.opacity = above.opacity * own.opacity;
  looks.offset = within(above.offset + own.offset, kMaxLayerOffset);
  looks.parallax =
      within({above.parallax.x * own.parallax.x, above.parallax.y * own.parallax.y}, kMaxParallax);
  looks.tint = product(above.tint, own.tint);
  return looks;
}

template <class Layer>
LayerLooks looks_of_layer(const LayerGroups& groups, const Layer& layer) {
  LayerLooks looks;
  for (const int group : groups_around(groups, layer.group))
    looks = joined(looks, groups[static_cast<std::size_t>(group)]);
  return joined(looks, layer);
}

// Numbers groups anew as their layers come.
class GroupNumbers {
 public:
  explicit GroupNumbers(LayerGroups all)
      : old_(std::move(all)), is_begun_(old_.size()), numbers_(old_.size(), -1) {}

  // The new number of a group, after those around it; -1 if there is none.
  int number_of(int group) {
    if (!is_group(old_, group)) return -1;
    const auto at = static_cast<std::size_t>(group);
    if (is_begun_[at]) return numbers_[at];  // -1 in a ring
    is_begun_[at] = true;
    const int around = number_of(old_[at].group);
    numbers_[at] = static_cast<int>(groups.size());
    groups.push_back(old_[at]);
    groups.back().group = around;
    return numbers_[at];
  }

  LayerGroups groups;

 private:
  LayerGroups old_;
  std::vector<bool> is_begun_;  // by old group
  std::vector<int> numbers_;    // the same
};

}  // namespace

LayerLooks shown_looks(const LayerGroups& groups, const TileLayer& layer) {
  return looks_of_layer(groups, layer);
}
LayerLooks shown_looks(const LayerGroups& groups, const ObjectLayer& layer) {
  return looks_of_layer(groups, layer);
}
LayerLooks shown_looks(const LayerGroups& groups, const LayerGroup& group) {
  return looks_of_layer(groups, group);
}

void tidy_groups(TileLayers& layers, std::vector<ObjectLayer>& objects) {
  GroupNumbers numbers(std::move(layers.groups));
  for (const auto& [has_tiles, index] : layers_in_order(layers.count(), objects)) {
    const auto at = static_cast<std::size_t>(index);
    int& group = has_tiles ? layers.list[at].group : objects[at].group;
    group = numbers.number_of(group);
  }
  layers.groups = std::move(numbers.groups);
}

}  // namespace talus
