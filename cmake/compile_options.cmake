# Compile options of every target of the project.
add_library(gvd_compile_options INTERFACE)
target_compile_options(gvd_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # The same input gives the same bytes on every machine, so no implicit fused multiply-add.
  -ffp-contract=off)
if(GVD_WARNINGS_AS_ERRORS)
  target_compile_options(gvd_compile_options INTERFACE -Werror)
endif()
if(GVD_SANITIZE)
  target_compile_options(gvd_compile_options INTERFACE
    -fsanitize=${GVD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gvd_compile_options INTERFACE -fsanitize=${GVD_SANITIZE})
endif()

# gvd_compile_fast(TARGETS...): no optimisation under sanitizers. The templates of Catch2 and CLI11 then compile in 40 % of the
# time (docs/notes/build-time.md). For sources that leave the long work to the libraries.
function(gvd_compile_fast)
  if(GVD_SANITIZE)
    foreach(target ${ARGN})
      target_compile_options(${target} PRIVATE -O0)
    endforeach()
  endif()
endfunction()
