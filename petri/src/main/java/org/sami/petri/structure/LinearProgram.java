package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import org.ojalgo.optimisation.Expression;
import org.ojalgo.optimisation.ExpressionsBasedModel;
import org.ojalgo.optimisation.Optimisation;
import org.ojalgo.optimisation.Variable;

/**
 * A linear program: the least {@code cost · x} with {@code x ≥ 0} and lower limits of sums of {@code x}. Solved by ojAlgo in floating point; whoever wants to rely on
 * what it says checks it in whole numbers ({@link WholeMultiple}). For one thread.
 */
final class LinearProgram {
    private static final int MOST_ROWS_AND_COLUMNS = 20_000;
    private static final long MOST_MILLIS = 10_000;

    private final ExpressionsBasedModel model = new ExpressionsBasedModel();
    private final List<Variable> variables = new ArrayList<>();
    private int rows;

    /** What came of it. That a program was not solved is a hint that it has no solution, and no proof. */
    static final class Outcome {
        private final boolean solved;
        private final double[] values;

        private Outcome(boolean solved, double[] values) {
            this.solved = solved;
            this.values = values;
        }

        boolean solved() {
            return solved;
        }

        /** The values of the variables; not a copy. */
        double[] values() {
            return values;
        }
    }

    /**
     * A program with so many variables, all without cost.
     *
     * @param mostMillis how long it may take, in ms; never more than ten seconds
     */
    LinearProgram(int count, long mostMillis) {
        for (int i = 0; i < count; i++) {
            variables.add(model.newVariable("x" + i).lower(0));
        }
        model.options.time_abort = Math.min(mostMillis, MOST_MILLIS);
        model.options.time_suffice = model.options.time_abort;
    }

    /** Whether a program would take too long to be worth a try. */
    static boolean isTooLarge(int rows, int columns) {
        return rows + columns > MOST_ROWS_AND_COLUMNS;
    }

    void cost(int variable, long cost) {
        variables.get(variable).weight(cost);
    }

    void atLeast(IntegerVector factors, long least) {
        row(factors).lower(least);
    }

    void atMost(IntegerVector factors, long most) {
        row(factors).upper(most);
    }

    Outcome solve() {
        Optimisation.Result result = model.minimise();
        Optimisation.State state = result.getState();
        double[] values = new double[variables.size()];
        if (state.isOptimal()) {
            for (int i = 0; i < values.length; i++) {
                values[i] = result.doubleValue(i);
            }
        }
        return new Outcome(state.isOptimal(), values);
    }

    private Expression row(IntegerVector factors) {
        Expression row = model.newExpression("r" + rows++);
        for (int i = 0; i < factors.size(); i++) {
            row.set(variables.get(factors.indexAt(i)), factors.valueAt(i));
        }
        return row;
    }
}
