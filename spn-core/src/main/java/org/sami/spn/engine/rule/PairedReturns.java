package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.protocol.Token;

/**
 * The returns of static instances on one place that a firing uses together: one of each instance that it needs one of, and of
 * their tokens those that all of them brought back. Returns that name nobody in common do not go together, in whatever order
 * they came.
 *
 * <p>Implements R-SHR-9.
 */
final class PairedReturns {
    /** Where no static instance limits a firing. */
    private static final PairedReturns UNLIMITED = new PairedReturns(List.of(), List.of());

    /** In the order of the instances. */
    final List<Return> returns;
    /** What all of them brought back, each token as often as all did. */
    final List<Token> tokens;

    private PairedReturns(List<Return> returns, List<Token> tokens) {
        this.returns = returns;
        this.tokens = tokens;
    }

    /** Whether static instances limit the firing to what they brought back. */
    boolean limit() {
        return !returns.isEmpty();
    }

    /** The earliest pairing of a place for a firing, older returns of earlier instances first; null where it must wait. */
    static @Nullable PairedReturns in(PlaceState place, FiringScope scope) {
        if (place.shared.length == 0) {
            return UNLIMITED;
        }
        List<List<Return>> choices = new ArrayList<>(place.shared.length);
        for (SharedRun run : place.shared) {
            if (scope.needsReturn(run)) {
                Return checked = scope.checkedOf(run);
                List<Return> choice = checked == null ? run.returns : List.of(checked);
                if (choice.isEmpty()) {
                    return null;
                }
                choices.add(choice);
            }
        }
        return choices.isEmpty() ? UNLIMITED : pair(choices, new ArrayList<>(choices.size()), null);
    }

    private static @Nullable PairedReturns pair(
            List<List<Return>> choices, List<Return> chosen, @Nullable List<Token> common) {
        if (chosen.size() == choices.size()) {
            return common != null && goTogether(chosen, common)
                    ? new PairedReturns(List.copyOf(chosen), List.copyOf(common))
                    : null;
        }
        for (Return next : choices.get(chosen.size())) {
            chosen.add(next);
            PairedReturns found = pair(choices, chosen, common == null ? next.tokens : common(common, next.tokens));
            chosen.remove(chosen.size() - 1);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /** A return of nobody goes with any. */
    private static boolean goTogether(List<Return> chosen, List<Token> common) {
        return !common.isEmpty() || chosen.stream().anyMatch(r -> r.tokens.isEmpty());
    }

    private static List<Token> common(List<Token> some, List<Token> others) {
        List<Token> left = new ArrayList<>(others);
        List<Token> common = new ArrayList<>(some);
        common.removeIf(token -> !left.remove(token));
        return common;
    }
}
