#pragma once

#include <Eigen/Core>
#include <optional>

namespace rockfall {

/// Weighted least-squares plane through points given relative to one of them, the centre.
class LocalPlane {
public:
    /// Requires weight > 0.
    void add(double x_m, double y_m, double z_m, double weight) {
        weight_ += weight;
        x_ += weight * x_m;
        y_ += weight * y_m;
        z_ += weight * z_m;
        xx_ += weight * x_m * x_m;
        xy_ += weight * x_m * y_m;
        yy_ += weight * y_m * y_m;
        xz_ += weight * x_m * z_m;
        yz_ += weight * y_m * z_m;
    }

    /// Height of the plane at the centre; nothing if the points, seen from above, lie in one line or nearly
    /// so.
    [[nodiscard]] std::optional<double> height_at_centre_m() const {
        const std::optional<Eigen::Vector3d> plane = fit();
        return plane ? std::optional{plane->z()} : std::nullopt;
    }

    /// The plane as (dz/dx, dz/dy, height at the centre [m]); nothing where the centre's height is nothing.
    [[nodiscard]] std::optional<Eigen::Vector3d> fit() const {
        if (weight_ <= 0.0) {
            return std::nullopt;
        }
        const double x_m = x_ / weight_, y_m = y_ / weight_, z_m = z_ / weight_;
        const double xx = xx_ / weight_ - x_m * x_m;
        const double xy = xy_ / weight_ - x_m * y_m;
        const double yy = yy_ / weight_ - y_m * y_m;
        const double xz = xz_ / weight_ - x_m * z_m;
        const double yz = yz_ / weight_ - y_m * z_m;
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
    double weight_ = 0.0;
    double x_ = 0.0, y_ = 0.0, z_ = 0.0;
    double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0, xz_ = 0.0, yz_ = 0.0;
};

}  // namespace rockfall
