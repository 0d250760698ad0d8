package org.sami.crw.gui;

import java.nio.file.Path;
import javax.swing.JLabel;
import org.sami.ui.check.WindowRobot;

/** The window of a session elsewhere in a process of its own, in which an operator answers and stops the fleet. What the loss of a connection took is done again. */
final class LossyWindow {
    private static final int ATTEMPTS = 8;
    private static final String ANSWER = "value-decision-yes";

    private final OpenedRemoteWindow opened;
    private final WindowRobot robot = new WindowRobot();

    private LossyWindow(OpenedRemoteWindow opened) {
        this.opened = opened;
    }

    /**
     * Opens it, and says how often each was done until it was seen.
     *
     * @param args the address of the session, the SHA-256 of its certificate, and the folder of the window's files
     */
    public static void main(String[] args) throws Exception {
        LossyWindow window = new LossyWindow(new OpenedRemoteWindow(args[0], args[1], Path.of(args[2])));
        System.out.println("answered " + window.answered());
        System.out.println("stopped " + window.stopped());
        System.exit(window.opened.end());
    }

    private int answered() {
        int done = 0;
        while (!isAnswered()) {
            attempt(done++);
            robot.untilSaid("missions-count", "1 mission");
            robot.untilShown(ANSWER);
            JLabel age = robot.find(JLabel.class, "decision-age");
            robot.until(
                    "it can be read, or the connection is lost",
                    () -> ReadQuestion.isPast(age) || hasNoDecision() || !isConnected());
            robot.click(ANSWER);
            robot.until("it is answered, or the connection lost", () -> hasNoDecision() || !isConnected());
        }
        return done;
    }

    private int stopped() {
        int done = 0;
        while (!WindowRobot.ask(this::isStopped)) {
            attempt(done++);
            opened.run("fleet-stop");
            robot.until("the fleet is stopped, or the connection lost", () -> isStopped() || !isConnected());
        }
        return done;
    }

    /** Waits for the connection before something is done. */
    private void attempt(int before) {
        if (before == ATTEMPTS) {
            throw new IllegalStateException("the connection was lost each of " + before + " times");
        }
        robot.until("it is connected", this::isConnected);
    }

    private boolean isAnswered() {
        return WindowRobot.ask(() -> isConnected() && hasBegun() && hasNoDecision());
    }

    private boolean hasBegun() {
        return !opened.session().models().missions().snapshot().missions().isEmpty();
    }

    private boolean hasNoDecision() {
        return opened.session().models().decisions().snapshot().isEmpty();
    }

    private boolean isStopped() {
        return opened.session().models().fleetStop().snapshot().everyBoat();
    }

    private boolean isConnected() {
        return robot.find(JLabel.class, "connection").getText().startsWith("Session at ");
    }
}
