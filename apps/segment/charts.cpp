// Charts of gvd-segment: --disc adds generators, --uv lays the pieces of the cut mesh into the unit square.
//
// --disc comes between the diagram and its labels, so that every file has the added generators. Texture coordinates
// belong to corners of cut faces. The report has the shares of area that are flipped, torn and not placed.
#include "segment/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/run_parts.hpp"
#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// A note names this many regions.
constexpr std::size_t kNamedRegions = 8;

void report_charts(Run& run, const Charts& charts, ChartMap map) {
  Json& results = run.report().results()["charts"];
  results["scale"] = charts.scale;
  results["covered_share"] = charts.covered;
  results["flipped_share"] = charts.share(&Chart::flipped_area);
  results["torn_share"] = charts.share(&Chart::torn_area);
  results["unplaced_share"] = charts.share(&Chart::unplaced_area);
  Json& listed = results["charts"] = Json::array();
  for (const Chart& chart : charts.charts) {
    const auto share = [&](double part) { return chart.area > 0 ? part / chart.area : 0; };
    Json& one = listed.emplace_back(Json{{"label", chart.generator.value()},
                                         {"faces", chart.faces},
                                         {"area", chart.area},
                                         {"flipped_share", share(chart.flipped_area)},
                                         {"stretch", chart.stretch}});
    if (const auto& box = chart.box; !box.isEmpty()) {
      one["box"] = {box.min().x(), box.min().y(), box.max().x(), box.max().y()};
    }
    if (map == ChartMap::flat) continue;
    one["torn_share"] = share(chart.torn_area);
    one["origin"] = {chart.origin.x(), chart.origin.y()};
  }
}

void note_shares(Run& run, const Charts& charts, ChartMap map) {
  const auto percent = [&](double Chart::*area_of) { return fmt::format("{:.3g} %", 100 * charts.share(area_of)); };
  const auto has = [&](double Chart::*area_of) { return charts.share(area_of) > 0; };
  run.console().note(fmt::format(
      "{} {:.3g} % of the texture{}", counted(std::ssize(charts.charts), "chart covers", "charts cover"),
      100 * charts.covered, map == ChartMap::flat && !has(&Chart::flipped_area) ? "; no face is flipped" : ""));
  if (has(&Chart::flipped_area)) {
    run.console().note(fmt::format("{} of the area is flipped{}", percent(&Chart::flipped_area),
                                   map == ChartMap::flat
                                       ? ": limbs too long for double precision; give more generators"
                                       : " where shortest paths meet, or flat behind saddles; --uv flat flips none"));
  }
  if (has(&Chart::torn_area)) {
    run.console().note(fmt::format("{} of the area is torn off its chart, where shortest paths come from two sides",
                                   percent(&Chart::torn_area)));
  }
  if (has(&Chart::unplaced_area)) {
    run.console().note(fmt::format("{} of the area has no texture coordinates: no path to its generator was found",
                                   percent(&Chart::unplaced_area)));
  }
}

}  // namespace

void describe(OptionList& list, ChartRequest& request) {
  list.option("disc", Flag{&request.disc},
              {.help = "Add generators, as few as are found, until every region is a disc"});
  list.option(
      "uv", choice(request.uv, kChartMapNames),
      {.help =
           "Give each region texture coordinates, in a " + list_extensions(output_extensions(Content::texture), "or"),
       .more = ": distance and direction from its generator, or a map that flips no face and needs discs (implies "
               "{option:cut})"});
  list.excludes("disc", {"balance", "weights"});
  list.excludes("uv", {"labels"});
}

Diagram make_cells_discs(Run& run, const Mesh& mesh, const Diagram& diagram) {
  DiscOptions options;
  options.diagram = run.options().compute.diagram;
  options.diagram.progress = run.progress();
  DiscCells made = run.timed("discs", [&] { return make_discs(mesh, diagram, options); });
  run.report().results()["disc"] = {
      {"added", made.added}, {"rounds", made.rounds}, {"search_cut_short", made.search_cut_short}};
  if (made.added > 0) {
    run.console().note(fmt::format("{} added, so that every cell is a disc{}",
                                   counted(made.added, "generator was", "generators were"),
                                   made.search_cut_short ? "; fewer may do" : ""));
    report_diagram(run, made.diagram);
  }
  return std::move(made.diagram);
}

void note_non_discs(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, const char* why) {
  const std::vector<GeneratorId> regions = find_non_disc_regions(mesh, label);
  if (regions.empty()) return;
  std::vector<std::int32_t> named;
  for (std::size_t i = 0; i < std::min(kNamedRegions, regions.size()); ++i) named.push_back(regions[i].value());
  run.console().note(fmt::format("{}: {}{}; {}",
                                 counted(std::ssize(regions), "region is no disc although its cell is",
                                         "regions are no discs although their cells are"),
                                 fmt::join(named, ", "), named.size() < regions.size() ? ", ..." : "", why));
}

Charts chart_regions(Run& run, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut,
                     const ChartRequest& request) {
  const ChartMap map = *request.uv;
  try {
    const ChartOptions options{map, run.options().compute.diagram.threads, run.progress()};
    Charts charts = run.timed("charts", [&] { return make_charts(mesh, diagram, cut, options); });
    report_charts(run, charts, map);
    note_shares(run, charts, map);
    return charts;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::no_valid_result || request.disc) throw;
    throw Error(error.code(), fmt::format("{}; --disc adds generators until every region is a disc", error.what()),
                error.element());
  }
}

}  // namespace gvd::app
