// Writes and reads the state of a recording in restart files, so that another process can continue it.
#include "base/bytes.hpp"
#include "results/file/extended.hpp"
#include "run/record/recording.hpp"

namespace trilith {

template <int D>
template <class File>
void Recording<D>::walk(File& file) {
  file.item(has_frame_), file.item(stage_), file.item(analyses_), file.item(stage_open_);
  file.item(drives_known_), file.item(motions_kept_), file.item(time_);
  file.item(has_balance_), file.item(first_balance_);
  check_.each_number([&](double& v) { file.item(v); });
}

template <int D>
void Recording<D>::write(ByteWriter& out) {
  out.item(writer_.rows());
  walk(out);
}

template <int D>
void Recording<D>::read(ByteReader& in, const std::filesystem::path& rows) {
  const auto counts = in.get<results::RowCounts>();
  walk(in);
  results::continue_rows(rows, header_, counts, stage_open_, writer_);
}

template void Recording<2>::write(ByteWriter&);
template void Recording<3>::write(ByteWriter&);
template void Recording<2>::read(ByteReader&, const std::filesystem::path&);
template void Recording<3>::read(ByteReader&, const std::filesystem::path&);

}  // namespace trilith
