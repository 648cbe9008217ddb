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
  # Left out are checks that cost a third of the compile time, and find what the address sanitizer finds at the next access: null
  # pointers, pointers that run over, and objects that are too small or of another type. Alignment is checked where bytes of files
  # are read (gvd_guide_fuzzers).
  target_compile_options(gvd_compile_options INTERFACE
    -fsanitize=${GVD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -fno-sanitize=null,object-size,vptr,pointer-overflow,alignment)
  target_link_options(gvd_compile_options INTERFACE -fsanitize=${GVD_SANITIZE})
endif()
