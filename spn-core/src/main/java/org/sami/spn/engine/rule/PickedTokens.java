package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.PlacedToken;

/** Tokens of the marking, each once, in the order in which they were picked. A few are looked through; of more there is a table. */
final class PickedTokens {
    private static final int FEW = 8;

    private final List<PlacedToken> inOrder = new ArrayList<>(2);
    private @Nullable Set<PlacedToken> many;

    /** Adds a token; says whether it was not among them. */
    boolean add(PlacedToken e) {
        if (contains(e)) {
            return false;
        }
        inOrder.add(e);
        if (many != null) {
            many.add(e);
        } else if (inOrder.size() > FEW) {
            many = new HashSet<>(inOrder);
        }
        return true;
    }

    boolean contains(PlacedToken e) {
        return many == null ? inOrder.contains(e) : many.contains(e);
    }

    void clear() {
        inOrder.clear();
        many = null;
    }

    List<PlacedToken> inOrder() {
        return inOrder;
    }
}
