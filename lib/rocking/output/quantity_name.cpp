#include "rocking/output/quantity_name.hpp"

#include <algorithm>
#include <map>

#include "rocking/text/json.hpp"

namespace rocking {

QuantityName quantity_name(const std::string& pointer) {
  static const std::map<std::string, QuantityName> known{
      {"/excitation/amplitude", {"base amplitude", "A_h", "", "$A_h$"}},
      {"/excitation/frequency_ratio", {"frequency ratio", "Ω_h", "", "$\\Omega_h$"}},
      {"/excitation/amplitude_g", {"base amplitude", "", "g", "$a_h/g$"}},
      {"/excitation/amplitude_m_s2", {"base amplitude", "", "m/s²", "$a_h$ [m/s$^2$]"}},
      {"/excitation/frequency_hz", {"base frequency", "", "Hz", "$f$ [Hz]"}},
      {"/excitation/period_s", {"base period", "", "s", "$T$ [s]"}},
      {"/restitution/rate_ratio", {"rate ratio", "δ", "", "$\\delta$"}},
      {"/restitution/rate_ratio/0", {"rate ratio of the left edge", "δ_1", ""}},
      {"/restitution/rate_ratio/1", {"rate ratio of the right edge", "δ_-1", ""}},
      {"/excitation/phase_rad", {"phase", "Φ", "rad"}},
      {"/excitation/vertical/amplitude", {"vertical amplitude", "A_v", ""}},
      {"/excitation/vertical/amplitude_g", {"vertical amplitude", "", "g"}},
      {"/excitation/vertical/amplitude_m_s2", {"vertical amplitude", "", "m/s²"}},
      {"/excitation/vertical/frequency_ratio", {"vertical frequency ratio", "Ω_v", ""}},
      {"/excitation/vertical/frequency_hz", {"vertical frequency", "", "Hz"}},
      {"/excitation/vertical/period_s", {"vertical period", "", "s"}},
      {"/excitation/vertical/phase_rad", {"vertical phase", "Φ_v", "rad"}},
      {"/excitation/scale", {"scale of the ground motion", "", ""}},
      {"/excitation/pga_g", {"peak ground acceleration", "PGA", "g"}},
      {"/excitation/sa_g", {"spectral acceleration", "PSa", "g"}},
      {"/excitation/sa_p_g", {"spectral acceleration at 2π/p", "PSa", "g"}},
      {"/excitation/avgsa_g", {"average spectral acceleration", "avgSa", "g"}},
      {"/excitation/sa_absolute_g", {"absolute spectral acceleration", "", "g"}},
      {"/excitation/pgv_m_s", {"peak ground velocity", "PGV", "m/s"}},
      {"/excitation/file", {"ground motion", "", ""}},
      {"/friction/static", {"static friction", "μ_s", "", "$\\mu_s$"}},
      {"/friction/kinetic", {"kinetic friction", "μ_k", "", "$\\mu_k$"}},
      {"/friction/kinetic/ratio", {"kinetic over static friction", "μ_k/μ_s", ""}},
      {"/friction", {"friction", "μ_s/μ_k", "", "$\\mu_s/\\mu_k$"}},
      {"/restitution", {"restitution", "e", "", "$e$"}},
      {"/block/width_m", {"width", "B", "m"}},
      {"/block/height_m", {"height", "H", "m"}},
      {"/initial/tilt", {"initial tilt", "Θ_0", ""}},
      {"/initial/tilt_rate", {"initial tilt rate", "Θ′_0", ""}},
      {"/initial/slip", {"initial slip", "X_0", ""}},
      {"/initial/slip_rate", {"initial slip rate", "V_0", ""}},
      {"/initial/tilt_rad", {"initial tilt", "θ_0", "rad"}},
      {"/initial/tilt_rate_rad_s", {"initial tilt rate", "", "rad/s"}},
      {"/initial/slip_m", {"initial slip", "", "m"}},
      {"/initial/slip_rate_m_s", {"initial slip rate", "", "m/s"}}};
  if (const auto found = known.find(pointer); found != known.end()) return found->second;
  const std::string key = last_key(pointer);
  if (key == "refresh_slip_m") return {"cell of friction", "", "m"};
  const std::string whole = pointer.substr(0, pointer.size() - std::min(pointer.size(), key.size() + 1));
  if (last_key(whole) == "normal" || last_key(whole) == "lognormal") {  // of a number that is drawn
    const std::string drawn = quantity_name(whole.substr(0, whole.rfind('/'))).quantity;
    return {.quantity = (key == "sigma" ? "standard deviation" : key) + (" of " + drawn), .symbol = "", .unit = ""};
  }
  if (key == "sigma" || key == "relative_sigma") {
    std::string of = last_key(whole);
    std::replace(of.begin(), of.end(), '_', ' ');
    return {.quantity = (key == "sigma" ? "standard deviation of " : "relative standard deviation of ") + of,
            .symbol = "σ",
            .unit = ""};
  }
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  const bool is_source = pointer == "/fluctuation/" + key;
  return {.quantity = (is_source ? "fluctuation of " : "") + words, .symbol = "", .unit = ""};
}

}  // namespace rocking
