package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;

/** Driving by keys and by the stick: a boat goes only while a key or the stick is held for it. */
@Isolated("the keys that drive a boat are heard in the whole process")
@Timeout(300)
class TeleoperationTest {
    private static final double GOES_MPS = 0.3;
    private static final double STANDS_MPS = 0.1;

    private final JPanel sea = new JPanel();
    private SessionWorld world;
    private SelectedBoatPanel panel;
    private String notice = "";

    @BeforeEach
    void open() throws Exception {
        world = new SessionWorld(SessionWorld.library("clv"), "anna");
        panel = SessionWorld.laidOut(() -> new SelectedBoatPanel(world.context));
        onEventThread(() -> {
            world.context.notices().addListener(told -> notice = told.text());
            world.context.boats().select(List.of("anna"));
            return null;
        });
    }

    @AfterEach
    void close() throws Exception {
        onEventThread(() -> {
            if (isDriven()) {
                world.context.commands().get("boat-by-hand").run();
            }
            return null;
        });
        world.close();
    }

    @Test
    void aBoatStandsOnceAnotherWindowHasTheKeyboard() {
        driveByKeys();

        loseTheKeyboard();

        SessionWorld.until("it stands", () -> speed() < STANDS_MPS);
        assertThat(onEventThread(this::isDriven)).isTrue();
        assertThat(onEventThread(() -> notice)).startsWith("anna is told to stand: another window has the keyboard");
    }

    @Test
    void theStickIsLetGoOnceAnotherWindowHasTheKeyboard() {
        StickView stick = stick();
        onEventThread(() -> {
            mouse(stick, MouseEvent.MOUSE_PRESSED, 74, 10);
            return null;
        });
        SessionWorld.until("it goes", () -> speed() > GOES_MPS);

        loseTheKeyboard();
        onEventThread(() -> {
            mouse(stick, MouseEvent.MOUSE_DRAGGED, 74, 11);
            return null;
        });

        SessionWorld.until("it stands", () -> speed() < STANDS_MPS);
    }

    @Test
    void theFleetStopEndsDrivingAndTheBoatStaysAtRestAfterTheRelease() throws Exception {
        driveByKeys();

        SessionWorld.get(world.session.fleet().stopAll());

        SessionWorld.until("driving has ended", () -> !isDriven());
        assertThat(world.whyNot("boat-by-hand")).isEqualTo("its motors are stopped, release it first");
        assertThat(notice).isEqualTo("anna is stopped: driving by hand has ended");
        SessionWorld.get(world.session.fleet().releaseAll());
        SessionWorld.until(
                "it may be driven again",
                () -> world.context.commands().get("boat-by-hand").whyNot().isEmpty());
        SessionWorld.until("it is the missions'", () -> boat().commander() == Commander.THIS_BASE);
    }

    @Test
    void aStoppedBoatIsNotBegunToBeDriven() throws Exception {
        SessionWorld.get(world.session.fleet().stop("anna"));
        SessionWorld.until(
                "it is stopped",
                () -> world.context.models().fleetStop().snapshot().stops("anna"));

        assertThat(world.whyNot("boat-by-hand")).isEqualTo("its motors are stopped, release it first");
    }

    @Test
    void aKeyWithAnotherOneHeldAndAKeyInATextAreLeftToOthers() {
        world.run("boat-by-hand");
        JTextField text = new JTextField();
        List<KeyEvent> left = new ArrayList<>();
        KeyEventDispatcher others = event -> {
            left.add(event);
            return true;
        };
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();

        onEventThread(() -> {
            manager.addKeyEventDispatcher(others);
            press(KeyEvent.VK_DOWN, InputEvent.ALT_DOWN_MASK, sea);
            press(KeyEvent.VK_UP, InputEvent.SHIFT_DOWN_MASK, sea);
            press(KeyEvent.VK_UP, InputEvent.CTRL_DOWN_MASK, sea);
            press(KeyEvent.VK_UP, 0, text);
            manager.removeKeyEventDispatcher(others);
            return null;
        });

        assertThat(left).hasSize(4);
    }

