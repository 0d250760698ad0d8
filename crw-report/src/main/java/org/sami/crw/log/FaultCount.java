package org.sami.crw.log;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * All problems of one kind.
 *
 * @param lines the first {@value #NAMED} line numbers
 * @param example the message of the first
 */
public record FaultCount(LineFault fault, long count, List<Long> lines, String example) {
    static final int NAMED = 20;

    public FaultCount {
        lines = List.copyOf(lines);
    }

    /** Counts problems by their kind. */
    static final class Counter {
        private final Map<LineFault, Found> found = new EnumMap<>(LineFault.class);

        /** The problems of a kind. */
        private static final class Found {
            private final String example;
            private final List<Long> lines = new ArrayList<>();
            private long count;

            Found(String example) {
                this.example = example;
            }
        }

        void add(LineProblem problem) {
            Found one = found.computeIfAbsent(problem.fault(), fault -> new Found(problem.message()));
            one.count++;
            if (one.lines.size() < NAMED) {
                one.lines.add(problem.line());
            }
        }

        /** The counts, in the order of the kinds. */
        List<FaultCount> counts() {
            return found.entrySet().stream()
                    .map(e -> new FaultCount(e.getKey(), e.getValue().count, e.getValue().lines, e.getValue().example))
                    .toList();
        }
    }
}
