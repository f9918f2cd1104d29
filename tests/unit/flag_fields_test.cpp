// Fields of flags: their values, how files keep them, and finding flags in a level.
#include <talus/level/flag_fields.h>

#include <gtest/gtest.h>

#include "level/flag_search.h"
#include "level_picture.h"
#include "native_text.h"

namespace talus::flag_fields_test {

FlagField slope_kind() { return {"slope kind", 2, 2, {"none", "up", "down"}, ""}; }

void expect_field_error(const std::string& fields, const std::string& place, const std::string& message) {
  expect_native_error(native_with("\"flag_fields\": " + fields), place, message);
}

TEST(FlagField, ReadsItsFlagsAsANumber) {
  const FlagField field = slope_kind();
  EXPECT_EQ(field.mask(), 0b1100);
  EXPECT_EQ(field.value_count(), 4);
  EXPECT_EQ(field.value_of(0b11111011), 2);
  EXPECT_EQ(field.pattern(2), (FlagPattern{0b1100, 0b1000}));
  EXPECT_EQ(field.pattern(2).put_in(0b0101), 0b1001);
  EXPECT_TRUE(field.pattern(0).matches(0b11110011));
  EXPECT_FALSE(field.pattern(0).matches(0b0100));
  EXPECT_EQ(field.pattern(1).lowest_flag(), 2);
  EXPECT_EQ((FlagField{"", 0, 8, {}, ""}.mask()), 0xff);
}

TEST(FlagField, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(problem_of(slope_kind()), std::nullopt);
  EXPECT_EQ(problem_of({"", 0, 1, {}, ""}), "must have 2 to 8 bits");
  EXPECT_EQ(problem_of({"", 30, 3, {}, ""}), "reaches beyond flag 31");
  EXPECT_EQ(problem_of({"", 0, 2, {"a", "b", "c", "d", "e"}, ""}), "has more names than values: 5 for 4");
}

TEST(FlagField, KnowsItsNeighbours) {
  const std::vector<FlagField> fields = {slope_kind(), {"", 5, 2, {}, ""}};
  EXPECT_EQ(field_of_flag(fields, 3), &fields[0]);
  EXPECT_EQ(field_of_flag(fields, 4), nullptr);
  EXPECT_EQ(most_bits(fields, 0), 2);
  EXPECT_EQ(most_bits(fields, 4), 1);
  EXPECT_EQ(most_bits({}, 29), 3);
  EXPECT_EQ(most_bits({}, 5), 8);
  EXPECT_EQ(overlapping_field(fields), std::nullopt);
  const std::vector<FlagField> overlapping = {slope_kind(), {"", 3, 2, {}, ""}};
  EXPECT_EQ(overlapping_field(overlapping), 1u);
}

TEST(FlagFieldFile, SurvivesSavingAndReading) {
  Level level;
  level.flag_fields = {slope_kind(), {"", 6, 2, {}, R"({"hint":"new"})"}};
  const auto written = write_native(level, {});
  ASSERT_TRUE(written);
  EXPECT_NE(written->bytes.find(R"("flag_fields": [
    {
      "name": "slope kind",
      "first": 2,
      "bits": 2,
      "values": [
        "none",
        "up",
        "down"
      ]
    },
    {"first": 6, "bits": 2, "hint": "new"}
  ],)"),
            std::string::npos)
      << written->bytes;
  const auto read = read_native(written->bytes, {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->flag_fields, level.flag_fields);
  EXPECT_EQ(write_native(*read, {})->bytes, written->bytes);
}

TEST(FlagFieldFile, AnEmptyListIsLeftOut) {
  EXPECT_EQ(write_native(Level(), {})->bytes.find("flag_fields"), std::string::npos);
}

TEST(FlagFieldFile, ErrorsSayWhere) {
  expect_field_error("7", "key flag_fields", "must be a list");
  expect_field_error("[1]", "key flag_fields[0]", "must be an object");
  expect_field_error(R"([{"bits": 2}])", "key flag_fields[0].first", "must be a flag from 0 to 30");
  expect_field_error(R"([{"first": 0, "bits": 9}])", "key flag_fields[0].bits",
                     "must be a whole number from 2 to 8");
  expect_field_error(R"([{"first": 0, "bits": 1}])", "key flag_fields[0].bits",
                     "must be a whole number from 2 to 8");
  expect_field_error(R"([{"first": 30, "bits": 3}])", "key flag_fields[0]", "reaches beyond flag 31");
  expect_field_error(R"([{"first": 0, "bits": 2, "values": [1]}])", "key flag_fields[0].values",
                     "must be a list of strings");
  expect_field_error(R"([{"first": 0, "bits": 2, "name": 1}])", "key flag_fields[0].name",
                     "must be a string");
  expect_field_error(R"([{"first": 0, "bits": 3}, {"first": 2, "bits": 2}])", "key flag_fields[1]",
                     "has a flag of another field");
}

TEST(FlagFieldFile, FieldsThatAReaderRefusesAreNotWritten) {
  Level level;
  level.flag_fields = {{"", 31, 2, {}, ""}};
  const auto written = write_native(level, {});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().place, "key flag_fields[0].first");
}

