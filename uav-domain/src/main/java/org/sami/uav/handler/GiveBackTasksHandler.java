package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;

/**
 * Give Back Tasks: the tasks that the entering aircraft have left of the mission are allocated to none, so that their commands are withdrawn before the plan
 * asks something else of the aircraft. {@link AircraftNews} tells the plan of each task.
 */
final class GiveBackTasksHandler implements ActivationHandler {
    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<String> aircraft =
                Addressee.of(activation, context).stream().map(Addressee::boat).toList();
        Map<TaskId, Optional<String>> toNobody = new LinkedHashMap<>();
        context.query(view -> view.allocation()).forEach((task, of) -> {
            if (task.mission() == activation.mission() && aircraft.contains(of)) {
                toNobody.put(task, Optional.empty());
            }
        });
        List<Input> inputs = new ArrayList<>();
        if (!toNobody.isEmpty()) {
            inputs.add(new Input.AllocateTasks(toNobody));
        }
        for (String one : aircraft) {
            inputs.add(new Input.Received(
                    Occurrence.answer(UavEvents.TASKS_GIVEN_BACK, activation, List.of(one), List.of(), Map.of())));
        }
        context.post(inputs);
    }
}
