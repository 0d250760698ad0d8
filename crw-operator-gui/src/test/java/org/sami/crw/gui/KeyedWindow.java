package org.sami.crw.gui;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JTextField;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.ui.check.WindowRobot;

/** The operator's window as {@code --keys} opens it, on a laptop that is a folder of its own: what the keys protect holds for the process until it is closed. */
final class KeyedWindow implements AutoCloseable {
    final OperatorWindow window;
    private final OpenedWindow opened;

    /** Opens it, with further options. */
    KeyedWindow(Path laptop, String... options) throws Exception {
        List<String> args = new ArrayList<>(List.of("--keys", keys(laptop).toString(), "--no-resume"));
        args.addAll(List.of("--data", laptop.resolve("data").toString()));
        args.addAll(List.of(options));
        opened = OpenedWindow.byCommand(args);
        window = opened.window();
    }

    /** Where a laptop keeps its keys. */
    static Path keys(Path laptop) {
        return laptop.resolve("keys");
    }

    /** Types into a field in place of what is in it. */
    static void type(WindowRobot robot, String field, String text) {
        robot.until(
                field + " can be typed into",
                () -> robot.find(JTextField.class, field).isEnabled());
        WindowRobot.ask(() -> {
            robot.find(JTextField.class, field).setText("");
            return robot.find(JTextField.class, field).requestFocusInWindow();
        });
        robot.untilFocused(field);
        robot.type(text);
    }

    @Override
    public void close() throws Exception {
        new BaseProtection(Optional.empty(), false).use();
        opened.close();
    }
}
