# A part is a folder: all its .cpp files make one library, brickwall_<name>, its headers are its interface.
# Sources are globbed so that a new file needs no line here; CONFIGURE_DEPENDS re-globs at each build.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# Headers are included as "brickwall/core/base/Box.h", in the source tree as after installation.
set(brickwall_includes ${CMAKE_BINARY_DIR}/include)
foreach(folder core channels plugin tests bench)
  file(MAKE_DIRECTORY ${brickwall_includes}/brickwall)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${folder} ${brickwall_includes}/brickwall/${folder} SYMBOLIC)
endforeach()

add_library(brickwall_options INTERFACE)
target_compile_options(brickwall_options INTERFACE -Wall -Wextra -Wpedantic)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(brickwall_options INTERFACE -Wno-restrict) # false alarms on std::string, GCC bug 105651
endif()
target_include_directories(brickwall_options INTERFACE $<BUILD_INTERFACE:${brickwall_includes}>)
if(BRICKWALL_SANITIZE)
  # GCC's uninitialised-use warnings are documented to be unreliable with sanitizers.
  target_compile_options(brickwall_options INTERFACE -fsanitize=${BRICKWALL_SANITIZE} -fno-omit-frame-pointer
                                                     -fno-sanitize-recover=all
                                                     $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(brickwall_options INTERFACE -fsanitize=${BRICKWALL_SANITIZE})
  if(BRICKWALL_SANITIZE MATCHES "undefined")
    # What these two find the address sanitizer finds, and the lanes' kernels take five times as long to compile with them.
    target_compile_options(brickwall_options INTERFACE -fno-sanitize=object-size,pointer-overflow)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang) # what libraries have in headers is theirs to test, and doubles the time to compile
    target_compile_options(brickwall_options INTERFACE -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitize-ignore.txt)
  endif()
endif()

# brickwall_part(NAME [PUBLIC targets that its headers need] [PRIVATE targets that only its sources need])
function(brickwall_part name)
  cmake_parse_arguments(PART "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(brickwall_${name} STATIC ${sources})
  add_library(brickwall::${name} ALIAS brickwall_${name})
  set_target_properties(brickwall_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(brickwall_${name} PUBLIC cxx_std_20)
  target_link_libraries(brickwall_${name} PUBLIC ${PART_PUBLIC} PRIVATE ${PART_PRIVATE} $<BUILD_INTERFACE:brickwall_options>)
  target_include_directories(brickwall_${name} PUBLIC $<BUILD_INTERFACE:${brickwall_includes}>
                                                      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(BRICKWALL_PRECOMPILE)
    target_precompile_headers(brickwall_${name} PRIVATE <algorithm> <cmath> <filesystem> <functional> <map> <memory> <span> <string>
                                                        <vector> <fmt/format.h> <brickwall/core/base/Box.h>)
  endif()
  set_property(GLOBAL APPEND PROPERTY brickwall_parts brickwall_${name})
endfunction()
