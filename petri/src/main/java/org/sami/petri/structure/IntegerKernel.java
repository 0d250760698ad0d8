package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * A basis over the whole numbers of all solutions {@code y} of {@code Σ y(i) row(i) = 0}, negative ones included. Rows are added to and subtracted from one another, as
 * in Euclid's algorithm, until each equation stands in one row only. These steps can be undone in whole numbers, so the rows without equations are a basis of all
 * solutions, not only of multiples of them.
 *
 * <p>Source: Schrijver, "Theory of Linear and Integer Programming", 1986, section 4.1 (Hermite normal form) and corollary 4.1c.
 */
final class IntegerKernel {
    private IntegerKernel() {}

    private record Row(IntegerVector rest, IntegerVector sum) {
        Row minus(Row other, long times) {
            long factor = Math.negateExact(times);
            return new Row(rest.combined(1, other.rest, factor), sum.combined(1, other.sum, factor));
        }
    }

    static Optional<List<IntegerVector>> of(List<IntegerVector> unknowns, int equations, BooleanSupplier cancelled) {
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < unknowns.size(); i++) {
            rows.add(new Row(unknowns.get(i), IntegerVector.unit(i, 1)));
        }
        try {
            for (int equation = 0; equation < equations; equation++) {
                if (cancelled.getAsBoolean()) {
                    return Optional.empty();
                }
                removePivot(rows, equation);
            }
        } catch (ArithmeticException e) {
            return Optional.empty(); // the numbers are too large
        }
        return Optional.of(rows.stream().map(Row::sum).toList());
    }

    /** Reduces the rows until one has a number in the equation, and removes that row. */
    private static void removePivot(List<Row> rows, int equation) {
        while (true) {
            int pivot = smallest(rows, equation);
            if (pivot < 0) {
                return;
            }
            long least = rows.get(pivot).rest().get(equation);
            boolean alone = true;
            for (int i = 0; i < rows.size(); i++) {
                long element = rows.get(i).rest().get(equation);
                if (i != pivot && element != 0) {
                    rows.set(i, rows.get(i).minus(rows.get(pivot), element / least));
                    alone &= element % least == 0;
                }
            }
            if (alone) {
                rows.remove(pivot);
                return;
            }
        }
    }

    private static int smallest(List<Row> rows, int equation) {
        int best = -1;
        long least = Long.MAX_VALUE;
        for (int i = 0; i < rows.size(); i++) {
            long size = Math.absExact(rows.get(i).rest().get(equation));
            if (size != 0 && size < least) {
                least = size;
                best = i;
            }
        }
        return best;
    }
}
