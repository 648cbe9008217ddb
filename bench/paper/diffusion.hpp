#pragma once

#include <array>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "pieces.hpp"

namespace gvd::paper {

/// The heat that has spread from each generator after one implicit time step.
///
/// Source: K. Crane, C. Weischedel, M. Wardetzky, Geodesics in heat, 2013, its first step; P. Herholz, F. Haase, M.
///   Alexa, Diffusion diagrams, 2017. (M + t L) u = e with the lumped mass M and the cotangent Laplacian L; e is 1 at
///   the generator's vertex, so that every generator sends the same heat.
/// Heat falls like exp(-distance / sqrt(t)) and would underflow some 700 sqrt(t) away. It is scaled by kScale, the same
/// for all generators, which moves that to more than 1200 sqrt(t). Obtuse angles make negative values possible. What is
/// below kFloor is 0.
struct HeatField {
  static constexpr double kScale = 1e250, kFloor = 1e-290;

  std::vector<std::vector<double>> heat;  ///< [generator][vertex], >= 0, in units without meaning
};

/// One sparse factorisation, and one solution for each generator. `time`: square mesh units, > 0.
/// Throws Error{no_valid_result} if the factorisation fails. Cost: about O(n^1.5) for it, O(n log n) for each solution.
HeatField compute_heat(const Mesh& mesh, const std::vector<VertexId>& generators, double time);

/// Cuts a face where the linear fields of two generators' heat are equal.
///
/// A triangle whose corners have one label is whole: the fields are linear. Where corners and midpoints of sides have
/// two labels, the line on which their fields are equal cuts it. Otherwise it is split at the midpoints. At the cap,
/// three labels meet in its centre.
/// Source: Herholz, Haase, Alexa 2017, as section 5.4 of the paper describes it.
class HeatEnvelope {
 public:
  /// `most_splits`: the cap, >= 0. All arguments must outlive this.
  HeatEnvelope(const Mesh& mesh, const HeatField& field, int most_splits);

  /// Appends the pieces of face f; whether the cap ended a split.
  bool cut(FaceId f, Pieces& pieces);

  /// The generator with the largest heat at a vertex, the lower one of equals; invalid where no heat arrives.
  GeneratorId warmest(VertexId v) const { return label_[v]; }

 private:
  using Triangle = std::array<std::array<double, 3>, 3>;

  void find_candidates(FaceId f);
  LinearForm heat(GeneratorId g) const;
  GeneratorId warmest(const std::array<double, 3>& bary) const;
  LinearForm difference(GeneratorId a, GeneratorId b) const;
  void cut(const Triangle& triangle, int splits, Pieces& pieces);
  void split(const Triangle& triangle, const Triangle& middles, int splits, Pieces& pieces);
  void cut_in_two(const Triangle& triangle, GeneratorId a, GeneratorId b, Pieces& pieces) const;
  void join_in_centre(const Triangle& triangle, const std::array<GeneratorId, 3>& label, Pieces& pieces) const;

  const Mesh& mesh_;
  const HeatField& field_;
  int most_splits_;
  IdVector<VertexId, GeneratorId> label_;
  FaceId face_;                          // the current one
  std::vector<GeneratorId> candidates_;  // that can be the warmest in it
  std::vector<LinearForm> forms_;        // their heat at its corners
  bool capped_ = false;
};

}  // namespace gvd::paper
