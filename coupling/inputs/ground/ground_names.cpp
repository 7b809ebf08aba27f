#include "coupling/inputs/ground/ground_names.hpp"

#include <algorithm>
#include <utility>

#include "config/text/numbers.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {
namespace {

constexpr std::size_t most_named_types = 255;  // the map keeps a byte for each cell

}  // namespace

GroundNames::GroundNames(std::vector<rockfall::SurfaceType> own,
                         std::optional<rockfall::SurfaceType> elsewhere, const config::Options& settings)
    : types_{std::move(own)},
      own_{types_.size()},
      shipped_{shipped_surfaces(settings)},
      place_of_shipped_(shipped_.size()) {
    if (elsewhere) {
        elsewhere_ = types_.size();
        types_.push_back(std::move(*elsewhere));
    }
}

std::optional<std::uint8_t> GroundNames::place_of(const config::Table& table, std::size_t row,
                                                  const std::string& other, config::Problems& problems) {
    const std::string text = table.has("surface") ? table.text(row, "surface") : "";
    const std::optional<std::size_t> place = text.empty() ? elsewhere_ : own_or_shipped(text);
    if (place && *place < most_named_types) {
        return static_cast<std::uint8_t>(*place);
    }
    problems.add(config::ExitCode::data, table.place(row, table.has("surface") ? "surface" : other),
                 text.empty() ? "no ground type" : "surface " + config::in_quotes(text), expected(text));
    return std::nullopt;
}

std::optional<std::uint8_t> GroundNames::elsewhere() const {
    return elsewhere_ ? std::optional{static_cast<std::uint8_t>(*elsewhere_)} : std::nullopt;
}

std::optional<std::size_t> GroundNames::own_or_shipped(const std::string& text) {
    if (const auto code = config::parse_whole(text)) {
        for (std::size_t i = 0; i < own_; ++i) {
            if (types_[i].code == *code) {
                return i;
            }
        }
        return std::nullopt;
    }
    for (std::size_t i = 0; i < shipped_.size(); ++i) {
        if (shipped_[i].name == text) {
            if (!place_of_shipped_[i]) {
                place_of_shipped_[i] = types_.size();
                types_.push_back(shipped_[i].type);
                types_.back().code = free_code(static_cast<int>(i) + 1);
            }
            return place_of_shipped_[i];
        }
    }
    return std::nullopt;
}

int GroundNames::free_code(int wanted) const {
    const auto is_taken = [&](int code) {
        return std::any_of(types_.begin(), types_.end(),
                           [&](const rockfall::SurfaceType& type) { return type.code == code; });
    };
    while (is_taken(wanted)) {
        wanted += 100;
    }
    return wanted;
}

std::string GroundNames::expected(const std::string& text) const {
    if (text.empty()) {
        return "a shipped ground type or a code in a column surface, or terrain.ground";
    }
    std::vector<std::string> names;
    for (const ShippedSurface& surface : shipped_) {
        names.push_back(surface.name);
    }
    const std::string nearest = config::nearest_word(text, names);
    return "a name of `bannwald info surfaces` or a code of terrain.surface_types" +
           (nearest.empty() ? "" : " (" + nearest + "?)");
}

}  // namespace coupling
