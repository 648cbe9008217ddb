// Which change of one generator leads from a list of generators to another: what an editor of diagrams can follow.

const same = (a, b) => a.face === b.face && a.bary.every((x, k) => x === b.bary[k]);

// The call of the editor, [name, ...arguments]: empty where both lists are the same, null where more than one generator
// differs. A generator that is removed leaves its number to the last one.
export function find_change(before, after) {
  const grown = after.length - before.length, common = Math.min(before.length, after.length);
  const differing = [];
  for (let i = 0; i < common && differing.length < 2; ++i) if (!same(before[i], after[i])) differing.push(i);
  if (differing.length > 1 || Math.abs(grown) > 1) return null;
  const [at] = differing;
  if (grown === 1) return at === undefined ? ['add', after.at(-1)] : null;
  if (grown === 0) return at === undefined ? [] : ['move', at, after[at]];
  if (at === undefined) return ['remove', before.length - 1];
  return same(after[at], before.at(-1)) ? ['remove', at] : null;
}

// The list without generator i.
export function without(points, i) {
  const others = points.slice(0, -1);
  if (i < others.length) others[i] = points.at(-1);
  return others;
}
