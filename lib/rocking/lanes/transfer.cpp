#include "rocking/lanes/transfer.hpp"

#include <tuple>

namespace rocking::lanes {
namespace {

using dynamics::MotionSeries;
using SeriesRow = MotionSeries<double>::Row;

constexpr std::size_t row_length = std::tuple_size_v<SeriesRow>;

/// Where a row is in the table of series, in rows.
std::size_t row_number(const MotionSeries<double>& series, SeriesRow MotionSeries<double>::*row) {
  return static_cast<std::size_t>(&(series.*row) - &series.base);
}

}  // namespace

void take_series(const Block& block, std::size_t lane, const Kernels& kernels, Kind kind,
                 MotionSeries<double>& series) {
  const auto lanes = static_cast<std::size_t>(kernels.lanes);
  const auto order = static_cast<std::size_t>(order_of(kind));
  const auto take = [&](SeriesRow MotionSeries<double>::*row, std::size_t count) {
    const std::size_t number = row_number(series, row);
    const double* from = block.series.data() + number * row_length * lanes + lane;
    for (std::size_t k = 0; k < count; ++k) (series.*row)[k] = from[k * lanes];
  };
  using Series = MotionSeries<double>;
  take(&Series::tilt, order + 2);
  take(&Series::tilt_rate, order + 1);
  take(&Series::normal, order);
  if (kind == Kind::rock_with_friction) {
    take(&Series::base, order + 1);
    take(&Series::rate_cosine, order + 1);
  }
  if (kind == Kind::rock_slide || kind == Kind::rock_slide_briefly) {
    take(&Series::slip_rate, order + 1);
    take(&Series::slip, order + 2);
    take(&Series::sine, 1);
    take(&Series::arm, 1);
  }
}

integrate::FiredGuards in_doubt(const Block& block, std::size_t lane) {
  integrate::FiredGuards guards;
  for (std::size_t guard = 0; guard < block.unclear.size(); ++guard)
    guards[guard] = (block.unclear[guard] >> lane & 1U) != 0;
  return guards;
}

}  // namespace rocking::lanes
