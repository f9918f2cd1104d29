// Parts of the window against pictures of them in golden/, in small blocks and with some tolerance, as
// graphics drivers draw edges differently. TALUS_UPDATE_GOLDEN=1 writes the pictures anew, to be looked at.
#pragma once

#include <string>

#include "harness.h"
#include "platform/picture.h"

namespace talus {

Picture load_picture(const std::string& path);
// min, max: px; what is outside of the picture is left out.
Picture cut(const Picture& picture, ImVec2 min, ImVec2 max);
// The first block that is another picture, as "x,y"; empty: all are alike. shown: what is far off, in red.
std::string first_difference(const Picture& a, const Picture& b, Picture& shown);

class UiGolden : public UiTest {
 protected:
  // Until nothing is left to be computed, with the mouse out of the way.
  void settle();
  Picture picture_of_window();
  void expect_as_before(const std::string& name, ImVec2 min, ImVec2 max);
  void expect_widget(const std::string& name, const std::string& widget);
};

}  // namespace talus
