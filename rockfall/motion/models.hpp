#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "rockfall/motion/classical/model.hpp"
#include "rockfall/motion/picus/model.hpp"
#include "rockfall/motion/pir3d/model.hpp"
#include "rockfall/motion/rigid/model.hpp"
#include "rockfall/motion/seam/description.hpp"

namespace rockfall {

/// The list of motion models, in the order of help, tables and pages; the first is the default.
///
/// A model is a room below motion/ with a struct `Model` (model.hpp), its entry here: its description, the
/// ground figures it uses, its settings (parameters.cpp), and three types. `Law` holds its settings as they
/// are used, `Written` those that users write otherwise. `Motion` is made for one rock from the law, the
/// rock's stream key and the rock. It offers:
///   next_draws()                        what chance gives to the next ground contact
///   touch(velocity, spin, normal, surface, draws) -> Contact   meets the ground
///   begin_rolling(speed)                the rock now moves on the ground
///   rolling_spin_radps(speed)           its spin there
///   lift_off(velocity, normal, surface) the velocity with which it leaves even ground by itself, if it does
///   next_piece(terrain, triangle, face, position, velocity, surface)
///                                       moves on: a RollingPiece or one's heir
///   caught_on_the_way(surface, piece)   the share of the piece after which the ground catches it, if it does
///   way_over_edge(velocity, next_normal, surface) -> EdgeWay
///   slides                              whether rocks slide on the ground or roll; a groove whose faces a
///                                       sliding rock strikes in turn leads it on
///   groove_law(surface), most_impacts()
/// The event loop (trajectory.hpp) does all else and is compiled once for each model: no call is virtual. A
/// model whose rocks need another loop specialises Fall for its Motion instead (rigid/fall.hpp).
using MotionModels = std::tuple<picus::Model, pir3d::Model, classical::Model, rigid::Model>;

/// An entry of the list, by its place there; the default one unless it is set.
enum class MotionModel : std::uint8_t {};

/// The place of a model in the list.
template <class Model, std::size_t place = 0>
constexpr std::size_t find_place() {
    if constexpr (std::is_same_v<Model, std::tuple_element_t<place, MotionModels>>) {
        return place;
    } else {
        return find_place<Model, place + 1>();
    }
}
template <class Model>
inline constexpr std::size_t place_in_list = find_place<Model>();
template <class Model>
inline constexpr MotionModel motion_model = static_cast<MotionModel>(place_in_list<Model>);

constexpr std::size_t to_place(MotionModel model) {
    return static_cast<std::size_t>(model);
}

/// Calls `with` for each model of the list, with its type.
template <class With>
void for_each_model(With&& with) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
        (with(std::type_identity<std::tuple_element_t<place, MotionModels>>{}), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<MotionModels>>{});
}

/// A tuple of what `Of` names of each model.
template <template <class> class Of, class Models = MotionModels>
struct EachModel;
template <template <class> class Of, class... Model>
struct EachModel<Of, std::tuple<Model...>> {
    using type = std::tuple<typename Of<Model>::type...>;
};
template <class Model>
struct LawOf : std::type_identity<typename Model::Law> {};
template <class Model>
struct WrittenOf : std::type_identity<typename Model::Written> {};

/// Memory that the falls of a model reuse: its `Scratch`, if it has one.
struct NoScratch {};
template <class Model>
struct ScratchOf : std::type_identity<NoScratch> {};
template <class Model>
requires requires {
    typename Model::Scratch;
}
struct ScratchOf<Model> : std::type_identity<typename Model::Scratch> {};

/// Which model moves the rocks, and the laws of all.
struct MotionLaws {
    MotionModel model{};
    EachModel<LawOf>::type laws;

    template <class Model>
    [[nodiscard]] typename Model::Law& of() {
        return std::get<place_in_list<Model>>(laws);
    }
    template <class Model>
    [[nodiscard]] const typename Model::Law& of() const {
        return std::get<place_in_list<Model>>(laws);
    }
};

/// Calls `with` with the type of the chosen model and its law. What it returns must not depend on the model.
template <std::size_t place = 0, class With>
decltype(auto) with_model(const MotionLaws& laws, With&& with) {
    using Model = std::tuple_element_t<place, MotionModels>;
    if constexpr (place + 1 < std::tuple_size_v<MotionModels>) {
        if (to_place(laws.model) != place) {
            return with_model<place + 1>(laws, std::forward<With>(with));
        }
    }
    return with(std::type_identity<Model>{}, laws.of<Model>());
}

/// All models, in the order of the list.
const std::vector<MotionModel>& all_models();

const ModelDescription& description_of(MotionModel model);

/// The names of the ground figures that a model uses, in its order.
std::vector<GroundColumnText> ground_columns_of(MotionModel model);

/// The ground figures that the chosen model uses of a ground type, in the order of `ground_columns_of`, for a
/// rock of this diameter.
std::vector<double> ground_figures(const SurfaceType& type, const MotionLaws& laws, double diameter_m);

/// What the chosen model does badly on this slope, in sentences for users; most models have nothing to say.
/// `drop_m`: from the highest source to the lowest ground. A model says it in
/// `static std::vector<std::string> doubts(const Slope&, double drop_m, const Law&)`, which it may leave out.
std::vector<std::string> doubts_of(const MotionLaws& laws, const Slope& slope, double drop_m);

/// Settings of any model that do nothing but turn rocks sideways.
std::vector<std::string> sideways_settings();

/// What kinetic energies count under each model, for texts that hold for any:
/// "translation and rotation; pir3d, classical: translation alone".
std::string what_energies_count();

}  // namespace rockfall
