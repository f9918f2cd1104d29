# Finds the packages that third_party/install installs; README.md beside this file says what each is for.

# A project that Talus is a part of links them too, through the static libraries.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
if(TALUS_EDITOR OR TALUS_TESTS)
  find_package(PkgConfig REQUIRED)
endif()
find_package(ZLIB REQUIRED)
find_package(zstd REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
find_package(pugixml REQUIRED)
find_package(libjpeg-turbo REQUIRED)

# stb is headers only and ships no CMake package; its folder holds stb_image.h and stb_image_write.h.
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
add_library(talus_stb INTERFACE)
target_include_directories(talus_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

if(TALUS_EDITOR)
  find_package(CLI11 REQUIRED)
  find_package(SDL2 REQUIRED)
  find_package(OpenGL REQUIRED COMPONENTS OpenGL)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()

if(TALUS_TESTS)
  find_package(GTest REQUIRED)
  # Debian's librapidcheck-dev ships headers and a library without a CMake package.
  find_path(RAPIDCHECK_INCLUDE_DIR rapidcheck.h REQUIRED)
  find_library(RAPIDCHECK_LIBRARY rapidcheck REQUIRED)
  add_library(talus_rapidcheck INTERFACE)
  target_include_directories(talus_rapidcheck SYSTEM INTERFACE ${RAPIDCHECK_INCLUDE_DIR})
  target_link_libraries(talus_rapidcheck INTERFACE ${RAPIDCHECK_LIBRARY})
  pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
endif()

if(TALUS_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
