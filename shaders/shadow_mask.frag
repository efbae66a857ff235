// Where the floor lies in a shadow. What is below the floor throws none.
#version 330 core

in float height;
out vec4 painted;

void main() {
  if (height < 0.0) discard;
  painted = vec4(1);
}
