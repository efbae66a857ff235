// The normal of each particle of a sheet without cuts: the sum of the areas of the cells around it, as vectors. It is
// written into a buffer, and nothing is drawn. It is the one that the processor would find, to the last bit.
#version 430 core

uniform samplerBuffer positions;  // x, y, z of each particle in three texels, m
uniform int columns;
uniform int rows;
uniform float scale;              // of lengths: of areas only what they are beside each other counts

precise out vec3 normal;          // of any length

vec3 at(int particle) {
  int i = 3 * particle;
  return vec3(texelFetch(positions, i).r, texelFetch(positions, i + 1).r, texelFetch(positions, i + 2).r);
}

void main() {
  int column = gl_VertexID % columns, row = gl_VertexID / columns;
  normal = vec3(0);
  for (int below = max(row, 1); below <= min(row + 1, rows - 1); ++below) {
    for (int right = max(column, 1); right <= min(column + 1, columns - 1); ++right) {
      int last = below * columns + right, first = last - columns - 1;
      vec3 falling = scale * (at(last) - at(first)), rising = scale * (at(last - 1) - at(first + 1));
      normal += falling.yzx * rising.zxy - rising.yzx * falling.zxy;  // cross() might fuse some of it
    }
  }
}
