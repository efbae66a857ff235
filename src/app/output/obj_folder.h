// Frames as numbered OBJ files in a folder, with the bodies as meshes.
// Must not know: how the cloth moves, options of the command line.
#pragma once

#include <filesystem>
#include <memory>

#include "app/output/exported_scene.h"

namespace tyg {

/// Files frame_00000.obj and on, in metres with y up. The cloth comes first, so that its particles have the numbers 1,
/// 2, ... in each of them. Throws InputError where the folder cannot be written.
std::unique_ptr<ExportSink> openObjFolder(const std::filesystem::path& folder);

}  // namespace tyg
