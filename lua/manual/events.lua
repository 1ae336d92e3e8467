return {
  name = "events", title = "Types of events, their severity, and the meaning of their value",
  --- Rows come from engine/model/event/event_list.hpp.
  has_events = true,
}
