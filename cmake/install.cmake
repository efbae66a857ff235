# What `cmake --install` puts into a prefix: the program; and for programs that embed the simulator the public headers,
# the libraries up to integrators, and the package tyg, whose one target for them is tyg::tyg.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tyg)
install(TARGETS tyg RUNTIME)
install(TARGETS tyg_util tyg_core tyg_integrators EXPORT tyg ARCHIVE)
set_target_properties(tyg_integrators PROPERTIES EXPORT_NAME tyg)
install(DIRECTORY include/tyg DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT tyg NAMESPACE tyg:: FILE tygTargets.cmake DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tygConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/tygConfig.cmake ${PROJECT_BINARY_DIR}/tygConfigVersion.cmake DESTINATION ${package_dir})
