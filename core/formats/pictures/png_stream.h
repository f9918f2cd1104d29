// PngStream: writes a PNG row by row, for pictures that would take too much memory as a whole.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace talus {

class PngStream {
 public:
  // width, height: px, at least 1. channels: 3 for RGB, 4 with opacity.
  PngStream(int width, int height, int channels);
  ~PngStream();
  PngStream(const PngStream&) = delete;
  PngStream& operator=(const PngStream&) = delete;

  // Whole rows, one behind the other; all of them together must be `height` when finish() is called.
  void add(const std::vector<std::uint8_t>& rows);
  // Bytes of the file so far.
  std::size_t size() const { return png_.size(); }
  // The file; empty if there was not enough memory.
  std::string finish();

 private:
  struct Packer;
  void pack(const std::uint8_t* bytes, std::size_t count, bool is_last);
  void add_chunk(const char* type, const std::string& content);

  std::size_t row_;  // bytes
  std::string png_;
  std::unique_ptr<Packer> packer_;
};

}  // namespace talus
