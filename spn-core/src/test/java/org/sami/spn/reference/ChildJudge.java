package org.sami.spn.reference;

import java.util.Optional;
import java.util.function.LongFunction;

/** Holds the net of a seed's random plan with sub-missions to the engine. Loaded a second time, next to a spoilt translation, by {@link SpoiltChildTest}. */
public final class ChildJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public ChildJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return ChildNetTest.difference(seed);
    }
}
