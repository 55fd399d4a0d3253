#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace rocking::support {

/// Values in lines of `columns`, as PEER's files have them: `  .1224950E-02`.
inline std::string peer_values(const std::vector<double>& values, std::size_t columns = 5) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%16.7E", values[i]);
    text += digits;
    if ((i + 1) % columns == 0 || i + 1 == values.size()) text += '\n';
  }
  return text;
}

/// A motion that looks like a recorded one: noise through two filters under an envelope, at rest at both ends.
inline std::vector<double> noise(unsigned seed, std::size_t count = 2000, double peak = 3.0) {
  std::vector<double> values(count);
  double one = 0.0, two = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    seed = seed * 1664525U + 1013904223U;
    const double white = static_cast<double>(seed >> 8U) / 8388608.0 - 1.0;
    one += 0.3 * (white - one);
    two += 0.02 * (one - two);
    const double at = static_cast<double>(i) / static_cast<double>(count);
    values[i] = (one - two) * std::pow(std::sin(std::acos(-1.0) * at), 2.0);
    largest = std::max(largest, std::abs(values[i]));
  }
  for (double& value : values) value *= peak / largest;
  return values;
}

/// Lines of a time and a value, times a factor.
inline std::string columns_text(const std::vector<double>& values, double step, double factor, int digits) {
  std::ostringstream text;
  text.precision(digits);
  for (std::size_t i = 0; i < values.size(); ++i)
    text << step * static_cast<double>(i) << ' ' << factor * values[i] << '\n';
  return text.str();
}

/// A file in PEER's .AT2 format, with the given last line of its header.
inline std::string peer_at2(const std::string& counts, const std::vector<double>& values) {
  return "PEER STRONG MOTION DATABASE RECORD. INVENTED FOR A TEST.\nNOWHERE 01/01/01 00:00, NO STATION, 000\n"
         "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=40.0 Hz\n" +
         counts + '\n' + peer_values(values);
}

/// The same with the header line of the values.
inline std::string peer_at2(const std::vector<double>& values, const std::string& step) {
  return peer_at2("NPTS=  " + std::to_string(values.size()) + ", DT=   " + step + " SEC", values);
}

/// A file in the ASCII format of the European strong-motion database.
inline std::string esm_asc(const std::string& step, const std::string& unit, const std::string& count,
                           const std::string& values) {
  return "EVENT_NAME: INVENTED\nEVENT_DATE_YYYYMMDD: 20010101\nEVENT_TIME_HHMMSS: 00:00:00\nSTATION_CODE: NONE\n"
         "SAMPLING_INTERVAL_S: " +
         step + "\nNDATA: " + count + "\nDURATION_S: \nSTREAM: HNE\nUNITS: " + unit +
         "\nPGA_CM/S^2: \nDATA_TYPE: ACCELERATION\nPROCESSING: \nUSER5: \n" + values;
}

}  // namespace rocking::support
