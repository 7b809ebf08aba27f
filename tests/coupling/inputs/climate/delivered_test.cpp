// Climate as services deliver it, made into our months.

#include "coupling/inputs/climate/delivered.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/climate/dates.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling::climate_delivered_test {
namespace {

using climate::Date;

struct Weather {
    Date date;
    double tmin_degc, tmax_degc, prec_mm, radiation_mjpm2;
};

/// Some years of days, from sines that no month shares.
std::vector<Weather> days_of(int first_year, int years) {
    std::vector<Weather> days;
    for (int year = first_year; year < first_year + years; ++year) {
        for (int day = 1; const auto date = climate::date_of_day(year, day); ++day) {
            const double season = std::cos(6.283 * (day - 200) / 365.0);
            const double noise = std::sin(12.9898 * day + year);
            days.push_back({*date, 3.0 + 9.0 * season + 3.0 * noise, 12.0 + 11.0 * season + 3.0 * noise,
                            std::max(0.0, 8.0 * noise), 12.0 + 8.0 * season + 2.0 * noise});
        }
    }
    return days;
}

std::string text(double value) {
    return config::to_text(value);
}

/// A service: its header with all above it, and a line for each day.
struct Service {
    std::string name;
    std::string header;
    std::function<std::string(const Weather&)> line;
};

int day_of_year(const Date& date) {
    int day = date.day;
    for (int month = 1; month < date.month; ++month) {
        day += climate::days_of_month(date.year, month);
    }
    return day;
}

std::string number(int value) {
    return std::to_string(value);
}

std::string eight_digits(const Date& date) {
    return number(date.year * 10000 + date.month * 100 + date.day);
}

/// The same days as several services have them.
const std::vector<Service>& services() {
    static const std::vector<Service> all{
        {"Daymet",
         "Latitude: 47.2  Longitude: 11.4\nX & Y on Lambert Conformal Conic: 1.0 2.0\nTile: 11\n"
         "Elevation: 1210 meters\nAll years; all variables; Version 4\n"
         "year,yday,dayl (s),prcp (mm/day),srad (W/m^2),swe (kg/m^2),tmax (deg c),tmin (deg c),vp (Pa)\n",
         [](const Weather& day) {
             constexpr double day_length_s = 40'000.0;
             return number(day.date.year) + "," + number(day_of_year(day.date)) + "," + text(day_length_s) +
                    "," + text(day.prec_mm) + "," + text(day.radiation_mjpm2 * 1e6 / day_length_s) + ",0," +
                    text(day.tmax_degc) + "," + text(day.tmin_degc) + ",600";
         }},
        {"NASA POWER",
         "-BEGIN HEADER-\nNASA/POWER Source Native Resolution Daily Data \n"
         "elevation from MERRA-2: Average for 0.5 x 0.625 degree lat/lon region = 1210.0 meters\n"
         "value for missing source data that cannot be computed: -999 \nparameter(s): \n"
         "T2M_MIN               MERRA-2 Temperature at 2 Meters Minimum (C) \n"
         "ALLSKY_SFC_SW_DWN     CERES SYN1deg All Sky Surface Shortwave Downward Irradiance (kW-hr/m^2/day) "
         "\n"
         "-END HEADER-\nYEAR,MO,DY,T2M_MIN,T2M_MAX,PRECTOTCORR,ALLSKY_SFC_SW_DWN\n",
         [](const Weather& day) {
             return number(day.date.year) + "," + number(day.date.month) + "," + number(day.date.day) + "," +
                    text(day.tmin_degc) + "," + text(day.tmax_degc) + "," + text(day.prec_mm) + "," +
                    text(day.radiation_mjpm2 / 3.6);
         }},
        {"MeteoSwiss", "station_abbr;reference_timestamp;tre200d0;tre200dn;tre200dx;rre150d0;gre000d0\n",
         [](const Weather& day) {
             return "DAV;" + number(day.date.day) + "." + number(day.date.month) + "." +
                    number(day.date.year) + " 00:00;" + text(0.5 * (day.tmin_degc + day.tmax_degc)) + ";" +
                    text(day.tmin_degc) + ";" + text(day.tmax_degc) + ";" + text(day.prec_mm) + ";" +
                    text(day.radiation_mjpm2 / 0.0864);
         }},
        {"GeoSphere Austria", "time,station,tlmin,tlmax,rr,cglo_j\n",
         [](const Weather& day) {
             return number(day.date.year) + "-" + number(day.date.month) + "-" + number(day.date.day) +
                    "T00:00+00:00,11804," + text(day.tmin_degc) + "," + text(day.tmax_degc) + "," +
                    text(day.prec_mm) + "," + text(100.0 * day.radiation_mjpm2);
         }},
        {"CORDEX", "date,tasmin,tasmax [K],pr,rsds\n",
         [](const Weather& day) {
             return eight_digits(day.date) + "," + text(day.tmin_degc + 273.15) + "," +
                    text(day.tmax_degc + 273.15) + "," + text(day.prec_mm / 86400.0) + "," +
                    text(day.radiation_mjpm2 / 0.0864);
         }},
        {"KNMI",
         "BRON: KONINKLIJK NEDERLANDS METEOROLOGISCH INSTITUUT (KNMI)\nComment: not suitable, for trends\n\n"
         "TN        = Minimum temperatuur (in 0.1 graden Celsius) / Minimum temperature (in 0.1 degrees "
         "Celsius)\nTX        = Maximum temperature (in 0.1 degrees Celsius)\n"
         "Q         = Globale straling (in J/cm2) / Global radiation (in J/cm2)\n"
         "RH        = Etmaalsom / Daily precipitation amount (in 0.1 mm) (-1 for <0.05 mm)\n"
         "UG        = Daily mean relative atmospheric humidity (in percents)\n\n"
         "# STN,YYYYMMDD,   TN,   TX,    Q,   RH,   UG, \n\n",
         [](const Weather& day) {
             return "  260," + eight_digits(day.date) + "," + text(10.0 * day.tmin_degc) + "," +
                    text(10.0 * day.tmax_degc) + "," + text(100.0 * day.radiation_mjpm2) + "," +
                    text(day.prec_mm > 0.0 ? 10.0 * day.prec_mm : -1.0) + ",   93, ";
         }},
        {"Open-Meteo",
         "latitude,longitude,elevation,utc_offset_seconds,timezone,timezone_abbreviation\n"
         "47.2,11.4,1210.0,0,GMT,GMT\n\ntime,temperature_2m_max (°C),temperature_2m_min (°C),"
         "precipitation_sum (mm),shortwave_radiation_sum (MJ/m²)\n",
         [](const Weather& day) {
             return number(day.date.year) + "-" + number(day.date.month) + "-" + number(day.date.day) + "," +
                    text(day.tmax_degc) + "," + text(day.tmin_degc) + "," + text(day.prec_mm) + "," +
                    text(day.radiation_mjpm2);
         }},
        {"NOAA", "DATE,PRCP (Inches),TMAX (Degrees Fahrenheit),TMIN [degF],SRAD [J/m2]\n",
         [](const Weather& day) {
             return eight_digits(day.date) + "," + text(day.prec_mm / 25.4) + "," +
                    text(32.0 + 1.8 * day.tmax_degc) + "," + text(32.0 + 1.8 * day.tmin_degc) + "," +
                    text(1e6 * day.radiation_mjpm2);
         }}};
    return all;
}

std::string file_of(const Service& service, const std::vector<Weather>& days) {
    std::string file = service.header;
    for (const Weather& day : days) {
        file += service.line(day) + "\n";
    }
    return file;
}

struct Read {
    config::Table table;
    tables::Findings findings;
};

Read read(const std::string& file) {
    Read read{config::Table::read(std::string_view{file}, "file"), {}};
    read.findings = tables::prepare(read.table, "climate", false);
    return read;
}

double value(const config::Table& table, std::size_t row, const std::string& column) {
    return config::parse_number(table.text(row, column)).value();
}

std::string message_of(const std::string& file) {
    try {
        read(file);
    } catch (const config::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(DeliveredClimate, IsTheSameFromEachService) {
    const std::vector<Weather> days = days_of(1999, 2);
    for (const Service& service : services()) {
        const config::Table table = read(file_of(service, days)).table;
        ASSERT_EQ(table.rows(), 24U) << service.name;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const int year = 1999 + static_cast<int>(row) / 12;
            const int month = 1 + static_cast<int>(row) % 12;
            EXPECT_EQ(value(table, row, "year"), year);
            EXPECT_EQ(value(table, row, "month"), month);
            double low = 0.0;
            double high = 0.0;
            double rain = 0.0;
            double light = 0.0;
            double lowest = 99.0;
            int frost = 0;
            for (const Weather& day : days) {
                if (day.date.year == year && day.date.month == month) {
                    low += day.tmin_degc;
                    high += day.tmax_degc;
                    rain += day.prec_mm;
                    light += day.radiation_mjpm2;
                    lowest = std::min(lowest, day.tmin_degc);
                    frost += day.tmin_degc < 0.0 ? 1 : 0;
                }
            }
            const double length = climate::days_of_month(year, month);
            EXPECT_NEAR(value(table, row, "tmin_c"), low / length, 1e-4) << service.name;
            EXPECT_NEAR(value(table, row, "tmax_c"), high / length, 1e-4) << service.name;
            EXPECT_NEAR(value(table, row, "prec_mm"), rain, 1e-4) << service.name;
            EXPECT_NEAR(value(table, row, "rad_mj_m2_d"), light / length, 1e-4) << service.name;
            EXPECT_NEAR(value(table, row, "abs_tmin_c"), lowest, 1e-4) << service.name;
            EXPECT_EQ(value(table, row, "frost_days"), frost) << service.name;
        }
    }
}

TEST(DeliveredClimate, TakesTheHeightFromAboveTheHeader) {
    const std::vector<Weather> days = days_of(1999, 1);
    for (const std::size_t service : {0U, 1U, 6U}) {
        EXPECT_EQ(value(read(file_of(services()[service], days)).table, 0, "elev_m"), 1210.0);
    }
    EXPECT_FALSE(read(file_of(services()[2], days)).table.find("elev_m"));
}

TEST(DeliveredClimate, MayBeginOnAnyDay) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Weather> days = days_of(2000, 2);
        const Service& service = services()[*rc::gen::inRange<std::size_t>(0, services().size())];
        const config::Table whole = read(file_of(service, days)).table;
        days.erase(days.begin(), days.begin() + *rc::gen::inRange(1, 366));
        const config::Table late = read(file_of(service, days)).table;
        RC_ASSERT(whole.rows() == 24U);
        RC_ASSERT(late.rows() == 12U || late.rows() == 24U);  // up to three days in a row may be missing
        RC_ASSERT(value(late, late.rows() - 1, "tmin_c") == value(whole, 23, "tmin_c"));
    }));
}

