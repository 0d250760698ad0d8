package org.sami.petri.coverability;

import java.util.Optional;
import java.util.function.LongFunction;

/** Compares the saturated graph of a seed's random net with the whole one. {@link SpoiltSaturationTest} loads it a second time, next to a spoilt net. */
public final class SaturationJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public SaturationJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return SaturatedQueriesTest.difference(seed, new SaturatedQueriesTest.Counts());
    }
}
