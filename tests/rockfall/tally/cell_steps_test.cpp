#include "rockfall/tally/cell_steps.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/random/stream.hpp"

namespace rockfall::cell_steps_test {
namespace {

RC_GTEST_PROP(CellInside, HoldsOnlyPlacesFromWhichNoStepLeadsOut, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 0, 0, 0}, config::Purpose::test};
    const config::GridFrame frame{40,
                                  30,
                                  1e4 * stream.uniform(),
                                  1e4 * stream.uniform(),
                                  0.1 + 20.0 * stream.uniform(),
                                  0.1 + 20.0 * stream.uniform()};
    // Near a corner of cells, where places of several lie side by side.
    const double near = *rc::gen::element(1e-9, 1e-6, 1e-3, 1.0);
    const auto drawn = [&] {
        const double column = 20.0 + near * (stream.uniform() - 0.5);
        const double row = 15.0 + near * (stream.uniform() - 0.5);
        return std::pair{frame.x_west_m + column * frame.cell_width_m,
                         frame.y_south_m + row * frame.cell_height_m};
    };
    const auto [x_m, y_m] = drawn();
    const auto [x_end_m, y_end_m] = drawn();
    const config::Cell cell = frame.cell_at(x_m, y_m);
    const CellInside inside{frame, cell};
    if (inside.has(x_m, y_m) && inside.has(x_end_m, y_end_m)) {
        const CellSteps steps{frame, x_m, y_m, x_end_m - x_m, y_end_m - y_m};
        RC_ASSERT(steps.cell() == cell);
        RC_ASSERT(steps.end() > 1.0);
    }
    RC_ASSERT(inside.has(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)));
}

TEST(CellInside, OfNoCellHasNothing) {
    EXPECT_FALSE(CellInside{}.has(0.0, 0.0));
}

}  // namespace
}  // namespace rockfall::cell_steps_test
