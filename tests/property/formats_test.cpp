// Random carts and levels: what every format must keep, whatever the content is.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "formats/native/companion.h"
#include "formats/native/native.h"
#include "formats/tic80/tic_cart.h"
#include "formats/tic80/tic_text.h"
#include "unit/zipped.h"

namespace talus::formats_test {

std::string random_bytes(std::size_t size) {
  auto bytes = *rc::gen::container<std::string>(size, rc::gen::arbitrary<char>());
  return bytes;
}

// A section of mostly zeros, like real ones, of any length that it may have.
std::string random_section(const SectionInfo& info) {
  std::string data(*rc::gen::inRange<std::size_t>(1, info.size() + 1), '\0');
  for (int i = *rc::gen::inRange(0, 20); i > 0; --i) {
    data[*rc::gen::inRange<std::size_t>(0, data.size())] = *rc::gen::arbitrary<char>();
  }
  return data;
}

std::string random_code() {
  static const std::vector<std::string> kPieces = {"x = 1",          "\n",       "\t-- note", "  ",
                                                   "if btn(0) then", "\xc3\xa9", "\"",        "end\n"};
  std::string code;
  for (const int piece : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8)))
    code += kPieces[piece];
  return code;
}

// Any chunks that a reader accepts: of every type and bank, several of one type, with trailing zeros.
std::string random_chunk() {
  const int type = *rc::gen::inRange(0, 32);
  std::string data;
  const auto infos = section_infos();
  const auto info =
      std::find_if(infos.begin(), infos.end(), [&](const SectionInfo& i) { return i.chunk == type; });
  if (info != infos.end()) {
    data = random_section(*info);
  } else if (type == kTicCode) {
    data = random_code() + "-";
  } else if (type == kTicCodeZip) {
    data = zipped(random_code());
  } else if (type != kTicDefault) {
    data = random_bytes(*rc::gen::inRange<std::size_t>(1, 200));
  }
  std::string bytes;
  const bool odd = *rc::gen::inRange(0, 8) == 0;
  append_tic_chunk(bytes, {.type = type,
                           .bank = *rc::gen::element(0, 0, 0, 1, 7),
                           .reserved = static_cast<std::uint8_t>(odd ? *rc::gen::inRange(0, 256) : 0),
                           .data = data});
  return bytes;
}

std::string random_tic() {
  std::string bytes;
  for (int i = *rc::gen::inRange(1, 12); i > 0; --i) bytes += random_chunk();
  return bytes;
}

// A text project as people edit it: carriage returns, capitals, sections in any order, lines between them.
std::string random_text() {
  const std::string newline = *rc::gen::element(std::string("\n"), std::string("\r\n"));
  std::string text = random_code();
  std::vector<std::string> sections;
  for (const SectionInfo& info : section_infos()) {
    for (const int bank : {0, 2}) {
      if (*rc::gen::inRange(0, 3) != 0) continue;
      const std::string tag = std::string(info.tag) + (bank == 0 ? "" : std::to_string(bank));
      std::string rows = text_rows(info, random_section(info), "--", newline);
      if (*rc::gen::arbitrary<bool>()) std::transform(rows.begin(), rows.end(), rows.begin(), ::toupper);
      const std::string gap = *rc::gen::element(std::string(), newline, "stray" + newline);
      sections.push_back("-- <" + tag + ">" + newline + rows + "-- </" + tag + ">" + newline + gap);
    }
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(sections.begin(), sections.end());
  text += newline;
  for (const std::string& section : sections) text += section;
  return text;
}

void edit_randomly(Level& level) {
  for (const int what : *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(0, 6))) {
    const int i = *rc::gen::inRange(0, 256);
    const auto value = *rc::gen::arbitrary<std::uint8_t>();
    Sheet& sheet = level.sheets[value % 2];
    if (what == 0) level.map.set({i % 240, i % 136}, value);
    if (what == 1) sheet.images[i][value % 64] = value & 15;
    if (what == 2) sheet.flags[i] = value;
    if (what == 3) level.palette[i % 16].g = value;
    if (what == 4) level.map = TileMap();
    if (what == 5) sheet = Sheet();
  }
}

double random_number() { return *rc::gen::inRange(-4000, 4000) / 16.0; }
double random_x() { return *rc::gen::inRange(0, 16 * 240 * 8) / 16.0; }
double random_y() { return *rc::gen::inRange(0, 16 * 136 * 8) / 16.0; }

// Shapes and curves of every kind; some are invalid.
TileShape random_shape() {
  TileShape shape;
  shape.kind = *rc::gen::element(TileShape::Kind::none, TileShape::Kind::solid, TileShape::Kind::slope,
                                 TileShape::Kind::profile);
  shape.side = *rc::gen::element(TileShape::Side::floor, TileShape::Side::ceiling);
  shape.one_way = *rc::gen::arbitrary<bool>();
  shape.tiles = *rc::gen::inRange(1, 9);
  int count = 0;
  if (shape.kind == TileShape::Kind::slope) count = 2;
  if (shape.kind == TileShape::Kind::profile) count = *rc::gen::inRange(3, 66);
  for (int i = 0; i < count; ++i) shape.heights.push_back(*rc::gen::inRange(0, 8 * 64 + 2) / 8.0);
  return shape;
}

