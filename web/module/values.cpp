// Points, and options that several calls share.
#include "values.hpp"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <array>

#include "gvd/generator_list.hpp"

namespace gvd::web {
namespace {

constexpr double kReportInterval = 100;  ///< between two calls of a progress function, milliseconds

}  // namespace

val to_points(const std::vector<SurfacePoint>& points) {
  std::vector<FaceId> faces;
  std::vector<double> bary;
  for (const SurfacePoint& point : points) {
    faces.push_back(point.face);
    bary.insert(bary.end(), point.bary.begin(), point.bary.end());
  }
  return object({{"face", to_array(faces)}, {"bary", to_array(bary)}});
}

val to_positions(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& point : points) positions.push_back(position(mesh, point));
  return to_array(positions);
}

GeneratorList make_list(const char* name, const val& entries) {
  const auto kind = kPointKinds.at(entries["kind"].as<std::size_t>());
  const auto ids = emscripten::convertJSArrayToNumberVector<double>(entries["id"]);
  const auto at = emscripten::convertJSArrayToNumberVector<double>(entries["at"]);
  GeneratorList list{name, {}};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    GeneratorEntry entry{kind, std::int64_t(ids[i])};
    if (3 * i + 2 < at.size()) std::copy_n(at.begin() + std::ptrdiff_t(3 * i), 3, entry.values.begin());
    list.entries.push_back(entry);
  }
  return list;
}

std::vector<SurfacePoint> resolve(const Mesh& mesh, const char* name, const val& entries) {
  std::optional<double> max_snap;
  Given(mesh, entries).read("max_snap", max_snap);
  return resolve_points(mesh, make_list(name, entries), max_snap, entries["coincident"].as<std::string>());
}

SamplingOptions Given::sampling(const char*) const {
  SamplingOptions options;
  read("n", options.count);
  read("sampling", options.kind, kSamplingNames);
  read("seed", options.seed);
  read("radius", options.radius);
  if (has("radius")) options.kind = Sampling::covering_radius;
  options.front = diagram().chosen_front();
  return options;
}

DiagramOptions Given::diagram() const {
  DiagramOptions options;
  read("method", options.method, kMethodNames);
  read("front", options.front, kFrontNames);
  read("chord_tolerance", options.chord_tolerance);
  options.progress = progress();
  return options;
}

Progress Given::progress() const {
  if (!has("progress")) return {};
  return [call = options_["progress"], next = 0.0](std::string_view step, double fraction) mutable {
    if (emscripten_get_now() < next) return true;
    next = emscripten_get_now() + kReportInterval;
    return !call(std::string(step), fraction).isFalse();
  };
}

std::string spell_properties(std::string_view text) {
  return spell_options(text, {.spell = [](std::string_view name, std::string_view value) {
                         std::string spelled(name);
                         if (value == "false") return "no_" + spelled + ": true";
                         if (value.empty()) return spelled;
                         return spelled + (value == "true" ? ": true" : ": '" + std::string(value) + '\'');
                       }});
}

}  // namespace gvd::web
