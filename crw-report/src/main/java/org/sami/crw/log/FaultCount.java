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
        private final Map<LineFault, Long> counts = new EnumMap<>(LineFault.class);
        private final Map<LineFault, List<Long>> lines = new EnumMap<>(LineFault.class);
        private final Map<LineFault, String> examples = new EnumMap<>(LineFault.class);

        void add(LineProblem problem) {
            counts.merge(problem.fault(), 1L, Long::sum);
            examples.putIfAbsent(problem.fault(), problem.message());
            List<Long> named = lines.computeIfAbsent(problem.fault(), fault -> new ArrayList<>());
            if (named.size() < NAMED) {
                named.add(problem.line());
            }
        }

        /** The counts, in the order of the kinds. */
        List<FaultCount> counts() {
            return counts.entrySet().stream()
                    .map(e -> new FaultCount(e.getKey(), e.getValue(), lines.get(e.getKey()), examples.get(e.getKey())))
                    .toList();
        }
    }
}
