// A program that computes in float.

#define real float
#define real2 vec2
#define real3 vec3
#define TINY 1e-30         // keeps a division by a length of 0 from being one by 0
#define WHOLE 12582912.0   // 1.5 over epsilon
