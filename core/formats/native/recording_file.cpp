// Reads and writes recordings.
#include "recording_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "../files/atomic_file.h"
#include "../last_catch.h"
#include "../text/hex.h"
#include "input_entry.h"
#include "native.h"
#include "native_document.h"
#include "native_members.h"
#include "native_objects.h"

namespace talus {
namespace {

constexpr std::size_t kHashDigits = 16;
constexpr std::size_t kHashesInText = 8;
// limit for the list entries that the patches of all edits may move; patches of Talus move none
constexpr std::size_t kMaxMovedEntries = 20'000'000;

// What a patch adds stands in five objects and lists: the recording, its edits, an edit, a patch, an
// operation.
constexpr int kMaxDeep = kMaxJsonDepth + 5;

// Thrown and caught in this file only: ends the reading of nested values at the first error.
struct WrongRecording {
  FormatError error;
};
[[noreturn]] void refuse(const std::string& key, const std::string& message) {
  throw WrongRecording{{"key " + key, message}};
}

std::string too_deep() { return "is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels"; }

double share_of(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

std::string entry_path(const char* list, std::size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

std::int64_t whole(const Json& object, const std::string& path, const char* key, std::int64_t min,
                   std::int64_t max) {
  const std::string place = path + key;
  if (!object.contains(key)) refuse(place, "is missing");
  const Json& value = object[key];
  if (!is_whole(value, min, max))
    refuse(place, "must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  return value.get<std::int64_t>();
}

const Json& list_member(const Json& object, const char* key) {
  static const Json kNone = Json::array();
  if (!object.contains(key)) return kNone;
  if (!object[key].is_array()) refuse(key, "must be a list");
  return object[key];
}

void check_keys(const Json& object, const std::string& path, std::initializer_list<std::string_view> known) {
  if (!object.is_object()) refuse(path, "must be an object");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(path.empty() ? key : path + "." + key, "is not a key of recordings");
  }
}

Level level_in(Json json, const std::string& path) {
  auto level = level_of_document(std::move(json));
  if (!level) throw WrongRecording{error_within("key " + path, level.error())};
  return *std::move(level);
}

// The same without its cart, which no edit of the physics needs. `json` stays as it is.
Level level_without_cart_in(Json& json, const std::string& path) {
  if (!json.is_object() || !json.contains("cart")) return level_in(json, path);
  Json cart = std::move(json["cart"]);
  json.erase("cart");
  Level level = level_in(json, path);
  json["cart"] = std::move(cart);
  return level;
}

const TuningField& run_speed_field() {
  const auto fields = tuning_fields();
  return *std::find_if(fields.begin(), fields.end(),
                       [](const TuningField& field) { return field.path() == "player.run_speed"; });
}

// Measures what the edits of a recording take together, in the same way for reading and writing.
class EditAmounts {
 public:
  explicit EditAmounts(const LevelVersion& first) : bytes_(memory_of(first, nullptr)) {}

  // Returns nothing if the edit from one version to the next fits.
  std::optional<FormatError> add(const LevelVersion& before, const LevelVersion& after, const Level& edited) {
    read_ += size_of(edited);
    bytes_ += memory_of(after, &before);
    if (read_ <= kMaxEditedBytes && bytes_ <= kMaxVersionBytes) return std::nullopt;
    return FormatError{"key edits", "has too many edits for a level of this size"};
  }

 private:
  std::size_t read_ = 0, bytes_;
};

FormatError too_many_edits() {
  return {"key edits", "has more than " + std::to_string(kMaxRecordedEdits) + " edits of the level"};
}

// The body that plays alone; null: there is none.
FormatResult<Json> alone_of(const std::optional<LoneBody>& alone) {
  if (!alone) return Json();
  auto json = json_of(alone->spawn, "alone");
  if (!json) return json;
  (*json)["stands"] = alone->stands;
  (*json)["run_speed"] = json_number(alone->run_speed);
  return json;
}

// ---- Reading ----

class RecordingReader {
 public:
  explicit RecordingReader(Progress progress) : progress_(std::move(progress)) {}

  Recording read(Json document) {
    if (!document.is_object()) throw WrongRecording{{"", "is JSON, but not a recording"}};
    const std::string version_key(kRecordingKey);
    if (!document.contains(version_key)) refuse(version_key, "is missing, so this is not a recording");
    if (whole(document, "", version_key.c_str(), 1, 1'000'000) > kRecordingVersion)
      refuse(version_key,
             "is newer than what this Talus reads, version " + std::to_string(kRecordingVersion));
    check_keys(document, "",
               {kRecordingKey, "frames", "marks", "level", "alone", "edits", "input", "hashes"});
    read_hashes(document);
    read_marks(list_member(document, "marks"));
    read_input(list_member(document, "input"));
    if (!document.contains("level")) refuse("level", "is missing");
    if (depth_of(document["level"]) > kMaxJsonDepth) refuse("level", too_deep());
    recording_.level = level_in(document["level"], "level");
    if (document.contains("alone")) read_alone(document["alone"]);
    const Json& edits = list_member(document, "edits");
    if (edits.size() > kMaxRecordedEdits) throw WrongRecording{too_many_edits()};
    read_edits(edits, document["level"]);
    return std::move(recording_);
  }

 private:
  // The hashes give the number of frames before memory is taken for them.
  void read_hashes(const Json& document) {
    if (!document.contains("hashes")) refuse("hashes", "is missing");
    const Json& texts = list_member(document, "hashes");
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string path = entry_path("hashes", i);
      if (!texts[i].is_string()) refuse(path, "must be a string");
      read_hash_text(texts[i].get_ref<const std::string&>(), path);
    }
    const bool has_any = !recording_.hashes.empty();
    const auto most = has_any ? static_cast<std::int64_t>(kMaxFileBytes) : kMaxUnhashedFrames;
    recording_.frames = whole(document, "", "frames", 0, most);
    if (!has_any) return;
    const auto wanted = static_cast<std::size_t>(recording_.frames) + 1;
    if (recording_.hashes.size() != wanted) {
      refuse("hashes", "must hold " + std::to_string(wanted) + " hashes, one more than frames, not " +
                           std::to_string(recording_.hashes.size()));
    }
  }

  void read_hash_text(std::string_view text, const std::string& path) {
    for (std::size_t at = 0; at < text.size(); at += kHashDigits + 1) {
      std::uint64_t hash = 0;
      const std::string_view digits = text.substr(at, kHashDigits);
      bool good = digits.size() == kHashDigits;
      for (const char c : digits) {
        good = good && hex_value(c) >= 0;
        hash = hash << 4 | static_cast<std::uint64_t>(hex_value(c) & 15);
      }
      const std::size_t end = at + kHashDigits;
      if (!good || (end < text.size() && (text[end] != ' ' || end + 1 == text.size())))
        refuse(path, "must be hashes of 16 hexadecimal digits with a space between them");
      recording_.hashes.push_back(hash);
    }
  }

  void read_marks(const Json& marks) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const std::string path = entry_path("marks", i);
      check_keys(marks[i], path, {"frame", "name"});
      const std::int64_t frame = whole(marks[i], path + ".", "frame", 0, recording_.frames);
      if (i > 0 && frame <= recording_.marks.back().frame)
        refuse(path + ".frame", "is not after the one before");
      const Json name = marks[i].value("name", Json(""));
      if (!name.is_string()) refuse(path + ".name", "must be a string");
      recording_.marks.push_back({frame, name.get<std::string>()});
    }
  }

