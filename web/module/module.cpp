// The web module: the library as the npm package needs it. The classes that users meet are in web/npm, with their
// documents and checks of arguments; nothing here is meant to be called by others. Names are those of Python.
#include "gvd/version.hpp"
#include "scenes.hpp"
#include "values.hpp"

EMSCRIPTEN_BINDINGS(gvd) {
  emscripten::function(
      "version", +[] { return std::string(gvd::version()); });
  gvd::web::bind_mesh();
  gvd::web::bind_curves();
  gvd::web::bind_diagram();
  gvd::web::bind_editor();
  gvd::web::bind_remesh();
  gvd::web::bind_scenes();
}
