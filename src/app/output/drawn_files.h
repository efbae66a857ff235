// The files of a drawn study in one folder: checked before anything is computed, drawn by gnuplot where it is there.
// Must not know: what is drawn.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>

namespace tyg {

/// Throws InputError where these files could not be written to the folder, or the folder could not be made: to be
/// called before anything is computed. Leaves no trace.
void checkFolder(const std::filesystem::path& name, std::span<const std::string> files);
/// The folder, made where it is missing; each of these files in it can then be written. Throws InputError.
std::filesystem::path preparedFolder(const std::filesystem::path& name, std::span<const std::string> files);

/// Runs the script STEM.gp in `folder`, which draws what is in `rows`, and keeps STEM.svg and STEM.png when both are
/// whole. Says on standard error, as `command`, what went wrong, on standard output how to draw where gnuplot is
/// missing. Returns an exit code.
int drawFiles(const std::string& command, const std::filesystem::path& folder, const std::string& stem,
              const std::string& rows);
/// The same, where standard output belongs to something else: names and advice go to `said`.
int drawFiles(const std::string& command, const std::filesystem::path& folder, const std::string& stem,
              const std::string& rows, std::ostream& said);

}  // namespace tyg
