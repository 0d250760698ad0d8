package org.sami.lessons.job;

import java.util.List;
import java.util.Optional;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.TaskId;

/**
 * One question of a plan to one who answers it by himself.
 *
 * @param type of the output event; empty text where the mission or the engine asks
 * @param numbers of the tasks
 */
record Asked(
        Answering by,
        String type,
        List<String> robots,
        List<TaskId> tasks,
        List<Integer> numbers,
        Optional<Activation> activation,
        Optional<Decision> decision) {
    /** What goes first of what is asked in one instant; does not depend on the plan. */
    String key() {
        return type + " " + robots.stream().sorted().toList() + " " + numbers;
    }
}
