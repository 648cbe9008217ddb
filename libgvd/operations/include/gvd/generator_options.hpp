#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// The source of the generators: exactly one of count, points, vertices, curves, radius, target_edge, error and
/// implied_count is set.
struct GeneratorOptions {
  /// How messages call the two options that list points: names or placeholders.
  std::string points_name = "generators", vertices_name = "\1vertices\2";
  std::optional<std::int32_t> count;       ///< >= 1
  Sampling sampling = Sampling::farthest;  ///< how `count` generators are sampled
  std::uint64_t seed = 0;
  GivenPoints points, vertices;       ///< listed generators; at most one of the two
  GivenCurves curves;                 ///< in place of points
  std::optional<double> radius;       ///< covering radius in mesh units, > 0
  std::optional<double> target_edge;  ///< mean edge of a mesh of the generators, mesh units, > 0
  std::optional<ErrorBound> error;    ///< as many generators as a mesh with this error needs
  std::optional<double> max_snap;     ///< largest snap distance allowed, mesh units, >= 0
  bool merge_coincident = false;
  std::optional<std::int32_t> implied_count;  ///< what `per_region` or `levels` imply, in place of `count`

  /// How many generators to sample; nothing if no option says so.
  std::optional<std::int32_t> wanted() const { return count ? count : implied_count; }
  /// Whether the user lists the generators.
  bool are_listed() const { return points.is_given() || vertices.is_given(); }
};

/// The heading of the options for generators.
inline constexpr const char* kGeneratorGroup =
    "Generators (one of \1count\2, \1generators\2, \1vertices\2, \1radius\2)";

/// Describes the options. One of `others` may replace the four options that say which generators there are.
void describe(OptionList& list, GeneratorOptions& generators, const std::vector<std::string>& others = {});

/// Describes the option for curves that take the place of points.
void describe_curves(OptionList& list, GeneratorOptions& generators);

/// The library's options for sampled generators of a diagram.
SamplingOptions make_sampling_options(const GeneratorOptions& asked, const DiagramOptions& diagram, Observer& observer);

/// Resolves the listed generators to points of the mesh. Notes points that were moved and merged. Throws what
/// `resolve_generators` throws.
ResolvedGenerators resolve_listed(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer,
                                  bool keep_coincident = false);

/// Lists or samples the generators, as the options say. Throws what `resolve_listed` and `sample_generators` throw.
ResolvedGenerators choose_generators(const CheckedMesh& input, const GeneratorOptions& asked,
                                     const DiagramOptions& diagram, Observer& observer);

/// Finds the curves that are the generators: boundary loops, creases, or listed curves. Throws what `resolve_curves`
/// throws, and Error{precondition} if the mesh has no boundary or no crease.
std::vector<GeneratorCurve> choose_curves(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer);

/// Points as a list of entries. `name`: how messages call the list if it has no name of its own.
GeneratorList list_points(const GivenPoints& points, const std::string& name);

/// Notes the entry of a list that is farthest from the surface, if it is far relative to the model's `diagonal` (mesh
/// units).
void note_far_entry(Observer& observer, const ResolvedGenerators& resolved, double diagonal);

}  // namespace gvd
