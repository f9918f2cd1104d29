#include "panels/ui/icons.h"

#include <gtest/gtest.h>

namespace talus::icons_test {

// Counts the corners that are drawn for an icon, with the icon font and without it.
class Icons : public testing::Test {
 protected:
  Icons() : context_(ImGui::CreateContext()) { ImGui::SetCurrentContext(context_); }
  ~Icons() override { ImGui::DestroyContext(context_); }

  void begin(bool with_icon_font) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {100, 100};
    io.Fonts->AddFontDefault();
    if (with_icon_font) add_icon_font(*io.Fonts, 1);
    io.Fonts->Build();
    ImGui::NewFrame();
  }
  static int corners(Icon icon) {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const int before = list.VtxBuffer.Size;
    draw_icon(list, icon, {10, 10}, 16, IM_COL32_WHITE);
    return list.VtxBuffer.Size - before;
  }

 private:
  ImGuiContext* context_;
};

constexpr int kGlyph = 4;  // corners of a glyph

TEST_F(Icons, CommonIconsAreGlyphsOfTheFont) {
  begin(true);
  for (int icon = static_cast<int>(Icon::first_frame); icon <= static_cast<int>(Icon::close); ++icon)
    EXPECT_EQ(corners(static_cast<Icon>(icon)), kGlyph) << icon;
  EXPECT_GT(corners(Icon::slope), 0);
  EXPECT_EQ(corners(Icon::none), 0);
}

TEST_F(Icons, ShortTextsReplaceIconsWithoutTheFont) {
  begin(false);
  EXPECT_EQ(corners(Icon::pause), 2 * kGlyph) << "||";
  for (int icon = static_cast<int>(Icon::stamp); icon <= static_cast<int>(Icon::close); ++icon)
    EXPECT_GT(corners(static_cast<Icon>(icon)), 0) << icon;
}

}  // namespace talus::icons_test
