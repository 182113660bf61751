// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which colour and which place does a planner have? Its properties say so, never its name.

const colours = {euclid: '#7f7f7f', 'hlut-1': '#56b4e9', 'hlut-2': '#009e73', 'hlut-3': '#cc79a7',
  'hlut-4': '#0072b2', 'reeds-shepp': '#d55e00', bound: '#7b4ab5'};
const spare = ['#e69f00', '#8c564b', '#9467bd', '#17becf'];
const strategies = {bsc: 'BSC: parent is the nearest node', opt: 'OPT: parent gives the least total cost'};

const nothingKnown = {summary: '', family: '', strategy: '', estimate: '', tries_goal: false};
const propertiesOf = (planner) => data.planners.find((p) => p.name === planner) || nothingKnown;

// Planners that differ in what ranks their nodes only; those without a strategy are in no group.
const groupOf = ({family, strategy, tries_goal: tries}) => (strategy === '' ? null : `${family} ${strategy} ${tries}`);
const titleOf = ({family, strategy, tries_goal: tries}) => (strategies[strategy] || `${family}, ${strategy}`) +
  (tries ? '; goal tried from every node' : '; goal only sampled');
const labelOf = (planner) => (groupOf(propertiesOf(planner)) ? propertiesOf(planner).estimate || planner : planner);

const others = data.planners.filter((p) => groupOf(p) === null || !colours[p.estimate]).map((p) => p.name);
function colourOf(planner) {
  const known = propertiesOf(planner);
  if (groupOf(known) && colours[known.estimate]) return colours[known.estimate];
  return spare[Math.max(0, others.indexOf(planner)) % spare.length];
}

const named = (planner) => {
  const dot = element('span', {class: 'dot'});
  dot.style.background = colourOf(planner);
  return element('span', {}, dot, planner);
};

// A few others are shown beside every group, many get a place of their own.
function inGroups(methods) {
  const groups = new Map();
  const rest = [];
  for (const method of methods) {
    const known = propertiesOf(method.planner);
    const key = groupOf(known);
    if (key === null) rest.push(method);
    else if (groups.has(key)) groups.get(key).methods.push(method);
    else groups.set(key, {title: titleOf(known), methods: [method]});
  }
  const full = [...groups.values()];
  if (full.length === 0 || rest.length > 2)
    return full.concat(rest.length ? [{title: 'Others', methods: rest}] : []);
  return full.map((group) => ({title: group.title, methods: group.methods.concat(rest)}));
}
