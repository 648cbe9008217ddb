# Installs the build tree BUILD_DIR into a new prefix under WORK_DIR. Then configures, builds and runs this folder's project
# against it, and the installed examples, these by pkg-config too. Given: BUILD_DIR, WORK_DIR, GENERATOR, CXX_COMPILER, PARTS
# (separated by commas), MESH, C_COMPILER.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${what} failed")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run("install" ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run("configure" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK_DIR}/build -G ${GENERATOR}
  -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DPARTS=${PARTS})
run("build" ${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run("the program" ${WORK_DIR}/build/consumer)

set(examples ${WORK_DIR}/prefix/share/doc/gvd/examples)
run("configure the examples" ${CMAKE_COMMAND} -S ${examples} -B ${WORK_DIR}/examples -G ${GENERATOR}
  -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run("build the examples" ${CMAKE_COMMAND} --build ${WORK_DIR}/examples)
run("an example" ${WORK_DIR}/examples/diagram_of_a_mesh ${MESH})
run("the example in C" ${WORK_DIR}/examples/path_of_a_mesh ${MESH} 0 5)

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${WORK_DIR}/prefix/*/gvd.pc)
  get_filename_component(folder ${pc} DIRECTORY)
  function(run_by_pkg_config package compiler source)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${PKG_CONFIG} --cflags --libs ${package}
                    OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY OUTPUT_STRIP_TRAILING_WHITESPACE)
    separate_arguments(flags)
    run("compile by ${package}.pc" ${compiler} -o ${WORK_DIR}/by_${package} ${examples}/${source} ${flags})
    run("the example of ${package}.pc" ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${folder}/.. ${WORK_DIR}/by_${package} ${ARGN})
  endfunction()
  run_by_pkg_config(gvd ${CXX_COMPILER} diagram_of_a_mesh.cpp ${MESH})
  run_by_pkg_config(gvd_c ${C_COMPILER} path_of_a_mesh.c ${MESH} 0 5)
endif()
