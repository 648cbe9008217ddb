#pragma once

#include <string>
#include <vector>

#include "gvd/soup.hpp"
#include "gvd/vec.hpp"
#include "support/random.hpp"

namespace gvd::test {

/// Polygons that a file might hold, good ones and bad ones.
struct RandomSoup {
  std::string name;  ///< of the shape and of what was done to it, for messages
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> polygons;
};

/// One of a dozen shapes, sometimes several at once, sometimes squashed, turned, scaled or moved far away.
RandomSoup make_random_soup(Random& random);

/// The soup as the text of an OBJ file, every digit kept.
std::string write_obj(const RandomSoup& soup);

}  // namespace gvd::test
