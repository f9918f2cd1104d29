// RecentPictures: small pictures of the levels that were open before, as files in the state folder.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

class RecentPictures {
 public:
  static constexpr int kWidth = 320, kHeight = 180;  // px, at most

  // folder: where they are kept.
  explicit RecentPictures(std::string folder) : folder_(std::move(folder)) {}

  // Keeps the picture of a level under the path of its file, and removes those of files that are not recent.
  // What cannot be written is not kept.
  void keep(const SheetPicture& picture, const std::string& file,
            const std::vector<std::string>& recent) const;
  // The picture of a file; null if there is none, or if what is in its place is none of that size.
  std::shared_ptr<const SheetPicture> find(const std::string& file) const;

 private:
  std::string place_of(const std::string& file) const;

  std::string folder_;
};

}  // namespace talus
