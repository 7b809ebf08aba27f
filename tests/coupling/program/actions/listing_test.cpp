#include "coupling/program/actions/listing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <sstream>

#include "config/random/stream.hpp"

namespace coupling::listing_test {
namespace {

/// Numbers and units of "reading 1 s, falls 11 s".
struct Said {
    long sum = 0;
    std::string unit;
};

Said said_in(const std::string& text) {
    Said said;
    std::istringstream words{text};
    std::string name;
    long number = 0;
    std::string unit;
    while (words >> name >> number >> unit) {
        EXPECT_GT(number, 0) << text;
        said.sum += number;
        said.unit = unit.substr(0, unit.find(','));
    }
    return said;
}

TEST(Durations, OfPartsAddUpToThatOfTheWhole) {
    config::RandomStream stream{{.seed = 1}, config::Purpose::release};
    constexpr int trials = 2000;
    for (int trial = 0; trial < trials; ++trial) {
        const auto draw_s = [&] { return std::pow(10.0, 6.0 * stream.uniform() - 1.5); };
        const double reading_s = draw_s();
        const double falls_s = draw_s();
        const double writing_s = draw_s();
        const double whole_s = reading_s + falls_s + writing_s;
        const std::string parts =
            durations_of({{"reading", reading_s}, {"falls", falls_s}, {"writing", writing_s}});
        if (whole_s < 1.0) {
            EXPECT_EQ(parts, "");
            EXPECT_EQ(duration(whole_s), "less than a second");
        } else {
            const Said said = said_in(parts);
            EXPECT_EQ("about " + std::to_string(said.sum) + " " + said.unit, duration(whole_s)) << parts;
        }
    }
}

TEST(Durations, LeaveOutWhatTakesNothing) {
    EXPECT_EQ(durations_of({{"reading", 0.2}, {"falls", 1.1}, {"writing", 0.0}}), "falls 1 s");
    EXPECT_EQ(durations_of({{"reading", 0.2}, {"falls", 0.3}, {"writing", 0.2}}), "");
}

}  // namespace
}  // namespace coupling::listing_test
