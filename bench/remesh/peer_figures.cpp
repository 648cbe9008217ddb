// Figures of other programs, beside which those of gvd-remesh are set.
//
// They were measured once: ACVD and ACVDQ with `-m 1`, Geogram with 5 iterations of Lloyd and 30 of Newton, and CGAL's
// quadric decimation (QEM), on nine meshes with 100, 500 and 2000 vertices. They are data: peers.tsv has a line for
// each run. A remesh is compared with the best of them, figure by figure, and so are the means and sums over all
// models.
#include "peer_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "gvd/error.hpp"

namespace gvd::bench {
namespace {

/// Differences below this fraction of the best figure are none.
constexpr double kLevel = 1e-6;

std::optional<double> optional_number(const std::string& text) {
  if (text == "-") return std::nullopt;
  return std::stod(text);
}

PeerRun parse_run(const std::string& line) {
  std::istringstream in(line);
  PeerRun run;
  RemeshQuality& q = run.quality;
  std::string topology, kept;
  in >> run.vertices >> run.model >> run.program >> topology >> q.inflation >> q.hausdorff >> q.rms >> q.q >>
      q.least_angle >> q.below_30 >> q.intersections >> q.seconds >> kept;
  if (!in) throw Error(ErrorCode::unreadable_input, fmt::format("'{}' has not 13 fields", line));
  q.right_topology = topology == "right";
  q.creases_kept = optional_number(kept);
  return run;
}

bool is_model(const std::string& model, const std::string& mesh) {
  return mesh.starts_with(model) &&
         (mesh.size() == model.size() || mesh[model.size()] == '.' || mesh[model.size()] == '_');
}

}  // namespace

std::vector<PeerRun> read_peer_runs(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line)) throw Error(ErrorCode::unreadable_input, fmt::format("{} can't be read", path));
  std::vector<PeerRun> runs;
  while (std::getline(in, line)) runs.push_back(parse_run(line));
  return runs;
}

std::vector<PeerRun> runs_on(const std::vector<PeerRun>& runs, const std::string& mesh, int vertices) {
  std::vector<PeerRun> found;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
               [&](const PeerRun& run) { return run.vertices == vertices && is_model(run.model, mesh); });
  return found;
}

const std::vector<ComparedFigure>& compared_figures() {
  static const std::vector<ComparedFigure> figures{{"vert/n"},         {"Hausd"},        {"RMS", true, 4},
                                                   {"Q", false},       {"<30", true, 2}, {"least", false, 1},
                                                   {"inters", true, 0}};
  return figures;
}

FigureValues values_of(const RemeshQuality& q) {
  return {q.inflation, q.hausdorff, q.rms, q.q, q.below_30, q.least_angle, q.intersections};
}

const std::vector<ComparedFigure>& compared_totals() {
  static const std::vector<ComparedFigure> figures{{"topology right", false, 0},
                                                   {"worst vertices / n"},
                                                   {"mean Hausdorff, %"},
                                                   {"mean RMS, %", true, 4},
                                                   {"mean Q", false},
                                                   {"mean below 30 degrees, %", true, 2},
                                                   {"least angle", false, 1},
                                                   {"intersecting pairs", true, 0},
                                                   {"CPU, s (elsewhere)", true, 1, false},
                                                   {"creases kept, %", false, 1}};
  return figures;
}

FigureValues totals_of(const std::vector<RemeshQuality>& remeshes) {
  if (remeshes.empty()) return FigureValues(compared_totals().size());
  RemeshQuality sum;
  sum.least_angle = 180;
  double right = 0, kept = 0, worst_inflation = 0, with_creases = 0;
  for (const RemeshQuality& q : remeshes) {
    right += q.right_topology;
    worst_inflation = std::max(worst_inflation, q.inflation);
    sum.least_angle = std::min(sum.least_angle, q.least_angle);
    for (const auto figure : {&RemeshQuality::hausdorff, &RemeshQuality::rms, &RemeshQuality::q,
                              &RemeshQuality::below_30, &RemeshQuality::intersections, &RemeshQuality::seconds}) {
      sum.*figure += q.*figure;
    }
    kept += q.creases_kept.value_or(0);
    with_creases += q.creases_kept.has_value();
  }
  const double count = double(remeshes.size());
  const std::optional<double> mean_kept = with_creases > 0 ? std::optional(kept / with_creases) : std::nullopt;
  return {
      right,           worst_inflation,   sum.hausdorff / count, sum.rms / count, sum.q / count, sum.below_30 / count,
      sum.least_angle, sum.intersections, sum.seconds,           mean_kept};
}

std::string compare_with_best(double ours, const std::vector<PeerValues>& peers, std::size_t index,
                              const ComparedFigure& figure) {
  if (!figure.is_comparable) return {};
  const PeerValues* best = nullptr;
  const auto is_better = [&](double a, double b) { return figure.smaller_is_better ? a < b : a > b; };
  for (const PeerValues& peer : peers) {
    if (!peer.values[index]) continue;
    if (!best || is_better(*peer.values[index], *best->values[index])) best = &peer;
  }
  if (!best) return {};
  const double value = *best->values[index], difference = std::abs(ours - value);
  if (difference <= kLevel * std::abs(value)) return "level";
  const std::string by = fmt::format("{:.{}f}", difference, figure.digits);
  return is_better(ours, value) ? "ahead by " + by : fmt::format("behind {} by {}", best->program, by);
}

}  // namespace gvd::bench
