#pragma once

#include <array>
#include <vector>

#include "diffusion/heat_field.hpp"
#include "gvd/ids.hpp"
#include "pieces/clip_polygon.hpp"
#include "pieces/piece_contacts.hpp"

namespace gvd::paper {

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
