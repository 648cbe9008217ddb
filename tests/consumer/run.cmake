# Installs the build tree BUILD_DIR into a new prefix under WORK_DIR, then configures, builds and runs this folder's
# project against it. Given: BUILD_DIR, WORK_DIR, GENERATOR, CXX_COMPILER, PARTS (separated by commas).
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
run("the program in C" ${WORK_DIR}/build/c_consumer ${CMAKE_CURRENT_LIST_DIR}/../../data/figure.obj 0 100)
