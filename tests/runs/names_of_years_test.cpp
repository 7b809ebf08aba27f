// Any name in, the same name out: runs over years, along a profile and under regimes. Tables, summary and
// page hold names as they were written, and no run is lost by them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "coupling/inputs/formats/json_library.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/any_names.hpp"
#include "tests/runs/years.hpp"

namespace coupling::names_of_years_test {
namespace {

/// All texts of a JSON file, keys and values.
Names texts_of_json(const SampleProject& project, const std::string& file) {
    Names texts;
    const std::function<void(const Json&)> take = [&](const Json& value) {
        if (value.is_string()) {
            texts.insert(value.get<std::string>());
        }
        if (value.is_object()) {
            for (const auto& [key, inner] : value.items()) {
                texts.insert(key);
                take(inner);
            }
        } else if (value.is_array()) {
            std::for_each(value.begin(), value.end(), take);
        }
    };
    take(Json::parse(project.read(file)));
    return texts;
}

/// The page as a reader sees its texts: without tags' escapes, blanks of any kind as one.
std::string as_seen(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool is_escape = false;
        for (const auto& [escape, letter] : {std::pair{"&lt;", '<'},
                                             {"&gt;", '>'},
                                             {"&amp;", '&'},
                                             {"&quot;", '"'},
                                             {"&#34;", '"'},
                                             {"&#39;", '\''}}) {
            if (text.compare(i, std::string{escape}.size(), escape) == 0) {
                plain += letter;
                i += std::string{escape}.size() - 1;
                is_escape = true;
                break;
            }
        }
        if (is_escape) {
            continue;
        }
        const bool is_blank = text[i] == ' ' || text[i] == '\n' || text[i] == '\r' || text[i] == '\t';
        if (!is_blank || plain.empty() || plain.back() != ' ') {
            plain += is_blank ? ' ' : text[i];
        }
    }
    return plain;
}

void expect_on_page(const SampleProject& project, const std::string& file, const Names& names) {
    const std::string page = project.read(file);
    EXPECT_EQ(text_checks::markup_fault(page), "") << file;
    const std::string seen = as_seen(page);
    for (const std::string& name : names) {
        std::string wanted = as_seen(name);
        wanted = wanted.starts_with(' ') ? wanted.substr(1) : wanted;
        EXPECT_NE(seen.find(wanted), std::string::npos) << file << " lacks " << name;
    }
}

void expect_in_summary(const SampleProject& project, const std::string& file, const Names& names) {
    const Names texts = texts_of_json(project, file);
    for (const std::string& name : names) {
        EXPECT_TRUE(texts.contains(name)) << file << " lacks " << name;
    }
}

/// Each table with the column holds these names and no others, or none where a row is of no target.
void expect_in_each_table(const SampleProject& project, const std::string& folder, const std::string& column,
                          const Names& names) {
    std::size_t tables = 0;
    for (const auto& entry : std::filesystem::directory_iterator{project.file(folder + "/tables")}) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".csv" || !table(project, folder + "/tables/" + name).has(column)) {
            continue;
        }
        ++tables;
        for (const std::string& found : column_of(project, folder, name, column)) {
            EXPECT_TRUE(found.empty() || names.contains(found)) << name << " has " << found;
        }
    }
    EXPECT_GT(tables, 3U);
}

