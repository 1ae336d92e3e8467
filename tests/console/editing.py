"""Typing: expressions, lines, history, completion."""
import os

from sessions import check, run_all


def session_expression_is_shown_and_ctrl_d_leaves(place):
    s = place.console()
    s.query("1 + 2*3", r"^7$")
    s.query('"a" .. "b"', r"^ab$")
    s.query("nil, 2", r"^nil\s+^2$")
    s.type("\x04")
    s.ends(0)


def session_trilith_is_there_without_require(place):
    s = place.console()
    s.query('trilith.build.block { width = 1, height = 1 } ~= nil', r"^true$")
    s.line("local trilith = 7")
    s.query("trilith", r"^7$")


def session_locals_of_a_line_are_seen_by_the_next(place):
    s = place.console()
    s.line("local width = 3")
    s.query("width*2", r"^6$")
    s.line("width = 5")
    s.query("width", r"^5$")


def session_lines_belong_together_until_the_chunk_is_whole(place):
    s = place.console()
    s.line("function twice(x)")
    s.expect(r"^>> ")
    s.line("return 2*x")
    s.expect(r"^>> ")
    s.line("end")
    s.query("twice(21)", r"^42$")


def session_ctrl_c_drops_the_line(place):
    s = place.console()
    s.type("x = (1 +")
    s.expect(r"x = \(1 \+$")
    s.interrupt()
    s.expect(r"^> $")
    s.query("1 + 1", r"^2$")


def session_ctrl_c_drops_an_unfinished_chunk(place):
    s = place.console()
    s.line("for i = 1, 3 do")
    s.expect(r"^>> ")
    s.interrupt()
    s.query("1 + 1", r"^2$")


def session_arrow_up_brings_the_last_line(place):
    s = place.console()
    s.query("40 + 2", r"^42$")
    s.type("\x1b[A")
    s.expect(r"40 \+ 2")
    s.type("0\r")
    s.expect(r"^60$")


def session_line_is_edited_in_its_middle(place):
    s = place.console()
    s.type("10 + 1\x01\x1b[C\x1b[C0\r")
    s.expect(r"^101$")


def session_history_is_kept_between_sessions(place):
    kept = {"TRILITH_HISTORY": "", "XDG_STATE_HOME": os.path.join(place.folder, "state")}
    del kept["TRILITH_HISTORY"]
    kept["TRILITH_HISTORY"] = os.path.join(place.folder, "lines", "kept")
    s = place.console(environment=kept)
    s.query("6*7 + 0", r"^42$")
    s.query(" 'not kept, with a blank before'", r"^not kept, with a blank before$")
    s.type("\x04")
    s.ends(0)
    check(open(kept["TRILITH_HISTORY"]).read() == "6*7 + 0\n", "the file holds something else")
    check(os.stat(kept["TRILITH_HISTORY"]).st_mode & 0o077 == 0, "others can read the history")
    s = place.console(environment=kept)
    s.type("\x1b[A\r")
    s.expect(r"^42$")


def session_history_that_cannot_be_written_is_reported_once(place):
    place.write("file", "")
    s = place.console(environment={"TRILITH_HISTORY": os.path.join(place.folder, "file", "history")})
    s.query("1 + 1", r"the history of this console is not saved: cannot write .*^2$")
    s.query("2 + 1", r"^3$")
    check(s.text.count("is not saved") == 1, "printed twice")


def session_letters_of_other_alphabets(place):
    s = place.console()
    s.query('"Säule" .. " π"', r"^Säule π$")


def session_tab_completes_a_global(place):
    s = place.console()
    s.type("ppp = 4\r")
    s.expect("^> $")
    s.type("coll\t")
    s.expect(r"collectgarbage")
    s.interrupt()
    s.type("pp\t\r")
    s.expect(r"^4$")


if __name__ == "__main__":
    run_all(dict(globals()))
