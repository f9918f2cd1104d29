// Folders of maps: what is listed, beside the window.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "formats/files/real_path.h"
#include "session/files/map_list.h"
#include "session/session.h"
#include "waiting.h"

namespace talus::map_folders_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MapFolders : public FolderTest {};

// With the whole file it would be no companion, as its end is missing.
TEST_F(MapFolders, CompanionsAreKnownByTheirBeginning) {
  const std::string cave = put("cave.tmx", "<map/>"), tower = put("tower.talus.json", "{}");
  put("cave.tmx.talus.json", R"({"talus":1,"companion":{"file":"cave.tmx"},"map":)");
  MapList maps;
  maps.list({folder_.string()}, true);
  EXPECT_THAT(maps.files(), ElementsAre(cave, tower));
  EXPECT_FALSE(maps.is_cut());
}

TEST_F(MapFolders, ListingCanBeStopped) {
  put("cave.tmx", "<map/>");
  MapList maps;
  maps.list({folder_.string()}, true, Progress([](double) { return false; }));
  EXPECT_THAT(maps.files(), IsEmpty());
}

TEST_F(MapFolders, AFolderIsListedBesideTheWindow) {
  put("cave.tmx", "<map/>");
  Session session;
  session.apply(action::OpenFile{folder_.string()});
  ASSERT_TRUE(session.reading());
  EXPECT_EQ(session.reading()->name, last_name(folder_.string()));
  session.apply(action::CancelReading{});
  session.advance(0);
  EXPECT_FALSE(session.reading());
  EXPECT_THAT(session.maps().files(), IsEmpty());
}

TEST_F(MapFolders, AFolderWithoutMapsIsNamed) {
  Session session;
  session.apply(action::OpenFile{folder_.string()});
  ASSERT_TRUE(comes_true([&] {
    session.advance(0);
    return !session.reading();
  }));
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text, "There is no map in " + folder_.string() + ".");
}

}  // namespace talus::map_folders_test
