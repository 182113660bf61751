// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a table sort, and how does the reader choose what he looks at?

function bestOf(values, best) {
  const known = values.filter((v) => v !== null && v !== undefined);
  return known.length ? (best === 'low' ? Math.min : Math.max)(...known) : null;
}

// columns: {title, value(row) for sorting, show(row), best: 'low' | 'high' or isBest(row), text, hint}
function table(columns, rows, options) {
  const {sorted, chosen} = options || {};
  const order = sorted || {column: -1, up: true};
  const body = element('tbody');
  const heads = columns.map((column, i) => {
    const head = element('th', {scope: 'col', title: column.hint || null},
      element('button', {on: () => sort(i)}, column.title));
    return head;
  });
  const bests = columns.map((column) => (column.best ? bestOf(rows.map(column.value), column.best) : null));
  const isBest = (column, i, row) => column.value(row) !== null &&
    (column.isBest ? column.isBest(row) : column.value(row) === bests[i]);
  function sort(i) {
    order.up = order.column === i ? !order.up : true;
    order.column = i;
    fill();
  }
  function fill() {
    heads.forEach((head, i) => {
      if (i === order.column) head.setAttribute('aria-sort', order.up ? 'ascending' : 'descending');
      else head.removeAttribute('aria-sort');
    });
    const shown = rows.slice();
    if (order.column >= 0) {
      const value = columns[order.column].value;
      const sign = order.up ? 1 : -1;
      shown.sort((a, b) => {
        const [x, y] = [value(a), value(b)];
        if (x === y) return 0;
        if (x === null || x === undefined) return 1;  // what is missing comes last
        if (y === null || y === undefined) return -1;
        return (x < y ? -1 : 1) * sign;
      });
    }
    body.replaceChildren(...shown.map((row) => {
      const line = element('tr', chosen ? {on: () => chosen(row, line)} : {},
        ...columns.map((column, i) => {
          const content = column.show(row);
          const best = isBest(column, i, row) ? 'best' : '';
          const kind = content === none ? 'none' : column.text ? 'text' : '';
          return element('td', {class: `${best} ${kind}`.trim() || null}, content);
        }));
      return line;
    }));
  }
  fill();
  return element('table', {}, element('thead', {}, element('tr', {}, ...heads)), body);
}

function switcher(container, choices, key) {
  container.replaceChildren(...choices.map(([value, label]) =>
    element('button', {'aria-pressed': String(state[key] === value), type: 'button', on: () => {
      state[key] = value;
      render();
    }}, label)));
}
