// Frames as time samples of one file in the text format of USD, with bodies as shapes.
// Must not know: how the cloth moves, options of the command line.
#pragma once

#include <filesystem>
#include <memory>

#include "app/output/exported_scene.h"

namespace tyg {

/// In metres with y up; the time code of a frame is its number. The first points of the cloth are its particles. Throws
/// InputError where the file cannot be written.
std::unique_ptr<ExportSink> openUsdFile(const std::filesystem::path& file);

}  // namespace tyg
