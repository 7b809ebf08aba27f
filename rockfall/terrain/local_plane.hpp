#pragma once

#include <Eigen/Core>
#include <optional>

namespace rockfall {

/// Weighted least-squares plane through points given relative to one of them, the centre.
class LocalPlane {
public:
    /// What a point adds to the sums, in the order of `sums_`; the last one is none and makes their number
    /// even.
    using Terms = Eigen::Array<double, 10, 1>;

    static Terms terms_of(double x_m, double y_m, double z_m, double weight) {
        const double wx = weight * x_m;
        const double wy = weight * y_m;
        Terms terms;
        terms << weight, wx, wy, weight * z_m, wx * x_m, wx * y_m, wy * y_m, wx * z_m, wy * z_m, 0.0;
        return terms;
    }
    /// Requires weight > 0.
    void add(double x_m, double y_m, double z_m, double weight) { add(terms_of(x_m, y_m, z_m, weight)); }
    void add(const Terms& terms) { sums_ += terms; }

    /// Height of the plane at the centre; nothing if the points, seen from above, lie in one line or nearly
    /// so.
    [[nodiscard]] std::optional<double> height_at_centre_m() const {
        const std::optional<Eigen::Vector3d> plane = fit();
        return plane ? std::optional{plane->z()} : std::nullopt;
    }

    /// The plane as (dz/dx, dz/dy, height at the centre [m]); nothing where the centre's height is nothing.
    [[nodiscard]] std::optional<Eigen::Vector3d> fit() const {
        if (sums_[0] <= 0.0) {
            return std::nullopt;
        }
        const Terms means = sums_ / sums_[0];
        const double x_m = means[1], y_m = means[2], z_m = means[3];
        const double xx = means[4] - x_m * x_m;
        const double xy = means[5] - x_m * y_m;
        const double yy = means[6] - y_m * y_m;
        const double xz = means[7] - x_m * z_m;
        const double yz = means[8] - y_m * z_m;
        const double determinant = xx * yy - xy * xy;
        constexpr double flattest = 1e-4;  // ratio of the variances across and along the points
        if (!(determinant > flattest * (xx + yy) * (xx + yy))) {
            return std::nullopt;
        }
        const double along_x = (xz * yy - yz * xy) / determinant;
        const double along_y = (yz * xx - xz * xy) / determinant;
        return Eigen::Vector3d{along_x, along_y, z_m - (along_x * x_m + along_y * y_m)};
    }

private:
    Terms sums_ = Terms::Zero();  ///< of w, w x, w y, w z, w x x, w x y, w y y, w x z, w y z
};

}  // namespace rockfall
