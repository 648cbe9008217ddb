// Describes the options of a diagram for users.

#include "gvd/diagram_options.hpp"

#include <fmt/format.h>

namespace gvd {
namespace {

constexpr int kMostThreads = 4096;

void describe_rules(OptionList& list, const DiagramOptions& options) {
  const auto clash = [&options] {
    return fmt::format("\1method={}\2 and \1chord_tolerance\2 exclude each other: keep one",
                       name_in(kMethodNames, options.method));
  };
  list.rule({"method", {"chord_tolerance"}, [&options, clash](const Given& given) {
               return given.has("chord_tolerance") && options.method != Method::exact ? clash() : "";
             }});
  list.rule({"chord_tolerance", {"method"}, [&options, clash](const Given&) {
               return options.method != Method::exact ? clash() : "";
             }});
  list.rule({"front", {"method", "chord_tolerance"}, [&options](const Given&) -> std::string {
               if (options.method != Method::exact) return "";
               return "\1front\2 has no effect here: add \1method=gbgvd\2 or \1method=paper\2, or leave "
                      "\1front\2 out";
             }});
}

}  // namespace

void describe(OptionList& list, DiagramOptions& options) {
  list.group(kComputingGroup);
  list.option("method", choice(options.method, kMethodNames),
              {.help = "How to build the diagram",
               .more = ": from exact distances, by growth with fast marching, or by the paper's steps as written"});
  list.option("chord_tolerance", Number{&options.chord_tolerance, {.least = kLeastChordTolerance}},
              {.help = "Largest distance between an exact bisector and its straight pieces",
               .more = fmt::format(", at least {}; below that, rounding decides", kLeastChordTolerance),
               .unit = "mean edge lengths"});
  list.option("front", choice(options.front, kFrontNames),
              {.help = "Shape of the front in fast marching",
               .usual = "planar with \1method=paper\2, circle with \1method=gbgvd\2"});
  describe_rules(list, options);
}

void describe_threads(OptionList& list, int& threads) {
  list.group(kComputingGroup);
  list.option("threads", Number{&threads, {.least = 1, .most = kMostThreads}},
              {.help = "Number of threads", .more = "; it does not change the result", .usual = "all cores"});
}

void resolve(DiagramOptions& options) {
  if (options.method != Method::exact) options.front = options.chosen_front();
}

}  // namespace gvd
