// Names of flags, and the flags of each tile.
#include "tiled_flags.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "../text/xml_text.h"

namespace talus {

std::array<std::string, kMaxFlags> tiled_flag_names(const Level& level) {
  std::set<std::string> taken = {"flags",         "shape",         "shape_side",
                                 "shape_one_way", "shape_heights", std::string(kTiledConveyor)};
  std::array<std::string, kMaxFlags> names;
  for (std::size_t flag = 0; flag < kMaxFlags; ++flag) taken.insert("flag" + std::to_string(flag));
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    std::string& name = names[static_cast<std::size_t>(flag)];
    name = level.flag_names[static_cast<std::size_t>(flag)];
    for (const FlagRoleInfo& role : flag_role_infos()) {
      if (name.empty() && level.roles.*role.flag == flag) name = role.key;
    }
    if (name.empty() || !taken.insert(xml_text(name)).second) name = "flag" + std::to_string(flag);
  }
  return names;
}

std::int64_t tiled_number_of(FlagSet flags) { return static_cast<std::int32_t>(flags); }

std::optional<FlagSet> flags_of_tiled_number(std::int64_t number) {
  if (number < std::numeric_limits<std::int32_t>::min() || number > std::numeric_limits<FlagSet>::max())
    return std::nullopt;
  return static_cast<FlagSet>(number);
}

TiledFlagReader::TiledFlagReader(Level& level) : level_(level) {
  const auto names = tiled_flag_names(level);
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    const std::string& name = names[static_cast<std::size_t>(flag)];
    flags_[name] = flags_[xml_text(name)] = flag;
  }
}

void TiledFlagReader::name_flags(const std::vector<const TiledTile*>& tiles, bool takes_roles) {
  std::map<std::string, Numbers> wanted;
  for (std::size_t number = 0; number < tiles.size(); ++number) {
    if (tiles[number] == nullptr) continue;
    const TiledProperties& properties = tiles[number]->properties;
    if (const auto* const all = find_property<std::int64_t>(properties, "flags")) {
      for (int flag = 0; flag < kMaxFlags; ++flag)
        if (has_flag(flags_of_tiled_number(*all).value_or(0), flag))
          by_number_[static_cast<std::size_t>(flag)].insert(number);
    }
    for (const TiledProperty& property : properties) {
      const bool* const is_on = std::get_if<bool>(&property.value);
      if (is_on == nullptr || !*is_on) continue;
      if (const auto known = flags_.find(property.name); known != flags_.end())
        by_name_.insert(known->second);
      else if (!property.name.empty() && !knows(property))
        wanted[property.name].insert(number);
    }
  }
  for (const auto& [name, numbers] : wanted) {
    const auto flag = flag_for(numbers, takes_roles);
    if (!flag) continue;
    for (const FlagRoleInfo& role : flag_role_infos())
      if (level_.roles.*role.flag == *flag) level_.roles.*role.flag = FlagRoles::kUnused;
    std::erase_if(flags_, [&](const auto& entry) { return entry.second == *flag; });
    level_.flag_names[static_cast<std::size_t>(*flag)] = name;
    flags_[name] = *flag;
  }
}

// The flag to name for these tiles; nothing if there is none.
std::optional<int> TiledFlagReader::flag_for(const Numbers& tiles, bool takes_roles) const {
  const auto numbers = [&](int flag) -> const Numbers& { return by_number_[static_cast<std::size_t>(flag)]; };
  for (int flag = 0; flag < kMaxFlags; ++flag)
    if (is_free(flag) && !has_role(flag) && numbers(flag) == tiles) return flag;
  for (int flag = 0; flag < kMaxFlags; ++flag)
    if (is_free(flag) && !has_role(flag) && numbers(flag).empty()) return flag;
  for (int flag = 0; takes_roles && flag < kMaxFlags; ++flag)
    if (is_free(flag) && numbers(flag).empty() && !by_name_.contains(flag)) return flag;
  return std::nullopt;
}

bool TiledFlagReader::has_role(int flag) const {
  const auto& infos = flag_role_infos();
  return std::any_of(infos.begin(), infos.end(),
                     [&](const FlagRoleInfo& role) { return level_.roles.*role.flag == flag; });
}

// Whether the flag has no meaning but its role.
bool TiledFlagReader::is_free(int flag) const {
  return field_of_flag(level_.flag_fields, flag) == nullptr &&
         level_.flag_names[static_cast<std::size_t>(flag)].empty() &&
         level_.flag_shapes[static_cast<std::size_t>(flag)].kind == TileShape::Kind::none;
}

bool TiledFlagReader::knows(const TiledProperty& property) const {
  constexpr std::array<std::string_view, 6> kKnown = {"flags",         "shape",      "shape_heights",
                                                      "shape_one_way", "shape_side", kTiledConveyor};
  const auto is_one_of = [&](const auto& names) {
    return std::find(names.begin(), names.end(), property.name) != names.end();
  };
  return is_flag(property.name) || is_one_of(kKnown) || is_one_of(kTiledSolidWords);
}

FlagSet TiledFlagReader::flags_of(const TiledTile& tile, ImportDrops& drops) const {
  FlagSet flags = 0;
  for (const TiledProperty& property : tile.properties) {
    if (property.name != "flags") continue;
    const auto* const number = std::get_if<std::int64_t>(&property.value);
    const auto all = number != nullptr ? flags_of_tiled_number(*number) : std::nullopt;
    if (all)
      flags = *all;
    else
      drops.add("`flags` of a tile, which is not a whole number of 32 bits");
  }
  for (const TiledProperty& property : tile.properties) {
    const auto flag = flags_.find(property.name);
    const bool* const is_on = std::get_if<bool>(&property.value);
    if (flag != flags_.end() && is_on != nullptr) {
      FlagPattern pattern = pattern_of_flag(flag->second);
      if (!*is_on) pattern.bits = 0;
      flags = pattern.put_in(flags);
    }
  }
  return flags;
}

}  // namespace talus
