// The messages between this page and the session's server, as docs/session-link.md has them. A member that may be absent there is optional here.

/** Latitude and longitude in degrees, WGS 84. */
export type LatLon = [number, number];

export type Severity = 'low' | 'medium' | 'high' | 'critical';

export type Right = 'stop' | 'answer' | 'press' | 'start' | 'drive' | 'setup';

export interface Shape {
  point?: LatLon;
  path?: LatLon[];
  area?: LatLon[];
  holes?: LatLon[][];
  many?: Labelled[];
}

export interface Labelled {
  label?: string;
  shape: Shape;
}

/** What rows of all tables have. */
export interface Row {
  id: string;
  /** Where rows have one they are sorted by it, 0 first. */
  rank?: number;
}

export interface BoatRow extends Row {
  lat?: number;
  alt?: number;
  lon?: number;
  /** In degrees, clockwise from true north. */
  heading?: number;
  /** In m/s, negative astern. */
  speed?: number;
  at?: number;
  heard?: number;
  /** In percent. */
  battery?: number;
  batteryLevel?: 'nominal' | 'low' | 'critical';
  link: 'unreached' | 'connecting' | 'linked' | 'lost';
  mode?: string;
  commander: string;
  driver?: string;
  why: string;
  moving: boolean;
  stopped: boolean;
  alarm?: Severity;
  flies: boolean;
  stop?: 'here' | 'elsewhere' | 'overridden';
  stoppedBy?: string;
}

/** A boat that has said where it is. */
export type PlacedBoat = BoatRow & {lat: number, lon: number};

export interface PathRow extends Row {
  points: LatLon[];
}

export interface MissionRow extends Row {
  parent?: string;
  name: string;
  plan: string;
  state: string;
  places: string[];
  stuck?: string;
  since: number;
  ended?: number;
}

export type ActionState = 'ahead' | 'active' | 'done';

export type PhaseState = ActionState | 'begun';

export interface Action {
  actor: string;
  label: string;
  state: ActionState;
  times?: number;
}

export interface Phase {
  name: string;
  state: PhaseState;
  actions: Action[];
}

export interface PhasesRow extends Row {
  phases: Phase[];
}

export interface Reading {
  sensor: string;
  channel: string;
  unit?: string;
  value: number;
  at: number;
}

export interface ReadingsRow extends Row {
  readings: Reading[];
}

export interface PictureOfPanorama {
  name: string;
  state: 'here' | 'coming' | 'missed';
  why?: string;
}

export interface PicturesRow extends Row {
  boat: string;
  panorama: string;
  mission?: string;
  at: number;
  lat: number;
  lon: number;
  pictures: PictureOfPanorama[];
}

export interface StandingRow extends Row {
  status: 'warning' | 'severe';
}

export interface MessageRow extends Row {
  at: number;
  priority: Severity;
  text: string;
  boats: string[];
  mission?: string;
  acknowledged: boolean;
  count: number;
  source: string;
  keyword?: string;
  /** Ids of boats whose last pictures it is about. */
  pictures?: string[];
}

export interface AlarmRow extends Row {
  kind: string;
  severity: Severity;
  text: string;
  advice: string;
  boat?: string;
  other?: string;
  since: number;
  active: boolean;
  acknowledged: boolean;
  sounds: boolean;
}

export interface FaultRow extends Row {
  severity: Severity;
  text: string;
  advice: string;
  since: number;
  kind: string;
  subject: string;
  details: string;
  /** Empty where it is about none. */
  boat: string;
  /** '0' for none. */
  mission: string;
}

export interface ButtonRow extends Row {
  mission: string;
  plan: string;
  name: string;
  description: string;
  priority: Severity;
  /** A press may name boats. */
  boats: boolean;
  whyNot?: string;
  final?: string;
}

export interface AreaRow extends Row {
  kind: 'area' | 'no-go' | 'fence' | 'relevant' | 'place';
  name: string;
  mission?: string;
  shape: Shape;
}

export interface BaseRow extends Row {
  certificate?: string;
}

export interface FleetRow extends Row {
  stopped: boolean;
  every: boolean;
  words: string;
  advice: string;
  boats: number;
  standStill: boolean;
}

export interface PointValue {
  lat: number;
  lon: number;
}

export interface AreaValue {
  outline: PointValue[];
  holes: PointValue[][];
}

/** A value as files have it. */
export type Value = boolean | number | string | PointValue | AreaValue | Value[] | {[key: string]: Value};

export interface FieldOfDecision {
  key: string;
  type: string;
  unit: string;
  help: string;
  editable: boolean;
  value?: Value;
  choices?: string[];
  shape?: Shape;
  optional: boolean;
}

export interface Option {
  index: number;
  value: string;
  label: string;
  detail: string;
  selected: boolean;
  shape?: Shape;
}

export type Visualization = 'heatmap' | 'contour' | 'threshold';

/** Readings that are to be drawn. */
export interface Information {
  sensor: string;
  visualization: Visualization;
}

