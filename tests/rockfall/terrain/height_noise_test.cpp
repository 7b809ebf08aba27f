#include "rockfall/terrain/height_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "tests/rockfall/slopes.hpp"
#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::height_noise_test {
namespace {

using testing::heights_of;

std::vector<Eigen::Vector3d> points_of(const config::Raster<double>& heights) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        points.emplace_back(heights.frame.x_centre_m(cell.column), heights.frame.y_centre_m(cell.row),
                            heights.values[i]);
    }
    return points;
}

/// Noise by the number of the cell.
double noise_of_cell(std::size_t cell) {
    const config::RandomStream stream{{31, 0, 0, cell}, config::Purpose::test};
    return config::normal(stream.uniforms_of(0)[0], 0.0, 1.0);
}

/// A slope of 38 degrees with a hollow across it and a crooked wall of 20 m.
double curved_m(double x_m, double y_m) {
    const double wall_m = x_m > 60.0 + 0.3 * y_m ? -20.0 : 0.0;
    return wall_m - 0.78 * x_m + 8.0 * std::sin(0.05 * x_m) * std::cos(0.04 * y_m);
}

config::Raster<double> noisy(const config::GridFrame& frame, double left_m, double right_m) {
    config::Raster<double> heights = heights_of(frame, curved_m);
    const int middle = frame.columns / 2;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        heights.values[i] += (frame.cell_of(i).column < middle ? left_m : right_m) * noise_of_cell(i);
    }
    return heights;
}

/// The median of the absolute value of n normal variates has this relative error; those of the mask overlap,
/// so that some four cells make one.
double relative_error(double cells) {
    return 1.17 / std::sqrt(0.25 * cells);
}

TEST(HeightNoise, IsThatWhichWasAddedWhateverTheGroundIs) {
    for (const double cell_m : {0.5, 1.0, 2.0}) {
        for (const double noise_m : {0.1, 0.3}) {
            const config::Raster<double> heights =
                noisy({144, 144, 0.0, 0.0, cell_m, cell_m}, noise_m, noise_m);
            for (const HeightNoise& noise : {HeightNoise{heights}, HeightNoise{points_of(heights)}}) {
                std::vector<double> of_patches;
                for (const PointNoise& patch : noise.patches()) {
                    of_patches.push_back(patch.noise_m);
                    EXPECT_NEAR(patch.spacing_m, cell_m, 0.12 * cell_m);
                }
                std::sort(of_patches.begin(), of_patches.end());
                const double middle_m = of_patches[of_patches.size() / 2];
                EXPECT_NEAR(middle_m / noise_m, 1.0, 4.0 * relative_error(144.0 * 144.0) + 0.03);
                EXPECT_NEAR(of_patches.front() / noise_m, 1.0, 4.0 * relative_error(576.0));
                // A crooked wall takes up to a fifth of a patch.
                EXPECT_NEAR(of_patches.back() / noise_m, 1.0, 4.0 * relative_error(576.0) + 0.4);
            }
        }
    }
}

TEST(HeightNoise, IsNoneOnCurvedGroundWithAWall) {
    const HeightNoise noise{noisy({144, 144, 0.0, 0.0, 1.0, 1.0}, 0.0, 0.0)};
    for (const PointNoise& patch : noise.patches()) {
        EXPECT_LT(patch.noise_m, 1e-3);
    }
}

TEST(HeightNoise, DiffersFromAMeadowToDebris) {
    const HeightNoise noise{noisy({192, 192, 0.0, 0.0, 1.0, 1.0}, 0.02, 0.3)};
    EXPECT_NEAR(noise.at(40.0, 96.0).noise_m, 0.02, 0.01);
    EXPECT_NEAR(noise.at(150.0, 96.0).noise_m, 0.3, 0.08);
    const ContactLaw law{.least_radius_m = 0.5};
    EXPECT_LT(law.radius_m(noise.at(40.0, 96.0)), 0.4 * law.radius_m(noise.at(150.0, 96.0)));
}

TEST(HeightNoise, IsThatOfTheTurnedAndTheMirroredTerrain) {
    const int cells = 77;
    const config::GridFrame frame{cells, cells, 0.0, 0.0, 1.0, 1.0};
    config::Raster<double> heights = noisy(frame, 0.05, 0.3);
    config::Raster<double> turned{frame};
    config::Raster<double> mirrored{frame};
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            turned.at({row, cells - 1 - column}) = heights.at({column, row});
            mirrored.at({cells - 1 - column, row}) = heights.at({column, row});
        }
    }
    const ContactLaw law{.least_radius_m = 0.95};
    const config::Raster<double> felt = contact_zone(heights, law, HeightNoise{heights});
    const config::Raster<double> felt_turned = contact_zone(turned, law, HeightNoise{turned});
    const config::Raster<double> felt_mirrored = contact_zone(mirrored, law, HeightNoise{mirrored});
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            EXPECT_NEAR(felt_turned.at({row, cells - 1 - column}), felt.at({column, row}), 1e-9);
            EXPECT_NEAR(felt_mirrored.at({cells - 1 - column, row}), felt.at({column, row}), 1e-9);
        }
    }
}

TEST(ContactLaw, KeepsTheSlopeErrorThatItPromises) {
    for (const double cell_m : {0.25, 1.0, 5.0}) {
        for (const double noise_m : {0.1, 0.2, 0.4 * std::sqrt(cell_m)}) {
            const config::GridFrame frame{200, 200, 0.0, 0.0, cell_m, cell_m};
            config::Raster<double> heights =
                heights_of(frame, [](double x_m, double) { return -0.78 * x_m; });
            for (std::size_t i = 0; i < heights.values.size(); ++i) {
                heights.values[i] += noise_m * noise_of_cell(i);
            }
            const ContactLaw law{.least_radius_m = 0.2};
            const config::Raster<double> felt = contact_zone(heights, law, HeightNoise{heights});
            double squares = 0.0;
            for (int row = 20; row < 180; ++row) {
                for (int column = 20; column < 180; ++column) {
                    const double slope = (felt.at({column + 1, row}) - felt.at({column, row})) / cell_m;
                    squares += (slope + 0.78) * (slope + 0.78);
                }
            }
            const double error = std::sqrt(squares / (160.0 * 160.0));
            // A zone of few cells keeps less of the noise than the integral says; breaks are seen by chance.
            EXPECT_LT(error, 1.2 * law.slope_error) << cell_m << " m, " << noise_m << " m";
            EXPECT_GT(error, 0.6 * law.slope_error) << cell_m << " m, " << noise_m << " m";
        }
    }
}

TEST(ContactLaw, IsAsWideAsTheRockWhereTheHeightsAreClean) {
    const ContactLaw law{.least_radius_m = 1.3};
    EXPECT_EQ(law.radius_m({0.0, 1.0}), 1.3);
    EXPECT_EQ((ContactLaw{.given_radius_m = 2.5, .least_radius_m = 1.3}).radius_m({1.0, 1.0}), 2.5);
    EXPECT_NEAR(law.radius_m({0.3, 1.0}), std::sqrt(slope_of_noise * 0.3 / law.slope_error), 1e-12);
}

}  // namespace
}  // namespace rockfall::height_noise_test
