package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** Finds what may lie in a box without looking at all there is: things by the square cells that they touch. For one thread. */
final class CellGrid<T> {
    private static final double CELL = 120;

    private final Map<Long, List<Entry<T>>> cells = new HashMap<>();
    private final Map<T, Entry<T>> entries = new HashMap<>(); // equal things are one
    private long searches;

    /** A thing, and the last search that came upon it. */
    private static final class Entry<T> {
        private final T thing;
        private long foundBy;

        Entry(T thing) {
            this.thing = thing;
        }
    }

    /** Adds a thing that lies in a box. */
    void add(DrawingBox box, T thing) {
        add(box, thing, cell -> true);
    }

    /** Adds a thing that lies in a box and touches only some of its cells. */
    void add(DrawingBox box, T thing, Predicate<DrawingBox> touches) {
        Entry<T> entry = entries.computeIfAbsent(thing, Entry::new);
        for (int column = index(box.x()); column <= index(box.maxX()); column++) {
            for (int row = index(box.y()); row <= index(box.maxY()); row++) {
                if (touches.test(new DrawingBox(column * CELL, row * CELL, CELL, CELL))) {
                    cells.computeIfAbsent(key(column, row), unused -> new ArrayList<>())
                            .add(entry);
                }
            }
        }
    }

    /** All that touches a cell which the box touches, each once. */
    List<T> near(DrawingBox box) {
        List<T> near = new ArrayList<>();
        long search = ++searches;
        int lastColumn = index(box.maxX());
        int lastRow = index(box.maxY());
        for (int column = index(box.x()); column <= lastColumn; column++) {
            for (int row = index(box.y()); row <= lastRow; row++) {
                for (Entry<T> entry : cells.getOrDefault(key(column, row), List.of())) {
                    if (entry.foundBy != search) {
                        entry.foundBy = search;
                        near.add(entry.thing);
                    }
                }
            }
        }
        return near;
    }

    private static long key(int column, int row) {
        return ((long) column << Integer.SIZE) | (row & 0xffffffffL);
    }

    private static int index(double coordinate) {
        return (int) Math.floor(coordinate / CELL);
    }
}
