// The limits of a level and of what belongs to it: the same for all. Readers refuse a file with more, edits
// that would make more are refused, and nothing is saved that could not be read again.
//
// Other limits are beside what they limit: kMaxTerrainSide and kMaxTerrainCells, kMaxPolylineHeights,
// max_shape_heights(), kMaxBrushSide, kMaxBrushes, kMaxExports.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <talus/level/level.h>

namespace talus {

inline constexpr std::size_t kMaxSpawns = 65'536;           // of a level
inline constexpr std::size_t kMaxCurves = 16'384;           // of a level
inline constexpr std::size_t kMaxShapeNumbers = 1'048'576;  // heights and points of all tiles' shapes
inline constexpr std::size_t kMaxLevelHeights = 262'144;    // of all polylines together
inline constexpr std::size_t kMaxCurveCells = 2'097'152;    // cells that all curves pass, see cells_passed
inline constexpr int kMaxLayers = 100;                      // of a level
inline constexpr std::size_t kMaxLayerCells = std::size_t{4} << 24;  // of all layers, if there are several
inline constexpr std::size_t kMaxBrushCells = 1'048'576;             // of all brushes together
inline constexpr std::size_t kMaxNameBytes = std::size_t{4} << 20;   // of all names and other texts together
inline constexpr std::size_t kMaxUnknownBytes = std::size_t{1} << 20;  // of all unknown members together

// Limit for the bytes of a file. Of the largest levels, a full map of 4096x4096 cells takes 34 MB, and one of
// 8x2097152 cells, with its many lines, 55 MB; with more than 256 tiles they take 68 MB and 88 MB.
inline constexpr std::size_t kMaxFileBytes = std::size_t{96} << 20;

inline constexpr std::size_t kMaxRecordedEdits = 10'000;  // of one recording
// Memory of the versions of the level that one recording's edits make.
inline constexpr std::size_t kMaxVersionBytes = std::size_t{256} << 20;
// Sum of the sizes of all levels that reading or writing one recording goes through.
inline constexpr std::size_t kMaxEditedBytes = std::size_t{2} << 30;

// Memory of the edits that can be undone; beyond it the oldest are forgotten.
inline constexpr std::size_t kMaxHistoryBytes = std::size_t{512} << 20;

// Says which limit a level exceeds: "has 70000 bodies, but a level holds at most 65536"; nothing if it keeps
// all of them.
std::optional<std::string> problem_of_amounts(const Level& level);

// About the memory of layers of objects, in bytes.
std::size_t size_of(const std::vector<ObjectLayer>& objects);

// About the size of a level as data, which measures the work of going through it: its cells, heights and
// texts, its cart, its tiles, and some bytes for each body, curve and brush. Tuning is small, and does not
// count.
std::size_t size_of(const Level& level);

}  // namespace talus
