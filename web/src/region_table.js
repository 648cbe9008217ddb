// The table of all regions. Only the rows in view are made, so a hundred thousand of them cost nothing.
import { by_id, element, format_number, group_digits } from './panel.js';

const kRowHeight = 24;  // pixels, as in style.css
const kSpare = 6;       // rows above and below those in view

const kColumns = [
  ['label', 'Region'],
  ['area', 'Area'],
  ['energy', 'Energy'],
  ['neighbours', 'Next to', 'Number of neighbours'],
];

function value_of(cell, label, key) {
  if (key === 'label') return label;
  if (key === 'neighbours') return cell.neighbours.length;
  return cell[key] ?? -Infinity;
}

// The labels in the order of a column; equal values in that of the labels.
export function sort_labels(cells, key, ascending) {
  const values = cells.map((cell, label) => value_of(cell, label, key));
  const order = values.map((_, label) => label);
  return order.sort((a, b) => (ascending ? values[a] - values[b] : values[b] - values[a]) || a - b);
}

export class RegionTable {
  // Calls `pin` with the label of a row that is clicked.
  constructor(pin) {
    this.pin = pin;
    this.pinned = null;
    this.sort_by_label();
    [this.cells, this.order] = [[], []];
    this.box = by_id('region-rows');
    this.body = this.box.querySelector('tbody');
    this.make_head();
    this.box.addEventListener('scroll', () => this.show_rows());
    by_id('regions').addEventListener('toggle', () => this.show_rows());
  }

  make_head() {
    for (const [key, textContent, title = ''] of kColumns) {
      const button = element('button', { type: 'button', textContent, title });
      button.addEventListener('click', () => this.sort_by(key));
      const cell = element('th', { scope: 'col' }, button);
      cell.dataset.key = key;
      this.box.querySelector('thead tr').append(cell);
    }
  }

  sort_by_label() {
    [this.key, this.ascending] = ['label', true];
  }

  // As at the start, when the next scene is shown.
  reset() {
    this.sort_by_label();
    this.box.scrollTop = 0;
  }

  // Shows the cells of a scene; `colour` gives the CSS colour of a label.
  show(cells, colour) {
    [this.cells, this.colour] = [cells, colour];
    by_id('regions').hidden = cells.length === 0;
    by_id('regions').querySelector('small').textContent = group_digits(cells.length);
    this.sort();
  }

  sort_by(key) {
    this.ascending = this.key === key ? !this.ascending : key === 'label';
    this.key = key;
    this.sort();
  }

  sort() {
    this.order = sort_labels(this.cells, this.key, this.ascending);
    for (const cell of this.box.querySelectorAll('th[data-key]')) {
      const own = cell.dataset.key === this.key;
      cell.setAttribute('aria-sort', own ? (this.ascending ? 'ascending' : 'descending') : 'none');
    }
    this.show_rows();
  }

  mark(label) {
    this.pinned = label;
    for (const row of this.body.rows) row.classList.toggle('pinned', row.dataset.label === String(label));
  }

  show_rows() {
    const first = Math.max(0, Math.floor(this.box.scrollTop / kRowHeight) - kSpare);
    const count = Math.ceil((this.box.clientHeight || 240) / kRowHeight) + 2 * kSpare;
    const rows = this.order.slice(first, first + count);
    const space = (n) => {
      const row = element('tr', { ariaHidden: 'true' });
      row.style.height = `${Math.max(0, n) * kRowHeight}px`;
      return row;
    };
    const shown = rows.map((label) => this.make_row(label));
    const focused = this.body.contains(document.activeElement) ? document.activeElement.closest('tr').dataset.label : null;
    this.body.replaceChildren(space(first), ...shown, space(this.order.length - first - rows.length));
    if (focused !== null) this.focus_row(focused);
  }

  // Gives the new row of a label the focus that its old one had; the table, where the row is out of view.
  focus_row(label) {
    const row = [...this.body.rows].find(({ dataset }) => dataset.label === label);
    (row?.querySelector('button') ?? this.box).focus({ preventScroll: true });
  }

  make_row(label) {
    const cell = this.cells[label], swatch = element('i');
    swatch.style.background = this.colour(label);
    const button = element('button', { type: 'button' }, swatch, String(label));
    const texts = [cell.area, cell.energy].map((value) => (Number.isFinite(value) ? short(value) : ''));
    const others = [...texts, cell.neighbours.length].map((text) => element('td', { textContent: text }));
    const row = element('tr', {}, element('td', {}, button), ...others);
    row.dataset.label = label;
    row.classList.toggle('pinned', label === this.pinned);
    row.addEventListener('click', () => this.pin(label));
    return row;
  }
}

const short = (value) => format_number(Number(value.toPrecision(4)));
