package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.spn.model.Project;

@Timeout(120)
class InterruptCommandsTest {
    private static final Project PROJECT =
            SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'one'}, {'plan': 'two'}]}],
             'plans': [%s, %s]}""".formatted(plan("one", "avoid boat"), plan("two", "alarm")));

    private static String plan(String id, String interrupt) {
        return """
              {'id': '%s', 'places': [
                {'id': 'go', 'name': 'Go', 'start': true, 'outputs': [
                  {'id': 'offer', 'type': 'GeneralInterrupt', 'fields': {'interruptName': {'value': '%s'}}}]},
                {'id': 'pressed', 'name': 'Pressed'}],
               'transitions': [{'id': 'press', 'inputs': [{'id': 'received', 'type': 'GeneralInterruptReceived'}]}],
               'inEdges': [{'id': 'a', 'place': 'go', 'transition': 'press',
                 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]}],
               'outEdges': [{'id': 'b', 'transition': 'press', 'place': 'pressed',
                 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]}]}""".formatted(id, interrupt);
    }

    @Test
    void anInterruptIsPressedByItsKeyWhichIsNeverThatOfAnother() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            long one = world.start("one");
            until("one is offered", () -> keys(world).equals(List.of("Interrupt: avoid boat Ctrl+F2")));
            assertThat(onEventThread(() ->
                            find(panel, "interrupt-avoid-boat", JButton.class).getToolTipText()))
                    .endsWith("(Ctrl+F2)");

            world.run("interrupt-1");
            until("it is taken", () -> firings(world, one) == 1);
            until(
                    "it is offered no longer",
                    () -> !world.context.commands().get("interrupt-1").whyNot().isEmpty());

            world.start("two");
            until(
                    "another has a key of its own",
                    () -> keys(world).equals(List.of("Interrupt: avoid boat Ctrl+F2", "Interrupt: alarm Ctrl+F3")));
        }
    }

    private static List<String> keys(SessionWorld world) {
        return onEventThread(() -> world.context.commands().all().stream()
                .filter(command -> command.id().startsWith("interrupt-"))
                .map(command -> command.title() + " " + command.keyText())
                .toList());
    }

    private static long firings(SessionWorld world, long mission) {
        return world.context
                .models()
                .missions()
                .snapshot()
                .mission(mission)
                .map(now -> now.firings())
                .orElse(0L);
    }
}
