// Texture coordinates for regions: islands of the cut mesh, laid into the plane and packed into the unit square.
//
// The cut mesh is taken apart along the borders of its labels, so that each island has vertices of its own and a border
// without a vertex twice. Islands keep their size in mesh units until all are packed; then one scale takes them into
// the square. Faces are judged by their final coordinates, rounding included. A flat map that turns a face round there
// is replaced by its next one, and all islands are packed again.
// The stretch is measured there, too, and divided by the scale. It is a mean of lengths and not of their squares: a
// face as thin as rounding adds its small area times a large factor, and squares of that would outweigh all others.
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

void check_cut(const Mesh& mesh, const CutMesh& cut) {
  const bool fits = cut.parent.count() == cut.mesh.face_count() && cut.label.count() == cut.mesh.face_count() &&
                    (cut.parent.empty() || cut.parent.raw().back().value() < mesh.face_count());
  if (!fits) throw Error(ErrorCode::precondition, "the cut mesh was made of another mesh");
}

constexpr StepPart kFlatMapping{"charts", 0, 0.9};

class ChartMaker {
 public:
  ChartMaker(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options)
      : surface_(mesh, diagram, cut, options) {}

  Charts run(ChartMap map) {
    charts_.charts.resize(islands().size());
    if (map == ChartMap::logmap) {
      corners_ = map_by_logarithms(surface_, torn_);
      place();
    } else {
      lay_flat();
    }
    for (std::size_t i = 0; i < islands().size(); ++i) measure(i);
    charts_.covered =
        std::accumulate(charts_.charts.begin(), charts_.charts.end(), 0.0,
                        [&](double sum, const Chart& c) { return sum + c.area * charts_.scale * charts_.scale; });
    return std::move(charts_);
  }

 private:
  const Mesh& mesh() const { return surface_.mesh(); }
  const std::vector<Island>& islands() const { return surface_.islands(); }

  void lay_flat() {
    for (const Island& island : islands()) check_disc(island);
    corners_.assign(std::size_t(mesh().face_count()), {kNowhere, kNowhere, kNowhere});
    std::vector<int> next(islands().size(), 0);
    std::vector<IslandBorder> borders(islands().size());
    std::vector<std::size_t> open(islands().size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    while (!open.empty()) {
      surface_.parallel().run(open.size(), kFlatMapping, [&](std::size_t k) {
        int& attempt = next[open[k]];
        const Island& island = islands()[open[k]];
        if (attempt == 0) borders[open[k]] = measure_border(surface_, island);
        for (bool laid = false; !laid && attempt < kFlatMaps; ++attempt) {
          laid = map_flat(mesh(), island, borders[open[k]], attempt, corners_);
        }
      });
      place();
      std::erase_if(open, [&](std::size_t i) { return next[i] == kFlatMaps || !has_flip(i); });
    }
  }

  void check_disc(const Island& island) const {
    if (island.euler_characteristic == 1) return;
    throw Error(ErrorCode::no_valid_result,
                fmt::format("region {} is no disc (Euler characteristic {}), and can't be laid flat; \1disc\2 adds "
                            "generators until every region is a disc",
                            island.generator.value(), island.euler_characteristic),
                island.generator.value());
  }

  bool has_flip(std::size_t i) const {
    return std::ranges::any_of(islands()[i].faces, [&](FaceId f) { return orientation_of(f) <= 0; });
  }

  /// 1 if counter-clockwise in the square, for certain.
  int orientation_of(FaceId f) const { return orientation(corner_of(f, 0), corner_of(f, 1), corner_of(f, 2)); }

  /// In the square.
  Vec2 corner_of(FaceId f, std::size_t c) const {
    const auto& [u, v] = charts_.texture[3 * f.index() + c];
    return Vec2(u, v);
  }

  /// Packs the islands and sets the texture coordinates.
  void place() {
    std::vector<Box2> boxes;
    std::vector<Vec2> sizes;
    for (const Island& island : islands()) {
      Box2 box;
      for (const FaceId f : island.faces) {
        for (const Vec2& p : corners_[f.index()]) {
          if (p.allFinite()) box.extend(p);
        }
      }
      if (box.isEmpty()) box.extend(Vec2::Zero());
      boxes.push_back(box);
      sizes.push_back(box.sizes());
    }
    const Packing packing = pack_boxes(sizes);
    charts_.scale = packing.side > 0 ? 1 / packing.side : 1;
    charts_.texture.assign(3 * corners_.size(), {kNaN, kNaN});
    for (std::size_t i = 0; i < islands().size(); ++i) {
      const auto in_square = [&](const Vec2& p) -> Vec2 {
        return charts_.scale * (packing.at[i] + (p - boxes[i].min()));
      };
      charts_.charts[i].origin = in_square(Vec2::Zero());
      for (const FaceId f : islands()[i].faces) {
        for (std::size_t c = 0; c < 3; ++c) {
          const Vec2 p = in_square(corners_[f.index()][c]);
          charts_.texture[3 * f.index() + c] = {p.x(), p.y()};
        }
      }
    }
  }

  void measure(std::size_t i) {
    Chart& chart = charts_.charts[i];
    chart.generator = islands()[i].generator;
    chart.faces = std::ssize(islands()[i].faces);
    for (const FaceId f : islands()[i].faces) {
      const double area = mesh().area(f);
      chart.area += area;
      if (!torn_.empty() && torn_[f]) chart.torn_area += area;
      if (std::isnan(charts_.texture[3 * f.index()][0])) {
        chart.unplaced_area += area;
      } else if (orientation_of(f) <= 0) {
        chart.flipped_area += area;
      }
      if (is_finite(charts_.texture[3 * f.index()])) add_stretch(f, area, chart);
    }
    if (const double placed = chart.area - chart.unplaced_area; placed > 0) chart.stretch /= placed;
  }

  /// Adds the root mean square of the singular values of the face's map, by its area.
  void add_stretch(FaceId f, double area, Chart& chart) const {
    const FaceLayout layout(mesh(), f);
    Eigen::Matrix2d sides, laid;
    sides << layout.corner[1] - layout.corner[0], layout.corner[2] - layout.corner[0];
    laid << corner_of(f, 1) - corner_of(f, 0), corner_of(f, 2) - corner_of(f, 0);
    chart.stretch += area * (laid * sides.inverse()).norm() / (std::numbers::sqrt2 * charts_.scale);
    for (std::size_t c = 0; c < 3; ++c) chart.box.extend(corner_of(f, c));
  }

  ChartSurface surface_;
  std::vector<PlaneCorners> corners_;  // mesh units, each island round an origin of its own
  IdVector<FaceId, char> torn_;
  Charts charts_;
};

/// Whether an island has two vertices that are copies of one.
bool touches_itself(const SeparatedMesh& separated, const Island& island) {
  std::vector<std::pair<VertexId, VertexId>> vertices;  // of the input, and of the separated mesh
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
  std::map<GeneratorId, std::int64_t> parts;  // 2 for a region that can't be a disc
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
  check_cut(mesh, cut);
  return ChartMaker(mesh, diagram, cut, options).run(options.map);
}

void replace_texture(std::vector<Uv> charts, Appearance& appearance) {
  if (!appearance.texture.empty()) {
    appearance.unread.emplace_back("texture coordinates of the input, for those of \1uv\2");
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
