package org.sami.crw.task;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Whether an operator may give a task to another boat by hand (docs/operator-models.md). */
public final class TaskMove {
    private TaskMove() {}

    /**
     * Why a task cannot be moved now, in one sentence; empty where it can. On the thread that owns the state.
     *
     * @param boat the boat that gets it; empty to take it from its present boat
     */
    public static Optional<String> refusal(TaskId task, Optional<String> boat, EngineView view) {
        List<TaskId> names = view.namesOf(task);
        if (names.isEmpty()) {
            return Optional.of("no running mission has a task '" + task.name() + "'"
                    + (view.mission(task.mission()).isEmpty() ? "; mission " + task.mission() + " does not run" : ""));
        }
        TaskId owned = names.get(0);
        Optional<String> had = Optional.ofNullable(view.allocation().get(owned));
        if (TaskQueues.isComplete(owned, view)) {
            return Optional.of("the task '" + task.name() + "' is complete");
        } else if (boat.isEmpty()) {
            return had.isEmpty() ? Optional.of("nobody has the task '" + task.name() + "'") : Optional.empty();
        } else if (!view.proxies().contains(boat.get())) {
            return Optional.of("there is no boat '" + boat.get() + "'; there are " + String.join(", ", view.proxies()));
        } else if (had.equals(boat)) {
            return Optional.of(boat.get() + " has the task '" + task.name() + "' already");
        }
        return takesPart(boat.get(), owned.mission(), view)
                ? Optional.empty()
                : Optional.of(boat.get() + " takes no part in mission " + owned.mission());
    }

    /** A boat takes part where its token stands, in the mission or below it, or where it has a task. */
    private static boolean takesPart(String boat, long mission, EngineView view) {
        boolean hasTask = view.allocation().entrySet().stream()
                .anyMatch(one ->
                        one.getKey().mission() == mission && one.getValue().equals(boat));
        return hasTask
                || view.missions().stream()
                        .filter(one -> isWithin(one, mission, view))
                        .map(MissionView::marking)
                        .flatMap(marking -> marking.values().stream())
                        .flatMap(Collection::stream)
                        .anyMatch(new Token.Proxy(boat)::equals);
    }

    private static boolean isWithin(MissionView one, long mission, EngineView view) {
        Optional<MissionView> at = Optional.of(one);
        while (at.isPresent() && at.get().id() != mission) {
            at = view.mission(at.get().parent());
        }
        return at.isPresent();
    }
}
