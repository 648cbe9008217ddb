// Reads a window field for tracers: sources on edges and in faces, and tables of generators.
//
// Idea: a kept window is an image with an interval, so it is a source of its edge, and of the face that it enters. The
// ends of an edge and the corners of a face are sources, too, because shortest paths can come through them.
// Source: the windows of Mitchell, Mount and Papadimitriou (1987); the tables of section 4.1 of the paper.
// Invariant: where windows were kept, the least of the sources' distances is exact, and the distance of each source is
// the length of a path.
#include "geodesic/windows/window_sources.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/plane.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Number of faces between two reports of progress.
constexpr std::int32_t kTableStride = 1 << 12;

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
      if (w.is_parallel()) {
        sources.push_back(EdgeSource::parallel(w.begin, w.end, w.x, w.offset, w.generator));
      } else {
        sources.push_back({w.begin, w.end, w.x, w.depth, w.offset, w.generator});
      }
    });
  }
  field.windows.for_each(twin.valid() ? twin : h, [&](const Window& w) {
    if (w.is_parallel()) {
      sources.push_back(EdgeSource::parallel(length - w.end, length - w.begin, -w.x, w.distance(length), w.generator));
    } else {
      sources.push_back({length - w.end, length - w.begin, length - w.x, w.depth, w.offset, w.generator});
    }
  });
}

void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources) {
  sources.clear();
  const std::array<Vec2, 3> side{layout.side(0), layout.side(1), layout.side(2)};
  field.windows.for_each(f, [&](const Window& w) {
    const HalfedgeId h = w.halfedge;
    if (!mesh.twin(h).valid() && !w.begins_here()) return;  // the boundary: the paths leave the face
    const int i = Mesh::corner(h);
    const Vec2 &origin = layout.corner[i], &along = side[i];
    const Vec2 inwards = turned_left(along), to_image = w.x * along - w.depth * inwards;
    FaceSource s{origin + to_image,        origin + w.begin * along, origin + w.end * along, w.offset, w.generator, h,
                 FaceSource::Kind::window, w.distance(w.begin),      w.distance(w.end)};
    if (w.is_parallel()) [[unlikely]] {
      s.kind = FaceSource::Kind::parallel;
      s.image = to_image;
      s.offset = -kInfinity;
    }
    sources.push_back(s);
  });
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh.vertices(f)[i];
    if (!field.label[v].valid()) continue;
    sources.push_back(FaceSource::corner(layout.corner[i], field.distance[v], field.label[v], Mesh::halfedge(f, i)));
  }
}

// This visits faces rather than edges, so that each window is read once. Most faces have no windows.
std::vector<EdgeId> WindowDistances::contested_edges(const ParallelChunks& parallel) const {
  const auto faces = cut_into_chunks(mesh_.face_count(), kScanChunk);
  std::vector<EdgeId> edges = parallel.collect(faces, steps::kLabels, [&](const Chunk& chunk) {
    std::vector<EdgeId> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      const auto& [a, b, c] = mesh_.vertices(f);
      const std::array<GeneratorId, 3> label{field_.label[a], field_.label[b], field_.label[c]};
      std::array<bool, 3> is_contested{label[0] != label[1], label[1] != label[2], label[2] != label[0]};
      field_.windows.for_each(f, [&](const Window& w) {
        const int side = Mesh::corner(w.halfedge);
        is_contested[side] |= w.generator != label[side];
      });
      for (int side = 0; side < 3; ++side) {
        if (is_contested[side]) found.push_back(mesh_.edge(Mesh::halfedge(f, side)));
      }
    }
    return found;
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
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
      std::array<double, 3> least{kInfinity, kInfinity, kInfinity};
      for (const FaceSource& s : sources) {
        if (s.generator != g) continue;
        for (std::size_t k = 0; k < 3; ++k) least[k] = std::min(least[k], s.distance(layout.corner[k]));
      }
      std::array<std::int32_t, 3> corner{};
      for (std::size_t k = 0; k < 3; ++k) corner[k] = table.lower(mesh.vertices(f)[k], g, least[k]);
      table.add(f, g, corner, 0);
      std::erase_if(sources, [g](const FaceSource& s) { return s.generator == g; });
    }
  }
  return table;
}

}  // namespace gvd
