#include "rockfall/motion/models.hpp"

#include <algorithm>

namespace rockfall {

const std::vector<MotionModel>& all_models() {
    static const std::vector<MotionModel> models = [] {
        std::vector<MotionModel> all;
        for_each_model([&]<class Model>(std::type_identity<Model>) { all.push_back(motion_model<Model>); });
        return all;
    }();
    return models;
}

const ModelDescription& description_of(MotionModel model) {
    const MotionLaws laws{.model = model, .laws = {}};
    return with_model(laws,
                      []<class Model>(std::type_identity<Model>, const auto&) -> const ModelDescription& {
                          return Model::description();
                      });
}

std::vector<GroundColumnText> ground_columns_of(MotionModel model) {
    const MotionLaws laws{.model = model, .laws = {}};
    return with_model(laws, []<class Model>(std::type_identity<Model>, const auto&) {
        std::vector<GroundColumnText> texts;
        for (const auto& column : Model::ground_columns()) {
            texts.push_back({column.name, column.from, column.remark});
        }
        return texts;
    });
}

std::vector<double> ground_figures(const SurfaceType& type, const MotionLaws& laws, double diameter_m) {
    return with_model(laws, [&]<class Model>(std::type_identity<Model>, const auto& law) {
        std::vector<double> figures;
        for (const auto& column : Model::ground_columns()) {
            figures.push_back(column.value == nullptr ? no_figure : column.value(type, law, diameter_m));
        }
        return figures;
    });
}

std::vector<std::string> doubts_of(const MotionLaws& laws, const Slope& slope, double drop_m) {
    return with_model(laws, [&]<class Model>(std::type_identity<Model>, const auto& law) {
        if constexpr (requires { Model::doubts(slope, drop_m, law); }) {
            return Model::doubts(slope, drop_m, law);
        } else {
            return std::vector<std::string>{};
        }
    });
}

std::vector<std::string> sideways_settings() {
    std::vector<std::string> settings;
    for (const MotionModel model : all_models()) {
        const std::vector<std::string>& own = description_of(model).sideways_settings;
        settings.insert(settings.end(), own.begin(), own.end());
    }
    return settings;
}

std::string what_energies_count() {
    std::vector<std::string_view> kinds;
    for (const MotionModel model : all_models()) {
        const std::string_view energy = description_of(model).energy;
        if (std::find(kinds.begin(), kinds.end(), energy) == kinds.end()) {
            kinds.push_back(energy);
        }
    }
    std::string text{kinds.front()};
    for (std::size_t i = 1; i < kinds.size(); ++i) {
        const char* before = "; ";
        for (const MotionModel model : all_models()) {
            if (description_of(model).energy == kinds[i]) {
                text.append(before).append(description_of(model).name);
                before = ", ";
            }
        }
        text.append(": ").append(kinds[i]);
    }
    return text;
}

}  // namespace rockfall
