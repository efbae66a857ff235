#!/usr/bin/env bash
# The house rules that a machine can hold: every source file opens with a comment, none is longer than 450 lines, nothing
# is left to be done, and the project's words are used. Proves first that it can fail.
#   tests/house_rules_test.sh SOURCE_DIR
set -euo pipefail

longest=450
unfinished='(^|[^[:alnum:]])(TODO|FIXME|XXX|HACK)([^[:alnum:]]|$)'
# A particle is a particle everywhere; `vertex` belongs to OpenGL.
foreign='(^|[^[:alnum:]_])(nodes?|solvers?)([^[:alnum:]_]|$)'

breaches() {
  local root=$1 path
  (cd "$root" && find include src shaders tests -type f '(' -name '*.h' -o -name '*.cpp' -o -name '*.vert' -o -name '*.frag' \
    -o -name '*.geom' -o -name '*.glsl' ')' | sort) | while IFS= read -r path; do
    if ! head -n 2 "$root/$path" | grep -q '^//'; then echo "$path: does not open with a comment"; fi
    if (($(wc -l <"$root/$path") > longest)); then echo "$path: more than $longest lines"; fi
    grep -nE "$unfinished" "$root/$path" | sed "s,^,$path: unfinished: line ," || true
    if [[ $path != tests/* ]]; then
      sed -nE 's,"[^"]*",,g; s,.*(//.*),\1,p' "$root/$path" | grep -iE "$foreign" | sed "s,^,$path: not a word of this project: ," || true
    fi
  done
}

planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
mkdir -p "$planted"/{include,src/core,shaders,tests}
must_find() {
  if ! breaches "$planted" | grep -q "$1"; then echo "not noticed: $1" && exit 1; fi
}
echo 'int x;' >"$planted/src/core/a.cpp" && must_find "does not open"
{ echo '// What for.' && yes 'int x;' | head -n 450; } >"$planted/src/core/a.cpp" && must_find "more than"
printf '// What for.\nint x;  // TO%s later\n' DO >"$planted/src/core/a.cpp" && must_find "unfinished"
printf '// Every node of the sheet.\n' >"$planted/src/core/a.cpp" && must_find "not a word"
printf '// Every particle of the sheet.\nint x;\n' >"$planted/src/core/a.cpp"
if [[ -n $(breaches "$planted") ]]; then echo "wrongly refused: $(breaches "$planted")" && exit 1; fi

found=$(breaches "$1")
if [[ -n $found ]]; then
  echo "$found"
  exit 1
fi
