package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/** Finds what may lie in a box without looking at all there is: things by the square cells that they touch. */
final class CellGrid<T> {
    private static final double CELL = 120;

    private record Cell(int column, int row) {
        DrawingBox box() {
            return new DrawingBox(column * CELL, row * CELL, CELL, CELL);
        }
    }

    private final Map<Cell, List<T>> cells = new HashMap<>();

    /** Adds a thing that lies in a box. */
    void add(DrawingBox box, T thing) {
        add(box, thing, cell -> true);
    }

    /** Adds a thing that lies in a box and touches only some of its cells. */
    void add(DrawingBox box, T thing, Predicate<DrawingBox> touches) {
        for (Cell cell : cellsOf(box)) {
            if (touches.test(cell.box())) {
                cells.computeIfAbsent(cell, unused -> new ArrayList<>()).add(thing);
            }
        }
    }

    /** All that touches a cell which the box touches, each once. */
    Set<T> near(DrawingBox box) {
        Set<T> near = new LinkedHashSet<>();
        for (Cell cell : cellsOf(box)) {
            near.addAll(cells.getOrDefault(cell, List.of()));
        }
        return near;
    }

    private static List<Cell> cellsOf(DrawingBox box) {
        List<Cell> cells = new ArrayList<>();
        for (int column = index(box.x()); column <= index(box.maxX()); column++) {
            for (int row = index(box.y()); row <= index(box.maxY()); row++) {
                cells.add(new Cell(column, row));
            }
        }
        return cells;
    }

    private static int index(double coordinate) {
        return (int) Math.floor(coordinate / CELL);
    }
}