  void read_input(const Json& entries) {
    RecordedInput held;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string path = entry_path("input", i);
      const std::int64_t before = i == 0 ? 0 : held.frame;
      if (const std::string wrong = take_input_entry(entries[i], held); !wrong.empty()) refuse(path, wrong);
      if (held.frame <= before) refuse(path + ".frame", "is not after the one before");
      if (held.frame > recording_.frames) refuse(path + ".frame", "is after the last frame");
      recording_.input.push_back(held);
    }
  }

  void read_alone(Json json) {
    const std::string path = "alone";
    LoneBody body;
    body.run_speed = recording_.level.tuning.player.run_speed;
    MemberTaker take(json, path);
    take.optional("stands", body.stands);
    take.optional("run_speed", body.run_speed);
    const TuningField& speed = run_speed_field();
    if (!speed.accepts(body.run_speed)) take.fail("run_speed", range_text(speed.min, speed.max, speed.unit));
    const auto taken = take.result(true);
    if (!taken) throw WrongRecording{taken.error()};
    auto spawn = take_spawn(json, path);
    if (!spawn) throw WrongRecording{spawn.error()};
    if (!json.empty()) refuse(path + "." + json.begin().key(), "is not a key of recordings");
    body.spawn = *std::move(spawn);
    recording_.alone = std::move(body);
  }

