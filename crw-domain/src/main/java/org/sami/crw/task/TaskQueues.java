package org.sami.crw.task;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.ListenerList;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.TaskId;

/**
 * The queue of tasks of every boat, kept in step with what the engine allocates, and the news of it for plans (docs/language.md).
 * The queues stand in the session's journalled memory, written in one batch with the news, so that each is published once, whatever dies in
 * between. News that no transition waits for is not posted.
 *
 * <p>Changes on the engine's thread; may be asked from any.
 */
public final class TaskQueues implements HostListener {
    private static final String QUEUE = "tasks/";
    private static final String COMPLETE = "task-complete/";

    private final EngineHost host;
    private final ListenerList<TaskListener> listeners = new ListenerList<>();
    private final StartNews starts = new StartNews();
    private volatile Map<String, TaskQueue> queues;
    private boolean compared;

    /**
     * The queues of a host, which may go on with a state that was restored.
     *
     * @param listener receives all news, whether a plan waits for it or not
     */
    public TaskQueues(EngineHost host, TaskListener listener) {
        this.host = host;
        listeners.add(listener);
        this.queues = host.ask(TaskQueues::remembered);
    }

    /** The queue of a boat as an input remembers it; empty where the input is about something else. */
    public static Optional<Map.Entry<String, TaskQueue>> remembered(Input input) {
        return input instanceof Input.Remember remember
                        && remember.mission() == Ids.NONE
                        && remember.key().startsWith(QUEUE)
                ? Optional.of(Map.entry(remember.key().substring(QUEUE.length()), TaskQueue.of(remember.value())))
                : Optional.empty();
    }

    /** The task that an input marks as complete, or as such no longer; empty where the input is about something else. */
    public static Optional<Map.Entry<TaskId, Boolean>> completed(Input input) {
        return input instanceof Input.Remember remember
                        && remember.key().startsWith(COMPLETE)
                        && remember.value() instanceof BooleanValue is
                ? Optional.of(Map.entry(
                        new TaskId(remember.mission(), remember.key().substring(COMPLETE.length())), is.value()))
                : Optional.empty();
    }

    /** The queues of a state, by boat. */
    public static Map<String, TaskQueue> remembered(EngineView view) {
        Map<String, TaskQueue> found = new TreeMap<>();
        for (String boat : view.proxies()) {
            view.memory(Ids.NONE, QUEUE + boat).ifPresent(value -> found.put(boat, TaskQueue.of(value)));
        }
        return found;
    }

    /** The queue of a boat. */
    public TaskQueue of(String boat) {
        return queues.getOrDefault(boat, TaskQueue.EMPTY);
    }

    /** The boats that have something to do, with the task that each does now. */
    public Map<String, TaskId> current() {
        Map<String, TaskId> current = new LinkedHashMap<>();
        queues.forEach((boat, queue) -> queue.current().ifPresent(task -> current.put(boat, task)));
        return current;
    }

    /**
     * Takes the tasks of an activation whose start was posted before it and is processed after it: saying it once more would say it
     * twice. Whoever answers the activation asks once.
     */
    public Set<TaskId> takeStartsUnderWay(long activation) {
        return starts.takeUnderWay(activation);
    }

    /** What marks a task as complete, so that its release is no news. */
    public static Input markComplete(TaskId task) {
        return complete(task, true);
    }

    /** Whether a task was completed and not allocated again. */
    public static boolean isComplete(TaskId task, EngineView view) {
        return view.memory(task.mission(), COMPLETE + task.name())
                .filter(new BooleanValue(true)::equals)
                .isPresent();
    }

    private static Input complete(TaskId task, boolean is) {
        return new Input.Remember(task.mission(), COMPLETE + task.name(), new BooleanValue(is));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        starts.processed(input);
        follow(effects, view);
        starts.activated(effects, view.vocabulary());
    }

