# Everything that Debian 12 provides (scripts/packages). Also installed, for find_package(brickwall): static libraries hand
# what they link on to whoever links them.
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(embree 3 REQUIRED)
find_package(pugixml REQUIRED)
find_package(muparser REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(hwy REQUIRED QUIET IMPORTED_TARGET libhwy)
pkg_check_modules(hdf5 REQUIRED QUIET IMPORTED_TARGET hdf5)
pkg_check_modules(tinyobjloader REQUIRED QUIET IMPORTED_TARGET tinyobjloader)
pkg_check_modules(openexr REQUIRED QUIET IMPORTED_TARGET OpenEXR)
if(NOT TARGET brickwall::openvdb) # by hand: Debian's FindOpenVDB.cmake would ask for all that OpenVDB was built with
  find_package(Imath REQUIRED) # numbers of 16 bits
  find_path(BRICKWALL_OPENVDB_INCLUDE openvdb/openvdb.h REQUIRED)
  find_library(BRICKWALL_OPENVDB_LIBRARY openvdb REQUIRED)
  add_library(brickwall::openvdb INTERFACE IMPORTED)
  set_target_properties(brickwall::openvdb PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${BRICKWALL_OPENVDB_INCLUDE}"
    INTERFACE_INCLUDE_DIRECTORIES "${BRICKWALL_OPENVDB_INCLUDE}"
    INTERFACE_LINK_LIBRARIES "${BRICKWALL_OPENVDB_LIBRARY};TBB::tbb;Imath::Imath")
endif()
if(BRICKWALL_PLUGIN AND NOT TARGET brickwall::osg)
  find_package(OpenGL REQUIRED COMPONENTS OpenGL)
  find_package(X11 REQUIRED)
  find_package(OpenSceneGraph 3.6 REQUIRED COMPONENTS osgGA osgText osgViewer osgUtil osgDB)
  add_library(brickwall::osg INTERFACE IMPORTED)
  set_target_properties(brickwall::osg PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OPENSCENEGRAPH_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${OPENSCENEGRAPH_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${OPENSCENEGRAPH_LIBRARIES};OpenGL::GL;X11::X11")
endif()
