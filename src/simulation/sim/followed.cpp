// SPDX-License-Identifier: MIT
#include "sim/followed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace touchstone::sim {
namespace {

std::optional<Index> number_from(std::string_view text) {
  Index number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<Followed> followed_from(const std::string& text) {
  constexpr std::string_view kBody = "body:";
  Followed followed;
  if (!text.starts_with(kBody)) {
    followed.particle = number_from(text);
    return followed.particle ? std::optional(followed) : std::nullopt;
  }
  const std::string_view numbers = std::string_view(text).substr(kBody.size());
  const std::size_t colon = numbers.find(':');
  followed.body = number_from(numbers.substr(0, colon));
  if (!followed.body) return std::nullopt;
  if (colon == std::string_view::npos) return followed;
  followed.vertex = number_from(numbers.substr(colon + 1));
  return followed.vertex ? std::optional(followed) : std::nullopt;
}

std::string missing_in(const Scene& scene, const Followed& followed) {
  if (followed.particle) {
    const std::size_t count = scene.particles.size();
    return *followed.particle < count ? "" : fmt::format("there is no such particle: there are {}", count);
  }
  if (*followed.body >= scene.bodies.size()) {
    return fmt::format("there is no such body: there are {}", scene.bodies.size());
  }
  const std::size_t count = scene.bodies[*followed.body].vertices.size();
  if (!followed.vertex || *followed.vertex < count) return {};
  return fmt::format("there is no such vertex: the body has {}", count);
}

std::string header_of(const Followed& followed) {
  return followed.body && !followed.vertex ? ",x,y,z,qw,qx,qy,qz" : ",x,y,z";
}

std::vector<double> values_of(const Simulation& simulation, const Followed& followed) {
  if (followed.particle) {
    const Vector3 at = position(simulation.state().q, *followed.particle);
    return {at.x(), at.y(), at.z()};
  }
  const Pose& pose = simulation.bodies()->state().bodies[*followed.body].pose;
  if (followed.vertex) {
    const Vector3 at = placed(pose, simulation.bodies()->system().bodies()[*followed.body].points[*followed.vertex]);
    return {at.x(), at.y(), at.z()};
  }
  std::vector<double> values = {pose.p.x(), pose.p.y(), pose.p.z()};
  const auto first = std::find_if(pose.q.begin(), pose.q.end(), [](double x) { return x != 0; });
  for (const double x : first != pose.q.end() && *first < 0 ? negated(pose.q) : pose.q) values.push_back(x);
  return values;
}

}  // namespace touchstone::sim
