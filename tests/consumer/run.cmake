# cmake -DBUILD=<build folder> -DSOURCE=<this folder> -DGENERATOR=<generator> -P run.cmake
# Installs into a fresh prefix, then configures, builds and runs the consumer against it.
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})
foreach(step
        "--install;${BUILD};--prefix;${work}/prefix"
        "-S;${SOURCE};-B;${work}/build;-G;${GENERATOR};-DCMAKE_BUILD_TYPE=Release;-DCMAKE_PREFIX_PATH=${work}/prefix"
        "--build;${work}/build")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  if(result)
    message(FATAL_ERROR "cmake ${step} failed:\n${errors}")
  endif()
endforeach()
execute_process(COMMAND ${work}/build/consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${work}/prefix/bin/brickwall rig cave5 COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
if(EXISTS ${work}/build/node)
  execute_process(COMMAND ${work}/build/node COMMAND_ERROR_IS_FATAL ANY)
endif()
