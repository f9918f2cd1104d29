// The picture of a body: frames of tiles, by what the body does. Only drawing uses it; no solver does.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

// What a body does, as far as its picture shows it.
enum class BodyAct : std::uint8_t { stand, run, jump, fall };
inline constexpr int kBodyActs = 4;             // how many acts there are
inline constexpr int kMaxBodyPictureSide = 16;  // tiles, of a frame
inline constexpr int kMaxBodyFrames = 32;       // of an act
inline constexpr int kMaxFrameSteps = 600;      // for which a frame is shown
// In files and exports, by BodyAct: "stand".
inline constexpr std::array<std::string_view, kBodyActs> kBodyActWords = {"stand", "run", "jump", "fall"};

// Frames that lie side by side on a sheet, from the left to the right.
struct BodyFrames {
  TileNumber first = 0;    // the image at the top left of the first frame, 0..kMaxTiles - 1
  std::uint8_t count = 0;  // frames, 0..kMaxBodyFrames; 0: the act has none of its own
  friend bool operator==(const BodyFrames&, const BodyFrames&) = default;
};

// The bottom of a frame stands on the bottom of the body's box, its middle in the box's middle; a frame has
// its own size, whatever the box has. It is mirrored while the body goes to the left. An image of either
// sheet is shown as large as a tile of the map.
struct BodyPicture {
  std::uint8_t columns = 1;                     // images in a row of a frame, 1..kMaxBodyPictureSide
  std::uint8_t rows = 1;                        // rows of images in a frame, 1..kMaxBodyPictureSide
  std::uint16_t steps = 6;                      // for which a frame is shown, 1..kMaxFrameSteps
  SheetId sheet = SheetId::tiles;               // on which the frames are
  std::array<BodyFrames, kBodyActs> acts = {};  // by BodyAct
  // The frames of an act.
  BodyFrames& operator[](BodyAct act) { return acts[static_cast<std::size_t>(act)]; }
  const BodyFrames& operator[](BodyAct act) const { return acts[static_cast<std::size_t>(act)]; }  // as above
  // Whether it has no frame: the body is drawn as its kind is.
  bool empty() const {
    return std::all_of(acts.begin(), acts.end(), [](const BodyFrames& frames) { return frames.count == 0; });
  }
  friend bool operator==(const BodyPicture&, const BodyPicture&) = default;
};

// The frames for an act: its own, else those of standing, else the first that there are. Count 0 if it is
// empty.
const BodyFrames& frames_of(const BodyPicture& picture, BodyAct act);
// The image at the top left of the frame that is shown after so many steps. The picture must not be empty
// (asserted). It may lie beside the sheet, where the level has other images than it was made for.
int frame_tile(const BodyPicture& picture, BodyAct act, std::int64_t step);

// The picture without frames that are not wholly on its sheet, which has this layout.
BodyPicture on_sheet(BodyPicture picture, const SheetLayout& layout);
// The images of all of its frames that are on its sheet.
std::vector<int> images_of(const BodyPicture& picture, const SheetLayout& layout);

}  // namespace talus
