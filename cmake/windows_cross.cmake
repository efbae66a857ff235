# For building tyg.exe on Debian with MinGW-w64 (posix threads). `.ci/windows` makes the folder TYG_WINDOWS_PREFIX, in
# which all libraries are, and passes it on.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# GCC aligns no stack beyond 16 bytes on Windows (GCC bug 54412), and code for wider vectors would end at once.
set(flags "-Wa,-muse-unaligned-vector-move -D_WIN32_WINNT=0x0A00 -DNOMINMAX -DWIN32_LEAN_AND_MEAN")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s")

set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TYG_WINDOWS_PREFIX)
set(CMAKE_FIND_ROOT_PATH ${TYG_WINDOWS_PREFIX})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(ENV{PKG_CONFIG_LIBDIR} ${TYG_WINDOWS_PREFIX}/lib/pkgconfig)
# What is built here runs elsewhere.
set(CMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE PRE_TEST)
