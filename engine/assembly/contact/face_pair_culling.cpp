#include "assembly/contact/face_pair_culling.hpp"

#include <algorithm>

#include "assembly/contact/face_columns.hpp"
#include "base/team.hpp"
#include "law/contact/face_overlap.hpp"

namespace trilith {
namespace {

/// Pads the last rows of a list for reading in groups of four.
template <class List>
void pad(List&& rows, std::size_t count) {
  if (count == 0) return;
  for (std::size_t i = 0; i + 1 < lane_count; ++i) rows[count + i] = rows[count - 1];
}

/// True if the line along one of the two faces certainly separates the two pieces: both ends of the other face lie
/// beyond it, and no corner next to them can reach back. A row that does not touch has no memory and no effect.
TRILITH_INLINE LaneMask clearly_apart(const SkinMotion<2>* skin, const NearPair* const* p) {
  const Lanes slack = Lanes{} + 1e-12;  // times the length of the face, far above the rounding of positions
  Lanes ax0, ay0, ax1, ay1, bx0, by0, bx1, by1;
  load_ends(skin, p, &NearPair::a0, &SkinMotion<2>::x, ax0, ay0);
  load_ends(skin, p, &NearPair::a1, &SkinMotion<2>::x, ax1, ay1);
  load_ends(skin, p, &NearPair::b0, &SkinMotion<2>::x, bx0, by0);
  load_ends(skin, p, &NearPair::b1, &SkinMotion<2>::x, bx1, by1);
  const Lanes corner{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner};
  const Lanes ax = ax1 - ax0, ay = ay1 - ay0, bx = bx1 - bx0, by = by1 - by0;
  const Lanes x0 = bx0 - ax0, y0 = by0 - ay0, x1 = bx1 - ax0, y1 = by1 - ay0;
  const Lanes cosine = ax * bx + ay * by, sine = ax * by - ay * bx;
  // Height of b's ends over a's face, and of a's ends over b's face, times the length of the face.
  const Lanes over_a = smaller(ay * x0 - ax * y0, ay * x1 - ax * y1);
  const Lanes over_b = smaller(bx * y0 - by * x0, bx * y0 - by * x0 + sine);
  // With `corner` at most 1 the surface edges next to a face turn away by 45 degrees or more. At a tilt below atan(1/2)
  // they do not lead back over the line.
  const LaneMask parallel = (corner <= 1.0 + Lanes{}) & (magnitude(sine) < -0.5 * cosine);
  return parallel & ((over_a > slack * (ax * ax + ay * ay)) | (over_b > slack * (bx * bx + by * by)));
}

/// The faces of four pairs in their present position.
struct FourFacePairs {
  FaceEnds<Lanes> a{}, b{};
  FaceOverlap<Lanes> overlap;
  Lanes corner;

  TRILITH_INLINE FourFacePairs(const SkinMotion<2>* skin, const NearPair* const* p)
      : corner{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner} {
    load_ends(skin, p, &NearPair::a0, &SkinMotion<2>::x, a.x0, a.y0);
    load_ends(skin, p, &NearPair::a1, &SkinMotion<2>::x, a.x1, a.y1);
    load_ends(skin, p, &NearPair::b0, &SkinMotion<2>::x, b.x0, b.y0);
    load_ends(skin, p, &NearPair::b1, &SkinMotion<2>::x, b.x1, b.y1);
    overlap = FaceOverlap<Lanes>(a, b);
  }
};

/// True for faces that share no length and are flat with their neighbours in line. The kernel would find a pair of
/// faces (see join_lines) that does not touch. Each face of a mesh in a joint has two such neighbours next to the
/// opposite face.
TRILITH_INLINE LaneMask lie_beside(const FaceLine& line, const SkinMotion<2>* skin, const NearPair* const* p) {
  const FourFacePairs faces(skin, p);
  return flip(faces.overlap.sane) &
         are_flat_in_line<Lanes>(faces.overlap, load_next(line, skin, p, faces.a, faces.b), faces.corner);
}

/// Keeps the rows that may touch among the first `count` rows of a padded list that did not touch, in their order.
/// `before`: contact memories; bonded rows are always kept.
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] std::size_t keep_near(const FaceLine& line,
                                                                                  const ContactMemory* before,
                                                                                  const SkinMotion<2>* skin,
                                                                                  const NearPair* pairs, int* rows,
                                                                                  std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += lane_count) {
    const int four[lane_count] = {rows[i], rows[i + 1], rows[i + 2], rows[i + 3]};
    const NearPair* const p[lane_count] = {&pairs[four[0]], &pairs[four[1]], &pairs[four[2]], &pairs[four[3]]};
    LaneMask apart = clearly_apart(skin, p);
    if (line.is_there() && any(flip(apart))) {
      LaneMask beside = lie_beside(line, skin, p);
      for (int lane = 0; lane < lane_count; ++lane)
        if (before[four[lane]].bonds != 0) beside[lane] = 0;
      apart |= beside;
    }
    for (int lane = 0; lane < lane_count; ++lane) {
      rows[kept] = four[lane];
      kept += i + static_cast<std::size_t>(lane) < count && apart[lane] == 0 ? 1 : 0;
    }
  }
  return kept;
}

/// Bit i: the faces of row i of four form a pair of faces without regard to bonds, as the kernel tests.
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] unsigned are_faces(const SkinMotion<2>* skin,
                                                                               const NearPair* pairs, const int* row) {
  const NearPair* const p[lane_count] = {&pairs[row[0]], &pairs[row[1]], &pairs[row[2]], &pairs[row[3]]};
  const FourFacePairs faces(skin, p);
  const LaneMask are = faces.overlap.sane & faces.overlap.is_flat(faces.corner);
  unsigned bits = 0;
  for (int i = 0; i < lane_count; ++i) bits |= are[i] != 0 ? 1U << i : 0U;
  return bits;
}

}  // namespace

