// Makes texture coordinates for regions: maps the islands of the cut mesh to the plane, and packs them into the unit
// square.
//
// The cut mesh is separated along the borders of its labels, so that each island has vertices of its own and no vertex
// occurs twice on a border. Islands keep their size in mesh units until all are packed; then a single scale takes them
// into the square. Faces are judged by their final coordinates, including rounding. If a flat map flips a face there,
// the next map replaces it, and all islands are packed again. The stretch is measured in the square, too, and divided
// by the scale. It is a mean of lengths and not of squared lengths, because the square of a very large stretch, in a
// face as thin as rounding, would outweigh all other faces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/plane.hpp"
#include "chart_maps.hpp"
#include "chart_surface.hpp"
#include "face_shares.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/charts.hpp"
#include "gvd/error.hpp"
#include "pack_boxes.hpp"

namespace gvd {
namespace {

constexpr StepPart kFlatMapping{"charts", 0, 0.9};

/// A corner of a face, in the square.
Vec2 corner_in_square(const Charts& charts, FaceId f, std::size_t c) {
  const auto& [u, v] = charts.texture[3 * f.index() + c];
  return Vec2(u, v);
}

/// The orientation of a face in the square; 1 if the face is certainly counter-clockwise.
int orientation_of(const Charts& charts, FaceId f) {
  return orientation(corner_in_square(charts, f, 0), corner_in_square(charts, f, 1), corner_in_square(charts, f, 2));
}

/// Whether a counter-clockwise face is no longer counter-clockwise if u and 1 - v are rounded to 32-bit floats, as in
/// glTF, where v runs downwards.
bool do_floats_flip(const Charts& charts, FaceId f) {
  const auto at = [&](std::size_t c) {
    const Vec2 p = corner_in_square(charts, f, c);
    return Vec2(double(float(p.x())), double(float(1 - p.y())));
  };
  return orientation_of(charts, f) > 0 && orientation(at(0), at(1), at(2)) >= 0;
}

/// Packs the islands and sets the texture coordinates. `corners`: the corners of all faces in mesh units, with an
/// origin for each island.
void place_islands(const std::vector<Island>& islands, const std::vector<PlaneCorners>& corners, Charts& charts) {
  std::vector<Box2> boxes;
  std::vector<Vec2> sizes;
  for (const Island& island : islands) {
    Box2 box;
    for (const FaceId f : island.faces) {
      for (const Vec2& p : corners[f.index()]) {
        if (p.allFinite()) box.extend(p);
      }
    }
    if (box.isEmpty()) box.extend(Vec2::Zero());
    boxes.push_back(box);
    sizes.push_back(box.sizes());
  }
  const Packing packing = pack_boxes(sizes);
  charts.scale = packing.side > 0 ? 1 / packing.side : 1;
  charts.texture.assign(3 * corners.size(), {kNaN, kNaN});
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const auto in_square = [&](const Vec2& p) -> Vec2 { return charts.scale * (packing.at[i] + (p - boxes[i].min())); };
    charts.charts[i].origin = in_square(Vec2::Zero());
    for (const FaceId f : islands[i].faces) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec2 p = in_square(corners[f.index()][c]);
        charts.texture[3 * f.index() + c] = {p.x(), p.y()};
      }
    }
  }
}

