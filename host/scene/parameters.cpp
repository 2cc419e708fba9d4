#include "scene/scene.h"

namespace capcon {
namespace {

/// The values of an entry as T, nullptr when absent; InputError when they are of another kind.
template <typename T>
const std::vector<T>* find(const Parameters& parameters, const std::string& name, const char* wanted) {
  const auto found = parameters.entries.find(name);
  if (found == parameters.entries.end()) return nullptr;
  const auto* values = std::get_if<std::vector<T>>(&found->second.value);
  if (!values) throw InputError(found->second.place, '"' + name + "\" must be " + wanted);
  return values;
}

template <typename T>
T first(const Parameters& parameters, const std::string& name, const T& fallback, const char* wanted) {
  const auto* values = find<T>(parameters, name, wanted);
  if (!values) return fallback;
  if (values->empty()) throw InputError(parameters.entries.at(name).place, '"' + name + "\" has no value");
  return values->front();
}

}  // namespace

double Parameters::number(const std::string& name, double fallback) const {
  return first<double>(*this, name, fallback, "a number");
}

std::string Parameters::string(const std::string& name, const std::string& fallback) const {
  return first<std::string>(*this, name, fallback, "a string");
}

bool Parameters::boolean(const std::string& name, bool fallback) const {
  return first<bool>(*this, name, fallback, "true or false");
}

const std::vector<double>* Parameters::numbers(const std::string& name) const {
  return find<double>(*this, name, "numbers");
}

}  // namespace capcon
