// Documents in the grammar of a format: a good document, changed at places and in ways that bytes choose.
// Random bytes rarely get past the first check of a reader; these documents get as far as the wrong value in
// the right place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

// The choices that the bytes of a fuzzer, or of a random generator, make.
class RandomBytes {
 public:
  explicit RandomBytes(std::string_view bytes) : bytes_(bytes) {}
  // Returns 0..count-1; 0 when the bytes are used up, which always means that nothing is changed. count: 1 to
  // 255.
  unsigned below(unsigned count);
  std::size_t index(std::size_t count);  // the same for larger counts

 private:
  std::string_view bytes_;
};

class Grammar {
 public:
  // good: a document without an error, in JSON or XML, recognised by its first character (asserted).
  explicit Grammar(std::string good);

  // Returns the good document with changes: members, attributes and elements may be left out, repeated, get
  // another one's name or value, the wrong type, an unexpected number, or something nested deep instead. The
  // document may also end early, or have more text behind its end.
  std::string document(RandomBytes& choices) const;
  // Returns some documents, one on each line.
  std::string lines(RandomBytes& choices) const;

 private:
  std::string good_;                 // XML without its declaration
  std::vector<std::string> names_;   // of members, attributes and elements
  std::vector<std::string> values_;  // as the document writes them
};

// The grammar of tests/fuzz/seeds/NAME, which must exist (asserted).
Grammar grammar_of_seed(const std::string& name);

}  // namespace talus
