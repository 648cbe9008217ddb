// The options that the library's structs describe: their names and defaults are those of the structs.

#include "gvd/diagram_options.hpp"
#include "gvd/lloyd_options.hpp"
#include "gvd/option_text.hpp"
#include "gvd/remesh_options.hpp"
#include "gvd/segment_options.hpp"
#include "support/catch.hpp"

namespace gvd::test_library_options {

using Names = std::vector<std::string>;

Names names_of(const OptionList& list) {
  Names names;
  for (const Option* const option : list.options()) names.push_back(option->name);
  return names;
}

TEST_CASE("a diagram's options are described once, and depend on its method") {
  DiagramOptions options;
  OptionList list;
  describe(list, options);
  describe_threads(list, options.threads);
  CHECK(names_of(list) == Names{"method", "chord_tolerance", "front", "threads"});
  CHECK(list.find_unknown_names().empty());
  CHECK(list.find("method")->spec.usual == "exact");
  CHECK(list.find("chord_tolerance")->spec.usual == "0.0001");
  CHECK(!read_option(*list.find("chord_tolerance"), {"9e-11"}).empty());
  Given given;
  given.add("front", {"front", ""});
  CHECK(list.find_problem(given)->text ==
        "\1front\2 has no effect here: add \1method=gbgvd\2 or \1method=paper\2, or leave \1front\2 "
        "out");
  CHECK(read_option(*list.find("method"), {"paper"}).empty());
  CHECK(!list.find_problem(given));
  given.add("chord_tolerance", {"chord_tolerance", ""});
  CHECK(list.find_problem(given)->text == "\1method=paper\2 and \1chord_tolerance\2 exclude each other: keep one");
  resolve(options);
  CHECK(options.front == Front::planar);
}

TEST_CASE("a relaxation's options say their defaults, and resolve them") {
  LloydOptions options;
  OptionList list;
  describe(list, options);
  CHECK(names_of(list) == Names{"accelerate", "relocate", "iterations", "tolerance", "move_tolerance"});
  CHECK(list.find("iterations")->spec.usual == "300; 100 with \1accelerate=none\2");
  CHECK(list.find_unknown_names().empty());
  resolve(options);
  CHECK(options.max_iterations == 300);
  CHECK(options.relocate == true);
  CHECK(!options.energy_tolerance);
  LloydOptions plain;
  plain.acceleration = Acceleration::none;
  resolve(plain);
  CHECK(plain.max_iterations == 100);
  CHECK(plain.relocate == false);
  CHECK(plain.energy_tolerance == 1e-5);
}

TEST_CASE("a remesh has the options of its start, with its own defaults") {
  SurfaceRemeshOptions options;
  OptionList list;
  describe(list, options);
  CHECK(names_of(list) == Names{"relax", "coarse", "features", "keep_boundary", "gradation", "loose_boundary",
                                "max_added", "refine", "exact_count", "place", "shape", "allow_intersections"});
  CHECK(list.find("features")->spec.usual == "auto");
  CHECK(list.find("refine")->is_on);
  CHECK(!list.find("loose_boundary")->is_on);
  CHECK(read_option(*list.find("loose_boundary"), {}).empty());
  CHECK(!options.start.constraints.prefers_boundary);
  RelaxationStartOptions start;
  OptionList plain;
  describe(plain, start);
  CHECK(plain.find("features")->spec.usual == "none");
}

TEST_CASE("faces are labelled smoothly unless the options say otherwise") {
  SegmentOptions options;
  OptionList list;
  list.group("Regions");
  describe(list, options);
  CHECK(list.find("labels")->spec.usual == "smooth");
}

}  // namespace gvd::test_library_options
