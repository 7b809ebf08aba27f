#include "coupling/program/actions/period_blocks.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "config/text/numbers.hpp"

namespace coupling {
namespace {

std::vector<std::string> lines_of_block(const PeriodBlock& block) {
    std::istringstream stream{block.text};
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty()) {
            lines.push_back(line);
        }
    }
    return lines;
}

}  // namespace

void print_blocks(const std::vector<PeriodBlock>& blocks, std::ostream& out) {
    std::vector<std::vector<std::string>> all;
    std::transform(blocks.begin(), blocks.end(), std::back_inserter(all), lines_of_block);
    const auto is_common = [&](const std::string& line) {
        return all.size() > 1 && std::all_of(all.begin(), all.end(), [&](const auto& lines) {
                   return std::find(lines.begin(), lines.end(), line) != lines.end();
               });
    };
    if (all.size() > 1) {
        out << "Each of the " << all.size() << " return periods\n";
        for (const std::string& line : all.front()) {
            if (is_common(line)) {
                out << line << '\n';
            }
        }
        out << '\n';
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        out << (i > 0 ? "\n" : "") << "Return period of " << config::to_text(blocks[i].years) << " years\n";
        for (const std::string& line : all[i]) {
            if (!is_common(line)) {
                out << line << '\n';
            }
        }
    }
}

}  // namespace coupling
