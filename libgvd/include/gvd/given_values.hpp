#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Points, numbers and curves as users give them: by name, as on a command line, or as values, as programs do.
//
// A command reads the named files before it calls an operation, so that operations only see values.
namespace gvd {

struct CurveList;
struct ElementValues;
struct GeneratorList;

struct GivenPoints {
  std::optional<std::vector<std::int64_t>> vertices = {};  ///< vertices of the input, counted from 0
  std::string file = {};                                   ///< a file that lists points, or "-"; empty for none
  std::shared_ptr<const GeneratorList> list = {};          ///< the points as values, in place of the other two

  bool is_given() const { return vertices || !file.empty() || list; }
};

/// A number for each vertex or face, or for each generator.
struct GivenNumbers {
  std::string name = {};  ///< a word, a file or a property of the input; empty for none
  std::shared_ptr<const ElementValues> values = {};

  bool is_given() const { return !name.empty() || values; }
};

struct GivenCurves {
  std::string name = {};  ///< "boundary", "creases", "creases:ANGLE" or a file; empty for none
  std::shared_ptr<const CurveList> list = {};

  bool is_given() const { return !name.empty() || list; }
};

}  // namespace gvd
