"""Terms that readers search for, and the page that must be the first result."""
SEARCHES = {
    "bearing limit": "docs/guide/bridges",
    "Rayleigh damping": "docs/reference/values",
    "restart": "docs/guide/restart",
    "fragility": "docs/guide/studies",
    "hysteresis": "docs/guide/plots",
    "time history": "docs/guide/plots",
    "pushover": "docs/scripting/loads",
    "seat.lost": "docs/reference/events",
    "trilith.pendulum": "docs/reference/laws",
}
