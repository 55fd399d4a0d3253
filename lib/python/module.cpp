#include "module.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <variant>

#include <pybind11/stl.h>

#include "rocking/rocking.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

/// Before its version 2.12 pybind11 reads the item size of an array where numpy 1 has it, so that arrays would be wrong.
void refuse_numpy_2() {
  const auto version = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (PYBIND11_VERSION_HEX >= 0x020C0000 || version.starts_with("1.")) return;
  throw py::import_error("this module was built with pybind11 " + std::to_string(PYBIND11_VERSION_MAJOR) + '.' +
                         std::to_string(PYBIND11_VERSION_MINOR) + ", which does not know numpy " + version +
                         ": install numpy<2");
}

/// Sets the Python error for an exception of the library; the classes are those of rocking/errors.py.
void set_error(const char* name, const py::object& argument) {
  const py::object type = py::module_::import("rocking.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(argument).ptr());
}

py::list tuples_of(const std::vector<base::Problem>& problems) {
  py::list list;
  for (const base::Problem& problem : problems) {
    list.append(py::make_tuple(problem.place, problem.value, problem.reason, problem.remedy, problem.where));
  }
  return list;
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const base::InputError& error) {
    set_error("InputError", tuples_of(error.problems()));
  } catch (const DifferentBits& error) {
    set_error("DifferentBits", py::str(error.what()));
  } catch (const base::UnusableFile& error) {
    set_error("StoreError", py::str(error.what()));
  } catch (const std::system_error& error) {
    // With two arguments OSError becomes FileNotFoundError, PermissionError and so on.
    const py::object os_error = py::reinterpret_borrow<py::object>(PyExc_OSError);
    PyErr_SetObject(PyExc_OSError, py::make_tuple(error.code().value(), error.what()).ptr());
  }
}

template <std::size_t Count>
py::tuple tuple_of(const std::array<std::string_view, Count>& names) {
  py::tuple tuple(Count);
  for (std::size_t i = 0; i < Count; ++i) tuple[i] = std::string(names[i]);
  return tuple;
}

py::object swept_value(const SweptValue& value) {
  return std::visit(
      []<class Value>(const Value& given) -> py::object {
        if constexpr (std::is_same_v<Value, WrittenPart>) {
          return py::module_::import("json").attr("loads")(given.text);
        } else {
          return py::cast(given);
        }
      },
      value);
}

void add_experiment(py::module_& module) {
  py::class_<Experiment>(module, "Experiment")
      .def_readonly("title", &Experiment::title)
      .def_readonly("seed", &Experiment::seed)
      .def_property_readonly("text", [](const Experiment& experiment) { return experiment.canonical_text; })
      .def_property_readonly("shape", [](const Experiment& experiment) { return experiment.sweep_sizes; })
      .def_property_readonly("conditions", [](const Experiment& experiment) { return experiment.conditions.size(); })
      .def("parameters", [](const Experiment& experiment, std::size_t condition) {
        py::list list;
        for (const Parameter& parameter : experiment.conditions.at(condition).parameters) {
          list.append(py::make_tuple(parameter.pointer, swept_value(parameter.value)));
        }
        return list;
      });
  const auto overrides = [](std::optional<std::string> seed, std::optional<std::string> realisations, bool skips) {
    return Overrides{
        .seed = std::move(seed), .realisations = std::move(realisations), .levels = {}, .skips_unreadable = skips};
  };
  module.def("parse", [overrides](const std::string& text, const std::string& name, const std::string& folder,
                                  std::optional<std::string> seed, std::optional<std::string> realisations,
                                  bool skips_unreadable) {
    return parse_experiment(text, folder, name, overrides(std::move(seed), std::move(realisations), skips_unreadable));
  });
  module.def("read", [overrides](const std::string& path, std::optional<std::string> seed,
                                 std::optional<std::string> realisations, bool skips_unreadable) {
    return read_experiment(path, overrides(std::move(seed), std::move(realisations), skips_unreadable));
  });
}

}  // namespace
}  // namespace rocking::python

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace rocking;
  module.doc() = "Core of the package rocking; its interface is that of the package.";
  python::refuse_numpy_2();
  py::register_exception_translator(&python::translate);
  python::add_experiment(module);
  python::add_arrays(module);
  python::add_checks(module);
  python::add_runs(module);
  python::add_studies(module);
#if defined(ROCKING_HAS_PAGES)
  python::add_pages(module);
#endif
  module.def("clopper_pearson", [](std::uint64_t successes, std::uint64_t trials, double confidence) {
    const stats::Interval interval = clopper_pearson(successes, trials, confidence);
    return py::make_tuple(interval.low, interval.high);
  });
  module.def("wilson", [](std::uint64_t successes, std::uint64_t trials, double confidence) {
    const stats::Interval interval = wilson(successes, trials, confidence);
    return py::make_tuple(interval.low, interval.high);
  });
  module.def("colour", [](const std::string& name) -> std::optional<std::string> {
    const auto mode = mode_named(name);
    return mode ? std::optional(std::string(colour_of(*mode))) : std::nullopt;
  });
  module.def("version", [] { return version(); });
  module.def("schema", [](const std::string& name) { return std::string(schema(name)); });
  module.attr("contacts") = python::tuple_of(dynamics::contact_names);
  module.attr("events") = python::tuple_of(dynamics::event_names);
  module.attr("terminations") = python::tuple_of(dynamics::termination_names);
}
