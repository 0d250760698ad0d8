package org.sami.spn.reference;

import java.util.List;
import java.util.Random;

/** Choices at random; a function of the seed. */
final class Dice {
    private final Random random;

    Dice(long seed) {
        random = new Random(seed);
    }

    boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    int below(int bound) {
        return random.nextInt(bound);
    }

    @SafeVarargs
    final <T> T pick(T... choices) {
        return choices[random.nextInt(choices.length)];
    }

    <T> T pick(List<T> choices) {
        return choices.get(random.nextInt(choices.size()));
    }

    /** Some of a list in its order: mostly one; none only where there are none. */
    <T> List<T> some(List<T> all) {
        if (all.size() < 2) {
            return all;
        }
        if (chance(50)) {
            return List.of(pick(all));
        }
        List<T> some = all.stream().filter(x -> chance(70)).toList();
        return some.isEmpty() ? all : some;
    }
}
