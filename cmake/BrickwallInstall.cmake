# cmake --install: the command, the libraries with their headers, the rigs, and what find_package(brickwall) needs.
include(CMakePackageConfigHelpers)

get_property(parts GLOBAL PROPERTY brickwall_parts)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/brickwall)
install(TARGETS ${parts} EXPORT BrickwallTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS brickwall RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY core channels DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/brickwall FILES_MATCHING PATTERN "*.h")
if(BRICKWALL_PLUGIN)
  install(DIRECTORY plugin DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/brickwall FILES_MATCHING PATTERN "*.h"
          PATTERN osgdb EXCLUDE)
endif()
install(DIRECTORY config DESTINATION ${CMAKE_INSTALL_DATADIR}/brickwall)
install(EXPORT BrickwallTargets NAMESPACE brickwall:: DESTINATION ${config_folder})
configure_package_config_file(cmake/BrickwallConfig.cmake.in ${CMAKE_BINARY_DIR}/brickwallConfig.cmake
                              INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/brickwallConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/brickwallConfig.cmake ${CMAKE_BINARY_DIR}/brickwallConfigVersion.cmake
              cmake/BrickwallDependencies.cmake DESTINATION ${config_folder})
