#pragma once

#include <string>
#include <string_view>

#include "analysis/gnuplot.hpp"

namespace rocking::analysis {

/// A page of HTML, without scripts and external resources, as PDF: by WeasyPrint, which is looked up in PATH. Empty where
/// that is missing or fails; `printing` says why. Equal pages give equal bytes. Throws base::Stopped if it is asked to
/// stop.
[[nodiscard]] std::string pdf_of(std::string_view html, Drawing& printing, base::StopRequest stop = {});

}  // namespace rocking::analysis
