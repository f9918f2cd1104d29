// Compressed bytes, for carts and pictures that tests make.
#pragma once

#include <zlib.h>

#include <string>

namespace talus {

// Compresses the bytes to a zlib stream.
inline std::string zipped(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out;
}

}  // namespace talus
