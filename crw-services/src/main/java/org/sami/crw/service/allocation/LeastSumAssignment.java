package org.sami.crw.service.allocation;

import java.util.Arrays;

/**
 * The assignment of rows to columns with the least sum of costs, by shortest augmenting paths with potentials (H. W. Kuhn,
 * The Hungarian method for the assignment problem, 1955; J. Munkres, 1957). O(rows² × columns); as many columns as rows or
 * more. Deterministic: the same costs give the same assignment.
 */
public final class LeastSumAssignment {
    private final double[][] costs;
    private final int rows;
    private final int columns;
    private final double[] rowPotential;
    private final double[] columnPotential;
    /** The row of each column, both counted from 1; 0 = none. Column 0 holds the row that is being placed. */
    private final int[] rowOf;

    private LeastSumAssignment(double[][] costs) {
        this.costs = costs;
        rows = costs.length;
        columns = rows == 0 ? 0 : costs[0].length;
        rowPotential = new double[rows + 1];
        columnPotential = new double[columns + 1];
        rowOf = new int[columns + 1];
    }

    /** The column of each row. */
    public static int[] of(double[][] costs) {
        LeastSumAssignment assignment = new LeastSumAssignment(costs);
        for (int row = 1; row <= assignment.rows; row++) {
            assignment.place(row);
        }
        int[] columnOf = new int[assignment.rows];
        for (int column = 1; column <= assignment.columns; column++) {
            if (assignment.rowOf[column] != 0) {
                columnOf[assignment.rowOf[column] - 1] = column - 1;
            }
        }
        return columnOf;
    }

    private void place(int row) {
        double[] slack = new double[columns + 1];
        Arrays.fill(slack, Double.POSITIVE_INFINITY);
        int[] before = new int[columns + 1];
        boolean[] reached = new boolean[columns + 1];
        rowOf[0] = row;
        int column = 0;
        while (rowOf[column] != 0) {
            reached[column] = true;
            int next = relax(column, slack, before, reached);
            shift(slack[next], slack, reached);
            column = next;
        }
        while (column != 0) {
            rowOf[column] = rowOf[before[column]];
            column = before[column];
        }
    }

    /** Updates the slack of the columns not reached from one that is; returns the one with the least. */
    private int relax(int from, double[] slack, int[] before, boolean[] reached) {
        int row = rowOf[from];
        int least = 0;
        for (int column = 1; column <= columns; column++) {
            if (!reached[column]) {
                double reduced = costs[row - 1][column - 1] - rowPotential[row] - columnPotential[column];
                if (reduced < slack[column]) {
                    slack[column] = reduced;
                    before[column] = from;
                }
                if (least == 0 || slack[column] < slack[least]) {
                    least = column;
                }
            }
        }
        return least;
    }

    private void shift(double delta, double[] slack, boolean[] reached) {
        for (int column = 0; column <= columns; column++) {
            if (reached[column]) {
                rowPotential[rowOf[column]] += delta;
                columnPotential[column] -= delta;
            } else {
                slack[column] -= delta;
            }
        }
    }
}