TEST(NamesOfYears, ComeOutOfARunAsTheyWentIn) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        NameMaker make{seed};
        const ForestProject project;
        const Names ids{make.next(), make.next()};
        const Names called{make.next(), make.next()};
        const std::string net = make.next();
        const std::string ground = make.next();
        project.write("targets.csv",
                      "target_id,name,wkt\n" + in_csv(*ids.begin()) + "," + in_csv(*called.begin()) +
                          ",\"LINESTRING (1105 2010, 1105 2090)\"\n" + in_csv(*ids.rbegin()) + "," +
                          in_csv(*called.rbegin()) +
                          ",\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\n");
        project.write("nets.csv", "name,height_m,capacity_kj,wkt\n" + in_csv(net) +
                                      ",3,50,\"LINESTRING (1098 2030, 1098 2060)\"\n");
        project.write("surface_types.csv", "code,label,r_n,r_t,p_stop\n1,rock,0.40,0.90,0.0005\n3," +
                                               in_csv(ground) + ",0.30,0.80,0.01\n");
        const Outcome outcome =
            call(project, std::string{four_members} + "--set run.years=2 --set nets.file=nets.csv");
        ASSERT_EQ(outcome.code, 0) << seed << "\n" << outcome.err;
        EXPECT_EQ(column_of(project, "out", "targets.csv", "target_id"), ids) << seed;
        expect_in_each_table(project, "out", "target_id", ids);
        expect_in_summary(project, "out/summary.json", ids);
        expect_on_page(project, "out/report.html", called);
        const Outcome again = call(project, "compare out out --page page.html");
        EXPECT_EQ(again.code, 0) << seed << "\n" << again.err;
    }
}

TEST(NamesOfRegimes, ComeOutOfTheirWorkAsTheyWentIn) {
    for (unsigned seed = 10; seed < 13; ++seed) {
        NameMaker make{seed};
        const ForestProject project;
        const Names works{make.next(), make.next()};
        project.write("own.csv", "name,treatment,first_year,every_years,share\n" + in_csv(*works.begin()) +
                                     ",thin_below,1,2,0.2\n" + in_csv(*works.rbegin()) +
                                     ",thin_below,2,2,0.1\n");
        const Outcome outcome = call(
            project,
            "run scenario.ini --quiet --set trees.file= --set stands.records=records.csv --set run.years=2 "
            "--set run.rockfall_every=0 --set regimes.list=none,own.csv");
        ASSERT_EQ(outcome.code, 0) << seed << "\n" << outcome.err;
        EXPECT_EQ(column_of(project, "out", "interventions.csv", "intervention"), works) << seed;
        expect_on_page(project, "out/report.html", works);
    }
}

/// Names that become folders are refused before anything is simulated, and the message says which are fit.
TEST(NamesOfRegimes, ThatBecomeFoldersAreRefusedAtOnce) {
    NameMaker make{20};
    for (int trial = 0; trial < 6; ++trial) {
        const ForestProject project;
        const std::string name = make.next() + "\"";
        project.write("climates.csv", "name,temperature_change_k\n" + in_csv(name) + ",2\n");
        const Outcome outcome =
            call(project, std::string{four_members} + "--set climate.variants=climates.csv");
        EXPECT_EQ(outcome.code, 4) << name << outcome.err;
        EXPECT_NE(outcome.err.find("climates.csv:2:1: found name "), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(project.file("out"))) << name;
    }
}

TEST(NamesOfAProfile, ComeOutOfTheRunAsTheyWentIn) {
    for (unsigned seed = 30; seed < 36; ++seed) {
        NameMaker make{seed};
        const SampleProject project;
        make_profile_project(project);
        const Names stations{make.next(), make.next()};
        const std::string ground = make.next();
        project.write("stations.csv", "name,distance_m\n" + in_csv(*stations.begin()) + ",102\n" +
                                          in_csv(*stations.rbegin()) + ",240\n");
        project.write("surface_types.csv", "code,label,r_n,r_t,p_stop\n1,rock,0.40,0.90,0.0005\n3," +
                                               in_csv(ground) + ",0.30,0.80,0.01\n");
        const Outcome outcome = call(project, "run scenario.ini --quiet --set output.xlsx=yes");
        ASSERT_EQ(outcome.code, 0) << seed << "\n" << outcome.err;
        EXPECT_EQ(column_of(project, "out", "stations.csv", "station"), stations) << seed;
        expect_in_summary(project, "out/summary.json", stations);
        Names shown = stations;
        shown.insert(ground);
        expect_on_page(project, "out/report.html", shown);
        const Outcome again = call(project, "compare out out --page page.html");
        EXPECT_EQ(again.code, 0) << seed << "\n" << again.err;
    }
}

}  // namespace
}  // namespace coupling::names_of_years_test
