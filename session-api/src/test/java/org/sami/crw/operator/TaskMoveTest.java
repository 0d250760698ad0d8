package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.task.TaskMove;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;

/** Which tasks can be moved by hand, and that a move changes who has them; of a mission with two tasks and two boats. */
class TaskMoveTest {
    private static final TaskId A = new TaskId(1, "a");

    private final ModelWorld world = new ModelWorld();
    private final TaskQueues queues = new TaskQueues(world.host, (news, names) -> {});

    @BeforeEach
    void missionRuns() {
        world.host.addListener(queues);
        world.step(new Input.ProxyJoined("anna"), new Input.ProxyJoined("bert"), ModelWorld.start("test"));
        world.step(new Input.ProxyJoined("late"), allocate("anna"));
        world.settle();
    }

    private static Input allocate(String boat) {
        return new Input.AllocateTasks(Map.of(A, Optional.of(boat)));
    }

    private Optional<String> refusal(TaskId task, String boat) {
        return world.host.ask(view -> TaskMove.refusal(task, Optional.of(boat).filter(b -> !b.isEmpty()), view));
    }

    @Test
    void taskIsMovedFromBoatToBoatAndToNobody() {
        assertThat(refusal(A, "bert")).isEmpty();
        world.step(allocate("bert"));
        world.settle();
        assertThat(world.models.allocation().snapshot().queues()).containsOnlyKeys("bert");

        assertThat(refusal(A, "")).isEmpty();
        world.step(new Input.AllocateTasks(Map.of(A, Optional.empty())));
        world.settle();
        assertThat(world.models.allocation().snapshot().queues()).isEmpty();
        assertThat(world.models.allocation().snapshot().unallocated()).contains(A);
    }

    /** Queues are written a step after the allocation. */
    @Test
    void movedTaskIsNeverOutOfSight() {
        ModelWorld before = new ModelWorld();
        before.step(new Input.ProxyJoined("anna"), new Input.ProxyJoined("bert"), ModelWorld.start("test"));
        before.step(allocate("bert"));
        before.settle();

        assertThat(before.models.allocation().snapshot().queues()).containsExactly(Map.entry("bert", List.of(A)));
    }

    @Test
    void whatMakesNoSenseIsRefusedInWords() {
        assertThat(refusal(new TaskId(1, "z"), "bert")).contains("no running mission has a task 'z'");
        assertThat(refusal(new TaskId(7, "a"), "bert"))
                .contains("no running mission has a task 'a'; mission 7 does not run");
        assertThat(refusal(A, "carl")).contains("there is no boat 'carl'; there are anna, bert, late");
        assertThat(refusal(A, "anna")).contains("anna has the task 'a' already");
        assertThat(refusal(new TaskId(1, "b"), "")).contains("nobody has the task 'b'");
    }

    @Test
    void boatThatTakesNoPartInTheMissionGetsNoTaskOfIt() {
        assertThat(refusal(A, "late")).contains("late takes no part in mission 1");

        world.step(new Input.ProxyDropped("bert", 1));
        assertThat(refusal(A, "bert")).contains("bert takes no part in mission 1");
        world.step(new Input.ProxyDropped("bert", Ids.NONE));
        assertThat(refusal(A, "bert").orElseThrow()).startsWith("there is no boat 'bert'");
    }

    @Test
    void completeTaskIsNotDoneAgain() {
        world.step(TaskQueues.markComplete(A));

        assertThat(refusal(A, "bert")).contains("the task 'a' is complete");
    }
}
