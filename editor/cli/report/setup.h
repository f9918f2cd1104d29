// The rows of the report: which scene, which solver, which settings.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <talus/level/tileset.h>
#include <talus/level/tuning.h>

namespace talus {

enum class ReportScene {
  flat_tiles,
  slope_tiles,
  tiny_bodies,
  segment,
  arc,
  sine,
  wall_of_tiles,
  wall_of_bodies,
  roll_flat,
  roll_slope,
  bounce_fall,
  bounce_gravity,
  bounce_rebound
};

struct ReportSceneInfo {
  ReportScene scene;
  std::string_view name;     // in the tables
  std::string_view meaning;  // a sentence
  bool for_all;              // whether the solvers on boxes can have it, too
  double top_scale;          // the largest coordinate scale that it exists at
};
inline constexpr int kReportSceneCount = 13;
const std::array<ReportSceneInfo, kReportSceneCount>& report_scenes();  // in the order of the enum

struct Setup {
  ReportScene scene = ReportScene::flat_tiles;
  std::optional<SolverKind> solver = {};  // nothing: the hand-written discrete kernel of `talus bench`
  bool single = false;                    // in float
  int substeps = 1;
  int segments = 0;          // of the polyline that replaces the curve; 0: the curve itself
  double scale = 1;          // px: about how far from the origin the scene is (see report_origin)
  int tile = kCartTileSize;  // px, a side of the tiles; the scene and its moves are as many times larger
};

inline constexpr std::array kReportSubsteps = {1, 2, 4, 8, 16};
inline constexpr std::array kReportLargerTiles = {16, 24, 32};  // px
inline constexpr std::array kReportSegments = {4, 8, 16, 32, 64, 128, 256, 512, 1024};

const ReportSceneInfo& info_of(ReportScene scene);
std::string_view solver_name(const Setup& setup);
bool is_curve(ReportScene scene);
bool is_of_tiles(ReportScene scene);  // whether it exists with tiles of other sizes
// How many times larger than with the tiles of a cart everything is.
double factor_of(const Setup& setup);

// All rows; those of a scene and scale follow one another.
std::vector<Setup> report_setups();

}  // namespace talus
