// What is said of a table of nets does not depend on the order of its rows, on the end from which a line was
// drawn, or on how the map lies: each fault is found wherever it stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/coupling/inputs/plausible/turned.hpp"

namespace coupling::net_rules_test {
namespace {

using plausible::Turn;
using Line = std::vector<Eigen::Vector2d>;

struct GivenNet {
    std::string name;
    std::string height_m;
    std::string capacity_kj;
    Line line_m;
};

/// Nets on a square of 200 m about (0, 0) and its heights, which have a hole.
struct GivenSite {
    config::Raster<double> heights;
    std::vector<GivenNet> nets;
};

config::Raster<double> heights_with_hole() {
    config::GridFrame frame{.columns = 20, .rows = 20, .x_west_m = -100.0, .y_south_m = -100.0};
    frame.cell_width_m = 10.0;
    frame.cell_height_m = 10.0;
    config::Raster<double> heights{frame, 0.0};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const bool is_hole = cell.column >= 14 && cell.column < 17 && cell.row >= 3 && cell.row < 6;
        heights.values[i] =
            is_hole ? std::numeric_limits<double>::quiet_NaN() : 500.0 - 6.0 * cell.column + 1.0 * cell.row;
    }
    return heights;
}

/// Nets that are right: one to three pieces each, in lanes of 8 m in the south, out of each other's way.
std::vector<GivenNet> right_nets(std::mt19937& random) {
    const auto draw = [&](double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(random);
    };
    std::vector<GivenNet> nets;
    for (int lane = 0; lane < 8; ++lane) {
        const double x_m = -80.0 + 8.0 * lane;
        Line line;
        double y_m = draw(-85.0, -60.0);
        for (int corner = std::uniform_int_distribution{2, 4}(random); corner > 0; --corner) {
            line.push_back({x_m + draw(0.0, 5.0), y_m});
            y_m += draw(5.0, 20.0);
        }
        nets.push_back({"net " + std::to_string(lane), "3", std::to_string(100 * (lane + 1)), line});
    }
    return nets;
}

/// One fault of each kind that the rules know.
std::vector<GivenNet> faulty_nets() {
    return {{"in joules", "3", "500000", {{0.0, -80.0}, {0.0, -60.0}}},
            {"in hundreds", "3", "20000", {{5.0, -80.0}, {5.0, -60.0}}},
            {"in tonnes", "3", "5", {{10.0, -80.0}, {10.0, -60.0}}},
            {"in decimetres", "0.3", "500", {{15.0, -80.0}, {15.0, -60.0}}},
            {"first", "4", "500", {{30.0, -80.0}, {30.0, -50.0}}},
            {"same", "4", "700", {{30.0, -80.0}, {30.0, -50.0}}},
            {"longer", "4", "500", {{40.0, -80.0}, {50.0, -60.0}, {50.0, -20.0}}},
            {"within", "4", "500", {{50.003, -50.0}, {49.996, -30.0}, {55.0, -25.0}}},
            {"Upper Net", "4", "500", {{60.0, -80.0}, {60.0, -50.0}}},
            {"upper  net", "4", "500", {{65.0, -80.0}, {65.0, -50.0}}},
            {"knotted", "4", "500", {{0.0, 0.0}, {0.0, 20.0}, {10.0, 15.0}, {-10.0, 10.0}}},
            {"too short", "4", "500", {{70.0, 0.0}, {70.0, 0.05}}},
            {"over the rim", "4", "500", {{-80.0, 20.0}, {-120.0, 30.0}}},
            {"elsewhere", "4", "500", {{-8000.0, 20.0}, {-8010.0, 30.0}}},
            {"over the hole", "4", "500", {{20.0, 55.0}, {90.0, 55.0}}}};
}

std::string number_text(double value) {
    return config::to_text(value);
}

config::Table table_of(const std::vector<GivenNet>& nets) {
    std::ostringstream text;
    text << "name,height_m,capacity_kj,wkt\n";
    for (const GivenNet& net : nets) {
        text << net.name << ',' << net.height_m << ',' << net.capacity_kj << ",\"LINESTRING (";
        for (std::size_t i = 0; i < net.line_m.size(); ++i) {
            text << (i > 0 ? ", " : "") << number_text(net.line_m[i].x()) << ' '
                 << number_text(net.line_m[i].y());
        }
        text << ")\"\n";
    }
    std::istringstream in{text.str()};
    return config::Table::read(in, "nets.csv");
}

/// "in the place of: first, same": a message without what depends on the order of rows and of corners.
std::string answer_of(const config::Problem& problem, const std::vector<GivenNet>& nets) {
    const std::string& own = nets.at(problem.place.line - 2).name;
    std::string kind = problem.found;
    std::set<std::string> names{own};
    for (const GivenNet& net : nets) {
        if (const auto at = kind.find("'" + net.name + "'"); at != std::string::npos) {
            kind.erase(at, net.name.size() + 2);
            names.insert(net.name);
        }
    }
    for (const char* rest : {" of line ", " at x ", "; the net spans "}) {
        const auto at = kind.find(rest);
        const auto over = kind.find(" over ");
        kind = kind.substr(0, at) +
               (at != std::string::npos && over != std::string::npos ? kind.substr(over) : "");
    }
    if (const auto cause = kind.find(": "); cause != std::string::npos) {
        kind.resize(cause);
    }
    for (const std::string& name : names) {
        kind += " | " + name;
    }
    return kind;
}

using Answers = std::multiset<std::string>;

/// What is refused of the table and on the terrain, and what is warned of.
Answers answers_to(const GivenSite& site) {
    Answers answers;
    const auto take = [&](const config::Problem& problem) { answers.insert(answer_of(problem, site.nets)); };
    const config::Table table = table_of(site.nets);
    try {
        std::ignore = nets_of(table);
    } catch (const config::InputError& error) {
        std::for_each(error.problems().begin(), error.problems().end(), take);
    }
    // What stands on the terrain is asked of nets that can be read; each alone, so that one fault hides none.
    const rockfall::Terrain terrain = rockfall::triangulate(site.heights, 0.0);
    std::vector<GivenNet> readable;
    std::copy_if(site.nets.begin(), site.nets.end(), std::back_inserter(readable), [](const GivenNet& net) {
        return net.name != "knotted" && net.name != "too short" && net.name != "in joules";
    });
    const config::Table readable_table = table_of(readable);
    GivenNets given = nets_of(readable_table, Standing::each_alone);
    for (const config::Problem& problem : net_warnings(readable_table, given.nets)) {
        answers.insert(answer_of(problem, readable));
    }
    config::Problems problems;
    on_terrain(std::move(given), terrain, problems);
    for (const config::Problem& problem : problems.list()) {
        answers.insert(answer_of(problem, readable));
    }
    return answers;
}

std::string in_words(const Answers& answers) {
    std::string words;
    for (const std::string& answer : answers) {
        words += answer + "\n";
    }
    return words;
}

GivenSite turned(const GivenSite& site, const Turn& turn) {
    GivenSite result{turn.of(site.heights), site.nets};
    for (GivenNet& net : result.nets) {
        for (Eigen::Vector2d& corner : net.line_m) {
            corner = turn.of(corner);
        }
    }
    return result;
}

GivenSite site_of(std::mt19937& random) {
    GivenSite site{heights_with_hole(), right_nets(random)};
    for (GivenNet& net : faulty_nets()) {
        site.nets.push_back(std::move(net));
    }
    return site;
}

TEST(NetRules, FindEachFaultAndNothingElse) {
    std::mt19937 random{1};
    const GivenSite site = site_of(random);
    EXPECT_EQ(in_words(answers_to(site)),
              "a net of 0.3 m | in decimetres\n"
              "a net of length 0.05 m | too short\n"
              "a net that takes 20000 kJ | in hundreds\n"
              "a net that takes 5 kJ | in tonnes\n"
              "a net that takes 500000 kJ, which looks like joules | in joules\n"
              "name  beside  | Upper Net | upper  net\n"
              "net  crosses or touches itself | knotted\n"
              // 20 m, and 2 cm of the piece that turns away from within a centimetre
              "net  in the place of net  over 20.02 m | longer | within\n"
              "net  in the place of net  over 30 m | first | same\n"
              "net  leaves the terrain | over the hole\n"
              "net  leaves the terrain | over the rim\n"
              "net  outside the terrain | elsewhere\n");
    EXPECT_EQ(in_words(answers_to({site.heights, right_nets(random)})), "");
}

TEST(NetRules, AnswerTheSameForTurnedMirroredShuffledAndReversedNets) {
    std::mt19937 random{2};
    for (int trial = 0; trial < 20; ++trial) {
        GivenSite site = site_of(random);
        const std::string expected = in_words(answers_to(site));
        for (const Turn& turn : plausible::all_turns()) {
            std::shuffle(site.nets.begin(), site.nets.end(), random);
            for (GivenNet& net : site.nets) {
                if (random() % 2 == 0) {
                    std::reverse(net.line_m.begin(), net.line_m.end());
                }
            }
            ASSERT_EQ(in_words(answers_to(turned(site, turn))), expected)
                << "trial " << trial << ", " << turn.quarters << " quarters, mirrored " << turn.mirrored;
        }
    }
}

/// A line with more corners on it is the same line.
TEST(NetRules, AnswerTheSameForLinesWithMoreCorners) {
    std::mt19937 random{3};
    const GivenSite site = site_of(random);
    const std::string expected = in_words(answers_to(site));
    for (const double step_m : {5.0, 0.5}) {
        GivenSite denser = site;
        for (GivenNet& net : denser.nets) {
            Line line{net.line_m.front()};
            for (std::size_t i = 1; i < net.line_m.size(); ++i) {
                const Eigen::Vector2d from = net.line_m[i - 1];
                const Eigen::Vector2d way = net.line_m[i] - from;
                const int pieces = static_cast<int>(std::clamp(std::ceil(way.norm() / step_m), 1.0, 1000.0));
                for (int k = 1; k <= pieces; ++k) {
                    // Rounded to a millimetre, as a drawing program writes it.
                    const Eigen::Vector2d place = from + static_cast<double>(k) / pieces * way;
                    line.push_back({1e-3 * std::round(1e3 * place.x()), 1e-3 * std::round(1e3 * place.y())});
                }
            }
            net.line_m = line;
        }
        EXPECT_EQ(in_words(answers_to(denser)), expected) << step_m;
    }
}

}  // namespace
}  // namespace coupling::net_rules_test
