// Maps of Tiled in other encodings than UTF-8.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "formats/text/xml_encoding.h"

namespace talus::xml_encoding_test {

using namespace std::string_literals;
using testing::HasSubstr;

std::string utf16_of(const std::u16string& text, bool is_big, bool has_mark) {
  std::string bytes;
  for (const char16_t unit : (has_mark ? u"\ufeff"s : u""s) + text) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xff);
    bytes += {is_big ? high : low, is_big ? low : high};
  }
  return bytes;
}

std::string in_utf8(std::string_view bytes) {
  const auto text = xml_in_utf8(bytes);
  if (!text) return to_string(text.error(), "x");
  return *text ? **text : "as it is";
}

TEST(XmlEncoding, Utf16BecomesUtf8) {
  for (const bool is_big : {false, true}) {
    for (const bool has_mark : {false, true})
      EXPECT_EQ(in_utf8(utf16_of(u"<a b=\"\u00e4\u20ac\U0001f600\"/>", is_big, has_mark)), "<a b=\"ä€😀\"/>");
  }
  EXPECT_EQ(in_utf8(utf16_of(u"<?xml version=\"1.0\" encoding='UTF-16'?><a/>", false, true)),
            "<?xml version=\"1.0\" encoding='UTF-8'?><a/>");
}

TEST(XmlEncoding, DamagedUtf16IsAnError) {
  const std::string good = utf16_of(u"<a/>", false, true);
  EXPECT_EQ(in_utf8(good + "x"), "x:byte 10: error: has a half character of UTF-16");
  EXPECT_EQ(in_utf8(good + "\x01\xd8"), "x:byte 10: error: has a half character of UTF-16");
  EXPECT_EQ(in_utf8(good + "\x01\xd8 \0"s), "x:byte 10: error: has a half character of UTF-16");
  EXPECT_EQ(in_utf8(good + "\x01\xdc"), "x:byte 10: error: has a half character of UTF-16");
}

TEST(XmlEncoding, DeclaredOnesBecomeUtf8) {
  const auto with = [](const std::string& name, const std::string& text) {
    return "<?xml version=\"1.0\" encoding=\"" + name + "\"?><a b=\"" + text + "\"/>";
  };
  EXPECT_EQ(in_utf8(with("ISO-8859-1", "\xe4\x80")), with("UTF-8", "ä\xc2\x80"));
  EXPECT_EQ(in_utf8(with("latin1", "\xc3\xa4")), with("UTF-8", "Ã¤"));
  EXPECT_EQ(in_utf8(with("Windows-1252", "\xe4\x80")), with("UTF-8", "ä€"));
  EXPECT_EQ(in_utf8(with("utf-16", "ä")), with("UTF-8", "ä"));
  for (const char* const as_it_is : {"UTF-8", "utf8"}) EXPECT_EQ(in_utf8(with(as_it_is, "ä")), "as it is");
  EXPECT_EQ(in_utf8("<a encoding=\"latin1\"/>"), "as it is");
  EXPECT_EQ(in_utf8("\xef\xbb\xbf" + with("latin1", "ä")), "as it is");
  EXPECT_EQ(in_utf8(with("koi8-r", "\xe4")),
            "x: error: is text in the encoding \"koi8-r\", but must be in UTF-8, "
            "UTF-16, ISO-8859-1 or windows-1252");
}

class EncodedMap : public FolderTest {};

std::string map_named(const std::string& encoding, const std::string& name, const std::string& cells) {
  return "<?xml version=\"1.0\"" + encoding +
         R"(?><map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">)"
         R"(<tileset firstgid="1" source="t.tsx"/><layer name=")" +
         name + R"(" width="2" height="1"><data encoding="csv">)" + cells + "</data></layer></map>";
}

// An unchanged one keeps its bytes.
TEST_F(EncodedMap, IsSavedInUtf8OnceItIsEdited) {
  const std::string declared = " encoding=\"ISO-8859-1\"";
  const std::string tileset = "<?xml version=\"1.0\"" + declared +
                              "?><tileset name=\"\xe4\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"2\" "
                              "columns=\"2\"></tileset>";
  const std::string latin = map_named(declared, "\xe4", "1,2"), plain = map_named("", "a", "1,2");
  const std::string wide = utf16_of(std::u16string(plain.begin(), plain.end()), false, true);
  for (const auto& [text, now] : {std::pair(latin, map_named(" encoding=\"UTF-8\"", "ä", "2,2")),
                                  std::pair(wide, map_named("", "a", "2,2"))}) {
    put("t.tsx", tileset);
    put("m.tmx", text);
    auto loaded = load_level(path("m.tmx"));
    ASSERT_TRUE(loaded) << to_string(loaded.error(), "m.tmx");
    const auto save = [&] {
      const auto saved = save_level(loaded->level, *loaded->format, path("m.tmx"), loaded->companion);
      EXPECT_TRUE(saved) << to_string(saved.error(), "m.tmx");
    };
    save();
    EXPECT_EQ(bytes_of("m.tmx"), text);
    loaded->level.map.set({0, 0}, 1);
    save();
    EXPECT_EQ(bytes_of("m.tmx"), now);
    EXPECT_EQ(bytes_of("t.tsx"), tileset);
    loaded->level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
    save();
    EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("encoding=\"UTF-8\"?><tileset name=\"ä\""));
    EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<objectgroup"));
    EXPECT_EQ(load_level(path("m.tmx"))->level.map, loaded->level.map);
  }
}

}  // namespace talus::xml_encoding_test
