// Pages say what their tables say: each number of a page is computed once more from the tables of the run.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"
#include "tests/runs/page_figures/figure_rules.hpp"
#include "tests/runs/years.hpp"

namespace coupling::page_figures {
namespace {

/// Two return periods above a road, a house and a brook, with trees, nets, a design and risk.
void fill(const SampleProject& project) {
    project.write("scenario.ini",
                  "[terrain]\ndem = dem.asc\nsurface = surface.asc\nsurface_types = surface_types.csv\n"
                  "[trees]\nfile = trees.csv\n[release]\nsource = source.asc\nrocks = 1200\n"
                  "[nets]\nfile = nets.csv\nkeep_paths = yes\n"
                  "[design]\nrule = own\nenergy_factor = 1.2\nheight_factor = 1.1\nfreeboard_m = 0.5\n"
                  "[hazard]\nblocks = blocks.csv\n"
                  "[risk]\nassess = yes\ncurves = curves.csv\nprevented_death = 4e6\nclosure_days = 0.5\n"
                  "closure_cost_per_day = 3000\n[targets]\nfile = targets.csv\n");
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n100,1,0.8\n");
    project.write("curves.csv",
                  "energy_from_kj,lethality_in_vehicle,lethality_in_house,damage_to_house\n0,0.1,0.001,0.01\n"
                  "5,0.3,0.01,0.05\n40,0.6,0.1,0.3\n");
    project.write("nets.csv",
                  "name,height_m,capacity_kj,class,gap_m,wkt\n"
                  "upper,1.2,40,,0.1,\"LINESTRING (1075 2010, 1078 2050, 1075 2090)\"\n"
                  "lower,3,,1,,\"LINESTRING (1098 2005, 1098 2035)\"\n");
    project.write("targets.csv",
                  "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle,persons,hours_per_day,"
                  "house_value\nRoad,Road,\"LINESTRING (1105 2010, 1105 2090)\",1200,60,1.6,,,\n"
                  "House,House,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\",,,,4,16,"
                  "900000\nBrook,Brook,\"LINESTRING (1100 2010, 1100 2090)\",,,,,,\n");
    project.write("others.csv",
                  "name,height_m,capacity_kj,gap_m,wkt\n"
                  "new,2,100,0.1,\"LINESTRING (1085 2010, 1086 2050, 1085 2090)\"\n"
                  "weak,1,10,,\"LINESTRING (1095 2020, 1095 2080)\"\n");
    project.write("road.csv", "name,wkt\nRoad,\"LINESTRING (1105 2010, 1105 2090)\"\n");
    std::ostringstream trees;
    trees << "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int tree = 0; tree < 72; ++tree) {
        trees << tree + 1 << ',' << 1042 + tree % 8 * 6 << ',' << 2022 + tree / 8 * 7 << ','
              << std::vector{"ABAL", "PIAB", "FASY"}.at(static_cast<std::size_t>(tree % 3)) << ','
              << 15.5 + tree * 7 % 40 << ',' << 18 + tree % 9 << '\n';
    }
    project.write("trees.csv", trees.str());
}

/// Tables of a folder of results, read once.
class TablesOf {
public:
    TablesOf(const SampleProject& project, std::string folder, std::string tables)
        : project_{project}, folder_{std::move(folder)}, tables_{std::move(tables)} {}
    const config::Table& operator()(const std::string& name) {
        const auto known = read_.find(name);
        if (known != read_.end()) {
            return known->second;
        }
        // "return_period_100/targets" is a table of a return period, which lies beside.
        const std::size_t slash = name.find('/');
        const std::string file = slash == std::string::npos ? folder_ + tables_ + name
                                                            : folder_ + "/../" + name.substr(0, slash) +
                                                                  tables_ + name.substr(slash + 1);
        return read_.emplace(name, table(project_, file + ".csv")).first->second;
    }

private:
    const SampleProject& project_;
    std::string folder_;
    std::string tables_;
    std::map<std::string, config::Table> read_;
};

Rules rules_of(std::initializer_list<const char*> names) {
    Rules rules;
    for (const char* name : names) {
        std::ifstream file{std::string{BANNWALD_SOURCE_DIR "/tests/runs/page_figures/"} + name + ".rules"};
        std::ostringstream text;
        text << file.rdbuf();
        add_rules(text.str(), rules);
    }
    return rules;
}

std::string lines_of(const std::vector<std::string>& faults) {
    std::string text;
    for (const std::string& fault : faults) {
        text += fault + "\n";
    }
    return text;
}

/// Kinds of pages: where they lie, what their figures come from, how many figures they have at least.
struct Kind {
    std::string name;
    std::string folder;
    std::string tables;
    Rules rules;
    std::size_t least_figures;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"today", "out/return_period_100", "/tables/", rules_of({"common", "today", "nets"}), 300},
        {"hazard", "out/hazard", "/tables/", rules_of({"common", "hazard"}), 100},
        {"net place", "placed", "/", rules_of({"common", "net_place"}), 80},
        {"net try", "tried", "/", rules_of({"common", "net_try"}), 40}};
    return all;
}

/// The page with the first energy that it judges changed.
std::string with_another_energy(std::string page, const std::vector<CheckedFigure>& figures) {
    for (const CheckedFigure& figure : figures) {
        for (const char* unit : {"\u00a0kJ", " kJ"}) {
            const std::size_t at = page.find(figure.shown + unit);
            if (!figure.figure.is_of_map && at != std::string::npos &&
                figure.text.find(figure.shown + " kJ") != std::string::npos) {
                return page.replace(at, figure.shown.size(), changed(figure.shown, figure.figure.rounding));
            }
        }
    }
    return page;
}

