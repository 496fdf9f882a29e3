// Every figure that decides the verdict, beside its limits.
import { section, table } from './dom.js';
import { badge } from './header.js';

export function judged({ data }) {
  if (!data.judged.length) return null;
  const rows = data.judged.map((figure) => {
    const side = figure.at_least ? '<' : '>';
    return [
      figure.what,
      figure.value,
      `${side} ${figure.warn}`,
      `${side} ${figure.fail}`,
      badge(figure.grade),
    ];
  });
  const columns = [
    { label: 'Figure' },
    { label: 'Measured', number: true },
    { label: 'Warns', number: true },
    { label: 'Fails', number: true },
    { label: 'Grade' },
  ];
  return section(
    'judged',
    'What the verdict rests on',
    table('Judged figures and their limits', columns, rows),
  );
}
