#include "rvd/lrvd.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "cpu_clock.hpp"
#include "pieces/collect_pieces.hpp"
#include "pieces/islands.hpp"
#include "rvd/euclidean_cells.hpp"
#include "rvd/rvd.hpp"

namespace gvd::paper {
namespace {

class IslandSweeper {
 public:
  IslandSweeper(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const std::vector<Vec3>& positions)
      : mesh_(mesh), generators_(generators), cells_(mesh, positions) {}

  /// Divides all islands that cells touch among these; whether there was one.
  bool sweep(Pieces& pieces) {
    const auto contacts = find_contacts(mesh_, pieces);
    parts_ = find_cell_parts(mesh_, generators_, pieces, contacts);
    find_touching_cells(pieces, contacts);
    Pieces swept;
    bool changed = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::vector<GeneratorId>& around = touching_[part(i)];
      if (around.empty()) {
        swept.push_back(std::move(pieces[i]));
      } else {
        divide(pieces[i], around, swept);
        changed = true;
      }
    }
    pieces = std::move(swept);
    return changed;
  }

 private:
  std::size_t part(std::size_t piece) const { return static_cast<std::size_t>(parts_.part_of[piece]); }

  void find_touching_cells(const Pieces& pieces, const std::vector<Contact>& contacts) {
    std::vector<std::set<GeneratorId>> touching(parts_.area.size());
    const auto add = [&](std::int32_t from, std::int32_t to) {
      const std::size_t island = part(static_cast<std::size_t>(from)), cell = part(static_cast<std::size_t>(to));
      if (!parts_.is_island(static_cast<std::int32_t>(island)) || parts_.has_generator[cell] == 0) return;
      touching[island].insert(pieces[to].generator);
    };
    for (const Contact& c : contacts) {
      add(c.left, c.right);
      add(c.right, c.left);
    }
    touching_.clear();
    for (const auto& cells : touching) touching_.emplace_back(cells.begin(), cells.end());
  }

  void divide(const FacePiece& piece, const std::vector<GeneratorId>& cells, Pieces& swept) const {
    for (const GeneratorId g : cells) {
      Polygon polygon = cells_.clip(piece.face, piece.corners, g, cells);
      if (!polygon.empty()) swept.push_back({piece.face, g, std::move(polygon)});
    }
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  EuclideanCells cells_;
  CellParts parts_;
  std::vector<std::vector<GeneratorId>> touching_;  // [component] the cells that touch an island, ascending
};

}  // namespace

Comparison compute_lrvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LrvdOptions& options) {
  const std::vector<Vec3> positions = find_positions(mesh, generators);
  Comparison result;
  Pieces pieces = time_voronoi_cells(mesh, positions, result);
  const double start = bench::cpu_milliseconds();
  IslandSweeper sweeper(mesh, generators, positions);
  result.rounds = 0;
  while (result.rounds < options.most_rounds && sweeper.sweep(pieces)) ++result.rounds;
  result.diagram_ms += bench::cpu_milliseconds() - start;
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

}  // namespace gvd::paper
