# Builds the page of --view from web/ and embeds it into a target as data. So a program needs no file at run time.
#
#   GVD_WITH_VIEWER  ON if npm is found. OFF: gvd::make_view_page throws, everything else works.
#   GVD_VIEWER_PAGE  a page that was built elsewhere (BUILD/viewer/viewer.html). The build then needs neither npm nor network.
#
# Run as a script (cmake -DPAGE=... -DSOURCE=... -P embed_viewer.cmake) it turns a page into a C++ source.

# An array of bytes, because compilers need not accept a string literal of this length.
function(gvd_write_template_source page source)
  set(bytes "")
  if(page)
    file(READ ${page} hex HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
  endif()
  string(CONCAT text
    "#include \"io/view/view_template.hpp\"\n\n"
    "namespace gvd::io {\nnamespace {\nconstexpr char kPage[] = {\n${bytes}'\\0'};\n}  // namespace\n\n"
    "std::string_view view_template() { return {kPage, sizeof(kPage) - 1}; }\n\n}  // namespace gvd::io\n")
  file(WRITE ${source}.new "${text}")
  execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${source}.new ${source} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${source}.new)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  gvd_write_template_source(${PAGE} ${SOURCE})
  return()
endif()

find_program(GVD_NPM npm)
find_program(GVD_NODE NAMES node nodejs)
set(GVD_VIEWER_PAGE "" CACHE FILEPATH "A page built elsewhere, to embed in place of building web/")
if((GVD_NPM AND GVD_NODE) OR GVD_VIEWER_PAGE)
  set(gvd_viewer_default ON)
else()
  set(gvd_viewer_default OFF)
endif()
option(GVD_WITH_VIEWER "Build the page of --view into the library (needs npm)" ${gvd_viewer_default})

# gvd_build_viewer_page(PAGE_VARIABLE): adds rules that bundle web/ into one file in the build tree. The sources are
# copied, so that npm installs nothing into the source tree.
function(gvd_build_viewer_page page_variable)
  if(NOT GVD_NPM OR NOT GVD_NODE)
    message(FATAL_ERROR "GVD_WITH_VIEWER is ON and there is no npm: install it (apt-get install npm), give "
                        "GVD_VIEWER_PAGE, or set GVD_WITH_VIEWER=OFF")
  endif()
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(work ${PROJECT_BINARY_DIR}/viewer)
  file(GLOB sources CONFIGURE_DEPENDS ${web}/src/*)
  set(modules ${work}/node_modules/.package-lock.json)
  add_custom_command(OUTPUT ${modules}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${work}
    COMMAND ${CMAKE_COMMAND} -E copy ${web}/package.json ${web}/package-lock.json ${web}/.npmrc ${work}
    COMMAND ${GVD_NPM} ci --loglevel=error --no-update-notifier
    COMMAND ${CMAKE_COMMAND} -E touch ${modules}
    DEPENDS ${web}/package.json ${web}/package-lock.json ${web}/.npmrc
    WORKING_DIRECTORY ${work}
    COMMENT "Fetching the viewer's packages (GVD_WITH_VIEWER=OFF builds without them)" VERBATIM)
  add_custom_command(OUTPUT ${work}/viewer.html
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${web}/src ${work}/src
    COMMAND ${CMAKE_COMMAND} -E copy ${web}/build.mjs ${web}/bundle.mjs ${work}
    COMMAND ${GVD_NODE} build.mjs viewer.html
    DEPENDS ${modules} ${sources} ${web}/build.mjs ${web}/bundle.mjs
    WORKING_DIRECTORY ${work} COMMENT "Bundling the viewer" VERBATIM)
  set(${page_variable} ${work}/viewer.html PARENT_SCOPE)
endfunction()

# gvd_embed_viewer(TARGET): adds io::view_template() to the target.
function(gvd_embed_viewer target)
  set(source ${PROJECT_BINARY_DIR}/viewer/view_template.cpp)
  if(NOT GVD_WITH_VIEWER)
    message(STATUS "Building without the viewer: --view will be refused")
    gvd_write_template_source("" ${source})
  else()
    set(page ${GVD_VIEWER_PAGE})
    if(NOT page)
      gvd_build_viewer_page(page)
    endif()
    set(script ${PROJECT_SOURCE_DIR}/cmake/embed_viewer.cmake)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DPAGE=${page} -DSOURCE=${source} -P ${script}
      COMMAND ${CMAKE_COMMAND} -E touch ${source}
      DEPENDS ${page} ${script} COMMENT "Embedding the viewer" VERBATIM)
  endif()
  target_sources(${target} PRIVATE ${source})
endfunction()
