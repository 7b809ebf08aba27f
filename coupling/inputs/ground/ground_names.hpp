#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// Ground types by what users call them in a column `surface`: codes of terrain.surface_types, names of
/// shipped types. Shipped types join the list when they are first named; their code is their row in
/// `bannwald info surfaces`, plus a multiple of 100 where another type has it.
class GroundNames {
public:
    /// `elsewhere`: that of terrain.ground, for an empty field.
    GroundNames(std::vector<rockfall::SurfaceType> own, std::optional<rockfall::SurfaceType> elsewhere,
                const config::Options& settings);

    /// Place in the list of types; nothing, and a problem, for what no type is called. A table without the
    /// column is spoken of at the column `other`.
    std::optional<std::uint8_t> place_of(const config::Table& table, std::size_t row,
                                         const std::string& other, config::Problems& problems);
    /// The place of the type of terrain.ground, if there is one.
    [[nodiscard]] std::optional<std::uint8_t> elsewhere() const;
    [[nodiscard]] const std::vector<rockfall::SurfaceType>& types() const { return types_; }
    [[nodiscard]] std::vector<rockfall::SurfaceType> list() && { return std::move(types_); }

private:
    std::optional<std::size_t> own_or_shipped(const std::string& text);
    [[nodiscard]] int free_code(int wanted) const;
    [[nodiscard]] std::string expected(const std::string& text) const;

    std::vector<rockfall::SurfaceType> types_;
    std::size_t own_;
    std::optional<std::size_t> elsewhere_;
    std::vector<ShippedSurface> shipped_;
    std::vector<std::optional<std::size_t>> place_of_shipped_;
};

}  // namespace coupling
