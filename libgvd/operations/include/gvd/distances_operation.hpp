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

  GeneratorOptions sources, targets;             ///< listed points; the sources may be curves
  bool each = false;                             ///< measure from each source separately
  bool paths = false;                            ///< trace a shortest path from each target
  std::optional<double> max_distance, isolines;  ///< mesh units; `isolines` is the step between levels
  GivenNumbers levels;                           ///< levels of isolines, in place of a step
  bool logarithm = false;                        ///< compute the logarithmic map of every vertex at the only source
  bool keep_coincident = false;                  ///< sources may coincide
  bool mesh_vertices = false;                    ///< the columns of rows are the mesh's vertices, not the input's
  GivenRegions regions;
  /// Largest size of the table of `each` in bytes; a larger table is refused before the work.
  double most_bytes = std::numeric_limits<double>::infinity();
};

/// The results that a caller wants besides the distances of all vertices from the nearest source.
struct AskedDistances {
  bool targets = false, each = false, paths = false, isolines = false;
};

AskedDistances asked_of(const DistancesCall& call);

/// Throws Error{invalid_option} if none of the files would hold one of the results. `others`: other outputs that hold
/// all results, as messages name them; `has_other`: whether such an output is written, too.
void check_files(const AskedDistances& asked, const std::vector<WrittenFile>& files,
                 const std::vector<std::string>& others = {}, bool has_other = false);

/// Describes the options, except options for programs only, such as `logarithm`, whose result no file of the command
/// holds. `describe_for_programs` describes these.
void describe(OptionList& list, DistancesCall& call);
void describe_for_programs(OptionList& list, DistancesCall& call);

/// The result of `distances`: distances from sources, with paths and isolines.
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
  /// `part` is "path N" for a single path.
  OwnWriters part_writers(std::string_view part) const override;
  const Mesh& surface() const { return parted.surface(input->mesh); }

  AskedDistances asked;
  MeshPtr input = std::make_shared<CheckedMesh>();
  PartedMesh parted;                                 ///< the regions, which paths don't leave
  std::vector<std::optional<double>> snap_distance;  ///< for each source, how far it was moved to the surface
  std::vector<GeneratorCurve> curves;                ///< the sources, if they are curves
  DistanceTable table;
  std::vector<MeshCurve> polylines;         ///< paths and isolines as polylines, for files
  PlacedPoints sources, targets;            ///< their places on the surface
  bool has_limit = false;                   ///< whether there is a largest distance
  bool has_mesh_vertices = false;           ///< the columns of rows are the mesh's vertices, not the input's
  std::unique_ptr<const ExactField> field;  ///< from all sources together; null with `each`
  IdVector<VertexId, double> distance;      ///< from the nearest source, for the mesh's vertices; empty with `each`
  IdVector<VertexId, GeneratorId> label;    ///< the nearest source
  std::vector<std::array<double, 2>> logarithms;  ///< for the mesh's vertices; NaN without a path
  std::int64_t unreached = 0;                     ///< number of infinite distances
};

/// Notes list at most this many distances to targets.
inline constexpr std::size_t kToldDistances = 8;

/// Says how many distances are infinite, and why; empty if none is.
std::string describe_unreached(const DistancesOutcome& outcome);
/// Up to kToldDistances distances to targets, one line each, with the reason for an infinite one.
std::vector<std::string> describe_targets(const DistancesOutcome& outcome);

/// Measures distances, and traces paths and isolines. Throws what `resolve_generators`, `find_regions` and ExactField
/// throw, and Error{precondition} if a source lies in faces that are left out.
/// Cost: one ExactField, or one for each source with `each`.
std::shared_ptr<const DistancesOutcome> run(const MeshPtr& input, DistancesCall& call, Observer& observer);

}  // namespace gvd
