/**
 * The options of each call, by the names of their types in index.d.ts: the operation, and those of its options that the call
 * sets itself, or has not.
 */
export const kCalls = Object.fromEntries(Object.entries({
  SampleOptions: ['sample', 'points generators vertices max_snap merge_coincident'],
  PointOptions: ['sample', 'count sampling seed radius generators vertices merge_coincident points'],
  DistanceOptions: ['distances', 'from curves each merge_coincident keep_coincident mesh_vertices paths isolines levels logarithm'],
  PathOptions: ['distances', 'from to curves each merge_coincident keep_coincident mesh_vertices paths isolines levels logarithm'],
  MeasureOptions: ['distances', 'from curves merge_coincident keep_coincident mesh_vertices'],
  CurveOptions: ['curves', 'curves'],
  DiagramOptions: ['diagram', 'count sampling seed radius generators vertices curves balance shares'],
  BalanceOptions: ['diagram', 'count sampling seed radius generators vertices curves method front balance editable'],
  EditorOptions: ['diagram', 'count sampling seed radius generators vertices curves method front balance shares weights within mask editable'],
  EditOptions: ['edit', 'move to add remove'],
  LabelOptions: ['label', 'cut uv'],
  CutOptions: ['label', 'cut labels'],
  SegmentOptions: ['segment', 'cut uv'],
  LloydOptions: ['lloyd', ''],
  RemeshOptions: ['remesh', 'map'],
  MapOptions: ['map', ''],
  CheckOptions: ['check', ''],
  SceneOptions: ['scene', ''],
  ReadOptions: ['mesh', 'file content weld'],
  FileOptions: ['file', 'part'],
}).map(([type, [operation, without]]) => [type, { operation, without: without.split(' ').filter(Boolean) }]));
