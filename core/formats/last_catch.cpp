#include "last_catch.h"

#include <exception>

namespace talus {

std::string caught_text() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "there is not enough memory";
  } catch (const std::exception& error) {
    return std::string("an unexpected error: ") + error.what();
  } catch (...) {
    return "an unexpected error";
  }
}

}  // namespace talus
