#pragma once

#include "rocking/text/json.hpp"

namespace rocking::support {

/// An experiment whose mean static friction is unknown; it is quick to infer from a few tests.
inline Json campaign_block() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "title": "campaign",
    "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0 },
    "friction": { "static": { "normal": { "mean": 0.35, "sigma": 0.02, "between": [0.05, 1.0] } },
                  "kinetic": { "ratio": 0.857 } },
    "horizon": { "transient_periods": 100, "sampled_periods": 60 },
    "unknown": [ { "parameter": "/friction/static/normal/mean", "from": 0.3, "to": 0.45 } ],
    "realisations": 20, "seed": "0x2012" })");
}

}  // namespace rocking::support
