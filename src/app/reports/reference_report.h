// What `tyg reference` says about the motion that it has written, and how far that can be trusted.
// Must not know: options.
#pragma once

#include <string>

#include "study/motion/reference.h"

namespace tyg {

struct ReferenceReport {
  Scene scene;  ///< as it was asked for
  Reference reference;
  SampledMotion motion;  ///< as it was written
  std::string tears;     ///< why it ends before the scene does; mostly empty
  std::string file;
};

/// A few lines with units.
std::string referenceText(const ReferenceReport& report);
/// One JSON object; its keys and their order are what scripts rely on.
std::string referenceJson(const ReferenceReport& report);

}  // namespace tyg
