# What `cmake --install` puts into a prefix: the program with its manual page, completions, menu entry, scenes and
# documentation; and for programs that embed the simulator the public headers, the libraries up to integrators, and the
# package tyg, whose one target for them is tyg::tyg.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(TYG_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where zsh looks for completions, below the prefix")

install(TARGETS tyg RUNTIME)
install(DIRECTORY src/scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/tyg/scenes FILES_MATCHING PATTERN *.toml)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN *.sh EXCLUDE)
install(FILES packaging/tyg.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/tyg.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
foreach(size IN ITEMS 48 128 256)
  install(FILES packaging/tyg-${size}.png DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps RENAME tyg.png)
endforeach()

# Made from what the program says of itself, which takes a program that runs here.
if(NOT CMAKE_CROSSCOMPILING)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(documents ${PROJECT_BINARY_DIR}/documents)
  add_custom_command(
    OUTPUT ${documents}/tyg.1
    BYPRODUCTS ${documents}/tyg.bash ${documents}/_tyg ${documents}/tyg.fish
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packaging/documents.py $<TARGET_FILE:tyg> ${documents}
    DEPENDS tyg packaging/documents.py
    COMMENT "Making the manual page and the completions" VERBATIM)
  add_custom_target(documents ALL DEPENDS ${documents}/tyg.1)
  install(FILES ${documents}/tyg.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${documents}/tyg.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME tyg)
  install(FILES ${documents}/_tyg DESTINATION ${TYG_ZSH_DIR})
  install(FILES ${documents}/tyg.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tyg)
install(TARGETS tyg_util tyg_core tyg_integrators EXPORT tyg ARCHIVE)
set_target_properties(tyg_integrators PROPERTIES EXPORT_NAME tyg)
install(DIRECTORY include/tyg DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT tyg NAMESPACE tyg:: FILE tygTargets.cmake DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tygConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/tygConfig.cmake ${PROJECT_BINARY_DIR}/tygConfigVersion.cmake DESTINATION ${package_dir})

# `cpack` in the build folder makes a package for Debian, whose needs are read from what the program is linked with.
# OSMesa is opened when it is first wanted, and the rest are other programs, so that nothing is linked with them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tyg)
set(CPACK_PACKAGE_CONTACT "The authors of Tyg <tyg@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, gnuplot-nox, ffmpeg")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libfmt-dev, libtomlplusplus-dev")
include(CPack)
