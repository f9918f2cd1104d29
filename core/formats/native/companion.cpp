// Takes the difference of two documents, and adds it again.
#include "companion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "../text/content_hash.h"
#include "../text/hex.h"
#include "../text/json_text.h"
#include "moved_companion.h"
#include "moved_members.h"
#include "native.h"
#include "native_document.h"
#include "tiled_frame_json.h"

namespace talus {
namespace {

constexpr const char* kAbout = "companion";

// The members of `whole` that `part` does not have, or has with other values; null for those that only `part`
// has.
Json difference(const Json& whole, const Json& part) {
  Json differing = Json::object();
  for (const auto& [key, value] : whole.items()) {
    const auto other = part.find(key);
    if (other != part.end() && *other == value) continue;
    const bool are_objects = other != part.end() && value.is_object() && other->is_object();
    differing[key] = are_objects ? difference(value, *other) : value;
  }
  for (const auto& [key, value] : part.items()) {
    if (!whole.contains(key)) differing[key] = nullptr;
  }
  return differing;
}

// The same without its cart, which a file of such a format is itself.
FormatResult<Json> document_without_cart(const Level& level) {
  if (!level.cart) return native_document(level);
  Level bare = level;
  bare.cart.reset();
  return native_document(bare);
}

// Layers of objects as a file has them: in the order in which they are drawn, without empty ones.
Json drawn_layers(const Json& document) {
  const auto tiles = document.find("layers");
  const auto count = tiles != document.end() && tiles->is_array() ? std::ssize(*tiles) : 1;
  Json drawn = Json::array();
  for (const Json& layer : document.value("objects", Json::array())) {
    if (!layer.is_object() || (layer.value("objects", Json::array()).empty() && !layer.contains("image")))
      continue;
    drawn.push_back(layer);
    Json& place = drawn.back()["place"];
    place = is_whole(place, 0, count) ? place : Json(count);
  }
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const Json& a, const Json& b) { return a["place"] < b["place"]; });
  return drawn;
}

std::string hash_of(const Json* value) {
  std::uint64_t hash =
      content_hash(value == nullptr ? "" : value->dump(-1, ' ', false, Json::error_handler_t::replace));
  std::string text;
  for (int digit = 0; digit < 16; ++digit, hash <<= 4) text += kHexDigits[hash >> 60];
  return text;
}

// as_drawn: of layers of objects as they are drawn; older versions took them as they were listed.
std::string hash_of_member(const Json& document, const std::string& member, bool as_drawn = true) {
  const auto found = document.find(member);
  if (found == document.end()) return hash_of(nullptr);
  if (member != "objects" || !as_drawn) return hash_of(&*found);
  const Json drawn = drawn_layers(document);
  return hash_of(drawn.empty() ? nullptr : &drawn);
}

bool are_objects(const Json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const Json& v) { return v.is_object(); });
}

// Whether both are the same but for the last bits of their numbers.
bool has_near_numbers(const Json& a, const Json& b) {
  constexpr double kSlack = 1e-9;
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    return std::abs(x - y) <= kSlack * std::max(1.0, std::abs(x));
  }
  if (a.is_array() && b.is_array())
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), has_near_numbers);
  if (!a.is_object() || !b.is_object() || a.size() != b.size()) return a == b;
  return std::all_of(a.items().begin(), a.items().end(), [&](const auto& item) {
    const auto other = b.find(item.key());
    return other != b.end() && has_near_numbers(item.value(), *other);
  });
}

// Lays the members of a companion over those of its file.
class Joiner {
 public:
  // has_moved: whether both were moved to the place of their ground, by sums that differ in their last bits.
  explicit Joiner(bool has_moved) : has_moved_(has_moved) {}
  void join(Json& document, Json added, const std::vector<std::string>& changed) {
    for (const auto& [key, value] : added.items()) {
      is_changed_ = std::find(changed.begin(), changed.end(), key) != changed.end();
      is_roles_ = key == "roles";
      is_layers_ = key == "objects";
      put(document, key, value);
    }
  }
  bool left_out() const { return left_out_; }

 private:
  void put(Json& object, const std::string& key, Json& value) {
    const auto held = object.find(key);
    if (held == object.end()) {
      if (!(is_changed_ && value.is_null())) object[key] = std::move(value);
    } else if (held->is_object() && value.is_object()) {
      for (const auto& [name, member] : value.items()) put(*held, name, member);
    } else if (is_changed_) {
      keep(*held, value);
    } else if (value.is_null() && !is_roles_) {
      object.erase(held);
    } else {
      *held = std::move(value);
    }
  }

  // The file has a value of its own, which may be newer.
  void keep(Json& held, const Json& value) {
    if (is_same(held, value)) return;
    if (is_layers_ || !are_objects(held) || !are_objects(value)) {
      left_out_ = true;
      return;
    }
    for (const Json& entry : value) {
      const auto same =
          std::find_if(held.begin(), held.end(), [&](const Json& its) { return has_all_of(entry, its); });
      if (same == held.end())
        held.push_back(entry);
      else
        *same = entry;
    }
  }

