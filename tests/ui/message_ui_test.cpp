// Messages lie beside the map and the play view, and are short until more is asked for.
#include <array>

#include "harness.h"

namespace talus::message_ui_test {

class UiMessage : public UiTest {
 protected:
  void tell(const std::string& text) {
    session().apply(action::ShowMessage{text, true});
    frames(4);
  }
  // Eleven sentences.
  static std::string long_text() {
    std::string text = "The file level.tmx was opened.";
    for (int i = 0; i < 10; ++i) text += " Saving keeps what Talus does not show of its layers.";
    return text;
  }
  float height() {
    const Widget& text = *find("message/text");
    return text.max.y - text.min.y;
  }
};

bool overlap(const Widget& a, const Widget& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

TEST_F(UiMessage, CoversNoCanvasNoFieldAndNoBar) {
  for (const auto& [width, height] : {std::array{900, 600}, std::array{1280, 720}}) {
    start(save_test_level("level.talus.json"), width, height);
    app().ui().view.window.dock_open = true;
    tell(long_text());
    for (const char* part : {"message/text", "message/dismiss", "message/details"}) {
      const Widget message = *find(part);
      for (const char* other :
           {"map/canvas", "play/canvas", "timeline/track", "tabs/problems", "tabs/compare"}) {
        const Widget* shown = find(other);
        EXPECT_FALSE(shown != nullptr && overlap(message, *shown))
            << part << " over " << other << " at " << width;
      }
      EXPECT_TRUE(find("map/canvas") != nullptr || find("play/canvas") != nullptr);
    }
    session().apply(action::DismissMessage{});
  }
}

TEST_F(UiMessage, HasItsFirstSentencesAndMoreBehindDetails) {
  start();
  tell("A short message. With two sentences.");
  EXPECT_EQ(find("message/details"), nullptr) << "they have room";
  tell(long_text());
  ASSERT_NE(find("message/details"), nullptr);
  const float folded = height();
  EXPECT_LT(folded, 5 * ImGui::GetTextLineHeight());
  click("message/details");
  frames(4);
  EXPECT_GT(height(), folded + ImGui::GetTextLineHeight());
  click("message/details");
  frames(4);
  EXPECT_EQ(height(), folded);
  click("message/details");
  tell(long_text() + " Another one.");
  EXPECT_EQ(height(), folded) << "each message is short at first";
}

TEST_F(UiMessage, ErrorsThatWereNotDismissedStayAboveTheLast) {
  start();
  tell("The first went wrong.");
  tell("The second went wrong.");
  tell("The second went wrong.");
  ASSERT_EQ(session().earlier_messages().size(), 1u) << "the same text is one message";
  session().apply(action::ShowMessage{"Done."});
  frames(4);
  ASSERT_NE(find("message/earlier1"), nullptr);
  EXPECT_LT(find("message/earlier0")->max.y, find("message/earlier1")->max.y);
  EXPECT_LT(find("message/earlier1")->max.y, find("message/text")->max.y);
  click("message/dismiss_earlier0");
  frames(2);
  ASSERT_EQ(session().earlier_messages().size(), 1u);
  EXPECT_EQ(session().earlier_messages()[0].text, "The second went wrong.");
  EXPECT_EQ(session().message()->text, "Done.");
  key(kKeyEscape);
  EXPECT_TRUE(session().earlier_messages().empty());
}

}  // namespace talus::message_ui_test
