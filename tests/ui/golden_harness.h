// Compares parts of the window with pictures in golden/, in small blocks and with some tolerance, as graphics
// drivers draw edges differently. TALUS_UPDATE_GOLDEN=1 writes the pictures again; look at them before you
// commit them.
#pragma once

#include <string>

#include "harness.h"
#include "platform/picture.h"

namespace talus {

Picture load_picture(const std::string& path);
// min, max: px; parts outside the picture are left out.
Picture cut(const Picture& picture, ImVec2 min, ImVec2 max);
// Returns the first block that differs as "x,y", or "" if there is none. shown: the differing pixels in red.
std::string first_difference(const Picture& a, const Picture& b, Picture& shown);

class UiGolden : public UiTest {
 protected:
  // Moves the mouse out of the way, and waits until nothing is left to compute.
  void settle();
  Picture picture_of_window();
  void expect_as_before(const std::string& name, ImVec2 min, ImVec2 max);
  void expect_widget(const std::string& name, const std::string& widget);
};

}  // namespace talus
