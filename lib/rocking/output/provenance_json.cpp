#include "rocking/output/provenance_json.hpp"

#include "rocking/base/digest.hpp"

namespace rocking {

Json input_json(const Experiment& experiment) {
  Json input = Json::object();
  input["experiment"] = Json::parse(experiment.canonical_text);
  input["sha256"] = base::to_hex(base::sha256(experiment.canonical_text));
  return input;
}

Json system_json(const SystemFacts& system) {
  Json json = Json::object();
  json["version"] = system.build.version;
  json["revision"] = system.build.revision;
  json["compiler"] = system.build.compiler;
  json["flags"] = system.build.flags;
  json["build_type"] = system.build.build_type;
  json["machine"] = system.machine;
  json["start"] = system.start;
  json["duration_s"] = system.duration_s;
  json["threads"] = system.threads;
  return json;
}

}  // namespace rocking
