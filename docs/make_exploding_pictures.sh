#!/usr/bin/env bash
# Makes the pictures of docs/exploding.md, one for each cause: ./docs/make_exploding_pictures.sh [path of tyg]
# gnuplot draws four of them from what the program and the examples for marking print; the program renders the other one.
# Needs gnuplot, ffmpeg, Python and a C++ compiler.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tyg=$(readlink -f "${1:-$here/../build/release/tyg}")
pictures=$here/pictures examples=$here/../examples/marking
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# chart NAME: draws what gnuplot's statements on standard input say.
chart() {
  cat - >chart.gp
  gnuplot -d -e "set terminal pngcairo size 960,400 enhanced background '#ffffff' font 'DejaVu Sans,13';
    set output 'chart.png'; set datafile separator comma; set grid lc '#d8d8d8';
    set border lc '#888888'; set key outside right center Left reverse spacing 1.3; set lmargin 11;
    blue = '#0072b2'; orange = '#d55e00'; green = '#009e73'; purple = '#cc79a7'" chart.gp
  mv chart.png "$pictures/exploding-$1.png"
}

# The step: the kinetic energy below the limit, a little past it, and far past it. Four steps a row.
energies() { awk -F, -v m="$1" 'NR > 1 { e[$1] += m * ($6^2 + $7^2 + $8^2) / 2 } END { for (t in e) if (e[t] < 1e12) print t "," e[t] }' | sort -g; }
for step in 2.5 2.7 3; do
  "$tyg" run curtain --integrator leapfrog --dt "${step}ms" --duration "$(awk "BEGIN { print 0.6 * $step }")" \
    --samples 150 --keep-going --out run.csv >/dev/null 2>&1 || true
  energies 0.018 <run.csv >"step-$step.csv"
done
chart step <<'END'
set xlabel 'time (s)'; set ylabel 'kinetic energy (J)'; set logscale y; set format y '10^{%T}'
set xrange [0:1.5]; set yrange [1e-2:1e8]
plot 'step-3.csv' with lines lw 2.5 lc rgb orange title '3 ms', \
  'step-2.7.csv' with lines lw 2.5 lc rgb purple title '2.7 ms', \
  'step-2.5.csv' with lines lw 2.5 lc rgb blue title '2.5 ms'
END

# Explicit Euler: the sum of the energies without damping, which should stay what it is.
python=$examples/exercises.py
python3 "$python" explicit-euler 0.01 none energy >explicit-10.csv
python3 "$python" explicit-euler 0.001 none energy >explicit-1.csv
python3 "$python" symplectic-euler 0.01 none energy >symplectic-10.csv
chart explicit-euler <<'END'
set xlabel 'time (s)'; set ylabel 'sum of energies (J)'; set xrange [0:8]; set yrange [-1:2]
plot 'explicit-10.csv' skip 1 using 1:5 with lines lw 2.5 lc rgb orange title 'explicit Euler, 10 ms', \
  'explicit-1.csv' skip 1 using 1:5 with lines lw 2.5 lc rgb purple title 'explicit Euler, 1 ms', \
  'symplectic-10.csv' skip 1 using 1:5 with lines lw 2.5 lc rgb blue title 'symplectic Euler, 10 ms'
END

# Damping: the largest stable step against the damping of all springs.
methods=symplectic-euler,leapfrog,rk4,rkc2,imex
for kd in 0.1 0.2 0.3 0.5 0.7 1 2 3 5 7 10 20 30 50 70 100; do
  "$tyg" limit --ks 1200,900,200 --kd "$kd" --mass 18g --methods "$methods" --json |
    python3 -c 'import json, sys; print(sys.argv[1], *(m["stable_dt"] * 1e3 for m in json.load(sys.stdin)["methods"]), sep=",")' "$kd"
done >limits.csv
chart damping <<'END'
set xlabel 'damping of every spring, kd (N s/m)'; set ylabel 'largest stable step (ms)'
set logscale xy; set xrange [0.1:100]; set yrange [0.01:1000]; set format '%g'
names = "symplectic-euler leapfrog rk4 rkc2 imex"; colours = "#d55e00 #cc79a7 #0072b2 #009e73 #56b4e9"
plot for [k=1:5] 'limits.csv' using 1:(column(k + 1)) with lines lw 2.5 lc rgb word(colours, k) title word(names, k)
END

# The grid: the same cloth on a finer grid, and the one with particles as heavy as before.
"$tyg" render curtain --sheet 77x77 --dt 0.3ms --at 0.7 --size 480x400 --out fine.png >/dev/null
"$tyg" render fail-refined --dt 0.3ms --at 0.7 --size 480x400 --out heavy.png >/dev/null
ffmpeg -loglevel error -y -i fine.png -i heavy.png -filter_complex hstack "$pictures/exploding-grid.png"

# A mistake in the forces: halving the step halves the error of the right program alone.
c++ -O2 "$examples/curtain.cpp" -o right
sed 's/for (const Spring& s : springs) {/for (int twice = 0; twice < 2; ++twice) for (const Spring\& s : springs) {/' \
  "$examples/curtain.cpp" >twice.cpp
c++ -O2 twice.cpp -o wrong
for program in right wrong; do
  for step in 0.001 0.0005; do
    "./$program" "$step" >mine.csv
    "$tyg" check curtain mine.csv --out marked >/dev/null
    mv marked/check.csv "$program-$step.csv"
  done
done
chart mistake <<'END'
set xlabel 'time (s)'; set ylabel 'error (m)'; set logscale y; set format y '10^{%T}'; set xrange [0:2]; set yrange [1e-4:10]
plot 'wrong-0.001.csv' skip 1 using 1:2 with lines lw 3 lc rgb orange title 'springs twice, 1 ms', \
  'wrong-0.0005.csv' skip 1 using 1:2 with lines lw 2 dt 2 lc rgb 'black' title 'springs twice, 0.5 ms', \
  'right-0.001.csv' skip 1 using 1:2 with lines lw 3 lc rgb blue title 'right, 1 ms', \
  'right-0.0005.csv' skip 1 using 1:2 with lines lw 3 dt 2 lc rgb blue title 'right, 0.5 ms'
END
