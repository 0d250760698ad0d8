// Points that are touched on the map, and dragged: a place, a path, an area, a list of places. One drawing at a time.
import {element} from './dom.js';
import {Handles, MOST} from './handles.js';
import type {Chart} from './chart.js';
import type {LatLon, Shape} from './protocol.js';

/** A shape as the map draws it. */
export function shapeOf(type: string, points: LatLon[]): Shape {
  if (type === 'area' && points.length > 2) {
    return {area: points};
  }
  return type === 'point' ? {point: points[0]} : type === 'list<point>' ? {many: points.map((point) => ({shape: {point}}))} : {path: points};
}

export class Drawing {
  chart: Chart;
  resized: () => void;
  handles: Handles;
  bar: HTMLElement | null;
  /** Points as they were before each change. */
  before: LatLon[][];
  selected: number | null;

  /** @param resized called when the map has another size */
  constructor(chart: Chart, resized: () => void) {
    this.chart = chart;
    this.resized = resized;
    this.handles = new Handles(chart.map);
    this.bar = null;
    this.before = [];
    this.selected = null;
  }

  /**
   * Begins; what was being drawn ends.
   * @param asked points change in place
   */
  begin(asked: {type: string, points: LatLon[], changed: () => void, done: () => void}) {
    this.end();
    this.before = [];
    this.selected = null;
    const many = asked.type !== 'point';
    const words = element('output');
    const remove = element('button', {type: 'button', onclick: () => change(() => asked.points.splice(this.selected ?? 0, 1))}, 'Remove point');
    const undo = element('button', {type: 'button', onclick: () => {
      asked.points.splice(0, asked.points.length, ...(this.before.pop() ?? asked.points));
      this.selected = null;
      shown();
    }}, 'Undo');
    const keep = () => this.before.push([...asked.points]);
    const shape = () => this.chart.draft(asked.points.length === 0 ? null : shapeOf(asked.type, asked.points));
    const shown = () => {
      words.textContent = Drawing.words(asked.type, asked.points.length);
      remove.hidden = this.selected === null || !many;
      undo.toggleAttribute('disabled', this.before.length === 0);
      shape();
      this.handles.show(asked.type, asked.points, this.selected, {begun: keep, moved: shape, over: () => {
        this.selected = null;
        shown();
        asked.changed();
      }, chosen: (at) => {
        this.selected = this.selected === at ? null : at;
        shown();
      }});
    };
    const change = (doing: () => void) => {
      keep();
      doing();
      this.selected = null;
      shown();
      asked.changed();
    };
    this.chart.taking = (point) => change(() => {
      if (!many) {
        asked.points.length = 0;
      }
      asked.points.push(point);
    });
    const done = () => {
      this.end();
      document.body.classList.add('open');
      this.resized();
      asked.done();
    };
    this.bar = element('div', {class: 'bar'}, words, remove, undo, element('button', {type: 'button', class: 'main', onclick: done}, 'Done'));
    document.body.append(this.bar);
    document.body.classList.add('drawing');
    document.body.classList.remove('open');
    this.resized();
    if (asked.points.length > 0) {
      this.chart.bring(asked.points, false);
    }
    shown();
  }

  static words(type: string, count: number) {
    if (count === 0) {
      return type === 'point' ? 'Touch the place' : 'Touch the points, one after another';
    }
    const drag = count > MOST ? 'too many to drag' : 'drag to move';
    return type === 'point' ? '1 point · ' + drag : count + (count === 1 ? ' point · ' : ' points · ') + drag;
  }

  /** What was drawn stays on the map until {@link Chart#draft} is given something else. */
  end() {
    this.chart.taking = null;
    this.handles.clear();
    this.bar?.remove();
    this.bar = null;
    document.body.classList.remove('drawing');
  }
}
