#include "picture_drawing.h"

#include "overlay/visible.h"

namespace talus {
namespace {

// The place of a px in a picture as a texture.
ImVec2 uv_in(const SheetPicture& picture, double x, double y) {
  return {static_cast<float>(x / picture.width), static_cast<float>(y / picture.height)};
}

// A layer's picture, as one rectangle however often it is repeated.
void draw_image(ImDrawList& list, const LayerImage& image, const CanvasView& view, const Ui& ui,
                ImU32 color) {
  const PicturePart& part = image.part;
  Rect box{0, 0, 1.0 * part.width, 1.0 * part.height};
  const Rect visible = view.visible();
  if (image.repeats_x) box.x = visible.x, box.w = visible.w;
  if (image.repeats_y) box.y = visible.y, box.h = visible.h;
  if (!meet(box, visible)) return;
  list.AddImage(ui.picture_textures->texture_of(part.picture), view.to_screen({box.x, box.y}),
                view.to_screen({box.right(), box.bottom()}), uv_in(*part.picture, box.x, box.y),
                uv_in(*part.picture, box.right(), box.bottom()), color);
}

}  // namespace

void draw_picture(ImDrawList& list, const PlacedPicture& picture, const CanvasView& view, const Ui& ui,
                  ImU32 color) {
  if (ui.picture_textures == nullptr || !meet(bounds_of(picture), view.visible())) return;
  const PicturePart& part = picture.part;
  const Vec2 corner = picture.corner, right = picture.right, down = picture.down;
  const SheetPicture& pixels = *part.picture;
  list.AddImageQuad(
      ui.picture_textures->texture_of(part.picture), view.to_screen(corner), view.to_screen(corner + right),
      view.to_screen(corner + right + down), view.to_screen(corner + down), uv_in(pixels, part.x, part.y),
      uv_in(pixels, part.x + part.width, part.y), uv_in(pixels, part.x + part.width, part.y + part.height),
      uv_in(pixels, part.x, part.y + part.height), color);
}

void draw_pictures(ImDrawList& list, const ObjectLayer& layer, const CanvasView& view, const Ui& ui,
                   ImU32 color) {
  if (ui.picture_textures == nullptr) return;
  if (layer.image && layer.image->part.picture != nullptr) draw_image(list, *layer.image, view, ui, color);
  for (const std::size_t i : drawn_pictures(layer))
    draw_picture(list, placed(layer.objects[i]), view, ui, color);
}

}  // namespace talus
