// Responses of beams of fibres at the last evaluation, kept for the tangent of the model.
//
// Each evaluation computes the tangents of all fibres. It appends them to the trial memories in Work::beam_memory, so a
// tangent of the model needs no second pass over the fibres. At the commit they are cut off. So State never has them,
// and they never belong to memories of another step.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <span>

#include "element/beam/beam_answer.hpp"
#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Motion of a beam and its response: N strains, in the order of BeamStrain or BeamStrain3.
template <int N>
struct FibreAnswer {
  std::array<double, N> strain{}, rate{}, stress{}, damping{};
  Eigen::Matrix<double, N, N> by_strain, by_rate;  ///< derivatives of `stress` and `damping`

  static constexpr int size = 4 * N + 2 * N * N;
};

inline FibreAnswer<3> fibre_answer(const BeamStrain& strain, const BeamStrain& rate, const BeamTangent& r) {
  return {strain, rate, r.stress, r.damping, r.by_strain, r.by_rate};
}
inline FibreAnswer<6> fibre_answer(const BeamStrain3& strain, const BeamStrain3& rate, const BeamAnswer3& r) {
  return {strain, rate, r.stress, r.damping, r.by_strain, r.by_rate};
}

template <int D>
class FibreAnswers {
 public:
  using Answer = FibreAnswer<D == 2 ? 3 : 6>;
  using Strain = decltype(Answer::strain);

  /// `memories`: Work::beam_memory. Writer: internal_forces
  static void make_room(const Model<D>& model, std::vector<double>& memories) {
    memories.resize(static_cast<std::size_t>(model.beam_memory + Answer::size * beams(model)));
  }
  static void keep(const Model<D>& model, int row, const Answer& answer, std::vector<double>& memories) {
    double* to = memories.data() + place(model, row);
    for (const Strain* part : {&answer.strain, &answer.rate, &answer.stress, &answer.damping})
      to = std::copy(part->begin(), part->end(), to);
    to = std::copy_n(answer.by_strain.data(), answer.by_strain.size(), to);
    std::copy_n(answer.by_rate.data(), answer.by_rate.size(), to);
  }
  /// The response of the beam with `row` of fibres, if it was evaluated in this motion after the last commit.
  static std::optional<Answer> find(const Model<D>& model, int row, const Strain& strain, const Strain& rate,
                                    const std::vector<double>& memories) {
    if (memories.size() != static_cast<std::size_t>(model.beam_memory + Answer::size * beams(model)))
      return std::nullopt;
    const double* from = memories.data() + place(model, row);
    Answer out;
    for (Strain* part : {&out.strain, &out.rate, &out.stress, &out.damping}) {
      std::copy_n(from, part->size(), part->begin());
      from += part->size();
    }
    if (out.strain != strain || out.rate != rate) return std::nullopt;
    std::copy_n(from, out.by_strain.size(), out.by_strain.data());
    std::copy_n(from + out.by_strain.size(), out.by_rate.size(), out.by_rate.data());
    return out;
  }

 private:
  static int beams(const Model<D>& model) {
    if constexpr (D == 2)
      return static_cast<int>(model.yields.fibre_beams.size());
    else
      return static_cast<int>(model.yields_3d.fibre_beams.size());
  }
  static std::size_t place(const Model<D>& model, int row) {
    return static_cast<std::size_t>(model.beam_memory + Answer::size * row);
  }
};

}  // namespace trilith
