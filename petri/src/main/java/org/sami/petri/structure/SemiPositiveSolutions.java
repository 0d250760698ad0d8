package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * The minimal solutions {@code y ≥ 0} of a system of equations {@code Σ y(i) row(i) = 0} in whole numbers: those whose support contains no other solution's, each
 * divided by what all its elements share. Every solution is a sum of these with factors of 0 or more. One equation is solved at a time: each row whose element there
 * is positive is added to each whose element is negative, as often as makes 0. A sum is kept only if its support contains no third row's.
 *
 * <p>There can be exponentially many rows. If there are {@code mostRows} more than unknowns, those with the largest supports are given up, and the result says that not all were computed; the
 * same when a number leaves the range of {@code long} or the search is cancelled. What is returned is a solution in any case.
 *
 * <p>Source: Colom and Silva, "Convex geometry and semiflows in P/T nets", Advances in Petri Nets 1990, LNCS 483; the test of supports is that of Fukuda and Prodon,
 * "Double description method revisited", 1996, LNCS 1120.
 */
final class SemiPositiveSolutions {
    /** Each row has a bit for each unknown: of so many they take 56 MB, of 780,000 they would take 38 GB. */
    private static final int MOST_UNKNOWNS = 30_000;

    private final int mostRows;
    private final BooleanSupplier cancelled;
    private final int[] positive;
    private final int[] negative;
    private final BitSet open = new BitSet();
    private List<Row> rows = new ArrayList<>();
    private boolean complete = true;

    /** A row: what is left of the equations, and the sum of original rows that it is. Equal only to itself. */
    private static final class Row {
        private final IntegerVector rest;
        private final IntegerVector sum;
        private final BitSet support;

        private Row(IntegerVector rest, IntegerVector sum) {
            this.rest = rest;
            this.sum = sum;
            this.support = sum.support();
        }

        boolean within(BitSet other) {
            if (support.length() > other.length()) {
                return false;
            }
            for (int i = support.nextSetBit(0); i >= 0; i = support.nextSetBit(i + 1)) {
                if (!other.get(i)) {
                    return false;
                }
            }
            return true;
        }
    }

    private SemiPositiveSolutions(int equations, int mostRows, BooleanSupplier cancelled) {
        this.mostRows = mostRows;
        this.cancelled = cancelled;
        this.positive = new int[equations];
        this.negative = new int[equations];
    }

    /** Solves for one unknown a row; {@code equations} is the length of the rows. None is found of more than {@link #MOST_UNKNOWNS}. */
    static InvariantSet of(List<IntegerVector> unknowns, int equations, int mostRows, BooleanSupplier cancelled) {
        if (unknowns.size() > MOST_UNKNOWNS) {
            return new InvariantSet(List.of(), false);
        }
        SemiPositiveSolutions search = new SemiPositiveSolutions(equations, mostRows + unknowns.size(), cancelled);
        for (int i = 0; i < unknowns.size(); i++) {
            search.add(new Row(unknowns.get(i), IntegerVector.unit(i, 1)));
        }
        search.solve();
        return search.result();
    }

    private void solve() {
        while (!open.isEmpty()) {
            if (cancelled.getAsBoolean()) {
                complete = false;
                return;
            }
            eliminate(cheapest());
            if (rows.size() > mostRows) {
                giveUpLargest();
            }
        }
    }

    /** The equation that leaves the fewest rows. */
    private int cheapest() {
        int best = -1;
        long least = Long.MAX_VALUE;
        for (int equation = open.nextSetBit(0); equation >= 0; equation = open.nextSetBit(equation + 1)) {
            long growth = (long) positive[equation] * negative[equation] - positive[equation] - negative[equation];
            if (growth < least) {
                least = growth;
                best = equation;
            }
        }
        return best;
    }

    private void eliminate(int equation) {
        List<Row> above = new ArrayList<>();
        List<Row> below = new ArrayList<>();
        List<Row> others = new ArrayList<>();
        for (Row row : rows) {
            long element = row.rest.get(equation);
            (element > 0 ? above : element < 0 ? below : others).add(row);
        }
        List<Row> before = rows;
        rows = others;
        above.forEach(row -> count(row, -1));
        below.forEach(row -> count(row, -1));
        for (Row up : above) {
            for (Row down : below) {
                if (rows.size() > 4L * mostRows || cancelled.getAsBoolean()) {
                    complete = false;
                    return;
                }
                if (adjacent(up, down, before)) {
                    addSum(up, down, equation);
                }
            }
        }
    }

    private static boolean adjacent(Row up, Row down, List<Row> all) {
        BitSet both = (BitSet) up.support.clone();
        both.or(down.support);
        return all.stream().noneMatch(row -> !row.equals(up) && !row.equals(down) && row.within(both));
    }

    private void addSum(Row up, Row down, int equation) {
        try {
            long plus = up.rest.get(equation);
            long minus = Math.negateExact(down.rest.get(equation));
            long shared = IntegerVector.gcd(plus, minus);
            IntegerVector rest = up.rest.combined(minus / shared, down.rest, plus / shared);
            IntegerVector sum = up.sum.combined(minus / shared, down.sum, plus / shared);
            long divisor = IntegerVector.gcd(rest.greatestDivisor(), sum.greatestDivisor());
            add(new Row(rest.dividedBy(divisor), sum.dividedBy(divisor)));
        } catch (ArithmeticException e) {
            complete = false; // the numbers of this row are too large
        }
    }

    private void add(Row row) {
        rows.add(row);
        count(row, 1);
    }

    private void count(Row row, int by) {
        for (int i = 0; i < row.rest.size(); i++) {
            int equation = row.rest.indexAt(i);
            int[] counted = row.rest.valueAt(i) > 0 ? positive : negative;
            counted[equation] += by;
            open.set(equation, positive[equation] + negative[equation] > 0);
        }
    }

    private void giveUpLargest() {
        complete = false;
        rows.sort(Comparator.comparingInt(row -> row.support.cardinality()));
        List<Row> surplus = rows.subList(mostRows, rows.size());
        surplus.forEach(row -> count(row, -1));
        surplus.clear();
    }

    private InvariantSet result() {
        List<Row> solved = rows.stream().filter(row -> row.rest.isZero()).toList();
        List<IntegerVector> minimal = solved.stream()
                .filter(row -> complete
                        || solved.stream().noneMatch(other -> !other.equals(row) && smaller(other, row, solved)))
                .map(row -> row.sum)
                .toList();
        return new InvariantSet(minimal, complete);
    }

    /** Whether a row's support lies within another's; of two equal ones the first counts as smaller. */
    private static boolean smaller(Row row, Row than, List<Row> order) {
        return row.within(than.support) && (!than.within(row.support) || order.indexOf(row) < order.indexOf(than));
    }
}
