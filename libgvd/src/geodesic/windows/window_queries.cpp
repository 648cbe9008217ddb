// Reads a window field for tracers and users: sources on edges and in faces, and tables of generators.
//
// Idea: a kept window is an image with an interval, so it is a source of its edge, and of the face that it enters. The
// ends of an edge and the corners of a face are sources too: shortest paths can come through them.
// Source: the windows of Mitchell, Mount and Papadimitriou (1987); the tables of section 4.1 of the paper.
// Invariant: where windows were kept, the least of the sources' distances is exact, and each one is a path's length.
#include "geodesic/windows/window_queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported once every so many faces.
constexpr std::int32_t kTableStride = 1 << 12;

/// The length of generator g's shortest path to p among these sources.
double least_distance(const std::vector<FaceSource>& sources, GeneratorId g, const Vec2& p) {
  double least = kInfinity;
  for (const FaceSource& s : sources) {
    if (s.generator == g) least = std::min(least, s.distance(p));
  }
  return least;
}

}  // namespace

void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources) {
  sources.clear();
  const double length = mesh.length(h);
  const VertexId from = mesh.from(h), to = mesh.to(h);
  if (field.label[from].valid()) sources.push_back({0, length, 0, 0, field.distance[from], field.label[from]});
  if (field.label[to].valid()) sources.push_back({0, length, length, 0, field.distance[to], field.label[to]});
  const HalfedgeId twin = mesh.twin(h);
  if (twin.valid()) {
    field.windows.for_each(h, [&](const Window& w) {
      sources.push_back({w.begin, w.end, w.x, w.depth, w.offset, w.generator});
    });
  }
  field.windows.for_each(twin.valid() ? twin : h, [&](const Window& w) {
    sources.push_back({length - w.end, length - w.begin, length - w.x, w.depth, w.offset, w.generator});
  });
}

void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources) {
  sources.clear();
  const std::array<Vec2, 3> side{layout.side(0), layout.side(1), layout.side(2)};
  field.windows.for_each(f, [&](const Window& w) {
    const HalfedgeId h = w.halfedge;
    if (!mesh.twin(h).valid()) return;  // the boundary: the paths leave the face
    const int i = Mesh::corner(h);
    const Vec2 origin = layout.corner[i], along = side[i], inwards = turned_left(along);
    const Vec2 image = origin + w.x * along - w.depth * inwards;
    sources.push_back({image, origin + w.begin * along, origin + w.end * along, w.offset, w.generator, h, false,
                       w.distance(w.begin), w.distance(w.end)});
  });
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh.vertices(f)[i];
    if (!field.label[v].valid()) continue;
    const Vec2 at = layout.corner[i];
    const double d = field.distance[v];
    sources.push_back({at, at, at, d, field.label[v], Mesh::halfedge(f, i), true, d, d});
  }
}

std::vector<EdgeId> WindowDistances::contested_edges(const ParallelChunks& parallel) const {
  // Whether a halfedge has a window of another label than its start. So each window is read once.
  IdVector<HalfedgeId, std::uint8_t> has_other(mesh_.halfedge_count(), 0);
  const auto faces = cut_into_chunks(mesh_.face_count(), kScanChunk);
  parallel.run(faces.size(), steps::kLabels, [&](std::size_t chunk) {
    for (std::size_t f = faces[chunk].begin; f < faces[chunk].end; ++f) {
      field_.windows.for_each(FaceId(f), [&](const Window& w) {
        const GeneratorId label = field_.label[mesh_.from(w.halfedge)];
        if (w.generator != label) has_other[w.halfedge] = 1;
      });
    }
  });
  return find_edges(mesh_, parallel, [&](EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
    return field_.label[mesh_.from(h)] != field_.label[mesh_.to(h)] || has_other[h] != 0 ||
           (twin.valid() && has_other[twin] != 0);
  });
}

GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress) {
  GeneratorTable table(mesh.vertex_count(), mesh.face_count());
  for (const VertexId v : mesh.vertices()) {
    if (field.label[v].valid()) table.add(v, field.label[v], field.distance[v], HalfedgeId());
  }
  std::vector<FaceSource> sources;
  for (const FaceId f : mesh.faces()) {
    if (f.value() % kTableStride == 0) report_progress(progress, steps::kTables, double(f.value()) / mesh.face_count());
    const FaceLayout layout(mesh, f);
    collect_face_sources(mesh, field, f, layout, sources);
    while (!sources.empty()) {
      const GeneratorId g = sources.front().generator;
      std::array<std::int32_t, 3> corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = table.lower(mesh.vertices(f)[k], g, least_distance(sources, g, layout.corner[k]));
      }
      table.add(f, g, corner, 0);
      std::erase_if(sources, [g](const FaceSource& s) { return s.generator == g; });
    }
  }
  return table;
}

}  // namespace gvd
