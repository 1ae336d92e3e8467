return {
  name = "heat", title = "Heat: conduction, thermal strain and processes",
  { "model:heat", "Gives bodies thermal properties and a temperature at the start. A rigid body has one temperature, a "
    .. "mesh one at each node, a frame one at each face of its sections at each node.",
    also = "temperature, conduction, thermal expansion, thermal strain, specific heat", keys = [[
body           bodies              bodies, in the model from the start
conductivity   number W/(m K)      thermal conductivity  <at least 0>
heat_capacity  number J/(kg K)     specific heat capacity  <above 0>
expansion      number 1/K = 0      coefficient of linear expansion, of bodies that deform  <at least 0>
temperature    number degC = 0     temperature at the start
reference      number degC = temperature  temperature without thermal strain
depth          number m?           of frames: distance of the lower and the upper face of their sections  <above 0>]],
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900, temperature = 10 }' },
  { "model:heat_exchange", "Exchange of heat between faces and a surrounding of given temperature. Faces without "
    .. "exchange are insulated. Returns its name.",
    also = "air, convection, boundary condition, season, day", keys = [[
body         bodies             bodies with thermal properties
temperature  course             temperature [degC]: a number, or { {time, value}, ..., period = seconds }
exchange     number W/(m2 K)?   surface coefficient; without it the faces have that temperature  <above 0>
side         text?              faces: left, right, top, bottom or all; in space front and back too
from         point?             in the plane, instead of side: start of a part of the outline
to           point?             end of that part, counter-clockwise
name         text?              name in readings]], gives = "string",
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900 }\n'
      .. 'm:heat_exchange { body = "block", side = "left", temperature = 20, exchange = 10 }' },
  { "model:heat_contact", "Conductance of contacts per area. Heat flows through the closed part of a joint. "
    .. "Without it contacts are insulated; a later call takes precedence.",
    also = "thermal contact resistance", keys = [[
conductance  number W/(m2 K)    conductance of the area in contact  <at least 0>
body         bodies?            contacts of these bodies; all contacts if none is given
friction     flag = false       the energy that friction of contacts dissipates heats both bodies, from now on]],
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900 }\nm:heat_contact { conductance = 20 }' },
  { "model:set_temperature", "Changes the temperature of bodies at once, between stages. Find equilibrium afterwards.",
    keys = [[
body         bodies             bodies with thermal properties
temperature  number degC        new mean temperature
gradient     number K/m = 0     increase upwards from the centroid, in frames over the depth of their sections]],
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900 }\n'
      .. 'm:set_temperature { body = "block", temperature = 30 }' },
  { "model:temperature", "Temperature of a body, the mean weighted by heat capacity, or at a point of it at the start; "
    .. "and in frames the upper less the lower face [degC].",
    args = "body  body  body with thermal properties\npoint  point?  {x, y} at the start, in space {x, y, z}",
    gives = "number, number",
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900, temperature = 10 }\n'
      .. 'print(m:temperature "block")' },
  { "model:heat_state", "State of the heat: clock of its processes [s], content relative to 0 degC [J], cells, "
    .. "and surroundings by name, each with temperature and supplied heat [J].", gives = "table",
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900, temperature = 10 }\n'
      .. 'print(m:heat_state().content)' },
  { "model:process", "A process on the clock of the heat, such as a season. After each step the structure is brought "
    .. "to static equilibrium. The model's time advances by 1 s in all.",
    also = "season, year, thermal analysis, transient heat", keys = [[
duration   number s            duration on the clock of the heat  <above 0>
step       number s            longest step  <above 0>
mechanics  flag = true         equilibrium after each step; false: the structure stays as it is
within     number = 0.25       largest motion of a body over its size in a step  <above 0>
tolerance  number = 1e-8       residual force, as a share of the largest force  <above 0, at most 0.01>
or_go_on   flag = false        without equilibrium: the process ends there, without an error
name       text = "process"    name in results]], gives = "report",
    example = 'm:heat { body = "block", conductivity = 2, heat_capacity = 900, temperature = 10 }\n'
      .. 'm:process { duration = 3600, step = 600, mechanics = false }' },
}
