// What things of LDtk stand for, remembered without saving, and given to the command line.
#include "session/files/unsaved_mappings.h"

#include <gmock/gmock.h>

#include "cli_answer.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "session/session.h"

namespace talus::unsaved_mappings_test {

using Kind = LdtkMapping::Kind;
using testing::HasSubstr;

class UnsavedMappingsTest : public FolderTest {
 protected:
  UnsavedMappingsTest() {
    put("p.ldtk", ldtk_project(ldtk_level(ldtk_grid(2, 1, "1,0")), R"({"value":1,"identifier":"thing"})"));
  }
  static LdtkMapping slope() {
    LdtkMapping mapping;
    mapping.set({.kind = Kind::value, .name = "1", .shape = "slope_up"});
    return mapping;
  }
};

TEST_F(UnsavedMappingsTest, AreKeptByFileUntilTheyAreForgotten) {
  const std::string store = path("state/mappings");
  UnsavedMappings(store).keep(path("p.ldtk"), LdtkMapping());
  UnsavedMappings(store).keep(path("p.ldtk"), slope());
  UnsavedMappings(store).keep(path("q.ldtk"), LdtkMapping());
  EXPECT_EQ(UnsavedMappings(store).find(path("p.ldtk")), slope());
  EXPECT_EQ(UnsavedMappings(store).find(path("./p.ldtk")), slope());
  UnsavedMappings(store).forget(path("p.ldtk"));
  EXPECT_FALSE(UnsavedMappings(store).find(path("p.ldtk")));
  EXPECT_TRUE(UnsavedMappings(store).find(path("q.ldtk")));
  put("state/mappings", "damaged\n[]\n{\"file\": 3}\n");
  EXPECT_FALSE(UnsavedMappings(store).find(path("q.ldtk")));
}

TEST_F(UnsavedMappingsTest, OpenAProjectAsItWasMappedBefore) {
  const ExportTools tools{.read_asset = {}, .mappings = path("state/mappings")};
  const auto heights = [](const Session& session) { return shape_of_tile(session.level(), 1).heights; };
  {
    Session session(Level(), "", kUnnamed, tools);
    session.apply(action::OpenFile{path("p.ldtk")});
    ASSERT_TRUE(session.level_import());
    ImportChoices choices = session.level_import()->choices;
    choices.mapping = slope();
    session.apply(action::SetLevelImport{choices});
    session.apply(action::ApplyLevelImport{});
    EXPECT_FALSE(session.modified());
    EXPECT_EQ(heights(session), (std::vector<double>{0, 8}));
  }
  EXPECT_FALSE(exists("p.talus.json"));
  Session again(Level(), "", kUnnamed, tools);
  again.apply(action::OpenFile{path("p.ldtk")});
  EXPECT_FALSE(again.level_import());
  EXPECT_EQ(heights(again), (std::vector<double>{0, 8}));
  again.apply(action::SaveFile{});
  EXPECT_TRUE(exists("p.talus.json"));
  EXPECT_FALSE(UnsavedMappings(tools.mappings).find(path("p.ldtk")));
}

TEST_F(UnsavedMappingsTest, TheCommandLineTakesAFile) {
  put("map.json", R"([{"kind": "value", "of": "", "name": "1", "shape": "slope_up"}])");
  const auto import = [&](const std::string& mapping) {
    return cli_answer({"import", path("p.ldtk"), "--ldtk-map", mapping, "-o", path("a.talus.json")});
  };
  EXPECT_EQ(import(path("map.json")).status, 0);
  EXPECT_EQ(shape_of_tile(load_level(path("a.talus.json"))->level, 1).heights, (std::vector<double>{0, 8}));
  put("map.json", "{}");
  EXPECT_THAT(import(path("map.json")).err, HasSubstr("is neither a list"));
  EXPECT_EQ(import(path("none.json")).status, 1);
}

}  // namespace talus::unsaved_mappings_test