TEST(DeliveredClimate, DoesNotDependOnTheOrderOfItsRows) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Weather> days = days_of(2001, 1);
        const Service& service = services()[*rc::gen::inRange<std::size_t>(0, services().size())];
        const config::Table ordered = read(file_of(service, days)).table;
        for (std::size_t i = days.size(); i > 1; --i) {
            std::swap(days[i - 1], days[*rc::gen::inRange<std::size_t>(0, i)]);
        }
        const config::Table mixed = read(file_of(service, days)).table;
        for (std::size_t row = 0; row < ordered.rows(); ++row) {
            for (const std::string& column : ordered.columns()) {
                RC_ASSERT(std::abs(value(mixed, row, column) - value(ordered, row, column)) < 1e-3);
            }
        }
    }));
}

TEST(DeliveredClimate, PassesOverSingleMissingDaysAndLeavesOutYearsWithGaps) {
    std::vector<Weather> days = days_of(1998, 5);
    // Of 1998 spring alone; a gap in 2000 of four days in a row; five single days in 2001.
    std::erase_if(days, [](const Weather& day) {
        return (day.date.year == 1998 && day.date.month < 4) ||
               (day.date.year == 2000 && day.date.month == 7 && day.date.day >= 10 && day.date.day < 14) ||
               (day.date.year == 2001 && day.date.month == 3 && day.date.day % 5 == 0 && day.date.day < 26);
    });
    const Read found = read(file_of(services()[3], days));
    ASSERT_EQ(found.table.rows(), 24U);
    EXPECT_EQ(value(found.table, 0, "year"), 2001);
    ASSERT_EQ(found.findings.warnings.size(), 1U);
    EXPECT_NE(found.findings.warnings[0].found.find("years left out: 1998 to 2000; gap: tmin_c, 2000-07"),
              std::string::npos)
        << found.findings.warnings[0].found;
    const auto says = [&](const std::string& text) {
        return std::any_of(found.findings.notes.begin(), found.findings.notes.end(),
                           [&](const std::string& note) { return note.find(text) != std::string::npos; });
    };
    EXPECT_TRUE(says("single days without a value, passed over: 20")) << "five days, four quantities";
    EXPECT_TRUE(says("numbers in other units: rad_mj_m2_d = 'cglo_j' / 100"));
}

