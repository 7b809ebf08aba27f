#include "coupling/assessments/hazard/hazard_colours.hpp"

namespace coupling::hazard {

const std::vector<ClassColour>& level_colours() {
    static const std::vector<ClassColour> colours{{0.0, level_name(Level::none), {0xff, 0xff, 0xff}},
                                                  {1.0, level_name(Level::residual), {0xfb, 0xf6, 0xc8}},
                                                  {2.0, level_name(Level::low), {0xff, 0xe0, 0x1a}},
                                                  {3.0, level_name(Level::moderate), {0x3d, 0x85, 0xc6}},
                                                  {4.0, level_name(Level::high), {0xc4, 0x1e, 0x24}}};
    return colours;
}

std::vector<ClassColour> intensity_colours(const Matrix& matrix) {
    std::vector<ClassColour> colours;
    const std::size_t count = matrix.intensities();
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i + 1) / static_cast<double>(count);
        colours.push_back({static_cast<double>(i + 1), matrix.intensity_name(i),
                           count == intensity_class_colours.size() ? intensity_class_colours[i]
                                                                   : colour_at(Palette::deposits, place)});
    }
    return colours;
}

}  // namespace coupling::hazard
