package org.sami.crw.cli.output;

import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import org.jspecify.annotations.Nullable;
import org.sami.spn.json.FileTooLargeException;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** The message for a wrong command line or an internal fault: one or two lines, no stack trace. */
public final class ErrorMessages {
    /** Set to see where a fault came from. */
    private static final String TRACE = "crw.trace";

    private ErrorMessages() {}

    /** Prints faults with their stack traces, or no longer. */
    public static void trace(boolean on) {
        System.setProperty(TRACE, String.valueOf(on));
    }

    public static boolean wantsTrace() {
        return Boolean.getBoolean(TRACE);
    }

    public static int onWrongUsage(ParameterException fault, String[] args) {
        CommandLine command = fault.getCommandLine();
        PrintWriter err = TerminalWriter.of(command.getErr());
        // picocli says "option" twice where a NAME=VALUE is not one
        err.println("crw: " + String.valueOf(fault.getMessage()).replace("option option", "option"));
        UnmatchedArgumentException.printSuggestions(fault, err);
        String name = command.getCommandSpec().qualifiedName(" ");
        err.println("Try '" + name + " --help'.");
        err.flush();
        return ExitCode.USAGE;
    }

    /**
     * Finds out whether everything that was printed arrived: a full disk or a closed pipe swallows it without a word.
     *
     * @param code the exit code of what was done
     * @return the exit code to end with
     */
    public static int checkOutput(CommandLine command, PrintStream standardOutput, int code) {
        if (!command.getOut().checkError() && !standardOutput.checkError()) {
            return code;
        }
        PrintWriter err = TerminalWriter.of(command.getErr());
        err.println("crw: standard output could not be written (a full disk or a closed pipe); what was printed is not"
                + " complete");
        err.flush();
        return code == ExitCode.OK ? ExitCode.FAILED : code;
    }

    public static int onException(Exception fault, CommandLine command, @Nullable ParseResult arguments) {
        PrintWriter err = TerminalWriter.of(command.getErr());
        if (fault instanceof UsageFault || fault instanceof FileTooLargeException) {
            err.println("crw: " + fault.getMessage());
            err.flush();
            return ExitCode.USAGE;
        }
        err.println("crw: " + words(fault));
        if (wantsTrace()) {
            fault.printStackTrace(err);
        }
        err.flush();
        return ExitCode.FAILED;
    }

    /** The message when the Java virtual machine itself fails. */
    public static int onError(Error fault, CommandLine command) {
        PrintWriter err = TerminalWriter.of(command.getErr());
        if (fault instanceof OutOfMemoryError) {
            long most = Runtime.getRuntime().maxMemory() >> 20;
            err.println("crw: the memory of " + most + " MB ran out; start it with more: JAVA_OPTS=-Xmx4g");
        } else {
            err.println("crw: the program broke: " + fault);
        }
        if (wantsTrace()) {
            fault.printStackTrace(err);
        }
        err.flush();
        return ExitCode.FAILED;
    }

    /** A fault in words for people. */
    public static String words(Exception fault) {
        if (fault instanceof NoSuchFileException) {
            return "there is no file or folder " + fault.getMessage();
        }
        if (fault instanceof AccessDeniedException) {
            return "no permission for " + fault.getMessage();
        }
        if (fault instanceof FileAlreadyExistsException) {
            return fault.getMessage() + " is there already";
        }
        if (fault instanceof FileSystemException file && file.getReason() != null) {
            return file.getReason() + " (" + file.getFile() + ")";
        }
        String message = fault.getMessage();
        if (fault instanceof IOException && message != null) {
            return message;
        }
        return fault + " (run with JAVA_OPTS=-D" + TRACE + "=true to see where)";
    }
}