    private void follow(List<Effect> effects, EngineView view) {
        if (compared && effects.stream().noneMatch(this::concernsTasks)) {
            return;
        }
        Map<String, TaskQueue> before = queues;
        Change change = new Change(new TreeMap<>(before));
        if (!compared) {
            compared = true;
            change.compare(view);
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.TasksAllocated allocated) {
                change.allocated(allocated, view);
            } else if (effect instanceof Effect.MissionEnded ended) {
                change.ended(ended.mission());
            }
        }
        if (change.inputs.isEmpty() && change.after.equals(before)) {
            return;
        }
        queues = new TreeMap<>(change.after);
        List<Input> posted = new ArrayList<>(change.inputs);
        change.after.forEach((boat, queue) -> {
            if (!Objects.equals(queue, before.get(boat))) {
                posted.add(new Input.Remember(Ids.NONE, QUEUE + boat, queue.toValue()));
            }
        });
        change.news.sort(Comparator.comparing(TaskNews::kind));
        for (TaskNews news : change.news) {
            List<TaskId> names = view.namesOf(news.task());
            listeners.each(listener -> listener.onNews(news, names));
            posted.addAll(occurrences(news, names, view));
        }
        starts.posted(posted);
        host.post(posted);
    }

    private boolean concernsTasks(Effect effect) {
        return effect instanceof Effect.TasksAllocated
                || (effect instanceof Effect.MissionEnded ended
                        && queues.values().stream()
                                .anyMatch(queue ->
                                        queue.tasks().stream().anyMatch(task -> task.mission() == ended.mission())));
    }

    private static List<Input> occurrences(TaskNews news, List<TaskId> names, EngineView view) {
        List<Input> occurrences = new ArrayList<>();
        if (view.awaits(news.kind().event())) {
            List<String> boats = news.boat().isEmpty() ? List.of() : List.of(news.boat());
            for (TaskId name : names) {
                occurrences.add(new Input.Received(
                        new Occurrence(news.kind().event(), name.mission(), Ids.NONE, boats, List.of(name), Map.of())));
            }
        }
        return occurrences;
    }

    /** What one step changes. */
    private static final class Change {
        private final Map<String, TaskQueue> after;
        private final List<TaskNews> news = new ArrayList<>();
        private final List<Input> inputs = new ArrayList<>();

        Change(Map<String, TaskQueue> queues) {
            after = queues;
        }

        /** What was allocated while nobody listened: before the death of the process. */
        void compare(EngineView view) {
            Map<TaskId, String> had = new LinkedHashMap<>();
            after.forEach((boat, queue) -> queue.tasks().forEach(task -> had.put(task, boat)));
            Map<TaskId, Optional<String>> robots = new LinkedHashMap<>();
            view.allocation().forEach((task, boat) -> {
                if (view.namesOf(task).get(0).equals(task) && !boat.equals(had.get(task))) {
                    robots.put(task, Optional.of(boat));
                }
            });
            Map<TaskId, String> allocation = view.allocation();
            had.keySet().stream().filter(task -> !allocation.containsKey(task)).forEach(task -> {
                if (view.namesOf(task).isEmpty()) {
                    ended(task.mission());
                } else {
                    robots.put(task, Optional.empty());
                }
            });
            if (!robots.isEmpty()) {
                allocated(new Effect.TasksAllocated(robots, had, Priority.MEDIUM), view);
            }
        }

        void allocated(Effect.TasksAllocated allocated, EngineView view) {
            Map<String, TaskQueue> before = new TreeMap<>(after);
            Map<String, List<TaskId>> given = new TreeMap<>();
            allocated.robots().forEach((task, robot) -> {
                boolean complete = isComplete(task, view);
                Optional<String> had = Optional.ofNullable(allocated.before().get(task));
                if (!had.equals(robot)) {
                    had.ifPresent(boat -> leaves(task, boat, robot, complete));
                }
                robot.ifPresent(boat -> {
                    given.computeIfAbsent(boat, name -> new ArrayList<>()).add(task);
                    if (complete) {
                        inputs.add(complete(task, false));
                    }
                });
            });
            given.forEach((boat, tasks) ->
                    after.put(boat, after.getOrDefault(boat, TaskQueue.EMPTY).with(tasks, allocated.priority())));
            tellOrder(before);
        }

        void ended(long mission) {
            Map<String, TaskQueue> before = new TreeMap<>(after);
            after.replaceAll((boat, queue) -> queue.withoutMission(mission));
            tellOrder(before);
        }

        private void leaves(TaskId task, String boat, Optional<String> to, boolean complete) {
            after.computeIfPresent(boat, (name, queue) -> queue.without(task));
            if (!complete) {
                news.add(new TaskNews(TaskNews.Kind.RELEASED, task, boat));
                news.add(to.map(other -> new TaskNews(TaskNews.Kind.REASSIGNED, task, other))
                        .orElse(new TaskNews(TaskNews.Kind.UNASSIGNED, task, "")));
            }
        }

        private void tellOrder(Map<String, TaskQueue> before) {
            after.forEach((boat, queue) -> {
                TaskQueue old = before.getOrDefault(boat, TaskQueue.EMPTY);
                for (TaskId task : queue.tasks()) {
                    if (old.position(task).isPresent()
                            && queue.position(task).getAsInt()
                                    > old.position(task).getAsInt()) {
                        news.add(new TaskNews(TaskNews.Kind.DELAYED, task, boat));
                    }
                }
                queue.current()
                        .filter(task -> !old.current().equals(Optional.of(task)))
                        .ifPresent(task -> news.add(new TaskNews(TaskNews.Kind.STARTED, task, boat)));
            });
        }
    }
}
