#include "table.h"

#include <cmath>
#include <cstdio>
#include <functional>

#include "formats/text/append_number.h"

namespace talus {
namespace {

// Three significant digits, for people.
std::string rounded(double value) {
  char text[32];
  const double size = std::abs(value);
  std::snprintf(text, sizeof text, size >= 1000 && size < 1e9 ? "%.0f" : "%.3g", value);
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

std::string_view precision_of(const Setup& setup) { return setup.single ? "float" : "double"; }

// A column of both tables; the text is empty if it does not apply to the row.
struct Column {
  std::string_view name;
  std::function<std::string(const Row&)> text;
};

template <std::optional<Spread> Row::*Kind>
std::string max_of(const Row& row) {
  return row.*Kind ? csv_number((row.*Kind)->max) : "";
}
template <std::optional<Spread> Row::*Kind>
std::string p999_of(const Row& row) {
  return row.*Kind ? csv_number((row.*Kind)->p999) : "";
}
template <std::size_t Counts::*Kind>
std::string count_of(const Row& row) {
  return row.counts ? std::to_string((*row.counts).*Kind) : "";
}

std::vector<Column> csv_columns() {
  return {
      {"scene", [](const Row& r) { return quoted(std::string(info_of(r.setup.scene).name)); }},
      {"solver", [](const Row& r) { return std::string(solver_name(r.setup)); }},
      {"precision", [](const Row& r) { return std::string(precision_of(r.setup)); }},
      {"substeps", [](const Row& r) { return std::to_string(r.setup.substeps); }},
      {"segments", [](const Row& r) { return std::to_string(r.setup.segments); }},
      {"scale_px", [](const Row& r) { return csv_number(r.setup.scale); }},
      {"tile_px", [](const Row& r) { return std::to_string(r.setup.tile); }},
      {"moves", [](const Row& r) { return std::to_string(r.moves); }},
      {"ns_per_move", [](const Row& r) { return r.ns ? csv_number(*r.ns) : ""; }},
      {"geometry_max_px", max_of<&Row::geometry>},
      {"geometry_p999_px", p999_of<&Row::geometry>},
      {"impact_max_px", max_of<&Row::impact>},
      {"impact_p999_px", p999_of<&Row::impact>},
      {"trajectory_max_px", max_of<&Row::trajectory>},
      {"trajectory_p999_px", p999_of<&Row::trajectory>},
      {"model_max_px", max_of<&Row::model>},
      {"model_p999_px", p999_of<&Row::model>},
      {"misses", count_of<&Counts::misses>},
      {"ghosts", count_of<&Counts::ghosts>},
      {"tunnels", count_of<&Counts::tunnels>},
      {"teleports", count_of<&Counts::teleports>},
  };
}

// ---- The page ----

std::string pair_of(const std::optional<Spread>& spread) {
  return spread ? rounded(spread->max) + " / " + rounded(spread->p999) : "";
}

std::string line_of(const Row& row, bool with_segments) {
  const Setup& s = row.setup;
  std::string line = "| " + std::string(solver_name(s)) + " " + std::string(precision_of(s)) + " | ";
  if (with_segments) line += (s.segments == 0 ? "curve" : std::to_string(s.segments)) + " | ";
  line += std::to_string(s.substeps) + " | " + rounded(s.scale) + " | " + std::to_string(s.tile) + " | ";
  line += row.ns ? rounded(*row.ns) : "";
  for (const auto kind : {&Row::geometry, &Row::impact, &Row::trajectory, &Row::model}) {
    line += " | " + pair_of(row.*kind);
  }
  line += " | ";
  if (const auto& c = row.counts) {
    line += std::to_string(c->misses) + ", " + std::to_string(c->ghosts) + ", " + std::to_string(c->tunnels) +
            ", " + std::to_string(c->teleports);
  }
  return line + " |\n";
}

// The page has no combinations: one thing changes at a time, from double, one step, the curve itself, and
// scale 1.
bool is_on_page(const Setup& s) {
  const int changes = (s.substeps != 1) + (s.segments != 0) + (s.scale != 1) + (s.tile != kCartTileSize);
  return changes == 0 || (changes == 1 && (s.substeps == 1 || !s.single));
}

std::string scene_of(std::span<const Row> rows, const ReportSceneInfo& info) {
  const bool curve = is_curve(info.scene);
  std::string page = "## " + std::string(info.name) + "\n\n" + std::string(info.meaning) + "\n\n| solver | ";
  if (curve) page += "segments | ";
  page +=
      "sub-steps | scale, px | tile, px | ns a move | geometry | impact | trajectory | model | misses, "
      "ghosts, tunnels, "
      "teleports |\n|";
  for (int i = 0; i < (curve ? 11 : 10); ++i) page += " --- |";
  page += '\n';
  for (const Row& row : rows) {
    if (row.setup.scene == info.scene && is_on_page(row.setup)) page += line_of(row, curve);
  }
  return page + '\n';
}

// ---- Where the exact solver loses ----

bool is_standard(const Setup& s) {
  return s.solver == SolverKind::exact && !s.single && s.substeps == 1 && s.segments == 0;
}

std::string rival_of(const Setup& s) {
  std::string name = std::string(solver_name(s)) + " " + std::string(precision_of(s));
  if (s.segments != 0) name += ", " + std::to_string(s.segments) + " segments";
  if (s.substeps != 1) name += ", " + std::to_string(s.substeps) + " sub-steps";
  return name;
}

struct Loss {
  const Row* rival = nullptr;
  double own = 0, other = 0;
  // The rival that is furthest ahead counts.
  void note(const Row& row, double standard, double value) {
    if (rival == nullptr ? value < standard : value < other) *this = {&row, standard, value};
  }
};

std::optional<Spread> error_of(const Row& row) {
  if (row.geometry) return row.geometry;
  return row.trajectory ? row.trajectory : row.model;
}

std::string losses_of(std::span<const Row> rows) {
  std::string page;
  for (const Row& row : rows) {
    if (!is_standard(row.setup)) continue;
    Loss time, error;
    for (const Row& other : rows) {
      if (other.setup.scene != row.setup.scene || other.setup.scale != row.setup.scale ||
          other.setup.tile != row.setup.tile)
        continue;
      if (row.ns && other.ns) time.note(other, *row.ns, *other.ns);
      if (error_of(row) && error_of(other)) error.note(other, error_of(row)->max, error_of(other)->max);
    }
    const auto add = [&](const Loss& loss, const std::string& what) {
      if (loss.rival == nullptr) return;
      page += "| " + std::string(info_of(row.setup.scene).name) + " | " + rounded(row.setup.scale) + " | " +
              std::to_string(row.setup.tile) + " | " + what + " | " + rounded(loss.own) + " | " +
              rounded(loss.other) + " | " + rival_of(loss.rival->setup) + " |\n";
    };
    add(time, "ns a move");
    add(error, "largest error, px");
  }
  if (page.empty()) return "Nowhere in this run.\n\n";
  return "| scene | scale, px | tile, px | what | exact | rival | which |\n| --- | --- | --- | --- | --- | "
         "--- | --- "
         "|\n" +
         page + '\n';
}

constexpr std::string_view kIntroduction = R"(# Speed against error

Written by `talus report`; all rows are in `report.csv`. Errors are in px. Each cell has the largest one, then the 99.9th
percentile; x and y are compared on their own, and the larger difference counts. There are four kinds of error:

- **geometry**: one move against the exact answer to the stored inputs. It is the distance of the first contact, or the
  height over the floor in the end, whichever is larger; along a wall the distance in the end.
- **impact**: the time of impact, times the length of the motion.
- **trajectory**: the same integrator in long double, over all frames.
- **model**: closed-form physics, over all frames. Frames of a free flight lie on its curve, so that the bounce alone
  is measured.

Where a cell is empty, the row has nothing to compare. The article's solver tells no time of impact on slopes, only on
the full tiles beside them; with sub-steps the time within the frame is not recorded. `article` and `bump` know no
segments, no curves, no `float` and no sub-steps, so they have no such rows.

**Scale** says how far from the origin a scene lies: near (scale, scale), and from 1e5 on, where a map that is both long
and high would be too large, near (scale, 0), or near (0, scale) if it bounces balls, of which only the heights are
measured. The line of 500 px in height ends at 1e6, and polylines in place of curves at 1e4. Numbers get coarser with the
distance: at 1e7 px those of `double` are 2e-9 px apart, and those of `float` 1 px.

**Tile** is the side of a tile. With tiles of 16, 24 and 32 px the scene, its boxes and their moves are 2, 3 and 4 times as
large. Numbers are 2 or 4 times as coarse there at most.

All falls are steep enough to have one right answer; grazing ones are left to the property tests. What meets or misses
something within 1/64 px of the end of its motion is not counted as a miss or a ghost.

Misses, ghosts, tunnels and teleports are of single moves, each of which has its own exact answer: a miss met something
according to the exact answer alone, a ghost according to the solver alone; a tunnel ended on the far side of what it
should have met, and a teleport moved further than was asked for. Rows of a trajectory or of a model have none: there a
ball that fell through the ground, or left the scene, is a large error of its row.

)";

}  // namespace

std::string csv_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string facts_of_csv(const BuildFacts& facts) {
  return quoted(facts.commit) + ',' + quoted(facts.compiler) + ',' + quoted(facts.flags) + ',' +
         quoted(facts.cpu);
}

std::string csv_of(std::span<const Row> rows, const BuildFacts& facts) {
  const std::vector<Column> columns = csv_columns();
  std::string csv;
  for (const Column& column : columns) csv += std::string(column.name) + ',';
  csv += "commit,compiler,flags,cpu\n";
  const std::string tail = facts_of_csv(facts) + '\n';
  for (const Row& row : rows) {
    for (const Column& column : columns) csv += column.text(row) + ',';
    csv += tail;
  }
  return csv;
}

std::string page_of(std::span<const Row> rows, const BuildFacts& facts, std::span<const PagePicture> pictures,
                    const std::string& meetings) {
  std::string page(kIntroduction);
  page += "Commit " + facts.commit + "; " + facts.compiler + " with `" + facts.flags + "`; " + facts.cpu +
          ". The errors are the same in every run; the times are not.\n\n";
  for (const PagePicture& picture : pictures) {
    page += std::string(picture.meaning) + "\n\n![" + std::string(picture.name) + "](" +
            std::string(picture.name) + ".svg)\n\n";
  }
  page +=
      "## Where exact loses\n\nAgainst double precision, one step and the curve itself, the row that is "
      "furthest ahead:\n\n";
  page += losses_of(rows) + meetings;
  for (const ReportSceneInfo& info : report_scenes()) page += scene_of(rows, info);
  return page;
}

}  // namespace talus
