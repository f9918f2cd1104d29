// Renders into a framebuffer object.
#define GL_GLEXT_PROTOTYPES
#include "picture.h"

#include <SDL_opengl.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

#include "formats/files/atomic_file.h"
#include "formats/pictures/png_picture.h"

namespace talus {
namespace {

// A framebuffer object with one colour buffer, bound while it lives.
class Framebuffer {
 public:
  Framebuffer(int width, int height) {
    glGenRenderbuffers(1, &color_);
    glBindRenderbuffer(GL_RENDERBUFFER, color_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  }
  ~Framebuffer() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &frame_);
    glDeleteRenderbuffers(1, &color_);
  }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  bool complete() const { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

 private:
  GLuint color_ = 0, frame_ = 0;
};

}  // namespace

tl::expected<Picture, std::string> draw_picture() {
  const ImDrawData* data = ImGui::GetDrawData();
  Picture picture;
  picture.width = static_cast<int>(data->DisplaySize.x * data->FramebufferScale.x);
  picture.height = static_cast<int>(data->DisplaySize.y * data->FramebufferScale.y);
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (picture.width > largest || picture.height > largest)
    return tl::unexpected("a picture of " + std::to_string(picture.width) + "x" +
                          std::to_string(picture.height) + " px is larger than the graphics driver's " +
                          std::to_string(largest));
  Framebuffer frame(picture.width, picture.height);
  if (!frame.complete()) return tl::unexpected(std::string("the graphics driver cannot draw into memory"));
  glViewport(0, 0, picture.width, picture.height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  const std::size_t row = static_cast<std::size_t>(picture.width) * 4;
  picture.rgba.resize(row * static_cast<std::size_t>(picture.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  for (int y = 0; y < picture.height / 2; ++y)  // OpenGL's first row is the lowest one
    std::swap_ranges(picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y,
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (y + 1),
                     picture.rgba.end() - static_cast<std::ptrdiff_t>(row) * (y + 1));
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

tl::expected<void, std::string> write_png(const Picture& picture, const std::string& path, InPlace in_place) {
  const std::string bytes = encode_png(picture.width, picture.height, 4, picture.rgba.data());
  if (bytes.empty()) return tl::unexpected(std::string("cannot encode the PNG"));
  if (const auto written = write_file_atomic(path, bytes, in_place); !written)
    return tl::unexpected(written.error().message);
  return {};
}

}  // namespace talus
