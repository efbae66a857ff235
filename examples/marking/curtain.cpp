// The scene curtain as a small program of one's own: symplectic Euler, the positions as CSV on standard output.
//   c++ -O2 curtain.cpp -o curtain && ./curtain >mine.csv && tyg check curtain mine.csv --within 1%
// ./curtain STEP SIDE ROWS takes other steps (s), the same cloth on SIDE x SIDE particles, and writes ROWS times (20).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

struct Vector {
  double x = 0, y = 0, z = 0;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
double length(Vector a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

struct Spring {
  int first, second;
  double ks, kd, rest;  // N/m, N s/m, m
};

int main(int argc, char** argv) {
  const int side = argc > 2 ? std::atoi(argv[2]) : 20, samples = argc > 3 ? std::atoi(argv[3]) : 20;
  const double duration = 2, h = argc > 1 ? std::atof(argv[1]) : 1e-3;              // s
  const double spacing = 1.9 / (side - 1), mass = 0.018 * 20 * 20 / (side * side);  // m, kg: 1.9 m and 7.2 kg in all
  const Vector gravity{0, -9.81, 0};

  std::vector<Vector> position, velocity(side * side), force(side * side);
  std::vector<Spring> springs;
  const auto join = [&](int c, int r, int toColumn, int toRow, double ks) {
    const int column = c + toColumn, row = r + toRow;
    if (column < 0 || column >= side || row >= side) return;
    springs.push_back({r * side + c, row * side + column, ks, 0.1, spacing * std::hypot(toColumn, toRow)});
  };
  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      position.push_back({(c - (side - 1) / 2.0) * spacing, 0, r * spacing});
      join(c, r, 1, 0, 1200), join(c, r, 0, 1, 1200);  // structural
      join(c, r, 1, 1, 900), join(c, r, -1, 1, 900);   // shear
      join(c, r, 2, 0, 200), join(c, r, 0, 2, 200);    // bend
    }
  }

  std::puts("t,particle,x,y,z");
  const int steps = int(std::lround(duration / h));
  for (int step = 1; step <= steps; ++step) {
    for (Vector& f : force) f = mass * gravity;
    for (const Spring& s : springs) {
      const Vector along = position[s.first] - position[s.second];
      const double now = length(along);
      const Vector f = (-s.ks * (now - s.rest) / now) * along - s.kd * (velocity[s.first] - velocity[s.second]);
      force[s.first] = force[s.first] + f;
      force[s.second] = force[s.second] - f;
    }
    for (int i = 0; i < side * side; ++i) {
      if (i == 0 || i == side - 1) continue;  // the two pinned corners
      velocity[i] = velocity[i] + (h / mass) * force[i];
      position[i] = position[i] + h * velocity[i];
    }
    if (step % (steps / samples) != 0) continue;
    for (const Vector& at : position) {
      if (!std::isfinite(at.x + at.y + at.z)) return 1;  // it has exploded: what it has written by now is a motion
    }
    for (int i = 0; i < side * side; ++i) {
      std::printf("%.9g,%d,%.17g,%.17g,%.17g\n", step * h, i, position[i].x, position[i].y, position[i].z);
    }
  }
}
