package org.sami.ui.window;

import java.io.IOException;
import java.io.PrintWriter;
import picocli.CommandLine.Model.CommandSpec;

/** Opens a window for a command, or prints in one line on standard error why that was not possible. */
public final class WindowStart {
    private static final int OPENED = 0;
    private static final int USAGE = 2;
    private static final int BROKEN = 4;

    private WindowStart() {}

    /** What opens the window. */
    @FunctionalInterface
    public interface Opening {
        /**
         * Opens it; returns once it is there.
         *
         * @throws IllegalArgumentException with one sentence for the user, if the options make no sense
         * @throws IOException with one sentence for the user, if something could not be read or opened
         */
        void open() throws IOException;
    }

    /** Opens the window and returns the command's exit code: 0, 2 if its options make no sense, 4 if it could not be opened. */
    public static int open(CommandSpec command, Opening opening) {
        try {
            opening.open();
            return OPENED;
        } catch (IllegalArgumentException unfit) {
            return tell(command, unfit, USAGE);
        } catch (IOException fault) {
            return tell(command, fault, BROKEN);
        }
    }

    private static int tell(CommandSpec command, Exception fault, int code) {
        PrintWriter err = command.commandLine().getErr();
        err.println(command.name() + ": " + fault.getMessage());
        err.flush();
        return code;
    }
}
