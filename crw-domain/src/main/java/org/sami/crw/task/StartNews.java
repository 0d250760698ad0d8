package org.sami.crw.task;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Starts of tasks that were posted to the engine and not yet processed. An activation that is made in between gets them as news, and
 * needs no answer of its own. Changes on the engine's thread; may be asked from any. Not kept over a restart.
 */
final class StartNews {
    private static final String START = TaskNews.Kind.STARTED.event();

    private final Set<TaskId> posted = new HashSet<>();
    private final Map<Long, Set<TaskId>> byActivation = new ConcurrentHashMap<>();

    /** Inputs that are posted, in the order of the engine's queue. */
    void posted(List<Input> inputs) {
        for (Input input : inputs) {
            if (isStart(input)) {
                posted.addAll(((Input.Received) input).occurrence().tasks());
            }
        }
    }

    /** An input that the engine has processed. */
    void processed(Input input) {
        if (isStart(input)) {
            posted.removeAll(((Input.Received) input).occurrence().tasks());
        }
    }

    /** What the engine has activated, in the step of the newest posting or after it. */
    void activated(List<Effect> effects, Vocabulary words) {
        if (posted.isEmpty()) {
            return;
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated && saysStarts(activated.activation(), words)) {
                note(activated.activation());
            }
        }
    }

    private static boolean saysStarts(Activation activation, Vocabulary words) {
        return words.event(activation.type())
                .filter(type -> type.answers().contains(START))
                .isPresent();
    }

    private void note(Activation activation) {
        Set<TaskId> tasks = new HashSet<>(activation.tasks());
        tasks.retainAll(posted);
        if (!tasks.isEmpty()) {
            byActivation.put(activation.id(), Set.copyOf(tasks));
        }
    }

    /** Takes the tasks of an activation whose start was under way when it was made: whoever answers the activation asks once. */
    Set<TaskId> takeUnderWay(long activation) {
        return Optional.ofNullable(byActivation.remove(activation)).orElse(Set.of());
    }

    private static boolean isStart(Input input) {
        return input instanceof Input.Received received
                && received.occurrence().activation() == Ids.NONE
                && received.occurrence().type().equals(START);
    }
}
