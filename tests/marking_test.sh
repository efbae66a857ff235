#!/usr/bin/env bash
# The examples of docs/teaching.md, marked as a teacher would: right as they are, wrong with a mistake put in.
#   tests/marking_test.sh SOURCE_DIR TYG PYTHON COMPILER
set -euo pipefail

source=$1 tyg=$2 python=$3 compiler=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*" && exit 1; }

# NAME SCENE WITHIN EXIT_CODE WORDS...: checks $work/NAME.csv.
mark() {
  local name=$1 scene=$2 within=$3 code=0 expected=$4
  shift 4
  "$tyg" check "$scene" "$work/$name.csv" --within "$within" >"$work/said" || code=$?
  ((code == expected)) || fail "$name: exit code $code instead of $expected: $(cat "$work/said")"
  for words in "$@"; do
    tr -s ' \n' ' ' <"$work/said" | grep -qF -- "$words" || fail "$name: not said: $words: $(cat "$work/said")"
  done
}

program=$source/examples/marking/four_particles.py
"$python" "$program" >"$work/right.csv"
mark right four-particles 1mm 0 "those of leapfrog at 2 ms: they agree"
sed 's/force\[j\]\[k\] -= f/force[j][k] -= 0 * f/' "$program" >"$work/one_end.py"
"$python" "$work/one_end.py" >"$work/one_end.csv"
mark one_end four-particles 1mm 1 "each spring applied to one end only" "Apply each spring to both ends"

program=$source/examples/marking/curtain.cpp
"$compiler" -std=c++20 -O2 -Wall -Wextra -Werror "$program" -o "$work/curtain"
"$work/curtain" >"$work/curtain.csv"
mark curtain curtain 1% 0 "those of symplectic Euler at 1 ms: they agree"
sed 's/for (const Spring& s : springs) {/for (int twice = 0; twice < 2; ++twice) for (const Spring\& s : springs) {/' "$program" >"$work/twice.cpp"
"$compiler" -std=c++20 -O2 "$work/twice.cpp" -o "$work/twice"
"$work/twice" >"$work/twice.csv"
mark twice curtain 1% 1 "each spring applied twice" "Apply each spring once to each end"
