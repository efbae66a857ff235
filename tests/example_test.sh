#!/usr/bin/env bash
# What an embedding program needs: Tyg is installed into a folder of its own, each public header is compiled alone from
# there, and examples/hello_cloth is configured, built and run against it.
#   tests/example_test.sh SOURCE_DIR BUILD_DIR CMAKE COMPILER
set -euo pipefail

source=$1 build=$2 cmake=$3 compiler=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*" && exit 1; }
quietly() { "$@" >"$work/said" 2>&1 || fail "$(cat "$work/said")" "failed: $*"; }

prefix="$work/the prefix"
quietly "$cmake" --install "$build" --prefix "$prefix"
"$prefix/bin/tyg" --version >/dev/null || fail "the installed program does not start"

headers=(input_error scene sheet method methods event_log energies simulation)
(($(find "$prefix/include" -type f | wc -l) == ${#headers[@]})) || fail "installed are other headers than ${headers[*]}"
for header in "${headers[@]}"; do
  echo "#include \"tyg/$header.h\"" >"$work/alone.cpp"
  quietly "$compiler" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I "$prefix/include" "$work/alone.cpp"
done
internal=$(grep -rniE 'worker|aligned|fused|"(core|util|integrators)/' "$prefix/include" || true)
[[ -z $internal ]] || fail "public headers speak of the inside: $internal"

quietly "$cmake" -S "$source/examples/hello_cloth" -B "$work/hello" "-DCMAKE_PREFIX_PATH=$prefix" \
  "-DCMAKE_CXX_COMPILER=$compiler" -DCMAKE_BUILD_TYPE=Debug
quietly "$cmake" --build "$work/hello"
"$work/hello/hello_cloth" >"$work/out" || fail "hello_cloth left with $?"
[[ $(head -n 1 "$work/out") == time_s,kinetic_J,elastic_J,gravitational_J,drift ]] || fail "$(cat "$work/out")"
(($(wc -l <"$work/out") == 12)) || fail "found other than a header, ten times and a status: $(cat "$work/out")"
awk -F, 'NR > 1 && NR < 12 && !($5 * $5 < 1e-8 && $2 > 0 && $4 < 0) { exit 1 }' "$work/out" ||
  fail "the energies are wrong: $(cat "$work/out")"
[[ $(tail -n 1 "$work/out") == "status ok, hash dd885031fb260491" ]] || fail "other bits: $(tail -n 1 "$work/out")"
