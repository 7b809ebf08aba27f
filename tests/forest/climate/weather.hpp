#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "config/errors/input_error.hpp"
#include "forest/climate/series.hpp"

namespace forest {

inline config::Table climate_table(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "climate.csv");
}

/// A month of an alpine valley, lines of a climate table.
inline std::string alpine_row(int year, int month) {
    static const char* const months[] = {
        "-6.1,1.4,-2.5,90,4.5,0.12,28,0,-15",   "-5.3,3.4,-1.2,75,8.4,0.17,24,0,-14",
        "-2.1,8.0,2.7,85,12.6,0.29,20,20,-10",  "1.9,13.1,7.3,80,16.8,0.46,9,80,-5",
        "6.3,18.2,12.1,110,19.7,0.63,1,205,-1", "9.7,21.4,15.4,140,20.6,0.73,0,298,3",
        "11.6,23.6,17.4,150,20.9,0.84,0,369,6", "11.4,23.1,16.9,140,17.8,0.77,0,353,5",
        "7.9,18.6,12.8,95,13.2,0.51,0,221,1",   "3.4,13.0,7.7,75,8.6,0.31,6,85,-3",
        "-1.3,6.0,2.1,85,4.8,0.16,19,11,-9",    "-4.9,1.9,-1.6,95,3.6,0.11,27,0,-14"};
    return std::to_string(year) + "," + std::to_string(month) + "," + months[month - 1] + "\n";
}

inline constexpr const char* alpine_header =
    "year,month,tmin_c,tmax_c,tave_c,prec_mm,rad_mj_m2_d,vpd_kpa,frost_days,gdd55_c_d,abs_tmin_c\n";

/// The same weather in each of some years.
inline std::string alpine_text(int first_year, int last_year) {
    std::string text = alpine_header;
    for (int year = first_year; year <= last_year; ++year) {
        for (int month = 1; month <= 12; ++month) {
            text += alpine_row(year, month);
        }
    }
    return text;
}

inline ClimateSeries alpine_series(int first_year = 2001, int last_year = 2003) {
    config::Warnings warnings;
    return read_climate_of_one_place(climate_table(alpine_text(first_year, last_year)), warnings);
}

inline std::string replaced(std::string text, const std::string& old_text, const std::string& new_text) {
    const std::size_t at = text.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    return text.replace(at, old_text.size(), new_text);
}

}  // namespace forest