  void read_edits(const Json& edits, Json level) {
    auto before = std::make_shared<const LevelVersion>(version_of(recording_.level));
    EditAmounts amounts(*before);
    std::int64_t last = 1;
    for (std::size_t i = 0; i < edits.size(); ++i) {
      if (!progress_.at(i, edits.size())) throw WrongRecording{was_cancelled().value()};
      const std::string path = entry_path("edits", i);
      check_keys(edits[i], path, {"frame", "patch"});
      const std::int64_t frame = whole(edits[i], path + ".", "frame", 1, recording_.frames);
      if (frame < last) refuse(path + ".frame", "goes backwards");
      last = frame;
      if (!edits[i].contains("patch")) refuse(path + ".patch", "is missing");
      const double before_it = share_of(i, edits.size()), after_it = share_of(i + 1, edits.size());
      apply_patch(edits[i]["patch"], path + ".patch", level, progress_.part(before_it, after_it));
      const Level edited = level_without_cart_in(level, path);
      auto after = std::make_shared<const LevelVersion>(version_of(edited, before.get()));
      if (auto problem = amounts.add(*before, *after, edited)) throw WrongRecording{*std::move(problem)};
      before = std::move(after);
      recording_.edits.push_back({frame, before});
    }
  }

  // "copy" is not allowed: with it a short patch could make a level that fills the memory.
  void apply_patch(const Json& patch, const std::string& path, Json& level, const Progress& progress) {
    if (!patch.is_array()) refuse(path, "must be a list");
    for (std::size_t i = 0; i < patch.size(); ++i) {
      if (!progress.at(i, patch.size())) throw WrongRecording{was_cancelled().value()};
      const Json kind = patch[i].is_object() ? patch[i].value("op", Json()) : Json();
      if (kind != "add" && kind != "remove" && kind != "replace")
        refuse(entry_path(path.c_str(), i), R"(must have an "op": "add", "remove" or "replace")");
      try {
        if (levels_after(patch[i]) > kMaxJsonDepth)
          refuse(entry_path(path.c_str(), i), "makes a level that " + too_deep());
        count_moves(patch[i], path, level);
        level.patch_inplace(Json::array({patch[i]}));
      } catch (const Json::exception&) {
        refuse(path, "does not fit the level before it");
      }
    }
  }

  // How deep the level is, at least, where the operation puts its value: each name in the path is one further
  // in. Copying a deeper one would overflow the stack.
  static std::ptrdiff_t levels_after(const Json& operation) {
    if (operation["op"] == "remove") return 0;
    const std::string& path = operation.at("path").get_ref<const std::string&>();
    return std::count(path.begin(), path.end(), '/') + depth_of(operation.at("value"));
  }

  // Adding an entry to a list, or removing one, moves all entries behind it. Json::exception: the place does
  // not exist.
  void count_moves(const Json& operation, const std::string& path, const Json& level) {
    const Json::json_pointer place(operation.at("path").get_ref<const std::string&>());
    if (operation["op"] == "replace" || place.empty() || place.back() == "-") return;
    const Json& list = level.at(place.parent_pointer());
    if (!list.is_array()) return;
    std::size_t index = 0;
    const std::string& digits = place.back();
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (problem == std::errc() && index < list.size()) moved_ += list.size() - index;
    if (moved_ > kMaxMovedEntries) refuse(path, "moves too many entries of lists");
  }

  Recording recording_;
  Progress progress_;
  std::size_t moved_ = 0;  // entries of lists that the patches have moved so far
};

// ---- Writing ----

std::string hash_digits(std::uint64_t hash) {
  std::string text(kHashDigits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4) *digit = kHexDigits[hash & 15];
  return text;
}

Json hash_texts(const std::vector<std::uint64_t>& hashes) {
  Json texts = Json::array();
  for (std::size_t i = 0; i < hashes.size(); i += kHashesInText) {
    std::string text = hash_digits(hashes[i]);
    for (std::size_t j = i + 1; j < std::min(i + kHashesInText, hashes.size()); ++j)
      text += " " + hash_digits(hashes[j]);
    texts.push_back(std::move(text));
  }
  return texts;
}

// The list with one entry on each line.
std::string input_text(const std::vector<RecordedInput>& input) {
  std::string text = "[";
  RecordedInput before;
  for (const RecordedInput& entry : input) {
    const Json json = input_entry(entry, before);
    before = entry;
    text += text.size() > 1 ? ",\n  {" : "\n  {";
    for (const char* key : {"frame", "mouse", "down", "grab", "keys"}) {
      if (!json.contains(key)) continue;
      text.append(text.back() == '{' ? "\"" : ", \"").append(key).append("\": ").append(json[key].dump());
    }
    text += "}";
  }
  return text + (input.empty() ? "]\n" : "\n]\n");
}

