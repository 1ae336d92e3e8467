"""Input from a pipe: no prompt, no banner, errors on stderr, and an exit code that is 0 if all chunks succeeded."""
from sessions import check, run_all


def session_piped_lines_give_their_values_alone(place):
    code, out, err = place.pipe("1 + 1\nlocal x = 20\nfunction f(y)\n  return y + x\nend\nf(22)\n")
    check((code, out, err) == (0, "2\n42\n", ""), (code, out, err))


def session_piped_error_is_reported_the_rest_runs_the_code_is_1(place):
    code, out, err = place.pipe("error 'no'\n1 + 1\n")
    check(code == 1 and out == "2\n" and "no" in err, (code, out, err))


def session_piped_chunk_that_does_not_end(place):
    code, out, err = place.pipe("1 + 1\nfor i = 1, 2 do\n")
    check(code == 1 and out == "2\n" and "the input ends within a chunk" in err, (code, out, err))


def session_piped_wrong_syntax(place):
    code, _, err = place.pipe("x = = 2\n")
    check(code == 1 and "unexpected symbol near '='" in err, (code, err))


def session_piped_nothing(place):
    check(place.pipe("") == (0, "", ""), "something was printed")


def session_piped_after_a_script(place):
    code, out, err = place.pipe("m.name\nreport.ending\n", "-i", "run.lua", "-q")
    check(code == 0 and out.endswith("fall\ntime\n") and err == "", (code, out, err))


def session_piped_script_that_fails(place):
    place.write("wrong.lua", "local x = 4\nerror 'stop here'\n")
    code, out, err = place.pipe("x\n", "-i", "wrong.lua")
    check(code == 1 and out == "4\n" and "wrong.lua:2: stop here" in err, (code, out, err))


def session_piped_script_that_is_not_there(place):
    code, _, err = place.pipe("1\n", "-i", "none.lua")
    check(code == 1 and "cannot read script 'none.lua'" in err, (code, err))


def session_parameters_reach_the_script(place):
    place.write("p.lua", "local p = require('trilith').params { pga = { 1, unit = 'g', 'peak' } }\n")
    code, out, _ = place.pipe("p.pga\n", "-i", "p.lua", "pga=2")
    check(code == 0 and out == "19.6133\n", (code, out))


if __name__ == "__main__":
    run_all(dict(globals()))
