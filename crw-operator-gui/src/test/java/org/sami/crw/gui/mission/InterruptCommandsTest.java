package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.spn.model.Project;

@Timeout(900)
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
    void eachInterruptOfEachMissionHasAKeyThatNeverMeansAnother() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            assertThat(world.whyNot("interrupt-1")).isEqualTo("no mission has an interrupt with this key");
            long one = world.start("one");
            until("one is offered", () -> meant(world).equals(List.of("avoid boat of mission 1, one Ctrl+F2")));
            assertThat(onEventThread(() ->
                            find(panel, "interrupt-avoid-boat", JButton.class).getToolTipText()))
                    .endsWith("(Ctrl+F2)");
            world.start("one");
            until(
                    "the second mission has a key of its own",
                    () -> meant(world)
                            .equals(List.of(
                                    "avoid boat of mission 1, one Ctrl+F2", "avoid boat of mission 2, one Ctrl+F3")));

            world.run("interrupt-2");
            until("it is pressed for the second mission alone", () -> firings(world, 2) == 1);
            assertThat(firings(world, one)).isZero();
            until(
                    "it is offered no longer",
                    () -> !world.context.commands().get("interrupt-2").whyNot().isEmpty());

            world.session.abort(one);
            world.session.abort(2);
            until(
                    "nobody offers it",
                    () -> world.context
                            .commands()
                            .get("interrupt-1")
                            .whyNot()
                            .equals(Optional.of("no running mission offers it")));
            world.start("two");
            until(
                    "another has a key of its own",
                    () -> meant(world)
                            .equals(List.of(
                                    "avoid boat Ctrl+F2", "avoid boat Ctrl+F3", "alarm of mission 3, two Ctrl+F4")));
            world.start("one");
            until("it has its key again", () -> meant(world).contains("avoid boat of mission 4, one Ctrl+F2"));
        }
    }

    private static List<String> meant(SessionWorld world) {
        return onEventThread(() -> world.context.commands().all().stream()
                .filter(command -> command.title().startsWith("Interrupt: "))
                .map(command -> command.title().replace("Interrupt: ", "") + " " + command.keyText())
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