TEST(DeliveredClimate, PassesOverGapsOfSunshineBesideRadiation) {
    std::string file = "date,tre200dn,tre200dx,rre150d0,gre000d0,sre000d0\n";
    for (const Weather& day : days_of(2001, 1)) {
        file += eight_digits(day.date) + "," + text(day.tmin_degc) + "," + text(day.tmax_degc) + "," +
                text(day.prec_mm) + "," + text(day.radiation_mjpm2 / 0.0864) + ",-\n";
    }
    const config::Table table = read(file).table;
    EXPECT_EQ(table.rows(), 12U);
    EXPECT_FALSE(table.find("sunshine_h"));
}

TEST(DeliveredClimate, ReadsSignsOfNoValue) {
    const std::vector<Weather> days = days_of(2001, 1);
    std::string file = services()[3].header;
    for (const Weather& day : days) {
        Weather seen = day;
        if (day.date.day == 7) {
            seen.prec_mm = -999.0;
        }
        file += services()[3].line(seen) + "\n";
    }
    const config::Table table = read(file).table;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_GE(value(table, row, "prec_mm"), 0.0);
    }
}

TEST(DeliveredClimate, ConvertsMonthsInOtherUnits) {
    std::string file = "date,tmin [K],tmax [K],pr (kg m-2 s-1),rsds (W/m2)\n";
    for (int month = 1; month <= 12; ++month) {
        file += "2001-" + number(month) + ",273.15,283.15,0.00001,150\n";
    }
    const config::Table table = read(file).table;
    ASSERT_EQ(table.rows(), 12U);
    EXPECT_NEAR(value(table, 0, "tmin_c"), 0.0, 1e-9);
    EXPECT_NEAR(value(table, 1, "prec_mm"), 1e-5 * 86400.0 * 28.0, 1e-4);
    EXPECT_NEAR(value(table, 0, "rad_mj_m2_d"), 12.96, 1e-4);
    EXPECT_EQ(value(table, 11, "month"), 12.0);
}

