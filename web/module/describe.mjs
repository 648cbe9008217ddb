// Writes the options of each call into the package's types, from what the library says of itself: node describe.mjs PACKAGE
//
// In index.d.ts, a line "//= NAME" stands for the interface of the options that calls.mjs has under this name.
import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

/** The values that an option takes. */
function typeOf({ kind, choices, name }) {
  const words = (choices ?? []).map((word) => `'${word}'`);
  const kinds = {
    'choice': words,
    'flag': ['boolean'],
    'switch': ['boolean'],
    'number': [...words, 'number'],
    'whole number': [...words, ...(name === 'seed' ? ['number', 'bigint'] : ['number'])],
    'bound': ['number', '`${number}%`'],
    'crease angle': ['number', "'auto'", "'none'"],
    'counts': ['Numbers'],
    'values': [...words, 'Numbers', ...(name === 'mask' ? ['boolean[]'] : [])],
    'points': ['PointsLike'],
    'vertices': ['PointsLike'],
    'curves': ['Curves', "'boundary'", "'creases'", '`creases:${number}`'],
    'input file': ['string'],
  };
  if (!kinds[kind]) throw new Error(`${name}: no type for the kind ${kind}`);
  return kinds[kind].join(' | ');
}

function describeOption(option) {
  const unit = option.unit ? ` (${option.unit})` : '', told = option.usual ?? option.default;
  const usual = told === null || told === false ? '' : `. Default: ${told}`;
  const text = `${option.summary}${unit}${usual}`.replaceAll('*/', '* /');
  return `  /** ${text} */\n  ${option.name}?: ${typeOf(option)} | null;\n`;
}

/** The types, with an interface in place of each line that stands for one. */
function fill(types, { operations, file_options }, calls) {
  const all = new Map([...operations.map(({ name, options }) => [name, options]), ['file', file_options]]);
  return types.replace(/^\/\/= (\w+)(?: extends (\w+))?$/gm, (_, name, base = 'Run') => {
    const { operation, without } = calls[name], options = all.get(operation);
    for (const one of without) if (!options.some((option) => option.name === one)) throw new Error(`${operation} has no option ${one}`);
    const shown = options.filter((option) => !without.includes(option.name)).map(describeOption).join('');
    return `export interface ${name} extends ${base} {\n${shown}}`;
  });
}

const [, , folder] = process.argv, file = join(folder, 'index.d.ts');
const load = (module) => import(pathToFileURL(resolve(folder, module)).href);
const [{ describe }, { kCalls }] = await Promise.all([load('library.mjs'), load('calls.mjs')]);
writeFileSync(file, fill(readFileSync(file, 'utf8'), describe(), kCalls));
