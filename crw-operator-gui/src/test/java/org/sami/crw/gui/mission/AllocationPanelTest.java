package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;

@Timeout(900)
class AllocationPanelTest {
    private static final List<String> BOATS = List.of("anna", "bert", "carl");

    /** So far apart that nothing is done while the test looks. */
    private static final ListValue LOCATIONS = new ListValue(List.of(
            GeoPoint.of(45.41, 10.9), GeoPoint.of(45.39, 10.9), GeoPoint.of(45.411, 10.9), GeoPoint.of(45.389, 10.9)));

    @Test
    void aTaskIsGivenToAnotherBoatByAMenuThatSaysWhatChanges() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("measure"), BOATS.toArray(String[]::new))) {
            AllocationPanel panel = laidOut(() -> new AllocationPanel(world.context));
            assertThat(world.whyNot("allocation-give")).startsWith("select a task");
            DividedTasks.of(world.session, LOCATIONS);
            String before = rows(panel, "allocation-table");
            String from = BOATS.stream()
                    .filter(boat ->
                            !now(world).queues().getOrDefault(boat, List.of()).isEmpty())
                    .findFirst()
                    .orElseThrow();
            String to = BOATS.get((BOATS.indexOf(from) + 1) % BOATS.size());
            TaskId task = now(world).queues().get(from).get(0);
            SessionWorld.select(
                    panel,
                    "allocation-table",
                    before.lines()
                            .toList()
                            .indexOf(from + "|1.|" + task.name() + " (mission 1, Measurement collection)"));

            JMenuItem item = item(panel, "allocation-give-" + to);
            assertThat(item.getText())
                    .startsWith(to + " does " + task.name() + " ")
                    .contains("; " + from + " leaves it now and ");
            onEventThread(() -> {
                item.doClick(0);
                return null;
            });

            until(
                    to + " has it",
                    () -> now(world).queues().getOrDefault(to, List.of()).contains(task));
            until("it is shown", () -> !rows(panel, "allocation-table").equals(before));
            until(
                    "it is logged",
                    () -> world.context.models().log().snapshot().stream()
                            .anyMatch(entry -> entry.text().contains("moved task")));
        }
    }

    private static JMenuItem item(AllocationPanel panel, String name) {
        return onEventThread(() -> {
            JPopupMenu menu = panel.menu();
            Optional<JMenuItem> found = Arrays.stream(menu.getComponents())
                    .filter(JMenuItem.class::isInstance)
                    .map(JMenuItem.class::cast)
                    .filter(one -> name.equals(one.getName()))
                    .findFirst();
            return found.orElseThrow(() -> new AssertionError("there is no " + name));
        });
    }

    private static AllocationSnapshot now(SessionWorld world) {
        return world.context.models().allocation().snapshot();
    }
}
