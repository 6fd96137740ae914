#include "comparison/accuracy/study_driver.h"

#include <functional>
#include <utility>

namespace fretval {

void run_studies(std::vector<CaseStudy>& studies, const MakeBody& make_body,
                 const std::function<void(std::size_t)>& finished) {
  BodyStore bodies(make_body);
  run_studies(studies, bodies, finished);
}

void run_studies(std::vector<CaseStudy>& studies, BodyStore& bodies, const std::function<void(std::size_t)>& finished) {
  while (true) {
    std::vector<Probe> probes;
    std::vector<std::pair<std::size_t, Resolution>> origin;  // study
    std::vector<std::size_t> n_missing(studies.size());
    for (std::size_t s = 0; s < studies.size(); ++s)
      for (const auto& resolution : studies[s].wanted()) {
        const auto& prepared = studies[s].prepared();
        probes.push_back({&prepared.scene, at_resolution(prepared.fem, resolution)});
        origin.emplace_back(s, resolution);
        ++n_missing[s];
      }
    if (probes.empty()) return;
    const auto take = [&](std::size_t i, ProbeAnswer&& answer) {
      const auto& [s, resolution] = origin[i];
      studies[s].take(resolution, std::move(answer));
      if (--n_missing[s] > 0) return;
      studies[s].advance();
      if (studies[s].wanted().empty()) finished(s);
    };
    run_probes(probes, std::ref(bodies), take);
  }
}

}  // namespace fretval
