#include "coupling/inputs/climate/sunshine.hpp"

#include <gtest/gtest.h>

#include <string>

#include "config/text/numbers.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "forest/light/sun.hpp"

namespace coupling::sunshine_test {
namespace {

const config::Angle latitude = config::Angle::from_degrees(46.2);

config::Table months(const std::string& text) {
    config::Table table = config::Table::read(std::string_view{text}, "file");
    tables::prepare(table, "climate", false);
    return table;
}

double radiation(const config::Table& table, std::size_t row) {
    return config::parse_number(table.text(row, "rad_mj_m2_d")).value();
}

TEST(Sunshine, GivesAQuarterOfTheSkysLightWithoutSunAndThreeWithIt) {
    config::Table table = months("year,month,sunshine_h\n2001,6,0\n2001,6,744\n");
    EXPECT_NE(climate::take_sunshine(table, latitude), "");
    const double outside_mjpm2 = forest::extraterrestrial_mjpm2(latitude, 166);
    EXPECT_NEAR(radiation(table, 0), 0.25 * outside_mjpm2, 1e-4);
    EXPECT_NEAR(radiation(table, 1), 0.75 * outside_mjpm2, 1e-4) << "more hours than there are count as all";
}

TEST(Sunshine, IsNearWhatWasMeasuredAtSion) {
    // MeteoSwiss, Sion 1981: hours of a month and measured radiation [MJ/m2 d].
    config::Table table = months("year,month,sunshine_h\n1981,1,85.1\n1981,7,210.3\n");
    climate::take_sunshine(table, latitude);
    EXPECT_NEAR(radiation(table, 0), 4.498, 0.1 * 4.498);
    EXPECT_NEAR(radiation(table, 1), 20.212, 0.1 * 20.212);
}

TEST(Sunshine, MayBeReplacedByTheDailyRangeOfTemperatures) {
    // FAO-56, equation 50: 0.16 of the root of 9 K, and nothing where the day is no warmer than the night.
    config::Table table = months("year,month,tmin_c,tmax_c,prec_mm\n2001,6,8,17,90\n2001,7,12,12,80\n");
    EXPECT_NE(climate::take_sunshine(table, latitude).find("daily range of temperatures"), std::string::npos);
    EXPECT_NEAR(radiation(table, 0), 0.48 * forest::extraterrestrial_mjpm2(latitude, 166), 1e-4);
    EXPECT_EQ(radiation(table, 1), 0.0);
    // MeteoSwiss, Sion, means of 1981 to 2020: the range gives 1.00 to 1.20 of the measured radiation.
    config::Table without = months("year,month,prec_mm\n2001,6,90\n");
    EXPECT_EQ(climate::take_sunshine(without, latitude), "");
}

TEST(Sunshine, IsReadInMinutesOfDaysAndLeftAloneBesideRadiation) {
    std::string days = "date,tre200dn,tre200dx,rre150d0,sre000d0\n";
    for (int month = 1; month <= 12; ++month) {
        for (int day = 1; day <= 28; ++day) {
            days += std::to_string(20010000 + 100 * month + day) + ",1,9,2,300\n";
        }
    }
    config::Table table = months(days);
    ASSERT_EQ(table.rows(), 12U);
    EXPECT_EQ(table.text(0, "sunshine_h"), "155") << "five hours on each of 31 days";
    config::Table with_radiation = months("year,month,sunshine_h,rad_mj_m2_d\n2001,1,80,4.5\n");
    EXPECT_EQ(climate::take_sunshine(with_radiation, latitude), "");
    EXPECT_EQ(with_radiation.text(0, "rad_mj_m2_d"), "4.5");
}

}  // namespace
}  // namespace coupling::sunshine_test
