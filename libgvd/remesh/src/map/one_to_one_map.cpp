#include "map/one_to_one_map.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "map/cell_map.hpp"

namespace gvd {
namespace {

/// Faces of a chunk of cells: their systems take milliseconds.
constexpr std::size_t kMapFacesPerChunk = 2048;

struct Image {
  VertexId vertex;  ///< of the surface
  SurfacePoint point;
};

struct CellPoints {
  SurfacePoint origin;
  std::vector<Image> images;
};

class OneToOneMapper {
 public:
  OneToOneMapper(const Mesh& surface, const RemeshResult& result)
      : surface_(surface),
        result_(result),
        cells_(cut_into_cells(surface, result)),
        polygons_(cells_.cut.mesh, cells_.cut.label, result.mesh),
        input_{surface_, result_, cells_, polygons_},
        faces_(result.generators.size()) {
    place_crossings(cells_, polygons_);
    const auto& label = cells_.cut.label;
    for (std::size_t i = 0; i < label.size(); ++i) {
      const FaceId f(i);
      faces_[label[f]].push_back(f);
    }
  }

  MapPoints run(int threads) const {
    const Progress none;
    const ParallelChunks parallel(threads, none);
    const auto chunks =
        cut_by_work(faces_.size(), kMapFacesPerChunk, [&](std::size_t i) { return faces_.raw()[i].size(); });
    const std::vector<CellPoints> cells = parallel.collect(chunks, {}, [&](const Chunk& chunk) {
      std::vector<CellPoints> found;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        found.push_back(map_cell(GeneratorId(i)));
      }
      return found;
    });
    MapPoints points;
    points.images.resize(static_cast<std::size_t>(surface_.vertex_count()));
    for (const CellPoints& cell : cells) {
      points.origins.push_back(cell.origin);
      for (const Image& image : cell.images) points.images[image.vertex] = image.point;
    }
    return points;
  }

 private:
  /// Vertices between two cells are on both borders; there, they have the same point.
  CellPoints map_cell(GeneratorId g) const {
    const PlaneCell plane = flatten_cell(input_, g, faces_[g]);
    CellPoints cell{plane.origin, {}};
    for (std::size_t i = 0; i < plane.disc.vertices.size(); ++i) {
      const VertexId v = plane.disc.vertices[i];
      if (v.value() < surface_.vertex_count()) cell.images.push_back({v, plane.image(plane.disc.points[i])});
    }
    for (const BorderTarget& t : plane.targets) {
      const VertexId v = cells_.cut.mesh.from(t.halfedge);
      if (v.value() < surface_.vertex_count()) cell.images.push_back({v, t.polygon->on_remesh(t.from)});
    }
    if (plane.origin.kind() == SurfacePoint::Kind::vertex) {
      cell.images.push_back({vertex(surface_, plane.origin), vertex_point(result_.mesh, plane.vertex)});
    }
    return cell;
  }

  const Mesh& surface_;
  const RemeshResult& result_;
  CellSurface cells_;
  DualPolygons polygons_;
  CellMapInput input_;
  IdVector<GeneratorId, std::vector<FaceId>> faces_;
};

}  // namespace

MapPoints one_to_one_points(const Mesh& surface, const RemeshResult& result, int threads) {
  return OneToOneMapper(surface, result).run(threads);
}

}  // namespace gvd
