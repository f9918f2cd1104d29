// The last net under readers, threads and programs: an unexpected exception becomes a sentence.
#pragma once

#include <string>

#include <talus/formats/format.h>

namespace talus {

// Describes the exception that is being handled: "there is not enough memory", or its own text. Call it in a
// catch (...).
std::string caught_text();

// Returns what read() returns, or an error if it throws. Readers throw only if memory runs out, and the
// fuzzers call them without this. With it, a bug in a reader costs the user one file and not the program.
template <class Read>
auto read_guarded(Read read) -> decltype(read()) {
  try {
    return read();
  } catch (...) {
    return tl::unexpected(FormatError{"", "cannot be read: " + caught_text()});
  }
}

}  // namespace talus
