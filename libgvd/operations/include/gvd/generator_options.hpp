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

/// Where the generators come from: exactly one of count, points, vertices, curves, radius, target_edge, error and
/// implied_count is set.
struct GeneratorOptions {
  /// What messages call the points, and the options that list them: names or placeholders.
  std::string points_name = "generators", vertices_name = "\1vertices\2";
  std::optional<std::int32_t> count;       ///< >= 1
  Sampling sampling = Sampling::farthest;  ///< of `count` ones
  std::uint64_t seed = 0;
  GivenPoints points, vertices;       ///< listed ones; at most one of the two
  GivenCurves curves;                 ///< in place of points
  std::optional<double> radius;       ///< covering radius in mesh units, > 0
  std::optional<double> target_edge;  ///< of a mesh of the generators, mesh units, > 0
  std::optional<ErrorBound> error;    ///< as many as a mesh of them needs
  std::optional<double> max_snap;     ///< largest snap distance allowed, mesh units, >= 0
  bool merge_coincident = false;
  std::optional<std::int32_t> implied_count;  ///< of per_region and levels, in place of `count`

  /// How many are to be sampled; nothing where no option says so.
  std::optional<std::int32_t> wanted() const { return count ? count : implied_count; }
  /// Whether the generators are those of a list: where the user wants them.
  bool are_listed() const { return points.is_given() || vertices.is_given(); }
};

/// The heading of their options.
inline constexpr const char* kGeneratorGroup =
    "Generators (one of \1count\2, \1generators\2, \1vertices\2, \1radius\2)";

/// Describes them; one of `others` may take the place of the four that say which generators there are.
void describe(OptionList& list, GeneratorOptions& generators, const std::vector<std::string>& others = {});

/// Describes the curves that may take the place of points.
void describe_curves(OptionList& list, GeneratorOptions& generators);

/// The library's options for sampled generators of a diagram.
SamplingOptions make_sampling_options(const GeneratorOptions& asked, const DiagramOptions& diagram, Observer& observer);

/// The generators that are listed, as points of the mesh. Notes what was moved and merged. Throws what
/// resolve_generators throws.
ResolvedGenerators resolve_listed(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer,
                                  bool keep_coincident = false);

/// The generators, as many as the options say: listed or sampled. Throws what resolve_listed and sample_generators
/// throw.
ResolvedGenerators choose_generators(const CheckedMesh& input, const GeneratorOptions& asked,
                                     const DiagramOptions& diagram, Observer& observer);

/// The curves that are the generators: boundary loops, creases, or those of a list. Throws what resolve_curves throws,
/// and
/// Error{precondition} if the mesh has no boundary or no crease.
std::vector<GeneratorCurve> choose_curves(const CheckedMesh& input, const GeneratorOptions& asked, Observer& observer);

/// Points as a list of entries. `name`: what messages call it where it has no name of its own.
GeneratorList list_points(const GivenPoints& points, const std::string& name);

/// Notes which entry of a list lies farthest from the surface, if that is far in view of the model's `diagonal`, in
/// mesh units.
void note_far_entry(Observer& observer, const ResolvedGenerators& resolved, double diagonal);

}  // namespace gvd
