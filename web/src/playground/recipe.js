// The shell command and the lines of Python that give the same result as the page.

// A file's name for the shell; one that begins like an option gets a folder.
function quoted(name) {
  const path = name.startsWith('-') ? `./${name}` : name;
  return /^[\w./-]+$/.test(path) ? path : `'${path.replaceAll("'", "'\\''")}'`;
}

// What each picture is called in both, and the file that it writes.
const kRecipes = {
  diagram: { command: 'gvd-segment', call: 'segment', output: 'regions.ply' },
  remesh: { command: 'gvd-remesh', call: 'remesh', output: 'coarse.obj' },
  equal: { command: 'gvd-segment', output: 'equal.ply', options: ' --balance area --cut' },
  distances: { command: 'gvd-distance', output: 'distances.ply' },
};

// `generators` is null where they are the farthest `count` ones; others come from the list that the page saves.
export function shell_command({ file, count, generators, show }) {
  const { command, output, options = '' } = kRecipes[show];
  const list = show === 'distances' ? '--from' : '--generators';
  const given = generators || show === 'distances' ? `${list} generators.csv` : `-n ${count}`;
  return `${command} ${quoted(file)} ${given}${options} -o ${output}`;
}

export function python_lines({ file, count, generators, show }) {
  const { call, output } = kRecipes[show];
  const lines = ['import gvd', `mesh = gvd.read(${JSON.stringify(file)})`];
  if (generators) {
    const faces = generators.map(({ face }) => face).join(', ');
    const bary = generators.map(({ bary: b }) => `(${b.join(', ')})`).join(', ');
    lines.push(`points = gvd.Points(numpy.array([${faces}]), numpy.array([${bary}]))`);
    lines.unshift('import numpy');
  } else if (!call) {
    lines.push(`points = mesh.farthest(${count})`);
  }
  if (show === 'equal') lines.push('result = mesh.balance(points).diagram.cut()');
  if (show === 'distances') return [...lines, 'distances = mesh.distances(points)'].join('\n');
  if (call) lines.push(`result = mesh.${call}(${generators ? 'generators=points' : count})`);
  return [...lines, `result.to_file("${output}")`].join('\n');
}