LevelCurve random_curve() {
  LevelCurve curve{*rc::gen::element(std::string(), std::string("hill")), {}, ""};
  const Vec2 from{random_x(), random_y()}, to{random_x(), random_y()};
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      curve.curve.form = Segment{from, to};
      break;
    case 1:
      curve.curve.form = Arc{{random_x(), random_y()}, random_x(), from.x, to.x, *rc::gen::arbitrary<bool>()};
      break;
    case 2:
      curve.curve.form = Parabola{from, to, random_number()};
      break;
    case 3:
      curve.curve.form = Cubic{from, to, random_number(), random_number()};
      break;
    case 4:
      curve.curve.form = Sine{from.x, to.x, from.y, random_number() / 8, random_x(), random_number()};
      break;
    default:
      curve.curve.form = Polyline{from.x, to.x, {from.y, random_number(), to.y}};
  }
  curve.curve.faces = *rc::gen::element(Curve::Faces::up, Curve::Faces::down, Curve::Faces::both);
  return curve;
}

Spawn random_spawn() {
  Spawn spawn{"", {random_number(), random_number()}, {random_number(), 0}, ""};
  spawn.kind = *rc::gen::element(BodyKind::ball, BodyKind::player);
  spawn.size = {*rc::gen::inRange(1, 200) / 4.0, *rc::gen::element(8.0, 1.0 / 256, 1024.0)};
  spawn.foot = *rc::gen::element<std::optional<Foot>>(std::nullopt, Foot::box, Foot::centre);
  return spawn;
}

// A level whose ground has shapes. problem_of says which of them are valid.
Level random_ground() {
  Level level;
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i)
    level.tile_shapes[*rc::gen::inRange(0, 256)] = random_shape();
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
    level.flag_shapes[*rc::gen::inRange(0, 8)] = random_shape();
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) level.curves.push_back(random_curve());
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) level.spawns.push_back(random_spawn());
  level.roles.one_way = *rc::gen::inRange(-1, 8);
  level.roles.ceiling = *rc::gen::inRange(-1, 8);
  level.tuning.solver = *rc::gen::element(SolverKind::article, SolverKind::bump, SolverKind::exact);
  const auto fields = tuning_fields();
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const TuningField& field = fields[*rc::gen::inRange<std::size_t>(0, fields.size())];
    field.in(level.tuning) = *rc::gen::element(field.min, field.max, field.standard());
  }
  return level;
}

bool is_usable(const Level& level) {
  const auto good = [&](const TileShape& shape) { return !problem_of(shape, level.map.tile_size()); };
  return std::all_of(level.tile_shapes.begin(), level.tile_shapes.end(), good) &&
         std::all_of(level.flag_shapes.begin(), level.flag_shapes.end(), good) &&
         std::all_of(level.curves.begin(), level.curves.end(),
                     [&](const LevelCurve& c) { return !problem_of(c.curve, level.map); });
}

bool same_drawing(Level a, Level b) {
  a.cart = b.cart = nullptr;
  return a == b;
}

Level read_tic_level(const std::string& bytes) { return read_tic(bytes, {}).value(); }
Level read_text_level(const std::string& bytes) { return read_text(bytes, {"lua"}).value(); }
std::string tic_of(const Level& level) { return write_tic(level, {}).value().bytes; }
std::string text_of(const Level& level) { return write_text(level, {"lua"}).value().bytes; }
std::string native_of(const Level& level) { return write_native(level, {}).value().bytes; }

template <class Property>
void expect_property(Property property) {
  EXPECT_TRUE(rc::check(property));
}

TEST(FormatProperties, UntouchedCartridgesKeepEveryByte) {
  expect_property([] {
    const std::string bytes = random_tic();
    RC_ASSERT(tic_of(read_tic_level(bytes)) == bytes);
  });
}

TEST(FormatProperties, UntouchedTextProjectsKeepEveryByte) {
  expect_property([] {
    const std::string bytes = random_text();
    RC_ASSERT(text_of(read_text_level(bytes)) == bytes);
  });
}

TEST(FormatProperties, NativeLevelsKeepEveryByteOfACart) {
  expect_property([] {
    const bool is_tic = *rc::gen::arbitrary<bool>();
    const std::string bytes = is_tic ? random_tic() : random_text();
    const Level level = is_tic ? read_tic_level(bytes) : read_text_level(bytes);
    const std::string native = native_of(level);
    const Level again = read_native(native, {}).value();
    RC_ASSERT(again == level);
    RC_ASSERT(native_of(again) == native);
    RC_ASSERT((is_tic ? tic_of(again) : text_of(again)) == bytes);
  });
}

