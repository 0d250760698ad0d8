package org.sami.spn.plannet;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Collects what a translation leaves to chance, each sentence once. For one thread. */
final class AbstractionList {
    private final Set<Abstraction> all = new LinkedHashSet<>();

    void wider(String where, String text) {
        all.add(new Abstraction(Abstraction.Kind.WIDER, where, text));
    }

    void partial(String where, String text) {
        all.add(new Abstraction(Abstraction.Kind.PARTIAL, where, text));
    }

    List<Abstraction> all() {
        return List.copyOf(all);
    }
}
