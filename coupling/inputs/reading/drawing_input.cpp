#include "coupling/inputs/reading/drawing_input.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

using config::joined;

std::string listed_layers(const Undrawn& undrawn) {
    std::string names;
    for (const std::string& layer : undrawn.layers) {
        names += joined(names.empty() ? "" : ", ", layer);
    }
    return names;
}

}  // namespace

void note_drawing(Reading& reading) {
    const std::string& drawing = reading.run().drawing;
    if (drawing.empty()) {
        return;
    }
    static_cast<void>(reading.open("run.drawing", "drawing", drawing, "a GeoPackage to draw in"));
    static_cast<void>(reading.text_beside("drawing -wal", joined(drawing, "-wal")));
    const std::string file = reading.shown(drawing);
    for (const Undrawn& undrawn : reading.scenario().undrawn) {
        const std::string layers = listed_layers(undrawn);
        if (!undrawn.is_all) {
            reading.note(joined(file, ": nothing drawn yet in ", layers));
        } else if (undrawn.key == "release.source_shapes" && reading.release().steeper_than_deg > 0.0) {
            reading.note(joined(file, ": nothing drawn yet in ", layers, ": all cells steeper than ",
                                config::to_text(reading.release().steeper_than_deg), " degrees are sources"));
        } else {
            reading.note(joined(file, ": nothing drawn yet in ", layers, ": as without ", undrawn.key));
        }
    }
}

}  // namespace coupling
