#pragma once

#include <vector>

#include "diagram/envelope/bisector_sample.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/envelope/visible_sources.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Samples the bisector of an arc's two generators in a band of a face, and tells whether segments are near enough.
class BisectorSampler {
 public:
  /// `distances` must outlive this. `tolerance` in mesh units, > 0.
  BisectorSampler(const SourceDistances& distances, double tolerance) : distances_(distances), tolerance_(tolerance) {}

  /// Takes the sources of the arc's generators in the current face that may see a point of the band.
  void enter(const FaceArc& arc, const SearchBand& band);

  const SearchBand& band() const { return band_; }
  BisectorSample sample(const Vec2& p) const;

  /// Whether the bisector is within half of the tolerance of a sample: its distance is the error divided by the
  /// gradient.
  bool is_near(const BisectorSample& sample) const;
  /// The same for the segment between two samples that are near enough. The bisector has a corner where a path changes
  /// from one source to another. So the segment is sampled where paths change, unless the corner can't be high.
  /// Cost: a few paths for each change. A corner that may be high takes one sample or more, over all sources that may
  /// see the band.
  bool is_near_between(const BisectorSample& a, const BisectorSample& b) const;

 private:
  bool is_near_between(const BisectorSample& a, const BisectorSample& b, int splits) const;

  const SourceDistances& distances_;
  double tolerance_;
  SearchBand band_{};
  std::vector<VisibleSource> left_, right_;
};

}  // namespace gvd
