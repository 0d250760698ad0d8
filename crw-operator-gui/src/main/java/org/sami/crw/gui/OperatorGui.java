package org.sami.crw.gui;

import java.util.Arrays;
import org.sami.crw.cli.Crw;
import org.sami.crw.gui.start.OperatorCommand;
import org.sami.ui.window.WindowDisplay;
import picocli.CommandLine;

/**
 * The program of the operator's window. Where there is no display it is the headless demonstration; with a command of {@code crw} as its first
 * argument, such as {@code demo}, it is {@code crw}.
 */
public final class OperatorGui {
    private static final String DEMO = "demo";

    private OperatorGui() {}

    /** Opens the window; the process ends with it. */
    public static void main(String[] args) {
        if (args.length > 0 && !args[0].startsWith("-")) {
            Crw.main(args);
            return;
        }
        CommandLine line = new CommandLine(new OperatorCommand(WindowStart::open));
        boolean helped = Arrays.stream(args).anyMatch(arg -> arg.equals("--help") || arg.equals("-h"));
        if (!helped && !WindowDisplay.isThere()) {
            System.err.println(
                    "crw-operator: there is no display (set DISPLAY, or run under: xvfb-run); the headless demonstration runs instead");
            Crw.main(new String[] {DEMO});
            return;
        }
        int code = line.execute(args);
        if (code != 0 || helped) {
            System.exit(code);
        }
    }
}
