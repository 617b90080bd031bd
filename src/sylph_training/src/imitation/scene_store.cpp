#include "sylph_training/imitation/scene_store.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "sylph_core/files/write_file.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph_training {
namespace {

constexpr float kCostScale = 8.F;  // the encoder's cost to go is a multiple of 1 / 8
constexpr float kGapScale = 127.F;
constexpr float kCentideg = 100.F;
constexpr auto kMostCentideg =
    static_cast<int>(kCentideg * static_cast<float>(sylph::kSvoLevelSpacingDeg)) *
    sylph::kMostProsocialLevel;
constexpr std::array<char, 8> kFormat = {'S', 'Y', 'L', 'P', 'H', 'S', 'C', '2'};

/// The channels that are not 0 or 1 as they lie in a word.
struct Field {
  sylph::Channel channel;
  int shift;
  int bits;
  float scale;  ///< of the whole number that is stored, which is 0 at -1
};
constexpr int kCostShift = sylph::kBinaryChannelCount;
constexpr std::array<Field, 3> kFields = {
    {{sylph::Channel::CostToGo, kCostShift, 5, kCostScale},
     {sylph::Channel::SvoGap, kCostShift + 5, 8, kGapScale},
     {sylph::Channel::InheritedGap, kCostShift + 13, 8, kGapScale}}};

static_assert(kCostShift + 21 <= 64, "a cell no longer fits into its word");
static_assert(std::is_trivially_copyable_v<Sample> && std::is_trivially_copyable_v<SceneAgent>,
              "written to files as they lie in memory");

struct Header {
  std::array<char, 8> format = kFormat;
  std::uint64_t sample_bytes = sizeof(Sample);
  std::uint64_t scenes = 0;
  std::uint64_t agents = 0;
  std::uint64_t samples = 0;
};

struct Counts {
  std::uint32_t agents;
  std::uint32_t samples;
};

template <typename T>
void write(std::ofstream& stream, const T* values, std::size_t count) {
  stream.write(reinterpret_cast<const char*>(values),
               static_cast<std::streamsize>(count * sizeof(T)));
}

template <typename T>
void read(std::ifstream& stream, T* values, std::size_t count) {
  stream.read(reinterpret_cast<char*>(values), static_cast<std::streamsize>(count * sizeof(T)));
}

/// Whether everything in a scene that is used as an index is one.
bool isSound(const SceneStore::Span<SceneAgent>& agents, const SceneStore::Span<Sample>& samples) {
  return std::all_of(agents.begin(), agents.end(),
                     [&](const SceneAgent& agent) {
                       return agent.partner < agents.count && agent.svo_centideg <= kMostCentideg;
                     }) &&
         std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
           return sample.agent < agents.count && sample.action < sylph::kActionCount &&
                  sample.only_ties <= 1;
         });
}

}  // namespace

PackedView packView(const float* view) {
  PackedView packed{};
  for (std::uint64_t& word : packed) {
    for (int channel = 0; channel < sylph::kBinaryChannelCount; ++channel) {
      word |= (view[channel] > 0.5F ? std::uint64_t{1} : std::uint64_t{0}) << channel;
    }
    for (const Field& field : kFields) {
      const float value = view[static_cast<std::size_t>(field.channel)];
      word |= static_cast<std::uint64_t>(std::lround((value + 1.F) * field.scale)) << field.shift;
    }
    view += sylph::kChannelCount;
  }
  return packed;
}

void unpackView(const PackedView& view, float* out) {
  for (const std::uint64_t word : view) {
    for (int channel = 0; channel < sylph::kBinaryChannelCount; ++channel) {
      out[channel] = static_cast<float>((word >> channel) & 1U);
    }
    for (const Field& field : kFields) {
      const std::uint64_t stored = (word >> field.shift) & ((std::uint64_t{1} << field.bits) - 1);
      out[static_cast<std::size_t>(field.channel)] = static_cast<float>(stored) / field.scale - 1.F;
    }
    out += sylph::kChannelCount;
  }
}

