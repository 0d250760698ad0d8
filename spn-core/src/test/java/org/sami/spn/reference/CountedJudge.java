package org.sami.spn.reference;

import java.util.Optional;
import java.util.function.LongFunction;

/** Compares nets that count robots with nets that name them, for a seed's random plans. {@link SpoiltCountingTest} loads it a second time, next to a spoilt translation. */
public final class CountedJudge implements LongFunction<Optional<String>> {
    /** Nothing is judged yet. */
    public CountedJudge() {}

    @Override
    public Optional<String> apply(long seed) {
        return CountedNetTest.difference(seed);
    }
}
