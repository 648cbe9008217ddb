// The options of a remesh, for users.

#include "gvd/remesh_options.hpp"

#include <fmt/format.h>

#include "gvd/lloyd_options.hpp"

namespace gvd {
namespace {

void describe_mesh(OptionList& list, SurfaceRemeshOptions& options) {
  RemeshOptions& remesh = options.remesh;
  list.group("Remesh");
  list.option("max_added", Number{&remesh.max_added, {.least = 0, .most = 1e9}},
              {.help = "Largest number of generators to add",
               .usual = "ten for each given generator, component, boundary loop and handle, plus 100"});
  list.option("refine", Flag{&remesh.refine},
              {.help = "Add no generators",
               .more = "; fail if the given ones are too few for a valid mesh",
               .arrays = "Add generators where the given ones are too few for a valid mesh; false: fail there"});
  list.option(
      "exact_count", Flag{&options.exact_count},
      {.help = "Exactly as many vertices as asked for, or no mesh",
       .more = ": leave out a generator where the mesh can do without it for each one that is added (generators "
               "of a list stay: the same as \1refine\2)",
       .arrays =
           "Exactly as many vertices as asked for, or no mesh: leave out a generator where the mesh can do without "
           "it for each one that is added (generators that are given stay: the same as \1refine=false\2)"});
  list.option(
      "place", choice(options.placement, kPlacementNames),
      {.help = "Where to put vertices",
       .more = ": at the generators, at the best points for the planes of their cells, or fitted to the surface",
       .usual = "fit; generator with \1generators\2 and \1vertices\2"});
  list.option("shape", Number{&remesh.placement.shape, {.least = 0, .most = 1}},
              {.help = "With \1place=fit\2: from 0, the nearest to the surface, to 1, the best triangles"});
  list.option("allow_intersections", Flag{&remesh.allow_intersections},
              {.help = "Accept triangles that intersect each other instead of adding generators there"});
  list.excludes("refine", {"max_added"});
  list.excludes("exact_count", {"refine"});
}

}  // namespace

void describe(OptionList& list, SurfaceRemeshOptions& options) {
  list.group("Relaxation");
  list.option("relax", Number{&options.relaxation, {.least = 0, .most = 1'000'000}, {{"none", 0}}},
              {.help = "Iterations that first move the generators to the centroids of their cells",
               .more = "; 'none' leaves them in place",
               .usual = fmt::format("{}; none with \1generators\2 and \1vertices\2", kRemeshRelaxation)});
  describe(list, options.start);
  list.option("loose_boundary", Flag{&options.start.constraints.prefers_boundary, false},
              {.help = "Put no generators on the boundary",
               .more = "; the outline then runs through generators beside it",
               .usual = "with \1count\2 and \1radius\2: \1keep_boundary\2, if it takes at most half of "
                        "the generators"});
  list.excludes("loose_boundary", {"keep_boundary"});
  describe_mesh(list, options);
}

}  // namespace gvd
