#!/usr/bin/env bash
# The rooms' arrows, read from the includes: core <- integrators <- study <- app and core <- view <- gfx <- app.
# Also: OpenGL and window headers only in gfx and app; below app nothing prints or reads a clock.
# First it proves that it can fail: each planted wrong line below must be found.
#   tests/include_arrows_test.sh SOURCE_DIR
set -euo pipefail
source_dir=$1

declare -A may_include=(
  [core]="core"
  [integrators]="core integrators"
  [study]="core integrators study"
  [view]="core view"
  [gfx]="core view gfx"
  [app]="core integrators study view gfx app"
)
drawing='^(glad/|GLFW/|GL/|GLES|EGL/|X11/|imgui)'
outside_world='^(chrono|ctime|time\.h|sys/time\.h|iostream)$'
printing='(^|[^[:alnum:]_])((printf|puts|putchar|perror|clock_gettime|gettimeofday)[[:space:]]*\(|stdout|stderr|(std::)(cout|cerr|clog))'

# The room of a path below SOURCE_DIR, or of what an #include "..." names.
room_of() {
  case $1 in
    include/tyg/methods.h | tyg/methods.h) echo integrators ;;
    include/tyg/* | tyg/*) echo core ;;
    src/main.cpp) echo app ;;
    src/*/*) cut -d/ -f2 <<<"$1" ;;
    */*) cut -d/ -f1 <<<"$1" ;;
    *) echo none ;;
  esac
}

# Prints one line for every breach in the file ROOT/PATH.
breaches() {
  local root=$1 path=$2 room header target
  room=$(room_of "$path")
  if [[ -z ${may_include[$room]:-} ]]; then echo "$path: $room is no room of the house" && return; fi
  while IFS= read -r header; do
    target=$(room_of "$header")
    if [[ " ${may_include[$room]} " != *" $target "* ]]; then
      echo "$path: room $room includes \"$header\" of $target; allowed: ${may_include[$room]}"
    fi
  done < <(sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*"([^"]+)".*/\1/p' "$root/$path")
  while IFS= read -r header; do
    if [[ $room != gfx && $room != app && $header =~ $drawing ]]; then echo "$path: <$header> outside gfx and app"; fi
    if [[ $room != app && $header =~ $outside_world ]]; then echo "$path: <$header> below app"; fi
  done < <(sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*<([^>]+)>.*/\1/p' "$root/$path")
  if [[ $room != app ]]; then
    sed -E 's,//.*,,' "$root/$path" | grep -nE "$printing" | sed "s,^,$path: prints or reads a clock below app: line ," || true
  fi
}

check() {
  local root=$1 path
  (cd "$root" && find include src -name '*.h' -o -name '*.cpp' | sort) | while IFS= read -r path; do breaches "$root" "$path"; done
}

planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
# plant right|wrong PATH LINE
plant() {
  local expected=$1 path=$2 line=$3 found
  rm -rf "${planted:?}"/*
  mkdir -p "$planted/include" "$planted/src" "$(dirname "$planted/$path")"
  echo "$line" >"$planted/$path"
  found=$(check "$planted")
  if [[ $expected == wrong && -z $found ]]; then echo "not noticed in $path: $line" && exit 1; fi
  if [[ $expected == right && -n $found ]]; then echo "wrongly refused: $found" && exit 1; fi
}
plant wrong src/core/a.cpp '#include "integrators/rk4.h"'
plant wrong src/core/a.cpp '#include "tyg/methods.h"'
plant wrong include/tyg/a.h '  #  include "core/forces.h"  '$'\n''#include "app/commands/commands.h"'
plant wrong src/integrators/a.cpp '#include "study/row.h"'
plant wrong src/study/a.cpp '#include "view/camera.h"'
plant wrong src/view/a.cpp '#include "tyg/methods.h"'
plant wrong src/view/a.h '#include "gfx/renderer.h"'
plant wrong src/gfx/a.cpp '#include "ui/windows/window.h"'
plant wrong src/gfx/a.cpp '#include "study/row.h"'
plant wrong src/core/a.cpp '#include "sheet.h"'
plant wrong src/view/a.cpp '#include <glad/gl.h>'
plant wrong src/study/a.cpp '#include <GLFW/glfw3.h>'
plant wrong src/study/a.cpp '#include <chrono>'
plant wrong src/gfx/a.cpp '#include <iostream>'
plant wrong src/core/a.cpp 'void f() { std::printf("x"); }'
plant wrong src/view/a.cpp 'void f() { fprintf(stderr, "x"); }'
plant wrong src/cellar/a.cpp 'int x;'
plant right src/core/a.cpp '#include "tyg/sheet.h"'
plant right src/integrators/a.cpp '#include "tyg/methods.h"'
plant right src/gfx/a.cpp '#include <glad/gl.h>'
plant right src/app/a.cpp '#include <chrono>'$'\n''#include "study/row.h"'
plant right src/core/a.cpp 'void f() { std::snprintf(text, 9, "x"); }  // printf( to stderr'

found=$(check "$source_dir")
if [[ -n $found ]]; then
  echo "$found"
  exit 1
fi