/// Maps all islands by flat maps: each by the first map that flips no face in the square, or by the last map.
void lay_flat(const ChartSurface& surface, Charts& charts) {
  const std::vector<Island>& islands = surface.islands();
  for (const Island& island : islands) {
    if (island.euler_characteristic == 1) continue;
    throw Error(ErrorCode::no_valid_result,
                fmt::format("region {} is not a disc (Euler characteristic {}) and can't be mapped flat; \1disc\2 adds "
                            "generators until every region is a disc",
                            island.generator.value(), island.euler_characteristic),
                island.generator.value());
  }
  const std::size_t faces = std::size_t(surface.mesh().face_count());
  std::vector<PlaneCorners> corners(faces, {kNowhere, kNowhere, kNowhere});
  std::vector<int> next(islands.size(), 0);
  std::vector<IslandBorder> borders(islands.size());
  std::vector<std::size_t> open(islands.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  const auto has_flip = [&](const Island& island) {
    return std::ranges::any_of(island.faces, [&](FaceId f) { return orientation_of(charts, f) <= 0; });
  };
  while (!open.empty()) {
    surface.parallel().run(open.size(), kFlatMapping, [&](std::size_t k) {
      int& attempt = next[open[k]];
      const Island& island = islands[open[k]];
      if (attempt == 0) borders[open[k]] = measure_border(surface, island);
      for (bool laid = false; !laid && attempt < kFlatMaps; ++attempt) {
        laid = map_flat(surface.mesh(), island, borders[open[k]], attempt, corners);
      }
    });
    place_islands(islands, corners, charts);
    std::erase_if(open, [&](std::size_t i) { return next[i] == kFlatMaps || !has_flip(islands[i]); });
  }
}

/// Measures a chart after its faces were placed. `torn` marks torn faces, and is empty if there are none.
void measure_chart(const Mesh& mesh, const Island& island, const IdVector<FaceId, char>& torn, const Charts& charts,
                   Chart& chart) {
  chart.generator = island.generator;
  chart.faces = std::ssize(island.faces);
  for (const FaceId f : island.faces) {
    const double area = mesh.area(f);
    chart.area += area;
    if (!torn.empty() && torn[f]) chart.torn_area += area;
    if (std::isnan(charts.texture[3 * f.index()][0])) {
      chart.unplaced_area += area;
    } else if (orientation_of(charts, f) <= 0) {
      chart.flipped_area += area;
    }
    if (!is_finite(charts.texture[3 * f.index()])) continue;
    // Adds the root mean square of the singular values of the face's map, weighted by its area.
    const FaceLayout layout(mesh, f);
    Eigen::Matrix2d sides, laid;
    sides << layout.corner[1] - layout.corner[0], layout.corner[2] - layout.corner[0];
    laid << corner_in_square(charts, f, 1) - corner_in_square(charts, f, 0),
        corner_in_square(charts, f, 2) - corner_in_square(charts, f, 0);
    chart.stretch += area * (laid * sides.inverse()).norm() / (std::numbers::sqrt2 * charts.scale);
    for (std::size_t c = 0; c < 3; ++c) chart.box.extend(corner_in_square(charts, f, c));
  }
  if (const double placed = chart.area - chart.unplaced_area; placed > 0) chart.stretch /= placed;
}

/// Whether an island has two copies of the same vertex.
bool touches_itself(const SeparatedMesh& separated, const Island& island) {
  std::vector<std::pair<VertexId, VertexId>> vertices;  // in the input, and in the separated mesh
  for (const FaceId f : island.faces) {
    for (const VertexId v : separated.mesh.vertices(f)) vertices.emplace_back(separated.input_vertex[v], v);
  }
  std::ranges::sort(vertices);
  const auto are_copies = [](const auto& a, const auto& b) { return a.first == b.first && a.second != b.second; };
  return std::adjacent_find(vertices.begin(), vertices.end(), are_copies) != vertices.end();
}

}  // namespace

double Charts::share(double Chart::*area_of) const {
  double part = 0, all = 0;
  for (const Chart& chart : charts) part += chart.*area_of, all += chart.area;
  return all > 0 ? part / all : 0;
}

std::vector<GeneratorId> find_non_disc_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label) {
  const SeparatedMesh separated = separate_regions(mesh, to_regions(face_label));
  std::map<GeneratorId, std::int64_t> parts;  // number of parts; 2 for a region that can't be a disc
  for (const Island& island : find_islands(separated.mesh, face_label)) {
    const bool is_disc = island.euler_characteristic == 1 && !touches_itself(separated, island);
    parts[island.generator] += is_disc ? 1 : 2;
  }
  std::vector<GeneratorId> regions;
  for (const auto& [region, count] : parts) {
    if (count > 1) regions.push_back(region);
  }
  return regions;
}

Charts make_charts(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options) {
  check_belongs(mesh, diagram);
  if (cut.parent.count() != cut.mesh.face_count() || cut.label.count() != cut.mesh.face_count() ||
      (!cut.parent.empty() && cut.parent.raw().back().value() >= mesh.face_count())) {
    throw Error(ErrorCode::precondition, "the cut mesh was made of another mesh");
  }
  const ChartSurface surface(mesh, diagram, cut, options);
  const std::vector<Island>& islands = surface.islands();
  Charts charts;
  charts.charts.resize(islands.size());
  IdVector<FaceId, char> torn;
  if (options.map == ChartMap::logmap) {
    place_islands(islands, map_by_logarithms(surface, torn), charts);
  } else {
    lay_flat(surface, charts);
  }
  for (std::size_t i = 0; i < islands.size(); ++i) {
    Chart& chart = charts.charts[i];
    measure_chart(surface.mesh(), islands[i], torn, charts, chart);
    charts.covered += chart.area * charts.scale * charts.scale;
  }
  charts.flipped_by_floats =
      std::ranges::count_if(surface.mesh().faces(), [&](FaceId f) { return do_floats_flip(charts, f); });
  return charts;
}

void replace_texture(std::vector<Uv> charts, Appearance& appearance) {
  if (!appearance.texture.empty()) {
    appearance.unread.emplace_back("texture coordinates of the input (replaced by \1uv\2)");
  }
  if (!appearance.material.empty()) {
    appearance.unread.emplace_back("materials of the input, whose images do not fit those of \1uv\2");
  }
  appearance.texture = std::move(charts);
  appearance.material.clear();
  appearance.materials.clear();
  appearance.material_files.clear();
}

}  // namespace gvd
