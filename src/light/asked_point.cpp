#include "light/asked_point.hpp"

namespace sphereview {

AskedPoint::AskedPoint(const HitPlaces& places, Pixel pixel, const Sphere& sphere, EyeSide side,
                       const std::optional<HitPlace>& place, std::int64_t* in_integers)
    : places_(places),
      pixel_(pixel),
      sphere_(sphere),
      side_(side),
      place_(place ? *place : places.at(places.ray(pixel), sphere, side)),
      in_integers_(in_integers) {}

const ApproximateLitPoint& AskedPoint::approximate() {
    if (!approximate_) approximate_.emplace(places_.camera(), places_.exact_basis(), places_.size(), pixel_, sphere_, side_);
    return *approximate_;
}

const ExactLitPoint& AskedPoint::exact() {
    if (in_integers_ != nullptr) ++*in_integers_;
    if (!exact_) exact_.emplace(places_.camera(), places_.size(), pixel_, sphere_, side_);
    return *exact_;
}

bool AskedPoint::faces(const glm::dvec3& direction) {
    const bool outside = places_.begins_outside(pixel_, sphere_, side_);
    if (const std::optional<bool> found = places_.faces(place_, sphere_, direction, outside)) return *found;
    if (const std::optional<int> sign = approximate().facing(direction)) return *sign > 0;
    return exact().facing(direction) > 0;
}

bool AskedPoint::blocked(const Sphere& other, const glm::dvec3& direction) {
    Shadow found = places_.shadow(place_, other, direction);
    if (found == Shadow::unsure) found = approximate().shadow(other, direction);
    return found == Shadow::unsure ? exact().blocking(other, direction).blocks() : found == Shadow::all;
}

}  // namespace sphereview
