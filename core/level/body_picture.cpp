// Chooses among the frames of a body's picture.
#include <talus/level/body_picture.h>

#include <cassert>

namespace talus {

const BodyFrames& frames_of(const BodyPicture& picture, BodyAct act) {
  for (const BodyAct tried : {act, BodyAct::stand, BodyAct::run, BodyAct::jump, BodyAct::fall})
    if (picture[tried].count > 0) return picture[tried];
  return picture[act];
}

int frame_tile(const BodyPicture& picture, BodyAct act, std::int64_t step) {
  const BodyFrames& frames = frames_of(picture, act);
  assert(frames.count > 0 && picture.steps > 0);
  return frames.first + static_cast<int>(step / picture.steps % frames.count) * picture.columns;
}

BodyPicture on_sheet(BodyPicture picture, const SheetLayout& layout) {
  for (BodyFrames& frames : picture.acts) {
    const bool has_first = frames.count > 0 && frames.first < layout.count;
    const Cell at = has_first ? layout.place_of(frames.first) : Cell{0, 0};
    const auto fits = [&](int frame) {
      const int right = at.x + (frame + 1) * picture.columns - 1;
      return layout.contains({right, at.y + picture.rows - 1});
    };
    int fitting = 0;
    while (has_first && fitting < frames.count && fits(fitting)) ++fitting;
    frames.count = static_cast<std::uint8_t>(fitting);
  }
  return picture;
}

std::vector<int> images_of(const BodyPicture& picture, const SheetLayout& layout) {
  std::vector<int> images;
  for (const BodyFrames& frames : picture.acts) {
    if (frames.count == 0 || frames.first >= layout.count) continue;
    const Cell at = layout.place_of(frames.first);
    const int right = std::min(at.x + frames.count * picture.columns, layout.columns);
    for (int y = at.y; y < at.y + picture.rows; ++y)
      for (int x = at.x; x < right; ++x)
        if (const int image = layout.tile_at({x, y}); image >= 0 && image < layout.count)
          images.push_back(image);
  }
  return images;
}

}  // namespace talus
