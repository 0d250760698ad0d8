package org.sami.crw.operator.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.TaskId;

class TaskMovePreviewTest {
    private static final TaskId PIER = new TaskId(1, "pier");
    private static final TaskId BUOY = new TaskId(1, "buoy");
    private static final TaskId REED = new TaskId(1, "reed");
    private static final TaskId FREE = new TaskId(1, "free");
    private static final AllocationSnapshot NOW =
            new AllocationSnapshot(Map.of("anna", List.of(PIER, BUOY), "bert", List.of(REED)), List.of(FREE));

    @Test
    void whoLosesTheTaskItIsAtGoesOnWithItsNext() {
        assertThat(words(PIER, "bert"))
                .isEqualTo("bert does pier as its number 2; anna leaves it now and goes on with buoy");
        assertThat(words(REED, "carl")).isEqualTo("carl does reed at once; bert leaves it now and has no task left");
    }

    @Test
    void aTaskThatWaitsIsOnlyTakenOff() {
        assertThat(words(BUOY, "bert")).isEqualTo("bert does buoy as its number 2; anna loses it");
        assertThat(words(FREE, "anna")).isEqualTo("anna does free as its number 3");
    }

    @Test
    void nobodyCanHaveItAndToWhomHasItItCannotBeGiven() {
        assertThat(TaskMovePreview.of(PIER, Optional.empty(), NOW).orElseThrow().words())
                .isEqualTo("nobody does pier; anna leaves it now and goes on with buoy");
        assertThat(TaskMovePreview.of(PIER, Optional.of("anna"), NOW)).isEmpty();
        assertThat(TaskMovePreview.of(FREE, Optional.empty(), NOW)).isEmpty();
    }

    private static String words(TaskId task, String boat) {
        return TaskMovePreview.of(task, Optional.of(boat), NOW).orElseThrow().words();
    }
}
