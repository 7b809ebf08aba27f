#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/assessments/decades/tables/yearly_work.hpp"

namespace coupling::decades {

/// What one member says of one year.
struct YearView {
    const YearRow* row = nullptr;
    const forest::StandFigures* stand = nullptr;  ///< the whole forest, all species
    std::vector<double> volumes_m3pha;            ///< by species of the table
    std::array<forest::Loss, forest::cause_count> losses{};
    YearlyWork work{};
    double drought_index = 0.0;  ///< mean over the forest
};

/// A figure of a year.
using YearFigure = std::function<double(const YearView&)>;

/// How charts name the regime (or climate) at a place of the list: "A", "B", ..., beyond 26 its number; empty
/// for a single one.
std::string letter_of(std::size_t place, std::size_t regimes);

/// How charts name a course: by its regime, where there is but one by its climate. Lines of the same regime
/// look the same in the charts of all climates.
struct CourseLook {
    std::string letter;    ///< "A", ...; empty for a single course
    std::size_t line = 0;  ///< place of its line among the styles
    std::string name;      ///< "pfm1", where there are several climates "pfm1, warm"
    std::string in_chart;  ///< its name where the chart is about one climate: "pfm1"

    [[nodiscard]] std::string title() const;           ///< "A: pfm1, warm"
    [[nodiscard]] std::string title_in_chart() const;  ///< "A: pfm1"
};
CourseLook look_of(const Names& names, std::size_t course);

/// Whether several regimes live in several climates: then each climate has a chart of its own.
bool splits_charts(const Names& names);

/// A regime in a climate with its replicates in order; views are of the same years in all of them.
struct RegimeView {
    std::size_t course = 0;
    std::size_t climate = 0;
    CourseLook look;
    std::vector<std::vector<YearView>> replicates;  ///< [replicate][year]
    const MemberYears* first = nullptr;             ///< the lowest replicate there is

    [[nodiscard]] std::string title() const { return look.title(); }
    [[nodiscard]] Band band(std::size_t year, const YearFigure& figure,
                            const Bounds& bounds = not_negative) const;
    /// Of each replicate's mean over the years `first_year` to `last_year`.
    [[nodiscard]] Band mean_band(std::size_t first_year, std::size_t last_year, const YearFigure& figure,
                                 const Bounds& bounds = not_negative) const;
};

/// The members of a run, looked up by course, replicate and year. Refers to the members.
struct RunView {
    std::vector<RegimeView> regimes;  ///< one for each course that ran
    std::vector<std::string> climates;
    bool chart_a_climate = false;                  ///< splits_charts
    std::size_t years = 0;                         ///< simulated, without the start; 0 without members too
    std::vector<std::size_t> species;              ///< of the table, those that ever stood
    forest::DisturbanceLaw disturbance{};          ///< which of them were simulated
    [[nodiscard]] std::size_t replicates() const;  ///< most of any regime
};

/// Requires that all members have rows of the same years, from the start on, and area_ha > 0.
RunView view_of(const Names& names, std::span<const MemberYears> members, double area_ha);

/// Stems from 12 cm on, where foresters begin to count.
double stems_from_12_cm(const forest::StandFigures& stand);

}  // namespace coupling::decades
