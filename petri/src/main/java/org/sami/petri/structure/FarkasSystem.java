package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearCondition.AtLeast;
import org.sami.petri.structure.LinearProgram.Outcome;

/**
 * The state equation with conditions on the marking: counts {@code x ≥ 0} of columns of the incidence matrix after which each place has 0 tokens or more, each condition
 * holds and each limit is kept. Every reachable marking that fulfils the conditions gives a solution; where there is none, the conditions hold in no reachable marking,
 * and by Farkas' lemma factors of the rows show that.
 *
 * <p>Source: Murata 1989, section IV.B; Schrijver, "Theory of Linear and Integer Programming", 1986, corollary 7.1d.
 */
final class FarkasSystem {
    private final PetriNet net;
    private final Incidence incidence;
    private final List<AtLeast> conditions;
    private final List<AtLeast> traps;
    private final List<FiringLimit> limits;
    private final LongSupplier millisLeft;
    private final List<IntegerVector> rows = new ArrayList<>();
    private final List<Long> least = new ArrayList<>();

    FarkasSystem(
            PetriNet net,
            Incidence incidence,
            List<AtLeast> conditions,
            List<AtLeast> traps,
            List<FiringLimit> limits,
            LongSupplier millisLeft) {
        this.net = net;
        this.incidence = incidence;
        this.conditions = conditions;
        this.traps = traps;
        this.limits = limits;
        this.millisLeft = millisLeft;
        int[] initial = net.initialMarking();
        for (AtLeast condition : conditions) {
            long missing =
                    Math.subtractExact(condition.least(), condition.weights().times(initial));
            add(growth(condition.weights()), missing);
        }
        for (int place = 0; place < initial.length; place++) {
            add(incidence.rows().get(place), -initial[place]);
        }
        limits.forEach(limit -> add(limit.row(), limit.bound()));
    }

    private void add(IntegerVector row, long bound) {
        rows.add(row);
        least.add(bound);
    }

    /** What each column adds to a weighted sum of tokens. */
    private IntegerVector growth(IntegerVector weights) {
        IntegerVector growth = IntegerVector.ZERO;
        for (int i = 0; i < weights.size(); i++) {
            growth = growth.combined(1, incidence.rows().get(weights.indexAt(i)), weights.valueAt(i));
        }
        return growth;
    }

    /** Whether a solver would take too long to be worth a try. */
    boolean isTooLarge() {
        return LinearProgram.isTooLarge(rows.size(), incidence.columns().size());
    }

    /** Counts that solve the system, few in sum, as a solver computes them. */
    Outcome counts() {
        LinearProgram program = new LinearProgram(incidence.columns().size(), millisLeft.getAsLong());
        for (int column = 0; column < incidence.columns().size(); column++) {
            program.cost(column, 1);
        }
        for (int row = 0; row < rows.size(); row++) {
            if (!rows.get(row).isZero() || least.get(row) > 0) {
                program.atLeast(rows.get(row), least.get(row));
            }
        }
        return program.solve();
    }

    /** The tokens of each place after such counts. */
    double[] tokens(double[] counts) {
        double[] tokens = new double[net.placeCount()];
        for (int place = 0; place < tokens.length; place++) {
            tokens[place] = net.initial(place);
            IntegerVector row = incidence.rows().get(place);
            for (int i = 0; i < row.size(); i++) {
                tokens[place] += row.valueAt(i) * counts[row.indexAt(i)];
            }
        }
        return tokens;
    }

    /** A proof that nothing solves the system; empty where none was found, though there may be one. */
    Optional<RefutedCase> proof() {
        LinearProgram program = new LinearProgram(rows.size(), millisLeft.getAsLong());
        long[] unsatisfied = new long[rows.size()];
        for (int row = 0; row < rows.size(); row++) {
            program.cost(row, -least.get(row));
            unsatisfied[row] = least.get(row) > 0 ? 1 : 0;
        }
        program.atMost(IntegerVector.of(unsatisfied), 1);
        for (IntegerVector column :
                Incidence.transposed(rows, incidence.columns().size())) {
            if (!column.isZero()) {
                program.atMost(column, 0);
            }
        }
        Outcome outcome = program.solve();
        return outcome.solved()
                ? WholeMultiple.of(outcome.values(), factors -> refuted(factors).isProof(net, incidence))
                        .map(this::refuted)
                : Optional.empty();
    }

    RefutedCase refuted(IntegerVector factors) {
        return new RefutedCase(conditions, traps, limits, factors);
    }
}
