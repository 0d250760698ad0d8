package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ESCAPE;

import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.sami.ui.check.WindowRobot;

/** The window's program in a process of its own, which asks whether an unfinished session goes on, and is answered by Escape. */
public final class EscapedWindow {
    private EscapedWindow() {}

    /**
     * Starts it.
     *
     * @param args the data directory
     */
    public static void main(String[] args) throws Exception {
        CompletableFuture<Integer> ended = OpenedWindow.ask(Path.of(args[0]));
        WindowRobot robot = new WindowRobot();
        robot.untilFocused("resume-go-on");
        robot.press(VK_ESCAPE);
        System.exit(ended.get(300, TimeUnit.SECONDS));
    }
}
