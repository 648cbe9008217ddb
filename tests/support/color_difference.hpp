#pragma once

#include <array>
#include <string>
#include <vector>

#include "gvd/io/label_color.hpp"

namespace gvd::test {

/// CIE L*, a*, b*, for the white point D65.
using Lab = std::array<double, 3>;

/// The colour difference CIEDE2000 with unit weights (Sharma, Wu and Dalal 2005).
double ciede2000(const Lab& one, const Lab& two);

/// A kind of vision.
struct Vision {
  std::string name;
  std::array<double, 9> matrix;  ///< of linear red, green and blue, by rows
};

/// Full colour vision, and the simulations of protanopia, deuteranopia and tritanopia by Machado, Oliveira and
/// Fernandes 2009 at full severity.
const std::vector<Vision>& visions();

/// The colour as this vision sees it.
Lab seen(const Vision& vision, const Rgb& color);

/// The smallest difference of two colours over all visions.
double least_difference(const Rgb& one, const Rgb& two);

}  // namespace gvd::test
