# The C++ library as others link it: one archive of all folders, the public headers of include/ with what they include, a CMake package
# (layoutbox::layoutbox) and a pkg-config file. None of it names a folder of the machine that it was built on.
include(CMakePackageConfigHelpers)

set(folders base scene catalog chat sandbox publish plan solve furnish render export verify judge edit dress pipeline experiment)
list(TRANSFORM folders REPLACE "(.+)" "$<TARGET_OBJECTS:layoutbox_\\1>" OUTPUT_VARIABLE objects)
add_library(layoutbox_library STATIC ${objects})
set_target_properties(layoutbox_library PROPERTIES OUTPUT_NAME layoutbox EXPORT_NAME layoutbox LINKER_LANGUAGE CXX)
target_compile_features(layoutbox_library INTERFACE cxx_std_20)
target_include_directories(layoutbox_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(layoutbox_library INTERFACE fmt::fmt ZLIB::ZLIB meshoptimizer::meshoptimizer Threads::Threads ${CMAKE_DL_LIBS})
add_library(layoutbox::layoutbox ALIAS layoutbox_library)

# What the public headers include, and nothing else; tests/cli/test_install.py compiles against it.
set(included
    base/result.h base/units.h
    scene/layout.h scene/relation_list.inc scene/relation_parameters.h scene/relation_table.h scene/scene_graph.h scene/scene_json.h
    catalog/catalog.h catalog/normalize.h catalog/traits.h catalog/user_catalog.h
    plan/edit.h plan/planner.h
    solve/cp_sat_folder.h solve/solver.h
    furnish/furnish.h furnish/model.h
    render/render.h
    export/export.h export/formats.h
    verify/verify.h
    edit/edit.h
    pipeline/batch.h pipeline/batch_input.h pipeline/generate.h)
foreach(header IN LISTS included)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES src/layoutbox/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/layoutbox/${folder})
endforeach()
install(DIRECTORY include/layoutbox DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/layoutbox)
install(TARGETS layoutbox_library EXPORT layoutbox ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT layoutbox NAMESPACE layoutbox:: FILE layoutbox-targets.cmake DESTINATION ${package})
configure_package_config_file(cmake/layoutbox-config.cmake.in ${CMAKE_BINARY_DIR}/layoutbox-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/layoutbox-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/layoutbox-config.cmake ${CMAKE_BINARY_DIR}/layoutbox-config-version.cmake DESTINATION ${package})

# pkg-config finds the prefix from where the file stands.
file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/layoutbox.pc.in ${CMAKE_BINARY_DIR}/layoutbox.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/layoutbox.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
