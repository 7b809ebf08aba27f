#include "coupling/inputs/formats/layer.hpp"

#include <algorithm>

#include "config/errors/input_error.hpp"

namespace coupling::formats {

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
        text += (i == 0 ? "" : ", ") + config::in_quotes(names[i]);
    }
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

}  // namespace coupling::formats
