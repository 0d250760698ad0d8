package org.sami.dreamm;

import java.util.Arrays;
import java.util.Set;
import org.sami.dreamm.start.DreammCommand;
import org.sami.ui.window.WindowDisplay;
import picocli.CommandLine;

/** The program. Where there is no display it says so in one line. */
public final class Dreamm {
    private static final Set<String> HELP = Set.of("--help", "-h", "--version", "-V");
    private static final int BROKEN = 4;

    private Dreamm() {}

    /** Opens the window; the process ends with it. */
    public static void main(String[] args) {
        boolean helped = Arrays.stream(args).anyMatch(HELP::contains);
        if (!helped && !WindowDisplay.isThere()) {
            System.err.println("dreamm: there is no display (set DISPLAY, or run under: xvfb-run)");
            System.exit(BROKEN);
        }
        int code = new CommandLine(new DreammCommand(DreammStart::open)).execute(args);
        if (code != 0 || helped) {
            System.exit(code);
        }
    }
}