std::uint16_t toCentidegrees(float svo_deg) {
  return static_cast<std::uint16_t>(std::lround(svo_deg * kCentideg));
}

void SceneStore::add(const Scene& scene) {
  scenes_.push_back({agents_.size(), scene.agents.size(), samples_.size(), scene.samples.size()});
  agents_.insert(agents_.end(), scene.agents.begin(), scene.agents.end());
  samples_.insert(samples_.end(), scene.samples.begin(), scene.samples.end());
}

SceneStore::Span<SceneAgent> SceneStore::agents(std::size_t scene) const {
  const Range& range = scenes_.at(scene);
  return {agents_.data() + range.first_agent, static_cast<std::size_t>(range.agents)};
}

SceneStore::Span<Sample> SceneStore::samples(std::size_t scene) const {
  const Range& range = scenes_.at(scene);
  return {samples_.data() + range.first_sample, static_cast<std::size_t>(range.samples)};
}

void SceneStore::save(const std::string& path) const {
  const std::string partial = path + ".partial";
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    Header header;
    header.scenes = scenes_.size();
    header.agents = agents_.size();
    header.samples = samples_.size();
    write(stream, &header, 1);
    for (const Range& range : scenes_) {
      const Counts counts{static_cast<std::uint32_t>(range.agents),
                          static_cast<std::uint32_t>(range.samples)};
      write(stream, &counts, 1);
    }
    write(stream, agents_.data(), agents_.size());
    write(stream, samples_.data(), samples_.size());
    sylph::closeWritten(stream, partial);
  }
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error) {
    throw std::runtime_error(path + ": cannot be replaced: " + error.message());
  }
}

void SceneStore::load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
  }
  Header header;
  header.format = {};
  read(stream, &header, 1);
  if (!stream || header.format != kFormat || header.sample_bytes != sizeof(Sample)) {
    throw std::runtime_error(path + ": is not a file of scenes of this version");
  }
  const std::uint64_t bytes = sizeof(Header) + header.scenes * sizeof(Counts) +
                              header.agents * sizeof(SceneAgent) + header.samples * sizeof(Sample);
  constexpr std::uint64_t kMostItems = std::uint64_t{1} << 40;  // keeps the sum from overflowing
  if (header.scenes > kMostItems || header.agents > kMostItems || header.samples > kMostItems ||
      bytes != std::filesystem::file_size(path)) {
    throw std::runtime_error(path + ": is not whole");
  }
  std::vector<Counts> counts(header.scenes);
  read(stream, counts.data(), counts.size());
  Range next{agents_.size(), 0, samples_.size(), 0};
  std::vector<Range> ranges;
  for (const Counts& count : counts) {
    next.agents = count.agents;
    next.samples = count.samples;
    ranges.push_back(next);
    next.first_agent += count.agents;
    next.first_sample += count.samples;
  }
  if (next.first_agent != agents_.size() + header.agents ||
      next.first_sample != samples_.size() + header.samples) {
    throw std::runtime_error(path + ": its scenes do not add up to its agents and samples");
  }
  std::vector<SceneAgent> agents(header.agents);
  std::vector<Sample> samples(header.samples);
  read(stream, agents.data(), agents.size());
  read(stream, samples.data(), samples.size());
  if (!stream) {
    throw std::runtime_error(path + ": cannot be read");
  }
  const SceneAgent* agent = agents.data();
  const Sample* sample = samples.data();
  for (const Counts& count : counts) {
    if (!isSound({agent, count.agents}, {sample, count.samples})) {
      throw std::runtime_error(path + ": has a scene with a row, level or action out of range");
    }
    agent += count.agents;
    sample += count.samples;
  }
  scenes_.insert(scenes_.end(), ranges.begin(), ranges.end());
  agents_.insert(agents_.end(), agents.begin(), agents.end());
  samples_.insert(samples_.end(), samples.begin(), samples.end());
}

}  // namespace sylph_training