  // Whether an entry has all members of another one, and maybe some that the file cannot hold.
  bool has_all_of(const Json& entry, const Json& other) const {
    return std::all_of(other.items().begin(), other.items().end(), [&](const auto& item) {
      const auto found = entry.find(item.key());
      return found != entry.end() && is_same(*found, item.value());
    });
  }
  bool is_same(const Json& a, const Json& b) const { return has_moved_ ? has_near_numbers(a, b) : a == b; }

  bool has_moved_;
  bool is_changed_ = false;  // whether another program changed the current member of the document
  bool is_roles_ = false;
  bool is_layers_ = false;  // layers of objects, which the file has with its own changes
  bool left_out_ = false;
};

// Adds the flags that no cart has to the tiles of a cart that another program has changed, and removes all
// flags of these tiles from `added`: the others may be newer in the cart. member: of both.
void join_flags(Json& document, const std::string& member, Json& added) {
  const auto tiles = added.find(member);
  if (tiles == added.end() || !tiles->is_object()) return;
  for (const auto& [tile, entry] : tiles->items()) {
    const auto flags = entry.is_object() ? entry.find("flags") : entry.end();
    if (flags == entry.end() || !flags->is_array()) continue;
    for (const Json& flag : *flags)
      if (!is_whole(flag, 0, kCartFlags - 1)) document[member][tile]["flags"].push_back(flag);
    entry.erase(flags);
  }
}

// The size that the companion gives the map, but not smaller than the cells that the file fills. Removes it
// from `added`. Returns whether it had to grow.
bool join_map_size(Json& document, Json& added) {
  const auto map = added.find("map");
  if (map == added.end() || !map->is_object()) return false;
  const Json& rows = document["map"]["rows"];
  std::size_t width = 0;
  for (const Json& row : rows) width = std::max(width, row.get_ref<const std::string&>().size() / 2);
  bool has_grown = false;
  const auto take = [&](const char* side, std::size_t least) {
    const auto size = map->find(side);
    if (size == map->end()) return;
    const bool is_small = size->is_number_unsigned() && size->get<std::uint64_t>() < least;
    document["map"][side] = is_small ? Json(least) : *size;
    has_grown = has_grown || is_small;
    map->erase(side);
  };
  take("width", width);
  take("height", rows.size());
  return has_grown;
}

// Calls change(entry) for everything in a document that may name a picture by its number.
template <class Change>
void for_each_pictured(Json& document, Change change) {
  const auto large = document.find("large_tiles"), layers = document.find("objects");
  if (large != document.end() && large->is_object()) {
    for (Json& tile : *large) change(tile);
  }
  if (layers == document.end() || !layers->is_array()) return;
  for (Json& layer : *layers) {
    if (!layer.is_object()) continue;
    if (const auto image = layer.find("image"); image != layer.end()) change(*image);
    const auto objects = layer.find("objects");
    if (objects == layer.end() || !objects->is_array()) continue;
    for (Json& object : *objects) change(object);
  }
}

// Puts the pictures of the companion behind those of the file, each once, and removes them from `added`, in
// which their numbers are changed to these. So what the file keeps goes on to name its own pictures.
void join_pictures(Json& document, Json& added) {
  const auto found = added.find("pictures");
  if (found == added.end()) return;
  const Json own = std::move(*found);
  added.erase(found);
  if (!own.is_array()) return;
  std::vector<std::size_t> numbers;  // in the document, by number in the companion
  Json all = document.value("pictures", Json::array());
  for (const Json& picture : own) {
    const auto same = std::find(all.begin(), all.end(), picture);
    numbers.push_back(static_cast<std::size_t>(same - all.begin()));
    if (same == all.end()) all.push_back(picture);
  }
  document["pictures"] = std::move(all);
  for_each_pictured(added, [&](Json& entry) {
    const auto number = entry.is_object() ? entry.find("picture") : entry.end();
    if (number == entry.end() || !is_whole(*number, 0, std::ssize(numbers) - 1)) return;
    *number = numbers[number->get<std::size_t>()];
  });
}

// The note on a file that was changed since its companion was saved.
std::string change_note(const std::string& file, const Json& about, const std::vector<std::string>& changed,
                        bool left_out, bool has_grown) {
  const auto name = about.find("file");
  const std::string own = file + std::string(kCompanionEnding);
  std::string note = name != about.end() && *name == file
                         ? file + " was changed since " + own + " was saved with it ("
                         : file + " is not the file that " + own + " was saved with (other ";
  for (const std::string& member : changed) note += (&member == changed.data() ? "" : ", ") + member;
  note += left_out ? "); both are kept, but where they disagree, " + file + " counts"
                   : "); all that was added is kept";
  return note + (has_grown ? ", and the map is as large as its cells need" : "");
}

tl::unexpected<FormatError> no_companion(std::string message) {
  return tl::unexpected(FormatError{"", std::move(message)});
}

