package org.sami.spn.engine.state;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.protocol.Token;

/**
 * Who stands in the watched places of a transition that waits for all, and how many of them have not reported: each
 * entry, departure and report takes constant time. Robots are counted, not copies; generic tokens are not.
 *
 * <p>Implements R-PEND-8.
 */
public final class Barrier {
    private static final class Count {
        int copies;
        final int[] reports;

        Count(int inputs) {
            reports = new int[inputs];
        }
    }

    private final int inputs;
    private final Map<Token, Count> counts = new HashMap<>();
    private final int[] missing;
    private int standing;

    public Barrier(int inputs) {
        this.inputs = inputs;
        this.missing = new int[inputs];
    }

    public void entered(Token token) {
        Count c = count(token);
        if (c.copies++ == 0) {
            standing++;
            for (int i = 0; i < inputs; i++) {
                if (c.reports[i] == 0) {
                    missing[i]++;
                }
            }
        }
    }

    /** One copy left; says whether it was the last. */
    public boolean left(Token token) {
        Count c = counted(token);
        if (--c.copies > 0) {
            return false;
        }
        standing--;
        for (int i = 0; i < inputs; i++) {
            if (c.reports[i] == 0) {
                missing[i]--;
            }
        }
        forget(token, c);
        return true;
    }

    public void reported(int input, Token token) {
        Count c = count(token);
        if (c.reports[input]++ == 0 && c.copies > 0) {
            missing[input]--;
        }
    }

    public void withdrawn(int input, Token token) {
        Count c = counted(token);
        if (--c.reports[input] == 0 && c.copies > 0) {
            missing[input]++;
        }
        forget(token, c);
    }

    public boolean stands(Token token) {
        Count c = counts.get(token);
        return c != null && c.copies > 0;
    }

    public boolean isEmpty() {
        return standing == 0;
    }

    /** How many of those who stand there have not reported on an input event. */
    public int missing(int input) {
        return missing[input];
    }

    public boolean hasReported(int input, Token token) {
        Count c = counts.get(token);
        return c != null && c.reports[input] > 0;
    }

    /** The count of a token that entered or reported before. */
    private Count counted(Token token) {
        return Objects.requireNonNull(counts.get(token), "a token that was counted");
    }

    private Count count(Token token) {
        return counts.computeIfAbsent(token, t -> new Count(inputs));
    }

    private void forget(Token token, Count c) {
        if (c.copies > 0) {
            return;
        }
        for (int reports : c.reports) {
            if (reports > 0) {
                return;
            }
        }
        counts.remove(token);
    }
}
