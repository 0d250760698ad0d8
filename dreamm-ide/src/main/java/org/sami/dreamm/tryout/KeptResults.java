package org.sami.dreamm.tryout;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Results of searches, kept in memory by what was asked; of many those that were used last. For one thread.
 *
 * @param <K> what was asked, with equality by value
 * @param <V> the result
 */
public final class KeptResults<K, V> {
    private static final float LOAD = 0.75f;

    private final Map<K, V> kept;

    /**
     * Nothing is kept yet.
     *
     * @param most how many results are kept, 1 or more
     */
    public KeptResults(int most) {
        kept = new LinkedHashMap<>(16, LOAD, true) {
            @Override
            protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
                return size() > most;
            }
        };
    }

    /** Keeps a result, in place of the one that was there. */
    public void keep(K asked, V result) {
        kept.put(Objects.requireNonNull(asked, "asked"), Objects.requireNonNull(result, "result"));
    }

    /** The result; empty where the same was not asked, or long ago. */
    public Optional<V> find(K asked) {
        return Optional.ofNullable(kept.get(asked));
    }
}
