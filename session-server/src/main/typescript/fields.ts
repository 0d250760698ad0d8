// The fields of a question: each is typed, chosen or drawn on the map.
import {shapeOf} from './drawing.js';
import {element} from './dom.js';
import type {Chart} from './chart.js';
import type {Drawing} from './drawing.js';
import type {Link} from './link.js';
import type {AreaValue, FieldOfDecision, LatLon, PointValue, Value} from './protocol.js';

const DRAWN = ['point', 'path', 'area', 'list<point>'];

export class Fields {
  fields: FieldOfDecision[];
  link: Link;
  chart: Chart;
  drawing: Drawing;
  changed: () => void;
  points: Map<string, LatLon[]>;
  node: HTMLElement;

  constructor(fields: FieldOfDecision[], link: Link, chart: Chart, drawing: Drawing, changed: () => void) {
    this.fields = fields;
    this.link = link;
    this.chart = chart;
    this.drawing = drawing;
    this.changed = changed;
    this.points = new Map();
    this.node = element('div', {class: 'fields', oninput: changed}, ...fields.map((field) => this.field(field)));
  }

  field(field: FieldOfDecision) {
    const title = field.key + (field.unit ? ' (' + field.unit + ')' : '');
    const parts = [element('span', {class: 'key'}, title), element('small', {}, field.help ?? '')];
    if (!field.editable) {
      parts.push(element('output', {}, field.shape ? 'on the map' : Fields.text(field.value)));
      return element('div', {class: 'field'}, ...parts);
    }
    return element('label', {class: 'field'}, ...parts, this.input(field));
  }

  static text(value: Value | undefined) {
    return value === undefined ? '' : typeof value === 'object' ? JSON.stringify(value) : String(value);
  }

  input(field: FieldOfDecision) {
    const now = field.value;
    const key = {'data-key': field.key};
    if (field.choices) {
      return element('select', key, ...field.choices.map((one) => element('option', {value: one, selected: one === now}, one)));
    }
    if (DRAWN.includes(field.type)) {
      return this.draw(field);
    }
    switch (field.type) {
      case 'boolean':
        return element('input', {...key, type: 'checkbox', checked: now === true});
      case 'integer':
      case 'real':
        return element('input', {...key, type: 'number', step: field.type === 'integer' ? 1 : 'any', value: Fields.text(now), inputmode: 'decimal'});
      case 'proxy':
        return element('select', key, ...this.link.all('boats').map((boat) => element('option', {value: boat.id, selected: boat.id === now}, boat.id)));
      default:
        return element('input', {...key, type: 'text', value: Fields.text(now)});
    }
  }

  /** What is there already is changed point by point; nothing of it is lost until the answer is given. */
  draw(field: FieldOfDecision) {
    const count = element('output', {}, field.value === undefined ? 'nothing yet' : 'as shown');
    const begin = (points: LatLon[]) => {
      this.points.set(field.key, points);
      this.drawing.begin({type: field.type, points, changed: () => {
        count.textContent = points.length === 1 ? '1 point' : points.length + ' points';
        edit.textContent = Fields.drawing(points);
      }, done: this.changed});
    };
    const present = () => this.points.get(field.key) ?? Fields.pointsOf(field);
    const edit = element('button', {type: 'button', onclick: () => begin(present())}, Fields.drawing(present()));
    const anew = field.value === undefined ? null : element('button', {type: 'button', onclick: () => begin([])}, 'Draw anew');
    return element('span', {class: 'draw'}, edit, anew, count);
  }

  static drawing(points: LatLon[]) {
    return points.length === 0 ? 'Draw on the map' : 'Move points';
  }

  /** The points of what a question proposes. */
  static pointsOf(field: FieldOfDecision): LatLon[] {
    const value = field.value;
    const points = value === undefined ? [] : field.type === 'point' ? [value] : field.type === 'area' ? (value as AreaValue).outline : value;
    return (points as PointValue[]).map((one) => [one.lat, one.lon]);
  }

  /** Shows again what was drawn. */
  show() {
    const shapes = this.fields.filter((field) => (this.points.get(field.key)?.length ?? 0) > 0)
        .map((field) => ({shape: shapeOf(field.type, this.points.get(field.key) ?? [])}));
    this.chart.draft(shapes.length === 0 ? null : {many: shapes});
  }

  /** The values by key. @throws {Error} with a sentence, where one is missing or cannot be read */
  values() {
    const values: Record<string, Value> = {};
    for (const field of this.fields.filter((one) => one.editable)) {
      const value = this.value(field);
      if (value !== undefined) {
        values[field.key] = value;
      } else if (!field.optional) {
        throw new Error(field.key + ' is missing.');
      }
    }
    return values;
  }

  value(field: FieldOfDecision): Value | undefined {
    if (DRAWN.includes(field.type)) {
      const points = this.points.get(field.key) ?? [];
      return points.length === 0 ? field.value : Fields.drawnValue(field, points.map(([lat, lon]) => ({lat, lon})));
    }
    const input = this.node.querySelector('[data-key="' + CSS.escape(field.key) + '"]') as HTMLInputElement | HTMLSelectElement;
    if (input instanceof HTMLInputElement && input.type === 'checkbox') {
      return input.checked;
    }
    if (input.value === '') {
      return undefined;
    }
    if (input.type === 'number') {
      return Number(input.value);
    }
    return typeof field.value === 'object' || field.type.startsWith('list<') ? Fields.parsed(field, input.value) : input.value;
  }

  static parsed(field: FieldOfDecision, text: string): Value {
    try {
      return JSON.parse(text);
    } catch {
      throw new Error(field.key + ' is not JSON' + (field.value === undefined ? '' : ' such as ' + JSON.stringify(field.value)) + '.');
    }
  }

  static drawnValue(field: FieldOfDecision, points: PointValue[]): Value {
    const least = field.type === 'area' ? 3 : field.type === 'path' ? 2 : 1;
    if (points.length < least) {
      throw new Error(field.key + ' needs ' + least + (least === 1 ? ' point' : ' points') + ' on the map.');
    }
    return field.type === 'point' ? points[0] : field.type === 'area' ? {outline: points, holes: (field.value as AreaValue | undefined)?.holes ?? []} : points;
  }
}
