package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.task.TaskMove;
import org.sami.session.api.RefusedException;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;

/** What an operator does to running missions apart from their plans: refused where it makes no sense as things stand, and written into the operator's log. */
final class MissionActions {
    private final SessionEngine engine;
    private final OperatorModels models;

    MissionActions(SessionEngine engine, OperatorModels models) {
        this.engine = engine;
        this.models = models;
    }

    /** Delivers what failed for a mission to its handlers again. */
    CompletionStage<Void> sendAgain(long mission) {
        return engine.ask(view -> models.stuck().takeAgain(mission)).thenAccept(again -> {
            if (again.isEmpty()) {
                throw new RefusedException("nothing has failed in mission " + mission + " that can be sent again");
            }
            again.forEach(engine.host()::redeliver);
            String words = "sent again what failed in mission " + mission;
            models.log().add(OperatorLogEntry.Kind.MISSION, words, mission, List.of());
        });
    }

    /** Gives a task to another boat, or to nobody. */
    CompletionStage<Void> moveTask(TaskId task, Optional<String> boat) {
        return engine.ask(view -> TaskMove.refusal(task, boat, view)).thenCompose(refusal -> {
            if (refusal.isPresent()) {
                return CompletableFuture.failedFuture(new RefusedException(refusal.get()));
            }
            String words = "moved task " + task.name() + " to " + boat.orElse("nobody");
            return engine.posted()
                    .post(new Input.AllocateTasks(Map.of(task, boat)), effects -> null)
                    .thenAccept(moved -> models.log()
                            .add(
                                    OperatorLogEntry.Kind.TASK,
                                    words,
                                    task.mission(),
                                    boat.stream().toList()));
        });
    }
}
