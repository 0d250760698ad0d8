package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;

/**
 * Task Complete: the entering tasks are done. Each is answered for itself, naming the boat that had it, and leaves that boat's queue,
 * so that the boat begins with its next one; being complete it is neither released nor unassigned.
 */
final class TaskCompleteHandler implements ActivationHandler {
    static final String TYPE = "TaskComplete";

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Input> inputs = new ArrayList<>();
        for (TaskId name : activation.tasks()) {
            List<TaskId> names = context.query(view -> view.namesOf(name));
            if (names.isEmpty()) {
                continue; // its mission has ended
            }
            TaskId task = names.get(0);
            boolean before = context.query(view -> TaskQueues.isComplete(task, view));
            if (before && context.redelivered()) {
                continue;
            }
            Optional<String> boat =
                    Optional.ofNullable(context.query(view -> view.allocation()).get(task));
            inputs.add(TaskQueues.markComplete(task));
            boat.ifPresent(had -> inputs.add(new Input.AllocateTasks(Map.of(task, Optional.empty()))));
            inputs.add(new Input.Received(Occurrence.answer(
                    EventNames.TASK_COMPLETED,
                    activation,
                    boat.map(List::of).orElse(List.of()),
                    List.of(name),
                    Map.of())));
        }
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }
}
