// The last net under readers, threads and programs: what nobody expected to be thrown becomes a sentence.
#pragma once

#include <string>

#include <talus/formats/format.h>

namespace talus {

// Of the exception that is being handled: "there is not enough memory", or what it says itself. To be called
// in a catch (...).
std::string caught_text();

// What read() gives, or an error in the place of what it throws. Readers throw nothing but for lack of
// memory, and the fuzzers call them without this; here a fault of theirs costs the user one file and not the
// program.
template <class Read>
auto read_guarded(Read read) -> decltype(read()) {
  try {
    return read();
  } catch (...) {
    return tl::unexpected(FormatError{"", "cannot be read: " + caught_text()});
  }
}

}  // namespace talus
