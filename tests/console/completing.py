"""Tab, help and apropos."""
from sessions import FALL, check, run_all

PLACES = FALL + """m:bearing { name = "S3.left", between = { "base", "block" }, at = { 0, 0.2 },
            along = trilith.linear { stiffness = 1e6 } }
m:history { name = "height of the block", body = block, what = "y" }
"""


def session_tab_completes_a_local_of_the_script(place):
    s = place.console("-i", "fall.lua")
    s.type("blo\t")
    s.expect("block$")
    s.type("\r")
    s.expect("^body 'block'")


def session_tab_lists_what_there_is(place):
    s = place.console("-i", "fall.lua")
    s.type("m.bas\t")
    s.expect(r"m\.base_shear$")
    s.interrupt()
    s.type("m:che\t")
    s.expect(r"m:checkpoints$")
    s.interrupt()
    s.type("m:co\t\t")
    s.expect(r"compare +.*consolidate.*contact.*^> m:co$")


def session_tab_completes_fields_of_a_body(place):
    s = place.console("-i", "fall.lua")
    s.type("block.rot\t\r")
    s.expect("^0$")


def session_tab_completes_names_in_strings(place):
    place.write("places.lua", PLACES)
    s = place.console("-i", "places.lua")
    s.type('m:body "blo\t"\r')
    s.expect("^body 'block'")
    s.type('m.bearings["S\t"].name\r')
    s.expect(r"^S3\.left$")
    s.type('m:fix("upp\t")\r')
    s.expect(r'm:fix\("upper"\)\s+^> $')
    s.type('m:history { name = "height\t')
    s.expect(r'"height ?of the block$')
    s.interrupt()
    s.type("m:break_on 'bearing.f\t'\r")
    s.expect("^1$")


def session_tab_completes_files(place):
    place.write("motions_of_1940.csv", "")
    s = place.console("-i", "fall.lua")
    s.type('trilith.motion "motions_o\t')
    s.expect(r'"motions_of_1940\.csv$')
    s.interrupt()
    s.type('m:results { file = "fal\t')
    s.expect(r'"fall\.lua$')
    s.interrupt()


def session_tab_completes_keys_of_a_call(place):
    s = place.console("-i", "fall.lua")
    s.type("m:consolidate { dur\t")
    s.expect(r"duration$")
    s.type(" = 0.01, re\t")
    s.expect(r"rest$")
    s.interrupt()
    s.type("trilith.frictional { k\t\t")
    s.expect(r"kn +ks")


def session_tab_completes_the_module(place):
    s = place.console("-i", "fall.lua")
    s.type("trilith.fric\t\t")
    s.expect(r"friction +frictional")
    s.interrupt()
    s.type("trilith.build.runn\t")
    s.expect(r"running_bond$")


def session_tab_where_nothing_fits_adds_nothing(place):
    s = place.console()
    s.type("zzzz\t1 = 5\r")
    s.query("zzzz1", "^5$")


def session_help_of_everything(place):
    s = place.console("-i", "fall.lua")
    s.query("help", r"Tab completes.*stages +Stages: runs.*leaves the console\.\s+^> $")
    s.query('help "m.consolidate"', r"^model:consolidate\{\.\.\.\}\s+Brings the model to rest under dead load.*rest +rest, optional +limits of rest: \{ ratio = 1e-5.*gives: report")
    s.query("help(m.run)", r"^model:run\{\.\.\.\}")
    s.query("help(block)", r"^body 'block'.*body\.rotation +counter-clockwise")
    s.query("help(trilith.frictional)", r"^trilith\.frictional\{\.\.\.\}.*mu +number")
    s.query('help "stages"', r"^Stages: .*model:shake +Bodies follow")
    s.query('help "event"', r"event\.cause +id of the event")
    s.query('help "%s"', r"help: there is nothing called '%s'")
    s.query('help "rnu"', r"help: there is nothing called 'rnu'; did you mean 'run'\?")
    s.query("help(3)", r"^a integer: 3|^an? integer")


def session_apropos(place):
    s = place.console()
    s.query('apropos "bearing"', r"model:bearing +A bearing between two bodies")
    s.query('apropos "qqq"', r"^no entry mentions 'qqq'")
    s.query("apropos(3)", r"^apropos: takes a word")


def session_long_tables_are_cut(place):
    s = place.console()
    s.line("local t = {}")
    s.line("for i = 1, 100 do t[i] = i end")
    s.query("t", r"and 76 more")
    s.line("t.t = t")
    s.query("{ deep = { { { { 1 } } } } }", r"\{ deep = \{ \{ \{ \.\.\. \} \} \} \}")


if __name__ == "__main__":
    run_all(dict(globals()))
