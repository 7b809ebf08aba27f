#pragma once

#include <limits>
#include <map>
#include <string>

namespace coupling::compare {

inline constexpr const char* over_years = "mean over years";
inline constexpr const char* last_year = "last year";
inline constexpr const char* worst_year = "worst year";

/// Which figure of a run: the same key in two runs means the same thing.
struct FigureKey {
    std::string target;     ///< id, empty for figures of the forest
    std::string regime;     ///< empty in runs of today
    std::string quantity;   ///< unit at the end, as columns of tables
    std::string when;       ///< "today", "mean over years", "last year" or "worst year"
    std::string climate{};  ///< empty in runs of today

    friend bool operator==(const FigureKey&, const FigureKey&) = default;
};

/// A figure with what is known of its uncertainty; NaN where not known.
struct Figure {
    FigureKey key;
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    bool is_interval = false;  ///< low and high: 95 % interval; otherwise the range of nine replicates in ten
    int year = -1;             ///< the worst one; -1: none
    std::map<long long, double> by_replicate{};  ///< values by the number of the replicate
    bool is_part = false;    ///< of a whole such as all species or causes: 0 where a run has no such part
    std::string why_none{};  ///< why there is no value, such as too few rocks; may be empty
};

/// Mean of the replicates with its 95 % interval by Student's t; one replicate has none.
Figure over_replicates(FigureKey key, std::map<long long, double> by_replicate);

}  // namespace coupling::compare
