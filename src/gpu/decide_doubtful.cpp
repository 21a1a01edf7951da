#include "gpu/decide_doubtful.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"

namespace sphereview {

Decided decide_doubtful(const Resolver& resolver, const DrawnSpheres& drawn, std::span<std::int32_t> visible,
                        const std::function<Pixel(int place)>& pixel_of, const Deadline& deadline) {
    constexpr std::size_t batch = 256;  // pixels: some may take a millisecond each
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (is_doubtful(visible[i])) places.push_back(i);
    }
    std::size_t decided = 0;
    while (decided < places.size() && (decided == 0 || !deadline.passed())) {
        const std::size_t end = std::min(decided + batch, places.size());
        parallel_for(end - decided, [&](std::size_t i) {
            const std::size_t place = places[decided + i];
            DecisionLevel level = DecisionLevel::in_float;
            const std::int32_t seen = resolver.resolve(pixel_of(static_cast<int>(place)), level);
            visible[place] =
                seen < 0 ? visible_background : static_cast<std::int32_t>(*drawn.index_of(static_cast<std::uint32_t>(seen)));
        });
        decided = end;
    }
    return {decided > 0, decided == places.size()};
}

}  // namespace sphereview
