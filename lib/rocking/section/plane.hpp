#pragma once

namespace rocking::section {

/// A point, or the difference of two, in the plane in which strobe points are compared: (Theta, Theta'), or (V, 0) for
/// a block that only slides.
struct PlanePoint {
  double x = 0.0;
  double y = 0.0;

  [[nodiscard]] PlanePoint scaled(double factor) const { return {factor * x, factor * y}; }
  friend PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a.x - b.x, a.y - b.y}; }
};

/// A symmetric 2 x 2 matrix: a covariance, or a sum of squares and products.
struct Covariance {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  void add(const PlanePoint& p) {
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
  }
  void add(const Covariance& other) {
    xx += other.xx;
    xy += other.xy;
    yy += other.yy;
  }
  [[nodiscard]] Covariance scaled(double factor) const { return {factor * xx, factor * xy, factor * yy}; }
  [[nodiscard]] double determinant() const { return xx * yy - xy * xy; }
};

/// d' C^-1 d: the square of the Mahalanobis distance. C must be positive definite.
[[nodiscard]] inline double squared_distance(const PlanePoint& d, const Covariance& c) {
  return (d.x * d.x * c.yy - 2.0 * d.x * d.y * c.xy + d.y * d.y * c.xx) / c.determinant();
}

}  // namespace rocking::section
