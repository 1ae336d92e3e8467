-- trilith manual: `(what, name)` returns a text, or nil and the reason.
local console = ...

function console.manual_text(what, name)
  if what == "meta" then return console.meta_text() end
  if what == "check" then
    local wrong = console.undeclared()
    if #wrong == 0 then return ("%d declarations, none left out\n"):format(#console.manual().list) end
    return nil, table.concat(wrong, "\n")
  end
  if what == "pages" then return console.page_names() end
  if what == "markdown" then
    local good, text = pcall(console.page_markdown, name ~= "" and name or nil)
    if good then return text end
    return nil, text
  end
  local good, text = pcall(console.help_text, name ~= "" and name or nil)
  if good then return text .. "\n" end
  return nil, text
end
