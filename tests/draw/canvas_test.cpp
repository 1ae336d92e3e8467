#include "draw/canvas.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "draw/picture_text.hpp"
#include "draw/sample_pictures.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::draw;
using testing::near;

namespace {

Canvas some_drawing() {
  Canvas canvas(200, 100);
  canvas.polygon({{10, 10}, {60, 12}, {40, 60}}, body_tint(1), Stroke{});
  canvas.hatch({{100, 10}, {150, 10}, {150, 60}, {100, 60}}, 45, 4, Stroke{});
  canvas.clipped({0, 0, 50, 50}, [&] { canvas.circle({50, 50}, 20, palette().failed, std::nullopt); });
  canvas.text({20, 90}, "Pier 3 · 1.2 MN", {});
  canvas.text({180, 90}, "upward", {8, true, palette().ink, Align::left, true});
  return canvas;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("the ending chooses the picture format") {
  CHECK(picture_format("a/b.svg") == PictureFormat::svg);
  CHECK(picture_format("b.c.PDF") == PictureFormat::pdf);
  CHECK(picture_format("b.Png") == PictureFormat::png);
  CHECK_THROWS_WITH_AS(picture_format("out.jpg"),
                       "picture 'out.jpg': the extension '.jpg' is not a picture format, must be .svg, .pdf or .png",
                       InputError);
  CHECK_THROWS_AS(picture_format("out"), InputError);
}

TEST_CASE("the same drawing gives the same bytes in every format") {
  const Canvas first = some_drawing(), second = some_drawing();
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png}) {
    const std::string bytes = first.bytes(format);
    CHECK(bytes.size() > 500);
    CHECK(bytes == first.bytes(format));
    CHECK(bytes == second.bytes(format));
  }
  CHECK(first.bytes(PictureFormat::svg).substr(0, 5) == "<?xml");
  CHECK(first.bytes(PictureFormat::pdf).substr(0, 5) == "%PDF-");
  CHECK(first.bytes(PictureFormat::png).substr(1, 3) == "PNG");
}

TEST_CASE("a picture that cannot be written is rejected and nothing is left") {
  const std::filesystem::path folder = testing::picture_path("refused");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "folder.svg");
  CHECK_THROWS_AS(some_drawing().save(folder / "none" / "a.svg"), InputError);
  CHECK_THROWS_AS(some_drawing().save(folder / "folder.svg"), InputError);
  CHECK_THROWS_AS(some_drawing().save(folder / "a.bmp"), InputError);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a full disk leaves the previous picture unchanged") {
  const std::filesystem::path folder = testing::picture_path("full");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.png") << "old";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_AS(some_drawing().save(folder / "a.png"), InputError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(content(folder / "a.png") == "old");
  CHECK(files_in(folder) == 1);
  some_drawing().save(folder / "a.png");
  CHECK(content(folder / "a.png") == some_drawing().bytes(PictureFormat::png));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("text that is not UTF-8 is shown with question marks and never stops the drawing") {
  CHECK(printable_utf8("Br\xFC"
                       "cke") == "Br?cke");
  CHECK(printable_utf8("Brücke µ−²") == "Brücke µ−²");
  CHECK(printable_utf8("a\nb\tc") == "a b c");
  CHECK(printable_utf8("\xED\xA0\x80") == "???");
  CHECK(printable_utf8("\xF0\x9F\x8C") == "???");
  for (int byte = 0; byte < 256; ++byte) {
    Canvas canvas(50, 50);
    canvas.text({5, 20}, std::string(2, static_cast<char>(byte)) + "x", {});
    CHECK(canvas.bytes(PictureFormat::svg).size() > 100);
  }
}

TEST_CASE("wrapped lines fit the width and lose no word") {
  const TextStyle style;
  std::string joined;
  for (const std::string& line : wrap_text("the left fixed bearing of span 3 fails", style, 60)) {
    CHECK(text_width(line, style) <= 60);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(joined == "the left fixed bearing of span 3 fails");
  CHECK(wrap_text("", style, 60).empty());
  const std::vector<std::string> cut = wrap_text("donaudampfschifffahrtsgesellschaft", style, 40);
  REQUIRE(cut.size() == 1);
  CHECK(text_width(cut[0], style) <= 40);
  CHECK(cut[0].ends_with("…"));
}

TEST_CASE("a text is drawn at the place that its alignment defines") {
  Canvas canvas(200, 100);
  canvas.text({100, 50}, "span", {8, false, {}, Align::left});
  canvas.text({100, 50}, "span", {8, false, {}, Align::right});
  canvas.text({100, 50}, "span", {8, false, {}, Align::centre, true});
  const auto& boxes = canvas.text_boxes();
  CHECK(boxes[0].x0 >= 99.5);
  CHECK(boxes[1].x1 <= 100.5);
  CHECK(near((boxes[2].y0 + boxes[2].y1) / 2, 50, 0.02));
  CHECK(boxes[2].x1 <= 103);
}

TEST_CASE("an invalid page size or resolution is rejected") {
  CHECK_THROWS_AS(Canvas(0, 10), InputError);
  CHECK_THROWS_AS(Canvas(10, 1e9), InputError);
  CHECK_THROWS_AS(Canvas(10, 10).bytes(PictureFormat::png, 5), InputError);
  CHECK_THROWS_AS(Canvas(10000, 10000).bytes(PictureFormat::png, 1200), InputError);
}
