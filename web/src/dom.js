// Elements without a template language: el('p', { class: 'note' }, 'text', child).
export function el(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value != null) element.setAttribute(key, value);
  }
  element.append(...children.flat(Infinity).filter((child) => child != null && child !== false));
  return element;
}

// A section of the page under its heading.
export function section(id, title, ...children) {
  return el(
    'section',
    { id, 'aria-labelledby': `${id}-title` },
    el('h2', { id: `${id}-title` }, title),
    ...children,
  );
}

// Rows of cells under a header; columns are { label, number } and cells strings or elements.
export function table(caption, columns, rows) {
  const cell = (name, column, content, attributes = {}) =>
    el(name, { class: column.number ? 'number' : null, ...attributes }, content);
  return el(
    'div',
    { class: 'table', tabindex: 0, role: 'region', 'aria-label': caption },
    el(
      'table',
      {},
      el('caption', {}, caption),
      el(
        'thead',
        {},
        el(
          'tr',
          {},
          columns.map((column) => cell('th', column, column.label, { scope: 'col' })),
        ),
      ),
      el(
        'tbody',
        {},
        rows.map((row) =>
          el(
            'tr',
            {},
            row.map((content, i) =>
              i === 0
                ? cell('th', columns[i], content, { scope: 'row' })
                : cell('td', columns[i], content),
            ),
          ),
        ),
      ),
    ),
  );
}

// What a chart says, as a table for those who want the numbers.
export function figures(caption, columns, rows) {
  return el(
    'details',
    { class: 'figures' },
    el('summary', {}, 'The figures as a table'),
    table(caption, columns, rows),
  );
}
