package org.sami.crw.task;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;

/** In which order a boat does its tasks. */
class TaskQueueTest {
    private static final TaskId A = new TaskId(1, "a");
    private static final TaskId B = new TaskId(1, "b");
    private static final TaskId C = new TaskId(1, "c");
    private static final TaskId OTHER = new TaskId(2, "a");

    @Test
    void newTasksComeLastInTheOrderOfTheirAllocation() {
        TaskQueue queue = medium(TaskQueue.EMPTY, B, A);

        assertThat(medium(queue, C).tasks()).containsExactly(B, A, C);
        assertThat(queue.current()).contains(B);
    }

    @Test
    void tasksThatAreNamedAgainAreOrderedAmongThePlacesThatTheyHold() {
        TaskQueue queue = medium(medium(medium(TaskQueue.EMPTY, A), OTHER), B);

        assertThat(medium(queue, B, A).tasks()).containsExactly(B, OTHER, A);
        assertThat(medium(queue, C, B, A).tasks()).containsExactly(C, OTHER, B, A);
    }

    @Test
    void aMoreUrgentAllocationComesFirst() {
        TaskQueue queue = medium(TaskQueue.EMPTY, A, B).with(List.of(OTHER), Priority.HIGH);

        assertThat(queue.tasks()).containsExactly(OTHER, A, B);
        assertThat(queue.with(List.of(B), Priority.CRITICAL).tasks()).containsExactly(B, OTHER, A);
    }

    @Test
    void aTaskThatIsNamedTwiceIsQueuedOnce() {
        assertThat(medium(TaskQueue.EMPTY, A, A, B).tasks()).containsExactly(A, B);
    }

    @Test
    void theTasksOfAMissionGoWithIt() {
        TaskQueue queue = medium(TaskQueue.EMPTY, A, OTHER, B);

        assertThat(queue.withoutMission(1).tasks()).containsExactly(OTHER);
        assertThat(queue.without(A).tasks()).containsExactly(OTHER, B);
    }

    @Test
    void theMemoryGivesBackWhatItWasGiven() {
        TaskQueue queue = medium(TaskQueue.EMPTY, B, OTHER).with(List.of(A), Priority.HIGH);

        assertThat(TaskQueue.of(queue.toValue())).isEqualTo(queue).hasSameHashCodeAs(queue);
        assertThat(TaskQueue.of(new IntegerValue(3))).isEqualTo(TaskQueue.EMPTY);
    }

    private static TaskQueue medium(TaskQueue queue, TaskId... tasks) {
        return queue.with(List.of(tasks), Priority.MEDIUM);
    }
}
