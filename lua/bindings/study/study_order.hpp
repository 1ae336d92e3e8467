// How the program runs the cases of a study. No Lua here.
#pragma once

#include "bindings/core/host.hpp"
#include "run/study/study.hpp"

namespace trilith::script {

struct CasesOfScript {
  std::string program;             ///< this program
  std::filesystem::path script;    ///< that runs a case
  std::vector<std::string> fixed;  ///< "name=value", the same in all cases
  bool by_number = false;          ///< the script knows its cases by number; else it is given their parameters
  bool trust = false;              ///< the cases run without a closed room
  double memory = 0, seconds = 0;  ///< limits of each case as in Host; 0: the program's own
  std::vector<std::filesystem::path> folders;  ///< that the cases may use, where the room is closed
};

/// An order for `plan` but for file, histories and jobs. Throws InputError where the script cannot be read.
StudyOrder study_order(StudyPlan plan, const CasesOfScript& cases);

/// What was chosen on the command line goes before what the script says. Throws InputError for a case that is not
/// there.
void take_choice(const StudyChoice& choice, StudyOrder& order);

/// Prints the command of each case.
void list_cases(const StudyOrder& order);

}  // namespace trilith::script
