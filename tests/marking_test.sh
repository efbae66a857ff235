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
# A step past the limit, with every step until the numbers end.
"$work/curtain" 0.003125 20 640 >"$work/above.csv" && fail "the curtain does not explode at 3.125 ms"
mark above curtain 1% 1 "those of symplectic Euler at 3.12 ms" "The program is right, but its step is longer than 2.79 ms"

# The answers to the exercises.
program=$source/examples/marking/exercises.py
exercise() { "$python" "$program" "${@:2}" >"$work/$1.csv"; }
exercise figure symplectic-euler 0.005
mark figure four-particles 1% 0 "those of symplectic Euler at 5 ms: they agree"
exercise order rk4 0.02
mark order four-particles 1mm 0 "those of the classical Runge-Kutta method at 20 ms: they agree"
exercise axial leapfrog 0.01 axial
mark axial four-particles 1% 1 "leapfrog at 10 ms with axial instead of relative damping"
exercise undamped explicit-euler 0.01 none
mark undamped four-particles 1% 1 "explicit Euler at 10 ms without the springs' damping"
exercise energy leapfrog 0.01 none energy
awk -F, 'NR > 1 && ($5 < -0.9175 || $5 > -0.9165) { exit 1 }' "$work/energy.csv" || fail "leapfrog does not keep the energy"

# spoilt NAME FROM TO WORDS: an answer with a mistake put in, as docs/teaching.md suggests.
spoilt() {
  sed "s/$2/$3/" "$program" >"$work/$1.py"
  cmp -s "$program" "$work/$1.py" && fail "$1: nothing to spoil"
  "$python" "$work/$1.py" leapfrog 0.01 >"$work/$1.csv"
  mark "$1" four-particles 1% 1 "$4"
}
spoilt one_sided 'force\[j\]\[k\] -= f' 'force[j][k] -= 0 * f' "each spring applied to one end only"
spoilt short 'DIAGONAL = SPACING \* 2\*\*0.5' 'DIAGONAL = SPACING' "shear rest length equal to the spacing"
spoilt falling 'i in PINNED' 'i in ()' "pins left out"

# Without Tyg.
"$tyg" reference four-particles --samples 40 --out "$work/reference.csv" >"$work/said"
"$python" "$source/examples/marking/compare.py" "$work/figure.csv" "$work/reference.csv" | tail -n 1 | grep -q "^largest: 0.0017" ||
  fail "compare.py finds another error than the check"
