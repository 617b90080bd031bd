#include "sylph_core/social/social_state_file.hpp"

#include <algorithm>
#include <cstddef>

#include "sylph_core/files/write_file.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {

void saveSocialStates(const Plan& plan, const std::vector<SocialState>& social,
                      const std::string& path) {
  std::string text = "step,agent,row,col,partner,svo_deg\n";
  for (std::size_t step = 0; step < std::min(plan.size(), social.size()); ++step) {
    for (std::size_t agent = 0; agent < plan[step].size(); ++agent) {
      const Cell& cell = plan[step][agent];
      text += std::to_string(step) + "," + std::to_string(agent) + "," + std::to_string(cell.row) +
              "," + std::to_string(cell.col) + "," + std::to_string(social[step].partners[agent]) +
              "," + format("%.1f", static_cast<double>(social[step].svo_deg[agent])) + "\n";
    }
  }
  writeFile(path, text);
}

}  // namespace sylph
