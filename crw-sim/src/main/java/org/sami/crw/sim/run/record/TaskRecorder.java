package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.report.TaskResult;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Records the results of tasks for the report. For the engine's thread. */
final class TaskRecorder implements ReportFold {
    private final Project project;
    private final Map<TaskId, Progress> tasks = new LinkedHashMap<>();

    TaskRecorder(Project project) {
        this.project = project;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                project.plan(started.plan())
                        .ifPresent(plan -> plan.tasks()
                                .forEach(task -> progressOf(new TaskId(started.mission(), task.name()), view)));
            } else if (effect instanceof Effect.Fired fired) {
                fired.used().forEach(used -> used.tasks().forEach(task -> progressOf(task, view)));
            } else if (effect instanceof Effect.TasksAllocated allocated) {
                allocated(allocated, view);
            }
        }
        TaskQueues.remembered(input)
                .flatMap(queue -> queue.getValue().current())
                .flatMap(task -> progressOf(task, view))
                .ifPresent(progress -> progress.started(atMillis));
        if (input instanceof Input.Received received
                && received.occurrence().type().equals(EventNames.TASK_COMPLETED)) {
            received.occurrence()
                    .tasks()
                    .forEach(task -> progressOf(task, view)
                            .ifPresent(progress -> progress.completed(
                                    atMillis, received.occurrence().proxies())));
        }
    }

    private void allocated(Effect.TasksAllocated allocated, EngineView view) {
        allocated
                .robots()
                .forEach((task, robot) -> progressOf(task, view)
                        .ifPresent(progress -> progress.allocated(
                                robot, Optional.ofNullable(allocated.before().get(task)))));
    }

    /** The progress of a task, under its owner's name for it; empty for a task whose mission ended unobserved. */
    private Optional<Progress> progressOf(TaskId name, EngineView view) {
        if (tasks.containsKey(name)) {
            return Optional.of(tasks.get(name));
        }
        return view.namesOf(name).stream()
                .findFirst()
                .map(task -> tasks.computeIfAbsent(task, fresh -> new Progress(location(fresh, view))));
    }

    private static Optional<TaskResult.Place> location(TaskId task, EngineView view) {
        Value location = view.task(task).orElse(Map.of()).get("location");
        return location instanceof GeoPoint point
                ? Optional.of(new TaskResult.Place(point.latDeg(), point.lonDeg()))
                : Optional.empty();
    }

    @Override
    public void addTo(ReportDraft report) {
        report.tasks(results());
    }

    /** The tasks in the order in which they became known. */
    private List<TaskResult> results() {
        List<TaskResult> results = new ArrayList<>();
        tasks.forEach((task, progress) -> results.add(new TaskResult(
                task.mission(),
                task.name(),
                progress.location,
                progress.boat,
                progress.allocations,
                progress.startedAtMillis,
                progress.completedAtMillis)));
        return results;
    }

    private static final class Progress {
        private final Optional<TaskResult.Place> location;
        private String boat = "";
        private int allocations;
        private OptionalLong startedAtMillis = OptionalLong.empty();
        private OptionalLong completedAtMillis = OptionalLong.empty();

        Progress(Optional<TaskResult.Place> location) {
            this.location = location;
        }

        void allocated(Optional<String> to, Optional<String> before) {
            boat = to.orElse("");
            if (to.isPresent() && !to.equals(before)) {
                allocations++;
                completedAtMillis = OptionalLong.empty();
            }
        }

        void started(long atMillis) {
            if (startedAtMillis.isEmpty()) {
                startedAtMillis = OptionalLong.of(atMillis);
            }
        }

        void completed(long atMillis, List<String> by) {
            completedAtMillis = OptionalLong.of(atMillis);
            by.forEach(who -> boat = who);
        }
    }
}
