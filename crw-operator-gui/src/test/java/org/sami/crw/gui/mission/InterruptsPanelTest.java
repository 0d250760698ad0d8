package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.press;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandPolicy;
import org.sami.ui.command.CommandRegistry;

/** Boats work, have their batteries swapped and come back, or are taken out for good: the buttons of that. */
@Timeout(900)
class InterruptsPanelTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'p'}]}],
             'plans': [{'id': 'p', 'name': 'Work',
              'places': [{'id': 'start', 'name': 'Start', 'start': true}, {'id': 'work', 'name': 'Work'},
                {'id': 'swap-button', 'name': 'Swap button', 'outputs': [
                  {'id': 's', 'type': 'ProxyInterrupt', 'fields': {'interruptName': {'value': 'battery swap'}}}]},
                {'id': 'abort-button', 'name': 'Abort button', 'outputs': [
                  {'id': 'a', 'type': 'ProxyInterrupt', 'fields': {'interruptName': {'value': 'proxy abort'}}}]},
                {'id': 'out', 'name': 'Out'}],
              'transitions': [{'id': 'begin'},
                {'id': 'abort', 'inputs': [{'id': 'i2', 'type': 'ProxyInterruptReceived'}]},
                {'id': 'swap', 'inputs': [{'id': 'i1', 'type': 'ProxyInterruptReceived'}]}],
              'inEdges': [
                {'id': 'e0', 'place': 'start', 'transition': 'begin', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'any-proxy'}]},
                {'id': 'e1', 'place': 'swap-button', 'transition': 'swap', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]},
                {'id': 'e2', 'place': 'work', 'transition': 'swap', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'relevant'}]},
                {'id': 'e3', 'place': 'abort-button', 'transition': 'abort', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]},
                {'id': 'e4', 'place': 'work', 'transition': 'abort', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'relevant'}]}],
              'outEdges': [
                {'id': 'oa', 'transition': 'begin', 'place': 'work', 'requirements': [{'action': 'take', 'n': 'all', 'kind': 'any-proxy'}]},
                {'id': 'ob', 'transition': 'begin', 'place': 'swap-button', 'requirements': [{'action': 'add', 'n': 1, 'kind': 'generic'}]},
                {'id': 'oc', 'transition': 'begin', 'place': 'abort-button', 'requirements': [{'action': 'add', 'n': 1, 'kind': 'generic'}]},
                {'id': 'o1', 'transition': 'swap', 'place': 'swap-button', 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]},
                {'id': 'o2', 'transition': 'swap', 'place': 'work', 'requirements': [{'action': 'take', 'n': 'all', 'kind': 'relevant'}]},
                {'id': 'o3', 'transition': 'abort', 'place': 'abort-button', 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]},
                {'id': 'o4', 'transition': 'abort', 'place': 'out', 'requirements': [{'action': 'take', 'n': 'all', 'kind': 'relevant'}]}]}]}
            """);

    private final List<String> told = new ArrayList<>();

    private SessionWorld world() throws Exception {
        SessionWorld world = new SessionWorld(PROJECT, "anna", "bert");
        onEventThread(() -> {
            world.context.notices().addListener(notice -> told.add(notice.text()));
            return null;
        });
        return world;
    }

    private static long firings(SessionWorld world) {
        return world.context
                .models()
                .missions()
                .snapshot()
                .mission(1)
                .map(now -> now.firings())
                .orElse(0L);
    }

    private static boolean isEnabled(InterruptsPanel panel, String name) {
        return Layout.find(panel, name, JButton.class)
                .filter(JButton::isEnabled)
                .isPresent();
    }

    private static List<Integer> places(InterruptsPanel panel) {
        return onEventThread(() -> {
            Layout.layOut(panel, 300, 400);
            List<Integer> places = new ArrayList<>();
            for (String name : List.of("interrupt-battery-swap", "interrupt-proxy-abort")) {
                Component button = find(panel, name, JButton.class);
                places.add(SwingUtilities.convertPoint(button, 0, 0, panel).y);
            }
            return places;
        });
    }

    @Test
    void whoMayNotPressInterruptsSeesTheirButtonsLockedWithTheReasonUntilThatIsOtherwise() throws Exception {
        AtomicBoolean may = new AtomicBoolean();
        CommandPolicy rights = new CommandPolicy() {
            @Override
            public Optional<String> whyLocked(String id) {
                return may.get() || !id.startsWith("interrupt-")
                        ? Optional.empty()
                        : Optional.of("observers only look");
            }
        };
        try (SessionWorld world = world()) {
            OperatorContext context = new OperatorContext(
                    world.session,
                    new CommandRegistry(rights),
                    world.context.marks(),
                    world.context.boats(),
                    world.context.notices());
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(context));
            world.start("p");
            until("boats work", () -> firings(world) == 1);
            onEventThread(() -> {
                context.boats().select(List.of("anna"));
                return null;
            });
            until(
                    "the button says why",
                    () -> Layout.find(panel, "interrupt-battery-swap", JButton.class)
                            .filter(button -> button.getToolTipText().contains("observers only look"))
                            .isPresent());
            assertThat(isEnabled(panel, "interrupt-battery-swap")).isFalse();

            until(
                    "it is offered",
                    () -> world.context.models().interrupts().snapshot().stream()
                            .anyMatch(choice -> choice.isEnabled()));
            onEventThread(() -> {
                may.set(true);
                context.commands().askPolicy();
                return null;
            });

            assertThat(onEventThread(() -> isEnabled(panel, "interrupt-battery-swap")))
                    .isTrue();
        }
    }

    @Test
    void aButtonStaysTheSameInItsPlaceWhileItIsPressedAgainAndAgain() throws Exception {
        try (SessionWorld world = world()) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            world.start("p");
            until("boats work", () -> firings(world) == 1);
            onEventThread(() -> {
                world.context.boats().select(List.of("anna"));
                return null;
            });
            until("both are offered", () -> isEnabled(panel, "interrupt-proxy-abort"));
            JButton swap = find(panel, "interrupt-battery-swap", JButton.class);
            List<Integer> before = places(panel);
            assertThat(before.get(1)).isGreaterThan(before.get(0) + 48); // set apart

            for (int i = 0; i < 3; i++) {
                long fired = firings(world);
                press(panel, "interrupt-battery-swap");
                until("it is pressed", () -> firings(world) == fired + 1);
                until("it is offered again", () -> isEnabled(panel, "interrupt-battery-swap"));

                assertThat(places(panel)).isEqualTo(before);
                assertThat(find(panel, "interrupt-battery-swap", JButton.class)).isSameAs(swap);
            }
        }
    }

    @Test
    void buttonsStandBelowTheNameThatTheirMissionWasGiven() throws Exception {
        try (SessionWorld world = world()) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            SessionWorld.get(world.session.start("p", "Look at the bay", Map.of()));
            until("boats work", () -> firings(world) == 1);

            until("its buttons are there", () -> texts(panel).contains("mission 1, Look at the bay"));
        }
    }

    private static List<String> texts(Container container) {
        List<String> texts = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child instanceof JLabel label) {
                texts.add(label.getText());
            } else if (child instanceof Container inner) {
                texts.addAll(texts(inner));
            }
        }
        return texts;
    }

    @Test
    void whatCannotBeUndoneIsConfirmedInPlaceOrLeft() throws Exception {
        try (SessionWorld world = world()) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            world.start("p");
            until("boats work", () -> firings(world) == 1);
            onEventThread(() -> {
                world.context.boats().select(List.of("anna"));
                return null;
            });
            until("it is offered", () -> isEnabled(panel, "interrupt-proxy-abort"));
            press(panel, "interrupt-proxy-abort");
            assertThat(text(panel, "interrupt-confirmation-text"))
                    .isEqualTo(
                            "Press proxy abort of mission 1, Work for anna? It cannot be undone. Nothing leads back from 'Out' to 'Work'.");
            press(panel, "interrupt-leave");
            Component asked = find(panel, "interrupt-confirmation", Component.class);
            until("it is left", () -> !asked.isVisible());
            assertThat(firings(world)).isEqualTo(1);

            press(panel, "interrupt-proxy-abort");
            onEventThread(() -> {
                world.context.boats().select(List.of("bert")); // the press stays for whom it was for
                return null;
            });
            press(panel, "interrupt-confirm");

            until("it is pressed", () -> firings(world) == 2);
            until("it is told for whom", () -> told.contains("Pressed proxy abort of mission 1, Work for anna"));
            assertThat(asked.isVisible()).isFalse();
        }
    }

    @Test
    void aPressThatAsksForBoatsIsWithdrawn() throws Exception {
        try (SessionWorld world = world()) {
            InterruptsPanel panel = laidOut(() -> new InterruptsPanel(world.context));
            world.start("p");
            until("boats work", () -> firings(world) == 1);
            assertThat(world.whyNot("interrupt-withdraw")).isEqualTo("no interrupt asks which boats it is for");
            until("it is offered", () -> isEnabled(panel, "interrupt-battery-swap"));
            press(panel, "interrupt-battery-swap");
            until(
                    "it asks",
                    () -> find(panel, "interrupt-battery-swap-withdraw", JButton.class)
                            .isVisible());
            assertThat(isEnabled(panel, "interrupt-battery-swap")).isFalse();
            assertThat(isEnabled(panel, "interrupt-proxy-abort")).isTrue();

            world.run("interrupt-withdraw");

            until(
                    "nothing is asked",
                    () -> world.context.models().decisions().snapshot().isEmpty());
            until("it can be pressed again", () -> isEnabled(panel, "interrupt-battery-swap"));
            assertThat(firings(world)).isEqualTo(1);
            until("it is told", () -> told.contains("Withdrew battery swap of mission 1, Work: nothing was done"));
        }
    }
}
