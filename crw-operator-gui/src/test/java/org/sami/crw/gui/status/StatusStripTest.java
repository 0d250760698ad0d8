package org.sami.crw.gui.status;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.gui.EventThreadCall;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class StatusStripTest {
    private SessionWorld world;
    private OperatorContext context;
    private Optional<String> unseen = Optional.empty();
    private int decisionsShown;

    @BeforeEach
    void open() throws Exception {
        world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert", "carl");
        context = world.context;
    }

    @AfterEach
    void close() throws Exception {
        Look.apply(Theme.LIGHT, 100);
        world.close();
    }

    private StatusStrip strip() {
        return new StatusStrip(
                context,
                new FleetStopCommands(context),
                new Command("panel-alarms", "Alarms", () -> {}),
                new Command("panel-decisions", "Decisions", () -> decisionsShown++),
                () -> unseen);
    }

    private static JLabel label(StatusStrip strip, String name) {
        return Layout.find(strip, name, JLabel.class).orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void theClockIsSeenWholeAtEveryScaleInAWindowOf1280Pixels(int percent) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            Look.apply(Theme.LIGHT, percent);
            StatusStrip strip = strip();
            Layout.layOut(strip, 1280, Look.px(58));

            JLabel clock = label(strip, "clock");
            assertThat(clock.isVisible()).isTrue();
            assertThat(clock.getText()).matches("\\d\\d:\\d\\d:\\d\\d");
            assertThat(clock.getWidth()).isGreaterThanOrEqualTo(clock.getPreferredSize().width);
            assertThat(TextFit.faults(strip)).isEmpty();
        });
    }

    @Test
    void stripIsRedAsLongAsTheFleetIsStopped() throws Exception {
        StatusStrip strip = EventThreadCall.onEventThread(this::strip);
        assertThat(strip.getBackground()).isEqualTo(SemanticColor.SURFACE.get());

        SessionWorld.get(world.session.fleet().stopAll());

        SessionWorld.until("the strip is red", () -> {
            strip.refresh();
            return strip.getBackground().equals(SemanticColor.CRITICAL_FILL.get());
        });
        SessionWorld.until(
                "the worst fault is that all are stopped",
                () -> context.models()
                        .health()
                        .snapshot()
                        .worst()
                        .orElseThrow()
                        .fault()
                        .text()
                        .equals("FLEET STOP: 3 of 3 boats are stopped; nothing moves before the release"));
        SessionWorld.get(world.session.fleet().releaseAll());
        SessionWorld.until("the strip is as before", () -> {
            strip.refresh();
            return strip.getBackground().equals(SemanticColor.SURFACE.get());
        });
    }

    @Test
    void stripIsRedNoLongerOnceSomebodyElseReleasesTheFleetThatWasStoppedHere() throws Exception {
        StatusStrip strip = EventThreadCall.onEventThread(this::strip);
        world.run("fleet-stop");
        SessionWorld.until("the strip is red", () -> isRed(strip));

        SessionWorld.get(world.session.fleet().releaseAll());

        SessionWorld.until("it is so no longer", () -> !isRed(strip));
        assertThat(world.whyNot("fleet-release")).isEqualTo("the fleet is not stopped");
    }

    @Test
    void aStopThatIsNotSentIsSaidAndStripIsNotRed() throws Exception {
        StatusStrip strip = EventThreadCall.onEventThread(this::strip);
        world.session.close(); // as where the session cannot be reached

        world.run("fleet-stop");

        SessionWorld.until(
                "it is said", () -> label(strip, "fleet-stop-sent").getText().equals("▲ STOP NOT SENT"));
        SessionWorld.until("it is seen", () -> {
            strip.refresh();
            return label(strip, "fleet-stop-sent").isVisible();
        });
        assertThat(EventThreadCall.onEventThread(() -> isRed(strip))).isFalse();
        assertThat(world.whyNot("fleet-release")).isEqualTo("the fleet is not stopped");
    }

    private static boolean isRed(StatusStrip strip) {
        strip.refresh();
        return strip.getBackground().equals(SemanticColor.CRITICAL_FILL.get());
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void fleetStopAndClockAreSeenWholeWhileTheFleetIsStopped(int percent) throws Exception {
        StatusStrip[] strip = new StatusStrip[1];
        SwingUtilities.invokeAndWait(() -> {
            Look.apply(Theme.LIGHT, percent);
            strip[0] = strip();
            Layout.find(strip[0], "fleet-stop", AbstractButton.class)
                    .orElseThrow()
                    .doClick();
        });
        SessionWorld.until("the fleet is stopped", () -> {
            strip[0].refresh();
            return Layout.find(strip[0], "fleet-release", AbstractButton.class)
                    .filter(Component::isVisible)
                    .isPresent();
        });
        SwingUtilities.invokeAndWait(() -> {
            Layout.layOut(strip[0], 1280, Look.px(58));

            assertIsSeenWhole(strip[0], "fleet-stop", "fleet-release", "clock", "boats-count", "links-count");

            Layout.find(strip[0], "fleet-release", AbstractButton.class)
                    .orElseThrow()
                    .doClick();
            Layout.layOut(strip[0], 1280, Look.px(58));
            assertIsSeenWhole(strip[0], "fleet-stop", "fleet-release-confirm");
        });
    }

    @Test
    void theFleetStopIsLaidOutOnceMoreAfterTheLayoutThatHasChangedItsMargin() throws Exception {
        Set<JComponent> asking = new HashSet<>();
        RepaintManager usual = RepaintManager.currentManager(null);
        AbstractButton[] stop = new AbstractButton[1];
        try {
            SwingUtilities.invokeAndWait(() -> {
                RepaintManager.setCurrentManager(new RepaintManager() {
                    @Override
                    public synchronized void addInvalidComponent(JComponent one) {
                        asking.add(one);
                    }
                });
                StatusStrip strip = strip();
                stop[0] = Layout.find(strip, "fleet-stop", AbstractButton.class).orElseThrow();
                Layout.layOut(strip, 900, Look.px(58));
                int narrow = stop[0].getMargin().left;

                Layout.layOut(strip, 1600, Look.px(58));

                assertThat(stop[0].getMargin().left).isGreaterThan(narrow);
                asking.clear();
            });
            SwingUtilities.invokeAndWait(() -> assertThat(asking).contains(stop[0]));
        } finally {
            RepaintManager.setCurrentManager(usual);
        }
    }

    @Test
    void alarmsThatAreNotCriticalHaveTheMarkThatTheyHaveEverywhere() throws Exception {
        StatusStrip strip = EventThreadCall.onEventThread(this::strip);
        AbstractButton alarms =
                Layout.find(strip, "alarms-count", AbstractButton.class).orElseThrow();

        try (SimulatedBoatsOnTcp twin = new SimulatedBoatsOnTcp(2)) {
            world.session.fleet().connect(twin.launch("anna", SessionWorld.PIER));

            SessionWorld.until("two boats are anna", () -> {
                strip.refresh();
                return alarms.getText().endsWith("1 alarm");
            });
            assertThat(alarms.getText()).isEqualTo("△ 1 alarm");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void aDecisionBehindAnotherPanelIsSaidAndMovesNothingThatCanBePressed(int percent) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            Look.apply(Theme.LIGHT, percent);
            StatusStrip strip = strip();
            Layout.layOut(strip, 1280, Look.px(58));
            AbstractButton button =
                    Layout.find(strip, "decision-unseen", AbstractButton.class).orElseThrow();
            Rectangle alarms = place(strip, "alarms-count");
            Rectangle stop = place(strip, "fleet-stop");
            assertThat(button.isVisible()).isFalse();

            unseen = Optional.of("Draw the area to explore");
            strip.refresh();
            Layout.layOut(strip, 1280, Look.px(58));

            assertThat(button.isVisible()).isTrue();
            assertThat(button.getText()).isEqualTo("▲ Draw the area to explore");
            assertThat(button.getToolTipText()).startsWith("Draw the area to explore – show it");
            assertThat(button.getWidth()).isGreaterThanOrEqualTo(Look.px(56));
            assertThat(place(strip, "alarms-count")).isEqualTo(alarms);
            assertThat(place(strip, "fleet-stop")).isEqualTo(stop);
            assertIsSeenWhole(strip, "clock", "boats-count", "links-count");
            button.doClick();
            assertThat(decisionsShown).isEqualTo(1);
        });
    }

    private static Rectangle place(StatusStrip strip, String name) {
        Component part = Layout.find(strip, name, JComponent.class).orElseThrow();
        return SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), strip);
    }

    private static void assertIsSeenWhole(StatusStrip strip, String... names) {
        for (String name : names) {
            Component part = Layout.find(strip, name, JComponent.class).orElseThrow();
            assertThat(part.isVisible()).as(name).isTrue();
            assertThat(part.getWidth()).as(name).isGreaterThanOrEqualTo(part.getPreferredSize().width);
            int right = SwingUtilities.convertPoint(part, part.getWidth(), 0, strip).x;
            assertThat(right).as(name).isLessThanOrEqualTo(1280);
        }
    }
}
