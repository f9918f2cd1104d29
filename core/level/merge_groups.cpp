#include "merge_groups.h"

#include <algorithm>
#include <string>
#include <utility>

namespace talus {
namespace {

// The names of the layers that are in a group, but in none of its groups; sorted.
std::vector<std::string> names_in(const Level& level, int group) {
  std::vector<std::string> names;
  for (const TileLayer& layer : level.layers.list)
    if (layer.group == group) names.push_back(layer.name);
  for (const ObjectLayer& layer : level.objects)
    if (layer.group == group) names.push_back(layer.name);
  std::sort(names.begin(), names.end());
  return names;
}

class SharedGroups {
 public:
  void add(const Level& level, std::size_t version) {
    const LayerGroups& groups = level.layers.groups;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      LayerGroup group = groups[i];
      if (group.group >= 0) group.group = numbers[static_cast<std::size_t>(group.group)];
      std::vector<std::string> names = names_in(level, static_cast<int>(i));
      const std::size_t number = number_of(group, names, version);
      if (names_[number].empty()) names_[number] = std::move(names);
      all[number][version] = std::move(group);
      numbers.push_back(static_cast<int>(number));
    }
    numbers_ = std::move(numbers);
  }
  void renumber(int& group) const {
    if (group >= 0) group = numbers_[static_cast<std::size_t>(group)];
  }

  std::vector<GroupVersions> all;

 private:
  std::size_t number_of(const LayerGroup& group, const std::vector<std::string>& names, std::size_t version) {
    const auto find = [&](const auto& fits) {
      std::size_t number = 0;
      while (number < all.size() && (all[number][version] || !fits(number))) ++number;
      return number;
    };
    std::size_t number = find([&](std::size_t other) {
      return std::any_of(all[other].begin(), all[other].end(), [&](const std::optional<LayerGroup>& its) {
        return its && its->name == group.name && its->group == group.group;
      });
    });
    if (number == all.size() && !names.empty())
      number = find([&](std::size_t other) { return names_[other] == names; });
    if (number == all.size()) {
      all.emplace_back();
      names_.emplace_back();
    }
    return number;
  }

  std::vector<std::vector<std::string>> names_;  // by group, of its layers
  std::vector<int> numbers_;                     // by group of the level that was added last
};

}  // namespace

std::vector<GroupVersions> take_shared_groups(const std::array<Level*, 3>& levels) {
  SharedGroups shared;
  for (std::size_t version = 0; version < levels.size(); ++version) {
    Level& level = *levels[version];
    shared.add(level, version);
    for (TileLayer& layer : level.layers.list) shared.renumber(layer.group);
    for (ObjectLayer& layer : level.objects) shared.renumber(layer.group);
    level.layers.groups.clear();
  }
  return std::move(shared.all);
}

LayerGroups merged_groups(const std::vector<GroupVersions>& groups, MergeSide side, int& conflicts) {
  LayerGroups merged;
  for (const GroupVersions& versions : groups) {
    const std::optional<LayerGroup>&base = versions[0], &mine = versions[1], &theirs = versions[2];
    LayerGroup group = mine ? *mine : theirs ? *theirs : *base;
    const auto take = [&](auto LayerGroup::*field) {
      if (base && mine && theirs)
        group.*field = pick_side((*base).*field, (*mine).*field, (*theirs).*field, side, conflicts);
    };
    take(&LayerGroup::name);
    take(&LayerGroup::visible);
    take(&LayerGroup::locked);
    take(&LayerGroup::opacity);
    take(&LayerGroup::offset);
    take(&LayerGroup::parallax);
    take(&LayerGroup::tint);
    take(&LayerGroup::group);
    take(&LayerGroup::extra);
    merged.push_back(std::move(group));
  }
  return merged;
}

}  // namespace talus
