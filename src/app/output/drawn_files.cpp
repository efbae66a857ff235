// The folder and every file are tried before any work begins, and the folder is made when there are files. Pictures
// appear whole, or not at all where gnuplot fails or is interrupted.
#include "app/output/drawn_files.h"

#include <iostream>

#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "study/charts/gnuplot.h"
#include "tyg/scene.h"
#include "util/interrupt.h"
#include "util/visible_text.h"
#include "util/whole_picture.h"

namespace tyg {

namespace fs = std::filesystem;

namespace {

/// The folders of a path that are not there. Where they were made meanwhile, and are empty, they go when this goes.
class MissingFolders {
 public:
  explicit MissingFolders(fs::path path) {
    std::error_code none;
    const auto isMissing = [&] { return fs::symlink_status(path, none).type() == fs::file_type::not_found; };
    for (; !path.empty() && isMissing(); path = path.parent_path()) {
      paths_.push_back(path);
    }
  }
  ~MissingFolders() {
    std::error_code none;
    for (const fs::path& path : paths_) fs::remove(path, none);
  }
  MissingFolders(const MissingFolders&) = delete;
  MissingFolders& operator=(const MissingFolders&) = delete;

 private:
  std::vector<fs::path> paths_;  // the innermost first
};

}  // namespace

fs::path preparedFolder(const fs::path& name, std::span<const std::string> files) {
  std::error_code error;
  fs::create_directories(name, error);
  std::error_code none;
  if (!fs::is_directory(name, none)) {
    throw InputError("--out: found '" + name.string() + "', allowed is a folder that exists or can be made (" +
                     error.message() + ")");
  }
  for (const std::string& file : files) checkWritable(name / file);
  return name;
}

void checkFolder(const fs::path& name, std::span<const std::string> files) {
  const MissingFolders goneAgain(name);
  preparedFolder(name, files);
}

int drawFiles(const std::string& command, const fs::path& folder, const std::string& stem, const std::string& rows) {
  return drawFiles(command, folder, stem, rows, std::cout);
}

int drawFiles(const std::string& command, const fs::path& folder, const std::string& stem, const std::string& rows,
              std::ostream& said) {
  const std::string script = stem + ".gp";
  WholeFile svg(folder / (stem + ".svg")), png(folder / (stem + ".png"));
  const GnuplotOutcome outcome = runGnuplot(folder, script,
                                            {"svg=" + gnuplotQuoted(fs::absolute(svg.temporary()).string()),
                                             "png=" + gnuplotQuoted(fs::absolute(png.temporary()).string())});
  if (interrupted()) return sayInterrupted(command, "the pictures were not drawn");
  if (outcome.kind == GnuplotOutcome::Kind::Missing) {
    said << "gnuplot is not installed: " << (folder / rows).string() << " and " << (folder / script).string()
         << " are written;\nwith it, `cd " << shellWord(folder.string()) << " && gnuplot " << script << "` draws "
         << stem << ".svg and " << stem << ".png" << std::endl;
    return kDone;
  }
  if (outcome.kind == GnuplotOutcome::Kind::Failed) {
    std::cerr << command << ": gnuplot could not draw " << (folder / script).string() << ":\n"
              << outcome.message << "allowed is a gnuplot 5 with the terminals svg and pngcairo" << std::endl;
    return kWrongInput;
  }
  keepPictures({&svg, &png});
  for (const std::string& file : {rows, script, stem + ".svg", stem + ".png"}) {
    said << (folder / file).string() << "\n";
  }
  said << std::flush;
  return kDone;
}

}  // namespace tyg
