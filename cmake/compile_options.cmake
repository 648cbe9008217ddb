# Compile options of every target of the project.
add_library(gvd_compile_options INTERFACE)
target_compile_options(gvd_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # The same input gives the same bytes on every machine, so no implicit fused multiply-add.
  -ffp-contract=off -fno-math-errno
  # Position-independent code inlines as other code does: no function is replaced by one of another library.
  -fno-semantic-interposition)
if(GVD_WARNINGS_AS_ERRORS)
  target_compile_options(gvd_compile_options INTERFACE -Werror)
endif()
if(GVD_SANITIZE)
  target_compile_options(gvd_compile_options INTERFACE
    -fsanitize=${GVD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(gvd_compile_options INTERFACE -fsanitize=${GVD_SANITIZE})
endif()
