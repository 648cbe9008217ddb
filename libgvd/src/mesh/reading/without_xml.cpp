// Replaces the readers that GVD_WITH_XML=OFF leaves out on platforms without pugixml and zlib. Each function throws an
// error that says so.
#include <string>

#include "gvd/error.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(std::string_view name, const char* what) {
  throw Error(ErrorCode::unreadable_input, std::string(name) + ": " + what);
}

}  // namespace

std::string unpack_gzip(std::string_view, std::string_view name) {
  refuse(name, "compressed by gzip, which is not read here; unpack it first");
}

PolygonSoup parse_vtk_xml(std::string_view, std::string_view name) {
  refuse(name, "VTK's XML (.vtp, .vtu) is not read here; convert it to VTK, PLY or OBJ");
}

std::optional<SoupProperty> parse_vtk_xml_property(std::string_view, std::string_view, std::string_view name,
                                                   SoupElement) {
  parse_vtk_xml({}, name);
  return std::nullopt;
}

PolygonSoup parse_gifti(std::string_view, std::string_view name) {
  refuse(name, "GIFTI is not read here; convert it to PLY or OBJ");
}

std::vector<double> parse_gifti_values(std::string_view, std::string_view name) {
  refuse(name, "GIFTI is not read here; convert it to text");
}

}  // namespace gvd
