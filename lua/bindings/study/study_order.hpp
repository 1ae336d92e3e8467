// Command and options of the cases of a study. No Lua here.
#pragma once

#include "bindings/core/host.hpp"
#include "run/study/study.hpp"

namespace trilith::script {

struct CasesOfScript {
  std::string program;             ///< this program
  std::filesystem::path script;    ///< that runs a case
  std::vector<std::string> fixed;  ///< "name=value", equal in all cases
  bool by_number = false;          ///< the script selects its cases by number; otherwise it receives their parameters
  bool trust = false;              ///< the cases run without a sandbox
  double memory = 0, seconds = 0;  ///< limits of each case as in Host; 0: default
  double checkpoint = -1;          ///< wall clock between checkpoints of a case [s]; below 0: default
  std::vector<std::filesystem::path> folders;  ///< that the cases may use in a sandbox
};

/// An order for `plan`, without file, histories and jobs. Throws InputError if the script cannot be read.
StudyOrder study_order(StudyPlan plan, const CasesOfScript& cases);

/// Options of the command line take precedence over the script. Throws InputError for an unknown case.
void take_choice(const StudyChoice& choice, StudyOrder& order);

/// Prints the command of each case.
void list_cases(const StudyOrder& order);

}  // namespace trilith::script
