#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/options/options.hpp"
#include "common/regions.hpp"
#include "common/run.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/segment.hpp"

// The regions that gvd-segment keeps to: given ones, those of a mask, and those of the coarser levels.
namespace gvd::app {

struct RegionOptions : RegionFiles {
  std::optional<std::int32_t> per_region;  ///< generators of each region, >= 1
  std::vector<std::int32_t> levels;        ///< numbers of generators, ascending; empty: one level
};

void describe(OptionList& list, RegionOptions& options);

/// A surface that is parted before it is segmented.
class PartedSurface {
 public:
  /// Reads the regions, and labels all levels but the last. Throws Error{unreadable_input} where there is no such file
  /// or property.
  PartedSurface(Run& run, const CheckedMesh& input, const RegionOptions& options, const SegmentOptions& labels);

  /// The input, or its faces with the vertices on borders doubled.
  const CheckedMesh& input() const { return input_; }
  const Mesh& mesh() const { return is_parted() ? separated_.mesh : input_.mesh; }

  /// Generators by the options of the run, sampled inside the regions or moved into them.
  std::vector<SurfacePoint> make_generators(Run& run) const;

  /// The diagram for files, which hold the input's vertices alone: the same one, or a copy in `restricted` where
  /// borders have more vertices.
  const Diagram& restrict(const Diagram& diagram, Diagram& restricted) const;

  /// The numbers of the input's faces besides their labels: the region, and the labels of coarser levels.
  const std::vector<FaceNumbers>& numbers() const { return numbers_; }
  /// With levels, adds the labels of the last one: those of the faces themselves.
  void add_labels(const IdVector<FaceId, GeneratorId>& labels, std::vector<FaceNumbers>& numbers) const;

  /// The edges between two regions, or beside faces that are left out.
  std::vector<std::vector<Vec3>> borders() const;

  bool is_left_out(FaceId f) const { return is_parted() && regions_[f] < 0; }

 private:
  bool is_parted() const { return !regions_.empty(); }
  void label_levels(Run& run, const SegmentOptions& labels);
  void note_samples(Run& run, const RegionSamples& samples) const;

  const CheckedMesh& input_;
  const RegionOptions& options_;
  FaceRegions regions_;  // empty: all faces are one
  SeparatedMesh separated_;
  std::vector<FaceNumbers> numbers_;
};

/// The numbers whose names are those of levels.
std::vector<FaceNumbers> levels_of(const std::vector<FaceNumbers>& numbers);

}  // namespace gvd::app
