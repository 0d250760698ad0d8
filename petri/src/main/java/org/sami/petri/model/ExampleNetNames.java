package org.sami.petri.model;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.petri.net.PetriNet;

/** Finds an {@link ExampleNets example net} by a name such as {@code kanban-5}. */
public final class ExampleNetNames {
    private static final Pattern NAME = Pattern.compile("([a-z-]+)-(\\d{1,4})");

    private static final List<Family> FAMILIES = List.of(
            new Family("kanban", 1, 1000, ExampleNets::kanban),
            new Family("open-kanban", 1, 1000, ExampleNets::openKanban),
            new Family("philosophers", 2, 1000, ExampleNets::philosophers),
            new Family("token-ring", 2, 1000, ExampleNets::tokenRing),
            new Family("agents", 1, 1000, ExampleNets::agents),
            new Family("shared-memory", 1, 100, ExampleNets::sharedMemory),
            new Family("producer-consumer", 0, 1000, ExampleNets::producerConsumer),
            new Family("erk", 1, 1000, ExampleNets::erk),
            new Family("circadian-clock", 1, 1000, ExampleNets::circadianClock),
            new Family("peterson", 1, 30, MutualExclusionNets::peterson),
            new Family("lamport", 1, 100, MutualExclusionNets::lamport));

    private record Family(String name, int least, int most, IntFunction<PetriNet> net) {
        String words() {
            return name + "-N (N from " + least + " to " + most + ")";
        }
    }

    private ExampleNetNames() {}

    /** The net of a name; empty where there is none of that name and size. */
    public static Optional<PetriNet> find(String name) {
        Matcher parts = NAME.matcher(name);
        if (!parts.matches()) {
            return Optional.empty();
        }
        int size = Integer.parseInt(parts.group(2));
        return FAMILIES.stream()
                .filter(family -> family.name().equals(parts.group(1)))
                .filter(family -> size >= family.least() && size <= family.most())
                .map(family -> family.net().apply(size))
                .findFirst();
    }

    /** What names there are, for people. */
    public static List<String> words() {
        return FAMILIES.stream().map(Family::words).toList();
    }
}
