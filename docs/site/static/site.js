// Sets the formulas of a page, marks tables of keys and terms, keeps numbers and units together, and adds the first sentence of each
// page to the results of the search.
document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".formula")) {
    katex.render(place.textContent, place, { displayMode: place.tagName === "DIV", throwOnError: false, strict: false });
  }
  for (const table of document.querySelectorAll("article table")) {
    const head = [...table.querySelectorAll("thead th")].map((cell) => cell.textContent.trim());
    if (head.length >= 4 && ["key", "argument", "field", "term"].includes(head[0])) table.classList.add("facts");
    if (head[0] === "term") table.classList.add("terms");
  }
  for (const cell of document.querySelectorAll("article td")) {
    if (/^[+-]?[\d.,]+(e[+-]?\d+)?( \S{1,6}){0,2}$/.test(cell.textContent.trim())) cell.classList.add("number");
  }
  const results = document.getElementById("search-results");
  if (!results || !window.summaries) return;
  const root = new URL(document.documentElement.dataset.content_root || "./", document.baseURI);
  const seen = new Set();
  const describe = () => {
    for (const item of results.querySelectorAll("li:not([data-described])")) {
      const link = item.querySelector("a");
      if (!link) continue;
      item.dataset.described = "yes";
      const [page, anchor] = decodeURI(link.href).slice(root.href.length).split("#");
      const name = page.replace(/\.html.*/, "");
      if (seen.has(name) && (!anchor || seen.has(`${name}#${anchor}`))) {
        item.hidden = true;
        continue;
      }
      seen.add(name).add(`${name}#${anchor}`);
      if (!window.summaries[name]) continue;
      const line = document.createElement("p");
      line.className = "summary";
      line.textContent = window.summaries[name];
      item.append(line);
    }
  };
  new MutationObserver(describe).observe(results, { childList: true, subtree: true });
  describe();
});
