# How every target is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# A room's files need not wait until the libraries below it are complete; only linking must.
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)

if(MSVC)  # clang-cl too, which passes over the options below and then contracts a * b + c
  message(FATAL_ERROR "CMAKE_CXX_COMPILER: found ${CMAKE_CXX_COMPILER_ID} with Microsoft's options, allowed are g++ and clang++")
endif()

# -ffp-contract=off: the same bits from every compiler and vector width. -fno-math-errno, -fno-trapping-math: square
# roots and selections vectorise; neither changes a result.
add_library(tyg_settings INTERFACE)
target_compile_options(tyg_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of its own std::string (GCC bug 105651), of which it sees more where that comes precompiled.
  target_compile_options(tyg_settings INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(TYG_WERROR)
  target_compile_options(tyg_settings INTERFACE -Werror)
endif()
if(TYG_SANITIZE)
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC sees uninitialised values in what the sanitizers add
  add_compile_options(-fsanitize=${TYG_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TYG_SANITIZE})
endif()

if(TYG_FUZZ AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "TYG_FUZZ: found the compiler ${CMAKE_CXX_COMPILER_ID}, allowed is clang, which has libFuzzer")
endif()
if(TYG_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_compile_definitions(FMT_HEADER_ONLY)  # clang and GCC, which built the library, name some of its functions differently
endif()

# Standard headers are most of what there is to compile in a file, so they are compiled once: for the rooms that compute
# and for those that show something. Files still include what they use: it must build with
# CMAKE_DISABLE_PRECOMPILE_HEADERS=ON as well.
set(tyg_headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory> <optional> <span> <stdexcept> <string>
  <string_view> <utility> <vector> <fmt/core.h>)
function(tyg_precompile room)
  if(room STREQUAL util)
    target_precompile_headers(tyg_util PRIVATE ${tyg_headers})
  elseif(room STREQUAL view)
    target_precompile_headers(tyg_view PRIVATE ${tyg_headers} <filesystem> <glm/glm.hpp>)
  elseif(room MATCHES "core|integrators|study|gpu")
    target_precompile_headers(tyg_${room} REUSE_FROM tyg_util)
  else()
    target_precompile_headers(tyg_${room} REUSE_FROM tyg_view)
  endif()
endfunction()

# The folder of src/util that holds what another system needs.
set(other_system windows)
if(WIN32)
  set(other_system posix)
endif()

# A room: every source file in src/ROOM and its folders, plus generated ones.
function(tyg_library room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "row_kernel_level\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "/src/util/${other_system}/")
  add_library(tyg_${room} STATIC ${sources} ${ARGN})
  target_include_directories(tyg_${room} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include>)
  target_compile_features(tyg_${room} PUBLIC cxx_std_20)
  target_link_libraries(tyg_${room} PRIVATE $<BUILD_INTERFACE:tyg_settings>)
  tyg_precompile(${room})
endfunction()

# The force kernel is compiled once per precision and vector level from one source; the program picks at start-up.
function(tyg_row_kernels target)
  set(levels baseline)
  # With sanitizers these files take half a minute each; one level shows what there is to see.
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT TYG_SANITIZE)
    list(APPEND levels v3 v4)
    target_compile_definitions(${target} PRIVATE TYG_X86_LEVELS=1)
  endif()
  foreach(level IN LISTS levels)
    foreach(number IN ITEMS float double)
      set(object tyg_row_kernel_${level}_${number})
      add_library(${object} OBJECT src/core/forces/row_kernel_level.cpp)
      target_include_directories(${object} PRIVATE include src)
      target_link_libraries(${object} PRIVATE tyg_settings)
      target_compile_definitions(${object} PRIVATE TYG_LEVEL=${level} TYG_NUMBER=${number})
      if(NOT TYG_SANITIZE)
        target_compile_options(${object} PRIVATE -O3)
      endif()
      if(NOT level STREQUAL baseline)
        target_compile_options(${object} PRIVATE -march=x86-64-${level})
      endif()
      if(level STREQUAL v4)
        target_compile_options(${object} PRIVATE -mprefer-vector-width=512)
      endif()
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${object}>)
    endforeach()
  endforeach()
endfunction()
