// LinkedFiles: the files beside a file of another program that its content names, such as pictures.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <talus/level/limits.h>
#include <talus/level/tileset.h>
#include "../files/real_path.h"
#include "../pictures/png_picture.h"
#include "import_drops.h"

namespace talus {

inline constexpr std::size_t kMaxLinkedPixels = std::size_t{1} << 25;  // of different pictures together
// px, of a picture: its pixels alone limit it, as its tiles find their places on a sheet of another form.
inline constexpr int kMaxLinkedPictureSide = kMaxSheetPicturePixels;

// A picture that a file names.
struct LinkedPicture {
  std::string path;  // as it was opened; empty: its bytes are in the file that names it
  RgbaPicture rgba;
  std::vector<Rgb> palette;  // of the file; empty: the file has none
  bool is_missing = false;   // whether it cannot be read: numbered boxes stand for its tiles
};

// Whether what stands for the name of a file is the file itself, in Base64: "data:image/png;base64,...".
inline bool is_data_name(std::string_view name) { return name.starts_with("data:"); }

// An error in a file that another file names.
tl::unexpected<FormatError> error_in(const std::string& file, const FormatError& error);

// The name of a file with "/" alone between its folders.
std::string with_slashes(std::string path);

// All names are relative to the folder of the context. Its `linked` gets the path of each file that is read,
// or would be if it were there; its `refused` gets the names of those that lie where nothing is read, and its
// `missing` the names of all that are not read.
class LinkedFiles {
 public:
  // Both must outlive it.
  LinkedFiles(const FormatContext& context, ImportDrops& drops);

  // The path of a file. Names that are no relative paths are errors, as absolute ones would lead to other
  // places on other machines; so are those of anything but files, and of files that lie, after all links are
  // followed, neither in the folder of the context nor in ImportChoices::outside.
  FormatResult<std::string> place_of(const std::string& name);
  // Says that a file, which the content calls so, cannot be read; picture() says it itself.
  void note_missing(const std::string& name) const;
  // Says that the content names a file, which is not read by read().
  void note(const std::string& place) const;
  // The bytes of a file. place: from place_of(). All files together may have kMaxFileBytes.
  FormatResult<std::string> read(const std::string& name, const std::string& place,
                                 std::size_t most = kMaxFileBytes);
  // A picture that read_picture() reads. A file is read once, whatever its names. One that cannot be read is
  // dropped, and is_missing. The name may be an is_data_name(). of: what it is the picture of.
  std::shared_ptr<const LinkedPicture> picture(const std::string& name, const std::string& of);

 private:
  FormatResult<LinkedPicture> read_picture(const std::string& name, const std::string& place);
  FormatResult<LinkedPicture> picture_in(std::string_view data_name);
  FormatResult<LinkedPicture> decode(std::string_view bytes);
  bool may_be_read(const std::string& real) const;
  void refuse(const std::string& name);

  const FormatContext& context_;
  ImportDrops& drops_;
  std::vector<std::string> folders_;  // as real_path() returns them; files in them are read
  std::size_t bytes_ = 0;             // read so far
  std::size_t pixels_ = 0;            // of pictures_
  std::map<FileNumber, std::shared_ptr<const LinkedPicture>> pictures_;
};

}  // namespace talus
