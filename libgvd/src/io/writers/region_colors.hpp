#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/mesh.hpp"

// Chooses colours of regions, for files and pages.
namespace gvd::io {

/// The colours of regions. Any two of them differ by at least 14.6 in CIEDE2000, and each differs as much from
/// kUnlabelledColor. This holds for full colour vision and for protanopia, deuteranopia and tritanopia, simulated by
/// the matrices of Machado et al. 2009, and the first two also by those of Vienot et al. 1999. The usual colours have
/// lightnesses from 60 to 93; the other three have a lightness of 38, because no lighter ones differ as much.
inline constexpr std::array<Rgb, 9> kRegionPalette{{{0x5f, 0xc1, 0xd9},
                                                    {0xfd, 0xec, 0x8f},
                                                    {0xde, 0x72, 0x4b},
                                                    {0xbf, 0xf5, 0xf9},
                                                    {0x78, 0x89, 0xed},
                                                    {0xd5, 0xe4, 0xcb},
                                                    {0x49, 0x51, 0xb8},
                                                    {0xae, 0x1b, 0x37},
                                                    {0x7b, 0x4a, 0x65}}};
/// Number of usual colours, which come first in the palette; dark lines are hard to see on the others.
inline constexpr std::size_t kUsualColors = 6;

using RegionPair = std::pair<GeneratorId, GeneratorId>;

/// Appends, for each edge, the pair of labels on its two sides.
void add_face_neighbours(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::vector<RegionPair>& pairs);

/// Appends the pairs of cells with a common bisector.
void add_cell_neighbours(const IdVector<GeneratorId, Cell>& cells, std::vector<RegionPair>& pairs);

/// Sorts the pairs and removes duplicates. In each pair the smaller label comes first.
void sort_pairs(std::vector<RegionPair>& pairs);

/// A colour of the palette for each of `count` labels, such that adjacent ones differ.
///
/// Each label in turn takes a colour that no neighbour has yet: a usual colour if there is one, and among several the
/// colour that the fewest labels have. In the order of the labels (smallest-last, Matula and Beck 1983), each label has
/// at most d neighbours before it, d being the degeneracy of the graph. For connected regions d is at most 5 on a
/// surface of genus 0. For genus g > 0 it is at most (5 + sqrt(1 + 48 g)) / 2 (Heawood 1890). So the usual colours
/// suffice for genus 0, and the palette up to genus 3. Elsewhere, a label whose neighbours have all colours takes the
/// colour that the fewest of them have.
/// Cost: O(n log n) for n labels and pairs.
std::vector<Rgb> choose_region_colors(std::size_t count, const std::vector<RegionPair>& adjacent);

/// Adapts the colours of a similar graph, `before`, until adjacent labels differ. Only labels change that have the
/// colour of a neighbour, that are new, or that have a dark colour without need. `before`: colours of the first labels,
/// all from the palette.
///
/// A label takes a usual colour that no neighbour has, if there is one. Otherwise it takes the colour of a neighbour,
/// which then needs another colour in turn. This nearly always ends after a few changes. If it does not, all colours
/// are chosen from scratch.
/// Cost: O(n log n) for n labels and pairs; nearly always O(n).
std::vector<Rgb> adapt_region_colors(const std::vector<Rgb>& before, std::size_t count,
                                     const std::vector<RegionPair>& adjacent);

}  // namespace gvd::io
