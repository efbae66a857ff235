// A program that computes in double.

#define real double
#define real2 dvec2
#define real3 dvec3
#define TINY 1e-300lf              // keeps a division by a length of 0 from being one by 0
#define WHOLE 6755399441055744.0lf  // 1.5 over epsilon
