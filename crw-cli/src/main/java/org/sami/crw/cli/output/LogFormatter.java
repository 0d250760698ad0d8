package org.sami.crw.cli.output;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Locale;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.sami.crw.console.TerminalText;

/** What parts of the program log, as one line on standard error; where it came from only when that is asked for. */
public final class LogFormatter extends Formatter {
    private final boolean withCalls;

    LogFormatter(boolean withCalls) {
        this.withCalls = withCalls;
    }

    /** Has the whole process log like this. */
    public static void install() {
        for (Handler handler : Logger.getLogger("").getHandlers()) {
            handler.setFormatter(new LogFormatter(ErrorMessages.wantsTrace()));
            handler.setLevel(Level.WARNING);
        }
    }

    @Override
    public String format(LogRecord record) {
        String line = String.format(
                Locale.ROOT,
                "crw: %s: %s%n",
                record.getLevel().getName().toLowerCase(Locale.ROOT),
                TerminalText.shown(formatMessage(record)));
        if (!withCalls || record.getThrown() == null) {
            return line;
        }
        StringWriter calls = new StringWriter();
        record.getThrown().printStackTrace(new PrintWriter(calls));
        return line + calls;
    }
}
