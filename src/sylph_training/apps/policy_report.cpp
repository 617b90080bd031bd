#include <CLI/CLI.hpp>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/command/run_command.hpp"
#include "sylph_core/files/write_file.hpp"
#include "sylph_training/run/policy_meters.hpp"

namespace {

struct Options {
  std::string weights;
  std::string csv;
  bool by_rule = false;
  sylph_training::MeterSettings meters;
};

/// A column for each kind of worlds.
void print(const std::vector<std::pair<std::string, sylph_training::Figures>>& columns) {
  constexpr int kWidth = 18;
  std::cout << std::left << std::setw(kWidth) << "";
  for (const auto& [name, figures] : columns) {
    std::cout << std::right << std::setw(kWidth) << name;
  }
  std::cout << std::endl << std::fixed << std::setprecision(3);
  for (std::size_t row = 0; row < columns.front().second.size(); ++row) {
    std::cout << std::left << std::setw(kWidth) << columns.front().second[row].first;
    for (const auto& [name, figures] : columns) {
      std::cout << std::right << std::setw(kWidth) << figures[row].second;
    }
    std::cout << std::endl;
  }
}

void write(const std::vector<std::pair<std::string, sylph_training::Figures>>& columns,
           const std::string& path) {
  std::ofstream file(path);
  file << "worlds";
  for (const auto& figure : columns.front().second) {
    file << "," << figure.first;
  }
  file << "\n";
  for (const auto& [name, figures] : columns) {
    file << name;
    for (const auto& figure : figures) {
      file << "," << figure.second;
    }
    file << "\n";
  }
  sylph::closeWritten(file, path);
}

int report(Options options) {
  const sylph::Policy policy = sylph::Policy::load(options.weights);
  options.meters.svo = options.by_rule ? sylph::SvoChoice::Priority : sylph::SvoChoice::Mean;
  std::vector<std::pair<std::string, sylph_training::Figures>> columns;
  for (const auto& worlds : sylph_training::meterWorlds()) {
    columns.emplace_back(worlds.name(),
                         sylph_training::measure(policy, worlds, options.meters).figures());
  }
  print(columns);
  if (!options.csv.empty()) {
    write(columns, options.csv);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Measures a policy in the worlds it leads itself through: how it does, when it gives way, "
      "and "
      "whether SVOs decide that.",
      "sylph_policy_report");
  app.add_option("weights", options.weights, "weights to measure")->required();
  app.add_option("--worlds", options.meters.worlds, "of each kind")->check(CLI::PositiveNumber);
  app.add_option("--seed", options.meters.seed, "of the first world");
  app.add_option("--temperature", options.meters.temperature, "of the moves")
      ->check(CLI::PositiveNumber);
  app.add_flag("--by-rule", options.by_rule,
               "SVOs by the rule of priorities instead of the weights' own");
  app.add_option("--csv", options.csv, "file for the table, for plot_policy_report");
  return sylph::runCommand(app, argc, argv, [&] { return report(options); });
}