    @Test
    void aKeyThatDrivesIsLetGoWhereAnotherOneIsHeldWithIt() {
        driveByKeys();

        onEventThread(() -> {
            press(KeyEvent.VK_UP, InputEvent.ALT_DOWN_MASK, sea);
            return null;
        });

        SessionWorld.until("it stands", () -> speed() < STANDS_MPS);
    }

    @Test
    void theStickDoesNotBeginAgainAfterEscapeUntilItIsPressedAgain() {
        StickView stick = stick();
        onEventThread(() -> {
            mouse(stick, MouseEvent.MOUSE_PRESSED, 74, 10);
            press(KeyEvent.VK_ESCAPE, 0, sea);
            mouse(stick, MouseEvent.MOUSE_DRAGGED, 74, 11);
            return null;
        });

        assertThat(onEventThread(this::isDriven)).isFalse();
        onEventThread(() -> {
            mouse(stick, MouseEvent.MOUSE_RELEASED, 74, 11);
            mouse(stick, MouseEvent.MOUSE_PRESSED, 74, 10);
            return null;
        });
        assertThat(onEventThread(this::isDriven)).isTrue();
    }

    @Test
    void aRefusalToDriveStaysSaidAfterTheBoatWasGivenBack() throws Exception {
        driveByKeys();

        SessionWorld.get(world.session.fleet().handOver("anna"));

        SessionWorld.until("driving has ended", () -> !isDriven());
        SessionWorld.until("its answers have come", () -> boat().commander() == Commander.SOMEBODY_ELSE);
        assertThat(onEventThread(() -> notice)).startsWith("anna cannot be driven: ");
    }

    @Test
    void aPanelThatIsClosedGivesTheDrivenBoatBack() {
        driveByKeys();

        onEventThread(() -> {
            panel.close();
            return null;
        });

        SessionWorld.until("it is the missions'", () -> boat().commander() == Commander.THIS_BASE);
        SessionWorld.until("it stands", () -> speed() < STANDS_MPS);
    }

    @Test
    void theMotorOfABoatThatIsDrivenByHandIsNotTried() {
        driveByKeys();
        SessionWorld.until("it says so", () -> boat().commander() == Commander.BY_HAND);

        assertThat(world.whyNot("boat-try-motor")).isEqualTo("it is driven by hand");
    }

    private void driveByKeys() {
        world.run("boat-by-hand");
        onEventThread(() -> {
            press(KeyEvent.VK_UP, 0, sea);
            return null;
        });
        SessionWorld.until("it goes", () -> speed() > GOES_MPS);
    }

    private static void press(int key, int modifiers, Component on) {
        KeyboardFocusManager.getCurrentKeyboardFocusManager()
                .dispatchEvent(new KeyEvent(on, KeyEvent.KEY_PRESSED, 0, modifiers, key, KeyEvent.CHAR_UNDEFINED));
    }

    /** As the display tells it: the window that had the keyboard has it no longer. */
    private void loseTheKeyboard() {
        onEventThread(() -> {
            KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
            PropertyChangeEvent lost = new PropertyChangeEvent(manager, "focusedWindow", sea, null);
            for (PropertyChangeListener listener : manager.getPropertyChangeListeners("focusedWindow")) {
                listener.propertyChange(lost);
            }
            return null;
        });
    }

    private StickView stick() {
        StickView stick = SessionWorld.find(panel, "boat-stick", StickView.class);
        onEventThread(() -> {
            stick.setSize(148, 148);
            return null;
        });
        return stick;
    }

    private static void mouse(Component on, int id, int x, int y) {
        on.dispatchEvent(new MouseEvent(on, id, 0, InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1));
    }

    private boolean isDriven() {
        panel.refresh();
        return SessionWorld.text(panel, "boat-hand-text").startsWith("You drive anna");
    }

    private BoatSnapshot boat() {
        return world.context.models().fleet().boat("anna").orElseThrow();
    }

    private double speed() {
        return boat().pose().map(pose -> Math.abs(pose.speedMps())).orElse(0.0);
    }
}
