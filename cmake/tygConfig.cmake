# find_package(tyg) ends here: the libraries that Tyg's static ones need, then the target tyg::tyg.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(fmt)
find_dependency(tomlplusplus)
include(${CMAKE_CURRENT_LIST_DIR}/tygTargets.cmake)
