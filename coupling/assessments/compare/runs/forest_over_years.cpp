#include "coupling/assessments/compare/runs/forest_over_years.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/runs/means_over_years.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"

namespace coupling::compare {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// A regime in a climate with one stream of chances.
struct Member {
    std::string regime;
    std::string climate;
    std::string replicate;

    friend auto operator<=>(const Member&, const Member&) = default;

    [[nodiscard]] FigureKey key(const std::string& quantity, const char* when) const {
        return {"", regime, quantity, when, climate};
    }
};

Member member_of(const config::Table& table, std::size_t row) {
    return {table.text(row, "regime"), climate_of(table, row), table.text(row, "replicate")};
}

/// Parts of a whole by name, of all members: species, causes of death, kinds of work. What a member lacks is
/// 0.
class ByName {
public:
    void add(const std::string& name, const Member& member, double value) {
        if (std::find(names_.begin(), names_.end(), name) == names_.end()) {
            names_.push_back(name);
        }
        values_[{name, member}] += value;
    }
    void give(const std::vector<Member>& members, const char* when, MeansOverYears& means) const {
        for (const std::string& name : names_) {
            for (const Member& member : members) {
                const auto found = values_.find({name, member});
                const FigureKey key = member.key(name, when);
                means.add(key, member.replicate, found == values_.end() ? 0.0 : found->second);
                means.mark_as_part(key);
            }
        }
    }

private:
    std::vector<std::string> names_;  ///< as they came
    std::map<std::pair<std::string, Member>, double> values_;
};

/// Returns the members of the run.
std::vector<Member> add_stands(const fs::path& folder, std::uint32_t years, MeansOverYears& means) {
    const config::Table table =
        read_table(folder, "stands.csv",
                   {"regime", "replicate", "year", "stand", "species", "basal_area_m2pha", "volume_m3pha"});
    const std::string last = std::to_string(years);
    std::vector<Member> members;
    ByName species_at_the_end;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "stand") != "all") {
            continue;
        }
        const Member member = member_of(table, row);
        const std::string& species = table.text(row, "species");
        // Also of species that are gone by then, so that their 0 stands beside what another run kept.
        const bool is_last = table.text(row, "year") == last;
        const double volume_m3pha = number(table, row, "volume_m3pha");
        if (species != "all") {
            species_at_the_end.add(joined("volume_", species, "_m3pha"), member,
                                   is_last ? volume_m3pha : 0.0);
            continue;
        }
        if (std::find(members.begin(), members.end(), member) == members.end()) {
            members.push_back(member);
        }
        for (const char* figure : {"basal_area_m2pha", "volume_m3pha"}) {
            const double value = number(table, row, figure);
            means.add(member.key(figure, over_years), member.replicate, value);
            if (is_last) {
                means.add(member.key(figure, last_year), member.replicate, value);
            }
        }
    }
    species_at_the_end.give(members, last_year, means);
    return members;
}

void add_dead_wood_and_young(const fs::path& folder, MeansOverYears& means) {
    const config::Table table = read_table(
        folder, "forest_years.csv",
        {"regime", "replicate", "snags_m3pha", "logs_m3pha", "saplings_pha", "ingrowth_stems_pha"});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const Member member = member_of(table, row);
        for (const char* figure : {"snags_m3pha", "logs_m3pha", "saplings_pha", "ingrowth_stems_pha"}) {
            means.add(member.key(figure, over_years), member.replicate, number(table, row, figure));
        }
    }
}

/// What was felled belongs to add_work().
void add_deaths(const fs::path& folder, std::uint32_t years, const std::vector<Member>& members,
                MeansOverYears& means) {
    const config::Table table =
        read_table(folder, "mortality.csv", {"regime", "replicate", "cause", "volume_m3pha"});
    ByName a_year;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& cause = table.text(row, "cause");
        if (cause != "felled") {
            a_year.add(joined("died_", cause, "_m3pha"), member_of(table, row),
                       number(table, row, "volume_m3pha") / static_cast<double>(years));
        }
    }
    a_year.give(members, over_years, means);
}

/// Timber and money; the work of the start counts in the first year.
void add_work(const fs::path& folder, std::uint32_t years, const std::vector<Member>& members,
              MeansOverYears& means) {
    static const std::vector<std::string> figures{"felled_m3pha", "salvaged_m3pha", "removed_m3pha",
                                                  "left_m3pha", "contribution_margin_eur_pha"};
    std::vector<std::string> columns{"regime", "replicate"};
    columns.insert(columns.end(), figures.begin(), figures.end());
    const config::Table table = read_table(folder, "work_by_year.csv", columns);
    ByName a_year;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const std::string& figure : figures) {
            a_year.add(figure, member_of(table, row),
                       number(table, row, figure) / static_cast<double>(years));
        }
    }
    a_year.give(members, over_years, means);
}

}  // namespace

void add_forest_over_years(const fs::path& folder, std::uint32_t years, std::vector<Figure>& figures) {
    MeansOverYears means{figures};
    const std::vector<Member> members = add_stands(folder, years, means);
    add_dead_wood_and_young(folder, means);
    add_deaths(folder, years, members, means);
    add_work(folder, years, members, means);
    means.finish();
}

}  // namespace coupling::compare
