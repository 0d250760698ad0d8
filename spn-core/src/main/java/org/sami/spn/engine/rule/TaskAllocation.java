package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Reserved;

/**
 * Tasks made at run time, and which robot a task is allocated to.
 *
 * <p>Implements R-TASK-1, R-TASK-2, R-TASK-3, R-TASK-4.
 */
public final class TaskAllocation {
    private final RuleStep step;
    private final PendingOccurrences pendings;

    TaskAllocation(RuleStep step, PendingOccurrences pendings) {
        this.step = step;
        this.pendings = pendings;
    }

    /** Allocates or releases tasks, as an input. */
    public void allocate(Map<TaskId, Optional<String>> allocation, Priority priority) {
        List<TaskState> tasks = new ArrayList<>();
        Map<TaskId, String> before = new LinkedHashMap<>();
        allocation.forEach((task, robot) -> {
            TaskState state = step.task(task);
            if (state == null) {
                step.note(
                        NoteKind.REJECTED_INPUT,
                        step.state.missions.containsKey(task.mission()) ? task.mission() : Ids.NONE,
                        "There is no task '" + task.name() + "' of a running mission " + task.mission());
            } else if (robot.isPresent() && !step.state.proxies().contains(robot.get())) {
                step.note(
                        NoteKind.REJECTED_INPUT,
                        task.mission(),
                        "Task '" + task.name() + "' cannot be allocated to '" + robot.get()
                                + "': no such robot is known");
            } else {
                TaskState owned = state.owned();
                if (!owned.proxy().isEmpty() && !tasks.contains(owned)) {
                    before.putIfAbsent(owned.id, owned.proxy());
                }
                owned.allocate(robot.orElse(""));
                tasks.add(owned);
            }
        });
        renewNames();
        tell(tasks, before, priority);
    }

    /** Releases what a robot had of a mission's own tasks. */
    public void release(MissionState m, String robot) {
        List<TaskState> released = new ArrayList<>();
        Map<TaskId, String> before = new LinkedHashMap<>();
        for (TaskState task : m.tasks.values()) {
            if (task.original == null && task.proxy().equals(robot)) {
                task.allocate("");
                released.add(task);
                before.put(task.id, robot);
            }
        }
        tell(released, before, Priority.MEDIUM);
    }

    private void tell(List<TaskState> tasks, Map<TaskId, String> before, Priority priority) {
        if (!tasks.isEmpty()) {
            Map<TaskId, Optional<String>> robots = new LinkedHashMap<>();
            tasks.forEach(task -> robots.put(task.id, Optional.of(task.proxy()).filter(robot -> !robot.isEmpty())));
            step.emit(new Effect.TasksAllocated(robots, before, priority));
        }
    }

    /** Applies the allocation in an activation. */
    public void apply(SentActivation sent) {
        Value tasks = sent.activation.values().get(Reserved.TASKS);
        if (tasks == null && sent.activation.values().get(Reserved.ALLOCATION) instanceof RecordValue record) {
            tasks = record.field(Reserved.TASKS).orElse(null);
        }
        if (!(tasks instanceof MapValue map)) {
            step.note(
                    NoteKind.HANDLER_FAILED,
                    sent.mission().id,
                    sent.activation.type() + " at '" + sent.visit.place.place + "' has no allocation");
            return;
        }
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        map.entries().forEach((task, robot) -> {
            if (task instanceof TaskId id && robot instanceof ProxyValue proxy) {
                allocation.put(id, Optional.of(proxy.proxy()));
            }
        });
        allocate(allocation, sent.activation.priority());
    }

    private void renewNames() {
        for (MissionState m : step.state.missions.values()) {
            for (TransitionState t : m.transitions) {
                if (t != null && t.pending > 0) {
                    pendings.renewNames(t);
                }
            }
        }
    }

    /** Adds tasks to a running mission; a reason where it cannot. */
    public Optional<String> add(Input.AddTasks input) {
        MissionState m = step.state.missions.get(input.mission());
        if (m == null) {
            return Optional.of("There is no running mission " + input.mission());
        }
        for (TaskSpec task : input.tasks()) {
            if (m.tasks.containsKey(task.name())) {
                return Optional.of("The mission has a task '" + task.name() + "' already");
            }
        }
        input.tasks().forEach(t -> m.addTask(new TaskState(m.taskId(t.name()), t.taskClass(), t.fields(), null)));
        return Optional.empty();
    }

    /** Makes one task per item of the list in an activation. */
    public List<TaskId> generate(SentActivation sent) {
        MissionState m = sent.mission();
        String taskClass = sent.activation
                .value(Reserved.TASK_CLASS)
                .map(CompiledInput::text)
                .orElse("");
        Value locations = sent.activation.values().get(Reserved.LOCATIONS);
        List<TaskId> made = new ArrayList<>();
        if (locations instanceof ListValue list) {
            for (Value location : list.items()) {
                String name;
                do {
                    name = (taskClass.isEmpty() ? "Task" : taskClass) + " " + ++m.generatedTasks;
                } while (m.tasks.containsKey(name));
                m.addTask(new TaskState(m.taskId(name), taskClass, Map.of(Reserved.LOCATION, location), null));
                made.add(m.taskId(name));
            }
        } else {
            step.note(
                    NoteKind.HANDLER_FAILED,
                    m.id,
                    sent.activation.type() + " at '" + sent.visit.place.place + "' has no list of locations");
        }
        return made;
    }
}
