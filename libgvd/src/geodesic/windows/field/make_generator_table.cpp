#include "geodesic/windows/field/make_generator_table.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "geodesic/field/face_layout.hpp"
#include "geodesic/windows/field/collect_sources.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported once every so many faces.
constexpr std::int32_t kTableStride = 1 << 12;

/// Generator g's distance at v, lowered to `distance`; returns its index in the table.
std::int32_t lower(GeneratorTable& table, VertexId v, GeneratorId g, double distance) {
  const std::int32_t index = table.find(v, g);
  if (index < 0) return table.add(v, g, distance, HalfedgeId());
  VertexDistance& known = table.distance(index);
  known.distance = std::min(known.distance, distance);
  return index;
}

/// The length of generator g's shortest path to p among these sources.
double least_distance(const std::vector<FaceSource>& sources, GeneratorId g, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const FaceSource& s : sources) {
    if (s.generator == g) least = std::min(least, s.distance(p));
  }
  return least;
}

}  // namespace

GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress) {
  GeneratorTable table(mesh.vertex_count(), mesh.face_count());
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (field.label[v].valid()) table.add(v, field.label[v], field.distance[v], HalfedgeId());
  }
  std::vector<FaceSource> sources;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    if (i % kTableStride == 0) report_progress(progress, steps::kTables, double(i) / mesh.face_count());
    const FaceLayout layout(mesh, f);
    collect_face_sources(mesh, field, f, layout, sources);
    while (!sources.empty()) {
      const GeneratorId g = sources.front().generator;
      std::array<std::int32_t, 3> corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = lower(table, mesh.vertices(f)[k], g, least_distance(sources, g, layout.corner[k]));
      }
      table.add(f, g, corner, 0);
      std::erase_if(sources, [g](const FaceSource& s) { return s.generator == g; });
    }
  }
  return table;
}

}  // namespace gvd
