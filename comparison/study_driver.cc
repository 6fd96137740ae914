#include "comparison/study_driver.h"

#include <functional>
#include <utility>

namespace fretval {

void run_studies(std::vector<CaseStudy>& studies, const MakeBody& make_body) {
  BodyStore bodies(make_body);
  while (true) {
    std::vector<Probe> probes;
    std::vector<std::pair<std::size_t, Resolution>> origin;  // study
    for (std::size_t s = 0; s < studies.size(); ++s)
      for (const auto& resolution : studies[s].wanted()) {
        const auto& prepared = studies[s].prepared();
        probes.push_back({&prepared.scene, at_resolution(prepared.fem, resolution)});
        origin.emplace_back(s, resolution);
      }
    if (probes.empty()) return;
    run_probes(probes, std::ref(bodies), [&](std::size_t i, ProbeAnswer&& answer) {
      studies[origin[i].first].take(origin[i].second, std::move(answer));
    });
    for (auto& study : studies)
      if (!study.wanted().empty()) study.advance();
  }
}

}  // namespace fretval
