// The rules on coordinate systems, units and scale over random systems and extents: what is said depends on
// the system and on the place, not on the shape of the extent, the side of a meridian or the form of the
// text.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::system_rules_test {
namespace {

std::mt19937& draws() {
    static std::mt19937 random{11};
    return random;
}

double draw(double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(draws());
}

/// Random extents of 100 m to 5 km about a place.
Extent extent_about(double x_m, double y_m) {
    const double width_m = draw(100.0, 5000.0);
    const double height_m = draw(100.0, 5000.0);
    return {x_m - 0.5 * width_m, x_m + 0.5 * width_m, y_m - 0.5 * height_m, y_m + 0.5 * height_m};
}

Extent extent_within(const Extent& area) {
    constexpr double rim_m = 2500.0;
    return extent_about(draw(area.west_m + rim_m, area.east_m - rim_m),
                        draw(area.south_m + rim_m, area.north_m - rim_m));
}

std::string text_of(const KnownSystem& system) {
    return formats::esri_text_of("EPSG:" + std::to_string(system.epsg));
}

/// The same text with blanks, line breaks and round brackets, as other programs write it.
std::string in_other_form(const std::string& text) {
    std::string other;
    bool quoted = false;
    for (const char c : text) {
        quoted = quoted != (c == '"');
        if (quoted || (c != '[' && c != ']' && c != ',')) {
            other += c;
        } else {
            other += c == ',' ? std::string{",\r\n    "} : c == '[' ? "(" : ")";
        }
    }
    return other + "\n";
}

TEST(SystemRules, AcceptEachSystemInItsAreaAndRefuseItElsewhere) {
    constexpr double far_m = 150e3;  // beyond every slack
    int refused = 0;
    for (const KnownSystem& system : known_systems()) {
        const std::string text = text_of(system);
        ASSERT_FALSE(text.empty()) << system.name;
        for (const KnownSystem& other : known_systems()) {
            for (int trial = 0; trial < 5; ++trial) {
                const Extent here = extent_within(system.area);
                EXPECT_FALSE(contradiction_of(text, here, "dem.prj")) << system.name << in_words(here);
                const Extent there = extent_within(other.area);
                const Extent& area = system.area;
                const bool is_far =
                    there.east_m < area.west_m - far_m || there.west_m > area.east_m + far_m ||
                    there.north_m < area.south_m - far_m || there.south_m > area.north_m + far_m;
                const auto wrong = contradiction_of(text, there, "dem.prj");
                EXPECT_TRUE(wrong || !is_far) << system.name << " at " << in_words(there);
                refused += is_far ? 1 : 0;
                const auto again = contradiction_of(in_other_form(text), there, "dem.prj");
                ASSERT_EQ(again.has_value(), wrong.has_value()) << in_other_form(text);
                if (wrong) {
                    EXPECT_EQ(again->found, wrong->found);
                    EXPECT_EQ(again->advice, wrong->advice);
                }
            }
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(SystemRules, RefuseDegreesAnywhere) {
    for (const char* code : {"EPSG:4326", "EPSG:4258", "EPSG:4312", "EPSG:4314"}) {
        const std::string text = formats::esri_text_of(code);
        for (int trial = 0; trial < 20; ++trial) {
            const double east_deg = draw(-179.0, 179.0);
            const double north_deg = draw(-89.0, 89.0);
            const Extent degrees{east_deg, east_deg + draw(0.001, 0.1), north_deg, north_deg + 0.01};
            EXPECT_TRUE(contradiction_of(text, degrees, "dem.tif")) << code << in_words(degrees);
            EXPECT_TRUE(contradiction_of(text, extent_about(draw(-1e6, 1e6), draw(1e5, 6e6)), "dem.tif"));
        }
    }
}

TEST(SystemRules, RefuseEachUnitOfThePlanButTheMetre) {
    const std::string metres = formats::esri_text_of("EPSG:25832");
    const std::string unit = "UNIT[\"Meter\",1.0]";
    ASSERT_NE(metres.rfind(unit), std::string::npos) << metres;
    for (int trial = 0; trial < 50; ++trial) {
        const double size = std::pow(10.0, draw(-3.0, 3.0));
        std::string text = metres;
        text.replace(text.rfind(unit), unit.size(), "UNIT[\"Other\"," + config::to_text(size) + "]");
        const auto wrong = contradiction_of(text, extent_about(6e5, 5.2e6), "dem.prj");
        ASSERT_TRUE(wrong) << text;
        EXPECT_NE(wrong->found.find("in units of " + config::to_text(size) + " m"), std::string::npos)
            << wrong->found;
    }
}

/// The part of a text that says how heights are counted, in the three forms in use.
std::vector<std::string> height_parts(const std::string& plan, double size, bool is_depth) {
    const std::string number = config::to_text(size);
    return {
        plan + ",VERTCS[\"Local\",VDATUM[\"L\"],PARAMETER[\"Vertical_Shift\",0.0],PARAMETER[\"Direction\"," +
            (is_depth ? "-1.0" : "1.0") + "],UNIT[\"Unit\"," + number + "]]",
        "COMPD_CS[\"both\"," + plan + ",VERT_CS[\"Local\",VERT_DATUM[\"L\",2005],UNIT[\"Unit\"," + number +
            "],AXIS[\"Up\"," + (is_depth ? "DOWN" : "UP") + "]]]",
        "COMPOUNDCRS[\"both\"," + plan + ",VERTCRS[\"Local\",VDATUM[\"L\"],CS[vertical,1],AXIS[\"height\"," +
            (is_depth ? "down" : "up") + "],LENGTHUNIT[\"Unit\"," + number + "]]]"};
}

TEST(SystemRules, RefuseEachUnitOfHeightsButTheMetreInAnyForm) {
    for (const KnownSystem& system : known_systems()) {
        const std::string plan = text_of(system);
        for (const double size : {1.0, 0.3048, 1200.0 / 3937.0, 0.1, 0.01, std::pow(10.0, draw(-3.0, 2.0))}) {
            for (const bool is_depth : {false, true}) {
                for (const std::string& text : height_parts(plan, size, is_depth)) {
                    for (const std::string& form : {text, in_other_form(text)}) {
                        const auto unit = height_unit_in(form);
                        ASSERT_TRUE(unit) << form;
                        EXPECT_NEAR(unit->metres, size, 1e-12 * size);
                        const auto wrong = contradiction_of_heights(*unit);
                        EXPECT_EQ(wrong.has_value(), is_depth || size != 1.0) << form;
                        // The plan is read as before.
                        EXPECT_FALSE(contradiction_of(form, extent_within(system.area), "dem.prj")) << form;
                    }
                }
            }
        }
    }
}

TEST(SystemRules, RefuseHeightsAboveMontBlancInEachSystemOfEurope) {
    for (const KnownSystem& system : known_systems()) {
        const std::string text = text_of(system);
        for (int trial = 0; trial < 5; ++trial) {
            EXPECT_NO_THROW(check_highest_of_system(draw(-10.0, 4810.0), text, "dem.tif"));
            EXPECT_THROW(check_highest_of_system(draw(4811.0, 9000.0), text, "dem.tif"), config::InputError)
                << system.name;
        }
    }
    EXPECT_NO_THROW(check_highest_of_system(8000.0, "", "dem.tif"));
    EXPECT_NO_THROW(check_highest_of_system(6200.0, formats::esri_text_of("EPSG:32719"), "dem.tif"));
}

/// What is said of the scale of a map: 0 nothing, 1 a warning, 2 an error.
int said_of_scale(const std::string& text, const Extent& extent) {
    const auto scale = contradiction_of_scale(text, "dem.tif", extent);
    return !scale ? 0 : scale->is_refused ? 2 : 1;
}

TEST(ScaleRule, RefusesWebMercatorAwayFromTheEquatorOnBothSidesOfIt) {
    const std::string text = formats::esri_text_of("EPSG:3857");
    constexpr double radius_m = 6378137.0;
    for (int trial = 0; trial < 25; ++trial) {
        const double latitude_deg = draw(0.0, 80.0);
        const double angle = latitude_deg * std::numbers::pi / 180.0;
        const double y_m = radius_m * std::log(std::tan(0.25 * std::numbers::pi + 0.5 * angle));
        const double x_m = draw(-1.9e7, 1.9e7);
        const int north = said_of_scale(text, extent_about(x_m, y_m));
        const int south = said_of_scale(text, extent_about(-x_m, -y_m));
        // 1 / cos(latitude) is 1.01 at 8.07 degrees; the flattening of the earth adds up to 0.7 %.
        if (latitude_deg > 8.1) {
            EXPECT_EQ(north, 2) << latitude_deg;
        }
        EXPECT_GE(north, 1) << latitude_deg;  // and never nothing
        if (std::abs(latitude_deg - 8.07) > 4.0) {
            EXPECT_EQ(north, south) << latitude_deg;
        }
    }
}

TEST(ScaleRule, PassesEachNationalSystemInItsArea) {
    for (const KnownSystem& system : known_systems()) {
        const std::string text = text_of(system);
        if (system.name.find("UTM") != std::string_view::npos || system.epsg == 3003 || system.epsg == 3004) {
            continue;  // wider than their zone, judged below
        }
        // The rectangle around France reaches beyond its coasts, to where its map is off by 0.3 %.
        const int most = system.epsg == 2154 || system.epsg == 27572 ? 1 : 0;
        for (int trial = 0; trial < 4; ++trial) {
            const Extent extent = extent_within(system.area);
            EXPECT_LE(said_of_scale(text, extent), most) << system.name << " " << in_words(extent);
        }
    }
}

TEST(ScaleRule, GrowsWithTheDistanceFromTheMeridianOfUtmToBothSides) {
    for (const int code : {25831, 25832, 25833, 32610, 32718, 32760}) {
        const std::string text = formats::esri_text_of("EPSG:" + std::to_string(code));
        for (int trial = 0; trial < 8; ++trial) {
            const double y_m = draw(1e6, 8e6);
            const double off_m = draw(0.0, 1.2e6);
            // 0.9996 (1 + off^2 / 2 R^2); R is 6335 to 6400 km by direction and latitude.
            const auto scale_off = [&](double radius_m) {
                return std::abs(0.9996 * (1.0 + 0.5 * std::pow(off_m / 0.9996 / radius_m, 2)) - 1.0);
            };
            const auto said = [](double off) { return off >= 0.01 ? 2 : off >= 0.003 ? 1 : 0; };
            const int least = said(scale_off(6.41e6) - 2e-4);  // terms of the fourth power: below 2e-4
            const int most = said(scale_off(6.33e6) + 2e-4);
            for (const double side : {-1.0, 1.0}) {
                const int found = said_of_scale(text, extent_about(5e5 + side * off_m, y_m));
                EXPECT_GE(found, least) << code << " " << off_m;
                EXPECT_LE(found, most) << code << " " << off_m;
            }
        }
    }
}

}  // namespace
}  // namespace coupling::plausible::system_rules_test