namespace {

/// Rows per chunk of a thread, about 5 microseconds.
constexpr int sorted_stretch = 512;
/// Buffer size of a chunk, padding included.
constexpr std::size_t stretch_room = sorted_stretch + lane_count;

/// A list that grows downwards from `end` with `count` rows that were of general shape in the last step. Keeps the rows
/// that still are, which the kernel need not test. Returns their number.
std::size_t keep_tumbling(const FaceLine& line, const Work<2>& work, int* end, std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t from = 0; from < count; from += lane_count) {
    int four[lane_count];
    for (std::size_t i = 0; i < lane_count; ++i) four[i] = *(end - 1 - (from + i < count ? from + i : from));
    const unsigned faces = are_faces(work.skin.data(), work.pairs.data(), four);
    for (std::size_t i = 0; i < lane_count && from + i < count; ++i)
      if ((faces >> i & 1U) == 0 &&
          !(line.is_there() && is_flat_in_line(line, work.skin.data(), work.pairs[static_cast<std::size_t>(four[i])])))
        *(end - ++kept) = four[i];
  }
  return kept;
}

/// Removes the rows of such a list, which are in the same order, from the first `count` of `rows`; returns the number
/// of remaining rows.
std::size_t without(const int* end, std::size_t tumbling, int* rows, std::size_t count) {
  std::size_t left = 0, next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    rows[left] = rows[i];
    if (next < tumbling && rows[i] == *(end - 1 - next))
      ++next;
    else
      ++left;
  }
  return left;
}

/// Sorts `count` rows of opposed faces. Rows that touched are written to `rows`, rows that may touch now to `fresh`.
/// Rows that remain of general shape are written to the end of the buffer of `fresh`. Both buffers can hold all rows
/// and the padding.
SortedRows sort_stretch(const FaceLine& line, const ContactHistory& before, const Work<2>& work, const int* facing,
                        std::size_t count, int* rows, int* fresh) {
  constexpr std::uint32_t shapeless = contact_touching | contact_general;
  int* const end = fresh + stretch_room;
  std::size_t touched = 0, rest = 0, tumbling = 0;
  std::uint32_t seen = 0;
  static_assert(contact_touching == 1 && contact_kept == 4);
  for (std::size_t i = 0; i < count; ++i) {  // without branches: touching rows are hard to predict
    const int row = facing[i];
    const std::uint32_t state = before.memory[row].state, was = (state | state >> 2) & 1;
    rows[touched] = fresh[rest] = row;
    touched += was;
    rest += was ^ 1;
    seen |= state;
  }
  if ((seen & contact_general) != 0) {  // in a standing wall there are none
    for (std::size_t i = 0; i < touched; ++i) {
      const ContactMemory& memory = before.memory[rows[i]];
      if ((memory.state & shapeless) == shapeless && memory.bonds == 0) *(end - ++tumbling) = rows[i];
    }
    tumbling = keep_tumbling(line, work, end, tumbling);
    touched = without(end, tumbling, rows, touched);
  }
  pad(fresh, rest);
  return {touched, keep_near(line, before.memory.data(), work.skin.data(), work.pairs.data(), fresh, rest), tumbling};
}

}  // namespace

/// Rows that touched, or have a memory, come first and are always processed; of the others only the rows that may touch
/// now. Both are in their order, independent of the chunks of the threads. The output is padded for reading in groups
/// of four.
NearRows sort_out(const FaceLine& line, const ContactHistory& before, Work<2>& work, const std::vector<int>& facing,
                  std::vector<int>& rows, std::vector<int>& fresh) {
  const std::size_t stretches = (facing.size() + sorted_stretch - 1) / sorted_stretch;
  constexpr std::size_t room = stretch_room;
  rows.resize(stretches * room), fresh.resize(stretches * room);
  work.sorted_rows.resize(stretches);
  share(work.threads, static_cast<int>(stretches), 1, [&](int first, int last, int /*thread*/) {
    for (int s = first; s < last; ++s) {
      const std::size_t from = static_cast<std::size_t>(s) * sorted_stretch, to = static_cast<std::size_t>(s) * room;
      work.sorted_rows[static_cast<std::size_t>(s)] = sort_stretch(
          line, before, work, facing.data() + from, std::min<std::size_t>(sorted_stretch, facing.size() - from),
          rows.data() + to, fresh.data() + to);
    }
  });
  std::size_t count = 0;
  const auto append = [&](std::size_t stretch, const std::vector<int>& from, std::size_t many) {
    // Within `rows`, to the left of the present position.
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(stretch * room), many,
                rows.begin() + static_cast<std::ptrdiff_t>(count));
    count += many;
  };
  for (std::size_t s = 0; s < stretches; ++s) {
    const auto end = fresh.begin() + static_cast<std::ptrdiff_t>((s + 1) * room);
    work.general_now.insert(work.general_now.end(), end - static_cast<std::ptrdiff_t>(work.sorted_rows[s].tumbling),
                            end);
  }
  count = stretches == 0 ? 0 : work.sorted_rows[0].touched;  // they are in their final position
  for (std::size_t s = 1; s < stretches; ++s) append(s, rows, work.sorted_rows[s].touched);
  const std::size_t touched = count;
  for (std::size_t s = 0; s < stretches; ++s) append(s, fresh, work.sorted_rows[s].fresh);
  pad(rows, count);
  return {count, touched};
}

}  // namespace trilith
