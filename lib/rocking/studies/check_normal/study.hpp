#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/studies/check_normal/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

struct GeneratedNumbers {
  std::string sampler;  ///< `box-muller`, ...
  std::uint64_t seed = 0;
};

struct NumbersOfFile {
  std::string file;
  bool has_own_law = false;  ///< the law has the mean and the standard deviation of the numbers
};

/// The check of numbers against their law.
struct SamplerCheck {
  std::optional<std::string> distribution;    ///< `lognormal`, `uniform`; absent: normal
  std::optional<GeneratedNumbers> generated;  ///< or else of a file
  std::optional<NumbersOfFile> of_file;
  stats::NormalCheck found;
};

/// The numbers in the text of a file: one a line, or of the column that its first line names so. `name`: of the file. Throws
/// base::InputError with the line of what is no number, or if there are fewer than 20.
[[nodiscard]] std::vector<double> read_numbers(std::string_view text, const std::string& name,
                                               const std::optional<std::string>& column);

[[nodiscard]] SamplerCheck sampler_check(const SamplerQuestion& question, const stats::NormalCheck& found);

[[nodiscard]] const StructType& fields_of(const SamplerCheck*);

/// The output of `rocking check-normal --json`.
[[nodiscard]] const DocumentOf<SamplerCheck>& check_normal_document();

/// The check as text for a terminal.
[[nodiscard]] std::string check_normal_summary(const SamplerCheck& check);

[[nodiscard]] const StructType& fields_of(const SamplerQuestion*);

[[nodiscard]] const Study& check_normal_study();

}  // namespace rocking

namespace rocking::analysis {

/// The figure `normal_histogram` of a check of random numbers: counts and the curve of the normal distribution, as in
/// Fig. 2 of Jeong and Yang (2012).
[[nodiscard]] Figure normal_histogram(const SamplerCheck& check);

}  // namespace rocking::analysis
