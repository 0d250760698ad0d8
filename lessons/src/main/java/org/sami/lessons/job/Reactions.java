package org.sami.lessons.job;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Which reaction of a case's script is for which question: the first that fits it. */
final class Reactions {
    private final List<JobCase.Reaction> script;
    private final Map<JobCase.Reaction, Integer> asked = new HashMap<>();

    Reactions(JobCase job) {
        script = job.script();
    }

    /** The reaction to the next question of that kind; to be asked once a question. */
    Optional<JobCase.Reaction> next(String type, List<String> robots, List<Integer> tasks) {
        Optional<JobCase.Reaction> found = Optional.empty();
        for (JobCase.Reaction reaction : script) {
            boolean fits = reaction.on().equals(type)
                    && robots.containsAll(reaction.robots())
                    && tasks.containsAll(reaction.tasks());
            if (fits) {
                int count = asked.merge(reaction, 1, Integer::sum);
                boolean isNow = reaction.time().isEmpty() || reaction.time().getAsInt() == count;
                if (isNow && found.isEmpty()) {
                    found = Optional.of(reaction);
                }
            }
        }
        return found;
    }
}