TEST(FormatProperties, NativeLevelsKeepTheGround) {
  expect_property([] {
    const Level level = random_ground();
    const auto written = write_native(level, {});
    RC_TAG(written.has_value());
    RC_ASSERT(written.has_value() == is_usable(level));
    if (!written) return;
    const Level again = read_native(written->bytes, {}).value();
    RC_ASSERT(again == level);
    RC_ASSERT(native_of(again) == written->bytes);
  });
}

TEST(FormatProperties, ACartAndItsCompanionKeepTheGround) {
  expect_property([] {
    const Level level = random_ground();
    const Format& format = *find_format(*rc::gen::arbitrary<bool>() ? "tic" : "tic-text");
    const auto cart = format.write(level, {});
    RC_PRE(cart.has_value());  // the map fits, and the cart is not empty
    const Level held = format.read(cart->bytes, {}).value();
    const auto companion = write_companion(level, held, format, "a");
    RC_ASSERT(companion.has_value() == is_usable(level));
    if (!companion) return;
    if (companion->empty()) RC_ASSERT(same_drawing(held, level));
    if (companion->empty()) return;
    const JoinedLevel joined = join_companion(*companion, held, format, "a").value();
    RC_ASSERT(same_drawing(joined.level, level));
    RC_ASSERT(joined.note.empty() && joined.is_whole);
    RC_ASSERT(write_companion(joined.level, held, format, "a").value() == *companion);
  });
}

TEST(FormatProperties, AnEditOfACartridgeChangesNothingElse) {
  expect_property([] {
    const std::string bytes = random_tic();
    Level level = read_tic_level(bytes);
    const CartContent before = tic_content(bytes).value();
    edit_randomly(level);
    const auto written = write_tic(level, {});
    RC_PRE(written && level.palette != Palette{});  // the cart has content
    const std::string& edited = written->bytes;
    RC_ASSERT(same_drawing(read_tic_level(edited), level));
    const CartContent after = tic_content(edited).value();
    RC_ASSERT(after.code == before.code);
    RC_ASSERT(after.rest == before.rest);
    for (int bank = 1; bank < kBankCount; ++bank) RC_ASSERT(after.banks[bank] == before.banks[bank]);
    for (const Section id :
         {Section::waves, Section::sfx, Section::patterns, Section::tracks, Section::screen}) {
      RC_ASSERT(at(after.banks[0], id) == at(before.banks[0], id));
    }
  });
}

TEST(FormatProperties, AnEditOfATextProjectChangesNothingElse) {
  expect_property([] {
    const std::string bytes = random_text();
    Level level = read_text_level(bytes);
    const CartContent before = text_content(bytes, "--").value();
    edit_randomly(level);
    RC_PRE(level.palette != Palette{});
    const std::string edited = text_of(level);
    RC_ASSERT(same_drawing(read_text_level(edited), level));
    const CartContent after = text_content(edited, "--").value();
    RC_ASSERT(after.code == before.code);
    RC_ASSERT(after.rest == before.rest);
    for (int bank = 1; bank < kBankCount; ++bank) RC_ASSERT(after.banks[bank] == before.banks[bank]);
  });
}

TEST(FormatProperties, AnEditedCartSurvivesTheNativeForm) {
  expect_property([] {
    const bool is_tic = *rc::gen::arbitrary<bool>();
    Level level = is_tic ? read_tic_level(random_tic()) : read_text_level(random_text());
    edit_randomly(level);
    const Level again = read_native(native_of(level), {}).value();
    RC_ASSERT(same_drawing(again, level));
    const auto write = is_tic ? write_tic : write_text;
    const auto before = write(level, {"lua"}), after = write(again, {"lua"});
    RC_ASSERT((before ? before->bytes : before.error().message) ==
              (after ? after->bytes : after.error().message));
    RC_ASSERT(native_of(again) == native_of(level));
  });
}

TEST(FormatProperties, TheTwoFormsOfACartHoldTheSame) {
  expect_property([] {
    const Level level = read_tic_level(random_tic());
    const CartContent tic = tic_content(level.cart->bytes).value();
    const std::string text = text_of(level);
    const CartContent content = text_content(text, "--").value();
    RC_ASSERT(content.banks == tic.banks);
    RC_ASSERT(content.code == tic.code);
    const auto written = write_tic(read_text_level(text), {});
    RC_PRE(written.has_value());  // the cart has more than a language
    const std::string& back = written->bytes;
    RC_ASSERT(tic_content(back)->banks == tic.banks);
    RC_ASSERT(tic_content(back)->code == tic.code);
    RC_ASSERT(text_of(read_tic_level(back)) == text || content.lang != 0);
  });
}

}  // namespace talus::formats_test
