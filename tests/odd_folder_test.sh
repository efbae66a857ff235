#!/usr/bin/env bash
# Tyg's scripts in a folder whose name has a space and a letter beyond ASCII: it is configured and what CMake generates is
# built there, and a sanitized program runs through the preset's ctest.
#   tests/odd_folder_test.sh SOURCE_DIR COMPILER
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
copy="$work/my tyg å"
mkdir "$copy"
tar -C "$1" --exclude=./build --exclude=./.git -c . | tar -C "$copy" -x
cd "$copy"

fail() { echo "$*" && exit 1; }
bash -c 'cd / && "$0/.ci/build" release tyg_glad' "$copy" || fail "cannot be built in '$copy'"
[[ -s build/release/libtyg_glad.a ]] || fail "nothing was built in '$copy'"

# A build folder by hand, with the least that the sanitizers can run: building Tyg with them takes minutes.
mkdir build/asan
echo 'int main() { delete new int; }' >build/asan/least.cpp
"$2" -fsanitize=address,undefined build/asan/least.cpp -o build/asan/least
echo "add_test(least [==[$copy/build/asan/least]==])" >build/asan/CTestTestfile.cmake
ctest --preset asan --no-tests=error || fail "a sanitized test fails in '$copy'"
