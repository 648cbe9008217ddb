#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "gvd/exact_field.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/given_regions.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/parted_mesh.hpp"

namespace gvd {

/// The options of the operation `distances`.
struct DistancesCall {
  DistancesCall();

  GeneratorOptions sources, targets;             ///< listed ones; the sources may be curves
  bool each = false;                             ///< measure from each source alone
  bool paths = false;                            ///< from each target
  std::optional<double> max_distance, isolines;  ///< mesh units; of isolines the step between levels
  GivenNumbers levels;                           ///< of isolines, in place of a step
  bool logarithm = false;                        ///< of every vertex, at the only source
  bool keep_coincident = false;                  ///< sources may be in the same place
  bool mesh_vertices = false;                    ///< rows are those of the mesh's vertices, not of the input's
  GivenRegions regions;
  /// The most bytes that the table of `each` may take: more are refused before the work.
  double most_bytes = std::numeric_limits<double>::infinity();
};

/// The results that a caller wants beside the distances of all vertices from the nearest source.
struct AskedDistances {
  bool targets = false, each = false, paths = false, isolines = false;
};

AskedDistances asked_of(const DistancesCall& call);

/// Throws Error{invalid_option} where the files together would lose some of it. `others`: what else holds all, in
/// messages; `has_other`: whether that is written, too.
void check_files(const AskedDistances& asked, const std::vector<WrittenFile>& files,
                 const std::vector<std::string>& others = {}, bool has_other = false);

/// Describes them, but for those that only programs have, as `logarithm`, which no file of the command holds.
void describe(OptionList& list, DistancesCall& call);
void describe_for_programs(OptionList& list, DistancesCall& call);

/// Distances from sources, with paths and isolines.
class DistancesOutcome : public Object {
 public:
  static constexpr Content kContent =
      Content::distances | Content::rows | Content::targets | Content::curves | Content::paths | Content::isolines;
  std::string_view kind() const override { return "distances"; }
  Content content() const override { return kContent; }
  void check_file(const WrittenFile& file) const override { check_files(asked, {file}); }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;
  /// "path N": that path alone.
  OwnWriters part_writers(std::string_view part) const override;
  const Mesh& surface() const { return parted.surface(input->mesh); }

  AskedDistances asked;
  MeshPtr input = std::make_shared<CheckedMesh>();
  PartedMesh parted;                                 ///< paths don't leave its regions
  std::vector<std::optional<double>> snap_distance;  ///< of the sources, from where they were given
  std::vector<GeneratorCurve> curves;                ///< the sources, where they are curves
  DistanceTable table;
  std::vector<MeshCurve> polylines;               ///< paths and isolines, for files
  PlacedPoints sources, targets;                  ///< on the surface
  bool has_limit = false;                         ///< whether there is a largest distance
  bool has_mesh_vertices = false;                 ///< columns of rows are the mesh's vertices, not those of the input
  std::unique_ptr<const ExactField> field;        ///< of the nearest source; null with `each`
  IdVector<VertexId, double> distance;            ///< of the mesh's vertices from the nearest source; empty with `each`
  IdVector<VertexId, GeneratorId> label;          ///< that source
  std::vector<std::array<double, 2>> logarithms;  ///< of the mesh's vertices; NaN where no path leads
  std::int64_t unreached = 0;                     ///< distances that are infinite
};

/// Notes name at most so many distances to targets.
inline constexpr std::size_t kToldDistances = 8;

/// Says how many distances are infinite, and why; empty where none is.
std::string describe_unreached(const DistancesOutcome& outcome);
/// The distances to targets, a line each, up to that number; of infinite ones, why.
std::vector<std::string> describe_targets(const DistancesOutcome& outcome);

/// Measures, traces paths and isolines. Throws what resolve_generators, find_regions and ExactField throw;
/// Error{precondition} where a source lies in faces that are left out.
std::shared_ptr<const DistancesOutcome> run(const MeshPtr& input, DistancesCall& call, Observer& observer);

}  // namespace gvd
