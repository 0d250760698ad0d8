package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.PlacedToken;

/** Tokens of the marking that a firing has picked already. A few are looked through; of more there is a table. Used again for each firing. */
final class PickedTokens {
    private static final int FEW = 8;

    private final List<PlacedToken> few = new ArrayList<>(FEW);
    private @Nullable Set<PlacedToken> many;

    /** Adds a token; says whether it was not among them. */
    boolean add(PlacedToken e) {
        if (many != null) {
            return many.add(e);
        }
        if (few.contains(e)) {
            return false;
        }
        if (few.size() == FEW) {
            many = new HashSet<>(few);
            return many.add(e);
        }
        return few.add(e);
    }

    boolean contains(PlacedToken e) {
        return many == null ? few.contains(e) : many.contains(e);
    }

    void clear() {
        few.clear();
        many = null;
    }
}
