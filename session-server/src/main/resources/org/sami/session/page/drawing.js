// @ts-check
// Points that are touched on the map: a place, a path, an area, a list of places. One drawing at a time.
import {element} from './dom.js';

/** @typedef {import('./chart.js').Chart} Chart */

/** A shape as the map draws it. @param {string} type @param {any[]} points */
export function shapeOf(type, points) {
  if (type === 'area' && points.length > 2) {
    return {area: points};
  }
  return type === 'point' ? {point: points[0]} : type === 'list<point>' ? {many: points.map((point) => ({shape: {point}}))} : {path: points};
}

export class Drawing {
  /** @param {Chart} chart @param {() => void} resized called when the map has another size */
  constructor(chart, resized) {
    this.chart = chart;
    this.resized = resized;
    /** @type {HTMLElement | null} */
    this.bar = null;
  }

  /**
   * Begins; what was being drawn ends.
   *
   * @param {{type: string, points: any[], changed: () => void, done: () => void}} asked points grows in place
   */
  begin(asked) {
    this.end();
    const many = asked.type !== 'point';
    const count = element('output', {}, many ? 'Touch the points, one after another' : 'Touch the place');
    const shown = () => {
      count.textContent = asked.points.length === 1 ? '1 point' : asked.points.length + ' points';
      this.chart.draft(asked.points.length === 0 ? null : shapeOf(asked.type, asked.points));
      asked.changed();
    };
    this.chart.taking = (point) => {
      if (!many) {
        asked.points.length = 0;
      }
      asked.points.push(point);
      shown();
    };
    const undo = () => {
      asked.points.pop();
      shown();
    };
    const done = () => {
      this.end();
      document.body.classList.add('open');
      this.resized();
      asked.done();
    };
    this.bar = element('div', {class: 'bar'}, count, element('button', {type: 'button', onclick: undo}, 'Undo'), element('button', {type: 'button', class: 'main', onclick: done}, 'Done'));
    document.body.append(this.bar);
    document.body.classList.add('drawing');
    document.body.classList.remove('open');
    this.resized();
  }

  /** What was drawn stays on the map until {@link Chart#draft} is given something else. */
  end() {
    this.chart.taking = null;
    this.bar?.remove();
    this.bar = null;
    document.body.classList.remove('drawing');
  }
}
