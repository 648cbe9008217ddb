#pragma once

#include <string>
#include <vector>

#include "gvd/soup.hpp"
#include "gvd/vec.hpp"
#include "support/random.hpp"

namespace gvd::test {

/// Polygons as a file might contain them, valid or not.
struct RandomSoup {
  std::string name;  ///< the shape and its changes, for messages
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
};

/// One of a dozen shapes, sometimes several at once, sometimes squashed, turned, scaled or moved far away.
RandomSoup make_random_soup(Random& random);

/// The soup as the text of an OBJ file, with all digits.
std::string write_obj(const RandomSoup& soup);

}  // namespace gvd::test
