// Reads each field, and checks all of them together.
#include "native_flags.h"

#include <algorithm>

#include "native_members.h"

namespace talus {
namespace {

tl::unexpected<FormatError> error_at_key(const std::string& path, std::string message) {
  return tl::unexpected(FormatError{"key " + path, std::move(message)});
}

bool are_strings(const Json& json) {
  return json.is_array() &&
         std::all_of(json.begin(), json.end(), [](const Json& v) { return v.is_string(); });
}

FormatResult<FlagField> take_flag_field(Json json, const std::string& path) {
  if (!json.is_object()) return error_at_key(path, "must be an object");
  const Json name = json.value("name", Json("")), values = json.value("values", Json::array());
  const Json first = json.value("first", Json()), bits = json.value("bits", Json());
  if (!name.is_string()) return error_at_key(path + ".name", "must be a string");
  if (!is_whole(first, 0, kMaxFlags - FlagField::kLeastBits))
    return error_at_key(path + ".first", "must be a flag from 0 to 30");
  if (!is_whole(bits, FlagField::kLeastBits, FlagField::kMaxBits))
    return error_at_key(path + ".bits", "must be a whole number from 2 to 8");
  if (!are_strings(values)) return error_at_key(path + ".values", "must be a list of strings");
  FlagField field{name, first, bits, values, {}};
  if (auto problem = problem_of(field)) return error_at_key(path, *std::move(problem));
  for (const char* known : {"name", "first", "bits", "values"}) json.erase(known);
  if (!json.empty()) field.extra = json.dump();
  return field;
}

std::string path_of(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

}  // namespace

FormatResult<FlagSet> take_flags(const Json& list, const std::string& path) {
  const bool good = list.is_array() && std::all_of(list.begin(), list.end(), [](const Json& flag) {
                      return is_whole(flag, 0, kMaxFlags - 1);
                    });
  if (!good) return error_at_key(path, "must be a list of flags from 0 to 31");
  FlagSet flags = 0;
  for (const Json& flag : list) flags |= flag_bit(flag.get<int>());
  return flags;
}

Json json_of_flags(FlagSet flags) {
  Json list = Json::array();
  for (int flag = 0; flag < kMaxFlags; ++flag)
    if (has_flag(flags, flag)) list.push_back(flag);
  return list;
}

FormatResult<std::array<std::string, kMaxFlags>> take_flag_names(const Json& list, const std::string& path) {
  if (!are_strings(list) || list.size() > kMaxFlags)
    return error_at_key(path, "must be a list of up to 32 strings");
  std::array<std::string, kMaxFlags> names;
  for (std::size_t flag = 0; flag < list.size(); ++flag) names[flag] = list[flag].get<std::string>();
  return names;
}

Json json_of(const std::array<std::string, kMaxFlags>& names) {
  std::size_t count = names.size();
  while (count > kCartFlags && names[count - 1].empty()) --count;
  Json list = Json::array();
  for (std::size_t flag = 0; flag < count; ++flag) list.push_back(names[flag]);
  return list;
}

bool has_more_flags(const Level& level) { return (used_flags(level) & ~kCartFlagSet) != 0; }

FormatResult<std::vector<FlagField>> take_flag_fields(const Json& list, const std::string& path) {
  if (!list.is_array()) return error_at_key(path, "must be a list");
  std::vector<FlagField> fields;
  for (const Json& json : list) {
    auto field = take_flag_field(json, path_of(path, fields.size()));
    if (!field) return tl::unexpected(field.error());
    fields.push_back(*std::move(field));
    if (overlapping_field(fields))
      return error_at_key(path_of(path, fields.size() - 1), "has a flag of another field");
  }
  return fields;
}

FormatResult<Json> json_of(const std::vector<FlagField>& fields, const std::string& path) {
  Json list = Json::array();
  for (const FlagField& field : fields) {
    auto json = parse_extra(field.extra);
    if (!json) return json;
    if (!field.name.empty()) (*json)["name"] = field.name;
    (*json)["first"] = field.first;
    (*json)["bits"] = field.bits;
    if (!field.values.empty()) (*json)["values"] = field.values;
    list.push_back(*std::move(json));
  }
  if (const auto good = take_flag_fields(list, path); !good) return tl::unexpected(good.error());
  return list;
}

}  // namespace talus