TEST(FlagSearch, CountsTilesAndCells) {
  const Level level = level_of({"#o#", ".##"});
  const FlagUse solid = find_flag_use(level, pattern_of_flag(0));
  EXPECT_EQ(solid.tiles, std::vector<int>{1});
  EXPECT_EQ(solid.cells[1], 4u);
  EXPECT_EQ(solid.cells[2], 0u);
  EXPECT_EQ(solid.cell_count, 4u);
  const FlagUse up = find_flag_use(level, pattern_of_flag(2));
  EXPECT_EQ(up.tiles, std::vector<int>{3});
  EXPECT_EQ(up.cell_count, 0u);
  // Every tile but three is neither solid nor a ball, and one of those is on the map.
  const FlagUse none = find_flag_use(level, {0b11, 0});
  EXPECT_EQ(none.tiles.size(), 254u);
  EXPECT_EQ(none.cell_count, 1u);
}

TEST(FlagSearch, GoesFromCellToCellAndWrapsAround) {
  const Level level = level_of({".#.", "#.o", "..#"});
  const FlagPattern solid = pattern_of_flag(0);
  EXPECT_EQ(find_flagged_cell(level, solid, {}, true), (Cell{1, 0}));
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{1, 0}, true), (Cell{0, 1}));
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{2, 2}, true), (Cell{1, 0}));
  EXPECT_EQ(find_flagged_cell(level, solid, {}, false), (Cell{2, 2}));
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{1, 0}, false), (Cell{2, 2}));
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{99, 0}, true), (Cell{1, 0})) << "from outside the map";
  EXPECT_EQ(find_flagged_cell(level, pattern_of_flag(1), Cell{2, 1}, true), (Cell{2, 1})) << "the only one";
  EXPECT_EQ(find_flagged_cell(level, pattern_of_flag(3), {}, true), std::nullopt);
  EXPECT_EQ(find_flagged_cell(level, solid, {}, true, 2), std::nullopt) << "tile 2 is no solid one";
}

TEST(FlagSearch, LooksAtAllLayersOrTheChosenOne) {
  Level level = level_of({"#..", "...", ".o."});
  std::vector<TileNumber> front(9);
  front[2] = 1;  // the solid tile, at (2,0)
  level.layers.list = {{.name = "back"},
                       {.name = "front", .cells = std::make_shared<const MapCells>(std::move(front))}};
  const FlagPattern solid = pattern_of_flag(0), empty{0b11, 0};
  EXPECT_EQ(find_flag_use(level, solid).cell_count, 2U);
  EXPECT_EQ(find_flag_use(level, solid, SearchedLayers::chosen).cell_count, 1U);
  EXPECT_EQ(find_flag_use(level, empty).cell_count, 7U) << "tile 0 is empty in front";
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{0, 0}, true), (Cell{2, 0}));
  EXPECT_EQ(find_flagged_cell(level, solid, Cell{0, 0}, true, -1, SearchedLayers::chosen), (Cell{0, 0}));
}

}  // namespace talus::flag_fields_test
