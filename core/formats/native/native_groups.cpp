#include "native_groups.h"

#include "native_layers.h"
#include "native_members.h"

namespace talus {
namespace {

FormatResult<LayerGroup> take_group(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  LayerGroup group;
  take.optional("name", group.name);
  take.optional("group", group.group);
  take_looks(take, group);
  if (const auto good = take.result(true); !good) return tl::unexpected(good.error());
  group.extra = take.rest();
  return group;
}

FormatResult<Json> json_of_group(const LayerGroup& group, const std::string& path) {
  if (const auto good = check_looks(group, path); !good) return tl::unexpected(good.error());
  auto json = parse_extra(group.extra);
  if (!json) return json;
  if (!group.name.empty()) (*json)["name"] = group.name;
  if (group.group >= 0) (*json)["group"] = group.group;
  put_looks(group, *json);
  return json;
}

// most: the groups that may be named have numbers below it.
FormatResult<void> check_number(int group, std::size_t most, const std::string& path) {
  if (group >= -1 && group < static_cast<int>(most)) return {};
  return tl::unexpected(FormatError{"key " + path + ".group", "must be the number of one of \"groups\""});
}

template <class Layer>
FormatResult<void> check_layers(const std::vector<Layer>& layers, std::size_t groups, const char* key) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string path = std::string(key) + "[" + std::to_string(i) + "]";
    if (const auto good = check_number(layers[i].group, groups, path); !good) return good;
  }
  return {};
}

}  // namespace

FormatResult<LayerGroups> take_groups(Json& list) {
  return take_list<LayerGroup>(list, "groups", take_group, kMaxLayerGroups,
                               "must be a list of up to 4096 groups");
}

FormatResult<void> check_groups(const Level& level) {
  const LayerGroups& groups = level.layers.groups;
  std::vector<int> depths;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string path = "groups[" + std::to_string(i) + "]";
    if (groups[i].group < -1 || groups[i].group >= static_cast<int>(i))
      return tl::unexpected(FormatError{"key " + path + ".group", "must be the number of a group before it"});
    depths.push_back(groups[i].group < 0 ? 1 : depths[static_cast<std::size_t>(groups[i].group)] + 1);
    if (depths.back() > kMaxGroupDepth)
      return tl::unexpected(FormatError{
          "key " + path, "is in more than " + std::to_string(kMaxGroupDepth - 1) + " other groups"});
  }
  if (const auto good = check_layers(level.layers.list, groups.size(), "layers"); !good) return good;
  return check_layers(level.objects, groups.size(), "objects");
}

FormatResult<Json> json_of_groups(const Level& level) {
  if (const auto good = check_groups(level); !good) return tl::unexpected(good.error());
  return put_list(level.layers.groups, "groups", json_of_group);
}

}  // namespace talus
