#include "setup.h"

namespace talus {
namespace {

using S = ReportScene;
// The largest power of ten on a map, which ends at 16,777,216 px; and on one of more than 13 rows, since the
// area is limited, too.
constexpr double kTopScale = 1e7, kHighGroundScale = 1e6;
constexpr double kTopPolylineScale = 1e4;  // enough to see what polylines are worth

constexpr std::array<ReportSceneInfo, kReportSceneCount> kScenes = {{
    {S::flat_tiles, "flat tiles", "Boxes fall askew onto a floor of full tiles.", true, kTopScale},
    {S::slope_tiles, "slope tiles", "Boxes fall askew onto a hillside of slopes, 2x1 tiles each.", true,
     kTopScale},
    {S::tiny_bodies, "tiny bodies", "The same with boxes of 1/64 px.", true, kTopScale},
    {S::segment, "segment", "Boxes fall onto one straight line between two points off the grid.", false,
     kTopScale},
    {S::arc, "arc", "Boxes fall onto the upper quarter of a circle of radius 64.", false, kTopScale},
    {S::sine, "sine", "Boxes fall onto a sine of amplitude 8 and wavelength 64.", false, kTopScale},
    {S::wall_of_tiles, "wall of tiles",
     "A box is pushed into a wall of tiles, slides 40 px down along it, and leaves it.", true, kTopScale},
    {S::wall_of_bodies, "wall of bodies",
     "The same with a wall of two boxes off the grid; exact has them as bodies, which it does not merge.",
     true, kTopScale},
    {S::roll_flat, "roll on tiles", "Balls of the article's velocities bounce out and roll, 300 frames.",
     true, kTopScale},
    {S::roll_slope, "roll down a line", "The same down a straight line of slope 1/4, 120 frames.", false,
     kHighGroundScale},
    {S::bounce_fall, "bounce, article's fall",
     "Balls dropped at rest under the article's fall bounce without loss, 240 frames.", true, kTopScale},
    {S::bounce_gravity, "bounce, gravity",
     "The same under a gravity of 1/4; what a bounce leaves of a step's motion slides.", false, kTopScale},
    {S::bounce_rebound, "bounce, rebound",
     "The same with `exact.rebound`: what a bounce leaves of a step's motion bounces.", false, kTopScale},
}};

void add_exact(Setup setup, std::vector<Setup>& rows) {
  setup.solver = SolverKind::exact;
  for (const bool single : {false, true}) {
    for (const int substeps : kReportSubsteps) {
      setup.single = single;
      setup.substeps = substeps;
      rows.push_back(setup);
    }
  }
}

}  // namespace

const std::array<ReportSceneInfo, kReportSceneCount>& report_scenes() { return kScenes; }

const ReportSceneInfo& info_of(ReportScene scene) { return kScenes[static_cast<std::size_t>(scene)]; }

std::string_view solver_name(const Setup& setup) {
  return setup.solver ? solver_name(*setup.solver) : "kernel";
}

bool is_curve(ReportScene scene) { return scene == S::arc || scene == S::sine; }
bool is_of_tiles(ReportScene scene) {
  return scene == S::flat_tiles || scene == S::slope_tiles || scene == S::wall_of_tiles;
}
double factor_of(const Setup& setup) { return 1.0 * setup.tile / kCartTileSize; }

namespace {

// Every solver in double precision, near the origin.
void add_larger_tiles(ReportScene scene, std::vector<Setup>& rows) {
  for (const int tile : kReportLargerTiles) {
    for (const SolverKind solver : {SolverKind::article, SolverKind::bump, SolverKind::exact})
      rows.push_back({.scene = scene, .solver = solver, .tile = tile});
  }
}

}  // namespace

std::vector<Setup> report_setups() {
  std::vector<Setup> rows;
  for (const ReportSceneInfo& info : kScenes) {
    for (double scale = 1; scale <= info.top_scale; scale *= 10) {
      Setup setup{.scene = info.scene, .scale = scale};
      if (info.scene == S::flat_tiles) rows.push_back(setup);  // the kernel
      if (info.for_all) {
        for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
          setup.solver = solver;
          rows.push_back(setup);
        }
      }
      add_exact(setup, rows);
      if (is_of_tiles(info.scene) && scale == 1) add_larger_tiles(info.scene, rows);
      if (!is_curve(info.scene) || scale > kTopPolylineScale) continue;
      for (const int segments : kReportSegments) {
        setup.segments = segments;
        add_exact(setup, rows);
      }
    }
  }
  return rows;
}

}  // namespace talus