TEST(DeliveredClimate, LeavesOurMonthsAsTheyAre) {
    const std::string file = "year,month,tmin_c,tmax_c,prec_mm,rad_mj_m2_d,note\n2001,1,-3.25,1,80,4.5,x\n";
    const Read found = read(file);
    EXPECT_EQ(found.table.text(0, "tmin_c"), "-3.25");
    EXPECT_EQ(found.table.text(0, "note"), "x");
    EXPECT_TRUE(found.findings.notes.empty());
}

// A unit that no header names: whole degrees Fahrenheit, and tenths of a degree, would look like summers.
TEST(DeliveredClimate, RefusesTemperaturesThatNoPlaceHas) {
    EXPECT_TRUE(rc::check([] {
        const std::vector<Weather> days = days_of(2001, 1);
        const bool are_tenths = *rc::gen::arbitrary<bool>();
        const double warmer_k = *rc::gen::inRange(-4, 15);  // the days have a mean of 3 and 12 degC
        std::string file = "DATE,PRCP,TMAX,TMIN\n";
        for (const Weather& day : days) {
            const auto whole = [&](double degc) {
                return number(static_cast<int>(std::lround(are_tenths ? 10.0 * degc : 32.0 + 1.8 * degc)));
            };
            file += eight_digits(day.date) + ",1," + whole(day.tmax_degc + warmer_k) + "," +
                    whole(day.tmin_degc + warmer_k) + "\n";
        }
        const std::string message = message_of(file);
        RC_ASSERT(message.find(are_tenths ? "tenths of a degree" : "degrees Fahrenheit") !=
                  std::string::npos);
        RC_ASSERT(message.find("units=metric") != std::string::npos);
    }));
}

TEST(DeliveredClimate, AsksForWhatDaysLackByTheNamesOfTheFile) {
    std::string file = "time,tmin,tmax,precip_total_x\n";
    for (const Weather& day : days_of(2001, 1)) {
        file += eight_digits(day.date) + "," + text(day.tmin_degc) + "," + text(day.tmax_degc) + ",1\n";
    }
    EXPECT_NE(message_of(file).find("'precip_total_x' meant to be it?"), std::string::npos)
        << message_of(file);
}

TEST(DeliveredClimate, RefusesWhatIsNoSeriesOfOnePlace) {
    const std::vector<Weather> days = days_of(2001, 1);
    const std::string twice = file_of(services()[3], days) + services()[3].line(days[3]) + "\n";
    EXPECT_NE(message_of(twice).find("one row for each day or month, of one place"), std::string::npos);
    EXPECT_NE(message_of("PARAMETER,YEAR,JAN,FEB,MAR,APR,MAY,JUN,JUL,AUG,SEP,OCT,NOV,DEC,ANN\n"
                         "T2M_MAX,2001,1,2,3,4,5,6,7,8,9,10,11,12,13\n")
                  .find("Daily, CSV"),
              std::string::npos);
    EXPECT_NE(message_of("date,tmin_c,tmax_c,prec_mm,rad_mj_m2_d\n1.1.01,1,2,3,4\n").find("a day or month"),
              std::string::npos);
    EXPECT_NE(message_of("date,tmin_c,tmax_c,prec_mm,rad_mj_m2_d\n20010101,1,2,3,4\n20010102,1,2,3,4\n")
                  .find("no whole year"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::climate_delivered_test