// The patch from one native level to another. If a list lost or got entries, the diff would name every entry
// behind them; so a long list is replaced as a whole.
Json patch_between(const Json& before, const Json& after) {
  constexpr std::size_t kLong = 256;
  Json patch = Json::array();
  Json patched = before;
  for (const auto& [key, value] : after.items()) {
    const auto old = patched.find(key);
    if (old == patched.end() || !value.is_array() || !old->is_array()) continue;
    if (value.size() == old->size() || std::max(value.size(), old->size()) < kLong) continue;
    patch.push_back({{"op", "replace"}, {"path", "/" + key}, {"value", value}});
    *old = value;
  }
  for (Json& operation : Json::diff(patched, after)) patch.push_back(std::move(operation));
  return patch;
}

Level without_cart(Level level) {
  level.cart.reset();
  return level;
}

// Why a reader would refuse the edits.
std::optional<FormatError> problem_of_edits(const Recording& recording) {
  if (recording.edits.size() > kMaxRecordedEdits) return too_many_edits();
  Level level = without_cart(recording.level);
  LevelVersion version = version_of(level);
  EditAmounts amounts(version);
  for (const RecordedEdit& edit : recording.edits) {
    put_version(*edit.version, level);
    LevelVersion next = version_of(level, &version);
    if (auto problem = amounts.add(version, next, level)) return problem;
    version = std::move(next);
  }
  return std::nullopt;
}

FormatResult<Json> edits_of(const Recording& recording) {
  if (auto problem = problem_of_edits(recording)) return tl::unexpected(*std::move(problem));
  Json edits = Json::array();
  Level level = without_cart(recording.level);
  auto before = native_document(level);
  if (!before) return before;
  for (const RecordedEdit& edit : recording.edits) {
    put_version(*edit.version, level);
    auto after = native_document(level);
    if (!after) return after;
    edits.push_back({{"frame", edit.frame}, {"patch", patch_between(*before, *after)}});
    before = std::move(after);
  }
  return edits;
}

Json marks_of(const std::vector<Mark>& marks) {
  Json list = Json::array();
  for (const Mark& mark : marks) list.push_back({{"frame", mark.frame}, {"name", mark.name}});
  return list;
}

// A printed value as it stands in an object.
std::string indented(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, text.size() - 1)) {  // without the line break at its end
    out += c;
    if (c == '\n') out += "  ";
  }
  return out;
}

}  // namespace

bool is_recording(std::string_view bytes, const FormatContext& context) {
  return context.extension == kRecordingExtension ||
         bytes.substr(0, 200).find("\"" + std::string(kRecordingKey) + "\"") != std::string_view::npos;
}

FormatResult<Recording> read_recording(std::string_view bytes, const Progress& progress) {
  constexpr double kParsed = 0.2;  // share of the time, if the level was edited
  auto document = parse_json(bytes, progress.part(0, kParsed), 1, kMaxDeep);
  if (!document) return tl::unexpected(document.error());
  try {
    return RecordingReader(progress.part(kParsed, 1)).read(*std::move(document));
  } catch (const WrongRecording& wrong) {
    return tl::unexpected(wrong.error);
  }
}

FormatResult<std::string> write_recording(const Recording& recording) {
  const auto level = write_native(recording.level, {});
  if (!level) return tl::unexpected(level.error());
  const auto alone = alone_of(recording.alone);
  if (!alone) return tl::unexpected(alone.error());
  const auto edits = edits_of(recording);
  if (!edits) return tl::unexpected(edits.error());
  constexpr std::array<std::string_view, 2> kOrder = {"frame", "op"};
  std::string text = "{";
  const auto add = [&](std::string_view key, std::string_view printed) {
    text.append(text.size() > 1 ? ",\n  \"" : "\n  \"").append(key).append("\": ").append(indented(printed));
  };
  try {
    add(kRecordingKey, print_json(alone->is_null() ? 1 : kRecordingVersion, kOrder));
    add("frames", print_json(recording.frames, kOrder));
    add("marks", print_json(marks_of(recording.marks), kOrder));
    add("level", level->bytes);
    if (!alone->is_null()) add("alone", print_json(*alone, kOrder));
    add("edits", print_json(*edits, kOrder));
    add("input", input_text(recording.input));
    add("hashes", print_json(hash_texts(recording.hashes), kOrder));
  } catch (const Json::exception&) {
    return tl::unexpected(FormatError{"key marks", "has a name that is not valid UTF-8"});
  }
  text += "\n}\n";
  if (auto problem = problem_of_size(text)) return tl::unexpected(FormatError{"", *std::move(problem)});
  return text;
}

FormatResult<Recording> load_recording(const std::string& path, const Progress& progress) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_guarded([&] { return read_recording(*bytes, progress); });
}

FormatResult<void> save_recording(const Recording& recording, const std::string& path) {
  const auto bytes = write_recording(recording);
  if (!bytes) return tl::unexpected(bytes.error());
  return write_file_atomic(path, *bytes);
}

}  // namespace talus
