// @ts-check
// Points of what is drawn, each as large as a finger: dragged to move, touched to choose; between two that are far apart one that adds a point.
import * as L from './leaflet/leaflet-src.esm.js';

const SIZE = 48;
const ROOM = 110; // pixels between two points, for one between them
export const MOST = 200;

/** @typedef {{begun: () => void, moved: () => void, over: () => void, chosen: (at: number) => void}} Heard */

export class Handles {
  /** @param {any} map of Leaflet */
  constructor(map) {
    this.map = map;
    this.layer = L.layerGroup().addTo(map);
    /** @type {any[]} */
    this.points = [];
    this.type = '';
    /** @type {Heard | null} */
    this.heard = null;
    /** @type {number | null} */
    this.selected = null;
    map.on('zoomend', () => this.draw());
  }

  /** Shows points, which are changed in place. @param {string} type @param {any[]} points @param {number | null} selected @param {Heard} heard */
  show(type, points, selected, heard) {
    this.type = type;
    this.points = points;
    this.selected = selected;
    this.heard = heard;
    this.draw();
  }

  clear() {
    this.heard = null;
    this.layer.clearLayers();
  }

  draw() {
    this.layer.clearLayers();
    if (!this.heard || this.points.length > MOST) {
      return;
    }
    this.between().forEach((at) => this.add(Handles.middle(this.points[at], this.points[(at + 1) % this.points.length]), 'between', at + 1, true));
    this.points.forEach((point, at) => this.add(point, at === this.selected ? 'selected' : '', at, false));
  }

  /** Indexes of points behind which there is room for one more. */
  between() {
    const lines = this.type === 'path' ? this.points.length - 1 : this.type === 'area' && this.points.length > 2 ? this.points.length : 0;
    return [...Array(Math.max(0, lines)).keys()].filter((at) => {
      const one = this.map.latLngToContainerPoint(this.points[at]);
      return one.distanceTo(this.map.latLngToContainerPoint(this.points[(at + 1) % this.points.length])) > ROOM;
    });
  }

  /** @param {any} one @param {any} other */
  static middle(one, other) {
    return [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2];
  }

  /** @param {any} point @param {string} mark @param {number} at @param {boolean} isNew */
  add(point, mark, at, isNew) {
    const marker = L.marker(point, {draggable: true, autoPan: true, keyboard: false, icon: L.divIcon({className: 'handle ' + mark, iconSize: [SIZE, SIZE]}), zIndexOffset: isNew ? 900 : 1000});
    marker.on('dragstart', () => {
      this.heard?.begun();
      if (isNew) {
        this.points.splice(at, 0, point);
      }
    });
    marker.on('drag', () => {
      const {lat, lng} = marker.getLatLng();
      this.points[at] = [lat, lng];
      this.heard?.moved();
    });
    marker.on('dragend', () => this.heard?.over());
    marker.on('click', () => {
      if (!isNew) {
        this.heard?.chosen(at);
      }
    });
    marker.addTo(this.layer);
  }
}
