package org.sami.spn.reference;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.stream.Collectors;
import org.sami.spn.testing.SpoiltClasses;

/**
 * Judges nets of plans that are made by code of which one line is spoilt. Some lines show in one of hundreds of seeds: {@code spoilt-seeds.txt} names it, and it is tried first. What it does not
 * show, as plans of that seed have become others, is looked for from seed 1 on, and the line for the file is printed.
 */
final class SpoiltNets {
    private static final int SOON = 20; // found as fast without the file

    private static final Map<String, Long> SEEDS = seeds();

    private final Class<?> judge;
    private final long mostSeeds;

    /**
     * Says who judges.
     *
     * @param judge a {@code LongFunction} from a seed to what differs, with a constructor without arguments
     * @param mostSeeds that are tried, from 1 on
     */
    SpoiltNets(Class<?> judge, long mostSeeds) {
        this.judge = judge;
        this.mostSeeds = mostSeeds;
    }

    private static Map<String, Long> seeds() {
        try (InputStream file = SpoiltNets.class.getResourceAsStream("spoilt-seeds.txt")) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split("\t", -1))
                    .collect(Collectors.toMap(columns -> columns[1], columns -> Long.valueOf(columns[0])));
        } catch (IOException damaged) {
            throw new UncheckedIOException(damaged);
        }
    }

    /**
     * The first difference that the judge sees with a line of a source in place of another; empty where the spoilt line is not noticed.
     *
     * @param spoilt what is spoilt, in words
     */
    Optional<?> difference(String spoilt, Path folder, Path source, String right, String wrong)
            throws ReflectiveOperationException {
        LongFunction<?> judged =
                (LongFunction<?>) SpoiltClasses.with(folder, source, right, wrong, SpoiltNets::isOfNets)
                        .loadClass(judge.getName())
                        .getConstructors()[0]
                        .newInstance();
        String name = judge.getSimpleName() + ": " + spoilt;
        Optional<?> found = Optional.empty();
        if (SEEDS.containsKey(name)) {
            found = judged(judged, SEEDS.get(name));
        }
        for (long seed = 1; seed <= mostSeeds && found.isEmpty(); seed++) {
            found = judged(judged, seed);
            if (found.isPresent() && seed > SOON) {
                System.out.println("spoilt-seeds.txt: " + seed + "\t" + name);
            }
        }
        return found;
    }

    /** Nets, and what compares them. */
    private static boolean isOfNets(String name) {
        return name.startsWith("org.sami.spn.plannet.")
                || name.startsWith("org.sami.spn.planspace.")
                || name.startsWith("org.sami.petri.")
                || name.startsWith("org.sami.spn.reference.");
    }

    /** What differs; a net that cannot be made or searched, or a run in which a robot is missing, is noticed too. */
    private static Optional<?> judged(LongFunction<?> judge, long seed) {
        try {
            return (Optional<?>) judge.apply(seed);
        } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException broken) {
            return Optional.of("seed " + seed + ": " + broken);
        }
    }
}
