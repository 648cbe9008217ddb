#include "segment/segment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// A note names this many generators; the report lists all.
constexpr std::size_t kNamed = 8;

void note_without_face(Run& run, const std::vector<GeneratorId>& without_face) {
  if (without_face.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, without_face.size()); ++i) {
    names += fmt::format("{}{}", i > 0 ? ", " : "", without_face[i].value());
  }
  if (without_face.size() > kNamed) names += ", ...";
  run.console().note(fmt::format("{} inside faces of other regions: {}",
                                 counted(std::ssize(without_face), "generator owns no face, its cell lies",
                                         "generators own no face, their cells lie"),
                                 names));
}

}  // namespace

void report_segment_options(Run& run, const OwnOptions& own) {
  run.report().options()["cut"] = own.cut;
  const std::string& stats = run.options().output.own.at("--stats");
  run.report().options()["stats"] = stats.empty() ? Json() : Json(stats);
  const bool smooth = own.segment_options().labels == FaceLabels::smooth;
  run.report().options()["labels"] = own.cut ? Json() : Json(smooth ? "smooth" : "nearest");
}

void report_segmentation(Run& run, const Segmentation& segmentation) {
  note_without_face(run, segmentation.without_face);
  Json without_face = Json::array();
  for (const GeneratorId id : segmentation.without_face) without_face.push_back(id.value());
  Json& results = run.report().results();
  results["generators_without_face"] = std::move(without_face);
  results["moved_faces"] = segmentation.moved_faces;
  results["given_faces"] = segmentation.given_faces;
  results["smoothed_faces"] = segmentation.smoothed_faces;
}

void report_borders(Run& run, double border_length, double bisector_length) {
  Json ratio;
  if (bisector_length > 0) {
    ratio = border_length / bisector_length;
    run.console().detail(fmt::format("borders of length {:.6g}, {:.3f} times that of the bisectors", border_length,
                                     border_length / bisector_length));
  }
  Json& results = run.report().results();
  results["border_length"] = border_length;
  results["border_ratio"] = std::move(ratio);
}

void report_cut(Run& run, const CutMesh& cut) {
  if (cut.uncut_faces > 0)
    run.console().note(fmt::format("{} could not be cut", counted(cut.uncut_faces, "face", "faces")));
  run.report().results()["uncut_faces"] = cut.uncut_faces;
}

void report_regions(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  const auto unreached = std::count_if(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); });
  if (unreached > 0)
    run.console().note(fmt::format("{} reached by no generator: label -1", counted(unreached, "face is", "faces are")));
  const IdVector<GeneratorId, RegionSize> sizes = measure_regions(mesh, label, count);
  Json regions = Json::array();
  for (std::size_t g = 0; g < sizes.size(); ++g) {
    const auto& [faces, area] = sizes.raw()[g];
    regions.push_back({{"label", g}, {"faces", faces}, {"area", area}});
  }
  Json& results = run.report().results();
  results["faces"] = mesh.face_count();
  results["unreached_faces"] = unreached;
  results["regions"] = std::move(regions);
}

}  // namespace gvd::app