export interface Attention {
  type: 'highlight' | 'blink';
  target: 'component' | 'all-proxies' | 'relevant-proxies';
}

export interface ShownBoats {
  boats: string[];
  paths: boolean;
  state: boolean;
  data: boolean;
  pictures: boolean;
}

interface AnyDecision extends Row {
  priority: Severity;
  title: string;
  mission?: string;
  plan?: string;
  place?: string;
  type: string;
  description: string[];
  boats: string[];
  opened: number;
  deadline?: number;
  autonomy?: string;
  reject?: boolean;
  format: 'stacked' | 'sequential' | 'tabs';
  attention?: Attention;
  show?: ShownBoats;
  shapes?: Labelled[];
  view?: {boats: string[], change?: 'expand' | 'reduce'};
  information?: Information;
  yours: boolean;
  whyNot?: string;
}

export interface YesNoDecision extends AnyDecision {
  form: 'yesNo';
}

export interface BoatsDecision extends AnyDecision {
  form: 'boats';
  options: Option[];
  min: number;
  max: number;
}

export interface OptionDecision extends AnyDecision {
  form: 'option';
  options: Option[];
}

export interface FieldsDecision extends AnyDecision {
  form: 'fields';
  fields: FieldOfDecision[];
}

export type DecisionRow = YesNoDecision | BoatsDecision | OptionDecision | FieldsDecision;

/** A decision that draws attention. */
export type CallingDecision = DecisionRow & {attention: Attention};

/** The tables that this page looks at, by name. */
export interface Tables {
  boats: BoatRow;
  paths: PathRow;
  missions: MissionRow;
  phases: PhasesRow;
  readings: ReadingsRow;
  pictures: PicturesRow;
  decisions: DecisionRow;
  standings: StandingRow;
  messages: MessageRow;
  alarms: AlarmRow;
  faults: FaultRow;
  buttons: ButtonRow;
  areas: AreaRow;
  bases: BaseRow;
  fleet: FleetRow;
}

export interface Welcome {
  t: 'welcome';
  v: number;
  name: string;
  role: string;
  rights: Right[];
  now: number;
  robots: string;
  plans: {id: string, title: string}[];
  ticket: string;
  /** Of the base's lease of the session. */
  epoch?: number;
  /** `beat` comes so often, in ms. */
  beat?: number;
}

export interface Rows {
  t: 'rows';
  n: number;
  full: boolean;
  now: number;
  set?: {[Name in keyof Tables]?: Tables[Name][]};
  gone?: {[Name in keyof Tables]?: string[]};
}

export interface Standby {
  t: 'standby';
  text: string;
  bases?: BaseRow[];
}

export interface Done {
  t: 'done';
  id: number;
  text: string;
  warnings?: string[];
  mission?: string;
  layer?: Layer;
}

export interface Refused {
  t: 'refused';
  id: number;
  text: string;
  bad?: boolean;
}

export type Reply = Done | Refused;

export interface Rights {
  t: 'rights';
  role: string;
  rights: Right[];
}

export interface Bye {
  t: 'bye';
  text: string;
}

export interface News {
  t: 'news';
  at: number;
  by: string;
  text: string;
}

export interface Beat {
  t: 'beat';
  now: number;
}

/** What the server sends; it may send others that a later version has. */
export type ServerMessage = Welcome | Rows | Standby | Reply | Rights | Bye | News | Beat;

/** What all boats have measured, for a map. */
export interface Layer {
  sensor: string;
  channel: string;
  unit?: string;
  visualization: Visualization;
  least: number;
  greatest: number;
  south: number;
  west: number;
  north: number;
  east: number;
  columns: number;
  /** In Base64 a byte a cell, row by row from the north-west; 0 is clear. */
  cells: string;
  marks: number[];
  contours?: Contour[];
}

export interface Contour {
  value: number;
  segments: [LatLon, LatLon][];
}

export interface Hello {
  t: 'hello';
  v: 1;
  name: string;
  key?: string;
}

export type Answer = {yes: boolean} | {boats: string[]} | {option: number} | {none: true} | {fields: {[key: string]: Value}};

/** What this page asks the server for; the link adds `id`. */
export type Command =
  | {t: 'answer', decision: string, answer: Answer}
  | {t: 'judge', decision: string, answer: Answer}
  | {t: 'hold', decision: string}
  | {t: 'press', mission: string, name: string, boats?: string[]}
  | {t: 'start', plan: string}
  | {t: 'abort', mission: string}
  | {t: 'stopFleet'}
  | {t: 'releaseFleet'}
  | {t: 'claim' | 'holdBoat' | 'giveBack', boat: string}
  | {t: 'drive', boat: string, thrust: number, rudder: number}
  | {t: 'goTo', boat: string, lat: number, lon: number}
  | {t: 'acknowledge', message: number}
  | {t: 'acknowledge', alarm: number}
  | {t: 'layer', sensor: string, visualization?: Visualization}
  | {t: 'note', text: string, lat?: number, lon?: number};
