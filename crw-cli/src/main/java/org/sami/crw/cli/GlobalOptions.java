package org.sami.crw.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ErrorLines;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.TerminalWriter;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.output.Version;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;
import picocli.CommandLine.ScopeType;

/** The options that every command has: how much is printed in addition to the result, and the source of options. */
final class GlobalOptions {
    @Option(
            names = "--quiet",
            scope = ScopeType.INHERIT,
            description = "Tell only what is wrong, no progress and no remarks.")
    private boolean quiet;

    @Option(
            names = "--verbose",
            scope = ScopeType.INHERIT,
            description = "Tell also what helps to find a fault of the program: its version, where a fault arose.")
    private boolean verbose;

    @Option(
            names = "--log-file",
            paramLabel = "FILE",
            scope = ScopeType.INHERIT,
            description = "Append the lines of standard error to this file, with the time (UTC).")
    private @Nullable Path logFile;

    @Option(
            names = "--config",
            paramLabel = "FILE",
            scope = ScopeType.INHERIT,
            description = "Take options from this file of NAME = VALUE, and not from ~/.config/sami/crw.properties.")
    private @Nullable Path config; // read before all others, by Configuration

    /** Runs a parsed command with these options. */
    int execute(CommandLine line, ParseResult parsed) {
        if (quiet && verbose) {
            throw new CommandLine.ParameterException(line, "--quiet and --verbose contradict each other");
        }
        PrintWriter out = line.getOut();
        PrintWriter err = line.getErr();
        line.setOut(TerminalWriter.of(out)); // names of files, boats and links are in all that is printed
        try {
            if (!quiet && !verbose && logFile == null) {
                line.setErr(TerminalWriter.of(err));
                return new RunLast().execute(parsed);
            }
            return reportedOtherwise(line, parsed, err);
        } finally {
            line.getOut().flush();
            line.setOut(out);
            line.setErr(err);
        }
    }

    private int reportedOtherwise(CommandLine line, ParseResult parsed, PrintWriter err) {
        try (PrintWriter log = log()) {
            ErrorLines told = new ErrorLines(err, quiet, log);
            line.setErr(TerminalWriter.of(new PrintWriter(told, true)));
            if (verbose) {
                ErrorMessages.trace(true);
                String options = config == null ? "" : ", options of " + config;
                line.getErr().println("crw: " + String.join(", ", new Version().getVersion()) + options);
            }
            try {
                return new RunLast().execute(parsed);
            } catch (CommandLine.ExecutionException e) {
                return fault(line, parsed, e);
            } finally {
                line.getErr().flush();
                told.end();
                if (verbose) {
                    ErrorMessages.trace(false);
                }
            }
        }
    }

    /** Told here, and not by picocli after this method, so that the log has it. */
    private static int fault(CommandLine line, ParseResult parsed, CommandLine.ExecutionException e) {
        if (e.getCause() instanceof CommandLine.ParameterException wrong) {
            throw wrong;
        }
        if (e.getCause() instanceof Exception cause) {
            return ErrorMessages.onException(cause, line, parsed);
        }
        throw e;
    }

    private PrintWriter log() {
        if (logFile == null) {
            return new PrintWriter(Writer.nullWriter());
        }
        try {
            return new PrintWriter(Files.newBufferedWriter(
                    logFile, StandardCharsets.UTF_8, StandardOpenOption.CREATE, StandardOpenOption.APPEND));
        } catch (IOException e) {
            throw new UsageFault("--log-file: " + logFile + " cannot be written");
        }
    }
}
