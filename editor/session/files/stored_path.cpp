#include "stored_path.h"

#include "formats/text/base64.h"
#include "formats/text/utf8_text.h"

namespace talus {
namespace {

const std::string kBase64 = "_base64";

}  // namespace

void put_path(Json& line, const std::string& key, const std::string& path) {
  if (is_utf8(path))
    line[key] = path;
  else
    line[key + kBase64] = encode_base64(path);
}

std::string path_in(const Json& line, const std::string& key) {
  const Json path = line.value(key, Json()), encoded = line.value(key + kBase64, Json());
  if (path.is_string()) return path.get<std::string>();
  return encoded.is_string() ? decode_base64(encoded.get_ref<const std::string&>()).value_or("") : "";
}

}  // namespace talus