/// How a figure is shown, by its value in the tables, and the sentence that showed it first.
using Digits = std::map<std::string, std::pair<std::string, std::string>>;

/// Counts and settings have few digits, and may be equal by chance.
bool is_result(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return std::abs(value - unit * std::round(value / unit)) > 1e-6 * std::abs(value);
}

/// The same figure has the same digits wherever pages show it.
void expect_same_digits(const std::vector<CheckedFigure>& figures, Digits& digits) {
    for (const CheckedFigure& figure : figures) {
        const double value = figure.figure.value;
        if (figure.figure.is_of_map || figure.shown == "–" || value == std::round(value) ||
            !is_result(value)) {
            continue;
        }
        const auto [first, is_new] =
            digits.try_emplace(config::to_text(value), std::pair{figure.shown, figure.text});
        EXPECT_TRUE(is_new || first->second.first == figure.shown)
            << figure.shown << " in " << figure.text << "\n"
            << first->second.first << " in " << first->second.second;
    }
}

/// Holds each figure of a page against the tables, and lets each rule find out another number.
void expect_figures_of_tables(const SampleProject& project, const Kind& kind, Digits& digits) {
    TablesOf tables{project, kind.folder, kind.tables};
    const std::string page = project.read(kind.folder + "/report.html");
    const Judged judged = judge(page, kind.rules, std::ref(tables));
    EXPECT_TRUE(judged.faults.empty()) << kind.name << ":\n" << lines_of(judged.faults);
    EXPECT_GE(judged.figures.size(), kind.least_figures) << kind.name;
    expect_same_digits(judged.figures, digits);
    const std::set<std::string> used{judged.used.begin(), judged.used.end()};
    for (const FigureRule& rule : kind.rules.figures) {
        EXPECT_TRUE(!rule.is_always_there || used.contains(rule.pattern))
            << kind.name << ": no sentence of the page has this form: " << rule.pattern;
    }
    for (const CheckedFigure& each : judged.figures) {
        const std::string other = changed(each.shown, each.figure.rounding);
        EXPECT_TRUE(each.figure.is_of_map || !agree(other, each.figure))
            << other << " for " << each.shown << " in " << each.text;
    }
    const Judged wrong = judge(with_another_energy(page, judged.figures), kind.rules, std::ref(tables));
    EXPECT_FALSE(wrong.faults.empty()) << kind.name;
}

TEST(PageFigures, AreThoseOfTheTables) {
    const SampleProject project;
    fill(project);
    const Outcome run = call(project, "run scenario.ini --quiet --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const Outcome placed = call(project, "net place out/return_period_100 --nets road.csv --out placed");
    ASSERT_EQ(placed.code, 0) << placed.err;
    const Outcome tried = call(project, "net try out/return_period_100 --nets others.csv --out tried");
    ASSERT_EQ(tried.code, 0) << tried.err;
    Digits digits;
    for (const Kind& kind : kinds()) {
        expect_figures_of_tables(project, kind, digits);
    }
}

/// A number in a drawing that the tables do not have is found out.
TEST(PageFigures, OfDrawingsAreJudged) {
    const SampleProject project;
    fill(project);
    const Outcome run = call(project, "run scenario.ini --quiet --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string folder = "out/return_period_100";
    TablesOf tables{project, folder, "/tables/"};
    const Rules rules = rules_of({"common", "today", "nets"});
    const std::string page = project.read(folder + "/report.html");
    ASSERT_TRUE(judge(page, rules, std::ref(tables)).faults.empty());
    std::size_t changes = 0;
    for (const CheckedFigure& figure : judge(page, rules, std::ref(tables)).figures) {
        const std::size_t at = page.find(">" + figure.shown + "\u00a0%</text>");
        if (figure.text.starts_with("with forest | ") && at != std::string::npos) {
            std::string wrong = page;
            wrong.replace(at + 1, figure.shown.size(), changed(figure.shown, figure.figure.rounding));
            EXPECT_FALSE(judge(wrong, rules, std::ref(tables)).faults.empty()) << figure.shown;
            ++changes;
        }
    }
    EXPECT_GE(changes, 4U);
}

TEST(PageFigures, OverYearsAreThoseOfTheTables) {
    const ForestProject project;
    const Outcome run = call(project, std::string{four_members} + "--out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const Kind years{"years", "out", "/tables/", rules_of({"common", "years"}), 900};
    Digits digits;
    expect_figures_of_tables(project, years, digits);
    // A figure of the decision, one of its tables of years and one of the forest.
    TablesOf tables{project, years.folder, years.tables};
    const std::string page = project.read("out/report.html");
    for (const auto& [shown, other] :
         std::vector<std::pair<std::string, std::string>>{{"78.1", "79.3"}, {"27.2", "29.2"}}) {
        std::string wrong = page;
        const std::size_t at = wrong.find(shown);
        ASSERT_NE(at, std::string::npos) << shown;
        wrong.replace(at, shown.size(), other);
        EXPECT_FALSE(judge(wrong, years.rules, std::ref(tables)).faults.empty()) << shown;
    }
}

}  // namespace
}  // namespace coupling::page_figures