// What the companion says about its file. Removes it from the document.
FormatResult<Json> take_about(Json& companion) {
  if (!companion.is_object() || !companion.contains(kAbout))
    return no_companion("is a file of its own, not the companion of another one");
  Json about = companion[kAbout];
  companion.erase(kAbout);
  if (!about.is_object()) return tl::unexpected(FormatError{"key companion", "must be an object"});
  if (companion.contains("cart") && companion["cart"].is_object() && companion["cart"].contains("kind"))
    return tl::unexpected(
        FormatError{"key cart", "must not be in a companion: the file beside it holds the cart"});
  return about;
}

std::vector<std::string> changed_members(const Json& document, const Json& about, const Format& format) {
  const auto with = about.find("with");
  std::vector<std::string> changed;
  for (const std::string_view held : format.holds) {
    const std::string member(held);
    const bool has_hashes = with != about.end() && with->is_object() && !with->empty();
    const bool is_unknown =  // to older versions
        has_hashes && (member == "objects" || member == "background") && !with->contains(member);
    const Json then = has_hashes ? with->value(member, Json()) : Json();
    const auto is_listed_so = [&] {
      return member == "objects" && then == hash_of_member(document, member, false);
    };
    const bool fits =
        is_unknown || (has_hashes && (then == hash_of_member(document, member) || is_listed_so()));
    if (!fits) changed.push_back(member);
  }
  return changed;
}

}  // namespace

std::optional<TiledFrame> frame_of_companion(std::string_view bytes) {
  if (bytes.find("\"frame\"") == std::string_view::npos) return std::nullopt;
  const auto json = parse_json(bytes);
  if (!json || !json->is_object()) return std::nullopt;
  const Json about = json->value(kAbout, Json());
  const Json json_frame = about.is_object() ? about.value("frame", Json()) : Json();
  return tiled_frame_of_json(json_frame);
}

std::string owner_of_companion(const std::string& path) {
  if (!path.ends_with(kCompanionEnding)) return {};
  std::string owner = path.substr(0, path.size() - kCompanionEnding.size());
  if (owner.empty() || owner.ends_with('/')) return {};
  std::error_code error;
  const bool is_of_ldtk =
      !std::filesystem::exists(owner, error) && std::filesystem::exists(owner + ".ldtk", error);
  return is_of_ldtk ? owner + ".ldtk" : owner;
}

bool is_companion(std::string_view bytes) {
  if (bytes.find("\"companion\"") == std::string_view::npos) return false;
  const auto json = parse_json(bytes);
  return json && json->is_object() && json->contains(kAbout);
}

bool begins_as_companion(std::string_view start) {
  constexpr std::array<std::string_view, 1> kKey = {kAbout};
  return has_key(start, kKey);
}

FormatResult<std::string> write_companion(const Level& level, const Level& held, const Format& format,
                                          const std::string& file, bool even_empty) {
  const auto whole = document_without_cart(level), part = document_without_cart(held);
  if (!whole) return tl::unexpected(whole.error());
  if (!part) return tl::unexpected(part.error());
  Json companion = difference(*whole, *part);
  if (companion.empty() && !even_empty) return std::string();
  companion["talus"] = (*whole)["talus"];
  Json& about = companion[kAbout] = {{"file", file}};
  if (held.tiled) {
    about["frame"] = json_of_tiled_frame(held.tiled->frame);
    about["frame"]["ground"] = json_of_ground(ground_place(held));
  }
  for (const std::string_view member : format.holds)
    about["with"][std::string(member)] = hash_of_member(*part, std::string(member));
  return print_document(companion);
}

FormatResult<JoinedLevel> join_companion(std::string_view bytes, const Level& held, const Format& format,
                                         const std::string& file) {
  auto companion = parse_json(bytes);
  if (!companion) return tl::unexpected(companion.error());
  const auto about = take_about(*companion);
  if (!about) return tl::unexpected(about.error());
  auto document = document_without_cart(held);
  if (!document) return tl::unexpected(document.error());
  const auto place = ground_of_frame(*about);
  const Cell by = place && held.tiled ? ground_shift(*place, held) : Cell{0, 0};
  const bool has_moved = by != Cell{0, 0};
  const int lost_curves = has_moved ? move_companion(*companion, by, *place, held) : 0;
  const auto then = has_moved ? document_before_shift(held, by, *place) : std::nullopt;
  const std::vector<std::string> changed = changed_members(then ? *then : *document, *about, format);
  const bool has_grown = join_map_size(*document, *companion);
  join_pictures(*document, *companion);
  for (const std::string& member : changed)
    if (held.cart != nullptr) join_flags(*document, member, *companion);
  Joiner joiner(has_moved);
  joiner.join(*document, *std::move(companion), changed);
  auto level = level_of_document(*std::move(document));
  if (!level) return tl::unexpected(level.error());
  level->cart = held.cart;
  level->tiled = held.tiled;
  JoinedLevel joined{*std::move(level), "", !joiner.left_out() && lost_curves == 0};
  if (!changed.empty()) joined.note = change_note(file, *about, changed, joiner.left_out(), has_grown);
  if (has_moved)
    joined.note =
        with_shift_note(joined.note, file, by, growth_at_corner(*place, held.map, by) == by, lost_curves);
  return joined;
}

}  // namespace talus
