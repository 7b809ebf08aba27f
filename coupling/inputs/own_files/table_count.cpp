#include "coupling/inputs/own_files/table_count.hpp"

#include <algorithm>
#include <string_view>

namespace coupling {

void TableCount::add(const char* text, std::size_t count) {
    bytes_ += count;
    for (std::string_view rest{text, count}; !rest.empty();) {
        const std::size_t quote = std::min(rest.find('"'), rest.size());
        if (!in_quotes_) {
            lines_ += static_cast<std::uint64_t>(
                std::count(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(quote), '\n'));
        }
        in_quotes_ = in_quotes_ != (quote < rest.size());
        rest.remove_prefix(std::min(quote + 1, rest.size()));
    }
}

}  // namespace coupling
