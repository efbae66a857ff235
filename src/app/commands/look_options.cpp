// The option that draws a cloth as lines or as a surface, and the picture that its scene puts on it.
#include <array>
#include <string>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "gfx/picture.h"

namespace tyg {

void addLookOption(Command& command, LookOptions& options) {
  command
      .option("--look,--show", options.show,
              "The cloth as lines, as a lit surface, or as both [the scene's, else lines]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"lines", "surface", "both"});
      })
      .typeName("lines|surface|both");
}

std::optional<Show> chosenShow(const LookOptions& options, const Scene& scene) {
  std::optional<Show> show;
  if (options.show)
    show = *options.show == "lines" ? Show::Lines : *options.show == "both" ? Show::Both : Show::Surface;
  if (!scene.look.image.empty()) (void)readPicture(scene.look.image);
  return show;
}

}  // namespace tyg
