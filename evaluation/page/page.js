// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What is shown when? Comes last: it begins.

function render() {
  const regions = [...new Set(data.cells.map((c) => c.region))];
  if (!cell(state.scenario, state.region))
    state.scenario = data.cells.find((c) => c.region === state.region).scenario;
  const c = cell(state.scenario, state.region);
  switcher($('regions'), regions.map((r) => [r, `samples: ${r}`]), 'region');
  switcher($('chips'), data.cells.filter((x) => x.region === state.region)
    .map((x) => [x.scenario, short(scenarioOf(x).name)]), 'scenario');
  switcher($('measures'), Object.entries(measures).map(([key, m]) => [key, m.label]), 'measure');
  switcher($('examples'), [['typical', 'Typical path'], ['best', 'Best path']], 'example');
  $('scenario-title').textContent = `${short(scenarioOf(c).name)}, samples from the ${c.region}`;
  $('scenario-description').textContent = scenarioOf(c).description;
  renderMatrix();
  renderPooled();
  renderSearches();
  renderMethods(c);
  renderCostCharts(c);
  renderSuccessCharts(c);
  renderBoxCharts(c);
  renderTwins(c);
  renderGallery(c);
  renderRuns(c);
}

renderFrame();
render();
