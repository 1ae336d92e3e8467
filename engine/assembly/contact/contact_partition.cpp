#include "assembly/contact/contact_partition.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "assembly/contact/face_contact_simd.hpp"

namespace trilith {
namespace {

/// Evaluations after which pairs are assumed to last longer; the partition then costs very little in comparison.
constexpr int settled_after = 8;

/// Least number of rows in a partition.
constexpr int least_run = 64;

constexpr int nobody = -1, several = -2;

void note(int& share_of, int share) {
  share_of = share_of == nobody || share_of == share ? share : several;
}

}  // namespace

bool partition_face_contacts(const Model<2>& model, Work<2>& work) {
  RowShares& shares = work.row_shares;
  if (work.threads <= 1 || ++shares.evaluations <= settled_after) return false;
  if (shares.threads == work.threads) return true;
  const std::size_t rows = work.pairs.size();
  const auto parts = static_cast<std::size_t>(
      std::clamp(static_cast<int>(rows) / least_run, work.threads, runs_a_thread * work.threads));
  shares.threads = work.threads;
  shares.first.resize(parts + 1), shares.border.resize(rows);
  for (std::size_t t = 0; t <= parts; ++t) shares.first[t] = static_cast<int>(rows * t / parts);
  shares.share_of.assign(model.bodies.size(), nobody);
  const auto body_of = [&](int piece) -> int& { return shares.share_of[model.piece_body[piece]]; };
  for (std::size_t t = 0; t < parts; ++t)
    for (int row = shares.first[t]; row < shares.first[t + 1]; ++row) {
      note(body_of(work.pairs[row].piece_a), static_cast<int>(t));
      note(body_of(work.pairs[row].piece_b), static_cast<int>(t));
    }
  for (std::size_t row = 0; row < rows; ++row)
    shares.border[row] = static_cast<std::uint8_t>((body_of(work.pairs[row].piece_a) == several ? side_a : 0) |
                                                   (body_of(work.pairs[row].piece_b) == several ? side_b : 0));
  return true;
}

}  // namespace trilith
