#include "validation/engine/forest_cases/yield_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "forest/stand/allometry.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using yield_trial::YieldSite;
using yield_trial::YieldTableRow;

/// Classes between two printed ones are made of both, which fits badly where trees are thin and many.
constexpr double judged_from_cm = 10.0;

bool contradicts_basal_area(const YieldTableRow& row) {
    const double follows_m2pha = row.stems_pha * forest::basal_area_m2(row.mean_dbh_cm);
    return row.mean_dbh_cm >= judged_from_cm &&
           std::abs(row.basal_area_m2pha - follows_m2pha) > 0.15 * follows_m2pha;
}

bool has_odd_tree(const YieldTableRow& row) {
    const double slenderness = 100.0 * row.mean_height_m / row.mean_dbh_cm;
    return row.mean_dbh_cm >= judged_from_cm && (slenderness < 15.0 || slenderness > 150.0);
}

/// Whether most trees of 20 cm or more are more than 105 times as high as thick.
bool look_swapped(const std::vector<YieldTableRow>& rows) {
    std::size_t thick = 0;
    std::size_t slender = 0;
    for (const YieldTableRow& row : rows) {
        if (row.mean_dbh_cm >= 20.0) {
            ++thick;
            slender += 100.0 * row.mean_height_m / row.mean_dbh_cm > 105.0 ? 1 : 0;
        }
    }
    return 2 * slender > thick;
}

/// Thin trees have little wood of 7 cm and more.
bool has_odd_form(const YieldTableRow& row) {
    constexpr double from_cm = 15.0;
    const double form =
        row.volume_m3pha / (row.stems_pha * forest::basal_area_m2(row.mean_dbh_cm) * row.mean_height_m);
    return row.mean_dbh_cm >= from_cm && (form < 0.15 || form > 0.75);
}

/// More stems than in the row of the next younger age of the class.
std::vector<bool> rises(const std::vector<YieldTableRow>& rows) {
    std::vector<bool> found(rows.size(), false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const YieldTableRow* before = nullptr;
        for (const YieldTableRow& other : rows) {
            if (other.table == rows[i].table &&
                yield_trial::is_same_class(other.site_class, rows[i].site_class) &&
                other.age_years < rows[i].age_years &&
                (before == nullptr || other.age_years > before->age_years)) {
                before = &other;
            }
        }
        found[i] = before != nullptr && rows[i].stems_pha > before->stems_pha;
    }
    return found;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += joined(text.empty() ? "" : ", ", config::in_quotes(word));
    }
    return text;
}

void add_new(std::vector<std::string>& words, const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) {
        words.push_back(word);
    }
}

void check_site(const config::Table& sites, std::size_t row, const YieldSite& site,
                const yield_trial::YieldCase& data, const std::vector<int>& ages_years,
                const std::string& rows_file, config::Problems& problems) {
    std::vector<std::string> tables;
    std::vector<std::string> classes;
    for (const YieldTableRow& published : data.rows) {
        add_new(tables, published.table);
        if (published.table == site.table) {
            add_new(classes, published.site_class);
        }
    }
    if (classes.empty()) {
        problems.add(config::ExitCode::data, sites.place(row, "table"),
                     joined("table ", config::in_quotes(site.table)),
                     joined("one of ", rows_file, ": ", listed(tables), ", or none"));
        return;
    }
    if (std::none_of(classes.begin(), classes.end(), [&](const std::string& name) {
            return yield_trial::is_same_class(name, site.site_class);
        })) {
        problems.add(
            config::ExitCode::data, sites.place(row, "class"),
            joined("class ", config::in_quotes(site.site_class), " of table ", config::in_quotes(site.table)),
            joined("one of ", rows_file, ": ", listed(classes)));
        return;
    }
    if (ages_of(data, site, ages_years).empty()) {
        problems.add(config::ExitCode::data, sites.place(row, "table"),
                     joined("no row of table ", config::in_quotes(site.table), " for site ", site.name,
                            " at an age of yield.ages_years"),
                     joined("a row to start from and one at a later age in ", rows_file));
    }
}

}  // namespace

void warn_of_yield_rows(const config::Table& table, const std::vector<YieldTableRow>& rows,
                        config::Warnings& warnings) {
    const std::vector<bool> rising = rises(rows);
    struct Doubt {
        const char* words;
        const char* advice;
        std::vector<std::size_t> rows{};
    };
    std::array doubts{
        Doubt{"stems and mean diameter that make another basal area", "check stems_pha and mean_dbh_cm (cm)"},
        Doubt{"a mean tree that is less than 15 or more than 150 times as high as thick",
              "check mean_height_m (m) and mean_dbh_cm (cm)"},
        Doubt{"a volume that is less than 0.15 or more than 0.75 of basal area times height",
              "check volume_m3pha and stems_pha: are they swapped?"},
        Doubt{"more stems than at the age before", "check stems_pha and age_years"}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::array<bool, 4> holds{contradicts_basal_area(rows[i]), has_odd_tree(rows[i]),
                                        has_odd_form(rows[i]), rising[i]};
        for (std::size_t k = 0; k < holds.size(); ++k) {
            if (holds[k]) {
                doubts[k].rows.push_back(i);
            }
        }
    }
    if (look_swapped(rows)) {
        warnings.add(joined(table.file(),
                            ": most mean trees of 20 cm or more are more than 105 times as high as thick; "
                            "check whether the columns mean_dbh_cm and mean_height_m are swapped"));
    }
    for (const Doubt& doubt : doubts) {
        if (!doubt.rows.empty()) {
            warnings.add(joined(table.file(), ", line ",
                                std::to_string(table.place(doubt.rows.front(), "age_years").line), ": ",
                                std::to_string(doubt.rows.size()), doubt.rows.size() == 1 ? " row" : " rows",
                                " with ", doubt.words, "; ", doubt.advice));
        }
    }
}

void check_sites(const config::Table& sites, const yield_trial::YieldCase& data,
                 const std::vector<int>& ages_years, const std::string& rows_file,
                 config::Problems& problems) {
    std::map<std::string, std::size_t> first;
    for (std::size_t row = 0; row < data.sites.size(); ++row) {
        const YieldSite& site = data.sites[row];
        if (const auto [known, is_new] = first.emplace(site.name, row); !is_new) {
            problems.add(config::ExitCode::data, sites.place(row, "site"),
                         joined("site ", config::in_quotes(site.name), " a second time, as in line ",
                                std::to_string(sites.place(known->second, "site").line)),
                         "a name of its own for each site");
        }
        if (!site.table.empty()) {
            check_site(sites, row, site, data, ages_years, rows_file, problems);
        }
    }
}

std::vector<int> usual_drawn_ages(const yield_trial::YieldCase& data, const std::vector<int>& ages_years) {
    std::map<int, std::size_t> sites_at;
    for (const YieldSite& site : data.sites) {
        for (const int age_years : ages_of(data, site, ages_years)) {
            ++sites_at[age_years];
        }
    }
    int common_years = ages_years.back();
    for (const auto& [age_years, sites] : sites_at) {
        common_years = sites >= sites_at[common_years] ? age_years : common_years;
    }
    return common_years == ages_years.back() ? std::vector{common_years}
                                             : std::vector{common_years, ages_years.back()};
}

}  // namespace coupling::validation::forest_cases
